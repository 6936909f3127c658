/// The scheme that docs/howto/add_a_scheme.md walks through: it is what the page shows, keeps the contract, and runs.
#include "core/step/musl.hpp"
#include "docs/howto/softened.hpp"
#include "support/howto_page.hpp"
#include "support/problems.hpp"

namespace riedel::test {
namespace {

TEST(HowtoAddAScheme, ShowsTheExampleAsItStandsInLessThanSixtyLines) {
  expect_page_to_show("docs/howto/add_a_scheme.md", "docs/howto/softened.hpp");
}

template <int Dim>
void keeps_the_contract() {
  Counts<Dim> cells;
  cells.fill(3);
  const Grid<Dim> grid = grid_of<Dim>(cells, 0.5, 2);
  Points<Dim> points;
  points.resize(40, 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> inside(0.0, 1.5);
  for (int a = 0; a < Dim; ++a)
    for (Index p = 0; p < points.size(); ++p)
      points.position[a][p] = p % 4 == 0 ? std::round(8 * inside(random)) / 8 : inside(random); // on kinks, too
  const Softened<Dim> scheme;
  Stencils<Dim> stencils;
  stencils.resize(points.size(), scheme.max_nodes());
  scheme.evaluate(grid, points, {0, points.size()}, stencils);
  for (Index p = 0; p < points.size(); ++p) {
    double one = 0.0;
    Vec<Dim> x = Vec<Dim>::Zero();
    Mat<Dim> sum_of_gradients = Mat<Dim>::Zero();
    const StencilGroup<Dim>& group = stencils.group_of(p);
    for (int e = 0; e < group.count; ++e) {
      const Vec<Dim> x_i = grid.position(grid.index(group.node_of(e, p % pack_size)));
      Vec<Dim> gradient;
      for (int a = 0; a < Dim; ++a) gradient[a] = group.gradient_of(e, a, p % pack_size);
      one += group.value_of(e, p % pack_size);
      x += group.value_of(e, p % pack_size) * x_i;
      sum_of_gradients += x_i * gradient.transpose();
    }
    EXPECT_NEAR(one, 1.0, 1e-14);
    EXPECT_LT((x - points.position_of(p)).norm(), 1e-14);
    EXPECT_LT((sum_of_gradients - Mat<Dim>::Identity()).norm(), 1e-13);
  }
}

TEST(HowtoAddAScheme, HasAnExampleThatKeepsTheContract) {
  keeps_the_contract<2>();
  keeps_the_contract<3>();
}

TEST(HowtoAddAScheme, HasAnExampleThatCarriesABlockAcrossCells) {
  ShapeFunctions<2> schemes{"scheme"};
  schemes.add({.name = std::string(Softened<2>::name), .summary = "", .source = ""},
              [](const Values&) { return std::make_unique<Softened<2>>(); });
  State<2> state = elastic_state<2>({3, 3}, 0.5, 2, 4, [](const Vec<2>&) { return true; });
  state.bodies[0].points.velocity.fill(0, 10.0);
  Model<2> model = model_with<2>("linear");
  model.scheme = schemes.find("softened").make(Values());
  Simulation<2> simulation(std::move(model), std::move(state));
  while (simulation.state().time < 0.1) simulation.step(); // two cells
  const Points<2>& points = simulation.state().bodies[0].points;
  for (Index p = 0; p < points.size(); ++p) EXPECT_NEAR(points.velocity[0][p], 10.0, 1e-11);
}

} // namespace
} // namespace riedel::test
