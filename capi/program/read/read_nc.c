/* Numbers have their highest byte first. The file begins with CDF and a version: 1, 2 with offsets of 64 bits, or 5
 * with counts of 64 bits too. Then come the number of frames and three lists: dimensions, each a name and a length, of
 * which that of frames is 0; attributes; variables, each a name, its dimensions, attributes, kind, size and where it
 * begins. A list is a tag, a count and its items, and names and values are filled up to four bytes. Variables whose
 * first dimension is that of frames lie behind all others, one after another for each frame. AMBER's convention names
 * them: coordinates, by atoms and axes; time; cell_lengths and cell_angles. An attribute scale_factor multiplies. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/number.h"
#include "read/trajectory.h"

enum { TAG_DIMENSIONS = 10, TAG_VARIABLES = 11, TAG_ATTRIBUTES = 12 };
enum { KIND_CHARACTERS = 2, KIND_FLOAT = 5, KIND_DOUBLE = 6, KINDS = 12 };
enum { NAME_BYTES = 24, TEXT_BYTES = 16, MOST_DIMENSIONS = 1024, CHUNK_NUMBERS = 1024 };

/* Bytes of a value of each kind; 0: there is none such. */
static const uint8_t width_of_kind[KINDS] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};

static const char *const names[NETCDF_USES] = {
    [NETCDF_COORDINATES] = "coordinates",
    [NETCDF_TIME] = "time",
    [NETCDF_LENGTHS] = "cell_lengths",
    [NETCDF_ANGLES] = "cell_angles",
};

static bool damaged(struct failure *failure) {
  return failure_in_input(failure, 0, "its header is damaged");
}

static bool take(struct trajectory *of, unsigned char *out, size_t count, struct failure *failure) {
  of->netcdf.place += count;
  return byte_reader_take(&of->bytes, out, count, failure);
}

static bool skip(struct trajectory *of, uint64_t count, struct failure *failure) {
  of->netcdf.place += count;
  return byte_reader_skip(&of->bytes, count, failure);
}

/* A number of 32 bits, or of 64. */
static bool take_whole(struct trajectory *of, bool wide, uint64_t *value, struct failure *failure) {
  unsigned char bytes[8];
  if (!take(of, bytes, wide ? 8 : 4, failure)) return false;
  *value = wide ? bytes_to_u64(bytes, true) : bytes_to_u32(bytes, true);
  return true;
}

static bool take_count(struct trajectory *of, uint64_t *value, struct failure *failure) {
  if (!take_whole(of, of->netcdf.wide_counts, value, failure)) return false;
  return *value <= INT64_MAX || damaged(failure);
}

static uint64_t filled(uint64_t bytes) {
  return (bytes + 3) / 4 * 4;
}

/* Read that many bytes and their padding. The first ones are kept, with a 0 behind them. */
static bool take_text(struct trajectory *of, uint64_t bytes, char *out, size_t room, struct failure *failure) {
  const size_t kept = bytes < room - 1 ? (size_t)bytes : room - 1;
  out[kept] = '\0';
  return take(of, (unsigned char *)out, kept, failure) && skip(of, filled(bytes) - kept, failure);
}

/* A name that is cut off equals no known name: all of these are shorter. */
static bool take_name(struct trajectory *of, char name[NAME_BYTES], struct failure *failure) {
  uint64_t bytes = 0;
  return take_count(of, &bytes, failure) && take_text(of, bytes, name, NAME_BYTES, failure);
}

/* The number of items; an empty list may have no tag. */
static bool take_list(struct trajectory *of, uint64_t expected, uint64_t *items, struct failure *failure) {
  uint64_t tag = 0;
  if (!take_whole(of, false, &tag, failure) || !take_count(of, items, failure)) return false;
  return tag == expected || (tag == 0 && *items == 0) || damaged(failure);
}

/* a * b, if that can be the size of something in a file. */
static bool multiply(uint64_t a, uint64_t b, uint64_t *product, struct failure *failure) {
  if (b != 0 && a > (uint64_t)INT64_MAX / b) return damaged(failure);
  *product = a * b;
  return true;
}

/* The attributes that matter. */
struct attributes {
  double scale;
  char unit[TEXT_BYTES];
};

static double number_at(const unsigned char *at, bool wide) {
  return wide ? bits_to_double(bytes_to_u64(at, true)) : float_as_written(bits_to_float(bytes_to_u32(at, true)));
}

static bool take_attribute(struct trajectory *of, struct attributes *attributes, struct failure *failure) {
  char name[NAME_BYTES];
  uint64_t kind = 0, count = 0, bytes = 0;
  if (!take_name(of, name, failure) || !take_whole(of, false, &kind, failure) || !take_count(of, &count, failure)) {
    return false;
  }
  if (kind >= KINDS || width_of_kind[kind] == 0) return damaged(failure);
  if (!multiply(count, width_of_kind[kind], &bytes, failure)) return false;
  if (kind == KIND_CHARACTERS && strcmp(name, "units") == 0) {
    return take_text(of, bytes, attributes->unit, TEXT_BYTES, failure);
  }
  const bool number = (kind == KIND_FLOAT || kind == KIND_DOUBLE) && count == 1;
  if (!number || strcmp(name, "scale_factor") != 0) return skip(of, filled(bytes), failure);
  unsigned char value[8];
  if (!take(of, value, (size_t)bytes, failure)) return false;
  attributes->scale = number_at(value, kind == KIND_DOUBLE);
  return is_finite(attributes->scale) || damaged(failure);
}

static bool take_attributes(struct trajectory *of, struct attributes *attributes, struct failure *failure) {
  uint64_t items = 0;
  *attributes = (struct attributes){.scale = 1.0};
  if (!take_list(of, TAG_ATTRIBUTES, &items, failure)) return false;
  for (uint64_t k = 0; k < items; ++k) {
    if (!take_attribute(of, attributes, failure)) return false;
  }
  return true;
}

static bool take_dimensions(struct trajectory *of, struct failure *failure) {
  struct netcdf *const netcdf = &of->netcdf;
  char name[NAME_BYTES];
  if (!take_list(of, TAG_DIMENSIONS, &netcdf->dimensions, failure)) return false;
  if (netcdf->dimensions > MOST_DIMENSIONS) return damaged(failure);
  netcdf->dimension = calloc((size_t)netcdf->dimensions + 1, sizeof *netcdf->dimension);
  if (netcdf->dimension == NULL) return failure_of_memory(failure);
  for (uint64_t k = 0; k < netcdf->dimensions; ++k) {
    if (!take_name(of, name, failure) || !take_count(of, &netcdf->dimension[k], failure)) return false;
  }
  return true;
}

/* The dimensions of a variable: the last two, how many numbers they make in a frame, or in all. */
struct shape {
  uint64_t rank, last[2], numbers;
  bool of_frames;
};

static bool take_shape(struct trajectory *of, struct shape *shape, struct failure *failure) {
  const struct netcdf *const netcdf = &of->netcdf;
  *shape = (struct shape){.numbers = 1};
  if (!take_count(of, &shape->rank, failure)) return false;
  for (uint64_t k = 0; k < shape->rank; ++k) {
    uint64_t number = 0;
    if (!take_count(of, &number, failure)) return false;
    if (number >= netcdf->dimensions) return damaged(failure);
    const uint64_t length = netcdf->dimension[number];
    if (length == 0 && k > 0) return damaged(failure);
    shape->of_frames = shape->of_frames || length == 0;
    shape->last[0] = shape->last[1];
    shape->last[1] = length;
    if (length > 0 && !multiply(shape->numbers, length, &shape->numbers, failure)) return false;
  }
  return true;
}

/* Whether a variable of that name has the form that the convention states. */
static bool check_field(enum netcdf_use use, const struct shape *shape, uint64_t kind, const char *unit, uint32_t atoms,
                        struct failure *failure) {
  const uint64_t rank = use == NETCDF_COORDINATES ? 3 : use == NETCDF_TIME ? 1 : 2;
  if (!shape->of_frames || shape->rank != rank || (rank > 1 && shape->last[1] != 3)) {
    return failure_in_input(failure, 0, "its variable %s is not by %s", names[use],
                            rank == 3   ? "frame, atom and axis"
                            : rank == 2 ? "frame, three numbers each"
                                        : "frame alone");
  }
  if (kind != KIND_FLOAT && kind != KIND_DOUBLE) {
    return failure_in_input(failure, 0, "its variable %s has neither floats nor doubles", names[use]);
  }
  if (rank == 3 && shape->last[0] != atoms) {
    return failure_in_input(failure, 0, "%" PRIu64 " in place of %" PRIu32 " atoms", shape->last[0], atoms);
  }
  const bool lengths = use == NETCDF_COORDINATES || use == NETCDF_LENGTHS;
  if (!lengths || unit[0] == '\0' || strncmp(unit + 1, "ngstrom", 7) == 0) return true;
  return failure_in_input(failure, 0, "its variable %s is not in angstrom", names[use]);
}

/* For all variables of frames together: where the first one begins, and their bytes in a frame. */
struct extent {
  uint64_t begin, bytes;
};

static bool take_variable(struct trajectory *of, struct extent *extent, struct failure *failure) {
  struct netcdf *const netcdf = &of->netcdf;
  char name[NAME_BYTES];
  struct shape shape;
  struct attributes attributes;
  uint64_t kind = 0, size = 0, begin = 0, bytes = 0;
  if (!take_name(of, name, failure) || !take_shape(of, &shape, failure) || !take_attributes(of, &attributes, failure) ||
      !take_whole(of, false, &kind, failure) || !take_whole(of, netcdf->wide_counts, &size, failure) ||
      !take_whole(of, netcdf->wide_offsets, &begin, failure)) {
    return false;
  }
  if (kind >= KINDS || width_of_kind[kind] == 0) return damaged(failure);
  if (!multiply(shape.numbers, width_of_kind[kind], &bytes, failure)) return false;
  int use = 0;
  while (use < NETCDF_USES && strcmp(name, names[use]) != 0) ++use;
  if (use < NETCDF_USES) {
    if (!check_field((enum netcdf_use)use, &shape, kind, attributes.unit, of->atoms, failure)) return false;
    if (netcdf->field[use].there) return damaged(failure);
    netcdf->field[use] = (struct netcdf_field){true, kind == KIND_DOUBLE, begin, bytes, attributes.scale};
  }
  if (!shape.of_frames) return true;
  /* The size that the file states is of 32 bits, and no size where that does not do: it is counted instead. */
  const uint64_t most = (uint64_t)INT64_MAX - 4;
  if (bytes > most || extent->bytes > most - bytes || begin > most - bytes) return damaged(failure);
  if (begin < extent->begin) extent->begin = begin;
  extent->bytes += filled(bytes);
  return true;
}

/* The next field of a frame in the order of the file, from a place in the frame on; NULL: there is none left. */
static const struct netcdf_field *next_field(const struct netcdf *netcdf, uint64_t from) {
  const struct netcdf_field *next = NULL;
  for (int use = 0; use < NETCDF_USES; ++use) {
    const struct netcdf_field *const field = &netcdf->field[use];
    if (field->there && field->begin >= from && (next == NULL || field->begin < next->begin)) next = field;
  }
  return next;
}

/* The fields lie in the frame, and one behind the other. */
static bool check_fields(const struct netcdf *netcdf, struct failure *failure) {
  int there = 0, met = 0;
  uint64_t from = 0;
  for (int use = 0; use < NETCDF_USES; ++use) there += netcdf->field[use].there ? 1 : 0;
  for (const struct netcdf_field *field; (field = next_field(netcdf, from)) != NULL; ++met) {
    from = field->begin + field->bytes;
  }
  return (met == there && from <= netcdf->stride) || damaged(failure);
}

static bool take_start(struct trajectory *of, struct failure *failure) {
  struct netcdf *const netcdf = &of->netcdf;
  unsigned char bytes[4];
  if (!take(of, bytes, 4, failure)) return false;
  if (memcmp(bytes, "\x89HDF", 4) == 0) {
    return failure_in_input(failure, 0, "NetCDF-4 files are not read; 'nccopy -k classic' makes them those that are");
  }
  if (memcmp(bytes, "CDF", 3) != 0 || (bytes[3] != 1 && bytes[3] != 2 && bytes[3] != 5)) {
    return failure_in_input(failure, 0, "this is no .nc file: it does not begin with CDF and a version");
  }
  netcdf->wide_offsets = bytes[3] != 1;
  netcdf->wide_counts = bytes[3] == 5;
  if (!take_whole(of, netcdf->wide_counts, &netcdf->frames, failure)) return false;
  netcdf->counted = netcdf->frames != (netcdf->wide_counts ? UINT64_MAX : UINT32_MAX);
  return true;
}

/* Files of another number of atoms fail. */
static bool begin(struct trajectory *of, struct failure *failure) {
  struct netcdf *const netcdf = &of->netcdf;
  struct attributes of_file;
  struct extent extent = {UINT64_MAX, 0};
  uint64_t variables = 0;
  if (!take_start(of, failure) || !take_dimensions(of, failure) || !take_attributes(of, &of_file, failure) ||
      !take_list(of, TAG_VARIABLES, &variables, failure)) {
    return false;
  }
  for (uint64_t k = 0; k < variables; ++k) {
    if (!take_variable(of, &extent, failure)) return false;
  }
  if (!netcdf->field[NETCDF_COORDINATES].there) return failure_in_input(failure, 0, "it has no coordinates");
  if (extent.begin < netcdf->place) return damaged(failure);
  netcdf->next = extent.begin;
  netcdf->stride = extent.bytes; /* coordinates alone, which would not be filled up, need not be */
  for (int use = 0; use < NETCDF_USES; ++use) {
    if (netcdf->field[use].there) netcdf->field[use].begin -= extent.begin;
  }
  return check_fields(netcdf, failure);
}

static bool take_numbers(struct trajectory *of, const struct netcdf_field *field, double *out,
                         struct failure *failure) {
  unsigned char bytes[8 * CHUNK_NUMBERS];
  const bool cartesian = field == &of->netcdf.field[NETCDF_COORDINATES];
  const size_t width = field->wide ? 8 : 4, all = (size_t)(field->bytes / width);
  for (size_t first = 0; first < all; first += CHUNK_NUMBERS) {
    const size_t count = all - first < CHUNK_NUMBERS ? all - first : CHUNK_NUMBERS;
    if (!take(of, bytes, count * width, failure)) return false;
    for (size_t k = 0; k < count; ++k) {
      const unsigned char *const at = bytes + k * width;
      const double number =
          cartesian && !field->wide ? (double)bits_to_float(bytes_to_u32(at, true)) : number_at(at, field->wide);
      out[first + k] = field->scale * number;
    }
  }
  return true;
}

static bool take_stamp(const struct netcdf *netcdf, double time, const double cell[6], struct frame_stamp *stamp,
                       struct failure *failure) {
  stamp->timed = netcdf->field[NETCDF_TIME].there;
  stamp->time = time;
  if (!is_finite(time)) return failure_in_input(failure, 0, "its time is not finite");
  if (!netcdf->field[NETCDF_LENGTHS].there || !netcdf->field[NETCDF_ANGLES].there) return true;
  for (int k = 0; k < 6; ++k) {
    if (!is_finite(cell[k])) return failure_in_input(failure, 0, "its cell is not finite");
  }
  box_from_angles(cell, cell + 3, &stamp->box);
  return true;
}

static enum line_status next_frame(struct trajectory *of, bool wanted, struct failure *failure) {
  struct netcdf *const netcdf = &of->netcdf;
  if (netcdf->counted && netcdf->frames == 0) return LINE_END;
  const uint64_t begin_of_frame = netcdf->next;
  if (!skip(of, begin_of_frame - netcdf->place, failure)) return LINE_FAILED;
  if (!netcdf->counted && byte_reader_at_end(&of->bytes)) return LINE_END;
  double time = 0.0, cell[6] = {0.0};
  double *const out[NETCDF_USES] = {
      [NETCDF_COORDINATES] = of->xyz, [NETCDF_TIME] = &time, [NETCDF_LENGTHS] = cell, [NETCDF_ANGLES] = cell + 3};
  const struct netcdf_field *field;
  while ((field = next_field(netcdf, netcdf->place - begin_of_frame)) != NULL) {
    const bool stepped_over = !wanted && field == &netcdf->field[NETCDF_COORDINATES];
    if (!skip(of, begin_of_frame + field->begin - netcdf->place, failure)) return LINE_FAILED;
    if (stepped_over ? !skip(of, field->bytes, failure)
                     : !take_numbers(of, field, out[field - netcdf->field], failure)) {
      return LINE_FAILED;
    }
  }
  netcdf->next = begin_of_frame + netcdf->stride;
  if (!skip(of, netcdf->next - netcdf->place, failure)) return LINE_FAILED;
  if (netcdf->counted) --netcdf->frames;
  return take_stamp(netcdf, time, cell, &of->stamp, failure) ? LINE_READ : LINE_FAILED;
}

void netcdf_free(struct netcdf *netcdf) {
  free(netcdf->dimension);
  netcdf->dimension = NULL;
}

const struct file_format nc_format = {
    .name = "nc", .extensions = "NC NCDF", ANGSTROM, .features = FILE_FRAMES, .begin = begin, .next_frame = next_frame};
