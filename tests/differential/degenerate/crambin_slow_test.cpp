// The ground of crambin's rows in the degenerate list: its boundary by brute force, its measures by slices.
#include <gtest/gtest.h>

#include <cmath>

#include "brute_boundary.hpp"
#include "molecule_balls.hpp"
#include "peers_inputs.hpp"
#include "set_checks.hpp"
#include "slice_quadrature.hpp"

namespace {

oracle::Balls crambin_in_thousandths() {
  return read_molecule(support::own_molecule("crambin.pdb"));
}

TEST(CrambinSlow, BoundaryOfBruteForce) {
  const oracle::BoundaryRecord record = oracle::brute_boundary(crambin_in_thousandths());
  EXPECT_EQ(record.vertices.size(), degenerate::crambin_vertices);
  EXPECT_EQ(degenerate::to_text(degenerate::topology_of(record)), degenerate::to_text(degenerate::crambin_topology));
  EXPECT_EQ(degenerate::brute_force_disagrees(crambin_in_thousandths()), "");
}

TEST(CrambinSlow, AreaAndVolumeOfSlices) {
  const oracle::SliceMeasures measures = oracle::measure_by_slices(oracle::real_balls(crambin_in_thousandths()));
  EXPECT_LE(std::abs(measures.area * 1e-6L - degenerate::crambin_area), 1e-13L * degenerate::crambin_area);
  EXPECT_LE(std::abs(measures.volume * 1e-9L - degenerate::crambin_volume), 1e-13L * degenerate::crambin_volume);
}

}  // namespace
