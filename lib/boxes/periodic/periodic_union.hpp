// The union of balls in a periodic box: a ball that leaves it through one face comes in through the opposite one.
//
// The ordinary boundary and contacts are computed for the balls in the box alone, with all images near them as their
// halo. The result is that of endless copies of the box: a ball's sphere, contacts and share are cut only by balls that
// meet it, and the symbolic perturbation depends on relative positions and on an order that all copies share
// (periodic_images.hpp). Vertices, arcs and contacts across a face of the box are found from each side.
//
// Numbers without "grid" are the caller's balls, or images numbered behind them. Lengths are in steps.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "contacts/contact_groups.hpp"
#include "contacts/contacts_builder.hpp"
#include "core/limits.hpp"
#include "core/ranked_bits.hpp"
#include "periodic/periodic_images.hpp"
#include "periodic/windings.hpp"

namespace hsp {

struct PeriodicLimits {
  uint32_t balls = 0, images = 0, neighbours = 0;
  uint32_t vertices = 0;  // a vertex across faces of the box counts once for each side
  uint32_t circles = 0;
  uint32_t contacts = 0;
  uint32_t workers = 0;  // of the boundary; 0 is 1
};

// Limits that suffice for most boxes of molecules. Status::range if one would be larger than max_count.
constexpr Status default_limits(uint32_t balls, PeriodicLimits &limits) {
  if (balls > (max_count - 2048) / 36) return Status::range;
  const uint32_t all = 3 * balls + 128;
  limits = {balls, all - balls, 256, 8 * all + 64, 2 * all + 16, 12 * all + 64, 0};
  return Status::ok;
}

// How many parts the boundary in the box has. Each vertex, arc and circle counts once, on however many images it is
// seen.
struct PeriodicCounts {
  uint32_t vertices = 0;
  uint32_t arcs = 0;
  uint32_t circles = 0;
  uint32_t loops = 0;
  uint32_t faces = 0;
  uint32_t shells = 0;
  uint32_t components = 0;
  uint32_t contacts = 0;

  int64_t euler() const { return int64_t{vertices} - arcs + 2 * int64_t{faces} - loops; }
};

// A contact, as seen from a ball in the box.
struct PeriodicContact {
  uint32_t ball;   // the caller's
  uint32_t other;  // the caller's ball, or an image
  const ContactRecord *record;
};

// Images by their numbers in the grid, for the search for contacts.
class ImagesInGrid {
 public:
  ImagesInGrid(const CubeGrid &grid, const PeriodicImages &images) : grid_(grid), images_(images) {}

  static constexpr bool there = true;
  bool comes_before_its_ball(uint32_t image) const { return visited_before(shift_of(image), {}); }
  uint32_t ball_of(uint32_t image) const { return grid_.grid_index(images_.ball_of(number(image))); }
  uint32_t moved_back(uint32_t other, uint32_t image) const { return moved(other, BoxShift{} - shift_of(image)); }
  // The ball or image at which a ball or image is, when it is moved by a shift; no_id if that is not in the set.
  uint32_t moved(uint32_t ball, const BoxShift &shift) const {
    const uint32_t k = number(ball);
    const uint32_t moved = images_.find(images_.ball_of(k), images_.shift_of(k) + shift);
    return moved == no_id ? no_id : grid_.grid_index(moved);
  }

 private:
  uint32_t number(uint32_t ball) const { return grid_.balls().caller[ball]; }
  BoxShift shift_of(uint32_t ball) const { return images_.shift_of(number(ball)); }

  const CubeGrid &grid_;
  const PeriodicImages &images_;
};

class PeriodicUnion : public Limited<PeriodicLimits> {
 public:
  void carve(Workspace &workspace, const PeriodicLimits &limits);

  // Rounds balls and box to the lattice and computes everything; with areas_alone only as much as areas and their
  // derivatives need. vector: a, b, c. The executor shares the search for the boundary. first_bad names a ball that is
  // to blame, or is no_id. Status::capacity if a limit is too small; needed() then reports what suffices, as far as the
  // work got. Status::executor if the executor fails.
  Status build(const BallInput &input, const double vector[9], const Executor &executor, bool areas_alone,
               uint32_t &first_bad);

  const PeriodicImages &images() const { return images_; }
  const PeriodicCounts &counts() const { return counts_; }
  const Windings &windings() const { return windings_; }
  const CubeGrid &grid() const { return grid_; }
  const BallSet &balls() const { return grid_.balls(); }
  const Boundary &boundary() const { return boundary_.boundary(); }
  const Contacts &contacts() const { return contacts_.contacts(); }
  // Whether build() was called with areas_alone: there are no contacts, components and counts.
  bool has_areas_alone() const { return areas_alone_; }
  // The volume of the share of a grid's ball in the box; 0 without contacts.
  double share_volume(uint32_t ball) const { return areas_alone_ ? 0.0 : contacts().share_volume(ball); }
  // Whether the grid's ball is in the box, and not an image.
  bool is_in_box(uint32_t grid_ball) const { return grid_ball < images_.balls(); }
  // Whether a grid's ball or image has a face.
  bool is_exposed(uint32_t grid_ball) const {
    return boundary().is_exposed(grid_.grid_index(images_.ball_of(balls().caller[grid_ball])));
  }

  // Calls sink(contact) for every contact of the caller's ball i, ascending by the other ball or image.
  template <class Sink>
  void visit_contacts_of(uint32_t i, Sink sink) const {
    const uint32_t own = grid_.grid_index(i);
    for (const uint32_t id : contacts().row(own)) {
      const ContactRecord &record = contacts().contact(id);
      sink(PeriodicContact{i, balls().caller[record.other(own)], &record});
    }
  }
  // The order of balls and images: balls in the caller's order, images of one ball by position, lower ones first, by z,
  // then y, then x. The order does not depend on the basis of the box.
  bool comes_first(uint32_t k, uint32_t other) const {
    const uint32_t own = images_.ball_of(k), ball = images_.ball_of(other);
    return own != ball ? own < ball : visited_before(images_.shift_of(k), images_.shift_of(other));
  }
  // Whether a part that ball i has in common with ball or image k is listed at ball i: it is listed at the first of the
  // two.
  bool is_listed(uint32_t i, uint32_t k) const { return comes_first(i, k); }
  bool is_listed(const PeriodicContact &contact) const { return is_listed(contact.ball, contact.other); }

  // Contacts between groups of the caller's balls; an image belongs to the group of its ball. The result is in memory
  // of this union, and valid until the next call.
  ContactGroups group_contacts(const uint32_t *group) {
    // Further records are contacts with images as seen from the other side.
    return {balls(), contacts(), counts_.contacts, {group, images_.balls_of_all()}, contacts_.scratch()};
  }

  // Each vertex, arc and circle in the box is listed once, as it is when the first of its balls is in the box; an arc
  // as its half-edge on that ball. Its number is its rank among the listed ones of its kind.
  const RankedBits &listed_vertices() const { return listed_vertices_; }
  const RankedBits &listed_half_edges() const { return listed_half_edges_; }
  const RankedBits &listed_circles() const { return listed_circles_; }
  // The balls of a vertex, the first one first.
  OrderedVertex in_listed_order(const VertexRecord &vertex) const {
    const Span<const uint32_t> caller = balls().caller;
    return in_order(vertex, [&](uint32_t p, uint32_t q) { return comes_first(caller[p], caller[q]); });
  }
  // The half-edge of the same arc on its other ball, at the place of that ball in the box; no_id if there is none,
  // which cannot happen.
  uint32_t half_edge_across(uint32_t ball, uint32_t half_edge) const;
  // The same for a whole circle. False if there is none.
  bool find_across(ClosedHalfEdge own, ClosedHalfEdge &across) const;

 private:
  Status join_balls(Patience &patience);
  Status count(Patience &patience);
  bool list_vertices(Patience &patience);
  Status join_faces(Patience &patience);
  PeriodicImages images_;
  CubeGrid grid_;
  BoundaryBuilder boundary_;
  ContactsBuilder contacts_;
  Windings windings_;
  RankedBits listed_vertices_, listed_half_edges_, listed_circles_;
  PeriodicCounts counts_;
  bool areas_alone_ = false;
};

// The digest of a grid (model/set_digest.hpp), together with the box and the places where the caller has put the balls.
uint64_t digest_of(const PeriodicUnion &periodic);

}  // namespace hsp
