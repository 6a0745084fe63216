// The quad-edge structure of Guibas and Stolfi (ACM TOG 4, 1985): pure connectivity over arrays of ids.
//
// An edge e has four directed forms, its quarter-edges 4 e + k: k = 0 is the edge, k = 2 the edge in the other
// direction, k = 1 and k = 3 are the dual edges from its right to its left face and back. One table, onext, holds the
// rings of quarter-edges about their origins: vertices for even k and faces for odd k. Every other step is a lookup in
// this table with a few rotations before and after it.
//
// As an example edge 1, from vertex s to vertex t with face L on its left and R on its right:
//   4      from s to t, L on its left            sym(4) = 6, rot(4) = 5, inverse_rot(4) = 7
//   5      from R to L, s on its left
//   6      from t to s, R on its left
//   7      from L to R, t on its left            rot(7) = 4
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

constexpr uint32_t rot(uint32_t q) {
  return (q & ~3U) | ((q + 1) & 3U);
}
constexpr uint32_t inverse_rot(uint32_t q) {
  return (q & ~3U) | ((q + 3) & 3U);
}
constexpr uint32_t sym(uint32_t q) {
  return q ^ 2U;
}
constexpr uint32_t edge_of(uint32_t q) {
  return q / 4;
}
constexpr uint32_t quarter_edge(uint32_t edge) {
  return 4 * edge;
}

// inverse_rot for even q, rot for odd q: 0 <-> 3, 2 <-> 1.
constexpr uint32_t dual_on_left(uint32_t q) {
  return q ^ 3U;
}

// One of the two numbers of every quarter-edge. The eight numbers of an edge lie side by side in memory: they are read
// together, and a boundary has more edges than fit a cache.
class QuarterEdgeNumbers {
 public:
  QuarterEdgeNumbers() = default;
  QuarterEdgeNumbers(uint32_t *first, uint32_t size) : first_(first), size_(size) {}

  uint32_t operator[](uint32_t q) const { return first_[2 * static_cast<size_t>(q)]; }
  uint32_t &operator[](uint32_t q) { return first_[2 * static_cast<size_t>(q)]; }
  uint32_t size() const { return size_; }

 private:
  uint32_t *first_ = nullptr;
  uint32_t size_ = 0;
};

struct QuadEdges {
  QuarterEdgeNumbers next;   // onext
  QuarterEdgeNumbers start;  // vertex or face
  uint32_t edges = 0;
  Span<uint32_t> memory;  // of both numbers

  static constexpr uint32_t numbers_per_edge = 8;
  void bind(Span<uint32_t> numbers) {
    memory = numbers;
    const uint32_t quarter_edges = memory.size() / 2;
    next = {memory.data(), quarter_edges};
    start = {memory.empty() ? nullptr : memory.data() + 1, quarter_edges};
  }

  uint32_t onext(uint32_t q) const { return next[q]; }
  uint32_t lnext(uint32_t q) const { return rot(next[inverse_rot(q)]); }
  uint32_t origin(uint32_t q) const { return start[q]; }
  uint32_t left(uint32_t q) const { return start[inverse_rot(q)]; }

  // lnext() and left() of an even quarter-edge.
  uint32_t next_on_face(uint32_t q) const { return dual_on_left(next[dual_on_left(q)]); }
  uint32_t face_on_left(uint32_t q) const { return start[dual_on_left(q)]; }

  // Makes `after` follow `before` about the face on the left of both; both are even quarter-edges. The rings are
  // complete once every even quarter-edge has a successor.
  void link_lnext(uint32_t before, uint32_t after) {
    next[after] = sym(before);                         // sym(onext(after)) = before
    next[dual_on_left(before)] = dual_on_left(after);  // lnext(before) = after
  }
};

}  // namespace hsp
