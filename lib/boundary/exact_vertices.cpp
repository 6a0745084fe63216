#include "sphere/vertex_finder.hpp"

namespace hsp {

namespace {

// A plane that belongs to no ball lies nowhere.
bool lies_inside(const BallSet &balls, uint32_t inner, uint32_t outer) {
  if (inner == no_id || outer == no_id) return false;
  return exact::pair_relation(balls.ball(inner), balls.ball(outer)) == exact::PairRelation::first_in_second;
}

}  // namespace

bool find_vertices_exactly(const BallSet &balls, const Caps &caps, const CapTests &tests, uint32_t j, uint32_t k,
                           FixedVector<VertexRecord> &vertices) {
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane &P = caps.plane[j];
  const exact::Plane &Q = caps.plane[k];
  const exact::Sign crossing = predicates.crossing(P, Q);
  if (crossing.sign < 0) return false;

  bool free[2] = {true, true};
  bool tied[2] = {crossing.tied, crossing.tied};
  for (uint32_t t = 0; t < tests.count && (free[0] || free[1]); ++t) {
    const uint32_t l = tests.cap[t];
    if (l == j || l == k) continue;
    const exact::PointStatus status = predicates.point_status(P, Q, caps.plane[l]);
    // Balls inside the origin ball have no cap here, so only the other two are left to ask.
    const bool ties = (status.tied[0] || status.tied[1]) && !lies_inside(balls, caps.ball[l], caps.ball[j]) &&
                      !lies_inside(balls, caps.ball[l], caps.ball[k]);
    for (int point = 0; point < 2; ++point) {
      free[point] = free[point] && status.side[point] < 0;
      tied[point] = tied[point] || (ties && status.tied[point]);
    }
  }
  for (uint32_t point = 0; point < 2; ++point) {
    if (!free[point]) continue;
    vertices.push({{caps.origin, caps.ball[j], caps.ball[k]},
                   (point == 1 ? VertexRecord::positive_bit : 0U) | (tied[point] ? VertexRecord::tied_bit : 0U)});
  }
  return true;
}

}  // namespace hsp
