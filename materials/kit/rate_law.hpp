/// Turns a rate equation, written for one point, into a law for blocks of points.
#pragma once

#include "materials/kit/runge_kutta.hpp"

#include <optional>

namespace riedel {

/// Control of the integration; every rate law takes these parameters in addition to its own.
struct IntegrationControl {
  double tolerance = 1e-4;       ///< error of stress and state allowed in one step, relative [-]
  double minimum_pressure = 0.0; ///< p below which a point of a frictional law returns or separates [Pa]; 0: no limit

  double cohesion_pressure = 0.0; ///< p_t, added to the pressure in a frictional law [Pa]

  static Keys keys();            ///< `tolerance`
  static Keys frictional_keys(); ///< the same, `minimum_pressure` and `cohesion_pressure`
  explicit IntegrationControl(const Values& given);
};

/// Explicit integration with error control. d (‖D‖ or its average) is constant over the step.
///  - A step that changes neither the stress nor a state variable by more than four times the tolerance, relative,
///    takes one evaluation of the rate (Euler). Euler's method lags by half a step; for a material with fading memory
///    the stress stays within twice the tolerance of the exact path, for any number of steps.
///  - Any other takes two (Heun).
///  - A point that then misses the tolerance, or is near zero pressure, is integrated alone with sub-steps of the
///    Bogacki–Shampine pair.
/// The error of a step is the difference between the two results of its pair, in the stress or in a state variable,
/// relative. Eight points at a time take the first two methods; which one a point takes depends on that point alone.
///
/// A law derives from RateLaw<Law, States>, with States the number of columns of its state variables (a scalar has one,
/// a tensor six), and provides
///   static constexpr bool frictional;             whether it needs a pressure above zero
///   Rate<Real, States> rate(const Sym<Real>& sigma, const std::array<Real, States>& state,
///                               const Sym<Real>& D, Real d) const;      for Real = double and, if it can, Real = Pack
/// and the virtual functions of Material except `integrate`. A frictional law declares `separation_variable()` last.
/// rate_law_traits.hpp describes what else a law may declare.
///
/// Low pressure: a frictional law uses σ − p_t I, p_t being the cohesion pressure, and so p + p_t. If a step would end
/// with p + p_t below the minimum pressure, an expanding point separates (stress-free until its volume is back) and any
/// other returns along its last direction of σ − p_t I to p + p_t = p_min. Both depend on invariants only.
template <class Law, std::size_t States>
class RateLaw : public Material {
public:
  explicit RateLaw(const IntegrationControl& control) : control_(control) {}

  void integrate(const MaterialBatch& batch, MaterialReport& report) const final;

  /// The stress in the law: σ − p_t I of a frictional law. `rate` receives it; `assess` needs it.
  template <class Real>
  [[nodiscard]] Sym<Real> seen(Sym<Real> sigma) const {
    if constexpr (Law::frictional)
      for (std::size_t c = 0; c < 3; ++c) sigma.m[c] = sigma.m[c] - Real(control_.cohesion_pressure);
    return sigma;
  }
  /// For a point that regains contact: the minimum pressure, or none if cohesion carries more than that.
  [[nodiscard]] Sym<double> contact_stress() const {
    return -std::max(control_.minimum_pressure - control_.cohesion_pressure, 0.0) * Sym<double>::identity();
  }

protected:
  static StateVariable separation_variable() {
    return {"separation", "-", "volumetric strain since the grains lost contact; 0 in contact"};
  }

private:
  template <class Real>
  using Point = PointState<Real, States>;
  template <class Real>
  struct Step { ///< the step of one point, or of eight
    Sym<Real> D;
    Real d;
    double time;
  };
  template <class Real>
  struct Trial { ///< a step without sub-steps
    Point<Real> end;
    MaskOf<Real> good;  ///< false for NaN
    MaskOf<Real> twice; ///< needed two evaluations
  };
  struct Lone { ///< a point integrated alone
    Point<double> point;
    double separation;
  };

  template <class Real>
  Rate<Real, States> rate(const Point<Real>& at, const Step<Real>& over) const {
    return law().rate(seen(at.stress), at.state, over.D, over.d);
  }
  template <class Real>
  MaskOf<Real> changes_little(const Point<Real>& start, const Point<Real>& end) const;
  template <class Real>
  Real error(const Point<Real>& start, const PairStep<Real, States>& step) const;
  template <class Real>
  Trial<Real> attempt(const Point<Real>& start, const Real& separation, const Step<Real>& over) const;
  template <class Real>
  static Step<Real> step_of(const BatchGroup<Real, States>& group) {
    const Sym<Real> D = group.rate();
    return {.D = D, .d = group.averaged() ? group.load(group.averaged()) : norm(D), .time = group.time_step()};
  }
  template <class Real>
  static Real separation(const BatchGroup<Real, States>& group) {
    if constexpr (Law::frictional) return group.load(group.separation());
    return Real(0.0);
  }
  void integrate_alone(const MaterialBatch& batch, Index p, MaterialReport& report) const;
  std::string_view advance_alone(Lone& lone, const Step<double>& over, MaterialReport& report) const;
  double move_stress_free(Lone& lone, Step<double> over, double left, MaterialReport& report) const;
  void leave_low_pressure(Lone& lone, const Sym<double>& before, double volume_strain, MaterialReport& report) const;

  [[nodiscard]] const Law& law() const { return static_cast<const Law&>(*this); }
  [[nodiscard]] double min_trace() const { return 3.0 * (control_.minimum_pressure - control_.cohesion_pressure); }
  IntegrationControl control_;
};

} // namespace riedel

#include "materials/kit/rate_law_integration.ipp"
#include "materials/kit/rate_law_substeps.ipp"
