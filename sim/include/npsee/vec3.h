#pragma once

#include <cmath>

namespace npsee {

/// World vector: x east, y up, z south (right-handed), metres or metres per second.
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double s, const Vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }  ///< Scalar product.
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {  ///< Vector product, right-handed.
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }  ///< Euclidean length; no care is taken of overflow.

}  // namespace npsee
