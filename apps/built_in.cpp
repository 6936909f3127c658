#include "apps/built_in.hpp"

#include "apps/riedel.hpp"

namespace riedel {

Catalogue full_catalogue() { return built_in(); }

Inventory load_catalogue(const std::vector<std::string>& named) { return with_plugins(built_in(), named); }

Inventory load_catalogue(const CaseFile& given) { return with_plugins(built_in(), given); }

} // namespace riedel
