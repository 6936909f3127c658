#include "apps/verify/study.hpp"

#include <cmath>

namespace riedel {

double VerifyStudy::order() const {
  // Cells double from run to run: x = 0, 1, 2, ...
  const auto n = static_cast<double>(runs.size());
  if (runs.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    sum += (static_cast<double>(i) - (n - 1) / 2) * -std::log2(runs[i].error);
  return 12 * sum / (n * (n * n - 1));
}

std::string VerifyStudy::missed() const {
  const Expectation wish = expected();
  const std::string wished = ", expected " + wish.text;
  if (!failure.empty()) return wish.text == Expectation().text ? "" : failure + wished;
  if (wish.min_order > 0.0 && order() < wish.min_order) return "order " + short_text(order()) + wished;
  if (!runs.empty() && !(runs.back().error <= wish.max_error)) return "error " + short_text(runs.back().error) + wished;
  return "";
}

VerifyStudy study(const VerifyProblem& problem, const Catalogue& catalogue, const std::string& scheme,
                  const StudyOptions& options) {
  const auto& entry = catalogue.in_2d.schemes.find(scheme);
  VerifyStudy answer{.problem = &problem,
                     .scheme = scheme,
                     .traits = entry.make(Values(entry.description.parameters))->traits(),
                     .points = options.points,
                     .runs = {},
                     .failure = {}};
  try {
    for (const Index cells : problem.cells)
      if (cells <= options.max_cells)
        answer.runs.push_back(problem.run({catalogue, scheme, cells, options.points, options.stop}));
  } catch (const RunError& error) { answer.failure = error.what(); }
  return answer;
}

} // namespace riedel
