/* hardsphere voids: the cavities that the union encloses, and the balls around them. */
#include <inttypes.h>
#include <math.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/void_list.h"
#include "write/ball_label.h"

/* The values that are printed. */
struct found {
  const struct request *request;
  struct void_list list;
};

static bool void_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct void_cell *cell = &((const struct found *)of)->list.voids[row];
  const struct void_sphere *sphere = &cell->sphere;
  (void)text;
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
  return true;
}

static struct table table_of(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {NULL, "void", "void", 6, COLUMN_COUNT, 0},
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
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->list.count, found, void_row, NULL};
}

static void print(struct record *record, const void *of) {
  const struct found *const found = of;
  const struct void_list *const list = &found->list;
  const struct table table = table_of(record->molecule, found);
  record_atoms(record);
  const bool line = record->form == AS_CSV || record->form == AS_CSV_TITLES; /* which has no list */
  record_count(record, line ? "voids" : NULL, "voids", list->count, "cavities enclosed by the union, largest first");
  if (record->form == AS_JSON) record_table(record, "voids", &table);
  record_count(record, "smaller", list->smaller > 0 ? "smaller" : NULL, list->smaller,
               "not listed: smaller than --min-volume");
  if (record->form == FOR_PERSONS && list->count > 0) {
    record_line(record, "");
    record_line(record,
                "  volume in @^3, area in @^2; x y z: its point that is farthest from all balls, and its "
                "clearance, in @");
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

bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct found found = {.request = request};
  const bool done = void_list_make(geometry, molecule, request->probe, request->voids.min_volume, &found.list, failure);
  const struct table table = table_of(molecule, &found);
  if (done && request->csv) {
    table_csv(&table, out);
  } else if (done) {
    report(request, molecule, print, &found, out);
  }
  void_list_free(&found.list);
  return done;
}
