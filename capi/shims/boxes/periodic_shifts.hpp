// The conversion of shifts in a periodic box for the caller.
#pragma once

#include "hardsphere.h"
#include "periodic/windings.hpp"

namespace hsp::capi {

inline void put_shift(const BoxShift &shift, int32_t *out) {
  for (int k = 0; k < 3; ++k) out[k] = shift.k[k];
}

// Sets the directions, copies and rows of a record that is 0.
template <class Record>
void put_lattice(const WindingLattice &lattice, Record &record) {
  const uint64_t copies = lattice.copies();
  record.directions = lattice.rank;
  record.copies = copies == 0 || copies >= HSP_NONE ? HSP_NONE : static_cast<uint32_t>(copies);
  for (uint32_t r = 0; r < lattice.rank; ++r)
    put_shift({{lattice.row[r][0], lattice.row[r][1], lattice.row[r][2]}}, record.row + 3 * r);
}

// Lexicographic order.
inline bool shift_comes_before(const int32_t (&p)[3], const int32_t (&q)[3]) {
  return comes_before({{p[0], p[1], p[2]}}, {{q[0], q[1], q[2]}});
}

inline bool image_comes_before(const hsp_image &p, const hsp_image &q) {
  return p.ball != q.ball ? p.ball < q.ball : shift_comes_before(p.shift, q.shift);
}

}  // namespace hsp::capi
