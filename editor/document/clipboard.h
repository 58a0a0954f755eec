#pragma once

#include "editor/document/document.h"

#include <npsee/parameters.h>

#include <string>
#include <string_view>

namespace npsee::editor {

/// A layer with all that hangs on it as text for the clipboard: JSON as in a preset's file, so that it can be pasted into one, and a whole
/// file's text can be pasted here.
std::string layerText(const Preset& preset, int layer);

/// All parameters of a section but the layer's name: {"npsee": 1, "parameters": {"speed_mean": 40, ...}}. `layer` may be null for a section of
/// the burst.
std::string sectionText(const Preset& preset, const Layer* layer, Section section);

/// Adds the layers, or takes over the parameters, that `text` holds, as one undo step. Layers come after the selected one, under free names;
/// they hang on what they hung on where the preset has a layer of that name. Returns what was done, as a sentence. Error kind input says what is
/// wrong with the text, with its line; the document is then unchanged.
Expected<std::string> paste(Document& document, std::string_view text);

}  // namespace npsee::editor
