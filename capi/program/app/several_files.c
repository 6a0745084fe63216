#include "app/several_files.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "app/arguments.h"
#include "commands/input_report.h"
#include "read/line_reader.h"
#include "read/progress.h"
#include "read/stopping.h"
#include "read/threads.h"
#include "write/csv.h"
#include "write/report.h"

enum {
  SLOTS_OF_WORKER = 8, /* so that no worker waits for a large file among small ones */
  WATCHED_FILES = 100, /* less takes no time that anybody would watch */
  MEMORY_OF_BYTE = 5   /* bytes of memory for a byte of the file, about */
};

/* The memory of files that are worked on at the same time; a larger one is alone. */
#define MOST_MEMORY ((uint64_t)1 << 30)

/* A file between reading and printing. */
struct file {
  const struct request *request; /* of its format; NULL: it has none */
  const char *name;
  bool done;
  struct notes notes;
  struct text_buffer out;
  struct failure failure; /* if it is not done */
};

struct several_files {
  const struct request *first;
  struct request of_format[MOST_FORMATS]; /* one for all files of a format; without names: there are none */
  file_function *run;
  struct in_order loop;
  struct file *file; /* [slots] */
  int taken;
  int given;
  bool any;                  /* was printed */
  struct text_buffer header; /* of the table of --csv, which all share */
  struct progress progress;
  int exit_status;
};

/* The length of a table's first row, its line end included. A line end in quotes is part of a field. */
static size_t row_length(const char *text, size_t length) {
  bool quoted = false;
  for (size_t at = 0; at < length; ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (text[at] == '\n' && !quoted) return at + 1;
  }
  return length;
}

/* Whether a table has the titles of the first one, which it has if it is that. */
static bool has_titles(struct several_files *several, const struct request *request, const char *titles, size_t length,
                       struct failure *failure) {
  if (!several->any) text_buffer_append(&several->header, titles, length);
  if (several->header.out_of_memory) return failure_of_memory(failure);
  if (length == several->header.length && memcmp(titles, several->header.text, length) == 0) return true;
  failure->file = request->file;
  return failure_in_input(failure, 0, "its table has other columns than that of the first file");
}

/* The data of all files: those of a request that has radii to tell, if there is one. */
static void add_heading(const struct several_files *several, struct text_buffer *out) {
  const struct request *shown = NULL;
  struct files_among files = {several->first->names[0], .one_unit = true};
  for (size_t i = 0; i < MOST_FORMATS; ++i) {
    const struct request *const request = &several->of_format[i];
    if (request->format == NULL) continue;
    if (shown != NULL && strcmp(request->format->unit, shown->format->unit) != 0) files.one_unit = false;
    if (file_format_has(request->format, FILE_RADII)) files.own_radii = true;
    if (shown == NULL || file_format_has(shown->format, FILE_RADII)) shown = request;
  }
  rows_heading(out, shown, &files);
}

/* The one row of a table for persons, with the file's name behind it. */
static bool add_row(struct several_files *several, const struct request *request, const struct text_buffer *record,
                    struct text_buffer *out, struct failure *failure) {
  const size_t titles = row_length(record->text, record->length);
  if (!has_titles(several, request, record->text, titles, failure)) return false;
  if (!several->any) {
    add_heading(several, out);
    text_buffer_append(out, record->text, titles - 1);
    text_buffer_add_text(out, "  file\n");
  }
  text_buffer_append(out, record->text + titles, record->length - titles - 1);
  text_buffer_add_text(out, "  ");
  report_file_name(out, input_name(request->file));
  text_buffer_add_text(out, "\n");
  return true;
}

/* The rows of a table with the file's name before each; its header only if it is the first one. */
static bool add_table(struct several_files *several, const struct request *request, const struct text_buffer *record,
                      struct text_buffer *out, struct failure *failure) {
  size_t at = row_length(record->text, record->length);
  if (!has_titles(several, request, record->text, at, failure)) return false;
  if (!several->any) {
    text_buffer_add(out, "file,");
    text_buffer_append(out, record->text, at);
  }
  while (at < record->length) {
    const size_t length = row_length(record->text + at, record->length - at);
    csv_text(out, request->file);
    text_buffer_add(out, ",");
    text_buffer_append(out, record->text + at, length);
    at += length;
  }
  return true;
}

/* False: it cannot be printed, or its table has other columns than the first one. */
static bool print(struct several_files *several, const struct request *request, const struct text_buffer *record,
                  struct failure *failure) {
  if (record->out_of_memory) return failure_of_memory(failure);
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  bool done = true;
  if (request->rows == ROWS_FOR_PERSONS) {
    done = add_row(several, request, record, &out, failure);
  } else if (request->csv || request->rows == ROWS_OF_CSV) {
    done = add_table(several, request, record, &out, failure);
  } else {
    if (several->any && !request->json) text_buffer_add(&out, "\n");
    text_buffer_append(&out, record->text, record->length);
  }
  if (done) {
    several->any = true;
    done = text_buffer_print(&out, failure);
  }
  text_buffer_free(&out);
  return done;
}

/* The request for files of its format; NULL with the reason: its name says none. The last one is for standard input
 * without --format, which no request can be made for. */
static struct request *request_of(struct several_files *several, const char *name, struct failure *failure) {
  const struct request *const first = several->first;
  if (!first->format_given && input_is_standard(name)) return &several->of_format[MOST_FORMATS - 1];
  const struct file_format *const format = first->format_given ? first->format : file_format_of(name, failure);
  size_t i = 0;
  if (format == NULL) return NULL;
  while (file_format_at(i) != format) ++i;
  return &several->of_format[i];
}

/* Find fault with the command line, for files of each format that there are. */
static bool make_requests(struct several_files *several, int count, char **arguments, struct failure *failure) {
  const struct request *const first = several->first;
  for (int k = 0; k < first->files; ++k) {
    struct request *const request = request_of(several, first->names[k], failure);
    if (request == NULL || request->names != NULL) continue;
    if (!request_parse(request, first->command, k, count, arguments, failure)) return false;
  }
  return true;
}

static uint64_t memory_of(const char *name) {
  struct stat found;
  if (input_is_standard(name) || stat(name, &found) != 0 || !S_ISREG(found.st_mode) || found.st_size < 0) return 0;
  return MEMORY_OF_BYTE * (uint64_t)found.st_size;
}

static bool take_file(void *of, uint32_t slot, uint64_t *weight) {
  struct several_files *const several = of;
  struct file *const file = &several->file[slot];
  if (several->taken == several->first->files) return false;
  file->name = several->first->names[several->taken++];
  file->failure = (struct failure)FAILURE_NONE;
  file->request = request_of(several, file->name, &file->failure);
  file->out.length = 0;
  if (several->loop.workers > 1) *weight = memory_of(file->name);
  return true;
}

static void work_on_file(void *of, uint32_t worker, uint32_t slot) {
  const struct several_files *const several = of;
  struct file *const file = &several->file[slot];
  (void)worker;
  file->done = false;
  file->notes = (struct notes)NOTES_NONE;
  if (file->request == NULL) return;
  struct request own = *file->request;
  own.file = file->name;
  file->done =
      several->run(&own, request_threads(&own) / several->loop.workers, &file->notes, &file->out, &file->failure);
}

static void show_files(const struct several_files *several) {
  char text[60];
  snprintf(text, sizeof text, "file %d of %d", several->given, several->first->files);
  progress_show(&several->progress, text);
}

static bool print_file(void *of, uint32_t slot) {
  struct several_files *const several = of;
  struct file *const file = &several->file[slot];
  ++several->given;
  progress_end(&several->progress);
  if (file->done) {
    struct request own = *file->request;
    own.file = file->name;
    notes_print(&file->notes, &own);
    file->done = print(several, &own, &file->out, &file->failure);
  }
  notes_free(&file->notes);
  if (!file->done && stopping_asked()) return false;
  if (!file->done) {
    failure_print(&file->failure);
    several->exit_status = file->failure.exit_status;
    if (file->failure.file == NULL) return false; /* it is standard output that fails, or memory */
  }
  show_files(several);
  return true;
}

bool several_files_run(const struct request *first, int count, char **arguments, file_function *run,
                       struct failure *failure) {
  const uint32_t files = (uint32_t)first->files, threads = request_threads(first);
  struct several_files several = {.first = first, .run = run};
  struct in_order *const loop = &several.loop;
  *loop = (struct in_order){&several,  threads < files ? threads : files, 0, MOST_MEMORY, take_file, work_on_file,
                            print_file};
  loop->slots = loop->workers == 1 ? 1 : SLOTS_OF_WORKER * loop->workers;
  bool done = make_requests(&several, count, arguments, failure);
  several.file = done ? calloc(loop->slots, sizeof *several.file) : NULL;
  if (done && several.file == NULL) done = failure_of_memory(failure);
  if (done) {
    several.progress = progress_begin(files, WATCHED_FILES);
    if (loop->workers > 1) progress_be_quiet();
    const bool enough = in_order_run(loop);
    progress_end(&several.progress);
    *failure = (struct failure)FAILURE_NONE;
    failure->exit_status = several.exit_status;
    done = (enough || failure_of_memory(failure)) && !stopping_asked();
  }
  for (uint32_t k = 0; several.file != NULL && k < loop->slots; ++k) {
    text_buffer_free(&several.file[k].out);
    notes_free(&several.file[k].notes);
  }
  for (size_t i = 0; i < MOST_FORMATS; ++i) request_free(&several.of_format[i]);
  text_buffer_free(&several.header);
  free(several.file);
  return done;
}
