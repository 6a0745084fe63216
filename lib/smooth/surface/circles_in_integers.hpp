// The same caps with their planes rounded to integers, as a source of decisions for free_region.hpp that answers every
// question, exactly and without contradiction: ties are decided by the symbolic perturbation.
#pragma once

#include "core/decimal.hpp"
#include "exact/angular_order.hpp"
#include "sphere/arc_geometry.hpp"
#include "sphere/caps.hpp"
#include "surface/free_region.hpp"

namespace hsp {

class CirclesInIntegers {
 public:
  // The unit sphere, magnified: y = 2^30 x, so W = 2^60; normals have a length of about 2^29, and what is rounded moves
  // a circle by less than 2^-28.
  static constexpr int64_t normal_length = INT64_C(1) << 29;
  static constexpr int64_t W = INT64_C(1) << 60;

  explicit CirclesInIntegers(const Caps &caps) : caps_(caps), predicates_({W, no_id}, 0x1p60) {}

  struct Crossing {
    uint32_t first, second;
  };

  uint32_t count() const { return caps_.count; }
  Vec3 axis(uint32_t k) const { return geometry(k).axis; }
  double height(uint32_t k) const { return geometry(k).height * to_unit; }

  Answer crossing(uint32_t j, uint32_t k, Crossing &crossing) const {
    crossing = {j, k};
    return answer(predicates_.crossing(plane(j), plane(k)).sign);
  }
  Answer contains(const Crossing &crossing, int sign, uint32_t r) const {
    return answer(predicates_.inside(plane(crossing.first), plane(crossing.second), sign, plane(r)));
  }
  RegionCorner corner(const Crossing &crossing, int sign) const {
    const exact::Plane P = plane(crossing.first);
    const exact::Plane Q = plane(crossing.second);
    const double D = exact::Exact::discriminant(predicates_.sphere(), P, Q);
    const double root = std::sqrt(D > 0.0 ? D : 0.0);
    return {crossing.first, crossing.second, sign, root, to_unit * crossing_point(P, Q, sign, root), 0.0, false};
  }
  Answer lies_inside(uint32_t k, uint32_t r) const { return answer(predicates_.side(plane(k), plane(r)).sign); }
  // The order of entries is that of the mid-points of what the other caps cover; that of the exit's own cap is a whole
  // turn away (sphere/half_edges.hpp).
  bool ends_sooner(uint32_t k, const RegionCorner &exit, const RegionCorner &a, const RegionCorner &b) const {
    const uint32_t from = exit.other(k);
    if (a.other(k) == from || b.other(k) == from) return a.other(k) != from;
    return exact::counter_clockwise_before(plane(k).v, plane(from).v, plane(a.other(k)).v, plane(b.other(k)).v);
  }
  double arc_angle(uint32_t k, const RegionCorner &exit, const RegionCorner &entry) const {
    return hsp::arc_angle(plane(k), plane(exit.other(k)), exit.root, plane(entry.other(k)), entry.root);
  }
  double exterior_angle(const RegionCorner &corner) const {
    return hsp::exterior_angle(corner.root, predicates_.sphere(), plane(corner.first), plane(corner.second));
  }

 private:
  // Positions of lib/union/sphere are x = y / 2.
  static constexpr double to_unit = 0x1p-29;

  static Answer answer(int sign) { return sign > 0 ? Answer::yes : Answer::no; }
  exact::Plane plane(uint32_t k) const {
    constexpr double scale = static_cast<double>(normal_length);
    const exact::Vector v{nearest(scale * caps_.ux[k]), nearest(scale * caps_.uy[k]), nearest(scale * caps_.uz[k])};
    const double length = std::sqrt(static_cast<double>(dot(v, v)));
    return {v, nearest(caps_.b[k] * length * 0x1p30), 1, k};
  }
  CircleGeometry geometry(uint32_t k) const { return {predicates_.sphere(), plane(k)}; }

  const Caps &caps_;
  exact::Predicates predicates_;
};

}  // namespace hsp
