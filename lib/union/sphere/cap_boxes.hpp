// Of one ball with hundreds of large caps, those that matter along the circle of one of them: an index by boxes.
//
//     +-------+---+---+   The cube around the unit sphere is halved along each axis, and so are its parts, until few
//     |       |   |+-+|   caps may touch what is free in one. A box lists these; if nothing in it is free, caps that
//     |       +---++-+|   cover all of the sphere there. The boxes that a circle's plane goes through list all that
//     +-------+---+---+   matters to what is free of it (exact/PROOFS.md, section 7).
//
// As an example balls close together on a line and a large ball beside it. All its caps meet each other, and each is
// free for a short way between the next ones: a box around a part of that way lists those of its balls.
#pragma once

#include "core/small_code.hpp"
#include "sphere/exposed_caps.hpp"

namespace hsp {

class CapBoxes {
 public:
  // Fewer are compared each with each: that is as quick. Of so many all have been found to matter.
  static constexpr uint32_t fewest = ExposedCaps::fewest;
  static bool are_many(const Caps &caps) { return !small_code && caps.count >= fewest; }

  // Memory, [words_for_each caps] or more: with more, lists are shorter.
  static constexpr uint32_t words_for_each = 8;
  explicit CapBoxes(Span<uint32_t> memory) : memory_(memory) {}

  // Of all caps, once before the others. False if boxes do not help: then all are around each.
  [[gnu::cold]] bool start(const Caps &caps);
  // Those that matter along the circle of cap j, j itself, and others, ascending. Valid until the next call.
  Span<const uint32_t> around(const Caps &caps, uint32_t j);

 private:
  struct Box;
  struct Found;

  // How often the cube is halved at most, and how many caps a box lists that is not, if there is room.
  static constexpr uint32_t most_halvings = 16, fewest_listed = 32;
  static constexpr uint32_t all_units = 1U << most_halvings;  // from the cube's centre to its sides
  static constexpr double unit = CellBox{}.half / all_units;

  [[gnu::cold]] Found find_in(const Caps &caps, const CellBox &box, Span<const uint32_t> above);
  [[gnu::cold]] bool halve(const Caps &caps, const Box &whole);
  void write(uint32_t at, const Box &box, uint32_t end, uint32_t listed) const;

  Span<uint32_t> memory_;
  Span<uint32_t> near_, marks_, boxes_;
  Span<uint8_t> state_;
  uint32_t most_listed_ = 0;
  uint64_t tried_ = 0;  // caps in boxes
  uint32_t end_ = 0;    // of what is written of boxes_
};

}  // namespace hsp
