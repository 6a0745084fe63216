#include "surface/surface_check.hpp"

#include "exact/circle_crossing.hpp"
#include "measure/areas.hpp"
#include "surface/probe_positions.hpp"
#include "surface/surface_patches.hpp"
#include "surface/surface_positions.hpp"

namespace hsp {
namespace {

// Up to rounding, of lengths in units of the largest radius.
constexpr double tolerance = 1e-6;
// By which patches that are decided in integers move their borders, in units of the probe's radius
// (circles_in_integers.hpp).
constexpr double rounding_of_planes = 0x1p-28;

class SurfaceChecker {
 public:
  SurfaceChecker(const BallSet &balls, const Boundary &boundary, const Surface &surface)
      : balls_(balls),
        boundary_(boundary),
        surface_(surface),
        map_(balls, boundary, surface),
        length_(static_cast<double>(balls.largest_radius)) {}

  SurfaceViolation check() {
    if (!surface_.is_closed()) fail(SurfaceInvariant::joints, surface_.counts().joints.open);
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_steps(h);
    for (uint32_t patch = 0; patch < map_.patch_count() && holds(); ++patch) count_loops(patch);
    if (holds() && visited_ != 2 * map_.edge_count()) fail(SurfaceInvariant::loops, visited_);
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_crease(h);
    for (uint32_t h = 0; h < 2 * map_.edge_count() && holds(); ++h) check_corner(h);
    if (holds()) check_shells();
    for (uint32_t v = 0; v < boundary_.vertex_count() && holds(); ++v) check_areas_at(v);
    for (uint32_t patch = 0; patch < map_.patch_count() && holds(); ++patch) check_patch(patch);
    return violation_;
  }

 private:
  bool holds() const { return violation_.invariant == SurfaceInvariant::none; }
  void fail(SurfaceInvariant invariant, uint32_t id) {
    if (holds()) violation_ = {invariant, id};
  }

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
        if (map_.left(h) != patch || visited_ >= 2 * map_.edge_count()) return fail(SurfaceInvariant::loops, patch);
        ++visited_;
        h = map_.next(h);
      } while (h != loop);
      loop = map_.next_loop(loop);
    } while (loop != first);
  }

  // The circle of a crease is computed from each of its two probes; its angle was, when they were cut.
  void check_crease(uint32_t h) {
    const SurfaceEdge edge = map_.edge(h / 2);
    if (edge.kind != SurfaceEdgeKind::crease || h % 2 != 0) return;
    const CutPatches &cut = surface_.cut_patches();
    const PatchArc &arc = cut.arc(edge.source);
    const double radius = position_of_edge(balls_, boundary_, surface_, h / 2).radius;
    const double off = (arc.angle - cut.arc(arc.twin).angle) * radius;
    const double most = tolerance * length_ + uncertainty_of_crease(edge.source);
    if (!(off <= most && -off <= most)) fail(SurfaceInvariant::creases, h);
  }

  // A circle on the unit sphere about a vertex, that an arc of a cut patch lies on; and how far off it may be.
  struct ArcCircle {
    Vec3 axis;
    double height, error;
  };
  ArcCircle circle_of(uint32_t vertex, const PatchArc &arc) const {
    const double error = vertex_error * length_;
    const Vec3 at = place_of(vertex);
    if (!arc.is_side()) {
      const Vec3 to = place_of(arc.across) - at;
      const double distance = std::sqrt(dot(to, to));
      if (!(distance > 0.0)) return {{0.0, 0.0, 0.0}, 0.0, 1.0};
      return {(1.0 / distance) * to, distance / (2 * static_cast<double>(balls_.probe_steps)),
              14 * error / distance + rounding_of_planes};
    }
    const VertexRecord &record = boundary_.vertex(vertex);
    const Vec3 first = centre_of(record.ball[arc.slot() == 0 ? 1 : 0]) - at;
    const Vec3 second = centre_of(record.ball[arc.slot() == 2 ? 1 : 2]) - at;
    const Vec3 normal = cross(first, second);
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0.0)) return {{0.0, 0.0, 0.0}, 0.0, 1.0};
    const double longer = std::sqrt(dot(first, first)) + std::sqrt(dot(second, second));
    return {(1.0 / length) * normal, 0.0, error * longer / length + rounding_of_planes};
  }

  // Where two circles cross at an angle whose sine is s, errors d of them move their crossing by d/s along one of them,
  // and if they nearly touch by the root of d. So little is known of where a crease ends if two of the probes are close
  // to each other, or it grazes the border.
  double uncertainty_of_ends(uint32_t a) const {
    const CutPatches &cut = surface_.cut_patches();
    const PatchArc &arc = cut.arc(a);
    if (arc.next == a) return 0.0;
    const uint32_t vertex = cut.piece(cut.piece_of_arc(a)).vertex;
    const ArcCircle own = circle_of(vertex, arc);
    double sum = 0.0;
    const uint32_t ends[2] = {arc.next, cut.previous(a)};
    for (const uint32_t beside : ends) {
      const ArcCircle other = circle_of(vertex, cut.arc(beside));
      const CircleCrossing<Vec3, double> crossing(own.axis, own.height, other.axis, other.height);
      const double D = crossing.discriminant(1.0);
      const double error = own.error + other.error;
      const double square = D > error ? D : error;
      sum += 4 * error / std::sqrt(square);
    }
    return sum * static_cast<double>(balls_.probe_steps);
  }

  // In both of its patches.
  double uncertainty_of_crease(uint32_t arc) const {
    return uncertainty_of_ends(arc) + uncertainty_of_ends(surface_.cut_patches().arc(arc).twin);
  }

  Vec3 centre_of(uint32_t ball) const { return offset_from_origin(balls_, boundary_, ball); }
  Vec3 place_of(uint32_t vertex) const { return from_origin(position_of_probe(balls_, boundary_, vertex)); }

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

  // What is left of a concave patch is not more than the patch, and its pieces are all of it.
  void check_areas_at(uint32_t v) {
    const double most = tolerance * length_ * length_;
    const CutPatches &cut = surface_.cut_patches();
    double area = 0.0;
    double volume = 0.0;
    if (!cut.is_cut(v)) return;
    const ConcavePatch &patch = cut.patch(v);
    for (const uint32_t piece : cut.pieces(v)) {
      area += cut.piece(piece).area;
      volume += cut.piece(piece).volume;
    }
    const double off = area - patch.area;
    const double volume_off = (volume - patch.volume) / extent(v);
    if (!(off <= most && -off <= most && volume_off <= most && -volume_off <= most)) fail(SurfaceInvariant::areas, v);
  }
  double extent(uint32_t v) const {
    const Vec3 arm = offset_from_origin(balls_, boundary_, boundary_.vertex(v).ball[0]);
    return length_ + std::sqrt(dot(arm, arm));
  }

  // Area and volume of a patch agree with the vector area that the circles around it give: 1/2 of the integral of
  // x x dx along them (Stokes). The outward normal of a sphere is along the radius, or against it.
  void check_patch(uint32_t id) {
    const SurfacePatch record = map_.patch(id);
    const PatchMeasure measure = measure_patch(balls_, boundary_, surface_, id);
    if (!(measure.area >= 0.0)) return fail(SurfaceInvariant::areas, id);
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
        if (edge.kind == SurfaceEdgeKind::crease) uncertainty += uncertainty_of_crease(edge.source);
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
  const double length_;
  uint32_t visited_ = 0;
  SurfaceViolation violation_;
};

}  // namespace

SurfaceViolation check_surface(const BallSet &balls, const Boundary &boundary, const Surface &surface) {
  return SurfaceChecker(balls, boundary, surface).check();
}

}  // namespace hsp
