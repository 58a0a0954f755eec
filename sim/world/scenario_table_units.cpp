#include "sim/world/scenario_row.h"

namespace npsee::world {
namespace {

// Why a field has no effect with the others as they are; empty where it has.

template <Behaviour needed>
std::string_view unlessBehaviour(const VehicleSetup& vehicle) {
  return vehicle.behaviour == needed ? "" : "its behaviour is another";
}
std::string_view whenCarried(const ObserverSetup& observer) { return observer.vehicle.empty() ? "" : "his vehicle's counts"; }
std::string_view whenCertain(const Sensing& sensing) { return sensing.limited_belief ? "" : "what is seen is known for certain"; }

}  // namespace

const Struct& vehicleTypeTable() {
  static const Struct table = [] {
    Struct out = structOf<VehicleType>(
        "vehicle type", "A kind of vehicle. One with the index of a shipped type starts from that type's values and replaces it.",
        {
            field(&VehicleType::index, {.key = "index", .doc = "Number by which vehicles, `(mountedon 8)` and `(mission destroy 51)` name the type.", .hard = kIndexRange, .required = true}),
            field(&VehicleType::name, {.key = "name", .doc = "What people call it.", .hard = {0, 60}}),
            field(&VehicleType::side, {.key = "side", .doc = "Whose it is. Observers call fire by their mission orders, not by side."}),
            field(&VehicleType::target_class, {.key = "class", .doc = "Class of target, which decides what a weapon does to it."}),
            field(&VehicleType::length_m, {.key = "length", .doc = "Length over all.", .hard = {0.1, 500}, .unit = Unit::metre}),
            field(&VehicleType::width_m, {.key = "width", .doc = "Width.", .hard = {0.1, 500}, .unit = Unit::metre}),
            field(&VehicleType::height_m, {.key = "height", .doc = "Height; the observer looks for its upper half.", .hard = {0.1, 100}, .unit = Unit::metre}),
            field(&VehicleType::speed_mps, {.key = "speed", .doc = "Greatest speed on level ground.", .hard = {0, 400}, .unit = Unit::metre_per_second}),
            field(&VehicleType::turn_radps, {.key = "turn_rate", .doc = "Greatest rate of turn.", .hard = {0, 360}, .unit = Unit::degree_per_second}),
            field(&VehicleType::weapon, {.key = "weapon", .doc = "Id in weapons.dat of what it shoots back with; 0 is unarmed.", .hard = kIndexRange}),
            field(&VehicleType::model, {.key = "model", .doc = "Name of a model in assets/models; empty chooses by the class.", .hard = {0, 60}}),
        },
        "index");
    out.rebase = [](void* object) {
      auto& type = *static_cast<VehicleType*>(object);
      for (const VehicleType& shipped : shippedVehicleTypes())
        if (shipped.index == type.index) type = shipped;
    };
    return out;
  }();
  return table;
}

const Struct& vehicleTable() {
  static const Struct table = structOf<VehicleSetup>(
      "vehicle", "One vehicle and what it does.",
      {
          identity(&VehicleSetup::id, {.key = "id", .doc = "Name in the log.", .required = true}),
          field(&VehicleSetup::type, {.key = "type", .doc = "Index of its vehicle type.", .hard = kIndexRange, .required = true}),
          field(&VehicleSetup::at, {.key = "pos", .doc = "Where it starts.", .hard = {-1e6, 1e6}, .unit = Unit::metre, .required = true}),
          field(&VehicleSetup::heading_rad, {.key = "heading", .doc = "Heading at the start, clockwise from north (-z).", .hard = {-360, 360}, .unit = Unit::degree}),
          field(&VehicleSetup::speed_mps, {.key = "speed", .doc = "Wished speed; the type's greatest limits it.", .hard = {0, 400}, .unit = Unit::metre_per_second}),
          field(&VehicleSetup::behaviour, {.key = "behaviour", .doc = "static stands; straight keeps heading and speed; meander wanders and turns back at the sea and the world's edge; goals drives to its goals in turn; follow keeps behind another vehicle; user is driven by a person."}),
          field(&VehicleSetup::reaction, {.key = "reaction", .doc = "What it does when it notices fire: nothing, retire at high speed, return fire, or both."}),
          field(&VehicleSetup::goals, {.key = "goals", .doc = "Places to drive to in turn, of behaviour goals.", .hard = {0, 1000}, .unit = Unit::metre, .idle = idleIn<VehicleSetup, unlessBehaviour<Behaviour::goals>>}),
          field(&VehicleSetup::repeat_goals, {.key = "repeat_goals", .doc = "Whether the first goal follows the last one.", .idle = idleIn<VehicleSetup, unlessBehaviour<Behaviour::goals>>}),
          field(&VehicleSetup::follows, {.key = "follows", .doc = "Id of the vehicle ahead, of behaviour follow.", .hard = {0, 40}, .idle = idleIn<VehicleSetup, unlessBehaviour<Behaviour::follow>>}),
          field(&VehicleSetup::gap_m, {.key = "gap", .doc = "Distance kept to the vehicle ahead.", .hard = {1, 10000}, .unit = Unit::metre, .idle = idleIn<VehicleSetup, unlessBehaviour<Behaviour::follow>>}),
      },
      "id");
  return table;
}

const Struct& groupTable() {
  static const Struct table = structOf<VehicleGroup>(
      "group", "Vehicles at random places on land, with random headings and speeds, drawn from the mission's seed.",
      {
          identity(&VehicleGroup::id, {.key = "id", .doc = "Its vehicles are called id-1, id-2 and so on.", .required = true}),
          field(&VehicleGroup::type, {.key = "type", .doc = "Index of their vehicle type.", .hard = kIndexRange, .required = true}),
          field(&VehicleGroup::count, {.key = "count", .doc = "How many.", .hard = {1, static_cast<double>(kMaxVehicles)}, .required = true}),
          field(&VehicleGroup::from, {.key = "from", .doc = "One corner of the area they start in.", .hard = {-1e6, 1e6}, .unit = Unit::metre, .required = true}),
          field(&VehicleGroup::to, {.key = "to", .doc = "The opposite corner.", .hard = {-1e6, 1e6}, .unit = Unit::metre, .required = true}),
          field(&VehicleGroup::speed_min_mps, {.key = "speed_min", .doc = "Least wished speed.", .hard = {0, 400}, .unit = Unit::metre_per_second}),
          field(&VehicleGroup::speed_max_mps, {.key = "speed_max", .doc = "Greatest wished speed.", .hard = {0, 400}, .unit = Unit::metre_per_second}),
          field(&VehicleGroup::behaviour, {.key = "behaviour", .doc = "As of a vehicle, except goals and follow."}),
          field(&VehicleGroup::reaction, {.key = "reaction", .doc = "As of a vehicle."}),
      },
      "id");
  return table;
}

const Struct& gunTable() {
  static const Struct table = structOf<GunSetup>("gun", "One gun of a battery.",
                                                 {
                                                     identity(&GunSetup::id, {.key = "id", .doc = "Name in the log.", .required = true}),
                                                     field(&GunSetup::at, {.key = "pos", .doc = "Where it stands.", .hard = {-1e6, 1e6}, .unit = Unit::metre, .required = true}),
                                                 },
                                                 "id");
  return table;
}

const Struct& batteryTable() {
  BatterySetup initial;
  initial.id = "battery";
  static const Struct table = structOf<BatterySetup>(
      "battery", "Guns that fire together for one fire direction centre.",
      {
          identity(&BatterySetup::id, {.key = "id", .doc = "Name in the log."}),
          field(&BatterySetup::weapon, {.key = "weapon", .doc = "Id in weapons.dat: radii, muzzle velocity and kind of trajectory.", .hard = kIndexRange}),
          field(&BatterySetup::projectile, {.key = "projectile", .doc = "A shipped projectile of the ballistics library (m107), or a file; empty chooses by the weapon.", .hard = {0, 1000}}),
          field(&BatterySetup::charges, {.key = "charges", .doc = "Charges that may be used, weakest first; empty takes the one nearest to the weapon's muzzle velocity.", .hard = {0, 16}}),
          list(&BatterySetup::guns, gunTable(), {.key = "guns", .doc = "The guns.", .hard = {1, static_cast<double>(kMaxGuns)}, .required = true}),
          field(&BatterySetup::pe_range_m, {.key = "pe_range", .doc = "Probable error in range: half of the shells fall within it, on either side.", .hard = {0, 2000}, .unit = Unit::metre}),
          field(&BatterySetup::pe_deflection_m, {.key = "pe_deflection", .doc = "Probable error in deflection.", .hard = {0, 2000}, .unit = Unit::metre}),
          field(&BatterySetup::lay_time_s, {.key = "lay_time", .doc = "Time to lay a gun on new data.", .hard = {0, 3600}, .unit = Unit::second}),
          field(&BatterySetup::reload_time_s, {.key = "reload_time", .doc = "Time between two shots of a gun.", .hard = {0.05, 3600}, .unit = Unit::second}),
          field(&BatterySetup::rounds, {.key = "rounds", .doc = "Ammunition of each gun.", .hard = {0, 100000}}),
          field(&BatterySetup::muzzle_height_m, {.key = "muzzle_height", .doc = "Height of the muzzle over the ground.", .hard = {0, 50}, .unit = Unit::metre}),
          field(&BatterySetup::max_elevation_rad, {.key = "max_elevation", .doc = "Greatest elevation of the tubes.", .hard = {12, 90}, .unit = Unit::degree}),
          field(&BatterySetup::volley_rounds, {.key = "volley_rounds", .doc = "Rounds each gun fires in one volley of fire for effect.", .hard = {1, 100}}),
          field(&BatterySetup::preset, {.key = "preset", .doc = "Explosion preset of its bursts: a shipped name or a file; empty chooses by the weapon.", .hard = {0, 1000}}),
      },
      "id", initial);
  return table;
}

const Struct& sensingTable() {
  static const Struct table = structOf<Sensing>(
      "sensing", "How well an observer senses. The defaults are perfect; \"sensing\": \"perfect\" says so in one word.",
      {
          field(&Sensing::limited_belief, {.key = "limited_belief", .doc = "Whether belief in a contact falls with the logarithm of its range; false: what is seen is known for certain."}),
          field(&Sensing::belief_near, {.key = "belief_near", .doc = "Belief at the near range and closer.", .hard = {0, 1}, .unit = Unit::fraction, .idle = idleIn<Sensing, whenCertain>}),
          field(&Sensing::belief_far, {.key = "belief_far", .doc = "Belief at the far range and beyond.", .hard = {0, 1}, .unit = Unit::fraction, .idle = idleIn<Sensing, whenCertain>}),
          field(&Sensing::near_m, {.key = "near", .doc = "Range at which belief begins to fall.", .hard = {1, 100000}, .unit = Unit::metre, .idle = idleIn<Sensing, whenCertain>}),
          field(&Sensing::far_m, {.key = "far", .doc = "Range at which belief has fallen.", .hard = {1, 100000}, .unit = Unit::metre, .idle = idleIn<Sensing, whenCertain>}),
          field(&Sensing::hostile_belief, {.key = "hostile_belief", .doc = "Belief from which a contact counts as hostile.", .hard = {0, 1}, .unit = Unit::fraction}),
          field(&Sensing::location_cep_m, {.key = "location_cep", .doc = "Circular error probable of where he believes a target to be; one draw for each target.", .hard = {0, 5000}, .unit = Unit::metre}),
          field(&Sensing::own_cep_m, {.key = "own_cep", .doc = "Circular error probable of where he believes himself to be.", .hard = {0, 5000}, .unit = Unit::metre}),
          field(&Sensing::bearing_error_mil, {.key = "bearing_error", .doc = "Standard deviation of his spottings across the observer-target line.", .hard = {0, 800}, .unit = Unit::mil, .si = false}),
          field(&Sensing::range_error, {.key = "range_error", .doc = "Standard deviation of his spottings along the line, as a share of the distance.", .hard = {0, 1}, .unit = Unit::fraction}),
          field(&Sensing::fog, {.key = "fog", .doc = "Whether contrast falls with distance by the weather's visibility."}),
          field(&Sensing::contrast, {.key = "contrast", .doc = "Contrast of targets with what is behind them, near by.", .hard = {0, 1}, .unit = Unit::fraction}),
          field(&Sensing::contrast_threshold, {.key = "contrast_threshold", .doc = "Least contrast he can see.", .hard = {0.001, 1}, .unit = Unit::fraction}),
      });
  return table;
}

const Struct& orderTable() {
  static const Struct table = structOf<MissionOrder>("mission order", "What the observer is there for, as `(mission destroy 51)` in the thesis.",
                                                     {
                                                         field(&MissionOrder::action, {.key = "action", .doc = "What to do to vehicles of the type."}),
                                                         field(&MissionOrder::type, {.key = "type", .doc = "Index of the vehicle type.", .hard = kIndexRange, .required = true}),
                                                     });
  return table;
}

const Struct& observerTable() {
  static const Struct table = structOf<ObserverSetup>(
      "observer", "A forward observer.",
      {
          identity(&ObserverSetup::id, {.key = "id", .doc = "Name in the log.", .required = true}),
          field(&ObserverSetup::at, {.key = "pos", .doc = "Where he stands; with `vehicle` that vehicle's place counts.", .hard = {-1e6, 1e6}, .unit = Unit::metre, .required = true, .idle = idleIn<ObserverSetup, whenCarried>}),
          field(&ObserverSetup::type, {.key = "type", .doc = "Index of the vehicle type he is mounted on.", .hard = kIndexRange}),
          field(&ObserverSetup::vehicle, {.key = "vehicle", .doc = "Id of the vehicle that carries him; empty puts one of his type at his place.", .hard = {0, 40}}),
          field(&ObserverSetup::eye_height_m, {.key = "eye_height", .doc = "Height of his eyes over the ground.", .hard = {0, 100}, .unit = Unit::metre}),
          field(&ObserverSetup::max_range_m, {.key = "max_range", .doc = "Greatest distance he sees anything at.", .hard = {1, 100000}, .unit = Unit::metre}),
          field(&ObserverSetup::rules, {.key = "rules", .doc = "Own rules, or the thesis's facts file, loaded beside the shipped rules; forwardobserver.clp means the shipped facts where there is no such file.", .hard = {0, 1000}}),
          field(&ObserverSetup::shipped_rules, {.key = "shipped_rules", .doc = "false leaves the shipped rules out, so that only `rules` decides."}),
          object(&ObserverSetup::sensing, sensingTable(), {.key = "sensing", .doc = "How well he senses.", .word = "perfect"}),
          list(&ObserverSetup::missions, orderTable(), {.key = "missions", .doc = "His mission orders; where there are none they come from the facts file.", .hard = {0, 100}}),
          field(&ObserverSetup::method, {.key = "method", .doc = "How he engages; auto lets the rules choose."}),
          field(&ObserverSetup::suppress_s, {.key = "suppress_time", .doc = "Duration of suppression and of illumination.", .hard = {1, 3600}, .unit = Unit::second}),
          field(&ObserverSetup::batteries, {.key = "batteries", .doc = "Ids of the batteries he may call, in order of preference; empty means all.", .hard = {0, 100}}),
          field(&ObserverSetup::self_preservation, {.key = "self_preservation", .doc = "Whether he moves away from fire and from close hostiles."}),
          field(&ObserverSetup::human, {.key = "human", .doc = "A person calls the fire; the rules only watch and grade."}),
      },
      "id");
  return table;
}

}  // namespace npsee::world
