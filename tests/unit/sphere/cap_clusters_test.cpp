#include "cap_clusters_cases.hpp"

#include "expect_cases.hpp"

TEST(CapClusters, Cases) {
  expect_cases(cases::sphere_cap_clusters);
}
