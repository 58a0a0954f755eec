#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// The candidate with the least edit distance to `word`, if it is close enough to be what was meant; ties go to the first.
std::optional<std::string_view> nearest(std::string_view word, const std::vector<std::string_view>& candidates);

/// "a, b and c".
std::string listed(const std::vector<std::string_view>& words);

/// The names of a table's rows: views into them.
template <class Table, class Row, class Name>
std::vector<std::string_view> namesOf(const Table& table, Name Row::*name) {
  std::vector<std::string_view> names;
  names.reserve(std::size(table));
  for (const Row& row : table) names.push_back(row.*name);
  return names;
}

/// Whether `text` is well-formed UTF-8 (no overlong forms, no surrogates).
bool validUtf8(std::string_view text);

/// `value` with so many decimals, whatever the locale: withDecimals(2.25, 1) is "2.2".
std::string withDecimals(double value, int decimals);

std::string_view trimmed(std::string_view text);
std::vector<std::string_view> splitAt(std::string_view text, char separator);

}  // namespace npsee
