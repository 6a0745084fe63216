#include <inttypes.h>
#include <stdio.h>

#include "ball_sets.h"
#include "check.h"
#include "interface_bits.h"

static double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST], sigma[BALL_SET_MOST];
static double area[8 * BALL_SET_MOST], volume[8 * BALL_SET_MOST];
static uint32_t flags[BALL_SET_MOST];
static uint8_t selected[BALL_SET_MOST];

static void print_parts(const computed *c) {
  hsp_totals totals = {0};
  uint32_t i;
  for (i = 0; i < c->n; ++i) selected[i] = i % 3 == 0;
  print_status("selected", hsp_boundary_measure(c->boundary, selected, &totals, area, volume, c->n, NULL));
  print_doubles(&totals.area, 1);
  print_doubles(&totals.volume, 1);
  print_doubles(area, c->n);
  print_doubles(volume, c->n);
  end_line();
  print_status("faces", hsp_boundary_measure_faces(c->boundary, area, volume, 8 * BALL_SET_MOST, NULL));
  print_doubles(area, c->counts.faces);
  print_doubles(volume, c->counts.faces);
  end_line();
}

static void print_energy(const computed *c, double tension, double pressure, uint32_t tangency) {
  hsp_energy energy = {0};
  uint32_t i;
  print_status("energy", hsp_boundary_get_gradient(c->boundary,
                                                   SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension,
                                                         .pressure = pressure, .tangency = tangency),
                                                   SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = centre,
                                                         .d_radius = radius, .flags = flags, .capacity = c->n)));
  print_doubles(&energy.value, 1);
  print_doubles(&energy.area, 1);
  print_doubles(&energy.volume, 1);
  print_doubles(&energy.d_probe, 1);
  end_line();
  for (i = 0; i < c->n; ++i) {
    printf("gradient %" PRIu32, flags[i]);
    print_doubles(&centre[3 * i], 3);
    print_doubles(&radius[i], 1);
    end_line();
  }
}

static void print_row(const computed *c, uint32_t ball, uint32_t tangency) {
  static hsp_area_derivative row[BALL_SET_MOST];
  uint32_t i, count = 0;
  print_status("row", hsp_boundary_get_area_row(c->boundary, ball, tangency, row, BALL_SET_MOST, &count));
  end_line();
  for (i = 0; i < count; ++i) {
    printf("derivative %" PRIu32 " %" PRIu32, row[i].ball, row[i].flags);
    print_doubles(row[i].centre, 3);
    print_doubles(&row[i].radius, 1);
    print_doubles(&row[i].angle, 1);
    end_line();
  }
}

void print_gradients(const computed *c) {
  static const uint32_t tangencies[] = {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT};
  uint32_t i, t;
  for (i = 0; i < c->n; ++i) sigma[i] = 0.125 * (double)(i % 7) - 0.25;
  print_parts(c);
  for (t = 0; t < 2; ++t) {
    print_energy(c, 1.0, 0.0, tangencies[t]);
    print_energy(c, 0.0625, -0.375, tangencies[t]);
    for (i = 0; i < c->n; i += 5) print_row(c, i, tangencies[t]);
  }
}
