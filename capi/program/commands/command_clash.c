/* hardsphere clash: a molecule against another one that is turned and moved. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/command_frames.h"
#include "commands/commands.h"
#include "commands/input_report.h"
#include "read/geometry.h"
#include "read/vectors.h"
#include "write/ball_label.h"

/* The findings, and the bodies that they are found with. */
struct clash {
  struct geometry geometry[2];
  void *memory[2];
  hsp_body *body[2]; /* at rest, moving */
  hsp_body_gap gap;
  hsp_body_overlap overlap;
  uint32_t *pair; /* [overlap.pairs][2] */
};

static void clash_free(struct clash *clash) {
  for (int k = 0; k < 2; ++k) {
    geometry_free(&clash->geometry[k]);
    free(clash->memory[k]);
  }
  free(clash->pair);
}

/* Set both models on one lattice: the coarser of the two that they would choose. */
static bool set_models(const struct molecule_request *const both[2], struct clash *clash, struct failure *failure) {
  double step[2];
  const bool frame = both[1]->molecule->frame.number > 0;
  const char *const files[2] = {both[0]->request->file, frame ? failure->file : both[1]->request->file};
  for (int k = 0; k < 2; ++k) {
    failure->file = files[k];
    if (!geometry_set_model(&clash->geometry[k], both[k]->molecule, both[k]->request->probe, 0.0, failure))
      return false;
    hsp_model_info info;
    const int32_t status = hsp_model_get_info(clash->geometry[k].work.model, &info);
    if (status != HSP_OK) return failure_in_library(failure, status);
    step[k] = info.step;
  }
  if (step[0] == step[1]) return true;
  const int finer = step[0] < step[1] ? 0 : 1;
  failure->file = files[finer];
  return geometry_set_model(&clash->geometry[finer], both[finer]->molecule, both[finer]->request->probe,
                            step[1 - finer], failure);
}

static bool make_bodies(struct clash *clash, struct failure *failure) {
  for (int k = 0; k < 2; ++k) {
    const hsp_model *const model = clash->geometry[k].work.model;
    hsp_model_info info;
    size_t bytes = 0;
    int32_t status = hsp_model_get_info(model, &info);
    if (status == HSP_OK) status = hsp_body_bytes(info.balls, &bytes);
    if (status != HSP_OK) return failure_in_library(failure, status);
    clash->memory[k] = malloc(bytes);
    if (clash->memory[k] == NULL) return failure_of_memory(failure);
    status = hsp_body_init(clash->memory[k], bytes, info.balls, &clash->body[k]);
    if (status == HSP_OK) status = hsp_body_set(clash->body[k], model);
    if (status != HSP_OK) return failure_in_library(failure, status);
  }
  return true;
}

/* The rotation by three angles, in the way of `draw`. */
static int32_t rotation_of(const double angle[3], double matrix[9]) {
  static const double none[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  memcpy(matrix, none, sizeof none);
#if HSP_HAS_SIGHT
  hsp_view_options options;
  int32_t status = hsp_view_options_init(&options, (uint32_t)sizeof options);
  if (status == HSP_OK) status = hsp_view_options_turn(&options, angle[0], angle[1], angle[2]);
  if (status != HSP_OK) return status;
  /* The viewer's axes, seen from the balls, are the rows of the rotation. */
  const double *const u = options.up, *const t = options.towards;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    matrix[k] = u[next] * t[last] - u[last] * t[next];
    matrix[3 + k] = u[k];
    matrix[6 + k] = t[k];
  }
#else
  (void)angle; /* the option is of the part that draws */
#endif
  return HSP_OK;
}

/* Turned about the mean of its centres, then moved. */
static int32_t pose_of(const struct molecule_request *moving, hsp_pose *pose) {
  const struct molecule *const molecule = moving->molecule;
  double mean[3] = {0.0, 0.0, 0.0}, translation[3], matrix[9];
  const int32_t status = rotation_of(moving->request->clash.rotate.xyz, matrix);
  if (status != HSP_OK) return status;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    for (int axis = 0; axis < 3; ++axis) mean[axis] += molecule->xyz[3 * (size_t)i + (size_t)axis] / molecule->atoms;
  }
  for (int row = 0; row < 3; ++row) {
    translation[row] = mean[row] + moving->request->clash.translate.xyz[row] - dot(matrix + 3 * row, mean);
  }
  return hsp_pose_from_matrix(matrix, translation, pose);
}

static bool find(const struct molecule_request *moving, struct clash *clash, struct failure *failure) {
  const hsp_body *const fixed = clash->body[0], *const other = clash->body[1];
  hsp_pose pose;
  int32_t status = pose_of(moving, &pose);
  if (status == HSP_OK) status = hsp_body_gaps(fixed, other, 1, &pose, &clash->gap, NULL);
  if (status == HSP_E_RANGE) {
    return failure_in_usage(failure, "--translate: the second molecule comes to lie beyond the lattice");
  }
  if (status == HSP_OK) status = hsp_body_overlaps(fixed, other, 1, &pose, &clash->overlap, NULL);
  if (status != HSP_OK) return failure_in_library(failure, status);
  const uint32_t count = clash->overlap.pairs;
  uint32_t needed = 0;
  clash->pair = calloc(2 * (size_t)count + 2, sizeof *clash->pair);
  if (clash->pair == NULL) return failure_of_memory(failure);
  status = hsp_body_pairs(fixed, other, &pose, clash->pair, count, &needed);
  return status == HSP_OK || failure_in_library(failure, status);
}

static void add_input(struct record *record, const char *key, const struct molecule_request *one) {
  if (!record_key(record, key)) return;
  text_buffer_add(record->out, "{\"n\": %" PRIu32, one->molecule->atoms);
  input_report_json(record->out, one->request, one->molecule);
  text_buffer_add_text(record->out, "}");
}

/* Both nearest balls in the columns that either file has something for. */
static void print_nearest(const struct molecule_request *const both[2], const struct clash *clash,
                          struct text_buffer *out) {
  const uint32_t nearest[2] = {clash->gap.fixed, clash->gap.posed};
  struct ball_columns columns = {false, false};
  for (int k = 0; k < 2; ++k) {
    const struct ball_columns own = ball_columns_of(both[k]->molecule);
    columns.names = columns.names || own.names;
    columns.elements = columns.elements || own.elements;
  }
  text_buffer_add(out, "\n  %-8s", "molecule");
  report_ball_titles(out, columns);
  for (int k = 0; k < 2; ++k) {
    text_buffer_add(out, "\n  %-8s", k == 0 ? "first" : "second");
    report_ball(out, columns, both[k]->molecule, nearest[k]);
  }
  text_buffer_add_text(out, "\n");
}

static void record_findings(struct record *record, const struct molecule_request *const both[2],
                            const struct clash *clash) {
  const uint32_t pairs = clash->overlap.pairs, nearest[2] = {clash->gap.fixed, clash->gap.posed};
  const bool row = record_is_row(record);
  record_whether(record, "hit", NULL, pairs > 0, "");
  record_count(record, row ? "pairs" : NULL, "pairs", pairs, "of balls that meet");
  if (record_key(record, "pairs")) {
    text_buffer_add_text(record->out, "[");
    for (uint32_t k = 0; k < pairs; ++k) {
      if (k > 0) text_buffer_add_text(record->out, ", ");
      json_counts(record->out, clash->pair + 2 * (size_t)k, 2);
    }
    text_buffer_add_text(record->out, "]");
  }
  record_number(record, "gap", "least gap", clash->gap.gap, 6, "@, of the two balls below");
  record_counts(record, "nearest", nearest, 2);
  if (row) record_count(record, "nearest_1", NULL, nearest[0], "");
  if (row) record_count(record, "nearest_2", NULL, nearest[1], "");
  record_number(record, "overlap_volume", "overlap", clash->overlap.volume, 6, "@^3, summed pair by pair");
  if (record_key(record, "nearest_balls")) {
    for (int k = 0; k < 2; ++k) {
      text_buffer_add_text(record->out, k == 0 ? "[{" : "}, {");
      ball_label_json(both[k]->molecule, nearest[k], record->out);
    }
    text_buffer_add_text(record->out, "}]");
  }
  if (record->molecule->frame.number > 0) return; /* it would be the same for all frames */
  add_input(record, "fixed", both[0]);
  add_input(record, "moving", both[1]);
}

void describe_clash(const struct request *request, struct record *record) {
  static const struct clash none;
  const struct molecule_request one = {request, record->molecule, NULL};
  const struct molecule_request *const both[2] = {&one, &one};
  record_findings(record, both, &none);
}

static void print(const struct molecule_request *const both[2], const struct clash *clash, struct text_buffer *out) {
  const bool json = both[0]->request->json;
  struct record record = {
      .form = json ? AS_JSON : FOR_PERSONS, .molecule = both[0]->molecule, .width = VALUE_WIDTH, .out = out};
  if (json) text_buffer_add_text(out, "{");
  for (int k = 0; k < 2 && !json; ++k) report_heading(out, both[k]->request, both[k]->molecule);
  record_findings(&record, both, clash);
  if (json) {
    text_buffer_add_text(out, "}\n");
  } else {
    print_nearest(both, clash, out);
  }
}

static bool find_all(const struct molecule_request *const both[2], struct clash *clash, struct failure *failure) {
  return set_models(both, clash, failure) && make_bodies(clash, failure) && find(both[1], clash, failure);
}

/* Frames of the second molecule. */
struct run {
  const struct molecule_request *const *both;
};

struct findings {
  struct clash clash;
  const struct molecule_request *const *both; /* in print_row */
};

static bool find_in_frame(const void *of, const struct molecule *molecule, struct geometry *geometry, void *findings,
                          struct failure *failure) {
  const struct molecule_request *const *const both = ((const struct run *)of)->both;
  const struct molecule_request posed = {both[1]->request, molecule, NULL};
  const struct molecule_request *const now[2] = {both[0], &posed};
  (void)geometry; /* of the finer lattice of both */
  return find_all(now, &((struct findings *)findings)->clash, failure);
}

static void print_row(struct record *record, const void *of) {
  const struct findings *const found = of;
  const struct molecule_request posed = {found->both[1]->request, record->molecule, NULL};
  const struct molecule_request *const now[2] = {found->both[0], &posed};
  record_findings(record, now, &found->clash);
}

static bool take_frame(void *of, const struct molecule *molecule, void *findings, struct text_buffer *out,
                       struct failure *failure) {
  struct findings *const found = findings;
  (void)failure;
  found->both = ((const struct run *)of)->both;
  double *const rounding = found->both[0]->largest_rounding;
  *rounding = fmax(*rounding, found->clash.geometry[0].largest_rounding);
  report(found->both[1]->request, molecule, print_row, found, out);
  return true;
}

static void clear(void *findings) {
  clash_free(&((struct findings *)findings)->clash);
}

bool command_clash(const struct molecule_request *fixed, const struct molecule_request *moving, struct text_buffer *out,
                   struct failure *failure) {
  const struct molecule_request *const both[2] = {fixed, moving};
  if (strcmp(fixed->molecule->format->unit, moving->molecule->format->unit) != 0) {
    return failure_in_usage(failure, "the files have different units: %s and %s", fixed->molecule->format->unit,
                            moving->molecule->format->unit);
  }
  if (moving->request->trajectory != NULL) {
    struct run run = {both};
    const struct frame_work work = {
        .bytes = sizeof(struct findings), .find = find_in_frame, .take = take_frame, .clear = clear, .of = &run};
    return command_frames(moving->request, moving->molecule, &work, moving->largest_rounding, failure);
  }
  struct clash clash;
  memset(&clash, 0, sizeof clash);
  const bool done = find_all(both, &clash, failure);
  for (int k = 0; k < 2; ++k) *both[k]->largest_rounding = clash.geometry[k].largest_rounding;
  if (done) print(both, &clash, out);
  clash_free(&clash);
  return done;
}
