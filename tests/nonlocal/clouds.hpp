/// Clouds of points for the tests of searches and averagers.
#pragma once

#include "core/interface/neighbour_search.hpp"

#include <random>

namespace riedel {

struct Cloud {
  std::string name;
  Columns positions;
};

/// @param count points   @param extent edge of the box that they fill evenly [m]
template <int Dim>
Columns random_points(Index count, double extent, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-0.3 * extent, 0.7 * extent);
  Columns x(Dim);
  x.resize(count);
  for (Index p = 0; p < count; ++p)
    for (int a = 0; a < Dim; ++a) x[a][p] = coordinate(random);
  return x;
}

/// Points numbered row by row. @param spacing [m]
template <int Dim>
Columns lattice(const Counts<Dim>& counts, double spacing) {
  Index count = 1;
  for (const Index n : counts) count *= n;
  Columns x(Dim);
  x.resize(count);
  for (Index p = 0; p < count; ++p) {
    Index rest = p;
    for (int a = 0; a < Dim; ++a) {
      x[a][p] = (rest % counts[a] + 0.5) * spacing;
      rest /= counts[a];
    }
  }
  return x;
}

template <int Dim>
Counts<Dim> cube(Index n) {
  Counts<Dim> counts;
  counts.fill(n);
  return counts;
}

/// Kinds of clouds on which a search has failed: all within a box of about one metre, except the widespread one.
template <int Dim>
std::vector<Cloud> clouds() {
  constexpr Index side = Dim == 2 ? 24 : 9;
  std::vector<Cloud> all;
  all.push_back({"no points", Columns(Dim)});
  all.push_back({"one point", random_points<Dim>(1, 1.0)});
  all.push_back({"random", random_points<Dim>(700, 1.0)});
  all.push_back({"lattice of binary fractions", lattice<Dim>(cube<Dim>(side), 0.0625)}); // distances are exact
  all.push_back({"lattice of decimal fractions", lattice<Dim>(cube<Dim>(side), 0.05)});
  Columns clustered = random_points<Dim>(600, 1.0, 2);
  for (Index p = 0; p < 500; ++p)
    for (int a = 0; a < Dim; ++a) clustered[a][p] = 0.2 + 1e-3 * clustered[a][p];
  all.push_back({"clustered", clustered});
  Columns coincident = random_points<Dim>(300, 1.0, 3);
  for (Index p = 100; p < 300; ++p)
    for (int a = 0; a < Dim; ++a) coincident[a][p] = coincident[a][p % 3];
  all.push_back({"coincident", coincident});
  Columns collinear = random_points<Dim>(300, 1.0, 4);
  for (int a = 1; a < Dim; ++a) collinear.fill(a, 0.1);
  all.push_back({"collinear", collinear});
  Columns far = random_points<Dim>(400, 1.0, 5);
  for (int a = 0; a < Dim; ++a) {
    far[a][7] = 1e12;
    far[a][8] = 1e12;
    far[a][399] = -1e300;
  }
  all.push_back({"far-flung", far});
  return all;
}

} // namespace riedel
