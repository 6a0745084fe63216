/* The ball in front at each point of a grid. This is enough to find where labels have room and from which direction
 * most is seen. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/molecule.h"
#include "read/stated_bonds.h"

#define FRONT_GRID_NOTHING UINT32_MAX
#define FRONT_GRID_STICK (UINT32_C(1) << 31)

/* The balls and sticks of a picture. */
struct shown_bodies {
  const struct molecule *molecule;
  double share, probe; /* a ball's radius is that of its atom times the share, plus the probe */
  const struct bond *bond;
  uint32_t bonds;      /* 0: there are only balls */
  double stick;        /* the radius of sticks */
  const bool *painted; /* [atoms]; NULL: any ball may be seen */
};

double shown_bodies_radius(const struct shown_bodies *bodies, uint32_t atom);

/* The axes to the right, down and towards the viewer, and the place of the origin. */
struct page_axes {
  double row[3][3];
  double origin[3];
};

void page_axes_place(const struct page_axes *axes, const double *xyz, double at[3]);

struct front_grid {
  double corner[2], cell; /* the upper left corner, and the side of a cell */
  int32_t columns, rows;
  double *height;  /* [rows][columns] how far in front the foremost body is in the middle of a cell */
  uint32_t *owner; /* [rows][columns] its ball; for a stick the ball of that half, with FRONT_GRID_STICK */
};

/* Make a grid over the rectangle from `low` to `high`, with up to 2^20 cells that are at least `cell` wide. Free it on
 * true and on false. False: memory is short. */
bool front_grid_make(struct front_grid *grid, const double low[2], const double high[2], double cell);
void front_grid_free(struct front_grid *grid);

/* Fill the grid with these bodies alone. The axes may contain a scale. */
void front_grid_show(struct front_grid *grid, const struct shown_bodies *bodies, const struct page_axes *axes,
                     double scale);

/* The ball that is in front, itself or by its half of a stick; beyond the grid there is none. */
uint32_t front_grid_owner(const struct front_grid *grid, double x, double y);

/* The same, with FRONT_GRID_STICK if it is a stick. */
uint32_t front_grid_body(const struct front_grid *grid, double x, double y);

/* Whether that ball itself is in front at every point of a box (left, top, right, bottom). */
bool front_grid_is_all(const struct front_grid *grid, const double box[4], uint32_t ball);
