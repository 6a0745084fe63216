#include "commands/frame_range.h"

#include <string.h>

#include "read/number.h"

bool frame_range_parse(struct frame_range *range, const char *text, struct failure *failure) {
  uint64_t *const parts[] = {&range->first, &range->last, &range->step};
  *range = (struct frame_range)FRAME_RANGE_ALL;
  const char *at = text;
  bool good = text[0] != '\0';
  int part = 0;
  for (; good; ++part) {
    const size_t length = strcspn(at, ":");
    good = length == 0 || (number_parse_count(at, length, parts[part]) == NUMBER_OK && *parts[part] > 0);
    at += length;
    if (*at == '\0' || part == 2) break;
    ++at;
  }
  if (good && part == 0) range->last = range->first;
  if (good && *at == '\0' && range->first <= range->last) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(failure, "--frames: '%s' is not of the form A:B:S, counted from 1: A to B in steps of S",
                          excerpt(shown, text, strlen(text)));
}

bool frame_range_has(const struct frame_range *range, uint64_t number) {
  return number >= range->first && number <= range->last && (number - range->first) % range->step == 0;
}
