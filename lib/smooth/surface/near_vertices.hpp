// The vertices whose probes may cut the patch of one: floats leave out others for certain (near_probes.hpp).
#pragma once

#include "core/fixed_vector.hpp"
#include "surface/chosen_faces.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

class NearVertices {
 public:
  // The list is the caller's.
  NearVertices(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
               FixedVector<uint32_t> &list)
      : balls_(balls), boundary_(boundary), chosen_(chosen), grid_(grid), list_(list) {}

  // Lists those of this vertex by their numbers. False if there is no room. Nothing of the search stays on the stack.
  [[gnu::noinline]] bool find(uint32_t vertex);
  Span<const uint32_t> list() const { return list_.items(); }
  bool has(uint32_t vertex) const;

 private:
  const BallSet &balls_;
  const Boundary &boundary_;
  const ChosenFaces &chosen_;
  const ProbeGrid &grid_;
  FixedVector<uint32_t> &list_;
};

}  // namespace hsp
