#include "apps/element/tests/tests.hpp"

#include <algorithm>

namespace riedel {

const std::vector<ElementTest>& named_element_tests() {
  static const std::vector<ElementTest> all{oedometer_test(), triaxial_test(), shear_test(), biaxial_element_test()};
  return all;
}

const ElementTest* find_element_test(std::string_view name) {
  const std::vector<ElementTest>& all = named_element_tests();
  const auto found = std::ranges::find(all, name, &ElementTest::name);
  return found == all.end() ? nullptr : &*found;
}

bool shears(std::string_view test) {
  const ElementTest* const named = find_element_test(test);
  return named != nullptr && named->shears();
}

} // namespace riedel
