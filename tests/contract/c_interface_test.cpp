// The C interface gives what the command line gives, to the bit, and refuses every misuse. A program in C and a script of Python's ctypes
// use it as others would.

#include "tests/scenario/mission_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace npsee {
namespace {

using test::npseeRun;

/// Words of each line.
std::vector<std::vector<std::string>> rowsOf(const std::string& text, char separator) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    auto& row = rows.emplace_back();
    for (std::string word; std::getline(words, word, separator);) row.push_back(word);
  }
  return rows;
}

bool sameBits(const std::string& a, const std::string& b) {
  const double one = std::stod(a), other = std::stod(b);
  return std::memcmp(&one, &other, sizeof one) == 0;
}

/// What the interface printed against the table of `npsee particles`: alive, age to a, bounces.
void expectSameParticles(const std::string& ours, const std::vector<std::string>& command) {
  const auto told = npseeRun(command);
  ASSERT_EQ(told.exit_code, 0) << told.err;
  auto table = rowsOf(told.out, ',');
  table.erase(table.begin());
  const auto rows = rowsOf(ours, ' ');
  ASSERT_EQ(rows.size(), table.size());
  ASSERT_GE(rows.size(), 100u);
  std::size_t alive = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 14u);
    ASSERT_EQ(table[i].size(), 16u);
    ASSERT_EQ(rows[i][0], table[i][2]) << "particle " << i;
    alive += rows[i][0] == "1";
    for (std::size_t k = 1; k <= 12; ++k) ASSERT_TRUE(sameBits(rows[i][k], table[i][k + 2])) << "particle " << i << ", column " << k << ": " << rows[i][k] << " and " << table[i][k + 2];
    ASSERT_EQ(rows[i][13], table[i][15]) << "particle " << i;
  }
  EXPECT_GT(alive, 0u);
}

std::string presetFile(const std::string& name) { return std::string(NPSEE_SOURCE_DIR) + "/presets/" + name + ".npsee.json"; }

/// Value behind a word at the beginning of a line.
std::string valueOf(const std::string& text, const std::string& name) {
  for (const auto& row : rowsOf(text, ' '))
    if (row.size() == 2 && row[0] == name) return row[1];
  return "nan";
}

TEST(CInterface, ParticlesHaveTheBitsOfTheCommandLine) {
  for (const char* name : {"classic_1993", "cascade"}) {
    SCOPED_TRACE(name);
    const auto run = test::run(NPSEE_C_CONSUMER, {"particles", presetFile(name), "0.7", "3"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    expectSameParticles(run.out, {"particles", presetFile(name), "--time", "0.7"});
  }
}

TEST(CInterface, SettingsCountAsOnTheCommandLine) {
  const auto run = test::run(NPSEE_C_CONSUMER, {"particles", presetFile("classic_1993"), "1.2", "1", "fragments.speed_mean=90km/h"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expectSameParticles(run.out, {"particles", presetFile("classic_1993"), "--time", "1.2", "--set", "fragments.speed_mean=90km/h"});
}

TEST(CInterface, PythonsCtypesGetTheBitsOfTheCommandLine) {
#ifdef NPSEE_SANITIZED
  GTEST_SKIP() << "an interpreter without sanitizers cannot load a library with them";
#else
  const auto run = test::run(NPSEE_PYTHON, {std::string(NPSEE_SOURCE_DIR) + "/tests/consumer/particles.py", NPSEE_C_LIBRARY, presetFile("classic_1993"), "0.7"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expectSameParticles(run.out, {"particles", presetFile("classic_1993"), "--time", "0.7"});
#endif
}

TEST(CInterface, AFlightAndAnAimHaveTheBitsOfTheCommandLine) {
  const auto flown = test::run(NPSEE_C_CONSUMER, {"fly", "5W", "0.75"});
  ASSERT_EQ(flown.exit_code, 0) << flown.err;
  const auto told = nlohmann::json::parse(npseeRun({"fly", "--charge", "5W", "--qe", "0.75rad", "--json"}).out);
  for (const char* key : {"range_m", "time_of_flight_s", "drift_m"}) EXPECT_EQ(std::stod(valueOf(flown.out, key)), told.at(key).get<double>()) << key;
  EXPECT_NEAR(std::stod(valueOf(flown.out, "last_x_m")), told.at("range_m").get<double>(), 1e-3) << "the path ends at the impact";

  const auto aimed = test::run(NPSEE_C_CONSUMER, {"aim", "5W", "6000"});
  ASSERT_EQ(aimed.exit_code, 0) << aimed.err;
  const auto solved = nlohmann::json::parse(npseeRun({"aim", "--charge", "5W", "--range", "6000", "--solution", "low", "--json"}).out);
  EXPECT_EQ(std::stod(valueOf(aimed.out, "elevation_rad")), solved.at("solutions")[0].at("elevation_rad").get<double>());
  EXPECT_TRUE(test::run(NPSEE_C_CONSUMER, {"aim", "5W", "60000"}).out.starts_with("out of reach: "));
}

TEST(CInterface, AMissionsEventsAreTheLogOfTheCommandLine) {
  const std::string file = std::string(NPSEE_SOURCE_DIR) + "/assets/missions/thesis_default.mission.json";
  const auto run = test::run(NPSEE_C_CONSUMER, {"mission", file});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, npseeRun({"mission", file}).out);
  EXPECT_NE(run.out.find("\"ev\":\"end\""), std::string::npos);
}

TEST(CInterface, OrdersThatNobodyCanObeyAreToldByTheLog) {
  const auto run = test::run(NPSEE_C_CONSUMER, {"orders", std::string(NPSEE_SOURCE_DIR) + "/assets/missions/thesis_default.mission.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> texts;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) texts.push_back(nlohmann::json::parse(line).value("text", line));
  EXPECT_EQ(texts, (std::vector<std::string>{"A person takes over fo1.", "There is no vehicle \"t72-9\" to call fire on.", "Mission 77 is not open; there is nothing to end.", "There is no vehicle \"\" to drive."}));
}

/// A recording of version 1, which is read for ever.
std::string sampleRecording() { return std::string(NPSEE_SOURCE_DIR) + "/tests/data/v1/thesis_default.rec"; }

/// Lines that begin with a word and a blank, without them.
std::vector<std::string> linesOf(const std::string& text, const std::string& first) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(first + " ")) found.push_back(line.substr(first.size() + 1));
  return found;
}

/// What a program printed of a recording at a time, against `npsee replay`.
void expectSameRecording(const std::string& printed, const std::string& file, const std::string& time) {
  std::vector<std::string> log;
  std::istringstream lines(npseeRun({"replay", file, "--events"}).out);
  for (std::string line; std::getline(lines, line);) log.push_back(line);
  ASSERT_GT(log.size(), 5u);
  const auto last = nlohmann::json::parse(log.back());
  EXPECT_EQ(valueOf(printed, "hash"), last.at("hash").get<std::string>());
  // Seeking is a search; counting is not.
  const double from_s = std::stod(time);
  const auto first = static_cast<std::size_t>(std::count_if(log.begin(), log.end(), [&](const std::string& line) { return nlohmann::json::parse(line).at("t").get<double>() < from_s; }));
  EXPECT_EQ(valueOf(printed, "first"), std::to_string(first));
  EXPECT_EQ(linesOf(printed, "event"), std::vector<std::string>(log.begin() + static_cast<std::ptrdiff_t>(first), log.end()));

  const auto fired = std::count_if(log.begin(), log.end(), [](const std::string& line) { return line.find("\"ev\":\"fire\"") != std::string::npos; });
  EXPECT_EQ(linesOf(printed, "burst").size(), static_cast<std::size_t>(fired)) << "every shell has a burst with a seed";

  const auto state = nlohmann::json::parse(npseeRun({"replay", file, "--at", time}).out);
  const auto vehicles = rowsOf(printed, ' ');
  std::size_t met = 0;
  const auto expectPlace = [](const std::vector<std::string>& row, const nlohmann::json& place) {
    // `npsee replay` rounds to four decimals.
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(std::stod(row.at(2 + k)), place.at(k).get<double>(), 5.1e-5);
  };
  for (const auto& row : vehicles)
    for (const char* kind : {"vehicle", "shell"})
      for (const auto& told : state.at(std::string(kind) + "s"))
        if (row[0] == kind && row[1] == (row[0] == "vehicle" ? told.at("id").get<std::string>() : std::to_string(told.at("shell").get<int>()))) {
          expectPlace(row, told.at("position"));
          ++met;
        }
  EXPECT_EQ(met, state.at("vehicles").size() + state.at("shells").size());
  for (const auto& row : vehicles) {
    EXPECT_TRUE(row[0] != "vehicle" || row[3] == row[5]) << row[1] << " stands on the ground";
  }
}

TEST(CInterface, ARecordingTellsAnyMomentAsTheCommandLineDoes) {
  for (const char* time : {"0", "16.5", "60"}) {
    SCOPED_TRACE(time);
    const auto run = test::run(NPSEE_C_CONSUMER, {"recording", sampleRecording(), time});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    expectSameRecording(run.out, sampleRecording(), time);
  }
}

TEST(CInterface, TheHashOfARecordingIsThatOfItsLinesAsDocumented) {
  const auto run = test::run(NPSEE_C_CONSUMER, {"recording", sampleRecording(), "0"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto lines = linesOf(run.out, "event");
  ASSERT_GT(lines.size(), 5u);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    for (const char byte : lines[i] + "\n") hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  std::ostringstream digits;
  digits << std::hex << std::setw(16) << std::setfill('0') << hash;
  EXPECT_EQ(valueOf(run.out, "hash"), digits.str());
}

TEST(CInterface, AMissionSavedThroughItIsTheCommandLinesRecording) {
  const test::TemporaryFolder folder;
  const std::string file = std::string(NPSEE_SOURCE_DIR) + "/assets/missions/thesis_default.mission.json";
  const auto saved = test::run(NPSEE_C_CONSUMER, {"record", file, folder / "ours.rec"});
  ASSERT_EQ(saved.exit_code, 0) << saved.err;
  ASSERT_EQ(npseeRun({"mission", file, "--quiet", "--record", folder / "theirs.rec"}).exit_code, 0);
  EXPECT_EQ(test::slurp(folder / "ours.rec"), test::slurp(folder / "theirs.rec"));
  const auto run = test::run(NPSEE_C_CONSUMER, {"recording", folder / "ours.rec", "12"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expectSameRecording(run.out, folder / "ours.rec", "12");
}

TEST(CInterface, PythonsCtypesReadARecordingAsAProgramInCDoes) {
#ifdef NPSEE_SANITIZED
  GTEST_SKIP() << "an interpreter without sanitizers cannot load a library with them";
#else
  const auto run = test::run(NPSEE_PYTHON, {std::string(NPSEE_SOURCE_DIR) + "/tests/consumer/recording.py", NPSEE_C_LIBRARY, sampleRecording(), "16.5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, test::run(NPSEE_C_CONSUMER, {"recording", sampleRecording(), "16.5"}).out);
#endif
}

TEST(CInterface, EveryMisuseIsRefusedWithAText) {
  const auto run = test::run(NPSEE_C_CONSUMER, {"errors", sampleRecording()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  ASSERT_TRUE(run.out.starts_with("refused ")) << run.out;
  EXPECT_GE(std::stoi(run.out.substr(8)), 78);
}

TEST(CInterface, OnlyItsFunctionsCanBeSeenInTheLibrary) {
  const auto symbols = test::run(NPSEE_NM, {"-D", "--defined-only", NPSEE_C_LIBRARY});
  ASSERT_EQ(symbols.exit_code, 0) << symbols.err;
  const std::string header = test::slurp(std::string(NPSEE_SOURCE_DIR) + "/sim/include/npsee/c.h");
  std::size_t functions = 0;
  for (const auto& row : rowsOf(symbols.out, ' ')) {
    ASSERT_EQ(row.size(), 3u);
    const std::string name = row[2].substr(0, row[2].find('@'));
    EXPECT_TRUE(name.starts_with("npsee_") && header.find(name + "(") != std::string::npos) << name << " can be seen, and npsee/c.h does not declare it";
    ++functions;
  }
  std::size_t declared = 0;
  for (std::size_t at = 0; (at = header.find("\nNPSEE_API ", at)) != std::string::npos; ++at) ++declared;
  EXPECT_EQ(functions, declared) << "every function that npsee/c.h declares is in the library";
}

}  // namespace
}  // namespace npsee
