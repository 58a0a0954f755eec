#pragma once

#include <npsee/error.h>
#include <npsee/vec3.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::render {

/// What a facet's material says: its own colour, or one that follows from whose it is.
enum class Paint : std::uint8_t { plain, body, accent };

/// A part of a model that turns as one.
struct ModelPart {
  enum class Kind { hull, turret, tube } kind = Kind::hull;
  Vec3 pivot;                       ///< around which it turns, m
  Vec3 carrier;                     ///< the turret's pivot, for a tube that the turret carries
  std::size_t first = 0, count = 0; ///< its vertices
};

/// A vehicle's shape: metres, x right, y up, -z forward, standing on y = 0. Triangles, three vertices each, lit facet by facet.
struct Model {
  struct Vertex {
    std::array<float, 3> position, normal;
    std::array<float, 3> colour;    ///< sRGB-coded
    float paint = 0.0f;             ///< Paint
  };
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<ModelPart> parts;
  Vec3 low, high;                   ///< of all its corners
  double length_m = 1.0, height_m = 1.0;
  double hull_length_m = 1.0;       ///< without tubes
};

/// Reads a Wavefront OBJ. Objects named NAME@x,y,z turn around that point (turret, tube); materials called body and accent take
/// the side's colours. Error kind input.
Expected<Model> parseModel(std::string_view name, std::string_view obj, std::string_view mtl);

/// The shipped models, in the order of their names; `block` stands for anything seen very small.
Expected<std::vector<Model>> loadShippedModels();

}  // namespace npsee::render
