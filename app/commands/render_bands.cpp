#include "app/commands/render_bands.h"

#include "app/render/deep_image.h"
#include "app/render/exr.h"

#include <utility>

namespace npsee::commands {

bool inBands(const RenderPlan& plan) { return plan.floats && static_cast<std::int64_t>(plan.width) * plan.height > render::kMostWholeFloats; }

BandFile::BandFile(TemporaryFile file) : file_(std::move(file)) {}

BandFile::~BandFile() {
  if (running_.valid()) running_.wait();
}

Expected<std::unique_ptr<BandFile>> BandFile::open(const RenderPlan& plan, const WorkItem& item) {
  if (isSpecialFile(item.path)) return cannotWrite(item.path, "a picture of more than " + std::to_string(render::kMostWholeFloats) + " pixels in single precision is put together in a regular file", "Name a file, or choose a smaller --size.");
  auto file = TemporaryFile::beside(item.path);
  if (!file) return tl::unexpected<Error>(file.error());
  std::unique_ptr<BandFile> out(new BandFile(std::move(*file)));
  if (plan.format == FileFormat::exr) {
    auto exr = render::ExrWriter::open(out->file_.path(), plan.width, plan.height, *plan.floats, recipeText(item));
    if (!exr) return tl::unexpected<Error>(exr.error());
    out->exr_ = std::move(*exr);
    return out;
  }
  // Whether a pixel is not opaque would be known after the last band only.
  const bool alpha = plan.background.kind == render::Background::Kind::transparent;
  out->png_ = std::make_unique<render::DeepPngWriter>(plan.width, plan.height, alpha, recipeText(item));
  out->bytes_.open(out->file_.path(), std::ios::binary | std::ios::trunc);
  return out;
}

Expected<void> BandFile::wait() { return running_.valid() ? running_.get() : Expected<void>(); }

Expected<void> BandFile::add(render::FloatImage& band) {
  if (auto done = wait(); !done) return done;
  std::swap(band_, band);
  // Deferred, to the moment it is waited for, where no thread can be started.
  running_ = std::async(std::launch::async | std::launch::deferred, [this] { return encode(band_); });
  return {};
}

Expected<void> BandFile::encode(const render::FloatImage& band) {
  if (exr_) return exr_->add(band);
  const auto bytes = png_->add(sixteenBits(band.rgba));
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  bytes_.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  return bytes_ ? Expected<void>() : fail(ErrorKind::output, "a picture cannot be written: there is no room for it.", "Make room, or choose another place; nothing was changed.");
}

Expected<void> BandFile::finish() {
  if (auto done = wait(); !done) return done;
  if (exr_)
    if (auto done = exr_->finish(); !done) return done;
  if (png_) {
    bytes_.close();
    if (!bytes_) return fail(ErrorKind::output, "a picture cannot be written: there is no room for it.", "Make room, or choose another place; nothing was changed.");
  }
  return file_.publish();
}

}  // namespace npsee::commands
