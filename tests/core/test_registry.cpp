/// Names and the objects made from them.
#include "core/base/registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Registry<int()> two_entries() {
  Registry<int()> registry("scheme");
  registry.add({.name = "linear", .summary = "hats", .source = "S"}, [] { return 1; });
  registry.add({.name = "gimp", .summary = "boxes", .source = "B"}, [] { return 2; });
  return registry;
}

TEST(Registry, MakesWhatItsNameStandsFor) {
  const auto registry = two_entries();
  EXPECT_EQ(registry.find("linear").make(), 1);
  EXPECT_EQ(registry.find("gimp").make(), 2);
  EXPECT_EQ(registry.find("gimp").description.summary, "boxes");
  EXPECT_TRUE(registry.known("linear"));
  EXPECT_FALSE(registry.known("line")) << "no part of a name is known";
  EXPECT_THAT(registry.names(), ElementsAre("linear", "gimp")) << "in the order of addition";
}

TEST(Registry, AnswersAnUnknownNameWithTheKnownOnes) {
  const auto registry = two_entries();
  EXPECT_THAT([&] { (void)registry.find("gmip"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("scheme"), HasSubstr("'gmip'"), HasSubstr("linear"), HasSubstr("gimp"))));
}

TEST(Registry, TellsHowToGetWhatThisBuildDoesWithout) {
  auto registry = two_entries();
  registry.leave_out("cpdi", "takes corners, which this build does without");
  EXPECT_FALSE(registry.known("cpdi"));
  EXPECT_THAT([&] { (void)registry.find("cpdi"); },
              ThrowsMessage<InputError>(
                  testing::Eq("scheme 'cpdi' takes corners, which this build does without; known: linear, gimp")));
}

TEST(Registry, RefusesASecondEntryOfOneName) {
  auto registry = two_entries();
  EXPECT_THAT([&] { registry.add({.name = "gimp", .summary = "", .source = ""}, [] { return 3; }); },
              ThrowsMessage<PluginError>(AllOf(HasSubstr("scheme"), HasSubstr("'gimp'"))));
  EXPECT_EQ(registry.find("gimp").make(), 2) << "the first one stays";
}

} // namespace
} // namespace riedel::test
