#include "draw/mesh_picture.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/colour_mixed.h"
#include "draw/mesh_layers.h"
#include "draw/mesh_outlines.h"
#include "draw/mesh_parts.h"
#include "draw/pen.h"
#include "draw/surface_light.h"
#include "draw/text_width.h"
#include "hardsphere.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

static const double picture_width = 1000.0; /* px */
static const double margin = 0.03;          /* of the larger side */
static const double letter = 220.0;         /* tenths of a px, as all that follows */
static const double slack = 2.0;            /* of overlaps */
static const int32_t step_of_points = 3;    /* at which triangles are seen or not */
static const double hairline = 5.0;         /* at most */
static const double hairline_per_unit = 0.0055, thinnest = 1.2;
static const double section_line = 22.0;
static const double largest_sphere = 1e7;  /* larger ones are as good as flat: no circles of light are seen */
static const double bands_per_unit = 0.08; /* of the picture's scale: the smaller saddles are, the fewer */

static const uint32_t inside_colour = 0xC9B79C;
static const uint32_t void_colour = 0xC2452F;
static const uint32_t line_colour = 0x23202B;
static const double element_share = 0.7; /* the rest is grey */
static const uint32_t grey = 0xD2CDC3;

enum {
  HYDROGEN = 1,
  CARBON = 6,
  ELEMENTS = 119,
  MOST_COLOURS = 128,
  FEWEST_BANDS = 16,
  MOST_BANDS = 64,
  MOST_CORNERS = 12
};

/* The visible sides of a surface; with pockets two more of each, their outsides and their voids. */
enum { OUTSIDE, INSIDE, OF_VOID, SIDES };

static int pocket_side(uint8_t pocket, int side) {
  return SIDES + 2 * (pocket - 1) + (side == OF_VOID ? 1 : 0);
}

/* From 1 on; 0: none. */
static int pocket_of(int side) {
  return side < SIDES ? 0 : (side - SIDES) / 2 + 1;
}

static int plain_side(int side) {
  return side < SIDES ? side : (side - SIDES) % 2 == 1 ? OF_VOID : OUTSIDE;
}

/* Paints of a layer are numbered: for each sphere those of its sides, for each colour its bands of light, then
 * lines. */
static const uint32_t first_band = UINT32_C(1) << 31;
static const uint32_t hairlines = UINT32_MAX;

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
  uint32_t *layer;           /* [triangles], UINT32_MAX: not shown */
  uint32_t (*patch_ball)[3]; /* [patches], that it comes from; UINT32_MAX: no more */
  uint32_t patches;
  double *ball;                  /* [atoms][3], along the axes of the view */
  uint32_t colour[MOST_COLOURS]; /* [colours], each once */
  uint32_t colours;
  uint32_t sides;                /* of spheres, with those of pockets */
  int bands;                     /* of light, on saddles */
  double border[MOST_BANDS + 2]; /* where they begin, of the light's circles */
  struct painted_edges areas, section;
};

/* ---- where things are ---- */

static int32_t rounded(double value) {
  return (int32_t)floor(value + 0.5);
}

static void find_frame(const struct mesh_parts *parts, struct frame *frame) {
  const double wide = parts->high[0] - parts->low[0];
  const double high = parts->high[1] - parts->low[1];
  const double around = margin * (wide > high ? wide : high);
  const double across = wide + 2.0 * around;
  *frame = (struct frame){1.0, 0.0, 0.0, rounded(10.0 * picture_width), rounded(10.0 * picture_width), 0};
  if (!(across > 0.0)) return; /* nothing is seen */
  frame->scale = 10.0 * picture_width / across;
  frame->left = parts->low[0] - around;
  frame->top = parts->high[1] + around;
  frame->height = rounded(frame->scale * (high + 2.0 * around));
  frame->strip = rounded(2.0 * letter);
}

static void place(const struct frame *frame, const double *at, int32_t page[2]) {
  page[0] = rounded((at[0] - frame->left) * frame->scale);
  page[1] = rounded((frame->top - at[1]) * frame->scale);
}

static void turn(const double axis[3][3], const double *from, double to[3]) {
  for (int k = 0; k < 3; ++k) to[k] = axis[k][0] * from[0] + axis[k][1] * from[1] + axis[k][2] * from[2];
}

/* ---- colours ---- */

static uint32_t colour_number(struct mesh_picture *picture, uint32_t colour) {
  uint32_t k = 0;
  while (k < picture->colours && picture->colour[k] != colour) ++k;
  if (k == MOST_COLOURS) return k - 1; /* more than there are elements */
  if (k == picture->colours) picture->colour[picture->colours++] = colour;
  return k;
}

static uint32_t number_of(const struct mesh_picture *picture, uint32_t ball) {
  const struct atom_label *label = &picture->molecule->label[ball];
  return label->element.text[0] == '\0' ? CARBON : element_atomic_number(label->element);
}

static uint32_t element_colour(uint32_t number) {
  return colour_mixed(grey, hsp_palette_colour(HSP_PALETTE_SOFT, number, 0), element_share);
}

static const uint32_t pocket_colours[MESH_POCKETS] = {0x2F6DB5, 0xE0862B, 0x3E9B62, 0x8F5FB0, 0xB9A62A, 0x35A3B3};

static uint32_t colour_of(struct mesh_picture *picture, uint32_t ball, int side) {
  if (pocket_of(side) > 0) return colour_number(picture, pocket_colours[pocket_of(side) - 1]);
  if (side == INSIDE) return colour_number(picture, inside_colour);
  if (picture->view->pockets != NULL) return colour_number(picture, grey);
  if (side == OF_VOID) return colour_number(picture, void_colour);
  return colour_number(picture, element_colour(number_of(picture, ball)));
}

/* ---- polygons, cut along where a linear function is 0 ---- */

struct corner {
  double at[3];  /* along the axes of the view */
  double circle; /* of the light: surface_light.h */
  int on;        /* borders of a band of light: bits */
};

struct polygon {
  struct corner corner[MOST_CORNERS];
  int corners;
};

/* In the same way from both sides, so that neighbours meet. */
static struct corner between(const struct corner *a, const struct corner *b, double value_a, double value_b) {
  bool swapped = false;
  for (int k = 0; k < 3; ++k) {
    if (a->at[k] == b->at[k]) continue;
    swapped = a->at[k] > b->at[k];
    break;
  }
  if (swapped) return between(b, a, value_b, value_a);
  const double share = value_a / (value_a - value_b);
  struct corner corner;
  for (int k = 0; k < 3; ++k) corner.at[k] = a->at[k] + share * (b->at[k] - a->at[k]);
  corner.circle = a->circle + share * (b->circle - a->circle);
  return corner;
}

/* The part where the values at the corners are 0 or less; new corners are on the border `on`. */
static struct polygon cut_off(const struct polygon *polygon, const double value[MOST_CORNERS], int on) {
  struct polygon left = {.corners = 0};
  for (int k = 0; k < polygon->corners; ++k) {
    const int next = (k + 1) % polygon->corners;
    if (value[k] <= 0.0 && left.corners < MOST_CORNERS) left.corner[left.corners++] = polygon->corner[k];
    if ((value[k] < 0.0 && value[next] > 0.0) || (value[k] > 0.0 && value[next] < 0.0)) {
      if (left.corners == MOST_CORNERS) continue;
      struct corner *const made = &left.corner[left.corners++];
      *made = between(&polygon->corner[k], &polygon->corner[next], value[k], value[next]);
      made->on = on | (polygon->corner[k].on & polygon->corner[next].on);
    }
  }
  return left;
}

static void add_polygon(struct mesh_picture *picture, const struct polygon *polygon, uint32_t layer, uint32_t paint) {
  for (int k = 0; k < polygon->corners; ++k) {
    const struct corner *const from = &polygon->corner[k];
    const struct corner *const to = &polygon->corner[(k + 1) % polygon->corners];
    struct painted_edge edge = {.layer = layer, .paint = paint, .inner = (from->on & to->on) != 0};
    place(&picture->frame, from->at, edge.from);
    place(&picture->frame, to->at, edge.to);
    painted_edges_add(&picture->areas, &edge);
  }
}

/* Between two circles of the light each, and on under the next band, which comes later: no page shows between them. */
static void add_bands(struct mesh_picture *picture, const struct polygon *polygon, uint32_t layer, uint32_t colour) {
  double least = 1.0, most = 0.0;
  for (int k = 0; k < polygon->corners; ++k) {
    if (polygon->corner[k].circle < least) least = polygon->corner[k].circle;
    if (polygon->corner[k].circle > most) most = polygon->corner[k].circle;
  }
  for (int band = 0; band < picture->bands && picture->border[band] <= most; ++band) {
    double below[MOST_CORNERS], above[MOST_CORNERS];
    if (picture->border[band + 2] < least) continue;
    for (int k = 0; k < polygon->corners; ++k) below[k] = picture->border[band] - polygon->corner[k].circle;
    const struct polygon outer = cut_off(polygon, below, 1);
    for (int k = 0; k < outer.corners; ++k) above[k] = outer.corner[k].circle - picture->border[band + 2];
    const struct polygon part = cut_off(&outer, above, 2);
    add_polygon(picture, &part, layer, first_band + colour * MOST_BANDS + (uint32_t)band);
  }
}

/* ---- patches ---- */

/* How much nearer a point is to a ball, with the probe, than to its centre: the least is what it belongs to. */
static double power(const struct mesh_picture *picture, uint32_t ball, const double *at) {
  const double *centre = picture->ball + 3 * (size_t)ball;
  const double radius = picture->molecule->radius[ball] + picture->mesh->probe;
  double sum = -radius * radius;
  for (int k = 0; k < 3; ++k) sum += (at[k] - centre[k]) * (at[k] - centre[k]);
  return sum;
}

static double dot(const double *a, const double *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *product) {
  for (int k = 0; k < 3; ++k) {
    product[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }
}

/* Where the parts of two balls of a concave patch meet on the side between them, from the probe's centre: as on the
 * saddle there. One of them may have nothing of it. */
static void find_middle(const double from[3], const double to[3], double middle[3]) {
  double apart[3];
  for (int k = 0; k < 3; ++k) apart[k] = to[k] - from[k];
  const double share[2] = {dot(apart, to), -dot(apart, from)};
  for (int k = 0; k < 3; ++k) {
    middle[k] = share[0] <= 0.0 ? to[k] : share[1] <= 0.0 ? from[k] : share[0] * from[k] + share[1] * to[k];
  }
}

static void add_unit(const double *vector, double *sum) {
  const double length = sqrt(dot(vector, vector));
  for (int k = 0; k < 3 && length > 0.0; ++k) sum[k] += vector[k] / length;
}

/* The normal of the plane through the probe's centre and two points, towards where one more is ahead. */
static void find_plane(const double a[3], const double b[3], const double ahead[3], double normal[3]) {
  cross(a, b, normal);
  const double sign = dot(normal, ahead) < 0.0 ? -1.0 : 1.0;
  for (int k = 0; k < 3; ++k) normal[k] *= sign;
}

/* The three kinds of parts of a concave patch. */
enum part_kind { CORNER_OF_THREE, CORNER, WITHOUT_CORNER };

/* Of a polygon of a concave patch, what belongs to one of its balls, or to the two others: on either side of the line
 * between the points where it meets these on the sides, if they look alike; else there is one more point in the middle,
 * in which all three meet. So colours go on from patch to patch. */
static struct polygon part_of_corner(const struct mesh_picture *picture, const struct polygon *polygon, uint32_t patch,
                                     int slot, enum part_kind kind) {
  double probe[3], to[3][3], side[3][3], within[3] = {0.0, 0.0, 0.0}, normal[2][3];
  turn(picture->view->axis, picture->view->patches[patch].probe, probe);
  for (int i = 0; i < 3; ++i) {
    const double *const centre = picture->ball + 3 * (size_t)picture->patch_ball[patch][(slot + i) % 3];
    for (int k = 0; k < 3; ++k) to[i][k] = centre[k] - probe[k];
  }
  for (int i = 0; i < 3; ++i) find_middle(to[i], to[(i + 1) % 3], side[i]);
  for (int i = 0; i < 3; ++i) add_unit(side[i], within);
  double ahead[2][3];
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 2; ++i) ahead[i][k] = to[i + 1][k] - to[0][k];
    if (kind != CORNER_OF_THREE) ahead[0][k] = to[1][k] + to[2][k] - to[0][k];
  }
  find_plane(side[0], kind == CORNER_OF_THREE ? within : side[2], ahead[0], normal[0]);
  find_plane(side[2], within, ahead[1], normal[1]);
  struct polygon part = *polygon;
  if (kind == CORNER && !(dot(normal[0], normal[0]) > 0.0)) part.corners = 0; /* it has nothing of both sides */
  for (int plane = 0; plane < (kind == CORNER_OF_THREE ? 2 : 1); ++plane) {
    double value[MOST_CORNERS] = {0.0};
    for (int k = 0; k < part.corners; ++k) {
      double from[3];
      for (int axis = 0; axis < 3; ++axis) from[axis] = part.corner[k].at[axis] - probe[axis];
      value[k] = kind == WITHOUT_CORNER ? -dot(normal[plane], from) : dot(normal[plane], from);
    }
    part = cut_off(&part, value, 0);
  }
  return part;
}

/* Of a polygon of a saddle, what belongs to one of its two balls. */
static struct polygon part_of_saddle(const struct mesh_picture *picture, const struct polygon *polygon,
                                     const uint32_t balls[3], int slot) {
  double value[MOST_CORNERS];
  for (int k = 0; k < polygon->corners; ++k) {
    const double *at = polygon->corner[k].at;
    value[k] = power(picture, balls[slot], at) - power(picture, balls[1 - slot], at);
  }
  return cut_off(polygon, value, 0);
}

/* The sphere of a convex patch is that of its ball; of a concave one, each ball has its own part. */
static void add_part(struct mesh_picture *picture, const struct polygon *polygon, uint32_t triangle, int slot,
                     uint32_t ball, int side) {
  const struct triangle_mesh *mesh = picture->mesh;
  const uint32_t kind = mesh->kinds[triangle];
  const uint32_t layer = picture->layer[triangle];
  const double radius = kind == HSP_PATCH_CONVEX ? picture->molecule->radius[ball] : mesh->probe;
  const bool of_sphere = kind == HSP_PATCH_CONVEX || kind == HSP_PATCH_CONCAVE;
  if (of_sphere && radius * picture->frame.scale < largest_sphere) {
    const uint32_t sphere =
        kind == HSP_PATCH_CONVEX ? ball : mesh->atoms + 3 * mesh->patches[triangle] + (uint32_t)slot;
    add_polygon(picture, polygon, layer, picture->sides * sphere + (uint32_t)side);
  } else {
    add_bands(picture, polygon, layer, colour_of(picture, ball, side));
  }
}

/* Where colours differ, each has its part. */
static void add_parts(struct mesh_picture *picture, const struct polygon *polygon, uint32_t triangle, int side) {
  const uint32_t patch = picture->mesh->patches[triangle];
  const uint32_t *const balls = picture->patch_ball[patch];
  const int count = balls[1] == UINT32_MAX ? 1 : balls[2] == UINT32_MAX ? 2 : 3;
  uint32_t colour[3];
  for (int slot = 0; slot < count; ++slot) colour[slot] = colour_of(picture, balls[slot], side);
  int alike = count == 1 ? 1 : 0, alone = 0; /* pairs of equal colours, and the slot that is in none */
  for (int slot = 0; slot < count && count > 1; ++slot) {
    if (colour[slot] != colour[(slot + 1) % count]) continue;
    ++alike;
    alone = (slot + 2) % 3;
  }
  const bool one = alike == count;
  const bool pair = count == 3 && alike == 1;
  for (int k = 0; k < (one ? 1 : pair ? 2 : count); ++k) {
    struct polygon part = *polygon;
    const int slot = pair ? (alone + k) % 3 : k;
    if (pair) {
      part = part_of_corner(picture, polygon, patch, alone, k == 0 ? CORNER : WITHOUT_CORNER);
    } else if (!one) {
      part = count == 2 ? part_of_saddle(picture, polygon, balls, slot)
                        : part_of_corner(picture, polygon, patch, slot, CORNER_OF_THREE);
    }
    if (part.corners >= 3) add_part(picture, &part, triangle, slot, balls[slot], side);
  }
}

static int side_of(const struct mesh_picture *picture, uint32_t triangle, double area) {
  const struct mesh_pockets *const pockets = picture->view->pockets;
  const uint8_t pocket = pockets == NULL                        ? 0
                         : triangle < picture->view->of_outside ? pockets->of_triangle[triangle]
                                                                : pockets->of_patch[picture->mesh->patches[triangle]];
  const bool of_void = mesh_parts_is_of_void(&picture->parts, picture->mesh->corners[3 * (size_t)triangle]);
  const int side = of_void ? OF_VOID : area < 0.0 ? INSIDE : OUTSIDE;
  return pocket > 0 && side != INSIDE ? pocket_side(pocket, side) : side;
}

/* Twice the area on the page, above 0 if it is counter-clockwise. */
static double seen_area(const struct mesh_picture *picture, uint32_t triangle) {
  const double *at[3];
  for (int k = 0; k < 3; ++k) {
    at[k] = picture->parts.seen + 3 * (size_t)picture->mesh->corners[3 * (size_t)triangle + (size_t)k];
  }
  return (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
}

/* With the normals turned to the viewer. */
static struct polygon polygon_of(const struct mesh_picture *picture, uint32_t triangle, int side) {
  struct polygon polygon = {.corners = 3};
  for (int k = 0; k < 3; ++k) {
    const uint32_t vertex = picture->mesh->corners[3 * (size_t)triangle + (size_t)k];
    double normal[3];
    turn(picture->view->axis, picture->mesh->normals + 3 * (size_t)vertex, normal);
    for (int axis = 0; axis < 3 && plain_side(side) != OUTSIDE; ++axis) normal[axis] = -normal[axis];
    memcpy(polygon.corner[k].at, picture->parts.seen + 3 * (size_t)vertex, sizeof polygon.corner[k].at);
    polygon.corner[k].circle = surface_light_circle(normal);
    polygon.corner[k].on = 0;
  }
  return polygon;
}

/* Where the plane of the cut goes through. */
static void add_section(struct mesh_picture *picture, const struct polygon *polygon, const double value[3]) {
  double ends[2][3];
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if ((value[k] <= 0.0) == (value[next] <= 0.0)) continue;
    const struct corner end = between(&polygon->corner[k], &polygon->corner[next], value[k], value[next]);
    memcpy(ends[value[k] <= 0.0 ? 0 : 1], end.at, sizeof end.at);
    ++count;
  }
  if (count != 2) return;
  struct painted_edge edge = {.layer = 0, .paint = 0};
  place(&picture->frame, ends[0], edge.from);
  place(&picture->frame, ends[1], edge.to);
  painted_edges_add(&picture->section, &edge);
}

static void add_triangle(struct mesh_picture *picture, uint32_t triangle) {
  const int side = side_of(picture, triangle, seen_area(picture, triangle));
  struct polygon polygon = polygon_of(picture, triangle, side);
  if (plain_side(side) != OF_VOID && picture->parts.cut < INFINITY) {
    double value[MOST_CORNERS];
    for (int k = 0; k < 3; ++k) value[k] = polygon.corner[k].at[2] - picture->parts.cut;
    polygon = cut_off(&polygon, value, 0);
  }
  add_parts(picture, &polygon, triangle, side);
}

/* Nobody looks through a closed surface. Of a void, as a body, what faces the viewer is what turns away from him as a
 * surface of the balls. */
static bool is_shown(const struct mesh_picture *picture, uint32_t triangle) {
  const uint32_t first = picture->mesh->corners[3 * (size_t)triangle];
  const bool of_void = mesh_parts_is_of_void(&picture->parts, first);
  const bool cut = picture->view->cut;
  const double area = seen_area(picture, triangle);
  if (cut && of_void != (triangle >= picture->view->of_outside)) return false;
  if (of_void) return cut && area < 0.0;
  if (!(area > 0.0 || (cut && area < 0.0))) return false;
  bool behind = false;
  for (int k = 0; k < 3; ++k) {
    const uint32_t vertex = picture->mesh->corners[3 * (size_t)triangle + (size_t)k];
    if (picture->parts.seen[3 * (size_t)vertex + 2] > picture->parts.cut) continue;
    if (picture->parts.dropped[vertex]) return false;
    behind = true;
  }
  return behind;
}

static bool paint_triangles(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  struct seen_triangle *seen = calloc((size_t)mesh->triangles + 1, sizeof *seen);
  uint32_t count = 0;
  if (seen == NULL) return false;
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    picture->layer[t] = UINT32_MAX;
    if (!is_shown(picture, t)) continue;
    struct seen_triangle *const one = &seen[count++];
    one->number = t;
    one->whole = true;
    for (int k = 0; k < 3; ++k) {
      const double *at = picture->parts.seen + 3 * (size_t)mesh->corners[3 * (size_t)t + (size_t)k];
      place(&picture->frame, at, one->at[k]);
      one->depth[k] = at[2];
      one->whole = one->whole && at[2] <= picture->parts.cut;
    }
  }
  const bool enough = mesh_layers_find(seen, count, slack) && mesh_layers_find_seen(seen, count, step_of_points);
  for (uint32_t i = 0; enough && i < count; ++i) {
    if (!seen[i].seen) continue;
    picture->layer[seen[i].number] = seen[i].layer;
    add_triangle(picture, seen[i].number);
  }
  free(seen);
  return enough;
}

/* ---- lines ---- */

struct side {
  uint32_t low, high, triangle;
  bool back;
};

static int compare_sides(const void *left, const void *right) {
  const struct side *a = left;
  const struct side *b = right;
  if (a->low != b->low) return a->low < b->low ? -1 : 1;
  if (a->high != b->high) return a->high < b->high ? -1 : 1;
  return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* A border of two patches that are both seen, in the direction of the patch with the lower number. */
static void add_hairline(struct mesh_picture *picture, const struct side *side, uint32_t layer) {
  struct polygon line = {.corners = 2};
  double value[MOST_CORNERS];
  for (int k = 0; k < 2; ++k) {
    const uint32_t vertex = (k == 0) != side->back ? side->low : side->high;
    memcpy(line.corner[k].at, picture->parts.seen + 3 * (size_t)vertex, sizeof line.corner[k].at);
    line.corner[k].circle = 0.0;
    value[k] = mesh_parts_is_of_void(&picture->parts, vertex) ? -1.0 : line.corner[k].at[2] - picture->parts.cut;
  }
  if (value[0] > 0.0 || value[1] > 0.0) return;
  struct painted_edge edge = {.layer = layer, .paint = hairlines};
  place(&picture->frame, line.corner[0].at, edge.from);
  place(&picture->frame, line.corner[1].at, edge.to);
  painted_edges_add(&picture->areas, &edge);
}

static double hairline_width(const struct mesh_picture *picture) {
  const double width = hairline_per_unit * picture->frame.scale;
  return width < hairline ? width : hairline;
}

static bool paint_lines(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  if (hairline_width(picture) < thinnest) return true;
  struct side *sides = calloc((size_t)mesh->triangles + 1, 3 * sizeof *sides);
  size_t count = 0;
  if (sides == NULL) return false;
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    for (size_t k = 0; k < 3 && picture->layer[t] != UINT32_MAX; ++k) {
      const uint32_t from = mesh->corners[3 * (size_t)t + k], to = mesh->corners[3 * (size_t)t + (k + 1) % 3];
      sides[count++] = (struct side){from < to ? from : to, from < to ? to : from, t, from > to};
    }
  }
  qsort(sides, count, sizeof *sides, compare_sides);
  for (size_t i = 0; i + 1 < count; ++i) {
    const struct side *const one = &sides[i], *const other = &sides[i + 1];
    if (one->low != other->low || one->high != other->high) continue;
    if (mesh->patches[one->triangle] == mesh->patches[other->triangle]) continue;
    const uint32_t layer[2] = {picture->layer[one->triangle], picture->layer[other->triangle]};
    add_hairline(picture, one, layer[0] > layer[1] ? layer[0] : layer[1]);
  }
  free(sides);
  return true;
}

static void find_section(struct mesh_picture *picture) {
  for (uint32_t t = 0; t < picture->view->of_outside; ++t) {
    const uint32_t *c = picture->mesh->corners + 3 * (size_t)t;
    struct polygon polygon = {.corners = 3};
    double value[3];
    bool dropped = mesh_parts_is_of_void(&picture->parts, c[0]);
    for (int k = 0; k < 3; ++k) {
      memcpy(polygon.corner[k].at, picture->parts.seen + 3 * (size_t)c[k], sizeof polygon.corner[k].at);
      polygon.corner[k].circle = 0.0;
      value[k] = polygon.corner[k].at[2] - picture->parts.cut;
      dropped = dropped || (value[k] <= 0.0 && picture->parts.dropped[c[k]]);
    }
    if (!dropped) add_section(picture, &polygon, value);
  }
}

/* ---- the file ---- */

static bool is_of_sphere(uint32_t paint) {
  return paint < first_band;
}

static int compare_paints(const void *left, const void *right) {
  const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
  return (a > b) - (a < b);
}

static uint32_t sphere_colour(struct mesh_picture *picture, uint32_t paint) {
  const uint32_t sphere = paint / picture->sides, atoms = picture->mesh->atoms;
  const uint32_t ball = sphere < atoms ? sphere : picture->patch_ball[(sphere - atoms) / 3][(sphere - atoms) % 3];
  return colour_of(picture, ball, (int)(paint % picture->sides));
}

/* Normals point to the centre of the probe's sphere, and away from that of a ball, but on the inside. */
static void add_sphere(struct mesh_picture *picture, struct text_buffer *out, uint32_t paint) {
  const struct triangle_mesh *mesh = picture->mesh;
  const uint32_t sphere = paint / picture->sides;
  const bool of_ball = sphere < mesh->atoms;
  const bool turned = of_ball == (plain_side((int)(paint % picture->sides)) != OUTSIDE);
  const bool smooth = picture->view->patches != NULL;
  double centre[3];
  double radius = mesh->probe;
  if (of_ball) {
    memcpy(centre, picture->ball + 3 * (size_t)sphere, sizeof centre);
    radius = picture->molecule->radius[sphere] + (smooth ? 0.0 : mesh->probe);
  } else {
    turn(picture->view->axis, picture->view->patches[(sphere - mesh->atoms) / 3].probe, centre);
  }
  int32_t at[2];
  place(&picture->frame, centre, at);
  for (int axis = 0; axis < 2; ++axis) at[axis] *= 2; /* see add_picture */
  const double size = 2.0 * radius * picture->frame.scale * (turned ? -1.0 : 1.0);
  text_buffer_add(out,
                  "<radialGradient id=\"s%" PRIu32 "\" gradientUnits=\"userSpaceOnUse\" cx=\"%" PRId32
                  "\" cy=\"%" PRId32 "\" r=\"%" PRId32 "\" fx=\"%" PRId32 "\" fy=\"%" PRId32 "\">",
                  paint, at[0], at[1], rounded(fabs(size)), rounded(at[0] + surface_light_focus[0] * size),
                  rounded(at[1] - surface_light_focus[1] * size));
  const uint32_t colour = picture->colour[sphere_colour(picture, paint)];
  for (int stop = 0; stop < SURFACE_STOPS; ++stop) {
    text_buffer_add(out, "<stop offset=\"%.2g\" stop-color=\"#%06" PRIx32 "\"/>", surface_light_offset(stop),
                    surface_light_stop(colour, stop));
  }
  text_buffer_add_text(out, "</radialGradient>\n");
}

/* Lines in an area's own colour cover what anti-aliasing leaves open between neighbours. An area of which nothing is
 * left is not written: some readers paint the next one wrongly then. Lists the spheres that are seen, each once. */
static bool add_areas(const struct mesh_picture *picture, struct text_buffer *out, uint32_t *paints, size_t *spheres) {
  const struct painted_edges *areas = &picture->areas;
  bool enough = true;
  for (size_t i = 0, end = 0; enough && i < areas->count; i = end) {
    const uint32_t paint = areas->edge[i].paint;
    const bool line = paint == hairlines, sphere = is_of_sphere(paint);
    const size_t before = out->length;
    end = painted_edges_end(areas, i);
    if (line) {
      text_buffer_add(out,
                      "<path fill=\"none\" stroke=\"#%06" PRIx32 "\" stroke-opacity=\".4\" stroke-width=\"%.2f\" d=\"",
                      line_colour, 2.0 * hairline_width(picture));
    } else if (sphere) {
      text_buffer_add(out, "<path fill=\"url(#s%" PRIu32 ")\" stroke=\"url(#s%" PRIu32 ")\" d=\"", paint, paint);
    } else {
      const uint32_t band = (paint - first_band) % MOST_BANDS, colour = (paint - first_band) / MOST_BANDS;
      const uint32_t tone =
          surface_light_on(picture->colour[colour], picture->border[band] / 2.0 + picture->border[band + 1] / 2.0);
      text_buffer_add(out, "<path fill=\"#%06" PRIx32 "\" stroke=\"#%06" PRIx32 "\" d=\"", tone, tone);
    }
    const size_t begun = out->length;
    enough = painted_edges_write(areas, i, end, !line, sphere || line, out) && !out->out_of_memory;
    if (out->length == begun) {
      out->length = before;
      continue;
    }
    text_buffer_add(out, "\"/>\n");
    if (sphere) paints[(*spheres)++] = paint;
  }
  qsort(paints, *spheres, sizeof *paints, compare_paints);
  size_t kept = 0;
  for (size_t i = 0; i < *spheres; ++i) {
    if (i == 0 || paints[i] != paints[i - 1]) paints[kept++] = paints[i];
  }
  *spheres = kept;
  return enough;
}

/* Within the section the inside is seen everywhere: in its darkest tone below all areas, so that no page shows where
 * one of them is too thin to be painted; over them its line. */
static bool add_section_area(const struct mesh_picture *picture, struct text_buffer *out) {
  if (picture->section.count == 0) return true;
  text_buffer_add(out, "<defs><path id=\"section\" d=\"");
  const bool enough = painted_edges_write(&picture->section, 0, picture->section.count, false, true, out);
  text_buffer_add(out, "\"/></defs>\n<use xlink:href=\"#section\" fill=\"#%06" PRIx32 "\" fill-rule=\"evenodd\"/>\n",
                  surface_light_on(inside_colour, 1.0));
  return enough;
}

static void add_section_line(const struct mesh_picture *picture, struct text_buffer *out) {
  if (picture->section.count == 0) return;
  text_buffer_add(out, "<use xlink:href=\"#section\" fill=\"none\" stroke=\"#%06" PRIx32 "\" stroke-width=\"%.0f\"/>\n",
                  line_colour, 2.0 * section_line);
}

static void add_entry(const struct pen *pen, double *x, double y, uint32_t colour, const char *text) {
  const double corner[2] = {*x, y - letter * 0.45};
  pen_rectangle(pen, corner, 0.9 * letter, 0.9 * letter, colour);
  const struct pen_text written = {text, *x + 1.3 * letter, y + 0.36 * letter, letter, 0.0, line_colour, 0xFFFFFF};
  pen_write(pen, &written);
  *x += 1.9 * letter + text_width(text, letter);
}

static void add_pockets(struct mesh_picture *picture, const struct pen *pen, double *x, double y) {
  bool seen[MESH_POCKETS + 1] = {false}, any = false;
  for (uint32_t t = 0; t < picture->mesh->triangles; ++t) {
    if (picture->layer[t] != UINT32_MAX) seen[pocket_of(side_of(picture, t, seen_area(picture, t)))] = true;
  }
  for (int pocket = 1; pocket <= MESH_POCKETS; ++pocket) {
    char name[sizeof "pocket 4294967295"];
    if (!seen[pocket]) continue;
    snprintf(name, sizeof name, "%s%" PRIu32, any ? "" : "pocket ", picture->view->pockets->number[pocket - 1]);
    any = true;
    add_entry(pen, x, y, surface_light_on(pocket_colours[pocket - 1], 0.4), name);
  }
}

/* Elements whose outside is seen, C and H first, then by their numbers. */
static void add_elements(struct mesh_picture *picture, const struct pen *pen, double *x, double y) {
  bool seen[ELEMENTS] = {false};
  for (uint32_t t = 0; t < picture->mesh->triangles; ++t) {
    if (picture->layer[t] == UINT32_MAX || side_of(picture, t, seen_area(picture, t)) != OUTSIDE) continue;
    const uint32_t ball = picture->mesh->balls[t], number = number_of(picture, ball);
    if (number < ELEMENTS && picture->molecule->label[ball].element.text[0] != '\0') seen[number] = true;
  }
  for (uint32_t k = 0; k < ELEMENTS + 2; ++k) {
    const uint32_t number = k == 0 ? CARBON : k == 1 ? HYDROGEN : k - 2;
    if (!seen[number]) continue;
    seen[number] = false;
    struct element_symbol symbol;
    if (!element_symbol_of_number(number, &symbol)) continue;
    add_entry(pen, x, y, surface_light_on(element_colour(number), 0.4), symbol.text);
  }
}

static void add_legend(struct mesh_picture *picture, struct text_buffer *out) {
  const struct pen pen = {out, HSP_FORMAT_SVG, (double)picture->frame.height};
  const double y = picture->frame.height + picture->frame.strip / 2.0 - 0.3 * letter;
  double x = margin * 10.0 * picture_width;
  bool any = false;
  for (uint32_t t = picture->view->of_outside; t < picture->mesh->triangles; ++t) {
    any = any || picture->layer[t] != UINT32_MAX;
  }
  pen_begin(&pen);
  if (picture->view->pockets != NULL) {
    add_pockets(picture, &pen, &x, y);
  } else {
    add_elements(picture, &pen, &x, y);
  }
  if (picture->view->cut)
    add_entry(&pen, &x, y, surface_light_on(inside_colour, 0.4), "inside of the surface, cut open");
  if (any && picture->view->pockets == NULL) {
    add_entry(&pen, &x, y, surface_light_on(void_colour, 0.4), "voids");
  }
  pen_end(&pen);
}

static bool add_picture(struct mesh_picture *picture, const char *title, struct text_buffer *out) {
  const struct frame *const frame = &picture->frame;
  const int32_t height = frame->height + frame->strip;
  struct text_buffer areas = TEXT_BUFFER_EMPTY;
  uint32_t *paints = calloc(picture->areas.count + 1, sizeof *paints); /* spheres */
  size_t spheres = 0;
  bool enough = paints != NULL && add_areas(picture, &areas, paints, &spheres);
  text_buffer_add(out,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                  "width=\"%" PRId32 ".%" PRId32 "px\" height=\"%" PRId32 ".%" PRId32 "px\" viewBox=\"0 0 %" PRId32
                  " %" PRId32 "\" role=\"img\">\n<title>",
                  frame->width / 10, frame->width % 10, height / 10, height % 10, frame->width, height);
  text_buffer_add_xml(out, title);
  text_buffer_add(out, "</title>\n<rect width=\"%" PRId32 "\" height=\"%" PRId32 "\" fill=\"#ffffff\"/>\n<defs>\n",
                  frame->width, height);
  for (size_t i = 0; i < spheres; ++i) add_sphere(picture, out, paints[i]);
  /* Outlines are in halves of units. */
  text_buffer_add(out,
                  "</defs>\n<g transform=\"scale(.5)\" stroke-width=\"12\" "
                  "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n");
  enough = enough && add_section_area(picture, out);
  text_buffer_append(out, areas.text, areas.length);
  add_section_line(picture, out);
  text_buffer_add(out, "</g>\n");
  if (picture->mesh->triangles > 0) add_legend(picture, out);
  text_buffer_add(out, "</svg>\n");
  text_buffer_free(&areas);
  free(paints);
  return enough;
}

/* ---- all of it ---- */

static bool find_patch_balls(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  for (size_t t = 0; t < mesh->triangles; ++t) {
    if (mesh->patches[t] >= picture->patches) picture->patches = mesh->patches[t] + 1;
  }
  picture->patch_ball = calloc((size_t)picture->patches + 1, sizeof *picture->patch_ball);
  if (picture->patch_ball == NULL) return false;
  memset(picture->patch_ball, 0xFF, picture->patches * sizeof *picture->patch_ball);
  for (size_t t = 0; t < mesh->triangles; ++t) {
    uint32_t *const balls = picture->patch_ball[mesh->patches[t]];
    if (mesh->kinds[t] == HSP_PATCH_CONVEX) {
      balls[0] = mesh->balls[t];
    } else {
      memcpy(balls, picture->view->patches[mesh->patches[t]].ball, sizeof *picture->patch_ball);
    }
  }
  return true;
}

static bool make(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  const bool cut = picture->view->cut;
  picture->layer = calloc((size_t)mesh->triangles + 1, sizeof *picture->layer);
  picture->ball = calloc((size_t)mesh->atoms + 1, 3 * sizeof *picture->ball);
  if (picture->layer == NULL || picture->ball == NULL || !find_patch_balls(picture)) return false;
  for (size_t i = 0; i < mesh->atoms; ++i) {
    turn(picture->view->axis, picture->molecule->xyz + 3 * i, picture->ball + 3 * i);
  }
  if (!mesh_parts_find(mesh, picture->view->axis, &picture->parts)) return false;
  const struct mesh_pockets *const pockets = picture->view->pockets;
  const bool through = pockets != NULL && pockets->count > 0;
  const double depth = through ? dot(picture->view->axis[2], pockets->through) : 0.0;
  if (cut && !mesh_parts_cut(mesh, picture->view->of_outside, through ? &depth : NULL, &picture->parts)) return false;
  find_frame(&picture->parts, &picture->frame);
  const double bands = bands_per_unit * picture->frame.scale;
  picture->bands = bands < FEWEST_BANDS ? FEWEST_BANDS : bands > MOST_BANDS ? MOST_BANDS : (int)bands;
  for (int k = 0; k <= picture->bands + 1; ++k) picture->border[k] = surface_light_border((double)k / picture->bands);
  if (!paint_triangles(picture) || !paint_lines(picture)) return false;
  if (cut) find_section(picture);
  painted_edges_cancel(&picture->areas);
  painted_edges_cancel(&picture->section);
  return !picture->areas.out_of_memory && !picture->section.out_of_memory &&
         painted_edges_find_joints(&picture->areas, first_band);
}

bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure) {
  struct mesh_picture picture = {.mesh = mesh, .view = view, .molecule = molecule, .sides = SIDES};
  if (view->pockets != NULL) picture.sides += 2 * view->pockets->count;
  struct text_buffer text = TEXT_BUFFER_EMPTY;
  const bool made = make(&picture) && add_picture(&picture, title, &text);
  const bool done = made ? output_file_write_text(path, &text, failure) : failure_of_memory(failure);
  if (done) *bytes = text.length;
  text_buffer_free(&text);
  mesh_parts_free(&picture.parts);
  painted_edges_free(&picture.areas);
  painted_edges_free(&picture.section);
  free(picture.layer);
  free(picture.patch_ball);
  free(picture.ball);
  return done;
}
