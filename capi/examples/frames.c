/* Area, volume and largest gradient of the area for every frame of a trajectory:
 *   frames FILE.pdb [PROBE]       a .pdb file with MODEL ... ENDMDL for each frame
 * One workspace serves all frames. It is made anew only when a frame needs more than the largest before it. */
#define _POSIX_C_SOURCE 200112L /* isatty, fileno */

#include <hardsphere.h>
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

/* The element stands in columns 77-78, or begins the atom's name. Radii of Bondi, in angstrom. */
static double radius_of(const char *line, size_t length) {
  static const char symbols[] = "HCNOSP";
  static const double radii[] = {1.10, 1.70, 1.55, 1.52, 1.80, 1.80};
  const char *name = line + 12 + strspn(line + 12, " 0123456789");
  const char symbol = length >= 78 && line[77] != ' ' ? line[77] : *name;
  const char *found = symbol == '\0' ? NULL : strchr(symbols, symbol);
  return found == NULL ? 1.70 : radii[found - symbols];
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

struct workspace {
  void *model_memory;
  void *boundary_memory;
  hsp_model *model;
  hsp_boundary *boundary;
  uint32_t balls; /* that the model has room for */
  hsp_boundary_limits limits;
  unsigned sizings; /* how often memory was asked for */
};

static int32_t size_model(struct workspace *work, uint32_t balls) {
  size_t bytes = 0;
  int32_t status = hsp_model_bytes(balls, &bytes);
  if (status != HSP_OK) return status;
  free(work->model_memory);
  work->model_memory = malloc(bytes);
  if (work->model_memory == NULL) return HSP_E_MEMORY;
  work->balls = balls;
  return hsp_model_init(work->model_memory, bytes, balls, &work->model);
}

static int32_t size_boundary(struct workspace *work) {
  size_t bytes = 0;
  const int32_t status = hsp_boundary_bytes(&work->limits, &bytes);
  if (status != HSP_OK) return status;
  free(work->boundary_memory);
  work->boundary_memory = malloc(bytes);
  if (work->boundary_memory == NULL) return HSP_E_MEMORY;
  ++work->sizings;
  return hsp_boundary_init(work->boundary_memory, bytes, &work->limits, &work->boundary);
}

static void enlarge(uint32_t *limit, uint32_t needed) {
  if (needed > *limit) *limit = needed;
}

/* Room for a molecule of so many atoms, and for no less than any frame before needed. */
static int32_t size_for(struct workspace *work, uint32_t balls) {
  hsp_boundary_limits usual;
  int32_t status = hsp_boundary_limits_init(&usual, sizeof usual, balls);
  if (status == HSP_OK) status = size_model(work, balls);
  if (status != HSP_OK) return status;
  work->limits.struct_size = usual.struct_size;
  enlarge(&work->limits.balls, usual.balls);
  enlarge(&work->limits.neighbours, usual.neighbours);
  enlarge(&work->limits.vertices, usual.vertices);
  enlarge(&work->limits.circles, usual.circles);
  return size_boundary(work);
}

/* Compute the boundary; enlarge its limits only if they turn out too small. */
static int32_t compute_boundary(struct workspace *work) {
  for (int attempt = 0; attempt < 4; ++attempt) {
    int32_t status = hsp_boundary_compute(work->boundary, work->model);
    if (status != HSP_E_CAPACITY) return status;
    hsp_boundary_limits needed;
    status = hsp_boundary_get_needed(work->boundary, &needed);
    if (status != HSP_OK) return status;
    enlarge(&work->limits.balls, needed.balls);
    enlarge(&work->limits.neighbours, needed.neighbours);
    enlarge(&work->limits.vertices, needed.vertices);
    enlarge(&work->limits.circles, needed.circles);
    status = size_boundary(work);
    if (status != HSP_OK) return status;
  }
  return HSP_E_CAPACITY;
}

static int32_t compute(struct workspace *work, struct frame *frame, double probe, hsp_energy *energy) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK && (work->model == NULL || frame->atoms > work->balls)) status = size_for(work, frame->atoms);
  if (status == HSP_OK) status = hsp_model_set(work->model, frame->atoms, frame->xyz, frame->radius, &options, NULL);
  if (status == HSP_OK) status = compute_boundary(work);
  if (status != HSP_OK) return status;
  return hsp_boundary_gradient(work->boundary, NULL, 1.0, 0.0, HSP_TANGENT_OVERLAP, energy, frame->gradient, NULL, NULL,
                               frame->atoms);
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

static int run(FILE *file, double probe, struct workspace *work, struct frame *frame) {
  const int watched = isatty(fileno(stderr)); /* a log file wants no progress */
  unsigned long number = 0;
  int found;
  printf("%8s %8s %16s %16s %16s\n", "frame", "atoms", "area", "volume", "largest dA/dc");
  while ((found = read_frame(file, frame)) > 0) {
    hsp_energy energy;
    const int32_t status = compute(work, frame, probe, &energy);
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
  printf("# frames: %lu; memory sized: %u\n", number, work->sizings);
  return found == 0;
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
  struct workspace work;
  struct frame frame = {0, 0, NULL, NULL, NULL};
  memset(&work, 0, sizeof work);
  const int done = run(file, count == 3 ? strtod(arguments[2], NULL) : 0.0, &work, &frame);
  fclose(file);
  free(work.model_memory);
  free(work.boundary_memory);
  free(frame.xyz);
  free(frame.radius);
  free(frame.gradient);
  return done ? 0 : 1;
}
