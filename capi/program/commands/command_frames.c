#include "commands/command_frames.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/frame_range.h"
#include "read/line_reader.h"
#include "read/progress.h"
#include "read/threads.h"
#include "read/trajectory.h"

/* All frames in work have at most this many atoms together, which take half a gigabyte; else fewer threads work. */
enum { MOST_ATOMS = 1500000, SLOTS_OF_WORKER = 2 };

/* A frame between reading and printing. */
struct frame {
  struct molecule molecule; /* only coordinates and lines are its own, all else is the file's */
  bool done;                /* it was read, and the command has its results */
  struct failure failure;   /* if not */
  struct text_buffer out;
  void *findings; /* [work->bytes] */
};

struct frames {
  const struct request *request;
  const struct frame_work *work;
  const struct molecule *molecule;
  struct trajectory trajectory;
  struct box_record own; /* of the file of the molecule, which serves frames of a file that has none at all */
  struct in_order loop;
  struct frame_clock clock;
  struct geometry *geometry; /* [workers] */
  struct frame *frame;       /* [slots] */
  uint64_t taken;            /* frames that were asked for and are there */
  bool broken;               /* one of them could not be read */
  struct progress progress;
  struct failure begin;    /* the file's name, without a fault: each frame's failure begins as this one */
  struct failure *failure; /* of the first frame at fault */
};

/* The frame's coordinates for those atoms that became balls. */
static void take_coordinates(const struct trajectory *trajectory, struct molecule *molecule) {
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const size_t place = molecule->coordinate[i];
    memcpy(molecule->xyz + 3 * (size_t)i, trajectory->xyz + 3 * place, 3 * sizeof *molecule->xyz);
    molecule->line[i] = trajectory->line == NULL ? 0 : trajectory->line[place];
  }
}

/* Shows progress to a person who watches: nothing of short trajectories. */
static void show_frame(struct frames *frames, uint64_t number) {
  char text[40];
  const uint64_t amount = number * frames->molecule->atoms;
  if (frames->loop.workers == 1) frames->progress = progress_begin(amount, PROGRESS_LEAST_BALLS);
  if (amount < PROGRESS_LEAST_BALLS) return;
  snprintf(text, sizeof text, "frame %" PRIu64, number);
  progress_show(&frames->progress, text);
}

static bool take_frame(void *of, uint32_t slot, uint64_t *weight) {
  struct frames *const frames = of;
  struct frame *const frame = &frames->frame[slot];
  struct trajectory *const trajectory = &frames->trajectory;
  (void)weight;
  while (!frames->broken && trajectory->frames < frames->request->frames.last) {
    const bool wanted = frame_range_has(&frames->request->frames, trajectory->frames + 1);
    frame->failure = frames->begin;
    const enum line_status status = trajectory_next(trajectory, wanted, &frame->failure);
    if (status == LINE_END) break;
    frames->broken = status == LINE_FAILED;
    if (frames->loop.workers == 1 && !frames->broken) show_frame(frames, trajectory->frames);
    if (!wanted && !frames->broken) continue;
    if (!frames->broken && frame_range_has_times(&frames->request->frames)) {
      if (!trajectory->stamp.timed) {
        failure_in_input(&frame->failure, 0, "it has no time, which --begin, --end and --interval are about");
        failure_in_frame(&frame->failure, trajectory->stamp.number);
        frames->broken = true;
      } else if (!frame_clock_takes(&frames->clock, &frames->request->frames, trajectory->stamp.time)) {
        continue;
      }
    }
    frame->done = !frames->broken;
    if (frames->broken) return true;
    take_coordinates(trajectory, &frame->molecule);
    frame->molecule.frame = trajectory->stamp;
    if (!trajectory->boxed) frame->molecule.frame.box = frames->own;
    frame->molecule.frame.first = frames->taken++ == 0;
    return true;
  }
  return false;
}

static void clear_findings(const struct frame_work *work, struct frame *frame) {
  if (frame->findings == NULL) return;
  if (work->clear != NULL) work->clear(frame->findings);
  memset(frame->findings, 0, work->bytes);
}

static void work_on_frame(void *of, uint32_t worker, uint32_t slot) {
  const struct frames *const frames = of;
  const struct request *const request = frames->request;
  struct geometry *const geometry = &frames->geometry[worker];
  struct frame *const frame = &frames->frame[slot];
  struct failure *const failure = &frame->failure;
  const char *const file = failure->file;
  if (!frame->done) return;
  frame->out.length = 0;
  const struct frame_work *const to_do = frames->work;
  clear_findings(to_do, frame);
  frame->done = geometry_set_model(geometry, &frame->molecule, request_grown(request), 0.0, failure) &&
                (to_do->command != NULL ? to_do->command(request, &frame->molecule, geometry, &frame->out, failure)
                                        : to_do->find(to_do->of, &frame->molecule, geometry, frame->findings, failure));
  if (!frame->done && failure->file == file) failure_in_frame(failure, frame->molecule.frame.number);
  progress_end(&geometry->progress);
}

static bool print_frame(void *of, uint32_t slot) {
  struct frames *const frames = of;
  struct frame *const frame = &frames->frame[slot];
  const struct frame_work *const work = frames->work;
  progress_end(&frames->progress);
  if (!frame->done) {
    *frames->failure = frame->failure;
    return false;
  }
  if (work->command == NULL && !work->take(work->of, &frame->molecule, frame->findings, &frame->out, frames->failure)) {
    return false;
  }
  if (!text_buffer_print(&frame->out, frames->failure)) return false;
  if (frames->loop.workers > 1) show_frame(frames, frame->molecule.frame.number);
  return true;
}

static bool check_number(const struct frames *frames, struct failure *failure) {
  if (failure->exit_status != 0) return false;
  failure->file = frames->begin.file;
  if (frames->taken > 0) return true;
  if (frames->trajectory.frames > 0 && frame_range_has_times(&frames->request->frames)) {
    return failure_in_input(failure, 0, "no frame at such a time: the file has %" PRIu64, frames->trajectory.frames);
  }
  if (frames->trajectory.frames == 0) return failure_in_input(failure, 0, "no frames in the file");
  return failure_in_input(failure, 0, "no frame %" PRIu64 ": the file has %" PRIu64, frames->request->frames.first,
                          frames->trajectory.frames);
}

/* Handles for each worker, and coordinates for each slot. */
static bool allocate(struct frames *frames, struct failure *failure) {
  const struct in_order *const loop = &frames->loop;
  const size_t atoms = (size_t)frames->molecule->atoms;
  frames->geometry = calloc(loop->workers, sizeof *frames->geometry);
  frames->frame = calloc(loop->slots, sizeof *frames->frame);
  bool done = frames->geometry != NULL && frames->frame != NULL;
  for (uint32_t k = 0; done && k < loop->slots; ++k) {
    struct molecule *const molecule = &frames->frame[k].molecule;
    *molecule = *frames->molecule;
    molecule->xyz = malloc((atoms + 1) * 3 * sizeof *molecule->xyz);
    molecule->line = malloc((atoms + 1) * sizeof *molecule->line);
    frames->frame[k].findings = calloc(frames->work->bytes + 1, 1);
    done = molecule->xyz != NULL && molecule->line != NULL && frames->frame[k].findings != NULL;
  }
  return done || failure_of_memory(failure);
}

static void release(struct frames *frames, double *largest_rounding) {
  for (uint32_t k = 0; frames->geometry != NULL && k < frames->loop.workers; ++k) {
    *largest_rounding = fmax(*largest_rounding, frames->geometry[k].largest_rounding);
    geometry_free(&frames->geometry[k]);
  }
  for (uint32_t k = 0; frames->frame != NULL && k < frames->loop.slots; ++k) {
    free(frames->frame[k].molecule.xyz);
    free(frames->frame[k].molecule.line);
    clear_findings(frames->work, &frames->frame[k]);
    free(frames->frame[k].findings);
    text_buffer_free(&frames->frame[k].out);
  }
  free(frames->geometry);
  free(frames->frame);
}

/* Choose as many workers as memory allows, and divide the threads that are left among them. */
static void share_out(struct frames *frames) {
  const uint32_t threads = request_threads(frames->request), atoms = frames->molecule->atoms;
  const uint32_t most = atoms < MOST_ATOMS ? MOST_ATOMS / (atoms + 1) + 1 : 1;
  struct in_order *const loop = &frames->loop;
  loop->workers = threads < most ? threads : most;
  loop->slots = loop->workers == 1 ? 1 : SLOTS_OF_WORKER * loop->workers;
}

bool command_frames(const struct request *request, const struct molecule *molecule, const struct frame_work *work,
                    double *largest_rounding, struct failure *failure) {
  struct frames frames = {.request = request,
                          .work = work,
                          .molecule = molecule,
                          .own = molecule->frame.box,
                          .loop = {.of = &frames, .take = take_frame, .work = work_on_frame, .give = print_frame},
                          .failure = failure};
  share_out(&frames);
  const uint32_t workers = frames.loop.workers;
  frames.progress = progress_begin(workers > 1, 1);
  if (workers > 1) progress_be_quiet();
  bool done = trajectory_format_of(request->trajectory, request->format, &frames.trajectory, failure);
  frames.trajectory.location = request->choice.location;
  done = done && trajectory_open(&frames.trajectory, request->trajectory, molecule->read, failure) &&
         allocate(&frames, failure);
  for (uint32_t k = 0; done && k < workers; ++k) {
    frames.geometry[k].progress = progress_begin(molecule->atoms, PROGRESS_LEAST_BALLS);
    geometry_share_work(&frames.geometry[k], request_threads(request) / workers, molecule->atoms);
  }
  frames.begin = *failure;
  if (done) done = in_order_run(&frames.loop) || failure_of_memory(failure);
  done = done && check_number(&frames, failure);
  progress_end(&frames.progress);
  release(&frames, largest_rounding);
  trajectory_close(&frames.trajectory);
  return done;
}
