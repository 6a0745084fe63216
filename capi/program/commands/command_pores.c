/* hardsphere pores: free space for every probe at once: maxima, gates and their classes, pockets and tunnels. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "commands/followed_run.h"
#include "commands/framework_units.h"
#include "commands/input_report.h"
#include "commands/pores_found.h"
#include "write/ball_label.h"

static bool is_boxed(const struct request *request) {
  return request->box.source != BOX_NONE;
}

static const char *number_text(char *text, size_t bytes, uint32_t number) {
  if (number == HSP_NONE) return "none";
  if (number == HSP_PORE_OUTSIDE) return "outside";
  snprintf(text, bytes, "%" PRIu32, number);
  return text;
}

static void set_list(union cell *cell, const struct number_lists *lists, size_t row) {
  cell->counts.list = lists->number + lists->first[row];
  cell->counts.length = (uint32_t)(lists->first[row + 1] - lists->first[row]);
}

static bool maximum_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct pores_found *const found = of;
  const hsp_pore_maximum *const maximum = &found->maxima[row];
  if (!pores_lists_maximum(found, row)) return false;
  cells[0].count = (int64_t)row;
  cells[1].vector = maximum->xyz;
  cells[2].quantity = maximum->radius;
  cells[3].quantity = maximum->death;
  cells[4].text = number_text(text, CELL_BYTES / 2, maximum->gate);
  cells[5].text = number_text(text + CELL_BYTES / 2, CELL_BYTES / 2, maximum->parent);
  set_list(&cells[6], &found->of_maxima, row);
  return true;
}

static struct table table_of_maxima(const struct molecule *molecule, const struct pores_found *found) {
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
  const struct pores_found *const found = of;
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

static struct table table_of_gates(const struct molecule *molecule, const struct pores_found *found) {
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

/* "1 0 0, 0 1 0", or "-". */
static const char *ways_text(char text[CELL_BYTES], uint32_t directions, const int32_t row[9]) {
  size_t length = 0;
  snprintf(text, CELL_BYTES, "-");
  for (uint32_t r = 0; r < directions && length < CELL_BYTES; ++r) {
    const int32_t *const way = row + 3 * r;
    length += (size_t)snprintf(text + length, CELL_BYTES - length, "%s%" PRId32 " %" PRId32 " %" PRId32,
                               r == 0 ? "" : ", ", way[0], way[1], way[2]);
  }
  return text;
}

static bool channel_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct pores_found *const found = of;
  const hsp_pore_channel *const channel = &found->channels[row];
  cells[0].count = (int64_t)row + 1;
  cells[1].vector = found->maxima[channel->maximum].xyz;
  cells[2].quantity = channel->radius;
  cells[3].count = channel->maxima;
  cells[4].count = channel->directions;
  cells[5].text = ways_text(text, channel->directions, channel->row);
  return true;
}

/* For persons. */
static struct table table_of_channels(const struct molecule *molecule, const struct pores_found *found) {
  static const struct column columns[] = {
      {NULL, "", "channel", 7, COLUMN_COUNT, 0},     {NULL, "", "x y z", 9, COLUMN_POINT, 0},
      {NULL, "", "radius", 9, COLUMN_QUANTITY, 4},   {NULL, "", "maxima", 7, COLUMN_COUNT, 0},
      {NULL, "", "directions", 10, COLUMN_COUNT, 0}, {NULL, "", "along", 8, COLUMN_TEXT, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->channel_count, found, channel_row, NULL};
}

/* The radius is that of the whole probe, as for all things that are listed here. */
static bool region_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct pores_found *const found = of;
  const hsp_pore_region *const region = &found->regions[row];
  cells[0].count = (int64_t)row + 1;
  cells[1].vector = region->maximum == HSP_PORE_OUTSIDE ? NULL : found->widest[row].xyz;
  cells[2].quantity = region->radius + found->request->probe;
  cells[3].text = region->accessible ? "accessible" : "blocked";
  cells[4].quantity = region->area;
  cells[5].quantity = region->volume;
  cells[6].count = region->directions;
  cells[7].count = region->maxima;
  cells[8].count = region->shells;
  cells[9].text = ways_text(text, region->directions, region->row);
  return true;
}

static struct table table_of_regions(const struct molecule *molecule, const struct pores_found *found) {
  static const struct column columns[] = {
      {"region", NULL, "region", 6, COLUMN_COUNT, 0},          {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},       {"access", NULL, "access", 10, COLUMN_TEXT, 0},
      {"area", NULL, "area", 11, COLUMN_QUANTITY, 4},          {"volume", NULL, "volume", 11, COLUMN_QUANTITY, 4},
      {"directions", NULL, "directions", 10, COLUMN_COUNT, 0}, {"maxima", NULL, "maxima", 7, COLUMN_COUNT, 0},
      {"shells", NULL, "shells", 6, COLUMN_COUNT, 0},          {"along", NULL, "along", 8, COLUMN_TEXT, 0},
  };
  return (struct table){
      columns, sizeof columns / sizeof columns[0], molecule->format, found->region_count, found, region_row, NULL};
}

static bool pocket_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct pores_found *const found = of;
  const uint32_t number = found->listed[row].pocket;
  const hsp_pore_pocket *const pocket = &found->pockets[number];
  const hsp_pore_pocket_size *const size = &found->sizes[number];
  cells[0].count = (int64_t)number + 1;
  cells[1].vector = found->maxima[pocket->maximum].xyz;
  cells[2].quantity = pocket->radius;
  cells[3].quantity = pocket->mouth;
  cells[4].count = pocket->maximum;
  cells[5].text = number_text(text, CELL_BYTES / 2, pocket->gate);
  cells[6].count = pocket->maxima;
  cells[7].count = pocket->mouths;
  cells[8].count = pocket->balls;
  cells[9].quantity = size->volume;
  cells[10].quantity = size->area;
  cells[11].count = size->closed;
  set_list(&cells[12], &found->mouths, number);
  set_list(&cells[13], &found->lining, number);
  if (found->followed != NULL) followed_cells(&found->followed[row], &cells[0], &cells[14], text);
  return true;
}

static struct table table_of_pockets(const struct molecule *molecule, const struct pores_found *found) {
  static const struct column columns[] = {
      {"pocket", NULL, "pocket", 6, COLUMN_COUNT, 0},
      {"xyz", "x,y,z", "x y z", 9, COLUMN_POINT, 0},
      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"mouth_radius", NULL, "mouth", 9, COLUMN_QUANTITY, 4},
      {"maximum", NULL, "maximum", 7, COLUMN_COUNT, 0},
      {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0},
      {"maxima", NULL, "maxima", 7, COLUMN_COUNT, 0},
      {NULL, "mouths", "mouths", 6, COLUMN_COUNT, 0},
      {NULL, "balls", "balls", 6, COLUMN_COUNT, 0},
      {"volume", NULL, "volume", 9, COLUMN_QUANTITY, 4},
      {"area", NULL, "area", 9, COLUMN_QUANTITY, 4},
      {"closed", NULL, NULL, 0, COLUMN_COUNT, 0},
      {"mouths", "", NULL, 0, COLUMN_COUNTS, 0},
      {"balls", "", NULL, 0, COLUMN_COUNTS, 0},
      FOLLOWED_COLUMNS,
  };
  const int count = sizeof columns / sizeof columns[0] - (found->followed == NULL ? FOLLOWED : 0);
  return (struct table){columns, count, molecule->format, found->listed_count, found, pocket_row, NULL};
}

static bool tunnel_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct pores_found *const found = of;
  const hsp_tunnel *const tunnel = &found->tunnels[row];
  cells[0].count = (int64_t)row + 1;
  cells[1].quantity = tunnel->radius;
  cells[2].quantity = tunnel->length;
  cells[3].quantity = found->routes[row].cost;
  cells[4].text = number_text(text, CELL_BYTES, tunnel->gate);
  cells[5].count = tunnel->gates;
  cells[6].count = tunnel->points;
  cells[7].shift = found->routes[row].shift;
  return true;
}

static struct table table_of_tunnels(const struct molecule *molecule, const struct pores_found *found) {
  static const struct column columns[] = {
      {"tunnel", NULL, "tunnel", 6, COLUMN_COUNT, 0},      {"radius", NULL, "radius", 9, COLUMN_QUANTITY, 4},
      {"length", NULL, "length", 10, COLUMN_QUANTITY, 4},  {"cost", NULL, "cost", 9, COLUMN_QUANTITY, 4},
      {"gate", NULL, "gate", 7, COLUMN_RESIDUE_NUMBER, 0}, {"gates", NULL, "gates", 6, COLUMN_COUNT, 0},
      {"points", NULL, "points", 6, COLUMN_COUNT, 0},      {"shift", NULL, "shift", 14, COLUMN_SHIFT, 0}, /* in a box */
  };
  const int count = sizeof columns / sizeof columns[0];
  return (struct table){
      columns, found->shifts == NULL ? count - 1 : count, molecule->format, found->tunnel_count, found, tunnel_row,
      NULL};
}

static bool step_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct tunnel_step *const step = &((const struct pores_found *)of)->steps[row];
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

static struct table table_of_steps(const struct molecule *molecule, const struct pores_found *found) {
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
static void print_balls(struct record *record, const char *what, uint32_t number, const struct number_lists *lists,
                        size_t row) {
  union cell balls;
  set_list(&balls, lists, row);
  text_buffer_add(record->out, "\nballs around %s %" PRIu32 "\n", what, number);
  ball_rows_print(record->molecule, balls.counts.list, balls.counts.length, record->out);
}

/* The three diameters in JSON, null if no probe passes. */
static void set_diameters(double out[3], const double radius[3], const uint32_t gate[3]) {
  for (int d = 0; d < 3; ++d) out[d] = gate[d] == HSP_NONE ? (double)NAN : 2.0 * radius[d];
}

static void print_box(struct record *record, const struct pores_found *found) {
  static const char *const titles[2][3] = {{"pore limit, 1-d", "pore limit, 2-d", "pore limit, 3-d"},
                                           {"along the first", "along the second", "along the third"}};
  static const char *const remarks[2][3] = {
      {"@, the diameter up to which probes go on for ever in one direction", "@, in two directions",
       "@, in three directions"},
      {"@, and so along the first vector of the box", "@, along the second one", "@, along the third one"}};
  static const char *const keys[] = {"pore_limiting_diameter_1d", "pore_limiting_diameter_2d",
                                     "pore_limiting_diameter_3d"};
  const hsp_pore_percolation *const wide = &found->wide;
  const bool persons = record->form == FOR_PERSONS, line = !persons && record->form != AS_JSON;
  double through[3], included[3], along[3];
  set_diameters(through, wide->through, wide->gate);
  set_diameters(included, wide->included, wide->gate);
  set_diameters(along, wide->along, wide->gate_along);
  record_numbers(record, "pore_limiting_diameter", through, 3);
  if (record_is_row(record)) record_number(record, "pore_limiting_diameter", NULL, through[0], 0, "");
  record_numbers(record, "included_cavity_diameter", included, 3);
  record_numbers(record, "pore_limiting_diameter_along", along, 3);
  for (int k = 0; (persons && k < 6) || (line && k < 3); ++k) {
    record_number(record, line ? keys[k] : NULL, titles[k / 3][k % 3], k < 3 ? through[k] : along[k - 3], 8,
                  remarks[k / 3][k % 3]);
  }
  if (persons || line) {
    record_number(record, line ? "included_cavity_diameter" : NULL, "included cavity", included[0], 8,
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

static void record_as_framework(struct record *record, const struct pores_found *found) {
  const hsp_pore_access *const access = &found->access;
  const struct framework framework = framework_of(record->molecule, found->box.box);
  framework_record(record, &framework, (struct pore_sizes){access->accessible_area, access->accessible_volume},
                   (struct pore_sizes){access->blocked_area, access->blocked_volume});
}

static void print_regions(struct record *record, const struct pores_found *found) {
  const hsp_pore_access *const access = &found->access;
  const struct table table = table_of_regions(record->molecule, found);
  record_number(record, "accessible_area", "reached area", access->accessible_area, 4,
                "@^2, of the balls grown by the probe, where it gets to");
  record_number(record, "accessible_volume", "reached volume", access->accessible_volume, 4,
                "@^3, of places of its centre");
  record_number(record, "blocked_area", "blocked area", access->blocked_area, 4,
                "@^2, where it fits and does not get to");
  record_number(record, "blocked_volume", "blocked volume", access->blocked_volume, 4, "@^3, likewise");
  record_count(record, "accessible_regions", "reached regions", access->accessible,
               is_boxed(found->request) ? "that go on for ever" : "the outside");
  record_count(record, "blocked_regions", "blocked regions", access->blocked, "that end on all sides");
  if (is_boxed(found->request)) record_as_framework(record, found);
  if (record->form != FOR_PERSONS) record_table(record, "region_list", &table);
  print_table(record, &table, "  a region: its widest probe; area in @^2, volume in @^3");
}

/* The main ones, in a row for persons. */
static void print_short(struct record *record, const struct pores_found *found) {
  const hsp_pores_counts *const counts = &found->counts;
  double through[3];
  record_number(record, "cavity", NULL, counts->maxima > 0 ? 2.0 * found->maxima[0].radius : (double)NAN, 0, "");
  set_diameters(through, found->wide.through, found->wide.gate);
  if (is_boxed(found->request)) record_number(record, "pore limit", NULL, through[0], 0, "");
  if (found->request->pores.regions && is_boxed(found->request)) {
    record_as_framework(record, found);
  } else {
    record_count(record, "maxima", NULL, counts->maxima, "");
    record_count(record, "cavities", NULL, counts->cavities, "");
  }
}

static bool lists_balls(const struct record *record, const struct pores_found *found) {
  return record->form == FOR_PERSONS && found->request->pores.balls;
}

/* Columns in the row of a frame: the sum of all known volumes, and the largest pocket. */
static void record_pocket_sums(struct record *record, const struct pores_found *found) {
  double volume = 0.0;
  for (uint32_t i = 0; i < found->listed_count; ++i) volume += fmax(found->listed[i].volume, 0.0);
  const bool any = found->listed_count > 0 && found->listed[0].volume >= 0.0;
  const bool follows = found->followed != NULL; /* in a trajectory; else the list's numbers serve */
  const double largest = !any      ? (double)NAN
                         : follows ? (double)found->followed[0].number
                                   : (double)found->listed[0].pocket + 1.0;
  record_number(record, "pocket_volume", NULL, volume, 0, "");
  record_number(record, "largest_pocket", NULL, largest, 0, "");
  record_number(record, "largest_pocket_volume", NULL, any ? found->listed[0].volume : (double)NAN, 0, "");
}

static void print_pockets(struct record *record, const struct pores_found *found) {
  const bool persons = record->form == FOR_PERSONS;
  const struct table table = table_of_pockets(record->molecule, found);
  uint32_t empty = 0;
  for (uint32_t i = 0; i < found->listed_count; ++i) empty += found->listed[i].volume == 0.0 ? 1 : 0;
  record_count(record, "pockets", "pockets", found->pocket_count, "where the probe fits that --pockets keeps out");
  record_count(record, "smaller", found->smaller > 0 ? "smaller" : NULL, found->smaller,
               "not listed: smaller than --min-volume");
  record_count(record, NULL, empty > 0 ? "of volume 0" : NULL, empty,
               "hardly wider than their mouths: the balls that fill these fill them, too");
  if (!persons) record_table(record, "pocket_list", &table);
  if (record_is_row(record)) record_pocket_sums(record, found);
  print_table(
      record, &table,
      "  x y z: where the widest probe fits; its radius, and the widest mouth's, in @; volume in @^3, area in @^2");
  for (uint32_t i = 0; lists_balls(record, found) && i < found->listed_count; ++i) {
    const uint32_t pocket = found->listed[i].pocket;
    print_balls(record, "pocket", pocket + 1, &found->lining, pocket);
  }
}

static void print(struct record *record, const void *of) {
  const struct pores_found *const found = of;
  const struct request *const request = found->request;
  const struct molecule *const molecule = record->molecule;
  const hsp_pores_counts *const counts = &found->counts;
  const bool persons = record->form == FOR_PERSONS, pockets = request->pores.pockets >= 0.0;
  const bool tunnels = request->pores.tunnels_from.point.given;
  const struct table maxima = table_of_maxima(molecule, found), gates = table_of_gates(molecule, found);
  const struct table tunnel_table = table_of_tunnels(molecule, found), steps = table_of_steps(molecule, found);
  const struct table channels = table_of_channels(molecule, found);
  record_atoms(record);
  if (record->aligned) {
    print_short(record, found);
    return;
  }
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
  } else if (request->pores.regions) {
    /* The list of regions follows. */
  } else if (is_boxed(request) && !request->pores.gates && !pockets && !tunnels) {
    print_table(record, &channels, "  a channel: its widest probe, in @, and where it goes on for ever, by vectors");
  } else if (!request->pores.gates && !pockets && !tunnels) {
    print_table(record, &maxima, "  a class: the radius of the widest probe in it, and of that which merges it, in @");
  }
  if (request->pores.regions) print_regions(record, found);
  if (persons && request->pores.gates) print_table(record, &gates, "  narrower probes than radius, in @, pass");
  if (pockets) print_pockets(record, found);
  if (!tunnels) return;
  if (persons && (request->pores.gates || request->pores.regions || pockets)) record_line(record, "");
  const bool ends = request->pores.tunnels_to.point.given;
  record_numbers(record, "from", found->from, 3);
  record_numbers(record, "to", ends ? found->to : NULL, 3);
  record_number(record, "from_radius", "start", found->room, 8, "@, the radius of the largest probe there");
  record_count(record, "tunnels", "tunnels", found->tunnel_count,
               ends                ? "to that point, each by another bottleneck"
               : is_boxed(request) ? "to a copy of the start, each by another bottleneck"
                                   : "to the outside, each by another bottleneck");
  if (record_is_row(record)) {
    const hsp_tunnel *const best = found->tunnel_count > 0 ? found->tunnels : NULL;
    record_number(record, "tunnel_radius", NULL, best == NULL ? (double)NAN : best->radius, 0, "");
    record_number(record, "tunnel_length", NULL, best == NULL ? (double)NAN : best->length, 0, "");
  }
  if (!persons) record_table(record, "tunnel_list", &tunnel_table);
  if (!persons) record_table(record, "tunnel_points", &steps);
  print_table(record, &tunnel_table,
              "  the widest probe that gets through, and how far it goes, in @; its cost, in 1/@");
  for (uint32_t i = 0; lists_balls(record, found) && i < found->tunnel_count; ++i) {
    const uint32_t gate = found->tunnels[i].gate;
    if (gate != HSP_NONE) print_balls(record, "the bottleneck of tunnel", i + 1, &found->of_gates, gate);
  }
  print_table(record, &steps, "  along the tunnels: the way so far, and the largest probe there, in @");
}

static struct table table_of(const struct molecule *molecule, const struct pores_found *found) {
  const struct request *const request = found->request;
  return request->pores.gates                      ? table_of_gates(molecule, found)
         : request->pores.regions                  ? table_of_regions(molecule, found)
         : request->pores.pockets >= 0.0           ? table_of_pockets(molecule, found)
         : request->pores.tunnels_from.point.given ? table_of_steps(molecule, found)
                                                   : table_of_maxima(molecule, found);
}

bool check_pores(struct request *request, struct failure *failure) {
  const struct pores_request *const pores = &request->pores;
  const bool pockets = pores->pockets >= 0.0, from = pores->tunnels_from.point.given;
  const int lists = (int)pores->gates + (int)pores->regions + (int)pockets + (int)from;
  const struct usage_rule rules[] = {
      {pores->tunnels > 0 && !from, "--tunnels needs --tunnels-from"},
      {pores->tunnels_to.point.given && !from, "--tunnels-to needs --tunnels-from"},
      {pores->cheapest && !from, "--cheapest needs --tunnels-from"},
      {pores->min_volume > 0.0 && !pockets, "--min-volume needs --pockets"},
      {request->plot != NULL && !pockets, "--plot needs --pockets"},
      {pockets && pores->pockets < request->probe, "--pockets: W must not be less than --probe"},
      {pores->tunnels_out != NULL && !from, "--tunnels-out needs --tunnels-from"},
      {pores->profile != NULL && !from, "--profile needs --tunnels-from"},
      {pores->balls && !pockets && !from, "--balls needs --pockets or --tunnels-from"},
      {request->csv && lists > 1, "--csv prints one table: either --gates, --regions, --pockets or --tunnels-from"},
  };
  return usage_rules_hold(rules, sizeof rules / sizeof rules[0], failure);
}

void describe_pores(const struct request *request, struct record *record) {
  static hsp_pore_gate_shifts some[1];
  const struct pores_found none = {.request = request, .shifts = is_boxed(request) ? some : NULL};
  print(record, &none);
}

static void write(const struct request *request, const struct molecule *molecule, const struct pores_found *found,
                  struct text_buffer *out) {
  if (request->csv) {
    const struct table table = table_of(molecule, found);
    report_list(molecule, &table, out);
  } else if (!request_prints_file(request)) {
    report(request, molecule, print, found, out);
  }
}

bool command_pores(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  struct pores_found found = {.request = request};
  const bool done = pores_find(molecule, geometry, &found, failure) && pores_write_files(&found, molecule, failure);
  if (done) write(request, molecule, &found, out);
  pores_free(&found);
  return done;
}

/* ---- a trajectory ---- */

static bool find_in_frame(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
                          struct failure *failure) {
  struct pores_found *const found = findings;
  found->request = ((const struct followed_run *)of)->request;
  return pores_find(molecule, geometry, found, failure);
}

static bool follow(struct followed_run *run, const struct molecule *molecule, struct pores_found *found,
                   struct failure *failure) {
  found->followed = calloc((size_t)found->listed_count + 1, sizeof *found->followed);
  if (found->followed == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < found->listed_count; ++i) {
    const uint32_t pocket = found->listed[i].pocket;
    union cell balls;
    set_list(&balls, &found->lining, pocket);
    found->followed[i] = (struct cavity){
        .balls = balls.counts.list, .ball_count = balls.counts.length, .volume = found->sizes[pocket].volume};
  }
  return followed_take(&run->followed, molecule, found->followed, found->listed_count, failure);
}

static bool take_frame(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
                       struct failure *failure) {
  struct followed_run *const run = of;
  if (run->request->pores.pockets >= 0.0 && !follow(run, molecule, findings, failure)) return false;
  write(run->request, molecule, findings, out);
  return true;
}

static void clear(void *findings) {
  pores_free(findings);
}

bool pores_of_run(const struct request *request, const struct molecule *molecule, struct text_buffer *out,
                  double *largest_rounding, struct failure *failure) {
  const struct frame_work work = {
      .bytes = sizeof(struct pores_found), .find = find_in_frame, .take = take_frame, .clear = clear};
  (void)out;
  return follow_run(request, molecule, work, "pocket", largest_rounding, failure);
}
