// The larger and the smaller of two numbers.
#pragma once

namespace hsp {

template <class Number>
constexpr Number larger_of(Number a, Number b) {
  return a > b ? a : b;
}
template <class Number>
constexpr Number smaller_of(Number a, Number b) {
  return a < b ? a : b;
}

}  // namespace hsp
