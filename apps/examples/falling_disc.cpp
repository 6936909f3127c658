/// A rubber disc falls on a bed of softer rubber and rebounds: two bodies in contact through the grid.
///   falling_disc [FOLDER]        one second; leaves points.pvd for ParaView and history.csv
#include <riedel/riedel.hpp>

using namespace riedel;

int main(int argc, char** argv) try {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "falling_disc";
  const Catalogue catalogue = built_in();

  // 1. A scheme, and a grid of cells of 5 cm over 2 m by 2 m, with room around it for the scheme's supports.
  Model<2> model;
  model.scheme = make(catalogue.in_2d.schemes, "gimp");
  State<2> state;
  state.grid = grid_around<2>({0.0, 0.0}, {2.0, 2.0}, 0.05, model.scheme->margin() + 2);

  // 2. Bodies: a law, a shape, two by two points in a cell.
  const auto rubber = [&](double stiffness) {
    return make(catalogue.materials, "linear_elastic", {{"youngs_modulus", stiffness}, {"density", 1000.0}});
  };
  state.bodies.push_back(make_body<2>("bed", rubber(2e5), state.grid, 2, [](const Vec<2>& x) {
    return x[0] > 0.0 && x[0] < 2.0 && x[1] > 0.0 && x[1] < 0.5;
  }));
  state.bodies.push_back(make_body<2>("disc", rubber(1e6), state.grid, 2,
                                      [](const Vec<2>& x) { return (x - Vec<2>(1.0, 1.2)).norm() < 0.3; }));

  // 3. Walls, weight, and the order of the step.
  model.conditions = rough_wall(state.grid, "floor", 1, 0.0, Behind::lower);
  model.conditions.push_back(smooth_wall(state.grid, "left", 0, 0.0, Behind::lower));
  model.conditions.push_back(smooth_wall(state.grid, "right", 0, 2.0, Behind::upper));
  model.gravity = {0.0, -9.81};
  model.step = musl_step<2>;
  model.transfer = make(catalogue.in_2d.transfers, "flip", {{"flip", 1.0}});

  // 4. The run, with a frame and a row of history every 20 ms.
  Simulation<2> simulation(std::move(model), std::move(state));
  const StartPlaces<2> start = places_of(simulation);
  SeriesWriter frames(folder);
  History history(folder / "history.csv", {"time_s", "disc_m", "kinetic_J_per_m", "floor_N_per_m"});
  Run<2> run(simulation);
  run.every(0.02, [&] {
    const Points<2>& disc = simulation.state().bodies[1].points;
    double height = 0.0;
    for (Index p = 0; p < disc.size(); ++p) height += disc.position[1][p] / disc.size();
    history.add(std::array{simulation.state().time, height, simulation.energies().kinetic,
                           simulation.boundary_report("floor_y").reaction});
    frames.write(snapshot(simulation, start));
  });
  run.until(1.0).go();
} catch (const std::exception& error) { return std::fprintf(stderr, "falling_disc: %s\n", error.what()), 1; }
