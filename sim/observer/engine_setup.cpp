#include "sim/observer/engine.h"

#include "sim/world/scenario_files.h"

#include <algorithm>

namespace npsee {

using namespace observer;

namespace {

/// The error with faults that name no place put at a value of the mission file.
Error at(const std::string& pointer, Error error) {
  for (Fault& fault : error.faults)
    if (fault.file.empty() && fault.pointer.empty()) fault.pointer = pointer;
  return error;
}

}  // namespace

Expected<void> Mission::State::setUp(const Scenario& given) {
  std::vector<Fault> doubts;
  auto resolved = world::resolved(given, &doubts);
  if (!resolved) return tl::unexpected(resolved.error());
  rec.scenario = std::move(*resolved);
  const Scenario& sc = rec.scenario;
  if (auto faults = validate(sc); !faults.empty()) return tl::unexpected(Error{ErrorKind::input, std::move(faults)});

  for (const Fault& doubt : doubts) log(EventKind::warning, 0.0).fields = {{"text", doubt.what}};

  auto terrain = Terrain::make(world::missionTerrain(sc), sc.world.size_x_m, sc.world.size_z_m, sc.world.sea_level_m);
  if (!terrain) return tl::unexpected(at("/world/terrain", terrain.error()));
  rec.terrain = std::move(*terrain);
  if (sc.world.size_x_m == 0.0 || sc.world.size_z_m == 0.0) {
    // The terrain file says how large the world is, and with that whether everything lies in it.
    rec.scenario.world.size_x_m = rec.terrain.sizeX();
    rec.scenario.world.size_z_m = rec.terrain.sizeZ();
    if (auto faults = validate(sc); !faults.empty()) return tl::unexpected(Error{ErrorKind::input, std::move(faults)});
  }
  auto read = world::missionWeapons(sc);
  if (!read) return tl::unexpected(read.error());
  weapons = std::move(*read);
  types = vehicleTypes(sc);

  auto made = world::Vehicles::make(sc, rec.terrain, rec.vehicles);
  if (!made) return tl::unexpected(made.error());
  vehicles.emplace(std::move(*made));
  hits.resize(rec.vehicles.size());
  for (std::size_t v = 0; v < rec.vehicles.size(); ++v)
    if (rec.vehicles[v].type.side == Side::friendly) friendlies.push_back(static_cast<int>(v));
  if (auto done = setUpBatteries(); !done) return done;
  return setUpPosts();
}

Expected<void> Mission::State::setUpBatteries() {
  const Scenario& sc = rec.scenario;
  for (std::size_t b = 0; b < sc.batteries.size(); ++b) {
    const BatterySetup& setup = sc.batteries[b];
    Battery& battery = batteries.emplace_back();
    battery.setup = &setup;
    battery.weapon = weaponOf(setup.weapon);
    if (!battery.weapon)
      return tl::unexpected(at("/batteries/" + std::to_string(b) + "/weapon", npsee::fail(ErrorKind::input, "battery " + setup.id + " has weapon " + std::to_string(setup.weapon) + ", which the weapons file does not list.",
                                                                                         "`npsee weapons FILE` shows the ids there are.").value()));
    // Lasers and bombs need no fire direction; what they do instead is in engine_lines.cpp.
    if (battery.weapon->path != PathType::linear && battery.weapon->path != PathType::gravity_bomb) {
      auto fdc = FireDirection::make(world::missionBattery(sc, b), *battery.weapon, rec.terrain, sc.world.weather, sc.fdc);
      if (!fdc) return tl::unexpected(at("/batteries/" + std::to_string(b), fdc.error()));
      battery.fdc.emplace(std::move(*fdc));
    }
    if (battery.fdc)
      for (const Fault& warning : battery.fdc->warnings())
        log(EventKind::warning, 0.0).fields = {{"battery", setup.id}, {"text", warning.what}};
    // Tubes stand towards the observers' country at first: the centre of the world.
    const Vec3 centre{0.5 * sc.world.size_x_m, 0.0, 0.5 * sc.world.size_z_m};
    for (const GunSetup& gun : setup.guns) {
      const Vec3 foot{gun.at.x_m, rec.terrain.surface(gun.at.x_m, gun.at.z_m), gun.at.z_m};
      const Vec3 muzzle{foot.x, foot.y + setup.muzzle_height_m, foot.z};
      const double azimuth = bearing(muzzle, centre);
      GunRecord record{gun.id, static_cast<int>(b), muzzle, {}};
      record.lays.push_back({0.0, 0.0, azimuth, 0.3});
      battery.pieces.push_back({Gun(gun, setup, muzzle, azimuth), static_cast<int>(rec.guns.size())});
      rec.guns.push_back(std::move(record));
    }
  }
  return {};
}

Expected<void> Mission::State::setUpPosts() {
  const Scenario& sc = rec.scenario;
  int next_carrier = static_cast<int>(rec.vehicles.size());
  for (const ObserverSetup& setup : sc.observers)
    if (setup.vehicle.empty()) --next_carrier;
  for (std::size_t o = 0; o < sc.observers.size(); ++o) {
    const ObserverSetup& setup = sc.observers[o];
    Post& post = posts.emplace_back();
    post.setup = &setup;
    post.human = setup.human;
    post.vehicle = setup.vehicle.empty() ? next_carrier++ : rec.findVehicle(setup.vehicle);
    post.knows.resize(rec.vehicles.size());
    const auto entity = static_cast<std::uint32_t>(o);
    const Normals own = normals(sc.seed, entity, Purpose::own_location, 0);
    const double own_sigma = sigmaOfCep(setup.sensing.own_cep_m), sigma = sigmaOfCep(setup.sensing.location_cep_m);
    post.own_error_m = {own_sigma * own.a, 0.0, own_sigma * own.b};
    for (std::size_t v = 0; v < rec.vehicles.size(); ++v) {
      const Normals n = normals(sc.seed, entity, Purpose::location, static_cast<std::uint32_t>(v));
      post.knows[v].error_m = post.own_error_m + Vec3{sigma * n.a, 0.0, sigma * n.b};
    }
    for (const std::string& name : setup.batteries)
      for (std::size_t b = 0; b < sc.batteries.size(); ++b)
        if (sc.batteries[b].id == name) post.batteries.push_back(static_cast<int>(b));
    if (setup.batteries.empty())
      for (std::size_t b = 0; b < sc.batteries.size(); ++b) post.batteries.push_back(static_cast<int>(b));

    MindSetup mind;
    mind.shipped_rules = setup.shipped_rules;
    mind.orders = setup.missions;
    mind.danger_close_m = sc.fdc.danger_close_m;
    mind.hostile_belief = setup.sensing.hostile_belief;
    mind.max_missions = static_cast<int>(std::max<std::size_t>(1, post.batteries.size()));
    if (!setup.rules.empty()) {
      auto text = world::readNamed(sc.folder, setup.rules);
      if (!text) return tl::unexpected(text.error());
      mind.rules = std::move(text->text);
      mind.rules_name = std::move(text->name);
    }
    auto made = Mind::make(mind);
    if (!made) return tl::unexpected(made.error());
    post.mind.emplace(std::move(*made));
    rec.observers.push_back({setup.id, post.vehicle, setup.eye_height_m, {}});
  }
  return {};
}

}  // namespace npsee
