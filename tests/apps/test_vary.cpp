/// The lists of --vary.
#include "core/base/error.hpp"
#include "core/case/vary.hpp"

#include <gmock/gmock.h>

namespace riedel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<Variant> variants(const std::vector<std::string>& wishes) {
  return variants_of(CaseFile::empty(), variations_of(wishes));
}

std::string error(const std::vector<std::string>& wishes) {
  try {
    (void)variants(wishes);
  } catch (const InputError& refusal) { return refusal.what(); }
  return "no error";
}

std::vector<std::string> names(const std::vector<std::string>& wishes) {
  std::vector<std::string> all;
  for (const Variant& variant : variants(wishes)) all.push_back(variant.name);
  return all;
}

TEST(Variations, PartAtCommasOutsideOfBracketsAndQuotes) {
  EXPECT_THAT(variation_of("grid.cells=[16,56],[24,84]").values, ElementsAre("[16,56]", "[24,84]"));
  EXPECT_THAT(variation_of("a={b=[1,2],c=3}, {b=4}").values, ElementsAre("{b=[1,2],c=3}", "{b=4}"));
  EXPECT_THAT(variation_of(R"(a="x,y",'u"],v',z)").values, ElementsAre(R"("x,y")", R"('u"],v')", "z"));
  EXPECT_THAT(variation_of(" grid.cells = [1, 2] , [3, 4] ").values, ElementsAre("[1, 2]", "[3, 4]"));
}

TEST(Variations, WithBracketsThatDoNotMatchAreRefused) {
  EXPECT_EQ(error({"grid.cells=[16,56"}), "--vary grid.cells=[16,56: a ']' is missing");
  EXPECT_EQ(error({"grid.cells=[16,56]],[1,2]"}), "--vary grid.cells=[16,56]],[1,2]: a ']' has no opening bracket");
  EXPECT_THAT(error({"grid.cells=[16,{56]"}), HasSubstr("a ']' has no opening bracket"));
  EXPECT_THAT(error({"a={b=1"}), HasSubstr("a '}' is missing"));
}

TEST(Variations, WithoutAValueAreRefused) {
  for (const char* wish : {"a", "=1", "a=", "a", ""})
    EXPECT_THAT(error({wish}), HasSubstr("expected KEY=A,B,C")) << wish;
  for (const char* wish : {"a=1,,2", "a=1,", "a=,1", "a= , ", "a=\t"})
    EXPECT_THAT(error({wish}), HasSubstr("a value of the list is empty")) << wish;
}

TEST(Variations, OfOneValueTwiceAreRefused) {
  EXPECT_THAT(error({"a=1, 1"}), HasSubstr("1 is given twice"));
  EXPECT_THAT(error({"a=1", "a=2"}), HasSubstr("a is varied twice"));
  EXPECT_NO_THROW(refuse_same_cases({{"length=1mm", "length = 0.001"}, {"length=2mm", "length = 0.002"}}));
  EXPECT_THAT(
      [] {
        refuse_same_cases({{"length=1mm", "length = 0.001"}, {"length=0.001", "length = 0.001"}});
      },
      testing::ThrowsMessage<InputError>("--vary: length=1mm and length=0.001 are the same case: a value is given "
                                         "twice, in two spellings"));
}

TEST(Variations, AreAsManyAsACampaignHolds) {
  std::string list = "a=0";
  for (int i = 1; i < 40; ++i) list += "," + std::to_string(i);
  EXPECT_THAT(variants({list, "b" + list.substr(1, 50)}), SizeIs(testing::Gt(100U)));
  EXPECT_THAT(error({list, "b" + list.substr(1)}), HasSubstr("more than 1000 runs"));
  std::vector<std::string> wishes;
  for (int i = 0; i < 40; ++i) wishes.push_back("k" + std::to_string(i) + list.substr(1)); // 40^40
  EXPECT_THAT(error(wishes), HasSubstr("more than 1000 runs"));
  for (int i = 40; i < 1001; ++i) list += "," + std::to_string(i);
  EXPECT_THAT(error({list}), HasSubstr("more than 1000 values"));
}

TEST(Variations, GiveEveryRunAFolderOfItsOwn) {
  EXPECT_THAT(names({"a.e=0.6,0.75"}), ElementsAre("e=0.6", "e=0.75"));
  const auto alike = names({"a=x/y,x:y,x*y"});
  EXPECT_THAT(std::set<std::string>(alike.begin(), alike.end()), SizeIs(3));
  EXPECT_THAT(alike, testing::Each(testing::StartsWith("a=x_y~")));
  EXPECT_EQ(names({"a=x/y,x:y,x*y"}), alike); // the same the next time: a campaign that was stopped goes on
}

TEST(Variations, GiveNoFolderANameThatIsTooLong) {
  std::string text = "é"; // two bytes: none is cut in two
  for (int i = 0; i < 8; ++i) text += text;
  const auto all = names({"a=" + text + "," + text + "2"});
  EXPECT_NE(all[0], all[1]);
  for (const std::string& name : all) EXPECT_LT(name.size(), 220U);
}

TEST(Variations, AreNoPathsAndHoldNoSignsThatSteer) {
  EXPECT_THAT(names({"a=../../x"}), ElementsAre("a=.._.._x"));
  for (const char* value : {"x\ny", "\x1b[2J", "\xff"}) EXPECT_NE(error({std::string("a=1,") + value}), "no error");
  EXPECT_THAT(error({"a=1 # one,2"}), HasSubstr("a value cannot contain a comment"));
}

} // namespace
} // namespace riedel
