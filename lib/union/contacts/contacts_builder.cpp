// Finds contacts, triangles and tetrahedra, ball after ball.
//
// As an example the balls of radius 5 at (0,0,0), (6,0,0) and (0,6,0), in this order:
//   ball 0    its later caps are those of 1 and 2. It has one chord, with two free ends: triangle 0 1 2, singular
//   ball 1    its later cap is that of 2. It has no further chord
//   ball 2    it has no later caps
// Then the arcs of ball 0 give the contacts of 0 with 1 and of 0 with 2, those of ball 1 the contact of 1 with 2.
// Shares are cones over faces and contacts. With 3 balls, 3 contacts, 1 triangle and no tetrahedron Euler's number is 3
// - 3 + 1 = 1, that of a union that can be shrunk to a point.
#include "contacts/contacts_builder.hpp"

#include <cstring>

#include "contacts/contact_measures.hpp"
#include "core/rows.hpp"
#include "core/small_code.hpp"

namespace hsp {
namespace {

// The balls of a block from ball i on.
CubeBlock part_from(const CubeBlock &block, uint32_t i) {
  CubeBlock part;
  part.ranges = 0;
  part.levels = block.levels;
  for (uint32_t k = 0; k < block.ranges; ++k) {
    const BallRange &range = block.range[k];
    if (range.last > i) part.range[part.ranges++] = {range.first > i ? range.first : i, range.last};
  }
  return part;
}

// The two children of a contact in a tree: their ids, each increased by 1, or 0 for none. They are stored in place of
// the contact's rim, which is still 0.
struct Children {
  uint32_t of[2];

  explicit Children(const ContactRecord &contact) { std::memcpy(of, &contact.rim, sizeof of); }
  void put(ContactRecord &contact) const { std::memcpy(&contact.rim, of, sizeof of); }
};
static_assert(sizeof(Children) == sizeof(ContactRecord::rim));

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

bool ContactsBuilder::start(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours) {
  const uint32_t balls = grid.balls().n;
  clear(balls);
  own_balls_ = grid.own_balls();
  some_inside_ = some_trees_ = false;
  lost_across_ = 0;
  not_found_ = 0;
  needed_.neighbours = neighbours;
  if (balls > limits_.balls || neighbours > limits_.neighbours) return false;
  walk_.start(balls, own_balls_);
  for (uint32_t i = 0; i < balls && !some_inside_; ++i) some_inside_ = boundary.is_contained(i);
  candidates_.start(contacts_.a_.row, boundary.target());
  return true;
}

void ContactsBuilder::clear(uint32_t balls) {
  ContactArrays &a = contacts_.a_;
  needed_ = {balls, 0, 0, 0, 0};
  vertices_.count = 0;
  for (auto &kept : vertices_.kept) {
    for (double &chord : kept) chord = 1.0;
  }
  for (auto &ends : vertices_.ends) {
    for (uint32_t &contact : ends) contact = 2;
  }
  a.contacts.clear();
  a.triangles.clear();
  a.tetrahedra.clear();
  a.simplices = {};
  a.balls = balls;
  if (balls > limits_.balls) return;
  // While contacts are found, first_in_row is the head of each ball's list of contacts with later balls.
  for (uint32_t i = 0; i <= balls; ++i) a.first_in_row[i] = no_id;
  for (uint32_t i = 0; i < balls; ++i) a.share_volume[i] = a.contact_area[i] = 0.0;
}

// If a ball has very many contacts, most of them are in a tree, too. Its branches are the bits of the other ball, the
// lowest first, so that no way down is longer than the number of bits. The root is the contact with code 1 in the
// ball's list. New contacts, which stand before the root in the list, are moved behind it and into the tree.
uint32_t ContactsBuilder::find_in_tree(uint32_t a, uint32_t b) {
  ContactArrays &arrays = contacts_.a_;
  uint32_t waiting = arrays.first_in_row[a], root = waiting;
  while (root != no_id && arrays.contacts[root].code == 0) root = arrays.links[root];
  if (root == no_id) {
    root = waiting;
    waiting = arrays.links[root];
    arrays.links[root] = no_id;
    arrays.contacts[root].code = 1;
    some_trees_ = true;
  }
  while (waiting != no_id && waiting != root) {
    const uint32_t next = arrays.links[waiting];
    arrays.links[waiting] = arrays.links[root];
    arrays.links[root] = waiting;
    uint32_t at = root, bits = arrays.contacts[waiting].ball[1];
    Children children(arrays.contacts[root]);
    for (; children.of[bits % 2] != 0; bits /= 2) {
      at = children.of[bits % 2] - 1;
      children = Children(arrays.contacts[at]);
    }
    children.of[bits % 2] = waiting + 1;
    children.put(arrays.contacts[at]);
    waiting = next;
  }
  arrays.first_in_row[a] = root;
  uint32_t at = root;
  for (uint32_t bits = b; arrays.contacts[at].ball[1] != b; bits /= 2) {
    const uint32_t child = Children(arrays.contacts[at]).of[bits % 2];
    if (child == 0) return no_id;
    at = child - 1;
  }
  return at;
}

void ContactsBuilder::fell_trees() {
  for (uint32_t id = 0; some_trees_ && id < contacts_.a_.contacts.size(); ++id) {
    contacts_.a_.contacts[id].code = 0;
    contacts_.a_.contacts[id].rim = 0.0;
  }
}

uint32_t ContactsBuilder::add_contact(uint32_t a, uint32_t b, uint32_t counted) {
  ContactArrays &arrays = contacts_.a_;
  const uint64_t number = arrays.contacts.required();
  if (number < arrays.contacts.capacity()) {
    const uint32_t id = static_cast<uint32_t>(number);
    arrays.contacts.set_count(number + 1);
    arrays.contacts[id] = {{a, b}, 0, 0, 0.0, 0.0};
    arrays.links[id] = arrays.first_in_row[a];
    arrays.first_in_row[a] = id;
    return id;
  }
  arrays.contacts.set_count(number + counted);
  lost_across_ += b < own_balls_ ? 0U : counted;
  return no_room;
}

// The contact of a cap that has no contact yet. In a box it may be there already: a power vertex may have found it as a
// contact of two images.
uint32_t ContactsBuilder::first_contact_of_cap(uint32_t cap) {
  const uint32_t own = caps_.origin, other = caps_.ball[cap];
  return contact_of_cap_[cap] = own_balls_ == contacts_.a_.balls ? add_contact(own, other) : find_contact(own, other);
}

// The caps of later balls, or all caps.
void ContactsBuilder::gather_caps(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i,
                                  bool in_lanes) {
  if (walk_.asks_for_all_caps(boundary, i)) return caps_.gather(balls, block, i, nullptr);
  if (in_lanes) {
    const uint32_t found = candidates_.later(i, caps_.ball.data(), caps_.capacity());
    if (found <= caps_.capacity()) {
      if (!some_inside_ && walk_.gather_in_floats(balls, i, found, caps_)) return;
      return caps_.gather_given(balls, i, found);
    }
  }
  caps_.gather(balls, part_from(block, i + 1), i, nullptr);
}

bool ContactsBuilder::start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block, uint32_t first) {
  return block.levels == nullptr && candidates_.start_cube(grid, cube, first, part_from(block, first));
}

void ContactsBuilder::start_ball(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i,
                                 bool in_lanes) {
  gather_caps(balls, boundary, block, i, in_lanes);
  if (some_inside_) caps_.keep_if([&boundary](uint32_t j) { return !boundary.is_contained(j); });
  walk_.keep_exposed(boundary, caps_);
  caps_.first_later = 0;
  while (caps_.first_later < caps_.count && caps_.ball[caps_.first_later] < caps_.origin) ++caps_.first_later;
  static_assert(no_id == ~UINT32_C(0));
  if (caps_.count > 0) std::memset(contact_of_cap_.data(), 0xFF, caps_.count * sizeof(uint32_t));
}

// Finds the chords of the ball at hand, and its contacts with later balls that chords of earlier balls have found.
void ContactsBuilder::find_chords(const Boundary &boundary) {
  walk_.find(boundary, caps_);
  const ContactArrays &a = contacts_.a_;
  for (uint32_t id = a.first_in_row[caps_.origin]; id != no_id; id = a.links[id]) {
    contact_of_cap_[walk_.cap_of(a.contacts[id].ball[1])] = id;
  }
}

void ContactsBuilder::count_chords(bool some_elsewhere) {
  ContactArrays &a = contacts_.a_;
  uint32_t with_free_ends[3] = {};
  for (const FoundChord &chord : walk_.chords()) {
    const auto [j, k] = chord.cap;
    if (some_elsewhere && (is_elsewhere(j) || is_elsewhere(k))) continue;
    ++with_free_ends[chord.free_ends];
    if (a.triangles.capacity() > 0) {
      a.triangles.push({{caps_.origin, caps_.ball[j], caps_.ball[k]}, chord.free_ends});
    }
  }
  for (uint32_t ends = 0; ends < 3; ++ends) count_triangles(ends, with_free_ends[ends]);
}

// Adds the parts of the vertices to contacts. measure_contacts() divides them by the distances of the balls.
void ContactsBuilder::measure_vertices(const BallSet &balls, const Boundary &boundary) {
  const uint32_t count = vertices_.count;
  if (count == 0) return;
  vertices_.count = 0;
  for (uint32_t padded = count; padded % 4 != 0; ++padded) vertices_.repeat(count - 1, padded);
  uint32_t unserved = measure_power_vertices(boundary.target(), arrays_of(balls), vertices_, count);
  for (; unserved != 0; unserved &= unserved - 1) {
    measure_in_integers(balls, vertices_, static_cast<uint32_t>(__builtin_ctz(unserved)));
  }
  for (uint32_t s = 0; s < count; ++s) {
    for (uint32_t pair = 0; pair < 6; ++pair) {
      const uint32_t id = vertices_.contact[pair][s];
      if (id == no_room) continue;
      ContactRecord &contact = contacts_.a_.contacts[id];
      contact.area += vertices_.part[pair][s];
      contact.chords += vertices_.ends[pair][s];
    }
  }
}

// A ball has less than three times as many chords as contacts, and less than twice as many power vertices. A contact
// with an image is there from both sides.
Status ContactsBuilder::check_capacity() {
  const ContactArrays &a = contacts_.a_;
  const uint64_t contacts = a.contacts.required() + (own_balls_ < a.balls ? 2 : 1) * not_found_;
  const uint64_t least = not_found_ > 0 ? uint64_t{limits_.contacts} + 1 : 0;
  needed_.contacts = clamped_count(contacts < least ? least : contacts);
  if (limits_.triangles > 0) needed_.triangles = clamped_count(a.triangles.required() + 3 * not_found_);
  if (limits_.tetrahedra > 0) needed_.tetrahedra = clamped_count(a.tetrahedra.required() + 2 * not_found_);
  const bool fits = needed_.contacts <= limits_.contacts && needed_.triangles <= limits_.triangles &&
                    needed_.tetrahedra <= limits_.tetrahedra;
  return fits ? Status::ok : Status::capacity;
}

// Finds areas and rims, and adds to shares the cones over contacts. Sums run in the order in which contacts were found,
// which does not depend on the order of the input.
bool ContactsBuilder::measure_contacts(const BallSet &balls, [[maybe_unused]] Target target, Patience &patience) {
  ContactArrays &a = contacts_.a_;
  for (uint32_t i = 0, count = a.balls; i < count; ++i) a.first_in_row[i] = 0;  // how many its row will have
  ContactMeasures measures;
  for (uint32_t first = 0; first < a.contacts.size(); first += ContactMeasures::capacity) {
    if (!patience.allows(100 * uint64_t{ContactMeasures::capacity})) return false;
    const uint32_t left = a.contacts.size() - first;
    const uint32_t count = left < ContactMeasures::capacity ? left : ContactMeasures::capacity;
    const Span<ContactRecord> contacts = a.contacts.items().part(first, first + count);
    for (uint32_t s = 0; s < ContactMeasures::capacity; ++s) {
      const ContactRecord &contact = contacts[s < count ? s : 0];
      measures.ball[0][s] = contact.ball[0];
      measures.ball[1][s] = contact.ball[1];
      measures.area[s] = contact.area;
      measures.rim[s] = contact.rim;
    }
    bool certain = false;
    if constexpr (has_lanes) certain = measure_contacts_in_lanes(target, arrays_of(balls), measures);
    for (uint32_t s = 0; s < count; ++s) {
      ContactRecord &contact = contacts[s];
      if (!certain && measure_contact_in_integers(balls, measures, s)) contact.code |= ContactRecord::touching_bit;
      contact.chords /= 2;
      contact.area = measures.area[s];
      contact.rim = measures.rim[s];
      for (uint32_t side = 0; side < 2; ++side) {
        const uint32_t ball = contact.ball[side];
        ++a.first_in_row[ball];
        a.contact_area[ball] += measures.area[s];
        a.share_volume[ball] += measures.cone[side][s];
      }
    }
  }
  return true;
}

void ContactsBuilder::close_shares() {
  ContactArrays &a = contacts_.a_;
  for (uint32_t i = 0; i < a.balls; ++i) {
    const double volume = a.share_volume[i] / 3;
    a.share_volume[i] = volume > 0.0 ? volume : 0.0;
  }
}

// First puts contacts into rows in the order in which they were found. Then takes all balls in the caller's order, the
// last one first, and puts each to the ends of the rows of the balls that it is in contact with.
void ContactsBuilder::make_rows(const CubeGrid &grid, Patience &patience) {
  ContactArrays &a = contacts_.a_;
  candidates_.end();
  const ChordWalk::SpareArrays spare = walk_.end();
  const Span<uint32_t> found = spare.of_contacts, end = spare.of_balls;
  end_rows(a.first_in_row, a.balls);
  for (uint32_t i = 0; i < a.balls; ++i) end[i] = a.first_in_row[i];
  in_parts(patience, IdRange{0, a.contacts.size()}, 50, [&](IdRange some) {
    for (const uint32_t id : some) {
      for (const uint32_t ball : a.contacts[id].ball) found[--a.first_in_row[ball]] = id;
    }
  });
  if (!patience.allows(0)) return;
  for (uint32_t given = a.balls; given > 0 && patience.allows(200);) {
    const uint32_t i = grid.grid_index(--given);
    for (const uint32_t id : found.part(a.first_in_row[i], a.first_in_row[i + 1])) {
      a.row[--end[a.contacts[id].other(i)]] = id;
    }
  }
}

// Counts balls, contacts and tetrahedra; triangles have been counted as they were found.
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
  constexpr uint32_t arc = ContactRecord::arc_bit, circle = ContactRecord::circle_bit;
  uint32_t with_code[(arc | circle) + 1] = {};
  for (const ContactRecord &contact : a.contacts.items()) ++with_code[contact.code & (arc | circle)];
  const uint32_t edges[3] = {with_code[circle] + with_code[arc | circle], with_code[arc], with_code[0]};
  for (uint32_t kind = 0; kind < 3; ++kind) a.simplices.of[1][kind] = edges[kind];
  a.simplices.of[3][static_cast<uint32_t>(SimplexKind::interior)] = clamped_count(a.tetrahedra.required());
}

}  // namespace hsp
