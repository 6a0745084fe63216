// The terms of the ends of chords in the areas of contacts. The area of a contact is half the sum over its borders of
// distance from the circle's centre times length; from the foot of that distance a chord runs to both of its ends, so
// each end adds its own half of it, whatever the other one is.
//
// With y = 2 (x - c), the planes u.y = h_P, v.y = h_Q of two balls and the names of chord_line.hpp a chord runs along
// (q x n + t n)/N, and an end at t adds +- t beta/(8 N |u|) to the contact of P, t alpha/(8 N |v|) to that of Q and
// t (2 N - alpha - beta)/(8 N |v - u|) to the third one. At a free end t is +-sqrt(D). At a power vertex, where
// z.y = h_R, too, y = (h_R u x v + h_P v x z + h_Q z x u)/B with B = u.(v x z), and t = n.y; it is the end of larger t
// iff B > 0.
//
// Doubles serve vertices of planes that are not nearly parallel: with B^2 >= least_square U V Z, where U, V and Z are
// the squares of three vectors from one of the balls, and N >= least_square U V. In units of e = 2^-53, u, v and z are
// exact. |u x v| has an error of 3 |u||v|, h_P, which is at most 2 r |u|, one of 8 r |u|, alpha and beta of
// 40 r |u||v|^2 and 40 r |u|^2 |v|; divided by |n| = s |u||v|, the distance of the chord's line is off by 50 r/s. y is
// off by 3 (8 + 8) r/k + 10 r/k, where k = |B|/(|u||v||z|) <= s. So each term is off by less than 128 e r^2/k, and
// typically by a few e r^2; exact numbers, each rounded once, take the place of what may be off by 2^-41 r^2.
#pragma once

#include "measure/arc_sums.hpp"
#include "model/ball_set.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

// Power vertices. Their chords are those of the balls 012, 023, 031 and 123; their contacts 01, 02, 03, 12, 31 and 23.
struct PowerVertexBatch {
  static constexpr uint32_t capacity = 8;  // a multiple of the lanes of every target

  uint32_t count = 0;
  uint32_t ball[4][capacity];
  double kept[4][capacity];       // 0 for a chord that is kept elsewhere, else 1
  uint32_t contact[6][capacity];  // the caller's
  uint32_t ends[6][capacity];     // of chords, that a contact has here

  // Terms of the kept ends in half the sum of distance times length, times the distance of the two balls.
  double part[6][capacity];

  // Makes vertex `to` the same as another one, but for its contacts.
  void repeat(uint32_t from, uint32_t to) {
    for (auto &of_vertex : ball) of_vertex[to] = of_vertex[from];
    for (auto &of_vertex : kept) of_vertex[to] = of_vertex[from];
  }
};

// The parts of the first `count` power vertices; behind them there may be read and written as many as a register has
// lanes. A bit for each that doubles do not serve.
HSP_KERNEL(uint32_t, measure_power_vertices, (const BallArrays &balls, PowerVertexBatch &batch, uint32_t count),
           (balls, batch, count))
// Vertex s of a batch.
void measure_in_integers(const BallSet &balls, PowerVertexBatch &batch, uint32_t s);

// The same of both ends of each arc of a batch that has been evaluated with its products, for the contact with the ball
// that cuts out its circle; 0 where there is no arc. The radius is that of the batch's ball. False if doubles do not
// serve for one: that is not a number. And the sum that AreaSums has, too.
HSP_KERNEL(bool, measure_free_ends,
           (const ArcBatch &batch, double radius, double (&parts)[ArcBatch::room], double &cosines),
           (batch, radius, parts, cosines))
// Arc s of a batch on ball `own`.
double free_ends_in_integers(const BallSet &balls, uint32_t own, const ArcBatch &batch, uint32_t s);

}  // namespace hsp
