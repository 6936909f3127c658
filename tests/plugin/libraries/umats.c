/* UMATs in C, by KIND: ends by XIT, never content with the step, returns NaN, sums the strain up in its state, or elastic
   with steps of at most 1e-5. */
#include <math.h>

extern void xit_(void);

void umat_(double *stress, double *statev, double *ddsdde, double *sse, double *spd, double *scd, double *rpl,
           double *ddsddt, double *drplde, double *drpldt, const double *stran, const double *dstran,
           const double *time, const double *dtime, const double *temp, const double *dtemp, const double *predef,
           const double *dpred, const char *cmname, const int *ndi, const int *nshr, const int *ntens,
           const int *nstatv, const double *props, const int *nprops, const double *coords, const double *drot,
           double *pnewdt, const double *celent, const double *dfgrd0, const double *dfgrd1, const int *noel) {
  const double E = 1e7;
  double largest = 0.0;
  for (int i = 0; i < 36; ++i) ddsdde[i] = i % 7 == 0 ? (i < 21 ? E : E / 2) : 0.0;
  for (int i = 0; i < 6; ++i) largest = fmax(largest, fabs(dstran[i]));
  if (largest > 0.0) {
#if KIND == 1
    xit_();
#elif KIND == 2
    *pnewdt = 0.5;
#elif KIND == 3
    stress[0] = NAN;
#elif KIND == 4
    for (int i = 0; i < 6; ++i) {
      stress[i] += (i < 3 ? E : E / 2) * 100 * statev[i] * (dstran[0] + dstran[1] + dstran[2]);
      statev[i] += dstran[i];
    }
#else
    if (largest > 1e-5) {
      *pnewdt = 0.25;
      stress[0] = -1e9; /* what it leaves behind must not count */
      return;
    }
#endif
  }
  for (int i = 0; i < 6; ++i) stress[i] += (i < 3 ? E : E / 2) * dstran[i];
}
