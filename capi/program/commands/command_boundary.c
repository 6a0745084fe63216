/* hardsphere boundary: what the boundary of the union consists of. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"
#include "write/csv.h"
#include "write/report.h"

/* The pieces of spheres are counted as the boundary has them; what hangs together is the topology's matter. */
struct counted {
  hsp_boundary_counts boundary;
  hsp_topology_counts topology;
  hsp_shell *shells;
  uint32_t shell_count;
};

static int64_t euler_of(const struct counted *counted) {
  return (int64_t)counted->topology.vertices - (int64_t)counted->topology.edges +
         (int64_t)counted->topology.simple_faces;
}

static uint32_t voids_of(const struct counted *counted) {
  return counted->topology.cells - 1;
}

static const char *kind_of(const hsp_shell *shell) {
  return shell->kind == HSP_SHELL_VOID ? "void" : "outer";
}

static void json_shells(const struct counted *counted, struct text_buffer *out) {
  text_buffer_add(out, ", \"shell_list\": [");
  for (uint32_t i = 0; i < counted->shell_count; ++i) {
    const hsp_shell *shell = &counted->shells[i];
    text_buffer_add(out, "%s{\"kind\": \"%s\", \"component\": %" PRIu32 ", \"cell\": %" PRIu32 ", \"faces\": %" PRIu32,
                    i == 0 ? "" : ", ", kind_of(shell), shell->component, shell->cell, shell->faces);
    text_buffer_add(out, ", \"euler\": %" PRId32 ", \"genus\": %" PRIu32 ", \"area\": ", shell->euler, shell->genus);
    json_number(out, shell->area);
    text_buffer_add(out, ", \"volume\": ");
    json_number(out, shell->volume);
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "]");
}

static void print_json(const struct request *request, const struct molecule *molecule, const struct counted *counted,
                       struct text_buffer *out) {
  const hsp_boundary_counts *counts = &counted->boundary;
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"vertices\": %" PRIu32 ", \"arcs\": %" PRIu32 ", \"circles\": %" PRIu32,
                  counts->balls, counts->vertices, counts->arcs, counts->circles);
  text_buffer_add(out, ", \"faces\": %" PRIu32 ", \"exposed_balls\": %" PRIu32 ", \"shells\": %" PRIu32, counts->faces,
                  counts->exposed_balls, counted->topology.shells);
  text_buffer_add(out, ", \"components\": %" PRIu32 ", \"voids\": %" PRIu32 ", \"euler\": %" PRId64,
                  counted->topology.components, voids_of(counted), euler_of(counted));
  if (request->shells) json_shells(counted, out);
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

/* A row of all counts, or one for each shell. */
static void print_csv(const struct request *request, const struct counted *counted, struct text_buffer *out) {
  const hsp_boundary_counts *counts = &counted->boundary;
  if (!request->shells) {
    text_buffer_add(out, "balls,vertices,arcs,circles,faces,exposed_balls,shells,components,voids,euler\n");
    const uint32_t numbers[] = {counts->balls,
                                counts->vertices,
                                counts->arcs,
                                counts->circles,
                                counts->faces,
                                counts->exposed_balls,
                                counted->topology.shells,
                                counted->topology.components,
                                voids_of(counted)};
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k) text_buffer_add(out, "%" PRIu32 ",", numbers[k]);
    text_buffer_add(out, "%" PRId64 "\n", euler_of(counted));
    return;
  }
  text_buffer_add(out, "shell,kind,component,cell,faces,euler,genus,area,volume\n");
  for (uint32_t i = 0; i < counted->shell_count; ++i) {
    const hsp_shell *shell = &counted->shells[i];
    text_buffer_add(out, "%" PRIu32 ",%s,%" PRIu32 ",%" PRIu32 ",%" PRIu32 ",%" PRId32 ",%" PRIu32 ",", i,
                    kind_of(shell), shell->component, shell->cell, shell->faces, shell->euler, shell->genus);
    csv_number(out, shell->area);
    text_buffer_add(out, ",");
    csv_number(out, shell->volume);
    text_buffer_add(out, "\n");
  }
}

static void print_shells(const struct molecule *molecule, const struct counted *counted, struct text_buffer *out) {
  char value[NUMBER_BYTES];
  const char *unit = molecule->format->unit;
  char titles[2][32];
  snprintf(titles[0], sizeof titles[0], "area, %s^2", unit);
  snprintf(titles[1], sizeof titles[1], "encloses, %s^3", unit);
  text_buffer_add(out, "\n  %9s  %-5s  %9s  %9s  %9s  %20s  %20s\n", "shell", "kind", "component", "faces", "genus",
                  titles[0], titles[1]);
  for (uint32_t i = 0; i < counted->shell_count; ++i) {
    const hsp_shell *shell = &counted->shells[i];
    text_buffer_add(out, "  %9" PRIu32 "  %-5s  %9" PRIu32, i, kind_of(shell), shell->component);
    text_buffer_add(out, "  %9s", count_text(value, shell->faces));
    text_buffer_add(out, "  %9s", count_text(value, shell->genus));
    text_buffer_add(out, "  %20s", column_text(value, molecule->format, shell->area, 4));
    text_buffer_add(out, "  %20s\n", column_text(value, molecule->format, shell->volume, 4));
  }
}

static void print_table(const struct request *request, const struct molecule *molecule, const struct counted *counted,
                        struct text_buffer *out) {
  const hsp_boundary_counts *counts = &counted->boundary;
  report_heading(out, request, molecule);
  report_row_count(out, "vertices", counts->vertices, "points on three spheres, outside all other balls");
  report_row_count(out, "arcs", counts->arcs, "pieces of circles between two vertices");
  report_row_count(out, "circles", counts->circles, "whole circles of two spheres");
  report_row_count(out, "faces", counts->faces, "pieces of spheres");
  report_row_count(out, "exposed balls", counts->exposed_balls, "balls with a face");
  report_row_count(out, "buried balls", (int64_t)counts->balls - (int64_t)counts->exposed_balls,
                   "balls without a face");
  report_row_count(out, "components", counted->topology.components, "connected pieces of the union");
  report_row_count(out, "voids", voids_of(counted), "cavities enclosed by the union");
  report_row_count(out, "shells", counted->topology.shells, "connected pieces of the boundary: components + voids");
  report_row_count(out, "euler", euler_of(counted), "Euler characteristic, summed over the shells");
  if (counts->tied_vertices > 0) {
    report_row_count(out, "tied vertices", counts->tied_vertices,
                     "vertices with a fourth sphere or a tangency, decided by symbolic perturbation");
  }
  const bool list_them = counted->shell_count > 1 || (request->shells && counted->shell_count > 0);
  if (list_them) print_shells(molecule, counted, out);
}

/* What is counted in a periodic box, where nothing is outside. */
static void print_box(const struct request *request, const struct molecule *molecule,
                      const struct periodic_result *result, struct text_buffer *out) {
  const hsp_periodic_counts *counts = &result->counts;
  if (request->json) {
    text_buffer_add(out, "{\"n\": %" PRIu32 ", \"vertices\": %" PRIu32 ", \"arcs\": %" PRIu32 ", \"circles\": %" PRIu32,
                    counts->balls, counts->vertices, counts->arcs, counts->circles);
    text_buffer_add(out, ", \"faces\": %" PRIu32 ", \"shells\": %" PRIu32 ", \"components\": %" PRIu32, counts->faces,
                    counts->shells, counts->components);
    text_buffer_add(out, ", \"euler\": %" PRId32, counts->euler);
    periodic_result_json(result, out);
    input_report_json(out, request, molecule);
    text_buffer_add(out, "}\n");
    return;
  }
  report_heading(out, request, molecule);
  report_row_count(out, "vertices", counts->vertices, "points on three spheres, outside all other balls");
  report_row_count(out, "arcs", counts->arcs, "pieces of circles between two vertices");
  report_row_count(out, "circles", counts->circles, "whole circles of two spheres");
  report_row_count(out, "faces", counts->faces, "pieces of spheres");
  report_row_count(out, "shells", counts->shells, "connected pieces of the boundary");
  report_row_count(out, "euler", counts->euler, "Euler characteristic, summed over the shells");
  periodic_result_rows(result, molecule->format->unit, out);
}

static bool count_in_box(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                         struct text_buffer *out, struct failure *failure) {
  struct periodic_result result;
  const bool done = periodic_result_make(request, molecule, geometry, &result, failure);
  if (done) print_box(request, molecule, &result, out);
  periodic_result_free(&result);
  return done;
}

bool command_boundary(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  if (request->box.source != BOX_NONE) return count_in_box(request, molecule, geometry, out, failure);
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct counted counted;
  int32_t status = hsp_boundary_get_counts(geometry->work.boundary, &counted.boundary);
  if (status == HSP_OK) status = hsp_topology_get_counts(geometry->work.topology, &counted.topology);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (!geometry_list_shells(geometry, &counted.shells, &counted.shell_count, failure)) return false;
  if (request->json) {
    print_json(request, molecule, &counted, out);
  } else if (request->csv) {
    print_csv(request, &counted, out);
  } else {
    print_table(request, molecule, &counted, out);
  }
  free(counted.shells);
  return true;
}
