/// Element tests in the files of IncrementalDriver (Niemunis 2007), in which many laws are published: parameters.inp,
/// initialconditions.inp and test.inp are read, and an output in its columns is written.
#pragma once

#include "core/io/case_file.hpp"
#include "core/io/history.hpp"
#include "materials/law_point.hpp"

namespace riedel {

/// The case that the three files describe. Tension is positive in them and stresses are in kPa; strains are natural,
/// and shears 2 ε_ij, without spin. The law is that of parameters.inp's first line, or `model` if that is given.
/// @throws InputError with file and line for what cannot be read or is not supported
CaseFile import_incremental_driver(const std::filesystem::path& folder, const std::optional<std::string>& model);

/// The columns time(1) time(2) stran(1..6) stress(1..6) statev(1..), tension positive, stresses in kPa. The state is
/// that of UMATs for hypoplastic sand: intergranular strain (0 of a law without), void ratio, and then what else there
/// is.
class IncrementalOutput {
public:
  IncrementalOutput(const std::filesystem::path& path, const Material& law);
  void add(const LawPoint& point);

private:
  OutputFile file_;
  std::vector<int> columns_; ///< of the law's state for each statev; −1: it has none
};

} // namespace riedel
