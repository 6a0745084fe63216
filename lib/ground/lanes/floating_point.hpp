// The floating-point environment on which every result relies: IEEE doubles, every operation rounded once. Every file
// that computes with doubles includes this header, so that a build that would break the promise of equal bits does not
// compile.
//
// A NaN in a lane says that nothing is certain there, and lanes behind the last item of a vector may hold anything:
// both raise floating-point exceptions. Entry points mask these and restore the caller's flags
// (capi/shims/core/library_arithmetic.hpp); nothing here reads flags.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

// g++ names each option of -ffast-math that is on, clang -ffinite-math-only alone.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "hardsphere must not be compiled with -ffast-math or parts of it: its results are defined by IEEE arithmetic"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "hardsphere needs doubles without excess precision (on i686: -msse2 -mfpmath=sse)"
#endif
// g++ fuses operations where it can, and no macro shows options that forbid it. So library.cmake, and the core as one
// file, define HSP_NO_CONTRACTION with these options.
#if !defined(HSP_NO_CONTRACTION) && (defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(__FP_FAST_FMA))
#error "hardsphere needs -ffp-contract=off, and with g++ -fno-tree-vectorize: say so by -DHSP_NO_CONTRACTION"
#endif
static_assert(0.1 != static_cast<float>(0.1), "hardsphere must not be compiled with -fsingle-precision-constant");
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

namespace hsp {

// Half an ulp of 1: the largest relative error of one rounding.
inline constexpr double unit_roundoff = 0x1p-53;

inline constexpr double pi = 0x1.921fb54442d18p+1;
inline constexpr double pi_low = 0x1.1a62633145c07p-53;  // the rest of pi

// True for everything but NaN and infinities; plain comparison, so that no library call is needed.
inline bool is_finite(double x) {
  return x - x == 0.0;
}

}  // namespace hsp
