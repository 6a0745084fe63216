#include "commands/input_report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "read/line_reader.h"
#include "read/residues.h"
#include "write/report.h"

/* The kinds of the balls. */
struct among {
  uint64_t waters; /* molecules */
  uint64_t water_atoms;
  uint64_t hetatm; /* other than water */
  uint64_t hydrogens;
  uint64_t by_element; /* balls whose radii are */
  uint64_t by_number;  /* balls whose element is a number in the file */
};

static struct among count_among(const struct molecule *molecule) {
  struct among among = {0, 0, 0, 0, 0, 0};
  bool water = false; /* the residue of the atom before */
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const struct atom_label *label = &molecule->label[i];
    const struct residue_label *const before = i == 0 ? NULL : molecule->label[i - 1].residue;
    if (label->residue != before) {
      water = atom_is_water(label);
      if (water && (i == 0 || !residue_label_same(before, label->residue))) ++among.waters;
    }
    if (water) ++among.water_atoms;
    if (label->hetatm && !water) ++among.hetatm;
    if (atom_is_hydrogen(label)) ++among.hydrogens;
    if (!label->by_name) ++among.by_element;
    if (label->by_number) ++among.by_number;
  }
  return among;
}

uint64_t input_report_waters(const struct molecule *molecule) {
  if (!file_format_has(molecule->format, FILE_RESIDUES)) return 0;
  const struct among among = count_among(molecule);
  return among.water_atoms < molecule->atoms ? among.waters : 0;
}

/* "58 waters", "1 water" */
static void add_count(struct text_buffer *out, const char *separator, uint64_t count, const char *one,
                      const char *many) {
  char shown[NUMBER_BYTES];
  text_buffer_add(out, "%s%s %s", separator, count_text(shown, (int64_t)count), count == 1 ? one : many);
}

static void row_among(struct text_buffer *out, const struct molecule *molecule, const struct among *among) {
  const bool residues = file_format_has(molecule->format, FILE_RESIDUES);
  const bool elements = file_format_has(molecule->format, FILE_ELEMENTS);
  if (!residues && !elements) return;
  text_buffer_add(out, "  %-16s", "among them");
  if (residues) {
    add_count(out, " ", among->waters, "water", "waters");
    if (file_format_has(molecule->format, FILE_HETATM)) {
      add_count(out, ", ", among->hetatm, "other HETATM atom", "other HETATM atoms");
    }
  }
  if (elements) add_count(out, residues ? ", " : " ", among->hydrogens, "hydrogen", "hydrogens");
  text_buffer_add(out, "\n");
}

static void rows_left_out(struct text_buffer *out, const struct left_out *left_out) {
  const struct {
    uint64_t count;
    const char *one;
    const char *many;
  } rows[] = {
      {left_out->other_models, "atom of other models", "atoms of other models"},
      {left_out->alternate_locations, "atom at other alternate locations", "atoms at other alternate locations"},
      {left_out->virtual_sites, "virtual site", "virtual sites"},
      {left_out->unplaced, "atom without coordinates", "atoms without coordinates"},
      {left_out->hydrogens_of_set, "hydrogen, which its heavy atom stands for",
       "hydrogens, which heavy atoms stand for"},
      {left_out->water, "atom of water", "atoms of water"},
      {left_out->hetatm, "other HETATM atom", "other HETATM atoms"},
      {left_out->hydrogen, "other hydrogen", "other hydrogens"},
      {left_out->others, "other atom", "other atoms"},
  };
  const char *name = "left out";
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
    if (rows[i].count == 0) continue;
    text_buffer_add(out, "  %-16s", name);
    add_count(out, " ", rows[i].count, rows[i].one, rows[i].many);
    text_buffer_add(out, "\n");
    name = "";
  }
}

/* Elements that the set has no radius for, and unknown ones at the end, with their atoms: `add` is called for each. */
static void list_substitutes(struct text_buffer *out, const struct request *request, const struct molecule *molecule,
                             void add(struct text_buffer *, bool first, const char *symbol, double radius,
                                      uint64_t atoms)) {
  uint64_t atoms[120] = {0}; /* by atomic number; [0]: unknown */
  struct element_symbol symbol;
  bool first = true;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    symbol = molecule->label[i].element;
    if (molecule->label[i].by_name) continue;
    if (radii_is_substitute(&request->radii, symbol)) ++atoms[element_atomic_number(symbol)];
  }
  for (uint32_t number = 1; element_symbol_of_number(number, &symbol); ++number) {
    double radius;
    if (atoms[number] == 0 || !radii_find(&request->radii, symbol, &radius)) continue;
    add(out, first, symbol.text, radius, atoms[number]);
    first = false;
  }
  double radius;
  if (atoms[0] > 0 && radii_find(&request->radii, element_unknown, &radius)) {
    add(out, first, element_unknown.text, radius, atoms[0]);
  }
}

static void add_substitute(struct text_buffer *out, bool first, const char *symbol, double radius, uint64_t atoms) {
  if (first) text_buffer_add(out, "  %-16s", "substitutes");
  text_buffer_add(out, "%s%s %.10g", first ? " " : ", ", symbol, radius);
  add_count(out, " (", atoms, "atom)", "atoms)");
}

static void json_substitute(struct text_buffer *out, bool first, const char *symbol, double radius, uint64_t atoms) {
  text_buffer_add(out, "%s{\"element\": \"%s\", \"radius\": ", first ? "" : ", ", symbol);
  json_number(out, radius);
  text_buffer_add(out, ", \"atoms\": %" PRIu64 "}", atoms);
}

static void row_substitutes(struct text_buffer *out, const struct request *request, const struct molecule *molecule) {
  const size_t before = out->length;
  list_substitutes(out, request, molecule, add_substitute);
  if (out->length == before) return;
  text_buffer_add(out, ": not in %s%s\n",
                  request->table.count > 0 ? radii_set_name(&radii_bondi) : radii_set_name(request->set),
                  request->set == &radii_bondi || request->table.count > 0 ? "" : ", from bondi where it has them");
}

static void rows_radii(struct text_buffer *out, const struct request *request, const struct molecule *molecule,
                       const struct among *among) {
  if (request->radii_file != NULL) {
    text_buffer_add(out, "  %-16s ", "radii");
    report_file_name(out, request->radii_file);
    text_buffer_add(out, " (a file)\n");
  } else {
    text_buffer_add(out, "  %-16s %s (%s)\n", "radii", radii_set_name(request->set), radii_set_source(request->set));
  }
  if (request->overrides.length > 0) text_buffer_add(out, "  %-16s with %s\n", "", request->overrides.text);
  if (request->table.count > 0 && among->by_element > 0) {
    text_buffer_add(out, "  %-16s", "by element");
    add_count(out, " ", among->by_element, "atom", "atoms");
    text_buffer_add(out, " that it does not name%s\n",
                    request->overrides.length > 0 ? ", or by --radius" : ", of bondi");
  }
  row_substitutes(out, request, molecule);
}

static void rows(struct text_buffer *out, const struct request *request, const struct molecule *molecule) {
  const struct among among = count_among(molecule);
  char value[2 * NUMBER_BYTES];
  report_row_count(out, "balls", molecule->atoms, "");
  row_among(out, molecule, &among);
  if (among.by_number > 0) {
    text_buffer_add(out, "  %-16s", "elements");
    add_count(out, " ", among.by_number, "number, taken as an atomic number", "numbers, taken as atomic numbers");
    text_buffer_add(out, "\n");
  }
  if (molecule->models > 1 && molecule->model == EVERY_MODEL) {
    snprintf(value, sizeof value, "all %" PRIu64 ", as one", molecule->models);
    report_row(out, "models", value, "");
  } else if (molecule->models > 1) {
    snprintf(value, sizeof value, "%" PRIu64 " of %" PRIu64, molecule->model, molecule->models);
    report_row(out, "model", value, "");
  }
  if (request->choice.assembly != NULL) {
    char shown[EXCERPT_BYTES];
    snprintf(value, sizeof value, "%s, by %lu operator%s",
             excerpt(shown, request->choice.assembly, strlen(request->choice.assembly)),
             (unsigned long)molecule->assemblies.made, molecule->assemblies.made == 1 ? "" : "s");
    report_row(out, "assembly", value, "");
  }
  if (request->choice.label_chains) report_row(out, "chains", "by label_asym_id", "");
  if (request->location_given) {
    const char letter[] = {request->choice.location, '\0'};
    report_row(out, "locations",
               letter[0] == LOCATION_FIRST          ? "the first"
               : letter[0] == LOCATION_BY_OCCUPANCY ? "by occupancy"
                                                    : letter,
               "");
  }
  if (molecule->coordinates != NULL) report_row(out, "coordinates", molecule->coordinates, "");
  rows_left_out(out, &molecule->left_out);
  if (!file_format_has(request->format, FILE_RADII)) {
    rows_radii(out, request, molecule, &among);
  } else if (molecule_points(molecule) == molecule->atoms) {
    report_row(out, "radii", "from the file; all of them are 0", "");
  } else {
    report_row(out, "radii", "from the file", "");
  }
}

static void report_probe(struct text_buffer *out, const struct request *request, const char *unit) {
  if (request->probe == 0.0) {
    report_row(out, "probe", "none: the van der Waals surface, by the radii as they are", "");
    return;
  }
  char value[160];
  snprintf(value, sizeof value, "%.10g %s, %s", request->probe, unit,
           request->command == COMMAND_GATE    ? "added to every radius to find voids, and then no more"
           : request->command == COMMAND_PORES ? "the narrowest one of interest; radii are as they are"
           : request->measure.outer    ? "rolling over the atoms from outside: the outer solvent-excluded surface"
           : request->excluded_surface ? "rolling over the atoms: the solvent-excluded surface"
                                       : "added to every radius: the solvent-accessible surface");
  report_row(out, "probe", value, "");
}

void rows_heading(struct text_buffer *out, const struct request *request, const struct files_among *files) {
  report_file_name(out, input_name(files->first));
  if (request->files > 1) text_buffer_add(out, " and %d more", request->files - 1);
  text_buffer_add_text(out, "\n");
  if (!file_format_has(request->format, FILE_RADII)) {
    text_buffer_add(out, "  %-16s %s%s\n", "radii",
                    request->radii_file != NULL ? request->radii_file : radii_set_name(request->set),
                    files->own_radii ? ", or from the file" : "");
    if (request->overrides.length > 0) text_buffer_add(out, "  %-16s with %s\n", "", request->overrides.text);
  }
  report_probe(out, request, files->one_unit ? request->format->unit : "in the unit of each file");
  text_buffer_add(out, "  %-16s of lengths %s; areas and volumes are its powers\n\n", "unit",
                  files->one_unit ? request->format->unit : "that of each file");
}

void report_heading(struct text_buffer *out, const struct request *request, const struct molecule *molecule) {
  report_file_name(out, input_name(request->file));
  text_buffer_add(out, "\n");
  rows(out, request, molecule);
  report_probe(out, request, request->format->unit);
  text_buffer_add(out, "\n");
}

static void json_count(struct text_buffer *out, const char *name, uint64_t count) {
  text_buffer_add(out, ", \"%s\": %" PRIu64, name, count);
}

void input_report_json(struct text_buffer *out, const struct request *request, const struct molecule *molecule) {
  if (molecule->frame.number > 0) return; /* it would be the same for all frames */
  const struct among among = count_among(molecule);
  const struct left_out *left_out = &molecule->left_out;
  text_buffer_add(out, ", \"input\": {\"file\": ");
  json_text(out, request->file);
  text_buffer_add(out, ", \"format\": \"%s\", \"unit\": \"%s\"", molecule->format->name, molecule->format->unit);
  text_buffer_add(out, ", \"radii\": ");
  json_text(out, file_format_has(molecule->format, FILE_RADII) ? "file"
                 : request->radii_file != NULL                 ? request->radii_file
                                                               : radii_set_name(request->set));
  text_buffer_add(out, ", \"radius_overrides\": ");
  json_text(out, request->overrides.length > 0 ? request->overrides.text : "");
  text_buffer_add(out, ", \"substitutes\": [");
  if (!file_format_has(molecule->format, FILE_RADII)) list_substitutes(out, request, molecule, json_substitute);
  text_buffer_add(out, "], \"probe\": ");
  json_number(out, request->probe);
  json_count(out, "balls", molecule->atoms);
  json_count(out, "waters", among.waters);
  json_count(out, "water_atoms", among.water_atoms);
  json_count(out, "hetatm", among.hetatm);
  json_count(out, "hydrogens", among.hydrogens);
  json_count(out, "radius_zero", molecule_points(molecule));
  json_count(out, "radius_by_element", file_format_has(molecule->format, FILE_RADII) ? 0 : among.by_element);
  if (file_format_has(molecule->format, FILE_ATOMIC_NUMBERS)) json_count(out, "atomic_numbers", among.by_number);
  if (file_format_has(molecule->format, FILE_COORDINATE_ITEMS)) {
    text_buffer_add(out, ", \"coordinates\": ");
    json_text(out, molecule->coordinates == NULL ? "Cartn_x" : molecule->coordinates);
  }
  if (molecule->model == EVERY_MODEL) {
    text_buffer_add(out, ", \"model\": null");
  } else {
    json_count(out, "model", molecule->number > 0 ? molecule->number : molecule->model);
  }
  if (molecule->number > 0) { /* their number is not known yet */
    text_buffer_add_text(out, ", \"models\": null");
  } else {
    json_count(out, "models", molecule->models);
  }
  if (request->choice.assembly != NULL) {
    text_buffer_add(out, ", \"assembly\": ");
    json_text(out, request->choice.assembly);
    json_count(out, "assembly_operators", molecule->assemblies.made);
  }
  text_buffer_add(out, ", \"left_out\": {\"other_models\": %" PRIu64, left_out->other_models);
  json_count(out, "alternate_locations", left_out->alternate_locations);
  json_count(out, "virtual_sites", left_out->virtual_sites);
  if (file_format_has(molecule->format, FILE_COORDINATE_ITEMS)) json_count(out, "unplaced", left_out->unplaced);
  json_count(out, "hydrogens_of_set", left_out->hydrogens_of_set);
  json_count(out, "water", left_out->water);
  json_count(out, "hetatm", left_out->hetatm);
  json_count(out, "hydrogen", left_out->hydrogen);
  json_count(out, "others", left_out->others);
  text_buffer_add(out, "}}");
}

/* Records the part of a frame that stands before its results. */
static void record_frame(struct record *record, const struct frame_stamp *frame) {
  if (frame->number == 0) return;
  record_count(record, "frame", NULL, (int64_t)frame->number, "");
  record_number(record, "time", NULL, frame->timed ? frame->time : (double)NAN, 0, "");
  if (frame->stepped) {
    record_count(record, "step", NULL, frame->step, "");
  } else {
    record_number(record, "step", NULL, NAN, 0, "");
  }
}

void report(const struct request *request, const struct molecule *molecule,
            void print(struct record *record, const void *of), const void *of, struct text_buffer *out) {
  const bool frames = molecule->frame.number > 0, rows = request->rows != ROWS_NONE;
  const bool csv = !request->json && (frames || rows || request->csv);
  struct record record = {.form = request->json ? AS_JSON
                                  : csv         ? AS_CSV_TITLES
                                                : FOR_PERSONS,
                          .molecule = molecule,
                          .atoms = request->json    ? "n"
                                   : frames || rows ? "atoms"
                                                    : "balls",
                          .aligned = request->rows == ROWS_FOR_PERSONS,
                          .width = VALUE_WIDTH,
                          .out = out};
  if (request->json) text_buffer_add_text(out, "{");
  if (record.form == FOR_PERSONS) report_heading(out, request, molecule);
  if (csv && (!frames || molecule->frame.first)) {
    record_frame(&record, &molecule->frame);
    print(&record, of);
    text_buffer_add_text(out, "\n");
  }
  if (csv) record.form = AS_CSV, record.any = false;
  record_frame(&record, &molecule->frame);
  print(&record, of);
  if (request->json) input_report_json(out, request, molecule);
  if (request->json) text_buffer_add_text(out, "}");
  if (record.form != FOR_PERSONS) text_buffer_add_text(out, "\n");
}

/* The table of a frame, and the text with which each row begins. */
struct framed {
  const struct table *table;
  struct text_buffer lead[2]; /* titles, values */
};

static bool framed_row(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct table *const table = ((const struct framed *)of)->table;
  return table->row(table->of, row, cells, text);
}

static void framed_lead(const void *of, size_t row, enum form form, struct text_buffer *out) {
  const struct text_buffer *const lead = &((const struct framed *)of)->lead[row == TABLE_TITLES ? 0 : 1];
  (void)form;
  text_buffer_append(out, lead->text, lead->length);
}

void report_list(const struct molecule *molecule, const struct table *table, struct text_buffer *out) {
  if (molecule->frame.number == 0) {
    table_csv(table, out);
    return;
  }
  struct framed framed = {table, {TEXT_BUFFER_EMPTY, TEXT_BUFFER_EMPTY}};
  for (int k = 0; k < 2; ++k) {
    struct record record = {
        .form = k == 0 ? AS_CSV_TITLES : AS_CSV, .molecule = molecule, .width = 0, .out = &framed.lead[k]};
    record_frame(&record, &molecule->frame);
  }
  struct table rows = *table;
  rows.of = &framed;
  rows.row = framed_row;
  rows.lead = framed_lead;
  (molecule->frame.first ? table_csv : table_csv_rows)(&rows, out);
  for (int k = 0; k < 2; ++k) {
    out->out_of_memory = out->out_of_memory || framed.lead[k].out_of_memory;
    text_buffer_free(&framed.lead[k]);
  }
}
