// The power cell of one ball in one cube: the points of the cube that have no smaller power to another ball that meets
// the cube. Its part outside the ball consists of connected free parts.
//
// Theorem. The components of K \ B, for a convex polytope K and a ball B, correspond to the components of this graph:
// the vertices of K outside B, joined by the edges of K that lie outside B as a whole. Proof: from a common point q of
// K and B every ray leaves the convex B once and K once. So K \ B retracts to its part of the boundary of K. In the
// same way every facet retracts to its border, and an edge, of which B covers an interval, to its ends. If K and B have
// no common point, all vertices and edges are outside and connected.
#pragma once

#include "cells/cube_members.hpp"
#include "cells/member_blocks.hpp"
#include "cells/power_polytope.hpp"
#include "cells/power_predicates.hpp"
#include "cells/vertex_edges.hpp"

namespace hsp {

class PowerCell {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Sets the cube whose power cells follow, and its members, the balls that meet it.
  void enter(const BallSet &balls, const CubeFrame &frame, Span<const uint32_t> members);
  // Discards the balls whose power cells are certainly empty, as another ball has less power all over the cube. From
  // then on a ball whose power cell is found to be empty is discarded, too.
  void drop_dominated();

  // The power cell of member number k, which may be empty.
  void build(uint32_t k) { cut_out(k, false); }
  // The same. But a cell that lies in its ball and is not empty may be left not cut to the end: it has no free parts.
  void build_unless_covered(uint32_t k) { cut_out(k, true); }
  // Finds the vertices outside the ball, the edges outside it, and the free parts.
  void find_free_parts();

  const CubeFrame &frame() const { return frame_; }
  bool empty() const { return polytope_.size() == 0; }
  uint32_t ball() const { return members_[member_]; }
  const PowerPolytope &polytope() const { return polytope_; }
  // The position of a vertex; by integers if doubles do not know it, as planes that meet there are nearly parallel.
  Vec3 position(uint32_t vertex) const;
  uint32_t parts() const { return parts_; }
  // The free part of a vertex; no_id for a vertex inside the ball.
  uint32_t part_of(uint32_t vertex) const { return part_[vertex]; }
  // Whether the edge opposite to plane k of a vertex is outside the ball as a whole.
  bool is_free_edge(uint32_t vertex, uint32_t k) const { return (free_edges_[vertex] >> k & 1) != 0; }
  // Whether the ball and its power cell have a common point. Only for cells without vertices in the ball.
  bool meets_ball() const;

  // Plane numbers: sides, then members.
  PowerPlane plane(uint32_t number) const {
    return number < cube_sides ? side_plane(number) : PowerPlane{ball(), members_[number - cube_sides]};
  }
  // The plane in doubles, if the cell has a vertex on it.
  const UnitPlane &unit_plane(uint32_t number) const { return planes_[number]; }
  // The code of a plane, which does not depend on the members: a side, or a ball plus six.
  uint32_t code_of(uint32_t number) const { return codes_[number]; }
  // The members whose planes have cut the cell, each once; some may have no facet left.
  uint32_t cutters() const { return cutter_count_; }
  uint32_t cutter(uint32_t k) const { return cutters_[k]; }
  // The first vertex outside the ball on a side, or on the plane of a cutter; no_id if there is none.
  uint32_t first_free(uint32_t number) const { return first_free_[number]; }

 private:
  // From the centre of the cube to that of a member.
  Vec3 offset(uint32_t m) const { return {x_[m], y_[m], z_[m]}; }
  MemberArrays numbers() const {
    return {x_.data(), y_.data(), z_.data(), radius_.data(), power_.data(), in_game_.data(), members_.size()};
  }
  MemberBall own() const { return {x_[member_], y_[member_], z_[member_], radius_[member_], power_[member_]}; }
  bool is_in_game(uint32_t m) const { return in_game_[m] > 0.0; }
  void take_out_of_game(uint32_t m) {
    in_game_[m] = 0.0;
    if (blocks_.is_there()) blocks_.discard(m);
  }
  // The member whose plane is number p of of_planes_.
  uint32_t member_of_plane(uint32_t p) const { return blocks_.is_there() ? blocks_.member_at(p) : p; }
  void cut_out(uint32_t k, bool unless_covered);
  void find_member_planes();
  bool order_next_planes();
  bool has_certain_point() const;
  uint32_t find_free_vertices(double limit, double error);
  uint32_t list_edges();
  template <class Visit>
  void for_each_free_edge(double limit, double error, Visit visit);
  void gather_few(double limit, double error);
  void gather_many(uint32_t free_vertices);
  bool is_outside(uint32_t v) const;
  bool edge_is_free(uint32_t v, uint32_t k) const;
  bool has_centre_before(uint32_t number) const;
  bool contains_disc(uint32_t number) const;

  const BallSet *balls_ = nullptr;
  CubeFrame frame_;
  Span<const uint32_t> members_;
  uint32_t member_ = 0;
  Vec3 centre_{};
  PowerPolytope polytope_;
  Span<double> x_, y_, z_, radius_, power_, in_game_;  // [members + 7] as MemberArrays has them
  MemberBlocks blocks_;                                // of many members
  PlaneArrays of_planes_{};                            // [members + 7] or, of blocks, [places]
  Span<PlaneOrder> order_;                             // [1]
  Span<UnitPlane> planes_;                             // [sides + members]
  Span<uint32_t> codes_, first_free_;                  // [sides + members] the latter of_planes_.nearest, too
  Span<uint32_t> cutters_;                             // [members]
  Span<uint32_t> part_;                                // [vertices]
  Span<uint32_t> waiting_;                             // [vertices]
  Span<EdgeEnds> edges_;                               // [edges + edges_behind]
  Span<uint8_t> free_edges_;                           // [vertices] a bit for each
  Span<uint64_t> outside_;                             // [vertices / 64] a bit for each
  uint32_t parts_ = 0, cutter_count_ = 0, planes_at_once_ = 0;
  Target target_ = Target::baseline;
};

}  // namespace hsp
