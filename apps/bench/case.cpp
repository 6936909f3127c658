#include "apps/bench/case.hpp"

#include "core/case/transfer_keys.hpp"
#include "core/setup/fill.hpp"
#include "core/step/musl.hpp"
#include "core/step/usf.hpp"
#include "core/step/usl.hpp"

namespace riedel {

namespace {

namespace block = bench_block;

template <int Dim>
StepFunction<Dim> step_named(const std::string& order) {
  if (order == "musl") return musl_step<Dim>;
  if (order == "usl") return usl_step<Dim>;
  if (order == "usf") return usf_step<Dim>;
  throw InputError("unknown order '" + order + "'; known: musl, usl, usf");
}

/// Shear, compression and a little rotation, with ‖D‖ = 1.
template <int Dim>
Mat<Dim> direction() {
  Mat<3> L;
  L << 0.3, 0.5, 0.1, 0.2, -0.7, 0.0, 0.0, 0.3, -0.2;
  const Mat<Dim> part = L.template topLeftCorner<Dim, Dim>();
  return part / (0.5 * (part + part.transpose())).norm();
}

template <int Dim>
void set_state_of_start(Body<Dim>& body) {
  Points<Dim>& points = body.points;
  for (int c = 0; c < 6; ++c) points.stress.fill(c, c < 3 ? -block::pressure : 0.0);
  const int e = state_column(body.material->states(), "void_ratio");
  const std::vector<double> start = body.material->initial_state();
  for (int s = 0; s < points.state.components(); ++s)
    points.state.fill(s, s == e ? block::void_ratio : start[static_cast<std::size_t>(s)]);
}

template <int Dim>
void set_averager(Body<Dim>& body, const BenchCase& wanted, const Catalogue& catalogue) {
  if (wanted.length == 0.0) return;
  const std::vector<std::string> offered = body.material->nonlocal_variables();
  if (offered.empty()) throw InputError("--length: " + wanted.material + " averages nothing");
  body.averaged_state = state_column(body.material->states(), offered.front());
  body.averager = catalogue.in<Dim>()
                      .averagers.find(wanted.averager)
                      .make(wanted.length, catalogue.in<Dim>().searches.find(wanted.search).make());
}

} // namespace

const std::vector<std::string>& step_orders() {
  static const std::vector<std::string> all{"musl", "usl", "usf"};
  return all;
}

const std::vector<std::string>& stencil_memory() {
  static const std::vector<std::string> all{"auto", "kept", "blocks"};
  return all;
}

template <int Dim>
Counts<Dim> block_cells(Index points, Index per_cell) {
  double left = static_cast<double>(points) / power(per_cell, Dim); // cells
  Counts<Dim> cells{};
  for (int a = 0; a < Dim; ++a) {
    cells[a] = std::max<Index>(1, static_cast<Index>(std::lround(std::pow(left, 1.0 / (Dim - a)))));
    left /= cells[a];
  }
  return cells;
}

template <int Dim>
std::shared_ptr<const VelocityTransfer<Dim>> transfer_of(const BenchCase& wanted, const Catalogue& catalogue) {
  const auto& transfer = catalogue.in<Dim>().transfers.find(wanted.transfer);
  Values options(transfer.description.parameters);
  if (options.has("flip")) options.set("flip", block::flip);
  return transfer.make(options);
}

template <int Dim>
Simulation<Dim> make_block(const BenchCase& wanted, const Catalogue& catalogue) {
  Model<Dim> model;
  const auto& scheme = catalogue.in<Dim>().schemes.find(wanted.scheme);
  model.scheme = scheme.make(Values(scheme.description.parameters));
  model.step = step_named<Dim>(wanted.order);
  model.confining_pressure = block::pressure;
  model.transfer = transfer_of<Dim>(wanted, catalogue);
  if (wanted.filter > 0) {
    model.stress_filter.stress_rate = block::filter_rate;
    model.stress_filter.volume_rate = 0.1 * block::filter_rate;
    model.stress_filter.steps_between = wanted.filter;
  }
  if (wanted.stencils != "auto") model.keep_stencils = wanted.stencils == "kept";

  const auto& law = catalogue.materials.find(wanted.material);
  const Counts<Dim> cells = block_cells<Dim>(wanted.points, wanted.per_cell);
  const Index margin = model.scheme->margin() + 2;
  State<Dim> state;
  state.grid.cell.setConstant(block::cell);
  state.grid.origin.setConstant(-margin * block::cell);
  for (int a = 0; a < Dim; ++a) state.grid.nodes[a] = cells[a] + 2 * margin + 1;

  Body<Dim>& body = state.bodies.emplace_back();
  body.name = "block";
  body.material = law.make(Values(law.description.parameters));
  // Off the nodes by a tenth of a cell: points reach all nodes of their supports, and no node has a very small mass.
  fill<Dim>(body.points,
            lattice_of<Dim>(cells, state.grid.cell, wanted.per_cell, Vec<Dim>::Constant(0.1 * block::cell)),
            state_components(body.material->states()));
  set_state_of_start(body);
  std::vector<double> first(static_cast<std::size_t>(body.points.state.components()));
  for (int s = 0; s < body.points.state.components(); ++s) first[static_cast<std::size_t>(s)] = body.points.state[s][0];
  const double density = body.material->density(first);
  for (Index p = 0; p < body.points.size(); ++p) body.points.mass[0][p] = density * body.points.volume[0][p];
  set_averager(body, wanted, catalogue);

  Simulation<Dim> simulation(std::move(model), std::move(state));
  set_in_motion(simulation);
  return simulation;
}

template <int Dim>
void set_in_motion(Simulation<Dim>& simulation) {
  Body<Dim>& body = simulation.state().bodies.front();
  set_state_of_start(body);
  Points<Dim>& points = body.points;
  Vec<Dim> centre = Vec<Dim>::Zero();
  for (Index p = 0; p < points.size(); ++p) centre += points.position_of(p) / points.size();
  const Mat<Dim> L = block::strain_per_step / simulation.time_step() * direction<Dim>();
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> v = L * (points.position_of(p) - centre);
    for (int a = 0; a < Dim; ++a) points.velocity[a][p] = v[a];
  }
  for (int c = 0; c < points.transfer_data.components(); ++c) points.transfer_data.fill(c, 0.0);
}

template Counts<2> block_cells<2>(Index, Index);
template Counts<3> block_cells<3>(Index, Index);
template Simulation<2> make_block<2>(const BenchCase&, const Catalogue&);
template Simulation<3> make_block<3>(const BenchCase&, const Catalogue&);
template void set_in_motion<2>(Simulation<2>&);
template void set_in_motion<3>(Simulation<3>&);

} // namespace riedel
