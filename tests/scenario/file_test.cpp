// Mission files: what is read, what is written, and every message about what is wrong.

#include "tests/scenario/sample.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace npsee {
namespace {

namespace fs = std::filesystem;

const std::string kData = std::string(NPSEE_SOURCE_DIR) + "/tests/scenario/data/";

std::string errorOf(const std::string& text) {
  const auto read = parseScenario(text, "m.json");
  return read ? std::string() : read.error().text();
}

/// Faults of the sample with one member changed in its JSON.
template <class Change>
std::string errorWith(const Change& change) {
  auto json = nlohmann::ordered_json::parse(scenarioText(test::sampleScenario()));
  change(json);
  return errorOf(json.dump(2));
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << part << "\" is not in:\n" << text;
}

TEST(MissionFile, TheOlderFormatLoadsAsItStands) {
  const auto read = loadScenario(kData + "npsnet_scenario.json");
  ASSERT_TRUE(read) << read.error().text();
  const Scenario& s = *read;
  EXPECT_EQ(s.name, "ridge-high-angle");
  EXPECT_EQ(s.seed, 1993);
  EXPECT_EQ(s.duration_s, 400.0);
  EXPECT_EQ(s.world.terrain.kind, TerrainKind::function);
  EXPECT_EQ(s.world.terrain.expression, "ridge");
  EXPECT_EQ(s.world.terrain.axis, "z");
  EXPECT_EQ(s.world.terrain.params, (std::map<std::string, double>{{"crest_x", 25000}, {"crest_height", 200}, {"foot_before", 400}, {"foot_after", 300}}));
  EXPECT_EQ(s.world.weather.visibility_m, 20000.0);
  ASSERT_EQ(s.types.size(), 2u);
  EXPECT_EQ(s.types[1].height_m, 2.2);
  EXPECT_EQ(s.types[0].target_class, TargetClass::light_armor) << "an M577 stays one where the file says only its name and side";
  ASSERT_EQ(s.vehicles.size(), 1u);
  EXPECT_EQ(s.vehicles[0].at, (Place{25400, 25000}));
  EXPECT_DOUBLE_EQ(s.vehicles[0].heading_rad, 1.5 * kPi);
  ASSERT_EQ(s.batteries.size(), 1u);
  EXPECT_EQ(s.batteries[0].id, "battery");
  ASSERT_EQ(s.batteries[0].guns.size(), 4u);
  EXPECT_EQ(s.batteries[0].guns[3].at, (Place{20400, 25015}));
  ASSERT_EQ(s.observers.size(), 1u);
  EXPECT_EQ(s.observers[0].id, "fo1");
  EXPECT_TRUE(s.observers[0].sensing.perfect());
  EXPECT_EQ(s.observers[0].method, FireMethod::adjust_fire);
  EXPECT_EQ(s.observers[0].missions, (std::vector<MissionOrder>{{MissionAction::destroy, 51}}));
  EXPECT_EQ(s.fdc, FdcSetup{}) << "table_step null means the default";
  ASSERT_EQ(s.expect.size(), 3u);
  EXPECT_EQ(s.expect[1].within_of, "t72-1");
  EXPECT_EQ(s.expect[1].within_m, 60.0);
  EXPECT_TRUE(s.expect[2].negated);
  EXPECT_EQ(s.expect[2].text, "{\"not\":{\"event\":\"fire\",\"trajectory\":\"low\"}}");
  EXPECT_EQ(s.expect[0].line, 10);
}

TEST(MissionFile, TheOlderFormatIsWrittenInOurs) {
  const auto read = loadScenario(kData + "npsnet_scenario.json");
  ASSERT_TRUE(read);
  const std::string text = scenarioText(*read);
  EXPECT_TRUE(text.starts_with("{\n  \"npsee_mission\": 1,\n")) << text;
  EXPECT_TRUE(contains(text, "\"batteries\": [")) << text;
  const auto again = parseScenario(text, "again", read->folder);
  ASSERT_TRUE(again) << again.error().text() << text;
  EXPECT_EQ(*again, *read);
}

TEST(MissionFile, TheOlderFormatHasOneTickAndNoPlaceOnEarth) {
  const std::string start = R"({"format":"npsnet-scenario/1",)";
  EXPECT_EQ(errorOf(start + R"("dt":0.05,"world":{"georef":{"lat0":0,"lon0":0.0,"mapping":"topographic"}}})"), "");
  EXPECT_EQ(errorOf(start + R"("dt":0.1})"), "m.json:1: /dt: dt is 0.1, but the tick is always 0.05 s.\n  Leave dt out.");
  EXPECT_EQ(errorOf(start + R"("world":{"georef":{"lat0":48.1,"lon0":0}}})"),
            "m.json:1: /world/georef: the world is synthetic and has no place on Earth, so lat0 and lon0 must be 0.\n  Leave georef out.");
  EXPECT_TRUE(contains(errorOf(R"({"format":"npsnet-scenario/2"})"), "/format: the format is \"npsnet-scenario/2\", which this program does not know."));
}

TEST(MissionFile, OurFormatKnowsNeitherSingularsNorTheOldKeys) {
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"battery":{"guns":[]}})"), "/battery: a mission has no such key.\n  Did you mean batteries?"));
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"world":{"georef":{}}})"), "/world/georef: a world has no such key."));
}

TEST(MissionFile, WritingAndReadingIsIdentity) {
  const Scenario sample = test::sampleScenario();
  const auto again = parseScenario(scenarioText(sample), "");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(*again, sample);
  EXPECT_EQ(scenarioText(*again), scenarioText(sample));
}

TEST(MissionFile, SavingAndLoadingIsIdentityAndKeepsTheClauses) {
  const test::TemporaryFolder folder;
  Scenario s = test::sampleScenario();
  s.folder = folder.path();
  Expectation clause;
  clause.fields = {{"event", std::string("detonation"), {}, {}}, {"miss_m", 0.0, {}, 60.0}};
  clause.before_s = 100.0;
  clause.text = R"({"event":"detonation","miss_m":{"max":60.0},"before":100})";
  s.expect.push_back(clause);
  ASSERT_TRUE(saveScenario(s, folder / "a.mission.json"));
  const auto loaded = loadScenario(folder / "a.mission.json");
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_EQ(*loaded, s);
  EXPECT_EQ(loaded->expect[0].before_s, 100.0);
  EXPECT_EQ(loaded->expect[0].fields[1].max, 60.0);
  EXPECT_EQ(loaded->expect[0].file, folder / "a.mission.json");
  ASSERT_TRUE(saveScenario(*loaded, folder / "b.mission.json"));
  EXPECT_EQ(test::slurp(folder / "a.mission.json"), test::slurp(folder / "b.mission.json"));
}

TEST(MissionFile, AClauseWithoutTextIsWrittenFromItsParts) {
  Scenario s = test::sampleScenario();
  Expectation clause;
  clause.fields = {{"event", std::string("fire"), {}, {}}};
  clause.at_most = 4;
  clause.at_least = 0;
  s.expect.push_back(clause);
  EXPECT_TRUE(contains(scenarioText(s), R"("expect": [{"event": "fire","at_most": 4}])") || contains(scenarioText(s), "\"at_most\": 4")) << scenarioText(s);
  const auto again = parseScenario(scenarioText(s), "");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->expect[0].at_most, 4);
  EXPECT_EQ(again->expect[0].at_least, 0);
}

TEST(MissionFile, AnInvalidMissionIsNotSaved) {
  const test::TemporaryFolder folder;
  Scenario s = test::sampleScenario();
  s.vehicles[0].type = 7;
  EXPECT_FALSE(saveScenario(s, folder / "a.mission.json"));
  EXPECT_FALSE(fs::exists(folder / "a.mission.json"));
  EXPECT_EQ(saveScenario(test::sampleScenario(), folder / "no/such/a.mission.json").error().kind, ErrorKind::output);
}

TEST(MissionFile, OneVehicleOrGunIsOneLine) {
  const std::string text = scenarioText(test::sampleScenario());
  EXPECT_TRUE(contains(text, "\n  \"vehicles\": [{ \"id\": \"t72-1\", \"type\": 51, \"pos\": [26000, 25000] }],\n"));
}

TEST(MissionFile, OnlyWhatDiffersFromTheShippedTypeIsWritten) {
  Scenario s = test::sampleScenario();
  s.types = {shippedVehicleTypes()[3]};
  s.types[0].speed_mps = 17.5;
  const std::string text = scenarioText(s);
  EXPECT_TRUE(contains(text, "\"vehicle_types\": [{ \"index\": 8, \"speed\": 17.5 }]")) << text;
  const auto again = parseScenario(text, "");
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, s);
}

// --- messages ---------------------------------------------------------------------------------------------------------------

TEST(MissionMessages, OfTheVersion) {
  EXPECT_EQ(errorOf("{}"), "m.json:1: the file's version is missing.\n  Add \"npsee_mission\": 1 as the first key.");
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":"1"})"), "m.json:1: /npsee_mission: the version must be a whole number from 1."));
  EXPECT_TRUE(contains(errorOf("{\n\"npsee_mission\":2,\n\"anything\":0}"), "m.json:2: /npsee_mission: the file has version 2, newer than 1, the newest this program reads.\n  Use a newer npsee."));
  EXPECT_EQ(errorOf("[]"), "m.json:1: a mission is an object { ... }, but this is a list.");
  EXPECT_TRUE(contains(errorOf("{"), "is not JSON"));
}

TEST(MissionMessages, NameFileLineAndPointer) {
  EXPECT_EQ(errorOf("{\"npsee_mission\": 1,\n \"batteries\": [ {\n  \"guns\": [ {\"id\": \"g\", \"pos\": [1, 2]} ],\n  \"pe_range\": 5000 } ] }"),
            "m.json:4: /batteries/0/pe_range: pe_range is 5000 m, above the limit of 2000 m.\n  `npsee params --missions pe_range` says what it does.");
}

TEST(MissionMessages, ComeAllAtOnce) {
  const std::string all = errorOf("{\"npsee_mission\": 1,\n\"sed\": 1,\n\"duration\": -1,\n\"world\": {\"size\": 3, \"weather\": {\"night\": 1}}}");
  EXPECT_TRUE(contains(all, "m.json:2: /sed: a mission has no such key.\n  Did you mean seed?"));
  EXPECT_TRUE(contains(all, "m.json:3: /duration: duration is -1 s, below the limit of 0.05 s."));
  EXPECT_TRUE(contains(all, "m.json:4: /world/size: size is 3, but must be a list of two numbers [x, z]."));
  EXPECT_TRUE(contains(all, "m.json:4: /world/weather/night: night is 1, but must be true or false."));
}

TEST(MissionMessages, OfObjectsAndLists) {
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"world":[]})"), "/world: world is [], but must be an object."));
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"vehicles":{}})"), "/vehicles: vehicles is {}, but must be a list of objects."));
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"vehicles":[3]})"), "/vehicles/0: a vehicle is 3, but must be an object."));
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"batteries":[{"guns":[]}]})"), "/batteries/0/guns: guns is empty."));
  EXPECT_TRUE(contains(errorOf(R"({"npsee_mission":1,"batteries":[{}]})"), "/batteries/0: guns is missing: battery needs it."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["sensing"] = "good"; }), "/observers/0/sensing: sensing is \"good\", but must be an object or \"perfect\"."));
  EXPECT_EQ(errorWith([](auto& j) { j["observers"][0]["sensing"] = "perfect"; }), "");
}

TEST(MissionMessages, OfFilesOutsideTheFolder) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["facts"] = "/etc/passwd"; }), "/facts: facts is \"/etc/passwd\", but a mission names files relative to its own folder; an absolute path is refused."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["weapons"] = "a/../../w.dat"; }), "/weapons: weapons is \"a/../../w.dat\", but a mission names files in its own folder or below; .. is refused."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["rules"] = "a\\b.clp"; }), "which is not a path with / between folders."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["batteries"][0]["preset"] = "../x.npsee.json"; }), "/batteries/0/preset: preset is \"../x.npsee.json\", but a mission names files in its own folder or below"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["batteries"][0]["projectile"] = "/x.json"; }), "/batteries/0/projectile: projectile is \"/x.json\""));
}

TEST(MissionMessages, OfNames) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["id"] = "t72-1"; }), "/observers/0/id: the id \"t72-1\" is taken by /vehicles/0/id.\n  Give everything in the mission an id of its own."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["id"] = "group-2"; }), "/groups/0/id: the id \"group-2\" is taken by /vehicles/0/id."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["id"] = "a b"; }), "/vehicles/0/id: id \"a b\" does not fit; use letters, digits, - and _."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicle_types"].push_back({{"index", 60}}); }), "/vehicle_types/1/index: the index 60 is taken by vehicle type 0."));
  Scenario unnamed = test::sampleScenario();
  unnamed.batteries[0].guns[0].id.clear();
  ASSERT_EQ(validate(unnamed).size(), 1u);
  EXPECT_EQ(validate(unnamed)[0].pointer, "/batteries/0/guns/0/id");
}

TEST(MissionMessages, OfTypesThatDoNotExist) {
  const std::string types = "there is no vehicle type 7.\n  Types are 1 infantry squad, 4 truck, 6 M113, 8 M577,";
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["type"] = 7; }), "/vehicles/0/type: " + types));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["groups"][0]["type"] = 7; }), "/groups/0/type: " + types));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["type"] = 7; }), "/observers/0/type: " + types));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["missions"][0]["type"] = 7; }), "/observers/0/missions/0/type: " + types));
}

TEST(MissionMessages, OfPlacesOutsideTheWorld) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["pos"] = {60000, 1}; }),
                       "/vehicles/0/pos: vehicle \"t72-1\" at (60000, 1) lies outside the world, which spans 0 to 50000 m east and 0 to 50000 m south."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["pos"] = {-1, 1}; }), "/observers/0/pos: observer \"fo1\" at (-1, 1) lies outside the world"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["batteries"][0]["guns"][0]["pos"] = {1, 50001}; }), "/batteries/0/guns/0/pos: gun \"gun1\" at (1, 50001) lies outside the world"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["groups"][0]["to"] = {1, 50001}; }), "/groups/0/to: the corner at (1, 50001) lies outside the world"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["goals"] = {{1, 1}, {1, 50001}}; }), "/vehicles/0/goals/1: the goal at (1, 50001) lies outside the world"));
}

TEST(MissionMessages, OfBehaviours) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["behaviour"] = "goals"; }), "/vehicles/0: behaviour goals needs at least one goal.")) << "placed at the nearest object that the file has";
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["behaviour"] = "follow"; }), "/vehicles/0: behaviour follow needs the vehicle ahead."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0].update({{"behaviour", "follow"}, {"follows", "grup-1"}}); }), "/vehicles/0/follows: there is no vehicle \"grup-1\".\n  Did you mean group-1?"));
  EXPECT_EQ(errorWith([](auto& j) { j["vehicles"][0].update({{"behaviour", "follow"}, {"follows", "group-1"}}); }), "");
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0].update({{"behaviour", "follow"}, {"follows", "t72-1"}}); }), "vehicle \"t72-1\" follows itself, directly or through others."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["vehicles"][0]["behaviour"] = "wander"; }), "behaviour cannot be \"wander\"; it is one of static, straight, meander, goals, follow and user."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["groups"][0]["behaviour"] = "follow"; }), "/groups/0/behaviour: a group cannot have goals or follow."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["groups"][0]["speed_min"] = 20; }), "/groups/0/speed_min: speed_min is 20 m/s, above speed_max, 10 m/s."));
}

TEST(MissionMessages, OfObservers) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["vehicle"] = "t72"; }), "/observers/0/vehicle: there is no vehicle \"t72\".\n  Did you mean t72-1?"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["batteries"] = {"alfa"}; }), "/observers/0/batteries/0: there is no battery \"alfa\".\n  Did you mean alpha?"));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["shipped_rules"] = false; }), "/observers/0/shipped_rules: the observer has no rules at all."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["sensing"] = {{"near", 5000}}; }), "/observers/0/sensing: far is 4000 m, not beyond near, 5000 m."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"][0]["sensing"] = {{"belief_near", 0.01}}; }), "/observers/0/sensing: belief_far is 0.05, above belief_near, 0.01."));
}

TEST(MissionMessages, OfTheWorld) {
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["world"]["terrain"]["kind"] = "hgt"; }), "/world/terrain: this kind of terrain needs a file."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["world"]["terrain"]["kind"] = "function"; }), "/world/terrain: kind function needs the function's name."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["world"]["size"] = {50000, 0}; }), "/world/size: the size along z is 0, which only a terrain file can fill in."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["world"]["terrain"] = {{"kind", "function"}, {"expr", "ridge"}, {"params", {{"axis", 3}}}}; }), "/world/terrain/params: params' axis is 3, but must be x or z."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["world"]["terrain"] = {{"kind", "function"}, {"expr", "ridge"}, {"params", {{"crest_x", "high"}}}}; }), "params' crest_x is the text \"high\", but must be a number."));
}

TEST(MissionMessages, OfTooMuch) {
  Scenario many = test::sampleScenario();
  many.groups[0].count = static_cast<int>(kMaxVehicles);
  EXPECT_TRUE(contains(validate(many).at(0).what, "there are 10002 vehicles with those of groups and observers, above the limit of 10000."));
  Scenario guns = test::sampleScenario();
  for (int b = 0; b < 3; ++b) {
    guns.batteries.push_back({});
    guns.batteries.back().id = "b" + std::to_string(b);
    for (int g = 0; g < 400; ++g) guns.batteries.back().guns.push_back({"g" + std::to_string(b) + '-' + std::to_string(g), {1, 1}});
  }
  EXPECT_TRUE(contains(validate(guns).at(0).what, "there are 1201 guns, above the limit of 1000."));
  EXPECT_TRUE(contains(errorWith([](auto& j) { j["observers"] = nlohmann::ordered_json(101, {{"id", "x"}, {"pos", {1, 1}}}); }), "observers has 101 entries, above the limit of 100."));
}

TEST(MissionMessages, OfClauses) {
  const auto clause = [](const std::string& text) { return errorOf("{\"npsee_mission\": 1,\n\"expect\": [" + text + "]}"); };
  EXPECT_EQ(clause(R"({"event":"fire","at_most":5}, {"not":{"event":"warning"}}, {"event":"solution","qe_mil":{"min":340,"max":360},"trajectory":"low"})"), "");
  EXPECT_TRUE(contains(clause("3"), "m.json:2: /expect/0: a clause is 3, but must be an object such as {\"event\": \"destroyed\"}."));
  EXPECT_TRUE(contains(clause("{}"), "/expect/0: the clause names no event."));
  EXPECT_TRUE(contains(clause(R"({"event":7})"), "/expect/0/event: event is 7, but must be the name of an event."));
  EXPECT_TRUE(contains(clause(R"({"event":"fir"})"), "/expect/0/event: event is \"fir\", but must be the name of an event.\n  Did you mean fire?"));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","gan":"gun1"})"), "/expect/0/gan: events of the kind fire have no such key.\n  Did you mean gun?"));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","position":[1,2,3]})"), "/expect/0/position: position is a place, which a clause cannot compare."));
  EXPECT_TRUE(contains(clause(R"({"event":"spot","observed":"no"})"), "/expect/0/observed: observed is \"no\", but must be true or false."));
  EXPECT_TRUE(contains(clause(R"({"event":"end_of_mission","within":{"of":"x","m":1}})"), "/expect/0/within: events of the kind end_of_mission have no position to be within of."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","gun":[1]})"), "/expect/0/gun: gun is [1], but must be a text."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","t":{"mim":1}})"), "/expect/0/t: t is {\"mim\":1}, but must be a number or {\"min\": A, \"max\": B}."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","within":{"of":"x"}})"), "/expect/0/within: within is {\"of\":\"x\"}, but must be {\"of\": \"t72-1\", \"m\": 60}."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","within":{"of":"x","m":0}})"), "/expect/0/within/m: m is 0, but a distance must be above 0."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","within":{"of":"x","m":1}})"), "/expect/0: there is no vehicle, gun or observer \"x\"."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","before":-1})"), "/expect/0/before: before is -1, but must be a time of 0 to 86400 s."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","before":1,"after":2})"), "/expect/0: before is 1 s, not later than after, 2 s."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","at_least":2,"at_most":1})"), "/expect/0: at_most is 1, below at_least, 2."));
  EXPECT_TRUE(contains(clause(R"({"event":"fire","at_least":0.5})"), "/expect/0/at_least: at_least is 0.5, but must be a whole number of 0 to 1000000."));
  EXPECT_TRUE(contains(clause(R"({"not":{"event":"fire"},"before":1})"), "/expect/0: a clause with \"not\" has no other keys."));
  EXPECT_TRUE(contains(clause(R"({"not":{"event":"fire","at_most":1}})"), "/expect/0/not: \"not\" means that there is no such event; it takes neither counts nor another \"not\"."));
}

// --- files beside the mission -----------------------------------------------------------------------------------------------

TEST(MissionFolder, FilesItNamesMustBeThere) {
  const test::TemporaryFolder folder;
  test::spill(folder / "m.mission.json", "{\"npsee_mission\": 1,\n\"facts\": \"mine.clp\"}");
  const auto missing = loadScenario(folder / "m.mission.json");
  ASSERT_FALSE(missing);
  EXPECT_TRUE(contains(missing.error().text(), "m.mission.json:2: /facts: there is no file \"" + folder.path() + "/mine.clp\".\n  Paths are relative to the mission file's folder."));
  test::spill(folder / "mine.clp", "");
  EXPECT_TRUE(loadScenario(folder / "m.mission.json"));
}

TEST(MissionFolder, TheShippedFilesNeedNotBeThere) {
  const test::TemporaryFolder folder;
  test::spill(folder / "m.mission.json", R"({"npsee_mission": 1, "facts": "forwardobserver.clp", "weapons": "weapons.dat"})");
  EXPECT_TRUE(loadScenario(folder / "m.mission.json"));
  test::spill(folder / "m.mission.json", R"({"npsee_mission": 1, "facts": "sub/forwardobserver.clp"})");
  EXPECT_FALSE(loadScenario(folder / "m.mission.json")) << "a path with a folder means that file";
}

TEST(MissionFolder, FoldersAndDevicesAreNoFiles) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "mine.clp");
  fs::create_symlink("/dev/zero", folder / "zero.clp");
  for (const char* name : {"mine.clp", "zero.clp"}) {
    test::spill(folder / "m.mission.json", std::string("{\"npsee_mission\": 1, \"facts\": \"") + name + "\"}");
    const auto read = loadScenario(folder / "m.mission.json");
    ASSERT_FALSE(read);
    EXPECT_TRUE(contains(read.error().text(), "is not a regular file that can be read."));
  }
}

TEST(MissionFolder, AMissingMissionIsAnInputError) {
  const auto read = loadScenario("/no/such.mission.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::input);
  EXPECT_TRUE(contains(read.error().text(), "/no/such.mission.json: cannot be read: there is no such file."));
}

// --- hostile files ----------------------------------------------------------------------------------------------------------

TEST(HostileMission, ListsAtMostAHundredFaults) {
  std::string text = "{\"npsee_mission\":1,\"vehicles\":[";
  for (int i = 0; i < 9000; ++i) text += std::string(i ? "," : "") + "{\"id\":3}";
  const auto read = parseScenario(text + "]}", "h");
  ASSERT_FALSE(read);
  EXPECT_LE(read.error().faults.size(), 103u);
  EXPECT_TRUE(contains(read.error().faults.back().what, "there may be more faults; the first 100 are listed."));
}

TEST(HostileMission, TooManyVehiclesAreRefusedBeforeTheyAreRead) {
  std::string text = "{\"npsee_mission\":1,\"vehicles\":[0";
  for (int i = 0; i < 200000; ++i) text += ",0";
  const auto read = parseScenario(text + "]}", "h");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().faults.size(), 1u);
  EXPECT_TRUE(contains(read.error().text(), "vehicles has 200001 entries, above the limit of 10000."));
}

TEST(HostileMission, DamagedTextIsReadOrRefusedButNeverMore) {
  const std::string good = test::slurp(kData + "npsnet_scenario.json");
  std::uint32_t state = 1;
  const auto next = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
  const std::string alphabet = "{}[]\",:0123456789.-eE \\nultrfasx\xff\x80";
  int refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string text = good;
    for (std::uint32_t k = 1 + next() % 4; k > 0; --k) {
      const std::size_t at = next() % text.size();
      const char c = alphabet[next() % alphabet.size()];
      switch (next() % 3) {
        case 0: text[at] = c; break;
        case 1: text.insert(at, 1, c); break;
        default: text.erase(at, 1 + next() % 8); break;
      }
    }
    const auto read = parseScenario(text, "h");
    if (read) {
      EXPECT_TRUE(validate(*read).empty());
      const auto again = parseScenario(scenarioText(*read), "");
      ASSERT_TRUE(again) << again.error().text();
      EXPECT_EQ(*again, *read);
    } else {
      ++refused;
      EXPECT_FALSE(read.error().faults.empty());
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(ShippedTypes, AreInOrderAndHoldTheThesisOnes) {
  const auto& types = shippedVehicleTypes();
  EXPECT_TRUE(std::ranges::is_sorted(types, {}, &VehicleType::index));
  const auto find = [&](int index) { return *std::ranges::find(types, index, &VehicleType::index); };
  EXPECT_EQ(find(8).name, "M577");
  EXPECT_EQ(find(8).side, Side::friendly);
  EXPECT_EQ(find(51).name, "T-72");
  EXPECT_EQ(find(51).target_class, TargetClass::heavy_armor);
  EXPECT_EQ(find(52).name, "BMP");
  EXPECT_EQ(find(53).name, "T2fred");
  EXPECT_TRUE(std::ranges::any_of(types, [](const VehicleType& type) { return type.side == Side::neutral; }));
  Scenario all;
  all.types = types;
  EXPECT_TRUE(validate(all).empty());
}

TEST(ShippedTypes, AreReplacedByTheMissionsOwnOfTheSameIndex) {
  Scenario s;
  s.types = {test::typeNamed(51, "other"), test::typeNamed(70, "new")};
  const auto types = vehicleTypes(s);
  EXPECT_EQ(types.size(), shippedVehicleTypes().size() + 1);
  EXPECT_TRUE(std::ranges::is_sorted(types, {}, &VehicleType::index));
  EXPECT_EQ(std::ranges::find(types, 51, &VehicleType::index)->name, "other");
}

}  // namespace
}  // namespace npsee
