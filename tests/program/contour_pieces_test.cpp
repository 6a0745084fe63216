// Contours of pictures of triangles: levels that close gaps, end in points and leave no hairs.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

extern "C" {
#include "draw/contour_pieces.h"
}

namespace {

constexpr contour_limits limits{20, 2, 50, 0.1, 300};

class Contours {
 public:
  ~Contours() { contour_pieces_free(&pieces_); }
  Contours() = default;
  Contours(const Contours &) = delete;
  Contours &operator=(const Contours &) = delete;

  // A chain along x of pieces as long as `length`, from vertex to vertex.
  void add_chain(const std::vector<double> &levels, uint32_t first, double length, bool outline = false) {
    for (size_t k = 0; k < levels.size(); ++k) {
      const double x = length * static_cast<double>(k);
      const auto vertex = static_cast<uint32_t>(first + k);
      add({{{x, 0}, {x + length, 0}}, {vertex, vertex + 1}, levels[k], outline, {0, 0}, 0, false});
    }
  }
  void add(const contour_piece &piece) { contour_pieces_add(&pieces_, &piece); }
  void set_levels() { ASSERT_TRUE(contour_pieces_level(&pieces_, 1000, &limits)); }
  [[nodiscard]] contour_piece &piece(size_t k) const { return pieces_.piece[k]; }
  [[nodiscard]] double level(size_t k, double share) const {
    return contour_piece_level(&pieces_.piece[k], limits.slope, share);
  }

 private:
  contour_pieces pieces_ = CONTOUR_PIECES_NONE;
};

TEST(ContourPieces, EndInPoints) {
  Contours contours;
  contours.add_chain(std::vector<double>(20, 8), 0, 10);
  contours.set_levels();
  for (size_t k = 0; k < 20; ++k) {
    for (const double share : {0.0, 0.3, 1.0}) {
      const double from_start = 10 * (static_cast<double>(k) + share);
      EXPECT_NEAR(contours.level(k, share), std::fmin(8, 0.1 * std::fmin(from_start, 200 - from_start)), 1e-12);
    }
  }
}

// Something nearer lies before an end without a vertex: the contour goes on under it.
TEST(ContourPieces, KeepTheirWidthWhereTheyAreHidden) {
  Contours contours;
  contours.add_chain(std::vector<double>(20, 8), 0, 10);
  contours.piece(19).vertex[1] = NO_CONTOUR_VERTEX;
  contours.set_levels();
  EXPECT_EQ(contours.level(0, 0), 0);
  EXPECT_EQ(contours.level(19, 1), 8);
}

TEST(ContourPieces, OutlinesAreRoundedOff) {
  Contours contours;
  contours.add_chain(std::vector<double>(20, 8), 0, 10, true);
  contours.set_levels();
  EXPECT_NEAR(contours.level(1, 0), 4, 1e-12);
  EXPECT_EQ(contours.level(2, 0), 8);
}

// Nor where they go on hidden from a vertex on, which others do not.
TEST(ContourPieces, OutlinesKeepTheirWidthWhereTheyGoOn) {
  for (const bool outline : {true, false}) {
    Contours contours;
    contours.add_chain(std::vector<double>(20, 8), 0, 10, outline);
    contours.add({{{0, 0}, {0, 0}}, {20, NO_CONTOUR_VERTEX}, 0, false, {0, 0}, 0, true});
    contours.set_levels();
    EXPECT_EQ(contours.level(0, 0), 0);
    EXPECT_EQ(contours.level(19, 1), outline ? 8 : 0);
  }
}

TEST(ContourPieces, CloseGapsAndDips) {
  Contours contours;
  contours.add_chain({8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 0, 0, 0, 0, 8, 8, 8, 8, 5, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8}, 0, 10);
  contours.add_chain({8, 8, 8, 8, 8, 8, 8, 8, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8, 8, 8, 8, 8}, 100, 10);
  contours.set_levels();
  for (size_t k = 10; k < 14; ++k) EXPECT_EQ(contours.piece(k).level, 2);
  EXPECT_NEAR(contours.level(9, 0), 3, 1e-12);  // towards what closes the gap
  EXPECT_EQ(contours.piece(18).level, 8);
  for (size_t k = 29 + 8; k < 29 + 14; ++k) EXPECT_EQ(contours.piece(k).level, 0);
  EXPECT_EQ(contours.level(29 + 7, 1), 0);
}

// Hairs that leave a contour or an outline, or are alone; not what meets others at both ends.
TEST(ContourPieces, LeaveNoHairs) {
  Contours contours;
  contours.add_chain(std::vector<double>(40, 8), 0, 10);
  contours.add({{{200, 0}, {200, 30}}, {20, 500}, 3, false, {0, 0}, 0, false});
  contours.add({{{200, 30}, {200, 60}}, {500, 501}, 3, false, {0, 0}, 0, false});
  contours.add({{{100, 0}, {150, 30}}, {10, 600}, 3, false, {0, 0}, 0, false});
  contours.add({{{150, 30}, {300, 0}}, {600, 30}, 3, false, {0, 0}, 0, false});
  contours.add({{{500, 0}, {600, 0}}, {700, 701}, 2.9, false, {0, 0}, 0, false});
  contours.add({{{500, 0}, {600, 0}}, {702, 703}, 3.1, false, {0, 0}, 0, false});
  contours.add_chain(std::vector<double>(10, 8), 800, 10, true);
  contours.add({{{100, 0}, {120, 0}}, {810, 811}, 5, false, {0, 0}, 0, false});
  contours.set_levels();
  for (const size_t hair : {40U, 41U, 44U, 56U}) EXPECT_EQ(contours.piece(hair).level, 0) << hair;
  for (const size_t other : {20U, 42U, 43U, 45U, 55U}) EXPECT_GT(contours.piece(other).level, 0) << other;
  EXPECT_EQ(contours.level(20, 0), 8);
  EXPECT_EQ(contours.level(55, 1), 8);  // the outline goes on under what ends there
  EXPECT_EQ(contours.level(46, 0), 0);
}

// A level is the least of all levels of the chain and the slope from there, and of the slope from ends: at points of
// chains and rings of pieces at random, by a look at all pieces.
TEST(ContourPieces, NoLevelIsMoreThanAnotherAndTheSlopeFromThere) {
  constexpr contour_limits slope_alone{0, 2, 0, 0.1, 0};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any_length(1, 30), any_level(0.5, 12);
  for (int trial = 0; trial < 20; ++trial) {
    const bool ring = trial % 2 == 1;
    const uint32_t count = 3 + static_cast<uint32_t>(trial);
    std::vector<double> begin{0}, level;
    contour_pieces pieces = CONTOUR_PIECES_NONE;
    for (uint32_t k = 0; k < count; ++k) {
      begin.push_back(begin[k] + any_length(random));
      level.push_back(any_level(random));
      const contour_piece piece{{{begin[k], 0}, {begin[k + 1], 0}},
                                {k, ring && k + 1 == count ? 0 : k + 1},
                                level[k],
                                false,
                                {0, 0},
                                0,
                                false};
      contour_pieces_add(&pieces, &piece);
    }
    const double whole = begin[count];
    ASSERT_TRUE(contour_pieces_level(&pieces, count + 1, &slope_alone));
    for (uint32_t k = 0; k < count; ++k) {
      for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double at = begin[k] + share * (begin[k + 1] - begin[k]);
        double least = ring ? level[k] : std::fmin(level[k], 0.1 * std::fmin(at, whole - at));
        for (uint32_t j = 0; j < count; ++j) {
          double away = std::fmax(0, std::fmax(begin[j] - at, at - begin[j + 1]));
          // The other way round.
          if (ring && j != k) away = std::fmin(away, whole - std::fmax(begin[j + 1] - at, at - begin[j]));
          least = std::fmin(least, level[j] + 0.1 * away);
        }
        EXPECT_NEAR(contour_piece_level(&pieces.piece[k], slope_alone.slope, share), least, 1e-9)
            << "trial " << trial << ", piece " << k;
      }
    }
    contour_pieces_free(&pieces);
  }
}

}  // namespace
