#if !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* feenableexcept */
#endif
#include "host_environment.h"

#include <fenv.h>
#include <stdint.h>

/* The bits that make the processor flush, and the register that has them. */
#if defined(__SSE2__)
enum { FLUSH = 0x8040 };
static uint32_t control(void) {
  uint32_t word;
  __asm__ volatile("stmxcsr %0" : "=m"(word));
  return word;
}
static void set_control(uint32_t word) {
  __asm__ volatile("ldmxcsr %0" : : "m"(word));
}
#elif defined(__aarch64__)
enum { FLUSH = 1 << 24 };
static uint64_t control(void) {
  uint64_t word;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word));
  return word;
}
static void set_control(uint64_t word) {
  __asm__ volatile("msr fpcr, %0" : : "r"(word));
}
#elif defined(__arm__) && defined(__ARM_FP)
enum { FLUSH = 1 << 24 };
static uint32_t control(void) {
  uint32_t word;
  __asm__ volatile("vmrs %0, fpscr" : "=r"(word));
  return word;
}
static void set_control(uint32_t word) {
  __asm__ volatile("vmsr fpscr, %0" : : "r"(word));
}
#elif defined(__mips_hard_float)
enum { FLUSH = 1 << 24 };
static uint32_t control(void) {
  uint32_t word;
  __asm__ volatile("cfc1 %0, $31" : "=r"(word));
  return word;
}
static void set_control(uint32_t word) {
  __asm__ volatile("ctc1 %0, $31" : : "r"(word));
}
#else
enum { FLUSH = 0 };
static uint32_t control(void) {
  return 0;
}
static void set_control(uint32_t word) {
  (void)word;
}
#endif

#if defined(__GLIBC__)
#define HAS_TRAPS 1
#else
#define HAS_TRAPS 0
#endif

static int mode_of(int which) {
  switch (which) {
#if defined(FE_UPWARD)
    case HOST_upward:
      return FE_UPWARD;
#endif
#if defined(FE_DOWNWARD)
    case HOST_downward:
      return FE_DOWNWARD;
#endif
#if defined(FE_TOWARDZERO)
    case HOST_to_zero:
      return FE_TOWARDZERO;
#endif
    default:
      return FE_TONEAREST;
  }
}

const char *host_environment_name(int which) {
  static const char *const name[HOST_ENVIRONMENTS] = {"default", "flushing", "traps", "upward", "downward", "to_zero"};
  return name[which];
}

static int flushes(void) {
  return FLUSH != 0 && (control() & FLUSH) == FLUSH;
}

static int traps(void) {
#if HAS_TRAPS
  return fegetexcept() == FE_ALL_EXCEPT;
#else
  return 0;
#endif
}

static int traps_something(void) {
#if HAS_TRAPS
  return fegetexcept() != 0;
#else
  return 0;
#endif
}

void host_environment_set(int which, int flag) {
  fesetenv(FE_DFL_ENV);
  feclearexcept(FE_ALL_EXCEPT);
#if defined(FE_OVERFLOW)
  if (flag && which != HOST_traps) {
    fexcept_t overflow = 0;
    feraiseexcept(FE_OVERFLOW);
    fegetexceptflag(&overflow, FE_OVERFLOW);
    feclearexcept(FE_ALL_EXCEPT);
    fesetexceptflag(&overflow, FE_OVERFLOW);
  }
#endif
  if (mode_of(which) != FE_TONEAREST) fesetround(mode_of(which));
  if (which == HOST_flushing) set_control(control() | FLUSH);
#if HAS_TRAPS
  if (which == HOST_traps) feenableexcept(FE_ALL_EXCEPT);
#endif
}

const char *host_environment_differs(int which, int flag) {
  const int raised = fetestexcept(FE_ALL_EXCEPT);
#if defined(FE_OVERFLOW)
  const int expected = flag && which != HOST_traps ? FE_OVERFLOW : 0;
#else
  const int expected = 0;
  (void)flag;
#endif
  if (raised != expected) return "the exception flags";
  if (fegetround() != mode_of(which)) return "the rounding mode";
  if (flushes() != (which == HOST_flushing)) return "what becomes of subnormal numbers";
  return (which == HOST_traps ? !traps() : traps_something()) ? "the traps" : 0;
}

int host_environment_exists(int which) {
  fenv_t own;
  int exists;
  if (fegetenv(&own) != 0) return which == HOST_default;
  host_environment_set(which, 0);
  exists = which == HOST_flushing ? flushes() : which == HOST_traps ? traps() : mode_of(which) != FE_TONEAREST;
  fesetenv(&own);
  return exists || which == HOST_default;
}
