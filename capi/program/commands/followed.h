/* Cavities that are followed from frame to frame by the atoms around them, and their volumes. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/molecule.h"
#include "write/table.h"

/* A cavity of a frame. */
struct cavity {
  const uint32_t *balls; /* [ball_count] the balls around it, each once */
  uint32_t ball_count;
  double volume; /* NaN: not known */
  /* Found by followed_take: */
  uint32_t number;        /* from 1 on, the same in all frames */
  uint32_t from;          /* if it split off from a cavity of the frame before: the number of that one; else 0 */
  const uint32_t *merged; /* [merged_count] cavities of the frame before that have ended and are in it now */
  uint32_t merged_count;
};

/* All cavities so far. Zeros at first. */
struct followed {
  struct followed_cavity *known; /* [numbers] */
  uint32_t numbers;
  size_t room;
  uint64_t frames;
  uint32_t *merged; /* of the last frame */
  bool keeps_volumes;
  struct followed_volume {
    uint64_t frame, place; /* the frame's number in the trajectory, and its place among those taken */
    uint32_t number;
    double volume;
  } * volumes; /* [volume_count], by frames */
  size_t volume_count, volume_room;
  uint64_t first_frame, last_frame;
};

/* Give the cavities of the next frame their numbers. A cavity may be the same as one of the frame before if they share
 * at least half of the atoms of that with fewer atoms. Pairs that share the largest part of the atoms that either has
 * are chosen first: if a cavity splits, the part with more of it keeps its number; if two merge, the result has the
 * number of the one that makes up more of it. A cavity that closes and opens again has its number again. New numbers
 * are given in the order of the list. */
bool followed_take(struct followed *followed, const struct molecule *molecule, struct cavity *cavities, uint32_t count,
                   struct failure *failure);

/* The columns about following, beside the number, which stand behind all others of a table; and their cells. */
enum { FOLLOWED = 2 };
#define FOLLOWED_COLUMNS                               \
  {"from", NULL, NULL, 0, COLUMN_RESIDUE_NUMBER, 0}, { \
    "merged", "", NULL, 0, COLUMN_COUNTS, 0            \
  }
void followed_cells(const struct cavity *cavity, union cell *number, union cell more[FOLLOWED], char text[CELL_BYTES]);

void followed_free(struct followed *followed);
