// Fills contacts: the pass over all balls of a boundary. Every chord is found at the first of its three balls in the
// grid's order, and its parts of their three contacts follow from exact integers rounded once: so they keep their
// digits where spheres nearly meet in one point.
#pragma once

#include "contacts/chord_parts.hpp"
#include "contacts/chord_walk.hpp"
#include "sphere/cube_candidates.hpp"

namespace hsp {

// Limits that suffice for most molecules, for a boundary whose balls meet at most so many others. Status::range if one
// would be larger than max_count.
constexpr Status default_contact_limits(uint32_t balls, uint32_t neighbours, ContactLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, neighbours, 12 * balls + 64, 0, 0};
  return Status::ok;
}

class ContactsBuilder {
 public:
  void carve(Workspace &workspace, const ContactLimits &limits);

  // Where balls of the grid stand around, of the contacts of all others; boundary then says of those at least which are
  // inside others. neighbours: what it needed of them. Status::capacity if a limit is too small; needed() then reports
  // what suffices, once `neighbours` does. Of contacts that may be more than there are, by no more than the triangles.
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours);

  const Contacts &contacts() const { return contacts_; }
  // Triangles and tetrahedra count if they have limits.
  const ContactLimits &needed() const { return needed_; }
  ContactLimits retry_limits() const { return limits_.covering(needed_); }
  // [contacts]
  Span<uint32_t> scratch() { return contacts_.a_.links; }
  // For tests, which break them.
  ContactArrays &arrays() { return contacts_.a_; }

 private:
  void clear(uint32_t balls);
  void gather_caps(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i, bool in_lanes);
  void start_ball(const Boundary &boundary);
  void recall_contacts();
  void add_chord(const BallSet &balls, const Boundary &boundary, const FoundChord &chord);
  void measure_chords(const BallSet &balls, const Boundary &boundary);
  void add_free_edges(const BallSet &balls, const Boundary &boundary);
  uint32_t contact_of_cap(uint32_t cap);
  uint32_t find_contact(uint32_t a, uint32_t b);
  Status check_capacity();
  void measure_contacts(const BallSet &balls, const Boundary &boundary);
  void make_rows(const CubeGrid &grid);
  void count_simplices(const Boundary &boundary);

  ContactLimits limits_;
  ContactLimits needed_;
  uint32_t own_balls_ = 0;  // the first ones
  Contacts contacts_;
  CubeCandidates candidates_;
  Caps caps_;
  ChordWalk walk_;
  ChordBatch chords_;              // that have been found, but not yet measured
  Span<uint32_t> contact_of_cap_;  // [neighbours] of the ball at hand, for later balls; no_id where none is known yet
};

}  // namespace hsp
