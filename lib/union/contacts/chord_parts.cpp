#include "contacts/chord_parts.hpp"

#include "exact/chord_line.hpp"
#include "exact/lattice_ball.hpp"

namespace hsp {

// With y = 2 (x - c) the chord runs along (q x n + t n)/N, and its part is beta (t+ - t-) / (8 N) for P, and likewise
// for the two others.
void measure_in_integers(const BallSet &balls, ChordBatch &batch, uint32_t s) {
  const exact::LatticeBall own = balls.ball(batch.ball[0][s]);
  const exact::ChordLine<exact::FastLimb> line(exact::plane_of(own, balls.ball(batch.ball[1][s])),
                                               exact::plane_of(own, balls.ball(batch.ball[2][s])));
  double t[2];
  for (uint32_t end = 0; end < 2; ++end) {
    const double free_end = batch.free_end[end][s];
    t[end] = free_end == free_end ? free_end : line.parameter(exact::plane_of(own, balls.ball(batch.clipper[end][s])));
  }
  const exact::ChordFactors factors = line.factors();
  // Infinitely short chords may have an extent below 0 by rounding.
  const double extent = t[1] - t[0];
  const double scale = extent > 0.0 ? extent / (8 * factors.N) : 0.0;
  batch.part[0][s] = scale * factors.beta;
  batch.part[1][s] = scale * factors.alpha;
  batch.part[2][s] = scale * factors.third;
}

}  // namespace hsp
