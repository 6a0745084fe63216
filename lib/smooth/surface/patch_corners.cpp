#include "surface/patch_corners.hpp"

namespace hsp {
namespace {

class Joiner {
 public:
  Joiner(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches)
      : boundary_(boundary),
        cusped_(cusped),
        patience_(patience),
        patches_(patches),
        first_cusp_(3 * boundary.vertex_count()),
        first_crease_corner_(first_cusp_ + 2 * cusped.count()) {}

  uint32_t join() {
    // A cusp is known by the corner at the other end of its side, so those come first; then the corners of three
    // patches at the first of these, before the other two.
    for_each_joint([this](uint32_t v, uint32_t before, uint32_t after) { number_own_corner(v, before, after); });
    for_each_joint([this](uint32_t v, uint32_t before, uint32_t after) { number_cusp(v, before, after); });
    for_each_joint([this](uint32_t v, uint32_t before, uint32_t after) { find_owner(v, before, after); });
    patches_.crease_corners().count();
    const uint32_t corners = patches_.crease_corners().size();
    for (uint32_t k = 0; k < corners; ++k) {
      patches_.arc(patches_.crease_corners().member(k)).corner = first_crease_corner_ + k;
    }
    for_each_joint([this](uint32_t v, uint32_t before, uint32_t after) { find_crease_corner(v, before, after); });
    // Every arc of a cusped circle has two ends, with both cusps at each.
    open_ += difference(cusps_, 4 * cusped_.arcs()) + difference(met_, 2 * corners);
    for_each_arc([this](uint32_t v, uint32_t a) { find_twin(v, a); });
    patches_.creases().count();
    return open_;
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
  // Calls visit(vertex, arc, next arc), but not for whole circles.
  template <class Visit>
  void for_each_joint(Visit visit) {
    for_each_arc([&](uint32_t v, uint32_t a) {
      const uint32_t next = patches_.arc(a).next;
      if (next != a) visit(v, a, next);
    });
  }

  void number_own_corner(uint32_t v, uint32_t before, uint32_t after) {
    PatchArc &arc = patches_.arc(after);
    const PatchArc &last = patches_.arc(before);
    if (last.is_side() && arc.is_side()) arc.corner = 3 * v + (3 - last.slot() - arc.slot());
  }

  void number_cusp(uint32_t v, uint32_t before, uint32_t after) {
    PatchArc &arc = patches_.arc(after);
    const PatchArc &last = patches_.arc(before);
    if (last.is_side() == arc.is_side()) return;
    const PatchArc &side = last.is_side() ? last : arc;
    // The corner at the other end of this piece of the side.
    const uint32_t corner = last.is_side() ? last.corner : patches_.arc(arc.next).corner;
    const VertexRecord &vertex = boundary_.vertex(v);
    const uint32_t a = side.slot() == 0 ? 1 : 0;
    const uint32_t b = side.slot() == 2 ? 1 : 2;
    const uint32_t circle = cusped_.of_arc(vertex.ball[a], vertex.ball[b]);
    if (circle == no_id || corner >= first_cusp_) {
      ++open_;
      return;
    }
    arc.corner = first_cusp_ + 2 * circle + (corner == 3 * v + a ? 0 : 1);
    ++cusps_;
  }

  bool is_crease_corner(uint32_t before, uint32_t after) const {
    return !patches_.arc(before).is_side() && !patches_.arc(after).is_side();
  }

  void find_owner(uint32_t v, uint32_t before, uint32_t after) {
    if (!is_crease_corner(before, after)) return;
    if (v < patches_.arc(after).across && v < patches_.arc(before).across) patches_.crease_corners().set(after);
  }

  // Around the corner of three probes one comes after v and one before it: in the patch of v a loop arrives on the
  // crease to the one before and leaves on that to the one after. So it does, in this order, in all three patches.
  void find_crease_corner(uint32_t v, uint32_t before, uint32_t after) {
    PatchArc &arc = patches_.arc(after);
    if (!is_crease_corner(before, after) || arc.corner != no_id) return;
    const uint32_t following = arc.across;
    const uint32_t preceding = patches_.arc(before).across;
    const bool owner_follows = following < preceding;
    const uint32_t owner = owner_follows ? following : preceding;
    const uint32_t arrive = owner_follows ? v : following;
    const uint32_t leave = owner_follows ? preceding : v;
    for (const uint32_t a : patches_.arcs_of_vertex(owner)) {
      const uint32_t next = patches_.arc(a).next;
      if (patches_.arc(a).across == arrive && patches_.arc(next).across == leave) {
        arc.corner = patches_.arc(next).corner;
        ++met_;
        return;
      }
    }
    ++open_;
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
      patches_.creases().set(a);
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
  const uint32_t first_cusp_, first_crease_corner_;
  uint32_t cusps_ = 0;
  uint32_t met_ = 0;
  uint32_t open_ = 0;
};

}  // namespace

uint32_t join_patches(const Boundary &boundary, const CuspedCircles &cusped, Patience &patience, CutPatches &patches) {
  return Joiner(boundary, cusped, patience, patches).join();
}

}  // namespace hsp
