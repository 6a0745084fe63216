#include "read/frame_title.h"

#include <string.h>

#include "read/characters.h"
#include "read/fields.h"
#include "read/number.h"

/* The word that ends here, alone. */
static struct field word_before(const char *title, const char *end) {
  while (end != title && is_blank(end[-1])) --end;
  const char *begin = end;
  while (begin != title && is_letter(begin[-1])) --begin;
  const bool alone = begin == title || is_blank(begin[-1]) || begin[-1] == ',';
  return (struct field){begin, alone ? (size_t)(end - begin) : 0};
}

static struct field number_behind(const char *at) {
  while (is_blank(*at)) ++at;
  return (struct field){at, strcspn(at, " \t,\"'")};
}

void frame_title_read(const char *title, struct frame_stamp *stamp) {
  for (const char *equals = strchr(title, '='); equals != NULL; equals = strchr(equals + 1, '=')) {
    const struct field word = word_before(title, equals);
    const struct field number = number_behind(equals + 1);
    const char *digits = number.text;
    double time;
    uint64_t step;
    if (field_is(word, "T") || field_is(word, "TIME")) {
      if (number_parse(digits, number.length, &time) != NUMBER_OK) continue;
      stamp->timed = true;
      stamp->time = time;
    } else if (field_is(word, "STEP") || field_is(word, "I")) {
      if (number_parse_count(digits, number.length, &step) != NUMBER_OK || step > INT64_MAX) continue;
      stamp->stepped = true;
      stamp->step = (int64_t)step;
    }
  }
}
