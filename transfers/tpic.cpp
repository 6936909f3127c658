#include "transfers/tpic.hpp"

#include "transfers/kit/affine.ipp"

namespace riedel {

template class AffineTransfer<2, TaylorGradient<2>, TakeFromGrid<2>>;
template class AffineTransfer<3, TaylorGradient<3>, TakeFromGrid<3>>;
template class Tpic<2>;
template class Tpic<3>;

} // namespace riedel
