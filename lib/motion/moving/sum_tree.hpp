// The sums of summation.hpp for terms that change one by one: the same tree of additions, with all nodes stored. A
// changed term changes one node on each level of the tree.
#pragma once

#include "core/workspace.hpp"

namespace hsp {

// Several sums over the same terms.
template <uint32_t sums>
struct SumTerm {
  double of[sums];
};

template <uint32_t sums>
class SumTree {
 public:
  using Term = SumTerm<sums>;

  void carve(Workspace &workspace, uint32_t capacity) {
    nodes_ = workspace.take<Term>(2 * static_cast<uint64_t>(capacity));
    changed_ = workspace.take<uint32_t>(capacity);
    marked_ = workspace.take<uint8_t>(2 * static_cast<uint64_t>(capacity));
  }

  // From now on there are so many terms. All have to be set before the next total().
  void resize(uint32_t terms) {
    terms_ = terms;
    change_count_ = 0;
    for (uint8_t &mark : marked_) mark = 0;
  }
  void set(uint32_t k, const Term &term) {
    nodes_[k] = term;
    mark(k, k);
  }
  // Has to be called between set() and total().
  void update() {
    uint32_t children = 0;  // the first node of their level
    uint32_t count = terms_;
    while (change_count_ != 0) {
      const uint32_t parents = children + count;
      const uint32_t parent_count = count / 2;
      const uint32_t changed = change_count_;
      change_count_ = 0;
      for (uint32_t c = 0; c < changed; ++c) {
        const uint32_t child = changed_[c];
        marked_[children + child] = 0;
        const uint32_t k = child / 2;
        if (k >= parent_count || marked_[parents + k] != 0) continue;  // the last child may have no parent
        const Term &left = nodes_[children + 2 * k];
        const Term &right = nodes_[children + 2 * k + 1];
        for (uint32_t s = 0; s < sums; ++s) nodes_[parents + k].of[s] = left.of[s] + right.of[s];
        mark(k, parents + k);
      }
      children = parents;
      count = parent_count;
    }
  }
  // The sum of all terms. Complete subtrees are added from the last one, the smallest, to the first.
  Term total() const {
    Term total{};
    uint32_t level = 0;
    for (uint32_t count = terms_; count != 0; level += count, count /= 2) {
      if (count % 2 == 0) continue;
      for (uint32_t s = 0; s < sums; ++s) total.of[s] = nodes_[level + count - 1].of[s] + total.of[s];
    }
    return total;
  }

 private:
  // Marks node k of its level, which has the number `node` among all.
  void mark(uint32_t k, uint32_t node) {
    if (marked_[node] != 0) return;
    marked_[node] = 1;
    changed_[change_count_++] = k;
  }

  Span<Term> nodes_;        // level after level, the terms first
  Span<uint32_t> changed_;  // the changed nodes of one level, numbered in that level
  Span<uint8_t> marked_;    // [nodes] whether a node is in changed_
  uint32_t terms_ = 0;
  uint32_t change_count_ = 0;
};

}  // namespace hsp
