/* The pictures of a movie: the balls turn once about the upright axis, in a frame that stays.
 *   turntable FILE.xyzr PREFIX [FRAMES]      x y z r on each line; writes PREFIX000.svg, PREFIX001.svg, ...
 * The frame is centred on the middle of the balls and as large as what they sweep, so that nothing is cut off and
 * nothing but the turn moves. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../read_balls.h"

/* Of the pictures, px. */
static const double side = 600.0;

static int32_t write_bytes(void *context, const char *bytes, size_t count) {
  return fwrite(bytes, 1, count, context) != count;
}

/* From the middle of the box of the centres to the farthest point of any ball. */
static double reach_of(const struct balls *balls, double centre[3]) {
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double low = 0.0, high = 0.0;
    for (size_t i = 0; i < balls->count; ++i) {
      const double x = balls->xyz[3 * i + (size_t)axis];
      if (i == 0 || x < low) low = x;
      if (i == 0 || x > high) high = x;
    }
    centre[axis] = (low + high) / 2;
  }
  for (size_t i = 0; i < balls->count; ++i) {
    const double *c = balls->xyz + 3 * i;
    const double x = c[0] - centre[0], y = c[1] - centre[1], z = c[2] - centre[2];
    const double far_end = sqrt(x * x + y * y + z * z) + balls->radius[i];
    if (far_end > reach) reach = far_end;
  }
  return reach;
}

static int32_t write_frame(hsp_workspace *work, double angle, const hsp_picture_options *picture, const char *path) {
  hsp_view_options options;
  int32_t status = hsp_view_options_init(&options, sizeof options);
  if (status == HSP_OK) status = hsp_view_options_turn(&options, 0.0, angle, 0.0);
  if (status == HSP_OK) status = hsp_workspace_view(work, 0, &options);
  if (status != HSP_OK) return status;
  FILE *file = fopen(path, "wb");
  if (file == NULL) return HSP_E_SINK;
  status = hsp_picture_write(work->view, NULL, picture, path, NULL, write_bytes, file, NULL);
  return fclose(file) == 0 ? status : HSP_E_SINK;
}

static int32_t write_frames(const struct balls *balls, const char *prefix, int frames) {
  hsp_workspace work = {0};
  hsp_picture_options picture;
  int32_t status = hsp_picture_options_init(&picture, sizeof picture);
  const double reach = reach_of(balls, picture.centre);
  picture.width = picture.height = side;
  picture.scale = reach > 0.0 ? side / (2.1 * reach) : 1.0;
  if (status == HSP_OK) status = hsp_workspace_set(&work, balls->count, balls->xyz, balls->radius, NULL, NULL);
  if (status != HSP_OK) fprintf(stderr, "turntable: %s\n", hsp_status_text(status));
  for (int frame = 0; frame < frames && status == HSP_OK; ++frame) {
    char path[4096];
    const int length = snprintf(path, sizeof path, "%s%03d.svg", prefix, frame);
    status = length < 0 || (size_t)length >= sizeof path ? HSP_E_SINK
                                                         : write_frame(&work, 360.0 * frame / frames, &picture, path);
    if (status != HSP_OK) fprintf(stderr, "turntable: %s: %s\n", path, hsp_status_text(status));
  }
  hsp_workspace_free(&work);
  return status;
}

int main(int count, char **arguments) {
  const int frames = count == 4 ? atoi(arguments[3]) : 36;
  if (count < 3 || count > 4 || frames < 1 || frames > 1000) {
    fprintf(stderr, "usage: turntable FILE.xyzr PREFIX [FRAMES]\n");
    return 2;
  }
  struct balls balls = {0, NULL, NULL};
  const int good = read_balls(arguments[1], &balls) && write_frames(&balls, arguments[2], frames) == HSP_OK;
  free_balls(&balls);
  if (good) printf("%s000.svg to %s%03d.svg, %.0f x %.0f px\n", arguments[2], arguments[2], frames - 1, side, side);
  return good ? 0 : 1;
}
