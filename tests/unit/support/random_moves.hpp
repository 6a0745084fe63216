// Random moves of balls of one kind of set: ties stay ties, since most places are those of another set of this kind.
#pragma once

#include <algorithm>

#include "moved_union.hpp"
#include "random_balls.hpp"

class RandomMoves {
 public:
  using Family = oracle::Balls (*)(oracle::RandomSource &, size_t);

  RandomMoves(oracle::RandomSource &random, Family family, size_t n)
      : random_(random), start_(family(random, n)), places_(family(random, 2 * n)) {
    places_.insert(places_.end(), start_.begin(), start_.end());
    for (const oracle::LatticeBall &ball : places_) largest_ = std::max(largest_, ball.radius);
  }

  const oracle::Balls &start() const { return start_; }
  double largest_radius() const { return static_cast<double>(std::max<int64_t>(largest_, 1)); }

  // Draws the ids of some balls, all different, and the balls that they become.
  void next(const support::BallList &balls, std::vector<uint32_t> &ids, support::BallList &to) {
    const uint32_t n = balls.size();
    size_t count = random_.one_in(3) ? 1 + random_.below(std::min(n, 5U)) : 1;
    if (random_.one_in(50)) count = n;
    ids = random_.permutation(n);
    ids.resize(count);
    to = {};
    for (const uint32_t i : ids) {
      oracle::LatticeBall ball = places_[random_.below(static_cast<uint32_t>(places_.size()))];
      const uint32_t other = random_.below(n);
      switch (random_.below(8)) {
        case 0:  // a little
          ball = at(balls, i);
          ball.x += random_.in(-2, 2);
          ball.y += random_.in(-2, 2);
          ball.z += random_.in(-2, 2);
          break;
        case 1:  // onto another one
          ball = at(balls, other);
          break;
        case 2:  // around another one
          ball = at(balls, other);
          ball.radius = at(balls, i).radius;
          break;
        case 3:  // touching another one from inside
          ball = at(balls, other);
          ball.x += ball.radius - ball.radius / 2;
          ball.radius /= 2;
          break;
        case 4:  // far away
          if (random_.one_in(4)) ball.x += 1000000;
          break;
        default:
          break;
      }
      to.add(static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z),
             static_cast<double>(std::min(ball.radius, largest_)));
    }
  }

 private:
  static oracle::LatticeBall at(const support::BallList &balls, uint32_t i) {
    return oracle::nearest_ball({balls.xyz[3 * i], balls.xyz[3 * i + 1], balls.xyz[3 * i + 2], balls.radius[i]});
  }

  oracle::RandomSource &random_;
  oracle::Balls start_, places_;
  int64_t largest_ = 0;
};

// Moves balls of random sets, `moves` times in all and `moves_of_set` times each set, and takes some of the moves back.
// Empty, or what went wrong.
inline std::string complaint_about_moves(uint64_t seed, int moves, int moves_of_set) {
  using namespace oracle;
  constexpr RandomMoves::Family families[] = {
      loose_balls,     dense_balls,         clustered_balls,      belted_balls,  grid_balls,    coplanar_balls,
      collinear_balls, balls_through_point, balls_through_circle, tangent_balls, lattice_balls, repeated_balls};
  RandomSource random(seed);
  std::vector<uint32_t> ids;
  support::BallList to;
  for (int done = 0, set = 0; done < moves; ++set) {
    const size_t n = 1 + random.below(set % 7 == 0 ? 60 : 24);
    RandomMoves family(random, families[static_cast<size_t>(set) % std::size(families)], n);
    std::vector<double> weights(n);
    for (double &weight : weights) weight = static_cast<double>(random.in(-3, 5)) / 4;
    const hsp::EnergyTerms terms{{random.one_in(3) ? nullptr : weights.data(),
                                  random.one_in(2) ? hsp::TouchingBalls::meet : hsp::TouchingBalls::apart},
                                 0.75,
                                 random.one_in(2) ? -0.375 : 0.0};
    MovedUnion moved(in_lengths(family.start(), 1), family.largest_radius(), static_cast<uint32_t>(n), terms);
    const auto name = [&](const char *what) {
      return std::string(what) + " of move " + std::to_string(done) + ", set " + std::to_string(set) + ": ";
    };
    if (moved.status() != hsp::Status::ok) return name("the set");
    if (const std::string complaint = moved.complaint(); !complaint.empty()) return name("the start") + complaint;
    for (int k = 0; k < moves_of_set; ++k, ++done) {
      family.next(moved.balls(), ids, to);
      if (moved.move(ids, to) != hsp::Status::ok) return name("the status");
      if (const std::string complaint = moved.complaint(k % 2 == 0); !complaint.empty())
        return name("after") + complaint;
      if (!random.one_in(4)) continue;
      if (moved.undo() != hsp::Status::ok) return name("undoing");
      if (const std::string complaint = moved.complaint(); !complaint.empty()) return name("undoing") + complaint;
      if (moved.undo() != hsp::Status::state) return name("undoing twice");
    }
  }
  return "";
}
