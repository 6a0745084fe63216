// An index by boxes, for a ball with hundreds of large caps: it finds the caps that matter along the circle of one cap.
//
//     +-------+---+---+   The cube around the unit sphere is halved along each axis, and its eight parts again, until
//     |       |   |+-+|   few caps may touch the free part of the sphere in a box. The box lists these caps. If nothing
//     |       +---++-+|   is free in a box, it lists caps that cover the sphere there. The boxes that the plane of a
//     +-------+---+---+   circle meets list all that matters to its free parts (exact/PROOFS.md, section 7).
//
// As an example balls close together on a line, and a large ball beside the line. All caps of the large ball meet each
// other, and each circle has a short free arc between the next two circles: a box around a part of that arc lists few.
#pragma once

#include "core/small_code.hpp"
#include "sphere/exposed_caps.hpp"

namespace hsp {

class CapBoxes {
 public:
  // Fewer caps are compared each with each, which is as quick. If there are so many, ExposedCaps has kept them all.
  static constexpr uint32_t fewest = ExposedCaps::fewest;
  static bool are_many(const Caps &caps) { return !small_code && caps.count >= fewest; }

  // Memory: words_for_each words for each cap, or more. With more memory the boxes have shorter lists.
  static constexpr uint32_t words_for_each = 8;
  explicit CapBoxes(Span<uint32_t> memory) : memory_(memory) {}

  // Builds the boxes, once, before around(). False if boxes do not help: around() then gives all caps.
  [[gnu::cold]] bool start(const Caps &caps);
  // All caps that matter along the circle of cap j, j itself, and perhaps others, ascending. Valid until the next call.
  Span<const uint32_t> around(const Caps &caps, uint32_t j);

 private:
  struct Box;
  struct Found;

  // How often the cube is halved at most. A box with no more caps than fewest_listed is not halved; if memory is short,
  // that limit is raised (most_listed_).
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
  uint64_t tried_ = 0;  // pairs of a box and a cap that have been tested
  uint32_t end_ = 0;    // how many words of boxes_ are written
};

}  // namespace hsp
