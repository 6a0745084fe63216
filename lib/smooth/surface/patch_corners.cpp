#include "surface/patch_corners.hpp"

namespace hsp {
namespace {

// A crease is measured in both of its patches, and each patch has found its ends on its own. The two angles agree up to
// this if doubles are precise enough.
constexpr double crease_tolerance = 1e-6;

class Joiner {
 public:
  Joiner(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches)
      : boundary_(boundary),
        cusped_(cusped),
        patience_(patience),
        patches_(patches),
        first_crease_corner_(3 * boundary.vertex_count() + 2 * cusped.count()) {}

  uint32_t join() {
    // In the order of vertices: the first of the patches at a corner of three creases comes before the other two.
    for_each_arc([this](uint32_t v, uint32_t a) { number_end(v, a); });
    for_each_arc([this](uint32_t v, uint32_t a) { find_twin(v, a); });
    patches_.number_joints(first_crease_corner_);
    // Every arc of a cusped circle has two ends, and both cusps are found at each end.
    return open_ + difference(cusps_, 4 * cusped_.arcs()) + difference(met_, 2 * patches_.crease_corners().size());
  }

 private:
  static uint32_t difference(uint32_t a, uint32_t b) { return a < b ? b - a : a - b; }

  template <class Visit>
  void for_each_arc(Visit visit) {
    for (uint32_t piece = 0; piece < patches_.piece_count(); ++piece) {
      if (!patience_.allows(100 * uint64_t{patches_.arcs(piece).size()})) return;
      for (const uint32_t a : patches_.arcs(piece)) visit(patches_.piece(piece).vertex, a);
    }
  }

  // Numbers the corner at the end of arc a, where the next arc begins. A side runs from its second ball to its first;
  // between the two it has its cusps, if any.
  void number_end(uint32_t v, uint32_t a) {
    const PatchArc &last = patches_.arc(a);
    PatchArc &arc = patches_.arc(last.next);
    if (last.next == a) return;
    if (last.is_side() && arc.is_side()) {
      arc.corner = 3 * v + (3 - last.slot() - arc.slot());
    } else if (last.is_side() || arc.is_side()) {
      const VertexRecord &vertex = boundary_.vertex(v);
      const SideOfPatch side = side_of_patch(vertex, (last.is_side() ? last : arc).slot());
      const uint32_t at = vertex.ball[last.is_side() ? side.second : side.first];
      const uint32_t cusp = cusped_.cusp(vertex.ball[side.first], vertex.ball[side.second], at);
      if (cusp != no_id) arc.corner = 3 * boundary_.vertex_count() + cusp;
      ++(cusp != no_id ? cusps_ : open_);
    } else if (v < arc.across && v < last.across) {
      arc.corner = first_crease_corner_ + last.next;
    } else {
      arc.corner = corner_at_first(v, last.across, arc.across);
      ++(arc.corner != no_id ? met_ : open_);
    }
  }

  // Around the corner of three probes, one probe precedes that of v and one follows it. In the patch of v the loop
  // arrives on the crease to the preceding probe and leaves on the crease to the following one. The same holds, in this
  // cyclic order, in all three patches.
  uint32_t corner_at_first(uint32_t v, uint32_t preceding, uint32_t following) const {
    const bool is_following = following < preceding;
    const uint32_t arrive = is_following ? v : following, leave = is_following ? preceding : v;
    for (const uint32_t a : patches_.arcs_of_vertex(is_following ? following : preceding)) {
      const PatchArc &next = patches_.arc(patches_.arc(a).next);
      if (patches_.arc(a).across == arrive && next.across == leave) return next.corner;
    }
    return no_id;
  }

  // A crease runs the other way in the patch across it.
  void find_twin(uint32_t v, uint32_t a) {
    PatchArc &arc = patches_.arc(a);
    if (arc.is_side() || arc.twin != no_id) return;
    for (const uint32_t b : patches_.arcs_of_vertex(arc.across)) {
      PatchArc &other = patches_.arc(b);
      if (other.across != v || other.twin != no_id || other.corner != patches_.end_corner(a) ||
          patches_.end_corner(b) != arc.corner)
        continue;
      arc.twin = b;
      other.twin = a;
      const double off = arc.angle - other.angle;
      if (!(off <= crease_tolerance && -off <= crease_tolerance)) ++open_;
      return;
    }
    ++open_;
  }

  const Boundary &boundary_;
  const CuspedCircles &cusped_;
  Patience &patience_;
  CutPatches &patches_;
  const uint32_t first_crease_corner_;
  uint32_t cusps_ = 0, met_ = 0, open_ = 0;
};

}  // namespace

uint32_t join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches) {
  return Joiner(boundary, cusped, patience, patches).join();
}

}  // namespace hsp
