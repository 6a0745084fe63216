/* hardsphere measure: area and volume of the union, and what single balls, residues and chains have of it. */
#include <inttypes.h>

#include "ball_table.h"
#include "commands.h"
#include "group_table.h"
#include "input_report.h"
#include "measurement.h"
#include "output_file.h"
#include "pdb_output.h"
#include "report.h"

/* Of totals, which are accurate to 1e-13 of their size for molecules; single balls are shown with four. */
enum { TOTAL_DECIMALS = 10 };

static void print_json(const struct request *request, const struct molecule *molecule,
                       const struct measurement *measurement, const struct atom_groups *groups,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"area\": ", molecule->atoms);
  json_number(out, measurement->totals.area);
  text_buffer_add(out, ", \"volume\": ");
  json_number(out, measurement->totals.volume);
  if (measurement->weights != NULL) {
    text_buffer_add(out, ", \"weighted_area\": ");
    json_number(out, measurement->weighted_area);
  }
  if (request_wants_balls(request)) {
    text_buffer_add(out, ", \"balls\": ");
    ball_table_json(molecule, measurement, out);
  }
  if (request->by != GROUPING_NONE) {
    text_buffer_add(out, request->by == GROUPING_RESIDUE ? ", \"residues\": " : ", \"chains\": ");
    group_table_json(molecule, groups, out);
  }
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_tables(const struct request *request, const struct molecule *molecule,
                         const struct measurement *measurement, const struct atom_groups *groups,
                         struct text_buffer *out) {
  const char *unit = format_unit(molecule->format);
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  text_buffer_add(out, "  %-16s %s %s^2\n", "area", quantity_text(value, measurement->totals.area, TOTAL_DECIMALS),
                  unit);
  text_buffer_add(out, "  %-16s %s %s^3\n", "volume", quantity_text(value, measurement->totals.volume, TOTAL_DECIMALS),
                  unit);
  if (measurement->weights != NULL) {
    text_buffer_add(out, "  %-16s %s, the sum of weight x free area\n", "weighted area",
                    quantity_text(value, measurement->weighted_area, TOTAL_DECIMALS));
  }
  if (measurement->one_sided > 0) {
    report_row_count(out, "touching balls", measurement->one_sided,
                     "their derivatives are one-sided: as if touching balls overlapped");
  }
  if (request_wants_balls(request)) ball_table_print(request, molecule, measurement, out);
  if (request->by != GROUPING_NONE) group_table_print(molecule, groups, out);
}

static void print(const struct request *request, const struct molecule *molecule, const struct measurement *measurement,
                  const struct atom_groups *groups, struct text_buffer *out) {
  if (request->json) {
    print_json(request, molecule, measurement, groups, out);
  } else if (!request->csv) {
    print_tables(request, molecule, measurement, groups, out);
  } else if (request->by == GROUPING_NONE) {
    ball_table_csv(molecule, measurement, out);
  } else {
    group_table_csv(molecule, groups, out);
  }
}

bool command_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  struct measurement measurement;
  struct atom_groups groups = ATOM_GROUPS_NONE;
  bool done = measurement_make(request, molecule, geometry, &measurement, failure);
  if (done && request->by != GROUPING_NONE) {
    done = atom_groups_make(molecule, request->by, measurement.area, &groups, failure);
  }
  const bool written_only = request->pdb_out != NULL && output_is_standard(request->pdb_out);
  if (done && !written_only) print(request, molecule, &measurement, &groups, out);
  if (done && request->pdb_out != NULL) {
    done = pdb_output_write(request->file, molecule, measurement.area, request->pdb_out, failure);
  }
  atom_groups_free(&groups);
  measurement_free(&measurement);
  return done;
}
