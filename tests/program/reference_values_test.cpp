// Real molecules against figures that were found by other means: areas, volumes and vertex counts by numerical
// quadrature and by a regular triangulation, and the figures that Halperin and Overmars print in Section 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"

namespace {

struct Reference {
  const char *file;
  const char *probe;
  int balls;
  double area;
  double volume;
  int vertices;
};

// Radii: C 1.70, N 1.55, O 1.52, S 1.80, H 1.10. Areas and volumes are sums of slices by tanh-sinh quadrature, the
// numbers of vertices are exposed triple points counted one by one, confirmed by the alpha complex.
constexpr Reference references[] = {
    {"caffeine.pdb", "0", 24, 195.00674996282, 156.45605721238, 44},
    {"caffeine.pdb", "1.4", 24, 359.26018591633, 537.89953553947, 58},
    {"crambin.pdb", "0", 327, 4247.6562115516, 3571.7031090322, 898},
    {"crambin.pdb", "1.4", 327, 2971.3230159967, 8357.3215455062, 480},
};

TEST(ReferenceValues, AreaVolumeAndVertices) {
  for (const Reference &reference : references) {
    const std::string file = molecules_folder() + "/" + reference.file;
    SCOPED_TRACE(file + " probe " + reference.probe);
    const Json measure = run_json({"measure", file, "--probe", reference.probe});
    EXPECT_EQ(measure["n"].number, reference.balls);
    EXPECT_NEAR(measure["area"].number, reference.area, 1e-12 * reference.area);
    EXPECT_NEAR(measure["volume"].number, reference.volume, 1e-12 * reference.volume);
    const Json boundary = run_json({"boundary", file, "--probe", reference.probe});
    EXPECT_EQ(boundary["n"].number, reference.balls);
    EXPECT_EQ(boundary["vertices"].number, reference.vertices);
    EXPECT_EQ(2 * boundary["arcs"].number, 3 * boundary["vertices"].number);
    EXPECT_EQ(boundary["voids"].number, boundary["shells"].number - boundary["components"].number);
  }
}

// Contacts between residues of crambin, summed up from those of atoms that another program computed with 113 bits.
// It knew residues by their numbers alone: one has an insertion code here.
TEST(ReferenceValues, ContactsOfResidues) {
  const struct {
    const char *probe;
    double area;
    size_t pairs;
    std::map<std::pair<int, int>, double> chosen;
  } rows[] = {{"0",
               420.916667194253,
               81,
               {{{1, 2}, 7.89606554790860}, {{3, 40}, 7.78380051826307}, {{16, 26}, 7.90486417720339}}},
              {"1.4",
               2750.75796874724,
               199,
               {{{1, 2}, 33.7715719480323}, {{3, 40}, 20.5147564349179}, {{16, 26}, 23.8106524595831}}}};
  for (const auto &row : rows) {
    const Json found =
        run_json({"contacts", molecules_folder() + "/crambin.pdb", "--by", "residue", "--probe", row.probe});
    std::map<std::pair<int, int>, double> areas;
    for (const Json &pair : found["pairs"].items) {
      const auto number_of = [&](size_t side) {
        const std::string &name = pair["residues"].items.at(side).text;
        return std::stoi(name.substr(name.rfind(':') + 1));
      };
      const std::pair<int, int> numbers = std::minmax({number_of(0), number_of(1)});
      if (numbers.first != numbers.second) areas[numbers] += pair["area"].number;
    }
    double sum = 0.0;
    for (const auto &[numbers, area] : areas) sum += area;
    EXPECT_EQ(areas.size(), row.pairs) << row.probe;
    EXPECT_NEAR(sum, row.area, 1e-10) << row.probe;
    for (const auto &[numbers, area] : row.chosen) EXPECT_NEAR(areas[numbers], area, 2e-13 * area) << row.probe;
  }
}

// Crambin has a void for a probe of 1.4. The widest probe that gets out of it was found by a search among power
// diagrams in doubles.
TEST(ReferenceValues, WidestProbeOutOfAVoid) {
  const std::string file = molecules_folder() + "/crambin.pdb", start = "9.8,12.2,6.1", outside = "60,0,0";
  const Json gate = run_json({"gate", file, "--from", start});
  EXPECT_NEAR(gate["widest_probe"].number, 0.838840049, 6e-10);
  EXPECT_EQ(gate["gate"].items.size(), 3U);
  const Json path = run_json({"path", file, "--from", start, "--to", outside, "--probe", "0.8388"});
  EXPECT_TRUE(path["connected"].boolean);
  EXPECT_TRUE(path["certified"].boolean);
  EXPECT_GT(path["length"].number, 50.0);
  EXPECT_LT(path["clearance"].number, 0.838840049 - 0.8388 + 1e-7);
  const Json closed = run_json({"path", file, "--from", start, "--to", outside, "--probe", "0.8389"});
  EXPECT_FALSE(closed["connected"].boolean);
  EXPECT_FALSE(closed["covered"].boolean);
  EXPECT_EQ(closed["points"].items.size(), 0U);
}

TEST(ReferenceValues, BallsSumToTheTotal) {
  for (const Reference &reference : references) {
    const std::string file = molecules_folder() + "/" + reference.file;
    const Json measure = run_json({"measure", file, "--probe", reference.probe, "--per-ball"});
    double sum = 0;
    double exposed = 0;
    for (const Json &ball : measure["balls"].items) {
      EXPECT_GE(ball["area"].number, 0.0);
      sum += ball["area"].number;
      exposed += ball["area"].number > 0 ? 1 : 0;
    }
    EXPECT_NEAR(sum, reference.area, 1e-12 * reference.area) << file;
    EXPECT_EQ(run_json({"boundary", file, "--probe", reference.probe})["exposed_balls"].number, exposed) << file;
  }
}

struct PaperRow {
  const char *file;
  int balls;
  double k;
  double rho;
  int most;
  double mean;
};

// The table of Section 2, as printed.
constexpr PaperRow paper_rows[] = {
    {"caffeine.pdb", 24, 2.17, 0.71, 10, 4.5},
    {"crambin.pdb", 327, 1.64, 0.78, 10, 5.5},
};

// A printed figure may be rounded or cut off: it differs by less than one unit of its last digit, and by no more
// than half a unit upwards.
void expect_printed(double value, double printed, double unit) {
  EXPECT_GE(value, printed - 0.5 * unit);
  EXPECT_LT(value, printed + unit);
}

TEST(ReferenceValues, SectionTwoOfThePaper) {
  for (const PaperRow &row : paper_rows) {
    SCOPED_TRACE(row.file);
    const Json model = run_json({"model", molecules_folder() + "/" + row.file, "--radii", "chem3d"});
    EXPECT_EQ(model["n"].number, row.balls);
    expect_printed(model["k"].number, row.k, 0.01);
    expect_printed(model["rho"].number, row.rho, 0.01);
    EXPECT_EQ(model["max_overlaps"].number, row.most);
    expect_printed(model["mean_overlaps"].number, row.mean, 0.1);
  }
}

}  // namespace
