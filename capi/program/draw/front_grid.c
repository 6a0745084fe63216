#include "draw/front_grid.h"

#include <math.h>
#include <stdlib.h>

static const double most_cells = 1048576.0;

double shown_bodies_radius(const struct shown_bodies *bodies, uint32_t atom) {
  return bodies->share * bodies->molecule->radius[atom] + bodies->probe;
}

void page_axes_place(const struct page_axes *axes, const double *xyz, double at[3]) {
  for (int k = 0; k < 3; ++k) {
    const double *const row = axes->row[k];
    at[k] = axes->origin[k] + row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2];
  }
}

bool front_grid_make(struct front_grid *grid, const double low[2], const double high[2], double cell) {
  const double wide = high[0] - low[0], high_side = high[1] - low[1];
  const double least = sqrt(wide / most_cells * high_side);
  *grid = (struct front_grid){.corner = {low[0], low[1]}, .cell = cell > least ? cell : least};
  /* A grid that is one cell wide has the other side's cells as numbers of 31 bits: sides differ by less than 10^9. */
  const double sides[2] = {ceil(wide / grid->cell), ceil(high_side / grid->cell)};
  if (!(sides[0] >= 1.0 && sides[1] >= 1.0 && sides[0] * sides[1] <= 4.0 * most_cells)) return true;
  grid->columns = (int32_t)sides[0];
  grid->rows = (int32_t)sides[1];
  const size_t cells = (size_t)grid->columns * (size_t)grid->rows;
  grid->height = calloc(cells, sizeof *grid->height);
  grid->owner = calloc(cells, sizeof *grid->owner);
  return grid->height != NULL && grid->owner != NULL;
}

void front_grid_free(struct front_grid *grid) {
  free(grid->height);
  free(grid->owner);
}

/* The cells whose middles are in the box, as far as the grid goes. False: none. */
struct cells {
  int32_t low[2], high[2];
};
static bool find_cells(const struct front_grid *grid, const double low[2], const double high[2], struct cells *cells) {
  const int32_t count[2] = {grid->columns, grid->rows};
  for (int k = 0; k < 2; ++k) {
    const double first = ceil((low[k] - grid->corner[k]) / grid->cell - 0.5);
    const double last = floor((high[k] - grid->corner[k]) / grid->cell - 0.5);
    if (!(first < count[k] && last >= 0.0 && first <= last)) return false;
    cells->low[k] = first < 0.0 ? 0 : (int32_t)first;
    cells->high[k] = last < count[k] ? (int32_t)last : count[k] - 1;
  }
  return true;
}

static void middle_of(const struct front_grid *grid, int32_t column, int32_t row, double at[2]) {
  at[0] = grid->corner[0] + (column + 0.5) * grid->cell;
  at[1] = grid->corner[1] + (row + 0.5) * grid->cell;
}

static void put(struct front_grid *grid, int32_t column, int32_t row, double height, uint32_t owner) {
  const size_t cell = (size_t)row * (size_t)grid->columns + (size_t)column;
  if (grid->owner[cell] != FRONT_GRID_NOTHING && grid->height[cell] >= height) return;
  grid->height[cell] = height;
  grid->owner[cell] = owner;
}

static void add_ball(struct front_grid *grid, const double centre[3], double radius, uint32_t owner) {
  struct cells cells;
  const double low[2] = {centre[0] - radius, centre[1] - radius}, high[2] = {centre[0] + radius, centre[1] + radius};
  if (!find_cells(grid, low, high, &cells)) return;
  for (int32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
    for (int32_t column = cells.low[0]; column <= cells.high[0]; ++column) {
      double at[2];
      middle_of(grid, column, row, at);
      const double x = at[0] - centre[0], y = at[1] - centre[1], left = radius * radius - x * x - y * y;
      if (left > 0.0) put(grid, column, row, centre[2] + sqrt(left), owner);
    }
  }
}

/* A band of the stick's width, with its axis as height: ends are in balls. */
static void add_stick(struct front_grid *grid, const double from[3], const double to[3], double radius,
                      const uint32_t owner[2]) {
  struct cells cells;
  double low[2], high[2];
  const double d[2] = {to[0] - from[0], to[1] - from[1]}, square = d[0] * d[0] + d[1] * d[1];
  for (int k = 0; k < 2; ++k) {
    low[k] = (from[k] < to[k] ? from[k] : to[k]) - radius;
    high[k] = (from[k] < to[k] ? to[k] : from[k]) + radius;
  }
  if (!(square > 0.0) || !find_cells(grid, low, high, &cells)) return;
  for (int32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
    for (int32_t column = cells.low[0]; column <= cells.high[0]; ++column) {
      double at[2];
      middle_of(grid, column, row, at);
      const double x = at[0] - from[0], y = at[1] - from[1], along = (x * d[0] + y * d[1]) / square;
      const double across = d[0] * y - d[1] * x;
      if (along < 0.0 || along > 1.0 || across * across > radius * radius * square) continue;
      put(grid, column, row, from[2] + along * (to[2] - from[2]) + radius,
          owner[along < 0.5 ? 0 : 1] | FRONT_GRID_STICK);
    }
  }
}

void front_grid_show(struct front_grid *grid, const struct shown_bodies *bodies, const struct page_axes *axes,
                     double scale) {
  const size_t cells = (size_t)grid->columns * (size_t)grid->rows;
  const double *const xyz = bodies->molecule->xyz;
  for (size_t i = 0; i < cells; ++i) grid->owner[i] = FRONT_GRID_NOTHING;
  for (uint32_t atom = 0; atom < bodies->molecule->atoms; ++atom) {
    double at[3];
    const double radius = shown_bodies_radius(bodies, atom);
    if (bodies->painted != NULL && !bodies->painted[atom]) continue;
    page_axes_place(axes, xyz + 3 * (size_t)atom, at);
    if (radius > 0.0) add_ball(grid, at, scale * radius, atom);
  }
  for (uint32_t i = 0; i < bodies->bonds; ++i) {
    double ends[2][3];
    const struct bond *const bond = &bodies->bond[i];
    for (int end = 0; end < 2; ++end) page_axes_place(axes, xyz + 3 * (size_t)bond->atom[end], ends[end]);
    add_stick(grid, ends[0], ends[1], scale * bodies->stick, bond->atom);
  }
}

uint32_t front_grid_body(const struct front_grid *grid, double x, double y) {
  const double column = floor((x - grid->corner[0]) / grid->cell), row = floor((y - grid->corner[1]) / grid->cell);
  if (!(column >= 0.0 && column < grid->columns && row >= 0.0 && row < grid->rows)) return FRONT_GRID_NOTHING;
  return grid->owner[(size_t)row * (size_t)grid->columns + (size_t)column];
}

uint32_t front_grid_owner(const struct front_grid *grid, double x, double y) {
  const uint32_t owner = front_grid_body(grid, x, y);
  return owner == FRONT_GRID_NOTHING ? owner : owner & ~FRONT_GRID_STICK;
}

bool front_grid_is_all(const struct front_grid *grid, const double box[4], uint32_t ball) {
  bool all = true;
  for (double y = box[1]; all && y < box[3] + grid->cell; y += grid->cell) {
    for (double x = box[0]; all && x < box[2] + grid->cell; x += grid->cell) {
      all = front_grid_body(grid, fmin(x, box[2]), fmin(y, box[3])) == ball;
    }
  }
  return all;
}
