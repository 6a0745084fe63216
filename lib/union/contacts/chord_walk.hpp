// Finds all chords that survive and all power vertices, ball after ball in grid order, each at the first of its balls.
//
// Most pairs of caps are never tried: a chord is found at one of its ends. The ends on the surface of the union are the
// boundary's vertices. Every other end is a power vertex, where four chords end, one for every three of its balls. So
// the walk goes from a known end along the chord to its other end: to the nearest cut by a later ball. Cuts by earlier
// balls have been found at these balls already. At the power vertex two more chords of the ball at hand begin. The
// fourth chord is that of the other three balls: it is kept until the first of these has its turn (an arrival).
//
// This finds every chord. On a sphere about the ball draw its contacts with later balls as points, its chords with
// later balls as edges, and its power vertices with later balls as triangles: a planar complex. From an edge that
// bounds a component of it the walk covers the whole component. A component without such an edge is a whole sphere. In
// that case the ball has no face, all balls that it is in contact with are later ones, and it has no power vertex with
// an earlier ball; so one chord is searched for among all pairs (chord_clipper.hpp). By Euler's formula a ball has less
// than three times as many chords with two later balls as contacts with later balls. By the same formula for all balls
// together there are no more power vertices than contacts.
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
  uint32_t new_chords;  // bits 0, 1 and 2: the chord of caps 01, 02 or 12 was not known before
};

class ChordWalk {
 public:
  void carve(Workspace &workspace, const ContactLimits &limits);

  // Called before the first ball. balls: how many there are in all, within the limits. The walk is asked about the
  // first `own` of them, one after the other.
  void start(uint32_t balls, uint32_t own);
  // Whether the next ball needs all of its caps. Else it needs those of later balls alone.
  bool asks_for_all_caps(const Boundary &boundary, uint32_t ball) const {
    return lost_ || (first_arrival_[ball] == no_id && !boundary.is_exposed(ball));
  }
  // Whether it can be seen at once that all chords of the next ball have two free ends. Then find() must not be called
  // for it; `ends` are the vertices of these chords, two consecutive ones for each chord.
  bool has_whole_chords(const Boundary &boundary, uint32_t ball, IdRange &ends);
  // If there are many caps, keeps those whose planes may touch the ball's power cell: find() finds the same with these.
  // If chords are searched for among all pairs of caps, fewer caps count as many.
  void keep_exposed(const Boundary &boundary, Caps &caps) const {
    constexpr uint32_t many_of_pairs = 32;
    const uint32_t many = asks_for_all_caps(boundary, caps.origin) ? many_of_pairs : ExposedCaps::fewest;
    if (caps.count >= many && !clipper_.exposed_caps().keep(ExposedCaps::Part::ball, caps, many)) caps.count = 0;
  }
  // Finds the caps of ball i by n later balls, which are in caps.ball, as gather_given() does, but in floats alone.
  // Doubles follow when floats do not tell where a chord is cut. False if there are many, or one cap is not certain.
  bool gather_in_floats(const BallSet &balls, uint32_t i, uint32_t n, Caps &caps);
  // Finds the chords and power vertices of the next ball. caps: without those of balls that lie inside others. Called
  // once for each ball that has caps and does not lie inside another one, in ascending order, unless has_whole_chords()
  // is true.
  void find(const Boundary &boundary, Caps &caps);

  // Whether find() looks for nothing, as the ball has many caps and there is not enough room for contacts anyhow. The
  // ball may then have as many contacts with later balls as it has later caps.
  bool skips(const Caps &caps) const { return lost_ && caps.count > MaskedChords::most_caps; }
  // The chords and power vertices of the ball at hand with later balls, in the order in which they are found.
  Span<const FoundChord> chords() const { return {chords_.data(), chord_count_}; }
  Span<const FoundVertex> vertices() const { return {vertices_.data(), vertex_count_}; }
  // The cap of a later ball that meets the ball at hand.
  uint32_t cap_of(uint32_t ball) const { return cap_of_ball_[ball]; }

  // Called after the last ball. Until the next start() the walk leaves some of its memory to the caller.
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
  CapPointers<float> floats_{};  // caps of the ball at hand in floats, in memory of the clipper; null if there are none
  bool lacks_doubles_ = false;   // whether the ball at hand has caps in floats alone
  Span<uint32_t> heads_;         // [neighbours] for ListedChords
  Span<uint32_t> cap_of_ball_;   // [balls]
  // An arrival is an end of a chord of three balls, in a power vertex that was found at the fourth ball. It is the end
  // at the side of p+ if the two later balls are stored in ascending order, else that at the side of p-.
  Span<uint32_t> first_arrival_;  // [balls] the list of arrivals of each first ball
  Span<uint32_t> arrival_balls_;  // [2 contacts] the two later balls of each
  Span<uint32_t> next_arrival_;   // [contacts]
  uint32_t arrivals_ = 0;         // how many places have ever been taken
  uint32_t spare_arrival_ = 0;    // the list, by next_arrival_, of places that are free again
  uint32_t own_ = 0;
  uint32_t next_vertex_ = 0;  // vertices are in the order of their first balls
  bool lost_ = false;  // there was no room for an arrival: from the next ball on all pairs are tried if caps are few
};

}  // namespace hsp
