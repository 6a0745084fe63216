// A second index, for sets with a few large balls. These make the grid's cubes so wide that most balls around a small
// ball are too far away. Balls are put into levels by their radii; the largest radius of a level is less than twice its
// smallest. The balls of each level are in cubes of side four times the level's largest radius, so that a query ball no
// larger than that looks at eight of these cubes. The few largest balls are in no cube and are always looked at. Ids
// and the order of results are those of the grid: results do not show which index was used.
//
// The cubes are buckets of a hash table without keys: several cubes may share a bucket, also two cubes that one query
// looks at. So there are no probe sequences. A set whose cubes are chosen to share buckets is left to the wide cubes.
#pragma once

#include "core/small_code.hpp"
#include "model/grid_order.hpp"
#include "model/ordered_balls.hpp"
#include "model/query_hits.hpp"

namespace hsp {

// Memory of an index that is given up, for another one.
struct IndexMemory {
  Span<uint32_t> words;   // [at least 2 n]
  Span<float> roundings;  // [4 n and behind]
};

class RadiusLevels {
 public:
  RadiusLevels() {
    clear();
    use(Target::baseline, false);
  }
  // In smaller sets it takes no more time to look at all balls.
  static constexpr uint32_t fewest_balls = 1024;

  // Whether an index may save work, judged by the numbers of balls in the grid's cubes.
  static bool may_save_work(const OrderedBalls &order);
  // Builds the index in the given memory if it saves work; is_there() tells. Uses order.scratch_links() meanwhile.
  void build(OrderedBalls &order, const IndexMemory &memory);
  void clear() {
    if (!small_code) buckets_ = 0;
  }
  bool is_there() const { return !small_code && buckets_ != 0; }
  // The target of the kernels, and whether queries use them.
  void use(Target target, bool lanes) {
    if (small_code) return;
    target_ = target;
    lanes_ = lanes;
  }

  // Writes the balls that meet a query, ascending. Ids are in grid order, also query.excluded. Returns how many these
  // are. Returns a number above `room` if they may be more than `room`, or if the query reaches so far that another
  // search takes less time.
  uint32_t find(const QueryBall &query, uint32_t *ids, uint32_t room) const;
  // The same for the other balls that meet ball i.
  uint32_t find_neighbours(const BallSet &balls, uint32_t i, uint32_t *ids, uint32_t room) const {
    return find({balls.x[i], balls.y[i], balls.z[i], balls.r[i], i}, ids, room);
  }

  // Calls visit(first, last) for buckets first .. last - 1, until all buckets have been visited that may hold balls
  // that meet the query. In one call these are up to eight, and none but the first is a multiple of eight. A bucket may
  // be visited twice. False, perhaps after some calls, if there would be very many.
  template <class Visit>
  bool visit_buckets(const QueryBall &query, Visit visit) const {
    visit(buckets_, buckets_ + 1);
    double left = 64.0 + buckets_ / 4;
    for (uint32_t k = 0; k < level_count_; ++k) {
      const Level &level = levels_[k];
      const double reach = query.r + level.largest;
      const auto cube_at = [&level](double x, double y, double z) {
        return level.axis.cube_at({static_cast<int64_t>(x), static_cast<int64_t>(y), static_cast<int64_t>(z)});
      };
      const CubeCoordinates low = cube_at(query.x - reach, query.y - reach, query.z - reach);
      const CubeCoordinates high = cube_at(query.x + reach, query.y + reach, query.z + reach);
      left -= static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
              static_cast<double>(high.z - low.z + 1);
      if (left < 0.0) return false;
      for (int64_t z = low.z; z <= high.z; ++z) {
        for (int64_t y = low.y; y <= high.y; ++y) {
          for (int64_t x = low.x; x <= high.x;) {
            const int64_t end_of_row = (x | (in_a_row - 1)) + 1, end = high.x < end_of_row ? high.x + 1 : end_of_row;
            const uint32_t bucket = bucket_of(k, {x, y, z});
            visit(bucket, bucket + static_cast<uint32_t>(end - x));
            x = end;
          }
        }
      }
    }
    return true;
  }
  // The balls of buckets first .. last - 1, as positions in ball_.
  BallRange balls_in(uint32_t first, uint32_t last) const { return {first_[first], first_[last]}; }

 private:
  struct Level {
    CubeAxis axis{1};
    double largest = 0.0;  // the largest radius
  };
  class Found;

  // Radii are below 2^30. They are divided into classes, four for each factor of two.
  static constexpr uint32_t most_levels = 32, classes = 124;
  static constexpr int64_t in_a_row = 8;  // so many cubes along x have consecutive buckets
  static uint32_t class_of(double radius);
  bool make_levels(const OrderedBalls &order, uint8_t (&level_of)[classes]);
  void put(OrderedBalls &order, const uint8_t (&level_of)[classes]);
  [[gnu::cold]] void find_middle(const OrderedBalls &order);
  // Most neighbouring cubes along x have consecutive buckets, so that their balls follow each other in memory.
  uint32_t bucket_of(uint32_t level, const CubeCoordinates &cube) const {
    const int64_t in_row = cube.x & (in_a_row - 1);
    const uint64_t linear = level * UINT64_C(0xD1B54A32D192ED03) + linear_hash({cube.x - in_row, cube.y, cube.z});
    return (CubeProbe(linear, buckets_).slot & ~uint32_t{in_a_row - 1}) | static_cast<uint32_t>(in_row);
  }

  uint32_t buckets_;  // 0: there is no index, and nothing else is set
  const BallSet *balls_;
  Level *levels_;         // [most_levels]
  Span<uint32_t> first_;  // [buckets + 2] where each bucket begins in ball_; the last one is that of the largest balls
  Span<uint32_t> ball_;   // [n + read_behind] by bucket, and in each in grid order
  Span<float> rounded_;   // [4 (n + read_behind)] these balls relative to middle_: x, y, z, r of each side by side
  double middle_[3];      // of the box, integers
  double extent_;         // no centre is farther from the middle along any axis
  uint32_t level_count_;
  Target target_;
  bool lanes_;
};

}  // namespace hsp
