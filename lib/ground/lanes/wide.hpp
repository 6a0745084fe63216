// Several numbers at once (SIMD), for kernels that are compiled for registers of several widths and give the same bits
// with each: every lane is computed by the IEEE operations of a scalar, in the order in which they are written. Words
// are the vector types of GCC and clang, with their operators. Further operations are in this file, by instructions of
// the target where the compiler's own code is worse. Everything here has internal linkage, so that kernels have their
// own copy for each target (target.hpp).
//
// As an example two doubles at a time, p[0] = 3 and p[1] = 4:
//   using L = Wide<double, 2>;
//   const L::Real a = L::load(p);                 3  4
//   const L::Real b = a * a + L::all(1.0);       10 17     two roundings in each lane, as of one number
//   const L::Mask large = b > L::all(12.0);       0 -1     all bits where it is true
//   L::any(large)                                true
//   L::store(q, b);                              q[0] = 10, q[1] = 17
// With n = 1 the same lines are the plain loop, for targets without registers of several numbers.
#pragma once

// Compilers take most of a second to read the header of all instructions, so that of SSE2 is used where it suffices.
#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <cstdint>
#include <cstring>

#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

// The numbers of doubles and of floats in a register of the target that is being compiled for.
#if defined(__AVX2__)
constexpr uint32_t register_lanes = 4;
#elif defined(__SSE2__) || defined(__aarch64__) || defined(__ALTIVEC__) || defined(__wasm_simd128__)
constexpr uint32_t register_lanes = 2;
#else
constexpr uint32_t register_lanes = 1;
#endif
constexpr uint32_t register_floats = register_lanes == 1 ? 1 : 2 * register_lanes;

// The integer types that are as wide as a number.
template <class T>
struct IntegersOf;
template <>
struct IntegersOf<float> {
  using Signed = int32_t;
  using Unsigned = uint32_t;
};
template <>
struct IntegersOf<double> {
  using Signed = int64_t;
  using Unsigned = uint64_t;
};

template <class T, uint32_t n>
struct Wide {
  static constexpr uint32_t lanes = n;
  using Signed = typename IntegersOf<T>::Signed;
  typedef T Real __attribute__((vector_size(n * sizeof(T))));
  typedef Signed Mask __attribute__((vector_size(n * sizeof(T))));  // -1 where true
  typedef typename IntegersOf<T>::Unsigned Bits __attribute__((vector_size(n * sizeof(T))));

  static Mask load_mask(const Signed *p) {
    Mask a;
    std::memcpy(&a, p, sizeof a);
    return a;
  }
  static Real all(T x) {
    if constexpr (n == 8) {
      return Real{x, x, x, x, x, x, x, x};
    } else if constexpr (n == 4) {
      return Real{x, x, x, x};
    } else if constexpr (n == 2) {
      return Real{x, x};
    } else {
      return Real{x};
    }
  }
  // 0, 1, 2 and so on.
  static Real ascending() {
    if constexpr (n == 8) {
      return Real{0, 1, 2, 3, 4, 5, 6, 7};
    } else if constexpr (n == 4) {
      return Real{0, 1, 2, 3};
    } else {
      return Real{0, 1};
    }
  }
  static Real of(T a, T b, T c, T d) { return Real{a, b, c, d}; }
  // p[index[0]], p[index[1]] and so on.
  static Real gather(const T *p, const uint32_t *index) {
    if constexpr (n == 8) {
      return Real{p[index[0]], p[index[1]], p[index[2]], p[index[3]],
                  p[index[4]], p[index[5]], p[index[6]], p[index[7]]};
    } else if constexpr (n == 4) {
      return Real{p[index[0]], p[index[1]], p[index[2]], p[index[3]]};
    } else if constexpr (n == 2) {
      return Real{p[index[0]], p[index[1]]};
    } else {
      return Real{p[index[0]]};
    }
  }

  // The bits of a number as a mask, and back.
  static Mask bits(const Real &a) { return reinterpret_cast<Mask>(a); }
  static Real number(const Mask &a) { return reinterpret_cast<Real>(a); }

  // a where the mask is set, else 0. both() is the same for masks: on targets without a blend instruction GCC splits a
  // plain & of two comparisons into single lanes.
  static Real kept(const Mask &mask, const Real &a) { return number(mask & bits(a)); }
  static Mask both(const Mask &a, const Mask &b) { return bits(kept(a, number(b))); }
  static Real select(const Mask &mask, const Real &a, const Real &b) { return mask ? a : b; }
  // a where the mask is set, else NaN.
  static Real valid(const Mask &mask, const Real &a) { return number(~mask | bits(a)); }
  // -a where the mask is set, else a.
  static Real negate_if(const Mask &mask, const Real &a) { return number(bits(a) ^ (mask & bits(all(-0.0)))); }
  // a >= +0 with the sign of b.
  static Real with_sign(const Real &a, const Real &b) { return negate_if(bits(b), a); }
  static Real absolute(const Real &a) { return number(bits(a) & ~bits(all(-0.0))); }

  // 1 where the highest bit is set, else 0.
  static Mask sign_bits(const Mask &a) {
    return reinterpret_cast<Mask>(reinterpret_cast<Bits>(a) >> (8 * sizeof(T) - 1));
  }

  static int64_t sum(const Mask &a) {
#if defined(__AVX2__)
    if constexpr (n == 8) {
      const __m256i fours = _mm256_add_epi32(__m256i(a), _mm256_permute4x64_epi64(__m256i(a), 0x4E));
      const __m256i twos = _mm256_add_epi32(fours, _mm256_shuffle_epi32(fours, 0x4E));
      return _mm256_cvtsi256_si32(_mm256_add_epi32(twos, _mm256_shuffle_epi32(twos, 0xB1)));
    }
#endif
    int64_t total = 0;
    for (uint32_t k = 0; k < n; ++k) total += a[k];
    return total;
  }
  static uint32_t count(const Mask &mask) {
    return static_cast<uint32_t>(-sum(mask));
  }

  // For eight floats GCC 12 copies halves unless these instructions are used.
  static Real load(const T *p) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_loadu_ps(p));
#endif
    Real a;
    std::memcpy(&a, p, sizeof a);
    return a;
  }
  // One number in all lanes. With all(), GCC 12 loads the number alone as well, to compute with it before it is spread.
  static Real all_of(const T *p) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_broadcast_ss(p));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_broadcast_sd(p));
#endif
    return all(*p);
  }
  // The first `count` numbers, and zeros behind them, for the end of an array.
  static Real load_first(const T *p, uint32_t count) {
#if defined(__AVX2__)
    if constexpr (n == 4 && sizeof(T) == 8) {
      const __m256i chosen = _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), _mm256_setr_epi64x(0, 1, 2, 3));
      return Real(_mm256_maskload_pd(p, chosen));
    }
#endif
    if (count >= n) return load(p);
    Real a{};
    for (uint32_t k = 0; k < count; ++k) a[k] = p[k];
    return a;
  }
  static void store(T *p, const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 8) {
      _mm256_storeu_ps(p, __m256(a));
      return;
    }
#endif
    std::memcpy(p, &a, sizeof a);
  }
  // As an instruction: with -a GCC 12 places the branches of find_few() so that 1.3 % more of Step 2 are mispredicted.
  static Real negated(const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_xor_ps(__m256(a), _mm256_set1_ps(-0.0F)));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_xor_pd(__m256d(a), _mm256_set1_pd(-0.0)));
#endif
    return -a;
  }
  static Real square_root(const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_sqrt_ps(__m256(a)));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_sqrt_pd(__m256d(a)));
#endif
#if defined(__SSE2__)
    if constexpr (n == 4 && sizeof(T) == 4) return Real(_mm_sqrt_ps(__m128(a)));
    if constexpr (n == 2 && sizeof(T) == 8) return Real(_mm_sqrt_pd(__m128d(a)));
#endif
    Real root = a;  // GCC -O1 does not see that every lane is written
    for (uint32_t k = 0; k < n; ++k) root[k] = std::sqrt(a[k]);
    return root;
  }
  // The larger and the smaller of two numbers; b if they are equal or one is NaN, as by the instructions of SSE2.
  static Real larger(const Real &a, const Real &b) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_max_ps(__m256(a), __m256(b)));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_max_pd(__m256d(a), __m256d(b)));
#endif
#if defined(__SSE2__)
    if constexpr (n == 4 && sizeof(T) == 4) return Real(_mm_max_ps(__m128(a), __m128(b)));
    if constexpr (n == 2 && sizeof(T) == 8) return Real(_mm_max_pd(__m128d(a), __m128d(b)));
#endif
    return select(a > b, a, b);
  }
  static Real smaller(const Real &a, const Real &b) {
#if defined(__AVX2__)
    if constexpr (n == 8) return Real(_mm256_min_ps(__m256(a), __m256(b)));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_min_pd(__m256d(a), __m256d(b)));
#endif
#if defined(__SSE2__)
    if constexpr (n == 4 && sizeof(T) == 4) return Real(_mm_min_ps(__m128(a), __m128(b)));
    if constexpr (n == 2 && sizeof(T) == 8) return Real(_mm_min_pd(__m128d(a), __m128d(b)));
#endif
    return select(a < b, a, b);
  }

  static T least(const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 8) {
      const __m256 fours = _mm256_min_ps(__m256(a), _mm256_permute2f128_ps(__m256(a), __m256(a), 1));
      const __m256 twos = _mm256_min_ps(fours, _mm256_permute_ps(fours, 0x4E));
      return _mm256_cvtss_f32(_mm256_min_ps(twos, _mm256_permute_ps(twos, 0xB1)));
    }
#endif
    T least = a[0];
    for (uint32_t k = 1; k < n; ++k) least = a[k] < least ? a[k] : least;
    return least;
  }

  // Truncated towards 0, for numbers below 2^63 in size.
  static Real truncated(const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 4 && sizeof(T) == 8) {
      return Real(_mm256_round_pd(__m256d(a), _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC));
    }
#endif
    Real whole = a;
    for (uint32_t k = 0; k < n; ++k) whole[k] = static_cast<T>(static_cast<int64_t>(a[k]));
    return whole;
  }
  // The same as integers, for numbers from 0 on and below 2^31.
  static void store_truncated(uint32_t *p, const Real &a) {
#if defined(__AVX2__)
    if constexpr (n == 4 && sizeof(T) == 8) {
      _mm_storeu_si128(reinterpret_cast<__m128i *>(p), _mm256_cvttpd_epi32(__m256d(a)));
      return;
    }
#endif
    for (uint32_t k = 0; k < n; ++k) p[k] = static_cast<uint32_t>(static_cast<int64_t>(a[k]));
  }
  static void store_as_floats(float *p, const Real &a) {
    Wide<float, n>::store(p, __builtin_convertvector(a, typename Wide<float, n>::Real));
  }

  // For each of four words, stores the sum of its four lanes, (0 + 1) + (2 + 3).
  static void store_sums_of_four(double *p, const Real &a, const Real &b, const Real &c, const Real &d) {
    static_assert(n == 4 && sizeof(T) == 8);
#if defined(__AVX2__)
    const __m256d ab = _mm256_hadd_pd(__m256d(a), __m256d(b)), cd = _mm256_hadd_pd(__m256d(c), __m256d(d));
    const __m256d low = _mm256_permute2f128_pd(ab, cd, 0x20), high = _mm256_permute2f128_pd(ab, cd, 0x31);
    _mm256_storeu_pd(p, _mm256_add_pd(low, high));
#else
    const Real *const words[4] = {&a, &b, &c, &d};
    for (uint32_t k = 0; k < 4; ++k) {
      const Real &word = *words[k];
      p[k] = (word[0] + word[1]) + (word[2] + word[3]);
    }
#endif
  }

  // Stores integers below 2^32.
  static void store_integers(uint32_t *p, const Mask &a) {
#if defined(__AVX2__)
    if constexpr (n == 4 && sizeof(T) == 8) {
      const __m256i front = _mm256_permutevar8x32_epi32(__m256i(a), _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7));
      _mm_storeu_si128(reinterpret_cast<__m128i *>(p), _mm256_castsi256_si128(front));
      return;
    }
#endif
    for (uint32_t k = 0; k < n; ++k) p[k] = static_cast<uint32_t>(a[k]);
  }
  // A bit for each lane, lane 0 lowest: whether the mask is set there.
  static uint64_t set_lanes(const Mask &mask) {
#if defined(__AVX2__)
    if constexpr (n == 8) return static_cast<uint64_t>(_mm256_movemask_ps(__m256(mask)));
    if constexpr (n == 4 && sizeof(T) == 8) return static_cast<uint64_t>(_mm256_movemask_pd(__m256d(mask)));
#endif
#if defined(__SSE2__)
    if constexpr (n == 4 && sizeof(T) == 4) return static_cast<uint64_t>(_mm_movemask_ps(__m128(mask)));
    if constexpr (n == 2 && sizeof(T) == 8) return static_cast<uint64_t>(_mm_movemask_pd(__m128d(mask)));
#endif
    if constexpr (n == 4 && sizeof(T) == 4) {
      const Mask own_bits = mask & Mask{1, 2, 4, 8};
      uint64_t halves[2];
      std::memcpy(halves, &own_bits, sizeof halves);
      const uint64_t all_bits = halves[0] | halves[1];
      return (all_bits | all_bits >> 32) & 15U;
    }
    uint64_t set = 0;
    for (uint32_t k = 0; k < n; ++k) set |= static_cast<uint64_t>(mask[k] & 1) << k;
    return set;
  }
  static bool any(const Mask &mask) {
#if defined(__AVX2__)
    if constexpr (n == 4 && sizeof(T) == 8) return _mm256_movemask_pd(__m256d(mask)) != 0;
#endif
    Signed found = 0;
    for (uint32_t k = 0; k < n; ++k) found |= mask[k];
    return found != 0;
  }

  // a b + c, rounded once if the target has an instruction for that, else twice: for decisions with error bounds, never
  // for results.
  static Real fused(const Real &a, const Real &b, const Real &c) {
#if defined(__FMA__)
    if constexpr (n == 8) return Real(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
    if constexpr (n == 4 && sizeof(T) == 8) return Real(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#endif
    return a * b + c;
  }
};

// Returns its argument, but hides from the compiler that it does. For loops over many arrays of one structure: their
// addresses are then computed from a single register. Else each array has an address of its own, most of them in
// memory.
template <class Arrays>
[[gnu::always_inline]] inline Arrays &by_one_register(Arrays &arrays) {
  Arrays *at = &arrays;
  __asm__("" : "+r"(at));
  return *at;
}

template <class Real>
struct VectorOf {
  Real x, y, z;

  friend VectorOf operator+(const VectorOf &a, const VectorOf &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend VectorOf operator-(const VectorOf &a, const VectorOf &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend VectorOf operator*(const Real &s, const VectorOf &a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Real dot(const VectorOf &a, const VectorOf &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend VectorOf cross(const VectorOf &a, const VectorOf &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

}  // namespace
}  // namespace hsp
