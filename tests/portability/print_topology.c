#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "interface_bits.h"
#include "topology_result.h"

static void print_places(const topology_result *t) {
  uint32_t i;
  for (i = 0; i < t->counts.vertices; ++i) {
    const hsp_topology_vertex *vertex = &t->vertices[i];
    printf("place %" PRIu32 " %" PRIu32, vertex->kind, vertex->q);
    print_numbers(vertex->ball, 3);
    print_doubles(vertex->xyz, 3);
    end_line();
  }
  for (i = 0; i < t->counts.edges; ++i) {
    const hsp_topology_edge *edge = &t->edges[i];
    printf("edge %" PRIu32 " %" PRIu32, edge->kind, edge->source);
    print_numbers(edge->vertex, 2);
    print_numbers(edge->face, 2);
    print_numbers(edge->ball, 2);
    print_doubles(edge->centre, 3);
    print_doubles(edge->axis, 3);
    print_doubles(&edge->radius, 1);
    print_doubles(&edge->angle, 1);
    end_line();
    printf("quad");
    print_numbers(&t->onext[4 * i], 4);
    print_numbers(&t->origin[4 * i], 4);
    end_line();
  }
  for (i = 0; i < t->counts.simple_faces; ++i) {
    const hsp_simple_face *face = &t->faces[i];
    printf("simple face %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", face->ball, face->face,
           face->edges, face->q, face->shell);
  }
}

static void print_shells(const topology_result *t) {
  uint32_t i;
  for (i = 0; i < t->counts.shells; ++i) {
    const hsp_shell *shell = &t->shells[i];
    printf("shell %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRId64 " %" PRIu32 " %" PRIu32, shell->kind, shell->component,
           shell->region, shell->euler, shell->genus, shell->start_face);
    print_doubles(&shell->area, 1);
    print_doubles(&shell->volume, 1);
    print_doubles(shell->point, 3);
    end_line();
  }
  for (i = 0; i < t->counts.components; ++i) {
    const hsp_component *component = &t->components[i];
    printf("component %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", component->balls,
           component->top_ball, component->outer_shell, component->shells, component->region);
  }
  for (i = 0; i < t->counts.regions; ++i) {
    const hsp_region *region = &t->regions[i];
    printf("region %" PRIu32 " %" PRIu32 " %" PRIu32, region->enclosing_shell, region->components, region->shells);
    print_doubles(&region->area, 1);
    print_doubles(&region->volume, 1);
    end_line();
  }
}

/* The scan of every shell, and the region of a point beside every ball's centre. */
static void print_answers(const topology_result *t) {
  uint32_t *faces = malloc((t->counts.simple_faces + 1) * sizeof *faces);
  uint32_t i, needed = 0;
  if (faces == NULL) exit(2);
  for (i = 0; i < t->counts.shells; ++i) {
    print_status("scan", hsp_topology_get_traversal(t->topology, i, faces, t->counts.simple_faces, &needed));
    print_numbers(faces, needed);
    end_line();
  }
  free(faces);
  for (i = 0; i < t->base->n; ++i) {
    const double *ball = &t->base->xyz[3 * i];
    const double point[3] = {ball[0] + 0.5, ball[1] + 0.5, ball[2] + 0.5};
    uint32_t region = 0;
    print_status("located", hsp_topology_locate(t->topology, point, &region));
    print_numbers(&region, 1);
    end_line();
  }
}

void print_topology(const computed *c) {
  topology_result t;
  const int32_t status = topology_result_make(c, &t);
  print_status("topology", status);
  end_line();
  if (status == HSP_OK) {
    print_places(&t);
    print_shells(&t);
    print_answers(&t);
  }
  topology_result_release(&t);
}
