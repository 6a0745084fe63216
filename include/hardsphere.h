/* hardsphere: exact geometry of unions of balls (molecules), for C, C++ and Fortran.
 *
 * A molecule is n balls. This header answers, exactly and without allocating memory:
 *   - how well the set behaves (Section 2 of the paper): k, rho, numbers of overlaps;
 *   - which balls contain a point, meet a ball, or meet each other (Section 3);
 *   - the boundary of the union: vertices, arcs, circles, faces, shells, voids (Section 4.2, Steps 1 and 2);
 *   - areas and volumes, and their gradients;
 *   - the boundary's topology: quad-edges with simple faces, shells, cells, point location (Section 4.2, Step 3);
 *   - pictures with hidden parts removed: pieces in painter's order as true arcs, SVG, EPS and PDF (Section 5.1).
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
 *   A handle stays where it is made. A copy of one at another address, a handle of another kind and memory that holds
 *   no handle any more are refused with HSP_E_ARGUMENT, also where a language has one type for all pointers. What was
 *   computed from a handle that is no longer there yields HSP_E_STATE.
 *
 * LIMITS
 *   All handles but models take in what some numbers allow, which fix their memory. hsp_X_compute hands such limits
 *   back, if its last argument is not NULL. Its struct_size has to be set, which hsp_X_limits_init does.
 *   On HSP_E_CAPACITY they are limits to retry with: none is smaller than the handle's own, and one at least is larger.
 *   What is not known yet stays as it was, so that a few retries may be necessary. On HSP_OK they are what was needed,
 *   exactly. On any other status they stay as they are. So memory grows until it suffices in three lines:
 *     while ((status = hsp_X_compute(x, ..., &limits)) == HSP_E_CAPACITY) {
 *       hsp_X_bytes(&limits, &bytes);
 *       memory = realloc(memory, bytes);
 *       hsp_X_init(memory, bytes, &limits, &x);
 *     }
 *
 * STRUCTS
 *   A struct that begins with struct_size says how much of it a program knows, so that programs and libraries of
 *   different versions fit together. Fields that an older, smaller one lacks have their default values. What the
 *   library does not know of a newer, larger one has to be zeros, else the status is HSP_E_ARGUMENT. Nothing is written
 *   beyond struct_size. Bad are smaller sizes that no version of the struct had, and larger ones above 1024 or no
 *   multiple of 4.
 *
 * OUTPUT ARRAYS
 *   Where a function takes (T *out, uint32_t capacity, uint32_t *needed): *needed is set to the number of records there
 *   are, on HSP_OK and on HSP_E_CAPACITY. With capacity smaller than that the status is HSP_E_CAPACITY and nothing
 *   is written to out. out == NULL with capacity == 0 asks for the number: HSP_E_CAPACITY if there are records, HSP_OK
 *   if there are none.
 *
 * STATUS
 *   Every function that can fail returns an int32_t: HSP_OK (0) or a negative number. On failure nothing but what the
 *   function's comment names is written. Treat an unknown negative number as a general failure.
 *
 * HANDLES AFTER A FAILURE
 *   hsp_model_set and hsp_X_compute replace what the handle held, whether they succeed or not. One that fails, for
 *   whatever reason, leaves the handle as hsp_X_init makes it: a model is empty (hsp_model_get_info says so: 0 balls,
 *   step 1e-8); a boundary, topology or view holds no results, and reading it yields HSP_E_STATE. All other functions
 *   leave what a handle holds as it is, whatever they return.
 */
#ifndef HARDSPHERE_H
#define HARDSPHERE_H

#include <stddef.h>
#include <stdint.h>

/* What stands before every function. Building the shared library defines HSP_BUILD_SHARED: the functions of this header
 * are what it exports. Nothing has to be defined to use either library. */
#ifndef HSP_API
#ifdef HSP_BUILD_SHARED
#define HSP_API __attribute__((visibility("default")))
#else
#define HSP_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- version --------------------------------------------------------------------------------------------------- */

/** Version of this header: 10000 * major + 100 * minor + patch. */
#define HSP_VERSION_NUMBER 100

/** Version of the library that was linked, to be compared with HSP_VERSION_NUMBER. */
HSP_API uint32_t hsp_version(void);

/* ---- status ---------------------------------------------------------------------------------------------------- */

#define HSP_OK 0               /**< success */
#define HSP_E_ARGUMENT (-1)    /**< a null pointer, no live handle, an unknown option, or a bad struct_size */
#define HSP_E_CAPACITY (-2)    /**< an output array or a limit is too small; what suffices is reported */
#define HSP_E_MEMORY (-3)      /**< the memory is smaller than required */
#define HSP_E_STATE (-4)       /**< nothing computed, or the model or boundary behind it has changed since */
#define HSP_E_ID (-5)          /**< no ball, vertex, edge, quarter-edge, face, shell, cell or element has this id */
#define HSP_E_CHECK (-6)       /**< the self-check found a violated invariant: please report it */
#define HSP_E_SINK (-7)        /**< the caller's byte sink refused bytes */
#define HSP_E_NOT_FINITE (-10) /**< a value is NaN or infinite */
#define HSP_E_NEGATIVE (-11)   /**< a radius, the probe or the step is negative */
#define HSP_E_RANGE (-12)      /**< a value lies beyond the lattice or the largest size */

/** What stands above beside a status, for messages; never NULL, "unknown status" for numbers not listed above. */
HSP_API const char *hsp_status_text(int32_t status);

/** The id that no ball has. */
#define HSP_NONE UINT32_C(0xFFFFFFFF)

/** The largest number of balls in one model. */
#define HSP_MAX_BALLS UINT32_C(0x0FFFFFFF)

/* ---- radii by element -------------------------------------------------------------------------------------------- */

/** Van der Waals radii of A. Bondi, J. Phys. Chem. 68 (1964) 441, completed for the main group by M. Mantina et al.,
 *  J. Phys. Chem. A 113 (2009) 5806, Table 12, with hydrogen 1.10 after R. S. Rowland and R. Taylor, J. Phys. Chem. 100
 *  (1996) 7384. Published: all s- and p-block elements of the periods 1 to 6, Fr, Ra, Ni, Cu, Zn, Pd, Ag, Cd, Au, Hg
 *  and U. */
#define HSP_RADII_BONDI UINT32_C(0)

/** The radii of the paper, Section 2, which are those of Chem3D Plus. Published: H, C, N, O, P, S and Ca. */
#define HSP_RADII_CHEM3D UINT32_C(1)

/** The set's source has no radius for this element: the radius is a substitute. */
#define HSP_RADIUS_FALLBACK UINT32_C(1)

/** The radius of an element in one of the sets HSP_RADII_*: *radius in angstrom, *flags = HSP_RADIUS_* or 0; flags may
 *  be NULL. Atomic numbers are 1 (hydrogen) to 118 (oganesson); deuterium is hydrogen.
 *  Where the source has no radius it is that of HSP_RADII_BONDI instead, and 2.00 where this has none either, always
 *  with HSP_RADIUS_FALLBACK, so that a caller can refuse the element or name a radius of its own.
 *  HSP_E_ARGUMENT: radius is NULL, unknown set. HSP_E_ID: no element has this number. On failure nothing is written. */
HSP_API int32_t hsp_element_radius(uint32_t set, uint32_t atomic_number, double *radius, uint32_t *flags);

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
 *  hsp_model_bytes says (nothing is written). Boundaries and views computed from a model that was in this
 *  memory before must be computed again before they are read. */
HSP_API int32_t hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model);

/** How hsp_model_set reads the balls. Zero means default in every field but the first. */
typedef struct hsp_model_options {
  uint32_t struct_size; /**< sizeof(hsp_model_options); hsp_model_options_init sets it */
  uint32_t reserved;    /**< 0 */
  double probe;         /**< length, >= 0: added to every radius, for the solvent-accessible surface; default 0 */
  double step;          /**< length, > 0: the lattice step; 0 means the smallest power of ten with r_max/step < 2^30 */
  double
      largest_radius; /**< length, > 0: r_max less the probe, for balls of which none may be larger; 0: of the balls */
} hsp_model_options;

/** Fill options with defaults. HSP_E_ARGUMENT: options is NULL or struct_size is bad. */
HSP_API int32_t hsp_model_options_init(hsp_model_options *options, uint32_t struct_size);

/** Take n balls: round them to the lattice, hash them into cubes. May be called any number of times (frames of a
 *  trajectory); results obtained from earlier contents become invalid.
 *  xyz [n][3] and radius [n], in length units, may be NULL only if n is 0; options may be NULL (defaults);
 *  first_bad may be NULL, else it is set to the index of the first ball that is refused, or HSP_NONE.
 *
 *  The lattice: coordinate x becomes the integer nearest to x/step, radius r becomes the integer nearest to r/step
 *  plus the integer nearest to probe/step. The default step is a power of ten between 1e-22 and 1e22 chosen from
 *  the largest radius plus probe (1e-8 if that is 0). Limits: radius plus probe below 2^30 steps, every coordinate at
 *  most 2^50 steps. Centres that coincide, balls inside others, and balls that touch are all valid.
 *  With options.largest_radius lattice and cubes no longer depend on the balls: models with the same options have the
 *  same grid, and a ball and its neighbours give the same bits whatever else there is. A larger ball is HSP_E_RANGE.
 *
 *  HSP_E_ARGUMENT: model NULL, xyz or radius NULL with n > 0, bad options. HSP_E_CAPACITY: n exceeds the model's limit.
 *  HSP_E_NOT_FINITE, HSP_E_NEGATIVE, HSP_E_RANGE: as named. On failure the model is empty (0 balls), as
 *  hsp_model_init makes it.
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

/** Describe the model. Without balls the step is the one that hsp_model_set was given, else 1e-8.
 *  HSP_E_ARGUMENT: a null pointer. */
HSP_API int32_t hsp_model_get_info(const hsp_model *model, hsp_model_info *info);

#define HSP_PACKING_ZERO_RADIUS UINT32_C(1) /**< a ball has radius 0 (probe included): k has no value */
#define HSP_PACKING_COINCIDENT UINT32_C(2)  /**< two centres coincide: rho is 0 */
#define HSP_PACKING_NO_PAIR UINT32_C(4)     /**< fewer than two balls, or all radii 0: rho has no value */

/** The hard-sphere figures of Section 2, on the lattice. */
typedef struct hsp_packing {
  double k;               /**< r_max / r_min; 0 where it has no value (no balls, HSP_PACKING_ZERO_RADIUS) */
  double rho;             /**< min over pairs of |c_i c_j| / max(r_i, r_j); 0 where it has no value */
  double mean_overlaps;   /**< mean over the balls of the number of others with |c_i c_j| < r_i + r_j; 0 if n = 0 */
  double neighbour_bound; /**< 216 (k/rho)^3 of Theorem 2.1: no ball meets more others; 0 where it says nothing */
  uint32_t max_overlaps;  /**< the largest of those numbers */
  uint32_t flags;         /**< HSP_PACKING_*; 0 means that Theorem 2.1 holds with this k and rho */
} hsp_packing;

/** The figures of Section 2, and by flags whether the set meets the conditions of Theorem 2.1 at all. A set that does
 * not is still handled exactly; only the time and memory bounds are lost. Uses the model's scratch memory, hence not
 * const. HSP_E_ARGUMENT: a null pointer. Cost: O(n) for sets with bounded figures. */
HSP_API int32_t hsp_model_get_packing(hsp_model *model, hsp_packing *figures);

/* ---- queries (Section 3) ------------------------------------------------------------------------------------------
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

/* ---- boundary of the union (Section 4.2) --------------------------------------------------------------------------
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
 *  min(balls, 256), vertices 8 balls + 64, circles 2 balls + 16. hsp_boundary_compute says if a set needs more.
 *  HSP_E_ARGUMENT: limits is NULL or struct_size is bad. HSP_E_RANGE: more than
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
 *  HSP_E_ARGUMENT, HSP_E_RANGE as hsp_boundary_bytes; HSP_E_MEMORY: bytes too small (nothing is written).
 *  Topologies computed from a boundary that was in this memory before must be computed again before they are read. */
HSP_API int32_t hsp_boundary_init(void *memory, size_t bytes, const hsp_boundary_limits *limits,
                                  hsp_boundary **boundary);

/** Compute the boundary of the union of the model's balls. The model must outlive the boundary and stay unchanged while
 *  results are read: after hsp_model_set the functions below return HSP_E_STATE until this one is called again.
 *  limits: see LIMITS above. vertices and circles are known once neighbours suffices: at most three retries.
 *  HSP_E_ARGUMENT: boundary or model NULL, bad struct_size of limits. HSP_E_CAPACITY: a limit is too small. On failure
 *  the boundary holds no results.
 *  Property 1: the order of the balls has no effect but on ids.
 *  Cost: O(n) for sets as in Theorem 2.1; O(m^3) per ball with m neighbours at worst. */
HSP_API int32_t hsp_boundary_compute(hsp_boundary *boundary, const hsp_model *model, hsp_boundary_limits *limits);

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

/** The symbolic perturbation decided about this vertex: a further sphere goes through it (of a ball that lies inside no
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

/** An arc runs counter-clockwise about its axis, from vertex[0] to vertex[1]. Seen from outside the balls, face[1] lies
 *  on its left and face[0] on its right. */
typedef struct hsp_arc {
  double centre[3];   /**< of its circle, length */
  double axis[3];     /**< unit vector from c_a towards c_b */
  double radius;      /**< of its circle, length */
  double angle;       /**< from vertex[0] to vertex[1], in [0, 2 pi] */
  uint32_t ball[2];   /**< its two balls a < b */
  uint32_t vertex[2]; /**< where it starts and where it ends */
  uint32_t face[2];   /**< the face on ball a and the face on ball b */
} hsp_arc;

/** The arcs, each once; index in the array = arc id used by hsp_loop_arc. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_arcs(const hsp_boundary *boundary, hsp_arc *out, uint32_t capacity, uint32_t *needed);

/** Counter-clockwise about the axis, face[1] lies on its left and face[0] on its right, as at arcs. */
typedef struct hsp_circle {
  double centre[3]; /**< length */
  double axis[3];   /**< unit vector from c_a towards c_b */
  double radius;    /**< length */
  uint32_t ball[2]; /**< its two balls a < b */
  uint32_t face[2]; /**< the face on ball a and the face on ball b */
} hsp_circle;

/** The free circles; index in the array = circle id used by hsp_loop. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_circles(const hsp_boundary *boundary, hsp_circle *out, uint32_t capacity,
                                         uint32_t *needed);

typedef struct hsp_face {
  uint32_t ball;       /**< the ball it lies on */
  uint32_t loops;      /**< its boundary loops; 0 for a whole sphere */
  uint32_t shell;      /**< 0 .. shells - 1 */
  uint32_t first_loop; /**< its loops are first_loop .. first_loop + loops - 1 of hsp_boundary_get_loops */
} hsp_face;

/** The faces; index in the array = face id; faces of one ball are consecutive. Statuses as hsp_boundary_get_vertices.
 */
HSP_API int32_t hsp_boundary_get_faces(const hsp_boundary *boundary, hsp_face *out, uint32_t capacity,
                                       uint32_t *needed);

/** A boundary loop of a face: a closed chain of arcs, or a whole circle. Seen from outside the ball, it keeps its face
 *  on its left. */
typedef struct hsp_loop {
  uint32_t face;      /**< the face that it bounds */
  uint32_t circle;    /**< the free circle that it is, whose face[side] is `face`; HSP_NONE if it consists of arcs */
  uint32_t side;      /**< 1: a circle counter-clockwise about its axis; 0: a circle clockwise, or arcs */
  uint32_t first_arc; /**< its arcs are first_arc .. first_arc + arcs - 1 of hsp_boundary_get_loop_arcs */
  uint32_t arcs;      /**< at least 2; 0 for a circle */
} hsp_loop;

/** The loops, face after face: counts.loops records. Statuses as hsp_boundary_get_vertices. */
HSP_API int32_t hsp_boundary_get_loops(const hsp_boundary *boundary, hsp_loop *out, uint32_t capacity,
                                       uint32_t *needed);

/** An arc as a part of a loop. */
typedef struct hsp_loop_arc {
  uint32_t arc;    /**< index in hsp_boundary_get_arcs */
  uint32_t side;   /**< 1: the loop runs along it, 0: against it; its face[side] is that of the loop */
  uint32_t vertex; /**< where the loop comes to it: its vertex[1 - side]; vertex[side] is the next one's */
} hsp_loop_arc;

/** The arcs of all loops, loop after loop, each loop's in walking order: 2 counts.arcs records. Statuses as
 *  hsp_boundary_get_vertices.
 *  Property 1: the arcs of a loop are closed: each ends at the vertex of the next, the last at that of the first.
 *  Property 2: every arc occurs once with side 0 and once with side 1. Cost: O(vertices). */
HSP_API int32_t hsp_boundary_get_loop_arcs(const hsp_boundary *boundary, hsp_loop_arc *out, uint32_t capacity,
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

/* ---- areas and volume ------------------------------------------------------------------------------------------ */

typedef struct hsp_totals {
  double area;   /**< of the boundary, walls of voids included, length^2 */
  double volume; /**< of the union, voids not included, length^3 */
} hsp_totals;

/** Area and volume of the union, and of each ball, or those of some balls while the others only block.
 *  selected [n] holds one byte per ball, 0 or not 0; NULL selects all. What is not selected counts 0, and the rest is
 *  the same bit for bit. totals may be NULL; area and volume may each be NULL, else they hold capacity >= n entries, in
 *  the caller's order; needed may be NULL and else becomes n.
 *  area[i] is the free area of ball i. volume[i] is ball i's term of the divergence theorem,
 *  (r_i area[i] + (c_i - o) . N_i) / 3 with N_i the vector area of its faces and o a centre of its component that does
 *  not depend on the order of the balls: the terms sum to the volume, single terms may be negative.
 *  Totals are summed over the balls in the caller's order by a fixed binary tree.
 *  HSP_E_ARGUMENT: boundary NULL. HSP_E_STATE as above. HSP_E_CAPACITY: an array is given and capacity < n
 *  (then nothing but *needed is written).
 *  Property 1: area[i] and volume[i] do not depend on the order of the balls, bit for bit.
 *  Accuracy: about 1e-14 of the total for molecules.
 *  Cost: O(n + what the selected balls' faces have of arcs and circles). */
HSP_API int32_t hsp_boundary_measure(const hsp_boundary *boundary, const uint8_t *selected, hsp_totals *totals,
                                     double *area, double *volume, uint32_t capacity, uint32_t *needed);

/** Area, and term of the volume, of each face: area [faces] and volume [faces], each may be NULL, face ids as in
 *  hsp_boundary_get_faces. A face's volume term is that of the divergence theorem about its ball's origin o (see
 *  hsp_boundary_measure). HSP_E_ARGUMENT, HSP_E_STATE as above; HSP_E_CAPACITY: an array is given and capacity is
 *  less than the number of faces, which *needed becomes if needed is not NULL (nothing else is written then).
 *  Property 1: the faces of a ball sum to that ball's area and volume, up to rounding. */
HSP_API int32_t hsp_boundary_measure_faces(const hsp_boundary *boundary, double *area, double *volume,
                                           uint32_t capacity, uint32_t *needed);

/* ---- gradients ----------------------------------------------------------------------------------------------------
 *
 * The area A_i of ball i and the volume V of the union as functions of all centres and radii. V is continuously
 * differentiable. A_i is continuous; its derivative jumps where two spheres begin to touch, and has an unbounded slope,
 * but no jump, where an arc is born or dies. Where two spheres touch the derivatives here are one-sided
 * (HSP_TANGENT_*), and flags tell which balls are concerned; a ball that touches another from inside counts as lying
 * inside it either way. Where balls are equal A_i jumps and V has a kink: the ball of lowest index has the derivatives
 * that it would have alone, the others have 0, and all are flagged. Where three spheres share a free circle derivatives
 * are one-sided too: those of the side that the symbolic perturbation takes, without a flag. Radii include the probe.
 * The lattice's rounding is not differentiated. */

#define HSP_TANGENT_OVERLAP UINT32_C(0)  /**< as if balls that touch overlapped by an infinitely small amount */
#define HSP_TANGENT_DISJOINT UINT32_C(1) /**< as if they were apart by an infinitely small amount */

#define HSP_GRADIENT_ONE_SIDED \
  UINT32_C(1) /**< the ball touches another at a free point: its derivatives are one-sided */

typedef struct hsp_energy {
  double value;  /**< E = tension * sum_i sigma_i A_i + pressure * V */
  double area;   /**< sum_i sigma_i A_i */
  double volume; /**< V */
  double probe;  /**< dE/d(probe) = sum of all dE/dr_i */
} hsp_energy;

/** E = tension * sum_i sigma_i A_i + pressure * V and its gradient, in one pass.
 *  sigma [n], NULL for all ones; tangency is one of HSP_TANGENT_*; energy may be NULL. centre [n][3] = dE/dc_i,
 *  radius [n] = dE/dr_i and flags [n] = HSP_GRADIENT_* may each be NULL and else hold capacity >= n entries.
 *  For the area alone: tension 1, pressure 0, sigma NULL. For the volume alone: tension 0, pressure 1. A ball with
 *  sigma 0 only blocks. For molecular dynamics take HSP_TANGENT_OVERLAP. needed may be NULL and else becomes n;
 *  first_bad may be NULL and else becomes the first ball whose sigma is NaN or infinite, HSP_NONE if there is none.
 *  HSP_E_ARGUMENT: boundary NULL, unknown tangency. HSP_E_STATE, HSP_E_CAPACITY as hsp_boundary_measure.
 *  HSP_E_NOT_FINITE: a sigma, tension or pressure is NaN or infinite. On failure nothing else is written.
 *  Property 1: the sums of centre and of c_i x centre are zero up to rounding (E does not change under motions).
 *  Property 2: with all sigma equal, sum_i (r_i radius_i + c_i . centre_i) = 2 A for the area, 3 V for the volume.
 *  Property 3: centre, radius and flags do not depend on the order of the balls, bit for bit.
 *  Source: M. L. Connolly 1983, T. J. Richmond 1984 for the area; dV/dc_i is the vector area of ball i's faces.
 *  Cost: O(n + vertices + circles). */
HSP_API int32_t hsp_boundary_gradient(const hsp_boundary *boundary, const double *sigma, double tension,
                                      double pressure, uint32_t tangency, hsp_energy *energy, double *centre,
                                      double *radius, uint32_t *flags, uint32_t capacity, uint32_t *needed,
                                      uint32_t *first_bad);

/** The two parts of that gradient, each on its own: the derivatives of S = sum_i sigma_i A_i and of the volume V.
 *  area_centre [n][3] = dS/dc_i, area_radius [n] = dS/dr_i, volume_centre [n][3] = dV/dc_i (the vector area of ball i's
 *  faces), volume_radius [n] = dV/dr_i (ball i's free area); each may be NULL. Other arguments and statuses as
 *  hsp_boundary_gradient.
 *  Property 1: tension times the one plus pressure times the other is what hsp_boundary_gradient says, up to rounding;
 *  with tension 1 and pressure 0, or 0 and 1, and finite numbers, bit for bit. */
HSP_API int32_t hsp_boundary_derivatives(const hsp_boundary *boundary, const double *sigma, uint32_t tangency,
                                         double *area_centre, double *area_radius, double *volume_centre,
                                         double *volume_radius, uint32_t *flags, uint32_t capacity, uint32_t *needed,
                                         uint32_t *first_bad);

/** One entry of a ball's row of the area's Jacobian. */
typedef struct hsp_area_derivative {
  double centre[3]; /**< dA_i/dc_j, length */
  double radius;    /**< dA_i/dr_j, length */
  double angle;     /**< sum of the angles of the free arcs of the circle of i and j that count; 0 for j = i */
  uint32_t ball;    /**< j */
  uint32_t flags;   /**< HSP_GRADIENT_ONE_SIDED if i and j touch; for j = i if another entry has it */
} hsp_area_derivative;

/** The derivatives of A_i, i = ball: an entry for i itself and one for every j whose circle on i has a free piece,
 *  ascending in j; all others are 0. No entries if ball i has no face. tangency as above.
 *  HSP_E_ARGUMENT: null pointer, unknown tangency. HSP_E_ID: no such ball. HSP_E_STATE, HSP_E_CAPACITY as above.
 *  Property 1: the centre entries of a row sum to 0 up to rounding.
 *  Property 2: dA_i/dr_j = dA_j/dr_i up to rounding. Cost: O(m^2) for m arcs on the ball. */
HSP_API int32_t hsp_boundary_get_area_row(const hsp_boundary *boundary, uint32_t ball, uint32_t tangency,
                                          hsp_area_derivative *out, uint32_t capacity, uint32_t *needed);

/* ---- self-check ------------------------------------------------------------------------------------------------ */

/** Check the invariants of a computed boundary: what fuzzers and careful callers call. If all hold, *invariant becomes
 *  0 and *id HSP_NONE. Else *invariant becomes the number of the first that is violated, and
 *  *id that of the vertex, arc end, loop, face, shell or ball concerned:
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
 *  HSP_OK: all hold. HSP_E_CHECK: one is violated. HSP_E_ARGUMENT: a null pointer. HSP_E_STATE as above.
 *  Uses the boundary's scratch memory, hence not const; results stay valid. Cost: O(size of the boundary). */
HSP_API int32_t hsp_boundary_check(hsp_boundary *boundary, uint32_t *invariant, uint32_t *id);

/* ---- topology (Section 4.2, Step 3) -------------------------------------------------------------------------------
 *
 * The boundary as one quad-edge structure (Guibas and Stolfi 1985) whose faces are simple, as the paper has them: every
 * simple face is bounded by one loop of at least two edges, every edge by two different simple faces. To this end
 *   - arcs stay as they are, each is an edge or, where a cut arc ends on it, several;
 *   - a free circle becomes at least two edges, meeting in its two points in the plane through its balls' centres that
 *     contains the direction z (the plane across x if the centres lie above each other);
 *   - a face with several loops is cut by cut arcs: pieces of great circles in planes that contain z, each through
 *     the axis of a circle on that ball, as many of these planes as it takes to join the face's loops;
 *   - a whole sphere is cut in two by the great circle across x, in its highest and lowest points.
 *
 *   vertex         0 .. vertices - 1; the boundary's own vertices come first, with the ids that they have there
 *   edge           0 .. edges - 1
 *   quarter-edge   q = 4 edge + k: the edge's four directed forms. k = 0 is the edge, k = 2 the edge the other way
 *                  (sym), k = 1 and 3 the dual edges from its right to its left face and back (rot, inverse rot)
 *   simple face    0 .. simple_faces - 1
 *   cell           a connected component of the complement of the union: cell 0 is the outer one, the others are the
 *                  voids, in the order of their shells
 *   shell          as in hsp_face: each shell separates one component of the union from one cell
 *
 *              destination(q)                   rot(q)        runs from the right face to the left one
 *                 \   |                         sym(q)        the same edge the other way
 *     lnext(q) <-- \  |                         onext(q)      the next edge counter-clockwise about q's origin
 *                   \ ^   right                 oprev(q)      the next one clockwise
 *           left     \|                         lnext(q)      the next edge counter-clockwise about q's left face,
 *                     | q                                     from q's destination
 *     onext(q) <-- \  |                         lprev(q)      the previous one
 *                   \ |                         counter-clockwise: seen from outside the balls
 *                 origin(q)
 */

typedef struct hsp_topology hsp_topology;

/** The limits that fix a topology's memory. */
typedef struct hsp_topology_limits {
  uint32_t struct_size; /**< sizeof(hsp_topology_limits) */
  uint32_t balls;       /**< number of balls of the model */
  uint32_t neighbours;  /**< as in hsp_boundary_limits */
  uint32_t edges;       /**< edges; vertices and simple faces are never more */
  uint32_t cut_arcs;    /**< cut arcs that cut faces with several loops */
  uint32_t reserved;    /**< 0 */
} hsp_topology_limits;

/** Limits that suffice for molecules of `balls` atoms: neighbours min(balls, 256), edges 16 balls + 96, cut arcs
 *  2 balls + 16. hsp_topology_limits_for suits a boundary that is already there.
 *  HSP_E_ARGUMENT: limits is NULL or struct_size is bad. HSP_E_RANGE: more than
 *  (HSP_MAX_BALLS - 96) / 16 balls. */
HSP_API int32_t hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, uint32_t balls);

/** Limits for a computed boundary that nearly always suffice: its balls and neighbours, four cut arcs for every loop
 *  of a face beyond the first, and edges for its arcs, circles and whole spheres and four for every cut arc.
 *  HSP_E_ARGUMENT: a null pointer or wrong struct_size. HSP_E_STATE: nothing computed, or the model has changed. */
HSP_API int32_t hsp_topology_limits_for(hsp_topology_limits *limits, uint32_t struct_size,
                                        const hsp_boundary *boundary);

/** Bytes that hsp_topology_init needs. HSP_E_ARGUMENT: null pointer, bad struct_size, reserved not 0.
 *  HSP_E_RANGE: a limit is larger than HSP_MAX_BALLS, or the size does not fit a size_t.
 *  Property 1: at most HSP_TOPOLOGY_BYTES of the four limits. Property 2: grows with each limit. */
HSP_API int32_t hsp_topology_bytes(const hsp_topology_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_TOPOLOGY_BYTES(balls, neighbours, edges, cut_arcs)                                                        \
  ((size_t)4096 + (size_t)64 * (size_t)(balls) + (size_t)192 * (size_t)(neighbours) + (size_t)160 * (size_t)(edges) + \
   (size_t)160 * (size_t)(cut_arcs))

/** Make an empty topology in caller memory of any alignment; sets *topology.
 *  HSP_E_ARGUMENT, HSP_E_RANGE as hsp_topology_bytes; HSP_E_MEMORY: bytes too small (nothing is written). */
HSP_API int32_t hsp_topology_init(void *memory, size_t bytes, const hsp_topology_limits *limits,
                                  hsp_topology **topology);

/** Compute the topology of a computed boundary. Boundary and model must outlive the topology; after hsp_model_set or
 *  hsp_boundary_compute the functions below return HSP_E_STATE until this one is called again.
 *  limits: see LIMITS above; at most three retries.
 *  HSP_E_ARGUMENT: topology or boundary NULL, bad struct_size of limits. HSP_E_STATE: the boundary holds no results.
 *  HSP_E_CAPACITY: a limit is too small. On failure the topology holds no results.
 *  Property 1: the order of the balls has no effect but on ids.
 *  Cost: O(n) for sets as in Theorem 2.1 without voids; with voids, for every component of the union one vertical ray
 *  through the grid, at most O(n) each. */
HSP_API int32_t hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits);

/** How many of everything. */
typedef struct hsp_topology_counts {
  uint32_t vertices; /**< those of the boundary and the added ones */
  uint32_t edges;
  uint32_t simple_faces;
  uint32_t cut_edges; /**< of the edges, the ones that cut a face or a whole sphere */
  uint32_t shells;
  uint32_t components; /**< of the union */
  uint32_t cells;      /**< of the complement: 1 + voids */
  uint32_t start_face; /**< the simple face that holds the highest point of all; HSP_NONE if there are no balls */
} hsp_topology_counts;

/** HSP_E_ARGUMENT: a null pointer. HSP_E_STATE: nothing computed, or model or boundary changed since.
 *  Property 1: vertices - edges + simple_faces is the Euler characteristic of the boundary. */
HSP_API int32_t hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts);

/* The algebra. Functions of a quarter-edge alone; HSP_NONE yields HSP_NONE. */
HSP_API uint32_t hsp_quad_rot(uint32_t q);         /**< from the right face to the left one */
HSP_API uint32_t hsp_quad_inverse_rot(uint32_t q); /**< from the left face to the right one */
HSP_API uint32_t hsp_quad_sym(uint32_t q);         /**< the other way */

/* Steps from a quarter-edge; HSP_NONE if there is no such quarter-edge, or no results.
 * Property 1: rot(rot(q)) = sym(q), sym(sym(q)) = q, inverse_rot(rot(q)) = q.
 * Property 2: rot(onext(rot(onext(q)))) = q. Property 3: oprev(onext(q)) = q, lprev(lnext(q)) = q.
 * Property 4: lnext(q) = rot(onext(inverse_rot(q))). Property 5: origin(onext(q)) = origin(q), left(lnext(q)) =
 * left(q), origin(lnext(q)) = origin(sym(q)). */
HSP_API uint32_t hsp_topology_onext(const hsp_topology *topology, uint32_t q);
HSP_API uint32_t hsp_topology_oprev(const hsp_topology *topology, uint32_t q);
HSP_API uint32_t hsp_topology_lnext(const hsp_topology *topology, uint32_t q);
HSP_API uint32_t hsp_topology_lprev(const hsp_topology *topology, uint32_t q);
/** Where q starts: a vertex if q is even, a simple face if q is odd (a dual edge). */
HSP_API uint32_t hsp_topology_origin(const hsp_topology *topology, uint32_t q);
/** What lies to the left of q: a simple face if q is even, a vertex if q is odd. */
HSP_API uint32_t hsp_topology_left(const hsp_topology *topology, uint32_t q);
/** The ball that the simple face on the left of q lies on; HSP_NONE for odd q. */
HSP_API uint32_t hsp_topology_ball(const hsp_topology *topology, uint32_t q);

/** The whole structure as two flat arrays: onext [edges][4] and origin [edges][4], as the functions above give them;
 *  all else follows by rot. Either may be NULL; both with capacity 0 is the query. capacity and *needed count edges.
 *  HSP_E_ARGUMENT: topology or needed is NULL, or both arrays with a capacity above 0. HSP_E_STATE, HSP_E_CAPACITY as
 *  above. Property 1: the arrays hold what the functions above say. */
HSP_API int32_t hsp_topology_get_quad_edges(const hsp_topology *topology, uint32_t *onext, uint32_t *origin,
                                            uint32_t capacity, uint32_t *needed);

#define HSP_POINT_VERTEX UINT32_C(0) /**< a vertex of the boundary; its id is the same */
#define HSP_POINT_CIRCLE UINT32_C(1) /**< an added point of an arc or circle of ball[0] < ball[1] */
#define HSP_POINT_POLE UINT32_C(2)   /**< the highest or lowest point of the sphere of ball[0] */

typedef struct hsp_topology_vertex {
  double xyz[3];    /**< position, length */
  uint32_t ball[3]; /**< the balls whose spheres meet there, ascending, HSP_NONE for those there are not */
  uint32_t kind;    /**< HSP_POINT_* */
  uint32_t q;       /**< a quarter-edge that starts there */
  uint32_t reserved;
} hsp_topology_vertex;

#define HSP_EDGE_ARC UINT32_C(0)    /**< an arc of hsp_boundary_get_arcs or a piece of one */
#define HSP_EDGE_CIRCLE UINT32_C(1) /**< a piece of a free circle */
#define HSP_EDGE_CUT UINT32_C(2)    /**< a piece of a great circle that cuts a face; both sides lie on one ball */

typedef struct hsp_topology_edge {
  double centre[3]; /**< of its circle, length */
  double axis[3];   /**< unit vector; the edge runs counter-clockwise about it, its left face lies on the axis's side */
  double radius;    /**< of its circle, length */
  double angle;     /**< from origin to destination, in [0, 2 pi] */
  uint32_t vertex[2]; /**< origin and destination */
  uint32_t face[2];   /**< simple faces on its left and right */
  uint32_t ball[2];   /**< balls of these faces */
  uint32_t kind;      /**< HSP_EDGE_* */
  uint32_t source;    /**< id of the boundary's arc or circle it is a piece of; HSP_NONE for cut edges */
} hsp_topology_edge;

typedef struct hsp_simple_face {
  uint32_t ball;  /**< the ball it lies on */
  uint32_t face;  /**< the maximal face of hsp_boundary_get_faces that it is a part of */
  uint32_t edges; /**< on its loop, at least 2 */
  uint32_t q;     /**< the quarter-edge, even, of one of them, with this face on its left */
  uint32_t shell;
  uint32_t reserved;
} hsp_simple_face;

/* Vertices, edges and simple faces with their geometry, one by id or all at once.
 * HSP_E_ARGUMENT, HSP_E_STATE, HSP_E_CAPACITY as above; HSP_E_ID: no such id. */
HSP_API int32_t hsp_topology_get_vertex(const hsp_topology *topology, uint32_t id, hsp_topology_vertex *out);
HSP_API int32_t hsp_topology_get_edge(const hsp_topology *topology, uint32_t id, hsp_topology_edge *out);
HSP_API int32_t hsp_topology_get_face(const hsp_topology *topology, uint32_t id, hsp_simple_face *out);
HSP_API int32_t hsp_topology_get_vertices(const hsp_topology *topology, hsp_topology_vertex *out, uint32_t capacity,
                                          uint32_t *needed);
HSP_API int32_t hsp_topology_get_edges(const hsp_topology *topology, hsp_topology_edge *out, uint32_t capacity,
                                       uint32_t *needed);
HSP_API int32_t hsp_topology_get_faces(const hsp_topology *topology, hsp_simple_face *out, uint32_t capacity,
                                       uint32_t *needed);

#define HSP_SHELL_OUTER UINT32_C(0) /**< bounds its component from outside */
#define HSP_SHELL_VOID UINT32_C(1)  /**< bounds a void inside its component */

typedef struct hsp_shell {
  double area;           /**< length^2 */
  double volume;         /**< of the space it encloses, whatever lies in it, length^3 */
  double point[3];       /**< a point of it, length */
  int32_t euler;         /**< Euler characteristic: vertices - edges + simple faces */
  uint32_t genus;        /**< 1 - euler/2: number of handles */
  uint32_t kind;         /**< HSP_SHELL_* */
  uint32_t component;    /**< of the union, as in hsp_ball */
  uint32_t cell;         /**< of the complement, on its other side */
  uint32_t faces;        /**< maximal faces */
  uint32_t simple_faces; /**< and what they are cut into */
  uint32_t edges;
  uint32_t vertices;
  uint32_t start_face; /**< simple face where its scan starts: of an outer shell the one with its highest point, of a
                          void the first one on its ball of lowest rank (x, y, z, radius) */
} hsp_shell;

/** The shells. HSP_E_ARGUMENT, HSP_E_STATE, HSP_E_CAPACITY as above.
 *  Property 1: areas sum to the area of the union; volumes of outer shells less those of voids to its volume, up to
 *  rounding. Cost: O(size of the boundary). */
HSP_API int32_t hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity,
                                        uint32_t *needed);

typedef struct hsp_component {
  uint32_t balls;
  uint32_t top_ball;    /**< the ball with its highest point */
  uint32_t outer_shell; /**< the one shell of kind HSP_SHELL_OUTER */
  uint32_t shells;      /**< outer shell and voids */
  uint32_t cell;        /**< the cell it lies in: 0 or a void of another component */
  uint32_t reserved;
} hsp_component;

/** The connected components of the union, as numbered in hsp_ball. Statuses as hsp_topology_get_shells. */
HSP_API int32_t hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity,
                                            uint32_t *needed);

typedef struct hsp_cell {
  double area;              /**< of all its shells, length^2 */
  double volume;            /**< of the cell itself, what lies in it left out, length^3; of cell 0: 0 */
  uint32_t enclosing_shell; /**< the shell of kind HSP_SHELL_VOID around it; HSP_NONE for cell 0 */
  uint32_t components;      /**< components of the union that lie in it */
  uint32_t shells;          /**< shells that bound it */
  uint32_t reserved;
} hsp_cell;

/** The cells of the complement. Statuses as hsp_topology_get_shells. */
HSP_API int32_t hsp_topology_get_cells(const hsp_topology *topology, hsp_cell *out, uint32_t capacity,
                                       uint32_t *needed);

/** The shells that bound a cell, ascending: its enclosing shell, and the outer shell of every component in it.
 *  HSP_E_ID: no such cell. Else statuses as above. Cost: O(shells). */
HSP_API int32_t hsp_topology_get_cell_shells(const hsp_topology *topology, uint32_t cell, uint32_t *shells,
                                             uint32_t capacity, uint32_t *needed);

/** The paper's scan of one shell: its simple faces in the order in which its recursion from start_face visits them,
 *  around each face counter-clockwise from the edge by which it was entered (hsp_simple_face.q for start_face) and
 *  at once into every neighbour not visited before. With the shell of hsp_topology_counts.start_face it is the outer
 *  boundary component from the topmost ball. HSP_E_ID: no such shell. Else statuses as above. */
HSP_API int32_t hsp_topology_get_traversal(const hsp_topology *topology, uint32_t shell, uint32_t *faces,
                                           uint32_t capacity, uint32_t *needed);

/** Where the point xyz [3] lies: *cell becomes its cell, or HSP_NONE if it lies in a ball; ids receives the balls that
 *  contain it as hsp_query_point does (pass NULL, 0, NULL to have only the cell). Exact; the point is rounded to the
 *  lattice. Statuses as hsp_query_point, and HSP_E_STATE; on HSP_E_CAPACITY *cell and *needed are set.
 *  Uses the topology's scratch memory, hence not const.
 *  Cost: one vertical ray: O(1) expected for each cube it passes, at most O(n). */
HSP_API int32_t hsp_topology_locate(hsp_topology *topology, const double *xyz, uint32_t *cell, uint32_t *ids,
                                    uint32_t capacity, uint32_t *needed);

/** Whether a point can move from a [3] to b [3] without entering a ball: *same becomes 1 if both lie in one cell, else
 *  0. With a model grown by a probe this asks whether the probe's centre can go there. Statuses as
 *  hsp_topology_locate. */
HSP_API int32_t hsp_topology_same_cell(hsp_topology *topology, const double *a, const double *b, int32_t *same);

/** Check the invariants of a computed topology. If all hold, *invariant becomes 0 and *id HSP_NONE. Else
 *  *invariant becomes the number of the first that is violated, and
 *  *id that of the quarter-edge, vertex, simple face, shell or component concerned:
 *     1  the quad-edge algebra: properties 1 to 5 above
 *     2  origins are vertices, and every vertex starts an edge and is one ring of onext
 *     3  every simple face is one ring of at least two edges, on one ball, and no edge has it on both sides
 *     4  sides of arcs and circles lie on their balls, sides of cut edges on one
 *     5  vertices - edges + simple faces of each shell is the Euler characteristic that its maximal faces give
 *     6  the scan visits every simple face of a shell once and no other
 *     7  every component has one outer shell, every other shell walls one void, and the cells nest without cycles
 *     8  outer shells enclose a positive volume, voids' shells a negative one, up to rounding
 *  HSP_OK: all hold. HSP_E_CHECK: one is violated. HSP_E_ARGUMENT: a null pointer. HSP_E_STATE as above.
 *  Uses the topology's scratch memory, hence not const; results stay valid. Cost: O(size of the topology). */
HSP_API int32_t hsp_topology_check(hsp_topology *topology, uint32_t *invariant, uint32_t *id);

/* ---- view: hidden surface removal by the painter's order (Section 5.1) --------------------------------------------
 *
 * A view looks at the balls from infinitely far away. View coordinates: x to the right, y up, z towards the viewer, so
 * that a larger z is nearer; (x, y) is the view plane. What is painted of a ball is a piece of its front hemisphere:
 *   HSP_PIECES_OUTSIDE_FARTHER   the front hemisphere outside all farther balls (Lemma 5.3)
 *   HSP_PIECES_OUTSIDE_ALL   the front hemisphere outside all other balls: the front part of its faces (Theorem 5.1)
 * A ball is farther if its centre has the smaller z, exactly; of centres with equal z, the one of the ball that comes
 * first by (x, y, z, radius) of the caller's coordinates. Painting whole pieces from the farthest ball to the nearest
 * shows exactly what is visible. (The paper's theorem says "decreasing z" with viewing direction -z; back to front is
 * increasing z when the viewer is at z = +infinity.) G-pieces have fewer arcs, and as a farther ball goes on under a
 * nearer one, no background shows through the seams of anti-aliased pictures.
 *
 *   piece     what is painted of one ball; its loops together are one path, to be filled by either rule
 *   loop      a closed boundary of a piece, with the piece on its left: outer loops run counter-clockwise in the view
 *             plane (x right, y up), holes clockwise
 *   view arc  a part of the sphere's own silhouette, which is a circle in the view plane, or of its intersection with
 *             another sphere, which is an ellipse there
 * Silhouettes are cut by the same exact predicates as all circles: the half-space behind the centre is one more plane.
 * Ties are decided as everywhere (see the boundary). A ball of radius 0 and a ball inside another one have no piece. */

typedef struct hsp_view hsp_view;

/** The limits that fix a view's memory. */
typedef struct hsp_view_limits {
  uint32_t struct_size; /**< sizeof(hsp_view_limits) */
  uint32_t balls;       /**< number of balls of the model */
  uint32_t neighbours;  /**< most balls that meet any one ball that is not left out and lies inside no other */
  uint32_t arcs;        /**< arcs of all pieces; pieces and loops are never more */
} hsp_view_limits;

/** Limits that suffice for molecules of `balls` atoms: neighbours min(balls, 256), arcs 12 balls + 64.
 *  HSP_E_ARGUMENT: limits is NULL or struct_size is bad. HSP_E_RANGE: more than
 *  (HSP_MAX_BALLS - 64) / 12 balls; set the limits by hand then. */
HSP_API int32_t hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls);

/** Bytes that hsp_view_init needs. HSP_E_ARGUMENT: null pointer, bad struct_size. HSP_E_RANGE: a limit is larger than
 *  HSP_MAX_BALLS, or the size does not fit a size_t.
 *  Property 1: at most HSP_VIEW_BYTES of the three limits. Property 2: grows with each limit. */
HSP_API int32_t hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_VIEW_BYTES(balls, neighbours, arcs) \
  ((size_t)32768 + (size_t)192 * (size_t)(balls) + (size_t)384 * (size_t)(neighbours) + (size_t)64 * (size_t)(arcs))

/** Make an empty view in caller memory of any alignment; sets *view.
 *  HSP_E_ARGUMENT, HSP_E_RANGE as hsp_view_bytes; HSP_E_MEMORY: bytes too small (nothing is written). */
HSP_API int32_t hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view);

#define HSP_PIECES_OUTSIDE_FARTHER UINT32_C(0) /**< front hemispheres outside farther balls; needs no boundary */
#define HSP_PIECES_OUTSIDE_ALL UINT32_C(1)     /**< front hemispheres outside all balls; cut from a computed boundary */

/** Also give a piece to balls that are completely hidden behind others. Without this flag most of these are left out,
 *  which changes nothing that is seen, and pieces outside farther balls are cut by the remaining balls only. */
#define HSP_VIEW_ALL_BALLS UINT32_C(1)

/** From where to look, and what to cut. Zero means default in every field but the first. */
typedef struct hsp_view_options {
  uint32_t struct_size; /**< sizeof(hsp_view_options); hsp_view_options_init sets it */
  uint32_t pieces;      /**< HSP_PIECES_* */
  uint32_t flags;       /**< HSP_VIEW_* */
  uint32_t reserved;    /**< 0 */
  double towards[3];    /**< from the balls towards the viewer, of any length; default 0 0 1 */
  double up[3]; /**< what appears upwards, of any length, not necessarily across towards; default, and if it is parallel
                     to towards: 0 1 0, or 0 0 1 if towards is parallel to that */
} hsp_view_options;

/** Fill options with defaults. HSP_E_ARGUMENT: options is NULL or struct_size is bad. */
HSP_API int32_t hsp_view_options_init(hsp_view_options *options, uint32_t struct_size);

/** Set towards and up so that the balls appear turned: by x degrees about the x axis (right), then by y degrees about
 *  the y axis (up), then by z degrees about the z axis (towards the viewer), each counter-clockwise seen from the
 *  axis's positive end. In degrees, so that quarter turns are exact.
 *  HSP_E_ARGUMENT: options is NULL or its struct_size is wrong. HSP_E_NOT_FINITE: an angle is NaN or infinite.
 *  HSP_E_RANGE: an angle is beyond 1e6. On failure nothing is written. */
HSP_API int32_t hsp_view_options_turn(hsp_view_options *options, double x, double y, double z);

/** Cut and sort the pieces for one direction; any number of times, from any directions. boundary: one computed from the
 *  same model, so that a new direction costs only the cut and the sort; it may be NULL for G-pieces, which then
 *  come from the model alone (with it, balls without faces are skipped). options may be NULL (defaults). The model
 *  must outlive the view: after hsp_model_set the functions below return HSP_E_STATE until this one is called again;
 *  after hsp_model_init in the model's memory it must be called again before them. The boundary is not needed after
 *  the call.
 *  towards is rounded to integers with a largest component of 2^28, so that axes and diagonals are exact.
 *  limits: see LIMITS above; at most three retries.
 *  HSP_E_ARGUMENT: view or model NULL, bad options or struct_size of limits, no boundary for H-pieces or one of
 *  another model. HSP_E_STATE: the boundary holds no results. HSP_E_NOT_FINITE: a component of towards or up is NaN or
 *  infinite. HSP_E_CAPACITY: a limit is too small. On failure the view holds no results.
 *  Property 1: the order of the balls has no effect but on ids.
 *  Cost: O(n) to leave out hidden balls, O(m log m) to sort the m that are left, and for each of these O(k) at H-pieces
 *  and O(k^2) at G-pieces expected, with k balls that meet it. */
HSP_API int32_t hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary,
                                 const hsp_view_options *options, hsp_view_limits *limits);

/** What the view shows, and where. */
typedef struct hsp_view_info {
  double origin[3]; /**< the point with view coordinates 0 0 0: the middle of the balls' centres, length */
  double right[3];  /**< unit vectors: the axes of the view coordinates */
  double up[3];
  double towards[3];
  double low[2]; /**< of the view plane, the box of all pieces' silhouettes, length; 0 0 to 0 0 without pieces */
  double high[2];
  double depth_low; /**< z of the farthest and the nearest centre with a piece, length */
  double depth_high;
  uint32_t pieces;
  uint32_t loops;
  uint32_t arcs;
  uint32_t kind; /**< HSP_PIECES_* */
} hsp_view_info;

/** HSP_E_ARGUMENT: a null pointer. HSP_E_STATE: nothing computed, or the model has changed since. */
HSP_API int32_t hsp_view_get_info(const hsp_view *view, hsp_view_info *info);

typedef struct hsp_view_piece {
  double centre[2];    /**< of the ball, in the view plane, length */
  double depth;        /**< z of the ball's centre, length; rounded, while the order of the pieces is exact */
  double radius;       /**< of the ball, length */
  uint32_t ball;       /**< the caller's index */
  uint32_t first_loop; /**< its loops are first_loop .. first_loop + loops - 1 */
  uint32_t loops;
  uint32_t first_arc; /**< its arcs are first_arc .. first_arc + arcs - 1, loop after loop */
  uint32_t arcs;
  uint32_t reserved;
} hsp_view_piece;

/** The pieces in drawing order, farthest first; pieces without arcs (nothing to draw) are left out.
 *  HSP_E_ARGUMENT, HSP_E_STATE as hsp_view_get_info, HSP_E_CAPACITY as described above. */
HSP_API int32_t hsp_view_get_pieces(const hsp_view *view, hsp_view_piece *out, uint32_t capacity, uint32_t *needed);

typedef struct hsp_view_loop {
  uint32_t piece;     /**< index in hsp_view_get_pieces */
  uint32_t first_arc; /**< its arcs are first_arc .. first_arc + arcs - 1, each beginning where the one before ends */
  uint32_t arcs;      /**< at least 1: a whole circle or ellipse is one arc */
  uint32_t reserved;
} hsp_view_loop;

/** The loops, piece after piece. Statuses as hsp_view_get_pieces. */
HSP_API int32_t hsp_view_get_loops(const hsp_view *view, hsp_view_loop *out, uint32_t capacity, uint32_t *needed);

/** An arc of a circle or ellipse in the view plane: the points
 *      centre + semi_axis[0] cos(t) (cos rotation, sin rotation) + semi_axis[1] sin(t) (-sin rotation, cos rotation)
 *  for t from `from` to `to`; to > from: counter-clockwise, to < from: clockwise. */
typedef struct hsp_view_arc {
  double centre[2];    /**< length */
  double semi_axis[2]; /**< the larger and the smaller one, length; the smaller is 0 for a circle seen edge on */
  double rotation;     /**< of the larger one from the right, in (-pi, pi] */
  double from;         /**< in [-2 pi, 2 pi] */
  double to;           /**< at most 2 pi away from `from`; exactly 2 pi for a whole circle or ellipse */
  double start[2];     /**< the point at `from`, length; it is the end of the arc before, bit for bit */
  double end[2];       /**< the point at `to`, length */
  uint32_t piece;      /**< index in hsp_view_get_pieces */
  uint32_t other_ball; /**< the ball whose sphere it lies on too, the caller's index; HSP_NONE on the silhouette */
} hsp_view_arc;

/** The arcs, loop after loop. Statuses as hsp_view_get_pieces.
 *  Property 1: the arcs of a loop are closed: the end of each is the start of the next.
 *  Property 2: start and end agree with centre, semi-axes, rotation and parameters up to rounding. */
HSP_API int32_t hsp_view_get_arcs(const hsp_view *view, hsp_view_arc *out, uint32_t capacity, uint32_t *needed);

/* ---- pictures -----------------------------------------------------------------------------------------------------
 *
 * A view as a vector picture: one path per piece, true arcs, painted back to front. The bytes depend on the view,
 * the colours and the options alone, not on the machine.
 *   SVG   elliptical arcs; each path carries the caller's ball index as data-ball
 *   EPS   arcs of the unit circle under a matrix: exact
 *   PDF   cubic pieces of at most 45 degrees, within 4.3e-6 of the semi-axis of the arc
 */

/** Takes `count` bytes; returns 0 to go on and anything else to stop. */
typedef int32_t (*hsp_sink)(void *context, const char *bytes, size_t count);

#define HSP_FORMAT_SVG UINT32_C(0)
#define HSP_FORMAT_EPS UINT32_C(1)
#define HSP_FORMAT_PDF UINT32_C(2)

#define HSP_STYLE_FLAT UINT32_C(0)      /**< one colour per ball */
#define HSP_STYLE_HEADLIGHT UINT32_C(1) /**< light from the viewer, Lambert's law in 16 steps of a radial gradient */
#define HSP_STYLE_SOFT UINT32_C(2)      /**< light from the upper left, an approximation by a focal gradient */

#define HSP_UNIT_PX UINT32_C(0) /**< 1/96 inch */
#define HSP_UNIT_MM UINT32_C(1)

#define HSP_PICTURE_NO_IDS UINT32_C(1) /**< SVG without data-ball */
/** Nothing behind the balls; fog still fades to the background colour. */
#define HSP_PICTURE_NO_BACKGROUND UINT32_C(2)

/** What a picture looks like. hsp_picture_options_init sets the defaults; every field means what it says. */
typedef struct hsp_picture_options {
  uint32_t struct_size;    /**< sizeof(hsp_picture_options) */
  uint32_t format;         /**< HSP_FORMAT_*; default SVG */
  uint32_t style;          /**< HSP_STYLE_*; default flat */
  uint32_t unit;           /**< HSP_UNIT_* of width, height and outline; default px */
  double width;            /**< of the picture; 0: follows from height; less than 0.01 counts as 0.01; default 1000 */
  double height;           /**< likewise, from width; default 0. With both given the balls are centred */
  double margin;           /**< around the balls, as a part of the larger side of their box, in [0, 10]; default 0.03 */
  double outline;          /**< width of the lines along silhouettes and intersections; 0 (or less than 5e-5 px): none;
                                < 0: chosen; default -1 */
  double fog;              /**< how far the farthest ball fades to the background, in [0, 1]; default 0.3 */
  uint32_t outline_colour; /**< 0xRRGGBB; default 0x23202B */
  uint32_t background;     /**< 0xRRGGBB; default 0xFFFFFF */
  uint32_t flags;          /**< HSP_PICTURE_*; default 0 */
  uint32_t reserved;       /**< 0 */
} hsp_picture_options;

/** Fill options with defaults. HSP_E_ARGUMENT: options is NULL or struct_size is bad. */
HSP_API int32_t hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size);

#define HSP_PALETTE_SOFT UINT32_C(0)  /**< muted colours by element */
#define HSP_PALETTE_JMOL UINT32_C(1)  /**< Jmol's colours by element */
#define HSP_PALETTE_CHAIN UINT32_C(2) /**< a tint for each chain, carbon lighter than other elements */

/** A palette's colour, 0xRRGGBB, for an atomic number (0 or above 109: unknown) and a chain number 0, 1, ..: tints
 *  repeat after 12 chains. Palettes by element ignore the chain. An unknown palette counts as HSP_PALETTE_SOFT. */
HSP_API uint32_t hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain);

/** Write a picture of a computed view.
 *  colour [n] holds 0xRRGGBB for each ball of the model, NULL: all 0xD2CDC3. options may be NULL (defaults). title and
 *  description are NUL-terminated UTF-8 texts for the file, NULL or empty for none; what a format cannot hold is
 *  replaced by '?'. sink is called any number of times in order with at most 1024 bytes and is given `context`; bytes,
 *  if not NULL, becomes the number of bytes that the sink has taken.
 *  HSP_E_ARGUMENT: view or sink NULL, unknown format, style, unit or flag, reserved not 0, width and height both 0, a
 *  colour above 0xFFFFFF. HSP_E_NOT_FINITE: a value of options is NaN or infinite. HSP_E_RANGE: width or height
 *  negative or beyond 1e6, margin or fog beyond its range, outline beyond 1e6. HSP_E_STATE: the view holds no results.
 *  HSP_E_SINK: the sink refused. Apart from that the sink is called only if all is well.
 *  Uses the view's scratch memory, hence not const; results stay valid.
 *  Property 1: the same bytes for every order of the balls, up to the values of data-ball. (Of balls that are equal in
 *  centre and radius the first one counts, with its colour.)
 *  Cost: O(pieces log pieces + arcs); bytes proportional to arcs. */
HSP_API int32_t hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options,
                                  const char *title, const char *description, hsp_sink sink, void *context,
                                  uint64_t *bytes);

#ifdef __cplusplus
}
#endif

#endif
