/* The words of a CIF file, one after the other: tags, values, and the keywords between them (Hall, Allen and Brown,
 * "The crystallographic information file (CIF)", 1991; syntax of CIF 1.1). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/fields.h"
#include "read/line_reader.h"
#include "read/text_buffer.h"

enum cif_kind {
  CIF_VALUE,
  CIF_TAG,     /* _category.item */
  CIF_LOOP,    /* loop_ */
  CIF_BLOCK,   /* data_name */
  CIF_KEYWORD, /* save_, global_ or stop_: none of them belongs into a file of coordinates */
  CIF_END,     /* of the file */
  CIF_FAILED
};

struct cif_tokens {
  enum cif_kind kind;
  struct field text; /* without quotes; valid until the next step */
  bool quoted;       /* the value was in quotes: "?" and "." mean themselves */
  uint64_t line;     /* on which it begins */

  struct line_reader *reader;
  size_t at;               /* the first character of the line that was not read yet */
  struct text_buffer many; /* a text field of several lines */
  struct failure *failure;
};

/* Begin at the first line of a reader. */
void cif_tokens_begin(struct cif_tokens *tokens, struct line_reader *reader, struct failure *failure);

/* Step to the next token and return its kind. CIF_FAILED: the failure says why. */
enum cif_kind cif_tokens_next(struct cif_tokens *tokens);

/* Step to the next line instead, and look at none of its tokens. False: there is none, kind tells why. */
bool cif_tokens_next_line(struct cif_tokens *tokens);

/* Whether a value says nothing: "?" and ".", unless in quotes. */
bool cif_value_is_absent(const struct cif_tokens *tokens);

void cif_tokens_free(struct cif_tokens *tokens);
