/// Converts texts with units, such as "100 kPa", to numbers in a key's unit.
#pragma once

#include <string>
#include <string_view>

namespace riedel {

/// "1.5 mm" for a key in "m" gives 0.0015, identical to the bit to a written 0.0015.
/// The unit may be a product of powers: "kg/m3", "m/s^2", "kN/m²".
/// @param unit the unit of the result @throws InputError that says what is wrong with the text, without naming a key
double read_quantity(std::string_view text, std::string_view unit);

/// Units allowed in a text for a key in `unit`, for messages: "m, cm, mm, um".
std::string unit_examples(std::string_view unit);

} // namespace riedel
