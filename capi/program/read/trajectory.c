#include "read/trajectory.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/fields.h"
#include "read/number.h"
#include "read/read_molecule.h"
#include "read/read_trr.h"

static enum line_status next_of_xtc(struct trajectory *of, bool wanted, struct failure *failure) {
  return xtc_next(&of->xtc, &of->bytes, wanted, of->atoms, of->xyz, &of->stamp, failure);
}

static enum line_status next_of_trr(struct trajectory *of, bool wanted, struct failure *failure) {
  return trr_next(&of->bytes, wanted, of->atoms, of->xyz, &of->stamp, failure);
}

static bool begin_dcd(struct trajectory *of, struct failure *failure) {
  return dcd_begin(&of->dcd, &of->bytes, of->atoms, failure);
}

static enum line_status next_of_dcd(struct trajectory *of, bool wanted, struct failure *failure) {
  return dcd_next(&of->dcd, &of->bytes, wanted, of->atoms, of->xyz, &of->stamp, failure);
}

static const struct binary_frames binary_formats[] = {
    {"xtc", "XTC", NULL, next_of_xtc},
    {"trr", "TRR", NULL, next_of_trr},
    {"dcd", "DCD", begin_dcd, next_of_dcd},
};

enum { BINARY_FORMATS = sizeof binary_formats / sizeof binary_formats[0] };

const char *trajectory_format_list(char out[FORMAT_LIST_BYTES]) {
  char models[FORMAT_LIST_BYTES];
  size_t at = 0;
  for (size_t i = 0; i < BINARY_FORMATS; ++i) {
    at += (size_t)snprintf(out + at, FORMAT_LIST_BYTES - at, ".%s, ", binary_formats[i].name);
  }
  snprintf(out + at, FORMAT_LIST_BYTES - at, "%s", file_format_list(models, ".", "or", FILE_FRAMES, true));
  return out;
}

bool trajectory_format_of(const char *path, const struct file_format *molecule, struct trajectory *trajectory,
                          struct failure *failure) {
  const char *slash = strrchr(path, '/');
  const char *dot = strrchr(slash == NULL ? path : slash + 1, '.');
  const struct field extension = {dot == NULL ? "" : dot + 1, dot == NULL ? 0 : strlen(dot + 1)};
  memset(trajectory, 0, sizeof *trajectory);
  for (size_t i = 0; i < BINARY_FORMATS; ++i) {
    if (field_is(extension, binary_formats[i].extension)) trajectory->binary = &binary_formats[i];
  }
  if (trajectory->binary != NULL) return true;
  trajectory->models = input_is_standard(path) ? molecule : file_format_named(extension.text);
  if (trajectory->models != NULL && file_format_has(trajectory->models, FILE_FRAMES)) return true;
  char list[FORMAT_LIST_BYTES];
  failure->file = path;
  return failure_in_input(failure, 0, "no trajectory by its extension; expected %s", trajectory_format_list(list));
}

bool trajectory_open(struct trajectory *trajectory, const char *path, uint32_t atoms, struct failure *failure) {
  trajectory->path = path;
  trajectory->atoms = atoms;
  failure->file = input_name(path);
  molecule_init(&trajectory->model, trajectory->models, 1, KEEP_NO_MORE);
  if (trajectory->binary == NULL) {
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
  return trajectory->binary->begin == NULL || trajectory->binary->begin(trajectory, failure);
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
  const struct binary_frames *const binary = trajectory->binary;
  trajectory->stamp = (struct frame_stamp){.number = trajectory->frames + 1};
  enum line_status status =
      binary == NULL ? next_model(trajectory, wanted, failure) : binary->next(trajectory, wanted, failure);
  if (status == LINE_READ && wanted && binary != NULL && !check_coordinates(trajectory, failure)) {
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
  if (trajectory->binary != NULL) free(trajectory->xyz);
  molecule_free(&trajectory->model);
  byte_reader_close(&trajectory->bytes);
  xtc_free(&trajectory->xtc);
  dcd_free(&trajectory->dcd);
  memset(trajectory, 0, sizeof *trajectory);
}
