#pragma once

#include <npsee/parameters.h>

#include <string_view>
#include <vector>

namespace npsee::editor {

/// Courses over a particle's life that a curve or gradient can begin from.
template <class Course>
struct LifePreset {
  std::string_view name;
  Course course;
};
/// Those whose values the parameter allows.
std::vector<LifePreset<Curve>> curvePresets(const Parameter& parameter);
std::vector<LifePreset<Gradient>> gradientPresets(const Parameter& parameter);

/// The same course backwards.
Curve reversed(Curve curve);
Gradient reversed(Gradient gradient);

/// Value and colour at a fraction of life; the course must have points.
double valueOf(const Curve& curve, double at);
Colour colourOf(const Gradient& gradient, double at);

}  // namespace npsee::editor
