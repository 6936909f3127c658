/// "Did you mean ...?"
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace riedel {

/// Number of letters to insert, delete, replace or swap with their neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, or an empty text if none is near. The last part of dotted words is compared too,
/// so that a key in the wrong section is found.
std::string nearest(std::string_view word, std::span<const std::string> known);

/// " (did you mean 'linear'?)", or empty if no known word is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

} // namespace riedel
