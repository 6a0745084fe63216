/* Widths of contours and shares of fog beside a picture, against the powers of the header, by pow. */
#include <math.h>

#include <hardsphere.h>

#include "check.h"

static void widths(void) {
  int k;
  double before = -1;
  for (k = 0; k <= 400; ++k) {
    const double gap = k * 0.01, expected = 2.5 * (gap < 3 ? pow(gap / 3, 0.625) : 1);
    double width = -1;
    CHECK_EQUAL(hsp_picture_ink_width(2.5, gap, &width), HSP_OK);
    CHECK_NEAR(width, expected, 1e-14);
    CHECK(width >= before);
    before = width;
  }
  CHECK_EQUAL(hsp_picture_ink_width(0, 1e300, &before), HSP_OK);
  CHECK(before == 0);
}

static void fog(void) {
  int k;
  for (k = -50; k <= 250; ++k) {
    const double depth = 7 - k * 0.1;
    double share = -1, way = k * 0.1 / 20; /* from 7 to -13 */
    CHECK_EQUAL(hsp_picture_fog_share(7, -13, 1.5, depth, &share), HSP_OK);
    CHECK_NEAR(share, way <= 0 ? 0 : way < 1 ? pow(way, 1.25) : 1, 1e-14);
    /* Balls in a plane have it within five of their radii. */
    way = k * 0.1 / 7.5;
    CHECK_EQUAL(hsp_picture_fog_share(7, 7, 1.5, depth, &share), HSP_OK);
    CHECK_NEAR(share, way <= 0 ? 0 : way < 1 ? pow(way, 1.25) : 1, 1e-14);
    /* Points in a plane have none. */
    CHECK_EQUAL(hsp_picture_fog_share(7, 7, 0, depth, &share), HSP_OK);
    CHECK(share == 0);
  }
}

static void arguments(void) {
  double out = 5;
  CHECK_EQUAL(hsp_picture_ink_width(1, 1, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_picture_ink_width(NAN, 1, &out), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_picture_ink_width(1, INFINITY, &out), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_picture_ink_width(-1, 1, &out), HSP_E_RANGE);
  CHECK_EQUAL(hsp_picture_ink_width(1, -1, &out), HSP_E_RANGE);
  CHECK_EQUAL(hsp_picture_fog_share(1, 0, 1, 0.5, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_picture_fog_share(1, 0, 1, -INFINITY, &out), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_picture_fog_share(1, 0, -1, 0.5, &out), HSP_E_RANGE);
  CHECK(out == 5);
}

int main(void) {
  widths();
  fog();
  arguments();
  return check_report();
}
