/// What every registered transfer must satisfy, in two and three dimensions, with schemes of several kinds and in all
/// orders of the step. Allocations and threads in whole tests are counted in tests/verification.
#include "transfers/contract.hpp"

namespace riedel::test {
namespace {

class TransferContract : public testing::TestWithParam<std::string> {
protected:
  void SetUp() override { omp_set_num_threads(1); }

  /// Calls `check(scheme)` for schemes that the transfer supports.
  template <class Check>
  static void for_each_scheme(const Check& check) {
    for (const std::string scheme_name : {"gimp", "cpdi", "bspline2"})
      if (goes_with(GetParam(), scheme_name)) check(scheme_name);
  }
};

TEST_P(TransferContract, KeepsMassAndTheMomentaThatItPromises) {
  for_each_scheme([](const std::string& scheme_name) {
    expect_momenta_to_stay<2>(transfer<2>(GetParam()), scheme_name);
    expect_momenta_to_stay<3>(transfer<3>(GetParam()), scheme_name);
  });
}

TEST_P(TransferContract, LeavesATranslationAsItIs) {
  for_each_scheme([](const std::string& scheme_name) {
    expect_a_translation_to_stay<2>(transfer<2>(GetParam()), scheme_name);
    expect_a_translation_to_stay<3>(transfer<3>(GetParam()), scheme_name);
  });
}

TEST_P(TransferContract, GainsNoEnergyWithoutForces) {
  for_each_scheme([](const std::string& scheme_name) {
    expect_no_energy_to_be_gained<2>(transfer<2>(GetParam()), scheme_name);
    expect_no_energy_to_be_gained<3>(transfer<3>(GetParam()), scheme_name);
  });
}

TEST_P(TransferContract, GivesTheSameBitsOnAnyNumberOfThreads) {
  expect_the_same_bits_on_any_threads<2>(transfer<2>(GetParam()), "gimp");
  expect_the_same_bits_on_any_threads<3>(transfer<3>(GetParam()), "gimp");
}

TEST_P(TransferContract, HasWhatItKeepsSortedWithThePoints) {
  expect_point_data_to_be_sorted<2>(transfer<2>(GetParam()), "gimp");
  expect_point_data_to_be_sorted<3>(transfer<3>(GetParam()), "gimp");
}

TEST_P(TransferContract, IsRefusedWithSchemesThatLackWhatItNeeds) {
  for (const std::string& scheme_name : scheme_names()) {
    const auto made = [&] {
      Simulation<2>(model_of<2>(scheme_name, transfer<2>(GetParam()), musl_step<2>), scattered_block<2>({3, 2}, 1e5));
    };
    if (goes_with(GetParam(), scheme_name))
      EXPECT_NO_THROW(made()) << scheme_name;
    else
      EXPECT_THROW(made(), InputError) << scheme_name;
  }
}

TEST_P(TransferContract, IsTheSameInTwoAndThreeDimensions) {
  const auto& in_2d = catalogue().in_2d.transfers.find(GetParam()).description;
  const auto& in_3d = catalogue().in_3d.transfers.find(GetParam()).description;
  EXPECT_EQ(in_2d.summary, in_3d.summary);
  EXPECT_FALSE(in_2d.source.empty());
  EXPECT_EQ(in_2d.parameters.size(), in_3d.parameters.size());
}

INSTANTIATE_TEST_SUITE_P(EveryTransfer, TransferContract, testing::ValuesIn(transfer_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
