#pragma once

#include <npsee/vec3.h>

#include <vector>

/// Non-uniform rational B-splines (NURBS): curves, tensor-product surfaces, and the exact circles, spheres and surfaces of
/// revolution that only the rational form can hold.
///
/// A point of a curve is C(u) = sum N_i(u) w_i P_i / sum N_i(u) w_i, that of a surface
/// S(u, v) = sum N_i(u) M_j(v) w_ij P_ij / sum N_i(u) M_j(v) w_ij, with basis functions N, M of the knot vectors. Sums are
/// formed in homogeneous coordinates (w P, w) and divided once. Source: Piegl and Tiller, The NURBS Book, 2nd ed., chapters
/// 2 to 4 and 7 (circles: section 7.5, surfaces of revolution: section 8.5). Basis functions by Eigen's spline module.
namespace npsee::nurbs {

struct ControlPoint {
  Vec3 position;
  double weight = 1.0;  ///< above 0
  friend bool operator==(const ControlPoint&, const ControlPoint&) = default;
};

/// Degree and knots of one parameter direction. Parameters run from the first knot to the last; values outside are clamped.
struct KnotVector {
  int degree = 1;
  std::vector<double> knots;  ///< not decreasing; the first and the last degree + 1 are equal ("clamped")

  /// Number of control points that go with it.
  int points() const { return static_cast<int>(knots.size()) - degree - 1; }
  double first() const { return knots.front(); }
  double last() const { return knots.back(); }
  friend bool operator==(const KnotVector&, const KnotVector&) = default;
};

/// The degree + 1 basis functions that are not zero at u, and their first derivatives; `first` is the index of the first.
struct Basis {
  int first = 0;
  std::vector<double> value, derivative;
};
Basis basisAt(const KnotVector& knots, double u);

/// Clamped knot vector over 0..1 whose inner knots divide it evenly.
KnotVector uniformKnots(int degree, int points);

struct CurveSample {
  Vec3 point, derivative;
};

class Curve {
 public:
  /// Throws std::invalid_argument when knots, points and weights do not fit together: a mistake of the program.
  Curve(KnotVector knots, std::vector<ControlPoint> points);

  CurveSample at(double u) const;
  const KnotVector& knots() const { return knots_; }
  const std::vector<ControlPoint>& points() const { return points_; }

 private:
  KnotVector knots_;
  std::vector<ControlPoint> points_;
};

/// `map(p) = x p.x + y p.y + z p.z + origin`.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;
  Vec3 operator()(const Vec3& p) const { return p.x * x + p.y * y + p.z * z + origin; }
};

struct SurfaceSample {
  Vec3 point, du, dv;
  Vec3 normal;  ///< unit; du x dv, and its limit where a row of control points falls together, as at a sphere's poles; zero where there is none
};

class Surface {
 public:
  /// `net` holds u.points() * v.points() control points, u running fastest. Throws std::invalid_argument when knots, net and
  /// weights do not fit together.
  Surface(KnotVector u, KnotVector v, std::vector<ControlPoint> net);

  SurfaceSample at(double u, double v) const;
  /// Samples at every pair of the given parameters, u running fastest. Basis functions are computed once per row and column.
  std::vector<SurfaceSample> grid(const std::vector<double>& us, const std::vector<double>& vs) const;

  /// The same surface mapped: NURBS keep their form under affine maps of their control points.
  Surface mapped(const Affine& map) const;

  const KnotVector& u() const { return u_; }
  const KnotVector& v() const { return v_; }
  const ControlPoint& control(int i, int j) const { return net_[static_cast<std::size_t>(j) * u_.points() + i]; }
  const std::vector<ControlPoint>& net() const { return net_; }

 private:
  SurfaceSample sample(const Basis& along_u, const Basis& along_v) const;

  KnotVector u_, v_;
  std::vector<ControlPoint> net_;
};

/// The exact unit circle in the x-z plane about the origin: 9 control points, quadratic, from +x towards -z (counter-clockwise
/// seen from above), u = 0..1 with a quarter each at u = 1/4, 1/2, 3/4.
Curve unitCircle();

/// The same circle with 7 control points on an equilateral triangle (knots at thirds).
Curve unitCircleOfSeven();

/// An ellipse about the y axis: what one control point of a profile becomes when it is carried around.
struct Ring {
  double radius_x = 1.0, radius_z = 1.0, y = 0.0, weight = 1.0;
};

/// Tensor product of the exact circle (u) with a profile (v) given ring by ring. With radius_x = radius_z it is an exact surface of
/// revolution. Normals point outward where the profile runs upward.
Surface ringSurface(const KnotVector& profile, const std::vector<Ring>& rings);

/// The profile (radius = x >= 0, height = y; z is not used) turned about the y axis.
Surface revolved(const Curve& profile);

/// The exact sphere, poles on the y axis; v runs from the lower pole to the upper.
Surface sphere(const Vec3& centre, double radius);

}  // namespace npsee::nurbs
