/* hardsphere boundary: the parts of the union's boundary. */
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"

struct counted {
  const struct periodic_result *box; /* or NULL; then there are counts as far as any are: nothing is outside */
  bool listed;                       /* shells */
  hsp_boundary_counts boundary;
  hsp_shell *shells;
  uint32_t shell_count;
};

static bool shell_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct counted *counted = of;
  const hsp_shell *shell = &counted->shells[row];
  (void)text;
  cells[0].count = (int64_t)row;
  cells[1].text = shell->kind == HSP_SHELL_VOID ? "void" : "outer";
  cells[2].count = shell->component;
  cells[3].count = shell->region;
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

static void print(struct record *record, const void *of) {
  const struct counted *const counted = of;
  const hsp_boundary_counts *counts = &counted->boundary;
  const struct table shells = table_of_shells(record->molecule, counted);
  const struct periodic_result *const box = counted->box;
  record_count(record, record->atoms, NULL, counts->balls, "");
  record_count(record, "vertices", "vertices", counts->vertices, "points on three spheres, outside all other balls");
  record_count(record, "arcs", "arcs", counts->arcs, "pieces of circles between two vertices");
  record_count(record, "circles", "circles", counts->circles, "whole circles of two spheres");
  record_count(record, "faces", "faces", counts->faces, "pieces of spheres");
  if (box == NULL) {
    record_count(record, "exposed_balls", "exposed balls", counts->exposed_balls, "balls with a face");
    record_count(record, NULL, "buried balls", counts->balls - counts->exposed_balls, "balls without a face");
  }
  record_count(record, "shells", box != NULL ? "shells" : NULL, counts->shells, "connected pieces of the boundary");
  record_count(record, "components", box != NULL ? NULL : "components", counts->components,
               "connected pieces of the union");
  if (box == NULL) {
    record_count(record, "voids", "voids", counts->voids, "cavities enclosed by the union");
    record_count(record, NULL, "shells", counts->shells, "connected pieces of the boundary: components + voids");
  }
  record_count(record, "euler", "euler", counts->euler, "Euler characteristic, summed over the shells");
  if (box == NULL && counts->tied_vertices > 0) {
    record_count(record, NULL, "tied vertices", counts->tied_vertices,
                 "vertices with a fourth sphere or a tangency, decided by symbolic perturbation");
  }
  if (record->form == AS_JSON && counted->listed) record_table(record, "shell_list", &shells);
  if (box != NULL) periodic_result_record(record, box);
  if (record->form == FOR_PERSONS && counted->shell_count > (counted->listed ? 0 : 1)) {
    record_table(record, NULL, &shells);
  }
}

static void print_all(const struct request *request, const struct molecule *molecule, const struct counted *counted,
                      struct text_buffer *out) {
  const struct table shells = table_of_shells(molecule, counted);
  if (request->csv && request->boundary.shells) {
    table_csv(&shells, out);
  } else {
    report(request, molecule, print, counted, out);
  }
}

static bool count_in_box(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                         struct text_buffer *out, struct failure *failure) {
  struct periodic_result result;
  const bool done = periodic_result_make(request, molecule, NULL, geometry, &result, failure);
  const hsp_periodic_counts *counts = &result.counts;
  struct counted counted = {.box = &result, .listed = request->boundary.shells};
  counted.boundary.balls = counts->balls;
  counted.boundary.vertices = counts->vertices;
  counted.boundary.arcs = counts->arcs;
  counted.boundary.circles = counts->circles;
  counted.boundary.faces = counts->faces;
  counted.boundary.shells = counts->shells;
  counted.boundary.components = counts->components;
  counted.boundary.euler = counts->euler;
  if (done) print_all(request, molecule, &counted, out);
  periodic_result_free(&result);
  return done;
}

void describe_boundary(const struct request *request, struct record *record) {
  static const struct symmetry symmetry;
  static const struct periodic_result box = {.symmetry = &symmetry};
  const struct counted none = {.listed = request->boundary.shells,
                               .box = request->box.source != BOX_NONE ? &box : NULL};
  print(record, &none);
}

bool command_boundary(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  if (request->box.source != BOX_NONE) return count_in_box(request, molecule, geometry, out, failure);
  if (!geometry_compute_boundary(geometry, failure)) return false;
  struct counted counted = {.listed = request->boundary.shells};
  const int32_t status = hsp_boundary_get_counts(geometry->work.boundary, &counted.boundary);
  if (status != HSP_OK) return failure_in_library(failure, status);
  /* Only the list needs the topology: what hangs together is counted without. */
  const bool lists = counted.listed || (!request->json && !request->csv && counted.boundary.shells > 1);
  if (lists && !(geometry_topology_of_boundary(geometry, failure) &&
                 geometry_list_shells(geometry, &counted.shells, &counted.shell_count, failure))) {
    return false;
  }
  print_all(request, molecule, &counted, out);
  free(counted.shells);
  return true;
}
