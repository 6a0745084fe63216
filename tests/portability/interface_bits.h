/* Parts of the program interface_bits: what it prints of one set of balls. */
#pragma once

#include "computed.h"

/* Append to the line: doubles as 16 hexadecimal digits of their bits, numbers as they are. */
void print_doubles(const double *value, uint32_t count);
void print_numbers(const uint32_t *number, uint32_t count);
void end_line(void);

/* Begins a line with what was asked for and the status it ended with. */
void print_status(const char *what, int32_t status);
/* Whether every status was HSP_OK. */
int all_succeeded(void);

/* Areas and volumes of selected balls and of faces, energies, gradients, rows of the area's Jacobian. */
void print_gradients(const computed *c);

/* Vertices, edges, simple faces, shells, components, cells and scans. */
void print_topology(const computed *c);

/* The same balls in a periodic box: counts, areas, cells, contacts, records, windings, a gradient and the strain's. */
void print_periodic(const computed *c);

/* Pieces, loops and arcs of several views; bytes of pictures as hashes; colours. */
void print_views(const computed *c);

/* Maps of balls from two directions with what they answer, and of balls and sticks. */
void print_maps(const computed *c);
