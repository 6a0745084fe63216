// Finds which cells of two cubes touch on their common side: the overlay of the facets that the power cells of both
// cubes have there.
//
// A piece is the intersection of two facets, one of each cube: a convex polygon. If the facets belong to two balls, the
// piece is outside both. For a point of it in one ball has the least power to that ball in the one cube, and to the
// other ball in the other cube; then both balls meet both cubes, and the powers would have to be equal. For the same
// reason facets of two balls that meet both cubes have no piece. If the facets belong to one ball, the corners of the
// piece outside it, joined by edges outside it, give the connected parts of the piece without the ball, as in
// power_cell.hpp. Each such part joins a cell of one cube and a cell of the other.
//
// The facets are polygons of lines, each of which is the radical line of two balls on the side. One polygon is cut by
// the lines of the other: on which exact side of a third line is a corner of two lines? Lines of three balls whose
// pairs make up a triangle have a common point for all weights, and a line may belong to both facets. Then the corner
// lies on the line; any other corner lies on one side of it.
//
// The cell that a part belongs to is known from a corner of the facet, or from a point of an edge between two such
// corners. A part that touches no border of a facet touches other parts in it, at corners that three facets of the
// other cube have in common. One of these parts reaches the border, as every part of a facet outside a ball does.
//
// Most facets belong to one cell each. Then the only question about two facets is whether they have a piece, since a
// piece has a point outside the balls. For two balls this was shown above. Two facets of one ball have the same part in
// the ball: another ball with less power at a point of that part would contain the point, and so meet both cubes. If
// there is such a part, the arc that bounds it inside the facets belongs to both. So do the points near the arc outside
// the ball, since a ball that does not meet the side has more power there. If there is no such part, both facets are
// outside. So the cells of facets of one ball touch without further questions if one of the facets has a corner in the
// ball. Else the question is decided by a corner of one facet that is certainly in the other, by an edge of one that
// the other is certainly beyond, or because there is no such edge.
#pragma once

#include "cells/facet_parts.hpp"
#include "cells/free_space.hpp"
#include "cells/side_facets.hpp"

namespace hsp {

class FacetOverlay {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // The facets of one of the two cubes.
  struct Side {
    const SideFacets &facets;
    IdRange range;
  };
  // Finds the contacts across the common side of two cubes that are neighbours along `axis`. above: the facets of the
  // upper cube on its side 2 axis; below: those of the lower cube on its side 2 axis + 1. frame: that of the upper
  // cube. Facets on one side come in the order of their balls. Status::capacity: memory for needed_balls() per cube
  // would have sufficed. Status::check cannot happen.
  Status find(const BallSet &balls, const CubeFrame &frame, uint32_t axis, const Side &below, const Side &above,
              CellContacts &contacts);
  uint32_t needed_balls() const { return parts_.needed_balls(); }

 private:
  struct Edge {
    PowerPlane line;
    uint32_t of[2];  // the edge of each of the two facets on which it lies, or no_id
  };
  struct Corner {
    BoundedPoint at;
    uint32_t corner_of[2];  // the corner of each of the two facets that it is, or no_id
    uint32_t edge_of[2];    // an edge of each of the two facets on which it lies, or no_id
    uint32_t outside;
  };
  // A facet of one of the two cubes, as a polygon of lines.
  struct Polygon {
    const SideFacets *facets;
    const SideFacet *facet;
    const FacetCorner &corner(uint32_t k) const { return facets->corner(*facet, k); }
    uint32_t size() const { return facet->corners; }
    uint32_t next(uint32_t k) const { return k + 1 < size() ? k + 1 : 0; }
    uint32_t previous(uint32_t k) const { return (k > 0 ? k : size()) - 1; }
    PowerPlane line(uint32_t k) const { return plane_of_code(corner(k).line, facet->ball); }
    // The corner between two edges; no_id if they are not neighbours.
    uint32_t corner_between(uint32_t a, uint32_t b) const { return next(a) == b ? b : next(b) == a ? a : no_id; }
  };

  enum class Meeting { apart, together, unknown };

  static uint32_t list(Span<uint32_t> out, const Side &side, uint32_t number);
  uint32_t list_near(const SideFacets &facets, uint32_t lower_count, const SideFacet &over);
  bool have_one_cell_each() const;
  Meeting compare() const;
  FacetSides compare(const Polygon &corners, const Polygon &lines) const;
  bool add_parts_of_equals(uint32_t below, uint32_t above);
  BoundedPoint corner_below(uint32_t corner) const;
  void start();
  bool cut(uint32_t edge);
  int side_of(uint32_t corner, const PowerPlane &line, const UnitPlane &plane) const;
  void lies_on(Corner &corner, uint32_t edge) const;
  void overlay(uint32_t below, uint32_t above, CellContacts &contacts);
  void find_outside();
  bool edge_is_free(uint32_t k) const;
  void add_part(uint32_t below, uint32_t above, uint32_t first, uint32_t count, CellContacts &contacts,
                uint64_t first_contact);
  Vec3 position(uint32_t corner) const;
  Vec3 portal_of(uint32_t first, uint32_t count) const;
  uint32_t cell_of(uint32_t which, uint32_t corner) const;
  bool name_of(uint32_t corner, FacetParts::Name &name) const;

  uint32_t previous(uint32_t k) const { return (k > 0 ? k : size_) - 1; }
  uint32_t next(uint32_t k) const { return k + 1 < size_ ? k + 1 : 0; }

  const BallSet *balls_ = nullptr;
  CubeFrame frame_;
  PowerPlane side_{};
  UnitPlane side_plane_{};
  Polygon polygon_[2]{};
  // The piece: corner k, and edge k from it to the next corner. A cut writes what is left to the other arrays.
  Span<Corner> corners_, other_corners_;
  Span<Edge> edges_, other_edges_;
  Span<UnitPlane> above_planes_;  // the planes of the edges of the facet above
  Span<int8_t> sides_;
  Span<uint32_t> below_, above_;  // the facets of both cubes on the side
  Span<uint32_t> near_;           // the facets below with which one above may have a piece
  Target target_ = Target::baseline;
  uint32_t size_ = 0;
  FacetParts parts_;  // parts with an unknown cell on one side, and parts that may tell others theirs
};

}  // namespace hsp
