#include "read/file_box.h"

#include <math.h>
#include <string.h>

#include "read/fields.h"
#include "read/number.h"
#include "read/title_value.h"
#include "read/vectors.h"

/* Exact where the angle is a right one. */
static double cosine(double degrees) {
  return degrees == 90.0 ? 0.0 : cos(degrees * (3.14159265358979323846 / 180.0));
}

/* A cube of side 1 is smaller than an atom. */
static bool is_placeholder(const double vector[9]) {
  for (int k = 0; k < 9; ++k) {
    if (vector[k] != (k % 4 == 0 ? 1.0 : 0.0)) return false;
  }
  return true;
}

void box_from_angles(const double length[3], const double angle[3], struct box_record *box) {
  memset(box, 0, sizeof *box);
  box->denied = true;
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
  box->denied = is_placeholder(box->vector);
  box->given = !box->denied;
}

/* The determinant of three vectors: below 0 if they are left-handed. */
static double volume_of(const double v[9]) {
  return v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6]) + v[2] * (v[3] * v[7] - v[4] * v[6]);
}

void box_from_vectors(const double vector[9], struct box_record *box) {
  memset(box, 0, sizeof *box);
  const double volume = volume_of(vector);
  box->denied = is_placeholder(vector) || volume == 0.0 || !is_finite(volume);
  if (box->denied) return;
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
  box_from_angles(number, number + 3, box);
}

/* Along how many vectors the box repeats, by pbc, which says so of each or of all of them; 3 where there is no such
 * key. Negative: it says something else. */
static int directions_of(const char *title) {
  struct field value, word[3];
  if (!title_value(title, "pbc", &value)) return 3;
  const size_t words = title_value_split(value, word, 3);
  if (words != 1 && words != 3) return -1;
  int directions = 0;
  for (size_t k = 0; k < words; ++k) {
    const bool yes = field_is(word[k], "T") || field_is(word[k], "TRUE") || field_is(word[k], "1");
    if (!yes && !field_is(word[k], "F") && !field_is(word[k], "FALSE") && !field_is(word[k], "0")) return -1;
    if (yes) directions += words == 1 ? 3 : 1;
  }
  return directions;
}

/* Nine numbers, or three of a box of right angles. */
static bool parse_lattice(struct field value, double vector[9]) {
  struct field part[9];
  const size_t count = title_value_split(value, part, 9);
  if (count != 3 && count != 9) return false;
  memset(vector, 0, 9 * sizeof *vector);
  for (size_t k = 0; k < count; ++k) {
    if (number_parse(part[k].text, part[k].length, &vector[count == 3 ? 4 * k : k]) != NUMBER_OK) return false;
  }
  return true;
}

void box_from_title(const char *title, struct box_record *box) {
  struct field value;
  double vector[9];
  memset(box, 0, sizeof *box);
  if (!title_value(title, "Lattice", &value)) return;
  const int directions = directions_of(title);
  if (directions == 3 && parse_lattice(value, vector)) {
    box_from_vectors(vector, box);
    return;
  }
  box->denied = true;
  box->fault = directions < 0    ? "pbc is not of the form \"T T T\""
               : directions == 1 ? "by pbc it is periodic in one direction alone"
               : directions == 2 ? "by pbc it is periodic in two directions alone"
               : directions == 3 ? "Lattice is not of the form \"a_x a_y a_z b_x .. c_z\""
                                 : NULL;
}

static void combine(const double v[9], const double factor[3], double out[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    out[axis] = factor[0] * v[axis] + factor[1] * v[3 + axis] + factor[2] * v[6 + axis];
  }
}

void box_point(const struct box_record *box, const double fraction[3], double out[3]) {
  combine(box->vector, fraction, out);
}

void box_fractions(const struct box_record *box, const double point[3], double out[3]) {
  const double volume = volume_of(box->vector);
  for (int k = 0; k < 3; ++k) {
    double with_point[9];
    memcpy(with_point, box->vector, sizeof with_point);
    memcpy(with_point + 3 * k, point, 3 * sizeof *point);
    out[k] = volume_of(with_point) / volume;
  }
}

double box_distance(const struct box_record *box, int k) {
  double across[3];
  cross(box->vector + 3 * ((k + 1) % 3), box->vector + 3 * ((k + 2) % 3), across);
  return fabs(volume_of(box->vector)) / vector_length(across);
}

void box_axes(const struct box_record *box, double axis[9]) {
  const double *const v = box->vector, a = vector_length(v);
  for (int k = 0; k < 3; ++k) axis[k] = v[k] / a;
  const double shared = dot(v + 3, axis);
  for (int k = 0; k < 3; ++k) axis[3 + k] = v[3 + k] - shared * axis[k];
  const double b = vector_length(axis + 3);
  for (int k = 0; k < 3; ++k) axis[3 + k] /= b;
  cross(axis, axis + 3, axis + 6);
}
