/// Verification problems: each has a known solution, and runs under any scheme with cells of any size.
#pragma once

#include "core/interface/catalogue.hpp"

#include <functional>
#include <limits>
#include <span>

namespace riedel {

/// The input of one run of a problem.
struct VerifyCase {
  const Catalogue& catalogue;
  std::string scheme;
  Index cells;
  int points = 0;                  ///< per cell along each axis; 0: the problem's own number
  std::function<bool()> stop = {}; ///< asked between steps; true ends the run with `VerifyStopped`
};

struct VerifyStopped {};

/// The results of one run of a problem.
struct VerifyRun {
  double error = 0.0;               ///< as `VerifyProblem::measure` says [-]
  double ns = 0.0;                  ///< per point and step
  std::vector<double> figures = {}; ///< as `VerifyProblem::figures` names them [-]
};

/// What theory or the scheme's authors predict.
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
  std::string measure; ///< definition of its error, and the known solution
  std::string source;
  std::vector<Index> cells;         ///< along the body; one number, or from coarse to fine, each twice the one before
  std::vector<std::string> figures; ///< further results of a run, as deviations
  VerifyRun (*run)(const VerifyCase& given);
  Expectation (*expected)(const SchemeTraits& scheme);
};

/// All problems: one line each.
std::span<const VerifyProblem> verify_problems();

} // namespace riedel
