/* hardsphere path: how the centre of a probe gets from one point to another. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"
#include "write/report.h"

static const char *yes_or_no(bool yes) {
  return yes ? "yes" : "no";
}

static void print_json(const struct request *request, const struct molecule *molecule, const hsp_path *path,
                       const double *points, struct text_buffer *out) {
  const bool connected = path->ends == HSP_PATH_CONNECTED;
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"connected\": %s, \"covered\": %s, \"certified\": %s, \"length\": ",
                  molecule->atoms, connected ? "true" : "false", path->ends == HSP_PATH_COVERED ? "true" : "false",
                  path->certified != 0 ? "true" : "false");
  json_number(out, connected ? path->length : NAN);
  text_buffer_add(out, ", \"clearance\": ");
  json_number(out, connected ? path->clearance : NAN);
  text_buffer_add(out, ", \"points\": [");
  for (uint32_t k = 0; k < path->points; ++k) {
    if (k > 0) text_buffer_add(out, ", ");
    json_vector(out, points + 3 * (size_t)k);
  }
  text_buffer_add(out, "]");
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_path *path,
                        const double *points, struct text_buffer *out) {
  static const char *const remarks[] = {"", "the ends lie in two regions of free space", "an end lies in a ball"};
  const bool connected = path->ends == HSP_PATH_CONNECTED;
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  report_row(out, "connected", yes_or_no(connected), remarks[path->ends]);
  if (!connected) return;
  report_row(out, "certified", yes_or_no(path->certified != 0), "no segment meets a ball, by integers");
  report_row(out, "length", quantity_text(value, path->length, 4), molecule->format->unit);
  char remark[60];
  snprintf(remark, sizeof remark, "%s, least distance from a ball", molecule->format->unit);
  report_row(out, "clearance", quantity_text(value, path->clearance, 6), remark);
  report_row_count(out, "points", path->points, "");
  text_buffer_add(out, "\n  %14s  %14s  %14s\n", "x", "y", "z");
  for (uint32_t k = 0; k < path->points; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      text_buffer_add(out, "  %14s", coordinate_text(value, molecule->format, points[3 * (size_t)k + (size_t)axis]));
    }
    text_buffer_add(out, "\n");
  }
}

bool command_path(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  hsp_path path;
  uint32_t needed = 0;
  if (!geometry_find_path(geometry, request->from.point.xyz, request->to.point.xyz, &path, failure)) return false;
  double *const points = calloc(3 * (size_t)path.points + 1, sizeof *points);
  if (points == NULL) return failure_of_memory(failure);
  const int32_t status = hsp_paths_get_points(geometry->work.paths, points, path.points, &needed);
  if (status != HSP_OK) {
    failure_in_library(failure, status);
  } else if (request->json) {
    print_json(request, molecule, &path, points, out);
  } else {
    print_table(request, molecule, &path, points, out);
  }
  free(points);
  return status == HSP_OK;
}
