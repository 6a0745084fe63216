/* hardsphere/picture.h: a view, a visibility map, or balls and sticks as SVG, EPS or PDF.
 *
 * Guide: gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * A view as a vector picture: one path per piece, true arcs, painted back to front. A map as a vector picture: one path
 * for each ball that is seen, around all of its faces; no two paths overlap, and lines are drawn apart, each edge once.
 * Maps serve plotters, cutters and click maps. On screens the background shines through the seams between their paths;
 * pictures of views have no seams. Balls and sticks: one path for each ball and half of a stick, painted back to front;
 * or, where they have no such order, around what is seen of each, as of a map. The bytes depend on these, the colours
 * and the options alone, not on the machine.
 *   SVG   elliptical arcs, and circles for balls that are seen whole; each ball carries the caller's index as
 *         data-ball, or in an id where it has classes. In styles with light it is a group with the ball's colour around
 *         its path, with light over it, in coordinates in which the ball's disc is the unit circle: a style sheet that
 *         sets the fill of the group keeps the light. Fog is in both, and what a style sheet sets has that of the light
 *         alone. Names begin with four digits or letters that depend on what is named, so that several pictures can
 *         stand inline in one page
 *   EPS   arcs of the unit circle under a matrix: exact
 *   PDF   cubic pieces of at most 90 degrees: within .01 px of the arc, besides being rounded to that; to a ten
 *         thousandth of the longer side on pages of less than 100 px. Of its objects, 1 is the catalogue, 3 the page
 *         and 5 its contents, which leave the graphics state as it is; its resources, 4, have Helvetica with
 *         WinAnsiEncoding as /F1, for texts that an incremental update adds, the first object of which may be 11
 * An ellipse whose lesser semi-axis is below an eighth of the width of the lines, and below 0.2 px, is drawn as a line,
 * which it nearly is: along flatter ellipses many a renderer breaks the stroke. Without lines the bound is 1e-4 px.
 */
#ifndef HARDSPHERE_PICTURE_H
#define HARDSPHERE_PICTURE_H

#include "map.h"
#include "sticks.h"
#include "view.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Takes `count` bytes; returns 0 to go on and anything else to stop. */
typedef int32_t(HSP_CALL *hsp_sink)(void *context, const char *bytes, size_t count);

#define HSP_FORMAT_SVG UINT32_C(0) /**< Scalable Vector Graphics 1.1 */
#define HSP_FORMAT_EPS UINT32_C(1) /**< Encapsulated PostScript, language level 3 */
#define HSP_FORMAT_PDF UINT32_C(2) /**< PDF 1.4, compressed PDF 1.5; one page */

#define HSP_STYLE_FLAT UINT32_C(0)      /**< one colour per ball */
#define HSP_STYLE_HEADLIGHT UINT32_C(1) /**< light from the viewer, Lambert's law in 16 steps of a radial gradient */
#define HSP_STYLE_SOFT UINT32_C(2)      /**< light from the upper left, an approximation by a focal gradient */

#define HSP_UNIT_PX UINT32_C(0) /**< 1/96 inch */
#define HSP_UNIT_MM UINT32_C(1) /**< millimetres */

#define HSP_PICTURE_NO_IDS UINT32_C(1) /**< SVG without data-ball, and without ids of balls */
/** Nothing behind the balls; fog still fades to the background colour. */
#define HSP_PICTURE_NO_BACKGROUND UINT32_C(2)

/** The look of a picture. hsp_picture_options_init sets the defaults; every field means what it says.
 *
 *  Without a scale all that is seen is fitted into the picture: of width and height the one that is 0 follows, and with
 *  both given the balls are in the middle. With a scale the frame is fixed, for movies and for pictures side by side:
 *  `centre` is in the middle whatever the direction, lengths are the same in every picture, and a side that is 0 is as
 *  long as the other one. Everything beyond the edges is cut off there: by the viewBox of SVG, a clip path of EPS, the
 *  MediaBox of PDF. Chosen lines depend on the scale and on the radii of all balls of the model alone. Fog still goes
 *  from the nearest to the farthest ball of the view, or through five mean radii of the model's balls if that is more.
 *  A view that is fitted without margin and lines into a picture of the shape of its box (hsp_view_info) has the scale
 *  width / (high[0] - low[0]) and the centre origin + right (low[0] + high[0]) / 2 + up (low[1] + high[1]) / 2. */
typedef struct hsp_picture_options {
  uint32_t struct_size; /**< sizeof(hsp_picture_options) */
  uint32_t format;      /**< HSP_FORMAT_*; default SVG */
  uint32_t style;       /**< HSP_STYLE_*; default flat */
  uint32_t unit;        /**< HSP_UNIT_* of width, height, outline and ink_width; default px */
  double width;         /**< of the picture; 0: follows from height; less than 0.01 counts as 0.01; default 1000 */
  double height;        /**< likewise, from width; default 0 */
  double margin;        /**< around the balls, as a part of the larger side of their box, in [0, 10]; default 0.03. Of
                                no effect with a scale. Lines around them have room in any case */
  double outline;       /**< width of the lines along silhouettes and intersections; 0 (or less than 5e-5 px): none;
                                < 0: chosen; default -1 */
  double fog;           /**< how far the farthest ball fades to the background, in [0, 1], if it is five mean radii or
                                more behind the nearest; default 0.3 */
  uint32_t outline_colour; /**< 0xRRGGBB; default 0x23202B */
  uint32_t background;     /**< 0xRRGGBB; default 0xFFFFFF */
  uint32_t flags;          /**< HSP_PICTURE_*; default 0 */
  uint32_t reserved;       /**< 0 */
  double scale;     /**< of a fixed frame: px or mm of the picture per unit of length; default 0: no fixed frame */
  double centre[3]; /**< of a fixed frame: the point in space in its middle, length; default 0 0 0. Without a scale it
                                has to be that */
  void *memory;     /**< scratch memory of any alignment, with which PDF is compressed (Deflate) to a third to a seventh
                                of its size; default NULL: it is not. Of no effect on other formats */
  size_t memory_bytes;    /**< of memory, HSP_PICTURE_MEMORY or more; default 0, as it has to be without memory */
  const hsp_map *ink;     /**< a computed map of the same model from the same direction, with which contours are drawn:
                                see HSP_INK_BORDER; default NULL: none. Of balls and sticks see ink_of_sticks */
  const uint32_t *group;  /**< of each ball of the model: numbers of groups, such as chains, residues or ligands, for
                                HSP_INK_GROUP; default NULL: all balls are of one */
  double ink_width[3];    /**< HSP_INK_*: of contours where they are widest; 0: none; < 0: chosen; default -1 */
  uint32_t ink_colour[3]; /**< HSP_INK_*: 0xRRGGBB, fades like lines; default 0x23202B */
  uint32_t reserved_for_ink;       /**< 0 */
  const char *const *atom_class;   /**< SVG: of each ball of the model, each NULL, empty or names of classes with blanks
                                between them, NUL-terminated UTF-8. Such balls have their index in an id, "a", four
                                digits or letters, "-" and the index, and not in data-ball; halves of sticks have
                                classes and data-ball. Default NULL: none; of no effect on other formats */
  const char *const *atom_title;   /**< SVG: likewise texts that browsers show beside the pointer; default NULL: none */
  const hsp_sticks *ink_of_sticks; /**< as ink, for a picture of balls and sticks: a computed map of the same balls and
                                sticks from the same direction (hsp_sticks_compute_map); default NULL: no contours */
  size_t reserved_for_sticks;      /**< 0 */
} hsp_picture_options;

/** Contours along silhouettes, areas of a width that depends on the gap g between the silhouette and what lies behind
 *  it: as wide as ink_width where g is three mean radii of the model's balls or more, with width (g / 3)^(5/8) below.
 *  They taper to nothing at tangencies, where silhouettes go over into creases. Where g jumps, at a T-junction, the
 *  thinner part widens to the thicker one, so that widths are continuous along a silhouette. In a gap, where between
 *  two nearer bodies less of a ball's silhouette is seen, without background behind it, than eight times the largest
 *  width, widths are less in proportion. Fog f takes its share f of a width. Contours are painted directly after their
 *  ball, and go on under nearer ones. SVG: paths of class border, group or depth, without data-ball.
 *  Sticks have them along both sides, as parts of their balls.
 *  No contour is wider than the radius of its ball or stick. Chosen widths are 3.1, 2.2 and 2.9 px where the mean
 *  radius of what is seen is 34 px; lines are then thinner, where they are chosen, too: .5 px, and none between more
 *  than 1000 balls. */
#define HSP_INK_BORDER UINT32_C(0) /**< before the background */
#define HSP_INK_GROUP UINT32_C(1)  /**< before a ball of another group: at least width min(1, 2 g) */
#define HSP_INK_DEPTH UINT32_C(2)  /**< before a ball of the same group */

/** The width of a contour before a gap, as pictures have it (HSP_INK_DEPTH), for contours that are drawn elsewhere:
 *  full_width where the gap is three mean radii or more, its share (gap / 3)^(5/8) below.
 *  @param      full_width  where nothing is less in proportion
 *  @param      gap         in mean radii
 *  @param[out] width       in the unit of full_width
 *
 *  Cost: O(1).
 *  @retval HSP_E_ARGUMENT    width is NULL
 *  @retval HSP_E_NOT_FINITE  a number is NaN or infinite
 *  @retval HSP_E_RANGE       a number is negative */
HSP_API int32_t HSP_CALL hsp_picture_ink_width(double full_width, double gap, double *width);

/** How much of the fog lies over a ball, as pictures have it, for colours that are shown elsewhere: 0 at the nearest
 *  centre and 1 at the farthest one, or at five mean radii behind the nearest one, if that is farther; in between
 *  f^(5/4) of the way f. The background's share in a colour is that times options.fog.
 *  @param      nearest      the largest depth of a centre, which grows towards the viewer
 *  @param      farthest     the least one
 *  @param      mean_radius  of the balls
 *  @param      depth        of the ball's centre
 *  @param[out] share        from 0 to 1
 *
 *  Cost: O(1).
 *  @retval HSP_E_ARGUMENT    share is NULL
 *  @retval HSP_E_NOT_FINITE  a number is NaN or infinite
 *  @retval HSP_E_RANGE       mean_radius is negative */
HSP_API int32_t HSP_CALL hsp_picture_fog_share(double nearest, double farthest, double mean_radius, double depth,
                                               double *share);

/** Bytes of memory that compression takes. */
#define HSP_PICTURE_MEMORY UINT32_C(71680)

/** Fill options with defaults.
 *  @retval HSP_E_ARGUMENT  options is NULL
 *  @retval HSP_E_VERSION   struct_size is bad */
HSP_API int32_t HSP_CALL hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size);

#define HSP_PALETTE_SOFT UINT32_C(0)  /**< muted colours by element */
#define HSP_PALETTE_JMOL UINT32_C(1)  /**< Jmol's colours by element */
#define HSP_PALETTE_CHAIN UINT32_C(2) /**< a tint for each chain, carbon lighter than other elements */

/** A palette's colour, 0xRRGGBB, for an atomic number (0 or above 109: unknown) and a chain number 0, 1, ..: tints
 *  repeat after 12 chains. Palettes by element ignore the chain. An unknown palette counts as HSP_PALETTE_SOFT. */
HSP_API uint32_t HSP_CALL hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain);

/** Write a picture of a computed view.
 *  colour [n] holds 0xRRGGBB for each ball of the model, NULL: all 0xD2CDC3. options may be NULL (defaults). title and
 *  description are NUL-terminated UTF-8 texts for the file, NULL or empty for none; what a format cannot hold, in EPS
 *  all but ASCII, is replaced by '?'. sink is called any number of times in order with at most 1024 bytes and is given
 *  `context`; bytes, if not NULL, becomes the number of bytes that the sink has taken.
 *  The sink is called only when all else is well. Uses the view's scratch memory, hence not const; results stay valid.
 *  - Property 1: the same bytes for every order of the balls, up to their indices. (Of balls that are equal
 *    in centre and radius the first one counts, with its colour.)
 *
 *  Cost: O(pieces log pieces + arcs); bytes proportional to arcs.
 *  @retval HSP_E_ARGUMENT    view or sink is NULL; unknown format, style, unit or flag; width and height are both 0; a
 *                            centre without a scale; a colour above 0xFFFFFF; memory_bytes without memory; ink is no
 *                            computed map of the same model from the same direction; ink_of_sticks is not NULL
 *  @retval HSP_E_HANDLE      view is no live view, or ink no live map
 *  @retval HSP_E_VERSION     bad struct_size, or a reserved field is not 0
 *  @retval HSP_E_MEMORY      memory_bytes is less than HSP_PICTURE_MEMORY, and there is memory
 *  @retval HSP_E_STATE       the view holds no results, or the model has changed since
 *  @retval HSP_E_SINK        the sink refused
 *  @retval HSP_E_NOT_FINITE  a value of options is NaN or infinite
 *  @retval HSP_E_RANGE       width or height is negative or beyond 1e6, margin or fog beyond its range, outline or
 *                            ink_width beyond 1e6, scale negative; a ball reaches farther than 1e7 px from the middle
 *                            of a fixed frame */
HSP_API int32_t HSP_CALL hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options,
                                           const char *title, const char *description, hsp_sink sink, void *context,
                                           uint64_t *bytes);

/** Write a picture of what is seen, from a computed map: for each ball that is seen one path around all of its faces,
 *  farthest ball first. Paths share their borders and nothing else; holes are clockwise loops, by either fill rule. All
 *  arguments are those of hsp_picture_write, and all options apply:
 *    lines        are drawn after all paths, every edge of the map once, as parts of open paths; those of a ball, its
 *                 silhouette and where it is the nearer one of a crease, follow each other. SVG: without data-ball, and
 *                 a click on them goes to what is below
 *    fitted size  what is seen of the balls has the same box as in a view
 *  Coordinates are rounded as in pictures of views, in SVG to 0.01 px or less on pages of up to 1000 px, in styles with
 *  light to 0.03 px: by so much neighbours may overlap or leave a gap. Of a map whose balls were moved (hsp_map_info)
 *  it shows the moved ones.
 *  Uses the map's scratch memory, hence not const; results stay valid.
 *  - Property 1: the same bytes for every order of the balls, up to their indices. (Of balls that are equal
 *    in centre and radius the first one counts, with its colour.)
 *
 *  Cost: O(edges log edges); bytes proportional to edges.
 *  @retval HSP_E_ARGUMENT    map or sink is NULL; unknown format, style, unit or flag; width and height are both 0; a
 *                            centre without a scale; a colour above 0xFFFFFF; memory_bytes without memory; ink is no
 *                            computed map of the same model from the same direction; ink_of_sticks is not NULL
 *  @retval HSP_E_HANDLE      map is no live map, or ink no live map
 *  @retval HSP_E_VERSION     bad struct_size, or a reserved field is not 0
 *  @retval HSP_E_MEMORY      memory_bytes is less than HSP_PICTURE_MEMORY, and there is memory
 *  @retval HSP_E_STATE       the map holds no results, or the model has changed since
 *  @retval HSP_E_SINK        the sink refused
 *  @retval HSP_E_NOT_FINITE  a value of options is NaN or infinite
 *  @retval HSP_E_RANGE       width or height is negative or beyond 1e6, margin or fog beyond its range, outline or
 *                            ink_width beyond 1e6, scale negative; a ball reaches farther than 1e7 px from the middle
 *                            of a fixed frame */
HSP_API int32_t HSP_CALL hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options,
                                               const char *title, const char *description, hsp_sink sink, void *context,
                                               uint64_t *bytes);

/** Write a picture of computed balls and sticks. All arguments are those of hsp_picture_write, and all options apply. A
 *  half of a stick has the colour and the fog of its ball, and its data-ball. In styles with light only balls are
 *  shaded; sticks have one colour, that of a ball halfway to its rim. Uses scratch memory, hence not const; results
 *  stay valid.
 *
 *  Cost: O(paths log paths); bytes proportional to paths.
 *  @retval HSP_E_ARGUMENT    sticks or sink is NULL; unknown format, style, unit or flag; width and height are both 0;
 *                            a centre without a scale; a colour above 0xFFFFFF; memory_bytes without memory; ink is not
 *                            NULL; ink_of_sticks has no map of the same balls and sticks from the same direction
 *  @retval HSP_E_HANDLE      sticks is no live handle, or ink_of_sticks none
 *  @retval HSP_E_VERSION     bad struct_size, or a reserved field is not 0
 *  @retval HSP_E_MEMORY      memory_bytes is less than HSP_PICTURE_MEMORY, and there is memory
 *  @retval HSP_E_STATE       nothing computed, or the model has changed since
 *  @retval HSP_E_SINK        the sink refused
 *  @retval HSP_E_NOT_FINITE  a value of options is NaN or infinite
 *  @retval HSP_E_RANGE       width or height is negative or beyond 1e6, margin or fog beyond its range, outline or
 *                            ink_width beyond 1e6, scale negative; a ball reaches farther than 1e7 px from the middle
 *                            of a fixed frame */
HSP_API int32_t HSP_CALL hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour,
                                                  const hsp_picture_options *options, const char *title,
                                                  const char *description, hsp_sink sink, void *context,
                                                  uint64_t *bytes);

#ifdef __cplusplus
}
#endif

#endif
