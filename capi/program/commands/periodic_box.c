#include "commands/periodic_box.h"

#include <string.h>

#include "read/number.h"

enum { MOST_NUMBERS = 9 };

/* Numbers with a comma or blanks between them, in one argument. -1: something is none of these, and the failure says
 * so. */
static int read_numbers(struct option_reader *reader, const char *text, double numbers[MOST_NUMBERS]) {
  int count = 0;
  text += strspn(text, " \t");
  while (text[0] != '\0') {
    const size_t length = strcspn(text, ", \t");
    const bool fits = count < MOST_NUMBERS;
    double value = 0.0;
    const enum number_status status = number_parse(text, length, &value);
    if (status != NUMBER_OK) {
      char shown[EXCERPT_BYTES];
      failure_in_usage(reader->failure, "--box: '%s' %s", excerpt(shown, text, length), number_complaint(status));
      return -1;
    }
    if (fits) numbers[count] = value;
    ++count;
    text += length;
    text += strspn(text, " \t");
    if (text[0] == ',') {
      text += 1 + strspn(text + 1, " \t");
      if (text[0] == '\0') return 0;
    }
  }
  return count;
}

bool box_take_option(struct box_choice *choice, struct option_reader *reader, const char *value) {
  static const char wanted[] = "AX,BY,CZ, nine numbers, 'file' or 'p1'";
  if (!option_value(reader, "--box", &value, wanted)) return false;
  if (choice->source != BOX_NONE) return failure_in_usage(reader->failure, "--box is given twice");
  choice->without_copies = strcmp(value, "p1") == 0;
  if (choice->without_copies || strcmp(value, "file") == 0) {
    choice->source = BOX_OF_FILE;
    return true;
  }
  double numbers[MOST_NUMBERS] = {0};
  const int count = read_numbers(reader, value, numbers);
  if (count < 0) return false;
  if (count != 3 && count != MOST_NUMBERS) return failure_in_usage(reader->failure, "--box needs %s", wanted);
  choice->source = BOX_GIVEN;
  memset(choice->vector, 0, sizeof choice->vector);
  if (count == 3) {
    for (int axis = 0; axis < 3; ++axis) choice->vector[4 * axis] = numbers[axis];
  } else {
    memcpy(choice->vector, numbers, sizeof numbers);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!(choice->vector[4 * axis] > 0.0)) {
      return failure_in_usage(reader->failure, "--box: AX, BY and CZ must be larger than 0");
    }
  }
  if (choice->vector[1] != 0.0 || choice->vector[2] != 0.0 || choice->vector[5] != 0.0) {
    return failure_in_usage(reader->failure, "--box: the vectors are AX,0,0, BX,BY,0 and CX,CY,CZ");
  }
  return true;
}
