/// "Did you mean ...?"
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace riedel {

/// Letters to insert, delete, replace or swap with their neighbour to turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, or an empty text when none is near. Of dotted words the last part counts as well,
/// so that a key in the wrong section finds its place.
std::string nearest(std::string_view word, std::span<const std::string> known);

/// " (did you mean 'linear'?)", or nothing when no known word is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

} // namespace riedel
