/* hardsphere mesh: a surface as triangles. */
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/pictures.h"
#include "commands/surface_geometry.h"
#include "write/mesh_file.h"
#include "write/output_file.h"

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
  struct mesh_drawn drawn; /* of other files the bytes */
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
  if (found->drawn.pockets != UINT32_MAX) {
    record_count(record, "pockets", "pockets", found->drawn.pockets, "where the probe fits that --pockets keeps out");
    record_count(record, "coloured", "coloured", found->drawn.coloured,
                 "of these, the widest ones that --least leaves");
  }
  record_count(record, "bytes", "bytes", (int64_t)found->drawn.bytes, "");
}

/* The triangles of MSMS have a file of their own. */
static bool check_second_file(const struct request *request, struct failure *failure) {
  if (request->meshing.format != MESH_MSMS) return true;
  const char *const faces = mesh_file_faces_name(request->meshing.out);
  if (faces == NULL) return failure_of_memory(failure);
  return !request_reads(request, faces) || failure_in_usage(failure, "-o would write over the file that is read");
}

static bool write_file(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                       struct triangle_mesh *mesh, struct found *found, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
  if (meshing->format == MESH_SVG) return pictures.mesh(request, molecule, geometry, mesh, &found->drawn, failure);
  return mesh_file_write(mesh, meshing->format, meshing->out, &found->drawn.bytes, failure);
}

void describe_mesh(const struct request *request, struct record *record) {
  const uint32_t pockets = request->meshing.pockets >= 0.0 ? 0 : UINT32_MAX;
  struct meshing any = request->meshing;
  any.surface = MESH_VAN_DER_WAALS; /* it is not said which */
  struct found none = {.meshing = &any, .drawn = {0, pockets, pockets}};
  print(record, &none);
}

bool command_mesh(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
  struct triangle_mesh mesh;
  struct found found = {meshing, 0, 0, {0, UINT32_MAX, UINT32_MAX}, 0.0, 0.0};
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
  if (request->meshing.format == MESH_SVG && pictures.mesh == NULL) {
    return failure_in_usage(failure, "mesh -o OUT.svg needs the part that draws, which this build leaves out");
  }
  request->excluded_surface = request->meshing.surface == MESH_SOLVENT_EXCLUDED;
  const struct meshing *const meshing = &request->meshing;
  const bool pockets = meshing->pockets >= 0.0, picture = meshing->format == MESH_SVG;
  const struct usage_rule rules[] = {
      {!pockets && meshing->persistence > 0.0, "--least needs --pockets"},
      {meshing->dark && !picture, "--dark is for a picture, -o OUT.svg"},
      {pockets && !picture, "--pockets is for a picture, -o OUT.svg"},
      {pockets && meshing->pockets < request->probe, "--pockets: W must not be less than --probe"},
  };
  return usage_rules_hold(rules, sizeof rules / sizeof rules[0], failure);
}
