#include "app/commands/command.h"
#include "app/commands/golden.h"
#include "app/commands/interrupt.h"
#include "app/commands/render_bands.h"
#include "app/commands/render_run.h"
#include "app/commands/render_summary.h"
#include "app/gl/machine.h"

#include "sim/core/files.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

/// One call of `npsee render`.
class RenderCall {
 public:
  explicit RenderCall(const RenderOptions& options) : o_(options) {}

  int run() {
    const auto begin = std::chrono::steady_clock::now();
    Expected<void> result = prepare();
    if (!result) return report(result.error());
    const bool any = std::ranges::find(items_, FileState::planned, &WorkItem::state) != items_.end();
    if (!o_.dry_run && !o_.verify && any) result = draw();
    // Pictures that were drawn before an error are worth a report too.
    if (auto reported = writeReports(); result && !reported) result = reported;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const int printed = writeResult(o_.summary == "json" ? json(seconds.count()) : text());
    if (!result) {
      const int code = report(result.error());
      Interrupt::resume();
      return code;
    }
    return printed != 0 ? printed : verdict();
  }

 private:
  Expected<void> prepare();
  Expected<void> checkOptions() const;
  Expected<void> makeItems();
  Expected<void> draw();
  Expected<void> save(std::size_t item, const Picture& picture, render::PngEncoder& encoder);
  Expected<void> writeReports() const;
  std::string text() const;
  std::string json(double seconds) const { return summaryJson({&plan_, &o_.files, &items_, golden_ ? &*golden_ : nullptr, machine_.driver, machine_.processor, seconds}); }
  int verdict() const;

  const RenderOptions& o_;
  RenderPlan plan_;
  ProgressMode progress_ = ProgressMode::terminal;
  OutputNames names_;  // of the output
  std::vector<Preset> presets_;
  render::Tolerance tolerance_;
  std::vector<WorkItem> items_;      // of the goldens where there are any, else of the output
  std::vector<WorkItem> copies_;     // of the output beside goldens
  GoldenRecord machine_;
  std::optional<GoldenCheck> golden_;
};

Expected<void> RenderCall::checkOptions() const {
  const auto clash = [](const std::string& what, const std::string& remedy) { return fail(ErrorKind::usage, what, remedy); };
  const bool needs_golden = o_.update_golden || !o_.report.empty() || !o_.junit.empty() || o_.tolerance.given();
  if (o_.golden.empty() && needs_golden) return clash("--update-golden, --report, --junit and tolerances belong to a comparison with goldens.", "Add --golden DIR, or compare files with `npsee compare`.");
  if (o_.golden.empty() && o_.output.empty()) return clash("-o (--output) is missing: where do the pictures go?", "For example -o picture.png.");
  if (!o_.golden.empty() && (o_.resume || o_.dry_run || o_.verify)) return clash("--golden draws every picture anew.", "Leave out --resume, --dry-run and --verify.");
  if (!o_.golden.empty() && (plan_.format != FileFormat::png || plan_.floats || plan_.index)) return clash("goldens are PNG pictures of 8 bits.", "Leave out --golden, or --bits, --format and --index.");
  if (o_.any_build && !o_.resume && !o_.verify) return clash("--any-build says which files count as finished.", "Add --resume or --verify.");
  if (o_.verify && (o_.resume || o_.dry_run)) return clash("--verify only looks at what is there.", "Leave out --resume and --dry-run.");
  if (!o_.summary.empty() && o_.summary != "text" && o_.summary != "json") return clash("--summary " + o_.summary + ": there is no such summary.", "Write text or json.");
  if (plan_.kind == RenderKind::video && !o_.dry_run && !o_.verify)
    if (auto ffmpeg = render::findFfmpeg(); !ffmpeg) return tl::unexpected<Error>(ffmpeg.error());
  for (const std::string& file : {o_.report, o_.junit})
    if (!file.empty())
      if (auto place = checkPlace(file); !place) return place;
  std::error_code ignored;
  if (!o_.golden.empty() && !fs::is_directory(o_.golden, ignored))
    return fail(ErrorKind::input, {.what = "is no folder of goldens.", .remedy = "Make the folder and fill it with --update-golden.", .file = o_.golden, .line = 0, .pointer = {}});
  return {};
}

Expected<void> RenderCall::prepare() {
  auto plan = makePlan(o_);
  if (!plan) return tl::unexpected<Error>(plan.error());
  plan_ = std::move(*plan);
  if (auto checked = checkOptions(); !checked) return checked;
  auto tolerance = readTolerance(o_.tolerance);
  if (!tolerance) return tl::unexpected<Error>(tolerance.error());
  tolerance_ = *tolerance;
  const auto progress = readProgress(o_.progress);
  if (!progress) return tl::unexpected<Error>(progress.error());
  progress_ = *progress;
  for (const std::string& file : o_.files) {
    auto preset = loadChosen({file, o_.settings, o_.seed});
    if (!preset) return tl::unexpected<Error>(preset.error());
    if (auto layer = templateLayer(plan_, *preset); !layer) return tl::unexpected<Error>(layer.error());
    presets_.push_back(std::move(*preset));
  }
  // A camera that cannot be read is a mistake of the call; found before the driver is started.
  if (auto camera = render::parseCamera(plan_.camera, {}, 1.0); !camera) return tl::unexpected<Error>(camera.error());
  return makeItems();
}

Expected<void> RenderCall::makeItems() {
  if (!o_.output.empty()) {
    auto names = OutputNames::make(o_.output, o_.files, plan_.numbered(), endingOf(plan_.format));
    if (!names) return tl::unexpected<Error>(names.error());
    items_ = workOf(plan_, presets_, *names);
    names_ = std::move(*names);
  }
  if (!o_.golden.empty()) {
    const auto names = OutputNames::inFolder(o_.golden, o_.files, plan_.numbered(), endingOf(plan_.format));
    if (!names) return tl::unexpected<Error>(names.error());
    copies_ = std::move(items_);
    items_ = workOf(plan_, presets_, *names);
  }
  if (o_.resume || o_.verify) skipFinished(items_, o_.any_build, inBands(plan_) ? 1 : plan_.threads);
  if (o_.verify)
    for (WorkItem& item : items_)
      if (item.state == FileState::planned) item.state = FileState::missing;
  return {};
}

Expected<void> RenderCall::save(std::size_t index, const Picture& picture, render::PngEncoder& encoder) {
  if (golden_) {
    if (auto judged = golden_->judge(index, picture.image); !judged || copies_.empty()) return judged;
  }
  const WorkItem& item = copies_.empty() ? items_[index] : copies_[index];
  const auto bytes = encoded(plan_, picture, item, encoder);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return writeFileAtomically(item.path, std::as_bytes(std::span(*bytes)));
}

Expected<void> RenderCall::draw() {
  const Interrupt interrupt;
  if (auto made = names_.makeFolder(); !made) return made;
  const auto context = gl::makeOffscreenContext();
  if (!context) return tl::unexpected<Error>(context.error());
  const auto renderer = render::Renderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  machine_ = {(*context)->description(), gl::processorClass()};
  if (!o_.golden.empty()) golden_.emplace(GoldenCheck::Settings{o_.golden, machine_, tolerance_, o_.update_golden, !o_.report.empty()}, items_);
  RenderRun run{plan_, presets_, o_.files, items_, **renderer, [this](std::size_t item, const Picture& picture, render::PngEncoder& encoder) { return save(item, picture, encoder); }, progress_};
  return drawItems(run);
}

Expected<void> RenderCall::writeReports() const {
  if (!golden_) return {};
  Expected<void> result;
  if (!o_.report.empty()) result = writeFileAtomically(o_.report, goldenPage(*golden_));
  if (!o_.junit.empty())
    if (auto written = writeFileAtomically(o_.junit, goldenJunit(*golden_)); result) result = written;
  return result;
}

std::string RenderCall::text() const {
  if (golden_) return goldenText(*golden_);
  return pathsText(items_, o_.verify ? FileState::missing : o_.dry_run ? FileState::planned : FileState::written);
}

int RenderCall::verdict() const {
  const auto any = [&](FileState state) { return std::ranges::find(items_, state, &WorkItem::state) != items_.end(); };
  if (golden_) return countsOf(golden_->results()).failed > 0 ? 1 : 0;
  return any(FileState::missing) ? 1 : 0;
}

}  // namespace

void addRender(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render presets to files: a picture, a numbered sequence, a contact or sprite sheet, a video; needs no display");
  addRenderOptions(*command, *options);
  command->footer(
      "Prints the files written, one per line.\n"
      "Examples:\n  npsee render presets/classic_1993.npsee.json -o classic.png --time 2.14\n"
      "  npsee render presets/classic_1993.npsee.json -o frames/classic_%04d.png --frames 0:3 --fps 30\n"
      "  npsee render presets/classic_1993.npsee.json -o sheet.png --sheet 4x3\n"
      "  npsee render presets/classic_1993.npsee.json -o sprites.png --sheet 8x8 --size 128x128 --background transparent --index\n"
      "  npsee render presets/cascade.npsee.json -o cascade.mp4 --size 1920x1080 --fps 60\n"
      "  npsee render presets/cascade.npsee.json -o comp/cascade_%04d.exr --frames 0:3 --fps 24 --pass colour,depth,motion --background transparent\n"
      "  npsee render presets/classic_1993.npsee.json -o template.png --template --view splines\n"
      "  npsee render a.npsee.json b.npsee.json -o folder/ --set fragments.speed_mean=40 --camera \"eye=0,10,60 target=0,8,0\"\n"
      "  npsee render presets/*.npsee.json -o frames/ --frames 0:3 --shard 2/5 --resume\n"
      "  npsee render presets/*.npsee.json --time 10%,30%,70% --size 320x180 --golden goldens --report report.html --junit report.xml");
  command->callback([options, &outcome] { outcome.exit_code = RenderCall(*options).run(); });
}

}  // namespace npsee::commands
