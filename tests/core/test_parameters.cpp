/// Bounds, values and exact texts: the basis of the tables of keys.
#include "core/base/error.hpp"
#include "core/base/parameters.hpp"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Bounds, IncludeTheirEndsOrNotAsTheyAreNamed) {
  EXPECT_TRUE(at_least(2).contain(2.0));
  EXPECT_FALSE(at_least(2).contain(std::nextafter(2.0, 1.0)));
  EXPECT_FALSE(more_than(2).contain(2.0));
  EXPECT_TRUE(more_than(2).contain(std::nextafter(2.0, 3.0)));
  EXPECT_TRUE(between(0, 1).contain(0.0) && between(0, 1).contain(1.0));
  EXPECT_FALSE(between(0, 1).contain(-1e-300) || between(0, 1).contain(1.0 + 1e-15));
  EXPECT_FALSE(within(0, 1).contain(0.0) || within(0, 1).contain(1.0));
  EXPECT_TRUE(within(0, 1).contain(1e-300));
}

TEST(Bounds, NeverContainWhatIsNoFiniteNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Bounds& bounds : {Bounds{}, at_least(0), between(-1, 1)})
    for (const double x : {infinity, -infinity, std::nan("")}) EXPECT_FALSE(bounds.contain(x));
}

TEST(Bounds, ReadAsPeopleWriteThem) {
  EXPECT_EQ(at_least(0).text(), "≥ 0");
  EXPECT_EQ(more_than(-1.5).text(), "> -1.5");
  EXPECT_EQ(between(0, 1).text(), "[0, 1]");
  EXPECT_EQ(within(0, 90).text(), "(0, 90)");
  EXPECT_EQ((Bounds{.lower = 0, .upper = 1, .lower_included = false}.text()), "(0, 1]");
  EXPECT_EQ((Bounds{.upper = 3, .upper_included = false}.text()), "< 3");
  EXPECT_EQ(Bounds{}.text(), "any number");
}

TEST(ExactText, ReadsBackToTheSameBits) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double x;
    static_assert(sizeof x == sizeof bits);
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    EXPECT_EQ(std::strtod(exact_text(x).c_str(), nullptr), x) << exact_text(x);
  }
}

TEST(ExactText, IsShortAndAlwaysAFloatingNumber) {
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(1.5e-3), "0.0015");
  EXPECT_EQ(exact_text(50e3), "50000.0");
  EXPECT_EQ(exact_text(-2.0), "-2.0");
  EXPECT_EQ(exact_text(1e300), "1e+300");
}

const Keys keys{
    {"stiffness", 2e7, "Pa", more_than(0), "Young's modulus"},
    {"cells", std::int64_t{4}, "-", at_least(1), "cells"},
    {"name", std::string("sand"), "", {}, "name"},
    {"on", true, "", {}, "switch"},
    {"size", std::vector<double>{1.0, 2.0}, "m", {}, "size"},
    {"step", std::string("auto"), "s", more_than(0), "time step", {"auto"}},
};

TEST(Values, StartFromTheDefaultsOfTheirKeys) {
  Values values(keys);
  EXPECT_EQ(values.number("stiffness"), 2e7);
  EXPECT_EQ(values.integer("cells"), 4);
  EXPECT_EQ(values.number("cells"), 4.0) << "integers count as numbers";
  EXPECT_EQ(values.text("name"), "sand");
  EXPECT_TRUE(values.flag("on"));
  EXPECT_EQ(values.numbers("size"), (std::vector<double>{1.0, 2.0}));
  values.set("stiffness", 5.0);
  EXPECT_EQ(values.number("stiffness"), 5.0);
  EXPECT_FALSE(values.has("stifness"));
  EXPECT_THAT([&] { (void)values.number("stifness"); }, ThrowsMessage<std::out_of_range>(HasSubstr("'stifness'")));
}

TEST(Values, GiveASectionWithoutItsPrefix) {
  Values values;
  values.set("material.e", 1.0);
  values.set("material.n", 2.0);
  values.set("materials.e", 3.0);
  values.set("material", 4.0);
  const Values section = values.section("material");
  EXPECT_EQ(section.all().size(), 2U);
  EXPECT_EQ(section.number("e"), 1.0);
  EXPECT_EQ(section.number("n"), 2.0);
}

TEST(Key, TakesANumberWhenItIsOneOrHasAUnit) {
  const auto takes = [](std::string_view name) {
    for (const Key& key : keys)
      if (key.name == name) return key.takes_number();
    throw std::out_of_range("key");
  };
  EXPECT_TRUE(takes("stiffness"));
  EXPECT_TRUE(takes("step")) << "a word that a number may replace";
  EXPECT_FALSE(takes("name"));
  EXPECT_FALSE(takes("on"));
}

TEST(CheckBounds, NamesOwnerKeyValueRangeAndUnit) {
  Values values(keys);
  EXPECT_NO_THROW(check_bounds(keys, values, "law"));
  values.set("stiffness", -3.5);
  EXPECT_THAT([&] { check_bounds(keys, values, "law"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("law"), HasSubstr("stiffness"), HasSubstr("-3.5"),
                                              HasSubstr("> 0"), HasSubstr("Pa"))));
}

TEST(CheckBounds, LooksAtANumberInThePlaceOfAWordToo) {
  const Keys step{{"step", "auto", "s", more_than(0), "", {"auto"}}};
  Values values(step);
  EXPECT_NO_THROW(check_bounds(step, values, "law"));
  values.set("step", 1e-3);
  EXPECT_NO_THROW(check_bounds(step, values, "law"));
  values.set("step", -1.0);
  EXPECT_THAT([&] { check_bounds(step, values, "law"); }, ThrowsMessage<InputError>(HasSubstr("step = -1")));
}

} // namespace
} // namespace riedel::test
