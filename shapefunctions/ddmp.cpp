#include "shapefunctions/ddmp.hpp"

#include "core/state/cell_place.hpp"
#include "shapefunctions/kit/tensor_product.hpp"

#include <atomic>

namespace riedel {

namespace {

enum NodeColumn { nearness, filling, per_volume };

constexpr int bit(int number, int axis) { return (number >> axis) & 1; }

/// Raises a number that other threads may raise too; the maximum wins in any order.
void raise(double& number, double to) {
  std::atomic_ref<double> shared(number);
  double now = shared.load(std::memory_order_relaxed);
  while (now < to && !shared.compare_exchange_weak(now, to, std::memory_order_relaxed)) {}
}

/// max_p S_i(x_p) at each node.
template <int Dim>
void find_nearness(const Grid<Dim>& grid, const Points<Dim>& points, double* near) {
  parallel_for(grid.node_count(), [&](Index i) { near[i] = 0.0; });
  for_each_block(points.size(), [&](Range block) {
    for (Index p = block.begin; p < block.end; ++p) {
      const CellPlace<Dim> place(grid, points.position_of(p));
      if (!place.inside()) continue;
      for (int n = 0; n < power(2, Dim); ++n) raise(near[place.node(n)], place.hat(n));
    }
  });
}

/// Nodes at the corners of the cell above a node: offsets of their indices.
template <int Dim>
std::array<Index, power(2, Dim)> corners_of_cell(const Grid<Dim>& grid) {
  const Counts<Dim> strides = grid.strides();
  std::array<Index, power(2, Dim)> offset{};
  for (int n = 0; n < power(2, Dim); ++n)
    for (int a = 0; a < Dim; ++a) offset[n] += bit(n, a) * strides[a];
  return offset;
}

/// ∫_cell S_j ∂S_i/∂x_a dx, from its factors along the axes: ±1/2 along a, h/3 or h/6 along the others.
template <int Dim>
double coupling(const Grid<Dim>& grid, int j, int i, int a) {
  double K = bit(i, a) ? 0.5 : -0.5;
  for (int b = 0; b < Dim; ++b)
    if (b != a) K *= grid.cell[b] * (bit(i, b) == bit(j, b) ? 1.0 / 3.0 : 1.0 / 6.0);
  return K;
}

/// Positions of eight points in their cells, and their hats there.
template <int Dim>
struct PointsInCells {
  std::array<Pack, Dim> xi;           ///< 0 to 1
  std::array<Index, pack_size> first; ///< the lowest node of the patch: one below the cell along each axis
  std::array<Pack, power(2, Dim)> hat;
  std::array<Pack, Dim> first_row; ///< of the patch along each axis
  Mask inside;

  PointsInCells(const Grid<Dim>& grid, const Points<Dim>& points, Index p) {
    const Counts<Dim> strides = grid.strides();
    Pack number(0.0);
    for (int a = 0; a < Dim; ++a) {
      const Pack x = load_lanes(points.position[a], p, points.size());
      const Pack place = (x - Pack(grid.origin[a])) * Pack(1.0 / grid.cell[a]), cell = floor(place);
      const Mask fits = cell >= Pack(1.0) && cell <= Pack(grid.nodes[a] - 3); // also false for NaN
      inside = a == 0 ? fits : inside && fits;
      xi[a] = select(fits, place - cell, Pack(0.0));
      first_row[a] = select(fits, cell - Pack(1.0), Pack(0.0));
      number += first_row[a] * Pack(strides[a]);
    }
    first = whole_numbers(number);
    for (int n = 0; n < power(2, Dim); ++n) {
      hat[n] = Pack(1.0);
      for (int a = 0; a < Dim; ++a) hat[n] *= bit(n, a) ? xi[a] : Pack(1.0) - xi[a];
    }
  }

  /// Values of a nodal column at an offset from the patch's lowest node.
  [[nodiscard]] Pack column_at(const double* column, Index offset) const {
    std::array<double, pack_size> lane;
    for (int k = 0; k < pack_size; ++k) lane[k] = column[first[k] + offset];
    return Pack::load(lane.data());
  }
};

template <int Dim>
using PatchSlopes = std::array<std::array<Pack, Dim>, power(4, Dim)>;

/// Index of the patch's entry whose node is `above` nodes above its lowest node, along each axis.
template <int Dim>
int entry_at(const Counts<Dim>& above) {
  int entry = 0;
  for (int a = Dim - 1; a >= 0; --a) entry = 4 * entry + above[a];
  return entry;
}

/// (1 − α) Σ_j S_j/V_j Σ_c ω_c ∫_c S_j ∇S_i: over the cells around each node j of the points' own cell.
template <int Dim>
void add_averaged_gradients(const Grid<Dim>& grid, const Columns& node_data, const PointsInCells<Dim>& at,
                            const Pack& share, PatchSlopes<Dim>& gradients) {
  constexpr int corners = power(2, Dim);
  const Counts<Dim> strides = grid.strides();
  for (int j = 0; j < corners; ++j) {
    Index node = 0;
    for (int a = 0; a < Dim; ++a) node += (1 + bit(j, a)) * strides[a];
    const Pack of_node = share * at.hat[j] * at.column_at(node_data[per_volume], node);
    for (int below = 0; below < corners; ++below) { // the cell whose corner `below` is node j
      Counts<Dim> cell;
      Index lowest = 0;
      for (int a = 0; a < Dim; ++a) lowest += (cell[a] = 1 + bit(j, a) - bit(below, a)) * strides[a];
      const Pack weight = of_node * at.column_at(node_data[filling], lowest);
      for (int i = 0; i < corners; ++i) {
        Counts<Dim> above;
        for (int a = 0; a < Dim; ++a) above[a] = cell[a] + bit(i, a);
        for (int a = 0; a < Dim; ++a) gradients[entry_at<Dim>(above)][a] += weight * Pack(coupling(grid, below, i, a));
      }
    }
  }
}

} // namespace

template <int Dim>
const Keys& Ddmp<Dim>::parameters() {
  static const Keys keys{
      {"alpha", 0.5, "-", between(0, 1), "ddmp: share of the hats' own gradient at a cell's centre"}};
  return keys;
}

/// The filling of a cell measures how near points come to all of its corners; it is full at the hat values of a point
/// at its centre. So nodes that no point reaches do not enter any average, and cells are left and entered smoothly.
template <int Dim>
void Ddmp<Dim>::prepare(const Grid<Dim>& grid, const Points<Dim>& points, Columns& node_data) const {
  constexpr int corners = power(2, Dim);
  double *const near = node_data[nearness], *const fill = node_data[filling], *const per_V = node_data[per_volume];
  find_nearness(grid, points, near);
  const std::array<Index, corners> offset = corners_of_cell(grid);
  const Index last = grid.node_count() - 1;
  parallel_for(grid.node_count(), [&](Index i) { // the last rows of nodes have no cell
                                                 // above; their results are not used
    double minimum = 1.0;
    for (const Index o : offset) minimum = std::min(minimum, corners * near[std::min(i + o, last)]);
    fill[i] = minimum;
  });
  const double share = grid.cell.prod() / corners; // ∫_cell S_j
  parallel_for(grid.node_count(), [&](Index i) {
    double V = 0.0;
    for (const Index o : offset) V += share * fill[std::max(i - o, 0)];
    per_V[i] = V > 0.0 ? 1.0 / V : 0.0;
  });
}

template <int Dim>
void Ddmp<Dim>::evaluate(const Grid<Dim>& grid, const Points<Dim>& points, Range block, Stencils<Dim>& stencils) const {
  constexpr int corners = power(2, Dim);
  for (Index p = block.begin; p < block.end; p += pack_size) {
    StencilGroup<Dim>& group = stencils.group_of(p);
    const PointsInCells<Dim> at(grid, points, p);
    Pack alpha(stencils.node_data == nullptr ? 1.0 : alpha_); // no averages for rigid bodies
    if (stencils.node_data != nullptr)
      for (const Pack& xi : at.xi) alpha *= Pack(4.0) * xi * (Pack(1.0) - xi);

    PatchSlopes<Dim> gradients;
    for (auto& gradient : gradients) gradient.fill(Pack(0.0));
    if (stencils.node_data != nullptr)
      add_averaged_gradients<Dim>(grid, *stencils.node_data, at, Pack(1.0) - alpha, gradients);
    set_nodes<4, Dim>(grid.strides(), at.first, group);
    for (int e = 0; e < group.count; ++e) group.set_value(e, Pack(0.0));
    for (int n = 0; n < corners; ++n) {
      Counts<Dim> above;
      for (int a = 0; a < Dim; ++a) above[a] = 1 + bit(n, a);
      const int entry = entry_at<Dim>(above);
      group.set_value(entry, at.hat[n]);
      for (int a = 0; a < Dim; ++a) {
        Pack dS(bit(n, a) ? 1.0 / grid.cell[a] : -1.0 / grid.cell[a]);
        for (int b = 0; b < Dim; ++b)
          if (b != a) dS *= bit(n, b) ? at.xi[b] : Pack(1.0) - at.xi[b];
        gradients[entry][a] += alpha * dS;
      }
    }
    for (int e = 0; e < group.count; ++e)
      for (int a = 0; a < Dim; ++a) group.set_gradient(e, a, gradients[e][a]);
    group.lowest = whole_numbers(at.first_row[Dim - 1]);
    for (int k = 0; k < pack_size; ++k) group.highest[k] = group.lowest[k] + 3;
    group.keep_lanes(at.inside);
  }
}

template class Ddmp<2>;
template class Ddmp<3>;

} // namespace riedel
