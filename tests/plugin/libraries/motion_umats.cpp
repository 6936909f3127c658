/// UMATs in C++ that use a driver's motion and time, by CMNAME. AUDIT is elastic and keeps its own record, with which
/// it compares every call: it reports any mismatch, and calls XIT.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

extern "C" {
[[noreturn]] void xit_();
void rotsig_(const double* s, const double* R, double* turned, const int* kind, const int* ndi, const int* nshr);
}

namespace {

using Six = std::array<double, 6>;

struct Call {
  double *stress, *statev, *ddsdde;
  const double *stran, *dstran, *time, *props;
  double dtime, temp, dtemp, predef, celent;
  const double *coords, *drot, *dfgrd0, *dfgrd1;
  double* pnewdt;
  int ndi, nshr, ntens, nstatv, noel, npt, layer, kspt, kstep, kinc;
};

/// Matrices by columns.
double at(const double* a, int i, int j) { return a[j * 3 + i]; }

double determinant(const double* a) {
  return at(a, 0, 0) * (at(a, 1, 1) * at(a, 2, 2) - at(a, 1, 2) * at(a, 2, 1)) -
         at(a, 0, 1) * (at(a, 1, 0) * at(a, 2, 2) - at(a, 1, 2) * at(a, 2, 0)) +
         at(a, 0, 2) * (at(a, 1, 0) * at(a, 2, 1) - at(a, 1, 1) * at(a, 2, 0));
}

std::array<double, 9> inverse(const double* a) {
  std::array<double, 9> b{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
      b[static_cast<std::size_t>(i * 3 + j)] = (at(a, k, m) * at(a, l, n) - at(a, k, n) * at(a, l, m)) / determinant(a);
    }
  return b;
}

void elastic_stiffness(double* C, double E, double nu) {
  const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) C[j * 6 + i] = (i < 3 && j < 3 ? lambda : 0) + (i == j ? (i < 3 ? 2 * mu : mu) : 0);
}

/// PROPS: E, ν, E growing with `factor`.
void hooke(const Call& c, double factor) {
  elastic_stiffness(c.ddsdde, factor * c.props[0], c.props[1]);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) c.stress[i] += c.ddsdde[j * 6 + i] * c.dstran[j];
}

/// PROPS: μ, κ. σ = μ J^(−5/3) dev b + κ (J − 1) I, from F at the end of the step alone.
void neo_hooke(const Call& c) {
  const double mu = c.props[0], kappa = c.props[1], J = determinant(c.dfgrd1);
  const int row[] = {0, 1, 2, 0, 0, 1}, column[] = {0, 1, 2, 1, 2, 2};
  Six b{};
  for (int k = 0; k < 6; ++k)
    for (int m = 0; m < 3; ++m) b[static_cast<std::size_t>(k)] += at(c.dfgrd1, row[k], m) * at(c.dfgrd1, column[k], m);
  const double mean = (b[0] + b[1] + b[2]) / 3;
  for (std::size_t k = 0; k < 6; ++k)
    c.stress[k] = mu * std::pow(J, -5.0 / 3.0) * (b[k] - (k < 3 ? mean : 0)) + (k < 3 ? kappa * (J - 1) : 0);
  elastic_stiffness(c.ddsdde, 9 * kappa * mu / (3 * kappa + mu), (3 * kappa - 2 * mu) / (2 * (3 * kappa + mu)));
}

/// STATEV of AUDIT: the stress, declared as a tensor; the stress and the strain, rotated by ROTSIG; F, time, KINC,
/// KSTEP, NOEL and number of calls at the end of the last step.
enum Record { declared = 0, own_stress = 6, own_strain = 12, gradient = 18, end = 27, increment, stage, point, calls };

void demand(bool fits, const char* what, double found, double wanted) {
  if (fits) return;
  std::fprintf(stderr, "audit: %s is %.17g, not %.17g\n", what, found, wanted);
  xit_();
}
void demand_equal(const char* what, double found, double wanted, double size) {
  demand(std::abs(found - wanted) <= 1e-10 * size, what, found, wanted);
}

double largest(const double* a, int count) {
  double maximum = 0.0;
  for (int i = 0; i < count; ++i) maximum = std::max(maximum, std::abs(a[i]));
  return maximum;
}

Six turned(const double* a, const Call& c, int kind) {
  Six b{};
  rotsig_(a, c.drot, b.data(), &kind, &c.ndi, &c.nshr);
  return b;
}

void audit_what_never_changes(const Call& c) {
  demand_equal("NDI", c.ndi, 3, 1);
  demand_equal("NSHR", c.nshr, 3, 1);
  demand_equal("NTENS", c.ntens, 6, 1);
  demand_equal("TEMP, DTEMP, PREDEF", std::abs(c.temp) + std::abs(c.dtemp) + std::abs(c.predef), 0, 1);
  demand_equal("COORDS", largest(c.coords, 3), 0, 1);
  demand_equal("CELENT", c.celent, 1, 1);
  for (const int one : {c.npt, c.layer, c.kspt}) demand_equal("NPT, LAYER, KSPT", one, 1, 1);
  demand(c.noel >= 1, "NOEL", c.noel, 1);
}

/// The data of a step are consistent. PROPS(3) = 1: the rotation follows the spin.
void audit_motion(const Call& c) {
  const std::array<double, 9> back = inverse(c.dfgrd0);
  double H[3][3], size = 0.0; // ΔF − I
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      H[i][j] = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) H[i][j] += at(c.dfgrd1, i, k) * at(back.data(), k, j);
      size += H[i][j] * H[i][j];
    }
  // A part of a step has its share of the second-order error of the whole step.
  const double second_order = 4 * size + 1e-12 + (c.props[3] > 0 ? 0.01 * std::sqrt(size) : 0);
  const int row[] = {0, 1, 2, 0, 0, 1}, column[] = {0, 1, 2, 1, 2, 2};
  for (int k = 0; k < 6; ++k) {
    const double strain = (k < 3 ? 0.5 : 1) * (H[row[k]][column[k]] + H[column[k]][row[k]]);
    demand(std::abs(c.dstran[k] - strain) <= second_order, "DSTRAN", c.dstran[k], strain);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double product = 0.0;
      for (int k = 0; k < 3; ++k) product += at(c.drot, i, k) * at(c.drot, j, k);
      demand_equal("DROT DROT^T", product, i == j, 1);
      const double spin = 0.5 * (H[i][j] - H[j][i]), found = 0.5 * (at(c.drot, i, j) - at(c.drot, j, i));
      if (c.props[2] == 1) demand(std::abs(found - spin) <= second_order, "DROT's spin", found, spin);
    }
}

/// A step begins where the last one ended.
void audit_record(const Call& c) {
  const double* const s = c.statev;
  if (s[calls] == 0) {
    for (int k = 0; k < 9; ++k) demand_equal("DFGRD0 at the start", c.dfgrd0[k], k % 4 == 0, 1);
    demand_equal("KINC at the start", c.kinc, 1, 1);
    demand_equal("TIME(2) at the start", c.time[1], 0, 1);
    return;
  }
  const double size = largest(c.stress, 6) + 1;
  const Six stress = turned(s + own_stress, c, 1), strain = turned(s + own_strain, c, 2);
  for (int k = 0; k < 6; ++k) {
    const auto n = static_cast<std::size_t>(k);
    demand_equal("a declared tensor", s[declared + k], c.stress[k], size);
    demand_equal("STRESS turned by DROT", stress[n], c.stress[k], size);
    demand_equal("STRAN turned by DROT", strain[n], c.stran[k], 1);
  }
  for (int k = 0; k < 9; ++k) demand_equal("DFGRD0", c.dfgrd0[k], s[gradient + k], 1);
  demand_equal("TIME(2)", c.time[1], s[end], s[end]);
  demand_equal("NOEL", c.noel, s[point], 1);
  const bool next_stage = c.kstep == s[stage] + 1, same_stage = c.kstep == s[stage];
  demand(next_stage || same_stage, "KSTEP", c.kstep, s[stage]);
  if (next_stage) demand_equal("TIME(1) of a new stage", c.time[0], 0, 1);
  // Parts of a step that was too long, PROPS(4), share a number.
  const bool counts =
      next_stage ? c.kinc == 1 : c.kinc == s[increment] + 1 || (c.props[3] > 0 && c.kinc == s[increment]);
  demand(counts, "KINC", c.kinc, s[increment] + 1);
}

void keep_record(const Call& c) {
  double* const s = c.statev;
  const Six strain = turned(s + own_strain, c, 2);
  for (int k = 0; k < 6; ++k) {
    s[declared + k] = s[own_stress + k] = c.stress[k];
    s[own_strain + k] = strain[static_cast<std::size_t>(k)] + c.dstran[k];
  }
  std::copy_n(c.dfgrd1, 9, s + gradient);
  s[end] = c.time[1] + c.dtime;
  s[increment] = c.kinc;
  s[stage] = c.kstep;
  s[point] = c.noel;
  ++s[calls];
}

/// PROPS: E, ν, whether the rotation follows the spin, longest increment of strain (0: any).
void audit(const Call& c) {
  audit_what_never_changes(c);
  audit_motion(c);
  audit_record(c);
  if (c.props[3] > 0 && largest(c.dstran, 6) > c.props[3]) {
    *c.pnewdt = 0.4;
    return;
  }
  hooke(c, 1);
  keep_record(c);
}

} // namespace

extern "C" void umat_(double* stress, double* statev, double* ddsdde, double*, double*, double*, double*, double*,
                      double*, double*, const double* stran, const double* dstran, const double* time,
                      const double* dtime, const double* temp, const double* dtemp, const double* predef, const double*,
                      const char* cmname, const int* ndi, const int* nshr, const int* ntens, const int* nstatv,
                      const double* props, const int*, const double* coords, const double* drot, double* pnewdt,
                      const double* celent, const double* dfgrd0, const double* dfgrd1, const int* noel, const int* npt,
                      const int* layer, const int* kspt, const int* kstep, const int* kinc, std::size_t length) {
  const Call call{stress, statev,  ddsdde,  stran,  dstran, time,   props,  *dtime, *temp,
                  *dtemp, *predef, *celent, coords, drot,   dfgrd0, dfgrd1, pnewdt, *ndi,
                  *nshr,  *ntens,  *nstatv, *noel,  *npt,   *layer, *kspt,  *kstep, *kinc};
  std::string_view name(cmname, length);
  name = name.substr(0, name.find_last_not_of(' ') + 1);
  if (name == "NEO_HOOKE") return neo_hooke(call);
  if (name == "AGEING") return hooke(call, 1 + time[1]);
  if (name == "AGEING_BY_STAGE") return hooke(call, 1 + time[0]);
  if (name == "AUDIT") return audit(call);
  std::fprintf(stderr, "no such law: %.*s\n", static_cast<int>(name.size()), name.data());
  xit_();
}
