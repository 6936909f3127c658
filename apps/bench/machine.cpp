#include "apps/bench/machine.hpp"

#include "apps/bench/bare_kernel.hpp"
#include "apps/bench/measure.hpp"
#include "apps/built_in.hpp"
#include "materials/gudehus_bauer.hpp"
#include "materials/intergranular_strain.hpp"
#include "materials/von_wolffersdorff.hpp"

#include <chrono>

namespace riedel {

namespace {

/// Keeps the compiler from removing a loop whose result is not used.
void use(double x) {
  static_assert(sizeof(x) == 8);
  asm volatile("" : : "m"(x) : "memory");
}

/// Median seconds of one call, 0 when stopped.
double seconds_per_call(const BenchEffort& effort, const std::function<void()>& call) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;
  std::int64_t calls = 1;
  while (static_cast<int>(seconds.size()) < effort.repeats) {
    if (effort.stop()) return 0.0;
    const auto start = Clock::now();
    for (std::int64_t i = 0; i < calls; ++i) call();
    const double taken = std::chrono::duration<double>(Clock::now() - start).count();
    if (taken < effort.seconds) // also warms up
      calls *= 2;
    else
      seconds.push_back(taken / static_cast<double>(calls));
  }
  return spread_of(seconds).median;
}

/// STREAM's triad: 24 bytes per entry, without those that are read only to be overwritten.
double triad_seconds(std::size_t size, const BenchEffort& effort) {
  AlignedVector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
  return seconds_per_call(effort, [&] {
    const Pack s(3.0);
    for (std::size_t i = 0; i < size; i += pack_size)
      (Pack::load(b.data() + i) + s * Pack::load(c.data() + i)).store(a.data() + i);
    use(a[size / 2]);
  });
}

/// GFLOP/s of multiply-adds in registers: as many chains as there are free registers.
double fma_rate(const BenchEffort& effort) {
  constexpr int chains = 12 / detail::registers, rounds = 1000;
  const double seconds = seconds_per_call(effort, [&] {
    const Pack x(0.999999), y(1e-6);
    std::array<Pack, chains> sum;
    for (int i = 0; i < chains; ++i) sum[i] = Pack(1.0 + i);
    for (int n = 0; n < rounds; ++n)
      for (Pack& each : sum) each = each * x + y;
    for (const Pack& each : sum) {
      std::array<double, pack_size> lane;
      each.store(lane.data());
      use(lane[0]);
    }
  });
  return 2e-9 * chains * rounds * pack_size / seconds;
}

constexpr std::size_t numbers = 1024; ///< arguments of a function, in L1

/// Nanoseconds per number of f(double) or f(Pack), over the same numbers.
template <class Real, class F>
double function_time(const BenchEffort& effort, const F& f) {
  AlignedVector<double> x(numbers), y(numbers);
  for (std::size_t i = 0; i < numbers; ++i) x[i] = 1e-3 + 1e-3 * static_cast<double>(i);
  const double seconds = seconds_per_call(effort, [&] {
    if constexpr (std::is_same_v<Real, Pack>)
      for (std::size_t i = 0; i < numbers; i += pack_size) f(Pack::load(x.data() + i)).store(y.data() + i);
    else
      for (std::size_t i = 0; i < numbers; ++i) y[i] = f(x[i]);
    use(y[7]);
  });
  return 1e9 * seconds / numbers;
}

/// One rate of the law at a stress that differs from point to point, compiled as a whole as in RateLaw. State variables
/// after the void ratio are small strains.
template <class Real, class Law, std::size_t States>
[[gnu::flatten]] double rate_time(const RateLaw<Law, States>& law, const BenchEffort& effort) {
  std::array<Real, States> state;
  for (std::size_t s = 0; s < States; ++s) state[s] = Real(s == 0 ? bench_block::void_ratio : 1e-5);
  return function_time<Real>(effort, [&](const Real& x) {
    const Real p = Real(-bench_block::pressure) * (Real(1.0) + Real(0.1) * x), zero(0.0);
    const Sym<Real> sigma{{p, Real(1.2) * p, Real(1.1) * p, Real(0.1) * p, zero, zero}};
    const Sym<Real> D{{x, -x, zero, Real(0.5) * x, zero, zero}};
    const auto rate = static_cast<const Law&>(law).rate(sigma, state, D, norm(D));
    Real sum = trace(rate.stress) + rate.stress.m[3];
    for (const Real& each : rate.state) sum += each;
    return sum;
  });
}

template <class Law>
LawTimes law_times(const std::string& name, const Catalogue& catalogue, const BenchEffort& effort) {
  const Law law{Values(catalogue.materials.find(name.substr(0, name.find(','))).description.parameters)};
  return {.law = name, .pack = rate_time<Pack>(law, effort), .scalar = rate_time<double>(law, effort)};
}

template <int Nodes>
double bare_kernel_time(Index points, const BenchEffort& effort) {
  const Simulation<2> block = make_block<2>({.order = "usl", .points = points}, full_catalogue());
  const State<2>& state = block.state();
  const GudehusBauer law{Values(GudehusBauer::parameters())};
  BareKernel<GudehusBauer, 1, Nodes> kernel(law, state.grid, state.bodies.front().points, bench_block::pressure,
                                            bench_block::flip);
  const double dt = block.time_step();
  return 1e9 * seconds_per_call(effort, [&] { kernel.step(dt); }) / state.bodies.front().points.size();
}

} // namespace

double BareKernelTimes::nearest(bool wide, int points_of_case) const {
  // By ratio, the middle of two sizes is their geometric mean.
  const bool small = static_cast<double>(points_of_case) * points_of_case < double{points[0]} * points[1];
  return (wide ? gimp : linear)[small ? 0 : 1];
}

BareKernelTimes measure_bare_kernel(const BenchEffort& effort) {
  BareKernelTimes times;
  for (std::size_t i = 0; i < BareKernelTimes::points.size(); ++i) {
    times.linear[i] = bare_kernel_time<2>(BareKernelTimes::points[i], effort);
    times.gimp[i] = bare_kernel_time<3>(BareKernelTimes::points[i], effort);
  }
  return times;
}

MachineLimits measure_machine(const BenchEffort& effort) {
  constexpr std::size_t in_memory = 1 << 24, in_l2 = 170 * 1024 / sizeof(double) / pack_size * pack_size;
  const auto rate = [](std::size_t size, double seconds) { return 24e-9 * static_cast<double>(size) / seconds; };
  const Catalogue catalogue = full_catalogue();
  const auto exponential = [](const auto& x) { return exp(-x); };
  const auto power = [](const auto& x) { return pow(x, std::decay_t<decltype(x)>(0.3)); };
  return {
      .triad_memory = rate(in_memory, triad_seconds(in_memory, effort)),
      .triad_l2 = rate(in_l2, triad_seconds(in_l2, effort)),
      .fma = fma_rate(effort),
      .exp_pack = function_time<Pack>(effort, exponential),
      .exp_scalar = function_time<double>(effort, exponential),
      .pow_pack = function_time<Pack>(effort, power),
      .pow_scalar = function_time<double>(effort, power),
      .laws = {law_times<GudehusBauer>("gudehus_bauer", catalogue, effort),
               law_times<VonWolffersdorff>("von_wolffersdorff", catalogue, effort),
               law_times<IntergranularStrain<GudehusBauer>>("gudehus_bauer, intergranular strain", catalogue, effort),
               law_times<IntergranularStrain<VonWolffersdorff>>("von_wolffersdorff, intergranular strain", catalogue,
                                                                effort)}};
}

} // namespace riedel
