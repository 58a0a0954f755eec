#pragma once

#include "app/commands/render_work.h"
#include "sim/core/files.h"

#include <fstream>
#include <future>
#include <memory>

namespace npsee::render {
class DeepPngWriter;
class ExrWriter;
}  // namespace npsee::render

namespace npsee::commands {

/// Whether the plan's pictures are drawn and written in bands of rows, since they take too much memory as a whole.
bool inBands(const RenderPlan& plan);

/// The file of a picture in single precision that comes in bands; it appears under its name when it is whole. A band is encoded while the next
/// is drawn. The bytes are those of encoded(), but that a 16-bit PNG over nothing always has alpha.
class BandFile {
 public:
  /// Error kind output.
  static Expected<std::unique_ptr<BandFile>> open(const RenderPlan& plan, const WorkItem& item);
  ~BandFile();

  /// The next rows from the top. Error kind output, also of the rows before.
  Expected<void> add(render::FloatImage& band);
  /// Error kind output.
  Expected<void> finish();

 private:
  explicit BandFile(TemporaryFile file);
  Expected<void> wait();
  Expected<void> encode(const render::FloatImage& band);

  TemporaryFile file_;
  std::unique_ptr<render::ExrWriter> exr_;
  std::unique_ptr<render::DeepPngWriter> png_;
  std::ofstream bytes_;  // of the PNG
  render::FloatImage band_;
  std::future<Expected<void>> running_;
};

}  // namespace npsee::commands
