#include <npsee/ground.h>

namespace npsee {

Vec3 Ground::normal(double x_m, double z_m) const {
  const double step = 0.05 * detail();
  const double east = (height(x_m + step, z_m) - height(x_m - step, z_m)) / (2.0 * step);
  const double south = (height(x_m, z_m + step) - height(x_m, z_m - step)) / (2.0 * step);
  return (1.0 / std::sqrt(east * east + 1.0 + south * south)) * Vec3{-east, 1.0, -south};
}

}  // namespace npsee
