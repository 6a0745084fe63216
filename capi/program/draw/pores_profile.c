/* The radius along tunnels as a chart. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/pores_found.h"
#include "draw/chart.h"
#include "draw/pores_charts.h"
#include "draw/smooth_curve.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

enum { PROFILE_HEIGHT = 320 }; /* px */

#define TUNNEL_LINE 1.5
#define SHARED_LINE 4.5 /* more of it for each tunnel on the same way */
#define SHARED_EDGE 1.0 /* that is seen of it, on both sides */

struct profile {
  const struct pores_found *found;
  double *slope; /* [steps] of the radius */
  struct chart_frame frame;
  struct chart_scale across, up;
};

static void add_dash(struct text_buffer *out, uint32_t tunnel) {
  if (chart_dash(tunnel) > 0) text_buffer_add(out, " stroke-dasharray=\"%d 2\"", chart_dash(tunnel));
}

enum { MOST_SHARED = 4 };

/* How many tunnels before this one have the step, and the one before it; and the first of them. */
static int shared_by(const struct pores_found *found, size_t step, uint32_t *first) {
  const struct tunnel_step *const to = &found->steps[step], *const from = to - 1;
  int count = 0;
  for (size_t i = 1; i < step && count < MOST_SHARED; ++i) {
    const struct tunnel_step *const other = &found->steps[i];
    if (other->tunnel >= to->tunnel || (other - 1)->tunnel != other->tunnel) continue;
    if (memcmp(other->point.xyz, to->point.xyz, sizeof to->point.xyz) != 0 || other->length != to->length) continue;
    if (memcmp((other - 1)->point.xyz, from->point.xyz, sizeof from->point.xyz) != 0) continue;
    if (count == 0) *first = other->tunnel - 1;
    ++count;
  }
  return count;
}

static void place_step(const struct profile *profile, size_t step, double at[2]) {
  const struct tunnel_step *const of = &profile->found->steps[step];
  at[0] = chart_x(&profile->frame, &profile->across, of->length);
  at[1] = chart_y(&profile->frame, &profile->up, of->point.radius);
}

static void add_start(struct text_buffer *out, const struct profile *profile, size_t step) {
  double at[2];
  place_step(profile, step, at);
  text_buffer_add(out, "M%.2f %.2f", at[0], at[1]);
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

/* At an end of a wide line between others, or where it becomes less wide, its two sides meet around the end. */
struct wide_ends {
  double at[2][2];
  int count;
};

static double wide_line(int shared) {
  return TUNNEL_LINE + SHARED_LINE * shared;
}

/* Not where it would go beyond the frame. */
static void add_end(struct wide_ends *ends, const struct profile *profile, size_t step, int shared) {
  double at[2];
  place_step(profile, step, at);
  if (at[0] - wide_line(shared) / 2.0 < profile->frame.left) return;
  memcpy(ends->at[ends->count++], at, sizeof at);
}

/* A wide line with a white one in it, so that no colour touches that of a narrower line within. */
static void add_wide(struct text_buffer *out, const char *colour, int shared, const struct text_buffer *way,
                     const struct wide_ends *ends) {
  const double wide = wide_line(shared);
  for (int inner = 0; inner < 2; ++inner) {
    const double width = inner == 0 ? wide : wide - 2.0 * SHARED_EDGE;
    const char *const filled = inner == 0 ? colour : "#ffffff";
    chart_path_begin(out, filled, width);
    text_buffer_add_text(out, " d=\"");
    text_buffer_append(out, way->text, way->length);
    text_buffer_add_text(out, "\"/>\n");
    for (int end = 0; end < ends->count; ++end) {
      text_buffer_add(out, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"%s\"/>\n", ends->at[end][0],
                      ends->at[end][1], width / 2.0, filled);
    }
  }
  out->out_of_memory = out->out_of_memory || way->out_of_memory;
}

/* Two tunnels that go the same way, the earlier one first. False: there are none. */
static bool find_pair(const struct pores_found *found, uint32_t pair[2]) {
  for (size_t i = 1; i < found->step_count; ++i) {
    pair[1] = found->steps[i].tunnel - 1;
    if (found->steps[i - 1].tunnel == found->steps[i].tunnel && shared_by(found, i, &pair[0]) > 0) return true;
  }
  return false;
}

/* A tunnel that goes the way of earlier ones has a wider line, which is seen on both sides of theirs. */
static void add_shared(struct text_buffer *out, const struct profile *profile, uint32_t tunnel) {
  struct text_buffer way = TEXT_BUFFER_EMPTY;
  struct wide_ends ends = {.count = 0};
  int before = 0;
  uint32_t first;
  for (size_t i = 1; i <= profile->found->step_count; ++i) {
    const struct tunnel_step *const step = &profile->found->steps[i - 1];
    const bool here = i < profile->found->step_count && step->tunnel == tunnel + 1 && (step + 1)->tunnel == tunnel + 1;
    const int shared = here ? shared_by(profile->found, i, &first) : 0;
    if (before > 0 && shared != before) {
      if (here && before > shared) add_end(&ends, profile, i - 1, before);
      add_wide(out, chart_colour(tunnel), before, &way, &ends);
      text_buffer_free(&way);
    }
    if (shared > 0 && shared != before) {
      ends.count = 0;
      add_start(&way, profile, i - 1);
      if (shared > before && i > 1 && (step - 1)->tunnel == step->tunnel) add_end(&ends, profile, i - 1, shared);
    }
    if (shared > 0) add_step(&way, profile, i);
    before = shared;
  }
}

static void add_line(struct text_buffer *out, const struct profile *profile, uint32_t tunnel) {
  chart_path_begin(out, chart_colour(tunnel), TUNNEL_LINE);
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

/* A piece of a way that two tunnels go, as add_shared draws it. */
static void add_shared_swatch(struct text_buffer *out, double x, double y, const uint32_t tunnel[2]) {
  struct text_buffer way = TEXT_BUFFER_EMPTY;
  text_buffer_add(&way, "M%.1f %.1fh%d", x, y, SWATCH);
  add_wide(out, chart_colour(tunnel[1]), 1, &way, &(const struct wide_ends){.count = 0});
  chart_path_begin(out, chart_colour(tunnel[0]), TUNNEL_LINE);
  text_buffer_add_text(out, " d=\"");
  text_buffer_append(out, way.text, way.length);
  text_buffer_add_text(out, "\"/>\n");
  text_buffer_free(&way);
}

/* Add a row for each tunnel, with its line and the ring at its bottleneck, and rows for other marks. pair: two tunnels
 * that go the same way, or NULL. */
static void add_profile_legend(struct text_buffer *out, const struct profile *profile, const char *sign, bool dashes,
                               const uint32_t *pair) {
  const struct pores_found *const found = profile->found;
  const char *const blank = sign[0] == '\0' ? "" : " ";
  const double text_at = LEFT + SWATCH + BEHIND_SWATCH;
  double y = profile->frame.top + profile->frame.height + BELOW;
  for (uint32_t t = 0; t < found->tunnel_count; ++t, y += LEGEND_ROW) {
    const hsp_tunnel *const tunnel = &found->tunnels[t];
    chart_path_begin(out, chart_colour(t), TUNNEL_LINE);
    add_dash(out, t);
    text_buffer_add(out, " d=\"M%d %.1fh%d\"/>\n", LEFT, y - CHART_HALF_LETTER, SWATCH);
    add_ring(out, LEFT + SWATCH / 2.0, y - CHART_HALF_LETTER, chart_colour(t));
    text_buffer_add(out,
                    "<text x=\"%.1f\" y=\"%.1f\">tunnel %" PRIu32 ": bottleneck %.3f%s%s, length %.2f%s%s</text>\n",
                    text_at, y, t + 1, tunnel->radius, blank, sign, tunnel->length, blank, sign);
  }
  if (pair != NULL) {
    add_shared_swatch(out, LEFT, y - CHART_HALF_LETTER, pair);
    chart_text(out, text_at, y, "start", "a tunnel on both sides of another: they go the same way");
    y += LEGEND_ROW;
  }
  if (!dashes) return;
  chart_dashed(out, LEFT, y - CHART_HALF_LETTER, LEFT + SWATCH, y - CHART_HALF_LETTER);
  chart_text(out, text_at, y, "start", "the narrowest probe of interest");
}

/* The slopes; free them. NULL: memory is short. */
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
  uint32_t pair[2];
  const bool shared = find_pair(found, pair);
  const int rows = (int)found->tunnel_count + (shared ? 1 : 0) + (dashes ? 1 : 0);
  chart_begin(&out, LEFT + WIDTH + RIGHT, TOP + PROFILE_HEIGHT + BELOW + LEGEND_ROW * (rows - 1) + MARGIN_BELOW,
              "Tunnels");
  chart_axes(&out, &profile.frame, &profile.across, &profile.up);
  chart_name_across(&out, &profile.frame, "length along the tunnel", molecule->format->sign);
  chart_name_up(&out, &profile.frame, "radius of the largest probe", molecule->format->sign);
  if (dashes) {
    const double y = chart_y(&profile.frame, &profile.up, probe);
    chart_dashed(&out, LEFT, y, LEFT + WIDTH, y);
  }
  for (uint32_t t = found->tunnel_count; t-- > 0;) add_shared(&out, &profile, t);
  for (uint32_t t = found->tunnel_count; t-- > 0;) add_line(&out, &profile, t);
  for (uint32_t t = found->tunnel_count; t-- > 0;) add_tightest(&out, &profile, t);
  free(slope);
  add_profile_legend(&out, &profile, molecule->format->sign, dashes, shared ? pair : NULL);
  text_buffer_add_text(&out, "</svg>\n");
  const bool done = output_file_write_text(path, &out, failure);
  text_buffer_free(&out);
  return done;
}
