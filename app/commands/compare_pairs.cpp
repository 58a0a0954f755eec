#include "app/commands/compare_pairs.h"

#include "app/render/exr.h"
#include "sim/core/files.h"
#include "sim/core/text.h"

#include <nlohmann/json.hpp>
#include <npsee/units.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPictures = 200'000;

/// Most bytes of an OpenEXR file: all passes of the largest picture, not compressed.
constexpr std::size_t kMaxExr = std::size_t{1} << 30;

bool endsIn(const fs::path& path, std::string_view wanted) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == wanted;
}
bool isExr(const fs::path& path) { return endsIn(path, ".exr"); }

/// A picture as it is seen, and the passes of an OpenEXR file.
struct ReadPicture {
  render::DeepImage seen;
  std::optional<render::FloatImage> passes;
};

Expected<ReadPicture> readPicture(const fs::path& path) {
  ReadPicture out;
  if (isExr(path)) {
    const auto bytes = readTextFile(path, kMaxExr);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    auto exr = render::parseExr(*bytes, path.string(), render::kMaxDeepPixels);
    if (!exr) return tl::unexpected<Error>(exr.error());
    out.seen = render::shown(exr->image);
    out.passes = std::move(exr->image);
    return out;
  }
  auto png = render::readDeepPng(path);
  if (!png) return tl::unexpected<Error>(png.error());
  out.seen = std::move(*png);
  return out;
}

/// What the tolerance allows of a pass; none where it says nothing of it.
std::optional<double> limitOf(const render::PassDifference& pass, const render::Tolerance& tolerance) {
  if (tolerance.exact()) return 0.0;
  return pass.name == "light" ? tolerance.light : pass.name == "depth" ? tolerance.depth_m : tolerance.motion_px;
}

std::string passText(const render::PassDifference& pass, double value) { return rounded(value, 5) + (pass.unit.empty() ? "" : " " + std::string(pass.unit)); }

std::string valuesText(const std::array<double, 4>& values, std::size_t count) {
  std::string out;
  for (std::size_t c = 0; c < count; ++c) out += (c == 0 ? "" : ",") + rounded(values[c], 5);
  return out;
}

/// Adds what two OpenEXR pictures have beyond what is seen, and judges anew.
void judgePasses(PairResult& result, const render::FloatImage& before, const render::FloatImage& after, const render::Tolerance& tolerance) {
  if (result.verdict == Verdict::sizes) return;
  result.passes = render::comparePasses(before, after);
  const auto lacking = render::passesOfOne(before, after);
  for (const std::string_view name : lacking) result.reasons.push_back("only one of them holds " + std::string(name));
  bool same = result.difference.same() && lacking.empty();
  for (const render::PassDifference& pass : result.passes) {
    same = same && pass.differing == 0;
    const auto limit = limitOf(pass, tolerance);
    if (!limit || pass.differing == 0) continue;
    if (pass.max > *limit) result.reasons.push_back(std::string(pass.name) + ": max " + passText(pass, pass.max) + " is above " + passText(pass, *limit));
    if (pass.in_one > 0) result.reasons.push_back(std::string(pass.name) + ": " + std::to_string(pass.in_one) + " pixels have one in only one of them");
    // Bits may differ where values do not: -0 and 0, or two kinds of no number.
    if (tolerance.exact() && pass.max == 0.0 && pass.in_one == 0) result.reasons.push_back(std::string(pass.name) + ": bits differ");
  }
  result.verdict = same ? Verdict::same : result.reasons.empty() ? Verdict::within : Verdict::different;
}

/// Relative path to path of all pictures below a folder; links to folders are not followed.
Expected<std::map<std::string, fs::path>> picturesBelow(const fs::path& folder) {
  std::map<std::string, fs::path> out;
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(folder, error); !error && entry != fs::end(entry); entry.increment(error)) {
    std::error_code ignored;
    if (!(endsIn(entry->path(), ".png") || isExr(entry->path())) || entry->is_directory(ignored)) continue;
    out.emplace(entry->path().lexically_relative(folder).generic_string(), entry->path());
    if (out.size() > kMaxPictures) return fail(ErrorKind::input, folder.string() + " holds more than " + std::to_string(kMaxPictures) + " pictures.", "Compare its folders one by one.");
  }
  if (error) return fail(ErrorKind::input, folder.string() + " cannot be read: " + error.message() + ".", "Check the path and its permissions.");
  return out;
}

std::string sizeText(const render::DeepImage& image) { return std::to_string(image.width) + " x " + std::to_string(image.height); }

std::string colourText(const std::array<double, 4>& levels) {
  std::string out;
  for (const double level : levels) out += (out.empty() ? "" : ",") + rounded(level, 2);
  return out;
}

}  // namespace

std::string rounded(double value, int digits) {
  std::string out = withDecimals(value, digits);
  if (out.find('.') == std::string::npos) return out;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  // A difference is never shown as none.
  return out == "0" && value != 0.0 ? shortest(value) : out;
}

std::string_view verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::same: return "same";
    case Verdict::within: return "within";
    case Verdict::different: return "different";
    case Verdict::sizes: return "sizes differ";
    case Verdict::missing: return "missing";
    case Verdict::unreadable: break;
  }
  return "unreadable";
}

Expected<std::vector<PicturePair>> picturePairs(const fs::path& before, const fs::path& after) {
  std::error_code ignored;
  const bool folders = fs::is_directory(before, ignored);
  if (folders != fs::is_directory(after, ignored))
    return fail(ErrorKind::usage, (folders ? before : after).string() + " is a folder and " + (folders ? after : before).string() + " is not.", "Compare two pictures, or two folders.");
  if (!folders) return std::vector<PicturePair>{{before.string() + ", " + after.string(), before, after}};
  auto first = picturesBelow(before);
  if (!first) return tl::unexpected<Error>(first.error());
  auto second = picturesBelow(after);
  if (!second) return tl::unexpected<Error>(second.error());
  std::map<std::string, PicturePair> pairs;
  for (auto& [name, path] : *first) pairs[name] = {name, path, {}};
  for (auto& [name, path] : *second) {
    pairs[name].name = name;
    pairs[name].after = path;
  }
  if (pairs.empty()) return fail(ErrorKind::input, "neither " + before.string() + " nor " + after.string() + " holds a *.png or *.exr file.", "Name folders with pictures.");
  std::vector<PicturePair> out;
  out.reserve(pairs.size());
  for (auto& [name, pair] : pairs) out.push_back(std::move(pair));
  return out;
}

PairResult judged(PicturePair pair, const render::DeepImage& before, const render::DeepImage& after, const render::Tolerance& tolerance) {
  PairResult out{std::move(pair), Verdict::sizes, {}, {}, {}};
  if (before.width != after.width || before.height != after.height) {
    out.reasons.push_back("the first is " + sizeText(before) + " pixels, the second " + sizeText(after));
    return out;
  }
  out.difference = render::compareImages(before, after, tolerance.threshold());
  out.reasons = render::exceeded(out.difference, tolerance);
  out.verdict = out.difference.same() ? Verdict::same : out.reasons.empty() ? Verdict::within : Verdict::different;
  return out;
}

Expected<PairResult> comparePair(const PicturePair& pair, const render::Tolerance& tolerance, const fs::path& picture, bool only_differing) {
  if (pair.before.empty() || pair.after.empty()) return PairResult{pair, Verdict::missing, {}, {pair.after.empty() ? "only in the first folder" : "only in the second folder"}, {}};
  const auto before = readPicture(pair.before), after = readPicture(pair.after);
  if (!before || !after) {
    PairResult out{pair, Verdict::unreadable, {}, {}, before ? after.error() : before.error()};
    out.reasons.push_back((before ? pair.after : pair.before).string() + " cannot be read");
    return out;
  }
  PairResult out = judged(pair, before->seen, after->seen, tolerance);
  if (before->passes && after->passes) judgePasses(out, *before->passes, *after->passes, tolerance);
  if (picture.empty() || out.verdict == Verdict::sizes || (only_differing && out.verdict == Verdict::same)) return out;
  if (auto written = render::writePng(render::differencePicture(before->seen, after->seen), picture); !written) return tl::unexpected<Error>(written.error());
  return out;
}

std::string pairText(const PairResult& result) {
  const render::ImageDifference& d = result.difference;
  std::string out = printable(result.pair.name) + ": " + std::string(verdictName(result.verdict));
  if (result.verdict == Verdict::within) out += " the tolerance";
  out += '\n';
  if (d.differing > 0) {
    out += "  max " + rounded(d.max, 3) + " of 255, mean " + rounded(d.mean, 5) + ", SSIM " + rounded(d.ssim, 6) + '\n';
    out += "  " + std::to_string(d.differing) + " of " + std::to_string(d.pixels()) + " pixels differ (" + rounded(100.0 * static_cast<double>(d.differing) / static_cast<double>(d.pixels()), 4) + " %), " +
           std::to_string(d.over) + " by more than " + rounded(d.threshold, 3) + '\n';
    for (const render::WorstPlace& place : d.worst)
      out += "  at " + std::to_string(place.x) + ',' + std::to_string(place.y) + ": " + colourText(place.before) + " became " + colourText(place.after) + '\n';
  }
  for (const render::PassDifference& pass : result.passes) {
    if (pass.differing == 0) continue;
    out += "  " + std::string(pass.name) + ": max " + passText(pass, pass.max) + ", mean " + passText(pass, pass.mean) + ", " + std::to_string(pass.differing) + " pixels differ";
    if (pass.in_one > 0) out += ", " + std::to_string(pass.in_one) + " have one in only one of them";
    if (pass.max > 0.0) out += "; at " + std::to_string(pass.x) + ',' + std::to_string(pass.y) + ": " + valuesText(pass.before, pass.components) + " became " + valuesText(pass.after, pass.components);
    out += '\n';
  }
  for (const std::string& reason : result.reasons) out += "  not met: " + printable(reason) + '\n';
  return out;
}

nlohmann::ordered_json differenceJson(const render::ImageDifference& d) {
  nlohmann::ordered_json out{{"width", d.width}, {"height", d.height}, {"max", d.max}, {"mean", d.mean}, {"ssim", d.ssim}, {"pixels_differing", d.differing}, {"threshold", d.threshold}, {"pixels_over", d.over}};
  out["worst"] = nlohmann::ordered_json::array();
  for (const render::WorstPlace& place : d.worst)
    out["worst"].push_back({{"x", place.x}, {"y", place.y}, {"difference", place.difference}, {"before", place.before}, {"after", place.after}});
  return out;
}

nlohmann::ordered_json pairJson(const PairResult& result) {
  nlohmann::ordered_json out{{"name", result.pair.name}, {"verdict", verdictName(result.verdict)}, {"reasons", result.reasons}};
  const bool compared = passes(result.verdict) || result.verdict == Verdict::different;
  out["difference"] = compared ? differenceJson(result.difference) : nlohmann::ordered_json();
  for (const render::PassDifference& pass : result.passes)
    out["passes"].push_back({{"name", pass.name}, {"unit", pass.unit}, {"max", pass.max}, {"mean", pass.mean}, {"pixels_differing", pass.differing}, {"pixels_in_one", pass.in_one}, {"x", pass.x}, {"y", pass.y}});
  return out;
}

}  // namespace npsee::commands
