/// The machine that a program runs on, for the head of a report.
#pragma once

#include <string>

namespace riedel {

/// Instruction set that the library was compiled for, as wide as its packs: "AVX-512".
std::string instruction_set();

/// Name of the processor; "unknown" where the system does not tell.
std::string processor_name();

} // namespace riedel
