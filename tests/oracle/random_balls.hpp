// Random sets of balls, the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "lattice_ball.hpp"
#include "random_numbers.hpp"

namespace oracle {

class RandomSource : public support::RandomNumbers<std::mt19937_64> {
 public:
  using RandomNumbers::RandomNumbers;

  std::vector<uint32_t> permutation(size_t n);
};

// A vector whose components and length are integers, as a LatticeBall with the length as radius. It is one of the first
// `kinds` of 0 0 1, 0 3 4, 1 2 2, 2 3 6, 1 4 8, 4 4 7, 2 6 9, 6 6 7, 0 5 12, its components in any order and with any
// signs.
inline constexpr size_t kinds_of_integer_length = 9;
LatticeBall integer_length_vector(RandomSource &random, size_t kinds = kinds_of_integer_length);

// permuted[k] = balls[order[k]].
Balls permuted(const Balls &balls, const std::vector<uint32_t> &order);

// Centres in a cube of this half side about the origin, radii in least .. largest.
LatticeBall ball_in_box(RandomSource &random, int64_t half_side, int64_t least, int64_t largest);
Balls balls_in_box(RandomSource &random, size_t n, int64_t half_side, int64_t least, int64_t largest);

// Sets in general position, or nearly.
Balls loose_balls(RandomSource &random, size_t n);      // like atoms: a few overlaps per ball
Balls dense_balls(RandomSource &random, size_t n);      // nearly all meet
Balls clustered_balls(RandomSource &random, size_t n);  // a few groups of very different size
Balls belted_balls(RandomSource &random, size_t n);     // a large ball with rings and bumps: nested loops
// A ball of radius `large` around a centre, and many small ones with centres on its sphere.
Balls studded_ball(RandomSource &random, size_t studs, const LatticePoint &centre, int64_t large, int64_t least,
                   int64_t largest);
// A ball around the origin, and further balls near the z axis whose radical planes with it nearly go through one point
// of that axis, `height` times the radius from the origin. The normals of the planes deviate from z by up to `width`
// along either other axis.
Balls balls_of_near_planes(RandomSource &random, size_t n, int64_t radius, double height, double width);

// Centres and radii as large as a lattice may have them: about the origin, or near a corner of it.
Balls largest_balls(RandomSource &random, size_t n);

// Sets full of ties.
Balls grid_balls(RandomSource &random, size_t n);            // centres and radii from very few integers
Balls coplanar_balls(RandomSource &random, size_t n);        // grid_balls in one plane
Balls collinear_balls(RandomSource &random, size_t n);       // grid_balls on one line
Balls balls_through_point(RandomSource &random, size_t n);   // all spheres have a common point
Balls balls_through_circle(RandomSource &random, size_t n);  // all spheres have a common circle
Balls balls_around_circle(RandomSource &random,
                          size_t n);  // most have one size and centres on a circle: two common points
Balls balls_around_sphere(RandomSource &random, size_t n);  // of one radius, around points of a sphere
Balls tangent_balls(RandomSource &random, size_t n);        // each touches an earlier one, from inside or outside
Balls lattice_balls(RandomSource &random, size_t n);        // part of a box lattice in which eight spheres meet
Balls repeated_balls(RandomSource &random, size_t n);       // duplicates, concentric and contained balls

// A ball with whole rings of balls around integer points of a sphere: nested loops and ties at once. At least 9 balls.
Balls crowned_balls(RandomSource &random, size_t n);

// Groups of one to four balls in cubes that collide in the library's hash table (lib/balls/model/cube_slots.hpp), whose
// cubes have sides of twice the largest radius or four times that. The groups are apart by multiples of one of these
// steps, for which the linear form that the hash begins with is 0 modulo 2^64. The second step has no z, for squares of
// a view.
inline constexpr std::array<LatticePoint, 2> colliding_steps = {
    {{852863, 1285698, 183727}, {1346530022, 1795967550, 0}}};
Balls colliding_balls(RandomSource &random, size_t n);

// One of the tied kinds above but crowned_balls, or a mixture of two.
Balls degenerate_balls(RandomSource &random, size_t n);

// One of all the kinds.
Balls any_balls(RandomSource &random, size_t n);

}  // namespace oracle
