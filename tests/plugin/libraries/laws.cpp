/// Laws that fail: while they are made, by throwing or by a crash, and in a run, by NaN, by a report or by throwing.
#include "core/interface/plugin.hpp"
#include "materials/kit/rate_law.hpp"

#include <csignal>

namespace {

using namespace riedel;

class Bad : public Material {
public:
  [[nodiscard]] std::span<const StateVariable> states() const override { return {}; }
  [[nodiscard]] double density(std::span<const double>) const override { return 2000.0; }
  [[nodiscard]] MaterialLimits assess(const MaterialBatch&) const override { return {.wave_speed = 100.0}; }
  void integrate(const MaterialBatch&, MaterialReport&) const override {}
};

struct Throws final : Bad {
  static constexpr std::string_view name = "throws";
  Throws() { throw std::runtime_error("it has no licence"); }
};
struct Crashes final : Bad {
  static constexpr std::string_view name = "crashes";
  Crashes() { std::raise(SIGSEGV); }
};
struct NotANumber final : Bad {
  static constexpr std::string_view name = "not_a_number";
  void integrate(const MaterialBatch& batch, MaterialReport&) const override {
    for (Index p = 0; p < batch.size; ++p) batch.stress[0][p] = std::nan("");
  }
};
struct ThrowsInARun final : Bad {
  static constexpr std::string_view name = "throws_in_a_run";
  void integrate(const MaterialBatch& batch, MaterialReport&) const override {
    if (batch.time > 3e-4) throw std::runtime_error("it has lost its licence");
  }
};
struct Fails final : Bad {
  static constexpr std::string_view name = "fails";
  void integrate(const MaterialBatch&, MaterialReport& report) const override { report.fail(0, "it is Monday"); }
};

} // namespace

RIEDEL_PLUGIN(riedel::material<Throws>, riedel::material<Crashes>, riedel::material<NotANumber>,
              riedel::material<Fails>, riedel::material<ThrowsInARun>)
