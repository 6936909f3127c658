/// A user-defined law inside a program: elastic, and stiffer under pressure. A block of it settles under its weight.
///   own_law [FOLDER]             leaves points.pvd for ParaView and history.csv with the height
#include <riedel/riedel.hpp>

using namespace riedel;

/// σ° = (1 + p/p0) (λ tr(D) I + 2 μ D)
class Stiffening final : public RateLaw<Stiffening, 0> { // no state variables
public:
  static constexpr bool frictional = false;
  explicit Stiffening(const Values& given) : RateLaw(IntegrationControl(given)), solid_(given) {}

  template <class Real> // a double, or a pack of eight
  Rate<Real, 0> rate(const Sym<Real>& sigma, const std::array<Real, 0>&, const Sym<Real>& D, Real) const {
    const Real p = Real(-1.0 / 3.0) * trace(sigma);
    return {.stress = (Real(1.0) + max(p, Real(0.0)) / Real(p0)) * solid_.stress(D), .state = {}};
  }
  std::span<const StateVariable> states() const override { return {}; }
  double density(std::span<const double>) const override { return solid_.density; }
  MaterialLimits assess(const MaterialBatch&) const override { // the fastest wave, from which the time step follows
    return {.wave_speed = std::sqrt(10.0 * solid_.longitudinal() / solid_.density)};
  }

private:
  static constexpr double p0 = 1e3; // [Pa]
  ElasticSolid solid_;
};

int main(int argc, char** argv) try {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "own_law";
  Model<2> model;
  model.scheme = make(built_in().in_2d.schemes, "gimp");
  State<2> state;
  state.grid = grid_around<2>({0.0, 0.0}, {0.4, 1.2}, 0.05, model.scheme->margin() + 2);
  Values values(Keys{{"tolerance", 1e-4}, {"youngs_modulus", 2e5}, {"poissons_ratio", 0.3}, {"density", 1000.0}});
  state.bodies.push_back(make_body<2>("block", std::make_shared<Stiffening>(values), state.grid, 2,
                                      [](const Vec<2>& x) { return x[0] > 0 && x[0] < 0.4 && x[1] > 0 && x[1] < 1; }));
  model.conditions.push_back(smooth_wall(state.grid, "floor", 1, 0.0, Behind::lower));
  model.conditions.push_back(smooth_wall(state.grid, "left", 0, 0.0, Behind::lower));
  model.conditions.push_back(smooth_wall(state.grid, "right", 0, 0.4, Behind::upper));
  model.gravity = {0.0, -9.81};
  model.step = musl_step<2>;
  model.body_forces.push_back({.per_mass = [](const Points<2>& points, Index p, double) -> Vec<2> {
    return -30.0 * points.velocity_of(p); // drag [N/kg], so that it comes to rest
  }});

  Simulation<2> simulation(std::move(model), std::move(state));
  const StartPlaces<2> start = places_of(simulation);
  SeriesWriter frames(folder);
  History history(folder / "history.csv", {"time_s", "height_m"});
  Run<2> run(simulation);
  run.every(0.02, [&] {
    const Columns& x = simulation.state().bodies.front().points.position;
    history.add(std::array{simulation.state().time, *std::max_element(x[1], x[1] + x.size())});
    frames.write(snapshot(simulation, start));
  });
  run.until(1.0).go();
} catch (const std::exception& error) { return std::fprintf(stderr, "own_law: %s\n", error.what()), 1; }
