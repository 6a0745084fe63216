#include "pores/critical_points.hpp"

#include <bit>
#include <initializer_list>

#include "core/extremes.hpp"
#include "core/sorting.hpp"
#include "exact/lattice.hpp"
#include "pores/cube_halves.hpp"
#include "pores/search_blocks.hpp"

namespace hsp {
namespace {

using exact::Vector;

constexpr uint32_t most_cubes = 64;  // on the stack of cubes that are being halved: from 2^52 steps down to least_half
constexpr int64_t least_half = 4;
constexpr uint32_t most_fine_cubes = 64;
constexpr uint32_t most_led_up = 1 << 14;

// An upper bound of how far a point of a cube is from its centre, and a step more.
double reach_of(int64_t half) {
  return static_cast<double>(half + 2) * root_of_three * (1.0 + 0x1p-50);
}
// Bound of the error of a computed distance: its differences are integers, so that its relative error is below 3 2^-53.
double error_of(double distance) {
  return 0x1p-50 * distance;
}
// Eight bytes as one number, the first byte lowest; written so that compilers make one load of it.
uint64_t eight_bytes(const uint8_t *p) {
  const auto byte = [&](uint32_t k) { return static_cast<uint64_t>(p[k]) << 8 * k; };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}
bool contains(const Vector &centre, int64_t half, const Vector &other, int64_t other_half) {
  const int64_t room = half - other_half;
  const auto within = [&](int64_t a, int64_t b) { return a - b <= room && b - a <= room; };
  return within(centre.x, other.x) && within(centre.y, other.y) && within(centre.z, other.z);
}

}  // namespace

void CriticalPoints::carve(Workspace &workspace, const PoreLimits &limits) {
  limits_ = limits;
  maxima_ = FixedVector<PoreMaximum>(workspace.take<PoreMaximum>(limits.maxima));
  gates_ = FixedVector<PoreGate>(workspace.take<PoreGate>(limits.gates));
  tied_ = FixedVector<uint32_t>(workspace.take<uint32_t>(limits.tied));
  tied_shifts_ = FixedVector<SmallShift>(workspace.take<SmallShift>(limits.tied));
  maximum_names_.carve(workspace, limits.maxima);
  gate_names_.carve(workspace, limits.gates);
  candidates_ = workspace.take<uint32_t>(limits.candidates);
  in_parts_ = workspace.take<uint8_t>(static_cast<uint64_t>(limits.candidates) + 8);
  cubes_ = workspace.take<Cube>(most_cubes);
  target_ = workspace.target();
  at_point_ = workspace.take<uint32_t>(limits.near);
  cluster_ = workspace.take<uint32_t>(limits.near);
  lines_ = workspace.make<TangentLines>(1);
  directions_ = workspace.take<CubeDirections>(1);
  hull_ = workspace.take<Vec3>(limits.near);
  room_ = workspace.take<Vec3>(limits.near);
  inverse_ = workspace.take<double>(limits.near);
  fine_cubes_ = workspace.take<FineCube>(most_fine_cubes);
}

Status CriticalPoints::find(PoreBalls &balls, int64_t floor, Patience patience, const PoresBuilder *before) {
  patience_ = patience;
  all_ = &balls;
  before_ = before;
  balls_ = &balls.set();
  floor_ = floor;
  needed_ = {balls.set().n, 0, 0, 0, 0, 0};
  work_ = {};
  ceiling_ = std::numeric_limits<double>::infinity();
  const PeriodicBox *const box = balls.box();
  if (balls.own() < (box == nullptr ? 3U : 1U)) {
    forget();
    return Status::ok;
  }
  if (box == nullptr) {
    Vec3 low, high;
    balls.find_box(low, high);
    return search(low, high);
  }
  // Images are needed as far from the box as a ball can be nearest to a point in it. The reach is guessed, and grows
  // until it certainly suffices.
  const double largest = static_cast<double>(balls.set().largest_radius);
  double reach = 4.0 * largest + 0.25 * static_cast<double>(box->shortest_side());
  for (;;) {
    const bool longest = reach >= static_cast<double>(balls.longest_reach());
    if (longest) reach = static_cast<double>(balls.longest_reach());
    const int64_t steps = static_cast<int64_t>(reach);
    const Status status = balls.surround(steps);
    if (status != Status::ok) return status;
    needed_.balls = larger_count(needed_.balls, balls.set().n);
    ceiling_ = static_cast<double>(steps) - largest - 2.0;
    const Status found = search({0.0, 0.0, 0.0}, to_double(balls.brick()));
    if (found != Status::ok || beyond_ceiling_ == 0.0) return found;
    if (longest) return Status::check;
    reach = larger_of(1.25 * reach, beyond_ceiling_ + largest + 4.0);
  }
}

void CriticalPoints::forget() {
  beyond_reach_ = false;
  beyond_ceiling_ = 0.0;
  maxima_.clear();
  gates_.clear();
  tied_.clear();
  tied_shifts_.clear();
  maximum_names_.clear();
  gate_names_.clear();
}

// Finds the critical points in a box of space. If beyond_ceiling_ is not 0 afterwards, they are not complete.
Status CriticalPoints::search(const Vec3 &low, const Vec3 &high) {
  const BallSet &balls = *balls_;
  forget();
  if (before_ != nullptr) {
    if (const Status status = take_known(); status != Status::ok) return status;
  }
  needed_.candidates = larger_count(needed_.candidates, balls.n);
  if (balls.n > limits_.candidates) return Status::capacity;
  for (uint32_t i = 0; i < balls.n; ++i) candidates_[i] = i;
  low_ = low;
  high_ = high;
  const double extent = larger_of(larger_of(high_.x - low_.x, high_.y - low_.y), high_.z - low_.z);
  int64_t half = least_half;
  while (static_cast<double>(half) < 0.6 * extent + 2.0) half *= 2;
  // The first cube is off the middle of the box, so that points of symmetry are no corners of cubes.
  const auto middle = [&](double least, double most, double part) {
    return nearest(0.5 * (least + most)) +
           static_cast<int64_t>(part * (static_cast<double>(half) - 0.5 * extent - 2.0));
  };
  uint32_t depth = 0;
  cubes_[depth++] = {{middle(low_.x, high_.x, 0.311), middle(low_.y, high_.y, 0.427), middle(low_.z, high_.z, 0.241)},
                     half,
                     0,
                     balls.n,
                     0,
                     {},
                     {},
                     0};
  while (depth > 0) {
    Cube &cube = cubes_[depth - 1];
    if (cube.next_part == 8) {
      --depth;
      continue;
    }
    if (!patience_.allows(500 + 20 * uint64_t{cube.last - cube.first})) return Status::stopped;
    if (cube.next_part == 0) halve(cube);
    const uint32_t part = cube.next_part++;
    const int64_t step = cube.half / 2;
    const auto moved = [&](int64_t at, uint32_t axis) { return (part >> axis & 1) != 0 ? at + step : at - step; };
    Cube &child = cubes_[depth];  // comes onto the stack if it is to be halved
    child.centre = {moved(cube.centre.x, 0), moved(cube.centre.y, 1), moved(cube.centre.z, 2)};
    child.half = step;
    child.searched_centre = cube.searched_centre;
    child.searched_half = cube.searched_half;
    child.next_part = 0;
    child.first = cube.last;
    child.last = enter(child, cube, part);
    if (needed_.candidates > limits_.candidates) return Status::capacity;
    if (beyond_ceiling_ != 0.0) return Status::ok;
    if (child.last == child.first) continue;
    if (unsure_) {
      ++depth;
      continue;
    }
    const Span<const uint32_t> near = candidates_.part(child.first, child.last);
    if (near.size() <= most_tried_whole || child.half <= least_half) {
      const Block own{child.centre, static_cast<double>(child.half + 1)};
      if (!patience_.allows(3000 + 500 * uint64_t{near.size()})) return Status::stopped;
      try_leaf(near, own, own, PointKind::passing, child.last);
      if (needed_.near > limits_.near || needed_.candidates > limits_.candidates) return Status::capacity;
      continue;
    }
    // Candidates that tie do not become fewer by halving.
    if (9 * near.size() >= 8 * (cube.last - cube.first)) search_ties(child);
    if (!patience_.allows(0)) return Status::stopped;
    if (needed_.near > limits_.near || needed_.candidates > limits_.candidates) return Status::capacity;
    if (!is_searched(child)) ++depth;
  }
  if (!patience_.allows(0)) return Status::stopped;
  needed_.maxima = clamped_count(maxima_.required());
  needed_.gates = clamped_count(gates_.required());
  needed_.tied = clamped_count(tied_.required());
  if (maxima_.overflowed() || gates_.overflowed() || tied_.overflowed()) return Status::capacity;
  return beyond_reach_ ? Status::range : Status::ok;
}

bool CriticalPoints::is_searched(const Cube &cube) const {
  return cube.searched_half != 0 && contains(cube.searched_centre, cube.searched_half, cube.centre, cube.half);
}

NearArrays CriticalPoints::near_arrays(Span<const uint32_t> ids) const {
  const BallSet &balls = *balls_;
  return {balls.x.data(), balls.y.data(), balls.z.data(), balls.r.data(), ids.data(), ids.size()};
}

// Finds which candidates of a cube may be nearest in each of its parts. f is at most the distance from any one ball to
// the farthest corner of the part; the ball that is nearest to its middle is taken. A ball that is farther from all of
// the part is nowhere nearest in it.
void CriticalPoints::halve(Cube &cube) {
  CubeParts parts;
  const int64_t step = cube.half / 2;
  const auto side = [&](uint32_t part, uint32_t axis) { return (part >> axis & 1) != 0 ? step : -step; };
  for (uint32_t part = 0; part < 8; ++part) {
    parts.x[part] = static_cast<double>(cube.centre.x + side(part, 0));
    parts.y[part] = static_cast<double>(cube.centre.y + side(part, 1));
    parts.z[part] = static_cast<double>(cube.centre.z + side(part, 2));
  }
  parts.edge = static_cast<double>(step + 2);
  const BallSet &balls = *balls_;
  const NearArrays near = near_arrays(candidates_.part(cube.first, cube.last));
  find_nearest(target_, near, parts);
  for (uint32_t part = 0; part < 8; ++part) {
    const uint32_t ball = parts.nearest[part];
    const Vec3 corner{std::fabs(balls.x[ball] - parts.x[part]) + parts.edge,
                      std::fabs(balls.y[ball] - parts.y[part]) + parts.edge,
                      std::fabs(balls.z[ball] - parts.z[part]) + parts.edge};
    const double farthest = std::sqrt(dot(corner, corner)), radius = balls.r[ball];
    parts.most_level[part] = cube.most_level[part] = farthest + error_of(farthest + radius) - radius;
  }
  find_near(target_, near, parts, &in_parts_[cube.first]);
}

// Copies the candidates of a cube that may be nearest in one of its parts, behind those of the cube; returns where they
// end. Copies none if the part has no critical point.
uint32_t CriticalPoints::enter(const Cube &cube, const Cube &whole, uint32_t part) {
  ++work_.cubes;
  unsure_ = false;
  const uint32_t first = whole.first, last = whole.last;
  const double most_level = whole.most_level[part];
  const double x = static_cast<double>(cube.centre.x), y = static_cast<double>(cube.centre.y),
               z = static_cast<double>(cube.centre.z), side = static_cast<double>(cube.half + 1);
  if (x - side > high_.x || x + side < low_.x || y - side > high_.y || y + side < low_.y || z - side > high_.z ||
      z + side < low_.z || is_searched(cube)) {
    return last;
  }
  const uint32_t most = last - first;
  needed_.candidates = larger_count(needed_.candidates, clamped_count(static_cast<uint64_t>(last) + most));
  if (most > limits_.candidates - last) return last;
  const double reach = reach_of(cube.half);
  if (most_level < static_cast<double>(floor_)) return last;
  unsure_ = most_level + 2.0 * reach > ceiling_;
  if (unsure_ && (16.0 * reach < ceiling_ + static_cast<double>(balls_->largest_radius) || cube.half <= least_half)) {
    beyond_ceiling_ = most_level + 2.0 * reach;
    return last;
  }
  uint32_t count = 0;
  for (uint32_t k = first; k < last; k += 8) {
    uint64_t here = eight_bytes(&in_parts_[k]) >> part & UINT64_C(0x0101010101010101);
    if (last - k < 8) here &= (UINT64_C(1) << 8 * (last - k)) - 1;
    for (; here != 0; here &= here - 1) {
      candidates_[last + count++] = candidates_[k + static_cast<uint32_t>(std::countr_zero(here)) / 8];
    }
  }
  if (unsure_) return last + count;
  if (count < 3 || !may_be_new(last, count)) return last;
  const Vec3 at{x, y, z};
  const double reach_along = static_cast<double>(cube.half + 3);
  if (count <= CubeDirections::room) {
    const uint32_t left = leave_few(at, reach_along, last, count, count == most && count > most_tried_whole);
    return may_be_new(last, left) ? last + left : last;
  }
  // As a rule more candidates become fewer by halving, unless the cube is small beside their distance: those of a ring
  // become fewer slowly.
  const bool small = distance(*balls_, candidates_[last], cube.centre) > 8.0 * reach_along;
  return last + (small || 9 * count >= 8 * most ? leave_many(at, reach_along, last, count) : count);
}

uint32_t CriticalPoints::leave_many(const Vec3 &at, double half, uint32_t first, uint32_t count) {
  if (count > limits_.near || count > most_led_up) return count;
  if (needed_.near < count) needed_.near = count;  // with less room other cubes are halved, which may need more
  see_directions(candidates_.part(first, first + count), at);
  const auto a = [&](uint32_t k) { return hull_[k]; };
  const auto inverse = [&](uint32_t k) { return inverse_[k]; };
  return lead_up_at_all(count, half, a, inverse) ? 0 : count;
}

// Sets hull_, inverse_ and room_ to the unit vectors from the centres of balls to a point, their inverse lengths, and
// the vectors.
void CriticalPoints::see_directions(Span<const uint32_t> near, const Vec3 &at) {
  for (uint32_t k = 0; k < near.size(); ++k) {
    const Vec3 y = at - centre_of(*balls_, near[k]);
    const double length = std::sqrt(dot(y, y));
    inverse_[k] = length > 0.0 ? 1.0 / length : 0.0;
    hull_[k] = inverse_[k] * y;
    room_[k] = y;
  }
}

// Leaves out candidates that are farther than another one in all of the cube, a bit for each; returns how many stay.
uint32_t CriticalPoints::drop_farther(uint32_t first, uint32_t count, uint64_t dropped) {
  CubeDirections &directions = directions_[0];
  if (dropped == 0) return count;
  uint32_t left = 0;
  for (uint64_t rest = ~dropped & ~UINT64_C(0) >> (64 - count); rest != 0; rest &= rest - 1) {
    const auto k = static_cast<uint32_t>(std::countr_zero(rest));
    directions.move(k, left);
    candidates_[first + left++] = candidates_[first + k];
  }
  return left;
}

// A bit for each candidate to leave out, of balls closer together than doubles tell distances apart, or the cube is
// wide. Let y and Y be the vectors from two centres to the middle of the cube. The difference of their lengths is
// (y - Y).(y + Y) / (|y| + |Y|): as y - Y is exact, it is wrong by a fraction of |y - Y| alone, less than 2^-48.
// Elsewhere in the cube it is no more than `reach` times the difference of the unit vectors away from that, which is at
// most 2 |y - Y| / (|y| + |Y|) (Dunkl and Williams 1964).
uint64_t CriticalPoints::compare_clustered(uint32_t first, uint32_t count, const Vec3 &at, double half) const {
  const BallSet &balls = *balls_;
  const double reach = root_of_three * half;
  const auto is_farther = [&](uint32_t ball, uint32_t other) {
    const Vec3 y = at - centre_of(balls, ball), Y = at - centre_of(balls, other), w = balls.difference(ball, other);
    const double lengths = std::sqrt(dot(y, y)) + std::sqrt(dot(Y, Y)), apart = std::sqrt(dot(w, w));
    const double wider = balls.r[ball] - balls.r[other];
    if (!(lengths > 4.0 * reach)) return false;
    const double off = 2.0 * reach * apart / (lengths - 2.0 * reach);
    return dot(w, y + Y) / lengths - wider > off + 0x1p-44 * (apart + off + std::fabs(wider));
  };
  uint64_t dropped = 0;
  for (uint32_t k = 0; k < count; ++k) {
    bool farther = false;
    for (uint32_t m = 0; m < count && !farther; ++m) {
      const bool stays = m != k && (dropped >> m & 1) == 0;
      farther = stays && is_farther(candidates_[first + k], candidates_[first + m]);
    }
    dropped |= uint64_t{farther} << k;
  }
  return dropped;
}

// Tries the sets of a cube's candidates at once if all of them tie, or nearly tie, at one point.
void CriticalPoints::search_ties(Cube &cube) {
  const BallSet &balls = *balls_;
  const Span<const uint32_t> near = candidates_.part(cube.first, cube.last);
  const uint32_t count = near.size();
  if (count > most_led_up) return;
  // Near the centre of a ball the bound allows no search as large as a part of the cube.
  for (const uint32_t ball : near) {
    if (distance(balls, ball, cube.centre) < 4.0 * static_cast<double>(cube.half)) return;
  }
  needed_.near = larger_count(needed_.near, count);
  if (count > limits_.near) return;
  uint32_t set[4];
  const bool solid = find_far_apart(balls, near, set);
  if (set[2] == set[0]) return;
  // Tries both points of four balls, and the point of three balls in their plane.
  for (const int attempt : {0, 1, 2}) {
    const bool rising = attempt == 1, flat = attempt == 2;
    TangentPoint point(lines());
    if ((!solid && !flat) || !point.find(balls, {set[0], set[1], set[2]}, flat ? no_id : set[3], rising)) continue;
    const Vec3 at = point.position_estimate();
    if (!(std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z) < 0x1p52)) continue;
    const Vector x{nearest(at.x), nearest(at.y), nearest(at.z)};
    if (!contains(cube.centre, 2 * cube.half, x, 0)) continue;
    if (cube.searched_half != 0 && contains(cube.searched_centre, cube.searched_half, x, 0)) return;
    const auto gap_of = [&](uint32_t ball) { return distance(balls, ball, x) - balls.r[ball]; };
    for (uint32_t k = 0; k < count; ++k) cluster_[k] = near[k];
    sort_in_place(cluster_.part(0, count), [&](uint32_t a, uint32_t b) { return gap_of(a) < gap_of(b); });
    const double lowest = gap_of(cluster_[0]);
    uint32_t size = 0;
    double ratio = 0.0, next = 0.0, spread = 0.0, nearest_centre = std::numeric_limits<double>::infinity();
    for (uint32_t k = flat ? 3 : 4; k <= count; ++k) {
      const double here = gap_of(cluster_[k - 1]) - lowest + 1.0;
      const double behind = k < count ? gap_of(cluster_[k]) - lowest - 1.0 : 4.0 * reach_of(cube.half);
      if (behind > ratio * here) {
        ratio = behind / here;
        size = k;
        next = behind;
        spread = here;
      }
    }
    if (size == 0) continue;
    const Span<uint32_t> tied = cluster_.part(0, size);
    for (const uint32_t ball : tied) nearest_centre = smaller_of(nearest_centre, distance(balls, ball, x));
    see_directions(tied, to_double(x));
    double off_plane = 0.0;
    const Span<const Vec3> way = hull_.part(0, size), from = room_.part(0, size);
    const double depth = flat ? depth_in_plane(way, from, off_plane) : depth_of_hull(way);
    if (!(depth > 0.0)) continue;
    spread += 4.0 * off_plane;
    const double delta = smaller_of(0.5 * next, 0.49 * depth * nearest_centre / (1.5 + depth));
    const double searched = delta / root_of_three - 4.0;
    const double around = spread / (0.45 * depth) + 4.0;  // beyond which no point is critical
    if (!(searched > around) || searched < 0.125 * static_cast<double>(cube.half)) continue;
    cube.searched_centre = x;
    cube.searched_half = static_cast<int64_t>(searched);
    sort_ascending(tied);
    const Block left{x, static_cast<double>(static_cast<int64_t>(around)) + 1.0},
        own{cube.centre, static_cast<double>(cube.half + 1)};
    if (!meet(left, own)) return;
    // If all of them tie exactly, their common point is the only one.
    uint32_t four[4];
    TangentPoint all(lines());
    bool tie = !flat && find_far_apart(balls, tied, four) &&
               all.find(balls, {four[0], four[1], four[2]}, four[3], rising) && all.level_against(floor_) > 0;
    for (uint32_t k = 0; tie && k < size; ++k) tie = all.nearness(tied[k]) == 0;
    if (!tie) {
      if (size <= CubeDirections::room) {
        directions_[0].set(target_, near_arrays(tied), to_double(left.centre), left.half + 2.0);
        static_cast<void>(directions_[0].compare(target_, size));
      }
      try_leaf(tied, left, own, flat ? PointKind::gate : PointKind::maximum, cube.last);
    } else if (is_in(all, own)) {
      add(all, four, PointKind::maximum, tied);
    }
    return;
  }
}

}  // namespace hsp
