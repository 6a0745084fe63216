/* hardsphere boundary: what the boundary of the union consists of. */
#include <inttypes.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"
#include "write/table.h"

/* The pieces of spheres are counted as the boundary has them; what hangs together is the topology's matter. */
struct counted {
  hsp_boundary_counts boundary;
  hsp_topology_counts topology;
  int64_t euler;
  hsp_shell *shells;
  uint32_t shell_count;
};

static uint32_t voids_of(const struct counted *counted) {
  return counted->topology.cells - 1;
}

/* The counts, of the boundary in a box as far as there are any: nothing is outside there. */
enum { MOST_COUNTS = 16 };
static size_t list_counts(const struct counted *counted, bool in_box, struct result list[MOST_COUNTS]) {
  const hsp_boundary_counts *counts = &counted->boundary;
  const hsp_topology_counts *topology = &counted->topology;
  size_t count = 0;
  list[count++] =
      (struct result){"vertices", "vertices", counts->vertices, 0, "points on three spheres, outside all other balls"};
  list[count++] = (struct result){"arcs", "arcs", counts->arcs, 0, "pieces of circles between two vertices"};
  list[count++] = (struct result){"circles", "circles", counts->circles, 0, "whole circles of two spheres"};
  list[count++] = (struct result){"faces", "faces", counts->faces, 0, "pieces of spheres"};
  if (!in_box) {
    const double buried = (double)counts->balls - counts->exposed_balls;
    list[count++] = (struct result){"exposed_balls", "exposed balls", counts->exposed_balls, 0, "balls with a face"};
    list[count++] = (struct result){NULL, "buried balls", buried, 0, "balls without a face"};
  }
  list[count++] =
      (struct result){"shells", in_box ? "shells" : NULL, topology->shells, 0, "connected pieces of the boundary"};
  list[count++] = (struct result){"components", in_box ? NULL : "components", topology->components, 0,
                                  "connected pieces of the union"};
  if (!in_box) {
    list[count++] = (struct result){"voids", "voids", voids_of(counted), 0, "cavities enclosed by the union"};
    list[count++] =
        (struct result){NULL, "shells", topology->shells, 0, "connected pieces of the boundary: components + voids"};
  }
  list[count++] =
      (struct result){"euler", "euler", (double)counted->euler, 0, "Euler characteristic, summed over the shells"};
  if (!in_box && counts->tied_vertices > 0) {
    list[count++] = (struct result){NULL, "tied vertices", counts->tied_vertices, 0,
                                    "vertices with a fourth sphere or a tangency, decided by symbolic perturbation"};
  }
  return count;
}

static bool shell_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct counted *counted = of;
  const hsp_shell *shell = &counted->shells[row];
  (void)text;
  cells[0].count = (int64_t)row;
  cells[1].text = shell->kind == HSP_SHELL_VOID ? "void" : "outer";
  cells[2].count = shell->component;
  cells[3].count = shell->cell;
  cells[4].count = shell->faces;
  cells[5].count = shell->euler;
  cells[6].count = shell->genus;
  cells[7].quantity = shell->area;
  cells[8].quantity = shell->volume;
  return true;
}

static struct table table_of_shells(const struct molecule *molecule, const struct counted *counted) {
  static const struct column columns[] = {
      {NULL, "shell", "shell", 9, COLUMN_COUNT, 0},
      {"kind", NULL, "kind", -5, COLUMN_TEXT, 0},
      {"component", NULL, "component", 9, COLUMN_COUNT, 0},
      {"cell", NULL, NULL, 0, COLUMN_COUNT, 0},
      {"faces", NULL, "faces", 9, COLUMN_COUNT, 0},
      {"euler", NULL, NULL, 0, COLUMN_COUNT, 0},
      {"genus", NULL, "genus", 9, COLUMN_COUNT, 0},
      {"area", NULL, "area, @^2", 20, COLUMN_QUANTITY, 4},
      {"volume", NULL, "encloses, @^3", 20, COLUMN_QUANTITY, 4},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, counted->shell_count, counted, shell_row, NULL};
}

static void print(const struct request *request, const struct molecule *molecule, const struct counted *counted,
                  const struct periodic_result *box, struct text_buffer *out) {
  struct result counts[MOST_COUNTS];
  const size_t count = list_counts(counted, box != NULL, counts);
  const struct table shells = table_of_shells(molecule, counted);
  if (request->json) {
    text_buffer_add(out, "{\"n\": %" PRIu32, counted->boundary.balls);
    results_json(counts, count, out);
    if (request->shells) {
      text_buffer_add(out, ", \"shell_list\": ");
      table_json(&shells, out);
    }
    if (box != NULL) periodic_result_json(box, out);
    input_report_json(out, request, molecule);
    text_buffer_add(out, "}\n");
  } else if (request->csv && request->shells) {
    table_csv(&shells, out);
  } else if (request->csv) {
    text_buffer_add(out, "balls,");
    results_csv_titles(counts, count, out);
    text_buffer_add(out, "\n%" PRIu32 ",", counted->boundary.balls);
    results_csv(counts, count, out);
    text_buffer_add(out, "\n");
  } else {
    report_heading(out, request, molecule);
    results_print(counts, count, RESULT_WIDTH, "", out);
    if (box != NULL) periodic_result_rows(box, molecule->format->unit, out);
    if (counted->shell_count > 1 || (request->shells && counted->shell_count > 0)) {
      text_buffer_add(out, "\n");
      table_print(&shells, out);
    }
  }
}

static bool count_in_box(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                         struct text_buffer *out, struct failure *failure) {
  struct periodic_result result;
  const bool done = periodic_result_make(request, molecule, geometry, &result, failure);
  const hsp_periodic_counts *counts = &result.counts;
  struct counted counted = {.euler = counts->euler};
  counted.boundary.balls = counts->balls;
  counted.boundary.vertices = counts->vertices;
  counted.boundary.arcs = counts->arcs;
  counted.boundary.circles = counts->circles;
  counted.boundary.faces = counts->faces;
  counted.topology.shells = counts->shells;
  counted.topology.components = counts->components;
  if (done) print(request, molecule, &counted, &result, out);
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
  const hsp_topology_counts *topology = &counted.topology;
  counted.euler = (int64_t)topology->vertices - (int64_t)topology->edges + (int64_t)topology->simple_faces;
  print(request, molecule, &counted, NULL, out);
  free(counted.shells);
  return true;
}
