/* hardsphere query: the balls that contain a point, or that meet a ball. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "write/report.h"

static int32_t ask(const struct request *request, const hsp_model *model, uint32_t *ids, uint32_t capacity,
                   uint32_t *needed) {
  if (request->query == QUERY_POINT) return hsp_query_point(model, request->position, ids, capacity, needed);
  return hsp_query_ball(model, request->position, request->query_radius, ids, capacity, needed);
}

static void print_json(const struct request *request, const struct molecule *molecule, const uint32_t *ids,
                       uint32_t count, struct text_buffer *out) {
  text_buffer_add(out, "{\"hits\": [");
  for (uint32_t i = 0; i < count; ++i) text_buffer_add(out, "%s%" PRIu32, i == 0 ? "" : ", ", ids[i]);
  text_buffer_add(out, "]");
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static double distance(const double *a, const double *b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return sqrt(x * x + y * y + z * z); /* hypot differs from one mathematics library to the next; sqrt does not */
}

static void print_table(const struct request *request, const struct molecule *molecule, const uint32_t *ids,
                        uint32_t count, struct text_buffer *out) {
  const char *unit = molecule->format->unit;
  report_heading(out, request, molecule);
  const double *at = request->position;
  text_buffer_add(out, "  %-16s at %.10g %.10g %.10g", request->query == QUERY_POINT ? "query point" : "query ball",
                  at[0], at[1], at[2]);
  if (request->query == QUERY_BALL) text_buffer_add(out, ", radius %.10g", request->query_radius);
  text_buffer_add(out, " %s\n", unit);
  report_row_count(out, "hits", count,
                   request->query == QUERY_POINT ? "balls that contain the point" : "balls that meet the ball");
  if (count == 0) return;
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %18s\n", "distance of centre");
  for (uint32_t i = 0; i < count; ++i) {
    char value[NUMBER_BYTES];
    report_ball(out, columns, molecule, ids[i]);
    text_buffer_add(out, "  %18s\n", quantity_text(value, distance(at, molecule->xyz + 3 * (size_t)ids[i]), 4));
  }
}

bool command_query(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  uint32_t count = 0;
  int32_t status = ask(request, geometry->work.model, NULL, 0, &count);
  uint32_t *ids = calloc((size_t)count + 1, sizeof *ids);
  if (ids == NULL) return failure_of_memory(failure);
  if (status == HSP_E_CAPACITY) status = ask(request, geometry->work.model, ids, count, &count);
  if (status == HSP_E_RANGE) {
    failure_in_input(failure, 0, "the query: %s", geometry_reason(status));
  } else if (status != HSP_OK) {
    failure_in_library(failure, status);
  } else if (request->json) {
    print_json(request, molecule, ids, count, out);
  } else {
    print_table(request, molecule, ids, count, out);
  }
  free(ids);
  return status == HSP_OK;
}
