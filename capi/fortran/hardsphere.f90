! Generated from the headers by capi/interface/generate.sh.
!
! The Fortran module of hardsphere: the C interface of include/hardsphere.h, name for name.
!
! EVERY ID IN THIS MODULE IS 0-BASED, AS IN C: OF BALLS, VERTICES, ARCS, CIRCLES, FACES, SHELLS, COMPONENTS, EDGES,
! QUARTER-EDGES, SIMPLE FACES, CELLS, PIECES AND LOOPS.
! THE FORTRAN ARRAY ELEMENT OF ID i IS THEREFORE i + 1; hsp_index(i) COMPUTES THAT.
!
! What each function does, its statuses and its costs are documented in hardsphere.h; nothing of that changes here. A
! row with a name, such as `---- model.h`, begins what include/hardsphere/model.h declares.
! How C maps to Fortran:
!   double xyz[n][3]             real(c_double) :: xyz(3, n)
!   uint32_t onext[edges][4]     integer(c_int32_t) :: onext(0:3, 0:edges - 1), and indices are ids
!   uint32_t                     integer(c_int32_t); values above huge() appear negative: HSP_NONE is -1
!   uint8_t selected[n]          integer(c_int8_t) :: selected(n), 0 or not 0
!   hsp_model *, other handles   type(c_ptr); where NULL is allowed, c_null_ptr
!   void *memory                 type(c_ptr) from c_loc of an array with the TARGET attribute; the handle lives in it,
!                                so the array must outlive the handle and must not be reallocated
!   T *out, uint32_t capacity    out(*) with capacity elements; other extents stand behind the declarations
!   a pointer that may be NULL   an optional argument that is left out
!   const char *title            character(kind=c_char) :: title(*); a string that ends with c_null_char may be passed
!   hsp_sink                     type(c_funptr) from c_funloc of a function with the interface hsp_sink
!   void *context                type(c_ptr), as it will be handed to the sink; c_null_ptr if the sink has no use for it
module hardsphere
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_funptr, c_int8_t, c_int32_t, c_int64_t, &
                                         c_null_char, c_ptr, c_size_t
  implicit none
  private :: quad_turned
  private :: c_char, c_double, c_f_pointer, c_funptr, c_int8_t, c_int32_t, c_int64_t, c_null_char, c_ptr, c_size_t

  ! ---- version.h: the version of the header and of the library -------------------------------------------------------

  character(*), parameter :: HSP_VERSION_STRING = '0.2.0'
  integer(c_int32_t), parameter :: HSP_VERSION_MAJOR = 0_c_int32_t  ! 0 until the interface is frozen
  ! raised when something is added, and until 1.0 when something changes
  integer(c_int32_t), parameter :: HSP_VERSION_MINOR = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_VERSION_PATCH = 0_c_int32_t  ! raised when only mistakes were mended
  ! Version of this header: 10000 * major + 100 * minor + patch.
  integer(c_int32_t), parameter :: HSP_VERSION_NUMBER = 200_c_int32_t
  ! The binary interface that this header describes; the shared library's file name ends with it.
  integer(c_int32_t), parameter :: HSP_ABI_NUMBER = 1_c_int32_t
  ! The bits of the results that the library of this header gives.
  integer(c_int32_t), parameter :: HSP_NUMERICS_NUMBER = 2_c_int32_t

  ! ---- status.h: what functions return -------------------------------------------------------------------------------

  integer(c_int32_t), parameter :: HSP_OK = 0_c_int32_t  ! success
  ! a null pointer, an unknown option, or a value that is not allowed there
  integer(c_int32_t), parameter :: HSP_E_ARGUMENT = -1_c_int32_t
  ! an output array or a limit is too small; what suffices is reported
  integer(c_int32_t), parameter :: HSP_E_CAPACITY = -2_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_MEMORY = -3_c_int32_t  ! the memory is smaller than required
  ! nothing there to read, continue or undo, or what it was made from has changed
  integer(c_int32_t), parameter :: HSP_E_STATE = -4_c_int32_t
  ! no such ball, vertex, edge, face, shell, cell or element, or one listed twice
  integer(c_int32_t), parameter :: HSP_E_ID = -5_c_int32_t
  ! a violated invariant, or results that contradict each other: please report it
  integer(c_int32_t), parameter :: HSP_E_CHECK = -6_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_SINK = -7_c_int32_t  ! the caller's byte sink refused bytes
  ! no live handle of this kind: overwritten, moved, or of another kind
  integer(c_int32_t), parameter :: HSP_E_HANDLE = -8_c_int32_t
  ! a bad struct_size, or more asked for than this version of the library knows
  integer(c_int32_t), parameter :: HSP_E_VERSION = -9_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_NOT_FINITE = -10_c_int32_t  ! a value is NaN or infinite
  integer(c_int32_t), parameter :: HSP_E_NEGATIVE = -11_c_int32_t  ! a radius, the probe or the step is negative
  ! a value lies beyond the lattice or its range, or is no rotation or direction
  integer(c_int32_t), parameter :: HSP_E_RANGE = -12_c_int32_t
  ! balls and sticks that cannot be painted; which ones is reported
  integer(c_int32_t), parameter :: HSP_E_CONFLICT = -13_c_int32_t
  ! a degenerate set of balls, whose smooth surface does not close
  integer(c_int32_t), parameter :: HSP_E_OPEN_SURFACE = -14_c_int32_t

  ! ---- element.h: radii by element -----------------------------------------------------------------------------------

  ! Van der Waals radii of A. Bondi, J. Phys. Chem. 68 (1964) 441, completed for the main group by M. Mantina et al.,
  ! J. Phys. Chem. A 113 (2009) 5806, Table 12, with hydrogen 1.10 after R. S. Rowland and R. Taylor, J. Phys. Chem.
  ! 100 (1996) 7384. Published: all s- and p-block elements of the periods 1 to 6, Fr, Ra, Ni, Cu, Zn, Pd, Ag, Cd, Au,
  ! Hg and U.
  integer(c_int32_t), parameter :: HSP_RADII_BONDI = 0_c_int32_t
  ! The radii of the paper, Section 2, which are those of Chem3D Plus. Published: H, C, N, O, P, S and Ca.
  integer(c_int32_t), parameter :: HSP_RADII_CHEM3D = 1_c_int32_t
  ! The set's source has no radius for this element: the radius is a substitute.
  integer(c_int32_t), parameter :: HSP_RADIUS_FALLBACK = 1_c_int32_t

  ! ---- model.h: a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2) -----------------

  integer(c_int32_t), parameter :: HSP_NONE = -1_c_int32_t  ! The id that no ball has.
  integer(c_int32_t), parameter :: HSP_MAX_BALLS = 268435455_c_int32_t  ! The largest number of balls in one model.
  ! a ball has radius 0 (probe included): k has no value
  integer(c_int32_t), parameter :: HSP_PACKING_ZERO_RADIUS = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PACKING_COINCIDENT = 2_c_int32_t  ! two centres coincide: rho is 0
  ! fewer than two balls, or all radii 0: rho has no value
  integer(c_int32_t), parameter :: HSP_PACKING_NO_PAIR = 4_c_int32_t

  ! ---- query.h: which balls contain a point, meet a ball, or meet each other (Section 3) -----------------------------

  ! Each pair of balls i < j stands once, as j in the row of i. Without this flag it stands in the rows of both.
  integer(c_int32_t), parameter :: HSP_PAIRS_ONCE = 1_c_int32_t

  ! ---- boundary.h: the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2) ------------

  integer(c_int32_t), parameter :: HSP_MAX_WORKERS = 1024_c_int32_t  ! most workers of a boundary
  ! The symbolic perturbation decided about this vertex: a further sphere goes through it (of a ball that lies inside
  ! no other), or two of its circles only touch there.
  integer(c_int32_t), parameter :: HSP_VERTEX_TIED = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_BALL_CONTAINED = 1_c_int32_t  ! the ball lies inside one other ball

  ! ---- gradient.h: their derivatives ---------------------------------------------------------------------------------

  ! as if balls that touch overlapped by an infinitely small amount
  integer(c_int32_t), parameter :: HSP_TANGENT_OVERLAP = 0_c_int32_t
  ! as if they were apart by an infinitely small amount
  integer(c_int32_t), parameter :: HSP_TANGENT_DISJOINT = 1_c_int32_t
  ! The ball touches another at a free point: its derivatives are one-sided.
  integer(c_int32_t), parameter :: HSP_GRADIENT_ONE_SIDED = 1_c_int32_t

  ! ---- curvature.h: integrated mean and Gaussian curvature -----------------------------------------------------------

  ! The derivatives of the energy are those of one side, or it has none: as HSP_GRADIENT_ONE_SIDED, and besides where
  ! four spheres or more meet in a vertex of the ball, or one of its vertices is where two circles only touch.
  integer(c_int32_t), parameter :: HSP_CURVATURE_ONE_SIDED = 1_c_int32_t

  ! ---- contacts.h: which balls touch and by how much, shares of the union, the dual complex --------------------------

  integer(c_int32_t), parameter :: HSP_CONTACT_TOUCHING = 1_c_int32_t  ! the spheres only touch: area 0
  ! no part of its border is on the surface of the union
  integer(c_int32_t), parameter :: HSP_CONTACT_BURIED = 2_c_int32_t
  ! the whole disk, with all of its border on the surface
  integer(c_int32_t), parameter :: HSP_CONTACT_CIRCLE = 4_c_int32_t
  ! on the boundary of the union, and in no larger simplex
  integer(c_int32_t), parameter :: HSP_SIMPLEX_SINGULAR = 0_c_int32_t
  ! on the boundary, and in a larger simplex; triangles: on one side only
  integer(c_int32_t), parameter :: HSP_SIMPLEX_REGULAR = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_SIMPLEX_INTERIOR = 2_c_int32_t  ! not on the boundary

  ! ---- surface.h: the smooth surface that a probe leaves, its area and volume (Section 4.3) --------------------------

  ! The ball has a vertex of more than three spheres, or of three that its probe just fits between; or another ball is
  ! equal to it; or its sphere passes through a vertex or a whole circle that other balls have. Or its probe at a
  ! vertex touches another one in a point of the concave patch: exactly, if that stands on the other side of the same
  ! three balls, else up to rounding. Or, where weights differ, the plane of a saddle's narrowest place passes through
  ! a ball's centre, or one of two balls touches the other from inside.
  integer(c_int32_t), parameter :: HSP_SURFACE_DEGENERATE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PATCH_CONVEX = 0_c_int32_t  ! of a face
  integer(c_int32_t), parameter :: HSP_PATCH_SADDLE = 1_c_int32_t  ! of an arc
  integer(c_int32_t), parameter :: HSP_PATCH_CONCAVE = 2_c_int32_t  ! of a vertex
  integer(c_int32_t), parameter :: HSP_PATCH_CIRCLE_SADDLE = 3_c_int32_t  ! of a circle
  integer(c_int32_t), parameter :: HSP_SURFACE_RIM = 0_c_int32_t  ! between the patches of a face and an arc
  integer(c_int32_t), parameter :: HSP_SURFACE_CIRCLE_RIM = 1_c_int32_t  ! between those of a face and a circle
  integer(c_int32_t), parameter :: HSP_SURFACE_SIDE = 2_c_int32_t  ! between those of an arc and a vertex
  integer(c_int32_t), parameter :: HSP_SURFACE_CREASE = 3_c_int32_t  ! between those of two vertices
  integer(c_int32_t), parameter :: HSP_CORNER_BALL = 0_c_int32_t  ! of a convex, a concave and two saddle patches
  integer(c_int32_t), parameter :: HSP_CORNER_CUSP = 1_c_int32_t  ! where saddle patches meet their axis
  integer(c_int32_t), parameter :: HSP_CORNER_CREASE = 2_c_int32_t  ! of three concave patches

  ! ---- topology.h: the boundary as quad-edges with simple faces, shells, cells, point location (Step 3) --------------

  integer(c_int32_t), parameter :: HSP_POINT_VERTEX = 0_c_int32_t  ! a vertex of the boundary; its id is the same
  ! an added point of an arc or circle of ball[0] < ball[1]
  integer(c_int32_t), parameter :: HSP_POINT_CIRCLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_POINT_POLE = 2_c_int32_t  ! the highest or lowest point of the sphere of ball[0]
  integer(c_int32_t), parameter :: HSP_EDGE_ARC = 0_c_int32_t  ! an arc of hsp_boundary_get_arcs or a piece of one
  integer(c_int32_t), parameter :: HSP_EDGE_CIRCLE = 1_c_int32_t  ! a piece of a free circle
  ! a piece of a great circle that cuts a face; both sides lie on one ball
  integer(c_int32_t), parameter :: HSP_EDGE_CUT = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_SHELL_OUTER = 0_c_int32_t  ! bounds its component from outside
  integer(c_int32_t), parameter :: HSP_SHELL_VOID = 1_c_int32_t  ! bounds a void inside its component

  ! ---- cells.h: what no ball covers as simple cells, their neighbours, point location (Section 2) --------------------

  integer(c_int32_t), parameter :: HSP_CELL_RUN = 0_c_int32_t  ! cubes that no ball meets
  ! a free part of the power cell of a ball that meets that power cell
  integer(c_int32_t), parameter :: HSP_CELL_AT_BALL = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_CELL_APART = 2_c_int32_t  ! a whole power cell, which its ball does not meet

  ! ---- paths.h: how a probe gets from one point to another, and how wide one may be (Section 2) ----------------------

  integer(c_int32_t), parameter :: HSP_PATH_CONNECTED = 0_c_int32_t  ! there is a path
  integer(c_int32_t), parameter :: HSP_PATH_APART = 1_c_int32_t  ! the ends lie in two regions of free space
  integer(c_int32_t), parameter :: HSP_PATH_COVERED = 2_c_int32_t  ! at least one of the ends lies in a ball

  ! ---- view.h: pieces in painter's order as true arcs (Section 5.1) --------------------------------------------------

  ! front hemispheres outside farther balls; needs no boundary
  integer(c_int32_t), parameter :: HSP_PIECES_OUTSIDE_FARTHER = 0_c_int32_t
  ! front hemispheres outside all balls; cut from a computed boundary
  integer(c_int32_t), parameter :: HSP_PIECES_OUTSIDE_ALL = 1_c_int32_t
  ! Also give a piece to balls that are completely hidden behind others. Without this flag most of these are left out,
  ! which changes nothing that is seen, and pieces outside farther balls are cut by the remaining balls only.
  integer(c_int32_t), parameter :: HSP_VIEW_ALL_BALLS = 1_c_int32_t

  ! ---- map.h: what is seen as faces, edges and vertices of the view plane (Section 5.2) ------------------------------

  integer(c_int32_t), parameter :: HSP_MAP_PLAIN = 0_c_int32_t  ! on a closed curve without other vertices
  integer(c_int32_t), parameter :: HSP_MAP_TRIPLE = 1_c_int32_t  ! where three creases meet
  integer(c_int32_t), parameter :: HSP_MAP_T = 2_c_int32_t  ! where a curve goes behind a silhouette
  integer(c_int32_t), parameter :: HSP_MAP_TANGENCY = 3_c_int32_t  ! where a crease goes over into a silhouette
  ! where halves of a stick meet at their outline; in sticks.h only
  integer(c_int32_t), parameter :: HSP_MAP_HALVES = 4_c_int32_t

  ! ---- sticks.h: balls and sticks in an order to paint them ----------------------------------------------------------

  ! A stick that is not cut in two: all of it belongs to ball[0]. For halves of the same colour, which else have a line
  ! between them.
  integer(c_int32_t), parameter :: HSP_STICK_WHOLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_NO_CONFLICT = 0_c_int32_t  ! there is none
  integer(c_int32_t), parameter :: HSP_STICKS_BALLS_MEET = 1_c_int32_t  ! two balls that meet: no order, but HSP_OK
  integer(c_int32_t), parameter :: HSP_STICKS_NO_BALL = 2_c_int32_t  ! a stick, and its end, which is no ball
  ! two sticks between the same balls; or a stick twice, whose ends are one
  integer(c_int32_t), parameter :: HSP_STICKS_SAME_ENDS = 3_c_int32_t
  ! a stick, and the ball at its end, which is not thicker
  integer(c_int32_t), parameter :: HSP_STICKS_THIN_BALL = 4_c_int32_t
  ! two sticks that meet outside the ball in which both end
  integer(c_int32_t), parameter :: HSP_STICKS_SHARP_ANGLE = 5_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_MEET = 6_c_int32_t  ! two other sticks that meet
  ! a stick, and a ball that it meets and does not end in
  integer(c_int32_t), parameter :: HSP_STICKS_STICK_IN_BALL = 7_c_int32_t
  ! a stick of a circle of balls and halves of sticks, each of which covers a part of the next; and how many they are:
  ! no order, but HSP_OK
  integer(c_int32_t), parameter :: HSP_STICKS_CYCLE = 8_c_int32_t

  ! ---- picture.h: a view, a map, or balls and sticks as SVG, EPS or PDF ----------------------------------------------

  integer(c_int32_t), parameter :: HSP_FORMAT_SVG = 0_c_int32_t  ! Scalable Vector Graphics 1.1
  integer(c_int32_t), parameter :: HSP_FORMAT_EPS = 1_c_int32_t  ! Encapsulated PostScript, language level 3
  integer(c_int32_t), parameter :: HSP_FORMAT_PDF = 2_c_int32_t  ! PDF 1.4, compressed PDF 1.5; one page
  integer(c_int32_t), parameter :: HSP_STYLE_FLAT = 0_c_int32_t  ! one colour per ball
  ! light from the viewer, Lambert's law in 16 steps of a radial gradient
  integer(c_int32_t), parameter :: HSP_STYLE_HEADLIGHT = 1_c_int32_t
  ! light from the upper left, an approximation by a focal gradient
  integer(c_int32_t), parameter :: HSP_STYLE_SOFT = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_UNIT_PX = 0_c_int32_t  ! 1/96 inch
  integer(c_int32_t), parameter :: HSP_UNIT_MM = 1_c_int32_t  ! millimetres
  integer(c_int32_t), parameter :: HSP_PICTURE_NO_IDS = 1_c_int32_t  ! SVG without data-ball, and without ids of balls
  ! Nothing behind the balls; fog still fades to the background colour.
  integer(c_int32_t), parameter :: HSP_PICTURE_NO_BACKGROUND = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_INK_BORDER = 0_c_int32_t  ! before the background
  ! before a ball of another group: at least width min(1, 2 g)
  integer(c_int32_t), parameter :: HSP_INK_GROUP = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_INK_DEPTH = 2_c_int32_t  ! before a ball of the same group
  integer(c_int32_t), parameter :: HSP_PICTURE_MEMORY = 71680_c_int32_t  ! Bytes of memory that compression takes.
  integer(c_int32_t), parameter :: HSP_PALETTE_SOFT = 0_c_int32_t  ! muted colours by element
  integer(c_int32_t), parameter :: HSP_PALETTE_JMOL = 1_c_int32_t  ! Jmol's colours by element
  ! a tint for each chain, carbon lighter than other elements
  integer(c_int32_t), parameter :: HSP_PALETTE_CHAIN = 2_c_int32_t

  ! ---- model.h: a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2) -----------------

  type, bind(C) :: hsp_model_options
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_model_options); hsp_model_options_init sets it
    integer(c_int32_t) :: reserved     ! 0
    ! length, >= 0: added to every radius, for the solvent-accessible surface; default 0
    real(c_double) :: probe
    ! length, > 0: the lattice step; 0 means the smallest power of ten with r_max/step < 2^30
    real(c_double) :: step
    ! length, > 0: r_max less the probe, for balls of which none may be larger; 0: that of the balls
    real(c_double) :: largest_radius
  end type

  type, bind(C) :: hsp_model_info
    integer(c_int32_t) :: balls          ! number of balls
    integer(c_int32_t) :: cubes          ! cubes of side 2 r_max that hold a centre (Section 3)
    integer(c_int32_t) :: table_slots    ! slots of the open-addressing table; at least twice the number of cubes
    integer(c_int32_t) :: longest_probe  ! most slots looked at to find a cube that is there
    real(c_double) :: step               ! the lattice step, length
    real(c_double) :: probe              ! the probe as rounded to the lattice, length
    real(c_double) :: largest_radius     ! r_max, probe included, as rounded to the lattice, length
  end type

  type, bind(C) :: hsp_packing
    real(c_double) :: k                 ! r_max / r_min; 0 where it has no value (no balls, HSP_PACKING_ZERO_RADIUS)
    real(c_double) :: rho               ! min over pairs of |c_i c_j| / max(r_i, r_j); 0 where it has no value
    ! mean over the balls of the number of others with |c_i c_j| < r_i + r_j; 0 if n = 0
    real(c_double) :: mean_overlaps
    ! 216 (k/rho)^3 of Theorem 2.1: no ball meets more others; 0 where it says nothing
    real(c_double) :: neighbour_bound
    integer(c_int32_t) :: max_overlaps  ! the largest of those numbers
    integer(c_int32_t) :: flags         ! HSP_PACKING_*; 0 means that Theorem 2.1 holds with this k and rho
  end type

  ! ---- query.h: which balls contain a point, meet a ball, or meet each other (Section 3) -----------------------------

  type, bind(C) :: hsp_ray_hit
    real(c_double) :: xyz(3)        ! the point, length; 0 if there is none
    real(c_double) :: distance      ! of the point from the origin, length; infinite if there is none
    integer(c_int32_t) :: ball      ! the caller's index; HSP_NONE: the ray meets no ball
    integer(c_int32_t) :: reserved  ! 0
  end type

  ! ---- pose.h: a molecule against a moved one: hits, pairs, gaps (Sections 3 and 6) ----------------------------------

  type, bind(C) :: hsp_pose
    real(c_double) :: quaternion(4)   ! w x y z, of any length but 0: the rotation R; 1 0 0 0 is none
    real(c_double) :: translation(3)  ! t, lengths
  end type

  type, bind(C) :: hsp_body_gap
    ! length: |c - c'| - r - r', least of all pairs; negative for the pair that overlaps deepest
    real(c_double) :: gap
    integer(c_int32_t) :: fixed   ! ball of the body at rest; HSP_NONE if a body has no balls: the gap is infinite then
    integer(c_int32_t) :: moving  ! ball of the moving body, likewise
  end type

  type, bind(C) :: hsp_body_overlap
    real(c_double) :: volume        ! length^3: the intersections of all pairs of balls, summed pair by pair
    integer(c_int32_t) :: pairs     ! pairs that meet; 2^32 - 1 if there are more
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_rational_pose
    integer(c_int32_t) :: quaternion(4)  ! w x y z, not all 0, of any length: the rotation R; 1 0 0 0 is none
    real(c_double) :: translation(3)     ! t, lengths; what counts is the lattice point nearest to it
  end type

  ! ---- boundary.h: the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2) ------------

  type, bind(C) :: hsp_boundary_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_boundary_limits)
    integer(c_int32_t) :: balls        ! most balls of the model
    integer(c_int32_t) :: neighbours   ! most balls that meet any one ball that lies inside no other
    integer(c_int32_t) :: vertices     ! vertices of the boundary
    integer(c_int32_t) :: circles      ! free circles
    integer(c_int32_t) :: workers      ! most workers of hsp_boundary_begin; 0 is 1. Comes back as it is
  end type

  type, bind(C) :: hsp_boundary_counts
    integer(c_int32_t) :: balls            ! balls of the model
    integer(c_int32_t) :: exposed_balls    ! balls with at least one face
    integer(c_int32_t) :: contained_balls  ! balls inside one other ball (of several equal balls, all but one)
    integer(c_int32_t) :: vertices         ! points where three spheres meet
    integer(c_int32_t) :: arcs             ! between two vertices, each counted once
    integer(c_int32_t) :: circles          ! whole circles that are free
    integer(c_int32_t) :: faces            ! maximal free pieces of spheres
    integer(c_int32_t) :: loops            ! boundary loops of all faces
    integer(c_int32_t) :: shells           ! connected components of the boundary
    integer(c_int32_t) :: components       ! connected components of the union
    integer(c_int32_t) :: voids            ! bounded components of the complement of the union
    integer(c_int32_t) :: tied_vertices    ! vertices with HSP_VERTEX_TIED
    integer(c_int64_t) :: euler            ! Euler characteristic of the boundary, summed over its shells
  end type

  type, bind(C) :: hsp_vertex
    real(c_double) :: xyz(3)        ! position, length
    integer(c_int32_t) :: ball(3)   ! its balls a < b < c
    integer(c_int32_t) :: sign      ! +1 or -1: the side of the plane of the centres, along (c_b - c_a) x (c_c - c_a)
    integer(c_int32_t) :: flags     ! HSP_VERTEX_*
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_arc
    real(c_double) :: centre(3)      ! of its circle, length
    real(c_double) :: axis(3)        ! unit vector from c_a towards c_b
    real(c_double) :: radius         ! of its circle, length
    real(c_double) :: angle          ! from vertex[0] to vertex[1], in [0, 2 pi]
    integer(c_int32_t) :: ball(2)    ! its two balls a < b
    integer(c_int32_t) :: vertex(2)  ! where it starts and where it ends
    integer(c_int32_t) :: face(2)    ! the face on ball a and the face on ball b
  end type

  type, bind(C) :: hsp_circle
    real(c_double) :: centre(3)    ! length
    real(c_double) :: axis(3)      ! unit vector from c_a towards c_b
    real(c_double) :: radius       ! length
    integer(c_int32_t) :: ball(2)  ! its two balls a < b
    integer(c_int32_t) :: face(2)  ! the face on ball a and the face on ball b
  end type

  type, bind(C) :: hsp_face
    integer(c_int32_t) :: ball        ! the ball it lies on
    integer(c_int32_t) :: loops       ! its boundary loops; 0 for a whole sphere
    integer(c_int32_t) :: shell       ! 0 .. shells - 1
    integer(c_int32_t) :: first_loop  ! its loops are first_loop .. first_loop + loops - 1 of hsp_boundary_get_loops
  end type

  type, bind(C) :: hsp_loop
    integer(c_int32_t) :: face       ! the face that it bounds
    ! the free circle that it is, whose face[side] is `face`; HSP_NONE if it consists of arcs
    integer(c_int32_t) :: circle
    integer(c_int32_t) :: side       ! 1: a circle counter-clockwise about its axis; 0: a circle clockwise, or arcs
    integer(c_int32_t) :: first_arc  ! its arcs are first_arc .. first_arc + arcs - 1 of hsp_boundary_get_loop_arcs
    integer(c_int32_t) :: arcs       ! at least 2; 0 for a circle
  end type

  type, bind(C) :: hsp_loop_arc
    integer(c_int32_t) :: arc     ! index in hsp_boundary_get_arcs
    integer(c_int32_t) :: side    ! 1: the loop runs along it, 0: against it; its face[side] is that of the loop
    integer(c_int32_t) :: vertex  ! where the loop comes to it: its vertex[1 - side]; vertex[side] is the next one's
  end type

  type, bind(C) :: hsp_ball
    integer(c_int32_t) :: faces       ! number of its faces; 0: the ball is buried
    integer(c_int32_t) :: first_face  ! id of the first of them, HSP_NONE if there is none
    integer(c_int32_t) :: component   ! connected component of the union, 0 .. components - 1
    integer(c_int32_t) :: flags       ! HSP_BALL_*
  end type

  ! ---- measure.h: areas and volumes ----------------------------------------------------------------------------------

  type, bind(C) :: hsp_totals
    real(c_double) :: area    ! of the boundary, walls of voids included, length^2
    real(c_double) :: volume  ! of the union, voids not included, length^3
  end type

  ! ---- gradient.h: their derivatives ---------------------------------------------------------------------------------

  type, bind(C) :: hsp_energy
    real(c_double) :: value    ! E = tension * sum_i sigma_i A_i + pressure * V
    real(c_double) :: area     ! sum_i sigma_i A_i
    real(c_double) :: volume   ! V
    real(c_double) :: d_probe  ! dE/d(probe) = sum of all dE/dr_i
  end type

  type, bind(C) :: hsp_area_derivative
    real(c_double) :: centre(3)  ! dA_i/dc_j, length
    real(c_double) :: radius     ! dA_i/dr_j, length
    real(c_double) :: angle      ! sum of the angles of the free arcs of the circle of i and j that count; 0 for j = i
    integer(c_int32_t) :: ball   ! j
    integer(c_int32_t) :: flags  ! HSP_GRADIENT_ONE_SIDED if i and j touch; for j = i if another entry has it
  end type

  ! ---- moving.h: all of that while a few balls move at a time --------------------------------------------------------

  type, bind(C) :: hsp_moving_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_moving_limits)
    integer(c_int32_t) :: balls        ! most balls
    integer(c_int32_t) :: neighbours   ! most balls that meet any one ball that lies inside no other
  end type

  type, bind(C) :: hsp_moving_info
    real(c_double) :: step                 ! the lattice step, length
    real(c_double) :: probe                ! as rounded to the lattice, length
    real(c_double) :: largest_radius       ! the largest that a ball may have, probe included, length
    integer(c_int64_t) :: vertices         ! as in hsp_boundary_counts, and so on
    integer(c_int64_t) :: arcs             ! between two vertices, each counted once
    integer(c_int64_t) :: circles          ! whole circles that are free
    integer(c_int64_t) :: faces            ! maximal free pieces of spheres
    integer(c_int64_t) :: loops            ! boundary loops of all faces
    integer(c_int32_t) :: balls            ! number of balls
    integer(c_int32_t) :: exposed_balls    ! balls with at least one face
    integer(c_int32_t) :: contained_balls  ! balls inside one other ball (of several equal balls, all but one)
    integer(c_int32_t) :: components       ! connected components of the union
    integer(c_int32_t) :: changed          ! how many balls hsp_moving_get_changed lists
    integer(c_int32_t) :: reserved         ! 0
  end type

  type, bind(C) :: hsp_moving_ball
    real(c_double) :: centre(3)           ! as rounded to the lattice, length
    real(c_double) :: radius              ! likewise, probe included
    real(c_double) :: area                ! its free area, length^2
    real(c_double) :: volume              ! its term of the volume, see hsp_boundary_measure
    real(c_double) :: d_centre(3)         ! derivative of the energy by its centre
    real(c_double) :: d_radius            ! and by its radius
    integer(c_int32_t) :: faces           ! number of its faces; 0: the ball is buried
    integer(c_int32_t) :: flags           ! HSP_BALL_*
    integer(c_int32_t) :: gradient_flags  ! HSP_GRADIENT_*
    integer(c_int32_t) :: reserved        ! 0
  end type

  ! ---- curvature.h: integrated mean and Gaussian curvature -----------------------------------------------------------

  type, bind(C) :: hsp_curvatures
    real(c_double) :: mean   ! M, length
    real(c_double) :: gauss  ! G = pi/3 times the sum of gauss_thirds
  end type

  type, bind(C) :: hsp_morphometry
    real(c_double) :: pressure  ! of the volume
    real(c_double) :: tension   ! of the weighted area
    real(c_double) :: bending   ! of the weighted mean curvature
    real(c_double) :: gaussian  ! of the Gaussian curvature
  end type

  type, bind(C) :: hsp_morphometric_energy
    real(c_double) :: value    ! pressure V + tension sum sigma_i A_i + bending M(sigma) + gaussian G
    real(c_double) :: volume   ! V
    real(c_double) :: area     ! sum sigma_i A_i
    ! M(sigma) = sum sigma_i A_i / r_i - 1/2 sum of l beta (sigma_i + sigma_j) / 2 over the edges
    real(c_double) :: mean
    real(c_double) :: gauss    ! G
    real(c_double) :: d_probe  ! the derivative by the probe, the sum of all d_radius
  end type

  ! ---- contacts.h: which balls touch and by how much, shares of the union, the dual complex --------------------------

  type, bind(C) :: hsp_contacts_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_contacts_limits)
    integer(c_int32_t) :: balls        ! most balls of the model
    integer(c_int32_t) :: neighbours   ! as in hsp_boundary_limits
    integer(c_int32_t) :: contacts     ! contacts, each once
    integer(c_int32_t) :: triangles    ! triangles to keep for hsp_contacts_get_simplices; 0: they are only counted
    integer(c_int32_t) :: tetrahedra   ! the same of tetrahedra
  end type

  type, bind(C) :: hsp_contact
    real(c_double) :: area             ! length^2
    real(c_double) :: edge             ! length of the part of its border that is on the surface of the union
    real(c_double) :: distance         ! of the two centres
    integer(c_int32_t) :: ball(2)      ! its two balls a < b
    integer(c_int32_t) :: chords       ! straight sides
    integer(c_int32_t) :: flags        ! HSP_CONTACT_*
    integer(c_int32_t) :: reserved(2)  ! 0
  end type

  type, bind(C) :: hsp_group_contact
    real(c_double) :: area          ! of all contacts between them
    real(c_double) :: edge          ! length of their borders on the surface of the union
    integer(c_int32_t) :: group(2)  ! the groups g < h
    integer(c_int32_t) :: contacts  ! how many
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_complex
    integer(c_int32_t) :: singular(4)  ! simplices of HSP_SIMPLEX_SINGULAR: balls, edges, triangles, tetrahedra
    integer(c_int32_t) :: regular(4)   ! of HSP_SIMPLEX_REGULAR
    integer(c_int32_t) :: interior(4)  ! of HSP_SIMPLEX_INTERIOR
    integer(c_int32_t) :: euler        ! balls - edges + triangles - tetrahedra
    integer(c_int32_t) :: betti(3)     ! of the union: components, independent tunnels, voids
  end type

  type, bind(C) :: hsp_simplex
    integer(c_int32_t) :: ball(4)   ! ascending; ball[3] of a triangle is HSP_NONE
    integer(c_int32_t) :: kind      ! HSP_SIMPLEX_*
    integer(c_int32_t) :: reserved  ! 0
  end type

  ! ---- periodic.h: all of that in a box whose copies fill space: areas, volume, contacts, windings, strain -----------

  type, bind(C) :: hsp_periodic_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_periodic_limits)
    integer(c_int32_t) :: balls        ! most balls
    integer(c_int32_t) :: images       ! images of them that are near the box
    integer(c_int32_t) :: neighbours   ! as in hsp_boundary_limits
    integer(c_int32_t) :: vertices     ! of balls in the box; those across its faces once from each side
    integer(c_int32_t) :: circles      ! the same
    integer(c_int32_t) :: contacts     ! the same
  end type

  type, bind(C) :: hsp_periodic_counts
    integer(c_int32_t) :: balls       ! n
    integer(c_int32_t) :: images      ! that were made of them
    integer(c_int32_t) :: vertices    ! points of three spheres
    integer(c_int32_t) :: arcs        ! between two vertices
    integer(c_int32_t) :: circles     ! whole free circles
    integer(c_int32_t) :: loops       ! as in hsp_boundary_counts
    integer(c_int32_t) :: faces       ! as in hsp_boundary_counts
    integer(c_int32_t) :: shells      ! connected components of the boundary; which is outside which has no meaning
    integer(c_int32_t) :: components  ! connected components of the union
    integer(c_int32_t) :: contacts    ! pairs of balls, or of a ball and an image, in contact
    integer(c_int32_t) :: euler       ! V - E + sum over faces of (2 - loops): twice that of the union
    integer(c_int32_t) :: reserved    ! 0
  end type

  type, bind(C) :: hsp_periodic_totals
    real(c_double) :: area          ! of the boundary, length^2
    real(c_double) :: volume        ! of the union, length^3
    real(c_double) :: box_volume    ! of the box on the lattice
    real(c_double) :: free_volume   ! box_volume less volume; 0 exactly if there is no boundary but there are balls
    real(c_double) :: contact_area  ! of all contacts, each once
  end type

  type, bind(C) :: hsp_periodic_contact
    real(c_double) :: area          ! length^2
    real(c_double) :: edge          ! length of the part of its border that is on the surface of the union
    real(c_double) :: distance      ! of the two centres
    integer(c_int32_t) :: ball(2)   ! its two balls a <= b
    integer(c_int32_t) :: chords    ! straight sides
    integer(c_int32_t) :: flags     ! HSP_CONTACT_* of hardsphere/contacts.h
    ! times the vectors of the box that ball b is to be moved by, both where they were given
    integer(c_int32_t) :: shift(3)
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_winding
    integer(c_int32_t) :: balls       ! how many belong to it
    integer(c_int32_t) :: first       ! the first of them
    ! 0 to 3: in how many independent directions it goes on for ever; 0: it ends on all sides
    integer(c_int32_t) :: directions
    ! how many copies of it are apart from each other where it goes: with directions 3 so many interpenetrating nets,
    ! else those in the line or plane of one. 1 if directions is 0; HSP_NONE if there are more
    integer(c_int32_t) :: copies
    ! of the lattice of its windings, in multiples of the vectors of the box: as many rows of three as directions, in
    ! echelon form with positive pivots and smaller numbers above them: equal lattices have equal rows; the rest is 0
    integer(c_int32_t) :: row(9)
  end type

  type, bind(C) :: hsp_image
    integer(c_int32_t) :: ball      ! the caller's index
    integer(c_int32_t) :: shift(3)  ! times the vectors of the box that it is to be moved by from where it was given
  end type

  ! ---- periodic_boundary.h: vertices, arcs, circles, faces in such a box ---------------------------------------------

  type, bind(C) :: hsp_periodic_id
    integer(c_int32_t) :: id        ! index in its list
    integer(c_int32_t) :: shift(3)  ! times the vectors of the box that it is to be moved by from where it is listed
  end type

  type, bind(C) :: hsp_periodic_vertex
    real(c_double) :: xyz(3)     ! position, length
    type(hsp_image) :: image(3)  ! its balls a, b, c, the first one at its place
    integer(c_int32_t) :: sign   ! +1 or -1: the side of the plane of the centres, along (c_b - c_a) x (c_c - c_a)
    integer(c_int32_t) :: flags  ! HSP_VERTEX_* of hardsphere/boundary.h
  end type

  type, bind(C) :: hsp_periodic_arc
    real(c_double) :: centre(3)         ! of its circle, length
    real(c_double) :: axis(3)           ! unit vector from c_a towards c_b
    real(c_double) :: radius            ! of its circle, length
    real(c_double) :: angle             ! from vertex[0] to vertex[1], in [0, 2 pi]
    type(hsp_image) :: image(2)         ! its balls a and b, the first one at its place
    type(hsp_periodic_id) :: vertex(2)  ! where it starts and where it ends
    type(hsp_periodic_id) :: face(2)    ! the face on ball a and the face on ball b
  end type

  type, bind(C) :: hsp_periodic_circle
    real(c_double) :: centre(3)       ! length
    real(c_double) :: axis(3)         ! unit vector from c_a towards c_b
    real(c_double) :: radius          ! length
    type(hsp_image) :: image(2)       ! its balls a and b, the first one at its place
    type(hsp_periodic_id) :: face(2)  ! the face on ball a and the face on ball b
  end type

  type, bind(C) :: hsp_periodic_face
    type(hsp_image) :: image          ! the ball it lies on, at its place
    integer(c_int32_t) :: loops       ! its boundary loops; 0 for a whole sphere
    integer(c_int32_t) :: shell       ! 0 .. counts.shells - 1, in the order of their first faces
    integer(c_int32_t) :: first_loop  ! its loops are first_loop .. first_loop + loops - 1 of hsp_periodic_get_loops
    integer(c_int32_t) :: reserved    ! 0
  end type

  type, bind(C) :: hsp_periodic_loop
    ! the circle that it is, where its face is listed; id HSP_NONE if it consists of arcs
    type(hsp_periodic_id) :: circle
    integer(c_int32_t) :: face       ! the face that it bounds
    integer(c_int32_t) :: side       ! 1: a circle counter-clockwise about its axis; 0: a circle clockwise, or arcs
    integer(c_int32_t) :: first_arc  ! its arcs are first_arc .. first_arc + arcs - 1 of hsp_periodic_get_loop_arcs
    integer(c_int32_t) :: arcs       ! at least 2; 0 for a circle
  end type

  type, bind(C) :: hsp_periodic_loop_arc
    type(hsp_periodic_id) :: arc     ! of hsp_periodic_get_arcs
    type(hsp_periodic_id) :: vertex  ! where the loop comes to it: vertex[1 - side] of the arc, moved with it
    integer(c_int32_t) :: side       ! 1: the loop runs along it, 0: against it; its face[side] is that of the loop
    integer(c_int32_t) :: reserved   ! 0
  end type

  ! ---- surface.h: the smooth surface that a probe leaves, its area and volume (Section 4.3) --------------------------

  type, bind(C) :: hsp_surface_limits
    integer(c_int32_t) :: struct_size     ! sizeof(hsp_surface_limits)
    integer(c_int32_t) :: vertices        ! vertices of the boundary
    integer(c_int32_t) :: faces           ! faces of the boundary
    integer(c_int32_t) :: neighbours      ! most probes at other vertices that may cut any one concave patch
    ! what is left of the concave patches that are cut: at least one for each of them
    integer(c_int32_t) :: pieces
    integer(c_int32_t) :: arcs            ! that bound these pieces
    integer(c_int32_t) :: cusped_circles  ! circles whose saddle patches reach their axis
  end type

  type, bind(C) :: hsp_surface_counts
    integer(c_int32_t) :: convex_patches   ! faces of the boundary
    integer(c_int32_t) :: saddle_patches   ! arcs and circles of the boundary
    integer(c_int32_t) :: concave_patches  ! vertices of the boundary
    integer(c_int32_t) :: cusped_patches   ! of the saddle patches, those that their axis cuts
    integer(c_int32_t) :: cut_patches      ! of the concave patches, those that other probes cut
    integer(c_int32_t) :: hidden_patches   ! of these, those of which nothing is left
    integer(c_int32_t) :: rounded_patches  ! of the concave patches, those decided in integers after rounding
    integer(c_int32_t) :: open_joints      ! corners, creases and pieces of cut patches that do not fit: see above
  end type

  type, bind(C) :: hsp_surface_totals
    real(c_double) :: area          ! of all patches, length^2
    real(c_double) :: volume        ! inside the surface, voids not included, length^3
    real(c_double) :: convex_area   ! length^2
    real(c_double) :: saddle_area   ! length^2
    real(c_double) :: concave_area  ! length^2
  end type

  type, bind(C) :: hsp_surface_map_counts
    integer(c_int32_t) :: patches    ! of all kinds
    integer(c_int32_t) :: edges      ! of all kinds
    integer(c_int32_t) :: corners    ! of all kinds
    integer(c_int32_t) :: shells     ! connected components of the surface
    integer(c_int32_t) :: cusps      ! of the corners, cusps
    integer(c_int32_t) :: junctions  ! of the corners, those where three creases meet
    integer(c_int32_t) :: creases    ! of the edges, creases
    integer(c_int32_t) :: reserved   ! 0
  end type

  type, bind(C) :: hsp_surface_patch
    real(c_double) :: area          ! length^2
    integer(c_int32_t) :: kind      ! HSP_PATCH_*
    integer(c_int32_t) :: source    ! face, arc, circle or vertex of the boundary
    ! of a saddle patch with cusps, 0 at ball 0, 1 at ball 1; of a cut patch, the piece 0, 1, ...
    integer(c_int32_t) :: part
    integer(c_int32_t) :: shell     ! HSP_NONE if nothing is left of it
    integer(c_int32_t) :: loops     ! around it; 0 for a whole sphere, and if nothing is left of it
    integer(c_int32_t) :: edges     ! of all its loops
    integer(c_int32_t) :: h         ! a directed edge with this patch on its left; HSP_NONE if it has none
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_surface_edge
    real(c_double) :: centre(3)        ! of its circle, length
    real(c_double) :: axis(3)          ! unit vector; 0 if the circle has no size
    real(c_double) :: radius           ! of its circle, length
    real(c_double) :: angle            ! counter-clockwise about the axis, in [0, 2 pi]
    integer(c_int32_t) :: patch(2)     ! on its left and on its right
    integer(c_int32_t) :: corner(2)    ! where it starts and ends; HSP_NONE for a whole circle
    integer(c_int32_t) :: next(2)      ! after 2 edge around patch[0], after 2 edge + 1 around patch[1]
    integer(c_int32_t) :: previous(2)  ! before them
    integer(c_int32_t) :: kind         ! HSP_SURFACE_*
    integer(c_int32_t) :: source       ! arc or circle of the boundary; of a crease, HSP_NONE
  end type

  type, bind(C) :: hsp_surface_corner
    real(c_double) :: xyz(3)         ! position, length
    integer(c_int32_t) :: kind       ! HSP_CORNER_*
    ! the ball it lies on; of a cusp, those of its circle, the one on its side first; else HSP_NONE
    integer(c_int32_t) :: ball(2)
    integer(c_int32_t) :: vertex(3)  ! the vertex, or the three of its concave patches; else HSP_NONE
    ! HSP_NONE for the cusp of a whole circle; a cusp may be one of a shell of each part
    integer(c_int32_t) :: shell
    integer(c_int32_t) :: reserved   ! 0
  end type

  type, bind(C) :: hsp_surface_shell
    real(c_double) :: area         ! length^2
    real(c_double) :: volume       ! of what it encloses, length^3; negative if that is outside of the solid
    integer(c_int32_t) :: euler    ! Euler characteristic
    integer(c_int32_t) :: genus    ! 1 - euler/2: number of handles
    integer(c_int32_t) :: patches  ! how many it consists of
    integer(c_int32_t) :: chosen   ! 1; of the rest that hsp_surface_compute_shells left out, 0
  end type

  ! ---- mesh.h: boundary or smooth surface as triangles ---------------------------------------------------------------

  type, bind(C) :: hsp_mesh_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_mesh_limits)
    integer(c_int32_t) :: balls        ! of the model; of a smooth surface, balls and vertices of the boundary
    integer(c_int32_t) :: curves       ! arcs and circles of the boundary; of a smooth surface, its edges
    integer(c_int32_t) :: vertices     ! of the mesh, with those that finer ones have replaced
    integer(c_int32_t) :: triangles    ! of the mesh, with those that finer ones have replaced
    integer(c_int32_t) :: points       ! most points of any one sphere while it is triangulated
  end type

  type, bind(C) :: hsp_mesh_counts
    integer(c_int32_t) :: vertices   ! of the triangles
    integer(c_int32_t) :: triangles  ! of the mesh
    integer(c_int32_t) :: curves     ! arcs and circles of the boundary; edges of the smooth surface
    integer(c_int32_t) :: refined    ! of these, those that got more points than their length demands
  end type

  ! ---- topology.h: the boundary as quad-edges with simple faces, shells, cells, point location (Step 3) --------------

  type, bind(C) :: hsp_topology_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_topology_limits)
    integer(c_int32_t) :: balls        ! most balls of the model
    integer(c_int32_t) :: neighbours   ! as in hsp_boundary_limits
    integer(c_int32_t) :: edges        ! edges; vertices and simple faces are never more
    integer(c_int32_t) :: cut_arcs     ! cut arcs that cut faces with several loops
    integer(c_int32_t) :: shells       ! shells; 0: as many as the edges allow, two for each. Fewer take less memory
  end type

  type, bind(C) :: hsp_topology_counts
    integer(c_int32_t) :: vertices      ! those of the boundary and the added ones
    integer(c_int32_t) :: edges         ! of all kinds
    integer(c_int32_t) :: simple_faces  ! what the maximal faces are cut into
    integer(c_int32_t) :: cut_edges     ! of the edges, the ones that cut a face or a whole sphere
    integer(c_int32_t) :: shells        ! connected components of the boundary
    integer(c_int32_t) :: components    ! of the union
    integer(c_int32_t) :: cells         ! of the complement: 1 + voids
    ! the simple face that holds the highest point of all; HSP_NONE if there are no balls
    integer(c_int32_t) :: start_face
  end type

  type, bind(C) :: hsp_topology_vertex
    real(c_double) :: xyz(3)        ! position, length
    integer(c_int32_t) :: ball(3)   ! the balls whose spheres meet there, ascending, HSP_NONE for those there are not
    integer(c_int32_t) :: kind      ! HSP_POINT_*
    integer(c_int32_t) :: q         ! a quarter-edge that starts there
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_topology_edge
    real(c_double) :: centre(3)      ! of its circle, length
    ! unit vector; the edge runs counter-clockwise about it, its left face lies on the axis's side
    real(c_double) :: axis(3)
    real(c_double) :: radius         ! of its circle, length
    real(c_double) :: angle          ! from origin to destination, in [0, 2 pi]
    integer(c_int32_t) :: vertex(2)  ! origin and destination
    integer(c_int32_t) :: face(2)    ! simple faces on its left and right
    integer(c_int32_t) :: ball(2)    ! balls of these faces
    integer(c_int32_t) :: kind       ! HSP_EDGE_*
    integer(c_int32_t) :: source     ! id of the boundary's arc or circle it is a piece of; HSP_NONE for cut edges
  end type

  type, bind(C) :: hsp_simple_face
    integer(c_int32_t) :: ball      ! the ball it lies on
    integer(c_int32_t) :: face      ! the maximal face of hsp_boundary_get_faces that it is a part of
    integer(c_int32_t) :: edges     ! on its loop, at least 2
    integer(c_int32_t) :: q         ! the quarter-edge, even, of one of them, with this face on its left
    integer(c_int32_t) :: shell     ! the shell it belongs to
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_shell
    real(c_double) :: area              ! length^2
    real(c_double) :: volume            ! of the space it encloses, whatever lies in it, length^3
    real(c_double) :: point(3)          ! a point of it, length
    integer(c_int32_t) :: euler         ! Euler characteristic: vertices - edges + simple faces
    integer(c_int32_t) :: genus         ! 1 - euler/2: number of handles
    integer(c_int32_t) :: kind          ! HSP_SHELL_*
    integer(c_int32_t) :: component     ! of the union, as in hsp_ball
    integer(c_int32_t) :: cell          ! of the complement, on its other side
    integer(c_int32_t) :: faces         ! maximal faces
    integer(c_int32_t) :: simple_faces  ! and what they are cut into
    integer(c_int32_t) :: edges         ! edges of its simple faces
    integer(c_int32_t) :: vertices      ! vertices of these edges
    ! simple face where its scan starts: of an outer shell the one with its highest point, of a void the first one on
    ! its ball of lowest rank (x, y, z, radius)
    integer(c_int32_t) :: start_face
  end type

  type, bind(C) :: hsp_component
    integer(c_int32_t) :: balls        ! how many it consists of
    integer(c_int32_t) :: top_ball     ! the ball with its highest point
    integer(c_int32_t) :: outer_shell  ! the one shell of kind HSP_SHELL_OUTER
    integer(c_int32_t) :: shells       ! outer shell and voids
    integer(c_int32_t) :: cell         ! the cell it lies in: 0 or a void of another component
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_cell
    real(c_double) :: area                 ! of all its shells, length^2
    real(c_double) :: volume               ! of the cell itself, what lies in it left out, length^3; of cell 0: 0
    integer(c_int32_t) :: enclosing_shell  ! the shell of kind HSP_SHELL_VOID around it; HSP_NONE for cell 0
    integer(c_int32_t) :: components       ! components of the union that lie in it
    integer(c_int32_t) :: shells           ! shells that bound it
    integer(c_int32_t) :: reserved         ! 0
  end type

  ! ---- cells.h: what no ball covers as simple cells, their neighbours, point location (Section 2) --------------------

  type, bind(C) :: hsp_cells_limits
    integer(c_int32_t) :: struct_size   ! sizeof(hsp_cells_limits)
    integer(c_int32_t) :: cubes         ! that balls meet
    integer(c_int32_t) :: entries       ! pairs of a ball and a cube that it meets
    integer(c_int32_t) :: cells         ! free parts and runs
    integer(c_int32_t) :: adjacencies   ! pairs of neighbours
    integer(c_int32_t) :: landmarks     ! vertices of power cells with several free parts
    integer(c_int32_t) :: facets        ! of power cells on sides between two cubes that balls meet, each side once
    integer(c_int32_t) :: corners       ! of all these facets
    integer(c_int32_t) :: cube_balls    ! most balls that meet one cube; rarely some more
    integer(c_int32_t) :: cube_corners  ! vertices of all power cells of one cube
  end type

  type, bind(C) :: hsp_cells_counts
    integer(c_int32_t) :: cubes        ! that balls meet
    integer(c_int32_t) :: power_cells  ! in all of these, free or not
    integer(c_int32_t) :: cells        ! free parts and runs
    integer(c_int32_t) :: runs         ! of these
    integer(c_int32_t) :: adjacencies  ! pairs of neighbours
    integer(c_int32_t) :: regions      ! connected components of free space: 1 + voids
  end type

  type, bind(C) :: hsp_free_cell
    ! the box that holds it: of a run itself, else its cube; length, infinite without an end
    real(c_double) :: low(3)
    real(c_double) :: high(3)         ! likewise
    integer(c_int32_t) :: ball        ! whose power cell it is a part of; HSP_NONE for a run
    ! 0 .. cubes - 1, those with the lowest z first, of these with the lowest y; HSP_NONE
    integer(c_int32_t) :: cube
    integer(c_int32_t) :: kind        ! HSP_CELL_*
    integer(c_int32_t) :: region      ! what it belongs to
    integer(c_int32_t) :: neighbours  ! how many it has
    integer(c_int32_t) :: reserved    ! 0
  end type

  type, bind(C) :: hsp_cell_pair
    integer(c_int32_t) :: cell(2)  ! numbers of cells
  end type

  type, bind(C) :: hsp_arrangement
    integer(c_int64_t) :: vertices  ! where three spheres meet
    integer(c_int64_t) :: edges     ! on circles of two spheres
    integer(c_int64_t) :: faces     ! on spheres
  end type

  ! ---- paths.h: how a probe gets from one point to another, and how wide one may be (Section 2) ----------------------

  type, bind(C) :: hsp_paths_limits
    integer(c_int32_t) :: struct_size   ! sizeof(hsp_paths_limits)
    integer(c_int32_t) :: cubes         ! as hsp_cells_limits.cubes
    integer(c_int32_t) :: entries       ! as hsp_cells_limits.entries
    integer(c_int32_t) :: cells         ! as hsp_cells_limits.cells
    integer(c_int32_t) :: adjacencies   ! as hsp_cells_limits.adjacencies
    integer(c_int32_t) :: landmarks     ! as hsp_cells_limits.landmarks
    integer(c_int32_t) :: facets        ! as hsp_cells_limits.facets
    integer(c_int32_t) :: corners       ! as hsp_cells_limits.corners
    integer(c_int32_t) :: cube_balls    ! as hsp_cells_limits.cube_balls
    integer(c_int32_t) :: cube_corners  ! as hsp_cells_limits.cube_corners
    integer(c_int32_t) :: points        ! of a path before it is shortened
  end type

  type, bind(C) :: hsp_path
    real(c_double) :: length         ! of the polyline; 0 if there is none
    ! least distance of the polyline from a ball; 0 if there is none, infinite without balls
    real(c_double) :: clearance
    integer(c_int32_t) :: ends       ! HSP_PATH_*, exactly
    integer(c_int32_t) :: certified  ! whether no segment meets a ball, exactly: 1 or 0
    integer(c_int32_t) :: points     ! 2 or more with the ends; 0 if there is none
    integer(c_int32_t) :: reserved   ! 0
  end type

  type, bind(C) :: hsp_gate_limits
    integer(c_int32_t) :: struct_size   ! sizeof(hsp_gate_limits)
    integer(c_int32_t) :: balls         ! of the model
    integer(c_int32_t) :: cubes         ! as hsp_cells_limits.cubes
    integer(c_int32_t) :: entries       ! as hsp_cells_limits.entries
    integer(c_int32_t) :: cells         ! as hsp_cells_limits.cells
    integer(c_int32_t) :: adjacencies   ! as hsp_cells_limits.adjacencies
    integer(c_int32_t) :: landmarks     ! as hsp_cells_limits.landmarks
    integer(c_int32_t) :: facets        ! as hsp_cells_limits.facets
    integer(c_int32_t) :: corners       ! as hsp_cells_limits.corners
    integer(c_int32_t) :: cube_balls    ! as hsp_cells_limits.cube_balls
    integer(c_int32_t) :: cube_corners  ! as hsp_cells_limits.cube_corners
  end type

  type, bind(C) :: hsp_widest_probe
    ! added to the radii of the model; 0 if not even a point passes, infinite without balls
    real(c_double) :: radius
    integer(c_int32_t) :: passes    ! whether a point does, exactly: 1 or 0
    integer(c_int32_t) :: gate(3)   ! the balls that stop a wider one, ascending, HSP_NONE behind the last
    integer(c_int32_t) :: builds    ! how often free space was cut into cells
    integer(c_int32_t) :: reserved  ! 0
  end type

  ! ---- view.h: pieces in painter's order as true arcs (Section 5.1) --------------------------------------------------

  type, bind(C) :: hsp_view_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_view_limits)
    integer(c_int32_t) :: balls        ! most balls of the model
    integer(c_int32_t) :: neighbours   ! most balls that meet any one ball that is not left out and lies inside no other
    integer(c_int32_t) :: arcs         ! arcs of all pieces; pieces and loops are never more
  end type

  type, bind(C) :: hsp_view_options
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_view_options); hsp_view_options_init sets it
    integer(c_int32_t) :: pieces       ! HSP_PIECES_*
    integer(c_int32_t) :: flags        ! HSP_VIEW_*
    integer(c_int32_t) :: reserved     ! 0
    real(c_double) :: towards(3)       ! from the balls towards the viewer, of any length; default 0 0 1
    ! what appears upwards, of any length, not necessarily across towards; default, and if it is parallel to towards: 0
    ! 1 0, or 0 0 1 if towards is parallel to that
    real(c_double) :: up(3)
  end type

  type, bind(C) :: hsp_view_info
    real(c_double) :: origin(3)   ! the point with view coordinates 0 0 0: the middle of the balls' centres, length
    real(c_double) :: right(3)    ! unit vector: the x axis of the view coordinates
    real(c_double) :: up(3)       ! unit vector: the y axis
    real(c_double) :: towards(3)  ! unit vector: the z axis
    real(c_double) :: low(2)      ! of the box of all pieces' silhouettes in the view plane, length; 0 0 without pieces
    real(c_double) :: high(2)     ! of the same box
    real(c_double) :: depth_low   ! z of the farthest centre with a piece, length
    real(c_double) :: depth_high  ! z of the nearest centre with a piece, length
    integer(c_int32_t) :: pieces  ! number of pieces
    integer(c_int32_t) :: loops   ! of all pieces
    integer(c_int32_t) :: arcs    ! of all loops
    integer(c_int32_t) :: kind    ! HSP_PIECES_*
  end type

  type, bind(C) :: hsp_view_piece
    real(c_double) :: centre(2)       ! of the ball, in the view plane, length
    real(c_double) :: depth           ! z of the ball's centre, length; rounded, while the order of the pieces is exact
    real(c_double) :: radius          ! of the ball, length
    integer(c_int32_t) :: ball        ! the caller's index
    integer(c_int32_t) :: first_loop  ! its loops are first_loop .. first_loop + loops - 1
    integer(c_int32_t) :: loops       ! at least 1
    integer(c_int32_t) :: first_arc   ! its arcs are first_arc .. first_arc + arcs - 1, loop after loop
    integer(c_int32_t) :: arcs        ! at least 1
    integer(c_int32_t) :: reserved    ! 0
  end type

  type, bind(C) :: hsp_view_loop
    integer(c_int32_t) :: piece      ! index in hsp_view_get_pieces
    ! its arcs are first_arc .. first_arc + arcs - 1, each beginning where the one before ends
    integer(c_int32_t) :: first_arc
    integer(c_int32_t) :: arcs       ! at least 1: a whole circle or ellipse is one arc
    integer(c_int32_t) :: reserved   ! 0
  end type

  type, bind(C) :: hsp_view_arc
    real(c_double) :: centre(2)       ! length
    ! the larger and the smaller one, length; the smaller is 0 for a circle seen edge on
    real(c_double) :: semi_axis(2)
    real(c_double) :: rotation        ! of the larger one from the right, in (-pi, pi]
    real(c_double) :: from            ! in [-2 pi, 2 pi]
    real(c_double) :: to              ! at most 2 pi away from `from`; exactly 2 pi for a whole circle or ellipse
    real(c_double) :: start(2)        ! the point at `from`, length; it is the end of the arc before, bit for bit
    real(c_double) :: end(2)          ! the point at `to`, length
    integer(c_int32_t) :: piece       ! index in hsp_view_get_pieces
    ! the ball whose sphere it lies on too, the caller's index; HSP_NONE on the silhouette
    integer(c_int32_t) :: other_ball
  end type

  ! ---- map.h: what is seen as faces, edges and vertices of the view plane (Section 5.2) ------------------------------

  type, bind(C) :: hsp_map_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_map_limits)
    integer(c_int32_t) :: balls        ! of the model
    ! most balls whose discs meet the disc of any one and that reach higher than its centre
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: edges        ! of the map
  end type

  type, bind(C) :: hsp_map_info
    real(c_double) :: origin(3)       ! the point with view coordinates 0 0 0: the middle of the balls' centres, length
    real(c_double) :: right(3)        ! unit vector: the x axis of the view coordinates
    real(c_double) :: up(3)           ! unit vector: the y axis
    real(c_double) :: towards(3)      ! unit vector: the z axis
    real(c_double) :: area            ! of the view plane that balls cover, length^2
    real(c_double) :: perturbation    ! no centre was moved farther, length; 0 unless roundings had to be overcome
    integer(c_int32_t) :: vertices    ! of the map
    integer(c_int32_t) :: edges       ! of the map
    integer(c_int32_t) :: faces       ! of the map, the unbounded one included
    integer(c_int32_t) :: components  ! connected parts of the edges
    integer(c_int32_t) :: balls       ! how many of them are seen
    integer(c_int32_t) :: reserved    ! 0
  end type

  type, bind(C) :: hsp_map_vertex
    real(c_double) :: xyz(3)        ! view coordinates, length; of a T those of the stem, which is behind
    integer(c_int32_t) :: kind      ! HSP_MAP_*
    ! a directed edge that starts here, of a T the stem; the others are next(twin(h)) and so on
    integer(c_int32_t) :: h
    ! whose curves meet here: T: of the stem's one or two balls, then the nearer ball, in ball[2]; triple: in any
    ! order; tangency: the farther one, the nearer one; else HSP_NONE
    integer(c_int32_t) :: ball(3)
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_map_edge
    real(c_double) :: centre(2)      ! of its circle or ellipse, length
    real(c_double) :: first(2)       ! length
    real(c_double) :: second(2)      ! length
    real(c_double) :: from           ! in [-3 pi, pi]
    real(c_double) :: to             ! not below `from`, and at most 2 pi above it
    integer(c_int32_t) :: ball(2)    ! silhouette: the ball, HSP_NONE; crease: the nearer ball, the farther one
    integer(c_int32_t) :: face(2)    ! on its left and on its right
    integer(c_int32_t) :: vertex(2)  ! where it starts and ends
    integer(c_int32_t) :: next(2)    ! after 2 edge around face[0], after 2 edge + 1 around face[1]
  end type

  type, bind(C) :: hsp_map_face
    real(c_double) :: area          ! in the view plane, length^2; 0 for the unbounded one
    integer(c_int32_t) :: ball      ! the caller's index; HSP_NONE: the background
    ! a directed edge of its outer loop, of any hole for face 0; HSP_NONE if there are no edges
    integer(c_int32_t) :: h
    integer(c_int32_t) :: loops     ! around it, with the holes
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_map_sight
    real(c_double) :: depth     ! z of the ball's front there, length; -infinity for the background
    integer(c_int32_t) :: ball  ! the caller's index; HSP_NONE: the background
    integer(c_int32_t) :: face  ! HSP_NONE if the point is so close to an edge that roundings decide
  end type

  type, bind(C) :: hsp_map_point
    real(c_double) :: xyz(3)  ! view coordinates, length
    ! how far behind it what is seen on its left and right is, length; infinite: the background
    real(c_double) :: gap(2)
  end type

  type, bind(C) :: hsp_map_pole
    real(c_double) :: centre(2)  ! view coordinates, length
    real(c_double) :: radius     ! how far the nearest edge is from there, length
    real(c_double) :: bound      ! nowhere in the face it is farther, length; not below `radius`
  end type

  ! ---- sticks.h: balls and sticks in an order to paint them ----------------------------------------------------------

  type, bind(C) :: hsp_sticks_limits
    integer(c_int32_t) :: struct_size  ! sizeof(hsp_sticks_limits)
    integer(c_int32_t) :: balls        ! of the model
    integer(c_int32_t) :: sticks       ! most sticks
    ! of balls and halves of sticks of which one may cover a part of the other; two if they are balls that meet
    integer(c_int32_t) :: pairs
    integer(c_int32_t) :: edges        ! of the map, where there is one
  end type

  type, bind(C) :: hsp_stick
    integer(c_int32_t) :: ball(2)   ! its ends, the caller's indices
    integer(c_int32_t) :: flags     ! HSP_STICK_*
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_sticks_conflict
    integer(c_int32_t) :: kind      ! HSP_STICKS_*
    integer(c_int32_t) :: first     ! a number of a ball or stick as said there; HSP_NONE without conflict
    integer(c_int32_t) :: second    ! likewise
    integer(c_int32_t) :: reserved  ! 0
  end type

  type, bind(C) :: hsp_sticks_info
    real(c_double) :: origin(3)   ! the point with view coordinates 0 0 0: the middle of the balls' centres, length
    real(c_double) :: right(3)    ! unit vector: the x axis of the view coordinates
    real(c_double) :: up(3)       ! unit vector: the y axis
    real(c_double) :: towards(3)  ! unit vector: the z axis
    real(c_double) :: low(2)      ! of the box of all balls in the view plane, length; 0 0 without balls
    real(c_double) :: high(2)     ! of the same box
    integer(c_int32_t) :: paths   ! balls and halves of sticks that are painted; without an order those that are seen
    integer(c_int32_t) :: balls   ! of these
    integer(c_int32_t) :: sticks  ! as given
    integer(c_int32_t) :: arcs    ! parts of circles, ellipses and lines around all paths
  end type

  ! ---- picture.h: a view, a map, or balls and sticks as SVG, EPS or PDF ----------------------------------------------

  type, bind(C) :: hsp_picture_options
    integer(c_int32_t) :: struct_size       ! sizeof(hsp_picture_options)
    integer(c_int32_t) :: format            ! HSP_FORMAT_*; default SVG
    integer(c_int32_t) :: style             ! HSP_STYLE_*; default flat
    integer(c_int32_t) :: unit              ! HSP_UNIT_* of width, height, outline and ink_width; default px
    ! of the picture; 0: follows from height; less than 0.01 counts as 0.01; default 1000
    real(c_double) :: width
    real(c_double) :: height                ! likewise, from width; default 0
    ! around the balls, as a part of the larger side of their box, in [0, 10]; default 0.03. Of no effect with a scale.
    ! Lines around them have room in any case
    real(c_double) :: margin
    ! width of the lines along silhouettes and intersections; 0 (or less than 5e-5 px): none; < 0: chosen; default -1
    real(c_double) :: outline
    ! how far the farthest ball fades to the background, in [0, 1], if it is five mean radii or more behind the
    ! nearest; default 0.3
    real(c_double) :: fog
    integer(c_int32_t) :: outline_colour    ! 0xRRGGBB; default 0x23202B
    integer(c_int32_t) :: background        ! 0xRRGGBB; default 0xFFFFFF
    integer(c_int32_t) :: flags             ! HSP_PICTURE_*; default 0
    integer(c_int32_t) :: reserved          ! 0
    ! of a fixed frame: px or mm of the picture per unit of length; default 0: no fixed frame
    real(c_double) :: scale
    ! of a fixed frame: the point in space in its middle, length; default 0 0 0. Without a scale it has to be that
    real(c_double) :: centre(3)
    ! HSP_ADDRESS of scratch memory of any alignment, with which PDF is compressed (Deflate) to a third to a seventh of
    ! its size; default 0: it is not. Of no effect on other formats. A number, so that the struct is the same on every
    ! machine
    integer(c_int64_t) :: memory
    ! of memory, HSP_PICTURE_MEMORY or more; default 0, as it has to be without memory
    integer(c_int64_t) :: memory_bytes
    ! HSP_ADDRESS of a computed map of the same model from the same direction, with which contours are drawn: see
    ! HSP_INK_BORDER; default 0: none. Of balls and sticks there are none
    integer(c_int64_t) :: ink
    ! HSP_ADDRESS of a uint32_t for each ball of the model: numbers of groups, such as chains, residues or ligands, for
    ! HSP_INK_GROUP; default 0: all balls are of one
    integer(c_int64_t) :: group
    ! HSP_INK_*: of contours where they are widest; 0: none; < 0: chosen; default -1
    real(c_double) :: ink_width(3)
    integer(c_int32_t) :: ink_colour(3)     ! HSP_INK_*: 0xRRGGBB, fades like lines; default 0x23202B
    integer(c_int32_t) :: reserved_for_ink  ! 0
    ! SVG: HSP_ADDRESS of a const char * for each ball of the model, each NULL, empty or names of classes with blanks
    ! between them, NUL-terminated UTF-8. Such balls have their index in an id, "a", four digits or letters, "-" and
    ! the index, and not in data-ball; halves of sticks have classes and data-ball. Default 0: none; of no effect on
    ! other formats
    integer(c_int64_t) :: atom_class
    integer(c_int64_t) :: atom_title        ! SVG: likewise texts that browsers show beside the pointer; default 0: none
  end type

  abstract interface
    function hsp_sink(context, bytes, count) result(stop) bind(C)
      import :: c_char, c_int32_t, c_ptr, c_size_t
      type(c_ptr), value :: context
      integer(c_size_t), value :: count
      character(kind=c_char), intent(in) :: bytes(count)
      integer(c_int32_t) :: stop
    end function
  end interface

  interface

    ! ---- version.h: the version of the header and of the library -----------------------------------------------------

    function hsp_version() result(found) bind(C, name="hsp_version")
      import :: c_int32_t
      integer(c_int32_t) :: found
    end function

    function hsp_abi() result(found) bind(C, name="hsp_abi")
      import :: c_int32_t
      integer(c_int32_t) :: found
    end function

    function hsp_numerics() result(found) bind(C, name="hsp_numerics")
      import :: c_int32_t
      integer(c_int32_t) :: found
    end function

    ! ---- status.h: what functions return -----------------------------------------------------------------------------

    ! A pointer to C characters; hsp_status_message below returns the same as a Fortran string.
    function hsp_status_text(status) result(text) bind(C, name="hsp_status_text")
      import :: c_int32_t, c_ptr
      integer(c_int32_t), value :: status
      type(c_ptr) :: text
    end function

    ! ---- element.h: radii by element ---------------------------------------------------------------------------------

    function hsp_element_radius(set, atomic_number, radius, flags) result(status) bind(C, name="hsp_element_radius")
      import :: c_double, c_int32_t
      integer(c_int32_t), value :: set
      integer(c_int32_t), value :: atomic_number
      real(c_double), intent(inout) :: radius
      integer(c_int32_t), intent(inout), optional :: flags
      integer(c_int32_t) :: status
    end function

    ! ---- model.h: a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2) ---------------

    function hsp_model_bytes(balls, bytes) result(status) bind(C, name="hsp_model_bytes")
      import :: c_int32_t, c_size_t
      integer(c_int32_t), value :: balls
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_model_init(memory, bytes, balls, model) result(status) bind(C, name="hsp_model_init")
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      integer(c_int32_t), value :: balls
      type(c_ptr), intent(inout) :: model
      integer(c_int32_t) :: status
    end function

    function hsp_model_options_init(options, struct_size) result(status) bind(C, name="hsp_model_options_init")
      import :: c_int32_t, hsp_model_options
      type(hsp_model_options), intent(inout) :: options
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t) :: status
    end function

    function hsp_model_set(model, n, xyz, radius, options, first_bad) result(status) bind(C, name="hsp_model_set")
      import :: c_double, c_int32_t, c_ptr, hsp_model_options
      type(c_ptr), value :: model
      integer(c_int32_t), value :: n
      real(c_double), intent(in), optional :: xyz(3, *)  ! 3, n
      real(c_double), intent(in), optional :: radius(*)  ! n
      type(hsp_model_options), intent(in), optional :: options
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_model_get_info(model, info) result(status) bind(C, name="hsp_model_get_info")
      import :: c_int32_t, c_ptr, hsp_model_info
      type(c_ptr), value :: model
      type(hsp_model_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_model_get_packing(model, figures) result(status) bind(C, name="hsp_model_get_packing")
      import :: c_int32_t, c_ptr, hsp_packing
      type(c_ptr), value :: model
      type(hsp_packing), intent(inout) :: figures
      integer(c_int32_t) :: status
    end function

    ! ---- query.h: which balls contain a point, meet a ball, or meet each other (Section 3) ---------------------------

    function hsp_query_point(model, xyz, ids, capacity, needed) result(status) bind(C, name="hsp_query_point")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: model
      real(c_double), intent(in) :: xyz(3)
      integer(c_int32_t), intent(inout), optional :: ids(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_query_ball(model, xyz, radius, ids, capacity, needed) result(status) bind(C, name="hsp_query_ball")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: model
      real(c_double), intent(in) :: xyz(3)
      real(c_double), value :: radius
      integer(c_int32_t), intent(inout), optional :: ids(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_query_meets(model, xyz, radius, meets) result(status) bind(C, name="hsp_query_meets")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: model
      real(c_double), intent(in) :: xyz(3)
      real(c_double), value :: radius
      integer(c_int32_t), intent(inout) :: meets
      integer(c_int32_t) :: status
    end function

    function hsp_query_neighbours(model, ball, ids, capacity, needed) result(status) &
      bind(C, name="hsp_query_neighbours")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: model
      integer(c_int32_t), value :: ball
      integer(c_int32_t), intent(inout), optional :: ids(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! Row i, from 0 on, is ids(first(i + 1) + 1 : first(i + 2)).
    function hsp_query_pairs(model, flags, first, ids, capacity, needed) result(status) bind(C, name="hsp_query_pairs")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: model
      integer(c_int32_t), value :: flags
      integer(c_int32_t), intent(inout) :: first(*)  ! n + 1
      integer(c_int32_t), intent(inout), optional :: ids(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_query_ray(model, origin, direction, hit) result(status) bind(C, name="hsp_query_ray")
      import :: c_double, c_int32_t, c_ptr, hsp_ray_hit
      type(c_ptr), value :: model
      real(c_double), intent(in) :: origin(3)
      real(c_double), intent(in) :: direction(3)
      type(hsp_ray_hit), intent(inout) :: hit
      integer(c_int32_t) :: status
    end function

    ! ---- pose.h: a molecule against a moved one: hits, pairs, gaps (Sections 3 and 6) --------------------------------

    function hsp_body_bytes(balls, bytes) result(status) bind(C, name="hsp_body_bytes")
      import :: c_int32_t, c_size_t
      integer(c_int32_t), value :: balls
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_body_init(memory, bytes, balls, body) result(status) bind(C, name="hsp_body_init")
      import :: c_int32_t, c_ptr, c_size_t
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      integer(c_int32_t), value :: balls
      type(c_ptr), intent(inout) :: body
      integer(c_int32_t) :: status
    end function

    function hsp_body_set(body, model) result(status) bind(C, name="hsp_body_set")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: body
      type(c_ptr), value :: model
      integer(c_int32_t) :: status
    end function

    ! The matrix is row by row, as in C: transpose Fortran's.
    function hsp_pose_from_matrix(matrix, translation, pose) result(status) bind(C, name="hsp_pose_from_matrix")
      import :: c_double, c_int32_t, hsp_pose
      real(c_double), intent(in) :: matrix(9)
      real(c_double), intent(in) :: translation(3)
      type(hsp_pose), intent(inout) :: pose
      integer(c_int32_t) :: status
    end function

    function hsp_body_hits(fixed, moving, poses, pose, hit, first_bad) result(status) bind(C, name="hsp_body_hits")
      import :: c_int32_t, c_ptr, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in), optional :: pose(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: hit(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_hits_along(fixed, moving, poses, pose, margin, hit, first_bad) result(status) &
      bind(C, name="hsp_body_hits_along")
      import :: c_double, c_int32_t, c_ptr, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in), optional :: pose(*)  ! poses
      real(c_double), value :: margin
      integer(c_int32_t), intent(inout), optional :: hit(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_gaps(fixed, moving, poses, pose, gap, first_bad) result(status) bind(C, name="hsp_body_gaps")
      import :: c_int32_t, c_ptr, hsp_body_gap, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in), optional :: pose(*)  ! poses
      type(hsp_body_gap), intent(inout), optional :: gap(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_overlaps(fixed, moving, poses, pose, overlap, first_bad) result(status) &
      bind(C, name="hsp_body_overlaps")
      import :: c_int32_t, c_ptr, hsp_body_overlap, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in), optional :: pose(*)  ! poses
      type(hsp_body_overlap), intent(inout), optional :: overlap(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_pairs(fixed, moving, pose, pair, capacity, needed) result(status) bind(C, name="hsp_body_pairs")
      import :: c_int32_t, c_ptr, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      type(hsp_pose), intent(in) :: pose
      integer(c_int32_t), intent(inout), optional :: pair(2, *)  ! 2, needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_hits(fixed, moving, poses, pose, hit, first_bad) result(status) &
      bind(C, name="hsp_body_rational_hits")
      import :: c_int32_t, c_ptr, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_rational_pose), intent(in), optional :: pose(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: hit(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_hits_along(fixed, moving, poses, pose, margin, hit, first_bad) result(status) &
      bind(C, name="hsp_body_rational_hits_along")
      import :: c_double, c_int32_t, c_ptr, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_rational_pose), intent(in), optional :: pose(*)  ! poses
      real(c_double), value :: margin
      integer(c_int32_t), intent(inout), optional :: hit(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_gaps(fixed, moving, poses, pose, gap, first_bad) result(status) &
      bind(C, name="hsp_body_rational_gaps")
      import :: c_int32_t, c_ptr, hsp_body_gap, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_rational_pose), intent(in), optional :: pose(*)  ! poses
      type(hsp_body_gap), intent(inout), optional :: gap(*)  ! poses
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_pairs(fixed, moving, pose, pair, capacity, needed) result(status) &
      bind(C, name="hsp_body_rational_pairs")
      import :: c_int32_t, c_ptr, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      type(hsp_rational_pose), intent(in) :: pose
      integer(c_int32_t), intent(inout), optional :: pair(2, *)  ! 2, needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- boundary.h: the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2) ----------

    function hsp_boundary_limits_init(limits, struct_size, balls) result(status) &
      bind(C, name="hsp_boundary_limits_init")
      import :: c_int32_t, hsp_boundary_limits
      type(hsp_boundary_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_bytes(limits, bytes) result(status) bind(C, name="hsp_boundary_bytes")
      import :: c_int32_t, c_size_t, hsp_boundary_limits
      type(hsp_boundary_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_init(memory, bytes, limits, boundary) result(status) bind(C, name="hsp_boundary_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_boundary_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_boundary_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: boundary
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_compute(boundary, model, limits) result(status) bind(C, name="hsp_boundary_compute")
      import :: c_int32_t, c_ptr, hsp_boundary_limits
      type(c_ptr), value :: boundary
      type(c_ptr), value :: model
      type(hsp_boundary_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_begin(boundary, model, workers, stages) result(status) bind(C, name="hsp_boundary_begin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      type(c_ptr), value :: model
      integer(c_int32_t), value :: workers
      integer(c_int32_t), intent(inout) :: stages
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_work(boundary, stage, worker) result(status) bind(C, name="hsp_boundary_work")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      integer(c_int32_t), value :: stage
      integer(c_int32_t), value :: worker
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_end(boundary, limits) result(status) bind(C, name="hsp_boundary_end")
      import :: c_int32_t, c_ptr, hsp_boundary_limits
      type(c_ptr), value :: boundary
      type(hsp_boundary_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_counts(boundary, counts) result(status) bind(C, name="hsp_boundary_get_counts")
      import :: c_int32_t, c_ptr, hsp_boundary_counts
      type(c_ptr), value :: boundary
      type(hsp_boundary_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_vertices(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_vertices")
      import :: c_int32_t, c_ptr, hsp_vertex
      type(c_ptr), value :: boundary
      type(hsp_vertex), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_arcs(boundary, out, capacity, needed) result(status) bind(C, name="hsp_boundary_get_arcs")
      import :: c_int32_t, c_ptr, hsp_arc
      type(c_ptr), value :: boundary
      type(hsp_arc), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_circles(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_circles")
      import :: c_int32_t, c_ptr, hsp_circle
      type(c_ptr), value :: boundary
      type(hsp_circle), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_faces(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_faces")
      import :: c_int32_t, c_ptr, hsp_face
      type(c_ptr), value :: boundary
      type(hsp_face), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_loops(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_loops")
      import :: c_int32_t, c_ptr, hsp_loop
      type(c_ptr), value :: boundary
      type(hsp_loop), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_loop_arcs(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_loop_arcs")
      import :: c_int32_t, c_ptr, hsp_loop_arc
      type(c_ptr), value :: boundary
      type(hsp_loop_arc), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_balls(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_balls")
      import :: c_int32_t, c_ptr, hsp_ball
      type(c_ptr), value :: boundary
      type(hsp_ball), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_check(boundary, invariant, id) result(status) bind(C, name="hsp_boundary_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- measure.h: areas and volumes --------------------------------------------------------------------------------

    function hsp_boundary_measure(boundary, selected, totals, area, volume, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_measure")
      import :: c_double, c_int32_t, c_int8_t, c_ptr, hsp_totals
      type(c_ptr), value :: boundary
      integer(c_int8_t), intent(in), optional :: selected(*)  ! n
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: area(*)  ! n
      real(c_double), intent(inout), optional :: volume(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_range(boundary, selected, first, count, area, volume) result(status) &
      bind(C, name="hsp_boundary_measure_range")
      import :: c_double, c_int32_t, c_int8_t, c_ptr
      type(c_ptr), value :: boundary
      integer(c_int8_t), intent(in), optional :: selected(*)  ! n
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      real(c_double), intent(inout) :: area(*)  ! n
      real(c_double), intent(inout) :: volume(*)  ! n
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_end(boundary, totals, area, volume) result(status) &
      bind(C, name="hsp_boundary_measure_end")
      import :: c_double, c_int32_t, c_ptr, hsp_totals
      type(c_ptr), value :: boundary
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout) :: area(*)  ! n
      real(c_double), intent(inout) :: volume(*)  ! n
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_faces(boundary, area, volume, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_measure_faces")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(inout), optional :: area(*)  ! faces
      real(c_double), intent(inout), optional :: volume(*)  ! faces
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- gradient.h: their derivatives -------------------------------------------------------------------------------

    function hsp_boundary_gradient(boundary, sigma, tension, pressure, tangency, energy, d_centre, d_radius, flags, &
      capacity, needed, first_bad) result(status) bind(C, name="hsp_boundary_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)  ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_gradient_range(boundary, sigma, tension, pressure, tangency, first, count, d_centre, &
      d_radius, flags, shares, first_bad) result(status) bind(C, name="hsp_boundary_gradient_range")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)  ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      real(c_double), intent(inout), optional :: shares(3, *)  ! 3, n
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_gradient_end(boundary, tension, pressure, energy, flags, shares) result(status) &
      bind(C, name="hsp_boundary_gradient_end")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: boundary
      real(c_double), value :: tension
      real(c_double), value :: pressure
      type(hsp_energy), intent(inout), optional :: energy
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      real(c_double), intent(in), optional :: shares(3, *)  ! 3, n
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_derivatives(boundary, sigma, tangency, area_centre, area_radius, volume_centre, &
      volume_radius, flags, capacity, needed, first_bad) result(status) bind(C, name="hsp_boundary_derivatives")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)  ! n
      integer(c_int32_t), value :: tangency
      real(c_double), intent(inout), optional :: area_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: area_radius(*)  ! n
      real(c_double), intent(inout), optional :: volume_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: volume_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_area_row(boundary, ball, tangency, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_area_row")
      import :: c_int32_t, c_ptr, hsp_area_derivative
      type(c_ptr), value :: boundary
      integer(c_int32_t), value :: ball
      integer(c_int32_t), value :: tangency
      type(hsp_area_derivative), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- moving.h: all of that while a few balls move at a time ------------------------------------------------------

    function hsp_moving_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_moving_limits_init")
      import :: c_int32_t, hsp_moving_limits
      type(hsp_moving_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_moving_bytes(limits, bytes) result(status) bind(C, name="hsp_moving_bytes")
      import :: c_int32_t, c_size_t, hsp_moving_limits
      type(hsp_moving_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_moving_init(memory, bytes, limits, moving) result(status) bind(C, name="hsp_moving_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_moving_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_moving_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: moving
      integer(c_int32_t) :: status
    end function

    function hsp_moving_set(moving, model, sigma, tension, pressure, tangency, limits, first_bad) result(status) &
      bind(C, name="hsp_moving_set")
      import :: c_double, c_int32_t, c_ptr, hsp_moving_limits
      type(c_ptr), value :: moving
      type(c_ptr), value :: model
      real(c_double), intent(in), optional :: sigma(*)  ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency
      type(hsp_moving_limits), intent(inout), optional :: limits
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_moving_move(moving, count, ball, xyz, radius, limits, first_bad) result(status) &
      bind(C, name="hsp_moving_move")
      import :: c_double, c_int32_t, c_ptr, hsp_moving_limits
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(in), optional :: ball(*)  ! count
      real(c_double), intent(in), optional :: xyz(3, *)  ! 3, count
      real(c_double), intent(in), optional :: radius(*)  ! count
      type(hsp_moving_limits), intent(inout), optional :: limits
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_moving_undo(moving) result(status) bind(C, name="hsp_moving_undo")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: moving
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_info(moving, info) result(status) bind(C, name="hsp_moving_get_info")
      import :: c_int32_t, c_ptr, hsp_moving_info
      type(c_ptr), value :: moving
      type(hsp_moving_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_moving_measure(moving, totals, area, volume, capacity, needed) result(status) &
      bind(C, name="hsp_moving_measure")
      import :: c_double, c_int32_t, c_ptr, hsp_totals
      type(c_ptr), value :: moving
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: area(*)  ! n
      real(c_double), intent(inout), optional :: volume(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_moving_gradient(moving, energy, d_centre, d_radius, flags, capacity, needed) result(status) &
      bind(C, name="hsp_moving_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: moving
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_balls(moving, count, ball, out) result(status) bind(C, name="hsp_moving_get_balls")
      import :: c_int32_t, c_ptr, hsp_moving_ball
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(in), optional :: ball(*)  ! count
      type(hsp_moving_ball), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_changed(moving, out, capacity, needed) result(status) bind(C, name="hsp_moving_get_changed")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: moving
      integer(c_int32_t), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_model(moving, model) result(status) bind(C, name="hsp_moving_get_model")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: moving
      type(c_ptr), value :: model
      integer(c_int32_t) :: status
    end function

    ! ---- curvature.h: integrated mean and Gaussian curvature ---------------------------------------------------------

    function hsp_boundary_curvature(boundary, totals, mean, gauss_thirds, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_curvature")
      import :: c_double, c_int32_t, c_ptr, hsp_curvatures
      type(c_ptr), value :: boundary
      type(hsp_curvatures), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: mean(*)  ! n
      integer(c_int32_t), intent(inout), optional :: gauss_thirds(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_morphometry(boundary, sigma, factors, energy, d_centre, d_radius, flags, capacity, needed, &
      first_bad) result(status) bind(C, name="hsp_boundary_morphometry")
      import :: c_double, c_int32_t, c_ptr, hsp_morphometric_energy, hsp_morphometry
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)  ! n
      type(hsp_morphometry), intent(in) :: factors
      type(hsp_morphometric_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    ! ---- contacts.h: which balls touch and by how much, shares of the union, the dual complex ------------------------

    function hsp_contacts_limits_init(limits, struct_size, boundary) result(status) &
      bind(C, name="hsp_contacts_limits_init")
      import :: c_int32_t, c_ptr, hsp_contacts_limits
      type(hsp_contacts_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      type(c_ptr), value :: boundary
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_bytes(limits, bytes) result(status) bind(C, name="hsp_contacts_bytes")
      import :: c_int32_t, c_size_t, hsp_contacts_limits
      type(hsp_contacts_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_init(memory, bytes, limits, contacts) result(status) bind(C, name="hsp_contacts_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_contacts_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_contacts_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: contacts
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_compute(contacts, boundary, limits) result(status) bind(C, name="hsp_contacts_compute")
      import :: c_int32_t, c_ptr, hsp_contacts_limits
      type(c_ptr), value :: contacts
      type(c_ptr), value :: boundary
      type(hsp_contacts_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_get(contacts, out, capacity, needed) result(status) bind(C, name="hsp_contacts_get")
      import :: c_int32_t, c_ptr, hsp_contact
      type(c_ptr), value :: contacts
      type(hsp_contact), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_get_row(contacts, ball, out, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_get_row")
      import :: c_int32_t, c_ptr, hsp_contact
      type(c_ptr), value :: contacts
      integer(c_int32_t), value :: ball
      type(hsp_contact), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_measure(contacts, totals, cell_volume, contact_area, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_measure")
      import :: c_double, c_int32_t, c_ptr, hsp_totals
      type(c_ptr), value :: contacts
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: cell_volume(*)  ! n
      real(c_double), intent(inout), optional :: contact_area(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_group(contacts, group, out, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_group")
      import :: c_int32_t, c_ptr, hsp_group_contact
      type(c_ptr), value :: contacts
      integer(c_int32_t), intent(in) :: group(*)  ! n
      type(hsp_group_contact), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_get_complex(contacts, counts) result(status) bind(C, name="hsp_contacts_get_complex")
      import :: c_int32_t, c_ptr, hsp_complex
      type(c_ptr), value :: contacts
      type(hsp_complex), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_get_simplices(contacts, dimension, out, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_get_simplices")
      import :: c_int32_t, c_ptr, hsp_simplex
      type(c_ptr), value :: contacts
      integer(c_int32_t), value :: dimension
      type(hsp_simplex), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_check(contacts, invariant, id) result(status) bind(C, name="hsp_contacts_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: contacts
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- periodic.h: all of that in a box whose copies fill space: areas, volume, contacts, windings, strain ---------

    function hsp_periodic_limits_init(limits, struct_size, balls) result(status) &
      bind(C, name="hsp_periodic_limits_init")
      import :: c_int32_t, hsp_periodic_limits
      type(hsp_periodic_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_bytes(limits, bytes) result(status) bind(C, name="hsp_periodic_bytes")
      import :: c_int32_t, c_size_t, hsp_periodic_limits
      type(hsp_periodic_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_init(memory, bytes, limits, periodic) result(status) bind(C, name="hsp_periodic_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_periodic_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_periodic_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: periodic
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_compute(periodic, n, xyz, radius, options, box, limits, first_bad) result(status) &
      bind(C, name="hsp_periodic_compute")
      import :: c_double, c_int32_t, c_ptr, hsp_model_options, hsp_periodic_limits
      type(c_ptr), value :: periodic
      integer(c_int32_t), value :: n
      real(c_double), intent(in), optional :: xyz(3, *)  ! 3, n
      real(c_double), intent(in), optional :: radius(*)  ! n
      type(hsp_model_options), intent(in), optional :: options
      real(c_double), intent(in) :: box(9)
      type(hsp_periodic_limits), intent(inout), optional :: limits
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_counts(periodic, counts) result(status) bind(C, name="hsp_periodic_get_counts")
      import :: c_int32_t, c_ptr, hsp_periodic_counts
      type(c_ptr), value :: periodic
      type(hsp_periodic_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_measure(periodic, totals, area, cell_volume, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_measure")
      import :: c_double, c_int32_t, c_ptr, hsp_periodic_totals
      type(c_ptr), value :: periodic
      type(hsp_periodic_totals), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: area(*)  ! n
      real(c_double), intent(inout), optional :: cell_volume(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_curvature(periodic, totals, mean, gauss_thirds, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_curvature")
      import :: c_double, c_int32_t, c_ptr, hsp_curvatures
      type(c_ptr), value :: periodic
      type(hsp_curvatures), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: mean(*)  ! n
      integer(c_int32_t), intent(inout), optional :: gauss_thirds(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_morphometry(periodic, sigma, factors, energy, d_centre, d_radius, flags, d_strain, d_box, &
      capacity, needed, first_bad) result(status) bind(C, name="hsp_periodic_morphometry")
      import :: c_double, c_int32_t, c_ptr, hsp_morphometric_energy, hsp_morphometry
      type(c_ptr), value :: periodic
      real(c_double), intent(in), optional :: sigma(*)  ! n
      type(hsp_morphometry), intent(in) :: factors
      type(hsp_morphometric_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      real(c_double), intent(inout), optional :: d_strain(9)
      real(c_double), intent(inout), optional :: d_box(9)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_contacts(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_contacts")
      import :: c_int32_t, c_ptr, hsp_periodic_contact
      type(c_ptr), value :: periodic
      type(hsp_periodic_contact), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_group_contacts(periodic, group, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_group_contacts")
      import :: c_int32_t, c_ptr, hsp_group_contact
      type(c_ptr), value :: periodic
      integer(c_int32_t), intent(in) :: group(*)  ! n
      type(hsp_group_contact), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_windings(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_windings")
      import :: c_int32_t, c_ptr, hsp_winding
      type(c_ptr), value :: periodic
      type(hsp_winding), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_components(periodic, component, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_components")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: periodic
      integer(c_int32_t), intent(inout), optional :: component(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_gradient(periodic, sigma, tension, pressure, tangency, energy, d_centre, d_radius, flags, &
      d_strain, d_box, capacity, needed, first_bad) result(status) bind(C, name="hsp_periodic_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: periodic
      real(c_double), intent(in), optional :: sigma(*)  ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      real(c_double), intent(inout), optional :: d_strain(9)
      real(c_double), intent(inout), optional :: d_box(9)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_query_point(periodic, xyz, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_point")
      import :: c_double, c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      real(c_double), intent(in) :: xyz(3)
      type(hsp_image), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_query_ball(periodic, xyz, radius, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_ball")
      import :: c_double, c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      real(c_double), intent(in) :: xyz(3)
      real(c_double), value :: radius
      type(hsp_image), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_query_neighbours(periodic, ball, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_neighbours")
      import :: c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      integer(c_int32_t), value :: ball
      type(hsp_image), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! Row i, from 0 on, is out(first(i + 1) + 1 : first(i + 2)).
    function hsp_periodic_query_pairs(periodic, flags, first, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_pairs")
      import :: c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      integer(c_int32_t), value :: flags
      integer(c_int32_t), intent(inout) :: first(*)  ! n + 1
      type(hsp_image), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_check(periodic, invariant, id) result(status) bind(C, name="hsp_periodic_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: periodic
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- periodic_boundary.h: vertices, arcs, circles, faces in such a box -------------------------------------------

    function hsp_periodic_get_vertices(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_vertices")
      import :: c_int32_t, c_ptr, hsp_periodic_vertex
      type(c_ptr), value :: periodic
      type(hsp_periodic_vertex), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_arcs(periodic, out, capacity, needed) result(status) bind(C, name="hsp_periodic_get_arcs")
      import :: c_int32_t, c_ptr, hsp_periodic_arc
      type(c_ptr), value :: periodic
      type(hsp_periodic_arc), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_circles(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_circles")
      import :: c_int32_t, c_ptr, hsp_periodic_circle
      type(c_ptr), value :: periodic
      type(hsp_periodic_circle), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_faces(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_faces")
      import :: c_int32_t, c_ptr, hsp_periodic_face
      type(c_ptr), value :: periodic
      type(hsp_periodic_face), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_loops(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_loops")
      import :: c_int32_t, c_ptr, hsp_periodic_loop
      type(c_ptr), value :: periodic
      type(hsp_periodic_loop), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_loop_arcs(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_loop_arcs")
      import :: c_int32_t, c_ptr, hsp_periodic_loop_arc
      type(c_ptr), value :: periodic
      type(hsp_periodic_loop_arc), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_balls(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_balls")
      import :: c_int32_t, c_ptr, hsp_ball
      type(c_ptr), value :: periodic
      type(hsp_ball), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- surface.h: the smooth surface that a probe leaves, its area and volume (Section 4.3) ------------------------

    function hsp_surface_limits_init(limits, struct_size, boundary) result(status) &
      bind(C, name="hsp_surface_limits_init")
      import :: c_int32_t, c_ptr, hsp_surface_limits
      type(hsp_surface_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      type(c_ptr), value :: boundary
      integer(c_int32_t) :: status
    end function

    function hsp_surface_bytes(limits, bytes) result(status) bind(C, name="hsp_surface_bytes")
      import :: c_int32_t, c_size_t, hsp_surface_limits
      type(hsp_surface_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_surface_init(memory, bytes, limits, surface) result(status) bind(C, name="hsp_surface_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_surface_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_surface_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: surface
      integer(c_int32_t) :: status
    end function

    function hsp_surface_compute(surface, boundary, limits) result(status) bind(C, name="hsp_surface_compute")
      import :: c_int32_t, c_ptr, hsp_surface_limits
      type(c_ptr), value :: surface
      type(c_ptr), value :: boundary
      type(hsp_surface_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_surface_compute_shells(surface, boundary, shells, count, limits) result(status) &
      bind(C, name="hsp_surface_compute_shells")
      import :: c_int32_t, c_ptr, hsp_surface_limits
      type(c_ptr), value :: surface
      type(c_ptr), value :: boundary
      integer(c_int32_t), intent(in), optional :: shells(*)  ! count
      integer(c_int32_t), value :: count
      type(hsp_surface_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_counts(surface, counts) result(status) bind(C, name="hsp_surface_get_counts")
      import :: c_int32_t, c_ptr, hsp_surface_counts
      type(c_ptr), value :: surface
      type(hsp_surface_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_surface_measure(surface, totals, balls, capacity, needed) result(status) &
      bind(C, name="hsp_surface_measure")
      import :: c_int32_t, c_ptr, hsp_surface_totals
      type(c_ptr), value :: surface
      type(hsp_surface_totals), intent(inout), optional :: totals
      type(hsp_surface_totals), intent(inout), optional :: balls(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_surface_gradient(surface, tension, pressure, energy, d_centre, d_radius, flags, capacity, needed) &
      result(status) bind(C, name="hsp_surface_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: surface
      real(c_double), value :: tension
      real(c_double), value :: pressure
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_surface_weighted_gradient(surface, sigma, tension, pressure, energy, d_centre, d_radius, flags, &
      capacity, needed, first_bad) result(status) bind(C, name="hsp_surface_weighted_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: surface
      real(c_double), intent(in), optional :: sigma(*)  ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *)  ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)  ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_map_counts(surface, counts) result(status) bind(C, name="hsp_surface_get_map_counts")
      import :: c_int32_t, c_ptr, hsp_surface_map_counts
      type(c_ptr), value :: surface
      type(hsp_surface_map_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_surface_next(surface, h) result(found) bind(C, name="hsp_surface_next")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_surface_previous(surface, h) result(found) bind(C, name="hsp_surface_previous")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_surface_next_loop(surface, h) result(found) bind(C, name="hsp_surface_next_loop")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_surface_origin(surface, h) result(found) bind(C, name="hsp_surface_origin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_surface_left(surface, h) result(found) bind(C, name="hsp_surface_left")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_surface_get_patches(surface, first, count, out) result(status) bind(C, name="hsp_surface_get_patches")
      import :: c_int32_t, c_ptr, hsp_surface_patch
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_surface_patch), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_edges(surface, first, count, out) result(status) bind(C, name="hsp_surface_get_edges")
      import :: c_int32_t, c_ptr, hsp_surface_edge
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_surface_edge), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_corners(surface, first, count, out) result(status) bind(C, name="hsp_surface_get_corners")
      import :: c_int32_t, c_ptr, hsp_surface_corner
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_surface_corner), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_shells(surface, out, capacity, needed) result(status) &
      bind(C, name="hsp_surface_get_shells")
      import :: c_int32_t, c_ptr, hsp_surface_shell
      type(c_ptr), value :: surface
      type(hsp_surface_shell), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_surface_check(surface, invariant, id) result(status) bind(C, name="hsp_surface_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- mesh.h: boundary or smooth surface as triangles -------------------------------------------------------------

    function hsp_mesh_limits_init(limits, struct_size, boundary, edge) result(status) &
      bind(C, name="hsp_mesh_limits_init")
      import :: c_double, c_int32_t, c_ptr, hsp_mesh_limits
      type(hsp_mesh_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      type(c_ptr), value :: boundary
      real(c_double), value :: edge
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_limits_init_surface(limits, struct_size, surface, edge) result(status) &
      bind(C, name="hsp_mesh_limits_init_surface")
      import :: c_double, c_int32_t, c_ptr, hsp_mesh_limits
      type(hsp_mesh_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      type(c_ptr), value :: surface
      real(c_double), value :: edge
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_bytes(limits, bytes) result(status) bind(C, name="hsp_mesh_bytes")
      import :: c_int32_t, c_size_t, hsp_mesh_limits
      type(hsp_mesh_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_init(memory, bytes, limits, mesh) result(status) bind(C, name="hsp_mesh_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_mesh_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_mesh_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: mesh
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_compute(mesh, boundary, edge, limits) result(status) bind(C, name="hsp_mesh_compute")
      import :: c_double, c_int32_t, c_ptr, hsp_mesh_limits
      type(c_ptr), value :: mesh
      type(c_ptr), value :: boundary
      real(c_double), value :: edge
      type(hsp_mesh_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_compute_surface(mesh, surface, edge, limits) result(status) &
      bind(C, name="hsp_mesh_compute_surface")
      import :: c_double, c_int32_t, c_ptr, hsp_mesh_limits
      type(c_ptr), value :: mesh
      type(c_ptr), value :: surface
      real(c_double), value :: edge
      type(hsp_mesh_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_counts(mesh, counts) result(status) bind(C, name="hsp_mesh_get_counts")
      import :: c_int32_t, c_ptr, hsp_mesh_counts
      type(c_ptr), value :: mesh
      type(hsp_mesh_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_vertices(mesh, xyz, normals, areas, balls, capacity, needed) result(status) &
      bind(C, name="hsp_mesh_get_vertices")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: mesh
      real(c_double), intent(inout), optional :: xyz(3, *)  ! 3, vertices
      real(c_double), intent(inout), optional :: normals(3, *)  ! 3, vertices
      real(c_double), intent(inout), optional :: areas(*)  ! vertices
      integer(c_int32_t), intent(inout), optional :: balls(*)  ! vertices
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, capacity, needed) result(status) &
      bind(C, name="hsp_mesh_get_triangles")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: mesh
      integer(c_int32_t), intent(inout), optional :: corners(3, *)  ! 3, triangles
      integer(c_int32_t), intent(inout), optional :: kinds(*)  ! triangles
      integer(c_int32_t), intent(inout), optional :: patches(*)  ! triangles
      integer(c_int32_t), intent(inout), optional :: balls(*)  ! triangles
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_patch(mesh, patch, first, count) result(status) bind(C, name="hsp_mesh_get_patch")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: patch
      integer(c_int32_t), intent(inout) :: first
      integer(c_int32_t), intent(inout) :: count
      integer(c_int32_t) :: status
    end function

    ! ---- topology.h: the boundary as quad-edges with simple faces, shells, cells, point location (Step 3) ------------

    function hsp_topology_limits_init(limits, struct_size, boundary) result(status) &
      bind(C, name="hsp_topology_limits_init")
      import :: c_int32_t, c_ptr, hsp_topology_limits
      type(hsp_topology_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      type(c_ptr), value :: boundary
      integer(c_int32_t) :: status
    end function

    function hsp_topology_bytes(limits, bytes) result(status) bind(C, name="hsp_topology_bytes")
      import :: c_int32_t, c_size_t, hsp_topology_limits
      type(hsp_topology_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_topology_init(memory, bytes, limits, topology) result(status) bind(C, name="hsp_topology_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_topology_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_topology_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: topology
      integer(c_int32_t) :: status
    end function

    function hsp_topology_compute(topology, boundary, limits) result(status) bind(C, name="hsp_topology_compute")
      import :: c_int32_t, c_ptr, hsp_topology_limits
      type(c_ptr), value :: topology
      type(c_ptr), value :: boundary
      type(hsp_topology_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_counts(topology, counts) result(status) bind(C, name="hsp_topology_get_counts")
      import :: c_int32_t, c_ptr, hsp_topology_counts
      type(c_ptr), value :: topology
      type(hsp_topology_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_topology_onext(topology, q) result(found) bind(C, name="hsp_topology_onext")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: q
      integer(c_int32_t) :: found
    end function

    function hsp_topology_lnext(topology, q) result(found) bind(C, name="hsp_topology_lnext")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: q
      integer(c_int32_t) :: found
    end function

    function hsp_topology_origin(topology, q) result(found) bind(C, name="hsp_topology_origin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: q
      integer(c_int32_t) :: found
    end function

    function hsp_topology_left(topology, q) result(found) bind(C, name="hsp_topology_left")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: q
      integer(c_int32_t) :: found
    end function

    function hsp_topology_get_quad_edges(topology, first, count, onext, origin) result(status) &
      bind(C, name="hsp_topology_get_quad_edges")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(inout), optional :: onext(0:3, 0:*)  ! 4, count
      integer(c_int32_t), intent(inout), optional :: origin(0:3, 0:*)  ! 4, count
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_vertices(topology, first, count, out) result(status) &
      bind(C, name="hsp_topology_get_vertices")
      import :: c_int32_t, c_ptr, hsp_topology_vertex
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_topology_vertex), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_edges(topology, first, count, out) result(status) bind(C, name="hsp_topology_get_edges")
      import :: c_int32_t, c_ptr, hsp_topology_edge
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_topology_edge), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_simple_faces(topology, first, count, out) result(status) &
      bind(C, name="hsp_topology_get_simple_faces")
      import :: c_int32_t, c_ptr, hsp_simple_face
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_simple_face), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_shells(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_shells")
      import :: c_int32_t, c_ptr, hsp_shell
      type(c_ptr), value :: topology
      type(hsp_shell), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_components(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_components")
      import :: c_int32_t, c_ptr, hsp_component
      type(c_ptr), value :: topology
      type(hsp_component), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_cells(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_cells")
      import :: c_int32_t, c_ptr, hsp_cell
      type(c_ptr), value :: topology
      type(hsp_cell), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_cell_shells(topology, cell, shells, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_cell_shells")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: cell
      integer(c_int32_t), intent(inout), optional :: shells(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_traversal(topology, shell, faces, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_traversal")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: shell
      integer(c_int32_t), intent(inout), optional :: faces(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_locate(topology, xyz, cell) result(status) bind(C, name="hsp_topology_locate")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: topology
      real(c_double), intent(in) :: xyz(3)
      integer(c_int32_t), intent(inout) :: cell
      integer(c_int32_t) :: status
    end function

    function hsp_topology_check(topology, invariant, id) result(status) bind(C, name="hsp_topology_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- cells.h: what no ball covers as simple cells, their neighbours, point location (Section 2) ------------------

    function hsp_cells_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_cells_limits_init")
      import :: c_int32_t, hsp_cells_limits
      type(hsp_cells_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_cells_bytes(limits, bytes) result(status) bind(C, name="hsp_cells_bytes")
      import :: c_int32_t, c_size_t, hsp_cells_limits
      type(hsp_cells_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_cells_init(memory, bytes, limits, cells) result(status) bind(C, name="hsp_cells_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_cells_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_cells_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: cells
      integer(c_int32_t) :: status
    end function

    function hsp_cells_compute(cells, model, limits) result(status) bind(C, name="hsp_cells_compute")
      import :: c_int32_t, c_ptr, hsp_cells_limits
      type(c_ptr), value :: cells
      type(c_ptr), value :: model
      type(hsp_cells_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_cells_get_counts(cells, counts) result(status) bind(C, name="hsp_cells_get_counts")
      import :: c_int32_t, c_ptr, hsp_cells_counts
      type(c_ptr), value :: cells
      type(hsp_cells_counts), intent(inout) :: counts
      integer(c_int32_t) :: status
    end function

    function hsp_cells_get_cells(cells, first, count, out) result(status) bind(C, name="hsp_cells_get_cells")
      import :: c_int32_t, c_ptr, hsp_free_cell
      type(c_ptr), value :: cells
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_free_cell), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_cells_get_neighbours(cells, cell, neighbours, capacity, needed) result(status) &
      bind(C, name="hsp_cells_get_neighbours")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: cells
      integer(c_int32_t), value :: cell
      integer(c_int32_t), intent(inout), optional :: neighbours(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_cells_get_pairs(cells, first, count, out) result(status) bind(C, name="hsp_cells_get_pairs")
      import :: c_int32_t, c_ptr, hsp_cell_pair
      type(c_ptr), value :: cells
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_cell_pair), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_cells_locate(cells, xyz, cell) result(status) bind(C, name="hsp_cells_locate")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: cells
      real(c_double), intent(in) :: xyz(3)
      integer(c_int32_t), intent(inout) :: cell
      integer(c_int32_t) :: status
    end function

    function hsp_cells_check(cells, topology, invariant, id) result(status) bind(C, name="hsp_cells_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: cells
      type(c_ptr), value :: topology  ! may be c_null_ptr
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    function hsp_model_arrangement(model, totals, of_ball, scratch, words, words_needed) result(status) &
      bind(C, name="hsp_model_arrangement")
      import :: c_int32_t, c_ptr, hsp_arrangement
      type(c_ptr), value :: model
      type(hsp_arrangement), intent(inout), optional :: totals
      type(hsp_arrangement), intent(inout), optional :: of_ball(*)  ! n
      integer(c_int32_t), intent(inout), optional :: scratch(*)  ! needed
      integer(c_int32_t), value :: words
      integer(c_int32_t), intent(inout) :: words_needed
      integer(c_int32_t) :: status
    end function

    ! ---- paths.h: how a probe gets from one point to another, and how wide one may be (Section 2) --------------------

    function hsp_paths_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_paths_limits_init")
      import :: c_int32_t, hsp_paths_limits
      type(hsp_paths_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_paths_bytes(limits, bytes) result(status) bind(C, name="hsp_paths_bytes")
      import :: c_int32_t, c_size_t, hsp_paths_limits
      type(hsp_paths_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_paths_init(memory, bytes, limits, paths) result(status) bind(C, name="hsp_paths_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_paths_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_paths_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: paths
      integer(c_int32_t) :: status
    end function

    function hsp_paths_compute(paths, model, limits) result(status) bind(C, name="hsp_paths_compute")
      import :: c_int32_t, c_ptr, hsp_paths_limits
      type(c_ptr), value :: paths
      type(c_ptr), value :: model
      type(hsp_paths_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_paths_find(paths, from, to, path, limits) result(status) bind(C, name="hsp_paths_find")
      import :: c_double, c_int32_t, c_ptr, hsp_path, hsp_paths_limits
      type(c_ptr), value :: paths
      real(c_double), intent(in) :: from(3)
      real(c_double), intent(in) :: to(3)
      type(hsp_path), intent(inout) :: path
      type(hsp_paths_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_paths_get_points(paths, points, capacity, needed) result(status) bind(C, name="hsp_paths_get_points")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: paths
      real(c_double), intent(inout), optional :: points(3, *)  ! 3, needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_gate_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_gate_limits_init")
      import :: c_int32_t, hsp_gate_limits
      type(hsp_gate_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_gate_bytes(limits, bytes) result(status) bind(C, name="hsp_gate_bytes")
      import :: c_int32_t, c_size_t, hsp_gate_limits
      type(hsp_gate_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_gate_init(memory, bytes, limits, gate) result(status) bind(C, name="hsp_gate_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_gate_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_gate_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: gate
      integer(c_int32_t) :: status
    end function

    function hsp_gate_compute(gate, model, from, to, limits) result(status) bind(C, name="hsp_gate_compute")
      import :: c_double, c_int32_t, c_ptr, hsp_gate_limits
      type(c_ptr), value :: gate
      type(c_ptr), value :: model
      real(c_double), intent(in) :: from(3)
      real(c_double), intent(in), optional :: to(3)
      type(hsp_gate_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_gate_get(gate, widest) result(status) bind(C, name="hsp_gate_get")
      import :: c_int32_t, c_ptr, hsp_widest_probe
      type(c_ptr), value :: gate
      type(hsp_widest_probe), intent(inout) :: widest
      integer(c_int32_t) :: status
    end function

    ! ---- view.h: pieces in painter's order as true arcs (Section 5.1) ------------------------------------------------

    function hsp_view_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_view_limits_init")
      import :: c_int32_t, hsp_view_limits
      type(hsp_view_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_view_bytes(limits, bytes) result(status) bind(C, name="hsp_view_bytes")
      import :: c_int32_t, c_size_t, hsp_view_limits
      type(hsp_view_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_view_init(memory, bytes, limits, view) result(status) bind(C, name="hsp_view_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_view_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_view_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: view
      integer(c_int32_t) :: status
    end function

    function hsp_view_options_init(options, struct_size) result(status) bind(C, name="hsp_view_options_init")
      import :: c_int32_t, hsp_view_options
      type(hsp_view_options), intent(inout) :: options
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t) :: status
    end function

    function hsp_view_options_turn(options, x, y, z) result(status) bind(C, name="hsp_view_options_turn")
      import :: c_double, c_int32_t, hsp_view_options
      type(hsp_view_options), intent(inout) :: options
      real(c_double), value :: x
      real(c_double), value :: y
      real(c_double), value :: z
      integer(c_int32_t) :: status
    end function

    function hsp_view_compute(view, model, boundary, options, limits) result(status) bind(C, name="hsp_view_compute")
      import :: c_int32_t, c_ptr, hsp_view_limits, hsp_view_options
      type(c_ptr), value :: view
      type(c_ptr), value :: model
      type(c_ptr), value :: boundary  ! may be c_null_ptr
      type(hsp_view_options), intent(in), optional :: options
      type(hsp_view_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_info(view, info) result(status) bind(C, name="hsp_view_get_info")
      import :: c_int32_t, c_ptr, hsp_view_info
      type(c_ptr), value :: view
      type(hsp_view_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_pieces(view, out, capacity, needed) result(status) bind(C, name="hsp_view_get_pieces")
      import :: c_int32_t, c_ptr, hsp_view_piece
      type(c_ptr), value :: view
      type(hsp_view_piece), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_loops(view, out, capacity, needed) result(status) bind(C, name="hsp_view_get_loops")
      import :: c_int32_t, c_ptr, hsp_view_loop
      type(c_ptr), value :: view
      type(hsp_view_loop), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_arcs(view, out, capacity, needed) result(status) bind(C, name="hsp_view_get_arcs")
      import :: c_int32_t, c_ptr, hsp_view_arc
      type(c_ptr), value :: view
      type(hsp_view_arc), intent(inout), optional :: out(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- map.h: what is seen as faces, edges and vertices of the view plane (Section 5.2) ----------------------------

    function hsp_map_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_map_limits_init")
      import :: c_int32_t, hsp_map_limits
      type(hsp_map_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_map_bytes(limits, bytes) result(status) bind(C, name="hsp_map_bytes")
      import :: c_int32_t, c_size_t, hsp_map_limits
      type(hsp_map_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_map_init(memory, bytes, limits, map) result(status) bind(C, name="hsp_map_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_map_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_map_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: map
      integer(c_int32_t) :: status
    end function

    function hsp_map_compute(map, model, options, limits) result(status) bind(C, name="hsp_map_compute")
      import :: c_int32_t, c_ptr, hsp_map_limits, hsp_view_options
      type(c_ptr), value :: map
      type(c_ptr), value :: model
      type(hsp_view_options), intent(in), optional :: options
      type(hsp_map_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_info(map, info) result(status) bind(C, name="hsp_map_get_info")
      import :: c_int32_t, c_ptr, hsp_map_info
      type(c_ptr), value :: map
      type(hsp_map_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_map_next(map, h) result(found) bind(C, name="hsp_map_next")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_map_previous(map, h) result(found) bind(C, name="hsp_map_previous")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_map_next_loop(map, h) result(found) bind(C, name="hsp_map_next_loop")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_map_origin(map, h) result(found) bind(C, name="hsp_map_origin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_map_left(map, h) result(found) bind(C, name="hsp_map_left")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h
      integer(c_int32_t) :: found
    end function

    function hsp_map_get_vertices(map, first, count, out) result(status) bind(C, name="hsp_map_get_vertices")
      import :: c_int32_t, c_ptr, hsp_map_vertex
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_vertex), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_edges(map, first, count, out) result(status) bind(C, name="hsp_map_get_edges")
      import :: c_int32_t, c_ptr, hsp_map_edge
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_edge), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_faces(map, first, count, out) result(status) bind(C, name="hsp_map_get_faces")
      import :: c_int32_t, c_ptr, hsp_map_face
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_face), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_areas(map, area, capacity, needed) result(status) bind(C, name="hsp_map_get_areas")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: map
      real(c_double), intent(inout), optional :: area(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_outline(map, ball, h, capacity, needed) result(status) bind(C, name="hsp_map_get_outline")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: ball
      integer(c_int32_t), intent(inout), optional :: h(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_map_pick(map, x, y, sight) result(status) bind(C, name="hsp_map_pick")
      import :: c_double, c_int32_t, c_ptr, hsp_map_sight
      type(c_ptr), value :: map
      real(c_double), value :: x
      real(c_double), value :: y
      type(hsp_map_sight), intent(inout) :: sight
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_point(map, edge, t, point) result(status) bind(C, name="hsp_map_get_point")
      import :: c_double, c_int32_t, c_ptr, hsp_map_point
      type(c_ptr), value :: map
      integer(c_int32_t), value :: edge
      real(c_double), value :: t
      type(hsp_map_point), intent(inout) :: point
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_pole(map, face, pole) result(status) bind(C, name="hsp_map_get_pole")
      import :: c_int32_t, c_ptr, hsp_map_pole
      type(c_ptr), value :: map
      integer(c_int32_t), value :: face
      type(hsp_map_pole), intent(inout) :: pole
      integer(c_int32_t) :: status
    end function

    function hsp_map_check(map, invariant, id) result(status) bind(C, name="hsp_map_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- sticks.h: balls and sticks in an order to paint them --------------------------------------------------------

    function hsp_sticks_limits_init(limits, struct_size, balls) result(status) bind(C, name="hsp_sticks_limits_init")
      import :: c_int32_t, hsp_sticks_limits
      type(hsp_sticks_limits), intent(inout) :: limits
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t), value :: balls
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_bytes(limits, bytes) result(status) bind(C, name="hsp_sticks_bytes")
      import :: c_int32_t, c_size_t, hsp_sticks_limits
      type(hsp_sticks_limits), intent(in) :: limits
      integer(c_size_t), intent(inout) :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_init(memory, bytes, limits, sticks) result(status) bind(C, name="hsp_sticks_init")
      import :: c_int32_t, c_ptr, c_size_t, hsp_sticks_limits
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(hsp_sticks_limits), intent(in) :: limits
      type(c_ptr), intent(inout) :: sticks
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_compute(sticks, model, options, stick, count, radius, conflict, limits) result(status) &
      bind(C, name="hsp_sticks_compute")
      import :: c_double, c_int32_t, c_ptr, hsp_stick, hsp_sticks_conflict, hsp_sticks_limits, hsp_view_options
      type(c_ptr), value :: sticks
      type(c_ptr), value :: model
      type(hsp_view_options), intent(in), optional :: options
      type(hsp_stick), intent(in), optional :: stick(*)  ! count
      integer(c_int32_t), value :: count
      real(c_double), value :: radius
      type(hsp_sticks_conflict), intent(inout), optional :: conflict
      type(hsp_sticks_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_compute_map(sticks, model, options, stick, count, radius, conflict, limits) result(status) &
      bind(C, name="hsp_sticks_compute_map")
      import :: c_double, c_int32_t, c_ptr, hsp_stick, hsp_sticks_conflict, hsp_sticks_limits, hsp_view_options
      type(c_ptr), value :: sticks
      type(c_ptr), value :: model
      type(hsp_view_options), intent(in), optional :: options
      type(hsp_stick), intent(in), optional :: stick(*)  ! count
      integer(c_int32_t), value :: count
      real(c_double), value :: radius
      type(hsp_sticks_conflict), intent(inout), optional :: conflict
      type(hsp_sticks_limits), intent(inout), optional :: limits
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_info(sticks, info) result(status) bind(C, name="hsp_sticks_get_info")
      import :: c_int32_t, c_ptr, hsp_sticks_info
      type(c_ptr), value :: sticks
      type(hsp_sticks_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_map_info(sticks, info) result(status) bind(C, name="hsp_sticks_get_map_info")
      import :: c_int32_t, c_ptr, hsp_map_info
      type(c_ptr), value :: sticks
      type(hsp_map_info), intent(inout) :: info
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_vertices(sticks, first, count, out) result(status) bind(C, name="hsp_sticks_get_vertices")
      import :: c_int32_t, c_ptr, hsp_map_vertex
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_vertex), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_edges(sticks, first, count, out) result(status) bind(C, name="hsp_sticks_get_edges")
      import :: c_int32_t, c_ptr, hsp_map_edge
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_edge), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_faces(sticks, first, count, out) result(status) bind(C, name="hsp_sticks_get_faces")
      import :: c_int32_t, c_ptr, hsp_map_face
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      type(hsp_map_face), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_areas(sticks, area, capacity, needed) result(status) bind(C, name="hsp_sticks_get_areas")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: sticks
      real(c_double), intent(inout), optional :: area(*)  ! needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_pick(sticks, x, y, sight) result(status) bind(C, name="hsp_sticks_pick")
      import :: c_double, c_int32_t, c_ptr, hsp_map_sight
      type(c_ptr), value :: sticks
      real(c_double), value :: x
      real(c_double), value :: y
      type(hsp_map_sight), intent(inout) :: sight
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_check(sticks, invariant, id) result(status) bind(C, name="hsp_sticks_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: sticks
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- picture.h: a view, a map, or balls and sticks as SVG, EPS or PDF --------------------------------------------

    function hsp_picture_options_init(options, struct_size) result(status) bind(C, name="hsp_picture_options_init")
      import :: c_int32_t, hsp_picture_options
      type(hsp_picture_options), intent(inout) :: options
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t) :: status
    end function

    pure function hsp_palette_colour(palette, atomic_number, chain) result(found) bind(C, name="hsp_palette_colour")
      import :: c_int32_t
      integer(c_int32_t), value :: palette
      integer(c_int32_t), value :: atomic_number
      integer(c_int32_t), value :: chain
      integer(c_int32_t) :: found
    end function

    function hsp_picture_write(view, colour, options, title, description, sink, context, bytes) result(status) &
      bind(C, name="hsp_picture_write")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: view
      integer(c_int32_t), intent(in), optional :: colour(*)  ! n
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink  ! of a function with the interface hsp_sink
      type(c_ptr), value :: context  ! may be c_null_ptr
      integer(c_int64_t), intent(inout), optional :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_picture_write_map(map, colour, options, title, description, sink, context, bytes) result(status) &
      bind(C, name="hsp_picture_write_map")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: map
      integer(c_int32_t), intent(in), optional :: colour(*)  ! n
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink  ! of a function with the interface hsp_sink
      type(c_ptr), value :: context  ! may be c_null_ptr
      integer(c_int64_t), intent(inout), optional :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_picture_write_sticks(sticks, colour, options, title, description, sink, context, bytes) &
      result(status) bind(C, name="hsp_picture_write_sticks")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: sticks
      integer(c_int32_t), intent(in), optional :: colour(*)  ! n
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink  ! of a function with the interface hsp_sink
      type(c_ptr), value :: context  ! may be c_null_ptr
      integer(c_int64_t), intent(inout), optional :: bytes
      integer(c_int32_t) :: status
    end function

  end interface

contains

  !> The element of a Fortran array (lower bound 1) that belongs to a 0-based id.
  elemental function hsp_index(id) result(index)
    integer(c_int32_t), intent(in) :: id
    integer(c_int32_t) :: index
    index = id + 1_c_int32_t
  end function

  ! ---- status.h

  !> hsp_status_text as a Fortran string.
  function hsp_status_message(status) result(message)
    integer(c_int32_t), intent(in) :: status
    character(len=:), allocatable :: message
    integer, parameter :: longest = 256
    character(kind=c_char), pointer :: text(:)
    integer :: i
    call c_f_pointer(hsp_status_text(status), text, [longest])
    message = ''
    do i = 1, longest
      if (text(i) == c_null_char) exit
      message = message//text(i)
    end do
  end function

  ! ---- topology.h

  !> HSP_QUAD_ROT of the header: from the right face to the left one. HSP_NONE yields HSP_NONE, here and below.
  elemental function hsp_quad_rot(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 1_c_int32_t)
  end function

  !> HSP_QUAD_INVERSE_ROT of the header: from the left face to the right one.
  elemental function hsp_quad_inverse_rot(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 3_c_int32_t)
  end function

  !> HSP_QUAD_SYM of the header: the same edge the other way.
  elemental function hsp_quad_sym(q) result(turned)
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: turned
    turned = quad_turned(q, 2_c_int32_t)
  end function

  elemental function quad_turned(q, quarters) result(turned)
    integer(c_int32_t), intent(in) :: q, quarters
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (q /= HSP_NONE) turned = ior(iand(q, not(3_c_int32_t)), iand(iand(q, 3_c_int32_t) + quarters, 3_c_int32_t))
  end function

  !> HSP_TOPOLOGY_OPREV of the header: the next edge clockwise about the origin of q.
  function hsp_topology_oprev(topology, q) result(found)
    type(c_ptr), intent(in) :: topology
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: found
    found = hsp_topology_lnext(topology, hsp_quad_sym(q))
  end function

  !> HSP_TOPOLOGY_LPREV of the header: the previous edge about the left face of q.
  function hsp_topology_lprev(topology, q) result(found)
    type(c_ptr), intent(in) :: topology
    integer(c_int32_t), intent(in) :: q
    integer(c_int32_t) :: found
    found = hsp_quad_sym(hsp_topology_onext(topology, q))
  end function

  ! ---- surface.h

  !> HSP_SURFACE_TWIN of the header: the directed edge h the other way.
  elemental function hsp_surface_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (h /= HSP_NONE) turned = ieor(h, 1_c_int32_t)
  end function

  ! ---- map.h

  !> HSP_MAP_TWIN of the header: the directed edge h the other way.
  elemental function hsp_map_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (h /= HSP_NONE) turned = ieor(h, 1_c_int32_t)
  end function

  ! ---- sticks.h

  !> HSP_STICKS_HALF of the header: the number of a half of a stick in a map of so many balls; all 0-based.
  elemental function hsp_sticks_half(balls, stick, half) result(number)
    integer(c_int32_t), intent(in) :: balls, stick, half
    integer(c_int32_t) :: number
    number = balls + 2_c_int32_t*stick + half
  end function

  ! ---- model.h: a set of balls on its lattice, and how well it behaves: k, rho, overlaps (Section 2) -----------------

  !> HSP_MODEL_BYTES of the header, for the size of an allocation.
  pure function hsp_model_bytes_bound(balls) result(bytes)
    integer(c_int32_t), intent(in) :: balls
    integer(c_size_t) :: bytes
    bytes = 1536_c_size_t + 128_c_size_t*int(balls, c_size_t)
  end function

  ! ---- pose.h: a molecule against a moved one: hits, pairs, gaps (Sections 3 and 6) ----------------------------------

  !> HSP_BODY_BYTES of the header, for the size of an allocation.
  pure function hsp_body_bytes_bound(balls) result(bytes)
    integer(c_int32_t), intent(in) :: balls
    integer(c_size_t) :: bytes
    bytes = 2048_c_size_t + 112_c_size_t*int(balls, c_size_t)
  end function

  ! ---- boundary.h: the boundary of the union: vertices, arcs, circles, faces (Section 4.2, Steps 1 and 2) ------------

  !> HSP_BOUNDARY_BYTES of the header, for the size of an allocation.
  pure function hsp_boundary_bytes_bound(balls, neighbours, vertices, circles) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, vertices, circles
    integer(c_size_t) :: bytes
    bytes = 5120_c_size_t + 64_c_size_t*int(balls, c_size_t) + 256_c_size_t*int(neighbours, c_size_t) &
      + 160_c_size_t*int(vertices, c_size_t) + 80_c_size_t*int(circles, c_size_t)
  end function

  !> HSP_WORKER_BYTES of the header, for the size of an allocation.
  pure function hsp_worker_bytes_bound(balls, neighbours, vertices, circles) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, vertices, circles
    integer(c_size_t) :: bytes
    bytes = 13312_c_size_t + 16_c_size_t*int(balls, c_size_t) + 416_c_size_t*int(neighbours, c_size_t) &
      + 16_c_size_t*int(vertices, c_size_t) + 16_c_size_t*int(circles, c_size_t)
  end function

  ! ---- moving.h: all of that while a few balls move at a time --------------------------------------------------------

  !> HSP_MOVING_BYTES of the header, for the size of an allocation.
  pure function hsp_moving_bytes_bound(balls, neighbours) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours
    integer(c_size_t) :: bytes
    bytes = 196608_c_size_t + 640_c_size_t*int(balls, c_size_t) + 1280_c_size_t*int(neighbours, c_size_t)
  end function

  ! ---- contacts.h: which balls touch and by how much, shares of the union, the dual complex --------------------------

  !> HSP_CONTACTS_BYTES of the header, for the size of an allocation.
  pure function hsp_contacts_bytes_bound(balls, neighbours, contacts, triangles, tetrahedra) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, contacts, triangles, tetrahedra
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 28_c_size_t*int(balls, c_size_t) + 208_c_size_t*int(neighbours, c_size_t) &
      + 60_c_size_t*int(contacts, c_size_t) + 16_c_size_t*int(triangles, c_size_t) &
      + 16_c_size_t*int(tetrahedra, c_size_t)
  end function

  ! ---- periodic.h: all of that in a box whose copies fill space: areas, volume, contacts, windings, strain -----------

  !> HSP_PERIODIC_BYTES of the header, for the size of an allocation.
  pure function hsp_periodic_bytes_bound(balls, images, neighbours, vertices, circles, contacts) result(bytes)
    integer(c_int32_t), intent(in) :: balls, images, neighbours, vertices, circles, contacts
    integer(c_size_t) :: bytes
    bytes = 16384_c_size_t + 384_c_size_t*int(balls, c_size_t) + 256_c_size_t*int(images, c_size_t) &
      + 448_c_size_t*int(neighbours, c_size_t) + 160_c_size_t*int(vertices, c_size_t) &
      + 80_c_size_t*int(circles, c_size_t) + 60_c_size_t*int(contacts, c_size_t)
  end function

  ! ---- surface.h: the smooth surface that a probe leaves, its area and volume (Section 4.3) --------------------------

  !> HSP_SURFACE_BYTES of the header, for the size of an allocation.
  pure function hsp_surface_bytes_bound(vertices, faces, neighbours, pieces, arcs, cusped_circles) result(bytes)
    integer(c_int32_t), intent(in) :: vertices, faces, neighbours, pieces, arcs, cusped_circles
    integer(c_size_t) :: bytes
    bytes = 8192_c_size_t + 54_c_size_t*int(vertices, c_size_t) + 9_c_size_t*int(faces, c_size_t) &
      + 1152_c_size_t*int(neighbours, c_size_t) + 106_c_size_t*int(pieces, c_size_t) &
      + 26_c_size_t*int(arcs, c_size_t) + 16_c_size_t*int(cusped_circles, c_size_t)
  end function

  ! ---- mesh.h: boundary or smooth surface as triangles ---------------------------------------------------------------

  !> HSP_MESH_BYTES of the header, for the size of an allocation.
  pure function hsp_mesh_bytes_bound(balls, curves, vertices, triangles, points) result(bytes)
    integer(c_int32_t), intent(in) :: balls, curves, vertices, triangles, points
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 16_c_size_t*int(balls, c_size_t) + 32_c_size_t*int(curves, c_size_t) &
      + 64_c_size_t*int(vertices, c_size_t) + 32_c_size_t*int(triangles, c_size_t) + 384_c_size_t*int(points, c_size_t)
  end function

  ! ---- topology.h: the boundary as quad-edges with simple faces, shells, cells, point location (Step 3) --------------

  !> HSP_TOPOLOGY_BYTES of the header, for the size of an allocation.
  pure function hsp_topology_bytes_bound(balls, neighbours, edges, cut_arcs) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, edges, cut_arcs
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 64_c_size_t*int(balls, c_size_t) + 192_c_size_t*int(neighbours, c_size_t) &
      + 112_c_size_t*int(edges, c_size_t) + 96_c_size_t*int(cut_arcs, c_size_t)
  end function

  ! ---- cells.h: what no ball covers as simple cells, their neighbours, point location (Section 2) --------------------

  !> HSP_CELLS_BYTES of the header, for the size of an allocation.
  pure function hsp_cells_bytes_bound(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
    cube_corners) result(bytes)
    integer(c_int32_t), intent(in) :: cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
      cube_corners
    integer(c_size_t) :: bytes
    bytes = 24576_c_size_t + 128_c_size_t*int(cubes, c_size_t) + 8_c_size_t*int(entries, c_size_t) &
      + 28_c_size_t*int(cells, c_size_t) + 16_c_size_t*int(adjacencies, c_size_t) &
      + 12_c_size_t*int(landmarks, c_size_t) + 72_c_size_t*int(facets, c_size_t) + 48_c_size_t*int(corners, c_size_t) &
      + 1536_c_size_t*int(cube_balls, c_size_t) + 64_c_size_t*int(cube_corners, c_size_t)
  end function

  ! ---- paths.h: how a probe gets from one point to another, and how wide one may be (Section 2) ----------------------

  !> HSP_PATHS_BYTES of the header, for the size of an allocation.
  pure function hsp_paths_bytes_bound(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
    cube_corners, points) result(bytes)
    integer(c_int32_t), intent(in) :: cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
      cube_corners, points
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 128_c_size_t*int(cubes, c_size_t) + 8_c_size_t*int(entries, c_size_t) &
      + 136_c_size_t*int(cells, c_size_t) + 48_c_size_t*int(adjacencies, c_size_t) &
      + 12_c_size_t*int(landmarks, c_size_t) + 72_c_size_t*int(facets, c_size_t) + 48_c_size_t*int(corners, c_size_t) &
      + 2176_c_size_t*int(cube_balls, c_size_t) + 64_c_size_t*int(cube_corners, c_size_t) &
      + 24_c_size_t*int(points, c_size_t)
  end function

  !> HSP_GATE_BYTES of the header, for the size of an allocation.
  pure function hsp_gate_bytes_bound(balls, cubes, entries, cells, adjacencies, landmarks, facets, corners, &
    cube_balls, cube_corners) result(bytes)
    integer(c_int32_t), intent(in) :: balls, cubes, entries, cells, adjacencies, landmarks, facets, corners, &
      cube_balls, cube_corners
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 160_c_size_t*int(balls, c_size_t) + 128_c_size_t*int(cubes, c_size_t) &
      + 8_c_size_t*int(entries, c_size_t) + 28_c_size_t*int(cells, c_size_t) + 16_c_size_t*int(adjacencies, c_size_t) &
      + 12_c_size_t*int(landmarks, c_size_t) + 72_c_size_t*int(facets, c_size_t) + 48_c_size_t*int(corners, c_size_t) &
      + 1536_c_size_t*int(cube_balls, c_size_t) + 64_c_size_t*int(cube_corners, c_size_t)
  end function

  ! ---- view.h: pieces in painter's order as true arcs (Section 5.1) --------------------------------------------------

  !> HSP_VIEW_BYTES of the header, for the size of an allocation.
  pure function hsp_view_bytes_bound(balls, neighbours, arcs) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, arcs
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 192_c_size_t*int(balls, c_size_t) + 384_c_size_t*int(neighbours, c_size_t) &
      + 64_c_size_t*int(arcs, c_size_t)
  end function

  ! ---- map.h: what is seen as faces, edges and vertices of the view plane (Section 5.2) ------------------------------

  !> HSP_MAP_BYTES of the header, for the size of an allocation.
  pure function hsp_map_bytes_bound(balls, neighbours, edges) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, edges
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 288_c_size_t*int(balls, c_size_t) + 208_c_size_t*int(neighbours, c_size_t) &
      + 352_c_size_t*int(edges, c_size_t)
  end function

  ! ---- sticks.h: balls and sticks in an order to paint them ----------------------------------------------------------

  !> HSP_STICKS_BYTES of the header, for the size of an allocation.
  pure function hsp_sticks_bytes_bound(balls, sticks, pairs, edges) result(bytes)
    integer(c_int32_t), intent(in) :: balls, sticks, pairs, edges
    integer(c_size_t) :: bytes
    bytes = 16384_c_size_t + 192_c_size_t*int(balls, c_size_t) + 384_c_size_t*int(sticks, c_size_t) &
      + 20_c_size_t*int(pairs, c_size_t) + 400_c_size_t*int(edges, c_size_t)
  end function

end module hardsphere
