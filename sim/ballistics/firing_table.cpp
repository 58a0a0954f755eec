#include <npsee/firing_table.h>

#include "sim/ballistics/json_fields.h"
#include "sim/ballistics/shipped.h"

#include <npsee/units.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace npsee {

using namespace ballistics;

namespace {

PublishedImpact impactAt(Fields& fields, const std::string& at) {
  if (!fields.object(at, {"deflection_m", "range_m"})) return {};
  return {fields.number(at + "/deflection_m").value_or(0.0), fields.number(at + "/range_m").value_or(0.0)};
}

}  // namespace

Expected<ThesisTables> parseThesisTables(std::string_view text, std::string_view file) {
  auto json = JsonText::parse(text, file);
  if (!json) return tl::unexpected<Error>(json.error());
  Fields fields(*json);
  ThesisTables out;
  if (fields.object("", {"title", "source", "projectile", "rows"})) {
    out.title = fields.text("/title");
    out.source = fields.text("/source", true);
    out.projectile = fields.text("/projectile", true);
    const std::size_t count = fields.list("/rows");
    for (std::size_t i = 0; i < count; ++i) {
      const std::string at = "/rows/" + std::to_string(i);
      if (!fields.object(at, {"charge", "elevation_mil", "cep_m", "firing_table", "thesis_vacuum", "thesis_model"})) continue;
      ThesisRow row;
      row.charge = fields.text(at + "/charge", true);
      row.elevation_rad = toSi(Unit::mil, fields.number(at + "/elevation_mil").value_or(0.0));
      row.cep_m = fields.number(at + "/cep_m").value_or(0.0);
      if (!(row.cep_m > 0.0)) fields.fault(at + "/cep_m", "the circular error probable must be above 0 m.");
      row.firing_table = impactAt(fields, at + "/firing_table");
      row.thesis_vacuum = impactAt(fields, at + "/thesis_vacuum");
      row.thesis_model = impactAt(fields, at + "/thesis_model");
      out.rows.push_back(std::move(row));
    }
  }
  if (!fields.faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(fields.faults)});
  return out;
}

Expected<ThesisTables> thesisTables() {
  for (const ShippedFile& file : shippedFiringTables())
    if (file.name == "thesis_1993") return parseThesisTables(file.text, "assets/firing_tables/thesis_1993.json");
  return fail(ErrorKind::input, "the thesis's tables are not part of this build.");
}

double errorInCeps(const ThesisRow& row, double range_m, double deflection_m) {
  const double dr = range_m - row.firing_table.range_m, dd = deflection_m - row.firing_table.deflection_m;
  return std::sqrt(dr * dr + dd * dd) / row.cep_m;
}

}  // namespace npsee
