/* Of vectors in space. */
#ifndef HARDSPHERE_TOOL_DOT_PRODUCT_H
#define HARDSPHERE_TOOL_DOT_PRODUCT_H

static inline double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

#endif
