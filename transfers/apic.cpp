#include "transfers/apic.hpp"

#include "transfers/kit/affine.ipp"

namespace riedel {

template <int Dim>
Mat<Dim> Apic<Dim>::velocity_moment(const Points<Dim>& points, Index p) const {
  Mat<Dim> B;
  for (int i = 0; i < Dim; ++i)
    for (int a = 0; a < Dim; ++a) B(i, a) = points.transfer_data[i * Dim + a][p];
  return B;
}

template class AffineTransfer<2, ApicGradient<2>, TakeFromGrid<2>>;
template class AffineTransfer<3, ApicGradient<3>, TakeFromGrid<3>>;
template class Apic<2>;
template class Apic<3>;

} // namespace riedel
