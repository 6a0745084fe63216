#include "core/elementary.hpp"
#include "core/extremes.hpp"
#include "hsp_view.hpp"
#include "picture/painted_paths.hpp"
#include "view/projected_arcs.hpp"
#include "view_options.hpp"

using namespace hsp::capi;

namespace {

double length_of(const double v[2]) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1]);
}

hsp_view_arc to_c(const hsp::BallSet &balls, const hsp::ProjectedArc &arc, uint32_t piece) {
  const ViewLengths length{balls.lattice};
  hsp_view_arc out{};
  length.point(arc.ellipse.centre, out.centre);
  out.semi_axis[0] = length(length_of(arc.ellipse.major));
  // Of an ellipse that is nearly a circle roundings might make the lesser one the larger one.
  out.semi_axis[1] = hsp::smaller_of(length(length_of(arc.ellipse.minor)), out.semi_axis[0]);
  out.rotation = hsp::arc_tangent(arc.ellipse.major[1], arc.ellipse.major[0]);
  out.from = arc.from;
  out.to = arc.to;
  length.point(arc.start, out.start);
  length.point(arc.end, out.end);
  out.piece = piece;
  out.other_ball = arc.other_ball == hsp::no_id ? HSP_NONE : balls.caller[arc.other_ball];
  return out;
}

}  // namespace

int32_t hsp_view_get_info(const hsp_view *view, hsp_view_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(view, info == nullptr); status != HSP_OK) return status;
  const hsp::BallSet &balls = view->balls();
  const hsp::View &structure = view->structure();
  const ViewLengths length{balls.lattice};
  *info = {};
  put_frame(length, structure.frame, *info);
  const hsp::ViewBox box = hsp::box_of(balls, hsp::paths_of(structure));
  length.point(box.low, info->low);
  length.point(box.high, info->high);
  info->depth_low = length(box.depth_low);
  info->depth_high = length(box.depth_high);
  info->pieces = structure.pieces.size();
  info->loops = structure.loops.size();
  info->arcs = structure.arcs.size();
  info->kind =
      view->builder.kind() == hsp::PieceKind::outside_all ? HSP_PIECES_OUTSIDE_ALL : HSP_PIECES_OUTSIDE_FARTHER;
  return HSP_OK;
}

// lib keeps loops and arcs in the grid order of their balls; here they are written in the order of the pieces.
int32_t hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(view, out, capacity, needed,
                                       [](const hsp_view &handle) { return handle.structure().pieces.size(); });
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = view->balls();
  const hsp::View &structure = view->structure();
  const ViewLengths length{balls.lattice};
  uint32_t loops = 0;
  uint32_t arcs = 0;
  for (uint32_t p = 0; p < structure.pieces.size(); ++p) {
    const hsp::PieceRecord &piece = structure.pieces[p];
    const hsp::Vec3 centre = structure.frame.centre_of(balls, piece.ball);
    out[p] = {{length(centre.x), length(centre.y)},
              length(centre.z),
              length(balls.r[piece.ball]),
              balls.caller[piece.ball],
              loops,
              piece.loops,
              arcs,
              piece.arcs,
              0};
    loops += piece.loops;
    arcs += piece.arcs;
  }
  return HSP_OK;
}

int32_t hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(view, out, capacity, needed,
                                       [](const hsp_view &handle) { return handle.structure().loops.size(); });
  if (status != HSP_OK) return status;
  const hsp::View &structure = view->structure();
  uint32_t written = 0;
  uint32_t arcs = 0;
  for (uint32_t p = 0; p < structure.pieces.size(); ++p) {
    for (uint32_t loop = structure.pieces[p].first_loop; loop < structure.end_of_loops(p); ++loop) {
      const uint32_t length = structure.end_of_arcs(loop) - structure.loops[loop];
      out[written++] = {p, arcs, length, 0};
      arcs += length;
    }
  }
  return HSP_OK;
}

int32_t hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(view, out, capacity, needed, [](const hsp_view &handle) { return handle.structure().arcs.size(); });
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = view->balls();
  const hsp::View &structure = view->structure();
  uint32_t written = 0;
  for (uint32_t p = 0; p < structure.pieces.size(); ++p) {
    hsp::visit_arcs(balls, structure, p,
                    [&](const hsp::ProjectedArc &arc, bool, bool) { out[written++] = to_c(balls, arc, p); });
  }
  return HSP_OK;
}
