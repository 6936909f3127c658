#include "nonlocal/register.hpp"

#include "nonlocal/cell_list.hpp"
#include "nonlocal/cgal_kd_tree.hpp"
#include "nonlocal/gauss.hpp"
#include "nonlocal/gauss_grid.hpp"

namespace riedel {

namespace {

template <class Search>
auto make_search() {
  return [] { return std::make_unique<Search>(); };
}

template <class Averager, class Search>
auto make_averager() {
  return [](double length, std::unique_ptr<Search> search) {
    return std::make_unique<Averager>(length, std::move(search));
  };
}

} // namespace

template <int Dim>
void register_nonlocal(CatalogueOf<Dim>& catalogue) {
  add_cgal_kd_tree(catalogue.searches);
  catalogue.searches.add({"cell_list", "bins a radius wide, without CGAL", "Hockney & Eastwood (1981)"},
                         make_search<CellList<Dim>>());
  catalogue.averagers.add({"gauss", "sum over pairs with Gaussian weights, cut off at 3 l_c",
                           "Krzyżanowski, Wójcik & Tejchman (2020), eqs. (1), (2)"},
                          make_averager<GaussAverager<Dim>, NeighbourSearch<Dim>>());
  catalogue.averagers.add({"gauss_grid", "the same through a fine grid, for many neighbours; to 1e-3, without a search",
                           "Krzyżanowski, Wójcik & Tejchman (2020), eqs. (1), (2)"},
                          [](double length, auto) { return std::make_unique<GaussGridAverager<Dim>>(length); });
}

template void register_nonlocal<2>(CatalogueOf<2>&);
template void register_nonlocal<3>(CatalogueOf<3>&);

} // namespace riedel
