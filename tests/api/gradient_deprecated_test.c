/* Old names, which deprecated.h has: the same bits and statuses as the new calls, and needed and first_bad where the
 * old functions wrote them. */
#define HSP_NO_DEPRECATION_WARNINGS
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "computed.h"
#include "gradients.h"
#include "periodic_result.h"

/* Outputs of an old call and of the new one. */
typedef struct outputs {
  hsp_energy energy;
  hsp_morphometric_energy morphometric;
  double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST], more_centre[3 * BALL_SET_MOST], more_radius[BALL_SET_MOST];
  double strain[9], box[9];
  uint32_t flags[BALL_SET_MOST], needed, first_bad;
} outputs;

static outputs old, new;
static double sigma[BALL_SET_MOST];

/* Weights for every call: none, numbers, and one that is none; and a capacity that suffices or does not. */
enum { WAYS = 4 };
typedef struct question {
  const double *sigma;
  uint32_t tangency, capacity;
} question;

static question question_of(int way, uint32_t n) {
  question q = {NULL, HSP_TANGENT_OVERLAP, n};
  uint32_t i;
  for (i = 0; i < n; ++i) sigma[i] = 0.5 * i - 1;
  if (way > 0) q.sigma = sigma;
  if (way == 1) q.tangency = HSP_TANGENT_DISJOINT;
  if (way == 2 && n > 0) sigma[n - 1] = NAN;
  if (way == 3 && n > 0) q.capacity = n - 1;
  memset(&old, 0x5A, sizeof old);
  memset(&new, 0x5A, sizeof new);
  return q;
}

/* Status of an old function, and the outputs that it reached. */
static void hand_back(int32_t status, uint32_t needed, uint32_t first_bad) {
  new.needed = needed;
  if (status != HSP_E_CAPACITY) new.first_bad = first_bad;
}

static void same(int32_t was, int32_t is, const char *name) {
  check_scene("%s", name);
  CHECK_EQUAL(was, is);
  CHECK_BYTES(&old, &new, sizeof old);
}

static void of_boundary(const hsp_boundary *b, const question *q) {
  const question x = *q;
  hsp_gradient_outputs g = {sizeof g, x.capacity, 12345, 12345, &new.energy, new.centre, new.radius, new.flags, NULL};
  hsp_derivatives_outputs d = {sizeof d,   x.capacity,      12345,           12345,    new.centre,
                               new.radius, new.more_centre, new.more_radius, new.flags};
  hsp_morphometry_outputs m = {sizeof m,          x.capacity, 12345,      12345,
                               &new.morphometric, new.centre, new.radius, new.flags};
  const hsp_morphometry factors = {-0.5, 1.5, 0.75, 2};
  int32_t status = hsp_boundary_get_gradient(
      b, SIZED(hsp_gradient_request, .tangency = x.tangency, .tension = 2, .pressure = -0.5, .sigma = x.sigma), &g);
  hand_back(status, g.needed, g.first_bad);
  same(hsp_boundary_gradient(b, x.sigma, 2, -0.5, x.tangency, &old.energy, old.centre, old.radius, old.flags,
                             x.capacity, &old.needed, &old.first_bad),
       status, "hsp_boundary_gradient");
  status =
      hsp_boundary_get_derivatives(b, SIZED(hsp_derivatives_request, .tangency = x.tangency, .sigma = x.sigma), &d);
  hand_back(status, d.needed, d.first_bad);
  same(hsp_boundary_derivatives(b, x.sigma, x.tangency, old.centre, old.radius, old.more_centre, old.more_radius,
                                old.flags, x.capacity, &old.needed, &old.first_bad),
       status, "hsp_boundary_derivatives");
  status = hsp_boundary_get_morphometry(b,
                                        SIZED(hsp_morphometry_request, .pressure = -0.5, .tension = 1.5,
                                              .bending = 0.75, .gaussian = 2, .sigma = x.sigma),
                                        &m);
  hand_back(status, m.needed, m.first_bad);
  same(hsp_boundary_morphometry(b, x.sigma, &factors, &old.morphometric, old.centre, old.radius, old.flags, x.capacity,
                                &old.needed, &old.first_bad),
       status, "hsp_boundary_morphometry");
}

static void of_box(const hsp_periodic *p, const question *q) {
  const question x = *q;
  hsp_periodic_gradient_outputs g = {sizeof g,   x.capacity, 12345,      12345,   &new.energy, new.centre,
                                     new.radius, new.flags,  new.strain, new.box, NULL};
  hsp_periodic_morphometry_outputs m = {sizeof m,   x.capacity, 12345,     12345,      &new.morphometric,
                                        new.centre, new.radius, new.flags, new.strain, new.box};
  const hsp_morphometry factors = {-0.5, 1.5, 0.75, 2};
  int32_t status = hsp_periodic_get_gradient(
      p, SIZED(hsp_gradient_request, .tangency = x.tangency, .tension = 2, .pressure = -0.5, .sigma = x.sigma), &g);
  hand_back(status, g.needed, g.first_bad);
  same(hsp_periodic_gradient(p, x.sigma, 2, -0.5, x.tangency, &old.energy, old.centre, old.radius, old.flags,
                             old.strain, old.box, x.capacity, &old.needed, &old.first_bad),
       status, "hsp_periodic_gradient");
  status = hsp_periodic_get_morphometry(p,
                                        SIZED(hsp_morphometry_request, .pressure = -0.5, .tension = 1.5,
                                              .bending = 0.75, .gaussian = 2, .sigma = x.sigma),
                                        &m);
  hand_back(status, m.needed, m.first_bad);
  same(hsp_periodic_morphometry(p, x.sigma, &factors, &old.morphometric, old.centre, old.radius, old.flags, old.strain,
                                old.box, x.capacity, &old.needed, &old.first_bad),
       status, "hsp_periodic_morphometry");
}

/* Where nothing can be read nothing is written, and what may be NULL is. */
static void refused(const computed *c) {
  uint32_t needed = 7, first_bad = 7;
  hsp_energy energy;
  check_scene("refusals");
  CHECK_EQUAL(hsp_boundary_gradient(NULL, NULL, 1, 0, 0, NULL, NULL, NULL, NULL, 0, &needed, &first_bad),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_gradient(c->boundary, NULL, 1, 0, 2, NULL, NULL, NULL, NULL, 0, &needed, &first_bad),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_derivatives(c->boundary, NULL, 2, NULL, NULL, NULL, NULL, NULL, 0, &needed, &first_bad),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_boundary_morphometry(c->boundary, NULL, NULL, NULL, NULL, NULL, NULL, 0, &needed, &first_bad),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_morphometry(NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0, &needed, &first_bad),
              HSP_E_ARGUMENT);
  CHECK(needed == 7 && first_bad == 7);
  CHECK_EQUAL(hsp_boundary_gradient(c->boundary, NULL, 1, 0, 0, &energy, NULL, NULL, NULL, 0, NULL, NULL), HSP_OK);
}

int main(void) {
  static ball_set set;
  uint32_t which;
  int way;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      periodic_result p;
      const int32_t in_box = periodic_result_make(&c, &p);
      for (way = 0; way < WAYS; ++way) {
        const question q = question_of(way, set.n);
        of_boundary(c.boundary, &q);
        if (in_box == HSP_OK) of_box(p.periodic, &q);
      }
      refused(&c);
      periodic_result_release(&p);
    }
    computed_release(&c);
  }
  return check_report();
}
