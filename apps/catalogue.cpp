#include "apps/catalogue.hpp"

#include "materials/register.hpp"
#include "nonlocal/register.hpp"
#include "shapefunctions/register.hpp"

namespace riedel {

Catalogue full_catalogue() {
  Catalogue catalogue;
  register_shape_functions(catalogue.in_2d.schemes);
  register_shape_functions(catalogue.in_3d.schemes);
  register_nonlocal(catalogue.in_2d);
  register_nonlocal(catalogue.in_3d);
  register_materials(catalogue.materials);
  return catalogue;
}

} // namespace riedel
