#pragma once

#include <npsee/recording.h>

#include <string>

namespace npsee::commands {

/// Everything in the recording at a moment, as one JSON object: vehicles, guns, shells in the air, bursts of the last second,
/// observers and what they believe.
std::string stateJson(const Recording& recording, double time_s);

/// A few lines for people: what was recorded and how it ended.
std::string summaryText(const Recording& recording);

}  // namespace npsee::commands
