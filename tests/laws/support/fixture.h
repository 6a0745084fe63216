/* The fixture of all laws: a small set of balls, and handles of each kind over it, with results and without, which are
 * the arguments of the calls. */
#pragma once

#include "registry.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { FIXTURE_BALLS = 9, FIXTURE_STICK_END = 6, LIMIT_BYTES = 64 };

typedef struct fixture {
  uint32_t balls; /* how many of the fixture's balls there are: the first ones */
  /* Of each kind: the handle with results, its memory and the limits that it was made with. */
  void *handle[NOUNS], *memory[NOUNS];
  size_t bytes[NOUNS];
  unsigned char limits[NOUNS][LIMIT_BYTES];
  void *fresh[NOUNS], *fresh_memory[NOUNS]; /* without results */
  /* For functions that take two handles of a kind. */
  void *moving_body;
  hsp_model *spare_model;
  void *spare_memory[2];
  /* Summaries of bricks: one brick that is all, with its shells, and two that make all. */
  unsigned char *summary[3];
  size_t summary_bytes[3];
  void *refused[NOUNS], *refused_memory[NOUNS]; /* a model and a body whose set has failed */
} fixture;
extern fixture given;

extern const double fixture_xyz[FIXTURE_BALLS][3], fixture_radius[FIXTURE_BALLS], fixture_box[9];
extern const double fixture_outside[3]; /* a point that no ball is near to */
extern const double fixture_probe, fixture_edge, fixture_stick_radius, fixture_floor;
#if HSP_HAS_SIGHT
extern const hsp_stick fixture_stick;
#endif

/* Makes `given` anew, of the first `balls` balls. The program ends if a call fails. */
void fixture_make(uint32_t balls);

/* Makes the handle of a kind again where it is, with the same results; what was made from it can be read again. */
void fixture_make_again(int noun);

/* The model is set to the balls of the fixture, or to others. */
void fixture_set_model(void);
void fixture_set_other_balls(void);

/* hsp_X_bytes and hsp_X_init of a kind. Limits of a model and of a body are a number of balls. */
int32_t handle_bytes(int noun, void *limits, size_t *bytes);
int32_t handle_init(int noun, void *memory, size_t bytes, void *limits, void **handle);

/* Whether the function is one that makes new contents of its first handle: a set or a computation. */
int replaces_contents(const function *f);

/* Whether argument i is a handle whose contents the function has to know. */
int reads_contents(const function *f, int i);

/* Whether results of a kind look into the model or boundary when they are read. */
int depends_on(int noun, int base);

#ifdef __cplusplus
}
#endif
