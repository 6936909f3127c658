/// A column of dry sand, 20 cm by 40 cm, is released and spreads over a rough floor.
///   column_collapse [FOLDER]     leaves points.pvd for ParaView and history.csv with the front
#include <riedel/riedel.hpp>

using namespace riedel;

int main(int argc, char** argv) try {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "column_collapse";
  const Catalogue catalogue = built_in();

  // 1. A scheme, and a grid of cells of 2 cm over the half space to the right of the line of symmetry.
  Model<2> model;
  model.scheme = make(catalogue.in_2d.schemes, "gimp");
  State<2> state;
  state.grid = grid_around<2>({0.0, 0.0}, {1.0, 0.5}, 0.02, model.scheme->margin() + 2);

  // 2. The sand, under the stress of its weight at rest.
  const double density = 1500.0, gravity = 9.81, height = 0.4;
  const std::shared_ptr<const Material> sand = make(catalogue.materials, "mohr_coulomb",
                                                    {{"youngs_modulus", 1e6},
                                                     {"poissons_ratio", 0.3},
                                                     {"density", density},
                                                     {"friction_angle", 30.0},
                                                     {"dilatancy_angle", 0.0},
                                                     {"cohesion", 0.0}});
  state.bodies.push_back(make_body<2>("sand", sand, state.grid, 2, [&](const Vec<2>& x) {
    return x[0] > 0.0 && x[0] < 0.2 && x[1] > 0.0 && x[1] < height;
  }));
  Points<2>& points = state.bodies.front().points;
  for (Index p = 0; p < points.size(); ++p) {
    const double vertical = -density * gravity * (height - points.position[1][p]);
    points.stress[1][p] = vertical;
    points.stress[0][p] = points.stress[2][p] = 0.5 * vertical;
  }

  // 3. A rough floor, a smooth line of symmetry, weight.
  model.conditions = rough_wall(state.grid, "floor", 1, 0.0, Behind::lower);
  model.conditions.push_back(smooth_wall(state.grid, "symmetry", 0, 0.0, Behind::lower));
  model.gravity = {0.0, -gravity};
  model.step = musl_step<2>;
  // [1/s], of what the grid does not resolve
  model.transfer = make(catalogue.in_2d.transfers, "flip", {{"damping", 10.0}});

  // 4. The run, with a frame and a row every 20 ms.
  Simulation<2> simulation(std::move(model), std::move(state));
  const StartPlaces<2> start = places_of(simulation);
  SeriesWriter frames(folder);
  History history(folder / "history.csv", {"time_s", "front_m", "height_m", "kinetic_J_per_m"});
  Run<2> run(simulation);
  run.every(0.02, [&] {
    const Columns& x = simulation.state().bodies.front().points.position;
    history.add(std::array{simulation.state().time, *std::max_element(x[0], x[0] + x.size()),
                           *std::max_element(x[1], x[1] + x.size()), simulation.energies().kinetic});
    frames.write(snapshot(simulation, start));
  });
  run.until(0.8).go();
} catch (const std::exception& error) { return std::fprintf(stderr, "column_collapse: %s\n", error.what()), 1; }
