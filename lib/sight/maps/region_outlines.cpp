#include "maps/region_outlines.hpp"

#include "maps/loop_runs.hpp"
#include "maps/stick_outlines.hpp"

namespace hsp {
namespace {

const StickRegions &as_regions(const void *source) {
  return *static_cast<const StickRegions *>(source);
}

uint32_t ball_of_region(const void *source, uint32_t path) {
  const StickScene &scene = as_regions(source).scene;
  const uint32_t body = as_regions(source).owner_of(path);
  return scene.is_ball(body) ? body : scene.stick_at(body).owner[scene.part_of(body)];
}

bool is_stick_region(const void *source, uint32_t path) {
  return !as_regions(source).scene.is_ball(as_regions(source).owner_of(path));
}

// Calls visit(first half-edge) for each loop.
template <class Visit>
void visit_loops(const StickRegions &regions, uint32_t path, Visit visit) {
  const uint32_t first = regions.first_loop[path];
  const uint32_t owner = regions.owner_of(path);
  for (uint32_t l = first; l < regions.loops.size() && regions.loops[l].owner == owner; ++l) {
    visit(regions.loops[l].first_half_edge);
  }
}

void visit_region(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  const StickRegions &regions = as_regions(source);
  const auto next = [&regions](uint32_t h) { return regions.half_edges[h].next; };
  visit_loops(regions, path, [&](uint32_t first) {
    visit_loop(first, next, [&](uint32_t h, bool begins, bool closes) { visitor(arc_of(regions, h), begins, closes); });
  });
}

void visit_lines_of_region(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  const StickRegions &regions = as_regions(source);
  const auto next = [&regions](uint32_t h) { return regions.half_edges[h].next; };
  visit_loops(regions, path, [&](uint32_t first) {
    visit_own_runs(first, next,
                   [&](uint32_t h, bool begins, bool closes) { visitor(arc_of(regions, h), begins, closes); });
  });
}

constexpr PaintedPaths::Functions of_regions{ball_of_region, visit_region, visit_lines_of_region, is_stick_region};

}  // namespace

// The parameter of all but silhouettes counts from the steepest direction, which appears shortened; that of a projected
// ellipse from the end of its major axis, a quarter turn ahead.
ProjectedArc arc_of(const StickRegions &regions, uint32_t half_edge) {
  const MapEdge &edge = regions.edges[half_edge / 2];
  const MapVertex &v = regions.vertices[regions.origin(half_edge)];
  const MapVertex &w = regions.vertices[regions.origin(half_edge ^ 1U)];
  const double start[2] = {v.x, v.y};
  const double end[2] = {w.x, w.y};
  if (regions.scene.is_straight(edge.ball, edge.nearer)) return line_between(start, end, no_id);
  const RoundCurve curve = regions.scene.round_curve(edge.ball, edge.nearer);
  const uint32_t from_end = half_edge % 2;
  ProjectedArc arc{{{curve.middle.x, curve.middle.y}, {curve.first.x, curve.first.y}, {curve.second.x, curve.second.y}},
                   from_end == 0 ? edge.from : edge.to,
                   from_end == 0 ? edge.to : edge.from,
                   {start[0], start[1]},
                   {end[0], end[1]},
                   no_id};
  if (edge.is_silhouette()) return arc;
  const StickScene &scene = regions.scene;
  arc.other_ball = scene.is_ball(edge.ball) ? edge.ball : scene.stick_at(edge.ball).owner[scene.part_of(edge.ball)];
  arc.ellipse = {{curve.middle.x, curve.middle.y}, {curve.second.x, curve.second.y}, {-curve.first.x, -curve.first.y}};
  arc.from -= pi / 2;
  arc.to -= pi / 2;
  return arc;
}

PaintedPaths paths_of(const StickRegions &regions) {
  return {regions.frame, regions.paths, &regions, of_regions};
}

}  // namespace hsp
