/// One law at a few points, without a grid.
#pragma once

#include "core/state/points.hpp"
#include "support/problems.hpp"
#include "support/tensors.hpp"

namespace riedel::test {

/// A registered law with its defaults, with one of its switches the other way round, or with cohesion.
struct LawCase {
  std::string name, label;
  std::map<std::string, Value> with = {};
};
inline void PrintTo(const LawCase& tested, std::ostream* out) { *out << tested.label; }
inline std::vector<LawCase> every_law() {
  std::vector<LawCase> cases;
  for (const std::string& name : law_names()) {
    cases.push_back({name, name});
    for (const Key& key : catalogue().materials.find(name).description.parameters) {
      if (key.name == "cohesion_pressure") cases.push_back({name, name + "_with_cohesion_pressure", {{key.name, 5e3}}});
      if (const bool* flag = std::get_if<bool>(&key.default_value))
        cases.push_back({name, name + "_with_" + key.name, {{key.name, !*flag}}});
    }
  }
  return cases;
}

/// Points with stress, state and rate of deformation, passed to a law as one batch.
struct LawBench {
  std::shared_ptr<const Material> law;
  Columns stress{6}, rate{6}, state;
  AlignedVector<double> averaged;
  MaterialBatch batch;
  MaterialReport report;

  std::vector<double*> columns;

  LawBench(std::shared_ptr<const Material> given, Index size)
      : law(std::move(given)), state(state_components(law->states())) {
    stress.resize(size);
    rate.resize(size);
    state.resize(size);
  }
  void put(Index p, const Sym<double>& sigma, double void_ratio, const Sym<double>& D) {
    for (std::size_t c = 0; c < 6; ++c) stress[static_cast<int>(c)][p] = sigma.m[c];
    put_rate(p, D);
    const int e = state_column(law->states(), "void_ratio");
    if (e >= 0) state[e][p] = void_ratio;
  }
  void put_rate(Index p, const Sym<double>& D) {
    for (std::size_t c = 0; c < 6; ++c) rate[static_cast<int>(c)][p] = D.m[c];
  }
  [[nodiscard]] Sym<double> stress_of(Index p) const { return tensor(stress, 0, p); }
  [[nodiscard]] int column(std::string_view variable) const { return state_column(law->states(), variable); }
  [[nodiscard]] Sym<double> tensor_of(std::string_view variable, Index p) const {
    return tensor(state, column(variable), p);
  }
  void put_tensor(std::string_view variable, Index p, const Sym<double>& value) {
    for (std::size_t c = 0; c < 6; ++c) state[column(variable) + static_cast<int>(c)][p] = value.m[c];
  }
  void integrate(double dt) { integrate(dt, {0, stress.size()}); }
  void integrate(double dt, Range part) {
    columns.clear();
    for (int s = 0; s < state.components(); ++s) columns.push_back(state[s] + part.begin);
    batch.size = part.size();
    batch.time_step = dt;
    for (int c = 0; c < 6; ++c) {
      batch.stress[static_cast<std::size_t>(c)] = stress[c] + part.begin;
      batch.rate[static_cast<std::size_t>(c)] = rate[c] + part.begin;
    }
    batch.averaged = averaged.empty() ? nullptr : averaged.data() + part.begin;
    batch.state = columns;
    law->integrate(batch, report);
  }

private:
  static Sym<double> tensor(const Columns& field, int first, Index p) {
    Sym<double> s;
    for (std::size_t c = 0; c < 6; ++c) s.m[c] = field[first + static_cast<int>(c)][p];
    return s;
  }
};

/// Compresses point 0 along axis 2 by `strain`; axes 1 and 3 share the strain that keeps their stress. Bisection, since
/// the end of a step jumps a little where its sub-steps are cut otherwise.
inline void compress_in_triaxial_cell(LawBench& bench, double strain, double lateral_stress) {
  const auto moved = [&](double lateral) {
    LawBench trial = bench;
    for (int c = 0; c < 6; ++c) trial.rate[c][0] = c == 1 ? -strain : c < 3 ? lateral * strain : 0.0;
    trial.integrate(1.0);
    return trial;
  };
  double low = -0.5, high = 2.0; // lateral over axial strain: too much compression, too little
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (moved(middle).stress_of(0).m[0] < lateral_stress ? low : high) = middle;
  }
  bench = moved(low);
}

} // namespace riedel::test
