/* hardsphere: exact geometry of unions of balls (molecules), for C, C++ and Fortran.
 *
 * A molecule is n balls. The library answers these questions about it, exactly and without allocating memory. Each
 * header can be included on its own and names pages of the guide, capi/guide (as installed, guide beside README.md);
 * this is the order to read them in. Below is what all of them have in common.
 *   hardsphere/version.h    the version of the header and of the library
 *   hardsphere/status.h     the statuses that functions return
 *   hardsphere/executor.h   threads of the caller's own
 *   hardsphere/element.h    elements by symbol, and their radii
 *   hardsphere/residue.h    radii by the names of residues and atoms
 *   hardsphere/model.h      a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2)
 *   hardsphere/query.h      which balls contain a point, meet a ball, or meet each other (Section 3)
 *   hardsphere/pose.h       a molecule against a moved one: hits, pairs, gaps (Sections 3 and 6)
 *   hardsphere/boundary.h   the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2)
 *   hardsphere/measure.h    areas and volumes
 *   hardsphere/gradient.h   their derivatives
 *   hardsphere/moving.h     all of that while a few balls move at a time
 *   hardsphere/curvature.h  integrated mean and Gaussian curvature
 *   hardsphere/hessian.h    second derivatives of areas and volume
 *   hardsphere/bricks.h     one set in parts that no memory holds together
 *   hardsphere/contacts.h   which balls touch and by how much, shares of the union, the dual complex
 *   hardsphere/periodic.h   all of that in a box whose copies fill space: areas, volume, contacts, windings, strain
 *   hardsphere/periodic_boundary.h  vertices, arcs, circles, faces in such a box
 *   hardsphere/surface.h    the smooth surface that a probe leaves, its area and volume (Section 4.3)
 *   hardsphere/mesh.h       boundary or smooth surface as triangles
 *   hardsphere/regions.h    cavities and other regions, what lines them, shells, point location (Section 4.2, Step 3)
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
 *   free         in no other ball
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
 *   hsp_X_compute, of models, bodies and balls that move hsp_X_set, takes what results are made of. hsp_X_get_counts
 *   says how many there are of each kind; hsp_X_get_info says that and what else is settled, such as the lattice or the
 *   frame of a view. hsp_X_measure, hsp_X_gradient and hsp_X_curvature give numbers, in all and of each ball, into
 *   arguments of their own. Functions with a request (REQUESTS AND OUTPUTS) have other names than those without:
 *   hsp_X_compute_with beside hsp_X_compute, likewise of other verbs, and hsp_X_get_measures, hsp_X_get_gradient,
 *   hsp_X_get_derivatives, hsp_X_get_morphometry, which fill outputs. A name with _with that is not there yet may come.
 *   Arguments are in this order: handle, what is asked about (balls, box, boundary, options or request), limits or
 *   outputs, first_bad; of outputs the totals first, then arrays, then capacity and needed. Euler characteristics are
 *   int64_t, as differences of counts that have 32 bits; yes or no is uint32_t, but in arrays of masks, such as
 *   selected, uint8_t, as other codes keep these. The counts of hsp_moving_info are uint64_t, as no limit bounds them.
 *
 * TIERS
 *   Each header with functions says at its head which of two tiers it is of. Stable are those of the union of balls and
 *   its numbers: version, status, executor, element, model, query, boundary, measure, gradient, contacts, regions,
 *   topology. From 1.0 on they stay as they are, and are only added to; HSP_ABI_NUMBER is theirs. All others are
 *   provisional: what stands there may change with any minor version, with a line in the changelog and
 *   HSP_PROVISIONAL_NUMBER (version.h). So are hardsphere_workspace.h, hardsphere.hpp and the Fortran modules, which
 *   are source that a program compiles and have no part in the binary interface. Results are as well tested in either.
 *
 * ARRAYS
 *   name          shape   type      unit      meaning
 *   xyz           [n][3]  double    length    centres, x y z of ball 0, then of ball 1, ...
 *   radius        [n]     double    length    radii, 0 allowed
 *   ids           [m]     uint32_t  -         ball indices, always 0-based, always the caller's own order
 *   area          [n]     double    length^2  free area of each ball
 *   volume_term   [n]     double    length^3  each ball's term of the volume: no volume of an atom
 *   share_volume  [n]     double    length^3  volume of each ball's share: the volume of an atom
 * Lengths are in whatever unit the caller uses, and results are in the same unit. Angles are in radians.
 * Arrays and structs are aligned as their types are; memory for handles need not be. Outputs overlap nothing else that
 * a call is given. No call keeps a pointer to arrays, structs or executors: they may change or go when it returns.
 *
 * EXACTNESS
 *   Coordinates and radii are rounded once, to a decimal lattice: the nearest multiple of a step that is a power of
 *   ten (1e-8 for radii between 1.08 and 10.7). Text input with no more decimals than the lattice is represented
 *   exactly. Everything combinatorial is then decided in integers; ties are decided as if every ball were
 *   larger by an infinitely small amount of its own, so that balls that touch count as meeting.
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
 *   be read by any number of threads at a time. It is not const where results are made, moved or dropped, by functions
 *   with _set, _compute, _find, _move or _undo in their names; nor in these, which work in its own memory:
 *   hsp_model_get_packing; hsp_boundary_check, hsp_topology_check, hsp_contacts_check, hsp_periodic_check,
 *   hsp_surface_check, hsp_cells_check, hsp_map_check, hsp_sticks_check; hsp_contacts_group;
 *   hsp_periodic_group_contacts; hsp_pores_get_channels, _measure_pockets, _measure_pockets_with; hsp_picture_write,
 *   _write_map, _write_sticks. These leave results as they are, but that those of pockets find mouths.
 *   HSP_X_BYTES, at least as much as hsp_X_bytes of the library of this header, is for static arrays of a program that
 *   links the archive. It may grow with a minor version: a program that loads a shared library asks hsp_X_bytes.
 *   A handle stays where it is made. A copy of one at another address, a handle of another kind and memory that holds
 *   no handle any more are refused with HSP_E_HANDLE, also where a language has one type for all pointers.
 *
 * RESULTS
 *   A result of a model or a boundary looks there when it is read, so that these must outlive it. It can be
 *   read while that handle, in the same place, holds the same: a model the same balls in the same order on the same
 *   lattice, with the same probe and largest radius; a boundary the results of such a model. Else reading it yields
 *   HSP_E_STATE. So nothing has to be done about results when hsp_X_init makes a handle again where it is, and those of
 *   balls that are taken once more can be read once more.
 *   Whether balls are the same is decided by 64 bits made of all that is known of them. Others have the same bits by
 *   accident with a probability of the order of 2^-64, or if somebody made them to.
 *   A result of a handle whose memory was given back, or is used for something else, must not be read any
 *   more: the library cannot know. hsp_X_compute with NULL for the model or boundary drops results.
 *
 * FLOATING POINT
 *   A program may round to another direction, flush subnormal numbers to zero, as -ffast-math and -Ofast make it, and
 *   trap exceptions, as with -ffpe-trap: results are the same bits, and nothing traps. Every function that calculates
 *   sets the default environment for its thread, to nearest with neither flushing nor traps, and puts back the caller's
 *   with the flags that it had; so does every task of an executor in its thread. Functions of the caller's, such as the
 *   loop of an executor and a sink, run in the caller's environment, and what they change of it stays; proceed of an
 *   executor, which any thread may call, runs in a copy of it. They return: none is left by longjmp or an exception.
 *   The environment is in MXCSR on x86, FPCR and FPSR on 64-bit Arm, FPSCR on 32-bit Arm and POWER, fcsr on RISC-V, FPC
 *   on s390x, FCSR on MIPS. WebAssembly and arithmetic in software have none; on other processors the library computes
 *   in that of the caller.
 *
 * COST
 *   Functions that state no cost take O(1), and O(1) for each record that they write. In costs of the stable tier n is
 *   the number of balls, m the most balls that meet one ball, and c the most centres in 27 cubes of side 2 r_max: m
 *   times a constant where radii are of one size, and n where one ball is as large as all others together. "Expected"
 *   is where no coordinates were chosen to collide in hash tables; where they were, a search looks at up to 194 slots
 *   instead of some two (hsp_model_set). "At worst" is a bound for every set, and a set that comes near it is named. A
 *   bound in m is that of one ball; those of all balls add up. Logarithms of what is sorted are left out where they are
 *   those of one ball's records.
 *
 * LIMITS
 *   Limits fix the memory of a handle: of models and bodies a number of balls, of all others an hsp_X_limits. That is
 *   an array of uint32_t, of which struct_size is the first, and grows at its end: so programs in any language may take
 *   it. hsp_X_compute hands such limits back, if its argument of that name is not NULL. Their struct_size has to be
 *   set, which hsp_X_limits_init does.
 *   On HSP_E_CAPACITY they are limits to retry with: none is smaller than the handle's own, and one at least is larger.
 *   A limit not known yet stays as it was, so that a few retries may be necessary. On HSP_OK they are what was needed,
 *   exactly. On any other status they stay as they are. So memory grows until it suffices:
 *     while ((status = hsp_X_compute(x, ..., &limits)) == HSP_E_CAPACITY) {
 *       if (hsp_X_bytes(&limits, &bytes) != HSP_OK || (larger = realloc(memory, bytes)) == NULL) break;
 *       memory = larger;
 *       hsp_X_init(memory, bytes, &limits, &x);
 *     }
 *
 * STRUCTS
 *   A struct that begins with struct_size says how much of it a program knows, so that programs and libraries of
 *   different versions fit together. Fields that an older, smaller one lacks have their default values. Of a
 *   struct that is read, what the library does not know of a newer, larger one has to be zeros, else the status is
 *   HSP_E_VERSION, as it is with a bad struct_size: a smaller one that no version of the struct had, or a larger one
 *   above 1024 or no multiple of 4. Of a struct that is written, such a part stays or becomes zeros; nothing is written
 *   beyond struct_size.
 *   All other structs are frozen: they stay as they are as long as the number of their header's tier does. Additions
 *   come as structs and functions of their own, or instead of reserved bytes, which are 0 until then.
 *
 * OUTPUT ARRAYS
 *   Where a function takes (T *out, uint32_t capacity, uint32_t *needed): *needed is set to the number of records there
 *   are, on HSP_OK and on HSP_E_CAPACITY; needed may be NULL. With capacity smaller than that the status is
 *   HSP_E_CAPACITY and nothing is written to out. out == NULL with capacity == 0 asks for the number: HSP_E_CAPACITY if
 *   there are records, HSP_OK if there are none. Behind the records, up to capacity, out may be written with what was
 *   there before: capacity must not count elements that are not there, or that another thread uses.
 *   Where a function takes (uint32_t first, uint32_t count, T *out), exactly the records first .. first + count - 1 are
 *   written, or none with HSP_E_ID. How many there are is known from the counts; out may be NULL with count == 0.
 *   The first form is that of lists which are taken as a whole: what a query finds, what belongs to one ball, face or
 *   shell, values for all balls, all records of a boundary. The second is that of structures which are walked by the
 *   numbers of their parts, such as quad-edges, half-edges, patches and free cells, and which may be read in parts.
 *   Where a function takes several arrays before the capacity, each of them may be NULL, and the capacity is that of
 *   each. Records are counted by a uint32_t: a list of more than 2^32 - 1 pairs, some 16 for each ball of the largest
 *   sets, is not possible.
 *
 * REQUESTS AND OUTPUTS
 *   A function with much to say takes a request, which says what is asked, and outputs, which say where results go.
 *   Both begin with struct_size. In a request 0 or NULL means default, and the request may itself be NULL: all
 *   defaults. A pointer in outputs is NULL where its result is not wanted; capacity is that of each array [n], needed
 *   becomes n. In C, with names:
 *     hsp_gradient_request request = {.struct_size = sizeof request, .tension = 1.0};
 *     hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = n, .d_centre = gradient};
 *     status = hsp_boundary_get_gradient(boundary, &request, &outputs);
 *
 * STATUS
 *   Every function that can fail returns an int32_t: HSP_OK (0) or a negative number. On failure nothing but what the
 *   function's comment or the line of the status names is written. Treat an unknown negative number as a general
 *   failure. Every function that takes a handle may return HSP_E_HANDLE, which is not said again at each of them: the
 *   pointer is not NULL, and there is no live handle of that kind. Nothing is written then, not even what comments
 *   name, such as *first_bad. A handle that is NULL is HSP_E_ARGUMENT, like every pointer that must not be NULL.
 *   Functions that return an id, such as hsp_topology_onext, return HSP_NONE for both. Texts that functions return are
 *   constants. Where more than one status fits, the first of these comes back: what is wrong with the handles, in the
 *   order of arguments; HSP_E_VERSION; HSP_E_ARGUMENT; HSP_E_STATE; what is wrong with values, such as HSP_E_ID,
 *   HSP_E_NOT_FINITE, HSP_E_NEGATIVE and HSP_E_RANGE; HSP_E_CAPACITY, or HSP_E_MEMORY. A model that has no room for all
 *   balls is HSP_E_CAPACITY before values are looked at.
 *
 * HANDLES AFTER A FAILURE
 *   hsp_X_set and hsp_X_compute replace what the handle held, whether they succeed or not. One that fails, for whatever
 *   reason, leaves the handle without contents: what reads these is HSP_E_STATE. So a model or body whose set has
 *   failed is not an empty one, as hsp_X_init makes it: queries and every hsp_X_compute of it are HSP_E_STATE, and
 *   hsp_model_get_info alone still answers: 0 balls, step 1e-8. A boundary, surface, mesh, topology, view, map,
 *   contacts, cells, paths, pores, sticks, a periodic union or balls that move hold no results, and reading them yields
 *   HSP_E_STATE.
 *   All other functions leave what a handle holds as it is, whatever they return.
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
