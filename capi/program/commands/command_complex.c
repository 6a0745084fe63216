/* hardsphere complex: the dual complex of the union, its simplices by kind, and its topology. */
#include "commands/commands.h"
#include "commands/input_report.h"

/* Simplices of one dimension, by kind; in JSON it is the other way round. */
static bool row_of(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  static const char *const names[4] = {"balls", "edges", "triangles", "tetrahedra"};
  const hsp_complex *const complex = of;
  (void)text;
  cells[0].text = names[row];
  cells[1].count = complex->singular[row];
  cells[2].count = complex->regular[row];
  cells[3].count = complex->interior[row];
  cells[4].count = cells[1].count + cells[2].count + cells[3].count;
  return true;
}

static void print(struct record *record, const void *of) {
  static const struct column columns[] = {
      {NULL, NULL, "simplices", -16, COLUMN_TEXT, 0}, {NULL, NULL, "singular", 10, COLUMN_COUNT, 0},
      {NULL, NULL, "regular", 10, COLUMN_COUNT, 0},   {NULL, NULL, "interior", 10, COLUMN_COUNT, 0},
      {NULL, NULL, "all", 10, COLUMN_COUNT, 0},
  };
  const hsp_complex *const complex = of;
  const struct table simplices = {columns, 5, record->molecule->format, 4, complex, row_of, NULL};
  record_atoms(record);
  record_count(record, NULL, "components", complex->betti[0], "connected pieces of the union");
  record_count(record, NULL, "tunnels", complex->betti[1], "independent ways through it");
  record_count(record, NULL, "voids", complex->betti[2], "cavities enclosed by it");
  if (record_key(record, "simplices")) {
    struct record kinds = {.form = AS_JSON, .out = record->out};
    text_buffer_add_text(record->out, "{");
    record_counts(&kinds, "singular", complex->singular, 4);
    record_counts(&kinds, "regular", complex->regular, 4);
    record_counts(&kinds, "interior", complex->interior, 4);
    text_buffer_add_text(record->out, "}");
  }
  record_count(record, "euler", "euler", complex->euler, "balls - edges + triangles - tetrahedra");
  record_counts(record, "betti", complex->betti, 3);
  record_table(record, NULL, &simplices);
}

void describe_complex(const struct request *request, struct record *record) {
  static const hsp_complex none;
  (void)request;
  print(record, &none);
}

bool command_complex(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_contacts(geometry, failure)) return false;
  hsp_complex found;
  const int32_t status = hsp_contacts_get_complex(geometry->work.contacts, &found);
  if (status != HSP_OK) return failure_in_library(failure, status);
  report(request, molecule, print, &found, out);
  return true;
}
