/* hardsphere measure: area and volume of the union, and the areas of single balls, residues and chains. */
#include <math.h>
#include <string.h>

#include "commands/ball_table.h"
#include "commands/commands.h"
#include "commands/framework_units.h"
#include "commands/group_table.h"
#include "commands/input_report.h"
#include "commands/interface.h"
#include "commands/measure_mean.h"
#include "commands/measurement.h"
#include "write/pdb_output.h"

/* Decimals of totals, which are accurate to 1e-13 of their size for molecules; single balls are shown with four. */
enum { TOTAL_DECIMALS = 10 };

/* All that is printed. */
struct findings {
  const struct request *request;
  struct measurement measurement;
  struct atom_groups groups;
  struct interface interface;
};

/* The surface and the box, behind the totals of the union. */
static void record_subject(struct record *record, const struct request *request, const struct measurement *of) {
  if (of->box.periodic != NULL) {
    periodic_result_record(record, &of->box);
    framework_record_union(record, of->box.box, of->part == NULL ? of->totals.area : (double)NAN,
                           of->box.totals.free_volume);
  }
  if (request->excluded_surface && record->form == AS_JSON) {
    record_text(record, "surface", NULL, "ses", "");
    if (request->measure.outer) record_whether(record, "outer", NULL, true, "");
  }
}

static void record_totals(struct record *record, const struct request *request, const struct measurement *of) {
  struct quantities quantities;
  measurement_quantities(request, of, &quantities);
  for (size_t k = 0; k < quantities.count; ++k) {
    const struct quantity *const row = &quantities.of[k];
    record_number(record, row->key, row->title, row->value, TOTAL_DECIMALS, row->remark);
    if (k + 1 == quantities.totals) record_subject(record, request, of);
  }
}

static void print(struct record *record, const void *of) {
  const struct findings *const found = of;
  const struct request *const request = found->request;
  const struct measurement *const measurement = &found->measurement;
  const bool line = record_is_row(record);
  record_atoms(record);
  if (measurement->part != NULL) {
    record_count(record, "measured", "measured", measurement->part_atoms, "of them; all others only block");
  }
  record->width = 0;
  record_totals(record, request, measurement);
  record->width = VALUE_WIDTH;
  if (measurement->one_sided > 0) {
    record_count(record, NULL, request->excluded_surface ? "degenerate balls" : "touching balls",
                 measurement->one_sided,
                 request->excluded_surface
                     ? "their derivatives are one-sided at best: four spheres meet in a point, or balls are equal"
                     : "their derivatives are one-sided: as if touching balls overlapped");
  }
  if (request->measure.interface.text != NULL) {
    interface_record(record, &request->measure.interface, &found->interface);
  }
  if (request_wants_balls(request) && !line) {
    struct ball_table balls;
    ball_table_make(record->molecule, measurement, request->probe, &balls);
    record_table(record, "balls", &balls.table);
  }
  if (request->by != GROUPING_NONE && !line)
    group_table_record(record, &found->groups, NULL, request->measure.relative);
}

static void print_all(const struct request *request, const struct molecule *molecule, const struct findings *found,
                      struct text_buffer *out) {
  if (!request->csv || molecule->frame.number > 0) {
    report(request, molecule, print, found, out);
  } else if (request->by == GROUPING_NONE) {
    struct ball_table balls;
    ball_table_make(molecule, &found->measurement, request->probe, &balls);
    table_csv(&balls.table, out);
  } else {
    group_table_csv(molecule, &found->groups, NULL, request->measure.relative, out);
  }
}

void describe_measure(const struct request *request, struct record *record) {
  static double some[1];
  static const struct gradient derivatives = {some, some};
  static uint8_t part[1];
  struct request asked = *request;
  struct findings none = {.request = &asked};
  struct measurement *const of = &none.measurement;
  asked.excluded_surface = request->measure.surface == 1;
  if (request_wants_part(request)) of->part = part;
  if (request->weights != NULL) of->weights = some;
  if (request->measure.gradient) of->of_area = of->of_volume = derivatives;
  if (request->measure.gradient && of->weights != NULL) of->of_weighted_area = derivatives;
  if (request->measure.gradient && request->window > 0.0) of->of_windowed_area = derivatives;
  none.groups.grouping = request->by;
  if (request->measure.mean) {
    measure_mean_describe(request, record);
  } else {
    print(record, &none);
  }
}

bool command_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  struct findings found;
  memset(&found, 0, sizeof found);
  found.request = request;
  bool done = measurement_make(request, molecule, geometry, &found.measurement, failure);
  const double *area = found.measurement.area;
  if (done && request->by != GROUPING_NONE) {
    done = atom_groups_make(molecule, request->by, &request->index, found.measurement.part, &found.groups, failure);
    if (done) atom_groups_sum(&found.groups, area);
  }
  if (done && request->measure.interface.text != NULL) {
    done = interface_measure(request, molecule, geometry, &found.interface, failure);
  }
  if (done && request_wants_balls(request)) progress_show(&geometry->progress, "making the table");
  if (done && !request_prints_file(request)) print_all(request, molecule, &found, out);
  if (done && request->measure.pdb_out != NULL) {
    progress_show(&geometry->progress, "writing");
    done = pdb_output_write(request->file, molecule, area, request->measure.pdb_out, failure);
  }
  atom_groups_free(&found.groups);
  interface_free(&found.interface);
  measurement_free(&found.measurement);
  return done;
}
