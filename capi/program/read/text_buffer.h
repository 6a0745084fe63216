/* Text that grows in memory: results are collected in it, and reach stdout completely or not at all. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "read/failure.h"

struct text_buffer {
  char *text; /* NUL-terminated as soon as anything was added */
  size_t length;
  size_t capacity;
  bool out_of_memory; /* stays set; later additions are ignored */
  uint32_t threads;   /* how many may make rows of a table at the same time; 0: only the calling one */
};

#define TEXT_BUFFER_EMPTY \
  { NULL, 0, 0, false, 0 }

/* The part of text_buffer_reserve for a buffer without enough room. */
bool text_buffer_grow(struct text_buffer *buffer, size_t more);

/* Make room for `more` bytes and a closing NUL; false when memory is short. */
static inline bool text_buffer_reserve(struct text_buffer *buffer, size_t more) {
  if (buffer->out_of_memory) return false;
  return more < buffer->capacity - buffer->length || text_buffer_grow(buffer, more);
}

/* Add text as printf would; the most common formats are written without it. */
void text_buffer_add(struct text_buffer *buffer, const char *format, ...) FAILURE_FORMAT(2, 3);

/* Add any bytes. It is inline so that the compiler knows the length of a literal. */
static inline void text_buffer_append(struct text_buffer *buffer, const char *bytes, size_t count) {
  if (count == 0 || !text_buffer_reserve(buffer, count)) return;
  char *const at = buffer->text + buffer->length;
  memcpy(at, bytes, count);
  at[count] = '\0';
  buffer->length += count;
}

/* "%s" */
static inline void text_buffer_add_text(struct text_buffer *buffer, const char *text) {
  text_buffer_append(buffer, text, strlen(text));
}

/* "%c" */
static inline void text_buffer_add_character(struct text_buffer *buffer, char character) {
  if (!text_buffer_reserve(buffer, 1)) return;
  buffer->text[buffer->length++] = character;
  buffer->text[buffer->length] = '\0';
}

/* "%" PRIu64 */
void text_buffer_add_count(struct text_buffer *buffer, uint64_t count);

/* Add a number as number_text_exact writes it. */
void text_buffer_add_exact(struct text_buffer *buffer, double value);

/* Add a text as the content of an XML element; a byte that is not ASCII, or does not print, becomes '?'. */
void text_buffer_add_xml(struct text_buffer *buffer, const char *text);

/* Write everything to stdout. False: writing failed, or memory was short before. */
bool text_buffer_print(const struct text_buffer *buffer, struct failure *failure);

void text_buffer_free(struct text_buffer *buffer);
