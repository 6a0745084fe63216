#include "write/ball_label.h"

#include <inttypes.h>

#include "write/csv.h"
#include "write/report.h"

/* What a ball is called, in the order of the keys and columns. */
enum { MOST_NAMES = 6 };

struct ball_name {
  const char *key;
  const char *text;
};

/* Which names there are follows from the format, not from what a file happens to leave empty. Returns how many. */
static int list_names(const struct file_format *format, const struct atom_label *label,
                      struct ball_name list[MOST_NAMES]) {
  const struct residue_label *residue = &label->residue;
  const bool residues = file_format_has(format, FILE_RESIDUES);
  int count = 0;
  if (residues) list[count++] = (struct ball_name){"atom", label->name};
  if (!file_format_has(format, FILE_RADII)) list[count++] = (struct ball_name){"element", label->element.text};
  if (!residues) return count;
  list[count++] = (struct ball_name){"chain", residue->chain};
  list[count++] = (struct ball_name){"residue", residue->name};
  list[count++] = (struct ball_name){"number", residue->number};
  list[count++] = (struct ball_name){"insertion", residue->insertion};
  return count;
}

void ball_label_json(const struct molecule *molecule, uint32_t ball, struct text_buffer *out) {
  const struct atom_label *label = &molecule->label[ball];
  struct ball_name names[MOST_NAMES];
  const int count = list_names(molecule->format, label, names);
  text_buffer_add(out, "\"ball\": %" PRIu32, ball);
  for (int i = 0; i < count; ++i) {
    text_buffer_add(out, ", \"%s\": ", names[i].key);
    if (names[i].text == label->residue.number) {
      json_residue_number(out, names[i].text);
    } else {
      json_text(out, names[i].text);
    }
  }
  text_buffer_add(out, ", \"xyz\": ");
  json_vector(out, molecule->xyz + 3 * (size_t)ball);
  text_buffer_add(out, ", \"radius\": ");
  json_number(out, molecule->radius[ball]);
}

void ball_label_csv_titles(const struct file_format *format, const char *suffix, struct text_buffer *out) {
  static const struct atom_label nobody = ATOM_LABEL_NONE;
  struct ball_name names[MOST_NAMES];
  const int count = list_names(format, &nobody, names);
  text_buffer_add(out, "ball%s", suffix);
  for (int i = 0; i < count; ++i) text_buffer_add(out, ",%s%s", names[i].key, suffix);
}

void ball_label_csv(const struct molecule *molecule, uint32_t ball, struct text_buffer *out) {
  struct ball_name names[MOST_NAMES];
  const int count = list_names(molecule->format, &molecule->label[ball], names);
  text_buffer_add(out, "%" PRIu32, ball);
  for (int i = 0; i < count; ++i) {
    text_buffer_add(out, ",");
    csv_text(out, names[i].text);
  }
}
