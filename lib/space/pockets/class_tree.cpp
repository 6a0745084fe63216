#include "pockets/class_tree.hpp"

#include "core/first_index.hpp"
#include "lanes/floating_point.hpp"

namespace hsp {
namespace {

// How far a way may end below the point that it ends at, in steps.
constexpr double below_end = 2.0;

// How many records are not below a level; their levels descend.
template <class Record>
uint32_t count_not_below(Span<const Record> records, double level) {
  return first_index(0, records.size(), [&](uint32_t k) { return records[k].point.level < level; });
}

// Sets the maximum of a location, and its copy, from the end of a way up. The way ends near the maximum or gate that is
// nearest to its end and not below it. The levels of two points differ by no more than their distance: so the search
// begins with the lowest record, and stops at levels that are higher than the end by more than the least distance
// found. The two steps of below_end make up for the rounding of levels, and of distances up to 2^50 steps. For a longer
// distance 2^-52 of it may be a step by itself, for which there is the factor.
void find_nearest(const PoresBuilder &pores, const PeriodicBox *box, const Vec3 &at, const Ascent &way,
                  PoreLocation &location) {
  const double lowest = way.level() - below_end;
  double least = std::numeric_limits<double>::infinity();
  const auto is_too_high = [&](const CriticalPoint &point) {
    return way.level_is_known() && point.level > way.level() + below_end + std::sqrt(least) * (1.0 + 0x1p-40);
  };
  // Of points that are equally far the highest counts, and maxima before gates.
  const auto is_nearer = [&](const CriticalPoint &point, bool or_as_near, BoxShift &shift) {
    Vec3 d = at - point.position;
    shift = box == nullptr ? BoxShift{} : box->centre(d);
    const double squared = dot(d, d);
    if (or_as_near ? squared > least : squared >= least) return false;
    least = squared;
    return true;
  };
  BoxShift shift;
  for (uint32_t k = count_not_below(pores.maxima(), lowest); k > 0 && !is_too_high(pores.maxima()[k - 1].point); --k) {
    if (!is_nearer(pores.maxima()[k - 1].point, true, shift)) continue;
    location.maximum = k - 1;
    location.maximum_shift = shift;
  }
  bool has_gate = false;
  for (uint32_t k = count_not_below(pores.gates(), lowest); k > 0 && !is_too_high(pores.gates()[k - 1].point); --k) {
    const PoreGate &gate = pores.gates()[k - 1];
    if (!is_nearer(gate.point, has_gate, shift)) continue;
    has_gate = true;
    location.maximum = gate.end[0];
    location.maximum_shift = shift + gate.end_shift[0].shift();
  }
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

// Of the two classes the one that dies first is replaced by the one that it merges into, until both are one. Gates are
// in descending order.
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

// Each class on the way to the root may wind itself before it dies, or merge into one that does.
uint32_t ClassTree::gate_to_copy(uint32_t maximum) const {
  uint32_t last = 0;
  while (winding_gates_[maximum] == no_id) {
    last = maxima_[maximum].gate;
    if (last == no_id) return no_id;
    maximum = maxima_[maximum].into;
  }
  return winding_gates_[maximum] > last ? winding_gates_[maximum] : last;
}

Status locate(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &point, int64_t floor,
              PoreLocation &location) {
  location = {std::numeric_limits<double>::infinity(), no_id, pore_outside, {}, {}};
  if (balls.are_none()) return Status::ok;
  exact::Vector wrapped = point;
  BoxShift home;
  if (balls.box() != nullptr && balls.box()->wrap(wrapped, home) != Status::ok) return Status::range;
  Ascent way(balls, point);
  location.level = way.level();
  location.ball = way.nearest_ball().ball;
  location.ball_shift = way.nearest_ball().shift;
  location.maximum = no_id;
  // Integers decide whether the point is in a ball.
  const bool blocked =
      floor == 0 ? balls.find({point, 0}, nullptr, 0) > 0 : !(location.level > static_cast<double>(floor));
  if (blocked) return Status::ok;
  return follow_up(pores, balls, way, point, floor, location);
}

Status follow_up(const PoresBuilder &pores, const BallsAround &balls, Ascent &way, const exact::Vector &start,
                 int64_t floor, PoreLocation &location) {
  while (way.step()) {
  }
  // So far from all balls a way may be too flat for the number of steps allowed.
  const Status lost = way.level() > 0x1p34 ? Status::range : Status::check;
  if (way.is_lost()) return lost;
  const Vec3 &offset = way.offset();
  const Vec3 at{static_cast<double>(start.x) + offset.x, static_cast<double>(start.y) + offset.y,
                static_cast<double>(start.z) + offset.z};
  if (way.is_outside()) {
    location.maximum = pore_outside;
  } else {
    find_nearest(pores, balls.box(), at, way, location);
  }
  // A maximum as low as the floor is not in the list.
  return location.maximum == no_id && way.level() > static_cast<double>(floor) + below_end ? lost : Status::ok;
}

Status find_passage(const PoresBuilder &pores, const BallsAround &balls, const exact::Vector &from,
                    const exact::Vector *to, int64_t floor, PorePassage &passage) {
  PoreLocation ends[2];
  ends[1] = {std::numeric_limits<double>::infinity(), no_id, pore_outside, {}, {}};
  Status status = locate(pores, balls, from, floor, ends[0]);
  if (status == Status::ok && to != nullptr) status = locate(pores, balls, *to, floor, ends[1]);
  if (status != Status::ok) return status;
  const bool to_copy = to == nullptr && balls.box() != nullptr && !balls.are_none();
  if (to_copy) ends[1] = ends[0];
  const uint32_t a = ends[0].maximum, b = ends[1].maximum;
  passage = {false, 0.0, no_id, no_id, {a, b}};
  if (a == no_id || b == no_id) return Status::ok;
  const ClassTree tree(pores);
  const uint32_t gate = to_copy ? tree.gate_to_copy(a) : tree.gate_between(a, b);
  if ((a != b || to_copy) && gate == no_id) return Status::ok;
  const PoreLocation &tighter = ends[ends[0].level <= ends[1].level ? 0 : 1];
  const bool at_gate = gate != no_id && pores.gates()[gate].point.level < tighter.level;
  passage.passes = true;
  passage.level = at_gate ? pores.gates()[gate].point.level : tighter.level;
  passage.gate = at_gate ? gate : no_id;
  passage.ball = at_gate ? no_id : tighter.ball;
  return Status::ok;
}

}  // namespace hsp
