/// Verification problems: each has a known answer, and runs under any scheme with cells of any size.
#pragma once

#include "core/interface/catalogue.hpp"

#include <functional>
#include <limits>
#include <span>

namespace riedel {

/// What one run of a problem is told.
struct VerifyCase {
  const Catalogue& catalogue;
  std::string scheme;
  Index cells;
  int points = 0;                  ///< in a cell along each axis; 0: as many as the problem has by itself
  std::function<bool()> stop = {}; ///< asked between steps; true ends the run with `VerifyStopped`
};

struct VerifyStopped {};

/// What one run of a problem tells.
struct VerifyRun {
  double error = 0.0;               ///< as `VerifyProblem::measure` says [-]
  double ns = 0.0;                  ///< per point and step
  std::vector<double> figures = {}; ///< as `VerifyProblem::figures` names them [-]
};

/// What theory or the scheme's authors promise.
struct Expectation {
  std::string text = "none";
  double min_order = 0.0;                                     ///< of convergence; 0: none
  double max_error = std::numeric_limits<double>::infinity(); ///< with the finest cells [-]
};

/// Of displacements, in a problem whose points cross cells.
Expectation expected_across_cells(const SchemeTraits& scheme);

struct VerifyProblem {
  std::string name;
  std::string title;
  std::string measure; ///< what its error is, and the known answer
  std::string source;
  std::vector<Index> cells;         ///< along the body; one number, or from coarse to fine, each twice the last
  std::vector<std::string> figures; ///< what else a run tells, as deviations
  VerifyRun (*run)(const VerifyCase& given);
  Expectation (*expected)(const SchemeTraits& scheme);
};

/// Every problem: a line each.
std::span<const VerifyProblem> verify_problems();

} // namespace riedel
