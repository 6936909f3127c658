#include "core/base/suggestion.hpp"

#include <gtest/gtest.h>
#include <vector>

using namespace riedel;

TEST(Suggestion, CountsTheLettersToChange) {
  EXPECT_EQ(edit_distance("gimp", "gimp"), 0);
  EXPECT_EQ(edit_distance("", "gimp"), 4);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("cpid", "cpdi"), 1); // neighbours swapped
}

TEST(Suggestion, FindsTheNearestWordAndIsSilentWhenNoneIsNear) {
  const std::vector<std::string> known{"linear", "gimp", "specimen.width"};
  EXPECT_EQ(nearest("liner", known), "linear");
  EXPECT_EQ(nearest("width", known), "specimen.width");
  EXPECT_EQ(nearest("lin", known), "linear");
  EXPECT_EQ(nearest("loading.width", known), "specimen.width");
  EXPECT_EQ(did_you_mean("spectral", known), "");
  EXPECT_EQ(nearest("gimp", {}), "");
  EXPECT_EQ(nearest("6", std::vector<std::string>{"2", "10"}), "") << "nothing of the word is left";
}
