// Areas, volumes and numbers of vertices of molecules from 24 to 164965 atoms against values found by other programs;
// the same of their smooth surfaces.
//
// Where a molecule's file is not there the test says "skipped".
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lattice_lengths.hpp"
#include "library_run.hpp"
#include "molecule_balls.hpp"
#include "owned_surfaces.hpp"

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

// ---- smooth surfaces, for a probe of 1.4 unless another one is given ----

// The values are those of an independent program in doubles, whose areas and volumes agree with lines through the
// definition, with V' = -A and with quadrature of the concave patches.
struct SmoothRow {
  double area, volume;
  double convex, saddle, concave;
  uint32_t concave_patches, cut, cusped;  // cusped: arcs and whole circles
};

// To `digits` of a relative precision; lengths are in angstrom.
void compare_smooth(const support::BallList &list, const SmoothRow &row, double digits,
                    double units = static_cast<double>(steps_per_angstrom), double probe = 1.4) {
  const LibraryBoundary boundary(oracle::on_lattice(list, 0, units), 1, probe * units);
  support::OwnedSurface surface;
  surface.take(support::surface_limits_for(boundary.handle()));
  surface.compute([&](hsp_surface *handle, hsp_surface_limits *limits) {
    return hsp_surface_compute(handle, boundary.handle(), limits);
  });
  hsp_surface_totals totals;
  hsp_surface_counts counts;
  expect_ok(hsp_surface_measure(surface.get(), &totals, nullptr, 0, nullptr), "hsp_surface_measure");
  expect_ok(hsp_surface_get_counts(surface.get(), &counts), "hsp_surface_get_counts");
  const double unit = 1 / units;
  EXPECT_NEAR(totals.area * unit * unit, row.area, digits * row.area);
  EXPECT_NEAR(totals.volume * unit * unit * unit, row.volume, digits * row.volume);
  if (row.convex > 0) {
    // Their sum is known to more digits than they are.
    const double printed = std::max(digits, 1e-9) * row.area;
    EXPECT_NEAR(totals.convex_area * unit * unit, row.convex, printed);
    EXPECT_NEAR(totals.saddle_area * unit * unit, row.saddle, printed);
    EXPECT_NEAR(totals.concave_area * unit * unit, row.concave, printed);
  }
  if (row.concave_patches > 0) {
    EXPECT_EQ(counts.concave_patches, row.concave_patches);
    EXPECT_EQ(counts.cut_patches, row.cut);
    EXPECT_EQ(counts.cusped_patches, row.cusped);
    EXPECT_EQ(counts.open_joints, 0U);
  }
}

TEST(ReferenceRows, SmoothSurfacesOfTheProjectsOwnMolecules) {
  const auto atoms = [](const char *name) {
    return with_radii(support::read_atoms(support::own_molecule(name)), support::Radii::metals_as_sulfur);
  };
  compare_smooth(atoms("caffeine.pdb"),
                 {182.6053055199, 164.3407116951, 86.9990059303, 78.4289742200, 17.1773253697, 58, 0, 0}, 1e-12);
  const support::BallList crambin = atoms("crambin.pdb");
  struct Probed {
    double probe;
    SmoothRow row;
  };
  for (const Probed &c :
       {Probed{1, {2653.999024201, 4368.192803430, 1142.157188, 948.779605, 563.062230, 650, 59, 33}},
        Probed{1.4, {2319.064883323, 4664.897270837, 860.388078879, 896.522219402, 562.154585041, 480, 38, 21}},
        Probed{3, {2091.274679908, 5207.368683474, 427.302757, 826.304128, 837.667795, 314, 13, 7}},
        Probed{6, {2022.630997030, 5798.829886572, 217.529117, 716.857773, 1088.244106, 208, 15, 9}}}) {
    SCOPED_TRACE(c.probe);
    compare_smooth(crambin, c.row, 1e-12, static_cast<double>(steps_per_angstrom), c.probe);
  }
}

// Rings, a void, and lattices, whose values are the limits of inflated balls.
TEST(ReferenceRows, SmoothSurfacesOfSymmetricSets) {
  support::BallList ring, cavity, grid, wide_grid;
  constexpr double diagonal = 3.11126984;
  constexpr double rings[8][3] = {
      {4.4, 0, 0},     {diagonal, diagonal, -0.04}, {0, 4.4, -0.04}, {-diagonal, diagonal, 0},
      {-4.4, 0, 0.08}, {-diagonal, -diagonal, 0.2}, {0, -4.4, 0.36}, {diagonal, -diagonal, 0.56}};
  for (const auto &c : rings) ring.add(c[0], c[1], c[2], 1.7);
  for (int k = 0; k < 40; ++k) {
    const double z = 4.8 * (1 - (2 * k + 1) / 40.0);
    const double turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double rho = std::sqrt(4.8 * 4.8 - z * z);
    const auto rounded = [](double x) { return std::nearbyint(x * 1e8) / 1e8; };
    cavity.add(rounded(rho * std::cos(turn)), rounded(rho * std::sin(turn)), rounded(z), 1.7);
  }
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        grid.add(x, y, z, 0.9);
        wide_grid.add(2.6 * x, 2.6 * y, 2.6 * z, 1.2);
      }
    }
  }
  compare_smooth(ring, {261.5695947954, 183.4017052863, 158.156503965, 103.41309083, 0, 0, 0, 0}, 1e-11, 1e8);
  compare_smooth(cavity, {641.9377902208, 792.6536298566, 244.616174726, 262.826528217, 134.495087278, 0, 0, 0}, 1e-11,
                 1e8);
  compare_smooth(grid, {67.6596077, 45.5116003, 0, 0, 0, 0, 0, 0}, 2e-9);
  compare_smooth(wide_grid, {304.230888, 331.901243, 0, 0, 0, 0, 0, 0}, 2e-9);
}

// Saddles that reach their axis, probes that cut each other around a throat and from inside and outside of a void; four
// and eight spheres through one point, whose values are the limits of inflated balls.
TEST(ReferenceRows, SmoothSurfacesOfSmallSets) {
  struct SmallSet {
    const char *name;
    std::vector<std::array<double, 4>> balls;
    double probe;
    SmoothRow row;
    double digits;
  };
  constexpr double a = 1.79555934;
  const auto triangle = [](double x, double left, double y) {
    return std::vector<std::array<double, 4>>{{x, 0, 0, 1.7}, {left, y, 0, 1.7}, {left, -y, 0, 1.7}};
  };
  std::vector<std::array<double, 4>> corners;
  for (const double x : {-0.8, 0.8}) {
    for (const double y : {-1.6, 1.6}) {
      for (const double z : {-1.6, 1.6}) corners.push_back({x, y, z, 1});
    }
  }
  const SmallSet sets[] = {
      {"two far",
       {{0, 0, 0, 1.7}, {5.4, 0, 0, 1.7}},
       1.4,
       {74.82423590186, 41.80379383311, 67.9475820122, 6.8766538896, 0, 0, 0, 0},
       1e-12},
      {"two far, a larger probe",
       {{0, 0, 0, 1.7}, {5.4, 0, 0, 1.7}},
       3,
       {80.96140531381, 47.93581275002, 57.1796599912, 23.7817453226, 0, 0, 0, 0},
       1e-12},
      {"spindle",
       {{0, 0, 0, 1.7}, {6.1, 0, 0, 1.7}},
       1.4,
       {72.64919880183, 41.16523321646, 72.0478671336, 0.6013316682, 0, 0, 0, 0},
       1e-12},
      {"spindle of two sizes",
       {{0, 0, 0, 2}, {5.6, 0, 0, 1.2}},
       1.4,
       {68.61845656966, 40.84146738944, 66.2984492731, 2.3200072966, 0, 0, 0, 0},
       1e-12},
      {"small on large",
       {{0, 0, 0, 1.7}, {1.9, 0, 0, 0.3}},
       1.4,
       {36.93770058142, 20.82937123191, 34.3749409815, 2.5627595996, 0, 0, 0, 0},
       1e-12},
      {"throat",
       triangle(2.9, -1.45, 2.51147367),
       1.4,
       {119.8830024625, 66.99444771262, 89.1358433827, 24.3930994435, 6.35405963625, 0, 0, 0},
       1e-12},
      {"throat, almost open",
       triangle(3.09, -1.545, 2.6760185),
       1.4,
       {116.3057233727, 64.01665722428, 94.0598133676, 21.1175258521, 1.12838415294, 0, 0, 0},
       1e-12},
      {"open throat",
       triangle(3.2, -1.6, 2.77128129),
       1.4,
       {112.4921565405, 62.85155162832, 97.3975152429, 15.0946412977, 0, 0, 0, 0},
       1e-12},
      {"void",
       {{a, a, a, 1.7}, {a, -a, -a, 1.7}, {-a, a, -a, 1.7}, {-a, -a, a, 1.7}},
       1.4,
       {167.6627434343, 92.23100491818, 108.55494545, 36.4811662779, 22.6266317068, 8, 8, 0},
       1e-12},
      {"four through a point",
       {{2.1, 0, 0, 1.7}, {0, 2.1, 0, 1.7}, {-2.1, 0, 0, 1.7}, {0, -2.1, 0, 1.7}},
       1.4,
       {114.7810576, 87.0340342, 0, 0, 0, 0, 0, 0},
       1e-9},
      {"eight through a point", corners, 1.4, {103.3358454, 50.3578564, 0, 0, 0, 0, 0, 0}, 2e-9},
  };
  for (const SmallSet &set : sets) {
    SCOPED_TRACE(set.name);
    support::BallList list;
    for (const auto &[x, y, z, radius] : set.balls) list.add(x, y, z, radius);
    compare_smooth(list, set.row, set.digits, 1e8, set.probe);
  }
}

struct SmoothMolecule {
  const char *file;
  SmoothRow row;
  support::Records records = support::Records::all;
};

class FurtherSmoothSurfaces : public testing::TestWithParam<SmoothMolecule> {};

TEST_P(FurtherSmoothSurfaces, HaveTheReferenceValues) {
  const std::optional<std::filesystem::path> file = support::further_molecule(GetParam().file);
  if (!file) GTEST_SKIP() << GetParam().file << " is not in the folder of further molecules";
  const std::vector<support::Atom> atoms = support::read_atoms(*file, GetParam().records);
  compare_smooth(with_radii(atoms, support::Radii::metals_as_sulfur), GetParam().row, 2e-11);
}

INSTANTIATE_TEST_SUITE_P(
    ReferenceRows, FurtherSmoothSurfaces,
    testing::Values(
        SmoothMolecule{"sod_model_4392.pdb",
                       {26481.54187164, 64728.10394243, 7956.864091, 9613.698104, 8910.979677, 6118, 1168, 691}},
        SmoothMolecule{"4hhb.pdb.gz",
                       {27504.00120672, 66429.91120292, 7561.786539, 10052.156501, 9890.058167, 6440, 1162, 693},
                       protein},
        SmoothMolecule{"3l5q.xyz.gz",
                       {450726.2207037, 1256785.601979, 104926.763, 159128.862, 186670.595, 111558, 24514, 14479}},
        SmoothMolecule{"6zu5.cif.gz",
                       {940989.7379, 2341230.46209, 233066.176, 351389.967, 356533.595, 234356, 45751, 27220}}),
    [](const testing::TestParamInfo<SmoothMolecule> &molecule) {
      const std::string file = molecule.param.file;
      return file.substr(0, file.find('.'));
    });

}  // namespace
