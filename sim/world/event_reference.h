#pragma once

#include <npsee/parameters.h>

#include <string>

namespace npsee::world {

/// The schema of the event log (npsee/recording.h), by event: text, Markdown, JSON, or the JSON Schema of one line.
std::string eventReference(ReferenceFormat format);

}  // namespace npsee::world
