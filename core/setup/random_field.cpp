#include "core/setup/random_field.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace riedel {

namespace {

constexpr int number_of_modes = 1000;

/// Random numbers that are the same on every platform: the standard defines the generator's bits, but not how its
/// distributions use them.
class Random {
public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// In (0, 1).
  double uniform() { return (static_cast<double>(bits_() >> 11U) + 0.5) * 0x1p-53; }
  /// Two standard normal numbers (Box & Muller 1958).
  Vec<2> normals() {
    const double radius = std::sqrt(-2.0 * std::log(uniform())), angle = 2.0 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

private:
  std::mt19937_64 bits_;
};

} // namespace

VoidRatioField::VoidRatioField(double deviation, double length, std::uint64_t seed) {
  if (deviation == 0.0) return;
  Random random(seed);
  const double wave_number = std::numbers::sqrt2 / length;
  for (int m = 0; m < number_of_modes; ++m) {
    const Vec<2> k = wave_number * random.normals();
    modes_.push_back({k, 2.0 * std::numbers::pi * random.uniform()});
  }
  amplitude_ = deviation * std::sqrt(2.0 / number_of_modes);
}

double VoidRatioField::operator()(const Vec<2>& x) const {
  double sum = 0.0;
  for (const Mode& mode : modes_) sum += std::cos(mode.k.dot(x) + mode.phase);
  return amplitude_ * sum;
}

/// cos(a + b) = cos a cos b − sin a sin b: a product of two matrices.
Eigen::MatrixXd VoidRatioField::on_lattice(std::span<const double> x, std::span<const double> y) const {
  const auto modes = static_cast<Index>(modes_.size()), rows = static_cast<Index>(x.size()),
             columns = static_cast<Index>(y.size());
  Eigen::MatrixXd along_x(rows, 2 * modes), along_y(2 * modes, columns);
  for (Index m = 0; m < modes; ++m) {
    const Mode& mode = modes_[static_cast<std::size_t>(m)];
    for (Index i = 0; i < rows; ++i) {
      along_x(i, m) = std::cos(mode.k[0] * x[static_cast<std::size_t>(i)]);
      along_x(i, modes + m) = -std::sin(mode.k[0] * x[static_cast<std::size_t>(i)]);
    }
    for (Index j = 0; j < columns; ++j) {
      along_y(m, j) = std::cos(mode.k[1] * y[static_cast<std::size_t>(j)] + mode.phase);
      along_y(modes + m, j) = std::sin(mode.k[1] * y[static_cast<std::size_t>(j)] + mode.phase);
    }
  }
  return amplitude_ * (along_x * along_y);
}

} // namespace riedel
