// Rows of the areas' Jacobian: an entry for each ball, sorted, and sums of their parts.
#pragma once

#include "measure/gradients.hpp"
#include "small_union.hpp"

namespace cases {

struct RowEntry {
  double centre[3];
  double radius, angle;
  uint32_t ball, flags;
};

// The row of a ball of the input in small_union(); its length, or no_id if it is too long.
template <uint32_t most>
uint32_t gather_row(uint32_t input, RowEntry (&row)[most]) {
  const uint32_t i = small_union().grid().grid_index(input);
  const uint32_t length = hsp::area_row_length(small_union().boundary(), i);
  if (length > most) return hsp::no_id;
  for (RowEntry &entry : row) entry = {{9, 9, 9}, 9, 9, 9, 9};  // whatever was there does not matter
  hsp::gather_area_row(small_union().balls(), small_union().boundary(), i, hsp::TouchingBalls::meet,
                       hsp::Span<RowEntry>(row, length));
  return length;
}

struct Row {
  uint32_t n;
  SmallBall ball[4];
  uint32_t input, length;
  uint32_t others[4], flags[4];
};
constexpr Row rows[] = {
    // Two small balls at opposite ends of the circle of two large ones leave two arcs of it: one entry for both.
    {4,
     {{500, -866, 0, 300}, {0, 0, 0, 1000}, {500, 866, 0, 300}, {1000, 0, 0, 1000}},
     1,
     4,
     {0, 1, 2, 3},
     {0, 0, 0, 0}},
    // Touching balls are flagged, and the ball itself.
    {3,
     {{1000, 0, 0, 500}, {-900, 0, 0, 500}, {0, 0, 0, 500}},
     2,
     3,
     {0, 1, 2},
     {hsp::one_sided_flag, 0, hsp::one_sided_flag}},
    // No face, no row.
    {2, {{0, 0, 0, 1000}, {0, 0, 0, 100}}, 1, 0, {}, {}},
    {2, {{0, 0, 0, 1000}, {0, 0, 0, 100}}, 0, 1, {0}, {0}}};

inline uint32_t rows_have_an_entry_for_each_ball() {
  return first_failing(rows, [](const Row &c) {
    RowEntry row[4];
    if (!small_union().build(c.ball, c.n) || gather_row(c.input, row) != c.length) return false;
    double sum[3] = {0, 0, 0};
    for (uint32_t k = 0; k < c.length; ++k) {
      if (row[k].ball != c.others[k] || row[k].flags != c.flags[k]) return false;
      for (int axis = 0; axis < 3; ++axis) sum[axis] += row[k].centre[axis];
    }
    // A shift of all balls changes nothing.
    return near(sum[0], 0, 1e-9) && near(sum[1], 0, 1e-9) && near(sum[2], 0, 1e-9);
  });
}

inline uint32_t entries_are_sums_of_their_parts() {
  const Row &c = rows[0];
  RowEntry row[4];
  if (!small_union().build(c.ball, c.n) || gather_row(c.input, row) != c.length) return 0;
  // The parts of ball 3, added by hand.
  hsp::AreaDerivative merged;
  uint32_t parts = 0;
  const hsp::AreaDerivative own =
      hsp::visit_area_row(small_union().balls(), small_union().boundary(), small_union().grid().grid_index(c.input),
                          hsp::TouchingBalls::meet, [&](uint32_t j, const hsp::AreaDerivative &part) {
                            if (small_union().balls().caller[j] != 3) return;
                            merged.radius += part.radius;
                            merged.angle += part.angle;
                            ++parts;
                          });
  const bool conditions[] = {parts == 2,         row[3].radius == merged.radius, row[3].angle == merged.angle,
                             row[3].angle > 0.0, row[1].radius == own.radius,    row[1].angle == 0.0};
  return first_false(conditions);
}

// dA/dR of a whole sphere is 8 pi R, with a ball inside it as well.
inline uint32_t rows_of_whole_spheres() {
  constexpr SmallBall balls[] = {{3, 4, 5, 1000}, {3, 4, 5, 100}};
  RowEntry row[1];
  if (!small_union().build(balls, 2) || gather_row(0, row) != 1) return 0;
  return near(row[0].radius, 8 * hsp::pi * 1000, 1e-9) ? all_hold : 1;
}

inline constexpr Check measure_gradients[] = {{"rows_have_an_entry_for_each_ball", rows_have_an_entry_for_each_ball},
                                              {"entries_are_sums_of_their_parts", entries_are_sums_of_their_parts},
                                              {"rows_of_whole_spheres", rows_of_whole_spheres}};

}  // namespace cases
