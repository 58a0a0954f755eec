#pragma once

#include <npsee/error.h>

#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// A published impact: metres to the right of the line of fire, and along it.
struct PublishedImpact {
  double deflection_m = 0.0, range_m = 0.0;
};

/// One row of the thesis's tables 1 and 2.
struct ThesisRow {
  std::string charge;
  double elevation_rad = 0.0;
  double cep_m = 0.0;  ///< circular error probable
  PublishedImpact firing_table, thesis_vacuum, thesis_model;
};

struct ThesisTables {
  std::string title, source, projectile;
  std::vector<ThesisRow> rows;
};

/// The thesis's tables as shipped in assets/firing_tables. Error kind input: never, in a program that was built whole.
Expected<ThesisTables> thesisTables();
/// The same from a file's text; `file` stands for it in messages. Error kind input, with line.
Expected<ThesisTables> parseThesisTables(std::string_view text, std::string_view file);

/// Distance of an impact from the firing table's as the thesis counts it: hypot(range error, deflection error) / CEP.
double errorInCeps(const ThesisRow& row, double range_m, double deflection_m);

}  // namespace npsee
