#include "cells/facet_overlay.hpp"

#include <utility>

#include "core/sorting.hpp"

namespace hsp {
namespace {

bool same_pair(const PowerPlane &a, const PowerPlane &b) {
  return (a.near == b.near && a.far == b.far) || (a.near == b.far && a.far == b.near);
}

// Sets the balls of two lines, each once. False if they are not three.
bool three_balls(const PowerPlane &a, const PowerPlane &b, uint32_t ball[3]) {
  if (a.is_side() || b.is_side() || same_pair(a, b)) return false;
  const bool near_shared = b.near == a.near || b.near == a.far;
  const bool far_shared = b.far == a.near || b.far == a.far;
  if (!near_shared && !far_shared) return false;
  ball[0] = a.near;
  ball[1] = a.far;
  ball[2] = near_shared ? b.far : b.near;
  return true;
}

// Whether the common point of two lines lies on a third one for all weights.
bool concur(const PowerPlane &a, const PowerPlane &b, const PowerPlane &line) {
  if ((!a.is_side() && same_pair(a, line)) || (!b.is_side() && same_pair(b, line))) return true;
  uint32_t ball[3];
  if (!three_balls(a, b, ball)) return false;
  const auto is_one = [&](uint32_t k) { return k == ball[0] || k == ball[1] || k == ball[2]; };
  return is_one(line.near) && is_one(line.far);
}

}  // namespace

void FacetOverlay::carve(Workspace &workspace, uint32_t balls) {
  const uint64_t planes = PowerPolytope::most_planes(balls);
  workspace.take_each(2 * planes, corners_, other_corners_, edges_, other_edges_);
  above_planes_ = workspace.take<UnitPlane>(planes);
  sides_ = workspace.take<int8_t>(2 * planes);
  workspace.take_each(static_cast<uint64_t>(balls) + 1, below_, above_, near_);
  parts_.carve(workspace, planes);
  target_ = workspace.target();
}

// Notes that a corner lies on an edge of the facet above; if it lies on two edges, it is the corner between them.
void FacetOverlay::lies_on(Corner &corner, uint32_t edge) const {
  if (corner.edge_of[1] == no_id) {
    corner.edge_of[1] = edge;
  } else if (corner.edge_of[1] != edge && corner.corner_of[1] == no_id) {
    corner.corner_of[1] = polygon_[1].corner_between(corner.edge_of[1], edge);
  }
}

// Whether each of the two facets belongs to one cell: then there is at most one contact.
bool FacetOverlay::have_one_cell_each() const {
  return polygon_[0].facet->cell != no_id && polygon_[1].facet->cell != no_id;
}

// Compares the corners of one facet with the edges of the other. Both have the same coordinates along the side.
FacetSides FacetOverlay::compare(const Polygon &corners, const Polygon &lines) const {
  const SideFacet &of = *corners.facet, &around = *lines.facet;
  const double margin = of.error + 0x1p-21 * frame_.side();
  const double *const u = corners.facets->u(of), *const w = corners.facets->w(of);
  const FlatLine *const edges = lines.facets->lines(around);
  return compare_facets(target_, u, w, of.corners, edges, around.corners, margin);
}

// Whether two facets are apart, or have a piece, or doubles do not know. They are apart if one is certainly beyond an
// edge of the other. They have a piece if a corner of one is certainly in the other, or if certainly no edge of either
// has all of the other beyond it: for two disjoint convex polygons are separated by the line of an edge of one of them.
FacetOverlay::Meeting FacetOverlay::compare() const {
  const Polygon &below = polygon_[0], &above = polygon_[1];
  if (below.size() > 64 || above.size() > 64) return Meeting::unknown;
  const FacetSides lower = compare(below, above);
  if (lower.apart) return Meeting::apart;
  if (lower.inside != 0) return Meeting::together;
  const FacetSides upper = compare(above, below);
  if (upper.apart) return Meeting::apart;
  return upper.inside != 0 || (lower.reached && upper.reached) ? Meeting::together : Meeting::unknown;
}

// If two facets of one ball have the same lines, they are one polygon, seen from two sides, and every corner of the
// piece is a corner of both. Then adds the parts of the piece and returns true. These parts need no names, as no other
// parts lie in these facets.
bool FacetOverlay::add_parts_of_equals(uint32_t below, uint32_t above) {
  const Polygon &lower = polygon_[0], &upper = polygon_[1];
  const uint32_t size = lower.size();
  if (upper.size() != size) return false;
  uint32_t at = 0;  // the edge above that is edge 0 below
  while (at < size && upper.corner(at).line != lower.corner(0).line) ++at;
  if (at == size) return false;
  for (uint32_t k = 1, e = upper.previous(at); k < size; ++k, e = upper.previous(e)) {
    if (upper.corner(e).line != lower.corner(k).line) return false;
  }
  const uint64_t known = parts_.required();
  bool from_free = lower.corner(size - 1).edge_free != 0;
  for (uint32_t k = 0, same = upper.next(at); k < size; ++k, same = upper.previous(same)) {
    const FacetCorner &corner = lower.corner(k);
    // A part begins at a corner behind an edge that is not free.
    if (corner.cell != no_id && !from_free) {
      parts_.add(below, above, corner.cell, upper.corner(same).cell);
    }
    from_free = corner.edge_free != 0;
  }
  if (parts_.required() == known) {  // all edges are free
    parts_.add(below, above, lower.corner(0).cell, upper.corner(upper.next(at)).cell);
  }
  return true;
}

// A corner of the facet below, in the frame of the cube above.
BoundedPoint FacetOverlay::corner_below(uint32_t corner) const {
  return polygon_[0].facets->point(*polygon_[0].facet, corner, axes_along(side_.side() / 2), -frame_.side());
}

// Sets the piece to the whole facet below, in the frame of the cube above.
void FacetOverlay::start() {
  const Polygon &below = polygon_[0], &above = polygon_[1];
  size_ = below.size();
  for (uint32_t k = 0; k < size_; ++k) {
    corners_[k] = {corner_below(k), {k, no_id}, {k, no_id}, 0};
    const PowerPlane line = below.line(k);
    edges_[k] = {line, {k, no_id}};
  }
  // Both facets may lie along the same sides.
  for (uint32_t e = 0; e < above.size(); ++e) {
    if (!above.line(e).is_side()) continue;
    for (uint32_t k = 0; k < size_; ++k) {
      if (!(edges_[k].line == above.line(e))) continue;
      edges_[k].of[1] = e;
      lies_on(corners_[k], e);
      lies_on(corners_[next(k)], e);
    }
  }
}

int FacetOverlay::side_of(uint32_t corner, const PowerPlane &line, const UnitPlane &plane) const {
  const int side = frame_.side_of(corners_[corner].at, plane);
  if (side != 0) return side;
  const PowerPlane &a = edges_[previous(corner)].line, &b = edges_[corner].line;
  if (concur(a, b, line)) return 0;
  return PowerPredicates(*balls_, polygon_[0].facet->ball, frame_).side_of(a, b, side_, line);
}

// Cuts from the piece the part beyond an edge of the facet above. Returns whether anything is left.
bool FacetOverlay::cut(uint32_t edge) {
  const PowerPlane line = polygon_[1].line(edge);
  if (line.is_side()) return true;
  const UnitPlane plane = above_planes_[edge];
  bool any_near = false, any_beyond = false;
  for (uint32_t k = 0; k < size_; ++k) {
    const int side = side_of(k, line, plane);
    sides_[k] = static_cast<int8_t>(side);
    any_near |= side > 0;
    any_beyond |= side < 0;
  }
  if (!any_near) return false;
  for (uint32_t k = 0; k < size_; ++k) {
    if (sides_[k] != 0) continue;
    lies_on(corners_[k], edge);
    if (sides_[next(k)] == 0) edges_[k].of[1] = edge;
  }
  if (!any_beyond) return true;

  uint32_t count = 0;
  const auto add = [&](const Corner &corner, const Edge &out) {
    other_corners_[count] = corner;
    other_edges_[count++] = out;
  };
  const auto crossing = [&](const Edge &crossed) {
    Corner corner{frame_.common_point(frame_.plane(*balls_, crossed.line), plane, side_plane_),
                  {no_id, no_id},
                  {crossed.of[0], edge},
                  0};
    if (crossed.of[1] != no_id && crossed.of[1] != edge) {
      corner.corner_of[1] = polygon_[1].corner_between(crossed.of[1], edge);
    }
    return corner;
  };
  const Edge along_line{line, {no_id, edge}};
  for (uint32_t k = 0; k < size_; ++k) {
    const int here = sides_[k], there = sides_[next(k)];
    if (here >= 0) add(corners_[k], here == 0 && there < 0 ? along_line : edges_[k]);
    if (here > 0 && there < 0) add(crossing(edges_[k]), along_line);
    if (here < 0 && there > 0) add(crossing(edges_[k]), edges_[k]);
  }
  std::swap(corners_, other_corners_);
  std::swap(edges_, other_edges_);
  size_ = count;
  return true;
}

// Finds which corners of a piece of two facets of one ball lie outside the ball.
void FacetOverlay::find_outside() {
  const uint32_t ball = polygon_[0].facet->ball;
  const Vec3 centre = frame_.centre_of(*balls_, ball);
  const double r = balls_->r[ball];
  for (uint32_t k = 0; k < size_; ++k) {
    Corner &corner = corners_[k];
    int outside = 0;
    for (uint32_t which = 0; which < 2; ++which) {
      if (corner.corner_of[which] == no_id) continue;
      outside = polygon_[which].corner(corner.corner_of[which]).cell != no_id ? 1 : -1;
    }
    if (outside == 0) {
      const Vec3 y = corner.at.y - centre;
      outside = frame_.outside(dot(y, y), corner.at.error, 4 * r * r);
    }
    if (outside == 0) {
      const PowerPredicates exact(*balls_, ball, frame_);
      outside = exact.is_outside(edges_[previous(k)].line, edges_[k].line, side_) ? 1 : -1;
    }
    corner.outside = outside > 0 ? 1 : 0;
  }
}

// Whether an edge of such a piece is outside the ball, if its ends are.
bool FacetOverlay::edge_is_free(uint32_t k) const {
  const Edge &edge = edges_[k];
  for (uint32_t which = 0; which < 2; ++which) {
    if (edge.of[which] != no_id && polygon_[which].corner(edge.of[which]).edge_free != 0) return true;
  }
  const uint32_t ball = polygon_[0].facet->ball;
  const Vec3 centre = frame_.centre_of(*balls_, ball);
  const BoundedPoint &from = corners_[k].at, &to = corners_[next(k)].at;
  const double r = balls_->r[ball];
  const int outside = frame_.segment_outside(from, dot(from.y - centre, from.y - centre), to,
                                             dot(to.y - centre, to.y - centre), centre, 4 * r * r);
  if (outside != 0) return outside > 0;
  return PowerPredicates(*balls_, ball, frame_)
      .is_free(edge.line, side_, edges_[previous(k)].line, edges_[next(k)].line);
}

// The cell of a corner outside the ball of one of the two facets; no_id if it is inside a facet with several cells.
uint32_t FacetOverlay::cell_of(uint32_t which, uint32_t corner) const {
  const Polygon &polygon = polygon_[which];
  if (polygon.facet->cell != no_id) return polygon.facet->cell;
  const Corner &at = corners_[corner];
  if (at.corner_of[which] != no_id) return polygon.corner(at.corner_of[which]).cell;
  const uint32_t edge = at.edge_of[which];
  if (edge == no_id) return no_id;
  const uint32_t from = polygon.corner(edge).cell;
  const uint32_t to = polygon.corner(polygon.next(edge)).cell;
  if (from == to || to == no_id) return from;
  if (from == no_id) return to;
  // The ball covers a part of the edge, on one side of the corner.
  const PowerPlane &across = edges_[corner].of[which] == edge ? edges_[previous(corner)].line : edges_[corner].line;
  const PowerPredicates exact(*balls_, polygon.facet->ball, frame_);
  const PowerPlane line = polygon.line(edge);
  const int covered = exact.side_of_middle(line, side_, across);
  return exact.side_of(line, polygon.line(polygon.previous(edge)), side_, across) == covered ? to : from;
}

// Names a corner by its three balls, which are the same in all pieces around it. False if it is not of three balls.
bool FacetOverlay::name_of(uint32_t corner, FacetParts::Name &name) const {
  if (!three_balls(edges_[previous(corner)].line, edges_[corner].line, name.ball)) return false;
  sort_three(name.ball[0], name.ball[1], name.ball[2]);
  return true;
}

// The position of a corner; by integers if doubles do not know it, as lines that meet there are nearly parallel.
Vec3 FacetOverlay::position(uint32_t corner) const {
  const BoundedPoint &at = corners_[corner].at;
  if (at.error < no_certainty) return at.y;
  const uint32_t ball = polygon_[0].facet->ball;
  return frame_.centre_of(*balls_, ball) +
         PowerPredicates(*balls_, ball, frame_).common_point(edges_[previous(corner)].line, edges_[corner].line, side_);
}

// The portal of a part: for two balls the mean of the corners of the piece, which is free; for one ball the corner that
// is farthest from it.
Vec3 FacetOverlay::portal_of(uint32_t first, uint32_t count) const {
  const uint32_t ball = polygon_[0].facet->ball;
  const bool is_convex = polygon_[1].facet->ball != ball;
  const Vec3 centre = frame_.centre_of(*balls_, ball);
  Vec3 sum{0, 0, 0}, best{0, 0, 0};
  double farthest = -1.0;
  for (uint32_t n = 0, k = first; n < count; ++n, k = next(k)) {
    const Vec3 at = position(k);
    sum = sum + at;
    const double distance = dot(at - centre, at - centre);
    if (distance <= farthest) continue;
    farthest = distance;
    best = at;
  }
  return is_convex ? (1.0 / count) * sum : best;
}

void FacetOverlay::add_part(uint32_t below, uint32_t above, uint32_t first, uint32_t count, CellContacts &contacts,
                            uint64_t first_contact) {
  uint32_t cell[2] = {no_id, no_id};
  for (uint32_t n = 0, k = first; n < count; ++n, k = next(k)) {
    for (uint32_t which = 0; which < 2; ++which) {
      if (cell[which] == no_id) cell[which] = cell_of(which, k);
    }
  }
  const Vec3 portal = contacts.has_portals() ? portal_of(first, count) : Vec3{};
  if (have_one_cell_each()) {
    if (contacts.required() == first_contact) contacts.push({{cell[0], cell[1]}}, frame_, portal);
    return;
  }
  parts_.add(below, above, cell[0], cell[1], portal);
  for (uint32_t n = 0, k = first; n < count; ++n, k = next(k)) {
    FacetParts::Name name;
    if (name_of(k, name)) parts_.add_name(name);
  }
}

void FacetOverlay::overlay(uint32_t below, uint32_t above, CellContacts &contacts) {
  start();
  for (uint32_t edge = 0; edge < polygon_[1].size(); ++edge) {
    if (!cut(edge)) return;
  }
  const uint64_t first_contact = contacts.required();
  if (polygon_[0].facet->ball != polygon_[1].facet->ball) {
    return add_part(below, above, 0, size_, contacts, first_contact);
  }
  find_outside();
  // sides_[k]: whether the edge from corner k to the next one joins both.
  bool any_gap = false;
  for (uint32_t k = 0; k < size_; ++k) {
    const bool joins = corners_[k].outside != 0 && corners_[next(k)].outside != 0 && edge_is_free(k);
    sides_[k] = joins ? 1 : 0;
    any_gap |= !joins;
  }
  if (!any_gap) return add_part(below, above, 0, size_, contacts, first_contact);
  for (uint32_t k = 0; k < size_; ++k) {
    if (corners_[k].outside == 0 || sides_[previous(k)] != 0) continue;
    uint32_t count = 1;
    for (uint32_t at = k; sides_[at] != 0; at = next(at)) ++count;
    add_part(below, above, k, count, contacts, first_contact);
  }
}

// Lists the facets of a cube on a side that are not covered. Returns how many.
uint32_t FacetOverlay::list(Span<uint32_t> out, const Side &side, uint32_t number) {
  uint32_t *const listed = out.data();
  uint32_t count = 0;
  for (const uint32_t k : side.range) {
    listed[count] = k;  // written in any case, counted if it is on that side
    count += side.facets.facet(k).side == number ? 1 : 0;
  }
  return count;
}

// Lists the facets below whose boxes meet that of a facet above, without those of another ball if both balls meet both
// cubes. Which these are cannot be predicted, so that no branch depends on it. Returns how many.
uint32_t FacetOverlay::list_near(const SideFacets &facets, uint32_t lower_count, const SideFacet &over) {
  const uint32_t *const lowers = below_.data();
  uint32_t *const near = near_.data();
  uint32_t count = 0;
  for (uint32_t b = 0; b < lower_count; ++b) {
    const SideFacet &under = facets.facet(lowers[b]);
    const uint32_t overlaps = (under.high_u >= over.low_u ? 1U : 0U) & (over.high_u >= under.low_u ? 1U : 0U) &
                              (under.high_w >= over.low_w ? 1U : 0U) & (over.high_w >= under.low_w ? 1U : 0U);
    const uint32_t may_touch = (over.ball == under.ball ? 1U : 0U) | (1U ^ (over.meets_both & under.meets_both));
    near[count] = lowers[b];
    count += overlaps & may_touch;
  }
  return count;
}

Status FacetOverlay::find(const BallSet &balls, const CubeFrame &frame, uint32_t axis, const Side &below,
                          const Side &above, CellContacts &contacts) {
  balls_ = &balls;
  frame_ = frame;
  side_ = side_plane(2 * axis);
  side_plane_ = CubeFrame::side_in_doubles(2 * axis, frame.side());
  parts_.clear();
  const uint32_t lower_count = list(below_, below, 2 * axis + 1);
  const uint32_t upper_count = list(above_, above, 2 * axis);
  for (const uint32_t a : above_.part(0, upper_count)) {
    const SideFacet &over = above.facets.facet(a);
    polygon_[1] = {&above.facets, &over};
    bool has_planes = false;
    const uint32_t near_count = list_near(below.facets, lower_count, over);
    for (const uint32_t b : near_.part(0, near_count)) {
      const SideFacet &under = below.facets.facet(b);
      polygon_[0] = {&below.facets, &under};
      const AdjacentCells cells{{under.cell, over.cell}};
      // A portal is chosen among all corners of the piece.
      const bool one_contact = have_one_cell_each() && !contacts.has_portals();
      const uint32_t is_certain = (one_contact ? 1U : 0U) & (over.ball == under.ball ? 1U : 0U) &
                                  (under.has_covered_corner | over.has_covered_corner);
      if (is_certain != 0) {  // one branch, as each of its conditions is as likely as not
        contacts.push(cells);
        continue;
      }
      const Meeting meeting = compare();
      if (meeting == Meeting::apart) continue;
      if (meeting == Meeting::together && one_contact) {
        contacts.push(cells);
        continue;
      }
      if (over.ball == under.ball && !contacts.has_portals() && !have_one_cell_each() && add_parts_of_equals(b, a)) {
        continue;
      }
      if (!has_planes) {
        for (uint32_t e = 0; e < polygon_[1].size(); ++e) {
          above_planes_[e] = frame_.plane(balls, polygon_[1].line(e));
        }
        has_planes = true;
      }
      overlay(b, a, contacts);
    }
  }
  return parts_.overflowed() ? Status::capacity : parts_.resolve(frame_, contacts);
}

}  // namespace hsp
