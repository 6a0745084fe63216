// The vertices whose probes may cut the patch of a given vertex. A search in floats leaves out only probes that
// certainly do not cut it (near_probes.hpp). If it leaves many, the actual set decides about each.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/small_code.hpp"
#include "surface/actual_balls.hpp"
#include "surface/chosen_faces.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

class NearVertices {
 public:
  // The list and the triangles are the caller's.
  NearVertices(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid, ProbeTriangles &triangles,
               FixedVector<uint32_t> &list)
      : actual_(actual), chosen_(chosen), grid_(grid), triangles_(triangles), list_(list) {}

  // Lists the vertices near this one, in ascending order. Vertices must be passed in order, from the first on. False if
  // there is no room.
  bool find(uint32_t vertex);
  // The room that the list needed before any decision of the actual set, also if there was too little.
  uint64_t required() const { return required_; }
  // How many of them the actual set was asked about, if there was room.
  uint64_t asked() const { return !small_code && required_ > many ? required_ : 0; }

 private:
  // With more than this it pays to ask the actual set about each.
  static constexpr uint32_t many = 32;

  // A function of its own, so that nothing of the search stays on the stack.
  [[gnu::noinline]] void find_by_floats(uint32_t vertex);

  const ActualBalls &actual_;
  const ChosenFaces &chosen_;
  const ProbeGrid &grid_;
  ProbeTriangles &triangles_;
  FixedVector<uint32_t> &list_;
  uint64_t required_ = 0;
};

}  // namespace hsp
