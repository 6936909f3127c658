/// The transfer that docs/howto/add_a_transfer.md walks through: it is what the page shows, and keeps the contract.
#include "docs/howto/aflip.hpp"
#include "support/howto_page.hpp"
#include "transfers/contract.hpp"

namespace riedel::test {
namespace {

TEST(HowtoAddATransfer, ShowsTheExampleAsItStandsInLessThanSixtyLines) {
  expect_page_to_show("docs/howto/add_a_transfer.md", "docs/howto/aflip.hpp");
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
