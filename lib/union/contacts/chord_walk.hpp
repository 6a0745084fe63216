// All chords that survive and all power vertices, ball after ball in the grid's order, each at the first of its balls.
//
// Most pairs of caps are never tried: a chord is found at one of its ends. The ends on the surface of the union are the
// boundary's vertices. Every other one is a power vertex, and there four chords end, one for every three of its balls.
// So from an end that is known the walk goes along the chord to the other one: the nearest cut by a later ball, as
// nothing is left of chords that earlier balls cut but what those found. There begin two more chords of the ball at
// hand, and one of the other three balls, which is kept until the first of these has its turn.
//
// This finds every chord. On a sphere about the ball draw its contacts with later balls as points, chords as edges,
// power vertices as triangles: a planar complex, of which the walk goes through a whole component from each edge that
// bounds one. A component without such edges is a whole sphere, so the ball has no face, all balls that it is in
// contact with are later ones, and no power vertex with an earlier ball has it: then one chord is searched for among
// all pairs (chord_clipper.hpp). By Euler's formula a ball has less than three times as many chords with later balls as
// later contacts, and by the same for all balls there are no more power vertices than contacts.
#pragma once

#include "boundary/boundary.hpp"
#include "contacts/chord_clipper.hpp"
#include "contacts/chord_cuts.hpp"
#include "contacts/chord_tables.hpp"
#include "contacts/contacts.hpp"

namespace hsp {

// A power vertex of the ball at hand.
struct FoundVertex {
  uint32_t cap[3];      // ascending
  uint32_t new_chords;  // bits 0, 1 and 2 for the chords of caps 01, 02 and 12: it was not known before
};

class ChordWalk {
 public:
  void carve(Workspace &workspace, const ContactLimits &limits);

  // Before the first of all balls; there must be room for so many. Only the first `own` ones come.
  void start(uint32_t balls, uint32_t own);
  // Whether the next ball is to come with all of its caps. Else those of later balls do.
  bool asks_for_all_caps(const Boundary &boundary, uint32_t ball) const {
    return lost_ || (first_arrival_[ball] == no_id && !boundary.is_exposed(ball));
  }
  // Whether the next ball has no other chords than such with two free ends, as far as it can be seen at once. Then it
  // need not come, and `ends` are the vertices of these chords, two after two.
  bool has_whole_chords(const Boundary &boundary, uint32_t ball, IdRange &ends);
  // Of many caps keeps those whose planes may touch the ball's power cell: the same is found with these. Where one
  // chord is searched for among all pairs, fewer are many.
  void keep_exposed(const Boundary &boundary, Caps &caps) const {
    constexpr uint32_t many_of_pairs = 32;
    const uint32_t many = asks_for_all_caps(boundary, caps.origin) ? many_of_pairs : ExposedCaps::fewest;
    if (caps.count >= many && !clipper_.exposed_caps().keep(ExposedCaps::Part::ball, caps, many)) caps.count = 0;
  }
  // The caps of ball i by n later balls, which are in caps.ball, as gather_given() finds them, but first in floats, and
  // in doubles when these do not tell where a chord is cut. False if they are many or one is not certain.
  bool gather_in_floats(const BallSet &balls, uint32_t i, uint32_t n, Caps &caps);
  // The next ball of the boundary by its caps, without those of balls inside other ones. All others that have caps must
  // come, in ascending order, once.
  void find(const Boundary &boundary, Caps &caps);

  // Whether nothing is looked for, as the ball has many caps and there is no room for contacts anyhow: one with each
  // later ball is the most that there may be.
  bool skips(const Caps &caps) const { return lost_ && caps.count > MaskedChords::most_caps; }
  // Of the ball at hand and later ones, in the order in which they are found.
  Span<const FoundChord> chords() const { return {chords_.data(), chord_count_}; }
  Span<const FoundVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
  // The cap of a later ball that meets the ball at hand.
  uint32_t cap_of(uint32_t ball) const { return cap_of_ball_[ball]; }

  // When all balls have come. Until the next start the walk leaves some of its memory to others.
  struct SpareArrays {
    Span<uint32_t> of_contacts, of_balls;  // [2 contacts], [balls]
  };
  SpareArrays end() const {
    forget(arrival_balls_);
    forget(first_arrival_);
    return {arrival_balls_, first_arrival_};
  }

 private:
  class NearCuts;

  [[gnu::cold]] void try_all_pairs(const Caps &caps);
  template <class Chords>
  void walk(const Boundary &boundary, Caps &caps, Chords &&chords);
  template <class Chords>
  [[gnu::cold]] void start_from_any(const Caps &caps, Chords &chords);
  template <class Chords>
  void start_from_ends(const Boundary &boundary, const Caps &caps, Chords &chords);
  bool in_floats() const { return has_lanes && floats_.x != nullptr; }
  uint32_t cut_of(Caps &caps, const ChordEnd &end, Target target) {
    if constexpr (has_lanes) {
      const uint32_t cut = in_floats() ? nearest_cut(target, floats_, 0, caps.count, end.j, end.k, end.side) : no_cut;
      if (cut != no_cut) return cut;
    }
    return cut_in_doubles(caps, end, target);
  }
  uint32_t cut_in_doubles(Caps &caps, const ChordEnd &end, Target target);
  template <bool is_known, class Chords>
  void add_power_vertex(const Caps &caps, const ChordEnd &end, uint32_t clipper, Chords &chords);

  ChordClipper clipper_;
  Span<FoundChord> chords_;     // [3 neighbours]
  Span<FoundVertex> vertices_;  // [2 neighbours]
  uint32_t chord_count_ = 0, vertex_count_ = 0;
  CapPointers<float> floats_{};  // caps of the ball at hand, in memory of the clipper, if it has such
  bool lacks_doubles_ = false;   // and not yet others
  Span<uint32_t> heads_;         // [neighbours] for ListedChords
  Span<uint32_t> cap_of_ball_;   // [balls]
  // Arrivals: a chord of three balls, known at the fourth one of a power vertex. It ends there at the side of p+ if its
  // two later balls are ascending, else at that of p-.
  Span<uint32_t> first_arrival_;  // [balls] by first ball
  Span<uint32_t> arrival_balls_;  // [2 contacts] the two later ones
  Span<uint32_t> next_arrival_;   // [contacts]
  uint32_t arrivals_ = 0;         // places that have been taken
  uint32_t spare_arrival_ = 0;    // the first of those whose ball has come, by next_arrival_
  uint32_t own_ = 0;
  uint32_t next_vertex_ = 0;  // vertices are in the order of their first balls
  bool lost_ = false;         // there was no room for an arrival: from the next ball on all pairs of few caps are tried
};

}  // namespace hsp
