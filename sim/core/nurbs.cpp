#include "sim/core/nurbs.h"

#include <unsupported/Eigen/Splines>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace npsee::nurbs {
namespace {

using EigenSpline = Eigen::Spline<double, 1, Eigen::Dynamic>;

/// Homogeneous coordinates (w P, w).
struct Homogeneous {
  Vec3 p;
  double w = 0.0;

  void add(double factor, const ControlPoint& point) {
    const double weight = factor * point.weight;
    p = p + weight * point.position;
    w += weight;
  }
};

void check(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("NURBS: ") + what);
}

void checkKnots(const KnotVector& k) {
  check(k.degree >= 1, "the degree is below 1");
  check(k.points() >= k.degree + 1, "there are too few knots for the degree");
  check(std::ranges::all_of(k.knots, [](double knot) { return std::isfinite(knot); }), "a knot is not finite");
  check(std::ranges::is_sorted(k.knots), "the knots decrease");
  check(k.knots[k.degree] == k.first() && k.knots[k.points()] == k.last(), "the knots are not clamped");
  check(k.first() < k.last(), "the knots span nothing");
  for (std::size_t i = 1; i + k.degree + 1 < k.knots.size(); ++i) check(k.knots[i] < k.knots[i + k.degree], "an inner knot is repeated more often than the degree");
}

void checkPoints(const std::vector<ControlPoint>& points) {
  for (const ControlPoint& point : points) {
    check(std::isfinite(point.weight) && point.weight > 0.0, "a weight is not above 0");
    check(std::isfinite(dot(point.position, point.position)), "a control point is not finite");
  }
}

/// Zero stays zero: a surface shrunk to a point has no normal, and must not have NaN.
Vec3 unit(const Vec3& v) {
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : Vec3{};
}

/// A tangent this much shorter than the other counts as zero (a pole); rounding leaves about 1e-16.
constexpr double kDegenerate = 1e-9;

/// Unit normal from the tangents. At a pole one tangent is zero, and so is du x dv; next to it du = duv * (v - pole), so the
/// direction is that of +-(duv x dv), the sign by the side of the pole the surface lies on. Likewise for dv.
Vec3 normalFrom(const Vec3& du, const Vec3& dv, const Vec3& duv, double side_u, double side_v) {
  const double u = length(du), v = length(dv);
  if (u <= kDegenerate * v) return unit(side_v * cross(duv, dv));
  if (v <= kDegenerate * u) return unit(side_u * cross(du, duv));
  return unit(cross(du, dv));
}

constexpr double kHalfRoot2 = 0.70710678118654752440;

}  // namespace

Basis basisAt(const KnotVector& knots, double u) {
  const double inside = std::clamp(u, knots.first(), knots.last());
  const Eigen::Map<const EigenSpline::KnotVectorType> map(knots.knots.data(), static_cast<Eigen::Index>(knots.knots.size()));
  const EigenSpline::KnotVectorType copy = map;
  const auto values = EigenSpline::BasisFunctionDerivatives(inside, 1, knots.degree, copy);
  Basis out;
  out.first = static_cast<int>(EigenSpline::Span(inside, knots.degree, copy)) - knots.degree;
  for (int i = 0; i <= knots.degree; ++i) {
    out.value.push_back(values(0, i));
    out.derivative.push_back(values(1, i));
  }
  return out;
}

KnotVector uniformKnots(int degree, int points) {
  check(degree >= 1 && points > degree, "there are too few points for the degree");
  KnotVector out{degree, {}};
  const int spans = points - degree;
  for (int i = 0; i < points + degree + 1; ++i) out.knots.push_back(static_cast<double>(std::clamp(i - degree, 0, spans)) / spans);
  return out;
}

Curve::Curve(KnotVector knots, std::vector<ControlPoint> points) : knots_(std::move(knots)), points_(std::move(points)) {
  checkKnots(knots_);
  check(static_cast<int>(points_.size()) == knots_.points(), "the number of control points does not fit the knots");
  checkPoints(points_);
}

CurveSample Curve::at(double u) const {
  const Basis basis = basisAt(knots_, u);
  Homogeneous value, derivative;
  for (std::size_t i = 0; i < basis.value.size(); ++i) {
    const ControlPoint& point = points_[basis.first + i];
    value.add(basis.value[i], point);
    derivative.add(basis.derivative[i], point);
  }
  const Vec3 at = (1.0 / value.w) * value.p;
  return {at, (1.0 / value.w) * (derivative.p - derivative.w * at)};
}

Surface::Surface(KnotVector u, KnotVector v, std::vector<ControlPoint> net) : u_(std::move(u)), v_(std::move(v)), net_(std::move(net)) {
  checkKnots(u_);
  checkKnots(v_);
  check(static_cast<int>(net_.size()) == u_.points() * v_.points(), "the number of control points does not fit the knots");
  checkPoints(net_);
}

SurfaceSample Surface::sample(const Basis& along_u, const Basis& along_v) const {
  Homogeneous s, su, sv, suv;
  for (std::size_t j = 0; j < along_v.value.size(); ++j)
    for (std::size_t i = 0; i < along_u.value.size(); ++i) {
      const ControlPoint& point = control(along_u.first + static_cast<int>(i), along_v.first + static_cast<int>(j));
      s.add(along_u.value[i] * along_v.value[j], point);
      su.add(along_u.derivative[i] * along_v.value[j], point);
      sv.add(along_u.value[i] * along_v.derivative[j], point);
      suv.add(along_u.derivative[i] * along_v.derivative[j], point);
    }
  const double inverse = 1.0 / s.w;
  SurfaceSample out;
  out.point = inverse * s.p;
  out.du = inverse * (su.p - su.w * out.point);
  out.dv = inverse * (sv.p - sv.w * out.point);
  const Vec3 duv = inverse * (suv.p - suv.w * out.point - su.w * out.dv - sv.w * out.du);
  // A pole at the end of the domain is reached from below, where the distance to it is negative.
  const bool at_end_u = along_u.value.back() == 1.0, at_end_v = along_v.value.back() == 1.0;
  out.normal = normalFrom(out.du, out.dv, duv, at_end_u ? -1.0 : 1.0, at_end_v ? -1.0 : 1.0);
  return out;
}

SurfaceSample Surface::at(double u, double v) const { return sample(basisAt(u_, u), basisAt(v_, v)); }

std::vector<SurfaceSample> Surface::grid(const std::vector<double>& us, const std::vector<double>& vs) const {
  std::vector<Basis> along_u;
  along_u.reserve(us.size());
  for (const double u : us) along_u.push_back(basisAt(u_, u));
  std::vector<SurfaceSample> out;
  out.reserve(us.size() * vs.size());
  for (const double v : vs) {
    const Basis along_v = basisAt(v_, v);
    for (const Basis& basis : along_u) out.push_back(sample(basis, along_v));
  }
  return out;
}

Surface Surface::mapped(const Affine& map) const {
  std::vector<ControlPoint> net = net_;
  for (ControlPoint& point : net) point.position = map(point.position);
  return Surface(u_, v_, std::move(net));
}

Curve unitCircle() {
  const double h = kHalfRoot2;
  return Curve({2, {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}},
               {{{1, 0, 0}, 1}, {{1, 0, -1}, h}, {{0, 0, -1}, 1}, {{-1, 0, -1}, h}, {{-1, 0, 0}, 1}, {{-1, 0, 1}, h}, {{0, 0, 1}, 1}, {{1, 0, 1}, h}, {{1, 0, 0}, 1}});
}

Curve unitCircleOfSeven() {
  // Corners of the triangle around the circle carry weight cos(60 deg), the points of contact weight 1.
  const double c = std::sqrt(3.0) / 2.0, t = std::sqrt(3.0);
  return Curve({2, {0, 0, 0, 1.0 / 3, 1.0 / 3, 2.0 / 3, 2.0 / 3, 1, 1, 1}},
               {{{1, 0, 0}, 1}, {{1, 0, -t}, 0.5}, {{-0.5, 0, -c}, 1}, {{-2, 0, 0}, 0.5}, {{-0.5, 0, c}, 1}, {{1, 0, t}, 0.5}, {{1, 0, 0}, 1}});
}

Surface ringSurface(const KnotVector& profile, const std::vector<Ring>& rings) {
  const Curve circle = unitCircle();
  std::vector<ControlPoint> net;
  for (const Ring& ring : rings)
    for (const ControlPoint& point : circle.points())
      net.push_back({{ring.radius_x * point.position.x, ring.y, ring.radius_z * point.position.z}, ring.weight * point.weight});
  return Surface(circle.knots(), profile, std::move(net));
}

Surface revolved(const Curve& profile) {
  std::vector<Ring> rings;
  for (const ControlPoint& point : profile.points()) rings.push_back({point.position.x, point.position.x, point.position.y, point.weight});
  return ringSurface(profile.knots(), rings);
}

Surface sphere(const Vec3& centre, double radius) {
  const double h = kHalfRoot2;
  const Surface unit_sphere = revolved(Curve({2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}}, {{{0, -1, 0}, 1}, {{1, -1, 0}, h}, {{1, 0, 0}, 1}, {{1, 1, 0}, h}, {{0, 1, 0}, 1}}));
  return unit_sphere.mapped({{radius, 0, 0}, {0, radius, 0}, {0, 0, radius}, centre});
}

}  // namespace npsee::nurbs
