#include "draw/label_places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/text_width.h"

/* Lengths in sizes of letters. */
static const double box_height = 0.8, clear = 0.2, beside = 0.25, alone = 0.4, step = 0.35, line_gap = 0.25,
                    shortest = 0.45;

/* Costs of a place, in lengths of a line. */
static const double cost_of_line = 2.0, cost_of_knee = 1.0, cost_of_slope = 0.5, cost_of_corner = 1.0;
static const double near_by = 4.0, cost_of_far = 8.0; /* for each length beyond: a far name is hard to find */
static const double cost_across[2] = {15.0, 400.0}; /* for a length across bodies that are not selected, and that are */
static const double across_ball = 2.0;              /* times as much: a bond under a line is still a bond */
static const double cost_of_end = 8.0;              /* on another body, which it seems to name then */
static const double cost_of_cover[2] = {300.0, 6e3}; /* for a label all over them */

enum { PASSES = 4, MOST_PAIRED = 24 };

/* ---- how much of a box is taken ---- */

struct taken {
  const struct front_grid *front;
  const struct label_page *page;
  uint32_t *sum[2]; /* [rows + 1][columns + 1], of cells above and to the left: others, selected */
};

static size_t sum_at(const struct front_grid *front, int32_t column, int32_t row) {
  return (size_t)row * ((size_t)front->columns + 1) + (size_t)column;
}

static bool is_selected(const struct label_page *page, uint32_t atom) {
  return selection_takes(page->selected, page->molecule, atom);
}

static bool make_taken(const struct label_page *page, struct taken *taken) {
  const struct front_grid *const front = page->front;
  const size_t sums = sum_at(front, 0, front->rows + 1);
  *taken = (struct taken){front, page, {calloc(sums, sizeof(uint32_t)), calloc(sums, sizeof(uint32_t))}};
  if (taken->sum[0] == NULL || taken->sum[1] == NULL) return false;
  for (int32_t row = 0; row < front->rows; ++row) {
    uint32_t in_row[2] = {0, 0};
    for (int32_t column = 0; column < front->columns; ++column) {
      const uint32_t owner = front->owner[(size_t)row * (size_t)front->columns + (size_t)column];
      if (owner != FRONT_GRID_NOTHING) ++in_row[is_selected(page, owner & ~FRONT_GRID_STICK) ? 1 : 0];
      for (int k = 0; k < 2; ++k) {
        taken->sum[k][sum_at(front, column + 1, row + 1)] = taken->sum[k][sum_at(front, column + 1, row)] + in_row[k];
      }
    }
  }
  return true;
}

static int32_t clamped(double x, int32_t most) {
  return x <= 0.0 ? 0 : x >= most ? most : (int32_t)x;
}

/* The part of a box, enlarged by `around`, that is taken. */
static void find_cover(const struct taken *taken, const double box[4], double around, double cover[2]) {
  const struct front_grid *const front = taken->front;
  const int32_t low[2] = {clamped(floor((box[0] - around - front->corner[0]) / front->cell), front->columns),
                          clamped(floor((box[1] - around - front->corner[1]) / front->cell), front->rows)};
  const int32_t high[2] = {clamped(ceil((box[2] + around - front->corner[0]) / front->cell), front->columns),
                           clamped(ceil((box[3] + around - front->corner[1]) / front->cell), front->rows)};
  const double cells = (double)(high[0] - low[0]) * (high[1] - low[1]);
  for (int k = 0; k < 2; ++k) {
    const uint32_t *const sum = taken->sum[k];
    const uint32_t within = sum[sum_at(front, high[0], high[1])] - sum[sum_at(front, low[0], high[1])] -
                            sum[sum_at(front, high[0], low[1])] + sum[sum_at(front, low[0], low[1])];
    cover[k] = cells > 0.0 ? within / cells : 0.0;
  }
}

/* ---- obstacles ---- */

/* How many lines are within `clear` of each cell, and labels as near as they may be to others: a line that is followed
 * from cell to cell crosses none unnoticed. */
struct marks {
  const struct front_grid *front;
  double of_line, of_label; /* around, px */
  uint16_t *count;          /* [rows][columns] */
};

static void mark_box(const struct marks *marks, const double box[4], double around, int change) {
  const struct front_grid *const front = marks->front;
  const double cell = front->cell, *const corner = front->corner;
  const int32_t left = clamped(floor((box[0] - around - corner[0]) / cell), front->columns);
  const int32_t right = clamped(ceil((box[2] + around - corner[0]) / cell), front->columns);
  const int32_t top = clamped(floor((box[1] - around - corner[1]) / cell), front->rows);
  const int32_t bottom = clamped(ceil((box[3] + around - corner[1]) / cell), front->rows);
  for (int32_t row = top; row < bottom; ++row) {
    uint16_t *const cells = marks->count + (size_t)row * (size_t)front->columns;
    for (int32_t column = left; column < right; ++column) cells[column] = (uint16_t)(cells[column] + change);
  }
}

static void mark_line(const struct marks *marks, const double from[2], const double to[2], int change) {
  const double length = fmax(fabs(to[0] - from[0]), fabs(to[1] - from[1]));
  const int steps = (int)ceil(length / marks->front->cell) + 1;
  for (int k = 0; k <= steps; ++k) {
    const double share = (double)k / steps;
    const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
    const double box[4] = {x, y, x, y};
    mark_box(marks, box, marks->of_line, change);
  }
}

static void mark_label(const struct marks *marks, const struct placed_label *label, int change) {
  mark_box(marks, label->box, marks->of_label, change);
  if (!label->has_line) return;
  mark_line(marks, label->from, label->knee, change);
  mark_line(marks, label->knee, label->at, change);
}

static bool is_marked(const struct marks *marks, double x, double y) {
  const struct front_grid *const front = marks->front;
  const int32_t column = clamped(floor((x - front->corner[0]) / front->cell), front->columns - 1);
  const int32_t row = clamped(floor((y - front->corner[1]) / front->cell), front->rows - 1);
  return marks->count[(size_t)row * (size_t)front->columns + (size_t)column] > 0;
}

/* Marks are wider than the steps. */
static bool box_is_marked(const struct marks *marks, const double box[4]) {
  const double move = 2.0 * marks->front->cell;
  for (double y = box[1]; y < box[3] + move; y += move) {
    for (double x = box[0]; x < box[2] + move; x += move) {
      if (is_marked(marks, fmin(x, box[2]), fmin(y, box[3]))) return true;
    }
  }
  return false;
}

/* ---- places of one label ---- */

struct search {
  const struct taken *taken;
  struct marks marks;
  const struct placed_label *own;
  struct placed_label best;
  double cost;
};

/* The label at `own` with its text beginning, or ending, at x; y is the middle of its height. */
static struct placed_label with_text(const struct search *search, double x, double y, double anchor) {
  struct placed_label label = *search->own;
  const double half = box_height / 2.0 * search->taken->page->size;
  label.text_at[0] = x;
  label.text_at[1] = y;
  label.anchor = anchor;
  label.box[0] = x - anchor * label.wide;
  label.box[1] = y - half;
  label.box[2] = label.box[0] + label.wide;
  label.box[3] = y + half;
  label.has_line = false;
  return label;
}

static bool is_on_page(const struct label_page *page, const double box[4]) {
  return box[0] >= page->low[0] && box[1] >= page->low[1] && box[2] <= page->high[0] && box[3] <= page->high[1];
}

/* Not by hypot, whose last digit differs from one mathematics library to the next. */
static double distance(const double a[2], const double b[2]) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  return sqrt(x * x + y * y);
}

/* The place becomes the best one if it costs less than the best so far and nothing is in its way. */
static void offer(struct search *search, const struct placed_label *label, double cost) {
  const struct label_page *const page = search->taken->page;
  double letters[2], cover[2];
  if (!(cost < search->cost) || !is_on_page(page, label->box)) return;
  const double reach = distance(label->from, label->at);
  if (label->has_line && reach < shortest * page->size) return;
  /* Bodies under letters are worse than those near them. */
  find_cover(search->taken, label->box, 0.0, letters);
  find_cover(search->taken, label->box, label->has_line ? clear * page->size : 0.0, cover);
  for (int k = 0; k < 2; ++k) cost += cost_of_cover[k] * (letters[k] + cover[k]) / 2.0;
  if (label->has_line) {
    const uint32_t end = front_grid_owner(page->front, label->from[0], label->from[1]);
    if (end != FRONT_GRID_NOTHING && end != label->atom) cost += cost_of_end;
  }
  if (!(cost < search->cost)) return;
  if (box_is_marked(&search->marks, label->box)) return;
  search->best = *label;
  search->best.cost = search->cost = cost;
}

/* Whether a box, enlarged by `alone` letters, meets no disc or stick but the label's own. */
static bool is_alone(const struct search *search, const double box[4]) {
  const struct front_grid *const front = search->taken->front;
  const double around = alone * search->taken->page->size, cell = front->cell;
  for (double y = box[1] - around; y <= box[3] + around; y += cell) {
    for (double x = box[0] - around; x <= box[2] + around; x += cell) {
      const uint32_t owner = front_grid_owner(front, x, y);
      if (owner != FRONT_GRID_NOTHING && owner != search->own->atom) return false;
    }
  }
  return true;
}

/* Try places to the right, left, above, below, and at the corners of the disc, where the disc itself is visible. */
static void try_beside(struct search *search) {
  static const int8_t ways[8][2] = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
  const struct placed_label *const own = search->own;
  const double size = search->taken->page->size, gap = beside * size, half = box_height / 2.0 * size;
  for (int k = 0; k < 8 && !own->needs_line; ++k) {
    const double slope = ways[k][0] != 0 && ways[k][1] != 0 ? 0.7071 : 1.0;
    const double rim = slope * (own->radius - search->taken->front->cell), away = slope * (own->radius + gap);
    const double x = own->centre[0] + ways[k][0] * rim, y = own->centre[1] + ways[k][1] * rim;
    if (front_grid_owner(search->taken->front, x, y) != own->atom) continue;
    const double up = ways[k][1] * (away + (ways[k][0] == 0 ? half : 0.3 * half));
    const struct placed_label label = with_text(search, own->centre[0] + ways[k][0] * away, own->centre[1] + up,
                                                ways[k][0] == 0  ? 0.5
                                                : ways[k][0] > 0 ? 0.0
                                                                 : 1.0);
    if (is_alone(search, label.box)) offer(search, &label, 0.1 * k);
  }
}

/* Add to *cost the cost of a line from one point to the next. False: it meets another line or a label; at its beginning
 * that is allowed. */
static bool go_on(const struct search *search, const double from[2], const double to[2], bool begins, double *cost) {
  const struct label_page *const page = search->taken->page;
  const double length = distance(from, to);
  const int parts = (int)ceil(length / page->front->cell);
  for (int k = 1; k <= parts; ++k) {
    const double share = (double)k / parts;
    const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
    if (!begins && is_marked(&search->marks, x, y)) return false;
    const uint32_t body = front_grid_body(page->front, x, y), owner = body & ~FRONT_GRID_STICK;
    double times = 1.0;
    if (body != FRONT_GRID_NOTHING && owner != search->own->atom) {
      times += cost_across[is_selected(page, owner) ? 1 : 0] * (body == owner ? across_ball : 1.0);
    }
    if (distance(search->own->at, (const double[2]){x, y}) > near_by * page->size) times += cost_of_far;
    *cost += length / parts / page->size * times;
  }
  return true;
}

/* Try texts on a level line from a point to the right or left, at each step from `first` on. */
static void try_level(struct search *search, const double knee[2], int way, int first, double cost) {
  const struct label_page *const page = search->taken->page;
  const double length = step * page->size, gap = line_gap * page->size;
  const bool bent = knee[1] != search->own->at[1];
  for (int k = 0; cost < search->cost; ++k) {
    const double from[2] = {knee[0] + way * (k - 1) * length, knee[1]}, to[2] = {from[0] + way * length, knee[1]};
    if (to[0] < page->low[0] || to[0] > page->high[0]) return;
    if (k > 0 && !go_on(search, from, to, !bent && k == 1, &cost)) return;
    struct placed_label label = with_text(search, to[0] + way * gap, to[1], way > 0 ? 0.0 : 1.0);
    label.has_line = true;
    memcpy(label.from, to, sizeof label.from);
    memcpy(label.knee, knee, sizeof label.knee);
    if (k >= first) offer(search, &label, cost + (bent && k > 0 ? cost_of_knee : 0.0));
  }
}

static bool is_point_on_page(const struct label_page *page, const double at[2]) {
  const double box[4] = {at[0], at[1], at[0], at[1]};
  return is_on_page(page, box);
}

/* At 45 degrees, and from each step on the level; across 0: upwards or down. */
static void try_sloping(struct search *search, int across, int down) {
  const struct label_page *const page = search->taken->page;
  const double length = step * page->size, away = (line_gap + box_height / 2.0) * page->size;
  double cost = cost_of_line + (across != 0 ? cost_of_slope : 0.0);
  double before[2] = {search->own->at[0], search->own->at[1]};
  for (int k = 1; cost < search->cost; ++k) {
    const double at[2] = {search->own->at[0] + across * k * length, search->own->at[1] + down * k * length};
    if (!is_point_on_page(page, at) || !go_on(search, before, at, k == 1, &cost)) return;
    memcpy(before, at, sizeof before);
    if (across != 0) {
      try_level(search, at, across, 0, cost);
      continue;
    }
    struct placed_label label = with_text(search, at[0], at[1] + down * away, 0.5);
    label.has_line = true;
    memcpy(label.from, at, sizeof label.from);
    memcpy(label.knee, at, sizeof label.knee);
    offer(search, &label, cost);
    for (int way = -1; way <= 1; way += 2) try_level(search, at, way, 1, cost + cost_of_corner);
  }
}

/* False: there is no place. */
static bool find_place(struct search *search, const struct placed_label *own) {
  search->own = own;
  search->cost = HUGE_VAL;
  try_beside(search);
  for (int way = -1; way <= 1; way += 2) {
    try_level(search, own->at, way, 0, cost_of_line);
    for (int across = -1; across <= 1; ++across) try_sloping(search, across, way);
  }
  return search->cost < HUGE_VAL;
}

bool label_is_placed(const struct placed_label *label) {
  return label->box[2] > label->box[0];
}

/* One after the other, then each anew among all others, until none moves. How many have places. */
static size_t place_all(struct search *search, struct placed_label *label, size_t count) {
  bool moved = true;
  size_t placed = 0;
  for (int pass = 0; pass < PASSES && moved; ++pass) {
    moved = false;
    placed = 0;
    for (size_t i = 0; i < count; ++i) {
      if (label_is_placed(&label[i])) mark_label(&search->marks, &label[i], -1);
      if (find_place(search, &label[i])) {
        moved = moved || memcmp(label[i].box, search->best.box, sizeof label[i].box) != 0;
        label[i] = search->best;
      }
      if (!label_is_placed(&label[i])) continue;
      mark_label(&search->marks, &label[i], 1);
      ++placed;
    }
  }
  return placed;
}

/* Two labels anew, the first one before the other. False, and they are as they were, unless both together cost less. */
static bool place_pair(struct search *search, struct placed_label *first, struct placed_label *other) {
  const struct placed_label before[2] = {*first, *other};
  struct placed_label *const both[2] = {first, other};
  double cost = 0.0;
  for (int k = 0; k < 2; ++k) mark_label(&search->marks, both[k], -1);
  int placed = 0;
  for (; placed < 2 && find_place(search, both[placed]); ++placed) {
    *both[placed] = search->best;
    cost += search->cost;
    mark_label(&search->marks, both[placed], 1);
  }
  if (placed == 2 && cost < before[0].cost + before[1].cost) return true;
  while (placed-- > 0) mark_label(&search->marks, both[placed], -1);
  for (int k = 0; k < 2; ++k) {
    *both[k] = before[k];
    mark_label(&search->marks, both[k], 1);
  }
  return false;
}

/* Place pairs of labels together, as one may have the only good place of the other. */
static void place_pairs(struct search *search, struct placed_label *label, size_t count) {
  bool moved = count <= MOST_PAIRED;
  for (int pass = 0; pass < PASSES && moved; ++pass) {
    moved = false;
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = 0; j < count; ++j) moved = (i != j && place_pair(search, &label[i], &label[j])) || moved;
    }
  }
}

bool label_places_find(const struct label_page *page, const double (*boxes)[4], size_t box_count,
                       struct placed_label *label, size_t count, size_t *placed) {
  struct taken taken;
  const size_t cells = (size_t)page->front->columns * (size_t)page->front->rows;
  bool enough = make_taken(page, &taken);
  struct search search = {
      .taken = &taken,
      .marks = {page->front, clear * page->size, page->apart * page->size, calloc(cells + 1, sizeof(uint16_t))}};
  enough = enough && search.marks.count != NULL;
  for (size_t i = 0; i < count; ++i) {
    label[i].wide = text_width(label[i].text, page->size);
    memset(label[i].box, 0, sizeof label[i].box);
  }
  for (size_t i = 0; enough && i < box_count; ++i) mark_box(&search.marks, boxes[i], search.marks.of_label, 1);
  *placed = enough && cells > 0 ? place_all(&search, label, count) : 0;
  if (enough && *placed == count) place_pairs(&search, label, count);
  free(search.marks.count);
  free(taken.sum[0]);
  free(taken.sum[1]);
  return enough;
}
