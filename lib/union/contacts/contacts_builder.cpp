#include "contacts/contacts_builder.hpp"

#include <limits>

#include "contacts/contact_measures.hpp"
#include "core/rows.hpp"
#include "exact/discriminant.hpp"
#include "measure/areas.hpp"

namespace hsp {
namespace {

// Of an end of a chord that something clips.
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// The balls of a block from ball i on.
CubeBlock part_from(const CubeBlock &block, uint32_t i) {
  CubeBlock part;
  part.ranges = 0;
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange &range = block.range[k];
    if (range.last > i) part.range[part.ranges++] = {range.first > i ? range.first : i, range.last};
  }
  return part;
}

}  // namespace

void ContactArrays::carve(Workspace &workspace, const ContactLimits &limits) {
  const uint64_t most_contacts = limits.contacts;
  const uint64_t most_balls = limits.balls;
  contacts = FixedVector<ContactRecord>(workspace.take<ContactRecord>(most_contacts));
  triangles = FixedVector<TriangleRecord>(workspace.take<TriangleRecord>(limits.triangles));
  tetrahedra = FixedVector<TetrahedronRecord>(workspace.take<TetrahedronRecord>(limits.tetrahedra));
  links = workspace.take<uint32_t>(most_contacts);
  row = workspace.take<uint32_t>(2 * most_contacts);
  first_in_row = workspace.take<uint32_t>(most_balls + 1);
  share_volume = workspace.take<double>(most_balls);
  contact_area = workspace.take<double>(most_balls);
}

void ContactsBuilder::carve(Workspace &workspace, const ContactLimits &limits) {
  limit(limits);
  contacts_.a_.carve(workspace, limits);
  caps_.carve(workspace, limits.neighbours);
  walk_.carve(workspace, limits);
  contact_of_cap_ = workspace.take<uint32_t>(limits.neighbours);
}

bool ContactsBuilder::start(const CubeGrid &grid, uint32_t neighbours, Target target) {
  const uint32_t balls = grid.balls().n;
  clear(balls);
  own_balls_ = grid.own_balls();
  lost_across_ = 0;
  needed_.neighbours = neighbours;
  if (balls > limits_.balls || neighbours > limits_.neighbours) return false;
  walk_.start(balls, own_balls_);
  candidates_.start(contacts_.a_.row, target);
  return true;
}

void ContactsBuilder::clear(uint32_t balls) {
  ContactArrays &a = contacts_.a_;
  needed_ = {balls, 0, 0, 0, 0};
  chords_.count = 0;
  a.contacts.clear();
  a.triangles.clear();
  a.tetrahedra.clear();
  a.simplices = {};
  a.balls = balls;
  if (balls > limits_.balls) return;
  // While contacts are found, the first one of each ball with later balls.
  for (uint32_t i = 0; i <= balls; ++i) a.first_in_row[i] = no_id;
  for (uint32_t i = 0; i < balls; ++i) a.share_volume[i] = a.contact_area[i] = 0.0;
}

uint32_t ContactsBuilder::find_contact(uint32_t a, uint32_t b) {
  const ContactArrays &arrays = contacts_.a_;
  for (uint32_t id = arrays.first_in_row[a]; id != no_id; id = arrays.links[id]) {
    if (arrays.contacts[id].ball[1] == b) return id;
  }
  return add_contact(a, b);
}

uint32_t ContactsBuilder::add_contact(uint32_t a, uint32_t b) {
  ContactArrays &arrays = contacts_.a_;
  const bool fits = arrays.contacts.required() < arrays.contacts.capacity();
  const uint32_t id = arrays.contacts.size();
  arrays.contacts.push({{a, b}, 0, 0, 0.0, 0.0});
  if (!fits) {
    lost_across_ += b < own_balls_ ? 0U : 1U;
    return no_room;
  }
  arrays.links[id] = arrays.first_in_row[a];
  arrays.first_in_row[a] = id;
  return id;
}

// Those of later balls, or all.
void ContactsBuilder::gather_caps(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i,
                                  bool in_lanes) {
  if (walk_.asks_for_all_caps(boundary, i)) return caps_.gather(balls, block, i, nullptr);
  if (in_lanes) {
    const uint32_t found = candidates_.later(i, caps_.ball.data(), caps_.capacity());
    if (found <= caps_.capacity()) return caps_.gather_given(balls, i, found);
  }
  caps_.gather(balls, part_from(block, i + 1), i, nullptr);
}

bool ContactsBuilder::start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block) {
  const uint32_t first = grid.balls_in(cube).first;
  return candidates_.start_cube(grid, cube, first, part_from(block, first));
}

void ContactsBuilder::start_ball(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i,
                                 bool in_lanes) {
  gather_caps(balls, boundary, block, i, in_lanes);
  const auto is_inside = [&boundary](uint32_t ball) { return boundary.is_contained(ball); };
  bool any_inside = false;
  for (uint32_t k = 0; k < caps_.count; ++k) any_inside = any_inside || is_inside(caps_.ball[k]);
  if (any_inside) caps_.keep_if([&is_inside](uint32_t j) { return !is_inside(j); });
  caps_.first_later = 0;
  while (caps_.first_later < caps_.count && caps_.ball[caps_.first_later] < caps_.origin) ++caps_.first_later;
  for (uint32_t k = caps_.first_later; k < caps_.count; ++k) contact_of_cap_[k] = no_id;
}

// And the contacts of the ball at hand with later ones that chords at other balls have.
void ContactsBuilder::find_chords(const Boundary &boundary) {
  walk_.find(boundary, caps_);
  const ContactArrays &a = contacts_.a_;
  for (uint32_t id = a.first_in_row[caps_.origin]; id != no_id; id = a.links[id]) {
    contact_of_cap_[walk_.cap_of(a.contacts[id].ball[1])] = id;
  }
}

// In a box chords of this ball also find contacts of it that are kept here and seen as those of two images.
uint32_t ContactsBuilder::contact_of_cap(uint32_t cap) {
  uint32_t &id = contact_of_cap_[cap];
  if (id == no_id) {
    const bool is_new = own_balls_ == contacts_.a_.balls;
    id = is_new ? add_contact(caps_.origin, caps_.ball[cap]) : find_contact(caps_.origin, caps_.ball[cap]);
  }
  return id == elsewhere ? no_room : id;
}

void ContactsBuilder::add_chord(const BallSet &balls, const Boundary &boundary, const FoundChord &chord,
                                const ContactPair &last) {
  const auto [j, k] = chord.cap;
  const uint32_t s = chords_.count++;
  chords_.ball[0][s] = caps_.origin;
  chords_.ball[1][s] = caps_.ball[j];
  chords_.ball[2][s] = caps_.ball[k];
  chords_.clipper[0][s] = chord.clipper[0];
  chords_.clipper[1][s] = chord.clipper[1];
  chords_.vertex[s] = chord.vertex;
  chords_.contact[0][s] = contact_of_cap(j);
  chords_.contact[1][s] = contact_of_cap(k);
  chords_.contact[2][s] = last.ball[0] != no_id ? find_contact(last.ball[0], last.ball[1]) : no_room;
  if (chords_.count == ChordBatch::capacity) measure_chords(balls, boundary);
}

// Chords once they are found: the ends of their parts, and simplices. Which ends are free cannot be
// predicted, so there are tables instead of branches.
void ContactsBuilder::complete_chords(const BallSet &balls, const Boundary &boundary) {
  ContactArrays &a = contacts_.a_;
  const double none = 0.0;
  const double *const roots = boundary.vertex_count() > 0 ? boundary.root_discriminant_data() : &none;
  for (uint32_t s = 0; s < chords_.count; ++s) {
    const uint32_t own = chords_.ball[0][s];
    const uint32_t first = chords_.ball[1][s];
    const uint32_t second = chords_.ball[2][s];
    const uint32_t clipper[2] = {chords_.clipper[0][s], chords_.clipper[1][s]};
    const uint32_t is_free[2] = {clipper[0] == no_id ? 1U : 0U, clipper[1] == no_id ? 1U : 0U};
    const uint32_t free_ends = is_free[0] + is_free[1];
    // Half its length, if it were whole: the boundary knows it of one that ends in a vertex.
    const uint32_t vertices[3] = {0, chords_.vertex[s], chords_.vertex[s]};
    const uint32_t vertex = vertices[free_ends];
    double root = 0.0;
    if (vertex != no_id) {
      root = roots[vertex];
    } else {
      const exact::LatticeBall ball = balls.ball(own);
      root = std::sqrt(exact::discriminant(exact::sphere_of(ball), exact::plane_of(ball, balls.ball(first)),
                                           exact::plane_of(ball, balls.ball(second))));
    }
    for (uint32_t end = 0; end < 2; ++end) {
      const double ends[2] = {not_a_number, end == 0 ? -root : root};
      const uint32_t clippers[2] = {clipper[end], second};
      chords_.free_end[end][s] = ends[is_free[end]];
      chords_.clipper[end][s] = clippers[is_free[end]];
    }

    const TriangleRecord triangle{{own, first, second}, free_ends};
    a.triangles.push(triangle);
    ++a.simplices.of[2][static_cast<uint32_t>(triangle.kind())];
    // Each tetrahedron is an end of four chords, of which one is that of its first three balls.
    for (uint32_t end = 0; end < 2; ++end) {
      const uint32_t is_last = (clipper[end] > second ? 1U : 0U) - is_free[end];
      if (a.tetrahedra.capacity() == 0) {
        a.tetrahedra.set_count(a.tetrahedra.required() + is_last);
      } else if (is_last != 0) {
        a.tetrahedra.push({{own, first, second, clipper[end]}});
      }
    }
  }
}

// The lengths of the three axes are the contacts' own: measure_contacts() divides by them.
void ContactsBuilder::measure_chords(const BallSet &balls, const Boundary &boundary) {
  const uint32_t count = chords_.count;
  if (count == 0) return;
  complete_chords(balls, boundary);
  chords_.count = 0;
  uint32_t uncertain = (1U << count) - 1U;
  if constexpr (has_lanes) {
    uint32_t padded = count;
    for (; padded % 4 != 0; ++padded) chords_.repeat(count - 1, padded);
    uncertain &= measure_in_lanes(boundary.target(), arrays_of(balls), chords_, padded);
  }
  for (; uncertain != 0; uncertain &= uncertain - 1) {
    measure_in_integers(balls, chords_, static_cast<uint32_t>(__builtin_ctz(uncertain)));
  }
  for (uint32_t s = 0; s < count; ++s) {
    for (uint32_t pair = 0; pair < 3; ++pair) {
      const uint32_t id = chords_.contact[pair][s];
      if (id == no_room) continue;
      ContactRecord &contact = contacts_.a_.contacts[id];
      contact.area += chords_.part[pair][s];
      ++contact.chords;
    }
  }
}

// Arcs and circles of the ball at hand: its part of its share, and the free borders of its contacts with later balls.
void ContactsBuilder::add_free_edges(const BallSet &balls, const Boundary &boundary) {
  const uint32_t i = caps_.origin;
  const uint32_t faces = boundary.faces(i).size();
  if (faces == 0) return;
  const double radius = balls.r[i];
  FreeSurface surface(boundary, radius);
  ArcBatches arcs(balls, boundary, i);
  while (arcs.next()) {
    const ArcBatch &batch = arcs.batch();
    surface.add(batch);
    for (uint32_t s = 0; s < batch.count; ++s) {
      if (batch.other[s] < i || !batch.has_piece(s)) continue;
      const uint32_t id = contact_of_cap(walk_.cap_of(batch.other[s]));
      if (id == no_room) continue;
      ContactRecord &contact = contacts_.a_.contacts[id];
      contact.rim += batch.angle[s];  // not yet a length
      contact.code |= batch.arc[s] != 0 ? ContactRecord::arc_bit : ContactRecord::circle_bit;
    }
  }
  // r A, the part of three times the volume about the centre.
  const double steradians = surface.steradians(faces, boundary.loops(i).size());
  contacts_.a_.share_volume[i] = radius * radius * radius * steradians;
}

Status ContactsBuilder::check_capacity() {
  const ContactArrays &a = contacts_.a_;
  needed_.contacts = clamped_count(a.contacts.required());
  if (limits_.triangles > 0) needed_.triangles = clamped_count(a.triangles.required());
  if (limits_.tetrahedra > 0) needed_.tetrahedra = clamped_count(a.tetrahedra.required());
  const bool fits =
      !a.contacts.overflowed() && needed_.triangles <= limits_.triangles && needed_.tetrahedra <= limits_.tetrahedra;
  return fits ? Status::ok : Status::capacity;
}

// Areas, and shares as cones over their faces and contacts. The order of the sums is that in which contacts are found,
// which does not depend on the order of the input.
void ContactsBuilder::measure_contacts(const BallSet &balls, [[maybe_unused]] const Boundary &boundary) {
  ContactArrays &a = contacts_.a_;
  ContactMeasures measures;
  for (uint32_t first = 0; first < a.contacts.size(); first += ContactMeasures::capacity) {
    const uint32_t left = a.contacts.size() - first;
    const uint32_t count = left < ContactMeasures::capacity ? left : ContactMeasures::capacity;
    for (uint32_t s = 0; s < ContactMeasures::capacity; ++s) {
      const ContactRecord &contact = a.contacts[first + (s < count ? s : 0)];
      measures.ball[0][s] = contact.ball[0];
      measures.ball[1][s] = contact.ball[1];
      measures.area[s] = contact.area;
      measures.rim[s] = contact.rim;
    }
    bool certain = false;
    if constexpr (has_lanes) certain = measure_contacts_in_lanes(boundary.target(), arrays_of(balls), measures);
    for (uint32_t s = 0; s < count; ++s) {
      ContactRecord &contact = a.contacts[first + s];
      if (!certain && measure_contact_in_integers(balls, measures, s)) contact.code |= ContactRecord::touching_bit;
      contact.area = measures.area[s];
      contact.rim = measures.rim[s];
      for (uint32_t side = 0; side < 2; ++side) {
        a.contact_area[contact.ball[side]] += measures.area[s];
        a.share_volume[contact.ball[side]] += measures.cone[side][s];
      }
    }
  }
}

void ContactsBuilder::close_shares() {
  ContactArrays &a = contacts_.a_;
  for (uint32_t i = 0; i < a.balls; ++i) {
    const double volume = a.share_volume[i] / 3;
    a.share_volume[i] = volume > 0.0 ? volume : 0.0;
  }
}

// Rows in the order in which contacts were found; then all balls in the caller's order, each to the rows of those that
// it is in contact with.
void ContactsBuilder::make_rows(const CubeGrid &grid) {
  ContactArrays &a = contacts_.a_;
  candidates_.end();
  const auto [found, next] = walk_.end();
  for (uint32_t i = 0; i < a.balls; ++i) a.first_in_row[i] = 0;
  for (const ContactRecord &contact : a.contacts.items()) {
    for (const uint32_t ball : contact.ball) ++a.first_in_row[ball];
  }
  end_rows(a.first_in_row, a.balls);
  for (uint32_t id = a.contacts.size(); id-- > 0;) {
    for (const uint32_t ball : a.contacts[id].ball) found[--a.first_in_row[ball]] = id;
  }
  for (uint32_t i = 0; i < a.balls; ++i) next[i] = a.first_in_row[i];
  for (uint32_t given = 0; given < a.balls; ++given) {
    const uint32_t i = grid.grid_index(given);
    for (const uint32_t id : found.part(a.first_in_row[i], a.first_in_row[i + 1])) {
      a.row[next[a.contacts[id].other(i)]++] = id;
    }
  }
}

// Triangles are counted as they are found.
void ContactsBuilder::count_simplices(const Boundary &boundary) {
  ContactArrays &a = contacts_.a_;
  const auto count = [&a](uint32_t dimension, SimplexKind kind) {
    ++a.simplices.of[dimension][static_cast<uint32_t>(kind)];
  };
  for (uint32_t i = 0; i < own_balls_; ++i) {
    const bool has_contacts = a.first_in_row[i] < a.first_in_row[i + 1];
    if (boundary.is_exposed(i)) {
      count(0, has_contacts ? SimplexKind::regular : SimplexKind::singular);
    } else if (has_contacts) {
      count(0, SimplexKind::interior);
    }
  }
  for (const ContactRecord &contact : a.contacts.items()) {
    count(1, contact.is_circle() ? SimplexKind::singular
             : contact.has_arc() ? SimplexKind::regular
                                 : SimplexKind::interior);
  }
  a.simplices.of[3][static_cast<uint32_t>(SimplexKind::interior)] = clamped_count(a.tetrahedra.required());
}

}  // namespace hsp
