#include "read/trajectory.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hardsphere.h"
#include "read/number.h"
#include "read/read_molecule.h"

bool trajectory_format_of(const char *path, const struct file_format *molecule, struct trajectory *trajectory,
                          struct failure *failure) {
  memset(trajectory, 0, sizeof *trajectory);
  trajectory->format = input_is_standard(path) ? molecule : file_format_named(file_extension(path), FILE_FRAMES);
  if (trajectory->format != NULL && file_format_has(trajectory->format, FILE_FRAMES)) return true;
  char list[FORMAT_LIST_BYTES];
  failure->file = path;
  return failure_in_input(failure, 0, "no trajectory by its extension; expected %s",
                          file_format_list(list, ".", "or", FILE_FRAMES, true));
}

static bool has_models(const struct trajectory *trajectory) {
  return file_format_has(trajectory->format, FILE_ATOMS);
}

bool trajectory_open(struct trajectory *trajectory, const char *path, uint32_t atoms, struct failure *failure) {
  trajectory->path = path;
  trajectory->atoms = atoms;
  failure->file = input_name(path);
  struct file_choice choice = FILE_CHOICE_FIRST;
  choice.location = trajectory->location;
  molecule_init(&trajectory->model, trajectory->format, &choice, KEEP_NO_MORE);
  if (has_models(trajectory)) {
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
  return trajectory->format->begin == NULL || trajectory->format->begin(trajectory, failure);
}

bool failure_in_frame(struct failure *failure, uint64_t number) {
  char lead[32];
  const size_t length = (size_t)snprintf(lead, sizeof lead, "frame %" PRIu64 ": ", number);
  memmove(failure->reason + length, failure->reason, sizeof failure->reason - length - 1); /* the last byte stays 0 */
  memcpy(failure->reason, lead, length);
  return false;
}

static enum line_status next_model(struct trajectory *trajectory, bool wanted, struct failure *failure) {
  struct molecule *model = &trajectory->model;
  molecule_empty(model);
  /* Those at all locations are read before the choice. */
  model->most = trajectory->location == LOCATION_FIRST ? trajectory->atoms : HSP_MAX_BALLS;
  model->frame = trajectory->stamp;
  model->frame.box = trajectory->last_box;
  model->models = 0;
  model->model = wanted ? 1 : 2;
  const enum line_status status =
      trajectory->format->next(trajectory->lines, &trajectory->begun, wanted, model, failure);
  trajectory->stamp = model->frame;
  if (file_format_has(trajectory->format, FILE_ONE_BOX)) trajectory->last_box = model->frame.box;
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
  const bool models = has_models(trajectory);
  trajectory->stamp = (struct frame_stamp){.number = trajectory->frames + 1};
  enum line_status status =
      models ? next_model(trajectory, wanted, failure) : trajectory->format->next_frame(trajectory, wanted, failure);
  if (status == LINE_READ && wanted && !models && !check_coordinates(trajectory, failure)) {
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
  if (trajectory->format != NULL && !has_models(trajectory)) free(trajectory->xyz);
  molecule_free(&trajectory->model);
  byte_reader_close(&trajectory->bytes);
  xtc_free(&trajectory->xtc);
  dcd_free(&trajectory->dcd);
  netcdf_free(&trajectory->netcdf);
  memset(trajectory, 0, sizeof *trajectory);
}
