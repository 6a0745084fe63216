// The widest probe between two places, as the pores have it, against a relaxation over all gates, and against the
// library's cells of free space around grown balls (support::ProbeByCells, no independent oracle).
#pragma once

#include "checked_passage.hpp"
#include "checked_pores.hpp"
#include "lattice_lengths.hpp"
#include "probe_by_cells.hpp"

namespace pore_widths {

struct Seen {
  int pairs = 0, gates = 0;
};

// The widest probe from one maximum to every other, by relaxation over all gates: the level of the narrowest gate on
// the widest way.
class Widths {
 public:
  explicit Widths(const BuiltPores &pores, uint32_t from) : width_(pores.maxima().size() + 1, -INFINITY) {
    width_[node(from)] = INFINITY;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto &gate : pores.gates()) {
        for (const uint32_t side : {0U, 1U}) {
          const double through = std::min(width_[node(gate.end[side])], gate.point.level);
          double &there = width_[node(gate.end[1 - side])];
          if (through > there) {
            there = through;
            changed = true;
          }
        }
      }
    }
  }
  double at(uint32_t end) const { return width_[node(end)]; }

 private:
  size_t node(uint32_t end) const { return end == hsp::pore_outside ? width_.size() - 1 : end; }
  std::vector<double> width_;
};

inline std::array<double, 3> in_lengths(const hsp::exact::Vector &point) {
  return {static_cast<double>(point.x), static_cast<double>(point.y), static_cast<double>(point.z)};
}

// Between maxima, which are places in free space that are known to be in their classes, and to the outside.
inline void compare_with_gates(oracle::RandomSource &random, int kind, int pairs, Seen &seen) {
  const oracle::Balls balls = pore_sets::general_set(random, 30, kind);
  const BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  if (pores.maxima().size() < 2) return;
  const auto count = static_cast<int64_t>(pores.maxima().size());
  for (int k = 0; k < pairs; ++k) {
    const auto a = static_cast<uint32_t>(random.in(0, count - 1));
    const auto b = random.one_in(3) ? hsp::pore_outside : static_cast<uint32_t>(random.in(0, count - 1));
    if (a == b) continue;
    const auto place = [&](uint32_t end) {
      const hsp::Vec3 &at = pores.maxima()[end].point.position;
      return hsp::exact::Vector{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    };
    const auto level = [&](uint32_t end) {
      return end == hsp::pore_outside ? INFINITY : pores.maxima()[end].point.level;
    };
    const hsp::exact::Vector from = place(a), to = b == hsp::pore_outside ? from : place(b);
    // Places lose less than a step by rounding to the lattice.
    if (std::min(level(a), level(b)) < 4.0) continue;
    hsp::PorePassage passage{};
    const hsp::exact::Vector *const end = b == hsp::pore_outside ? nullptr : &to;
    ASSERT_EQ(find_passage(pores.builder(), pores.grid(), from, end, 0, passage), hsp::Status::ok);
    const double ours = std::min({Widths(pores, a).at(b), level(a), level(b)});
    ASSERT_EQ(passage.passes, ours != -INFINITY) << oracle::to_text(balls);
    const std::array<double, 3> start = in_lengths(from), last = in_lengths(to);
    const double *const end_in_lengths = end == nullptr ? nullptr : last.data();
    support::ProbeByCells cells(oracle::in_lengths(balls, 1), 1.0);
    const auto is_open = [&](support::ProbeByCells &free_space, double probe) {
      const std::optional<bool> open = free_space.passes(probe, start.data(), end_in_lengths);
      EXPECT_FALSE(free_space.has_failed()) << oracle::to_text(balls);
      return open;
    };
    ASSERT_EQ(is_open(cells, std::max(0.0, std::floor(ours) - 1.0)), passage.passes) << oracle::to_text(balls);
    if (!passage.passes) continue;
    ASSERT_NEAR(passage.level, ours, 1.0) << oracle::to_text(balls);
    ++seen.pairs;
    const std::optional<bool> wider = is_open(cells, std::floor(ours) + 2.0);
    if (!wider) continue;
    ASSERT_FALSE(*wider) << oracle::to_text(balls);
    if (ours > std::min(level(a), level(b)) - 8.0) continue;
    ++seen.gates;
    ASSERT_NE(passage.gate, hsp::no_id);
    oracle::Balls without = balls;
    for (const uint32_t ball : pores.gates()[passage.gate].point.ball)
      if (ball != hsp::no_id) without[ball].radius -= 5;
    support::ProbeByCells opened(oracle::in_lengths(without, 1), 1.0);
    ASSERT_EQ(is_open(opened, std::floor(ours) + 2.0), true) << oracle::to_text(balls);
  }
}

}  // namespace pore_widths
