/// How a run is called and drawn in a legend.
#pragma once

#include "core/case/vary.hpp"
#include "core/draw/pens.hpp"

#include <span>

namespace riedel {

/// What a run differs in, with symbols and units that are read at a glance: "SCHEME, l_c = 4 mm, e₀ = 0.55". Keys
/// without a symbol are called by their last word, or wholly where two of them end alike.
/// @param keys of the case, for their units
std::string legend_label(const std::vector<Setting>& settings, const Keys& keys);

/// The colour of a scheme, the same in every plot.
/// @param schemes in the order of their colours; one that is not among them is put behind them
std::size_t color_of_scheme(std::vector<std::string>& schemes, const std::string& scheme);

/// Pens for runs that differ in these settings. The colour tells the scheme, where that varies, else the first key that
/// does; the dashes tell the rest.
/// @param schemes in the order of their colours
std::vector<Pen> pens_of(std::span<const std::vector<Setting>> runs, std::vector<std::string> schemes);

} // namespace riedel
