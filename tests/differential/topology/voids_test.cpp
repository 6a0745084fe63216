// The voids of proteins against the dual complex and flood fill: number, volumes, and where points lie.
#include "void_expectations.hpp"

namespace {

TEST(Voids, OfCrambin) {
  expect_voids("crambin, accessible", bench_atoms("crambin.pdb"), 1400, 1.0L);
  expect_voids("crambin, van der Waals", bench_atoms("crambin.pdb"), 0, 1.0L);
}
TEST(Voids, OfUbiquitin) {
  expect_voids("ubiquitin, accessible", bench_atoms("ubiquitin.pdb"), 1400, 1.0L);
  expect_voids("ubiquitin, van der Waals", bench_atoms("ubiquitin.pdb"), 0, 1.0L);
}
TEST(Voids, OfUbiquitinForSmallProbes) {
  expect_voids("ubiquitin, probe 1.0", bench_atoms("ubiquitin.pdb"), 1000, 0.95L);
  expect_voids("ubiquitin, probe 0.5", bench_atoms("ubiquitin.pdb"), 500, 1.0L);
}

TEST(Location, InProteins) {
  expect_locations(bench_atoms("crambin.pdb"), 0, 4000);
  expect_locations(bench_atoms("crambin.pdb"), 1400, 4000);
  expect_locations(bench_atoms("ubiquitin.pdb"), 1000, 4000);
}

}  // namespace
