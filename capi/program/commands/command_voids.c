/* hardsphere voids: the cavities that the union encloses, and the balls around them. */
#include <inttypes.h>
#include <math.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/void_list.h"
#include "write/report.h"
#include "write/table.h"

static void json_room(const struct void_room *room, struct text_buffer *out) {
  text_buffer_add(out, ", \"point\": ");
  if (room->found) {
    json_vector(out, room->xyz);
  } else {
    text_buffer_add(out, "null");
  }
  text_buffer_add(out, ", \"clearance\": ");
  json_number(out, room->found ? room->clearance : NAN);
  text_buffer_add(out, ", \"clearance_bound\": ");
  json_number(out, room->bound);
}

static void print_json(const struct request *request, const struct molecule *molecule, const struct void_list *list,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"voids\": [", molecule->atoms);
  for (uint32_t i = 0; i < list->count; ++i) {
    const struct void_cell *of = &list->voids[i];
    text_buffer_add(out, "%s{\"cell\": %" PRIu32 ", \"area\": ", i == 0 ? "" : ", ", of->cell);
    json_number(out, of->figures.area);
    text_buffer_add(out, ", \"volume\": ");
    json_number(out, of->figures.volume);
    text_buffer_add(out, ", \"components\": %" PRIu32 ", \"balls\": [", of->figures.components);
    for (uint32_t k = 0; k < of->ball_count; ++k) {
      text_buffer_add(out, "%s%" PRIu32, k == 0 ? "" : ", ", of->balls[k]);
    }
    text_buffer_add(out, "], \"middle\": ");
    json_vector(out, of->middle);
    json_room(&of->room, out);
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "], \"smaller\": %" PRIu32, list->smaller);
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static bool void_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct void_cell *cell = &((const struct void_list *)of)->voids[row];
  const struct void_room *room = &cell->room;
  (void)text;
  cells[0].count = (int64_t)row + 1;
  cells[1].quantity = cell->figures.volume;
  cells[2].quantity = cell->figures.area;
  for (int axis = 0; axis < 3; ++axis) cells[3 + axis].quantity = room->found ? room->xyz[axis] : NAN;
  cells[6].quantity = room->found ? room->clearance : NAN;
  cells[7].quantity = room->bound;
  cells[8].count = cell->ball_count;
  cells[9].count = cell->figures.components;
  return true;
}

static struct table table_of(const struct molecule *molecule, const struct void_list *list) {
  static const struct column columns[] = {
      {"void", NULL, "void", 6, COLUMN_COUNT, 0},
      {"volume", NULL, "volume", 16, COLUMN_QUANTITY, 4},
      {"area", NULL, "area", 16, COLUMN_QUANTITY, 4},
      {"x", NULL, "x", 9, COLUMN_COORDINATE, 0},
      {"y", NULL, "y", 9, COLUMN_COORDINATE, 0},
      {"z", NULL, "z", 9, COLUMN_COORDINATE, 0},
      {"clearance", NULL, "clearance", 9, COLUMN_QUANTITY, 4},
      {"clearance_bound", NULL, NULL, 0, COLUMN_QUANTITY, 0},
      {"balls", NULL, "balls", 6, COLUMN_COUNT, 0},
      {"components", NULL, "inside", 6, COLUMN_COUNT, 0},
  };
  return (struct table){columns, sizeof columns / sizeof columns[0], molecule->format, list->count, list, void_row,
                        NULL};
}

static void print_wall(const struct molecule *molecule, struct ball_columns columns, uint32_t rank,
                       const struct void_cell *of, struct text_buffer *out) {
  text_buffer_add(out, "\nballs around void %" PRIu32 "\n\n", rank);
  report_ball_titles(out, columns);
  text_buffer_add(out, "\n");
  for (uint32_t k = 0; k < of->ball_count; ++k) {
    report_ball(out, columns, molecule, of->balls[k]);
    text_buffer_add(out, "\n");
  }
}

static void print_table(const struct request *request, const struct molecule *molecule, const struct void_list *list,
                        struct text_buffer *out) {
  const struct table table = table_of(molecule, list);
  report_heading(out, request, molecule);
  report_row_count(out, "voids", list->count, "cavities enclosed by the union, largest first");
  if (list->smaller > 0) report_row_count(out, "smaller", list->smaller, "not listed: smaller than --min-volume");
  if (list->count > 0) {
    const char *unit = molecule->format->unit;
    text_buffer_add(out,
                    "\n  volume in %s^3, area in %s^2; x y z: its point that is farthest from all balls, and its "
                    "clearance, in %s\n",
                    unit, unit, unit);
    table_print(&table, out);
  }
  if (!request->void_balls) return;
  const struct ball_columns columns = ball_columns_of(molecule);
  for (uint32_t i = 0; i < list->count; ++i) print_wall(molecule, columns, i + 1, &list->voids[i], out);
}

bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct void_list list;
  const bool done = void_list_make(geometry, molecule, request->probe, request->min_volume, &list, failure);
  if (done && request->json) print_json(request, molecule, &list, out);
  const struct table table = table_of(molecule, &list);
  if (done && request->csv) table_csv(&table, out);
  if (done && !request->json && !request->csv) print_table(request, molecule, &list, out);
  void_list_free(&list);
  return done;
}
