#include "cells/power_cell.hpp"

#include <bit>
#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {

void PowerCell::carve(Workspace &workspace, uint32_t balls) {
  polytope_.carve(workspace, balls);
  const auto take_numbers = [&](uint64_t count) {
    const Span<double> numbers = workspace.take<double>(count + 7);
    for (double &number : numbers) number = 0.0;  // eight are read at once, some of them behind the last ball
    return numbers;
  };
  for (Span<double> *numbers : {&x_, &y_, &z_, &radius_, &power_, &in_game_}) *numbers = take_numbers(balls);
  for (double **numbers : {&of_planes_.x, &of_planes_.y, &of_planes_.z, &of_planes_.h, &of_planes_.distance}) {
    *numbers = take_numbers(MemberBlocks::places_for(balls)).data();
  }
  blocks_.carve(workspace, balls);
  order_ = workspace.take<PlaneOrder>(1);
  const uint64_t planes = PowerPolytope::most_planes(balls), vertices = PowerPolytope::most_vertices(balls);
  workspace.take_each(planes, planes_, codes_, first_free_);
  of_planes_.nearest = first_free_.data();
  of_planes_.order = order_.data();
  cutters_ = workspace.take<uint32_t>(balls);
  part_ = workspace.take<uint32_t>(vertices);
  waiting_ = workspace.take<uint32_t>(vertices);
  edges_ = workspace.take<EdgeEnds>(vertices + vertices / 2 + edges_behind);
  free_edges_ = workspace.take<uint8_t>(vertices);
  outside_ = workspace.take<uint64_t>(vertices / 64 + 1);
  target_ = workspace.target();
}

void PowerCell::enter(const BallSet &balls, const CubeFrame &frame, Span<const uint32_t> members) {
  balls_ = &balls;
  frame_ = frame;
  members_ = members;
  for (uint32_t side = 0; side < cube_sides; ++side) {
    planes_[side] = CubeFrame::side_in_doubles(side, frame.side());
    codes_[side] = side;
  }
  for (uint32_t k = 0; k < members.size(); ++k) {
    const Vec3 offset = frame.offset_of(balls, members[k]);
    const double radius = balls.r[members[k]];
    x_[k] = offset.x;
    y_[k] = offset.y;
    z_[k] = offset.z;
    radius_[k] = radius;
    power_[k] = dot(offset, offset) - radius * radius;
    in_game_[k] = 1.0;
    codes_[cube_sides + k] = cube_sides + members[k];
  }
  for (uint32_t k = members.size(); k < members.size() + 7; ++k) in_game_[k] = 0.0;
  blocks_.enter(numbers(), frame.side());
}

// The power to ball j less that to ball i is, up to a factor, g_j - g_i - (c_j - c_i).y with g = |c|^2 - r^2 and
// centres relative to that of the cube. Its mean over the cube is its value at y = 0. In the cube it differs from that
// by at most the side times the sum of |components| of c_j - c_i.
void PowerCell::drop_dominated() {
  const double error = 64 * unit_roundoff * frame_.side() * frame_.side();
  const uint32_t members = members_.size();
  for (uint32_t a = 0; a < members; ++a) {
    for (uint32_t first = a + 1; first < members; first += 64) {
      uint64_t left = find_dominance(target_, numbers(), a, first, frame_.side(), error);
      for (; left != 0; left &= left - 1) {
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

// Finds the planes of all members that are not discarded and that are as near to the ball's centre as some point of the
// cube; in blocks, some at a time when they are put in order.
void PowerCell::find_member_planes() {
  const double side = frame_.side();
  const Vec3 corner{side + std::fabs(centre_.x), side + std::fabs(centre_.y), side + std::fabs(centre_.z)};
  const double reach = std::sqrt(dot(corner, corner)) + 2 * frame_.plane_error();
  planes_at_once_ = 0;
  if (!blocks_.is_there()) return find_planes(target_, numbers(), own(), reach * reach, of_planes_);
  blocks_.begin(own(), reach * reach);
  order_[0] = {0, 0};
}

// Puts some of many planes in order, the nearest ones, of which most cells need few; each time four times as many.
// False if all are done with.
bool PowerCell::order_next_planes() {
  const double *const distance = of_planes_.distance;
  const uint32_t members = members_.size();
  if (planes_at_once_ == 0) {
    planes_at_once_ = 32;
  } else if (planes_at_once_ < members) {
    planes_at_once_ *= 4;
  }
  PlaneOrder &order = order_[0];
  do {
    const uint32_t planes = blocks_.is_there() ? blocks_.known() : members;
    // About so many are as near as the nearest of every so many. Planes of blocks may come before those known.
    double most = blocks_.is_there() ? blocks_.nearest_unknown() : done_with;
    for (uint32_t p = 0; p < planes; p += planes_at_once_) most = distance[p] < most ? distance[p] : most;
    order.next = order.count = 0;
    for (uint32_t p = 0; p < planes; ++p) {
      of_planes_.nearest[order.count] = p;
      order.count += distance[p] <= most && distance[p] < done_with ? 1U : 0U;
    }
  } while (order.count == 0 && blocks_.is_there() && blocks_.find_more(target_, of_planes_));
  sort_by_number(
      Span<uint32_t>(of_planes_.nearest, order.count), waiting_, [distance](uint32_t p) { return distance[p]; },
      [this, distance](uint32_t p, uint32_t q) {
        return distance[p] != distance[q] ? distance[p] < distance[q] : member_of_plane(p) < member_of_plane(q);
      });
  return order.count > 0;
}

// Whether the middle of the polytope is certainly on the near side of all planes that may still cut it: then the cell
// is not empty. The distance of two centres is below 4 sides.
bool PowerCell::has_certain_point() const {
  const double side = frame_.side();
  const double error = (8 * polytope_.most_error() + 512 * unit_roundoff * side) * side;
  const Vec3 middle = polytope_.middle();
  if (!blocks_.is_there()) return is_before_all(target_, numbers(), own(), middle, error, of_planes_.distance);
  const Vec3 way = middle - centre_;
  return dot(way, way) * (1.0 + 0x1p-20) + error < blocks_.nearest_unknown() &&
         blocks_.is_before_known(target_, middle, error, of_planes_.distance);
}

// Cuts the power cell out of the cube. The nearest planes come first, as they cut most; when the next one is farther
// than all that is left, the cell is done.
void PowerCell::cut_out(uint32_t k, bool unless_covered) {
  member_ = k;
  parts_ = cutter_count_ = 0;
  if (!is_in_game(k)) return polytope_.make_empty();
  centre_ = 2.0 * offset(k);
  polytope_.start(frame_, centre_);
  find_member_planes();
  const double plane_error = frame_.plane_error(), six_sides = 6 * frame_.side();
  double covered = -1.0;
  for (;;) {
    const double error = polytope_.most_error();
    const double reach_error = error + 2 * plane_error;
    // No distance in the cube is larger than 6 sides.
    const CutMargins margins{error + plane_error, (2 * six_sides + reach_error) * reach_error, covered};
    const uint32_t p = find_cut(target_, polytope_.to_cut(), of_planes_, members_.size(), margins);
    if (p == none_cuts || (p == wants_more && !order_next_planes())) return;
    if (p == wants_more) continue;
    if (p == is_covered) {
      if (has_certain_point()) return;
      covered = -1.0;
      continue;
    }
    const uint32_t m = member_of_plane(p), number = cube_sides + m;
    const UnitPlane S{{of_planes_.x[p], of_planes_.y[p], of_planes_.z[p]}, of_planes_.h[p]};
    planes_[number] = S;
    const CutOff beyond = polytope_.decide_sides(S, frame_, [&](const PolytopeVertex &vertex) {
      return PowerPredicates(*balls_, ball(), frame_)
          .side_of(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]), plane(number));
    });
    if (beyond == CutOff::nothing) continue;
    if (beyond == CutOff::all) {
      take_out_of_game(k);
      return polytope_.make_empty();
    }
    polytope_.cut(number, planes_.data(), frame_);
    cutters_[cutter_count_++] = m;
    covered = unless_covered ? 4 * radius_[k] * radius_[k] : -1.0;
  }
}

Vec3 PowerCell::position(uint32_t vertex) const {
  const BoundedPoint at = polytope_.at(vertex);
  if (at.error < no_certainty) return at.y;
  const PolytopeVertex &of = polytope_[vertex];
  return centre_ + PowerPredicates(*balls_, ball(), frame_)
                       .common_point(plane(of.plane[0]), plane(of.plane[1]), plane(of.plane[2]));
}

bool PowerCell::is_outside(uint32_t v) const {
  const PolytopeVertex &vertex = polytope_[v];
  const double r = balls_->r[ball()];
  const int outside = frame_.outside(polytope_.squared(v), polytope_.at(v).error, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_outside(plane(vertex.plane[0]), plane(vertex.plane[1]), plane(vertex.plane[2]));
}

// Whether an edge whose ends are outside the ball is outside as a whole, by integers.
bool PowerCell::edge_is_free(uint32_t v, uint32_t k) const {
  const PolytopeVertex &from = polytope_[v];
  const uint32_t w = from.neighbour(k);
  const double r = balls_->r[ball()];
  const int outside = frame_.segment_outside(polytope_.at(v), polytope_.squared(v), polytope_.at(w),
                                             polytope_.squared(w), centre_, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball(), frame_)
      .is_free(plane(from.plane[next_of_three(k)]), plane(from.plane[previous_of_three(k)]), plane(from.plane[k]),
               plane(polytope_[w].plane[from.back(k)]));
}

// Finds the vertices outside the ball. Returns how many.
uint32_t PowerCell::find_free_vertices(double limit, double error) {
  const uint32_t size = polytope_.size();
  const PolytopeVertex *const vertices = &polytope_[0];
  uint8_t *const free_edges = free_edges_.data();
  uint32_t *const part = part_.data(), *const first_free = first_free_.data();
  for (uint32_t side = 0; side < cube_sides; ++side) first_free[side] = no_id;
  for (uint32_t k = 0; k < cutter_count_; ++k) first_free[cube_sides + cutters_[k]] = no_id;
  for (uint32_t v = 0; v < size; ++v) {
    free_edges[v] = 0;
    part[v] = no_id;
  }
  uint32_t count = 0;
  // From the last vertices to the first, so that first_free_ ends as the first vertex on each plane.
  for (uint32_t word = (size + 63) / 64; word-- > 0;) {
    const uint32_t left_over = size - 64 * word, some = left_over < 64 ? left_over : 64;
    const SquareSides sides = compare_squares(target_, polytope_.arrays().squared + 64 * word, some, limit, error);
    uint64_t outside = sides.above;
    for (uint64_t left = sides.unsure; left != 0; left &= left - 1) {
      if (is_outside(64 * word + static_cast<uint32_t>(std::countr_zero(left)))) outside |= left & (~left + 1);
    }
    outside_[word] = outside;
    while (outside != 0) {
      const uint32_t bit = 63 - static_cast<uint32_t>(std::countl_zero(outside)), v = 64 * word + bit;
      outside ^= UINT64_C(1) << bit;
      for (const uint32_t number : vertices[v].plane) first_free[number] = v;
      ++count;
    }
  }
  return count;
}

// Lists the edges whose ends are both outside, each once. Returns how many.
uint32_t PowerCell::list_edges() {
  const PolytopeVertex *const vertices = &polytope_[0];
  const uint64_t *const outside = outside_.data();
  EdgeEnds *const edges = edges_.data();
  const uint32_t words = (polytope_.size() + 63) / 64;
  uint32_t count = 0;
  for (uint32_t word = 0; word < words; ++word) {
    for (uint64_t left = outside[word]; left != 0; left &= left - 1) {
      const uint32_t v = 64 * word + static_cast<uint32_t>(std::countr_zero(left));
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t link = vertices[v].link[k], w = link / 4;
        edges[count] = {4 * v + k, link};  // written in any case, counted if the edge is to be listed
        count += static_cast<uint32_t>(outside[w / 64] >> w % 64 & (v < w ? 1U : 0U));
      }
    }
  }
  for (uint32_t k = 0; k < edges_behind; ++k) edges[count + k] = {0, 0};
  return count;
}

// Calls visit(edge) for each edge that is outside the ball as a whole, and notes it in free_edges_.
template <class Visit>
void PowerCell::for_each_free_edge(double limit, double error, Visit visit) {
  uint8_t *const free_edges = free_edges_.data();
  const uint32_t count = list_edges();
  for (uint32_t first = 0; first < count; first += 64) {
    const EdgeEnds *const edges = edges_.data() + first;
    const uint32_t some = count - first < 64 ? count - first : 64;
    const EdgeSides sides = compare_edges(target_, polytope_.arrays(), edges, some, limit, error);
    uint64_t outside = sides.outside;
    for (uint64_t left = sides.unsure; left != 0; left &= left - 1) {
      const uint32_t from = edges[std::countr_zero(left)].from;
      if (edge_is_free(from / 4, from % 4)) outside |= left & (~left + 1);
    }
    for (; outside != 0; outside &= outside - 1) {
      const EdgeEnds edge = edges[std::countr_zero(outside)];
      free_edges[edge.from / 4] = static_cast<uint8_t>(free_edges[edge.from / 4] | 1U << edge.from % 4);
      free_edges[edge.to / 4] = static_cast<uint8_t>(free_edges[edge.to / 4] | 1U << edge.to % 4);
      visit(edge);
    }
  }
}

void PowerCell::find_free_parts() {
  const double r = balls_->r[ball()];
  const double limit = 4 * r * r, error = frame_.sphere_error(polytope_.most_error());
  parts_ = 0;
  const uint32_t free_vertices = find_free_vertices(limit, error);
  if (free_vertices == 0) return;
  if (polytope_.size() <= 64) {
    gather_few(limit, error);
  } else {
    for_each_free_edge(limit, error, [](const EdgeEnds &) {});
    gather_many(free_vertices);
  }
}

// Finds the free parts of up to 64 vertices, with bits for vertices: those that free edges lead to from the first
// vertex without a part.
void PowerCell::gather_few(double limit, double error) {
  uint32_t *const part = part_.data();
  const uint64_t outside = outside_[0];
  uint64_t joined[64];
  for (uint64_t left = outside; left != 0; left &= left - 1) joined[std::countr_zero(left)] = 0;
  for_each_free_edge(limit, error, [&](const EdgeEnds &edge) {
    joined[edge.from / 4] |= UINT64_C(1) << edge.to / 4;
    joined[edge.to / 4] |= UINT64_C(1) << edge.from / 4;
  });
  for (uint64_t without = outside; without != 0;) {
    uint64_t reached = without & (~without + 1);
    for (uint64_t waiting = reached; waiting != 0;) {
      const uint64_t found = joined[std::countr_zero(waiting)] & ~reached;
      reached |= found;
      waiting = (waiting & (waiting - 1)) | found;
    }
    without ^= reached;
    for (; reached != 0; reached &= reached - 1) part[std::countr_zero(reached)] = parts_;
    ++parts_;
  }
}

// The same for any number of vertices, one after another.
void PowerCell::gather_many(uint32_t free_vertices) {
  uint32_t *const part = part_.data(), *const waiting = waiting_.data();
  uint32_t known = 0;
  for (uint32_t start = 0; known < free_vertices; ++start) {
    if ((outside_[start / 64] >> start % 64 & 1) == 0 || part[start] != no_id) continue;
    part[start] = parts_;
    waiting[0] = start;
    uint32_t count = 1;
    for (uint32_t next = 0; next < count; ++next) {
      const uint32_t v = waiting[next];
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t w = polytope_[v].neighbour(k);
        if (!is_free_edge(v, k) || part[w] != no_id) continue;
        part[w] = parts_;
        waiting[count++] = w;
      }
    }
    known += count;
    ++parts_;
  }
}

// Whether a facet whose border is outside the ball contains the disc in which its plane meets the ball. The middle of
// the disc is computed from its distance to the centre of the ball, which is off by less than 8 plane errors, as in
// has_centre_before(). If the plane meets the ball, the distance is not larger than about a side, so that v adds less
// than 16 u s, and rounding less than 64 u s: the middle is off by less than 16 plane errors.
bool PowerCell::contains_disc(uint32_t number) const {
  const PowerPredicates exact(*balls_, ball(), frame_);
  const double r = balls_->r[ball()];
  const UnitPlane &disc = planes_[number];
  const double distance = disc.h - dot(disc.v, centre_);
  const int outside = frame_.outside(distance * distance, 8 * frame_.plane_error(), 4 * r * r);
  if (outside > 0 || (outside == 0 && !exact.meets_plane(plane(number)))) return false;
  const BoundedPoint middle{centre_ + distance * disc.v, 16 * frame_.plane_error()};
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    const PolytopeVertex &vertex = polytope_[v];
    if (!vertex.has(number)) continue;
    for (const uint32_t other : vertex.plane) {
      if (other == number) continue;
      const int side = frame_.side_of(middle, planes_[other]);
      if ((side != 0 ? side : exact.side_of_disc(plane(number), plane(other))) < 0) return false;
    }
  }
  return true;
}

// Whether the centre of the ball is on the near side of a plane.
bool PowerCell::has_centre_before(uint32_t number) const {
  const double distance = planes_[number].h - dot(planes_[number].v, centre_);
  if (std::fabs(distance) > 8 * frame_.plane_error()) return distance > 0.0;
  return PowerPredicates(*balls_, ball(), frame_).side_of_centre(plane(number)) >= 0;
}

// As no vertex is in the ball, first_free_ has a vertex for each plane with a facet.
bool PowerCell::meets_ball() const {
  for (uint32_t v = 0; v < polytope_.size(); ++v) {
    if (part_[v] == no_id || free_edges_[v] != 7) return true;
  }
  const auto any_facet = [&](auto holds) {
    for (uint32_t side = 0; side < cube_sides; ++side) {
      if (first_free(side) != no_id && holds(side)) return true;
    }
    for (uint32_t k = 0; k < cutter_count_; ++k) {
      const uint32_t number = cube_sides + cutters_[k];
      if (first_free(number) != no_id && holds(number)) return true;
    }
    return false;
  };
  return !any_facet([&](uint32_t number) { return !has_centre_before(number); }) ||
         any_facet([&](uint32_t number) { return contains_disc(number); });
}

}  // namespace hsp
