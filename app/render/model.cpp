#include "app/render/model.h"

#include "sim/fragments/shipped_models.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace npsee::render {
namespace {

ModelPart partOf(const std::string& name) {
  ModelPart part;
  if (name.starts_with("turret")) part.kind = ModelPart::Kind::turret;
  if (name.starts_with("tube")) part.kind = ModelPart::Kind::tube;
  const std::size_t at = name.find('@');
  if (at == std::string::npos) return part;
  const char* text = name.c_str() + at + 1;
  double* const values[] = {&part.pivot.x, &part.pivot.y, &part.pivot.z};
  for (double* value : values) {
    char* end = nullptr;
    *value = std::strtod(text, &end);
    text = *end == ',' ? end + 1 : end;
  }
  return part;
}

void addFacet(Model& model, const tinyobj::attrib_t& attributes, const tinyobj::index_t* corners, const tinyobj::material_t* material) {
  Vec3 points[3];
  for (int i = 0; i < 3; ++i) {
    const auto at = 3 * static_cast<std::size_t>(corners[i].vertex_index);
    points[i] = {static_cast<double>(attributes.vertices[at]), static_cast<double>(attributes.vertices[at + 1]), static_cast<double>(attributes.vertices[at + 2])};
  }
  const Vec3 across = cross(points[1] - points[0], points[2] - points[0]);
  const double size = length(across);
  if (size < 1e-12) return;
  const auto f = [](double v) { return static_cast<float>(v); };
  Model::Vertex vertex;
  vertex.normal = {f(across.x / size), f(across.y / size), f(across.z / size)};
  vertex.colour = {0.5f, 0.5f, 0.5f};
  if (material != nullptr) {
    vertex.colour = {f(static_cast<double>(material->diffuse[0])), f(static_cast<double>(material->diffuse[1])), f(static_cast<double>(material->diffuse[2]))};
    vertex.paint = material->name == "body" ? 1.0f : material->name == "accent" ? 2.0f : 0.0f;
  }
  for (const Vec3& point : points) {
    vertex.position = {f(point.x), f(point.y), f(point.z)};
    model.vertices.push_back(vertex);
  }
}

void measure(Model& model) {
  model.low = {1e9, 1e9, 1e9};
  model.high = {-1e9, -1e9, -1e9};
  for (const Model::Vertex& vertex : model.vertices) {
    const Vec3 p{static_cast<double>(vertex.position[0]), static_cast<double>(vertex.position[1]), static_cast<double>(vertex.position[2])};
    model.low = {std::min(model.low.x, p.x), std::min(model.low.y, p.y), std::min(model.low.z, p.z)};
    model.high = {std::max(model.high.x, p.x), std::max(model.high.y, p.y), std::max(model.high.z, p.z)};
  }
  model.length_m = std::max(model.high.z - model.low.z, model.high.x - model.low.x);
  model.height_m = model.high.y - model.low.y;
  double front = 1e9, rear = -1e9;
  for (const ModelPart& part : model.parts)
    for (std::size_t i = part.first; part.kind == ModelPart::Kind::hull && i < part.first + part.count; ++i) {
      front = std::min(front, static_cast<double>(model.vertices[i].position[2]));
      rear = std::max(rear, static_cast<double>(model.vertices[i].position[2]));
    }
  model.hull_length_m = std::max(rear - front, 0.1);
}

}  // namespace

Expected<Model> parseModel(std::string_view name, std::string_view obj, std::string_view mtl) {
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(std::string(obj), std::string(mtl), config))
    return fail(ErrorKind::input, "the model " + std::string(name) + " cannot be read: " + reader.Error(), "Write it as Wavefront OBJ with v, o, usemtl and f lines.");
  Model model;
  model.name = name;
  const auto& materials = reader.GetMaterials();
  const std::size_t known = reader.GetAttrib().vertices.size() / 3;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    ModelPart part = partOf(shape.name);
    part.first = model.vertices.size();
    for (const ModelPart& earlier : model.parts)
      if (earlier.kind == ModelPart::Kind::turret) part.carrier = earlier.pivot;
    for (std::size_t face = 0; 3 * face + 2 < shape.mesh.indices.size(); ++face) {
      const tinyobj::index_t* corners = &shape.mesh.indices[3 * face];
      if (std::any_of(corners, corners + 3, [&](const tinyobj::index_t& c) { return c.vertex_index < 0 || static_cast<std::size_t>(c.vertex_index) >= known; })) continue;
      const int material = shape.mesh.material_ids[face];
      addFacet(model, reader.GetAttrib(), corners, material >= 0 ? &materials[static_cast<std::size_t>(material)] : nullptr);
    }
    part.count = model.vertices.size() - part.first;
    if (part.count > 0) model.parts.push_back(part);
  }
  if (model.vertices.empty()) return fail(ErrorKind::input, "the model " + std::string(name) + " has no facets.", "Add faces (lines that begin with f).");
  measure(model);
  return model;
}

Expected<std::vector<Model>> loadShippedModels() {
  std::string_view palette;
  for (const fragments::ShippedModel& asset : fragments::shippedModelFiles())
    if (asset.name == "palette.mtl") palette = asset.text;
  std::vector<Model> out;
  for (const fragments::ShippedModel& asset : fragments::shippedModelFiles()) {
    if (!asset.name.ends_with(".obj")) continue;
    auto model = parseModel(asset.name.substr(0, asset.name.size() - 4), asset.text, palette);
    if (!model) return tl::unexpected<Error>(model.error());
    out.push_back(std::move(*model));
  }
  return out;
}

}  // namespace npsee::render
