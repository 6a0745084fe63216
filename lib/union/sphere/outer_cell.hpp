// A polyhedron in doubles around what the caps of one ball leave free: some of the caps' planes bound it. On the unit
// sphere of caps.hpp a cap u.x >= b takes a half-space away; what all caps leave of space is the ball's power cell, and
// what some of them leave, as here, contains it. A cap that certainly misses this misses the power cell.
//
//     +-----------+        +-------.            +-------.  /
//     |   .---.   |        |   .---.\           |   .---.\/
//     |  ( ball ) |   ->   |  ( ball \|    ->   |  ( ball\|\ a cap that misses
//     |   '---'   |        |   '---'  |         |   '---'  |
//     +-----------+        +----------+         +----------+
//       the cube at first    a cap has cut        drops out
//
// It is kept as its vertices alone, each a triple of planes; there are no edges and no neighbours. Why that is enough,
// and that the answers are certain: exact/PROOFS.md, section 7.
#pragma once

#include "core/status.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {

// A cube with sides along the axes: at first the one around the unit sphere.
struct CellBox {
  // Half of its side, as a fraction: somewhat larger than the sphere, so that balls that are inflated by infinitely
  // little lie in it, too, and planes that meet in a point of the sphere hardly meet in one of a side.
  static constexpr int32_t side_numerator = 9, side_denominator = 8;

  double x = 0.0, y = 0.0, z = 0.0;  // its centre
  double half = static_cast<double>(side_numerator) / side_denominator;
};

struct OuterCell {
  static constexpr uint32_t most_faces = 64;                     // bits of a word
  static constexpr uint32_t most_vertices = 2 * most_faces - 4;  // of a polyhedron whose vertices have three edges each
  static constexpr uint32_t room = most_vertices + 4;            // whole registers are read

  // Vertices: where they are, how far the computed depth of a plane may be off there, their planes.
  double x[room], y[room], z[room], error[room];
  uint8_t face[room][3];
  uint32_t vertices = 0;
  // Planes u.x = b of the cube and of the caps that have cut.
  double ux[most_faces], uy[most_faces], uz[most_faces], b[most_faces];
  uint32_t cap[most_faces];  // of which cap a plane is; no_id of the cube
  uint64_t faces = 0;        // bits of those that have a vertex

  [[gnu::cold]] void start(const CellBox &box = {});
  // Whether no part of it reaches the unit sphere.
  bool lies_inside_sphere() const;

  enum class Cut : uint8_t {
    misses,   // the cap certainly touches nothing of it
    cuts,     // the cap's plane is a face now
    unsure,   // nothing has changed: a vertex is too near the plane
    refused,  // nothing has changed: a new vertex is not certain enough
    full,     // nothing has changed: there is no room for another face, or for its vertices
    buries    // all of it certainly lies in the cap
  };
  struct Plane {
    double ux, uy, uz, b;
    uint32_t cap = no_id;
  };
  Cut cut(Target target, const Plane &plane);
  // The same where it is known which vertices lie in the cap: bits. It is not `unsure`.
  Cut cut(const Plane &plane, const uint64_t (&outside)[2]);

  // The part that a cap takes: at most what is near one point, as where many planes go through one, or maybe more.
  enum class Taken : uint8_t { point_inside_sphere, point_outside_sphere, more };
  [[gnu::cold]] Taken part_taken(const Plane &plane) const;

 private:
  bool place_vertex(uint32_t v, uint32_t p, uint32_t q, uint32_t r);
};

// Some caps in the order in which they are tried, as arrays for the kernels.
struct CapBatch {
  static constexpr uint32_t most = 32;
  double ux[most], uy[most], uz[most], b[most];
  double depth[most];  // how far a plane cuts into the polyhedron, about
  uint32_t count = 0;

  uint32_t all() const { return count < most ? (1U << count) - 1U : ~0U; }
};

// Bits of those of `asked` caps of a batch that are not certain to miss the polyhedron, whose depths are set.
HSP_KERNEL(uint32_t, caps_that_may_cut, (const OuterCell &cell, CapBatch &caps, uint32_t asked), (cell, caps, asked))

// The same of caps in floats: how many of the first `count` of them are not certain to miss the polyhedron, their
// numbers, ascending, and about the deepest of them. There are more caps behind these, as FloatCaps::pad writes them.
HSP_KERNEL(uint32_t, float_caps_that_may_cut,
           (const OuterCell &cell, const FloatCaps &caps, uint32_t count, uint32_t *numbers, uint32_t &deepest),
           (cell, caps, count, numbers, deepest))

// On which side of a plane vertices are.
struct VertexSides {
  uint64_t outside[2];  // bits: certainly in the cap
  uint64_t unsure[2];   // all others are certainly not
};
HSP_KERNEL(VertexSides, sides_of_vertices, (const OuterCell &cell, const OuterCell::Plane &plane), (cell, plane))

}  // namespace hsp
