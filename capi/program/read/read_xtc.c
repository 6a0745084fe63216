/* A frame, all numbers with the highest byte first: magic number, atoms, step, time (float), box (9 floats), atoms
 * again. Up to 9 atoms follow as floats. More of them are packed: precision (float), least and greatest coordinates in
 * units of 1/precision (3 numbers each), index of the small differences, how many bytes, and these, filled up to a
 * multiple of 4.
 *
 * The bytes are a string of bits, highest first. Atoms come in groups. Of the first its coordinates less the least
 * ones: as three numbers if one of the spans exceeds 24 bits, else as one number in mixed radix. Then a bit; if it is
 * set, five more, which say how many atoms follow as small differences and how the index changes behind them; else
 * there follow as many as last time. A small difference is to the atom before, three coordinates in one number, whose
 * radix is about 2^(index/3), half of it added to each. The first small one and the atom before it have changed places,
 * since the oxygen of water is nearer to both of its hydrogens than they are to each other. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/number.h"
#include "read/trajectory.h"

enum {
  MAGIC = 1995,
  MAGIC_LARGE = 2023, /* with 64 bits for the number of bytes */
  MOST_UNPACKED = 9,
  LEAST_INDEX = 9,
  MOST_INDEX = 72,
  LONGEST = 9,            /* bytes of a packed number */
  PADDING = 32,           /* behind the packed bytes, more than an atom takes */
  MOST_BYTES_AN_ATOM = 13 /* three coordinates of 32 bits, a bit, and five */
};

/* The radix of small differences: 2^(index/3) rounded down, but for three that the format has otherwise. */
static uint32_t radix_of(int index) {
  static const double third[3] = {1.0, 1.2599210498948732, 1.5874010519681994};
  if (index == 37) return 5060;
  if (index == 57) return 524287;
  if (index == 69) return 8388607;
  return (uint32_t)(third[index % 3] * (double)(UINT32_C(1) << (index / 3)));
}

static unsigned bit_length(uint64_t value) {
  unsigned bits = 0;
  for (; value > 0; value >>= 1) ++bits;
  return bits;
}

struct bits {
  const unsigned char *bytes;
  uint64_t at;  /* the next bit */
  uint64_t end; /* no bit from here on is asked for, but up to PADDING bytes may be looked at */
};

/* The next 0 to 32 bits. */
static inline uint64_t take_bits(struct bits *bits, unsigned count) {
  const uint64_t eight = bytes_to_u64(bits->bytes + (bits->at >> 3), true);
  const unsigned before = (unsigned)(bits->at & 7);
  bits->at += count;
  return (eight << before) >> 1 >> (63 - count);
}

/* A number in mixed radix: (x radix[1] + y) radix[2] + z. */
struct packing {
  unsigned bits;
  uint64_t radix[3];
};

/* Its last digit is taken off: the bytes of a number, highest last, are divided. */
static uint64_t divide_bytes(unsigned char bytes[LONGEST], uint64_t divisor) {
  uint64_t rest = 0;
  for (int i = LONGEST - 1; i >= 0; --i) {
    rest = rest << 8 | bytes[i];
    bytes[i] = (unsigned char)(rest / divisor);
    rest %= divisor;
  }
  return rest;
}

/* The three numbers, which are stored with the lowest byte first. */
static inline void take_packed(struct bits *bits, const struct packing *packing, uint64_t out[3]) {
  if (packing->bits <= 64) {
    uint64_t number = 0;
    unsigned shift = 0;
    for (; packing->bits > shift + 8; shift += 8) number |= take_bits(bits, 8) << shift;
    number |= take_bits(bits, packing->bits - shift) << shift;
    out[2] = number % packing->radix[2];
    number /= packing->radix[2];
    out[1] = number % packing->radix[1];
    out[0] = number / packing->radix[1];
    return;
  }
  unsigned char bytes[LONGEST];
  for (int i = 0; i < LONGEST - 1; ++i) bytes[i] = (unsigned char)take_bits(bits, 8);
  bytes[LONGEST - 1] = (unsigned char)take_bits(bits, packing->bits - 64);
  out[2] = divide_bytes(bytes, packing->radix[2]);
  out[1] = divide_bytes(bytes, packing->radix[1]);
  out[0] = bytes_to_u64(bytes, false);
}

/* Small differences by index. */
static struct packing small_packing(int index) {
  const uint64_t radix = radix_of(index);
  return (struct packing){(unsigned)index, {radix, radix, radix}};
}

/* The header before the packed bytes. */
struct header {
  double precision;
  int64_t least[3];
  struct packing whole; /* of the coordinates less the least; bits is 0 where each has a number of its own */
  int index;
  uint64_t bytes;
};

static bool unpack_failed(struct failure *failure) {
  return failure_in_input(failure, 0, "the packed coordinates are damaged");
}

static void put_atom(double *xyz, const int64_t at[3], double precision) {
  /* One rounding: nanometres times precision are whole, and so are ten times as many. */
  for (int axis = 0; axis < 3; ++axis) xyz[axis] = (double)(10 * at[axis]) / precision;
}

static void take_whole(struct bits *bits, const struct header *header, int64_t at[3]) {
  uint64_t digit[3];
  if (header->whole.bits == 0) {
    for (int axis = 0; axis < 3; ++axis) digit[axis] = take_bits(bits, bit_length(header->whole.radix[axis]));
  } else {
    take_packed(bits, &header->whole, digit);
  }
  for (int axis = 0; axis < 3; ++axis) {
    /* Damaged numbers may have digits of any size; sound ones have 32 bits. */
    at[axis] = header->least[axis] + (int64_t)(digit[axis] & UINT32_MAX);
  }
}

static bool unpack(const struct header *header, const unsigned char *packed, uint32_t atoms, double *xyz,
                   struct failure *failure) {
  struct bits bits = {packed, 0, 8 * header->bytes};
  int index = header->index;
  struct packing small = small_packing(index);
  uint32_t run = 0; /* atoms that follow as small differences */
  for (uint32_t atom = 0; atom < atoms;) {
    int64_t first[3];
    int change = 0;
    take_whole(&bits, header, first);
    if (take_bits(&bits, 1) != 0) {
      const uint32_t code = (uint32_t)take_bits(&bits, 5);
      run = code / 3;
      change = (int)(code % 3) - 1;
    }
    if (bits.at > bits.end || run >= atoms - atom) return unpack_failed(failure);
    int64_t at[3] = {first[0], first[1], first[2]};
    for (uint32_t k = 0; k < run; ++k) {
      uint64_t digit[3];
      take_packed(&bits, &small, digit);
      if (bits.at > bits.end) return unpack_failed(failure);
      for (int axis = 0; axis < 3; ++axis) {
        at[axis] += (int64_t)(digit[axis] & UINT32_MAX) - (int64_t)(small.radix[axis] / 2);
      }
      put_atom(xyz + 3 * (size_t)(atom + (k == 0 ? 0 : k + 1)), at, header->precision);
    }
    put_atom(xyz + 3 * (size_t)(atom + (run == 0 ? 0 : 1)), first, header->precision);
    atom += run + 1;
    if (change != 0) {
      index += change;
      if (index < LEAST_INDEX || index > MOST_INDEX) return unpack_failed(failure);
      small = small_packing(index);
    }
  }
  return true;
}

static bool take_header(struct byte_reader *reader, bool large, uint32_t atoms, struct header *header,
                        struct failure *failure) {
  unsigned char bytes[40];
  const size_t length = large ? 40 : 36;
  if (!byte_reader_take(reader, bytes, length, failure)) return false;
  header->precision = (double)bits_to_float(bytes_to_u32(bytes, true));
  bool good = is_finite(header->precision) && header->precision > 0.0;
  uint64_t most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    header->least[axis] = bits_to_i32(bytes_to_u32(bytes + 4 + 4 * axis, true));
    const int64_t span = bits_to_i32(bytes_to_u32(bytes + 16 + 4 * axis, true)) - header->least[axis] + 1;
    good = good && span > 0 && span <= (int64_t)UINT32_MAX;
    header->whole.radix[axis] = good ? (uint64_t)span : 1;
    if (most < header->whole.radix[axis]) most = header->whole.radix[axis];
  }
  /* The product of three numbers of 24 bits has up to 72: the first two, then 2^24 parts of the third. */
  const uint64_t *span = header->whole.radix;
  header->whole.bits = 0;
  if (most < UINT32_C(1) << 24) {
    const uint64_t two = span[0] * span[1];
    const uint64_t low = (two & 0xFFFFFF) * span[2], high = (two >> 24) * span[2] + (low >> 24);
    header->whole.bits = high == 0 ? bit_length(low) : 24 + bit_length(high);
  }
  header->index = bits_to_i32(bytes_to_u32(bytes + 28, true));
  header->bytes = large ? bytes_to_u64(bytes + 32, true) : bytes_to_u32(bytes + 32, true);
  good = good && header->index >= LEAST_INDEX && header->index <= MOST_INDEX;
  if (good && header->bytes <= (uint64_t)MOST_BYTES_AN_ATOM * atoms + 16) return true;
  return failure_in_input(failure, 0, "what stands before the packed coordinates is damaged");
}

static bool take_packed_frame(struct xtc *xtc, struct byte_reader *reader, bool large, bool wanted, uint32_t atoms,
                              double *xyz, struct failure *failure) {
  struct header header;
  if (!take_header(reader, large, atoms, &header, failure)) return false;
  const uint64_t length = header.bytes + (4 - header.bytes % 4) % 4;
  if (!wanted) return byte_reader_skip(reader, length, failure);
  if (xtc->capacity < length + PADDING) {
    free(xtc->packed);
    xtc->packed = malloc((size_t)length + PADDING);
    xtc->capacity = xtc->packed == NULL ? 0 : (size_t)length + PADDING;
    if (xtc->packed == NULL) return failure_of_memory(failure);
  }
  if (!byte_reader_take(reader, xtc->packed, (size_t)length, failure)) return false;
  memset(xtc->packed + length, 0, PADDING);
  return unpack(&header, xtc->packed, atoms, xyz, failure);
}

static bool take_floats(struct byte_reader *reader, uint32_t atoms, double *xyz, struct failure *failure) {
  unsigned char bytes[12 * MOST_UNPACKED];
  if (!byte_reader_take(reader, bytes, 12 * (size_t)atoms, failure)) return false;
  for (size_t k = 0; k < 3 * (size_t)atoms; ++k) {
    xyz[k] = 10.0 * (double)bits_to_float(bytes_to_u32(bytes + 4 * k, true));
  }
  return true;
}

/* Takes the beginning of a frame. */
static bool take_start(struct byte_reader *reader, uint32_t atoms, bool *large, struct frame_stamp *stamp,
                       struct failure *failure) {
  unsigned char bytes[56];
  if (!byte_reader_take(reader, bytes, 4, failure)) return false;
  const uint32_t magic = bytes_to_u32(bytes, true);
  *large = magic == MAGIC_LARGE;
  if (magic != MAGIC && !*large) return failure_in_input(failure, 0, "no frame of an .xtc file begins here");
  if (!byte_reader_take(reader, bytes + 4, 52, failure)) return false;
  const uint32_t count[2] = {bytes_to_u32(bytes + 4, true), bytes_to_u32(bytes + 52, true)};
  if (count[0] != atoms || count[1] != atoms) {
    return failure_in_input(failure, 0, "%" PRIu32 " in place of %" PRIu32 " atoms", count[count[0] == atoms ? 1 : 0],
                            atoms);
  }
  /* Time and box. */
  for (size_t k = 0; k < 10; ++k) {
    if (is_finite((double)bits_to_float(bytes_to_u32(bytes + 12 + 4 * k, true)))) continue;
    return failure_in_input(failure, 0, "its %s is not finite", k == 0 ? "time" : "box");
  }
  stamp->stepped = stamp->timed = true;
  stamp->step = bits_to_i32(bytes_to_u32(bytes + 8, true));
  stamp->time = float_as_written(bits_to_float(bytes_to_u32(bytes + 12, true)));
  double vector[9];
  for (size_t k = 0; k < 9; ++k)
    vector[k] = 10.0 * float_as_written(bits_to_float(bytes_to_u32(bytes + 16 + 4 * k, true)));
  box_from_vectors(vector, &stamp->box);
  return true;
}

static enum line_status next_frame(struct trajectory *of, bool wanted, struct failure *failure) {
  struct byte_reader *const reader = &of->bytes;
  bool large = false;
  if (byte_reader_at_end(reader)) return LINE_END;
  if (!take_start(reader, of->atoms, &large, &of->stamp, failure)) return LINE_FAILED;
  const bool done = of->atoms <= MOST_UNPACKED
                        ? take_floats(reader, of->atoms, of->xyz, failure)
                        : take_packed_frame(&of->xtc, reader, large, wanted, of->atoms, of->xyz, failure);
  return done ? LINE_READ : LINE_FAILED;
}

void xtc_free(struct xtc *xtc) {
  free(xtc->packed);
  xtc->packed = NULL;
  xtc->capacity = 0;
}

const struct file_format xtc_format = {
    .name = "xtc", .extensions = "XTC", ANGSTROM, .features = FILE_FRAMES, .next_frame = next_frame};
