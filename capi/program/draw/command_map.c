/* hardsphere map: what is seen from a direction, as faces, edges and vertices of the view plane. */
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/view_geometry.h"
#include "write/ball_label.h"

/* The visible parts, by balls. */
struct seen {
  struct ball_rows rows;
  bool per_ball; /* for persons, too */
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

static bool ball_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  (void)text;
  cells[0].quantity = ((const struct seen *)of)->area[row];
  return cells[0].quantity != 0.0;
}

static void print(struct record *record, const void *of) {
  static const struct column columns[] = {{"visible_area", NULL, "visible area", 16, COLUMN_QUANTITY, 4}};
  const struct seen *const seen = of;
  const hsp_map_info *map = &seen->map;
  const struct molecule *const molecule = record->molecule;
  const struct table balls = {columns, 1, molecule->format, molecule->atoms, seen, ball_row, ball_rows_lead_index};
  record_atoms(record);
  record_count(record, "vertices", "vertices", map->vertices, "where edges end");
  record_count(record, "edges", "edges", map->edges, "silhouettes, and creases where two balls meet");
  record_count(record, "faces", "faces", map->faces, "the background counts");
  record_count(record, "visible_balls", "visible balls", map->balls, "of which something is seen");
  record_number(record, "visible_area", "visible area", map->area, 6, "@^2, of the view plane");
  record_number(record, "moved", map->perturbation > 0.0 ? "moved" : NULL, map->perturbation, 9,
                "@ at most: of balls seen one behind the other");
  if (record->form == AS_JSON || seen->per_ball) record_table(record, "balls", &balls);
}

void describe_map(const struct request *request, struct record *record) {
  static const struct seen none;
  (void)request;
  print(record, &none);
}

bool command_map(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                 struct text_buffer *out, struct failure *failure) {
  struct seen seen;
  memset(&seen, 0, sizeof seen);
  seen.rows = ball_rows_of(molecule, NULL);
  seen.per_ball = request->map.per_ball;
  const bool done = geometry_compute_map(geometry, &request->viewing, molecule, failure) &&
                    read_map(geometry->work.map, molecule->atoms, &seen, failure);
  if (done) report(request, molecule, print, &seen, out);
  free(seen.area);
  return done;
}
