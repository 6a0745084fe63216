#include "periodic/periodic_records.hpp"

#include "measure/areas.hpp"

namespace hsp {
namespace {

// The shift from a ball's place in the box to this ball or image of the grid.
BoxShift shift_of_grid_ball(const PeriodicUnion &periodic, uint32_t grid_ball) {
  return periodic.images().shift_of(periodic.balls().caller[grid_ball]);
}

ClosedHalfEdge circle_across(const PeriodicUnion &periodic, ClosedHalfEdge own) {
  ClosedHalfEdge found = own;
  static_cast<void>(periodic.find_across(own, found));  // it is there: faces have been joined across it
  return found;
}

}  // namespace

// The listed vertex is the same one as seen on its first ball, at the place of that ball.
MovedRecord listed_vertex(const PeriodicUnion &periodic, uint32_t vertex) {
  const RankedBits &listed = periodic.listed_vertices();
  if (listed.has(vertex)) return {listed.rank(vertex), {}};
  const Boundary &b = periodic.boundary();
  const OrderedVertex seen = periodic.in_listed_order(b.vertex(vertex));
  const BoxShift shift = shift_of_grid_ball(periodic, seen.ball[0]);
  const ImagesInGrid images(periodic.grid(), periodic.images());
  uint32_t wanted[3];
  for (int t = 0; t < 3; ++t) wanted[t] = images.moved_back(seen.ball[t], seen.ball[0]);
  for (const uint32_t e : b.half_edges(wanted[0])) {
    const uint32_t candidate = b.half_edge(e).vertex;
    const OrderedVertex there = periodic.in_listed_order(b.vertex(candidate));
    if (there.sign == seen.sign && there.ball[0] == wanted[0] && there.ball[1] == wanted[1] &&
        there.ball[2] == wanted[2]) {
      return {listed.rank(candidate), shift};
    }
  }
  return {no_id, {}};
}

MovedRecord listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge) {
  const RankedBits &listed = periodic.listed_half_edges();
  if (listed.has(half_edge)) return {listed.rank(half_edge), {}};
  return {listed.rank(periodic.half_edge_across(ball, half_edge)),
          shift_of_grid_ball(periodic, periodic.boundary().half_edge(half_edge).circle)};
}

MovedRecord face_across(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge) {
  const Boundary &b = periodic.boundary();
  return {b.face_of(periodic.half_edge_across(ball, half_edge)),
          shift_of_grid_ball(periodic, b.half_edge(half_edge).circle)};
}

double angle_of_listed_arc(const PeriodicUnion &periodic, uint32_t ball, uint32_t half_edge) {
  const Boundary &b = periodic.boundary();
  const uint32_t other = b.half_edge(half_edge).circle;
  if (periodic.balls().ranks_before(ball, other)) return angle_of(periodic.balls(), b, ball, half_edge);
  const uint32_t across = periodic.half_edge_across(ball, half_edge);
  return angle_of(periodic.balls(), b, b.ball_of(across), across);
}

MovedRecord listed_circle(const PeriodicUnion &periodic, ClosedHalfEdge own) {
  const Boundary &b = periodic.boundary();
  const RankedBits &listed = periodic.listed_circles();
  const uint32_t ball = periodic.balls().caller[b.ball_of(own)];
  const uint32_t other = periodic.balls().caller[b.neighbour(own)];
  if (periodic.is_listed(ball, other)) return {listed.rank(own.circle()), {}};
  return {listed.rank(circle_across(periodic, own).circle()), periodic.images().shift_of(other)};
}

MovedRecord face_across(const PeriodicUnion &periodic, ClosedHalfEdge own) {
  const Boundary &b = periodic.boundary();
  return {b.face_of_loop(b.loop_of(circle_across(periodic, own))), shift_of_grid_ball(periodic, b.neighbour(own))};
}

}  // namespace hsp
