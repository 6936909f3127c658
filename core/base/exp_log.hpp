/// Exponential and natural logarithm of a register of doubles, to about one unit in the last place. They take half as
/// long as xsimd's: no division in the exponential, no general conversions of integers.
#pragma once

#include <cstdint>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace riedel::detail {

using Register = xsimd::batch<double>;
using Bits = xsimd::batch<std::uint64_t>;

constexpr double ln_2_high =
    0x1.62e42fee00000p-1; ///< ln 2 without its last bits, so that products with an exponent are exact
constexpr double ln_2_low = 1.9082149292705877e-10;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Σ c_i x^i, in pairs, so that the processor need not wait for each product in turn.
template <class... C>
Register polynomial(const Register& x, const Register& square, double c0, double c1, C... rest) {
  const Register pair = xsimd::fma(Register(c1), x, Register(c0));
  if constexpr (sizeof...(rest) == 0)
    return pair;
  else if constexpr (sizeof...(rest) == 1)
    return xsimd::fma(Register(rest...), square, pair);
  else
    return xsimd::fma(polynomial(x, square, rest...), square, pair);
}

/// 0 below −708, where the result would be subnormal; ∞ above 709.7; NaN of NaN.
inline Register exponential(const Register& x) {
  const Register shift(0x1.8p52); // after adding it, the last bits of the sum are those of the nearest integer
  const Register shifted = xsimd::fma(x, Register(1.4426950408889634), shift), k = shifted - shift; // x / ln 2
  const Register r = xsimd::fnma(k, Register(ln_2_low), xsimd::fnma(k, Register(ln_2_high), x)), r2 = r * r;
  const Register q =
      polynomial(r, r2, 0.5000000000000001, 0.16666666666666669, 0.04166666666662413, 0.008333333333330062,
                 0.0013888888917213717, 0.00019841269863053618, 2.4801521295954376e-05, 2.7557268459997064e-06,
                 2.7620088445409746e-07, 2.510038549551032e-08);
  const Register power =
      xsimd::bitwise_cast<Register>((xsimd::bitwise_cast<Bits>(shifted) << 52) + Bits(0x3ff0000000000000)); // 2^k
  const Register result = power * xsimd::fma(r2, q, r + Register(1.0));
  return xsimd::select(x < Register(-708.0), Register(0.0),
                       xsimd::select(x > Register(709.7), Register(infinity), result));
}

/// −∞ of 0 and of numbers below 2.2e-308, ∞ of ∞, NaN of negative numbers and of NaN.
inline Register logarithm(const Register& x) {
  // x = 2^k m with m from √½ to √2. The exponent of x/√½ is k + 1023; 1 more keeps the unsigned number above zero.
  const Bits bits = xsimd::bitwise_cast<Bits>(x), mask(0xfff0000000000000);
  const Bits biased = bits - Bits(0x3fe6a09e667f3bcd) + Bits(0x4000000000000000); // k + 1024 in its upper bits
  const Register k =
      xsimd::bitwise_cast<Register>((biased >> 52) | Bits(0x4330000000000000)) - Register(0x1p52 + 1024.0);
  const Register m = xsimd::bitwise_cast<Register>(bits - (biased & mask) + Bits(0x4000000000000000));

  const Register f = m - Register(1.0), s = f / (f + Register(2.0)), z = s * s; // ln m = 2 artanh s
  const Register g = polynomial(z, z * z, 0.3333333333333335, 0.19999999999949722, 0.14285714313001635,
                                0.11111105565129939, 0.09091444727837474, 0.07665855309105386, 0.07308292712444311);
  const Register twice = s + s, ln_m = xsimd::fma(twice * z, g, twice);
  const Register result = xsimd::fma(k, Register(ln_2_high), xsimd::fma(k, Register(ln_2_low), ln_m));

  const auto normal = (x >= Register(std::numeric_limits<double>::min())) & (x < Register(infinity));
  const Register below =
      xsimd::select(x >= Register(0.0), Register(-infinity), Register(std::numeric_limits<double>::quiet_NaN()));
  return xsimd::select(normal, result, xsimd::select(x > Register(1.0), x, below));
}

} // namespace riedel::detail
