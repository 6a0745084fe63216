// Areas, volumes and numbers of vertices of molecules from 24 to 164965 atoms against values found by other programs.
//
// Where a molecule's file is not there the test says "skipped".
#include <gtest/gtest.h>

#include <cmath>

#include "lattice_lengths.hpp"
#include "library_run.hpp"
#include "molecule_balls.hpp"

namespace {

struct Row {
  const char *file;
  double probe;
  uint32_t balls;
  long double area;    // angstrom^2
  long double volume;  // angstrom^3
  uint32_t vertices;
  support::Records records = support::Records::all;
};

// Areas and volumes by quadrature over slices (tanh-sinh between all heights at which the slice changes), to as many
// digits as are known, with 1.80 as the radius of metals too; the numbers of vertices as exposed triple points, and
// again as regular facets plus twice the singular ones of the alpha complex.
void compare(const Row &row, const std::filesystem::path &file) {
  constexpr auto units = static_cast<double>(steps_per_angstrom);
  const std::vector<support::Atom> atoms = support::read_atoms(file, row.records);
  const oracle::Balls balls = oracle::on_lattice(with_radii(atoms, support::Radii::metals_as_sulfur), row.probe, units);
  ASSERT_EQ(balls.size(), row.balls);
  const LibraryBoundary boundary(balls);
  const hsp_totals totals = boundary.measure().totals;
  constexpr long double unit = 1 / static_cast<long double>(units);
  const long double area = static_cast<long double>(totals.area) * unit * unit;
  const long double volume = static_cast<long double>(totals.volume) * unit * unit * unit;
  EXPECT_LE(std::abs(area - row.area), 1e-13L * row.area) << row.file << " probe " << row.probe << ": " << area;
  EXPECT_LE(std::abs(volume - row.volume), 1e-13L * row.volume) << row.file << " probe " << row.probe << ": " << volume;
  EXPECT_EQ(boundary.counts().vertices, row.vertices) << row.file << " probe " << row.probe;
}

TEST(ReferenceRows, OfTheProjectsOwnMolecules) {
  for (const Row &row : {Row{"caffeine.pdb", 0, 24, 195.00674996282L, 156.45605721238L, 44},
                         Row{"caffeine.pdb", 1.4, 24, 359.26018591633L, 537.89953553947L, 58},
                         Row{"crambin.pdb", 0, 327, 4247.6562115516L, 3571.7031090322L, 898},
                         Row{"crambin.pdb", 1.4, 327, 2971.3230159967L, 8357.3215455062L, 480}})
    compare(row, support::own_molecule(row.file));
}

constexpr auto protein = support::Records::protein;

class FurtherMolecules : public testing::TestWithParam<Row> {};

TEST_P(FurtherMolecules, HaveTheReferenceValues) {
  const std::optional<std::filesystem::path> file = support::further_molecule(GetParam().file);
  if (!file) GTEST_SKIP() << GetParam().file << " is not in the folder of further molecules";
  compare(GetParam(), *file);
}

INSTANTIATE_TEST_SUITE_P(
    ReferenceRows, FurtherMolecules,
    testing::Values(Row{"sod_model_4392.pdb", 0, 4392, 54707.431825958L, 46963.926065318L, 11852},
                    Row{"sod_model_4392.pdb", 1.4, 4392, 27797.577444215L, 102677.04158677L, 6118},
                    Row{"4hhb.pdb.gz", 0, 4384, 56392.742355758L, 47593.011959852L, 11210, protein},
                    Row{"4hhb.pdb.gz", 1.4, 4384, 26109.528532295L, 103970.05672332L, 6440, protein},
                    Row{"3l5q.xyz.gz", 0, 79452, 1020503.3194064L, 857215.30412613L, 215376},
                    Row{"3l5q.xyz.gz", 1.4, 79452, 366176.9610790L, 1828041.9217116L, 111558},
                    Row{"6zu5.cif.gz", 0, 164965, 2000392.1443771L, 1697465.5851185L, 435374},
                    Row{"6zu5.cif.gz", 1.4, 164965, 823043.05896426L, 3585654.7324477L, 234356}),
    [](const testing::TestParamInfo<Row> &row) {
      const std::string file = row.param.file;
      return file.substr(0, file.find('.')) + (row.param.probe > 0 ? "Accessible" : "VanDerWaals");
    });

}  // namespace
