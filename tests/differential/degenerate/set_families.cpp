#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "box_lattice.hpp"
#include "degenerate_set.hpp"
#include "named_balls.hpp"
#include "point_lattices.hpp"

namespace degenerate {
namespace {

using Integer = int64_t;
using oracle::Balls;
using oracle::balls_on_circle;
using oracle::balls_on_sphere;
using oracle::chosen_points;
using oracle::is_diamond;
using oracle::is_face_centred;
using oracle::joined;
using oracle::LatticeBall;

Topology topology(Integer components, Integer voids, Integer euler) {
  return {components, voids, components + voids, euler};
}

class Collection {
 public:
  void add(std::string name, Balls balls, Topology expected) {
    sets_.push_back({std::move(name), std::move(balls), expected, "construction"});
  }
  void add_unknown(std::string name, Balls balls) {
    sets_.push_back({std::move(name), std::move(balls), std::nullopt, ""});
  }
  void add(const BoxLattice &lattice) { add(name_of(lattice), balls_of(lattice), topology_of(lattice)); }
  [[nodiscard]] std::vector<DegenerateSet> take() { return std::move(sets_); }

 private:
  std::vector<DegenerateSet> sets_;
};

void add_named(Collection &collection) {
  for (const oracle::KnownBalls &set : oracle::known_balls()) {
    if (set.euler)
      collection.add("named: " + set.name, set.balls, topology(set.components, set.voids, *set.euler));
    else
      collection.add_unknown("named: " + set.name, set.balls);
  }
}

void add_box_lattices(Collection &collection) {
  // Half an edge 6; half diagonals of squares 8.49 and of cubes 10.39.
  for (const Integer radius : {5, 6, 7, 8, 9, 10, 11, 12, 13, 18})
    collection.add(BoxLattice{{3, 3, 3}, {12, 12, 12}, radius});
  // Half sides and half diagonals 1, 2, 3 of 2 x 4 x 4; 3 and 4 and their rectangle's 5, the box's 13 of 6 x 8 x 24.
  for (const Integer radius : {1, 2, 3, 4}) collection.add(BoxLattice{{3, 3, 3}, {2, 4, 4}, radius});
  for (const Integer radius : {2, 3, 4, 5, 6, 12, 13, 14}) collection.add(BoxLattice{{2, 3, 2}, {6, 8, 24}, radius});
  for (const Integer radius : {2, 3, 5, 6, 7, 8}) collection.add(BoxLattice{{2, 2, 3}, {4, 6, 12}, radius});
  for (const Integer radius : {6, 7, 14, 20, 21, 42, 48, 49, 50})
    collection.add(BoxLattice{{2, 2, 3}, {4, 6, 12}, radius, true});
  // In a plane and on a line.
  for (const Integer radius : {2, 3, 4, 5, 6}) collection.add(BoxLattice{{4, 5, 1}, {6, 8, 1}, radius});
  for (const Integer radius : {13, 14, 20, 21, 28, 35, 36})
    collection.add(BoxLattice{{1, 4, 4}, {1, 6, 8}, radius, true});
  for (const Integer radius : {2, 3, 4, 6, 7}) collection.add(BoxLattice{{1, 12, 1}, {1, 6, 1}, radius});
  // Of genus 1 to 5: ladders of touching and of crossing balls.
  for (const Integer rungs : {2, 3, 4, 5, 6}) {
    collection.add(BoxLattice{{rungs, 2, 1}, {10, 10, 1}, 5});
    collection.add(BoxLattice{{rungs, 1, 2}, {10, 1, 10}, 7});
  }
  // The law of cells holds at any size.
  for (const Integer radius : {4, 5, 6, 7, 8, 9, 10, 12}) collection.add(BoxLattice{{5, 5, 5}, {10, 10, 10}, radius});
  for (const Integer radius : {3, 6, 7, 8}) collection.add(BoxLattice{{6, 5, 4}, {4, 6, 12}, radius});
}

void add_other_lattices(Collection &collection) {
  // Nearest balls at 17.0, triangles close at 9.8, tetrahedra at 10.4, octahedra at 12 exactly.
  for (const Integer radius : {8, 9, 10, 11, 12, 13, 17})
    collection.add_unknown("face-centred lattice, radius " + std::to_string(radius),
                           chosen_points(4, 12, radius, is_face_centred));
  // Bonds of 10.4; the holes close at 12 exactly.
  for (const Integer radius : {5, 6, 9, 10, 11, 12, 13})
    collection.add_unknown("diamond, radius " + std::to_string(radius), chosen_points(5, 6, radius, is_diamond));
}

// The centres are those of tests/oracle; edges 71 long, pentagons close at 60.4, hexagons at 71, the cage at 176.
void add_fullerenes(Collection &collection) {
  const std::vector<oracle::KnownBalls> named = oracle::known_balls();
  const auto found = std::find_if(named.begin(), named.end(), [](const auto &set) { return set.name == "fullerene"; });
  if (found == named.end()) throw std::logic_error("no fullerene among the named balls");
  const std::array<std::pair<Integer, Topology>, 6> radii = {{{30, topology(60, 0, 120)},
                                                              {40, topology(1, 0, 2 * (60 - 90))},
                                                              {65, topology(1, 0, 2 * (60 - 90 + 12))},
                                                              {80, topology(1, 1, 4)},
                                                              {150, topology(1, 1, 4)},
                                                              {180, topology(1, 0, 2)}}};
  for (const auto &[radius, expected] : radii) {
    Balls balls = found->balls;
    for (LatticeBall &ball : balls) ball.radius = radius;
    collection.add("fullerene, radius " + std::to_string(radius), balls, expected);
  }
}

void add_rings(Collection &collection) {
  // Twenty points at 25 from the origin, of which twelve neighbours are at 7.07 and eight at 8.94.
  collection.add("ring of 20, in eight parts", balls_on_circle(25, 1, 4), topology(8, 0, 16));
  for (const Integer radius : {5, 12, 24})
    collection.add("ring of 20, radius " + std::to_string(radius), balls_on_circle(25, 1, radius), topology(1, 0, 0));
  collection.add("ring of 20 that closes at its centre", balls_on_circle(25, 1, 25), topology(1, 0, 2));
  collection.add("ring of 36, radius 64", balls_on_circle(65, 1, 64), topology(1, 0, 0));
  collection.add("ring of 36 that closes at its centre", balls_on_circle(65, 1, 65), topology(1, 0, 2));
  Balls linked = balls_on_circle(25, 1, 5);
  for (const LatticeBall &ball : balls_on_circle(25, 1, 5)) linked.push_back({ball.x + 25, 0, ball.y, 5});
  collection.add("two rings, linked", linked, topology(2, 0, 0));
  Balls crossing = balls_on_circle(25, 1, 5);
  for (const LatticeBall &ball : balls_on_circle(25, 1, 5)) crossing.push_back({ball.x, 0, ball.y, 5});
  collection.add("two rings through two common balls, each there twice", crossing, topology(1, 0, 2 * (1 - 3)));
}

void add_shells(Collection &collection) {
  collection.add("shell of 30", balls_on_sphere(3, 1, 2), topology(1, 1, 4));
  collection.add("shell of 30 that closes at its centre", balls_on_sphere(3, 1, 3), topology(1, 0, 2));
  collection.add("shell of 30, wider apart", balls_on_sphere(5, 1, 4), topology(1, 1, 4));
  collection.add_unknown("shell of 30 with windows", balls_on_sphere(5, 1, 2));
  collection.add_unknown("shell of 30 with smaller windows", balls_on_sphere(5, 1, 3));
  collection.add("shell of 54", balls_on_sphere(7, 1, 6), topology(1, 1, 4));
  collection.add("shell of 54 that closes at its centre", balls_on_sphere(7, 1, 7), topology(1, 0, 2));
  collection.add("shell of 102", balls_on_sphere(9, 1, 8), topology(1, 1, 4));
  collection.add("shell of 102 that closes at its centre", balls_on_sphere(9, 1, 9), topology(1, 0, 2));
  const Balls small = balls_on_sphere(3, 3, 6);
  collection.add("shell of 30 with a point in its middle", joined(small, {{0, 0, 0, 0}}), topology(2, 1, 6));
  collection.add("shell of 30 with a ball inside", joined(small, {{0, 0, 0, 2}}), topology(2, 1, 6));
  // Thirty contacts between core and shell: 29 tunnels through what is left of the void.
  collection.add("shell of 30 with a ball that touches all from inside", joined(small, {{0, 0, 0, 3}}),
                 topology(1, 1, 2 * (1 - 29 + 1)));
  const Balls large = balls_on_sphere(7, 10, 50);
  collection.add("shell in the void of a shell", joined(large, small), topology(2, 2, 8));
  collection.add("ball in the void of a shell in the void of a shell", joined(joined(large, small), {{0, 0, 0, 2}}),
                 topology(3, 2, 10));
}

void add_belts(Collection &collection) {
  const Balls core = {{0, 0, 0, 100}};
  collection.add("belt of 20 separate balls", joined(core, balls_on_circle(25, 4, 10)), topology(1, 0, 2));
  collection.add("belt of 20 balls", joined(core, balls_on_circle(25, 4, 20)), topology(1, 0, 2));
  collection.add("belt of 20 balls, bumps at both poles and beside them",
                 joined(joined(core, balls_on_circle(25, 4, 20)),
                        {{0, 0, 100, 8}, {36, 48, 80, 8}, {-48, 36, 80, 8}, {0, 0, -100, 8}, {60, 0, -80, 5}}),
                 topology(1, 0, 2));
  collection.add("belt of 20 balls, bumps that touch each other on the sphere",
                 joined(joined(core, balls_on_circle(25, 4, 20)), {{-8, 60, 80, 8}, {8, 60, 80, 8}, {0, 0, -100, 10}}),
                 topology(1, 0, 2));
  collection.add("face with 30 holes", joined({{0, 0, 0, 90}}, balls_on_sphere(3, 30, 10)), topology(1, 0, 2));
  collection.add("face with 30 holes of radius 0", joined({{0, 0, 0, 3}}, balls_on_sphere(3, 1, 0)), topology(1, 0, 2));
  collection.add("face with 54 holes", joined({{0, 0, 0, 700}}, balls_on_sphere(7, 100, 30)), topology(1, 0, 2));
  collection.add("face with 102 holes", joined({{0, 0, 0, 900}}, balls_on_sphere(9, 100, 30)), topology(1, 0, 2));
  // The belt's own hole is filled by a core that touches it all around.
  collection.add("belt that touches its core", joined({{0, 0, 0, 80}}, balls_on_circle(25, 4, 20)),
                 topology(1, 0, 2 * (1 - 20)));
  collection.add("small ball across a large one's belt of radii 1:1000",
                 joined({{0, 0, 0, 1000}}, balls_on_circle(25, 40, 1)), topology(1, 0, 2));
}

}  // namespace

std::vector<DegenerateSet> made_sets() {
  Collection collection;
  add_named(collection);
  add_box_lattices(collection);
  add_other_lattices(collection);
  add_fullerenes(collection);
  add_rings(collection);
  add_shells(collection);
  add_belts(collection);
  return collection.take();
}

}  // namespace degenerate
