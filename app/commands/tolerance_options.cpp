#include "app/commands/tolerance_options.h"

#include "sim/core/text.h"

#include <npsee/units.h>

#include <CLI/CLI.hpp>

#include <charconv>

namespace npsee::commands {
namespace {

constexpr const char* kPixelsRemedy = "Write a share of the pixels and the levels they may exceed, for example --pixels \"0.01% over 2\".";

std::optional<double> numberIn(std::string_view text, double low, double high) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high)) return std::nullopt;
  return value;
}

Expected<void> readLimit(const char* option, const std::string& text, double low, double high, std::optional<double>& into) {
  if (text.empty()) return {};
  into = numberIn(trimmed(text), low, high);
  if (into) return {};
  return fail(ErrorKind::usage, std::string(option) + ' ' + text + ": this is no number from " + shortest(low) + " to " + shortest(high) + ".", "For example " + std::string(option) + (high > 1.0 ? " 2." : " 0.999."));
}

Expected<void> readPixels(const std::string& text, std::optional<render::Tolerance::Share>& into) {
  if (text.empty()) return {};
  const std::string_view whole = text, word = "over";
  const std::size_t at = whole.find(word);
  std::string_view share = trimmed(whole.substr(0, at));
  const auto over = at == std::string_view::npos ? std::optional(0.0) : numberIn(trimmed(whole.substr(at + word.size())), 0.0, 255.0);
  const bool percent = share.ends_with('%');
  if (percent) share.remove_suffix(1);
  const auto value = numberIn(trimmed(share), 0.0, 100.0);
  if (!percent || !value || !over) return fail(ErrorKind::usage, "--pixels " + text + ": this is no share of pixels.", kPixelsRemedy);
  into = render::Tolerance::Share{*value / 100.0, *over};
  return {};
}

auto optionAdder(CLI::App& command) {
  return [&command](const char* name, std::string& into, const char* help, const char* type) { command.add_option(name, into, help)->type_name(type)->group("Tolerance"); };
}

}  // namespace

void addToleranceOptions(CLI::App& command, ToleranceOptions& options) {
  const auto option = optionAdder(command);
  option("--max", options.max, "Largest difference allowed, in levels of 0..255. Without any tolerance nothing may differ", "N");
  option("--mean", options.mean, "Largest mean difference allowed, in levels", "N");
  option("--pixels", options.pixels, "Share of the pixels that may differ by more than so many levels: \"0.01% over 2\"", "\"P% over N\"");
  option("--ssim", options.ssim, "Least structural similarity allowed, 1 = equal", "S");
}

void addPassToleranceOptions(CLI::App& command, ToleranceOptions& options) {
  const auto option = optionAdder(command);
  option("--light", options.light, "Largest difference of the linear light of OpenEXR pictures", "N");
  option("--depth", options.depth, "Largest difference of their depth, m; a surface in only one of them exceeds it", "N");
  option("--motion", options.motion, "Largest difference of their motion, pixels", "N");
}

Expected<render::Tolerance> readTolerance(const ToleranceOptions& options) {
  render::Tolerance out;
  Expected<void> done = readLimit("--max", options.max, 0.0, 255.0, out.max);
  if (done) done = readLimit("--mean", options.mean, 0.0, 255.0, out.mean);
  if (done) done = readLimit("--ssim", options.ssim, -1.0, 1.0, out.ssim);
  if (done) done = readLimit("--light", options.light, 0.0, 65504.0, out.light);
  if (done) done = readLimit("--depth", options.depth, 0.0, 1e9, out.depth_m);
  if (done) done = readLimit("--motion", options.motion, 0.0, 1e9, out.motion_px);
  if (done) done = readPixels(options.pixels, out.pixels);
  if (!done) return tl::unexpected<Error>(done.error());
  return out;
}

std::string toleranceText(const render::Tolerance& tolerance) {
  if (tolerance.exact()) return "nothing may differ";
  std::string out;
  const auto add = [&](const std::string& text) { out += (out.empty() ? "" : ", ") + text; };
  if (tolerance.max) add("max " + shortest(*tolerance.max));
  if (tolerance.mean) add("mean " + shortest(*tolerance.mean));
  if (tolerance.pixels) add(shortest(100.0 * tolerance.pixels->share) + " % of the pixels over " + shortest(tolerance.pixels->over));
  if (tolerance.light) add("light " + shortest(*tolerance.light));
  if (tolerance.depth_m) add("depth " + shortest(*tolerance.depth_m) + " m");
  if (tolerance.motion_px) add("motion " + shortest(*tolerance.motion_px) + " pixels");
  if (tolerance.ssim) add("SSIM " + shortest(*tolerance.ssim));
  return out;
}

}  // namespace npsee::commands
