#include "commands/followed_run.h"

#include "commands/pictures.h"

bool follow_run(const struct request *request, const struct molecule *molecule, struct frame_work work,
                const char *what, double *largest_rounding, struct failure *failure) {
  struct followed_run run = {.request = request, .followed = {.keeps_volumes = request->plot != NULL}};
  work.of = &run;
  const bool done = command_frames(request, molecule, &work, largest_rounding, failure) &&
                    (request->plot == NULL || pictures.volumes(&run.followed, molecule, what, request->plot, failure));
  followed_free(&run.followed);
  return done;
}
