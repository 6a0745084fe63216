#include "surface/surface_map.hpp"

namespace hsp {

// ---- numbers ----

uint32_t SurfaceMap::saddle_of(LoopElement e) const {
  if (e.is_circle()) return boundary_.arc_count() + e.closed_half_edge().circle();
  const RankedBits &first = surface_.first_half_edges();
  return first.rank(first.has(e.half_edge()) ? e.half_edge() : boundary_.twin(e.half_edge()));
}

uint32_t SurfaceMap::side_of(LoopElement e) const {
  return balls_.given_before(boundary_.ball_of(e), boundary_.neighbour(e)) ? 0 : 1;
}

LoopElement SurfaceMap::element_of(uint32_t saddle, uint32_t side) const {
  const uint32_t arcs = boundary_.arc_count();
  const LoopElement first = saddle < arcs ? LoopElement::arc(surface_.first_half_edges().member(saddle))
                                          : LoopElement::circle({saddle - arcs, 0});
  return side_of(first) == side ? first : across(first);
}

uint32_t SurfaceMap::cusped_circle_of(LoopElement e) const {
  const CuspedCircles &cusped = surface_.cusped_circles();
  if (cusped.count() == 0) return no_id;
  return e.is_circle() ? cusped.of_circle(e.closed_half_edge().circle())
                       : cusped.of_arc(boundary_.ball_of(e), boundary_.neighbour(e));
}

// Its circle must have cusps.
uint32_t SurfaceMap::cusped_saddle_of(LoopElement e) const {
  const bool on_first = boundary_.ball_of(e) < boundary_.neighbour(e);
  return surface_.cusped_circles().saddle_number(cusped_circle_of(e), on_first ? e : across(e));
}

uint32_t SurfaceMap::concave_patch(uint32_t vertex, uint32_t piece) const {
  const CutPatches &cut = surface_.cut_patches();
  if (!cut.is_cut(vertex) || piece == cut.pieces(vertex).first) return first_concave() + vertex;
  return first_extra_piece() + cut.extra_pieces().rank(piece);
}

uint32_t SurfaceMap::patch_of_piece(uint32_t piece) const {
  return concave_patch(surface_.cut_patches().piece(piece).vertex, piece);
}

uint32_t SurfaceMap::face_beside(uint32_t id) const {
  const SurfacePatch record = patch(id);
  if (record.kind == PatchKind::convex) return record.source;
  if (record.kind == PatchKind::concave) return face_at_vertex(boundary_, record.source);
  return boundary_.face_of(element_of(record.source, record.part));
}

uint32_t SurfaceMap::shell_of(uint32_t id) const {
  const SurfacePatch record = patch(id);
  if (record.kind == PatchKind::concave && record.part != no_id) return surface_.shells().of_piece(record.part);
  return surface_.shells().of_face(face_beside(id));
}

uint32_t SurfaceMap::other_shell_of_cusp(uint32_t corner) const {
  const uint32_t cusp = cusp_of(corner);
  if (surface_.chosen().all() || cusp == no_id) return no_id;
  const IdRange half_edges = surface_.cusped_circles().half_edges(cusp / 2);
  for (const uint32_t e : half_edges) {
    const bool is_other = !surface_.chosen().together(boundary_.face_of(e), boundary_.face_of(half_edges.first));
    if (is_other) return shell_at_cusp(cusp, e);
  }
  return no_id;
}

uint32_t SurfaceMap::shell_of_corner(uint32_t corner) const {
  const SurfaceShells &shells = surface_.shells();
  if (corner < first_cusp()) return shells.of_face(boundary_.face_of(boundary_.half_edge_at(corner / 3, corner % 3)));
  if (const uint32_t cusp = cusp_of(corner); cusp != no_id) {
    const IdRange half_edges = surface_.cusped_circles().half_edges(cusp / 2);
    return half_edges.empty() ? no_id : shell_at_cusp(cusp, half_edges.first);
  }
  const CutPatches &cut = surface_.cut_patches();
  return shells.of_piece(cut.piece_of_arc(cut.crease_corners().member(corner - first_crease_corner())));
}

uint32_t SurfaceMap::corner_at(uint32_t vertex, uint32_t ball) const {
  return 3 * vertex + boundary_.vertex(vertex).slot_of(ball);
}

uint32_t SurfaceMap::cusp_at(uint32_t circle, uint32_t ball) const {
  return first_cusp() + 2 * circle + (surface_.cusped_circles().ball(circle, 0) == ball ? 0 : 1);
}

SurfacePatch SurfaceMap::patch(uint32_t id) const {
  const CutPatches &cut = surface_.cut_patches();
  if (id < first_saddle()) return {PatchKind::convex, id, 0};
  if (id < first_concave()) return saddle_patch(id - first_saddle(), 0);
  if (id < first_extra_saddle()) {
    const uint32_t vertex = id - first_concave();
    return {PatchKind::concave, vertex, cut.is_cut(vertex) ? cut.pieces(vertex).first : no_id};
  }
  if (id < first_extra_piece()) {
    return saddle_patch(saddle_of(surface_.cusped_circles().element(id - first_extra_saddle())), 1);
  }
  const uint32_t piece = cut.extra_pieces().member(id - first_extra_piece());
  return {PatchKind::concave, cut.piece(piece).vertex, piece};
}

SurfaceEdge SurfaceMap::edge(uint32_t id) const {
  if (id < first_side()) {
    const LoopElement e = element_of(id / 2, id % 2);
    return {e.is_circle() ? SurfaceEdgeKind::circle_rim : SurfaceEdgeKind::rim, e.code(), 0};
  }
  // End e of an arc is where the half-edge on its ball 1 - e starts.
  if (id < first_extra_side()) {
    const uint32_t k = id - first_side();
    return {SurfaceEdgeKind::side, element_of(k / 2, 1 - k % 2).code(), 0};
  }
  if (id < first_crease()) {
    const uint32_t k = id - first_extra_side();
    const uint32_t arc = saddle_of(surface_.cusped_circles().element(k / 2));
    return {SurfaceEdgeKind::side, element_of(arc, 1 - k % 2).code(), 1};
  }
  return {SurfaceEdgeKind::crease, surface_.cut_patches().creases().member(id - first_crease()), 0};
}

// ---- directed edges ----

uint32_t SurfaceMap::along_rim(LoopElement e) const {
  const uint32_t side = side_of(e);
  return 2 * (2 * saddle_of(e) + side) + (1 - side);
}

uint32_t SurfaceMap::side_of_saddle(uint32_t half_edge, bool at_other) const {
  const LoopElement e = LoopElement::arc(half_edge);
  const uint32_t side = side_of(e);
  const bool is_extra = (side == 1) != at_other && cusped_circle_of(e) != no_id;
  const uint32_t id = is_extra ? first_extra_side() + 2 * cusped_saddle_of(e) : first_side() + 2 * saddle_of(e);
  return 2 * (id + (1 - side)) + side;
}

// In the concave patch a side runs towards the ball of its half-edge.
uint32_t SurfaceMap::edge_of_patch_arc(uint32_t arc) const {
  const CutPatches &cut = surface_.cut_patches();
  const PatchArc &record = cut.arc(arc);
  if (!record.is_side()) {
    const uint32_t first = arc < record.twin ? arc : record.twin;
    return 2 * (first_crease() + cut.creases().rank(first)) + (arc == first ? 0 : 1);
  }
  const uint32_t vertex = cut.vertex_of_arc(arc), on = side_of_patch(boundary_.vertex(vertex), record.slot()).first;
  return twin(side_of_saddle(boundary_.half_edge_at(vertex, on), record.corner < first_cusp()));
}

uint32_t SurfaceMap::patch_arc_of_side(uint32_t half_edge, uint32_t part) const {
  const CutPatches &cut = surface_.cut_patches();
  const uint32_t vertex = boundary_.half_edge(half_edge).vertex;
  const VertexRecord &record = boundary_.vertex(vertex);
  const uint32_t opposite =
      3 - record.slot_of(boundary_.ball_of(half_edge)) - record.slot_of(boundary_.half_edge(half_edge).circle);
  const LoopElement e = LoopElement::arc(half_edge);
  const bool has_parts = cusped_circle_of(e) != no_id;
  const bool at_other = part != side_of(e);
  for (const uint32_t a : cut.arcs_of_vertex(vertex)) {
    const PatchArc &arc = cut.arc(a);
    if (arc.is_side() && arc.slot() == opposite && (!has_parts || (arc.corner < first_cusp()) == at_other)) return a;
  }
  return no_id;
}

// In the concave patch a side runs towards the ball of its half-edge. So the side before it is that of the half-edge on
// the other ball of its circle, and the side after it that of the half-edge on the third ball.
uint32_t SurfaceMap::side_before(uint32_t half_edge) const {
  const uint32_t vertex = boundary_.half_edge(half_edge).vertex;
  return boundary_.half_edge_at(vertex, boundary_.vertex(vertex).slot_of(boundary_.half_edge(half_edge).circle));
}

uint32_t SurfaceMap::side_after(uint32_t half_edge) const {
  const HalfEdge &record = boundary_.half_edge(half_edge);
  const uint32_t third = boundary_.previous_circle(boundary_.ball_of(half_edge), record);
  return boundary_.half_edge_at(record.vertex, boundary_.vertex(record.vertex).slot_of(third));
}

// ---- steps ----

SurfaceMap::Directed SurfaceMap::directed(uint32_t h) const {
  Directed d{edge(h / 2), no_id, false, false};
  const bool forward = h % 2 == 0;
  if (d.edge.kind == SurfaceEdgeKind::crease) {
    d.outward = true;
    d.arc = forward ? d.edge.source : surface_.cut_patches().arc(d.edge.source).twin;
    return d;
  }
  const uint32_t side = side_of(d.edge.element());
  d.outward = forward == (side == 1);
  if (d.edge.kind == SurfaceEdgeKind::side) {
    d.at_other = cusped_circle_of(d.edge.element()) != no_id && d.edge.part != side;
    const uint32_t vertex = boundary_.half_edge(d.edge.source).vertex;
    d.arc = d.outward && surface_.cut_patches().is_cut(vertex) ? patch_arc_of_side(d.edge.source, d.edge.part) : no_id;
  }
  return d;
}

uint32_t SurfaceMap::next(uint32_t h) const {
  const Directed d = directed(h);
  const uint32_t e = d.edge.source;
  if (d.edge.kind == SurfaceEdgeKind::circle_rim) return h;
  if (d.edge.kind == SurfaceEdgeKind::rim) {
    return d.outward ? along_rim(LoopElement::arc(boundary_.half_edge(e).next)) : side_of_saddle(e, false);
  }
  if (d.outward && d.arc != no_id) return edge_of_patch_arc(surface_.cut_patches().arc(d.arc).next);
  if (d.outward) return twin(side_of_saddle(side_after(e), false));
  const bool has_parts = cusped_circle_of(d.edge.element()) != no_id;
  return has_parts && !d.at_other ? side_of_saddle(boundary_.twin(e), true) : twin(along_rim(across(d.edge.element())));
}

uint32_t SurfaceMap::previous(uint32_t h) const {
  const Directed d = directed(h);
  const uint32_t e = d.edge.source;
  if (d.edge.kind == SurfaceEdgeKind::circle_rim) return h;
  if (d.edge.kind == SurfaceEdgeKind::rim) {
    return d.outward ? along_rim(across(LoopElement::arc(side_after(e)))) : side_of_saddle(boundary_.twin(e), true);
  }
  if (d.outward && d.arc != no_id) return edge_of_patch_arc(surface_.cut_patches().previous(d.arc));
  if (d.outward) return twin(side_of_saddle(side_before(e), false));
  return d.at_other ? side_of_saddle(boundary_.twin(e), false) : twin(along_rim(d.edge.element()));
}

uint32_t SurfaceMap::left(uint32_t h) const {
  const Directed d = directed(h);
  if (d.arc != no_id) return patch_of_piece(surface_.cut_patches().piece_of_arc(d.arc));
  const LoopElement e = d.edge.element();
  if (d.outward) {
    return d.edge.kind == SurfaceEdgeKind::side ? first_concave() + boundary_.half_edge(e.half_edge()).vertex
                                                : boundary_.face_of(e);
  }
  const uint32_t part = side_of(e) ^ (d.at_other ? 1U : 0U);
  return part == 1 && cusped_circle_of(e) != no_id ? first_extra_saddle() + cusped_saddle_of(e)
                                                   : first_saddle() + saddle_of(e);
}

uint32_t SurfaceMap::origin(uint32_t h) const {
  const Directed d = directed(h);
  const uint32_t e = d.edge.source;
  if (d.edge.kind == SurfaceEdgeKind::circle_rim) return no_id;
  if (d.edge.kind == SurfaceEdgeKind::crease) return surface_.cut_patches().arc(d.arc).corner;
  const uint32_t own = boundary_.ball_of(e);
  const uint32_t vertex = boundary_.half_edge(e).vertex;
  if (d.edge.kind == SurfaceEdgeKind::rim) return corner_at(d.outward ? vertex : boundary_.end_vertex(e), own);
  const uint32_t other = boundary_.half_edge(e).circle;
  const uint32_t circle = cusped_circle_of(d.edge.element());
  if (circle == no_id) return corner_at(vertex, d.outward ? other : own);
  // With the saddle on its left, a side runs from the own ball to its cusp, and from the other ball's cusp to that
  // ball.
  if (d.at_other) return d.outward ? corner_at(vertex, other) : cusp_at(circle, other);
  return d.outward ? cusp_at(circle, own) : corner_at(vertex, own);
}

uint32_t SurfaceMap::first_edge(uint32_t id) const {
  const SurfacePatch record = patch(id);
  if (record.kind == PatchKind::convex) {
    const IdRange loops = boundary_.loops_of_face(record.source);
    return loops.empty() ? no_id : along_rim(boundary_.loop_start(loops.first));
  }
  if (record.kind != PatchKind::concave) return twin(along_rim(element_of(record.source, record.part)));
  if (record.part == no_id) return twin(side_of_saddle(boundary_.half_edge_at(record.source, 0), false));
  return edge_of_patch_arc(surface_.cut_patches().arcs(record.part).first);
}

uint32_t SurfaceMap::next_loop(uint32_t h) const {
  const Directed d = directed(h);
  if (d.arc != no_id) {
    const CutPatches &cut = surface_.cut_patches();
    const IdRange arcs = cut.arcs(cut.piece_of_arc(d.arc));
    uint32_t last = d.arc;
    while (cut.arc(last).next == last + 1) ++last;
    return edge_of_patch_arc(last + 1 < arcs.last ? last + 1 : arcs.first);
  }
  const LoopElement e = d.edge.element();
  if (d.outward && d.edge.kind != SurfaceEdgeKind::side) {
    const uint32_t loop = boundary_.loop_of(e);
    const IdRange loops = boundary_.loops_of_face(boundary_.face_of_loop(loop));
    return along_rim(boundary_.loop_start(loop + 1 < loops.last ? loop + 1 : loops.first));
  }
  if (!e.is_circle()) return first_edge(left(h));
  return cusped_circle_of(e) != no_id ? h : twin(along_rim(across(e)));
}

}  // namespace hsp
