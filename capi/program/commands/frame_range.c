#include "commands/frame_range.h"

#include <string.h>

#include "read/number.h"

bool frame_range_parse(struct frame_range *range, const char *text, struct failure *failure) {
  uint64_t *const parts[] = {&range->first, &range->last, &range->step};
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

bool frame_range_has_times(const struct frame_range *range) {
  return range->begin > -HUGE_VAL || range->end < HUGE_VAL || range->interval > 0.0;
}

bool frame_clock_takes(struct frame_clock *clock, const struct frame_range *range, double time) {
  /* Times are decimals: of the quotient of two so much may be lost in rounding. */
  const double rounding = 1e-6;
  if (time < range->begin || time > range->end) return false;
  if (!clock->begun) {
    *clock = (struct frame_clock){true, time, 1.0};
    return true;
  }
  if (range->interval == 0.0) return true;
  const double number = floor((time - clock->first) / range->interval + rounding);
  if (number < clock->due) return false;
  clock->due = number + 1.0;
  return true;
}
