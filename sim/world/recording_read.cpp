#include "sim/core/file_kind.h"
#include "sim/core/files.h"
#include "sim/core/json_text.h"
#include "sim/core/text.h"
#include "sim/world/recording_file.h"
#include "sim/world/scenario_files.h"

#include <npsee/units.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace npsee {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Bounds that any recording keeps and that keep the program safe: times (s), places (m), everything else.
constexpr double kMaxTime_s = 2.0 * kMaxMissionDuration_s, kMaxPlace_m = 1e7, kMaxNumber = 1e12;
constexpr std::string_view kDamaged = "The file is damaged or was changed by hand. Run the mission again with --record.";

/// Reads the values of one line; the first fault counts, later ones follow from it.
class Line {
 public:
  Line(const ordered_json& value, std::string pointer, std::optional<Fault>& fault) : value_(value), pointer_(std::move(pointer)), fault_(fault) {}

  const ordered_json* find(const char* key) {
    if (!value_.is_object()) return wrong("", "is not an object."), nullptr;
    const auto found = value_.find(key);
    if (found == value_.end()) return wrong(key, "is missing."), nullptr;
    return &*found;
  }
  std::string text(const char* key, std::size_t limit = 4096) {
    const ordered_json* value = find(key);
    if (!value) return {};
    if (!value->is_string()) return wrong(key, "is not a text."), std::string();
    std::string out = value->get<std::string>();
    if (out.size() > limit) wrong(key, "is longer than " + std::to_string(limit) + " bytes.");
    return out;
  }
  bool flag(const char* key) {
    const ordered_json* value = find(key);
    if (value && !value->is_boolean()) wrong(key, "is not true or false.");
    return value && value->is_boolean() && value->get<bool>();
  }
  double number(const char* key, double low, double high) {
    const ordered_json* value = find(key);
    return value ? checked(*value, key, low, high) : 0.0;
  }
  int whole(const char* key, int low, int high) {
    const double value = number(key, low, high);
    if (value != std::floor(value)) wrong(key, "is not a whole number.");
    return static_cast<int>(value);
  }
  Vec3 place(const char* key, double limit = kMaxPlace_m) {
    const auto v = numbers<3>(find(key), key, limit);
    return {v[0], v[1], v[2]};
  }
  template <std::size_t N>
  std::array<double, N> numbers(const ordered_json* value, const std::string& key, double limit) {
    std::array<double, N> out{};
    if (!value) return out;
    if (!value->is_array() || value->size() != N) return wrong(key, "is not a list of " + std::to_string(N) + " numbers."), out;
    for (std::size_t i = 0; i < N && !fault_; ++i) out[i] = checked((*value)[i], key + '/' + std::to_string(i), -limit, limit);
    return out;
  }
  /// Each entry of a list of lists of N numbers, in order, while there is no fault.
  template <std::size_t N, class Take>
  void each(const char* key, const Take& take) {
    const ordered_json* list = find(key);
    if (!list) return;
    if (!list->is_array()) return wrong(key, "is not a list.");
    for (std::size_t i = 0; i < list->size() && !fault_; ++i) {
      const auto row = numbers<N>(&(*list)[i], std::string(key) + '/' + std::to_string(i), kMaxNumber);
      if (!fault_) take(row, std::string(key) + '/' + std::to_string(i));
    }
  }
  void wrong(const std::string& key, std::string what) {
    if (!fault_) fault_ = Fault{.what = std::move(what), .remedy = std::string(kDamaged), .file = {}, .line = 0, .pointer = pointer_ + (key.empty() ? "" : "/" + key)};
  }
  bool good() const { return !fault_; }

 private:
  double checked(const ordered_json& value, const std::string& key, double low, double high) {
    if (!value.is_number()) return wrong(key, "is not a number."), 0.0;
    const double number = value.get<double>();
    if (!(number >= low && number <= high)) return wrong(key, "is " + shortest(number) + ", outside " + shortest(low) + " to " + shortest(high) + "."), 0.0;
    return number;
  }

  const ordered_json& value_;
  std::string pointer_;
  std::optional<Fault>& fault_;
};

class Reader {
 public:
  Reader(std::string_view text, fs::path path) : text_(text), path_(std::move(path)) {}

  Expected<Recording> run() {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      const std::string_view line = text_.substr(begin, end - begin);
      begin = end + 1;
      ++line_;
      if (trimmed(line).empty()) continue;
      if (ended_) return error("", "stands after the end of the recording.");
      if (auto read = this->line(line); !read) return tl::unexpected<Error>(read.error());
    }
    if (!ended_) return error("", line_ == 0 ? "is empty." : "ends before the recording does.");
    return std::move(recording_);
  }

 private:
  using Take = void (Reader::*)(Line&);

  tl::unexpected<Error> error(std::string pointer, std::string what) {
    return fail(ErrorKind::input, {.what = std::move(what), .remedy = std::string(kDamaged), .file = path_.string(), .line = line_, .pointer = std::move(pointer)});
  }
  tl::unexpected<Error> placed(Error error, const std::string& pointer) {
    for (Fault& fault : error.faults) {
      fault.file = path_.string();
      fault.line = line_;
      if (!fault.pointer.empty()) fault.pointer.insert(0, pointer);
    }
    error.kind = ErrorKind::input;
    return tl::unexpected<Error>(std::move(error));
  }

  Expected<void> line(std::string_view text) {
    auto json = JsonText::parse(text, path_.string());
    if (!json) {
      Error error = json.error();
      for (Fault& fault : error.faults) fault.line = line_;
      return tl::unexpected<Error>(std::move(error));
    }
    const ordered_json& root = json->root();
    if (!root.is_object() || root.size() != 1) return error("", "is no line of a recording: an object with one key.");
    const std::string key = root.begin().key();
    if (head_ == 0 && key != "npsee_recording") return error("", "is not the first line of a recording (npsee_recording).");
    static constexpr std::array<std::pair<std::string_view, Take>, 9> kLines{{{"npsee_recording", &Reader::head}, {"scenario", &Reader::scenario}, {"weapons", &Reader::weapons}, {"vehicle", &Reader::vehicle}, {"gun", &Reader::gun}, {"shell", &Reader::shell}, {"observer", &Reader::observer}, {"event", &Reader::event}, {"end", &Reader::end}}};
    const auto* known = std::ranges::find(kLines, key, &std::pair<std::string_view, Take>::first);
    if (known == kLines.end()) return error('/' + pointerToken(key), "is not known.");
    // The first three come in order and once, the rest needs them.
    const auto place = static_cast<int>(known - kLines.begin());
    if (place < 3 ? place != head_ : head_ < 3) return error('/' + pointerToken(key), "stands out of order.");
    head_ += place < 3 ? 1 : 0;
    Line values(root.begin().value(), '/' + key, fault_);
    value_ = &root.begin().value();
    (this->*known->second)(values);
    if (error_) return placed(std::move(*error_), '/' + key);
    if (!fault_) return {};
    fault_->file = path_.string();
    fault_->line = line_;
    return fail(ErrorKind::input, std::move(*fault_));
  }

  void head(Line& in) {
    const int version = in.whole("version", 1, 1000000);
    if (version > world::kRecordingVersion && in.good())
      return take(fail(ErrorKind::input, "the recording has version " + std::to_string(version) + ", newer than " + std::to_string(world::kRecordingVersion) + ", the newest this program reads.", "Use a newer npsee.").value());
    recording_.duration_s = in.number("duration_s", 0.0, kMaxTime_s);
    recording_.finished = in.flag("finished");
    recording_.hash = in.text("hash");
    folder_ = in.text("folder");
    terrain_mark_ = in.text("terrain");
  }

  void scenario(Line& in) {
    auto scenario = parseScenario(value_->dump(), path_.string());
    if (!scenario) return take(scenario.error());
    recording_.scenario = std::move(*scenario);
    const fs::path here = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    recording_.scenario.folder = (here / folder_).lexically_normal();
    const WorldSetup& world = recording_.scenario.world;
    auto terrain = Terrain::make(world::missionTerrain(recording_.scenario), world.size_x_m, world.size_z_m, world.sea_level_m);
    if (!terrain) return take(terrain.error());
    recording_.terrain = std::move(*terrain);
    if (world::terrainMark(recording_.terrain) != terrain_mark_) in.wrong("terrain", "is not the ground on which the mission was played.");
    for (const VehicleType& type : vehicleTypes(recording_.scenario)) types_.push_back(type);
  }

  void weapons(Line& in) {
    if (!value_->is_string()) return in.wrong("", "is not a text.");
    auto weapons = parseWeapons(value_->get<std::string>(), path_.string());
    if (!weapons) return take(weapons.error());
    weapons_ = std::move(*weapons);
    reflight_.emplace(recording_, weapons_);
  }

  void vehicle(Line& in) {
    VehicleRecord out;
    out.id = in.text("id");
    const int index = in.whole("type", -1000000, 1000000);
    const auto type = std::ranges::find(types_, index, &VehicleType::index);
    if (type == types_.end()) in.wrong("type", "is no type of the mission's vehicles.");
    else out.type = *type;
    double last = -1.0;
    in.each<7>("legs", [&](const std::array<double, 7>& v, const std::string& at) {
      if (!(v[0] >= last && v[0] >= 0.0 && v[0] <= kMaxTime_s) || std::fabs(v[1]) > kMaxPlace_m || std::fabs(v[2]) > kMaxPlace_m || std::fabs(v[3]) > 1e4 || std::fabs(v[4]) > 1e4 || std::fabs(v[5]) > 1e4 || std::fabs(v[6]) > 100.0)
        return in.wrong(at, "is no leg of a drive: out of order or beyond all bounds.");
      last = v[0];
      out.track.add({v[0], v[1], v[2], v[3], v[4], v[5], v[6]});
    });
    if (in.good() && out.track.legs.empty()) in.wrong("legs", "is empty, but a vehicle stands somewhere.");
    in.each<4>("damage", [&](const std::array<double, 4>& v, const std::string&) { out.damage.push_back({v[0], v[1], v[2] != 0.0, v[3] != 0.0}); });
    if (!std::ranges::is_sorted(out.damage, {}, &DamageStep::t_s)) in.wrong("damage", "is not in the order of time.");
    if (recording_.vehicles.size() >= 4 * kMaxVehicles) in.wrong("", "is one vehicle too many.");
    if (in.good()) recording_.vehicles.push_back(std::move(out));
  }

  void gun(Line& in) {
    GunRecord out;
    out.id = in.text("id");
    out.battery = in.whole("battery", 0, static_cast<int>(recording_.scenario.batteries.size()) - 1);
    out.muzzle_m = in.place("muzzle");
    in.each<4>("lays", [&](const std::array<double, 4>& v, const std::string& at) {
      if (!(v[1] >= v[0]) || (!out.lays.empty() && v[0] < out.lays.back().from_s)) return in.wrong(at, "is not in the order of time.");
      out.lays.push_back({v[0], v[1], v[2], v[3]});
    });
    if (in.good()) recording_.guns.push_back(std::move(out));
  }

  Shot shot(const ordered_json& value) {
    Line in(value, "/shell/shot", fault_);
    Shot out;
    out.speed_mps = in.number("speed", 0.0, 1e5);
    out.elevation_rad = in.number("elevation", -2.0, 2.0);
    out.azimuth_rad = in.number("azimuth", -1e3, 1e3);
    out.wind_mps = in.place("wind", 1e4);
    const auto f = in.numbers<4>(in.find("factors"), "factors", 1e3);
    out.factors = {f[0], f[1], f[2], f[3]};
    out.muzzle_m = in.place("muzzle");
    return out;
  }

  void shell(Line& in) {
    ShellRecord out;
    const int vehicles = static_cast<int>(recording_.vehicles.size()), guns = static_cast<int>(recording_.guns.size());
    out.number = in.whole("number", 0, std::numeric_limits<int>::max());
    out.gun = in.whole("gun", -1, guns - 1);
    out.shooter = in.whole("shooter", -1, vehicles - 1);
    out.weapon = in.whole("weapon", -1000000, 1000000);
    out.mission = in.whole("mission", 0, 1000000000);
    out.target = in.whole("target", -1, vehicles - 1);
    out.fired_s = in.number("fired_s", 0.0, kMaxTime_s);
    out.burst_s = in.number("burst_s", out.fired_s, out.fired_s + 2000.0);
    out.burst_m = in.place("burst");
    out.muzzle_m = in.place("muzzle");
    out.preset = in.text("preset");
    if (const ordered_json* seed = in.find("seed")) {
      if (seed->is_number_integer()) out.seed = seed->get<std::uint64_t>();
      else in.wrong("seed", "is not a whole number.");
    }
    out.illumination = in.flag("illumination");
    out.smoke = in.flag("smoke");
    if (!recording_.shells.empty() && out.fired_s < recording_.shells.back().fired_s) in.wrong("fired_s", "is not in the order of time.");
    if (!in.good()) return;
    if (const auto found = value_->find("shot"); found != value_->end()) {
      if (out.gun < 0) return in.wrong("shot", "belongs to a shell of no gun.");
      const Shot flown = shot(*found);
      if (!in.good()) return;
      auto path = reflight_->fly(out, flown);
      if (!path) return take(path.error());
      out.path = std::move(*path);
    }
    recording_.shells.push_back(std::move(out));
  }

  void observer(Line& in) {
    ObserverRecord out;
    out.id = in.text("id");
    out.vehicle = in.whole("vehicle", -1, static_cast<int>(recording_.vehicles.size()) - 1);
    out.eye_height_m = in.number("eye_height", -1000.0, 1000.0);
    in.each<9>("beliefs", [&](const std::array<double, 9>& v, const std::string& at) {
      if (!(v[1] >= -1.0 && v[1] < static_cast<double>(recording_.vehicles.size())) || std::fabs(v[8]) > 1e9) return in.wrong(at, "names no vehicle there is.");
      if (!out.beliefs.empty() && v[0] < out.beliefs.back().t_s) return in.wrong(at, "is not in the order of time.");
      out.beliefs.push_back({v[0], static_cast<int>(v[1]), v[2] != 0.0, {v[3], v[4], v[5]}, v[6], v[7], static_cast<int>(v[8])});
    });
    if (in.good()) recording_.observers.push_back(std::move(out));
  }

  /// The value of an event's field by what it looks like: the writer keeps 5 and 5.0 apart.
  static std::optional<MissionEvent::Value> eventValue(const ordered_json& value) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number_integer()) return value.get<std::int64_t>();
    if (value.is_number_float()) return value.get<double>();
    if (value.is_string()) return value.get<std::string>();
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!value.is_array()) return std::nullopt;
    if (value.size() == 3 && std::ranges::all_of(value, [](const ordered_json& v) { return v.is_number(); })) return Vec3{value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
    std::vector<std::string> texts;
    for (const ordered_json& text : value) {
      if (!text.is_string()) return std::nullopt;
      texts.push_back(text.get<std::string>());
    }
    return texts;
  }

  void event(Line& in) {
    MissionEvent out;
    out.t_s = in.number("t", 0.0, kMaxTime_s);
    const std::string name = in.text("ev");
    const auto names = eventKindNames();
    const auto kind = std::ranges::find(names, name);
    if (kind == names.end()) return in.wrong("ev", "is no kind of event.");
    out.kind = static_cast<EventKind>(kind - names.begin());
    for (auto field = value_->begin(); field != value_->end(); ++field) {
      if (field.key() == "t" || field.key() == "ev") continue;
      auto value = eventValue(field.value());
      if (!value) return in.wrong(pointerToken(field.key()), "is no value of an event.");
      out.fields.emplace_back(field.key(), std::move(*value));
    }
    if (in.good()) recording_.events.push_back(std::move(out));
  }

  void end(Line& in) {
    const auto same = [&](const char* key, std::size_t have) {
      const double said = in.number(key, 0.0, 1e15);
      if (in.good() && said != static_cast<double>(have)) in.wrong(key, "is " + shortest(said) + ", but there are " + std::to_string(have) + ".");
    };
    same("vehicles", recording_.vehicles.size());
    same("shells", recording_.shells.size());
    same("events", recording_.events.size());
    ended_ = true;
  }

  void take(Error error) {
    if (!error_) error_ = std::move(error);
  }

  std::string_view text_;
  fs::path path_;
  Recording recording_;
  Weapons weapons_;
  std::optional<world::Reflight> reflight_;
  std::vector<VehicleType> types_;
  std::string folder_, terrain_mark_;
  const ordered_json* value_ = nullptr;  ///< of the line being read
  std::optional<Fault> fault_;
  std::optional<Error> error_;
  int line_ = 0, head_ = 0;
  bool ended_ = false;
};

}  // namespace

Expected<Recording> loadRecording(const fs::path& path) {
  const auto text = readTextFile(path, world::kMaxRecordingFile);
  if (!text) return tl::unexpected<Error>(text.error());
  return readAs(FileKind::recording, *text, path.string(), Reader(*text, path).run());
}

}  // namespace npsee
