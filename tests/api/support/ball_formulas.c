#include "ball_formulas.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

amount amount_of_ball(double r) {
  amount a;
  a.area = 4 * pi * r * r;
  a.volume = a.area * r / 3;
  return a;
}

/* The cap of a ball of radius r beyond a plane at distance h from its centre: Archimedes. */
amount amount_of_cap(double r, double h) {
  amount a;
  a.area = 2 * pi * r * (r - h);
  a.volume = pi * (r - h) * (r - h) * (2 * r + h) / 3;
  return a;
}

/* Two balls whose centres are d apart, neither inside the other. */
amount amount_of_two_balls(double r, double s, double d) {
  const double h = (d * d + r * r - s * s) / (2 * d);
  const amount a = amount_of_ball(r), b = amount_of_ball(s), c = amount_of_cap(r, h), e = amount_of_cap(s, d - h);
  amount both;
  both.area = a.area + b.area - c.area - e.area;
  both.volume = a.volume + b.volume - c.volume - e.volume;
  return both;
}

/* The part of a ball beyond two planes at distances h[0], h[1] whose normals make an angle psi; 0 if they do not meet
 * inside. An arc on plane i turns by cos(polar angle) times its angle 2 phi_i; theta is the exterior angle. */
amount amount_of_double_cap(double r, const double h[2], double psi) {
  amount a = {0, 0};
  double phi[2], rho[2], flat = 0, arcs = 0, theta;
  int i;
  for (i = 0; i < 2; ++i) {
    const double mine = h[i] / r, other = h[1 - i] / r;
    double cosine;
    rho[i] = sqrt(1 - mine * mine);
    cosine = (other - mine * cos(psi)) / (rho[i] * sin(psi));
    if (cosine >= 1) return a;
    phi[i] = acos(cosine);
    arcs += mine * 2 * phi[i];
    flat += mine * rho[i] * rho[i] * (phi[i] - sin(phi[i]) * cos(phi[i]));
  }
  theta = acos((cos(psi) - h[0] * h[1] / (r * r)) / (rho[0] * rho[1]));
  a.area = r * r * (2 * pi - arcs - 2 * theta);
  a.volume = r * r * r * (a.area / (r * r) - flat) / 3;
  return a;
}

/* The part beyond three mutually perpendicular planes; 0 if their common point is not inside. */
static amount amount_of_corner(double r, const double h[3]) {
  amount a = {0, 0};
  double area = 2 * pi, flat = 0;
  int i;
  if (h[0] * h[0] + h[1] * h[1] + h[2] * h[2] >= r * r) return a;
  for (i = 0; i < 3; ++i) {
    const double mine = h[i] / r, u = h[(i + 1) % 3] / r, v = h[(i + 2) % 3] / r;
    const double rho = sqrt(1 - mine * mine), next = sqrt(1 - u * u);
    const double turn = acos(u / rho) - asin(v / rho); /* on circle i, from v at its plane to u at its plane */
    area -= mine * turn + acos(-mine * u / (rho * next));
    /* sector less the two triangles between the origin, (u, v) and an end of the arc */
    flat += mine * (rho * rho * turn - v * (sqrt(rho * rho - v * v) - u) - u * (sqrt(rho * rho - u * u) - v)) / 2;
  }
  a.area = r * r * area;
  a.volume = r * r * r * (area - flat) / 3;
  return a;
}

void amount_add(amount *to, double times, amount what) {
  to->area += times * what.area;
  to->volume += times * what.volume;
}

/* The union of a full grid of equal balls that overlap along every axis. */
amount amount_of_grid(const int counts[3], const double spacing[3], double r) {
  amount all = {0, 0};
  double h[3];
  int x, y, z, i;
  for (i = 0; i < 3; ++i) h[i] = spacing[i] / 2;
  for (x = 0; x < counts[0]; ++x) {
    for (y = 0; y < counts[1]; ++y) {
      for (z = 0; z < counts[2]; ++z) {
        double sides[3]; /* how many of the two planes across each axis cut this ball */
        sides[0] = (x > 0) + (x + 1 < counts[0]);
        sides[1] = (y > 0) + (y + 1 < counts[1]);
        sides[2] = (z > 0) + (z + 1 < counts[2]);
        amount_add(&all, 1, amount_of_ball(r));
        for (i = 0; i < 3; ++i) {
          double pair[2];
          pair[0] = h[i];
          pair[1] = h[(i + 1) % 3];
          if (h[i] < r) amount_add(&all, -sides[i], amount_of_cap(r, h[i]));
          amount_add(&all, sides[i] * sides[(i + 1) % 3], amount_of_double_cap(r, pair, pi / 2));
        }
        amount_add(&all, -sides[0] * sides[1] * sides[2], amount_of_corner(r, h));
      }
    }
  }
  return all;
}
