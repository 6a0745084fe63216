/* hardsphere voids: the cavities that the union encloses, and the balls around them. */
#include <inttypes.h>
#include <math.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/void_list.h"
#include "write/csv.h"
#include "write/report.h"

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

static void print_line(const struct molecule *molecule, uint32_t rank, const struct void_cell *of,
                       struct text_buffer *out) {
  const struct void_room *room = &of->room;
  char volume[NUMBER_BYTES];
  char area[NUMBER_BYTES];
  text_buffer_add(out, "  %6" PRIu32 "  %16s  %16s", rank, column_text(volume, molecule->format, of->figures.volume, 4),
                  column_text(area, molecule->format, of->figures.area, 4));
  for (int axis = 0; axis < 3; ++axis) {
    char value[NUMBER_BYTES];
    const char *shown = room->found ? coordinate_text(value, molecule->format, room->xyz[axis]) : "-";
    text_buffer_add(out, "  %9s", shown);
  }
  char clearance[NUMBER_BYTES];
  text_buffer_add(out, "  %9s", room->found ? column_text(clearance, molecule->format, room->clearance, 4) : "-");
  text_buffer_add(out, "  %6" PRIu32 "  %6" PRIu32 "\n", of->ball_count, of->figures.components);
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
  report_heading(out, request, molecule);
  report_row_count(out, "voids", list->count, "cavities enclosed by the union, largest first");
  if (list->smaller > 0) report_row_count(out, "smaller", list->smaller, "not listed: smaller than --min-volume");
  if (list->count > 0) {
    const char *unit = molecule->format->unit;
    text_buffer_add(out,
                    "\n  volume in %s^3, area in %s^2; x y z: its point that is farthest from all balls, and its "
                    "clearance, in %s\n",
                    unit, unit, unit);
    text_buffer_add(out, "  %6s  %16s  %16s  %9s  %9s  %9s  %9s  %6s  %6s\n", "void", "volume", "area", "x", "y", "z",
                    "clearance", "balls", "inside");
  }
  for (uint32_t i = 0; i < list->count; ++i) print_line(molecule, i + 1, &list->voids[i], out);
  if (!request->void_balls) return;
  const struct ball_columns columns = ball_columns_of(molecule);
  for (uint32_t i = 0; i < list->count; ++i) print_wall(molecule, columns, i + 1, &list->voids[i], out);
}

static void print_csv(const struct void_list *list, struct text_buffer *out) {
  text_buffer_add(out, "void,volume,area,x,y,z,clearance,clearance_bound,balls,components\n");
  for (uint32_t i = 0; i < list->count; ++i) {
    const struct void_cell *of = &list->voids[i];
    const struct void_room *room = &of->room;
    const double numbers[] = {of->figures.volume, of->figures.area};
    const double none[] = {NAN, NAN, NAN};
    const double clearance = room->found ? room->clearance : NAN;
    text_buffer_add(out, "%" PRIu32, i + 1);
    csv_numbers(out, numbers, 2);
    csv_numbers(out, room->found ? room->xyz : none, 3);
    csv_numbers(out, &clearance, 1);
    csv_numbers(out, &room->bound, 1);
    text_buffer_add(out, ",%" PRIu32 ",%" PRIu32 "\n", of->ball_count, of->figures.components);
  }
}

bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct void_list list;
  const bool done = void_list_make(geometry, molecule, request->probe, request->min_volume, &list, failure);
  if (done && request->json) print_json(request, molecule, &list, out);
  if (done && request->csv) print_csv(&list, out);
  if (done && !request->json && !request->csv) print_table(request, molecule, &list, out);
  void_list_free(&list);
  return done;
}
