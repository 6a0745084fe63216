/* hardsphere cells: free space as simple cells, how many there are and what they make up. */
#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"

bool command_cells(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_cells(geometry, failure)) return false;
  hsp_cells_counts found;
  const int32_t status = hsp_cells_get_counts(geometry->work.cells, &found);
  if (status != HSP_OK) return failure_in_library(failure, status);
  const struct result results[] = {
      {"cubes", "cubes", found.cubes, 0, "cubes of the grid that balls meet"},
      {"cells", "cells", found.power_cells, 0, "power cells in these cubes"},
      {"free_cells", "free cells", found.cells, 0, "what no ball covers of them, and runs of other cubes"},
      {"adjacencies", "adjacencies", found.adjacencies, 0, "pairs of free cells with a common facet"},
      {"regions", "regions", found.regions, 0, "connected pieces of free space, the outside among them"},
  };
  input_report_results(out, request, molecule, results, sizeof results / sizeof results[0]);
  return true;
}
