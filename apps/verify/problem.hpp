/// Verification problems: each has a known answer, and runs under any scheme with cells of any size.
#pragma once

#include "core/interface/catalogue.hpp"

#include <span>

namespace riedel {

/// What one run of a problem is told.
struct VerifyCase {
  const Catalogue& catalogue;
  std::string scheme;
  Index cells;
};

/// What one run of a problem tells.
struct VerifyRun {
  double error = 0.0;               ///< relative L2 error of the problem's quantity [-]
  double ns = 0.0;                  ///< per point and step
  std::vector<double> figures = {}; ///< as `VerifyProblem::figures` names them [-]
};

/// The order of convergence that theory or the scheme's authors promise.
struct ExpectedOrder {
  double least = 0.0; ///< 0: none
  std::string text;
};

struct VerifyProblem {
  std::string name;
  std::string title, known; ///< what it is, and its known answer
  std::string source;
  std::vector<Index> cells;         ///< along the body, from coarse to fine, each twice the last
  std::vector<std::string> figures; ///< what else a run tells
  VerifyRun (*run)(const VerifyCase& given);
  ExpectedOrder (*expected)(std::string_view scheme);
};

/// Every problem: a line each.
std::span<const VerifyProblem> verify_problems();

} // namespace riedel
