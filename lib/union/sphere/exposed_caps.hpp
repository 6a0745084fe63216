// Of many caps of one ball, those that may touch its free part. The others are covered by these, strictly, so that
// whatever is found of the free part of the sphere is found with these alone: vertices, circles, clusters, ties. Or
// those that may touch the ball's power cell, inside the ball: with these alone the ball's contacts are found.
// (exact/PROOFS.md, section 7.) In sets of many overlaps, models of one molecule or poses of a ligand, a ball has a
// thousand caps, and mostly a dozen of these cover it.
#pragma once

#include "core/small_code.hpp"
#include "sphere/cell_cutting.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {

class ExposedCaps : private CapState {
 public:
  // Fewer are searched as they are: that is as quick, and where it turns out not to be, these are found after all.
  // Small code does without: where flash counts, balls have few caps.
  static constexpr uint32_t fewest = 160;
  static bool are_many(const Caps &caps) { return !small_code && caps.count >= fewest; }

  // Memory, [caps] each.
  ExposedCaps(Span<uint32_t> order, Span<uint8_t> state) : order_(order), state_(state) {}
  using Part = CellCutting::Part;
  // False if nothing of it is left. The radius is not 0. floats: where of caps the balls alone are known, the caps in
  // floats; doubles are made of those caps alone that are looked at.
  bool find(Part part, const Caps &caps, const FloatCaps *floats = nullptr);
  // After find: the numbers of those that stay, ascending.
  Span<const uint32_t> kept() const { return order_.part(0, kept_); }
  // Of so many caps or more keeps these. False if nothing is left. Of fewer it keeps one of each of equal balls, if
  // there are such.
  bool keep(Part part, Caps &caps, uint32_t many = fewest);

  // For tests: of how many caps that doubles leave in doubt at vertices integers are asked.
  uint32_t fewest_ties = 24;

 private:
  bool is_tried(uint32_t k) const { return state_[k] == dropped || state_[k] >= waits; }

  template <class Real>
  Span<const uint32_t> order_by_size(const Real *b, uint32_t count, uint32_t step);
  Span<uint32_t> in_states(uint32_t count, uint8_t first, uint8_t last);
  void keep_planes_of_ties(const Caps &caps, TiedSets &sets);

  Span<uint32_t> order_;
  Span<uint8_t> state_;
  uint32_t kept_ = 0;
};

}  // namespace hsp
