#include "boundary/faces.hpp"

#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

// Whether two caps have a common point.
bool caps_meet(const Caps &caps, const exact::Predicates &predicates, uint32_t j, uint32_t k) {
  const CapPair pair(caps, j, k);
  if (pair.surely_cross()) return true;
  if (pair.surely_apart()) {
    if (pair.surely_inside() || pair.surely_contains()) return true;
    if (pair.surely_separate()) return false;
  }
  const exact::Plane &P = caps.plane[j];
  const exact::Plane &Q = caps.plane[k];
  return predicates.crossing(P, Q).sign > 0 || predicates.side(P, Q).sign > 0 || predicates.side(Q, P).sign > 0;
}

// Numbers the faces of one ball from the partition of its loops in face_parent, which starts at the ball's first loop.
void number_faces(const DisjointSets &sets, uint32_t ball, BoundaryStructure &boundary) {
  const uint32_t first = boundary.first_loop[ball];
  const uint32_t last = boundary.first_loop[ball + 1];
  for (uint32_t loop = first; loop < last; ++loop) {
    const uint32_t representative = sets.find(loop - first);
    if (representative == loop - first) {
      boundary.loop_face[loop] = boundary.face_count;
      boundary.faces[boundary.face_count++] = {ball, 1, no_id};
    } else {
      boundary.loop_face[loop] = boundary.loop_face[first + representative];
      ++boundary.faces[boundary.loop_face[loop]].loops;
    }
  }
}

}  // namespace

uint32_t count_clusters(const Caps &caps, const FaceScratch &scratch) {
  const DisjointSets clusters(scratch.cluster.part(0, caps.count));
  clusters.reset();
  const exact::Predicates predicates = caps.predicates();
  uint32_t count = caps.count;
  for (uint32_t j = 0; j < caps.count && count > 1; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      if (clusters.find(j) != clusters.find(k) && caps_meet(caps, predicates, j, k)) {
        clusters.join(j, k);
        --count;
      }
    }
  }
  return count;
}

void FaceScratch::carve(Workspace &workspace, uint32_t capacity) {
  cluster = workspace.take<uint32_t>(capacity);
  crossing = workspace.take<uint32_t>(capacity);
  owner = workspace.take<uint32_t>(capacity);
}

// If a sphere has a free point, its free faces and its clusters alternate around the loops as the nodes of a tree whose
// edges are the loops (the sphere less disjoint closed curves). Hence #faces = #loops - #clusters + 1.
void gather_faces(const CubeGrid &grid, Caps &caps, FaceScratch &scratch, BoundaryStructure &boundary) {
  const BallSet &balls = grid.balls();
  boundary.face_count = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    boundary.first_face[i] = boundary.face_count;
    const uint32_t first = boundary.first_loop[i];
    const uint32_t loops = boundary.first_loop[i + 1] - first;
    if (loops == 0) {
      if (boundary.ball_state[i] == BoundaryStructure::without_caps) {
        boundary.faces[boundary.face_count++] = {i, 0, no_id};
      }
      continue;
    }
    // A partition of the ball's loops; smaller numbers stay representatives.
    const DisjointSets sets(boundary.face_parent.part(first, first + loops));
    sets.reset();
    if (loops > 1) {
      uint32_t clusters = boundary.cluster_count[i];
      const auto gather_again = [&]() {
        caps.gather(balls, grid.block_around(grid.cube_at(balls.ball(i).centre)), i, nullptr);
        clusters = count_clusters(caps, scratch);
      };
      if (clusters == BoundaryStructure::not_counted) gather_again();
      if (loops == clusters) {  // one face
        for (uint32_t loop = 1; loop < loops; ++loop) sets.join(0, loop);
      } else if (clusters > 1) {
        if (boundary.cluster_count[i] != BoundaryStructure::not_counted) gather_again();
        join_loops_by_meridians(caps, scratch, boundary, sets);
      }
    }
    number_faces(sets, i, boundary);
  }
  boundary.first_face[balls.n] = boundary.face_count;
}

}  // namespace hsp
