#include "commands/void_room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"

/* The nearest ball of any point of the void has a face on it, and a sphere that meets none of these balls lies either
 * in the void or outside it: the balls of the wall are all that counts. The largest empty sphere touches four of them
 * in independent directions. Boxes are halved until few balls can be the nearest ones there, and then the spheres that
 * touch any four of these are compared. Where many balls are as near, as in a cage, a tolerance ends it. */

#define ROOM_TOLERANCE 1e-6 /* of the clearance */
enum { FEW_BALLS = 8 };

struct box {
  double centre[3];
  double half[3];
  double most;          /* no point of it has more clearance */
  size_t first, behind; /* in search.nearby: the balls that can be nearest to a point of it */
};

struct search {
  const struct geometry *geometry;
  const struct void_wall *wall;
  struct box *boxes; /* to look at, the most promising of the last two on top */
  size_t box_count, box_capacity;
  uint32_t *nearby;
  size_t nearby_capacity;
  double left;       /* bound of the boxes that were left with more than the best clearance so far; 0: none */
  uint64_t compared; /* balls with boxes */
  struct void_room *room;
};

static double distance_to(const struct void_wall *wall, uint32_t ball, const double point[3]) {
  const double *centre = wall->xyz + 3 * (size_t)ball;
  const double x = point[0] - centre[0], y = point[1] - centre[1], z = point[2] - centre[2];
  return sqrt(x * x + y * y + z * z) - (wall->radius[ball] + wall->probe);
}

static double farthest_in_box(const struct void_wall *wall, uint32_t ball, const struct box *box) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double away = fabs(box->centre[axis] - wall->xyz[3 * (size_t)ball + (size_t)axis]) + box->half[axis];
    sum += away * away;
  }
  return sqrt(sum) - (wall->radius[ball] + wall->probe);
}

/* Of a point: not above `most` if it has no more. */
static double clearance_of(const struct void_wall *wall, const double point[3], double most) {
  double least = HUGE_VAL;
  for (uint32_t k = 0; k < wall->ball_count && least > most; ++k) {
    least = fmin(least, distance_to(wall, wall->balls[k], point));
  }
  return least;
}

/* Whether the point lies in the void, by the library's integers. The centre of a sphere that touches four balls nearly
 * in one plane may be anywhere: beyond the lattice there is no void. */
static bool lies_inside(const struct search *search, const double point[3], bool *inside, struct failure *failure) {
  uint32_t region = HSP_NONE;
  const int32_t status = hsp_topology_locate(search->geometry->work.topology, point, &region);
  *inside = status == HSP_OK && region == search->wall->region;
  return status == HSP_OK || status == HSP_E_RANGE || status == HSP_E_NOT_FINITE || failure_in_library(failure, status);
}

/* The point becomes the room's if it has more clearance and lies in the void. */
static bool offer(struct search *search, const double point[3], double clearance, bool *inside,
                  struct failure *failure) {
  struct void_room *room = search->room;
  if (!lies_inside(search, point, inside, failure)) return false;
  if (!*inside || !(clearance > room->clearance)) return true;
  memcpy(room->xyz, point, sizeof room->xyz);
  room->clearance = clearance;
  room->found = true;
  return true;
}

static bool push_box(struct search *search, const struct box *box, struct failure *failure) {
  struct box *const grown = array_with_room(search->boxes, sizeof *grown, search->box_count, &search->box_capacity);
  if (grown == NULL) return failure_of_memory(failure);
  search->boxes = grown;
  search->boxes[search->box_count++] = *box;
  return true;
}

static bool make_room(struct search *search, size_t count, struct failure *failure) {
  if (count <= search->nearby_capacity) return true;
  uint32_t *nearby = realloc(search->nearby, 2 * count * sizeof *nearby);
  if (nearby == NULL) return failure_of_memory(failure);
  search->nearby = nearby;
  search->nearby_capacity = 2 * count;
  return true;
}

/* The bound of a box by the balls that can be nearest in it. */
static double most_in_box(const struct search *search, const struct box *box) {
  double most = HUGE_VAL;
  for (size_t k = box->first; k < box->behind; ++k) {
    most = fmin(most, farthest_in_box(search->wall, search->nearby[k], box));
  }
  return most;
}

/* Halve the box across its longest side. Its halves have the balls that can be nearest there: those whose distance from
 * its centre exceeds the least by no more than its diagonal. They stand behind its own, where those of boxes that are
 * done with stood. */
static bool halve(struct search *search, const struct box *box, double clearance, double half_diagonal,
                  struct failure *failure) {
  struct box halves[2] = {*box, *box};
  const size_t begin = box->behind;
  size_t end = begin;
  if (!make_room(search, begin + (box->behind - box->first), failure)) return false;
  for (size_t k = box->first; k < box->behind; ++k) {
    const uint32_t ball = search->nearby[k];
    if (distance_to(search->wall, ball, box->centre) <= clearance + 2.0 * half_diagonal) search->nearby[end++] = ball;
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (box->half[axis] > box->half[longest]) longest = axis;
  }
  for (int side = 0; side < 2; ++side) {
    struct box *half = &halves[side];
    half->half[longest] = 0.5 * box->half[longest];
    half->centre[longest] += side == 0 ? -half->half[longest] : half->half[longest];
    half->first = begin;
    half->behind = end;
    half->most = fmin(box->most, most_in_box(search, half));
  }
  const int better = halves[1].most > halves[0].most ? 1 : 0;
  return push_box(search, &halves[1 - better], failure) && push_box(search, &halves[better], failure);
}

/* Bring three equations in four unknowns, rows [3][5] with the right-hand side, to the form in which each row has one
 * unknown of its own, column[row]. False: they are not independent. */
static bool eliminate(double rows[3][5], int column[3]) {
  for (int row = 0; row < 3; ++row) {
    int pivot_row = row, pivot = 0;
    for (int k = row; k < 3; ++k) {
      for (int i = 0; i < 4; ++i) {
        if (fabs(rows[k][i]) > fabs(rows[pivot_row][pivot])) pivot_row = k, pivot = i;
      }
    }
    const double largest = rows[pivot_row][pivot];
    if (!(fabs(largest) > 0.0)) return false;
    for (int i = 0; i < 5; ++i) {
      const double swapped = rows[pivot_row][i];
      rows[pivot_row][i] = rows[row][i];
      rows[row][i] = swapped / largest;
    }
    column[row] = pivot;
    for (int k = 0; k < 3; ++k) {
      const double factor = rows[k][pivot];
      for (int i = 0; i < 5 && k != row; ++i) rows[k][i] -= factor * rows[row][i];
    }
  }
  return true;
}

/* The points that are as far from each of four balls, and how far that is: x, y, z from the first centre, and r. How
 * many there are, 0 to 2. */
static int find_equally_far(const struct void_wall *wall, const uint32_t balls[4], double points[2][4]) {
  const double *origin = wall->xyz + 3 * (size_t)balls[0];
  const double radius = wall->radius[balls[0]] + wall->probe;
  double rows[3][5];
  for (int k = 0; k < 3; ++k) { /* |x - c| = R + r, squared, less the same of the first ball */
    const double *centre = wall->xyz + 3 * (size_t)balls[k + 1];
    const double own = wall->radius[balls[k + 1]] + wall->probe;
    double right = (radius - own) * (radius + own);
    for (int axis = 0; axis < 3; ++axis) {
      rows[k][axis] = centre[axis] - origin[axis];
      right += rows[k][axis] * rows[k][axis];
    }
    rows[k][3] = own - radius;
    rows[k][4] = 0.5 * right;
  }
  int column[3];
  if (!eliminate(rows, column)) return 0;
  const int rest = 6 - column[0] - column[1] - column[2]; /* the unknown that is free */
  double begin[4] = {0, 0, 0, 0}, along[4] = {0, 0, 0, 0};
  along[rest] = 1.0;
  for (int k = 0; k < 3; ++k) {
    begin[column[k]] = rows[k][4];
    along[column[k]] = -rows[k][rest];
  }
  /* |begin + t along|^2 = (radius + r)^2 */
  const double from = radius + begin[3];
  const double a = along[0] * along[0] + along[1] * along[1] + along[2] * along[2] - along[3] * along[3];
  const double b = begin[0] * along[0] + begin[1] * along[1] + begin[2] * along[2] - from * along[3];
  const double c = begin[0] * begin[0] + begin[1] * begin[1] + begin[2] * begin[2] - from * from;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0)) return 0;
  const double sum = -(b + copysign(sqrt(discriminant), b)); /* no cancellation */
  const double roots[2][2] = {{sum, a}, {c, sum}};
  int count = 0;
  for (int root = 0; root < 2; ++root) {
    if (roots[root][1] == 0.0) continue;
    const double t = roots[root][0] / roots[root][1];
    for (int i = 0; i < 4; ++i) points[count][i] = begin[i] + t * along[i];
    ++count;
  }
  return count;
}

/* Whether the point lies in the box, or beside it by no more than it may have been rounded. NULL: everywhere. */
static bool lies_in_box(const double point[3], const struct box *box) {
  const double slack = 1e-6;
  for (int axis = 0; box != NULL && axis < 3; ++axis) {
    const double away = fabs(point[axis] - box->centre[axis]);
    if (!(away <= (1.0 + slack) * box->half[axis] + slack * slack * fabs(point[axis]))) return false;
  }
  return true;
}

/* Offer the centres, in a box, of the spheres that touch four of these balls. */
static bool offer_centres(struct search *search, const struct box *box, const uint32_t *balls, size_t count,
                          struct failure *failure) {
  const struct void_wall *wall = search->wall;
  for (unsigned chosen = 0; chosen < 1U << count; ++chosen) {
    uint32_t four[4];
    double points[2][4];
    int size = 0;
    for (size_t k = 0; k < count; ++k) {
      if ((chosen >> k & 1U) == 0) continue;
      if (size < 4) four[size] = balls[k];
      ++size;
    }
    const int centres = size == 4 ? find_equally_far(wall, four, points) : 0;
    for (int i = 0; i < centres; ++i) {
      const double *origin = wall->xyz + 3 * (size_t)four[0];
      const double point[3] = {origin[0] + points[i][0], origin[1] + points[i][1], origin[2] + points[i][2]};
      const double least = search->room->clearance;
      if (!(points[i][3] > least) || !lies_in_box(point, box)) continue;
      search->compared += wall->ball_count;
      const double clearance = clearance_of(wall, point, least);
      bool inside = false;
      if (clearance > least && !offer(search, point, clearance, &inside, failure)) return false;
    }
  }
  return true;
}

/* Look at the box on top: it may give a better point, be of no use, or fall into two. */
static bool look_at_box(struct search *search, struct failure *failure) {
  const struct box box = search->boxes[--search->box_count];
  const double half_diagonal = sqrt(box.half[0] * box.half[0] + box.half[1] * box.half[1] + box.half[2] * box.half[2]);
  const size_t balls = box.behind - box.first;
  search->compared += balls;
  if (!(box.most > search->room->clearance)) return true;
  if (balls <= FEW_BALLS) return offer_centres(search, &box, search->nearby + box.first, balls, failure);
  if (search->room->found && box.most <= search->room->clearance * (1.0 + ROOM_TOLERANCE)) {
    search->left = fmax(search->left, box.most);
    return true;
  }
  double clearance = HUGE_VAL;
  for (size_t k = box.first; k < box.behind; ++k) {
    clearance = fmin(clearance, distance_to(search->wall, search->nearby[k], box.centre));
  }
  if (clearance > search->room->clearance || clearance >= half_diagonal) {
    bool inside = false;
    if (!offer(search, box.centre, clearance, &inside, failure)) return false;
    if (!inside && clearance >= half_diagonal) return true; /* so is all of the box */
  }
  return halve(search, &box, clearance, half_diagonal, failure);
}

/* The balls nearest to the point, the nearest first; how many. */
static size_t nearest_balls(const struct void_wall *wall, const double point[3], uint32_t nearest[FEW_BALLS]) {
  double distance[FEW_BALLS];
  size_t count = 0;
  for (uint32_t k = 0; k < wall->ball_count; ++k) {
    const double own = distance_to(wall, wall->balls[k], point);
    if (count == FEW_BALLS && !(own < distance[FEW_BALLS - 1])) continue;
    size_t place = count < FEW_BALLS ? count++ : FEW_BALLS - 1;
    for (; place > 0 && distance[place - 1] > own; --place) {
      distance[place] = distance[place - 1];
      nearest[place] = nearest[place - 1];
    }
    distance[place] = own;
    nearest[place] = wall->balls[k];
  }
  return count;
}

static bool search_boxes(struct search *search, struct failure *failure) {
  const struct void_wall *wall = search->wall;
  struct box all = {{0, 0, 0}, {0, 0, 0}, 0.0, 0, wall->ball_count};
  if (!make_room(search, (size_t)wall->ball_count + 1, failure)) return false;
  memcpy(search->nearby, wall->balls, wall->ball_count * sizeof *search->nearby);
  for (int axis = 0; axis < 3; ++axis) {
    all.centre[axis] = 0.5 * (wall->low[axis] + wall->high[axis]);
    all.half[axis] = 0.5 * (wall->high[axis] - wall->low[axis]);
  }
  all.most = most_in_box(search, &all);
  if (!push_box(search, &all, failure)) return false;
  while (search->box_count > 0 && search->compared < ROOM_MOST_COMPARED) {
    if (!look_at_box(search, failure)) return false;
  }
  for (size_t k = 0; k < search->box_count; ++k) search->left = fmax(search->left, search->boxes[k].most);
  return true;
}

bool void_room_find(const struct geometry *geometry, const struct void_wall *wall, struct void_room *room,
                    struct failure *failure) {
  struct search search = {geometry, wall, NULL, 0, 0, NULL, 0, 0.0, 0, room};
  *room = (struct void_room){false, {0, 0, 0}, 0.0, 0.0};
  bool done = search_boxes(&search, failure);
  if (done && room->found) {
    const double best[3] = {room->xyz[0], room->xyz[1], room->xyz[2]};
    uint32_t nearest[FEW_BALLS];
    done = offer_centres(&search, NULL, nearest, nearest_balls(wall, best, nearest), failure);
  }
  room->bound = fmax(search.left, room->clearance);
  free(search.boxes);
  free(search.nearby);
  return done;
}
