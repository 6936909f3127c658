/// The transfers of velocities against their formulas, from the scheme's weights.
#include "verification/transfers.hpp"

#include <Eigen/Dense>

namespace riedel::test {
namespace {

class TransferFormulaTest : public TransferTest {};

/// Weights of all points on all nodes, S of v_p = Σ_i S_pi v_i.
template <int Dim>
Eigen::MatrixXd weights(const State<Dim>& state, const ShapeFunction<Dim>& scheme) {
  const Points<Dim>& points = state.bodies[0].points;
  Stencils<Dim> stencils;
  stencils.resize(points.size(), scheme.max_nodes());
  scheme.evaluate(state.grid, points, {0, points.size()}, stencils);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(points.size(), state.grid.node_count());
  for (Index p = 0; p < points.size(); ++p) {
    const StencilGroup<Dim>& group = stencils.group_of(p);
    for (int e = 0; e < group.count; ++e) S(p, group.node_of(e, p % pack_size)) += group.value_of(e, p % pack_size);
  }
  return S;
}

template <int Dim>
Eigen::MatrixXd velocities(const State<Dim>& state) {
  const Points<Dim>& points = state.bodies[0].points;
  Eigen::MatrixXd V(points.size(), Dim);
  for (Index p = 0; p < points.size(); ++p) V.row(p) = points.velocity_of(p).transpose();
  return V;
}

/// Steps without forces: the stress is zero, and remains negligible in this time.
template <int Dim>
Model<Dim> without_forces(Model<Dim> model) {
  model.fixed_time_step = 1e-9;
  return model;
}

template <int Dim>
void expect_the_papers_filter(const std::string& scheme_name, int m) {
  for (const StepOrder<Dim>& order : orders_of_step<Dim>) {
    const Transfer chosen{"xpic", "xpic", {{"xpic_order", m}}};
    Simulation<Dim> simulation(without_forces(model_with<Dim>(scheme_name, chosen, order.step)),
                               shaken_block<Dim>(few_cells<Dim>()));
    const State<Dim>& state = simulation.state();
    const Eigen::MatrixXd S = weights(state, *simulation.model().scheme), before = velocities(state);
    const Eigen::VectorXd mass = S.colwise().sum().transpose(); // all points have one mass
    Eigen::MatrixXd back = S.transpose();                       // S⁺
    for (Index i = 0; i < mass.size(); ++i)
      if (mass[i] > 0.0) back.row(i) /= mass[i];
    Eigen::MatrixXd left = before; // (I − S S⁺)ᵐ V
    for (int k = 0; k < m; ++k) left -= Eigen::MatrixXd(S * Eigen::MatrixXd(back * left));
    simulation.step();
    EXPECT_LT((velocities(state) - (before - left)).cwiseAbs().maxCoeff(), 1e-5) << order.name << ", m = " << m;
    EXPECT_GT(left.cwiseAbs().maxCoeff(), 0.1) << "nothing to filter";
  }
}

TEST_P(TransferFormulaTest, XpicTakesOutThePowersOfWhatTheGridDoesNotSee) {
  for (const int m : {1, 2, 3, 6}) {
    expect_the_papers_filter<2>(GetParam(), m);
    expect_the_papers_filter<3>(GetParam(), m);
  }
}

/// The points' order may change in a run, so velocities are compared by id.
template <int Dim>
Eigen::MatrixXd after_steps(const std::string& scheme_name, const Transfer& chosen, StepFunction<Dim> step, int steps) {
  Model<Dim> model = model_with<Dim>(scheme_name, chosen, step);
  model.cfl = 0.2;
  Simulation<Dim> simulation(std::move(model), shaken_block<Dim>(few_cells<Dim>()));
  for (int i = 0; i < steps; ++i) simulation.step();
  const Points<Dim>& points = simulation.state().bodies[0].points;
  Eigen::MatrixXd V(points.size(), Dim);
  for (Index id = 0; id < points.size(); ++id)
    V.row(id) = points.velocity_of(points.place[static_cast<std::size_t>(id)]).transpose();
  return V;
}

TEST_P(TransferFormulaTest, XpicOfOrderOneIsPic) {
  const Transfer xpic1{"xpic 1", "xpic", {{"xpic_order", 1}}};
  for (const StepOrder<2>& order : orders_of_step<2>) {
    const Eigen::MatrixXd V = after_steps<2>(GetParam(), pic, order.step, 10);
    EXPECT_LT((after_steps<2>(GetParam(), xpic1, order.step, 10) - V).norm(), 1e-12 * V.norm()) << order.name;
    EXPECT_GT((after_steps<2>(GetParam(), xpic2, order.step, 10) - V).norm(), 1e-2 * V.norm()) << order.name;
  }
}

/// D_p = Σ_i N_ip (x_i − x_p) ⊗ (x_i − x_p) from the scheme's weights.
template <int Dim>
Mat<Dim> second_moment(const State<Dim>& state, const Eigen::MatrixXd& S, Index p) {
  Mat<Dim> D = Mat<Dim>::Zero();
  for (Index i = 0; i < S.cols(); ++i) {
    const Vec<Dim> r = state.grid.position(state.grid.index(i)) - state.bodies[0].points.position_of(p);
    D += S(p, i) * r * r.transpose();
  }
  return D;
}

template <int Dim>
void expect_a_linear_field_to_stay(const std::string& scheme_name, const Transfer& chosen,
                                   const StepOrder<Dim>& order) {
  SCOPED_TRACE(std::string(chosen.label) + ", " + order.name);
  Mat<3> all;
  all << 0.3, -2.0, 0.7, 1.1, -0.4, 0.2, 0.5, 0.9, -0.6;
  const Mat<Dim> C = all.topLeftCorner<Dim, Dim>();
  const Vec<Dim> constant = Vec<3>(0.4, -0.3, 0.2).head<Dim>();
  State<Dim> start = shaken_block<Dim>(few_cells<Dim>());
  Simulation<Dim> simulation(without_forces(model_with<Dim>(scheme_name, chosen, order.step)), std::move(start));
  State<Dim>& state = simulation.state();
  Points<Dim>& points = state.bodies[0].points;
  const Eigen::MatrixXd S = weights(state, *simulation.model().scheme);
  std::vector<Mat<Dim>> kept;
  for (Index p = 0; p < points.size(); ++p) {
    kept.push_back(chosen.name == "apic" ? Mat<Dim>(C * second_moment(state, S, p)) : C);
    const Vec<Dim> v = constant + C * points.position_of(p);
    for (int i = 0; i < Dim; ++i) {
      points.velocity[i][p] = v[i];
      for (int a = 0; a < Dim; ++a) points.transfer_data[i * Dim + a][p] = kept.back()(i, a);
    }
  }
  const Eigen::MatrixXd before = velocities(state);
  simulation.step();
  EXPECT_LT((velocities(state) - before).cwiseAbs().maxCoeff(), 1e-7);
  for (Index p = 0; p < points.size(); ++p) {
    Mat<Dim> after;
    for (int i = 0; i < Dim; ++i)
      for (int a = 0; a < Dim; ++a) after(i, a) = points.transfer_data[i * Dim + a][p];
    const double scale = kept[static_cast<std::size_t>(p)].norm();
    ASSERT_LT((after - kept[static_cast<std::size_t>(p)]).norm(), 1e-5 * scale) << p;
    ASSERT_LT((points.velocity_gradient_of(p) - C).norm(), 1e-5) << p;
  }
}

TEST_P(TransferFormulaTest, AffineTransfersPassOnALinearFieldExactly) {
  for (const Transfer& chosen : {apic, tpic}) {
    if (!offers(chosen)) continue;
    for (const StepOrder<2>& order : orders_of_step<2>) expect_a_linear_field_to_stay<2>(GetParam(), chosen, order);
    for (const StepOrder<3>& order : orders_of_step<3>) expect_a_linear_field_to_stay<3>(GetParam(), chosen, order);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, TransferFormulaTest, testing::ValuesIn(scheme_names()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace riedel::test
