// The widest probe is that of the search without pores, bit for bit, and takes fewer cuts of free space into cells.
#include "pockets/gate_finder.hpp"

#include <gtest/gtest.h>

#include "checked_pores.hpp"
#include "sweep_length.hpp"

namespace {

template <class Finder, class Balls>
hsp::Status find(Finder &finder, CarvedMemory &memory, const Balls &balls, uint32_t n, const hsp::exact::Vector &from,
                 const hsp::exact::Vector *to, hsp::WidestProbe &widest) {
  hsp::ProbeLimits limits;
  static_cast<void>(hsp::default_limits(n, limits));
  for (int retry = 0;; ++retry) {
    memory.carve(finder, limits);
    const hsp::Status status = finder.find(balls, from, to, widest);
    if (status != hsp::Status::capacity || retry > 40) return status;
    limits = finder.retry_limits();
  }
}

TEST(GateFinder, FindsWhatTheSearchWithoutPoresDoes) {
  oracle::RandomSource random(1);
  uint32_t with = 0, without = 0;
  int gates = 0, ends = 0, closed = 0;
  for (int turn = 0; turn < oracle::sets(48); ++turn) {
    const oracle::Balls balls = turn % 2 == 0 ? pore_sets::general_set(random, 30, turn / 2 % pore_sets::general_kinds)
                                              : pore_sets::tied_set(random, 20, turn / 2 % pore_sets::tied_kinds);
    const BuiltPores pores(balls, 0);
    if (pores.maxima().empty()) continue;
    for (int k = 0; k < 3; ++k) {
      const auto place = [&] {
        const auto last = static_cast<int64_t>(pores.maxima().size()) - 1;
        const hsp::Vec3 &at = pores.maxima()[static_cast<uint32_t>(random.in(0, last))].point.position;
        const int64_t aside = k == 2 ? 150000000 : 9;
        return hsp::exact::Vector{std::llround(at.x) + random.in(-aside, aside), std::llround(at.y),
                                  std::llround(at.z)};
      };
      const hsp::exact::Vector from = place(), to = place();
      const hsp::exact::Vector *const end = k == 0 ? nullptr : &to;
      const auto n = static_cast<uint32_t>(balls.size());
      hsp::GateFinder finder;
      hsp::WidestProbeFinder plain;
      CarvedMemory memory, memory_of_plain;
      hsp::WidestProbe found{}, expected{};
      const hsp::Status status = find(finder, memory, pores.grid(), n, from, end, found);
      ASSERT_EQ(status, find(plain, memory_of_plain, pores.grid().balls(), n, from, end, expected));
      if (status != hsp::Status::ok) continue;
      ASSERT_EQ(found.passes, expected.passes);
      ASSERT_EQ(found.radius, expected.radius) << oracle::to_text(balls);
      for (size_t b = 0; b < 3; ++b) ASSERT_EQ(found.gate[b], expected.gate[b]);
      ASSERT_LE(finder.builds(), plain.builds());
      with += finder.builds();
      without += plain.builds();
      ++(!found.passes ? closed : found.gate[2] != hsp::no_id ? gates : ends);
      // No room for pores of more balls than limits can have.
      ASSERT_EQ(finder.needed().balls, n);
    }
  }
  EXPECT_GT(gates, 10);
  EXPECT_GT(ends, 3);
  EXPECT_GT(closed, 3);
  EXPECT_LT(4 * with, without);
}

// More balls that tie than a word has bits.
TEST(GateFinder, ManyBallsThatTie) {
  const oracle::Balls balls = pore_sets::shell(100000, 30000);
  const auto n = static_cast<uint32_t>(balls.size());
  const BuiltGrid grid(BuiltPores::listed(balls));
  hsp::GateFinder finder;
  hsp::WidestProbeFinder plain;
  CarvedMemory memory, memory_of_plain;
  hsp::WidestProbe found{}, expected{};
  ASSERT_EQ(find(finder, memory, grid.grid(), n, {0, 0, 0}, nullptr, found), hsp::Status::ok);
  ASSERT_EQ(find(plain, memory_of_plain, grid.grid().balls(), n, {0, 0, 0}, nullptr, expected), hsp::Status::ok);
  EXPECT_TRUE(found.passes);
  EXPECT_EQ(found.radius, expected.radius);
  EXPECT_LT(finder.builds(), plain.builds());
}

}  // namespace
