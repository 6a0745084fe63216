// Fills contacts by two passes over all balls of a boundary. The first pass finds chords and power vertices, each at
// the first of its balls in grid order; the second pass takes arcs and circles. Both add terms to the areas of
// contacts, as chord_ends.hpp says.
//
// As an example the balls of radius 5 at (0,0,0), (6,0,0) and (0,6,0), with one chord, from (3, 3, -2.65) to (3, 3,
// 2.65):
//   contact of 0 and 1     in the plane x = 3: the part y <= 3 of the disc of radius 4 around (3, 0, 0)
//   its border             the chord, 5.29 long and 3 from the centre; an arc of 2 pi - 2 acos(3/4) = 4.838
//   its area               half the sum of distance times length: (3 * 5.29 + 4 * 4 * 4.838) / 2 = 46.64
//   contact of 1 and 2     half of the disc of radius 2.65 in the plane x = y, x >= 3: 7 pi / 2 = 11.00
// Both ends of the chord are free. Each adds half of 3 * 5.29 / 2 to the first area, and nothing to the second.
#pragma once

#include "contacts/chord_ends.hpp"
#include "contacts/chord_walk.hpp"
#include "core/patience.hpp"
#include "core/small_code.hpp"
#include "measure/areas.hpp"
#include "model/block_sweep.hpp"
#include "sphere/cube_candidates.hpp"

namespace hsp {

// Limits that suffice for most molecules. neighbours: no ball meets more others. Status::range if a limit would be
// larger than max_count.
constexpr Status default_limits(uint32_t balls, uint32_t neighbours, ContactLimits &limits) {
  if (balls > (max_count - 64) / 12) return Status::range;
  limits = {balls, neighbours, 12 * balls + 64, 0, 0};
  return Status::ok;
}

// Two balls, ids in grid order; no_id for none.
struct ContactPair {
  uint32_t ball[2];
};

// For sets whose halo, if there is one, has no images of other balls.
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

  // Finds the contacts of all balls that are not in the grid's halo. Of the halo, the boundary need only say which
  // balls lie inside others. neighbours: the number that the boundary needed. Status::capacity if a limit is too small;
  // needed() then reports what suffices, if `neighbours` is within its limit, for triangles and tetrahedra if they have
  // limits. For contacts this may be more than there are, but by no more than the triangles and arcs. Status::stopped
  // if `patience` allows no more work.
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours, Patience patience = Patience()) {
    return build(grid, boundary, neighbours, NoImages{}, patience);
  }

  // For a halo that may have images of the other balls, in a box whose copies fill space. A chord across faces of the
  // box is found once in each copy that holds one of its balls. It is computed only in the copy where none of its
  // images comes before its ball, an order that all copies share. Its terms for a contact of two images go to the copy
  // of this contact in the box. Every contact of a ball and an image is there from both sides, with the same bits.
  // Status::check if an image is missing.
  template <class Images>
  Status build(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours, const Images &images,
               Patience patience = Patience()) {
    if (!start(grid, boundary, neighbours)) return Status::capacity;
    BlockSweep sweep(grid);
    uint64_t before = 0;  // number of caps of the ball before, an estimate for the next one
    for (uint32_t cube = 0; cube < grid.own_cubes(); ++cube) {
      const BallRange own = grid.balls_in(cube);
      const CubeBlock *block = nullptr;
      bool in_lanes = false;
      for (uint32_t i = own.first; i < own.last; ++i) {
        if (boundary.is_contained(i)) continue;
        if (!patience.allows(1000 + (500 + before) * before)) return Status::stopped;
        if (IdRange ends; walk_.has_whole_chords(boundary, i, ends)) {
          count_whole_chords(boundary, ends, images);
          continue;
        }
        if (block == nullptr) {
          block = &sweep.block_around(cube);
          in_lanes = start_cube(grid, cube, *block, i);
        }
        start_ball(grid.balls(), boundary, *block, i, in_lanes);
        bool some_elsewhere = false;
        if constexpr (Images::there) {
          for (uint32_t k = caps_.count; k > caps_.first_later; --k) {
            const uint32_t ball = caps_.ball[k - 1];
            if (ball < own_balls_) break;
            if (!images.comes_before_its_ball(ball)) continue;
            contact_of_cap_[k - 1] = elsewhere;
            some_elsewhere = true;
          }
        }
        find_chords(boundary);
        before = caps_.count;
        if (walk_.skips(caps_)) not_found_ += caps_.count - caps_.first_later;
        count_chords(some_elsewhere);
        for (const FoundVertex &vertex : walk_.vertices()) add_power_vertex(grid.balls(), boundary, vertex, images);
      }
    }
    measure_vertices(grid.balls(), boundary);
    fell_trees();
    const Span<uint32_t> contact_with = walk_.end().of_balls;
    for (uint32_t i = 0, balls = contacts_.a_.balls; i < balls; ++i) contact_with[i] = no_id;
    for (uint32_t i = 0; i < own_balls_; ++i) {
      if (!patience.allows(2000)) return Status::stopped;
      add_free_edges(grid.balls(), boundary, i, images, contact_with);
    }
    if (!measure_contacts(grid.balls(), boundary.target(), patience)) return Status::stopped;
    if (!add_other_sides(images)) return Status::check;
    if (const Status status = check_capacity(); status != Status::ok) return status;
    close_shares();
    if (!patience.allows(50 * uint64_t{needed_.contacts})) return Status::stopped;
    make_rows(grid, patience);
    if (!patience.allows(0)) return Status::stopped;
    count_simplices(boundary);
    return Status::ok;
  }

  const Contacts &contacts() const { return contacts_; }
  // [contacts]
  Span<uint32_t> scratch() { return contacts_.a_.links; }
  // For tests, which break them.
  ContactArrays &arrays() { return contacts_.a_; }

 private:
  // In place of the id of a contact. no_room: it was counted, but there was no room for it. elsewhere, for the contact
  // of a cap: it is kept in another copy of the box.
  static constexpr uint32_t no_room = no_id - 1;
  static constexpr uint32_t elsewhere = no_id - 2;
  // So many contacts of one ball are searched one by one; for more there is a tree.
  static constexpr uint32_t most_listed = 32;

  bool start(const CubeGrid &grid, const Boundary &boundary, uint32_t neighbours);
  void clear(uint32_t balls);
  bool start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block, uint32_t first);
  void gather_caps(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i, bool in_lanes);
  void start_ball(const BallSet &balls, const Boundary &boundary, const CubeBlock &block, uint32_t i, bool in_lanes);
  void find_chords(const Boundary &boundary);
  void count_chords(bool some_elsewhere);
  void measure_vertices(const BallSet &balls, const Boundary &boundary);
  bool is_elsewhere(uint32_t cap) const { return contact_of_cap_[cap] == elsewhere; }
  uint32_t contact_of_cap(uint32_t cap) {
    const uint32_t id = contact_of_cap_[cap];
    return id == no_id ? first_contact_of_cap(cap) : id == elsewhere ? no_room : id;
  }
  uint32_t first_contact_of_cap(uint32_t cap);
  // The contact of balls a and b, which is added if there is none. no_room if there is no room for it; the number of
  // contacts then grows by `counted`.
  uint32_t find_contact(uint32_t a, uint32_t b, uint32_t counted = 1) {
    const ContactArrays &arrays = contacts_.a_;
    uint32_t id = arrays.first_in_row[a];
    for (uint32_t left = most_listed; id != no_id && (small_code || left > 0); --left, id = arrays.links[id]) {
      if (arrays.contacts[id].ball[1] == b) return id;
    }
    if (!small_code && id != no_id) id = find_in_tree(a, b);
    return id != no_id ? id : add_contact(a, b, counted);
  }
  uint32_t add_contact(uint32_t a, uint32_t b, uint32_t counted = 1);
  uint32_t find_in_tree(uint32_t a, uint32_t b);
  void fell_trees();
  Status check_capacity();
  bool measure_contacts(const BallSet &balls, Target target, Patience &patience);
  void close_shares();
  void make_rows(const CubeGrid &grid, Patience &patience);
  void count_simplices(const Boundary &boundary);

  template <class Images>
  void add_power_vertex(const BallSet &balls, const Boundary &boundary, const FoundVertex &vertex,
                        const Images &images) {
    const auto [a, b, c] = vertex.cap;
    const uint32_t first = caps_.ball[a], second = caps_.ball[b], third = caps_.ball[c];
    if constexpr (Images::there) {
      keep_chords(vertices_, is_elsewhere(a), is_elsewhere(b), is_elsewhere(c), first < own_balls_);
    }
    const uint32_t s = vertices_.count++;
    vertices_.ball[0][s] = caps_.origin;
    vertices_.ball[1][s] = first;
    vertices_.ball[2][s] = second;
    vertices_.ball[3][s] = third;
    const auto contact_of = [&](uint32_t k, uint32_t one, uint32_t other) {
      if constexpr (Images::there) {
        if (vertices_.ends[3 + k][s] == 0) return no_room;
      }
      const ContactPair pair = place_in_box({{one, other}}, images);
      return pair.ball[0] == no_id ? no_room : find_contact(pair.ball[0], pair.ball[1], vertex.new_chords >> k & 1);
    };
    vertices_.contact[0][s] = contact_of_cap(a);
    vertices_.contact[1][s] = contact_of_cap(b);
    vertices_.contact[2][s] = contact_of_cap(c);
    vertices_.contact[3][s] = contact_of(0, first, second);
    vertices_.contact[4][s] = contact_of(1, first, third);
    vertices_.contact[5][s] = contact_of(2, second, third);
    if (!Images::there || vertices_.kept[0][s] != 0.0) {
      FixedVector<TetrahedronRecord> &tetrahedra = contacts_.a_.tetrahedra;
      if (tetrahedra.capacity() == 0) {
        tetrahedra.set_count(tetrahedra.required() + 1);
      } else {
        tetrahedra.push({{caps_.origin, first, second, third}});
      }
    }
    if (vertices_.count == PowerVertexBatch::capacity) measure_vertices(balls, boundary);
  }
  // For the vertex that is added next: which of its chords are kept here, and how many ends each contact has. A chord
  // is kept elsewhere if the contact of the ball at hand with one of its balls is. first_comes: the first of the three
  // other balls is in the box.
  static void keep_chords(PowerVertexBatch &batch, bool first_elsewhere, bool second_elsewhere, bool third_elsewhere,
                          bool first_comes) {
    const uint32_t s = batch.count;
    const uint32_t kept[4] = {
        first_elsewhere || second_elsewhere ? 0U : 1U, second_elsewhere || third_elsewhere ? 0U : 1U,
        third_elsewhere || first_elsewhere ? 0U : 1U, !first_comes || second_elsewhere || third_elsewhere ? 0U : 1U};
    const uint32_t ends[6] = {kept[0] + kept[2], kept[0] + kept[1], kept[1] + kept[2],
                              kept[0] + kept[3], kept[2] + kept[3], kept[1] + kept[3]};
    for (uint32_t k = 0; k < 4; ++k) batch.kept[k][s] = kept[k];
    for (uint32_t k = 0; k < 6; ++k) batch.ends[k][s] = ends[k];
  }
  template <class Images>
  void count_whole_chords(const Boundary &boundary, IdRange ends, const Images &images) {
    for (uint32_t v = ends.first; v < ends.last; v += 2) {
      const auto [i, j, k] = boundary.vertex(v).ball;
      if constexpr (Images::there) {
        const auto is_elsewhere = [&](uint32_t ball) {
          return ball >= own_balls_ && images.comes_before_its_ball(ball);
        };
        if (is_elsewhere(j) || is_elsewhere(k)) continue;
      }
      count_triangles(2, 1);
      if (contacts_.a_.triangles.capacity() > 0) contacts_.a_.triangles.push({{i, j, k}, 2});
    }
  }
  // Counts triangles by kind; if no triangles are stored, also their total.
  void count_triangles(uint32_t free_ends, uint32_t number) {
    ContactArrays &a = contacts_.a_;
    a.simplices.of[2][static_cast<uint32_t>(TriangleRecord{{}, free_ends}.kind())] += number;
    if (a.triangles.capacity() == 0) a.triangles.set_count(a.triangles.required() + number);
  }

  // Adds the arcs and circles of ball i: to its own share, and to its contacts with later balls, as their rims.
  // contact_with [balls]: holds the ids of these contacts during the call.
  template <class Images>
  void add_free_edges(const BallSet &balls, const Boundary &boundary, uint32_t i, const Images &images,
                      Span<uint32_t> contact_with) {
    const uint32_t faces = boundary.faces(i).size();
    if (faces == 0) return;
    const ContactArrays &a = contacts_.a_;
    for (uint32_t id = a.first_in_row[i]; id != no_id; id = a.links[id]) contact_with[a.contacts[id].ball[1]] = id;
    const double radius = balls.r[i];
    FreeSurface surface(boundary, radius);
    ArcBatches arcs(balls, boundary, i);
    ArcProducts products;
    arcs.batch().products = &products;
    while (arcs.next()) {
      const ArcBatch &batch = arcs.batch();
      double ends[ArcBatch::room], cosines = 0.0;
      const bool all_served = measure_free_ends(boundary.target(), batch, radius, ends, cosines);
      surface.add(batch, {cosines, {}});
      for (uint32_t s = 0; s < batch.count; ++s) {
        const uint32_t other = batch.other[s];
        if (other < i || !batch.has_piece(s)) continue;
        if constexpr (Images::there) {
          if (other >= own_balls_ && images.comes_before_its_ball(other)) continue;
        }
        // An id that an earlier ball has left here does not count.
        uint32_t id = contact_with[other];
        if (id == no_id || a.contacts[id].ball[0] != i) {
          id = add_contact(i, other);
          if (id == no_room) continue;
          contact_with[other] = id;
        }
        ContactRecord &contact = contacts_.a_.contacts[id];
        const bool is_served = all_served || ends[s] == ends[s];
        contact.area += is_served ? ends[s] : free_ends_in_integers(balls, i, batch, s);
        contact.rim += batch.angle[s];  // not yet a length
        contact.chords += batch.arc[s] != 0 ? 2U : 0U;
        contact.code |= batch.arc[s] != 0 ? ContactRecord::arc_bit : ContactRecord::circle_bit;
      }
    }
    // r times the area: three times the volume of the cones over the faces, with their tips in the centre.
    const double steradians = surface.steradians(faces, boundary.loops(i).size());
    contacts_.a_.share_volume[i] = radius * radius * radius * steradians;
  }

  // The two balls under which a contact is kept, if no image of them comes before its ball.
  template <class Images>
  ContactPair place_in_box(const ContactPair &pair, const Images &images) const {
    const auto [first, second] = pair.ball;
    if (first < own_balls_) return pair;
    if constexpr (Images::there) {
      const uint32_t ball = images.ball_of(first);
      const uint32_t other = images.moved_back(second, first);
      if (other < own_balls_) return {{ball < other ? ball : other, ball < other ? other : ball}};
      if (other != no_id && !images.comes_before_its_ball(other)) return {{ball, other}};
      return {{images.ball_of(second), images.moved_back(first, second)}};
    }
    return {{no_id, no_id}};
  }

  // Adds contacts with images as seen from the images' balls, and to these balls their parts of the shares. False if an
  // image is missing.
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
      for (const uint32_t ball : other_side.ball) ++a.first_in_row[ball];
      a.contacts.push(other_side);
    }
    if (lost_across_ > 0) a.contacts.set_count(a.contacts.required() + lost_across_);
    for (uint32_t image = own_balls_; image < a.balls; ++image) {
      a.share_volume[images.ball_of(image)] += a.share_volume[image];
    }
    return true;
  }

  uint32_t own_balls_ = 0;    // the first so many balls are not in the halo
  bool some_inside_ = false;  // whether balls lie inside others
  bool some_trees_ = false;   // whether there are trees of contacts
  uint32_t lost_across_ = 0;  // contacts with balls of the halo for which there was no room
  uint64_t not_found_ = 0;    // a bound of the contacts of balls whose chords were not looked for
  Contacts contacts_;
  CubeCandidates candidates_;
  Caps caps_;
  ChordWalk walk_;
  PowerVertexBatch vertices_;      // found, but not yet measured
  Span<uint32_t> contact_of_cap_;  // [neighbours] the contacts of the ball at hand with later balls; no_id: none yet
};

}  // namespace hsp
