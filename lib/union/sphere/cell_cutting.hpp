// The polyhedron of one ball, cut by its caps some at a time, and what has become of these.
#pragma once

#include "sphere/caps.hpp"
#include "sphere/cell_ties.hpp"

namespace hsp {

// States of a cap. It is dropped; it is not looked at yet, in this state or one between it and the next; its plane cuts
// less deep than others do, and waits; it has cut; that is in doubt, and it stays; it is in doubt as it is near a
// vertex; or it goes through a set of vertices: that and the number of the set. Those from `waits` on are few and have
// a bit of their own.
struct CapState {
  static constexpr uint8_t dropped = 0, not_tried = 1, waits = 0x80, has_cut = waits + 1, stays = waits + 2,
                           near_vertex = waits + 3, tied = waits + 4;
};

class CellCutting : private CapState {
 public:
  // Of which the caps leave a part: of the sphere, or of the ball.
  enum class Part : uint8_t { sphere, ball };

  // balls_alone: of the caps the balls alone are known. state: memory, [caps]. box: where.
  CellCutting(const Caps &caps, Part part, bool balls_alone, Span<uint8_t> state, const CellBox &box = {})
      : caps_(caps), part_(part), balls_alone_(balls_alone), state_(state) {
    cell_.start(box);
  }

  // Cuts by those whose planes go deeper than that; the others wait. False if nothing is left. Out of line, as all that
  // has a batch: integers take the stack beside them.
  [[gnu::noinline]] bool cut_by(Span<const uint32_t> numbers, double least_depth);
  // The same from the start, the deepest of all first, for caps that stay. Ends soon where most matter, as studs do.
  [[gnu::cold]] bool cut_anew(Span<uint32_t> numbers);
  // After that, some that leave nothing, the faces: how many.
  uint32_t covering(Span<uint32_t> numbers) const;

  // Drops those that miss what is left. Faces do not: their planes go through vertices.
  [[gnu::cold]] void drop(Span<const uint32_t> numbers);

  // Cuts by caps whose planes are near vertices, by integers. False if nothing is left. Those that go deep come first:
  // where planes have a line in common two of them leave the others nearly nothing, which in another order may cut one
  // after the other, until there is no room. Many are asked about together, but few behind one that cuts, since the
  // next may, too.
  bool cut_by_integers(Span<uint32_t> numbers, const CellTies &ties);

  // Drops those of them that miss what is left, but for the planes that go through vertices.
  void drop_by_integers(Span<uint32_t> numbers, const CellTies &ties, TiedSets &sets);

  const OuterCell &cell() const { return cell_; }
  bool some_wait() const { return some_wait_; }
  // Whether some stay as there was no room for another face.
  bool lacks_room() const { return lacks_room_; }

 private:
  static OuterCell::Plane plane_of(const CapBatch &batch, uint32_t k, uint32_t number) {
    return {batch.ux[k], batch.uy[k], batch.uz[k], batch.b[k], number};
  }
  [[gnu::noinline]] OuterCell::Plane plane_of(uint32_t number) const;

  bool leaves_nothing() const { return part_ == Part::sphere && cell_.lies_inside_sphere(); }

  bool is_face(uint32_t number) const;

  // Where all planes go through one point that is not on the sphere, integers would be asked about it again and again.
  bool takes_nothing(const OuterCell::Plane &plane) const;

  struct Sides {
    static constexpr uint32_t most = 16;
    VertexSides sides[most];
    VertexBits on_plane[most];
  };
  // Of the first ones, as many as there is room for: of how many. 0 if the first is not certain to be a circle.
  uint32_t find_sides(Span<const uint32_t> numbers, const CellTies &ties, Sides &found);
  [[gnu::noinline]] uint32_t find_certain_sides(Span<const uint32_t> numbers, Sides &found) const;

  // Of one or more those that may cut, the one whose plane goes deepest first if one goes deeper than doubles can tell;
  // the others are dropped.
  [[gnu::cold]] Span<uint32_t> keep_deepest_first(Span<uint32_t> numbers, bool &goes_deep);

  uint32_t may_cut(CapBatch &batch, uint32_t asked) const;

  // The first ones, a whole batch if there are as many. False if the first is not certain to be a circle.
  bool load(Span<const uint32_t> numbers, CapBatch &batch) const;

  const Caps &caps_;
  Part part_;
  bool balls_alone_;
  Span<uint8_t> state_;
  OuterCell cell_;
  bool some_wait_ = false, lacks_room_ = false;
  uint32_t buried_by_ = no_id;
};

}  // namespace hsp
