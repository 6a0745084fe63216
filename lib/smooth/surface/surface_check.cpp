#include "surface/surface_check.hpp"

#include "measure/areas.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/surface_areas.hpp"
#include "surface/surface_patches.hpp"
#include "surface/surface_positions.hpp"

namespace hsp {
namespace {

// For lengths, in units of the largest radius.
constexpr double tolerance = 1e-6;

class SurfaceChecker : FirstViolation<SurfaceInvariant> {
 public:
  explicit SurfaceChecker(const SurfaceMap &map)
      : map_(map),
        balls_(map.balls()),
        boundary_(map.boundary()),
        surface_(map.surface()),
        length_(static_cast<double>(balls_.largest_radius)) {}

  SurfaceViolation check() {
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_steps(h);
    for (uint32_t patch = 0; patch < map_.patch_count() && holds(); ++patch) count_loops(patch);
    if (holds() && visited_ != 2 * map_.edge_count()) fail(SurfaceInvariant::loops, no_id);
    if (holds()) check_rings();
    for (uint32_t e = 0; e < map_.edge_count() && holds(); ++e) check_crease(e);
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

  // Every loop that a patch names has this patch on its left, and all loops together have every directed edge once.
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

  bool is_crease(uint32_t h) const { return map_.edge(h / 2).kind == SurfaceEdgeKind::crease; }

  // Around each corner edges and patches follow each other in one ring; around a cusp in one ring for each part of the
  // boundary. In a concave patch two sides meet at a corner of the boundary, two creases where three of them do, and a
  // side and a crease in a cusp: so there is one crease for each covered gap, between the sides at its ends.
  void check_rings() {
    const CutPatches &cut = surface_.cut_patches();
    const uint32_t cusps = map_.first_cusp(), creases = map_.first_crease_corner();
    uint32_t expected = cusps + 2 * surface_.cusped_circles().first_whole() + map_.corner_count() - creases;
    for (uint32_t corner = cusps; corner < creases; ++corner) {
      expected += map_.other_shell_of_cusp(corner) != no_id ? 1U : 0U;
    }
    for (uint32_t k = 0; creases + k < map_.corner_count() && holds(); ++k) {
      if (cut.arc(cut.crease_corners().member(k)).corner != creases + k) fail(SurfaceInvariant::rings, no_id);
    }
    uint32_t rings = 0;
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) {
      const uint32_t corner = map_.origin(h);
      if (corner == no_id) continue;
      const bool is_own = corner < cusps, is_cusp = !is_own && corner < creases;
      const uint32_t before = map_.previous(h);
      const bool fits =
          map_.patch(map_.left(h)).kind != PatchKind::concave ||
          (is_cusp ? is_crease(h) != is_crease(before) : is_crease(h) != is_own && is_crease(before) != is_own);
      // A ring is counted at its first edge.
      uint32_t length = 1;
      uint32_t e = SurfaceMap::twin(before);
      for (; e > h; e = SurfaceMap::twin(map_.previous(e))) ++length;
      if (!fits || (e == h && !is_cusp && length != (is_own ? 4U : 3U))) fail(SurfaceInvariant::rings, h);
      rings += e == h ? 1U : 0U;
    }
    if (holds() && rings != expected) fail(SurfaceInvariant::rings, no_id);
  }

  // A crease is an arc of two patches and measured in each. Creases of the same two patches do not overlap on their
  // circle.
  void check_crease(uint32_t id) {
    if (!is_crease(2 * id)) return;
    const CutPatches &cut = surface_.cut_patches();
    const uint32_t a = map_.edge(id).source;
    const PatchArc &arc = cut.arc(a);
    const ArcPosition at = position_of_edge(map_, id);
    const double off = arc.angle - cut.arc(arc.twin).angle, most = tolerance * length_ / at.radius;
    bool good = off <= most && -off <= most;
    for (const uint32_t b : cut.arcs_of_vertex(cut.vertex_of_arc(a))) {
      const PatchArc &other = cut.arc(b);
      if (b == a || other.across != arc.across || !good) continue;
      good = arc.corner != no_id && other.corner != no_id;
      if (!good) continue;
      // From 0 to a whole turn; corners of nearly one place may be either.
      const double turn = turn_about(at.axis, arm_to(arc.corner, at), arm_to(other.corner, at));
      const auto is_apart = [&](double start) {
        return start >= arc.angle - most && start + other.angle <= 2 * pi + most;
      };
      good = is_apart(turn) || is_apart(turn - 2 * pi) || is_apart(turn + 2 * pi);
    }
    if (!good) fail(SurfaceInvariant::creases, 2 * id);
  }

  Vec3 from_origin(const Position &position) const {
    return offset_from_origin(balls_, boundary_, position.ball) + position.offset;
  }
  // From the centre of an edge to a corner.
  Vec3 arm_to(uint32_t corner, const ArcPosition &edge) const {
    return from_origin(position_of_corner(map_, corner)) - from_origin(edge.centre);
  }

  // A corner lies on the circle of each edge that starts there.
  void check_corner(uint32_t h) {
    const uint32_t corner = map_.origin(h);
    if (corner == no_id) return;
    const ArcPosition arc = position_of_edge(map_, h / 2);
    const Vec3 arm = arm_to(corner, arc);
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
    count_euler(map_, [lacking](uint32_t shell, int32_t n) { lacking[shell] -= static_cast<uint32_t>(n); });
    for (uint32_t s = 0; s < shells && holds(); ++s) {
      if (lacking[s] >> 31 != 0 || lacking[s] % 2 != 0) fail(SurfaceInvariant::shells, s);
    }
  }

  // A cut concave patch is the sum of its pieces. Both are sums of the same terms, a few for each arc, in different
  // orders, so they differ by rounding alone.
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

  // The most by which sums of areas, and of terms of the volume, may differ if they have the same terms in different
  // orders: m additions of terms that are at most t round by m^2 t u. A face or patch with k arcs and loops, on a
  // sphere of radius at most R, is a sum of some 4 k terms of at most 7 pi R^2, which are rounded a few times each.
  // Beyond them come the 32 additions of a TreeSum. Terms of the volume are larger by as much as the sphere reaches
  // away from the origin.
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
      if (!map_.is_chosen(id)) continue;
      const BallMeasure measure = measure_patch(map_, id);
      area.add(-measure.area);
      volume.add(-measure.volume);
    }
    if (!most.allows(area.total(), volume.total())) fail(SurfaceInvariant::totals, no_id);
  }

  // Area and volume of a patch agree with the vector area that the circles around it give: 1/2 of the integral of
  // x x dx along them (Stokes). The outward normal of a sphere is along the radius, or against it.
  void check_patch(uint32_t id) {
    const SurfacePatch record = map_.patch(id);
    const BallMeasure measure = measure_patch(map_, id);
    if (!(measure.area >= 0.0)) fail(SurfaceInvariant::areas, id);
    if (record.kind != PatchKind::convex && record.kind != PatchKind::concave) return;
    Position centre;
    double radius;
    const double p = static_cast<double>(balls_.probe_steps);
    if (record.kind == PatchKind::convex) {
      centre = {boundary_.face(record.source).ball, {0.0, 0.0, 0.0}};
      radius = balls_.r[centre.ball] - p;
    } else {
      centre = position_of_vertex(balls_, boundary_, record.source);
      radius = -p;
    }
    const Vec3 arm = from_origin(centre);
    Vec3 vector_area{0.0, 0.0, 0.0};
    map_.for_each_loop(id, [&](uint32_t loop) {
      map_.for_each_edge(loop, [&](uint32_t h) { vector_area = vector_area + vector_area_along(h, arm); });
    });
    const double off = 3 * measure.volume - radius * measure.area - dot(arm, vector_area);
    const double most = tolerance * length_ * length_ * (length_ + std::sqrt(dot(arm, arm)));
    if (!(off <= most && -off <= most)) fail(SurfaceInvariant::closure, id);
  }

  Vec3 vector_area_along(uint32_t h, const Vec3 &origin) const {
    const ArcPosition arc = position_of_edge(map_, h / 2);
    const uint32_t first = map_.origin(h & ~1U);
    Vec3 chord{0.0, 0.0, 0.0};
    if (first != no_id) {
      chord = from_origin(position_of_corner(map_, map_.origin(h | 1U))) - from_origin(position_of_corner(map_, first));
    }
    const Vec3 forward = combine(0.5, cross(from_origin(arc.centre) - origin, chord),
                                 0.5 * arc.radius * arc.radius * arc.angle, arc.axis);
    return h % 2 == 0 ? forward : -forward;
  }

  const SurfaceMap &map_;
  const BallSet &balls_;
  const Boundary &boundary_;
  const Surface &surface_;
  const double length_;
  uint32_t visited_ = 0;
};

}  // namespace

SurfaceViolation check_surface(const SurfaceMap &map) {
  return SurfaceChecker(map).check();
}

}  // namespace hsp
