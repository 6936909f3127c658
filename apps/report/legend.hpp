/// How a run is called and drawn in a legend.
#pragma once

#include "apps/vary.hpp"
#include "core/io/pens.hpp"

#include <span>

namespace riedel {

/// What a run differs in, with symbols and units that are read at a glance: "gimp, l_c = 4 mm, e₀ = 0.55". Keys without
/// a symbol are called by their last word, or wholly where two of them end alike.
std::string legend_label(const std::vector<Setting>& settings);

/// The colour of a scheme, the same in every plot.
std::size_t color_of_scheme(const std::string& scheme);

/// Pens for runs that differ in these settings. The colour tells the scheme, where that varies, else the first key that
/// does; the dashes tell the rest.
std::vector<Pen> pens_of(std::span<const std::vector<Setting>> runs);

} // namespace riedel
