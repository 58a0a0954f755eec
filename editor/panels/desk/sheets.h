#pragma once

#include "editor/ui/context.h"

namespace npsee::editor {

/// Strips about unsaved work that was found and files that another program changed.
void drawDeskNotices(const PanelContext& ui);

/// True while a sheet takes the place of the left panels; then it can be drawn there.
bool sheetOpen(const PanelContext& ui);
void drawSheet(const PanelContext& ui);
/// A sheet's heading with the button that closes it.
void sheetHeading(const PanelContext& ui, const char* title);

/// All steps that can be undone and redone; a click goes there.
void drawHistorySheet(const PanelContext& ui);
/// What the person was told since the start.
void drawMessagesSheet(const PanelContext& ui);
/// Commands, parameters and presets by a few letters of their name.
void drawPaletteSheet(const PanelContext& ui);
/// Pictures, sequences, sheets and videos, made beside the editing.
void drawExportSheet(const PanelContext& ui);
void openExport(const PanelContext& ui, ExportKind kind);
/// Puts the `npsee render` line of the export that is set up on the clipboard.
void copyCommandLine(const PanelContext& ui);

/// The hints of the first start, one beside what it tells of.
void drawTour(const PanelContext& ui);

}  // namespace npsee::editor
