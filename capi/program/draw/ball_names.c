#include "draw/ball_names.h"

#include <stdio.h>
#include <stdlib.h>

#include "read/residues.h"

/* No class and no title is longer. */
enum { NAME_BYTES = 64 };

/* Names of mmCIF may have blanks, which would end a class. */
static void join_words(char *text) {
  for (; *text != '\0'; ++text) {
    if (*text == ' ' || *text == '\t') *text = '_';
  }
}

static void put_class(char *out, const struct atom_label *label) {
  const char *const words[3][2] = {
      {"el-", label->element.text}, {"res-", label->residue->name}, {"chain-", label->residue->chain}};
  size_t used = 0;
  out[0] = '\0';
  for (int k = 0; k < 3; ++k) {
    if (words[k][1][0] == '\0') continue;
    if (used > 0) out[used++] = ' ';
    char *const class_name = out + used;
    used += (size_t)snprintf(class_name, NAME_BYTES - used, "%s%s", words[k][0], words[k][1]);
    join_words(class_name);
  }
}

static void put_title(char *out, const struct atom_label *label) {
  char residue[RESIDUE_TEXT_BYTES];
  residue_text(residue, label->residue);
  snprintf(out, NAME_BYTES, "%s%s%s", residue, residue[0] != '\0' && label->name[0] != '\0' ? " " : "", label->name);
}

bool ball_names_make(const struct molecule *molecule, bool classes, bool titles, struct ball_names *names,
                     struct failure *failure) {
  const size_t atoms = molecule->atoms;
  *names = (struct ball_names)BALL_NAMES_NONE;
  names->text = malloc((2 * atoms + 1) * NAME_BYTES);
  if (classes) names->class_of = malloc((atoms + 1) * sizeof *names->class_of);
  if (titles) names->title_of = malloc((atoms + 1) * sizeof *names->title_of);
  if (names->text == NULL || (classes && names->class_of == NULL) || (titles && names->title_of == NULL)) {
    return failure_of_memory(failure);
  }
  for (size_t i = 0; i < atoms; ++i) {
    char *text = names->text + 2 * i * NAME_BYTES;
    put_class(text, &molecule->label[i]);
    put_title(text + NAME_BYTES, &molecule->label[i]);
    if (classes) names->class_of[i] = text;
    if (titles) names->title_of[i] = text + NAME_BYTES;
  }
  return true;
}

void ball_names_free(struct ball_names *names) {
  free(names->text);
  free(names->class_of);
  free(names->title_of);
  *names = (struct ball_names)BALL_NAMES_NONE;
}
