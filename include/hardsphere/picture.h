/* hardsphere/picture.h: writes a view, a visibility map, or balls and sticks as an SVG, EPS or PDF picture.
 *
 * Guide: gallery.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * The picture of a view has one path per piece, with true arcs, painted back to front. The picture of a map has one
 * path for each ball that is seen, around all of its faces; no two paths overlap, and lines are drawn separately, each
 * edge once. Maps serve plotters, cutters and click maps. On screens the background shines through the seams between
 * their paths; pictures of views have no seams. The picture of balls and sticks has one path for each ball and half of
 * a stick, painted back to front; or, where there is no such order, around the visible part of each, as for a map. The
 * bytes depend only on the view, map or sticks, the colours and the options, not on the machine.
 *   SVG   elliptical arcs, and circles for balls that are seen whole; each ball carries the caller's index as
 *         data-ball, or in an id where it has classes. In styles with light a ball is a group that has the ball's
 *         colour, with its path and the light over it, in coordinates in which the ball's disc is the unit circle: a
 *         style sheet that sets the fill of the group keeps the light. Fog is in the colour and in the light; a fill
 *         from a style sheet keeps only the fog of the light. Names begin with four digits or letters that depend on
 *         the content, so that several pictures can stand inline in one page
 *   EPS   arcs of the unit circle under a matrix: exact
 *   PDF   cubic pieces of at most 90 degrees, within .01 px of the arc; coordinates are rounded to .01 px, on pages of
 *         less than 100 px to a ten thousandth of the longer side. Of its objects, 1 is the catalogue, 3 the page and 5
 *         its contents, which leave the graphics state as it is; its resources, 4, have Helvetica with WinAnsiEncoding
 *         as /F1, for texts that an incremental update adds, the first object of which may be 11
 * An ellipse whose lesser semi-axis is below an eighth of the width of the lines, and below 0.2 px, is drawn as a
 * straight line, as many renderers break the stroke along such flat ellipses. Without lines the bound is 1e-4 px.
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

/** A function of the caller's that takes `count` bytes; returns 0 to go on and anything else to stop. bytes are valid
 *  during the call alone; context is what the writing function was given. */
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

/** The look of a picture. hsp_picture_options_init sets the defaults. Unlike in other options a field that is 0 is
 *  taken as 0, not as the default.
 *
 *  Without a scale all that is seen is fitted into the picture: if width or height is 0 it follows from the other; if
 *  both are given the balls are in the middle. With a scale the frame is fixed, for movies and for pictures side by
 *  side: `centre` is in the middle whatever the direction, lengths are the same in every picture, and a side that is 0
 *  is as long as the other one. Everything beyond the edges is cut off there: by the viewBox of SVG, a clip path of
 *  EPS, the MediaBox of PDF. Default widths of lines depend only on the scale and on the radii of all balls of the
 *  model. Fog still goes from the nearest to the farthest ball of the view, or through five mean radii of the model's
 *  balls if that is more. A view that is fitted without margin and lines into a picture of the shape of its box
 *  (hsp_view_info) has the scale width / (high[0] - low[0]) and the centre origin + right (low[0] + high[0]) / 2 + up
 *  (low[1] + high[1]) / 2. */
typedef struct hsp_picture_options {
  uint32_t struct_size; /**< sizeof(hsp_picture_options) */
  uint32_t format;      /**< HSP_FORMAT_*; default SVG */
  uint32_t style;       /**< HSP_STYLE_*; default flat */
  uint32_t unit;        /**< HSP_UNIT_* of width, height, outline and ink_width; default px */
  double width;         /**< of the picture; 0: follows from height; less than 0.01 counts as 0.01; default 1000 */
  double height;        /**< likewise, from width; default 0 */
  double margin;        /**< around the balls, as a part of the larger side of their box, in [0, 10]; default 0.03. Of
                                no effect with a scale. Lines around the balls have room even with 0 */
  double outline;       /**< width of the lines along silhouettes and intersections; 0 (or less than 5e-5 px): none;
                                < 0: the library chooses; default -1 */
  double fog;           /**< how far the farthest ball fades to the background, in [0, 1], if it is five mean radii or
                                more behind the nearest; default 0.3 */
  uint32_t outline_colour; /**< 0xRRGGBB; default 0x23202B */
  uint32_t background;     /**< 0xRRGGBB; default 0xFFFFFF */
  uint32_t flags;          /**< HSP_PICTURE_*; default 0 */
  uint32_t reserved;       /**< 0 */
  double scale;     /**< of a fixed frame: px or mm of the picture per unit of length; default 0: no fixed frame */
  double centre[3]; /**< of a fixed frame: the point in space in its middle, length; default 0 0 0, which it has to be
                                without a scale */
  void *memory;     /**< scratch memory of any alignment, with which PDF is compressed (Deflate) to a third to a seventh
                                of its size; default NULL: no compression. Of no effect on other formats */
  size_t memory_bytes;    /**< of memory, HSP_PICTURE_MEMORY or more; default 0, as it has to be without memory */
  const hsp_map *ink;     /**< a computed map of the same model from the same direction, with which contours are drawn:
                                see HSP_INK_BORDER; default NULL: none. Of balls and sticks see ink_of_sticks */
  const uint32_t *group;  /**< [balls of the model]: the number of each ball's group, such as chain, residue or ligand,
                                for HSP_INK_GROUP; default NULL: all balls are of one group */
  double ink_width[3];    /**< [HSP_INK_*]: largest width of contours; 0: none; < 0: the library chooses; default -1 */
  uint32_t ink_colour[3]; /**< [HSP_INK_*]: 0xRRGGBB, fades like lines; default 0x23202B */
  uint32_t reserved_for_ink;       /**< 0 */
  const char *const *atom_class;   /**< SVG: [balls of the model], each NULL, empty or names of classes with blanks
                                between them, NUL-terminated UTF-8. Balls with classes have their index in an id, "a",
                                four digits or letters, "-" and the index, and not in data-ball; halves of sticks have
                                classes and data-ball. Default NULL: none; of no effect on other formats */
  const char *const *atom_title;   /**< SVG: likewise texts that browsers show beside the pointer; default NULL: none */
  const hsp_sticks *ink_of_sticks; /**< as ink, for a picture of balls and sticks: a computed map of the same balls and
                                sticks from the same direction (hsp_sticks_compute_map); default NULL: no contours */
  size_t reserved_for_sticks;      /**< 0 */
} hsp_picture_options;

/** Contours before the background. Contours are areas along silhouettes. Their width depends on the gap g between the
 *  silhouette and what lies behind it, in mean radii of the model's balls: ink_width where g is 3 or more, ink_width
 *  times (g / 3)^(5/8) below. They taper to nothing at tangencies, where silhouettes continue as creases. Where g
 *  jumps, at a T-junction, the thinner part widens to the thicker one, so that widths are continuous along a
 *  silhouette. Where a piece of a ball's silhouette, seen between two nearer bodies and without background behind it,
 *  is shorter than eight times the largest width, widths shrink in proportion. Fog that covers a fraction f of a colour
 *  makes a contour narrower by the same fraction. Contours are painted directly after their ball, and go on under
 *  nearer ones. SVG: paths of class border, group or depth, without data-ball.
 *  Sticks have contours along both sides, as parts of their balls.
 *  No contour is wider than the radius of its ball or stick. Default widths of the three kinds are 3.1, 2.2 and 2.9 px
 *  where the mean radius of the visible balls is 34 px; default lines are thinner with contours: .5 px, and none
 *  between more than 1000 balls. */
#define HSP_INK_BORDER UINT32_C(0) /**< before the background */
#define HSP_INK_GROUP UINT32_C(1)  /**< before a ball of another group: at least width min(1, 2 g) */
#define HSP_INK_DEPTH UINT32_C(2)  /**< before a ball of the same group */

/** The width of a contour before a gap, as pictures have it (HSP_INK_DEPTH), for contours that are drawn elsewhere:
 *  full_width where the gap is three mean radii or more, full_width (gap / 3)^(5/8) below.
 *  @param      full_width  the width of contours before wide gaps, in any unit
 *  @param      gap         in mean radii
 *  @param[out] width       in the unit of full_width
 *
 *  Cost: O(1).
 *  @retval HSP_E_ARGUMENT    width is NULL
 *  @retval HSP_E_NOT_FINITE  a number is NaN or infinite
 *  @retval HSP_E_RANGE       a number is negative */
HSP_API int32_t HSP_CALL hsp_picture_ink_width(double full_width, double gap, double *width);

/** How much of the fog lies over a ball, as pictures have it, for colours that are shown elsewhere: 0 at the nearest
 *  centre, 1 at the farthest one, or at five mean radii behind the nearest one if that is farther; in between f^(5/4)
 *  at the fraction f of this depth. The background's share in a colour is *share times options.fog.
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

/** Bytes of hsp_picture_options.memory that compression takes. */
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
 *  all but ASCII, is replaced by '?'. sink is called any number of times in order with at most 1024 bytes each and is
 *  given `context`; *bytes, if not NULL, becomes the number of bytes that the sink has taken. The sink is called only
 *  if no other status than HSP_E_SINK can follow. Uses the view's scratch memory, hence not const; results stay valid.
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

/** Write a picture of a computed map: for each ball that is seen one path around all of its faces, farthest ball first.
 *  Paths share their borders and nothing else; holes are clockwise loops, for either fill rule. All arguments are those
 *  of hsp_picture_write, and all options apply:
 *    lines        are drawn after all paths, every edge of the map once, as parts of open paths; lines of a ball, its
 *                 silhouettes and the creases where it is the nearer ball, follow each other. SVG: without data-ball,
 *                 and a click on a line goes to the path below
 *    fitted size  the box of the visible balls is the same as in a view
 *  Coordinates are rounded as in pictures of views, in SVG to 0.01 px or less on pages of up to 1000 px, in styles with
 *  light to 0.03 px: by so much neighbours may overlap or leave a gap. If the balls of the map were moved
 *  (hsp_map_info.perturbation) it shows the moved ones.
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
