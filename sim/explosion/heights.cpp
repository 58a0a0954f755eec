#include "sim/explosion/compile.h"
#include "sim/explosion/contact.h"
#include "sim/preset/validate.h"

#include <algorithm>
#include <cmath>

namespace npsee::explosion {
namespace {

double clearance(const Ground& ground, const Motion<double>& m) { return m.y - ground.height(m.x, m.z); }

/// Time in (0, life] at which the arc first goes under the ground, or kNever_s.
double contactOnHeights(const Flight& flight, const Ground& ground, const Motion<double>& m, double life) {
  double from = 0.0;
  // Rounding may leave a start a hair under the ground; the search begins once it is above.
  bool above = clearance(ground, m) > 0.0;
  const double half_detail = 0.5 * std::max(1e-3, ground.detail());
  for (int step = 0; step < 1'000'000 && from < life; ++step) {
    const Motion<double> here = flownBy(flight, m, from);
    const double speed = std::sqrt(here.vx * here.vx + here.vy * here.vy + here.vz * here.vz);
    // The speed may grow within the step by the acceleration; a quarter of a second bounds that.
    const double to = std::min(life, from + std::clamp(half_detail / std::max(speed, 1e-9), 1e-5, 0.25));
    if (clearance(ground, flownBy(flight, m, to)) > 0.0) {
      above = true;
    } else if (above || step == 0) {
      double low = from, high = to;
      for (int halving = 0; halving < 200; ++halving) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        (clearance(ground, flownBy(flight, m, middle)) > 0.0 ? low : high) = middle;
      }
      return high;
    }
    from = to;
  }
  return kNever_s;
}

float notUnder(double height) {
  const auto rounded = static_cast<float>(height);
  return rounded < height ? std::nextafterf(rounded, INFINITY) : rounded;
}

void append(ArcRoom& room, int lane, double start, const Motion<double>& m) {
  const int number = ++room.last[lane];
  room.arcs[lane][number] = {start, m.vy, static_cast<float>(m.x), static_cast<float>(m.z), static_cast<float>(m.vx), static_cast<float>(m.vz)};
  room.heights[lane][number] = static_cast<float>(m.y);
}

/// Velocity after a contact: the part along the normal turned back and damped, the part along the ground rubbed off.
Vec3 bounced(const LayerConstants& c, const Vec3& velocity, const Vec3& normal, double& away) {
  const double towards = dot(velocity, normal);
  away = -c.restitution * std::min(0.0, towards);
  return (1.0 - c.friction) * (velocity - towards * normal) + away * normal;
}

}  // namespace

void findArcsOnHeights(const LayerConstants& c, const Ground& ground, const Motion<double>& launch, double life, ArcRoom& room, int lane) {
  Motion<double> m = launch;
  double start = 0.0;
  m.y = std::max(m.y, c.collide ? ground.height(m.x, m.z) : m.y);
  // The first arc was appended by the caller, relative to the layer's origin.
  if (!c.collide) return;
  for (int bounce = 0; bounce <= c.bounce_limit; ++bounce) {
    const double tau = contactOnHeights(c.flight, ground, m, life - start);
    if (tau >= kNever_s) return;
    const Motion<double> hit = flownBy(c.flight, m, tau);
    start += tau;
    double away = 0.0;
    const Vec3 after = bounced(c, {hit.vx, hit.vy, hit.vz}, ground.normal(hit.x, hit.z), away);
    const bool stays = away < c.rest_speed_mps || bounce >= c.bounce_limit || away == 0.0;
    const auto x = static_cast<float>(hit.x), z = static_cast<float>(hit.z);
    m = {x, notUnder(ground.height(x, z)), z, floatTowardsZero(after.x), after.y, floatTowardsZero(after.z)};
    if (stays) m.vx = m.vy = m.vz = 0.0;
    append(room, lane, start, m);
    room.rests[lane] = stays;
    if (stays) return;
  }
}

void findArcsAlongGround(const LayerConstants& c, const Ground& ground, const Motion<double>& launch, double life, ArcRoom& room, int lane) {
  const double above = std::max(0.0, launch.y - ground.height(launch.x, launch.z)), speed = std::sqrt(launch.vx * launch.vx + launch.vz * launch.vz);
  const double thrown = c.flight.k > 0.0 ? std::min(speed * life, speed / c.flight.k) : speed * life;
  const double way = thrown + life * std::sqrt(c.flight.wx * c.flight.wx + c.flight.wz * c.flight.wz);
  const int cuts = std::clamp(static_cast<int>(std::min(1e6, way / (0.5 * std::max(1e-3, ground.detail())))) + 1, 1, kMostArcsAlongGround);
  const auto heightAbove = [&](double t) { return flownBy(c.flight, {0.0, above, 0.0, 0.0, launch.vy, 0.0}, t).y; };
  Motion<double> m = launch;
  double start = 0.0;
  for (int cut = 1; cut <= cuts; ++cut) {
    // Closer together at first, where the way is fast.
    const double end = life * (cut * cut) / (static_cast<double>(cuts) * cuts), tau = end - start;
    Motion<double> next = flownBy(c.flight, m, tau);
    next.x = static_cast<float>(next.x);
    next.z = static_cast<float>(next.z);
    next.y = notUnder(ground.height(next.x, next.z) + heightAbove(end));
    // The height at the arc's end is linear in the vertical velocity at its beginning.
    const double unmoved = flownBy(c.flight, {0.0, m.y, 0.0, 0.0, 0.0, 0.0}, tau).y, per_speed = flownBy(c.flight, {0.0, m.y, 0.0, 0.0, 1.0, 0.0}, tau).y - unmoved;
    room.arcs[lane][room.last[lane]].vy = per_speed > 0.0 ? (next.y - unmoved) / per_speed : 0.0;
    if (cut == cuts) return;
    next.vx = floatTowardsZero(next.vx);
    next.vz = floatTowardsZero(next.vz);
    append(room, lane, end, next);
    m = next;
    start = end;
  }
}

}  // namespace npsee::explosion
