// The keys of a case name the steps, which readers never take: the fuzzers do without the library of core.
#include "core/step/musl.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"

#include <stdexcept>

namespace riedel {

namespace {
[[noreturn]] void refuse() { throw std::logic_error("a reader takes no step"); }
} // namespace

template <int Dim>
void musl_step(State<Dim>&, const Model<Dim>&, double) {
  refuse();
}
template <int Dim>
void usl_step(State<Dim>&, const Model<Dim>&, double) {
  refuse();
}
template <int Dim>
void usf_step(State<Dim>&, const Model<Dim>&, double) {
  refuse();
}
template void musl_step<2>(State<2>&, const Model<2>&, double);
template void musl_step<3>(State<3>&, const Model<3>&, double);
template void usl_step<2>(State<2>&, const Model<2>&, double);
template void usl_step<3>(State<3>&, const Model<3>&, double);
template void usf_step<2>(State<2>&, const Model<2>&, double);
template void usf_step<3>(State<3>&, const Model<3>&, double);

} // namespace riedel
