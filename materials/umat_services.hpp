/// What Abaqus offers to subroutines: XIT, ROTSIG, SINV, SPRINC, SPRIND, STDB_ABQERR, under the names that Fortran
/// gives them. They are exported, so that a UMAT finds them.
#pragma once

#include <csetjmp>

namespace riedel {

/// Where XIT goes on this thread; null outside a call.
std::jmp_buf*& way_out_of_umat();

} // namespace riedel
