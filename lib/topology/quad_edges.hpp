// The quad-edge structure of Guibas and Stolfi (ACM TOG 4, 1985): pure connectivity over arrays of ids.
//
// An edge has four directed forms, its quarter-edges 4 e + k: k = 0 the edge, k = 2 the edge the other way, k = 1 and 3
// the dual edges from its right to its left face and back. One table, onext, holds the rings of quarter-edges about
// their origins, vertices for even k and faces for odd k; every other step is a few rotations around it.
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

// A number for every quarter-edge. An edge's four numbers of one kind and its four of the other lie side by side, as
// they are read together and a boundary has more edges than fit a cache.
class QuarterEdgeNumbers {
 public:
  QuarterEdgeNumbers() = default;
  QuarterEdgeNumbers(uint32_t *first, uint32_t size) : first_(first), size_(size) {}

  uint32_t operator[](uint32_t q) const { return first_[q + (q & ~3U)]; }
  uint32_t &operator[](uint32_t q) { return first_[q + (q & ~3U)]; }
  uint32_t size() const { return size_; }

 private:
  uint32_t *first_ = nullptr;
  uint32_t size_ = 0;
};

struct QuadEdges {
  QuarterEdgeNumbers next;   // onext
  QuarterEdgeNumbers start;  // vertex or face
  uint32_t edges = 0;

  static constexpr uint32_t numbers_per_edge = 8;
  void bind(Span<uint32_t> memory) {
    const uint32_t quarter_edges = memory.size() / 2;
    next = {memory.data(), quarter_edges};
    start = {memory.empty() ? nullptr : memory.data() + 4, quarter_edges};
  }

  uint32_t onext(uint32_t q) const { return next[q]; }
  uint32_t lnext(uint32_t q) const { return rot(next[inverse_rot(q)]); }
  uint32_t origin(uint32_t q) const { return start[q]; }
  uint32_t left(uint32_t q) const { return start[inverse_rot(q)]; }

  // Makes `after` the edge that follows `before` about the face on the left of both. The rings are complete once every
  // even quarter-edge has been given its successor.
  void link_lnext(uint32_t before, uint32_t after) {
    next[after] = sym(before);                       // sym(onext(after)) = before
    next[inverse_rot(before)] = inverse_rot(after);  // lnext(before) = after
  }
};

}  // namespace hsp
