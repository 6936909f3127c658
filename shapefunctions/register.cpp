#include "shapefunctions/register.hpp"

#include "shapefunctions/bspline.hpp"
#include "shapefunctions/cpdi.hpp"
#include "shapefunctions/cpdi2.hpp"
#include "shapefunctions/ddmp.hpp"
#include "shapefunctions/gimp.hpp"
#include "shapefunctions/linear.hpp"
#include "shapefunctions/lme.hpp"

namespace riedel {

namespace {
template <class Scheme, int Dim>
void add(ShapeFunctions<Dim>& schemes, std::string summary, std::string source) {
  Description description{
      .name = std::string(Scheme::name), .summary = std::move(summary), .source = std::move(source)};
  if constexpr (std::is_constructible_v<Scheme, const Values&>) {
    description.parameters = Scheme::parameters();
    schemes.add(std::move(description), [](const Values& options) { return std::make_unique<Scheme>(options); });
  } else {
    schemes.add(std::move(description), [](const Values&) { return std::make_unique<Scheme>(); });
  }
}
} // namespace

template <int Dim>
void register_shape_functions(ShapeFunctions<Dim>& schemes) {
  add<Linear<Dim>>(schemes, "multilinear hats at the point: the standard material point method",
                   "Sulsky, Chen & Schreyer (1994)");
  add<Gimp<Dim>>(schemes, "uniform GIMP: hats averaged over a box of fixed share of a cell",
                 "Bardenhagen & Kober (2004)");
  add<Cpgimp<Dim>>(schemes, "contiguous-particle GIMP: the box follows the point's stretch",
                   "Wallstedt & Guilkey (2008)");
  add<Cpdi<Dim>>(schemes, "convected particle domain interpolation: the domain deforms with F",
                 "Sadeghirad, Brannon & Burghardt (2011)");
  add<Cpdi2<Dim>>(schemes, "second-order CPDI: the corners of the domain move with the grid",
                  "Sadeghirad, Brannon & Guilkey (2013)");
  add<Ddmp<Dim>>(schemes, "dual domain: hats at the point, gradients made continuous by averages around the nodes",
                 "Zhang, Ma & Giguere (2011)");
  add<QuadraticBspline<Dim>>(schemes, "quadratic B-splines at the point, modified at walls",
                             "Steffen, Kirby & Berzins (2008)");
  add<CubicBspline<Dim>>(schemes, "cubic B-splines at the point, modified at walls", "Steffen, Kirby & Berzins (2008)");
  add<Lme<Dim>>(schemes, "local maximum entropy: the least biased weights near the point", "Arroyo & Ortiz (2006)");
}

template void register_shape_functions<2>(ShapeFunctions<2>&);
template void register_shape_functions<3>(ShapeFunctions<3>&);

} // namespace riedel
