/// The architecture rules. Each checks one file, or all of them, and returns the offences: empty if there are none.
#pragma once

#include "architecture/source_tree.hpp"

namespace riedel::architecture {

using Offences = std::vector<std::string>;

/// Includes go down the floors only: base <- state <- interface <- step <- io; shapefunctions see base, state and
/// interface; materials and nonlocal see base and interface; apps and tests see everything.
Offences includes_that_run_up(const SourceFile& file);

/// Includes between the folders of two apps.
Offences includes_of_other_apps(const SourceFile& file);

/// Files that include each other in a circle.
Offences circles_of_includes(const std::vector<SourceFile>& files);

/// A library with heavy or infectious headers is included in the few files named for it, and in tests.
Offences libraries_out_of_place(const SourceFile& file);

/// What core must not name: schemes, laws and transfers, taken from the files of shapefunctions/,
/// materials/ and transfers/. A name made of everyday words only, such as `linear`, is forbidden as a quoted text.
std::vector<std::string> names_of_plugged_in(const std::vector<SourceFile>& files);
Offences names_in_core(const SourceFile& file, const std::vector<std::string>& names);

/// In core, outside core/setup, a kind of boundary condition is included by its own source and the register alone.
Offences kinds_of_boundaries_known(const SourceFile& file, const std::vector<SourceFile>& files);

/// Headers of at most 140 lines, sources of at most 280.
Offences files_too_long(const SourceFile& file);

/// Notes of unfinished work.
Offences unfinished_work(const SourceFile& file);

/// Paths that exist only on one machine.
Offences paths_of_a_machine(const SourceFile& file);

} // namespace riedel::architecture
