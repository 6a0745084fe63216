#include "model/cube_grid.hpp"

#include "core/small_code.hpp"
#include "model/grid_order.hpp"

namespace hsp {
namespace {

// Balls of a large set are far from each other in the order of the input, and on their way while others are rounded.
constexpr uint32_t input_balls_ahead = 12;

// Balls on a lattice, as BallRounding gives those of an input: in the caller's order, or from places in a set.
struct GivenBalls {
  const BallSet &balls;

  static void fetch(uint32_t) {}
  void round(uint32_t i, exact::LatticeBall &ball) const { ball = balls.ball(i); }
};
struct PlacedBalls {
  const BallSet &balls;
  Span<const uint32_t> place;

  static void fetch(uint32_t) {}
  void round(uint32_t i, exact::LatticeBall &ball) const { ball = balls.ball(place[i]); }
};

}  // namespace

CubeCoordinates CubeGrid::cube_at(const exact::Vector &point, int64_t side) {
  return CubeAxis(side).cube_at(point);
}

void CubeGrid::carve(Workspace &workspace, uint32_t n) {
  capacity_ = n;
  wide_ = workspace.wide_code();
  const auto slots = workspace.take<uint32_t>(CubeTable::slots_for(n));
  const auto cubes = workspace.take<CubeCoordinates>(n);
  table_ = CubeTable(slots, cubes);
  first_ball_ = workspace.take<uint32_t>(static_cast<uint64_t>(n) + 1);
  grid_index_ = workspace.take<uint32_t>(n);
  balls_.carve(workspace, n);
  scratch_slots_ = workspace.take<uint32_t>(CubeTable::slots_for(n));
  scratch_links_ = workspace.take<uint32_t>(n);
#if HSP_AVX2
  if (has_row_directories) {
    rounded_ = workspace.take<float>(4 * (static_cast<uint64_t>(n) + BallSet::read_behind));
  }
#endif
}

void CubeGrid::clear() {
  balls_.n = 0;
  own_balls_ = own_cubes_ = 0;
  lift_ = last_own_layer_ = 0;
  static_cast<void>(exact::Lattice::for_largest_radius(0.0, 0.0, balls_.lattice));
  balls_.probe_steps = 0;
  balls_.largest_radius = 0;
  side_ = 1;
  table_.clear(0);
  rows_.clear();
#if HSP_AVX2
  query_grid_ = {};
#endif
  first_ball_[0] = 0;
}

void CubeGrid::make_row_directory() {
  if (has_row_directories) rows_.build(table_, first_ball_, scratch_slots_);
#if HSP_AVX2
  query_grid_ = {};
  if (!rows_.is_there()) return;
  const double side = static_cast<double>(side_);
  rows_.describe(query_grid_);
  query_grid_.side = side;
  query_grid_.inverse_side = 1.0 / side;
  query_grid_.largest_radius = static_cast<double>(balls_.largest_radius);
  query_grid_.factor = balls_.lattice.factor();
  if (wide_) round_balls();
#endif
}

#if HSP_AVX2
void CubeGrid::round_balls() {
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    // The first wall of a cube in the middle; as there is a directory there are few cubes.
    const double before = static_cast<double>(static_cast<int64_t>(query_grid_.size[axis]) / 2);
    query_grid_.middle[axis] = (query_grid_.low[axis] + before) * query_grid_.side;
    const double behind = (query_grid_.size[axis] - before) * query_grid_.side;
    extent = behind > extent ? behind : extent;
  }
  query_grid_.middle[3] = 0.0;
  query_grid_.extent = extent;
  if (extent > most_extent_of_rounded * query_grid_.largest_radius) return;
  const double *const middle = query_grid_.middle;
  float *to = rounded_.data();
  for (uint32_t i = 0; i < balls_.n; ++i, to += 4) {
    to[0] = static_cast<float>(balls_.x[i] - middle[0]);
    to[1] = static_cast<float>(balls_.y[i] - middle[1]);
    to[2] = static_cast<float>(balls_.z[i] - middle[2]);
    to[3] = static_cast<float>(balls_.r[i]);
  }
  for (uint32_t k = 0; k < 4 * BallSet::read_behind; ++k) to[k] = 0.0F;
  query_grid_.rounded = rounded_.data();
}
#endif

Span<uint32_t> CubeGrid::order_of(const BallSet &given, BallRange part, const CubeAxis &axis) {
  const uint32_t n = given.n;
  BallSet some;
  some.x = given.x.part(part.first, part.last);
  some.y = given.y.part(part.first, part.last);
  some.z = given.z.part(part.first, part.last);
  some.r = given.r.part(part.first, part.last);
  some.caller = given.caller.part(part.first, part.last);
  some.n = part.last - part.first;
  return grid_order(some, axis,
                    {scratch_slots_.part(part.first, part.last), scratch_slots_.part(n + part.first, n + part.last),
                     grid_index_.part(part.first, part.last), scratch_links_.part(part.first, part.last), first_ball_});
}

// A part of the balls, in its order, to the same places, as new cubes.
template <class Source>
void CubeGrid::put(const Source &source, const CubeAxis &axis, BallRange part, Span<const uint32_t> order) {
  exact::LatticeBall ball;
  const uint32_t cubes_before = table_.count();
  for (uint32_t k = 0; k < order.size(); ++k) {
    if (!small_code && k + input_balls_ahead < order.size()) source.fetch(part.first + order[k + input_balls_ahead]);
    const uint32_t input = part.first + order[k];
    const uint32_t place = part.first + k;
    static_cast<void>(source.round(input, ball));
    balls_.store(place, ball);
    grid_index_[input] = place;
    CubeCoordinates cube = axis.cube_at(ball.centre);
    cube.z += lift_;
    if (table_.count() == cubes_before || !(cube == table_.coordinates(table_.count() - 1))) {
      first_ball_[table_.count()] = place;
      table_.push(cube);
    }
  }
  table_.insert_from(cubes_before);
}

Status CubeGrid::build(const BallInput &input, uint32_t &first_bad) {
  clear();
  BallRounding rounding;
  if (const Status status = rounding.prepare(input, first_bad); status != Status::ok) return status;

  // Every ball is rounded twice, in the order of the input for r_max and the cubes, and then into its place: that is
  // cheaper than a second copy of the set.
  int64_t largest = 0;
  exact::LatticeBall ball;
  for (uint32_t i = 0; i < input.n; ++i) {
    if (const Status status = rounding.round(i, ball); status != Status::ok) {
      first_bad = i;
      return status;
    }
    balls_.store(i, ball);
    largest = ball.radius > largest ? ball.radius : largest;
  }
  balls_.largest_radius = largest;
  const int64_t radius = rounding.expected_radius() > largest ? rounding.expected_radius() : largest;
  side_ = radius > 0 ? 2 * radius : 1;
  balls_.n = input.n;
  balls_.lattice = rounding.lattice();
  balls_.probe_steps = rounding.probe_steps();
  sort(rounding, balls_, input.n);
  return Status::ok;
}

void CubeGrid::build(const BallSet &given, uint32_t own) {
  clear();
  balls_.largest_radius = given.largest_radius;
  balls_.n = given.n;
  balls_.lattice = given.lattice;
  balls_.probe_steps = given.probe_steps;
  side_ = given.largest_radius > 0 ? 2 * given.largest_radius : 1;
  sort(GivenBalls{given}, given, own);
}

void CubeGrid::build(const BallSet &balls, Span<const uint32_t> place, int64_t side) {
  clear();
  const PlacedBalls placed{balls, place};
  const uint32_t n = place.size();
  exact::LatticeBall ball;
  for (uint32_t i = 0; i < n; ++i) {
    placed.round(i, ball);
    balls_.store(i, ball);
    balls_.largest_radius = ball.radius > balls_.largest_radius ? ball.radius : balls_.largest_radius;
  }
  side_ = side;
  balls_.n = n;
  balls_.lattice = balls.lattice;
  balls_.probe_steps = balls.probe_steps;
  sort(placed, balls_, n);
}

// From balls that are known as they are given, which may be where they are to be put: the source has them once more.
template <class Source>
void CubeGrid::sort(const Source &source, const BallSet &given, uint32_t own) {
  const uint32_t n = given.n;
  const CubeAxis axis(side_);
  const Span<const uint32_t> order = order_of(given, {0, own}, axis);
  Span<const uint32_t> others;
  int64_t lowest = 0;
  if (own < n) {
    others = order_of(given, {own, n}, axis);
    lowest = axis.cube_at(static_cast<int64_t>(given.z[own + others[0]]));
  }
  table_.clear(n);
  put(source, axis, {0, own}, order);
  own_balls_ = own;
  own_cubes_ = table_.count();
  if (own < n) {
    last_own_layer_ = own > 0 ? table_.high().z : 0;
    lift_ = last_own_layer_ + 1 - lowest;
    inner_low_ = table_.low();
    inner_high_ = table_.high();
    put(source, axis, {own, n}, others);
    cut_off_others();
  }
  first_ball_[table_.count()] = n;
  make_row_directory();
}

// From the box around all own cubes each cube of another ball cuts off the fewest layers that hold it.
void CubeGrid::cut_off_others() {
  for (uint32_t cube = own_cubes_; cube < table_.count(); ++cube) {
    CubeCoordinates at = table_.coordinates(cube);
    at.z -= lift_;
    const int64_t behind[6] = {at.x - inner_low_.x,  at.y - inner_low_.y,  at.z - inner_low_.z,
                               inner_high_.x - at.x, inner_high_.y - at.y, inner_high_.z - at.z};
    uint32_t least = 0;
    for (uint32_t face = 1; face < 6; ++face) least = behind[face] < behind[least] ? face : least;
    if (behind[least] < 0) continue;  // it is outside
    if (least == 0) inner_low_.x = at.x + 1;
    if (least == 1) inner_low_.y = at.y + 1;
    if (least == 2) inner_low_.z = at.z + 1;
    if (least == 3) inner_high_.x = at.x - 1;
    if (least == 4) inner_high_.y = at.y - 1;
    if (least == 5) inner_high_.z = at.z - 1;
  }
}

// Whether no ball that only stands around is in the 27 cubes around this one.
bool CubeGrid::is_far_from_others(const CubeCoordinates &centre) const {
  return centre.x > inner_low_.x && centre.x < inner_high_.x && centre.y > inner_low_.y && centre.y < inner_high_.y &&
         centre.z > inner_low_.z && centre.z < inner_high_.z;
}

BallRange CubeGrid::balls_in_row(int64_t x_low, int64_t x_high, int64_t y, int64_t z) const {
  const uint64_t along_x = linear_hash({1, 0, 0});
  uint64_t linear = linear_hash({x_low, y, z});
  for (int64_t x = x_low; x <= x_high; ++x, linear += along_x) {
    const uint32_t cube = table_.find({x, y, z}, linear);
    if (cube == no_id) continue;
    // The other cubes of the row have the next numbers.
    uint32_t end = cube + 1;
    for (; end < table_.count(); ++end) {
      const CubeCoordinates &next = table_.coordinates(end);
      if (next.x > x_high || next.y != y || next.z != z) break;
    }
    return {first_ball_[cube], first_ball_[end]};
  }
  return {0, 0};
}

// Rows of cubes from `low` to `high`, nine at most.
void CubeGrid::add_rows(const CubeCoordinates &low, const CubeCoordinates &high, CubeBlock &block) const {
  if (rows_.is_there()) {
    block.ranges += rows_.find(low, high, {block.range + block.ranges, 9});
    return;
  }
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      const BallRange range = balls_in_row(low.x, high.x, y, z);
      if (!range.empty()) block.range[block.ranges++] = range;
    }
  }
}

CubeBlock CubeGrid::block_around(const CubeCoordinates &centre) const {
  CubeBlock block;
  CubeCoordinates low{centre.x - 1, centre.y - 1, centre.z - 1};
  CubeCoordinates high{centre.x + 1, centre.y + 1, centre.z + 1};
  if (!has_others() || is_far_from_others(centre)) {
    add_rows(low, high, block);
    return block;
  }
  const CubeCoordinates highest{high.x, high.y, high.z < last_own_layer_ ? high.z : last_own_layer_};
  add_rows(low, highest, block);
  low.z += lift_;
  high.z += lift_;
  if (low.z <= last_own_layer_) low.z = last_own_layer_ + 1;
  add_rows(low, high, block);
  return block;
}

}  // namespace hsp
