#include "sim/observer/mind.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace npsee::observer {
namespace {

/// Every fourth is friendly, every third of the others of an ordered type; the rest are hostile and nobody's target.
Contact vehicle(int id, int round) {
  Contact out;
  out.id = id;
  out.type = id % 4 == 0 ? 8 : id % 3 == 0 ? 51 : 54;
  out.type_name = "vehicle";
  out.hostile = id % 4 == 0 ? 0.0 : 1.0;
  out.friendly = 1.0 - out.hostile;
  out.range_m = 1000.0 + (id * 37 + round) % 3000;
  out.x_m = 25000.0 + out.range_m;
  out.z_m = 25000.0 + id;
  out.speed_mps = 8.0;
  return out;
}

/// All of 200 vehicles drive on at 8 m/s and are told at every tick of 0.05 s, as a mission does.
void drive(benchmark::State& state) {
  MindSetup setup;
  setup.orders = {{MissionAction::destroy, 51}};
  auto mind = Mind::make(setup);
  if (!mind) return state.SkipWithError(mind.error().text().c_str());
  std::vector<Decision> decisions;
  std::vector<Contact> contacts;
  for (int id = 0; id < static_cast<int>(state.range(0)); ++id) contacts.push_back(vehicle(id, 0));
  double time_s = 0.0;
  for (auto _ : state) {
    time_s += 0.05;
    for (Contact& contact : contacts) {
      contact.z_m = 25000.0 + 100.0 * contact.id + 8.0 * time_s;
      contact.range_m = 1000.0 + 8.0 * std::fmod(time_s + contact.id * 1.7, 300.0);
      mind->contact(contact);
    }
    decisions.clear();
    if (!mind->think(decisions)) return state.SkipWithError("the rules failed");
    benchmark::DoNotOptimize(decisions.data());
  }
}
BENCHMARK(drive)->ArgName("contacts")->Arg(20)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);

/// One think with `changed` of `contacts` vehicles moved since the last, a mission being open.
void think(benchmark::State& state) {
  const int contacts = static_cast<int>(state.range(0)), changed = static_cast<int>(state.range(1));
  MindSetup setup;
  setup.orders = {{MissionAction::destroy, 51}};
  auto made = Mind::make(setup);
  if (!made) return state.SkipWithError(made.error().text().c_str());
  Mind mind = std::move(*made);
  SelfFacts self;
  self.type = 8;
  mind.self(self);
  std::vector<Decision> decisions;
  for (int id = 0; id < contacts; ++id) mind.contact(vehicle(id, 0));
  if (const auto thought = mind.think(decisions); !thought) return state.SkipWithError(thought.error().text().c_str());
  for (const Decision& decision : decisions)
    if (decision.kind == Decision::Kind::call) {
      MissionFact mission;
      mission.mission = 1;
      mission.contact = decision.contact;
      mission.method = decision.method;
      mind.mission(mission);
    }
  int round = 0, next = 0;
  for (auto _ : state) {
    ++round;
    for (int i = 0; i < changed; ++i) {
      mind.contact(vehicle(next, 40 * round));
      next = (next + 7) % contacts;
    }
    decisions.clear();
    if (!mind.think(decisions)) return state.SkipWithError("the rules failed");
    benchmark::DoNotOptimize(decisions.data());
  }
}
BENCHMARK(think)->ArgNames({"contacts", "changed"})->Args({20, 2})->Args({200, 0})->Args({200, 5})->Args({200, 20})->Args({200, 200})->Args({2000, 20})->Unit(benchmark::kMicrosecond);

/// Making a mind with the shipped rules, and with own rules that are tried in a child process first.
void make(benchmark::State& state) {
  MindSetup setup;
  setup.orders = {{MissionAction::destroy, 51}};
  if (state.range(0) != 0) {
    setup.rules = "(defrule greet (contact (id ?id)) => (warn ?id))";
    setup.rules_name = "own.clp";
  }
  for (auto _ : state) {
    auto mind = Mind::make(setup);
    if (!mind) return state.SkipWithError(mind.error().text().c_str());
    benchmark::DoNotOptimize(mind);
  }
}
BENCHMARK(make)->ArgName("own")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace npsee::observer

BENCHMARK_MAIN();
