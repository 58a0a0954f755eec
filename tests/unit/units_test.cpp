#include <npsee/units.h>

#include <gtest/gtest.h>

namespace npsee {
namespace {

TEST(Units, EveryNumberOfFifteenDigitsSurvivesTheWayToSiAndBack) {
  for (const Unit unit : {Unit::none, Unit::metre, Unit::degree, Unit::revolution_per_second, Unit::fraction})
    for (const double value : {0.0, 1.0, 52.0, 0.1, 33.3, 89.999999999999, 180.0, 1e-7, -12.3456789, 123456.789012345})
      EXPECT_EQ(toUnit(unit, toSi(unit, value)), value) << symbol(unit);
}

TEST(Units, ReadsANumberWithAnyFittingUnit) {
  EXPECT_DOUBLE_EQ(*parseQuantity("180deg", Unit::degree), kPi);
  EXPECT_DOUBLE_EQ(*parseQuantity("0.9 rad", Unit::degree), 0.9);
  EXPECT_DOUBLE_EQ(*parseQuantity("3200mil", Unit::degree), kPi);
  EXPECT_DOUBLE_EQ(*parseQuantity("216 km/h", Unit::metre_per_second), 60.0);
  EXPECT_DOUBLE_EQ(*parseQuantity(" +12 cm ", Unit::metre), 0.12);
  EXPECT_DOUBLE_EQ(*parseQuantity("25%", Unit::fraction), 0.25);
}

TEST(Units, RefusesWhatIsNotAFiniteNumberOrNoUnitOfTheQuantity) {
  for (const char* text : {"", "deg", "nan", "inf", "1e999", "--3", "12 s", "1,5"}) EXPECT_FALSE(parseQuantity(text, Unit::metre)) << text;
  EXPECT_NE(parseQuantity("12 s", Unit::metre).error().text().find("m, km, cm and mm"), std::string::npos);
}

}  // namespace
}  // namespace npsee
