#include "nested_balls.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "point_lattices.hpp"
#include "set_arrangements.hpp"

namespace {

using Integer = int64_t;
using oracle::Balls;
using oracle::balls_on_circle;
using oracle::balls_on_sphere;
using oracle::cage_of_26;
using oracle::joined;
using oracle::LatticeBall;
using oracle::LatticePoint;
using oracle::RandomSource;

Balls moved(const Balls &balls, Integer x, Integer y, Integer z) {
  return oracle::moved(balls, {x, y, z});
}

Balls without(const Balls &balls, const std::vector<LatticePoint> &centres) {
  Balls result;
  for (const LatticeBall &b : balls)
    if (std::find(centres.begin(), centres.end(), oracle::centre_of(b)) == centres.end()) result.push_back(b);
  return result;
}

Balls box_of_8(const std::array<Integer, 3> &sides, Integer radius) {
  return moved(oracle::box_lattice({2, 2, 2}, sides, radius), -sides[0] / 2, -sides[1] / 2, -sides[2] / 2);
}

BuiltComponent solid(Balls balls, std::optional<size_t> around = std::nullopt) {
  return {std::move(balls), 0, 0, around};
}

BuiltComponent hollow(Balls balls, std::optional<size_t> around = std::nullopt) {
  return {std::move(balls), 0, 1, around};
}

void add_hollow_sets(std::vector<BuiltSet> &sets) {
  const Balls first = balls_on_sphere(3, 1, 2);        // 1 to 5 steps from the origin
  const Balls second = balls_on_sphere(3, 8, 16);      // 8 to 40
  const Balls third = balls_on_sphere(7, 40, 200);     // 80 to 480
  const Balls fourth = balls_on_sphere(9, 200, 1000);  // 800 to 2800
  sets.push_back(
      {"four shells, one in another", {hollow(fourth), hollow(third, 0), hollow(second, 1), hollow(first, 2)}});
  sets.push_back({"four shells, one in another, and a point in the middle",
                  {hollow(first, 1), hollow(second, 2), hollow(third, 3), hollow(fourth), solid({{0, 0, 0, 0}}, 0)}});
  sets.push_back({"a ball in a void that touches nothing", {hollow(second), solid({{1, -2, 3, 2}}, 0)}});
  sets.push_back(
      {"a void in a ball in a void, and a ball beside it",
       {hollow(third), hollow(moved(first, -31, 0, 2), 0), solid({{40, 3, 1, 12}}, 0), solid({{0, 0, 900, 9}})}});
  // Two shells side by side in the void of a third, each with something in it.
  sets.push_back({"two shells side by side in a void",
                  {hollow(fourth), hollow(moved(second, -50, 0, 0), 0), hollow(moved(second, 50, 0, 0), 0),
                   solid({{-50, 0, 0, 3}}, 1), solid({{48, 2, 0, 2}}, 2), solid({{52, -2, 0, 2}}, 2),
                   solid({{0, 0, 200, 50}}, 0)}});
  // Above each other: a vertical ray from the lower one passes both walls of the upper one.
  sets.push_back({"two shells above each other outside, one with a ball",
                  {hollow(moved(second, 0, 0, -50)), hollow(moved(second, 3, 1, 50)), solid({{0, 0, -50, 7}}, 0),
                   solid({{0, 0, 200, 5}})}});
  // One component with two voids.
  sets.push_back({"two shells that touch in one point",
                  {{joined(moved(second, -40, 0, 0), moved(second, 40, 0, 0)), 0, 2, std::nullopt},
                   solid({{-40, 0, 0, 7}}, 0),
                   solid({{40, 0, 0, 0}}, 0)}});
  // Half diagonals 5 of 6 x 8: two walls are closed by the single point that four spheres share.
  sets.push_back({"a point in a box with two windows closed by a point each",
                  {hollow(box_of_8({6, 8, 6}, 5)), solid({{0, 0, 0, 0}}, 0)}});
  sets.push_back(
      {"the same, upright", {hollow(box_of_8({6, 6, 8}, 5)), solid({{0, 0, 0, 0}}, 0), solid({{0, 0, 11, 1}})}});
}

void add_rings_and_cages(std::vector<BuiltSet> &sets) {
  for (const std::array<size_t, 2> &plane : {std::array<size_t, 2>{0, 1}, {1, 2}, {0, 2}}) {
    sets.push_back({"ring across axis " + std::to_string(3 - plane[0] - plane[1]),
                    {{balls_on_circle(25, 1, 7, plane[0], plane[1]), 1, 0, std::nullopt}}});
  }
  // Each goes through the other's hole.
  sets.push_back({"two linked rings",
                  {{balls_on_circle(25, 1, 5, 0, 1), 1, 0, std::nullopt},
                   {moved(balls_on_circle(25, 1, 5, 0, 2), 25, 0, 0), 1, 0, std::nullopt}}});
  sets.push_back({"two linked rings in a void",
                  {hollow(balls_on_sphere(9, 20, 100)),
                   {balls_on_circle(25, 1, 5, 1, 2), 1, 0, 0},
                   {moved(balls_on_circle(25, 1, 5, 0, 1), 0, 25, 0), 1, 0, 0}}});
  sets.push_back(
      {"a ring in a void", {hollow(balls_on_sphere(7, 20, 100)), {balls_on_circle(25, 1, 5, 0, 2), 1, 0, 0}}});
  // Six of the 54 points at distance 7 are on the axes. The rest has windows there: a ball with n holes in its shell is
  // a solid of genus n - 1.
  const Balls shell = balls_on_sphere(7, 10, 36);
  const Integer far = 70;
  const std::vector<LatticePoint> poles = {{far, 0, 0},  {0, far, 0},  {0, 0, far},
                                           {-far, 0, 0}, {0, -far, 0}, {0, 0, -far}};
  for (const size_t openings : {1U, 2U, 3U, 6U}) {
    const std::vector<LatticePoint> left_out(poles.begin(), poles.begin() + static_cast<ptrdiff_t>(openings));
    const auto genus = static_cast<uint32_t>(openings - 1);
    sets.push_back({"cage, openings: " + std::to_string(openings),
                    {{without(shell, left_out), genus, 0, std::nullopt}, solid({{0, 0, 0, 10}})}});
  }
}

}  // namespace

Balls BuiltSet::balls() const {
  Balls all;
  for (const BuiltComponent &component : components) all = joined(std::move(all), component.balls);
  return all;
}

std::vector<BuiltSet> built_sets() {
  std::vector<BuiltSet> sets;
  add_hollow_sets(sets);
  add_rings_and_cages(sets);
  return sets;
}

std::vector<oracle::NamedBalls> awkward_sets() {
  std::vector<oracle::NamedBalls> sets;
  const auto add = [&](const char *name, Balls balls) { sets.push_back({name, std::move(balls)}); };
  const LatticeBall core = {0, 0, 0, 100};
  add("upright pair", {{0, 0, 0, 5}, {0, 0, 6, 5}});
  add("upright pair that touches", {{0, 0, 0, 5}, {0, 0, 10, 5}});
  add("upright chain", {{0, 0, 0, 5}, {0, 0, 6, 5}, {0, 0, 12, 5}, {0, 0, 19, 4}, {0, 0, -6, 3}});
  add("level pair along x", {{0, 0, 0, 5}, {6, 0, 0, 5}});
  add("level pair along y", {{0, 0, 0, 5}, {0, 6, 0, 5}});
  add("level chain along x", {{0, 0, 0, 5}, {6, 0, 0, 5}, {12, 0, 0, 5}, {19, 0, 0, 4}});
  add("level chain along y", {{0, 0, 0, 5}, {0, 6, 0, 5}, {0, 12, 0, 5}, {0, 19, 0, 4}});
  add("slanted chain in an upright plane", {{0, 0, 0, 7}, {6, 0, 8, 7}, {12, 0, 16, 7}, {18, 0, 24, 7}});
  add("bumps at both poles", {core, {0, 0, 100, 10}, {0, 0, -100, 10}});
  add("bumps around the equator", joined({core}, balls_on_circle(100, 1, 6, 0, 1)));
  add("bumps around a meridian across y", joined({core}, balls_on_circle(100, 1, 6, 0, 2)));
  add("bumps around a meridian across x", joined({core}, balls_on_circle(100, 1, 6, 1, 2)));
  add("bumps at the ends of the axes", joined({core}, balls_on_sphere(1, 100, 12)));
  add("30 bumps", joined({{0, 0, 0, 90}}, balls_on_sphere(3, 30, 10)));
  add("54 bumps", joined({{0, 0, 0, 700}}, balls_on_sphere(7, 100, 30)));
  add("54 bumps, of which some touch", joined({{0, 0, 0, 70}}, balls_on_sphere(7, 10, 7)));
  add("bumps straight above and below each other",
      {core, {60, 0, 80, 9}, {60, 0, -80, 9}, {-60, 0, 80, 9}, {-60, 0, -80, 9}, {0, 60, 80, 9}, {0, 60, -80, 9}});
  add("a belt and bumps on both sides of it",
      joined(joined({core}, balls_on_circle(100, 1, 32, 0, 1)),
             {{60, 0, 80, 9}, {-60, 0, 80, 9}, {0, 0, 100, 9}, {60, 0, -80, 9}, {0, 60, -80, 9}}));
  add("an upright belt and bumps on both sides of it",
      joined(joined({core}, balls_on_circle(100, 1, 32, 0, 2)),
             {{60, 80, 0, 9}, {-60, 80, 0, 9}, {0, 100, 0, 9}, {0, -80, 60, 9}, {0, -80, -60, 9}}));
  // Two large balls with holes in their faces and one circle between them: cut arcs from both sides come to it in one
  // upright plane.
  const Balls bumps = {{-60, 0, 80, 9}, {-60, 0, -80, 9}, {-100, 0, 0, 9}};
  Balls pair = {core, {120, 0, 0, 100}};
  for (const LatticeBall &b : bumps) pair = joined(pair, {b, {120 - b.x, b.y, b.z, b.radius}});
  add("a level pair with bumps in its upright plane", pair);
  add("the same along y", along_axes(pair, {1, 0, 2}));
  add("the same upright, in the plane across y", along_axes(pair, {2, 1, 0}));
  add("the same upright, in the plane across x", along_axes(pair, {1, 2, 0}));
  // Along (3, 4, 0), where the plane has no round numbers and is given by other multiples of its normal on either side;
  // then with the circle cut short.
  const Balls slanted = {core,
                         {72, 96, 0, 100},
                         {-36, -48, 80, 9},
                         {-36, -48, -80, 9},
                         {72 + 48, 96 + 64, 60, 9},
                         {72 + 48, 96 + 64, -60, 9}};
  add("a level pair along (3, 4, 0) with bumps in its upright plane", slanted);
  add("the same with a ball across the circle", joined(slanted, {{-36, 102, 0, 45}}));
  add("a level pair with bumps at the poles",
      {core, {120, 0, 0, 100}, {0, 0, 100, 9}, {0, 0, -100, 9}, {120, 0, 100, 9}, {120, 0, -100, 9}});
  add("a slanted pair with bumps at the poles",
      {core, {72, 0, 96, 100}, {0, 0, -100, 9}, {72, 0, 196, 9}, {-100, 0, 0, 9}, {0, 100, 0, 9}});
  add("bumps that cover the poles off their middle",
      {core, {28, 0, 96, 40}, {-28, 0, -96, 40}, {100, 0, 0, 10}, {0, 100, 0, 10}, {-60, -80, 0, 10}});
  add("circles that pass through the poles",  // the balls' surfaces contain (0, 0, 100) and (0, 0, -100)
      {core, {40, 0, 100, 40}, {0, -30, -100, 30}, {-100, 0, 0, 10}, {0, 100, 0, 10}});
  add("circles that touch at the poles",
      {core, {40, 0, 100, 40}, {-40, 0, 100, 40}, {0, 100, 0, 10}, {0, -100, 0, 10}});
  add("points of radius 0 on a sphere, at the poles too", joined({{0, 0, 0, 3}}, balls_on_sphere(3, 1, 0)));
  add("balls that touch a sphere from inside at the poles", {core, {0, 0, 50, 50}, {0, 0, -60, 40}, {100, 0, 0, 10}});
  add("every bump twice", joined(joined({core}, balls_on_circle(100, 1, 6, 0, 2)), balls_on_circle(100, 1, 6, 0, 2)));
  return sets;
}

namespace {

// A closed wall around the origin, and how far it leaves the origin free.
struct Wall {
  Balls balls;
  Integer room;
};

Wall random_wall(RandomSource &random, Integer reach, size_t most) {
  switch (random.in(0, most < 30 ? 2 : 3)) {
    case 0: {  // triangles of an octahedron close at 0.8165 of the distance
      const Integer distance = reach * 100 / 190;
      const Integer radius = distance * random.in(83, 90) / 100;
      return {balls_on_sphere(1, distance, radius), distance - radius};
    }
    case 1: {  // two windows close exactly
      const Integer unit = reach / 22;
      std::array<Integer, 3> sides = {12 * unit, 16 * unit, 12 * unit};
      std::swap(sides[1], sides[static_cast<size_t>(random.in(0, 2))]);
      return {box_of_8(sides, 10 * unit), unit};  // half diagonal 11.66 units
    }
    case 2: {
      const Integer spacing = reach * 10 / 26;
      const Integer radius = spacing * random.in(71, 80) / 100 + 1;
      return {cage_of_26(spacing, radius), spacing - radius};
    }
    default: {
      const Integer unit = reach / 5;
      return {balls_on_sphere(3, unit, 2 * unit), unit};
    }
  }
}

// Fills the ball of a free radius around a place.
void fill(RandomSource &random, const LatticeBall &place, size_t most, Balls &balls) {
  if (balls.size() >= most) return;
  const Integer reach = place.radius;
  if (reach >= 24 && (balls.empty() || !random.one_in(5))) {
    const Wall wall = random_wall(random, reach - 1, most - balls.size());
    balls = joined(std::move(balls), moved(wall.balls, place.x, place.y, place.z));
    fill(random, {place.x, place.y, place.z, wall.room}, most, balls);
    return;
  }
  const Integer third = reach / 3;
  switch (random.in(0, 4)) {
    case 0:
      return;
    case 1:  // two side by side, maybe touching
      fill(random, {place.x - third - 1, place.y, place.z, third}, most, balls);
      fill(random, {place.x + third + 1, place.y, place.z, third}, most, balls);
      balls.push_back({place.x, place.y + 2 * third, place.z, random.in(0, third)});
      return;
    case 2:  // as large as the room: touches the wall where that comes nearest
      balls.push_back({place.x, place.y, place.z, reach});
      return;
    default:
      balls.push_back({place.x, place.y, place.z, random.in(0, std::max<Integer>(0, reach - 1))});
      return;
  }
}

// Balls inside others, most of them touching these from inside where a vertical ray or a level one comes in.
void add_contained(RandomSource &random, Balls &balls) {
  const size_t given = balls.size();
  for (size_t i = 0; i < given; ++i) {
    if (!random.one_in(3)) continue;
    LatticeBall inner = balls[i];
    inner.radius = random.in(0, inner.radius);
    const Integer away = balls[i].radius - inner.radius;
    switch (random.in(0, 6)) {
      case 0:
        inner.z -= away;
        break;
      case 1:
        inner.z += away;
        break;
      case 2:
        inner.x += away;
        break;
      case 3:
        inner.y -= away;
        break;
      case 4:
        inner.z += away / 2;
        break;
      case 5:
        inner.z -= away / 2;
        break;
      default:
        inner = balls[i];
    }
    balls.push_back(inner);
  }
}

}  // namespace

Balls nested_balls(RandomSource &random) {
  Balls balls;
  const Integer reach = random.in(150, 400);
  fill(random, {0, 0, 0, reach}, 70, balls);
  if (random.one_in(2)) {
    // Something outside, perhaps above the rest, perhaps touching it.
    const LatticeBall beside = {random.in(-reach, reach), random.in(-reach, reach),
                                (random.one_in(2) ? 1 : -1) * (reach + random.in(0, 40)), random.in(1, 40)};
    balls.push_back(beside);
  }
  std::array<size_t, 3> axes = {0, 1, 2};
  for (size_t k = 2; k > 0; --k) std::swap(axes[k], axes[static_cast<size_t>(random.in(0, static_cast<Integer>(k)))]);
  balls = along_axes(balls, axes, random.one_in(2) ? 4 : 0);
  if (random.one_in(2)) add_contained(random, balls);
  return oracle::permuted(balls, random.permutation(balls.size()));
}
