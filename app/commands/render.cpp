#include "app/commands/command.h"
#include "app/commands/progress.h"
#include "app/commands/render_output.h"
#include "app/commands/render_pipeline.h"
#include "app/render/contact_sheet.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

/// Everything a run has opened.
struct Session {
  RenderPlan plan;
  OutputNames names;
  std::vector<Preset> presets;
  std::unique_ptr<gl::Context> context;  // outlives the renderer
  std::unique_ptr<render::Renderer> renderer;
};

Expected<Session> open(const RenderOptions& options) {
  Session session;
  auto plan = makePlan(options);
  if (!plan) return tl::unexpected<Error>(plan.error());
  session.plan = std::move(*plan);
  for (const std::string& file : options.files) {
    auto preset = loadChosen({file, options.settings, options.seed});
    if (!preset) return tl::unexpected<Error>(preset.error());
    if (auto layer = templateLayer(session.plan, *preset); !layer) return tl::unexpected<Error>(layer.error());
    session.presets.push_back(std::move(*preset));
  }
  auto names = OutputNames::make(options.output, options.files, session.plan.kind == RenderKind::sequence);
  if (!names) return tl::unexpected<Error>(names.error());
  session.names = std::move(*names);
  // A camera that cannot be read is a mistake of the call; found before the driver is started.
  if (auto camera = render::parseCamera(session.plan.camera, {}, 1.0); !camera) return tl::unexpected<Error>(camera.error());
  auto context = gl::makeOffscreenContext();
  if (!context) return tl::unexpected<Error>(context.error());
  session.context = std::move(*context);
  auto renderer = render::Renderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  session.renderer = std::move(*renderer);
  return session;
}

PictureJob jobOf(const RenderPlan& plan, const Preset& preset, const Explosion& explosion) {
  PictureJob job;
  job.explosion = &explosion;
  job.scene.layers = explosion.layers();
  job.scene.ground_height_m = preset.ground_height_m;
  job.scene.ground_colour = preset.ground_colour;
  job.scene.background = plan.background;
  job.width = plan.width;
  job.height = plan.height;
  job.threads = plan.threads;
  job.camera = *render::parseCamera(plan.camera, explosion.extent(), static_cast<double>(plan.width) / plan.height);
  return job;
}

/// "t=0.52 s"
std::string caption(double time_s) {
  char text[40];
  std::snprintf(text, sizeof text, "t=%.2f s", time_s);
  return text;
}

Expected<void> writeSheet(Session& session, const PictureJob& job, const std::vector<Shot>& shots, const fs::path& path, Progress& progress, std::vector<fs::path>& written) {
  const RenderPlan& plan = session.plan;
  render::Image sheet{plan.width * plan.columns, plan.height * plan.rows, {}};
  sheet.rgba.resize(4u * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  auto drawn = drawPictures(*session.renderer, job, shots, [&](const Shot& shot, render::Image& image) -> Expected<void> {
    const int column = static_cast<int>(shot.number) % plan.columns, row = static_cast<int>(shot.number) / plan.columns;
    render::placeInSheet(sheet, image, column, row);
    // A transparent sheet is a sprite sheet: nothing but the effect.
    if (plan.background.kind != render::Background::Kind::transparent) render::captionCell(sheet, plan.width, plan.height, column, row, caption(shot.time_s));
    progress.show(static_cast<std::size_t>(shot.number) + 1);
    return {};
  });
  if (!drawn) return drawn;
  if (auto saved = render::writePng(sheet, path); !saved) return saved;
  written.push_back(path);
  return {};
}

Expected<void> writeTemplate(Session& session, std::size_t index, std::vector<fs::path>& written) {
  render::TemplateScene scene;
  scene.preset = &session.presets[index];
  scene.layer = *templateLayer(session.plan, *scene.preset);
  scene.view = session.plan.view;
  scene.background = session.plan.background;
  auto image = session.renderer->drawToImage(scene, session.plan.width, session.plan.height);
  if (!image) return tl::unexpected<Error>(image.error());
  const fs::path path = session.names.path(index, 0);
  if (auto saved = render::writePng(*image, path); !saved) return saved;
  written.push_back(path);
  return {};
}

Expected<void> renderOne(Session& session, std::size_t index, std::vector<fs::path>& written) {
  if (session.plan.kind == RenderKind::template_view) return writeTemplate(session, index, written);
  const Preset& preset = session.presets[index];
  const auto explosion = Explosion::compile(preset, std::nullopt, nullptr, {.threads = session.plan.threads});
  if (!explosion) return tl::unexpected<Error>(explosion.error());
  const PictureJob job = jobOf(session.plan, preset, **explosion);
  const std::vector<Shot> shots = shotsOf(session.plan, (*explosion)->duration_s());
  Progress progress("frame", shots.size());
  if (session.plan.kind == RenderKind::sheet) return writeSheet(session, job, shots, session.names.path(index, 0), progress, written);
  return writePictures(*session.renderer, job, shots, [&](const Shot& shot) { return session.names.path(index, shot.number); }, [&](std::size_t done) { progress.show(done); }, written);
}

int render(const RenderOptions& options) {
  auto session = open(options);
  if (!session) return report(session.error());
  std::vector<fs::path> written;
  Expected<void> result;
  for (std::size_t i = 0; result && i < session->presets.size(); ++i) result = renderOne(*session, i, written);
  std::string lines;
  for (const fs::path& path : written) lines += path.string() + '\n';
  const int printed = writeResult(lines);
  return result ? printed : report(result.error());
}

}  // namespace

void addRender(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render presets to PNG: one picture, a numbered sequence, or a contact sheet; needs no display");
  command->add_option("FILE", options->files, "Preset files (*.npsee.json)")->required();
  command->add_option("-o,--output", options->output, "PNG file to write; for a sequence with %04d where the frame number goes (else _0000 is added); for several presets a folder")->required()->type_name("OUT");
  command->add_option("--time", options->time, "Moment to draw, after the burst; a quarter of the effect's duration if left out")->type_name("T");
  command->add_option("--frames", options->frames, "Sequence from A up to, but without, B seconds; frame k shows the time k / fps and carries the number k. With --sheet: the time it divides evenly")->type_name("A:B");
  command->add_option("--fps", options->fps, "Frames per second of a sequence: 30 (default), 29.97, 30000/1001")->type_name("RATE");
  command->add_option("--size", options->size, "Picture size in pixels, 1280x720 if left out; with --sheet that of each picture, 320x180 if left out")->type_name("WxH");
  command->add_option("--camera", options->camera, "auto (default: the whole effect), front, back, side, left, top, or \"eye=X,Y,Z target=X,Y,Z fov=40deg\"")->type_name("CAMERA");
  command->add_option("--background", options->background, "sky (default), transparent, black, white, or a colour such as \"#20242c\"")->type_name("COLOUR");
  command->add_option("--sheet", options->sheet, "Contact sheet of C columns and R rows over the whole effect, or over --frames; transparent: a sprite sheet without captions")->type_name("CxR");
  command->add_flag("--template", options->as_template, "Draw the template, the shape that shows the settings, instead of the explosion");
  command->add_option("--view", options->view, "The template's view: surface (default), polygons, splines")->type_name("VIEW");
  command->add_option("--layer", options->layer, "The layer whose template is drawn, the first enabled one if left out")->type_name("NAME");
  addChangeOptions(*command, options->settings, options->seed);
  command->add_option("-j,--threads,--jobs", options->threads, "Threads for simulation and PNG; the pictures do not depend on it")->type_name("N");
  command->footer(
      "Prints the files written, one per line.\n"
      "Examples:\n  npsee render presets/classic_1993.npsee.json -o classic.png --time 2.14\n"
      "  npsee render presets/classic_1993.npsee.json -o frames/classic_%04d.png --frames 0:3 --fps 30\n"
      "  npsee render presets/classic_1993.npsee.json -o sheet.png --sheet 4x3\n"
      "  npsee render presets/classic_1993.npsee.json -o sprites.png --sheet 8x8 --size 128x128 --background transparent\n"
      "  npsee render presets/classic_1993.npsee.json -o template.png --template --view splines\n"
      "  npsee render a.npsee.json b.npsee.json -o folder/ --set fragments.speed_mean=40 --camera \"eye=0,10,60 target=0,8,0\"");
  command->callback([options, &outcome] { outcome.exit_code = render(*options); });
}

}  // namespace npsee::commands
