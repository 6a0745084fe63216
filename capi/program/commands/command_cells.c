/* hardsphere cells: free space as simple cells, their number, and the regions that they form. */
#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"

static void print(struct record *record, const void *of) {
  const hsp_cells_counts *const found = of;
  record_atoms(record);
  record_count(record, "cubes", "cubes", found->cubes, "cubes of the grid that balls meet");
  record_count(record, "cells", "cells", found->power_cells, "power cells in these cubes");
  record_count(record, "free_cells", "free cells", found->cells,
               "what no ball covers of them, and runs of other cubes");
  record_count(record, "adjacencies", "adjacencies", found->adjacencies, "pairs of free cells with a common facet");
  record_count(record, "regions", "regions", found->regions, "connected pieces of free space, the outside among them");
}

void describe_cells(const struct request *request, struct record *record) {
  static const hsp_cells_counts none;
  (void)request;
  print(record, &none);
}

bool command_cells(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_cells(geometry, failure)) return false;
  hsp_cells_counts found;
  const int32_t status = hsp_cells_get_counts(geometry->work.cells, &found);
  if (status != HSP_OK) return failure_in_library(failure, status);
  report(request, molecule, print, &found, out);
  return true;
}
