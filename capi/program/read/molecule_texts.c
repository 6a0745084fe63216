#include "read/molecule_texts.h"

#include <string.h>

struct field molecule_text_next_line(const char **text, size_t *length) {
  const char *const end = *length == 0 ? NULL : memchr(*text, '\n', *length);
  const char *const begin = *text;
  const size_t own = end == NULL ? *length : (size_t)(end - begin);
  const size_t all = end == NULL ? own : own + 1;
  *text += all;
  *length -= all;
  return own == 0 ? (struct field){"", 0} : field_in_columns(begin, own, 1, own);
}

bool molecule_texts_open(struct molecule_texts *texts, const char *path, const struct file_format *format,
                         struct failure *failure) {
  *texts = (struct molecule_texts){.format = format};
  failure->file = input_name(path);
  return line_reader_open(&texts->reader, path, failure);
}

void molecule_texts_close(struct molecule_texts *texts) {
  if (texts->format != NULL) line_reader_close(&texts->reader);
  text_buffer_free(&texts->common);
  text_buffer_free(&texts->behind);
}

/* With '\n' in place of its own end; once, as it has no end for the reader then. */
static void add_line(struct text_buffer *out, const struct line_reader *reader) {
  reader->text[reader->length] = '\n';
  text_buffer_append(out, reader->text, reader->length + 1);
}

static bool is_blank(const struct text_buffer *text) {
  return text->length == 0 || strspn(text->text, " \t\n") == text->length;
}

/* Begin a text with what all have and what was left for it. */
static void begin(struct molecule_texts *texts, struct molecule_text *text) {
  text->text.length = 0;
  text->number = texts->given + 1;
  text->common = texts->common_lines;
  text->before = texts->reader.number - (texts->held ? 1 : 0) - texts->behind_lines;
  text_buffer_append(&text->text, texts->common.text, texts->common.length);
  text_buffer_append(&text->text, texts->behind.text, texts->behind.length);
  texts->behind.length = 0;
  texts->behind_lines = 0;
}

/* Keep the lines so far as common to all molecules. */
static void keep_common(struct molecule_texts *texts, struct molecule_text *text) {
  text_buffer_append(&texts->common, text->text.text, text->text.length);
  texts->common_lines = text->common = text->before = texts->reader.number - 1;
}

static enum line_status fail_of_memory(struct failure *failure) {
  failure_of_memory(failure);
  return LINE_FAILED;
}

enum line_status molecule_texts_next(struct molecule_texts *texts, struct molecule_text *text,
                                     struct failure *failure) {
  struct line_reader *const reader = &texts->reader;
  struct molecule_lines *const lines = &texts->lines;
  const bool broken = texts->broken.exit_status != 0;
  if (texts->ended && !broken) return LINE_END;
  begin(texts, text);
  if (broken) {
    *failure = texts->broken;
    texts->broken.exit_status = 0;
    return LINE_FAILED;
  }
  enum line_status status = LINE_READ;
  bool any = texts->held;
  if (texts->held) add_line(&text->text, reader);
  texts->held = false;
  for (;;) {
    const char *passed;
    size_t bytes = 0;
    if (any && lines->mark != '\0') lines->line += line_reader_pass(reader, lines->mark, &passed, &bytes);
    if (bytes > 0) text_buffer_append(&text->text, passed, bytes);
    status = line_reader_next(reader, failure);
    if (status != LINE_READ) break;
    const bool before = lines->count == 0;
    const bool begins = texts->format->begins(lines, reader);
    if (begins && before && lines->first) keep_common(texts, text);
    texts->held = begins && any;
    if (texts->held) break;
    any = any || begins;
    const bool behind = lines->behind && any;
    add_line(behind ? &texts->behind : &text->text, reader);
    texts->behind_lines += behind ? 1 : 0;
  }
  if (text->text.out_of_memory || texts->behind.out_of_memory || texts->common.out_of_memory) {
    return fail_of_memory(failure);
  }
  texts->ended = status != LINE_READ;
  if (status == LINE_FAILED && (!any || lines->open)) return LINE_FAILED;
  if (status == LINE_FAILED) {
    texts->broken = *failure;
    *failure = (struct failure)FAILURE_NONE;
    failure->file = texts->broken.file;
  }
  const bool none = status == LINE_END && (is_blank(&text->text) || lines->count == 0);
  if (none && texts->given > 0) return LINE_END;
  ++texts->given;
  return LINE_READ;
}
