#include "cells/power_cell.hpp"

#include "core/disjoint_sets.hpp"
#include "core/sorting.hpp"

namespace hsp {

void PowerCell::carve(Workspace &workspace, uint32_t balls) {
  polytope_.carve(workspace, balls);
  planes_ = workspace.take<UnitPlane>(PowerPolytope::most_planes(balls));
  placed_ = workspace.take<Member>(balls);
  candidates_ = workspace.take<Candidate>(balls);
  out_of_game_ = workspace.take<uint8_t>(balls);
  part_ = workspace.take<uint32_t>(PowerPolytope::most_vertices(balls));
  free_edges_ = workspace.take<uint8_t>(PowerPolytope::most_vertices(balls));
}

void PowerCell::enter(const BallSet &balls, const CubeFrame &frame, Span<const uint32_t> members) {
  balls_ = &balls;
  frame_ = frame;
  members_ = members;
  for (uint32_t side = 0; side < cube_sides; ++side) planes_[side] = CubeFrame::side_in_doubles(side, frame.side());
  for (uint32_t k = 0; k < members.size(); ++k) {
    const Vec3 offset = frame.offset_of(balls, members[k]);
    const double radius = balls.r[members[k]];
    placed_[k] = {offset, radius, dot(offset, offset) - radius * radius};
    out_of_game_[k] = 0;
  }
}

// The power to ball j less that to ball i is, but for a factor, g_j - g_i - (c_j - c_i).y with g = |c|^2 - r^2 and
// centres from that of the cube. Its mean over the cube is that at y = 0.
void PowerCell::drop_dominated() {
  const double doubt = 64 * unit_roundoff * frame_.side() * frame_.side();
  for (uint32_t a = 0; a < members_.size(); ++a) {
    const Member &first = placed_[a];
    for (uint32_t b = a + 1; b < members_.size(); ++b) {
      const double mean = placed_[b].power - first.power;
      const Vec3 v = placed_[b].offset - first.offset;
      const double spread = frame_.side() * (std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z));
      if (spread == 0.0) {
        const bool first_wins = first.radius != placed_[b].radius ? first.radius > placed_[b].radius
                                                                  : balls_->ranks_before(members_[a], members_[b]);
        out_of_game_[first_wins ? b : a] = 1;
      } else if (mean > spread + doubt) {
        out_of_game_[b] = 1;
      } else if (mean < -spread - doubt) {
        out_of_game_[a] = 1;
      }
    }
  }
}

// Marks the vertices that lie beyond a plane. Returns whether there are any; all: there are no others.
bool PowerCell::find_beyond(uint32_t number, bool &all) {
  bool any = false;
  all = true;
  const UnitPlane &S = planes_[number];
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    const PolytopeVertex &vertex = polytope_[v];
    int side = frame_.side_of(vertex.at, S);
    if (side == 0) {
      const PowerPredicates exact(*balls_, ball(), frame_);
      side = exact.side_of(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]), plane(number));
    }
    polytope_.set_beyond(v, side < 0);
    any |= side < 0;
    all &= side < 0;
  }
  return any;
}

// No vertex is farther from the ball's centre.
double PowerCell::farthest() const {
  double squared = 0.0, doubt = 0.0;
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    const PlacedPoint &at = polytope_[v].at;
    const Vec3 y = at.y - centre_;
    const double distance = dot(y, y);
    squared = distance > squared ? distance : squared;
    doubt = at.doubt > doubt ? at.doubt : doubt;
  }
  return std::sqrt(squared) + doubt + 2 * frame_.plane_doubt();
}

void PowerCell::build(uint32_t k) {
  member_ = k;
  parts_ = 0;
  if (out_of_game_[k] != 0) return polytope_.make_empty();
  const Member own = placed_[k];
  centre_ = 2.0 * own.offset;
  uint32_t count = 0;
  for (uint32_t m = 0; m < members_.size(); ++m) {
    if (m == k || out_of_game_[m] != 0) continue;
    const uint32_t number = cube_sides + m;
    const UnitPlane S = CubeFrame::between(own.offset, own.radius, placed_[m].offset, placed_[m].radius);
    planes_[number] = S;
    candidates_[count++] = {S.h - dot(S.v, centre_), number};
  }
  // The planes that cut most come first, and none follows that is farther than all that is left.
  sort_in_place(candidates_.part(0, count), [](const Candidate &a, const Candidate &b) {
    return a.distance < b.distance || (a.distance == b.distance && a.plane < b.plane);
  });
  polytope_.start(frame_.side());
  double reach = farthest();
  for (uint32_t c = 0; c < count; ++c) {
    if (candidates_[c].distance > reach) break;
    bool all = false;
    if (!find_beyond(candidates_[c].plane, all)) continue;
    if (all) {
      out_of_game_[k] = 1;
      return polytope_.make_empty();
    }
    polytope_.cut(candidates_[c].plane, planes_.data(), frame_);
    reach = farthest();
  }
}

bool PowerCell::is_outside(const PolytopeVertex &vertex) const {
  const Vec3 y = vertex.at.y - centre_;
  const double r = balls_->r[ball()];
  const int outside = frame_.outside(dot(y, y), vertex.at.doubt, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_outside(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]));
}

// Both ends are outside.
bool PowerCell::edge_is_free(uint32_t v, uint32_t k) const {
  const PolytopeVertex &from = polytope_[v];
  const PolytopeVertex &to = polytope_[from.neighbour[k]];
  const int outside = frame_.segment_outside(from.at, to.at, centre_, balls_->r[ball()]);
  if (outside != 0) return outside > 0;
  const uint32_t a_plane = from.plane[k == 0 ? 1 : 0], b_plane = from.plane[k == 2 ? 1 : 2];
  uint32_t last = 0;
  while (to.plane[last] == a_plane || to.plane[last] == b_plane) ++last;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_free(plane(a_plane), plane(b_plane), plane(from.plane[k]), plane(to.plane[last]));
}

void PowerCell::find_free_parts() {
  const uint32_t size = polytope_.size();
  DisjointSets sets(part_.part(0, size));
  sets.reset();
  uint8_t *const outside = free_edges_.data();
  for (uint32_t v = 0; v < size; ++v) outside[v] = is_outside(polytope_[v]) ? 8 : 0;
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] == 0) continue;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t w = polytope_[v].neighbour[k];
      if (w < v || outside[w] == 0 || !edge_is_free(v, k)) continue;
      const PolytopeVertex &to = polytope_[w];
      const uint32_t back = to.neighbour[0] == v ? 0 : to.neighbour[1] == v ? 1 : 2;
      outside[v] |= static_cast<uint8_t>(1U << k);
      outside[w] |= static_cast<uint8_t>(1U << back);
      static_cast<void>(sets.join(v, w));
    }
  }
  // Numbers instead of representatives, which are the smallest of their sets.
  parts_ = 0;
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] == 0) continue;
    part_[v] = sets.root(v);
  }
  for (uint32_t v = 0; v < size; ++v) {
    if (outside[v] == 0) {
      part_[v] = no_id;
    } else {
      part_[v] = part_[v] == v ? parts_++ : part_[part_[v]];
    }
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
