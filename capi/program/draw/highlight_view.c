#include "draw/highlight_view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/view_axes.h"
#include "read/geometry.h"
#include "read/vectors.h"

enum { LARGEST = 3 };
static const double cells_across = 200.0;

static bool is_primitive(int x, int y, int z) {
  int a = abs(x), b = abs(y), c = abs(z);
  for (int k = 0; k < 2; ++k) {
    while (b != 0) {
      const int rest = a % b;
      a = b;
      b = rest;
    }
    b = c;
    c = 0;
  }
  return a == 1;
}

/* How much is seen; cells: [atoms], zeros, and left so. False for want of memory. */
static bool rate(const struct shown_bodies *bodies, const struct selection *selected, double axis[3][3],
                 uint32_t *cells, double *rating) {
  struct page_axes axes = {.origin = {0.0, 0.0, 0.0}};
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  memcpy(axes.row, axis, sizeof axes.row);
  for (uint32_t atom = 0; atom < bodies->molecule->atoms; ++atom) {
    double at[3];
    if (!selection_takes(selected, bodies->molecule, atom)) continue;
    const double radius = shown_bodies_radius(bodies, atom);
    page_axes_place(&axes, bodies->molecule->xyz + 3 * (size_t)atom, at);
    for (int k = 0; k < 2; ++k) {
      low[k] = fmin(low[k], at[k] - radius);
      high[k] = fmax(high[k], at[k] + radius);
    }
  }
  struct front_grid grid;
  const bool enough = front_grid_make(&grid, low, high, fmax(high[0] - low[0], high[1] - low[1]) / cells_across);
  *rating = 0.0;
  if (enough) front_grid_show(&grid, bodies, &axes, 1.0);
  const size_t count = enough ? (size_t)grid.columns * (size_t)grid.rows : 0;
  for (size_t i = 0; i < count; ++i) {
    if (grid.owner[i] != FRONT_GRID_NOTHING) ++cells[grid.owner[i] & ~FRONT_GRID_STICK];
  }
  for (uint32_t atom = 0; atom < bodies->molecule->atoms; ++atom) {
    if (selection_takes(selected, bodies->molecule, atom)) *rating += sqrt(cells[atom] * grid.cell * grid.cell);
    cells[atom] = 0;
  }
  front_grid_free(&grid);
  return enough;
}

/* Find the direction upwards for which the longest visible axis is across. */
static void find_up(const struct molecule *molecule, double axis[3][3], double up[3]) {
  double mean[2] = {0.0, 0.0}, square[2] = {0.0, 0.0}, product = 0.0;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t atom = 0; atom < molecule->atoms; ++atom) {
      const double *const xyz = molecule->xyz + 3 * (size_t)atom;
      double at[2];
      for (int k = 0; k < 2; ++k) {
        at[k] = dot(axis[k], xyz) - mean[k];
        square[k] += pass == 0 ? at[k] / molecule->atoms : at[k] * at[k];
      }
      product += pass == 0 ? 0.0 : at[0] * at[1];
    }
    if (pass == 1) break;
    memcpy(mean, square, sizeof mean);
    square[0] = square[1] = 0.0;
  }
  const double half = (square[0] - square[1]) / 2.0;
  const double across[2] = {half + sqrt(half * half + product * product), product};
  for (int k = 0; k < 3; ++k) up[k] = across[0] * axis[1][k] - across[1] * axis[0][k];
  if (!(across[0] > 0.0)) memcpy(up, axis[square[1] > square[0] ? 0 : 1], 3 * sizeof *up);
}

bool highlight_view_find(const struct shown_bodies *bodies, const struct selection *selected, struct viewing *viewing,
                         struct failure *failure) {
  const struct molecule *const molecule = bodies->molecule;
  struct viewing tried = {.up = viewing->up};
  double principal[3][3], axis[3][3], best[3][3], most = -1.0;
  uint32_t *cells = calloc((size_t)molecule->atoms + 1, sizeof *cells);
  int32_t status = viewing_axes(&tried, molecule, principal);
  bool enough = cells != NULL;
  for (int z = LARGEST; status == HSP_OK && enough && z >= -LARGEST; --z) {
    for (int y = -LARGEST; status == HSP_OK && enough && y <= LARGEST; ++y) {
      for (int x = -LARGEST; status == HSP_OK && enough && x <= LARGEST; ++x) {
        double rating = 0.0;
        if (!is_primitive(x, y, z)) continue;
        tried.view.given = tried.up.given = true;
        for (int k = 0; k < 3; ++k) {
          tried.view.xyz[k] = x * principal[0][k] + y * principal[1][k] + z * principal[2][k];
          if (!viewing->up.given) tried.up.xyz[k] = principal[1][k];
        }
        status = viewing_axes(&tried, molecule, axis);
        enough = status != HSP_OK || rate(bodies, selected, axis, cells, &rating);
        if (!(rating > most)) continue;
        most = rating;
        viewing->view = tried.view;
        memcpy(best, axis, sizeof best);
      }
    }
  }
  free(cells);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (!enough) return failure_of_memory(failure);
  if (!viewing->up.given) find_up(molecule, best, viewing->up.xyz);
  viewing->up.given = true;
  return true;
}
