/* hardsphere boundary: what the boundary of the union consists of. */
#include <inttypes.h>

#include "commands.h"
#include "report.h"

static void print_json(const hsp_boundary_counts *counts, struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"vertices\": %" PRIu32 ", \"arcs\": %" PRIu32 ", \"circles\": %" PRIu32,
                  counts->balls, counts->vertices, counts->arcs, counts->circles);
  text_buffer_add(out, ", \"faces\": %" PRIu32 ", \"exposed_balls\": %" PRIu32 ", \"shells\": %" PRIu32, counts->faces,
                  counts->exposed_balls, counts->shells);
  text_buffer_add(out, ", \"components\": %" PRIu32 ", \"voids\": %" PRIu32 ", \"euler\": %" PRId64 "}\n",
                  counts->components, counts->voids, counts->euler);
}

static void print_table(const struct request *request, const struct molecule *molecule,
                        const hsp_boundary_counts *counts, struct text_buffer *out) {
  report_heading(out, request, molecule);
  report_row_count(out, "vertices", counts->vertices, "points on three spheres, outside all other balls");
  report_row_count(out, "arcs", counts->arcs, "pieces of circles between two vertices");
  report_row_count(out, "circles", counts->circles, "whole circles of two spheres");
  report_row_count(out, "faces", counts->faces, "pieces of spheres");
  report_row_count(out, "exposed balls", counts->exposed_balls, "balls with a face");
  report_row_count(out, "buried balls", (int64_t)counts->balls - (int64_t)counts->exposed_balls,
                   "balls without a face");
  report_row_count(out, "components", counts->components, "connected pieces of the union");
  report_row_count(out, "voids", counts->voids, "cavities enclosed by the union");
  report_row_count(out, "shells", counts->shells, "connected pieces of the boundary: components + voids");
  report_row_count(out, "euler", counts->euler, "Euler characteristic, summed over the shells");
  if (counts->tied_vertices > 0) {
    report_row_count(out, "tied vertices", counts->tied_vertices,
                     "vertices with a fourth sphere or a tangency, decided by the tie rule");
  }
}

bool command_boundary(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_boundary(geometry, molecule, failure)) return false;
  hsp_boundary_counts counts;
  const int32_t status = hsp_boundary_get_counts(geometry->boundary, &counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(&counts, out);
  } else {
    print_table(request, molecule, &counts, out);
  }
  return true;
}
