#include "transfers/flip.hpp"

#include "transfers/kit/pointwise.ipp"

namespace riedel {

namespace {

/// A rate of "auto" gives way to a given share per step.
template <int Dim>
Blend<Dim> blend_of(const Values& options) {
  Blend<Dim> rule;
  if (!options.is_text("flip"))
    rule.flip = options.number("flip");
  else if (!options.is_text("damping"))
    rule.damping = options.number("damping");
  return rule;
}

} // namespace

template <int Dim>
Keys Flip<Dim>::parameters() {
  return {{"damping",
           "auto",
           "1/s",
           at_least(0),
           "decay rate of the part of the points' velocities that the grid does not represent",
           {"auto"}},
          {"flip",
           "damping",
           "-",
           between(0, 1),
           "share of FLIP in a step, the rest is PIC; damping: e^(-time.damping dt), so that damping does not "
           "depend on the step size",
           {"damping"}}};
}

template <int Dim>
Flip<Dim>::Flip(const Values& options) : PointwiseTransfer<Dim, Blend<Dim>>(blend_of<Dim>(options)) {}

template <int Dim>
std::string Flip<Dim>::damping_text() const {
  const Blend<Dim>& rule = this->rule_;
  return rule.damping ? "damping " + short_text(*rule.damping) + " 1/s" : "FLIP " + short_text(rule.flip) + " per step";
}

template class PointwiseTransfer<2, Blend<2>>;
template class PointwiseTransfer<3, Blend<3>>;
template class Flip<2>;
template class Flip<3>;

} // namespace riedel
