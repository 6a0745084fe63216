// The polyhedron that contains the power cell of one ball (outer_cell.hpp). The planes of the ball's caps cut it, some
// caps at a time, and each cap has a state.
#pragma once

#include "sphere/caps.hpp"
#include "sphere/cell_ties.hpp"

namespace hsp {

// States of a cap:
//   dropped      the cap cannot matter
//   not_tried    it has not been looked at; values from here to below `waits` mean the same (ExposedCaps: size classes)
//   waits        its plane cuts less deep than the planes of others; it may cut later
//   has_cut      its plane has become a face
//   stays        nothing certain is known of it, or there was no room for its face: it is kept
//   near_vertex  its plane is too near a vertex of the polyhedron for doubles
//   tied + k     its plane goes through all vertices of set k of TiedSets
// Few caps are in a state from `waits` on. These states have the bit 0x80, by which they are found.
struct CapState {
  static constexpr uint8_t dropped = 0, not_tried = 1, waits = 0x80, has_cut = waits + 1, stays = waits + 2,
                           near_vertex = waits + 3, tied = waits + 4;
};

class CellCutting : private CapState {
 public:
  // The part that kept caps must tell about: the free part of the sphere, or the power cell inside the ball.
  enum class Part : uint8_t { sphere, ball };

  // balls_alone: `caps` has no doubles, only balls; doubles are made of the caps that are looked at. state: memory,
  // [caps]. box: the polyhedron at first.
  CellCutting(const Caps &caps, Part part, bool balls_alone, Span<uint8_t> state, const CellBox &box = {})
      : caps_(caps), part_(part), balls_alone_(balls_alone), state_(state) {
    cell_.start(box);
  }

  // Cuts by the caps whose planes go at least least_depth deep into the polyhedron; the other caps wait. False if
  // nothing is left. Functions with a CapBatch are out of line, so the batch is off the stack while integers decide.
  [[gnu::noinline]] bool cut_by(Span<const uint32_t> numbers, double least_depth);
  // Starts again from the cube, and cuts by the deepest of all caps each time: for caps that found no room. Gives up
  // soon if few caps drop out, as where all caps are small and matter.
  [[gnu::cold]] bool cut_anew(Span<uint32_t> numbers);
  // After a cut that left nothing: writes caps that together cover all, which are the faces and, if one cap holds all
  // of the polyhedron, that cap. Returns how many.
  uint32_t covering(Span<uint32_t> numbers) const;

  // Drops the caps that miss the polyhedron. A face never does: its plane goes through vertices.
  [[gnu::cold]] void drop(Span<const uint32_t> numbers);

  // Cuts by caps whose planes are near vertices; integers say on which side the vertices are. False if nothing is left.
  // Planes that go deep come first: where many planes have a line in common, two of them leave nearly nothing for the
  // others. In another order all might cut one after the other, until there is no room. Several caps are asked about at
  // once, but few after a cap that cuts, since the next one may cut, too.
  bool cut_by_integers(Span<uint32_t> numbers, const CellTies &ties);

  // Drops the caps that miss the polyhedron. If the plane of such a cap goes through vertices, the cap becomes `tied`
  // instead, or stays where `sets` has no room.
  void drop_by_integers(Span<uint32_t> numbers, const CellTies &ties, TiedSets &sets);

  const OuterCell &cell() const { return cell_; }
  bool some_wait() const { return some_wait_; }
  // Whether caps stay because there was no room for another face.
  bool lacks_room() const { return lacks_room_; }

 private:
  static OuterCell::Plane plane_of(const CapBatch &batch, uint32_t k, uint32_t number) {
    return {batch.ux[k], batch.uy[k], batch.uz[k], batch.b[k], number};
  }
  [[gnu::noinline]] OuterCell::Plane plane_of(uint32_t number) const;

  bool leaves_nothing() const { return part_ == Part::sphere && cell_.lies_inside_sphere(); }

  bool is_face(uint32_t number) const;

  // Whether a cap takes at most a point that does not matter to the part asked for (exact/PROOFS.md, section 7). Where
  // many planes go through one point off the sphere, integers would else be asked about it again and again.
  bool takes_nothing(const OuterCell::Plane &plane) const;

  struct Sides {
    static constexpr uint32_t most = 16;
    VertexSides sides[most];
    VertexBits on_plane[most];
  };
  // Finds on which side of the planes of the first caps the vertices lie, for as many caps as there is room. Returns
  // how many; 0 if the first one is not certain to be a proper circle. find_certain_sides: by doubles alone.
  uint32_t find_sides(Span<const uint32_t> numbers, const CellTies &ties, Sides &found);
  [[gnu::noinline]] uint32_t find_certain_sides(Span<const uint32_t> numbers, Sides &found) const;

  // Drops the caps that miss the polyhedron, and returns the others. goes_deep: whether one of their planes certainly
  // cuts; the plane that goes deepest is then the first. There is at least one cap.
  [[gnu::cold]] Span<uint32_t> keep_deepest_first(Span<uint32_t> numbers, bool &goes_deep);

  uint32_t may_cut(CapBatch &batch, uint32_t asked) const;

  // Loads the first caps, a whole batch if there are as many. False if the first is not certain to be a proper circle.
  bool load(Span<const uint32_t> numbers, CapBatch &batch) const;

  const Caps &caps_;
  Part part_;
  bool balls_alone_;
  Span<uint8_t> state_;
  OuterCell cell_;
  bool some_wait_ = false, lacks_room_ = false;
  uint32_t buried_by_ = no_id;  // the cap that holds all of the polyhedron
};

}  // namespace hsp
