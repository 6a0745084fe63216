// Brings balls from the caller's order into grid order.
//
// As an example centres on the x axis, in cubes of side 5:
//   the caller's ball     0   1   2   3
//   x                     7   1  12   3
//   cube                  1   0   2   0
// Ball by ball of the grid: cube 0 has the caller's balls 1 and 3, cube 1 has 0, cube 2 has 2. So
//   caller       1 3 0 2       for each ball in grid order, its index in the caller's order
//   grid_index   2 0 3 1       for each ball in the caller's order, its index in grid order
#include "model/ordered_balls.hpp"

#include "core/ahead.hpp"
#include "core/small_code.hpp"
#include "model/grid_order.hpp"

namespace hsp {
namespace {

// So many balls are still in a near cache when their cubes are looked at.
constexpr uint32_t balls_in_block = 512;

// Balls of an input that all fit the lattice, in the caller's order.
struct InputBalls {
  BallRounding rounding;

  void fetch(uint32_t i) const { rounding.fetch(i); }
  exact::LatticeBall ball(uint32_t i) const {
    if (!small_code) return rounding.ball(i);
    exact::LatticeBall ball;
    static_cast<void>(rounding.round(i, ball));
    return ball;
  }
  exact::Vector centre(uint32_t i) const { return rounding.centre(i); }
};
// Balls that are on a lattice: in the caller's order, or by their slots in a set.
struct GivenBalls {
  const BallSet &balls;

  static void fetch(uint32_t) {}
  exact::LatticeBall ball(uint32_t i) const { return balls.ball(i); }
  exact::Vector centre(uint32_t i) const { return ball(i).centre; }
};
struct PlacedBalls {
  const BallSet &balls;
  Span<const uint32_t> slot;

  static void fetch(uint32_t) {}
  exact::LatticeBall ball(uint32_t i) const { return balls.ball(slot[i]); }
  exact::Vector centre(uint32_t i) const { return ball(i).centre; }
};

// The balls of a source from number `first` on.
template <class Source>
struct BallsFrom {
  Source source;
  uint32_t first;

  void fetch(uint32_t i) const { source.fetch(first + i); }
  exact::LatticeBall ball(uint32_t i) const { return source.ball(first + i); }
  exact::Vector centre(uint32_t i) const { return source.centre(first + i); }
};

template <class Source>
LatticeBox box_around(const Source &source, BallRange part) {
  LatticeBox box;
  for (uint32_t i = part.first; i < part.last; ++i) {
    const exact::Vector centre = source.centre(i);
    if (i == part.first) box = {centre, centre};
    CubeList::widen(centre.x, box.low.x, box.high.x);
    CubeList::widen(centre.y, box.low.y, box.high.y);
    CubeList::widen(centre.z, box.low.z, box.high.z);
  }
  return box;
}

}  // namespace

CubeCoordinates OrderedBalls::cube_at(const exact::Vector &point, int64_t side) {
  return CubeAxis(side).cube_at(point);
}

void OrderedBalls::carve(Workspace &workspace, uint32_t n) {
  capacity_ = n;
  cubes_.take(workspace.take<CubeCoordinates>(n));
  first_ball_ = workspace.take<uint32_t>(n < 4 ? 4 : static_cast<uint64_t>(n) + 1);
  const auto two_for_each = workspace.take<uint32_t>(2 * static_cast<uint64_t>(n));
  if (!two_for_each.empty()) {
    grid_index_ = two_for_each.part(0, n);
    scratch_links_ = two_for_each.part(n, 2 * n);
  }
  balls_.carve(workspace, n);
}

void OrderedBalls::clear() {
  balls_.n = 0;
  own_balls_ = own_cubes_ = 0;
  static_cast<void>(exact::Lattice::for_largest_radius(0.0, 0.0, balls_.lattice));
  balls_.probe_steps = 0;
  balls_.largest_radius = 0;
  balls_.smallest_radius = no_radius;
  side_ = 1;
  cubes_.clear();
  first_ball_[0] = 0;
}

// The grid order of a part of the balls. Small code compares the given balls; else the source's balls are sorted by
// keys.
template <class Source>
GridOrder OrderedBalls::order_of(const Source &source, const BallSet &given, const LatticeBox &box,
                                 const CubeAxis &axis, BallRange part, Span<uint32_t> idle, Patience &patience) {
  const auto of_part = [part](Span<uint32_t> two_for_each) { return two_for_each.part(2 * part.first, 2 * part.last); };
  const Span<uint32_t> entries = of_part(idle);
  if (small_code) {
    BallSet some;
    some.x = given.x.part(part.first, part.last);
    some.y = given.y.part(part.first, part.last);
    some.z = given.z.part(part.first, part.last);
    some.r = given.r.part(part.first, part.last);
    some.caller = given.caller.part(part.first, part.last);
    some.n = part.last - part.first;
    return grid_order_by_comparing(some, axis, entries);
  }
  // If idle memory has room for both arrays of entries, it is used: a set with few cubes then touches less memory.
  const bool has_both = idle.size() / 4 >= capacity_;
  const Span<uint32_t> other_entries =
      of_part(has_both ? idle.part(2 * capacity_, 4 * capacity_) : Span(grid_index_.data(), 2 * grid_index_.size()));
  return grid_order(BallsFrom<Source>{source, part.first}, box, axis, {entries, other_entries, first_ball_}, patience);
}

// Puts a part of the balls, in its order, to the same slots, and appends its cubes. The processor cannot predict where
// a cube begins. So each ball is written as the first ball of the next cube, and is kept there if a cube begins.
template <class Source>
void OrderedBalls::put(const Source &source, const CubeAxis &axis, BallRange part, const GridOrder &order, int64_t lift,
                       Patience &patience) {
  constexpr uint32_t at_once = 32 * balls_in_block;
  const uint32_t n = order.size();
  if (small_code) return put_some(source, axis, part, order, lift, {0, n});
  for (uint32_t first = 0, last = 0; first < n && patience.allows(200 * at_once); first = last) {
    last = n - first < at_once ? n : first + at_once;
    put_some(source, axis, part, order, lift, {first, last});
  }
}

// Puts some of these balls, behind those that have been put before. A call of its own, so that this loop has the
// registers.
template <class Source>
HSP_APART_UNLESS_SMALL void OrderedBalls::put_some(const Source &given, const CubeAxis &axis, BallRange part,
                                                   const GridOrder &order, int64_t lift, BallRange some) {
  const BallsFrom<Source> source{given, part.first};  // a copy: the compiler knows that it is not written to
  const uint32_t n = order.size();
  const bool is_far = !small_code && n > ahead::few_balls;
  const auto store = [&](uint32_t k) {
    const exact::LatticeBall ball = source.ball(order.ball(k));
    balls_.store(part.first + k, ball);
    grid_index_[part.first + order.ball(k)] = part.first + k;
    return ball;
  };
  uint32_t sorted_before = order.keys_tell_cubes ? 0 : n;  // before that, balls of one slice are in order
  uint64_t last_key = ~UINT64_C(0);                        // no ball's
  CubeCoordinates last_cube{};
  int64_t last_x = 0;
  if (some.first > 0) {
    const exact::Vector last = balls_.ball(part.first + some.first - 1).centre;
    last_key = order.cube_key(some.first - 1);
    last_cube = axis.cube_at(last);
    last_x = last.x;
  }
  for (uint32_t block = some.first; block < some.last; block += balls_in_block) {
    const uint32_t end = some.last - block < balls_in_block ? some.last : block + balls_in_block;
    uint32_t cubes = cubes_.count();
    for (uint32_t k = block; k < end; ++k) {
      if (is_far && k + ahead::input_balls < n) {
        const uint32_t later = order.ball(k + ahead::input_balls);
        source.fetch(later);
        __builtin_prefetch(&grid_index_[part.first + later], 1);
      }
      const exact::LatticeBall ball = store(k);
      bool begins = true;
      if (order.keys_tell_cubes) {
        const uint64_t key = order.cube_key(k);
        begins = key != last_key;
        last_key = key;
      } else {
        const CubeCoordinates cube = axis.cube_at(ball.centre);
        begins = k == 0 || !(cube == last_cube);
        last_cube = cube;
      }
      first_ball_[cubes] = part.first + k;
      cubes += static_cast<uint32_t>(begins);
      const bool out_of_order = static_cast<unsigned>(!begins) & static_cast<unsigned>(last_x >= ball.centre.x);
      last_x = ball.centre.x;
      if (!small_code && out_of_order && k >= sorted_before) {
        const BallRange run = sort_slice(source, order, k);
        sorted_before = run.last;
        for (uint32_t again = run.first; again <= k; ++again) last_x = store(again).centre.x;
      }
    }
    while (cubes_.count() < cubes) {
      CubeCoordinates cube = axis.cube_at(balls_.ball(first_ball_[cubes_.count()]).centre);
      cube.z += lift;
      cubes_.push(cube);
    }
  }
}

// For small code: stores all balls in the caller's order.
Status OrderedBalls::store_all(const BallRounding &rounding, uint32_t n, uint32_t &first_bad, int64_t &largest) {
  exact::LatticeBall ball;
  for (uint32_t i = 0; i < n; ++i) {
    if (const Status status = rounding.round(i, ball); status != Status::ok) {
      first_bad = i;
      return status;
    }
    balls_.store(i, ball);
    largest = ball.radius > largest ? ball.radius : largest;
  }
  return Status::ok;
}

Status OrderedBalls::sort(const BallInput &input, Span<uint32_t> idle, uint32_t &first_bad, Patience &patience) {
  clear();
  BallRounding rounding;
  if (const Status status = rounding.prepare(input, first_bad); status != Status::ok) return status;

  // Every ball is rounded twice, for its cube and then into its slot: that is cheaper than a second copy of the set.
  LatticeBox box;
  int64_t largest = 0;
  if (small_code) {
    if (const Status status = store_all(rounding, input.n, first_bad, largest); status != Status::ok) return status;
  } else if (input.n > 0) {
    if (const Status status = rounding.find_box(box, first_bad); status != Status::ok) return status;
    largest = rounding.largest_radius();
  }
  balls_.largest_radius = largest;
  balls_.smallest_radius = rounding.smallest_radius();
  const int64_t radius = rounding.expected_radius() > largest ? rounding.expected_radius() : largest;
  side_ = radius > 0 ? 2 * radius : 1;
  balls_.n = input.n;
  balls_.lattice = rounding.lattice();
  balls_.probe_steps = rounding.probe_steps();
  sort(InputBalls{rounding}, balls_, box, input.n, idle, patience);
  return patience.allows(0) ? Status::ok : Status::stopped;
}

void OrderedBalls::sort(const BallSet &given, uint32_t own, Span<uint32_t> idle, Patience &patience) {
  clear();
  balls_.largest_radius = given.largest_radius;
  balls_.n = given.n;
  balls_.lattice = given.lattice;
  balls_.probe_steps = given.probe_steps;
  side_ = given.largest_radius > 0 ? 2 * given.largest_radius : 1;
  const GivenBalls source{given};
  sort(source, given, box_around(source, {0, own}), own, idle, patience);
}

void OrderedBalls::sort(const BallSet &balls, Span<const uint32_t> slot, int64_t side, Span<uint32_t> idle,
                        Patience &patience) {
  clear();
  const PlacedBalls placed{balls, slot};
  const uint32_t n = slot.size();
  for (uint32_t i = 0; i < n; ++i) {
    const exact::LatticeBall ball = placed.ball(i);
    balls_.largest_radius = ball.radius > balls_.largest_radius ? ball.radius : balls_.largest_radius;
    const bool is_least = balls_.smallest_radius == no_radius || ball.radius < balls_.smallest_radius;
    if (ball.radius > 0 && is_least) balls_.smallest_radius = ball.radius;
    if (small_code) balls_.store(i, ball);
  }
  side_ = side;
  balls_.n = n;
  balls_.lattice = balls.lattice;
  balls_.probe_steps = balls.probe_steps;
  sort(placed, balls_, box_around(placed, {0, n}), n, idle, patience);
}

// box: around the own balls. given: the balls as they are given. In small code `given` may be the output array, as
// `source` has the balls, too.
template <class Source>
void OrderedBalls::sort(const Source &source, const BallSet &given, const LatticeBox &box, uint32_t own,
                        Span<uint32_t> idle, Patience &patience) {
  const uint32_t n = balls_.n;
  const CubeAxis axis(side_);
  const GridOrder order = order_of(source, given, box, axis, {0, own}, idle, patience);
  GridOrder images{};
  int64_t lowest = 0;
  if (own < n) {
    const LatticeBox box_of_images = box_around(source, {own, n});
    images = order_of(source, given, box_of_images, axis, {own, n}, idle, patience);
    lowest = axis.cube_at(box_of_images.low.z);
  }
  if (!patience.allows(0)) return clear();
  put(source, axis, {0, own}, order, 0, patience);
  own_balls_ = own;
  own_cubes_ = cubes_.count();
  if (own < n) {
    halo_.begin(cubes_, lowest);
    put(source, axis, {own, n}, images, halo_.lift(), patience);
    halo_.end(cubes_, own_cubes_);
  }
  if (!patience.allows(0)) return clear();
  first_ball_[cubes_.count()] = n;
}

}  // namespace hsp
