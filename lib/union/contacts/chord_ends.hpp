// The terms that the ends of chords add to the areas of contacts. The area of a contact is half the sum, over the parts
// of its border, of the part's length times its distance from the circle's centre. The foot of that distance divides a
// chord's line; the term of an end is for the stretch between the foot and this end, so it does not depend on the
// other.
//
// With y = 2 (x - c), the planes u.y = h_P, v.y = h_Q of two balls and the names of chord_line.hpp, a chord runs along
// (q x n + t n)/N. An end at t adds +- t beta/(8 N |u|) to the contact of P, t alpha/(8 N |v|) to that of Q and
// t (2 N - alpha - beta)/(8 N |v - u|) to the third one. At a free end t is +-sqrt(D). At a power vertex, where also
// z.y = h_R, y = (h_R u x v + h_P v x z + h_Q z x u)/B with B = u.(v x z), and t = n.y; it is the end of larger t iff
// B > 0.
//
// Doubles serve vertices of planes that are not nearly parallel: with B^2 >= least_square U V Z, where U, V and Z are
// the squares of three vectors from one of the balls, and N >= least_square U V. Errors in units of e = 2^-53: u, v and
// z are exact. |u x v| has an error of 3 |u||v|; h_P, which is at most 2 r |u|, one of 8 r |u|; alpha and beta of
// 40 r |u||v|^2 and 40 r |u|^2 |v|. Divided by |n| = s |u||v|, the distance of the chord's line is off by 50 r/s. y is
// off by 3 (8 + 8) r/k + 10 r/k, where k = |B|/(|u||v||z|) <= s. So each term is off by less than 128 e r^2/k, and
// typically by a few e r^2. A term that may be off by 2^-41 r^2 is computed from exact numbers, each rounded once.
#pragma once

#include "measure/arc_sums.hpp"
#include "model/ball_set.hpp"
#include "sphere/near_balls.hpp"

namespace hsp {

// Power vertices, each of balls 0, 1, 2 and 3. Its chords are those of balls 012, 023, 031 and 123; its contacts those
// of balls 01, 02, 03, 12, 31 and 23.
struct PowerVertexBatch {
  static constexpr uint32_t capacity = 8;  // a multiple of the lanes of every target

  uint32_t count = 0;
  uint32_t ball[4][capacity];
  double kept[4][capacity];       // 0 for a chord that is kept elsewhere, else 1
  uint32_t contact[6][capacity];  // ids, for the caller alone
  uint32_t ends[6][capacity];     // how many ends of chords a contact has at the vertex

  // For each contact, the terms of the kept ends here in half the sum of distance times length, multiplied by the
  // distance of the two balls.
  double part[6][capacity];

  // Makes vertex `to` the same as another one, but for its contacts.
  void repeat(uint32_t from, uint32_t to) {
    for (auto &of_vertex : ball) of_vertex[to] = of_vertex[from];
    for (auto &of_vertex : kept) of_vertex[to] = of_vertex[from];
  }
};

// Finds the parts of the first `count` power vertices. Behind them, vertices up to the end of a register are read and
// written, too. Returns a bit for each vertex that doubles do not serve.
HSP_KERNEL(uint32_t, measure_power_vertices, (const BallArrays &balls, PowerVertexBatch &batch, uint32_t count),
           (balls, batch, count))
// Finds the parts of vertex s of a batch from integers.
void measure_in_integers(const BallSet &balls, PowerVertexBatch &batch, uint32_t s);

// Finds, for each slot of a batch, the terms of both ends of its arc for the contact with the ball that cuts out its
// circle; 0 if there is no arc. The batch has been evaluated, with its products. radius: of the batch's ball. cosines:
// becomes AreaSums::cosines of the batch. False if doubles do not serve for some arc: its part is not a number.
HSP_KERNEL(bool, measure_free_ends,
           (const ArcBatch &batch, double radius, double (&parts)[ArcBatch::room], double &cosines),
           (batch, radius, parts, cosines))
// The same for the arc of slot s, of a batch on ball `own`, from integers.
double free_ends_in_integers(const BallSet &balls, uint32_t own, const ArcBatch &batch, uint32_t s);

}  // namespace hsp
