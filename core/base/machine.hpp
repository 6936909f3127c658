/// The machine that a program runs on, for the header of a report.
#pragma once

#include <string>

namespace riedel {

/// Instruction set that the library was compiled for, which sets the width of packs: "AVX-512".
std::string instruction_set();

/// Name of the processor; "unknown" if the system does not give it.
std::string processor_name();

} // namespace riedel
