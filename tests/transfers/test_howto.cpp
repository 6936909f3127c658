/// The transfer that docs/howto/add_a_transfer.md walks through: it is what the page shows, and keeps the contract.
#include "docs/howto/aflip.hpp"
#include "transfers/contract.hpp"

#include <fstream>
#include <sstream>

namespace riedel::test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(SOURCE_DIR) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(HowtoAddATransfer, ShowsTheExampleAsItStandsInLessThanSixtyLines) {
  const std::string example = text_of("docs/howto/aflip.hpp");
  ASSERT_FALSE(example.empty());
  EXPECT_LT(std::ranges::count(example, '\n'), 60);
  EXPECT_NE(text_of("docs/howto/add_a_transfer.md").find("```cpp\n" + example + "```"), std::string::npos);
}

TEST(HowtoAddATransfer, HasAnExampleThatKeepsTheContract) {
  const auto aflip = std::make_shared<Aflip<2>>(Values(Aflip<2>::parameters()));
  expect_momenta_to_stay<2>(aflip, "gimp");
  expect_a_translation_to_stay<2>(aflip, "gimp");
  expect_no_energy_to_be_gained<2>(aflip, "gimp");
  expect_the_same_bits_on_any_threads<2>(aflip, "gimp");
  expect_point_data_to_be_sorted<2>(aflip, "gimp");
}

} // namespace
} // namespace riedel::test
