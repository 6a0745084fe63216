#include "app/arguments.h"

#include <string.h>

#include "app/option_reader.h"
#include "app/request_check.h"
#include "app/suggestion.h"
#include "commands/interface.h"
#include "read/number.h"
#include "read/read_molecule.h"

struct reading {
  struct request *request;
  int wanted_file;
  struct option_reader options;
  bool probe_seen;
  bool radii_seen;
  bool radius_seen;
  bool model_seen;
  bool standard_seen; /* among the files */
  struct failure *failure;
};

const char *command_name(enum command command) {
  static const char *const names[] = {
      [COMMAND_MODEL] = "model",     [COMMAND_BOUNDARY] = "boundary", [COMMAND_MEASURE] = "measure",
      [COMMAND_QUERY] = "query",     [COMMAND_VOIDS] = "voids",       [COMMAND_CONTACTS] = "contacts",
      [COMMAND_COMPLEX] = "complex", [COMMAND_CELLS] = "cells",       [COMMAND_PATH] = "path",
      [COMMAND_GATE] = "gate",       [COMMAND_CLASH] = "clash",       [COMMAND_MESH] = "mesh",
      [COMMAND_MAP] = "map",         [COMMAND_PICK] = "pick",         [COMMAND_DRAW] = "draw"};
  return names[command];
}

bool command_find(const char *name, enum command *command) {
  for (int each = 0; each <= COMMAND_DRAW; ++each) {
    if (strcmp(name, command_name((enum command)each)) != 0) continue;
    *command = (enum command)each;
    return true;
  }
  return false;
}

static bool take_probe(struct reading *reading, const char *value) {
  if (!option_value(&reading->options, "--probe", &value, "a length")) return false;
  if (reading->probe_seen) return failure_in_usage(reading->failure, "--probe is given twice");
  reading->probe_seen = true;
  return option_length(&reading->options, "--probe", value, &reading->request->probe);
}

static bool take_radii(struct reading *reading, const char *value) {
  if (!option_value(&reading->options, "--radii", &value, "a set, a file or 'list'")) return false;
  if (reading->radii_seen) return failure_in_usage(reading->failure, "--radii is given twice");
  reading->radii_seen = true;
  const struct radii_set *set = radii_set_find(value);
  if (set != NULL) {
    reading->request->set = set;
  } else if (strcmp(value, "list") == 0) {
    reading->request->list_radii = true;
  } else if (strpbrk(value, "./") != NULL) { /* the name of a set has neither */
    reading->request->radii_file = value;
  } else {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(reading->failure,
                            "--radii: no set '%s'; there are bondi, chem3d, protor, naccess, and files with a dot or "
                            "slash in their names",
                            excerpt(shown, value, strlen(value)));
  }
  return true;
}

/* Gather the text of --radius; it is applied by apply_overrides when the set is known. */
static bool take_radius(struct reading *reading, const char *value) {
  if (!option_value(&reading->options, "--radius", &value, "EL=R, for instance ZN=1.39")) return false;
  struct text_buffer *overrides = &reading->request->overrides;
  text_buffer_add(overrides, "%s%s", reading->radius_seen ? "," : "", value);
  if (overrides->out_of_memory) return failure_of_memory(reading->failure);
  reading->radius_seen = true;
  return true;
}

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
  const struct radii_rule *rules = radii_set_rules(request->set);
  if (request->radii_file == NULL && rules == NULL) return true;
  if (!file_format_has(request->format, FILE_RESIDUES)) {
    return failure_in_usage(reading->failure,
                            "--radii by residue and atom has no use here: the file names no residues");
  }
  if (request->radii_file != NULL) return radii_table_read(&request->table, request->radii_file, reading->failure);
  return radii_table_make(&request->table, rules, reading->failure);
}

static bool take_query(struct reading *reading, enum query_kind kind, const char *value) {
  struct request *request = reading->request;
  const char *option = kind == QUERY_POINT ? "--point" : "--ball";
  if (request->query != QUERY_NONE) {
    return failure_in_usage(reading->failure, "one query at a time: either --point X Y Z or --ball X Y Z R");
  }
  request->query = kind;
  double numbers[4] = {0};
  if (!option_numbers(&reading->options, option, value, kind == QUERY_POINT ? "XYZ" : "XYZR", numbers)) return false;
  memcpy(request->position, numbers, sizeof request->position);
  request->query_radius = numbers[3];
  if (request->query_radius < 0.0) return failure_in_usage(reading->failure, "--ball: R must not be negative");
  return true;
}

static bool take_at(struct reading *reading, const char *value) {
  struct option_vector *at = &reading->request->at;
  if (at->given) return failure_in_usage(reading->failure, "--at is given twice");
  at->given = true;
  return option_numbers(&reading->options, "--at", value, "XY", at->xyz);
}

/* X Y Z, or of `gate` void:K. */
static bool take_place(struct reading *reading, const char *option, const char *value, struct place *place) {
  static const char word[] = "void:";
  const struct option_reader *options = &reading->options;
  const char *text = value != NULL ? value : options->left > 0 ? options->rest[0] : "";
  if (reading->request->command != COMMAND_GATE || strncmp(text, word, strlen(word)) != 0) {
    return option_vector(&reading->options, option, value, false, &place->point);
  }
  if (value == NULL) option_next(&reading->options);
  if (place->point.given) return failure_in_usage(reading->failure, "%s is given twice", option);
  place->point.given = true;
  const char *rank = text + strlen(word);
  if (number_parse_count(rank, strlen(rank), &place->of_void) == NUMBER_OK && place->of_void > 0) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "%s: '%s' is not the number of a void, from 1 on", option,
                          excerpt(shown, rank, strlen(rank)));
}

static bool take_format(struct reading *reading, const char *value) {
  char list[FORMAT_LIST_BYTES];
  file_format_list(list, "", "or", 0, true);
  if (!option_value(&reading->options, "--format", &value, list)) return false;
  if (reading->request->format != NULL) return failure_in_usage(reading->failure, "--format is given twice");
  reading->request->format = file_format_named(value);
  if (reading->request->format != NULL) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "--format: '%s' is not %s", excerpt(shown, value, strlen(value)), list);
}

/* An option with the name of a file. */
static bool take_path(struct reading *reading, const char *option, const char *value, const char **path) {
  if (value == NULL) value = option_next(&reading->options);
  if (value == NULL || value[0] == '\0') return failure_in_usage(reading->failure, "%s needs a file", option);
  if (*path != NULL) return failure_in_usage(reading->failure, "%s is given twice", option);
  *path = value;
  return true;
}

static bool take_grouping(struct reading *reading, const char *value) {
  if (!option_value(&reading->options, "--by", &value, "residue or chain")) return false;
  if (reading->request->by != GROUPING_NONE) return failure_in_usage(reading->failure, "--by is given twice");
  if (strcmp(value, "residue") == 0) {
    reading->request->by = GROUPING_RESIDUE;
  } else if (strcmp(value, "chain") == 0) {
    reading->request->by = GROUPING_CHAIN;
  } else {
    char shown[EXCERPT_BYTES];
    return failure_in_usage(reading->failure, "--by: '%s' is neither residue nor chain",
                            excerpt(shown, value, strlen(value)));
  }
  return true;
}

static bool take_surface(struct reading *reading, const char *value) {
  struct request *request = reading->request;
  if (!option_value(&reading->options, "--surface", &value, "sas or ses")) return false;
  if (request->surface_seen) return failure_in_usage(reading->failure, "--surface is given twice");
  request->surface_seen = true;
  request->excluded_surface = strcmp(value, "ses") == 0;
  if (request->excluded_surface || strcmp(value, "sas") == 0) return true;
  char shown[EXCERPT_BYTES];
  return failure_in_usage(reading->failure, "--surface: '%s' is neither sas nor ses",
                          excerpt(shown, value, strlen(value)));
}

/* The options of `measure` alone; *known tells whether it is one of them. */
static bool take_measure_option(struct reading *reading, const char *argument, bool *known) {
  struct request *request = reading->request;
  const char *value = NULL;
  *known = true;
  bool *flag = NULL;
  if (strcmp(argument, "--per-ball") == 0) flag = &request->per_ball;
  if (strcmp(argument, "--gradient") == 0) flag = &request->gradient;
  if (strcmp(argument, "--curvature") == 0) flag = &request->curvature;
  if (strcmp(argument, "--polar") == 0) flag = &request->polar;
  if (strcmp(argument, "--relative") == 0) flag = &request->relative;
  if (strcmp(argument, "--outer") == 0) flag = &request->outer;
  if (flag != NULL) {
    *flag = true;
    return true;
  }
  if (option_is(argument, "--by", &value)) return take_grouping(reading, value);
  if (option_is(argument, "--surface", &value)) return take_surface(reading, value);
  if (option_is(argument, "--interface", &value)) {
    if (!option_value(&reading->options, "--interface", &value, "two groups of chains: A,B or A+B,C")) return false;
    if (request->interface != NULL) return failure_in_usage(reading->failure, "--interface is given twice");
    request->interface = value;
    return interface_parse(value, reading->failure);
  }
  if (option_is(argument, "--weights", &value)) return take_path(reading, "--weights", value, &request->weights);
  if (option_is(argument, "--pdb-out", &value)) return take_path(reading, "--pdb-out", value, &request->pdb_out);
  *known = false;
  return true;
}

/* The options that say which atoms are read; *known tells whether it is one of them. */
static bool take_selection_option(struct reading *reading, const char *argument, bool *known) {
  struct selection *selection = &reading->request->selection;
  static const char *const flags[][2] = {
      {"--no-water", "water"}, {"--no-hetatm", "hetatm"}, {"--no-hydrogens", "hydrogen"}};
  static const char *const options[] = {"--only", "--hide"};
  const char *value = NULL;
  *known = true;
  for (size_t i = 0; i < sizeof flags / sizeof flags[0]; ++i) {
    if (strcmp(argument, flags[i][0]) == 0) {
      return selection_add(selection, flags[i][0], flags[i][1], true, reading->failure);
    }
  }
  for (int i = 0; i < 2; ++i) {
    if (!option_is(argument, options[i], &value)) continue;
    return option_value(&reading->options, options[i], &value, "atoms, for instance chain:A,B or residue:HOH") &&
           selection_add(selection, options[i], value, i == 1, reading->failure);
  }
  if (option_is(argument, "--model", &value)) {
    if (!option_value(&reading->options, "--model", &value, "the number of a model, from 1 on")) return false;
    if (reading->model_seen) return failure_in_usage(reading->failure, "--model is given twice");
    reading->model_seen = true;
    uint64_t *model = &reading->request->model;
    if (number_parse_count(value, strlen(value), model) == NUMBER_OK && *model > 0) return true;
    char shown[EXCERPT_BYTES];
    return failure_in_usage(reading->failure, "--model: '%s' is not the number of a model, from 1 on",
                            excerpt(shown, value, strlen(value)));
  }
  *known = false;
  return true;
}

/* The options of commands that go through trajectories; *known tells whether it is one of them. */
static bool take_trajectory_option(struct reading *reading, const char *argument, bool *known) {
  struct request *request = reading->request;
  const char *value = NULL;
  *known = true;
  if (option_is(argument, "--trajectory", &value)) {
    return take_path(reading, "--trajectory", value, &request->trajectory);
  }
  if (option_is(argument, "--frames", &value)) {
    if (!option_value(&reading->options, "--frames", &value, "frames, A:B:S")) return false;
    if (request->frames_given) return failure_in_usage(reading->failure, "--frames is given twice");
    request->frames_given = true;
    return frame_range_parse(&request->frames, value, reading->failure);
  }
  *known = false;
  return true;
}

static bool take_file(struct reading *reading, const char *argument) {
  struct request *request = reading->request;
  if (input_is_standard(argument)) {
    if (reading->standard_seen) return failure_in_usage(reading->failure, "standard input is one file, not two");
    reading->standard_seen = true;
  }
  if (request->files == reading->wanted_file) request->file = argument;
  ++request->files;
  return true;
}

static bool take_argument(struct reading *reading, const char *argument) {
  struct request *request = reading->request;
  const char *value = NULL;
  if (argument[0] != '-' || argument[1] == '\0') return take_file(reading, argument);
  if (strcmp(argument, "--json") == 0) {
    request->json = true;
    return true;
  }
  if (option_is(argument, "--format", &value)) return take_format(reading, value);
  if (option_is(argument, "--probe", &value)) return take_probe(reading, value);
  if (option_is(argument, "--radii", &value)) return take_radii(reading, value);
  if (option_is(argument, "--radius", &value)) return take_radius(reading, value);
  bool known = false;
  if (!take_selection_option(reading, argument, &known)) return false;
  if (known) return true;
  const bool lists = request->command == COMMAND_CONTACTS || request->command == COMMAND_VOIDS ||
                     request->command == COMMAND_BOUNDARY || request->command == COMMAND_MEASURE;
  if (lists && strcmp(argument, "--csv") == 0) {
    request->csv = true;
    return true;
  }
  const bool counts_areas = request->command == COMMAND_MEASURE || request->command == COMMAND_CONTACTS;
  if ((counts_areas || request->command == COMMAND_BOUNDARY) && option_is(argument, "--box", &value)) {
    return box_take_option(&request->box, &reading->options, value);
  }
  if (counts_areas) {
    if (!take_trajectory_option(reading, argument, &known)) return false;
    if (known) return true;
  }
  if (request->command == COMMAND_MEASURE) {
    if (!take_measure_option(reading, argument, &known)) return false;
    if (known) return true;
  }
  if (request->command == COMMAND_MESH) {
    if (!meshing_take_option(&request->meshing, &reading->options, argument, &known)) return false;
    if (known) return true;
  }
  if (request->command == COMMAND_MAP || request->command == COMMAND_PICK || request->command == COMMAND_MESH) {
    if (!viewing_take_option(&request->viewing, &reading->options, argument, &known)) return false;
    if (known) return true;
  }
  if (request->command == COMMAND_MAP && strcmp(argument, "--per-ball") == 0) {
    request->per_ball = true;
    return true;
  }
  if (request->command == COMMAND_PICK && option_is(argument, "--at", &value)) return take_at(reading, value);
  if (request->command == COMMAND_DRAW && option_is(argument, "--highlight", &value)) {
    return option_value(&reading->options, "--highlight", &value, "atoms, for instance chain:A or residue:57,102") &&
           selection_add(&request->highlight, "--highlight", value, false, reading->failure);
  }
  if (request->command == COMMAND_DRAW) {
    if (!drawing_take_option(&request->drawing, &reading->options, argument, &known)) return false;
    if (known) return true;
  }
  if (request->command == COMMAND_CLASH && option_is(argument, "--rotate", &value)) {
    return option_vector(&reading->options, "--rotate", value, false, &request->viewing.rotate);
  }
  if (request->command == COMMAND_CLASH && option_is(argument, "--translate", &value)) {
    return option_vector(&reading->options, "--translate", value, false, &request->translate);
  }
  if (request->command == COMMAND_PATH || request->command == COMMAND_GATE) {
    if (option_is(argument, "--from", &value)) return take_place(reading, "--from", value, &request->from);
    if (option_is(argument, "--to", &value)) return take_place(reading, "--to", value, &request->to);
  }
  if (request->command == COMMAND_BOUNDARY && strcmp(argument, "--shells") == 0) {
    request->shells = true;
    return true;
  }
  if (request->command == COMMAND_VOIDS && strcmp(argument, "--balls") == 0) {
    request->void_balls = true;
    return true;
  }
  if (request->command == COMMAND_VOIDS && option_is(argument, "--min-volume", &value)) {
    return option_value(&reading->options, "--min-volume", &value, "a volume") &&
           option_length(&reading->options, "--min-volume", value, &request->min_volume);
  }
  if (request->command == COMMAND_CONTACTS && strcmp(argument, "--cells") == 0) {
    request->cells = true;
    return true;
  }
  if (request->command == COMMAND_CONTACTS && option_is(argument, "--by", &value)) return take_grouping(reading, value);
  if (request->command == COMMAND_CONTACTS && option_is(argument, "--map", &value)) {
    return take_path(reading, "--map", value, &request->map);
  }
  if (request->command == COMMAND_CONTACTS && option_is(argument, "--least", &value)) {
    return option_value(&reading->options, "--least", &value, "an area") &&
           option_length(&reading->options, "--least", value, &request->least);
  }
  if (request->command == COMMAND_QUERY && option_is(argument, "--point", &value)) {
    return take_query(reading, QUERY_POINT, value);
  }
  if (request->command == COMMAND_QUERY && option_is(argument, "--ball", &value)) {
    return take_query(reading, QUERY_BALL, value);
  }
  char shown[EXCERPT_BYTES], suggestion[SUGGESTION_BYTES];
  return failure_in_usage(reading->failure, "unknown option '%s';%s see hardsphere %s --help",
                          excerpt(shown, argument, strlen(argument)),
                          suggest_option(request->command, argument, suggestion), command_name(request->command));
}

/* The format of what is read: what the user says, or what its name says. */
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
                            command_name(request->command));
  }
  if (request->command == COMMAND_QUERY && request->query == QUERY_NONE) {
    return failure_in_usage(reading->failure, "query needs --point X Y Z or --ball X Y Z R");
  }
  if (request->command == COMMAND_PICK && !request->at.given) {
    return failure_in_usage(reading->failure, "pick needs --at X Y");
  }
  if (request->command == COMMAND_PATH && !(request->from.point.given && request->to.point.given)) {
    return failure_in_usage(reading->failure, "path needs --from X Y Z and --to X Y Z");
  }
  if (request->command == COMMAND_GATE && !request->from.point.given) {
    return failure_in_usage(reading->failure, "gate needs --from X Y Z or --from void:K");
  }
  if (request->command == COMMAND_GATE && reading->probe_seen && request->from.of_void == 0 &&
      request->to.of_void == 0) {
    return failure_in_usage(reading->failure, "gate finds the probe: --probe is for --from void:K alone");
  }
  if (!viewing_check(&request->viewing, reading->failure)) return false;
  if (!request_check_several(request, reading->failure) || !find_format(reading)) return false;
  if (file_format_has(request->format, FILE_RADII) && (reading->radii_seen || reading->radius_seen)) {
    return failure_in_usage(reading->failure, "%s has no use here: %s files bring their own radii",
                            reading->radii_seen ? "--radii" : "--radius",
                            file_format_list(list, ".", "and", FILE_RADII, true));
  }
  if (!request_check(request, reading->failure)) return false;
  return apply_overrides(reading) && load_table(reading);
}

bool request_parse(struct request *request, enum command command, int file, int count, char **arguments,
                   struct failure *failure) {
  memset(request, 0, sizeof *request);
  request->command = command;
  request->model = 1;
  request->frames = (struct frame_range)FRAME_RANGE_ALL;
  request->selection = (struct selection)SELECTION_EVERYTHING;
  request->highlight = (struct selection)SELECTION_EVERYTHING;
  request->set = &radii_bondi;
  request->meshing = (struct meshing)MESHING_DEFAULT;
  request->drawing = (struct drawing)DRAWING_DEFAULT;
  struct reading reading;
  memset(&reading, 0, sizeof reading);
  reading.request = request;
  reading.wanted_file = file;
  reading.options = (struct option_reader){arguments, count, failure};
  reading.failure = failure;
  bool options_end = false;
  for (;;) {
    const char *argument = option_next(&reading.options);
    if (argument == NULL) return check(&reading);
    if (!options_end && strcmp(argument, "--") == 0) {
      options_end = true;
    } else if (!(options_end ? take_file(&reading, argument) : take_argument(&reading, argument))) {
      return false;
    }
  }
}

bool request_wants_balls(const struct request *request) {
  return request->per_ball || request->gradient || (request->csv && request->by == GROUPING_NONE);
}

bool request_wants_areas(const struct request *request) {
  return request_wants_balls(request) || request->by != GROUPING_NONE || request->pdb_out != NULL || request->polar ||
         (request->excluded_surface && request->weights != NULL);
}

void request_free(struct request *request) {
  text_buffer_free(&request->overrides);
  selection_free(&request->selection);
  selection_free(&request->highlight);
  radii_table_free(&request->table);
}
