#include "draw/contour_pieces.h"

#include <math.h>
#include <stdlib.h>

#include "read/growing_array.h"

void contour_pieces_add(struct contour_pieces *pieces, const struct contour_piece *piece) {
  pieces->out_of_memory =
      pieces->out_of_memory || !array_append(&pieces->piece, &pieces->count, &pieces->room, piece, sizeof *piece);
}

void contour_pieces_free(struct contour_pieces *pieces) {
  free(pieces->piece);
}

double contour_piece_length(const struct contour_piece *piece) {
  const double x = piece->at[1][0] - piece->at[0][0], y = piece->at[1][1] - piece->at[0][1];
  return sqrt(x * x + y * y);
}

/* Another contour goes on where an outline ends, which is only rounded off. */
static const double steeper = 4.0;

static double slope_of(const struct contour_piece *piece, double slope) {
  return piece->outline ? steeper * slope : slope;
}

double contour_piece_level(const struct contour_piece *piece, double most_slope, double share) {
  const double length = contour_piece_length(piece), slope = slope_of(piece, most_slope);
  const double from = piece->most[0] + slope * share * length, to = piece->most[1] + slope * (1.0 - share) * length;
  return fmin(piece->level, fmin(from, to));
}

/* The pieces that meet at a vertex: the number of all, and of those with a level; and two of each kind. */
struct meeting {
  uint32_t all, drawn;
  bool goes_on;
  size_t of_all[2], of_drawn[2];
};

struct chains {
  struct contour_pieces *pieces;
  struct meeting *meeting; /* [vertices] */
  double *most;            /* [vertices] */
  uint32_t vertices;
};

static void find_meetings(const struct chains *chains) {
  for (uint32_t v = 0; v < chains->vertices; ++v) chains->meeting[v] = (struct meeting){0, 0, false, {0, 0}, {0, 0}};
  for (size_t i = 0; i < chains->pieces->count; ++i) {
    for (int end = 0; end < 2; ++end) {
      const struct contour_piece *const piece = &chains->pieces->piece[i];
      if (piece->vertex[end] == NO_CONTOUR_VERTEX) continue;
      struct meeting *const meeting = &chains->meeting[piece->vertex[end]];
      if (piece->goes_on) meeting->goes_on = true;
      if (piece->goes_on) continue;
      if (meeting->all < 2) meeting->of_all[meeting->all] = i;
      ++meeting->all;
      if (piece->level > 0.0 && meeting->drawn < 2) meeting->of_drawn[meeting->drawn] = i;
      if (piece->level > 0.0) ++meeting->drawn;
    }
  }
}

/* The other one of two pieces that meet at a vertex and no others do; itself if there is none. */
static size_t next_of(const struct chains *chains, size_t piece, uint32_t vertex, bool drawn) {
  if (vertex == NO_CONTOUR_VERTEX) return piece;
  const struct meeting *const meeting = &chains->meeting[vertex];
  if ((drawn ? meeting->drawn : meeting->all) != 2) return piece;
  const size_t *const two = drawn ? meeting->of_drawn : meeting->of_all;
  return two[two[0] == piece ? 1 : 0];
}

static uint32_t other_end(const struct contour_piece *piece, uint32_t vertex) {
  return piece->vertex[piece->vertex[0] == vertex ? 1 : 0];
}

/* From an end of a piece follow others with lower levels: they are raised to its level if a piece with that level
 * follows soon. */
static void raise_levels(const struct chains *chains, size_t piece, uint32_t vertex, double level, double longest) {
  struct contour_piece *const all = chains->pieces->piece;
  for (int pass = 0; pass < 2; ++pass) {
    double length = 0.0;
    uint32_t to = vertex;
    for (size_t at = piece;;) {
      const size_t next = next_of(chains, at, to, false);
      if (next == at) return;
      if (all[next].level >= level) break;
      length += contour_piece_length(&all[next]);
      if (length > longest) return;
      if (pass == 1) all[next].level = level;
      to = other_end(&all[next], to);
      at = next;
    }
  }
}

static void close_gaps(const struct chains *chains, const struct contour_limits *limits) {
  for (size_t i = 0; i < chains->pieces->count; ++i) {
    const struct contour_piece *const piece = &chains->pieces->piece[i];
    for (int end = 0; end < 2 && piece->level > 0.0; ++end) {
      raise_levels(chains, i, piece->vertex[end], piece->level, limits->dip);
      raise_levels(chains, i, piece->vertex[end], limits->thin, limits->gap);
    }
  }
}

static bool ends_alone(const struct chains *chains, uint32_t vertex) {
  return vertex != NO_CONTOUR_VERTEX && chains->meeting[vertex].drawn == 1;
}

/* A contour that ends alone, as far as nothing meets it and it is no outline: no level if it has hardly any ink. */
static void drop_spur(const struct chains *chains, size_t piece, uint32_t vertex, double ink) {
  struct contour_piece *const all = chains->pieces->piece;
  double own = 0.0;
  for (int pass = 0; pass < 2 && own < ink; ++pass) {
    uint32_t to = vertex;
    for (size_t at = piece, last = SIZE_MAX; at != last && own < ink && !all[at].outline;) {
      own += pass == 0 ? all[at].level * contour_piece_length(&all[at]) : 0.0;
      if (pass == 1) all[at].level = 0.0;
      to = other_end(&all[at], to);
      last = at;
      at = next_of(chains, last, to, true);
    }
  }
}

/* No level is more than another one and the slope from there. */
static void limit_levels(const struct chains *chains, double slope) {
  struct contour_pieces *const pieces = chains->pieces;
  for (uint32_t v = 0; v < chains->vertices; ++v) {
    if (ends_alone(chains, v) && !pieces->piece[chains->meeting[v].of_drawn[0]].outline) chains->most[v] = 0.0;
  }
  bool changed = true;
  while (changed) {
    changed = false;
    for (size_t i = 0; i < pieces->count; ++i) {
      struct contour_piece *const piece = &pieces->piece[i];
      if (piece->level == 0.0) continue;
      for (int end = 0; end < 2; ++end) {
        const uint32_t to = piece->vertex[end], from = piece->vertex[1 - end];
        if (to == NO_CONTOUR_VERTEX || chains->meeting[to].drawn > 2) continue;
        const double before = from == NO_CONTOUR_VERTEX ? INFINITY : chains->most[from];
        const double most = fmin(piece->level, before + slope_of(piece, slope) * contour_piece_length(piece));
        if (!(most < chains->most[to])) continue;
        chains->most[to] = most;
        changed = true;
      }
    }
  }
  for (size_t i = 0; i < pieces->count; ++i) {
    for (int end = 0; end < 2; ++end) {
      const uint32_t vertex = pieces->piece[i].vertex[end];
      pieces->piece[i].most[end] = vertex == NO_CONTOUR_VERTEX ? INFINITY : chains->most[vertex];
    }
  }
}

bool contour_pieces_level(struct contour_pieces *pieces, uint32_t vertices, const struct contour_limits *limits) {
  const struct chains chains = {pieces, calloc((size_t)vertices + 1, sizeof *chains.meeting),
                                calloc((size_t)vertices + 1, sizeof *chains.most), vertices};
  const bool enough = chains.meeting != NULL && chains.most != NULL && !pieces->out_of_memory;
  if (enough) {
    find_meetings(&chains);
    close_gaps(&chains, limits);
    find_meetings(&chains);
    /* Outlines keep their width where a spur is dropped. */
    for (uint32_t v = 0; v < vertices; ++v) {
      const bool whole = chains.meeting[v].goes_on && pieces->piece[chains.meeting[v].of_drawn[0]].outline;
      chains.most[v] = ends_alone(&chains, v) && !whole ? 0.0 : INFINITY;
    }
    for (size_t i = 0; i < pieces->count; ++i) {
      for (int end = 0; end < 2; ++end) {
        const uint32_t vertex = pieces->piece[i].vertex[end];
        if (pieces->piece[i].level > 0.0 && ends_alone(&chains, vertex)) drop_spur(&chains, i, vertex, limits->ink);
      }
    }
    find_meetings(&chains);
    limit_levels(&chains, limits->slope);
  }
  free(chains.meeting);
  free(chains.most);
  return enough;
}
