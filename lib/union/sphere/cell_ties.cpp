// Decides by integers on which side of a plane a vertex is.
//
// As an example a ball and four others, whose spheres all go through one point. On the first ball the planes of the
// four others go through this point. Of the inflated balls any three of these planes meet in a point of their own
// nearby, and the fourth plane either cuts that point off or does not.
#include "sphere/cell_ties.hpp"

#include "exact/power_vertex.hpp"

namespace hsp {
namespace {

uint64_t has(const uint64_t (&bits)[2], uint32_t vertex) {
  return bits[vertex / 64] >> vertex % 64 & 1U;
}

// If vertex v is on a side of the cube: a vertex before v, one of `among`, on the line of the two other planes of v;
// else, or if there is none, v. The planes of spheres through two common points are parallel to that line, so that all
// of the line is on one side of such a plane.
uint32_t other_end(const OuterCell &cell, uint32_t v, const uint64_t (&among)[2]) {
  const uint8_t *const face = cell.face[v];
  uint32_t side = 0;
  while (side < 3 && cell.cap[face[side]] != no_id) ++side;
  if (side == 3) return v;
  const uint32_t p = face[(side + 1) % 3], q = face[(side + 2) % 3];
  for (uint32_t u = 0; u < v; ++u) {
    if (!has(among, u)) continue;
    const uint8_t *const of = cell.face[u];
    for (uint32_t k = 0; k < 3; ++k) {
      if (of[k] == q && of[(k + 1) % 3] == p) return u;
    }
  }
  return v;
}

}  // namespace

exact::Plane CellTies::plane_of(const OuterCell &cell, uint32_t face) const {
  if (cell.cap[face] != no_id) return caps_.plane(cell.cap[face]);
  const auto part = [](double u) { return static_cast<int64_t>(u) * CellBox::side_denominator; };
  return exact::virtual_plane({part(cell.ux[face]), part(cell.uy[face]), part(cell.uz[face])},
                              2 * caps_.balls().ball(caps_.origin).radius * CellBox::side_numerator);
}

void CellTies::decide(const OuterCell &cell, Span<const uint32_t> numbers, VertexSides *sides,
                      VertexBits *on_plane) const {
  const uint32_t count = numbers.size();
  uint64_t unsure[2] = {0, 0};
  for (uint32_t k = 0; k < count; ++k) {
    for (uint32_t word = 0; word < 2; ++word) unsure[word] |= sides[k].unsure[word];
  }
  for (uint32_t v = 0; v < cell.vertices; ++v) {
    if (!has(unsure, v)) continue;
    const uint8_t *const face = cell.face[v];
    const uint32_t end = other_end(cell, v, unsure);
    const exact::Plane planes[3] = {plane_of(cell, face[0]), plane_of(cell, face[1]), plane_of(cell, face[2])};
    const exact::PowerVertex vertex(caps_.sphere, planes);
    for (uint32_t k = 0; k < count; ++k) {
      if (!has(sides[k].unsure, v)) continue;
      const exact::Plane plane = caps_.plane(numbers[k]);
      if (end < v && has(sides[k].unsure, end) && vertex.moves_along(plane)) {
        sides[k].outside[v / 64] |= has(sides[k].outside, end) << v % 64;
        on_plane[k].word[v / 64] |= has(on_plane[k].word, end) << v % 64;
        continue;
      }
      const exact::Sign nearer = vertex.near(plane);
      exact::count_answer(exact::Question::near, nearer.tied ? exact::Stage::perturbation : exact::Stage::exact);
      if (nearer.sign < 0) sides[k].outside[v / 64] |= uint64_t{1} << v % 64;
      if (nearer.tied) on_plane[k].word[v / 64] |= uint64_t{1} << v % 64;
    }
  }
  for (uint32_t k = 0; k < count; ++k) sides[k].unsure[0] = sides[k].unsure[1] = 0;
}

uint32_t TiedSets::number_of(const VertexBits &set) {
  for (uint32_t k = 0; k < count_; ++k) {
    if (set_[k].contains(set) && set.contains(set_[k])) return k;
  }
  if (count_ == most) return most;
  set_[count_] = set;
  return count_++;
}

void TiedSets::keep(uint32_t number) {
  for (uint32_t k = 0; k < count_; ++k) kept_ |= set_[number].contains(set_[k]) ? 1U << k : 0U;
}

}  // namespace hsp
