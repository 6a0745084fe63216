#include "mesh/sphere_triangulation.hpp"

namespace hsp {
namespace {

// The triangles a q r and b r q at an edge of the first; u is the second.
struct EdgeTriangles {
  SphereTriangle first, second;
  uint32_t u, a, b, q, r;
};

EdgeTriangles triangles_at(Span<const SphereTriangle> triangles, uint32_t t, uint32_t edge) {
  const SphereTriangle &first = triangles[t];
  const uint32_t u = first.neighbour[edge];
  const SphereTriangle &second = triangles[u];
  return {first,
          second,
          u,
          first.point[edge],
          second.point[second.edge_towards(t)],
          first.point[next_corner(edge)],
          first.point[previous_corner(edge)]};
}

}  // namespace

void SphereTriangulation::carve(Workspace &workspace, uint32_t points) {
  const uint64_t triangles = 2 * uint64_t{points};  // 2 n - 4
  point_ = workspace.take<RoundedDirection>(points);
  triangle_at_ = workspace.take<uint32_t>(points);
  triangle_ = workspace.take<SphereTriangle>(triangles);
  stack_ = workspace.take<uint32_t>(triangles);
  crossing_ = workspace.take<Pair>(triangles + 2);
}

// Three perpendicular directions that hardly ever are directions of the input, from a quaternion of small integers.
Vec3 SphereTriangulation::octahedron_corner(uint32_t turn, uint32_t k) {
  const double w = 7.0 + turn;
  const double x = 3.0 + 2.0 * turn;
  const double y = 5.0 - turn;
  const double z = 2.0 + 3.0 * turn;
  const double length_squared = w * w + x * x + y * y + z * z;
  const Vec3 axis = k < 2   ? Vec3{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)}
                    : k < 4 ? Vec3{2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)}
                            : Vec3{2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z};
  return ((k & 1) == 0 ? 1.0 : -1.0) / length_squared * axis;
}

void SphereTriangulation::start(uint32_t turn) {
  point_count_ = octahedron_points;
  for (uint32_t k = 0; k < octahedron_points; ++k) point_[k] = rounded(octahedron_corner(turn, k));
  // Triangle t lies in the octant whose negative axes are the bits of t; its corners are on the first, second and third
  // axis, the last two exchanged where an odd number is negative. Its neighbours differ in one bit.
  triangle_count_ = 8;
  for (uint32_t t = 0; t < 8; ++t) {
    const uint32_t on_axis[3] = {t & 1, 2 + (t >> 1 & 1), 4 + (t >> 2 & 1)};
    const bool odd = ((t ^ t >> 1 ^ t >> 2) & 1) != 0;
    const uint32_t axis[3] = {0, odd ? 2U : 1U, odd ? 1U : 2U};
    SphereTriangle triangle{};
    for (uint32_t c = 0; c < 3; ++c) {
      triangle.point[c] = on_axis[axis[c]];
      triangle.neighbour[c] = t ^ (1U << axis[c]);
    }
    set_triangle(t, triangle);
  }
  last_ = 0;
  flipped_ = false;
}

void SphereTriangulation::set_triangle(uint32_t t, const SphereTriangle &triangle) {
  triangle_[t] = triangle;
  for (const uint32_t p : triangle.point) triangle_at_[p] = t;
}

uint32_t SphereTriangulation::edge_before(const SphereTriangle &triangle, const RoundedDirection &p) const {
  uint32_t e = 0;
  while (e < 3 &&
         orientation(point_[triangle.point[next_corner(e)]], point_[triangle.point[previous_corner(e)]], p) >= 0)
    ++e;
  return e;
}

// Walks towards the point. Among Delaunay triangles the walk ends; after too many steps all triangles are tried.
uint32_t SphereTriangulation::locate(const RoundedDirection &p) const {
  uint32_t t = last_;
  for (uint32_t step = 0; step < triangle_count_; ++step) {
    const uint32_t edge = edge_before(triangle_[t], p);
    if (edge == 3) return t;
    t = triangle_[t].neighbour[edge];
  }
  for (t = 0; t < triangle_count_; ++t) {
    if (edge_before(triangle_[t], p) == 3) return t;
  }
  return 0;  // not reached: the triangles cover the sphere
}

uint32_t SphereTriangulation::insert(const RoundedDirection &p) {
  const uint32_t t = locate(p);
  last_ = t;
  const SphereTriangle &triangle = triangle_[t];
  bool on_edge[3];
  for (uint32_t e = 0; e < 3; ++e) {
    const RoundedDirection &a = point_[triangle.point[next_corner(e)]];
    on_edge[e] = orientation(a, point_[triangle.point[previous_corner(e)]], p) == 0;
  }
  for (uint32_t c = 0; c < 3; ++c) {
    if (point_[triangle.point[c]] == p || (on_edge[next_corner(c)] && on_edge[previous_corner(c)])) {
      return triangle.point[c];
    }
  }
  const uint32_t added = point_count_++;
  point_[added] = p;
  stacked_ = 0;
  const uint32_t edge = on_edge[0] ? 0U : on_edge[1] ? 1U : on_edge[2] ? 2U : 3U;
  if (edge < 3) {
    split_edge(t, edge, added);
  } else {
    split_triangle(t, added);
  }
  restore_around(added);
  return added;
}

void SphereTriangulation::replace_neighbour(uint32_t t, uint32_t old, uint32_t by) {
  triangle_[t].neighbour[triangle_[t].edge_towards(old)] = by;
}

void SphereTriangulation::split_triangle(uint32_t t, uint32_t p) {
  const SphereTriangle old = triangle_[t];
  const uint32_t part[3] = {t, triangle_count_, triangle_count_ + 1};
  triangle_count_ += 2;
  for (uint32_t e = 0; e < 3; ++e) {
    const uint32_t next = next_corner(e);
    const uint32_t previous = previous_corner(e);
    set_triangle(part[e], {{p, old.point[next], old.point[previous]},
                           {old.neighbour[e], part[next], part[previous]},
                           {old.fixed[e], false, false}});
    replace_neighbour(old.neighbour[e], t, part[e]);
    push(part[e]);
  }
}

// The point divides the edge, so both triangles there become two.
//        a                 a
//     t     b    ->     t1 | t2
//    q ----- r         q - p - r      below likewise
void SphereTriangulation::split_edge(uint32_t t, uint32_t edge, uint32_t p) {
  const auto [above, below, u, a, b, q, r] = triangles_at(triangle_, t, edge);
  const uint32_t t2 = triangle_count_;
  const uint32_t u2 = triangle_count_ + 1;
  triangle_count_ += 2;
  const uint32_t across_rb = below.corner_of(q);
  const uint32_t across_bq = below.corner_of(r);
  const uint32_t across_ra = above.corner_of(q);
  const uint32_t across_aq = above.corner_of(r);
  const bool fixed = above.fixed[edge];
  set_triangle(t, {{p, a, q}, {above.neighbour[across_aq], u, t2}, {above.fixed[across_aq], fixed, false}});
  set_triangle(t2, {{p, r, a}, {above.neighbour[across_ra], t, u2}, {above.fixed[across_ra], false, fixed}});
  set_triangle(u, {{p, q, b}, {below.neighbour[across_bq], u2, t}, {below.fixed[across_bq], false, fixed}});
  set_triangle(u2, {{p, b, r}, {below.neighbour[across_rb], t2, u}, {below.fixed[across_rb], fixed, false}});
  replace_neighbour(above.neighbour[across_ra], t, t2);
  replace_neighbour(below.neighbour[across_rb], u, u2);
  push(t);
  push(t2);
  push(u);
  push(u2);
}

// Whether the two triangles of an edge form a strictly convex quadrilateral.
bool SphereTriangulation::may_flip(uint32_t t, uint32_t edge) const {
  const SphereTriangle &one = triangle_[t];
  if (one.fixed[edge]) return false;
  const uint32_t u = one.neighbour[edge];
  const uint32_t a = one.point[edge];
  const uint32_t b = triangle_[u].point[triangle_[u].edge_towards(t)];
  return side(a, one.point[next_corner(edge)], b) > 0 && side(a, b, one.point[previous_corner(edge)]) > 0;
}

bool SphereTriangulation::wants_flip(uint32_t t, uint32_t edge) const {
  const SphereTriangle &one = triangle_[t];
  const SphereTriangle &other = triangle_[one.neighbour[edge]];
  const uint32_t b = other.point[other.edge_towards(t)];
  return height_above(point_[one.point[0]], point_[one.point[1]], point_[one.point[2]], point_[b]) > 0 &&
         may_flip(t, edge);
}

// The edge q r of the triangles a q r and b r q gives way to a b: afterwards they are a q b and a b r.
void SphereTriangulation::flip(uint32_t t, uint32_t edge) {
  const auto [one, other, u, a, b, q, r] = triangles_at(triangle_, t, edge);
  const uint32_t opposite_q = next_corner(edge);  // edge r a
  const uint32_t opposite_r = previous_corner(edge);
  const uint32_t opposite_r_below = other.corner_of(r);  // edge q b
  const uint32_t opposite_q_below = other.corner_of(q);
  set_triangle(t, {{a, q, b},
                   {other.neighbour[opposite_r_below], u, one.neighbour[opposite_r]},
                   {other.fixed[opposite_r_below], false, one.fixed[opposite_r]}});
  set_triangle(u, {{a, b, r},
                   {other.neighbour[opposite_q_below], one.neighbour[opposite_q], t},
                   {other.fixed[opposite_q_below], one.fixed[opposite_q], false}});
  replace_neighbour(other.neighbour[opposite_r_below], u, t);
  replace_neighbour(one.neighbour[opposite_q], t, u);
}

// Every flip moves the surface of the triangles outwards, so there is an end of them. The stack holds triangles around
// p, each at most once.
void SphereTriangulation::restore_around(uint32_t p) {
  while (stacked_ > 0) {
    const uint32_t t = stack_[--stacked_];
    const uint32_t edge = triangle_[t].corner_of(p);
    if (!wants_flip(t, edge)) continue;
    const uint32_t u = triangle_[t].neighbour[edge];
    flip(t, edge);
    push(t);
    push(u);
  }
}

bool SphereTriangulation::has_three_triangles(uint32_t p) const {
  uint32_t t = triangle_at_[p];
  for (int step = 0; step < 3; ++step) t = triangle_[t].neighbour[next_corner(triangle_[t].corner_of(p))];
  return t == triangle_at_[p];
}

// Flips one edge at p, so that p has one edge fewer.
bool SphereTriangulation::flip_edge_of(uint32_t p) {
  const uint32_t first = triangle_at_[p];
  uint32_t t = first;
  do {
    const uint32_t edge = next_corner(triangle_[t].corner_of(p));
    if (may_flip(t, edge)) {
      flip(t, edge);
      return true;
    }
    t = triangle_[t].neighbour[edge];
  } while (t != first);
  return false;
}

// The last triangle takes over its number.
void SphereTriangulation::remove_triangle(uint32_t t) {
  const uint32_t last = --triangle_count_;
  if (t == last) return;
  set_triangle(t, triangle_[last]);
  for (const uint32_t neighbour : triangle_[t].neighbour) replace_neighbour(neighbour, last, t);
}

bool SphereTriangulation::remove(uint32_t p) {
  flipped_ = true;
  while (!has_three_triangles(p)) {
    if (!flip_edge_of(p)) return false;
  }
  uint32_t around[3];
  SphereTriangle whole{};
  around[0] = triangle_at_[p];
  for (uint32_t k = 0; k < 3; ++k) {
    const SphereTriangle &part = triangle_[around[k]];
    const uint32_t corner = part.corner_of(p);
    whole.point[k] = part.point[next_corner(corner)];
    whole.neighbour[previous_corner(k)] = part.neighbour[corner];
    whole.fixed[previous_corner(k)] = part.fixed[corner];
    if (k < 2) around[k + 1] = part.neighbour[next_corner(corner)];
  }
  if (side(whole.point[0], whole.point[1], whole.point[2]) <= 0) return false;
  for (uint32_t k = 0; k < 3; ++k) replace_neighbour(whole.neighbour[previous_corner(k)], around[k], around[0]);
  set_triangle(around[0], whole);
  last_ = 0;
  const bool ascending = around[1] < around[2];
  remove_triangle(around[ascending ? 2 : 1]);
  remove_triangle(around[ascending ? 1 : 2]);
  return true;
}

void SphereTriangulation::restore_all() {
  constexpr int most_sweeps = 8;
  bool again = flipped_;
  for (int sweep = 0; again && sweep < most_sweeps; ++sweep) {
    again = false;
    for (uint32_t t = 0; t < triangle_count_; ++t) {
      for (uint32_t e = 0; e < 3; ++e) {
        if (!wants_flip(t, e)) continue;
        flip(t, e);
        again = true;
      }
    }
  }
}

bool SphereTriangulation::find_edge(uint32_t a, uint32_t b, TriangleEdge &found) const {
  const uint32_t first = triangle_at_[a];
  uint32_t t = first;
  do {
    const uint32_t corner = triangle_[t].corner_of(a);
    if (triangle_[t].point[next_corner(corner)] == b) {
      found = {t, previous_corner(corner)};
      return true;
    }
    t = triangle_[t].neighbour[next_corner(corner)];
  } while (t != first);
  return false;
}

}  // namespace hsp
