#pragma once

#include "app/render/template_geometry.h"

#include <array>

namespace npsee::render {

/// The view of a template: a perspective camera around the middle of the largest shape of its kind, at the distance where that one
/// fills the picture. The shape's own size does not move it, so that a larger shape also looks larger.
class TemplateCamera {
 public:
  /// Size in pixels. Yaw 0 looks north (from +z), growing to the east of it; pitch is the height over the base plane. With handles
  /// on a side of the picture that is dragged, `azimuth()` is where the rim handle lies.
  TemplateCamera(const TemplateShape& shape, double yaw_rad, double pitch_rad, int width, int height);

  struct Pixel {
    double x = 0.0, y = 0.0;  ///< pixels from the upper left corner of the picture
    double distance = 0.0;    ///< from the eye along the view, template units
  };
  Pixel project(const Vec3& point) const;

  /// Azimuth around the shape's axis that lies furthest to the side in this view; the rim handle's place.
  double azimuth() const { return azimuth_; }

  /// The handle whose picture lies within `reach` pixels of a pointer, the nearest first; `none` if there is none.
  TemplateHandle handleNear(const TemplateShape& shape, double x, double y, double reach = 9.0) const;

  /// Value (SI) of the handle's parameter that brings the handle nearest to the pointer in the picture. Works in every view, also
  /// where the handle's path is seen end on.
  double dragged(const TemplateShape& shape, TemplateHandle which, double x, double y) const;

  const Vec3& eye() const { return eye_; }
  const Vec3& forward() const { return forward_; }
  /// Direction towards the lamp, which stands over the viewer's left shoulder.
  Vec3 lamp() const;
  /// Template space to clip space, column by column.
  std::array<float, 16> viewProjection() const;

 private:
  /// Distance from which the largest cup in this direction just fits; half_x and half_y are tangents of half the view's angles.
  double cupDistance(const TemplateShape& shape, double half_x, double half_y) const;

  Vec3 eye_, right_, up_, forward_;
  double width_ = 1.0, height_ = 1.0, focal_ = 1.0, near_ = 0.1, far_ = 10.0, azimuth_ = 0.0;
};

}  // namespace npsee::render
