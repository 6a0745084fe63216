/* hardsphere map: what is seen from a direction, as faces, edges and vertices of the view plane. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/view_geometry.h"
#include "write/report.h"
#include "write/table.h"

/* What is seen. */
struct seen {
  hsp_map_info map;
  double *area; /* of each ball; to be freed */
};

static bool read_map(const hsp_map *map, uint32_t balls, struct seen *seen, struct failure *failure) {
  uint32_t needed = 0;
  seen->area = calloc((size_t)balls + 1, sizeof *seen->area);
  if (seen->area == NULL) return failure_of_memory(failure);
  int32_t status = hsp_map_get_info(map, &seen->map);
  if (status == HSP_OK) status = hsp_map_get_areas(map, seen->area, balls, &needed);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* What the table of balls is about. */
struct listed {
  const struct molecule *molecule;
  const struct seen *seen;
  struct ball_columns columns;
};

static void lead_ball(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct listed *listed = of;
  if (form == AS_JSON) text_buffer_add(out, "\"ball\": %" PRIu32, (uint32_t)row);
  if (form == FOR_PERSONS && row == TABLE_TITLES) report_ball_titles(out, listed->columns);
  if (form == FOR_PERSONS && row != TABLE_TITLES) report_ball(out, listed->columns, listed->molecule, (uint32_t)row);
}

static bool ball_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  (void)text;
  cells[0].quantity = ((const struct listed *)of)->seen->area[row];
  return cells[0].quantity != 0.0;
}

static void print(const struct request *request, const struct molecule *molecule, const struct seen *seen,
                  struct text_buffer *out) {
  static const struct column columns[] = {{"visible_area", NULL, "visible area", 16, COLUMN_QUANTITY, 4}};
  const hsp_map_info *map = &seen->map;
  const bool moved = map->perturbation > 0.0;
  const struct result results[] = {
      {"vertices", "vertices", map->vertices, 0, "where edges end"},
      {"edges", "edges", map->edges, 0, "silhouettes, and creases where two balls meet"},
      {"faces", "faces", map->faces, 0, "the background counts"},
      {"visible_balls", "visible balls", map->balls, 0, "of which something is seen"},
      {"visible_area", "visible area", map->area, 6, "@^2, of the view plane"},
      {"moved", moved ? "moved" : NULL, map->perturbation, 9, "@ at most: of balls seen one behind the other"},
  };
  const size_t count = sizeof results / sizeof results[0];
  const struct listed listed = {molecule, seen, ball_columns_of(molecule)};
  const struct table balls = {columns, 1, molecule->format, molecule->atoms, &listed, ball_row, lead_ball};
  if (request->json) {
    text_buffer_add(out, "{\"n\": %" PRIu32, molecule->atoms);
    results_json(results, count, out);
    text_buffer_add(out, ", \"balls\": ");
    table_json(&balls, out);
    input_report_json(out, request, molecule);
    text_buffer_add(out, "}\n");
    return;
  }
  input_report_results(out, request, molecule, results, count);
  if (!request->per_ball) return;
  text_buffer_add(out, "\n");
  table_print(&balls, out);
}

bool command_map(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                 struct text_buffer *out, struct failure *failure) {
  struct seen seen;
  memset(&seen, 0, sizeof seen);
  const bool done = geometry_compute_map(geometry, &request->viewing, molecule, failure) &&
                    read_map(geometry->work.map, molecule->atoms, &seen, failure);
  if (done) print(request, molecule, &seen, out);
  free(seen.area);
  return done;
}
