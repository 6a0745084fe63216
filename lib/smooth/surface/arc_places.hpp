// Positions of the arcs around a patch, in numbers of any width.
#pragma once

#include "surface/actual_decisions.hpp"
#include "surface/cut_patches.hpp"
#include "surface/patch_loops.hpp"

namespace hsp {

// An arc runs about `axis`, in the plane through `middle`. `middle` is relative to the vertex of the patch; `start` and
// `end` are relative to `middle`.
template <class Number>
struct ArcPlace {
  NumberVector<Number> axis, middle, start, end;
};

template <class Number>
void find_axis(const ActualPoints<Number> &actual, uint32_t vertex, uint32_t across, NumberVector<Number> &axis) {
  if ((across & PatchArc::side_bit) == 0) return actual.find_arm_to_vertex(vertex, across, axis);
  const VertexRecord &record = actual.boundary.vertex(vertex);
  const SideOfPatch side = side_of_patch(record, across & ~PatchArc::side_bit);
  actual.find_inward(vertex, record.ball[side.second], record.ball[side.first], axis);
}
// A function of its own, so that its temporaries are not on the stack while ends are computed.
template <class Number>
[[gnu::noinline]] void find_middle(const ActualPoints<Number> &actual, const BorderArc &arc, ArcPlace<Number> &place) {
  place.middle = place.axis;
  place.middle *= arc.is_side() ? actual.number(0) : actual.number(1).scaled(-1);
}
template <class Number>
[[gnu::noinline]] void find_place(const ActualPoints<Number> &actual, uint32_t vertex, const BorderArc &arc,
                                  ArcPlace<Number> &place) {
  find_axis(actual, vertex, arc.across, place.axis);
  find_middle(actual, arc, place);
  if (arc.is_whole()) return;
  actual.find_arm(vertex, arc.from, place.start);
  actual.find_arm(vertex, arc.to, place.end);
  place.start -= place.middle;
  place.end -= place.middle;
}

}  // namespace hsp
