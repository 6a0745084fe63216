#include <inttypes.h>
#include <stdio.h>

#include "interface_bits.h"
#include "map_result.h"
#include "sticks_result.h"

static void print_info(const char *what, const hsp_map_info *info) {
  printf("%s %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, what, info->vertices, info->edges, info->faces,
         info->components, info->balls);
  print_doubles(info->origin, 3);
  print_doubles(info->right, 3);
  print_doubles(info->up, 3);
  print_doubles(info->towards, 3);
  print_doubles(&info->area, 1);
  print_doubles(&info->perturbation, 1);
  end_line();
}

static void print_records(const hsp_map_info *info, const hsp_map_vertex *vertices, const hsp_map_edge *edges,
                          const hsp_map_face *faces) {
  uint32_t i;
  for (i = 0; i < info->vertices; ++i) {
    const hsp_map_vertex *vertex = &vertices[i];
    printf("map vertex %" PRIu32 " %" PRIu32, vertex->kind, vertex->h);
    print_numbers(vertex->ball, 3);
    print_doubles(vertex->xyz, 3);
    end_line();
  }
  for (i = 0; i < info->edges; ++i) {
    const hsp_map_edge *edge = &edges[i];
    printf("map edge");
    print_numbers(edge->ball, 2);
    print_numbers(edge->face, 2);
    print_numbers(edge->vertex, 2);
    print_numbers(edge->next, 2);
    print_doubles(edge->centre, 2);
    print_doubles(edge->first, 2);
    print_doubles(edge->second, 2);
    print_doubles(&edge->from, 1);
    print_doubles(&edge->to, 1);
    end_line();
  }
  for (i = 0; i < info->faces; ++i) {
    const hsp_map_face *face = &faces[i];
    printf("map face %" PRIu32 " %" PRIu32 " %" PRIu32, face->ball, face->h, face->loops);
    print_doubles(&face->area, 1);
    end_line();
  }
}

/* The middle of every edge with the gaps beside it, and of every face the pole with what is seen there. */
static void print_answers(const map_result *m) {
  uint32_t i;
  for (i = 0; i < m->info.edges; ++i) {
    hsp_map_point point;
    print_status("point", hsp_map_get_point(m->map, i, 0.5 * (m->edges[i].from + m->edges[i].to), &point));
    print_doubles(point.xyz, 3);
    print_doubles(point.gap, 2);
    end_line();
  }
  for (i = 1; i < m->info.faces; ++i) {
    hsp_map_pole pole;
    hsp_map_sight sight;
    print_status("pole", hsp_map_get_pole(m->map, i, &pole));
    print_doubles(pole.centre, 2);
    print_doubles(&pole.radius, 1);
    print_doubles(&pole.bound, 1);
    end_line();
    print_status("sight", hsp_map_pick(m->map, pole.centre[0], pole.centre[1], &sight));
    printf(" %" PRIu32 " %" PRIu32, sight.ball, sight.face);
    print_doubles(&sight.depth, 1);
    end_line();
  }
}

static void print_map(const computed *c, const hsp_view_options *options) {
  map_result m;
  const int32_t status = map_result_make(c, options, &m);
  print_status("map", status);
  printf(" %" PRIu32 " %" PRIu32 "\n", m.needed.neighbours, m.needed.edges);
  if (status == HSP_OK) {
    print_info("map of balls", &m.info);
    print_records(&m.info, m.vertices, m.edges, m.faces);
    print_answers(&m);
  }
  map_result_release(&m);
}

static void print_sticks(const computed *c, const hsp_view_options *options) {
  sticks_result s;
  const int32_t status = sticks_result_make(c, options, &s);
  print_status("sticks", status);
  printf(" %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", s.count, s.needed.pairs, s.needed.edges);
  if (status == HSP_OK) {
    printf("paths %" PRIu32 " %" PRIu32 " %" PRIu32, s.info.paths, s.info.balls, s.info.arcs);
    print_doubles(s.info.low, 2);
    print_doubles(s.info.high, 2);
    end_line();
    print_info("map of balls and sticks", &s.map);
    print_records(&s.map, s.vertices, s.edges, s.faces);
  }
  sticks_result_release(&s);
}

void print_maps(const computed *c) {
  hsp_view_options options;
  int32_t status = hsp_view_options_init(&options, (uint32_t)sizeof options);
  print_map(c, &options);
  if (status == HSP_OK) status = hsp_view_options_turn(&options, 25, -35, 10.5);
  print_status("turned", status);
  end_line();
  print_map(c, &options);
  if (c->n <= 100) print_sticks(c, &options);
}
