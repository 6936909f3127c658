/// A block in free flight, and the messages of a build without VTK and CGAL.
#include <riedel/riedel.hpp>

#include <iostream>

namespace {

using namespace riedel;

template <class Ask>
bool tells(const std::string& option, const Ask& ask) {
  try {
    ask();
  } catch (const InputError& error) {
    if (std::string(error.what()).find("-D" + option + "=ON") != std::string::npos) return true;
    std::cerr << error.what() << "\n";
  }
  std::cerr << "nothing tells of " << option << "\n";
  return false;
}

bool flies() {
  const Catalogue catalogue = built_in();
  State<2> state;
  state.grid.cell.setConstant(0.1);
  state.grid.origin.setConstant(0.0);
  state.grid.nodes = {17, 17};
  Body<2>& body = state.bodies.emplace_back();
  body.name = "block";
  body.material = make(catalogue.materials, "linear_elastic");
  body.points.resize(64, 0);
  for (Index p = 0; p < 64; ++p) {
    body.points.position[0][p] = 0.525 + 0.05 * (p % 8);
    body.points.position[1][p] = 0.525 + 0.05 * (p / 8);
    for (int a = 0; a < 2; ++a) body.points.half_size[a][p] = 0.025;
    body.points.volume[0][p] = body.points.initial_volume[0][p] = 0.0025;
    body.points.mass[0][p] = 5.0;
    body.points.velocity[0][p] = 1.0;
  }
  Model<2> model;
  model.scheme = make(catalogue.in_2d.schemes, "gimp");
  model.step = musl_step<2>;
  Simulation<2> simulation(std::move(model), std::move(state));
  for (int i = 0; i < 10; ++i) simulation.step();
  const double v = simulation.state().bodies.front().points.velocity[0][0];
  if (std::abs(v - 1.0) < 1e-12) return true;
  std::cerr << "a block in free flight has changed its velocity to " << v << " m/s\n";
  return false;
}

} // namespace

int main() {
  const Catalogue catalogue = built_in();
  const auto search = [&] { (void)catalogue.in_2d.searches.find("cgal_kd_tree"); };
  const auto series = [] { SeriesWriter writer("series"); };
  const bool told = tells("RIEDEL_WITH_CGAL", search) && tells("RIEDEL_WITH_VTK", series);
  (void)catalogue.in_3d.searches.find("cell_list").make();
  return told && flies() ? 0 : 1;
}
