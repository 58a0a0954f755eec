#include "app/commands/render_run.h"

#include "app/commands/interrupt.h"
#include "app/commands/render_bands.h"
#include "app/commands/render_caption.h"
#include "app/commands/sprite_index.h"
#include "app/render/contact_sheet.h"
#include "app/render/video.h"
#include "sim/core/files.h"

#include <algorithm>

namespace npsee::commands {
namespace {

PictureJob jobOf(const RenderPlan& plan, const Preset& preset, const Explosion& explosion) {
  PictureJob job;
  job.explosion = &explosion;
  job.scene.layers = explosion.layers();
  job.scene.ground_height_m = preset.ground_height_m;
  job.scene.ground_colour = preset.ground_colour;
  job.scene.sky = preset.sky;
  job.scene.background = plan.background;
  job.scene.quality = plan.quality;
  job.scene.exposure_stops = plan.exposure_stops;
  job.width = plan.width;
  job.height = plan.height;
  job.threads = plan.threads;
  job.floats = plan.floats;
  job.camera = *render::parseCamera(plan.camera, explosion.extent(), static_cast<double>(plan.width) / plan.height);
  job.stopped = Interrupt::requested;
  return job;
}

/// Draws items, given by their index, of one preset.
class PresetRun {
 public:
  PresetRun(RenderRun& run, std::vector<std::size_t> items, Progress& progress, std::size_t done) : run_(run), items_(std::move(items)), progress_(progress), done_(done) {}

  Expected<void> draw() {
    if (Interrupt::requested()) return stoppedEarly();
    const Preset& preset = run_.presets[run_.items[items_.front()].preset];
    if (run_.plan.kind == RenderKind::template_view) return drawTemplate(preset);
    const auto explosion = Explosion::compile(preset, std::nullopt, nullptr, {.threads = run_.plan.threads});
    if (!explosion) return tl::unexpected<Error>(explosion.error());
    const PictureJob job = jobOf(run_.plan, preset, **explosion);
    if (run_.plan.kind == RenderKind::video) return drawVideo(job);
    return run_.plan.kind == RenderKind::sheet ? drawSheet(preset, job) : drawPictures(job);
  }

 private:
  /// Pictures too large to be held whole: one after the other, each band written as it is drawn.
  Expected<void> drawInBands(const PictureJob& job) {
    Frame frame;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (Interrupt::requested()) return stoppedEarly();
      WorkItem& item = run_.items[items_[i]];
      job.explosion->at(shotOf(run_.plan, item.number, job.explosion->duration_s()).time_s, frame, render::kSceneFields, job.threads);
      render::Scene scene = job.scene;
      scene.frame = &frame;
      auto file = BandFile::open(run_.plan, item);
      if (!file) return tl::unexpected<Error>(file.error());
      auto done = run_.renderer.drawToRows(scene, job.camera, job.width, job.height, *job.floats, [&](int, render::FloatImage& band) { return (*file)->add(band); });
      if (done) done = (*file)->finish();
      if (!done) return done;
      item.state = FileState::written;
      progress_.show(done_ + i + 1);
    }
    return {};
  }

  Expected<void> drawPictures(const PictureJob& job) {
    if (inBands(run_.plan)) return drawInBands(job);
    std::vector<Shot> shots;
    for (const std::size_t item : items_) shots.push_back(shotOf(run_.plan, run_.items[item].number, job.explosion->duration_s()));
    std::vector<char> saved;
    auto result = savePictures(run_.renderer, job, shots, [&](std::size_t i, const Picture& picture, render::PngEncoder& encoder) { return run_.save(items_[i], picture, encoder); }, [&](std::size_t done) { progress_.show(done_ + done); }, saved);
    for (std::size_t i = 0; i < saved.size(); ++i)
      if (saved[i] != 0) run_.items[items_[i]].state = FileState::written;
    return result;
  }

  Expected<void> drawSheet(const Preset& preset, const PictureJob& job) {
    const RenderPlan& plan = run_.plan;
    const WorkItem& item = run_.items[items_.front()];
    const std::string& file = run_.files[item.preset];
    const double duration_s = job.explosion->duration_s();
    Picture whole{{plan.width * plan.columns, plan.height * plan.rows, {}}, {}};
    render::Image& sheet = whole.image;
    sheet.rgba.resize(4u * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
    auto drawn = commands::drawPictures(run_.renderer, job, sheetShots(plan, duration_s), [&](const Shot& shot, Picture& picture) -> Expected<void> {
      const int column = static_cast<int>(shot.number) % plan.columns, row = static_cast<int>(shot.number) / plan.columns;
      render::placeInSheet(sheet, picture.image, column, row);
      if (!plan.caption.empty()) render::captionCell(sheet, plan.width, plan.height, column, row, captionOf(plan.caption, preset, file, shot));
      return {};
    });
    if (drawn && !item.index.empty()) drawn = writeFileAtomically(item.index, spriteIndex(plan, job.camera, presetName(file), item.path, preset.ground_height_m, duration_s));
    return drawn ? saveOne(whole) : drawn;
  }

  Expected<void> drawVideo(const PictureJob& job) {
    const RenderPlan& plan = run_.plan;
    WorkItem& item = run_.items[items_.front()];
    const auto shots = videoShots(plan, job.explosion->duration_s());
    if (!shots) return tl::unexpected<Error>(shots.error());
    const bool alpha = plan.background.kind == render::Background::Kind::transparent;
    auto video = render::VideoWriter::open(item.path, {videoFormatOf(plan.format), plan.width, plan.height, plan.rate.numerator, plan.rate.denominator, alpha, recipeComment(item)});
    if (!video) return tl::unexpected<Error>(video.error());
    Progress frames("frame", shots->size(), run_.progress);
    std::size_t done = 0;
    auto drawn = commands::drawPictures(run_.renderer, job, *shots, [&](const Shot&, Picture& picture) -> Expected<void> {
      if (auto added = video->add(picture.image); !added) return added;
      frames.show(++done);
      return {};
    });
    if (drawn) drawn = video->finish();
    if (drawn) item.state = FileState::written;
    return drawn;
  }

  Expected<void> drawTemplate(const Preset& preset) {
    render::TemplateScene scene;
    scene.preset = &preset;
    scene.layer = *templateLayer(run_.plan, preset);
    scene.view = run_.plan.view;
    scene.background = run_.plan.background;
    // A larger picture shows the same in finer pixels.
    scene.scale = std::max(1.0, std::min(run_.plan.width / 1280.0, run_.plan.height / 720.0));
    auto image = run_.renderer.drawToImage(scene, run_.plan.width, run_.plan.height);
    return image ? saveOne({std::move(*image), {}}) : tl::unexpected<Error>(image.error());
  }

  Expected<void> saveOne(const Picture& picture) {
    render::PngEncoder encoder(render::PngEncoder::Keep::nothing);
    auto saved = run_.save(items_.front(), picture, encoder);
    if (!saved) return saved;
    run_.items[items_.front()].state = FileState::written;
    progress_.show(done_ + 1);
    return {};
  }

  RenderRun& run_;
  std::vector<std::size_t> items_;
  Progress& progress_;
  std::size_t done_;
};

}  // namespace

Expected<void> drawItems(RenderRun& run) {
  std::vector<std::vector<std::size_t>> by_preset(run.presets.size());
  std::size_t total = 0, done = 0;
  for (std::size_t i = 0; i < run.items.size(); ++i) {
    if (run.items[i].state != FileState::planned) continue;
    by_preset[run.items[i].preset].push_back(i);
    ++total;
  }
  // A video counts its own frames.
  Progress progress(run.plan.kind == RenderKind::sequence ? "frame" : "picture", total, run.plan.kind == RenderKind::video ? ProgressMode::never : run.progress);
  for (std::vector<std::size_t>& items : by_preset) {
    if (items.empty()) continue;
    const std::size_t count = items.size();
    if (auto drawn = PresetRun(run, std::move(items), progress, done).draw(); !drawn) return drawn;
    done += count;
  }
  return {};
}

}  // namespace npsee::commands
