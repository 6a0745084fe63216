#include "read/trajectory.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/fields.h"
#include "read/number.h"
#include "read/read_molecule.h"

bool trajectory_format_of(const char *path, const struct file_format *molecule, struct trajectory *trajectory,
                          struct failure *failure) {
  const char *slash = strrchr(path, '/');
  const char *dot = strrchr(slash == NULL ? path : slash + 1, '.');
  const struct field extension = {dot == NULL ? "" : dot + 1, dot == NULL ? 0 : strlen(dot + 1)};
  memset(trajectory, 0, sizeof *trajectory);
  if (field_is(extension, "XTC")) {
    trajectory->format = TRAJECTORY_XTC;
    return true;
  }
  if (field_is(extension, "DCD")) {
    trajectory->format = TRAJECTORY_DCD;
    return true;
  }
  trajectory->models = input_is_standard(path) ? molecule : file_format_named(extension.text);
  if (trajectory->models != NULL && file_format_has(trajectory->models, FILE_FRAMES)) return true;
  char list[FORMAT_LIST_BYTES];
  failure->file = path;
  return failure_in_input(failure, 0, "no trajectory by its extension; expected .xtc, .dcd, %s",
                          file_format_list(list, ".", "or", FILE_FRAMES, true));
}

bool trajectory_open(struct trajectory *trajectory, const char *path, uint32_t atoms, struct failure *failure) {
  trajectory->path = path;
  trajectory->atoms = atoms;
  failure->file = input_name(path);
  molecule_init(&trajectory->model, trajectory->models, 1, KEEP_NO_MORE);
  if (trajectory->format == TRAJECTORY_MODELS) {
    trajectory->lines = malloc(sizeof *trajectory->lines);
    if (trajectory->lines == NULL) return failure_of_memory(failure);
    if (line_reader_open(trajectory->lines, path, failure)) return true;
    free(trajectory->lines);
    trajectory->lines = NULL;
    return false;
  }
  trajectory->xyz = calloc((size_t)atoms + 1, 3 * sizeof *trajectory->xyz);
  if (trajectory->xyz == NULL) return failure_of_memory(failure);
  if (!byte_reader_open(&trajectory->bytes, path, failure)) return false;
  return trajectory->format == TRAJECTORY_XTC || dcd_begin(&trajectory->dcd, &trajectory->bytes, atoms, failure);
}

bool failure_in_frame(struct failure *failure, uint64_t number) {
  char reason[sizeof failure->reason];
  memcpy(reason, failure->reason, sizeof reason);
  const int length = snprintf(failure->reason, sizeof failure->reason, "frame %" PRIu64 ": ", number);
  snprintf(failure->reason + length, sizeof failure->reason - (size_t)length, "%s", reason);
  return false;
}

static enum line_status next_model(struct trajectory *trajectory, bool wanted, struct failure *failure) {
  struct molecule *model = &trajectory->model;
  molecule_empty(model);
  model->most = trajectory->atoms;
  model->frame = trajectory->stamp;
  model->frame.box = trajectory->last_box;
  model->models = 0;
  model->model = wanted ? 1 : 2;
  const enum line_status status =
      trajectory->models->next(trajectory->lines, &trajectory->begun, wanted, model, failure);
  trajectory->stamp = model->frame;
  if (file_format_has(trajectory->models, FILE_ONE_BOX)) trajectory->last_box = model->frame.box;
  trajectory->xyz = model->xyz;
  trajectory->line = model->line;
  if (status != LINE_READ || !wanted || model->atoms == trajectory->atoms) return status;
  failure_in_input(failure, trajectory->lines->number, "%" PRIu32 " in place of %" PRIu32 " atoms", model->atoms,
                   trajectory->atoms);
  return LINE_FAILED;
}

/* Files of text have no such numbers. */
static bool check_coordinates(const struct trajectory *trajectory, struct failure *failure) {
  for (size_t k = 0; k < 3 * (size_t)trajectory->atoms; ++k) {
    if (is_finite(trajectory->xyz[k])) continue;
    return failure_in_input(failure, 0, "%c of atom %lu, counted from 1, is not finite", "xyz"[k % 3],
                            (unsigned long)(k / 3 + 1));
  }
  return true;
}

enum line_status trajectory_next(struct trajectory *trajectory, bool wanted, struct failure *failure) {
  const uint32_t atoms = trajectory->atoms;
  enum line_status status = LINE_END;
  trajectory->stamp = (struct frame_stamp){.number = trajectory->frames + 1};
  switch (trajectory->format) {
    case TRAJECTORY_MODELS:
      status = next_model(trajectory, wanted, failure);
      break;
    case TRAJECTORY_XTC:
      status =
          xtc_next(&trajectory->xtc, &trajectory->bytes, wanted, atoms, trajectory->xyz, &trajectory->stamp, failure);
      break;
    case TRAJECTORY_DCD:
      status =
          dcd_next(&trajectory->dcd, &trajectory->bytes, wanted, atoms, trajectory->xyz, &trajectory->stamp, failure);
      break;
  }
  if (status == LINE_READ && wanted && trajectory->format != TRAJECTORY_MODELS &&
      !check_coordinates(trajectory, failure)) {
    status = LINE_FAILED;
  }
  if (status == LINE_READ) ++trajectory->frames;
  trajectory->boxed = trajectory->boxed || trajectory->stamp.box.given || trajectory->stamp.box.denied;
  if (status == LINE_FAILED) failure_in_frame(failure, trajectory->stamp.number);
  return status;
}

void trajectory_close(struct trajectory *trajectory) {
  if (trajectory->lines != NULL) line_reader_close(trajectory->lines);
  free(trajectory->lines);
  if (trajectory->format != TRAJECTORY_MODELS) free(trajectory->xyz);
  molecule_free(&trajectory->model);
  byte_reader_close(&trajectory->bytes);
  xtc_free(&trajectory->xtc);
  dcd_free(&trajectory->dcd);
  memset(trajectory, 0, sizeof *trajectory);
}
