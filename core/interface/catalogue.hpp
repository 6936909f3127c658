/// Everything that a case can name.
#pragma once

#include "core/interface/boundary_condition.hpp"
#include "core/interface/material.hpp"
#include "core/interface/nonlocal_averager.hpp"
#include "core/interface/shape_function.hpp"
#include "core/interface/velocity_transfer.hpp"

namespace riedel {

template <int Dim>
struct CatalogueOf {
  ShapeFunctions<Dim> schemes{"scheme"};
  NeighbourSearches<Dim> searches{"search"};
  NonlocalAveragers<Dim> averagers{"averager"};
  BoundaryConditions<Dim> boundaries{"boundary condition"};
  VelocityTransfers<Dim> transfers{"transfer"};
};

struct Catalogue {
  CatalogueOf<2> in_2d;
  CatalogueOf<3> in_3d;
  Materials materials{"material"};

  template <int Dim>
  [[nodiscard]] CatalogueOf<Dim>& in() {
    if constexpr (Dim == 2)
      return in_2d;
    else
      return in_3d;
  }
  template <int Dim>
  [[nodiscard]] const CatalogueOf<Dim>& in() const {
    if constexpr (Dim == 2)
      return in_2d;
    else
      return in_3d;
  }
};

} // namespace riedel
