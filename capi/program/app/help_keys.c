#include "app/help_keys.h"

#include <stdlib.h>
#include <string.h>

#include "app/arguments.h"
#include "app/command_table.h"
#include "app/option.h"

enum { LINE_BYTES = 115, MOST_WORDS = 8 };

/* Keys with the columns of their tables, a line each; and where those begin that were not named yet. */
struct keys {
  struct text_buffer text;
  size_t named;
};

/* Write the keys of a command with these options. */
static void write_keys(struct keys *keys, enum command command, const char *options, size_t length) {
  char words[160];
  char *word[MOST_WORDS];
  int count = 0;
  struct failure failure = FAILURE_NONE;
  struct request request;
  struct molecule molecule;
  memset(&molecule, 0, sizeof molecule);
  molecule.format = file_format_named("pdb", FILE_ATOMS);
  if (length >= sizeof words) length = sizeof words - 1;
  memcpy(words, options, length);
  words[length] = '\0';
  for (char *at = strtok(words, " "); at != NULL && count < MOST_WORDS; at = strtok(NULL, " ")) word[count++] = at;
  struct record record = {
      .form = AS_JSON, .molecule = &molecule, .atoms = "n", .width = VALUE_WIDTH, .keys = true, .out = &keys->text};
  if (request_read(&request, command, count, word, &failure)) command_table[command].describe(&request, &record);
  text_buffer_add_text(&keys->text, "\n");
  request_free(&request);
}

/* The length of the line at `at`, and of the key that it begins with. */
static size_t line_length(const char *at) {
  return strcspn(at, "\n");
}
static size_t key_length(const char *at) {
  return strcspn(at, ":\n");
}

static bool has_line(const char *text, const char *line, size_t length) {
  for (; text[0] != '\0'; text += line_length(text) + 1) {
    if (line_length(text) == length && memcmp(text, line, length) == 0) return true;
  }
  return false;
}

/* Takes away the lines that others have, too. */
static void keep_new(struct keys *keys, const struct keys *others) {
  struct text_buffer kept = TEXT_BUFFER_EMPTY;
  for (const char *at = keys->text.text; at[0] != '\0'; at += line_length(at) + 1) {
    const size_t length = line_length(at);
    if (!has_line(others->text.text, at, length)) text_buffer_append(&kept, at, length + 1);
  }
  text_buffer_add_text(&kept, "");
  text_buffer_free(&keys->text);
  keys->text = kept;
}

/* Name the keys from the first that was not named up to `key`, or `key` alone; key "": up to the last one. */
static void name_keys(struct keys *keys, const char *key, size_t length, bool alone, struct text_buffer *out) {
  const char *const first = keys->text.text + keys->named;
  if (first[0] == '\n') text_buffer_add_text(out, "(left out of this build)");
  const char *at = first, *last = NULL;
  for (; at[0] != '\0' && last == NULL; at += line_length(at) + 1) {
    if (length > 0 && key_length(at) == length && memcmp(at, key, length) == 0) last = at;
  }
  if (length > 0 && last == NULL) {
    text_buffer_append(out, "<", 1);
    text_buffer_append(out, key, length);
    text_buffer_append(out, ">", 1);
    return;
  }
  for (const char *line = alone ? last : first; line < at; line += line_length(line) + 1) {
    if (line != first && !alone) text_buffer_append(out, ", ", 2);
    text_buffer_append(out, line, line_length(line));
  }
  keys->named = (size_t)(at - keys->text.text);
}

/* Breaks lines at blanks, and where the text does. */
static void fill(struct text_buffer *out, const char *text) {
  size_t column = 0;
  while (text[0] != '\0') {
    const size_t length = strcspn(text, " \n");
    if (column > 0 && column + 1 + length > LINE_BYTES) {
      text_buffer_append(out, "\n", 1);
      column = 0;
    } else if (column > 0) {
      text_buffer_append(out, " ", 1);
      ++column;
    }
    text_buffer_append(out, text, length);
    column += length;
    text += length;
    if (text[0] == '\n') {
      text_buffer_append(out, "\n", 1);
      column = 0;
    }
    text += strspn(text, " \n");
  }
  text_buffer_add_text(out, "\n");
}

void help_keys_fill(struct text_buffer *out, enum command command, const char *text) {
  struct keys all = {TEXT_BUFFER_EMPTY, 0}, special = {TEXT_BUFFER_EMPTY, 0};
  struct text_buffer filled = TEXT_BUFFER_EMPTY;
  const char *options = "";
  size_t options_length = 0;
  write_keys(&all, command, "", 0);
  while (text[0] != '\0' && !all.text.out_of_memory && !special.text.out_of_memory) {
    const size_t plain = strcspn(text, "<");
    text_buffer_append(&filled, text, plain);
    text += plain;
    if (text[0] == '\0') break;
    const char *const begin = ++text, *const end = strchr(begin, '>');
    const char *key = begin;
    while (key < end && key[0] != '=' && strncmp(key, "..", 2) != 0) ++key;
    const size_t length = (size_t)(key - begin);
    const bool alone = key[0] == '=';
    if (length > 0 && (length != options_length || memcmp(begin, options, length) != 0)) {
      text_buffer_free(&special.text);
      special = (struct keys){TEXT_BUFFER_EMPTY, 0};
      options = begin;
      options_length = length;
      write_keys(&special, command, options, length);
      if (!special.text.out_of_memory) keep_new(&special, &all);
    }
    if (special.text.out_of_memory) break;
    if (key < end) key += alone ? 1 : 2;
    name_keys(length > 0 ? &special : &all, key, (size_t)(end - key), alone, &filled);
    text = end + 1;
  }
  if (filled.text != NULL) fill(out, filled.text);
  out->out_of_memory =
      out->out_of_memory || filled.out_of_memory || all.text.out_of_memory || special.text.out_of_memory;
  text_buffer_free(&all.text);
  text_buffer_free(&special.text);
  text_buffer_free(&filled);
}
