/// A problem under a scheme, with successively finer cells.
#pragma once

#include "apps/verify/problem.hpp"

namespace riedel {

struct VerifyStudy {
  const VerifyProblem* problem = nullptr;
  std::string scheme;
  SchemeTraits traits = {};
  int points = 0;              ///< per cell along each axis; 0: the problem's own number
  std::vector<VerifyRun> runs; ///< one for each of the problem's cells, as far as they went
  std::string failure;         ///< why the next run ended early; empty: none did

  [[nodiscard]] Expectation expected() const { return problem->expected(traits); }
  /// Slope of the straight line through the logarithms of errors and cells; not a number for fewer than two runs.
  [[nodiscard]] double order() const;
  /// How it misses the expectation, such as "order 0.8, expected 1 to 2"; empty: it does not.
  [[nodiscard]] std::string missed() const;
};

struct StudyOptions {
  Index max_cells = std::numeric_limits<Index>::max(); ///< finer ones are left out
  int points = 0;                                      ///< in a cell along each axis; 0: the problem's own number
  std::function<bool()> stop = {}; ///< asked between steps; true ends the study with `VerifyStopped`
};

VerifyStudy study(const VerifyProblem& problem, const Catalogue& catalogue, const std::string& scheme,
                  const StudyOptions& options = {});

} // namespace riedel
