#include "materials/umat.hpp"

#include "core/base/error.hpp"
#include "core/base/tensor.hpp"

#include <Eigen/LU>
#include <cmath>
#include <sstream>

namespace riedel {

namespace {

constexpr std::size_t most_states = 56; ///< so that the total strain has room beside them
constexpr int most_cuts = 1000;         ///< sub-steps of one step, and times that it is cut

/// Of a component from Mandel's to Abaqus': stresses as they are, strains with engineering shear.
constexpr double stress_shear = 1.0 / std::numbers::sqrt2, strain_shear = std::numbers::sqrt2;

std::array<double, 6> scaled(std::array<double, 6> a, double shear) {
  for (std::size_t c = 3; c < 6; ++c) a[c] *= shear;
  return a;
}

/// Row by row to column by column.
std::array<double, 9> by_columns(const Mat<3>& a) {
  std::array<double, 9> all;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) all[static_cast<std::size_t>(j * 3 + i)] = a(i, j);
  return all;
}

Mat<3> matrix_of(const std::array<const double*, 9>& columns, Index p) {
  Mat<3> a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(i, j) = columns[static_cast<std::size_t>(i * 3 + j)][p];
  return a;
}

/// Greatest of nine longitudinal stiffnesses n n : C : n n, along axes and the diagonals between two of them [Pa].
double longitudinal(const std::array<double, 36>& stiffness) {
  const auto C = [&](int i, int j) { return 0.5 * (stiffness[j * 6 + i] + stiffness[i * 6 + j]); };
  double greatest = 0.0;
  for (int i = 0; i < 3; ++i) greatest = std::max(greatest, C(i, i));
  for (int k = 3; k < 6; ++k) { // 12, 13, 23
    const int i = k == 5 ? 1 : 0, j = k == 3 ? 1 : 2;
    const double normal = 0.25 * (C(i, i) + C(j, j)) + 0.5 * C(i, j) + C(k, k), mixed = C(i, k) + C(j, k);
    greatest = std::max(greatest, normal + std::abs(mixed));
  }
  return greatest;
}

bool finite(const std::array<double, 6>& a) {
  return std::ranges::all_of(a, [](double x) { return std::isfinite(x); });
}

} // namespace

/// A point between the library's columns and the subroutine's arguments.
struct Umat::Point {
  UmatCall call;
  std::array<double, most_states> state{};
};

Keys Umat::parameters() {
  const Bounds any{};
  const std::vector<double> none;
  return {{"library", std::string(), "", any, "shared library with the UMAT"},
          {"symbol", std::string("umat_"), "", any, "its name in the library; umat_ is UMAT of gfortran and ifx"},
          {"name", std::string("MATERIAL"), "", any, "CMNAME"},
          {"parameters", none, "-", any, "PROPS, in the UMAT's units", {}, true},
          {"state", none, "-", any, "STATEV at the start", {}, true},
          {"state_names", std::string(), "", any,
           "names of STATEV in their order, such as \"void_ratio, h:strain, flag\": void_ratio takes the specimen's; "
           ":stress and :strain stand for six numbers that turn with the material, the latter with engineering shear"},
          {"thread_safe", false, "", any, "whether threads may share the library; otherwise each has a copy"},
          {"takes_average", false, "", any, "hand ‖D‖ Δt, or its non-local average, over in DPRED(1)"},
          {"density", 2000.0, "kg/m3", more_than(0), "bulk density, for a UMAT without a void_ratio"},
          {"grain_density", 2650.0, "kg/m3", more_than(0), "density of the grains, for one with it"},
          {"length", 1.0, "m", more_than(0), "CELENT"}};
}

Umat::Umat(const Values& given)
    : cmname_(given.text("name")),
      parameters_(given.numbers("parameters")),
      takes_average_(given.flag("takes_average")),
      density_(given.number("density")),
      grain_density_(given.number("grain_density")),
      length_(given.number("length")) {
  check_bounds(parameters(), given, name);
  if (const std::string& path = given.text("library"); !path.empty())
    library_ = std::make_unique<UmatLibrary>(path, given.text("symbol"), given.flag("thread_safe"));
  add_states(given);
}

void Umat::add_states(const Values& given) {
  std::istringstream words(given.text("state_names"));
  for (std::string word; std::getline(words, word, ',');) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    const std::size_t colon = word.find(':');
    const std::string kind = colon == std::string::npos ? "" : word.substr(colon + 1), label = word.substr(0, colon);
    if (label.empty() || (!kind.empty() && kind != "stress" && kind != "strain"))
      throw InputError("umat: state_names: '" + word + "' is no name; allowed: NAME, NAME:stress, NAME:strain");
    if (label == "void_ratio") void_ratio_ = static_cast<int>(shear_factors_.size());
    const int components = kind.empty() ? 1 : 6;
    states_.push_back({label, "-", "STATEV of the UMAT", components});
    for (int c = 0; c < components; ++c)
      shear_factors_.push_back(c < 3 ? 1.0 : kind == "stress" ? stress_shear : strain_shear);
  }
  const std::vector<double>& start = given.numbers("state");
  while (shear_factors_.size() < start.size()) { // the rest goes by number
    states_.push_back({"state_" + std::to_string(shear_factors_.size() + 1), "-", "STATEV of the UMAT"});
    shear_factors_.push_back(1.0);
  }
  if (start.size() != shear_factors_.size() && !start.empty())
    throw InputError("umat: state has " + std::to_string(start.size()) + " numbers, state_names stand for " +
                     std::to_string(shear_factors_.size()));
  if (shear_factors_.size() > most_states)
    throw InputError("umat: " + std::to_string(shear_factors_.size()) +
                     " state variables are too many; allowed: " + std::to_string(most_states));
  initial_ = start;
  initial_.resize(shear_factors_.size(), 0.0);
  for (std::size_t s = 0; s < initial_.size(); ++s) initial_[s] /= shear_factors_[s];
  states_.push_back({"umat_strain", "-", "STRAN, the total strain that turns with the material", 6});
  initial_.resize(initial_.size() + 6, 0.0);
}

std::vector<std::string> Umat::nonlocal_variables() const {
  if (takes_average_) return {"rate_norm"};
  return {};
}

double Umat::density(std::span<const double> state) const {
  return void_ratio_ < 0 ? density_ : grain_density_ / (1.0 + state[static_cast<std::size_t>(void_ratio_)]);
}

Umat::Point Umat::point_of(const MaterialBatch& batch, Index p) const {
  Point point;
  UmatCall& call = point.call;
  const std::size_t own = shear_factors_.size();
  for (std::size_t s = 0; s < own; ++s) point.state[s] = shear_factors_[s] * batch.state[s][p];
  for (std::size_t c = 0; c < 6; ++c) {
    call.stress[c] = batch.stress[c][p];
    call.strain[c] = batch.state[own + c][p];
    call.strain_increment[c] = batch.rate[c] == nullptr ? 0.0 : batch.rate[c][p] * batch.time_step;
  }
  double squares = 0.0;
  for (const double x : call.strain_increment) squares += x * x;
  if (takes_average_)
    call.field_increment = batch.averaged != nullptr ? batch.averaged[p] * batch.time_step : std::sqrt(squares);
  call.stress = scaled(call.stress, stress_shear);
  call.strain = scaled(call.strain, strain_shear);
  call.strain_increment = scaled(call.strain_increment, strain_shear);
  call.time = {batch.time, batch.time};
  call.time_step = batch.time_step;
  call.length = length_;
  call.point = static_cast<int>(p) + 1;
  call.increment = batch.time > 0.0 ? 2 : 1;
  if (batch.motion == nullptr || batch.time_step == 0.0) return point;
  const Mat<3> L = matrix_of(batch.motion->velocity_gradient, p), F = matrix_of(batch.motion->deformation_gradient, p);
  const Mat<3> half_spin = 0.25 * batch.time_step * (L - L.transpose()), I = Mat<3>::Identity();
  call.rotation =
      by_columns((I - half_spin).inverse() * (I + half_spin)); // Hughes and Winget's, as the stress is turned
  call.motion_after = by_columns(F);
  call.motion_before = by_columns((I + batch.time_step * L).inverse() * F);
  return point;
}

void Umat::give_back(const Point& point, const MaterialBatch& batch, Index p) const {
  const std::size_t own = shear_factors_.size();
  const auto stress = scaled(point.call.stress, 1.0 / stress_shear),
             strain = scaled(point.call.strain, 1.0 / strain_shear);
  for (std::size_t s = 0; s < own; ++s) batch.state[s][p] = point.state[s] / shear_factors_[s];
  for (std::size_t c = 0; c < 6; ++c) {
    batch.stress[c][p] = stress[c];
    batch.state[own + c][p] = strain[c];
  }
}

/// Takes the step whole, or in parts where the UMAT asks for that by PNEWDT < 1. @return why it failed; empty: it did
/// not
std::string_view Umat::advance(Point& point, const UmatLibrary::Lease& umat, MaterialReport& report) const {
  const Point start = point;
  const int states = static_cast<int>(shear_factors_.size());
  double done = 0.0, part = 1.0;
  for (int tries = 0; done < 1.0; ++tries) {
    if (tries == most_cuts) return "the UMAT goes on asking for shorter steps (PNEWDT)";
    Point trial = point;
    UmatCall& call = trial.call;
    call.state = trial.state.data();
    call.time_step = part * start.call.time_step;
    call.field_increment = part * start.call.field_increment;
    call.time_step_factor = 1.0;
    for (std::size_t c = 0; c < 6; ++c) call.strain_increment[c] = part * start.call.strain_increment[c];
    const UmatEnd end = umat.run(call, parameters_, states, cmname_);
    if (end == UmatEnd::xit) return "the UMAT called XIT";
    if (end == UmatEnd::threw) return "the UMAT threw an exception";
    if (call.time_step_factor < 1.0) {
      part *= std::max(call.time_step_factor, 0.01);
      ++report.rejected_substeps;
      continue;
    }
    if (!finite(call.stress)) return "the UMAT returned a stress that is not finite";
    for (std::size_t c = 0; c < 6; ++c) call.strain[c] += call.strain_increment[c];
    point = trial;
    for (double& t : point.call.time) t += call.time_step;
    done += part;
    if (part < 1.0) ++report.substeps;
    part = std::min(part, 1.0 - done);
    if (part < 1e-12) break;
  }
  return {};
}

void Umat::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  if (!library_) return report.fail(0, "no library is named (material.library)");
  try {
    const UmatLibrary::Lease umat = library_->lease();
    for (Index p = 0; p < batch.size; ++p) {
      Point point = point_of(batch, p);
      const std::int64_t before = report.substeps;
      const std::string_view failure = advance(point, umat, report);
      if (!failure.empty()) {
        report.fail(p, failure);
        continue;
      }
      report.substepped += report.substeps > before;
      give_back(point, batch, p);
    }
  } catch (const PluginError&) { report.fail(0, "the UMAT's library cannot be copied for another thread"); }
}

/// From DDSDDE of a call without strain.
Survey Umat::survey(const MaterialBatch& batch) const {
  if (!library_) return {};
  const UmatLibrary::Lease umat = library_->lease();
  double square_of_speed = 0.0;
  MaterialBatch idle = batch;
  idle.time_step = 0.0;
  for (Index p = 0; p < batch.size; ++p) {
    const double rho = void_ratio_ < 0 ? density_ : grain_density_ / (1.0 + batch.state[void_ratio_][p]);
    square_of_speed = std::max(square_of_speed, longitudinal(stiffness(umat, idle, p)) / rho);
  }
  return {.wave_speed = std::sqrt(square_of_speed)};
}

std::array<double, 36> Umat::stiffness(const MaterialBatch& batch, Index p) const {
  return stiffness(library_->lease(), batch, p);
}

std::array<double, 36> Umat::stiffness(const UmatLibrary::Lease& umat, const MaterialBatch& batch, Index p) const {
  Point point = point_of(batch, p);
  point.call.state = point.state.data();
  if (point.call.time_step == 0.0) point.call.time_step = 1.0; // many divide by it
  const UmatEnd end = umat.run(point.call, parameters_, static_cast<int>(shear_factors_.size()), cmname_);
  return end == UmatEnd::returned ? point.call.stiffness : std::array<double, 36>{};
}

} // namespace riedel
