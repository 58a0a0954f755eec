#include "app/commands/render_format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <system_error>

namespace npsee::commands {
namespace {

struct Named {
  std::string_view name;
  FileFormat format;
};
constexpr Named kFormats[] = {{"png", FileFormat::png}, {"exr", FileFormat::exr}, {"mp4", FileFormat::mp4}, {"webm", FileFormat::webm}, {"gif", FileFormat::gif}};

std::optional<FileFormat> formatNamed(std::string_view name) {
  for (const Named& named : kFormats)
    if (named.name == name) return named.format;
  return std::nullopt;
}

/// The ending of a name, small and without its point; empty for a folder.
std::string endingIn(const std::string& output) {
  std::error_code ignored;
  if (output.ends_with('/') || std::filesystem::is_directory(output, ignored)) return {};
  std::string out = std::filesystem::path(output).extension().string();
  if (!out.empty()) out.erase(0, 1);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace

std::string endingOf(FileFormat format) {
  for (const Named& named : kFormats)
    if (named.format == format) return '.' + std::string(named.name);
  return {};
}

render::VideoFormat videoFormatOf(FileFormat format) {
  return format == FileFormat::mp4 ? render::VideoFormat::mp4 : format == FileFormat::webm ? render::VideoFormat::webm : render::VideoFormat::gif;
}

Expected<FileFormat> readFormat(std::string_view text, const std::string& output) {
  const std::string ending = endingIn(output);
  const auto by_ending = formatNamed(ending), named = formatNamed(text);
  if (!text.empty() && !named) return fail(ErrorKind::usage, "--format " + std::string(text) + ": there is no such format.", "Write png, exr, mp4, webm or gif.");
  if (!ending.empty() && !by_ending) return fail(ErrorKind::usage, "-o " + output + ": pictures are written as .png or .exr, videos as .mp4, .webm or .gif.", "End the name in one of these.");
  if (named && by_ending && *named != *by_ending) return fail(ErrorKind::usage, "--format " + std::string(text) + " and -o " + output + " contradict each other.", "Leave out --format, or change the ending.");
  return named ? *named : by_ending.value_or(FileFormat::png);
}

}  // namespace npsee::commands
