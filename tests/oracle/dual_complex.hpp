// The connected components of the complement of a union of balls, exactly, from the union's dual complex. The library
// has no triangulation of the centres.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "lattice_ball.hpp"

namespace oracle {

// The regular triangulation of the centres, and which of its triangles and tetrahedra belong to the dual complex of
// the closed balls. The complex lies inside the union, and the union shrinks to it (H. Edelsbrunner, The union of
// balls and its dual shape, 1995); so a component of the union's complement lies in one component of the complex's
// complement, and each of those holds exactly one. Every step from a tetrahedron to the next looks at all balls.
class DualComplex {
 public:
  // Centres within 2^19 steps of the first along every axis, radii of at most 2^20 steps, else std::out_of_range.
  explicit DualComplex(Balls balls);

  // Components of the complement: 1 + voids.
  [[nodiscard]] uint32_t cells() const { return cells_; }

  // The component that a point outside the closed balls lies in, 0 for the unbounded one.
  // Throws std::domain_error for a point of the union.
  [[nodiscard]] uint32_t cell_of(int64_t x, int64_t y, int64_t z) const;

  // The balls of the tetrahedra in a component, ascending; for the unbounded one also the balls of the hull. In general
  // position those of them that belong to the complex are the balls with a face on the component: the free part of a
  // sphere has the shape of what the complex leaves free around the ball's centre. A ball outside the complex has no
  // face.
  [[nodiscard]] std::vector<uint32_t> balls_around(uint32_t cell) const;

 private:
  struct Tetrahedron {
    std::array<uint32_t, 4> ball;
    bool in_complex;
    uint32_t cell;
  };

  [[nodiscard]] int orientation(const std::array<uint32_t, 4> &balls) const;
  [[nodiscard]] bool is_empty(const std::array<uint32_t, 4> &tetrahedron) const;
  [[nodiscard]] std::optional<std::array<uint32_t, 4>> find_first() const;
  [[nodiscard]] std::optional<uint32_t> beyond(const std::array<uint32_t, 3> &triangle, uint32_t opposite) const;
  void find_tetrahedra();
  void join_cells();
  [[nodiscard]] bool conflicts(const std::array<uint32_t, 4> &tetrahedron, int orientation, uint32_t ball) const;
  [[nodiscard]] bool contains(const Tetrahedron &tetrahedron, const LatticeBall &point) const;

  Balls balls_;
  std::vector<Tetrahedron> tetrahedra_;
  std::set<uint32_t> hull_;
  uint32_t cells_ = 1;
};

}  // namespace oracle
