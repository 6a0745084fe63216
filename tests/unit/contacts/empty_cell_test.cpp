// Buried balls that are said to have nothing: no chord of two caps is left, and no point of the ball is nearest to it.
// Where nothing is left they are nearly all found.
#include "contacts/empty_cell.hpp"

#include <gtest/gtest.h>

#include "contacts/chord_clipper.hpp"
#include "indexed_search.hpp"
#include "set_arrangements.hpp"

namespace {

// Of all pairs of caps.
bool has_chord(const hsp::Caps &caps) {
  CarvedMemory memory;
  hsp::ChordClipper clipper;
  memory.carve(clipper, caps.count);
  clipper.start(caps);
  for (uint32_t j = 0; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      if (hsp::ChordEnds ends; clipper.clip(caps, j, k, ends)) return true;
    }
  }
  return false;
}

bool leaves(const hsp::Caps &caps, const hsp::Vec3 &p) {
  for (uint32_t k = 0; k < caps.count; ++k) {
    if (dot(caps.axis(k), p) > caps.b[k] - 1e-9) return false;
  }
  return true;
}

struct Counts {
  uint32_t cells = 0, empty = 0, without_chords = 0;
};

void expect_empty_cells(oracle::RandomSource &random, const oracle::Balls &balls, Counts &counts) {
  IndexedSearch search(balls);
  for (uint32_t i = 0; i < search.size(); ++i) {
    if (!search.gather(i)) continue;
    hsp::Caps &caps = search.caps;
    caps.first_later = 0;
    if (!search.found().empty()) continue;
    const bool is_empty = hsp::has_empty_cell(caps), chord = has_chord(caps);
    ++counts.cells;
    counts.empty += is_empty ? 1 : 0;
    counts.without_chords += chord ? 0 : 1;
    if (!is_empty) continue;
    EXPECT_FALSE(chord) << oracle::to_text(balls) << " ball " << i;
    for (int sample = 0; sample < 300; ++sample) {
      const auto part = [&random] { return 2 * random.fraction() - 1; };
      const hsp::Vec3 p{part(), part(), part()};
      EXPECT_TRUE(dot(p, p) > 1.0 || !leaves(caps, p)) << oracle::to_text(balls) << " ball " << i;
    }
  }
}

TEST(EmptyCell, HasNoChordAndNoPoint) {
  oracle::RandomSource random(97);
  Counts counts;
  for (int k = 0; k < 150 && !HasFailure(); ++k) {
    const size_t n = static_cast<size_t>(random.in(4, 30));
    expect_empty_cells(random, k % 2 == 0 ? oracle::dense_balls(random, n) : oracle::any_balls(random, n), counts);
  }
  EXPECT_GT(counts.empty, 100U);
  EXPECT_GT(counts.cells, counts.empty + 50U);
  EXPECT_GT(10 * counts.empty, 8 * counts.without_chords);
}

// Planes that nearly agree, and their chords: of these doubles know little.
TEST(EmptyCell, IsFoundWherePlanesNearlyAgree) {
  oracle::RandomSource random(98);
  Counts counts;
  for (const double width : {1.0, 1e-2, 1e-4}) {
    expect_empty_cells(random, oracle::balls_of_near_planes(random, 60, 1000000, 0.5, width), counts);
  }
  EXPECT_GT(counts.empty, 60U);
  EXPECT_EQ(counts.empty, counts.without_chords);
}

// All on a line, or in a plane: no three planes meet in one point.
TEST(EmptyCell, IsNotLookedForWithoutACorner) {
  oracle::RandomSource random(99);
  Counts counts;
  for (int k = 0; k < 400; ++k) {
    expect_empty_cells(random, k % 2 == 0 ? oracle::collinear_balls(random, 12) : oracle::coplanar_balls(random, 12),
                       counts);
  }
  EXPECT_GT(counts.cells, 50U);
  EXPECT_EQ(counts.empty, 0U);
}

}  // namespace
