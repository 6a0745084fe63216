/* Numbers have their highest byte first. A frame begins with 1993, the length of a name and its end, the name, which is
 * GMX_trn_file, and 13 numbers: the bytes of ten blocks, number of atoms, step, and one that is not used. Then come
 * time and another parameter, and the blocks: inputs and energies, which are empty, box, virial, pressure, topology and
 * symbols, which are empty, coordinates, velocities and forces. Numbers of all blocks are floats or doubles, as the
 * size of the first block with numbers tells. */
#include <inttypes.h>
#include <string.h>

#include "read/number.h"
#include "read/trajectory.h"

enum block {
  BLOCK_INPUT,
  BLOCK_ENERGY,
  BLOCK_BOX,
  BLOCK_VIRIAL,
  BLOCK_PRESSURE,
  BLOCK_TOPOLOGY,
  BLOCK_SYMBOLS,
  BLOCK_COORDINATES,
  BLOCK_VELOCITIES,
  BLOCK_FORCES,
  BLOCKS
};

enum { MAGIC = 1993, NAME_BYTES = 12, START_BYTES = 4 * 3 + NAME_BYTES + 4 * (BLOCKS + 3), CHUNK_NUMBERS = 1024 };

struct header {
  uint32_t bytes[BLOCKS];
  size_t width; /* of a number: 4 or 8 bytes */
};

/* A number, with the fewest digits that are it if it is a float: 0.1, where its own value has 17 digits. */
static double number_at(const unsigned char *at, size_t width) {
  return width == 4 ? float_as_written(bits_to_float(bytes_to_u32(at, true))) : bits_to_double(bytes_to_u64(at, true));
}

static bool damaged(struct failure *failure) {
  return failure_in_input(failure, 0, "the sizes of its blocks do not fit together");
}

/* The width of numbers, and whether all blocks have that. */
static bool find_width(struct header *header, uint32_t atoms, struct failure *failure) {
  static const enum block in_use[] = {BLOCK_BOX,         BLOCK_VIRIAL,     BLOCK_PRESSURE,
                                      BLOCK_COORDINATES, BLOCK_VELOCITIES, BLOCK_FORCES};
  uint64_t all = 0, used = 0;
  header->width = 4;
  for (size_t k = 0; k < BLOCKS; ++k) all += header->bytes[k];
  for (size_t k = 0; k < sizeof in_use / sizeof in_use[0]; ++k) {
    const uint64_t numbers = in_use[k] < BLOCK_COORDINATES ? 9 : 3 * (uint64_t)atoms;
    const uint64_t bytes = header->bytes[in_use[k]];
    if (bytes == 0) continue;
    if (used == 0 && bytes == 8 * numbers) header->width = 8;
    if (bytes != header->width * numbers) return damaged(failure);
    used += bytes;
  }
  return used == all || damaged(failure);
}

static bool take_start(struct byte_reader *reader, uint32_t atoms, struct header *header, struct frame_stamp *stamp,
                       struct failure *failure) {
  unsigned char bytes[START_BYTES];
  if (!byte_reader_take(reader, bytes, sizeof bytes, failure)) return false;
  const bool good = bytes_to_u32(bytes, true) == MAGIC && bytes_to_u32(bytes + 4, true) == NAME_BYTES + 1 &&
                    bytes_to_u32(bytes + 8, true) == NAME_BYTES && memcmp(bytes + 12, "GMX_trn_file", NAME_BYTES) == 0;
  if (!good) return failure_in_input(failure, 0, "no frame of a .trr file begins here");
  const unsigned char *const numbers = bytes + 12 + NAME_BYTES;
  for (size_t k = 0; k < BLOCKS; ++k) header->bytes[k] = bytes_to_u32(numbers + 4 * k, true);
  const uint32_t count = bytes_to_u32(numbers + 4 * BLOCKS, true);
  if (count != atoms) {
    return failure_in_input(failure, 0, "%" PRIu32 " in place of %" PRIu32 " atoms", count, atoms);
  }
  stamp->stepped = true;
  stamp->step = bits_to_i32(bytes_to_u32(numbers + 4 * BLOCKS + 4, true));
  return find_width(header, atoms, failure);
}

/* Time, the parameter, and the box if there is one. */
static bool take_time_and_box(struct byte_reader *reader, const struct header *header, struct frame_stamp *stamp,
                              struct failure *failure) {
  unsigned char bytes[11 * 8];
  double vector[9];
  const size_t width = header->width, numbers = header->bytes[BLOCK_BOX] > 0 ? 11 : 2;
  if (!byte_reader_take(reader, bytes, numbers * width, failure)) return false;
  stamp->timed = true;
  stamp->time = number_at(bytes, width);
  if (!is_finite(stamp->time)) return failure_in_input(failure, 0, "its time is not finite");
  for (size_t k = 2; k < numbers; ++k) {
    vector[k - 2] = 10.0 * number_at(bytes + k * width, width);
    if (!is_finite(vector[k - 2])) return failure_in_input(failure, 0, "its box is not finite");
  }
  if (numbers > 2) box_from_vectors(vector, &stamp->box);
  return true;
}

static bool take_coordinates(struct byte_reader *reader, size_t width, uint32_t atoms, double *xyz,
                             struct failure *failure) {
  unsigned char bytes[8 * CHUNK_NUMBERS];
  const size_t all = 3 * (size_t)atoms;
  for (size_t first = 0; first < all; first += CHUNK_NUMBERS) {
    const size_t count = all - first < CHUNK_NUMBERS ? all - first : CHUNK_NUMBERS;
    if (!byte_reader_take(reader, bytes, count * width, failure)) return false;
    for (size_t k = 0; k < count; ++k) {
      const unsigned char *const at = bytes + k * width;
      xyz[first + k] =
          10.0 * (width == 4 ? (double)bits_to_float(bytes_to_u32(at, true)) : bits_to_double(bytes_to_u64(at, true)));
    }
  }
  return true;
}

/* A frame, whose coordinates are taken if they are there and wanted. */
static bool take_frame(struct byte_reader *reader, bool wanted, uint32_t atoms, double *xyz, struct frame_stamp *stamp,
                       bool *has_coordinates, struct failure *failure) {
  struct header header = {{0}, 4};
  if (!take_start(reader, atoms, &header, stamp, failure)) return false;
  if (!take_time_and_box(reader, &header, stamp, failure)) return false;
  *has_coordinates = header.bytes[BLOCK_COORDINATES] > 0 || atoms == 0;
  if (!byte_reader_skip(reader, (uint64_t)header.bytes[BLOCK_VIRIAL] + header.bytes[BLOCK_PRESSURE], failure)) {
    return false;
  }
  const bool taken = wanted && *has_coordinates;
  if (taken && !take_coordinates(reader, header.width, atoms, xyz, failure)) return false;
  return byte_reader_skip(reader,
                          (uint64_t)(taken ? 0 : header.bytes[BLOCK_COORDINATES]) + header.bytes[BLOCK_VELOCITIES] +
                              header.bytes[BLOCK_FORCES],
                          failure);
}

/* The next frame that has coordinates; frames of velocities or forces alone are none. */
static enum line_status next_frame(struct trajectory *of, bool wanted, struct failure *failure) {
  const struct frame_stamp begun = of->stamp;
  bool has_coordinates = false;
  while (!has_coordinates) {
    if (byte_reader_at_end(&of->bytes)) return LINE_END;
    of->stamp = begun;
    if (!take_frame(&of->bytes, wanted, of->atoms, of->xyz, &of->stamp, &has_coordinates, failure)) return LINE_FAILED;
  }
  return LINE_READ;
}

const struct file_format trr_format = {
    .name = "trr", .extensions = "TRR", ANGSTROM, .features = FILE_FRAMES, .next_frame = next_frame};
