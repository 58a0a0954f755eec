#include "app/commands/command.h"
#include "app/commands/particle_formats.h"
#include "app/commands/progress.h"
#include "app/commands/render_output.h"
#include "app/commands/render_plan.h"

#include "sim/core/files.h"

#include <npsee/units.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <thread>

namespace npsee::commands {
namespace {

struct ParticleOptions {
  PresetChoice preset;
  std::string time, frames, fps, format, output;
};

/// The moments wanted; a sequence's carry their frame numbers.
Expected<std::vector<Shot>> shotsWanted(const ParticleOptions& o) {
  const auto clash = [](const std::string& what, const std::string& remedy) { return fail(ErrorKind::usage, what, remedy); };
  if (o.time.empty() == o.frames.empty()) return clash(o.time.empty() ? "--time is required, or --frames for a sequence." : "--time asks for one moment, --frames for several.", "For example --time 0.5, or --frames 0:2 --fps 30 -o cache_%04d.ply.");
  if (o.frames.empty() && !o.fps.empty()) return clash("--fps is the rate of a sequence, and no sequence is asked for.", "Add --frames FROM:TO.");
  if (!o.frames.empty() && o.output.empty()) return clash("a sequence needs -o for its files.", "For example -o cache_%04d.ply.");
  if (o.frames.empty()) {
    const auto time = parseQuantity(o.time, Unit::second);
    if (!time) return clash("--time " + o.time + ": " + time.error().faults.front().what, "For example --time 0.5 or --time 500ms.");
    return std::vector<Shot>{{*time, 0}};
  }
  RenderOptions sequence;
  sequence.frames = o.frames;
  sequence.fps = o.fps;
  const auto plan = makePlan(sequence);
  if (!plan) return tl::unexpected<Error>(plan.error());
  std::vector<Shot> shots;
  for (std::int64_t i = 0; i < plan->frame_count; ++i) shots.push_back(shotOf(*plan, plan->numberOf(i), 0.0));
  return shots;
}

/// The format that is named, else that of the output's ending, else CSV.
Expected<ParticleFormat> formatWanted(const ParticleOptions& o) {
  std::optional<ParticleFormat> named, by_ending;
  for (const ParticleFormat format : {ParticleFormat::csv, ParticleFormat::json, ParticleFormat::ply}) {
    if (endingOf(format) == '.' + o.format) named = format;
    if (o.output.ends_with(endingOf(format))) by_ending = format;
  }
  if (!o.format.empty() && !named) return fail(ErrorKind::usage, "--format " + o.format + ": there is no such format.", "Write csv, json or ply.");
  if (named && by_ending && *named != *by_ending) return fail(ErrorKind::usage, "--format " + o.format + " and -o " + o.output + " contradict each other.", "Leave out --format, or change the ending.");
  return named ? *named : by_ending.value_or(ParticleFormat::csv);
}

int print(ParticleFormat format, const ParticleDump& dump) {
  int code = 0;
  writeParticles(format, dump, [&](std::string_view text) { return (code = writeResult(text)) == 0; });
  return code;
}

/// Writes a file for each moment and prints their names.
int save(ParticleFormat format, const OutputNames& names, const std::vector<Shot>& shots, const std::function<ParticleDump(double)>& at) {
  Progress progress("frame", shots.size());
  std::string written;
  Expected<void> result;
  for (std::size_t i = 0; result && i < shots.size(); ++i) {
    const std::filesystem::path path = names.path(0, shots[i].number);
    std::string text;
    writeParticles(format, at(shots[i].time_s), [&](std::string_view piece) {
      text += piece;
      return true;
    });
    result = writeFileAtomically(path, text);
    if (result) written += path.string() + '\n';
    progress.show(i + 1);
  }
  const int printed = writeResult(written);
  return result ? printed : report(result.error());
}

int dump(const ParticleOptions& options) {
  const auto format = formatWanted(options);
  if (!format) return report(format.error());
  const auto shots = shotsWanted(options);
  if (!shots) return report(shots.error());
  const auto preset = loadChosen(options.preset);
  if (!preset) return report(preset.error());
  OutputNames names;
  if (!options.output.empty()) {
    auto made = OutputNames::make(options.output, {options.preset.file}, !options.frames.empty(), endingOf(*format));
    if (!made) return report(made.error());
    names = std::move(*made);
  }
  if (auto made = names.makeFolder(); !made) return report(made.error());
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto explosion = Explosion::compile(*preset, std::nullopt, nullptr, {.threads = threads});
  if (!explosion) return report(explosion.error());
  ExactFrame frame;
  const auto at = [&](double time_s) {
    (*explosion)->at(time_s, frame, kParticleFields, threads);
    return ParticleDump{frame, (*explosion)->layers(), preset->title, preset->seed};
  };
  return options.output.empty() ? print(*format, at(shots->front().time_s)) : save(*format, names, *shots, at);
}

}  // namespace

void addParticles(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<ParticleOptions>();
  CLI::App* command = app.add_subcommand("particles", "The state of every particle at a time, or a sequence of them as files, for checks and other tools");
  addPresetOptions(*command, options->preset);
  command->add_option("--time", options->time, "Time after the burst in seconds (\"0.5\", \"500ms\")")->type_name("T");
  command->add_option("--frames", options->frames, "Sequence from A up to, but without, B seconds; frame k shows the time k / fps and carries the number k")->type_name("A:B");
  command->add_option("--fps", options->fps, "Frames per second of a sequence: 30 (default), 29.97, 30000/1001")->type_name("RATE");
  command->add_option("--format", options->format, "csv (default), json, or ply: binary point clouds of the living particles in single precision; else by the ending of -o")->type_name("FORMAT");
  command->add_option("-o,--output", options->output, "File to write instead of printing; for a sequence with %04d where the frame number goes (else _0000 is added)")->type_name("OUT");
  command->footer("Columns: " + particleColumns() +
                  "\nA particle that is not alive stands where it was born or died, with size and a of 0. A PLY leaves it out; its id is the particle's\n"
                  "number over all layers and stays the same through a sequence, its q is the orientation (body to world).\n"
                  "Examples:\n  npsee particles presets/classic_1993.npsee.json --time 0.5\n"
                  "  npsee particles presets/classic_1993.npsee.json --time 2 --seed 7 --set fragments.restitution=0.8 --format json\n"
                  "  npsee particles presets/cascade.npsee.json --frames 0:3 --fps 24 -o cache/cascade_%04d.ply");
  command->callback([options, &outcome] { outcome.exit_code = dump(*options); });
}

}  // namespace npsee::commands
