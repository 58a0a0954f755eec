#include "editor/panels/desk/view_tools.h"

#include "app/render/view.h"
#include "editor/mission/session.h"
#include "editor/ui/controls.h"

#include <npsee/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace npsee::editor {
namespace {

/// The picture's axes and scale.
render::View viewOf(const render::Camera& camera, const Box& box) { return render::makeView(camera, std::max(1, static_cast<int>(box.width)), std::max(1, static_cast<int>(box.height))); }

constexpr double kNear_m = 0.05;

/// Pixels that a metre at a distance of one metre takes.
double pixelsPerShare(const render::Camera& camera, const Box& box) { return 0.5 * static_cast<double>(box.height) / std::tan(0.5 * camera.fov_y_rad); }

/// A line in the world, cut off at the eye's plane.
void worldLine(const PanelContext& ui, const Box& box, Vec3 a, Vec3 b, ImU32 colour, float width) {
  const render::Camera& camera = ui.session.camera;
  const render::View view = viewOf(camera, box);
  const double from = view.depthOf(a.x, a.y, a.z), to = view.depthOf(b.x, b.y, b.z);
  if (from < kNear_m && to < kNear_m) return;
  const auto cut = [&](const Vec3& inside, const Vec3& outside, double d_in, double d_out) { return inside + ((d_in - 2.0 * kNear_m) / (d_in - d_out)) * (outside - inside); };
  if (from < kNear_m) a = cut(b, a, to, from);
  if (to < kNear_m) b = cut(a, b, from, to);
  const auto p = placeInPicture(camera, box, a), q = placeInPicture(camera, box, b);
  if (p && q) ImGui::GetWindowDrawList()->AddLine(*p, *q, colour, width);
}

std::string metres(double m) { return shortNumber(m < 10.0 ? std::round(m * 100.0) / 100.0 : std::round(m * 10.0) / 10.0) + " m"; }

void words(const PanelContext& ui, ImVec2 at, const std::string& text, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  // Whole at the picture's edges too.
  const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
  const float x = std::clamp(at.x, low.x + 0.5f * size.x + ui.px(10), std::max(low.x + 0.5f * size.x + ui.px(10), high.x - 0.5f * size.x - ui.px(10)));
  const float y = std::min(at.y, high.y - ui.px(90));  // the tools lie below
  const ImVec2 min{std::floor(x - 0.5f * size.x), std::floor(y - 0.5f * size.y)};
  list.AddRectFilled({min.x - ui.px(6), min.y - ui.px(3)}, {min.x + size.x + ui.px(6), min.y + size.y + ui.px(3)}, faded(ui.theme.background, 0.82f), ui.px(4));
  list.AddText(min, colour, text.c_str());
  ImGui::PopFont();
}

void drawExtent(const PanelContext& ui, const Box& box) {
  const Explosion* const explosion = ui.session.explosion();
  if (explosion == nullptr || explosion->particleCount() == 0) return;
  const Vec3 low = explosion->extent().min, high = explosion->extent().max;
  const auto corner = [&](int i) { return Vec3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; };
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if ((i & bit) == 0) worldLine(ui, box, corner(i), corner(i | bit), faded(ui.theme.geometry, 0.8f), ui.px(1.2f));
  const auto tell = [&](int a, int b, double m, const char* what) {
    if (const auto at = placeInPicture(ui.session.camera, box, 0.5 * (corner(a) + corner(b)))) words(ui, *at, metres(m) + what, ui.theme.geometry);
  };
  tell(4, 5, high.x - low.x, " east-west");
  tell(1, 5, high.z - low.z, " north-south");
  tell(5, 7, high.y - low.y, " high");
}

void drawRuler(const PanelContext& ui, const Box& box) {
  const DeskUi::View& my = ui.state.desk.view;
  if (!my.ruler || my.points == 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < my.points; ++i)
    if (const auto at = placeInPicture(ui.session.camera, box, my.ends[static_cast<std::size_t>(i)])) list.AddCircleFilled(*at, ui.px(4), ui.theme.accent, 16);
  if (my.points < 2) return;
  const Vec3 between = my.ends[1] - my.ends[0];
  worldLine(ui, box, my.ends[0], my.ends[1], ui.theme.accent, ui.px(1.6f));
  std::string text = metres(length(between));
  if (std::abs(between.y) > 0.05) text += ", " + metres(std::abs(between.y)) + (between.y > 0.0 ? " up" : " down");
  if (const auto at = placeInPicture(ui.session.camera, box, 0.5 * (my.ends[0] + my.ends[1]))) words(ui, {at->x, at->y - ui.px(16)}, text, ui.theme.text);
}

/// A bar as long as a round number of metres at the reference point.
void drawScale(const PanelContext& ui, const Box& box) {
  const render::Camera& camera = ui.session.camera;
  const double pixels_per_metre = pixelsPerShare(camera, box) / std::max(length(camera.target - camera.eye), 1e-6);
  const double wish = static_cast<double>(ui.px(90)) / pixels_per_metre, decade = std::pow(10.0, std::floor(std::log10(wish)));
  const double lead = wish / decade, round = decade * (lead < 2.0 ? 1.0 : lead < 5.0 ? 2.0 : 5.0);
  const auto width = static_cast<float>(round * pixels_per_metre);
  const ImVec2 at{box.at.x + ui.px(84), box.end().y - ui.px(20)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  const std::string text = shortNumber(round) + " m";
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - ui.px(8), at.y - ui.px(9)}, {at.x + width + size.x + ui.px(18), at.y + ui.px(9)}, faded(ui.theme.background, 0.82f), ui.px(4));
  for (const float x : {at.x, at.x + width}) list.AddLine({x, at.y - ui.px(4)}, {x, at.y + ui.px(4)}, ui.theme.text, ui.px(1.2f));
  list.AddLine(at, {at.x + width, at.y}, ui.theme.text, ui.px(1.2f));
  list.AddText({at.x + width + ui.px(8), std::floor(at.y - 0.5f * size.y)}, ui.theme.text, text.c_str());
  ImGui::PopFont();
  ui.item("scale", {at.x, at.y - ui.px(4)}, {at.x + width, at.y + ui.px(4)});
}

struct Choice {
  const char *key, *label;
};
constexpr std::array kBackgrounds{Choice{"sky", "Sky and ground"}, Choice{"black", "Black"}, Choice{"#10141e", "Night"}, Choice{"#6b7078", "Grey"}, Choice{"white", "White"}};
constexpr std::array kQualities{Choice{"automatic", "Automatic quality"}, Choice{"draft", "Draft quality"}, Choice{"normal", "Normal quality"}, Choice{"fine", "Fine quality when still"}};

template <class Choices>
void offer(const PanelContext& ui, const Choices& choices, std::string& now) {
  for (const Choice& choice : choices) {
    if (checkEntry(choice.label, now == choice.key)) now = choice.key;
    ui.item(std::string("item:") + choice.label);
  }
}

void drawViewMenu(const PanelContext& ui) {
  DeskUi::View& my = ui.state.desk.view;
  offer(ui, kBackgrounds, my.background);
  ImGui::Separator();
  offer(ui, kQualities, my.quality);
  ImGui::Separator();
  for (std::size_t i = 0; i < kBookmarks; ++i) {
    const std::string number = std::to_string(i + 1);
    const bool kept = i < my.bookmarks.size() && !my.bookmarks[i].empty();
    if (ImGui::MenuItem(("Bookmark " + number).c_str(), ("Ctrl+" + number).c_str(), false, kept)) goToBookmark(ui, i);
    ui.item("item:Bookmark " + number);
  }
}

/// The observer's distance from the reference point, to be dragged and typed.
void drawDistance(const PanelContext& ui, const Box& box) {
  render::Camera& camera = ui.session.camera;
  const Vec3 arm = camera.eye - camera.target;
  const double distance = length(arm);
  const double step = distance < 10.0 ? 0.01 : 0.1;  // what is shown; what is typed counts exactly
  const NumberSpec spec{std::round(distance / step) * step, {1.0, 1000.0}, {0.1, 50000.0}, Scale::logarithmic, false, false};
  std::optional<double> wanted;
  if (typingIn(ui, "distance")) {
    if (const auto text = typingField(ui, box)) {
      const auto typed = parseQuantity(*text, Unit::metre);
      if (typed && *typed >= spec.hard.min && *typed <= spec.hard.max) {
        wanted = *typed;
        ui.state.typing = {};
      } else {
        refuseTyping(ui, typed ? "The distance goes from 0.1 m to 50 km." : typed.error().faults.front().what);
      }
    }
  } else {
    wanted = numberField(ui, "distance", spec, box, "from");
    if (ui.resting("number:distance", "The observer's distance from the reference point, m: drag sideways, double click to type.")) tooltip(ui, "Distance of the eye from the reference point, m");
  }
  if (wanted && distance > 0.0) camera.eye = camera.target + (*wanted / distance) * arm;
}

/// The camera's exposure, to be dragged and typed.
void drawExposure(const PanelContext& ui, const Box& box) {
  constexpr double kMost = render::kMostExposure_stops;
  double& stops = ui.state.desk.view.exposure_stops;
  const NumberSpec spec{std::round(stops * 100.0) / 100.0, {-kMost, kMost}, {-kMost, kMost}, Scale::linear, false, false};
  if (typingIn(ui, "exposure")) {
    const auto text = typingField(ui, box);
    if (!text) return;
    const auto typed = parseQuantity(*text, Unit::none);
    if (typed && std::abs(*typed) <= kMost) {
      stops = *typed;
      ui.state.typing = {};
    } else {
      refuseTyping(ui, "The exposure goes from -4 to 4 stops.");
    }
    return;
  }
  if (const auto wanted = numberField(ui, "exposure", spec, box, "EV")) stops = std::clamp(std::round(*wanted * 20.0) / 20.0, -kMost, kMost);
  if (ui.resting("number:exposure", "The camera's exposure, stops: drag sideways, double click to type; E longer, Shift+E shorter, Alt+E usual.")) tooltip(ui, "Exposure: each stop doubles the light (E, Shift+E)");
}

struct ViewSwitch {
  const char *label, *tip;
  bool DeskUi::View::*on;
};
constexpr std::array kSwitches{ViewSwitch{"grid", "Metre grid on the ground: lines every 1, 10 and 100 m", &DeskUi::View::grid}, ViewSwitch{"extent", "Box around all that the effect ever reaches (B)", &DeskUi::View::extent},
                               ViewSwitch{"ruler", "Click two places to measure between them (M)", &DeskUi::View::ruler}};
constexpr float kDistanceWidth = 96.0f, kGap = 2.0f;  // unscaled pixels

/// A narrow viewport leaves the exposure to its keys.
float exposureWidth(const PanelContext& ui, const Box& box) { return box.width > ui.px(400) ? ui.px(66) : 0.0f; }

}  // namespace

std::optional<ImVec2> placeInPicture(const render::Camera& camera, const Box& box, const Vec3& point) {
  const render::View view = viewOf(camera, box);
  const Vec3 from = point - camera.eye;
  const double depth = view.depthOf(point.x, point.y, point.z);
  if (depth < kNear_m) return std::nullopt;
  const double scale = pixelsPerShare(camera, box) / depth;
  return ImVec2{box.at.x + 0.5f * box.width + static_cast<float>(scale * dot(from, view.right)), box.at.y + 0.5f * box.height - static_cast<float>(scale * dot(from, view.up))};
}

Vec3 placeUnder(const render::Camera& camera, const Box& box, ImVec2 at, double ground_m) {
  const render::View view = viewOf(camera, box);
  const double scale = pixelsPerShare(camera, box);
  const double x = static_cast<double>(at.x - box.at.x - 0.5f * box.width) / scale, y = static_cast<double>(box.at.y + 0.5f * box.height - at.y) / scale;
  const Vec3 forward = -1.0 * view.back;
  const Vec3 ray = forward + x * view.right + y * view.up;
  constexpr double kFar_m = 5000.0;
  if (ray.y < -1e-6) {
    const double t = (ground_m - camera.eye.y) / ray.y;
    if (t > 0.0 && t < kFar_m) return camera.eye + t * ray;
  }
  // The upright plane through the burst, across the line of sight.
  const Vec3 level{forward.x, 0.0, forward.z};
  const double along = dot(ray, level);
  if (std::abs(along) < 1e-9) return camera.target;
  return camera.eye + (dot(Vec3{} - camera.eye, level) / along) * ray;
}

void handleRuler(const PanelContext& ui, const Box& box) {
  DeskUi::View& my = ui.state.desk.view;
  if (!my.ruler || !ImGui::IsItemDeactivated()) return;
  // A drag turns the view, as always.
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  if (std::abs(moved.x) + std::abs(moved.y) > ui.px(4)) return;
  if (my.points == 2) my.points = 0;
  my.ends[static_cast<std::size_t>(my.points++)] = placeUnder(ui.session.camera, box, ImGui::GetIO().MousePos, ui.session.document.preset().ground_height_m);
}

Box viewToolsBox(const PanelContext& ui, const Box& box) {
  float width = ui.px(kDistanceWidth) + exposureWidth(ui, box) + chipWidth(ui, "view") + ui.px(4.0f * kGap + 8.0f);
  for (const ViewSwitch& entry : kSwitches) width += chipWidth(ui, entry.label) + ui.px(kGap);
  const float height = ui.px(26);
  // Above the switches of what is laid over the effect in time.
  return {{std::max(box.at.x, box.right() - width - ui.px(14)), box.end().y - height - ui.px(48)}, width, height};
}

void drawViewTools(const PanelContext& ui, const Box& box) {
  DeskUi::View& my = ui.state.desk.view;
  ImGui::PushClipRect(box.at, box.end(), true);
  if (my.extent) drawExtent(ui, box);
  drawRuler(ui, box);
  if (box.width > ui.px(430)) drawScale(ui, box);
  const Box strip = viewToolsBox(ui, box);
  const ImVec2 at = strip.at;
  const float distance_width = ui.px(kDistanceWidth), exposure_width = exposureWidth(ui, box), gap = ui.px(kGap);
  ImGui::GetWindowDrawList()->AddRectFilled(at, strip.end(), faded(ui.theme.background, 0.86f), ui.px(4));
  drawDistance(ui, {{at.x + ui.px(2), at.y + ui.px(1)}, distance_width, ui.px(24)});
  if (exposure_width > 0.0f) drawExposure(ui, {{at.x + distance_width + ui.px(2), at.y + ui.px(1)}, exposure_width, ui.px(24)});
  float x = at.x + distance_width + exposure_width + 2.0f * gap + ui.px(4);
  for (const ViewSwitch& entry : kSwitches) {
    ImGui::SetCursorScreenPos({x, at.y + ui.px(2)});
    bool& on = my.*entry.on;
    if (chip(ui, entry.label, entry.label, on, entry.tip)) on = !on;
    x += chipWidth(ui, entry.label) + gap;
  }
  ImGui::SetCursorScreenPos({x, at.y + ui.px(2)});
  if (chip(ui, "view", "view", false, "Background, quality and bookmarks")) ImGui::OpenPopup("view tools");
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  dropDown(ui, "view tools", min, max, [&] { drawViewMenu(ui); });
  ImGui::PopClipRect();
}

const DrawnQuality& adaptQuality(const Session& session, DeskUi::View& my, double elapsed_s) {
  const render::Camera& camera = session.camera;
  const bool mission = session.inMission();
  const bool turned = mission ? session.mission().view.camera != my.seen_mission : camera != my.seen;
  const bool moves = turned || (mission ? session.mission().clock.playing : session.playback.playing || session.compiling() || session.frameStamp() != my.seen_stamp);
  my.seen = camera;
  my.seen_mission = session.mission().view.camera;
  my.seen_stamp = session.frameStamp();
  return my.chooser.choose(my.quality, moves, elapsed_s);
}

int drawnPixels(const PanelContext& ui, float length) { return std::max(1, static_cast<int>(static_cast<double>(length) * ui.state.desk.view.chooser.drawn().share)); }

void lookAlong(const PanelContext& ui, const char* name) {
  if (ui.session.explosion() == nullptr) return;
  if (const auto camera = render::parseCamera(name, ui.session.explosion()->extent(), ui.session.aspect())) ui.session.camera = *camera;
}

void keepBookmark(const PanelContext& ui, std::size_t index) {
  auto& bookmarks = ui.state.desk.view.bookmarks;
  bookmarks.resize(std::max(bookmarks.size(), index + 1));
  bookmarks[index] = render::cameraText(ui.session.camera);
  ui.session.notices.note = "Ctrl+" + std::to_string(index + 1) + " comes back to this view.";
}

void goToBookmark(const PanelContext& ui, std::size_t index) {
  const auto& bookmarks = ui.state.desk.view.bookmarks;
  const std::string text = index < bookmarks.size() ? bookmarks[index] : std::string();
  if (text.empty()) {
    ui.session.notices.note = "Nothing is kept there. Ctrl+Shift+" + std::to_string(index + 1) + " keeps a view.";
    return;
  }
  const Extent extent = ui.session.explosion() != nullptr ? ui.session.explosion()->extent() : Extent{};
  if (const auto camera = render::parseCamera(text, extent, ui.session.aspect())) ui.session.camera = *camera;
}

}  // namespace npsee::editor
