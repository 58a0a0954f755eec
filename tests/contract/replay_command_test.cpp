#include "tests/support/process.h"
#include "tests/world/recorded.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace npsee {
namespace {

using nlohmann::json;
using test::npseeRun;
using test::ProcessResult;
using test::recorded;
using test::slurp;

class ReplayCommand : public testing::Test {
 protected:
  ReplayCommand() { EXPECT_TRUE(saveRecording(recorded(), file())); }
  std::string file() const { return folder_ / "run.jsonl"; }
  ProcessResult replay(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"replay", file()});
    return npseeRun(arguments);
  }
  /// Exit code and a part of the message.
  void expectRefused(const std::vector<std::string>& arguments, int code, const std::string& part) const {
    const auto out = replay(arguments);
    EXPECT_EQ(out.exit_code, code) << out.err;
    EXPECT_NE(out.err.find(part), std::string::npos) << out.err;
    EXPECT_EQ(out.out, "");
  }
  test::TemporaryFolder folder_;
};

TEST_F(ReplayCommand, PrintsASummaryWithoutOptions) {
  const auto out = replay({});
  EXPECT_EQ(out.exit_code, 0) << out.err;
  EXPECT_NE(out.out.find("A battery, a column, a \"name\": 120 s, seed 1993"), std::string::npos) << out.out;
  EXPECT_NE(out.out.find("2 vehicles, 2 guns, 1 observers, 7 shells"), std::string::npos) << out.out;
  EXPECT_NE(out.out.find("hash of the log: 0123456789abcdef"), std::string::npos) << out.out;
}

TEST_F(ReplayCommand, PrintsTheLogAsItWas) {
  const auto out = replay({"--events"});
  EXPECT_EQ(out.exit_code, 0) << out.err;
  EXPECT_EQ(out.out, eventLog(recorded()));
}

TEST_F(ReplayCommand, PrintsTheStateAtATime) {
  const Recording r = recorded();
  const auto out = replay({"--at", "26"});
  ASSERT_EQ(out.exit_code, 0) << out.err;
  const json state = json::parse(out.out);
  EXPECT_EQ(state["t"], 26.0);
  EXPECT_EQ(state["vehicles"][0]["id"], "t72-1");
  EXPECT_NEAR(state["vehicles"][0]["position"][0].get<double>(), r.vehiclePlace(0, 26.0).x, 1e-4);
  EXPECT_EQ(state["vehicles"][0]["speed_mps"], 6.25);
  EXPECT_FALSE(state["vehicles"][0]["destroyed"].get<bool>());
  std::vector<int> flying;
  r.shellsInAir(26.0, flying);
  ASSERT_EQ(state["shells"].size(), flying.size());
  ASSERT_FALSE(flying.empty());
  EXPECT_NEAR(state["shells"][0]["position"][1].get<double>(), r.shells[static_cast<std::size_t>(flying[0])].at(26.0).y, 1e-4);
  EXPECT_EQ(state["observers"][0]["beliefs"][0]["target"], "t72-1");
  EXPECT_EQ(state["observers"][0]["beliefs"][0]["mission"], 1);
  EXPECT_TRUE(json::parse(replay({"--at", "1min"}).out)["vehicles"][0]["destroyed"].get<bool>());
}

TEST_F(ReplayCommand, WritesTheExportsThatTheNameMeans) {
  for (const auto& [name, begins] : {std::pair{"a.acmi", "FileType=text/acmi/tacview\n"}, {"a.csv", "t_s,kind,id"}, {"a.pcap", "\xd4\xc3\xb2\xa1"}}) {
    const auto out = replay({"-o", folder_ / name});
    EXPECT_EQ(out.exit_code, 0) << out.err;
    EXPECT_EQ(out.out, "");
    EXPECT_TRUE(slurp(folder_ / name).starts_with(begins)) << name;
  }
  const auto streamed = replay({"--format", "csv", "-o", "-"});
  EXPECT_EQ(streamed.exit_code, 0);
  EXPECT_EQ(streamed.out, slurp(folder_ / "a.csv"));
  const auto coarse = replay({"--format", "csv", "-o", "-", "--step", "10", "--shell-step", "5"});
  EXPECT_LT(coarse.out.size(), streamed.out.size() / 2);
}

TEST_F(ReplayCommand, RefusesWhatMakesNoSenseBeforeReadingTheFile) {
  expectRefused({"--format", "mp3", "-o", "x"}, 2, "There are acmi (Tacview), csv or dis");
  expectRefused({"--format", "csv"}, 2, "Give -o FILE");
  expectRefused({"-o", "run.txt"}, 2, "does not say which format");
  expectRefused({"--at", "-1"}, 2, "a mission begins at 0 s");
  expectRefused({"--at", "soon"}, 2, "--at");
  expectRefused({"--at", "121"}, 2, "the recording ends at 120 s");
  expectRefused({"--at", "1", "--events"}, 2, "one at a time");
  expectRefused({"--step", "0", "--format", "csv", "-o", "-"}, 2, "between 0.01 and 3600 s");
  expectRefused({"--send", "192.0.2.1:3000"}, 2, "packets are sent to this machine only");
  expectRefused({"--send", "127.0.0.1:99999"}, 2, "is no port");
  expectRefused({"--send", "127.0.0.1", "--speed", "0"}, 2, "above 0, or max");
  expectRefused({"--step", "2"}, 2, "--step 2 is that of an export or of --send, and none is asked for.");
  expectRefused({"--shell-step", "2", "--at", "3"}, 2, "--shell-step 2 is that of an export");
  expectRefused({"--step", "2", "--render", "t=3", "-o", folder_ / "a.png"}, 2, "--step 2 is that of an export");
  expectRefused({"--speed", "max", "-o", folder_ / "a.csv"}, 2, "--speed max is that of --send, and nothing is sent.");
  expectRefused({"--format", "csv", "-o", folder_ / "no/such/folder.csv"}, 5, "cannot be written");
  const auto missing = npseeRun({"replay", folder_ / "none.jsonl"});
  EXPECT_EQ(missing.exit_code, 3);
  test::spill(folder_ / "bad.jsonl", "{\"npsee_recording\":{}}\n");
  const auto bad = npseeRun({"replay", folder_ / "bad.jsonl"});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_NE(bad.err.find("bad.jsonl:1: /npsee_recording/version: is missing."), std::string::npos) << bad.err;
}

TEST_F(ReplayCommand, SendsThePacketsToAPortOfThisMachine) {
  const int descriptor = ::socket(AF_INET, SOCK_DGRAM, 0);
  ASSERT_GE(descriptor, 0);
  const int room = 4 << 20;
  ::setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  socklen_t size = sizeof address;
  ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
  const auto out = replay({"--send", "localhost:" + std::to_string(ntohs(address.sin_port)), "--speed", "max"});
  EXPECT_EQ(out.exit_code, 0) << out.err;
  // All is in the socket's buffer by now, as far as it had room.
  unsigned char bytes[2000];
  int fires = 0;
  for (;;) {
    const ssize_t got = ::recv(descriptor, bytes, sizeof bytes, MSG_DONTWAIT);
    if (got < 0) break;
    EXPECT_TRUE(got == 144 || got == 96 || got == 104) << got;
    fires += bytes[2] == 2;
  }
  ::close(descriptor);
  EXPECT_GT(fires, 0);
}

}  // namespace
}  // namespace npsee
