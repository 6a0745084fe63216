#include "commands/request.h"

bool request_wants_balls(const struct request *request) {
  return request->per_ball || request->gradient || (request->csv && request->by == GROUPING_NONE);
}

bool request_wants_areas(const struct request *request) {
  return request_wants_balls(request) || request->by != GROUPING_NONE || request->pdb_out != NULL || request->polar ||
         (request->excluded_surface && request->weights != NULL);
}

void request_free(struct request *request) {
  text_buffer_free(&request->overrides);
  selection_free(&request->selection);
  selection_free(&request->highlight);
  radii_table_free(&request->table);
}
