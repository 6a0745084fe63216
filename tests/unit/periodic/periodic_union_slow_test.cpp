// Many random and degenerate boxes against their explicit copies.
#include "periodic_crystals.hpp"
#include "sweep_length.hpp"

namespace {

TEST(PeriodicUnionSlow, IsThatOfManyCopies) {
  oracle::RandomSource random(341);
  for (int set = 0; set < oracle::rounds(250, 10000) && !HasFailure(); ++set) {
    expect_as_in_copies(RandomCrystal(random, set % 4 != 0));
  }
}

}  // namespace
