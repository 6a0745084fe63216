#include "draw/mesh_outlines.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_parts.h"
#include "read/growing_array.h"

static const double thinnest = 1.0; /* of areas, in units */

/* The largest distance of dropped points, as squares of units: on outlines; on inner edges between tones that hardly
 * differ; and on lines, which show every corner. */
static const double slack_squared[2] = {1.0, 30.0}, slack_squared_of_lines = 0.5;

void painted_edges_add(struct painted_edges *edges, const struct painted_edge *edge) {
  if (memcmp(edge->from, edge->to, sizeof edge->from) == 0 || edges->out_of_memory) return;
  edges->out_of_memory = !array_append(&edges->edge, &edges->count, &edges->room, edge, sizeof *edge);
}

static int compare_points(const int32_t a[2], const int32_t b[2]) {
  if (a[0] != b[0]) return a[0] < b[0] ? -1 : 1;
  return (a[1] > b[1]) - (a[1] < b[1]);
}

static int compare_groups(const struct painted_edge *a, const struct painted_edge *b) {
  if (a->layer != b->layer) return a->layer < b->layer ? -1 : 1;
  return (a->paint > b->paint) - (a->paint < b->paint);
}

static bool runs_back(const struct painted_edge *edge) {
  return compare_points(edge->from, edge->to) > 0;
}

/* Edges that run back stand beside those that they cancel; of the same way, outlines come first, so that no two orders
 * are as good. */
static int compare_lines(const void *left, const void *right) {
  const struct painted_edge *a = left;
  const struct painted_edge *b = right;
  const bool back[2] = {runs_back(a), runs_back(b)};
  int order = compare_groups(a, b);
  if (order == 0) order = compare_points(back[0] ? a->to : a->from, back[1] ? b->to : b->from);
  if (order == 0) order = compare_points(back[0] ? a->from : a->to, back[1] ? b->from : b->to);
  if (order == 0) order = (int)back[0] - (int)back[1];
  return order != 0 ? order : (int)a->inner - (int)b->inner;
}

static int compare_starts(const void *left, const void *right) {
  const struct painted_edge *a = left;
  const struct painted_edge *b = right;
  int order = compare_groups(a, b);
  if (order == 0) order = compare_points(a->from, b->from);
  if (order == 0) order = compare_points(a->to, b->to);
  return order != 0 ? order : (int)a->inner - (int)b->inner;
}

static bool same_line(const struct painted_edge *a, const struct painted_edge *b) {
  if (compare_groups(a, b) != 0) return false;
  const bool along = compare_points(a->from, b->from) == 0 && compare_points(a->to, b->to) == 0;
  return along || (compare_points(a->from, b->to) == 0 && compare_points(a->to, b->from) == 0);
}

void painted_edges_cancel(struct painted_edges *edges) {
  size_t kept = 0;
  if (edges->count == 0) return;
  qsort(edges->edge, edges->count, sizeof *edges->edge, compare_lines);
  for (size_t i = 0; i < edges->count;) {
    size_t end = i, back = 0;
    while (end < edges->count && same_line(&edges->edge[i], &edges->edge[end])) back += runs_back(&edges->edge[end++]);
    const size_t along = end - i - back;
    const struct painted_edge left = edges->edge[along >= back ? i : i + along];
    const size_t more = along >= back ? along - back : back - along;
    for (size_t k = 0; k < more; ++k) edges->edge[kept++] = left;
    i = end;
  }
  edges->count = kept;
  qsort(edges->edge, kept, sizeof *edges->edge, compare_starts);
}

size_t painted_edges_end(const struct painted_edges *edges, size_t first) {
  size_t end = first;
  while (end < edges->count && compare_groups(&edges->edge[first], &edges->edge[end]) == 0) ++end;
  return end;
}

/* The first edge that starts there, or the end. */
static size_t find_start(const struct painted_edges *edges, size_t first, size_t end, const int32_t at[2]) {
  size_t low = first, high = end;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (compare_points(edges->edge[middle].from, at) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < end && compare_points(edges->edge[low].from, at) == 0 ? low : end;
}

/* An edge that is written has no length any more. */
static void mark(struct painted_edge *edge) {
  memcpy(edge->to, edge->from, sizeof edge->to);
}
static bool is_marked(const struct painted_edge *edge) {
  return compare_points(edge->from, edge->to) == 0;
}

/* ---- connected lines ---- */

struct line_end {
  int32_t at[2];
  uint32_t edge;
};

static int compare_ends(const void *left, const void *right) {
  const struct line_end *a = left;
  const struct line_end *b = right;
  const int order = compare_points(a->at, b->at);
  return order != 0 ? order : (a->edge > b->edge) - (a->edge < b->edge);
}

static double length_of(const struct painted_edge *edge) {
  const double x = (double)edge->to[0] - edge->from[0], y = (double)edge->to[1] - edge->from[1];
  return sqrt(x * x + y * y);
}

/* The square of a point's distance from the way between two others. */
static double off_the_chord(const int32_t *at, const int32_t *from, const int32_t *to) {
  const double d[2] = {(double)to[0] - from[0], (double)to[1] - from[1]};
  const double a[2] = {(double)at[0] - from[0], (double)at[1] - from[1]};
  const double b[2] = {(double)at[0] - to[0], (double)at[1] - to[1]};
  if (d[0] * a[0] + d[1] * a[1] <= 0.0) return a[0] * a[0] + a[1] * a[1];
  if (d[0] * b[0] + d[1] * b[1] >= 0.0) return b[0] * b[0] + b[1] * b[1];
  const double across = d[0] * a[1] - d[1] * a[0];
  return across * across / (d[0] * d[0] + d[1] * d[1]);
}

/* Whether one of its ends is that near to a line. */
static bool is_near(const struct painted_edge *edge, const struct painted_edge *other, double apart) {
  return off_the_chord(edge->from, other->from, other->to) <= apart * apart ||
         off_the_chord(edge->to, other->from, other->to) <= apart * apart;
}

/* For each line the one that stands for all lines connected with it, and the ink of these. */
struct hanging {
  uint32_t *root;
  double *ink;
};

static void join(const struct hanging *hanging, uint32_t a, uint32_t b) {
  const uint32_t from = mesh_parts_root(hanging->root, a), to = mesh_parts_root(hanging->root, b);
  if (from == to) return;
  hanging->root[from] = to;
  hanging->ink[to] += hanging->ink[from];
}

/* Join lines that share an end. */
static bool join_at_ends(const struct painted_edges *edges, uint32_t first, const struct hanging *hanging) {
  struct line_end *end = calloc(2 * edges->count + 1, sizeof *end);
  size_t ends = 0;
  if (end == NULL) return false;
  for (size_t i = 0; i < edges->count; ++i) {
    const struct painted_edge *const edge = &edges->edge[i];
    hanging->root[i] = (uint32_t)i;
    if (edge->paint < first) continue;
    hanging->ink[i] = length_of(edge) * (edge->paint - first);
    end[ends++] = (struct line_end){{edge->from[0], edge->from[1]}, (uint32_t)i};
    end[ends++] = (struct line_end){{edge->to[0], edge->to[1]}, (uint32_t)i};
  }
  qsort(end, ends, sizeof *end, compare_ends);
  for (size_t i = 1; i < ends; ++i) {
    if (compare_points(end[i - 1].at, end[i].at) == 0) join(hanging, end[i].edge, end[i - 1].edge);
  }
  free(end);
  return true;
}

bool painted_edges_drop_specks(struct painted_edges *edges, uint32_t first, double ink, double apart) {
  const struct hanging hanging = {calloc(edges->count + 1, sizeof *hanging.root),
                                  calloc(edges->count + 1, sizeof *hanging.ink)};
  const bool enough = hanging.root != NULL && hanging.ink != NULL && join_at_ends(edges, first, &hanging);
  size_t kept = 0;
  for (uint32_t i = 0; enough && i < edges->count; ++i) {
    for (uint32_t k = 0; k < edges->count && edges->edge[i].paint >= first; ++k) {
      const uint32_t root = mesh_parts_root(hanging.root, i);
      if (hanging.ink[root] >= ink) break;
      if (edges->edge[k].paint < first || mesh_parts_root(hanging.root, k) == root) continue;
      if (is_near(&edges->edge[i], &edges->edge[k], apart)) join(&hanging, i, k);
    }
  }
  for (uint32_t i = 0; enough && i < edges->count; ++i) {
    const bool speck = edges->edge[i].paint >= first && hanging.ink[mesh_parts_root(hanging.root, i)] < ink;
    if (!speck) edges->edge[kept++] = edges->edge[i];
  }
  if (enough) edges->count = kept;
  free(hanging.root);
  free(hanging.ink);
  return enough;
}

/* ---- points where outlines meet ---- */

static int compare_segments(const void *left, const void *right) {
  const struct painted_edge *a = left;
  const struct painted_edge *b = right;
  const int order = compare_points(a->from, b->from);
  return order != 0 ? order : compare_points(a->to, b->to);
}

bool painted_edges_find_joints(struct painted_edges *edges, uint32_t first, uint32_t end) {
  struct painted_edge *segment = calloc(2 * edges->count + 1, sizeof *segment);
  size_t count = 0, joints = 0;
  if (segment == NULL) return false;
  for (size_t i = 0; i < edges->count; ++i) {
    if (edges->edge[i].paint < first || edges->edge[i].paint >= end) continue;
    for (int back = 0; back < 2; ++back, ++count) {
      memcpy(segment[count].from, back == 1 ? edges->edge[i].to : edges->edge[i].from, sizeof segment->from);
      memcpy(segment[count].to, back == 1 ? edges->edge[i].from : edges->edge[i].to, sizeof segment->to);
    }
  }
  qsort(segment, count, sizeof *segment, compare_segments);
  edges->joint = calloc(count + 1, sizeof *edges->joint);
  for (size_t i = 0, behind = 0; edges->joint != NULL && i < count; i = behind) {
    int different = 1;
    for (behind = i + 1; behind < count && compare_points(segment[i].from, segment[behind].from) == 0; ++behind) {
      if (compare_points(segment[behind].to, segment[behind - 1].to) != 0) ++different;
    }
    if (different > 2) memcpy(edges->joint[joints++], segment[i].from, sizeof segment->from);
  }
  edges->joints = joints;
  free(segment);
  return edges->joint != NULL;
}

static int compare_as_points(const void *left, const void *right) {
  return compare_points(left, right);
}

static bool is_joint(const struct painted_edges *edges, const int32_t at[2]) {
  return edges->joints > 0 && bsearch(at, edges->joint, edges->joints, sizeof *edges->joint, compare_as_points) != NULL;
}

/* ---- paths ---- */

/* A way along edges: the points that it turns at. */
struct way {
  const struct painted_edges *edges;
  const int32_t (*point)[2];
  const bool *inner; /* [points], of the edge that begins there */
  size_t points;
  bool of_area, closed, curved;
};

/* Whether a curve may go by this point: where no third outline comes to it, and where the way turns by less than 37
 * degrees, and around an area is no shorter than three times on one side as on the other. */
static bool is_smooth(const struct way *way, size_t k) {
  if (!way->curved || (!way->closed && (k == 0 || k + 1 == way->points))) return false;
  const int32_t *before = way->point[(k + way->points - 1) % way->points];
  const int32_t *at = way->point[k];
  const int32_t *after = way->point[(k + 1) % way->points];
  const double a[2] = {(double)at[0] - before[0], (double)at[1] - before[1]};
  const double b[2] = {(double)after[0] - at[0], (double)after[1] - at[1]};
  const double along = a[0] * b[0] + a[1] * b[1];
  const double squares[2] = {a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1]};
  const bool even = !way->of_area || (squares[0] <= 9.0 * squares[1] && squares[1] <= 9.0 * squares[0]);
  return even && along > 0.0 && along * along > 0.64 * squares[0] * squares[1] && !is_joint(way->edges, at);
}

/* Halves of units, in which middles of edges are whole. */
struct writer {
  struct text_buffer *out;
  int32_t at[2];
  char command; /* the last one */
};

static void put_number(struct writer *writer, int32_t number, bool first) {
  text_buffer_add(writer->out, "%s%" PRId32, first || number < 0 ? "" : " ", number);
}

static void put_points(struct writer *writer, char command, const int32_t *first, const int32_t *last) {
  const char name[2] = {command, '\0'};
  const bool named = writer->command != command;
  if (named) text_buffer_add_text(writer->out, name);
  for (int axis = 0; axis < 2; ++axis) {
    put_number(writer, first[axis] - writer->at[axis], axis == 0 && named);
  }
  for (int axis = 0; axis < 2 && last != first; ++axis) put_number(writer, last[axis] - writer->at[axis], false);
  memcpy(writer->at, last, sizeof writer->at);
  writer->command = command;
}

static void find_middle(const struct way *way, size_t k, int32_t middle[2]) {
  const int32_t *a = way->point[k % way->points];
  const int32_t *b = way->point[(k + 1) % way->points];
  for (int axis = 0; axis < 2; ++axis) middle[axis] = a[axis] + b[axis];
}

/* At smooth points parabolas lead from the middle of one edge to the middle of the next. Their control points are the
 * points themselves. Each control point is the last one mirrored at the middle between them, which is what the command
 * `t` means. */
static void put_way(struct text_buffer *out, const struct way *way) {
  struct writer writer = {out, {0, 0}, 'M'};
  size_t first = 0;
  while (way->closed && first < way->points && is_smooth(way, first)) ++first;
  const bool round = first == way->points;
  if (round) first = 0;
  if (round) {
    find_middle(way, way->points - 1, writer.at);
  } else {
    for (int axis = 0; axis < 2; ++axis) writer.at[axis] = 2 * way->point[first][axis];
  }
  text_buffer_add(out, "M%" PRId32 " %" PRId32, writer.at[0], writer.at[1]);
  const size_t last = round ? way->points : way->closed ? way->points + 1 : way->points;
  bool curved = false;
  for (size_t i = round ? 0 : 1; i < last; ++i) {
    const size_t k = (first + i) % way->points;
    const int32_t at[2] = {2 * way->point[k][0], 2 * way->point[k][1]};
    int32_t middle[2];
    if (!is_smooth(way, k)) {
      if (!(way->closed && i + 1 == last && !curved)) put_points(&writer, 'l', at, at);
      curved = false;
      continue;
    }
    if (!curved && !(round && i == 0)) {
      find_middle(way, k + way->points - 1, middle);
      put_points(&writer, 'l', middle, middle);
    }
    find_middle(way, k, middle);
    if (curved) {
      put_points(&writer, 't', middle, middle);
    } else {
      put_points(&writer, 'q', at, middle);
    }
    curved = true;
  }
  if (way->closed) text_buffer_add(out, "z");
}

/* ---- fewer points ---- */

/* Find the point between two others that is farthest from their chord; of several the first by coordinates, so that
 * both neighbours of an outline drop the same points. */
static size_t find_farthest(const struct way *way, size_t from, size_t to, double *square) {
  const size_t n = way->points;
  size_t farthest = from;
  *square = -1.0;
  for (size_t k = from + 1; k < to; ++k) {
    const double own = off_the_chord(way->point[k % n], way->point[from % n], way->point[to % n]);
    if (own < *square || (own == *square && compare_points(way->point[k % n], way->point[farthest % n]) > 0)) {
      continue;
    }
    *square = own;
    farthest = k;
  }
  return farthest;
}

/* Whether a point is kept: a third outline meets the way there, or another kind of edge begins. */
static bool is_kept(const struct way *way, size_t k) {
  return way->inner[k] != way->inner[(k + way->points - 1) % way->points] || is_joint(way->edges, way->point[k]);
}

/* The point with which a loop begins: the first by coordinates of the points that are kept, if there are any. */
static size_t find_first(const struct way *way) {
  size_t first = 0;
  bool kept = is_kept(way, 0);
  for (size_t k = 1; k < way->points; ++k) {
    const bool own = is_kept(way, k);
    if (own == kept ? compare_points(way->point[k], way->point[first]) > 0 : kept) continue;
    first = k;
    kept = own;
  }
  return first;
}

/* Drops points that are no joints, while no dropped one is farther from the chord than the slack (Douglas and Peucker).
 * A loop of joints begins at one of them, as both neighbours of an outline have to drop the same. */
static bool drop_points(const struct way *way, int32_t (*left)[2], size_t *count) {
  const size_t n = way->points, first = way->closed ? find_first(way) : 0, last = way->closed ? n : n - 1;
  size_t *ends = calloc(n + 2, sizeof *ends); /* of pieces that are not yet done, the last piece first */
  size_t open = 0, from = 0;
  *count = 0;
  if (ends == NULL) return false;
  ends[open++] = last;
  for (size_t k = last; k-- > 1;) {
    if (is_kept(way, (first + k) % n)) ends[open++] = k;
  }
  while (open > 0) {
    const size_t to = ends[open - 1];
    double square;
    const size_t farthest = find_farthest(way, first + from, first + to, &square);
    if (square > (way->of_area ? slack_squared[way->inner[(first + from) % n]] : slack_squared_of_lines)) {
      ends[open++] = farthest - first;
      continue;
    }
    memcpy(left[(*count)++], way->point[(first + from) % n], sizeof *left);
    from = to;
    --open;
  }
  if (!way->closed) memcpy(left[(*count)++], way->point[from], sizeof *left);
  free(ends);
  return true;
}

/* Follow edges, each beginning where the one before ends, until the way is back at its beginning or no edge is left. */
static bool take_way(const struct painted_edges *edges, size_t edge, size_t first, size_t end, int32_t (*point)[2],
                     bool *inner, struct way *way) {
  size_t count = 0;
  size_t next = edge;
  bool round = false;
  memcpy(point[count++], edges->edge[edge].from, sizeof *point);
  while (next < end && !round) {
    memcpy(point[count], edges->edge[next].to, sizeof *point);
    inner[count - 1] = edges->edge[next].inner;
    mark(&edges->edge[next]);
    round = compare_points(point[count], point[0]) == 0;
    if (!round) ++count;
    next = round ? end : find_start(edges, first, end, point[count - 1]);
    while (next < end && is_marked(&edges->edge[next])) {
      ++next;
      if (next < end && compare_points(edges->edge[next].from, point[count - 1]) != 0) next = end;
    }
  }
  if (!round) inner[count - 1] = false;
  way->point = (const int32_t(*)[2])point;
  way->inner = inner;
  way->points = count;
  way->closed = way->closed || round;
  return count > 1;
}

/* Whether a loop is so thin that only its line would be seen. It is left out, as lines of its neighbours close the
 * gap. */
static bool is_sliver(const struct way *way) {
  double area = 0.0, around = 0.0;
  for (size_t k = 0; k < way->points; ++k) {
    const int32_t *at = way->point[k], *next = way->point[(k + 1) % way->points], *start = way->point[0];
    const double d[2] = {(double)next[0] - at[0], (double)next[1] - at[1]};
    area += ((double)at[0] - start[0]) * d[1] - ((double)at[1] - start[1]) * d[0];
    around += sqrt(d[0] * d[0] + d[1] * d[1]);
  }
  return fabs(area) <= thinnest * around;
}

/* The ends of edges, sorted. Free them. NULL: memory is short. */
static int32_t (*find_ends(const struct painted_edges *edges, size_t first, size_t end))[2] {
  int32_t(*const ends)[2] = calloc(end - first + 1, sizeof *ends);
  for (size_t i = first; ends != NULL && i < end; ++i) memcpy(ends[i - first], edges->edge[i].to, sizeof *ends);
  if (ends != NULL) qsort(ends, end - first, sizeof *ends, compare_as_points);
  return ends;
}

/* Lines are taken from where they begin, and only then round ones from anywhere: a line that is begun in its middle is
 * two, with a corner between them. */
bool painted_edges_write(const struct painted_edges *edges, size_t first, size_t end, bool closed, bool curved,
                         struct text_buffer *out) {
  int32_t(*point)[2] = calloc(2 * (end - first + 2), sizeof *point);
  int32_t(*const left)[2] = point + (end - first + 2);
  int32_t(*const ends)[2] = find_ends(edges, first, closed ? first : end);
  bool *inner = calloc(end - first + 2, sizeof *inner);
  bool enough = point != NULL && ends != NULL && inner != NULL;
  for (int pass = closed ? 1 : 0; pass < 2; ++pass) {
    for (size_t i = first; enough && i < end; ++i) {
      struct way way = {.edges = edges, .of_area = closed, .closed = closed, .curved = curved};
      const int32_t *const from = edges->edge[i].from;
      if (is_marked(&edges->edge[i])) continue;
      if (pass == 0 && bsearch(from, ends, end - first, sizeof *ends, compare_as_points) != NULL) continue;
      if (!take_way(edges, i, first, end, point, inner, &way)) continue;
      size_t count;
      enough = drop_points(&way, left, &count);
      way.point = (const int32_t(*)[2])left;
      way.points = count;
      if (enough && count > 1 && !(closed && is_sliver(&way))) put_way(out, &way);
    }
  }
  free(point);
  free(ends);
  free(inner);
  return enough;
}

void painted_edges_free(struct painted_edges *edges) {
  free(edges->edge);
  free(edges->joint);
}
