#include <inttypes.h>
#include <stdio.h>

#include "ball_sets.h"
#include "check.h"
#include "interface_bits.h"
#include "periodic_result.h"

enum { MOST_BLOCKS = 200000 };
static double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST], strain[9], box[9], block[9 * MOST_BLOCKS];
static uint32_t first[BALL_SET_MOST + 1], column[MOST_BLOCKS], flags[BALL_SET_MOST + 1];

static void print_image(const hsp_image *image) {
  printf(" %" PRIu32 " %" PRId32 " %" PRId32 " %" PRId32, image->ball, image->shift[0], image->shift[1],
         image->shift[2]);
}

static void print_id(const hsp_periodic_id *id) {
  printf(" %" PRIu32 " %" PRId32 " %" PRId32 " %" PRId32, id->id, id->shift[0], id->shift[1], id->shift[2]);
}

static void print_records(const periodic_result *p) {
  uint32_t i, k;
  for (i = 0; i < p->counts.vertices; ++i) {
    const hsp_periodic_vertex *vertex = &p->vertices[i];
    printf("periodic vertex %" PRId32, vertex->sign);
    print_numbers(&vertex->flags, 1);
    for (k = 0; k < 3; ++k) print_image(&vertex->image[k]);
    print_doubles(vertex->xyz, 3);
    end_line();
  }
  for (i = 0; i < p->counts.arcs; ++i) {
    const hsp_periodic_arc *arc = &p->arcs[i];
    printf("periodic arc");
    for (k = 0; k < 2; ++k) {
      print_image(&arc->image[k]);
      print_id(&arc->vertex[k]);
      print_id(&arc->face[k]);
    }
    print_doubles(arc->centre, 3);
    print_doubles(arc->axis, 3);
    print_doubles(&arc->radius, 1);
    print_doubles(&arc->angle, 1);
    end_line();
  }
  for (i = 0; i < p->counts.circles; ++i) {
    const hsp_periodic_circle *circle = &p->circles[i];
    printf("periodic circle");
    for (k = 0; k < 2; ++k) {
      print_image(&circle->image[k]);
      print_id(&circle->face[k]);
    }
    print_doubles(circle->centre, 3);
    print_doubles(&circle->radius, 1);
    end_line();
  }
}

static void print_gradient(const periodic_result *p) {
  print_doubles(centre, 3 * p->base->n);
  print_doubles(radius, p->base->n);
  print_doubles(strain, 9);
  print_doubles(box, 9);
  end_line();
}

static void print_second_derivatives(const periodic_result *p) {
  uint32_t needed = 0, i;
  print_status("periodic second derivatives",
               hsp_periodic_get_hessian_rows(
                   p->periodic, SIZED(hsp_gradient_request, .sigma = p->base->radius, .tension = 1, .pressure = -0.5),
                   first, column, block, flags, MOST_BLOCKS, &needed));
  print_numbers(first, p->base->n + 1);
  print_numbers(flags, p->base->n + 1);
  end_line();
  for (i = 0; i < needed && needed <= MOST_BLOCKS; ++i) {
    printf("block");
    print_numbers(&column[i], 1);
    print_doubles(block + 9 * (size_t)i, 9);
    end_line();
  }
}

static void print_periodic_results(const periodic_result *p) {
  const hsp_periodic_counts *n = &p->counts;
  hsp_morphometric_energy energy;
  uint32_t i;
  printf(" %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRId64, n->images,
         n->vertices, n->circles, n->loops, n->faces, n->shells, n->components, n->euler);
  print_doubles(&p->totals.area, 1);
  print_doubles(&p->totals.volume, 1);
  print_doubles(&p->totals.free_volume, 1);
  print_doubles(p->area, p->base->n);
  print_doubles(p->share_volume, p->base->n);
  end_line();
  for (i = 0; i < n->contacts; ++i) {
    const hsp_periodic_contact *contact = &p->contacts[i];
    printf("periodic contact %" PRId32 " %" PRId32 " %" PRId32, contact->shift[0], contact->shift[1],
           contact->shift[2]);
    print_numbers(contact->ball, 2);
    print_numbers(&contact->chords, 1);
    print_numbers(&contact->flags, 1);
    print_doubles(&contact->area, 1);
    print_doubles(&contact->rim, 1);
    print_doubles(&contact->distance, 1);
    end_line();
  }
  print_records(p);
  for (i = 0; i < n->components; ++i) {
    uint32_t k;
    printf("winding %" PRIu32 " %" PRIu32 " %" PRIu32, p->windings[i].first, p->windings[i].directions,
           p->windings[i].copies);
    for (k = 0; k < 9; ++k) printf(" %" PRId32, p->windings[i].row[k]);
    end_line();
  }
  print_status("periodic gradient",
               hsp_periodic_get_gradient(
                   p->periodic, SIZED(hsp_gradient_request, .sigma = p->base->radius, .tension = 1, .pressure = -0.5),
                   SIZED(hsp_periodic_gradient_outputs, .d_centre = centre, .d_radius = radius, .d_strain = strain,
                         .d_box = box, .capacity = p->base->n)));
  print_gradient(p);
  print_status("periodic morphometry",
               hsp_periodic_get_morphometry(
                   p->periodic,
                   SIZED(hsp_morphometry_request, .sigma = p->base->radius, .pressure = -0.5, .tension = 1,
                         .bending = 0.75, .gaussian = 2),
                   SIZED(hsp_periodic_morphometry_outputs, .energy = &energy, .d_centre = centre, .d_radius = radius,
                         .d_strain = strain, .d_box = box, .capacity = p->base->n)));
  print_doubles(&energy.value, 1);
  print_doubles(&energy.mean, 1);
  print_gradient(p);
  print_second_derivatives(p);
}

void print_periodic(const computed *c) {
  periodic_result p;
  int turned;
  for (turned = 0; turned < 2; ++turned) {
    const int32_t status = turned ? periodic_result_make_turned(c, &p) : periodic_result_make(c, &p);
    if (status == HSP_E_RANGE) {
      printf("no box is large enough\n");
    } else {
      print_status("periodic", status);
      if (status == HSP_OK) print_periodic_results(&p);
    }
    periodic_result_release(&p);
  }
}
