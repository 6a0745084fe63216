// Contours of silhouettes that are given by hand: how wide they are, where they begin and end, which level they have.
#include "picture/ink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "small_picture.hpp"

namespace {

using hsp::InkLevel;

// A label on both sides of a ball in front: caller 0 far behind, caller 1 in front.
constexpr cases::SmallBall balls[] = {{0, 0, 0, 100}, {0, 0, 400, 40}};

struct Given {
  std::vector<hsp::SilhouetteArc> arcs;
};

void hand_out(const void *source, uint32_t ball, const hsp::SilhouetteVisitor &visitor) {
  if (cases::small_view().balls().caller[ball] != 1) return;
  bool first = true;
  for (const hsp::SilhouetteArc &arc : static_cast<const Given *>(source)->arcs) {
    visitor(arc, first);
    first = false;
  }
}

uint32_t far_ball() {
  return cases::small_view().balls().caller[0] == 0 ? 0 : 1;
}

struct Drawn {
  std::vector<hsp::InkCurve> curves;
  int loops = 0, closed = 0;
  double width = 0, height = 0, scale = 0;  // of the page

  // How far a point lies outside the front ball, which is in the middle.
  double beyond(const hsp::PagePoint &point) const {
    return std::hypot(point.x - width / 2, point.y - height / 2) - 40 * scale;
  }
};

// Some two px per step; the front ball's contours.
Drawn drawn(const Given &given, InkLevel level, const uint32_t *group = nullptr, double width = 5) {
  cases::small_view().succeeds(balls, 2);
  hsp::PictureOptions options = cases::two_px_per_step(200);
  options.ink_width[0] = width;
  options.ink_width[1] = 4;
  options.ink_width[2] = 6;
  hsp::PictureInput input = cases::picture_input();
  input.silhouettes = {&given, hand_out};
  input.group = group;
  const hsp::Page page = hsp::lay_out(input, options);
  const hsp::Paint paint(input, options, page, cases::small_view().scratch());
  const hsp::Ink ink(input, options, page, paint);
  Drawn result;
  result.width = page.width;
  result.height = page.height;
  result.scale = page.scale;
  EXPECT_TRUE(ink.is_drawn());
  for (uint32_t path = 0; path < input.paths.size(); ++path) {
    ink.visit(path, level, [&](const hsp::InkCurve &curve, bool first, bool closes) {
      result.curves.push_back(curve);
      result.loops += first ? 1 : 0;
      result.closed += closes ? 1 : 0;
    });
  }
  EXPECT_EQ(result.loops, result.closed);
  return result;
}

constexpr hsp::SilhouetteArc::End creases{false, false, hsp::no_id, hsp::no_id};

TEST(Ink, OfAWholeCircleHasOneWidth) {
  const double pi = std::numbers::pi;
  const Given given{
      {{-pi, pi, hsp::no_id, {true, false, hsp::no_id, hsp::no_id}, {true, false, hsp::no_id, hsp::no_id}}}};
  const Drawn found = drawn(given, InkLevel::border);
  EXPECT_EQ(found.loops, 1);
  ASSERT_GT(found.curves.size(), 8U);
  for (size_t k = 0; k < found.curves.size(); ++k) {
    const bool outer = k < found.curves.size() / 2;
    for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      EXPECT_NEAR(found.beyond(found.curves[k].at(t)), outer ? 0.62 * 5 : -0.38 * 5, 0.21) << k << ' ' << t;
    }
    EXPECT_EQ(found.curves[k].behind_line, k == found.curves.size() / 2);
  }
  EXPECT_TRUE(drawn(given, InkLevel::depth).curves.empty());
  EXPECT_TRUE(drawn(given, InkLevel::border, nullptr, 0).curves.empty());
}

// The gap is 400 - 100 sqrt(1 - .4^2) steps, and the mean radius 70: more than three of them.
TEST(Ink, IsNothingWhereASilhouetteCreases) {
  cases::small_view().succeeds(balls, 2);
  const Given given{{{0, 1, far_ball(), creases, creases}}};
  const Drawn found = drawn(given, InkLevel::depth);
  ASSERT_FALSE(found.curves.empty());
  EXPECT_NEAR(found.beyond(found.curves.front().start), 0, 1e-9);
  EXPECT_NEAR(found.beyond(found.curves.back().end), 0, 1e-9);
  double widest = 0;
  for (const hsp::InkCurve &curve : found.curves) {
    EXPECT_FALSE(curve.behind_line);
    widest = std::max(widest, found.beyond(curve.at(0.5)));
  }
  EXPECT_NEAR(widest, 0.62 * 6, 0.2);
}

// Seen between two nearer bodies along less than eight times the largest width of 6 px, it is thinner; not so before
// the background.
TEST(Ink, IsThinnerInAGap) {
  cases::small_view().succeeds(balls, 2);
  constexpr hsp::SilhouetteArc::End under{false, true, hsp::no_id, hsp::no_id};
  for (const double span : {0.2, 0.4, 0.9}) {
    const Drawn found = drawn({{{0, span, far_ball(), under, under}}}, InkLevel::depth);
    ASSERT_FALSE(found.curves.empty());
    const double share = std::min(1.0, span * 40 * found.scale / 48);
    EXPECT_NEAR(found.beyond(found.curves.front().start), 0.62 * 6 * share * share, 1e-9) << span;
    EXPECT_EQ(share < 1, span < 0.5);
    const Drawn border = drawn({{{0, span, hsp::no_id, under, under}}}, InkLevel::border);
    EXPECT_NEAR(border.beyond(border.curves.front().start), 0.62 * 5, 1e-9) << span;
  }
  const Given open{{{0, 0.1, hsp::no_id, under, {true, false, far_ball(), hsp::no_id}},
                    {0.1, 0.2, far_ball(), {true, false, hsp::no_id, hsp::no_id}, under}}};
  const Drawn beside = drawn(open, InkLevel::depth);
  ASSERT_FALSE(beside.curves.empty());
  EXPECT_NEAR(beside.beyond(beside.curves[beside.curves.size() / 2 - 1].end), 0.62 * 6, 1e-9);
}

TEST(Ink, BelongsToALevel) {
  cases::small_view().succeeds(balls, 2);
  const uint32_t apart[] = {7, 8}, together[] = {7, 7};
  const Given given{{{0, 1, far_ball(), creases, creases}}};
  EXPECT_TRUE(drawn(given, InkLevel::border).curves.empty());
  EXPECT_TRUE(drawn(given, InkLevel::group).curves.empty());
  EXPECT_TRUE(drawn(given, InkLevel::group, together).curves.empty());
  EXPECT_FALSE(drawn(given, InkLevel::group, apart).curves.empty());
  EXPECT_TRUE(drawn(given, InkLevel::depth, apart).curves.empty());
  // As wide as by the depth, which is more.
  const Drawn as_group = drawn(given, InkLevel::group, apart), as_depth = drawn(given, InkLevel::depth);
  EXPECT_NEAR(as_group.beyond(as_group.curves[0].end), as_depth.beyond(as_depth.curves[0].end), 1e-9);
}

// Before the background 9 px, before the ball 6: what is thinner is widened to meet the thicker one.
TEST(Ink, GoesOnWithTheSameWidth) {
  cases::small_view().succeeds(balls, 2);
  const uint32_t far = far_ball();
  const Given given{{{0, 1, hsp::no_id, creases, {true, false, far, hsp::no_id}},
                     {1, 2, far, {true, false, hsp::no_id, hsp::no_id}, creases}}};
  const Drawn border = drawn(given, InkLevel::border, nullptr, 9), depth = drawn(given, InkLevel::depth, nullptr, 9);
  EXPECT_NEAR(border.beyond(border.curves.front().start), 0.62 * 9, 1e-9);
  EXPECT_NEAR(border.beyond(border.curves[border.curves.size() / 2 - 1].end), 0.62 * 9, 1e-9);
  EXPECT_NEAR(depth.beyond(depth.curves.front().start), 0.62 * 9, 1e-9);
  EXPECT_NEAR(depth.beyond(depth.curves[depth.curves.size() / 2 - 1].end), 0, 1e-9);
  // The one begins a hair under the other.
  EXPECT_LT(depth.curves.front().start.y, border.curves[border.curves.size() / 2 - 1].end.y);
}

}  // namespace
