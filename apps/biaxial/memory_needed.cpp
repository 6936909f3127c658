#include "apps/biaxial/memory_needed.hpp"

#include "apps/biaxial/geometry.hpp"
#include "core/case/checked_case.hpp"
#include "core/case/step_keys.hpp"
#include "core/case/transfer_keys.hpp"
#include "core/run/failure.hpp"
#include "core/run/memory_there.hpp"
#include "core/step/model.hpp"
#include "core/step/state.hpp"

#include <cmath>

namespace riedel {

namespace {

// Measured: memory in use besides the arrays that are counted here.
constexpr double bytes_of_program = 57e6;
constexpr double bytes_of_pictures = 32e6; ///< while they are drawn, when frames have been written
constexpr double little_room = 3 << 20;    ///< stencils are kept up to here in any case

template <int Dim>
double entry_bytes() {
  return (1 + Dim) * sizeof(double) + sizeof(Index);
}

template <int Dim>
double columns_of_a_point(const ShapeFunction<Dim>& scheme, const VelocityTransfer<Dim>& transfer, int states) {
  Points<Dim> points;
  points.resize(0, states);
  double columns = Dim; // Δt Σ N v
  for (const Columns* field : points.fields()) columns += field->components();
  return columns + scheme.point_data_size() + transfer.point_data_size();
}

/// Numbers that a frame holds for a point: position, corners, the law's state and what `snapshot` adds to it.
template <int Dim>
double fields_of_a_frame(int states) {
  constexpr double others = 20; // stress and velocity count three and six times
  return others + states;
}

/// A frame, what VTK makes of it, and the bytes of the file, twice while they are compressed.
template <int Dim>
double bytes_of_frame(int states) {
  const double fields = fields_of_a_frame<Dim>(states), corners = 3 * power(2, Dim);
  const double frame = sizeof(double) * (3 + corners + fields);
  const double raw = sizeof(double) * corners + sizeof(float) * fields + sizeof(std::int64_t) * power(2, Dim);
  return frame + 2.0 * raw;
}

template <int Dim>
double bytes_of_stencils(const BiaxialCase& v, const ShapeFunction<Dim>& scheme, double points) {
  const double all = points * scheme.max_nodes() * entry_bytes<Dim>();
  const bool kept =
      v.keys.text("time.order") == "usf" || filters_stresses(v.keys); // the filter keeps them for its steps
  return kept || all <= little_room ? all : 0.0;
}

template <int Dim>
double bytes_of_neighbours(const BiaxialCase& v, const Catalogue& catalogue, const std::array<double, 3>& counts,
                           const Vec<Dim>& spacing) {
  constexpr double bytes_of_pair = 10.0, reach = 3.1; // 8 at first; 12 in a later search, beside the old weights
  const double length = v.nonlocal.length;
  if (length == 0.0) return 0.0;
  const auto& known = catalogue.in<Dim>();
  auto search = known.searches.find(v.nonlocal.search).make();
  if (!known.averagers.find(v.nonlocal.averager).make(length, std::move(search))->keeps_pairs()) return 0.0;
  std::array<double, 3> apart{spacing[0], spacing[1], 1.0};
  if constexpr (Dim == 3) apart[2] = spacing[2];
  return bytes_of_pair * pairs_within(counts, apart, reach * length);
}

template <int Dim>
MemoryNeeded needed(const BiaxialCase& v, const Catalogue& catalogue) {
  const auto scheme = catalogue.in<Dim>().schemes.find(v.scheme).make(v.interpolation);
  const auto law = catalogue.materials.find(v.material.model).make(v.material.parameters);
  const SpecimenGeometry<Dim> specimen(v, *scheme);
  const double per_direction = static_cast<double>(v.specimen.points_per_cell);
  std::array<double, 3> counts{1.0, 1.0, 1.0};
  double points = 1.0;
  for (std::size_t a = 0; a < Dim; ++a) points *= counts[a] = specimen.cells[a] * per_direction;
  double nodes = 1.0;
  const Grid<Dim> grid = specimen.grid();
  for (const Index n : grid.nodes) nodes *= n;

  const int states = state_components(law->states());
  const auto transfer = make_transfer<Dim>(v.keys, catalogue, 0.0);
  MemoryNeeded need{.program = bytes_of_program};
  constexpr double numbering = 6 * sizeof(Index) + sizeof(double); // ids, places and the space of a sort
  need.points = points * (sizeof(double) * columns_of_a_point(*scheme, *transfer, states) + numbering);
  constexpr double sums = sizeof(NodeSums<Dim>), motion = sizeof(NodeMotion<Dim>), number = sizeof(double);
  need.nodes = nodes * (sums + motion * (1.0 + transfer->node_records()) + number * scheme->node_data_size());
  if (filters_stresses(v.keys)) {
    need.points += points * (sizeof(ShortVector<8>) + number);
    need.nodes += nodes * (3.0 * sizeof(ShortVector<8>) + number);
  }
  need.stencils = bytes_of_stencils<Dim>(v, *scheme, points);
  need.neighbours = law->nonlocal_variables().empty()
                        ? 0.0
                        : bytes_of_neighbours<Dim>(v, catalogue, counts, specimen.cell / per_direction);
  if (v.output.vtk || v.output.plots) need.frames = points * bytes_of_frame<Dim>(states);
  if (v.output.plots) need.frames = std::max(need.frames, bytes_of_pictures);
  return need;
}

} // namespace

double pairs_within(const std::array<double, 3>& counts, const std::array<double, 3>& spacing, double radius) {
  const auto maximum = [&](int axis, double way) {
    return std::min(counts[axis] - 1.0, std::floor(way / spacing[axis]));
  };
  const auto left = [](double way_squared) { return std::sqrt(std::max(way_squared, 0.0)); };
  double pairs = 0.0;
  for (double k = -maximum(2, radius); k <= maximum(2, radius); ++k) {
    const double in_layer = left(square(radius) - square(k * spacing[2]));
    for (double j = -maximum(1, in_layer); j <= maximum(1, in_layer); ++j) {
      const double i = maximum(0, left(square(in_layer) - square(j * spacing[1]))); // Σ (n − |i|) from −i to i
      pairs += (counts[2] - std::abs(k)) * (counts[1] - std::abs(j)) * ((2.0 * i + 1.0) * counts[0] - i * (i + 1.0));
    }
  }
  return pairs;
}

MemoryNeeded memory_needed(const BiaxialCase& values, const Catalogue& catalogue) {
  return values.grid.dimensions == 3 ? needed<3>(values, catalogue) : needed<2>(values, catalogue);
}

void require_memory(const BiaxialCase& values, const Catalogue& catalogue, const CaseFile& file) {
  const MemoryNeeded need = memory_needed(values, catalogue);
  const MemoryThere there = memory_there();
  if (need.of_case() <= there.bytes) return;
  const Finding too_large{{"grid.cells", "specimen.points_per_cell", "nonlocal.length"},
                          std::string(reasons::too_large) + " " + bytes_text(need.of_case()) + " of memory, " +
                              bytes_text(need.neighbours) + " of them for neighbours within nonlocal.length, and " +
                              there.by + " " + bytes_text(there.bytes) +
                              "; use fewer grid.cells, fewer specimen.points_per_cell or a shorter nonlocal.length"};
  throw InputError(file.lines({too_large}));
}

} // namespace riedel
