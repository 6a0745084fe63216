// Second derivatives of areas and volume: their invariants, agreement with gradients and rows of areas, and arrays that
// are too short.
#include <hessian_invariants.h>

#include "computed_set.hpp"
#include "guarded_output.hpp"

namespace {

void require_sound(const char *broken) {
  FUZZ_REQUIRE(broken == nullptr, broken);
}

void require_short_arrays(const computed &c, fuzz::Bytes &bytes) {
  std::vector<uint32_t> first(c.n + 1);
  uint32_t entries = 0, needed = 0;
  const int32_t counted =
      hsp_boundary_get_hessian_rows(c.boundary, nullptr, first.data(), nullptr, nullptr, nullptr, 0, &entries);
  FUZZ_REQUIRE(counted == (entries > 0 ? HSP_E_CAPACITY : HSP_OK), "the number of blocks");
  if (entries == 0) return;
  const uint32_t room = bytes.below(entries);
  fuzz::Output<uint32_t> ball(room, false);
  fuzz::Output<double> block(9 * room, false);
  FUZZ_REQUIRE(hsp_boundary_get_hessian_rows(c.boundary, nullptr, first.data(), ball.data(), block.data(), nullptr,
                                             room, &needed) == HSP_E_CAPACITY &&
                   needed == entries && ball.untouched_from(0) && block.untouched_from(0),
               "rows in too short an array");
  const std::vector<double> direction(3 * size_t{c.n});
  fuzz::Output<double> product(3 * (c.n - 1), false);
  FUZZ_REQUIRE(hsp_boundary_get_hessian_product(c.boundary, nullptr, direction.data(), product.data(), nullptr, c.n - 1,
                                                &needed) == HSP_E_CAPACITY &&
                   needed == c.n && product.untouched_from(0),
               "a product in too short an array");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const uint32_t tangency = bytes.below(2);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 32);
  const fuzz::ComputedSet result(set);
  const computed &c = result.get();
  std::vector<double> sigma(set.n() + 1);
  for (double &s : sigma) s = (bytes.below(17) - 8.0) / 4;
  require_sound(broken_hessian(&c, nullptr, 0, 1.5, tangency));
  require_sound(broken_hessian(&c, sigma.data(), 1.5, 0, tangency));
  require_sound(broken_hessian(&c, sigma.data(), 1.5, -0.25, tangency));
  require_short_arrays(c, bytes);
  return 0;
}
