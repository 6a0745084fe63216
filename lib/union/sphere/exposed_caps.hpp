// Of many caps of one ball, those that may touch its free part. The others are covered by these, strictly, so that
// whatever is found of the free part of the sphere is found with these alone: vertices, circles, clusters, ties. Or
// those that may touch the ball's power cell, inside the ball: with these alone the ball's contacts are found.
// (exact/PROOFS.md, section 7.) In sets of many overlaps, models of one molecule or poses of a ligand, a ball has a
// thousand caps, and mostly a dozen of these cover it.
#pragma once

#include "core/small_code.hpp"
#include "sphere/caps.hpp"
#include "sphere/cell_ties.hpp"
#include "sphere/float_caps.hpp"

namespace hsp {

class ExposedCaps {
 public:
  // Fewer are searched as they are: that is as quick, and where it turns out not to be, these are found after all.
  // Small code does without: where flash counts, balls have few caps.
  static constexpr uint32_t fewest = 160;
  static bool are_many(const Caps &caps) { return !small_code && caps.count >= fewest; }

  // Memory, [caps] each.
  ExposedCaps(Span<uint32_t> order, Span<uint8_t> state) : order_(order), state_(state) {}
  // Of which the caps leave a part: of the sphere, or of the ball.
  enum class Part : uint8_t { sphere, ball };
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
  // States of a cap. It is dropped; it is not looked at yet: that and its class of size; its plane cuts less deep than
  // others do, and waits; it has cut; that is in doubt, and it stays; it is in doubt as it is near a vertex; or it goes
  // through a set of vertices: that and the number of the set. Those from `waits` on are few and have a bit of their
  // own.
  static constexpr uint8_t dropped = 0, not_tried = 1, waits = 0x80, has_cut = waits + 1, stays = waits + 2,
                           near_vertex = waits + 3, tied = waits + 4;
  bool is_tried(uint32_t k) const { return state_[k] == dropped || state_[k] >= waits; }
  class Cutting;

  template <class Real>
  Span<const uint32_t> order_by_size(const Real *b, uint32_t count, uint32_t step);
  Span<uint32_t> in_states(uint32_t count, uint8_t first, uint8_t last);
  void keep_planes_of_ties(const Caps &caps, TiedSets &sets);

  Span<uint32_t> order_;
  Span<uint8_t> state_;
  uint32_t kept_ = 0;
};

}  // namespace hsp
