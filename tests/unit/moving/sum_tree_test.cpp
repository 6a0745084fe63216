// Sums of terms that change are those of summation.hpp, bit for bit.
#include "moving/sum_tree.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "carved_memory.hpp"
#include "core/summation.hpp"
#include "random_numbers.hpp"

namespace {

TEST(SumTree, IsTheSumOfAllTerms) {
  support::Random random(5);
  CarvedMemory memory;
  hsp::SumTree<2> tree;
  memory.carve(tree, 200U);
  for (uint32_t n = 0; n <= 200; ++n) {
    std::vector<hsp::SumTerm<2>> terms(n);
    tree.resize(n);
    const auto change = [&](uint32_t k) {
      const double a = random.fraction() - 0.25;
      const double b = random.fraction() * 0x1p60;
      terms[k] = {{a, b}};
      tree.set(k, terms[k]);
    };
    for (uint32_t k = 0; k < n; ++k) change(n - 1 - k);
    for (int round = 0; round < 4; ++round) {
      tree.update();
      hsp::TreeSum a, b;
      for (const hsp::SumTerm<2> &term : terms) {
        a.add(term.of[0]);
        b.add(term.of[1]);
      }
      const hsp::SumTerm<2> total = tree.total();
      EXPECT_EQ(std::bit_cast<uint64_t>(total.of[0]), std::bit_cast<uint64_t>(a.total())) << n;
      EXPECT_EQ(std::bit_cast<uint64_t>(total.of[1]), std::bit_cast<uint64_t>(b.total())) << n;
      for (int k = 0; k < 3 && n > 0; ++k) change(random.below(n));
    }
  }
}

}  // namespace
