// Checks of lanes/wide.hpp: each lane against the same operation on one double; the signs of zeros count. Everything
// has internal linkage, so that files compiled for other registers have their own copy.
#pragma once

#include "lanes/wide.hpp"

namespace {

template <class T>
bool same_bits(T a, T b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

constexpr double lane_values[] = {0.0, -0.0, 1.5, -3.0, 2.0, 0x1p-1074, -0x1p1000, 9.0, -1e300, 0.25, 16.0, -1.0};
constexpr uint32_t lane_value_count = sizeof lane_values / sizeof *lane_values;

// The fault, or null. Every pair of values meets in every lane, beside others.
template <class T, uint32_t n>
const char *check_lanes() {
  using L = hsp::Wide<T, n>;
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  T values[lane_value_count];
  for (uint32_t k = 0; k < lane_value_count; ++k) values[k] = static_cast<T>(lane_values[k]);
  for (uint32_t k = 0; k < lane_value_count * lane_value_count; ++k) {
    T a[n], b[n], out[n];
    typename L::Signed words[n];
    uint32_t index[n];
    for (uint32_t lane = 0; lane < n; ++lane) {
      a[lane] = values[(k + 5 * lane) % lane_value_count];
      index[lane] = (k / lane_value_count + 7 * lane) % lane_value_count;
      b[lane] = values[index[lane]];
      words[lane] = a[lane] < b[lane] ? -1 : 0;
    }
    const Real x = L::load(a);
    const Real y = L::gather(values, index);
    const Mask smaller = x < y;
    const Mask loaded = L::load_mask(words);
    L::store(out, x);
    uint32_t set = 0;
    uint64_t bits = 0;
    for (uint32_t lane = 0; lane < n; ++lane) {
      const bool is_smaller = a[lane] < b[lane];
      set += is_smaller ? 1U : 0U;
      bits |= static_cast<uint64_t>(is_smaller) << lane;
      const T magnitude = std::signbit(a[lane]) ? -a[lane] : a[lane];
      if (!same_bits(out[lane], a[lane])) return "load, store";
      if (!same_bits(y[lane], b[lane])) return "gather";
      if (!same_bits(L::all(a[0])[lane], a[0])) return "all";
      if (smaller[lane] != words[lane] || loaded[lane] != words[lane]) return "load_mask";
      if (!same_bits(L::kept(smaller, x)[lane], is_smaller ? a[lane] : T{0})) return "kept";
      if (!same_bits(L::select(smaller, x, y)[lane], is_smaller ? a[lane] : b[lane])) return "select";
      if (!same_bits(L::smaller(x, y)[lane], is_smaller ? a[lane] : b[lane])) return "smaller";
      if (!same_bits(L::larger(x, y)[lane], a[lane] > b[lane] ? a[lane] : b[lane])) return "larger";
      const T valid = L::valid(smaller, x)[lane];
      if (is_smaller ? !same_bits(valid, a[lane]) : valid == valid) return "valid";
      if (!same_bits(L::negate_if(smaller, x)[lane], is_smaller ? -a[lane] : a[lane])) return "negate_if";
      if (!same_bits(L::absolute(x)[lane], magnitude)) return "absolute";
      if (!same_bits(L::square_root(L::absolute(x))[lane], std::sqrt(magnitude))) return "square_root";
      if (L::sign_bits(L::bits(x))[lane] != (std::signbit(a[lane]) ? 1 : 0)) return "sign_bits";
      if (L::both(smaller, x > T{0})[lane] != (is_smaller && a[lane] > T{0} ? -1 : 0)) return "both";
      if (!same_bits(L::number(L::bits(x))[lane], a[lane])) return "bits, number";
    }
    if (L::any(smaller) != (set > 0)) return "any";
    if (L::set_lanes(smaller) != bits || L::count(smaller) != set) return "set_lanes, count";
    if (L::sum(smaller) != -static_cast<int64_t>(set)) return "sum";
  }
  return nullptr;
}

template <uint32_t n>
const char *check_lane_vectors() {
  using L = hsp::Wide<double, n>;
  using Vector = hsp::VectorOf<typename L::Real>;
  const auto lanes = [](double first) {
    double x[n];
    for (uint32_t lane = 0; lane < n; ++lane) x[lane] = first + lane;
    return L::load(x);
  };
  const Vector a{lanes(1), lanes(3), lanes(7)}, b{lanes(13), lanes(19), lanes(29)};
  const Vector sum = a + b, difference = b - a, twice = L::all(2.0) * a, c = cross(a, b);
  for (uint32_t lane = 0; lane < n; ++lane) {
    const double k = lane;
    if (sum.x[lane] != 14 + 2 * k || sum.y[lane] != 22 + 2 * k || sum.z[lane] != 36 + 2 * k) return "+";
    if (difference.x[lane] != 12 || difference.y[lane] != 16 || difference.z[lane] != 22) return "-";
    if (twice.x[lane] != 2 + 2 * k || twice.y[lane] != 6 + 2 * k || twice.z[lane] != 14 + 2 * k) return "*";
    if (dot(a, b)[lane] != (1 + k) * (13 + k) + (3 + k) * (19 + k) + (7 + k) * (29 + k)) return "dot";
    if (c.x[lane] != (3 + k) * (29 + k) - (7 + k) * (19 + k)) return "cross, x";
    if (c.y[lane] != (7 + k) * (13 + k) - (1 + k) * (29 + k)) return "cross, y";
    if (c.z[lane] != (1 + k) * (19 + k) - (3 + k) * (13 + k)) return "cross, z";
  }
  return nullptr;
}

}  // namespace
