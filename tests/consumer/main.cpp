// What an embedding program does with npsee::sim, each result on a line of its own:
// consumer PRESET TIME MISSION

#include <npsee/aiming.h>
#include <npsee/explosion.h>
#include <npsee/mission.h>
#include <npsee/projectile.h>
#include <npsee/units.h>

#include <cstdio>
#include <cstdlib>

namespace {

template <class T>
T orExit(npsee::Expected<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().text().c_str());
  std::exit(npsee::exitCode(result.error().kind));
}

void explode(const char* file, double time_s) {
  const npsee::Preset preset = orExit(npsee::loadPreset(file));
  const auto explosion = orExit(npsee::Explosion::compile(preset));
  npsee::ExactFrame frame;
  explosion->at(time_s, frame);
  std::size_t alive = 0;
  double highest_m = 0.0;
  for (std::size_t i = 0; i < frame.count; ++i) {
    if (frame.alive[i] == 0) continue;
    ++alive;
    if (frame.y[i] > highest_m) highest_m = frame.y[i];
  }
  std::printf("particles %zu alive %zu highest_m %.17g\n", explosion->particleCount(), alive, highest_m);
}

void shoot() {
  const npsee::Projectile shell = orExit(npsee::findProjectile("m107"));
  const auto ballistics = orExit(npsee::Ballistics::make(shell));
  npsee::Shot shot;
  shot.speed_mps = 300.0;
  shot.elevation_rad = 0.7;
  const npsee::Flight flight = ballistics.fly(shot);
  std::printf("range_m %.17g tof_s %.17g\n", flight.range_m, flight.time_of_flight_s);
  npsee::AimRequest request;
  request.speed_mps = shot.speed_mps;
  const auto solution = orExit(npsee::Aimer::make(ballistics, request)).low(5000.0);
  if (!solution) std::exit(1);
  std::printf("qe_rad %.17g miss_m %.3g\n", solution->shot.elevation_rad, solution->miss_m);
}

void fight(const char* file) {
  const npsee::Scenario scenario = orExit(npsee::loadScenario(file));
  const npsee::Recording recording = orExit(npsee::runMission(scenario));
  std::printf("events %zu shells %zu hash %s\n", recording.events.size(), recording.shells.size(), recording.hash.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: consumer PRESET TIME MISSION\n");
    return 2;
  }
  explode(argv[1], std::atof(argv[2]));
  shoot();
  fight(argv[3]);
}
