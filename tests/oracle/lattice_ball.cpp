#include "lattice_ball.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace oracle {

std::vector<uint32_t> tie_ranks(const Balls &balls) {
  std::vector<uint32_t> order(balls.size());
  std::iota(order.begin(), order.end(), 0U);
  // Stable: equal balls keep the order of their indices.
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return balls[a] < balls[b]; });
  std::vector<uint32_t> rank(balls.size());
  for (uint32_t place = 0; place < order.size(); ++place) rank[order[place]] = place;
  return rank;
}

std::string to_text(const Balls &balls) {
  std::ostringstream text;
  for (const LatticeBall &ball : balls)
    text << "{" << ball.x << ", " << ball.y << ", " << ball.z << ", " << ball.radius << "}, ";
  return text.str();
}

}  // namespace oracle
