#pragma once

#include <npsee/fragments.h>

#include <gtest/gtest.h>

#include <string>

namespace npsee::test {

/// A box as OBJ lines; `before` points stand above it in the file.
inline std::string boxObj(const Vec3& low, const Vec3& high, int before = 0) {
  std::string out;
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] : {std::pair(low.x, low.y), std::pair(high.x, low.y), std::pair(high.x, high.y), std::pair(low.x, high.y)})
      out += "v " + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
  for (const char* face : {"4321", "5678", "1265", "2376", "3487", "4158"}) {
    out += 'f';
    for (const char* corner = face; *corner != 0; ++corner) out += ' ' + std::to_string(*corner - '0' + before);
    out += '\n';
  }
  return out;
}

inline SolidModel modelOf(const std::string& obj, const std::string& mtl = {}) {
  auto model = parseSolidModel(obj, mtl, "test.obj");
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  return model ? *model : SolidModel{};
}

inline std::shared_ptr<const Fragments> cut(const SolidModel& model, std::int64_t count, double density, std::uint64_t seed = 1993) {
  auto pieces = cutToPieces(model, count, density, {seed, 7});
  EXPECT_TRUE(pieces) << (pieces ? "" : pieces.error().text());
  return pieces ? *pieces : std::make_shared<const Fragments>();
}

}  // namespace npsee::test
