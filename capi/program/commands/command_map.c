/* hardsphere map: what is seen from a direction, as faces, edges and vertices of the view plane. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/view_geometry.h"
#include "write/report.h"

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

static void print_json(const struct request *request, const struct molecule *molecule, const struct seen *seen,
                       struct text_buffer *out) {
  const hsp_map_info *map = &seen->map;
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"vertices\": %" PRIu32 ", \"edges\": %" PRIu32 ", \"faces\": %" PRIu32,
                  molecule->atoms, map->vertices, map->edges, map->faces);
  text_buffer_add(out, ", \"visible_balls\": %" PRIu32 ", \"visible_area\": ", map->balls);
  json_number(out, map->area);
  text_buffer_add(out, ", \"moved\": ");
  json_number(out, map->perturbation);
  text_buffer_add(out, ", \"balls\": [");
  const char *separator = "";
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (seen->area[i] == 0.0) continue;
    text_buffer_add(out, "%s{\"ball\": %" PRIu32 ", \"visible_area\": ", separator, i);
    json_number(out, seen->area[i]);
    text_buffer_add(out, "}");
    separator = ", ";
  }
  text_buffer_add(out, "]");
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_balls(const struct molecule *molecule, const struct seen *seen, struct text_buffer *out) {
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %16s\n", "visible area");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    char value[NUMBER_BYTES];
    if (seen->area[i] == 0.0) continue;
    report_ball(out, columns, molecule, i);
    text_buffer_add(out, "  %16s\n", column_text(value, molecule->format, seen->area[i], 4));
  }
}

static void print_table(const struct request *request, const struct molecule *molecule, const struct seen *seen,
                        struct text_buffer *out) {
  const hsp_map_info *map = &seen->map;
  char value[NUMBER_BYTES];
  char remark[80];
  report_heading(out, request, molecule);
  report_row_count(out, "vertices", map->vertices, "where edges end");
  report_row_count(out, "edges", map->edges, "silhouettes, and creases where two balls meet");
  report_row_count(out, "faces", map->faces, "the background counts");
  report_row_count(out, "visible balls", map->balls, "of which something is seen");
  snprintf(remark, sizeof remark, "%s^2, of the view plane", molecule->format->unit);
  report_row(out, "visible area", quantity_text(value, map->area, 6), remark);
  if (map->perturbation > 0.0) {
    snprintf(remark, sizeof remark, "%s at most: of balls seen one behind the other", molecule->format->unit);
    report_row(out, "moved", quantity_text(value, map->perturbation, 9), remark);
  }
  if (request->per_ball) print_balls(molecule, seen, out);
}

bool command_map(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                 struct text_buffer *out, struct failure *failure) {
  struct seen seen;
  memset(&seen, 0, sizeof seen);
  const bool done = geometry_compute_map(geometry, &request->viewing, molecule, failure) &&
                    read_map(geometry->work.map, molecule->atoms, &seen, failure);
  if (done && request->json) print_json(request, molecule, &seen, out);
  if (done && !request->json) print_table(request, molecule, &seen, out);
  free(seen.area);
  return done;
}
