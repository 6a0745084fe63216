#include "file_box.h"

#include <math.h>
#include <string.h>

#include "fields.h"
#include "number.h"

/* Exact where the angle is a right one. */
static double cosine(double degrees) {
  return degrees == 90.0 ? 0.0 : cos(degrees * (3.14159265358979323846 / 180.0));
}

void box_from_angles(const double length[3], const double angle[3], struct box_record *box) {
  memset(box, 0, sizeof *box);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(length[axis] > 0.0) || !is_finite(length[axis]) || !(angle[axis] > 0.0 && angle[axis] < 180.0)) return;
  }
  const double alpha = cosine(angle[0]), beta = cosine(angle[1]), gamma = cosine(angle[2]);
  const double sine = gamma == 0.0 ? 1.0 : sqrt(1.0 - gamma * gamma);
  const double along_b = (alpha - beta * gamma) / sine;
  const double square = 1.0 - beta * beta - along_b * along_b;
  if (!(square > 0.0)) return;
  const double height = square == 1.0 ? 1.0 : sqrt(square);
  const double vector[9] = {
      length[0],         0.0, 0.0, length[1] * gamma, length[1] * sine, 0.0, length[2] * beta, length[2] * along_b,
      length[2] * height};
  /* No more digits than angles have: the same on every machine. */
  for (int k = 0; k < 9; ++k) box->vector[k] = round(vector[k] * 1e9) / 1e9;
  box->given = true;
}

void box_from_vectors(const double vector[9], struct box_record *box) {
  memset(box, 0, sizeof *box);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(vector[4 * axis] > 0.0)) return;
  }
  memcpy(box->vector, vector, sizeof box->vector);
  box->given = true;
}

void box_from_cryst1(const struct line_reader *reader, struct box_record *box) {
  static const char word[] = "CRYST1";
  if (reader->length < sizeof word - 1 || memcmp(reader->text, word, sizeof word - 1) != 0) return;
  static const size_t last[6] = {15, 24, 33, 40, 47, 54};
  double number[6];
  for (size_t k = 0; k < 6; ++k) {
    const struct field field = field_in_columns(reader->text, reader->length, k == 0 ? 7 : last[k - 1] + 1, last[k]);
    if (number_parse(field.text, field.length, &number[k]) != NUMBER_OK) return;
  }
  if (number[0] == 1.0 && number[1] == 1.0 && number[2] == 1.0) return;
  box_from_angles(number, number + 3, box);
}

void box_from_title(const char *title, struct box_record *box) {
  static const char key[] = "Lattice=\"";
  memset(box, 0, sizeof *box);
  const char *at = strstr(title, key);
  if (at == NULL) return;
  at += sizeof key - 1;
  struct field field[9];
  double vector[9];
  if (fields_split(at, strcspn(at, "\""), field, 9) != 9) return;
  for (int k = 0; k < 9; ++k) {
    if (number_parse(field[k].text, field[k].length, &vector[k]) != NUMBER_OK) return;
  }
  box_from_vectors(vector, box);
}
