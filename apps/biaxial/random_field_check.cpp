#include "apps/biaxial/random_field_check.hpp"

#include "apps/biaxial/patch.hpp"
#include "core/case/material_keys.hpp"
#include "core/setup/random_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace riedel {

namespace {

constexpr double max_samples = 4e6;         ///< a second or two
constexpr std::size_t rows_at_once = 128;   ///< of samples
constexpr double samples_per_length = 16.0; ///< between which a field falls short of its extremes by 2 % of σ
constexpr double near_limit = 0.1;          ///< of σ: there every point is checked

struct Outlier {
  Vec<2> x;
  double void_ratio;
};

/// The points of the specimen, some of them as samples.
class Search {
public:
  Search(const BiaxialCase& v, const VoidRatioLimits& limits)
      : field_(random_field(v)),
        patch_(v),
        limits_(limits),
        mean_(v.specimen.void_ratio),
        near_(near_limit * v.imperfection.deviation) {
    const double wanted = v.imperfection.correlation_length / samples_per_length;
    const Vec<2> edge(v.specimen.width, v.specimen.height);
    for (int a = 0; a < 2; ++a) {
      points_[a] = v.grid.cells[static_cast<std::size_t>(a)] * v.specimen.points_per_cell;
      spacing_[a] = edge[a] / static_cast<double>(points_[a]);
      stride_[a] = std::clamp<std::int64_t>(static_cast<std::int64_t>(wanted / spacing_[a]), 1, points_[a]);
    }
    const double samples =
        static_cast<double>(points_[0] / stride_[0] + 1) * static_cast<double>(points_[1] / stride_[1] + 1);
    if (samples <= max_samples) return;
    is_complete_ = false;
    for (int a = 0; a < 2; ++a)
      stride_[a] =
          static_cast<std::int64_t>(std::ceil(static_cast<double>(stride_[a]) * std::sqrt(samples / max_samples)));
  }

  [[nodiscard]] bool is_complete() const { return is_complete_; }
  [[nodiscard]] std::int64_t points_per_sample() const { return stride_[0] * stride_[1]; }

  [[nodiscard]] std::optional<Outlier> find() const {
    if (limits_.admit(mean_ - field_.bound()) && limits_.admit(mean_ + field_.bound())) return std::nullopt;
    const std::vector<double> x = places(0, 0, points_[0], stride_[0]), y = places(1, 0, points_[1], stride_[1]);
    for (std::size_t first = 0; first < y.size(); first += rows_at_once) {
      const std::vector<double> rows(y.begin() + static_cast<std::ptrdiff_t>(first),
                                     y.begin() + static_cast<std::ptrdiff_t>(std::min(first + rows_at_once, y.size())));
      const auto above_mean = field_.on_lattice(x, rows);
      for (std::size_t j = 0; j < rows.size(); ++j)
        for (std::size_t i = 0; i < x.size(); ++i)
          if (auto outlier = check({x[i], rows[j]}, above_mean(static_cast<Index>(i), static_cast<Index>(j))))
            return outlier;
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] std::vector<double> places(int axis, std::int64_t first, std::int64_t end, std::int64_t stride) const {
    std::vector<double> all;
    for (std::int64_t i = first; i < end; i += stride) all.push_back((static_cast<double>(i) + 0.5) * spacing_[axis]);
    return all;
  }
  [[nodiscard]] bool admits(const Vec<2>& x, double e) const { return limits_.admit(e) || patch_.contains(x); }

  /// At a sample, and where it is near a limit at the points around it.
  [[nodiscard]] std::optional<Outlier> check(const Vec<2>& x, double above_mean) const {
    const double e = mean_ + above_mean;
    if (!admits(x, e)) return Outlier{x, e};
    if (!is_complete_ || points_per_sample() == 1 || (e - near_ > limits_.lower && e + near_ <= limits_.upper))
      return std::nullopt;
    std::array<std::vector<double>, 2> around;
    for (int a = 0; a < 2; ++a) {
      const auto at = static_cast<std::int64_t>(x[a] / spacing_[a]);
      around[static_cast<std::size_t>(a)] =
          places(a, std::max<std::int64_t>(0, at - stride_[a]), std::min(points_[a], at + stride_[a] + 1), 1);
    }
    const auto values = field_.on_lattice(around[0], around[1]);
    for (std::size_t j = 0; j < around[1].size(); ++j)
      for (std::size_t i = 0; i < around[0].size(); ++i) {
        const Vec<2> place(around[0][i], around[1][j]);
        const double there = mean_ + values(static_cast<Index>(i), static_cast<Index>(j));
        if (!admits(place, there)) return Outlier{place, there};
      }
    return std::nullopt;
  }

  VoidRatioField field_;
  SpecimenPatch patch_;
  VoidRatioLimits limits_;
  double mean_, near_;
  std::array<std::int64_t, 2> points_{}, stride_{};
  Vec<2> spacing_;
  bool is_complete_ = true;
};

} // namespace

void check_random_field(const BiaxialCase& v, const Catalogue& catalogue, Diagnostics& found) {
  if (v.imperfection.deviation == 0.0 || !found.errors.empty()) return;
  const std::string& model = v.material.model;
  const auto law = catalogue.materials.find(model).make(v.material.parameters);
  if (state_column(law->states(), "void_ratio") < 0) {
    found.errors.push_back({{"imperfection.deviation", "material.model"},
                            "\"" + model + "\" has no void ratio that could be random; take 0"});
    return;
  }
  const bool bounded = has_limits_of_void_ratio(v.keys);
  const VoidRatioLimits limits = bounded ? limits_of_void_ratio(v.keys, v.loading.confining_pressure)
                                         : VoidRatioLimits{0.0, std::numeric_limits<double>::infinity()};
  const std::vector<std::string> keys{"imperfection.deviation", "imperfection.seed", "specimen.void_ratio"};
  const Search search(v, limits);
  if (const auto outlier = search.find())
    found.errors.push_back(
        {keys, "the random field gives the point at (" + rounded(outlier->x[0]) + ", " + rounded(outlier->x[1]) +
                   ") m the void ratio " + exact_text(outlier->void_ratio) +
                   ", which is out of range; the law allows " +
                   (bounded ? "(" + rounded(limits.lower) + ", " + rounded(limits.upper) + "] at the confining pressure"
                            : "> 0")});
  else if (!search.is_complete())
    found.warnings.push_back(
        {keys, "only one in " + std::to_string(search.points_per_sample()) +
                   " points was checked: the void ratio of another may be out of the law's range"});
}

} // namespace riedel
