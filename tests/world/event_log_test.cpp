#include <npsee/recording.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace npsee {
namespace {

TEST(EventLog, WritesOneObjectPerLineWithTimeKindAndFieldsInTheSchemasOrder) {
  MissionEvent fire{12.35, EventKind::fire, {{"qe_mil", 349.25}, {"position", Vec3{20400.0, 2.0, 25000.5}}, {"unheard_of", true}, {"shell", std::int64_t{3}}, {"gun", std::string("gun1")}}};
  EXPECT_EQ(eventJson(fire), R"({"t":12.35,"ev":"fire","shell":3,"gun":"gun1","position":[20400,2,25000.5],"qe_mil":349.25,"unheard_of":true})");
  // Whatever order they were collected in, they are written in that of the schema; what says nothing is left out where it may be.
  MissionEvent call{0.1 + 0.2, EventKind::call, {{"facts", std::vector<std::string>{"(a)", "(b)"}}, {"target", std::string()}, {"danger_close", true}}};
  EXPECT_EQ(eventJson(call), R"x({"t":0.3,"ev":"call","danger_close":true,"facts":["(a)","(b)"]})x");
  Recording recording;
  recording.events = {fire, call};
  EXPECT_EQ(eventLog(recording), eventJson(fire) + '\n' + eventJson(call) + '\n');
}

TEST(EventLog, NumbersAreRoundedToATenthOfAMillimetreAndNeverNotANumber) {
  const auto shown = [](double value) { return eventJson({0.0, EventKind::spot, {{"range_m", value}}}); };
  EXPECT_EQ(shown(4536.123456), R"({"t":0,"ev":"spot","range_m":4536.1235})");
  EXPECT_EQ(shown(-0.00001), R"({"t":0,"ev":"spot","range_m":0})");
  EXPECT_EQ(shown(std::nan("")), R"({"t":0,"ev":"spot","range_m":null})");
  EXPECT_EQ(shown(INFINITY), R"({"t":0,"ev":"spot","range_m":null})");
  EXPECT_EQ(shown(1e300), R"({"t":0,"ev":"spot","range_m":1e+300})");
}

TEST(EventLog, HostileNamesAreEscaped) {
  const auto shown = [](const std::string& text) { return eventJson({0.0, EventKind::warning, {{"text", text}}}); };
  EXPECT_EQ(shown("a\"b\\c\nd\te\x1b"), R"({"t":0,"ev":"warning","text":"a\"b\\c\nd\te\u001b"})");
  EXPECT_EQ(shown("Höhe"), "{\"t\":0,\"ev\":\"warning\",\"text\":\"Höhe\"}");
  EXPECT_EQ(shown("\xff"), R"({"t":0,"ev":"warning","text":"\ufffd"})");
}

TEST(EventLog, FieldsAreFoundByNameAndType) {
  const MissionEvent event{1.0, EventKind::detonation, {{"shell", std::int64_t{3}}, {"miss_m", 2.5}, {"gun", std::string("gun1")}, {"position", Vec3{1.0, 2.0, 3.0}}}};
  EXPECT_EQ(event.number("shell"), 3.0);
  EXPECT_EQ(event.number("miss_m"), 2.5);
  EXPECT_EQ(event.number("gun", -1.0), -1.0);
  EXPECT_EQ(event.text("gun"), "gun1");
  EXPECT_EQ(event.text("shell"), "");
  ASSERT_TRUE(event.place());
  EXPECT_EQ(*event.place(), (Vec3{1.0, 2.0, 3.0}));
  EXPECT_EQ(event.find("nothing"), nullptr);
}

TEST(EventSchema, DescribesEveryKindOfEventInOrderAndEachKeyOnce) {
  const auto names = eventKindNames();
  ASSERT_EQ(names.size(), static_cast<std::size_t>(kEventKinds));
  EXPECT_EQ(names[static_cast<std::size_t>(EventKind::danger_close)], "danger_close");
  EXPECT_EQ(names[static_cast<std::size_t>(EventKind::end)], "end");
  std::size_t kind = 0;
  std::set<std::string> seen;
  const std::set<std::string_view> types{"id", "number", "whole", "text", "bool", "place", "texts"};
  for (const EventKey& key : eventSchema()) {
    while (kind < names.size() && names[kind] != key.event) ++kind;
    ASSERT_LT(kind, names.size()) << key.event << " stands out of order";
    EXPECT_TRUE(seen.insert(std::string(key.event) + '.' + std::string(key.key)).second) << key.event << '.' << key.key;
    EXPECT_TRUE(types.contains(key.type)) << key.type;
    EXPECT_FALSE(key.doc.empty());
  }
  for (const std::string_view name : names) EXPECT_TRUE(std::ranges::any_of(eventSchema(), [&](const EventKey& key) { return key.event == name; })) << name;
}

}  // namespace
}  // namespace npsee
