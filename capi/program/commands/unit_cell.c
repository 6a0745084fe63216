#include "commands/unit_cell.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/image_table.h"
#include "hardsphere.h"
#include "read/vectors.h"
#include "write/report.h"

/* Errors of numbers in operators: these are whole numbers and 24ths, but files have only a few digits of them. */
static const double rotation_blur = 2e-3, translation_blur = 5e-4;

/* The relative error of squares of the cell's lengths. */
static const double cell_blur = 5e-3;

/* The relative error of vectors that follow from SCALE. */
static const double frame_blur = 1e-3;

static double nearest(double value) {
  return floor(value + 0.5);
}

/* An operator of points in angstrom becomes one of fractions. */
static void make_fractional(const struct box_record *box, struct symmetry_operator *symmetry) {
  struct symmetry_operator out;
  struct symmetry_operator rotation = *symmetry;
  memset(rotation.translation, 0, sizeof rotation.translation);
  for (int column = 0; column < 3; ++column) {
    double image[3], fraction[3];
    symmetry_apply(&rotation, box->vector + 3 * column, image);
    box_fractions(box, image, fraction);
    for (int row = 0; row < 3; ++row) out.rotation[3 * row + column] = fraction[row];
  }
  box_fractions(box, symmetry->translation, out.translation);
  *symmetry = out;
}

/* Whether it takes the vectors of the box to others of the same lengths and angles. */
static bool is_isometry(const struct box_record *box, const struct symmetry_operator *symmetry) {
  struct symmetry_operator rotation = *symmetry;
  double image[3][3];
  memset(rotation.translation, 0, sizeof rotation.translation);
  for (int k = 0; k < 3; ++k) {
    double unit[3] = {0.0, 0.0, 0.0}, turned[3];
    unit[k] = 1.0;
    symmetry_apply(&rotation, unit, turned);
    box_point(box, turned, image[k]);
  }
  for (int k = 0; k < 9; ++k) {
    const double *a = box->vector + 3 * (k / 3), *b = box->vector + 3 * (k % 3);
    const double *c = image[k / 3], *d = image[k % 3];
    if (!(fabs(dot(c, d) - dot(a, b)) <= cell_blur * sqrt(dot(a, a) * dot(b, b)))) return false;
  }
  return true;
}

/* Round the numbers of the operator to their exact values. False: it does not map the box's lattice to itself. */
static bool round_operator(const struct box_record *box, struct symmetry_operator *symmetry) {
  double *r = symmetry->rotation;
  for (int k = 0; k < 9; ++k) {
    const double whole = nearest(r[k]);
    if (!(fabs(r[k] - whole) <= rotation_blur)) return false;
    r[k] = whole;
  }
  for (int k = 0; k < 3; ++k) {
    const double part = nearest(24.0 * symmetry->translation[k]) / 24.0;
    if (fabs(symmetry->translation[k] - part) <= translation_blur) symmetry->translation[k] = part;
  }
  return is_isometry(box, symmetry);
}

/* Whether an operator moves atoms by nothing but whole vectors of the box. */
static bool is_identity(const struct symmetry_operator *symmetry) {
  for (int k = 0; k < 9; ++k) {
    if (symmetry->rotation[k] != (k % 4 == 0 ? 1.0 : 0.0)) return false;
  }
  for (int k = 0; k < 3; ++k) {
    if (symmetry->translation[k] != nearest(symmetry->translation[k])) return false;
  }
  return true;
}

static bool make_operators(struct molecule *molecule, struct failure *failure) {
  struct symmetry *symmetry = &molecule->symmetry;
  for (size_t k = 0; k < symmetry->count; ++k) {
    struct symmetry_operator *own = &symmetry->operators[k];
    if (symmetry->cartesian) make_fractional(&molecule->frame.box, own);
    if (round_operator(&molecule->frame.box, own)) continue;
    return failure_in_input(failure, 0,
                            "the symmetry of the file does not fit its box; --box p1 takes the atoms as they stand");
  }
  symmetry->cartesian = false;
  return true;
}

/* Which whole vectors of the box move the copy so that the mean of its centres is in it. */
static void find_shift(const double *fraction, uint32_t atoms, const struct symmetry_operator *symmetry,
                       double shift[3]) {
  double mean[3] = {0.0, 0.0, 0.0}, image[3];
  for (uint32_t i = 0; i < atoms; ++i) {
    for (int k = 0; k < 3; ++k) mean[k] += fraction[3 * (size_t)i + (size_t)k] / atoms;
  }
  symmetry_apply(symmetry, mean, image);
  for (int k = 0; k < 3; ++k) shift[k] = -floor(image[k]);
}

static bool add_copy(struct molecule *molecule, struct image_table *there, const double *fraction, uint32_t atoms,
                     const struct symmetry_operator *symmetry, struct failure *failure) {
  double shift[3];
  find_shift(fraction, atoms, symmetry, shift);
  for (uint32_t i = 0; i < atoms; ++i) {
    double image[3], xyz[3], own[3], error[3];
    symmetry_apply(symmetry, fraction + 3 * (size_t)i, image);
    image_table_error(there, i, own);
    for (int k = 0; k < 3; ++k) {
      const double *const row = symmetry->rotation + 3 * k;
      error[k] = fabs(row[0]) * own[0] + fabs(row[1]) * own[1] + fabs(row[2]) * own[2];
    }
    for (int k = 0; k < 3; ++k) image[k] += shift[k] - molecule->symmetry.origin[k];
    if (image_table_has(there, image, error, molecule->label[i].element)) {
      ++molecule->symmetry.shared;
      continue;
    }
    box_point(&molecule->frame.box, image, xyz);
    const struct atom_label label = molecule->label[i];
    if (!molecule_add(molecule, xyz, molecule->radius[i], &label, molecule->line[i], failure)) return false;
    image_table_add_last(there, error);
  }
  return true;
}

/* The vectors of the box as SCALE of a .pdb file has them: the columns of its inverse. */
static void vectors_of_scale(const double scale[9], struct box_record *out) {
  struct box_record rows = *out;
  memcpy(rows.vector, scale, sizeof rows.vector);
  for (int axis = 0; axis < 3; ++axis) {
    double unit[3] = {0.0, 0.0, 0.0}, row[3];
    unit[axis] = 1.0;
    box_fractions(&rows, unit, row);
    for (int k = 0; k < 3; ++k) out->vector[3 * k + axis] = row[k];
  }
}

/* Whether two boxes have the same vectors, within the six decimals of SCALE. */
static bool are_near(const struct box_record *a, const struct box_record *b) {
  const double most = frame_blur * (a->vector[0] + a->vector[4] + a->vector[8]);
  for (int k = 0; k < 9; ++k) {
    if (!(fabs(a->vector[k] - b->vector[k]) <= most)) return false;
  }
  return true;
}

/* The components of each vector along three unit vectors at right angles, or from these. */
static void vectors_along(const double vector[9], const double axis[9], double out[9]) {
  for (int k = 0; k < 9; ++k) {
    out[k] = dot(vector + 3 * (k / 3), axis + 3 * (k % 3));
  }
}
static void vectors_from(const double along[9], const double axis[9], double out[9]) {
  for (int k = 0; k < 9; ++k) {
    const double *const v = along + 3 * (k / 3), *const u = axis + k % 3;
    out[k] = v[0] * u[0] + v[1] * u[3] + v[2] * u[6];
  }
}

/* Put the box into the frame of the atoms: a few entries of the PDB have another frame and origin, which SCALE tells
 * unless it is the identity. The box's orientation follows from the six decimals of SCALE, its shape from lengths and
 * angles. The operators, if they are to be used, become those of fractions. */
static bool settle(struct molecule *molecule, bool with_operators, struct failure *failure) {
  struct box_record *box = &molecule->frame.box;
  struct symmetry *symmetry = &molecule->symmetry;
  const struct box_record plain = *box;
  struct box_record frame = plain;
  const bool scaled = symmetry->scaled[0] && symmetry->scaled[1] && symmetry->scaled[2];
  if (scaled) vectors_of_scale(symmetry->scale, &frame);
  struct box_record upright = frame;
  double axis[9];
  box_axes(&frame, axis);
  vectors_along(frame.vector, axis, upright.vector);
  const bool fits = scaled && are_near(&plain, &upright);
  const bool elsewhere = fits && !are_near(&plain, &frame);
  if (!fits || symmetry->cartesian) memset(symmetry->origin, 0, sizeof symmetry->origin);
  if (elsewhere) *box = frame;
  if (with_operators && !make_operators(molecule, failure)) return false;
  if (elsewhere) vectors_from(plain.vector, axis, box->vector);
  return true;
}

bool unit_cell_fill(const struct request *request, struct molecule *molecule, struct failure *failure) {
  struct symmetry *symmetry = &molecule->symmetry;
  const uint32_t atoms = molecule->atoms;
  if (request->box.source != BOX_OF_FILE || !molecule->frame.box.given) return true;
  const bool fills = !request->box.without_copies && symmetry->count > 1;
  if (!settle(molecule, fills, failure)) return false;
  if (!fills) return true;
  struct image_table there;
  const size_t most = (size_t)atoms * (symmetry->count + 1);
  double *fraction = malloc(((size_t)atoms + 1) * 3 * sizeof *fraction);
  bool done = image_table_begin(&there, molecule, most < HSP_MAX_BALLS ? most : HSP_MAX_BALLS, failure);
  if (fraction == NULL) done = failure_of_memory(failure);
  for (size_t i = 0; done && i < atoms; ++i) {
    box_fractions(&molecule->frame.box, molecule->xyz + 3 * i, fraction + 3 * i);
    for (size_t k = 0; k < 3; ++k) fraction[3 * i + k] += symmetry->origin[k];
  }
  for (size_t k = 0; done && k < symmetry->count; ++k) {
    const struct symmetry_operator *own = &symmetry->operators[k];
    if (!is_identity(own)) done = add_copy(molecule, &there, fraction, atoms, own, failure);
  }
  image_table_free(&there);
  free(fraction);
  symmetry->filled = done;
  return done;
}

/* "; copies by MTRIX that are not made: 59" */
static const char *matrices_text(char out[80], const struct symmetry *symmetry) {
  out[0] = '\0';
  if (symmetry->matrices > 0) {
    snprintf(out, 80, "; copies by MTRIX that are not made: %lu", (unsigned long)symmetry->matrices);
  }
  return out;
}

const char *unit_cell_text(char value[UNIT_CELL_TEXT_BYTES], const struct symmetry *symmetry) {
  char matrices[80], shared[NUMBER_BYTES];
  const char *name = symmetry->space_group[0] == '\0' ? "not named" : symmetry->space_group;
  if (!symmetry->filled) {
    snprintf(value, UNIT_CELL_TEXT_BYTES, "%s: copies by symmetry are not made%s%s", name,
             symmetry->unreadable  ? ", the file's operators cannot be read"
             : symmetry->count < 2 ? ", the file has no operators"
                                   : "",
             matrices_text(matrices, symmetry));
  } else {
    snprintf(
        value, UNIT_CELL_TEXT_BYTES, "%s: the box is filled by %lu operators%s%s%s", name,
        (unsigned long)symmetry->count, symmetry->shared > 0 ? "; images on special positions that count once: " : "",
        symmetry->shared > 0 ? count_text(shared, (int64_t)symmetry->shared) : "", matrices_text(matrices, symmetry));
  }
  return value;
}

void unit_cell_record(struct record *record, const struct symmetry *symmetry) {
  char value[UNIT_CELL_TEXT_BYTES];
  if (!symmetry_is_none(symmetry)) {
    record_text(record, NULL, "space group", unit_cell_text(value, symmetry), "");
  }
  if (!record_key(record, "symmetry")) return;
  struct record own = {.form = AS_JSON, .out = record->out};
  text_buffer_add_text(own.out, "{");
  record_text(&own, "space_group", NULL, symmetry->space_group, "");
  record_count(&own, "operators", NULL, (int64_t)symmetry->count, "");
  record_whether(&own, "filled", NULL, symmetry->filled, "");
  record_count(&own, "special_positions", NULL, (int64_t)symmetry->shared, "");
  record_count(&own, "matrices", NULL, (int64_t)symmetry->matrices, "");
  text_buffer_add_text(own.out, "}");
}
