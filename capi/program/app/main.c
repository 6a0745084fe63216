/* The program hardsphere: molecule files in, exact geometry out, over the library's C interface alone.
 * Results are gathered first and printed last, so that stdout has nothing of a file that fails, and of a trajectory
 * nothing of a frame that fails. */
#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#endif
#include <string.h>

#include "app/arguments.h"
#include "app/command_table.h"
#include "app/completion.h"
#include "app/many_molecules.h"
#include "app/molecule_run.h"
#include "app/notes.h"
#include "app/several_files.h"
#include "app/suggestion.h"
#include "app/usage.h"
#include "commands/command_frames.h"
#include "commands/commands.h"
#include "commands/measure_mean.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/line_reader.h"
#include "read/radii_list.h"
#include "read/read_molecule.h"
#include "read/stopping.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

/* Read the file of a request and do what it asks for, by that many threads. */
static bool run_command(const struct request *request, uint32_t threads, struct notes *notes, struct text_buffer *out,
                        struct failure *failure) {
  const struct command_row *const row = &command_table[request->command];
  struct molecule molecule;
  const bool again = request->measure.pdb_out != NULL && input_is_standard(request->file);
  if (again && !line_reader_keep_standard_input(failure)) return false;
  bool done =
      read_molecule(request->file, request->format, &request->choice, molecule_keeping(request), &molecule, failure) &&
      molecule_prepare(request, &molecule, notes, failure);
  if (done && request->trajectory != NULL) {
    const struct frame_work work = {.command = row->run};
    command_of_run *const run = request->measure.mean ? measure_mean : row->of_run;
    double *const rounding = &notes->largest_rounding;
    done = run != NULL ? run(request, &molecule, out, rounding, failure)
                       : command_frames(request, &molecule, &work, rounding, failure);
    if (done) notes_look_at_result(notes, request, &molecule);
  } else if (done) {
    struct geometry geometry = {.work = {0}};
    geometry.progress = progress_begin(molecule.atoms, PROGRESS_LEAST_BALLS);
    out->threads = threads;
    done = molecule_run(request, threads, &molecule, &geometry, notes, out, failure);
    notes->labels = geometry.labels;
    notes->labels_left_out = geometry.labels_left_out;
    notes->largest_rounding = geometry.largest_rounding;
    geometry_free(&geometry);
  }
  molecule_free(&molecule);
  return done;
}

static bool run_one(const struct request *request, struct text_buffer *out, struct failure *failure) {
  struct notes notes = NOTES_NONE;
  const bool done = run_command(request, request_threads(request), &notes, out, failure);
  if (done) notes_print(&notes, request);
  notes_free(&notes);
  return done;
}

/* Two files: the molecule at rest and the one that is moved. */
static bool run_two(enum command command, int count, char **arguments, struct text_buffer *out,
                    struct failure *failure) {
  struct request request[2];
  struct molecule molecule[2];
  struct notes notes[2] = {NOTES_NONE, NOTES_NONE};
  memset(request, 0, sizeof request);
  memset(molecule, 0, sizeof molecule);
  bool done = true;
  for (int k = 0; k < 2 && done; ++k) {
    done = request_parse(&request[k], command, k, count, arguments, failure);
    if (request[0].list_radii) break;
  }
  stopping_after(request[0].timeout);
  if (done && request[0].list_radii) {
    done = radii_list_print(out, failure);
  } else {
    for (int k = 0; k < 2 && done; ++k) {
      done = read_molecule(request[k].file, request[k].format, &request[k].choice, molecule_keeping(&request[k]),
                           &molecule[k], failure) &&
             molecule_prepare(&request[k], &molecule[k], &notes[k], failure);
    }
    const struct molecule_request fixed = {&request[0], &molecule[0], &notes[0].largest_rounding},
                                  moving = {&request[1], &molecule[1], &notes[1].largest_rounding};
    done = done && command_table[command].run_two(&fixed, &moving, out, failure);
  }
  for (int k = 0; k < 2; ++k) {
    if (done && !request[0].list_radii) {
      notes_look_at_result(&notes[k], &request[k], &molecule[k]);
      notes_print(&notes[k], &request[k]);
    }
    notes_free(&notes[k]);
    molecule_free(&molecule[k]);
    request_free(&request[k]);
  }
  return done;
}

/* Whether an option that any command has stands among the arguments. */
static bool asks_for(const char *name, const char *letter, int count, char **arguments) {
  for (int i = 0; i < count && strcmp(arguments[i], "--") != 0; ++i) {
    if (strcmp(arguments[i], name) == 0 || strcmp(arguments[i], letter) == 0) return true;
  }
  return false;
}

static bool find_command(const char *name, enum command *command, struct failure *failure) {
  if (command_find(name, command)) return true;
  char shown[EXCERPT_BYTES];
  const char *suggestion = suggest_command(name);
  return failure_in_usage(failure, "unknown command '%s';%s%s%s see hardsphere --help",
                          excerpt(shown, name, strlen(name)), suggestion != NULL ? " did you mean " : "",
                          suggestion != NULL ? suggestion : "", suggestion != NULL ? "?" : "");
}

/* help, help COMMAND. */
static bool print_help(int count, char **arguments, struct text_buffer *out, struct failure *failure) {
  enum command command;
  if (count == 1) {
    usage_of_program(out);
    return true;
  }
  if (count > 2) return failure_in_usage(failure, "%s takes one command", arguments[0]);
  if (!find_command(arguments[1], &command, failure)) return false;
  usage_of_command(out, command);
  return true;
}

static bool run(int count, char **arguments, struct text_buffer *out, struct failure *failure) {
  if (count < 1) return failure_in_usage(failure, "no command is given; see hardsphere --help");
  const char *first = arguments[0];
  if (strcmp(first, "--help") == 0 || strcmp(first, "-h") == 0 || strcmp(first, "help") == 0) {
    return print_help(count, arguments, out, failure);
  }
  if (strcmp(first, "--version") == 0 || strcmp(first, "-V") == 0) {
    if (count > 1) return failure_in_usage(failure, "%s stands alone", first);
    usage_version(out);
    return true;
  }
  if (strcmp(first, "completion") == 0) {
    if (count == 2 && completion_of_shell(arguments[1], out)) return true;
    return failure_in_usage(failure, "completion is of a shell: bash or zsh");
  }
  if ((count == 1 && strcmp(first, "--radii=list") == 0) || (count == 2 && strcmp(first, "--radii") == 0)) {
    if (count == 1 || strcmp(arguments[1], "list") == 0) return radii_list_print(out, failure);
  }
  enum command command;
  if (!find_command(first, &command, failure)) return false;
  if (asks_for("--help", "-h", count - 1, arguments + 1)) {
    usage_of_command(out, command);
    return true;
  }
  if (asks_for("--version", "-V", count - 1, arguments + 1)) {
    usage_version(out);
    return true;
  }
  const struct command_row *row = &command_table[command];
  if (!part_is_there(row->part, command, NULL, failure)) return false;
  if (row->run_two != NULL) return run_two(command, count - 1, arguments + 1, out, failure);
  struct request request;
  bool done = request_parse(&request, command, 0, count - 1, arguments + 1, failure);
  stopping_after(request.timeout);
  if (request.list_radii) {
    done = done && radii_list_print(out, failure);
  } else if (request.models == MODELS_EACH) {
    done = done && many_molecules_run(&request, failure);
  } else if (request.files < 2 && request.rows == ROWS_NONE) {
    done = done && run_one(&request, out, failure);
  } else if (done || failure->file == request.file) { /* else the command line is at fault */
    done = several_files_run(&request, count - 1, arguments + 1, run_command, failure);
  }
  request_free(&request);
  return done;
}

int main(int count, char **arguments) {
  struct failure failure = FAILURE_NONE;
  struct text_buffer out = TEXT_BUFFER_EMPTY;
#if defined(_WIN32)
  /* The bytes of a file are those that are written and read, here as elsewhere. */
  _setmode(_fileno(stdin), _O_BINARY);
  _setmode(_fileno(stdout), _O_BINARY);
#endif
  stopping_by_interrupt();
  const bool done = run(count > 0 ? count - 1 : 0, arguments + 1, &out, &failure) && !stopping_asked() &&
                    text_buffer_print(&out, &failure) && output_files_keep(&failure);
  text_buffer_free(&out);
  if (!done && stopping_asked()) stopping_is_why(&failure);
  if (!done) failure_print(&failure);
  output_files_drop();
  return failure.exit_status;
}
