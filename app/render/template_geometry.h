#pragma once

#include "sim/core/nurbs.h"

#include <npsee/preset.h>

#include <optional>
#include <string_view>

/// The template: the shape that encodes a layer's current settings (thesis, chapter IV.C.2), as geometry without GL.
///
/// It lives in a space of its own without unit: x east, y up, z south as in the world, base plane y = 0. The encoding, all of it
/// monotone and bounded so that every valid preset fits the view, with the saturating share q(x, c) = x / (x + c):
///
///   height  h = 0.25 + 0.95 q(speed_mean, 25 m/s)     Y-mag
///   foot    r = 0.2 + 0.35 q(region extent, 4 m)    per axis: region radius, or half the length along x and the width along z
///   scale   s = 0.6 + 0.4 q(size_mean, 0.5 m)       XZ-mag; multiplies the whole shape
///   lean    = min(ejection_angle, 90 deg)           angle between a side and the principal direction
///
/// Ground burst: a rational surface whose quadratic profile over knots 0 0 0 0.6 1 1 1 leaves the foot in the direction of the lean,
/// exactly straight for v <= 0.6, and then turns up to the rim at height h. Lean 0 is an upright cylinder, lean 90 deg a wide
/// dish. The corner of its control polygon lies where the side meets the ellipse with half-axes 1 (out) and 0.92 h (up), so
/// that the rim's distance from the foot is w = sin / sqrt((cos / 0.92 h)^2 + sin^2), growing with the lean to 1.
/// Regions that are not round scale the circle to an ellipse of their extents; its sections along x and z keep the exact lean.
/// A principal direction that is not upright turns the whole shape.
///
/// Air burst (a layer that throws equally in all directions): an exact sphere of radius 0.8 h s, above the base plane.
namespace npsee::render {

double templateHeight(double speed_mps);
double templateFoot(double extent_m);
double templateScale(double size_m);

/// Inverses. Values beyond what the encoding reaches give the parameter's own limits (0, or the table's maximum).
double speedOfTemplateHeight(double height);
double extentOfTemplateFoot(double foot);

/// Outward distance from foot to rim for a lean (rad, 0 to pi/2) and a height, before scaling, and its inverse.
double templateFlare(double lean_rad, double height);
double leanOfTemplateFlare(double flare, double height);

/// Places of the shape that a pointer can drag.
enum class TemplateHandle {
  none,
  rim,   ///< sets the ejection angle
  top,   ///< end of the axis; sets the mean speed
  foot,  ///< sets the size of the region
};

/// A layer's template. A plain value.
struct TemplateShape {
  bool ball = false;                ///< sphere of an air burst
  double scale = 1.0;               ///< s
  double height = 1.0;              ///< h, before scaling
  double foot_x = 0.5, foot_z = 0.5;  ///< r along x and z, before scaling
  double inner_foot = 0.0;          ///< of a ring's inner circle, before scaling; 0 = none
  double lean_rad = 0.0;
  Vec3 origin;                      ///< centre of the foot or of the sphere
  nurbs::Affine frame;              ///< shape space (y along the principal direction) to template space, scale included
  nurbs::Surface surface;           ///< in template space; u around, v from foot to rim
  std::string_view foot_key;        ///< parameter the foot handle sets; empty if the region has no extent

  /// Radius of the sphere, scaled.
  double ballRadius() const;

  /// Point of a handle. `azimuth_rad` counts from +x towards -z around the axis; the foot handle lies opposite the rim handle. A
  /// sphere has no rim handle and a foot without extent cannot be dragged: `none` of them is drawn, see hasHandle.
  Vec3 handle(TemplateHandle which, double azimuth_rad = 0.0) const;
  bool hasHandle(TemplateHandle which) const;

  /// Value (SI) of the parameter that puts the handle nearest to a point of template space, clamped to the parameter's range.
  double valueAt(TemplateHandle which, const Vec3& point, double azimuth_rad = 0.0) const;
};

/// Key of the layer parameter a handle sets ("ejection_angle", "speed_mean", "region.radius" or "region.length").
std::string_view parameterOf(TemplateHandle which, const TemplateShape& shape);

/// The template of one layer. `layer` must exist.
TemplateShape templateShape(const Preset& preset, int layer);

/// Bounds that hold for every valid preset: a cup lies in the cylinder of this radius and height upon its foot, a ball in the sphere
/// of this radius.
inline constexpr double kLargestCupRadius = 1.55, kLargestCupHeight = 1.2, kLargestBall = 0.96;

/// The middle of the largest shape of this kind: what a camera looks at.
Vec3 templateCentre(const TemplateShape& shape);

}  // namespace npsee::render
