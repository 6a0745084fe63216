#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "finding.hpp"
#include "structure_laws.hpp"

namespace {

/// One piece of an arc or circle, run counter-clockwise about the axis from its lower to its higher ball.
struct Piece {
  std::uint32_t from;
  std::uint32_t to;
  double angle;
};

/// Follows pieces from one vertex to another (around, if they are the same) and expects to have used all of them.
void check_chain(const std::vector<Piece> &pieces, std::uint32_t from, std::uint32_t to, double angle, const char *kind,
                 std::uint32_t id, Finding &finding) {
  std::map<std::uint32_t, std::uint32_t> next;
  double sum = 0;
  for (const Piece &piece : pieces) {
    finding.require(next.try_emplace(piece.from, piece.to).second, "two pieces of", kind, id, "start at one vertex");
    sum += piece.angle;
  }
  std::uint32_t at = from;
  std::size_t used = 0;
  do {
    const auto step = next.find(at);
    if (!finding.require(step != next.end(), "a gap in", kind, id, "after vertex", at)) return;
    at = step->second;
    ++used;
  } while (at != to && used <= pieces.size());
  finding.require(used == pieces.size(), "pieces of", kind, id, "are no chain");
  finding.require(std::abs(sum - angle) < 1e-9, "pieces of", kind, id, "have the angle", sum, "not", angle);
}

/// Of one maximal face.
struct Cut {
  std::int64_t interior_vertices = 0;
  std::int64_t extra_edges = 0;
  std::int64_t simple_faces = 0;
};

class Pieces {
 public:
  explicit Pieces(const LibraryTopology &topology)
      : topology_(topology),
        boundary_faces_(topology.boundary().faces()),
        arcs_(topology.boundary().arcs()),
        circles_(topology.boundary().circles()),
        vertices_(topology.vertices()),
        edges_(topology.edges()),
        faces_(topology.faces()),
        cut_(boundary_faces_.size()) {}

  std::string first_broken() {
    check_vertices();
    check_simple_faces();
    if (!finding_.any()) check_edges();
    if (!finding_.any()) check_chains();
    if (!finding_.any()) check_cuts();
    return finding_.text();
  }

 private:
  void check_vertices() {
    const std::vector<hsp_vertex> given = topology_.boundary().vertices();
    if (!finding_.require(vertices_.size() >= given.size(), "vertices of the boundary are missing")) return;
    for (std::uint32_t id = 0; id < vertices_.size(); ++id) {
      const hsp_topology_vertex &v = vertices_[id];
      finding_.require(v.q % 2 == 0 && hsp_topology_origin(topology_.handle(), v.q) == id, "edge of vertex", id);
      finding_.require(v.reserved == 0, "reserved field of vertex", id);
      if (id < given.size()) {
        finding_.require(v.kind == HSP_POINT_VERTEX && std::equal(v.ball, v.ball + 3, given[id].ball) &&
                             std::equal(v.xyz, v.xyz + 3, given[id].xyz),
                         "vertex", id, "is not the boundary's");
        continue;
      }
      const std::uint32_t balls = v.kind == HSP_POINT_CIRCLE ? 2 : 1;
      finding_.require(v.kind == HSP_POINT_CIRCLE || v.kind == HSP_POINT_POLE, "kind of the added vertex", id);
      for (std::uint32_t k = 0; k < 3; ++k)
        finding_.require((v.ball[k] != HSP_NONE) == (k < balls), "balls of the added vertex", id);
      finding_.require(balls == 1 || v.ball[0] < v.ball[1], "order of the balls of the added vertex", id);
    }
  }

  void check_simple_faces() {
    for (std::uint32_t id = 0; id < faces_.size(); ++id) {
      const hsp_simple_face &face = faces_[id];
      if (!finding_.require(face.face < boundary_faces_.size(), "maximal face of simple face", id)) return;
      const hsp_face &whole = boundary_faces_[face.face];
      finding_.require(face.ball == whole.ball && face.shell == whole.shell, "ball or shell of simple face", id);
      finding_.require(face.reserved == 0, "reserved field of simple face", id);
      ++cut_[face.face].simple_faces;
      if (!finding_.require(face.q % 2 == 0 && hsp_topology_left(topology_.handle(), face.q) == id,
                            "quarter-edge of simple face", id))
        return;
      std::uint32_t edges = 0;
      std::uint32_t q = face.q;
      do {
        finding_.require(hsp_topology_ball(topology_.handle(), q) == face.ball, "another ball on the loop of", id);
        q = hsp_topology_lnext(topology_.handle(), q);
        ++edges;
      } while (q != face.q && edges <= edges_.size());
      finding_.require(edges == face.edges && edges >= 2, "edges on the loop of simple face", id);
    }
  }

  void check_edges() {
    arc_pieces_.resize(arcs_.size());
    circle_pieces_.resize(circles_.size());
    std::uint32_t extra = 0;
    for (std::uint32_t id = 0; id < edges_.size(); ++id) {
      const hsp_topology_edge &edge = edges_[id];
      const hsp_topology *handle = topology_.handle();
      for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t q = 4 * id + 2 * side;
        finding_.require(edge.vertex[side] == hsp_topology_origin(handle, q), "vertex of edge", id);
        finding_.require(edge.face[side] == hsp_topology_left(handle, q), "face of edge", id);
        finding_.require(edge.ball[side] == hsp_topology_ball(handle, q), "ball of edge", id);
        finding_.require(hsp_topology_ball(handle, q + 1) == HSP_NONE, "ball beside the dual of edge", id);
        finding_.require(edge.ball[side] == faces_[edge.face[side]].ball, "ball of the face beside edge", id);
      }
      const std::array<std::uint32_t, 2> whole = {faces_[edge.face[0]].face, faces_[edge.face[1]].face};
      if (edge.kind == HSP_EDGE_EXTRA) {
        ++extra;
        ++cut_[whole[0]].extra_edges;
        finding_.require(edge.source == HSP_NONE, "source of the extra edge", id);
        finding_.require(whole[0] == whole[1], "the extra edge", id, "is not inside one maximal face");
        continue;
      }
      const bool arc = edge.kind == HSP_EDGE_ARC;
      finding_.require(arc || edge.kind == HSP_EDGE_CIRCLE, "kind of edge", id);
      if (!finding_.require(edge.source < (arc ? arcs_.size() : circles_.size()), "source of edge", id)) return;
      const std::uint32_t *balls = arc ? arcs_[edge.source].ball : circles_[edge.source].ball;
      const std::uint32_t *sides = arc ? arcs_[edge.source].face : circles_[edge.source].face;
      // The left face lies on the axis's side, that is, on the higher ball if the axis is the source's.
      const std::size_t with = edge.ball[0] == balls[1] ? 1 : 0;
      finding_.require(edge.ball[0] == balls[with] && edge.ball[1] == balls[1 - with], "balls of edge", id);
      finding_.require(whole[0] == sides[with] && whole[1] == sides[1 - with], "faces beside edge", id);
      (arc ? arc_pieces_ : circle_pieces_)[edge.source].push_back(
          {edge.vertex[1 - with], edge.vertex[with], edge.angle});
    }
    finding_.require(extra == topology_.counts().extra_edges, "number of extra edges");
  }

  void check_chains() {
    for (std::uint32_t id = 0; id < arcs_.size(); ++id)
      check_chain(arc_pieces_[id], arcs_[id].vertex[0], arcs_[id].vertex[1], arcs_[id].angle, "arc", id, finding_);
    for (std::uint32_t id = 0; id < circles_.size(); ++id) {
      const std::vector<Piece> &pieces = circle_pieces_[id];
      if (!finding_.require(pieces.size() >= 2, "circle", id, "is one edge")) return;
      check_chain(pieces, pieces[0].from, pieces[0].from, 2 * std::numbers::pi, "circle", id, finding_);
    }
  }

  void check_cuts() {
    // A vertex is inside a maximal face if all its edges are extra.
    std::vector<bool> on_boundary(vertices_.size(), false);
    std::vector<std::uint32_t> face_of(vertices_.size(), HSP_NONE);
    for (const hsp_topology_edge &edge : edges_)
      for (const std::uint32_t v : edge.vertex) {
        if (edge.kind != HSP_EDGE_EXTRA) on_boundary[v] = true;
        face_of[v] = faces_[edge.face[0]].face;
      }
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      finding_.require((vertices_[v].kind == HSP_POINT_POLE) != on_boundary[v], "vertex", v,
                       "of the boundary is a pole, or one inside a face is none");
      if (!on_boundary[v]) ++cut_[face_of[v]].interior_vertices;
    }
    for (std::size_t f = 0; f < cut_.size(); ++f) {
      const Cut &cut = cut_[f];
      finding_.require(
          cut.interior_vertices - cut.extra_edges + cut.simple_faces == 2 - std::int64_t{boundary_faces_[f].loops},
          "maximal face", f, "of", boundary_faces_[f].loops, "loops is not cut into discs:", cut.simple_faces,
          "simple faces,", cut.extra_edges, "extra edges");
      // Extra arcs are for faces with several loops and for whole spheres alone.
      finding_.require(boundary_faces_[f].loops != 1 || cut.extra_edges == 0, "the simple maximal face", f, "is cut");
    }
  }

  const LibraryTopology &topology_;
  std::vector<hsp_face> boundary_faces_;
  std::vector<hsp_arc> arcs_;
  std::vector<hsp_circle> circles_;
  std::vector<hsp_topology_vertex> vertices_;
  std::vector<hsp_topology_edge> edges_;
  std::vector<hsp_simple_face> faces_;
  std::vector<Cut> cut_;
  std::vector<std::vector<Piece>> arc_pieces_;
  std::vector<std::vector<Piece>> circle_pieces_;
  Finding finding_;
};

}  // namespace

std::string pieces_broken(const LibraryTopology &topology) {
  return Pieces(topology).first_broken();
}
