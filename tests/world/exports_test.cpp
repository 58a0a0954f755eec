#include "tests/support/process.h"
#include "tests/world/recorded.h"

#include <npsee/exports.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace npsee {
namespace {

using test::must;
using test::recorded;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) out.push_back(part);
  return out;
}

TEST(Acmi, BeginsAsTacviewAsksAndItsTimesNeverGoBack) {
  const auto lines = linesOf(must(acmiText(recorded())));
  EXPECT_EQ(lines[0], "FileType=text/acmi/tacview");
  EXPECT_EQ(lines[1], "FileVersion=2.2");
  double last = -1.0;
  for (const std::string& line : lines)
    if (line.starts_with("#")) {
      const double t = std::stod(line.substr(1));
      EXPECT_GT(t, last);
      last = t;
    }
  EXPECT_GE(last, 55.0);
}

TEST(Acmi, NativeCoordinatesAreThoseOfTheWorldAndObjectsEndOnce) {
  const Recording r = recorded();
  const std::string text = must(acmiText(r));
  std::map<std::string, int> begun, ended;
  double t = 0.0;
  int checked = 0;
  for (const std::string& line : linesOf(text)) {
    if (line.starts_with("#")) t = std::stod(line.substr(1));
    else if (line.starts_with("-")) ++ended[line.substr(1)];
    else if (line.find(",T=") != std::string::npos) {
      const std::string id = line.substr(0, line.find(','));
      if (line.find("Type=") != std::string::npos) ++begun[id];
      EXPECT_EQ(begun[id], 1) << line;
      if (id != "1") continue;
      // The first vehicle: longitude, latitude, altitude, roll, pitch, yaw, U, V, heading.
      const auto parts = split(line.substr(line.find("T=") + 2, line.find(',', line.find("T=")) - line.find("T=") - 2), '|');
      ASSERT_EQ(parts.size(), 9u) << line;
      const Vec3 p = r.vehiclePlace(0, t);
      EXPECT_NEAR(std::stod(parts[6]), p.x, 0.006);
      EXPECT_NEAR(std::stod(parts[7]), -p.z, 0.006);
      EXPECT_NEAR(std::stod(parts[2]), p.y, 0.006);
      EXPECT_NEAR(std::stod(parts[0]) * 111319.49, p.x - 6000.0, 0.01);
      ++checked;
    }
  }
  EXPECT_EQ(text.find("e-"), std::string::npos) << "no exponents";
  EXPECT_GT(checked, 20);
  for (const auto& [id, count] : ended) EXPECT_EQ(count, 1) << id;
  EXPECT_EQ(ended.size(), 2 * r.shells.size()) << "shells and their bursts";
}

TEST(Acmi, NamesCannotBreakLinesOrProperties) {
  Recording r = recorded();
  r.vehicles[0].id = "a,b\nc|d\\e";
  const std::string text = must(acmiText(r));
  EXPECT_NE(text.find("Pilot=a\\,b c d\\\\e,"), std::string::npos);
  EXPECT_NE(text.find("0,Event=Bookmark|fo1 calls adjust_fire on t72-1\n"), std::string::npos);
  EXPECT_NE(text.find("end"), std::string::npos);
}

TEST(Csv, HasOneRowPerThingAndSampleWithAllColumns) {
  Recording r = recorded();
  r.vehicles[1].id = "=HYPERLINK(\"x\")";
  const auto lines = linesOf(must(csvText(r)));
  const std::size_t columns = split(lines[0], ',').size();
  EXPECT_EQ(columns, 13u);
  std::set<std::string> kinds;
  double last = 0.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = split(lines[i], ',');
    if (lines[i].find("HYPERLINK") != std::string::npos) {
      EXPECT_NE(lines[i].find("\"'=HYPERLINK(\"\"x\"\")\""), std::string::npos) << "no formula for a spreadsheet";
      continue;
    }
    ASSERT_EQ(cells.size(), columns) << lines[i];
    kinds.insert(cells[1]);
    EXPECT_GE(std::stod(cells[0]), last);
    last = std::stod(cells[0]);
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"burst", "gun", "shell", "vehicle"}));
}

TEST(Exports, RefuseStepsThatAreNoneAndMoreThanFits) {
  const Recording r = recorded();
  for (const double step : {0.0, -1.0, std::nan(""), 1e9}) {
    const auto out = csvText(r, {.step_s = step, .shell_step_s = 0.25});
    ASSERT_FALSE(out);
    EXPECT_EQ(out.error().kind, ErrorKind::usage);
  }
  Recording day = recorded();
  day.duration_s = 86400.0;
  day.vehicles.resize(500, day.vehicles[0]);
  const auto out = acmiText(day);
  ASSERT_FALSE(out);
  EXPECT_NE(out.error().text().find("Give a larger --step."), std::string::npos);
  EXPECT_TRUE(acmiText(day, {.step_s = 60.0, .shell_step_s = 0.25}));
}

// Fields of a packet, big-endian.
std::uint64_t field(const std::vector<std::uint8_t>& bytes, std::size_t at, int size) {
  std::uint64_t out = 0;
  for (int i = 0; i < size; ++i) out = out << 8 | bytes[at + static_cast<std::size_t>(i)];
  return out;
}
double real(const std::vector<std::uint8_t>& bytes, std::size_t at) { return std::bit_cast<double>(field(bytes, at, 8)); }
double single(const std::vector<std::uint8_t>& bytes, std::size_t at) { return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(field(bytes, at, 4)))); }

TEST(Dis, PacketsHaveTheSizesOfTheStandardAndSayThem) {
  int count[4] = {};
  for (const DisPacket& packet : must(disPackets(recorded()))) {
    const auto type = packet.bytes[2];
    ASSERT_TRUE(type >= 1 && type <= 3);
    ++count[type];
    const std::size_t sizes[] = {0, 144, 96, 104};
    EXPECT_EQ(packet.bytes.size(), sizes[type]);
    EXPECT_EQ(field(packet.bytes, 8, 2), sizes[type]);
  }
  EXPECT_EQ(count[2], 7);
  EXPECT_EQ(count[3], 7);
  EXPECT_GT(count[1], 100);
}

TEST(Dis, TimestampsAreRoundedAndPacketsAreInOrder) {
  double last = 0.0;
  for (const DisPacket& packet : must(disPackets(recorded()))) {
    EXPECT_GE(packet.t_s, last);
    last = packet.t_s;
    const double units = static_cast<double>(field(packet.bytes, 4, 4) >> 1);
    EXPECT_LE(std::fabs(units - packet.t_s / 3600.0 * 0x1p31), 0.5 + 1e-6);
  }
}

TEST(Dis, EveryDetonationHasItsFireWithTheSameEventAndMunition) {
  std::map<std::uint64_t, std::uint64_t> fired;
  const Recording r = recorded();
  int matched = 0;
  for (const DisPacket& packet : must(disPackets(r))) {
    const std::uint64_t munition = field(packet.bytes, 24, 6), event = field(packet.bytes, 30, 6);
    if (packet.bytes[2] == 2) {
      EXPECT_TRUE(fired.emplace(event, munition).second);
    }
    if (packet.bytes[2] == 3) {
      EXPECT_EQ(fired.at(event), munition);
      ++matched;
    }
  }
  EXPECT_EQ(matched, static_cast<int>(r.shells.size()));
}

/// Axes of a body from its Euler angles: rows of the rotation, by the definition of the standard.
std::array<Vec3, 3> axesOf(double psi, double theta, double phi) {
  const double cp = std::cos(psi), sp = std::sin(psi), ct = std::cos(theta), st = std::sin(theta), cf = std::cos(phi), sf = std::sin(phi);
  return {Vec3{ct * cp, ct * sp, -st}, Vec3{sf * st * cp - cf * sp, sf * st * sp + cf * cp, sf * ct}, Vec3{cf * st * cp + sf * sp, cf * st * sp - sf * cp, cf * ct}};
}

TEST(Dis, PlaceAndOrientationMeanTheSameAsInTheWorld) {
  Recording r = recorded();
  for (const double heading : {0.0, 0.3, 0.5 * kPi, 2.5, kPi, 4.0, 1.5 * kPi, 6.0}) {
    r.vehicles[1].track = {};
    r.vehicles[1].track.add({0.0, 7000.0, 5000.0, heading, 5.0, 0.0, 0.0});
    for (const DisPacket& packet : must(disPackets(r))) {
      if (packet.bytes[2] != 1 || field(packet.bytes, 16, 2) != 2 || packet.t_s != 0.0) continue;
      const Vec3 p = r.vehiclePlace(1, 0.0);
      EXPECT_NEAR(real(packet.bytes, 48), 6378137.0 + p.y, 1e-6);
      EXPECT_NEAR(real(packet.bytes, 56), p.x - 6000.0, 1e-6);
      EXPECT_NEAR(real(packet.bytes, 64), 6000.0 - p.z, 1e-6);
      // Nose east sin, north cos; the right wing a quarter turn on; down towards the earth's centre.
      const auto axes = axesOf(single(packet.bytes, 72), single(packet.bytes, 76), single(packet.bytes, 80));
      EXPECT_LT(length(axes[0] - Vec3{0.0, std::sin(heading), std::cos(heading)}), 1e-5) << heading;
      EXPECT_LT(length(axes[1] - Vec3{0.0, std::cos(heading), -std::sin(heading)}), 1e-5) << heading;
      EXPECT_LT(length(axes[2] - Vec3{-1.0, 0.0, 0.0}), 1e-5) << heading;
      EXPECT_NEAR(single(packet.bytes, 40), 5.0 * std::sin(heading), 1e-5);
      EXPECT_NEAR(single(packet.bytes, 44), 5.0 * std::cos(heading), 1e-5);
    }
  }
}

TEST(Dis, TheDestroyedTankLooksDestroyed) {
  std::uint64_t appearance = 0;
  for (const DisPacket& packet : must(disPackets(recorded())))
    if (packet.bytes[2] == 1 && field(packet.bytes, 16, 2) == 1) appearance = field(packet.bytes, 84, 4);
  EXPECT_EQ(appearance, 2u | 4u | 3u << 3) << "immobile, unarmed, destroyed";
}

/// tshark's judgement of a capture, as fields of each packet.
std::vector<std::vector<std::string>> dissected(const std::string& path, const std::vector<std::string>& fields) {
  std::vector<std::string> arguments{"-r", path, "-T", "fields", "-o", "udp.check_checksum:TRUE", "-o", "ip.check_checksum:TRUE"};
  for (const std::string& field : fields) arguments.insert(arguments.end(), {"-e", field});
  const auto out = test::run("/usr/bin/tshark", arguments);
  EXPECT_EQ(out.exit_code, 0) << out.err << "\n(package tshark of scripts/packages.txt)";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : linesOf(out.out)) {
    rows.push_back(split(line, '\t'));
    rows.back().resize(fields.size());
  }
  return rows;
}

TEST(Dis, TsharkReadsEveryPacketAndFindsNothingMalformed) {
  const test::TemporaryFolder folder;
  const auto packets = must(disPackets(recorded()));
  test::spill(folder / "run.pcap", pcapText(packets));
  const auto rows = dissected(folder / "run.pcap", {"_ws.col.Protocol", "dis.pdu_type", "udp.dstport", "_ws.malformed", "_ws.expert.message", "ip.checksum.status", "udp.checksum.status", "frame.time_epoch", "dis.event_number"});
  ASSERT_EQ(rows.size(), packets.size());
  std::set<std::string> fired;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], "DIS");
    EXPECT_EQ(rows[i][1], std::to_string(packets[i].bytes[2]));
    EXPECT_EQ(rows[i][2], "3000");
    EXPECT_EQ(rows[i][3], "");
    EXPECT_EQ(rows[i][4], "");
    EXPECT_EQ(rows[i][5], "1") << "a good IP checksum";
    EXPECT_EQ(rows[i][6], "1") << "a good UDP checksum";
    EXPECT_NEAR(std::stod(rows[i][7]), 746841600.0 + packets[i].t_s, 1e-6);
    if (rows[i][1] == "2") {
      EXPECT_TRUE(fired.insert(rows[i][8]).second);
    } else if (rows[i][1] == "3") {
      EXPECT_EQ(fired.count(rows[i][8]), 1u) << "each detonation has its fire";
    }
  }
}

}  // namespace
}  // namespace npsee
