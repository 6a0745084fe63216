#include <math.h>
#include <string.h>

#include "draw/mesh_page.h"
#include "draw/surface_light.h"
#include "hardsphere.h"

static const double largest_sphere = 1e7; /* larger ones are as good as flat: no circles of light are seen */

static void add_polygon(struct mesh_picture *picture, const struct polygon *polygon, uint32_t layer, uint32_t paint) {
  for (int k = 0; k < polygon->corners; ++k) {
    const struct corner *const from = &polygon->corner[k];
    const struct corner *const to = &polygon->corner[(k + 1) % polygon->corners];
    struct painted_edge edge = {.layer = layer, .paint = paint, .inner = (from->on & to->on) != 0};
    mesh_place(&picture->frame, from->at, edge.from);
    mesh_place(&picture->frame, to->at, edge.to);
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
    const struct polygon outer = polygon_cut_off(polygon, below, 1);
    for (int k = 0; k < outer.corners; ++k) above[k] = outer.corner[k].circle - picture->border[band + 2];
    const struct polygon part = polygon_cut_off(&outer, above, 2);
    add_polygon(picture, &part, layer, colour * MOST_BANDS + (uint32_t)band);
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
  const double share[2] = {mesh_dot(apart, to), -mesh_dot(apart, from)};
  for (int k = 0; k < 3; ++k) {
    middle[k] = share[0] <= 0.0 ? to[k] : share[1] <= 0.0 ? from[k] : share[0] * from[k] + share[1] * to[k];
  }
}

static void add_unit(const double *vector, double *sum) {
  const double length = sqrt(mesh_dot(vector, vector));
  for (int k = 0; k < 3 && length > 0.0; ++k) sum[k] += vector[k] / length;
}

/* The normal of the plane through the probe's centre and two points, towards where one more is ahead. */
static void find_plane(const double a[3], const double b[3], const double ahead[3], double normal[3]) {
  cross(a, b, normal);
  const double sign = mesh_dot(normal, ahead) < 0.0 ? -1.0 : 1.0;
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
  mesh_turn(picture->view->axis, picture->view->patches[patch].probe, probe);
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
  if (kind == CORNER && !(mesh_dot(normal[0], normal[0]) > 0.0)) part.corners = 0; /* it has nothing of both sides */
  for (int plane = 0; plane < (kind == CORNER_OF_THREE ? 2 : 1); ++plane) {
    double value[MOST_CORNERS] = {0.0};
    for (int k = 0; k < part.corners; ++k) {
      double from[3];
      for (int axis = 0; axis < 3; ++axis) from[axis] = part.corner[k].at[axis] - probe[axis];
      value[k] = kind == WITHOUT_CORNER ? -mesh_dot(normal[plane], from) : mesh_dot(normal[plane], from);
    }
    part = polygon_cut_off(&part, value, 0);
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
  return polygon_cut_off(polygon, value, 0);
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
    add_polygon(picture, polygon, layer, FIRST_SPHERE + picture->sides * sphere + (uint32_t)side);
  } else {
    add_bands(picture, polygon, layer, mesh_colour_of(picture, ball, side));
  }
}

void mesh_add_parts(struct mesh_picture *picture, const struct polygon *polygon, uint32_t triangle, int side) {
  const uint32_t patch = picture->mesh->patches[triangle];
  const uint32_t *const balls = picture->patch_ball[patch];
  const int count = balls[1] == UINT32_MAX ? 1 : balls[2] == UINT32_MAX ? 2 : 3;
  uint32_t colour[3];
  for (int slot = 0; slot < count; ++slot) colour[slot] = mesh_colour_of(picture, balls[slot], side);
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
