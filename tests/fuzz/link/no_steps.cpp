// The keys of a case refer to the steps, which readers never take, and to VTK: the fuzzers do not need the libraries.
#include "core/io/commit.hpp"
#include "core/io/with_vtk.hpp"
#include "core/step/musl.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"

#include <cstdlib>
#include <stdexcept>

namespace riedel {

namespace {
[[noreturn]] void refuse() { throw std::logic_error("a reader takes no step"); }
} // namespace

bool with_vtk() { return true; }

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

const char* commit() { return "unknown"; }

} // namespace riedel

// Nor do they start threads, or rotate the states whose names they read.
extern "C" {
void rotsig_(const double*, const double*, double*, const int*, const int*, const int*) { std::abort(); }
int omp_get_max_threads() { return 1; }
int omp_get_num_procs() { return 1; }
}
