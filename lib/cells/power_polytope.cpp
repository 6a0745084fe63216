#include "cells/power_polytope.hpp"

namespace hsp {
namespace {

// Bit k of a corner's number says on which of the sides normal to axis k it lies. Corners with an odd number of such
// bits are mirror images of the others, hence their planes come in the order of axes 0, 2, 1.
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
  blocks_ = workspace.take<VertexBlock>(most / 4 + 2);
  for (VertexBlock &block : blocks_) block = {};  // four are read at once, and some may not be vertices
  beyond_ = workspace.take<uint64_t>(most / 64 + 1);
  unsure_ = workspace.take<uint64_t>(most / 64 + 1);
  holes_ = workspace.take<uint32_t>(most);
  crossings_ = workspace.take<Crossing>(most);
  made_ = workspace.take<uint32_t>(most);
  ends_ = workspace.take<uint32_t>(most_planes(balls));
  count_ = 0;
}

void PowerPolytope::start(double side, const Vec3 &centre) {
  count_ = 8;
  centre_ = centre;
  most_doubt_ = 0.0;
  const auto squares = [&](double along, double square[2]) {
    square[0] = (-side - along) * (-side - along);
    square[1] = (side - along) * (side - along);
  };
  double in_x[2], in_y[2], in_z[2];
  squares(centre.x, in_x);
  squares(centre.y, in_y);
  squares(centre.z, in_z);
  PolytopeVertex *const vertices = vertices_.data();
  VertexBlock *const blocks = blocks_.data();
  for (uint32_t v = 0; v < 8; ++v) vertices[v] = cube_corners[v];
  for (uint32_t upper = 0; upper < 2; ++upper) {
    blocks[upper] = {{-side, side, -side, side},
                     {-side, -side, side, side},
                     {0, 0, 0, 0},
                     {0, 0, 0, 0},
                     {in_x[0] + in_y[0] + in_z[upper], in_x[1] + in_y[0] + in_z[upper], in_x[0] + in_y[1] + in_z[upper],
                      in_x[1] + in_y[1] + in_z[upper]},
                     {0, 0, 0, 0}};
    for (double &z : blocks[upper].z) z = upper == 0 ? -side : side;
  }
}

Vec3 PowerPolytope::middle() const {
  Vec3 sum{0, 0, 0};
  for (uint32_t v = 0; v < count_; ++v) sum = sum + position(v);
  return (1.0 / static_cast<double>(count_)) * sum;
}

// Lists the edges from a vertex beyond the plane to one that is not: is_near(v) is 1 for such a vertex, else 0. Returns
// how many. Around a hole these are as many as the new facet has corners.
template <class IsNear>
uint32_t PowerPolytope::find_crossings(IsNear is_near) {
  const PolytopeVertex *const vertices = vertices_.data();
  const uint32_t *const holes = holes_.data();
  Crossing *at = crossings_.data();
  uint32_t *const ends = ends_.data();
  const uint32_t hole_count = hole_count_;
  for (uint32_t hole = 0; hole < hole_count; ++hole) {
    const PolytopeVertex vertex = vertices[holes[hole]];
    for (const uint32_t plane : vertex.plane) ends[plane] = 0;
    // Written in any case, and kept if the other end stays.
    const auto list = [&](uint32_t near, uint32_t a, uint32_t b) {
      *at = {hole, near, a, b};
      at += is_near(near / 4);
    };
    list(vertex.link[0], vertex.plane[1], vertex.plane[2]);
    list(vertex.link[1], vertex.plane[2], vertex.plane[0]);
    list(vertex.link[2], vertex.plane[0], vertex.plane[1]);
  }
  at->hole = hole_count;
  return static_cast<uint32_t>(at - crossings_.data());
}

void PowerPolytope::cut(uint32_t plane, const UnitPlane *planes, const CubeFrame &frame) {
  const uint64_t first_near = ~beyond_[0];
  const uint64_t *const beyond = beyond_.data();
  const uint32_t count = count_ <= 64 ? find_crossings([&](uint32_t v) { return first_near >> v & 1; })
                                      : find_crossings([&](uint32_t v) { return ~beyond[v / 64] >> v % 64 & 1; });
  const EdgeCrossing crossing(frame);
  const Vec3 centre = centre_;
  PolytopeVertex *const vertices = vertices_.data();
  VertexBlock *const blocks = blocks_.data();
  const uint32_t *const holes = holes_.data();
  const Crossing *const crossings = crossings_.data();
  uint32_t *const ends = ends_.data(), *const made = made_.data();
  // New vertices take the places of those that are cut off, once these have no more edges to be cut, and then places
  // behind the last one.
  uint32_t filled = 0, end = count_;
  double most_doubt = most_doubt_;
  for (uint32_t c = 0; c < count; ++c) {
    const uint32_t w = holes[crossings[c].hole], near = crossings[c].near, v = near / 4;
    const uint32_t a = crossings[c].a, b = crossings[c].b;
    // One or the other, which cannot be foreseen, without a branch.
    const uint32_t reuse = filled < crossings[c + 1].hole ? 1 : 0;
    const uint32_t to = end ^ ((end ^ holes[filled]) & (0 - reuse));
    filled += reuse;
    end += 1 - reuse;
    const VertexBlock &near_block = blocks[v / 4], &beyond_block = blocks[w / 4];
    const uint32_t i = v % 4, j = w % 4;
    const PlacedPoint from{{near_block.x[i], near_block.y[i], near_block.z[i]}, near_block.doubt[i]};
    const PlacedPoint gone{{beyond_block.x[j], beyond_block.y[j], beyond_block.z[j]}, beyond_block.doubt[j]};
    PlacedPoint at;
    if (!crossing.find(from, near_block.value[i], gone, beyond_block.value[j], at)) {
      at = frame.common_point(planes[a], planes[b], planes[plane]);
    }
    const Vec3 from_centre = at.y - centre;
    VertexBlock &block = blocks[to / 4];
    block.x[to % 4] = at.y.x;
    block.y[to % 4] = at.y.y;
    block.z[to % 4] = at.y.z;
    block.doubt[to % 4] = at.doubt;
    block.squared[to % 4] = dot(from_centre, from_centre);
    most_doubt = at.doubt > most_doubt ? at.doubt : most_doubt;
    made[c] = to;
    vertices[v].link[near % 4] = 4 * to + 2;
    vertices[to].plane[0] = a;
    vertices[to].plane[1] = b;
    vertices[to].plane[2] = plane;
    vertices[to].link[2] = near;
    // The edge on the new plane and on b is opposite to a.
    ends[b] ^= 4 * to;
    ends[a] ^= 4 * to + 1;
  }
  for (uint32_t c = 0; c < count; ++c) {
    const uint32_t to = made[c];
    vertices[to].link[0] = ends[crossings[c].b] ^ 4 * to;
    vertices[to].link[1] = ends[crossings[c].a] ^ (4 * to + 1);
  }
  count_ = end;
  most_doubt_ = most_doubt;
  // The last vertices take the places that are left, from the last one on.
  for (uint32_t hole = hole_count_; hole > filled; --hole) move(--count_, holes[hole - 1]);
  clear_squares_behind();
}

// Of the rest of two blocks. The number of vertices is even.
void PowerPolytope::clear_squares_behind() {
  VertexBlock *const blocks = blocks_.data() + count_ / 4;
  double *const squared = blocks[0].squared;
  squared[count_ % 4] = squared[count_ % 4 + 1] = squared[2] = squared[3] = 0.0;
  for (double &square : blocks[1].squared) square = 0.0;
}

// Moves a vertex, unless it is there, and tells its neighbours.
void PowerPolytope::move(uint32_t from, uint32_t to) {
  if (from == to) return;
  const PolytopeVertex vertex = vertices_[from];
  vertices_[to] = vertex;
  const VertexBlock &source = blocks_[from / 4];
  VertexBlock &target = blocks_[to / 4];
  target.x[to % 4] = source.x[from % 4];
  target.y[to % 4] = source.y[from % 4];
  target.z[to % 4] = source.z[from % 4];
  target.doubt[to % 4] = source.doubt[from % 4];
  target.squared[to % 4] = source.squared[from % 4];
  for (uint32_t k = 0; k < 3; ++k) vertices_[vertex.neighbour(k)].link[vertex.back(k)] = 4 * to + k;
}

}  // namespace hsp
