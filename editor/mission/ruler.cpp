#include "editor/mission/ruler.h"

#include "editor/mission/words.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {

void Ruler::pick(const Vec3& ground) {
  if (points != 1) {
    from = to = ground;
    points = 1;
    return;
  }
  to = ground;
  points = 2;
}

RulerReading readRuler(const Ruler& ruler, const Terrain& terrain, int samples) {
    RulerReading out;
  const auto standing = [&](const Vec3& p, double above) { return Vec3{p.x, terrain.surface(p.x, p.z) + above, p.z}; };
  const Vec3 a = standing(ruler.from, 0.0), b = standing(ruler.to, 0.0), line = b - a;
  out.level_m = std::hypot(line.x, line.z);
  out.slope_m = length(line);
  out.height_m = line.y;
  const double azimuth = std::atan2(line.x, -line.z) * kMilPerRad;
  out.azimuth_mil = azimuth < 0.0 ? azimuth + 6400.0 : azimuth;
  out.back_azimuth_mil = std::fmod(out.azimuth_mil + 3200.0, 6400.0);
  out.elevation_mil = std::atan2(line.y, out.level_m) * kMilPerRad;
  out.profile = terrain.profile(a, b, std::max(samples, 2));
  out.sight = terrain.sight(standing(ruler.from, ruler.eye_m), standing(ruler.to, ruler.target_m));
  return out;
}

}  // namespace npsee::editor
