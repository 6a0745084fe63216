/* hardsphere/deprecated.h: old names of functions and types, in terms of those that replace them.
 *
 * Deprecated: this goes with the next minor version. capi/guide/migration.md has each old call beside the new one.
 *
 * The functions are this header's own, and none of the library. Each gives the same bits as the new call with the same
 * numbers. Compilers warn of their use, unless HSP_NO_DEPRECATION_WARNINGS is defined. With HSP_NO_DEPRECATED defined
 * hardsphere.h leaves this header out. */
#ifndef HARDSPHERE_DEPRECATED_H
#define HARDSPHERE_DEPRECATED_H

#include "contacts.h"
#include "curvature.h"
#include "gradient.h"
#include "paths.h" /* hardsphere/paths.h, which a build may lack */
#include "periodic.h"
#include "status.h"
#include "surface.h" /* hardsphere/surface.h, which a build may lack */
#include "topology.h"

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) && !defined(HSP_NO_DEPRECATION_WARNINGS)
/** Before an old name: what compilers say of its use. */
#define HSP_REPLACED_BY(name) __attribute__((deprecated("use " #name)))
#else
/** Nothing. */
#define HSP_REPLACED_BY(name)
#endif

/* Hands needed and first_bad back where the old functions wrote them. */
static inline int32_t hsp_deprecated_result(int32_t status, uint32_t n, uint32_t bad, uint32_t *needed,
                                            uint32_t *first_bad) {
  const int weighed = status == HSP_OK || status == HSP_E_NOT_FINITE;
  if (needed != NULL && (weighed || status == HSP_E_CAPACITY)) *needed = n;
  if (first_bad != NULL && weighed) *first_bad = bad;
  return status;
}

/** hsp_boundary_get_gradient with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_boundary_get_gradient)
static inline int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension,
                                            double pressure, uint32_t tangency, hsp_energy *energy, double *d_centre,
                                            double *d_radius, uint32_t *flags, uint32_t capacity, uint32_t *needed,
                                            uint32_t *first_bad) {
  const hsp_gradient_request request = {sizeof(hsp_gradient_request), tangency, tension, pressure, sigma, NULL};
  hsp_gradient_outputs out = {sizeof(hsp_gradient_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags, NULL};
  const int32_t status = hsp_boundary_get_gradient(boundary, &request, &out);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** hsp_boundary_get_derivatives with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_boundary_get_derivatives)
static inline int32_t hsp_boundary_derivatives(const hsp_boundary *boundary, const double *sigma, uint32_t tangency,
                                               double *area_centre, double *area_radius, double *volume_centre,
                                               double *volume_radius, uint32_t *flags, uint32_t capacity,
                                               uint32_t *needed, uint32_t *first_bad) {
  const hsp_derivatives_request request = {sizeof(hsp_derivatives_request), tangency, sigma, NULL};
  hsp_derivatives_outputs out = {
      sizeof(hsp_derivatives_outputs), capacity, 0, 0, area_centre, area_radius, volume_centre, volume_radius, flags};
  const int32_t status = hsp_boundary_get_derivatives(boundary, &request, &out);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** The factors of a morphometric energy, which are fields of hsp_morphometry_request now. Frozen. */
typedef struct hsp_morphometry {
  double pressure; /**< of the volume */
  double tension;  /**< of the weighted area */
  double bending;  /**< of the weighted mean curvature */
  double gaussian; /**< of the Gaussian curvature */
} hsp_morphometry;

/* The request of an old call; without factors none that any function takes. */
static inline hsp_morphometry_request hsp_deprecated_morphometry(const double *sigma, const hsp_morphometry *factors) {
  const hsp_morphometry none = {0, 0, 0, 0}, *const f = factors != NULL ? factors : &none;
  const hsp_morphometry_request request = {
      sizeof(hsp_morphometry_request), 0, f->pressure, f->tension, f->bending, f->gaussian, sigma, NULL};
  return request;
}

/** hsp_boundary_get_morphometry with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_boundary_get_morphometry)
static inline int32_t hsp_boundary_morphometry(const hsp_boundary *boundary, const double *sigma,
                                               const hsp_morphometry *factors, hsp_morphometric_energy *energy,
                                               double *d_centre, double *d_radius, uint32_t *flags, uint32_t capacity,
                                               uint32_t *needed, uint32_t *first_bad) {
  const hsp_morphometry_request request = hsp_deprecated_morphometry(sigma, factors);
  hsp_morphometry_outputs out = {sizeof(hsp_morphometry_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags};
  const int32_t status = hsp_boundary_get_morphometry(boundary, &request, factors != NULL ? &out : NULL);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** hsp_periodic_get_gradient with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_periodic_get_gradient)
static inline int32_t hsp_periodic_gradient(const hsp_periodic *periodic, const double *sigma, double tension,
                                            double pressure, uint32_t tangency, hsp_energy *energy, double *d_centre,
                                            double *d_radius, uint32_t *flags, double *d_strain, double *d_box,
                                            uint32_t capacity, uint32_t *needed, uint32_t *first_bad) {
  const hsp_gradient_request request = {sizeof(hsp_gradient_request), tangency, tension, pressure, sigma, NULL};
  hsp_periodic_gradient_outputs out = {
      sizeof(hsp_periodic_gradient_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags, d_strain, d_box, NULL};
  const int32_t status = hsp_periodic_get_gradient(periodic, &request, &out);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** hsp_periodic_get_morphometry with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_periodic_get_morphometry)
static inline int32_t hsp_periodic_morphometry(const hsp_periodic *periodic, const double *sigma,
                                               const hsp_morphometry *factors, hsp_morphometric_energy *energy,
                                               double *d_centre, double *d_radius, uint32_t *flags, double *d_strain,
                                               double *d_box, uint32_t capacity, uint32_t *needed,
                                               uint32_t *first_bad) {
  const hsp_morphometry_request request = hsp_deprecated_morphometry(sigma, factors);
  hsp_periodic_morphometry_outputs out = {
      sizeof(hsp_periodic_morphometry_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags, d_strain, d_box};
  const int32_t status = hsp_periodic_get_morphometry(periodic, &request, factors != NULL ? &out : NULL);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** hsp_region by its old name. */
HSP_REPLACED_BY(hsp_region)
typedef hsp_region hsp_cell;

/** hsp_topology_get_regions by its old name. */
HSP_REPLACED_BY(hsp_topology_get_regions)
static inline int32_t hsp_topology_get_cells(hsp_topology *topology, hsp_region *out, uint32_t capacity,
                                             uint32_t *needed) {
  return hsp_topology_get_regions(topology, out, capacity, needed);
}

/** hsp_topology_get_region_shells by its old name. */
HSP_REPLACED_BY(hsp_topology_get_region_shells)
static inline int32_t hsp_topology_get_cell_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells,
                                                   uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_region_shells(topology, region, shells, capacity, needed);
}

/** hsp_topology_get_region_balls by its old name. */
HSP_REPLACED_BY(hsp_topology_get_region_balls)
static inline int32_t hsp_topology_get_cell_balls(hsp_topology *topology, uint32_t region, uint32_t *balls,
                                                  uint32_t capacity, uint32_t *needed) {
  return hsp_topology_get_region_balls(topology, region, balls, capacity, needed);
}

/** hsp_contacts_get_pairs by its old name. */
HSP_REPLACED_BY(hsp_contacts_get_pairs)
static inline int32_t hsp_contacts_get(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity,
                                       uint32_t *needed) {
  return hsp_contacts_get_pairs(contacts, out, capacity, needed);
}

/* ---- surface.h */

/** hsp_surface_get_gradient with the fields of its request and outputs as arguments. */
HSP_REPLACED_BY(hsp_surface_get_gradient)
static inline int32_t hsp_surface_weighted_gradient(const hsp_surface *surface, const double *sigma, double tension,
                                                    double pressure, hsp_energy *energy, double *d_centre,
                                                    double *d_radius, uint32_t *flags, uint32_t capacity,
                                                    uint32_t *needed, uint32_t *first_bad) {
  const hsp_gradient_request request = {
      sizeof(hsp_gradient_request), HSP_TANGENT_OVERLAP, tension, pressure, sigma, NULL};
  hsp_gradient_outputs out = {sizeof(hsp_gradient_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags, NULL};
  const int32_t status = hsp_surface_get_gradient(surface, &request, &out);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, first_bad);
}

/** hsp_surface_get_gradient without sigma. */
HSP_REPLACED_BY(hsp_surface_get_gradient)
static inline int32_t hsp_surface_gradient(const hsp_surface *surface, double tension, double pressure,
                                           hsp_energy *energy, double *d_centre, double *d_radius, uint32_t *flags,
                                           uint32_t capacity, uint32_t *needed) {
  const hsp_gradient_request request = {
      sizeof(hsp_gradient_request), HSP_TANGENT_OVERLAP, tension, pressure, NULL, NULL};
  hsp_gradient_outputs out = {sizeof(hsp_gradient_outputs), capacity, 0, 0, energy, d_centre, d_radius, flags, NULL};
  const int32_t status = hsp_surface_get_gradient(surface, &request, &out);
  return hsp_deprecated_result(status, out.needed, out.first_bad, needed, NULL);
}

/** hsp_surface_part_counts by its old name. */
HSP_REPLACED_BY(hsp_surface_part_counts)
typedef hsp_surface_part_counts hsp_surface_map_counts;

/** hsp_surface_get_part_counts by its old name. */
HSP_REPLACED_BY(hsp_surface_get_part_counts)
static inline int32_t hsp_surface_get_map_counts(const hsp_surface *surface, hsp_surface_part_counts *counts) {
  return hsp_surface_get_part_counts(surface, counts);
}

/* ---- paths.h */

/** hsp_gate_get_widest by its old name. */
HSP_REPLACED_BY(hsp_gate_get_widest)
static inline int32_t hsp_gate_get(const hsp_gate *gate, hsp_widest_probe *widest) {
  return hsp_gate_get_widest(gate, widest);
}

#endif
