/* The keys of JSON in the help of a command: those that the command itself writes. */
#pragma once

#include "commands/request.h"
#include "read/text_buffer.h"

/* Adds the paragraphs of a text to `out`, filled into lines, in which stands for
 *   <>                   the keys that follow the last ones that were named
 *   <..key>              the same up to that key
 *   <--option value=key> what the command has of that key with such options
 *   <--option value..key>, <--option value>
 *                        as the first two, of the keys that it has with such options alone
 * As a name that the command does not write would be, `key` stays as it is where there is no such key. */
void help_keys_fill(struct text_buffer *out, enum command command, const char *text);
