/* hardsphere mesh: a surface as triangles. */
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "write/mesh_file.h"
#include "write/output_file.h"
#if HSP_HAS_SIGHT
#include "commands/mesh_pockets.h"
#include "draw/mesh_facing.h"
#include "draw/mesh_picture.h"
#include "draw/view_axes.h"
#endif
#include "commands/surface_geometry.h"

static double edge_of(const struct request *request) {
  const double third_of_an_atom = 0.5;
  return request->meshing.edge > 0.0 ? request->meshing.edge : third_of_an_atom;
}

static double area_of(const struct triangle_mesh *mesh) {
  double sum = 0.0;
  for (uint32_t v = 0; v < mesh->vertices; ++v) sum += mesh->areas[v];
  return sum;
}

/* The values that are printed. */
struct found {
  const struct meshing *meshing;
  uint32_t vertices, triangles;
  uint32_t pockets, coloured; /* UINT32_MAX: without --pockets */
  uint64_t bytes;
  double edge, area;
};

static void print(struct record *record, const void *of) {
  static const char *const remarks[] = {"of the balls alone", "of the balls with the probe", "that the probe leaves"};
  const struct found *const found = of;
  record_atoms(record);
  record_text(record, NULL, "surface", meshing_surface_name(found->meshing), remarks[found->meshing->surface]);
  record_number(record, NULL, "edge", found->edge, 3, "@, of a triangle, about");
  record_count(record, "vertices", "vertices", found->vertices, "");
  record_count(record, "triangles", "triangles", found->triangles, "closed: each edge in two of them");
  record_number(record, "edge", NULL, found->edge, 0, "");
  record_number(record, "triangle_area", "area", found->area, 3, "@^2, of the triangles; measure has the surface's");
  if (found->pockets != UINT32_MAX) {
    record_count(record, "pockets", "pockets", found->pockets, "where the probe fits that --pockets keeps out");
    record_count(record, "coloured", "coloured_pockets", found->coloured,
                 "of these, the widest ones that --least leaves");
  }
  record_count(record, "bytes", "bytes", (int64_t)found->bytes, "");
}

/* The triangles of MSMS have a file of their own. */
static bool check_second_file(const struct request *request, struct failure *failure) {
  if (request->meshing.format != MESH_MSMS) return true;
  const char *const faces = mesh_file_faces_name(request->meshing.out);
  if (faces == NULL) return failure_of_memory(failure);
  return !request_reads(request, faces) || failure_in_usage(failure, "-o would write over the file that is read");
}

#if HSP_HAS_SIGHT
/* Voids are small, and shown whole: of shorter triangles than what is cut. */
static const double edge_of_voids = 0.6;

static bool add_finer_voids(const struct request *request, const struct molecule *molecule,
                            const struct mesh_view *view, struct geometry *geometry, struct triangle_mesh *mesh,
                            struct failure *failure) {
  struct triangle_mesh finer;
  memset(&finer, 0, sizeof finer);
  const bool smooth = request->meshing.surface == MESH_SOLVENT_EXCLUDED;
  const bool done = geometry_compute_mesh(geometry, smooth, edge_of_voids * mesh->edge, failure) &&
                    triangle_mesh_read(geometry->work.mesh, &finer, failure) &&
                    mesh_facing_split(&finer, view, molecule, NULL, failure) &&
                    triangle_mesh_append(mesh, &finer, failure);
  triangle_mesh_free(&finer);
  return done;
}

static bool find_pockets(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                         struct triangle_mesh *mesh, struct mesh_pockets *pockets, struct failure *failure) {
#if !HSP_HAS_SPACE
  (void)request;
  (void)molecule;
  (void)geometry;
  (void)mesh;
  (void)pockets;
  return failure_in_usage(failure, "--pockets needs the component space, which this build leaves out");
#else
  const bool smooth = request->meshing.surface == MESH_SOLVENT_EXCLUDED;
  return mesh_pockets_find(geometry, molecule, mesh, smooth, request->pockets, request->persistence, pockets, failure);
#endif
}

static bool write_picture(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                          struct triangle_mesh *mesh, struct found *found, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
  struct mesh_view view = {.cut = meshing->cut};
  struct mesh_patch *patches = NULL;
  view.dark = request->dark;
  const int32_t status = viewing_axes(&request->viewing, molecule, view.axis);
  if (status != HSP_OK) return failure_in_library(failure, status);
  const bool smooth = meshing->surface == MESH_SOLVENT_EXCLUDED;
  struct mesh_pockets pockets = {.count = 0};
  if (request->pockets >= 0.0) view.pockets = &pockets;
  const bool done = (view.pockets == NULL || find_pockets(request, molecule, geometry, mesh, &pockets, failure)) &&
                    (!smooth || geometry_list_patches(geometry, &patches, failure));
  view.patches = patches;
  const bool split =
      done && mesh_facing_split(mesh, &view, molecule, view.pockets == NULL ? NULL : &pockets.of_triangle, failure);
  view.of_outside = mesh->triangles;
  const bool written =
      split && (!view.cut || add_finer_voids(request, molecule, &view, geometry, mesh, failure)) &&
      mesh_picture_write(mesh, &view, molecule, input_base_name(request->file), meshing->out, &found->bytes, failure);
  free(patches);
  if (view.pockets != NULL) {
    found->pockets = pockets.all;
    found->coloured = pockets.count;
  }
  free(pockets.of_triangle);
  free(pockets.of_patch);
  return written;
}
#endif

static bool write_file(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                       struct triangle_mesh *mesh, struct found *found, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
#ifdef HSP_WITHOUT_SIGHT
  (void)molecule;
  (void)geometry;
#else
  if (meshing->format == MESH_SVG) return write_picture(request, molecule, geometry, mesh, found, failure);
#endif
  return mesh_file_write(mesh, meshing->format, meshing->out, &found->bytes, failure);
}

bool command_mesh(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
  struct triangle_mesh mesh;
  struct found found = {meshing, 0, 0, UINT32_MAX, UINT32_MAX, 0, 0.0, 0.0};
  memset(&mesh, 0, sizeof mesh);
  mesh.atoms = molecule->atoms;
  mesh.edge = edge_of(request);
  mesh.probe = request->probe;
  const bool smooth = meshing->surface == MESH_SOLVENT_EXCLUDED;
  bool done = check_second_file(request, failure) && geometry_compute_boundary(geometry, failure) &&
              (!smooth || geometry_compute_surface(geometry, failure)) &&
              geometry_compute_mesh(geometry, smooth, mesh.edge, failure) &&
              triangle_mesh_read(geometry->work.mesh, &mesh, failure);
  if (done) progress_show(&geometry->progress, "writing");
  found.vertices = mesh.vertices;
  found.triangles = mesh.triangles;
  found.edge = mesh.edge;
  found.area = done ? area_of(&mesh) : 0.0;
  done = done && write_file(request, molecule, geometry, &mesh, &found, failure);
  if (done && !output_is_standard(meshing->out)) report(request, molecule, print, &found, out);
  triangle_mesh_free(&mesh);
  return done;
}

bool check_mesh(struct request *request, struct failure *failure) {
  const bool viewed = viewing_is_given(&request->viewing);
  if (!meshing_check(&request->meshing, request->probe, viewed, failure)) return false;
#ifdef HSP_WITHOUT_SIGHT
  if (request->meshing.format == MESH_SVG) {
    return failure_in_usage(failure, "mesh -o OUT.svg needs the component sight, which this build leaves out");
  }
#endif
  request->excluded_surface = request->meshing.surface == MESH_SOLVENT_EXCLUDED;
  if (request->pockets < 0.0 && request->persistence > 0.0) {
    return failure_in_usage(failure, "--least needs --pockets");
  }
  if (request->dark && request->meshing.format != MESH_SVG) {
    return failure_in_usage(failure, "--dark is for a picture, -o OUT.svg");
  }
  if (request->pockets < 0.0) return true;
  if (request->meshing.format != MESH_SVG) return failure_in_usage(failure, "--pockets is for a picture, -o OUT.svg");
  if (request->pockets >= request->probe) return true;
  return failure_in_usage(failure, "--pockets: W must not be less than --probe");
}
