// Finds, among many caps of one ball, the caps that may touch the free part of its sphere. These cover all other caps
// strictly. So everything about the free part (vertices, free circles, clusters, ties) is found with these caps alone.
// Or finds the caps that may touch the ball's power cell inside the ball: the ball's contacts are found with these
// alone. (exact/PROOFS.md, section 7.) In sets of many overlaps, models of one molecule or poses of a ligand, a ball
// has a thousand caps, and mostly a dozen of them cover it.
#pragma once

#include "core/small_code.hpp"
#include "sphere/cell_cutting.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {

class ExposedCaps : private CapState {
 public:
  // Fewer caps are searched as they are, which is as quick; if the search turns out to be slow, exposed caps are found
  // after all. Small code does without: where flash memory is scarce, balls have few caps.
  static constexpr uint32_t fewest = 160;
  static bool are_many(const Caps &caps) { return !small_code && caps.count >= fewest; }

  // Memory, [caps] each.
  ExposedCaps(Span<uint32_t> order, Span<uint8_t> state) : order_(order), state_(state) {}
  using Part = CellCutting::Part;
  // False if nothing of the part is left. The ball's radius is not 0. floats: null, or, if `caps` has no doubles but
  // only balls, its caps in floats; doubles are then made of the caps that are looked at.
  bool find(Part part, const Caps &caps, const FloatCaps *floats = nullptr);
  // After find: the numbers of the caps that stay, ascending.
  Span<const uint32_t> kept() const { return order_.part(0, kept_); }
  // If there are `many` caps or more: keeps only those that find() keeps; false if nothing of the part is left. Of
  // fewer caps it may drop copies, so that one of several equal balls stays.
  bool keep(Part part, Caps &caps, uint32_t many = fewest);

  // For tests: integers are asked if doubles leave so many caps or more in doubt because they are near vertices.
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
