#include "branch_predictor.hpp"

#if defined(__x86_64__) && defined(__ELF__)

#include <array>
#include <cstdint>

// The predictor of cachegrind and callgrind has 2^14 counters of two bits: one for each pair of an address modulo 128
// and the outcomes of the last 7 branches. Below stands one branch at each address modulo 128. Each branch goes four
// times through a de Bruijn sequence of order 7, in which every 7 outcomes in a row occur once and so have one
// successor: three times saturate a counter. The loop around a branch must have no other conditional branch, hence the
// conditional move.
//
// void settle_branches(const uint64_t *outcomes, uint64_t last): outcomes are bits `last` .. 0.
__asm__(R"(
  .pushsection .text.settle_branches, "ax", @progbits
  .p2align 7
  .globl settle_branches
  .type settle_branches, @function
settle_branches:
  .set residue, 0
  .rept 128
  lea 0f(%rip), %rax
  lea 2f(%rip), %rdx
  mov %rsi, %rcx
  .p2align 7
  .fill (residue + 124) & 127, 1, 0x90
0:
  bt %rcx, (%rdi)
  jc 1f
  nop
1:
  mov %rax, %r8
  sub $1, %rcx
  cmovb %rdx, %r8
  jmp *%r8
2:
  .set residue, residue + 1
  .endr
  ret
  .size settle_branches, . - settle_branches
  .popsection
)");
extern "C" void settle_branches(const uint64_t *outcomes, uint64_t last);

namespace bench {
namespace {

constexpr uint32_t period = 128;
constexpr uint32_t repetitions = 4;

// Martin's algorithm: append a one unless the seven bits that end in it have occurred.
constexpr std::array<uint64_t, period * repetitions / 64> de_bruijn_outcomes() {
  std::array<bool, period> occurred{};
  std::array<uint64_t, period * repetitions / 64> outcomes{};
  uint32_t last_seven = 0;
  for (uint32_t i = 0; i < period; ++i) {
    const uint32_t with_one = (2 * last_seven + 1) % period;
    const bool one = !occurred[with_one];
    last_seven = one ? with_one : 2 * last_seven % period;
    occurred[last_seven] = true;
    for (uint32_t bit = i; one && bit < period * repetitions; bit += period) {
      outcomes[bit / 64] |= uint64_t{1} << bit % 64;
    }
  }
  return outcomes;
}

constexpr std::array outcomes = de_bruijn_outcomes();

}  // namespace

void settle_branch_predictor() {
  settle_branches(outcomes.data(), period * repetitions - 1);
}

}  // namespace bench

#else

void bench::settle_branch_predictor() {}

#endif
