#include "app/render/mission_render.h"

#include "app/render/preset_shelf.h"
#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <system_error>

namespace npsee::render {
namespace {

using Kind = MissionCamera::Kind;

constexpr double kMostTime_s = kMaxMissionDuration_s;
constexpr double kFarthest_m = 1e6;

struct CameraName {
  std::string_view name;
  Kind kind;
};
constexpr CameraName kCameras[] = {{"free", Kind::free}, {"orbit", Kind::orbit}, {"follow", Kind::follow}, {"gun", Kind::gun}, {"observer", Kind::observer}, {"plan", Kind::plan}};

struct OverlayName {
  std::string_view name;
  bool MissionOverlays::* member;
};
constexpr OverlayName kOverlays[] = {{"trails", &MissionOverlays::trails}, {"drops", &MissionOverlays::drop_lines}, {"trajectories", &MissionOverlays::trajectories}, {"lines", &MissionOverlays::fire_lines},
                                     {"rings", &MissionOverlays::range_rings}, {"sight", &MissionOverlays::sight_fan}, {"beliefs", &MissionOverlays::beliefs}, {"icons", &MissionOverlays::icons},
                                     {"scorch", &MissionOverlays::scorch}, {"contours", &MissionOverlays::contours}};

/// What is wrong with a part's value; empty = nothing.
using Fault = std::string;

Fault readNumber(std::string_view text, Unit unit, double low, double high, double& out) {
  const auto value = parseQuantity(text, unit);
  if (!value) return value.error().faults.front().what;
  if (!(*value >= low && *value <= high)) return "it goes from " + quantity(low, unit) + " to " + quantity(high, unit) + ".";
  out = *value;
  return {};
}

/// "x/y/z", or "x/z" for a place on the ground (y is then NaN until the ground is known).
Fault readPlace(std::string_view text, Vec3& out) {
  const auto parts = splitAt(text, '/');
  if (parts.size() != 2 && parts.size() != 3) return "a place is x/y/z, or x/z for one on the ground, in metres.";
  double numbers[3] = {0.0, std::nan(""), 0.0};
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (Fault fault = readNumber(trimmed(parts[i]), Unit::metre, -kFarthest_m, kFarthest_m, numbers[parts.size() == 2 && i == 1 ? 2 : i]); !fault.empty()) return fault;
  out = {numbers[0], numbers[1], numbers[2]};
  return {};
}

std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Fault readSize(std::string_view text, MissionRender& out) {
  const auto parts = splitAt(text, 'x');
  const auto width = parts.size() == 2 ? wholeNumber(parts[0]) : std::nullopt, height = parts.size() == 2 ? wholeNumber(parts[1]) : std::nullopt;
  constexpr int kMost = 8192;
  if (!width || !height || *width < 16 || *height < 16 || *width > kMost || *height > kMost) return "a size is WxH in pixels, each from 16 to 8192.";
  out.width = *width;
  out.height = *height;
  return {};
}

Fault readCamera(std::string_view text, MissionRender& out) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const auto* found = std::ranges::find(kCameras, name, &CameraName::name);
  if (found == std::end(kCameras)) {
    const auto names = namesOf(kCameras, &CameraName::name);
    const auto meant = nearest(name, names);
    return "there is no camera \"" + std::string(name) + "\"; cameras are " + listed(names) + "." + (meant ? " Did you mean " + std::string(*meant) + "?" : "");
  }
  out.view.camera.kind = found->kind;
  if (colon != std::string_view::npos) out.subject = std::string(text.substr(colon + 1));
  const bool has_subject = found->kind == Kind::follow || found->kind == Kind::gun || found->kind == Kind::observer;
  if (!out.subject.empty() && !has_subject) return "the camera " + std::string(name) + " has no subject.";
  return {};
}

/// "trails+rings": shown or hidden; "all" and "none" too.
Fault readOverlays(std::string_view text, bool shown, MissionOverlays& out) {
  for (const std::string_view name : splitAt(text, '+')) {
    if (name == "all") {
      for (const OverlayName& overlay : kOverlays) out.*overlay.member = shown;
      continue;
    }
    const auto* found = std::ranges::find(kOverlays, name, &OverlayName::name);
    if (found == std::end(kOverlays)) return "there is nothing called \"" + std::string(name) + "\" to show; there are " + listed(namesOf(kOverlays, &OverlayName::name)) + ", and all.";
    out.*found->member = shown;
  }
  return {};
}

Fault readPreset(std::string_view text, MissionRender& out) {
  const std::size_t colon = text.find(':');
  const auto number = colon == std::string_view::npos ? std::optional<int>(0) : wholeNumber(text.substr(0, colon));
  const std::string_view name = colon == std::string_view::npos ? text : text.substr(colon + 1);
  if (!number || *number < 0 || name.empty()) return "it is a preset's name or file, or SHELL:NAME for one shell by its number.";
  out.presets.emplace_back(*number, std::string(name));
  return {};
}

struct Key {
  std::string_view name, help;
  std::function<Fault(std::string_view, MissionRender&)> read;
};

const std::vector<Key>& keys() {
  static const std::vector<Key> table{
      {"t", "moment, s (the end if left out)", [](std::string_view v, MissionRender& r) { return readNumber(v, Unit::second, 0.0, kMostTime_s, r.time_s.emplace(0.0)); }},
      {"camera", "free, orbit, follow[:shell number], gun[:id], observer[:id] or plan; orbit if left out", readCamera},
      {"size", "WxH pixels, 1280x720 if left out", readSize},
      {"target", "x/y/z or x/z (on the ground), m: middle of orbit and plan, what free looks at", [](std::string_view v, MissionRender& r) { r.target_given = true; return readPlace(v, r.view.camera.target); }},
      {"eye", "x/y/z, m: of the free camera", [](std::string_view v, MissionRender& r) { r.eye_given = true; return readPlace(v, r.view.camera.eye); }},
      {"distance", "m: of orbit, follow and gun", [](std::string_view v, MissionRender& r) { r.distance_given = true; return readNumber(v, Unit::metre, 1.0, kFarthest_m, r.view.camera.distance_m); }},
      {"yaw", "deg: side it looks from; orbit: clockwise from the south, follow and gun: from behind", [](std::string_view v, MissionRender& r) { r.yaw_given = true; return readNumber(v, Unit::degree, -kTwoPi, kTwoPi, r.view.camera.yaw_rad); }},
      {"pitch", "deg: above the subject", [](std::string_view v, MissionRender& r) { r.pitch_given = true; return readNumber(v, Unit::degree, -0.5 * kPi, 0.5 * kPi, r.view.camera.pitch_rad); }},
      {"fov", "deg: vertical field of view, 40 if left out", [](std::string_view v, MissionRender& r) { return readNumber(v, Unit::degree, kPi / 360.0, 5.0 * kPi / 6.0, r.view.camera.fov_y_rad); }},
      {"span", "m: of the plan, from the lower to the upper edge", [](std::string_view v, MissionRender& r) { r.span_given = true; return readNumber(v, Unit::metre, 20.0, kFarthest_m, r.view.camera.span_m); }},
      {"look", "id of the vehicle that the observer looks at", [](std::string_view v, MissionRender& r) { r.look_at = std::string(v); return Fault(); }},
      {"field", "mil: the binoculars' circle, 130 if left out; 0 = the naked eye",
       [](std::string_view v, MissionRender& r) {
         double field = 0.0;
         Fault fault = readNumber(v, Unit::mil, 0.0, toSi(Unit::mil, 1500.0), field);
         r.view.camera.binoculars = field > 0.0;
         if (field > 0.0) r.view.camera.field_mil = std::max(toUnit(Unit::mil, field), 2.0);
         return fault;
       }},
      {"turn", "mil: the observer looks this much farther right", [](std::string_view v, MissionRender& r) { return readNumber(v, Unit::mil, -kTwoPi, kTwoPi, r.view.camera.turn_rad); }},
      {"show", "what to draw besides, joined by +: trails, drops, trajectories, lines, rings, sight, beliefs, icons, scorch, contours, all", [](std::string_view v, MissionRender& r) { return readOverlays(v, true, r.view.overlays); }},
      {"hide", "what not to draw, likewise", [](std::string_view v, MissionRender& r) { return readOverlays(v, false, r.view.overlays); }},
      {"least", "px: vehicles are drawn at least this long, 20 if left out; 0 = true sizes", [](std::string_view v, MissionRender& r) { return readNumber(v, Unit::none, 0.0, 500.0, r.view.least_px); }},
      {"preset", "explosion preset for every shell, or SHELL:NAME for one, instead of the mission's", readPreset},
      {"smooth", "1: several samples per pixel (default), 0: faster", [](std::string_view v, MissionRender& r) { r.view.smooth = v != "0"; return v == "0" || v == "1" ? Fault() : Fault("it is 0 or 1."); }},
      {"out", "file of this picture, instead of -o", [](std::string_view v, MissionRender& r) { r.output = std::string(v); return Fault(); }},
  };
  return table;
}

tl::unexpected<Error> refused(std::string_view text, const std::string& why, std::string remedy) {
  return fail(ErrorKind::usage, "--render " + std::string(text) + ": " + why, std::move(remedy));
}

std::string exampleText() { return "For example --render \"t=12.5,camera=observer,size=1280x720\"; `npsee mission --help` lists all keys."; }

}  // namespace

std::string_view missionRenderHelp() {
  static const std::string text = [] {
    std::string out;
    for (const Key& key : keys()) out += "  " + std::string(key.name) + std::string(10 - key.name.size(), ' ') + std::string(key.help) + "\n";
    return out;
  }();
  return text;
}

Expected<MissionRender> parseMissionRender(std::string_view text) {
  MissionRender out;
  out.text = std::string(text);
  out.view.smooth = true;
  for (const std::string_view raw : splitAt(text, ',')) {
    const std::string_view part = trimmed(raw);
    if (part.empty()) continue;
    const std::size_t equals = part.find('=');
    const std::string_view name = trimmed(part.substr(0, equals));
    const auto found = std::ranges::find(keys(), name, &Key::name);
    if (found == keys().end()) {
      const auto names = namesOf(keys(), &Key::name);
      const auto meant = nearest(name, names);
      return refused(text, "there is no key \"" + std::string(name) + "\"." + (meant ? " Did you mean " + std::string(*meant) + "?" : ""), exampleText());
    }
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : trimmed(part.substr(equals + 1));
    if (value.empty()) return refused(text, std::string(name) + " has no value.", exampleText());
    if (const Fault fault = found->read(value, out); !fault.empty()) return refused(text, std::string(name) + "=" + std::string(value) + ": " + fault, exampleText());
  }
  if (out.view.camera.kind == Kind::free && (!out.eye_given || !out.target_given)) return refused(text, "the free camera needs a place to stand and one to look at.", "Add eye=X/Y/Z and target=X/Y/Z.");
  return out;
}

namespace {

/// Index by id; usage error naming the nearest.
template <class Records>
Expected<int> findById(const MissionRender& render, const Records& records, const std::string& id, const char* what) {
  for (std::size_t i = 0; i < records.size(); ++i)
    if (records[i].id == id) return static_cast<int>(i);
  auto names = namesOf(records, &Records::value_type::id);
  const auto meant = nearest(id, names);
  if (names.size() > 12) names.resize(12);
  return refused(render.text, std::string("there is no ") + what + " \"" + id + "\"." + (meant ? " Did you mean " + std::string(*meant) + "?" : ""),
                 names.empty() ? std::string("The mission has none.") : "There are " + listed(names) + (records.size() > names.size() ? " and more." : "."));
}

Expected<int> findSubject(const MissionRender& render, const Recording& recording) {
  const std::string& id = render.subject;
  if (render.view.camera.kind == Kind::gun) return findById(render, recording.guns, id, "gun");
  if (render.view.camera.kind == Kind::observer) return findById(render, recording.observers, id, "observer");
  if (const auto number = wholeNumber(id))
    for (std::size_t i = 0; i < recording.shells.size(); ++i)
      if (recording.shells[i].number == *number) return static_cast<int>(i);
  return refused(render.text, "no shell has the number \"" + id + "\".", recording.shells.empty() ? "No shell was fired." : "Shells are numbered as in the log, from " + std::to_string(recording.shells.front().number) + " to " + std::to_string(recording.shells.back().number) + ".");
}

/// What the camera needs and the mission does not have.
std::string missingSubject(Kind kind, const Recording& recording) {
  if (kind == Kind::observer && recording.observers.empty()) return "the mission has no observer to look through.";
  if (kind == Kind::gun && recording.guns.empty()) return "the mission has no gun to look at.";
  if (kind == Kind::follow && recording.shells.empty()) return "there is no shell to follow: none was fired up to " + shortest(recording.duration_s) + " s.";
  return {};
}

}  // namespace

Expected<MissionView> missionView(const MissionRender& render, const Recording& recording) {
  MissionView out = render.view;
  MissionCamera& camera = out.camera;
  const double aspect = static_cast<double>(render.width) / render.height;
  if (!render.subject.empty()) {
    const auto subject = findSubject(render, recording);
    if (!subject) return tl::unexpected<Error>(subject.error());
    camera.subject = *subject;
  } else if (const std::string missing = missingSubject(camera.kind, recording); !missing.empty()) {
    return refused(render.text, missing, "Choose another camera: free, orbit or plan need nothing to look at.");
  }
  if (!render.look_at.empty()) {
    const auto vehicle = findById(render, recording.vehicles, render.look_at, "vehicle");
    if (!vehicle) return tl::unexpected<Error>(vehicle.error());
    camera.look_at = *vehicle;
  }
  if (camera.kind == Kind::orbit || camera.kind == Kind::plan) {
    const MissionCamera overview = overviewCamera(recording, camera.kind, aspect);
    if (!render.target_given) camera.target = overview.target;
    if (!render.span_given) camera.span_m = overview.span_m;
    // Around a place that was asked for one looks from nearer than at everything.
    if (!render.distance_given) camera.distance_m = render.target_given ? 400.0 : overview.distance_m;
    if (!render.yaw_given) camera.yaw_rad = overview.yaw_rad;
    if (!render.pitch_given) camera.pitch_rad = overview.pitch_rad;
  } else {
    if (!render.distance_given) camera.distance_m = camera.kind == Kind::gun ? 45.0 : 60.0;
    if (!render.yaw_given) camera.yaw_rad = 0.5;
    if (!render.pitch_given) camera.pitch_rad = 0.22;
  }
  for (Vec3* place : {&camera.target, &camera.eye})
    if (std::isnan(place->y)) place->y = recording.terrain.surface(place->x, place->z) + (place == &camera.eye ? 2.0 : 0.0);
  std::error_code gone;  // then the name is looked up as it is
  const std::filesystem::path here = std::filesystem::current_path(gone);
  for (const auto& [number, name] : render.presets) {
    auto preset = PresetShelf::lookUp(name, here);
    if (!preset && preset.error().kind != ErrorKind::usage) return tl::unexpected<Error>(preset.error());
    if (!preset) return refused(render.text, preset.error().faults.front().what, preset.error().faults.front().remedy);
    out.presets[number] = std::move(*preset);
  }
  return out;
}

}  // namespace npsee::render
