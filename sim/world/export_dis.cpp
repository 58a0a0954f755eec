// Distributed Interactive Simulation, IEEE 1278.1: Entity State, Fire and Detonation protocol data units.

#include "sim/ballistics/angles.h"
#include "sim/world/export_samples.h"

#include "sim/core/elementary.h"

#include <npsee/units.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace npsee {
namespace {

using world::Sample;

/// Version 6 is IEEE 1278.1a-1998.
constexpr std::uint8_t kVersion = 6, kExercise = 1;
constexpr std::uint16_t kSite = 1, kApplication = 1;
/// An entity is taken for gone after this without news; the standard's heartbeat (IEEE 1278.1, HEART_BEAT_TIMER), s.
constexpr double kHeartbeat_s = 5.0;
/// First numbers of guns and munitions; vehicles count from 1. Munitions' numbers come round again after so many.
constexpr int kFirstGun = 20000, kFirstMunition = 30000, kMunitions = 35000;
/// Equatorial radius of the earth, m. Source: WGS 84.
constexpr double kEarthRadius_m = 6378137.0;

enum class Type : std::uint8_t { entity_state = 1, fire = 2, detonation = 3 };
enum class Family : std::uint8_t { entity_information = 1, warfare = 2 };

/// Kind, domain, country, category, subcategory, specific, extra of SISO-REF-010.
struct EntityType {
  std::uint8_t kind = 0, domain = 0;
  std::uint16_t country = 0;
  std::uint8_t category = 0, subcategory = 0;
};
constexpr std::uint16_t kUnitedStates = 225, kOther = 0;

EntityType typeOf(const VehicleType& type) {
  const std::uint16_t country = type.side == Side::friendly ? kUnitedStates : kOther;
  switch (type.target_class) {
    case TargetClass::heavy_armor: return {1, 1, country, 1, 0};   // platform, land, tank
    case TargetClass::light_armor: return {1, 1, country, 2, 0};   // armoured fighting vehicle
    case TargetClass::wheeled: return {1, 1, country, 7, 0};       // large wheeled utility vehicle
    case TargetClass::personnel: return {3, 1, country, 1, 0};     // life form, land
    case TargetClass::aircraft: return {1, 2, country, 20, 0};     // air, attack helicopter
    case TargetClass::watercraft: return {1, 3, country, 0, 0};
  }
  return {1, 1, country, 0, 0};
}
constexpr EntityType kGunType{1, 1, kUnitedStates, 4, 0};   // platform, land, self-propelled artillery
constexpr EntityType kShellType{2, 9, kUnitedStates, 2, 0};  // munition, battlefield support, ballistic

std::uint8_t forceOf(Side side) { return side == Side::friendly ? 1 : side == Side::hostile ? 2 : 3; }

/// Big-endian fields in order.
class PduWriter {
 public:
  PduWriter(Type type, Family family, double t_s) {
    u8(kVersion), u8(kExercise), u8(static_cast<std::uint8_t>(type)), u8(static_cast<std::uint8_t>(family));
    u32(timestamp(t_s));
    u16(0), u16(0);  // length, filled in at the end, and padding
  }
  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u16(std::uint16_t value) { u8(static_cast<std::uint8_t>(value >> 8)), u8(static_cast<std::uint8_t>(value)); }
  void u32(std::uint32_t value) { u16(static_cast<std::uint16_t>(value >> 16)), u16(static_cast<std::uint16_t>(value)); }
  void f32(double value) { u32(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void f64(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    u32(static_cast<std::uint32_t>(bits >> 32)), u32(static_cast<std::uint32_t>(bits));
  }
  void zeros(int count) { bytes_.insert(bytes_.end(), static_cast<std::size_t>(count), 0); }
  void id(int number) {
    const bool none = number == 0;
    u16(none ? 0 : kSite), u16(none ? 0 : kApplication), u16(static_cast<std::uint16_t>(number));
  }
  void type(const EntityType& t) { u8(t.kind), u8(t.domain), u16(t.country), u8(t.category), u8(t.subcategory), u8(0), u8(0); }
  void velocity(const Vec3& v) { f32(v.x), f32(v.y), f32(v.z); }
  void place(const Vec3& v) { f64(v.x), f64(v.y), f64(v.z); }
  std::vector<std::uint8_t> done() {
    bytes_[8] = static_cast<std::uint8_t>(bytes_.size() >> 8);
    bytes_[9] = static_cast<std::uint8_t>(bytes_.size());
    return std::move(bytes_);
  }

 private:
  /// Time past the hour in units of 3600 s / 2^31, rounded; the lowest bit says relative (0) or absolute (1) time.
  static std::uint32_t timestamp(double t_s) {
    const double hour = t_s - 3600.0 * std::floor(t_s / 3600.0);
    const auto units = static_cast<std::uint64_t>(std::floor(hour / 3600.0 * 0x1p31 + 0.5)) % (std::uint64_t{1} << 31);
    return static_cast<std::uint32_t>(units << 1);
  }
  std::vector<std::uint8_t> bytes_;
};

/// The world's axes in the earth-centred frame at latitude and longitude 0: up is x, east y, north z.
Vec3 geocentric(const Vec3& v) { return {v.y, v.x, -v.z}; }

/// Euler angles psi, theta, phi (about z, y, x, in this order) of a body with this nose and this right wing, both in the earth's frame.
/// Source: IEEE 1278.1, orientation of entities: rows of the rotation are the body's axes.
std::array<double, 3> eulerAngles(const Vec3& nose, const Vec3& right) {
  const Vec3 down = cross(nose, right);
  const double level = std::sqrt(nose.x * nose.x + nose.y * nose.y);
  // Along the earth's axis, heading due north or south, psi and phi turn about the same line: psi is 0 then.
  if (level < 1e-9) return {0.0, nose.z > 0.0 ? -0.5 * kPi : 0.5 * kPi, ballistics::angleOf(right.y, nose.z > 0.0 ? -right.x : right.x)};
  return {ballistics::angleOf(nose.x, nose.y), ballistics::angleOf(level, -nose.z), ballistics::angleOf(down.z, right.z)};
}

class Exporter {
 public:
  explicit Exporter(const Recording& recording) : r_(recording) {}

  std::vector<DisPacket> run(const std::vector<Sample>& samples) {
    std::vector<DisPacket> out;
    out.reserve(samples.size());
    for (const Sample& sample : samples) {
      if (sample.kind == Sample::Kind::burst) {
        out.push_back({sample.t_s, detonation(r_.shells[static_cast<std::size_t>(sample.index)])});
        continue;
      }
      out.push_back({sample.t_s, entityState(sample)});
      // The munition is known before its shot is told of.
      if (sample.kind == Sample::Kind::shell && sample.first) out.push_back({sample.t_s, fire(r_.shells[static_cast<std::size_t>(sample.index)])});
    }
    return out;
  }

 private:
  static int vehicleId(int index) { return index < 0 ? 0 : index + 1; }
  static int munitionId(const ShellRecord& shell) { return kFirstMunition + shell.number % kMunitions; }
  static std::uint16_t eventId(const ShellRecord& shell) { return static_cast<std::uint16_t>(1 + shell.number % 65535); }
  static int shooterId(const ShellRecord& shell) { return shell.gun >= 0 ? kFirstGun + shell.gun : vehicleId(shell.shooter); }

  Vec3 placeOf(const Vec3& world_m) const {
    const Vec3 middle{0.5 * r_.terrain.sizeX(), 0.0, 0.5 * r_.terrain.sizeZ()};
    return geocentric(world_m - middle) + Vec3{kEarthRadius_m, 0.0, 0.0};
  }

  std::vector<std::uint8_t> entityState(const Sample& s) const {
    const auto i = static_cast<std::size_t>(s.index);
    PduWriter out(Type::entity_state, Family::entity_information, s.t_s);
    Side side = Side::friendly;
    EntityType type = kGunType;
    std::string marking;
    int id = 0;
    if (s.kind == Sample::Kind::vehicle) {
      side = r_.vehicles[i].type.side, type = typeOf(r_.vehicles[i].type), marking = r_.vehicles[i].id, id = vehicleId(s.index);
    } else if (s.kind == Sample::Kind::gun) {
      marking = r_.guns[i].id, id = kFirstGun + s.index;
    } else {
      side = world::sideOf(r_, r_.shells[i]), type = kShellType, marking = "shell " + std::to_string(r_.shells[i].number), id = munitionId(r_.shells[i]);
    }
    out.id(id);
    out.u8(forceOf(side));
    out.u8(0);  // no articulation parameters
    out.type(type);
    out.type(type);  // alternative type: the same to everybody
    const bool moves = !(s.velocity_mps == Vec3{});
    out.velocity(geocentric(s.velocity_mps));
    out.place(placeOf(s.position_m));
    for (const double angle : orientation(s)) out.f32(angle);
    out.u32(appearance(s));
    out.u8(moves ? 2 : 1);  // dead reckoning: constant velocity without rotation, or static
    out.zeros(39);
    out.u8(1);  // ASCII
    for (std::size_t k = 0; k < 11; ++k) out.u8(k < marking.size() ? static_cast<std::uint8_t>(marking[k] & 0x7f) : 0);
    out.u32(0);  // capabilities
    return out.done();
  }

  std::array<double, 3> orientation(const Sample& s) const {
    double sine = 0.0, cosine = 1.0;
    sineCosine(s.heading_rad, sine, cosine);
    Vec3 nose{sine, 0.0, -cosine}, right{cosine, 0.0, sine};
    const double speed = length(s.velocity_mps), level = std::sqrt(s.velocity_mps.x * s.velocity_mps.x + s.velocity_mps.z * s.velocity_mps.z);
    if (s.kind == Sample::Kind::shell && speed > 0.0) {
      nose = (1.0 / speed) * s.velocity_mps;
      if (level > 0.0) right = (1.0 / level) * Vec3{-s.velocity_mps.z, 0.0, s.velocity_mps.x};
    }
    return eulerAngles(geocentric(nose), geocentric(right));
  }

  /// Bits of SISO-REF-010: 1 immobile, 2 no firepower, 3 and 4 damage, 23 gone.
  std::uint32_t appearance(const Sample& s) const {
    if (s.last) return 1u << 23;
    const DamageStep* damage = s.kind == Sample::Kind::vehicle ? r_.vehicles[static_cast<std::size_t>(s.index)].damageAt(s.t_s) : nullptr;
    if (!damage) return 0;
    const std::uint32_t grade = damage->hull >= 1.0 ? 3 : damage->hull >= 0.5 ? 2 : damage->hull > 0.0 ? 1 : 0;
    return (damage->mobility ? 0u : 2u) | (damage->firepower ? 0u : 4u) | grade << 3;
  }

  void head(PduWriter& out, const ShellRecord& shell) const {
    out.id(shooterId(shell));
    out.id(vehicleId(shell.target));
    out.id(munitionId(shell));
    out.u16(kSite), out.u16(kApplication), out.u16(eventId(shell));
  }
  /// Warhead: 1000 high explosive, 2000 smoke, 3000 illumination; fuse: 1000 contact, 2000 timed.
  static void descriptor(PduWriter& out, const ShellRecord& shell) {
    out.type(kShellType);
    out.u16(shell.smoke ? 2000 : shell.illumination ? 3000 : 1000);
    out.u16(shell.illumination ? 2000 : 1000);
    out.u16(1), out.u16(0);  // one round, no rate
  }

  std::vector<std::uint8_t> fire(const ShellRecord& shell) const {
    PduWriter out(Type::fire, Family::warfare, shell.fired_s);
    head(out, shell);
    out.u32(static_cast<std::uint32_t>(std::max(0, shell.mission)));
    out.place(placeOf(shell.at(shell.fired_s)));
    descriptor(out, shell);
    out.velocity(geocentric(shell.velocityAt(shell.fired_s)));
    const Vec3 way = shell.burst_m - shell.muzzle_m;
    out.f32(std::sqrt(way.x * way.x + way.z * way.z));
    return out.done();
  }

  std::vector<std::uint8_t> detonation(const ShellRecord& shell) const {
    PduWriter out(Type::detonation, Family::warfare, shell.burst_s);
    head(out, shell);
    out.velocity(geocentric(shell.velocityAt(shell.burst_s)));
    out.place(placeOf(shell.burst_m));
    descriptor(out, shell);
    out.zeros(12);  // place in the target's own frame: it was not hit as such
    out.u8(shell.illumination ? 5 : 3);  // detonation in the air, or ground impact
    out.u8(0), out.u16(0);
    return out.done();
  }

  const Recording& r_;
};

/// Sum of 16-bit words with end-around carry, inverted. Source: RFC 1071.
std::uint16_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t sum = 0) {
  for (std::size_t i = 0; i < bytes.size(); i += 2) sum += static_cast<std::uint32_t>(bytes[i]) << 8 | (i + 1 < bytes.size() ? bytes[i + 1] : 0u);
  while (sum >> 16) sum = (sum & 0xffff) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum);
}

void put16(std::vector<std::uint8_t>& out, std::size_t value) { out.push_back(static_cast<std::uint8_t>(value >> 8)), out.push_back(static_cast<std::uint8_t>(value)); }
void put32(std::vector<std::uint8_t>& out, std::uint32_t value) { put16(out, value >> 16), put16(out, value & 0xffff); }

/// Ethernet frame of a UDP datagram from loopback to loopback, as a capture of `lo` shows it.
std::vector<std::uint8_t> frameOf(const std::vector<std::uint8_t>& payload, std::uint16_t number) {
  constexpr std::uint32_t kLoopback = 0x7f000001;
  std::vector<std::uint8_t> udp;
  put16(udp, kDisPort), put16(udp, kDisPort), put16(udp, 8 + payload.size()), put16(udp, 0);
  udp.insert(udp.end(), payload.begin(), payload.end());
  // The pseudo header: both addresses, protocol and length.
  const std::uint32_t pseudo = 2u * ((kLoopback >> 16) + (kLoopback & 0xffff)) + 17u + static_cast<std::uint32_t>(udp.size());
  std::uint16_t sum = checksum(udp, pseudo);
  if (sum == 0) sum = 0xffff;
  udp[6] = static_cast<std::uint8_t>(sum >> 8), udp[7] = static_cast<std::uint8_t>(sum);

  std::vector<std::uint8_t> ip{0x45, 0};
  put16(ip, 20 + udp.size()), put16(ip, number), put16(ip, 0x4000);  // do not fragment
  ip.push_back(64), ip.push_back(17);
  put16(ip, 0), put32(ip, kLoopback), put32(ip, kLoopback);
  const std::uint16_t ip_sum = checksum(ip);
  ip[10] = static_cast<std::uint8_t>(ip_sum >> 8), ip[11] = static_cast<std::uint8_t>(ip_sum);

  std::vector<std::uint8_t> frame(12, 0);
  put16(frame, 0x0800);
  frame.insert(frame.end(), ip.begin(), ip.end());
  frame.insert(frame.end(), udp.begin(), udp.end());
  return frame;
}

}  // namespace

Expected<std::vector<DisPacket>> disPackets(const Recording& recording, const ExportSetup& setup) {
  if (recording.vehicles.size() >= static_cast<std::size_t>(kFirstGun) || recording.guns.size() >= static_cast<std::size_t>(kFirstMunition - kFirstGun))
    return fail(ErrorKind::input, "the recording has more vehicles or guns than DIS entity numbers are set aside for.");
  const auto samples = world::samplesOf(recording, setup, kHeartbeat_s);
  if (!samples) return tl::unexpected<Error>(samples.error());
  return Exporter(recording).run(*samples);
}

std::string pcapText(std::span<const DisPacket> packets) {
  // 1993-09-01T00:00:00Z, the reference time of the other exports.
  constexpr std::uint32_t kEpoch_s = 746841600;
  std::vector<std::uint8_t> out;
  const auto little32 = [&](std::uint32_t v) { out.insert(out.end(), {static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v >> 8), static_cast<std::uint8_t>(v >> 16), static_cast<std::uint8_t>(v >> 24)}); };
  little32(0xa1b2c3d4), little32(0x00040002), little32(0), little32(0), little32(65535), little32(1);
  std::uint16_t number = 0;
  for (const DisPacket& packet : packets) {
    const std::vector<std::uint8_t> frame = frameOf(packet.bytes, number++);
    const auto micros = static_cast<std::uint64_t>(std::floor(packet.t_s * 1e6 + 0.5));
    little32(kEpoch_s + static_cast<std::uint32_t>(micros / 1000000)), little32(static_cast<std::uint32_t>(micros % 1000000));
    little32(static_cast<std::uint32_t>(frame.size())), little32(static_cast<std::uint32_t>(frame.size()));
    out.insert(out.end(), frame.begin(), frame.end());
  }
  return {out.begin(), out.end()};
}

}  // namespace npsee
