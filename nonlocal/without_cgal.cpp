/// Replaces cgal_kd_tree.cpp in a build without CGAL.
#include "nonlocal/cgal_kd_tree.hpp"

namespace riedel {

template <int Dim>
void add_cgal_kd_tree(NeighbourSearches<Dim>& searches) {
  searches.leave_out("cgal_kd_tree", "needs CGAL, which this build lacks: configure Riedel with "
                                     "-DRIEDEL_WITH_CGAL=ON (Debian's libcgal-dev)");
}

template void add_cgal_kd_tree<2>(NeighbourSearches<2>&);
template void add_cgal_kd_tree<3>(NeighbourSearches<3>&);

} // namespace riedel
