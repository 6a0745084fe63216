/* The tree of classes as a chart. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/pores_found.h"
#include "draw/chart.h"
#include "draw/pocket_colours.h"
#include "draw/pores_charts.h"
#include "draw/text_width.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

enum { NAME_BYTES = 96 };

enum { MOST_CLASSES = 100 };

/* Rows of the tree, each a class that is listed, from the outside or a class that meets no other on. Those that merge
 * into a class are below it, the widest gate first: so no line crosses another. */
struct tree {
  uint32_t *row;   /* [maxima], from 1 on; 0: it is not listed */
  uint32_t *class; /* [rows], in the order of rows */
  uint32_t rows, listed;
};

/* How long it lives, as the radius of a probe shrinks. */
struct life {
  double length;
  uint32_t class;
};

static int order_of_lives(const void *left, const void *right) {
  const struct life *const a = left, *const b = right;
  if (a->length != b->length) return a->length > b->length ? -1 : 1;
  return (a->class > b->class) - (a->class < b->class);
}

/* Marks in row those that are drawn: of the listed ones those that live longest, and with each the class that it merges
 * into, as that is older and ends later; and ones that meet no other live on. */
static bool choose_classes(const struct pores_found *found, struct tree *tree) {
  const uint32_t maxima = found->counts.maxima;
  struct life *const life = malloc(((size_t)maxima + 1) * sizeof *life);
  if (life == NULL) return false;
  for (uint32_t m = 0; m < maxima; ++m) {
    if (!pores_lists_maximum(found, m)) continue;
    life[tree->listed++] = (struct life){found->maxima[m].radius - found->maxima[m].death, m};
  }
  if (tree->listed > MOST_CLASSES) qsort(life, tree->listed, sizeof *life, order_of_lives);
  for (uint32_t k = 0; k < tree->listed && k < MOST_CLASSES; ++k) tree->row[life[k].class] = 1;
  free(life);
  return true;
}

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
  const bool done = of_gate != NULL && first != NULL && next != NULL && tree->row != NULL && tree->class != NULL &&
                    choose_classes(found, tree);
  if (done) {
    uint32_t stack = HSP_NONE;
    for (uint32_t g = 0; g < gates; ++g) of_gate[g] = HSP_NONE;
    for (uint32_t m = 0; m <= maxima; ++m) first[m] = HSP_NONE;
    for (uint32_t m = maxima; m-- > 0;) {
      if (tree->row[m] == 0) continue;
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
  NAMED_ROW = 18,
  ABOVE_AXIS = 6,
  TREE_HEIGHT = MOST_NAMED_ROWS * NAMED_ROW,
  OTHERS = POCKET_COLOURS,
  NO_POCKET,
  TREE_COLOURS
};

static uint32_t colour_of(uint8_t rank) {
  static const uint32_t plain = 0x4D4D4D;
  return rank == NO_POCKET ? plain : rank == OTHERS ? other_pockets_colour : pocket_colours[rank];
}

/* Find the colour of each class: that of the pocket of its maximum. */
static bool find_colours(const struct pores_found *found, uint8_t **colour) {
  const uint32_t maxima = found->counts.maxima;
  *colour = malloc((size_t)maxima + 1);
  if (*colour == NULL) return false;
  for (uint32_t m = 0; m < maxima; ++m) (*colour)[m] = NO_POCKET;
  const struct number_lists *const of_pockets = &found->of_pockets;
  const size_t all = found->pocket_count == 0 ? 0 : of_pockets->first[found->pocket_count];
  for (size_t k = 0; k < all; ++k) (*colour)[of_pockets->number[k]] = OTHERS;
  for (uint32_t rank = 0; rank < found->listed_count && rank < OTHERS; ++rank) {
    const uint32_t p = found->listed[rank].pocket;
    for (size_t k = of_pockets->first[p]; k < of_pockets->first[p + 1]; ++k) {
      (*colour)[of_pockets->number[k]] = (uint8_t)rank;
    }
  }
  return true;
}

#define TREE_LINE 1.5
enum { TREE_DOT = 3 }; /* its radius */

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
  text_buffer_add(out, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%d\" fill=\"#%06" PRIx32 "\"/>\n", x, y, TREE_DOT, colour);
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
        chart_path_begin(out, name, page->row < NAMED_ROW ? 0.8 : TREE_LINE);
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

/* Beside the widest class of a pocket that has a colour stands its number, too; beside all of others theirs. */
static void name_class(char name[NAME_BYTES], const struct pores_found *found, uint32_t class, uint8_t colour) {
  const int length = snprintf(name, NAME_BYTES, "%" PRIu32, class);
  for (uint32_t p = 0; p < found->pocket_count && colour != NO_POCKET; ++p) {
    const bool widest = found->pockets[p].maximum == class;
    bool within = widest;
    for (size_t k = found->of_pockets.first[p]; k < found->of_pockets.first[p + 1] && colour == OTHERS; ++k) {
      within = within || found->of_pockets.number[k] == class;
    }
    if (!within) continue;
    snprintf(name + length, (size_t)(NAME_BYTES - length), ", %spocket %" PRIu32, widest ? "" : "in ", p + 1);
  }
}

static double name_x(const struct pores_found *found, const struct tree_page *page, uint32_t class) {
  return chart_x(&page->frame, &page->across, found->maxima[class].radius) + 5.0;
}

static void add_names(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                      const struct tree_page *page, const uint8_t *colour) {
  for (uint32_t k = 0; k < tree->rows && page->row >= NAMED_ROW; ++k) {
    const uint32_t class = tree->class[k];
    char name[NAME_BYTES];
    name_class(name, found, class, colour[class]);
    chart_text(out, name_x(found, page, class), row_y(page, k + 1) + CHART_HALF_LETTER, "start", name);
  }
}

/* The width of the page, with all names. */
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

/* Narrower probes are not shown: a class that still has no way out is a cavity, and its line ends in a dot. */
static void add_cavities(struct text_buffer *out, const struct pores_found *found, const struct tree *tree,
                         const struct tree_page *page, const uint8_t *colour) {
  for (uint32_t k = 0; k < tree->rows && page->row >= NAMED_ROW; ++k) {
    const uint32_t class = tree->class[k];
    if (found->maxima[class].parent != HSP_NONE) continue;
    add_dot(out, chart_x(&page->frame, &page->across, found->maxima[class].death), row_y(page, k + 1),
            colour_of(colour[class]));
  }
}

/* The probes of --pockets, if they are within the axis. */
static bool shows_wide_probe(const struct pores_found *found, const struct tree_page *page) {
  const double wide = found->request->pores.pockets;
  return wide >= 0.0 && wide > page->across.low && wide < page->across.high;
}

static void add_wide_probe(struct text_buffer *out, const struct pores_found *found, const struct tree_page *page) {
  if (!shows_wide_probe(found, page)) return;
  const double x = chart_x(&page->frame, &page->across, found->request->pores.pockets);
  chart_dashed(out, x, page->frame.top, x, page->frame.top + page->frame.height);
}

/* Entries one after the other, each from a column on; where it does not end on the page it begins a row. */
struct tree_legend {
  struct text_buffer out;
  double first; /* the line of the first row */
  int rows, column;
};

static void place_entry(struct tree_legend *legend, double swatch, const char *name, double at[2]) {
  enum { COLUMNS = 6, COLUMN = WIDTH / COLUMNS, APART = 8 };
  const double wide = swatch + text_width(name, CHART_LETTER) + APART;
  const int columns = (int)ceil(wide / COLUMN);
  if (legend->rows == 0 || legend->column + columns > COLUMNS) {
    ++legend->rows;
    legend->column = 0;
  }
  at[0] = LEFT + COLUMN * legend->column;
  at[1] = legend->first + LEGEND_ROW * (legend->rows - 1);
  legend->column += columns;
  at[1] -= CHART_HALF_LETTER;
}

static void name_entry(struct tree_legend *legend, double swatch, const char *name, const double at[2]) {
  chart_text(&legend->out, at[0] + swatch, at[1] + CHART_HALF_LETTER, "start", name);
}

static void add_swatch(struct tree_legend *legend, uint32_t colour, const char *name) {
  enum { SQUARE = 16 };
  double at[2];
  place_entry(legend, SQUARE + BEHIND_SWATCH, name, at);
  text_buffer_add(&legend->out, "<path stroke=\"#%06" PRIx32 "\" stroke-width=\"3\" d=\"M%.1f %.1fh%d\"/>\n", colour,
                  at[0], at[1], SQUARE);
  name_entry(legend, SQUARE + BEHIND_SWATCH, name, at);
}

static bool has_cavities(const struct pores_found *found, const struct tree *tree) {
  for (uint32_t k = 0; k < tree->rows; ++k) {
    if (found->maxima[tree->class[k]].parent == HSP_NONE) return true;
  }
  return false;
}

static bool is_drawn(const struct tree *tree, const uint8_t *colour, uint8_t rank) {
  for (uint32_t k = 0; k < tree->rows; ++k) {
    if (colour[tree->class[k]] == rank) return true;
  }
  return false;
}

/* Add the pockets with colours that are drawn, then the other marks that are. */
static void add_tree_legend(struct tree_legend *legend, const struct pores_found *found, const struct tree *tree,
                            const struct tree_page *page, const uint8_t *colour) {
  static const char *const others[] = {[OTHERS] = "other pockets", [NO_POCKET] = "no pocket"};
  static const char wide_probe[] = "the wide probe of pockets", maxima[] = "numbers: maxima, as they are listed",
                    cavity[] = "ends in a dot: a cavity, which no such probe leaves";
  const bool pockets = found->request->pores.pockets >= 0.0;
  double at[2];
  for (uint8_t rank = 0; pockets && rank < found->listed_count && rank < OTHERS; ++rank) {
    char name[NAME_BYTES];
    snprintf(name, sizeof name, "pocket %" PRIu32, found->listed[rank].pocket + 1);
    if (is_drawn(tree, colour, rank)) add_swatch(legend, pocket_colours[rank], name);
  }
  for (uint8_t other = OTHERS; pockets && other < TREE_COLOURS; ++other) {
    if (is_drawn(tree, colour, other)) add_swatch(legend, colour_of(other), others[other]);
  }
  if (tree->rows < tree->listed) {
    char name[NAME_BYTES];
    snprintf(name, sizeof name, "the %" PRIu32 " classes that live longest; %" PRIu32 " more are left out", tree->rows,
             tree->listed - tree->rows);
    place_entry(legend, 0.0, name, at);
    name_entry(legend, 0.0, name, at);
  }
  if (shows_wide_probe(found, page)) {
    place_entry(legend, SWATCH + BEHIND_SWATCH, wide_probe, at);
    chart_dashed(&legend->out, at[0], at[1], at[0] + SWATCH, at[1]);
    name_entry(legend, SWATCH + BEHIND_SWATCH, wide_probe, at);
  }
  if (tree->rows == 0 || page->row < NAMED_ROW) return;
  place_entry(legend, 0.0, maxima, at);
  name_entry(legend, 0.0, maxima, at);
  if (!has_cavities(found, tree)) return;
  place_entry(legend, SWATCH + BEHIND_SWATCH, cavity, at);
  chart_path_begin(&legend->out, "#333333", TREE_LINE);
  text_buffer_add(&legend->out, " d=\"M%.1f %.1fh%d\"/>\n", at[0] + TREE_DOT, at[1], SWATCH - TREE_DOT);
  add_dot(&legend->out, at[0] + TREE_DOT, at[1], 0x333333);
  name_entry(legend, SWATCH + BEHIND_SWATCH, cavity, at);
}

/* Add lines at the radii below which a probe gets on without end in one direction or more. If lines are nearer to each
 * other than their names are wide, a label has several names, in the order of the lines from left to right, the first
 * one above its line. */
static void add_limits(struct text_buffer *out, const struct pores_found *found, const struct tree_page *page) {
  enum { ROOM = 32 };
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
    chart_dashed(out, x, top, x, bottom);
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
  struct tree_legend legend = {TEXT_BUFFER_EMPTY, bottom + BELOW, 0, 0};
  add_tree_legend(&legend, found, tree, &page, colour);
  chart_begin(out, find_width(found, tree, &page, colour),
              (int)ceil(bottom) + BELOW + LEGEND_ROW * (legend.rows - 1) + MARGIN_BELOW, "Classes of pores");
  chart_axis_below(out, &page.frame, &page.across);
  chart_name_across(out, &page.frame, "radius of the probe", molecule->format->sign);
  add_wide_probe(out, found, &page);
  if (!outside) add_limits(out, found, &page);
  if (outside) {
    text_buffer_add(out, "<path stroke=\"#333333\" stroke-width=\"1.5\" d=\"M%.2f %.2fH%.2f\"/>\n",
                    chart_x(&page.frame, &page.across, low), row_y(&page, 0), page.frame.left + page.frame.width);
    chart_text(out, LEFT - CHART_TICK - 3, row_y(&page, 0) + CHART_HALF_LETTER, "end", "outside");
  }
  add_classes(out, found, tree, &page, colour);
  add_cavities(out, found, tree, &page, colour);
  text_buffer_append(out, legend.out.text, legend.out.length);
  out->out_of_memory = out->out_of_memory || legend.out.out_of_memory;
  text_buffer_free(&legend.out);
  add_names(out, found, tree, &page, colour);
  text_buffer_add_text(out, "</svg>\n");
}

bool pores_write_tree(const struct pores_found *found, const struct molecule *molecule, const char *path,
                      struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  struct tree tree = {NULL, NULL, 0, 0};
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
