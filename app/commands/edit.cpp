#include "app/commands/command.h"
#include "app/commands/shipped.h"

#include "app/render/renderer.h"
#include "editor/run.h"
#include "editor/script/parser.h"

#include <npsee/units.h>

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <memory>
#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file, script, screenshot, library, size, time, measure, scale = "1";
  bool headless = false, print_state = false, remember = false;
};

Expected<std::pair<int, int>> parseSize(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  const bool separated = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = separated ? std::from_chars(first.ptr + 1, end, height) : first;
  if (!separated || second.ec != std::errc() || second.ptr != end || width < 640 || height < 400 || width > render::kMaxPictureSize || height > render::kMaxPictureSize)
    return fail(ErrorKind::usage, "--size " + text + " is not a size of a window.", "Write WIDTHxHEIGHT in pixels, at least 640x400 and at most 8192x8192, e.g. 1440x900.");
  return std::pair(width, height);
}

Expected<editor::EditorOptions> editorOptions(const Options& options) {
  editor::EditorOptions out;
  out.file = options.file;
  out.library = options.library.empty() ? shippedFolder(kShippedPresets.folder) : fs::path(options.library);
  out.missions = options.library.empty() ? shippedFolder(kShippedMissions.folder) : fs::path(options.library);
  // A script is to show the same pictures for everybody, whatever they have set.
  if (!options.headless || options.remember) out.folders = editor::xdgFolders();
  std::error_code ignored;
  out.program = fs::read_symlink("/proc/self/exe", ignored);
  if (!options.library.empty() && !fs::is_directory(options.library, ignored)) return fail(ErrorKind::input, "--library " + options.library + " is no folder.", "Name a folder with presets.");
  if (!options.time.empty()) {
    const auto time = parseQuantity(options.time, Unit::second);
    if (!time || *time < 0.0) return fail(ErrorKind::usage, "--time " + options.time + " is not a time.", "Write seconds after the burst, e.g. 0.8.");
    out.time_s = *time;
  }
  const auto scale = parseQuantity(options.scale, Unit::none);
  if (!scale || *scale < 0.75 || *scale > 4.0) return fail(ErrorKind::usage, "--scale " + options.scale + " is not a scale of the panels.", "Write a number from 0.75 to 4.");
  out.scale = static_cast<float>(*scale);
  return out;
}

int edit(const Options& options) {
  const bool needs_headless = !options.script.empty() || !options.screenshot.empty() || !options.measure.empty();
  if (needs_headless && !options.headless) return report(fail(ErrorKind::usage, "--script, --screenshot and --measure work without a window.", "Add --headless.").value());
  if (options.headless && !needs_headless) return report(fail(ErrorKind::usage, "--headless alone has nothing to do.", "Add --script FILE, --screenshot PICTURE.png, --measure SECONDS, or several of them.").value());
  const auto measured = options.measure.empty() ? Expected<double>(0.0) : parseQuantity(options.measure, Unit::second);
  if (!measured || *measured < 0.0 || *measured > 600.0) return report(fail(ErrorKind::usage, "--measure " + options.measure + " is not a time to measure for.", "Write seconds up to 600, e.g. 5.").value());
  if (options.remember && !options.headless) return report(fail(ErrorKind::usage, "--remember belongs to --headless.", "The window always remembers; set XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_CACHE_HOME to keep things elsewhere.").value());
  const auto size = parseSize(options.size.empty() ? "1440x900" : options.size);
  if (!size) return report(size.error());
  const auto chosen = editorOptions(options);
  if (!chosen) return report(chosen.error());
  int printed = 0;
  const auto print = [&printed](const std::string& line) {
    if (printed == 0) printed = writeResult(line + '\n');
  };
  if (!options.headless) {
    const auto done = editor::runWindow({*chosen, size->first, size->second, !options.size.empty(), options.print_state}, print);
    return done ? printed : report(done.error());
  }
  const auto code = editor::runHeadless({*chosen, size->first, size->second, options.script, options.screenshot, *measured}, print);
  if (!code) return report(code.error());
  return *code != 0 ? *code : printed;
}

std::string footer() {
  std::string out = "Examples:\n  npsee edit presets/classic_1993.npsee.json\n  npsee edit assets/missions/thesis_default.mission.json\n  npsee edit --headless --screenshot editor.png --time 0.8\n"
                    "  npsee edit my_burst.npsee.json --headless --script session.txt --screenshot editor.png\n\n"
                    "Script, one command per line (docs/ui-script.md):\n";
  for (const editor::ScriptCommandInfo& command : editor::scriptCommands()) out += "  " + std::string(command.name) + ' ' + std::string(command.arguments) + "\n      " + std::string(command.doc) + '\n';
  return out;
}

}  // namespace

void addEdit(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("edit", "The editor: a window, or with --headless a script that drives it without a display");
  CLI::Option* file = command->add_option("FILE", options->file, "Preset (*.npsee.json) or mission (*.mission.json) to open, or the name of a shipped one; without it a new preset is started");
  for (const ShippedFiles& shipped : {kShippedPresets, kShippedMissions}) acceptShipped(file, shipped);
  command->add_flag("--headless", options->headless, "No window: run a script on the software renderer");
  command->add_option("--script", options->script, "Script that drives the editor (with --headless)")->type_name("FILE");
  command->add_option("--screenshot", options->screenshot, "Save a picture of the last frame (with --headless)")->type_name("PNG");
  command->add_option("--measure", options->measure, "After the script, draw frames as in a window for so long, and print what they took (with --headless)")->type_name("SECONDS");
  command->add_option("--size", options->size, "Size of the window in pixels; that of the last time, at first 1440x900")->type_name("WxH");
  command->add_option("--library", options->library, "Folder whose presets and missions the library lists; the shipped ones by default")->type_name("FOLDER");
  command->add_option("--time", options->time, "Start paused at this moment instead of playing")->type_name("SECONDS");
  command->add_option("--scale", options->scale, "Scale of the panels, on top of the display's own; 1 by default, less where the window is too small for it")->type_name("FACTOR");
  command->add_flag("--remember", options->remember, "With --headless: keep settings, unsaved work and thumbnails in the XDG folders, as the window does");
  command->add_flag("--print-state", options->print_state, "Print the editor's state when the window is closed");
  command->footer(footer());
  command->callback([options, &outcome] { outcome.exit_code = edit(*options); });
}

}  // namespace npsee::commands
