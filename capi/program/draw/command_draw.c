/* hardsphere draw: a vector picture with hidden parts removed. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/annotation.h"
#include "draw/ball_and_stick.h"
#include "draw/ball_colours.h"
#include "draw/ball_groups.h"
#include "draw/ball_names.h"
#include "draw/highlight_view.h"
#include "draw/look.h"
#include "draw/occlusion.h"
#include "draw/page_labels.h"
#include "draw/picture_file.h"
#include "draw/picture_frame.h"
#include "draw/seen_areas.h"
#include "draw/spinning.h"
#include "draw/view_axes.h"
#include "draw/view_geometry.h"
#include "read/bonds.h"
#include "read/line_reader.h"
#include "write/output_file.h"
#include "write/report.h"

/* The result of drawing: of several pictures the first, with pieces, arcs and bytes of all. */
struct drawn {
  hsp_view_info view;        /* or as much of it as a map has, or balls and sticks have */
  uint32_t sticks, multiple; /* the latter where the file says so */
  bool multiple_shown;
  hsp_picture_options options;
  uint64_t bytes;
  double occlusion; /* as it was done */
  struct ball_palette palette;
  struct picture_frame frame;
};

/* The colour of every ball, to be freed on true, and the occlusion in it. */
static bool make_colours(const struct request *request, const struct molecule *molecule,
                         const struct geometry *geometry, uint32_t **colour, struct drawn *drawn,
                         struct failure *failure) {
  const struct drawing *drawing = &request->drawing;
  if (!ball_colours_make(drawing, &request->drawing.highlight, molecule, colour, &drawn->palette, failure))
    return false;
  drawn->occlusion = drawing_occlusion(drawing, molecule->atoms);
  const bool by_default = drawing->occlusion < 0.0;
  if (occlusion_darken(molecule, geometry, request->probe, &drawn->occlusion, by_default, *colour, failure)) {
    return true;
  }
  free(*colour);
  return false;
}

static bool view_options_of(const struct drawing *drawing, const struct molecule *molecule, hsp_view_options *options,
                            struct failure *failure) {
  const int32_t status = viewing_options(&drawing->viewing, molecule, options);
  if (drawing->pieces >= 0 && !drawing_is_of_map(drawing)) options->pieces = (uint32_t)drawing->pieces;
  if (drawing->all_balls) options->flags |= HSP_VIEW_ALL_BALLS;
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Among many balls and sticks lines do not suffice to show which are near: fog does. But the far end of a chain that
 * leads away from the viewer should be legible, too. */
enum { MOST_STICKS_AT_A_GLANCE = 60, MANY_STICKS = 200 };

static double fog_of_sticks(uint32_t balls) {
  return balls > MANY_STICKS ? 0.7 : 0.5;
}

static bool picture_options_of(const struct drawing *drawing, uint32_t balls, const hsp_view_info *view,
                               hsp_picture_options *options, struct picture_frame *frame, struct failure *failure) {
  const int32_t status = hsp_picture_options_init(options, (uint32_t)sizeof *options);
  if (status != HSP_OK) return failure_in_library(failure, status);
  options->format = (uint32_t)drawing->format;
  options->style = drawing_style(drawing, balls);
  if (drawing->unit >= 0) options->unit = (uint32_t)drawing->unit;
  options->width = drawing_default_width(drawing);
  if (drawing->height >= 0.0) {
    options->height = drawing->height;
    options->width = 0.0; /* follows, unless it is given too */
  }
  if (drawing->width >= 0.0) options->width = drawing->width;
  if (drawing->outline >= 0.0) options->outline = drawing->outline;
  const bool many_sticks = drawing_is_of_sticks(drawing) && balls > MOST_STICKS_AT_A_GLANCE;
  if (many_sticks) options->fog = fog_of_sticks(balls);
  if (drawing->fog >= 0.0) options->fog = drawing->fog;
  if (many_sticks && drawing->fog_of_many >= 0.0) options->fog = drawing->fog_of_many;
  if (drawing->margin >= 0.0) options->margin = drawing->margin;
  if (drawing->scale > 0.0) {
    options->scale = drawing->scale;
    memcpy(options->centre, drawing->centre.given ? drawing->centre.xyz : view->origin, sizeof options->centre);
  }
  picture_frame_set(drawing, view, options, frame);
  if (drawing->outline_colour >= 0) options->outline_colour = (uint32_t)drawing->outline_colour;
  for (int level = 0; level < INK_LEVELS; ++level) {
    if (drawing->ink_width[level] >= 0.0) options->ink_width[level] = drawing->ink_width[level];
    if (drawing->ink_colour[level] >= 0) options->ink_colour[level] = (uint32_t)drawing->ink_colour[level];
  }
  if (drawing->background == DRAWING_NO_BACKGROUND) {
    /* Nobody knows what far balls would have to fade to, unless the user says so. */
    options->flags |= HSP_PICTURE_NO_BACKGROUND;
    if (drawing->fog_colour >= 0) options->background = (uint32_t)drawing->fog_colour;
    if (drawing->fog_colour < 0) options->fog = 0.0;
  } else if (drawing->background >= 0) {
    options->background = (uint32_t)drawing->background;
  }
  return true;
}

/* A direction as a person reads it: with four decimals at most, and no "-0". */
#define DIRECTION_BYTES 64
static const char *direction_text(char out[DIRECTION_BYTES], const double direction[3]) {
  double rounded[3];
  for (int axis = 0; axis < 3; ++axis) rounded[axis] = floor(direction[axis] * 1e4 + 0.5) / 1e4 + 0.0;
  snprintf(out, DIRECTION_BYTES, "(%.4g, %.4g, %.4g)", rounded[0], rounded[1], rounded[2]);
  return out;
}

/* Find the box of the visible parts; no hidden ball reaches beyond it. */
static void find_box(const struct molecule *molecule, double probe, hsp_view_info *view) {
  const double *const axis[2] = {view->right, view->up};
  bool any = false;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double radius = molecule->radius[i] + probe;
    if (radius <= 0.0) continue;
    for (int k = 0; k < 2; ++k) {
      double at = 0.0;
      for (int c = 0; c < 3; ++c) at += axis[k][c] * (molecule->xyz[3 * (size_t)i + (size_t)c] - view->origin[c]);
      if (!any || at - radius < view->low[k]) view->low[k] = at - radius;
      if (!any || at + radius > view->high[k]) view->high[k] = at + radius;
    }
    any = true;
  }
}

static int32_t get_sticks_info(const hsp_sticks *sticks, struct drawn *drawn) {
  hsp_sticks_info info;
  hsp_view_info *const view = &drawn->view;
  const int32_t status = hsp_sticks_get_info(sticks, &info);
  if (status != HSP_OK) return status;
  memcpy(view->origin, info.origin, sizeof view->origin);
  memcpy(view->towards, info.towards, sizeof view->towards);
  memcpy(view->right, info.right, sizeof view->right);
  memcpy(view->up, info.up, sizeof view->up);
  memcpy(view->low, info.low, sizeof view->low);
  memcpy(view->high, info.high, sizeof view->high);
  view->pieces = info.paths;
  view->arcs = info.arcs;
  drawn->sticks = info.sticks;
  return HSP_OK;
}

static int32_t get_info(const struct request *request, const struct molecule *molecule, const struct geometry *geometry,
                        struct drawn *drawn) {
  hsp_map_info map;
  hsp_view_info *const view = &drawn->view;
  drawn->multiple = geometry->multiple_bonds;
  drawn->multiple_shown = geometry->multiple_shown;
  if (drawing_is_of_sticks(&request->drawing)) return get_sticks_info(geometry->sticks, drawn);
  if (!drawing_is_of_map(&request->drawing)) return hsp_view_get_info(geometry->work.view, view);
  const int32_t status = hsp_map_get_info(geometry->work.map, &map);
  if (status != HSP_OK) return status;
  memcpy(view->origin, map.origin, sizeof view->origin);
  memcpy(view->right, map.right, sizeof view->right);
  memcpy(view->up, map.up, sizeof view->up);
  memcpy(view->towards, map.towards, sizeof view->towards);
  view->pieces = map.balls;
  view->arcs = map.edges;
  find_box(molecule, request->probe, view);
  return HSP_OK;
}

static struct shown_bodies bodies_of(const struct request *request, const struct molecule *molecule,
                                     const struct bond *bond, uint32_t bonds) {
  const struct drawing *const drawing = &request->drawing;
  if (!drawing_is_of_sticks(drawing)) return (struct shown_bodies){molecule, 1.0, request->probe, NULL, 0, 0.0, NULL};
  return (struct shown_bodies){molecule, ball_and_stick_size(drawing),   0.0, bond,
                               bonds,    ball_and_stick_radius(drawing), NULL};
}

/* Adds the text over the picture. Labels are where a map of the balls says that there is room: sticks hide little. */
static bool annotate(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     const uint32_t *darkened, const struct drawn *drawn, struct text_buffer *over,
                     struct failure *failure) {
  const struct drawing *drawing = &request->drawing;
  struct ball_palette palette;
  struct page_label *labels = NULL;
  uint32_t *colour = NULL;
  uint32_t count = 0, left_out = 0;
  double *seen = NULL;
  bool *painted = NULL;
  bool done = ball_colours_make(drawing, &request->drawing.highlight, molecule, &colour, &palette, failure);
  if (!done) return false;
  /* Legends of kinds, of muted atoms, and of colours that occlusion darkens or fog fades. */
  const bool faded = drawn->occlusion > 0.0 || drawn->options.fog > 0.0;
  const bool several = drawing->colour == COLOUR_RESIDUE || request->drawing.highlight.count > 0;
  const bool of_seen = drawing->legend && palette.remark != NULL && (several || faded);
  const bool has_map = drawing_is_of_map(drawing) && !drawing_is_of_sticks(drawing);
  if (drawing->label >= 0 && !has_map) {
    done = geometry_compute_map(geometry, &drawing->viewing, molecule, failure);
  }
  if (drawing->label >= 0) {
    done = done && page_labels_find(geometry->work.map, molecule, &request->drawing.highlight, drawing->label, &labels,
                                    &count, failure);
  }
  struct shown_bodies bodies = bodies_of(request, molecule, geometry->bond, geometry->bonds);
  if (of_seen && !drawing_is_of_map(drawing) && !drawing_is_of_sticks(drawing)) {
    done = done && seen_areas_find_painted(geometry->work.view, molecule->atoms, &painted, failure);
    bodies.painted = painted;
  }
  if (of_seen) done = done && seen_areas_find(&bodies, &drawn->frame, &drawn->view, &seen, failure);
  const struct annotation annotation = {.drawing = drawing,
                                        .molecule = molecule,
                                        .options = &drawn->options,
                                        .frame = drawn->frame,
                                        .view = &drawn->view,
                                        .bodies = &bodies,
                                        .labels = labels,
                                        .label_count = count,
                                        .palette = &palette,
                                        .colour = colour,
                                        .darkened = darkened,
                                        .selected = &request->drawing.highlight,
                                        .seen = seen};
  done = done && annotation_write(&annotation, over, &left_out, failure);
  geometry->labels += count;
  geometry->labels_left_out += left_out;
  free(labels);
  free(colour);
  free(seen);
  free(painted);
  return done;
}

static bool write_picture(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                          const uint32_t *colour, struct drawn *drawn, struct failure *failure) {
  const int32_t status = get_info(request, molecule, geometry, drawn);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (!picture_options_of(&request->drawing, molecule->atoms, &drawn->view, &drawn->options, &drawn->frame, failure)) {
    return false;
  }
  struct text_buffer over = TEXT_BUFFER_EMPTY;
  const bool annotated = drawing_is_annotated(&request->drawing);
  if (annotated && !annotate(request, molecule, geometry, colour, drawn, &over, failure)) {
    text_buffer_free(&over);
    return false;
  }
  char description[160];
  char towards[DIRECTION_BYTES];
  snprintf(description, sizeof description, "%" PRIu32 " balls, seen from %s", molecule->atoms,
           direction_text(towards, drawn->view.towards));
  const char *title = request->drawing.title != NULL ? request->drawing.title : input_base_name(request->file);
  hsp_view *const view = drawing_is_of_map(&request->drawing) ? NULL : geometry->work.view;
  uint32_t *group = NULL;
  if (drawing_has_ink(&request->drawing)) {
    if (!ball_groups_make(&request->drawing, molecule, &group, failure)) {
      text_buffer_free(&over);
      return false;
    }
    drawn->options.ink = drawing_is_of_sticks(&request->drawing) ? NULL : geometry->work.map; /* labels need one */
    drawn->options.ink_of_sticks = geometry->ink_of_sticks;
    drawn->options.group = group;
  }
  struct ball_names names = BALL_NAMES_NONE;
  const bool classes = request->drawing.classes;
  const bool tooltips = request->drawing.tooltips;
  bool done = !(classes || tooltips) || ball_names_make(molecule, classes, tooltips, &names, failure);
  drawn->options.atom_class = names.class_of;
  drawn->options.atom_title = names.title_of;
  const struct picture picture = {view,        geometry->work.map, geometry->sticks,
                                  colour,      drawn->options,     title,
                                  description, over.text,          {drawn->frame.width, drawn->frame.height}};
  progress_show(&geometry->progress, "writing");
  done = done && picture_file_write(&picture, request->drawing.out, &geometry->progress, &drawn->bytes, failure);
  ball_names_free(&names);
  text_buffer_free(&over);
  free(group);
  return done;
}

/* Computes the parts of the picture. */
static bool compute(const struct request *request, const struct molecule *molecule, const uint32_t *colour,
                    struct geometry *geometry, struct failure *failure) {
  hsp_view_options options;
  if (drawing_is_of_sticks(&request->drawing)) {
    return ball_and_stick_compute(molecule, &request->drawing, colour, geometry, failure);
  }
  if (drawing_is_of_map(&request->drawing))
    return geometry_compute_map(geometry, &request->drawing.viewing, molecule, failure);
  return view_options_of(&request->drawing, molecule, &options, failure) &&
         (options.pieces != HSP_PIECES_OUTSIDE_ALL || geometry_compute_boundary(geometry, failure)) &&
         geometry_compute_view(geometry, &options, failure) &&
         (!drawing_has_ink(&request->drawing) ||
          geometry_compute_map(geometry, &request->drawing.viewing, molecule, failure));
}

/* The pictures of one turn, each a request of its own. */
static bool draw_turn(const struct request *request, const struct molecule *molecule, const uint32_t *colour,
                      struct geometry *geometry, struct drawn *drawn, struct failure *failure) {
  const int pictures = (int)request->drawing.spin;
  struct request one = *request;
  const int32_t status = spinning_fix_frame(&one.drawing, molecule, request->probe);
  if (status != HSP_OK) return failure_in_library(failure, status);
  for (int picture = 0; picture < pictures; ++picture) {
    struct drawn next = *drawn;
    const char *name = spinning_name(request->drawing.out, picture);
    if (name == NULL) return failure_of_memory(failure);
    one.drawing.out = name;
    one.drawing.viewing.spin = 360.0 * picture / pictures;
    if (request_reads(request, name)) {
      return failure_in_usage(failure, "-o would write over the file that is read");
    }
    if (!compute(&one, molecule, colour, geometry, failure)) return false;
    if (!write_picture(&one, molecule, geometry, colour, picture == 0 ? drawn : &next, failure)) return false;
    if (picture == 0) continue;
    drawn->view.pieces += next.view.pieces;
    drawn->view.arcs += next.view.arcs;
    drawn->bytes += next.bytes;
  }
  return true;
}

/* Find the direction of --view highlight. */
static bool find_view(struct drawing *drawing, const struct request *request, const struct molecule *molecule,
                      struct geometry *geometry, struct failure *failure) {
  struct bond *bonds = NULL;
  uint32_t count = 0;
  if (!drawing->viewing.of_highlight) return true;
  progress_show(&geometry->progress, "looking around");
  if (drawing_is_of_sticks(drawing) && !bonds_find(molecule, geometry, &bonds, &count, failure)) return false;
  const struct shown_bodies bodies = bodies_of(request, molecule, bonds, count);
  const bool done = highlight_view_find(&bodies, &request->drawing.highlight, &drawing->viewing, failure);
  free(bonds);
  return done;
}

static bool draw(const struct request *asked, const struct molecule *molecule, struct geometry *geometry,
                 struct drawn *drawn, struct failure *failure) {
  uint32_t *colour = NULL;
  struct request request = *asked;
  if (!find_view(&request.drawing, asked, molecule, geometry, failure)) return false;
  if (drawing_occlusion(&request.drawing, molecule->atoms) > 0.0) progress_show(&geometry->progress, "shading");
  if (!make_colours(&request, molecule, geometry, &colour, drawn, failure)) return false;
  const bool done = request.drawing.spin > 0 ? draw_turn(&request, molecule, colour, geometry, drawn, failure)
                                             : compute(&request, molecule, colour, geometry, failure) &&
                                                   write_picture(&request, molecule, geometry, colour, drawn, failure);
  free(colour);
  return done;
}

/* The values that are printed. */
struct found {
  const struct request *request;
  struct drawn drawn;
};

static void print(struct record *record, const void *of) {
  const struct request *const request = ((const struct found *)of)->request;
  const struct drawn *const drawn = &((const struct found *)of)->drawn;
  const struct ball_palette *const palette = &drawn->palette;
  const bool of_map = drawing_is_of_map(&request->drawing), of_sticks = drawing_is_of_sticks(&request->drawing);
  const int pictures = (int)request->drawing.spin;
  char value[160], remark[80], occlusion[NUMBER_BYTES], towards[DIRECTION_BYTES], up[DIRECTION_BYTES];
  snprintf(value, sizeof value, "%s, %s, %.6g x %.6g %s", drawing_format_name(drawn->options.format),
           drawing_style_name(drawn->options.style), drawn->options.width, drawn->options.height,
           drawn->options.unit == HSP_UNIT_MM ? "mm" : "px");
  record_text(record, NULL, "picture", value, "");
  if (pictures > 0) {
    record_count(record, NULL, "pictures", pictures, "of one turn, numbered from 000; view: that of the first");
  }
  snprintf(value, sizeof value, "%s towards the viewer, %s up", direction_text(towards, drawn->view.towards),
           direction_text(up, drawn->view.up));
  record_text(record, NULL, "view", value, "");
  snprintf(remark, sizeof remark, "from %s at %.6g to %s at %.6g", palette->falls ? "red" : "blue", palette->low,
           palette->falls ? "blue" : "red", palette->high);
  record_text(record, NULL, "palette", palette->name, palette->remark != NULL ? palette->remark : remark);
  snprintf(occlusion, sizeof occlusion, "%.6g", drawn->occlusion);
  record_text(record, NULL, "occlusion", occlusion,
              drawn->occlusion > 0.0 ? "buried balls are darker" : "no ball is darkened");
  if (of_sticks) {
    char multiple[60] = "";
    if (drawn->multiple > 0) {
      snprintf(multiple, sizeof multiple, "; %" PRIu32 " multiple ones%s", drawn->multiple,
               drawn->multiple_shown ? "" : ", drawn as single");
    }
    snprintf(value, sizeof value, "bonds by %scovalent radii%s",
             record->molecule->bonds == 0                             ? ""
             : file_format_has(record->molecule->format, FILE_BONDS)  ? "CONECT records, else by "
             : file_format_has(record->molecule->format, FILE_ORDERS) ? "the file, else by "
                                                                      : "_chem_comp_bond, else by ",
             multiple);
    record_count(record, NULL, "sticks", drawn->sticks, value);
  }
  record_atoms(record);
  record_count(record, "pieces", "pieces", drawn->view.pieces,
               of_sticks ? "balls, sticks and halves of sticks"
               : of_map  ? "balls, side by side"
                         : "painted one over the other, farthest first");
  record_count(record, "arcs", "arcs", drawn->view.arcs,
               of_sticks ? "of circles, ellipses and lines around them"
               : of_map  ? "of circles and ellipses between them"
                         : "of circles and ellipses around them");
  record_count(record, "bytes", "bytes", (int64_t)drawn->bytes, "");
  if (of_sticks) record_count(record, "sticks", NULL, drawn->sticks, "");
  if (pictures > 0) record_count(record, "pictures", NULL, pictures, "");
  record_text(record, "style", NULL, drawing_style_name(drawn->options.style), "");
  record_text(record, "palette", NULL, palette->name, "");
  record_number(record, "width", NULL, drawn->options.width, 0, "");
  record_number(record, "height", NULL, drawn->options.height, 0, "");
  record_number(record, "occlusion", NULL, drawn->occlusion, 0, "");
  const double range[2] = {palette->low, palette->high};
  if (palette->remark == NULL) record_numbers(record, "range", range, 2);
}

void describe_draw(const struct request *request, struct record *record) {
  struct found none = {.request = request};
  if (!drawing_is_of_values(&request->drawing)) none.drawn.palette.remark = "";
  print(record, &none);
}

bool command_draw(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  struct found found;
  memset(&found, 0, sizeof found);
  found.request = request;
  if (!draw(request, molecule, geometry, &found.drawn, failure)) return false;
  if (!output_is_standard(request->drawing.out)) report(request, molecule, print, &found, out);
  return true;
}

/* Whether the file has the data that colours are to stand for, and the names that labels are to show. */
static bool check_colours(const struct request *request, struct failure *failure) {
  const int colour = request->drawing.colour;
  char list[FORMAT_LIST_BYTES];
  if ((colour == COLOUR_CHAIN || colour == COLOUR_RESIDUE) && !file_format_has(request->format, FILE_RESIDUES)) {
    return failure_in_usage(failure, "--colour %s has no use here: the file names no residues",
                            colour == COLOUR_CHAIN ? "chain" : "residue");
  }
  if (request->drawing.label > LABEL_ATOM && !file_format_has(request->format, FILE_RESIDUES)) {
    return failure_in_usage(failure, "--label %s has no use here: the file names no residues",
                            request->drawing.label == LABEL_CHAIN ? "chain" : "residue");
  }
  if ((colour == COLOUR_BFACTOR || colour == COLOUR_PLDDT) &&
      !file_format_has(request->format, FILE_TEMPERATURE_FACTORS)) {
    return failure_in_usage(failure, "--colour %s is for %s files", colour == COLOUR_PLDDT ? "plddt" : "bfactor",
                            file_format_list(list, ".", "and", FILE_TEMPERATURE_FACTORS, true));
  }
  if (colour == COLOUR_CHARGE && !file_format_has(request->format, FILE_CHARGES)) {
    return failure_in_usage(failure, "--colour charge is for %s files",
                            file_format_list(list, ".", "and", FILE_CHARGES, true));
  }
  return true;
}

bool check_draw(struct request *request, struct failure *failure) {
  struct drawing *drawing = &request->drawing;
  if (!drawing_check(drawing, failure)) return false;
  look_apply(drawing);
  if (!check_colours(request, failure)) return false;
  return !drawing_is_of_sticks(drawing) || request->probe == 0.0 ||
         failure_in_usage(failure, "--probe is not for --as ball-and-stick");
}
