/* Size and offsets of every public struct, checked while compiling; included by a C99 and by a C++20 file. The numbers
 * are part of the binary interface: Fortran types and callers' compiled code rely on them. */
#ifndef HSP_TESTS_STRUCT_LAYOUT_H
#define HSP_TESTS_STRUCT_LAYOUT_H

#include <hardsphere.h>

/* C99 has no static assertion: an array of -1 elements is refused. */
#define LAYOUT_HOLDS(name, condition) typedef char layout_##name[(condition) ? 1 : -1]
#define LAYOUT_SIZE(type, size) LAYOUT_HOLDS(type##_size, sizeof(type) == (size))
#define LAYOUT_FIELD(type, field, offset, size) \
  LAYOUT_HOLDS(type##_##field, offsetof(type, field) == (offset) && sizeof(((type *)0)->field) == (size))

/* Each field begins where the one before it ends and the last ends with the struct: there is no padding. */
LAYOUT_SIZE(hsp_model_options, 24);
LAYOUT_FIELD(hsp_model_options, struct_size, 0, 4);
LAYOUT_FIELD(hsp_model_options, reserved, 4, 4);
LAYOUT_FIELD(hsp_model_options, probe, 8, 8);
LAYOUT_FIELD(hsp_model_options, step, 16, 8);

LAYOUT_SIZE(hsp_model_info, 40);
LAYOUT_FIELD(hsp_model_info, balls, 0, 4);
LAYOUT_FIELD(hsp_model_info, cubes, 4, 4);
LAYOUT_FIELD(hsp_model_info, table_slots, 8, 4);
LAYOUT_FIELD(hsp_model_info, longest_probe, 12, 4);
LAYOUT_FIELD(hsp_model_info, step, 16, 8);
LAYOUT_FIELD(hsp_model_info, probe, 24, 8);
LAYOUT_FIELD(hsp_model_info, largest_radius, 32, 8);

LAYOUT_SIZE(hsp_figures, 40);
LAYOUT_FIELD(hsp_figures, k, 0, 8);
LAYOUT_FIELD(hsp_figures, rho, 8, 8);
LAYOUT_FIELD(hsp_figures, mean_overlaps, 16, 8);
LAYOUT_FIELD(hsp_figures, neighbour_bound, 24, 8);
LAYOUT_FIELD(hsp_figures, max_overlaps, 32, 4);
LAYOUT_FIELD(hsp_figures, flags, 36, 4);

LAYOUT_SIZE(hsp_boundary_limits, 24);
LAYOUT_FIELD(hsp_boundary_limits, struct_size, 0, 4);
LAYOUT_FIELD(hsp_boundary_limits, balls, 4, 4);
LAYOUT_FIELD(hsp_boundary_limits, neighbours, 8, 4);
LAYOUT_FIELD(hsp_boundary_limits, vertices, 12, 4);
LAYOUT_FIELD(hsp_boundary_limits, circles, 16, 4);
LAYOUT_FIELD(hsp_boundary_limits, reserved, 20, 4);

LAYOUT_SIZE(hsp_boundary_counts, 56);
LAYOUT_FIELD(hsp_boundary_counts, balls, 0, 4);
LAYOUT_FIELD(hsp_boundary_counts, exposed_balls, 4, 4);
LAYOUT_FIELD(hsp_boundary_counts, contained_balls, 8, 4);
LAYOUT_FIELD(hsp_boundary_counts, vertices, 12, 4);
LAYOUT_FIELD(hsp_boundary_counts, arcs, 16, 4);
LAYOUT_FIELD(hsp_boundary_counts, circles, 20, 4);
LAYOUT_FIELD(hsp_boundary_counts, faces, 24, 4);
LAYOUT_FIELD(hsp_boundary_counts, loops, 28, 4);
LAYOUT_FIELD(hsp_boundary_counts, shells, 32, 4);
LAYOUT_FIELD(hsp_boundary_counts, components, 36, 4);
LAYOUT_FIELD(hsp_boundary_counts, voids, 40, 4);
LAYOUT_FIELD(hsp_boundary_counts, tied_vertices, 44, 4);
LAYOUT_FIELD(hsp_boundary_counts, euler, 48, 8);

LAYOUT_SIZE(hsp_vertex, 48);
LAYOUT_FIELD(hsp_vertex, xyz, 0, 24);
LAYOUT_FIELD(hsp_vertex, ball, 24, 12);
LAYOUT_FIELD(hsp_vertex, sign, 36, 4);
LAYOUT_FIELD(hsp_vertex, flags, 40, 4);
LAYOUT_FIELD(hsp_vertex, reserved, 44, 4);

LAYOUT_SIZE(hsp_arc, 32);
LAYOUT_FIELD(hsp_arc, ball, 0, 8);
LAYOUT_FIELD(hsp_arc, vertex, 8, 8);
LAYOUT_FIELD(hsp_arc, face, 16, 8);
LAYOUT_FIELD(hsp_arc, angle, 24, 8);

LAYOUT_SIZE(hsp_circle, 72);
LAYOUT_FIELD(hsp_circle, centre, 0, 24);
LAYOUT_FIELD(hsp_circle, axis, 24, 24);
LAYOUT_FIELD(hsp_circle, radius, 48, 8);
LAYOUT_FIELD(hsp_circle, ball, 56, 8);
LAYOUT_FIELD(hsp_circle, face, 64, 8);

LAYOUT_SIZE(hsp_face, 16);
LAYOUT_FIELD(hsp_face, ball, 0, 4);
LAYOUT_FIELD(hsp_face, loops, 4, 4);
LAYOUT_FIELD(hsp_face, shell, 8, 4);
LAYOUT_FIELD(hsp_face, reserved, 12, 4);

LAYOUT_SIZE(hsp_ball, 16);
LAYOUT_FIELD(hsp_ball, faces, 0, 4);
LAYOUT_FIELD(hsp_ball, first_face, 4, 4);
LAYOUT_FIELD(hsp_ball, component, 8, 4);
LAYOUT_FIELD(hsp_ball, flags, 12, 4);

LAYOUT_SIZE(hsp_totals, 16);
LAYOUT_FIELD(hsp_totals, area, 0, 8);
LAYOUT_FIELD(hsp_totals, volume, 8, 8);

/* The size macros are constant expressions of type size_t, and preprocessor conditions may use the version. */
LAYOUT_HOLDS(model_bytes, HSP_MODEL_BYTES(1000) > 0 && sizeof(HSP_MODEL_BYTES(1)) == sizeof(size_t));
LAYOUT_HOLDS(boundary_bytes,
             HSP_BOUNDARY_BYTES(10, 9, 8, 7) > 0 && sizeof(HSP_BOUNDARY_BYTES(1, 1, 1, 1)) == sizeof(size_t));
#if HSP_VERSION_NUMBER < 1
#error "HSP_VERSION_NUMBER is not a number that the preprocessor can compare"
#endif

#endif
