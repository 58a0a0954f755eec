#include "editor/document/moments.h"

#include <algorithm>

namespace npsee::editor {
namespace {

constexpr double kExact_s = 1e-3;

bool anyBounce(const Explosion& explosion, double t, Frame& frame) {
  explosion.at(t, frame, kBounces);
  const auto end = frame.bounces.begin() + static_cast<std::ptrdiff_t>(frame.count);
  return std::any_of(frame.bounces.begin(), end, [](std::uint8_t bounces) { return bounces > 0; });
}

}  // namespace

Moments momentsOf(const Explosion& explosion) {
  Moments out;
  const double end = explosion.duration_s();
  if (explosion.particleCount() == 0 || !(end > 0.0)) return out;
  Frame frame;
  explosion.at(end + kExact_s, frame, kPosition);
  const auto last = frame.alive.begin() + static_cast<std::ptrdiff_t>(frame.count);
  if (std::find(frame.alive.begin(), last, std::uint8_t{1}) == last) out.last_death_s = end;
  // Contacts are counted on, so that the first is found by halving.
  if (!anyBounce(explosion, end, frame)) return out;
  double before = 0.0, after = end;
  while (after - before > kExact_s) {
    const double middle = 0.5 * (before + after);
    (anyBounce(explosion, middle, frame) ? after : before) = middle;
  }
  out.first_contact_s = after;
  return out;
}

std::vector<Mark> marksOf(const Moments& moments) {
  std::vector<Mark> out{{"burst", 0.0}};
  if (moments.first_contact_s) out.push_back({"first contact", *moments.first_contact_s});
  if (moments.last_death_s) out.push_back({"last death", *moments.last_death_s});
  return out;
}

}  // namespace npsee::editor
