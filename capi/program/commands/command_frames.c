#include "commands/command_frames.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "commands/frame_range.h"
#include "commands/unit_cell.h"
#include "read/line_reader.h"
#include "read/progress.h"
#include "read/trajectory.h"

/* The frame's coordinates for those atoms that became balls. `own` is the box of the file of the molecule, which serves
 * frames of a file that has none at all. */
static void take_frame(const struct trajectory *trajectory, const struct box_record *own, bool first,
                       struct molecule *molecule) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const size_t place = molecule->place[i];
    memcpy(molecule->xyz + 3 * (size_t)i, trajectory->xyz + 3 * place, 3 * sizeof *molecule->xyz);
    molecule->line[i] = trajectory->line == NULL ? 0 : trajectory->line[place];
  }
  molecule->frame = trajectory->stamp;
  if (!trajectory->boxed) molecule->frame.box = *own;
  molecule->frame.first = first;
}

/* Do what is asked for with the frame that was read, and print it. */
static bool run_frame(const struct request *request, const struct trajectory *trajectory,
                      const struct molecule *molecule, struct geometry *geometry, command_function *command,
                      const struct progress *progress, struct text_buffer *out, struct failure *failure) {
  const char *file = failure->file;
  out->length = 0;
  if (!geometry_set_model(geometry, molecule, request->probe, 0.0, failure) ||
      !command(request, molecule, geometry, out, failure)) {
    return failure->file != file ? false : failure_in_frame(failure, trajectory);
  }
  progress_end(&geometry->progress);
  progress_end(progress);
  const bool printed = text_buffer_print(out, failure);
  if (printed) failure->file = file;
  return printed;
}

static bool check_number(const struct request *request, uint64_t measured, uint64_t frames, struct failure *failure) {
  if (measured > 0) return true;
  if (frames == 0) return failure_in_input(failure, 0, "no frames in the file");
  return failure_in_input(failure, 0, "no frame %" PRIu64 ": the file has %" PRIu64, request->frames.first, frames);
}

/* What a person who watches sees: nothing of short trajectories. */
static void show_frame(const struct trajectory *trajectory, struct progress *progress) {
  char text[40];
  *progress = progress_begin(trajectory->frames * trajectory->atoms, PROGRESS_LEAST_BALLS);
  snprintf(text, sizeof text, "frame %" PRIu64, trajectory->frames);
  progress_show(progress, text);
}

static bool run_frames(const struct request *request, struct trajectory *trajectory, struct molecule *molecule,
                       struct geometry *geometry, command_function *command, struct progress *progress,
                       struct text_buffer *out, struct failure *failure) {
  uint64_t measured = 0;
  const struct box_record own = molecule->frame.box;
  while (trajectory->frames < request->frames.last) {
    const bool wanted = frame_range_has(&request->frames, trajectory->frames + 1);
    const enum line_status status = trajectory_next(trajectory, wanted, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END) break;
    show_frame(trajectory, progress);
    if (!wanted) continue;
    take_frame(trajectory, &own, measured++ == 0, molecule);
    unit_cell_turn(request, molecule);
    if (!run_frame(request, trajectory, molecule, geometry, command, progress, out, failure)) return false;
  }
  return check_number(request, measured, trajectory->frames, failure);
}

bool command_frames(const struct request *request, struct molecule *molecule, struct geometry *geometry,
                    command_function *command, struct failure *failure) {
  struct trajectory trajectory;
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  struct progress progress = {false};
  bool done = trajectory_format_of(request->trajectory, request->format, &trajectory, failure);
  done = done && trajectory_open(&trajectory, request->trajectory, molecule->read, failure) &&
         run_frames(request, &trajectory, molecule, geometry, command, &progress, &out, failure);
  progress_end(&progress);
  trajectory_close(&trajectory);
  text_buffer_free(&out);
  return done;
}
