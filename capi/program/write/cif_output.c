#include "write/cif_output.h"

#include <inttypes.h>
#include <stdbool.h>
#include <string.h>

static bool is_plain(char c) {
  return ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
}

/* Whether all readers take a text for a value without quotes around it; a quote within it ends nothing. */
static bool needs_no_quotes(const char *text) {
  const char *at = text;
  while (is_plain(*at) || (at > text && *at != '\0' && strchr("'*+-.", *at) != NULL)) ++at;
  return *at == '\0';
}

void cif_text(struct text_buffer *out, const char *text) {
  if (text[0] == '\0') {
    text_buffer_add_text(out, ". ");
  } else if (needs_no_quotes(text)) {
    text_buffer_add(out, "%s ", text);
  } else if (strchr(text, '\'') == NULL) {
    text_buffer_add(out, "'%s' ", text);
  } else if (strchr(text, '"') == NULL) {
    text_buffer_add(out, "\"%s\" ", text);
  } else {
    text_buffer_add(out, "\n;%s\n;\n", text);
  }
}

void cif_loop(struct text_buffer *out, const char *category, const char *const *items, size_t count) {
  text_buffer_add_text(out, "#\nloop_\n");
  for (size_t k = 0; k < count; ++k) text_buffer_add(out, "_%s.%s\n", category, items[k]);
}

void cif_sites_begin(struct text_buffer *out) {
  static const char *const items[] = {"group_PDB",      "id",
                                      "type_symbol",    "label_atom_id",
                                      "label_alt_id",   "label_comp_id",
                                      "label_asym_id",  "label_entity_id",
                                      "label_seq_id",   "pdbx_PDB_ins_code",
                                      "Cartn_x",        "Cartn_y",
                                      "Cartn_z",        "occupancy",
                                      "B_iso_or_equiv", "auth_seq_id",
                                      "auth_asym_id",   "pdbx_PDB_model_num"};
  cif_loop(out, "atom_site", items, sizeof items / sizeof items[0]);
}

void cif_site(struct text_buffer *out, uint32_t serial, const struct site *site) {
  text_buffer_add(out, "%s %" PRIu32 " ", site->group, serial);
  cif_text(out, site->element);
  cif_text(out, site->atom);
  text_buffer_add_text(out, ". ");
  cif_text(out, site->residue);
  cif_text(out, site->chain);
  text_buffer_add_text(out, "? . ");
  cif_text(out, site->insertion);
  text_buffer_add(out, "%.5f %.5f %.5f 1 %.4f ", site->xyz[0] + 0.0, site->xyz[1] + 0.0, site->xyz[2] + 0.0,
                  site->value + 0.0);
  cif_text(out, site->number);
  cif_text(out, site->chain);
  text_buffer_add_text(out, "1\n");
}
