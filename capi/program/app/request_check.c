#include "app/request_check.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "app/command_table.h"
#include "read/read_molecule.h"
#include "write/output_file.h"

/* An option that asks for a list, which has no place in a row; NULL: none does. */
static const char *list_of(const struct request *request) {
  const struct selection_groups *const interface = &request->measure.interface;
  return request->measure.per_ball                      ? "--per-ball"
         : request->measure.gradient                    ? "--gradient"
         : request->by != GROUPING_NONE                 ? "--by"
         : request->contacts.cells                      ? "--cells"
         : request->contacts.between.text != NULL       ? "--between"
         : interface->chains || interface->count > 2    ? "--interface of more than two groups"
         : request->boundary.shells                     ? "--shells"
         : request->voids.balls || request->pores.balls ? "--balls"
         : request->pores.gates                         ? "--gates"
         : request->map.per_ball                        ? "--per-ball"
                                                        : NULL;
}

/* Check the options of a trajectory; each frame of it has one line. */
static bool check_trajectory(struct request *request, struct failure *failure) {
  char list[FORMAT_LIST_BYTES];
  const char *path = request->trajectory;
  if (path == NULL) {
    const char *const lone = request->frames_given               ? "--frames"
                             : request->measure.mean             ? "--mean"
                             : request->plot != NULL             ? "--plot"
                             : request->frames.begin > -HUGE_VAL ? "--begin"
                             : request->frames.end < HUGE_VAL    ? "--end"
                             : request->frames.interval > 0.0    ? "--interval"
                                                                 : NULL;
    return lone == NULL || failure_in_usage(failure, "%s needs --trajectory", lone);
  }
  if (request->files > 1 && request->command != COMMAND_CLASH) {
    return failure_in_usage(failure, "--trajectory takes one file at a time");
  }
  struct output_choice outputs[MOST_OUTPUTS];
  const int count = request_outputs(request, outputs);
  for (int k = 0; k < count; ++k) {
    if (outputs[k].path == request->plot) continue;
    return failure_in_usage(failure, "%s is not for a --trajectory", outputs[k].option);
  }
  if (request->csv && request->json) return true; /* refused with the options of measure */
  if (request->measure.mean && (request->measure.gradient || request->measure.interface.text != NULL)) {
    return failure_in_usage(failure, "%s has no mean: not with --mean",
                            request->measure.gradient ? "--gradient" : "--interface");
  }
  const char *const longer = list_of(request);
  const bool gates = request->csv && request->pores.gates && !request->pores.balls; /* each frame has a list of them */
  if (longer != NULL && !request->json && !request->measure.mean && !gates) {
    return failure_in_usage(failure, "%s has no place in the one row of a frame: it needs --json", longer);
  }
  const bool lists = request->measure.mean || request->command == COMMAND_VOIDS || request->command == COMMAND_PORES;
  if (!lists) request->csv = false; /* it is the table of frames anyway */
  if (!input_is_standard(path)) return true;
  if (file_format_has(request->format, FILE_FRAMES)) return true;
  return failure_in_usage(failure, "--trajectory from standard input is %s, as FILE is",
                          file_format_list(list, ".", "or", FILE_FRAMES | FILE_ATOMS, true));
}

/* Checks the options of a table with a row for each of several molecules or files. */
static bool check_rows(struct request *request, struct failure *failure) {
  char list[FORMAT_LIST_BYTES];
  struct output_choice outputs[MOST_OUTPUTS];
  const bool each = request->models == MODELS_EACH;
  if (!each && !request->rows_given) return true;
  const char *const option = each ? "--models all" : "--rows";
  const enum command command = request->command;
  if (command == COMMAND_CLASH || command == COMMAND_MESH || command == COMMAND_DRAW ||
      (command == COMMAND_HESSIAN && !(each && request->json))) {
    return failure_in_usage(failure, "%s is not for %s%s", option, command_table[command].name,
                            command == COMMAND_HESSIAN && each ? " but with --json" : "");
  }
  if (each && !file_format_has(request->format, FILE_MOLECULES)) {
    return failure_in_usage(failure, "--models all has no use here: it is for %s files",
                            file_format_list(list, ".", "and", FILE_MOLECULES, true));
  }
  if (!each && request->json)
    return failure_in_usage(failure, "--rows are of a table: --json has a line for each file");
  if (request->trajectory != NULL) return failure_in_usage(failure, "%s is not for a --trajectory", option);
  if (request_outputs(request, outputs) > 0) {
    return failure_in_usage(failure, "%s prints rows: not with %s", option, outputs[0].option);
  }
  const char *const longer = list_of(request);
  if (longer != NULL && !request->json) {
    return failure_in_usage(failure, "%s has no place in the row of a molecule: it needs --json", longer);
  }
  if (request->csv && request->json) return true; /* refused with the options of measure */
  request->rows = request->json ? ROWS_NONE : request->csv ? ROWS_OF_CSV : ROWS_FOR_PERSONS;
  request->csv = false;
  return true;
}

/* Which options of `measure` go together, and with the format of the file. */
static bool check_measure(const struct request *request, struct failure *failure) {
  char list[FORMAT_LIST_BYTES];
  const struct measure_request *const measure = &request->measure;
  const enum grouping by = request->by;
  const bool csv = request->csv, smooth = request->excluded_surface,
             names = file_format_has(request->format, FILE_RESIDUES);
  const bool of_balls = measure->per_ball || measure->gradient;
  const struct usage_rule forms[] = {
      {csv && request->json, "one form of output at a time: either --csv or --json"},
      {csv && request->contacts.cells, "--csv prints one table: --cells has no place in it"},
      {csv && (request->voids.balls || request->pores.balls), "--csv prints one table: --balls has no place in it"},
      {request->contacts.between.text != NULL && by == GROUPING_NONE && request->contacts.map != NULL,
       "--map is of balls, or with --by of residues or chains: not with --between alone"},
      {csv && request->command == COMMAND_BOUNDARY && request->box.source != BOX_NONE,
       "--csv is not for the boundary in a --box"},
      {csv && of_balls && by == GROUPING_RESIDUE, "--csv prints one table: either of balls or --by residue"},
      {csv && of_balls && by == GROUPING_CHAIN, "--csv prints one table: either of balls or --by chain"},
      {csv && of_balls && by == GROUPING_GROUP, "--csv prints one table: either of balls or --by group"},
      {by == GROUPING_GROUP && request->index.count == 0, "--by group is of an index file: it needs --index"},
  };
  const struct usage_rule others[] = {
      {measure->relative && by != GROUPING_RESIDUE, "--relative needs --by residue"},
      {measure->relative && request->probe == 0.0,
       "--relative compares solvent-accessible areas: it needs a probe, --probe 1.4"},
      {measure->polar && !file_format_has(request->format, FILE_ELEMENTS),
       "--polar has no use here: the file names no elements"},
      {csv && measure->polar, "--csv prints one table, of balls or of groups: --polar has no place in it"},
      {csv && measure->interface.text != NULL,
       "--csv prints one table, of balls or of groups: --interface has no place in it"},
      {measure->surface >= 0 && request->probe == 0.0, "--surface needs a probe, --probe 1.4"},
      {measure->outer && !smooth, "--outer is for the solvent-excluded surface: it needs --surface ses"},
      {smooth && request->weights != NULL && measure->gradient,
       "--gradient with --weights is of the solvent-accessible surface: not with --surface ses"},
      {smooth && measure->relative,
       "--relative is of the solvent-accessible surface: it has no use with --surface ses"},
      {smooth && measure->interface.text != NULL,
       "--interface is of the solvent-accessible surface: it has no use with --surface ses"},
      {smooth && measure->curvature,
       "--curvature is of the solvent-accessible surface: it has no use with --surface ses"},
      {smooth && request->window > 0.0,
       "--window is of the solvent-accessible surface: it has no use with --surface ses"},
      {csv && request->window > 0.0 && !measure->gradient,
       "--csv prints one table, of balls or of groups: --window has no place in it but with --gradient"},
      {csv && measure->curvature, "--csv prints one table, of balls or of groups: --curvature has no place in it"},
      {measure->pdb_out != NULL && !file_format_has(request->format, FILE_AREA_COLUMNS),
       "--pdb-out has no use here: it writes a .pdb file again"},
  };
  if (!usage_rules_hold(forms, sizeof forms / sizeof forms[0], failure)) return false;
  if (by != GROUPING_NONE && by != GROUPING_GROUP && !names) {
    return failure_in_usage(failure, "--by has no use here: %s files have no residues",
                            file_format_list(list, ".", "and", FILE_RESIDUES, false));
  }
  return usage_rules_hold(others, sizeof others / sizeof others[0], failure);
}

/* Results of all atoms alone, which a part that others block has not. */
static bool check_part(const struct request *request, struct failure *failure) {
  if (!request_wants_part(request)) return true;
  const char *other = request->excluded_surface                 ? "--surface ses"
                      : request->measure.interface.text != NULL ? "--interface"
                      : request->measure.pdb_out != NULL        ? "--pdb-out"
                                                                : NULL;
  return other == NULL || failure_in_usage(failure, "%s is of all atoms: not with --of", other);
}

/* Checks for results of the outside, or not computed in a box. */
static bool check_box(const struct request *request, struct failure *failure) {
  if (request->box.source == BOX_NONE) return true;
  const char *other = request->excluded_surface                 ? "--surface ses"
                      : request->measure.interface.text != NULL ? "--interface"
                      : request->boundary.shells                ? "--shells"
                      : request->window > 0.0                   ? "--window"
                      : request->measure.pdb_out != NULL        ? "--pdb-out"
                                                                : NULL;
  return other == NULL || failure_in_usage(failure, "%s is not for a --box", other);
}

/* Check the choice of a molecule in a file that states more than one. */
static bool check_choice(struct request *request, struct failure *failure) {
  char list[FORMAT_LIST_BYTES];
  const char *const assembly = request->choice.assembly;
  request->choice.label_chains = request->chains == 2;
  if (request->models == MODELS_MERGED) request->choice.model = EVERY_MODEL;
  if ((request->location_given || assembly != NULL) && !file_format_has(request->format, FILE_LOCATIONS)) {
    return failure_in_usage(failure, "%s has no use here: it is for %s files",
                            assembly != NULL ? "--assembly" : "--altloc",
                            file_format_list(list, ".", "and", FILE_LOCATIONS | FILE_ATOMS, true));
  }
  if (request->chains > 0 && !file_format_has(request->format, FILE_LABEL_CHAINS)) {
    return failure_in_usage(failure, "--chains has no use here: it is for %s files, which have two names of a chain",
                            file_format_list(list, ".", "and", FILE_LABEL_CHAINS | FILE_ATOMS, true));
  }
  if (assembly == NULL && request->models != MODELS_MERGED) return true;
  const char *const copies = assembly != NULL ? "--assembly" : "--models merged";
  if (assembly != NULL && request->models > 0) {
    return failure_in_usage(failure, request->models == MODELS_EACH
                                         ? "--assembly is of one molecule: not with --models all"
                                         : "copies are either those of --assembly or those of --models merged");
  }
  if (assembly != NULL && request->box.source != BOX_NONE) {
    return failure_in_usage(failure, "--assembly is not for a --box: both make copies");
  }
  const char *const other = request->trajectory != NULL        ? "--trajectory"
                            : request->measure.pdb_out != NULL ? "--pdb-out"
                                                               : NULL;
  return other == NULL ||
         failure_in_usage(failure, "%s has the atoms of the file, each once: not with %s", other, copies);
}

bool request_check_several(const struct request *request, struct failure *failure) {
  if (request->command == COMMAND_CLASH) {
    return request->files == 2 ||
           failure_in_usage(failure, "clash takes two files: the molecule at rest, then the one that is moved");
  }
  if (request->files < 2) return true;
  if (request->models == MODELS_EACH) return failure_in_usage(failure, "--models all takes one file at a time");
  if (request->command == COMMAND_HESSIAN && !request->json) {
    return failure_in_usage(failure, "hessian writes one matrix: it takes one file at a time, or --json");
  }
  if (request->command == COMMAND_DRAW) return failure_in_usage(failure, "draw takes one file at a time");
  if (request->command == COMMAND_MESH) return failure_in_usage(failure, "mesh takes one file at a time");
  struct output_choice outputs[MOST_OUTPUTS];
  if (request_outputs(request, outputs) > 0) {
    return failure_in_usage(failure, "%s takes one file at a time", outputs[0].option);
  }
  return true;
}

/* Whether a second reading finds nothing: standard input, or a pipe by name. A device like /dev/null is read again. */
static bool is_read_once(const char *path) {
  struct stat found;
  if (input_is_standard(path)) return true;
  return stat(path, &found) == 0 && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode) && !S_ISCHR(found.st_mode);
}

bool request_check_inputs(const struct request *request, struct failure *failure) {
  const bool each = request->models == MODELS_EACH, again = request->files > 1 || request->rows_given;
  const struct {
    const char *option, *path;
    bool again; /* it is read for each file, or for each molecule of a file */
  } inputs[] = {{"--weights", request->weights, again || each},
                {"--index", request->index_file, again},
                {"--radii", request->radii_file, again},
                {"--trajectory", request->trajectory, false}};
  char shown[EXCERPT_BYTES];
  const bool twice = request->measure.pdb_out != NULL && request->file != NULL && !input_is_standard(request->file);
  if (twice && is_read_once(request->file)) {
    return failure_in_usage(failure,
                            "--pdb-out: %s can be read once, and is needed again; as standard input, -, it is kept",
                            excerpt(shown, request->file, strlen(request->file)));
  }
  int standard = 0;
  for (int k = 0; k < request->files; ++k) standard += input_is_standard(request->names[k]) ? 1 : 0;
  for (size_t k = 0; k < sizeof inputs / sizeof inputs[0]; ++k) {
    const char *const path = inputs[k].path;
    if (path == NULL) continue;
    if (input_is_standard(path) && ++standard > 1) {
      return failure_in_usage(failure, "standard input is one file, not two");
    }
    if (!inputs[k].again || !is_read_once(path)) continue;
    const char *const name = input_name(path);
    return failure_in_usage(failure, "%s: %s can be read once, and serves for one %s", inputs[k].option,
                            excerpt(shown, name, strlen(name)), each ? "molecule" : "file");
  }
  return true;
}

/* Whether the name ends in an extension that the kind names, "a .pdb or .cif", in any case of its letters. */
static bool is_of_kind(const char *path, const char *kind) {
  const char *const extension = file_extension(path);
  const size_t length = strlen(extension);
  char dotted[8] = ".";
  if (length == 0 || length + 2 > sizeof dotted || extension == path + 1 || extension[-2] == '/') return false;
  for (size_t i = 0; i < length; ++i) dotted[i + 1] = (char)tolower((unsigned char)extension[i]);
  const char *const named = strstr(kind, dotted);
  return named != NULL && (named[length + 1] == ' ' || named[length + 1] == '\0');
}

static bool check_output(const struct request *request, const struct output_choice *output, struct failure *failure) {
  const bool standard = output_is_standard(output->path);
  if (output->kind != NULL && !standard && !is_of_kind(output->path, output->kind)) {
    return failure_in_usage(failure, "%s writes %s file, and its name says so", output->option, output->kind);
  }
  if (request_reads(request, output->path)) {
    return failure_in_usage(failure, "%s would write over the file that is read", output->option);
  }
  if (standard && (request->json || request->csv)) {
    return failure_in_usage(failure, "%s and %s would both go to standard output", output->option,
                            request->json ? "--json" : "--csv");
  }
  return true;
}

/* Nothing that is read is written over, and standard output serves for one thing. */
static bool check_files(const struct request *request, struct failure *failure) {
  struct output_choice outputs[MOST_OUTPUTS];
  const int count = request_outputs(request, outputs);
  for (int k = 0; k < count; ++k) {
    if (!check_output(request, &outputs[k], failure)) return false;
    for (int other = 0; other < k; ++other) {
      const char *const path = outputs[k].path, *const before = outputs[other].path;
      if (!outputs_are_one(path, before)) continue;
      return failure_in_usage(failure, "%s and %s would write the same file", outputs[other].option, outputs[k].option);
    }
  }
  return true;
}

bool request_check(struct request *request, struct failure *failure) {
  request->excluded_surface = request->measure.surface == 1;
  if (!selection_suits(&request->selection, request->format, &request->index, failure)) return false;
  if (!selection_suits(&request->measure.part, request->format, &request->index, failure)) return false;
  if (!selection_suits(&request->drawing.highlight, request->format, &request->index, failure)) return false;
  if (!selection_groups_suit(&request->measure.interface, "--interface", request->format, &request->index, failure) ||
      !selection_groups_suit(&request->contacts.between, "--between", request->format, &request->index, failure)) {
    return false;
  }
  if (!check_choice(request, failure) || !check_rows(request, failure)) return false;
  if (!check_trajectory(request, failure) || !check_measure(request, failure) || !check_part(request, failure) ||
      !check_box(request, failure)) {
    return false;
  }
  command_check *const check = command_table[request->command].check;
  if (check != NULL && !check(request, failure)) return false;
  return check_files(request, failure);
}
