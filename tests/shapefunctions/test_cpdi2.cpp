/// Domains with independent corners: what they share with parallelograms, and what only they can do; and the limit on
/// long domains.
#include "core/step/grid_to_points.hpp"
#include "core/step/locate.hpp"
#include "shapefunctions/one_stencil.hpp"

#include <gtest/gtest.h>

namespace riedel::test {
namespace {

template <int Dim>
Mat<Dim> some_deformation() {
  Mat<3> F;
  F << 1.1, 0.3, -0.1, 0.1, 0.8, 0.2, 0.2, -0.1, 0.9;
  return F.topLeftCorner<Dim, Dim>();
}

template <int Dim>
void equals_cpdi_for_a_parallelogram() {
  const Vec<Dim> x = Vec<3>(1.3, 2.6, 0.8).head<Dim>();
  const Mat<Dim> F = some_deformation<Dim>();
  EXPECT_LT(difference<Dim>(weights<Dim>("cpdi2", x, 0.4, F), weights<Dim>("cpdi", x, 0.4, F)), 1e-14);
}

TEST(Cpdi2, EqualsCpdiForAParallelogram) {
  equals_cpdi_for_a_parallelogram<2>();
  equals_cpdi_for_a_parallelogram<3>();
}

/// One point with its corners at `corner(c)`.
template <int Dim>
struct FreeDomain {
  Points<Dim> points;
  Stencils<Dim> stencils;
  std::shared_ptr<const ShapeFunction<Dim>> shape;

  template <class CornerAt>
  FreeDomain(const CornerAt& corner, double limit = 0.0) : shape(scheme<Dim>("cpdi2", {{"domain_limit", limit}})) {
    points.resize(1, 0);
    initialise(*shape, four_cells<Dim>(), points);
    for (int c = 0; c < power(2, Dim); ++c)
      for (int a = 0; a < Dim; ++a) points.scheme_data[c * Dim + a][0] = corner(c)[a];
    stencils.resize(1, shape->max_nodes());
    shape->evaluate(four_cells<Dim>(), points, {0, 1}, stencils);
  }

  /// Σ N, Σ N x_i and Σ x_i ⊗ ∇N.
  [[nodiscard]] std::tuple<double, Vec<Dim>, Mat<Dim>> sums() const {
    std::tuple<double, Vec<Dim>, Mat<Dim>> all{0.0, Vec<Dim>::Zero(), Mat<Dim>::Zero()};
    const StencilGroup<Dim>& group = stencils.group_of(0);
    const Grid<Dim> grid = four_cells<Dim>();
    for (int e = 0; e < group.count; ++e) {
      const Vec<Dim> x = grid.position(grid.index(group.node_of(e, 0)));
      Vec<Dim> gradient;
      for (int a = 0; a < Dim; ++a) gradient[a] = group.gradient_of(e, a, 0);
      std::get<0>(all) += group.value_of(e, 0);
      std::get<1>(all) += group.value_of(e, 0) * x;
      std::get<2>(all) += x * gradient.transpose();
    }
    return all;
  }
};

/// A corner of a cube of unit edges around (2, 2, 2), moved a little at random.
template <int Dim>
auto crooked_corner() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.2, 0.2);
  std::array<Vec<Dim>, power(2, Dim)> places;
  for (int c = 0; c < power(2, Dim); ++c)
    for (int a = 0; a < Dim; ++a) places[c][a] = 2.0 + ((c >> a) & 1 ? 0.5 : -0.5) + unit(random);
  return [places](int c) { return places[c]; };
}

template <int Dim>
void crooked_domains_conserve_and_take_exact_gradients(double limit) {
  const auto [one, centroid, gradient] = FreeDomain<Dim>(crooked_corner<Dim>(), limit).sums();
  EXPECT_NEAR(one, 1.0, 1e-14);
  EXPECT_LT((gradient - Mat<Dim>::Identity()).norm(), 1e-13);
}

TEST(Cpdi2, ConservesAndTakesExactGradientsWithCrookedDomainsToo) {
  for (const double limit : {0.0, 0.6}) {
    crooked_domains_conserve_and_take_exact_gradients<2>(limit);
    crooked_domains_conserve_and_take_exact_gradients<3>(limit);
  }
}

/// A trapezium with parallel sides 2 and 1 at a distance of 1: its centroid lies 4/9 above the longer one.
TEST(Cpdi2, WeighsTheCornersOfATrapeziumAsTheMeanOverIt) {
  const std::array<Vec<2>, 4> places{Vec<2>(1, 1), Vec<2>(3, 1), Vec<2>(1.5, 2), Vec<2>(2.5, 2)};
  const FreeDomain<2> domain([&](int c) { return places[c]; });
  EXPECT_LT((std::get<1>(domain.sums()) - Vec<2>(2.0, 1.0 + 4.0 / 9.0)).norm(), 1e-14);
}

TEST(Cpdi2, MarksADomainThatIsTurnedInsideOut) {
  const std::array<Vec<2>, 4> places{Vec<2>(3, 1), Vec<2>(1, 1), Vec<2>(2.5, 2), Vec<2>(1.5, 2)};
  EXPECT_TRUE(FreeDomain<2>([&](int c) { return places[c]; }).stencils.group_of(0).lost[0]);
}

/// A block whose nodes move with v = A x + q(x), otherwise at rest.
template <int Dim>
State<Dim> moved(const std::string& name, double quadratic, double limit = 0.0) {
  Counts<Dim> cells;
  cells.fill(4);
  State<Dim> state = elastic_state<Dim>(cells, 0.5, 2, 5, [](const Vec<Dim>&) { return true; });
  Model<Dim> model = model_with<Dim>(name);
  model.scheme = scheme<Dim>(name, {{"domain_limit", limit}});
  prepare_points(state, model);
  const Mat<Dim> A = some_deformation<Dim>() - Mat<Dim>::Identity();
  for (int step = 0; step < 5; ++step) {
    locate_points(state, model);
    for (Index i = 0; i < state.grid.node_count(); ++i) {
      const Vec<Dim> x = state.grid.position(state.grid.index(i));
      state.nodes.motion[i].velocity = A * x + quadratic * x[0] * x[1] * Vec<Dim>::Ones();
    }
    update_kinematics(state, model, 0.1);
    move_scheme_columns(state, model, 0.1);
    if (name != "cpdi2") // which moves its points itself
      for (Index p = 0; p < state.bodies[0].points.size(); ++p) {
        Points<Dim>& points = state.bodies[0].points;
        const Vec<Dim> x = points.position_of(p), v = A * x + quadratic * x[0] * x[1] * Vec<Dim>::Ones();
        for (int a = 0; a < Dim; ++a) points.position[a][p] += 0.1 * v[a];
      }
  }
  return state;
}

template <int Dim>
void stays_cpdi_in_homogeneous_motion(double limit) {
  const State<Dim> a = moved<Dim>("cpdi2", 0.0, limit), b = moved<Dim>("cpdi", 0.0, limit);
  const auto first = scheme<Dim>("cpdi2"), second = scheme<Dim>("cpdi");
  for (Index id = 0; id < a.bodies[0].points.size(); ++id) {
    const Index p = a.bodies[0].points.place[id], q = b.bodies[0].points.place[id];
    EXPECT_LT((a.bodies[0].points.position_of(p) - b.bodies[0].points.position_of(q)).norm(), 1e-13);
    const Corners<Dim> x = first->corners(a.grid, a.bodies[0].points, p),
                       y = second->corners(b.grid, b.bodies[0].points, q);
    for (int c = 0; c < power(2, Dim); ++c) EXPECT_LT((x[c] - y[c]).norm(), 1e-13);
  }
}

TEST(Cpdi2, StaysCpdiInHomogeneousMotion) {
  for (const double limit : {0.0, 0.3}) { // domains have half diagonals of 0.35 cells and 0.43 in space
    stays_cpdi_in_homogeneous_motion<2>(limit);
    stays_cpdi_in_homogeneous_motion<3>(limit);
  }
}

/// The largest distance between corners that coincide at the start.
double gap(const std::string& name) {
  const State<2> state = moved<2>(name, 0.5);
  const Points<2>& points = state.bodies[0].points;
  const auto shape = scheme<2>(name);
  double widest = 0.0;
  for (Index id = 0; id + 9 < points.size(); ++id) {
    if (id % 8 == 7) continue; // eight points in a row
    const Corners<2> x = shape->corners(state.grid, points, points.place[id]);
    widest = std::max(widest, (x[3] - shape->corners(state.grid, points, points.place[id + 9])[0]).norm());
    widest = std::max(widest, (x[1] - shape->corners(state.grid, points, points.place[id + 1])[0]).norm());
  }
  return widest;
}

TEST(Cpdi2, KeepsNeighboursJoinedWhereCpdiLeavesGaps) {
  EXPECT_LT(gap("cpdi2"), 1e-13);
  EXPECT_GT(gap("cpdi"), 0.01);
}

double max_reach(const std::string& name, double limit) {
  const Mat<2> F = Vec<2>(3.0, 0.5).asDiagonal();
  Points<2> points;
  points.resize(1, 0);
  for (int a = 0; a < 2; ++a) {
    points.position[a][0] = 2.0;
    points.half_size[a][0] = 0.5;
    points.deformation_gradient[a * 2 + a][0] = F(a, a);
  }
  const auto shape = scheme<2>(name, {{"domain_limit", limit}});
  Stencils<2> stencils;
  stencils.resize(1, shape->max_nodes());
  Columns node_data{0};
  const Grid<2> grid = four_cells<2>();
  evaluate_anew(*shape, grid, points, node_data, stencils);
  double reach = 0.0;
  Vec<2> gradients = Vec<2>::Zero();
  const StencilGroup<2>& group = stencils.group_of(0);
  for (int e = 0; e < group.count; ++e) {
    if (group.value_of(e, 0) > 1e-12)
      reach = std::max(reach, std::abs(grid.position(grid.index(group.node_of(e, 0)))[0] - 2.0));
    gradients[0] += group.gradient_of(e, 0, 0) * grid.position(grid.index(group.node_of(e, 0)))[0];
  }
  EXPECT_NEAR(gradients[0], 1.0, 1e-13);
  return reach;
}

TEST(DomainLimit, ShortensWhatIsTooLongAndNothingElse) {
  for (const std::string name : {"cpdi", "cpdi2"}) {
    EXPECT_EQ(max_reach(name, 0.0), 2.0) << name; // corners 1.5 away
    EXPECT_EQ(max_reach(name, 1.6), 2.0) << name;
    EXPECT_EQ(max_reach(name, 0.9), 1.0) << name;
  }
  const Mat<2> F = some_deformation<2>();
  EXPECT_LT(difference<2>(weights<2>("cpdi", {1.3, 2.6}, 0.4, F, four_cells<2>(), {{"domain_limit", 2.0}}),
                          weights<2>("cpdi", {1.3, 2.6}, 0.4, F)),
            1e-14);
}

} // namespace
} // namespace riedel::test
