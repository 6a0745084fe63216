#include "app/arguments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/command_table.h"
#include "app/option.h"
#include "app/request_check.h"
#include "app/suggestion.h"
#include "hardsphere.h"
#include "read/number.h"
#include "read/read_molecule.h"

static bool apply_override(struct reading *reading, const char *text, size_t length) {
  char shown[EXCERPT_BYTES];
  const char *equals = memchr(text, '=', length);
  if (equals == NULL) {
    return failure_in_usage(reading->failure, "--radius: '%s' is not of the form EL=R", excerpt(shown, text, length));
  }
  const size_t name_length = (size_t)(equals - text);
  const size_t number_length = length - name_length - 1;
  struct element_symbol symbol;
  if (!element_symbol_parse(text, name_length, &symbol)) {
    return failure_in_usage(reading->failure, "--radius: '%s' is not an element symbol",
                            excerpt(shown, text, name_length));
  }
  double radius;
  const enum number_status status = number_parse(equals + 1, number_length, &radius);
  if (status != NUMBER_OK) {
    return failure_in_usage(reading->failure, "--radius: '%s' %s", excerpt(shown, equals + 1, number_length),
                            number_complaint(status));
  }
  if (radius < 0.0) {
    return failure_in_usage(reading->failure, "--radius: the radius of '%s' must not be negative", symbol.text);
  }
  radii_put(&reading->request->radii, symbol, radius);
  return true;
}

static bool apply_overrides(struct reading *reading) {
  radii_take_set(&reading->request->radii, reading->request->set);
  if (!reading->radius_seen) return true;
  const char *text = reading->request->overrides.text;
  for (;;) {
    const size_t length = strcspn(text, ",");
    if (!apply_override(reading, text, length)) return false;
    if (text[length] == '\0') return true;
    text += length + 1;
  }
}

/* Get the radii by residue and atom, if any are asked for. */
static bool load_table(struct reading *reading) {
  struct request *request = reading->request;
  const uint32_t residues = radii_set_residues(request->set);
  if (request->radii_file == NULL && residues == HSP_NONE) return true;
  if (!file_format_has(request->format, FILE_RESIDUES)) {
    return failure_in_usage(reading->failure,
                            "--radii by residue and atom has no use here: the file names no residues");
  }
  if (request->radii_file != NULL) return radii_table_read(&request->table, request->radii_file, reading->failure);
  return radii_table_make(&request->table, residues, reading->failure);
}

static bool take_argument(struct reading *reading, const char *argument) {
  const enum command command = reading->request->command;
  const char *value = NULL;
  const struct option *option = option_find(command, argument, &value);
  if (option != NULL && !part_is_there(option->part, command, option->name, reading->failure)) return false;
  if (option != NULL) return option->take(reading, option, value);
  char shown[EXCERPT_BYTES], suggestion[SUGGESTION_BYTES];
  return failure_in_usage(reading->failure, "unknown option '%s';%s see hardsphere %s --help",
                          excerpt(shown, argument, strlen(argument)), suggest_option(command, argument, suggestion),
                          command_table[command].name);
}

/* The format of the input: the user's choice, or that of the file's name. */
static bool find_format(struct reading *reading) {
  struct request *request = reading->request;
  if (request->format != NULL) return true;
  if (!input_is_standard(request->file)) {
    request->format = file_format_of(request->file, reading->failure);
    return request->format != NULL;
  }
  return failure_in_usage(reading->failure, "standard input has no extension: --format says what it is");
}

static bool check(struct reading *reading) {
  struct request *request = reading->request;
  char list[FORMAT_LIST_BYTES];
  if (request->list_radii) return true;
  if (request->file == NULL) {
    return failure_in_usage(reading->failure, "no file is given; see hardsphere %s --help",
                            command_table[request->command].name);
  }
  if (request->command == COMMAND_QUERY && request->query.kind == QUERY_NONE) {
    return failure_in_usage(reading->failure,
                            "query needs --point X Y Z or --ball X Y Z R; see hardsphere query --help");
  }
  if (request->command == COMMAND_PICK && !request->pick.at.given) {
    return failure_in_usage(reading->failure, "pick needs --at X Y; see hardsphere pick --help");
  }
  if (request->command == COMMAND_PATH && !(request->path.from.point.given && request->path.to.point.given)) {
    return failure_in_usage(reading->failure, "path needs --from X Y Z and --to X Y Z; see hardsphere path --help");
  }
  if (request->command == COMMAND_GATE && !request->gate.from.point.given) {
    return failure_in_usage(reading->failure, "gate needs --from X Y Z or --from void:K; see hardsphere gate --help");
  }
  if (request->command == COMMAND_GATE && reading->probe_seen && request->gate.from.of_void == 0 &&
      request->gate.to.of_void == 0) {
    return failure_in_usage(reading->failure, "gate finds the probe: --probe is for --from void:K alone");
  }
  if (request->model_given && request->models > 0) {
    return failure_in_usage(reading->failure, "--model is one of them, --models %s all: either the one or the other",
                            request->models == MODELS_EACH ? "all" : "merged");
  }
  if (!request_check_several(request, reading->failure) || !request_check_inputs(request, reading->failure) ||
      !find_format(reading)) {
    return false;
  }
  if (file_format_has(request->format, FILE_RADII) && (reading->radii_seen || reading->radius_seen)) {
    return failure_in_usage(reading->failure, "%s has no use here: %s files bring their own radii",
                            reading->radii_seen ? "--radii" : "--radius",
                            file_format_list(list, ".", "and", FILE_RADII, true));
  }
  if (request->index_file != NULL && !index_file_read(&request->index, request->index_file, reading->failure)) {
    return false;
  }
  if (!request_check(request, reading->failure)) return false;
  return apply_overrides(reading) && load_table(reading);
}

/* Read all arguments; number `file` of the files becomes that of the request. */
static bool read_arguments(struct reading *reading, int file) {
  struct request *const request = reading->request;
  bool options_end = false;
  bool standard_seen = false;
  const char *argument;
  while ((argument = option_next(reading)) != NULL) {
    if (!options_end && strcmp(argument, "--") == 0) {
      options_end = true;
    } else if (!options_end && argument[0] == '-' && argument[1] != '\0') {
      if (!take_argument(reading, argument)) return false;
    } else {
      if (input_is_standard(argument)) {
        if (standard_seen) return failure_in_usage(reading->failure, "standard input is one file, not two");
        standard_seen = true;
      }
      if (request->files == file) request->file = argument;
      request->names[request->files++] = argument;
    }
  }
  return true;
}

/* Begin with a request without any option. */
static bool begin(struct reading *reading, struct request *request, enum command command, int count, char **arguments,
                  struct failure *failure) {
  *reading = (struct reading){.request = request, .rest = arguments, .left = count, .failure = failure};
  memset(request, 0, sizeof *request);
  request->command = command;
  request->choice = (struct file_choice)FILE_CHOICE_FIRST;
  request->frames = (struct frame_range)FRAME_RANGE_ALL;
  request->selection = (struct selection)SELECTION_EVERYTHING;
  request->measure.part = (struct selection)SELECTION_EVERYTHING;
  request->set = &radii_bondi;
  request->timeout = -1.0;
  request->measure.surface = -1;
  request->hessian = (struct hessian_request){HUGE_VAL, HUGE_VAL};
  request->pores.pockets = -1.0;
  request->meshing = (struct meshing)MESHING_DEFAULT;
  request->drawing = (struct drawing)DRAWING_DEFAULT;
  request->names = malloc(((size_t)count + 1) * sizeof *request->names);
  return request->names != NULL || failure_of_memory(failure);
}

bool request_parse(struct request *request, enum command command, int file, int count, char **arguments,
                   struct failure *failure) {
  struct reading reading;
  return begin(&reading, request, command, count, arguments, failure) && read_arguments(&reading, file) &&
         check(&reading);
}

bool request_read(struct request *request, enum command command, int count, char **arguments, struct failure *failure) {
  struct reading reading;
  return begin(&reading, request, command, count, arguments, failure) && read_arguments(&reading, 0);
}
