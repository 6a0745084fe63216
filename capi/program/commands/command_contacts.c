/* hardsphere contacts: which balls touch and by how much, what residues or chains have in contact, and each ball's cell
 * of the union. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/periodic_result.h"
#include "draw/contact_map.h"
#include "write/ball_label.h"
#include "write/csv.h"
#include "write/output_file.h"
#include "write/report.h"

/* All that is printed. Arrays that were not asked for are NULL. */
struct findings {
  hsp_totals totals;
  struct periodic_result box; /* if there is one; then contacts are of balls and images, moved by shifts */
  hsp_contact *contacts;      /* [contact_count] */
  int32_t *shift;             /* [contact_count][3], of the second ball */
  uint32_t contact_count;
  struct atom_groups groups;
  uint32_t *group_of;         /* [atoms] */
  hsp_group_contact *between; /* [between_count] */
  uint32_t between_count;
  double *cell, *free_area, *area; /* [atoms] */
};

static void findings_free(struct findings *found) {
  atom_groups_free(&found->groups);
  periodic_result_free(&found->box);
  free(found->contacts);
  free(found->shift);
  free(found->group_of);
  free(found->between);
  free(found->cell);
  free(found->free_area);
  free(found->area);
}

static bool find_contacts(const struct geometry *geometry, struct findings *found, struct failure *failure) {
  int32_t status = hsp_contacts_get(geometry->work.contacts, NULL, 0, &found->contact_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->contacts = calloc((size_t)found->contact_count + 1, sizeof *found->contacts);
  if (found->contacts == NULL) return failure_of_memory(failure);
  status = hsp_contacts_get(geometry->work.contacts, found->contacts, found->contact_count, &found->contact_count);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* A ball that touches its own image has that contact on two sides. */
static bool find_cells_in_box(const struct molecule *molecule, struct findings *found, struct failure *failure) {
  const int32_t status =
      hsp_periodic_measure(found->box.periodic, NULL, found->free_area, found->cell, molecule->atoms, NULL);
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    for (int side = 0; side < 2; ++side) found->area[found->contacts[k].ball[side]] += found->contacts[k].area;
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool find_cells(const struct molecule *molecule, const struct geometry *geometry, struct findings *found,
                       struct failure *failure) {
  const uint32_t n = molecule->atoms;
  found->cell = calloc((size_t)n + 1, sizeof *found->cell);
  found->free_area = calloc((size_t)n + 1, sizeof *found->free_area);
  found->area = calloc((size_t)n + 1, sizeof *found->area);
  if (found->cell == NULL || found->free_area == NULL || found->area == NULL) return failure_of_memory(failure);
  if (found->box.periodic != NULL) return find_cells_in_box(molecule, found, failure);
  int32_t status = hsp_contacts_measure(geometry->work.contacts, NULL, found->cell, found->area, n, NULL);
  if (status == HSP_OK) {
    status = hsp_boundary_measure(geometry->work.boundary, NULL, NULL, found->free_area, NULL, n, NULL);
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Contacts in a box, as those of a molecule and shifts beside them. */
static bool find_contacts_in_box(struct findings *found, struct failure *failure) {
  const uint32_t count = found->contact_count = found->box.counts.contacts;
  uint32_t needed = 0;
  hsp_periodic_contact *list = calloc((size_t)count + 1, sizeof *list);
  found->contacts = calloc((size_t)count + 1, sizeof *found->contacts);
  found->shift = calloc((size_t)count + 1, 3 * sizeof *found->shift);
  const bool room = list != NULL && found->contacts != NULL && found->shift != NULL;
  const int32_t status = room ? hsp_periodic_get_contacts(found->box.periodic, list, count, &needed) : HSP_E_MEMORY;
  for (uint32_t k = 0; status == HSP_OK && k < count; ++k) {
    hsp_contact *contact = &found->contacts[k];
    contact->area = list[k].area;
    contact->edge = list[k].edge;
    contact->distance = list[k].distance;
    memcpy(contact->ball, list[k].ball, sizeof contact->ball);
    memcpy(found->shift + 3 * (size_t)k, list[k].shift, sizeof list[k].shift);
  }
  free(list);
  found->totals.area = found->box.totals.contact_area;
  found->totals.volume = found->box.totals.volume;
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The number of each atom's residue or chain. */
static bool number_groups(const struct molecule *molecule, struct findings *found, struct failure *failure) {
  if (found->groups.grouping == GROUPING_CHAIN) return chain_numbers_make(molecule, &found->group_of, failure);
  found->group_of = calloc((size_t)molecule->atoms + 1, sizeof *found->group_of);
  if (found->group_of == NULL) return failure_of_memory(failure);
  uint32_t atom = 0;
  for (uint32_t g = 0; g < found->groups.count; ++g) {
    for (uint32_t k = 0; k < found->groups.group[g].atoms; ++k) found->group_of[atom++] = g;
  }
  return true;
}

/* Into found->between, and how many there are into found->between_count. */
static int32_t between_groups(const struct geometry *geometry, struct findings *found, uint32_t capacity) {
  uint32_t *const count = &found->between_count;
  if (found->box.periodic != NULL) {
    return hsp_periodic_group_contacts(geometry->periodic, found->group_of, found->between, capacity, count);
  }
  return hsp_contacts_group(geometry->work.contacts, found->group_of, found->between, capacity, count);
}

static bool find_groups(const struct request *request, const struct molecule *molecule, const struct geometry *geometry,
                        struct findings *found, struct failure *failure) {
  double *const nothing = calloc((size_t)molecule->atoms + 1, sizeof *nothing);
  if (nothing == NULL) return failure_of_memory(failure);
  const bool done = atom_groups_make(molecule, request->by, nothing, &found->groups, failure) &&
                    number_groups(molecule, found, failure);
  free(nothing);
  if (!done) return false;
  int32_t status = between_groups(geometry, found, 0);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->between = calloc((size_t)found->between_count + 1, sizeof *found->between);
  if (found->between == NULL) return failure_of_memory(failure);
  status = between_groups(geometry, found, found->between_count);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* "A:THR:1" or "A", as far as the file says. */
enum { GROUP_NAME_BYTES = 2 * RESIDUE_TEXT_BYTES };
static const char *group_name(char out[GROUP_NAME_BYTES], const struct molecule *molecule,
                              const struct atom_groups *groups, uint32_t group) {
  const struct residue_label *label = &molecule->label[groups->group[group].first].residue;
  if (groups->grouping == GROUPING_CHAIN) {
    snprintf(out, GROUP_NAME_BYTES, "%s", label->chain);
  } else {
    snprintf(out, GROUP_NAME_BYTES, "%s:%s:%s%s", label->chain, label->name, label->number, label->insertion);
  }
  return out;
}

static void between_json(const struct request *request, const struct molecule *molecule, const struct findings *found,
                         struct text_buffer *out) {
  char name[GROUP_NAME_BYTES];
  const char *separator = "";
  for (uint32_t k = 0; k < found->between_count; ++k) {
    const hsp_group_contact *sum = &found->between[k];
    if (sum->area < request->least) continue;
    text_buffer_add(out, "%s{\"%s\": [", separator, request->by == GROUPING_CHAIN ? "chains" : "residues");
    json_text(out, group_name(name, molecule, &found->groups, sum->group[0]));
    text_buffer_add(out, ", ");
    json_text(out, group_name(name, molecule, &found->groups, sum->group[1]));
    text_buffer_add(out, "], \"area\": ");
    json_number(out, sum->area);
    text_buffer_add(out, ", \"edge\": ");
    json_number(out, sum->edge);
    text_buffer_add(out, ", \"atom_pairs\": %" PRIu32 "}", sum->contacts);
    separator = ", ";
  }
}

static void pairs_json(const struct request *request, const struct findings *found, struct text_buffer *out) {
  const char *separator = "";
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    const hsp_contact *contact = &found->contacts[k];
    if (contact->area < request->least) continue;
    text_buffer_add(out, "%s{\"balls\": [%" PRIu32 ", %" PRIu32 "], \"area\": ", separator, contact->ball[0],
                    contact->ball[1]);
    json_number(out, contact->area);
    text_buffer_add(out, ", \"edge\": ");
    json_number(out, contact->edge);
    text_buffer_add(out, ", \"distance\": ");
    json_number(out, contact->distance);
    if (found->shift != NULL) {
      const int32_t *shift = found->shift + 3 * (size_t)k;
      text_buffer_add(out, ", \"shift\": [%" PRId32 ", %" PRId32 ", %" PRId32 "]", shift[0], shift[1], shift[2]);
    }
    text_buffer_add(out, "}");
    separator = ", ";
  }
}

/* The balls that pairs and cells are about. */
static void balls_json(const struct molecule *molecule, struct text_buffer *out) {
  text_buffer_add(out, ", \"balls\": [");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    text_buffer_add(out, "%s{", i == 0 ? "" : ", ");
    ball_label_json(molecule, i, out);
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "]");
}

static void print_json(const struct request *request, const struct molecule *molecule, const struct findings *found,
                       struct text_buffer *out) {
  text_buffer_add(out, "{");
  json_frame(out, &molecule->frame);
  text_buffer_add(out, "\"n\": %" PRIu32 ", \"contacts\": %" PRIu32 ", \"area\": ", molecule->atoms,
                  found->contact_count);
  json_number(out, found->totals.area);
  text_buffer_add(out, ", \"pairs\": [");
  if (request->by != GROUPING_NONE) {
    between_json(request, molecule, found, out);
  } else {
    pairs_json(request, found, out);
  }
  text_buffer_add(out, "]");
  if (request->cells) {
    text_buffer_add(out, ", \"cells\": [");
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      text_buffer_add(out, "%s{\"volume\": ", i == 0 ? "" : ", ");
      json_number(out, found->cell[i]);
      text_buffer_add(out, ", \"area\": ");
      json_number(out, found->free_area[i]);
      text_buffer_add(out, ", \"contact\": ");
      json_number(out, found->area[i]);
      text_buffer_add(out, "}");
    }
    text_buffer_add(out, "]");
  }
  if (request->by == GROUPING_NONE || request->cells) balls_json(molecule, out);
  if (found->box.periodic != NULL) periodic_result_json(&found->box, out);
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

/* "area, angstrom^2" */
enum { TITLE_BYTES = 32, DECIMALS = 4 };
static const char *title(char out[TITLE_BYTES], const struct molecule *molecule, const char *name, int power) {
  snprintf(out, TITLE_BYTES, power == 1 ? "%s, %s" : "%s, %s^%d", name, molecule->format->unit, power);
  return out;
}

static void print_pairs(const struct request *request, const struct molecule *molecule, const struct findings *found,
                        struct text_buffer *out) {
  const struct ball_columns columns = ball_columns_of(molecule);
  char titles[3][TITLE_BYTES];
  char values[3][NUMBER_BYTES];
  text_buffer_add(out, "\n");
  report_name_titles(out, columns, "first");
  report_name_titles(out, columns, "second");
  text_buffer_add(out, "  %16s  %16s  %18s%s\n", title(titles[0], molecule, "area", 2),
                  title(titles[1], molecule, "edge", 1), title(titles[2], molecule, "distance", 1),
                  found->shift != NULL ? "  shift of second" : "");
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    const hsp_contact *contact = &found->contacts[k];
    if (contact->area < request->least) continue;
    report_name(out, columns, molecule, contact->ball[0]);
    report_name(out, columns, molecule, contact->ball[1]);
    text_buffer_add(out, "  %16s  %16s  %18s", column_text(values[0], molecule->format, contact->area, DECIMALS),
                    column_text(values[1], molecule->format, contact->edge, DECIMALS),
                    column_text(values[2], molecule->format, contact->distance, DECIMALS));
    if (found->shift != NULL) {
      const int32_t *shift = found->shift + 3 * (size_t)k;
      text_buffer_add(out, "  %4" PRId32 " %4" PRId32 " %4" PRId32, shift[0], shift[1], shift[2]);
    }
    text_buffer_add(out, "\n");
  }
}

static void print_between(const struct request *request, const struct molecule *molecule, const struct findings *found,
                          struct text_buffer *out) {
  char names[2][GROUP_NAME_BYTES];
  char titles[2][TITLE_BYTES];
  char values[2][NUMBER_BYTES];
  text_buffer_add(out, "\n  %14s  %14s  %16s  %16s  %14s\n", "first", "second", title(titles[0], molecule, "area", 2),
                  title(titles[1], molecule, "edge", 1), "atom pairs");
  for (uint32_t k = 0; k < found->between_count; ++k) {
    const hsp_group_contact *sum = &found->between[k];
    if (sum->area < request->least) continue;
    text_buffer_add(out, "  %14s  %14s  %16s  %16s  %14" PRIu32 "\n",
                    group_name(names[0], molecule, &found->groups, sum->group[0]),
                    group_name(names[1], molecule, &found->groups, sum->group[1]),
                    column_text(values[0], molecule->format, sum->area, DECIMALS),
                    column_text(values[1], molecule->format, sum->edge, DECIMALS), sum->contacts);
  }
}

static void print_cells(const struct molecule *molecule, const struct findings *found, struct text_buffer *out) {
  const struct ball_columns columns = ball_columns_of(molecule);
  char titles[3][TITLE_BYTES];
  char values[3][NUMBER_BYTES];
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %16s  %21s  %24s\n", title(titles[0], molecule, "cell", 3),
                  title(titles[1], molecule, "free area", 2), title(titles[2], molecule, "contact area", 2));
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    report_ball(out, columns, molecule, i);
    text_buffer_add(out, "  %16s  %21s  %24s\n", column_text(values[0], molecule->format, found->cell[i], DECIMALS),
                    column_text(values[1], molecule->format, found->free_area[i], DECIMALS),
                    column_text(values[2], molecule->format, found->area[i], DECIMALS));
  }
}

static void csv_pairs(const struct request *request, const struct molecule *molecule, const struct findings *found,
                      struct text_buffer *out) {
  ball_label_csv_titles(molecule->format, "_1", out);
  text_buffer_add(out, ",");
  ball_label_csv_titles(molecule->format, "_2", out);
  text_buffer_add(out, ",area,edge,distance%s\n", found->shift != NULL ? ",shift_x,shift_y,shift_z" : "");
  for (uint32_t k = 0; k < found->contact_count; ++k) {
    const hsp_contact *contact = &found->contacts[k];
    const double numbers[] = {contact->area, contact->edge, contact->distance};
    if (contact->area < request->least) continue;
    ball_label_csv(molecule, contact->ball[0], out);
    text_buffer_add(out, ",");
    ball_label_csv(molecule, contact->ball[1], out);
    csv_numbers(out, numbers, 3);
    for (int axis = 0; axis < 3 && found->shift != NULL; ++axis) {
      text_buffer_add(out, ",%" PRId32, found->shift[3 * (size_t)k + (size_t)axis]);
    }
    text_buffer_add(out, "\n");
  }
}

/* The sums over residues or chains: names as --by has them in measure, of the one and of the other. */
static void csv_between(const struct request *request, const struct molecule *molecule, const struct findings *found,
                        struct text_buffer *out) {
  const bool residues = request->by == GROUPING_RESIDUE;
  text_buffer_add(
      out, "%s,area,edge,atom_pairs\n",
      residues ? "chain_1,residue_1,number_1,insertion_1,chain_2,residue_2,number_2,insertion_2" : "chain_1,chain_2");
  for (uint32_t k = 0; k < found->between_count; ++k) {
    const hsp_group_contact *sum = &found->between[k];
    const double numbers[] = {sum->area, sum->edge};
    if (sum->area < request->least) continue;
    for (int side = 0; side < 2; ++side) {
      const struct residue_label *label = &molecule->label[found->groups.group[sum->group[side]].first].residue;
      const char *const texts[] = {label->chain, label->name, label->number, label->insertion};
      for (int i = 0; i < (residues ? 4 : 1); ++i) {
        text_buffer_add(out, side + i == 0 ? "" : ",");
        csv_text(out, texts[i]);
      }
    }
    csv_numbers(out, numbers, 2);
    text_buffer_add(out, ",%" PRIu32 "\n", sum->contacts);
  }
}

static void print_tables(const struct request *request, const struct molecule *molecule, const struct findings *found,
                         struct text_buffer *out) {
  const char *unit = molecule->format->unit;
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  report_row_count(out, "contacts", found->contact_count, "pairs of balls whose cells of the union meet");
  text_buffer_add(out, "  %-16s %s %s^2, of all contacts, each once\n", "area",
                  quantity_text(value, found->totals.area, 10), unit);
  text_buffer_add(out, "  %-16s %s %s^3, of all cells\n", "volume", quantity_text(value, found->totals.volume, 10),
                  unit);
  if (found->box.periodic != NULL) periodic_result_rows(&found->box, unit, out);
  if (found->contact_count > 0 && request->by == GROUPING_NONE) print_pairs(request, molecule, found, out);
  if (found->contact_count > 0 && request->by != GROUPING_NONE) print_between(request, molecule, found, out);
  if (request->cells) print_cells(molecule, found, out);
}

/* What is listed, as a picture. */
static bool write_map(const struct request *request, const struct molecule *molecule, const struct findings *found,
                      struct failure *failure) {
  const bool grouped = request->by != GROUPING_NONE;
  const uint32_t pairs = grouped ? found->between_count : found->contact_count;
  struct contact_square *squares = calloc((size_t)pairs + 1, sizeof *squares);
  if (squares == NULL) return failure_of_memory(failure);
  struct contact_map map = {molecule, &found->groups, grouped ? found->groups.count : molecule->atoms, squares, 0};
  for (uint32_t k = 0; k < pairs; ++k) {
    const uint32_t *const pair = grouped ? found->between[k].group : found->contacts[k].ball;
    const double area = grouped ? found->between[k].area : found->contacts[k].area;
    if (area > 0.0 && area >= request->least) squares[map.count++] = (struct contact_square){pair[0], pair[1], area};
  }
  const bool done = contact_map_write(&map, request->map, failure);
  free(squares);
  return done;
}

/* A row of the table of frames. */
static void print_frame(const struct molecule *molecule, const struct findings *found, struct text_buffer *out) {
  if (molecule->frame.first) {
    csv_frame_titles(out);
    text_buffer_add(out, "contacts,area,volume%s\n", found->box.periodic != NULL ? ",box_volume,free_volume" : "");
  }
  csv_frame(out, molecule);
  text_buffer_add(out, "%" PRIu32 ",", found->contact_count);
  csv_number(out, found->totals.area);
  text_buffer_add(out, ",");
  csv_number(out, found->totals.volume);
  if (found->box.periodic != NULL) {
    text_buffer_add(out, ",");
    csv_number(out, found->box.totals.box_volume);
    text_buffer_add(out, ",");
    csv_number(out, found->box.totals.free_volume);
  }
  text_buffer_add(out, "\n");
}

static bool find_all(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct findings *found, struct failure *failure) {
  if (request->box.source != BOX_NONE) {
    return periodic_result_make(request, molecule, geometry, &found->box, failure) &&
           find_contacts_in_box(found, failure);
  }
  if (!geometry_compute_contacts(geometry, failure) || !find_contacts(geometry, found, failure)) return false;
  const int32_t status = hsp_contacts_measure(geometry->work.contacts, &found->totals, NULL, NULL, 0, NULL);
  return status == HSP_OK || failure_in_library(failure, status);
}

bool command_contacts(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  struct findings found;
  memset(&found, 0, sizeof found);
  bool done = find_all(request, molecule, geometry, &found, failure);
  if (done && request->by != GROUPING_NONE) done = find_groups(request, molecule, geometry, &found, failure);
  if (done && request->cells) done = find_cells(molecule, geometry, &found, failure);
  if (done && request->map != NULL) done = write_map(request, molecule, &found, failure);
  if (request->map != NULL && output_is_standard(request->map)) {
    findings_free(&found);
    return done;
  }
  if (done && request->json) {
    print_json(request, molecule, &found, out);
  } else if (done && molecule->frame.number > 0) {
    print_frame(molecule, &found, out);
  } else if (done && request->csv && request->by == GROUPING_NONE) {
    csv_pairs(request, molecule, &found, out);
  } else if (done && request->csv) {
    csv_between(request, molecule, &found, out);
  } else if (done) {
    print_tables(request, molecule, &found, out);
  }
  findings_free(&found);
  return done;
}
