#include "moving_workload.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>

#include "random_numbers.hpp"

namespace bench {
namespace {

constexpr double shift = 0.3;  // Angstrom

// The atoms nearest to one of them, which comes first.
std::vector<uint32_t> nearest_atoms(const Balls &balls, uint32_t centre, uint32_t count) {
  const auto squared_distance = [&](uint32_t i) {
    double sum = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const double d = balls.xyz[3 * size_t{i} + axis] - balls.xyz[3 * size_t{centre} + axis];
      sum += d * d;
    }
    return sum;
  };
  std::vector<uint32_t> ids(balls.size());
  std::iota(ids.begin(), ids.end(), 0U);
  count = std::min(count, balls.size());
  std::partial_sort(ids.begin(), ids.begin() + count, ids.end(),
                    [&](uint32_t i, uint32_t j) { return squared_distance(i) < squared_distance(j); });
  ids.resize(count);
  return ids;
}

}  // namespace

MovingAtoms::MovingAtoms(const Balls &balls, double probe, uint32_t moves, uint32_t atoms_a_move)
    : model_(balls, probe), boundary_(model_), changed_(balls.size()), records_(balls.size()) {
  hsp_moving_limits limits{};
  expect_ok(hsp_moving_limits_init(&limits, sizeof limits, balls.size()), "hsp_moving_limits_init");
  moving_.take(limits);
  moving_.compute([&](hsp_moving *moving, hsp_moving_limits *asked) {
    return hsp_moving_set(moving, model_.get(), nullptr, 1, 0, HSP_TANGENT_OVERLAP, asked, nullptr);
  });
  support::Random random(1994);
  for (uint32_t k = 0; k < moves; ++k) {
    Move next;
    next.ball = nearest_atoms(balls, random.below(balls.size()), atoms_a_move);
    for (const uint32_t i : next.ball) {
      for (size_t axis = 0; axis < 3; ++axis) {
        const double x = balls.xyz[3 * size_t{i} + axis];
        next.back.push_back(x);
        next.there.push_back(random.below(2) == 0 ? x - shift : x + shift);
      }
    }
    moves_.push_back(next);
  }
}

void MovingAtoms::move(const Move &move, const std::vector<double> &to) {
  const int32_t status = hsp_moving_move(moving_.get(), static_cast<uint32_t>(move.ball.size()), move.ball.data(),
                                         to.data(), nullptr, nullptr, nullptr);
  if (status != HSP_OK) expect_ok(status, "hsp_moving_move");
}

uint64_t MovingAtoms::read() {
  hsp_energy energy{};
  uint32_t needed = 0;
  int32_t status = hsp_moving_gradient(moving_.get(), &energy, nullptr, nullptr, nullptr, 0, nullptr);
  if (status == HSP_OK) status = hsp_moving_get_changed(moving_.get(), changed_.data(), size(), &needed);
  if (status == HSP_OK) status = hsp_moving_get_balls(moving_.get(), needed, changed_.data(), records_.data());
  if (status != HSP_OK) expect_ok(status, "reading balls that moved");
  benchmark::DoNotOptimize(energy);
  benchmark::DoNotOptimize(records_);
  return needed;
}

uint64_t MovingAtoms::move_all() {
  uint64_t changed = 0;
  for (const Move &next : moves_) {
    move(next, next.there);
    changed += read();
    move(next, next.back);
    changed += read();
  }
  return changed;
}

uint64_t MovingAtoms::move_and_undo_all() {
  uint64_t changed = 0;
  for (const Move &next : moves_) {
    move(next, next.there);
    changed += read();
    const int32_t status = hsp_moving_undo(moving_.get());
    if (status != HSP_OK) expect_ok(status, "hsp_moving_undo");
  }
  return changed;
}

hsp_energy MovingAtoms::compute_anew() {
  model_.set();
  boundary_.compute();
  boundary_.measure();
  return boundary_.gradient();
}

}  // namespace bench
