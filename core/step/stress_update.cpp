#include "core/step/stress_update.hpp"

#include "core/base/parallel.hpp"
#include "core/step/rotation.hpp"

#include <numeric>

namespace riedel {

namespace {

/// One block's columns as a law sees them; lives on the stack.
template <int Dim>
struct Block {
  const Range range;
  std::array<std::array<double, block_size>, 6> D;
  std::array<double*, most_state_columns> state{};
  MaterialBatch batch;

  Block(Points<Dim>& points, Range r, double dt) : range(r) {
    batch.size = r.size();
    batch.time_step = dt;
    for (int c = 0; c < 6; ++c) {
      batch.stress[c] = points.stress[c] + r.begin;
      batch.rate[c] = D[c].data();
    }
    for (int s = 0; s < points.state.components(); ++s) state[s] = points.state[s] + r.begin;
    batch.state = {state.data(), static_cast<std::size_t>(points.state.components())};
  }

  void fill_rate(const Points<Dim>& points) {
    const auto L = [&](int i, int j, Index p) { return Pack::load(points.velocity_gradient[i * Dim + j] + p); };
    for (Index p = range.begin, i = 0; p < range.end; p += pack_size, i += pack_size) {
      Sym<Pack> d = Sym<Pack>::zero();
      for (int a = 0; a < Dim; ++a) {
        d.m[a] = L(a, a, p);
        for (int b = 0; b < a; ++b) d.m[a + b + 2] = Pack(std::numbers::sqrt2 / 2) * (L(a, b, p) + L(b, a, p));
      }
      for (int c = 0; c < 6; ++c) d.m[c].store(D[c].data() + i);
    }
  }

  /// Σ V σ:D with the stress as it is now [W or W/m]
  [[nodiscard]] double power(const Points<Dim>& points) const {
    Pack sum(0.0); // columns are padded with points of no volume
    for (Index p = range.begin, i = 0; p < range.end; p += pack_size, i += pack_size) {
      Pack density(0.0);
      for (int c = 0; c < 6; ++c) density += Pack::load(batch.stress[c] + i) * Pack::load(D[c].data() + i);
      sum += Pack::load(points.volume[0] + p) * density;
    }
    alignas(64) std::array<double, pack_size> lane;
    sum.store(lane.data());
    return std::accumulate(lane.begin(), lane.end(), 0.0);
  }
};

/// Calls rotate(columns of a symmetric tensor) for the stress and for each tensor among the state variables.
template <int Dim, class Rotate>
void for_each_tensor(Body<Dim>& body, const Rotate& rotate) {
  const auto columns_from = [](Columns& field, int first) {
    std::array<double*, 6> columns;
    for (int c = 0; c < 6; ++c) columns[c] = field[first + c];
    return columns;
  };
  rotate(columns_from(body.points.stress, 0));
  int column = 0;
  for (const StateVariable& variable : body.material->states()) {
    if (variable.components == 6) rotate(columns_from(body.points.state, column));
    column += variable.components;
  }
}

void rotate_block(Body<2>& body, Range block, double dt) {
  const Points<2>& points = body.points;
  for_each_tensor(body, [&](const std::array<double*, 6>& tensor) {
    for (Index p = block.begin; p < block.end; p += pack_size) { // columns are padded to whole packs
      const Pack w =
          Pack(0.5) * (Pack::load(points.velocity_gradient[1] + p) - Pack::load(points.velocity_gradient[2] + p));
      Sym<Pack> a = Sym<Pack>::zero();
      for (const int c : {0, 1, 3}) a.m[c] = Pack::load(tensor[c] + p);
      rotate_in_plane(a, w, dt);
      for (const int c : {0, 1, 3}) a.m[c].store(tensor[c] + p);
    }
  });
}

void rotate_block(Body<3>& body, Range block, double dt) {
  const Columns& L = body.points.velocity_gradient;
  const auto w = [&](int i, int j, Index p) {
    return Pack(0.5) * (Pack::load(L[i * 3 + j] + p) - Pack::load(L[j * 3 + i] + p));
  };
  for_each_tensor(body, [&](const std::array<double*, 6>& tensor) {
    for (Index p = block.begin; p < block.end; p += pack_size) {
      Sym<Pack> a;
      for (int c = 0; c < 6; ++c) a.m[c] = Pack::load(tensor[c] + p);
      rotate_in_space(a, {w(2, 1, p), w(0, 2, p), w(1, 0, p)}, dt);
      for (int c = 0; c < 6; ++c) a.m[c].store(tensor[c] + p);
    }
  });
}

template <int Dim>
const double* average(State<Dim>& state, Body<Dim>& body) {
  if (!body.averager) return nullptr;
  Points<Dim>& points = body.points;
  const double* field = body.averaged_state < 0 ? points.rate_norm[0] : points.state[body.averaged_state];
  {
    const PhaseClock::Lap lap(state.clock, Phase::neighbours);
    body.averager->follow(points.position);
  }
  const PhaseClock::Lap lap(state.clock, Phase::averaging);
  body.averager->average(points.volume[0], field, points.averaged[0]);
  return points.averaged[0];
}

template <int Dim>
[[noreturn]] void report_failure(const State<Dim>& state, const Body<Dim>& body, const MaterialReport& report) {
  const Index p = report.first_failure;
  std::string where;
  for (int a = 0; a < Dim; ++a) where += (a ? ", " : "") + exact_text(body.points.position[a][p]);
  throw RunError("the law failed at " + std::to_string(report.failures) + " point(s) of '" + body.name +
                 "', first at point " + std::to_string(body.points.id[p]) + " at (" + where +
                 ") m: " + std::string(report.reason) + "; step " + std::to_string(state.step) + ", time " +
                 exact_text(state.time) + " s");
}

} // namespace

template <int Dim>
void update_stress(State<Dim>& state, double dt) {
  for (Body<Dim>& body : state.bodies) {
    const double* averaged = average(state, body);
    const PhaseClock::Lap lap(state.clock, Phase::law);
    const StressShare all = reduce_blocks(
        body.points.size(), state.shares, StressShare{},
        [&](Range range) {
          rotate_block(body, range, dt);
          Block<Dim> block(body.points, range, dt);
          block.fill_rate(body.points);
          block.batch.averaged = averaged ? averaged + range.begin : nullptr;
          StressShare share;
          MaterialReport report;
          const double before = block.power(body.points);
          body.material->integrate(block.batch, report);
          share.report.add(report, range.begin);
          share.work = 0.5 * dt * (before + block.power(body.points));
          return share;
        },
        [](StressShare sum, const StressShare& share) {
          sum.report.add(share.report, 0);
          sum.work += share.work;
          return sum;
        });
    if (all.report.failures > 0) report_failure(state, body, all.report);
    state.report.add(all.report, 0);
    state.internal_work += all.work;
  }
}

template <int Dim>
Survey survey(Body<Dim>& body, std::vector<Survey>& parts) {
  return reduce_blocks(
      body.points.size(), parts, Survey{},
      [&](Range range) {
        const Block<Dim> block(body.points, range, 0.0);
        return body.material->survey(block.batch);
      },
      [](Survey all, const Survey& part) {
        all.wave_speed = std::max(all.wave_speed, part.wave_speed);
        all.out_of_bounds += part.out_of_bounds;
        return all;
      });
}

template void update_stress<2>(State<2>&, double);
template void update_stress<3>(State<3>&, double);
template Survey survey<2>(Body<2>&, std::vector<Survey>&);
template Survey survey<3>(Body<3>&, std::vector<Survey>&);

} // namespace riedel
