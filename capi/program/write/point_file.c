#include "write/point_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "read/file_format.h"
#include "write/cif_output.h"
#include "write/output_file.h"
#include "write/pdb_number.h"

enum { MOST_SERIALS = 99999, MOST_NUMBERS = 9999, NUMBER_BYTES = 12 };

static void add_cif(const struct point *points, size_t count, struct text_buffer *out) {
  text_buffer_add_text(out, "data_pores\n");
  if (count > 0) cif_sites_begin(out);
  for (size_t i = 0; i < count; ++i) {
    const struct point *const point = &points[i];
    const char chain[2] = {point->chain, '\0'};
    char number[NUMBER_BYTES];
    snprintf(number, sizeof number, "%" PRIu32, point->number);
    const struct site site = {"HETATM", "X", point->atom, point->residue, chain, number, "", point->xyz, point->radius};
    cif_site(out, (uint32_t)i + 1, &site);
  }
}

static bool add_pdb_atom(const struct point *point, uint32_t serial, struct text_buffer *out) {
  char number[4][PDB_NUMBER_BYTES];
  bool fits = serial <= MOST_SERIALS && point->number <= MOST_NUMBERS && pdb_number(number[3], 6, 2, point->radius);
  for (int axis = 0; axis < 3; ++axis) fits = fits && pdb_number(number[axis], 8, 3, point->xyz[axis]);
  if (!fits) return false;
  text_buffer_add(out, "HETATM%5" PRIu32 "  %-3s %3s %c%4" PRIu32 "    %s%s%s  1.00%s           X\n", serial,
                  point->atom, point->residue, point->chain, point->number, number[0], number[1], number[2], number[3]);
  return true;
}

static bool add_pdb(const struct point *points, size_t count, struct text_buffer *out, struct failure *failure) {
  text_buffer_add_text(out, "REMARK   6 POINTS OF PORES; THEIR RADII ARE THE TEMPERATURE FACTORS\n");
  for (size_t i = 0; i < count; ++i) {
    if (add_pdb_atom(&points[i], (uint32_t)i + 1, out)) continue;
    return failure_in_input(failure, 0, "its points do not fit into the columns of a .pdb file; a .cif file has room");
  }
  for (size_t i = 0; i < count; ++i) {
    const bool after = i + 1 < count && points[i + 1].joined;
    if (!points[i].joined && !after) continue;
    text_buffer_add(out, "CONECT%5" PRIu32, (uint32_t)i + 1);
    if (points[i].joined) text_buffer_add(out, "%5" PRIu32, (uint32_t)i);
    if (after) text_buffer_add(out, "%5" PRIu32, (uint32_t)i + 2);
    text_buffer_add_text(out, "\n");
  }
  text_buffer_add_text(out, "END\n");
  return true;
}

bool point_file_write(const struct point *points, size_t count, const char *path, struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  const char first = *file_extension(path); /* of .pdb or .cif, as has been checked, or none */
  const bool cif = first == 'c' || first == 'C';
  if (cif) add_cif(points, count, &out);
  const bool done = (cif || add_pdb(points, count, &out, failure)) && output_file_write_text(path, &out, failure);
  text_buffer_free(&out);
  return done;
}
