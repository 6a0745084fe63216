/* Which ball is in front at the points of a grid: for questions that need no more than that, where labels have room and
 * from where most is seen. */
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
  double share, probe; /* a ball's radius is that of its atom times the share, and the probe */
  const struct bond *bond;
  uint32_t bonds;      /* 0: of balls alone */
  double stick;        /* radius */
  const bool *painted; /* [atoms]; NULL: any ball may be seen */
};

double shown_bodies_radius(const struct shown_bodies *bodies, uint32_t atom);

/* To the right, down and towards the viewer; the last row says where the origin is. */
struct page_axes {
  double row[3][3];
  double origin[3];
};

void page_axes_place(const struct page_axes *axes, const double *xyz, double at[3]);

struct front_grid {
  double corner[2], cell; /* the upper left one, and the side of a cell */
  int32_t columns, rows;
  double *height;  /* [rows][columns] of what is in front in the middle of a cell */
  uint32_t *owner; /* [rows][columns] its ball; of a stick that of the half and FRONT_GRID_STICK */
};

/* Over that rectangle, of up to 2^20 cells that are at least so wide; to be freed on true and on false, which is for
 * want of memory. */
bool front_grid_make(struct front_grid *grid, const double low[2], const double high[2], double cell);
void front_grid_free(struct front_grid *grid);

/* Only these bodies; the axes may have a scale. */
void front_grid_show(struct front_grid *grid, const struct shown_bodies *bodies, const struct page_axes *axes,
                     double scale);

/* The ball that is in front, or whose half of a stick is; beyond the grid is nothing. */
uint32_t front_grid_owner(const struct front_grid *grid, double x, double y);

/* The same, with FRONT_GRID_STICK where it is a stick. */
uint32_t front_grid_body(const struct front_grid *grid, double x, double y);

/* Whether at every point of a box (left, top, right, bottom) that ball itself is in front. */
bool front_grid_is_all(const struct front_grid *grid, const double box[4], uint32_t ball);
