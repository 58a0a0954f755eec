// Tacview ACMI 2.2: a header, then frames ("#seconds") of objects that change ("id,Property=...").

#include "sim/world/export_samples.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

using world::rounded;
using world::Sample;

/// Bursts are shown this long, s.
constexpr double kBurst_s = 3.0;
/// Metres per degree at the equator: pi/180 of the earth's equatorial radius, 6,378,137 m (WGS 84).
constexpr double kMetresPerDegree = 6378137.0 * kPi / 180.0;

/// Object numbers; they never meet, for there are at most kMaxVehicles vehicles and kMaxGuns guns.
std::string objectId(Sample::Kind kind, int index) {
  constexpr std::uint64_t kFirst[] = {0x1, 0x100000, 0x1000000, 0x100000000};
  std::uint64_t value = kFirst[static_cast<int>(kind)] + static_cast<std::uint64_t>(index);
  std::string out;
  for (; value > 0; value >>= 4) out.insert(out.begin(), "0123456789abcdef"[value & 15]);
  return out;
}

/// Text in a property: commas are escaped, and a line is a line.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == ',' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 || c == '|' ? ' ' : c;
  }
  return out;
}

std::string_view typeOf(TargetClass target) {
  switch (target) {
    case TargetClass::heavy_armor: return "Ground+Heavy+Armor+Vehicle+Tank";
    case TargetClass::light_armor: return "Ground+Light+Armor+Vehicle";
    case TargetClass::wheeled: return "Ground+Light+Vehicle";
    case TargetClass::personnel: return "Ground+Light+Human+Infantry";
    case TargetClass::aircraft: return "Air+Rotorcraft";
    case TargetClass::watercraft: return "Sea+Watercraft";
  }
  return "Ground+Vehicle";
}

std::string_view colourOf(Side side) { return side == Side::friendly ? "Blue" : side == Side::hostile ? "Red" : "Green"; }

class AcmiWriter {
 public:
  explicit AcmiWriter(const Recording& recording) : r_(recording) {}

  std::string run(const std::vector<Sample>& samples) {
    out_ = "FileType=text/acmi/tacview\nFileVersion=2.2\n0,ReferenceTime=1993-09-01T00:00:00Z\n0,ReferenceLongitude=0\n0,ReferenceLatitude=0\n0,DataSource=npsee\n0,Title=" + escaped(r_.scenario.title.empty() ? r_.scenario.name : r_.scenario.title) + '\n';
    std::size_t event = 0;
    for (const Sample& sample : samples) {
      for (; event < r_.events.size() && r_.events[event].t_s <= sample.t_s; ++event) tell(r_.events[event]);
      fade(sample.t_s);
      frame(sample.t_s);
      write(sample);
    }
    for (; event < r_.events.size(); ++event) tell(r_.events[event]);
    fade(r_.duration_s);
    return std::move(out_);
  }

 private:
  void frame(double t) {
    if (t == frame_s_) return;
    frame_s_ = t;
    out_ += '#' + rounded(t, 4) + '\n';
  }

  std::string where(const Vec3& p) const {
    const double east = p.x - 0.5 * r_.terrain.sizeX(), north = 0.5 * r_.terrain.sizeZ() - p.z;
    return rounded(east / kMetresPerDegree, 8) + '|' + rounded(north / kMetresPerDegree, 8) + '|' + rounded(p.y, 2);
  }
  static std::string native(const Vec3& p) { return rounded(p.x, 2) + '|' + rounded(-p.z, 2); }
  static std::string degrees(double rad) {
    const double turns = rad / kTwoPi;
    return rounded(360.0 * (turns - std::floor(turns)), 1);
  }

  void write(const Sample& s) {
    out_ += objectId(s.kind, s.index) + ",T=" + where(s.position_m);
    const auto i = static_cast<std::size_t>(s.index);
    switch (s.kind) {
      case Sample::Kind::vehicle:
      case Sample::Kind::gun:
        out_ += "|||" + degrees(s.heading_rad) + '|' + native(s.position_m) + '|' + degrees(s.heading_rad);
        if (s.kind == Sample::Kind::vehicle) vehicle(s, r_.vehicles[i]);
        else if (s.first) out_ += ",Type=Ground+Static+Vehicle,Name=Gun,Pilot=" + escaped(r_.guns[i].id) + ",Coalition=friendly,Color=Blue";
        break;
      case Sample::Kind::shell:
        out_ += '|' + native(s.position_m);
        if (s.first) shell(r_.shells[i]);
        if (s.last) out_ += "\n-" + objectId(s.kind, s.index);
        break;
      case Sample::Kind::burst:
        out_ += '|' + native(s.position_m) + ",Type=Misc+Explosion,Name=Burst of shell " + std::to_string(r_.shells[i].number);
        bursts_.push_back({s.t_s + kBurst_s, s.index});
        break;
    }
    out_ += '\n';
  }

  void vehicle(const Sample& s, const VehicleRecord& record) {
    if (s.first) {
      const std::string side(world::sideWord(record.type.side));
      out_ += ",Type=" + std::string(typeOf(record.type.target_class)) + ",Name=" + escaped(record.type.name) + ",Pilot=" + escaped(record.id) + ",Coalition=" + side + ",Color=" + std::string(colourOf(record.type.side));
    }
    const DamageStep* damage = record.damageAt(s.t_s);
    if (damage && damage->t_s == s.t_s) out_ += ",Health=" + rounded(std::max(0.0, 1.0 - damage->hull), 3);
  }

  void shell(const ShellRecord& record) {
    const Side side = world::sideOf(r_, record);
    out_ += ",Type=Weapon+Projectile+Shell,Name=Weapon " + std::to_string(record.weapon) + ",Pilot=Shell " + std::to_string(record.number) + ",Coalition=" + std::string(world::sideWord(side)) + ",Color=" + std::string(colourOf(side));
    if (record.gun >= 0) out_ += ",Parent=" + objectId(Sample::Kind::gun, record.gun);
    else if (record.shooter >= 0) out_ += ",Parent=" + objectId(Sample::Kind::vehicle, record.shooter);
  }

  /// Bursts that have been shown long enough, in order.
  void fade(double until_s) {
    std::size_t gone = 0;
    for (; gone < bursts_.size() && bursts_[gone].until_s <= until_s; ++gone) {
      frame(std::max(bursts_[gone].until_s, frame_s_));
      out_ += '-' + objectId(Sample::Kind::burst, bursts_[gone].index) + '\n';
    }
    bursts_.erase(bursts_.begin(), bursts_.begin() + static_cast<std::ptrdiff_t>(gone));
  }

  void tell(const MissionEvent& event) {
    std::string line;
    if (event.kind == EventKind::destroyed) {
      const int vehicle = r_.findVehicle(event.text("target"));
      if (vehicle >= 0) line = "0,Event=Destroyed|" + objectId(Sample::Kind::vehicle, vehicle) + '|' + escaped(event.text("target") + " destroyed");
    } else if (event.kind == EventKind::call) {
      line = "0,Event=Bookmark|" + escaped(event.text("observer") + " calls " + event.text("method") + " on " + event.text("target"));
    } else if (event.kind == EventKind::end_of_mission) {
      line = "0,Event=Bookmark|" + escaped(event.text("observer") + " ends the mission: " + event.text("reason"));
    }
    if (line.empty()) return;
    fade(event.t_s);
    frame(std::max(event.t_s, frame_s_));
    out_ += line + '\n';
  }

  struct Burst {
    double until_s = 0.0;
    int index = 0;
  };
  const Recording& r_;
  std::string out_;
  double frame_s_ = -1.0;
  std::vector<Burst> bursts_;
};

}  // namespace

Expected<std::string> acmiText(const Recording& recording, const ExportSetup& setup) {
  const auto samples = world::samplesOf(recording, setup);
  if (!samples) return tl::unexpected<Error>(samples.error());
  return AcmiWriter(recording).run(*samples);
}

}  // namespace npsee
