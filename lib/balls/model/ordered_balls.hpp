// The balls of a set in grid order (grid_order.hpp), and the cubes of side 2 r_max that hold them (Section 3). Each
// ball is stored once, in the cube of its centre. The centres of two balls that meet are in the same cube or in
// neighbouring cubes, so that 27 cubes hold all neighbours of a ball.
//
// A set may end with images that only surround the others, as in a periodic box. They come behind all others in grid
// order, in the cubes of a halo.
#pragma once

#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "model/ball_range.hpp"
#include "model/ball_set.hpp"
#include "model/cube_list.hpp"
#include "model/halo.hpp"

namespace hsp {

class CubeAxis;
struct GridOrder;

class OrderedBalls {
 public:
  // Carves the arrays for at most n balls; with a measuring workspace it only counts.
  void carve(Workspace &workspace, uint32_t n);

  const BallSet &balls() const { return balls_; }
  uint32_t capacity() const { return capacity_; }
  int64_t side() const { return side_; }
  // The index in grid order of the caller's ball.
  uint32_t grid_index(uint32_t caller) const { return grid_index_[caller]; }

  uint32_t cubes() const { return cubes_.count(); }
  const CubeList &cube_list() const { return cubes_; }
  // The numbers of balls and cubes without images. These balls and cubes come first.
  uint32_t own_balls() const { return own_balls_; }
  uint32_t own_cubes() const { return own_cubes_; }
  bool has_images() const { return own_balls_ < balls_.n; }
  const Halo &halo() const { return halo_; }
  BallRange balls_in(uint32_t cube) const { return balls_of(cube, cube + 1); }
  // The balls of cubes first .. last - 1.
  BallRange balls_of(uint32_t first, uint32_t last) const { return {first_ball_[first], first_ball_[last]}; }
  Span<const uint32_t> first_ball() const { return first_ball_; }
  CubeCoordinates cube_at(const exact::Vector &point) const { return cube_at(point, side_); }
  static CubeCoordinates cube_at(const exact::Vector &point, int64_t side);

  // Scratch memory of one number for each ball.
  Span<uint32_t> scratch_links() { return scratch_links_; }

 protected:
  void clear();
  // Sort balls for the three build() of CubeGrid. idle: scratch memory, two numbers for each ball or four. If
  // `patience` allows no more work, there are no balls.
  Status sort(const BallInput &input, Span<uint32_t> idle, uint32_t &first_bad, Patience &patience);
  void sort(const BallSet &given, uint32_t own, Span<uint32_t> idle, Patience &patience);
  void sort(const BallSet &balls, Span<const uint32_t> slot, int64_t side, Span<uint32_t> idle, Patience &patience);

 private:
  Status store_all(const BallRounding &rounding, uint32_t n, uint32_t &first_bad, int64_t &largest);
  template <class Source>
  void sort(const Source &source, const BallSet &given, const LatticeBox &box, uint32_t own, Span<uint32_t> idle,
            Patience &patience);
  template <class Source>
  GridOrder order_of(const Source &source, const BallSet &given, const LatticeBox &box, const CubeAxis &axis,
                     BallRange part, Span<uint32_t> idle, Patience &patience);
  template <class Source>
  void put(const Source &source, const CubeAxis &axis, BallRange part, const GridOrder &order, int64_t lift,
           Patience &patience);
  template <class Source>
  void put_some(const Source &source, const CubeAxis &axis, BallRange part, const GridOrder &order, int64_t lift,
                BallRange some);

  BallSet balls_;
  CubeList cubes_;
  Span<uint32_t> first_ball_;  // [cubes + 1, and at least 4]
  Span<uint32_t> grid_index_;  // [n] caller -> grid order
  Span<uint32_t> scratch_links_;
  uint32_t capacity_ = 0;
  uint32_t own_balls_ = 0, own_cubes_ = 0;
  Halo halo_;
  int64_t side_ = 1;
};

}  // namespace hsp
