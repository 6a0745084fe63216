/* hardsphere query: the balls that contain a point, or that meet a ball. */
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "read/vectors.h"
#include "write/ball_label.h"

static int32_t ask(const struct request *request, const hsp_model *model, uint32_t *ids, uint32_t capacity,
                   uint32_t *needed) {
  if (request->query.kind == QUERY_POINT) return hsp_query_point(model, request->query.position, ids, capacity, needed);
  return hsp_query_ball(model, request->query.position, request->query.radius, ids, capacity, needed);
}

/* The values that are printed: the balls, and how far away they are. */
struct found {
  struct ball_rows rows;
  const struct request *request;
  uint32_t count;
};

static bool row_of(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  (void)text;
  cells[0].quantity =
      distance_between(found->request->query.position, found->rows.molecule->xyz + 3 * (size_t)found->rows.balls[row]);
  return true;
}

static void print(struct record *record, const void *of) {
  static const struct column columns[] = {{NULL, NULL, "distance of centre", 18, COLUMN_PLAIN, 4}};
  const struct found *const found = of;
  const struct request *const request = found->request;
  const double *const at = request->query.position;
  const bool point = request->query.kind == QUERY_POINT;
  const struct table table = {columns, 1, request->format, found->count, found, row_of, ball_rows_lead};
  record_counts(record, "hits", found->rows.balls, found->count);
  if (record_is_row(record)) record_count(record, "hits", NULL, found->count, "");
  if (record->form != FOR_PERSONS) return;
  text_buffer_add(record->out, "  %-16s at %.10g %.10g %.10g", point ? "query point" : "query ball", at[0], at[1],
                  at[2]);
  if (!point) text_buffer_add(record->out, ", radius %.10g", request->query.radius);
  text_buffer_add(record->out, " %s\n", record->molecule->format->unit);
  record_count(record, NULL, "hits", found->count, point ? "balls that contain the point" : "balls that meet the ball");
  if (found->count > 0) record_table(record, NULL, &table);
}

void describe_query(const struct request *request, struct record *record) {
  const struct found none = {.request = request};
  print(record, &none);
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
  } else {
    const struct found found = {ball_rows_of(molecule, ids), request, count};
    report(request, molecule, print, &found, out);
  }
  free(ids);
  return status == HSP_OK;
}
