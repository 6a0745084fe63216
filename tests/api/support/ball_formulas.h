/* Areas and volumes in closed form. A sphere cut by planes at distances h < r from its centre keeps what inclusion and
 * exclusion over its caps leaves; the area of an intersection of caps follows from the Gauss-Bonnet theorem, its volume
 * from the divergence theorem. In a grid of equal balls the planes are those half-way between neighbours. */
#pragma once

typedef struct amount {
  double area, volume;
} amount;

void amount_add(amount *to, double times, amount what);

amount amount_of_ball(double r);

/* The cap beyond a plane at distance h < r, and its part of the sphere. */
amount amount_of_cap(double r, double h);

/* The part of a ball beyond two planes at distances h[0], h[1] whose normals make an angle psi. */
amount amount_of_double_cap(double r, const double h[2], double psi);

/* The union of two balls whose centres are d apart, neither inside the other. */
amount amount_of_two_balls(double r, double s, double d);

/* The union of a full grid of equal balls that overlap along every axis. */
amount amount_of_grid(const int counts[3], const double spacing[3], double r);
