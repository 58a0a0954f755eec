#include "tests/support/process.h"
#include "tests/world/recorded.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

namespace npsee {
namespace {

using test::recorded;
using test::slurp;
using test::spill;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}
std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

TEST(RecordingFile, ReadsBackToTheSameBits) {
  const test::TemporaryFolder folder;
  const Recording before = recorded();
  ASSERT_TRUE(saveRecording(before, folder / "run.jsonl"));
  const auto after = loadRecording(folder / "run.jsonl");
  ASSERT_TRUE(after) << after.error().text();

  EXPECT_EQ(after->events, before.events);
  EXPECT_EQ(eventLog(*after), eventLog(before));
  Scenario scenario = after->scenario;
  scenario.folder = before.scenario.folder;
  EXPECT_EQ(scenario, before.scenario);
  EXPECT_EQ(after->duration_s, before.duration_s);
  EXPECT_EQ(after->finished, before.finished);
  EXPECT_EQ(after->hash, before.hash);
  ASSERT_EQ(after->vehicles.size(), before.vehicles.size());
  for (std::size_t i = 0; i < before.vehicles.size(); ++i) {
    EXPECT_EQ(after->vehicles[i].id, before.vehicles[i].id);
    EXPECT_EQ(after->vehicles[i].type, before.vehicles[i].type);
    EXPECT_EQ(after->vehicles[i].track, before.vehicles[i].track);
    EXPECT_EQ(after->vehicles[i].damage, before.vehicles[i].damage);
  }
  ASSERT_EQ(after->shells.size(), before.shells.size());
  for (std::size_t i = 0; i < before.shells.size(); ++i) {
    const ShellRecord &a = after->shells[i], &b = before.shells[i];
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.preset, b.preset);
    EXPECT_EQ(a.smoke, b.smoke);
    EXPECT_EQ(a.path.nodes().size(), b.path.nodes().size());
    EXPECT_EQ(a.path.flight(), b.path.flight());
    for (double t = 0.0; t <= 120.0; t += 0.77) {
      EXPECT_EQ(a.at(t), b.at(t));
      EXPECT_EQ(a.velocityAt(t), b.velocityAt(t));
    }
  }
  for (std::size_t i = 0; i < before.guns.size(); ++i)
    for (double t = 0.0; t <= 120.0; t += 0.77) EXPECT_EQ(after->guns[i].lineAt(t), before.guns[i].lineAt(t));
  ASSERT_EQ(after->observers.size(), 1u);
  EXPECT_EQ(after->observers[0].beliefs.size(), 2u);
  EXPECT_EQ(after->observers[0].beliefs[1].believed_m, before.observers[0].beliefs[1].believed_m);
  EXPECT_EQ(after->observerEye(0, 50.0), before.observerEye(0, 50.0));

  ASSERT_TRUE(saveRecording(*after, folder / "again.jsonl"));
  EXPECT_EQ(slurp(folder / "again.jsonl"), slurp(folder / "run.jsonl"));
}

TEST(RecordingFile, AnEmptyMissionIsARecordingToo) {
  const test::TemporaryFolder folder;
  Recording empty;
  empty.scenario.world.size_x_m = empty.scenario.world.size_z_m = 1000.0;
  empty.terrain = test::must(Terrain::make({}, 1000.0, 1000.0, 0.0));
  ASSERT_TRUE(saveRecording(empty, folder / "empty.jsonl"));
  const auto after = loadRecording(folder / "empty.jsonl");
  ASSERT_TRUE(after) << after.error().text();
  EXPECT_TRUE(after->vehicles.empty());
}

class DamagedRecording : public testing::Test {
 protected:
  DamagedRecording() {
    EXPECT_TRUE(saveRecording(recorded(), path()));
    lines_ = linesOf(slurp(path()));
  }
  std::string path() const { return folder_ / "run.jsonl"; }
  std::size_t first(const std::string& key) const {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].starts_with("{\"" + key)) return i;
    return lines_.size();
  }
  /// The message for these lines; empty if they are read.
  std::string messageOf(const std::vector<std::string>& lines) {
    spill(path(), joined(lines));
    const auto read = loadRecording(path());
    if (read) return {};
    EXPECT_EQ(read.error().kind, ErrorKind::input);
    return read.error().text();
  }
  /// With a piece of the first line of a kind replaced.
  std::string messageWith(const std::string& key, const std::string& old, const std::string& now) {
    auto lines = lines_;
    std::string& line = lines[first(key)];
    const std::size_t at = line.find(old);
    EXPECT_NE(at, std::string::npos) << line;
    if (at != std::string::npos) line.replace(at, old.size(), now);
    return messageOf(lines);
  }
  std::string at(const std::string& key) const { return "run.jsonl:" + std::to_string(first(key) + 1) + ":"; }

  test::TemporaryFolder folder_;
  std::vector<std::string> lines_;
};

void expectSays(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

TEST_F(DamagedRecording, IsRefusedWithLineAndPlace) {
  expectSays(messageWith("vehicle", "\"type\":51", "\"type\":7777"), {at("vehicle"), "/vehicle/type", "is no type"});
  expectSays(messageWith("vehicle", "[5.0,", "[5000000.0,"), {at("vehicle"), "/vehicle/legs/1", "out of order or beyond all bounds"});
  expectSays(messageWith("gun", "\"battery\":0", "\"battery\":3"), {at("gun"), "/gun/battery", "outside 0 to 0"});
  expectSays(messageWith("shell", "\"target\":0", "\"target\":2"), {at("shell"), "/shell/target", "outside -1 to 1"});
  expectSays(messageWith("shell", "\"gun\":0", "\"gun\":0.5"), {at("shell"), "/shell/gun", "is not a whole number"});
  expectSays(messageWith("event", "\"contact\"", "\"contract\""), {at("event"), "/event/ev", "is no kind of event"});
  expectSays(messageWith("event", "\"belief\":0.8", "\"belief\":{}"), {at("event"), "/event/belief"});
  expectSays(messageWith("observer", "\"vehicle\":1", "\"vehicle\":9"), {at("observer"), "/observer/vehicle"});
  expectSays(messageWith("observer", "[3.0,0,1", "[3.0,99,1"), {at("observer"), "names no vehicle"});
  expectSays(messageWith("npsee_recording", "\"version\":1", "\"version\":2"), {"run.jsonl:1:", "version 2, newer than 1, the newest this program reads"});
  expectSays(messageWith("weapons", "I 155mm", "X 155mm"), {at("weapons")});
  expectSays(messageWith("scenario", "\"duration\"", "\"durration\""), {at("scenario"), "durration"});
}

TEST_F(DamagedRecording, SaysWhenShellsOrGroundAreNoLongerThoseOfTheMission) {
  expectSays(messageWith("scenario", "\"height\":50", "\"height\":51"), {at("scenario"), "is not the ground on which the mission was played"});
  expectSays(messageWith("shell", "\"speed\":29", "\"speed\":28"), {at("shell"), "shell 1 comes down", "from where it was recorded", "Run the mission again with --record"});
}

TEST_F(DamagedRecording, MustBeginAndEndAndKeepItsOrder) {
  expectSays(messageOf({}), {"is empty"});
  expectSays(messageOf({lines_.begin() + 1, lines_.end()}), {"run.jsonl:1:", "is not the first line"});
  expectSays(messageOf({lines_.begin(), lines_.end() - 1}), {"ends before the recording does"});
  auto twice = lines_;
  twice.push_back(lines_.back());
  expectSays(messageOf(twice), {"after the end"});
  auto swapped = lines_;
  std::swap(swapped[1], swapped[2]);
  expectSays(messageOf(swapped), {"run.jsonl:2:", "out of order"});
  auto missing = lines_;
  missing.erase(missing.begin() + static_cast<std::ptrdiff_t>(first("event")));
  expectSays(messageOf(missing), {"/end/events", "is 6, but there are 5"});
  auto strange = lines_;
  strange.insert(strange.begin() + 3, "{\"rocket\":{}}");
  expectSays(messageOf(strange), {"run.jsonl:4:", "/rocket", "is not known"});
  strange[3] = "[1,2";
  expectSays(messageOf(strange), {"run.jsonl:4:", "is not JSON"});
}

TEST_F(DamagedRecording, CutOrChangedAnywhereItIsReadOrRefusedButNeverWorse) {
  const std::string whole = joined(lines_);
  std::uint32_t random = 12345;
  const auto next = [&] { return random = random * 1664525u + 1013904223u, random >> 8; };
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string text = whole;
    if (i % 3 == 0) text.resize(next() % text.size());
    else
      for (int k = 0; k < 1 + i % 4; ++k) text[next() % text.size()] = "0919-e{}[],\":x"[next() % 14];
    spill(path(), text);
    const auto read = loadRecording(path());
    if (read) continue;
    ++refused;
    EXPECT_FALSE(read.error().text().empty());
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace npsee
