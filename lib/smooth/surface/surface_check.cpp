#include "surface/surface_check.hpp"

#include "measure/areas.hpp"
#include "surface/crease_lengths.hpp"
#include "surface/probe_positions.hpp"
#include "surface/surface_areas.hpp"
#include "surface/surface_patches.hpp"
#include "surface/surface_positions.hpp"

namespace hsp {
namespace {

constexpr double tolerance = CreaseLengths::tolerance;

class SurfaceChecker : FirstViolation<SurfaceInvariant> {
 public:
  SurfaceChecker(const BallSet &balls, const Boundary &boundary, const Surface &surface)
      : balls_(balls),
        boundary_(boundary),
        surface_(surface),
        map_(balls, boundary, surface),
        creases_(balls, boundary, surface.cut_patches()),
        length_(static_cast<double>(balls.largest_radius)) {}

  SurfaceViolation check() {
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_steps(h);
    for (uint32_t patch = 0; patch < map_.patch_count() && holds(); ++patch) count_loops(patch);
    if (holds() && visited_ != 2 * map_.edge_count()) fail(SurfaceInvariant::loops, visited_);
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_crease(h);
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_corner(h);
    if (holds()) check_shells();
    for (uint32_t v = 0; v < boundary_.vertex_count() && holds(); ++v) check_areas_at(v);
    for (uint32_t patch = 0; patch < map_.patch_count() && holds(); ++patch) check_patch(patch);
    if (holds()) check_totals();
    return violation_;
  }

 private:
  void check_steps(uint32_t h) {
    const uint32_t next = map_.next(h);
    const bool good = next < 2 * map_.edge_count() && map_.previous(next) == h && map_.left(next) == map_.left(h) &&
                      map_.left(h) < map_.patch_count() && map_.origin(next) == map_.origin(SurfaceMap::twin(h)) &&
                      (map_.origin(h) == no_id ? next == h : map_.origin(h) < map_.corner_count());
    if (!good) fail(SurfaceInvariant::steps, h);
  }

  // Every loop that a patch names is one of its own, and all together are all directed edges.
  void count_loops(uint32_t patch) {
    const uint32_t first = map_.first_edge(patch);
    if (first == no_id) return;
    uint32_t loop = first;
    do {
      uint32_t h = loop;
      do {
        if (map_.left(h) != patch || visited_ >= 2 * map_.edge_count()) {
          fail(SurfaceInvariant::loops, patch);
          return;
        }
        ++visited_;
        h = map_.next(h);
      } while (h != loop);
      loop = map_.next_loop(loop);
    } while (loop != first);
  }

  void check_crease(uint32_t h) {
    const SurfaceEdge edge = map_.edge(h / 2);
    if (edge.kind != SurfaceEdgeKind::crease || h % 2 != 0) return;
    if (!creases_.agree(edge.source)) fail(SurfaceInvariant::creases, h);
  }

  Vec3 from_origin(const Position &position) const {
    return offset_from_origin(balls_, boundary_, position.ball) + position.offset;
  }

  // It lies on the circle of the edge that starts there.
  void check_corner(uint32_t h) {
    const uint32_t corner = map_.origin(h);
    if (corner == no_id) return;
    const ArcPosition arc = position_of_edge(balls_, boundary_, surface_, h / 2);
    const Vec3 arm = from_origin(position_of_corner(balls_, boundary_, surface_, corner)) - from_origin(arc.centre);
    const double above = dot(arm, arc.axis);
    const double beside = std::sqrt(dot(arm, arm)) - arc.radius;
    const double most = tolerance * length_;
    if (!(above <= most && -above <= most && beside <= most && -beside <= most)) fail(SurfaceInvariant::corners, h);
  }

  void check_shells() {
    const uint32_t shells = surface_.shells().count();
    // 2 minus the characteristic, modulo 2^32.
    const Span<uint32_t> lacking = surface_.scratch().part(0, shells);
    for (uint32_t &e : lacking) e = 2;
    count_euler(balls_, boundary_, surface_,
                [lacking](uint32_t shell, int32_t n) { lacking[shell] -= static_cast<uint32_t>(n); });
    for (uint32_t s = 0; s < shells && holds(); ++s) {
      if (lacking[s] >> 31 != 0 || lacking[s] % 2 != 0) fail(SurfaceInvariant::shells, s);
    }
  }

  // The rest of a concave patch are its pieces: their sums are those of the same terms, a few for each of their
  // arcs, in another order, so they differ by rounding alone.
  void check_areas_at(uint32_t v) {
    const CutPatches &cut = surface_.cut_patches();
    if (!cut.is_cut(v)) return;
    double area = 0.0;
    double volume = 0.0;
    for (const uint32_t piece : cut.pieces(v)) {
      area += cut.piece(piece).area;
      volume += cut.piece(piece).volume;
    }
    const ConcavePatch &patch = cut.patch(v);
    const uint32_t ball = boundary_.vertex(v).ball[0];
    Rounding most;
    most.add(cut.arcs_of_vertex(v).size(), balls_.r[ball], offset_from_origin(balls_, boundary_, ball));
    if (!most.allows(area - patch.area, volume - patch.volume)) fail(SurfaceInvariant::areas, v);
  }

  // By how much sums of areas, and of terms of the volume, may differ where their terms are the same, but in another
  // order: m additions of terms that are at most t round by m^2 t u. A face or patch with k arcs and loops, on a sphere
  // of radius at most R, is a sum of some 4 k terms of at most 7 pi R^2, which are rounded a few times each. Beyond
  // them come the 32 additions of a TreeSum. Terms of the volume are larger by as much as the sphere reaches away from
  // the origin.
  struct Rounding {
    double area = 0.0, volume = 0.0;

    void add(uint32_t k, double radius, const Vec3 &arm) {
      const double terms = 4.0 * (k + 1);
      const double most = (terms + 32) * terms * 64 * pi * radius * radius * unit_roundoff;
      area += most;
      volume += most * (2 * radius + std::sqrt(dot(arm, arm)));
    }
    bool allows(double area_off, double volume_off) const {
      return area_off <= area && -area_off <= area && volume_off <= volume && -volume_off <= volume;
    }
  };

  // Patches of chosen shells are what surface_areas.hpp sums ball by ball.
  void check_totals() {
    TreeSum area;
    TreeSum volume;
    Rounding most;
    for (uint32_t i = 0; i < boundary_.ball_count(); ++i) {
      const SurfaceMeasure measure = measure_surface_of_ball(balls_, boundary_, surface_, i);
      area.add(measure.area());
      volume.add(measure.volume);
      most.add(boundary_.half_edges(i).size() + boundary_.loops(i).size(), balls_.r[i],
               offset_from_origin(balls_, boundary_, i));
    }
    for (uint32_t id = 0; id < map_.patch_count(); ++id) {
      if (map_.shell_of(id) == no_id || !map_.is_chosen(id)) continue;
      const PatchMeasure measure = measure_patch(balls_, boundary_, surface_, id);
      area.add(-measure.area);
      volume.add(-measure.volume);
    }
    if (!most.allows(area.total(), volume.total())) fail(SurfaceInvariant::totals, no_id);
  }

  // Area and volume of a patch agree with the vector area that the circles around it give: 1/2 of the integral of
  // x x dx along them (Stokes). The outward normal of a sphere is along the radius, or against it.
  void check_patch(uint32_t id) {
    const SurfacePatch record = map_.patch(id);
    const PatchMeasure measure = measure_patch(balls_, boundary_, surface_, id);
    if (!(measure.area >= 0.0)) fail(SurfaceInvariant::areas, id);
    if (record.kind != PatchKind::convex && record.kind != PatchKind::concave) return;
    Position centre;
    double radius;
    const double p = static_cast<double>(balls_.probe_steps);
    if (record.kind == PatchKind::convex) {
      centre = {boundary_.face(record.source).ball, {0.0, 0.0, 0.0}};
      radius = balls_.r[centre.ball] - p;
    } else {
      centre = position_of_probe(balls_, boundary_, record.source);
      radius = -p;
    }
    const Vec3 arm = from_origin(centre);
    Vec3 vector_area{0.0, 0.0, 0.0};
    double uncertainty = 0.0;
    map_.for_each_loop(id, [&](uint32_t loop) {
      map_.for_each_edge(loop, [&](uint32_t h) {
        vector_area = vector_area + vector_area_along(h, arm);
        const SurfaceEdge edge = map_.edge(h / 2);
        if (edge.kind == SurfaceEdgeKind::crease) uncertainty += creases_.uncertainty(edge.source);
      });
    });
    const double off = 3 * measure.volume - radius * measure.area - dot(arm, vector_area);
    const double most = (tolerance * length_ * length_ + p * uncertainty) * (length_ + std::sqrt(dot(arm, arm)));
    if (!(off <= most && -off <= most)) fail(SurfaceInvariant::closure, id);
  }

  Vec3 vector_area_along(uint32_t h, const Vec3 &origin) const {
    const ArcPosition arc = position_of_edge(balls_, boundary_, surface_, h / 2);
    const uint32_t first = map_.origin(h & ~1U);
    Vec3 chord{0.0, 0.0, 0.0};
    if (first != no_id) {
      chord = from_origin(position_of_corner(balls_, boundary_, surface_, map_.origin(h | 1U))) -
              from_origin(position_of_corner(balls_, boundary_, surface_, first));
    }
    const Vec3 forward = combine(0.5, cross(from_origin(arc.centre) - origin, chord),
                                 0.5 * arc.radius * arc.radius * arc.angle, arc.axis);
    return h % 2 == 0 ? forward : -forward;
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  const Surface &surface_;
  const SurfaceMap map_;
  const CreaseLengths creases_;
  const double length_;
  uint32_t visited_ = 0;
};

}  // namespace

SurfaceViolation check_surface(const BallSet &balls, const Boundary &boundary, const Surface &surface) {
  return SurfaceChecker(balls, boundary, surface).check();
}

}  // namespace hsp
