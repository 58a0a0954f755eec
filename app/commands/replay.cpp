#include "app/commands/command.h"
#include "app/commands/dis_send.h"
#include "app/commands/mission_pictures.h"
#include "app/commands/replay_state.h"
#include "app/commands/shot_options.h"

#include "sim/core/files.h"
#include "sim/core/text.h"

#include <npsee/exports.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace npsee::commands {
namespace {

struct ReplayOptions {
  std::string file, at, format, output, step, shell_step, send, speed;
  bool events = false;
  MissionPictureOptions pictures;
};

/// What was asked for, read from the options before the file is.
struct Wish {
  std::optional<double> at_s;
  ExportSetup setup;
  std::string format;
  std::optional<LoopbackPort> send;
  double speed = 1.0;
  MissionPicturePlan pictures;
};

constexpr std::string_view kFormats = "acmi (Tacview), csv or dis (a capture file)";

/// The format that a file's name means.
std::string formatOf(const ReplayOptions& options) {
  if (!options.format.empty() || options.output.empty()) return options.format;
  const std::string_view name = options.output;
  if (name.ends_with(".acmi")) return "acmi";
  if (name.ends_with(".csv")) return "csv";
  if (name.ends_with(".pcap")) return "dis";
  return {};
}

Expected<void> readSteps(const ReplayOptions& options, ExportSetup& setup) {
  for (const auto& [name, text, value] : {std::tuple{"--step", &options.step, &setup.step_s}, {"--shell-step", &options.shell_step, &setup.shell_step_s}}) {
    if (text->empty()) continue;
    const auto read = parseOption(name, *text, Unit::second);
    if (!read) return tl::unexpected<Error>(read.error());
    if (!(*read >= 0.01 && *read <= 3600.0)) return fail(ErrorKind::usage, std::string(name) + ' ' + *text + ": a step lies between 0.01 and 3600 s.");
    *value = *read;
  }
  return {};
}

/// With --render, -o names the picture instead of an export.
Expected<Wish> pictureWish(const ReplayOptions& options) {
  Wish wish;
  MissionPictureOptions pictures = options.pictures;
  pictures.output = options.output;
  auto plan = planMissionPictures(pictures);
  if (!plan) return tl::unexpected<Error>(plan.error());
  if (!options.at.empty() || options.events || !options.format.empty() || !options.send.empty())
    return fail(ErrorKind::usage, "--render draws pictures; --at, --events, --format and --send are other results.", "Ask for one at a time.");
  wish.pictures = std::move(*plan);
  return wish;
}

/// Options that change nothing of what is asked for are refused.
Expected<void> checkUse(const ReplayOptions& options) {
  const bool drawn = !options.pictures.renders.empty() || !options.pictures.frames.empty();
  if (drawn || (options.output.empty() && options.format.empty() && options.send.empty()))
    for (const auto& [name, text] : {std::pair{"--step", &options.step}, {"--shell-step", &options.shell_step}})
      if (!text->empty()) return fail(ErrorKind::usage, std::string(name) + ' ' + *text + " is that of an export or of --send, and none is asked for.", "Leave it out, or add -o FILE: " + std::string(kFormats) + ".");
  if (!options.speed.empty() && options.send.empty()) return fail(ErrorKind::usage, "--speed " + options.speed + " is that of --send, and nothing is sent.", "Leave it out, or add --send 127.0.0.1:3000.");
  return {};
}

Expected<Wish> wishOf(const ReplayOptions& options) {
  if (auto sensible = checkUse(options); !sensible) return tl::unexpected<Error>(sensible.error());
  if (!options.pictures.renders.empty() || !options.pictures.frames.empty() || !options.pictures.fps.empty() || !options.pictures.quality.empty()) return pictureWish(options);
  Wish wish;
  if (!options.at.empty()) {
    const auto at = parseOption("--at", options.at, Unit::second);
    if (!at) return tl::unexpected<Error>(at.error());
    if (!(*at >= 0.0)) return fail(ErrorKind::usage, "--at " + options.at + ": a mission begins at 0 s.");
    wish.at_s = *at;
  }
  if (auto steps = readSteps(options, wish.setup); !steps) return tl::unexpected<Error>(steps.error());
  wish.format = formatOf(options);
  if (!wish.format.empty() && wish.format != "acmi" && wish.format != "csv" && wish.format != "dis")
    return fail(ErrorKind::usage, "--format " + wish.format + ": there is no such format.", "There are " + std::string(kFormats) + ".");
  if (!options.output.empty() && wish.format.empty()) return fail(ErrorKind::usage, "-o " + options.output + ": the name does not say which format is meant.", "Give --format: " + std::string(kFormats) + ".");
  if (!wish.format.empty() && options.output.empty()) return fail(ErrorKind::usage, "--format " + wish.format + " needs a file to write.", "Give -o FILE, or -o - for standard output.");
  if (!options.send.empty()) {
    const auto send = parseLoopback(options.send);
    if (!send) return tl::unexpected<Error>(send.error());
    wish.send = *send;
  }
  if (!options.speed.empty() && options.speed != "max") {
    const auto speed = parseOption("--speed", options.speed, Unit::none);
    if (!speed) return tl::unexpected<Error>(speed.error());
    if (!(*speed > 0.0 && *speed <= 1e6)) return fail(ErrorKind::usage, "--speed " + options.speed + ": it is a number above 0, or max.");
    wish.speed = *speed;
  } else if (options.speed == "max") {
    wish.speed = 0.0;
  }
  if (const int results = (wish.at_s ? 1 : 0) + (options.events ? 1 : 0) + (options.output == "-" ? 1 : 0); results > 1)
    return fail(ErrorKind::usage, "--at, --events and -o - all write to standard output.", "Ask for one at a time.");
  return wish;
}

Expected<std::string> exported(const Recording& recording, const Wish& wish) {
  if (wish.format == "acmi") return acmiText(recording, wish.setup);
  if (wish.format == "csv") return csvText(recording, wish.setup);
  const auto packets = disPackets(recording, wish.setup);
  if (!packets) return tl::unexpected<Error>(packets.error());
  return pcapText(*packets);
}

int exportTo(const Recording& recording, const Wish& wish, const std::string& output) {
  const auto text = exported(recording, wish);
  if (!text) return report(text.error());
  if (output == "-") return writeResult(*text);
  const auto written = writeFileAtomically(output, *text);
  return written ? 0 : report(written.error());
}

int send(const Recording& recording, const Wish& wish) {
  const auto packets = disPackets(recording, wish.setup);
  if (!packets) return report(packets.error());
  const auto sent = sendPackets(*packets, *wish.send, wish.speed);
  return sent ? 0 : report(sent.error());
}

int draw(const Recording& recording, const MissionPicturePlan& pictures) {
  std::vector<std::filesystem::path> written;
  const auto drawn = writeMissionPictures(pictures, recording, written);
  std::string lines;
  for (const auto& file : written) lines += file.string() + '\n';
  const int printed = writeResult(lines);
  return drawn ? printed : report(drawn.error());
}

int replay(const ReplayOptions& options) {
  const auto wish = wishOf(options);
  if (!wish) return report(wish.error());
  const auto recording = loadRecording(options.file);
  if (!recording) return report(recording.error());
  if (!wish->pictures.renders.empty()) return draw(*recording, wish->pictures);
  if (wish->at_s && *wish->at_s > recording->duration_s)
    return report(Error{ErrorKind::usage, {{.what = "--at " + options.at + ": the recording ends at " + shortest(recording->duration_s) + " s.", .remedy = {}, .file = {}, .line = 0, .pointer = {}}}});
  if (!options.output.empty())
    if (const int code = exportTo(*recording, *wish, options.output); code != 0) return code;
  if (wish->send)
    if (const int code = send(*recording, *wish); code != 0) return code;
  if (wish->at_s) return writeResult(stateJson(*recording, *wish->at_s));
  if (options.events) return writeResult(eventLog(*recording));
  return options.output.empty() && !wish->send ? writeResult(summaryText(*recording)) : 0;
}

}  // namespace

void addReplay(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "Look into a recorded mission: its state at a time, its log, pictures, or an export to Tacview, CSV or DIS");
  command->add_option("FILE", options->file, "Recording, as `npsee mission --record` writes it")->required();
  command->add_option("--at", options->at, "Print everything's state at this time as JSON, s")->type_name("T");
  command->add_flag("--events", options->events, "Print the event log, one JSON object per line");
  command->add_option("--format", options->format, "Of the export: acmi, csv or dis; by the name of OUT without it")->type_name("FORMAT");
  command->add_option("-o,--output", options->output, "Write the export here (*.acmi, *.csv, *.pcap; - for standard output), or the picture of --render (*.png)")->type_name("OUT");
  command->add_option("--step", options->step, "Between two samples of what drives, of an export or --send (1 s)")->type_name("S");
  command->add_option("--shell-step", options->shell_step, "Between two samples of shells, likewise (0.25 s)")->type_name("S");
  command->add_option("--send", options->send, "Send DIS packets over UDP to this machine, e.g. 127.0.0.1:3000")->type_name("HOST[:PORT]");
  command->add_option("--speed", options->speed, "Times real time at which --send sends packets, or max (1)")->type_name("N");
  addMissionPictureOptions(*command, options->pictures);
  command->footer(
      "Without options a summary is printed. The keys of --render are listed by `npsee mission --help`.\n"
      "Examples:\n  npsee replay run.jsonl --at 42.5\n  npsee replay run.jsonl -o run.acmi\n  npsee replay run.jsonl --format dis -o run.pcap\n  npsee replay run.jsonl --render \"t=42.5,camera=follow\" -o shell.png\n  npsee replay run.jsonl --send 127.0.0.1:3000");
  command->callback([options, &outcome] { outcome.exit_code = replay(*options); });
}

}  // namespace npsee::commands
