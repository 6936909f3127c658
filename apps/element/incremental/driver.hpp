/// Element tests in the files of IncrementalDriver (Niemunis 2007), in which many laws are published: parameters.inp,
/// initialconditions.inp and test.inp.
#pragma once

#include "core/case/case_file.hpp"

namespace riedel {

struct IncrementalFiles {
  std::filesystem::path parameters, initial_conditions, test;
};

/// @param wishes of `--import`: a folder, a file like test.inp, or param=FILE, ini=FILE, test=FILE, as the program
/// takes them; files are searched in the folder, and those that are not named have their usual names
/// @throws InputError for anything else
IncrementalFiles incremental_files(const std::vector<std::string>& wishes);

/// The case that the files describe. Tension is positive in them and stresses are in kPa, or in the unit of a UMAT;
/// strains are natural, and shears 2 ε_ij, without spin. The law is that of the first line of parameters.inp, unless
/// the settings name one; with a library, the parameters go to the UMAT as they are.
/// @param settings of the command line, which later override the case
/// @throws InputError with file and line for what cannot be read or is not supported
CaseFile import_incremental_driver(const IncrementalFiles& files, const CaseFile& settings);

} // namespace riedel
