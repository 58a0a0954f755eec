#pragma once

#include "editor/mission/session.h"
#include "editor/ui/context.h"
#include "editor/ui/slider.h"

#include <optional>

namespace npsee::editor {

/// Panels of the mission mode; each fills the region it is called in.
void drawObjectsPanel(const PanelContext& ui);
void drawPlanPanel(const PanelContext& ui);
void drawMissionToolbar(const PanelContext& ui);
void drawMissionViewport(const PanelContext& ui);
/// Event log, shot table and ruler as tabs.
void drawBottomPanel(const PanelContext& ui);
void drawEventLog(const PanelContext& ui);
void drawShotTable(const PanelContext& ui);
void drawRulerPanel(const PanelContext& ui);
/// Parameters, mind and commands of the selected object as tabs.
void drawSelectedPanel(const PanelContext& ui);
void drawFieldPanel(const PanelContext& ui);
void drawMindPanel(const PanelContext& ui);
void drawCommandPanel(const PanelContext& ui);
void drawMissionTimeLine(const PanelContext& ui);
void drawMissionStatus(const PanelContext& ui);

/// Names and marks over the picture, as far as they do not crowd each other.
void drawLabels(const PanelContext& ui, const Box& box);

/// Keys of the mission mode that hold or move something: driving, camera. Call once a frame, before the panels.
void handleMissionKeys(const PanelContext& ui);

/// Parts of the command panel.
void drawObserverCommands(const PanelContext& ui);
void drawVehicleCommands(const PanelContext& ui);

/// Colour of a side.
ImU32 sideColour(const PanelContext& ui, Side side);
/// The map symbol of a vehicle (friendly frame, hostile diamond, neutral square), a gun or an observer, `size` pixels across.
enum class Symbol { friendly, hostile, neutral, gun, observer };
Symbol symbolOf(Side side);
void drawSymbol(const PanelContext& ui, Symbol symbol, ImVec2 centre, float size, ImU32 colour, bool destroyed);

/// What a click on the ground means now: something is placed, a call for fire is given its place, or nothing (the caller selects).
/// `vehicle` is the id of the one that lies there. True if the click was used.
bool useGroundClick(const PanelContext& ui, const Place& at, const std::string& vehicle = {});
/// What the pointer waits for, for the picture's plate; empty if it only selects.
std::string groundClickHint(const PanelContext& ui);

/// Pressing on a thing and moving drags it over the ground; one drag is one undo step. `pressed` in the frame of the press with what
/// lies under the pointer, `ground` where the pointer meets the ground now. True while something is being moved.
bool dragObject(const PanelContext& ui, bool pressed, const std::optional<ObjectRef>& under, const std::optional<Place>& ground, bool held);

}  // namespace npsee::editor
