// Fills contacts: the pass over all balls of a boundary. Every chord is found at the first of its three balls in the
// grid's order, and its parts of their three contacts follow from exact integers rounded once: so they keep their
// digits where spheres nearly meet in one point.
#pragma once

#include "contacts/chord_parts.hpp"
#include "contacts/chord_walk.hpp"
#include "model/block_sweep.hpp"
#include "sphere/cube_candidates.hpp"

namespace hsp {

// Limits that suffice for most molecules, for a boundary whose balls meet at most so many others. Status::range if one
// would be larger than max_count.
constexpr Status default_contact_limits(uint32_t balls, uint32_t neighbours, ContactLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, neighbours, 12 * balls + 64, 0, 0};
  return Status::ok;
}

// Two balls in the grid's order; no_id for none.
struct ContactPair {
  uint32_t ball[2];
};

// For sets whose halo, if any, has no images of other balls.
struct NoImages {
  static constexpr bool there = false;
  static constexpr bool comes_before_its_ball(uint32_t) { return false; }
  static constexpr uint32_t ball_of(uint32_t image) { return image; }
  // Ball or image `other`, moved as `image` is to be moved back to its ball.
  static constexpr uint32_t moved_back(uint32_t other, uint32_t) { return other; }
};

class ContactsBuilder : public Limited<ContactLimits> {
 public:
  void carve(Workspace &workspace, const ContactLimits &limits);

  // Of the contacts of all balls that are not in the grid's halo; the boundary says at least which balls of the halo
  // are inside others. neighbours: what it needed of them. Status::capacity if a limit is too small; needed() then
  // reports what suffices, once `neighbours` does; of triangles and tetrahedra if they have limits. Of contacts that
  // may be more than there are, by no more than the triangles.
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours) {
    return build(grid, boundary, neighbours, NoImages{});
  }

  // For a halo that may have images of the other balls, in a box whose copies fill space. A chord that lies
  // across its faces is found once in each copy that holds one of its balls. It is computed in the one where no image
  // comes before its ball, an order that all copies share, and what it says of two images goes to their copies in the
  // box. Every contact of a ball and an image is there from both sides, the same bit for bit. Status::check if an image
  // is missing.
  template <class Images>
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours, const Images &images) {
    if (!start(grid, neighbours, boundary.target())) return Status::capacity;
    BlockSweep sweep(grid);
    for (uint32_t cube = 0; cube < grid.own_cubes(); ++cube) {
      const CubeBlock &block = sweep.block_around(cube);
      const BallRange own = grid.balls_in(cube);
      const bool in_lanes = start_cube(grid, cube, block);
      for (uint32_t i = own.first; i < own.last; ++i) {
        if (boundary.is_contained(i)) continue;
        start_ball(grid.balls(), boundary, block, i, in_lanes);
        bool some_elsewhere = false;
        for (uint32_t k = caps_.count; Images::there && k > caps_.first_later; --k) {
          const uint32_t ball = caps_.ball[k - 1];
          if (ball < own_balls_) break;
          if (!images.comes_before_its_ball(ball)) continue;
          contact_of_cap_[k - 1] = elsewhere;
          some_elsewhere = true;
        }
        find_chords(boundary);
        walk_.visit([&](const FoundChord &chord) {
          const uint32_t j = chord.cap[0], k = chord.cap[1];
          if (some_elsewhere && (contact_of_cap_[j] == elsewhere || contact_of_cap_[k] == elsewhere)) return;
          add_chord(grid.balls(), boundary, chord, place_in_box({{caps_.ball[j], caps_.ball[k]}}, images));
        });
        add_free_edges(grid.balls(), boundary);
      }
    }
    measure_chords(grid.balls(), boundary);
    measure_contacts(grid.balls(), boundary);
    if (!add_other_sides(images)) return Status::check;
    if (const Status status = check_capacity(); status != Status::ok) return status;
    close_shares();
    make_rows(grid);
    count_simplices(boundary);
    return Status::ok;
  }

  const Contacts &contacts() const { return contacts_; }
  // [contacts]
  Span<uint32_t> scratch() { return contacts_.a_.links; }
  // For tests, which break them.
  ContactArrays &arrays() { return contacts_.a_; }

 private:
  // Instead of a contact: it was counted, but there was no room for it; and of the contact of a cap: it is kept where
  // it is found in another copy of the box.
  static constexpr uint32_t no_room = no_id - 1;
  static constexpr uint32_t elsewhere = no_id - 2;

  bool start(const CubeGrid &grid, uint32_t neighbours, Target target);
  void clear(uint32_t balls);
  bool start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block);
  void gather_caps(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i, bool in_lanes);
  void start_ball(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i, bool in_lanes);
  void find_chords(const Boundary &boundary);
  // `last`: where the contact of the chord's two last balls is kept.
  void add_chord(const BallSet &balls, const Boundary &boundary, const FoundChord &chord, const ContactPair &last);
  void complete_chords(const BallSet &balls, const Boundary &boundary);
  void measure_chords(const BallSet &balls, const Boundary &boundary);
  void add_free_edges(const BallSet &balls, const Boundary &boundary);
  uint32_t contact_of_cap(uint32_t cap);
  uint32_t find_contact(uint32_t a, uint32_t b);
  uint32_t add_contact(uint32_t a, uint32_t b);
  Status check_capacity();
  void measure_contacts(const BallSet &balls, const Boundary &boundary);
  void close_shares();
  void make_rows(const CubeGrid &grid);
  void count_simplices(const Boundary &boundary);

  // Where the contact of two balls is kept, of which no image comes before its ball.
  template <class Images>
  ContactPair place_in_box(const ContactPair &pair, const Images &images) const {
    const auto [first, second] = pair.ball;
    if (first < own_balls_) return pair;
    if constexpr (!Images::there) return {{no_id, no_id}};
    const uint32_t ball = images.ball_of(first);
    const uint32_t other = images.moved_back(second, first);
    if (other < own_balls_) return {{ball < other ? ball : other, ball < other ? other : ball}};
    if (other != no_id && !images.comes_before_its_ball(other)) return {{ball, other}};
    return {{images.ball_of(second), images.moved_back(first, second)}};
  }

  // Contacts with images from the images' balls, and these balls' part of them. False if an image is missing.
  template <class Images>
  bool add_other_sides(const Images &images) {
    if constexpr (!Images::there) return true;
    ContactArrays &a = contacts_.a_;
    const uint32_t count = a.contacts.size();
    for (uint32_t id = 0; id < count; ++id) {
      const ContactRecord contact = a.contacts[id];
      const auto [own, image] = contact.ball;
      if (image < own_balls_) continue;
      ContactRecord other_side = contact;
      other_side.ball[0] = images.ball_of(image);
      other_side.ball[1] = images.moved_back(own, image);
      if (other_side.ball[1] == no_id) return false;
      a.contacts.push(other_side);
    }
    if (lost_across_ > 0) a.contacts.set_count(a.contacts.required() + lost_across_);
    for (uint32_t image = own_balls_; image < a.balls; ++image) {
      a.share_volume[images.ball_of(image)] += a.share_volume[image];
      a.contact_area[images.ball_of(image)] += a.contact_area[image];
    }
    return true;
  }

  uint32_t own_balls_ = 0;    // the first ones
  uint32_t lost_across_ = 0;  // contacts with others for which there was no room
  Contacts contacts_;
  CubeCandidates candidates_;
  Caps caps_;
  ChordWalk walk_;
  ChordBatch chords_;              // that have been found, but not yet measured
  Span<uint32_t> contact_of_cap_;  // [neighbours] of the ball at hand, for later balls; no_id where there is none yet
};

}  // namespace hsp
