#include "core/analysis/cheap_quality.hpp"

#include <numeric>

namespace riedel {

namespace {

constexpr double min_share = 0.02; ///< of the confining pressure, below which a point counts as stress-free
constexpr double block = 0.05;     ///< largest change of void ratio of a point in a rigid block

/// Change of the void ratio of the point with this id since the start; change of volume for a law without a void ratio.
template <int Dim>
double rise(const Body<Dim>& body, int void_ratio, std::size_t id) {
  const Points<Dim>& points = body.points;
  const Index p = points.place[id];
  const double J = points.volume[0][p] / points.initial_volume[0][p];
  if (void_ratio < 0) return J - 1.0;
  return (1.0 + points.state[void_ratio][p]) * (1.0 - 1.0 / J); // grains keep their volume
}

/// A point in a block has neither dilated much nor been loose from the start.
template <int Dim>
bool in_block(const Body<Dim>& body, int void_ratio, std::size_t id, double rise, double usual) {
  return rise < block && (void_ratio < 0 || body.points.state[void_ratio][body.points.place[id]] < usual + block);
}

/// Rms over all runs of four neighbours in a row that lie in a block.
template <int Dim>
double alternation(const Body<Dim>& body, std::size_t in_row, double usual_void_ratio) {
  const int e = state_column(body.material->states(), "void_ratio");
  double squares = 0.0, count = 0.0;
  for (std::size_t row = 0; row + in_row <= body.points.place.size(); row += in_row)
    for (std::size_t i = row; i + 3 < row + in_row; ++i) {
      std::array<double, 4> r{};
      bool counts = true;
      for (std::size_t k = 0; k < 4; ++k) {
        r[k] = rise(body, e, i + k);
        counts = counts && in_block(body, e, i + k, r[k], usual_void_ratio);
      }
      if (!counts) continue;
      squares += square((r[0] - 3.0 * r[1] + 3.0 * r[2] - r[3]) / 8.0);
      count += 1.0;
    }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

template <int Dim>
std::int64_t stressless(const Points<Dim>& points, double minimum) {
  std::int64_t count = 0;
  for (Index p = 0; p < points.size(); ++p)
    count += -(points.stress[0][p] + points.stress[1][p] + points.stress[2][p]) / 3.0 < minimum;
  return count;
}

/// Mean velocity of the last fifth of the ids in each layer, along the specimen's x axis.
template <int Dim>
double upper_velocity(const Points<Dim>& points, std::size_t in_layer, const Vec<2>& along) {
  double momentum = 0.0, mass = 0.0;
  for (std::size_t id = 0; id < points.place.size(); ++id) {
    if (id % in_layer < in_layer - in_layer / 5) continue;
    const Index p = points.place[id];
    momentum += points.mass[0][p] * (along[0] * points.velocity[0][p] + along[1] * points.velocity[1][p]);
    mass += points.mass[0][p];
  }
  return mass > 0.0 ? momentum / mass : 0.0;
}

} // namespace

template <int Dim>
CheapQuality cheap_quality(const Body<Dim>& specimen, const SpecimenRows& rows) {
  return {.alternation = alternation(specimen, rows.in_row, rows.void_ratio),
          .stressless = stressless(specimen.points, min_share * rows.pressure),
          .block_velocity = upper_velocity(specimen.points, rows.in_layer, rows.across)};
}

double swing(const std::vector<double>& u, const std::vector<double>& velocity) {
  if (u.size() < 4) return std::nan("");
  const double n = static_cast<double>(u.size());
  const double at = std::accumulate(u.begin(), u.end(), 0.0) / n,
               mean = std::accumulate(velocity.begin(), velocity.end(), 0.0) / n;
  double squares = 0.0, products = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    squares += square(u[i] - at);
    products += (u[i] - at) * (velocity[i] - mean);
  }
  const double slope = products / squares;
  for (std::size_t i = 0; i < u.size(); ++i) rest += square(velocity[i] - mean - slope * (u[i] - at));
  return std::sqrt(rest / n) / std::abs(mean);
}

template CheapQuality cheap_quality<2>(const Body<2>&, const SpecimenRows&);
template CheapQuality cheap_quality<3>(const Body<3>&, const SpecimenRows&);

} // namespace riedel
