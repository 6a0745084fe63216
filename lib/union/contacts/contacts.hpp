// The contacts between balls, and the share of the union that each ball has, by power distance.
//
// With pi_i(x) = |x - c_i|^2 - r_i^2, the share of ball i is the part of the union where pi_i is least. It is convex
// and lies in the ball. The contact of two balls is the plane piece where their shares meet: the disc of their circle,
// clipped by the other balls. It is empty unless an arc or all of their circle is free, or a chord that they share with
// a third ball survives (chord_clipper.hpp). A surviving chord is a triangle of the dual complex, and its ends that are
// power vertices are tetrahedra (Edelsbrunner 1995). By the symbolic perturbation, touching balls have contacts of area
// 0.
//
// All ids of balls are in grid order. Readers use the accessors of class Contacts.
#pragma once

#include "boundary/boundary.hpp"
#include "core/limits.hpp"

namespace hsp {

struct ContactLimits {
  uint32_t balls = 0, neighbours = 0, contacts = 0;
  uint32_t triangles = 0;   // 0: triangles are only counted
  uint32_t tetrahedra = 0;  // 0: tetrahedra are only counted
};

// A contact of two balls, in lattice steps.
struct ContactRecord {
  uint32_t ball[2];  // ascending
  uint32_t chords;   // how many chords bound the contact
  uint32_t code;
  double area;
  double rim;  // length of the free part of the circle

  static constexpr uint32_t arc_bit = 1;       // a part of the circle is free
  static constexpr uint32_t circle_bit = 2;    // all of the circle is free
  static constexpr uint32_t touching_bit = 4;  // the spheres only touch

  bool has_arc() const { return (code & arc_bit) != 0; }
  bool is_circle() const { return (code & circle_bit) != 0; }
  bool is_touching() const { return (code & touching_bit) != 0; }
  uint32_t other(uint32_t own) const { return ball[0] ^ ball[1] ^ own; }
};

// How a simplex of the dual complex lies to the boundary of the union:
//   triangle   singular if its chord has two free ends, regular with one, interior with none
//   edge       singular if the whole circle of its contact is free, regular if some arcs are, interior else
//   ball       interior without faces; with faces singular without contacts, else regular
enum class SimplexKind : uint32_t { singular, regular, interior };

struct TriangleRecord {
  uint32_t ball[3];    // ascending
  uint32_t free_ends;  // how many ends of its chord are free

  SimplexKind kind() const { return static_cast<SimplexKind>(2 - free_ends); }
};

struct TetrahedronRecord {
  uint32_t ball[4];  // ascending
};

struct SimplexCounts {
  uint32_t of[4][3] = {};  // by dimension and kind

  uint32_t dimension(uint32_t d) const { return of[d][0] + of[d][1] + of[d][2]; }
  int64_t euler() const {
    return static_cast<int64_t>(dimension(0)) - dimension(1) + dimension(2) - static_cast<int64_t>(dimension(3));
  }
};

// The memory, carved once for given limits.
struct ContactArrays {
  FixedVector<ContactRecord> contacts;
  FixedVector<TriangleRecord> triangles;
  FixedVector<TetrahedronRecord> tetrahedra;
  Span<uint32_t> links;         // [contacts] during the search: the next one with the same first ball; then scratch
  Span<uint32_t> row;           // [2 contacts] the contacts of each ball, by the caller's index of the other ball
  Span<uint32_t> first_in_row;  // [balls + 1]
  Span<double> share_volume;    // [balls]
  Span<double> contact_area;    // [balls] of all contacts of a ball together; periodic boxes do not use it
  SimplexCounts simplices;
  uint32_t balls = 0;

  void carve(Workspace &workspace, const ContactLimits &limits);
};

class Contacts {
 public:
  uint32_t ball_count() const { return a_.balls; }
  uint32_t contact_count() const { return a_.contacts.size(); }
  const ContactRecord &contact(uint32_t id) const { return a_.contacts[id]; }
  // The contacts of a ball, ascending by the other ball in the caller's order.
  Span<const uint32_t> row(uint32_t ball) const {
    return a_.row.part(a_.first_in_row[ball], a_.first_in_row[ball + 1]);
  }
  double share_volume(uint32_t ball) const { return a_.share_volume[ball]; }
  double contact_area(uint32_t ball) const { return a_.contact_area[ball]; }

  const SimplexCounts &simplices() const { return a_.simplices; }
  // The triangles and tetrahedra for which there was room.
  Span<const TriangleRecord> triangles() const { return a_.triangles.items(); }
  Span<const TetrahedronRecord> tetrahedra() const { return a_.tetrahedra.items(); }

 private:
  friend class ContactsBuilder;

  ContactArrays a_;
};

}  // namespace hsp
