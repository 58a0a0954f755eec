#include "app/commands/mission_pictures.h"

#include "app/commands/progress.h"
#include "app/gl/context.h"
#include "app/render/png_encoder.h"
#include "app/render/renderer.h"
#include "sim/core/text.h"

#include <npsee/units.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <future>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

/// One picture of the plan.
struct Picture {
  const render::MissionRender* render = nullptr;
  double time_s = 0.0;
  fs::path file;
};

std::vector<Picture> picturesOf(const MissionPicturePlan& plan, const Recording& recording) {
  std::vector<Picture> out;
  if (plan.sequence) {
    for (std::int64_t k = 0; k < plan.sequence->frame_count; ++k) {
      const std::int64_t number = plan.sequence->first_frame + k;
      out.push_back({&plan.renders.front(), plan.sequence->rate.timeOf(number), plan.names->path(0, number)});
    }
    return out;
  }
  std::int64_t number = 0;
  for (const render::MissionRender& render : plan.renders) {
    const fs::path file = render.output.empty() ? plan.names->path(0, number++) : fs::path(render.output);
    out.push_back({&render, render.time_s.value_or(recording.duration_s), file});
  }
  return out;
}

/// Everything that drawing needs; the context outlives the rest.
struct Studio {
  std::unique_ptr<gl::Context> context;
  std::unique_ptr<render::Renderer> renderer;
  std::unique_ptr<render::MissionScene> scene;
};

Expected<Studio> openStudio(const Recording& recording) {
  Studio studio;
  auto context = gl::makeOffscreenContext();
  if (!context) return tl::unexpected<Error>(context.error());
  studio.context = std::move(*context);
  auto renderer = render::Renderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  studio.renderer = std::move(*renderer);
  auto scene = render::MissionScene::make(recording);
  if (!scene) return tl::unexpected<Error>(scene.error());
  studio.scene = std::move(*scene);
  return studio;
}

/// Writes one picture while the next is being drawn.
class Writer {
 public:
  explicit Writer(std::vector<fs::path>& written) : written_(written) {}

  Expected<void> write(render::Image image, const fs::path& file) {
    if (auto done = finish(); !done) return done;
    file_ = file;
    picture_ = std::move(image);
    // Deferred, to the moment it is waited for, where no thread can be started. What is handed over must bear being copied: the attempt takes one.
    running_ = std::async(std::launch::async | std::launch::deferred, [this] { return encoder_.write(picture_, file_); });
    return {};
  }
  /// Waits for the picture under way.
  Expected<void> finish() {
    if (!running_.valid()) return {};
    auto done = running_.get();
    if (done) written_.push_back(file_);
    return done;
  }

 private:
  std::vector<fs::path>& written_;
  fs::path file_;
  render::Image picture_;
  render::PngEncoder encoder_;
  std::future<Expected<void>> running_;
};

}  // namespace

void addMissionPictureOptions(CLI::App& command, MissionPictureOptions& options) {
  command.add_option("--render", options.renders, "Draw a picture: keys such as \"t=12.5,camera=observer\", see below; repeatable")->allow_extra_args(false)->type_name("VIEW");
  command.add_option("--frames", options.frames, "Draw a sequence of the view from A up to, but without, B seconds; frame k shows the time k / fps")->type_name("A:B");
  command.add_option("--fps", options.fps, "Frames per second of a sequence: 30 (default), 29.97, 30000/1001")->type_name("RATE");
  command.add_option("--quality", options.quality, kQualityHelp)->type_name(choiceOf(render::kQualityNames));
}

Expected<MissionPicturePlan> planMissionPictures(const MissionPictureOptions& options) {
  MissionPicturePlan plan;
  for (const std::string& text : options.renders) {
    auto render = render::parseMissionRender(text);
    if (!render) return tl::unexpected<Error>(render.error());
    plan.renders.push_back(std::move(*render));
  }
  if (!options.frames.empty() || !options.fps.empty()) {
    if (plan.renders.empty()) plan.renders.emplace_back(*render::parseMissionRender(""));
    if (plan.renders.size() > 1) return fail(ErrorKind::usage, "--frames draws a sequence of one view, and there are " + std::to_string(plan.renders.size()) + ".", "Give --render once, or leave --frames out.");
    RenderOptions sequence;
    sequence.frames = options.frames;
    sequence.fps = options.fps;
    auto read = makePlan(sequence);
    if (!read) return tl::unexpected<Error>(read.error());
    plan.sequence = std::move(*read);
  }
  const auto quality = readQuality(options.quality);
  if (!quality) return tl::unexpected<Error>(quality.error());
  for (render::MissionRender& render : plan.renders) render.view.quality = *quality;
  if (plan.renders.empty()) {
    if (!options.quality.empty()) return fail(ErrorKind::usage, "--quality " + options.quality + " is that of a picture, and none is asked for.", "Add --render, for example --render \"t=30,camera=observer\".");
    if (!options.output.empty()) return fail(ErrorKind::usage, "-o " + options.output + " names a picture, and none is asked for.", "Add --render, for example --render \"t=30,camera=observer\".");
    return plan;
  }
  const auto unnamed = plan.sequence ? 2 : std::ranges::count_if(plan.renders, [](const render::MissionRender& r) { return r.output.empty(); });
  if (unnamed == 0 && options.output.empty()) return plan;
  if (options.output.empty()) return fail(ErrorKind::usage, "there is no name for the picture.", "Give -o OUT.png, or out=OUT.png within --render.");
  const auto format = readFormat("", options.output);
  if (!format) return tl::unexpected<Error>(format.error());
  if (*format != FileFormat::png) return fail(ErrorKind::usage, "-o " + options.output + ": pictures of missions are written as PNG.", "End the name in .png; `ffmpeg -framerate 30 -i frame_%04d.png video.mp4` joins a sequence.");
  auto names = OutputNames::make(options.output, {"mission"}, unnamed > 1, ".png");
  if (!names) return tl::unexpected<Error>(names.error());
  plan.names = std::move(*names);
  return plan;
}

Expected<void> writeMissionPictures(const MissionPicturePlan& plan, const Recording& recording, std::vector<fs::path>& written) {
  if (plan.renders.empty()) return {};
  std::vector<render::MissionView> views;
  for (const render::MissionRender& render : plan.renders) {
    auto view = render::missionView(render, recording);
    if (!view) return tl::unexpected<Error>(view.error());
    views.push_back(std::move(*view));
  }
  if (plan.names)
    if (auto made = plan.names->makeFolder(); !made) return made;
  auto studio = openStudio(recording);
  if (!studio) return tl::unexpected<Error>(studio.error());
  const std::vector<Picture> pictures = picturesOf(plan, recording);
  Progress progress("picture", pictures.size());
  Writer writer(written);
  Expected<void> result;
  for (const Picture& picture : pictures) {
    const auto view = static_cast<std::size_t>(picture.render - plan.renders.data());
    render::Image image;
    result = studio->renderer->drawToImage(*studio->scene, recording, picture.time_s, views[view], picture.render->width, picture.render->height, image);
    if (result) result = writer.write(std::move(image), picture.file);
    if (!result) break;
    progress.show(written.size());
  }
  auto finished = writer.finish();
  for (const std::string& warning : studio->scene->warnings()) std::fprintf(stderr, "warning: %s\n", printable(warning).c_str());
  return result ? finished : result;
}

}  // namespace npsee::commands
