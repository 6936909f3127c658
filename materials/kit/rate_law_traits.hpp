/// Interface between RateLaw and a law, and properties of a law that RateLaw detects.
#pragma once

#include "materials/kit/batch_group.hpp"

namespace riedel {

/// Result of a rate equation: the objective stress rate [Pa/s] and the rates of the law's state variables [1/s].
template <class Real, std::size_t States>
struct Rate {
  Sym<Real> stress;
  std::array<Real, States> state;
};

/// A law whose `rate` accepts packs; one written for `double` only is integrated point by point.
template <class Law, std::size_t States>
concept RunsOnPacks = requires(const Law& law, const Sym<Pack>& sigma, const std::array<Pack, States>& state, Pack d) {
  law.rate(sigma, state, sigma, d);
};
/// A law may declare `static constexpr bool constant_rate = true`: its rate depends on D alone, and Euler is exact.
template <class Law>
concept HasConstantRate = requires {
  requires Law::constant_rate;
};
/// A law whose state contains a tensor, or may pass through zero, measures changes of its state itself, by invariants:
/// `Real state_change(from, to) const`, relative [-]. The tolerance then also applies to that, in every sub-step.
template <class Law, std::size_t States>
concept MeasuresState = requires(const Law& law, const std::array<double, States>& state) {
  { law.state_change(state, state) } -> std::same_as<double>;
};
/// A frictional law with state variables of the grain contacts: `lose_contact(state)` is called when grains separate.
template <class Law, std::size_t States>
concept LivesInContacts = requires(const Law& law, std::array<double, States>& state) {
  law.lose_contact(state);
};

} // namespace riedel
