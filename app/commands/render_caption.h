#pragma once

#include "app/commands/render_plan.h"

#include <string>

namespace npsee::commands {

inline constexpr const char* kUsualCaption = "t={time} s";

/// Error kind usage: an unknown placeholder.
Expected<void> checkCaption(const std::string& pattern);

/// The pattern with {time} (two decimals, s), {frame}, {seed}, {title} and {name} filled in.
std::string captionOf(const std::string& pattern, const Preset& preset, const std::string& file, const Shot& shot);

}  // namespace npsee::commands
