#include "read/cif_lines.h"

#include <string.h>

#include "read/characters.h"
#include "read/words.h"

/* A bit for each column of a line. */
struct line_bits {
  uint64_t blank[CIF_LINE_WORDS + 1]; /* ones behind its end */
  uint64_t quote[CIF_LINE_WORDS];
  bool quotes; /* there are some */
};

/* Find them. False: there may be a comment, a tag or a keyword in the line. */
static bool find_bits(const char *text, size_t length, struct line_bits *bits) {
  uint64_t blank = 0, special = 0;
  bits->quotes = false;
  for (size_t at = 0; at < length; at += 16) {
    /* No character of a line but blanks and tabs is below '!'. */
    blank |= (uint64_t)below_in_16(text + at, '!') << at % 64;
    special |= (uint64_t)(either_in_16(text + at, '_', '#') | either_in_16(text + at, '"', '\'')) << at % 64;
    if (at % 64 < 48 && at + 16 < length) continue;
    const size_t rest = length - at / 64 * 64;
    const uint64_t behind = rest < 64 ? ~UINT64_C(0) << rest : 0;
    bits->blank[at / 64] = blank | behind;
    bits->quote[at / 64] = special &= ~behind;
    for (; special != 0; special &= special - 1) {
      const char found = text[at / 64 * 64 + lowest_bit(special)];
      if (found == '_' || found == '#') return false;
      bits->quotes = true;
    }
    blank = 0;
  }
  if (length % 64 == 0) bits->blank[length / 64] = ~UINT64_C(0);
  return true;
}

/* The columns of some bits, behind those that are there. */
static size_t put_columns(uint64_t left, size_t k, uint16_t *column, size_t count) {
  for (; left != 0; left &= left - 1) column[count++] = (uint16_t)(64 * k + lowest_bit(left));
  return count;
}

/* Find where values begin and end. False: their number is not that of items. The columns are often the same as in the
 * line before. */
static bool find_values(struct cif_lines *lines, const struct line_bits *bits, size_t length) {
  uint64_t begins[CIF_LINE_WORDS + 1], before = 1, elsewhere = 0;
  const size_t words = length / 64 + 1;
  size_t count = 0;
  for (size_t k = 0; k < words; ++k) {
    const uint64_t blank = bits->blank[k], behind = blank << 1 | before;
    before = blank >> 63;
    begins[k] = ~blank & behind;
    elsewhere |= begins[k] ^ lines->begins[k];
    count = put_columns(blank & ~behind, k, lines->end, count);
  }
  if (count != lines->count) return false;
  /* As many begin as end. */
  for (size_t k = count = 0; elsewhere != 0 && k < words; ++k) {
    count = put_columns(begins[k], k, lines->begin, count);
    lines->begins[k] = begins[k];
  }
  return true;
}

/* Atoms of a residue share them, in files of molecules. */
static bool is_shared(enum cif_item item) {
  static const bool shared[CIF_ITEMS + 2] = {
      [CIF_GROUP] = true,      [CIF_ALTERNATE] = true,   [CIF_AUTH_RESIDUE] = true, [CIF_LABEL_RESIDUE] = true,
      [CIF_AUTH_CHAIN] = true, [CIF_LABEL_CHAIN] = true, [CIF_AUTH_NUMBER] = true,  [CIF_LABEL_NUMBER] = true,
      [CIF_INSERTION] = true,  [CIF_MODEL] = true};
  return shared[item];
}

/* In other tables several items may have one meaning. */
static bool has_twice(const enum cif_item *items, size_t count) {
  bool seen[CIF_ITEMS] = {false};
  for (size_t at = 0; at < count; ++at) {
    if (items[at] == CIF_OTHER_ITEM) continue;
    if (seen[items[at]]) return true;
    seen[items[at]] = true;
  }
  return false;
}

void cif_lines_begin(struct cif_lines *lines, const enum cif_item *items, size_t count) {
  lines->wanted = lines->shared = lines->runs = 0;
  memset(lines->begins, 0, sizeof lines->begins);
  lines->count = CIF_LINE_BYTES;
  if (has_twice(items, count)) return;
  lines->count = count;
  for (size_t at = 0; at < count; ++at) {
    if (!is_shared(items[at])) continue;
    if (at == 0 || !is_shared(items[at - 1])) lines->run[lines->runs++].first = (uint16_t)at;
    lines->run[lines->runs - 1].last = (uint16_t)at;
    lines->item[lines->wanted] = (unsigned char)items[at];
    lines->place[lines->wanted++] = (uint16_t)at;
  }
  lines->shared = lines->wanted;
  for (size_t at = 0; at < count; ++at) {
    if (is_shared(items[at]) || items[at] == CIF_OTHER_ITEM) continue;
    lines->item[lines->wanted] = (unsigned char)items[at];
    lines->place[lines->wanted++] = (uint16_t)at;
  }
}

/* Whether every value that begins with a quote ends with it, and not a later one behind a blank. */
static bool quotes_are_plain(const struct line_bits *bits, const struct cif_lines *lines, const char *text) {
  for (size_t at = 0; at < lines->count; ++at) {
    const size_t from = lines->begin[at], size = lines->end[at] - from;
    if ((bits->quote[from / 64] >> from % 64 & 1) == 0) continue;
    if (size < 2 || text[from + size - 1] != text[from]) return false;
  }
  return true;
}

/* Sixteen characters may be read from any place in them. */
static bool same_text(const char *a, const char *b, size_t length) {
  for (; length > 16; a += 16, b += 16, length -= 16) {
    if (differ_in_16(a, b) != 0) return false;
  }
  return (differ_in_16(a, b) & ((UINT32_C(1) << length) - 1)) == 0;
}

/* Whether all values that atoms of a residue share are the same as in the row that was kept. */
static bool same_residue(const struct cif_lines *lines, const char *text) {
  for (size_t r = 0; r < lines->runs; ++r) {
    const size_t begin = lines->begin[lines->run[r].first], length = lines->end[lines->run[r].last] - begin;
    if (length != lines->run_length[r] || !same_text(text + begin, lines->kept + lines->run_begin[r], length)) {
      return false;
    }
  }
  return true;
}

/* Rows are compared with this one from now on. */
static void keep_residue(struct cif_lines *lines, const char *text, size_t length) {
  for (size_t at = 0; at < length; at += 16) memcpy(lines->kept + at, text + at, 16);
  for (size_t r = 0; r < lines->runs; ++r) {
    lines->run_begin[r] = lines->begin[lines->run[r].first];
    lines->run_length[r] = (uint16_t)(lines->end[lines->run[r].last] - lines->run_begin[r]);
  }
}

bool cif_lines_take(struct cif_lines *lines, const struct line_reader *reader, bool go_on, struct cif_row *row) {
  struct line_bits bits;
  const char *const text = reader->text;
  const size_t length = reader->length;
  if (length == 0 || length > CIF_LINE_BYTES || text[0] == ';' || !find_bits(text, length, &bits)) return false;
  if (!find_values(lines, &bits, length)) return false;
  if (bits.quotes && !quotes_are_plain(&bits, lines, text)) return false;
  row->goes_on = go_on && row->values != NULL && same_residue(lines, text);
  if (!row->goes_on) keep_residue(lines, text, length);
  row->line = reader->number;
  row->values = text;
  for (size_t i = row->goes_on ? lines->shared : 0; i < lines->wanted; ++i) {
    size_t from = lines->begin[lines->place[i]], size = lines->end[lines->place[i]] - from;
    if (size == 1 && (text[from] == '?' || text[from] == '.')) {
      size = 0;
    } else if (bits.quotes && (bits.quote[from / 64] >> from % 64 & 1) != 0) {
      from += 1;
      size -= 2;
    }
    row->begin[lines->item[i]] = from;
    row->length[lines->item[i]] = size;
  }
  return true;
}
