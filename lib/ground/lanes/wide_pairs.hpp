// Two words of Wide side by side, with the operations that kernels need: for two independent long chains of dependent
// operations, of which a processor works on one while the other waits, and for twice as many lanes as a register has.
// Operations alternate between the two words, so that compilers and processors see them next to each other.
#pragma once

#include "lanes/wide.hpp"

namespace hsp {
namespace {

template <class T, uint32_t n>
struct WidePairs {
  using L = Wide<T, n>;
  static constexpr uint32_t lanes = 2 * n;

  struct Mask {
    typename L::Mask first, second;
    friend Mask operator^(const Mask &a, const Mask &b) { return {a.first ^ b.first, a.second ^ b.second}; }
  };
  struct Real {
    typename L::Real first, second;

    friend Real operator+(const Real &a, const Real &b) { return {a.first + b.first, a.second + b.second}; }
    friend Real operator-(const Real &a, const Real &b) { return {a.first - b.first, a.second - b.second}; }
    friend Real operator*(const Real &a, const Real &b) { return {a.first * b.first, a.second * b.second}; }
    friend Real operator/(const Real &a, const Real &b) { return {a.first / b.first, a.second / b.second}; }
    friend Real operator+(T a, const Real &b) { return {a + b.first, a + b.second}; }
    friend Real operator+(const Real &a, T b) { return {a.first + b, a.second + b}; }
    friend Real operator-(const Real &a, T b) { return {a.first - b, a.second - b}; }
    friend Real operator*(T a, const Real &b) { return {a * b.first, a * b.second}; }
    friend Real operator*(const Real &a, T b) { return {a.first * b, a.second * b}; }
    friend Mask operator>(const Real &a, const Real &b) { return {a.first > b.first, a.second > b.second}; }
    friend Mask operator>(const Real &a, T b) { return {a.first > b, a.second > b}; }
    friend Mask operator<(const Real &a, T b) { return {a.first < b, a.second < b}; }
    friend Real operator-(const Real &a) { return {-a.first, -a.second}; }
    friend Mask operator==(const Real &a, const Real &b) { return {a.first == b.first, a.second == b.second}; }
    friend Mask operator>=(const Real &a, const Real &b) { return {a.first >= b.first, a.second >= b.second}; }
  };

  static Real load(const T *p) { return {L::load(p), L::load(p + n)}; }
  static void store(T *p, const Real &a) {
    L::store(p, a.first);
    L::store(p + n, a.second);
  }
  static Real all(T x) { return {L::all(x), L::all(x)}; }
  static Real load_first(const T *p, uint32_t count) {
    return {L::load_first(p, count), count > n ? L::load_first(p + n, count - n) : L::all(T{0})};
  }
  static Real gather(const T *p, const uint32_t *index) { return {L::gather(p, index), L::gather(p, index + n)}; }
  static Real of(T a, T b, T c, T d) { return {typename L::Real{a, b}, typename L::Real{c, d}}; }
  static Real truncated(const Real &a) { return {L::truncated(a.first), L::truncated(a.second)}; }
  static void store_truncated(uint32_t *p, const Real &a) {
    L::store_truncated(p, a.first);
    L::store_truncated(p + n, a.second);
  }
  static void store_as_floats(float *p, const Real &a) {
    L::store_as_floats(p, a.first);
    L::store_as_floats(p + n, a.second);
  }
  static Real kept(const Mask &mask, const Real &a) {
    return {L::kept(mask.first, a.first), L::kept(mask.second, a.second)};
  }
  static Real select(const Mask &mask, const Real &a, const Real &b) {
    return {L::select(mask.first, a.first, b.first), L::select(mask.second, a.second, b.second)};
  }
  static Mask both(const Mask &a, const Mask &b) { return {L::both(a.first, b.first), L::both(a.second, b.second)}; }
  static Real negate_if(const Mask &mask, const Real &a) {
    return {L::negate_if(mask.first, a.first), L::negate_if(mask.second, a.second)};
  }
  static Real absolute(const Real &a) { return {L::absolute(a.first), L::absolute(a.second)}; }
  static Real square_root(const Real &a) { return {L::square_root(a.first), L::square_root(a.second)}; }
  static Real larger(const Real &a, const Real &b) {
    return {L::larger(a.first, b.first), L::larger(a.second, b.second)};
  }
  static Real smaller(const Real &a, const Real &b) {
    return {L::smaller(a.first, b.first), L::smaller(a.second, b.second)};
  }
  static uint64_t set_lanes(const Mask &mask) { return L::set_lanes(mask.first) | L::set_lanes(mask.second) << n; }
  static Real fused(const Real &a, const Real &b, const Real &c) {
    return {L::fused(a.first, b.first, c.first), L::fused(a.second, b.second, c.second)};
  }
};

}  // namespace
}  // namespace hsp
