/* What a plug-in of another kind exports, by KIND: no object of ours, another interface, another version. */
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>

struct stamp {
  char magic[12];
  uint32_t abi;
  const char *version, *compiler;
  uint32_t sizes;
  void (*enlist)(void*);
};

#if KIND == 1 /* another interface */
const struct stamp riedel_plugin = {"riedel plug", 4711, "0.2.0", "12", 0, 0};
#elif KIND == 2 /* another version */
const struct stamp riedel_plugin = {"riedel plug", 3, "99.1.0", "12", 0, 0};
#elif KIND == 3 /* another compiler */
const struct stamp riedel_plugin = {"riedel plug", 3, RIEDEL_VERSION, "3.4", 1, 0};
#elif KIND == 4 /* something else under that name */
const struct stamp riedel_plugin = {"other thing", 3, RIEDEL_VERSION, "12", 0, 0};
#elif KIND == 5 /* a symbol that does not exist */
extern void nobody_has_this(void);
void call_it(void) { nobody_has_this(); }
#elif KIND == 6 /* crashes while it is loaded */
__attribute__((constructor)) static void crash(void) { raise(SIGSEGV); }
#elif KIND == 7 /* does not return */
__attribute__((constructor)) static void loop(void) {
  for (volatile double x = 0.0;;) x += 1.0;
}
#elif KIND == 8 /* ends the program */
__attribute__((constructor)) static void leave(void) { exit(0); }
#elif KIND == 9 /* the interface of the version before */
const struct stamp riedel_plugin = {"riedel plug", 2, RIEDEL_VERSION, "12", 0, 0};
#else           /* a library that is not a plug-in */
int nothing = 0;
#endif
