/* Shells, components and regions against tallies over the arrays, the scans against their definition, and the library's
 * check of itself. */
#include <math.h>
#include <stdlib.h>

#include "boundary_invariants.h"
#include "topology_invariants.h"
#include "vectors.h"

/* Areas are known up to roundings of what whole spheres have: spheres may nearly close a space, and its shell has next
 * to no area. Volumes: times the largest radius. */
static double area_rounding(const topology_result *t, uint32_t faces) {
  const double r = t->base->info.largest_radius;
  return 1e-12 * r * r * (1 + faces);
}

/* Numbers that are counted per shell. */
typedef struct tally {
  uint32_t vertices, edges, simple_faces, faces;
  int64_t euler; /* of the boundary: vertices - arcs + sum over maximal faces of 2 - loops */
} tally;

static uint32_t shell_of_edge(const topology_result *t, uint32_t edge) {
  return t->faces[t->edges[edge].face[0]].shell;
}

static const char *tally_up(const topology_result *t, tally *tallies) {
  const computed *c = t->base;
  uint32_t i;
  for (i = 0; i < t->counts.simple_faces; ++i) ++tallies[t->faces[i].shell].simple_faces;
  for (i = 0; i < t->counts.edges; ++i) {
    const uint32_t shell = shell_of_edge(t, i);
    if (t->faces[t->edges[i].face[1]].shell != shell) return "edge: between two shells";
    ++tallies[shell].edges;
  }
  for (i = 0; i < t->counts.vertices; ++i) {
    const uint32_t shell = shell_of_edge(t, t->vertices[i].q / 4);
    ++tallies[shell].vertices;
    if (i < c->counts.vertices) ++tallies[shell].euler;
  }
  for (i = 0; i < c->counts.arcs; ++i) --tallies[c->faces[c->arcs[i].face[0]].shell].euler;
  for (i = 0; i < c->counts.faces; ++i) {
    ++tallies[c->faces[i].shell].faces;
    tallies[c->faces[i].shell].euler += 2 - (int64_t)c->faces[i].loops;
  }
  return NULL;
}

/* Whether ball i comes before ball j by (x, y, z, radius), whatever rounding to the lattice does to them. */
static int surely_ranks_before(const computed *c, uint32_t i, uint32_t j) {
  int k;
  for (k = 0; k < 4; ++k) {
    const double a = k < 3 ? c->xyz[3 * i + (uint32_t)k] : c->radius[i];
    const double b = k < 3 ? c->xyz[3 * j + (uint32_t)k] : c->radius[j];
    if (a != b) return b - a > 4 * c->rounding;
  }
  return 0;
}

/* Whether a simple face of the shell lies on a ball of lower rank than its start_face, or comes before it on its ball.
 */
static int starts_late(const topology_result *t, uint32_t shell) {
  const uint32_t start = t->shells[shell].start_face;
  uint32_t i;
  for (i = 0; i < t->counts.simple_faces; ++i) {
    if (t->faces[i].shell != shell) continue;
    if (surely_ranks_before(t->base, t->faces[i].ball, t->faces[start].ball)) return 1;
    if (t->faces[i].ball == t->faces[start].ball && i < start) return 1;
  }
  return 0;
}

static const char *broken_shell(const topology_result *t, uint32_t id, const tally *counted) {
  const hsp_shell *s = t->shells + id;
  const double rounding = area_rounding(t, s->faces), r = t->base->info.largest_radius;
  const double bound = (s->area + rounding) * (s->area + rounding) * (s->area + rounding);
  if (s->vertices != counted->vertices || s->edges != counted->edges || s->simple_faces != counted->simple_faces ||
      s->faces != counted->faces) {
    return "shell: its numbers are not those of its records";
  }
  if (s->euler != (int64_t)s->vertices - s->edges + s->simple_faces) {
    return "shell: euler is not vertices - edges + simple faces";
  }
  if (s->euler != counted->euler) return "shell: euler is not that of its maximal faces";
  if (s->euler > 2 || s->euler % 2 != 0 || s->genus != (uint32_t)((2 - s->euler) / 2)) {
    return "shell: genus is not 1 - euler/2";
  }
  if (s->kind > HSP_SHELL_VOID) return "shell: unknown kind";
  if (s->component >= t->counts.components || s->region >= t->counts.regions)
    return "shell: no such component or region";
  if (s->kind == HSP_SHELL_OUTER && t->components[s->component].outer_shell != id) {
    return "shell: outer, but not the outer shell of its component";
  }
  if (s->kind == HSP_SHELL_VOID && t->regions[s->region].enclosing_shell != id)
    return "shell: of a void that it does not enclose";
  if (s->start_face >= t->counts.simple_faces || t->faces[s->start_face].shell != id) {
    return "shell: start_face is none of its simple faces";
  }
  if (s->kind == HSP_SHELL_VOID && starts_late(t, id)) {
    return "shell: the start_face of a void is not the first on its ball of lowest rank";
  }
  if (!(s->area >= -rounding && s->volume >= -rounding * r)) return "shell: negative area or volume";
  if (!(36 * pi * s->volume * s->volume <= bound * (1 + 1e-9) + rounding * rounding * r * r)) {
    return "shell: encloses more than the ball of its area";
  }
  return NULL;
}

static const char *broken_shells(const topology_result *t) {
  const computed *c = t->base;
  const double rounding = area_rounding(t, c->counts.faces), r = c->info.largest_radius;
  double area = 0, volume = 0, volumes = 0;
  const char *broken;
  uint32_t i;
  tally *tallies = test_zeros(t->counts.shells, sizeof *tallies);
  broken = tally_up(t, tallies);
  for (i = 0; i < t->counts.shells && broken == NULL; ++i) {
    const hsp_shell *s = t->shells + i;
    broken = broken_shell(t, i, tallies + i);
    area += s->area;
    volume += s->kind == HSP_SHELL_OUTER ? s->volume : -s->volume;
    volumes += s->volume;
  }
  free(tallies);
  if (broken != NULL) return broken;
  for (i = 0; i < t->counts.simple_faces; ++i) {
    if (t->shells[t->faces[i].shell].component != c->balls[t->faces[i].ball].component) {
      return "simple face: its shell is not of its ball's component";
    }
  }
  if (!(fabs(area - c->totals.area) <= 1e-12 * area + rounding)) {
    return "hsp_topology_get_shells, property 1: areas sum to the area of the union";
  }
  if (!(fabs(volume - c->totals.volume) <= 1e-11 * volumes + rounding * r)) {
    return "hsp_topology_get_shells, property 1: volumes of outer shells less those of voids are the volume";
  }
  return NULL;
}

/* How high a ball reaches; in whole lattice steps if the lattice moved nothing, so that heights compare exactly. */
static double top_of_ball(const computed *c, uint32_t i) {
  const double z = c->xyz[3 * i + 2], step = c->info.step;
  if (c->rounding > 0) return z + c->radius[i];
  return floor(z / step + 0.5) + floor((c->radius[i] - c->info.probe) / step + 0.5);
}

/* How far tops may be below the highest one and still be it. */
static double top_rounding(const computed *c, double top) {
  return c->rounding > 0 ? 4 * c->rounding + 1e-13 * (fabs(top) + c->info.largest_radius) : 0;
}

static const char *broken_components(const topology_result *t) {
  const computed *c = t->base;
  const char *broken = NULL;
  uint32_t i;
  double top_of_all = -HUGE_VAL;
  uint32_t *balls = test_zeros(t->counts.components, sizeof(uint32_t)),
           *shells = test_zeros(t->counts.components, sizeof(uint32_t));
  double *top = test_zeros(t->counts.components, sizeof *top);
  for (i = 0; i < t->counts.components; ++i) top[i] = -HUGE_VAL;
  for (i = 0; i < c->n; ++i) {
    const uint32_t k = c->balls[i].component;
    ++balls[k];
    top[k] = fmax(top[k], top_of_ball(c, i));
    top_of_all = fmax(top_of_all, top[k]);
  }
  for (i = 0; i < t->counts.shells; ++i) ++shells[t->shells[i].component];
  for (i = 0; i < t->counts.components && broken == NULL; ++i) {
    const hsp_component *k = t->components + i;
    if (k->reserved != 0) broken = "component: reserved is not 0";
    if (k->balls != balls[i]) broken = "component: balls is not the number of its balls";
    if (k->shells != shells[i]) broken = "component: shells is not the number of its shells";
    if (k->outer_shell >= t->counts.shells || k->top_ball >= c->n) {
      broken = "component: no such shell or ball";
      break;
    }
    if (t->shells[k->outer_shell].component != i || t->shells[k->outer_shell].kind != HSP_SHELL_OUTER) {
      broken = "component: its outer shell is none";
    }
    if (k->region != t->shells[k->outer_shell].region) broken = "component: not in the region of its outer shell";
    if (c->balls[k->top_ball].component != i) broken = "component: its top ball belongs to another";
    if (!(top_of_ball(c, k->top_ball) >= top[i] - top_rounding(c, top[i]))) {
      broken = "component: another ball reaches higher than its top ball";
    }
    if (t->faces[t->shells[k->outer_shell].start_face].ball != k->top_ball) {
      broken = "component: the scan of its outer shell does not start on its top ball";
    }
    if (t->faces[t->shells[k->outer_shell].start_face].shell != k->outer_shell) {
      broken = "component: its highest point is not on its outer shell";
    }
  }
  if (broken == NULL && t->counts.start_face != HSP_NONE) {
    const hsp_simple_face *start = t->faces + t->counts.start_face;
    const hsp_shell *shell = t->shells + start->shell;
    if (shell->start_face != t->counts.start_face || shell->kind != HSP_SHELL_OUTER || shell->region != 0) {
      broken = "start_face is not where an outer shell of region 0 starts";
    }
    if (!(top[shell->component] >= top_of_all - top_rounding(c, top_of_all))) {
      broken = "start_face is not in the highest component";
    }
  }
  free(balls);
  free(shells);
  free(top);
  return broken;
}

static const char *broken_region(const topology_result *t, uint32_t id) {
  const hsp_region *region = t->regions + id;
  const double rounding = area_rounding(t, t->base->counts.faces), r = t->base->info.largest_radius;
  double area = 0, volume = 0, sizes = 0;
  uint32_t i, components = 0, shells = 0, needed = HSP_NONE;
  int good = 1;
  uint32_t *ids = test_zeros(t->counts.shells, sizeof(uint32_t));
  if (hsp_topology_get_region_shells(t->topology, id, ids, t->counts.shells, &needed) != HSP_OK) good = 0;
  for (i = 0; i < t->counts.shells; ++i) {
    const hsp_shell *s = t->shells + i;
    if (s->region != id) continue;
    if (!(shells < needed && ids[shells] == i)) good = 0;
    ++shells;
    area += s->area;
    volume += s->kind == HSP_SHELL_VOID ? s->volume : -s->volume;
    sizes += s->volume;
    if (s->kind == HSP_SHELL_OUTER) ++components;
  }
  free(ids);
  if (!good || shells != needed)
    return "hsp_topology_get_region_shells: not its enclosing shell and outer shells, ascending";
  if (region->reserved != 0) return "region: reserved is not 0";
  if (region->components != components || region->shells != shells)
    return "region: wrong numbers of components or shells";
  if ((region->enclosing_shell == HSP_NONE) != (id == 0)) return "region: region 0 alone has no enclosing shell";
  if (id > 0) {
    if (region->enclosing_shell >= t->counts.shells || t->shells[region->enclosing_shell].kind != HSP_SHELL_VOID ||
        t->shells[region->enclosing_shell].region != id) {
      return "region: its enclosing shell is not that of a void around it";
    }
    if (id > 1 && t->regions[id - 1].enclosing_shell >= region->enclosing_shell)
      return "regions are not in the order of their shells";
  }
  if (!(fabs(region->area - area) <= 1e-12 * area + rounding)) return "region: area is not that of its shells";
  if (id == 0 ? region->volume != 0 : !(fabs(region->volume - volume) <= 1e-12 * sizes + rounding * r)) {
    return "region: volume is not that of its enclosing shell less what lies in it";
  }
  if (!(region->volume >= -1e-12 * sizes - rounding * r)) return "region: negative volume";
  return NULL;
}

/* The balls of a region against the simple faces. A ball on no region is one without faces: property 1. */
static const char *broken_region_balls(const topology_result *t) {
  const uint32_t n = t->base->n;
  uint32_t *ids = test_zeros(n, sizeof(uint32_t));
  unsigned char *lines = test_zeros(n, 1), *exposed = test_zeros(n, 1);
  const char *broken = NULL;
  uint32_t id, i, k, needed = 0;
  for (id = 0; id < t->counts.regions && broken == NULL; ++id) {
    for (i = 0; i < n; ++i) lines[i] = 0;
    for (i = 0; i < t->counts.simple_faces; ++i) {
      if (t->shells[t->faces[i].shell].region == id) lines[t->faces[i].ball] = exposed[t->faces[i].ball] = 1;
    }
    if (hsp_topology_get_region_balls(t->topology, id, ids, n, &needed) != HSP_OK) needed = HSP_NONE;
    for (i = 0, k = 0; i < n; ++i) {
      if (lines[i] && (k >= needed || ids[k++] != i)) needed = HSP_NONE;
    }
    if (k != needed) broken = "hsp_topology_get_region_balls: not the balls with faces on the region, ascending";
  }
  for (i = 0; i < n && broken == NULL; ++i) {
    if (exposed[i] != (t->base->balls[i].faces > 0))
      broken = "hsp_topology_get_region_balls, property 1: an exposed ball lines a region";
  }
  free(ids);
  free(lines);
  free(exposed);
  return broken;
}

/* From any region, outwards over the component that walls it to the region that this one lies in, one comes to region
 * 0. */
static const char *broken_nesting(const topology_result *t) {
  uint32_t i;
  for (i = 0; i < t->counts.regions; ++i) {
    uint32_t at = i, steps = 0;
    while (at != 0) {
      const hsp_component *around = t->components + t->shells[t->regions[at].enclosing_shell].component;
      if (around->region >= t->counts.regions) return "component: no such region";
      at = around->region;
      if (++steps > t->counts.components) return "regions lie in each other in a circle";
    }
  }
  return NULL;
}

static const char *broken_regions(const topology_result *t) {
  const char *broken = NULL;
  uint32_t i, needed = 12345;
  for (i = 0; i < t->counts.regions && broken == NULL; ++i) broken = broken_region(t, i);
  if (broken == NULL) broken = broken_region_balls(t);
  if (broken == NULL) broken = broken_nesting(t);
  if (broken == NULL && (hsp_topology_get_region_shells(t->topology, t->counts.regions, NULL, 0, &needed) != HSP_E_ID ||
                         hsp_topology_get_traversal(t->topology, t->counts.shells, NULL, 0, &needed) != HSP_E_ID)) {
    broken = "a region or shell that there is not";
  }
  return broken;
}

/* The paper's recursion, with a stack: around each face counter-clockwise from the edge by which it was entered, and at
 * once into every neighbour not visited before. `faces`, `visited`, `entered` and `at` have room for all simple faces.
 */
static const char *broken_scan(const topology_result *t, uint32_t shell, uint32_t *faces, uint32_t *visited,
                               uint32_t *entered, uint32_t *at) {
  const uint32_t count = t->shells[shell].simple_faces, start = t->shells[shell].start_face;
  uint32_t needed = 0, depth = 1, reached = 1;
  if (hsp_topology_get_traversal(t->topology, shell, faces, count, &needed) != HSP_OK || needed != count) {
    return "hsp_topology_get_traversal: not as many simple faces as its shell has";
  }
  if (faces[0] != start) return "hsp_topology_get_traversal: does not begin with start_face";
  visited[start] = 1;
  entered[0] = at[0] = t->faces[start].q;
  while (depth > 0) {
    const uint32_t q = at[depth - 1], across = q - q % 4 + (q + 2) % 4, face = hsp_topology_left(t->topology, across);
    at[depth - 1] = hsp_topology_lnext(t->topology, q);
    if (at[depth - 1] == entered[depth - 1]) --depth;
    if (visited[face]) continue;
    if (reached == count) return "hsp_topology_get_traversal: ends before its recursion";
    if (faces[reached] != face) return "hsp_topology_get_traversal: not in the order of the recursion";
    if (t->faces[face].shell != shell) return "hsp_topology_get_traversal: a simple face of another shell";
    ++reached;
    visited[face] = 1;
    entered[depth] = at[depth] = across;
    ++depth;
  }
  return reached == count ? NULL : "hsp_topology_get_traversal: goes on after its recursion";
}

static const char *broken_scans(const topology_result *t) {
  const char *broken = NULL;
  const uint32_t count = t->counts.simple_faces;
  uint32_t i;
  uint32_t *faces = test_zeros(count, sizeof(uint32_t)), *visited = test_zeros(count, sizeof(uint32_t));
  uint32_t *entered = test_zeros(count, sizeof(uint32_t)), *at = test_zeros(count, sizeof(uint32_t));
  for (i = 0; i < t->counts.shells && broken == NULL; ++i) broken = broken_scan(t, i, faces, visited, entered, at);
  free(faces);
  free(visited);
  free(entered);
  free(at);
  return broken;
}

static const char *broken_own_check(const topology_result *t) {
  uint32_t invariant = 77, id = 77;
  const int32_t status = hsp_topology_check(t->topology, &invariant, &id);
  return broken_by_own_check(status, invariant, id);
}

const char *broken_topology_shells(const topology_result *t) {
  const char *broken = broken_shells(t);
  if (broken == NULL) broken = broken_components(t);
  if (broken == NULL) broken = broken_regions(t);
  if (broken == NULL) broken = broken_scans(t);
  if (broken == NULL) broken = broken_own_check(t);
  return broken;
}
