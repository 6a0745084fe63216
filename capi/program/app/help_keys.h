/* The keys of JSON in the help of a command: those that the command itself writes. */
#pragma once

#include "commands/request.h"
#include "read/text_buffer.h"

/* Add the paragraphs of a text to `out`, filled into lines, with these marks replaced:
 *   <>                   by the keys that follow those named so far
 *   <..key>              by the same keys up to `key`
 *   <--option value=key> by the form of that key when such options are given
 *   <--option value..key>, <--option value>
 *                        as the first two, but by keys that the command writes only with such options
 * If there is no such key, the result is <key>, brackets included. */
void help_keys_fill(struct text_buffer *out, enum command command, const char *text);
