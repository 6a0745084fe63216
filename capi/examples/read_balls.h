/* Balls from a file, for examples: x y z r on each line, # begins a comment. */
#ifndef READ_BALLS_H
#define READ_BALLS_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct balls {
  uint32_t count;
  double *xyz;    /* [count][3] */
  double *radius; /* [count] */
};

static inline int add_ball(struct balls *balls, const double ball[4]) {
  double *xyz = realloc(balls->xyz, ((size_t)balls->count + 1) * 3 * sizeof *xyz);
  if (xyz != NULL) balls->xyz = xyz;
  double *radius = realloc(balls->radius, ((size_t)balls->count + 1) * sizeof *radius);
  if (radius != NULL) balls->radius = radius;
  if (xyz == NULL || radius == NULL) return 0;
  memcpy(xyz + 3 * (size_t)balls->count, ball, 3 * sizeof *xyz);
  radius[balls->count++] = ball[3];
  return 1;
}

/* Adds the balls of a file; says on stderr why it cannot, and returns 0 then. */
static inline int read_balls(const char *path, struct balls *balls) {
  FILE *file = fopen(path, "r");
  if (file == NULL) {
    perror(path);
    return 0;
  }
  char line[512];
  int good = 1;
  while (good && fgets(line, sizeof line, file) != NULL) {
    double ball[4];
    int next = '\n', cut = 0;
    if (strchr(line, '\n') == NULL) {
      while ((next = getc(file)) != '\n' && next != EOF) cut = 1;
    }
    good = !cut || strchr(line, '#') != NULL; /* of long lines only the comments are cut off */
    line[strcspn(line, "#")] = '\0';
    if (!good || line[strspn(line, " \t\r\n")] == '\0') continue;
    good = sscanf(line, "%lf %lf %lf %lf", &ball[0], &ball[1], &ball[2], &ball[3]) == 4 && add_ball(balls, ball);
  }
  if (ferror(file)) {
    perror(path);
    fclose(file);
    return 0;
  }
  fclose(file);
  if (!good) fprintf(stderr, "%s: expected x y z r on each line\n", path);
  return good;
}

static inline void free_balls(struct balls *balls) {
  free(balls->xyz);
  free(balls->radius);
}

#endif
