#include <bit>
#include <initializer_list>

#include "core/extremes.hpp"
#include "core/sorting.hpp"
#include "pores/critical_points.hpp"
#include "pores/search_blocks.hpp"

namespace hsp {
namespace {

// Half a side of the least parts that a leaf is divided into, and how much that may be where all balls are far away.
constexpr double least_fine = 0x1p-8, most_fine = 0x1p-4;

}  // namespace

// Finds all critical points of a leaf, as far as they are in `other`, too. The candidates of the leaf are in
// directions_ if that has room for them; candidates_ is free from `last` on.
void CriticalPoints::try_leaf(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone,
                              uint32_t last) {
  needed_.near = larger_count(needed_.near, near.size());
  if (near.size() > limits_.near) return;
  if (near.size() <= most_tried_whole) return try_sets(near, block, other, alone);
  if (try_common_point(near, block, other)) return;
  // Doubles have to know places in parts of the leaf exactly, and distances about as closely as the parts are wide.
  double least = least_fine, farthest = 0.0;
  for (const uint32_t ball : near) farthest = larger_of(farthest, distance(*balls_, ball, block.centre));
  while (least <= 0x1p-51 * longest_part(to_double(block.centre)) || least <= 0x1p-48 * farthest) least *= 2.0;
  if (near.size() <= most_in_leaf || least > most_fine) return try_sets(near, block, other, alone);
  try_finely(near, block, other, last, least);
}

// Halves a leaf down to parts whose half sides are `least`, as a rule fractions of a step. There its candidates become
// fewer, except for those that tie exactly.
void CriticalPoints::try_finely(Span<const uint32_t> near, const Block &block, const Block &other, uint32_t last,
                                double least_part) {
  const uint32_t count = near.size();
  needed_.candidates = larger_count(needed_.candidates, clamped_count(static_cast<uint64_t>(last) + count));
  if (count > limits_.candidates - last) return;
  for (uint32_t k = 0; k < count; ++k) candidates_[last + k] = near[k];
  double half = least_part;
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
    if (!patience_.allows(5000)) return;
    if (here.empty()) continue;
    // No candidate was dropped: perhaps all of them tie at one point.
    const bool least = child.half <= least_part, stay = here.size() == cube.last - cube.first;
    if (here.size() > most_tried_whole && (least || stay) && try_common_point(here, own, other)) continue;
    if (here.size() > most_tried_whole && !least) {
      ++depth;
      continue;
    }
    // directions_ has other balls if try_common_point() was called.
    if (here.size() > most_tried_whole && here.size() <= CubeDirections::room) {
      directions_[0].set(target_, near_arrays(here), to_double(own.centre) + own.off, own.half);
      static_cast<void>(directions_[0].compare(target_, here.size()));
    }
    try_sets(here, own, other, PointKind::passing);
  }
}

// Copies the candidates of a part of a leaf behind those of the whole, as enter() does for cubes.
uint32_t CriticalPoints::enter(const FineCube &cube, const FineCube &whole, const Block &block) {
  ++work_.cubes;
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
    const double error = 0x1p-49 * (length + balls_->r[ball]);
    inverse_[k] = gap - error;
    least = smaller_of(least, gap + error);
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

// Whether all candidates of a leaf tie at one point p that is near. Then p is its only critical point, except for sets
// that are nearly flat. Proof: let q be another critical point, D an upper bound of its distance from p, and rho the
// least distance of the centres. Either the balls that span q tie at both points, or they are three, q is in the plane
// of their centres, and p beside it. In the first case 0 is a mean of their directions at q, so that their distances
// from p and q differ by less than D^2 / 2 (rho - D). Hence their directions are at right angles to the one from q to
// p, up to D / 2 (rho - D). In both cases three of the directions are nearly in one plane.
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
    const Vec3 to = point.position_estimate() - middle;
    const double apart = std::sqrt(dot(to, to)) + point.position_error() + root_of_three * block.half;
    if (!(16.0 * apart < nearest_centre)) continue;
    bool tie = true;
    for (uint32_t k = 0; tie && k < near.size(); ++k) tie = point.nearness(near[k]) == 0;
    if (!tie) continue;
    see_directions(near, middle);
    const double nearly = 8.0 * apart / nearest_centre + 1e-12;
    uint32_t circle[3];
    const FlatSets sets = flat_sets(point, near, nearly, circle);
    try_tied(point, near, block, other, true);
    if (sets == FlatSets::one && point.find(balls, {circle[0], circle[1], circle[2]}, no_id, false)) {
      try_tied(point, near, block, other, false);
    }
    if (sets != FlatSets::any) return true;
    point.find(balls, {set[0], set[1], set[2]}, flat ? no_id : set[3], rising);
    try_flat_sets(point, near, block, other, nearly);
    return true;
  }
  return false;
}

// Adds a point of some of the balls `near` if it is critical, by all of these balls that tie there. all_tie: whether it
// is known that all of them do.
void CriticalPoints::try_tied(TangentPoint &point, Span<const uint32_t> near, const Block &block, const Block &other,
                              bool all_tie) {
  if (point.level_against(floor_) <= 0 || !is_in(point, block) || !is_in(point, other)) return;
  uint32_t size = 0;
  for (const uint32_t ball : near) {
    const int sign = all_tie ? 0 : point.nearness(ball);
    if (sign < 0) return;
    if (sign == 0) at_point_[size++] = ball;
  }
  const Span<uint32_t> tied = at_point_.part(0, size);
  sort_ascending(tied);
  const PointKind kind = kind_of(*balls_, point, tied, room_);
  // add() computes the point again, from the balls of its name.
  constexpr uint32_t unnamed[4] = {no_id, no_id, no_id, no_id};
  if (kind != PointKind::passing) add(point, unnamed, kind, tied);
}

// Which sets of balls that tie at a common point p may have another critical point q nearby. The directions a of the
// balls are in hull_. Let d be the distance from p to q, u the direction, t the level of p, and delta = d / (rho - d) a
// bound of how far directions turn on the way. 0 is a mean of the directions at q of the balls that span q: so at q
// these balls are no nearer than t - d delta. As distances are convex, no ball is farther at q than t + d (a.u +
// delta). So a.u >= -2 delta for all balls. On the way back from q to p the balls that span q get farther in the mean:
// at q they are no farther than t, and have a.u <= 0.
//   If 0 is inside the convex hull of all a by more than 2 delta, or outside it by delta, there is no q. `nearly` is
//   larger than 2 delta, and than the angle by which directions turn between p and the middle of the block.
//   Take the a that are at right angles to n up to `nearly`. If 0 is inside their hull by `depth`, as seen along n, u
//   is along n but for 1.5 nearly / depth, and all balls that span q are at right angles to n but for 3 nearly / depth.
//   If these are in one plane with p, q and u would be in that plane, too: there is no q. If they are equal balls with
//   their centres in one plane, the centres are on a circle, as the balls tie at p, and q is its middle.
CriticalPoints::FlatSets CriticalPoints::flat_sets(const TangentPoint &common, Span<const uint32_t> near, double nearly,
                                                   uint32_t *set) {
  const BallSet &balls = *balls_;
  const Span<const Vec3> a = hull_.part(0, near.size());
  Vec3 n{};
  if (depth_of_hull(a, &n) > nearly) return FlatSets::none;
  const double length = std::sqrt(dot(n, n));
  if (!(length > 0.0)) return FlatSets::any;
  n = (1.0 / length) * n;
  double farthest = -1.0;
  for (const Vec3 &direction : a) farthest = larger_of(farthest, dot(n, direction));
  if (farthest < -nearly) return FlatSets::none;
  uint32_t three[3];
  const double depth = nearly < 1e-4 ? depth_in_circle(a, n, nearly, three) : -1.0;
  if (!(depth > 0.01)) return FlatSets::any;
  const auto spans = [&](uint32_t k) { return std::fabs(dot(n, a[k])) <= 3.0 * nearly / depth; };
  // The widest corner of a triangle around 0.
  const Vec3 across[3] = {cross(a[three[0]], a[three[1]]), cross(a[three[1]], a[three[2]]),
                          cross(a[three[2]], a[three[0]])};
  uint32_t wide = 0;
  for (uint32_t k = 1; k < 3; ++k) wide = dot(across[k], across[k]) > dot(across[wide], across[wide]) ? k : wide;
  for (uint32_t k = 0; k < 3; ++k) set[k] = near[three[(wide + k) % 3]];
  bool on_circle = !are_collinear(balls, set[0], set[1], set[2]);
  for (uint32_t k = 0; k < near.size() && on_circle; ++k) {
    on_circle =
        !spans(k) || (balls.r[near[k]] == balls.r[set[0]] && are_coplanar(balls, set[0], set[1], set[2], near[k]));
  }
  if (on_circle) return FlatSets::one;
  for (uint32_t k = 0; k < near.size(); ++k) {
    if (spans(k) && near[k] != set[0] && near[k] != set[1] && common.side_of_plane(set[0], set[1], near[k]) != 0) {
      return FlatSets::any;
    }
  }
  return FlatSets::none;
}

// Tries the nearly flat sets of balls that tie at a common point, the directions of which are in hull_. flat: the
// height up to which a set of three directions is nearly flat.
void CriticalPoints::try_flat_sets(const TangentPoint &common, Span<const uint32_t> near, const Block &block,
                                   const Block &other, double flat) {
  const BallSet &balls = *balls_;
  const uint32_t n = near.size();
  KnownTies known;
  bool equal = true;
  for (const uint32_t ball : near) equal = equal && balls.r[ball] == balls.r[near[0]];
  const auto bit = [](uint32_t k) { return UINT64_C(1) << (k & 63); };
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      const Vec3 across = cross(hull_[i], hull_[j]);
      const auto is_flat = [&](uint32_t k) { return std::fabs(dot(across, hull_[k])) <= flat; };
      const bool apart = dot(across, across) > flat * flat;
      if (!patience_.allows(50 * uint64_t{n})) return;
      for (uint32_t k = j + 1; k < n; ++k) {
        if (!is_flat(k)) continue;
        if (!patience_.allows(2000 + 20 * uint64_t{n})) return;
        const Vec3 to_first = cross(hull_[i], hull_[k]), to_second = cross(hull_[j], hull_[k]);
        const bool wide = apart || dot(to_first, to_first) > flat * flat || dot(to_second, to_second) > flat * flat;
        // If the three span another point, 0 is a mean of their directions up to `flat`. If the products of two of them
        // with the third are opposite, these two have less than an eighth of the mean each, and the third has too much.
        const auto opposite = [&](const Vec3 &u, const Vec3 &v) {
          return dot(u, v) < 0.0 && dot(u, u) > 64.0 * flat * flat && dot(v, v) > 64.0 * flat * flat;
        };
        const bool beside =
            opposite(across, -to_first) || opposite(across, to_second) || opposite(to_second, -to_first);
        // The centres of equal balls are on one sphere around the point: four of them have no other point, and three
        // the middle of their circle.
        const bool found = equal && n <= 64 && known.are_in_plane(bit(i) | bit(j) | bit(k));
        // Three balls in a plane with the point, two of which are not on a line with it, have no other point.
        if (!beside && !found && (!wide || common.side_of_plane(near[i], near[j], near[k]) != 0)) {
          const uint32_t three[4] = {near[i], near[j], near[k], no_id};
          static_cast<void>(try_point(three, 3, near, block, other, known));
        }
        for (uint32_t l = k + 1; l < n && !equal; ++l) {
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
}

// Tries all sets of three and four balls whose points are in both of two cubes; directions_ sees the balls from the
// first one. alone: a point of this kind at which all balls tie is the only critical point in the first cube.
void CriticalPoints::try_sets(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone) {
  ++work_.leaves;
  const uint32_t n = near.size();
  needed_.near = larger_count(needed_.near, n);
  if (n > limits_.near) return;
  const bool directed = n <= CubeDirections::room;
  const CubeDirections &directions = directions_[0];
  // ties[i]: a bit for each ball j > i that can tie with ball i in the cube.
  uint64_t ties[CubeDirections::room];
  for (uint32_t i = 0; i < n && directed; ++i) ties[i] = 0;
  for (uint32_t i = 0; i < n && directed; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      if (directions.may_tie(i, j)) ties[i] |= UINT64_C(1) << j;
    }
  }
  const auto tie = [&](uint32_t i, uint32_t j) { return !directed || (ties[i] >> j & 1) != 0; };
  // The faces of few balls are kept, since each belongs to several tetrahedra.
  CubeDirections::Face faces[most_tried_whole * (most_tried_whole - 1) * (most_tried_whole - 2) / 6];
  const auto index = [](uint32_t i, uint32_t j, uint32_t k) { return k * (k - 1) * (k - 2) / 6 + j * (j - 1) / 2 + i; };
  const bool kept = n <= most_tried_whole;
  for (uint32_t i = 0; kept && i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      for (uint32_t k = j + 1; k < n; ++k) {
        if (tie(i, j) && tie(i, k) && tie(j, k)) faces[index(i, j, k)] = directions.face(i, j, k);
      }
    }
  }
  CubeDirections::Face made[4];
  const auto face = [&](uint32_t i, uint32_t j, uint32_t k, uint32_t corner) -> const CubeDirections::Face & {
    if (kept) return faces[index(i, j, k)];
    made[corner] = directions.face(i, j, k);
    return made[corner];
  };
  KnownTies known;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = i + 1; j < n; ++j) {
      if (!tie(i, j)) continue;
      for (uint32_t k = j + 1; k < n; ++k) {
        if (!tie(i, k) || !tie(j, k)) continue;
        if (!patience_.allows(200 * uint64_t{n})) return;
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

// Adds the point of a set if it is critical. Returns whether it is, and all the balls `near` tie there.
bool CriticalPoints::try_point(const uint32_t *ids, uint32_t count, Span<const uint32_t> near, const Block &block,
                               const Block &other, KnownTies &known) {
  const BallSet &balls = *balls_;
  TangentPoint point(lines());
  const bool found = point.find(balls, {ids[0], ids[1], ids[2]}, count == 3 ? no_id : ids[3], false);
  if (!found) return false;
  // Most points are in another cube.
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
  const PointKind kind = count == 3 ? PointKind::gate : PointKind::maximum;
  // If 0 is in the convex hull of the directions from some balls, the largest of their distances is least at the point.
  // So the same balls have only one such point. It may be a maximum that is in the plane of three of its balls, too.
  if (kept && near.size() <= 64 && tied > count) {
    for (uint32_t k = 0; k < known.size; ++k) {
      if (known.set[k] == ties) return tied == near.size() && known.in_plane[k] == (kind == PointKind::gate);
    }
  }
  if (kept) kept = (tied == count && !on_side) || kind_of(balls, point, at_point_.part(0, tied), room_) == kind;
  if (kept && near.size() <= 64 && known.size < KnownTies::room) {
    known.in_plane[known.size] = kind == PointKind::gate;
    known.set[known.size++] = ties;
  }
  if (kept) add(point, ids, kind, at_point_.part(0, tied));
  return kept && tied == near.size();
}

}  // namespace hsp
