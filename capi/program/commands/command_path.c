/* hardsphere path: how the centre of a probe gets from one point to another. */
#include <math.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"
#include "write/report.h"

/* The values that are printed. */
struct found {
  hsp_path path;
  double *points;
};

static bool row_of(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  (void)text;
  cells[0].vector = ((const struct found *)of)->points + 3 * row;
  return true;
}

static void print(struct record *record, const void *of) {
  static const char *const remarks[] = {"", "the ends lie in two regions of free space", "an end lies in a ball"};
  static const struct column columns[] = {{NULL, NULL, "x y z", 14, COLUMN_POINT, 0}};
  const struct found *const found = of;
  const hsp_path *const path = &found->path;
  const bool connected = path->ends == HSP_PATH_CONNECTED;
  const struct table points = {columns, 1, record->molecule->format, path->points, found, row_of, NULL};
  record_atoms(record);
  record_whether(record, "connected", "connected", connected, remarks[path->ends]);
  record_whether(record, "covered", NULL, path->ends == HSP_PATH_COVERED, "");
  record_whether(record, "certified", connected ? "certified" : NULL, path->certified != 0,
                 "no segment meets a ball, by integers");
  record_number(record, "length", connected ? "length" : NULL, connected ? path->length : (double)NAN, 4, "@");
  record_number(record, "clearance", connected ? "clearance" : NULL, connected ? path->clearance : (double)NAN, 6,
                "@, least distance from a ball");
  if (record_key(record, "points")) json_points(record->out, found->points, path->points);
  if (record->form != FOR_PERSONS || !connected) return;
  record_count(record, NULL, "points", path->points, "");
  record_table(record, NULL, &points);
}

void describe_path(const struct request *request, struct record *record) {
  static const struct found none;
  (void)request;
  print(record, &none);
}

bool command_path(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  struct found found;
  uint32_t needed = 0;
  hsp_path *const path = &found.path;
  if (!geometry_find_path(geometry, request->path.from.point.xyz, request->path.to.point.xyz, path, failure))
    return false;
  found.points = calloc(3 * (size_t)path->points + 1, sizeof *found.points);
  if (found.points == NULL) return failure_of_memory(failure);
  const int32_t status = hsp_paths_get_points(geometry->work.paths, found.points, path->points, &needed);
  if (status == HSP_OK) report(request, molecule, print, &found, out);
  free(found.points);
  return status == HSP_OK || failure_in_library(failure, status);
}
