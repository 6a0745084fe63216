#include "draw/label_writing.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/label_places.h"
#include "draw/text_width.h"

static const double letter_height = 0.72;                    /* of capitals, in sizes */
static const double line_height = 1.3;                       /* from label to label */
static const double clear_of_edge = 0.23;                    /* a name within a ball, in sizes */
static const double clear_of_stick[] = {0.4, 0.3, 0.2, 0.1}; /* the first of them for which there is room */
static const double smallest_share = 1.0 / 110.0; /* of the width of the page: letters below that are not read */
static const double cells_per_letter = 8.0;       /* of the grid of bodies in front */
static const double apart[2] = {0.35, 0.2};       /* labels, in sizes; the latter where letters are smallest */
static const double least_circle = 0.4;           /* seen of a disc beside which a name stands without a line */

struct writer {
  const struct annotation *annotation;
  const struct pen *pen;
  double size; /* of letters, px */
  uint32_t colour, seam;
};

static const double dot = 0.3, ring = 0.55; /* wide, in sizes */
static const double seam_of_line = 0.12;    /* how much wider than the line, in sizes */
static const double smallest_within = 0.85; /* size of names within balls, as a part of that of others */
static const double smaller = 0.9;          /* from one try to the next */
enum { MOST_OF_TOO_MANY = 400 };            /* labels that are tried if not all have room */

/* Whether less of a ball is visible than the dot at the end of a line would cover. */
static bool is_hidden(const struct writer *writer, const struct placed_label *label) {
  return label->seen < dot / 2.0 * writer->size;
}

/* The largest size of letters with which a name has room within the visible part of a ball. */
static double size_within(const struct writer *writer, const struct page_label *label) {
  const double width = text_width(label->text, 1.0);
  const double reach = sqrt(width * width + letter_height * letter_height) / 2.0 + clear_of_edge;
  return writer->annotation->frame.scale * label->radius / reach;
}

static void place_of(const struct writer *writer, const struct page_label *label, double at[2]) {
  const struct picture_frame *const frame = &writer->annotation->frame;
  at[0] = frame->x + frame->scale * label->at[0];
  at[1] = frame->y - frame->scale * label->at[1];
}

/* Find the place nearest to `at` for a name, with room around its letters, within the visible part of a ball, which
 * sticks may cover in part. False: there is none. */
static bool find_within(const struct front_grid *front, const struct page_label *label, double size, double around,
                        double at[2], double box[4]) {
  const double half[2] = {text_width(label->text, size) / 2.0 + around, letter_height * size / 2.0 + around};
  const double move = 2.0 * front->cell;
  const int most = (int)fmin(2.0 * half[0] / move, 20.0);
  int least = INT_MAX;
  double found[2] = {0.0, 0.0};
  for (int down = -most; down <= most; ++down) {
    for (int right = -most; right <= most; ++right) {
      const int far = down * down + right * right;
      const double middle[2] = {at[0] + right * move, at[1] + down * move};
      if (far >= least) continue;
      const double letters[4] = {middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]};
      if (!front_grid_is_all(front, letters, label->atom)) continue;
      least = far;
      memcpy(found, middle, sizeof found);
    }
  }
  if (least == INT_MAX) return false;
  memcpy(at, found, sizeof found);
  for (int k = 0; k < 2; ++k) {
    box[k] = at[k] - half[k] + around;
    box[2 + k] = at[k] + half[k] - around;
  }
  return true;
}

/* The same, as clear of sticks as there is room. */
static bool find_clear(const struct front_grid *front, const struct page_label *label, double size, double at[2],
                       double box[4]) {
  for (size_t k = 0; k < sizeof clear_of_stick / sizeof clear_of_stick[0]; ++k) {
    if (find_within(front, label, size, clear_of_stick[k] * size, at, box)) return true;
  }
  return false;
}

/* Within a ball, on its colour: whichever of the two colours differs more from it. */
static void write_within(const struct writer *writer, const struct page_label *label, const double at[2], double size) {
  const uint32_t colours[3] = {writer->annotation->colour[label->atom], writer->colour, writer->seam};
  int light[3];
  for (int k = 0; k < 3; ++k) {
    light[k] = 3 * (int)(colours[k] >> 16 & 0xFF) + 6 * (int)(colours[k] >> 8 & 0xFF) + (int)(colours[k] & 0xFF);
  }
  const bool of_lines = abs(light[1] - light[0]) >= abs(light[2] - light[0]);
  const uint32_t colour = of_lines ? writer->colour : writer->seam;
  const double y = at[1] + size * letter_height / 2.0;
  const struct pen_text written = {label->text, at[0], y, size, 0.5, colour, colour};
  pen_write(writer->pen, &written);
}

static void write_line(const struct writer *writer, const double from[2], const double to[2], double width,
                       uint32_t colour) {
  if (memcmp(from, to, 2 * sizeof *from) != 0) pen_line(writer->pen, from, to, width, colour);
}

/* An atom that shows less than the dot has a ring instead. All lines first, so that none crosses a letter. */
static void write_beside(const struct writer *writer, const struct placed_label *label, size_t count, double size) {
  for (int seam = 1; seam >= 0; --seam) {
    const uint32_t colour = seam == 1 ? writer->seam : writer->colour;
    const double width = size * (seam == 1 ? 0.06 + seam_of_line : 0.06);
    for (size_t i = 0; i < count; ++i) {
      const struct placed_label *const one = &label[i];
      const bool hidden = is_hidden(writer, one);
      const double wide = hidden ? ring : dot;
      if (!label_is_placed(one) || !one->has_line) continue;
      write_line(writer, one->from, one->knee, width, colour);
      write_line(writer, one->knee, one->at, width, colour);
      pen_line(writer->pen, one->at, one->at, size * (seam == 1 ? wide + 0.15 : wide), colour);
      if (seam == 0 && hidden) pen_line(writer->pen, one->at, one->at, size * (wide - 0.15), writer->seam);
    }
  }
  for (size_t i = 0; i < count; ++i) {
    const struct placed_label *const one = &label[i];
    const struct pen_text written = {one->text,   one->text_at[0], one->text_at[1] + size * letter_height / 2.0,
                                     size,        one->anchor,     writer->colour,
                                     writer->seam};
    if (label_is_placed(one)) pen_write(writer->pen, &written);
  }
}

/* The labels within balls are written, and where they stand goes to `box`. The others go to `label`. */
static size_t write_all_within(const struct writer *writer, const struct front_grid *front,
                               const struct page_axes *axes, double (*box)[4], struct placed_label *label,
                               size_t *count) {
  const struct annotation *const annotation = writer->annotation;
  double size = writer->size;
  size_t within = 0;
  *count = 0;
  for (uint32_t i = 0; i < annotation->label_count; ++i) {
    const double own = size_within(writer, &annotation->labels[i]);
    if (own >= smallest_within * writer->size && own < size) size = own;
  }
  for (uint32_t i = 0; i < annotation->label_count; ++i) {
    const struct page_label *const one = &annotation->labels[i];
    double at[2], centre[3];
    place_of(writer, one, at);
    double clear[2] = {at[0], at[1]};
    if (size_within(writer, one) >= smallest_within * writer->size &&
        find_clear(front, one, size, clear, box[within])) {
      write_within(writer, one, clear, size);
      ++within;
      continue;
    }
    page_axes_place(axes, annotation->molecule->xyz + 3 * (size_t)one->atom, centre);
    const double seen = annotation->frame.scale * one->radius;
    label[(*count)++] =
        (struct placed_label){.text = one->text,
                              .atom = one->atom,
                              .at = {at[0], at[1]},
                              .centre = {centre[0], centre[1]},
                              .radius = annotation->frame.scale * shown_bodies_radius(annotation->bodies, one->atom),
                              .seen = seen,
                              .needs_line = seen < least_circle * writer->size};
  }
  return within;
}

static int compare_seen(const void *left, const void *right) {
  const struct placed_label *const a = left, *const b = right;
  if (a->seen != b->seen) return a->seen < b->seen ? 1 : -1;
  return (a->atom > b->atom) - (a->atom < b->atom);
}

bool labels_write(const struct annotation *annotation, const struct pen *pen, uint32_t colour, uint32_t seam,
                  uint32_t *left_out, struct failure *failure) {
  const struct picture_frame *frame = &annotation->frame;
  const struct writer of_labels = {annotation, pen, frame->letter, colour, seam}, *const writer = &of_labels;
  const double low[2] = {0.0, 0.0}, high[2] = {frame->width, frame->height}, margin = 0.25 * frame->letter;
  const bool written_below = annotation->drawing->scale_bar || annotation->drawing->legend;
  const double below = frame->strip > 0.0 ? frame->strip : written_below ? 2.0 * frame->letter : margin;
  const struct page_axes axes = picture_frame_axes(frame, annotation->view);
  const size_t labels = (size_t)annotation->label_count + 1;
  struct placed_label *label = calloc(labels, sizeof *label);
  double(*box)[4] = calloc(labels, sizeof *box);
  struct front_grid front;
  bool enough = front_grid_make(&front, low, high, writer->size / cells_per_letter);
  enough = enough && label != NULL && box != NULL;
  *left_out = 0;
  if (enough) {
    size_t count = 0, placed = 0;
    front_grid_show(&front, annotation->bodies, &axes, frame->scale);
    const size_t within = write_all_within(writer, &front, &axes, box, label, &count);
    struct label_page page = {.front = &front,
                              .molecule = annotation->molecule,
                              .selected = annotation->selected,
                              .low = {margin, margin},
                              .high = {frame->width - margin, frame->height - below},
                              .size = writer->size};
    const double columns = 0.5 * (double)count * line_height * smallest_share * frame->width;
    const double smallest = frame->width * smallest_share;
    bool all = count == 0;
    while (enough && !all && columns <= frame->height - below && page.size >= smallest) {
      page.apart = apart[page.size * smaller >= smallest ? 0 : 1];
      enough = label_places_find(&page, (const double(*)[4])box, within, label, count, &placed);
      all = placed == count;
      if (!all) page.size *= smaller;
    }
    if (enough && !all) {
      /* The most visible ones first. */
      const size_t tried = count < MOST_OF_TOO_MANY ? count : MOST_OF_TOO_MANY;
      qsort(label, count, sizeof *label, compare_seen);
      page.size = smallest;
      page.apart = apart[1];
      enough = label_places_find(&page, (const double(*)[4])box, within, label, tried, &placed);
      *left_out = (uint32_t)(count - placed);
      count = tried;
    }
    if (enough) write_beside(writer, label, count, page.size);
  }
  front_grid_free(&front);
  free(label);
  free(box);
  return enough || failure_of_memory(failure);
}
