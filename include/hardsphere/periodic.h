/* hardsphere/periodic.h: a union of balls in a periodic box: measures, derivatives, contacts, components, queries.
 *
 * Guide: periodic_boxes.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 * Copies of the box fill space; the copies of a ball are its images. Balls may be given anywhere: each counts once,
 * with all of its images, so that broken and whole molecules give the same results. A ball may meet several images of
 * another one, and of itself. Everything combinatorial is decided exactly, and ties are decided alike in all copies of
 * the box.
 *
 * The box is given by its vectors a, b, c: box [9] holds a_x a_y a_z, b_x b_y b_z, c_x c_y c_z. They may be any three
 * vectors that span a volume, with any angles: the library reduces b and c by whole multiples of the vectors before
 * them.
 *   upright      a_y = a_z = b_z = 0, as GROMACS has it. Nothing is turned: coordinates stay as given, bit for bit.
 *   turned       all other vectors. The library turns everything so that a is along x and b in the plane of x and y, on
 *                the side of y. All that has a direction comes back in the caller's frame: positions, axes, derivatives
 *                by centres, by the strain and by the vectors. The rotation is computed from products, sums, quotients
 *                and roots of doubles alone, so that every machine has the same bits. A point is turned before it is
 *                rounded to the lattice, with an error of a few units in the last place of its largest coordinate: far
 *                less than a lattice step, unless a coordinate is near 2^50 steps.
 *   left-handed  or upright with a_x, b_y or c_z below 0. Nothing is mirrored: a vector that, once turned, points to
 *                the negative side of its axis is reversed, which gives the same copies of the box. Shifts, windings
 *                and derivatives refer to the vectors as they were given.
 * The vectors, turned, are rounded once to the lattice of the balls: images are exact to the last bit only if the
 * vectors' components have no more decimals than the lattice. Components of turned vectors usually have more: then a
 * ball that is given one box away may lie one lattice step beside its place.
 *
 * hardsphere/periodic_boundary.h has vertices, arcs and faces as records. There is nothing that needs an outside: no
 * voids, outer shell, views and meshes; nor rays, which would never leave the copies of the box. Instead components
 * tell in how many directions they go on for ever. */
#ifndef HARDSPHERE_PERIODIC_H
#define HARDSPHERE_PERIODIC_H

#include "contacts.h"
#include "curvature.h"
#include "executor.h"
#include "gradient.h"
#include "hessian.h"
#include "model.h"
#include "query.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A union of balls in a periodic box: its boundary, contacts and components. */
typedef struct hsp_periodic hsp_periodic;

/** The limits that fix the memory. */
typedef struct hsp_periodic_limits {
  uint32_t struct_size; /**< sizeof(hsp_periodic_limits) */
  uint32_t balls;       /**< most balls */
  uint32_t images;      /**< images of balls that are near the box */
  uint32_t neighbours;  /**< as in hsp_boundary_limits */
  uint32_t vertices;    /**< of balls in the box; a vertex across its faces counts once from each side */
  uint32_t circles;     /**< the same */
  uint32_t contacts;    /**< the same */
  uint32_t workers;     /**< parts of the work for an executor; 0 means 1. Comes back unchanged if it suffices */
} hsp_periodic_limits;

/** Limits that suffice for most boxes of `balls` atoms that are at least four times as thick as the largest radius:
 *  images 2 balls + 128, neighbours 256, workers 0, and as many vertices, circles and contacts as
 *  hsp_boundary_limits_init and hsp_contacts_limits_init have for balls and images together.
 *  @retval HSP_E_ARGUMENT  limits is NULL
 *  @retval HSP_E_VERSION   struct_size is bad
 *  @retval HSP_E_RANGE     more than (HSP_MAX_BALLS - 2048) / 36 balls; set the limits by hand then */
HSP_API int32_t HSP_CALL hsp_periodic_limits_init(hsp_periodic_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_periodic_init needs.
 *  - Property 1: at most HSP_PERIODIC_BYTES of the limits but the last, and for each worker but the first
 *    HSP_WORKER_BYTES of balls + images, neighbours, vertices and circles.
 *  - Property 2: grows with each limit.
 *
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_RANGE     a limit, or balls and images together, is larger than HSP_MAX_BALLS, or workers than
 *                          HSP_MAX_WORKERS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_periodic_bytes(const hsp_periodic_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_PERIODIC_BYTES(balls, images, neighbours, vertices, circles, contacts)                          \
  ((size_t)16384 + (size_t)384 * (size_t)(balls) + (size_t)288 * (size_t)(images) +                         \
   (size_t)448 * (size_t)(neighbours) + (size_t)160 * (size_t)(vertices) + (size_t)80 * (size_t)(circles) + \
   (size_t)60 * (size_t)(contacts))

/** Make an empty union in caller memory of any alignment; sets *periodic.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_VERSION   bad struct_size
 *  @retval HSP_E_MEMORY    bytes is less than hsp_periodic_bytes says; nothing is written
 *  @retval HSP_E_RANGE     a limit, or balls and images together, is larger than HSP_MAX_BALLS, or workers than
 *                          HSP_MAX_WORKERS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_periodic_init(void *memory, size_t bytes, const hsp_periodic_limits *limits,
                                           hsp_periodic **periodic);

/** Take n balls and a box, and compute boundary, contacts and components. Balls and options are those of hsp_model_set:
 *  xyz and radius may be NULL only if n is 0; options and limits may be NULL. box [9] holds any three vectors, whose
 *  components count as coordinates for the step of points; nothing is kept of the arrays. On failure there are no
 *  results. first_bad may be NULL, else *first_bad becomes the index of the first ball that is refused. It becomes
 *  HSP_NONE if no ball is, or if the box or the options are at fault, also by a step that is too small for every
 *  radius. limits: see LIMITS in hardsphere.h; at most five retries.
 *  - Property 1: results do not depend on which image of a ball is given, nor on which upright vectors are given for
 *    the same copies, bit for bit. Exceptions are shifts, the order of records sorted by shifts, rows of windings,
 *    derivatives by the vectors, and points without a step, whose lattice follows from coordinates.
 *  - Property 2: a box of m x m x m copies has m^3 times everything that is counted or measured, up to rounding.
 *  - Property 3: if balls and vectors are turned by any rotation results stay the same, and those with a direction turn
 *    with them, up to rounding to the lattice. If a vector is reversed its shifts and derivatives change sign.
 *
 *  Source: contacts and shares as hardsphere/contacts.h, boundary as hardsphere/boundary.h, of the balls in the box and
 *  of the images that are no farther from it than their radius plus the largest radius.
 *  Cost: O(balls + images) for sets as in Theorem 2.1; as many images as a margin of that width around the box holds.
 *  @retval HSP_E_ARGUMENT    a null pointer, but xyz and radius with n = 0
 *  @retval HSP_E_VERSION     bad struct_size of options or limits, or reserved of the options is not 0
 *  @retval HSP_E_CAPACITY    a limit is too small; limits, if not NULL, become limits to retry with
 *  @retval HSP_E_NOT_FINITE  a coordinate, a radius, an option or a component of the box is NaN or infinite
 *  @retval HSP_E_NEGATIVE    a radius or an option is negative
 *  @retval HSP_E_RANGE       as hsp_model_set, also for turned coordinates; or of the turned vectors a_x, b_y or c_z is
 *                            0 on the lattice, as they lie in a plane, or below 2/55 of the largest radius, a component
 *                            is beyond 2^44 steps, or b or c needs more than 64 of the vectors before it to be reduced;
 *                            a ball is more than 2^17 boxes away; more than HSP_MAX_BALLS balls; a row of a winding
 *                            would need more than 31 bits, as no set is known to */
HSP_API int32_t HSP_CALL hsp_periodic_compute(hsp_periodic *periodic, uint32_t n, const double *xyz,
                                              const double *radius, const double *box, const hsp_model_options *options,
                                              hsp_periodic_limits *limits, uint32_t *first_bad);

/** How a box is computed. Zero means default in every field but the first. */
typedef struct hsp_periodic_request {
  uint32_t struct_size;             /**< sizeof(hsp_periodic_request) */
  uint32_t areas_alone;             /**< 1: only areas and their derivatives will be asked for; 0: everything */
  const hsp_model_options *options; /**< or NULL: how balls are rounded, as of hsp_model_set */
  const hsp_executor *executor;     /**< or NULL: the threads that share the work */
} hsp_periodic_request;

/** The same as hsp_periodic_compute, with threads, or for areas alone. request, limits and first_bad may be NULL. With
 *  areas_alone contacts and components, which take most of the time, are not computed. The results then answer
 *  hsp_periodic_measure, hsp_periodic_get_gradient, with derivatives by the box, and hsp_periodic_get_hessian_rows
 *  alone; all other functions return HSP_E_STATE, and so do these for shares and for a pressure in a gradient.
 *  hsp_periodic_totals has 0 for volume, free_volume and contact_area then, and hsp_energy.volume is 0. The limit of
 *  contacts may be 0.
 *  With an executor of more than one worker the search for the boundary falls into hsp_periodic_limits.workers parts,
 *  as that of hsp_boundary_compute_with. Contacts and components are computed by the calling thread alone, as each
 *  ball's contacts continue those of the ball before. limits: see LIMITS in hardsphere.h; at most six retries.
 *  - Property 1: all that can be read afterwards is the same for every number of workers and parts, bit for bit.
 *  - Property 2: areas and derivatives with areas_alone are those without it, bit for bit.
 *
 *  @retval HSP_E_ARGUMENT    a null pointer, but xyz and radius with n = 0; areas_alone is not 0 or 1; an executor with
 *                            several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size of request, options, executor or limits, or reserved of the options is
 *                            not 0
 *  @retval HSP_E_CAPACITY    as hsp_periodic_compute, or the limit of workers is too small
 *  @retval HSP_E_NOT_FINITE  as hsp_periodic_compute
 *  @retval HSP_E_NEGATIVE    as hsp_periodic_compute
 *  @retval HSP_E_RANGE       as hsp_periodic_compute
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once
 *  @retval HSP_E_STOPPED     the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_periodic_compute_with(hsp_periodic *periodic, uint32_t n, const double *xyz,
                                                   const double *radius, const double *box,
                                                   const hsp_periodic_request *request, hsp_periodic_limits *limits,
                                                   uint32_t *first_bad);

/** How many of everything there are in the box, each counted once, also where it crosses faces of the box. Frozen. */
typedef struct hsp_periodic_counts {
  uint32_t balls;      /**< n */
  uint32_t images;     /**< images that were made of them */
  uint32_t vertices;   /**< points of three spheres */
  uint32_t arcs;       /**< between two vertices */
  uint32_t circles;    /**< whole free circles */
  uint32_t loops;      /**< as in hsp_boundary_counts */
  uint32_t faces;      /**< as in hsp_boundary_counts */
  uint32_t shells;     /**< connected components of the boundary; none is inside or outside of another */
  uint32_t components; /**< connected components of the union */
  uint32_t contacts;   /**< pairs of balls, or of a ball and an image, in contact */
  int64_t euler;       /**< V - E + sum over faces of (2 - loops): twice that of the union */
} hsp_periodic_counts;

/** How many vertices, arcs, faces, contacts and components there are.
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_counts(const hsp_periodic *periodic, hsp_periodic_counts *counts);

/** Area and volume of the union in the box. Frozen. */
typedef struct hsp_periodic_totals {
  double area;         /**< of the boundary, length^2 */
  double volume;       /**< of the union, length^3 */
  double box_volume;   /**< of the box on the lattice, length^3 */
  double free_volume;  /**< box_volume less volume, length^3; exactly 0 if there are balls and no boundary */
  double contact_area; /**< of all contacts, each once, length^2 */
} hsp_periodic_totals;

/** Area and volume of the union, and of each ball: area [n] is its free area, share_volume [n] the volume of its share;
 *  the shares sum to the volume. Each array may be NULL and else holds capacity >= n entries. totals may be NULL.
 *  needed may be NULL and else becomes n.
 *  Accuracy: about 1e-14 of the totals for molecules.
 *  @retval HSP_E_ARGUMENT  periodic is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed; share_volume is given after areas_alone */
HSP_API int32_t HSP_CALL hsp_periodic_measure(const hsp_periodic *periodic, hsp_periodic_totals *totals, double *area,
                                              double *share_volume, uint32_t capacity, uint32_t *needed);

/** Integrated curvatures of the boundary in the box, in all and by ball: as hsp_boundary_curvature. Edges and vertices
 *  across the faces of the box count as if they were inside: half for each of an edge's two balls, a third for each of
 *  a vertex's three.
 *  - Property 1: the sum of gauss_thirds is 6 times the Euler characteristic of the boundary.
 *
 *  Cost: O(n + vertices + circles).
 *  @retval HSP_E_ARGUMENT  periodic is NULL
 *  @retval HSP_E_CAPACITY  an array is given and capacity < n; nothing but *needed is written
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_curvature(const hsp_periodic *periodic, hsp_curvatures *totals, double *mean,
                                                int32_t *gauss_thirds, uint32_t capacity, uint32_t *needed);

/** The results of a morphometric energy in a box that are wanted, and where they go. */
typedef struct hsp_periodic_morphometry_outputs {
  uint32_t struct_size; /**< sizeof(hsp_periodic_morphometry_outputs) */
  uint32_t capacity;    /**< entries that each array [n] has room for */
  uint32_t needed;      /**< becomes n */
  uint32_t first_bad;   /**< becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none */
  hsp_morphometric_energy *energy; /**< or NULL */
  double *d_centre;                /**< [n][3], or NULL: by the centres */
  double *d_radius;                /**< [n], or NULL: by the radii */
  uint32_t *flags;                 /**< [n], or NULL: HSP_CURVATURE_ONE_SIDED */
  double *d_strain;                /**< [9], or NULL: by the strain, as in hsp_periodic_gradient_outputs */
  double *d_box;                   /**< [9], or NULL: by the vectors of the box, likewise */
  double *area;                    /**< [n], or NULL: free area of each ball, as of hsp_periodic_measure */
} hsp_periodic_morphometry_outputs;

/** A morphometric energy, its gradient by the balls, and its derivatives by the box, in one call: as
 *  hsp_boundary_get_morphometry. request may be NULL: all defaults. When a ball moves or grows all of its images do.
 *  The volume is the sum of the shares. On failure nothing but outputs->needed and outputs->first_bad is written,
 *  except on HSP_E_EXECUTOR and HSP_E_STOPPED.
 *  - Property 1: the sum of d_centre is zero up to rounding.
 *  - Property 2: with only bending not 0, the trace of d_strain + sum_i r_i d_radius_i is M(sigma), up to rounding.
 *  - Property 3: d_strain is symmetric up to rounding if no ball has a flag.
 *
 *  Cost: O(n + vertices + circles + contacts).
 *  @retval HSP_E_ARGUMENT    periodic or outputs is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, an unknown part or reserved is not 0
 *  @retval HSP_E_CAPACITY    an array for balls is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed
 *  @retval HSP_E_NOT_FINITE  a sigma or a factor is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_periodic_get_morphometry(const hsp_periodic *periodic,
                                                      const hsp_morphometry_request *request,
                                                      hsp_periodic_morphometry_outputs *outputs);

/** A contact of a ball and an image. Frozen. */
typedef struct hsp_periodic_contact {
  double area;       /**< length^2 */
  double rim;        /**< length of the part of its border on the boundary of the union */
  double distance;   /**< of the two centres, length */
  uint32_t ball[2];  /**< its two balls a <= b */
  uint32_t chords;   /**< number of its straight sides */
  uint32_t flags;    /**< HSP_CONTACT_* of hardsphere/contacts.h */
  int32_t shift[3];  /**< multiples of the box vectors by which ball b is moved; both balls start where given */
  uint32_t reserved; /**< 0 */
} hsp_periodic_contact;

/** All contacts, each once, ascending in their balls and shifts. A contact of a ball with its own images is listed once
 *  for each pair of opposite shifts.
 *  - Property 1: 3 V = sum_i r_i A_i + the sum of distance times area over all contacts, up to rounding.
 *
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_contacts(const hsp_periodic *periodic, hsp_periodic_contact *out,
                                                   uint32_t capacity, uint32_t *needed);

/** Sums over the contacts between groups of balls, as hsp_contacts_group; images belong to the groups of their balls.
 *  So contacts of a group with its own images are left out, and contacts of two groups across several faces of the box
 *  make one sum. Uses memory of the handle, hence not const.
 *  @retval HSP_E_ARGUMENT  periodic or group is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_group_contacts(hsp_periodic *periodic, const uint32_t *group,
                                                     hsp_group_contact *out, uint32_t capacity, uint32_t *needed);

/** A connected component of the union, and the directions in which it goes on for ever. Frozen. */
typedef struct hsp_winding {
  uint32_t balls;      /**< how many balls belong to it */
  uint32_t first;      /**< the lowest index of them */
  uint32_t directions; /**< 0 to 3: in how many independent directions it goes on for ever; 0: it ends on all sides */
  /** how many separate copies of it there are along its directions: with directions 3 the number of interpenetrating
   *  nets, with 1 or 2 the number of copies in one line or plane. 1 if directions is 0; HSP_NONE if there are more */
  uint32_t copies;
  /** a basis of the lattice of its windings, in multiples of the vectors of the box: as many rows of three as
   *  directions, in Hermite normal form (echelon form with positive pivots and smaller numbers above them), so that
   *  equal lattices have equal rows; the rest is 0 */
  int32_t row[9];
} hsp_winding;

/** The components, in the order of their first balls.
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_windings(const hsp_periodic *periodic, hsp_winding *out, uint32_t capacity,
                                                   uint32_t *needed);

/** The component of each ball: component [n].
 *  @retval HSP_E_ARGUMENT  periodic is NULL; component is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed */
HSP_API int32_t HSP_CALL hsp_periodic_get_components(const hsp_periodic *periodic, uint32_t *component,
                                                     uint32_t capacity, uint32_t *needed);

/** The results that are wanted, and where they go. */
typedef struct hsp_periodic_gradient_outputs {
  uint32_t struct_size; /**< sizeof(hsp_periodic_gradient_outputs) */
  uint32_t capacity;    /**< entries that each array [n] has room for */
  uint32_t needed;      /**< becomes n */
  uint32_t first_bad;   /**< becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none */
  hsp_energy *energy;   /**< or NULL */
  double *d_centre;     /**< [n][3], or NULL: dE/dc_i */
  double *d_radius;     /**< [n], or NULL: dE/dr_i */
  uint32_t *flags;      /**< [n], or NULL: HSP_GRADIENT_* */
  double *d_strain;     /**< [9], or NULL: [3 p + q] is dE/deps_pq, if all centres and vectors x become x + eps x
                             and radii stay */
  double *d_box; /**< [9], or NULL: [3 k + p] is dE by component p of vector k as it was given, if all centres keep
                      their fractional coordinates */
  double *area;  /**< [n], or NULL: free area of each ball, as of hsp_periodic_measure */
} hsp_periodic_gradient_outputs;

/** An energy and its derivatives by the balls and by the box, as hsp_boundary_get_gradient. request may be NULL: all
 *  defaults. When a ball moves or grows all of its images do. On failure nothing but outputs->needed and
 *  outputs->first_bad is written, except on HSP_E_EXECUTOR and HSP_E_STOPPED.
 *
 *  With forces F = - dE/dc and distances x of pairs, d_strain [3 p + q] = dE/deps_pq = - sum F_p x_q. Hence E adds
 *    d_strain / V_box             to the stress, positive where the box pulls itself together (ASE)
 *    -d_strain                    to the virial sum F_p x_q (LAMMPS), and d_strain / 2 to that of GROMACS, its -1/2
 *    -trace(d_strain) / (3 V_box) to the pressure
 *  - Property 1: the sum of d_centre is zero up to rounding.
 *  - Property 2: with all sigma equal, the trace of d_strain + sum_i r_i d_radius_i is 2 A for the area, 3 V for the
 *    volume.
 *
 *  Cost: O(n + vertices + circles + contacts).
 *  @retval HSP_E_ARGUMENT    periodic or outputs is NULL; unknown tangency; an executor with several workers and
 *                            without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    an array for balls is given and capacity < n
 *  @retval HSP_E_STATE       nothing computed; after areas_alone, and pressure is not 0
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_periodic_get_gradient(const hsp_periodic *periodic, const hsp_gradient_request *request,
                                                   hsp_periodic_gradient_outputs *outputs);

/** The second derivatives of the same energy by the centres, as hsp_boundary_get_hessian_rows (hardsphere/hessian.h)
 *  has them for a union in free space: compressed rows of 3x3 blocks, one for each two balls of which images share a
 *  free piece of a circle, in the caller's frame. When a ball moves all of its images do: so all images of one ball
 *  share a block. Terms of a ball with its own images cancel: a ball that meets only these has a block of zeros. Works
 *  after areas_alone, too, with any pressure. first [n + 1], ball [needed], block [needed][3][3], flags [n + 1] and
 *  needed are as there; flags and request may be NULL.
 *  - Property 1: block (j, i) is block (i, j) transposed, bit for bit, and each block (i, i) is symmetric.
 *  - Property 2: the blocks of a row sum to 0 up to rounding: E does not change when everything moves by a vector. It
 *    does change when the balls turn and the box vectors do not.
 *  - Property 3: bits depend neither on which image of a ball is given, if the vectors are upright, nor on the order of
 *    the balls, except of equal balls, nor on the executor.
 *  - Property 4: a block of a box of m x m x m copies, summed over the copies of one of its balls, is that of the box.
 *
 *  Accuracy: as hsp_boundary_get_hessian_rows.
 *  Cost: O(n + vertices + circles), times the logarithm of the arcs on a ball; three to five gradients.
 *  @retval HSP_OK            all rows are there; or there is no entry, also with capacity 0
 *  @retval HSP_E_ARGUMENT    periodic or first is NULL; ball or block is NULL with a capacity above 0; unknown
 *                            tangency; an executor with several workers and without run
 *  @retval HSP_E_VERSION     bad struct_size, or an unknown part is not 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than the number of entries: first and *needed are set, nothing else
 *  @retval HSP_E_STATE       nothing computed
 *  @retval HSP_E_NOT_FINITE  a sigma, tension or pressure is NaN or infinite
 *  @retval HSP_E_EXECUTOR    the executor did not call every task exactly once; the arrays may have been written
 *  @retval HSP_E_STOPPED     the executor said not to go on; the arrays may have been written */
HSP_API int32_t HSP_CALL hsp_periodic_get_hessian_rows(const hsp_periodic *periodic,
                                                       const hsp_gradient_request *request, uint32_t *first,
                                                       uint32_t *ball, double *block, uint32_t *flags,
                                                       uint32_t capacity, uint32_t *needed);

/** A ball, or an image of it. Frozen. */
typedef struct hsp_image {
  uint32_t ball;    /**< the caller's index */
  int32_t shift[3]; /**< multiples of the box vectors by which it is moved from where it was given */
} hsp_image;

/** The balls and images that contain the point xyz [3], wherever it is, ascending in balls and shifts. Touching counts.
 *  - Property 1: if the point is moved by vectors of the box the balls stay the same, and the same multiples are added
 *    to the shifts.
 *
 *  @retval HSP_E_ARGUMENT    periodic or xyz is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed
 *  @retval HSP_E_STATE       nothing computed
 *  @retval HSP_E_NOT_FINITE  a coordinate is NaN or infinite
 *  @retval HSP_E_RANGE       a coordinate is beyond 2^50 lattice steps, or more than 2^17 boxes away */
HSP_API int32_t HSP_CALL hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out,
                                                  uint32_t capacity, uint32_t *needed);

/** The balls and images that meet the ball with centre xyz [3] and the given radius, wherever it is, ascending in balls
 *  and shifts. The radius may be larger than the box; the probe is not added to it. Touching counts.
 *  - Property 1: if the centre is moved by vectors of the box the balls stay the same, and the same multiples are added
 *    to the shifts.
 *
 *  Cost: O(1) expected for radius <= r_max; for larger radii proportional to the cubes within reach, in all copies of
 *  the box.
 *  @retval HSP_E_ARGUMENT    periodic or xyz is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY    capacity is smaller than *needed
 *  @retval HSP_E_STATE       nothing computed
 *  @retval HSP_E_NOT_FINITE  a coordinate or the radius is NaN or infinite
 *  @retval HSP_E_NEGATIVE    the radius is negative
 *  @retval HSP_E_RANGE       as hsp_periodic_query_point; or the radius is above 64 times the shortest of a_x, b_y and
 *                            c_z, once turned, or there are more than 2^32 - 1 hits */
HSP_API int32_t HSP_CALL hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius,
                                                 hsp_image *out, uint32_t capacity, uint32_t *needed);

/** The balls and images that meet ball `ball` where it was given, ascending in balls and shifts. The ball itself is not
 *  listed, but its images may be.
 *  - Property 1: (j, s) is listed for i exactly if (i, -s) is listed for j.
 *
 *  @retval HSP_E_ARGUMENT  periodic is NULL; out is NULL with a capacity above 0
 *  @retval HSP_E_CAPACITY  capacity is smaller than *needed
 *  @retval HSP_E_STATE     nothing computed
 *  @retval HSP_E_ID        no such ball */
HSP_API int32_t HSP_CALL hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out,
                                                       uint32_t capacity, uint32_t *needed);

/** All pairs of balls and images that meet, as rows of one array: those that meet ball i where it was given are
 *  out[first[i]] to out[first[i + 1] - 1], ascending in balls and shifts. flags is 0 or HSP_PAIRS_ONCE. first [n + 1]
 *  begins with 0 and ends with the number of all entries; *needed becomes the same number. first is written on HSP_OK
 *  and on HSP_E_CAPACITY: with out NULL and capacity 0 this function counts, and a second call with capacity first[n]
 *  lists.
 *
 *  For a neighbour list by a cutoff, give hsp_periodic_compute radii that are all 0 and the probe cutoff / 2. The
 *  cutoff is then twice the rounded probe.
 *  - Property 1: without flags, row i is what hsp_periodic_query_neighbours lists for ball i.
 *  - Property 2: with HSP_PAIRS_ONCE, row i holds only those entries with balls j > i, and of the images of ball i
 *    itself one of any two with opposite shifts: that of hsp_periodic_get_contacts if there is a contact.
 *
 *  Cost: O(n) expected for sets as in Theorem 2.1, and with a few large balls among small ones; proportional to the
 *  number of pairs if that is larger; O(n c) at worst.
 *  @retval HSP_OK          out holds all rows; or there is no pair, also with capacity 0
 *  @retval HSP_E_ARGUMENT  periodic or first is NULL; out is NULL with a capacity above 0; unknown flag
 *  @retval HSP_E_CAPACITY  more pairs than capacity: first and *needed are set, and nothing is written to out
 *  @retval HSP_E_STATE     nothing computed
 *  @retval HSP_E_RANGE     more than 2^32 - 1 entries; first becomes 0 everywhere */
HSP_API int32_t HSP_CALL hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first,
                                                  hsp_image *out, uint32_t capacity, uint32_t *needed);

/** Check the results against laws that hold for every set of balls in a box. *invariant becomes 0 or the number of the
 *  first law that is violated, *id the ball concerned, or HSP_NONE.
 *    1  each contact of a ball is there from the other ball's side
 *    2  faces and contacts of each ball close its share: their vector areas sum to 0
 *    3  the vector areas of all faces sum to 0
 *    4  the shares sum to the volume that the divergence theorem gives from faces and from contacts across the faces of
 *       the box
 *  Cost: O(size).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_STATE     nothing computed
 *  @retval HSP_E_CHECK     an invariant is violated: please report it */
HSP_API int32_t HSP_CALL hsp_periodic_check(hsp_periodic *periodic, uint32_t *invariant, uint32_t *id);

#ifdef __cplusplus
}
#endif

#endif
