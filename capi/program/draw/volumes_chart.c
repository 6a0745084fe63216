#include "draw/volumes_chart.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "draw/chart.h"
#include "draw/pores_charts.h"
#include "read/number.h"
#include "write/output_file.h"

enum { CHART_HEIGHT = 320, MOST_LINES = 6, SIGN_BYTES = 16, LEGEND_BYTES = 120 };

#define VOLUME_LINE 1.5
#define LONE_POINT 2.0 /* radius of a point that has no line */

/* A cavity over all frames. */
struct course {
  uint32_t number;
  uint64_t frames;
  double sum, largest;
};

/* The most volume first. */
static int order_of_courses(const void *left, const void *right) {
  const struct course *const a = left, *const b = right;
  if (a->sum != b->sum) return a->sum > b->sum ? -1 : 1;
  return (a->number > b->number) - (a->number < b->number);
}

/* [numbers], to be freed; NULL: memory is short. */
static struct course *find_courses(const struct followed *followed) {
  struct course *const course = calloc((size_t)followed->numbers + 1, sizeof *course);
  if (course == NULL) return NULL;
  for (uint32_t n = 0; n < followed->numbers; ++n) course[n].number = n + 1;
  for (size_t i = 0; i < followed->volume_count; ++i) {
    const struct followed_volume *const at = &followed->volumes[i];
    if (!is_finite(at->volume)) continue;
    struct course *const of = &course[at->number - 1];
    ++of->frames;
    of->sum += at->volume;
    of->largest = fmax(of->largest, at->volume);
  }
  if (followed->numbers > 1) qsort(course, followed->numbers, sizeof *course, order_of_courses);
  return course;
}

struct volumes_page {
  struct chart_frame frame;
  struct chart_scale across, up;
};

/* A line through frames that follow each other; a point where there is no neighbour. */
static void add_course(struct text_buffer *out, const struct volumes_page *page, const struct followed *followed,
                       uint32_t number, const char *colour) {
  struct text_buffer points = TEXT_BUFFER_EMPTY;
  const struct followed_volume *before = NULL;
  double x = 0.0, y = 0.0;
  bool joined = true;
  chart_path_begin(out, colour, VOLUME_LINE);
  text_buffer_add_text(out, " d=\"");
  for (size_t i = 0; i <= followed->volume_count; ++i) {
    const struct followed_volume *const at = i < followed->volume_count ? &followed->volumes[i] : NULL;
    if (at != NULL && (at->number != number || !is_finite(at->volume))) continue;
    const bool joins = at != NULL && before != NULL && at->place == before->place + 1;
    if (before != NULL && !joins && !joined) {
      text_buffer_add(&points, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.1f\" fill=\"%s\"/>\n", x, y, LONE_POINT, colour);
    }
    if (at == NULL) break;
    x = chart_x(&page->frame, &page->across, (double)at->frame);
    y = chart_y(&page->frame, &page->up, at->volume);
    text_buffer_add(out, joins ? "L%.2f %.2f" : "M%.2f %.2f", x, y);
    joined = joins;
    before = at;
  }
  text_buffer_add_text(out, "\"/>\n");
  text_buffer_append(out, points.text, points.length);
  out->out_of_memory = out->out_of_memory || points.out_of_memory;
  text_buffer_free(&points);
}

static void add_legend(struct text_buffer *out, const struct volumes_page *page, const struct followed *followed,
                       const struct course *course, uint32_t shown, uint32_t others, const char *noun,
                       const char *sign) {
  double y = page->frame.top + page->frame.height + BELOW;
  char text[LEGEND_BYTES];
  for (uint32_t k = 0; k < shown; ++k, y += LEGEND_ROW) {
    chart_path_begin(out, chart_colour(k), VOLUME_LINE);
    text_buffer_add(out, " d=\"M%d %.1fh%d\"/>\n", LEFT, y - CHART_HALF_LETTER, SWATCH);
    text_buffer_add(
        out, "<text x=\"%d\" y=\"%.1f\">%s %" PRIu32 ": mean %.4g%s%s, in %" PRIu64 " of %" PRIu64 " frames</text>\n",
        LEFT + SWATCH + BEHIND_SWATCH, y, noun, course[k].number, course[k].sum / (double)course[k].frames,
        sign[0] == '\0' ? "" : " ", sign, course[k].frames, followed->frames);
  }
  if (others == 0 && shown > 0) return;
  if (shown == 0) snprintf(text, sizeof text, "no %s has a volume", noun);
  if (shown > 0) snprintf(text, sizeof text, "and %" PRIu32 " more, each of less volume over the run", others);
  chart_text(out, LEFT, y, "start", text);
}

static void add_chart(struct text_buffer *out, const struct followed *followed, const struct course *course,
                      const char *unit, const char *noun) {
  uint32_t shown = 0, all = 0;
  double most = 0.0;
  char sign[SIGN_BYTES] = "", title[LEGEND_BYTES];
  while (all < followed->numbers && course[all].sum > 0.0) ++all;
  for (; shown < all && shown < MOST_LINES; ++shown) most = fmax(most, course[shown].largest);
  if (unit[0] != '\0') snprintf(sign, sizeof sign, "%s\xC2\xB3", unit);
  const double first = (double)followed->first_frame, last = (double)followed->last_frame;
  const struct volumes_page page = {{LEFT + 0.5, TOP + 0.5, WIDTH, CHART_HEIGHT},
                                    chart_scale_of(first, last > first ? last : first + 1.0),
                                    chart_scale_of(0.0, most > 0.0 ? most : 1.0)};
  const int rows = (int)shown + (shown == 0 || all > shown ? 1 : 0);
  snprintf(title, sizeof title, "Volume of each %s by frame", noun);
  chart_begin(out, LEFT + WIDTH + RIGHT, TOP + CHART_HEIGHT + BELOW + LEGEND_ROW * (rows - 1) + MARGIN_BELOW, title);
  chart_axes(out, &page.frame, &page.across, &page.up);
  chart_name_across(out, &page.frame, "frame", "");
  chart_name_up(out, &page.frame, "volume", sign);
  for (uint32_t k = shown; k-- > 0;) add_course(out, &page, followed, course[k].number, chart_colour(k));
  add_legend(out, &page, followed, course, shown, all - shown, noun, sign);
  text_buffer_add_text(out, "</svg>\n");
}

bool volumes_write(const struct followed *followed, const struct molecule *molecule, const char *noun, const char *path,
                   struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  struct course *const course = find_courses(followed);
  if (course == NULL) return failure_of_memory(failure);
  add_chart(&out, followed, course, molecule->format->sign, noun);
  const bool done = output_file_write_text(path, &out, failure);
  text_buffer_free(&out);
  free(course);
  return done;
}
