#include "draw/annotation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/pen.h"
#include "read/residue_kinds.h"

enum { MOST_ENTRIES = 14, RAMP_PARTS = 17, TEXT_BYTES = 48, MOST_POWERS = 300 };

static const double letter_height = 0.72;         /* of capitals, in sizes */
static const double line_height = 1.3;            /* from label to label */
static const double smallest_share = 1.0 / 110.0; /* of the width of the page: letters below that are not read */

struct writer {
  const struct annotation *annotation;
  struct pen pen;
  double width, height, size; /* of the page and of letters, px */
  uint32_t colour, seam;
};

static void write_text(const struct writer *writer, const char *text, double x, double y, double size, double anchor) {
  const struct pen_text written = {text, x, y + size * letter_height / 2.0, size, anchor, writer->colour, writer->seam};
  pen_write(&writer->pen, &written);
}

/* ---- labels ---- */

struct placed_label {
  const char *text;
  double at[2]; /* of what it names, px */
  double y;     /* of a label beside the molecule */
};

static int compare_heights(const void *a, const void *b) {
  const struct placed_label *p = a;
  const struct placed_label *q = b;
  if (p->at[1] != q->at[1]) return p->at[1] < q->at[1] ? -1 : 1;
  if (p->at[0] != q->at[0]) return p->at[0] < q->at[0] ? -1 : 1;
  return strcmp(p->text, q->text);
}

/* Labels of one side, from the top: each as near to what it names as those above and below leave room. */
static void spread(struct placed_label *label, size_t count, double step, double height) {
  qsort(label, count, sizeof *label, compare_heights);
  for (size_t i = 0; i < count; ++i) {
    const double least = i == 0 ? step / 2.0 : label[i - 1].y + step;
    label[i].y = label[i].at[1] > least ? label[i].at[1] : least;
  }
  for (size_t i = count; i-- > 0;) {
    const double most = i + 1 == count ? height - step / 2.0 : label[i + 1].y - step;
    if (label[i].y > most) label[i].y = most;
  }
}

static double widest_of(const struct placed_label *label, size_t count, double size) {
  double widest = 0.0;
  for (size_t i = 0; i < count; ++i) {
    const double width = pen_width(label[i].text, size);
    if (width > widest) widest = width;
  }
  return widest;
}

/* All lines first, so that none crosses a letter. */
static void write_side(const struct writer *writer, const struct placed_label *label, size_t count, double size,
                       bool left) {
  const double column = writer->annotation->frame.column;
  const double away = column > 0.0 ? column - 0.4 * size : widest_of(label, count, size) + 0.6 * size;
  const double x = left ? away : writer->width - away;
  for (int seam = 1; seam >= 0; --seam) {
    for (size_t i = 0; i < count; ++i) {
      const double from[2] = {left ? x + 0.25 * size : x - 0.25 * size, label[i].y};
      const uint32_t colour = seam == 1 ? writer->seam : writer->colour;
      pen_line(&writer->pen, from, label[i].at, size * (seam == 1 ? 0.2 : 0.06), colour);
      pen_line(&writer->pen, label[i].at, label[i].at, size * (seam == 1 ? 0.45 : 0.3), colour);
    }
  }
  for (size_t i = 0; i < count; ++i) write_text(writer, label[i].text, x, label[i].y, size, left ? 1.0 : 0.0);
}

static bool write_labels(const struct writer *writer, struct failure *failure) {
  const struct annotation *annotation = writer->annotation;
  const struct picture_frame *frame = &annotation->frame;
  struct placed_label *side = calloc((size_t)annotation->label_count + 1, 2 * sizeof *side);
  if (side == NULL) return failure_of_memory(failure);
  struct placed_label *const sides[2] = {side, side + annotation->label_count};
  size_t count[2] = {0, 0};
  for (uint32_t i = 0; i < annotation->label_count; ++i) {
    const struct page_label *label = &annotation->labels[i];
    const struct placed_label placed = {
        label->text, {frame->x + frame->scale * label->at[0], frame->y - frame->scale * label->at[1]}, 0.0};
    const double across = pen_width(label->text, writer->size);
    if (hypot(across, letter_height * writer->size) / 2.0 <= frame->scale * label->radius) {
      write_text(writer, label->text, placed.at[0], placed.at[1], writer->size, 0.5);
    } else {
      const int right = placed.at[0] > writer->width / 2.0 ? 1 : 0;
      sides[right][count[right]++] = placed;
    }
  }
  const size_t most = count[0] > count[1] ? count[0] : count[1];
  const double height = writer->height - frame->strip;
  double size = writer->size;
  if ((double)most * size * line_height > height) size = height / ((double)most * line_height);
  const bool readable = size >= writer->width * smallest_share;
  for (int right = 0; right < 2 && readable; ++right) {
    spread(sides[right], count[right], size * line_height, height);
    write_side(writer, sides[right], count[right], size, right == 0);
  }
  free(side);
  return readable || failure_in_input(failure, 0, "there is no room for %u labels: name fewer by --highlight",
                                      (unsigned)annotation->label_count);
}

/* ---- the scale bar ---- */

/* The largest of 1, 2, 5, 10, .. that is no longer than that. */
static double round_length(double most) {
  double power = 1.0;
  for (int k = 0; k < MOST_POWERS && power > most; ++k) power /= 10.0;
  for (int k = 0; k < MOST_POWERS && 10.0 * power <= most; ++k) power *= 10.0;
  return 5.0 * power <= most ? 5.0 * power : 2.0 * power <= most ? 2.0 * power : power;
}

static void write_scale_bar(const struct writer *writer, double y) {
  const struct picture_frame *frame = &writer->annotation->frame;
  const char *sign = writer->annotation->molecule->format->sign;
  if (!(frame->scale > 0.0)) return; /* nothing is seen */
  const double length = round_length(0.2 * writer->width / frame->scale);
  const double ends[2][2] = {{writer->size, y}, {writer->size + length * frame->scale, y}};
  const double tick = 0.3 * writer->size;
  for (int seam = 1; seam >= 0; --seam) {
    const uint32_t colour = seam == 1 ? writer->seam : writer->colour;
    const double width = writer->size * (seam == 1 ? 0.25 : 0.1);
    pen_line(&writer->pen, ends[0], ends[1], width, colour);
    for (int end = 0; end < 2; ++end) {
      const double tips[2][2] = {{ends[end][0], y - tick}, {ends[end][0], y + tick}};
      pen_line(&writer->pen, tips[0], tips[1], width, colour);
    }
  }
  char text[TEXT_BYTES];
  snprintf(text, sizeof text, "%.6g%s%s", length, sign[0] == '\0' ? "" : " ", sign);
  write_text(writer, text, ends[1][0] + 0.5 * writer->size, y, writer->size, 0.0);
}

/* ---- the legend ---- */

struct entry {
  const char *text;
  uint32_t colour;
};

/* Chains stand for their carbon atoms, which have the tint itself. Ligands have colours by element. */
static bool is_shown(const struct annotation *annotation, uint32_t atom, bool of_chains) {
  const struct atom_label *label = &annotation->molecule->label[atom];
  if (!selection_takes(annotation->selected, label)) return false;
  return !of_chains || (!label->hetatm && strcmp(label->element.text, "C") == 0 && label->residue->chain[0] != '\0');
}

static bool find_entries(const struct annotation *annotation, struct entry entries[MOST_ENTRIES], size_t *count,
                         struct failure *failure) {
  const bool of_chains = strcmp(annotation->palette->name, "chain") == 0;
  *count = 0;
  for (uint32_t atom = 0; atom < annotation->molecule->atoms; ++atom) {
    const struct atom_label *label = &annotation->molecule->label[atom];
    const char *const text = of_chains ? label->residue->chain : label->element.text;
    if (text[0] == '\0' || !is_shown(annotation, atom, of_chains)) continue;
    size_t at = 0;
    while (at < *count && strcmp(entries[at].text, text) != 0) ++at;
    if (at < *count) continue;
    if (at == MOST_ENTRIES) return failure_in_input(failure, 0, "--legend has room for %d colours", MOST_ENTRIES);
    entries[(*count)++] = (struct entry){text, annotation->colour[atom]};
  }
  return true;
}

static bool write_entries(const struct writer *writer, double y, struct failure *failure) {
  struct entry entries[MOST_ENTRIES];
  size_t count = 0;
  if (!find_entries(writer->annotation, entries, &count, failure)) return false;
  double x = writer->width - 0.4 * writer->size;
  for (size_t i = count; i-- > 0;) {
    x -= 0.6 * writer->size + pen_width(entries[i].text, writer->size);
    write_text(writer, entries[i].text, x, y, writer->size, 0.0);
    x -= 1.2 * writer->size;
    const double corner[2] = {x, y - 0.45 * writer->size};
    const double behind[2] = {corner[0] - 0.06 * writer->size, corner[1] - 0.06 * writer->size};
    pen_rectangle(&writer->pen, behind, 1.02 * writer->size, 1.02 * writer->size, writer->colour);
    pen_rectangle(&writer->pen, corner, 0.9 * writer->size, 0.9 * writer->size, entries[i].colour);
  }
  return true;
}

static void write_ramp(const struct writer *writer, double y) {
  const struct ball_palette *palette = writer->annotation->palette;
  char text[2][TEXT_BYTES];
  snprintf(text[0], TEXT_BYTES, "%.4g", palette->low);
  snprintf(text[1], TEXT_BYTES, "%.4g", palette->high);
  const double part = 0.5 * writer->size;
  double x = writer->width - writer->size - pen_width(text[1], writer->size);
  write_text(writer, text[1], x, y, writer->size, 0.0);
  x -= 0.4 * writer->size + RAMP_PARTS * part;
  for (int i = 0; i < RAMP_PARTS; ++i) {
    /* Parts overlap, so that no light comes between them. */
    const double corner[2] = {x + i * part, y - 0.45 * writer->size};
    const double share = (double)i / (RAMP_PARTS - 1);
    const double value = palette->low * (1.0 - share) + palette->high * share;
    const double width = i + 1 < RAMP_PARTS ? 1.2 * part : part;
    pen_rectangle(&writer->pen, corner, width, 0.9 * writer->size, ball_palette_colour(palette, value));
  }
  write_text(writer, text[0], x - 0.4 * writer->size, y, writer->size, 1.0);
}

/* ---- all of it ---- */

bool annotation_write(const struct annotation *annotation, struct text_buffer *out, struct failure *failure) {
  const struct drawing *drawing = annotation->drawing;
  const hsp_picture_options *options = annotation->options;
  const struct writer writer = {.annotation = annotation,
                                .pen = {out, options->format, annotation->frame.height},
                                .width = annotation->frame.width,
                                .height = annotation->frame.height,
                                .size = annotation->frame.letter,
                                .colour = options->outline_colour,
                                .seam = options->background};
  const double y = writer.height - (annotation->frame.strip > 0.0 ? annotation->frame.strip / 2.0 : writer.size);
  bool done = true;
  pen_begin(&writer.pen);
  if (drawing->label >= 0) done = write_labels(&writer, failure);
  if (drawing->scale_bar) write_scale_bar(&writer, y);
  if (done && drawing->legend && annotation->palette->remark == NULL) write_ramp(&writer, y);
  if (done && drawing->legend && annotation->palette->remark != NULL) done = write_entries(&writer, y, failure);
  pen_end(&writer.pen);
  return done && (!out->out_of_memory || failure_of_memory(failure));
}
