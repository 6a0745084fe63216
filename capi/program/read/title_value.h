/* Values by their keys in the title of extended XYZ: key=value, with blanks around the sign or without. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/fields.h"

/* The value of a key, as it is written: a word, or with what is around it, quotes or brackets [..] {..}. A key within
 * the value of another one is none. False: the title has no such key. */
bool title_value(const char *title, const char *key, struct field *value);

/* The parts of a value: words between blanks and commas, whatever brackets and quotes there are. The first `capacity`
 * are stored; the result is the number of all of them. */
size_t title_value_split(struct field value, struct field *parts, size_t capacity);
