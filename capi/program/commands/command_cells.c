/* hardsphere cells: free space as simple cells, how many there are and what they make up. */
#include <inttypes.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"
#include "write/report.h"

static void print_json(const struct request *request, const struct molecule *molecule, const hsp_cells_counts *found,
                       struct text_buffer *out) {
  text_buffer_add(out,
                  "{\"n\": %" PRIu32 ", \"cubes\": %" PRIu32 ", \"cells\": %" PRIu32 ", \"free_cells\": %" PRIu32
                  ", \"adjacencies\": %" PRIu32 ", \"regions\": %" PRIu32,
                  molecule->atoms, found->cubes, found->power_cells, found->cells, found->adjacencies, found->regions);
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_cells_counts *found,
                        struct text_buffer *out) {
  report_heading(out, request, molecule);
  report_row_count(out, "cubes", found->cubes, "cubes of the grid that balls meet");
  report_row_count(out, "cells", found->power_cells, "power cells in these cubes");
  report_row_count(out, "free cells", found->cells, "what no ball covers of them, and runs of other cubes");
  report_row_count(out, "adjacencies", found->adjacencies, "pairs of free cells with a common facet");
  report_row_count(out, "regions", found->regions, "connected pieces of free space, the outside among them");
}

bool command_cells(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_cells(geometry, failure)) return false;
  hsp_cells_counts found;
  const int32_t status = hsp_cells_get_counts(geometry->work.cells, &found);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(request, molecule, &found, out);
  } else {
    print_table(request, molecule, &found, out);
  }
  return true;
}
