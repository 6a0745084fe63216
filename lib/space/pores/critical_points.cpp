#include "pores/critical_points.hpp"

#include <bit>
#include <initializer_list>

#include "core/extremes.hpp"
#include "core/sorting.hpp"
#include "exact/lattice.hpp"
#include "pores/cube_halves.hpp"

namespace hsp {
namespace {

using exact::Vector;

constexpr uint32_t few = 5;          // balls all sets of which are tried
constexpr uint32_t most_cubes = 64;  // that are being halved: from 2^52 steps down to the least
constexpr int64_t least_half = 4;
constexpr uint32_t many = 12;          // balls for which a leaf is divided further
constexpr double least_fine = 0x1p-8;  // half a side of what it is divided into
constexpr uint32_t most_fine_cubes = 64;
constexpr uint32_t most_led_up = 1 << 14;

Vec3 centre_of(const BallSet &balls, uint32_t ball) {
  return {balls.x[ball], balls.y[ball], balls.z[ball]};
}
double distance(const BallSet &balls, uint32_t ball, const Vector &from) {
  const double x = balls.x[ball] - static_cast<double>(from.x), y = balls.y[ball] - static_cast<double>(from.y),
               z = balls.z[ball] - static_cast<double>(from.z);
  return std::sqrt(x * x + y * y + z * z);
}
// How far a point of a cube is from its centre, and a step more.
double reach_of(int64_t half) {
  return static_cast<double>(half + 2) * root_of_three * (1.0 + 0x1p-50);
}
// Bound of what is wrong with a computed distance: its differences are integers, its relative error below 3 2^-53.
double doubt_of(double distance) {
  return 0x1p-50 * distance;
}
// The first one lowest; written so that compilers find one load in it.
uint64_t eight_bytes(const uint8_t *p) {
  const auto byte = [&](uint32_t k) { return static_cast<uint64_t>(p[k]) << 8 * k; };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}
bool contains(const Vector &centre, int64_t half, const Vector &other, int64_t other_half) {
  const int64_t room = half - other_half;
  const auto within = [&](int64_t a, int64_t b) { return a - b <= room && b - a <= room; };
  return within(centre.x, other.x) && within(centre.y, other.y) && within(centre.z, other.z);
}

// +1 and -1 if it is certain whether a point is in a cube, its sides included.
int may_be_in(const TangentPoint &point, const CriticalPoints::Block &block) {
  const Vec3 off = point.place_estimate() - to_double(block.centre) - block.off;
  const double most = longest_part(off), doubt = point.place_error();
  return most > block.half + doubt ? -1 : most < block.half - doubt ? 1 : 0;
}
bool is_in(const TangentPoint &point, const CriticalPoints::Block &block) {
  const int certain = may_be_in(point, block);
  if (certain != 0) return certain > 0;
  const int64_t middle[3] = {block.centre.x, block.centre.y, block.centre.z};
  const double off[3] = {block.off.x, block.off.y, block.off.z};
  for (uint32_t axis = 0; axis < 3; ++axis) {
    if (point.against(axis, middle[axis], off[axis] - block.half) < 0 ||
        point.against(axis, middle[axis], off[axis] + block.half) > 0) {
      return false;
    }
  }
  return true;
}
// Four balls that are far apart; false if all centres are in one plane.
bool find_far_apart(const BallSet &balls, Span<const uint32_t> near, uint32_t *set) {
  for (uint32_t k = 0; k < 4; ++k) set[k] = near[0];
  for (uint32_t turn = 0; turn < 3; ++turn) {
    double best = 0.0;
    const Vec3 u = balls.difference(set[0], set[1]), v = balls.difference(set[0], set[2]);
    for (const uint32_t ball : near) {
      const Vec3 w = balls.difference(set[0], ball), n = cross(u, turn == 1 ? w : v);
      const double size = turn == 0 ? dot(w, w) : turn == 1 ? dot(n, n) : std::fabs(dot(n, w));
      if (size > best) {
        best = size;
        set[turn + 1] = ball;
      }
    }
    if (best == 0.0) return false;
  }
  return true;
}
bool meet(const CriticalPoints::Block &a, const CriticalPoints::Block &b) {
  return longest_part(to_double(a.centre) + a.off - to_double(b.centre) - b.off) <= a.half + b.half;
}

}  // namespace

void CriticalPoints::carve(Workspace &workspace, const CriticalLimits &limits) {
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
  lines_ = workspace.take<TangentLines>(1);
  directions_ = workspace.take<CubeDirections>(1);
  hull_ = workspace.take<Vec3>(limits.near);
  room_ = workspace.take<Vec3>(limits.near);
  inverse_ = workspace.take<double>(limits.near);
  fine_cubes_ = workspace.take<FineCube>(most_fine_cubes);
}

Status CriticalPoints::find(PoreBalls &balls, int64_t floor) {
  all_ = &balls;
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
    const BallSet &set = balls.set();
    Vec3 low{set.x[0], set.y[0], set.z[0]}, high = low;
    for (uint32_t i = 0; i < set.n; ++i) {
      const auto cover = [](double x, double &least, double &most) {
        least = x < least ? x : least;
        most = x > most ? x : most;
      };
      cover(set.x[i], low.x, high.x);
      cover(set.y[i], low.y, high.y);
      cover(set.z[i], low.z, high.z);
    }
    return search(low, high);
  }
  // Images as far from the box as balls can be nearest: as is guessed, until it is sure to suffice.
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

// In a box of space. Finds nothing if beyond_ceiling_ is not 0 then.
Status CriticalPoints::search(const Vec3 &low, const Vec3 &high) {
  const BallSet &balls = *balls_;
  forget();
  needed_.candidates = larger_count(needed_.candidates, balls.n);
  if (balls.n > limits_.candidates) return Status::capacity;
  for (uint32_t i = 0; i < balls.n; ++i) candidates_[i] = i;
  low_ = low;
  high_ = high;
  const double extent = larger_of(larger_of(high_.x - low_.x, high_.y - low_.y), high_.z - low_.z);
  int64_t half = least_half;
  while (static_cast<double>(half) < 0.6 * extent + 2.0) half *= 2;
  // Not in the middle, so that points of symmetry are no corners of cubes.
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
    if (cube.next_part == 0) halve(cube);
    const uint32_t part = cube.next_part++;
    const int64_t step = cube.half / 2;
    const auto moved = [&](int64_t at, uint32_t axis) { return (part >> axis & 1) != 0 ? at + step : at - step; };
    Cube &child = cubes_[depth];  // in its place, should it be halved
    child.centre = {moved(cube.centre.x, 0), moved(cube.centre.y, 1), moved(cube.centre.z, 2)};
    child.half = step;
    child.settled_centre = cube.settled_centre;
    child.settled_half = cube.settled_half;
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
    if (near.size() <= few || child.half <= least_half) {
      const Block own{child.centre, static_cast<double>(child.half + 1)};
      try_leaf(near, own, own, PointKind::passing, child.last);
      if (needed_.near > limits_.near || needed_.candidates > limits_.candidates) return Status::capacity;
      continue;
    }
    // Ties do not become fewer.
    if (9 * near.size() >= 8 * (cube.last - cube.first)) settle_ties(child);
    if (needed_.near > limits_.near || needed_.candidates > limits_.candidates) return Status::capacity;
    if (!is_settled(child)) ++depth;
  }
  needed_.maxima = clamped_count(maxima_.required());
  needed_.gates = clamped_count(gates_.required());
  needed_.tied = clamped_count(tied_.required());
  if (maxima_.overflowed() || gates_.overflowed() || tied_.overflowed()) return Status::capacity;
  return beyond_reach_ ? Status::range : Status::ok;
}

bool CriticalPoints::is_settled(const Cube &cube) const {
  return cube.settled_half != 0 && contains(cube.settled_centre, cube.settled_half, cube.centre, cube.half);
}

NearArrays CriticalPoints::near_arrays(Span<const uint32_t> ids) const {
  const BallSet &balls = *balls_;
  return {balls.x.data(), balls.y.data(), balls.z.data(), balls.r.data(), ids.data(), ids.size()};
}

// Which candidates of a cube may be nearest in each of its parts. f is at most the distance of the farthest corner of a
// part from any one ball, of which one is near its middle; a ball that is farther from all of the part is nowhere
// nearest in it.
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
  const NearArrays near{balls.x.data(), balls.y.data(),           balls.z.data(),
                        balls.r.data(), &candidates_[cube.first], cube.last - cube.first};
  find_nearest(target_, near, parts);
  for (uint32_t part = 0; part < 8; ++part) {
    const uint32_t ball = parts.nearest[part];
    const Vec3 corner{std::fabs(balls.x[ball] - parts.x[part]) + parts.edge,
                      std::fabs(balls.y[ball] - parts.y[part]) + parts.edge,
                      std::fabs(balls.z[ball] - parts.z[part]) + parts.edge};
    const double farthest = std::sqrt(dot(corner, corner)), radius = balls.r[ball];
    parts.most_level[part] = cube.most_level[part] = farthest + doubt_of(farthest + radius) - radius;
  }
  find_near(target_, near, parts, &in_parts_[cube.first]);
}

// Puts the candidates of a cube that may be nearest in a part of it behind these; returns where they end. Nothing is
// put if no critical point is there.
uint32_t CriticalPoints::enter(const Cube &cube, const Cube &whole, uint32_t part) {
  ++work_.cubes;
  unsure_ = false;
  const uint32_t first = whole.first, last = whole.last;
  const double most_level = whole.most_level[part];
  const double x = static_cast<double>(cube.centre.x), y = static_cast<double>(cube.centre.y),
               z = static_cast<double>(cube.centre.z), side = static_cast<double>(cube.half + 1);
  if (x - side > high_.x || x + side < low_.x || y - side > high_.y || y + side < low_.y || z - side > high_.z ||
      z + side < low_.z || is_settled(cube)) {
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
  if (count < 3) return last;
  const Vec3 at{x, y, z};
  const double reach_along = static_cast<double>(cube.half + 3);
  if (count <= CubeDirections::room)
    return last + leave_few(at, reach_along, last, count, count == most && count > few);
  // More become fewer, as a rule.
  return last + (9 * count < 8 * most ? count : leave_many(at, reach_along, last, count));
}

// Of candidates of a cube leaves those that may be nearest in it at a critical point, and returns how many. No more
// than directions_ has room for.
[[gnu::always_inline]] inline uint32_t CriticalPoints::leave_few(const Vec3 &at, double half, uint32_t first,
                                                                 uint32_t count, bool thoroughly) {
  CubeDirections &directions = directions_[0];
  directions.set(target_, near_arrays(candidates_.part(first, first + count)), at, half);
  const uint32_t left = drop_farther(first, count);
  if (left < 3 || directions.lead_up(left)) return 0;
  return thoroughly && directions.lead_up_at_all(left) ? 0 : left;
}
uint32_t CriticalPoints::leave_many(const Vec3 &at, double half, uint32_t first, uint32_t count) {
  if (count > limits_.near || count > most_led_up) return count;
  see_directions(candidates_.part(first, first + count), at);
  const auto a = [&](uint32_t k) { return hull_[k]; };
  const auto inverse = [&](uint32_t k) { return inverse_[k]; };
  return lead_up_at_all(count, half, a, inverse) ? 0 : count;
}

// From the centres of balls to a place.
void CriticalPoints::see_directions(Span<const uint32_t> near, const Vec3 &at) {
  for (uint32_t k = 0; k < near.size(); ++k) {
    const Vec3 y = at - centre_of(*balls_, near[k]);
    const double length = std::sqrt(dot(y, y));
    inverse_[k] = length > 0.0 ? 1.0 / length : 0.0;
    hull_[k] = inverse_[k] * y;
    room_[k] = y;
  }
}

// Leaves out candidates that are farther than another one in all of the cube; how many stay.
uint32_t CriticalPoints::drop_farther(uint32_t first, uint32_t count) {
  CubeDirections &directions = directions_[0];
  const uint64_t dropped = directions.compare(target_, count);
  if (dropped == 0) return count;
  uint32_t left = 0;
  for (uint64_t rest = ~dropped & ~UINT64_C(0) >> (64 - count); rest != 0; rest &= rest - 1) {
    const auto k = static_cast<uint32_t>(std::countr_zero(rest));
    directions.move(k, left);
    candidates_[first + left++] = candidates_[first + k];
  }
  return left;
}

// Where all of a cube's candidates tie, or nearly: tries their sets at once.
void CriticalPoints::settle_ties(Cube &cube) {
  const BallSet &balls = *balls_;
  const Span<const uint32_t> near = candidates_.part(cube.first, cube.last);
  const uint32_t count = near.size();
  if (count > most_led_up) return;
  // Near the centres of balls nothing can be settled that is as large as a part of the cube.
  for (const uint32_t ball : near) {
    if (distance(balls, ball, cube.centre) < 4.0 * static_cast<double>(cube.half)) return;
  }
  needed_.near = larger_count(needed_.near, count);
  if (count > limits_.near) return;
  uint32_t set[4];
  const bool solid = find_far_apart(balls, near, set);
  if (set[2] == set[0]) return;
  // Both points of four balls, and that of three in their plane.
  for (const int attempt : {0, 1, 2}) {
    const bool rising = attempt == 1, flat = attempt == 2;
    TangentPoint point(lines());
    if ((!solid && !flat) || !point.find(balls, {set[0], set[1], set[2]}, flat ? no_id : set[3], rising)) continue;
    const Vec3 at = point.place_estimate();
    if (!(std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z) < 0x1p52)) continue;
    const Vector x{nearest(at.x), nearest(at.y), nearest(at.z)};
    if (!contains(cube.centre, 2 * cube.half, x, 0)) continue;
    if (cube.settled_half != 0 && contains(cube.settled_centre, cube.settled_half, x, 0)) return;
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
    const double settled = delta / root_of_three - 4.0;
    const double around = spread / (0.45 * depth) + 4.0;  // beyond which no point is critical
    if (!(settled > around) || settled < 0.125 * static_cast<double>(cube.half)) continue;
    cube.settled_centre = x;
    cube.settled_half = static_cast<int64_t>(settled);
    sort_in_place(tied, [](uint32_t a, uint32_t b) { return a < b; });
    const Block left{x, static_cast<double>(static_cast<int64_t>(around)) + 1.0},
        own{cube.centre, static_cast<double>(cube.half + 1)};
    if (!meet(left, own)) return;
    // Where all of them tie exactly, that is the one point.
    uint32_t four[4];
    TangentPoint all(lines());
    bool tie = !flat && find_far_apart(balls, tied, four) &&
               all.find(balls, {four[0], four[1], four[2]}, four[3], rising) && all.level_against(floor_) > 0;
    for (uint32_t k = 0; tie && k < size; ++k) tie = all.nearness(tied[k]) == 0;
    beyond_reach_ = beyond_reach_ || all.beyond_reach();
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

// All points of a leaf. Its candidates are in directions_ if that has room for them; candidates_ are free from `last`
// on.
void CriticalPoints::try_leaf(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone,
                              uint32_t last) {
  needed_.near = larger_count(needed_.near, near.size());
  if (near.size() > limits_.near) return;
  if (near.size() <= few) return try_sets(near, block, other, alone);
  if (try_common_point(near, block, other)) return;
  bool fits = longest_part(to_double(block.centre)) < 0x1p43;
  for (const uint32_t ball : near) fits = fits && distance(*balls_, ball, block.centre) < 0x1p40;
  if (near.size() <= many || !fits) return try_sets(near, block, other, alone);
  try_finely(near, block, other, last);
}

// Halves a leaf down to parts of steps, in which its candidates become fewer but for those that tie exactly.
void CriticalPoints::try_finely(Span<const uint32_t> near, const Block &block, const Block &other, uint32_t last) {
  const uint32_t count = near.size();
  needed_.candidates = larger_count(needed_.candidates, clamped_count(static_cast<uint64_t>(last) + count));
  if (count > limits_.candidates - last) return;
  for (uint32_t k = 0; k < count; ++k) candidates_[last + k] = near[k];
  double half = least_fine;
  while (half < block.half) half *= 2.0;
  uint32_t depth = 0;
  fine_cubes_[depth++] = {{0.0, 0.0, 0.0}, half, last, last + count, 0};
  while (depth > 0) {
    FineCube &cube = fine_cubes_[depth - 1];
    if (cube.next_part == 8) {
      --depth;
      continue;
    }
    const uint32_t part = cube.next_part++;
    FineCube &child = fine_cubes_[depth];
    child.half = 0.5 * cube.half;
    const auto moved = [&](double at, uint32_t axis) {
      return (part >> axis & 1) != 0 ? at + child.half : at - child.half;
    };
    child.off = {moved(cube.off.x, 0), moved(cube.off.y, 1), moved(cube.off.z, 2)};
    child.next_part = 0;
    const Block own{block.centre, child.half, child.off};
    if (!meet(own, block) || !meet(own, other)) continue;
    child.first = cube.last;
    child.last = enter(child, cube, own);
    if (needed_.candidates > limits_.candidates) return;
    const Span<const uint32_t> here = candidates_.part(child.first, child.last);
    if (here.empty()) continue;
    if (here.size() > few && child.half > least_fine) {
      ++depth;
      continue;
    }
    if (here.size() > few && try_common_point(here, own, other)) continue;
    // try_common_point() sees other balls.
    if (here.size() > few && here.size() <= CubeDirections::room) {
      directions_[0].set(target_, near_arrays(here), to_double(own.centre) + own.off, own.half);
      static_cast<void>(directions_[0].compare(target_, here.size()));
    }
    try_sets(here, own, other, PointKind::passing);
  }
}

// Puts the candidates of a part of a leaf behind those of the whole, as enter() does for cubes.
uint32_t CriticalPoints::enter(const FineCube &cube, const FineCube &whole, const Block &block) {
  const uint32_t last = whole.last, most = last - whole.first;
  needed_.candidates = larger_count(needed_.candidates, clamped_count(static_cast<uint64_t>(last) + most));
  if (most > limits_.candidates - last) return last;
  const Vec3 at = to_double(block.centre) + cube.off;
  const double reach = root_of_three * cube.half * (1.0 + 0x1p-40);
  double least = std::numeric_limits<double>::infinity();  // upper bound of f at the middle
  for (uint32_t k = 0; k < most; ++k) {
    const uint32_t ball = candidates_[whole.first + k];
    const Vec3 y = at - centre_of(*balls_, ball);
    const double length = std::sqrt(dot(y, y)), gap = length - balls_->r[ball];
    const double doubt = 0x1p-49 * (length + balls_->r[ball]);
    inverse_[k] = gap - doubt;
    least = smaller_of(least, gap + doubt);
  }
  if (least + reach < static_cast<double>(floor_)) return last;
  uint32_t count = 0;
  for (uint32_t k = 0; k < most; ++k) {
    if (inverse_[k] <= least + 2.0 * reach) candidates_[last + count++] = candidates_[whole.first + k];
  }
  if (count < 3) return last;
  return last + (count <= CubeDirections::room ? leave_few(at, block.half, last, count, true)
                                               : leave_many(at, block.half, last, count));
}

// Whether all candidates of a leaf tie at one point that is near. Then that is its one critical point, but for sets
// that are nearly flat: let q be another one and D bound how far it is from the common point p. Balls that span q all
// tie at both, or are three with q in the plane of their centres and p beside it. Of the first the distances of p and
// q differ by less than D^2 / 2 (rho - D), as 0 is a mean of their directions at q, rho the least distance of the
// centres: so their directions are at right angles to that from q to p, up to D / 2 (rho - D). In both cases three of
// these make a flat angle.
bool CriticalPoints::try_common_point(Span<const uint32_t> near, const Block &block, const Block &other) {
  const BallSet &balls = *balls_;
  uint32_t set[4];
  const bool solid = find_far_apart(balls, near, set);
  if (set[2] == set[0]) return false;
  const Vec3 middle = to_double(block.centre) + block.off;
  double nearest_centre = std::numeric_limits<double>::infinity();
  for (const uint32_t ball : near) {
    const Vec3 y = middle - centre_of(balls, ball);
    nearest_centre = smaller_of(nearest_centre, std::sqrt(dot(y, y)));
  }
  for (const int attempt : {0, 1, 2}) {
    const bool rising = attempt == 1, flat = attempt == 2;
    TangentPoint point(lines());
    if ((!solid && !flat) || !point.find(balls, {set[0], set[1], set[2]}, flat ? no_id : set[3], rising)) continue;
    const Vec3 to = point.place_estimate() - middle;
    const double apart = std::sqrt(dot(to, to)) + point.place_error() + root_of_three * block.half;
    if (!(16.0 * apart < nearest_centre)) continue;
    bool tie = true;
    for (uint32_t k = 0; tie && k < near.size(); ++k) tie = point.nearness(near[k]) == 0;
    beyond_reach_ = beyond_reach_ || point.beyond_reach();
    if (!tie) continue;
    if (point.level_against(floor_) > 0 && is_in(point, block) && is_in(point, other)) {
      for (uint32_t k = 0; k < near.size(); ++k) at_point_[k] = near[k];
      const Span<uint32_t> tied = at_point_.part(0, near.size());
      sort_in_place(tied, [](uint32_t a, uint32_t b) { return a < b; });
      const PointKind kind = kind_of(balls, point, tied, room_);
      // Found anew by its name.
      constexpr uint32_t unnamed[4] = {no_id, no_id, no_id, no_id};
      if (kind != PointKind::passing) add(point, unnamed, kind, tied);
    }
    beyond_reach_ = beyond_reach_ || point.beyond_reach();
    point.find(balls, {set[0], set[1], set[2]}, flat ? no_id : set[3], rising);
    see_directions(near, middle);
    try_flat_sets(point, near, block, other, 8.0 * apart / nearest_centre + 1e-12);
    return true;
  }
  return false;
}

// Of balls that tie at a common point, and whose directions are known, the sets that are so flat.
void CriticalPoints::try_flat_sets(const TangentPoint &common, Span<const uint32_t> near, const Block &block,
                                   const Block &other, double flat) {
  const BallSet &balls = *balls_;
  const uint32_t n = near.size();
  KnownTies known;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      const Vec3 across = cross(hull_[i], hull_[j]);
      const auto is_flat = [&](uint32_t k) { return std::fabs(dot(across, hull_[k])) <= flat; };
      const bool apart = dot(across, across) > flat * flat;
      for (uint32_t k = j + 1; k < n; ++k) {
        if (!is_flat(k)) continue;
        const Vec3 to_first = cross(hull_[i], hull_[k]), to_second = cross(hull_[j], hull_[k]);
        const bool wide = apart || dot(to_first, to_first) > flat * flat || dot(to_second, to_second) > flat * flat;
        // In a plane with the point three of which two are not on a line with it have no other one.
        if (!wide || common.side_of_plane(near[i], near[j], near[k]) != 0) {
          const uint32_t three[4] = {near[i], near[j], near[k], no_id};
          static_cast<void>(try_point(three, 3, near, block, other, known));
        }
        for (uint32_t l = k + 1; l < n; ++l) {
          if (!is_flat(l) || std::fabs(dot(to_first, hull_[l])) > flat || std::fabs(dot(to_second, hull_[l])) > flat ||
              are_coplanar(balls, near[i], near[j], near[k], near[l])) {
            continue;
          }
          const uint32_t four[4] = {near[i], near[j], near[k], near[l]};
          static_cast<void>(try_point(four, 4, near, block, other, known));
        }
      }
    }
  }
  beyond_reach_ = beyond_reach_ || common.beyond_reach();
}

// All sets of three and four with points in both of two cubes, as seen from the first one; alone: of which kind a point
// where all of them tie is the only critical one in the first.
void CriticalPoints::try_sets(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone) {
  ++work_.leaves;
  const uint32_t n = near.size();
  needed_.near = larger_count(needed_.near, n);
  if (n > limits_.near) return;
  const bool directed = n <= CubeDirections::room;
  const CubeDirections &directions = directions_[0];
  // Which of them can be as near in the cube, by bits.
  uint64_t ties[CubeDirections::room];
  for (uint32_t i = 0; i < n && directed; ++i) ties[i] = 0;
  for (uint32_t i = 0; i < n && directed; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      if (directions.may_tie(i, j)) ties[i] |= UINT64_C(1) << j;
    }
  }
  const auto tie = [&](uint32_t i, uint32_t j) { return !directed || (ties[i] >> j & 1) != 0; };
  // Faces of few balls are kept, each being that of several tetrahedra.
  CubeDirections::Face faces[few * (few - 1) * (few - 2) / 6];
  const auto place = [](uint32_t i, uint32_t j, uint32_t k) { return k * (k - 1) * (k - 2) / 6 + j * (j - 1) / 2 + i; };
  const bool kept = n <= few;
  for (uint32_t i = 0; kept && i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      for (uint32_t k = j + 1; k < n; ++k) {
        if (tie(i, j) && tie(i, k) && tie(j, k)) faces[place(i, j, k)] = directions.face(i, j, k);
      }
    }
  }
  CubeDirections::Face made[4];
  const auto face = [&](uint32_t i, uint32_t j, uint32_t k, uint32_t corner) -> const CubeDirections::Face & {
    if (kept) return faces[place(i, j, k)];
    made[corner] = directions.face(i, j, k);
    return made[corner];
  };
  KnownTies known;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      if (!tie(i, j)) continue;
      for (uint32_t k = j + 1; k < n; ++k) {
        if (!tie(i, k) || !tie(j, k)) continue;
        const CubeDirections::Face &own = directed ? face(i, j, k, 3) : made[3];
        const uint32_t three[4] = {near[i], near[j], near[k], no_id};
        if (!directed || !directions.is_outside(own, i, j, k)) {
          ++work_.triples;
          if (try_point(three, 3, near, block, other, known) && alone == PointKind::gate) return;
        }
        for (uint32_t l = k + 1; l < n; ++l) {
          if (!tie(i, l) || !tie(j, l) || !tie(k, l)) continue;
          if (directed && (directions.separates(own, l) || directions.separates(face(i, j, l, 2), k) ||
                           directions.separates(face(i, k, l, 1), j) || directions.separates(face(j, k, l, 0), i))) {
            continue;
          }
          if (directed && directions.is_nearly_flat(own, l)) {
            const uint64_t some = UINT64_C(1) << i | UINT64_C(1) << j | UINT64_C(1) << k | UINT64_C(1) << l;
            if (known.are_in_plane(some) || are_coplanar(*balls_, near[i], near[j], near[k], near[l])) continue;
          }
          ++work_.quadruples;
          const uint32_t four[4] = {near[i], near[j], near[k], near[l]};
          if (try_point(four, 4, near, block, other, known) && alone == PointKind::maximum) return;
        }
      }
    }
  }
}

// Whether the point of a set is a critical one where all balls that are near tie.
bool CriticalPoints::try_point(const uint32_t *ids, uint32_t count, Span<const uint32_t> near, const Block &block,
                               const Block &other, KnownTies &known) {
  const BallSet &balls = *balls_;
  TangentPoint point(lines());
  const bool found = point.find(balls, {ids[0], ids[1], ids[2]}, count == 3 ? no_id : ids[3], false);
  if (!found) {
    beyond_reach_ = beyond_reach_ || point.beyond_reach();
    return false;
  }
  // Most are elsewhere.
  if (may_be_in(point, block) < 0 || may_be_in(point, other) < 0) return false;
  bool kept = point.level_against(floor_) > 0 && !(count == 3 ? are_collinear(balls, ids[0], ids[1], ids[2])
                                                              : are_coplanar(balls, ids[0], ids[1], ids[2], ids[3]));
  kept = kept && is_in(point, block) && is_in(point, other);
  bool on_side = false;
  kept = kept && (count == 3 ? is_in_triangle(balls, point, ids[0], ids[1], ids[2], on_side)
                             : is_in_tetrahedron(balls, point, ids, on_side));
  uint32_t tied = 0;
  uint64_t ties = 0;
  for (uint32_t k = 0; kept && k < near.size(); ++k) {
    const int sign = point.nearness(near[k]);
    kept = sign >= 0;
    if (sign != 0) continue;
    at_point_[tied++] = near[k];
    ties |= k < 64 ? UINT64_C(1) << k : 0;
  }
  // Where 0 is in the hull of the directions from some balls the largest of their distances is least, so that such a
  // point of the same balls is the same one.
  if (kept && near.size() <= 64 && tied > count) {
    for (uint32_t k = 0; k < known.size; ++k) {
      if (known.set[k] == ties) return tied == near.size();
    }
  }
  const PointKind kind = count == 3 ? PointKind::gate : PointKind::maximum;
  if (kept) kept = (tied == count && !on_side) || kind_of(balls, point, at_point_.part(0, tied), room_) == kind;
  if (kept && near.size() <= 64 && known.size < KnownTies::room) {
    known.in_plane[known.size] = kind == PointKind::gate;
    known.set[known.size++] = ties;
  }
  if (kept) add(point, ids, kind, at_point_.part(0, tied));
  beyond_reach_ = beyond_reach_ || point.beyond_reach();
  return kept && tied == near.size();
}

// As they are found in all copies: by balls of the box and shifts from the first of them.
PointName CriticalPoints::name_of_ids(const uint32_t *ids, uint32_t count) {
  PointName name{{no_id, no_id, no_id, no_id}, {}};
  const BoxShift first = all_->shift_of(ids[0]);
  for (uint32_t k = 0; k < count; ++k) {
    name.ball[k] = all_->ball_of(ids[k]);
    const BoxShift shift = all_->shift_of(ids[k]) - first;
    beyond_reach_ = beyond_reach_ || !SmallShift::fits(shift);
    name.shift[k] = SmallShift::of(shift);
  }
  return name;
}

void CriticalPoints::add(TangentPoint &point, const uint32_t *ids, PointKind kind, Span<uint32_t> tied) {
  const BallSet &balls = *balls_;
  const uint32_t count = kind == PointKind::gate ? 3 : 4;
  sort_in_place(tied, [&](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
  uint32_t set[4];
  name_of(balls, point, tied, kind, room_, set);
  const PointName name = name_of_ids(set, count);
  if ((kind == PointKind::gate ? gate_names_.find(name, gates_) : maximum_names_.find(name, maxima_)) != no_id) return;
  // By the same balls in the same order, whatever set has found it.
  bool same = true;
  for (uint32_t k = 0; k < count; ++k) same = same && set[k] == ids[k];
  if (!same) static_cast<void>(point.find(balls, {set[0], set[1], set[2]}, count == 3 ? no_id : set[3], false));
  CriticalPoint record{};
  record.tied = tied.size();
  Vec3 off{};
  record.doubt = point.settle_from_base(off, record.level);
  const BoxShift home = all_->shift_of(set[0]);
  for (uint32_t k = 0; k < all_->translations(); ++k) add_moved(record, off, name, kind, tied, home, k);
}

// A point where a translation takes it.
void CriticalPoints::add_moved(CriticalPoint record, const Vec3 &off, const PointName &name, PointKind kind,
                               Span<const uint32_t> tied, const BoxShift &from, uint32_t translation) {
  const BallSet &balls = *balls_;
  const uint32_t count = kind == PointKind::gate ? 3 : 4;
  const PointName own = translation == 0 ? name : moved_name(name, translation);
  if (translation != 0 &&
      (kind == PointKind::gate ? gate_names_.find(own, gates_) : maximum_names_.find(own, maxima_)) != no_id) {
    return;
  }
  record.first_tied = clamped_count(tied_.required());
  for (uint32_t k = 0; k < 4; ++k) {
    record.ball[k] = own.ball[k];
    record.shift[k] = own.shift[k];
  }
  const uint32_t first = own.ball[0];
  record.place = Vec3{balls.x[first], balls.y[first], balls.z[first]} + off;
  if (kind == PointKind::gate) {
    gates_.push({record, {no_id, no_id}, {}, false, false, translation});
    gate_names_.add(own, clamped_count(gates_.required() - 1), gates_);
  } else {
    maxima_.push({record, no_id, no_id});
    maximum_names_.add(own, clamped_count(maxima_.required() - 1), maxima_);
  }
  // One that there was no room for may be found again.
  const bool stored = kind == PointKind::gate ? !gates_.overflowed() : !maxima_.overflowed();
  if (tied.size() == count || !stored) return;
  const BoxShift home = translation == 0 ? BoxShift{} : all_->moved_image(name.ball[0], BoxShift{}, translation).shift;
  for (const uint32_t ball : tied) {
    PoreBalls::Image image{all_->ball_of(ball), all_->shift_of(ball) - from};
    if (translation != 0) image = all_->moved_image(image.ball, image.shift, translation);
    tied_.push(image.ball);
    tied_shifts_.push(SmallShift::of(image.shift - home));
  }
}

PointName CriticalPoints::moved_name(const PointName &name, uint32_t translation) {
  PointName moved{{no_id, no_id, no_id, no_id}, {}};
  BoxShift home;
  for (uint32_t k = 0; k < 4 && name.ball[k] != no_id; ++k) {
    const PoreBalls::Image image = all_->moved_image(name.ball[k], name.shift[k].shift(), translation);
    if (k == 0) home = image.shift;
    beyond_reach_ = beyond_reach_ || !SmallShift::fits(image.shift - home);
    moved.ball[k] = image.ball;
    moved.shift[k] = SmallShift::of(image.shift - home);
  }
  return moved;
}

}  // namespace hsp
