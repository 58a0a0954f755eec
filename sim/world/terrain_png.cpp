#include "sim/world/terrain_grid.h"

#include "sim/core/files.h"
#include "sim/core/json_text.h"
#include "sim/core/png_glue.h"
#include "sim/core/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

// ---- the picture

struct Picture {
  int columns = 0, rows = 0;
  std::vector<unsigned char> bytes;  ///< big-endian greys
};

/// The part between setjmp and longjmp: only plain data of the caller lives across it.
bool decode(png_structp png, png_infop info, Picture& picture, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_chunk_malloc_max(png, 8'000'000);
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  if (png_get_color_type(png, info) != PNG_COLOR_TYPE_GRAY || png_get_bit_depth(png, info) != 16) png_error(png, "it is not a 16-bit grey picture");
  if (width < 2 || height < 2) png_error(png, "it has less than 2 x 2 samples");
  if (static_cast<std::size_t>(width) * height > Terrain::kMaxSamples) png_error(png, "it has more than 67108864 samples");
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  picture.columns = static_cast<int>(width);
  picture.rows = static_cast<int>(height);
  picture.bytes.resize(static_cast<std::size_t>(width) * height * 2);
  for (std::size_t r = 0; r < height; ++r) rows.push_back(picture.bytes.data() + r * width * 2);
  png_read_image(png, rows.data());
  png_read_end(png, nullptr);
  return true;
}

tl::unexpected<Error> noTerrain(const std::filesystem::path& file, const std::string& why) {
  return fail(ErrorKind::input, {.what = "is no terrain that can be read: " + why + ".", .remedy = "Save the heights as a 16-bit grey PNG.", .file = file.string(), .line = 0, .pointer = {}});
}

Expected<Picture> readPicture(const std::filesystem::path& file) {
  const auto text = readTextFile(file, Terrain::kMaxSamples * 3);
  if (!text) return tl::unexpected<Error>(text.error());
  if (!png_glue::isPng(*text)) return noTerrain(file, "it is not a PNG file");
  const png_glue::Reading reading(*text);
  Picture picture;
  std::vector<png_bytep> rows;
  if (!reading || !decode(reading.png(), reading.info(), picture, rows)) return noTerrain(file, reading.complaint());
  return picture;
}

// ---- the sidecar

struct Sidecar {
  double cell_m = 0.0, offset_m = 0.0, scale_m = 0.0;
};

constexpr std::string_view kExample = R"(Write e.g. {"cell_m": 30, "height_min_m": 0, "height_max_m": 400}.)";

Expected<Sidecar> sidecarFrom(const JsonText& json) {
  const std::vector<std::string_view> known{"cell_m", "height_min_m", "height_max_m", "scale_m", "offset_m"};
  std::map<std::string, double, std::less<>> values;
  Error error;
  if (!json.root().is_object()) return fail(ErrorKind::input, json.fault("", "is not an object of settings.", std::string(kExample)));
  for (const auto& [key, value] : json.root().items()) {
    const std::string pointer = "/" + pointerToken(key);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      const auto close = nearest(key, known);
      error.faults.push_back(json.fault(pointer, "is no setting of a terrain picture.", close ? "Did you mean " + std::string(*close) + "?" : "It has " + listed(known) + "."));
    } else if (!value.is_number() || !(std::fabs(value.get<double>()) <= Terrain::kMaxSize_m)) {
      error.faults.push_back(json.fault(pointer, "must be a number within " + shown(Terrain::kMaxSize_m) + " of 0.", std::string(kExample)));
    } else {
      values[key] = value.get<double>();
    }
  }
  if (!error.faults.empty()) return tl::unexpected<Error>(std::move(error));

  const auto has = [&](std::string_view key) { return values.find(key) != values.end(); };
  const bool by_ends = has("height_min_m") && has("height_max_m") && !has("scale_m") && !has("offset_m");
  const bool by_scale = has("scale_m") && has("offset_m") && !has("height_min_m") && !has("height_max_m");
  if (!has("cell_m")) error.faults.push_back(json.fault("", "lacks cell_m, the distance of the samples in metres.", std::string(kExample)));
  else if (!(values["cell_m"] > 0.0)) error.faults.push_back(json.fault("/cell_m", "is " + shown(values["cell_m"]) + " m; it must be above 0.", std::string(kExample)));
  if (!by_ends && !by_scale) error.faults.push_back(json.fault("", "must give either height_min_m and height_max_m, or scale_m and offset_m.", std::string(kExample)));
  if (!error.faults.empty()) return tl::unexpected<Error>(std::move(error));
  if (by_scale) return Sidecar{values["cell_m"], values["offset_m"], values["scale_m"]};
  return Sidecar{values["cell_m"], values["height_min_m"], (values["height_max_m"] - values["height_min_m"]) / 65535.0};
}

Expected<Sidecar> readSidecar(const std::filesystem::path& file) {
  const std::filesystem::path path = file.string() + ".json";
  const auto text = readTextFile(path, 1u << 16);
  if (!text) {
    Error error = text.error();
    error.faults.front().remedy = "A terrain picture needs this file beside it. " + std::string(kExample);
    return tl::unexpected<Error>(std::move(error));
  }
  const auto json = JsonText::parse(*text, path.string());
  if (!json) return tl::unexpected<Error>(json.error());
  auto sidecar = sidecarFrom(*json);
  if (!sidecar) return sidecar;
  const double black = sidecar->offset_m, white = black + 65535.0 * sidecar->scale_m;
  if (std::max(std::fabs(black), std::fabs(white)) > Terrain::kMaxHeight_m)
    return fail(ErrorKind::input, json->fault("", "gives heights from " + shown(black) + " to " + shown(white) + " m, beyond the limit of " + shown(Terrain::kMaxHeight_m) + " m.", "Lower them."));
  return sidecar;
}

}  // namespace

Expected<Tile> readHeightPng(const TerrainSource& source) {
  const auto picture = readPicture(source.file);
  if (!picture) return tl::unexpected<Error>(picture.error());
  const auto sidecar = readSidecar(source.file);
  if (!sidecar) return tl::unexpected<Error>(sidecar.error());
  Tile tile{picture->columns, picture->rows, sidecar->cell_m, {}};
  tile.heights.reserve(picture->bytes.size() / 2);
  for (std::size_t i = 0; i < picture->bytes.size(); i += 2) {
    const int grey = picture->bytes[i] << 8 | picture->bytes[i + 1];
    tile.heights.push_back(static_cast<float>(sidecar->offset_m + sidecar->scale_m * grey));
  }
  return tile;
}

}  // namespace npsee::world
