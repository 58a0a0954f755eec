#pragma once

#include "app/render/image_compare.h"

#include <npsee/error.h>

#include <string>

namespace CLI {
class App;
}

namespace npsee::commands {

/// `--max`, `--mean`, `--ssim` and `--pixels` as they were typed; empty = not given.
struct ToleranceOptions {
  std::string max, mean, ssim, pixels;
  std::string light, depth, motion;  ///< of OpenEXR pictures
  bool given() const { return !(max.empty() && mean.empty() && ssim.empty() && pixels.empty() && light.empty() && depth.empty() && motion.empty()); }
};
void addToleranceOptions(CLI::App& command, ToleranceOptions& options);
/// `--light`, `--depth` and `--motion`, for commands that compare OpenEXR pictures.
void addPassToleranceOptions(CLI::App& command, ToleranceOptions& options);

/// Error kind usage for each option that cannot be read.
Expected<render::Tolerance> readTolerance(const ToleranceOptions& options);

/// "max 2, 0.01 % over 2", or "nothing may differ".
std::string toleranceText(const render::Tolerance& tolerance);

}  // namespace npsee::commands
