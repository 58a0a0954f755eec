#include "editor/desk/exports.h"

#include "editor/document/document.h"
#include "sim/core/text.h"

#include <npsee/parameters.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <tuple>
#include <utility>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

struct Kind {
  std::string_view name, ending;
};
constexpr std::array<Kind, 5> kKinds{{{"picture", ".png"}, {"sequence", "_%04d.png"}, {"contact sheet", "_sheet.png"}, {"sprite sheet", "_sprites.png"}, {"video", ".mp4"}}};

std::string size(int across, int down) { return std::to_string(across) + 'x' + std::to_string(down); }

/// The newest "frame 12 of 60, 20 %" among the lines.
std::optional<std::pair<int, int>> progressIn(std::string_view text) {
  std::optional<std::pair<int, int>> out;
  for (const std::string_view line : splitAt(text, '\n')) {
    const std::size_t of = line.find(" of "), space = of == std::string_view::npos ? of : line.rfind(' ', of - 1);
    if (space == std::string_view::npos || (!line.starts_with("frame ") && !line.starts_with("picture "))) continue;
    int done = 0, total = 0;
    std::from_chars(line.data() + space + 1, line.data() + of, done);
    std::from_chars(line.data() + of + 4, line.data() + line.size(), total);
    if (total > 0) out = {done, total};
  }
  return out;
}

/// The messages among the lines: all that is neither progress nor what drivers say to the world.
std::string messageIn(std::string_view text) {
  std::string out;
  for (const std::string_view line : splitAt(text, '\n'))
    if (!trimmed(line).empty() && !progressIn(line) && line.find("shader cache") == std::string_view::npos && !line.starts_with("MESA")) out += (out.empty() ? "" : "\n") + std::string(line);
  return out;
}

}  // namespace

std::string_view exportName(ExportKind kind) { return kKinds[static_cast<std::size_t>(kind)].name; }
fs::path firstOutput(const ExportChoice& choice) {
  std::string name = choice.output.filename().string();
  if (const std::size_t number = name.find("%04d"); choice.kind == ExportKind::sequence && number != std::string::npos) name.replace(number, 4, "0000");
  return choice.output.parent_path() / name;
}

std::string exportFile(ExportKind kind, const std::string& name) { return name + std::string(kKinds[static_cast<std::size_t>(kind)].ending); }

std::vector<std::string> renderArguments(const fs::path& preset, const std::vector<std::string>& settings, const ExportChoice& choice, const ExportView& view) {
  std::vector<std::string> out{"render", preset.string()};
  const auto add = [&out](const char* option, std::string value) { out.insert(out.end(), {option, std::move(value)}); };
  for (const std::string& setting : settings) add("--set", setting);
  add("-o", choice.output.string());
  if (choice.kind == ExportKind::picture) add("--time", shortest(view.time_s));
  // A sequence ends with the frame that shows the effect's end.
  if (choice.kind == ExportKind::sequence) add("--frames", "0:" + shortest(view.duration_s + 0.5 / choice.fps));
  if (choice.kind == ExportKind::sequence || choice.kind == ExportKind::video) add("--fps", shortest(choice.fps));
  if (choice.kind == ExportKind::contact_sheet || choice.kind == ExportKind::sprite_sheet) add("--sheet", size(choice.columns, choice.rows));
  add("--size", size(choice.width, choice.height));
  add("--camera", choice.whole_effect ? "auto" : render::cameraText(view.camera));
  add("--background", choice.kind == ExportKind::sprite_sheet ? "transparent" : choice.background);
  if (view.exposure_stops != 0.0) add("--exposure", shortest(view.exposure_stops));
  if (choice.kind == ExportKind::sprite_sheet) out.emplace_back("--index");
  return out;
}

std::optional<std::vector<std::string>> settingsBetween(const Preset& from, const Preset& to) {
  std::vector<std::string> out;
  if (from.layers.size() != to.layers.size()) return std::nullopt;
  for (const Parameter& parameter : parameters(Scope::burst))
    if (parameter.get(from) != parameter.get(to)) out.push_back(std::string(parameter.key) + '=' + valueText(parameter, parameter.get(to)));
  for (std::size_t i = 0; i < to.layers.size(); ++i)
    for (const Parameter& parameter : parameters(Scope::layer))
      if (parameter.get(from.layers[i]) != parameter.get(to.layers[i])) out.push_back(from.layers[i].name + '.' + std::string(parameter.key) + '=' + valueText(parameter, parameter.get(to.layers[i])));
  // Only what leads there to the last bit is worth printing.
  Preset reached = from;
  for (const std::string& setting : out)
    if (!applySetting(reached, setting)) return std::nullopt;
  return reached == to ? std::optional(std::move(out)) : std::nullopt;
}

Exports::~Exports() {
  for (auto& work : works_) {
    if (!work) continue;
    // Asked, not killed: half a video is tidied up.
    work->child.cancel();
    work->child.wait();
  }
}

int Exports::running() const { return static_cast<int>(std::ranges::count(jobs_, Job::State::running, &Job::state)); }

Expected<void> Exports::start(const Preset& preset, const ExportChoice& choice, const ExportView& view) {
  if (program_.empty()) return fail(ErrorKind::output, "There is no program that renders.", "Start the editor as `npsee edit`.");
  if (choice.output.filename().empty()) return fail(ErrorKind::usage, "The name of the file to export is missing.", "Write one.");
  if (std::ranges::any_of(jobs_, [&](const Job& job) { return job.state == Job::State::running && job.output == choice.output; }))
    return fail(ErrorKind::usage, choice.output.string() + " is being exported already.", "Wait for it, cancel it, or choose another name.");
  auto folder = WorkFolder::make();
  if (!folder) return tl::unexpected<Error>(std::move(folder.error()));
  const fs::path copy = folder->path() / ("preset" + std::string(kPresetEnding));
  auto saved = savePreset(preset, copy);
  if (saved) saved = bringModels(preset, folder->path());
  if (!saved) return saved;
  std::vector<std::string> arguments = renderArguments(copy, {}, choice, view);
  arguments.insert(arguments.end(), {"--progress", "steps"});
  auto child = Child::start(program_, arguments);
  if (!child) return tl::unexpected<Error>(std::move(child.error()));
  jobs_.push_back({std::string(exportName(choice.kind)) + ' ' + choice.output.filename().string(), choice.output, Job::State::running, 0, 0, {}});
  works_.emplace_back(Work{std::move(*child), std::move(*folder)});
  return {};
}

void Exports::cancel(std::size_t job) {
  if (job >= works_.size() || !works_[job]) return;
  works_[job]->cancelled = true;
  works_[job]->child.cancel();
}

void Exports::clearFinished() {
  for (std::size_t i = jobs_.size(); i-- > 0;) {
    if (jobs_[i].state == Job::State::running) continue;
    jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(i));
    works_.erase(works_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void Exports::finish(Job& job, Work& work) {
  job.state = work.cancelled ? Job::State::cancelled : work.child.exitCode() == 0 ? Job::State::done : Job::State::failed;
  if (job.state != Job::State::failed) return;
  job.message = messageIn(work.child.err());
  if (job.message.empty()) job.message = "The renderer ended with exit code " + std::to_string(work.child.exitCode()) + ".";
}

std::vector<Exports::Told> Exports::update(bool wait) {
  std::vector<Told> told;
  for (std::size_t i = 0; i < jobs_.size(); ++i) {
    if (!works_[i]) continue;
    Job& job = jobs_[i];
    Work& work = *works_[i];
    if (wait) work.child.wait();
    const bool runs = work.child.running();
    // Only what has come since: a long video says much.
    const std::string_view err = work.child.err();
    if (const auto now = progressIn(err.substr(std::min(work.read, err.size())))) std::tie(job.done, job.total) = *now;
    const std::size_t line = err.rfind('\n');
    work.read = line == std::string_view::npos ? 0 : line;
    if (runs) continue;
    finish(job, work);
    works_[i].reset();
    if (job.state == Job::State::done) told.push_back({"Exported " + job.output.string(), false});
    else if (job.state == Job::State::cancelled) told.push_back({"Cancelled the " + job.label, false});
    else told.push_back({"The " + job.label + " was not made.\n  " + job.message, true});
  }
  return told;
}

}  // namespace npsee::editor
