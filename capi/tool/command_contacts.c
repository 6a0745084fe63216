/* hardsphere contacts: which balls touch and by how much, what residues or chains have in contact, and each ball's cell
 * of the union. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "csv.h"
#include "input_report.h"
#include "report.h"

/* All that is printed. Arrays that were not asked for are NULL. */
struct findings {
  hsp_totals totals;
  hsp_contact *contacts; /* [contact_count] */
  uint32_t contact_count;
  struct atom_groups groups;
  uint32_t *group_of;         /* [atoms] */
  hsp_group_contact *between; /* [between_count] */
  uint32_t between_count;
  double *cell, *free_area, *area; /* [atoms] */
};

static void findings_free(struct findings *found) {
  atom_groups_free(&found->groups);
  free(found->contacts);
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

static bool find_cells(const struct molecule *molecule, const struct geometry *geometry, struct findings *found,
                       struct failure *failure) {
  const uint32_t n = molecule->atoms;
  found->cell = calloc((size_t)n + 1, sizeof *found->cell);
  found->free_area = calloc((size_t)n + 1, sizeof *found->free_area);
  found->area = calloc((size_t)n + 1, sizeof *found->area);
  if (found->cell == NULL || found->free_area == NULL || found->area == NULL) return failure_of_memory(failure);
  int32_t status = hsp_contacts_measure(geometry->work.contacts, NULL, found->cell, found->area, n, NULL);
  if (status == HSP_OK) {
    status = hsp_boundary_measure(geometry->work.boundary, NULL, NULL, found->free_area, NULL, n, NULL);
  }
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

static bool find_groups(const struct request *request, const struct molecule *molecule, const struct geometry *geometry,
                        struct findings *found, struct failure *failure) {
  double *const nothing = calloc((size_t)molecule->atoms + 1, sizeof *nothing);
  if (nothing == NULL) return failure_of_memory(failure);
  const bool done = atom_groups_make(molecule, request->by, nothing, &found->groups, failure) &&
                    number_groups(molecule, found, failure);
  free(nothing);
  if (!done) return false;
  int32_t status = hsp_contacts_group(geometry->work.contacts, found->group_of, NULL, 0, &found->between_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->between = calloc((size_t)found->between_count + 1, sizeof *found->between);
  if (found->between == NULL) return failure_of_memory(failure);
  status = hsp_contacts_group(geometry->work.contacts, found->group_of, found->between, found->between_count,
                              &found->between_count);
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
    text_buffer_add(out, "}");
    separator = ", ";
  }
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
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_pairs(const struct request *request, const struct molecule *molecule, const struct findings *found,
                        struct text_buffer *out) {
  char names[2][GROUP_NAME_BYTES];
  char values[3][NUMBER_BYTES];
  if (found->contact_count == 0) return;
  text_buffer_add(out, "\n  %14s  %14s  %16s  %16s  %14s\n", "first", "second", "area", "edge",
                  request->by == GROUPING_NONE ? "distance" : "atom pairs");
  for (uint32_t k = 0; request->by == GROUPING_NONE && k < found->contact_count; ++k) {
    const hsp_contact *contact = &found->contacts[k];
    if (contact->area < request->least) continue;
    text_buffer_add(out, "  %14" PRIu32 "  %14" PRIu32 "  %16s  %16s  %14s\n", contact->ball[0], contact->ball[1],
                    quantity_text(values[0], contact->area, 6), quantity_text(values[1], contact->edge, 6),
                    quantity_text(values[2], contact->distance, 6));
  }
  for (uint32_t k = 0; request->by != GROUPING_NONE && k < found->between_count; ++k) {
    const hsp_group_contact *sum = &found->between[k];
    if (sum->area < request->least) continue;
    text_buffer_add(out, "  %14s  %14s  %16s  %16s  %14" PRIu32 "\n",
                    group_name(names[0], molecule, &found->groups, sum->group[0]),
                    group_name(names[1], molecule, &found->groups, sum->group[1]),
                    quantity_text(values[0], sum->area, 6), quantity_text(values[1], sum->edge, 6), sum->contacts);
  }
}

static void print_cells(const struct molecule *molecule, const struct findings *found, struct text_buffer *out) {
  const struct ball_columns columns = ball_columns_of(molecule);
  char values[3][NUMBER_BYTES];
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %16s  %16s  %16s\n", "cell", "free area", "contact area");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    report_ball(out, columns, molecule, i);
    text_buffer_add(out, "  %16s  %16s  %16s\n", quantity_text(values[0], found->cell[i], 6),
                    quantity_text(values[1], found->free_area[i], 6), quantity_text(values[2], found->area[i], 6));
  }
}

static void print_tables(const struct request *request, const struct molecule *molecule, const struct findings *found,
                         struct text_buffer *out) {
  const char *unit = format_unit(molecule->format);
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  report_row_count(out, "contacts", found->contact_count, "pairs of balls whose cells of the union meet");
  text_buffer_add(out, "  %-16s %s %s^2, of all contacts, each once\n", "area",
                  quantity_text(value, found->totals.area, 10), unit);
  text_buffer_add(out, "  %-16s %s %s^3, of all cells\n", "volume", quantity_text(value, found->totals.volume, 10),
                  unit);
  print_pairs(request, molecule, found, out);
  if (request->cells) print_cells(molecule, found, out);
}

/* A row of the table of frames. */
static void print_frame(const struct molecule *molecule, const struct findings *found, struct text_buffer *out) {
  if (molecule->frame.first) {
    csv_frame_titles(out);
    text_buffer_add(out, "contacts,area,volume\n");
  }
  csv_frame(out, molecule);
  text_buffer_add(out, "%" PRIu32 ",", found->contact_count);
  csv_number(out, found->totals.area);
  text_buffer_add(out, ",");
  csv_number(out, found->totals.volume);
  text_buffer_add(out, "\n");
}

bool command_contacts(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct text_buffer *out, struct failure *failure) {
  struct findings found;
  memset(&found, 0, sizeof found);
  bool done = geometry_compute_contacts(geometry, failure) && find_contacts(geometry, &found, failure);
  if (done && request->by != GROUPING_NONE) done = find_groups(request, molecule, geometry, &found, failure);
  if (done && request->cells) done = find_cells(molecule, geometry, &found, failure);
  if (done) {
    const int32_t status = hsp_contacts_measure(geometry->work.contacts, &found.totals, NULL, NULL, 0, NULL);
    done = status == HSP_OK || failure_in_library(failure, status);
  }
  if (done && request->json) {
    print_json(request, molecule, &found, out);
  } else if (done && molecule->frame.number > 0) {
    print_frame(molecule, &found, out);
  } else if (done) {
    print_tables(request, molecule, &found, out);
  }
  findings_free(&found);
  return done;
}
