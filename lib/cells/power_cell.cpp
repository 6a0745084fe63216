#include "cells/power_cell.hpp"

#include <initializer_list>

#include "core/disjoint_sets.hpp"

namespace hsp {

void PowerCell::carve(Workspace &workspace, uint32_t balls) {
  polytope_.carve(workspace, balls);
  planes_ = workspace.take<UnitPlane>(PowerPolytope::most_planes(balls));
  for (Span<double> *numbers : {&x_, &y_, &z_, &radius_, &power_}) {
    *numbers = workspace.take<double>(static_cast<uint64_t>(balls) + 3);
    for (double &number : *numbers) number = 0.0;  // four are read at once, and some may not be those of balls
  }
  candidates_ = workspace.take<PlaneCandidate>(static_cast<uint64_t>(balls) + 4);
  in_game_ = workspace.take<uint64_t>(static_cast<uint64_t>(balls) / 64 + 1);
  part_ = workspace.take<uint32_t>(PowerPolytope::most_vertices(balls));
  free_edges_ = workspace.take<uint8_t>(PowerPolytope::most_vertices(balls));
  wide_code_ = workspace.wide_code();
}

void PowerCell::enter(const BallSet &balls, const CubeFrame &frame, Span<const uint32_t> members) {
  balls_ = &balls;
  frame_ = frame;
  members_ = members;
  for (uint32_t side = 0; side < cube_sides; ++side) planes_[side] = CubeFrame::side_in_doubles(side, frame.side());
  for (uint32_t k = 0; k <= members.size() / 64; ++k) in_game_[k] = ~UINT64_C(0);
  in_game_[members.size() / 64] = ~(~UINT64_C(0) << members.size() % 64);
  for (uint32_t k = 0; k < members.size(); ++k) {
    const Vec3 offset = frame.offset_of(balls, members[k]);
    const double radius = balls.r[members[k]];
    x_[k] = offset.x;
    y_[k] = offset.y;
    z_[k] = offset.z;
    radius_[k] = radius;
    power_[k] = dot(offset, offset) - radius * radius;
  }
}

// As find_dominance() has it.
uint64_t PowerCell::dominance(uint32_t a, uint32_t first, double doubt) const {
#if HSP_AVX2
  if (wide_code_) return find_dominance_avx2(numbers(), a, first, frame_.side(), doubt);
#endif
  return find_dominance<baseline_lanes>(numbers(), a, first, frame_.side(), doubt);
}

// The power to ball j less that to ball i is, but for a factor, g_j - g_i - (c_j - c_i).y with g = |c|^2 - r^2 and
// centres from that of the cube. Its mean over the cube is that at y = 0, and nowhere in the cube does it differ from
// that by more than the side times the sum of the parts of c_j - c_i.
void PowerCell::drop_dominated() {
  const double doubt = 64 * unit_roundoff * frame_.side() * frame_.side();
  const uint32_t members = members_.size();
  for (uint32_t a = 0; a < members; ++a) {
    for (uint32_t first = a + 1; first < members; first += 64) {
      for (uint64_t left = dominance(a, first, doubt); left != 0; left &= left - 1) {
        const uint32_t b = first + static_cast<uint32_t>(std::countr_zero(left));
        bool first_wins = power_[b] > power_[a];
        if (x_[a] == x_[b] && y_[a] == y_[b] && z_[a] == z_[b]) {
          first_wins =
              radius_[a] != radius_[b] ? radius_[a] > radius_[b] : balls_->ranks_before(members_[a], members_[b]);
        }
        take_out_of_game(first_wins ? b : a);
      }
    }
  }
}

// The planes of all others in the game that come as near to the ball's centre as any point of the cube.
uint32_t PowerCell::list_candidates(double reach) {
#if HSP_AVX2
  if (wide_code_) {
    return list_candidates_avx2(numbers(), in_game_.data(), member_, reach * reach, candidates_.data());
  }
#endif
  return hsp::list_candidates<baseline_lanes>(numbers(), in_game_.data(), member_, reach * reach, candidates_.data());
}

// Restores a heap, nearest plane first, after its item `hole` has been replaced.
void PowerCell::sift_down(uint32_t hole, uint32_t count) {
  PlaneCandidate *const items = candidates_.data();
  const PlaneCandidate item = items[hole];
  for (uint32_t child = 2 * hole + 1; child < count; child = 2 * hole + 1) {
    if (child + 1 < count && items[child + 1].distance < items[child].distance) ++child;
    if (!(items[child].distance < item.distance)) break;
    items[hole] = items[child];
    hole = child;
  }
  items[hole] = item;
}

// Whether the middle of the polytope is certainly on the near side of the planes of the first candidates. The value of
// a plane is as in drop_dominated(), and the distance of two centres is below 4 sides.
bool PowerCell::has_certain_point(uint32_t candidates) const {
  const Vec3 middle = polytope_.middle(), centre = offset(member_);
  const double side = frame_.side(), power = power_[member_];
  const double doubt = (8 * polytope_.most_doubt() + 512 * unit_roundoff * side) * side;
  const PlaneCandidate *const items = candidates_.data();
  for (uint32_t c = 0; c < candidates; ++c) {
    const uint32_t m = items[c].member;
    if (!(power_[m] - power - dot(offset(m) - centre, middle) > doubt)) return false;
  }
  return true;
}

void PowerCell::cut_out(uint32_t k, bool unless_covered) {
  member_ = k;
  parts_ = 0;
  if (!is_in_game(k)) return polytope_.make_empty();
  const Vec3 own = offset(k);
  const double radius = radius_[k];
  centre_ = 2.0 * own;
  polytope_.start(frame_.side(), centre_);
  const double slack = 2 * frame_.plane_doubt();
  double reach = polytope_.reach() + slack;
  uint32_t count = list_candidates(reach);
  // The planes that cut most come first, and none follows that is farther than all that is left.
  for (uint32_t hole = count / 2; hole-- > 0;) sift_down(hole, count);
  while (count > 0 && candidates_[0].distance <= reach * reach) {
    const uint32_t m = candidates_[0].member, number = cube_sides + m;
    candidates_[0] = candidates_[--count];
    sift_down(0, count);
    planes_[number] = CubeFrame::between(own, radius, offset(m), radius_[m]);
    const uint32_t beyond = polytope_.find_beyond(planes_[number], frame_, [&](const PolytopeVertex &vertex) {
      return PowerPredicates(*balls_, ball(), frame_)
          .side_of(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]), plane(number));
    });
    if (beyond == 0) continue;
    if (beyond == polytope_.size()) {
      take_out_of_game(k);
      return polytope_.make_empty();
    }
    polytope_.cut(number, planes_.data(), frame_);
    reach = polytope_.reach() + slack;
    if (unless_covered && reach < 2 * radius && has_certain_point(count)) return;
  }
}

bool PowerCell::is_outside(uint32_t v) const {
  const PolytopeVertex &vertex = polytope_[v];
  const double r = balls_->r[ball()];
  const int outside = frame_.outside(polytope_.squared(v), vertex.at.doubt, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_outside(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]));
}

// Both ends are outside.
bool PowerCell::edge_is_free(uint32_t v, uint32_t k) const {
  const PolytopeVertex &from = polytope_[v];
  const uint32_t w = from.neighbour[k];
  const PolytopeVertex &to = polytope_[w];
  const double r = balls_->r[ball()];
  const int outside =
      frame_.segment_outside(from.at, polytope_.squared(v), to.at, polytope_.squared(w), centre_, 4 * r * r);
  if (outside != 0) return outside > 0;
  const uint32_t a_plane = from.plane[k == 0 ? 1 : 0], b_plane = from.plane[k == 2 ? 1 : 2];
  uint32_t last = 0;
  while (to.plane[last] == a_plane || to.plane[last] == b_plane) ++last;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_free(plane(a_plane), plane(b_plane), plane(from.plane[k]), plane(to.plane[last]));
}

void PowerCell::find_free_parts() {
  const uint32_t size = polytope_.size();
  uint8_t *const outside = free_edges_.data();
  uint32_t *const part = part_.data();
  parts_ = 0;
  const PolytopeVertex *const vertices = &polytope_[0];
  const Vec3 centre = centre_;
  const double r = balls_->r[ball()];
  const double W = 4 * r * r, doubt = frame_.sphere_doubt(polytope_.most_doubt());
  uint32_t free_vertices = 0;
  for (uint32_t v = 0; v < size; ++v) {
    const double excess = polytope_.squared(v) - W;
    const bool is_free = excess > doubt || (!(excess < -doubt) && is_outside(v));
    outside[v] = is_free ? 8 : 0;
    part[v] = is_free ? v : no_id;
    free_vertices += is_free ? 1 : 0;
  }
  if (free_vertices == 0) return;
  // As CubeFrame::segment_outside() has it, and certain for most edges that are free.
  const auto is_certainly_free = [&](uint32_t v, uint32_t w) {
    const Vec3 from = vertices[v].at.y, edge = vertices[w].at.y - from;
    const double length = dot(edge, edge), along = dot(centre - from, edge);
    if (along <= 0.0) return polytope_.squared(v) - W > doubt;
    if (along >= length) return polytope_.squared(w) - W > doubt;
    return (polytope_.squared(v) - W - doubt) * length > along * along;
  };
  // Until only one set is left, which most cells have in the end, edges join vertices.
  DisjointSets sets(part_.part(0, size));
  uint32_t left = free_vertices;
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] == 0) continue;
    const PolytopeVertex &from = vertices[v];
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t w = from.neighbour[k];
      if (w < v || outside[w] == 0) continue;
      const PolytopeVertex &to = vertices[w];
      if (!is_certainly_free(v, w) && !edge_is_free(v, k)) continue;
      const uint32_t back = to.neighbour[0] == v ? 0 : to.neighbour[1] == v ? 1 : 2;
      outside[v] = static_cast<uint8_t>(outside[v] | 1U << k);
      outside[w] = static_cast<uint8_t>(outside[w] | 1U << back);
      if (left > 1 && sets.join(v, w)) --left;
    }
  }
  if (left == 1) {
    for (uint32_t v = 0; v < size; ++v) part[v] = outside[v] != 0 ? 0 : no_id;
    parts_ = 1;
    return;
  }
  // Numbers instead of representatives, which are the smallest of their sets.
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] != 0) part[v] = sets.root(v);
  }
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] != 0) part[v] = part[v] == v ? parts_++ : part[part[v]];
  }
}

// Whether the part of a plane in the ball lies in a facet whose border is outside the ball.
bool PowerCell::contains_disc(uint32_t number) const {
  const PowerPredicates exact(*balls_, ball(), frame_);
  const double r = balls_->r[ball()];
  const double distance = planes_[number].h - dot(planes_[number].v, centre_);
  if (frame_.outside(distance * distance, frame_.plane_doubt(), 4 * r * r) > 0) return false;
  if (!exact.meets_plane(plane(number))) return false;
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    const PolytopeVertex &vertex = polytope_[v];
    if (!vertex.has(number)) continue;
    for (uint32_t k = 0; k < 3; ++k) {
      if (vertex.plane[k] != number && exact.side_of_disc(plane(number), plane(vertex.plane[k])) < 0) return false;
    }
  }
  return true;
}

// Whether the centre of the ball is on the near side of a plane.
bool PowerCell::has_centre_before(uint32_t number) const {
  const double distance = planes_[number].h - dot(planes_[number].v, centre_);
  if (std::fabs(distance) > 8 * frame_.plane_doubt()) return distance > 0.0;
  return PowerPredicates(*balls_, ball(), frame_).side_of_centre(plane(number)) >= 0;
}

bool PowerCell::meets_ball() const {
  bool centre_inside = true;
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    if (part_[v] == no_id || (free_edges_[v] & 7) != 7) return true;
    for (const uint32_t number : polytope_[v].plane) centre_inside = centre_inside && has_centre_before(number);
  }
  if (centre_inside) return true;
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    for (const uint32_t number : polytope_[v].plane) {
      if (contains_disc(number)) return true;
    }
  }
  return false;
}

}  // namespace hsp
