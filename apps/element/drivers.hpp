/// The drivers of element tests: from a case to a curve.
#pragma once

#include "apps/element/case.hpp"
#include "core/interface/catalogue.hpp"
#include "materials/element/rows.hpp"

namespace riedel {

/// A driver returns its results even if the material could not follow the path; `failure` then says why.
struct ElementDriver {
  std::string name, summary;
  ElementCurve (*run)(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch);
};

/// One line each.
const std::vector<ElementDriver>& element_drivers();
std::vector<std::string> element_driver_names();
/// The driver that the case names.
const ElementDriver& element_driver(const ElementCase& given);

/// One point under mixed control.
ElementCurve run_point_driver(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch);

/// A specimen of cells between smooth plates, under any scheme.
ElementCurve run_mpm_driver(const ElementCase& given, const Catalogue& catalogue, const ElementWatch& watch);

} // namespace riedel
