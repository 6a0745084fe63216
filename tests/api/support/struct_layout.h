/* Size and offsets of every public struct, checked while compiling; included by a C99 and by a C++20 file. The numbers
 * are part of the binary interface: Fortran types and callers' compiled code rely on them. */
#pragma once

#include <hardsphere.h>

/* C99 has no static assertion: an array of -1 elements is refused. */
#define LAYOUT_HOLDS(name, condition) typedef char layout_##name[(condition) ? 1 : -1]
#define LAYOUT_SIZE(type, size) LAYOUT_HOLDS(type##_size, sizeof(type) == (size))
#define LAYOUT_FIELD(type, field, offset, size) \
  LAYOUT_HOLDS(type##_##field, offsetof(type, field) == (offset) && sizeof(((type *)0)->field) == (size))

/* Each field begins where the one before it ends and the last ends with the struct: there is no padding. */
LAYOUT_SIZE(hsp_model_options, 32);
LAYOUT_FIELD(hsp_model_options, struct_size, 0, 4);
LAYOUT_FIELD(hsp_model_options, reserved, 4, 4);
LAYOUT_FIELD(hsp_model_options, probe, 8, 8);
LAYOUT_FIELD(hsp_model_options, step, 16, 8);
LAYOUT_FIELD(hsp_model_options, largest_radius, 24, 8);

LAYOUT_SIZE(hsp_model_info, 40);
LAYOUT_FIELD(hsp_model_info, balls, 0, 4);
LAYOUT_FIELD(hsp_model_info, cubes, 4, 4);
LAYOUT_FIELD(hsp_model_info, table_slots, 8, 4);
LAYOUT_FIELD(hsp_model_info, longest_probe, 12, 4);
LAYOUT_FIELD(hsp_model_info, step, 16, 8);
LAYOUT_FIELD(hsp_model_info, probe, 24, 8);
LAYOUT_FIELD(hsp_model_info, largest_radius, 32, 8);

LAYOUT_SIZE(hsp_packing, 40);
LAYOUT_FIELD(hsp_packing, k, 0, 8);
LAYOUT_FIELD(hsp_packing, rho, 8, 8);
LAYOUT_FIELD(hsp_packing, mean_overlaps, 16, 8);
LAYOUT_FIELD(hsp_packing, neighbour_bound, 24, 8);
LAYOUT_FIELD(hsp_packing, max_overlaps, 32, 4);
LAYOUT_FIELD(hsp_packing, flags, 36, 4);

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

LAYOUT_SIZE(hsp_arc, 88);
LAYOUT_FIELD(hsp_arc, centre, 0, 24);
LAYOUT_FIELD(hsp_arc, axis, 24, 24);
LAYOUT_FIELD(hsp_arc, radius, 48, 8);
LAYOUT_FIELD(hsp_arc, angle, 56, 8);
LAYOUT_FIELD(hsp_arc, ball, 64, 8);
LAYOUT_FIELD(hsp_arc, vertex, 72, 8);
LAYOUT_FIELD(hsp_arc, face, 80, 8);

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
LAYOUT_FIELD(hsp_face, first_loop, 12, 4);

LAYOUT_SIZE(hsp_loop, 20);
LAYOUT_FIELD(hsp_loop, face, 0, 4);
LAYOUT_FIELD(hsp_loop, circle, 4, 4);
LAYOUT_FIELD(hsp_loop, side, 8, 4);
LAYOUT_FIELD(hsp_loop, first_arc, 12, 4);
LAYOUT_FIELD(hsp_loop, arcs, 16, 4);

LAYOUT_SIZE(hsp_loop_arc, 12);
LAYOUT_FIELD(hsp_loop_arc, arc, 0, 4);
LAYOUT_FIELD(hsp_loop_arc, side, 4, 4);
LAYOUT_FIELD(hsp_loop_arc, vertex, 8, 4);

LAYOUT_SIZE(hsp_ball, 16);
LAYOUT_FIELD(hsp_ball, faces, 0, 4);
LAYOUT_FIELD(hsp_ball, first_face, 4, 4);
LAYOUT_FIELD(hsp_ball, component, 8, 4);
LAYOUT_FIELD(hsp_ball, flags, 12, 4);

LAYOUT_SIZE(hsp_totals, 16);
LAYOUT_FIELD(hsp_totals, area, 0, 8);
LAYOUT_FIELD(hsp_totals, volume, 8, 8);

LAYOUT_SIZE(hsp_energy, 32);
LAYOUT_FIELD(hsp_energy, value, 0, 8);
LAYOUT_FIELD(hsp_energy, area, 8, 8);
LAYOUT_FIELD(hsp_energy, volume, 16, 8);
LAYOUT_FIELD(hsp_energy, probe, 24, 8);

LAYOUT_SIZE(hsp_area_derivative, 48);
LAYOUT_FIELD(hsp_area_derivative, centre, 0, 24);
LAYOUT_FIELD(hsp_area_derivative, radius, 24, 8);
LAYOUT_FIELD(hsp_area_derivative, angle, 32, 8);
LAYOUT_FIELD(hsp_area_derivative, ball, 40, 4);
LAYOUT_FIELD(hsp_area_derivative, flags, 44, 4);

LAYOUT_SIZE(hsp_topology_limits, 24);
LAYOUT_FIELD(hsp_topology_limits, struct_size, 0, 4);
LAYOUT_FIELD(hsp_topology_limits, balls, 4, 4);
LAYOUT_FIELD(hsp_topology_limits, neighbours, 8, 4);
LAYOUT_FIELD(hsp_topology_limits, edges, 12, 4);
LAYOUT_FIELD(hsp_topology_limits, cut_arcs, 16, 4);
LAYOUT_FIELD(hsp_topology_limits, reserved, 20, 4);

LAYOUT_SIZE(hsp_topology_counts, 32);
LAYOUT_FIELD(hsp_topology_counts, vertices, 0, 4);
LAYOUT_FIELD(hsp_topology_counts, edges, 4, 4);
LAYOUT_FIELD(hsp_topology_counts, simple_faces, 8, 4);
LAYOUT_FIELD(hsp_topology_counts, cut_edges, 12, 4);
LAYOUT_FIELD(hsp_topology_counts, shells, 16, 4);
LAYOUT_FIELD(hsp_topology_counts, components, 20, 4);
LAYOUT_FIELD(hsp_topology_counts, cells, 24, 4);
LAYOUT_FIELD(hsp_topology_counts, start_face, 28, 4);

LAYOUT_SIZE(hsp_topology_vertex, 48);
LAYOUT_FIELD(hsp_topology_vertex, xyz, 0, 24);
LAYOUT_FIELD(hsp_topology_vertex, ball, 24, 12);
LAYOUT_FIELD(hsp_topology_vertex, kind, 36, 4);
LAYOUT_FIELD(hsp_topology_vertex, q, 40, 4);
LAYOUT_FIELD(hsp_topology_vertex, reserved, 44, 4);

LAYOUT_SIZE(hsp_topology_edge, 96);
LAYOUT_FIELD(hsp_topology_edge, centre, 0, 24);
LAYOUT_FIELD(hsp_topology_edge, axis, 24, 24);
LAYOUT_FIELD(hsp_topology_edge, radius, 48, 8);
LAYOUT_FIELD(hsp_topology_edge, angle, 56, 8);
LAYOUT_FIELD(hsp_topology_edge, vertex, 64, 8);
LAYOUT_FIELD(hsp_topology_edge, face, 72, 8);
LAYOUT_FIELD(hsp_topology_edge, ball, 80, 8);
LAYOUT_FIELD(hsp_topology_edge, kind, 88, 4);
LAYOUT_FIELD(hsp_topology_edge, source, 92, 4);

LAYOUT_SIZE(hsp_simple_face, 24);
LAYOUT_FIELD(hsp_simple_face, ball, 0, 4);
LAYOUT_FIELD(hsp_simple_face, face, 4, 4);
LAYOUT_FIELD(hsp_simple_face, edges, 8, 4);
LAYOUT_FIELD(hsp_simple_face, q, 12, 4);
LAYOUT_FIELD(hsp_simple_face, shell, 16, 4);
LAYOUT_FIELD(hsp_simple_face, reserved, 20, 4);

LAYOUT_SIZE(hsp_shell, 80);
LAYOUT_FIELD(hsp_shell, area, 0, 8);
LAYOUT_FIELD(hsp_shell, volume, 8, 8);
LAYOUT_FIELD(hsp_shell, point, 16, 24);
LAYOUT_FIELD(hsp_shell, euler, 40, 4);
LAYOUT_FIELD(hsp_shell, genus, 44, 4);
LAYOUT_FIELD(hsp_shell, kind, 48, 4);
LAYOUT_FIELD(hsp_shell, component, 52, 4);
LAYOUT_FIELD(hsp_shell, cell, 56, 4);
LAYOUT_FIELD(hsp_shell, faces, 60, 4);
LAYOUT_FIELD(hsp_shell, simple_faces, 64, 4);
LAYOUT_FIELD(hsp_shell, edges, 68, 4);
LAYOUT_FIELD(hsp_shell, vertices, 72, 4);
LAYOUT_FIELD(hsp_shell, start_face, 76, 4);

LAYOUT_SIZE(hsp_component, 24);
LAYOUT_FIELD(hsp_component, balls, 0, 4);
LAYOUT_FIELD(hsp_component, top_ball, 4, 4);
LAYOUT_FIELD(hsp_component, outer_shell, 8, 4);
LAYOUT_FIELD(hsp_component, shells, 12, 4);
LAYOUT_FIELD(hsp_component, cell, 16, 4);
LAYOUT_FIELD(hsp_component, reserved, 20, 4);

LAYOUT_SIZE(hsp_cell, 32);
LAYOUT_FIELD(hsp_cell, area, 0, 8);
LAYOUT_FIELD(hsp_cell, volume, 8, 8);
LAYOUT_FIELD(hsp_cell, enclosing_shell, 16, 4);
LAYOUT_FIELD(hsp_cell, components, 20, 4);
LAYOUT_FIELD(hsp_cell, shells, 24, 4);
LAYOUT_FIELD(hsp_cell, reserved, 28, 4);

LAYOUT_SIZE(hsp_view_limits, 16);
LAYOUT_FIELD(hsp_view_limits, struct_size, 0, 4);
LAYOUT_FIELD(hsp_view_limits, balls, 4, 4);
LAYOUT_FIELD(hsp_view_limits, neighbours, 8, 4);
LAYOUT_FIELD(hsp_view_limits, arcs, 12, 4);

LAYOUT_SIZE(hsp_view_options, 64);
LAYOUT_FIELD(hsp_view_options, struct_size, 0, 4);
LAYOUT_FIELD(hsp_view_options, pieces, 4, 4);
LAYOUT_FIELD(hsp_view_options, flags, 8, 4);
LAYOUT_FIELD(hsp_view_options, reserved, 12, 4);
LAYOUT_FIELD(hsp_view_options, towards, 16, 24);
LAYOUT_FIELD(hsp_view_options, up, 40, 24);

LAYOUT_SIZE(hsp_view_info, 160);
LAYOUT_FIELD(hsp_view_info, origin, 0, 24);
LAYOUT_FIELD(hsp_view_info, right, 24, 24);
LAYOUT_FIELD(hsp_view_info, up, 48, 24);
LAYOUT_FIELD(hsp_view_info, towards, 72, 24);
LAYOUT_FIELD(hsp_view_info, low, 96, 16);
LAYOUT_FIELD(hsp_view_info, high, 112, 16);
LAYOUT_FIELD(hsp_view_info, depth_low, 128, 8);
LAYOUT_FIELD(hsp_view_info, depth_high, 136, 8);
LAYOUT_FIELD(hsp_view_info, pieces, 144, 4);
LAYOUT_FIELD(hsp_view_info, loops, 148, 4);
LAYOUT_FIELD(hsp_view_info, arcs, 152, 4);
LAYOUT_FIELD(hsp_view_info, kind, 156, 4);

LAYOUT_SIZE(hsp_view_piece, 56);
LAYOUT_FIELD(hsp_view_piece, centre, 0, 16);
LAYOUT_FIELD(hsp_view_piece, depth, 16, 8);
LAYOUT_FIELD(hsp_view_piece, radius, 24, 8);
LAYOUT_FIELD(hsp_view_piece, ball, 32, 4);
LAYOUT_FIELD(hsp_view_piece, first_loop, 36, 4);
LAYOUT_FIELD(hsp_view_piece, loops, 40, 4);
LAYOUT_FIELD(hsp_view_piece, first_arc, 44, 4);
LAYOUT_FIELD(hsp_view_piece, arcs, 48, 4);
LAYOUT_FIELD(hsp_view_piece, reserved, 52, 4);

LAYOUT_SIZE(hsp_view_loop, 16);
LAYOUT_FIELD(hsp_view_loop, piece, 0, 4);
LAYOUT_FIELD(hsp_view_loop, first_arc, 4, 4);
LAYOUT_FIELD(hsp_view_loop, arcs, 8, 4);
LAYOUT_FIELD(hsp_view_loop, reserved, 12, 4);

LAYOUT_SIZE(hsp_view_arc, 96);
LAYOUT_FIELD(hsp_view_arc, centre, 0, 16);
LAYOUT_FIELD(hsp_view_arc, semi_axis, 16, 16);
LAYOUT_FIELD(hsp_view_arc, rotation, 32, 8);
LAYOUT_FIELD(hsp_view_arc, from, 40, 8);
LAYOUT_FIELD(hsp_view_arc, to, 48, 8);
LAYOUT_FIELD(hsp_view_arc, start, 56, 16);
LAYOUT_FIELD(hsp_view_arc, end, 72, 16);
LAYOUT_FIELD(hsp_view_arc, piece, 88, 4);
LAYOUT_FIELD(hsp_view_arc, other_ball, 92, 4);

LAYOUT_SIZE(hsp_picture_options, 72);
LAYOUT_FIELD(hsp_picture_options, struct_size, 0, 4);
LAYOUT_FIELD(hsp_picture_options, format, 4, 4);
LAYOUT_FIELD(hsp_picture_options, style, 8, 4);
LAYOUT_FIELD(hsp_picture_options, unit, 12, 4);
LAYOUT_FIELD(hsp_picture_options, width, 16, 8);
LAYOUT_FIELD(hsp_picture_options, height, 24, 8);
LAYOUT_FIELD(hsp_picture_options, margin, 32, 8);
LAYOUT_FIELD(hsp_picture_options, outline, 40, 8);
LAYOUT_FIELD(hsp_picture_options, fog, 48, 8);
LAYOUT_FIELD(hsp_picture_options, outline_colour, 56, 4);
LAYOUT_FIELD(hsp_picture_options, background, 60, 4);
LAYOUT_FIELD(hsp_picture_options, flags, 64, 4);
LAYOUT_FIELD(hsp_picture_options, reserved, 68, 4);

/* The size macros are constant expressions of type size_t, and preprocessor conditions may use the version. */
LAYOUT_HOLDS(model_bytes, HSP_MODEL_BYTES(1000) > 0 && sizeof(HSP_MODEL_BYTES(1)) == sizeof(size_t));
LAYOUT_HOLDS(boundary_bytes,
             HSP_BOUNDARY_BYTES(10, 9, 8, 7) > 0 && sizeof(HSP_BOUNDARY_BYTES(1, 1, 1, 1)) == sizeof(size_t));
LAYOUT_HOLDS(topology_bytes,
             HSP_TOPOLOGY_BYTES(10, 9, 8, 7) > 0 && sizeof(HSP_TOPOLOGY_BYTES(1, 1, 1, 1)) == sizeof(size_t));
LAYOUT_HOLDS(view_bytes, HSP_VIEW_BYTES(10, 9, 8) > 0 && sizeof(HSP_VIEW_BYTES(1, 1, 1)) == sizeof(size_t));
#if HSP_VERSION_NUMBER < 1
#error "HSP_VERSION_NUMBER is not a number that the preprocessor can compare"
#endif
