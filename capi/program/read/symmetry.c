#include "read/symmetry.h"

#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/growing_array.h"
#include "read/number.h"

void symmetry_apply(const struct symmetry_operator *symmetry, const double point[3], double out[3]) {
  const double *r = symmetry->rotation;
  for (int row = 0; row < 3; ++row) {
    out[row] =
        r[3 * row] * point[0] + r[3 * row + 1] * point[1] + r[3 * row + 2] * point[2] + symmetry->translation[row];
  }
}

/* A conventional cell has 192 at most. */
enum { MOST_OPERATORS = 1000 };

static bool give_up(struct symmetry *symmetry) {
  symmetry->unreadable = true;
  symmetry->count = 0;
  return true;
}

static bool add_operator(struct symmetry *symmetry, const struct symmetry_operator *added, struct failure *failure) {
  if (symmetry->count == MOST_OPERATORS) return give_up(symmetry);
  return array_append(&symmetry->operators, &symmetry->count, &symmetry->capacity, added, sizeof *added) ||
         failure_of_memory(failure);
}

bool symmetry_row(const struct field *field, size_t fields, size_t row, struct symmetry_operator *out) {
  bool good = fields == 8;
  for (size_t k = 0; good && k < 4; ++k) {
    double *const value = k < 3 ? &out->rotation[3 * row + k] : &out->translation[row];
    good = number_parse(field[4 + k].text, field[4 + k].length, value) == NUMBER_OK;
  }
  return good;
}

/* REMARK 290 SMTRYr n a b c t: row r of operator n. */
static bool take_row(struct symmetry *symmetry, const struct field *field, size_t fields, struct failure *failure) {
  static const struct symmetry_operator zeros = {{0}, {0}};
  const size_t row = (size_t)(field[2].text[field[2].length - 1] - '1');
  uint64_t serial;
  const bool good = !symmetry->unreadable && fields > 3 && row == symmetry->rows % 3 &&
                    number_parse_count(field[3].text, field[3].length, &serial) == NUMBER_OK &&
                    serial == symmetry->count + (row == 0 ? 1 : 0);
  if (!good) return give_up(symmetry);
  if (row == 0 && !add_operator(symmetry, &zeros, failure)) return false;
  if (symmetry->unreadable) return true;
  if (!symmetry_row(field, fields, row, &symmetry->operators[symmetry->count - 1])) return give_up(symmetry);
  symmetry->rows = row + 1;
  symmetry->cartesian = true;
  return true;
}

/* SCALEr: three numbers in columns 11 to 40, and one in 46 to 55. */
static void take_scale(struct symmetry *symmetry, const struct line_reader *reader) {
  const size_t row = (size_t)(reader->text[5] - '1');
  double number[4];
  for (size_t k = 0; k < 4; ++k) {
    const size_t first = k < 3 ? 11 + 10 * k : 46;
    const struct field field = field_in_columns(reader->text, reader->length, first, first + 9);
    if (number_parse(field.text, field.length, &number[k]) != NUMBER_OK) return;
  }
  memcpy(symmetry->scale + 3 * row, number, 3 * sizeof *number);
  symmetry->origin[row] = number[3];
  symmetry->scaled[row] = true;
}

static bool is_count(struct field text) {
  uint64_t count;
  return number_parse_count(text.text, text.length, &count) == NUMBER_OK;
}

bool symmetry_take_pdb_record(struct symmetry *symmetry, const struct line_reader *reader, struct failure *failure) {
  if (strncmp(reader->text, "CRYST1", 6) == 0) {
    const struct field name = field_in_columns(reader->text, reader->length, 56, 66);
    const size_t length = name.length < sizeof symmetry->space_group ? name.length : sizeof symmetry->space_group - 1;
    memcpy(symmetry->space_group, name.text, length);
    symmetry->space_group[length] = '\0';
    return true;
  }
  if (strncmp(reader->text, "SCALE", 5) == 0 && reader->text[5] >= '1' && reader->text[5] <= '3') {
    take_scale(symmetry, reader);
    return true;
  }
  if (strncmp(reader->text, "MTRIX1", 6) == 0) {
    /* A 1 in column 60: the copy is in the file. */
    if (!field_is(field_in_columns(reader->text, reader->length, 60, 60), "1")) ++symmetry->matrices;
    return true;
  }
  struct field field[8];
  const size_t fields = fields_split(reader->text, reader->length, field, 8);
  if (fields < 3 || !field_is(field[0], "REMARK") || !field_is(field[1], "290")) return true;
  if (fields == 4 && is_count(field[2]) && memchr(field[3].text, ',', field[3].length) != NULL) {
    return symmetry_take_triplet(symmetry, field[3], failure);
  }
  const bool row = field_is(field[2], "SMTRY1") || field_is(field[2], "SMTRY2") || field_is(field[2], "SMTRY3");
  const bool known = symmetry->count > 0 && !symmetry->cartesian;
  return !row || known || take_row(symmetry, field, fields, failure);
}

/* A whole number, a decimal one or a fraction of two, without sign. *at steps behind it. */
static bool take_number(struct field text, size_t *at, double *value) {
  double part[2] = {0.0, 1.0};
  for (int k = 0; k < 2; ++k) {
    size_t end = *at;
    while (end < text.length && (is_digit(text.text[end]) || text.text[end] == '.')) ++end;
    if (number_parse(text.text + *at, end - *at, &part[k]) != NUMBER_OK) return false;
    *at = end;
    if (k == 1 || end == text.length || text.text[end] != '/') break;
    ++*at;
  }
  *value = part[0] / part[1];
  return part[1] != 0.0;
}

/* One of the three sums, for instance "1/2+x-y". */
static bool parse_sum(struct field text, double row[3], double *translation) {
  size_t terms = 0;
  for (size_t at = 0; at < text.length; ++terms) {
    const bool negative = text.text[at] == '-';
    if (negative || text.text[at] == '+') {
      ++at;
    } else if (terms > 0) {
      return false;
    }
    double factor = 1.0;
    const bool number = at < text.length && (is_digit(text.text[at]) || text.text[at] == '.');
    if (number && !take_number(text, &at, &factor)) return false;
    if (number && at < text.length && text.text[at] == '*') ++at;
    const char letter = at < text.length ? to_lower(text.text[at]) : ' ';
    const bool axis = letter >= 'x' && letter <= 'z';
    if (!axis && !number) return false;
    if (axis) ++at;
    *(axis ? &row[letter - 'x'] : translation) += negative ? -factor : factor;
  }
  return terms > 0;
}

bool symmetry_take_triplet(struct symmetry *symmetry, struct field text, struct failure *failure) {
  enum { MOST = 80 };
  char dense[MOST]; /* without blanks */
  size_t length = 0;
  struct symmetry_operator added = {{0}, {0}};
  for (size_t i = 0; i < text.length && length < MOST; ++i) {
    if (!is_blank(text.text[i])) dense[length++] = text.text[i];
  }
  bool good = !symmetry->unreadable && length < MOST;
  size_t begin = 0;
  for (size_t row = 0; good && row < 3; ++row) {
    size_t end = begin;
    while (end < length && dense[end] != ',') ++end;
    good = (row == 2) == (end == length) &&
           parse_sum((struct field){dense + begin, end - begin}, added.rotation + 3 * row, &added.translation[row]);
    begin = end + 1;
  }
  return good ? add_operator(symmetry, &added, failure) : give_up(symmetry);
}

bool symmetry_is_none(const struct symmetry *symmetry) {
  size_t letters = 0;
  const char *const p1 = "P1";
  bool other = false;
  for (const char *c = symmetry->space_group; *c != '\0'; ++c) {
    if (is_blank(*c)) continue;
    other = other || letters >= 2 || to_upper(*c) != p1[letters];
    ++letters;
  }
  other = other || letters == 1;
  return !other && symmetry->matrices == 0 && symmetry->count < 2 && !symmetry->unreadable;
}

void symmetry_free(struct symmetry *symmetry) {
  free(symmetry->operators);
  memset(symmetry, 0, sizeof *symmetry);
}
