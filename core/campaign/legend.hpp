/// Label and pen of a run in a legend.
#pragma once

#include "core/case/vary.hpp"
#include "core/draw/pens.hpp"

#include <span>

namespace riedel {

/// The settings in which a run differs, with readable symbols and units: "SCHEME, l_c = 4 mm, e₀ = 0.55". Keys without
/// a symbol are shown by their last word, or in full if two of them end in the same word.
/// @param keys of the case, for their units
std::string legend_label(const std::vector<Setting>& settings, const Keys& keys);

/// The colour of a scheme, the same in every plot.
/// @param schemes in the order of their colours; one that is not among them is appended
std::size_t color_of_scheme(std::vector<std::string>& schemes, const std::string& scheme);

/// Pens for runs that differ in these settings. The colour shows the scheme if that varies, otherwise the first key
/// that does; the dashes show the rest.
/// @param schemes in the order of their colours
std::vector<Pen> pens_of(std::span<const std::vector<Setting>> runs, std::vector<std::string> schemes);

} // namespace riedel
