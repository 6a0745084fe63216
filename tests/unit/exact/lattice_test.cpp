// Rounding to the decimal lattice: what is written with few decimals is represented exactly.
#include "lattice_cases.hpp"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "expect_cases.hpp"

namespace {

using hsp::nearest;
using hsp::exact::Lattice;

TEST(Lattice, DecimalTextIsExactUpToTheLimit) {
  cases::Random random(9);
  for (int digits = 0; digits <= 12; ++digits) {
    double step = 1.0;
    for (int k = 0; k < digits; ++k) step *= 10;
    const Lattice lattice = Lattice::with_step(1.0 / step);
    EXPECT_EQ(lattice.step(), 1.0 / step);
    for (int k = 0; k < 20000; ++k) {
      const int64_t steps = random.in(-(int64_t{1} << 50), (int64_t{1} << 50) - 1);
      const int64_t absolute = steps < 0 ? -steps : steps;
      const int64_t unit = static_cast<int64_t>(step);
      char text[64];
      std::snprintf(text, sizeof text, "%s%" PRId64 ".%0*" PRId64, steps < 0 ? "-" : "", absolute / unit,
                    digits == 0 ? 1 : digits, absolute % unit);
      EXPECT_EQ(nearest(lattice.steps(std::strtod(text, nullptr))), steps) << text << " digits " << digits;
    }
  }
}

TEST(Lattice, Cases) {
  expect_cases(cases::exact_lattice);
}

}  // namespace
