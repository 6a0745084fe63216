#include "surface/creased_patches.hpp"

#include "core/begin_array.hpp"
#include "surface/patch_corners.hpp"

namespace hsp {

void CreasedPatches::push(const Inputs &in, uint32_t across, uint32_t start, uint32_t end) {
  BorderArc arc{across, start, end, no_id, no_id, no_id, {}, {}};
  if (start != no_id) {
    arc.from = in.creases.point(start);
    arc.to = in.creases.point(end);
  }
  arcs_.push(arc);
}

// A side runs from its second ball to its first. If it has cusps it is two arcs: from the second ball to the cusp
// there, and from the other cusp to the first ball.
void CreasedPatches::add_sides(const Inputs &in, uint32_t v) {
  const VertexRecord &record = in.actual.boundary().vertex(v);
  const uint32_t first_cusp = 3 * in.actual.boundary().vertex_count();
  for (uint32_t slot = 0; slot < 3; ++slot) {
    const SideOfPatch side = side_of_patch(record, slot);
    const uint32_t start = 3 * v + side.second, end = 3 * v + side.first;
    const uint32_t a = record.ball[side.first], b = record.ball[side.second];
    const uint32_t cusp_at_a = in.cusped.cusp(a, b, a);
    if (cusp_at_a == no_id) {
      push(in, PatchArc::side(slot), start, end);
      continue;
    }
    push(in, PatchArc::side(slot), start, first_cusp + (cusp_at_a ^ 1));
    push(in, PatchArc::side(slot), first_cusp + cusp_at_a, end);
  }
}

Span<BorderArc> CreasedPatches::find_border(const Inputs &in, uint32_t v) {
  arcs_ = {};
  in.creases.for_each_of_vertex(v, [&](const Crease &crease) {
    if (arcs_.items().empty()) {
      arcs_ = FixedVector(begin_array<BorderArc>(memory_.part(0, words_of<BorderArc>(memory_.size() / words_of_arc))));
      add_sides(in, v);
    }
    const bool is_low = crease.low == v;
    push(in, is_low ? crease.high : crease.low, is_low ? crease.start : crease.end, is_low ? crease.end : crease.start);
  });
  return arcs_.items();
}

Status CreasedPatches::fill(const Inputs &in, CutPatches &cut, Patience &patience) {
  const uint32_t vertices = in.actual.boundary().vertex_count();
  cut.clear();
  keep_vertices(in, words_of<BorderArc>(memory_.size() / words_of_arc));
  for (uint32_t v = 0; v < vertices; ++v) {
    cut.begin_vertex(v);
    const Span<BorderArc> arcs = find_border(in, v);
    if (!patience.allows(500 + 5000 * uint64_t{arcs.size()})) return Status::stopped;
    if (arcs.empty()) continue;
    const Status status = arcs_.overflowed() ? Status::degenerate : store_patch(in, v, cut);
    if (status != Status::ok) return status;
  }
  cut.finish(vertices);
  if (cut.overflowed() || join_patches(in.actual.boundary(), in.cusped, patience, cut) == 0) return Status::ok;
  return patience.allows(0) ? Status::degenerate : Status::stopped;
}

// Adds up the loops of a piece, one after the other. Each loop but one takes away a whole sphere's 4 pi, so that the
// sum is the solid angle of a part of the patch.
void CreasedPatches::measure_piece(const PatchLoops &loops, uint32_t piece, double &steradians, Vec3 &vector_area,
                                   CreaseSums &sums) const {
  const Span<const BorderArc> arcs = arcs_.items();
  const Span<const ArcFigures> figures = figures_.part(0, arcs.size());
  steradians = 4 * pi;
  for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
    if (arcs[loop].piece != piece || arcs[loop].loop != loop) continue;
    steradians += loops.steradians(loop, figures) - 4 * pi;
    for_each_of_loop(arcs, loop, [&](uint32_t k) {
      vector_area = vector_area + figures[k].vector_area();
      if (!arcs[k].is_side()) sums.add(figures[k]);
    });
  }
  if (!(steradians > 0.0)) steradians = 0.0;
}

void CreasedPatches::keep_vertices(const Inputs &in, uint32_t first) {
  first_kept_ = first;
  in.actual.keep_vertices(memory_.part(first, memory_.size()));
}

Status CreasedPatches::store_patch(const Inputs &in, uint32_t v, CutPatches &cut) {
  Span<BorderArc> arcs = arcs_.items();
  PatchLoops loops(in.actual, v, arcs);
  if (!loops.chain()) return Status::degenerate;
  const uint32_t first_figures = words_of<BorderArc>(arcs.size()), first_kept = arcs.size() * words_of_arc;
  figures_ = begin_array<ArcFigures>(memory_.part(first_figures, first_kept));
  const Span<ArcFigures> figures = figures_.part(0, arcs.size());
  if (first_kept > first_kept_) keep_vertices(in, first_kept);
  for (uint32_t k = 0; k < arcs.size(); ++k) {
    if (!loops.measure(k, figures[k])) return Status::degenerate;
  }
  if (!loops.group(figures)) return Status::degenerate;
  const ConcaveScale scale(in.actual.balls(), in.actual.boundary(), in.grid.position(v));
  double whole = 0.0;
  Vec3 whole_vector{0.0, 0.0, 0.0};
  for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
    if (arcs[piece].piece != piece) continue;
    double steradians = 0.0;
    Vec3 vector_area{0.0, 0.0, 0.0};
    CreaseSums sums;
    measure_piece(loops, piece, steradians, vector_area, sums);
    whole += steradians;
    whole_vector = whole_vector + vector_area;
    const ConcavePatch measured = scale.patch(steradians, vector_area);
    cut.begin_piece(v, measured.area, measured.volume, sums);
    // The loop around the piece before those around holes.
    for (int holes = 0; holes < 2; ++holes) {
      for (uint32_t loop = 0; loop < arcs.size(); ++loop) {
        if (arcs[loop].piece != piece || arcs[loop].loop != loop || loops.is_around_hole(loop, figures) != (holes == 1))
          continue;
        for_each_of_loop(arcs, loop,
                         [&](uint32_t k) { cut.add_arc(arcs[k].across, figures[k].angle, arcs[k].next == loop); });
      }
    }
  }
  cut.set_patch(v, scale.patch(whole, whole_vector));
  return Status::ok;
}

}  // namespace hsp
