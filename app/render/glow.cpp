#include "app/render/glow.h"

#include "app/render/frame_particles.h"
#include "app/render/heat.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Light per square metre of what shines, as a multiple of its colour: a flash is far brighter than a picture can show.
double brightness(Form form) { return form == Form::flash ? 7.0 : form == Form::fire ? 2.2 : 0.0; }

/// As linearFromSrgb of shaders/common.glsl.
double linear(double c) {
  return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

}  // namespace

double Glow::reach() const { return std::sqrt(std::max({light_m2.x, light_m2.y, light_m2.z}) / kLeastGlow); }

Glow glowOf(const Frame& frame, std::span<const LayerSpan> layers) {
  Glow glow;
  double weight = 0.0, largest_m = 0.0;
  Vec3 moment, light;
  double spread = 0.0;
  for (const LayerSpan& layer : layers) {
    const double bright = brightness(layer.form);
    if (bright <= 0.0) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      const double radius = 0.5 * static_cast<double>(frame.size[i]);
      const double area = radius * radius * static_cast<double>(frame.a[i]);
      if (!(area > 0.0)) continue;
      const Vec3 place = placeOf(frame, i);
      weight += area;
      moment = moment + area * place;
      spread += area * dot(place, place);
      Colour colour{static_cast<double>(frame.r[i]), static_cast<double>(frame.g[i]), static_cast<double>(frame.b[i])};
      if (layer.temperature_k > 0.0) colour = hotColour(colour, temperatureAt(layer, frame, i));
      light = light + (area * bright) * Vec3{linear(colour.r), linear(colour.g), linear(colour.b)};
      largest_m = std::max(largest_m, radius);
    }
  }
  if (weight <= 0.0) return glow;
  glow.place = (1.0 / weight) * moment;
  const double variance = std::max(spread / weight - dot(glow.place, glow.place), 0.0);
  const double reach2 = variance + largest_m * largest_m;
  glow.radius_m = std::sqrt(reach2);
  // What overlaps shines through one surface: not more of it than the whole has.
  glow.light_m2 = std::min(1.0, reach2 / weight) * light;
  return glow;
}

void setGlow(const gl::Program& program, const Glow& glow) {
  program.set("u_glow_place", static_cast<float>(glow.place.x), static_cast<float>(glow.place.y), static_cast<float>(glow.place.z), static_cast<float>(std::max(glow.radius_m * glow.radius_m, 1e-6)));
  program.set("u_glow", static_cast<float>(glow.light_m2.x), static_cast<float>(glow.light_m2.y), static_cast<float>(glow.light_m2.z));
}

}  // namespace npsee::render
