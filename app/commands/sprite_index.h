#pragma once

#include "app/commands/render_plan.h"

#include <filesystem>
#include <string>

namespace npsee::commands {

/// Where the index of a sheet lies: beside it, with the ending .json.
std::filesystem::path indexPath(std::filesystem::path sheet);

/// The index of a sheet of pictures that follow each other in time, as game engines read it: the "JSON array" form of texture atlases
/// (frames with filename, frame, sourceSize, pivot and duration in ms; meta with image and size). Beyond that form meta holds the
/// times in s and the scale in pixels per metre at the burst. A pivot is the burst's place, in shares from the left and the top.
std::string spriteIndex(const RenderPlan& plan, const render::Camera& camera, const std::string& name, const std::filesystem::path& sheet, double ground_m, double duration_s);

}  // namespace npsee::commands
