#include "commands/request.h"

#include <stdlib.h>

#include "read/threads.h"
#include "write/same_file.h"

bool request_wants_balls(const struct request *request) {
  return request->measure.per_ball || request->measure.gradient || (request->csv && request->by == GROUPING_NONE);
}

bool request_wants_areas(const struct request *request) {
  return request_wants_balls(request) || request->by != GROUPING_NONE || request->measure.pdb_out != NULL ||
         request->measure.polar || (request->excluded_surface && request->weights != NULL);
}

bool request_wants_places(const struct request *request) {
  return request->command != COMMAND_MEASURE || request_wants_balls(request) || request->measure.interface != NULL ||
         request->window > 0.0 || request->measure.pdb_out != NULL || request->box.source != BOX_NONE ||
         request->trajectory != NULL;
}

bool request_wants_part(const struct request *request) {
  return request->measure.part.count > 0;
}

bool request_reads(const struct request *request, const char *path) {
  const char *const inputs[] = {request->file,       request->trajectory, request->weights,
                                request->radii_file, request->index_file, request->drawing.colour_file};
  for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; ++i) {
    if (inputs[i] != NULL && output_is_input(path, inputs[i])) return true;
  }
  return false;
}

int request_outputs(const struct request *request, struct output_choice outputs[MOST_OUTPUTS]) {
  const struct output_choice all[] = {
      {"-o", request->command == COMMAND_DRAW ? request->drawing.out : request->meshing.out, NULL},
      {"--pdb-out", request->measure.pdb_out, NULL},
      {"--map", request->contacts.map, "an .svg"},
      {"--points", request->pores.points, "a .pdb or .cif"},
      {"--tunnels-out", request->pores.tunnels_out, "a .cif"},
      {"--profile", request->pores.profile, "an .svg"},
      {"--tree", request->pores.tree, "an .svg"},
      {"--plot", request->plot, "an .svg"},
  };
  int count = 0;
  for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k) {
    if (all[k].path != NULL) outputs[count++] = all[k];
  }
  return count;
}

bool request_prints_file(const struct request *request) {
  struct output_choice outputs[MOST_OUTPUTS];
  const int count = request_outputs(request, outputs);
  for (int k = 0; k < count; ++k) {
    if (output_is_standard(outputs[k].path)) return true;
  }
  return false;
}

double request_grown(const struct request *request) {
  return request->command == COMMAND_PORES ? 0.0 : request->probe;
}

uint32_t request_threads(const struct request *request) {
  return request->threads > 0 ? request->threads : threads_of_machine();
}

void request_free(struct request *request) {
  free(request->names);
  text_buffer_free(&request->overrides);
  selection_free(&request->selection);
  selection_free(&request->drawing.highlight);
  selection_free(&request->measure.part);
  index_file_free(&request->index);
  radii_table_free(&request->table);
}
