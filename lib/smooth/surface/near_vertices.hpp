// The vertices whose probes may cut the patch of one: floats leave out others for certain (near_probes.hpp). Of many
// that they leave, the actual set says which do.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/small_code.hpp"
#include "surface/actual_balls.hpp"
#include "surface/chosen_faces.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

class NearVertices {
 public:
  // The list is the caller's.
  NearVertices(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid, FixedVector<uint32_t> &list)
      : actual_(actual), chosen_(chosen), grid_(grid), list_(list) {}

  // Lists those of this vertex by their numbers. False if there is no room.
  bool find(uint32_t vertex);
  Span<const uint32_t> list() const { return list_.items(); }
  // The room that was needed for it, or would be.
  uint64_t required() const { return required_; }
  // How many of those were asked about, if there was room.
  uint64_t asked() const { return !small_code && required_ > many ? required_ : 0; }

 private:
  // So many that it pays to ask whether each does cut.
  static constexpr uint32_t many = 32;

  // Nothing of the search stays on the stack.
  [[gnu::noinline]] void find_by_floats(uint32_t vertex);

  const ActualBalls &actual_;
  const ChosenFaces &chosen_;
  const ProbeGrid &grid_;
  FixedVector<uint32_t> &list_;
  uint64_t required_ = 0;
};

}  // namespace hsp
