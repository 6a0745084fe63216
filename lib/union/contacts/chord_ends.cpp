#include "contacts/chord_ends.hpp"

#include "exact/chord_line.hpp"
#include "exact/lattice_ball.hpp"
#include "exact/predicates.hpp"

namespace hsp {
namespace {

using exact::LatticeBall;
using exact::Plane;
using Line = exact::ChordLine<exact::FastLimb>;

// t/(8 N); 0 for planes through one circle, with N = 0.
double scale_of(double t, double N) {
  return N > 0.0 ? t / (8 * N) : 0.0;
}

// The term that an end at t = sqrt(D) of the chord of planes P and Q adds to the contact of P.
double free_end(const Plane &P, const Plane &Q, double root) {
  const exact::ChordFactors factors = Line(P, Q).factors();
  return factors.beta * scale_of(root, factors.N);
}

}  // namespace

void measure_in_integers(const BallSet &balls, PowerVertexBatch &batch, uint32_t s) {
  LatticeBall ball[4];
  for (uint32_t k = 0; k < 4; ++k) ball[k] = balls.ball(batch.ball[k][s]);
  const Plane P = plane_of(ball[0], ball[1]), Q = plane_of(ball[0], ball[2]), R = plane_of(ball[0], ball[3]);
  const Plane of_second[3] = {plane_of(ball[1], ball[2]), plane_of(ball[1], ball[3]), plane_of(ball[1], ball[0])};
  const int side = exact::Exact::triple_product_sign(P.v, Q.v, R.v);
  double part[4][3];  // by chord: for its first, second and third contact
  const auto measure = [&](uint32_t chord, const Plane &first, const Plane &second, const Plane &third, int direction) {
    const Line line(first, second);
    const exact::ChordFactors factors = line.factors();
    const double t = direction * line.parameter(third);
    const double scale = batch.kept[chord][s] * scale_of(t, factors.N);
    part[chord][0] = scale * factors.beta;
    part[chord][1] = scale * factors.alpha;
    part[chord][2] = scale * factors.third;
  };
  measure(0, P, Q, R, side);
  measure(1, Q, R, P, side);
  measure(2, R, P, Q, side);
  measure(3, of_second[0], of_second[1], of_second[2], -side);
  batch.part[0][s] = part[0][0] + part[2][1];
  batch.part[1][s] = part[0][1] + part[1][0];
  batch.part[2][s] = part[1][1] + part[2][0];
  batch.part[3][s] = part[0][2] + part[3][0];
  batch.part[4][s] = part[2][2] + part[3][1];
  batch.part[5][s] = part[1][2] + part[3][2];
}

double free_ends_in_integers(const BallSet &balls, uint32_t own, const ArcBatch &batch, uint32_t s) {
  const auto plane = [&](uint32_t slot) { return plane_of(balls.ball(own), balls.ball(batch.other[slot])); };
  const uint32_t end = batch.next[s];
  return free_end(plane(s), plane(batch.previous[s]), batch.root_discriminant[s]) +
         free_end(plane(s), plane(end), batch.root_discriminant[end]);
}

}  // namespace hsp
