#pragma once

#include "sim/core/json_text.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::ballistics {

/// Reads typed values out of a parsed file and collects every fault with its place. All functions take JSON pointers.
class Fields {
 public:
  explicit Fields(const JsonText& json) : json_(json) {}

  std::vector<Fault> faults;

  const nlohmann::ordered_json& at(const std::string& pointer) const;
  bool has(const std::string& pointer) const;

  /// True if the value is an object; every key of it that `known` does not list is a fault that names the nearest.
  bool object(const std::string& pointer, const std::vector<std::string_view>& known, bool required = true);
  /// Number of elements of a list, 0 where it is none (a fault).
  std::size_t list(const std::string& pointer);

  std::string text(const std::string& pointer, bool required = false);
  std::optional<double> number(const std::string& pointer, bool required = true);
  std::vector<double> numbers(const std::string& pointer, bool required = true);

  void fault(const std::string& pointer, std::string what, std::string remedy = {});

 private:
  void wrongType(const std::string& pointer, std::string_view wanted);
  bool missing(const std::string& pointer, bool required);

  const JsonText& json_;
};

}  // namespace npsee::ballistics
