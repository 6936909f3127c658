#include "core/base/error.hpp"
#include "core/io/units.hpp"

#include <gmock/gmock.h>
#include <numbers>

using namespace riedel;

TEST(Units, GiveTheBitsOfThePlainNumber) {
  EXPECT_EQ(read_quantity("100 kPa", "Pa"), 100e3);
  EXPECT_EQ(read_quantity("1.5 mm", "m"), 1.5e-3);
  EXPECT_EQ(read_quantity("2.2 mm", "m"), 2.2e-3); // 2.2 * 1e-3 has other bits
  EXPECT_EQ(read_quantity("190 MPa", "Pa"), 190e6);
  EXPECT_EQ(read_quantity("2 ms", "s"), 2e-3);
  EXPECT_EQ(read_quantity("0.1 m/s", "m/s"), 0.1);
  EXPECT_EQ(read_quantity("2650 kg/m3", "kg/m3"), 2650.0);
  EXPECT_EQ(read_quantity("33 deg", "deg"), 33.0);
  EXPECT_EQ(read_quantity("6 %", "-"), 0.06);
  EXPECT_EQ(read_quantity("-1.5e-1 um", "m"), -1.5e-7);
  EXPECT_EQ(read_quantity("+3mm", "m"), 3e-3);
}

TEST(Units, UnderstandProductsAndPowersInAnySpelling) {
  EXPECT_EQ(read_quantity("2.65 g/cm3", "kg/m3"), 2650.0);
  EXPECT_EQ(read_quantity("2.65 t/m³", "kg/m3"), 2650.0);
  EXPECT_EQ(read_quantity("9.81 m/s^2", "m/s2"), 9.81);
  EXPECT_EQ(read_quantity("9.81 m s-2", "m/s2"), 9.81);
  EXPECT_EQ(read_quantity("50 kN/m2", "Pa"), 50e3);
  EXPECT_EQ(read_quantity("0.5 bar", "Pa"), 50e3);
  EXPECT_DOUBLE_EQ(read_quantity("6 mm/min", "m/s"), 1e-4);
  EXPECT_DOUBLE_EQ(read_quantity("0.5 rad", "deg"), 90.0 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(read_quantity("30°", "deg"), 30.0);
}

TEST(Units, OfTheKeyMayHaveAPrefixToo) {
  EXPECT_EQ(read_quantity("1.5 m", "mm"), 1500.0);
  EXPECT_EQ(read_quantity("190 MPa", "kPa"), 190e3);
}

TEST(Units, RefuseWhatMeasuresSomethingElse) {
  for (const auto& [text, unit] : {std::pair{"40 kPa", "m"}, {"3 s", "m/s"}, {"30 deg", "-"}, {"1 m2", "m"}})
    EXPECT_THAT(([quantity = text, of = unit] { read_quantity(quantity, of); }),
                testing::ThrowsMessage<InputError>("has a unit of another kind"));
}

TEST(Units, RefuseWhatIsNoQuantity) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT([] { read_quantity("3 furlong", "m"); }, ThrowsMessage<InputError>(HasSubstr("unknown unit 'furlong'")));
  EXPECT_THAT([] { read_quantity("3 m//s", "m/s"); }, ThrowsMessage<InputError>(HasSubstr("unknown unit 'm//s'")));
  EXPECT_THAT([] { read_quantity("3", "m"); }, ThrowsMessage<InputError>(HasSubstr("without quotes")));
  for (const char* text : {"", "mm", "wide", "nan m", "inf m", "--1 m"})
    EXPECT_THAT([&] { read_quantity(text, "m"); }, ThrowsMessage<InputError>("is not a number with a unit")) << text;
  EXPECT_THROW(read_quantity("1e308 km", "m"), InputError);
}

TEST(Units, MayBePastedFromAPage) {
  EXPECT_EQ(read_quantity("1.5\u00a0mm", "m"), 1.5e-3); // a space that does not break
  EXPECT_EQ(read_quantity("3\u202fµm", "m"), 3e-6);
  EXPECT_EQ(read_quantity("\u22121 kN\u2009m⁻²", "Pa"), -1e3);
  EXPECT_EQ(read_quantity("1e-3 km", "m"), 1.0);
  EXPECT_EQ(read_quantity("1.5mm", "m"), 1.5e-3);
}

TEST(Units, RefuseACommaInANumber) {
  EXPECT_THAT([] { read_quantity("1,5 mm", "m"); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("comma")));
}

TEST(Units, RefuseANumberThatNoDoubleHolds) {
  for (const char* text : {"1e99999999999 m", "1e2147483647 km", "1e-2147483648 nm", "1e400 m", "1e-400 m", "1e308 km"})
    EXPECT_THAT([&] { read_quantity(text, "m"); },
                testing::ThrowsMessage<InputError>("is too large or too small for a number"))
        << text;
  EXPECT_THROW(read_quantity("1e308 h", "s"), InputError);
  EXPECT_EQ(read_quantity("1e-310 km", "m"), 1e-307);
}
