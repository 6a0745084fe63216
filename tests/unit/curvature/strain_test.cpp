// Sums of products of vectors, in the order of rows.
#include "curvature/strain.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Strain, HasTheFirstVectorAlongItsRows) {
  hsp::StrainSum sum;
  sum.add(2.0, {1.0, 2.0, 3.0}, {5.0, 7.0, 11.0});
  sum.add(-1.0, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0});
  const hsp::Strain strain = sum.total();
  const double expected[9] = {10.0, 14.0, 22.0, 20.0, 28.0, 44.0, 29.0, 42.0, 66.0};
  for (int k = 0; k < 9; ++k) EXPECT_EQ(strain.by[k], expected[k]);
  EXPECT_EQ(strain.trace(), 104.0);
  EXPECT_EQ(hsp::Strain{}.trace(), 0.0);
}

}  // namespace
