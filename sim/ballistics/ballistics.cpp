#include <npsee/ballistics.h>

#include "sim/ballistics/angles.h"
#include "sim/ballistics/setup.h"
#include "sim/core/elementary.h"
#include "sim/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace npsee {

using namespace ballistics;

struct Ballistics::Data {
  std::shared_ptr<const Projectile> projectile;
  Conditions conditions;
  Setup setup;
};

namespace {

/// Flights a thread takes at a time: long enough to keep the lanes full, short enough to share evenly.
constexpr std::size_t kBatch = 256;
/// More are never started.
constexpr int kMostThreads = 256;

class NodeRecorder final : public Recorder {
 public:
  NodeRecorder(const Setup& setup, std::vector<FlightPath::Node>& nodes, std::vector<double>& spins) : setup_(setup), nodes_(nodes), spins_(spins) {}
  void step(const Step& step) override {
    FlightPath::Node node{step.t, step.h, {}};
    denseOutput(step, setup_.integration.integrator != Integrator::dormand_prince, node.c);
    nodes_.push_back(node);
    if (!setup_.closed_form_spin) return;
    if (spins_.empty()) spins_.push_back(closedFormSpin(setup_, step.y0, step.t));
    spins_.push_back(closedFormSpin(setup_, step.y1, step.t + step.h));
  }

 private:
  const Setup& setup_;
  std::vector<FlightPath::Node>& nodes_;
  std::vector<double>& spins_;
};

std::string shown(double value, const char* unit) { return shortest(value) + (*unit ? std::string(" ") + unit : std::string()); }

void within(std::vector<Fault>& faults, const char* what, double value, double low, double high, const char* unit, const char* remedy = "") {
  if (value >= low && value <= high) return;
  faults.push_back({.what = std::string(what) + " is " + shown(value, unit) + ", outside " + shortest(low) + " to " + shown(high, unit) + ".", .remedy = remedy, .file = {}, .line = 0, .pointer = {}});
}

std::vector<Fault> conditionFaults(const Conditions& c, const Integration& i) {
  std::vector<Fault> faults;
  if (!c.atmosphere.icao) {
    within(faults, "the density of the air", c.atmosphere.density_kgm3, 0.0, 100.0, "kg/m3", "Air at sea level has 1.225 kg/m3.");
    within(faults, "the speed of sound", c.atmosphere.sound_speed_mps, 1.0, 10000.0, "m/s");
  }
  if (c.gravity_mps2 != 0.0) within(faults, "gravity", c.gravity_mps2, 0.01, 100.0, "m/s2", "On the ground it is 9.80665 m/s2.");
  if (c.has_latitude) within(faults, "the latitude", c.latitude_rad * 180.0 / kPi, -90.0, 90.0, "deg");
  if (c.coriolis && !c.has_latitude) faults.push_back({.what = "the Coriolis force needs a latitude.", .remedy = "Give one, e.g. --latitude 36deg.", .file = {}, .line = 0, .pointer = {}});
  within(faults, "the altitude of the muzzle", c.muzzle_altitude_m, -5000.0, 20000.0, "m");
  within(faults, "the height of the target", c.target_height_m, -20000.0, 100000.0, "m");
  within(faults, "the tolerance", i.tolerance_m, 1e-9, 1000.0, "m", "0.0003 m is the default.");
  within(faults, "the integration step", i.step_s, 1e-4, 10.0, "s", "0.1 s is the default.");
  within(faults, "the time limit", i.time_limit_s, 1e-3, 10000.0, "s");
  if (i.step_limit < 1) faults.push_back({.what = "the limit of steps is below 1.", .remedy = {}, .file = {}, .line = 0, .pointer = {}});
  return faults;
}

std::vector<Fault> shotFaults(const Shot& shot) {
  std::vector<Fault> faults;
  within(faults, "the muzzle velocity", shot.speed_mps, 0.01, 10000.0, "m/s", "Choose a charge, or a speed that a gun can have.");
  // A quarter turn that was converted may be a rounding beyond itself.
  const double elevation = shot.elevation_rad * 3200.0 / kPi;
  if (!(std::fabs(elevation) <= 1600.0 + 1e-9)) within(faults, "the elevation", elevation, -1600.0, 1600.0, "mil", "1600 mil (90 deg) is straight up; beyond the vertical turn the azimuth round instead.");
  within(faults, "the azimuth", shot.azimuth_rad, -1e4, 1e4, "rad");
  for (const double w : {shot.wind_mps.x, shot.wind_mps.y, shot.wind_mps.z}) within(faults, "the wind", w, -1000.0, 1000.0, "m/s", "Give the velocity of the air as range, up, right in m/s.");
  for (const double p : {shot.muzzle_m.x, shot.muzzle_m.y, shot.muzzle_m.z}) within(faults, "the muzzle's place", p, -1e8, 1e8, "m");
  const Factors& f = shot.factors;
  within(faults, "the form factor", f.form, 0.0, 100.0, "");
  within(faults, "the lift factor", f.lift, 0.0, 100.0, "");
  within(faults, "the Magnus factor", f.magnus, -100.0, 100.0, "");
  within(faults, "the yaw drag factor", f.yaw_drag, 0.0, 100.0, "");
  return faults;
}

/// Flies those of the shots that are possible; the others' flights are empty.
void flyBatch(const Setup& setup, std::span<const Shot> shots, std::span<Flight> flights) {
  std::vector<ShotConstants> constants;
  std::vector<std::size_t> place;
  constants.reserve(shots.size());
  place.reserve(shots.size());
  for (std::size_t i = 0; i < shots.size(); ++i) {
    flights[i] = {};
    if (!shotFaults(shots[i]).empty()) continue;
    constants.push_back(constantsOf(setup, shots[i]));
    place.push_back(i);
  }
  std::vector<Progress> progress(constants.size());
  if (setup.integration.integrator == Integrator::dormand_prince) {
    if (!constants.empty()) bestKernels().fly_many(setup, constants.data(), progress.data(), constants.size());
  } else {
    for (std::size_t k = 0; k < constants.size(); ++k) flyFixed(setup, constants[k], progress[k], nullptr);
  }
  for (std::size_t k = 0; k < place.size(); ++k) flights[place[k]] = flightOf(setup, shots[place[k]], progress[k]);
}

}  // namespace

std::span<const std::string_view> flightModelNames() {
  static constexpr std::string_view names[] = {"vacuum", "point-mass", "simplified-modified-point-mass", "modified-point-mass"};
  return names;
}
std::span<const std::string_view> integratorNames() {
  static constexpr std::string_view names[] = {"dormand-prince", "predictor-corrector", "rk4"};
  return names;
}
std::span<const std::string_view> gravityModelNames() {
  static constexpr std::string_view names[] = {"flat", "inverse-square", "curved"};
  return names;
}

double Conditions::gravityAtMuzzle() const {
  if (gravity_mps2 != 0.0) return gravity_mps2;
  if (!has_latitude || gravity != GravityModel::curved) return kStandardGravity_mps2;
  // cos 2L = 1 - 2 sin^2 L. Source: docs/physics.md, "Gravity".
  double sine = 0.0, cosine = 1.0;
  sineCosine(latitude_rad, sine, cosine);
  return kStandardGravity_mps2 * (1.0 - 0.0026 * (1.0 - 2.0 * sine * sine));
}

Vec3 worldFromFlight(const Vec3& v, double azimuth_rad) {
  double sine = 0.0, cosine = 1.0;
  sineCosine(azimuth_rad, sine, cosine);
  return {v.x * sine + v.z * cosine, v.y, v.z * sine - v.x * cosine};
}

Vec3 flightFromWorld(const Vec3& v, double azimuth_rad) {
  double sine = 0.0, cosine = 1.0;
  sineCosine(azimuth_rad, sine, cosine);
  return {v.x * sine - v.z * cosine, v.y, v.x * cosine + v.z * sine};
}

Expected<Ballistics> Ballistics::make(const Projectile& projectile, const Conditions& conditions, FlightModel model, const Integration& integration) {
  if (std::vector<Fault> faults = validate(projectile); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  if (std::vector<Fault> faults = conditionFaults(conditions, integration); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::usage, std::move(faults)});
  return Ballistics(std::make_shared<const Data>(Data{std::make_shared<const Projectile>(projectile), conditions, setupOf(projectile, conditions, model, integration)}));
}

Ballistics::Ballistics(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
Ballistics::~Ballistics() = default;
Ballistics::Ballistics(const Ballistics&) = default;
Ballistics& Ballistics::operator=(const Ballistics&) = default;

Ballistics Ballistics::onto(double target_height_m) const {
  Data data = *data_;
  data.conditions.ground = nullptr;
  data.conditions.target_height_m = target_height_m;
  data.setup.ground = nullptr;
  data.setup.target_height_m = target_height_m;
  return Ballistics(std::make_shared<const Data>(std::move(data)));
}

Expected<void> Ballistics::checkShot(const Shot& shot) const {
  if (std::vector<Fault> faults = shotFaults(shot); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::usage, std::move(faults)});
  return {};
}

Flight Ballistics::fly(const Shot& shot) const {
  if (!shotFaults(shot).empty()) return {};
  const Setup& setup = data_->setup;
  const ShotConstants constants = constantsOf(setup, shot);
  Progress progress;
  if (setup.integration.integrator == Integrator::dormand_prince) bestKernels().fly_one(setup, constants, progress, nullptr);
  else flyFixed(setup, constants, progress, nullptr);
  return flightOf(setup, shot, progress);
}

FlightPath Ballistics::path(const Shot& shot) const {
  FlightPath out;
  out.shot_ = shot;
  if (!shotFaults(shot).empty()) return out;
  const Setup& setup = data_->setup;
  const ShotConstants constants = constantsOf(setup, shot);
  Progress progress;
  NodeRecorder recorder(setup, out.nodes_, out.spins_);
  if (setup.integration.integrator == Integrator::dormand_prince) bestKernels().fly_one(setup, constants, progress, &recorder);
  else flyFixed(setup, constants, progress, &recorder);
  out.flight_ = flightOf(setup, shot, progress);
  out.closed_form_spin_ = setup.closed_form_spin;
  return out;
}

void Ballistics::flyMany(std::span<const Shot> shots, std::span<Flight> flights, int threads) const {
  const std::size_t batches = (shots.size() + kBatch - 1) / kBatch;
  const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  parallelFor(std::min(wanted, kMostThreads), batches, [&](std::size_t batch) {
    const std::size_t begin = batch * kBatch, size = std::min(kBatch, shots.size() - begin);
    flyBatch(data_->setup, shots.subspan(begin, size), flights.subspan(begin, size));
  });
}

const Projectile& Ballistics::projectile() const { return *data_->projectile; }
const Conditions& Ballistics::conditions() const { return data_->conditions; }
FlightModel Ballistics::model() const { return data_->setup.model; }
const Integration& Ballistics::integration() const { return data_->setup.integration; }

FlightPath::State FlightPath::at(double time_s) const {
  State state;
  if (nodes_.empty()) return state;
  const double end = flight_.end == FlightEnd::impact ? flight_.time_of_flight_s : nodes_.back().start_s + nodes_.back().step_s;
  const double t = time_s > 0.0 ? std::min(time_s, end) : 0.0;
  auto after = std::upper_bound(nodes_.begin(), nodes_.end(), t, [](double value, const Node& node) { return value < node.start_s; });
  const Node& node = after == nodes_.begin() ? *after : *std::prev(after);
  const double theta = (t - node.start_s) / node.step_s, rest = 1.0 - theta;
  double y[kStates];
  for (std::size_t i = 0; i < kStates; ++i) y[i] = node.c[0][i] + theta * (node.c[1][i] + rest * (node.c[2][i] + theta * (node.c[3][i] + rest * node.c[4][i])));
  state.position_m = {y[0], y[1], y[2]};
  state.velocity_mps = {y[3], y[4], y[5]};
  state.spin_radps = y[6];
  if (closed_form_spin_) {
    const auto i = static_cast<std::size_t>(&node - nodes_.data());
    state.spin_radps = spins_[i] + theta * (spins_[i + 1] - spins_[i]);
  }
  return state;
}

FlightPath::State FlightPath::inWorld(double time_s) const {
  State state = at(time_s);
  state.position_m = shot_.muzzle_m + worldFromFlight(state.position_m, shot_.azimuth_rad);
  state.velocity_mps = worldFromFlight(state.velocity_mps, shot_.azimuth_rad);
  return state;
}

}  // namespace npsee
