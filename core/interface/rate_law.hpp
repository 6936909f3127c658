/// Turns a rate equation, written for one point, into a law for blocks of points.
#pragma once

#include "core/interface/batch_group.hpp"

namespace riedel {

/// What a rate equation returns: the objective stress rate [Pa/s] and the rates of the law's own state variables [1/s].
template <class Real, std::size_t States>
struct Rate {
  Sym<Real> stress;
  std::array<Real, States> state;
};

/// How the integration is controlled; every rate law takes these parameters beside its own.
struct IntegrationControl {
  double tolerance = 1e-4;       ///< error allowed in the stress of one sub-step, relative [-]
  double minimum_pressure = 0.0; ///< p below which a frictional law returns or separates [Pa]; 0: no such limit

  static Keys keys();            ///< `tolerance`
  static Keys frictional_keys(); ///< `tolerance` and `minimum_pressure`
  explicit IntegrationControl(const Values& given);
};

/// Explicit integration of order 1(2) with error control. Eight points at a time take one modified Euler (Heun) step;
/// those whose error estimate exceeds the tolerance, and those near zero pressure, are integrated one by one with
/// sub-steps. d (‖D‖ or its average) is frozen over the step.
///
/// A law derives from RateLaw<Law, States>, States being the number of its own state variables, scalars, and provides
///   static constexpr bool frictional;             whether it needs a pressure above zero
///   Rate<Real, States> rate(const Sym<Real>& sigma, const std::array<Real, States>& state,
///                               const Sym<Real>& D, Real d) const;      for Real = double and Real = Pack
/// and the virtual functions of Material but `integrate`. A frictional law declares `separation_variable()` last.
///
/// Low pressure: where a step would end with p below the minimum pressure, an expanding point separates (no stress
/// until its volume is back) and any other returns along its last stress direction to p = p_min. Both depend on
/// invariants only.
template <class Law, std::size_t States>
class RateLaw : public Material {
public:
  explicit RateLaw(const IntegrationControl& control) : control_(control) {}

  void integrate(const MaterialBatch& batch, MaterialReport& report) const final;

protected:
  static StateVariable separation_variable() {
    return {"separation", "-", "volumetric strain since the grains lost contact; 0 in contact"};
  }

private:
  template <class Real>
  using Point = PointState<Real, States>;
  using Group = BatchGroup<States>;
  template <class Real>
  struct Increment {
    Point<Real> end;
    Real error; ///< relative to the stress
  };
  struct Lone { ///< a point integrated alone
    Point<double> point;
    double separation;
  };
  struct Step {
    Sym<double> D;
    double d, time;
  };

  template <class Real>
  Increment<Real> heun(const Point<Real>& start, const Sym<Real>& D, Real d, double dt) const;
  void integrate_mixed(const Group& group, const Point<Pack>& common, const std::array<bool, pack_size>& good,
                       const Pack& d, MaterialReport& report) const;
  std::string_view advance_alone(Lone& lone, const Step& over, MaterialReport& report) const;
  double drift_apart(Lone& lone, const Step& over, double left, MaterialReport& report) const;
  void leave_low_pressure(Lone& lone, const Sym<double>& before, double volume_strain, MaterialReport& report) const;

  [[nodiscard]] const Law& law() const { return static_cast<const Law&>(*this); }
  [[nodiscard]] double least_trace() const { return 3.0 * control_.minimum_pressure; }
  [[nodiscard]] Sym<double> contact_stress() const { return -control_.minimum_pressure * Sym<double>::identity(); }
  IntegrationControl control_;
};

} // namespace riedel

#include "core/interface/rate_law_integration.hpp"
