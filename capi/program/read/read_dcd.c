/* Records of Fortran: length, bytes, length again. The first holds CORD and 20 numbers of 32 bits, by place from 0:
 * 1 first step, 2 steps between frames, 8 fixed atoms, 9 time between steps (float), 10 cells, 11 a fourth coordinate,
 * 19 CHARMM's version. X-PLOR has 0 there, a double in 9 and 10, and no cells. Then come titles, the number of atoms
 * and, if some are fixed, the places of the others. A frame is its cell (6 doubles), if the file has those, and all x,
 * all y and all z as floats. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/number.h"
#include "read/trajectory.h"

enum { HEADER_BYTES = 84, CELL_BYTES = 48, CHUNK_FLOATS = 2048 };

/* Other programs, which write angles or their cosines, give themselves versions up to this. */
enum { LAST_VERSION_OF_ANGLES = 24 };

/* CHARMM's unit of time, sqrt(u angstrom^2 / (kcal/mol)), in picoseconds. */
static const double picoseconds = 0.04888821;

static bool damaged(struct failure *failure, const char *what) {
  return failure_in_input(failure, 0, "%s", what);
}

/* A record's length. */
static bool take_mark(const struct dcd *dcd, struct byte_reader *reader, uint32_t *length, struct failure *failure) {
  unsigned char bytes[4];
  if (!byte_reader_take(reader, bytes, 4, failure)) return false;
  *length = bytes_to_u32(bytes, dcd->highest_first);
  return true;
}

static bool take_end(const struct dcd *dcd, struct byte_reader *reader, uint32_t expected, struct failure *failure) {
  uint32_t length = 0;
  if (!take_mark(dcd, reader, &length, failure)) return false;
  return length == expected || damaged(failure, "the two lengths of a record differ");
}

/* A record of a known length in memory. */
static bool take_record(const struct dcd *dcd, struct byte_reader *reader, unsigned char *out, uint32_t expected,
                        struct failure *failure) {
  uint32_t length = 0;
  if (!take_mark(dcd, reader, &length, failure)) return false;
  if (length != expected) {
    return failure_in_input(failure, 0, "a record has %" PRIu32 " bytes where %" PRIu32 " belong", length, expected);
  }
  return byte_reader_take(reader, out, expected, failure) && take_end(dcd, reader, expected, failure);
}

static bool take_header(struct dcd *dcd, struct byte_reader *reader, uint32_t *fixed, struct failure *failure) {
  unsigned char bytes[4 + HEADER_BYTES];
  if (!byte_reader_take(reader, bytes, 8, failure)) return false;
  dcd->highest_first = bytes_to_u32(bytes, false) != HEADER_BYTES;
  if (bytes_to_u64(bytes, false) == HEADER_BYTES || bytes_to_u64(bytes, true) == HEADER_BYTES) {
    return damaged(failure, "lengths of records in 64 bits are not read");
  }
  if (bytes_to_u32(bytes, dcd->highest_first) != HEADER_BYTES) {
    return damaged(failure, "this is no .dcd file: it does not begin with a record of 84 bytes");
  }
  if (memcmp(bytes + 4, "CORD", 4) != 0) return damaged(failure, "this .dcd file holds no coordinates");
  if (!byte_reader_take(reader, bytes + 8, HEADER_BYTES - 4, failure)) return false;
  if (!take_end(dcd, reader, HEADER_BYTES, failure)) return false;
  uint32_t number[20];
  for (int i = 0; i < 20; ++i) number[i] = bytes_to_u32(bytes + 8 + 4 * i, dcd->highest_first);
  const bool charmm = number[19] != 0;
  dcd->first_step = bits_to_i32(number[1]);
  dcd->interval = bits_to_i32(number[2]);
  dcd->delta =
      charmm ? (double)bits_to_float(number[9]) : bits_to_double(bytes_to_u64(bytes + 8 + 4 * 9, dcd->highest_first));
  if (!is_finite(dcd->delta) || dcd->delta < 0.0) dcd->delta = 0.0;
  dcd->has_cell = charmm && number[10] != 0;
  dcd->has_vectors = number[19] > LAST_VERSION_OF_ANGLES;
  dcd->has_fourth = charmm && number[11] != 0;
  *fixed = number[8];
  return true;
}

static bool skip_titles(const struct dcd *dcd, struct byte_reader *reader, struct failure *failure) {
  uint32_t length = 0;
  return take_mark(dcd, reader, &length, failure) && byte_reader_skip(reader, length, failure) &&
         take_end(dcd, reader, length, failure);
}

static bool take_free_atoms(struct dcd *dcd, struct byte_reader *reader, uint32_t atoms, struct failure *failure) {
  uint32_t length = 0;
  dcd->free_place = malloc(((size_t)dcd->free_atoms + 1) * sizeof *dcd->free_place);
  if (dcd->free_place == NULL) return failure_of_memory(failure);
  if (!take_mark(dcd, reader, &length, failure)) return false;
  if (length != 4 * dcd->free_atoms) return damaged(failure, "the list of atoms that move has another length");
  for (uint32_t i = 0; i < dcd->free_atoms; ++i) {
    unsigned char bytes[4];
    if (!byte_reader_take(reader, bytes, 4, failure)) return false;
    const uint32_t place = bytes_to_u32(bytes, dcd->highest_first);
    if (place == 0 || place > atoms) return damaged(failure, "the list of atoms that move is damaged");
    dcd->free_place[i] = place - 1;
  }
  return take_end(dcd, reader, length, failure);
}

/* Files of another number of atoms fail. */
static bool begin(struct trajectory *of, struct failure *failure) {
  struct dcd *const dcd = &of->dcd;
  struct byte_reader *const reader = &of->bytes;
  const uint32_t atoms = of->atoms;
  unsigned char bytes[4];
  uint32_t fixed = 0;
  if (!take_header(dcd, reader, &fixed, failure) || !skip_titles(dcd, reader, failure) ||
      !take_record(dcd, reader, bytes, 4, failure)) {
    return false;
  }
  const uint32_t count = bytes_to_u32(bytes, dcd->highest_first);
  if (count != atoms) {
    return failure_in_input(failure, 0, "%" PRIu32 " in place of %" PRIu32 " atoms", count, atoms);
  }
  if (fixed > atoms) return damaged(failure, "more fixed atoms than atoms");
  dcd->free_atoms = atoms - fixed;
  return fixed == 0 || take_free_atoms(dcd, reader, atoms, failure);
}

/* Read all x, or all y, or all z: of all atoms, or of those that move. */
static bool take_axis(const struct dcd *dcd, struct byte_reader *reader, bool wanted, uint32_t count,
                      const uint32_t *place, double *out, struct failure *failure) {
  uint32_t length = 0;
  if (!take_mark(dcd, reader, &length, failure)) return false;
  if (length != 4 * count) {
    return failure_in_input(failure, 0, "coordinates of %" PRIu32 " atoms where %" PRIu32 " belong", length / 4, count);
  }
  if (!wanted) {
    return byte_reader_skip(reader, length, failure) && take_end(dcd, reader, length, failure);
  }
  unsigned char bytes[4 * CHUNK_FLOATS];
  for (uint32_t begin = 0; begin < count; begin += CHUNK_FLOATS) {
    const uint32_t piece = count - begin < CHUNK_FLOATS ? count - begin : CHUNK_FLOATS;
    if (!byte_reader_take(reader, bytes, 4 * (size_t)piece, failure)) return false;
    for (uint32_t k = 0; k < piece; ++k) {
      const uint32_t atom = place == NULL ? begin + k : place[begin + k];
      out[3 * (size_t)atom] = (double)bits_to_float(bytes_to_u32(bytes + 4 * (size_t)k, dcd->highest_first));
    }
  }
  return take_end(dcd, reader, length, failure);
}

/* Six finite numbers: what they mean differs between writers; take_cell knows three ways. */
static bool check_cell(const struct dcd *dcd, const unsigned char *bytes, struct failure *failure) {
  for (int k = 0; k < 6; ++k) {
    if (!is_finite(bits_to_double(bytes_to_u64(bytes + 8 * k, dcd->highest_first)))) {
      return damaged(failure, "its cell is not finite");
    }
  }
  return true;
}

/* Whether the numbers are vectors: no right angle, which hardly any vector has as a component. Of versions that may
 * have written angles none of those, nor their cosines, may do. */
static bool are_vectors(const struct dcd *dcd, const double number[6]) {
  bool cosines = true, angles = true, right = false;
  static const int place[3] = {1, 3, 4};
  for (int k = 0; k < 3; ++k) {
    const double value = number[place[k]];
    cosines = cosines && fabs(value) <= 1.0;
    angles = angles && value > 0.0 && value < 180.0;
    right = right || value == 90.0;
  }
  return !right && (dcd->has_vectors || (!cosines && !angles));
}

/* a_x, a_y, b_y, a_z, b_z, c_z of a matrix that is its own mirror image; or a, gamma, b, beta, alpha, c: angles in
 * degrees, or their cosines where all are that small. */
static void take_cell(const struct dcd *dcd, const unsigned char *bytes, struct box_record *box) {
  double number[6];
  for (int k = 0; k < 6; ++k) number[k] = bits_to_double(bytes_to_u64(bytes + 8 * k, dcd->highest_first));
  if (are_vectors(dcd, number)) {
    const double vector[9] = {number[0], number[1], number[3], number[1], number[2],
                              number[4], number[3], number[4], number[5]};
    box_from_vectors(vector, box);
    return;
  }
  const double length[3] = {number[0], number[2], number[5]};
  double angle[3] = {number[4], number[3], number[1]};
  const bool cosines = fabs(angle[0]) <= 1.0 && fabs(angle[1]) <= 1.0 && fabs(angle[2]) <= 1.0;
  for (int k = 0; k < 3 && cosines; ++k) {
    angle[k] = angle[k] == 0.0 ? 90.0 : acos(angle[k]) * (180.0 / 3.14159265358979323846);
  }
  box_from_angles(length, angle, box);
}

static bool take_frame(struct dcd *dcd, struct byte_reader *reader, bool wanted, uint32_t atoms, double *xyz,
                       struct failure *failure) {
  const bool all = dcd->frames == 0 || dcd->free_place == NULL;
  const uint32_t count = all ? atoms : dcd->free_atoms;
  for (int axis = 0; axis < 3; ++axis) {
    const uint32_t *place = all ? NULL : dcd->free_place;
    if (!take_axis(dcd, reader, wanted, count, place, xyz + axis, failure)) return false;
  }
  return !dcd->has_fourth || take_axis(dcd, reader, false, count, NULL, xyz, failure);
}

/* The coordinates of the frame before are kept: fixed atoms are only in the first frame. */
static enum line_status next_frame(struct trajectory *of, bool wanted, struct failure *failure) {
  struct dcd *const dcd = &of->dcd;
  struct byte_reader *const reader = &of->bytes;
  struct frame_stamp *const stamp = &of->stamp;
  if (byte_reader_at_end(reader)) return LINE_END;
  unsigned char cell[CELL_BYTES];
  if (dcd->has_cell && (!take_record(dcd, reader, cell, CELL_BYTES, failure) || !check_cell(dcd, cell, failure))) {
    return LINE_FAILED;
  }
  wanted = wanted || (dcd->frames == 0 && dcd->free_place != NULL);
  if (!take_frame(dcd, reader, wanted, of->atoms, of->xyz, failure)) return LINE_FAILED;
  const int64_t step = dcd->first_step + (int64_t)dcd->frames * dcd->interval;
  stamp->stepped = dcd->interval > 0;
  stamp->step = step;
  stamp->timed = stamp->stepped && dcd->delta > 0.0;
  stamp->time = (double)step * dcd->delta * picoseconds;
  if (dcd->has_cell) take_cell(dcd, cell, &stamp->box);
  ++dcd->frames;
  return LINE_READ;
}

void dcd_free(struct dcd *dcd) {
  free(dcd->free_place);
  dcd->free_place = NULL;
}

const struct file_format dcd_format = {
    .name = "dcd", .extensions = "DCD", ANGSTROM, .features = FILE_FRAMES, .begin = begin, .next_frame = next_frame};
