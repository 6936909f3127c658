/// Utility routines that Abaqus offers to subroutines: XIT, ROTSIG, SINV, SPRINC, SPRIND, STDB_ABQERR, under their
/// Fortran names. They are exported, so that a UMAT finds them.
#pragma once

extern "C" {
void xit_();
/// R s Rᵀ of 11, 22, 33, 12, 13, 23. @param R by columns   @param kind 1: stress, 2: strain   @param ndi, nshr 3, 3
void rotsig_(const double* s, const double* R, double* rotated, const int* kind, const int* ndi, const int* nshr);
}
