#include "contacts/chord_parts.hpp"

#if HSP_AVX2
#include "sphere/lane_planes_avx2.hpp"

namespace hsp {
namespace {

// The polynomials of chord_line.hpp.
struct LaneChords {
  static constexpr double most_error = 0x1p-98;  // in parts of the bounds below

  LaneVectors u, v;
  LaneNormals n;
  Twofold N, alpha, beta, third;
  Doubles bound;  // M
  LaneBits certain;

  LaneChords(const LanePlanes &P, const LanePlanes &Q) : u(P.v), v(Q.v), n(P.v, Q.v) {
    const Twofold uv = from(dot(u, v));
    const Twofold h_P = from(P.h), h_Q = from(Q.h);
    const Twofold a = product(h_P, from(Q.U)), b = product(h_Q, uv);
    const Twofold c = product(h_Q, from(P.U)), d = product(h_P, uv);
    const Twofold square = sum_of_squares(n.x, n.y, n.z);
    bound = square.high + ((magnitude(a.high) + magnitude(b.high)) + (magnitude(c.high) + magnitude(d.high)));
    const Doubles error = Doubles::all(most_error) * bound;
    certain = rounded_within(square, error, N);
    certain &= rounded_within(difference(a, b), error, alpha);
    certain &= rounded_within(difference(c, d), error, beta);
    const Twofold twice{N.high + N.high, N.low + N.low};
    certain &= rounded_within(difference(difference(twice, alpha), beta), error, third);
  }

  // Where a third plane meets the line, in lanes that are set in `known`.
  Doubles parameter(const LanePlanes &R, LaneBits &known) const {
    const Twofold h = from(R.h), uz = from(dot(u, R.v)), vz = from(dot(v, R.v));
    const Twofold minus_A = difference(difference(product(N, h), product(alpha, uz)), product(beta, vz));
    const Doubles bound_A = bound * ((magnitude(h.high) + magnitude(uz.high)) + magnitude(vz.high));
    const Twofold x = product(n.x, R.x), y = product(n.y, R.y), z = product(n.z, R.z);
    const Doubles bound_B = (magnitude(x.high) + magnitude(y.high)) + magnitude(z.high);
    Twofold A{}, B{};
    known = rounded_within(minus_A, Doubles::all(most_error) * bound_A, A);
    known &= rounded_within(sum_of_three(x, y, z), Doubles::all(most_error) * bound_B, B);
    return A.high / B.high;
  }
};

}  // namespace

uint32_t measure_in_lanes(const BallArrays &balls, ChordBatch &batch, uint32_t s) {
  const LaneBalls own(balls, &batch.ball[0][s]);
  const LanePlanes P(own, LaneBalls(balls, &batch.ball[1][s])), Q(own, LaneBalls(balls, &batch.ball[2][s]));
  const LaneChords chords(P, Q);
  LaneBits certain = chords.certain;
  Doubles t[2];
  for (uint32_t end = 0; end < 2; ++end) {
    const Doubles free_end = Doubles::load(&batch.free_end[end][s]);
    const LaneBits is_free = not_less(free_end, free_end);
    if (is_free == 15U) {
      t[end] = free_end;
      continue;
    }
    LaneBits known = 0;
    const LanePlanes R(own, LaneBalls(balls, &batch.clipper[end][s]));
    t[end] = where_number(free_end, chords.parameter(R, known));
    certain &= known | is_free;
  }
  const Doubles scale = larger(t[1] - t[0], Doubles::all(0.0)) / (Doubles::all(8.0) * chords.N.high);
  (scale * chords.beta.high).store(&batch.part[0][s]);
  (scale * chords.alpha.high).store(&batch.part[1][s]);
  (scale * chords.third.high).store(&batch.part[2][s]);
  return ~certain & 15U;
}

}  // namespace hsp
#endif
