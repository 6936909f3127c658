/// A catalogue of names for tests of the input: its laws have parameters but no equations, its schemes no
/// weights, its transfers no motion.
#pragma once

#include "core/interface/catalogue.hpp"

namespace riedel {

class FakeLaw final : public Material {
public:
  explicit FakeLaw(std::vector<std::string> averaged) : averaged_(std::move(averaged)) {}

  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] std::vector<std::string> nonlocal_variables() const override { return averaged_; }
  [[nodiscard]] double density(std::span<const double>) const override { return 1.0; }
  void integrate(const MaterialBatch&, MaterialReport&) const override {}
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override { return {}; }

private:
  std::vector<std::string> averaged_;
};

template <int Dim>
class FakeScheme final : public ShapeFunction<Dim> {
public:
  explicit FakeScheme(bool spreads) : spreads_(spreads) {}

  [[nodiscard]] int max_nodes() const override { return 0; }
  [[nodiscard]] int margin() const override { return 0; }
  [[nodiscard]] bool supports_affine() const override { return spreads_; }
  void evaluate(const Grid<Dim>&, const Points<Dim>&, Range, Stencils<Dim>&) const override {}
  [[nodiscard]] Mat<Dim> domain(const Grid<Dim>&, const Points<Dim>&, Index) const override { return Mat<Dim>::Zero(); }

private:
  bool spreads_;
};

/// Moves nothing.
template <int Dim>
class FakeTransfer final : public VelocityTransfer<Dim> {
public:
  explicit FakeTransfer(TransferTraits::Spread spread) : spread_(spread) {}

  [[nodiscard]] TransferTraits traits() const override { return {.spread = spread_}; }
  void map_mass_and_momentum(State<Dim>&, const Model<Dim>&) const override {}
  void points_to_grid(State<Dim>&, const Model<Dim>&) const override {}
  void move_points(State<Dim>&, const Model<Dim>&, double) const override {}
  void grid_to_points(State<Dim>&, const Model<Dim>&, double) const override {}
  void remap_velocity(State<Dim>&, const Model<Dim>&, double) const override {}

private:
  TransferTraits::Spread spread_;
};

/// With the parameters and the needs of those that cases know.
template <int Dim>
void add_fake_transfers(VelocityTransfers<Dim>& transfers) {
  using Spread = TransferTraits::Spread;
  const auto add = [&](const char* name, Spread spread, Keys parameters) {
    transfers.add({name, "a transfer", "a paper", std::move(parameters)},
                  [spread](const Values&) { return std::make_unique<FakeTransfer<Dim>>(spread); });
  };
  add("flip", Spread::any,
      {{"damping", "auto", "1/s", at_least(0), "a rate", {"auto"}},
       {"flip", "damping", "-", between(0, 1), "a share", {"damping"}}});
  add("apic", Spread::needed, {});
  add("tpic", Spread::wanted, {});
  add("xpic", Spread::any, {{"xpic_order", std::int64_t{2}, "-", between(1, 40), "a power"}});
}

inline Catalogue fake_catalogue() {
  Catalogue catalogue;
  for (const std::string name : {"linear", "gimp", "cpgimp", "cpdi"})
    catalogue.in_2d.schemes.add({name, "a scheme", "a paper"},
                                [name](const Values&) { return std::make_unique<FakeScheme<2>>(name != "linear"); });
  catalogue.in_3d.schemes.add({"cpdi", "a scheme", "a paper"},
                              [](const Values&) { return std::make_unique<FakeScheme<3>>(true); });
  for (const char* name : {"cgal_kd_tree", "cell_list"})
    catalogue.in_2d.searches.add({name, "a search", "a paper"}, [] { return nullptr; });
  catalogue.in_2d.averagers.add({"gauss", "an averager", "a paper"}, [](double, auto) { return nullptr; });

  add_fake_transfers(catalogue.in_2d.transfers);
  add_fake_transfers(catalogue.in_3d.transfers);

  const Keys sand{{"phi_c", 30.0, "deg", within(0, 90), "critical angle"},
                  {"h_s", 190e6, "Pa", more_than(0), "hardness"},
                  {"n", 0.5, "-", within(0, 1), "exponent"},
                  {"e_i0", 1.3, "-", more_than(0), "loosest"},
                  {"e_d0", 0.51, "-", more_than(0), "densest"},
                  {"e_c0", 0.82, "-", more_than(0), "critical"},
                  {"intergranular_strain", false, "", {}, "a switch"}};
  const auto law = [](std::vector<std::string> averaged) {
    return [averaged](const Values&) { return std::make_unique<FakeLaw>(averaged); };
  };
  catalogue.materials.add({"gudehus_bauer", "a law for sand", "a paper", sand}, law({"rate_norm", "void_ratio"}));
  catalogue.materials.add(
      {"linear_elastic", "Hooke's law", "a paper", {{"youngs_modulus", 1e7, "Pa", more_than(0), "E"}}}, law({}));
  return catalogue;
}

} // namespace riedel
