#include "avx2_lanes_checks.hpp"

#if HSP_AVX2
#include "lanes/words.hpp"
#include "wide_checks.hpp"

namespace {

using namespace hsp;

constexpr float fa[8] = {1.0F, -2.0F, 3.0F, 0.5F, 8.0F, -16.0F, 0.0F, 7.0F};
constexpr float fb[8] = {2.0F, 2.0F, -4.0F, 0.25F, 4.0F, 32.0F, 1.0F, 7.0F};
constexpr double da[4] = {1.0, -2.0, 3.0, 0.5};
constexpr double db[4] = {2.0, 2.0, -4.0, 0.25};

template <class Lanes, class Real>
bool lanes_are(const Lanes &lanes, const Real (&expected)[Lanes::lanes]) {
  Real found[Lanes::lanes];
  lanes.store(found);
  for (uint32_t k = 0; k < Lanes::lanes; ++k) {
    if (found[k] != expected[k]) return false;
  }
  return true;
}

// The operations that both kinds of lanes have, against the same on one number at a time. All results are exact.
template <class Lanes, class Real>
const char *check_real_lanes(const Real (&a)[Lanes::lanes], const Real (&b)[Lanes::lanes]) {
  constexpr uint32_t n = Lanes::lanes;
  const Lanes x = Lanes::load(a);
  const Lanes y = Lanes::load(b);
  Real sum[n], difference[n], product[n], ratio[n], negative[n], both[n], both_minus[n], minus_both[n], squares[n],
      all[n];
  for (uint32_t k = 0; k < n; ++k) {
    sum[k] = a[k] + b[k];
    difference[k] = a[k] - b[k];
    product[k] = a[k] * b[k];
    ratio[k] = a[k] / b[k];
    negative[k] = -a[k];
    both[k] = a[k] * b[k] + Real{3};
    both_minus[k] = a[k] * b[k] - Real{3};
    minus_both[k] = Real{3} - a[k] * b[k];
    squares[k] = a[k] * a[k];
    all[k] = a[1];
  }
  if (!lanes_are(x + y, sum)) return "+";
  if (!lanes_are(x - y, difference)) return "-";
  if (!lanes_are(x * y, product)) return "*";
  if (!lanes_are(x / y, ratio)) return "/";
  if (!lanes_are(-x, negative)) return "minus";
  if (!lanes_are(fused(x, y, Lanes::all(3)), both)) return "fused";
  if (!lanes_are(fused_minus(x, y, Lanes::all(3)), both_minus)) return "fused_minus";
  if (!lanes_are(minus_fused(x, y, Lanes::all(3)), minus_both)) return "minus_fused";
  for (uint32_t k = 0; k < n; ++k) negative[k] = a[k] < 0 ? -a[k] : a[k];
  if (!lanes_are(square_root(Lanes::load(squares)), negative)) return "square_root";
  if (!lanes_are(Lanes::all_of(a + 1), all)) return "all_of";
  return nullptr;
}

}  // namespace

const char *check_float_lanes() {
  return check_real_lanes<Floats>(fa, fb);
}

const char *check_double_lanes() {
  return check_real_lanes<Doubles>(da, db);
}

const char *check_four_doubles() {
  if (const char *const of_floats = check_lanes<float, 8>(); of_floats != nullptr) return of_floats;
  const char *const wrong = check_lanes<double, 4>();
  return wrong != nullptr ? wrong : check_lane_vectors<4>();
}

const char *check_integer_lanes() {
  const uint32_t expected[8] = {5, 6, 7, 8, 9, 10, 11, 12};
  if (!lanes_are(Integers::ascending() + Integers::all(5), expected)) return "ascending, +";
  if (!lanes_are(Integers::load(expected), expected)) return "load";
  for (uint32_t count = 0; count < 12; ++count) {
    const LaneBits bits = first_lanes(count);
    if (ones(bits) != (count < 8 ? count : 8)) return "first_lanes, ones";
    if (bits != 0 && (bits & 1U) == 0) return "first_lanes are the lowest";
  }
  const uint32_t others[8] = {5, 0, 7, 0, UINT32_MAX, 10, 0, 12};
  if (equal(Integers::load(expected), Integers::load(others)) != 0xA5) return "equal, integers";
  const uint32_t a[8] = {0, UINT32_MAX, 7, 0x80000000U, 3, 3, 4, 5}, b[8] = {1, 0, 6, 0x7FFFFFFFU, 3, 2, 4, 6};
  const uint32_t largest[8] = {1, 0, 7, 0x7FFFFFFFU, 3, 3, 4, 6};
  const uint32_t less[8] = {UINT32_MAX, UINT32_MAX, 1, 1, 0, 1, 0, UINT32_MAX}, both[8] = {0, 0, 6, 0, 3, 2, 4, 4};
  const Integers x = Integers::load(a), y = Integers::load(b);
  if (!lanes_are(larger_signed(x, y), largest)) return "larger_signed";
  if (!lanes_are(x - y, less) || !lanes_are(x & y, both)) return "-, &";
  if (sign_bits(x) != 0x0A || greater_signed(x, y) != 0x24) return "signs";
  if (!all_greater(x, y, Integers::load(a) & Integers::all(0)) || all_greater(x, y, Integers::first_set(3)))
    return "all";
  for (uint32_t count = 0; count < 12; ++count) {
    if (sign_bits(Integers::first_set(count)) != first_lanes(count)) return "first_set";
  }
  const double low[4] = {1.0, -1.0, 0.0, 2.0}, high[4] = {-0.0, 0x1.8p0, 0x1.00001p0, -4.0};
  const uint32_t upper[8] = {0x3FF00000, 0xBFF00000, 0, 0x40000000, 0x80000000U, 0x3FF80000, 0x3FF00001, 0xC0100000U};
  if (!lanes_are(upper_halves(Doubles::load(low), Doubles::load(high)), upper)) return "upper_halves";
  return lowest(0x50) == 4 ? nullptr : "lowest";
}

const char *check_comparisons() {
  const float nan = __builtin_nanf("");
  const float x[8] = {1.0F, 2.0F, 3.0F, nan, 5.0F, nan, 7.0F, 8.0F};
  const float y[8] = {2.0F, 2.0F, 2.0F, 1.0F, nan, nan, 8.0F, 0.0F};
  if (greater(Floats::load(x), Floats::load(y)) != 0x84) return "greater, floats";
  if (not_less(Floats::load(x), Floats::load(y)) != 0x86) return "not_less, floats";
  if (not_greater(Floats::load(x), Floats::load(y)) != 0x7B) return "not_greater, floats";
  const float chosen[8] = {1.0F, 1.0F, 0.0F, 1.0F, 1.0F, 1.0F, 1.0F, 0.0F};
  const Floats zero = Floats::all(0.0F), one = Floats::all(1.0F);
  if (!lanes_are(where_greater(Floats::load(x), Floats::load(y), zero, one), chosen)) return "where_greater";
  const double u[4] = {1.0, 2.0, 3.0, __builtin_nan("")};
  const double v[4] = {2.0, 2.0, 2.0, 1.0};
  if (greater(Doubles::load(u), Doubles::load(v)) != 4) return "greater, doubles";
  if (not_less(Doubles::load(u), Doubles::load(v)) != 6) return "not_less, doubles";
  const double w[4] = {-2.0, 0.0, -0.0, 3.0}, magnitudes[4] = {2.0, 0.0, 0.0, 3.0};
  if (negative(Doubles::load(w)) != 5) return "negative";
  if (!lanes_are(magnitude(Doubles::load(w)), magnitudes)) return "magnitude";
  // The last bit is lost, to even, or rounded away from what is nearest below.
  const double low[4] = {1.0, -2.5, 0x1.000001p0, 0x1.000003p0}, high[4] = {0.1, 1e30, 5.0, -6.0};
  const float rounded[8] = {1.0F, -2.5F, 1.0F, 0x1.000004p0F, 0.1F, 1e30F, 5.0F, -6.0F};
  if (!lanes_are(to_floats(Doubles::load(low), Doubles::load(high)), rounded)) return "to_floats";
  return nullptr;
}

const char *check_parts_and_counts() {
  const uint32_t index[4] = {3, 0, 2, 2};
  const double at[4] = {da[3], da[0], da[2], da[2]};
  if (!lanes_are(Doubles::at(da, index), at)) return "at";
  for (uint32_t count = 0; count <= 4; ++count) {
    double first[4];
    for (uint32_t k = 0; k < 4; ++k) first[k] = k < count ? da[k] : 0.0;
    if (!lanes_are(Doubles::load_first(da, count), first)) return "load_first";
  }
  const float as_floats[8] = {1.0F, -2.0F, 3.0F, 0.5F, 2.0F, 2.0F, -4.0F, 0.25F};
  if (!lanes_are(to_floats(Doubles::load(da), Doubles::load(db)), as_floats)) return "to_floats";
  const float larger_ones[8] = {2.0F, 2.0F, 3.0F, 0.5F, 8.0F, 32.0F, 1.0F, 7.0F};
  if (!lanes_are(larger(Floats::load(fa), Floats::load(fb)), larger_ones)) return "larger, floats";
  const double larger_doubles[4] = {2.0, 2.0, 3.0, 0.5};
  if (!lanes_are(larger(Doubles::load(da), Doubles::load(db)), larger_doubles)) return "larger, doubles";
  float smaller_ones[8];
  for (uint32_t k = 0; k < 8; ++k) smaller_ones[k] = fa[k] < fb[k] ? fa[k] : fb[k];
  if (!lanes_are(smaller(Floats::load(fa), Floats::load(fb)), smaller_ones)) return "smaller, floats";

  const double smaller_doubles[4] = {1.0, -2.0, -4.0, 0.25}, second[4] = {-2.0, -2.0, -2.0, -2.0};
  if (!lanes_are(smaller(Doubles::load(da), Doubles::load(db)), smaller_doubles)) return "smaller, doubles";
  if (!lanes_are(in_all_lanes<1>(Doubles::load(da)), second) || first(Doubles::load(da)) != 1.0) return "in_all_lanes";
  const double fractions[4] = {2.75, -2.75, -0x1p51 - 0.5, 0.5}, whole[4] = {2.0, -2.0, -0x1p51, 0.0};
  if (!lanes_are(truncated(Doubles::load(fractions)), whole)) return "truncated";
  const double bounds[4] = {2.75, -2.5, __builtin_nan(""), 0.25}, reached[4] = {1.0, 0.0, 0.0, 1.0};
  if (!lanes_are(one_where_not_less(Doubles::load(fractions), Doubles::load(bounds)), reached)) return "not less";
  const double numbers[4] = {2147483647.0, 0.0, 7.0, 65536.0};
  uint32_t integers[4];
  store_integers(integers, Doubles::load(numbers));
  if (integers[0] != 2147483647 || integers[1] != 0 || integers[2] != 7 || integers[3] != 65536)
    return "store_integers";

  LaneCounts<Floats> floats;
  LaneCounts<Doubles> doubles;
  for (int k = 0; k < 3; ++k) {
    floats.count_not_less(Floats::load(fa), Floats::all(static_cast<float>(k)));
    doubles.count_not_less(Doubles::load(da), Doubles::all(k));
  }
  // Numbers not below 0, 1 and 2: of 1 two, of -2 none, of 3 all, of 0.5 one.
  if (floats.equal(3) != 0x94 || floats.equal(2) != 1 || floats.equal(1) != 0x48) return "counts, floats";
  if (doubles.equal(3) != 4 || doubles.equal(2) != 1 || doubles.equal(0) != 2) return "counts, doubles";
  return nullptr;
}

const char *check_long_integers() {
  const double a[4] = {2147483647.0, -2147483647.0, -1.0, 1073741827.0};
  const double b[4] = {2147483645.0, 2147483647.0, 0.0, 1073741823.0};
  const LongIntegers x = LongIntegers::from(Doubles::load(a)), y = LongIntegers::from(Doubles::load(b));
  double sum[4], difference[4];
  for (uint32_t k = 0; k < 4; ++k) {
    const int64_t p = static_cast<int64_t>(a[k]) * static_cast<int64_t>(b[k]);
    const int64_t q = static_cast<int64_t>(a[k]) * static_cast<int64_t>(a[k]);
    sum[k] = static_cast<double>(p + q);
    difference[k] = static_cast<double>(p - q);
  }
  if (!lanes_are(to_doubles(product(x, y) + product(x, x)), sum)) return "sum of products";
  return lanes_are(to_doubles(product(x, y) - product(x, x)), difference) ? nullptr : "difference of products";
}

const char *check_front_orders() {
  const uint32_t ids[8] = {10, 11, 12, 13, 14, 15, 16, 17};
  for (LaneBits chosen = 0; chosen < 256; ++chosen) {
    uint32_t ids_first[8];
    float floats_first[8];
    store_front(ids_first, Integers::load(ids), FrontOrder::of_eight(chosen));
    store_front(floats_first, Floats::load(fa), FrontOrder::of_eight(chosen));
    uint32_t to = 0;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      if ((chosen >> lane & 1U) == 0) continue;
      if (ids_first[to] != ids[lane]) return "integers";
      if (floats_first[to++] != fa[lane]) return "floats";
    }
    if (chosen >= 16) continue;
    double doubles_first[4];
    store_front(doubles_first, Doubles::load(da), FrontOrder::of_four(chosen));
    to = 0;
    for (uint32_t lane = 0; lane < 4; ++lane) {
      if ((chosen >> lane & 1U) != 0 && doubles_first[to++] != da[lane]) return "doubles";
    }
  }
  return nullptr;
}

#endif
