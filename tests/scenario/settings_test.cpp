// `--set PATH=VALUE` of missions.

#include "tests/scenario/sample.h"

#include <gtest/gtest.h>

namespace npsee {
namespace {

using world::Field;
using world::FieldType;
using world::Struct;

std::string errorOf(const std::string& setting) {
  Scenario s = test::sampleScenario();
  const auto applied = applySetting(s, setting);
  EXPECT_EQ(s, test::sampleScenario()) << "unchanged where it is refused";
  if (applied) return "";
  EXPECT_EQ(applied.error().kind, ErrorKind::usage);
  return applied.error().text();
}

Scenario with(const std::string& setting) {
  Scenario s = test::sampleScenario();
  const auto applied = applySetting(s, setting);
  EXPECT_TRUE(applied) << applied.error().text();
  return s;
}

/// Sets every scalar below `object` to another value, and checks that it and nothing else has changed.
void setAll(const Struct& table, const void* object, const std::string& path) {
  for (const Field& field : table.fields) {
    const std::string here = path + std::string(field.key);
    if (field.type == FieldType::object) setAll(*field.child, field.partOf(object), here + '.');
    if (field.type == FieldType::list) setAll(*field.child, field.itemOf(object, 0), here + ".0.");
    if (!field.scalar() || field.type == FieldType::parameters) continue;
    Scenario s = test::sampleScenario();
    const auto value = test::another(field, field.read(object));
    const auto applied = applySetting(s, here + '=' + world::fieldText(field, value));
    ASSERT_TRUE(applied) << here << ": " << applied.error().text();
    EXPECT_FALSE(s == test::sampleScenario()) << here;
    const auto back = applySetting(s, here + '=' + world::fieldText(field, field.read(object)));
    // An empty id cannot be typed, and an index that becomes another's changes nothing else.
    ASSERT_TRUE(back) << here << ": " << back.error().text();
    EXPECT_EQ(s, test::sampleScenario()) << here;
  }
}

TEST(MissionSettings, ReachEveryValueOfTheTable) {
  const Scenario sample = test::sampleScenario();
  setAll(world::missionTable(), &sample, "");
}

TEST(MissionSettings, FindElementsByIdOrPosition) {
  EXPECT_EQ(with("world.weather.visibility=800").world.weather.visibility_m, 800.0);
  EXPECT_EQ(with("world.weather.visibility=1.5km").world.weather.visibility_m, 1500.0);
  EXPECT_EQ(with("observers.fo1.sensing.location_cep=200").observers[0].sensing.location_cep_m, 200.0);
  EXPECT_EQ(with("observers.0.sensing.bearing_error=5").observers[0].sensing.bearing_error_mil, 5.0);
  EXPECT_DOUBLE_EQ(with("observers.0.sensing.bearing_error=9deg").observers[0].sensing.bearing_error_mil, 160.0);
  EXPECT_EQ(with("vehicles.t72-1.pos=25400,25000").vehicles[0].at, (Place{25400, 25000}));
  EXPECT_EQ(with("vehicles.t72-1.pos=[25400,25000]").vehicles[0].at, (Place{25400, 25000}));
  EXPECT_EQ(with("batteries.alpha.guns.gun1.pos=1,2").batteries[0].guns[0].at, (Place{1, 2}));
  EXPECT_EQ(with("batteries.alpha.charges=3W, 4W").batteries[0].charges, (std::vector<std::string>{"3W", "4W"}));
  EXPECT_EQ(with("vehicles.t72-1.goals=1,2;3,4").vehicles[0].goals, (std::vector<Place>{{1, 2}, {3, 4}}));
  EXPECT_DOUBLE_EQ(with("vehicles.t72-1.heading=1600mil").vehicles[0].heading_rad, kPi / 2.0);
  EXPECT_EQ(with("observers.fo1.missions.0.type=8").observers[0].missions[0].type, 8);
}

TEST(MissionSettings, ChangeTheTerrainFunctionsNumbers) {
  Scenario s = with("world.terrain.params.crest_height=140");
  EXPECT_EQ(s.world.terrain.params.at("crest_height"), 140.0);
  ASSERT_TRUE(applySetting(s, "world.terrain.params.axis=x"));
  EXPECT_EQ(s.world.terrain.axis, "x");
  EXPECT_EQ(errorOf("world.terrain.params.axis=y"), "--set world.terrain.params.axis=y: params' axis is \"y\", but must be x or z.");
}

TEST(MissionSettings, TakeObjectsAndListsAsJson) {
  EXPECT_EQ(with(R"(observers.fo1.missions=[{"type":8},{"type":52,"action":"special"}])").observers[0].missions.size(), 2u);
  Scenario s = with("observers.fo1.sensing.location_cep=200");
  ASSERT_TRUE(applySetting(s, "observers.fo1.sensing=perfect"));
  EXPECT_EQ(s, test::sampleScenario());
  EXPECT_TRUE(with(R"(expect=[{"event":"destroyed"}])").expect.size() == 1);
  EXPECT_TRUE(with("vehicles=[]").vehicles.empty());
  EXPECT_EQ(errorOf(R"(observers.fo1.missions=[{"typ":8}])"), "--set observers.fo1.missions=[{\"typ\":8}]: /0/typ: a mission order has no such key.\n  Did you mean type?");
}

TEST(MissionSettings, MakeAShippedTypeTheMissionsOwn) {
  const Scenario s = with("vehicle_types.51.speed=20");
  ASSERT_EQ(s.types.size(), 2u);
  EXPECT_EQ(s.types[1].name, "T-72");
  EXPECT_EQ(s.types[1].speed_mps, 20.0);
}

TEST(MissionSettings, NameWhatIsWrongAndWhatIsNearest) {
  EXPECT_EQ(errorOf("nothing"), "--set nothing: this is not PATH=VALUE.\n  For example --set world.weather.visibility=800 or --set vehicles.t72-1.pos=25400,25000.");
  EXPECT_EQ(errorOf("world.weather.visibilty=800"),
            "--set world.weather.visibilty=800: there is no key \"visibilty\" in world.weather. Did you mean world.weather.visibility?\n  There are visibility, night, night_contrast, night_range and wind.");
  EXPECT_TRUE(errorOf("observers.fo2.type=8").starts_with("--set observers.fo2.type=8: there is no observer \"fo2\" in observers. Did you mean observers.fo1?")) << errorOf("observers.fo2.type=8");
  EXPECT_TRUE(errorOf("observers.1.type=8").starts_with("--set observers.1.type=8: there is no observer \"1\" in observers.")) << errorOf("observers.1.type=8");
  EXPECT_EQ(errorOf("seed.x=1"), "--set seed.x=1: seed has no parts.");
  EXPECT_TRUE(errorOf("vehicles.t72-1=3").starts_with("--set vehicles.t72-1=3: this names a whole vehicle.\n  Name one of its keys: id, type, pos,"));
  EXPECT_EQ(errorOf("world=3"), "--set world=3: world holds other values; name one of them, or write JSON.");
  EXPECT_EQ(errorOf("seed=abc"), "--set seed=abc: seed: \"abc\" is not a whole number.");
  EXPECT_EQ(errorOf("duration=1 m"), "--set duration=1 m: duration: \"m\" is not a unit for this value; units are s, ms and min.");
  EXPECT_EQ(errorOf("duration=0"), "--set duration=0: duration is 0 s, below the limit of 0.05 s.");
  EXPECT_EQ(errorOf("vehicles.t72-1.pos=1"), "--set vehicles.t72-1.pos=1: pos: \"1\" is not two numbers X,Z.");
  EXPECT_EQ(errorOf("world.weather.wind=1,2"), "--set world.weather.wind=1,2: wind: \"1,2\" is not three numbers X,Y,Z.");
  EXPECT_EQ(errorOf("world.weather.night=maybe"), "--set world.weather.night=maybe: night: \"maybe\" is neither true nor false.");
  EXPECT_EQ(errorOf("facts=../x"), "--set facts=../x: facts is \"../x\", but a mission names files in its own folder or below; .. is refused.");
  EXPECT_TRUE(errorOf("fdc.trajectory=hi").starts_with("--set fdc.trajectory=hi: trajectory cannot be \"hi\"; it is one of auto, low and high."));
}

}  // namespace
}  // namespace npsee
