/* Area, volume and largest gradient of the area for every frame of a trajectory:
 *   frames FILE.pdb [PROBE]       a .pdb file with MODEL ... ENDMDL for each frame
 * One workspace serves all frames. It grows only when a frame needs more than all before it. */
#define _POSIX_C_SOURCE 200112L /* isatty, fileno */

#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct frame {
  uint32_t atoms;
  uint32_t capacity;
  double *xyz;      /* [capacity][3] */
  double *radius;   /* [capacity] */
  double *gradient; /* [capacity][3] */
};

static int grow_array(double **array, size_t count) {
  double *larger = realloc(*array, count * sizeof **array);
  if (larger != NULL) *array = larger;
  return larger != NULL;
}

static int make_room(struct frame *frame) {
  if (frame->atoms < frame->capacity) return 1;
  const size_t capacity = 2 * (size_t)frame->capacity + 64;
  if (!grow_array(&frame->xyz, 3 * capacity) || !grow_array(&frame->radius, capacity) ||
      !grow_array(&frame->gradient, 3 * capacity)) {
    return 0;
  }
  frame->capacity = (uint32_t)capacity;
  return 1;
}

/* The element stands in columns 77-78, or begins the atom's name. An atom that is none of these counts as carbon. */
static double radius_of(const char *line, size_t length) {
  const char *name = line + 12 + strspn(line + 12, " 0123456789");
  const char first[] = {*name, '\0'};
  const char columns[] = {length >= 78 ? line[76] : '\0', length >= 78 ? line[77] : '\0', '\0'};
  uint32_t number = 6;
  double radius = 0.0;
  if (hsp_element_number(columns, &number) != HSP_OK) (void)hsp_element_number(first, &number);
  (void)hsp_element_radius(HSP_RADII_BONDI, number, &radius, NULL);
  return radius;
}

static int read_atom(struct frame *frame, const char *line) {
  const size_t length = strcspn(line, "\r\n");
  if (length < 54) return 0;
  if (line[16] != ' ' && line[16] != 'A') return 1; /* an alternate location */
  if (!make_room(frame)) return 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    char columns[9] = "";
    char *end;
    memcpy(columns, line + 30 + 8 * axis, 8);
    frame->xyz[3 * (size_t)frame->atoms + axis] = strtod(columns, &end);
    if (end == columns) return 0;
  }
  frame->radius[frame->atoms++] = radius_of(line, length);
  return 1;
}

/* The next frame: 1, none left: 0, not understood: -1. */
static int read_frame(FILE *file, struct frame *frame) {
  char line[512];
  frame->atoms = 0;
  while (fgets(line, sizeof line, file) != NULL) {
    if (strncmp(line, "ATOM", 4) == 0 || strncmp(line, "HETATM", 6) == 0) {
      if (!read_atom(frame, line)) return -1;
    } else if (strncmp(line, "ENDMDL", 6) == 0) {
      return 1;
    }
  }
  return frame->atoms > 0;
}

struct trajectory {
  hsp_workspace work;
  unsigned sizings; /* how often it was made larger */
};

/* The workspace grows only if a frame needs more than all before it. */
static int32_t compute(struct trajectory *trajectory, struct frame *frame, double probe, hsp_energy *energy) {
  hsp_workspace *work = &trajectory->work;
  const hsp_boundary_limits limits = work->boundary_limits;
  const uint32_t most_balls = work->most_balls;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) status = hsp_workspace_set(work, frame->atoms, frame->xyz, frame->radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status != HSP_OK) return status;
  if (work->most_balls != most_balls || memcmp(&work->boundary_limits, &limits, sizeof limits) != 0) {
    ++trajectory->sizings;
  }
  const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1.0};
  hsp_gradient_outputs outputs = {
      .struct_size = sizeof outputs, .capacity = frame->atoms, .energy = energy, .d_centre = frame->gradient};
  return hsp_boundary_get_gradient(work->boundary, &area, &outputs);
}

static double largest_norm(const struct frame *frame) {
  double largest = 0.0;
  for (size_t i = 0; i < frame->atoms; ++i) {
    const double *g = frame->gradient + 3 * i;
    const double square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if (square > largest) largest = square;
  }
  return sqrt(largest);
}

static int run(FILE *file, double probe, struct trajectory *trajectory, struct frame *frame) {
  const int watched = isatty(fileno(stderr)); /* a log file wants no progress */
  unsigned long number = 0;
  int found;
  printf("%8s %8s %16s %16s %16s\n", "frame", "atoms", "area", "volume", "largest dA/dc");
  while ((found = read_frame(file, frame)) > 0) {
    hsp_energy energy;
    const int32_t status = compute(trajectory, frame, probe, &energy);
    ++number;
    if (status != HSP_OK) {
      fprintf(stderr, "frames: frame %lu: %s\n", number, hsp_status_text(status));
      return 0;
    }
    printf("%8lu %8lu %16.6f %16.6f %16.6f\n", number, (unsigned long)frame->atoms, energy.area, energy.volume,
           largest_norm(frame));
    if (watched) fprintf(stderr, "\rframe %lu", number);
  }
  if (watched) fprintf(stderr, "\n");
  if (found < 0) fprintf(stderr, "frames: frame %lu: not an atom record\n", number + 1);
  if (ferror(file)) fprintf(stderr, "frames: the file cannot be read\n");
  printf("# frames: %lu; memory sized: %u\n", number, trajectory->sizings);
  return found == 0 && !ferror(file);
}

int main(int count, char **arguments) {
  if (count < 2 || count > 3) {
    fprintf(stderr, "usage: frames FILE.pdb [PROBE]\n");
    return 2;
  }
  FILE *file = fopen(arguments[1], "r");
  if (file == NULL) {
    perror(arguments[1]);
    return 1;
  }
  struct trajectory trajectory;
  struct frame frame = {0, 0, NULL, NULL, NULL};
  memset(&trajectory, 0, sizeof trajectory);
  const int done = run(file, count == 3 ? strtod(arguments[2], NULL) : 0.0, &trajectory, &frame);
  fclose(file);
  hsp_workspace_free(&trajectory.work);
  free(frame.xyz);
  free(frame.radius);
  free(frame.gradient);
  return done ? 0 : 1;
}
