#include "sphere/pairs_of_few.hpp"

namespace hsp {
namespace {

constexpr PairsOfFew list_pairs() {
  PairsOfFew pairs{};
  for (uint32_t things = 2; things <= PairsOfFew::most; ++things) {
    uint32_t p = 0;
    for (uint8_t a = 0; a < things; ++a) {
      for (uint8_t b = static_cast<uint8_t>(a + 1); b < things; ++b, ++p) {
        pairs.j[things][p] = a;
        pairs.k[things][p] = b;
        pairs.first[things][a] |= UINT32_C(1) << p;
        pairs.second[things][b] |= UINT32_C(1) << p;
        for (uint32_t bits = 0; things == PairsOfFew::most && bits < 16; ++bits) {
          if ((bits >> p % 4 & 1U) == 0) continue;
          pairs.matrix[p / 4][bits] |= UINT64_C(1) << (8 * a + b) | UINT64_C(1) << (8 * b + a);
        }
      }
    }
  }
  return pairs;
}

}  // namespace

constinit const PairsOfFew pairs_of_few = list_pairs();

}  // namespace hsp
