! The Fortran module of hardsphere: the C interface of include/hardsphere.h, name for name.
!
! EVERY ID IN THIS MODULE IS 0-BASED, AS IN C: OF BALLS, VERTICES, ARCS, CIRCLES, FACES, SHELLS, COMPONENTS, EDGES,
! QUARTER-EDGES, SIMPLE FACES, CELLS, PIECES AND LOOPS.
! THE FORTRAN ARRAY ELEMENT OF ID i IS THEREFORE i + 1; hsp_index(i) COMPUTES THAT.
!
! What each function does, its statuses and its costs are documented in hardsphere.h; nothing of that changes here.
! How C maps to Fortran:
!   double xyz[n][3]             real(c_double) :: xyz(3, n)
!   uint32_t onext[edges][4]     integer(c_int32_t) :: onext(0:3, 0:edges - 1), and indices are ids
!   uint32_t                     integer(c_int32_t); values above huge() appear negative: HSP_NONE is -1
!   uint8_t selected[n]          integer(c_int8_t) :: selected(n), 0 or not 0
!   hsp_model *, hsp_boundary *,
!   hsp_surface *, hsp_mesh *,
!   hsp_topology *, hsp_view *,
!   hsp_map *, hsp_sticks *,
!   hsp_contacts *, hsp_cells *,
!   hsp_body *, hsp_paths *,
!   hsp_gate *, hsp_periodic *,
!   hsp_moving *                 type(c_ptr)
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

  integer(c_int32_t), parameter :: HSP_VERSION_MAJOR = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_VERSION_MINOR = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_VERSION_PATCH = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_VERSION_NUMBER = 200_c_int32_t
  character(*), parameter :: HSP_VERSION_STRING = '0.2.0'
  integer(c_int32_t), parameter :: HSP_ABI_NUMBER = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_NUMERICS_NUMBER = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_OK = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_ARGUMENT = -1_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_CAPACITY = -2_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_MEMORY = -3_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_STATE = -4_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_ID = -5_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_CHECK = -6_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_SINK = -7_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_HANDLE = -8_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_VERSION = -9_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_NOT_FINITE = -10_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_NEGATIVE = -11_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_RANGE = -12_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_CONFLICT = -13_c_int32_t
  integer(c_int32_t), parameter :: HSP_E_OPEN_SURFACE = -14_c_int32_t

  integer(c_int32_t), parameter :: HSP_PICTURE_MEMORY = 71680_c_int32_t ! bytes

  integer(c_int32_t), parameter :: HSP_NONE = -1_c_int32_t              ! 0xFFFFFFFF
  integer(c_int32_t), parameter :: HSP_MAX_BALLS = 268435455_c_int32_t  ! 0x0FFFFFFF
  integer(c_int32_t), parameter :: HSP_MAX_WORKERS = 1024_c_int32_t

  integer(c_int32_t), parameter :: HSP_RADII_BONDI = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_RADII_CHEM3D = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_RADIUS_FALLBACK = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_PACKING_ZERO_RADIUS = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PACKING_COINCIDENT = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_PACKING_NO_PAIR = 4_c_int32_t
  integer(c_int32_t), parameter :: HSP_PAIRS_ONCE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_VERTEX_TIED = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_BALL_CONTAINED = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_TANGENT_OVERLAP = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_TANGENT_DISJOINT = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_GRADIENT_ONE_SIDED = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_CURVATURE_ONE_SIDED = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_CONTACT_TOUCHING = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_CONTACT_BURIED = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_CONTACT_CIRCLE = 4_c_int32_t
  integer(c_int32_t), parameter :: HSP_SIMPLEX_SINGULAR = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_SIMPLEX_REGULAR = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_SIMPLEX_INTERIOR = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_SURFACE_DEGENERATE = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_PATCH_CONVEX = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_PATCH_SADDLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PATCH_CONCAVE = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_POINT_VERTEX = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_POINT_CIRCLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_POINT_POLE = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_EDGE_ARC = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_EDGE_CIRCLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_EDGE_CUT = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_SHELL_OUTER = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_SHELL_VOID = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_PATCH_CIRCLE_SADDLE = 3_c_int32_t
  integer(c_int32_t), parameter :: HSP_SURFACE_RIM = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_SURFACE_CIRCLE_RIM = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_SURFACE_SIDE = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_SURFACE_CREASE = 3_c_int32_t
  integer(c_int32_t), parameter :: HSP_CORNER_BALL = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_CORNER_CUSP = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_CORNER_CREASE = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_PIECES_OUTSIDE_FARTHER = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_PIECES_OUTSIDE_ALL = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_VIEW_ALL_BALLS = 1_c_int32_t

  integer(c_int32_t), parameter :: HSP_MAP_PLAIN = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_MAP_TRIPLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_MAP_T = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_MAP_TANGENCY = 3_c_int32_t
  integer(c_int32_t), parameter :: HSP_MAP_HALVES = 4_c_int32_t

  integer(c_int32_t), parameter :: HSP_CELL_RUN = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_CELL_AT_BALL = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_CELL_APART = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_PATH_CONNECTED = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_PATH_APART = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PATH_COVERED = 2_c_int32_t

  integer(c_int32_t), parameter :: HSP_STICK_WHOLE = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_NO_CONFLICT = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_BALLS_MEET = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_NO_BALL = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_SAME_ENDS = 3_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_THIN_BALL = 4_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_SHARP_ANGLE = 5_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_MEET = 6_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_STICK_IN_BALL = 7_c_int32_t
  integer(c_int32_t), parameter :: HSP_STICKS_CYCLE = 8_c_int32_t

  integer(c_int32_t), parameter :: HSP_FORMAT_SVG = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_FORMAT_EPS = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_FORMAT_PDF = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_STYLE_FLAT = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_STYLE_HEADLIGHT = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_STYLE_SOFT = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_UNIT_PX = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_UNIT_MM = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PICTURE_NO_IDS = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PICTURE_NO_BACKGROUND = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_INK_BORDER = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_INK_GROUP = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_INK_DEPTH = 2_c_int32_t
  integer(c_int32_t), parameter :: HSP_PALETTE_SOFT = 0_c_int32_t
  integer(c_int32_t), parameter :: HSP_PALETTE_JMOL = 1_c_int32_t
  integer(c_int32_t), parameter :: HSP_PALETTE_CHAIN = 2_c_int32_t

  type, bind(C) :: hsp_model_options
    integer(c_int32_t) :: struct_size  ! hsp_model_options_init sets it
    integer(c_int32_t) :: reserved
    real(c_double) :: probe            ! length, >= 0
    real(c_double) :: step             ! length; 0: chosen from the largest radius
    real(c_double) :: largest_radius   ! length; 0: that of the balls
  end type

  type, bind(C) :: hsp_model_info
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: cubes
    integer(c_int32_t) :: table_slots
    integer(c_int32_t) :: longest_probe
    real(c_double) :: step             ! length
    real(c_double) :: probe            ! length
    real(c_double) :: largest_radius   ! length
  end type

  type, bind(C) :: hsp_packing
    real(c_double) :: k
    real(c_double) :: rho
    real(c_double) :: mean_overlaps
    real(c_double) :: neighbour_bound
    integer(c_int32_t) :: max_overlaps
    integer(c_int32_t) :: flags        ! HSP_PACKING_*
  end type

  type, bind(C) :: hsp_ray_hit
    real(c_double) :: xyz(3)           ! length
    real(c_double) :: distance         ! length
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_boundary_limits
    integer(c_int32_t) :: struct_size  ! hsp_boundary_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: circles
    integer(c_int32_t) :: workers           ! 0: one
  end type

  type, bind(C) :: hsp_boundary_counts
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: exposed_balls
    integer(c_int32_t) :: contained_balls
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: circles
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: components
    integer(c_int32_t) :: voids
    integer(c_int32_t) :: tied_vertices
    integer(c_int64_t) :: euler
  end type

  type, bind(C) :: hsp_vertex
    real(c_double) :: xyz(3)           ! length
    integer(c_int32_t) :: ball(3)      ! 0-based
    integer(c_int32_t) :: sign         ! +1 or -1
    integer(c_int32_t) :: flags        ! HSP_VERTEX_*
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_arc
    real(c_double) :: centre(3)        ! length
    real(c_double) :: axis(3)          ! unit vector
    real(c_double) :: radius           ! length
    real(c_double) :: angle            ! radians
    integer(c_int32_t) :: ball(2)      ! 0-based
    integer(c_int32_t) :: vertex(2)    ! 0-based
    integer(c_int32_t) :: face(2)      ! 0-based
  end type

  type, bind(C) :: hsp_circle
    real(c_double) :: centre(3)        ! length
    real(c_double) :: axis(3)          ! unit vector
    real(c_double) :: radius           ! length
    integer(c_int32_t) :: ball(2)      ! 0-based
    integer(c_int32_t) :: face(2)      ! 0-based
  end type

  type, bind(C) :: hsp_face
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: shell        ! 0-based
    integer(c_int32_t) :: first_loop   ! 0-based
  end type

  type, bind(C) :: hsp_loop
    integer(c_int32_t) :: face         ! 0-based
    integer(c_int32_t) :: circle       ! 0-based, HSP_NONE if it consists of arcs
    integer(c_int32_t) :: side         ! 0 or 1
    integer(c_int32_t) :: first_arc    ! 0-based
    integer(c_int32_t) :: arcs
  end type

  type, bind(C) :: hsp_loop_arc
    integer(c_int32_t) :: arc          ! 0-based
    integer(c_int32_t) :: side         ! 0 or 1
    integer(c_int32_t) :: vertex       ! 0-based
  end type

  type, bind(C) :: hsp_ball
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: first_face   ! 0-based, HSP_NONE if the ball is buried
    integer(c_int32_t) :: component    ! 0-based
    integer(c_int32_t) :: flags        ! HSP_BALL_*
  end type

  type, bind(C) :: hsp_totals
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
  end type

  type, bind(C) :: hsp_energy
    real(c_double) :: value            ! tension*area + pressure*volume
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    real(c_double) :: d_probe          ! dE/d(probe)
  end type

  type, bind(C) :: hsp_pose
    real(c_double) :: quaternion(4)    ! w x y z, of any length but 0
    real(c_double) :: translation(3)   ! length
  end type

  type, bind(C) :: hsp_rational_pose
    integer(c_int32_t) :: quaternion(4) ! w x y z, not all 0
    real(c_double) :: translation(3)   ! length
  end type

  type, bind(C) :: hsp_body_gap
    real(c_double) :: gap              ! length
    integer(c_int32_t) :: fixed        ! ball of the body at rest
    integer(c_int32_t) :: moving
  end type

  type, bind(C) :: hsp_body_overlap
    real(c_double) :: volume           ! length^3, summed pair by pair
    integer(c_int32_t) :: pairs
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_curvatures
    real(c_double) :: mean             ! length
    real(c_double) :: gauss
  end type

  type, bind(C) :: hsp_morphometry
    real(c_double) :: pressure         ! factors: of the volume,
    real(c_double) :: tension          ! of the weighted area,
    real(c_double) :: bending          ! of the weighted mean curvature
    real(c_double) :: gaussian         ! and of the Gaussian curvature
  end type

  type, bind(C) :: hsp_morphometric_energy
    real(c_double) :: value
    real(c_double) :: volume           ! length^3
    real(c_double) :: area             ! length^2
    real(c_double) :: mean             ! length
    real(c_double) :: gauss
    real(c_double) :: d_probe          ! dE/d(probe)
  end type

  type, bind(C) :: hsp_contacts_limits
    integer(c_int32_t) :: struct_size  ! hsp_contacts_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: contacts
    integer(c_int32_t) :: triangles    ! to keep; 0: they are only counted
    integer(c_int32_t) :: tetrahedra   ! the same
  end type

  type, bind(C) :: hsp_contact
    real(c_double) :: area             ! length^2
    real(c_double) :: edge             ! length of its border on the surface
    real(c_double) :: distance         ! of the centres
    integer(c_int32_t) :: ball(2)      ! a < b
    integer(c_int32_t) :: chords       ! straight sides
    integer(c_int32_t) :: flags        ! HSP_CONTACT_*
    integer(c_int32_t) :: reserved(2)  ! 0
  end type

  type, bind(C) :: hsp_periodic_limits
    integer(c_int32_t) :: struct_size  ! hsp_periodic_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: images
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: vertices     ! once from each side of the box
    integer(c_int32_t) :: circles
    integer(c_int32_t) :: contacts
  end type

  type, bind(C) :: hsp_periodic_counts
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: images
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: circles
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: components
    integer(c_int32_t) :: contacts
    integer(c_int32_t) :: euler
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_periodic_totals
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    real(c_double) :: box_volume
    real(c_double) :: free_volume
    real(c_double) :: contact_area
  end type

  type, bind(C) :: hsp_periodic_contact
    real(c_double) :: area             ! length^2
    real(c_double) :: edge             ! length of its border on the surface
    real(c_double) :: distance         ! of the centres
    integer(c_int32_t) :: ball(2)      ! a <= b
    integer(c_int32_t) :: chords       ! straight sides
    integer(c_int32_t) :: flags        ! HSP_CONTACT_*
    integer(c_int32_t) :: shift(3)     ! of ball b
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_winding
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: first        ! ball
    integer(c_int32_t) :: directions   ! 0 to 3
    integer(c_int32_t) :: copies
    integer(c_int32_t) :: row(9)       ! the first row first
  end type

  type, bind(C) :: hsp_image
    integer(c_int32_t) :: ball
    integer(c_int32_t) :: shift(3)
  end type

  type, bind(C) :: hsp_periodic_id
    integer(c_int32_t) :: id
    integer(c_int32_t) :: shift(3)
  end type

  type, bind(C) :: hsp_periodic_vertex
    real(c_double) :: xyz(3)                   ! length
    type(hsp_image) :: image(3)                ! its balls, the first one at its place
    integer(c_int32_t) :: sign                 ! +1 or -1
    integer(c_int32_t) :: flags                ! HSP_VERTEX_*
  end type

  type, bind(C) :: hsp_periodic_arc
    real(c_double) :: centre(3)                ! of its circle, length
    real(c_double) :: axis(3)                  ! unit vector from ball a towards ball b
    real(c_double) :: radius                   ! length
    real(c_double) :: angle                    ! from its first vertex to its second
    type(hsp_image) :: image(2)                ! its balls, the first one at its place
    type(hsp_periodic_id) :: vertex(2)         ! where it starts and where it ends
    type(hsp_periodic_id) :: face(2)           ! on ball a and on ball b
  end type

  type, bind(C) :: hsp_periodic_circle
    real(c_double) :: centre(3)                ! length
    real(c_double) :: axis(3)                  ! unit vector from ball a towards ball b
    real(c_double) :: radius                   ! length
    type(hsp_image) :: image(2)                ! its balls, the first one at its place
    type(hsp_periodic_id) :: face(2)           ! on ball a and on ball b
  end type

  type, bind(C) :: hsp_periodic_face
    type(hsp_image) :: image                   ! its ball, at its place
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: shell
    integer(c_int32_t) :: first_loop
    integer(c_int32_t) :: reserved             ! 0
  end type

  type, bind(C) :: hsp_periodic_loop
    type(hsp_periodic_id) :: circle            ! HSP_NONE if it consists of arcs
    integer(c_int32_t) :: face
    integer(c_int32_t) :: side
    integer(c_int32_t) :: first_arc
    integer(c_int32_t) :: arcs
  end type

  type, bind(C) :: hsp_periodic_loop_arc
    type(hsp_periodic_id) :: arc
    type(hsp_periodic_id) :: vertex            ! where the loop comes to it
    integer(c_int32_t) :: side
    integer(c_int32_t) :: reserved             ! 0
  end type

  type, bind(C) :: hsp_moving_limits
    integer(c_int32_t) :: struct_size     ! hsp_moving_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
  end type

  type, bind(C) :: hsp_moving_info
    real(c_double) :: step                ! length
    real(c_double) :: probe               ! length
    real(c_double) :: largest_radius      ! with the probe, length
    integer(c_int64_t) :: vertices
    integer(c_int64_t) :: arcs
    integer(c_int64_t) :: circles
    integer(c_int64_t) :: faces
    integer(c_int64_t) :: loops
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: exposed_balls
    integer(c_int32_t) :: contained_balls
    integer(c_int32_t) :: components
    integer(c_int32_t) :: changed
    integer(c_int32_t) :: reserved        ! 0
  end type

  type, bind(C) :: hsp_moving_ball
    real(c_double) :: centre(3)           ! length
    real(c_double) :: radius              ! with the probe, length
    real(c_double) :: area                ! length^2
    real(c_double) :: volume              ! length^3
    real(c_double) :: d_centre(3)
    real(c_double) :: d_radius
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: flags           ! HSP_BALL_*
    integer(c_int32_t) :: gradient_flags  ! HSP_GRADIENT_*
    integer(c_int32_t) :: reserved        ! 0
  end type

  type, bind(C) :: hsp_group_contact
    real(c_double) :: area             ! length^2
    real(c_double) :: edge             ! length
    integer(c_int32_t) :: group(2)     ! g < h
    integer(c_int32_t) :: contacts
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_complex
    integer(c_int32_t) :: singular(4)  ! balls, edges, triangles, tetrahedra
    integer(c_int32_t) :: regular(4)
    integer(c_int32_t) :: interior(4)
    integer(c_int32_t) :: euler
    integer(c_int32_t) :: betti(3)     ! components, tunnels, voids
  end type

  type, bind(C) :: hsp_simplex
    integer(c_int32_t) :: ball(4)      ! ascending; the last one of a triangle is HSP_NONE
    integer(c_int32_t) :: kind         ! HSP_SIMPLEX_*
    integer(c_int32_t) :: reserved     ! 0
  end type

  type, bind(C) :: hsp_area_derivative
    real(c_double) :: centre(3)        ! dA_i/dc_j, length
    real(c_double) :: radius           ! dA_i/dr_j, length
    real(c_double) :: angle            ! radians
    integer(c_int32_t) :: ball         ! j, 0-based
    integer(c_int32_t) :: flags        ! HSP_GRADIENT_*
  end type

  type, bind(C) :: hsp_surface_limits
    integer(c_int32_t) :: struct_size  ! hsp_surface_limits_init sets it
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: pieces
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: cusped_circles
  end type

  type, bind(C) :: hsp_surface_counts
    integer(c_int32_t) :: convex_patches
    integer(c_int32_t) :: saddle_patches
    integer(c_int32_t) :: concave_patches
    integer(c_int32_t) :: cusped_patches
    integer(c_int32_t) :: cut_patches
    integer(c_int32_t) :: hidden_patches
    integer(c_int32_t) :: rounded_patches
    integer(c_int32_t) :: open_joints
  end type

  type, bind(C) :: hsp_surface_map_counts
    integer(c_int32_t) :: patches
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: corners
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: cusps
    integer(c_int32_t) :: junctions
    integer(c_int32_t) :: creases
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_surface_patch
    real(c_double) :: area             ! length^2
    integer(c_int32_t) :: kind         ! HSP_PATCH_*
    integer(c_int32_t) :: source       ! 0-based
    integer(c_int32_t) :: part         ! 0-based
    integer(c_int32_t) :: shell        ! 0-based
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: h            ! a directed edge, 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_surface_edge
    real(c_double) :: centre(3)        ! length
    real(c_double) :: axis(3)          ! unit vector
    real(c_double) :: radius           ! length
    real(c_double) :: angle            ! radians
    integer(c_int32_t) :: patch(2)     ! 0-based, left and right
    integer(c_int32_t) :: corner(2)    ! 0-based
    integer(c_int32_t) :: next(2)      ! directed edges, 0-based
    integer(c_int32_t) :: previous(2)  ! directed edges, 0-based
    integer(c_int32_t) :: kind         ! HSP_SURFACE_*
    integer(c_int32_t) :: source       ! 0-based, HSP_NONE for creases
  end type

  type, bind(C) :: hsp_surface_corner
    real(c_double) :: xyz(3)           ! length
    integer(c_int32_t) :: kind         ! HSP_CORNER_*
    integer(c_int32_t) :: ball(2)      ! 0-based
    integer(c_int32_t) :: vertex(3)    ! 0-based
    integer(c_int32_t) :: shell        ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_surface_shell
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    integer(c_int32_t) :: euler
    integer(c_int32_t) :: genus
    integer(c_int32_t) :: patches
    integer(c_int32_t) :: chosen
  end type

  type, bind(C) :: hsp_surface_totals
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    real(c_double) :: convex_area      ! length^2
    real(c_double) :: saddle_area      ! length^2
    real(c_double) :: concave_area     ! length^2
  end type

  type, bind(C) :: hsp_mesh_limits
    integer(c_int32_t) :: struct_size  ! hsp_mesh_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: curves
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: triangles
    integer(c_int32_t) :: points
  end type

  type, bind(C) :: hsp_mesh_counts
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: triangles
    integer(c_int32_t) :: curves
    integer(c_int32_t) :: refined
  end type

  type, bind(C) :: hsp_topology_limits
    integer(c_int32_t) :: struct_size  ! hsp_topology_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: cut_arcs
    integer(c_int32_t) :: shells
  end type

  type, bind(C) :: hsp_topology_counts
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: simple_faces
    integer(c_int32_t) :: cut_edges
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: components
    integer(c_int32_t) :: cells
    integer(c_int32_t) :: start_face   ! 0-based, HSP_NONE if there are no balls
  end type

  type, bind(C) :: hsp_topology_vertex
    real(c_double) :: xyz(3)           ! length
    integer(c_int32_t) :: ball(3)      ! 0-based, HSP_NONE for those there are not
    integer(c_int32_t) :: kind         ! HSP_POINT_*
    integer(c_int32_t) :: q            ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_topology_edge
    real(c_double) :: centre(3)        ! length
    real(c_double) :: axis(3)          ! unit vector
    real(c_double) :: radius           ! length
    real(c_double) :: angle            ! radians
    integer(c_int32_t) :: vertex(2)    ! 0-based, origin and destination
    integer(c_int32_t) :: face(2)      ! 0-based, left and right
    integer(c_int32_t) :: ball(2)      ! 0-based, left and right
    integer(c_int32_t) :: kind         ! HSP_EDGE_*
    integer(c_int32_t) :: source       ! 0-based, HSP_NONE for cut edges
  end type

  type, bind(C) :: hsp_simple_face
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: face         ! 0-based
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: q            ! 0-based
    integer(c_int32_t) :: shell        ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_shell
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    real(c_double) :: point(3)         ! length
    integer(c_int32_t) :: euler
    integer(c_int32_t) :: genus
    integer(c_int32_t) :: kind         ! HSP_SHELL_*
    integer(c_int32_t) :: component    ! 0-based
    integer(c_int32_t) :: cell         ! 0-based
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: simple_faces
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: start_face   ! 0-based
  end type

  type, bind(C) :: hsp_component
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: top_ball     ! 0-based
    integer(c_int32_t) :: outer_shell  ! 0-based
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: cell         ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_cell
    real(c_double) :: area             ! length^2
    real(c_double) :: volume           ! length^3
    integer(c_int32_t) :: enclosing_shell ! 0-based, HSP_NONE for cell 0
    integer(c_int32_t) :: components
    integer(c_int32_t) :: shells
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_view_limits
    integer(c_int32_t) :: struct_size  ! hsp_view_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: arcs
  end type

  type, bind(C) :: hsp_view_options
    integer(c_int32_t) :: struct_size  ! hsp_view_options_init sets it
    integer(c_int32_t) :: pieces       ! HSP_PIECES_*
    integer(c_int32_t) :: flags        ! HSP_VIEW_*
    integer(c_int32_t) :: reserved
    real(c_double) :: towards(3)       ! of any length; 0 0 0: 0 0 1
    real(c_double) :: up(3)            ! of any length; 0 0 0: 0 1 0
  end type

  type, bind(C) :: hsp_view_info
    real(c_double) :: origin(3)        ! length
    real(c_double) :: right(3)         ! unit vector
    real(c_double) :: up(3)            ! unit vector
    real(c_double) :: towards(3)       ! unit vector
    real(c_double) :: low(2)           ! length
    real(c_double) :: high(2)          ! length
    real(c_double) :: depth_low        ! length
    real(c_double) :: depth_high       ! length
    integer(c_int32_t) :: pieces
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: kind         ! HSP_PIECES_*
  end type

  type, bind(C) :: hsp_view_piece
    real(c_double) :: centre(2)        ! length
    real(c_double) :: depth            ! length
    real(c_double) :: radius           ! length
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: first_loop   ! 0-based
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: first_arc    ! 0-based
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_view_loop
    integer(c_int32_t) :: piece        ! 0-based
    integer(c_int32_t) :: first_arc    ! 0-based
    integer(c_int32_t) :: arcs
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_view_arc
    real(c_double) :: centre(2)        ! length
    real(c_double) :: semi_axis(2)     ! length, the larger one first
    real(c_double) :: rotation         ! radians
    real(c_double) :: from             ! radians
    real(c_double) :: to               ! radians
    real(c_double) :: start(2)         ! length
    real(c_double) :: end(2)           ! length
    integer(c_int32_t) :: piece        ! 0-based
    integer(c_int32_t) :: other_ball   ! 0-based, HSP_NONE on the silhouette
  end type

  type, bind(C) :: hsp_map_limits
    integer(c_int32_t) :: struct_size  ! hsp_map_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: edges
  end type

  type, bind(C) :: hsp_map_info
    real(c_double) :: origin(3)        ! length
    real(c_double) :: right(3)
    real(c_double) :: up(3)
    real(c_double) :: towards(3)
    real(c_double) :: area             ! length^2
    real(c_double) :: perturbation     ! length
    integer(c_int32_t) :: vertices
    integer(c_int32_t) :: edges
    integer(c_int32_t) :: faces
    integer(c_int32_t) :: components
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_map_vertex
    real(c_double) :: xyz(3)           ! length
    integer(c_int32_t) :: kind         ! HSP_MAP_*
    integer(c_int32_t) :: h            ! 0-based
    integer(c_int32_t) :: ball(3)      ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_map_edge
    real(c_double) :: centre(2)        ! length
    real(c_double) :: first(2)         ! length
    real(c_double) :: second(2)        ! length
    real(c_double) :: from             ! radians
    real(c_double) :: to               ! radians
    integer(c_int32_t) :: ball(2)      ! 0-based
    integer(c_int32_t) :: face(2)      ! 0-based
    integer(c_int32_t) :: vertex(2)    ! 0-based
    integer(c_int32_t) :: next(2)      ! 0-based
  end type

  type, bind(C) :: hsp_map_face
    real(c_double) :: area             ! length^2
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: h            ! 0-based
    integer(c_int32_t) :: loops
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_map_sight
    real(c_double) :: depth            ! length
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: face         ! 0-based
  end type

  type, bind(C) :: hsp_map_point
    real(c_double) :: xyz(3)           ! length
    real(c_double) :: gap(2)           ! length
  end type

  type, bind(C) :: hsp_map_pole
    real(c_double) :: centre(2)        ! length
    real(c_double) :: radius           ! length
    real(c_double) :: bound            ! length
  end type

  type, bind(C) :: hsp_cells_limits
    integer(c_int32_t) :: struct_size  ! hsp_cells_limits_init sets it
    integer(c_int32_t) :: cubes
    integer(c_int32_t) :: entries
    integer(c_int32_t) :: cells
    integer(c_int32_t) :: adjacencies
    integer(c_int32_t) :: landmarks
    integer(c_int32_t) :: facets
    integer(c_int32_t) :: corners
    integer(c_int32_t) :: cube_balls
    integer(c_int32_t) :: cube_corners
  end type

  type, bind(C) :: hsp_cells_counts
    integer(c_int32_t) :: cubes
    integer(c_int32_t) :: power_cells
    integer(c_int32_t) :: cells
    integer(c_int32_t) :: runs
    integer(c_int32_t) :: adjacencies
    integer(c_int32_t) :: regions
  end type

  type, bind(C) :: hsp_free_cell
    real(c_double) :: low(3)           ! length
    real(c_double) :: high(3)          ! length
    integer(c_int32_t) :: ball         ! 0-based
    integer(c_int32_t) :: cube         ! 0-based
    integer(c_int32_t) :: kind         ! HSP_CELL_*
    integer(c_int32_t) :: region       ! 0-based
    integer(c_int32_t) :: neighbours
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_cell_pair
    integer(c_int32_t) :: cell(2)      ! 0-based
  end type

  type, bind(C) :: hsp_arrangement
    integer(c_int64_t) :: vertices
    integer(c_int64_t) :: edges
    integer(c_int64_t) :: faces
  end type

  type, bind(C) :: hsp_paths_limits
    integer(c_int32_t) :: struct_size  ! hsp_paths_limits_init sets it
    integer(c_int32_t) :: cubes
    integer(c_int32_t) :: entries
    integer(c_int32_t) :: cells
    integer(c_int32_t) :: adjacencies
    integer(c_int32_t) :: landmarks
    integer(c_int32_t) :: facets
    integer(c_int32_t) :: corners
    integer(c_int32_t) :: cube_balls
    integer(c_int32_t) :: cube_corners
    integer(c_int32_t) :: points
  end type

  type, bind(C) :: hsp_path
    real(c_double) :: length           ! length
    real(c_double) :: clearance        ! length
    integer(c_int32_t) :: ends         ! HSP_PATH_*
    integer(c_int32_t) :: certified    ! 0 or 1
    integer(c_int32_t) :: points
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_gate_limits
    integer(c_int32_t) :: struct_size  ! hsp_gate_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: cubes
    integer(c_int32_t) :: entries
    integer(c_int32_t) :: cells
    integer(c_int32_t) :: adjacencies
    integer(c_int32_t) :: landmarks
    integer(c_int32_t) :: facets
    integer(c_int32_t) :: corners
    integer(c_int32_t) :: cube_balls
    integer(c_int32_t) :: cube_corners
  end type

  type, bind(C) :: hsp_widest_probe
    real(c_double) :: radius           ! length
    integer(c_int32_t) :: passes       ! 0 or 1
    integer(c_int32_t) :: gate(3)      ! 0-based
    integer(c_int32_t) :: builds
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_sticks_limits
    integer(c_int32_t) :: struct_size  ! hsp_sticks_limits_init sets it
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: sticks
    integer(c_int32_t) :: pairs
    integer(c_int32_t) :: edges
  end type

  type, bind(C) :: hsp_stick
    integer(c_int32_t) :: ball(2)      ! 0-based
    integer(c_int32_t) :: flags        ! HSP_STICK_*
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_sticks_conflict
    integer(c_int32_t) :: kind         ! HSP_STICKS_*
    integer(c_int32_t) :: first        ! 0-based
    integer(c_int32_t) :: second       ! 0-based
    integer(c_int32_t) :: reserved
  end type

  type, bind(C) :: hsp_sticks_info
    real(c_double) :: origin(3)        ! length
    real(c_double) :: right(3)
    real(c_double) :: up(3)
    real(c_double) :: towards(3)
    real(c_double) :: low(2)           ! length
    real(c_double) :: high(2)          ! length
    integer(c_int32_t) :: paths
    integer(c_int32_t) :: balls
    integer(c_int32_t) :: sticks
    integer(c_int32_t) :: arcs
  end type

  type, bind(C) :: hsp_picture_options
    integer(c_int32_t) :: struct_size  ! hsp_picture_options_init sets it
    integer(c_int32_t) :: format       ! HSP_FORMAT_*
    integer(c_int32_t) :: style        ! HSP_STYLE_*
    integer(c_int32_t) :: unit         ! HSP_UNIT_*
    real(c_double) :: width            ! 0: follows from height
    real(c_double) :: height           ! 0: follows from width
    real(c_double) :: margin
    real(c_double) :: outline
    real(c_double) :: fog
    integer(c_int32_t) :: outline_colour  ! 0xRRGGBB
    integer(c_int32_t) :: background   ! 0xRRGGBB
    integer(c_int32_t) :: flags        ! HSP_PICTURE_*
    integer(c_int32_t) :: reserved
    real(c_double) :: scale            ! of a fixed frame: px or mm per unit of length; 0: fitted
    real(c_double) :: centre(3)        ! of a fixed frame
    integer(c_int64_t) :: memory       ! for the compression of PDF: transfer(c_loc(memory), 0_c_int64_t), or 0
    integer(c_int64_t) :: memory_bytes ! HSP_PICTURE_MEMORY or more, or 0
    integer(c_int64_t) :: ink          ! a map for contours: transfer(map, 0_c_int64_t), or 0
    integer(c_int64_t) :: group        ! transfer(c_loc(group), 0_c_int64_t) of a number for each ball, or 0
    real(c_double) :: ink_width(3)     ! 1 + HSP_INK_*; negative: chosen
    integer(c_int32_t) :: ink_colour(3)  ! 0xRRGGBB
    integer(c_int32_t) :: reserved_for_ink
    integer(c_int64_t) :: atom_class   ! transfer(c_loc(names), 0_c_int64_t) of a type(c_ptr) for each ball, or 0
    integer(c_int64_t) :: atom_title   ! likewise
  end type

  ! What takes the bytes of a picture: 0 to go on, anything else to stop.
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
    function hsp_version() result(version) bind(C, name="hsp_version")
      import :: c_int32_t
      integer(c_int32_t) :: version
    end function

    function hsp_abi() result(version) bind(C, name="hsp_abi")
      import :: c_int32_t
      integer(c_int32_t) :: version
    end function

    function hsp_numerics() result(version) bind(C, name="hsp_numerics")
      import :: c_int32_t
      integer(c_int32_t) :: version
    end function

    ! A pointer to C characters; hsp_status_message below returns the same as a Fortran string.
    function hsp_status_text(status) result(text) bind(C, name="hsp_status_text")
      import :: c_int32_t, c_ptr
      integer(c_int32_t), value :: status
      type(c_ptr) :: text
    end function

    ! ---- radii by element ------------------------------------------------------------------------------------------

    function hsp_element_radius(set, atomic_number, radius, flags) result(status) bind(C, name="hsp_element_radius")
      import :: c_double, c_int32_t
      integer(c_int32_t), value :: set                          ! HSP_RADII_*
      integer(c_int32_t), value :: atomic_number
      real(c_double), intent(inout) :: radius                   ! angstrom
      integer(c_int32_t), intent(inout), optional :: flags      ! HSP_RADIUS_*
      integer(c_int32_t) :: status
    end function

    ! ---- model -----------------------------------------------------------------------------------------------------

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
      real(c_double), intent(in), optional :: xyz(3, *)         ! 3, n
      real(c_double), intent(in), optional :: radius(*)         ! n
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

    ! ---- queries ---------------------------------------------------------------------------------------------------

    function hsp_query_point(model, xyz, ids, capacity, needed) result(status) bind(C, name="hsp_query_point")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: model
      real(c_double), intent(in) :: xyz(3)
      integer(c_int32_t), intent(inout), optional :: ids(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_query_ball(model, xyz, radius, ids, capacity, needed) result(status) bind(C, name="hsp_query_ball")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: model
      real(c_double), intent(in) :: xyz(3)
      real(c_double), value :: radius
      integer(c_int32_t), intent(inout), optional :: ids(*)
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
      integer(c_int32_t), intent(inout), optional :: ids(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! first has n + 1 entries. Row i, from 0 on, is ids(first(i + 1) + 1 : first(i + 2)).
    function hsp_query_pairs(model, flags, first, ids, capacity, needed) result(status) bind(C, name="hsp_query_pairs")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: model
      integer(c_int32_t), value :: flags
      integer(c_int32_t), intent(inout) :: first(*)
      integer(c_int32_t), intent(inout), optional :: ids(*)
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

    ! ---- bodies and poses ------------------------------------------------------------------------------------------

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
      type(hsp_pose), intent(in) :: pose(*)
      integer(c_int32_t), intent(inout) :: hit(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_hits_along(fixed, moving, poses, pose, margin, hit, first_bad) result(status) &
      bind(C, name="hsp_body_hits_along")
      import :: c_double, c_int32_t, c_ptr, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in) :: pose(*)
      real(c_double), value :: margin
      integer(c_int32_t), intent(inout) :: hit(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_gaps(fixed, moving, poses, pose, gap, first_bad) result(status) bind(C, name="hsp_body_gaps")
      import :: c_int32_t, c_ptr, hsp_body_gap, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in) :: pose(*)
      type(hsp_body_gap), intent(inout) :: gap(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_overlaps(fixed, moving, poses, pose, overlap, first_bad) result(status) &
      bind(C, name="hsp_body_overlaps")
      import :: c_int32_t, c_ptr, hsp_body_overlap, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_pose), intent(in) :: pose(*)
      type(hsp_body_overlap), intent(inout) :: overlap(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_pairs(fixed, moving, pose, pair, capacity, needed) result(status) bind(C, name="hsp_body_pairs")
      import :: c_int32_t, c_ptr, hsp_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      type(hsp_pose), intent(in) :: pose
      integer(c_int32_t), intent(inout), optional :: pair(2, *) ! 2, needed
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
      type(hsp_rational_pose), intent(in) :: pose(*)
      integer(c_int32_t), intent(inout) :: hit(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_hits_along(fixed, moving, poses, pose, margin, hit, first_bad) result(status) &
      bind(C, name="hsp_body_rational_hits_along")
      import :: c_double, c_int32_t, c_ptr, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_rational_pose), intent(in) :: pose(*)
      real(c_double), value :: margin
      integer(c_int32_t), intent(inout) :: hit(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_gaps(fixed, moving, poses, pose, gap, first_bad) result(status) &
      bind(C, name="hsp_body_rational_gaps")
      import :: c_int32_t, c_ptr, hsp_body_gap, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: poses
      type(hsp_rational_pose), intent(in) :: pose(*)
      type(hsp_body_gap), intent(inout) :: gap(*)
      integer(c_int32_t), intent(inout), optional :: first_bad ! counts from 0
      integer(c_int32_t) :: status
    end function

    function hsp_body_rational_pairs(fixed, moving, pose, pair, capacity, needed) result(status) &
      bind(C, name="hsp_body_rational_pairs")
      import :: c_int32_t, c_ptr, hsp_rational_pose
      type(c_ptr), value :: fixed
      type(c_ptr), value :: moving
      type(hsp_rational_pose), intent(in) :: pose
      integer(c_int32_t), intent(inout), optional :: pair(2, *) ! 2, needed
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- boundary --------------------------------------------------------------------------------------------------

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
      type(hsp_vertex), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_arcs(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_arcs")
      import :: c_int32_t, c_ptr, hsp_arc
      type(c_ptr), value :: boundary
      type(hsp_arc), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_circles(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_circles")
      import :: c_int32_t, c_ptr, hsp_circle
      type(c_ptr), value :: boundary
      type(hsp_circle), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_faces(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_faces")
      import :: c_int32_t, c_ptr, hsp_face
      type(c_ptr), value :: boundary
      type(hsp_face), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_loops(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_loops")
      import :: c_int32_t, c_ptr, hsp_loop
      type(c_ptr), value :: boundary
      type(hsp_loop), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_loop_arcs(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_loop_arcs")
      import :: c_int32_t, c_ptr, hsp_loop_arc
      type(c_ptr), value :: boundary
      type(hsp_loop_arc), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_get_balls(boundary, out, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_get_balls")
      import :: c_int32_t, c_ptr, hsp_ball
      type(c_ptr), value :: boundary
      type(hsp_ball), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- areas and volume ------------------------------------------------------------------------------------------

    function hsp_boundary_measure(boundary, selected, totals, area, volume, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_measure")
      import :: c_double, c_int32_t, c_int8_t, c_ptr, hsp_totals
      type(c_ptr), value :: boundary
      integer(c_int8_t), intent(in), optional :: selected(*)    ! n; 0 or not 0
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: area(*)        ! n
      real(c_double), intent(inout), optional :: volume(*)      ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_range(boundary, selected, first, count, area, volume) result(status) &
      bind(C, name="hsp_boundary_measure_range")
      import :: c_double, c_int8_t, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      integer(c_int8_t), intent(in), optional :: selected(*)
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      real(c_double), intent(inout) :: area(*)
      real(c_double), intent(inout) :: volume(*)
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_end(boundary, totals, area, volume) result(status) &
      bind(C, name="hsp_boundary_measure_end")
      import :: c_double, c_int32_t, c_ptr, hsp_totals
      type(c_ptr), value :: boundary
      type(hsp_totals), intent(inout), optional :: totals
      real(c_double), intent(inout) :: area(*)
      real(c_double), intent(inout) :: volume(*)
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_measure_faces(boundary, area, volume, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_measure_faces")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(inout), optional :: area(*)        ! faces
      real(c_double), intent(inout), optional :: volume(*)      ! faces
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- gradients -------------------------------------------------------------------------------------------------

    function hsp_boundary_gradient(boundary, sigma, tension, pressure, tangency, energy, d_centre, d_radius, flags, &
                                   capacity, needed, first_bad) result(status) bind(C, name="hsp_boundary_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)          ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency                     ! HSP_TANGENT_*
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_GRADIENT_*
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_gradient_range(boundary, sigma, tension, pressure, tangency, first, count, d_centre, d_radius, &
                                         flags, shares, first_bad) result(status) &
      bind(C, name="hsp_boundary_gradient_range")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)          ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency                     ! HSP_TANGENT_*
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_GRADIENT_*
      real(c_double), intent(inout), optional :: shares(3, *)   ! 3, n
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
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_GRADIENT_*
      real(c_double), intent(in), optional :: shares(3, *)      ! 3, n
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_derivatives(boundary, sigma, tangency, area_centre, area_radius, volume_centre, &
                                      volume_radius, flags, capacity, needed, first_bad) result(status) &
      bind(C, name="hsp_boundary_derivatives")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)               ! n
      integer(c_int32_t), value :: tangency                          ! HSP_TANGENT_*
      real(c_double), intent(inout), optional :: area_centre(3, *)   ! 3, n
      real(c_double), intent(inout), optional :: area_radius(*)      ! n
      real(c_double), intent(inout), optional :: volume_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: volume_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)        ! n; HSP_GRADIENT_*
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
      integer(c_int32_t), value :: tangency                     ! HSP_TANGENT_*
      type(hsp_area_derivative), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- self-check ------------------------------------------------------------------------------------------------

    function hsp_boundary_check(boundary, invariant, id) result(status) bind(C, name="hsp_boundary_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: boundary
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- curvature -------------------------------------------------------------------------------------------------

    function hsp_boundary_curvature(boundary, totals, mean, gauss_thirds, capacity, needed) result(status) &
      bind(C, name="hsp_boundary_curvature")
      import :: c_double, c_int32_t, c_ptr, hsp_curvatures
      type(c_ptr), value :: boundary
      type(hsp_curvatures), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: mean(*)             ! n
      integer(c_int32_t), intent(inout), optional :: gauss_thirds(*) ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_boundary_morphometry(boundary, sigma, factors, energy, d_centre, d_radius, flags, capacity, needed, &
                                      first_bad) result(status) bind(C, name="hsp_boundary_morphometry")
      import :: c_double, c_int32_t, c_ptr, hsp_morphometric_energy, hsp_morphometry
      type(c_ptr), value :: boundary
      real(c_double), intent(in), optional :: sigma(*)          ! n
      type(hsp_morphometry), intent(in) :: factors
      type(hsp_morphometric_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_CURVATURE_*
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    ! ---- contacts --------------------------------------------------------------------------------------------------

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
      type(hsp_contact), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_get_row(contacts, ball, out, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_get_row")
      import :: c_int32_t, c_ptr, hsp_contact
      type(c_ptr), value :: contacts
      integer(c_int32_t), value :: ball
      type(hsp_contact), intent(inout), optional :: out(*)
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
      real(c_double), intent(inout), optional :: contact_area(*) ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_contacts_group(contacts, group, out, capacity, needed) result(status) &
      bind(C, name="hsp_contacts_group")
      import :: c_int32_t, c_ptr, hsp_group_contact
      type(c_ptr), value :: contacts
      integer(c_int32_t), intent(in) :: group(*)                 ! n
      type(hsp_group_contact), intent(inout), optional :: out(*)
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
      type(hsp_simplex), intent(inout), optional :: out(*)
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

    ! ---- periodic boxes --------------------------------------------------------------------------------------------

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
      real(c_double), intent(in), optional :: xyz(3, *)         ! 3, n
      real(c_double), intent(in), optional :: radius(*)         ! n
      type(hsp_model_options), intent(in), optional :: options
      real(c_double), intent(in) :: box(9)                      ! the three vectors
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
      real(c_double), intent(inout), optional :: area(*)        ! n
      real(c_double), intent(inout), optional :: cell_volume(*) ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_curvature(periodic, totals, mean, gauss_thirds, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_curvature")
      import :: c_double, c_int32_t, c_ptr, hsp_curvatures
      type(c_ptr), value :: periodic
      type(hsp_curvatures), intent(inout), optional :: totals
      real(c_double), intent(inout), optional :: mean(*)             ! n
      integer(c_int32_t), intent(inout), optional :: gauss_thirds(*) ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_morphometry(periodic, sigma, factors, energy, d_centre, d_radius, flags, d_strain, d_box, &
                                      capacity, needed, first_bad) result(status) &
      bind(C, name="hsp_periodic_morphometry")
      import :: c_double, c_int32_t, c_ptr, hsp_morphometric_energy, hsp_morphometry
      type(c_ptr), value :: periodic
      real(c_double), intent(in), optional :: sigma(*)          ! n
      type(hsp_morphometry), intent(in) :: factors
      type(hsp_morphometric_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_CURVATURE_*
      real(c_double), intent(inout), optional :: d_strain(9)    ! by eps_xx, eps_xy, ...
      real(c_double), intent(inout), optional :: d_box(9)       ! by the components of box
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_contacts(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_contacts")
      import :: c_int32_t, c_ptr, hsp_periodic_contact
      type(c_ptr), value :: periodic
      type(hsp_periodic_contact), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_group_contacts(periodic, group, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_group_contacts")
      import :: c_int32_t, c_ptr, hsp_group_contact
      type(c_ptr), value :: periodic
      integer(c_int32_t), intent(in) :: group(*) ! n
      type(hsp_group_contact), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_windings(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_windings")
      import :: c_int32_t, c_ptr, hsp_winding
      type(c_ptr), value :: periodic
      type(hsp_winding), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_components(periodic, component, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_components")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: periodic
      integer(c_int32_t), intent(inout), optional :: component(*) ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_gradient(periodic, sigma, tension, pressure, tangency, energy, d_centre, d_radius, flags, &
                                   d_strain, d_box, capacity, needed, first_bad) result(status) &
      bind(C, name="hsp_periodic_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: periodic
      real(c_double), intent(in), optional :: sigma(*)          ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency                     ! HSP_TANGENT_*
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_GRADIENT_*
      real(c_double), intent(inout), optional :: d_strain(9)    ! by eps_xx, eps_xy, ...
      real(c_double), intent(inout), optional :: d_box(9)       ! by the components of box
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
      type(hsp_image), intent(inout), optional :: out(*)
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
      type(hsp_image), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_query_neighbours(periodic, ball, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_neighbours")
      import :: c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      integer(c_int32_t), value :: ball
      type(hsp_image), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! first has n + 1 entries. Row i, from 0 on, is out(first(i + 1) + 1 : first(i + 2)).
    function hsp_periodic_query_pairs(periodic, flags, first, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_query_pairs")
      import :: c_int32_t, c_ptr, hsp_image
      type(c_ptr), value :: periodic
      integer(c_int32_t), value :: flags
      integer(c_int32_t), intent(inout) :: first(*)
      type(hsp_image), intent(inout), optional :: out(*)
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

    function hsp_periodic_get_vertices(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_vertices")
      import :: c_int32_t, c_ptr, hsp_periodic_vertex
      type(c_ptr), value :: periodic
      type(hsp_periodic_vertex), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_arcs(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_arcs")
      import :: c_int32_t, c_ptr, hsp_periodic_arc
      type(c_ptr), value :: periodic
      type(hsp_periodic_arc), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_circles(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_circles")
      import :: c_int32_t, c_ptr, hsp_periodic_circle
      type(c_ptr), value :: periodic
      type(hsp_periodic_circle), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_faces(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_faces")
      import :: c_int32_t, c_ptr, hsp_periodic_face
      type(c_ptr), value :: periodic
      type(hsp_periodic_face), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_loops(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_loops")
      import :: c_int32_t, c_ptr, hsp_periodic_loop
      type(c_ptr), value :: periodic
      type(hsp_periodic_loop), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_loop_arcs(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_loop_arcs")
      import :: c_int32_t, c_ptr, hsp_periodic_loop_arc
      type(c_ptr), value :: periodic
      type(hsp_periodic_loop_arc), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_periodic_get_balls(periodic, out, capacity, needed) result(status) &
      bind(C, name="hsp_periodic_get_balls")
      import :: c_int32_t, c_ptr, hsp_ball
      type(c_ptr), value :: periodic
      type(hsp_ball), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- balls that move -------------------------------------------------------------------------------------------

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
      real(c_double), intent(in), optional :: sigma(*)           ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      integer(c_int32_t), value :: tangency                      ! HSP_TANGENT_*
      type(hsp_moving_limits), intent(inout), optional :: limits
      integer(c_int32_t), intent(inout), optional :: first_bad
      integer(c_int32_t) :: status
    end function

    function hsp_moving_move(moving, count, ball, xyz, radius, limits, first_bad) result(status) &
      bind(C, name="hsp_moving_move")
      import :: c_double, c_int32_t, c_ptr, hsp_moving_limits
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(in), optional :: ball(*)        ! count
      real(c_double), intent(in), optional :: xyz(3, *)          ! 3, count
      real(c_double), intent(in), optional :: radius(*)          ! count
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
      real(c_double), intent(inout), optional :: area(*)         ! n
      real(c_double), intent(inout), optional :: volume(*)       ! n
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
      real(c_double), intent(inout), optional :: d_radius(*)     ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)    ! n; HSP_GRADIENT_*
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_balls(moving, count, ball, out) result(status) bind(C, name="hsp_moving_get_balls")
      import :: c_int32_t, c_ptr, hsp_moving_ball
      type(c_ptr), value :: moving
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(in), optional :: ball(*)        ! count
      type(hsp_moving_ball), intent(inout), optional :: out(*)   ! count
      integer(c_int32_t) :: status
    end function

    function hsp_moving_get_changed(moving, out, capacity, needed) result(status) &
      bind(C, name="hsp_moving_get_changed")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: moving
      integer(c_int32_t), intent(inout), optional :: out(*)
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

    ! ---- the solvent-excluded surface ------------------------------------------------------------------------------

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
      integer(c_int32_t), intent(in), optional :: shells(*)     ! count
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
      type(hsp_surface_totals), intent(inout), optional :: balls(*)  ! n
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
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_SURFACE_DEGENERATE
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_surface_weighted_gradient(surface, sigma, tension, pressure, energy, d_centre, d_radius, flags, &
                                           capacity, needed, first_bad) result(status) &
      bind(C, name="hsp_surface_weighted_gradient")
      import :: c_double, c_int32_t, c_ptr, hsp_energy
      type(c_ptr), value :: surface
      real(c_double), intent(in), optional :: sigma(*)          ! n
      real(c_double), value :: tension
      real(c_double), value :: pressure
      type(hsp_energy), intent(inout), optional :: energy
      real(c_double), intent(inout), optional :: d_centre(3, *) ! 3, n
      real(c_double), intent(inout), optional :: d_radius(*)    ! n
      integer(c_int32_t), intent(inout), optional :: flags(*)   ! n; HSP_SURFACE_DEGENERATE
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
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_surface_previous(surface, h) result(found) bind(C, name="hsp_surface_previous")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_surface_next_loop(surface, h) result(found) bind(C, name="hsp_surface_next_loop")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_surface_origin(surface, h) result(found) bind(C, name="hsp_surface_origin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_surface_left(surface, h) result(found) bind(C, name="hsp_surface_left")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_surface_get_patches(surface, first, count, out) result(status) &
      bind(C, name="hsp_surface_get_patches")
      import :: c_int32_t, c_ptr, hsp_surface_patch
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_surface_patch), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_edges(surface, first, count, out) result(status) &
      bind(C, name="hsp_surface_get_edges")
      import :: c_int32_t, c_ptr, hsp_surface_edge
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_surface_edge), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_corners(surface, first, count, out) result(status) &
      bind(C, name="hsp_surface_get_corners")
      import :: c_int32_t, c_ptr, hsp_surface_corner
      type(c_ptr), value :: surface
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_surface_corner), intent(inout), optional :: out(*)  ! count
      integer(c_int32_t) :: status
    end function

    function hsp_surface_get_shells(surface, out, capacity, needed) result(status) &
      bind(C, name="hsp_surface_get_shells")
      import :: c_int32_t, c_ptr, hsp_surface_shell
      type(c_ptr), value :: surface
      type(hsp_surface_shell), intent(inout), optional :: out(*)
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

    ! ---- triangles -------------------------------------------------------------------------------------------------

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
      real(c_double), intent(inout), optional :: xyz(3, *)      ! 3, vertices
      real(c_double), intent(inout), optional :: normals(3, *)  ! 3, vertices
      real(c_double), intent(inout), optional :: areas(*)       ! vertices
      integer(c_int32_t), intent(inout), optional :: balls(*)   ! vertices; 0-based
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, capacity, needed) result(status) &
      bind(C, name="hsp_mesh_get_triangles")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: mesh
      integer(c_int32_t), intent(inout), optional :: corners(3, *)  ! 3, triangles; 0-based
      integer(c_int32_t), intent(inout), optional :: kinds(*)       ! triangles; HSP_PATCH_*
      integer(c_int32_t), intent(inout), optional :: patches(*)     ! triangles; 0-based
      integer(c_int32_t), intent(inout), optional :: balls(*)       ! triangles; 0-based
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout), optional :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_mesh_get_patch(mesh, patch, first, count) result(status) bind(C, name="hsp_mesh_get_patch")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: mesh
      integer(c_int32_t), value :: patch  ! 0-based
      integer(c_int32_t), intent(inout) :: first  ! 0-based
      integer(c_int32_t), intent(inout) :: count
      integer(c_int32_t) :: status
    end function

    ! ---- topology --------------------------------------------------------------------------------------------------

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

    ! Steps from a quarter-edge: to another one, to its origin, to what lies left of it. HSP_NONE if there is none.

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
      integer(c_int32_t), value :: first  ! an edge, 0-based
      integer(c_int32_t), value :: count
      integer(c_int32_t), intent(inout), optional :: onext(0:3, 0:*)  ! 4, count
      integer(c_int32_t), intent(inout), optional :: origin(0:3, 0:*)  ! 4, count
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_vertices(topology, first, count, out) result(status) &
      bind(C, name="hsp_topology_get_vertices")
      import :: c_int32_t, c_ptr, hsp_topology_vertex
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_topology_vertex), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_edges(topology, first, count, out) result(status) &
      bind(C, name="hsp_topology_get_edges")
      import :: c_int32_t, c_ptr, hsp_topology_edge
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_topology_edge), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_simple_faces(topology, first, count, out) result(status) &
      bind(C, name="hsp_topology_get_simple_faces")
      import :: c_int32_t, c_ptr, hsp_simple_face
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: first  ! an id, 0-based
      integer(c_int32_t), value :: count
      type(hsp_simple_face), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_shells(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_shells")
      import :: c_int32_t, c_ptr, hsp_shell
      type(c_ptr), value :: topology
      type(hsp_shell), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_components(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_components")
      import :: c_int32_t, c_ptr, hsp_component
      type(c_ptr), value :: topology
      type(hsp_component), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_cells(topology, out, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_cells")
      import :: c_int32_t, c_ptr, hsp_cell
      type(c_ptr), value :: topology
      type(hsp_cell), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_cell_shells(topology, cell, shells, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_cell_shells")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: cell
      integer(c_int32_t), intent(inout), optional :: shells(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_topology_get_traversal(topology, shell, faces, capacity, needed) result(status) &
      bind(C, name="hsp_topology_get_traversal")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: topology
      integer(c_int32_t), value :: shell
      integer(c_int32_t), intent(inout), optional :: faces(*)
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

    ! ---- view ------------------------------------------------------------------------------------------------------

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
      real(c_double), value :: x                                ! degrees
      real(c_double), value :: y                                ! degrees
      real(c_double), value :: z                                ! degrees
      integer(c_int32_t) :: status
    end function

    ! Without a boundary pass c_null_ptr.
    function hsp_view_compute(view, model, boundary, options, limits) result(status) bind(C, name="hsp_view_compute")
      import :: c_int32_t, c_ptr, hsp_view_options, hsp_view_limits
      type(c_ptr), value :: view
      type(c_ptr), value :: model
      type(c_ptr), value :: boundary
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
      type(hsp_view_piece), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_loops(view, out, capacity, needed) result(status) bind(C, name="hsp_view_get_loops")
      import :: c_int32_t, c_ptr, hsp_view_loop
      type(c_ptr), value :: view
      type(hsp_view_loop), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_view_get_arcs(view, out, capacity, needed) result(status) bind(C, name="hsp_view_get_arcs")
      import :: c_int32_t, c_ptr, hsp_view_arc
      type(c_ptr), value :: view
      type(hsp_view_arc), intent(inout), optional :: out(*)
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    ! ---- free space as cells ---------------------------------------------------------------------------------------

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
      integer(c_int32_t), intent(inout), optional :: neighbours(*)
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
      type(c_ptr), value :: topology
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
      integer(c_int32_t), intent(inout), optional :: scratch(*)  ! words
      integer(c_int32_t), value :: words
      integer(c_int32_t), intent(inout) :: words_needed
      integer(c_int32_t) :: status
    end function

    ! ---- paths through free space ----------------------------------------------------------------------------------

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
      real(c_double), intent(inout), optional :: points(3, *)
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

    ! ---- balls and sticks ------------------------------------------------------------------------------------------

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
      type(hsp_stick), intent(in), optional :: stick(*)
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
      type(hsp_stick), intent(in), optional :: stick(*)
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
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_vertex), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_edges(sticks, first, count, out) result(status) bind(C, name="hsp_sticks_get_edges")
      import :: c_int32_t, c_ptr, hsp_map_edge
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_edge), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_faces(sticks, first, count, out) result(status) bind(C, name="hsp_sticks_get_faces")
      import :: c_int32_t, c_ptr, hsp_map_face
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_face), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_areas(sticks, area, capacity, needed) result(status) bind(C, name="hsp_sticks_get_areas")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: sticks
      real(c_double), intent(inout), optional :: area(*)  ! balls, then two for each stick
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

    function hsp_sticks_get_outline(sticks, ball, h, capacity, needed) result(status) bind(C, name="hsp_sticks_get_outline")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: ball  ! 0-based
      integer(c_int32_t), intent(inout), optional :: h(*)  ! 0-based
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_point(sticks, edge, t, point) result(status) bind(C, name="hsp_sticks_get_point")
      import :: c_double, c_int32_t, c_ptr, hsp_map_point
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: edge  ! 0-based
      real(c_double), value :: t
      type(hsp_map_point), intent(inout) :: point
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_get_pole(sticks, face, pole) result(status) bind(C, name="hsp_sticks_get_pole")
      import :: c_int32_t, c_ptr, hsp_map_pole
      type(c_ptr), value :: sticks
      integer(c_int32_t), value :: face  ! 0-based
      type(hsp_map_pole), intent(inout) :: pole
      integer(c_int32_t) :: status
    end function

    function hsp_sticks_check(sticks, invariant, id) result(status) bind(C, name="hsp_sticks_check")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: sticks
      integer(c_int32_t), intent(inout) :: invariant
      integer(c_int32_t), intent(inout) :: id
      integer(c_int32_t) :: status
    end function

    ! ---- the visibility map ----------------------------------------------------------------------------------------

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
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_map_previous(map, h) result(found) bind(C, name="hsp_map_previous")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_map_next_loop(map, h) result(found) bind(C, name="hsp_map_next_loop")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_map_origin(map, h) result(found) bind(C, name="hsp_map_origin")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_map_left(map, h) result(found) bind(C, name="hsp_map_left")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: h  ! a directed edge, 0-based
      integer(c_int32_t) :: found
    end function

    function hsp_map_get_vertices(map, first, count, out) result(status) bind(C, name="hsp_map_get_vertices")
      import :: c_int32_t, c_ptr, hsp_map_vertex
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_vertex), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_edges(map, first, count, out) result(status) bind(C, name="hsp_map_get_edges")
      import :: c_int32_t, c_ptr, hsp_map_edge
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_edge), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_faces(map, first, count, out) result(status) bind(C, name="hsp_map_get_faces")
      import :: c_int32_t, c_ptr, hsp_map_face
      type(c_ptr), value :: map
      integer(c_int32_t), value :: first  ! 0-based
      integer(c_int32_t), value :: count
      type(hsp_map_face), intent(inout), optional :: out(*)
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_areas(map, area, capacity, needed) result(status) bind(C, name="hsp_map_get_areas")
      import :: c_double, c_int32_t, c_ptr
      type(c_ptr), value :: map
      real(c_double), intent(inout), optional :: area(*)  ! n
      integer(c_int32_t), value :: capacity
      integer(c_int32_t), intent(inout) :: needed
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_outline(map, ball, h, capacity, needed) result(status) bind(C, name="hsp_map_get_outline")
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: map
      integer(c_int32_t), value :: ball  ! 0-based
      integer(c_int32_t), intent(inout), optional :: h(*)  ! 0-based
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
      integer(c_int32_t), value :: edge  ! 0-based
      real(c_double), value :: t
      type(hsp_map_point), intent(inout) :: point
      integer(c_int32_t) :: status
    end function

    function hsp_map_get_pole(map, face, pole) result(status) bind(C, name="hsp_map_get_pole")
      import :: c_int32_t, c_ptr, hsp_map_pole
      type(c_ptr), value :: map
      integer(c_int32_t), value :: face  ! 0-based
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

    ! ---- pictures --------------------------------------------------------------------------------------------------

    function hsp_picture_options_init(options, struct_size) result(status) bind(C, name="hsp_picture_options_init")
      import :: c_int32_t, hsp_picture_options
      type(hsp_picture_options), intent(inout) :: options
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t) :: status
    end function

    pure function hsp_palette_colour(palette, atomic_number, chain) result(colour) bind(C, name="hsp_palette_colour")
      import :: c_int32_t
      integer(c_int32_t), value :: palette                      ! HSP_PALETTE_*
      integer(c_int32_t), value :: atomic_number
      integer(c_int32_t), value :: chain
      integer(c_int32_t) :: colour
    end function

    function hsp_picture_write(view, colour, options, title, description, sink, context, bytes) result(status) &
      bind(C, name="hsp_picture_write")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: view
      integer(c_int32_t), intent(in), optional :: colour(*)     ! n; 0xRRGGBB
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink                             ! of a function with the interface hsp_sink
      type(c_ptr), value :: context
      integer(c_int64_t), intent(inout), optional :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_picture_write_map(map, colour, options, title, description, sink, context, bytes) result(status) &
      bind(C, name="hsp_picture_write_map")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: map
      integer(c_int32_t), intent(in), optional :: colour(*)     ! n; 0xRRGGBB
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink                             ! of a function with the interface hsp_sink
      type(c_ptr), value :: context
      integer(c_int64_t), intent(inout), optional :: bytes
      integer(c_int32_t) :: status
    end function

    function hsp_picture_write_sticks(sticks, colour, options, title, description, sink, context, bytes) &
      result(status) bind(C, name="hsp_picture_write_sticks")
      import :: c_char, c_funptr, c_int32_t, c_int64_t, c_ptr, hsp_picture_options
      type(c_ptr), value :: sticks
      integer(c_int32_t), intent(in), optional :: colour(*)     ! n; 0xRRGGBB
      type(hsp_picture_options), intent(in), optional :: options
      character(kind=c_char), intent(in), optional :: title(*)  ! ends with c_null_char
      character(kind=c_char), intent(in), optional :: description(*)  ! ends with c_null_char
      type(c_funptr), value :: sink                             ! of a function with the interface hsp_sink
      type(c_ptr), value :: context
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

  !> HSP_SURFACE_TWIN of the header: the directed edge h the other way.
  elemental function hsp_surface_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = HSP_NONE
    if (h /= HSP_NONE) turned = ieor(h, 1_c_int32_t)
  end function

  !> HSP_MAP_TWIN of the header: the directed edge h the other way.
  elemental function hsp_map_twin(h) result(turned)
    integer(c_int32_t), intent(in) :: h
    integer(c_int32_t) :: turned
    turned = hsp_surface_twin(h)
  end function

  !> HSP_STICKS_HALF of the header: the number of a half of a stick in a map of so many balls; all 0-based.
  elemental function hsp_sticks_half(balls, stick, half) result(number)
    integer(c_int32_t), intent(in) :: balls, stick, half
    integer(c_int32_t) :: number
    number = balls + 2_c_int32_t*stick + half
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

  !> HSP_MODEL_BYTES of the header, for the size of an allocation.
  pure function hsp_model_bytes_bound(balls) result(bytes)
    integer(c_int32_t), intent(in) :: balls
    integer(c_size_t) :: bytes
    bytes = 1536_c_size_t + 128_c_size_t*int(balls, c_size_t)
  end function

  !> HSP_BODY_BYTES of the header, for the size of an allocation.
  pure function hsp_body_bytes_bound(balls) result(bytes)
    integer(c_int32_t), intent(in) :: balls
    integer(c_size_t) :: bytes
    bytes = 2048_c_size_t + 112_c_size_t*int(balls, c_size_t)
  end function

  !> HSP_BOUNDARY_BYTES of the header, for the size of an allocation.
  pure function hsp_boundary_bytes_bound(balls, neighbours, vertices, circles) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, vertices, circles
    integer(c_size_t) :: bytes
    bytes = 5120_c_size_t + 64_c_size_t*int(balls, c_size_t) + 256_c_size_t*int(neighbours, c_size_t) &
            + 160_c_size_t*int(vertices, c_size_t) + 80_c_size_t*int(circles, c_size_t)
  end function

  !> HSP_WORKER_BYTES of the header, for each worker of a boundary but the first.
  pure function hsp_worker_bytes_bound(balls, neighbours, vertices, circles) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, vertices, circles
    integer(c_size_t) :: bytes
    bytes = 13312_c_size_t + 16_c_size_t*int(balls, c_size_t) + 416_c_size_t*int(neighbours, c_size_t) &
            + 16_c_size_t*int(vertices, c_size_t) + 16_c_size_t*int(circles, c_size_t)
  end function

  !> HSP_SURFACE_BYTES of the header, for the size of an allocation.
  pure function hsp_surface_bytes_bound(vertices, faces, neighbours, pieces, arcs, cusped_circles) result(bytes)
    integer(c_int32_t), intent(in) :: vertices, faces, neighbours, pieces, arcs, cusped_circles
    integer(c_size_t) :: bytes
    bytes = 8192_c_size_t + 54_c_size_t*int(vertices, c_size_t) + 9_c_size_t*int(faces, c_size_t) &
            + 1152_c_size_t*int(neighbours, c_size_t) + 106_c_size_t*int(pieces, c_size_t) &
            + 26_c_size_t*int(arcs, c_size_t) + 16_c_size_t*int(cusped_circles, c_size_t)
  end function

  !> HSP_CONTACTS_BYTES of the header, for the size of an allocation.
  pure function hsp_contacts_bytes_bound(balls, neighbours, contacts, triangles, tetrahedra) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, contacts, triangles, tetrahedra
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 28_c_size_t*int(balls, c_size_t) + 208_c_size_t*int(neighbours, c_size_t) &
            + 60_c_size_t*int(contacts, c_size_t) + 16_c_size_t*int(triangles, c_size_t) &
            + 16_c_size_t*int(tetrahedra, c_size_t)
  end function

  !> HSP_PERIODIC_BYTES of the header, for the size of an allocation.
  pure function hsp_periodic_bytes_bound(balls, images, neighbours, vertices, circles, contacts) result(bytes)
    integer(c_int32_t), intent(in) :: balls, images, neighbours, vertices, circles, contacts
    integer(c_size_t) :: bytes
    bytes = 16384_c_size_t + 384_c_size_t*int(balls, c_size_t) + 256_c_size_t*int(images, c_size_t) &
            + 448_c_size_t*int(neighbours, c_size_t) + 160_c_size_t*int(vertices, c_size_t) &
            + 80_c_size_t*int(circles, c_size_t) + 60_c_size_t*int(contacts, c_size_t)
  end function

  !> HSP_MOVING_BYTES of the header, for the size of an allocation.
  pure function hsp_moving_bytes_bound(balls, neighbours) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours
    integer(c_size_t) :: bytes
    bytes = 196608_c_size_t + 640_c_size_t*int(balls, c_size_t) + 1280_c_size_t*int(neighbours, c_size_t)
  end function

  !> HSP_MESH_BYTES of the header, for the size of an allocation.
  pure function hsp_mesh_bytes_bound(balls, curves, vertices, triangles, points) result(bytes)
    integer(c_int32_t), intent(in) :: balls, curves, vertices, triangles, points
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 16_c_size_t*int(balls, c_size_t) + 32_c_size_t*int(curves, c_size_t) &
            + 64_c_size_t*int(vertices, c_size_t) + 32_c_size_t*int(triangles, c_size_t) &
            + 384_c_size_t*int(points, c_size_t)
  end function

  !> HSP_TOPOLOGY_BYTES of the header, for the size of an allocation.
  pure function hsp_topology_bytes_bound(balls, neighbours, edges, cut_arcs) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, edges, cut_arcs
    integer(c_size_t) :: bytes
    bytes = 4096_c_size_t + 64_c_size_t*int(balls, c_size_t) + 192_c_size_t*int(neighbours, c_size_t) &
            + 112_c_size_t*int(edges, c_size_t) + 96_c_size_t*int(cut_arcs, c_size_t)
  end function

  !> HSP_VIEW_BYTES of the header, for the size of an allocation.
  pure function hsp_view_bytes_bound(balls, neighbours, arcs) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, arcs
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 192_c_size_t*int(balls, c_size_t) + 384_c_size_t*int(neighbours, c_size_t) &
            + 64_c_size_t*int(arcs, c_size_t)
  end function

  !> HSP_MAP_BYTES of the header, for the size of an allocation.
  pure function hsp_map_bytes_bound(balls, neighbours, edges) result(bytes)
    integer(c_int32_t), intent(in) :: balls, neighbours, edges
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 288_c_size_t*int(balls, c_size_t) + 208_c_size_t*int(neighbours, c_size_t) &
            + 352_c_size_t*int(edges, c_size_t)
  end function

  !> HSP_CELLS_BYTES of the header, for the size of an allocation.
  pure function hsp_cells_bytes_bound(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
                                      cube_corners) result(bytes)
    integer(c_int32_t), intent(in) :: cubes, entries, cells, adjacencies, landmarks, facets, corners
    integer(c_int32_t), intent(in) :: cube_balls, cube_corners
    integer(c_size_t) :: bytes
    bytes = 24576_c_size_t + 128_c_size_t*int(cubes, c_size_t) + 8_c_size_t*int(entries, c_size_t) &
            + 28_c_size_t*int(cells, c_size_t) + 16_c_size_t*int(adjacencies, c_size_t) &
            + 12_c_size_t*int(landmarks, c_size_t) + 72_c_size_t*int(facets, c_size_t) &
            + 48_c_size_t*int(corners, c_size_t) + 1536_c_size_t*int(cube_balls, c_size_t) &
            + 64_c_size_t*int(cube_corners, c_size_t)
  end function

  !> HSP_PATHS_BYTES of the header, for the size of an allocation.
  pure function hsp_paths_bytes_bound(cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
                                      cube_corners, points) result(bytes)
    integer(c_int32_t), intent(in) :: cubes, entries, cells, adjacencies, landmarks, facets, corners
    integer(c_int32_t), intent(in) :: cube_balls, cube_corners, points
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 128_c_size_t*int(cubes, c_size_t) + 8_c_size_t*int(entries, c_size_t) &
            + 136_c_size_t*int(cells, c_size_t) + 48_c_size_t*int(adjacencies, c_size_t) &
            + 12_c_size_t*int(landmarks, c_size_t) + 72_c_size_t*int(facets, c_size_t) &
            + 48_c_size_t*int(corners, c_size_t) + 2176_c_size_t*int(cube_balls, c_size_t) &
            + 64_c_size_t*int(cube_corners, c_size_t) + 24_c_size_t*int(points, c_size_t)
  end function

  !> HSP_GATE_BYTES of the header, for the size of an allocation.
  pure function hsp_gate_bytes_bound(balls, cubes, entries, cells, adjacencies, landmarks, facets, corners, cube_balls, &
                                     cube_corners) result(bytes)
    integer(c_int32_t), intent(in) :: balls, cubes, entries, cells, adjacencies, landmarks, facets, corners
    integer(c_int32_t), intent(in) :: cube_balls, cube_corners
    integer(c_size_t) :: bytes
    bytes = 32768_c_size_t + 160_c_size_t*int(balls, c_size_t) + 128_c_size_t*int(cubes, c_size_t) &
            + 8_c_size_t*int(entries, c_size_t) + 28_c_size_t*int(cells, c_size_t) &
            + 16_c_size_t*int(adjacencies, c_size_t) + 12_c_size_t*int(landmarks, c_size_t) &
            + 72_c_size_t*int(facets, c_size_t) + 48_c_size_t*int(corners, c_size_t) &
            + 1536_c_size_t*int(cube_balls, c_size_t) + 64_c_size_t*int(cube_corners, c_size_t)
  end function

  !> HSP_STICKS_BYTES of the header, for the size of an allocation.
  pure function hsp_sticks_bytes_bound(balls, sticks, pairs, edges) result(bytes)
    integer(c_int32_t), intent(in) :: balls, sticks, pairs, edges
    integer(c_size_t) :: bytes
    bytes = 16384_c_size_t + 192_c_size_t*int(balls, c_size_t) + 384_c_size_t*int(sticks, c_size_t) &
            + 20_c_size_t*int(pairs, c_size_t) + 400_c_size_t*int(edges, c_size_t)
  end function

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
end module hardsphere
