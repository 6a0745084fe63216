#include "draw/mesh_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_facing.h"
#include "draw/mesh_layers.h"
#include "draw/mesh_lines.h"
#include "draw/mesh_page.h"
#include "draw/surface_light.h"
#include "hardsphere.h"
#include "read/vectors.h"
#include "write/output_file.h"

static const double slack = 0.3;         /* of overlaps */
static const int32_t step_of_points = 3; /* at which triangles are seen or not */

/* ---- triangles ---- */

/* With the normals turned to the viewer. */
static struct polygon polygon_of(const struct mesh_picture *picture, uint32_t triangle, int side) {
  struct polygon polygon = {.corners = 3};
  for (int k = 0; k < 3; ++k) {
    const uint32_t vertex = picture->mesh->corners[3 * (size_t)triangle + (size_t)k];
    double normal[3];
    mesh_turn(picture->view->axis, picture->mesh->normals + 3 * (size_t)vertex, normal);
    for (int axis = 0; axis < 3 && mesh_plain_side(side) != OUTSIDE; ++axis) normal[axis] = -normal[axis];
    memcpy(polygon.corner[k].at, picture->parts.seen + 3 * (size_t)vertex, sizeof polygon.corner[k].at);
    polygon.corner[k].circle = surface_light_circle(normal);
    polygon.corner[k].on = 0;
  }
  return polygon;
}

/* Add the line in which the plane of the cut meets a triangle. */
static void add_section(struct mesh_picture *picture, const struct polygon *polygon, const double value[3]) {
  double ends[2][3];
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if ((value[k] <= 0.0) == (value[next] <= 0.0)) continue;
    const struct corner end = polygon_between(&polygon->corner[k], &polygon->corner[next], value[k], value[next]);
    memcpy(ends[value[k] <= 0.0 ? 0 : 1], end.at, sizeof end.at);
    ++count;
  }
  if (count != 2) return;
  struct painted_edge edge = {.layer = 0, .paint = 0};
  mesh_place(&picture->frame, ends[0], edge.from);
  mesh_place(&picture->frame, ends[1], edge.to);
  painted_edges_add(&picture->section, &edge);
}

static void add_triangle(struct mesh_picture *picture, uint32_t triangle) {
  const int side = mesh_side_of(picture, triangle);
  struct polygon polygon = polygon_of(picture, triangle, side);
  if (mesh_plain_side(side) != OF_VOID && picture->parts.cut < INFINITY) {
    double value[MOST_CORNERS];
    for (int k = 0; k < 3; ++k) value[k] = polygon.corner[k].at[2] - picture->parts.cut;
    polygon = polygon_cut_off(&polygon, value, 0);
  }
  mesh_add_polygon(picture, &polygon, triangle, side);
}

/* Triangles that turn away are hidden by the closed surface itself. A void is drawn as a body: its triangles that face
 * the viewer are those that turn away as a surface of the balls. */
static bool is_shown(const struct mesh_picture *picture, uint32_t triangle) {
  const uint32_t first = picture->mesh->corners[3 * (size_t)triangle];
  const bool of_void = mesh_parts_is_of_void(&picture->parts, first);
  const bool cut = picture->view->cut;
  if (cut && of_void != (triangle >= picture->view->of_outside)) return false;
  if (of_void) return cut && mesh_faces_viewer(picture, triangle);
  if (!mesh_faces_viewer(picture, triangle) && !cut) return false;
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
    picture->shown[t] = is_shown(picture, t);
    if (!picture->shown[t]) continue;
    struct seen_triangle *const one = &seen[count];
    one->number = t;
    one->whole = true;
    const bool of_void = mesh_parts_is_of_void(&picture->parts, mesh->corners[3 * (size_t)t]);
    for (int k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh->corners[3 * (size_t)t + (size_t)k];
      const double *at = picture->parts.seen + 3 * (size_t)vertex;
      memcpy(one->at[k], picture->page[vertex], sizeof one->at[k]);
      one->depth[k] = at[2];
      one->whole = one->whole && (of_void || at[2] <= picture->parts.cut);
    }
    /* Near a contour some triangles are turned round by rounding to whole units, and since edges are chords. They would
     * lie over their own neighbours. */
    const double area = seen_triangle_area(one);
    if (picture->faces[t] ? area < 0.0 : area > 0.0) ++count; /* y is down */
  }
  bool enough = mesh_layers_find(seen, count, slack) && mesh_layers_find_seen(seen, count, step_of_points);
  for (uint32_t i = 0; enough && i < count; ++i) {
    if (seen[i].points > 0) picture->layer[seen[i].number] = seen[i].layer;
  }
  enough = enough && mesh_lines_find(picture, seen, count);
  for (uint32_t i = 0; enough && i < count; ++i) {
    if (seen[i].points == 0) continue;
    if (seen[i].whole) picture->points[seen[i].number] = seen[i].points;
    add_triangle(picture, seen[i].number);
  }
  free(seen);
  return enough;
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

/* ---- all of it ---- */

static bool make(struct mesh_picture *picture) {
  const struct triangle_mesh *mesh = picture->mesh;
  const bool cut = picture->view->cut;
  picture->layer = calloc((size_t)mesh->triangles + 1, sizeof *picture->layer);
  picture->ball = calloc((size_t)mesh->atoms + 1, 3 * sizeof *picture->ball);
  picture->points = calloc((size_t)mesh->triangles + 1, sizeof *picture->points);
  picture->page = calloc((size_t)mesh->vertices + 1, sizeof *picture->page);
  picture->shown = calloc((size_t)mesh->triangles + 1, sizeof *picture->shown);
  picture->faces = calloc((size_t)mesh->triangles + 1, sizeof *picture->faces);
  if (picture->layer == NULL || picture->points == NULL || picture->page == NULL || picture->ball == NULL ||
      picture->shown == NULL || picture->faces == NULL) {
    return false;
  }
  for (size_t i = 0; i < mesh->atoms; ++i) {
    mesh_turn(picture->view->axis, picture->molecule->xyz + 3 * i, picture->ball + 3 * i);
  }
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    picture->faces[t] = mesh_facing(mesh, picture->view, picture->molecule, t) > 0.0;
  }
  picture->mean_radius = molecule_mean_radius(picture->molecule) + (picture->view->patches == NULL ? mesh->probe : 0.0);
  if (!mesh_parts_find(mesh, picture->view->axis, &picture->parts)) return false;
  const struct mesh_pockets *const pockets = picture->view->pockets;
  const bool through = pockets != NULL && pockets->count > 0;
  const double depth = through ? dot(picture->view->axis[2], pockets->through) : 0.0;
  if (cut && !mesh_parts_cut(mesh, picture->view->of_outside, through ? &depth : NULL, &picture->parts)) return false;
  mesh_find_frame(&picture->parts, &picture->frame);
  for (size_t v = 0; v < mesh->vertices; ++v) {
    mesh_place(&picture->frame, picture->parts.seen + 3 * v, picture->page[v]);
  }
  for (int k = 0; k < BANDS + 2; ++k) picture->border[k] = surface_light_border((double)k / BANDS);
  if (!paint_triangles(picture)) return false;
  if (cut) find_section(picture);
  painted_edges_cancel(&picture->areas);
  painted_edges_cancel(&picture->section);
  return !picture->areas.out_of_memory && !picture->section.out_of_memory &&
         painted_edges_find_joints(&picture->areas, FIRST_SPHERE, UINT32_MAX);
}

bool mesh_picture_write(const struct triangle_mesh *mesh, const struct mesh_view *view, const struct molecule *molecule,
                        const char *title, const char *path, uint64_t *bytes, struct failure *failure) {
  struct mesh_picture picture = {.mesh = mesh, .view = view, .molecule = molecule, .sides = SIDES};
  if (view->pockets != NULL) picture.sides += 2 * OTHER_POCKETS;
  struct text_buffer text = TEXT_BUFFER_EMPTY;
  const bool made = make(&picture) && mesh_add_svg(&picture, title, &text);
  const bool done = made ? output_file_write_text(path, &text, failure) : failure_of_memory(failure);
  if (done) *bytes = text.length;
  text_buffer_free(&text);
  mesh_parts_free(&picture.parts);
  painted_edges_free(&picture.areas);
  painted_edges_free(&picture.creases);
  painted_edges_free(&picture.lines);
  painted_edges_free(&picture.section);
  free(picture.layer);
  free(picture.points);
  free(picture.page);
  free(picture.patch_points);
  free(picture.shown);
  free(picture.faces);
  free(picture.ball);
  return done;
}
