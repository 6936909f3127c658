/// What RateLaw and a law tell each other, and what RateLaw finds out about the law it integrates.
#pragma once

#include "materials/kit/batch_group.hpp"

namespace riedel {

/// What a rate equation returns: the objective stress rate [Pa/s] and the rates of the law's own state variables [1/s].
template <class Real, std::size_t States>
struct Rate {
  Sym<Real> stress;
  std::array<Real, States> state;
};

/// A law whose `rate` takes packs; one written for `double` alone is integrated point by point.
template <class Law, std::size_t States>
concept RunsOnPacks = requires(const Law& law, const Sym<Pack>& sigma, const std::array<Pack, States>& state, Pack d) {
  law.rate(sigma, state, sigma, d);
};
/// A law may say `static constexpr bool constant_rate = true`: its rate depends on D alone, one evaluation is exact.
template <class Law>
concept HasConstantRate = requires {
  requires Law::constant_rate;
};
/// A law whose state holds a tensor, or may pass through zero, measures changes of its state itself, by invariants:
/// `Real state_change(from, to) const`, relative [-]. The tolerance then holds for that, too, in every sub-step.
template <class Law, std::size_t States>
concept MeasuresState = requires(const Law& law, const std::array<double, States>& state) {
  { law.state_change(state, state) } -> std::same_as<double>;
};
/// A frictional law whose state lives in the contacts of the grains: `lose_contact(state)` is called where they part.
template <class Law, std::size_t States>
concept LivesInContacts = requires(const Law& law, std::array<double, States>& state) {
  law.lose_contact(state);
};

} // namespace riedel
