#include "hsp_surface.hpp"
#include "surface/surface_check.hpp"
#include "surface/surface_patches.hpp"
#include "surface/surface_positions.hpp"

using namespace hsp::capi;

namespace {

// The structures behind a surface with results, and corner numbers of the interface.
struct SurfaceResults {
  const hsp::BallSet &balls;
  const hsp::Boundary &boundary;
  const hsp::Surface &surface;
  const hsp::SurfaceMap map;

  explicit SurfaceResults(const hsp_surface &handle)
      : balls(handle.boundary->balls()),
        boundary(handle.boundary->structure()),
        surface(handle.structure()),
        map(balls, boundary, surface) {}

  uint32_t caller(uint32_t ball) const { return balls.caller[ball]; }
  // In the interface, corners at balls and cusps are numbered by the caller's order of their balls; in lib/ by the
  // grid's order. corner_from_c is the inverse of corner_to_c.
  uint32_t corner_to_c(uint32_t corner) const {
    if (corner < map.first_cusp()) {
      const hsp::VertexRecord &vertex = boundary.vertex(corner / 3);
      uint32_t place = 0;
      for (uint32_t t = 0; t < 3; ++t) {
        place += balls.given_before(vertex.ball[t], vertex.ball[corner % 3]) ? 1U : 0U;
      }
      return corner - corner % 3 + place;
    }
    return corner < map.first_crease_corner() ? cusp(corner) : corner;
  }
  uint32_t corner_from_c(uint32_t corner) const {
    if (corner < map.first_cusp()) {
      for (uint32_t t = corner - corner % 3;; ++t) {
        if (corner_to_c(t) == corner) return t;
      }
    }
    return corner < map.first_crease_corner() ? cusp(corner) : corner;
  }

 private:
  uint32_t cusp(uint32_t corner) const {
    const uint32_t k = (corner - map.first_cusp()) / 2;
    const hsp::CuspedCircles &cusped = surface.cusped_circles();
    const bool in_order = balls.given_before(cusped.ball(k, 0), cusped.ball(k, 1));
    return in_order ? corner : map.first_cusp() + ((corner - map.first_cusp()) ^ 1U);
  }
};

constexpr uint32_t number_of(hsp::PatchKind kind) {
  return static_cast<uint32_t>(kind);
}
constexpr uint32_t number_of(hsp::SurfaceEdgeKind kind) {
  return static_cast<uint32_t>(kind);
}
static_assert(number_of(hsp::PatchKind::convex) == HSP_PATCH_CONVEX &&
              number_of(hsp::PatchKind::saddle) == HSP_PATCH_SADDLE);
static_assert(number_of(hsp::PatchKind::circle_saddle) == HSP_PATCH_CIRCLE_SADDLE &&
              number_of(hsp::PatchKind::concave) == HSP_PATCH_CONCAVE);
static_assert(number_of(hsp::SurfaceEdgeKind::rim) == HSP_SURFACE_RIM &&
              number_of(hsp::SurfaceEdgeKind::circle_rim) == HSP_SURFACE_CIRCLE_RIM);
static_assert(number_of(hsp::SurfaceEdgeKind::side) == HSP_SURFACE_SIDE &&
              number_of(hsp::SurfaceEdgeKind::crease) == HSP_SURFACE_CREASE);

hsp_surface_patch patch_record(const SurfaceResults &results, uint32_t id) {
  const hsp::SurfacePatch patch = results.map.patch(id);
  hsp_surface_patch record{};
  record.area = results.balls.lattice.area(hsp::measure_patch(results.map, id).area);
  record.kind = number_of(patch.kind);
  const bool is_circle = patch.kind == hsp::PatchKind::circle_saddle;
  record.source = is_circle ? patch.source - results.boundary.arc_count() : patch.source;
  record.part = patch.part;
  if (patch.kind == hsp::PatchKind::concave) {
    record.part = patch.part == HSP_NONE ? 0 : patch.part - results.surface.cut_patches().pieces(patch.source).first;
  }
  record.shell = results.map.shell_of(id);
  record.h = results.map.first_edge(id);
  results.map.for_each_loop(id, [&](uint32_t loop) {
    ++record.loops;
    results.map.for_each_edge(loop, [&](uint32_t) { ++record.edges; });
  });
  return record;
}

hsp_surface_edge edge_record(const SurfaceResults &results, uint32_t id) {
  const hsp::SurfaceEdge edge = results.map.edge(id);
  const hsp::ArcPosition position = hsp::position_of_edge(results.map, id);
  hsp_surface_edge record{};
  hsp::to_coordinates(results.balls, position.centre, record.centre);
  to_array(position.axis, record.axis);
  record.radius = results.balls.lattice.length(position.radius);
  record.angle = position.angle;
  for (uint32_t side = 0; side < 2; ++side) {
    const uint32_t h = 2 * id + side;
    const uint32_t corner = results.map.origin(h);
    record.patch[side] = results.map.left(h);
    record.corner[side] = corner == HSP_NONE ? HSP_NONE : results.corner_to_c(corner);
    record.next[side] = results.map.next(h);
    record.previous[side] = results.map.previous(h);
  }
  record.kind = number_of(edge.kind);
  record.source = edge.kind == hsp::SurfaceEdgeKind::crease ? HSP_NONE
                  : edge.element().is_circle()              ? edge.element().closed_half_edge().circle()
                                                            : results.map.saddle_of(edge.element());
  return record;
}

hsp_surface_corner corner_record(const SurfaceResults &results, uint32_t id) {
  const uint32_t corner = results.corner_from_c(id);
  hsp_surface_corner record{};
  hsp::to_coordinates(results.balls, hsp::position_of_corner(results.map, corner), record.xyz);
  for (uint32_t &ball : record.ball) ball = HSP_NONE;
  for (uint32_t &vertex : record.vertex) vertex = HSP_NONE;
  record.shell = results.map.shell_of_corner(corner);
  if (corner < results.map.first_cusp()) {
    record.kind = HSP_CORNER_BALL;
    record.ball[0] = results.caller(results.boundary.vertex(corner / 3).ball[corner % 3]);
    record.vertex[0] = corner / 3;
  } else if (corner < results.map.first_crease_corner()) {
    record.kind = HSP_CORNER_CUSP;
    const uint32_t cusp = corner - results.map.first_cusp();
    const hsp::CuspedCircles &cusped = results.surface.cusped_circles();
    record.ball[0] = results.caller(cusped.ball(cusp / 2, cusp % 2));
    record.ball[1] = results.caller(cusped.ball(cusp / 2, 1 - cusp % 2));
  } else {
    record.kind = HSP_CORNER_CREASE;
    const hsp::CutPatches &cut = results.surface.cut_patches();
    const uint32_t arc = cut.crease_corners().member(corner - results.map.first_crease_corner());
    record.vertex[0] = cut.vertex_of_arc(arc);
    record.vertex[1] = cut.arc(arc).across;
    record.vertex[2] = cut.arc(cut.previous(arc)).across;
  }
  return record;
}

// Writes records first .. first + count - 1 of the number(map) records that there are.
template <class Record, class Number, class Make>
int32_t get_range(const hsp_surface *surface, uint32_t first, uint32_t count, Record *out, Number number, Make make) {
  const auto all = [](const hsp_surface &) { return HSP_NONE; };
  const int32_t status = check_range(surface, first, count, out, all);
  if (status != HSP_OK && status != HSP_E_ID) return status;
  const SurfaceResults results(*surface);
  const uint32_t there = number(results.map);
  if (first > there || count > there - first) return HSP_E_ID;
  for (uint32_t k = 0; k < count; ++k) out[k] = make(results, first + k);
  return HSP_OK;
}

// step(results), or HSP_NONE if there are no results or no directed edge h.
template <class Step>
uint32_t take_step(const hsp_surface *surface, uint32_t h, Step step) {
  if (!is_live(surface) || !surface->has_results()) return HSP_NONE;
  const SurfaceResults results(*surface);
  return h / 2 < results.map.edge_count() ? step(results) : HSP_NONE;
}

}  // namespace

int32_t hsp_surface_get_part_counts(const hsp_surface *surface, hsp_surface_part_counts *counts) {
  if (const int32_t status = check_results(surface, counts == nullptr); status != HSP_OK) return status;
  const hsp::Surface &structure = surface->structure();
  const SurfaceResults results(*surface);
  *counts = {results.map.patch_count(),
             results.map.edge_count(),
             results.map.corner_count(),
             structure.shells().count(),
             2 * structure.cusped_circles().count(),
             structure.cut_patches().crease_corners().size(),
             structure.cut_patches().creases().size(),
             0};
  return HSP_OK;
}

uint32_t hsp_surface_next(const hsp_surface *surface, uint32_t h) {
  return take_step(surface, h, [h](const SurfaceResults &results) { return results.map.next(h); });
}

uint32_t hsp_surface_previous(const hsp_surface *surface, uint32_t h) {
  return take_step(surface, h, [h](const SurfaceResults &results) { return results.map.previous(h); });
}

uint32_t hsp_surface_next_loop(const hsp_surface *surface, uint32_t h) {
  return take_step(surface, h, [h](const SurfaceResults &results) { return results.map.next_loop(h); });
}

uint32_t hsp_surface_origin(const hsp_surface *surface, uint32_t h) {
  return take_step(surface, h, [h](const SurfaceResults &results) {
    const uint32_t corner = results.map.origin(h);
    return corner == HSP_NONE ? HSP_NONE : results.corner_to_c(corner);
  });
}

uint32_t hsp_surface_left(const hsp_surface *surface, uint32_t h) {
  return take_step(surface, h, [h](const SurfaceResults &results) { return results.map.left(h); });
}

int32_t hsp_surface_get_patches(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_patch *out) {
  LibraryArithmetic arithmetic;
  const auto patches = [](const hsp::SurfaceMap &map) { return map.patch_count(); };
  return get_range(surface, first, count, out, patches, patch_record);
}

int32_t hsp_surface_get_edges(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_edge *out) {
  LibraryArithmetic arithmetic;
  const auto edges = [](const hsp::SurfaceMap &map) { return map.edge_count(); };
  return get_range(surface, first, count, out, edges, edge_record);
}

int32_t hsp_surface_get_corners(const hsp_surface *surface, uint32_t first, uint32_t count, hsp_surface_corner *out) {
  LibraryArithmetic arithmetic;
  const auto corners = [](const hsp::SurfaceMap &map) { return map.corner_count(); };
  return get_range(surface, first, count, out, corners, corner_record);
}

int32_t hsp_surface_get_shells(const hsp_surface *surface, hsp_surface_shell *out, uint32_t capacity,
                               uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(surface, out == nullptr && capacity > 0); status != HSP_OK) return status;
  const uint32_t shells = surface->structure().shells().count();
  if (const int32_t status = check_output(capacity, shells, needed); status != HSP_OK) return status;
  const SurfaceResults results(*surface);
  for (uint32_t s = 0; s < shells; ++s) out[s] = {};
  for (uint32_t id = 0; id < results.map.patch_count(); ++id) {
    const uint32_t shell = results.map.shell_of(id);
    if (shell == HSP_NONE) continue;
    const hsp::BallMeasure measure = hsp::measure_patch(results.map, id);
    out[shell].area += measure.area;
    out[shell].volume += measure.volume;
    ++out[shell].patches;
    out[shell].chosen = results.map.is_chosen(id) ? 1 : 0;
  }
  hsp::count_euler(results.map, [out](uint32_t shell, int32_t n) { out[shell].euler += n; });
  for (uint32_t s = 0; s < shells; ++s) {
    out[s].area = results.balls.lattice.area(out[s].area);
    out[s].volume = results.balls.lattice.volume(out[s].volume);
    out[s].genus = static_cast<uint32_t>(1 - out[s].euler / 2);
  }
  return HSP_OK;
}

int32_t hsp_surface_check(hsp_surface *surface, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(surface, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  const SurfaceResults results(*surface);
  return report(hsp::check_surface(results.map), invariant, id);
}
