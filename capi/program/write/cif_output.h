/* Pieces of .cif files. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "read/text_buffer.h"

/* A value, in quotes if it needs them, and a blank. An empty text is written as ".", no value. */
void cif_text(struct text_buffer *out, const char *text);

/* "loop_" and its items, [count] of a category. */
void cif_loop(struct text_buffer *out, const char *category, const char *const *items, size_t count);

/* An atom, or a point that viewers are to show as one; texts may be empty. */
struct site {
  const char *group; /* ATOM or HETATM */
  const char *element, *atom, *residue, *chain, *number, *insertion;
  const double *xyz; /* [3] */
  double value;      /* the temperature factor */
};

/* The lines before all atoms, and the line of each atom; `serial` counts them from 1. */
void cif_sites_begin(struct text_buffer *out);
void cif_site(struct text_buffer *out, uint32_t serial, const struct site *site);
