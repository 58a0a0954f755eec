#pragma once

#include "editor/ui/context.h"

namespace npsee::editor {

/// Panels are functions of the session and the widgets' state; each fills the region it is called in.
void drawMenuBar(const PanelContext& ui);
/// Errors and the question about unsaved work, in strips of their own height above the viewport; nothing covers the effect.
void drawNotices(const PanelContext& ui);
void drawFilePanel(const PanelContext& ui);
void drawLibraryPanel(const PanelContext& ui);
/// The library without its heading.
void drawLibraryList(const PanelContext& ui);
void drawTemplatePanel(const PanelContext& ui);
void drawViewport(const PanelContext& ui);
void drawLayerPanel(const PanelContext& ui);
void drawParameterPanel(const PanelContext& ui);
void drawTimeLine(const PanelContext& ui);
void drawStatusLine(const PanelContext& ui);
void drawHelpPanel(const PanelContext& ui);

/// One parameter's row: label, widget, value with unit, mark when it differs from the default.
void drawParameterRow(const PanelContext& ui, const Parameter& parameter);

/// Menu commands' shortcuts and the thesis's camera keys; call once a frame, before the panels.
void handleKeys(const PanelContext& ui);

}  // namespace npsee::editor
