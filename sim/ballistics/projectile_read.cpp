#include "sim/ballistics/json_fields.h"
#include "sim/ballistics/projectile_rows.h"

#include "sim/core/file_kind.h"
#include "sim/core/files.h"
#include "sim/core/text.h"

#include <npsee/units.h>

#include <nlohmann/json.hpp>

namespace npsee {
namespace ballistics {
namespace {

constexpr int kProjectileVersion = 1;

class Reader {
 public:
  explicit Reader(const JsonText& json) : fields(json) {}

  Fields fields;
  Projectile projectile;

  void run() {
    if (!fields.object("", {"npsee_projectile", "name", "title", "status", "note", "constants", "coefficients", "charges", "sources"})) return;
    version();
    projectile.name = fields.text("/name", true);
    projectile.title = fields.text("/title");
    projectile.status = fields.text("/status", true);
    projectile.note = fields.text("/note");
    sources();
    constants();
    coefficients();
    charges();
  }

 private:
  void version() {
    const auto version = fields.number("/npsee_projectile");
    if (version && *version != kProjectileVersion)
      fields.fault("/npsee_projectile", "the file has version " + shortest(*version) + ", but this program reads version " + std::to_string(kProjectileVersion) + ".", "Use a newer npsee.");
  }

  void sources() {
    if (!fields.has("/sources")) return;
    if (!fields.at("/sources").is_object()) return fields.fault("/sources", "this must be an object of key and reference.");
    for (const auto& [key, value] : fields.at("/sources").items()) projectile.sources.emplace_back(key, fields.text("/sources/" + pointerToken(key)));
  }

  /// The source of a value: the keys it begins with, joined by commas, must be in "sources".
  std::string source(const std::string& pointer) {
    std::string text = fields.text(pointer, true);
    for (const std::string_view part : splitAt(text, ',')) {
      const std::string_view key = trimmed(part);
      std::vector<std::string_view> known;
      bool found = key.empty();
      for (const auto& [name, reference] : projectile.sources) {
        found = found || name == key;
        known.push_back(name);
      }
      if (found) continue;
      const auto near = nearest(key, known);
      fields.fault(pointer, "\"" + std::string(key) + "\" is not among the file's sources.", near ? "Did you mean " + std::string(*near) + "?" : "Add it to \"sources\".");
    }
    return text;
  }

  void constants() {
    std::vector<std::string_view> keys;
    for (const ConstantRow& row : constantRows()) keys.push_back(row.key);
    if (!fields.object("/constants", keys)) return;
    for (std::size_t i = 0; i < constantRows().size(); ++i) {
      const ConstantRow& row = constantRows()[i];
      const std::string at = "/constants/" + std::string(row.key);
      if (!fields.object(at, {"value", "unit", "source", "note"}, row.required)) continue;
      projectile.constant_sources[i] = source(at + "/source");
      const auto value = fields.number(at + "/value");
      const std::string unit = fields.text(at + "/unit", true);
      if (!value || unit.empty()) continue;
      const auto factor = unitFactor(row, unit);
      if (factor) projectile.*row.member = *value * *factor;
      else fields.fault(at + "/unit", unknownUnit(row, unit), "Convert the value.");
    }
  }

  void coefficients() {
    std::vector<std::string_view> keys;
    for (std::size_t c = 0; c < kCoefficients; ++c) keys.push_back(coefficientKey(static_cast<Coefficient>(c)));
    if (!fields.object("/coefficients", keys)) return;
    for (std::size_t c = 0; c < kCoefficients; ++c) {
      const std::string at = "/coefficients/" + std::string(keys[c]);
      if (fields.object(at, {"mach", "value", "interpolation", "polynomial", "source", "note"}, static_cast<Coefficient>(c) == Coefficient::cd0)) curve(at, projectile.aero[c]);
    }
  }

  void curve(const std::string& at, CoefficientCurve& curve) {
    curve.source = source(at + "/source");
    if (fields.has(at + "/polynomial")) {
      const std::size_t count = fields.list(at + "/polynomial");
      for (std::size_t i = 0; i < count; ++i) {
        const std::string piece = at + "/polynomial/" + std::to_string(i);
        if (!fields.object(piece, {"mach_to", "a"})) continue;
        curve.pieces.push_back({fields.number(piece + "/mach_to").value_or(0.0), fields.numbers(piece + "/a")});
      }
    }
    if (curve.pieces.empty() || fields.has(at + "/mach")) {
      curve.mach = fields.numbers(at + "/mach");
      curve.value = fields.numbers(at + "/value");
    }
    const std::string interpolation = fields.text(at + "/interpolation");
    if (interpolation == "linear") curve.interpolation = Interpolation::linear;
    else if (!interpolation.empty() && interpolation != "monotone") fields.fault(at + "/interpolation", "there is no interpolation \"" + interpolation + "\".", "It is linear or monotone.");
    if (fields.faults.empty() && curve.empty()) fields.fault(at, "the curve has no points.", "Leave an unknown coefficient out.");
  }

  void charges() {
    const std::size_t count = fields.list("/charges");
    for (std::size_t i = 0; i < count && i < kMaxCharges + 1; ++i) {
      const std::string at = "/charges/" + std::to_string(i);
      if (!fields.object(at, {"name", "muzzle_velocity", "unit", "status", "source", "factors"})) continue;
      Charge charge;
      charge.name = fields.text(at + "/name", true);
      charge.status = fields.text(at + "/status");
      charge.source = source(at + "/source");
      charge.speed_mps = fields.number(at + "/muzzle_velocity").value_or(0.0);
      const std::string unit = fields.text(at + "/unit", true);
      if (unit == "ft/s") charge.speed_mps *= 0.3048;
      else if (!unit.empty() && unit != "m/s") fields.fault(at + "/unit", "\"" + unit + "\" is not a unit of a muzzle velocity; units are m/s and ft/s.", "Convert the value.");
      if (fields.has(at + "/factors")) factors(at + "/factors", charge.factors);
      projectile.charges.push_back(std::move(charge));
    }
  }

  void factors(const std::string& at, FactorCurves& factors) {
    std::vector<std::string_view> keys{"elevation_mil", "source"};
    for (const FactorRow& row : factorRows()) keys.push_back(row.key);
    if (!fields.object(at, keys)) return;
    factors.source = source(at + "/source");
    const std::vector<double> range = fields.numbers(at + "/elevation_mil");
    if (range.size() == 2) {
      factors.elevation_min_rad = toSi(Unit::mil, range[0]);
      factors.elevation_max_rad = toSi(Unit::mil, range[1]);
    } else {
      fields.fault(at + "/elevation_mil", "this must be two numbers, the least and the greatest elevation that was fitted.");
    }
    for (const FactorRow& row : factorRows()) factors.*row.curve = fields.numbers(at + '/' + std::string(row.key), false);
  }
};

}  // namespace
}  // namespace ballistics

using namespace ballistics;

namespace {

Expected<Projectile> parse(std::string_view text, std::string_view file) {
  auto json = JsonText::parse(text, file);
  if (!json) return tl::unexpected<Error>(json.error());
  Reader reader(*json);
  reader.run();
  if (reader.fields.faults.empty())
    for (Fault& fault : validate(reader.projectile)) reader.fields.fault(fault.pointer, std::move(fault.what), std::move(fault.remedy));
  if (!reader.fields.faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(reader.fields.faults)});
  return std::move(reader.projectile);
}

}  // namespace

Expected<Projectile> parseProjectile(std::string_view text, std::string_view file) {
  return readAs(FileKind::projectile, text, file, parse(text, file));
}

Expected<Projectile> loadProjectile(const std::filesystem::path& path) {
  const auto text = readTextFile(path);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseProjectile(*text, path.string());
}

Expected<AeroTable> parseAeroTable(std::string_view text, std::string_view file, Interpolation interpolation, bool drag_only) {
  auto json = JsonText::parse(text, file);
  if (!json) return tl::unexpected<Error>(json.error());
  Fields fields(*json);
  std::vector<std::string_view> keys{"M"};
  for (std::size_t c = 0; c < kCoefficients; ++c) keys.push_back(coefficientKey(static_cast<Coefficient>(c)));
  Projectile holder;
  holder.mass_kg = holder.diameter_m = 1.0;
  if (fields.object("", keys)) {
    const std::vector<double> mach = fields.numbers("/M");
    for (std::size_t c = 0; c < kCoefficients; ++c) {
      const std::string at = '/' + std::string(keys[c + 1]);
      // Cubic terms are seldom known; all other columns make the model what it is.
      const auto kind = static_cast<Coefficient>(c);
      const bool optional = kind == Coefficient::cla3 || kind == Coefficient::cma3 || (drag_only && kind != Coefficient::cd0);
      if (!fields.has(at)) {
        if (!optional) fields.fault(at, "the column is missing.", drag_only ? "A table has at least \"M\" and \"CD0\"." : "The modified point-mass model needs it; with --model point-mass \"M\" and \"CD0\" suffice.");
        continue;
      }
      CoefficientCurve& curve = holder.aero[c];
      curve.mach = mach;
      curve.value = fields.numbers(at);
      curve.interpolation = interpolation;
      if (fields.faults.empty() && curve.value.size() != mach.size())
        fields.fault(at, "the column has " + std::to_string(curve.value.size()) + " values for " + std::to_string(mach.size()) + " Mach numbers.", "Give one value for each Mach number of \"M\".");
    }
  }
  if (fields.faults.empty() && holder.curve(Coefficient::cd0).empty()) fields.fault("/M", "the table has no rows.");
  if (fields.faults.empty()) {
    for (Fault& fault : validate(holder)) {
      // Pointers of a projectile file become those of the bare table: /coefficients/CD0/mach/3 is /M/3 here.
      std::string at = fault.pointer.substr(std::string("/coefficients").size());
      if (const std::size_t mach = at.find("/mach"); mach != std::string::npos) at = std::string("/M").append(at, mach + 5);
      else if (const std::size_t value = at.find("/value"); value != std::string::npos) at.erase(value, 6);
      const bool repeated = !fields.faults.empty() && fields.faults.back().pointer == at;
      bool told = repeated;
      for (const Fault& earlier : fields.faults) told = told || (earlier.pointer == at && earlier.what == fault.what);
      if (!told) fields.fault(at, std::move(fault.what), std::move(fault.remedy));
    }
  }
  if (!fields.faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(fields.faults)});
  return std::move(holder.aero);
}

}  // namespace npsee
