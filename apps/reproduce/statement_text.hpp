/// Numbers as the statements print them, and the rules for verdicts.
#pragma once

#include "apps/reproduce/statements.hpp"

#include <algorithm>
#include <cmath>

namespace riedel {

inline std::string degrees(double x, int digits = 2) { return std::isnan(x) ? "–" : fixed_text(x, digits) + "°"; }
inline std::string percent(double x, int digits = 2) {
  return std::isnan(x) ? "–" : fixed_text(100.0 * x, digits) + " %";
}
inline std::string millimetres(double x) { return std::isnan(x) ? "–" : fixed_text(1e3 * x, 2) + " mm"; }

/// Open where a number is missing.
inline Verdict decide(bool known, bool holds, Verdict otherwise = Verdict::differs) {
  return !known ? Verdict::open : holds ? Verdict::agrees : otherwise;
}
inline Verdict within(double value, double wanted, double tolerance, Verdict otherwise = Verdict::differs) {
  return decide(!std::isnan(value), std::abs(value - wanted) <= tolerance, otherwise);
}
/// Rising, with dips no larger than the tolerance; missing values are left out, as long as three remain.
inline Verdict rising(std::vector<double> values, double tolerance) {
  std::erase_if(values, [](double x) { return std::isnan(x); });
  bool holds = true;
  for (std::size_t i = 1; i < values.size(); ++i) holds = holds && values[i] > values[i - 1] - tolerance;
  return decide(values.size() >= 3, holds);
}
inline std::string list(const std::vector<double>& values, double unit, int digits) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + (std::isnan(value) ? std::string("–") : fixed_text(value / unit, digits));
  return text;
}
inline std::vector<double> figures(const PaperResults& r, const std::vector<std::string>& runs,
                                   const std::string& name) {
  std::vector<double> values;
  for (const std::string& run : runs) values.push_back(r.figure(run, name));
  return values;
}

} // namespace riedel
