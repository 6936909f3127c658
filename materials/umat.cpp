#include "materials/umat.hpp"

#include "core/base/error.hpp"

#include <cmath>

namespace riedel {

namespace {

constexpr int max_cuts = 1000; ///< maximum number of parts of one step, and of its divisions

/// Largest of nine longitudinal stiffnesses n n : C : n n, along axes and the diagonals between two of them [Pa]; NaN
/// if one of the entries is NaN.
double longitudinal(const std::array<double, 36>& stiffness) {
  const auto C = [&](int i, int j) { return 0.5 * (stiffness[j * 6 + i] + stiffness[i * 6 + j]); };
  double maximum = 0.0;
  for (int i = 0; i < 3; ++i) maximum = std::max(maximum, C(i, i));
  for (int k = 3; k < 6; ++k) { // 12, 13, 23
    const int i = k == 5 ? 1 : 0, j = k == 3 ? 1 : 2;
    const double normal = 0.25 * (C(i, i) + C(j, j)) + 0.5 * C(i, j) + C(k, k), mixed = C(i, k) + C(j, k);
    maximum = std::max(maximum, normal + std::abs(mixed));
  }
  for (const double entry : stiffness)
    if (!std::isfinite(entry)) return std::nan("");
  return maximum;
}

/// Why a point fails with this result; empty: it does not fail.
std::string_view complaint(UmatEnd end, const UmatPoint& answer) {
  if (end == UmatEnd::xit) return "the UMAT called XIT";
  if (end == UmatEnd::threw) return "the UMAT threw an exception";
  const auto finite = [](double x) { return std::isfinite(x); };
  if (answer.call.time_step_factor < 1.0) return {};
  if (!std::ranges::all_of(answer.call.stress, finite)) return "the UMAT returned a stress that is not finite";
  if (!std::all_of(answer.state.begin(), answer.state.begin() + static_cast<std::ptrdiff_t>(answer.states), finite))
    return "the UMAT returned a state (STATEV) that is not finite";
  return {};
}

double pascals(const std::string& unit) { return unit == "kPa" ? 1e3 : unit == "MPa" ? 1e6 : 1.0; }

} // namespace

Keys Umat::parameters() {
  const Bounds any{};
  const std::vector<double> none;
  return {{"library", std::string(), "", any, "shared library with the UMAT"},
          {"symbol", std::string("umat_"), "", any, "its name in the library; gfortran and ifx name UMAT umat_"},
          {"name", std::string("MATERIAL"), "", any, "CMNAME"},
          {"parameters", none, "-", any, "PROPS, in the UMAT's units", {}, true},
          {"stress_unit",
           std::string("Pa"),
           "",
           any,
           "the UMAT's unit of stress: of STRESS, DDSDDE, and the states with :stress",
           {"Pa", "kPa", "MPa"}},
          {"state", none, "-", any, "STATEV at the start, in the UMAT's units", {}, true},
          {"state_names", std::string(), "", any,
           "names of STATEV in order, such as \"void_ratio, h:strain, flag\": void_ratio takes the specimen's; :stress "
           "and :strain stand for six numbers that rotate with the material, the latter with engineering shear"},
          {"thread_safe", false, "", any, "whether threads may share the library; otherwise each has a copy"},
          {"takes_average", false, "", any, "pass ‖D‖ Δt, or its non-local average, in DPRED(1)"},
          {"density", 2000.0, "kg/m3", more_than(0), "bulk density, for a UMAT without a void_ratio"},
          {"grain_density", 2650.0, "kg/m3", more_than(0), "density of the grains, for a UMAT with a void_ratio"},
          {"length", 1.0, "m", more_than(0), "CELENT"}};
}

Umat::Umat(const Values& given)
    : cmname_(given.text("name")),
      parameters_(given.numbers("parameters")),
      takes_average_(given.flag("takes_average")),
      stress_unit_(pascals(given.text("stress_unit"))),
      density_(given.number("density")),
      grain_density_(given.number("grain_density")),
      length_(given.number("length")),
      states_(given.text("state_names"), given.numbers("state"), stress_unit_) {
  check_bounds(parameters(), given, name);
  if (const std::string& path = given.text("library"); !path.empty())
    library_ = std::make_unique<UmatLibrary>(path, given.text("symbol"), given.flag("thread_safe"));
}

std::vector<std::string> Umat::nonlocal_variables() const {
  if (takes_average_) return {"rate_norm"};
  return {};
}

double Umat::density(std::span<const double> state) const {
  const int e = states_.void_ratio();
  return e < 0 ? density_ : grain_density_ / (1.0 + state[static_cast<std::size_t>(e)]);
}

UmatPoint Umat::point_of(const MaterialBatch& batch, Index p) const {
  UmatPoint point = umat_point(batch, p, states_, stress_unit_);
  if (!takes_average_) point.call.field_increment = 0.0;
  point.call.length = length_;
  return point;
}

UmatEnd Umat::call(UmatPoint& point, const UmatLibrary::Lease& umat) const {
  point.call.state = point.state.data();
  const UmatOutcome outcome = umat.run(point.call, parameters_, static_cast<int>(point.states), cmname_);
  if (outcome.end != UmatEnd::ended && outcome.end != UmatEnd::crashed) return outcome.end;
  throw RunError(library_->account_of(outcome) + " at point " + std::to_string(point.call.point - 1) + ", time " +
                 exact_text(point.call.time[1]) + " s");
}

/// Takes the step whole, or in parts if the UMAT requests that by PNEWDT < 1. @return why it failed; empty: it did not
std::string_view Umat::advance(UmatPoint& point, const UmatLibrary::Lease& umat, MaterialReport& report) const {
  UmatPoint answer = point;
  const UmatEnd end = call(answer, umat);
  const std::string_view failure = complaint(end, answer);
  if (!failure.empty()) return failure;
  if (answer.call.time_step_factor < 1.0) {
    ++report.rejected_substeps;
    return advance_in_parts(point, std::max(answer.call.time_step_factor, 0.01), umat, report);
  }
  for (std::size_t c = 0; c < 6; ++c) answer.call.strain[c] += answer.call.strain_increment[c];
  point = answer;
  return {};
}

std::string_view Umat::advance_in_parts(UmatPoint& point, double share, const UmatLibrary::Lease& umat,
                                        MaterialReport& report) const {
  UmatParts parts(point, states_);
  for (int tries = 0; parts.done() < 1.0 - 1e-12; ++tries) {
    if (tries == max_cuts) return "the UMAT keeps asking for shorter steps (PNEWDT)";
    UmatPoint part = parts.next(share);
    const std::array<double, 6> increment = part.call.strain_increment;
    const UmatEnd end = call(part, umat);
    const std::string_view failure = complaint(end, part);
    if (!failure.empty()) return failure;
    if (part.call.time_step_factor < 1.0) {
      share *= std::max(part.call.time_step_factor, 0.01);
      ++report.rejected_substeps;
      continue;
    }
    for (std::size_t c = 0; c < 6; ++c) part.call.strain[c] += increment[c];
    parts.keep(part, share);
    ++report.substeps;
    share = std::min(share, 1.0 - parts.done());
  }
  ++report.substepped;
  point = parts.point();
  return {};
}

void Umat::integrate(const MaterialBatch& batch, MaterialReport& report) const {
  if (!library_) return report.fail(0, "no library is named (material.library)");
  const UmatLibrary::Lease umat = library_->lease();
  for (Index p = 0; p < batch.size; ++p) {
    UmatPoint point = point_of(batch, p);
    const std::string_view failure = advance(point, umat, report);
    if (failure.empty())
      give_back(point, batch, p, states_, stress_unit_);
    else
      report.fail(p, failure);
  }
}

MaterialLimits Umat::assess(const MaterialBatch& batch) const {
  if (!library_) return {};
  const UmatLibrary::Lease umat = library_->lease();
  const int e = states_.void_ratio();
  double square_of_speed = 0.0;
  MaterialBatch idle = batch;
  idle.time_step = 0.0;
  for (Index p = 0; p < batch.size; ++p) {
    const double rho = e < 0 ? density_ : grain_density_ / (1.0 + batch.state[static_cast<std::size_t>(e)][p]);
    const double squared = longitudinal(stiffness(umat, idle, p)) / rho;
    if (!std::isfinite(squared)) throw RunError("the UMAT returned a DDSDDE that is not finite");
    square_of_speed = std::max(square_of_speed, squared);
  }
  return {.wave_speed = std::sqrt(square_of_speed)};
}

std::array<double, 36> Umat::stiffness(const MaterialBatch& batch, Index p) const {
  return stiffness(library_->lease(), batch, p);
}

std::array<double, 36> Umat::stiffness(const UmatLibrary::Lease& umat, const MaterialBatch& batch, Index p) const {
  UmatPoint point = point_of(batch, p);
  if (point.call.time_step == 0.0) { // many UMATs divide by it
    point.call.time_step = 1.0;
    point.call.strain_increment.fill(0.0);
  }
  if (const UmatEnd end = call(point, umat); end != UmatEnd::returned)
    throw RunError(std::string(complaint(end, point)) + " in a call without strain");
  for (double& entry : point.call.stiffness) entry *= stress_unit_;
  return point.call.stiffness;
}

} // namespace riedel
