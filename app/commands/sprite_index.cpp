#include "app/commands/sprite_index.h"

#include "app/render/view.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace npsee::commands {
namespace {

using Json = nlohmann::ordered_json;

std::string frameName(const std::string& name, std::int64_t number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "_%04lld", static_cast<long long>(number));
  return name + digits;
}

/// Where a point of the world is drawn, in shares from the left and the top.
Json pivotOf(const render::View& view, const Vec3& point) {
  const float* m = view.view_projection;
  const double p[] = {point.x, point.y, point.z, 1.0};
  const auto row = [&](int i) { return m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i] * p[3]; };
  return {{"x", 0.5 + 0.5 * row(0) / row(3)}, {"y", 0.5 - 0.5 * row(1) / row(3)}};
}

}  // namespace

std::filesystem::path indexPath(std::filesystem::path sheet) { return sheet.replace_extension(".json"); }

std::string spriteIndex(const RenderPlan& plan, const render::Camera& camera, const std::string& name, const std::filesystem::path& sheet, double ground_m, double duration_s) {
  const render::View view = render::makeView(camera, plan.width, plan.height);
  const Vec3 burst{0.0, ground_m, 0.0};
  const Json pivot = pivotOf(view, burst), size{{"w", plan.width}, {"h", plan.height}};
  const std::vector<Shot> shots = sheetShots(plan, duration_s);
  const auto [from, to] = plan.range_s.value_or(std::pair(0.0, duration_s));
  const double frame_s = (to - from) / static_cast<double>(shots.size());
  Json frames = Json::array(), times = Json::array();
  for (const Shot& shot : shots) {
    const int column = static_cast<int>(shot.number) % plan.columns, row = static_cast<int>(shot.number) / plan.columns;
    frames.push_back({{"filename", frameName(name, shot.number)},
                      {"frame", {{"x", column * plan.width}, {"y", row * plan.height}, {"w", plan.width}, {"h", plan.height}}},
                      {"rotated", false},
                      {"trimmed", false},
                      {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", plan.width}, {"h", plan.height}}},
                      {"sourceSize", size},
                      {"pivot", pivot},
                      {"duration", 1000.0 * frame_s}});
    times.push_back(shot.time_s);
  }
  const double depth_m = view.depthOf(burst.x, burst.y, burst.z);
  Json meta{{"app", "npsee"}, {"version", NPSEE_VERSION}, {"image", sheet.filename().string()}, {"format", "RGBA8888"}, {"size", {{"w", plan.width * plan.columns}, {"h", plan.height * plan.rows}}}, {"scale", "1"}};
  meta["frameTags"] = Json::array({{{"name", name}, {"from", 0}, {"to", shots.size() - 1}, {"direction", "forward"}}});
  meta["columns"] = plan.columns;
  meta["rows"] = plan.rows;
  meta["premultiplied"] = false;
  meta["times_s"] = times;
  meta["pixels_per_metre"] = depth_m > 0.0 ? Json(1.0 / (view.metre_per_pixel * depth_m)) : Json();
  return Json{{"frames", frames}, {"meta", meta}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace npsee::commands
