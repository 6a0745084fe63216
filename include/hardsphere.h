/* hardsphere: exact geometry of unions of balls (molecules), for C, C++ and Fortran.
 *
 * A molecule is n balls. This header answers, exactly and without allocating memory:
 *   - how well the set behaves (Section 2 of the paper): k, rho, numbers of overlaps;
 *   - which balls contain a point, meet a ball, or meet each other (Section 3);
 *   - the boundary of the union: vertices, arcs, circles, faces, shells, voids (Section 4.2);
 *   - areas and volumes.
 * The paper is Halperin and Overmars, "Spheres, Molecules, and Hidden Surface Removal", UU-CS-1994-36.
 *
 * ARRAYS
 *   name     shape    type      unit             meaning
 *   xyz      [n][3]   double    length           centres, x y z of ball 0, then of ball 1, ...
 *   radius   [n]      double    length           radii, 0 allowed
 *   ids      [m]      uint32_t  -                ball indices, always 0-based, always the caller's own order
 *   area     [n]      double    length^2         free area of each ball
 *   volume   [n]      double    length^3         each ball's term of the volume
 * Lengths are in whatever unit the caller uses, and results are in the same unit. Angles are in radians.
 *
 * EXACTNESS
 *   Coordinates and radii are rounded once, to a decimal lattice: the nearest multiple of a step that is a power of
 *   ten (1e-8 for radii between 1.08 and 10.7). Text input with no more decimals than the lattice is represented
 *   exactly. Everything combinatorial is then decided in integers; ties are decided as if every ball were
 *   larger by an infinitely small amount of its own, so that balls that touch count as meeting.
 *   See hsp_model_set for the limits of the lattice.
 *
 * MEMORY
 *   The library never allocates. For a handle X: hsp_X_bytes tells the size, hsp_X_init carves the handle out of memory
 *   of any alignment that the caller owns. A handle dies with its memory; there is nothing to free; initialising the
 *   memory again resets it. Distinct handles may be used by distinct threads, and a handle that is passed as const may
 *   be read by any number of threads at a time.
 *
 * OUTPUT ARRAYS
 *   Where a function takes (T *out, uint32_t capacity, uint32_t *needed): *needed is set to the number of records there
 *   are, on HSP_OK and on HSP_E_CAPACITY. With capacity smaller than that the status is HSP_E_CAPACITY and nothing
 *   is written to out. out == NULL with capacity == 0 is the documented query: it yields HSP_OK if there are no
 * records.
 *
 * STATUS
 *   Every function that can fail returns an int32_t: HSP_OK (0) or a negative number. On failure nothing but what the
 *   function's comment names is written. Treat an unknown negative number as a general failure.
 */
#ifndef HARDSPHERE_H
#define HARDSPHERE_H

#include <stddef.h>
#include <stdint.h>

#ifndef HSP_API
#define HSP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- version ------------------------------------------------------------------------------------------------------
 */

/** Version of this header: 10000 * major + 100 * minor + patch. */
#define HSP_VERSION_NUMBER 100

/** Version of the library that was linked, to be compared with HSP_VERSION_NUMBER. */
HSP_API uint32_t hsp_version(void);

/* ---- status -------------------------------------------------------------------------------------------------------
 */

#define HSP_OK 0            /**< success */
#define HSP_E_ARGUMENT (-1) /**< a null pointer, a wrong struct_size, or a reserved field that is not 0 */
#define HSP_E_CAPACITY (-2) /**< an output array or a limit is too small; the number that suffices is reported */
#define HSP_E_MEMORY (-3)   /**< the memory handed to an init function is smaller than its bytes function says */
#define HSP_E_STATE (-4)    /**< the handle does not hold what is asked for (nothing computed, or the model changed) */
#define HSP_E_ID (-5)       /**< a ball index is not below the number of balls */
#define HSP_E_CHECK (-6) /**< the self-check found a law that does not hold: a defect of the library, please report */

#define HSP_E_NOT_FINITE (-10) /**< a coordinate, radius, probe or step is NaN or infinite */
#define HSP_E_NEGATIVE (-11)   /**< a radius, the probe or the step is negative */
#define HSP_E_RANGE (-12)      /**< a coordinate or radius lies beyond the lattice, or the step is not representable */

/** A short English text for a status, for messages; never NULL, "unknown status" for numbers not listed above. */
HSP_API const char *hsp_status_text(int32_t status);

/** The id that no ball has. */
#define HSP_NONE UINT32_C(0xFFFFFFFF)

/** The largest number of balls in one model. */
#define HSP_MAX_BALLS UINT32_C(0x0FFFFFFF)

/* ---- model: a set of balls on its lattice, hashed into cubes --------------------------------------------------------
 *
 *   size_t bytes;                                hsp_model *model;
 *   hsp_model_bytes(n, &bytes);                  void *memory = malloc(bytes);
 *   hsp_model_init(memory, bytes, n, &model);    hsp_model_set(model, n, xyz, radius, NULL, NULL);
 */

typedef struct hsp_model hsp_model;

/** Bytes that hsp_model_init needs for at most `balls` balls, alignment slack included.
 *  HSP_E_ARGUMENT: bytes is NULL. HSP_E_RANGE: balls > HSP_MAX_BALLS or the size does not fit a size_t.
 *  Property 1: at most HSP_MODEL_BYTES(balls). */
HSP_API int32_t hsp_model_bytes(uint32_t balls, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_MODEL_BYTES(balls) ((size_t)1024 + (size_t)128 * (size_t)(balls))

/** Make an empty model (0 balls) for at most `balls` balls in caller memory of any alignment; sets *model.
 *  HSP_E_ARGUMENT: memory or model is NULL. HSP_E_RANGE: as hsp_model_bytes. HSP_E_MEMORY: bytes is less than
 *  hsp_model_bytes says (nothing is written). Boundaries computed from a model that was in this memory before
 *  must be computed again before they are read. */
HSP_API int32_t hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model);

/** How hsp_model_set reads the balls. Zero means default in every field but the first. */
typedef struct hsp_model_options {
  uint32_t struct_size; /**< sizeof(hsp_model_options); hsp_model_options_init sets it */
  uint32_t reserved;    /**< 0 */
  double probe;         /**< length, >= 0: added to every radius, for the solvent-accessible surface; default 0 */
  double step;          /**< length, > 0: the lattice step; 0 means the smallest power of ten with r_max/step < 2^30 */
} hsp_model_options;

/** Fill options with defaults. HSP_E_ARGUMENT: options is NULL or struct_size is not sizeof(hsp_model_options). */
HSP_API int32_t hsp_model_options_init(hsp_model_options *options, uint32_t struct_size);

/** Take n balls: round them to the lattice, hash them into cubes. May be called any number of times (frames of a
 *  trajectory); results obtained from earlier contents become invalid.
 *  xyz [n][3] and radius [n], in length units, may be NULL only if n is 0; options may be NULL (defaults);
 *  first_bad may be NULL, else it is set to the index of the first ball that is refused, or HSP_NONE.
 *
 *  The lattice: coordinate x becomes the integer nearest to x/step, radius r becomes the integer nearest to r/step
 *  plus the integer nearest to probe/step. The default step is a power of ten between 1e-22 and 1e22 chosen from
 *  the largest radius plus probe (1e-8 if that is 0). Limits: radius plus probe below 2^30 steps, every coordinate at
 * most 2^50 steps. Centres that coincide, balls inside others, and balls that touch are all valid.
 *
 *  HSP_E_ARGUMENT: model NULL, xyz or radius NULL with n > 0, bad options. HSP_E_CAPACITY: n exceeds the model's limit.
 *  HSP_E_NOT_FINITE, HSP_E_NEGATIVE, HSP_E_RANGE: as named. On failure the model is empty (0 balls).
 *  Property 1: the order of the balls has no effect but on the ids.
 *  Cost: O(n) expected; the hash table's load is at most 1/2. */
HSP_API int32_t hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius,
                              const hsp_model_options *options, uint32_t *first_bad);

/** What the model holds. */
typedef struct hsp_model_info {
  uint32_t balls;         /**< number of balls */
  uint32_t cubes;         /**< cubes of side 2 r_max that hold a centre (Section 3) */
  uint32_t table_slots;   /**< slots of the open-addressing table; at least twice the number of cubes */
  uint32_t longest_probe; /**< most slots looked at to find a cube that is there */
  double step;            /**< the lattice step, length */
  double probe;           /**< the probe as rounded to the lattice, length */
  double largest_radius;  /**< r_max, probe included, as rounded to the lattice, length */
} hsp_model_info;

/** Describe the model. HSP_E_ARGUMENT: a null pointer. */
HSP_API int32_t hsp_model_get_info(const hsp_model *model, hsp_model_info *info);

#define HSP_FIGURES_ZERO_RADIUS UINT32_C(1) /**< a ball has radius 0 (probe included): k has no value */
#define HSP_FIGURES_COINCIDENT UINT32_C(2)  /**< two centres coincide: rho is 0 */
#define HSP_FIGURES_NO_PAIR UINT32_C(4)     /**< fewer than two balls, or all radii 0: rho has no value */

/** The hard-sphere figures of Section 2, on the lattice. */
typedef struct hsp_figures {
  double k;               /**< r_max / r_min; 0 where it has no value (no balls, HSP_FIGURES_ZERO_RADIUS) */
  double rho;             /**< min over pairs of |c_i c_j| / max(r_i, r_j); 0 where it has no value */
  double mean_overlaps;   /**< mean over the balls of the number of others with |c_i c_j| < r_i + r_j; 0 if n = 0 */
  double neighbour_bound; /**< 216 (k/rho)^3 of Theorem 2.1: no ball meets more others; 0 where it says nothing */
  uint32_t max_overlaps;  /**< the largest of those numbers */
  uint32_t flags;         /**< HSP_FIGURES_*; 0 means that Theorem 2.1 holds with this k and rho */
} hsp_figures;

/** The figures of Section 2, and by flags whether the set meets the conditions of Theorem 2.1 at all. A set that does
 * not is still handled exactly; only the time and memory bounds are lost. Uses the model's scratch memory, hence not
 * const. HSP_E_ARGUMENT: a null pointer. Cost: O(n) for sets with bounded figures. */
HSP_API int32_t hsp_model_get_figures(hsp_model *model, hsp_figures *figures);

/* ---- queries (Section 3)
 * ------------------------------------------------------------------------------------------------
 *
 * Balls are closed: touching counts. Query positions and radii are rounded to the model's lattice, then decided
 * exactly. Hits are the caller's ball indices, ascending, without duplicates. Radii include the model's probe. All
 * return HSP_E_ARGUMENT for a null pointer (ids may be NULL with capacity 0), HSP_E_NOT_FINITE for NaN or infinities,
 * HSP_E_RANGE for a position beyond 2^50 lattice steps or a radius beyond 2^51, HSP_E_CAPACITY as described above. */

/** The balls that contain the point xyz [3]. Cost: O(1) expected for sets as in Theorem 2.1. */
HSP_API int32_t hsp_query_point(const hsp_model *model, const double *xyz, uint32_t *ids, uint32_t capacity,
                                uint32_t *needed);

/** The balls that meet the ball with centre xyz [3] and the given radius (>= 0, else HSP_E_NEGATIVE).
 *  Cost: O(1) expected for radius <= r_max; for larger radii proportional to the cubes within reach, at most to n. */
HSP_API int32_t hsp_query_ball(const hsp_model *model, const double *xyz, double radius, uint32_t *ids,
                               uint32_t capacity, uint32_t *needed);

/** Whether any ball meets that query ball: *meets becomes 1 or 0. Stops at the first hit. Cost as hsp_query_ball. */
HSP_API int32_t hsp_query_meets(const hsp_model *model, const double *xyz, double radius, int32_t *meets);

/** The other balls that meet ball `ball` of the model. HSP_E_ID: no such ball. Cost: O(1) expected.
 *  Property 1: j is listed for i exactly if i is listed for j. */
HSP_API int32_t hsp_query_neighbours(const hsp_model *model, uint32_t ball, uint32_t *ids, uint32_t capacity,
                                     uint32_t *needed);

/* ---- boundary of the union (Section 4.2)
 * -----------------------------------------------------------------------------
 *
 *   vertex   a point on three spheres outside all other balls; named by its three balls and a sign
 *   arc      a maximal free piece of the circle of two spheres between two vertices
 *   circle   a whole intersection circle that is free
 *   face     a maximal free piece of one sphere; it may have several boundary loops, or none (a whole sphere)
 *   shell    a connected component of the boundary;  void: a bounded component of the complement
 * Everything is as if ties were broken by infinitesimally inflated balls: components, voids and Euler number are those
 * of the balls as given, vertices are always on exactly three spheres, arcs and faces may be infinitesimally small. */

typedef struct hsp_boundary hsp_boundary;

/** The limits that fix a boundary's memory. */
typedef struct hsp_boundary_limits {
  uint32_t struct_size; /**< sizeof(hsp_boundary_limits) */
  uint32_t balls;       /**< number of balls of the model */
  uint32_t neighbours;  /**< most balls that meet any one ball that lies inside no other */
  uint32_t vertices;    /**< vertices of the boundary */
  uint32_t circles;     /**< free circles */
  uint32_t reserved;    /**< 0 */
} hsp_boundary_limits;

/** Limits that suffice for molecules of `balls` atoms, van der Waals or solvent-accessible: neighbours
 *  min(balls, 256), vertices 8 balls + 64, circles 2 balls + 16. Ask hsp_boundary_get_needed if a set wants more.
 *  HSP_E_ARGUMENT: limits is NULL or struct_size is not sizeof(hsp_boundary_limits). HSP_E_RANGE: more than
 *  (HSP_MAX_BALLS - 64) / 8 balls; set the limits by hand then. */
HSP_API int32_t hsp_boundary_limits_init(hsp_boundary_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_boundary_init needs. HSP_E_ARGUMENT: null pointer, bad struct_size, reserved not 0.
 *  HSP_E_RANGE: a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t.
 *  Property 1: at most HSP_BOUNDARY_BYTES of the four limits. Property 2: grows with each limit. */
HSP_API int32_t hsp_boundary_bytes(const hsp_boundary_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_BOUNDARY_BYTES(balls, neighbours, vertices, circles)                      \
  ((size_t)4096 + (size_t)64 * (size_t)(balls) + (size_t)256 * (size_t)(neighbours) + \
   (size_t)160 * (size_t)(vertices) + (size_t)80 * (size_t)(circles))

/** Make an empty boundary in caller memory of any alignment; sets *boundary.
 *  HSP_E_ARGUMENT, HSP_E_RANGE as hsp_boundary_bytes; HSP_E_MEMORY: bytes too small (nothing is written). */
HSP_API int32_t hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits,
                                  hsp_boundary **boundary);

/** Compute the boundary of the union of the model's balls. The model must outlive the boundary and stay unchanged while
 *  results are read: after hsp_model_set the functions below return HSP_E_STATE until this one is called again.
 *  HSP_E_ARGUMENT: a null pointer. HSP_E_CAPACITY: a limit is too small; hsp_boundary_get_needed tells which
 *  and what suffices, and the boundary is empty of results.
 *  Property 1: the order of the balls has no effect but on ids.
 *  Cost: O(n) for sets as in Theorem 2.1; O(m^3) per ball with m neighbours at worst. */
HSP_API int32_t hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model);

/** The limits that the last hsp_boundary_compute needed: exact numbers after HSP_OK. After HSP_E_CAPACITY every limit
 *  that was too small is reported with a number larger than given. `neighbours` is known only once `balls` suffices,
 *  `vertices` and `circles` once `neighbours` does, and 0 stands for what is not known yet, so that at most three
 *  enlargements lead to success. The numbers stay readable after the model has changed.
 *  HSP_E_ARGUMENT: a null pointer. HSP_E_STATE: nothing was computed. */
HSP_API int32_t hsp_boundary_get_needed(const hsp_boundary *boundary, hsp_boundary_limits *needed);

/** How many of everything. */
typedef struct hsp_boundary_counts {
  uint32_t balls;           /**< balls of the model */
  uint32_t exposed_balls;   /**< balls with at least one face */
  uint32_t contained_balls; /**< balls inside one other ball (of several equal balls, all but one) */
  uint32_t vertices;
  uint32_t arcs; /**< between two vertices, each counted once */
  uint32_t circles;
  uint32_t faces;
  uint32_t loops; /**< boundary loops of all faces */
  uint32_t shells;
  uint32_t components;    /**< connected components of the union */
  uint32_t voids;         /**< bounded components of the complement of the union */
  uint32_t tied_vertices; /**< vertices with HSP_VERTEX_TIED */
  int64_t euler;          /**< Euler characteristic of the boundary, summed over its shells */
} hsp_boundary_counts;

/** HSP_E_ARGUMENT: a null pointer. HSP_E_STATE: nothing computed, or the model has changed since.
 *  Property 1: euler = vertices - arcs + 2 faces - loops. Property 2: voids = shells - components.
 *  Property 3: 2 arcs = 3 vertices. */
HSP_API int32_t hsp_boundary_get_counts(const hsp_boundary *boundary, hsp_boundary_counts *counts);

/** The tie rule decided about this vertex: a further sphere goes through the point (of a ball that lies inside no
 * other), or two of its circles only touch there. */
#define HSP_VERTEX_TIED UINT32_C(1)

typedef struct hsp_vertex {
  double xyz[3];    /**< position, length */
  uint32_t ball[3]; /**< its balls a < b < c */
  int32_t sign;     /**< +1 or -1: the side of the plane of the centres, along (c_b - c_a) x (c_c - c_a) */
  uint32_t flags;   /**< HSP_VERTEX_* */
  uint32_t reserved;
} hsp_vertex;

/** The vertices; index in the array = vertex id used by hsp_arc.
 *  HSP_E_ARGUMENT, HSP_E_STATE as hsp_boundary_get_counts, HSP_E_CAPACITY as described above.
 *  Property 1: each vertex ends exactly three arcs. */
HSP_API int32_t hsp_boundary_get_vertices(const hsp_boundary *boundary, hsp_vertex *out, uint32_t capacity,
                                          uint32_t *needed);

typedef struct hsp_arc {
  uint32_t ball[2];   /**< its two balls a < b */
  uint32_t vertex[2]; /**< from vertex[0] to vertex[1], counter-clockwise about the axis from c_a to c_b */
  uint32_t face[2];   /**< the face on ball a and the face on ball b */
  double angle;       /**< its angle, in [0, 2 pi] */
} hsp_arc;

/** The arcs, each once. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed);

typedef struct hsp_circle {
  double centre[3]; /**< length */
  double axis[3];   /**< unit vector from c_a towards c_b */
  double radius;    /**< length */
  uint32_t ball[2]; /**< its two balls a < b */
  uint32_t face[2]; /**< the face on ball a and the face on ball b */
} hsp_circle;

/** The free circles. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity,
                                         uint32_t *needed);

typedef struct hsp_face {
  uint32_t ball;  /**< the ball it lies on */
  uint32_t loops; /**< its boundary loops; 0 for a whole sphere */
  uint32_t shell; /**< 0 .. shells - 1 */
  uint32_t reserved;
} hsp_face;

/** The faces; index in the array = face id; faces of one ball are consecutive. Statuses as hsp_boundary_get_vertices.
 */
HSP_API int32_t hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity,
                                       uint32_t *needed);

#define HSP_BALL_CONTAINED UINT32_C(1) /**< the ball lies inside one other ball */

typedef struct hsp_ball {
  uint32_t faces;      /**< number of its faces; 0: the ball is buried */
  uint32_t first_face; /**< id of the first of them, HSP_NONE if there is none */
  uint32_t component;  /**< connected component of the union, 0 .. components - 1 */
  uint32_t flags;      /**< HSP_BALL_* */
} hsp_ball;

/** One record per ball, in the caller's order. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_balls(const hsp_boundary *boundary, hsp_ball *out, uint32_t capacity,
                                       uint32_t *needed);

/* ---- areas and volume
 * ------------------------------------------------------------------------------------------------- */

typedef struct hsp_totals {
  double area;   /**< of the boundary, walls of voids included, length^2 */
  double volume; /**< of the union, voids not included, length^3 */
} hsp_totals;

/** Area and volume of the union, and of each ball.
 *  totals may be NULL; area and volume may each be NULL, else they hold capacity >= n entries, in the caller's order.
 *  area[i] is the free area of ball i. volume[i] is ball i's term of the divergence theorem,
 *  (r_i area[i] + (c_i - o) . N_i) / 3 with N_i the vector area of its faces and o a centre of its component that does
 *  not depend on the order of the balls: the terms sum to the volume, single terms may be negative.
 *  Totals are summed over the balls in the caller's order by a fixed binary tree.
 *  HSP_E_ARGUMENT: boundary NULL. HSP_E_STATE as above. HSP_E_CAPACITY: an array is given and capacity < n
 *  (then nothing is written).
 *  Property 1: area[i] and volume[i] do not depend on the order of the balls, bit for bit.
 *  Accuracy: about 1e-14 of the total for molecules. Cost: O(vertices + circles). */
HSP_API int32_t hsp_boundary_measure(const hsp_boundary *boundary, hsp_totals *totals, double *area, double *volume,
                                     uint32_t capacity);

/* ---- self-check
 * ------------------------------------------------------------------------------------------------------- */

/** Check a computed boundary against its own laws: what fuzzers and careful callers call. *law becomes 0, or the number
 * of the first law that does not hold, and *where the id of the vertex, arc end, loop, face, shell or ball concerned:
 *     1  a vertex lies on three different balls, none of them inside another
 *     2  each of its balls is visited by exactly one loop there, between the two circles that its sign gives
 *     3  an arc ends on the ball and circle it started on
 *     4  every arc is walked once on each of its two balls, in opposite directions
 *     5  loops keep to one ball and have at least two arcs, or are one circle
 *     6  every loop bounds one face of its own ball; only a whole sphere has a face without loops
 *     7  the faces on both sides of an arc or circle belong to one shell
 *     8  the Euler characteristic of each shell is even and at most 2, and there are no fewer shells than components
 *     9  every vertex lies on its three spheres, up to rounding
 *    10  no ball's area is negative or beyond its sphere, and it equals the area from angles between positions
 *    11  the volume equals the volume about another origin from positions: every component's surface is closed
 *  HSP_OK: all hold. HSP_E_CHECK: one does not. HSP_E_ARGUMENT: a null pointer. HSP_E_STATE as above.
 *  Uses the boundary's scratch memory, hence not const; results stay valid. Cost: O(size of the boundary). */
HSP_API int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *law, uint32_t *where);

#ifdef __cplusplus
}
#endif

#endif
