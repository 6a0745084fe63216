// Windings against a walk through the copies of a box whose sides are bent to rings of several lengths.
#include "periodic/windings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "carved_memory.hpp"
#include "random_balls.hpp"

namespace {

struct Pair {
  uint32_t i, j;
  hsp::BoxShift shift;
};

class CarvedWindings {
 public:
  CarvedWindings(uint32_t balls, const std::vector<Pair> &pairs) {
    memory_.carve(windings, balls);
    windings.reset(balls);
    for (const Pair &pair : pairs) EXPECT_TRUE(windings.join(pair.i, pair.j, pair.shift));
    count = windings.number();
  }
  hsp::Windings windings;
  uint32_t count = 0;

 private:
  CarvedMemory memory_;
};

uint32_t wrapped(int64_t x, uint32_t length) {
  const int64_t rest = x % length;
  return static_cast<uint32_t>(rest < 0 ? rest + length : rest);
}

uint32_t place(int64_t x, int64_t y, int64_t z, uint32_t length) {
  return (wrapped(x, length) * length + wrapped(y, length)) * length + wrapped(z, length);
}

// Which copies of each ball are reached from ball `start` in its place, in length^3 copies of the box.
std::vector<std::vector<bool>> walk(uint32_t n, const std::vector<Pair> &pairs, uint32_t start, uint32_t length) {
  std::vector<std::vector<bool>> reached(n, std::vector<bool>(length * length * length));
  std::vector<std::array<uint32_t, 4>> todo{{start, 0, 0, 0}};
  reached[start][0] = true;
  while (!todo.empty()) {
    const std::array<uint32_t, 4> from = todo.back();
    todo.pop_back();
    const auto step = [&](uint32_t to, const hsp::BoxShift &shift, int sign) {
      const uint32_t at[3] = {wrapped(int64_t{from[1]} + sign * shift.k[0], length),
                              wrapped(int64_t{from[2]} + sign * shift.k[1], length),
                              wrapped(int64_t{from[3]} + sign * shift.k[2], length)};
      const uint32_t p = place(at[0], at[1], at[2], length);
      if (reached[to][p]) return;
      reached[to][p] = true;
      todo.push_back({to, at[0], at[1], at[2]});
    };
    for (const Pair &pair : pairs) {
      if (pair.i == from[0]) step(pair.j, pair.shift, 1);
      if (pair.j == from[0]) step(pair.i, pair.shift, -1);
    }
  }
  return reached;
}

// The same for the start alone, from its lattice.
std::vector<bool> copies_in(const hsp::WindingLattice &lattice, uint32_t length) {
  std::vector<bool> reached(length * length * length);
  const int64_t n = length;
  for (int64_t a = 0; a < (lattice.rank > 0 ? n : 1); ++a) {
    for (int64_t b = 0; b < (lattice.rank > 1 ? n : 1); ++b) {
      for (int64_t c = 0; c < (lattice.rank > 2 ? n : 1); ++c) {
        int64_t at[3];
        for (int k = 0; k < 3; ++k) at[k] = a * lattice.row[0][k] + b * lattice.row[1][k] + c * lattice.row[2][k];
        reached[place(at[0], at[1], at[2], length)] = true;
      }
    }
  }
  return reached;
}

void expect_echelon_form(const hsp::WindingLattice &lattice) {
  int last = -1;
  for (uint32_t r = 0; r < lattice.rank; ++r) {
    int pivot = 0;
    while (pivot < 3 && lattice.row[r][pivot] == 0) ++pivot;
    ASSERT_LT(pivot, 3);
    EXPECT_GT(pivot, last);
    last = pivot;
    EXPECT_GT(lattice.row[r][pivot], 0);
    for (uint32_t above = 0; above < r; ++above) {
      EXPECT_GE(lattice.row[above][pivot], 0);
      EXPECT_LT(lattice.row[above][pivot], lattice.row[r][pivot]);
    }
  }
}

TEST(Windings, AreThoseOfAWalk) {
  oracle::RandomSource random(311);
  uint32_t of_rank[4] = {};
  for (int set = 0; set < 400; ++set) {
    const uint32_t n = 1 + random.below(6);
    std::vector<Pair> pairs(random.below(9));
    for (Pair &pair : pairs) {
      pair.i = random.below(n);
      pair.j = random.below(n);
      for (int32_t &k : pair.shift.k) k = random.one_in(2) ? 0 : static_cast<int32_t>(random.in(-3, 3));
    }
    const CarvedWindings built(n, pairs);
    uint32_t count = 0;
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t component = built.windings.component(i);
      ASSERT_LT(component, built.count);
      const bool is_first = built.windings.first_ball(component) == i;
      EXPECT_EQ(component, is_first ? count : component);
      count += is_first ? 1U : 0U;
      const hsp::WindingLattice &lattice = built.windings.lattice(component);
      expect_echelon_form(lattice);
      ++of_rank[lattice.rank];
      for (const uint32_t length : {5U, 6U, 8U}) {
        const auto reached = walk(n, pairs, i, length);
        EXPECT_EQ(reached[i], copies_in(lattice, length));
        for (uint32_t j = 0; j < n; ++j) {
          const bool any = std::find(reached[j].begin(), reached[j].end(), true) != reached[j].end();
          EXPECT_EQ(any, built.windings.component(j) == component);
        }
      }
    }
    EXPECT_EQ(count, built.count);
    // In another order, and every pair the other way round, the rows are the same.
    std::vector<Pair> others;
    for (const uint32_t k : random.permutation(pairs.size())) {
      others.push_back({pairs[k].j, pairs[k].i, hsp::BoxShift{} - pairs[k].shift});
    }
    const CarvedWindings again(n, others);
    ASSERT_EQ(again.count, built.count);
    for (uint32_t c = 0; c < built.count; ++c) {
      EXPECT_EQ(again.windings.lattice(c).rank, built.windings.lattice(c).rank);
      for (int r = 0; r < 3; ++r) {
        for (int k = 0; k < 3; ++k) EXPECT_EQ(again.windings.lattice(c).row[r][k], built.windings.lattice(c).row[r][k]);
      }
    }
  }
  for (const uint32_t times : of_rank) EXPECT_GT(times, 50U);
}

TEST(Windings, CountTheCopiesThatStayApart) {
  const auto copies = [](const std::vector<std::array<int64_t, 3>> &generators) {
    hsp::WindingLattice lattice;
    for (const auto &g : generators) {
      const int64_t generator[3] = {g[0], g[1], g[2]};
      EXPECT_TRUE(lattice.add(generator));
    }
    return lattice.copies();
  };
  EXPECT_EQ(copies({}), 1U);
  EXPECT_EQ(copies({{1, 0, 0}}), 1U);
  EXPECT_EQ(copies({{6, -9, 0}}), 3U);
  EXPECT_EQ(copies({{2, 0, 0}, {1, 1, 0}}), 2U);
  EXPECT_EQ(copies({{0, 2, 4}, {0, 0, 3}}), 6U);
  EXPECT_EQ(copies({{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}), 2U);
  EXPECT_EQ(copies({{2, 0, 0}, {0, 3, 0}, {0, 0, 5}}), 30U);
  const int64_t most = INT32_MAX;
  const uint64_t square = static_cast<uint64_t>(most) * static_cast<uint64_t>(most);
  EXPECT_EQ(copies({{most, 0, 0}, {0, most, 0}, {0, 0, 4}}), 4 * square);
  EXPECT_EQ(copies({{most, 0, 0}, {0, most, 0}, {0, 0, 5}}), 0U);
}

TEST(Windings, RefuseNumbersThatAreTooLarge) {
  hsp::WindingLattice lattice;
  const int64_t large[3] = {INT64_C(1) << 31, 0, 0};
  EXPECT_FALSE(lattice.add(large));
  const int64_t first[3] = {INT32_MAX, 1, 0};
  const int64_t second[3] = {2, 5, 0};
  EXPECT_TRUE(lattice.add(first));
  EXPECT_FALSE(lattice.add(second));  // Euclid's algorithm leads to 5 2^30
}

}  // namespace
