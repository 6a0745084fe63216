/* A picture while it is made, for the units that make it: its page, and its colours. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/mesh_outlines.h"
#include "draw/mesh_parts.h"
#include "draw/mesh_picture.h"
#include "draw/mesh_polygon.h"
#include "read/text_buffer.h"

/* Bands of light on saddles: so many that a step from one to the next is two of the 255 tones of a screen. */
enum { MOST_COLOURS = 128, BANDS = 48 };

/* The visible sides of a surface; each pocket adds two more, its outside and its voids. */
enum { OUTSIDE, INSIDE, OF_VOID, SIDES };

/* The numbers of paints in a layer: first for each colour its bands of light, then for each sphere its sides. So
 * spheres are painted later, and their dark rims extend over the ends of saddles behind them. */
#define FIRST_SPHERE ((uint32_t)MOST_COLOURS * BANDS)

/* Lengths: the width in pixels, the letters, as all that follows, in tenths of a pixel. */
#define PICTURE_WIDTH 1000.0
#define PAGE_MARGIN 0.03 /* of the larger side */
#define PAGE_LETTER 220.0

/* Tenths of a px. */
struct frame {
  double scale, left, top;
  int32_t width, height, strip;
};

struct mesh_picture {
  const struct triangle_mesh *mesh;
  const struct mesh_view *view;
  const struct molecule *molecule;
  struct mesh_parts parts;
  struct frame frame;
  uint32_t *layer;               /* [triangles], UINT32_MAX: not shown */
  bool *shown;                   /* [triangles], seen or hidden */
  bool *faces;                   /* [triangles], whether the viewer is on the outside (mesh_facing.h) */
  int32_t (*page)[2];            /* [vertices], their places on the page */
  uint32_t *points;              /* [triangles], visible points of triangles that the plane leaves whole */
  uint64_t *patch_points;        /* [patches], visible points */
  double *ball;                  /* [atoms][3], along the axes of the view */
  double mean_radius;            /* of the balls whose surface this is, with the probe if it is inflated */
  uint32_t colour[MOST_COLOURS]; /* [colours], each once */
  uint32_t colours;
  uint32_t sides;           /* number of sides of spheres, with those of pockets */
  double border[BANDS + 2]; /* the light's circles at which bands begin */
  struct painted_edges areas, creases, lines, section;
};

#define LINE_COLOUR UINT32_C(0x23202B)

/* The colours of the page and of the text on it. */
uint32_t mesh_page_colour(const struct mesh_picture *picture);
uint32_t mesh_text_colour(const struct mesh_picture *picture);

/* ---- places ---- */

int32_t mesh_rounded(double value);
void mesh_find_frame(const struct mesh_parts *parts, struct frame *frame);
void mesh_place(const struct frame *frame, const double *at, int32_t page[2]);
void mesh_turn(const double axis[3][3], const double *from, double to[3]);

/* ---- sides and colours ---- */

int mesh_pocket_of(int side); /* from 1 on; 0: none */
int mesh_plain_side(int side);

/* Whether a triangle shows its outside; or, if it belongs to a void, which is drawn as a body, its inside. */
bool mesh_faces_viewer(const struct mesh_picture *picture, uint32_t triangle);
int mesh_side_of(const struct mesh_picture *picture, uint32_t triangle);

uint32_t mesh_element_of(const struct mesh_picture *picture, uint32_t ball);
uint32_t mesh_element_colour(uint32_t number);
uint32_t mesh_plain_colour(int side);    /* for sides without colours of elements; SIDES: the colour of nothing */
uint32_t mesh_pocket_colour(int pocket); /* from 1 on to OTHER_POCKETS */

/* In place of a ball, and the colour, for saddles and concave patches. */
#define BETWEEN_ATOMS UINT32_MAX
#define BETWEEN_COLOUR UINT32_C(0xC3CCD3)

/* The number of the colour of a ball, or of BETWEEN_ATOMS. */
uint32_t mesh_colour_of(struct mesh_picture *picture, uint32_t ball, int side);

/* ---- painting ---- */

/* Whether a triangle has the light of a sphere; and, if so, its paint when that side of it is seen. */
bool mesh_is_of_sphere(const struct mesh_picture *picture, uint32_t triangle);
uint32_t mesh_sphere_paint(const struct mesh_picture *picture, uint32_t triangle, int side);

/* Add a triangle, or the part of it that a cut leaves. */
void mesh_add_polygon(struct mesh_picture *picture, const struct polygon *polygon, uint32_t triangle, int side);

/* Write the content of the file. False: memory is short. */
bool mesh_add_svg(struct mesh_picture *picture, const char *title, struct text_buffer *out);
