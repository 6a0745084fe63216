#include "contacts/chord_parts.hpp"

#include "sphere/lane_planes.hpp"

namespace hsp::HSP_TARGET {
namespace {

// The polynomials of chord_line.hpp.
struct LaneChords {
  static constexpr double most_error = 0x1p-98;  // in parts of the bounds below

  LaneVectors u, v;
  LaneNormals n;
  Twofold N, alpha, beta, third;
  FourDoubles bound;  // M
  LaneBits certain;

  LaneChords() = default;
  LaneChords(const LanePlanes &P, const LanePlanes &Q) : u(P.v), v(Q.v), n(P.v, Q.v) {
    const Twofold uv = from(dot(u, v));
    const Twofold h_P = from(P.h), h_Q = from(Q.h);
    const Twofold a = product(h_P, from(Q.U)), b = product(h_Q, uv);
    const Twofold c = product(h_Q, from(P.U)), d = product(h_P, uv);
    const Twofold square = sum_of_squares(n.x, n.y, n.z);
    bound = square.high +
            ((Four::absolute(a.high) + Four::absolute(b.high)) + (Four::absolute(c.high) + Four::absolute(d.high)));
    const FourDoubles error = Four::all(most_error) * bound;
    certain = rounded_within(square, error, N);
    certain &= rounded_within(difference(a, b), error, alpha);
    certain &= rounded_within(difference(c, d), error, beta);
    const Twofold twice{N.high + N.high, N.low + N.low};
    certain &= rounded_within(difference(difference(twice, alpha), beta), error, third);
  }

  // Where a third plane meets the line, in lanes that are set in `known`.
  FourDoubles parameter(const LanePlanes &R, LaneBits &known) const {
    const Twofold h = from(R.h), uz = from(dot(u, R.v)), vz = from(dot(v, R.v));
    const Twofold minus_A = difference(difference(product(N, h), product(alpha, uz)), product(beta, vz));
    const FourDoubles bound_A = bound * ((Four::absolute(h.high) + Four::absolute(uz.high)) + Four::absolute(vz.high));
    const Twofold x = product(n.x, R.x), y = product(n.y, R.y), z = product(n.z, R.z);
    const FourDoubles bound_B = (Four::absolute(x.high) + Four::absolute(y.high)) + Four::absolute(z.high);
    Twofold A{}, B{};
    known = rounded_within(minus_A, Four::all(most_error) * bound_A, A);
    known &= rounded_within(sum_of_three(x, y, z), Four::all(most_error) * bound_B, B);
    return A.high / B.high;
  }
};

}  // namespace

// Each step is for all groups of four before the next one is for any, so that a processor has chains of several groups
// to choose from.
uint32_t measure_in_lanes(const BallArrays &balls, ChordBatch &batch, uint32_t count) {
  if constexpr (!has_twofold) return (1U << count) - 1U;
  constexpr uint32_t most = ChordBatch::capacity / 4;
  LaneBalls own[most];
  LaneChords chords[most];
  FourDoubles t[2][most];
  const uint32_t groups = count / 4;
  for (uint32_t g = 0; g < groups; ++g) {
    own[g] = LaneBalls(balls, &batch.ball[0][4 * g]);
    chords[g] = {LanePlanes(own[g], LaneBalls(balls, &batch.ball[1][4 * g])),
                 LanePlanes(own[g], LaneBalls(balls, &batch.ball[2][4 * g]))};
  }
  for (uint32_t end = 0; end < 2; ++end) {
    for (uint32_t g = 0; g < groups; ++g) {
      const FourDoubles free_end = Four::load(&batch.free_end[end][4 * g]);
      const LaneBits is_free = lanes_where(free_end == free_end);
      t[end][g] = free_end;
      if (is_free == 15U) continue;
      LaneBits known = 0;
      const LanePlanes R(own[g], LaneBalls(balls, &batch.clipper[end][4 * g]));
      t[end][g] = Four::select(free_end == free_end, free_end, chords[g].parameter(R, known));
      chords[g].certain &= known | is_free;
    }
  }
  uint32_t uncertain = 0;
  for (uint32_t g = 0; g < groups; ++g) {
    const LaneChords &chord = chords[g];
    const FourDoubles scale = Four::larger(t[1][g] - t[0][g], Four::all(0.0)) / (Four::all(8.0) * chord.N.high);
    Four::store(&batch.part[0][4 * g], scale * chord.beta.high);
    Four::store(&batch.part[1][4 * g], scale * chord.alpha.high);
    Four::store(&batch.part[2][4 * g], scale * chord.third.high);
    uncertain |= (~chord.certain & 15U) << (4 * g);
  }
  return uncertain;
}

}  // namespace hsp::HSP_TARGET
