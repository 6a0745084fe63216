// Which boundary loops on one sphere bound the same face.
#pragma once

#include <cstdint>
#include <vector>

#include "circle_order.hpp"

namespace oracle {

// The circles on one sphere with the loops that their free arcs belong to.
struct SphereLoops {
  uint32_t ball = 0;
  std::vector<FreePieces> circles;                 // one for every cap
  std::vector<std::vector<uint32_t>> loop_of_arc;  // by circle, by arc; one entry for a whole circle
  uint32_t loops = 0;
};

// face_of_loop[l] = 0, 1, 2, ... for the faces of a sphere with at least one cap.
//
// The caps form clusters (connected components of their union). Every loop bounds one component of the complement of
// one cluster. Two loops l and l' of clusters K and K' bound the same face exactly if K' lies in l's component, K lies
// in that of l', and no third cluster has K and K' in different components of its complement; two loops of one
// cluster never do. In which component of K's complement a cap lies is found by walking along the great circle from
// the cap's centre to the centre of a cap of K.
// Throws if the number of faces is not loops - clusters + 1: faces and clusters form a tree with the loops as edges.
std::vector<uint32_t> faces_of_loops(const TiedBalls &set, const SphereLoops &sphere);

}  // namespace oracle
