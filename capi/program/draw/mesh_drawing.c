#include "draw/mesh_drawing.h"

#include <stdlib.h>
#include <string.h>

#include "commands/input_report.h"
#include "commands/surface_geometry.h"
#include "draw/mesh_facing.h"
#include "draw/mesh_picture.h"
#include "draw/mesh_pockets.h"
#include "draw/view_axes.h"

#if !HSP_HAS_SPACE
#define mesh_pockets_find(...) false /* never called: the option is refused then */
#endif

/* Voids are small, and shown as a whole: they have shorter triangles than the surface that is cut. */
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

bool mesh_draw(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
               struct triangle_mesh *mesh, struct mesh_drawn *drawn, struct failure *failure) {
  const struct meshing *meshing = &request->meshing;
  struct mesh_view view = {.cut = meshing->cut};
  struct mesh_patch *patches = NULL;
  view.dark = request->meshing.dark;
  const int32_t status = viewing_axes(&request->viewing, molecule, view.axis);
  if (status != HSP_OK) return failure_in_library(failure, status);
  const bool smooth = meshing->surface == MESH_SOLVENT_EXCLUDED;
  struct mesh_pockets pockets = {.count = 0};
  if (request->meshing.pockets >= 0.0) view.pockets = &pockets;
  const bool done =
      (view.pockets == NULL || mesh_pockets_find(geometry, molecule, mesh, smooth, request->meshing.pockets,
                                                 request->meshing.persistence, &pockets, failure)) &&
      (!smooth || geometry_list_patches(geometry, &patches, failure));
  view.patches = patches;
  const bool split =
      done && mesh_facing_split(mesh, &view, molecule, view.pockets == NULL ? NULL : &pockets.of_triangle, failure);
  view.of_outside = mesh->triangles;
  const bool written =
      split && (!view.cut || add_finer_voids(request, molecule, &view, geometry, mesh, failure)) &&
      mesh_picture_write(mesh, &view, molecule, input_base_name(request->file), meshing->out, &drawn->bytes, failure);
  free(patches);
  if (view.pockets != NULL) {
    drawn->pockets = pockets.all;
    drawn->coloured = pockets.count;
  }
  free(pockets.of_triangle);
  free(pockets.of_patch);
  return written;
}
