#include "write/mesh_file.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"
#include "read/text_buffer.h"
#include "read/vectors.h"
#include "write/output_file.h"

bool triangle_mesh_make(struct triangle_mesh *mesh, uint32_t vertices, uint32_t triangles, struct failure *failure) {
  const size_t v = (size_t)vertices + 1;
  const size_t t = (size_t)triangles + 1;
  mesh->vertices = vertices;
  mesh->triangles = triangles;
  mesh->xyz = calloc(v, 3 * sizeof *mesh->xyz);
  mesh->normals = calloc(v, 3 * sizeof *mesh->normals);
  mesh->areas = calloc(v, sizeof *mesh->areas);
  mesh->vertex_balls = calloc(v, sizeof *mesh->vertex_balls);
  mesh->corners = calloc(t, 3 * sizeof *mesh->corners);
  mesh->kinds = calloc(t, sizeof *mesh->kinds);
  mesh->patches = calloc(t, sizeof *mesh->patches);
  mesh->balls = calloc(t, sizeof *mesh->balls);
  return (mesh->xyz != NULL && mesh->normals != NULL && mesh->areas != NULL && mesh->vertex_balls != NULL &&
          mesh->corners != NULL && mesh->kinds != NULL && mesh->patches != NULL && mesh->balls != NULL) ||
         failure_of_memory(failure);
}

bool triangle_mesh_read(const hsp_mesh *mesh, struct triangle_mesh *into, struct failure *failure) {
  hsp_mesh_counts counts;
  if (hsp_mesh_get_counts(mesh, &counts) != HSP_OK) return failure_of_memory(failure);
  return triangle_mesh_make(into, counts.vertices, counts.triangles, failure) &&
         hsp_mesh_get_vertices(mesh, into->xyz, into->normals, into->areas, into->vertex_balls, counts.vertices,
                               NULL) == HSP_OK &&
         hsp_mesh_get_triangles(mesh, into->corners, into->kinds, into->patches, into->balls, counts.triangles, NULL) ==
             HSP_OK;
}

static bool append(void *array, size_t size, size_t count, const void *more, size_t more_count) {
  void *items;
  memcpy(&items, array, sizeof items); /* whatever it points to, as in growing_array.c */
  void *const grown = realloc(items, (count + more_count + 1) * size);
  if (grown == NULL) return false;
  memcpy(array, &grown, sizeof grown);
  memcpy((char *)grown + count * size, more, more_count * size);
  return true;
}

bool triangle_mesh_append(struct triangle_mesh *mesh, const struct triangle_mesh *more, struct failure *failure) {
  const size_t v = mesh->vertices, t = mesh->triangles, more_v = more->vertices, more_t = more->triangles;
  if (v + more_v >= UINT32_MAX || t + more_t >= UINT32_MAX ||
      !append(&mesh->xyz, 3 * sizeof *mesh->xyz, v, more->xyz, more_v) ||
      !append(&mesh->normals, 3 * sizeof *mesh->normals, v, more->normals, more_v) ||
      !append(&mesh->areas, sizeof *mesh->areas, v, more->areas, more_v) ||
      !append(&mesh->vertex_balls, sizeof *mesh->vertex_balls, v, more->vertex_balls, more_v) ||
      !append(&mesh->corners, 3 * sizeof *mesh->corners, t, more->corners, more_t) ||
      !append(&mesh->kinds, sizeof *mesh->kinds, t, more->kinds, more_t) ||
      !append(&mesh->patches, sizeof *mesh->patches, t, more->patches, more_t) ||
      !append(&mesh->balls, sizeof *mesh->balls, t, more->balls, more_t)) {
    return failure_of_memory(failure);
  }
  for (size_t k = 3 * t; k < 3 * (t + more_t); ++k) mesh->corners[k] += (uint32_t)v;
  mesh->vertices = (uint32_t)(v + more_v);
  mesh->triangles = (uint32_t)(t + more_t);
  return true;
}

void triangle_mesh_free(struct triangle_mesh *mesh) {
  free(mesh->xyz);
  free(mesh->normals);
  free(mesh->areas);
  free(mesh->vertex_balls);
  free(mesh->corners);
  free(mesh->kinds);
  free(mesh->patches);
  free(mesh->balls);
}

/* Text gathers here before it goes to the file. */
struct mesh_writer {
  struct output_file file;
  struct text_buffer text;
  uint64_t bytes;
};

enum { BYTES_AT_ONCE = 1 << 16 };

static bool flush(struct mesh_writer *writer, size_t unless_below) {
  struct text_buffer *text = &writer->text;
  if (text->out_of_memory) return false;
  if (text->length < unless_below) return true;
  writer->bytes += text->length;
  const bool done = text->length == 0 || output_file_write(&writer->file, text->text, text->length);
  text->length = 0;
  return done;
}

/* ---- PLY and OBJ ---- */

static void ply_head(const struct triangle_mesh *mesh, struct text_buffer *out) {
  text_buffer_add(out,
                  "ply\nformat ascii 1.0\ncomment hardsphere, edge %.9g, probe %.9g\nelement vertex %" PRIu32
                  "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\n"
                  "property float nz\nproperty float area\nproperty uint atom\nelement face %" PRIu32
                  "\nproperty list uchar uint vertex_indices\nproperty uchar kind\nproperty uint patch\n"
                  "property uint atom\nend_header\n",
                  mesh->edge, mesh->probe, mesh->vertices, mesh->triangles);
}

static bool write_ply(const struct triangle_mesh *mesh, struct mesh_writer *writer) {
  struct text_buffer *out = &writer->text;
  ply_head(mesh, out);
  for (size_t v = 0; v < mesh->vertices; ++v) {
    const double *p = mesh->xyz + 3 * v;
    const double *n = mesh->normals + 3 * v;
    text_buffer_add(out, "%.9g %.9g %.9g %.6g %.6g %.6g %.6g %" PRIu32 "\n", p[0], p[1], p[2], n[0], n[1], n[2],
                    mesh->areas[v], mesh->vertex_balls[v]);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    text_buffer_add(out, "3 %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", c[0], c[1],
                    c[2], mesh->kinds[t], mesh->patches[t], mesh->balls[t]);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  return flush(writer, 0);
}

static bool write_obj(const struct triangle_mesh *mesh, struct mesh_writer *writer) {
  struct text_buffer *out = &writer->text;
  text_buffer_add(out, "# hardsphere, edge %.9g, probe %.9g\n", mesh->edge, mesh->probe);
  for (size_t v = 0; v < mesh->vertices; ++v) {
    const double *p = mesh->xyz + 3 * v;
    text_buffer_add(out, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  for (size_t v = 0; v < mesh->vertices; ++v) {
    const double *n = mesh->normals + 3 * v;
    text_buffer_add(out, "vn %.6g %.6g %.6g\n", n[0], n[1], n[2]);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    text_buffer_add(out, "f %" PRIu32 "//%" PRIu32 " %" PRIu32 "//%" PRIu32 " %" PRIu32 "//%" PRIu32 "\n", c[0] + 1,
                    c[0] + 1, c[1] + 1, c[1] + 1, c[2] + 1, c[2] + 1);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  return flush(writer, 0);
}

/* ---- STL: binary, little-endian whatever the machine ---- */

static void add_number(struct text_buffer *out, uint32_t value) {
  const char bytes[4] = {(char)(value & 255), (char)(value >> 8 & 255), (char)(value >> 16 & 255),
                         (char)(value >> 24 & 255)};
  text_buffer_append(out, bytes, sizeof bytes);
}

static void add_float(struct text_buffer *out, double value) {
  const float rounded = (float)value;
  uint32_t bits;
  memcpy(&bits, &rounded, sizeof bits);
  add_number(out, bits);
}

static void normal_of(const struct triangle_mesh *mesh, const uint32_t *corners, double normal[3]) {
  double side[2][3];
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 2; ++k) {
      side[k][axis] =
          mesh->xyz[3 * (size_t)corners[k + 1] + (size_t)axis] - mesh->xyz[3 * (size_t)corners[0] + (size_t)axis];
    }
  }
  cross(side[0], side[1], normal);
  const double length = vector_length(normal);
  for (int axis = 0; axis < 3 && length > 0.0; ++axis) normal[axis] /= length;
}

static bool write_stl(const struct triangle_mesh *mesh, struct mesh_writer *writer) {
  struct text_buffer *out = &writer->text;
  char head[80] = "hardsphere";
  text_buffer_append(out, head, sizeof head);
  add_number(out, mesh->triangles);
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    double normal[3];
    normal_of(mesh, c, normal);
    for (int axis = 0; axis < 3; ++axis) add_float(out, normal[axis]);
    for (int k = 0; k < 9; ++k) add_float(out, mesh->xyz[3 * (size_t)c[k / 3] + (size_t)(k % 3)]);
    text_buffer_append(out, "\0", 2);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  return flush(writer, 0);
}

/* ---- MSMS: numbers from 1 on; 3 is its number of a convex patch, 1 of a saddle, 2 of a concave one ---- */

static int msms_kind(uint32_t kind) {
  return kind == HSP_PATCH_CONVEX ? 3 : kind == HSP_PATCH_CONCAVE ? 2 : 1;
}

static void msms_head(const struct triangle_mesh *mesh, const char *what, uint32_t count, struct text_buffer *out) {
  const double density = 1.0 / (mesh->edge * mesh->edge);
  text_buffer_add(out, "# hardsphere\n#%s #sphere density probe_r\n%7" PRIu32 " %7" PRIu32 " %5.2f %5.2f\n", what,
                  count, mesh->atoms, density, mesh->probe);
}

static bool write_vertices(const struct triangle_mesh *mesh, struct mesh_writer *writer) {
  struct text_buffer *out = &writer->text;
  /* A vertex has the patch of its first triangle. */
  uint32_t *first = malloc(((size_t)mesh->vertices + 1) * sizeof *first);
  if (first == NULL) return false;
  for (size_t t = mesh->triangles; t-- > 0;) {
    for (int k = 0; k < 3; ++k) first[mesh->corners[3 * t + (size_t)k]] = (uint32_t)t;
  }
  msms_head(mesh, "vertex", mesh->vertices, out);
  bool done = true;
  for (size_t v = 0; v < mesh->vertices && done; ++v) {
    const double *p = mesh->xyz + 3 * v;
    const double *n = mesh->normals + 3 * v;
    text_buffer_add(out, "%9.6f %9.6f %9.6f %9.6f %9.6f %9.6f %7" PRIu32 " %7" PRIu32 " %2d\n", p[0], p[1], p[2], n[0],
                    n[1], n[2], mesh->patches[first[v]] + 1, mesh->vertex_balls[v] + 1,
                    msms_kind(mesh->kinds[first[v]]));
    done = flush(writer, BYTES_AT_ONCE);
  }
  free(first);
  return done && flush(writer, 0);
}

static bool write_faces(const struct triangle_mesh *mesh, struct mesh_writer *writer) {
  struct text_buffer *out = &writer->text;
  msms_head(mesh, "faces", mesh->triangles, out);
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    text_buffer_add(out, "%6" PRIu32 " %6" PRIu32 " %6" PRIu32 " %2d %6" PRIu32 "\n", c[0] + 1, c[1] + 1, c[2] + 1,
                    msms_kind(mesh->kinds[t]), mesh->patches[t] + 1);
    if (!flush(writer, BYTES_AT_ONCE)) return false;
  }
  return flush(writer, 0);
}

/* ---- all of them ---- */

typedef bool write_function(const struct triangle_mesh *mesh, struct mesh_writer *writer);

static bool write_one(const struct triangle_mesh *mesh, write_function *write, const char *path, uint64_t *bytes,
                      struct failure *failure) {
  struct mesh_writer writer = {.text = TEXT_BUFFER_EMPTY, .bytes = 0};
  if (!output_file_open(&writer.file, path, failure)) return false;
  const bool written = write(mesh, &writer);
  const bool no_memory = !written && writer.file.reason == 0;
  text_buffer_free(&writer.text);
  *bytes += writer.bytes;
  if (!no_memory) return output_file_finish(&writer.file, failure);
  output_file_abandon(&writer.file);
  return failure_of_memory(failure);
}

const char *mesh_file_faces_name(const char *path) {
  const size_t length = strlen(path);
  const size_t stem = length > 5 && strcmp(path + length - 5, ".vert") == 0 ? length - 5 : length;
  static char *faces;
  free(faces);
  faces = malloc(stem + 6);
  if (faces == NULL) return NULL;
  memcpy(faces, path, stem);
  memcpy(faces + stem, ".face", 6);
  return faces;
}

static bool write_msms(const struct triangle_mesh *mesh, const char *path, uint64_t *bytes, struct failure *failure) {
  const char *const faces = mesh_file_faces_name(path);
  if (faces == NULL) return failure_of_memory(failure);
  return write_one(mesh, write_faces, faces, bytes, failure) && write_one(mesh, write_vertices, path, bytes, failure);
}

bool mesh_file_write(const struct triangle_mesh *mesh, int format, const char *path, uint64_t *bytes,
                     struct failure *failure) {
  *bytes = 0;
  if (format == MESH_MSMS) return write_msms(mesh, path, bytes, failure);
  write_function *const write = format == MESH_OBJ ? write_obj : format == MESH_STL ? write_stl : write_ply;
  return write_one(mesh, write, path, bytes, failure);
}
