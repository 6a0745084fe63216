// The free pieces of one circle on a sphere, in their order around the circle.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "sphere_predicates.hpp"

namespace oracle {

// A free arc, counter-clockwise about the circle's normal: from where the circle leaves the cap `exit` (the crossing
// (circle, exit) of side +1) to where it enters the cap `entry` (the crossing (circle, entry) of side -1).
struct FreeArc {
  Cap exit;
  Cap entry;
};

// Where a circle on the sphere of ball a is outside all of some caps.
//
// Order without the library's rule: the caps that own a free end point are sorted by the rational direction in which
// they lie as seen from the circle's axis. These directions, all covered, cut the circle into sectors, and every end
// point is located in its sector by the exact signs of its distances from the planes through axis and direction. A
// sector that holds ends holds one exit and one entry, with the free arc between them.
class FreePieces {
 public:
  enum class Kind { covered, whole, arcs };

  // Tells whether the crossing (circle, cap) of a side is outside all other caps.
  using FreeTest = std::function<bool(const Cap &cap, int side)>;

  // caps: all caps of the sphere but the circle's own.
  FreePieces(const TiedBalls &set, uint32_t a, const Cap &circle, const std::vector<Cap> &caps,
             const FreeTest &is_free);

  // The same with every end point tested against all the caps.
  FreePieces(const TiedBalls &set, uint32_t a, const Cap &circle, const std::vector<Cap> &caps);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Cap &circle() const { return circle_; }
  [[nodiscard]] const std::vector<FreeArc> &arcs() const { return arcs_; }

  // The index of the arc that holds a free point of the circle: the crossing (circle, cap) of a side.
  [[nodiscard]] size_t arc_with_crossing(const Cap &cap, int side) const;

  // The index of the arc that holds a free point of the circle: the one in the direction of a vector from its axis.
  [[nodiscard]] size_t arc_with_direction(const Vector &direction) const;

 private:
  void find_arcs(const std::vector<Cap> &crossing, const FreeTest &is_free);
  [[nodiscard]] size_t sector_of_crossing(const Cap &cap, int side) const;
  [[nodiscard]] size_t sector_of_direction(const Vector &direction) const;

  const TiedBalls *set_;
  uint32_t ball_;
  Cap circle_;
  Kind kind_ = Kind::covered;
  std::vector<FreeArc> arcs_;
  std::vector<Vector> directions_;                    // of the owners, counter-clockwise
  std::vector<std::optional<size_t>> arc_of_sector_;  // sector k: from directions_[k] to the next
};

}  // namespace oracle
