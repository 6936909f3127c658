/// The statements of the paper, compared with the results.
#pragma once

#include "apps/reproduce/paper_results.hpp"

namespace riedel {

/// `cannot_hold`: it contradicts the paper's own law or its discretisation, whatever the program. `open`: a run that it
/// needs is missing.
enum class Verdict { agrees, differs, cannot_hold, open };
[[nodiscard]] const char* name_of(Verdict verdict);

struct Statement {
  std::string where;    ///< figure or section of the paper
  std::string claim;    ///< in our words, with the paper's number
  std::string measured; ///< with the tolerance that decides
  std::string theory;   ///< the expected value, if known; otherwise empty
  Verdict verdict = Verdict::open;
  std::string reason; ///< of a disagreement
};

/// Those about the figures that were reproduced, in the paper's order.
std::vector<Statement> element_statements(const CriticalState& end);
std::vector<Statement> biaxial_statements(const PaperResults& results);
std::vector<Statement> mesh_statements(const PaperResults& results); ///< those among them about Figure 7

/// The statements about the runs of one way.
struct Verdicts {
  std::string way; ///< its title
  std::vector<Statement> statements;
};

/// A row for each statement, with verdict and measurement for each way.
PageTable statement_table(const std::vector<Verdicts>& verdicts);
std::string statement_markdown(const std::vector<Verdicts>& verdicts);
/// For a terminal.
std::string statement_text(const std::vector<Verdicts>& verdicts);

} // namespace riedel
