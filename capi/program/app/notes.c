#include "app/notes.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "commands/input_report.h"
#include "commands/unit_cell.h"
#include "read/line_reader.h"

static bool names_element(const struct molecule *molecule, struct element_symbol symbol) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    if (strcmp(molecule->label[i].element.text, symbol.text) == 0) return true;
  }
  return false;
}

/* The text of --radius is known to be EL=R,.. */
static void look_for_elements(struct notes *notes, const char *text, const struct molecule *molecule) {
  while (text[0] != '\0') {
    struct element_symbol symbol;
    if (element_symbol_parse(text, strcspn(text, "="), &symbol) && !names_element(molecule, symbol)) {
      text_buffer_add(&notes->unmatched, "%s--radius %s", notes->unmatched.length == 0 ? "" : ", ", symbol.text);
    }
    text += strcspn(text, ",");
    if (text[0] == ',') ++text;
  }
}

static void look_for_contradictions(struct notes *notes, const struct molecule *molecule) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *const label = &molecule->label[i];
    if (!label->contradicted || notes->contradicted++ > 0) continue;
    notes->contradicted_line = molecule->line[i];
    notes->stated = label->element;
    memcpy(notes->contradicted_name, label->name, sizeof notes->contradicted_name);
  }
}

static void look_for_parts(struct notes *notes, const struct molecule *molecule) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) count += molecule->label[i].partly ? 1 : 0;
  if (count == 0) return;
  text_buffer_add(&notes->lines, "%" PRIu32 " atom%s of an occupancy below 1 count%s whole, as if always there\n",
                  count, count == 1 ? "" : "s", count == 1 ? "s" : "");
}

/* Three atoms are always in a plane. */
enum { ENOUGH_FOR_SPACE = 4 };

static uint32_t count_at_origin(const struct molecule *molecule) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double *const xyz = molecule->xyz + 3 * (size_t)i;
    if (xyz[0] == 0.0 && xyz[1] == 0.0 && xyz[2] == 0.0) ++count;
  }
  return count;
}

/* Whether --models all would take all of them. */
static bool goes_through(const struct request *request) {
  const enum command command = request->command;
  return file_format_has(request->format, FILE_MOLECULES) && request->files == 1 && command != COMMAND_DRAW &&
         command != COMMAND_MESH && command != COMMAND_HESSIAN;
}

void notes_look_at_file(struct notes *notes, const struct request *request, struct molecule *molecule) {
  const char letter = request->choice.location;
  if (request->choice.assembly == NULL) assemblies_list_others(molecule, &notes->assemblies);
  if (letter != LOCATION_FIRST && letter != LOCATION_BY_OCCUPANCY && !molecule->location_found) {
    text_buffer_add(&notes->unmatched, "--altloc %c", letter);
  }
  const bool orders = file_format_has(molecule->format, FILE_ORDERS);
  if (molecule->remark != NULL) text_buffer_add(&notes->lines, "%s\n", molecule->remark);
  if (request->trajectory != NULL) return; /* its frames are read, all of them */
  const bool chosen = request->model_given || request->choice.model == EVERY_MODEL;
  if (molecule->models > 1 && !chosen && !request->json) { /* whose object has it */
    text_buffer_add(&notes->lines, "%s 1 of %" PRIu64 " is read, and no other; --model N takes another one%s\n",
                    orders ? "molecule" : "model", molecule->models,
                    goes_through(request) ? ", --models all each" : "");
  }
  const uint32_t at_origin = file_format_has(molecule->format, FILE_ELEMENTS) ? count_at_origin(molecule) : 0;
  if (at_origin > 1) {
    text_buffer_add(&notes->lines, "%" PRIu32 " atoms stand in one point, 0 0 0: they may have no coordinates\n",
                    at_origin);
  } else if (orders && molecule->atoms >= ENOUGH_FOR_SPACE && molecule_is_flat(molecule, 0)) {
    text_buffer_add(&notes->lines, "all z are 0: a flat molecule, or a drawing, which says nothing of space\n");
  }
}

void notes_look_at_symmetry(struct notes *notes, const struct request *request, const struct symmetry *symmetry) {
  char text[UNIT_CELL_TEXT_BYTES];
  if (request->box.source != BOX_OF_FILE || request->box.without_copies) return;
  if (!symmetry->filled && !symmetry_is_none(symmetry)) {
    text_buffer_add(&notes->lines, "space group %s\n", unit_cell_text(text, symmetry));
  }
}

void notes_look_among_all(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  look_for_contradictions(notes, molecule);
  selection_list_unmatched(&request->selection, molecule, &notes->unmatched);
  if (request->overrides.length > 0) look_for_elements(notes, request->overrides.text, molecule);
}

void notes_look_among_chosen(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  look_for_parts(notes, molecule);
  selection_list_unmatched(&request->drawing.highlight, molecule, &notes->unmatched);
  selection_list_unmatched(&request->measure.part, molecule, &notes->unmatched);
  selection_groups_list_unmatched(&request->measure.interface, molecule, &notes->unmatched);
  selection_groups_list_unmatched(&request->contacts.between, molecule, &notes->unmatched);
}

static void print(const struct request *request, const struct failure *note) {
  struct failure line = *note;
  line.file = input_name(request->file);
  failure_print(&line);
}

void notes_look_at_result(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  const bool rows = request->csv || request->rows != ROWS_NONE ||
                    (request->trajectory != NULL && !request->json && !request->measure.mean);
  notes->waters = rows ? input_report_waters(molecule) : 0;
  notes->dummies = molecule->left_out.virtual_sites;
}

void notes_print(const struct notes *notes, const struct request *request) {
  const uint64_t waters = notes->waters;
  struct failure note = FAILURE_NONE;
  for (const char *line = notes->lines.text; line != NULL && *line != '\0'; line += strcspn(line, "\n") + 1) {
    snprintf(note.reason, sizeof note.reason, "%.*s", (int)strcspn(line, "\n"), line);
    print(request, &note);
  }
  if (notes->unmatched.length > 0) {
    snprintf(note.reason, sizeof note.reason, "nothing matches %s", notes->unmatched.text);
    print(request, &note);
  }
  if (notes->assemblies.length > 0) {
    const bool several = strpbrk(notes->assemblies.text, ", ") != NULL;
    snprintf(note.reason, sizeof note.reason, "%s %s of the file %s not what is read; --assembly %s makes %s",
             several ? "assemblies" : "assembly", notes->assemblies.text, several ? "are" : "is",
             several ? "N" : notes->assemblies.text, several ? "one" : "it");
    print(request, &note);
  }
  if (notes->contradicted > 0) {
    char name[EXCERPT_BYTES];
    note.line = notes->contradicted_line;
    snprintf(note.reason, sizeof note.reason,
             "'%s' is %s by what the file states, which counts, and another element by its name; %" PRIu64
             " such atom%s",
             excerpt(name, notes->contradicted_name, strlen(notes->contradicted_name)), notes->stated.text,
             notes->contradicted, notes->contradicted == 1 ? "" : "s");
    print(request, &note);
    note.line = 0;
  }
  if (notes->dummies > 0) {
    snprintf(note.reason, sizeof note.reason, "%" PRIu64 " %s left out: %s", notes->dummies,
             notes->dummies == 1 ? "dummy or virtual site is" : "dummies or virtual sites are",
             notes->dummies == 1 ? "it is no atom" : "they are no atoms");
    print(request, &note);
  }
  if (waters > 0) {
    snprintf(note.reason, sizeof note.reason, "%" PRIu64 " %s counted; --no-water leaves %s out", waters,
             waters == 1 ? "water is" : "waters are", waters == 1 ? "it" : "them");
    print(request, &note);
  }
  if (notes->labels_left_out > 0) {
    snprintf(note.reason, sizeof note.reason,
             "no room for %" PRIu64 " of %" PRIu64 " labels, which are left out; --highlight names fewer",
             notes->labels_left_out, notes->labels);
    print(request, &note);
  }
  if (notes->largest_rounding > 1e-6) {
    static const char text[] = "coordinates and radii are rounded to a coarse lattice: ";
    if (notes->largest_rounding < 1.0) {
      snprintf(note.reason, sizeof note.reason, "%sthe smallest radius has only %.0f steps", text,
               0.5 / notes->largest_rounding);
    } else {
      snprintf(note.reason, sizeof note.reason, "%sa radius above 0 became 0", text);
    }
    print(request, &note);
  }
}

bool notes_are_none(const struct notes *notes) {
  return notes->lines.length == 0 && notes->unmatched.length == 0 && notes->assemblies.length == 0 &&
         notes->contradicted == 0 && notes->dummies == 0 && notes->waters == 0;
}

void notes_free(struct notes *notes) {
  text_buffer_free(&notes->lines);
  text_buffer_free(&notes->unmatched);
  text_buffer_free(&notes->assemblies);
}
