// Vertices kept in little memory: whatever is found is what was kept last under its name, whatever was thrown out.
#include "surface/kept_vertices.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "random_numbers.hpp"

namespace {

using hsp::WideFloat;

// A number without a pattern, or 0; with an error if it is a quotient.
WideFloat any_number(support::Random &random, uint32_t bits) {
  const auto whole = [&random] { return static_cast<int64_t>(random.below(1U << 30)) - (1 << 29); };
  if (random.below(5) == 0) return WideFloat(0, bits);
  const WideFloat a(whole(), bits, static_cast<int32_t>(random.below(200)) - 100), b(1 + 2 * whole(), bits);
  return random.below(2) == 0 ? a : a / b;
}

void expect_same(const WideFloat &a, const WideFloat &b) {
  int32_t size = 0, other_size = 0;
  EXPECT_EQ(a.leading(size), b.leading(other_size));
  EXPECT_EQ(size, other_size);
  EXPECT_EQ(a.error_exponent(), b.error_exponent());
  EXPECT_EQ(a.sign(), b.sign());
  ASSERT_EQ(a.words(), b.words());
  for (uint32_t k = 0; k < a.words(); ++k) EXPECT_EQ(a.word(k), b.word(k));
}

TEST(KeptVertices, AreThoseThatWereKept) {
  for (const uint32_t room : {0U, 15U, 16U, 40U, 200U, 3000U}) {
    SCOPED_TRACE(room);
    support::Random random(room);
    std::vector<uint64_t> memory(room, ~uint64_t{0});
    hsp::KeptVertices kept({memory.data(), room});
    std::map<std::pair<uint32_t, uint32_t>, hsp::NumberVector<WideFloat>> all;
    std::map<uint32_t, double> doubles;
    int found = 0, lost = 0;
    for (int turn = 0; turn < 3000; ++turn) {
      const uint32_t vertex = random.below(30) < 20 ? random.below(10) : ~random.below(10);
      const uint32_t bits = 64 * (1 + random.below(12));
      hsp::NumberVector<hsp::BoundedDouble> rounded;
      if (kept.find(vertex, 53, rounded)) {
        ++found;
        EXPECT_EQ(rounded.z.value, doubles[vertex]);
        EXPECT_EQ(rounded.x.error, doubles[vertex] / 2);
      } else {
        doubles[vertex] = random.fraction();
        kept.keep(vertex, 53, hsp::NumberVector<hsp::BoundedDouble>{{1, doubles[vertex] / 2}, 2.0, doubles[vertex]});
      }
      hsp::NumberVector<WideFloat> x;
      const bool is_there = kept.find(vertex, bits, x);
      hsp::NumberVector<WideFloat> &mine = all[{vertex, bits}];
      if (is_there) {
        ++found;
        expect_same(x.x, mine.x);
        expect_same(x.y, mine.y);
        expect_same(x.z, mine.z);
      } else {
        ++lost;
        mine = {any_number(random, bits), any_number(random, bits), any_number(random, bits)};
        kept.keep(vertex, bits, mine);
      }
    }
    EXPECT_EQ(found > 0, room >= 16);
    EXPECT_GT(lost, 100);
  }
}

}  // namespace
