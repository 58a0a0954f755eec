#pragma once

#include "editor/panels/actions.h"

namespace npsee::editor {

/// Actions of designing: clipboard, variation, comparing, what is shown of time; actions() has them too.
std::span<const Action> designActions();

/// Takes over what the clipboard holds; what was done, or why nothing could be, is said.
void pasteClipboard(const PanelContext& ui);

}  // namespace npsee::editor
