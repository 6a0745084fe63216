// The lines between strands in maps of balls and sticks, against lines of sight through points beside each axis.
#include "maps/strand_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "built_sticks.hpp"
#include "molecule_balls.hpp"
#include "random_balls.hpp"

namespace {

using Point = std::array<double, 3>;
using oracle::Balls;

const std::vector<hsp::StickStrands> kinds = {hsp::StickStrands::two, hsp::StickStrands::dashed, hsp::StickStrands::one,
                                              hsp::StickStrands::three};

struct Piece {
  std::array<double, 2> from, to;
};

// By the caller's numbers of sticks. The contour is beside the axis by the whole radius; rings of level
// sticks are lines across it.
std::vector<std::vector<Piece>> pieces_of(const BuiltSticks &built) {
  std::vector<std::vector<Piece>> pieces(built.ends().size());
  for (uint32_t path = 0; path < built.view().paths.size(); ++path) {
    const hsp::StickPath &record = built.view().paths[path];
    built.builder().paths().visit(
        built.balls(), path, hsp::PathPart::lines, [&](const hsp::ProjectedArc &arc, bool first, bool closes) {
          if (record.stick == hsp::no_id || arc.ellipse.minor[0] != 0 || arc.ellipse.minor[1] != 0) return;
          const hsp::Stick &stick = built.view().sticks[record.stick];
          const double way[2] = {arc.end[0] - arc.start[0], arc.end[1] - arc.start[1]};
          if (std::abs(way[1] * stick.e[0] - way[0] * stick.e[1]) > 1e-3 * std::hypot(way[0], way[1])) return;
          const double middle[2] = {(arc.start[0] + arc.end[0]) / 2 - stick.foot.x,
                                    (arc.start[1] + arc.end[1]) / 2 - stick.foot.y};
          if (std::abs(middle[1] * stick.e[0] - middle[0] * stick.e[1]) > 0.9 * stick.radius) return;
          EXPECT_TRUE(first && !closes);
          pieces[stick.caller].push_back({{arc.start[0], arc.start[1]}, {arc.end[0], arc.end[1]}});
        });
  }
  return pieces;
}

double height_of(const oracle::PlainBall &ball, double x, double y) {
  const double dx = x - ball.centre[0], dy = y - ball.centre[1];
  const double squared = ball.radius * ball.radius - dx * dx - dy * dy;
  return squared > 0 ? ball.centre[2] + std::sqrt(squared) : -std::numeric_limits<double>::infinity();
}

// Whether a ball or another cylinder is before a point of a cylinder.
bool is_covered(const PlainSticks &scene, size_t own, double x, double y, double z) {
  for (const oracle::PlainBall &ball : scene.balls)
    if (height_of(ball, x, y) > z) return true;
  for (size_t k = 0; k < scene.cylinders.size(); ++k)
    if (k != own && oracle::front_of(scene.cylinders[k], x, y).depth > z) return true;
  return false;
}

double distance_to(const Piece &piece, double x, double y) {
  const double way[2] = {piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]};
  const double at[2] = {x - piece.from[0], y - piece.from[1]};
  const double squared = way[0] * way[0] + way[1] * way[1];
  const double part = squared > 0 ? std::clamp((way[0] * at[0] + way[1] * at[1]) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(at[0] - part * way[0], at[1] - part * way[1]);
}

// In radii to the left on the way from the first ball to the second, and whether that side is dashed.
std::vector<std::pair<double, bool>> sides_of(hsp::StickStrands kind) {
  switch (kind) {
    case hsp::StickStrands::one:
      return {};
    case hsp::StickStrands::two:
      return {{0.28, false}, {-0.28, false}};
    case hsp::StickStrands::three:
      return {{0.58, false}, {0.21, false}, {-0.21, false}, {-0.58, false}};
    default:
      return {{0.28, false}, {-0.28, true}};
  }
}

struct Count {
  int seen = 0, hidden = 0;
};

// Points where so little decides that roundings may are left out.
void expect_lines(const BuiltSticks &built, Count &count) {
  ASSERT_EQ(built.status(), hsp::Status::ok);
  ASSERT_TRUE(built.builder().map().exist);
  const PlainSticks scene(built);
  const std::vector<std::vector<Piece>> pieces = pieces_of(built);
  for (size_t k = 0; k < scene.cylinders.size(); ++k) {
    const oracle::PlainCylinder &cylinder = scene.cylinders[k];
    const oracle::PlainBall &one = scene.balls[built.ends()[k][0]], &two = scene.balls[built.ends()[k][1]];
    Point axis{};
    for (size_t i = 0; i < 3; ++i) axis[i] = cylinder.to[i] - cylinder.from[i];
    const double length = std::hypot(axis[0], axis[1], axis[2]), seen = std::hypot(axis[0], axis[1]) / length;
    const double r = cylinder.radius, near = 1e-3 * r;
    const double out = std::sqrt(one.radius * one.radius - r * r), in = std::sqrt(two.radius * two.radius - r * r);
    if (sides_of(built.strands_of(k)).empty()) {
      EXPECT_TRUE(pieces[k].empty());
    }
    if (seen < 0.01 || out + in >= length) continue;
    for (double &x : axis) x /= length;
    const double e[2] = {axis[0] / seen, axis[1] / seen};
    for (const auto &[left, dashed] : sides_of(built.strands_of(k))) {
      const double up = std::sqrt(1 - left * left) * r;
      for (int step = 1; step < 30; ++step) {
        const double part = step / 30.0, s = out + part * (length - in - out);
        const double x = cylinder.from[0] + s * axis[0] - left * r * e[1] - up * axis[2] * e[0];
        const double y = cylinder.from[1] + s * axis[1] + left * r * e[0] - up * axis[2] * e[1];
        const double z = cylinder.from[2] + s * axis[2] + up * seen;
        const double of_dash = 4 * part - std::floor(4 * part) - 0.5;
        if (dashed && std::abs(std::abs(of_dash) - 0.25) < 0.02) continue;
        const bool wanted = !dashed || std::abs(of_dash) < 0.25;
        const bool covered = is_covered(scene, k, x, y, z);
        bool clear = is_covered(scene, k, x, y, z - near) == covered && is_covered(scene, k, x, y, z + near) == covered;
        for (const double move : {-near, near}) {
          clear = clear && is_covered(scene, k, x + move, y, z) == covered &&
                  is_covered(scene, k, x, y + move, z) == covered;
        }
        if (!clear) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Piece &piece : pieces[k]) nearest = std::min(nearest, distance_to(piece, x, y));
        ASSERT_EQ(nearest < near / 10, wanted && !covered) << k << " " << left << " " << part << " " << nearest / r;
        ++(covered ? count.hidden : count.seen);
      }
    }
  }
}

TEST(StrandLines, OfMolecules) {
  for (const char *name : {"caffeine.pdb", "acetyl_coa.pdb", "crambin.pdb"}) {
    const StickModel model = sticks_between_close(read_molecule(support::own_molecule(name)), 0.25);
    const bool large = model.balls.size() > 100;
    Count count;
    for (const std::array<double, 3> &towards :
         {std::array<double, 3>{0.37, -0.61, 0.83}, std::array<double, 3>{0, 0, 1}, std::array<double, 3>{1, 1, 1}}) {
      for (const bool whole : {false, true}) {
        if (large && count.seen > 0) continue;
        expect_lines(BuiltSticks(model.balls, model.ends, 120, towards, whole, true, kinds), count);
      }
    }
    EXPECT_GT(count.seen, 1000) << name;
    EXPECT_GT(count.hidden, large ? 1000 : 50) << name;
  }
}

// Balls that meet have no order, and sticks seen along the axis or level are there, too.
TEST(StrandLines, OfStars) {
  oracle::RandomSource random(47);
  Count count;
  for (int time = 0; time < 200; ++time) {
    StickModel model{{{0, 0, 0, 400}}, {}};
    const size_t n = 1 + random.below(6);
    for (size_t k = 1; k <= n; ++k) {
      oracle::LatticeBall ball = oracle::ball_in_box(random, 1500, 200, 500);
      if (time % 3 == 0) ball.z = 0;
      model.balls.push_back(ball);
      model.ends.push_back(random.below(2) == 0 ? BuiltSticks::Ends{0, static_cast<uint32_t>(k)}
                                                : BuiltSticks::Ends{static_cast<uint32_t>(k), 0});
    }
    const BuiltSticks built(model.balls, model.ends, 20.0 + static_cast<double>(random.below(60)), {0, 0, 1},
                            time % 2 == 0, true, kinds);
    if (built.status() == hsp::Status::ok) expect_lines(built, count);
  }
  EXPECT_GT(count.seen, 1000);
  EXPECT_GT(count.hidden, 100);
}

}  // namespace
