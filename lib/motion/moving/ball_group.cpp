#include "moving/ball_group.hpp"

#include "core/extremes.hpp"
#include "measure/tangency.hpp"

namespace hsp {
namespace {

// How many balls are computed together, and how large the box around them may be, in sides of cubes: the balls around
// them are gathered once for the group.
constexpr uint32_t most_in_group = 64;
constexpr int64_t most_sides = 3;

// A sphere with m caps has at most 6 m - 12 free vertices (Kedem and others 1986), and m circles. More room is for
// groups: so they are seldom halved.
BoundaryLimits limits_of_part(uint32_t balls, uint32_t neighbours) {
  const uint64_t m = neighbours;
  return {balls, neighbours, clamped_count(6 * m + 16 * most_in_group), clamped_count(m + 4 * most_in_group), 0};
}

}  // namespace

void BallGroup::carve(Workspace &workspace, uint32_t balls, uint32_t neighbours) {
  neighbours_ = neighbours;
  part_.carve(workspace, limits_of_part(balls, neighbours));
  near_.carve(workspace, balls);
  near_ball_ = workspace.take<uint32_t>(static_cast<uint64_t>(balls) + 1);
  in_group_ = workspace.take<uint8_t>(balls);
}

void BallGroup::clear(const exact::Lattice &lattice, uint32_t n) {
  near_.lattice = lattice;
  for (uint8_t &each : in_group_.part(0, n)) each = 0;
}

// If there is no room for all neighbours of a ball, the other balls are computed all the same, to learn how many
// neighbours they have.
uint32_t BallGroup::compute(MovingRecords &records, const BallCells &cells, uint32_t affected, AreaWeights weights,
                            Patience &patience) {
  uint32_t needed = 0;
  for (uint32_t first = 0; first < affected;) {
    uint32_t count = choose(records, cells, first, affected);
    const uint64_t around = needed;
    if (!patience.allows(count * (10000 + (500 + around) * around))) break;
    Status status = compute_chosen(records, cells, count, weights);
    // A single ball has room for all of its vertices.
    while (status != Status::ok && count > 1 && part_.needed().neighbours <= neighbours_) {
      count = choose(records, cells, first, first + count / 2);
      status = compute_chosen(records, cells, count, weights);
    }
    needed = larger_count(needed, part_.needed().neighbours);
    first += count;
  }
  return needed;
}

Status BallGroup::compute_chosen(MovingRecords &records, const BallCells &cells, uint32_t count, AreaWeights weights) {
  gather_around(records, cells, count);
  const Status status = part_.build(near_, count, centre_, static_cast<double>(cells.side()));
  if (status == Status::ok) store(records, count, weights);
  return status;
}

// Takes balls of the journal from `first` on into near_, as long as they are close together and in cubes of one size.
// Returns their number.
uint32_t BallGroup::choose(const MovingRecords &records, const BallCells &cells, uint32_t first, uint32_t last) {
  const BallSet &balls = records.balls;
  const int64_t side = cells.side_for(balls.ball(records.entry(first).ball).radius), most = most_sides * side;
  uint32_t count = 0;
  for (uint32_t k = first; k < last && count < most_in_group; ++k) {
    const uint32_t i = records.entry(k).ball;
    const exact::LatticeBall ball = balls.ball(i);
    if (cells.side_for(ball.radius) != side) break;
    const exact::Vector &c = ball.centre, &p = count == 0 ? c : low_, &q = count == 0 ? c : high_;
    const exact::Vector low{smaller_of(p.x, c.x), smaller_of(p.y, c.y), smaller_of(p.z, c.z)};
    const exact::Vector high{larger_of(q.x, c.x), larger_of(q.y, c.y), larger_of(q.z, c.z)};
    if (high.x - low.x > most || high.y - low.y > most || high.z - low.z > most) break;
    low_ = low;
    high_ = high;
    near_.store(count, ball);
    near_ball_[count++] = i;
  }
  return count;
}

// Puts behind the group in near_ all balls that meet one of its balls, and some more.
void BallGroup::gather_around(const MovingRecords &records, const BallCells &cells, uint32_t count) {
  const BallSet &balls = records.balls;
  const auto middle = [](int64_t a, int64_t b) { return 0.5 * static_cast<double>(a + b); };
  centre_[0] = middle(low_.x, high_.x);
  centre_[1] = middle(low_.y, high_.y);
  centre_[2] = middle(low_.z, high_.z);
  const double x = centre_[0], y = centre_[1], z = centre_[2];
  const auto squared_distance = [x, y, z](const BallSet &set, uint32_t i) {
    const double dx = set.x[i] - x, dy = set.y[i] - y, dz = set.z[i] - z;
    return dx * dx + dy * dy + dz * dz;
  };
  double reach = 0.0;
  int64_t largest = 0;
  for (uint32_t k = 0; k < count; ++k) {
    in_group_[near_ball_[k]] = 1;
    const double own = std::sqrt(squared_distance(near_, k)) + near_.r[k];
    reach = own > reach ? own : reach;
    const int64_t radius = near_.ball(k).radius;
    largest = radius > largest ? radius : largest;
  }
  // Above all rounding errors.
  reach = reach * (1.0 + 0x1p-40) + 1.0;
  uint32_t n = count;
  cells.visit_near(low_, high_, largest, [&](uint32_t j) {
    const double sum = reach + balls.r[j];
    // No branch, as whether this ball is taken is hard to predict.
    near_ball_[n] = j;
    n += static_cast<uint32_t>(squared_distance(balls, j) <= sum * sum) & static_cast<uint32_t>(in_group_[j] == 0);
  });
  for (uint32_t k = count; k < n; ++k) {
    const uint32_t j = near_ball_[k];
    near_.store(k, balls.ball(j));
  }
  near_.n = n;
  for (uint32_t k = 0; k < count; ++k) in_group_[near_ball_[k]] = 0;
}

void BallGroup::store(MovingRecords &records, uint32_t count, AreaWeights weights) const {
  const Boundary &boundary = part_.boundary();
  for (uint32_t k = 0; k < count; ++k) {
    MovingBall &ball = records.ball[near_ball_[k]];
    ball.own = gradient_of_ball(near_, boundary, weights, k);
    ball.half_edges = boundary.half_edges(k).size();
    ball.circles = boundary.circles(k).size();
    ball.loops = boundary.loops(k).size();
    ball.faces = boundary.faces(k).size();
    ball.contained = boundary.is_contained(k);
    ball.one_sided = ball.own.one_sided;
  }
}

void BallGroup::flag_inner_contacts(MovingRecords &records, const BallCells &cells, uint32_t affected) {
  for (uint32_t first = 0; first < affected;) {
    const uint32_t count = choose(records, cells, first, affected);
    gather_around(records, cells, count);
    flag(records, count);
    first += count;
  }
}

void BallGroup::flag(MovingRecords &records, uint32_t count) const {
  const BallsThatMayMeet everything(CubeBlock{{{0, near_.n}}, 1});
  const auto record = [&](uint32_t k) -> MovingBall & { return records.ball[near_ball_[k]]; };
  for (uint32_t inner = 0; inner < near_.n; ++inner) {
    if (!record(inner).contained) continue;
    InnerTouch touch(near_, everything, inner);
    const uint32_t outers = inner < count ? near_.n : count;
    for (uint32_t outer = 0; outer < outers; ++outer) {
      if (inner == outer || (near_.r[inner] == near_.r[outer] && record(outer).faces == 0)) continue;
      if (!touch.is_free_with(outer)) continue;
      if (inner < count) record(inner).one_sided = true;
      if (outer < count) record(outer).one_sided = true;
    }
  }
}

}  // namespace hsp
