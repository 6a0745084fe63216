/* Charts of pores: the radius along tunnels, and the tree of classes. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/pores_found.h"
#include "draw/chart.h"
#include "draw/pocket_colours.h"
#include "draw/smooth_curve.h"
#include "draw/text_width.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

/* Pixels. */
enum { LEFT = 72, TOP = 20, WIDTH = 640, RIGHT = 40, PROFILE_HEIGHT = 320, BELOW = 60, LEGEND_ROW = 18 };
enum { NAME_BYTES = 96 };

/* ---- the radius along tunnels ---- */

#define TUNNEL_LINE 1.5
#define SHARED_LINE 3.5 /* more of it for each tunnel on the same way */
#define SHARED_EDGE 1.0 /* that is seen of it, on both sides */

struct profile {
  const struct pores_found *found;
  double *slope; /* [steps] of the radius */
  struct chart_frame frame;
  struct chart_scale across, up;
};

static void path_begin(struct text_buffer *out, const char *colour, double width) {
  text_buffer_add(out, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" stroke-linejoin=\"round\"", colour,
                  width);
}

static void add_dash(struct text_buffer *out, uint32_t tunnel) {
  if (chart_dash(tunnel) > 0) text_buffer_add(out, " stroke-dasharray=\"%d 2\"", chart_dash(tunnel));
}

static void add_dashed(struct text_buffer *out, double x0, double y0, double x1, double y1) {
  text_buffer_add(out, "<path stroke=\"" CHART_GREY "\" stroke-dasharray=\"4 3\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", x0,
                  y0, x1, y1);
}

enum { MOST_SHARED = 4 };

/* How many tunnels before this one have the step, and the one before it. */
static int shared_by(const struct pores_found *found, size_t step) {
  const struct tunnel_step *const to = &found->steps[step], *const from = to - 1;
  int count = 0;
  for (size_t i = 1; i < step && count < MOST_SHARED; ++i) {
    const struct tunnel_step *const other = &found->steps[i];
    if (other->tunnel >= to->tunnel || (other - 1)->tunnel != other->tunnel) continue;
    if (memcmp(other->point.xyz, to->point.xyz, sizeof to->point.xyz) != 0 || other->length != to->length) continue;
    if (memcmp((other - 1)->point.xyz, from->point.xyz, sizeof from->point.xyz) == 0) ++count;
  }
  return count;
}

static void add_start(struct text_buffer *out, const struct profile *profile, size_t step) {
  const struct tunnel_step *const at = &profile->found->steps[step];
  text_buffer_add(out, "M%.2f %.2f", chart_x(&profile->frame, &profile->across, at->length),
                  chart_y(&profile->frame, &profile->up, at->point.radius));
}

/* From the step before. */
static void add_step(struct text_buffer *out, const struct profile *profile, size_t step) {
  const struct tunnel_step *const to = &profile->found->steps[step], *const from = to - 1;
  const double third = (to->length - from->length) / 3.0;
  const double at[3][2] = {{from->length + third, from->point.radius + profile->slope[step - 1] * third},
                           {to->length - third, to->point.radius - profile->slope[step] * third},
                           {to->length, to->point.radius}};
  for (int k = 0; k < 3; ++k) {
    text_buffer_add(out, "%s%.2f %.2f", k == 0 ? "C" : " ", chart_x(&profile->frame, &profile->across, at[k][0]),
                    chart_y(&profile->frame, &profile->up, at[k][1]));
  }
}

/* A wide line with a white one in it, so that no colour touches that of a narrower line within. */
static void add_wide(struct text_buffer *out, const char *colour, int shared, const struct text_buffer *way) {
  const double wide = TUNNEL_LINE + SHARED_LINE * shared;
  for (int inner = 0; inner < 2; ++inner) {
    path_begin(out, inner == 0 ? colour : "#ffffff", inner == 0 ? wide : wide - 2.0 * SHARED_EDGE);
    text_buffer_add_text(out, " d=\"");
    text_buffer_append(out, way->text, way->length);
    text_buffer_add_text(out, "\"/>\n");
  }
  out->out_of_memory = out->out_of_memory || way->out_of_memory;
}

/* Where a tunnel goes the way of earlier ones, it is wider, and so seen on both sides of theirs. False: nowhere. */
static bool add_shared(struct text_buffer *out, const struct profile *profile, uint32_t tunnel) {
  struct text_buffer way = TEXT_BUFFER_EMPTY;
  int before = 0;
  bool any = false;
  for (size_t i = 1; i <= profile->found->step_count; ++i) {
    const struct tunnel_step *const step = &profile->found->steps[i - 1];
    const bool here = i < profile->found->step_count && step->tunnel == tunnel + 1 && (step + 1)->tunnel == tunnel + 1;
    const int shared = here ? shared_by(profile->found, i) : 0;
    if (before > 0 && shared != before) {
      add_wide(out, chart_colour(tunnel), before, &way);
      text_buffer_free(&way);
    }
    if (shared > 0 && shared != before) add_start(&way, profile, i - 1);
    if (shared > 0) add_step(&way, profile, i);
    any = any || shared > 0;
    before = shared;
  }
  return any;
}

static void add_line(struct text_buffer *out, const struct profile *profile, uint32_t tunnel) {
  path_begin(out, chart_colour(tunnel), TUNNEL_LINE);
  add_dash(out, tunnel);
  text_buffer_add_text(out, " d=\"");
  bool begun = false;
  for (size_t i = 0; i < profile->found->step_count; ++i) {
    if (profile->found->steps[i].tunnel != tunnel + 1) continue;
    (begun ? add_step : add_start)(out, profile, i);
    begun = true;
  }
  text_buffer_add_text(out, "\"/>\n");
}

static void add_ring(struct text_buffer *out, double x, double y, const char *colour) {
  text_buffer_add(out,
                  "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"4\" fill=\"#ffffff\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", x,
                  y, colour);
}

/* At the bottleneck. */
static void add_tightest(struct text_buffer *out, const struct profile *profile, uint32_t tunnel) {
  const struct tunnel_step *tightest = NULL;
  for (size_t i = 0; i < profile->found->step_count; ++i) {
    const struct tunnel_step *const step = &profile->found->steps[i];
    if (step->tunnel != tunnel + 1) continue;
    if (tightest == NULL || step->point.radius < tightest->point.radius) tightest = step;
  }
  if (tightest == NULL) return;
  add_ring(out, chart_x(&profile->frame, &profile->across, tightest->length),
           chart_y(&profile->frame, &profile->up, tightest->point.radius), chart_colour(tunnel));
}

/* A row for each tunnel, and for what else is drawn. */
static void add_profile_legend(struct text_buffer *out, const struct profile *profile, const char *sign, bool dashes,
                               bool shared) {
  const struct pores_found *const found = profile->found;
  const char *const blank = sign[0] == '\0' ? "" : " ";
  double y = profile->frame.top + profile->frame.height + BELOW - 6;
  for (uint32_t t = 0; t < found->tunnel_count; ++t, y += LEGEND_ROW) {
    const hsp_tunnel *const tunnel = &found->tunnels[t];
    text_buffer_add(out, "<path stroke=\"%s\" stroke-width=\"1.5\"", chart_colour(t));
    add_dash(out, t);
    text_buffer_add(out, " d=\"M%d %.1fh24\"/>\n", LEFT, y - 4.0);
    text_buffer_add(out, "<text x=\"%d\" y=\"%.1f\">tunnel %" PRIu32 ": bottleneck %.3f%s%s, length %.2f%s%s</text>\n",
                    LEFT + 32, y, t + 1, tunnel->radius, blank, sign, tunnel->length, blank, sign);
  }
  if (found->tunnel_count == 0) return;
  add_ring(out, LEFT + 12, y - 4.0, "#333333");
  chart_text(out, LEFT + 32, y, "start", "bottleneck");
  double x = LEFT + 160;
  if (shared) {
    const double wide[3] = {TUNNEL_LINE + SHARED_LINE, TUNNEL_LINE + SHARED_LINE - 2.0 * SHARED_EDGE, TUNNEL_LINE};
    for (int k = 0; k < 3; ++k) {
      path_begin(out, k == 1 ? "#ffffff" : "#333333", wide[k]);
      text_buffer_add(out, " d=\"M%.0f %.1fh24\"/>\n", x, y - 4.0);
    }
    chart_text(out, x + 32, y, "start", "on both sides: the same way as another");
    x += 290;
  }
  if (!dashes) return;
  add_dashed(out, x, y - 4.0, x + 24, y - 4.0);
  chart_text(out, x + 32, y, "start", "the narrowest probe of interest");
}

/* To be freed; NULL where memory is short. */
static double *find_slopes(const struct pores_found *found) {
  const size_t count = found->step_count;
  double *const slope = malloc((count + 1) * sizeof *slope), *const length = malloc((count + 1) * sizeof *length);
  double *const radius = malloc((count + 1) * sizeof *radius);
  const bool enough = slope != NULL && length != NULL && radius != NULL;
  for (size_t first = 0, end = 0; enough && first < count; first = end) {
    for (; end < count && found->steps[end].tunnel == found->steps[first].tunnel; ++end) {
      length[end] = found->steps[end].length;
      radius[end] = found->steps[end].point.radius;
    }
    smooth_curve_slopes(length + first, radius + first, end - first, slope + first);
  }
  free(length);
  free(radius);
  if (!enough) free(slope);
  return enough ? slope : NULL;
}

bool pores_write_profile(const struct pores_found *found, const struct molecule *molecule, const char *path,
                         struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  const uint32_t rows = found->tunnel_count > 0 ? found->tunnel_count + 1 : 0;
  double longest = 0.0, widest = 0.0;
  for (size_t i = 0; i < found->step_count; ++i) {
    longest = fmax(longest, found->steps[i].length);
    widest = fmax(widest, found->steps[i].point.radius);
  }
  double *const slope = find_slopes(found);
  if (slope == NULL) return failure_of_memory(failure);
  const struct profile profile = {found,
                                  slope,
                                  {LEFT + 0.5, TOP + 0.5, WIDTH, PROFILE_HEIGHT},
                                  chart_scale_of(0.0, longest > 0.0 ? longest : 1.0),
                                  chart_scale_of(0.0, widest > 0.0 ? widest : 1.0)};
  const double probe = found->request->probe;
  const bool dashes = probe > 0.0 && probe < profile.up.high;
  chart_begin(&out, LEFT + WIDTH + RIGHT, TOP + PROFILE_HEIGHT + BELOW + LEGEND_ROW * (int)rows, "Tunnels");
  chart_axes(&out, &profile.frame, &profile.across, &profile.up);
  chart_name_across(&out, &profile.frame, "length along the tunnel", molecule->format->sign);
  chart_name_up(&out, &profile.frame, "radius of the largest probe", molecule->format->sign);
  if (dashes) {
    const double y = chart_y(&profile.frame, &profile.up, probe);
    add_dashed(&out, LEFT, y, LEFT + WIDTH, y);
  }
  bool shared = false;
  for (uint32_t t = found->tunnel_count; t-- > 0;) shared = add_shared(&out, &profile, t) || shared;
  for (uint32_t t = found->tunnel_count; t-- > 0;) add_line(&out, &profile, t);
  for (uint32_t t = found->tunnel_count; t-- > 0;) add_tightest(&out, &profile, t);
  free(slope);
  add_profile_legend(&out, &profile, molecule->format->sign, dashes, shared);
  text_buffer_add_text(&out, "</svg>\n");
  const bool done = output_file_write_text(path, &out, failure);
  text_buffer_free(&out);
  return done;
}

/* ---- the tree of classes ---- */

/* Rows of the tree, each a class that is listed, from the outside or a class that meets no other on. Those that merge
 * into a class are below it, the widest gate first: so no line crosses another. */
struct tree {
  uint32_t *row;   /* [maxima], from 1 on; 0: it is not listed */
  uint32_t *class; /* [rows], in the order of rows */
  uint32_t rows;
};

/* A stack of classes, where *links has the next one below each of them. */
static void push(uint32_t *top, uint32_t *links, uint32_t maximum) {
  links[maximum] = *top;
  *top = maximum;
}

static bool order_tree(const struct pores_found *found, struct tree *tree) {
  const uint32_t maxima = found->counts.maxima, gates = found->counts.gates;
  uint32_t *const of_gate = malloc(((size_t)gates + 1) * sizeof *of_gate);
  uint32_t *const first =
      malloc(((size_t)maxima + 1) * sizeof *first); /* the last one that merges; [maxima]: outside */
  uint32_t *const next = malloc(((size_t)maxima + 1) * sizeof *next);
  tree->row = calloc((size_t)maxima + 1, sizeof *tree->row);
  tree->class = calloc((size_t)maxima + 1, sizeof *tree->class);
  const bool done = of_gate != NULL && first != NULL && next != NULL && tree->row != NULL && tree->class != NULL;
  if (done) {
    uint32_t stack = HSP_NONE;
    for (uint32_t g = 0; g < gates; ++g) of_gate[g] = HSP_NONE;
    for (uint32_t m = 0; m <= maxima; ++m) first[m] = HSP_NONE;
    for (uint32_t m = maxima; m-- > 0;) {
      if (!pores_lists_maximum(found, m)) continue;
      if (found->maxima[m].gate == HSP_NONE) push(&stack, next, m);
      if (found->maxima[m].gate != HSP_NONE) of_gate[found->maxima[m].gate] = m;
    }
    for (uint32_t g = 0; g < gates; ++g) {
      if (of_gate[g] == HSP_NONE) continue;
      const uint32_t parent = found->maxima[of_gate[g]].parent;
      push(&first[parent == HSP_PORE_OUTSIDE ? maxima : parent], next, of_gate[g]);
    }
    /* Onto the stack go the narrowest gates first, so that the widest come off first. */
    for (uint32_t at = maxima; at != HSP_NONE;) {
      while (first[at] != HSP_NONE) {
        const uint32_t child = first[at];
        first[at] = next[child];
        push(&stack, next, child);
      }
      at = stack;
      if (at == HSP_NONE) break;
      stack = next[at];
      tree->class[tree->rows++] = at;
      tree->row[at] = tree->rows;
    }
  }
  free(of_gate);
  free(first);
  free(next);
  return done;
}

/* OTHERS: pockets without a colour of their own; NO_POCKET: where the wide probe gets, or pockets are not asked for. */
/* ABOVE_AXIS: px, so that no letter of the last row touches the axis. */
enum {
  MOST_NAMED_ROWS = 60,
  NAMED_ROW = 14,
  ABOVE_AXIS = 6,
  TREE_HEIGHT = 840,
  OTHERS = POCKET_COLOURS,
  NO_POCKET,
  TREE_COLOURS
};

static uint32_t colour_of(uint8_t rank) {
  static const uint32_t plain = 0x4D4D4D;
  return rank == NO_POCKET ? plain : rank == OTHERS ? other_pockets_colour : pocket_colours[rank];
}

/* Which colour a class has: that of the pocket that its maximum is in. */
static bool find_colours(const struct pores_found *found, uint8_t **colour) {
  const uint32_t maxima = found->counts.maxima;
  *colour = malloc((size_t)maxima + 1);
  if (*colour == NULL) return false;
  for (uint32_t m = 0; m < maxima; ++m) (*colour)[m] = NO_POCKET;
  uint32_t rank = 0;
  for (uint32_t p = 0; p < found->pocket_count; ++p) {
    const bool coloured = rank < OTHERS && pores_lists_pocket(found, p);
    for (size_t k = found->of_pockets.first[p]; k < found->of_pockets.first[p + 1]; ++k) {
      (*colour)[found->of_pockets.number[k]] = (uint8_t)(coloured ? rank : OTHERS);
    }
    if (coloured) ++rank;
  }
  return true;
}

struct tree_page {
  struct chart_frame frame;
  struct chart_scale across;
  double row; /* height */
  bool outside;
};

static double row_y(const struct tree_page *page, uint32_t row) {
  return page->frame.top + page->row * (row + (page->outside ? 0.5 : -0.5));
}

static void add_dot(struct text_buffer *out, double x, double y, uint32_t colour) {
  text_buffer_add(out, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"3\" fill=\"#%06" PRIx32 "\"/>\n", x, y, colour);
}

/* A line from birth to death, and on to the class that it merges into. */
static void add_classes(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                        const struct tree_page *page, const uint8_t *colour) {
  for (uint8_t c = 0; c < TREE_COLOURS; ++c) {
    bool any = false;
    for (uint32_t k = 0; k < tree->rows; ++k) {
      const hsp_pore_maximum *const maximum = &found->maxima[tree->class[k]];
      if (colour[tree->class[k]] != c) continue;
      if (!any) {
        char name[NAME_BYTES];
        snprintf(name, sizeof name, "#%06" PRIx32, colour_of(c));
        path_begin(out, name, page->row < NAMED_ROW ? 0.8 : 1.5);
        text_buffer_add_text(out, " d=\"");
      }
      any = true;
      text_buffer_add(out, "M%.2f %.2fH%.2f", chart_x(&page->frame, &page->across, maximum->radius), row_y(page, k + 1),
                      chart_x(&page->frame, &page->across, maximum->death));
      if (maximum->parent == HSP_NONE) continue;
      text_buffer_add(out, "V%.2f", row_y(page, maximum->parent == HSP_PORE_OUTSIDE ? 0 : tree->row[maximum->parent]));
    }
    if (any) text_buffer_add_text(out, "\"/>\n");
  }
}

/* Beside the widest class of a pocket that has a colour stands its number, too. */
static void name_class(char name[NAME_BYTES], const struct pores_found *found, uint32_t class, uint8_t colour) {
  const int length = snprintf(name, NAME_BYTES, "%" PRIu32, class);
  for (uint32_t p = 0; p < found->pocket_count && colour < OTHERS; ++p) {
    if (found->pockets[p].maximum != class) continue;
    snprintf(name + length, (size_t)(NAME_BYTES - length), ", pocket %" PRIu32, p + 1);
  }
}

static double name_x(const struct pores_found *found, const struct tree_page *page, uint32_t class) {
  return chart_x(&page->frame, &page->across, found->maxima[class].radius) + 4.0;
}

static void add_names(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                      const struct tree_page *page, const uint8_t *colour) {
  for (uint32_t k = 0; k < tree->rows && page->row >= NAMED_ROW; ++k) {
    const uint32_t class = tree->class[k];
    char name[NAME_BYTES];
    name_class(name, found, class, colour[class]);
    chart_text(out, name_x(found, page, class), row_y(page, k + 1) + 4.0, "start", name);
  }
}

/* Of the page, with all names. */
static int find_width(const struct pores_found *found, const struct tree *tree, const struct tree_page *page,
                      const uint8_t *colour) {
  double width = LEFT + WIDTH + RIGHT;
  for (uint32_t k = 0; k < tree->rows && page->row >= NAMED_ROW; ++k) {
    const uint32_t class = tree->class[k];
    char name[NAME_BYTES];
    name_class(name, found, class, colour[class]);
    width = fmax(width, name_x(found, page, class) + text_width(name, CHART_LETTER) + 20.0);
  }
  return (int)ceil(width);
}

/* No narrower probe is of interest: what still has no way out there is a cavity, and ends in a dot. */
static void add_cavities(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                         const struct tree_page *page, const uint8_t *colour) {
  for (uint32_t k = 0; k < tree->rows && page->row >= NAMED_ROW; ++k) {
    const uint32_t class = tree->class[k];
    if (found->maxima[class].parent != HSP_NONE) continue;
    add_dot(out, chart_x(&page->frame, &page->across, found->maxima[class].death), row_y(page, k + 1),
            colour_of(colour[class]));
  }
}

/* The probes of --pockets. */
static void add_wide_probe(struct text_buffer *out, const struct pores_found *found, const struct tree_page *page) {
  const double wide = found->request->pockets;
  if (!(wide > page->across.low && wide < page->across.high)) return;
  const double x = chart_x(&page->frame, &page->across, wide);
  add_dashed(out, x, page->frame.top, x, page->frame.top + page->frame.height);
}

static void add_swatch(struct text_buffer *out, int column, double y, uint32_t colour, const char *name) {
  const double x = LEFT + (double)(WIDTH / OTHERS) * column;
  text_buffer_add(out, "<path stroke=\"#%06" PRIx32 "\" stroke-width=\"3\" d=\"M%.1f %.1fh18\"/>\n", colour, x,
                  y - 4.0);
  chart_text(out, x + 24.0, y, "start", name);
}

/* The pockets that have colours, as many as there are; below them what else is drawn. */
static void add_tree_legend(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                            const struct tree_page *page, const uint8_t *colour) {
  static const char *const others[] = {[OTHERS] = "other pockets", [NO_POCKET] = "no pocket"};
  double y = page->frame.top + page->frame.height + BELOW - 6;
  const bool pockets = found->request->pockets >= 0.0;
  int rank = 0, column = 0;
  for (uint32_t p = 0; pockets && p < found->pocket_count && rank < OTHERS; ++p) {
    if (!pores_lists_pocket(found, p)) continue;
    char name[NAME_BYTES];
    snprintf(name, sizeof name, "pocket %" PRIu32, p + 1);
    add_swatch(out, rank, y, pocket_colours[rank], name);
    ++rank;
  }
  if (rank > 0) y += LEGEND_ROW;
  for (uint8_t other = OTHERS; pockets && other < TREE_COLOURS; ++other) {
    bool any = false;
    for (uint32_t k = 0; k < tree->rows && !any; ++k) any = colour[tree->class[k]] == other;
    if (any) add_swatch(out, column++, y, colour_of(other), others[other]);
  }
  if (tree->rows == 0 || page->row < NAMED_ROW) return;
  double x = LEFT + (double)column * (WIDTH / OTHERS) + (column > 0 ? 18 : 0);
  chart_text(out, x, y, "start", "numbers: maxima, as they are listed");
  x += 2 * (WIDTH / OTHERS) + 18;
  add_dot(out, x + 4.0, y - 4.0, colour_of(NO_POCKET));
  chart_text(out, x + 14.0, y, "start", "a cavity: no such probe leaves it");
}

/* In how many directions a narrower probe goes on for ever. Where lines are nearer than their names are wide, a label
 * has several names, from left to right as the lines are, the first of them above its line. */
static void add_limits(struct text_buffer *out, const struct pores_found *found, const struct tree_page *page) {
  enum { ROOM = 24 };
  const double top = page->frame.top, bottom = top + page->frame.height;
  double before = -HUGE_VAL, first = 0.0;
  int names = 0;
  char label[NAME_BYTES];
  for (int d = 3; d >= 0; --d) {
    const bool named = d > 0 && found->wide.gate[d - 1] != HSP_NONE && found->wide.through[d - 1] != before;
    if (!named && d > 0) continue;
    const double x = named ? chart_x(&page->frame, &page->across, found->wide.through[d - 1]) : HUGE_VAL;
    if (names > 0 && x >= first + ROOM * names) {
      chart_text(out, first + ROOM / 2 * (names - 1), top - 5.0, "middle", label);
      names = 0;
    }
    if (!named) break;
    before = found->wide.through[d - 1];
    add_dashed(out, x, top, x, bottom);
    if (names == 0) first = x;
    const size_t length = names == 0 ? 0 : strlen(label);
    snprintf(label + length, sizeof label - length, names == 0 ? "%d-d" : ", %d-d", d);
    ++names;
  }
}

static void add_tree(struct text_buffer *out, const struct pores_found *found, const struct molecule *molecule,
                     const struct tree *tree, const uint8_t *colour) {
  const double low = found->request->probe, high = found->counts.maxima > 0 ? found->maxima[0].radius : low;
  const bool outside = found->request->box.source == BOX_NONE;
  const uint32_t rows = tree->rows + (outside ? 1 : 0);
  const double row = rows <= MOST_NAMED_ROWS ? NAMED_ROW : fmax((double)TREE_HEIGHT / rows, 0.5);
  struct tree_page page = {{LEFT + 0.5, TOP + 0.5, WIDTH, row * fmax(rows, 1.0) + ABOVE_AXIS},
                           chart_scale_of(low, high > low ? high : low + 1.0),
                           row,
                           outside};
  const double bottom = page.frame.top + page.frame.height;
  chart_begin(out, find_width(found, tree, &page, colour), (int)ceil(bottom) + BELOW + 2 * LEGEND_ROW,
              "Classes of pores");
  chart_axis_below(out, &page.frame, &page.across);
  chart_name_across(out, &page.frame, "radius of the probe", molecule->format->sign);
  if (found->request->pockets >= 0.0) add_wide_probe(out, found, &page);
  if (!outside) add_limits(out, found, &page);
  if (outside) {
    text_buffer_add(out, "<path stroke=\"#333333\" stroke-width=\"1.5\" d=\"M%.2f %.2fH%.2f\"/>\n",
                    chart_x(&page.frame, &page.across, low), row_y(&page, 0), page.frame.left + page.frame.width);
    chart_text(out, LEFT - CHART_TICK - 3, row_y(&page, 0) + 4.0, "end", "outside");
  }
  add_classes(out, found, tree, &page, colour);
  add_cavities(out, found, tree, &page, colour);
  add_tree_legend(out, found, tree, &page, colour);
  add_names(out, found, tree, &page, colour);
  text_buffer_add_text(out, "</svg>\n");
}

bool pores_write_tree(const struct pores_found *found, const struct molecule *molecule, const char *path,
                      struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  struct tree tree = {NULL, NULL, 0};
  uint8_t *colour = NULL;
  bool done = (order_tree(found, &tree) && find_colours(found, &colour)) || failure_of_memory(failure);
  if (done) {
    add_tree(&out, found, molecule, &tree, colour);
    done = output_file_write_text(path, &out, failure);
  }
  text_buffer_free(&out);
  free(tree.row);
  free(tree.class);
  free(colour);
  return done;
}
