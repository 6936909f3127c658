/// Texts with units, such as "100 kPa", turned into numbers in a key's own unit.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// "1.5 mm" for a key in "m" gives 0.0015, with the same bits as if 0.0015 had been written.
/// The unit may be a product of powers: "kg/m3", "m/s^2", "kN/m²".
/// @param unit the unit of the answer   @throws InputError that says what is wrong with the text, without naming a key
double read_quantity(std::string_view text, std::string_view unit);

/// Units that a text for a key in `unit` may carry, for messages: "m, cm, mm, um".
std::string unit_examples(std::string_view unit);

} // namespace riedel
