#include "sim/core/elementary.h"
#include "sim/core/files.h"
#include "sim/core/text.h"
#include "sim/fragments/shipped_models.h"

#include <npsee/fragments.h>

#include <algorithm>
#include <system_error>

namespace npsee {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxMaterialFile = 1u << 20;
constexpr std::string_view kEnding = ".obj";

std::string_view textOf(std::string_view file) {
  for (const fragments::ShippedModel& model : fragments::shippedModelFiles())
    if (model.name == file) return model.text;
  return {};
}

bool namesAFile(const std::string& name) { return name.find_first_of("./\\") != std::string::npos; }

/// Name of the material library that an OBJ names; empty if none, or none beside it.
std::string materialFileOf(std::string_view obj) {
  for (std::size_t at = obj.find("mtllib "); at != std::string_view::npos; at = obj.find("mtllib ", at + 1)) {
    if (at > 0 && obj[at - 1] != '\n') continue;
    const std::size_t end = std::min(obj.find('\n', at), obj.size());
    std::string name(trimmed(obj.substr(at + 7, end - at - 7)));
    if (name.empty() || name.find_first_of(std::string_view("/\\\0", 3)) != std::string::npos || name == "..") return {};
    return name;
  }
  return {};
}

/// The material library that an OBJ names, if it lies beside it; colours only, so that a missing one is no fault.
std::string materialsBeside(const fs::path& file, std::string_view obj) {
  const std::string name = materialFileOf(obj);
  auto text = name.empty() ? std::string() : readTextFile(file.parent_path() / name, kMaxMaterialFile);
  return text ? std::move(*text) : std::string();
}

Expected<SolidModel> fromFile(const std::string& name, const fs::path& folder) {
  const fs::path path = folder / name;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const std::string shown = '"' + path.generic_string() + '"';
  if (status.type() == fs::file_type::not_found) return fail(ErrorKind::input, "there is no model file " + shown + ".", "Paths are relative to the preset file's folder; a shipped model is named without .obj.");
  if (!fs::is_regular_file(status)) return fail(ErrorKind::input, shown + " is not a regular file that can be read.", "Name an OBJ file.");
  const auto text = readTextFile(path, kMaxModelFile);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseSolidModel(*text, materialsBeside(path, *text), path.generic_string());
}

}  // namespace

std::vector<std::string_view> shippedModelNames() {
  std::vector<std::string_view> out;
  for (const fragments::ShippedModel& model : fragments::shippedModelFiles())
    if (model.name.ends_with(kEnding)) out.push_back(model.name.substr(0, model.name.size() - kEnding.size()));
  return out;
}

std::string wrongModelName(const std::string& name) {
  const std::string shown = "pieces.model is \"" + printable(name) + "\"";
  if (name.empty()) return "pieces.model is empty: there is nothing to come apart.";
  if (name.find('\0') != std::string::npos || name.find('\\') != std::string::npos) return shown + ", which is not a path with / between folders.";
  if (fs::path(name).is_absolute()) return shown + ", but a preset names files relative to its own folder; an absolute path is refused.";
  for (const fs::path& part : fs::path(name))
    if (part == "..") return shown + ", but a preset names files in its own folder or below; .. is refused.";
  if (namesAFile(name)) return {};
  const auto names = shippedModelNames();
  if (std::ranges::find(names, name) != names.end()) return {};
  const auto near = nearest(name, names);
  return shown + ", but there is no such shipped model" + (near ? "; did you mean " + std::string(*near) + "?" : ".");
}

Expected<SolidModel> findSolidModel(const std::string& name, const fs::path& folder) {
  if (std::string wrong = wrongModelName(name); !wrong.empty()) return fail(ErrorKind::input, std::move(wrong), "Name a shipped model, such as tank, or an OBJ file beside the preset.");
  if (namesAFile(name)) return fromFile(name, folder);
  return parseSolidModel(textOf(name + std::string(kEnding)), textOf("palette.mtl"), name);
}

std::vector<fs::path> modelFiles(const Preset& preset) {
  std::vector<fs::path> out;
  const auto add = [&out](fs::path file) {
    if (std::ranges::find(out, file) == out.end()) out.push_back(std::move(file));
  };
  for (const Layer& layer : preset.layers) {
    if (layer.form != Form::pieces || !namesAFile(layer.pieces_model) || !wrongModelName(layer.pieces_model).empty()) continue;
    const fs::path model = layer.pieces_model;
    add(model);
    const auto text = readTextFile(preset.folder.path / model, kMaxModelFile);
    if (const std::string materials = text ? materialFileOf(*text) : std::string(); !materials.empty()) add(model.parent_path() / materials);
  }
  return out;
}

std::string modelTexts(const Preset& preset) {
  std::string out;
  for (const fs::path& file : modelFiles(preset))
    if (const auto text = readTextFile(preset.folder.path / file, kMaxModelFile)) out += *text;
  return out;
}

SolidModel placedModel(SolidModel model, double scale, double heading_rad) {
  double sine = 0.0, cosine = 1.0;
  sineCosine(heading_rad, sine, cosine);
  for (Solid& shell : model.shells)
    for (Vec3& p : shell.points) p = scale * Vec3{cosine * p.x - sine * p.z, p.y, sine * p.x + cosine * p.z};
  return model;
}

}  // namespace npsee
