// Pockets against what flows through gates: from the outside with the wide probe, then in what is left with the narrow
// one. With one probe they are the cavities of grown balls.
#include "pockets/pockets.hpp"

#include <gtest/gtest.h>

#include <set>

#include "checked_pores.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::no_id;
using hsp::pore_outside;

// Maxima that a probe reaches from one, through gates that it passes, between members.
std::set<uint32_t> flood(const BuiltPores &pores, uint32_t from, double level, const std::set<uint32_t> *without) {
  std::set<uint32_t> reached{from};
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto &gate : pores.gates()) {
      if (gate.point.level <= level) continue;
      if (without != nullptr && (without->count(gate.end[0]) > 0 || without->count(gate.end[1]) > 0)) continue;
      for (const uint32_t side : {0U, 1U}) {
        if (reached.count(gate.end[side]) > 0) changed = reached.insert(gate.end[1 - side]).second || changed;
      }
    }
  }
  return reached;
}

TEST(Pockets, AreWhatAWideProbeDoesNotReach) {
  oracle::RandomSource random(1);
  int pockets = 0, with_mouths = 0, several = 0;
  for (int turn = 0; turn < oracle::sets(40); ++turn) {
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::general_set(random, 60, turn / 2 % pore_sets::general_kinds)
                                              : pore_sets::tied_set(random, 30, turn / 2 % pore_sets::tied_kinds);
    BuiltPores pores(balls);
    ASSERT_EQ(pores.status(), hsp::Status::ok);
    if (pores.maxima().empty()) continue;
    hsp::PocketFinder finder;
    CarvedMemory memory;
    memory.carve(finder, pores.limits());
    for (int pair = 0; pair < 4; ++pair) {
      const auto any = [&] {
        return pores.maxima()[static_cast<uint32_t>(random.in(0, pores.maxima().size() - 1))].point.level -
               static_cast<double>(random.in(0, 30000000));
      };
      const double a = any(), b = any(), narrow = std::min(a, b), wide = pair == 0 ? narrow : std::max(a, b);
      finder.find(pores.builder(), narrow, wide);
      const std::set<uint32_t> open = flood(pores, pore_outside, wide, nullptr);
      std::set<uint32_t> taken;
      double before = INFINITY;
      for (const hsp::Pocket &pocket : finder.pockets()) {
        ++pockets;
        std::set<uint32_t> members, mouths, lining;
        for (const uint32_t maximum : finder.maxima(pocket)) members.insert(maximum);
        ASSERT_EQ(members.size(), finder.maxima(pocket).size());
        ASSERT_EQ(members, flood(pores, pocket.maximum, narrow, &open)) << oracle::to_text(balls);
        ASSERT_EQ(*members.begin(), pocket.maximum);
        for (const uint32_t maximum : members) {
          ASSERT_TRUE(taken.insert(maximum).second);
          ASSERT_EQ(open.count(maximum), 0U);
          for (const uint32_t ball : pores.builder().tied(pores.maxima()[maximum].point)) lining.insert(ball);
        }
        for (uint32_t k = 0; k < pores.gates().size(); ++k) {
          const hsp::PoreGate &gate = pores.gates()[k];
          const bool first = members.count(gate.end[0]) > 0, second = members.count(gate.end[1]) > 0;
          if (gate.point.level <= narrow || !(first || second)) continue;
          if (first != second) mouths.insert(k);
          for (const uint32_t ball : pores.builder().tied(gate.point)) lining.insert(ball);
        }
        ASSERT_TRUE(
            std::equal(mouths.begin(), mouths.end(), finder.mouths(pocket).begin(), finder.mouths(pocket).end()));
        ASSERT_EQ(pocket.mouth, mouths.empty() ? no_id : *mouths.begin());
        ASSERT_TRUE(std::equal(lining.begin(), lining.end(), finder.balls(pocket).begin(), finder.balls(pocket).end()));
        const double level = pores.maxima()[pocket.maximum].point.level;
        ASSERT_GT(level, narrow);
        ASSERT_LE(level, before);
        before = level;
        with_mouths += mouths.empty() ? 0 : 1;
        several += members.size() > 1 ? 1 : 0;
        if (pair == 0) {
          ASSERT_TRUE(mouths.empty());
        }
      }
      for (uint32_t k = 0; k < pores.maxima().size(); ++k) {
        if (pores.maxima()[k].point.level > narrow && open.count(k) == 0) {
          ASSERT_EQ(taken.count(k), 1U);
        }
      }
      if (pair == 0) {
        ASSERT_EQ(static_cast<int>(finder.pockets().size()) + 1, pores.components(narrow));
      }
    }
  }
  EXPECT_GT(pockets, 100);
  EXPECT_GT(with_mouths, 20);
  EXPECT_GT(several, 20);
}

}  // namespace
