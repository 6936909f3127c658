#include "nonlocal/cgal_kd_tree.hpp"

#include "nonlocal/kit/rows.hpp"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

namespace riedel {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

template <int Dim>
struct Cgal;
template <>
struct Cgal<2> {
  using Point = Kernel::Point_2;
  using Traits = CGAL::Search_traits_2<Kernel>;
  static Point point(const Vec<2>& x) { return {x[0], x[1]}; }
};
template <>
struct Cgal<3> {
  using Point = Kernel::Point_3;
  using Traits = CGAL::Search_traits_3<Kernel>;
  static Point point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }
};

/// Gives the tree, which stores indices of points, the position of a point.
template <class Point>
struct PlaceOf {
  using key_type = Index;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::lvalue_property_map_tag;

  const Point* places = nullptr;
  reference operator[](Index p) const { return places[p]; }
  friend reference get(const PlaceOf& map, Index p) { return map.places[p]; }
};

} // namespace

template <int Dim>
void CgalKdTree<Dim>::find(const Columns& positions, double radius, NeighbourRows& rows) {
  using Point = typename Cgal<Dim>::Point;
  using Traits = CGAL::Search_traits_adapter<Index, PlaceOf<Point>, typename Cgal<Dim>::Traits>;
  using Tree = CGAL::Kd_tree<Traits>;
  using Sphere = CGAL::Fuzzy_sphere<Traits>;

  require_finite<Dim>(positions);
  std::vector<Point> places(static_cast<std::size_t>(positions.size()));
  std::vector<Index> numbers(places.size());
  for (Index p = 0; p < positions.size(); ++p) {
    Vec<Dim> place;
    for (int a = 0; a < Dim; ++a) place[a] = positions[a][p];
    places[p] = Cgal<Dim>::point(place);
    numbers[p] = p;
  }
  const Traits traits(PlaceOf<Point>{places.data()});
  Tree tree(numbers.begin(), numbers.end(), typename Tree::Splitter(), traits);
  if (!numbers.empty()) tree.build(); // before the queries below, which run in parallel

  fill_rows<Dim>(positions, radius, rows, [&](const Surroundings<Dim>& around, std::vector<Index>& list) {
    const Point centre = Cgal<Dim>::point(around.centre);
    tree.search(std::back_inserter(list), Sphere(centre, around.reach, 0.0, traits));
  });
}

template <int Dim>
void add_cgal_kd_tree(NeighbourSearches<Dim>& searches) {
  searches.add({"cgal_kd_tree", "k-d tree of CGAL", "Bentley (1975), Commun. ACM 18"},
               [] { return std::make_unique<CgalKdTree<Dim>>(); });
}

template class CgalKdTree<2>;
template class CgalKdTree<3>;
template void add_cgal_kd_tree<2>(NeighbourSearches<2>&);
template void add_cgal_kd_tree<3>(NeighbourSearches<3>&);

} // namespace riedel
