#include "read/cif_lines.h"

#include <string.h>

#include "read/characters.h"
#include "read/words.h"

/* The blanks of a line as bits, with ones behind its end, and its quotes. False: there may be a comment, a tag or a
 * keyword in it. */
static bool find_blanks(const char *text, size_t length, uint64_t blank[CIF_LINE_WORDS + 1],
                        uint64_t quote[CIF_LINE_WORDS]) {
  uint32_t found = 0;
  memset(blank, 0xFF, (CIF_LINE_WORDS + 1) * sizeof *blank);
  memset(quote, 0, CIF_LINE_WORDS * sizeof *quote);
  for (size_t at = 0; at < length; at += 16) {
    const uint32_t within = length - at < 16 ? (UINT32_C(1) << (length - at)) - 1 : UINT32_C(0xFFFF);
    /* No character of a line but blanks and tabs is below '!'. */
    blank[at / 64] ^= (uint64_t)(~below_in_16(text + at, '!') & within) << at % 64;
    found |= either_in_16(text + at, '_', '#') & within;
    quote[at / 64] |= (uint64_t)(either_in_16(text + at, '"', '\'') & within) << at % 64;
  }
  return found == 0;
}

/* Whether there are as many values as items; which column each begins in. */
static bool find_columns(struct cif_lines *lines, const uint64_t begins[CIF_LINE_WORDS]) {
  size_t at = 0;
  lines->known = false;
  lines->wanted = 0;
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    for (uint64_t left = begins[k]; left != 0; left &= left - 1, ++at) {
      if (at == lines->count) return false;
      if (lines->items[at] == CIF_OTHER_ITEM) continue;
      lines->item[lines->wanted] = (unsigned char)lines->items[at];
      lines->begin[lines->wanted++] = (unsigned char)(64 * k + lowest_bit(left));
    }
  }
  memcpy(lines->begins, begins, sizeof lines->begins);
  lines->known = at == lines->count;
  return lines->known;
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
static bool quotes_are_plain(const uint64_t blank[CIF_LINE_WORDS + 1], const uint64_t begins[CIF_LINE_WORDS],
                             const uint64_t quote[CIF_LINE_WORDS], const char *text) {
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    for (uint64_t left = begins[k] & quote[k]; left != 0; left &= left - 1) {
      const size_t from = 64 * k + lowest_bit(left), size = length_from(blank, from);
      if (size < 2 || text[from + size - 1] != text[from]) return false;
    }
  }
  return true;
}

bool cif_lines_take(struct cif_lines *lines, const struct line_reader *reader, struct cif_row *row) {
  uint64_t blank[CIF_LINE_WORDS + 1], quote[CIF_LINE_WORDS], begins[CIF_LINE_WORDS];
  const char *const text = reader->text;
  const size_t length = reader->length;
  if (length == 0 || length > CIF_LINE_BYTES || text[0] == ';') return false;
  if (!find_blanks(text, length, blank, quote)) return false;
  uint64_t before = 1, different = lines->known ? 0 : 1;
  for (size_t k = 0; k < CIF_LINE_WORDS; ++k) {
    begins[k] = ~blank[k] & (blank[k] << 1 | before);
    before = blank[k] >> 63;
    different |= begins[k] ^ lines->begins[k];
  }
  if (different != 0 && !find_columns(lines, begins)) return false;
  if (!quotes_are_plain(blank, begins, quote, text)) return false;
  row->line = reader->number;
  row->values = text;
  for (size_t i = 0; i < lines->wanted; ++i) {
    const enum cif_item item = (enum cif_item)lines->item[i];
    size_t from = lines->begin[i], size = length_from(blank, from);
    if (size == 1 && (text[from] == '?' || text[from] == '.')) {
      size = 0;
    } else if ((quote[from / 64] >> from % 64 & 1) != 0) {
      from += 1;
      size -= 2;
    }
    row->begin[item] = from;
    row->length[item] = size;
  }
  return true;
}
