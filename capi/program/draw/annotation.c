#include "draw/annotation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/label_writing.h"
#include "draw/pen.h"
#include "draw/residue_colours.h"
#include "draw/text_width.h"
#include "read/residues.h"
#include "read/vectors.h"

enum { MOST_ENTRIES = 200, MOST_STRIPES = 4, RAMP_PARTS = 65, TEXT_BYTES = 48, MOST_POWERS = 300 };

static const double letter_height = 0.72; /* of capitals, in sizes */

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
  bool of_element;
  int rank;
  double seen, tone[3]; /* of its atoms: how much is seen of them, and the sums of their tones by that */
};

struct entries {
  struct entry entry[MOST_ENTRIES];
  size_t count;
  bool cut; /* there are more */
};

/* The nearest and farthest depth of painted centres; the mean radius of all balls. */
struct depths {
  double nearest, farthest, mean_radius;
};

struct legend {
  struct entries own;
  struct entry other[MOST_STRIPES]; /* the most visible colours of muted atoms, with one text for all */
  size_t others;
  struct depths depths; /* the range of fog */
  const char *quantity; /* the meaning of the numbers; NULL: it needs no words */
};

static bool is_by_residue(const struct annotation *annotation) {
  return strcmp(annotation->palette->name, "residue") == 0;
}

/* A legend of residues' kinds has only entries of visible atoms; other legends have all. */
static bool is_hidden(const struct annotation *annotation, uint32_t atom) {
  return is_by_residue(annotation) && !(annotation->seen[atom] > 0.0);
}

/* Find the entry of the legend to which an atom's colour belongs. If colours are by chain, carbon of a chain has the
 * chain's entry, as it has just the chain's colour; if they are by residue, atoms of residues have those of kinds; all
 * others have those of their elements. False: it has none. */
static bool find_entry(const struct annotation *annotation, uint32_t atom, struct entry *entry) {
  const struct atom_label *label = &annotation->molecule->label[atom];
  const bool by_chain = strcmp(annotation->palette->name, "chain") == 0;
  struct residue_colour kind;
  *entry = (struct entry){label->element.text, annotation->colour[atom], true, 0, 0.0, {0.0}};
  if (is_hidden(annotation, atom)) return false;
  if (annotation->palette->bands > 0) return true;
  if (by_chain && (atom_is_of_chain(label) || atom_is_water(label))) {
    *entry = (struct entry){label->residue->chain, annotation->colour[atom], false, 0, 0.0, {0.0}};
    return strcmp(label->element.text, "C") == 0;
  }
  if (is_by_residue(annotation) && residue_colour_find(label->residue->name, &kind)) {
    *entry = (struct entry){kind.kind, annotation->colour[atom], false, kind.rank, 0.0, {0.0}};
  }
  return true;
}

/* Chains and kinds before elements, shorter names first; of elements C and H, as formulas have them. */
static int compare_entries(const void *left, const void *right) {
  const struct entry *a = left;
  const struct entry *b = right;
  if (a->of_element != b->of_element) return a->of_element ? 1 : -1;
  if (a->rank != b->rank) return a->rank < b->rank ? -1 : 1;
  for (const char *first = a->of_element ? "CH" : ""; *first != '\0'; ++first) {
    const bool is[2] = {a->text[0] == *first && a->text[1] == '\0', b->text[0] == *first && b->text[1] == '\0'};
    if (is[0] != is[1]) return is[0] ? -1 : 1;
  }
  const size_t length[2] = {strlen(a->text), strlen(b->text)};
  if (!a->of_element && length[0] != length[1]) return length[0] < length[1] ? -1 : 1;
  return strcmp(a->text, b->text);
}

static double depth_of(const struct annotation *annotation, uint32_t atom) {
  return dot(annotation->view->towards, annotation->molecule->xyz + 3 * (size_t)atom);
}

/* Whether an atom is painted, as far as that is known. */
static bool is_painted(const struct annotation *annotation, uint32_t atom) {
  const bool *const painted = annotation->bodies->painted;
  return painted != NULL ? painted[atom] : annotation->seen != NULL && annotation->seen[atom] > 0.0;
}

static struct depths depths_of(const struct annotation *annotation) {
  struct depths depths = {-HUGE_VAL, HUGE_VAL, 0.0};
  const uint32_t atoms = annotation->molecule->atoms;
  for (uint32_t atom = 0; atom < atoms; ++atom) {
    depths.mean_radius += shown_bodies_radius(annotation->bodies, atom) / atoms;
    if (!is_painted(annotation, atom)) continue;
    depths.nearest = fmax(depths.nearest, depth_of(annotation, atom));
    depths.farthest = fmin(depths.farthest, depth_of(annotation, atom));
  }
  return depths;
}

/* The share of the background in an atom that is seen. */
static double fog_of(const struct annotation *annotation, const struct depths *depths, uint32_t atom) {
  double share = 0.0;
  hsp_picture_fog_share(depths->nearest, depths->farthest, depths->mean_radius, depth_of(annotation, atom), &share);
  return annotation->options->fog * share;
}

static void add_tone(const struct annotation *annotation, const struct depths *depths, uint32_t atom,
                     struct entry *entry) {
  if (annotation->seen == NULL || !(annotation->seen[atom] > 0.0)) return;
  const double seen = annotation->seen[atom], fog = fog_of(annotation, depths, atom);
  entry->seen += seen;
  for (int k = 0; k < 3; ++k) {
    const double own = annotation->darkened[atom] >> (16 - 8 * k) & 0xFF;
    const double behind = annotation->options->background >> (16 - 8 * k) & 0xFF;
    entry->tone[k] += seen * (own + fog * (behind - own));
  }
}

/* A swatch has the mean tone of the visible parts: buried ones are darker than the colour itself, far ones have more of
 * the background. */
static void set_mean_tone(struct entry *entry) {
  uint32_t colour = 0;
  if (!(entry->seen > 0.0)) return;
  for (int k = 0; k < 3; ++k) colour = colour << 8 | (uint32_t)(entry->tone[k] / entry->seen + 0.5);
  entry->colour = colour;
}

/* Add the entries of the selected atoms, or of all others. */
static void add_entries(const struct annotation *annotation, bool selected, const struct depths *depths,
                        struct entries *entries) {
  for (uint32_t atom = 0; atom < annotation->molecule->atoms; ++atom) {
    struct entry entry;
    if (selection_takes(annotation->selected, annotation->molecule, atom) != selected) continue;
    if (!find_entry(annotation, atom, &entry) || entry.text[0] == '\0') continue;
    size_t at = 0;
    while (at < entries->count &&
           (strcmp(entries->entry[at].text, entry.text) != 0 || entries->entry[at].of_element != entry.of_element)) {
      ++at;
    }
    if (at == MOST_ENTRIES) {
      entries->cut = true;
      break;
    }
    if (at == entries->count) entries->entry[entries->count++] = entry;
    add_tone(annotation, depths, atom, &entries->entry[at]);
  }
  for (size_t k = 0; k < entries->count; ++k) set_mean_tone(&entries->entry[k]);
}

/* Readers look for the colour of each kind that is named, and do not find less of it than a third of a swatch. */
static void drop_specks(const struct annotation *annotation, struct entries *entries) {
  const double least = annotation->frame.letter * annotation->frame.letter / 3.0;
  size_t kept = 0;
  for (size_t k = 0; k < entries->count; ++k) {
    const struct entry entry = entries->entry[k];
    if (entry.of_element || !is_by_residue(annotation) || entry.seen >= least) entries->entry[kept++] = entry;
  }
  entries->count = kept;
}

static void find_entries(const struct annotation *annotation, struct legend *legend) {
  struct entries *const own = &legend->own;
  own->count = 0;
  own->cut = false;
  legend->quantity = annotation->palette->quantity;
  for (size_t k = 0; k < annotation->palette->bands; ++k) {
    own->entry[own->count++] =
        (struct entry){annotation->palette->band[k].name, annotation->palette->band[k].colour, false, 0, 0.0, {0.0}};
  }
  if (own->count > 0) return;
  add_entries(annotation, true, &legend->depths, own);
  drop_specks(annotation, own);
  if (own->count == 0) return;
  qsort(own->entry, own->count, sizeof own->entry[0], compare_entries);
  /* There are chains C and N, too, and other things than residues are polar. */
  if (own->entry[0].of_element) return;
  legend->quantity = is_by_residue(annotation) ? "residues" : "chains";
}

static int compare_seen(const void *left, const void *right) {
  const struct entry *const a = left, *const b = right;
  return a->seen != b->seen ? (a->seen < b->seen ? 1 : -1) : compare_entries(left, right);
}

/* Muted atoms keep a little of their colours, so their swatch has several, in the order of the other entries. */
static void find_others(const struct annotation *annotation, struct legend *legend) {
  struct entries all = {.count = 0};
  add_entries(annotation, false, &legend->depths, &all);
  qsort(all.entry, all.count, sizeof all.entry[0], compare_seen);
  size_t stripes = all.count < MOST_STRIPES ? all.count : MOST_STRIPES;
  while (stripes > 1 && !(all.entry[stripes - 1].seen > 0.0)) --stripes;
  qsort(all.entry, stripes, sizeof all.entry[0], compare_entries);
  memcpy(legend->other, all.entry, stripes * sizeof all.entry[0]);
  legend->others = stripes;
}

/* The colours of the entry in a place; the entry of all muted atoms is behind the legend's own ones. */
static const struct entry *find_colours(const struct legend *legend, size_t place, size_t *colours) {
  *colours = place < legend->own.count ? 1 : legend->others;
  return place < legend->own.count ? &legend->own.entry[place] : legend->other;
}

static const char *text_of(const struct legend *legend, size_t place) {
  return place < legend->own.count ? legend->own.entry[place].text : "others";
}

static double entry_width(const struct legend *legend, size_t place, double size) {
  size_t colours;
  find_colours(legend, place, &colours);
  return (0.65 + pen_swatch_width(colours)) * size + text_width(text_of(legend, place), size);
}

static void write_swatch(const struct writer *writer, const struct legend *legend, size_t place, const double corner[2],
                         double size) {
  uint32_t colour[MOST_STRIPES];
  size_t colours;
  const struct entry *const entry = find_colours(legend, place, &colours);
  for (size_t k = 0; k < colours; ++k) colour[k] = entry[k].colour;
  pen_swatch_of(&writer->pen, corner, size, colour, colours, writer->colour);
}

/* Write entries from right to left. If there are too many they are closer, then letters are smaller, and then the last
 * entries are replaced by dots. */
static void write_entries(const struct writer *writer, double y) {
  static const double smallest = 0.55;
  static const char more[] = "..";
  struct legend legend;
  legend.depths = depths_of(writer->annotation);
  find_entries(writer->annotation, &legend);
  find_others(writer->annotation, &legend);
  const size_t entries = legend.own.count + (legend.others > 0 ? 1 : 0);
  const char *const quantity = legend.quantity;
  const double room = (writer->annotation->drawing->scale_bar ? 0.66 : 1.0) * writer->width - writer->size;
  double wide = quantity == NULL ? 0.0 : text_width(quantity, writer->size) + 0.6 * writer->size;
  for (size_t i = 0; i < entries; ++i) wide += entry_width(&legend, i, writer->size);
  const double air = wide + 0.3 * writer->size * (double)entries <= room ? 0.15 * writer->size : 0.0;
  const double size = writer->size * (wide <= room ? 1.0 : wide * smallest >= room ? smallest : room / wide);
  double left = (quantity == NULL ? 0.4 * size : text_width(quantity, size) + size) +
                (wide * smallest > room || legend.own.cut ? text_width(more, size) : 0.0);
  size_t shown = 0;
  while (shown < entries && left + entry_width(&legend, shown, size) <= room + 0.5 * size) {
    left += entry_width(&legend, shown++, size);
  }
  double x = writer->width - 0.4 * writer->size;
  if (shown < entries || legend.own.cut) {
    x -= text_width(more, size);
    write_text(writer, more, x, y, size, 0.0);
  }
  for (size_t i = shown; i-- > 0;) {
    size_t colours;
    find_colours(&legend, i, &colours);
    x -= air + 0.4 * size + text_width(text_of(&legend, i), size);
    write_text(writer, text_of(&legend, i), x, y, size, 0.0);
    x -= air + (0.25 + pen_swatch_width(colours)) * size;
    const double corner[2] = {x, y - 0.45 * size};
    write_swatch(writer, &legend, i, corner, size);
  }
  if (quantity != NULL) write_text(writer, quantity, x - 0.6 * size, y, size, 1.0);
}

/* The quantity with its unit, and the ramp between the two ends. */
static void write_ramp(const struct writer *writer, double y) {
  const struct ball_palette *palette = writer->annotation->palette;
  char text[3][TEXT_BYTES];
  snprintf(text[0], TEXT_BYTES, "%.4g", palette->low);
  snprintf(text[1], TEXT_BYTES, "%.4g", palette->high);
  const double part = 8.5 / RAMP_PARTS * writer->size;
  double x = writer->width - writer->size - text_width(text[1], writer->size);
  write_text(writer, text[1], x, y, writer->size, 0.0);
  x -= 0.4 * writer->size + RAMP_PARTS * part;
  for (int i = 0; i < RAMP_PARTS; ++i) {
    /* Parts overlap, so that no light comes between them. */
    const double corner[2] = {x + i * part, y - 0.45 * writer->size};
    const double share = (double)i / (RAMP_PARTS - 1);
    const double value = palette->low * (1.0 - share) + palette->high * share;
    const double width = i + 1 < RAMP_PARTS ? 1.5 * part : part;
    pen_rectangle(&writer->pen, corner, width, 0.9 * writer->size, ball_palette_colour(palette, value));
  }
  write_text(writer, text[0], x - 0.4 * writer->size, y, writer->size, 1.0);
  const char *const sign = palette->power > 0 ? writer->annotation->molecule->format->sign : "";
  snprintf(text[2], TEXT_BYTES, "%s%s%s%s", palette->quantity, sign[0] == '\0' ? "" : ", ", sign,
           sign[0] != '\0' && palette->power == 2 ? "\xC2\xB2" : "");
  write_text(writer, text[2], x - 1.2 * writer->size - text_width(text[0], writer->size), y, writer->size, 1.0);
}

/* ---- all of it ---- */

bool annotation_write(const struct annotation *annotation, struct text_buffer *out, uint32_t *left_out,
                      struct failure *failure) {
  const struct drawing *drawing = annotation->drawing;
  const hsp_picture_options *options = annotation->options;
  const struct writer writer = {
      .annotation = annotation,
      .pen = {out, options->format, annotation->frame.height},
      .width = annotation->frame.width,
      .height = annotation->frame.height,
      .size = annotation->frame.letter,
      .colour = drawing->text_colour >= 0 ? (uint32_t)drawing->text_colour : options->outline_colour,
      .seam = options->background};
  const double y = writer.height - (annotation->frame.strip > 0.0 ? annotation->frame.strip / 2.0 : writer.size);
  bool done = true;
  pen_begin(&writer.pen);
  *left_out = 0;
  if (drawing->label >= 0) done = labels_write(annotation, &writer.pen, writer.colour, writer.seam, left_out, failure);
  if (drawing->scale_bar) write_scale_bar(&writer, y);
  if (done && drawing->legend && annotation->palette->remark == NULL) write_ramp(&writer, y);
  if (done && drawing->legend && annotation->palette->remark != NULL) write_entries(&writer, y);
  pen_end(&writer.pen);
  return done && (!out->out_of_memory || failure_of_memory(failure));
}
