/// A constitutive law: from a block of strain rates to stresses. Always three-dimensional, so that the same law serves
/// a single point, plane strain and 3-D.
#pragma once

#include "core/base/registry.hpp"
#include "core/base/types.hpp"

#include <span>

namespace riedel {

/// A state variable that the law declares and the solver carries.
struct StateVariable {
  std::string name;
  std::string unit;
  std::string doc;
  int components = 1; ///< 1: scalar; 6: symmetric tensor in Mandel components, rotated by the solver
};

/// How points moved over a step, for a law that follows their motion: matrices, row by row.
struct Motion {
  std::array<const double*, 9> velocity_gradient{};    ///< L [1/s]
  std::array<const double*, 9> deformation_gradient{}; ///< F at the end of the step [-]
  std::array<const double*, 9> gradient_before{};      ///< F at its start [-]
  std::array<const double*, 9> rotation{};             ///< Q, by which stress and tensors have been turned [-]
};

/// The points handed to a law at once: columns of `size` numbers.
struct MaterialBatch {
  Index size = 0;
  double time_step = 0.0;          ///< Δt [s]
  double time = 0.0;               ///< at the start of the step [s]
  double stage_time = 0.0;         ///< the same, since the stage of the test began [s]
  int stage = 1;                   ///< of the test, from 1
  std::int64_t increment = 1;      ///< number of the step in its stage, from 1
  std::array<double*, 6> stress{}; ///< Cauchy, tension positive, Mandel, already rotated by the solver [Pa]; in, out
  std::array<const double*, 6> rate{}; ///< rate of deformation D, Mandel [1/s]
  const double* averaged = nullptr;    ///< non-local average of the scalar the law named; null: local
  std::span<double* const> state{};    ///< a column per component of the declared variables; in, out
  const Motion* motion = nullptr;      ///< for a law that follows it; null where only rates of strain are known
  const Index* id = nullptr;           ///< numbers that the points keep, from 0; null: their places in the batch
};

/// What happened inside one call, or many.
struct MaterialReport {
  std::int64_t evaluated_twice = 0;   ///< points whose step took a second evaluation of the rate
  std::int64_t substepped = 0;        ///< points whose step had to be cut
  std::int64_t substeps = 0;          ///< taken by points that were integrated alone
  std::int64_t rejected_substeps = 0; ///< of theirs, tried and found too long
  std::int64_t low_pressure = 0;      ///< points returned to the least pressure
  std::int64_t separated = 0;         ///< points that carry no stress
  std::int64_t failures = 0;          ///< points that could not be integrated; their state is left as it was
  Index first_failure = -1;
  std::string_view reason{}; ///< why the first one failed

  void add(const MaterialReport& other, Index offset);
  void fail(Index point, std::string_view why); ///< counts a point that could not be integrated
};

/// The state of a block as the time step and the run's report need it.
struct MaterialLimits {
  double wave_speed = 0.0;        ///< greatest speed of a compression wave [m/s]
  std::int64_t out_of_bounds = 0; ///< points whose state the law does not admit (a void ratio below e_d, say)

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
  /// Scalars that the law can take averaged over a neighbourhood: `rate_norm` (‖D‖) or one of its state variables.
  [[nodiscard]] virtual std::vector<std::string> nonlocal_variables() const { return {}; }
  /// Values of the state components before anything has happened; a driver puts its void ratio in their place.
  [[nodiscard]] virtual std::vector<double> initial_state() const;
  /// Whether the law asks for the points' motion beside the rate of deformation; their rotation is the solver's.
  [[nodiscard]] virtual bool follows_motion() const { return false; }
  /// @param state one value per state component   @return bulk density [kg/m³]
  [[nodiscard]] virtual double density(std::span<const double> state) const = 0;
  /// Advances stress and state by one step. What fails at a point stands in the report; an exception ends the run, on
  /// whatever thread it is thrown.
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

/// Number of columns that the variables take.
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
