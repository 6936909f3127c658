/* UMATs that end badly once strain has gone on for PROPS(1) seconds, by the first letters of CMNAME: they are elastic
   before. */
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static volatile double sink;

static double overflow(int depth) {
  volatile char room[4096];
  room[0] = (char)depth;
  return depth < 0 ? 0.0 : overflow(depth + 1) + room[0];
}

void umat_(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
           double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran,
           const double* time, const double* dtime, const double* temp, const double* dtemp, const double* predef,
           const double* dpred, const char* cmname, const int* ndi, const int* nshr, const int* ntens,
           const int* nstatv, const double* props, const int* nprops) {
  const double E = 1e7;
  const int stiff = strncmp(cmname, "LIMP", 4) != 0;
  double strained = 0.0;
  for (int i = 0; i < 36; ++i) ddsdde[i] = i % 7 == 0 && stiff ? (i < 21 ? E : E / 2) : 0.0;
  for (int i = 0; i < 6; ++i) strained += fabs(dstran[i]);
  if (strncmp(cmname, "BAD STIFFNESS", 13) == 0) ddsdde[0] = NAN;
  if (strained > 0.0 && *nprops > 0 && time[1] >= props[0]) {
    if (strncmp(cmname, "STOP", 4) == 0) exit(0);
    if (strncmp(cmname, "LEAVE", 5) == 0) _exit(0);
    if (strncmp(cmname, "ABORT", 5) == 0) abort();
    if (strncmp(cmname, "SEGV", 4) == 0) *(volatile int*)8 = 1;
    if (strncmp(cmname, "DIVIDE", 6) == 0) raise(SIGFPE);
    if (strncmp(cmname, "STACK", 5) == 0) sink = overflow(0);
    if (strncmp(cmname, "LOOP", 4) == 0)
      for (;;) sink += 1.0;
    if (strncmp(cmname, "NOTHING", 7) == 0) return;
    if (strncmp(cmname, "NAN STATE", 9) == 0) statev[0] = NAN;
    if (strncmp(cmname, "INFINITE", 8) == 0) stress[1] = INFINITY;
    if (strncmp(cmname, "COUNTER", 7) == 0) statev[0] = 1e6 * dstran[0] + 1e5 * time[1]; /* of no frame */
  }
  for (int i = 0; i < 6; ++i) stress[i] += (i < 3 ? E : E / 2) * dstran[i];
}
