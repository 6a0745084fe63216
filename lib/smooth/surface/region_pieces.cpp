#include "surface/region_pieces.hpp"

#include "core/elementary.hpp"
#include "sphere/arc_geometry.hpp"

namespace hsp {
namespace {

Vec3 across_axis(const Vec3 &axis) {
  const bool along_x = axis.x * axis.x > 0.5;
  const Vec3 side = cross(axis, along_x ? Vec3{0, 1, 0} : Vec3{1, 0, 0});
  return (1.0 / std::sqrt(dot(side, side))) * side;
}

// The point of an arc that lies by an angle from its start.
class ArcPoints {
 public:
  ArcPoints(const Caps &caps, Span<const RegionCorner> corners, const RegionArc &arc)
      : axis_(caps.axis(arc.circle)), centre_(caps.b[arc.circle] * axis_) {
    const double height = caps.b[arc.circle];
    from_centre_ = arc.start == no_id ? std::sqrt((1.0 - height) * (1.0 + height)) * across_axis(axis_)
                                      : corners[arc.start].point - centre_;
  }
  Vec3 at(double angle) const {
    const SinCos turn = sin_cos(angle);
    return centre_ + combine(turn.cosine, from_centre_, turn.sine, cross(axis_, from_centre_));
  }

 private:
  Vec3 axis_, centre_, from_centre_{};
};

double loop_curvature(Span<const RegionArc> arcs, uint32_t first) {
  double sum = 0.0;
  uint32_t a = first;
  do {
    sum += arcs[a].curvature;
    a = arcs[a].next;
  } while (a != first);
  return sum;
}

// The angle by which the direction from a point to one that runs around the loop turns, in arcs of a few degrees.
double turns_about(const Caps &caps, Span<const RegionCorner> corners, Span<const RegionArc> arcs, uint32_t first,
                   const Vec3 &point) {
  double sum = 0.0;
  uint32_t a = first;
  do {
    const ArcPoints points(caps, corners, arcs[a]);
    const uint32_t steps = 1 + static_cast<uint32_t>(arcs[a].angle * 8);
    Vec3 from = points.at(0.0);
    for (uint32_t k = 1; k <= steps; ++k) {
      const Vec3 to = points.at(arcs[a].angle * k / steps);
      const double turn =
          turn_about(point, combine(1.0, from, -dot(from, point), point), combine(1.0, to, -dot(to, point), point));
      sum += turn > pi ? turn - 2 * pi : turn;
      from = to;
    }
    a = arcs[a].next;
  } while (a != first);
  return sum;
}

}  // namespace

bool find_pieces(const Caps &caps, Span<const RegionCorner> corners, Span<RegionArc> arcs) {
  uint32_t pieces = 0;
  uint32_t last_piece = no_id;
  for (uint32_t first = 0; first < arcs.size(); ++first) {
    if (arcs[first].loop != no_id) continue;
    const bool is_piece = loop_curvature(arcs, first) < 0.0;
    if (is_piece) {
      ++pieces;
      last_piece = first;
    }
    for (uint32_t a = first; arcs[a].loop == no_id; a = arcs[a].next) {
      arcs[a].loop = first;
      arcs[a].piece = is_piece ? first : no_id;
    }
  }
  for (uint32_t hole = 0; hole < arcs.size(); ++hole) {
    if (arcs[hole].loop != hole || arcs[hole].piece != no_id) continue;
    uint32_t around = pieces == 1 ? last_piece : no_id;
    if (pieces != 1) {
      const Vec3 point = ArcPoints(caps, corners, arcs[hole]).at(0.0);
      for (uint32_t piece = 0; piece < arcs.size(); ++piece) {
        if (arcs[piece].piece != piece) continue;
        // The region lies on the right of its arcs: they run clockwise around it.
        if (turns_about(caps, corners, arcs, piece, point) > -pi) continue;
        if (around != no_id) return false;
        around = piece;
      }
    }
    if (around == no_id) return false;
    uint32_t a = hole;
    do {
      arcs[a].piece = around;
      a = arcs[a].next;
    } while (a != hole);
  }
  return true;
}

}  // namespace hsp
