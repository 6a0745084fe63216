// Contacts, curvatures and dual complexes of molecules against values that another program computed with 113 bits,
// confirmed by CGAL's alpha shapes (numbers of simplices of each kind) and Voronota-LT (areas, to its six digits).
//
// Where a molecule's file is not there the test says "skipped".
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "lattice_lengths.hpp"
#include "library_run.hpp"
#include "molecule_balls.hpp"

namespace {

struct DualRow {
  const char *file;
  double probe;
  double contact_area, mean;    // angstrom^2, angstrom
  double by_centres, by_probe;  // the length of dM/dc, and dM/dprobe
  int gauss;                    // of 4 pi
  std::array<uint32_t, 4> singular, regular, interior;
  std::array<uint32_t, 3> betti{};  // zeros: not known
};

constexpr uint32_t unknown = UINT32_MAX;

void compare_dual(const DualRow &row, const std::filesystem::path &file, support::Records records) {
  constexpr auto units = static_cast<double>(steps_per_angstrom);
  const std::vector<support::Atom> atoms = support::read_atoms(file, records);
  const oracle::Balls balls = oracle::on_lattice(with_radii(atoms, support::Radii::metals_as_sulfur), row.probe, units);
  const LibraryBoundary boundary(balls);
  const auto n = static_cast<uint32_t>(balls.size());

  support::OwnedContacts contacts;
  contacts.take(support::contacts_limits_for(boundary.handle()));
  contacts.compute([&](hsp_contacts *handle, hsp_contacts_limits *limits) {
    return hsp_contacts_compute(handle, boundary.handle(), limits);
  });
  uint32_t invariant = 0, id = 0;
  expect_ok(hsp_contacts_check(contacts.get(), &invariant, &id), "hsp_contacts_check");
  const auto list = support::all_records<hsp_contact>(
      [&](auto... out) { return hsp_contacts_get_pairs(contacts.get(), out...); }, "hsp_contacts_get_pairs");
  double area = 0.0;
  for (const hsp_contact &contact : list) area += contact.area / units / units;
  EXPECT_NEAR(area, row.contact_area, 1e-13 * row.contact_area);

  hsp_complex complex{};
  expect_ok(hsp_contacts_get_complex(contacts.get(), &complex), "hsp_contacts_get_complex");
  for (size_t d = 0; d < 4; ++d) {
    if (row.singular[d] == unknown) {
      EXPECT_EQ(complex.singular[d] + complex.regular[d] + complex.interior[d], row.interior[d]) << d;
    } else {
      EXPECT_EQ(complex.singular[d], row.singular[d]) << d;
      EXPECT_EQ(complex.regular[d], row.regular[d]) << d;
      EXPECT_EQ(complex.interior[d], row.interior[d]) << d;
    }
  }
  EXPECT_EQ(complex.euler, row.gauss);
  EXPECT_EQ(2 * complex.euler, boundary.counts().euler);
  EXPECT_EQ(complex.betti[0], boundary.counts().components);
  EXPECT_EQ(complex.betti[2], boundary.counts().voids);
  for (size_t d = 0; d < 3 && row.betti[0] > 0; ++d) EXPECT_EQ(complex.betti[d], row.betti[d]) << d;

  hsp_curvatures curvatures{};
  expect_ok(hsp_boundary_curvature(boundary.handle(), &curvatures, nullptr, nullptr, 0, nullptr), "curvature");
  const double scale = std::fabs(row.mean) + static_cast<double>(n);
  EXPECT_NEAR(curvatures.mean / units, row.mean, 1e-13 * scale);
  EXPECT_NEAR(curvatures.gauss, 4 * std::numbers::pi * row.gauss, 1e-12 * std::abs(row.gauss));
  hsp_morphometry_request bending{};
  bending.struct_size = sizeof bending;
  bending.bending = 1.0;
  hsp_morphometric_energy energy{};
  std::vector<double> by_centre(3 * size_t{n});
  hsp_morphometry_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &energy;
  outputs.d_centre = by_centre.data();
  expect_ok(hsp_boundary_get_morphometry(boundary.handle(), &bending, &outputs), "morphometry");
  double square = 0.0;
  for (const double x : by_centre) square += x * x;
  EXPECT_EQ(energy.mean, curvatures.mean);
  EXPECT_NEAR(std::sqrt(square), row.by_centres, 1e-11 * row.by_centres);
  EXPECT_NEAR(energy.d_probe, row.by_probe, 1e-11 * scale);
}

// As far as the numbers of kinds are known: elsewhere all simplices of a dimension stand under interior.
constexpr std::array<uint32_t, 4> not_told{unknown, unknown, unknown, unknown};

TEST(DualReferenceRows, OfCrambin) {
  for (const DualRow &row : {DualRow{"crambin.pdb",
                                     0,
                                     2331.41786533733,
                                     1075.92293580892,
                                     184.271935563057,
                                     -1981.00371176851,
                                     -34,
                                     not_told,
                                     {},
                                     {327, 1004, 837, 194},
                                     {1, 35, 0}},
                             DualRow{"crambin.pdb",
                                     1.4,
                                     6610.26605369680,
                                     250.028140463776,
                                     19.0380208186020,
                                     6.71925911667347,
                                     2,
                                     not_told,
                                     {},
                                     {327, 1991, 3092, 1426},
                                     {1, 0, 1}}}) {
    compare_dual(row, support::own_molecule(row.file), support::Records::all);
  }
}

TEST(DualReferenceRows, OfHaemoglobin) {
  const std::optional<std::filesystem::path> file = support::further_molecule("4hhb.pdb.gz");
  if (!file) GTEST_SKIP() << "4hhb.pdb.gz is not in the folder of further molecules";
  for (const DualRow &row : {DualRow{"4hhb.pdb.gz",
                                     0,
                                     31127.9709872344,
                                     13918.6702796790,
                                     1084.6395898367,
                                     -32128.800082975,
                                     -556,
                                     {0, 568, 2318, 0},
                                     {4384, 12171, 6574, 0},
                                     {0, 174, 1449, 2368}},
                             DualRow{"4hhb.pdb.gz",
                                     1.4,
                                     91913.9271587017,
                                     -377.855490259286,
                                     631.2940462925,
                                     3546.7590839617,
                                     42,
                                     {0, 17, 191, 0},
                                     {2896, 9163, 6058, 0},
                                     {1488, 20015, 40237, 21633}}}) {
    compare_dual(row, *file, support::Records::protein);
  }
}

}  // namespace
