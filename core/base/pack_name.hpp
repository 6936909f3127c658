/// Declares Pack and Mask under names that depend on the instruction set, as their layout does: libraries compiled for
/// different instruction sets share a process without mixing up their packs or functions of packs.
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
