// Vectors of numbers with error bounds: BoundedDouble or WideFloat.
#pragma once

#include "core/vec3.hpp"
#include "numbers/wide_float.hpp"

namespace hsp {

template <class Number>
struct NumberVector {
  Number x, y, z;
};
// Not inlined, and with the result in an operand, since these operations are long code for wide floats. So the code
// between them is mostly calls, and a stack frame holds only named numbers.
template <class Number>
[[gnu::noinline]] void operator+=(NumberVector<Number> &a, const NumberVector<Number> &b) {
  a.x = a.x + b.x;
  a.y = a.y + b.y;
  a.z = a.z + b.z;
}
template <class Number>
[[gnu::noinline]] void operator-=(NumberVector<Number> &a, const NumberVector<Number> &b) {
  a.x = a.x - b.x;
  a.y = a.y - b.y;
  a.z = a.z - b.z;
}
template <class Number>
[[gnu::noinline]] void operator*=(NumberVector<Number> &a, const Number &s) {
  a.x = s * a.x;
  a.y = s * a.y;
  a.z = s * a.z;
}
template <class Number>
[[gnu::noinline]] Number dot(const NumberVector<Number> &a, const NumberVector<Number> &b) {
  Number sum = a.x * b.x;
  sum = sum + a.y * b.y;
  return sum + a.z * b.z;
}
// a b - c d
template <class Number>
[[gnu::noinline]] Number difference_of_products(const Number &a, const Number &b, const Number &c, const Number &d) {
  const Number first = a * b;
  return first - c * d;
}
template <class Number>
NumberVector<Number> cross(const NumberVector<Number> &a, const NumberVector<Number> &b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}
template <class Number>
[[gnu::noinline]] Number determinant(const NumberVector<Number> &a, const NumberVector<Number> &b,
                                     const NumberVector<Number> &c) {
  const NumberVector<Number> n = cross(b, c);
  return dot(a, n);
}

// The nearest doubles.
template <class Number>
NumberVector<BoundedDouble> rounded(const NumberVector<Number> &a) {
  return {BoundedDouble(a.x), BoundedDouble(a.y), BoundedDouble(a.z)};
}
template <class Number>
Vec3 to_double(const NumberVector<Number> &a) {
  const NumberVector<BoundedDouble> nearest = rounded(a);
  return {nearest.x.value, nearest.y.value, nearest.z.value};
}

}  // namespace hsp
