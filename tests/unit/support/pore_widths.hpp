// The widest probe between two places by maxima and gates, against the one that bisects free space of grown balls.
#pragma once

#include "checked_pores.hpp"
#include "checked_probe.hpp"

namespace pore_widths {

struct Seen {
  int pairs = 0, gates = 0;
};

// Of places, the widest probe from one to each maximum by relaxation over all gates: the level of the narrowest gate on
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
    // Rounded to the lattice the places lose less than a step.
    if (std::min(level(a), level(b)) < 4.0) continue;
    const checked_probe::BuiltProbe probe(balls, from, b == hsp::pore_outside ? nullptr : &to);
    ASSERT_EQ(probe.status(), hsp::Status::ok);
    const double ours = std::min({Widths(pores, a).at(b), level(a), level(b)});
    if (!probe.widest().passes || ours == -INFINITY) {
      ASSERT_EQ(probe.widest().passes, ours != -INFINITY) << oracle::to_text(balls);
      continue;
    }
    ASSERT_NEAR(probe.widest().radius, ours, 1.0) << oracle::to_text(balls);
    ++seen.pairs;
    if (ours > std::min(level(a), level(b)) - 2.0) continue;
    ++seen.gates;
    for (const auto &gate : pores.gates()) {
      if (gate.point.level != ours) continue;
      std::array<uint32_t, 3> named{gate.point.ball[0], gate.point.ball[1], gate.point.ball[2]};
      std::sort(named.begin(), named.end());
      for (size_t corner = 0; corner < 3; ++corner) ASSERT_EQ(probe.widest().gate[corner], named[corner]);
    }
  }
}

}  // namespace pore_widths
