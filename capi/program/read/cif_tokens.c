#include "read/cif_tokens.h"

#include <string.h>

#include "read/characters.h"

void cif_tokens_begin(struct cif_tokens *tokens, struct line_reader *reader, struct failure *failure) {
  memset(tokens, 0, sizeof *tokens);
  tokens->reader = reader;
  tokens->failure = failure;
}

static enum cif_kind take(struct cif_tokens *tokens, enum cif_kind kind, size_t begin, size_t end) {
  tokens->kind = kind;
  tokens->text = (struct field){tokens->reader->text + begin, end - begin};
  return kind;
}

static enum cif_kind fail(struct cif_tokens *tokens) {
  tokens->kind = CIF_FAILED;
  tokens->text.length = 0;
  return CIF_FAILED;
}

/* From the semicolon that the line begins with to the line that begins with the next one. */
static enum cif_kind take_text_field(struct cif_tokens *tokens) {
  struct line_reader *reader = tokens->reader;
  tokens->many.length = 0;
  text_buffer_append(&tokens->many, reader->text + 1, reader->length - 1);
  for (;;) {
    const enum line_status status = line_reader_next(reader, tokens->failure);
    if (status == LINE_FAILED) return fail(tokens);
    if (status == LINE_END) {
      failure_in_input(tokens->failure, tokens->line, "the text that begins with ';' has no end");
      return fail(tokens);
    }
    if (reader->text[0] == ';') break;
    text_buffer_append(&tokens->many, "\n", 1);
    text_buffer_append(&tokens->many, reader->text, reader->length);
  }
  if (tokens->many.out_of_memory) {
    failure_of_memory(tokens->failure);
    return fail(tokens);
  }
  tokens->at = 1;
  tokens->kind = CIF_VALUE;
  tokens->quoted = true;
  tokens->text = (struct field){tokens->many.text == NULL ? "" : tokens->many.text, tokens->many.length};
  return CIF_VALUE;
}

/* A quote ends a value only where a blank or the end of the line follows: 'O5'' is O5'. */
static enum cif_kind take_quoted(struct cif_tokens *tokens, size_t begin) {
  const struct line_reader *reader = tokens->reader;
  const char quote = reader->text[begin];
  for (size_t end = begin + 1; end < reader->length; ++end) {
    if (reader->text[end] != quote || (end + 1 < reader->length && !is_blank(reader->text[end + 1]))) continue;
    tokens->at = end + 1;
    tokens->quoted = true;
    return take(tokens, CIF_VALUE, begin + 1, end);
  }
  failure_in_input(tokens->failure, reader->number, "no quote (%c) ends what one begins", quote);
  return fail(tokens);
}

static bool begins_with(struct field word, const char *keyword) {
  const size_t length = strlen(keyword);
  return word.length >= length && field_is((struct field){word.text, length}, keyword);
}

static enum cif_kind kind_of(struct field word) {
  const char last = word.text[word.length - 1];
  if (word.text[0] == '_') return word.length > 1 ? CIF_TAG : CIF_VALUE;
  if (last == '_') {
    if (field_is(word, "LOOP_")) return CIF_LOOP;
    if (field_is(word, "GLOBAL_") || field_is(word, "STOP_")) return CIF_KEYWORD;
  }
  /* Few values contain an underscore as their fifth character. */
  if (word.length >= 5 && word.text[4] == '_') {
    if (begins_with(word, "SAVE_")) return CIF_KEYWORD;
    if (begins_with(word, "DATA_")) return CIF_BLOCK;
  }
  return CIF_VALUE;
}

enum cif_kind cif_tokens_next(struct cif_tokens *tokens) {
  struct line_reader *reader = tokens->reader;
  tokens->quoted = false;
  for (;;) {
    const char *text = reader->text;
    size_t begin = tokens->at;
    const size_t length = reader->number == 0 ? 0 : reader->length;
    while (begin < length && is_blank(text[begin])) ++begin;
    if (begin < length && text[begin] != '#') {
      tokens->line = reader->number;
      if (text[begin] == '\'' || text[begin] == '"') return take_quoted(tokens, begin);
      if (text[begin] == ';' && begin == 0) return take_text_field(tokens);
      size_t end = begin + 1;
      while (end < length && !is_blank(text[end])) ++end;
      tokens->at = end;
      return take(tokens, kind_of((struct field){text + begin, end - begin}), begin, end);
    }
    if (!cif_tokens_next_line(tokens)) return tokens->kind;
  }
}

bool cif_tokens_next_line(struct cif_tokens *tokens) {
  const enum line_status status = line_reader_next(tokens->reader, tokens->failure);
  tokens->at = 0;
  if (status == LINE_READ) return true;
  if (status == LINE_FAILED) fail(tokens);
  if (status == LINE_END) {
    tokens->kind = CIF_END;
    tokens->text = (struct field){"", 0};
  }
  return false;
}

bool cif_value_is_absent(const struct cif_tokens *tokens) {
  const char first = tokens->text.length == 1 ? tokens->text.text[0] : ' ';
  return !tokens->quoted && (first == '?' || first == '.');
}

void cif_tokens_free(struct cif_tokens *tokens) {
  text_buffer_free(&tokens->many);
}
