// A polyhedron in doubles that contains the power cell of one ball. The unit is the ball's radius. A cap u.x >= b
// (caps.hpp) takes a half-space away from a cube around the unit sphere. All caps together leave the power cell; the
// polyhedron is what some of the caps leave. A cap that certainly misses the polyhedron misses the power cell.
//
//     +-----------+        +-------.            +-------.  /
//     |   .---.   |        |   .---.\           |   .---.\/
//     |  ( ball ) |   ->   |  ( ball \|    ->   |  ( ball\|\ a cap that misses
//     |   '---'   |        |   '---'  |         |   '---'  |
//     +-----------+        +----------+         +----------+
//       the cube at first    a cap has cut        drops out
//
// Only the vertices are stored, each with its three planes; edges and neighbours are not. exact/PROOFS.md, section 7,
// proves that this is enough and that the answers are certain.
#pragma once

#include "core/status.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {

// A cube with sides along the axes: at first the one around the unit sphere.
struct CellBox {
  // Half of its side, as a fraction. The cube is somewhat larger than the sphere: it contains the infinitesimally
  // inflated ball, too, and planes that meet in a point of the sphere hardly ever meet in a point of a side.
  static constexpr int32_t side_numerator = 9, side_denominator = 8;

  double x = 0.0, y = 0.0, z = 0.0;  // its centre
  double half = static_cast<double>(side_numerator) / side_denominator;
};

struct OuterCell {
  static constexpr uint32_t most_faces = 64;                     // bits of a word
  static constexpr uint32_t most_vertices = 2 * most_faces - 4;  // of a polyhedron whose vertices have three edges each
  static constexpr uint32_t room = most_vertices + 4;            // whole registers are read

  // Vertices: their positions, the error bound of a cap's depth there, their three planes.
  double x[room], y[room], z[room], error[room];
  uint8_t face[room][3];
  uint32_t vertices = 0;
  // Planes u.x = b of the cube and of the caps that have cut.
  double ux[most_faces], uy[most_faces], uz[most_faces], b[most_faces];
  uint32_t cap[most_faces];  // the cap of a plane; no_id for a side of the cube
  uint64_t faces = 0;        // bits of the planes that have a vertex

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
  // The same where it is known which vertices lie in the cap, as bits. The answer is never `unsure`.
  Cut cut(const Plane &plane, const uint64_t (&outside)[2]);

  // The part of the polyhedron that a cap takes: at most the neighbourhood of one point, as where many planes go
  // through that point, or perhaps more.
  enum class Taken : uint8_t { point_inside_sphere, point_outside_sphere, more };
  [[gnu::cold]] Taken part_taken(const Plane &plane) const;

 private:
  bool place_vertex(uint32_t v, uint32_t p, uint32_t q, uint32_t r);
};

// Some caps in the order in which they are tried, as arrays for the kernels.
struct CapBatch {
  static constexpr uint32_t most = 32;
  double ux[most], uy[most], uz[most], b[most];
  double depth[most];  // roughly how far a plane cuts into the polyhedron
  uint32_t count = 0;

  uint32_t all() const { return count < most ? (1U << count) - 1U : ~0U; }
};

// Returns the bits of the caps in `asked` that do not certainly miss the polyhedron. asked: bits of caps of the batch.
// Sets the depths of all these caps.
HSP_KERNEL(uint32_t, caps_that_may_cut, (const OuterCell &cell, CapBatch &caps, uint32_t asked), (cell, caps, asked))

// The same for the first `count` caps in floats: returns how many are not certain to miss the polyhedron, and writes
// their numbers, ascending, and the number of the one that goes about deepest. FloatCaps::pad has written caps behind
// the last one.
HSP_KERNEL(uint32_t, float_caps_that_may_cut,
           (const OuterCell &cell, const FloatCaps &caps, uint32_t count, uint32_t *numbers, uint32_t &deepest),
           (cell, caps, count, numbers, deepest))

// On which side of a plane vertices are.
struct VertexSides {
  uint64_t outside[2];  // bits of the vertices that are certainly in the cap
  uint64_t unsure[2];   // of those that are not certain; all others are certainly not in the cap
};
HSP_KERNEL(VertexSides, sides_of_vertices, (const OuterCell &cell, const OuterCell::Plane &plane), (cell, plane))

}  // namespace hsp
