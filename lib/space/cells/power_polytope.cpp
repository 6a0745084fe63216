#include "cells/power_polytope.hpp"

#include <initializer_list>

namespace hsp {
namespace {

// Bit k of a corner's number says on which of the two sides normal to axis k it lies. Corners with an odd number of set
// bits are mirror images of the others: their planes come in the order of axes 0, 2, 1.
constexpr PolytopeVertex cube_corner(uint32_t v) {
  const uint32_t odd = (v ^ v >> 1 ^ v >> 2) & 1;
  const uint32_t second = 1 + odd, third = 2 - odd;
  return {{v & 1, 2 * second + (v >> second & 1), 2 * third + (v >> third & 1)},
          {4 * (v ^ 1), 4 * (v ^ 1U << second) + 2, 4 * (v ^ 1U << third) + 1}};
}
constexpr PolytopeVertex cube_corners[8] = {cube_corner(0), cube_corner(1), cube_corner(2), cube_corner(3),
                                            cube_corner(4), cube_corner(5), cube_corner(6), cube_corner(7)};

}  // namespace

void PowerPolytope::carve(Workspace &workspace, uint32_t balls) {
  const uint64_t most = 2 * most_vertices(balls);
  vertices_ = workspace.take<PolytopeVertex>(most);
  for (double **numbers :
       {&to_cut_.at.x, &to_cut_.at.y, &to_cut_.at.z, &to_cut_.at.error, &to_cut_.at.squared, &to_cut_.at.value}) {
    const Span<double> taken = workspace.take<double>(most + 7);
    for (double &number : taken) number = 0.0;  // eight are read at once, some of them behind the last vertex
    *numbers = taken.data();
  }
  beyond_ = workspace.take<uint64_t>(most / 64 + 1);
  unsure_ = workspace.take<uint64_t>(most / 64 + 1);
  to_cut_.beyond = beyond_.data();
  to_cut_.unsure = unsure_.data();
  holes_ = workspace.take<uint32_t>(most + 1);
  crossings_ = workspace.take<CrossedEdge>(most + crossings_behind);
  for (CrossedEdge &edge : crossings_) edge = {0, 0, 0, 0};  // kernels read some behind the last one
  made_ = workspace.take<uint32_t>(most + crossings_behind);
  ends_ = workspace.take<uint32_t>(most_planes(balls));
  count_ = 0;
  target_ = workspace.target();
}

void PowerPolytope::start(const CubeFrame &frame, const Vec3 &centre) {
  const double side = frame.side();
  count_ = 8;
  bounds_ = crossing_bounds(frame, centre);
  most_error_ = 0.0;
  const auto squares = [&](double along, double square[2]) {
    square[0] = (-side - along) * (-side - along);
    square[1] = (side - along) * (side - along);
  };
  double in_x[2], in_y[2], in_z[2];
  squares(centre.x, in_x);
  squares(centre.y, in_y);
  squares(centre.z, in_z);
  PolytopeVertex *const vertices = vertices_.data();
  for (uint32_t v = 0; v < 8; ++v) vertices[v] = cube_corners[v];
  // Two corners at a time.
  using L = Wide<double, 2>;
  const L::Real in_x_both{in_x[0], in_x[1]}, both_x{-side, side};
  for (uint32_t v = 0; v < 8; v += 2) {
    const uint32_t y = v / 2 % 2, z = v / 4;
    L::store(to_cut_.at.x + v, both_x);
    L::store(to_cut_.at.y + v, L::all(y == 0 ? -side : side));
    L::store(to_cut_.at.z + v, L::all(z == 0 ? -side : side));
    L::store(to_cut_.at.error + v, L::all(0.0));
    L::store(to_cut_.at.squared + v, in_x_both + L::all(in_y[y]) + L::all(in_z[z]));
  }
}

Vec3 PowerPolytope::middle() const {
  Vec3 sum{0, 0, 0};
  for (uint32_t v = 0; v < count_; ++v) sum = sum + position(v);
  return (1.0 / static_cast<double>(count_)) * sum;
}

// Lists the vertices beyond the plane, and the edges from these to vertices that are not: is_near(v) is 1 for such a
// vertex, else 0. Returns the number of these edges, which is that of the corners of the new facet.
template <class IsNear>
uint32_t PowerPolytope::find_crossings(IsNear is_near) {
  const PolytopeVertex *const vertices = vertices_.data();
  uint32_t *const holes = holes_.data();
  CrossedEdge *at = crossings_.data();
  uint32_t *const ends = ends_.data();
  uint32_t hole = 0;
  for (uint32_t first = 0; first < count_; first += 64) {
    for (uint64_t beyond = beyond_[first / 64]; beyond != 0; beyond &= beyond - 1, ++hole) {
      const uint32_t v = first + static_cast<uint32_t>(std::countr_zero(beyond));
      holes[hole] = v;
      const PolytopeVertex vertex = vertices[v];
      for (const uint32_t plane : vertex.plane) ends[plane] = 0;
      // Written without a branch, and kept if the other end stays.
      const auto list = [&](uint32_t near, uint32_t a, uint32_t b) {
        *at = {v, near, a, b};
        at += is_near(near / 4);
      };
      list(vertex.link[0], vertex.plane[1], vertex.plane[2]);
      list(vertex.link[1], vertex.plane[2], vertex.plane[0]);
      list(vertex.link[2], vertex.plane[0], vertex.plane[1]);
    }
  }
  holes[hole] = at->gone = count_;
  hole_count_ = hole;
  return static_cast<uint32_t>(at - crossings_.data());
}

void PowerPolytope::cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame) {
  const uint64_t first_near = ~beyond_[0];
  const uint64_t *const beyond = beyond_.data();
  const uint32_t count = count_ <= 64 ? find_crossings([&](uint32_t v) { return first_near >> v & 1; })
                                      : find_crossings([&](uint32_t v) { return ~beyond[v / 64] >> v % 64 & 1; });
  PolytopeVertex *const vertices = vertices_.data();
  const uint32_t *const holes = holes_.data();
  const CrossedEdge *const crossings = crossings_.data();
  uint32_t *const ends = ends_.data(), *const made = made_.data();
  // New vertices take the slots of vertices that are cut off, when these have no more edges to be cut; then slots
  // behind the last vertex.
  uint32_t filled = 0, end = count_;
  for (uint32_t c = 0; c < count; ++c) {
    const uint32_t near = crossings[c].near, a = crossings[c].a, b = crossings[c].b;
    // Which of the two cannot be predicted: chosen without a branch.
    const uint32_t hole = holes[filled], reuse = hole < crossings[c + 1].gone ? 1 : 0;
    const uint32_t to = end ^ ((end ^ hole) & (0 - reuse));
    filled += reuse;
    end += 1 - reuse;
    made[c] = to;
    vertices[near / 4].link[near % 4] = 4 * to + 2;
    vertices[to].plane[0] = a;
    vertices[to].plane[1] = b;
    vertices[to].plane[2] = plane;
    vertices[to].link[2] = near;
    // The edge on the new plane and on b is opposite to a.
    ends[b] ^= 4 * to;
    ends[a] ^= 4 * to + 1;
  }
  for (uint32_t k = 0; k < crossings_behind; ++k) made[count + k] = end;
  cross_edges(target_, to_cut_.at, crossings, made, count, bounds_);
  const double *const errors = to_cut_.at.error;
  double most_error = most_error_;
  for (uint32_t c = 0; c < count; ++c) {
    const uint32_t to = made[c];
    most_error = errors[to] > most_error ? errors[to] : most_error;
    vertices[to].link[0] = ends[crossings[c].b] ^ 4 * to;
    vertices[to].link[1] = ends[crossings[c].a] ^ (4 * to + 1);
  }
  if (most_error < no_certainty) {
    most_error_ = most_error;
  } else {
    solve_uncertain(count, planes, frame);
  }
  count_ = end;
  // The last vertices are moved into the slots that are left.
  for (uint32_t hole = hole_count_; hole > filled; --hole) move(--count_, holes[hole - 1]);
  clear_squares_behind();
}

// Computes new vertices with too large an error from their three planes.
void PowerPolytope::solve_uncertain(uint32_t count, const UnitPlane *planes, const CubeFrame &frame) {
  for (const uint32_t v : made_.part(0, count)) {
    if (to_cut_.at.error[v] >= no_certainty) {
      const uint32_t *const plane = vertices_[v].plane;
      const BoundedPoint at = frame.common_point(planes[plane[0]], planes[plane[1]], planes[plane[2]]);
      const Vec3 from_centre = at.y - bounds_.centre;
      to_cut_.at.x[v] = at.y.x;
      to_cut_.at.y[v] = at.y.y;
      to_cut_.at.z[v] = at.y.z;
      to_cut_.at.error[v] = at.error;
      to_cut_.at.squared[v] = dot(from_centre, from_centre);
    }
    if (to_cut_.at.error[v] > most_error_) most_error_ = to_cut_.at.error[v];
  }
}

// Sets the squares behind the last vertex to 0, as many as kernels read.
void PowerPolytope::clear_squares_behind() {
  double *const squared = to_cut_.at.squared + count_;
  for (uint32_t k = 0; k < 7; ++k) squared[k] = 0.0;
}

// Moves a vertex to another slot, and updates the links of its neighbours.
void PowerPolytope::move(uint32_t from, uint32_t to) {
  if (from == to) return;
  const PolytopeVertex vertex = vertices_[from];
  vertices_[to] = vertex;
  for (double *const numbers : {to_cut_.at.x, to_cut_.at.y, to_cut_.at.z, to_cut_.at.error, to_cut_.at.squared}) {
    numbers[to] = numbers[from];
  }
  for (uint32_t k = 0; k < 3; ++k) vertices_[vertex.neighbour(k)].link[vertex.back(k)] = 4 * to + k;
}

}  // namespace hsp
