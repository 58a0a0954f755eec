#include "sim/world/export_samples.h"

#include "sim/core/elementary.h"

#include <npsee/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace npsee::world {
namespace {

using Kind = Sample::Kind;

Vec3 ahead(double heading_rad, double speed_mps) {
  double sine = 0.0, cosine = 1.0;
  sineCosine(heading_rad, sine, cosine);
  return {speed_mps * sine, 0.0, -speed_mps * cosine};
}

class Sampler {
 public:
  Sampler(const Recording& recording, const ExportSetup& setup, double heartbeat_s) : r_(recording), setup_(setup), heartbeat_s_(heartbeat_s) {}

  std::vector<Sample> run() {
    for (std::size_t i = 0; i < r_.vehicles.size(); ++i) vehicle(i);
    for (std::size_t i = 0; i < r_.guns.size(); ++i) gun(i);
    for (std::size_t i = 0; i < r_.shells.size(); ++i) shell(i);
    std::ranges::stable_sort(out_, {}, &Sample::t_s);
    return std::move(out_);
  }

 private:
  void addVehicle(std::size_t i, double t) {
    const Pose pose = r_.vehicles[i].track.at(t);
    out_.push_back({t, Kind::vehicle, static_cast<int>(i), t == 0.0, false, {pose.x_m, r_.terrain.surface(pose.x_m, pose.z_m), pose.z_m}, ahead(pose.heading_rad, pose.speed_mps), pose.heading_rad});
  }

  void vehicle(std::size_t i) {
    std::vector<double> times{0.0};
    for (const Leg& leg : r_.vehicles[i].track.legs) times.push_back(leg.start_s);
    for (const DamageStep& step : r_.vehicles[i].damage) times.push_back(step.t_s);
    // Multiples of the step from whole numbers, so that samples of all things fall together.
    const auto steps = static_cast<std::int64_t>(r_.duration_s / setup_.step_s);
    double told = 0.0;
    for (std::int64_t k = 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) * setup_.step_s;
      const bool beat = heartbeat_s_ > 0.0 && t - told >= heartbeat_s_ - 1e-9;
      if (!beat && r_.vehicles[i].track.at(t).speed_mps == 0.0 && r_.vehicles[i].track.at(t - setup_.step_s).speed_mps == 0.0) continue;
      times.push_back(t);
      told = t;
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (const double t : times)
      if (t >= 0.0 && t <= r_.duration_s) addVehicle(i, t);
  }

  void gun(std::size_t i) {
    const GunRecord& gun = r_.guns[i];
    const auto beats = heartbeat_s_ > 0.0 ? static_cast<std::int64_t>(r_.duration_s / heartbeat_s_) : 0;
    for (std::int64_t k = 0; k <= beats; ++k) {
      const double t = static_cast<double>(k) * heartbeat_s_;
      out_.push_back({t, Kind::gun, static_cast<int>(i), k == 0, false, gun.muzzle_m, {}, gun.lineAt(t).first});
    }
  }

  void shell(std::size_t i) {
    const ShellRecord& shell = r_.shells[i];
    const auto steps = static_cast<std::int64_t>((shell.burst_s - shell.fired_s) / setup_.shell_step_s);
    for (std::int64_t k = 0; k <= steps; ++k) {
      const double t = shell.fired_s + static_cast<double>(k) * setup_.shell_step_s;
      if (k > 0 && t >= shell.burst_s) break;
      addShell(i, t, k == 0, false);
    }
    if (shell.burst_s > r_.duration_s) return;
    addShell(i, shell.burst_s, false, true);
    out_.push_back({shell.burst_s, Kind::burst, static_cast<int>(i), true, false, shell.burst_m, {}, 0.0});
  }

  void addShell(std::size_t i, double t, bool first, bool last) {
    if (t > r_.duration_s) return;
    const ShellRecord& shell = r_.shells[i];
    out_.push_back({t, Kind::shell, static_cast<int>(i), first, last, shell.at(t), shell.velocityAt(t), 0.0});
  }

  const Recording& r_;
  const ExportSetup& setup_;
  double heartbeat_s_;
  std::vector<Sample> out_;
};

}  // namespace

Expected<std::vector<Sample>> samplesOf(const Recording& recording, const ExportSetup& setup, double heartbeat_s) {
  for (const double step : {setup.step_s, setup.shell_step_s})
    if (!(step >= 0.01 && step <= 3600.0)) return fail(ErrorKind::usage, "the step of the export is " + shortest(step) + " s, outside 0.01 to 3600 s.");
  double count = static_cast<double>(recording.vehicles.size()) * recording.duration_s / setup.step_s;
  if (heartbeat_s > 0.0) count += static_cast<double>(recording.guns.size()) * recording.duration_s / heartbeat_s;
  for (const ShellRecord& shell : recording.shells) count += (shell.burst_s - shell.fired_s) / setup.shell_step_s + 3.0;
  if (count > kMaxExportSamples) return fail(ErrorKind::usage, "the export would have up to " + shortest(std::ceil(count)) + " samples, more than " + shortest(kMaxExportSamples) + ".", "Give a larger --step.");
  return Sampler(recording, setup, heartbeat_s).run();
}

Side sideOf(const Recording& recording, const ShellRecord& shell) {
  if (shell.gun >= 0 || shell.shooter < 0) return Side::friendly;
  return recording.vehicles[static_cast<std::size_t>(shell.shooter)].type.side;
}

std::string_view sideWord(Side side) { return side == Side::friendly ? "friendly" : side == Side::hostile ? "hostile" : "neutral"; }

std::string rounded(double value, int decimals) {
  // Never with an exponent: not every reader of these formats knows them.
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  std::string out(text, end);
  if (out.find('.') != std::string::npos) {
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

}  // namespace npsee::world
