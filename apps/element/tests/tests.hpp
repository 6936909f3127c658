/// The named element tests. A new one is a file beside this, with a line here and in tests.cpp.
#pragma once

#include "apps/element/tests/test.hpp"

namespace riedel {

ElementTest oedometer_test();
ElementTest triaxial_test();
ElementTest shear_test();
ElementTest biaxial_element_test();

const std::vector<ElementTest>& named_element_tests();
/// Null for a path and for an unknown name.
const ElementTest* find_element_test(std::string_view name);

/// Whether a test is reported against γ; otherwise against ε1.
bool shears(std::string_view test);

} // namespace riedel
