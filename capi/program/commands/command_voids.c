/* hardsphere voids: the cavities that the union encloses, and the balls around them. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/followed_run.h"
#include "commands/input_report.h"
#include "commands/void_list.h"
#include "commands/void_sphere.h"
#include "write/ball_label.h"

/* The values that are printed. */
struct found {
  const struct request *request;
  struct void_list list;
  struct cavity *followed; /* [list.count] of a trajectory; NULL: of a single molecule */
};

static bool void_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  const struct void_cell *cell = &found->list.voids[row];
  const struct void_sphere *sphere = &cell->sphere;
  cells[0].count = (int64_t)row + 1;
  cells[1].count = cell->region;
  cells[2].quantity = cells[4].quantity = cell->figures.volume;
  cells[3].quantity = cell->figures.area;
  cells[5].count = cells[12].count = cell->figures.components;
  cells[6].counts.list = cell->balls;
  cells[6].counts.length = cell->ball_count;
  cells[7].vector = cell->middle;
  cells[8].vector = sphere->found ? sphere->xyz : NULL;
  cells[9].quantity = cells[10].quantity = sphere->found ? sphere->clearance : (double)NAN;
  cells[11].count = cell->ball_count;
  if (found->followed != NULL) followed_cells(&found->followed[row], &cells[0], &cells[13], text);
  return true;
}

static struct table table_of(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"void", NULL, "void", 6, COLUMN_COUNT, 0},
      {"cell", "", NULL, 0, COLUMN_COUNT, 0},
      {NULL, "volume", "volume", 16, COLUMN_QUANTITY, 4},
      {"area", NULL, "area", 16, COLUMN_QUANTITY, 4},
      {"volume", "", NULL, 0, COLUMN_QUANTITY, 0},
      {"components", "", NULL, 0, COLUMN_COUNT, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
      {"middle", "", NULL, 0, COLUMN_POINT, 0},
      {"point", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"clearance", NULL, "clearance", 9, COLUMN_QUANTITY, 4},
      {"clearance_bound", NULL, NULL, 0, COLUMN_QUANTITY, 0},
      {NULL, "balls", "balls", 6, COLUMN_COUNT, 0},
      {NULL, "components", "inside", 6, COLUMN_COUNT, 0},
      FOLLOWED_COLUMNS,
  };
  const int count = sizeof columns / sizeof columns[0] - (found->followed == NULL ? FOLLOWED : 0);
  return (struct table){columns, count, molecule->format, found->list.count, found, void_row, NULL};
}

/* Columns in the row of a frame. */
static void record_sums(struct record *record, const struct void_list *list) {
  double volume = 0.0, area = 0.0;
  for (uint32_t i = 0; i < list->count; ++i) volume += list->voids[i].figures.volume;
  for (uint32_t i = 0; i < list->count; ++i) area += list->voids[i].figures.area;
  record_number(record, "volume", NULL, volume, 0, "");
  record_number(record, "area", NULL, area, 0, "");
  record_number(record, "largest", NULL, list->count > 0 ? list->voids[0].figures.volume : 0.0, 0, "");
}

static void print(struct record *record, const void *of) {
  const struct found *const found = of;
  const struct void_list *const list = &found->list;
  const struct table table = table_of(record->molecule, found);
  const bool row = record_is_row(record);
  record_atoms(record);
  record_count(record, row ? "voids" : NULL, "voids", list->count, "cavities enclosed by the union, largest first");
  if (record->form == AS_JSON) record_table(record, "voids", &table);
  record_count(record, "smaller", list->smaller > 0 ? "smaller" : NULL, list->smaller,
               "not listed: smaller than --min-volume");
  if (row) record_sums(record, list);
  if (record->form == FOR_PERSONS && list->count > 0) {
    record_line(record, "");
    record_line(record, void_columns);
    table_print(&table, record->out);
  }
  for (uint32_t i = 0; record->form == FOR_PERSONS && found->request->voids.balls && i < list->count; ++i) {
    text_buffer_add(record->out, "\nballs around void %" PRIu32 "\n", i + 1);
    ball_rows_print(record->molecule, list->voids[i].balls, list->voids[i].ball_count, record->out);
  }
}

void describe_voids(const struct request *request, struct record *record) {
  const struct found none = {.request = request};
  print(record, &none);
}

static bool find(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                 struct found *found, struct failure *failure) {
  found->request = request;
  return geometry_compute_topology(geometry, failure) &&
         void_list_make(geometry, molecule, request->probe, request->voids.min_volume, &found->list, failure);
}

static void write(const struct request *request, const struct molecule *molecule, const struct found *found,
                  struct text_buffer *out) {
  const struct table table = table_of(molecule, found);
  if (request->csv) {
    report_list(molecule, &table, out);
  } else if (!request_prints_file(request)) {
    report(request, molecule, print, found, out);
  }
}

static void clear(void *findings) {
  struct found *const found = findings;
  void_list_free(&found->list);
  free(found->followed);
}

bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  struct found found = {.list = VOID_LIST_NONE};
  const bool done = find(request, molecule, geometry, &found, failure);
  if (done) write(request, molecule, &found, out);
  clear(&found);
  return done;
}

/* ---- a trajectory ---- */

static bool find_in_frame(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
                          struct failure *failure) {
  return find(((const struct followed_run *)of)->request, molecule, geometry, findings, failure);
}

static bool take_frame(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
                       struct failure *failure) {
  struct followed_run *const run = of;
  struct found *const found = findings;
  const struct void_list *const list = &found->list;
  found->followed = calloc((size_t)list->count + 1, sizeof *found->followed);
  if (found->followed == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < list->count; ++i) {
    const struct void_cell *const one = &list->voids[i];
    found->followed[i] =
        (struct cavity){.balls = one->balls, .ball_count = one->ball_count, .volume = one->figures.volume};
  }
  if (!followed_take(&run->followed, molecule, found->followed, list->count, failure)) return false;
  write(run->request, molecule, found, out);
  return true;
}

bool voids_of_run(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                  double *largest_rounding, struct failure *failure) {
  const struct frame_work work = {
      .bytes = sizeof(struct found), .find = find_in_frame, .take = take_frame, .clear = clear};
  (void)out;
  return follow_run(request, molecule, work, "void", largest_rounding, failure);
}
