#pragma once

#include "editor/ui/context.h"
#include "editor/ui/slider.h"

#include <optional>

namespace npsee::editor {

/// Where a point lies in the viewport's picture; nothing behind the eye.
std::optional<ImVec2> placeInPicture(const render::Camera& camera, const Box& box, const Vec3& point);
/// The place under a point of the picture: on the ground, or, above the horizon and beyond its far end, on the upright plane through the burst that faces
/// the camera.
Vec3 placeUnder(const render::Camera& camera, const Box& box, ImVec2 at, double ground_m);

/// Sets the ruler's ends where the last item, the viewport, is clicked.
void handleRuler(const PanelContext& ui, const Box& box);
/// Where the strip of view tools lies on the viewport.
Box viewToolsBox(const PanelContext& ui, const Box& box);
/// Extent box, ruler and scale, over the picture; then the strip of view tools in its lower right corner.
void drawViewTools(const PanelContext& ui, const Box& box);

/// Chooses how finely pictures are drawn, once a frame.
const DrawnQuality& adaptQuality(const Session& session, DeskUi::View& view, double elapsed_s);
/// How many pixels are drawn for so many of the display.
int drawnPixels(const PanelContext& ui, float length);

/// A view along an axis ("front", "top", ...) that has the whole effect in sight.
void lookAlong(const PanelContext& ui, const char* name);

/// Cameras kept under 1 to 4.
inline constexpr std::size_t kBookmarks = 4;
void keepBookmark(const PanelContext& ui, std::size_t index);
void goToBookmark(const PanelContext& ui, std::size_t index);

}  // namespace npsee::editor
