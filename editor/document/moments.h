#pragma once

#include <npsee/explosion.h>

#include <optional>
#include <string_view>
#include <vector>

namespace npsee::editor {

/// What happens when, as marks on the time line.
struct Moments {
  std::optional<double> first_contact_s;  ///< a particle touches the ground for the first time
  std::optional<double> last_death_s;     ///< the last particle dies; none where some come to rest and stay
};
/// Found by looking at the explosion at about twenty moments; exact to a millisecond. Thread-safe.
Moments momentsOf(const Explosion& explosion);

struct Mark {
  std::string_view name;
  double time_s = 0.0;
};
/// The burst and what there is of the moments, in the order of time.
std::vector<Mark> marksOf(const Moments& moments);

}  // namespace npsee::editor
