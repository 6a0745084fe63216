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

void notes_look_at_file(struct notes *notes, const struct request *request, struct molecule *molecule) {
  const char letter = request->choice.location;
  if (request->choice.assembly == NULL) assemblies_list_others(molecule, &notes->assemblies);
  if (letter != LOCATION_FIRST && letter != LOCATION_BY_OCCUPANCY && !molecule->location_found) {
    text_buffer_add(&notes->unmatched, "--altloc %c", letter);
  }
}

void notes_look_among_all(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  selection_list_unmatched(&request->selection, molecule, &notes->unmatched);
  if (request->overrides.length > 0) look_for_elements(notes, request->overrides.text, molecule);
}

void notes_look_among_chosen(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  selection_list_unmatched(&request->highlight, molecule, &notes->unmatched);
  selection_list_unmatched(&request->part, molecule, &notes->unmatched);
}

static void print(const struct request *request, const struct failure *note) {
  struct failure line = *note;
  line.file = input_name(request->file);
  failure_print(&line);
}

void notes_look_at_result(struct notes *notes, const struct request *request, const struct molecule *molecule) {
  const bool rows = request->csv || (request->trajectory != NULL && !request->json && !request->mean);
  notes->waters = rows ? input_report_waters(molecule) : 0;
  if (request->trajectory == NULL && request->box.source == BOX_OF_FILE && !request->box.without_copies) {
    unit_cell_list_unfilled(&molecule->symmetry, &notes->symmetry);
  }
}

void notes_print(const struct notes *notes, const struct request *request) {
  const uint64_t waters = notes->waters;
  struct failure note = {0, NULL, 0, ""};
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
  if (notes->symmetry.length > 0) {
    snprintf(note.reason, sizeof note.reason, "space group %s", notes->symmetry.text);
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

void notes_free(struct notes *notes) {
  text_buffer_free(&notes->unmatched);
  text_buffer_free(&notes->assemblies);
  text_buffer_free(&notes->symmetry);
}
