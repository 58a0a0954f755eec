#include "app/commands/render_options.h"

#include "app/commands/command.h"
#include "app/commands/shipped.h"
#include "app/render/quality.h"

#include <CLI/CLI.hpp>

namespace npsee::commands {
namespace {

void addPictureOptions(CLI::App& command, RenderOptions& o) {
  const auto option = [&](const char* name, std::string& into, const char* help, const char* type) { command.add_option(name, into, help)->type_name(type); };
  option("-o,--output", o.output, "File to write, by its ending a picture (.png, .exr) or a video (.mp4, .webm, .gif); for a sequence with %04d where the frame number goes (else _0000 is added); for several presets a folder", "OUT");
  option("--format", o.format, "What is written where -o is a folder; png if left out", "{png,exr,mp4,webm,gif}");
  option("--bits", o.bits, "Bits per component of a PNG, 8 if left out", "{8,16}");
  option("--pass", o.passes, "What an EXR holds, with commas: colour (default; linear, premultiplied), depth (m along the viewing direction), motion (pixels to the right and up until the next frame)", "PASS,...");
  option("--time", o.time, "Moment to draw, after the burst (0.5, 500ms) or as a share of the effect's duration; 25% if left out. Several with commas: numbered pictures", "T,...");
  option("--frames", o.frames, "Sequence from A up to, but without, B seconds; frame k shows the time k / fps and carries the number k. With --sheet: the time it divides evenly. A video shows the whole effect if it is left out", "A:B");
  option("--fps", o.fps, "Frames per second of a sequence or video, and what motion is measured over: 30 (default), 29.97, 30000/1001", "RATE");
  option("--size", o.size, "Picture size in pixels, 1280x720 if left out; with --sheet that of each picture, 320x180 if left out", "WxH");
  option("--quality", o.quality, kQualityHelp, choiceOf(render::kQualityNames).c_str());
  option("--exposure", o.exposure, "The camera's exposure in stops, -4 to 4: each doubles the light before highlights roll off; 0 (default). Plain backgrounds stay as they are", "STOPS");
  option("--camera", o.camera, "auto (default: the whole effect), front, back, side, left, top, or \"eye=X,Y,Z target=X,Y,Z fov=40deg\"", "CAMERA");
  option("--background", o.background, "sky (default), transparent, black, white, or a colour such as \"#20242c\"", "COLOUR");
  option("--sheet", o.sheet, "Contact sheet of C columns and R rows over the whole effect, or over --frames; transparent: a sprite sheet without captions", "CxR");
  option("--caption", o.caption, "Text in the pictures of a sheet, \"t={time} s\" if left out; may hold {time}, {frame}, {seed}, {title}, {name}; or none", "TEXT");
  command.add_flag("--index", o.index, "Write NAME.json beside a sheet NAME.png: places, times and pivot of its pictures, as game engines read it");
  command.add_flag("--template", o.as_template, "Draw the template, the shape that shows the settings, instead of the explosion");
  option("--view", o.view, "The template's view, surface if left out", "{surface,polygons,splines}");
  option("--layer", o.layer, "The layer whose template is drawn, the first enabled one if left out", "NAME");
  addChangeOptions(command, o.settings, o.seed);
}

void addPipelineOptions(CLI::App& command, RenderOptions& o) {
  const auto option = [&](const char* name, std::string& into, const char* help, const char* type) { command.add_option(name, into, help)->type_name(type)->group("Pipeline"); };
  option("-j,--threads,--jobs", o.threads, "Threads for simulation and PNG; the pictures do not depend on it", "N");
  option("--shard", o.shard, "Only part I of N of the files, counted from 1, so that N calls anywhere share the work", "I/N");
  command.add_flag("--resume", o.resume, "Skip files that are there, whole, and made from the same preset and options by this build of the program")->group("Pipeline");
  command.add_flag("--any-build", o.any_build, "With --resume and --verify: files of any build of this version count, whose pixels may differ")->group("Pipeline");
  command.add_flag("--dry-run", o.dry_run, "Write nothing; print what would be written, with --resume only what is left")->group("Pipeline");
  command.add_flag("--verify", o.verify, "Write nothing; exit 1 and name the files that are missing, damaged or made from something else")->group("Pipeline");
  option("--summary", o.summary, "What is printed: text (default: the files written) or json", "{text,json}");
  option("--progress", o.progress, "Count and time left on stderr: auto (default: on a terminal), never, always (lines, for logs), steps (many lines, for programs)", "{auto,never,always,steps}");
}

void addGoldenOptions(CLI::App& command, RenderOptions& o) {
  const auto option = [&](const char* name, std::string& into, const char* help, const char* type) { command.add_option(name, into, help)->type_name(type)->group("Goldens"); };
  option("--golden", o.golden, "Compare the pictures with those of the same names in this folder; exit 1 where they differ. Nothing may differ on the driver and processor class recorded beside a golden; "
                               "elsewhere 0.01 % of the pixels by more than 2, or the tolerance given", "DIR");
  command.add_flag("--update-golden", o.update_golden, "Write the goldens that are missing or differ; names each, and the run still fails")->group("Goldens");
  option("--report", o.report, "Write a page with before, after and difference of each picture; one file, nothing else needed", "FILE.html");
  option("--junit", o.junit, "Write the result as JUnit XML", "FILE.xml");
  addToleranceOptions(command, o.tolerance);
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& options) {
  acceptShipped(command.add_option("FILE", options.files, "Preset files (*.npsee.json), or names of shipped ones")->required(), kShippedPresets);
  addPictureOptions(command, options);
  addPipelineOptions(command, options);
  addGoldenOptions(command, options);
}

}  // namespace npsee::commands
