#include "read/cif_lines.h"

#include <string.h>

#include "read/characters.h"
#include "read/words.h"

/* A bit for each column of a line. */
struct line_bits {
  uint64_t blank[CIF_LINE_WORDS + 1]; /* ones behind its end */
  uint64_t quote[CIF_LINE_WORDS];
  uint64_t different[CIF_LINE_WORDS]; /* from the line before, in the columns of this one */
};

/* Find them, and put the line in place of the one before. False: there may be a comment, a tag or a keyword in it. */
static bool find_bits(const char *text, size_t length, char before[CIF_LINE_BYTES], struct line_bits *bits) {
  uint32_t found = 0;
  memset(bits, 0, sizeof *bits);
  memset(bits->blank, 0xFF, sizeof bits->blank);
  for (size_t at = 0; at < length; at += 16) {
    const uint32_t within = length - at < 16 ? (UINT32_C(1) << (length - at)) - 1 : UINT32_C(0xFFFF);
    /* No character of a line but blanks and tabs is below '!'. */
    bits->blank[at / 64] ^= (uint64_t)(~below_in_16(text + at, '!') & within) << at % 64;
    found |= either_in_16(text + at, '_', '#') & within;
    bits->quote[at / 64] |= (uint64_t)(either_in_16(text + at, '"', '\'') & within) << at % 64;
    bits->different[at / 64] |= (uint64_t)(differ_in_16(text + at, before + at) & within) << at % 64;
    memcpy(before + at, text + at, 16);
  }
  return found == 0;
}

/* Atoms of a residue share them, in files of molecules. */
static bool is_shared(enum cif_item item) {
  static const bool shared[CIF_ITEMS + 2] = {
      [CIF_GROUP] = true,      [CIF_ALTERNATE] = true,   [CIF_AUTH_RESIDUE] = true, [CIF_LABEL_RESIDUE] = true,
      [CIF_AUTH_CHAIN] = true, [CIF_LABEL_CHAIN] = true, [CIF_AUTH_NUMBER] = true,  [CIF_LABEL_NUMBER] = true,
      [CIF_INSERTION] = true,  [CIF_MODEL] = true};
  return shared[item];
}

/* Whether there are as many values as items; which column each begins in. */
static bool find_columns(struct cif_lines *lines, const uint64_t begins[CIF_LINE_WORDS]) {
  size_t at = 0, others = 0;
  unsigned char other[2][CIF_ITEMS];
  lines->known = lines->compares = false;
  lines->wanted = 0;
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    for (uint64_t left = begins[k]; left != 0; left &= left - 1, ++at) {
      if (at == lines->count) return false;
      const enum cif_item item = lines->items[at];
      if (item == CIF_OTHER_ITEM) continue;
      const bool shared = is_shared(item);
      *(shared ? &lines->item[lines->wanted] : &other[0][others]) = (unsigned char)item;
      *(shared ? &lines->begin[lines->wanted] : &other[1][others]) = (unsigned char)(64 * k + lowest_bit(left));
      ++*(shared ? &lines->wanted : &others);
    }
  }
  lines->shared = lines->wanted;
  memcpy(lines->item + lines->wanted, other[0], others);
  memcpy(lines->begin + lines->wanted, other[1], others);
  lines->wanted += others;
  memcpy(lines->begins, begins, sizeof lines->begins);
  lines->known = at == lines->count;
  return lines->known;
}

/* From now on rows are compared with those before. */
static void find_columns_of_shared(struct cif_lines *lines) {
  lines->compares = true;
  memset(lines->of_shared, 0, sizeof lines->of_shared);
  for (size_t i = 0; i < lines->shared; ++i) {
    size_t at = lines->begin[i];
    do {
      lines->of_shared[at / 64] |= UINT64_C(1) << at % 64;
      ++at;
    } while (at < CIF_LINE_BYTES && (lines->begins[at / 64] >> at % 64 & 1) == 0);
  }
}

/* The length of the value that begins in a column. */
static size_t length_from(const uint64_t blank[CIF_LINE_WORDS + 1], size_t from) {
  size_t length = 0;
  for (;; from += 64, length += 64) {
    const uint64_t behind = blank[from / 64] >> from % 64 | blank[from / 64 + 1] << 1 << (63 - from % 64);
    if (behind != 0) return length + lowest_bit(behind);
  }
}

/* Whether every value that begins with a quote ends with it, and not a later one behind a blank. */
static bool quotes_are_plain(const struct line_bits *bits, const uint64_t begins[CIF_LINE_WORDS], const char *text) {
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    for (uint64_t left = begins[k] & bits->quote[k]; left != 0; left &= left - 1) {
      const size_t from = 64 * k + lowest_bit(left), size = length_from(bits->blank, from);
      if (size < 2 || text[from + size - 1] != text[from]) return false;
    }
  }
  return true;
}

bool cif_lines_take(struct cif_lines *lines, const struct line_reader *reader, struct cif_row *row) {
  struct line_bits bits;
  uint64_t begins[CIF_LINE_WORDS];
  const char *const text = reader->text;
  const size_t length = reader->length;
  if (length == 0 || length > CIF_LINE_BYTES || text[0] == ';') return false;
  if (!find_bits(text, length, lines->before, &bits)) return false;
  uint64_t before = 1, elsewhere = lines->known ? 0 : 1, different = 0;
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    begins[k] = ~bits.blank[k] & (bits.blank[k] << 1 | before);
    before = bits.blank[k] >> 63;
    elsewhere |= begins[k] ^ lines->begins[k];
    different |= bits.different[k] & lines->of_shared[k];
  }
  row->goes_on = row->values != NULL && elsewhere == 0 && lines->compares && different == 0 && length == lines->length;
  lines->length = length;
  if (elsewhere != 0 && !find_columns(lines, begins)) return false;
  if (elsewhere == 0 && !lines->compares) find_columns_of_shared(lines);
  if (!quotes_are_plain(&bits, begins, text)) return false;
  row->line = reader->number;
  row->values = text;
  for (size_t i = row->goes_on ? lines->shared : 0; i < lines->wanted; ++i) {
    const enum cif_item item = (enum cif_item)lines->item[i];
    size_t from = lines->begin[i], size = length_from(bits.blank, from);
    if (size == 1 && (text[from] == '?' || text[from] == '.')) {
      size = 0;
    } else if ((bits.quote[from / 64] >> from % 64 & 1) != 0) {
      from += 1;
      size -= 2;
    }
    row->begin[item] = from;
    row->length[item] = size;
  }
  return true;
}
