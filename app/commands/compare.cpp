#include "app/commands/command.h"
#include "app/commands/compare_pairs.h"
#include "app/commands/tolerance_options.h"

#include "sim/core/parallel.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string before, after, output;
  ToleranceOptions tolerance;
  bool json = false;
  int jobs = 0;
};

/// Most pairs at a time: the largest pictures take 600 MB a pair.
constexpr unsigned kMostJobs = 4;

/// Where the difference picture of a pair goes; empty = nowhere.
fs::path pictureOf(const Options& options, bool folders, const PicturePair& pair) {
  if (options.output.empty() || !folders) return options.output;
  return fs::path(options.output) / pair.name;
}

Expected<void> checkOutput(const Options& options, bool folders) {
  if (options.output.empty()) return {};
  std::error_code ignored;
  for (const std::string& input : {options.before, options.after})
    if (fs::equivalent(options.output, input, ignored)) return fail(ErrorKind::usage, "-o " + options.output + " is one of the inputs.", "Choose another place for the difference.");
  if (folders && !fs::is_directory(options.output, ignored))
    return fail(ErrorKind::output, {.what = "is no folder.", .remedy = "Two folders are compared; make a folder for their difference pictures first.", .file = options.output, .line = 0, .pointer = {}});
  if (!folders && !options.output.ends_with(".png")) return fail(ErrorKind::usage, "-o " + options.output + ": the difference picture is written as PNG.", "End the name in .png.");
  return {};
}

/// Makes the sub-folders of the difference pictures, before threads write into them.
Expected<void> makeFolders(const Options& options, const std::vector<PicturePair>& pairs) {
  for (const PicturePair& pair : pairs) {
    std::error_code error;
    fs::create_directories(pictureOf(options, true, pair).parent_path(), error);
    if (error) return fail(ErrorKind::output, {.what = "cannot be made: " + error.message() + ".", .remedy = {}, .file = pictureOf(options, true, pair).parent_path().string(), .line = 0, .pointer = {}});
  }
  return {};
}

Expected<std::vector<PairResult>> compareAll(const Options& options, const render::Tolerance& tolerance) {
  const auto pairs = picturePairs(options.before, options.after);
  if (!pairs) return tl::unexpected<Error>(pairs.error());
  std::error_code ignored;
  const bool folders = fs::is_directory(options.before, ignored);
  Expected<void> ready = checkOutput(options, folders);
  if (ready && folders && !options.output.empty()) ready = makeFolders(options, *pairs);
  if (!ready) return tl::unexpected<Error>(ready.error());
  std::vector<Expected<PairResult>> slots(pairs->size());
  const int threads = options.jobs > 0 ? options.jobs : static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, kMostJobs));
  parallelFor(threads, pairs->size(), [&](std::size_t i) { slots[i] = comparePair((*pairs)[i], tolerance, pictureOf(options, folders, (*pairs)[i]), folders); });
  std::vector<PairResult> out;
  for (auto& slot : slots) {
    if (!slot) return tl::unexpected<Error>(slot.error());
    out.push_back(std::move(*slot));
  }
  return out;
}

struct Counts {
  std::size_t same = 0, within = 0, different = 0, unreadable = 0;

  explicit Counts(const std::vector<PairResult>& results) {
    for (const PairResult& result : results) {
      if (result.verdict == Verdict::same) ++same;
      else if (result.verdict == Verdict::within) ++within;
      else if (result.verdict == Verdict::unreadable) ++unreadable;
      else ++different;
    }
  }
};

std::string textOf(const std::vector<PairResult>& results, const Counts& counts) {
  std::string out;
  for (const PairResult& result : results)
    if (results.size() == 1 || result.verdict != Verdict::same) out += pairText(result);
  if (results.size() == 1) return out;
  out += std::to_string(results.size()) + " pairs: " + std::to_string(counts.same) + " same, " + std::to_string(counts.within) + " within the tolerance, " + std::to_string(counts.different) + " different or missing";
  if (counts.unreadable > 0) out += ", " + std::to_string(counts.unreadable) + " unreadable";
  return out + '\n';
}

std::string jsonOf(const std::vector<PairResult>& results, const Counts& counts, const render::Tolerance& tolerance) {
  nlohmann::ordered_json out{{"pairs", results.size()}, {"same", counts.same}, {"within", counts.within}, {"different", counts.different}, {"unreadable", counts.unreadable}, {"tolerance", toleranceText(tolerance)}};
  out["results"] = nlohmann::ordered_json::array();
  for (const PairResult& result : results) out["results"].push_back(pairJson(result));
  return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

int compare(const Options& options) {
  const auto tolerance = readTolerance(options.tolerance);
  if (!tolerance) return report(tolerance.error());
  const auto results = compareAll(options, *tolerance);
  if (!results) return report(results.error());
  const Counts counts(*results);
  const int printed = writeResult(options.json ? jsonOf(*results, counts, *tolerance) : textOf(*results, counts));
  if (printed != 0) return printed;
  for (const PairResult& result : *results)
    if (result.error) report(*result.error);
  if (counts.unreadable > 0) return exitCode(ErrorKind::input);
  return counts.different > 0 ? 1 : 0;
}

}  // namespace

void addCompare(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Compare PNG or OpenEXR pictures, or folders of them: how much and where they differ; exit 1 over the tolerance");
  command->add_option("A", options->before, "Picture, or folder of pictures")->required();
  command->add_option("B", options->after, "Picture, or folder with pictures of the same names")->required();
  command->add_option("-o,--output", options->output, "Difference picture (*.png); for folders a folder, which gets one for each pair that differs")->type_name("OUT");
  addToleranceOptions(*command, options->tolerance);
  addPassToleranceOptions(*command, options->tolerance);
  command->add_flag("--json", options->json, "Print the result as JSON");
  command->add_option("-j,--jobs", options->jobs, "Pairs compared at a time")->check(CLI::Range(1, 64))->type_name("N");
  command->footer(
      "Differences are in levels of 0..255 (fractions for 16-bit pictures), of the colour multiplied by its alpha, and of alpha.\n"
      "OpenEXR pictures are compared as they look on a screen, and then in the values of their passes: light, depth (m), motion (pixels).\n"
      "Exit codes: 0 the tolerance is met, 1 it is not, 2 usage, 3 a picture cannot be read, 5 the difference cannot be written.\n"
      "Examples:\n  npsee compare before.png after.png -o difference.png\n"
      "  npsee compare golden/ new/ --pixels \"0.01% over 2\"\n"
      "  npsee compare a.png b.png --max 3 --mean 0.05 --ssim 0.999 --json\n"
      "  npsee compare a.exr b.exr --max 1 --depth 0.001 --motion 0.01");
  command->callback([options, &outcome] { outcome.exit_code = compare(*options); });
}

}  // namespace npsee::commands
