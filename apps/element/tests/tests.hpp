/// The element tests that have a name. A new one is a file beside this, and a line here and in tests.cpp.
#pragma once

#include "apps/element/tests/test.hpp"

namespace riedel {

ElementTest oedometer_test();
ElementTest triaxial_test();
ElementTest shear_test();
ElementTest biaxial_element_test();

const std::vector<ElementTest>& named_element_tests();
/// Null for a path of one's own, and for a name that there is not.
const ElementTest* find_element_test(std::string_view name);

/// Whether the strain that a test is told by is γ; ε1 otherwise.
bool shears(std::string_view test);

} // namespace riedel
