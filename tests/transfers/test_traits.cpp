/// The traits of a transfer reach the checks of a simulation and of a case, whatever its name.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/specimen.hpp"
#include "core/case/checked_case.hpp"
#include "core/case/step_keys.hpp"
#include "transfers/contract.hpp"
#include "transfers/kit/blend.hpp"
#include "transfers/kit/pointwise.ipp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// FLIP that does not support USL, with its own rate and number.
template <int Dim>
class Choosy final : public PointwiseTransfer<Dim, Blend<Dim>> {
public:
  static Keys parameters() {
    return {{"fading", "auto", "1/s", at_least(0), "rate at which it fades", {"auto"}},
            {"choice", 3.0, "-", between(0, 9), "number of its own"}};
  }
  explicit Choosy(const Values& options)
      : PointwiseTransfer<Dim, Blend<Dim>>({.damping = options.number("fading")}), choice(options.number("choice")) {}
  [[nodiscard]] TransferTraits traits() const override { return {.usl = false}; }
  [[nodiscard]] std::string damping_text() const override { return "fading " + short_text(*this->rule_.damping); }
  double choice;
};

template <int Dim>
void add_to(VelocityTransfers<Dim>& transfers, Keys parameters) {
  transfers.add({.name = "choosy", .summary = "s", .source = "s", .parameters = std::move(parameters)},
                [](const Values& options) { return std::make_unique<Choosy<Dim>>(options); });
}

Catalogue with_choosy(const Keys& parameters = Choosy<2>::parameters()) {
  Catalogue all = full_catalogue();
  add_to(all.in_2d.transfers, parameters);
  add_to(all.in_3d.transfers, parameters);
  return all;
}

CheckedCase checked(const std::vector<std::string>& settings) {
  CaseFile file = CaseFile::empty();
  for (const std::string& setting : settings) file.override_with(setting);
  return biaxial_case(file, with_choosy());
}

std::string refusal(const std::vector<std::string>& settings) {
  try {
    checked(settings);
  } catch (const InputError& error) { return error.what(); }
  return "accepted";
}

TEST(TransferTraits, RefuseAnOrderOfTheStepInASimulationAndInACase) {
  Values options;
  options.set("fading", 1.0);
  options.set("choice", 3.0);
  try {
    Simulation<2>(model_of<2>("gimp", std::make_shared<Choosy<2>>(options), usl_step<2>),
                  scattered_block<2>({3, 2}, 1e5));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("does not go with the order usl"), HasSubstr("allowed: musl, usf")));
  }
  EXPECT_THAT(refusal({"time.transfer=choosy", "time.order=usl"}),
              AllOf(HasSubstr("\"choosy\" does not go with \"usl\""), HasSubstr("\"musl\" or \"usf\"")));
  EXPECT_EQ(refusal({"time.transfer=choosy", "time.order=usf"}), "accepted");
}

TEST(TransferParameters, BecomeKeysOfTheTimeAndReachTheTransfer) {
  const CheckedCase given = checked({"time.transfer=choosy", "time.choice=4", "grid.cells=[4,14]"});
  const Simulation<2> simulation = make_biaxial<2>(BiaxialCase(given.values), with_choosy());
  const auto& made = dynamic_cast<const Choosy<2>&>(*simulation.model().transfer);
  EXPECT_EQ(made.choice, 4.0);
  EXPECT_THAT(made.damping_text(), AllOf(HasSubstr("fading "), testing::Not(HasSubstr("fading 0"))))
      << "the rate of waves takes the place of auto";
  EXPECT_THAT(refusal({"time.transfer=flip", "time.choice=4"}),
              AllOf(HasSubstr("means nothing to \"flip\""), HasSubstr("time.transfer = \"choosy\"")));
  EXPECT_THAT(refusal({"time.transfer=choosy", "time.choice=10"}), HasSubstr("time.choice"));
}

TEST(TransferParameters, MayNotHaveTheNameOfAKeyOfTheStep) {
  try {
    step_keys(with_choosy({{"cfl", 1.0, "-", {}, "taken"}}));
    FAIL() << "accepted";
  } catch (const PluginError& error) { EXPECT_THAT(error.what(), HasSubstr("time.cfl")); }
}

TEST(Transfer, IsFlipWhereNoneIsNamedAndNeverNone) {
  EXPECT_EQ(Model<2>().transfer->damping_text(), transfer<2>("flip")->damping_text());
  EXPECT_THROW(Simulation<2>(model_of<2>("gimp", nullptr, musl_step<2>), scattered_block<2>({3, 2}, 1e5)), InputError);
}

} // namespace
} // namespace riedel::test
