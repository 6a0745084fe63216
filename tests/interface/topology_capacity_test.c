/* Every limit of hsp_topology and every output array of its functions, for every set of topology_sets.h, at 0, 1,
 * needed-1, needed and needed+1: HSP_E_CAPACITY with nothing written beyond what the header names, or the same results
 * as with ample memory. Guard bytes lie around all memory. Sizes of handles: property numbers of hsp_topology_bytes. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "topology_result.h"
#include "topology_sets.h"

/* ---- limits ---- */

static uint32_t *limit_number(hsp_topology_limits *limits, int which) {
  switch (which) {
    case 0:
      return &limits->balls;
    case 1:
      return &limits->neighbours;
    case 2:
      return &limits->edges;
    default:
      return &limits->extra_arcs;
  }
}

/* The results are those that are known. */
static void check_same_results(const topology_result *all, const hsp_topology *topology) {
  hsp_topology_limits needed;
  hsp_topology_counts counts;
  uint32_t count = 0;
  guarded_memory onext = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory origin = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory edges = guarded_take(sizeof(hsp_topology_edge) * all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory shells = guarded_take(sizeof(hsp_shell) * all->counts.shells, 0, GUARDED_PATTERN);
  memset(&needed, 0, sizeof needed);
  CHECK_EQUAL(hsp_topology_get_needed(topology, &needed), HSP_OK);
  CHECK_BYTES(&needed, &all->needed, sizeof needed);
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_topology_get_quad_edges(topology, (uint32_t *)(void *)onext.block, (uint32_t *)(void *)origin.block,
                                          all->counts.edges, &count),
              HSP_OK);
  CHECK_BYTES(onext.block, all->onext, onext.bytes);
  CHECK_BYTES(origin.block, all->origin, origin.bytes);
  CHECK_EQUAL(hsp_topology_get_edges(topology, (hsp_topology_edge *)(void *)edges.block, all->counts.edges, &count),
              HSP_OK);
  CHECK_BYTES(edges.block, all->edges, edges.bytes);
  CHECK_EQUAL(hsp_topology_get_shells(topology, (hsp_shell *)(void *)shells.block, all->counts.shells, &count), HSP_OK);
  CHECK_BYTES(shells.block, all->shells, shells.bytes);
  CHECK(guarded_clean(&onext) && guarded_clean(&origin) && guarded_clean(&edges) && guarded_clean(&shells));
  guarded_give_back(&onext);
  guarded_give_back(&origin);
  guarded_give_back(&edges);
  guarded_give_back(&shells);
}

/* A topology with room for `limits`, enlarged by what it asks for until it succeeds. */
static void try_limits(const topology_result *all, const hsp_topology_limits *from, size_t misalignment) {
  const hsp_topology_limits *suffices = &all->needed;
  hsp_topology_limits limits = *from;
  int enlargements, which;
  for (enlargements = 0; enlargements <= 3; ++enlargements) {
    size_t bytes = 0;
    guarded_memory memory;
    hsp_topology *topology = NULL;
    hsp_topology_limits needed;
    hsp_topology_counts counts;
    uint32_t count = 12345;
    int enough = 1, asked = 0;
    for (which = 0; which < 4; ++which) {
      hsp_topology_limits exact = *suffices;
      if (*limit_number(&limits, which) < *limit_number(&exact, which)) enough = 0;
    }
    if (!CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_OK)) return;
    memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
    CHECK_EQUAL(hsp_topology_init(memory.block, bytes, &limits, &topology), HSP_OK);
    if (enough) {
      CHECK_EQUAL(hsp_topology_compute(topology, all->base->boundary), HSP_OK);
      check_same_results(all, topology);
    } else {
      CHECK_EQUAL(hsp_topology_compute(topology, all->base->boundary), HSP_E_CAPACITY);
      CHECK_EQUAL(hsp_topology_get_needed(topology, &needed), HSP_OK);
      CHECK_EQUAL(needed.struct_size, sizeof needed);
      CHECK_EQUAL(needed.reserved, 0);
      for (which = 0; which < 4; ++which) {
        hsp_topology_limits exact = *suffices;
        const uint32_t given = *limit_number(&limits, which), says = *limit_number(&needed, which);
        const int short_of = given < *limit_number(&exact, which);
        /* what is known is known exactly: larger than given where that was too small, and only there */
        if (says > given) asked = CHECK(short_of);
        if (short_of) CHECK(says > given || says == 0);
        if (says > given) *limit_number(&limits, which) = says;
      }
      CHECK(asked);
      CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_E_STATE);
      CHECK_EQUAL(hsp_topology_get_shells(topology, NULL, 0, &count), HSP_E_STATE);
      CHECK_EQUAL(hsp_topology_onext(topology, 0), HSP_NONE);
      CHECK_EQUAL(count, 12345);
    }
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
    if (enough) return;
  }
  check_true(0, "three enlargements by hsp_topology_get_needed lead to success", __FILE__, __LINE__);
}

static void sweep_limits(const topology_result *all, const char *name) {
  static const char *const names[4] = {"balls", "neighbours", "edges", "extra arcs"};
  hsp_topology_limits limits = all->needed;
  int which, i;
  check_scene("%s, all limits exact", name);
  try_limits(all, &limits, 1);
  for (which = 0; which < 4; ++which) {
    const uint32_t needed = *limit_number(&limits, which);
    uint32_t values[5];
    values[0] = 0;
    values[1] = 1;
    values[2] = needed == 0 ? 0 : needed - 1;
    values[3] = needed;
    values[4] = needed + 1;
    for (i = 0; i < 5; ++i) {
      check_scene("%s, %s %u of %u", name, names[which], (unsigned)values[i], (unsigned)needed);
      *limit_number(&limits, which) = values[i];
      try_limits(all, &limits, (size_t)(3 * i + which));
      /* and as the only one that suffices */
      if (i == 3) {
        hsp_topology_limits alone = limits;
        int other;
        for (other = 0; other < 4; ++other) {
          if (other != which) *limit_number(&alone, other) = 0;
        }
        try_limits(all, &alone, 5);
      }
    }
    *limit_number(&limits, which) = needed;
  }
  check_scene("%s, nothing at all", name);
  limits.balls = limits.neighbours = limits.edges = limits.extra_arcs = 0;
  try_limits(all, &limits, 7);
}

/* ---- output arrays ---- */

/* What is being asked, so that one sweep serves all functions. */
typedef struct question {
  const topology_result *all;
  uint32_t id;
} question;

typedef int32_t (*asking)(const question *q, void *out, uint32_t capacity, uint32_t *needed);

static int32_t ask_onext(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_quad_edges(q->all->topology, out, NULL, capacity, needed);
}
static int32_t ask_origin(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_quad_edges(q->all->topology, NULL, out, capacity, needed);
}
static int32_t ask_vertices(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_vertices(q->all->topology, out, capacity, needed);
}
static int32_t ask_edges(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_edges(q->all->topology, out, capacity, needed);
}
static int32_t ask_faces(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_faces(q->all->topology, out, capacity, needed);
}
static int32_t ask_shells(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_shells(q->all->topology, out, capacity, needed);
}
static int32_t ask_components(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_components(q->all->topology, out, capacity, needed);
}
static int32_t ask_cells(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_cells(q->all->topology, out, capacity, needed);
}
static int32_t ask_cell_shells(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_cell_shells(q->all->topology, q->id, out, capacity, needed);
}
static int32_t ask_scan(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_scan(q->all->topology, q->id, out, capacity, needed);
}

static void sweep(asking ask, const question *q, size_t record, uint32_t expected) {
  uint32_t capacities[5], i, needed = 12345;
  capacities[0] = 0;
  capacities[1] = 1;
  capacities[2] = expected == 0 ? 0 : expected - 1;
  capacities[3] = expected;
  capacities[4] = expected + 1;
  CHECK_EQUAL(ask(q, NULL, 0, &needed), expected == 0 ? HSP_OK : HSP_E_CAPACITY);
  CHECK_EQUAL(needed, expected);
  for (i = 0; i < 5; ++i) {
    const uint32_t capacity = capacities[i];
    /* records are aligned as their type wants, hence a misalignment of 0 */
    guarded_memory out = guarded_take(capacity * record, 0, GUARDED_PATTERN);
    needed = 12345;
    if (capacity < expected) {
      CHECK_EQUAL(ask(q, out.block, capacity, &needed), HSP_E_CAPACITY);
      CHECK(guarded_untouched(&out, GUARDED_PATTERN));
    } else {
      /* all of every record is written, and nothing behind the last */
      guarded_memory again = guarded_take(capacity * record, 0, 0x11);
      CHECK_EQUAL(ask(q, out.block, capacity, &needed), HSP_OK);
      CHECK_EQUAL(ask(q, again.block, capacity, &needed), HSP_OK);
      CHECK_BYTES(out.block, again.block, expected * record);
      CHECK(capacity == expected || out.block[expected * record] == GUARDED_PATTERN);
      CHECK(capacity == expected || again.block[capacity * record - 1] == 0x11);
      CHECK(guarded_clean(&again));
      guarded_give_back(&again);
    }
    CHECK_EQUAL(needed, expected);
    CHECK(guarded_clean(&out));
    guarded_give_back(&out);
  }
}

/* Without both arrays only the query for their size is good. */
static void no_arrays(const topology_result *all) {
  uint32_t needed = 12345;
  CHECK_EQUAL(hsp_topology_get_quad_edges(all->topology, NULL, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_quad_edges(all->topology, NULL, NULL, all->counts.edges + 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(needed, 12345);
}

static void sweep_outputs(const topology_result *all) {
  const hsp_topology_counts *k = &all->counts;
  question q;
  q.all = all;
  q.id = 0;
  sweep(ask_onext, &q, 4 * sizeof(uint32_t), k->edges);
  sweep(ask_origin, &q, 4 * sizeof(uint32_t), k->edges);
  no_arrays(all);
  sweep(ask_vertices, &q, sizeof(hsp_topology_vertex), k->vertices);
  sweep(ask_edges, &q, sizeof(hsp_topology_edge), k->edges);
  sweep(ask_faces, &q, sizeof(hsp_simple_face), k->simple_faces);
  sweep(ask_shells, &q, sizeof(hsp_shell), k->shells);
  sweep(ask_components, &q, sizeof(hsp_component), k->components);
  sweep(ask_cells, &q, sizeof(hsp_cell), k->cells);
  for (q.id = 0; q.id < k->cells; q.id += 1 + k->cells / 4) {
    sweep(ask_cell_shells, &q, sizeof(uint32_t), all->cells[q.id].shells);
  }
  for (q.id = 0; q.id < k->shells; q.id += 1 + k->shells / 4) {
    sweep(ask_scan, &q, sizeof(uint32_t), all->shells[q.id].simple_faces);
  }
}

/* ---- sizes ---- */

/* Where size_t has 32 bits, sizes of 2 GiB and more are refused, and only they: SIZE_MAX stands for them, so that
 * property 2 covers them. */
static size_t bytes_of(uint32_t balls, uint32_t neighbours, uint32_t edges, uint32_t extra_arcs) {
  hsp_topology_limits limits;
  size_t bytes = 0;
  limits.struct_size = (uint32_t)sizeof limits;
  limits.balls = balls;
  limits.neighbours = neighbours;
  limits.edges = edges;
  limits.extra_arcs = extra_arcs;
  limits.reserved = 0;
  if (hsp_topology_bytes(&limits, &bytes) == HSP_OK) return bytes;
  CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_E_RANGE);
  CHECK(4096.0 + 64.0 * balls + 192.0 * neighbours + 160.0 * edges + 160.0 * extra_arcs > (double)(SIZE_MAX / 2));
  return SIZE_MAX;
}

static void sizes(void) {
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 1000000, 0x0FFFFFFF};
  enum { BOX = sizeof box / sizeof box[0] };
  int a, b, c, d;
  for (a = 0; a < BOX; ++a) {
    for (b = 0; b < BOX; ++b) {
      for (c = 0; c < BOX; ++c) {
        for (d = 0; d < BOX; ++d) {
          const size_t bytes = bytes_of(box[a], box[b], box[c], box[d]);
          check_scene("limits %u %u %u %u", (unsigned)box[a], (unsigned)box[b], (unsigned)box[c], (unsigned)box[d]);
          /* property 1: at most HSP_TOPOLOGY_BYTES of the four limits */
          CHECK(bytes == SIZE_MAX || bytes <= HSP_TOPOLOGY_BYTES(box[a], box[b], box[c], box[d]));
          /* property 2: grows with each limit */
          if (a > 0) CHECK(bytes >= bytes_of(box[a - 1], box[b], box[c], box[d]));
          if (b > 0) CHECK(bytes >= bytes_of(box[a], box[b - 1], box[c], box[d]));
          if (c > 0) CHECK(bytes >= bytes_of(box[a], box[b], box[c - 1], box[d]));
          if (d > 0) CHECK(bytes >= bytes_of(box[a], box[b], box[c], box[d - 1]));
        }
      }
    }
  }
  check_scene("%s", "");
  CHECK(bytes_of(1000, 50, 1000, 100) < bytes_of(2000, 50, 1000, 100));
  CHECK(bytes_of(1000, 50, 1000, 100) < bytes_of(1000, 50, 2000, 100));
}

static void every_alignment(void) {
  static ball_set set;
  computed c;
  topology_result all;
  size_t misalignment, bytes = 0;
  topology_set_two_in_a_void(&set);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(topology_result_make(&c, &all), HSP_OK);
  CHECK_EQUAL(hsp_topology_bytes(&all.needed, &bytes), HSP_OK);
  for (misalignment = 0; misalignment < 16; ++misalignment) {
    guarded_memory memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
    guarded_memory less = guarded_take(bytes - 1, misalignment, GUARDED_PATTERN);
    hsp_topology *topology = NULL;
    uint32_t law = 77, where = 77, cell = 77;
    static const double place[3] = {0, 1, 0};
    check_scene("misalignment %u", (unsigned)misalignment);
    CHECK_EQUAL(hsp_topology_init(less.block, bytes - 1, &all.needed, &topology), HSP_E_MEMORY);
    CHECK(topology == NULL);
    CHECK(guarded_untouched(&less, GUARDED_PATTERN) && guarded_clean(&less));
    CHECK_EQUAL(hsp_topology_init(memory.block, bytes, &all.needed, &topology), HSP_OK);
    CHECK((unsigned char *)topology >= memory.block && (unsigned char *)topology < memory.block + bytes);
    CHECK_EQUAL(hsp_topology_compute(topology, c.boundary), HSP_OK);
    check_same_results(&all, topology);
    CHECK_EQUAL(hsp_topology_check(topology, &law, &where), HSP_OK);
    CHECK_EQUAL(hsp_topology_locate(topology, place, &cell, NULL, 0, NULL), HSP_OK);
    CHECK_EQUAL(cell, 1);
    check_same_results(&all, topology);
    CHECK(guarded_clean(&memory));
    guarded_give_back(&memory);
    guarded_give_back(&less);
  }
  topology_result_release(&all);
  computed_release(&c);
}

int main(void) {
  uint32_t which;
  sizes();
  every_alignment();
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_result all;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    memset(&all, 0, sizeof all);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK) &&
        CHECK_EQUAL(topology_result_make(&c, &all), HSP_OK)) {
      sweep_limits(&all, set.name);
      check_scene("%s", set.name);
      sweep_outputs(&all);
    }
    topology_result_release(&all);
    computed_release(&c);
  }
  return check_report();
}
