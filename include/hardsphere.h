/* hardsphere: exact geometry of unions of balls (molecules), for C, C++ and Fortran.
 *
 * A molecule is n balls. The library answers the questions listed here about it, exactly and without allocating memory.
 * Each header can be included on its own, and names pages of the guide, capi/guide (as installed, guide beside
 * README.md). The list is the order in which to read the headers. Below it stands what all headers have in common.
 *   hardsphere/version.h    the version of the header and of the library
 *   hardsphere/status.h     the statuses that functions return
 *   hardsphere/executor.h   threads of the caller's, and a way to stop a computation
 *   hardsphere/element.h    elements by symbol, and their radii
 *   hardsphere/residue.h    radii by the names of residues and atoms
 *   hardsphere/model.h      a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2)
 *   hardsphere/query.h      which balls contain a point, meet a ball, or meet each other (Section 3)
 *   hardsphere/pose.h       a moved molecule against one at rest: hits, pairs, gaps (Sections 3 and 6)
 *   hardsphere/boundary.h   the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2)
 *   hardsphere/measure.h    areas and volumes
 *   hardsphere/gradient.h   derivatives of areas and volume
 *   hardsphere/moving.h     areas, volume and gradients while a few balls move at a time
 *   hardsphere/curvature.h  integrated mean and Gaussian curvature
 *   hardsphere/hessian.h    second derivatives of areas and volume
 *   hardsphere/bricks.h     sets too large for one memory, computed in parts
 *   hardsphere/contacts.h   which balls touch and by how much, shares of the union, the dual complex
 *   hardsphere/periodic.h   unions in a periodic box: areas, volume, contacts, windings, strain
 *   hardsphere/periodic_boundary.h  vertices, arcs, circles, faces in a periodic box
 *   hardsphere/surface.h    the smooth surface that a probe leaves, its area and volume (Section 4.3)
 *   hardsphere/mesh.h       boundary or smooth surface as triangles
 *   hardsphere/regions.h    cavities and other regions, their lining, shells, point location (Section 4.2, Step 3)
 *   hardsphere/topology.h   the boundary as quad-edges with simple faces (Step 3)
 *   hardsphere/cells.h      free space as simple cells, their neighbours, point location (Section 2)
 *   hardsphere/paths.h      how a probe gets from one point to another (Section 2)
 *   hardsphere/pores.h      free space for every probe at once: cavities, gates, tunnels, channels of crystals
 *   hardsphere/pockets.h    pockets between two probes, with mouths and sizes; regions of free space
 *   hardsphere/view.h       pieces in painter's order as true arcs (Section 5.1)
 *   hardsphere/map.h        the visibility map: faces, edges and vertices of the view plane (Section 5.2)
 *   hardsphere/sticks.h     balls and sticks in an order to paint them
 *   hardsphere/picture.h    a view, a map, or balls and sticks as SVG, EPS or PDF
 * A build may leave out components: hardsphere/components.h says which of them a library has.
 * The paper is Halperin and Overmars, "Spheres, Molecules, and Hidden Surface Removal", UU-CS-1994-36.
 *
 * WORDS
 *   probe        a ball that rolls over the others; its radius is added to all radii
 *   free         of a point of a sphere or circle: in no other ball
 *   vertex       a free point of three spheres
 *   arc, circle  a free part of the circle in which two spheres meet, between two vertices, or all of it
 *   face         a connected free part of one sphere
 *   exposed      of a ball: with at least one face; a buried ball has none
 *   boundary     all faces together: the boundary of the union of the balls
 *   shell        a connected component of the boundary
 *   component    a connected component of the union
 *   region, void a connected component of the rest of space; a void is one that the union encloses
 *   cell         a simple piece of free space; regions consist of cells (cells.h)
 *   share        of a ball: the part of the union nearer to it than to others, by power distance (contacts.h)
 *   rim          of a contact: the part of its border on the boundary
 *   degenerate   in a special position, as balls that touch or four spheres through a point; a tie is a decision there
 *
 * NAMES
 *   hsp_X_compute takes the input and computes the results of a handle; of models, bodies and balls that move its name
 *   is hsp_X_set. hsp_X_get_counts says how many records there are of each kind; hsp_X_get_info says that and more,
 *   such as the lattice or the frame of a view. hsp_X_measure, hsp_X_gradient and hsp_X_curvature write numbers, in
 *   total and of each ball, to arguments of their own. Functions with a request (REQUESTS AND OUTPUTS) have other names
 *   than those without: hsp_X_compute_with beside hsp_X_compute, likewise of other verbs, and hsp_X_get_measures,
 *   hsp_X_get_gradient, hsp_X_get_derivatives, hsp_X_get_morphometry, which fill outputs. A name with _with that does
 *   not exist may be added. Arguments are in this order: handle, input (balls, box, boundary, options or request),
 *   limits or outputs, first_bad; of outputs the totals first, then arrays, then capacity and needed. Euler
 *   characteristics are int64_t, as differences of counts of 32 bits. Yes or no is a uint32_t, 1 or 0, but a uint8_t in
 *   arrays of masks such as selected, as in other codes. The counts of hsp_moving_info are uint64_t, as no limit bounds
 *   them.
 *
 * TIERS
 *   Each header with functions says at its head to which of two tiers it belongs. The stable headers are those of the
 *   union of balls and its numbers: version, status, executor, element, model, query, boundary, measure, gradient,
 *   contacts, regions, topology. From 1.0 on they stay as they are, and are only added to; HSP_ABI_NUMBER counts their
 *   binary interface. All other headers are provisional: their contents may change with any minor version, with a line
 *   in the changelog and another HSP_PROVISIONAL_NUMBER (version.h). hardsphere_workspace.h, hardsphere.hpp and the
 *   Fortran modules are provisional, too; they are source that a program compiles, and no part of the binary interface.
 *   Results of both tiers are equally well tested.
 *
 * ARRAYS
 *   name          shape   type      unit      meaning
 *   xyz           [n][3]  double    length    centres, x y z of ball 0, then of ball 1, ...
 *   radius        [n]     double    length    radii, 0 allowed
 *   ids           [m]     uint32_t  -         ball indices, always 0-based, always the caller's own order
 *   area          [n]     double    length^2  free area of each ball
 *   volume_term   [n]     double    length^3  each ball's term of the volume (measure.h): no volume of an atom
 *   share_volume  [n]     double    length^3  volume of each ball's share: the volume of an atom
 * Lengths are in whatever unit the caller uses, and results are in the same unit. Angles are in radians.
 * Arrays and structs must be aligned as their types are; memory for handles need not be. Outputs must not overlap other
 * arguments of the call. No function keeps a pointer to arrays, structs or executors: they may change or go when it
 * returns.
 *
 * EXACTNESS
 *   Coordinates and radii are rounded once, to a decimal lattice: the nearest multiple of a step that is a power of
 *   ten (1e-8 for radii between 1.08 and 10.7). Text input with no more decimals than the lattice is represented
 *   exactly. Everything combinatorial is then decided in integers. Ties are decided as if every ball were larger by an
 *   infinitely small amount of its own (simulation of simplicity), so that balls that touch count as meeting.
 *   See hsp_model_set for the limits of the lattice.
 *
 * HOW EXACT
 *   header      decided in integers                rounded                          best effort, and what says so
 *   model       -                                  coordinates and radii, once, to  -
 *                                                  the lattice
 *   query       which balls, which first on a ray  a ray's direction, distances     -
 *   pose        hits and pairs                     positions of posed balls, once,  -
 *                                                  to the lattice, rational ones
 *                                                  not at all; gaps, overlaps
 *   boundary    vertices, arcs, circles, faces,    positions, radii, angles         -
 *               loops, shells, components
 *   measure     -                                  areas, volumes                   -
 *   gradient    what is flagged                    derivatives                      -
 *   moving      as boundary                        as measure and gradient          -
 *   curvature   multiples of pi/3 at vertices      mean curvature, derivatives      -
 *   hessian     what is flagged; which blocks      second derivatives               -
 *               there are
 *   bricks      counts of the whole                areas, volumes: sums of          -
 *                                                  integers, the same bits in any
 *                                                  order
 *   contacts    pairs, the dual complex, its       areas, distances, shares         -
 *               Betti numbers
 *   periodic    as boundary and contacts,          the box, once, to the lattice;   -
 *               windings, queries                  as measure, gradient and contacts
 *   surface     which patches there are and how    areas, volumes, derivatives      -
 *               they hang together
 *   mesh        how patches hang together          positions, normals               triangles where borders lie on each
 *                                                                                   other: HSP_E_DEGENERATE
 *   regions     shells, components, regions,       areas, volumes                   -
 *               balls that line them, where a
 *               point lies
 *   topology    edges, simple faces                positions                        -
 *   cells       cells, neighbours, regions,        -                                -
 *               where a point lies
 *   paths       whether there is one, what is      points, once, to the lattice;    a polyline through passages of a
 *               certified                          lengths                          few steps: hsp_path.certified
 *   pores       maxima, gates, their balls, what   points, levels                   -
 *               merges where, the order of levels
 *   pockets     maxima, mouths and balls of each,  areas, volumes                   where plugs cut a pocket off:
 *               regions                                                             hsp_pore_pocket_size.closed
 *   view        the order of pieces, their arcs    the direction, once; arcs        -
 *   map         -                                  areas                            faces, edges, vertices: balls are
 *                                                                                   moved until labels fit,
 *                                                                                   hsp_map_info.perturbation,
 *                                                                                   HSP_E_DEGENERATE
 *   sticks      -                                  as map                           what covers what, and as map:
 *                                                                                   HSP_E_CONFLICT, HSP_E_DEGENERATE
 *   picture     -                                  coordinates on the page          -
 *   A rounded number has an error of a few last bits of the result, or the function says how large it is.
 *
 * MEMORY
 *   The library never allocates. For a handle X: hsp_X_bytes tells the size, hsp_X_init carves the handle out of memory
 *   of any alignment that the caller owns. A handle dies with its memory; there is nothing to free; initialising the
 *   memory again resets it. Distinct handles may be used by distinct threads, and a handle that is passed as const may
 *   be read by any number of threads at a time. A handle is not const in functions that make, change or drop results,
 *   which have _set, _compute, _find, _move or _undo in their names; nor in these, which work in its own memory:
 *   hsp_model_get_packing; hsp_boundary_check, hsp_topology_check, hsp_contacts_check, hsp_periodic_check,
 *   hsp_surface_check, hsp_cells_check, hsp_map_check, hsp_sticks_check; hsp_contacts_group;
 *   hsp_periodic_group_contacts; hsp_pores_get_channels, _measure_pockets, _measure_pockets_with; hsp_picture_write,
 *   _write_map, _write_sticks. These leave results as they are, except that hsp_pores_measure_pockets changes regions
 *   and mouths (pockets.h).
 *   HSP_X_BYTES, at least as much as hsp_X_bytes of the library of this header, is for static arrays of a program that
 *   links the archive. It may grow with a minor version: a program that loads a shared library asks hsp_X_bytes.
 *   A handle must stay where it is made. A copy of a handle at another address, a handle of another kind, and memory
 *   that holds no handle any more are refused with HSP_E_HANDLE, also from a language that has one type for all
 *   pointers.
 *
 * RESULTS
 *   A handle that was computed from a model or a boundary (its source) reads the source when its results are read, so
 *   the source must outlive it. Results can be read while the source, in the same place, holds the same: a model the
 *   same balls in the same order on the same lattice, with the same probe and largest radius; a boundary the results of
 *   such a model. Else reading yields HSP_E_STATE. So results need no care when hsp_X_init makes the source again in
 *   the same place; and if the source takes the same balls again, results can be read again.
 *   Whether balls are the same is decided by a hash of 64 bits. Other balls have the same hash by accident with a
 *   probability of the order of 2^-64, or if they were constructed to.
 *   After the memory of the source was given back, or is used for something else, results must not be read any more:
 *   the library cannot notice. hsp_X_compute with NULL for the model or boundary drops results.
 *
 * FLOATING POINT
 *   A program may round to another direction, flush subnormal numbers to zero, as -ffast-math and -Ofast make it, and
 *   trap exceptions, as with -ffpe-trap: results are the same bits, and nothing traps. Every function that calculates
 *   sets the default environment for its thread, to nearest with neither flushing nor traps, and puts back the caller's
 *   with the flags that it had; so does every task of an executor in its thread. Functions of the caller's, such as the
 *   loop of an executor and a sink, run in the caller's environment, and changes that they make to it stay; proceed of
 *   an executor, which any thread may call, runs in a copy of it. All these functions must return: none may be left by
 *   longjmp or an exception. The environment is in MXCSR on x86, FPCR and FPSR on 64-bit Arm, FPSCR on 32-bit Arm and
 *   POWER, fcsr on RISC-V, FPC on s390x, FCSR on MIPS. WebAssembly and arithmetic in software have none; on other
 *   processors the library computes in the caller's environment.
 *
 * COST
 *   Functions that state no cost take O(1), and O(1) for each record that they write. In costs of the stable tier n is
 *   the number of balls, m the most balls that meet one ball, and c the most centres in 27 cubes of side 2 r_max: c is
 *   m times a constant where radii are of one size, and n where one ball is as large as all others together. "Expected"
 *   means that coordinates were not chosen to collide in hash tables; if they were, a search looks at up to 194 slots
 *   instead of some two (hsp_model_set). "At worst" is a bound for every set, and a set that comes near it is named. A
 *   bound in m is for one ball; the bounds of all balls add up. Logarithms of sorting the records of one ball are left
 *   out.
 *
 * LIMITS
 *   Limits fix the memory of a handle: of models and bodies a number of balls, of all others an hsp_X_limits. Such a
 *   struct is an array of uint32_t with struct_size first, and grows at its end, so that programs in any language can
 *   use it. hsp_X_compute hands limits back if its argument `limits` is not NULL. Its struct_size has to be set, which
 *   hsp_X_limits_init does.
 *   On HSP_E_CAPACITY *limits becomes limits to retry with: none is smaller than the handle's own, and at least one is
 *   larger. A limit that is not known yet stays as it was, so a few retries may be necessary. On HSP_OK *limits becomes
 *   exactly what was needed. On any other status it stays as it is. So memory grows until it suffices:
 *     while ((status = hsp_X_compute(x, ..., &limits)) == HSP_E_CAPACITY) {
 *       if (hsp_X_bytes(&limits, &bytes) != HSP_OK || (larger = realloc(memory, bytes)) == NULL) break;
 *       memory = larger;
 *       hsp_X_init(memory, bytes, &limits, &x);
 *     }
 *
 * STRUCTS
 *   A struct that begins with struct_size says how much of it a program knows, so that programs and libraries of
 *   different versions fit together. Fields that an older, smaller struct lacks have their default values. A newer,
 *   larger struct has a part that the library does not know: in a struct that is read this part must be zeros, else the
 *   status is HSP_E_VERSION; in a struct that is written it stays as it is or becomes zeros. Nothing is written beyond
 *   struct_size. A bad struct_size is HSP_E_VERSION, too: a smaller size that no version of the struct had, or a larger
 *   one above 1024 or no multiple of 4.
 *   All other structs are frozen: they stay as they are while the number of their header's tier (version.h) stays.
 *   Additions come as new structs and functions, or in place of reserved bytes, which are 0 until then.
 *
 * OUTPUT ARRAYS
 *   Where a function takes (T *out, uint32_t capacity, uint32_t *needed): *needed becomes the number of records that
 *   there are, on HSP_OK and on HSP_E_CAPACITY; needed may be NULL. If capacity is smaller the status is HSP_E_CAPACITY
 *   and nothing is written to out. out == NULL with capacity == 0 asks for the number: HSP_E_CAPACITY if there are
 *   records, HSP_OK if there are none. After the records, up to capacity, elements of out may be overwritten with their
 *   own values: capacity must not count elements that do not exist, or that another thread uses.
 *   Where a function takes (uint32_t first, uint32_t count, T *out), exactly the records first .. first + count - 1 are
 *   written, or none with HSP_E_ID. The counts tell how many records there are; out may be NULL with count == 0.
 *   The first form is for lists that are taken as a whole: hits of a query, records of one ball, face or shell, values
 *   for all balls, all records of a boundary. The second form is for structures that are walked by the numbers of their
 *   parts, such as quad-edges, half-edges, patches and free cells, and that may be read in parts. Where a function
 *   takes several arrays before the capacity, each of them may be NULL, and the capacity is that of each. Records are
 *   counted by a uint32_t: a list cannot have more than 2^32 - 1 pairs, which is some 16 for each ball of the largest
 *   sets.
 *
 * REQUESTS AND OUTPUTS
 *   A function with many arguments takes a request, which says what is asked, and outputs, which say where results go.
 *   Both begin with struct_size. In a request 0 or NULL means default, and the request may itself be NULL: all
 *   defaults. A pointer in outputs is NULL if its result is not wanted; capacity is that of each array [n], and needed
 *   becomes n. In C, with names:
 *     hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1.0};
 *     hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = n, .d_centre = gradient};
 *     status = hsp_boundary_get_gradient(boundary, &request, &outputs);
 *
 * STATUS
 *   Every function that can fail returns an int32_t: HSP_OK (0) or a negative number. On failure nothing but what the
 *   function's comment or the line of the status names is written. Treat an unknown negative number as a general
 *   failure. Every function that takes a handle may return HSP_E_HANDLE, though its comment does not list it: the
 *   pointer is not NULL, and there is no live handle of that kind at it. Nothing is written then, not even *first_bad
 *   and other outputs that comments name for failures. A handle that is NULL is HSP_E_ARGUMENT, like every pointer that
 *   must not be NULL. Functions that return an id, such as hsp_topology_onext, return HSP_NONE for both. Texts that
 *   functions return are constants. If more than one status fits, the first of these is returned: statuses of handles,
 *   in the order of arguments; HSP_E_VERSION; HSP_E_ARGUMENT; HSP_E_STATE; statuses of values, such as HSP_E_ID,
 *   HSP_E_NOT_FINITE, HSP_E_NEGATIVE and HSP_E_RANGE; HSP_E_CAPACITY, or HSP_E_MEMORY. HSP_E_CAPACITY comes before
 *   statuses of values from hsp_model_set and hsp_areas without room for all balls, and from hsp_mesh_compute without
 *   room for all balls and curves. Handles inside options or requests come behind versions and arguments.
 *
 * HANDLES AFTER A FAILURE
 *   hsp_X_set and hsp_X_compute replace what the handle held, whether they succeed or not. If one fails, for whatever
 *   reason, the handle has no contents, and functions that read them return HSP_E_STATE. So a model or body whose set
 *   has failed differs from the empty one that hsp_X_init makes: queries and every hsp_X_compute of it return
 *   HSP_E_STATE. Only hsp_model_get_info still answers: 0 balls, step 1e-8. A boundary, surface, mesh, topology, view,
 *   map, contacts, cells, paths, pores, sticks, a periodic union or balls that move hold no results, and reading them
 *   yields HSP_E_STATE.
 *   Functions with _find in their names drop what their last call found, whether they succeed or not, and nothing else.
 *   All other functions leave what a handle holds as it is, whatever they return; moving.h and pockets.h name two
 *   exceptions.
 */
#ifndef HARDSPHERE_H
#define HARDSPHERE_H

#include "hardsphere/boundary.h"
#include "hardsphere/components.h"
#include "hardsphere/contacts.h"
#include "hardsphere/element.h"
#include "hardsphere/executor.h"
#include "hardsphere/gradient.h"
#include "hardsphere/measure.h"
#include "hardsphere/model.h"
#include "hardsphere/query.h"
#include "hardsphere/regions.h"
#include "hardsphere/status.h"
#include "hardsphere/topology.h"
#include "hardsphere/version.h"
#if HSP_HAS_RESIDUES
#include "hardsphere/residue.h"
#endif
#if HSP_HAS_CURVATURE
#include "hardsphere/curvature.h"
#include "hardsphere/hessian.h"
#endif
#if HSP_HAS_MOTION
#include "hardsphere/moving.h"
#include "hardsphere/pose.h"
#endif
#if HSP_HAS_BRICKS
#include "hardsphere/bricks.h"
#endif
#if HSP_HAS_BOXES
#include "hardsphere/periodic.h"
#include "hardsphere/periodic_boundary.h"
#endif
#if HSP_HAS_SMOOTH
#include "hardsphere/mesh.h"
#include "hardsphere/surface.h"
#endif
#if HSP_HAS_SPACE
#include "hardsphere/cells.h"
#include "hardsphere/paths.h"
#include "hardsphere/pockets.h"
#include "hardsphere/pores.h"
#endif
#if HSP_HAS_SIGHT
#include "hardsphere/map.h"
#include "hardsphere/picture.h"
#include "hardsphere/sticks.h"
#include "hardsphere/view.h"
#endif

#endif
