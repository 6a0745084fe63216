#include "write/pdf_update.h"

#include <inttypes.h>
#include <string.h>

/* Objects of the library's files, as hardsphere/picture.h tells them, and those that are new. */
enum { CATALOGUE = 1, PAGE = 3, CONTENTS = 5, INFORMATION = 7, OVER = 11, TABLE = 12, OBJECTS = 13 };

static const double points_per_px = 0.75;

/* The number behind the last "startxref". */
static uint64_t place_of_table(const char *tail, size_t count) {
  static const char word[] = "startxref\n";
  const size_t length = sizeof word - 1;
  uint64_t place = 0;
  for (size_t at = count; at-- > 0;) {
    if (at + length > count || memcmp(tail + at, word, length) != 0) continue;
    for (size_t k = at + length; k < count && '0' <= tail[k] && tail[k] <= '9'; ++k) {
      place = 10 * place + (uint64_t)(tail[k] - '0');
    }
    break;
  }
  return place;
}

/* Add an entry to a table: an object in use, its place, and its generation. */
static void put_entry(struct text_buffer *out, uint64_t place) {
  text_buffer_add(out, "01%016" PRIX64 "0000\n", place);
}

bool pdf_update_make(const char *over, const double page[2], const char *tail, size_t count, uint64_t size,
                     struct text_buffer *out) {
  uint64_t place[OBJECTS] = {0};
  place[PAGE] = size + out->length;
  text_buffer_add(out,
                  "%d 0 obj\n<</Type/Page/Parent 2 0 R/Resources 4 0 R/Contents[%d 0 R %d 0 R]"
                  "/MediaBox[0 0 %.6f %.6f]>>\nendobj\n",
                  PAGE, CONTENTS, OVER, page[0] * points_per_px, page[1] * points_per_px);
  place[OVER] = size + out->length;
  text_buffer_add(out, "%d 0 obj\n<</Length %zu>>\nstream\n", OVER, strlen(over));
  text_buffer_append(out, over, strlen(over));
  text_buffer_add(out, "\nendstream\nendobj\n");
  place[TABLE] = size + out->length;
  /* Three lines of 23 bytes. */
  text_buffer_add(out,
                  "%d 0 obj\n<</Type/XRef/Size %d/Index[%d 1 %d 2]/W[1 8 2]/Root %d 0 R/Info %d 0 R/Prev %" PRIu64
                  "/Filter/ASCIIHexDecode/Length 70>>\nstream\n",
                  TABLE, OBJECTS, PAGE, OVER, CATALOGUE, INFORMATION, place_of_table(tail, count));
  put_entry(out, place[PAGE]);
  put_entry(out, place[OVER]);
  put_entry(out, place[TABLE]);
  text_buffer_add(out, ">\nendstream\nendobj\nstartxref\n%" PRIu64 "\n%%%%EOF\n", place[TABLE]);
  return !out->out_of_memory;
}
