/* A walk over a shell, face by face: six balls in a ring, whose boundary is a torus. All steps from a face to the next
 * are quarter-edges: lnext goes round the face on the left, left(sym(q)) is the face across. No memory is allocated. */
#include <hardsphere.h>
#include <stdio.h>

#define BALLS 6
#define EDGES 128
#define CUT_ARCS 32

static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char topology_memory[HSP_TOPOLOGY_BYTES(BALLS, BALLS, EDGES, CUT_ARCS)];

static int32_t compute(hsp_topology **topology) {
  static const double xyz[BALLS][3] = {{1.0, 0.0, 0.0},  {0.5, 0.866025404, 0.0},   {-0.5, 0.866025404, 0.0},
                                       {-1.0, 0.0, 0.0}, {-0.5, -0.866025404, 0.0}, {0.5, -0.866025404, 0.0}};
  static const double radius[BALLS] = {0.7, 0.7, 0.7, 0.7, 0.7, 0.7};
  hsp_model *model;
  hsp_boundary *boundary;
  const hsp_boundary_limits boundary_limits = {
      .struct_size = sizeof boundary_limits, .balls = BALLS, .neighbours = BALLS, .vertices = 16, .circles = 16};
  const hsp_topology_limits topology_limits = {
      .struct_size = sizeof topology_limits, .balls = BALLS, .neighbours = BALLS, .edges = EDGES, .cut_arcs = CUT_ARCS};

  int32_t status = hsp_model_init(model_memory, sizeof model_memory, BALLS, &model);
  if (status == HSP_OK) status = hsp_model_set(model, BALLS, &xyz[0][0], radius, NULL, NULL);
  if (status == HSP_OK)
    status = hsp_boundary_init(boundary_memory, sizeof boundary_memory, &boundary_limits, &boundary);
  if (status == HSP_OK) status = hsp_boundary_compute(boundary, model, NULL);
  if (status == HSP_OK) status = hsp_topology_init(topology_memory, sizeof topology_memory, &topology_limits, topology);
  if (status == HSP_OK) status = hsp_topology_compute(*topology, boundary, NULL);
  return status;
}

/* Vertices and simple faces are never more than edges. */
static unsigned char vertex_seen[EDGES];
static unsigned char edge_seen[EDGES];
static unsigned char face_seen[EDGES];
static uint32_t faces_to_visit[EDGES];

struct tally {
  uint32_t vertices;
  uint32_t edges;
  uint32_t faces;
};

static void meet(unsigned char *seen, uint32_t *count) {
  if (!*seen) ++*count;
  *seen = 1;
}

static struct tally walk(const hsp_topology *topology, uint32_t start_face) {
  struct tally tally = {0, 0, 0};
  faces_to_visit[0] = start_face;
  meet(&face_seen[start_face], &tally.faces);
  for (uint32_t visited = 0; visited < tally.faces; ++visited) {
    hsp_simple_face face;
    if (hsp_topology_get_simple_faces(topology, faces_to_visit[visited], 1, &face) != HSP_OK) break;
    printf("  face %2u on ball %u, across its edges:", (unsigned)faces_to_visit[visited], (unsigned)face.ball);
    uint32_t q = face.q;
    do {
      const uint32_t across = hsp_topology_left(topology, HSP_QUAD_SYM(q));
      printf(" %u", (unsigned)across);
      meet(&vertex_seen[hsp_topology_origin(topology, q)], &tally.vertices);
      meet(&edge_seen[q / 4], &tally.edges);
      if (!face_seen[across]) {
        faces_to_visit[tally.faces] = across;
        meet(&face_seen[across], &tally.faces);
      }
      q = hsp_topology_lnext(topology, q);
    } while (q != face.q);
    printf("\n");
  }
  return tally;
}

int main(void) {
  hsp_topology *topology = NULL;
  hsp_shell shells[4];
  uint32_t count = 0;
  int32_t status = compute(&topology);
  if (status == HSP_OK) status = hsp_topology_get_shells(topology, shells, 4, &count);
  if (status != HSP_OK) {
    fprintf(stderr, "walk_shell: %s\n", hsp_status_text(status));
    return 1;
  }
  int wrong = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const hsp_shell *shell = &shells[i];
    printf("shell %u of kind %s\n", (unsigned)i, shell->kind == HSP_SHELL_OUTER ? "outer" : "void");
    const struct tally tally = walk(topology, shell->start_face);
    const int32_t euler = (int32_t)tally.vertices - (int32_t)tally.edges + (int32_t)tally.faces;
    printf("  V - E + F = %u - %u + %u = %d, genus %u: %s\n", (unsigned)tally.vertices, (unsigned)tally.edges,
           (unsigned)tally.faces, (int)euler, (unsigned)shell->genus,
           euler == shell->euler ? "as the library says" : "NOT what the library says");
    if (euler != shell->euler) wrong = 1;
  }
  return wrong;
}
