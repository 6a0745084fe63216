/* Triangles in a file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"

/* The format of a file; MESH_SVG is written by mesh_picture.h. */
enum mesh_format { MESH_PLY, MESH_OBJ, MESH_STL, MESH_MSMS, MESH_SVG };

/* A mesh in arrays of the program. */
struct triangle_mesh {
  uint32_t vertices, triangles;
  double *xyz, *normals;  /* [vertices][3] */
  double *areas;          /* [vertices] */
  uint32_t *vertex_balls; /* [vertices] */
  uint32_t *corners;      /* [triangles][3] */
  uint32_t *kinds;        /* [triangles] HSP_PATCH_* */
  uint32_t *patches;      /* [triangles] */
  uint32_t *balls;        /* [triangles] */
  uint32_t atoms;         /* of the whole molecule */
  double edge, probe;
};

/* The probe and the balls that a patch of a smooth surface belongs to. */
struct mesh_patch {
  double probe[3];  /* the centre of a concave patch's probe */
  uint32_t ball[3]; /* UINT32_MAX: no further ball */
};

struct hsp_mesh;

/* Make arrays for that many, all 0. Free the mesh on true and on false. */
bool triangle_mesh_make(struct triangle_mesh *mesh, uint32_t vertices, uint32_t triangles, struct failure *failure);

/* Copy all data of a computed mesh. Free `into` on true and on false. */
bool triangle_mesh_read(const struct hsp_mesh *mesh, struct triangle_mesh *into, struct failure *failure);
void triangle_mesh_free(struct triangle_mesh *mesh);

/* Append the triangles of another mesh of the same surface, with vertices of their own. */
bool triangle_mesh_append(struct triangle_mesh *mesh, const struct triangle_mesh *more, struct failure *failure);

/* The file in which MSMS has the triangles: name.face for name.vert. The name stays valid until the next call, so that
 * a failure can tell it. NULL: memory is short. */
const char *mesh_file_faces_name(const char *path);

/* Write the mesh to the file `path` (output_file.h); for MSMS the triangles go to the file beside it whose name ends
 * with .face. *bytes becomes the number of bytes written. False, with the file named, if it cannot be written in
 * full. */
bool mesh_file_write(const struct triangle_mesh *mesh, int format, const char *path, uint64_t *bytes,
                     struct failure *failure);
