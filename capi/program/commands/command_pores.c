/* hardsphere pores: free space for every probe at once: maxima, gates and their classes, pockets and tunnels. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"
#include "commands/space_geometry.h"
#include "write/ball_label.h"

enum { TUNNELS = 3 };

/* Lists of numbers, one for each of several things. */
struct lists {
  size_t *first; /* [things + 1] */
  uint32_t *number;
};

/* The steps of the tunnels, one after another. */
struct step {
  uint32_t tunnel; /* from 1 on */
  double length;   /* of the way from its start */
  hsp_tunnel_point point;
};

/* The values that are printed. */
struct found {
  const struct request *request;
  hsp_pores_counts counts;
  hsp_pore_maximum *maxima;
  hsp_pore_gate *gates;
  struct lists of_maxima; /* balls */
  struct lists of_gates;
  uint32_t pocket_count;
  hsp_pore_pocket *pockets;
  struct lists mouths;
  struct lists lining;
  double from[3];
  double room; /* of the largest probe there */
  uint32_t tunnel_count;
  hsp_tunnel *tunnels;
  struct step *steps;
  size_t step_count;
  struct periodic_result box; /* with --box, and what follows */
  hsp_pore_percolation wide;
  hsp_pore_gate_shifts *shifts; /* [gates] */
  uint32_t channel_count;
  hsp_pore_channel *channels;
};

static bool is_boxed(const struct request *request) {
  return request->box.source != BOX_NONE;
}

/* ---- what is found ---- */

typedef int32_t get_list(const hsp_pores *pores, uint32_t of, uint32_t *numbers, uint32_t capacity, uint32_t *needed);

static bool take_lists(const hsp_pores *pores, uint32_t things, get_list *get, struct lists *lists,
                       struct failure *failure) {
  lists->first = calloc((size_t)things + 1, sizeof *lists->first);
  if (lists->first == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < things; ++i) {
    uint32_t needed = 0;
    const int32_t status = get(pores, i, NULL, 0, &needed);
    if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
    lists->first[i + 1] = lists->first[i] + needed;
  }
  lists->number = calloc(lists->first[things] + 1, sizeof *lists->number);
  if (lists->number == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < things; ++i) {
    uint32_t needed = (uint32_t)(lists->first[i + 1] - lists->first[i]);
    const int32_t status = get(pores, i, lists->number + lists->first[i], needed, &needed);
    if (status != HSP_OK) return failure_in_library(failure, status);
  }
  return true;
}

static void free_lists(struct lists *lists) {
  free(lists->first);
  free(lists->number);
}

static bool take_tree(const hsp_pores *pores, struct found *found, struct failure *failure) {
  hsp_pores_counts *const counts = &found->counts;
  int32_t status = hsp_pores_get_counts(pores, counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  found->maxima = calloc((size_t)counts->maxima + 1, sizeof *found->maxima);
  found->gates = calloc((size_t)counts->gates + 1, sizeof *found->gates);
  if (found->maxima == NULL || found->gates == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_maxima(pores, 0, counts->maxima, found->maxima);
  if (status == HSP_OK) status = hsp_pores_get_gates(pores, 0, counts->gates, found->gates);
  if (status != HSP_OK) return failure_in_library(failure, status);
  return take_lists(pores, counts->maxima, hsp_pores_get_maximum_balls, &found->of_maxima, failure) &&
         take_lists(pores, counts->gates, hsp_pores_get_gate_balls, &found->of_gates, failure);
}

static bool take_channels(hsp_pores *pores, struct found *found, struct failure *failure) {
  const uint32_t gates = found->counts.gates;
  const double probe = found->request->probe;
  found->shifts = calloc((size_t)gates + 1, sizeof *found->shifts);
  if (found->shifts == NULL) return failure_of_memory(failure);
  int32_t status = hsp_pores_get_gate_shifts(pores, 0, gates, found->shifts);
  if (status == HSP_OK) status = hsp_pores_get_percolation(pores, &found->wide);
  if (status != HSP_OK) return failure_in_library(failure, status);
  status = hsp_pores_get_channels(pores, probe, NULL, 0, &found->channel_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->channels = calloc((size_t)found->channel_count + 1, sizeof *found->channels);
  if (found->channels == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_channels(pores, probe, found->channels, found->channel_count, &found->channel_count);
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool take_pockets(hsp_pores *pores, struct found *found, struct failure *failure) {
  const struct request *const request = found->request;
  uint32_t *const count = &found->pocket_count;
  int32_t status = hsp_pores_find_pockets(pores, request->probe, request->pockets, count);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--pockets: %s", geometry_reason(status));
  if (status != HSP_OK) return failure_in_library(failure, status);
  found->pockets = calloc((size_t)*count + 1, sizeof *found->pockets);
  if (found->pockets == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_pockets(pores, 0, *count, found->pockets);
  if (status != HSP_OK) return failure_in_library(failure, status);
  return take_lists(pores, *count, hsp_pores_get_pocket_mouths, &found->mouths, failure) &&
         take_lists(pores, *count, hsp_pores_get_pocket_balls, &found->lining, failure);
}

/* The point that was named, or the widest maximum at an atom. */
static bool find_start(const struct molecule *molecule, struct found *found, struct failure *failure) {
  const struct place *const place = &found->request->tunnels_from;
  memcpy(found->from, place->point.xyz, sizeof found->from);
  if (place->of_atom == 0) return true;
  const uint64_t atom = place->of_atom - 1;
  if (atom >= molecule->atoms) {
    return failure_in_input(failure, 0, "--tunnels-from: there is no atom %" PRIu64 " among %" PRIu32 ", from 0 on",
                            atom, molecule->atoms);
  }
  const size_t *const first = found->of_maxima.first;
  for (uint32_t i = 0; i < found->counts.maxima; ++i) {
    for (size_t k = first[i]; k < first[i + 1]; ++k) {
      if (found->of_maxima.number[k] != atom) continue;
      memcpy(found->from, found->maxima[i].xyz, sizeof found->from);
      return true;
    }
  }
  return failure_in_input(failure, 0, "--tunnels-from: atom %" PRIu64 " touches no largest probe", atom);
}

static bool add_steps(const hsp_pores *pores, struct found *found, struct failure *failure) {
  const uint32_t count = found->tunnels[found->tunnel_count].points;
  uint32_t needed = 0;
  struct step *const steps = realloc(found->steps, (found->step_count + count + 1) * sizeof *steps);
  if (steps != NULL) found->steps = steps;
  hsp_tunnel_point *const points = calloc((size_t)count + 1, sizeof *points);
  if (steps == NULL || points == NULL) {
    free(points);
    return failure_of_memory(failure);
  }
  const int32_t status = hsp_pores_get_tunnel_points(pores, points, count, &needed);
  double length = 0.0;
  for (uint32_t i = 0; status == HSP_OK && i < count; ++i) {
    double square = 0.0;
    for (int axis = 0; axis < 3 && i > 0; ++axis) {
      const double way = points[i].xyz[axis] - points[i - 1].xyz[axis];
      square += way * way;
    }
    length += sqrt(square);
    steps[found->step_count++] = (struct step){found->tunnel_count + 1, length, points[i]};
  }
  free(points);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The best ones, each without the bottlenecks of those before. */
static bool find_tunnels(struct geometry *geometry, const struct molecule *molecule, struct found *found,
                         struct failure *failure) {
  const uint32_t most = found->request->tunnels > 0 ? found->request->tunnels : TUNNELS;
  hsp_pore_place start;
  if (!find_start(molecule, found, failure)) return false;
  const int32_t located = hsp_pores_locate(geometry->work.pores, found->from, &start);
  if (located == HSP_E_RANGE) return failure_in_input(failure, 0, "--tunnels-from: %s", geometry_reason(located));
  if (located != HSP_OK) return failure_in_library(failure, located);
  found->room = start.radius;
  found->tunnels = calloc((size_t)most, sizeof *found->tunnels);
  uint32_t *const avoided = calloc((size_t)most, sizeof *avoided);
  bool done = (found->tunnels != NULL && avoided != NULL) || failure_of_memory(failure);
  for (uint32_t i = 0; done && i < most; ++i) {
    hsp_tunnel *const tunnel = &found->tunnels[i];
    done = geometry_find_tunnel(geometry, found->request->probe, found->from, avoided, i, tunnel, failure);
    if (!done || tunnel->there == 0) break;
    done = add_steps(geometry->work.pores, found, failure);
    found->tunnel_count = i + 1;
    if (tunnel->gate == HSP_NONE) break; /* no gate is its bottleneck: none is to be avoided */
    avoided[i] = tunnel->gate;
  }
  free(avoided);
  return done;
}

/* ---- what is printed ---- */

static const char *number_text(char *text, size_t bytes, uint32_t number) {
  if (number == HSP_NONE) return "none";
  if (number == HSP_PORE_OUTSIDE) return "outside";
  snprintf(text, bytes, "%" PRIu32, number);
  return text;
}

static void set_list(union cell *cell, const struct lists *lists, size_t row) {
  cell->counts.list = lists->number + lists->first[row];
  cell->counts.length = (uint32_t)(lists->first[row + 1] - lists->first[row]);
}

static bool maximum_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  const hsp_pore_maximum *const maximum = &found->maxima[row];
  if (maximum->radius - maximum->death < found->request->persistence) return false;
  cells[0].count = (int64_t)row;
  cells[1].vector = maximum->xyz;
  cells[2].quantity = maximum->radius;
  cells[3].quantity = maximum->death;
  cells[4].text = number_text(text, CELL_BYTES / 2, maximum->gate);
  cells[5].text = number_text(text + CELL_BYTES / 2, CELL_BYTES / 2, maximum->parent);
  set_list(&cells[6], &found->of_maxima, row);
  return true;
}

static struct table table_of_maxima(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"maximum", NULL, "maximum", 7, COLUMN_COUNT, 0},
      {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"death", NULL, "death", 9, COLUMN_QUANTITY, 4},
      {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"parent", NULL, "parent", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->counts.maxima, found, maximum_row, NULL};
}

static bool gate_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  const hsp_pore_gate *const gate = &found->gates[row];
  cells[0].count = (int64_t)row;
  cells[1].vector = gate->xyz;
  cells[2].quantity = gate->radius;
  cells[3].text = number_text(text, CELL_BYTES / 2, gate->end[0]);
  cells[4].text = number_text(text + CELL_BYTES / 2, CELL_BYTES / 2, gate->end[1]);
  cells[5].count = gate->merges;
  set_list(&cells[6], &found->of_gates, row);
  if (found->shifts == NULL) return true;
  cells[7].shift = found->shifts[row].end;
  cells[8].shift = found->shifts[row].end + 3;
  cells[9].count = found->shifts[row].directions;
  return true;
}

static struct table table_of_gates(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"gate", NULL, "gate", 7, COLUMN_COUNT, 0},
      {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"end", NULL, "end", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"other_end", NULL, "other", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"merges", NULL, "merges", 7, COLUMN_COUNT, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
      {"end_shift", NULL, "shift of end", 14, COLUMN_SHIFT, 0}, /* in a box */
      {"other_end_shift", NULL, "shift of other", 14, COLUMN_SHIFT, 0},
      {"directions", NULL, "directions", 10, COLUMN_COUNT, 0},
  };
  const int count = sizeof columns / sizeof columns[0];
  return (struct table){
      columns, found->shifts == NULL ? count - 3 : count, molecule->format, found->counts.gates, found, gate_row, NULL};
}

static bool channel_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  const hsp_pore_channel *const channel = &found->channels[row];
  size_t length = 0;
  cells[0].count = (int64_t)row + 1;
  cells[1].vector = found->maxima[channel->maximum].xyz;
  cells[2].quantity = channel->radius;
  cells[3].count = channel->maxima;
  cells[4].count = channel->directions;
  cells[5].text = text;
  snprintf(text, CELL_BYTES, "-");
  for (uint32_t r = 0; r < channel->directions && length < CELL_BYTES; ++r) {
    const int32_t *const way = channel->row + 3 * r;
    length += (size_t)snprintf(text + length, CELL_BYTES - length, "%s%" PRId32 " %" PRId32 " %" PRId32,
                               r == 0 ? "" : ", ", way[0], way[1], way[2]);
  }
  return true;
}

/* For persons. */
static struct table table_of_channels(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {NULL, "", "channel", 7, COLUMN_COUNT, 0},     {NULL, "", "x y z", 9, COLUMN_POINT, 0},
      {NULL, "", "radius", 9, COLUMN_QUANTITY, 4},   {NULL, "", "maxima", 7, COLUMN_COUNT, 0},
      {NULL, "", "directions", 10, COLUMN_COUNT, 0}, {NULL, "", "along", 8, COLUMN_TEXT, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->channel_count, found, channel_row, NULL};
}

static bool is_deep(const struct found *found, size_t pocket) {
  return found->pockets[pocket].radius - found->pockets[pocket].mouth >= found->request->persistence;
}

static bool pocket_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct found *const found = of;
  const hsp_pore_pocket *const pocket = &found->pockets[row];
  if (!is_deep(found, row)) return false;
  cells[0].count = (int64_t)row + 1;
  cells[1].vector = found->maxima[pocket->maximum].xyz;
  cells[2].quantity = pocket->radius;
  cells[3].quantity = pocket->mouth;
  cells[4].count = pocket->maximum;
  cells[5].text = number_text(text, CELL_BYTES, pocket->gate);
  cells[6].count = pocket->maxima;
  cells[7].count = pocket->mouths;
  cells[8].count = pocket->balls;
  set_list(&cells[9], &found->mouths, row);
  set_list(&cells[10], &found->lining, row);
  return true;
}

static struct table table_of_pockets(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"pocket", NULL, "pocket", 6, COLUMN_COUNT, 0},    {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4}, {"mouth_radius", NULL, "mouth", 9, COLUMN_QUANTITY, 4},
      {"maximum", NULL, "maximum", 7, COLUMN_COUNT, 0},  {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"maxima", NULL, "maxima", 7, COLUMN_COUNT, 0},    {NULL, "mouths", "mouths", 6, COLUMN_COUNT, 0},
      {NULL, "balls", "balls", 6, COLUMN_COUNT, 0},      {"mouths", "", NULL, 0, COLUMN_COUNTS, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->pocket_count, found, pocket_row, NULL};
}

static bool tunnel_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const hsp_tunnel *const tunnel = &((const struct found *)of)->tunnels[row];
  cells[0].count = (int64_t)row + 1;
  cells[1].quantity = tunnel->radius;
  cells[2].quantity = tunnel->length;
  cells[3].text = number_text(text, CELL_BYTES, tunnel->gate);
  cells[4].count = tunnel->gates;
  cells[5].count = tunnel->points;
  return true;
}

static struct table table_of_tunnels(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"tunnel", NULL, "tunnel", 6, COLUMN_COUNT, 0},     {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"length", NULL, "length", 10, COLUMN_QUANTITY, 4}, {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"gates", NULL, "gates", 6, COLUMN_COUNT, 0},       {"points", NULL, "points", 6, COLUMN_COUNT, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->tunnel_count, found, tunnel_row, NULL};
}

static bool step_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct step *const step = &((const struct found *)of)->steps[row];
  const hsp_tunnel_point *const point = &step->point;
  cells[0].count = step->tunnel;
  cells[1].quantity = step->length;
  cells[2].vector = point->xyz;
  cells[3].quantity = point->radius;
  cells[4].text = number_text(text, CELL_BYTES / 2, point->gate);
  cells[5].text = number_text(text + CELL_BYTES / 2, CELL_BYTES / 2, point->maximum);
  cells[6].counts.list = point->ball;
  cells[6].counts.length = 0;
  while (cells[6].counts.length < 4 && point->ball[cells[6].counts.length] != HSP_NONE) ++cells[6].counts.length;
  return true;
}

static struct table table_of_steps(const struct molecule *molecule, const struct found *found) {
  static const struct column columns[] = {
      {"tunnel", NULL, "tunnel", 6, COLUMN_COUNT, 0},
      {"length", NULL, "length", 10, COLUMN_QUANTITY, 4},
      {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"maximum", NULL, "maximum", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->step_count, found, step_row, NULL};
}

static void print_table(struct record *record, const struct table *table, const char *what) {
  if (record->form != FOR_PERSONS || table->rows == 0) return;
  record_line(record, "");
  record_line(record, what);
  table_print(table, record->out);
}

/* For persons. */
static void print_balls(struct record *record, const char *what, uint32_t number, const struct lists *lists,
                        size_t row) {
  union cell balls;
  set_list(&balls, lists, row);
  text_buffer_add(record->out, "\nballs around %s %" PRIu32 "\n", what, number);
  ball_rows_print(record->molecule, balls.counts.list, balls.counts.length, record->out);
}

/* Of three diameters of JSON, null where no probe gets through. */
static void set_diameters(double out[3], const double radius[3], const uint32_t gate[3]) {
  for (int d = 0; d < 3; ++d) out[d] = gate[d] == HSP_NONE ? (double)NAN : 2.0 * radius[d];
}

static void print_box(struct record *record, const struct found *found) {
  static const char *const titles[2][3] = {{"pore limit, 1-d", "pore limit, 2-d", "pore limit, 3-d"},
                                           {"along the first", "along the second", "along the third"}};
  static const char *const remarks[2][3] = {
      {"@, the diameter up to which probes go on for ever in one direction", "@, in two directions",
       "@, in three directions"},
      {"@, and so along the first vector of the box", "@, along the second one", "@, along the third one"}};
  const hsp_pore_percolation *const wide = &found->wide;
  const bool persons = record->form == FOR_PERSONS;
  double through[3], included[3], along[3];
  set_diameters(through, wide->through, wide->gate);
  set_diameters(included, wide->included, wide->gate);
  set_diameters(along, wide->along, wide->gate_along);
  record_numbers(record, "pore_limiting_diameter", through, 3);
  record_numbers(record, "included_cavity_diameter", included, 3);
  record_numbers(record, "pore_limiting_diameter_along", along, 3);
  for (int k = 0; persons && k < 6; ++k) {
    record_number(record, NULL, titles[k / 3][k % 3], k < 3 ? through[k] : along[k - 3], 8, remarks[k / 3][k % 3]);
  }
  if (persons) {
    record_number(record, NULL, "included cavity", included[0], 8,
                  "@, the diameter of the widest probe in the 1-d channel");
  }
  if (!record_key(record, "channel_list")) return;
  text_buffer_add_text(record->out, "[");
  for (uint32_t c = 0; c < found->channel_count; ++c) {
    const hsp_pore_channel *const channel = &found->channels[c];
    text_buffer_add(record->out, "%s{\"radius\": ", c == 0 ? "" : ", ");
    json_number(record->out, channel->radius);
    text_buffer_add(record->out, ", \"maximum\": %" PRIu32 ", \"maxima\": %" PRIu32 ", ", channel->maximum,
                    channel->maxima);
    directions_json(record->out, channel->directions, channel->copies, channel->row);
    text_buffer_add_text(record->out, "}");
  }
  text_buffer_add_text(record->out, "]");
}

static bool lists_balls(const struct record *record, const struct found *found) {
  return record->form == FOR_PERSONS && found->request->void_balls;
}

static void print(struct record *record, const void *of) {
  const struct found *const found = of;
  const struct request *const request = found->request;
  const struct molecule *const molecule = record->molecule;
  const hsp_pores_counts *const counts = &found->counts;
  const bool persons = record->form == FOR_PERSONS, pockets = request->pockets >= 0.0;
  const bool tunnels = request->tunnels_from.point.given;
  const struct table maxima = table_of_maxima(molecule, found), gates = table_of_gates(molecule, found);
  const struct table pocket_table = table_of_pockets(molecule, found);
  const struct table tunnel_table = table_of_tunnels(molecule, found), steps = table_of_steps(molecule, found);
  const struct table channels = table_of_channels(molecule, found);
  record_atoms(record);
  if (is_boxed(request)) periodic_result_record_box(record, &found->box);
  record_number(record, "largest_cavity_diameter", "largest cavity",
                counts->maxima > 0 ? 2.0 * found->maxima[0].radius : (double)NAN, 8,
                "@, the diameter of the widest probe in it");
  if (is_boxed(request)) print_box(record, found);
  record_count(record, "maxima", "maxima", counts->maxima, "where a probe fits best, each the birth of a class");
  record_count(record, "gates", "gates", counts->gates, "where parts of free space meet");
  record_count(record, "merges", "merges", counts->merges, "gates where a class ends in an older one");
  record_count(record, "cavities", "cavities", counts->cavities,
               is_boxed(request) ? "classes that meet no other one, channels too"
                                 : "classes that no such probe gets into or out of");
  if (!persons) {
    record_table(record, "maximum_list", &maxima);
    record_table(record, "gate_list", &gates);
  } else if (is_boxed(request) && !request->gates) {
    print_table(record, &channels, "  a channel: its widest probe, in @, and where it goes on for ever, by vectors");
  } else if (!request->gates && !pockets && !tunnels) {
    print_table(record, &maxima, "  a class: the radius of the widest probe in it, and of that which merges it, in @");
  }
  if (persons && request->gates) print_table(record, &gates, "  narrower probes than radius, in @, pass");
  if (pockets) {
    record_count(record, "pockets", "pockets", found->pocket_count, "where the probe fits that --pockets keeps out");
    if (!persons) record_table(record, "pocket_list", &pocket_table);
    print_table(record, &pocket_table,
                "  x y z: where the widest probe fits; its radius and that of the widest mouth, in @");
    for (uint32_t i = 0; lists_balls(record, found) && i < found->pocket_count; ++i) {
      if (is_deep(found, i)) print_balls(record, "pocket", i + 1, &found->lining, i);
    }
  }
  if (!tunnels) return;
  if (persons && (request->gates || pockets)) record_line(record, "");
  record_numbers(record, "from", found->from, 3);
  record_number(record, "from_radius", "start", found->room, 8, "@, the radius of the largest probe there");
  record_count(record, "tunnels", "tunnels", found->tunnel_count, "to the outside, each by another bottleneck");
  if (!persons) record_table(record, "tunnel_list", &tunnel_table);
  if (!persons) record_table(record, "tunnel_points", &steps);
  print_table(record, &tunnel_table, "  the widest probe that gets through, and how far it goes, in @");
  for (uint32_t i = 0; lists_balls(record, found) && i < found->tunnel_count; ++i) {
    const uint32_t gate = found->tunnels[i].gate;
    if (gate != HSP_NONE) print_balls(record, "the bottleneck of tunnel", i + 1, &found->of_gates, gate);
  }
  print_table(record, &steps, "  along the tunnels: the way so far, and the largest probe there, in @");
}

static struct table table_of(const struct molecule *molecule, const struct found *found) {
  const struct request *const request = found->request;
  return request->gates                      ? table_of_gates(molecule, found)
         : request->pockets >= 0.0           ? table_of_pockets(molecule, found)
         : request->tunnels_from.point.given ? table_of_steps(molecule, found)
                                             : table_of_maxima(molecule, found);
}

bool check_pores(struct request *request, struct failure *failure) {
  const bool pockets = request->pockets >= 0.0, from = request->tunnels_from.point.given;
  if (is_boxed(request) && (pockets || from)) {
    return failure_in_usage(failure, "%s is not for a --box", pockets ? "--pockets" : "--tunnels-from");
  }
  if (request->tunnels > 0 && !from) return failure_in_usage(failure, "--tunnels needs --tunnels-from");
  if (pockets && request->pockets < request->probe) {
    return failure_in_usage(failure, "--pockets: W must not be less than --probe");
  }
  if (request->void_balls && !pockets && !from) {
    return failure_in_usage(failure, "--balls needs --pockets or --tunnels-from");
  }
  if (!request->csv || (int)request->gates + (int)pockets + (int)from < 2) return true;
  return failure_in_usage(failure, "--csv prints one table: either --gates, --pockets or --tunnels-from");
}

bool command_pores(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  struct found found = {.request = request};
  const bool boxed = is_boxed(request);
  const bool done = (!boxed || periodic_result_find_box(request, molecule, &found.box, failure)) &&
                    (boxed ? geometry_find_pores_in_box(geometry, molecule, found.box.box, request->probe, failure)
                           : geometry_find_pores(geometry, molecule, request->probe, failure)) &&
                    take_tree(geometry->work.pores, &found, failure) &&
                    (!boxed || take_channels(geometry->work.pores, &found, failure)) &&
                    (request->pockets < 0.0 || take_pockets(geometry->work.pores, &found, failure)) &&
                    (!request->tunnels_from.point.given || find_tunnels(geometry, molecule, &found, failure));
  if (done && request->csv) {
    const struct table table = table_of(molecule, &found);
    table_csv(&table, out);
  } else if (done) {
    report(request, molecule, print, &found, out);
  }
  free_lists(&found.of_maxima);
  free_lists(&found.of_gates);
  free_lists(&found.mouths);
  free_lists(&found.lining);
  free(found.maxima);
  free(found.gates);
  free(found.pockets);
  free(found.tunnels);
  free(found.steps);
  free(found.shifts);
  free(found.channels);
  return done;
}
