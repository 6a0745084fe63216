#include "brick_splits.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace {

using support::OwnedBalls;
using support::Random;

// Through the centre of a ball, touching it, or across it.
int64_t any_plane(Random &random, const OwnedBalls &balls, int axis) {
  const uint32_t i = random.below(balls.size());
  const int64_t c = balls.at(i, axis), r = balls.r(i);
  return c + std::array<int64_t, 4>{0, r, -r, random.in(-r, r)}[random.below(4)];
}

// Cuts along the axes. A centre on a cut belongs to the side above.
uint32_t cut(OwnedBalls &balls, std::array<std::vector<int64_t>, 3> cuts) {
  uint32_t bricks = 1;
  for (auto &c : cuts) {
    std::sort(c.begin(), c.end());
    bricks *= static_cast<uint32_t>(c.size() + 1);
  }
  for (uint32_t i = 0; i < balls.size(); ++i) {
    balls.owner[i] = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const auto &c = cuts[static_cast<size_t>(axis)];
      const auto above = std::upper_bound(c.begin(), c.end(), balls.at(i, axis)) - c.begin();
      balls.owner[i] = balls.owner[i] * static_cast<uint32_t>(c.size() + 1) + static_cast<uint32_t>(above);
    }
  }
  return bricks;
}

// Halves across the longest extent, again and again.
uint32_t bisect(Random &random, OwnedBalls &balls, bool at_medians) {
  uint32_t bricks = 1;
  for (int64_t levels = random.in(1, 4); levels > 0; --levels, bricks *= 2) {
    for (uint32_t brick = 0; brick < bricks; ++brick) {
      std::vector<uint32_t> part;
      for (uint32_t i = 0; i < balls.size(); ++i) {
        if (balls.owner[i] == brick) part.push_back(i);
      }
      if (part.empty()) continue;
      int axis = 0;
      int64_t longest = -1, at = 0;
      for (int k = 0; k < 3; ++k) {
        std::vector<int64_t> c;
        for (const uint32_t i : part) c.push_back(balls.at(i, k));
        std::sort(c.begin(), c.end());
        if (c.back() - c.front() <= longest) continue;
        longest = c.back() - c.front();
        axis = k;
        at = c[c.size() / 2];
      }
      if (!at_medians) at = any_plane(random, balls, axis);
      for (const uint32_t i : part) balls.owner[i] += balls.at(i, axis) < at ? 0 : bricks;
    }
  }
  return bricks;
}

uint32_t cut_obliquely(Random &random, OwnedBalls &balls) {
  const uint32_t bricks = static_cast<uint32_t>(random.in(2, 6));
  for (uint32_t brick = 1; brick < bricks; ++brick) {
    const uint32_t p = random.below(balls.size());
    const std::array<int64_t, 3> normal = {random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)};
    for (uint32_t i = 0; i < balls.size(); ++i) {
      int64_t along = 0;
      for (int k = 0; k < 3; ++k) along += normal[static_cast<size_t>(k)] * (balls.at(i, k) - balls.at(p, k));
      if (along > 0) balls.owner[i] = brick;
    }
  }
  return bricks;
}

}  // namespace

uint32_t split_at_random(Random &random, OwnedBalls &balls) {
  std::fill(balls.owner.begin(), balls.owner.end(), 0U);
  if (balls.size() == 0) return static_cast<uint32_t>(random.in(1, 3));
  std::array<std::vector<int64_t>, 3> cuts;
  const auto add_cuts = [&](int axis, int64_t count) {
    for (; count > 0; --count) cuts[static_cast<size_t>(axis)].push_back(any_plane(random, balls, axis));
  };
  switch (random.below(6)) {
    case 0:
      add_cuts(static_cast<int>(random.below(3)), random.in(1, 6));
      return cut(balls, cuts);
    case 1:
      for (int axis = 0; axis < 3; ++axis) add_cuts(axis, random.in(1, 3));
      return cut(balls, cuts);
    case 2:
      return bisect(random, balls, true);
    case 3:
      return bisect(random, balls, false);
    case 4:
      return cut_obliquely(random, balls);
    default: {
      const uint32_t bricks = static_cast<uint32_t>(random.in(2, 7));
      for (uint32_t &owner : balls.owner) owner = random.below(bricks);
      return bricks;
    }
  }
}

Halos::Halos(const OwnedBalls &balls, const hsp_model *model, int64_t largest_radius)
    : balls_(balls), largest_radius_(largest_radius), first_(balls.size() + 1) {
  uint32_t needed = 0;
  const int32_t status = hsp_query_pairs(model, 0, first_.data(), nullptr, 0, &needed);
  if (status != HSP_E_CAPACITY) support::need(status, "pairs");
  pairs_.resize(needed);
  support::need(hsp_query_pairs(model, 0, first_.data(), pairs_.data(), needed, &needed), "pairs");
}

OwnedBalls Halos::model_of(uint32_t brick, uint32_t kind, Random &random) const {
  std::vector<uint8_t> in(balls_.size());
  std::array<int64_t, 3> low{}, high{};
  bool any = false;
  for (uint32_t i = 0; i < balls_.size(); ++i) {
    if (balls_.owner[i] != brick) continue;
    in[i] = 1;
    for (uint32_t k = first_[i]; k < first_[i + 1]; ++k) in[pairs_[k]] = 1;
    for (size_t k = 0; k < 3; ++k) {
      const int64_t c = balls_.at(i, static_cast<int>(k));
      low[k] = any ? std::min(low[k], c) : c;
      high[k] = any ? std::max(high[k], c) : c;
    }
    any = true;
  }
  for (uint32_t i = 0; i < balls_.size() && kind != 0; ++i) {
    bool near = any;
    for (size_t k = 0; k < 3 && near; ++k) {
      const int64_t c = balls_.at(i, static_cast<int>(k));
      near = low[k] - 2 * largest_radius_ <= c && c <= high[k] + 2 * largest_radius_;
    }
    if (kind == 1 ? near : random.one_in(5)) in[i] = 1;
  }
  return balls_.part(in);
}
