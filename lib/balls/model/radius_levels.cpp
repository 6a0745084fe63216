// As an example 20,000 balls of radius 1.6, thirty of radius 3 and one of radius 20:
//
//   level          balls             side of its cubes    looked at by a ball of 1.6
//   -              one of 20         none                 always
//   0              thirty of 3       4 * 3   = 12         cubes within 1.6 + 3   on each axis: at most 8
//   1              20,000 of 1.6     4 * 1.6 = 6.4        cubes within 1.6 + 1.6 on each axis: at most 8
//
// The grid's own cubes are 2 * 20 = 40 wide, so that a ball would look at 27 of them, which hold nearly everything.
#include "model/radius_levels.hpp"

#include <bit>
#include <cmath>

#include "core/sorting.hpp"

namespace hsp {
namespace {

// Up to so many of the largest balls are in no cube, and every query looks at them.
constexpr uint32_t most_large = 16;
// An index is worth while if the cube of a ball has so many balls, on average over all balls.
constexpr double many_pairs_a_ball = 32;
// The level of the largest balls.
constexpr uint8_t large_ball = 255;

// The sum, over all cubes, of the squares of their numbers of balls: how often balls look at balls of their own cubes.
double pairs_in(Span<const uint32_t> first, uint32_t cubes) {
  double pairs = 0.0;
  for (uint32_t cube = 0; cube < cubes; ++cube) {
    const double count = first[cube + 1] - first[cube];
    pairs += count * count;
  }
  return pairs;
}

}  // namespace

// Finds the hits in buckets. It tests balls in batches, no more at a time than QueryHits has room for.
class RadiusLevels::Found {
 public:
  Found(const RadiusLevels &levels, const QueryBall &query, uint32_t *ids, uint32_t room)
      : levels_(levels), balls_(*levels.balls_), query_(query), ids_(ids), room_(room) {
    const double reach = query.r + static_cast<double>(balls_.largest_radius);
    from_middle_ = {{static_cast<float>(query.x - levels.middle_[0]), static_cast<float>(query.y - levels.middle_[1]),
                     static_cast<float>(query.z - levels.middle_[2]), static_cast<float>(query.r)},
                    static_cast<float>(doubt_within(levels.extent_, reach))};
    hits_.count = 0;
  }

  // Adds the balls of some buckets, as visit_buckets() gives them. A branch on the number of balls could not be
  // predicted. So every eight balls, which are tested at once, are a range of their own, as are all balls behind the
  // first 16.
  void add(uint32_t first, uint32_t last) {
    uint64_t &seen = seen_[first / 64 % seen_words];
    const uint64_t bits = ((uint64_t{1} << (last - first)) - 1) << first % 64;
    repeated_ |= seen & bits;
    seen |= bits;
    const BallRange range = levels_.balls_in(first, last);
    const uint32_t count = range.last - range.first;
    if (count > QueryHits::room - asked_ || ranges_ > most_ranges - 3) [[unlikely]]
      return add_parts(range);
    const auto before_last = [&range](uint32_t end) { return range.last < end ? range.last : end; };
    range_[ranges_] = {range.first, before_last(range.first + at_once)};
    ranges_ += static_cast<uint32_t>(count > 0);
    range_[ranges_] = {range.first + at_once, before_last(range.first + 2 * at_once)};
    ranges_ += static_cast<uint32_t>(count > at_once);
    range_[ranges_] = {range.first + 2 * at_once, range.last};
    ranges_ += static_cast<uint32_t>(count > 2 * at_once);
    asked_ += count;
  }
  uint32_t end() {
    look();
    if (found_ == 0 && repeated_ == 0) {
      if (hits_.count > 0 && hits_.count <= room_) write_all();
      return hits_.count;
    }
    store();
    if (found_ > room_) return found_;
    sort_ascending(Span<uint32_t>(ids_, found_));
    uint32_t kept = 0;
    for (uint32_t k = 0; k < found_; ++k) {
      if (kept == 0 || ids_[k] != ids_[kept - 1]) ids_[kept++] = ids_[k];
    }
    return kept;
  }

 private:
  static constexpr uint32_t most_ranges = 40, seen_words = 8, at_once = 8;

  void add_parts(BallRange range) {
    for (; !range.empty(); range.first = range_[0].last) {
      flush();
      const uint32_t count = range.last - range.first;
      asked_ = count < QueryHits::room ? count : QueryHits::room;
      range_[0] = {range.first, range.first + asked_};
      ranges_ = 1;
    }
  }

  uint32_t look_in_floats() {
    const float *const rounded = levels_.rounded_.data();
    const uint32_t *const ids = levels_.ball_.data();
    if constexpr (has_lanes) {
      if (levels_.lanes_) {
        return near_query_in_lanes(levels_.target_, from_middle_, rounded, ids, range_, ranges_, hits_.ids);
      }
    }
    return near_query(from_middle_, rounded, ids, range_, ranges_, hits_.ids);
  }
  // Balls that may meet by floats are tested again in doubles.
  [[gnu::noinline]] void look() {
    const uint32_t near = look_in_floats();
    uint32_t met = 0;
    for (uint32_t k = 0; k < near; ++k) {
      const uint32_t j = hits_.ids[k];
      hits_.ids[met] = j;
      const bool meets =
          meet(balls_.x[j] - query_.x, balls_.y[j] - query_.y, balls_.z[j] - query_.z, balls_.r[j] + query_.r);
      met += static_cast<uint32_t>(meets) & static_cast<uint32_t>(j != query_.excluded);
    }
    hits_.count = met;
  }
  void store() {
    for (uint32_t k = 0; k < hits_.count && found_ + k < room_; ++k) ids_[found_ + k] = hits_.ids[k];
    found_ += hits_.count;
  }
  void flush() {
    look();
    store();
    hits_.count = ranges_ = asked_ = 0;
  }
  void write_all() {
    if constexpr (has_lanes) {
      if (levels_.lanes_) return write_ascending_in_lanes(levels_.target_, hits_, ids_, room_);
    }
    write_ascending(hits_, ids_);
  }

  const RadiusLevels &levels_;
  const BallSet &balls_;
  const QueryBall query_;
  uint32_t *const ids_;
  const uint32_t room_;
  uint32_t found_ = 0;               // number of hits of earlier batches; they are stored as far as there is room
  uint64_t seen_[seen_words] = {};   // a bit for each bucket that was visited; several buckets share a bit
  uint64_t repeated_ = 0;            // not 0 if a bucket may have been visited twice
  BallRange range_[most_ranges];     // of this batch
  uint32_t ranges_ = 0, asked_ = 0;  // number of these ranges, and of their balls
  RoundedQueryBall from_middle_;
  QueryHits hits_;
};

uint32_t RadiusLevels::class_of(double radius) {
  if (radius < 1.0) return 0;
  constexpr uint64_t one = std::bit_cast<uint64_t>(1.0) >> 50;
  return static_cast<uint32_t>((std::bit_cast<uint64_t>(radius) >> 50) - one) + 1;
}

// Whether many balls seem to be small for their cubes. This does not look at the balls.
bool RadiusLevels::may_save_work(const OrderedBalls &order) {
  const BallSet &balls = order.balls();
  const bool some_are_small = balls.smallest_radius >= 0 && 8 * balls.smallest_radius <= order.side();
  return balls.n >= fewest_balls && (some_are_small || balls.n / 16 >= order.cubes()) &&
         pairs_in(order.first_ball(), order.cubes()) >= many_pairs_a_ball * balls.n;
}

void RadiusLevels::build(OrderedBalls &order, const IndexMemory &memory) {
  const uint32_t n = order.balls().n;
  buckets_ = 0;
  balls_ = &order.balls();
  levels_ = reinterpret_cast<Level *>(memory.words.data());
  uint8_t level_of[classes] = {};
  find_middle(order);
  if (extent_ > most_extent_of_reach * static_cast<double>(balls_->largest_radius)) return;
  if (!make_levels(order, level_of)) return;
  buckets_ = std::bit_floor(n) / 2;
  const uint32_t before = most_levels * sizeof(Level) / sizeof(uint32_t), behind = before + buckets_ + 2;
  static_assert(fewest_balls / 2 >= most_levels * sizeof(Level) / sizeof(uint32_t) + 2 + BallSet::read_behind);
  first_ = memory.words.part(before, behind);
  ball_ = memory.words.part(behind, behind + n + BallSet::read_behind);
  rounded_ = memory.roundings;
  put(order, level_of);
  // A query looks at 8 cubes of a level instead of 27. Other levels, and hits that come one by one, cost as much again.
  // If there are more hits than QueryHits has room for, they are sorted, which takes five times as long as all that.
  const double pairs = pairs_in(first_, buckets_), looked_at = pairs > double{QueryHits::room} * n ? 96.0 : 16.0;
  if (looked_at * pairs > 27.0 * pairs_in(order.first_ball(), order.cubes())) buckets_ = 0;
}

void RadiusLevels::find_middle(const OrderedBalls &order) {
  const CubeCoordinates &low = order.cube_list().low(), &high = order.cube_list().high();
  const int64_t corner[3][2] = {{low.x, high.x}, {low.y, high.y}, {low.z, high.z}};
  const auto side = static_cast<double>(order.side());
  extent_ = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [first, last] = corner[axis];
    const int64_t before = (last - first) / 2 + 1, behind = last + 1 - (first + before);
    middle_[axis] = static_cast<double>(first + before) * side;
    const double extent = static_cast<double>(before > behind ? before : behind) * side;
    extent_ = extent > extent_ ? extent : extent_;
  }
}

// Makes levels, from the largest radii on. Returns whether at least half of the balls get cubes no wider than those of
// the grid.
bool RadiusLevels::make_levels(const OrderedBalls &order, uint8_t (&level_of)[classes]) {
  const BallSet &balls = order.balls();
  uint32_t count[classes] = {};
  double largest[classes] = {};
  for (uint32_t i = 0; i < balls.n; ++i) {
    const uint32_t of = class_of(balls.r[i]);
    ++count[of];
    largest[of] = balls.r[i] > largest[of] ? balls.r[i] : largest[of];
  }
  level_count_ = 0;
  uint32_t large = 0, small = 0, first_class = classes;
  for (uint32_t of = classes; of-- > 0;) {
    if (count[of] == 0) continue;
    if (level_count_ == 0 && large + count[of] <= most_large) {
      large += count[of];
      level_of[of] = large_ball;
      continue;
    }
    if (level_count_ == 0 || first_class - of >= 4) {
      first_class = of;
      const auto side = static_cast<int64_t>(4.0 * largest[of]);
      levels_[level_count_++] = {CubeAxis(side > 0 ? side : 1), largest[of]};
    }
    level_of[of] = static_cast<uint8_t>(level_count_ - 1);
    if (levels_[level_count_ - 1].axis.side() <= order.side()) small += count[of];
  }
  return small >= balls.n / 2;
}

// Puts the balls into their buckets by a counting sort.
void RadiusLevels::put(OrderedBalls &order, const uint8_t (&level_of)[classes]) {
  const BallSet &balls = order.balls();
  const Span<uint32_t> bucket = order.scratch_links();
  for (uint32_t b = 0; b < buckets_ + 2; ++b) first_[b] = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const uint32_t level = level_of[class_of(balls.r[i])];
    bucket[i] = level == large_ball ? buckets_ : bucket_of(level, levels_[level].axis.cube_at(balls.ball(i).centre));
    ++first_[bucket[i]];
  }
  for (uint32_t b = 1; b < buckets_ + 2; ++b) first_[b] += first_[b - 1];
  for (uint32_t i = balls.n; i-- > 0;) {
    const uint32_t to = --first_[bucket[i]];
    ball_[to] = i;
    float *const ball = &rounded_[4 * to];
    ball[0] = static_cast<float>(balls.x[i] - middle_[0]);
    ball[1] = static_cast<float>(balls.y[i] - middle_[1]);
    ball[2] = static_cast<float>(balls.z[i] - middle_[2]);
    ball[3] = static_cast<float>(balls.r[i]);
  }
  for (uint32_t k = 0; k < BallSet::read_behind; ++k) ball_[balls.n + k] = 0;
  for (uint32_t k = 0; k < 4 * BallSet::read_behind; ++k) rounded_[4 * balls.n + k] = 0.0F;
}

uint32_t RadiusLevels::find(const QueryBall &query, uint32_t *ids, uint32_t room) const {
  // A query farther away meets nothing, and the error bounds of floats would not hold for it.
  const double farthest = extent_ + query.r + static_cast<double>(balls_->largest_radius);
  const double centre[3] = {query.x, query.y, query.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(centre[axis] - middle_[axis]) > farthest) return 0;
  }
  Found found(*this, query, ids, room);
  return visit_buckets(query, [&](uint32_t first, uint32_t last) { found.add(first, last); }) ? found.end() : no_id;
}

}  // namespace hsp
