/* Prints every number that the interface gives for the ball sets of tests/api, doubles as bit patterns, to be
 * compared between processors and compilers. */
#include <hardsphere.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "ball_sets.h"
#include "computed.h"
#include "interface_bits.h"
#include "surface_result.h"

static void print_model(const computed *c) {
  hsp_packing figures = {0};
  printf("model %" PRIu32 " %" PRIu32 " %" PRIu32, c->info.cubes, c->info.table_slots, c->info.longest_probe);
  print_doubles(&c->info.step, 1);
  print_doubles(&c->info.probe, 1);
  print_doubles(&c->info.largest_radius, 1);
  end_line();
  print_status("figures", hsp_model_get_packing(c->model, &figures));
  printf(" %" PRIu32 " %" PRIu32, figures.max_overlaps, figures.flags);
  print_doubles(&figures.k, 1);
  print_doubles(&figures.rho, 1);
  print_doubles(&figures.mean_overlaps, 1);
  print_doubles(&figures.neighbour_bound, 1);
  end_line();
}

static void print_boundary(const computed *c) {
  const hsp_boundary_counts *n = &c->counts;
  uint32_t i;
  printf("counts %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRId64 "\n", n->loops,
         n->shells, n->components, n->voids, n->tied_vertices, n->contained_balls, n->euler);
  for (i = 0; i < n->vertices; ++i) {
    const hsp_vertex *vertex = &c->vertices[i];
    printf("vertex %" PRId32 " %" PRIu32, vertex->sign, vertex->flags);
    print_numbers(vertex->ball, 3);
    print_doubles(vertex->xyz, 3);
    end_line();
  }
  for (i = 0; i < n->arcs; ++i) {
    const hsp_arc *arc = &c->arcs[i];
    printf("arc");
    print_numbers(arc->ball, 2);
    print_numbers(arc->vertex, 2);
    print_numbers(arc->face, 2);
    print_doubles(arc->centre, 3);
    print_doubles(arc->axis, 3);
    print_doubles(&arc->radius, 1);
    print_doubles(&arc->angle, 1);
    end_line();
  }
  for (i = 0; i < n->circles; ++i) {
    const hsp_circle *circle = &c->circles[i];
    printf("circle");
    print_numbers(circle->ball, 2);
    print_numbers(circle->face, 2);
    print_doubles(circle->centre, 3);
    print_doubles(circle->axis, 3);
    print_doubles(&circle->radius, 1);
    end_line();
  }
  for (i = 0; i < n->faces; ++i) {
    printf("face %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", c->faces[i].ball, c->faces[i].loops, c->faces[i].shell);
  }
  for (i = 0; i < n->loops; ++i) {
    const hsp_loop *loop = &c->loops[i];
    printf("face loop %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, loop->face, loop->circle, loop->side, loop->arcs);
    end_line();
  }
  for (i = 0; i < 2 * n->arcs; ++i) {
    const hsp_loop_arc *at = &c->loop_arcs[i];
    printf("face loop arc %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", at->arc, at->side, at->vertex);
  }
}

static void print_balls(const computed *c) {
  uint32_t i;
  for (i = 0; i < c->n; ++i) {
    const hsp_ball *ball = &c->balls[i];
    printf("ball %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, ball->faces, ball->first_face, ball->component,
           ball->flags);
    print_doubles(&c->area[i], 1);
    print_doubles(&c->volume[i], 1);
    end_line();
  }
  printf("totals");
  print_doubles(&c->totals.area, 1);
  print_doubles(&c->totals.volume, 1);
  end_line();
}

static void print_surface(const computed *c) {
  surface_result s;
  uint32_t i;
  print_status("surface", surface_result_make(c, &s));
  printf(" %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, s.counts.cusped_patches, s.counts.cut_patches,
         s.counts.hidden_patches, s.counts.rounded_patches);
  print_doubles(&s.totals.area, 5);
  end_line();
  for (i = 0; i < c->n; ++i) {
    printf("share");
    print_doubles(&s.balls[i].area, 5);
    end_line();
  }
  surface_result_release(&s);
}

/* Some balls in turn, each halfway to another one; the last comes back. */
static void print_moving(const computed *c) {
  const hsp_moving_limits limits = {(uint32_t)sizeof limits, c->n, c->n};
  hsp_moving *moving = NULL;
  size_t bytes = 0;
  void *memory;
  uint32_t k;
  print_status("bytes of balls that move", hsp_moving_bytes(&limits, &bytes));
  memory = test_zeros(bytes, 1);
  print_status("init", hsp_moving_init(memory, bytes, &limits, &moving));
  print_status("set", hsp_moving_set(moving, c->model, NULL, 1, -0.5, HSP_TANGENT_OVERLAP, NULL, NULL));
  end_line();
  for (k = 0; k < 6 && c->n > 0; ++k) {
    const uint32_t ball = 7 * k % c->n, other = 3 * k % c->n;
    double to[3];
    hsp_energy energy = {0};
    hsp_moving_ball record;
    uint32_t axis;
    for (axis = 0; axis < 3; ++axis) to[axis] = 0.5 * (c->xyz[3 * ball + axis] + c->xyz[3 * other + axis]);
    print_status("move", hsp_moving_move(moving, 1, &ball, to, NULL, NULL, NULL));
    if (k == 5) print_status("undo", hsp_moving_undo(moving));
    print_status("energy", hsp_moving_gradient(moving, &energy, NULL, NULL, NULL, 0, NULL));
    print_doubles(&energy.value, 1);
    print_doubles(&energy.area, 1);
    print_doubles(&energy.volume, 1);
    print_doubles(&energy.d_probe, 1);
    print_status("ball", hsp_moving_get_balls(moving, 1, &other, &record));
    printf(" %" PRIu32 " %" PRIu32 " %" PRIu32, record.faces, record.flags, record.gradient_flags);
    print_doubles(record.d_centre, 3);
    print_doubles(&record.volume_term, 1);
    end_line();
  }
  free(memory);
}

/* With an argument: of so many sets one. */
int main(int argc, char **argv) {
  const uint32_t step = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
  static const double probes[] = {0.0, 0.4};
  static ball_set set;
  uint32_t which;
  size_t p;
  for (which = 0; which < ball_set_count(); which += step) {
    ball_set_make(which, &set);
    for (p = 0; p < sizeof probes / sizeof probes[0]; ++p) {
      hsp_model_options options;
      computed c;
      int32_t status = hsp_model_options_init(&options, (uint32_t)sizeof options);
      options.probe = probes[p];
      if (status == HSP_OK) status = computed_make(set.n, set.xyz, set.radius, &options, &c);
      printf("%s, probe %.1f\n", set.name, probes[p]);
      print_status("computed", status);
      end_line();
      if (status != HSP_OK) return 1;
      print_model(&c);
      print_boundary(&c);
      print_balls(&c);
      print_gradients(&c);
      print_surface(&c);
      print_moving(&c);
      print_topology(&c);
      print_periodic(&c);
      print_views(&c);
      print_maps(&c);
      computed_release(&c);
    }
  }
  return all_succeeded() && fflush(stdout) == 0 && ferror(stdout) == 0 ? 0 : 1;
}
