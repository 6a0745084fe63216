#include "words_checks.hpp"

#if HSP_LANES
#include "lanes/four_doubles.hpp"
#include "wide_checks.hpp"

namespace hsp::HSP_TARGET {
namespace {

constexpr uint32_t n = Floats::lanes;
constexpr float a[8] = {1.0F, -2.0F, 3.0F, 0.5F, 8.0F, -16.0F, 0.0F, 7.0F};
constexpr float b[8] = {2.0F, 2.0F, -4.0F, 0.25F, 4.0F, 32.0F, 1.0F, 7.0F};

// Whether each lane equals the result for one number at a time.
template <class Expected>
bool lanes_are(Floats found, Expected expected) {
  float lane[n];
  found.store(lane);
  for (uint32_t k = 0; k < n; ++k) {
    if (lane[k] != expected(k)) return false;
  }
  return true;
}
template <class Expected>
bool bits_are(LaneBits found, Expected expected) {
  LaneBits bits = 0;
  for (uint32_t k = 0; k < n; ++k) bits |= (expected(k) ? 1U : 0U) << k;
  return found == bits;
}

// All results are exact, so they must be equal.
const char *check_floats() {
  const Floats x = Floats::load(a), y = Floats::load(b), three = Floats::all(3);
  const auto of = [](auto operation) { return [operation](uint32_t k) { return operation(a[k], b[k]); }; };
  if (!lanes_are(x + y, of([](float u, float v) { return u + v; }))) return "+";
  if (!lanes_are(x - y, of([](float u, float v) { return u - v; }))) return "-";
  if (!lanes_are(x * y, of([](float u, float v) { return u * v; }))) return "*";
  if (!lanes_are(x / y, of([](float u, float v) { return u / v; }))) return "/";
  const Floats apart = distance(x, y);
  if (!lanes_are(apart * apart, of([](float u, float v) { return (u - v) * (u - v); }))) return "distance";
  if (!lanes_are(-x, of([](float u, float) { return -u; }))) return "minus";
  if (!lanes_are(fused(x, y, three), of([](float u, float v) { return u * v + 3; }))) return "fused";
  if (!lanes_are(fused_minus(x, y, three), of([](float u, float v) { return u * v - 3; }))) return "fused_minus";
  if (!lanes_are(minus_fused(x, y, three), of([](float u, float v) { return 3 - u * v; }))) return "minus_fused";
  if (!lanes_are(square_root(x * x), of([](float u, float) { return u < 0 ? -u : u; }))) return "square_root";
  if (!lanes_are(larger(x, y), of([](float u, float v) { return u > v ? u : v; }))) return "larger";
  if (!lanes_are(smaller(x, y), of([](float u, float v) { return u < v ? u : v; }))) return "smaller";
  if (!lanes_are(with_sign_of(y, x), of([](float u, float v) { return __builtin_copysignf(v, u); }))) return "sign";
  if (!lanes_are(Floats::all_of(a + 1), [](uint32_t) { return a[1]; })) return "all_of";
  if (!lanes_are(Floats::ascending(), [](uint32_t k) { return static_cast<float>(k); })) return "ascending";
  const uint8_t order[8] = {7, 0, 0, 5, 1, 2, 6, 3};
  if (!lanes_are(EightFloats::load(a).in_order(order), [&](uint32_t k) { return a[order[k]]; })) return "in_order";
  return nullptr;
}

// NaN stands in the first lanes, as there may be only four.
const char *check_comparisons() {
  const float nan = __builtin_nanf("");
  const float u[8] = {nan, nan, 3.0F, 2.0F, 2.0F, 1.0F, 7.0F, -0.0F};
  const float v[8] = {1.0F, nan, 2.0F, 2.0F, nan, 2.0F, 8.0F, 0.0F};
  const Floats x = Floats::load(u), y = Floats::load(v), zero = Floats::all(0), one = Floats::all(1);
  if (!bits_are(greater(x, y), [&](uint32_t k) { return u[k] > v[k]; })) return "greater";
  if (!bits_are(not_greater(x, y), [&](uint32_t k) { return !(u[k] > v[k]); })) return "not_greater";
  if (!bits_are(not_less(x, y), [&](uint32_t k) { return u[k] >= v[k]; })) return "not_less";
  if (!lanes_are(where_greater(x, y, zero, one), [&](uint32_t k) { return u[k] > v[k] ? 0.0F : 1.0F; })) return "where";
  const float signs[8] = {-0.0F, 1.0F, 0.0F, -1.0F, -2.0F, 3.0F, 4.0F, -5.0F};
  if (!bits_are(negative(Floats::load(signs)), [&](uint32_t k) { return __builtin_signbit(signs[k]) != 0; }))
    return "negative";
  for (uint32_t count = 0; count < 12; ++count) {
    const uint32_t most = count < n ? count : n;
    if (ones(first_lanes(count)) != most || first_lanes(count) >> most != 0) return "first_lanes, ones";
  }
  for (LaneBits bits = 1; bits < 1U << n; ++bits) {
    uint32_t count = 0, first = n;
    for (uint32_t k = n; k-- > 0;) {
      count += bits >> k & 1U;
      if ((bits >> k & 1U) != 0) first = k;
    }
    if (ones(bits) != count || lowest(bits) != first) return "ones, lowest";
  }
  LaneCounts<Floats> counts;
  for (int k = 0; k < 3; ++k) counts.count_not_less(Floats::load(a), Floats::all(static_cast<float>(k)));
  for (int32_t count = 0; count < 4; ++count) {
    const auto reached = [](float x_) { return (x_ >= 0 ? 1 : 0) + (x_ >= 1 ? 1 : 0) + (x_ >= 2 ? 1 : 0); };
    if (!bits_are(counts.equal(count), [&](uint32_t k) { return reached(a[k]) == count; })) return "counts";
  }
  return nullptr;
}

// Doubles become floats by rounding to nearest; ties, as in the first two numbers, go to even.
const char *check_doubles() {
  constexpr uint32_t half = Doubles::lanes;
  const double d[8] = {0x1.000003p0, 0x1.000001p0, 0.1, -2.5, 1e30, 1.0, 5.0, -6.0};
  const Doubles low = Doubles::load(d), high = Doubles::load(d + half);
  if (!lanes_are(to_floats(low, high), [&](uint32_t k) { return static_cast<float>(d[k]); })) return "to_floats";
  const Floats sums = to_floats(low - Doubles::all(1), high + Doubles::all_of(d));
  const auto sum = [&](uint32_t k) { return static_cast<float>(k < half ? d[k] - 1 : d[k] + d[0]); };
  return lanes_are(sums, sum) ? nullptr : "doubles, +, -";
}

template <class Expected>
bool integers_are(Integers found, Expected expected) {
  uint32_t lane[n];
  found.store(lane);
  for (uint32_t k = 0; k < n; ++k) {
    if (lane[k] != expected(k)) return false;
  }
  return true;
}

const char *check_integers() {
  const uint32_t u[8] = {0, UINT32_MAX, 3, 0x80000000U, 7, 3, 4, 5}, v[8] = {1, 0, 2, 0x7FFFFFFFU, 6, 3, 4, 6};
  const Integers x = Integers::load(u), y = Integers::load(v);
  const auto with_sign = [](uint32_t bits) { return static_cast<int32_t>(bits); };
  const auto is_greater = [&](uint32_t k) { return with_sign(u[k]) > with_sign(v[k]); };
  if (!integers_are(x + y, [&](uint32_t k) { return u[k] + v[k]; })) return "integers, +";
  if (!integers_are(x - y, [&](uint32_t k) { return u[k] - v[k]; })) return "integers, -";
  if (!integers_are(x & y, [&](uint32_t k) { return u[k] & v[k]; })) return "integers, &";
  if (!integers_are(x | y, [&](uint32_t k) { return u[k] | v[k]; })) return "integers, |";
  if (!integers_are(larger_signed(x, y), [&](uint32_t k) { return is_greater(k) ? u[k] : v[k]; })) return "larger";
  if (!integers_are(smaller_signed(x, y), [&](uint32_t k) { return is_greater(k) ? v[k] : u[k]; })) return "smaller";
  if (!bits_are(equal(x, y), [&](uint32_t k) { return u[k] == v[k]; })) return "equal";
  if (!bits_are(greater_signed(x, y), is_greater)) return "greater_signed";
  if (!bits_are(sign_bits(x), [&](uint32_t k) { return with_sign(u[k]) < 0; })) return "sign_bits";
  for (uint32_t count = 0; count < n + 3; ++count) {
    const auto is_first = [count](uint32_t k) { return k < count; };
    if (!bits_are(first_lanes(count), is_first) || ones(first_lanes(count)) != (count < n ? count : n)) return "first";
    const Integers first = Integers::first_set(count);
    if (!integers_are(first, [&](uint32_t k) { return is_first(k) ? UINT32_MAX : 0U; })) return "first_set";
    if (!integers_are(Integers::all_set_from(count) | first, [](uint32_t) { return UINT32_MAX; })) return "set behind";
    if (!integers_are(Integers::all_set_from(count) & first, [](uint32_t) { return 0U; })) return "set in front";
    if (!integers_are(chosen(first, x, y), [&](uint32_t k) { return is_first(k) ? u[k] : v[k]; })) return "chosen";
    bool all = true;
    for (uint32_t k = 0; k < n && k < count; ++k) all = all && is_greater(k);
    if (all_greater(x, y, first) != all) return "all_greater";
    uint32_t stored[8] = {9, 9, 9, 9, 9, 9, 9, 9};
    store_first(stored, x, count);
    for (uint32_t k = 0; k < 8; ++k) {
      if (stored[k] != (k < count && k < n ? u[k] : 9)) return "store_first";
    }
  }
  const double d[8] = {1.0, -1.0, 0.0, 2.0, -0.0, 0x1.8p0, 0x1.00001p0, -4.0};
  const uint32_t upper[8] = {0x3FF00000, 0xBFF00000U, 0, 0x40000000, 0x80000000U, 0x3FF80000, 0x3FF00001, 0xC0100000U};
  if (!integers_are(upper_halves(Doubles::load(d), Doubles::load(d + Doubles::lanes)),
                    [&](uint32_t k) { return upper[k]; }))
    return "upper_halves";
  float things[32];
  for (uint32_t k = 0; k < 32; ++k) things[k] = static_cast<float>(k);
  const FourOfEach each = FourOfEach::load(things);
  const Floats numbers[4] = {each.a, each.b, each.c, each.d};
  for (uint32_t number = 0; number < 4; ++number) {
    if (!lanes_are(numbers[number], [&](uint32_t k) { return things[4 * k + number]; })) return "four of each";
  }
  int32_t words[32];
  for (int32_t k = 0; k < 32; ++k) words[k] = (k % 2 == 0 ? 16777217 : -33554434) + k;
  const uint32_t thing[8] = {6, 0, 3, 3, 7, 1, 5, 2};
  const FourIntegersOfEach four = FourIntegersOfEach::at(words, thing);
  const Integers integers[4] = {four.a, four.b, four.c, four.d};
  for (uint32_t number = 0; number < 4; ++number) {
    const auto word = [&](uint32_t k) { return words[4 * thing[k] + number]; };
    if (!integers_are(integers[number], [&](uint32_t k) { return static_cast<uint32_t>(word(k)); }))
      return "four words";
    if (!lanes_are(to_floats(integers[number]), [&](uint32_t k) { return static_cast<float>(word(k)); }))
      return "as floats";
  }
  return lowest(0x50) == 4 ? nullptr : "lowest";
}

// Every order of distinct integers, and halves that ascend and descend.
const char *check_sorting() {
  uint32_t state = 12345;
  for (uint32_t round = 0; round < 5000; ++round) {
    uint32_t numbers[n], lane[n];
    for (uint32_t k = 0; k < n; ++k) numbers[k] = (state = state * 1664525U + 1013904223U) >> 4;
    sorted(Integers::load(numbers)).store(lane);
    uint64_t before = 0, after = lane[0];
    for (uint32_t k = 0; k < n; ++k) before += numbers[k];
    for (uint32_t k = 1; k < n; ++k) {
      if (lane[k] < lane[k - 1]) return "sorted";
      after += lane[k];
    }
    if (before != after) return "sorted to others";
    if (!integers_are(reversed(Integers::load(numbers)), [&](uint32_t k) { return numbers[n - 1 - k]; }))
      return "reversed";
    const uint32_t turn = round % n;
    uint32_t bitonic[n];
    for (uint32_t k = 0; k < n; ++k) bitonic[k] = lane[k < turn ? k : n - 1 - (k - turn)];
    if (!integers_are(sorted_bitonic(Integers::load(bitonic)), [&](uint32_t k) { return lane[k]; })) return "bitonic";
  }
  return nullptr;
}

bool are(const FourDoubles &found, const double (&expected)[4]) {
  double lane[4];
  Four::store(lane, found);
  for (uint32_t k = 0; k < 4; ++k) {
    if (lane[k] != expected[k]) return false;
  }
  return true;
}

const char *check_four_doubles() {
  const double fractions[4] = {2.75, -2.75, -0x1p51 - 0.5, 0.5}, whole[4] = {2.0, -2.0, -0x1p51, 0.0};
  if (!are(Four::truncated(Four::load(fractions)), whole)) return "truncated";
  if (!are(Four::of(2.75, -2.75, -0x1p51 - 0.5, 0.5), fractions)) return "of";
  const uint32_t index[4] = {3, 0, 2, 2};
  const double gathered[4] = {0.5, 2.75, -0x1p51 - 0.5, -0x1p51 - 0.5};
  if (!are(Four::gather(fractions, index), gathered)) return "gather";
  for (uint32_t count = 0; count <= 4; ++count) {
    double first[4];
    for (uint32_t k = 0; k < 4; ++k) first[k] = k < count ? fractions[k] : 0.0;
    if (!are(Four::load_first(fractions, count), first)) return "load_first of four";
  }
  const double numbers[4] = {2147483647.0, 0.0, 7.5, 65536.0};
  uint32_t integers[4];
  Four::store_truncated(integers, Four::load(numbers));
  if (integers[0] != 2147483647 || integers[1] != 0 || integers[2] != 7 || integers[3] != 65536) return "integers";
  float rounded[4];
  Four::store_as_floats(rounded, Four::load(numbers));
  for (uint32_t k = 0; k < 4; ++k) {
    if (rounded[k] != static_cast<float>(numbers[k])) return "as floats";
  }
  const double a4[4] = {2147483647.0, -2147483647.0, -1.0, 1073741827.0};
  const double b4[4] = {1073741823.0, 1073741825.0, 0.0, 1073741823.0};
  const LongIntegers x = LongIntegers::from(Four::load(a4)), y = LongIntegers::from(Four::load(b4));
  double product_rounded[4], left_out[4], difference[4];
  for (uint32_t k = 0; k < 4; ++k) {
    const int64_t p = static_cast<int64_t>(a4[k]) * static_cast<int64_t>(b4[k]);
    const int64_t q = static_cast<int64_t>(b4[k]) * static_cast<int64_t>(b4[k]);
    product_rounded[k] = static_cast<double>(p);
    left_out[k] = static_cast<double>(p - static_cast<int64_t>(product_rounded[k]));
    difference[k] = static_cast<double>(p - q);
  }
  FourDoubles rest{};
  if (!are(to_doubles(product(x, y), rest), product_rounded) || !are(rest, left_out)) return "product of integers";
  return are(to_doubles(product(x, y) - product(y, y)), difference) ? nullptr : "difference of products";
}

const char *check_wide() {
  if (const char *const wrong = check_lanes<float, Floats::lanes>(); wrong != nullptr) return wrong;
  if (const char *const wrong = check_lanes<double, Doubles::lanes>(); wrong != nullptr) return wrong;
  return check_lane_vectors<Doubles::lanes>();
}

const char *check_front_orders() {
  const uint32_t ids[8] = {10, 11, 12, 13, 14, 15, 16, 17};
  for (LaneBits chosen = 0; chosen < 1U << n; ++chosen) {
    uint32_t ids_first[8];
    float floats_first[8];
    const FrontOrder order = front_order<Floats>(chosen);
    store_front(ids_first, Integers::ascending() + Integers::all(10), order);
    store_front(floats_first, Floats::load(a), order);
    uint32_t to = 0;
    for (uint32_t lane = 0; lane < n; ++lane) {
      if ((chosen >> lane & 1U) == 0) continue;
      if (ids_first[to] != ids[lane]) return "integers in front";
      if (floats_first[to++] != a[lane]) return "floats in front";
    }
  }
  return nullptr;
}

// Fractions, multiples of 2^-15 in 16 bits, against the same operations on integers. Results stop at the ends of the
// range.
int32_t stopped(int32_t x) {
  return x < -0x8000 ? -0x8000 : x > 0x7FFF ? 0x7FFF : x;
}
const char *check_fractions() {
  constexpr uint32_t all = Fractions::lanes;
  static_assert(all == 2 * n);
  const int32_t sample[] = {0,      1,     -1,     2,     3,     -3,     127,    -255,  4095, 16384,
                            -16384, 23170, -23171, 32766, 32767, -32767, -32768, 12345, -9876};
  constexpr int32_t samples = sizeof sample / sizeof sample[0];
  for (int32_t shift = 0; shift < samples; ++shift) {
    float u[all], v[all];
    int32_t p[all], q[all];
    for (uint32_t k = 0; k < all; ++k) {
      p[k] = sample[(static_cast<int32_t>(k) + shift) % samples];
      q[k] = sample[(static_cast<int32_t>(5 * k) + 3 * shift) % samples];
      u[k] = static_cast<float>(p[k]) * 0x1p-15F;
      v[k] = static_cast<float>(q[k]) * 0x1p-15F;
    }
    const Fractions x = Fractions::of(Floats::load(u), Floats::load(u + n), 1.0F);
    const Fractions y = Fractions::of(Floats::load(v), Floats::load(v + n), 1.0F);
    // A result less what it should be is 0, and no other number has neither sign.
    const auto equals = [&](Fractions found, auto expected) {
      float e[all];
      for (uint32_t k = 0; k < all; ++k) e[k] = static_cast<float>(expected(p[k], q[k])) * 0x1p-15F;
      const Fractions should = Fractions::of(Floats::load(e), Floats::load(e + n), 1.0F);
      LaneBits low = 0, high = 0;
      FractionSigns::of(found - should, should - found).negative(low, high);
      return (low | high) == 0;
    };
    if (!equals(x + y, [](int32_t i, int32_t j) { return stopped(i + j); })) return "fractions, +";
    if (!equals(x - y, [](int32_t i, int32_t j) { return stopped(i - j); })) return "fractions, -";
    if (!equals(larger(x, y), [](int32_t i, int32_t j) { return i > j ? i : j; })) return "fractions, larger";
    if (!equals(smaller(x, y), [](int32_t i, int32_t j) { return i < j ? i : j; })) return "fractions, smaller";
    if (!equals(magnitude(x), [](int32_t i, int32_t) { return i < 0 && i > -32768 ? -i : i; })) return "magnitude";
    const Fractions one_less = larger(x, Fractions::all(-0x7FFFp-15F));
    if (!equals(one_less * y, [](int32_t i, int32_t j) { return ((i < -32767 ? -32767 : i) * j + 0x4000) >> 15; }))
      return "fractions, *";
    if (!bits_are(negative(x.signs_of_low()), [&](uint32_t k) { return p[k] < 0; })) return "signs_of_low";
    if (!bits_are(negative(x.signs_of_high()), [&](uint32_t k) { return p[k + n] < 0; })) return "signs_of_high";
    const FractionSigns either = either_negative(FractionSigns::of(x, y), FractionSigns::of(y, x));
    const FractionSigns both = both_negative(FractionSigns::of(x, x), FractionSigns::of(y, y));
    LaneBits low = 0, high = 0;
    either.negative(low, high);
    if (!bits_are(low, [&](uint32_t k) { return p[k] < 0 || q[k] < 0; })) return "either, low";
    if (!bits_are(high, [&](uint32_t k) { return p[k + n] < 0 || q[k + n] < 0; })) return "either, high";
    both.negative(low, high);
    if (!bits_are(low, [&](uint32_t k) { return p[k] < 0 && q[k] < 0; })) return "both, low";
    if (!bits_are(high, [&](uint32_t k) { return p[k + n] < 0 && q[k + n] < 0; })) return "both, high";
    float twice[n];
    Fractions::twice(Floats::load(u), 1.0F).store(twice);
    for (uint32_t k = 0; k < n; ++k) {
      if (!equals(Fractions::all_of(twice + k) - x, [&](int32_t i, int32_t) { return stopped(p[k] - i); }))
        return "twice";
    }
  }
  // A number that is too large stops, and halves are rounded to even.
  const float far[2 * n] = {4.0F, -4.0F, 0x1.8p-15F, 0x2.8p-15F};
  const float near[2 * n] = {0x7FFFp-15F, -1.0F, 0x2p-15F, 0x2p-15F};
  const Fractions x = Fractions::of(Floats::load(far), Floats::load(far + n), 1.0F);
  const Fractions y = Fractions::of(Floats::load(near), Floats::load(near + n), 1.0F);
  LaneBits low = 0, high = 0;
  FractionSigns::of(x - y, y - x).negative(low, high);
  return (low | high) == 0 ? nullptr : "fractions, of";
}

}  // namespace

void check_words(const char *&wrong) {
  const char *(*const checks[])() = {check_floats,       check_comparisons,  check_doubles,
                                     check_front_orders, check_fractions,    check_integers,
                                     check_sorting,      check_four_doubles, check_wide};
  for (const auto check : checks) {
    wrong = check();
    if (wrong != nullptr) return;
  }
}

}  // namespace hsp::HSP_TARGET

#endif
