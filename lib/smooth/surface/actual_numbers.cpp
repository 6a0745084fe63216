#include "surface/actual_numbers.hpp"

namespace hsp {
namespace {

constexpr int32_t proportion = -192, of_the_form = -460, of_centres = -600;

// 61 pseudo-random bits.
int64_t mixed(uint64_t &state) {
  state += UINT64_C(0x9E3779B97F4A7C15);
  uint64_t x = state;
  x = (x ^ (x >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  x = (x ^ (x >> 27)) * UINT64_C(0x94D049BB133111EB);
  return static_cast<int64_t>((x ^ (x >> 31)) >> 3);
}

uint64_t key_of(const exact::Vector &at) {
  uint64_t state = static_cast<uint64_t>(at.x);
  state = static_cast<uint64_t>(mixed(state)) ^ static_cast<uint64_t>(at.y);
  state = static_cast<uint64_t>(mixed(state)) ^ static_cast<uint64_t>(at.z);
  return state;
}

}  // namespace

// Exact, but for the shifts of the two centres.
void ActualNumbers<WideFloat>::find_difference(uint32_t i, uint32_t j, NumberVector<WideFloat> &v) const {
  const uint32_t origin = boundary.component_origin(i);
  const exact::Vector between = balls.exact_difference(i, j);
  uint64_t from = key_of(balls.exact_difference(origin, i)), to = key_of(balls.exact_difference(origin, j));
  const auto moved = [&](int64_t x) {
    const int64_t start = mixed(from), end = mixed(to);
    return number(x) + WideFloat(end - start, bits, of_centres - 61);
  };
  v.x = moved(between.x);
  v.y = moved(between.y);
  v.z = moved(between.z);
}

// M is an integer of less than 80 bits, so few bits suffice until it is added to the weight.
WideFloat ActualNumbers<WideFloat>::weight(uint32_t i) const {
  constexpr uint32_t bits_of_form = 128;
  const exact::Vector c = balls.exact_difference(boundary.component_origin(i), i);
  struct Term {
    int64_t coefficient, first, second;
  };
  const Term terms[] = {{1009, c.x, c.x}, {757, c.x, c.y}, {499, c.x, c.z},
                        {331, c.y, c.y},  {211, c.y, c.z}, {113, c.z, c.z}};
  WideFloat form;
  for (const Term &term : terms) {
    form = form + WideFloat(term.coefficient * term.first, bits_of_form) * WideFloat(term.second, bits_of_form);
  }
  WideFloat weight = number(static_cast<int64_t>(balls.r[i]));
  weight = weight * weight;
  weight = weight + weight.scaled(proportion);
  return weight + form.exact_in(bits).scaled(of_the_form);
}

WideFloat ActualNumbers<WideFloat>::root_discriminant(uint32_t v, const WideFloat &square,
                                                      const NumberVector<WideFloat> &q) const {
  return square_root(discriminant_of(square, q, weight(boundary.vertex(v).ball[0])));
}

}  // namespace hsp
