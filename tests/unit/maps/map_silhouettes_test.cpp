// Silhouettes of maps in runs: each edge that is one appears once, angles go on, and the ends say what the map says. Of
// balls and sticks they are where a z-buffer shows them, before what it shows there.
#include "maps/map_paths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "built_map.hpp"
#include "built_sticks.hpp"
#include "molecule_balls.hpp"
#include "picture/ink.hpp"
#include "random_balls.hpp"

namespace {

struct Taken {
  hsp::SilhouetteArc arc;
  bool first;
};

template <class Map>
std::vector<Taken> taken_of(const Map &map, uint32_t ball) {
  std::vector<Taken> taken;
  const hsp::SilhouetteVisitor visitor{&taken, [](void *context, const hsp::SilhouetteArc &arc, bool first) {
                                         static_cast<std::vector<Taken> *>(context)->push_back({arc, first});
                                       }};
  hsp::silhouettes_of(map).visit(ball, visitor);
  return taken;
}

TEST(MapSilhouettes, AreTheSilhouettesOfTheMap) {
  oracle::RandomSource random(12);
  size_t under = 0, creased = 0, gone_on = 0, crossed = 0;
  for (int time = 0; time < 10; ++time) {
    const BuiltMap built(oracle::loose_balls(random, 60), {1, 2, 3});
    const hsp::VisibilityMap &map = built.map();
    size_t expected = 0, found = 0;
    double span = 0, expected_span = 0;
    for (const hsp::MapEdge &edge : map.edges.items()) {
      if (!edge.is_silhouette()) continue;
      ++expected;
      expected_span += edge.to - edge.from;
    }
    for (uint32_t ball = 0; ball < 60; ++ball) {
      const std::vector<Taken> taken = taken_of(map, ball);
      found += taken.size();
      for (size_t k = 0; k < taken.size(); ++k) {
        const hsp::SilhouetteArc &arc = taken[k].arc;
        span += arc.to - arc.from;
        EXPECT_LE(arc.from, arc.to);
        EXPECT_NE(arc.behind, ball);
        EXPECT_FALSE(arc.start.goes_on && arc.start.goes_under);
        for (const hsp::SilhouetteArc::End *end : {&arc.start, &arc.end}) {
          gone_on += end->goes_on ? 1 : 0;
          under += end->goes_under ? 1 : 0;
          creased += !end->goes_on && !end->goes_under ? 1 : 0;
          crossed += end->goes_on && end->crossed != hsp::no_id ? 1 : 0;
          if (end->goes_under) {
            EXPECT_EQ(end->other, end->crossed);
          }
        }
        if (k == 0 || taken[k].first) {
          EXPECT_TRUE(taken[k].first);
          continue;
        }
        const hsp::SilhouetteArc &before = taken[k - 1].arc;
        EXPECT_TRUE(before.end.goes_on && arc.start.goes_on);
        EXPECT_NEAR(before.to, arc.from, 1e-6);
        EXPECT_EQ(before.end.other, arc.behind);
        EXPECT_EQ(arc.start.other, before.behind);
      }
    }
    EXPECT_EQ(found, expected);
    EXPECT_NEAR(span, expected_span, 1e-6);
  }
  EXPECT_GT(under, 100U);
  EXPECT_GT(creased, 100U);
  EXPECT_GT(gone_on, 100U);
  EXPECT_GT(crossed, 20U);
}

// A small ball before a large one, and beside it: the background is no ball, and whole circles go on where they begin.
TEST(MapSilhouettes, OfAWholeCircle) {
  const BuiltMap built({{0, 0, 0, 1000}, {100, 0, 5000, 200}}, {0, 0, 1});
  const hsp::VisibilityMap &map = built.map();
  size_t before_a_ball = 0, before_nothing = 0;
  for (uint32_t ball = 0; ball < 2; ++ball) {
    const std::vector<Taken> taken = taken_of(map, ball);
    ASSERT_EQ(taken.size(), 1U);
    const hsp::SilhouetteArc &arc = taken[0].arc;
    EXPECT_NEAR(arc.to - arc.from, 2 * std::numbers::pi, 1e-9);
    EXPECT_TRUE(arc.start.goes_on && arc.end.goes_on);
    EXPECT_EQ(arc.start.other, arc.behind);
    EXPECT_EQ(arc.start.crossed, hsp::no_id);
    if (arc.behind == hsp::no_id) {
      ++before_nothing;
    } else {
      EXPECT_EQ(arc.behind, 1 - ball);
      ++before_a_ball;
    }
  }
  EXPECT_EQ(before_a_ball, 1U);
  EXPECT_EQ(before_nothing, 1U);
}

// Both sides of a contour, looked at a little inside and outside: inside the z-buffer shows the body where its
// silhouette is said to be seen and nowhere else, outside what is said to be behind it, as high as it is said to be.
class Compared {
 public:
  explicit Compared(const BuiltSticks &built) : built_(built), plain_(built), scene_(built.builder().map().scene) {
    for (uint32_t body = 0; body < scene_.bodies(); ++body) compare(body);
  }

  size_t seen = 0, unseen = 0, before_sticks = 0, of_sticks = 0, close = 0, wrong = 0;

 private:
  uint32_t name(uint32_t body) const {
    if (body == hsp::no_id) return oracle::no_ball;
    return plain_name(built_, scene_.ball_of(body), scene_.is_ball(body) ? hsp::no_id : scene_.stick_of(body));
  }
  oracle::SeenPixel pixel(double x, double y) const { return plain_.image({x, y, 1, 1, 1})[0]; }

  void compare(uint32_t body) {
    const std::vector<Taken> taken = taken_of(built_.builder().map(), body);
    if (scene_.is_ball(body)) {
      const oracle::PlainBall &ball = plain_.balls[name(body)];
      for (int k = 0; k < 200; ++k) {
        const double t = -std::numbers::pi + (k + 0.37) * std::numbers::pi / 100;
        compare(body, taken, t,
                {ball.centre[0] + ball.radius * std::cos(t), ball.centre[1] + ball.radius * std::sin(t)},
                {std::cos(t), std::sin(t)}, 2 * std::numbers::pi);
      }
      return;
    }
    const hsp::Stick &stick = built_.view().sticks[scene_.stick_of(body)];
    if (built_.whole() && scene_.part_of(body) == 1) return;  // there is no such part
    const oracle::PlainCylinder &cylinder = plain_.cylinders[stick.caller];
    const bool up = cylinder.to[2] > cylinder.from[2];
    const std::array<double, 3> &foot = up ? cylinder.from : cylinder.to, &top = up ? cylinder.to : cylinder.from;
    const double x = top[0] - foot[0], y = top[1] - foot[1], across = std::hypot(x, y);
    for (int k = -60; k < 60; ++k) {
      const double t = (k + 0.51) / 60, side = t > 0 ? 1 : -1, along = std::abs(t);
      const std::array<double, 2> outward{side * y / across, -side * x / across};
      compare(body, taken, t,
              {foot[0] + along * x + cylinder.radius * outward[0], foot[1] + along * y + cylinder.radius * outward[1]},
              outward, 0);
    }
  }

  // The arc with a parameter, which may be some turns away; null if there is none.
  static const hsp::SilhouetteArc *arc_at(const std::vector<Taken> &taken, double t, double turn, bool &near_end) {
    const hsp::SilhouetteArc *found = nullptr;
    for (const Taken &of : taken)
      for (int k = turn > 0 ? -3 : 0; k <= (turn > 0 ? 3 : 0); ++k) {
        const double at = t + k * turn;
        if (of.arc.from <= at && at <= of.arc.to) found = &of.arc;
        near_end = near_end || std::abs(at - of.arc.from) < 0.02 || std::abs(at - of.arc.to) < 0.02;
      }
    return found;
  }

  void compare(uint32_t body, const std::vector<Taken> &taken, double t, const std::array<double, 2> &at,
               const std::array<double, 2> &outward, double turn) {
    const double step = 1e-6 * plain_.largest;
    const oracle::SeenPixel inside = pixel(at[0] - step * outward[0], at[1] - step * outward[1]);
    const oracle::SeenPixel outside = pixel(at[0] + step * outward[0], at[1] + step * outward[1]);
    bool near_end = false;
    const hsp::SilhouetteArc *arc = arc_at(taken, t, turn, near_end);
    bool right = (inside.ball == name(body)) == (arc != nullptr);
    if (arc != nullptr) {
      right = right && outside.ball == name(arc->behind);
      const bool before_stick = arc->behind != hsp::no_id && !scene_.is_ball(arc->behind);
      if (before_stick && !near_end) {
        const hsp::StickMap &map = built_.builder().map();
        right = right && std::abs(hsp::silhouettes_of(map).front_at(arc->behind, at[0], at[1]) - outside.depth) <
                             1e-2 * plain_.largest;
        ++before_sticks;
      }
      of_sticks += scene_.is_ball(body) ? 0 : 1;
    }
    ++(arc != nullptr ? seen : unseen);
    if (near_end) {
      ++close;
    } else if (!right) {
      ++wrong;
    }
  }

  const BuiltSticks &built_;
  PlainSticks plain_;
  const hsp::StickScene &scene_;
};

TEST(MapSilhouettes, OfSticksAreThoseOfAZBuffer) {
  oracle::RandomSource random(46);
  const oracle::Balls caffeine = read_molecule(support::own_molecule("caffeine.pdb"));
  size_t seen = 0, unseen = 0, before_sticks = 0, of_sticks = 0, close = 0;
  for (int time = 0; time < 12; ++time) {
    const auto coordinate = [&] { return static_cast<double>(random.below(2001)) - 1000.5; };
    const StickModel model = sticks_between_close(caffeine, time % 2 == 0 ? 0.3 : 0.5);
    const BuiltSticks built(model.balls, model.ends, 150, {coordinate(), coordinate(), coordinate()}, time % 3 == 0,
                            true);
    ASSERT_EQ(built.status(), hsp::Status::ok) << built.violation();
    const Compared compared(built);
    EXPECT_EQ(compared.wrong, 0U) << time;
    seen += compared.seen;
    unseen += compared.unseen;
    before_sticks += compared.before_sticks;
    of_sticks += compared.of_sticks;
    close += compared.close;
  }
  EXPECT_GT(seen, 5000U);
  EXPECT_GT(unseen, 2000U);
  EXPECT_GT(of_sticks, 500U);
  EXPECT_GT(before_sticks, 50U);
  EXPECT_LT(close, seen / 3);
}

// Of a stick between two balls before the background: from side to side, with the width that is asked for but no wider
// than its radius, and on under the upper half where the contour of the lower one ends.
TEST(MapSilhouettes, GiveSticksContoursAlongBothSides) {
  const BuiltSticks built({{-1000, 0, 0, 300}, {1000, 0, 200, 300}}, {{0, 1}}, 100, {0, 0, 1}, false, true);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::PictureInput input{built.balls(), built.builder().paths(), nullptr, nullptr, nullptr};
  input.silhouettes = hsp::silhouettes_of(built.builder().map());
  for (const double asked : {5.0, 1e6}) {
    hsp::PictureOptions options;
    options.fog = 0;
    options.ink_width[0] = asked;
    std::vector<uint32_t> scratch(input.paths.size());
    const hsp::Page page = hsp::lay_out(input, options);
    const hsp::Paint paint(input, options, page, {scratch.data(), input.paths.size()});
    const hsp::Ink ink(input, options, page, paint);
    const double half = 100 * page.scale, middle = page.height / 2, width = std::min(asked, half);
    int contours = 0;
    double length = 0, first_end = 1e9, last_begin = -1e9;  // of both halves
    for (uint32_t path = 0; path < input.paths.size(); ++path) {
      if (!input.paths.is_plain(path)) continue;
      std::vector<double> beyond;
      double begin = 1e9, end = -1e9;
      ink.visit(path, hsp::InkLevel::border, [&](const hsp::InkCurve &curve, bool first, bool) {
        contours += first ? 1 : 0;
        length += std::abs(curve.end.x - curve.start.x) / 2;
        begin = std::min({begin, curve.start.x, curve.end.x});
        end = std::max({end, curve.start.x, curve.end.x});
        for (const double t : {0.0, 0.5, 1.0}) beyond.push_back((std::abs(curve.at(t).y - middle) - half) / width);
      });
      EXPECT_FALSE(beyond.empty());
      first_end = std::min(first_end, end);
      last_begin = std::max(last_begin, begin);
      for (const double by : beyond) EXPECT_TRUE(std::abs(by - 0.62) < 0.002 || std::abs(by + 0.38) < 0.002) << by;
      ink.visit(path, hsp::InkLevel::depth,
                [&](const hsp::InkCurve &, bool first, bool) { contours += first ? 1 : 0; });
    }
    EXPECT_EQ(contours, 2 + 4);  // before the ball at the foot, and of both halves before the background
    EXPECT_GT(length, 2 * 1300 * page.scale);
    EXPECT_GT(first_end, last_begin + 0.1) << "the halves leave a gap";
  }
}

}  // namespace
