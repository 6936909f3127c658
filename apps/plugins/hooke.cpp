/// Hooke's law in rates, σ° = λ tr(D) I + 2 μ D: a minimal law.
#include "core/interface/plugin.hpp"
#include "materials/kit/elastic_solid.hpp"
#include "materials/kit/rate_law.hpp"

namespace {

using namespace riedel;

class Hooke final : public RateLaw<Hooke, 0> { // no state variables
public:
  static constexpr std::string_view name = "hooke", summary = "Hooke's law in rates, as a plug-in";
  static constexpr bool frictional = false;
  static constexpr bool constant_rate = true; // depends on D alone: one evaluation is exact

  static Keys parameters() {
    Keys keys = ElasticSolid::keys(); // youngs_modulus, poissons_ratio, density
    for (const Key& key : IntegrationControl::keys()) keys.push_back(key);
    return keys;
  }
  explicit Hooke(const Values& given) : RateLaw(IntegrationControl(given)), solid_(given) {
    check_bounds(parameters(), given, name);
  }

  template <class Real> // a double, or a pack of eight
  Rate<Real, 0> rate(const Sym<Real>&, const std::array<Real, 0>&, const Sym<Real>& D, Real) const {
    return {.stress = solid_.stress(D), .state = {}};
  }

  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] double density(std::span<const double>) const override { return solid_.density; }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override {
    return {.wave_speed = std::sqrt(solid_.longitudinal() / solid_.density)};
  }

private:
  ElasticSolid solid_;
};

} // namespace

RIEDEL_PLUGIN(riedel::material<Hooke>)
