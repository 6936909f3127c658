#pragma once

#include "core/interface/material.hpp"

namespace riedel {

/// Adds the built-in laws explicitly: static registrars would be dropped from archives.
void register_materials(Materials& materials);

} // namespace riedel
