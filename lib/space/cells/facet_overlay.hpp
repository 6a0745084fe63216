// Where the cells of two cubes touch on their common side: the overlay of the facets that the power cells of both have
// there.
//
// A piece is what two facets have in common, a convex polygon. If they belong to two balls, neither covers any of the
// piece: a point of it in one ball has the least power to that ball in the one cube, and to the other ball in the other
// cube, but both balls then meet both cubes and the powers would have to be equal. So the piece is outside both balls;
// and facets of two balls that meet both cubes have no piece in common. If the facets belong to one ball, the corners
// of the piece outside it, joined by edges outside it, are the connected parts of the piece without the ball, as in
// power_cell.hpp. Each such part joins a cell of one cube and a cell of the other.
//
// The facets are polygons of lines, each where the powers to two balls are equal, cut from each other by the exact side
// of a corner, two lines, and a third line. Lines of three balls whose pairs make up a triangle have a common point for
// all weights, and a line may be in both facets: such corners lie on the line, all others on one side of it.
//
// Which cell a part belongs to is known by a corner of the facet, or by a point of an edge between two such corners. A
// part that touches no border of a facet touches others in it, at corners that three facets of the other cube have in
// common, and one of these parts reaches the border: every part of a facet outside a ball does.
//
// Most facets belong to one cell each. Then all that is asked of two of them is whether they have a piece, as that has
// a point outside the balls. For two balls this was said above. Two facets of one ball have the same part in the ball:
// another ball with less power at a point of that would hold the point, and so meet both cubes. If there is such a
// part, the arc that bounds it inside the facets belongs to both, and so do the points near the arc outside the ball,
// since a ball that does not meet the side has more power there. If there is none, all of both facets is outside. So
// the cells of facets of one ball touch without further questions if one of the facets has a corner in the ball. Else
// a corner of either facet that is certainly in the other answers it, or an edge of either that the other is certainly
// beyond, or that there is none.
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
  // Finds the contacts of the facets on a side of a cube, those `above` with side 2 axis, with those of the cube below
  // it in direction `axis`, with side 2 axis + 1. frame is that of the cube above. Facets on one side come in the order
  // of their balls. Status::capacity: memory for needed_balls() per cube would have sufficed. Status::check cannot
  // happen.
  Status find(const BallSet &balls, const CubeFrame &frame, uint32_t axis, const Side &below, const Side &above,
              CellContacts &contacts);
  uint32_t needed_balls() const { return parts_.needed_balls(); }

 private:
  struct Edge {
    PowerPlane line;
    uint32_t of[2];  // the edges of the two facets on which it lies, or no_id
  };
  struct Corner {
    BoundedPoint at;
    uint32_t corner_of[2];  // the corners of the two facets that it is, or no_id
    uint32_t edge_of[2];    // edges of the two facets on which it lies, or no_id
    uint32_t outside;
  };
  // A facet of one of the two cubes, as lines.
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

  // A facet with a part outside its ball, whether that meets the other cube too, and the box around it.
  struct Listed {
    uint32_t facet, ball, meets_both;
    float low_u, high_u, low_w, high_w;
  };
  enum class Meeting { apart, together, unknown };

  static uint32_t list(Span<Listed> out, const Side &side, uint32_t number);
  uint32_t list_near(const Listed &over, uint32_t lower_count);
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
  // The piece: corner k and the edge from it to the next one. The others take what is left while it is cut.
  Span<Corner> corners_, other_corners_;
  Span<Edge> edges_, other_edges_;
  Span<UnitPlane> above_planes_;  // of the edges of the facet above
  Span<int8_t> sides_;
  Span<Listed> below_, above_;
  Span<uint32_t> near_;  // of those below, the ones that one above may have a piece with
  Target target_ = Target::baseline;
  uint32_t size_ = 0;
  FacetParts parts_;  // whose cell on one of the sides is not known, or that may tell others theirs
};

}  // namespace hsp
