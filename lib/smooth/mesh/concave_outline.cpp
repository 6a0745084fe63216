// The borders of the concave patch of one vertex, or of the pieces that other probes leave of it. Points are given to
// SphericalPatch as the surface's outward normals there, which point to the probe's centre.
#include "mesh/surface_outline.hpp"

namespace hsp {
namespace {

class ConcaveOutline {
 public:
  ConcaveOutline(const SurfaceCurves &curves, uint32_t vertex)
      : curves_(curves), vertex_(vertex), sphere_(curves.balls(), curves.boundary(), vertex) {}

  void add_border(SphericalPatch &patch) const {
    keep_off_sides(patch);
    keep_off_probes(patch);
    const SurfaceMap &map = curves_.map();
    const IdRange pieces = curves_.surface().cut_patches().pieces(vertex_);
    const uint32_t count = pieces.empty() ? 1 : pieces.size();
    for (uint32_t face = 0; face < count; ++face) {
      map.for_each_loop(map.concave_patch(vertex_, pieces.first + face), [&](uint32_t loop) {
        patch.begin_loop(face);
        add_loop(loop, patch);
      });
    }
  }

 private:
  void add_loop(uint32_t loop, SphericalPatch &patch) const {
    const SurfaceMap &map = curves_.map();
    map.for_each_edge(loop, [&](uint32_t h) {
      const uint32_t c = h / 2;
      const uint32_t corner = map.origin(h);
      if (corner != no_id) add_corner(corner, c, patch);
      if (corner != no_id && curves_.curve(c).segments == 1) return;
      if (map.edge(c).kind == SurfaceEdgeKind::crease) {
        add_crease(h, corner == no_id, patch);
      } else {
        add_side(h, patch);
      }
    });
  }

  // A cusp is a corner of the patches of all probes at vertices of its circle, too; so any_patch.
  void add_corner(uint32_t corner, uint32_t curve, SphericalPatch &patch) const {
    BorderSample start{{}, corner, curve, {no_id, no_id}};
    if (corner < curves_.map().first_cusp()) {
      const uint32_t ball = curves_.boundary().vertex(vertex_).ball[corner % 3];
      start.direction = direction_from(curves_.balls(), ball, sphere_.centre());
    } else {
      start.direction = sphere_.way_from(position_of_corner(curves_.map(), corner));
      start.other_patch[0] = BorderSample::any_patch;
    }
    patch.add(start);
  }

  // The points of a crease belong to the patch of the probe across, too.
  void add_crease(uint32_t h, bool is_closed, SphericalPatch &patch) const {
    const CutPatches &cut = curves_.surface().cut_patches();
    const SurfaceMap &map = curves_.map();
    const uint32_t c = h / 2;
    const MeshCurve &curve = curves_.curve(c);
    const bool forwards = h % 2 == 0;
    const uint32_t arc = map.edge(c).source;
    const uint32_t across = cut.arc(forwards ? arc : cut.arc(arc).twin).across;
    const CirclePoints points = points_of_crease(map, c, map.origin(2 * c));
    for_each_point(curve, is_closed, forwards, [&](uint32_t k, uint32_t vertex) {
      patch.add({sphere_.way_from(points.at(k, curve.segments)), vertex, c, {across, no_id}});
    });
  }

  void add_side(uint32_t h, SphericalPatch &patch) const {
    const uint32_t c = h / 2;
    const MeshCurve &curve = curves_.curve(c);
    const SurfaceEdge edge = curves_.map().edge(c);
    const SaddleBand band = curves_.band_of(edge.element());
    const Vec3 outward = band.outward_at_end(1 - curves_.map().side_of(edge.element()));
    for_each_point(curve, false, h % 2 == 0, [&](uint32_t k, uint32_t vertex) {
      patch.add({band.at(outward, edge.part, k, curve.segments).normal, vertex, c, {no_id, no_id}});
    });
  }

  // Outward normals lie within the cone of the vectors from the three balls to the probe's centre.
  void keep_off_sides(SphericalPatch &patch) const {
    const uint32_t *const ball = curves_.boundary().vertex(vertex_).ball;
    Vec3 from[3];
    for (uint32_t t = 0; t < 3; ++t) from[t] = direction_from(curves_.balls(), ball[t], sphere_.centre());
    for (uint32_t t = 0; t < 3; ++t) {
      const Vec3 across = cross(from[(t + 1) % 3], from[(t + 2) % 3]);
      const double along = dot(across, from[t]);
      const double length = std::sqrt(dot(across, across));
      if (along != 0.0 && length > 0.0) patch.keep_off((along > 0.0 ? -1.0 : 1.0) / length * across, 0.0);
    }
  }

  void keep_off_probes(SphericalPatch &patch) const {
    const CutPatches &cut = curves_.surface().cut_patches();
    for (const uint32_t a : cut.arcs_of_vertex(vertex_)) {
      if (cut.arc(a).is_side()) continue;
      const ProbeSphere other(curves_.balls(), curves_.boundary(), cut.arc(a).across);
      const Vec3 away = -other.way_from(sphere_.centre());
      const double distance = std::sqrt(dot(away, away));
      if (distance > coincident_distance * curves_.probe())
        patch.keep_off(1.0 / distance * away, distance / (2 * curves_.probe()));
    }
  }

  const SurfaceCurves &curves_;
  const uint32_t vertex_;
  const ProbeSphere sphere_;
};

}  // namespace

void SurfaceOutline::add_concave_border(uint32_t vertex, SphericalPatch &patch) const {
  ConcaveOutline(*this, vertex).add_border(patch);
}

}  // namespace hsp
