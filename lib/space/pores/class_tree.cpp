#include "pores/class_tree.hpp"

#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

// How far a way may end below the point that it ends at, in steps.
constexpr double below_end = 2.0;

// The maximum or gate that is nearest to where a way up ended, and not below that.
uint32_t maximum_near(const PoresBuilder &pores, const Vec3 &at, double level) {
  uint32_t best = no_id;
  double least = 0.0;
  const auto look_at = [&](const CriticalPoint &point, uint32_t maximum) {
    const Vec3 d = point.place - at;
    const double squared = dot(d, d);
    if (best != no_id && squared >= least) return;
    best = maximum;
    least = squared;
  };
  for (uint32_t k = 0; k < pores.maxima().size(); ++k) {
    const CriticalPoint &point = pores.maxima()[k].point;
    if (point.level < level - below_end) break;
    look_at(point, k);
  }
  for (const PoreGate &gate : pores.gates()) {
    if (gate.point.level < level - below_end) break;
    look_at(gate.point, gate.end[0]);
  }
  return best;
}

}  // namespace

uint32_t ClassTree::class_at(uint32_t maximum, double level) const {
  if (maximum != pore_outside && !(maxima_[maximum].point.level > level)) return no_id;
  while (maximum != pore_outside) {
    const uint32_t gate = maxima_[maximum].gate;
    if (gate == no_id || !(gates_[gate].point.level > level)) break;
    maximum = maxima_[maximum].into;
  }
  return maximum;
}

// The class that dies first moves on, until both are one. Gates are in descending order.
uint32_t ClassTree::gate_between(uint32_t a, uint32_t b) const {
  const auto death = [&](uint32_t maximum) { return maximum == pore_outside ? no_id : maxima_[maximum].gate; };
  uint32_t last = no_id;
  while (a != b) {
    const bool first = death(a) < death(b);
    const uint32_t gate = first ? death(a) : death(b);
    if (gate == no_id) return no_id;
    last = gate;
    (first ? a : b) = maxima_[first ? a : b].into;
  }
  return last;
}

Status locate(const PoresBuilder &pores, const CubeGrid &grid, const exact::Vector &point, int64_t floor,
              PorePlace &place) {
  place = {std::numeric_limits<double>::infinity(), no_id, pore_outside};
  if (grid.balls().n == 0) return Status::ok;
  Ascent way(grid, point);
  place.level = way.level();
  place.ball = way.nearest_ball();
  place.maximum = no_id;
  // Whether it is in a ball integers decide.
  if (floor == 0 ? any_ball_meets(grid, {point, 0}) : !(place.level > static_cast<double>(floor))) return Status::ok;
  while (way.step()) {
  }
  if (way.is_lost()) return Status::check;
  const Vec3 &offset = way.offset();
  const Vec3 at{static_cast<double>(point.x) + offset.x, static_cast<double>(point.y) + offset.y,
                static_cast<double>(point.z) + offset.z};
  place.maximum = way.is_outside() ? pore_outside : maximum_near(pores, at, way.level());
  // A maximum as low as the floor is not in the list.
  return place.maximum == no_id && way.level() > static_cast<double>(floor) + below_end ? Status::check : Status::ok;
}

}  // namespace hsp
