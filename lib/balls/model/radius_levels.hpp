// A second index, for sets whose cubes a few large balls make so wide that most balls around one are too far away.
// Balls are put in levels by their radii, the largest of one less than twice its smallest, and those of each level in
// cubes of four times its largest radius: a ball no larger looks at eight of them. The few largest balls are in no cube
// but looked at always. Ids and the order of results stay those of the grid, so that nobody sees which index answered.
//
// Cubes are buckets of a hash without keys: balls of several may share one, and of two that are asked for both may have
// the same. So there are no probes, and a set whose cubes are chosen to share is left to the wide cubes.
#pragma once

#include "core/small_code.hpp"
#include "model/grid_order.hpp"
#include "model/ordered_balls.hpp"
#include "model/query_hits.hpp"

namespace hsp {

// Numbers of an index that is given up, for another one.
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
  // In smaller sets all balls are looked at in no more time.
  static constexpr uint32_t fewest_balls = 1024;

  // Whether an index may save work, as far as cubes tell.
  static bool may_save_work(const OrderedBalls &order);
  // There is an index afterwards if one does. It is in that memory; links are used meanwhile.
  void build(OrderedBalls &order, const IndexMemory &memory);
  void clear() {
    if (!small_code) buckets_ = 0;
  }
  bool is_there() const { return !small_code && buckets_ != 0; }
  // Of the kernels, and whether queries are in lanes.
  void use(Target target, bool lanes) {
    if (small_code) return;
    target_ = target;
    lanes_ = lanes;
  }

  // The balls that meet a query, in the grid's order, which `excluded` is of, too; ascending. Returns their number, or
  // one above `room` if they may be more, or if the query reaches so far that others are asked sooner.
  uint32_t find(const QueryBall &query, uint32_t *ids, uint32_t room) const;
  // Those other than itself that meet ball i.
  uint32_t find_neighbours(const BallSet &balls, uint32_t i, uint32_t *ids, uint32_t room) const {
    return find({balls.x[i], balls.y[i], balls.z[i], balls.r[i], i}, ids, room);
  }

  // Calls visit(first, last) for all buckets with balls that may meet a query: for up to eight that follow each other
  // and none of which but the first is a multiple of eight; some may be the same. False, after no call or some, if they
  // would be very many.
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
  // Of buckets first .. last - 1.
  BallRange balls_in(uint32_t first, uint32_t last) const { return {first_[first], first_[last]}; }

 private:
  struct Level {
    CubeAxis axis{1};
    double largest = 0.0;  // radius
  };
  class Found;

  // Radii are below 2^30, and four classes of them make a factor of two.
  static constexpr uint32_t most_levels = 32, classes = 124;
  static constexpr int64_t in_a_row = 8;  // buckets
  static uint32_t class_of(double radius);
  bool make_levels(const OrderedBalls &order, uint8_t (&level_of)[classes]);
  void put(OrderedBalls &order, const uint8_t (&level_of)[classes]);
  [[gnu::cold]] void find_middle(const OrderedBalls &order);
  // Of cubes in a row most are buckets in a row, so that their balls follow each other in memory.
  uint32_t bucket_of(uint32_t level, const CubeCoordinates &cube) const {
    const int64_t in_row = cube.x & (in_a_row - 1);
    const uint64_t linear = level * UINT64_C(0xD1B54A32D192ED03) + linear_hash({cube.x - in_row, cube.y, cube.z});
    return (CubeProbe(linear, buckets_).slot & ~uint32_t{in_a_row - 1}) | static_cast<uint32_t>(in_row);
  }

  uint32_t buckets_;  // 0: there is no index, and nothing else is set
  const BallSet *balls_;
  Level *levels_;         // [most_levels]
  Span<uint32_t> first_;  // [buckets + 2] the last bucket is of the largest balls
  Span<uint32_t> ball_;   // [n and behind] by buckets, in the grid's order
  Span<float> rounded_;   // [4 n and behind] the same from the middle of the box, x, y, z, r of each side by side
  double middle_[3];      // integers
  double extent_;         // from the middle along any axis no centre is further
  uint32_t level_count_;
  Target target_;
  bool lanes_;
};

}  // namespace hsp
