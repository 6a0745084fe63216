// Bodies in an order in which each follows all those that it covers parts of. There may be none: sticks can lie one
// over the other around a circle.
#pragma once

#include "maps/stick_sweep.hpp"

namespace hsp {

class DrawingOrder {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Of the bodies that may come next always the one with the smallest depth; of equal ones the first. depth: by body.
  // Writes as many bodies into `order` as have a rank, and returns their number; the others lie over each other in
  // cycles, or over such. O((n + pairs) log n).
  uint32_t sort(Span<const StickPair> pairs, Span<const double> depth, Span<uint32_t> order);

  // A cycle, if the last order had no rank for some bodies: the last of its bodies, and how many it has.
  struct Cycle {
    uint32_t last, length;
  };
  Cycle find_cycle(Span<const StickPair> pairs, uint32_t bodies);

 private:
  BodiesAbove above_;
  Span<uint32_t> waiting_;  // [bodies] pairs whose lower body has no rank yet
  Span<uint32_t> heap_;     // [bodies]
};

}  // namespace hsp
