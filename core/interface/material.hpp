/// A constitutive law: from a block of strain rates to stresses. Always three-dimensional, so that one law serves a
/// single point, plane strain and 3-D.
#pragma once

#include "core/base/registry.hpp"
#include "core/base/types.hpp"

#include <span>

namespace riedel {

/// A state variable, declared by the law and stored by the solver.
struct StateVariable {
  std::string name;
  std::string unit;
  std::string doc;
  int components = 1; ///< 1: scalar; 6: symmetric tensor in Mandel components, rotated by the solver
};

/// Motion of points over a step, for laws that follow it: matrices, row by row.
struct Motion {
  std::array<const double*, 9> velocity_gradient{};    ///< L [1/s]
  std::array<const double*, 9> deformation_gradient{}; ///< F at the end of the step [-]
  std::array<const double*, 9> gradient_before{};      ///< F at its start [-]
  std::array<const double*, 9> rotation{};             ///< Q, by which stress and tensors have been rotated [-]
};

/// The points passed to a law at once: columns of `size` numbers.
struct MaterialBatch {
  Index size = 0;
  double time_step = 0.0;          ///< Δt [s]
  double time = 0.0;               ///< at the start of the step [s]
  double stage_time = 0.0;         ///< the same, from the start of the test's stage [s]
  int stage = 1;                   ///< of the test, counted from 1
  std::int64_t increment = 1;      ///< number of the step in its stage, counted from 1
  std::array<double*, 6> stress{}; ///< Cauchy, tension positive, Mandel, already rotated by the solver [Pa]; in, out
  std::array<const double*, 6> rate{}; ///< rate of deformation D, Mandel [1/s]
  const double* averaged = nullptr;    ///< non-local average of the scalar the law named; null: local
  std::span<double* const> state{};    ///< one column per component of the declared variables; in, out
  const Motion* motion = nullptr;      ///< for a law that follows it; null if only strain rates are known
  const Index* id = nullptr;           ///< permanent numbers of the points, from 0; null: their places in the batch
};

/// Events in one call or in several.
struct MaterialReport {
  std::int64_t evaluated_twice = 0;   ///< points whose step needed a second evaluation of the rate
  std::int64_t substepped = 0;        ///< points whose step was divided into substeps
  std::int64_t substeps = 0;          ///< taken by points that were integrated one by one
  std::int64_t rejected_substeps = 0; ///< of these, attempts that were too long
  std::int64_t low_pressure = 0;      ///< points returned to the minimum pressure
  std::int64_t separated = 0;         ///< stress-free points, grains out of contact
  std::int64_t failures = 0;          ///< points that could not be integrated; their state is unchanged
  Index first_failure = -1;
  std::string_view reason{}; ///< why the first one failed

  void add(const MaterialReport& other, Index offset);
  void fail(Index point, std::string_view why); ///< counts a point that could not be integrated
};

/// The state of a block, as needed for the time step and the run's report.
struct MaterialLimits {
  double wave_speed = 0.0;        ///< largest speed of a compression wave [m/s]
  std::int64_t out_of_bounds = 0; ///< points whose state the law does not admit (for example a void ratio below e_d)

  void add(const MaterialLimits& other) {
    wave_speed = std::max(wave_speed, other.wave_speed);
    out_of_bounds += other.out_of_bounds;
  }
};

class Material {
public:
  virtual ~Material() = default;
  Material() = default;
  Material(const Material&) = delete;
  Material& operator=(const Material&) = delete;

  [[nodiscard]] virtual std::span<const StateVariable> states() const = 0;
  /// Scalars of which the law can use a non-local average: `rate_norm` (‖D‖) or one of its state variables.
  [[nodiscard]] virtual std::vector<std::string> nonlocal_variables() const { return {}; }
  /// Initial values of the state components; a driver replaces the void ratio by its own.
  [[nodiscard]] virtual std::vector<double> initial_state() const;
  /// Whether the law also needs the points' motion, not only the rate of deformation; the solver rotates its tensors.
  [[nodiscard]] virtual bool follows_motion() const { return false; }
  /// @param state one value per state component   @return bulk density [kg/m³]
  [[nodiscard]] virtual double density(std::span<const double> state) const = 0;
  /// Advances stress and state by one step. Failures at points go into the report; an exception ends the run, whichever
  /// thread throws it.
  virtual void integrate(const MaterialBatch& batch, MaterialReport& report) const = 0;
  [[nodiscard]] virtual MaterialLimits assess(const MaterialBatch& batch) const = 0;
};

using Materials = Registry<std::unique_ptr<Material>(const Values&)>;

inline void MaterialReport::add(const MaterialReport& other, Index offset) {
  evaluated_twice += other.evaluated_twice;
  substepped += other.substepped;
  substeps += other.substeps;
  rejected_substeps += other.rejected_substeps;
  low_pressure += other.low_pressure;
  separated += other.separated;
  if (failures == 0 && other.failures > 0) {
    first_failure = other.first_failure + offset;
    reason = other.reason;
  }
  failures += other.failures;
}

inline void MaterialReport::fail(Index point, std::string_view why) {
  if (failures++ == 0) first_failure = point, reason = why;
}

/// Number of columns of the variables.
inline int state_components(std::span<const StateVariable> states) {
  int count = 0;
  for (const StateVariable& variable : states) count += variable.components;
  return count;
}
inline std::vector<double> Material::initial_state() const {
  return std::vector<double>(static_cast<std::size_t>(state_components(states())), 0.0);
}

/// Column of the variable called `name`, or −1.
inline int state_column(std::span<const StateVariable> states, std::string_view name) {
  int column = 0;
  for (const StateVariable& variable : states) {
    if (variable.name == name) return column;
    column += variable.components;
  }
  return -1;
}

} // namespace riedel
