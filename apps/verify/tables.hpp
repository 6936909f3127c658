/// The results of `riedel verify` as tables, as numbers for other programs, and as pictures.
#pragma once

#include "apps/verify/study.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace riedel {

/// Studies in the order of the problems, one Markdown table for each problem.
std::string verify_tables(const std::vector<VerifyStudy>& studies);

/// A line for each run; a cell is empty where there is no such number.
std::string verify_csv(const std::vector<VerifyStudy>& studies);

/// summary.json: version, status ("done", "interrupted"), and an object for each study; null where there is no such
/// number.
nlohmann::ordered_json verify_summary(const std::vector<VerifyStudy>& studies, const std::string& status);

/// convergence.png: errors against cells, of `problem`. cost.png: a line for each scheme, from its error with coarse
/// cells to that with fine ones, at its time per point and step.
void draw_verify(const std::vector<VerifyStudy>& studies, const VerifyProblem& problem,
                 const std::filesystem::path& folder);

} // namespace riedel
