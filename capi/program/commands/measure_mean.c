#include "commands/measure_mean.h"

#include <string.h>

#include "commands/command_frames.h"
#include "commands/group_table.h"
#include "commands/input_report.h"
#include "commands/measurement.h"
#include "commands/running_mean.h"
#include "write/ball_label.h"

/* The numbers of a frame are its quantities, and behind them the areas of balls or of groups. */
struct findings {
  const struct request *request;
  const struct molecule *molecule;
  struct atom_groups groups; /* their areas are those of the means in the end */
  struct running_mean running;
  struct quantities quantities; /* without values */
};

static bool has_groups(const struct request *request) {
  return request->by != GROUPING_NONE;
}

static bool find(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
                 struct failure *failure) {
  double *numbers = findings;
  const struct findings *const found = of;
  const struct atom_groups *const groups = &found->groups;
  const struct request *const request = found->request;
  struct measurement measurement;
  const bool done = measurement_make(request, molecule, geometry, &measurement, failure);
  if (done) {
    struct quantities quantities;
    measurement_quantities(request, &measurement, &quantities);
    for (size_t k = 0; k < quantities.count; ++k) *numbers++ = quantities.of[k].value;
    for (uint32_t k = 0; k < groups->count; ++k) {
      *numbers++ = atom_group_sum(groups, &groups->group[k], measurement.area);
    }
    if (request_wants_balls(request)) memcpy(numbers, measurement.area, molecule->atoms * sizeof *numbers);
  }
  measurement_free(&measurement);
  return done;
}

static bool take(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
                 struct failure *failure) {
  struct findings *const found = of;
  (void)molecule, (void)out, (void)failure;
  running_mean_add(&found->running, findings);
  return true;
}

static bool quantity_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct findings *const found = of;
  const struct running_mean *const running = &found->running;
  (void)text;
  cells[0].text = found->quantities.of[row].key;
  cells[1].text = found->quantities.of[row].title;
  cells[2].quantity = running->mean[row];
  cells[3].quantity = running->deviation[row];
  cells[4].quantity = running->least[row];
  cells[5].quantity = running->most[row];
  return true;
}

/* Beside it the balls that are measured, in the frame of ball_rows, which is its first member. */
struct ball_means {
  struct ball_rows rows;
  const double *mean, *deviation; /* [balls] */
  const struct selection *part;
};

static bool ball_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct ball_means *const means = of;
  (void)text;
  if (means->part->count > 0 && !selection_takes(means->part, means->rows.molecule, (uint32_t)row)) return false;
  cells[0].quantity = means->mean[row];
  cells[1].quantity = means->deviation[row];
  return true;
}

static struct table ball_table(const struct findings *found, struct ball_means *means) {
  static const struct column columns[] = {{"area", NULL, "free area", 14, COLUMN_QUANTITY, 4},
                                          {"deviation", NULL, "deviation", 12, COLUMN_QUANTITY, 4}};
  *means = (struct ball_means){
      ball_rows_of(found->molecule, NULL), found->running.mean + found->running.count - found->molecule->atoms,
      found->running.deviation + found->running.count - found->molecule->atoms, &found->request->measure.part};
  return (struct table){columns, 2, found->molecule->format, found->molecule->atoms, means, ball_row, ball_rows_lead};
}

static const double *group_deviations(const struct findings *found) {
  return found->running.deviation + found->quantities.count;
}

static void print(struct record *record, const void *of) {
  static const struct column columns[] = {
      {"quantity", NULL, NULL, 0, COLUMN_TEXT, 0},      {NULL, "", "quantity", -16, COLUMN_TEXT, 0},
      {"mean", NULL, "mean", 18, COLUMN_QUANTITY, 4},   {"deviation", NULL, "deviation", 14, COLUMN_QUANTITY, 4},
      {"least", NULL, "least", 18, COLUMN_QUANTITY, 4}, {"most", NULL, "most", 18, COLUMN_QUANTITY, 4}};
  const struct findings *const found = of;
  const struct request *const request = found->request;
  const struct table table = {columns, 6, record->molecule->format, found->quantities.count, found, quantity_row, NULL};
  record_atoms(record);
  record_count(record, "frames", "frames", (int64_t)found->running.times, "");
  record_table(record, "means", &table);
  if (has_groups(request)) {
    group_table_record(record, &found->groups, group_deviations(found), request->measure.relative);
  }
  if (!request_wants_balls(request)) return;
  struct ball_means means;
  const struct table balls = ball_table(found, &means);
  record_table(record, "balls", &balls);
}

void measure_mean_describe(const struct request *request, struct record *record) {
  static double some[1];
  struct findings none = {.request = request, .molecule = record->molecule, .running = {.deviation = some}};
  none.groups.grouping = request->by;
  print(record, &none);
}

/* Groups are the same in all frames. */
static bool make(struct findings *found, struct failure *failure) {
  const struct request *const request = found->request;
  const struct molecule *const molecule = found->molecule;
  struct measurement nothing = {.totals = {0}};
  measurement_quantities(request, &nothing, &found->quantities);
  size_t rows = request_wants_balls(request) ? molecule->atoms : 0;
  if (has_groups(request)) {
    const bool done = measurement_find_part(request, molecule, &nothing, failure) &&
                      atom_groups_make(molecule, request->by, &request->index, nothing.part, &found->groups, failure);
    measurement_free(&nothing);
    if (!done) return false;
    rows += found->groups.count;
  }
  return running_mean_make(&found->running, found->quantities.count + rows) || failure_of_memory(failure);
}

bool measure_mean(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                  double *largest_rounding, struct failure *failure) {
  struct findings found = {.request = request, .molecule = molecule, .groups = ATOM_GROUPS_NONE};
  bool done = make(&found, failure);
  if (done) {
    const struct frame_work work = {
        .bytes = found.running.count * sizeof *found.running.mean, .find = find, .take = take, .of = &found};
    done = command_frames(request, molecule, &work, largest_rounding, failure);
  }
  if (done) {
    running_mean_finish(&found.running);
    const double *const of_groups = found.running.mean + found.quantities.count;
    for (uint32_t k = 0; k < found.groups.count; ++k) found.groups.group[k].area = of_groups[k];
    if (!request->csv) {
      report(request, molecule, print, &found, out);
    } else if (has_groups(request)) {
      group_table_csv(molecule, &found.groups, group_deviations(&found), request->measure.relative, out);
    } else {
      struct ball_means means;
      const struct table balls = ball_table(&found, &means);
      table_csv(&balls, out);
    }
  }
  atom_groups_free(&found.groups);
  running_mean_free(&found.running);
  return done;
}
