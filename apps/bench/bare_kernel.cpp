#include "apps/bench/bare_kernel.hpp"

#include "core/step/rotation.hpp"
#include "materials/gudehus_bauer.hpp"
#include "materials/linear_elastic.hpp"

namespace riedel {

namespace {

using Four [[gnu::vector_size(32)]] = double;
using Line [[gnu::vector_size(64)]] = double;

/// Transposes eight rows of eight numbers.
inline void transpose(double (&a)[8][8]) {
  Line r[8], s[8];
  for (int i = 0; i < 8; ++i) r[i] = *reinterpret_cast<const Line*>(a[i]);
  for (int i = 0; i < 8; i += 2) {
    s[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    s[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
    for (int k = i; k < i + 2; ++k) {
      r[k] = __builtin_shufflevector(s[k], s[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      r[k + 2] = __builtin_shufflevector(s[k], s[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int i = 0; i < 4; ++i) {
    *reinterpret_cast<Line*>(a[i]) = __builtin_shufflevector(r[i], r[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    *reinterpret_cast<Line*>(a[i + 4]) = __builtin_shufflevector(r[i], r[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

} // namespace

template <class Law, std::size_t States, int Nodes>
BareKernel<Law, States, Nodes>::BareKernel(const Law& law, const Grid<2>& grid, const Points<2>& points,
                                           double pressure, double flip)
    : law_(law),
      grid_(grid),
      half_width_(Nodes == 2 ? 0.0 : points.half_size[0][0] / grid.cell[0]),
      pressure_(pressure),
      flip_(flip),
      min_mass_(1e-12 * points.mass[0][0]),
      order_(static_cast<std::size_t>(points.size())),
      groups_(static_cast<std::size_t>((points.size() + pack_size - 1) / pack_size)),
      nodes_(static_cast<std::size_t>(grid.node_count())) {
  const auto first_node = [&](Index p) {
    const Vec<2> place = (points.position_of(p) - grid.origin).cwiseQuotient(grid.cell);
    return static_cast<Index>(place[1] - half_width_) * grid.nodes[0] + static_cast<Index>(place[0] - half_width_);
  };
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, {}, first_node);
  for (std::size_t i = 0; i < groups_.size() * pack_size; ++i) {
    const bool real = i < order_.size(); // lanes past the last point repeat it, without mass and volume
    const Index p = real ? order_[i] : order_.back();
    Group& g = groups_[i / pack_size];
    const std::size_t k = i % pack_size;
    for (int a = 0; a < 2; ++a) g.x[a][k] = points.position[a][p], g.v[a][k] = points.velocity[a][p];
    for (int c = 0; c < 4; ++c) g.F[c][k] = points.deformation_gradient[c][p], g.sigma[c][k] = points.stress[c][p];
    for (std::size_t s = 0; s < States; ++s) g.state[s][k] = points.state[static_cast<int>(s)][p];
    g.m[0][k] = real ? points.mass[0][p] : 0.0;
    g.V[0][k] = real ? points.volume[0][p] : 0.0;
    g.V_0[0][k] = real ? points.initial_volume[0][p] : 0.0;
  }
}

/// Positions are in cells, s = 1 at the second node reached.
template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::find_weights(const Group& g, Weights& w) const {
  Pack lowest[2];
  for (int a = 0; a < 2; ++a) {
    const Pack per_cell(1.0 / grid_.cell[a]), one(1.0);
    const Pack place = (Pack::load(g.x[a]) - Pack(grid_.origin[a])) * per_cell;
    lowest[a] = floor(place - Pack(half_width_));
    const Pack r = place - lowest[a] - one; // from the second node
    Pack N[Nodes], dN[Nodes];
    if constexpr (Nodes == 2) {
      N[0] = -r, N[1] = one + r;
      dN[0] = -per_cell, dN[1] = per_cell;
    } else {
      // Left of −l the box lies inside one cell, and the weights are those of hats: (l − c)²/4l + c − r and 0.
      const Pack l(half_width_), c = max(r, -l), quarter(0.25 / half_width_);
      N[0] = (l - c) * (l - c) * quarter + (c - r), N[2] = (l + c) * (l + c) * quarter;
      N[1] = one - N[0] - N[2];
      const Pack half = Pack(0.5 / half_width_) * per_cell;
      dN[0] = (c - l) * half, dN[2] = (c + l) * half;
      dN[1] = -(dN[0] + dN[2]);
    }
    for (int i = 0; i < Nodes; ++i) N[i].store(w.N[a][i]), dN[i].store(w.dN[a][i]);
  }
  double base[pack_size];
  (lowest[1] * Pack(grid_.nodes[0]) + lowest[0]).store(base);
  for (int k = 0; k < pack_size; ++k) w.base[k] = static_cast<Index>(base[k]);
}

/// m_i, (mv)_i, f_i = −Σ_p V_p (σ_p + p I) ∇N_ip.
template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::points_to_grid() {
  std::fill(nodes_.begin(), nodes_.end(), Node{});
  Weights w;
  Four sum[Nodes][Nodes] = {}, mass[Nodes] = {};
  Index current = 0;
  const auto flush = [&] {
    for (int j = 0; j < Nodes; ++j)
      for (int i = 0; i < Nodes; ++i) {
        Node& node = nodes_[current + j * grid_.nodes[0] + i];
        *reinterpret_cast<Four*>(node.a) += sum[j][i];
        node.m += mass[j][i];
        sum[j][i] = Four{};
      }
    for (Four& m : mass) m = Four{};
  };
  for (const Group& g : groups_) {
    find_weights(g, w);
    alignas(64) Lanes<8> row;
    const Pack m = Pack::load(g.m[0]), V = Pack::load(g.V[0]), p(pressure_);
    const Pack shear = Pack(-std::numbers::sqrt2 / 2) * V * Pack::load(g.sigma[3]);
    (m * Pack::load(g.v[0])).store(row[0]), (m * Pack::load(g.v[1])).store(row[1]);
    (-V * (Pack::load(g.sigma[0]) + p)).store(row[2]), shear.store(row[3]);
    Pack(0.0).store(row[4]), Pack(0.0).store(row[5]);
    shear.store(row[6]), (-V * (Pack::load(g.sigma[1]) + p)).store(row[7]);
    transpose(row);
    for (int k = 0; k < pack_size; ++k) {
      if (w.base[k] != current) flush(), current = w.base[k];
      const Four along_x = *reinterpret_cast<const Four*>(row[k]), along_y = *reinterpret_cast<const Four*>(row[k] + 4);
      Four x_part[Nodes], y_part[Nodes], Nm{};
      for (int i = 0; i < Nodes; ++i) {
        const double N = w.N[0][i][k], dN = w.dN[0][i][k];
        x_part[i] = Four{N, N, dN, dN} * along_x;
        y_part[i] = N * along_y;
        Nm[i] = N * g.m[0][k];
      }
      for (int j = 0; j < Nodes; ++j) {
        const double N = w.N[1][j][k], dN = w.dN[1][j][k];
        mass[j] += N * Nm;
        for (int i = 0; i < Nodes; ++i) sum[j][i] += N * x_part[i], sum[j][i] += dN * y_part[i]; // two multiply-adds
      }
    }
  }
  flush();
}

/// v_i = ((mv)_i + f_i Δt)/m_i and a_i = f_i/m_i.
template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::advance_nodes(double dt) {
  for (Node& node : nodes_) {
    const double per_mass = node.m > min_mass_ ? 1.0 / node.m : 0.0;
    for (int a = 0; a < 2; ++a) {
      node.a[2 + a] *= per_mass;
      node.a[a] = node.a[a] * per_mass + dt * node.a[2 + a];
    }
  }
}

/// For each point v_x, v_y, a_x, a_y, ∂v_x/∂x, ∂v_y/∂x, ∂v_x/∂y, ∂v_y/∂y.
template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::grid_to_points(const Group& g, Lanes<8>& rows) const {
  Weights w;
  find_weights(g, w);
  for (int k = 0; k < pack_size; ++k) {
    const Node* node = nodes_.data() + w.base[k];
    Four motion{}, along_x{}, along_y{};
    for (int j = 0; j < Nodes; ++j, node += grid_.nodes[0]) {
      Four value{}, gradient{};
      for (int i = 0; i < Nodes; ++i) {
        const Four& at = *reinterpret_cast<const Four*>(node[i].a);
        value += w.N[0][i][k] * at;
        gradient += w.dN[0][i][k] * at;
      }
      motion += w.N[1][j][k] * value;
      along_x += w.N[1][j][k] * gradient;
      along_y += w.dN[1][j][k] * value;
    }
    *reinterpret_cast<Four*>(rows[k]) = motion;
    *reinterpret_cast<Four*>(rows[k] + 4) = __builtin_shufflevector(along_x, along_y, 0, 1, 4, 5);
  }
  transpose(rows);
}

/// v_p, x_p, F_p, V_p, then rotation and law.
template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::update(Group& g, const Lanes<8>& c, double dt) const {
  for (int a = 0; a < 2; ++a) {
    const Pack v = Pack::load(c[a]);
    (Pack(flip_) * (Pack::load(g.v[a]) + Pack(dt) * Pack::load(c[2 + a])) + Pack(1.0 - flip_) * v).store(g.v[a]);
    (Pack::load(g.x[a]) + Pack(dt) * v).store(g.x[a]);
  }
  const Pack L[2][2] = {{Pack::load(c[4]), Pack::load(c[6])}, {Pack::load(c[5]), Pack::load(c[7])}};
  const Pack old[2][2] = {{Pack::load(g.F[0]), Pack::load(g.F[1])}, {Pack::load(g.F[2]), Pack::load(g.F[3])}};
  Pack F[2][2];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      F[i][j] = old[i][j] + Pack(dt) * (L[i][0] * old[0][j] + L[i][1] * old[1][j]);
      F[i][j].store(g.F[2 * i + j]);
    }
  (Pack::load(g.V_0[0]) * (F[0][0] * F[1][1] - F[0][1] * F[1][0])).store(g.V[0]);

  Sym<Pack> sigma = Sym<Pack>::zero(), D = Sym<Pack>::zero();
  for (int i = 0; i < 4; ++i) sigma.m[i] = Pack::load(g.sigma[i]);
  rotate(sigma, cayley(Pack(0.5) * (L[0][1] - L[1][0]), dt));
  D.m[0] = L[0][0], D.m[1] = L[1][1], D.m[3] = Pack(std::numbers::sqrt2 / 2) * (L[0][1] + L[1][0]);
  std::array<Pack, States> state;
  for (std::size_t s = 0; s < States; ++s) state[s] = Pack::load(g.state[s]);
  const auto rate = law_.rate(sigma, state, D, norm(D));
  for (int i = 0; i < 4; ++i) (sigma.m[i] + Pack(dt) * rate.stress.m[i]).store(g.sigma[i]);
  for (std::size_t s = 0; s < States; ++s) (state[s] + Pack(dt) * rate.state[s]).store(g.state[s]);
}

template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::step(double dt) {
  points_to_grid();
  advance_nodes(dt);
  alignas(64) Lanes<8> rows;
  for (Group& group : groups_) {
    grid_to_points(group, rows);
    update(group, rows, dt);
  }
}

template <class Law, std::size_t States, int Nodes>
void BareKernel<Law, States, Nodes>::write(Points<2>& points) const {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Group& g = groups_[i / pack_size];
    const std::size_t k = i % pack_size;
    const Index p = order_[i];
    for (int a = 0; a < 2; ++a) points.position[a][p] = g.x[a][k], points.velocity[a][p] = g.v[a][k];
    for (int c = 0; c < 4; ++c) points.deformation_gradient[c][p] = g.F[c][k], points.stress[c][p] = g.sigma[c][k];
    for (std::size_t s = 0; s < States; ++s) points.state[static_cast<int>(s)][p] = g.state[s][k];
    points.volume[0][p] = g.V[0][k];
  }
}

template class BareKernel<GudehusBauer, 1, 2>;
template class BareKernel<GudehusBauer, 1, 3>;
template class BareKernel<LinearElastic, 0, 2>;
template class BareKernel<LinearElastic, 0, 3>;

} // namespace riedel
