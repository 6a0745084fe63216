#include <inttypes.h>
#include <stdio.h>

#include "ball_sets.h"
#include "interface_bits.h"
#include "periodic_result.h"

static double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST], strain[9], box[9];

static void print_periodic_results(const periodic_result *p) {
  const hsp_periodic_counts *n = &p->counts;
  uint32_t i;
  printf(" %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRId32, n->images,
         n->vertices, n->circles, n->loops, n->faces, n->shells, n->components, n->euler);
  print_doubles(&p->totals.area, 1);
  print_doubles(&p->totals.volume, 1);
  print_doubles(&p->totals.free_volume, 1);
  print_doubles(p->area, p->base->n);
  print_doubles(p->cell_volume, p->base->n);
  end_line();
  for (i = 0; i < n->contacts; ++i) {
    const hsp_periodic_contact *contact = &p->contacts[i];
    printf("periodic contact %" PRId32 " %" PRId32 " %" PRId32, contact->shift[0], contact->shift[1],
           contact->shift[2]);
    print_numbers(contact->ball, 2);
    print_numbers(&contact->chords, 1);
    print_numbers(&contact->flags, 1);
    print_doubles(&contact->area, 1);
    print_doubles(&contact->edge, 1);
    print_doubles(&contact->distance, 1);
    end_line();
  }
  for (i = 0; i < n->components; ++i) {
    uint32_t k;
    printf("winding %" PRIu32 " %" PRIu32 " %" PRIu32, p->windings[i].first, p->windings[i].directions,
           p->windings[i].copies);
    for (k = 0; k < 9; ++k) printf(" %" PRId32, p->windings[i].row[k]);
    end_line();
  }
  print_status("periodic gradient",
               hsp_periodic_gradient(p->periodic, p->base->radius, 1, -0.5, HSP_TANGENT_OVERLAP, NULL, centre, radius,
                                     NULL, strain, box, p->base->n, NULL, NULL));
  print_doubles(centre, 3 * p->base->n);
  print_doubles(radius, p->base->n);
  print_doubles(strain, 9);
  print_doubles(box, 9);
  end_line();
}

void print_periodic(const computed *c) {
  periodic_result p;
  const int32_t status = periodic_result_make(c, &p);
  if (status == HSP_E_RANGE) {
    printf("no box is large enough\n");
  } else {
    print_status("periodic", status);
    if (status == HSP_OK) print_periodic_results(&p);
  }
  periodic_result_release(&p);
}
