/// The law of the paper, the default of a case that names none.
#pragma once

#include "core/case/case_file.hpp"

namespace riedel {

inline constexpr std::string_view paper_model = "gudehus_bauer";

inline std::string model_of(const CaseFile& given) {
  return given.peek_text("material.model").value_or(std::string(paper_model));
}

} // namespace riedel
