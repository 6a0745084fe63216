/* Firmware that uses a part of the library, to see how much flash that takes. PART is a sum of
 *   1 balls that a ball meets   2 boundary, measure and gradient   4 topology   8 views and pictures   16 other queries
 *   32 the solvent-excluded surface   64 balls that move   128 molecule against molecule
 * A model is part of every image but the one without the library, PART < 0. Nothing here runs in the test. */
#include <stddef.h>

#if PART >= 0
#include <hardsphere.h>

#define BALLS 24

static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static hsp_model *model;

/* Not static: the compiler must not know what is in them. */
double xyz[3 * BALLS], radius[BALLS];
volatile int32_t result;

static void set_model(void) {
  result |= hsp_model_init(model_memory, sizeof model_memory, BALLS, &model);
  result |= hsp_model_set(model, BALLS, xyz, radius, NULL, NULL);
}
#endif

#if PART >= 0 && (PART & 1)
static void query(void) {
  static uint32_t ids[BALLS];
  uint32_t needed;
  result |= hsp_query_ball(model, xyz, 1.5, ids, BALLS, &needed);
#if PART & 16
  uint32_t meets;
  result |= hsp_query_point(model, xyz, ids, BALLS, &needed);
  result |= hsp_query_meets(model, xyz, 1.5, &meets);
  result |= hsp_query_neighbours(model, 0, ids, BALLS, &needed);
  static uint32_t first[BALLS + 1];
  result |= hsp_query_pairs(model, 0, first, ids, BALLS, &needed);
  hsp_ray_hit hit;
  result |= hsp_query_ray(model, xyz, xyz + 3, &hit);
#endif
}
#endif

#if PART >= 0 && (PART & 2)
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 100, 10)];
static hsp_boundary *boundary;

static void compute_boundary(void) {
  hsp_boundary_limits limits;
  result |= hsp_boundary_limits_init(&limits, sizeof limits, BALLS);
  limits.neighbours = BALLS, limits.vertices = 100, limits.circles = 10;
  result |= hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary);
  result |= hsp_boundary_compute(boundary, model, NULL);
  static double area[BALLS], volume[BALLS], centre[3 * BALLS], slope[BALLS];
  hsp_totals totals;
  hsp_energy energy;
  result |= hsp_boundary_measure(boundary, NULL, &totals, area, volume, BALLS, NULL);
  result |= hsp_boundary_get_gradient(
      boundary, &(hsp_gradient_request){.struct_size = sizeof(hsp_gradient_request), .tension = 1, .pressure = 1},
      &(hsp_gradient_outputs){.struct_size = sizeof(hsp_gradient_outputs),
                              .energy = &energy,
                              .d_centre = centre,
                              .d_radius = slope,
                              .capacity = BALLS});
}
#endif

#if PART >= 0 && (PART & 32)
static void compute_surface(void) {
  static unsigned char memory[HSP_SURFACE_BYTES(100, 40, BALLS, 40, 200, 20)];
  static hsp_surface_totals shares[BALLS];
  hsp_surface_limits limits;
  hsp_surface *surface;
  hsp_surface_totals totals;
  result |= hsp_surface_limits_init(&limits, sizeof limits, boundary);
  limits.vertices = 100, limits.faces = 40, limits.neighbours = BALLS;
  limits.pieces = 40, limits.arcs = 200, limits.cusped_circles = 20;
  result |= hsp_surface_init(memory, sizeof memory, &limits, &surface);
  result |= hsp_surface_compute(surface, boundary, NULL);
  result |= hsp_surface_measure(surface, &totals, shares, BALLS, NULL);
}
#endif

#if PART >= 0 && (PART & 4)
static void compute_topology(void) {
  static unsigned char memory[HSP_TOPOLOGY_BYTES(BALLS, BALLS, 500, 100)];
  hsp_topology_limits limits;
  hsp_topology *topology;
  uint32_t cell;
  result |= hsp_topology_limits_init(&limits, sizeof limits, boundary);
  result |= hsp_topology_init(memory, sizeof memory, &limits, &topology);
  result |= hsp_topology_compute(topology, boundary, NULL);
  result |= hsp_topology_locate(topology, xyz, &cell);
  static hsp_shell shells[8];
  static hsp_region regions[8];
  uint32_t needed;
  result |= hsp_topology_get_shells(topology, shells, 8, &needed);
  result |= hsp_topology_get_regions(topology, regions, 8, &needed);
}
#endif

#if PART >= 0 && (PART & 8)
static int32_t send(void *context, const char *bytes, size_t count) {
  (void)context;
  for (size_t i = 0; i < count; ++i) result ^= bytes[i];
  return 0;
}

static void draw(void) {
  static unsigned char memory[HSP_VIEW_BYTES(BALLS, BALLS, 400)];
  hsp_view_limits limits;
  hsp_view *view;
  hsp_picture_options options;
  result |= hsp_view_limits_init(&limits, sizeof limits, BALLS);
  limits.neighbours = BALLS, limits.arcs = 400;
  result |= hsp_view_init(memory, sizeof memory, &limits, &view);
  result |= hsp_view_compute(view, model, NULL, NULL, NULL);
  result |= hsp_picture_options_init(&options, sizeof options);
  options.format = (uint32_t)result;
  result |= hsp_picture_write(view, NULL, &options, "title", NULL, send, NULL, NULL);
}
#endif

#if PART >= 0 && (PART & 64)
static void move_balls(void) {
  static unsigned char memory[HSP_MOVING_BYTES(BALLS, BALLS)];
  static hsp_moving_ball balls[BALLS];
  static uint32_t changed[BALLS];
  hsp_moving_limits limits;
  hsp_moving *moving;
  hsp_energy energy;
  const uint32_t ball = 0;
  uint32_t needed = 0;
  result |= hsp_moving_limits_init(&limits, sizeof limits, BALLS);
  result |= hsp_moving_init(memory, sizeof memory, &limits, &moving);
  result |= hsp_moving_set(moving, model, NULL, 1, 1, HSP_TANGENT_OVERLAP, NULL, NULL);
  result |= hsp_moving_move(moving, 1, &ball, xyz, NULL, NULL, NULL);
  result |= hsp_moving_gradient(moving, &energy, NULL, NULL, NULL, 0, NULL);
  result |= hsp_moving_get_changed(moving, changed, BALLS, &needed);
  result |= hsp_moving_get_balls(moving, needed, changed, balls);
  result |= hsp_moving_undo(moving);
}
#endif

#if PART >= 0 && (PART & 128)
static void meet(void) {
  static unsigned char memory[HSP_BODY_BYTES(BALLS)];
  hsp_body *body;
  hsp_pose pose = {{1, 0, 0, 0}, {0, 0, 0}};
  hsp_body_gap gap;
  uint32_t hit;
  result |= hsp_body_init(memory, sizeof memory, BALLS, &body);
  result |= hsp_body_set(body, model);
  result |= hsp_body_hits(body, body, 1, &pose, &hit, NULL);
  result |= hsp_body_gaps(body, body, 1, &pose, &gap, NULL);
}
#endif

int main(void) {
#if PART >= 0
  set_model();
#if PART & 64
  move_balls();
#endif
#if PART & 128
  meet();
#endif
#if PART & 1
  query();
#endif
#if PART & 2
  compute_boundary();
#endif
#if PART & 32
  compute_surface();
#endif
#if PART & 4
  compute_topology();
#endif
#if PART & 8
  draw();
#endif
#endif
  return 0;
}
