/* Values by their keys in the title of an extended XYZ file: key=value, with or without blanks around the sign. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/fields.h"

/* The value of a key, as written: a word, or a text in quotes or brackets [..] {..}, which are part of the result. A
 * key within the value of another one does not count. False: the title has no such key. */
bool title_value(const char *title, const char *key, struct field *value);

/* The parts of a value: words between blanks and commas; brackets and quotes are ignored. The first `capacity` are
 * stored; the result is the number of all of them. */
size_t title_value_split(struct field value, struct field *parts, size_t capacity);
