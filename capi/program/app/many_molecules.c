#include "app/many_molecules.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "app/molecule_run.h"
#include "app/notes.h"
#include "commands/input_report.h"
#include "read/molecule_texts.h"
#include "read/read_molecule.h"
#include "read/stopping.h"
#include "read/threads.h"
#include "write/csv.h"
#include "write/report.h"

enum {
  SLOTS_OF_WORKER = 4,
  WATCHED_MOLECULES = 1000, /* less takes no time that anybody would watch */
  BYTES_OF_ROWS = 1 << 14,
  MOST_NOTED = 8,    /* molecules whose notes are printed */
  MEMORY_OF_BYTE = 5 /* bytes of memory for a byte of the file, about */
};

/* The memory of molecules that are worked on at the same time; a larger one is alone. */
#define MOST_MEMORY ((uint64_t)1 << 30)

/* A molecule between reading and printing. */
struct one {
  struct molecule_text text;
  struct text_buffer title; /* as the file has it */
  bool done;
  struct notes notes;
  struct text_buffer out; /* titles of columns and the row, or an object of JSON */
  struct failure failure; /* if it is not done */
};

/* The data of a thread, used for one molecule after the other. */
struct worker {
  struct molecule molecule;
  struct geometry geometry;
};

struct many {
  const struct request *request;
  struct in_order loop;
  struct molecule_texts texts;
  struct one *one;           /* [slots] */
  struct worker *worker;     /* [workers] */
  bool begun;                /* the table's first line is there */
  struct text_buffer titles; /* of the columns between the first and the last ones */
  struct text_buffer rows;   /* rows that are not printed yet */
  time_t printed;            /* the time when rows were last printed */
  struct text_buffer early;  /* rows of comma-separated values of molecules that failed before the table began */
  uint64_t given, failed, noted;
  struct progress progress;
  struct failure *failure;
};

static bool take_one(void *of, uint32_t slot, uint64_t *weight) {
  struct many *const many = of;
  struct one *const one = &many->one[slot];
  one->failure = (struct failure)FAILURE_NONE;
  one->failure.file = input_name(many->request->file);
  const enum line_status status = molecule_texts_next(&many->texts, &one->text, &one->failure);
  one->done = status == LINE_READ;
  if (many->loop.workers > 1) *weight = MEMORY_OF_BYTE * (uint64_t)one->text.text.length;
  return status != LINE_END;
}

/* Before it is read, which cuts its text into lines. */
static void take_title(const struct file_format *format, struct one *one) {
  const struct text_buffer *const text = &one->text.text;
  struct field title = {"", 0};
  if (text->length > 0) title = format->title(text->text, text->length);
  one->title.length = 0;
  text_buffer_append(&one->title, title.text, title.length);
}

static void work_on_one(void *of, uint32_t number, uint32_t slot) {
  const struct many *const many = of;
  const struct request *const request = many->request;
  struct worker *const worker = &many->worker[number];
  struct one *const one = &many->one[slot];
  one->out.length = 0;
  one->notes = (struct notes)NOTES_NONE;
  take_title(request->format, one);
  if (!one->done) return;
  one->done = read_molecule_text(&one->text, request->format, &request->choice, molecule_keeping(request),
                                 &worker->molecule, &one->failure);
  worker->molecule.number = one->text.number;
  one->done = one->done && molecule_prepare(request, &worker->molecule, &one->notes, &one->failure) &&
              molecule_run(request, request_threads(request) / many->loop.workers, &worker->molecule, &worker->geometry,
                           &one->notes, &one->out, &one->failure);
  if (one->out.out_of_memory || one->title.out_of_memory) one->done = failure_of_memory(&one->failure);
}

/* ---- rows ---- */

/* "line 12: unknown element 'Q'" */
static void add_reason(const struct failure *failure, struct text_buffer *out) {
  if (failure->line > 0) text_buffer_add(out, "line %" PRIu64 ": ", failure->line);
  text_buffer_add_text(out, failure->reason);
}

static void json_row(const struct one *one, const char *title, const char *reason, struct text_buffer *out) {
  text_buffer_add(out, "{\"model\": %" PRIu64 ", \"title\": ", one->text.number);
  json_text(out, title);
  text_buffer_add_text(out, ", ");
  if (one->done) {
    text_buffer_append(out, one->out.text + 1, one->out.length - 1);
    return;
  }
  text_buffer_add_text(out, "\"fault\": ");
  json_text(out, reason);
  text_buffer_add_text(out, "}\n");
}

/* Empty columns, as many as there are between the first and the last ones, each with the comma behind it; a mark as
 * long as that is not known. */
static const char columns_to_come = '\1';
static void add_empty_columns(const struct many *many, struct text_buffer *out) {
  if (!many->begun) text_buffer_append(out, &columns_to_come, 1);
  if (many->titles.length > 0) text_buffer_append(out, ",", 1);
  for (size_t k = 0; k < many->titles.length; ++k) {
    if (many->titles.text[k] == ',') text_buffer_append(out, ",", 1);
  }
}

static void csv_row(const struct many *many, const struct one *one, const char *title, const char *reason,
                    const char *row, size_t length, struct text_buffer *out) {
  text_buffer_add(out, "%" PRIu64 ",", one->text.number);
  csv_text(out, title);
  text_buffer_append(out, ",", 1);
  if (one->done) {
    text_buffer_append(out, row, length);
    text_buffer_append(out, ",", 1);
  } else {
    add_empty_columns(many, out);
  }
  csv_text(out, reason);
  text_buffer_append(out, "\n", 1);
}

static void row_for_persons(const struct one *one, const char *title, const char *reason, const char *row,
                            size_t length, struct text_buffer *out) {
  text_buffer_add(out, "  %7" PRIu64, one->text.number);
  if (one->done) text_buffer_append(out, row, length);
  text_buffer_add_text(out, "  ");
  report_file_name(out, title);
  if (!one->done) text_buffer_add(out, "%s%s", title[0] == '\0' ? "" : ": ", reason);
  text_buffer_append(out, "\n", 1);
}

/* The first line of the table, once it is known; of comma-separated values with the rows that waited for it. */
static void begin_table(struct many *many, const char *titles, size_t length, struct text_buffer *out) {
  const bool csv = many->request->rows == ROWS_OF_CSV;
  if (many->begun) return;
  many->begun = true;
  text_buffer_append(&many->titles, titles, length);
  text_buffer_add(out, "%s", csv ? "model,title," : "    model");
  text_buffer_append(out, titles, length);
  text_buffer_add(out, "%s\n", !csv ? "  title" : length > 0 ? ",fault" : "fault");
  for (size_t at = 0; at < many->early.length; ++at) {
    if (many->early.text[at] != columns_to_come) {
      text_buffer_append(out, many->early.text + at, 1);
    } else {
      add_empty_columns(many, out);
    }
  }
  many->early.length = 0;
}

/* Add the row of a molecule. The command has written two lines, titles and row. */
static void add_row(struct many *many, const struct one *one, struct text_buffer *out) {
  const enum rows rows = many->request->rows;
  struct text_buffer reason = TEXT_BUFFER_EMPTY;
  if (!one->done) add_reason(&one->failure, &reason);
  const char *const name = one->title.length > 0 ? one->title.text : "", *const why =
                                                                             reason.length > 0 ? reason.text : "";
  const char *row = NULL;
  size_t length = 0;
  if (one->done && rows != ROWS_NONE) {
    const size_t titles = strcspn(one->out.text, "\n");
    begin_table(many, one->out.text, titles, out);
    row = one->out.text + titles + 1;
    length = one->out.length - titles - 2;
  }
  if (reason.out_of_memory) {
    out->out_of_memory = true;
  } else if (rows == ROWS_NONE) {
    json_row(one, name, why, out);
  } else if (rows == ROWS_FOR_PERSONS) {
    row_for_persons(one, name, why, row, length, out);
  } else {
    csv_row(many, one, name, why, row, length, many->begun ? out : &many->early);
  }
  text_buffer_free(&reason);
}

static void print_notes(struct many *many, const struct one *one) {
  const struct notes *const notes = &one->notes;
  if (notes_are_none(notes) || ++many->noted > MOST_NOTED) return;
  struct request own = *many->request;
  char name[160];
  const char *const file = input_name(own.file);
  const size_t length = strlen(file), most = 120;
  snprintf(name, sizeof name, "%s, molecule %" PRIu64, length > most ? file + (length - most) : file, one->text.number);
  own.file = name;
  notes_print(notes, &own);
}

static void show(const struct many *many) {
  char text[40];
  if (many->given % WATCHED_MOLECULES != 0) return;
  snprintf(text, sizeof text, "molecule %" PRIu64, many->given);
  progress_show(&many->progress, text);
}

static bool print_rows(struct many *many) {
  const bool done = text_buffer_print(&many->rows, many->failure);
  many->rows.length = 0;
  many->printed = time(NULL);
  return done;
}

/* Rows of small molecules are printed many at a time, but no later than a person would see. */
static bool print_one(void *of, uint32_t slot) {
  struct many *const many = of;
  struct one *const one = &many->one[slot];
  if (!one->done && stopping_asked()) return false;
  if (!one->done && one->failure.file == NULL) { /* memory is short */
    *many->failure = one->failure;
    return false;
  }
  progress_end(&many->progress);
  ++many->given;
  many->failed += one->done ? 0 : 1;
  add_row(many, one, &many->rows);
  const bool due = many->rows.length >= BYTES_OF_ROWS || time(NULL) != many->printed;
  const bool done = !due || print_rows(many);
  if (one->done) print_notes(many, one);
  notes_free(&one->notes);
  show(many);
  return done;
}

/* ---- the file ---- */

static bool allocate(struct many *many, struct failure *failure) {
  const uint32_t threads = request_threads(many->request);
  struct in_order *const loop = &many->loop;
  *loop = (struct in_order){many, threads, 0, MOST_MEMORY, take_one, work_on_one, print_one};
  loop->slots = loop->workers == 1 ? 1 : SLOTS_OF_WORKER * loop->workers;
  many->one = calloc(loop->slots, sizeof *many->one);
  many->worker = calloc(loop->workers, sizeof *many->worker);
  return (many->one != NULL && many->worker != NULL) || failure_of_memory(failure);
}

static void release(struct many *many) {
  for (uint32_t k = 0; many->worker != NULL && k < many->loop.workers; ++k) {
    if (many->worker[k].molecule.format != NULL) molecule_free(&many->worker[k].molecule);
    geometry_free(&many->worker[k].geometry);
  }
  for (uint32_t k = 0; many->one != NULL && k < many->loop.slots; ++k) {
    text_buffer_free(&many->one[k].text.text);
    text_buffer_free(&many->one[k].title);
    text_buffer_free(&many->one[k].out);
    notes_free(&many->one[k].notes);
  }
  free(many->worker);
  free(many->one);
  text_buffer_free(&many->titles);
  text_buffer_free(&many->early);
  text_buffer_free(&many->rows);
  molecule_texts_close(&many->texts);
}

/* Prints the rest: of a table without a molecule that did not fail its first line, and notes of all. */
static bool finish(struct many *many, struct failure *failure) {
  if (many->request->rows == ROWS_OF_CSV) begin_table(many, "", 0, &many->rows);
  const bool done = print_rows(many);
  struct notes all = NOTES_NONE;
  for (uint32_t k = 0; k < many->loop.workers; ++k) {
    all.largest_rounding = fmax(all.largest_rounding, many->worker[k].geometry.largest_rounding);
  }
  if (many->noted > MOST_NOTED) {
    text_buffer_add(&all.lines, "notes on %" PRIu64 " more molecules are left out\n", many->noted - MOST_NOTED);
  }
  notes_print(&all, many->request);
  notes_free(&all);
  failure->file = input_name(many->request->file);
  return done && (many->failed == 0 ||
                  failure_in_input(failure, 0, "%" PRIu64 " of %" PRIu64 " molecules failed; their rows say why",
                                   many->failed, many->given));
}

static bool print_heading(const struct request *request, struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  if (request->rows != ROWS_FOR_PERSONS) return true;
  rows_heading(&out, request, &(struct files_among){request->file, .one_unit = true});
  const bool done = text_buffer_print(&out, failure);
  text_buffer_free(&out);
  return done;
}

bool many_molecules_run(const struct request *request, struct failure *failure) {
  struct many many = {.request = request, .failure = failure};
  bool done = molecule_texts_open(&many.texts, request->file, request->format, failure) && allocate(&many, failure) &&
              print_heading(request, failure);
  if (done) {
    many.progress = progress_begin(1, 1);
    progress_be_quiet();
    done = in_order_run(&many.loop) || failure_of_memory(failure);
    progress_end(&many.progress);
    if (done && failure->exit_status == 0) done = stopping_asked() ? print_rows(&many) : finish(&many, failure);
    done = done && failure->exit_status == 0;
  }
  release(&many);
  return done;
}
