/// The description of a named element test: everything in which the tests differ.
#pragma once

#include "core/base/parameters.hpp"
#include "materials/element/curve.hpp"

#include <array>

namespace riedel {

/// A column of element.csv as an axis of a picture.
struct PictureAxis {
  std::string column, label;
  double unit = 1.0; ///< what the column is multiplied by
};

struct ElementPicture {
  std::string file;
  PictureAxis x, y;
  bool log_x = false;
};

/// How the plates normal to one axis move.
enum class PlateMotion { fixed, free, driven };

struct ElementTest {
  std::string name, title;
  double void_ratio = 0.60; ///< default of specimen.void_ratio

  Keys loading;              ///< the test's own keys of [loading]
  std::string pressure_key;  ///< the one of them for the pressure from all sides at the start [Pa]
  std::string pressure_name; ///< its name in messages

  /// Of the six conditions on a point, those that are not γ12 = γ13 = γ23 = 0; the driven measure follows
  /// loading.final_strain, and the others are kept constant.
  std::array<std::string, 3> normal; ///< such as eps_1, sigma_2, sigma_3
  std::string driven = "eps_1";      ///< one of `normal`, or gamma
  Friction friction = Friction::in_plane;
  std::string limit_measure = {}, limit_key = {}; ///< ends the test above that value, if reached first; empty: none

  int dimensions = 2; ///< of the specimen; 3 where plane strain would be another test
  std::array<PlateMotion, 3> plates{PlateMotion::driven, PlateMotion::fixed, PlateMotion::fixed}; ///< normal to 1, 2, 3
  bool confined = true; ///< the pressure acts on the sides throughout the test

  std::vector<ElementPicture> pictures;

  /// Whether direction 1 is that of shear, and 2 the normal to the sheared planes.
  [[nodiscard]] bool shears() const { return driven == "gamma"; }
};

/// Keys for the tables of the tests.
Key element_pressure_key(const std::string& name, double standard, std::string doc);
Key element_strain_key(double standard, const std::string& doc, double maximum = 1.0);
inline constexpr const char* ends_at_vertical_strain = "vertical strain u/h0 at which the test ends";

/// Axes of the pictures.
namespace picture_axes {
PictureAxis eps_1(), gamma(), sigma_1(), tau(), p(), q(), phi(), void_ratio();
}
/// Stress and strain, friction, void ratio, compression and p-q of a test that compresses along 1.
std::vector<ElementPicture> pictures_of_compression();

} // namespace riedel
