#include "cells/power_cell.hpp"

#include "core/disjoint_sets.hpp"

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

// The planes of all others in the game that come as near to the ball's centre as any point of the cube.
uint32_t PowerCell::list_candidates(double reach) {
  const Member own = placed_[member_];
  const double limit = reach * reach;
  const uint32_t members = members_.size();
  const Member *const placed = placed_.data();
  const uint8_t *const out_of_game = out_of_game_.data();
  Candidate *const candidates = candidates_.data();
  uint32_t count = 0;
  for (uint32_t m = 0; m < members; ++m) {
    if (m == member_ || out_of_game[m] != 0) continue;
    const Vec3 v = placed[m].offset - own.offset;
    const double length = dot(v, v);
    const double h = length + (own.radius - placed[m].radius) * (own.radius + placed[m].radius);
    const double distance = h * std::fabs(h) / length;
    candidates[count] = {distance, m};
    count += distance > limit ? 0 : 1;
  }
  return count;
}

// Restores a heap, nearest plane first, after its item `hole` has been replaced.
void PowerCell::sift_down(uint32_t hole, uint32_t count) {
  Candidate *const items = candidates_.data();
  const Candidate item = items[hole];
  for (uint32_t child = 2 * hole + 1; child < count; child = 2 * hole + 1) {
    if (child + 1 < count && items[child + 1].distance < items[child].distance) ++child;
    if (!(items[child].distance < item.distance)) break;
    items[hole] = items[child];
    hole = child;
  }
  items[hole] = item;
}

void PowerCell::build(uint32_t k) {
  member_ = k;
  parts_ = 0;
  if (out_of_game_[k] != 0) return polytope_.make_empty();
  const Member own = placed_[k];
  centre_ = 2.0 * own.offset;
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
    planes_[number] = CubeFrame::between(own.offset, own.radius, placed_[m].offset, placed_[m].radius);
    const uint32_t beyond = polytope_.find_beyond(planes_[number], frame_, [&](const PolytopeVertex &vertex) {
      return PowerPredicates(*balls_, ball(), frame_)
          .side_of(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]), plane(number));
    });
    if (beyond == 0) continue;
    if (beyond == polytope_.size()) {
      out_of_game_[k] = 1;
      return polytope_.make_empty();
    }
    polytope_.cut(number, planes_.data(), frame_);
    reach = polytope_.reach() + slack;
  }
}

bool PowerCell::is_outside(const PolytopeVertex &vertex) const {
  const double r = balls_->r[ball()];
  const int outside = frame_.outside(vertex.squared, vertex.at.doubt, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_outside(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]));
}

// Both ends are outside.
bool PowerCell::edge_is_free(uint32_t v, uint32_t k) const {
  const PolytopeVertex &from = polytope_[v];
  const PolytopeVertex &to = polytope_[from.neighbour[k]];
  const double r = balls_->r[ball()];
  const int outside = frame_.segment_outside(from.at, from.squared, to.at, to.squared, centre_, 4 * r * r);
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
    const double excess = vertices[v].squared - W;
    const bool is_free = excess > doubt || (!(excess < -doubt) && is_outside(vertices[v]));
    outside[v] = is_free ? 8 : 0;
    part[v] = is_free ? v : no_id;
    free_vertices += is_free ? 1 : 0;
  }
  if (free_vertices == 0) return;
  // As CubeFrame::segment_outside() has it, and certain for most edges that are free.
  const auto is_certainly_free = [&](const PolytopeVertex &from, const PolytopeVertex &to) {
    const Vec3 edge = to.at.y - from.at.y;
    const double length = dot(edge, edge), along = dot(centre - from.at.y, edge);
    if (along <= 0.0) return from.squared - W > doubt;
    if (along >= length) return to.squared - W > doubt;
    return (from.squared - W - doubt) * length > along * along;
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
      if (!is_certainly_free(from, to) && !edge_is_free(v, k)) continue;
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
