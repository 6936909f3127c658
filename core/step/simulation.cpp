#include "core/step/simulation.hpp"

#include "core/step/boundary.hpp"
#include "core/step/grid_to_points.hpp"
#include "core/step/law_failure.hpp"
#include "core/step/loads.hpp"
#include "core/step/locate.hpp"
#include "core/step/orders.hpp"
#include "core/step/stress_update.hpp"

#include <tuple>

namespace riedel {

namespace {
constexpr std::int64_t steps_between_assessments = 10; // in that time the wave speed changes by less than 1 %

/// max ‖v_p‖².
double max_square(const Columns& v) {
  std::array<double, block_size> squared;
  double maximum = 0.0;
  for (Index b = 0; b < v.size(); b += block_size) {
    const Index count = std::min(block_size, v.size() - b);
    squared.fill(0.0);
    for (int a = 0; a < v.components(); ++a)
      for (Index i = 0; i < count; ++i) squared[i] += square(v[a][b + i]);
    maximum = std::max(maximum, *std::max_element(squared.begin(), squared.begin() + count));
  }
  return maximum;
}

template <int Dim>
void check_state_columns(const State<Dim>& state) {
  for (const Body<Dim>& body : state.bodies) {
    const int declared = state_components(body.material->states()), given = body.points.state.components();
    if (given != declared || declared > max_state_columns)
      throw InputError("body '" + body.name + "': its law declares " + std::to_string(declared) +
                       " state columns, its points have " + std::to_string(given) + "; they must agree, " +
                       std::to_string(max_state_columns) + " at most");
  }
}

template <int Dim>
void check_model(const Model<Dim>& model, const Grid<Dim>& grid) {
  if (model.scheme == nullptr) throw InputError("the model has no interpolation scheme");
  if (model.step == nullptr) throw InputError("the model has no step; take musl_step, usl_step or usf_step");
  for (int a = 0; a < Dim; ++a)
    if (!(grid.cell[a] > 0.0) || grid.nodes[a] < 2)
      throw InputError("the grid has " + std::to_string(grid.nodes[a]) + " nodes along axis " + std::to_string(a) +
                       ", " + exact_text(grid.cell[a]) + " m apart; allowed: 2 nodes and more, more than 0 m apart");
}

template <int Dim>
void check_moving_grids(const Model<Dim>& model) {
  for (const MovingGrid& moving : model.moving_grids)
    if (std::ranges::none_of(model.conditions, [&](const auto& c) { return c->name() == moving.platen; }))
      throw InputError("the grid is to follow '" + moving.platen + "', but no boundary condition has that name");
}

/// Checks the requirements of the transfer on the scheme and on the order of the step.
template <int Dim>
void check_transfer(const Model<Dim>& model) {
  if (model.transfer == nullptr)
    throw InputError("the model has no transfer of velocities; keep the default, or take one from the catalogue");
  const TransferTraits traits = model.transfer->traits();
  if (traits.spread == TransferTraits::Spread::needed && !model.scheme->supports_affine())
    throw InputError(
        "the scheme does not go with the transfer: it gives a point on a line of nodes no weight beside that line");
  for (const StepOrder<Dim>& order : orders_of_step<Dim>)
    if (model.step == order.step && !traits.goes_with(order.name)) {
      std::string allowed;
      for (const StepOrder<Dim>& other : orders_of_step<Dim>)
        if (traits.goes_with(other.name)) allowed += (allowed.empty() ? "" : ", ") + std::string(other.name);
      throw InputError("the transfer does not go with the order " + std::string(order.name) +
                       " of the step; allowed: " + allowed);
    }
}

/// Checks mass, volume and extent of points, by which the step divides.
template <int Dim>
void check_points(const State<Dim>& state) {
  if (state.bodies.empty()) throw InputError("a simulation needs a body");
  for (const Body<Dim>& body : state.bodies) {
    const Points<Dim>& points = body.points;
    if (body.material == nullptr) throw InputError("body '" + body.name + "' has no material");
    if (points.size() == 0) throw InputError("body '" + body.name + "' has no points");
    for (const auto& [name, unit, column] : {std::tuple{"mass", Dim == 2 ? "kg/m" : "kg", &points.mass},
                                             {"volume", Dim == 2 ? "m2" : "m3", &points.volume},
                                             {"initial volume", Dim == 2 ? "m2" : "m3", &points.initial_volume},
                                             {"half size", "m", &points.half_size}})
      for (int a = 0; a < column->components(); ++a)
        for (Index p = 0; p < points.size(); ++p)
          if (const double x = (*column)[a][p]; !(x > 0.0) || !std::isfinite(x))
            throw InputError("body '" + body.name + "', point " +
                             std::to_string(points.id[static_cast<std::size_t>(p)]) + ": its " + name + " is " +
                             exact_text(x) + " " + unit + "; allowed: more than 0");
  }
}

/// Volumes that decay nearly as fast as stresses add energy.
void check_filter(const StressFilter& filter, bool gradients_follow_weights) {
  if (!filter.on()) return;
  if (!gradients_follow_weights)
    throw InputError("the stress filter does not go with a scheme whose gradients are not those of its weights");
  if (filter.order < 1 || filter.steps_between < 1)
    throw InputError("the stress filter has the order " + std::to_string(filter.order) + " and works in every " +
                     std::to_string(filter.steps_between) + " steps; allowed: 1 and more for both");
  if (filter.volume_rate > 0.1 * (1.0 + 1e-12) * filter.stress_rate)
    throw InputError("the filter's rate for volumes, " + short_text(filter.volume_rate) +
                     " 1/s, is over a tenth of that for stresses, " + short_text(filter.stress_rate) + " 1/s");
}
} // namespace

template <int Dim>
Simulation<Dim>::Simulation(Model<Dim> model, State<Dim> state) : model_(std::move(model)), state_(std::move(state)) {
  check_model(model_, state_.grid);
  check_points(state_);
  check_state_columns(state_);
  check_transfer(model_);
  prepare_points(state_, model_);
  bind_boundaries(state_, model_);
  check_moving_grids(model_);
  locate_points(state_, model_);
  check_inside(state_, model_);
  assess_bodies();
  check_filter(model_.stress_filter, model_.scheme->gradients_follow_weights());
  potential_at_start_ = potential_of_loads();
  kinetic_at_start_ = kinetic_energy();
}

template <int Dim>
void Simulation<Dim>::step() {
  if (state_.step % steps_between_assessments == 0) assess_bodies();
  const double dt = time_step_;
  locate_points(state_, model_);
  follow_boundaries(state_, model_);
  model_.step(state_, model_, dt);
  state_.node_work += 0.5 * dt * (state_.node_power.start + state_.node_power.end);
  move_scheme_columns(state_, model_, dt);
  state_.load_work += surface_work(state_, model_, dt) + body_work(state_, model_, dt);
  move_boundaries(model_, state_.time + dt, dt);
  follow_platens(dt);
  state_.time += dt;
  ++state_.step;
}

template <int Dim>
void Simulation<Dim>::assess_bodies() {
  double wave = 0.0, fastest_squared = 0.0;
  std::int64_t outside = 0;
  for (Body<Dim>& body : state_.bodies) {
    const MaterialLimits found = watched(state_, body, [&] { return assess(body, limits_, state_.time, state_.step); });
    wave = std::max(wave, found.wave_speed);
    outside += found.out_of_bounds;
    fastest_squared = std::max(fastest_squared, max_square(body.points.velocity));
  }
  out_of_bounds_ = std::max(out_of_bounds_, outside);
  crossing_time_ = state_.grid.cell.minCoeff() / (wave + std::sqrt(fastest_squared));
  time_step_ = model_.fixed_time_step > 0.0 ? model_.fixed_time_step : model_.cfl * crossing_time_;
  if (!std::isfinite(time_step_))
    throw RunError("the law gives no wave speed, from which the time step is computed (step " +
                   std::to_string(state_.step) + "); allowed: a stiffness that is finite and not zero, or time.step");
}

template <int Dim>
void Simulation<Dim>::follow_platens(double dt) {
  Grid<Dim>& grid = state_.grid;
  for (const MovingGrid& moving : model_.moving_grids) {
    const int a = moving.axis;
    const double fixed = grid.origin[a] + moving.fixed_row * grid.cell[a];
    const Index rows = moving.moving_row - moving.fixed_row;
    const double before = grid.cell[a];
    grid.cell[a] += boundary_report(moving.platen).speed * dt / rows;
    grid.stretch[a] *= grid.cell[a] / before;
    grid.origin[a] = fixed - moving.fixed_row * grid.cell[a];
    if (!(grid.cell[a] > 0.0))
      throw RunError("the platen has closed the grid at time " + exact_text(state_.time) + " s");
  }
}

template <int Dim>
double Simulation<Dim>::potential_of_loads() const {
  double sum = 0.0;
  for (const Body<Dim>& body : state_.bodies)
    for (Index p = 0; p < body.points.size(); ++p)
      sum += body.points.mass[0][p] * model_.gravity.dot(body.points.position_of(p)) -
             model_.confining_pressure * body.points.volume[0][p];
  return sum;
}

template <int Dim>
Energies Simulation<Dim>::energies() const {
  Energies now{.kinetic = kinetic_energy(),
               .internal = state_.internal_work,
               .external = state_.boundary_work + state_.load_work + potential_of_loads() - potential_at_start_,
               .dissipated = state_.boundary_loss,
               .filter = state_.filter_work};
  const double gain = now.kinetic - kinetic_at_start_;
  now.transfer = state_.node_work - gain;
  now.unaccounted = now.external + now.filter - now.internal - now.transfer - gain;
  return now;
}

template <int Dim>
double Simulation<Dim>::kinetic_energy() const {
  double sum = 0.0;
  for (const Body<Dim>& body : state_.bodies)
    for (Index p = 0; p < body.points.size(); ++p)
      sum += 0.5 * body.points.mass[0][p] * body.points.velocity_of(p).squaredNorm();
  return sum;
}

template <int Dim>
const BoundaryCondition<Dim>& Simulation<Dim>::boundary(std::string_view name) const {
  for (const Boundary<Dim>& condition : model_.conditions)
    if (condition->name() == name) return *condition;
  throw std::out_of_range("no boundary condition is called '" + std::string(name) + "'");
}

template class Simulation<2>;
template class Simulation<3>;

} // namespace riedel
