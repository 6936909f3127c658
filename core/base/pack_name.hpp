/// Declares Pack and Mask under a name that follows the instruction set, as their layout does: libraries compiled for
/// different ones live in one process without taking each other's packs, or functions of packs, for their own.
#pragma once

namespace riedel {

#if defined(__AVX512F__)
inline namespace avx512 {
struct Pack;
struct Mask;
} // namespace avx512
namespace instructions = avx512;
#elif defined(__AVX__)
inline namespace avx {
struct Pack;
struct Mask;
} // namespace avx
namespace instructions = avx;
#else
inline namespace sse {
struct Pack;
struct Mask;
} // namespace sse
namespace instructions = sse;
#endif

} // namespace riedel
