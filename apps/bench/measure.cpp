#include "apps/bench/measure.hpp"

#include "core/run/threads.hpp"

#include <algorithm>
#include <chrono>
#include <malloc.h>
#include <numeric>
#include <omp.h>

namespace riedel {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Bytes of the program on the heap.
double bytes_in_use() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// Starts the threads, whose stacks and tables belong to no case.
void set_threads(int threads) {
  require_threads(threads);
  omp_set_num_threads(threads);
  int started = 0;
#pragma omp parallel reduction(+ : started)
  ++started;
}

/// @return seconds, or nothing when stopped
template <int Dim>
std::optional<double> run(Simulation<Dim>& simulation, std::int64_t steps, const BenchEffort& effort) {
  const auto start = Clock::now();
  for (std::int64_t i = 0; i < steps; ++i) {
    if (effort.stop()) return std::nullopt;
    simulation.step();
  }
  return seconds_since(start);
}

/// Number of steps that fills a repeat: a multiple of ten, because a run evaluates the wave speed in every tenth step,
/// and of the interval of the stress filter.
template <int Dim>
std::optional<std::int64_t> steps_of_a_repeat(Simulation<Dim>& simulation, const BenchEffort& effort) {
  constexpr std::int64_t maximum = 1'000'000;
  const StressFilter& filter = simulation.model().stress_filter;
  const std::int64_t round = std::lcm(std::int64_t{10}, std::int64_t{filter.on() ? filter.steps_between : 1});
  for (std::int64_t steps = round;; steps *= 4) {
    const std::optional<double> seconds = run(simulation, steps, effort);
    if (!seconds) return std::nullopt;
    if (*seconds < 0.1 * effort.seconds && steps < maximum) continue; // too short to measure
    const double wanted = effort.seconds / std::max(*seconds, 1e-9) * static_cast<double>(steps);
    const double rounds = std::ceil(wanted / static_cast<double>(round));
    return round * std::min(maximum / round, static_cast<std::int64_t>(rounds));
  }
}

template <int Dim>
std::optional<BenchResult> measure_in(const BenchCase& wanted, const Catalogue& catalogue, const BenchEffort& effort) {
  set_threads(wanted.threads);
  const double bytes_before = bytes_in_use();
  Simulation<Dim> simulation = make_block<Dim>(wanted, catalogue);
  BenchResult result{.of = wanted, .points = simulation.state().bodies.front().points.size()};
  result.wide = simulation.model().scheme->max_nodes() > power(2, Dim);

  const std::optional<std::int64_t> steps = steps_of_a_repeat(simulation, effort); // also warms up
  if (!steps) return std::nullopt;
  result.steps = *steps;
  const double point_steps = static_cast<double>(result.steps) * result.points;
  std::vector<double> repeats;
  for (int i = 0; i < effort.repeats; ++i) {
    set_in_motion(simulation);
    const std::optional<double> seconds = run(simulation, result.steps, effort);
    if (!seconds) return std::nullopt;
    repeats.push_back(1e9 * *seconds / point_steps);
  }
  result.ns = spread_of(repeats);

  set_in_motion(simulation);
  PhaseClock& clock = simulation.state().clock;
  clock.start();
  if (!run(simulation, result.steps, effort)) return std::nullopt;
  clock.stop();
  for (std::size_t i = 0; i < result.phases.size(); ++i)
    result.phases[i] = 1e9 * clock.seconds(static_cast<Phase>(i)) / point_steps;

  result.bytes_per_point = (bytes_in_use() - bytes_before) / result.points;
  result.substepped_share = static_cast<double>(simulation.state().report.substepped) /
                            (static_cast<double>(simulation.state().step) * result.points);
  return result;
}

} // namespace

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {.median = median, .minimum = values.front(), .maximum = values.back()};
}

std::optional<BenchResult> measure(const BenchCase& wanted, const Catalogue& catalogue, const BenchEffort& effort) {
  return wanted.dimension == 2 ? measure_in<2>(wanted, catalogue, effort) : measure_in<3>(wanted, catalogue, effort);
}

} // namespace riedel
