/// What a drawing or a file shows of one instant of a run: plain numbers, independent of the simulation.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace riedel {

/// One quantity at all points; the components of a point are adjacent.
struct Field {
  std::string name;
  int components = 1;
  std::string unit;           ///< "Pa", "-", ... shown by ParaView next to the name
  std::vector<double> values; ///< components × points; NaN if a point has no such quantity
  bool whole = false;         ///< counts or ids, written as integers
};

struct Frame {
  int dimension = 2; ///< 2 or 3
  double time = 0;   ///< [s]
  /// Of the frame as a whole, by name, such as u_over_h; stored in files with the time.
  std::map<std::string, double> scalars = {};
  std::vector<double> position; ///< x, y, z of each point [m]; z = 0 in 2-D
  /// x, y, z of the 2^dimension corners of each point's domain [m]: counter-clockwise in 2-D, in the order of
  /// VTK_HEXAHEDRON in 3-D. Empty if the points have no domains.
  std::vector<double> corners;
  std::vector<Field> fields;

  [[nodiscard]] std::size_t points() const { return position.size() / 3; }
  [[nodiscard]] int corners_per_point() const { return 1 << dimension; }

  [[nodiscard]] bool has(const std::string& name) const;
  /// The field of that name; throws InputError that lists the available names.
  [[nodiscard]] const Field& field(const std::string& name) const;

  /// The scalar of that name; throws InputError that lists the available names.
  [[nodiscard]] double scalar(const std::string& name) const;

  /// Throws std::logic_error unless every array has the length required by the dimension and the number of points.
  void check() const;
};

/// The frame without its rigid points, which have no mass: what measurements are made on.
Frame deformable_points(const Frame& frame);

} // namespace riedel
