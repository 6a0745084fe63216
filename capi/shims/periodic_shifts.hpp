// How shifts in a periodic box come to the caller.
#pragma once

#include "hardsphere.h"
#include "periodic/periodic_box.hpp"

namespace hsp::capi {

inline void put_shift(const BoxShift &shift, int32_t (&out)[3]) {
  for (int k = 0; k < 3; ++k) out[k] = shift.k[k];
}

// Lexicographic.
inline bool shift_comes_before(const int32_t (&p)[3], const int32_t (&q)[3]) {
  return comes_before({{p[0], p[1], p[2]}}, {{q[0], q[1], q[2]}});
}

inline bool image_comes_before(const hsp_image &p, const hsp_image &q) {
  return p.ball != q.ball ? p.ball < q.ball : shift_comes_before(p.shift, q.shift);
}

}  // namespace hsp::capi
