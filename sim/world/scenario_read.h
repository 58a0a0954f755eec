#pragma once

#include "sim/core/json_text.h"
#include "sim/world/scenario_table.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace npsee::world {

/// Most faults listed of one file; a hostile one could have millions.
inline constexpr std::size_t kMostFaults = 100;

/// Reads structures of the table from JSON and collects every fault.
class TableReader {
 public:
  /// `foreign`: the keys and shapes of "npsnet-scenario/1" are understood too.
  TableReader(const JsonText& json, std::vector<Fault>& faults, bool foreign) : json_(json), faults_(faults), foreign_(foreign) {}

  /// Reads an object at `pointer` into `out`, which has its defaults; keys in `extra` belong to the caller.
  void read(const Struct& table, const nlohmann::ordered_json& object, const std::string& pointer, void* out, const std::vector<std::string_view>& extra = {});
  /// Reads the value of one field of any type; lists replace what was there.
  void readField(const Field& field, const nlohmann::ordered_json& value, const std::string& pointer, void* out);

 private:
  bool full() const { return faults_.size() >= kMostFaults; }
  void readIdentity(const Struct& table, const nlohmann::ordered_json& object, const std::string& pointer, void* out);
  void readList(const Field& field, const nlohmann::ordered_json& value, const std::string& pointer, void* out);
  void readExpectations(const Field& field, const nlohmann::ordered_json& value, const std::string& pointer, void* out);
  const Field* singular(const Struct& table, std::string_view key) const;
  void unknown(const Struct& table, const std::string& key, const std::string& pointer, const std::vector<std::string_view>& extra);

  const JsonText& json_;
  std::vector<Fault>& faults_;
  bool foreign_;
};

}  // namespace npsee::world
