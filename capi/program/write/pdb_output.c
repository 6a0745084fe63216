#include "write/pdb_output.h"

#include <stdlib.h>
#include <string.h>

#include "read/characters.h"
#include "read/line_reader.h"
#include "read/pdb_records.h"
#include "read/text_buffer.h"
#include "write/output_file.h"
#include "write/pdb_number.h"

enum { AREA_BEGIN = 60, AREA_WIDTH = 6, AREA_END = AREA_BEGIN + AREA_WIDTH };

struct copying {
  struct line_reader *reader;
  const struct molecule *molecule;
  const double *area;
  uint32_t next; /* atom of the molecule that comes next */
  struct pdb_models models;
  bool left_out; /* the last atom record was */
  bool end_seen;
  struct text_buffer out;
  struct failure *failure;
};

static void copy_line(struct copying *copying) {
  text_buffer_append(&copying->out, copying->reader->text, copying->reader->length);
  text_buffer_add(&copying->out, "%s", copying->reader->ending);
}

static bool write_atom(struct copying *copying) {
  const struct line_reader *reader = copying->reader;
  char area[PDB_NUMBER_BYTES];
  if (!pdb_number(area, AREA_WIDTH, 2, copying->area[copying->next])) {
    return failure_in_input(copying->failure, reader->number,
                            "its area, %.3g, is too large for columns 61-66 of --pdb-out",
                            copying->area[copying->next]);
  }
  const size_t before = reader->length < AREA_BEGIN ? reader->length : AREA_BEGIN;
  text_buffer_append(&copying->out, reader->text, before);
  text_buffer_add(&copying->out, "%*s%s", (int)(AREA_BEGIN - before), "", area);
  if (reader->length > AREA_END) {
    text_buffer_append(&copying->out, reader->text + AREA_END, reader->length - AREA_END);
  }
  text_buffer_add(&copying->out, "%s", reader->ending);
  ++copying->next;
  return true;
}

static bool begins_with(const struct line_reader *reader, const char *name) {
  return field_is(field_in_columns(reader->text, reader->length, 1, strlen(name)), name);
}

static bool belongs_to_an_atom(const struct line_reader *reader) {
  return begins_with(reader, "ANISOU") || begins_with(reader, "SIGATM") || begins_with(reader, "SIGUIJ");
}

static void take_line_after_model(struct copying *copying, enum pdb_record record) {
  const struct line_reader *reader = copying->reader;
  const bool end = record == PDB_END && !begins_with(reader, "ENDMDL");
  if (end || begins_with(reader, "CONECT") || begins_with(reader, "MASTER")) copy_line(copying);
  copying->end_seen = end;
}

static bool take_line(struct copying *copying) {
  const struct molecule *molecule = copying->molecule;
  const struct line_reader *reader = copying->reader;
  const enum pdb_record record = pdb_record_of(reader->text, reader->length);
  const bool was_open = copying->models.open;
  pdb_models_step(&copying->models, record);
  const uint64_t model = copying->models.count;
  const bool closes = was_open && record == PDB_END;
  if (model > molecule->model || (model == molecule->model && !copying->models.open && !closes)) {
    take_line_after_model(copying, record);
  } else if (model > 0 && model < molecule->model) {
    copying->left_out = true;
  } else if (record == PDB_ATOM) {
    copying->left_out = copying->next == molecule->atoms || molecule->line[copying->next] != reader->number;
    return copying->left_out || write_atom(copying);
  } else if (!copying->left_out || !belongs_to_an_atom(reader)) {
    copy_line(copying);
    copying->end_seen = closes && !begins_with(reader, "ENDMDL");
  }
  return true;
}

static bool copy(struct copying *copying, const char *from) {
  if (input_is_standard(from)) rewind(stdin);
  if (!line_reader_open(copying->reader, from, copying->failure)) return false;
  enum line_status status = LINE_READ;
  while (status == LINE_READ && !copying->end_seen) {
    status = line_reader_next(copying->reader, copying->failure);
    if (status == LINE_READ && copying->reader->marked) text_buffer_add(&copying->out, "\xEF\xBB\xBF");
    if (status == LINE_READ && !take_line(copying)) status = LINE_FAILED;
  }
  line_reader_close(copying->reader);
  if (status == LINE_FAILED) return false;
  if (copying->next != copying->molecule->atoms) {
    return failure_in_input(copying->failure, 0, "the file has changed since it was read");
  }
  return !copying->out.out_of_memory || failure_of_memory(copying->failure);
}

bool pdb_output_write(const char *from, const struct molecule *molecule, const double *area, const char *to,
                      struct failure *failure) {
  struct line_reader *reader = malloc(sizeof *reader);
  if (reader == NULL) return failure_of_memory(failure);
  const char *file_before = failure->file;
  struct copying copying = {reader, molecule, area, 0, PDB_MODELS_NONE, false, false, TEXT_BUFFER_EMPTY, failure};
  failure->file = input_name(from);
  const bool done = copy(&copying, from) && output_file_write_text(to, &copying.out, failure);
  if (done) failure->file = file_before;
  text_buffer_free(&copying.out);
  free(reader);
  return done;
}
