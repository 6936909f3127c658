#include "materials/umat/services.hpp"

#include "materials/umat/guard.hpp"

#include <Eigen/Dense>
#include <cstdio>
#include <cstdlib>

namespace riedel {

namespace {

/// A tensor from its components 11, 22, 33, 12, 13, 23; strains have twice the shear.
Eigen::Matrix3d tensor(const double* s, int kind, int ndi, int nshr) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  for (int i = 0; i < ndi; ++i) a(i, i) = s[i];
  const double share = kind == 2 ? 0.5 : 1.0;
  const int row[] = {0, 0, 1}, column[] = {1, 2, 2};
  for (int k = 0; k < nshr; ++k) a(row[k], column[k]) = a(column[k], row[k]) = share * s[ndi + k];
  return a;
}

void put(const Eigen::Matrix3d& a, double* s, int kind, int ndi, int nshr) {
  for (int i = 0; i < ndi; ++i) s[i] = a(i, i);
  const double factor = kind == 2 ? 2.0 : 1.0;
  const int row[] = {0, 0, 1}, column[] = {1, 2, 2};
  for (int k = 0; k < nshr; ++k) s[ndi + k] = factor * a(row[k], column[k]);
}

} // namespace
} // namespace riedel

extern "C" {

/// Ends the call; the point fails, the program continues.
void xit_() {
  riedel::leave_umat(riedel::UmatEnd::xit, 0);
  std::abort();
}

void rotsig_(const double* s, const double* R, double* rotated, const int* kind, const int* ndi, const int* nshr) {
  const Eigen::Map<const Eigen::Matrix3d> Q(R);
  riedel::put(Q * riedel::tensor(s, *kind, *ndi, *nshr) * Q.transpose(), rotated, *kind, *ndi, *nshr);
}

/// Mean of the normal components and von Mises' equivalent stress.
void sinv_(const double* s, double* mean, double* mises, const int* ndi, const int* nshr) {
  const Eigen::Matrix3d a = riedel::tensor(s, 1, *ndi, *nshr);
  *mean = a.trace() / 3.0;
  *mises = std::sqrt(1.5) * (a - *mean * Eigen::Matrix3d::Identity()).norm();
}

/// Principal values, ascending. @param kind 1: stress, 2: strain
void sprinc_(const double* s, double* principal, const int* kind, const int* ndi, const int* nshr) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(riedel::tensor(s, *kind, *ndi, *nshr));
  Eigen::Map<Eigen::Vector3d>{principal} = solver.eigenvalues();
}

/// The same with directions: AN(k, i) is component i of direction k.
void sprind_(const double* s, double* principal, double* directions, const int* kind, const int* ndi, const int* nshr) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(riedel::tensor(s, *kind, *ndi, *nshr));
  Eigen::Map<Eigen::Vector3d>{principal} = solver.eigenvalues();
  Eigen::Map<Eigen::Matrix3d>{directions} = solver.eigenvectors().transpose();
}

/// Messages: their text goes to the error output unchanged; a severe one (−3) ends the call.
void stdb_abqerr_(const int* grade, const char* text, const int*, const double*, const char*, std::size_t length) {
  std::fprintf(stderr, "UMAT: %.*s\n", static_cast<int>(length), text);
  if (*grade <= -3) xit_();
}

} // extern "C"
