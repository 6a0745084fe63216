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
  for (int band = 0; band < BANDS && picture->border[band] <= most; ++band) {
    double below[MOST_CORNERS], above[MOST_CORNERS];
    if (picture->border[band + 2] < least) continue;
    for (int k = 0; k < polygon->corners; ++k) below[k] = picture->border[band] - polygon->corner[k].circle;
    const struct polygon outer = polygon_cut_off(polygon, below, 1);
    for (int k = 0; k < outer.corners; ++k) above[k] = outer.corner[k].circle - picture->border[band + 2];
    const struct polygon part = polygon_cut_off(&outer, above, 2);
    add_polygon(picture, &part, layer, colour * BANDS + (uint32_t)band);
  }
}

bool mesh_is_of_sphere(const struct mesh_picture *picture, uint32_t triangle) {
  const struct triangle_mesh *const mesh = picture->mesh;
  const uint32_t kind = mesh->kinds[triangle];
  const bool convex = kind == HSP_PATCH_CONVEX;
  const double radius = convex ? picture->molecule->radius[mesh->balls[triangle]] : mesh->probe;
  return (convex || kind == HSP_PATCH_CONCAVE) && radius * picture->frame.scale < largest_sphere;
}

/* The sphere of a convex patch is that of its ball; that of a concave one is its own. */
uint32_t mesh_sphere_paint(const struct mesh_picture *picture, uint32_t triangle, int side) {
  const struct triangle_mesh *const mesh = picture->mesh;
  const bool convex = mesh->kinds[triangle] == HSP_PATCH_CONVEX;
  const uint32_t sphere = convex ? mesh->balls[triangle] : mesh->atoms + mesh->patches[triangle];
  return FIRST_SPHERE + picture->sides * sphere + (uint32_t)side;
}

void mesh_add_polygon(struct mesh_picture *picture, const struct polygon *polygon, uint32_t triangle, int side) {
  const uint32_t layer = picture->layer[triangle];
  const bool convex = picture->mesh->kinds[triangle] == HSP_PATCH_CONVEX;
  const uint32_t ball = convex ? picture->mesh->balls[triangle] : BETWEEN_ATOMS;
  if (polygon->corners < 3) return;
  if (mesh_is_of_sphere(picture, triangle)) {
    add_polygon(picture, polygon, layer, mesh_sphere_paint(picture, triangle, side));
  } else {
    add_bands(picture, polygon, layer, mesh_colour_of(picture, ball, side));
  }
}
