# The C interface of hardsphere, for Julia. Generated from the headers by capi/interface/generate.sh.
# HARDSPHERE_LIBRARY names the shared library; without it the system's loader finds one.
module HardsphereC

const libhardsphere = get(ENV, "HARDSPHERE_LIBRARY", "libhardsphere.so.2")

const HSP_VERSION_MAJOR = UInt32(1)
const HSP_VERSION_MINOR = UInt32(1)
const HSP_VERSION_PATCH = UInt32(0)
const HSP_VERSION_NUMBER = UInt32(10100)
const HSP_ABI_NUMBER = UInt32(2)
const HSP_PROVISIONAL_NUMBER = UInt32(2)
const HSP_NUMERICS_NUMBER = UInt32(3)
const HSP_PROVISIONAL_NUMERICS_NUMBER = UInt32(4)
const HSP_OK = Int32(0)
const HSP_E_ARGUMENT = Int32(-1)
const HSP_E_CAPACITY = Int32(-2)
const HSP_E_MEMORY = Int32(-3)
const HSP_E_STATE = Int32(-4)
const HSP_E_ID = Int32(-5)
const HSP_E_CHECK = Int32(-6)
const HSP_E_SINK = Int32(-7)
const HSP_E_HANDLE = Int32(-8)
const HSP_E_VERSION = Int32(-9)
const HSP_E_NOT_FINITE = Int32(-10)
const HSP_E_NEGATIVE = Int32(-11)
const HSP_E_RANGE = Int32(-12)
const HSP_E_CONFLICT = Int32(-13)
const HSP_E_EXECUTOR = Int32(-15)
const HSP_E_DEGENERATE = Int32(-16)
const HSP_E_STOPPED = Int32(-17)
const HSP_E_DAMAGED = Int32(-18)
const HSP_RADII_BONDI = UInt32(0)
const HSP_RADII_CHEM3D = UInt32(1)
const HSP_RADII_UFF = UInt32(4)
const HSP_RADIUS_FALLBACK = UInt32(1)
const HSP_RADII_PROTOR = UInt32(2)
const HSP_RADII_NACCESS = UInt32(3)
const HSP_NONE = UInt32(4294967295)
const HSP_MAX_BALLS = UInt32(268435455)
const HSP_PACKING_ZERO_RADIUS = UInt32(1)
const HSP_PACKING_COINCIDENT = UInt32(2)
const HSP_PACKING_NO_PAIR = UInt32(4)
const HSP_PAIRS_ONCE = UInt32(1)
const HSP_MAX_WORKERS = UInt32(1024)
const HSP_VERTEX_TIED = UInt32(1)
const HSP_BALL_CONTAINED = UInt32(1)
const HSP_TANGENT_OVERLAP = UInt32(0)
const HSP_TANGENT_DISJOINT = UInt32(1)
const HSP_GRADIENT_ONE_SIDED = UInt32(1)
const HSP_CURVATURE_ONE_SIDED = UInt32(1)
const HSP_HESSIAN_SINGULAR = UInt32(2)
const HSP_BRICK_KEEP_SHELLS = UInt32(1)
const HSP_CONTACT_TOUCHING = UInt32(1)
const HSP_CONTACT_BURIED = UInt32(2)
const HSP_CONTACT_CIRCLE = UInt32(4)
const HSP_SIMPLEX_SINGULAR = UInt32(0)
const HSP_SIMPLEX_REGULAR = UInt32(1)
const HSP_SIMPLEX_INTERIOR = UInt32(2)
const HSP_SURFACE_DEGENERATE = UInt32(1)
const HSP_PATCH_CONVEX = UInt32(0)
const HSP_PATCH_SADDLE = UInt32(1)
const HSP_PATCH_CONCAVE = UInt32(2)
const HSP_PATCH_CIRCLE_SADDLE = UInt32(3)
const HSP_SURFACE_RIM = UInt32(0)
const HSP_SURFACE_CIRCLE_RIM = UInt32(1)
const HSP_SURFACE_SIDE = UInt32(2)
const HSP_SURFACE_CREASE = UInt32(3)
const HSP_CORNER_BALL = UInt32(0)
const HSP_CORNER_CUSP = UInt32(1)
const HSP_CORNER_CREASE = UInt32(2)
const HSP_SHELL_OUTER = UInt32(0)
const HSP_SHELL_VOID = UInt32(1)
const HSP_POINT_VERTEX = UInt32(0)
const HSP_POINT_CIRCLE = UInt32(1)
const HSP_POINT_POLE = UInt32(2)
const HSP_EDGE_ARC = UInt32(0)
const HSP_EDGE_CIRCLE = UInt32(1)
const HSP_EDGE_CUT = UInt32(2)
const HSP_CELL_RUN = UInt32(0)
const HSP_CELL_AT_BALL = UInt32(1)
const HSP_CELL_APART = UInt32(2)
const HSP_PATH_CONNECTED = UInt32(0)
const HSP_PATH_APART = UInt32(1)
const HSP_PATH_COVERED = UInt32(2)
const HSP_PORE_OUTSIDE = UInt32(4294967294)
const HSP_PIECES_OUTSIDE_FARTHER = UInt32(0)
const HSP_PIECES_OUTSIDE_ALL = UInt32(1)
const HSP_VIEW_ALL_BALLS = UInt32(1)
const HSP_MAP_PLAIN = UInt32(0)
const HSP_MAP_TRIPLE = UInt32(1)
const HSP_MAP_T = UInt32(2)
const HSP_MAP_TANGENCY = UInt32(3)
const HSP_MAP_HALVES = UInt32(4)
const HSP_STICK_WHOLE = UInt32(1)
const HSP_STICK_DOUBLE = UInt32(2)
const HSP_STICK_TRIPLE = UInt32(4)
const HSP_STICK_AROMATIC = UInt32(8)
const HSP_STICKS_NO_CONFLICT = UInt32(0)
const HSP_STICKS_BALLS_MEET = UInt32(1)
const HSP_STICKS_NO_BALL = UInt32(2)
const HSP_STICKS_SAME_ENDS = UInt32(3)
const HSP_STICKS_THIN_BALL = UInt32(4)
const HSP_STICKS_SHARP_ANGLE = UInt32(5)
const HSP_STICKS_MEET = UInt32(6)
const HSP_STICKS_STICK_IN_BALL = UInt32(7)
const HSP_STICKS_CYCLE = UInt32(8)
const HSP_FORMAT_SVG = UInt32(0)
const HSP_FORMAT_EPS = UInt32(1)
const HSP_FORMAT_PDF = UInt32(2)
const HSP_STYLE_FLAT = UInt32(0)
const HSP_STYLE_HEADLIGHT = UInt32(1)
const HSP_STYLE_SOFT = UInt32(2)
const HSP_UNIT_PX = UInt32(0)
const HSP_UNIT_MM = UInt32(1)
const HSP_PICTURE_NO_IDS = UInt32(1)
const HSP_PICTURE_NO_BACKGROUND = UInt32(2)
const HSP_INK_BORDER = UInt32(0)
const HSP_INK_GROUP = UInt32(1)
const HSP_INK_DEPTH = UInt32(2)
const HSP_PICTURE_MEMORY = UInt32(71680)
const HSP_PALETTE_SOFT = UInt32(0)
const HSP_PALETTE_JMOL = UInt32(1)
const HSP_PALETTE_CHAIN = UInt32(2)

mutable struct hsp_model end
mutable struct hsp_body end
mutable struct hsp_boundary end
mutable struct hsp_moving end
mutable struct hsp_contacts end
mutable struct hsp_periodic end
mutable struct hsp_surface end
mutable struct hsp_mesh end
mutable struct hsp_topology end
mutable struct hsp_cells end
mutable struct hsp_paths end
mutable struct hsp_pores end
mutable struct hsp_view end
mutable struct hsp_map end
mutable struct hsp_sticks end

struct hsp_executor
    struct_size::UInt32
    workers::UInt32
    context::Ptr{Cvoid}
    run::Ptr{Cvoid}
    proceed::Ptr{Cvoid}
end

struct hsp_residue_atom
    residue::NTuple{8, Cchar}
    atom::NTuple{8, Cchar}
    radius::Cdouble
end

struct hsp_model_options
    struct_size::UInt32
    reserved::UInt32
    probe::Cdouble
    step::Cdouble
    largest_radius::Cdouble
end

struct hsp_model_request
    struct_size::UInt32
    reserved::UInt32
    options::Ptr{hsp_model_options}
    executor::Ptr{hsp_executor}
end

struct hsp_model_info
    balls::UInt32
    cubes::UInt32
    table_slots::UInt32
    longest_probe::UInt32
    step::Cdouble
    probe::Cdouble
    largest_radius::Cdouble
    largest_rounding::Cdouble
    reserved::NTuple{2, UInt64}
end

struct hsp_packing
    k::Cdouble
    rho::Cdouble
    mean_overlaps::Cdouble
    neighbour_bound::Cdouble
    max_overlaps::UInt32
    flags::UInt32
    reserved::NTuple{2, UInt64}
end

struct hsp_pairs_request
    struct_size::UInt32
    flags::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_ray_hit
    xyz::NTuple{3, Cdouble}
    distance::Cdouble
    ball::UInt32
    reserved::UInt32
end

struct hsp_body_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_pose
    quaternion::NTuple{4, Cdouble}
    translation::NTuple{3, Cdouble}
end

struct hsp_body_gap
    gap::Cdouble
    fixed::UInt32
    posed::UInt32
end

struct hsp_body_overlap
    volume::Cdouble
    pairs::UInt32
    reserved::UInt32
end

struct hsp_rational_pose
    quaternion::NTuple{4, Int32}
    translation::NTuple{3, Cdouble}
end

struct hsp_boundary_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
    vertices::UInt32
    circles::UInt32
    workers::UInt32
end

struct hsp_boundary_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
    selected::Ptr{UInt8}
end

struct hsp_boundary_counts
    balls::UInt32
    exposed_balls::UInt32
    contained_balls::UInt32
    vertices::UInt32
    arcs::UInt32
    circles::UInt32
    faces::UInt32
    loops::UInt32
    shells::UInt32
    components::UInt32
    voids::UInt32
    tied_vertices::UInt32
    euler::Int64
    reserved::NTuple{2, UInt64}
end

struct hsp_vertex
    xyz::NTuple{3, Cdouble}
    ball::NTuple{3, UInt32}
    sign::Int32
    flags::UInt32
    reserved::UInt32
end

struct hsp_arc
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    angle::Cdouble
    ball::NTuple{2, UInt32}
    vertex::NTuple{2, UInt32}
    face::NTuple{2, UInt32}
end

struct hsp_circle
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    ball::NTuple{2, UInt32}
    face::NTuple{2, UInt32}
end

struct hsp_face
    ball::UInt32
    loops::UInt32
    shell::UInt32
    first_loop::UInt32
end

struct hsp_loop
    face::UInt32
    circle::UInt32
    side::UInt32
    first_arc::UInt32
    arcs::UInt32
end

struct hsp_loop_arc
    arc::UInt32
    side::UInt32
    vertex::UInt32
end

struct hsp_ball
    faces::UInt32
    first_face::UInt32
    component::UInt32
    flags::UInt32
end

struct hsp_totals
    area::Cdouble
    volume::Cdouble
    reserved::NTuple{2, UInt64}
end

struct hsp_measure_request
    struct_size::UInt32
    reserved::UInt32
    selected::Ptr{UInt8}
    executor::Ptr{hsp_executor}
end

struct hsp_measure_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    reserved::UInt32
    totals::Ptr{hsp_totals}
    area::Ptr{Cdouble}
    volume_term::Ptr{Cdouble}
end

struct hsp_energy
    value::Cdouble
    area::Cdouble
    volume::Cdouble
    d_probe::Cdouble
    reserved::NTuple{2, UInt64}
end

struct hsp_gradient_request
    struct_size::UInt32
    tangency::UInt32
    tension::Cdouble
    pressure::Cdouble
    sigma::Ptr{Cdouble}
    executor::Ptr{hsp_executor}
end

struct hsp_gradient_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    first_bad::UInt32
    energy::Ptr{hsp_energy}
    d_centre::Ptr{Cdouble}
    d_radius::Ptr{Cdouble}
    flags::Ptr{UInt32}
    area::Ptr{Cdouble}
end

struct hsp_derivatives_request
    struct_size::UInt32
    tangency::UInt32
    sigma::Ptr{Cdouble}
    executor::Ptr{hsp_executor}
end

struct hsp_derivatives_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    first_bad::UInt32
    area_centre::Ptr{Cdouble}
    area_radius::Ptr{Cdouble}
    volume_centre::Ptr{Cdouble}
    volume_radius::Ptr{Cdouble}
    flags::Ptr{UInt32}
end

struct hsp_area_derivative
    centre::NTuple{3, Cdouble}
    radius::Cdouble
    angle::Cdouble
    ball::UInt32
    flags::UInt32
end

struct hsp_moving_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
end

struct hsp_moving_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_moving_info
    step::Cdouble
    probe::Cdouble
    largest_radius::Cdouble
    vertices::UInt64
    arcs::UInt64
    circles::UInt64
    faces::UInt64
    loops::UInt64
    balls::UInt32
    exposed_balls::UInt32
    contained_balls::UInt32
    components::UInt32
    changed::UInt32
    reserved::UInt32
end

struct hsp_moving_ball
    centre::NTuple{3, Cdouble}
    radius::Cdouble
    area::Cdouble
    volume_term::Cdouble
    d_centre::NTuple{3, Cdouble}
    d_radius::Cdouble
    faces::UInt32
    flags::UInt32
    gradient_flags::UInt32
    reserved::UInt32
end

struct hsp_curvatures
    mean::Cdouble
    gauss::Cdouble
end

struct hsp_curvature_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_morphometry_request
    struct_size::UInt32
    reserved::UInt32
    pressure::Cdouble
    tension::Cdouble
    bending::Cdouble
    gaussian::Cdouble
    sigma::Ptr{Cdouble}
    executor::Ptr{hsp_executor}
end

struct hsp_morphometric_energy
    value::Cdouble
    volume::Cdouble
    area::Cdouble
    mean::Cdouble
    gauss::Cdouble
    d_probe::Cdouble
end

struct hsp_morphometry_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    first_bad::UInt32
    energy::Ptr{hsp_morphometric_energy}
    d_centre::Ptr{Cdouble}
    d_radius::Ptr{Cdouble}
    flags::Ptr{UInt32}
    area::Ptr{Cdouble}
end

struct hsp_brick_request
    struct_size::UInt32
    brick::UInt32
    bricks::UInt32
    flags::UInt32
    id::Ptr{UInt64}
    owner::Ptr{UInt32}
    executor::Ptr{hsp_executor}
end

struct hsp_brick_totals
    balls::UInt64
    exposed_balls::UInt64
    contained_balls::UInt64
    vertices::UInt64
    arcs::UInt64
    circles::UInt64
    faces::UInt64
    loops::UInt64
    shells::UInt64
    components::UInt64
    voids::UInt64
    tied_vertices::UInt64
    euler::Int64
    area::Cdouble
    volume::Cdouble
    void_volume::Cdouble
    reserved::NTuple{2, UInt64}
end

struct hsp_brick_shell
    component::UInt64
    faces::UInt64
    euler::Int64
    area::Cdouble
    volume::Cdouble
    kind::UInt32
    reserved::NTuple{3, UInt32}
end

struct hsp_contacts_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
    contacts::UInt32
    triangles::UInt32
    tetrahedra::UInt32
end

struct hsp_contacts_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_contact
    area::Cdouble
    rim::Cdouble
    distance::Cdouble
    ball::NTuple{2, UInt32}
    chords::UInt32
    flags::UInt32
    reserved::NTuple{2, UInt32}
end

struct hsp_group_contact
    area::Cdouble
    rim::Cdouble
    group::NTuple{2, UInt32}
    contacts::UInt32
    reserved::UInt32
end

struct hsp_complex
    singular::NTuple{4, UInt32}
    regular::NTuple{4, UInt32}
    interior::NTuple{4, UInt32}
    euler::Int64
    betti::NTuple{3, UInt32}
    reserved::NTuple{5, UInt32}
end

struct hsp_simplex
    ball::NTuple{4, UInt32}
    kind::UInt32
    reserved::UInt32
end

struct hsp_periodic_limits
    struct_size::UInt32
    balls::UInt32
    images::UInt32
    neighbours::UInt32
    vertices::UInt32
    circles::UInt32
    contacts::UInt32
    workers::UInt32
end

struct hsp_periodic_request
    struct_size::UInt32
    areas_alone::UInt32
    options::Ptr{hsp_model_options}
    executor::Ptr{hsp_executor}
end

struct hsp_periodic_counts
    balls::UInt32
    images::UInt32
    vertices::UInt32
    arcs::UInt32
    circles::UInt32
    loops::UInt32
    faces::UInt32
    shells::UInt32
    components::UInt32
    contacts::UInt32
    euler::Int64
end

struct hsp_periodic_totals
    area::Cdouble
    volume::Cdouble
    box_volume::Cdouble
    free_volume::Cdouble
    contact_area::Cdouble
end

struct hsp_periodic_morphometry_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    first_bad::UInt32
    energy::Ptr{hsp_morphometric_energy}
    d_centre::Ptr{Cdouble}
    d_radius::Ptr{Cdouble}
    flags::Ptr{UInt32}
    d_strain::Ptr{Cdouble}
    d_box::Ptr{Cdouble}
    area::Ptr{Cdouble}
end

struct hsp_periodic_contact
    area::Cdouble
    rim::Cdouble
    distance::Cdouble
    ball::NTuple{2, UInt32}
    chords::UInt32
    flags::UInt32
    shift::NTuple{3, Int32}
    reserved::UInt32
end

struct hsp_winding
    balls::UInt32
    first::UInt32
    directions::UInt32
    copies::UInt32
    row::NTuple{9, Int32}
end

struct hsp_periodic_gradient_outputs
    struct_size::UInt32
    capacity::UInt32
    needed::UInt32
    first_bad::UInt32
    energy::Ptr{hsp_energy}
    d_centre::Ptr{Cdouble}
    d_radius::Ptr{Cdouble}
    flags::Ptr{UInt32}
    d_strain::Ptr{Cdouble}
    d_box::Ptr{Cdouble}
    area::Ptr{Cdouble}
end

struct hsp_image
    ball::UInt32
    shift::NTuple{3, Int32}
end

struct hsp_periodic_id
    id::UInt32
    shift::NTuple{3, Int32}
end

struct hsp_periodic_vertex
    xyz::NTuple{3, Cdouble}
    image::NTuple{3, hsp_image}
    sign::Int32
    flags::UInt32
end

struct hsp_periodic_arc
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    angle::Cdouble
    image::NTuple{2, hsp_image}
    vertex::NTuple{2, hsp_periodic_id}
    face::NTuple{2, hsp_periodic_id}
end

struct hsp_periodic_circle
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    image::NTuple{2, hsp_image}
    face::NTuple{2, hsp_periodic_id}
end

struct hsp_periodic_face
    image::hsp_image
    loops::UInt32
    shell::UInt32
    first_loop::UInt32
    reserved::UInt32
end

struct hsp_periodic_loop
    circle::hsp_periodic_id
    face::UInt32
    side::UInt32
    first_arc::UInt32
    arcs::UInt32
end

struct hsp_periodic_loop_arc
    arc::hsp_periodic_id
    vertex::hsp_periodic_id
    side::UInt32
    reserved::UInt32
end

struct hsp_surface_limits
    struct_size::UInt32
    vertices::UInt32
    faces::UInt32
    neighbours::UInt32
    pieces::UInt32
    arcs::UInt32
    cusped_circles::UInt32
end

struct hsp_surface_request
    struct_size::UInt32
    count::UInt32
    executor::Ptr{hsp_executor}
    shells::Ptr{UInt32}
end

struct hsp_surface_counts
    convex_patches::UInt32
    saddle_patches::UInt32
    concave_patches::UInt32
    cusped_patches::UInt32
    cut_patches::UInt32
    hidden_patches::UInt32
    rounded_patches::UInt32
    open_joints::UInt32
end

struct hsp_surface_totals
    area::Cdouble
    volume::Cdouble
    convex_area::Cdouble
    saddle_area::Cdouble
    concave_area::Cdouble
end

struct hsp_surface_measure_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_surface_part_counts
    patches::UInt32
    edges::UInt32
    corners::UInt32
    shells::UInt32
    cusps::UInt32
    junctions::UInt32
    creases::UInt32
    reserved::UInt32
end

struct hsp_surface_patch
    area::Cdouble
    kind::UInt32
    source::UInt32
    part::UInt32
    shell::UInt32
    loops::UInt32
    edges::UInt32
    h::UInt32
    reserved::UInt32
end

struct hsp_surface_edge
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    angle::Cdouble
    patch::NTuple{2, UInt32}
    corner::NTuple{2, UInt32}
    next::NTuple{2, UInt32}
    previous::NTuple{2, UInt32}
    kind::UInt32
    source::UInt32
end

struct hsp_surface_corner
    xyz::NTuple{3, Cdouble}
    kind::UInt32
    ball::NTuple{2, UInt32}
    vertex::NTuple{3, UInt32}
    shell::UInt32
    reserved::UInt32
end

struct hsp_surface_shell
    area::Cdouble
    volume::Cdouble
    euler::Int64
    genus::UInt32
    patches::UInt32
    chosen::UInt32
    reserved::UInt32
end

struct hsp_mesh_limits
    struct_size::UInt32
    balls::UInt32
    curves::UInt32
    vertices::UInt32
    triangles::UInt32
    points::UInt32
end

struct hsp_mesh_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_mesh_counts
    vertices::UInt32
    triangles::UInt32
    curves::UInt32
    refined::UInt32
end

struct hsp_topology_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
    edges::UInt32
    cut_arcs::UInt32
    shells::UInt32
end

struct hsp_topology_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_topology_counts
    vertices::UInt32
    edges::UInt32
    simple_faces::UInt32
    cut_edges::UInt32
    shells::UInt32
    components::UInt32
    regions::UInt32
    start_face::UInt32
    reserved::NTuple{4, UInt32}
end

struct hsp_shell
    area::Cdouble
    volume::Cdouble
    point::NTuple{3, Cdouble}
    euler::Int64
    genus::UInt32
    kind::UInt32
    component::UInt32
    region::UInt32
    faces::UInt32
    simple_faces::UInt32
    edges::UInt32
    vertices::UInt32
    start_face::UInt32
    reserved::UInt32
end

struct hsp_component
    balls::UInt32
    top_ball::UInt32
    outer_shell::UInt32
    shells::UInt32
    region::UInt32
    reserved::UInt32
end

struct hsp_region
    area::Cdouble
    volume::Cdouble
    enclosing_shell::UInt32
    components::UInt32
    shells::UInt32
    reserved::UInt32
end

struct hsp_topology_vertex
    xyz::NTuple{3, Cdouble}
    ball::NTuple{3, UInt32}
    kind::UInt32
    q::UInt32
    reserved::UInt32
end

struct hsp_topology_edge
    centre::NTuple{3, Cdouble}
    axis::NTuple{3, Cdouble}
    radius::Cdouble
    angle::Cdouble
    vertex::NTuple{2, UInt32}
    face::NTuple{2, UInt32}
    ball::NTuple{2, UInt32}
    kind::UInt32
    source::UInt32
end

struct hsp_simple_face
    ball::UInt32
    face::UInt32
    edges::UInt32
    q::UInt32
    shell::UInt32
    reserved::UInt32
end

struct hsp_cells_limits
    struct_size::UInt32
    cubes::UInt32
    entries::UInt32
    cells::UInt32
    adjacencies::UInt32
    landmarks::UInt32
    facets::UInt32
    corners::UInt32
    cube_balls::UInt32
    cube_corners::UInt32
end

struct hsp_cells_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_cells_counts
    cubes::UInt32
    power_cells::UInt32
    cells::UInt32
    runs::UInt32
    adjacencies::UInt32
    regions::UInt32
end

struct hsp_free_cell
    low::NTuple{3, Cdouble}
    high::NTuple{3, Cdouble}
    ball::UInt32
    cube::UInt32
    kind::UInt32
    region::UInt32
    neighbours::UInt32
    reserved::UInt32
end

struct hsp_cell_pair
    cell::NTuple{2, UInt32}
end

struct hsp_arrangement
    vertices::UInt64
    edges::UInt64
    faces::UInt64
end

struct hsp_paths_limits
    struct_size::UInt32
    cubes::UInt32
    entries::UInt32
    cells::UInt32
    adjacencies::UInt32
    landmarks::UInt32
    facets::UInt32
    corners::UInt32
    cube_balls::UInt32
    cube_corners::UInt32
    points::UInt32
end

struct hsp_paths_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_path
    length::Cdouble
    clearance::Cdouble
    ends::UInt32
    certified::UInt32
    points::UInt32
    reserved::UInt32
end

struct hsp_pores_limits
    struct_size::UInt32
    balls::UInt32
    maxima::UInt32
    gates::UInt32
    tied::UInt32
    candidates::UInt32
    neighbours::UInt32
    points::UInt32
end

struct hsp_pores_options
    struct_size::UInt32
    reserved::UInt32
    floor::Cdouble
    executor::Ptr{hsp_executor}
    before::Ptr{hsp_pores}
end

struct hsp_pores_counts
    maxima::UInt32
    gates::UInt32
    merges::UInt32
    cavities::UInt32
    outer_balls::UInt32
    reserved::UInt32
end

struct hsp_pore_maximum
    xyz::NTuple{3, Cdouble}
    radius::Cdouble
    death::Cdouble
    ball::NTuple{4, UInt32}
    gate::UInt32
    parent::UInt32
end

struct hsp_pore_gate
    xyz::NTuple{3, Cdouble}
    radius::Cdouble
    ball::NTuple{3, UInt32}
    var"end"::NTuple{2, UInt32}
    merges::UInt32
end

struct hsp_pore_gate_shifts
    ball::NTuple{9, Int32}
    var"end"::NTuple{6, Int32}
    winds::UInt32
    directions::UInt32
end

struct hsp_pore_percolation
    largest::Cdouble
    through::NTuple{3, Cdouble}
    included::NTuple{3, Cdouble}
    along::NTuple{3, Cdouble}
    gate::NTuple{3, UInt32}
    maximum::NTuple{3, UInt32}
    gate_along::NTuple{3, UInt32}
    reserved::UInt32
end

struct hsp_pore_channel
    radius::Cdouble
    maximum::UInt32
    maxima::UInt32
    directions::UInt32
    copies::UInt32
    row::NTuple{9, Int32}
    reserved::UInt32
end

struct hsp_pore_place
    radius::Cdouble
    ball::UInt32
    maximum::UInt32
end

struct hsp_pore_place_shifts
    ball::NTuple{3, Int32}
    maximum::NTuple{3, Int32}
end

struct hsp_pore_passage
    radius::Cdouble
    passes::UInt32
    gate::UInt32
    ball::UInt32
    at::NTuple{2, UInt32}
    reserved::UInt32
end

struct hsp_tunnel
    radius::Cdouble
    length::Cdouble
    there::UInt32
    gate::UInt32
    gates::UInt32
    points::UInt32
    outside::UInt32
    reserved::UInt32
end

struct hsp_tunnel_request
    struct_size::UInt32
    cheapest::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_tunnel_route
    cost::Cdouble
    shift::NTuple{3, Int32}
    reserved::UInt32
end

struct hsp_tunnel_point
    xyz::NTuple{3, Cdouble}
    radius::Cdouble
    ball::NTuple{4, UInt32}
    gate::UInt32
    maximum::UInt32
end

struct hsp_tunnel_point_shifts
    ball::NTuple{12, Int32}
    at::NTuple{3, Int32}
end

struct hsp_pore_pocket
    radius::Cdouble
    mouth::Cdouble
    maximum::UInt32
    gate::UInt32
    maxima::UInt32
    mouths::UInt32
    balls::UInt32
    reserved::UInt32
end

struct hsp_pore_access
    accessible_area::Cdouble
    accessible_volume::Cdouble
    blocked_area::Cdouble
    blocked_volume::Cdouble
    accessible::UInt32
    blocked::UInt32
end

struct hsp_pores_request
    struct_size::UInt32
    reserved::UInt32
    executor::Ptr{hsp_executor}
end

struct hsp_pore_region
    radius::Cdouble
    area::Cdouble
    volume::Cdouble
    maximum::UInt32
    maxima::UInt32
    shells::UInt32
    accessible::UInt32
    directions::UInt32
    copies::UInt32
    row::NTuple{9, Int32}
    reserved::UInt32
end

struct hsp_pore_pocket_size
    volume::Cdouble
    area::Cdouble
    plug_area::Cdouble
    regions::UInt32
    closed::UInt32
end

struct hsp_view_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
    arcs::UInt32
end

struct hsp_view_options
    struct_size::UInt32
    pieces::UInt32
    flags::UInt32
    reserved::UInt32
    towards::NTuple{3, Cdouble}
    up::NTuple{3, Cdouble}
    executor::Ptr{hsp_executor}
    unused::Ptr{Cvoid}
end

struct hsp_view_info
    origin::NTuple{3, Cdouble}
    right::NTuple{3, Cdouble}
    up::NTuple{3, Cdouble}
    towards::NTuple{3, Cdouble}
    low::NTuple{2, Cdouble}
    high::NTuple{2, Cdouble}
    depth_low::Cdouble
    depth_high::Cdouble
    pieces::UInt32
    loops::UInt32
    arcs::UInt32
    kind::UInt32
end

struct hsp_view_piece
    centre::NTuple{2, Cdouble}
    depth::Cdouble
    radius::Cdouble
    ball::UInt32
    first_loop::UInt32
    loops::UInt32
    first_arc::UInt32
    arcs::UInt32
    reserved::UInt32
end

struct hsp_view_loop
    piece::UInt32
    first_arc::UInt32
    arcs::UInt32
    reserved::UInt32
end

struct hsp_view_arc
    centre::NTuple{2, Cdouble}
    semi_axis::NTuple{2, Cdouble}
    rotation::Cdouble
    from::Cdouble
    to::Cdouble
    start::NTuple{2, Cdouble}
    var"end"::NTuple{2, Cdouble}
    piece::UInt32
    other_ball::UInt32
end

struct hsp_map_limits
    struct_size::UInt32
    balls::UInt32
    neighbours::UInt32
    edges::UInt32
end

struct hsp_map_info
    origin::NTuple{3, Cdouble}
    right::NTuple{3, Cdouble}
    up::NTuple{3, Cdouble}
    towards::NTuple{3, Cdouble}
    area::Cdouble
    perturbation::Cdouble
    vertices::UInt32
    edges::UInt32
    faces::UInt32
    components::UInt32
    balls::UInt32
    reserved::UInt32
end

struct hsp_map_vertex
    xyz::NTuple{3, Cdouble}
    kind::UInt32
    h::UInt32
    ball::NTuple{3, UInt32}
    reserved::UInt32
end

struct hsp_map_edge
    centre::NTuple{2, Cdouble}
    first::NTuple{2, Cdouble}
    second::NTuple{2, Cdouble}
    from::Cdouble
    to::Cdouble
    ball::NTuple{2, UInt32}
    face::NTuple{2, UInt32}
    vertex::NTuple{2, UInt32}
    next::NTuple{2, UInt32}
end

struct hsp_map_face
    area::Cdouble
    ball::UInt32
    h::UInt32
    loops::UInt32
    reserved::UInt32
end

struct hsp_map_sight
    depth::Cdouble
    ball::UInt32
    face::UInt32
end

struct hsp_map_point
    xyz::NTuple{3, Cdouble}
    gap::NTuple{2, Cdouble}
end

struct hsp_map_pole
    centre::NTuple{2, Cdouble}
    radius::Cdouble
    bound::Cdouble
end

struct hsp_sticks_limits
    struct_size::UInt32
    balls::UInt32
    sticks::UInt32
    pairs::UInt32
    edges::UInt32
end

struct hsp_stick
    ball::NTuple{2, UInt32}
    flags::UInt32
    reserved::UInt32
end

struct hsp_sticks_conflict
    kind::UInt32
    first::UInt32
    second::UInt32
    reserved::UInt32
end

struct hsp_sticks_info
    origin::NTuple{3, Cdouble}
    right::NTuple{3, Cdouble}
    up::NTuple{3, Cdouble}
    towards::NTuple{3, Cdouble}
    low::NTuple{2, Cdouble}
    high::NTuple{2, Cdouble}
    paths::UInt32
    balls::UInt32
    sticks::UInt32
    arcs::UInt32
end

struct hsp_picture_options
    struct_size::UInt32
    format::UInt32
    style::UInt32
    unit::UInt32
    width::Cdouble
    height::Cdouble
    margin::Cdouble
    outline::Cdouble
    fog::Cdouble
    outline_colour::UInt32
    background::UInt32
    flags::UInt32
    reserved::UInt32
    scale::Cdouble
    centre::NTuple{3, Cdouble}
    memory::Ptr{Cvoid}
    memory_bytes::Csize_t
    ink::Ptr{hsp_map}
    group::Ptr{UInt32}
    ink_width::NTuple{3, Cdouble}
    ink_colour::NTuple{3, UInt32}
    reserved_for_ink::UInt32
    atom_class::Ptr{Ptr{Cchar}}
    atom_title::Ptr{Ptr{Cchar}}
    ink_of_sticks::Ptr{hsp_sticks}
    reserved_for_sticks::Csize_t
end

function hsp_version()
    ccall((:hsp_version, libhardsphere), UInt32, ())
end

function hsp_abi()
    ccall((:hsp_abi, libhardsphere), UInt32, ())
end

function hsp_provisional()
    ccall((:hsp_provisional, libhardsphere), UInt32, ())
end

function hsp_numerics()
    ccall((:hsp_numerics, libhardsphere), UInt32, ())
end

function hsp_provisional_numerics()
    ccall((:hsp_provisional_numerics, libhardsphere), UInt32, ())
end

function hsp_status_text(status)
    ccall((:hsp_status_text, libhardsphere), Cstring, (Int32,), status)
end

function hsp_element_radius(set, atomic_number, radius, flags)
    ccall((:hsp_element_radius, libhardsphere), Int32, (UInt32, UInt32, Ptr{Cdouble}, Ptr{UInt32}), set, atomic_number,
          radius, flags)
end

function hsp_element_number(symbol, atomic_number)
    ccall((:hsp_element_number, libhardsphere), Int32, (Ptr{Cchar}, Ptr{UInt32}), symbol, atomic_number)
end

function hsp_element_symbol(atomic_number)
    ccall((:hsp_element_symbol, libhardsphere), Cstring, (UInt32,), atomic_number)
end

function hsp_residue_radius(set, residue, atom, radius)
    ccall((:hsp_residue_radius, libhardsphere), Int32, (UInt32, Ptr{Cchar}, Ptr{Cchar}, Ptr{Cdouble}), set, residue,
          atom, radius)
end

function hsp_residue_get_atoms(set, out, capacity, needed)
    ccall((:hsp_residue_get_atoms, libhardsphere), Int32, (UInt32, Ptr{hsp_residue_atom}, UInt32, Ptr{UInt32}), set,
          out, capacity, needed)
end

function hsp_model_max_balls()
    ccall((:hsp_model_max_balls, libhardsphere), UInt32, ())
end

function hsp_model_bytes(balls, bytes)
    ccall((:hsp_model_bytes, libhardsphere), Int32, (UInt32, Ptr{Csize_t}), balls, bytes)
end

function hsp_model_init(memory, bytes, balls, model)
    ccall((:hsp_model_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, UInt32, Ptr{Ptr{hsp_model}}), memory, bytes,
          balls, model)
end

function hsp_model_options_init(options, struct_size)
    ccall((:hsp_model_options_init, libhardsphere), Int32, (Ptr{hsp_model_options}, UInt32), options, struct_size)
end

function hsp_model_set(model, n, xyz, radius, options, first_bad)
    ccall((:hsp_model_set, libhardsphere), Int32, (Ptr{hsp_model}, UInt32, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{hsp_model_options}, Ptr{UInt32}), model, n, xyz, radius, options, first_bad)
end

function hsp_model_set_with(model, n, xyz, radius, request, first_bad)
    ccall((:hsp_model_set_with, libhardsphere), Int32, (Ptr{hsp_model}, UInt32, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{hsp_model_request}, Ptr{UInt32}), model, n, xyz, radius, request, first_bad)
end

function hsp_model_get_info(model, info)
    ccall((:hsp_model_get_info, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{hsp_model_info}), model, info)
end

function hsp_model_get_balls(model, xyz, radius, capacity, needed)
    ccall((:hsp_model_get_balls, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{Cdouble}, Ptr{Cdouble}, UInt32,
          Ptr{UInt32}), model, xyz, radius, capacity, needed)
end

function hsp_model_get_packing(model, figures)
    ccall((:hsp_model_get_packing, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{hsp_packing}), model, figures)
end

function hsp_query_point(model, xyz, ids, capacity, needed)
    ccall((:hsp_query_point, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{Cdouble}, Ptr{UInt32}, UInt32, Ptr{UInt32}),
          model, xyz, ids, capacity, needed)
end

function hsp_query_ball(model, xyz, radius, ids, capacity, needed)
    ccall((:hsp_query_ball, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{Cdouble}, Cdouble, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), model, xyz, radius, ids, capacity, needed)
end

function hsp_query_meets(model, xyz, radius, meets)
    ccall((:hsp_query_meets, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{Cdouble}, Cdouble, Ptr{UInt32}), model, xyz,
          radius, meets)
end

function hsp_query_neighbours(model, ball, ids, capacity, needed)
    ccall((:hsp_query_neighbours, libhardsphere), Int32, (Ptr{hsp_model}, UInt32, Ptr{UInt32}, UInt32, Ptr{UInt32}),
          model, ball, ids, capacity, needed)
end

function hsp_query_pairs(model, flags, first, ids, capacity, needed)
    ccall((:hsp_query_pairs, libhardsphere), Int32, (Ptr{hsp_model}, UInt32, Ptr{UInt32}, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), model, flags, first, ids, capacity, needed)
end

function hsp_query_pairs_with(model, request, first, ids, capacity, needed)
    ccall((:hsp_query_pairs_with, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{hsp_pairs_request}, Ptr{UInt32},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), model, request, first, ids, capacity, needed)
end

function hsp_query_ray(model, origin, direction, hit)
    ccall((:hsp_query_ray, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{hsp_ray_hit}),
          model, origin, direction, hit)
end

function hsp_body_bytes(balls, bytes)
    ccall((:hsp_body_bytes, libhardsphere), Int32, (UInt32, Ptr{Csize_t}), balls, bytes)
end

function hsp_body_init(memory, bytes, balls, body)
    ccall((:hsp_body_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, UInt32, Ptr{Ptr{hsp_body}}), memory, bytes,
          balls, body)
end

function hsp_body_set(body, model)
    ccall((:hsp_body_set, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_model}), body, model)
end

function hsp_body_set_with(body, model, request)
    ccall((:hsp_body_set_with, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_model}, Ptr{hsp_body_request}), body,
          model, request)
end

function hsp_pose_from_matrix(matrix, translation, pose)
    ccall((:hsp_pose_from_matrix, libhardsphere), Int32, (Ptr{Cdouble}, Ptr{Cdouble}, Ptr{hsp_pose}), matrix,
          translation, pose)
end

function hsp_body_hits(fixed, posed, poses, pose, hit, first_bad)
    ccall((:hsp_body_hits, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32, Ptr{hsp_pose}, Ptr{UInt32},
          Ptr{UInt32}), fixed, posed, poses, pose, hit, first_bad)
end

function hsp_body_hits_along(fixed, posed, poses, pose, margin, hit, first_bad)
    ccall((:hsp_body_hits_along, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32, Ptr{hsp_pose}, Cdouble,
          Ptr{UInt32}, Ptr{UInt32}), fixed, posed, poses, pose, margin, hit, first_bad)
end

function hsp_body_gaps(fixed, posed, poses, pose, gap, first_bad)
    ccall((:hsp_body_gaps, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32, Ptr{hsp_pose},
          Ptr{hsp_body_gap}, Ptr{UInt32}), fixed, posed, poses, pose, gap, first_bad)
end

function hsp_body_overlaps(fixed, posed, poses, pose, overlap, first_bad)
    ccall((:hsp_body_overlaps, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32, Ptr{hsp_pose},
          Ptr{hsp_body_overlap}, Ptr{UInt32}), fixed, posed, poses, pose, overlap, first_bad)
end

function hsp_body_pairs(fixed, posed, pose, pair, capacity, needed)
    ccall((:hsp_body_pairs, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, Ptr{hsp_pose}, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), fixed, posed, pose, pair, capacity, needed)
end

function hsp_body_rational_hits(fixed, posed, poses, pose, hit, first_bad)
    ccall((:hsp_body_rational_hits, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32,
          Ptr{hsp_rational_pose}, Ptr{UInt32}, Ptr{UInt32}), fixed, posed, poses, pose, hit, first_bad)
end

function hsp_body_rational_hits_along(fixed, posed, poses, pose, margin, hit, first_bad)
    ccall((:hsp_body_rational_hits_along, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32,
          Ptr{hsp_rational_pose}, Cdouble, Ptr{UInt32}, Ptr{UInt32}), fixed, posed, poses, pose, margin, hit, first_bad)
end

function hsp_body_rational_gaps(fixed, posed, poses, pose, gap, first_bad)
    ccall((:hsp_body_rational_gaps, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, UInt32,
          Ptr{hsp_rational_pose}, Ptr{hsp_body_gap}, Ptr{UInt32}), fixed, posed, poses, pose, gap, first_bad)
end

function hsp_body_rational_pairs(fixed, posed, pose, pair, capacity, needed)
    ccall((:hsp_body_rational_pairs, libhardsphere), Int32, (Ptr{hsp_body}, Ptr{hsp_body}, Ptr{hsp_rational_pose},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), fixed, posed, pose, pair, capacity, needed)
end

function hsp_boundary_limits_init(limits, struct_size, balls)
    ccall((:hsp_boundary_limits_init, libhardsphere), Int32, (Ptr{hsp_boundary_limits}, UInt32, UInt32), limits,
          struct_size, balls)
end

function hsp_boundary_bytes(limits, bytes)
    ccall((:hsp_boundary_bytes, libhardsphere), Int32, (Ptr{hsp_boundary_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_boundary_init(memory, bytes, limits, boundary)
    ccall((:hsp_boundary_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_boundary_limits},
          Ptr{Ptr{hsp_boundary}}), memory, bytes, limits, boundary)
end

function hsp_boundary_compute(boundary, model, limits)
    ccall((:hsp_boundary_compute, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_model}, Ptr{hsp_boundary_limits}),
          boundary, model, limits)
end

function hsp_boundary_compute_with(boundary, model, request, limits)
    ccall((:hsp_boundary_compute_with, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_model},
          Ptr{hsp_boundary_request}, Ptr{hsp_boundary_limits}), boundary, model, request, limits)
end

function hsp_boundary_get_counts(boundary, counts)
    ccall((:hsp_boundary_get_counts, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_boundary_counts}), boundary,
          counts)
end

function hsp_boundary_get_vertices(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_vertices, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_vertex}, UInt32,
          Ptr{UInt32}), boundary, out, capacity, needed)
end

function hsp_boundary_get_arcs(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_arcs, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_arc}, UInt32, Ptr{UInt32}),
          boundary, out, capacity, needed)
end

function hsp_boundary_get_circles(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_circles, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_circle}, UInt32, Ptr{UInt32}),
          boundary, out, capacity, needed)
end

function hsp_boundary_get_faces(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_faces, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_face}, UInt32, Ptr{UInt32}),
          boundary, out, capacity, needed)
end

function hsp_boundary_get_loops(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_loops, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_loop}, UInt32, Ptr{UInt32}),
          boundary, out, capacity, needed)
end

function hsp_boundary_get_loop_arcs(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_loop_arcs, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_loop_arc}, UInt32,
          Ptr{UInt32}), boundary, out, capacity, needed)
end

function hsp_boundary_get_balls(boundary, out, capacity, needed)
    ccall((:hsp_boundary_get_balls, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_ball}, UInt32, Ptr{UInt32}),
          boundary, out, capacity, needed)
end

function hsp_boundary_check(boundary, invariant, id)
    ccall((:hsp_boundary_check, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{UInt32}, Ptr{UInt32}), boundary,
          invariant, id)
end

function hsp_areas_bytes(n, bytes)
    ccall((:hsp_areas_bytes, libhardsphere), Int32, (UInt32, Ptr{Csize_t}), n, bytes)
end

function hsp_areas(n, xyz, radius, probe, memory, bytes, totals, area)
    ccall((:hsp_areas, libhardsphere), Int32, (UInt32, Ptr{Cdouble}, Ptr{Cdouble}, Cdouble, Ptr{Cvoid}, Ptr{Csize_t},
          Ptr{hsp_totals}, Ptr{Cdouble}), n, xyz, radius, probe, memory, bytes, totals, area)
end

function hsp_boundary_measure(boundary, selected, totals, area, volume_term, capacity, needed)
    ccall((:hsp_boundary_measure, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{UInt8}, Ptr{hsp_totals}, Ptr{Cdouble},
          Ptr{Cdouble}, UInt32, Ptr{UInt32}), boundary, selected, totals, area, volume_term, capacity, needed)
end

function hsp_boundary_get_measures(boundary, request, outputs)
    ccall((:hsp_boundary_get_measures, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_measure_request},
          Ptr{hsp_measure_outputs}), boundary, request, outputs)
end

function hsp_boundary_measure_faces(boundary, area, volume_term, capacity, needed)
    ccall((:hsp_boundary_measure_faces, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{Cdouble}, Ptr{Cdouble}, UInt32,
          Ptr{UInt32}), boundary, area, volume_term, capacity, needed)
end

function hsp_gradient_request_init(request, struct_size)
    ccall((:hsp_gradient_request_init, libhardsphere), Int32, (Ptr{hsp_gradient_request}, UInt32), request, struct_size)
end

function hsp_boundary_get_gradient(boundary, request, outputs)
    ccall((:hsp_boundary_get_gradient, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_gradient_request},
          Ptr{hsp_gradient_outputs}), boundary, request, outputs)
end

function hsp_boundary_get_derivatives(boundary, request, outputs)
    ccall((:hsp_boundary_get_derivatives, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_derivatives_request},
          Ptr{hsp_derivatives_outputs}), boundary, request, outputs)
end

function hsp_boundary_get_area_row(boundary, ball, tangency, out, capacity, needed)
    ccall((:hsp_boundary_get_area_row, libhardsphere), Int32, (Ptr{hsp_boundary}, UInt32, UInt32,
          Ptr{hsp_area_derivative}, UInt32, Ptr{UInt32}), boundary, ball, tangency, out, capacity, needed)
end

function hsp_boundary_get_area_rows(boundary, request, first, ball, d_centre, d_radius, capacity, needed)
    ccall((:hsp_boundary_get_area_rows, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_derivatives_request},
          Ptr{UInt32}, Ptr{UInt32}, Ptr{Cdouble}, Ptr{Cdouble}, UInt32, Ptr{UInt32}), boundary, request, first, ball,
          d_centre, d_radius, capacity, needed)
end

function hsp_moving_limits_init(limits, struct_size, balls)
    ccall((:hsp_moving_limits_init, libhardsphere), Int32, (Ptr{hsp_moving_limits}, UInt32, UInt32), limits,
          struct_size, balls)
end

function hsp_moving_bytes(limits, bytes)
    ccall((:hsp_moving_bytes, libhardsphere), Int32, (Ptr{hsp_moving_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_moving_init(memory, bytes, limits, moving)
    ccall((:hsp_moving_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_moving_limits},
          Ptr{Ptr{hsp_moving}}), memory, bytes, limits, moving)
end

function hsp_moving_set(moving, model, sigma, tension, pressure, tangency, limits, first_bad)
    ccall((:hsp_moving_set, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_model}, Ptr{Cdouble}, Cdouble, Cdouble,
          UInt32, Ptr{hsp_moving_limits}, Ptr{UInt32}), moving, model, sigma, tension, pressure, tangency, limits,
          first_bad)
end

function hsp_moving_set_with(moving, model, request, limits, first_bad)
    ccall((:hsp_moving_set_with, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_model}, Ptr{hsp_gradient_request},
          Ptr{hsp_moving_limits}, Ptr{UInt32}), moving, model, request, limits, first_bad)
end

function hsp_moving_move(moving, count, ball, xyz, radius, limits, first_bad)
    ccall((:hsp_moving_move, libhardsphere), Int32, (Ptr{hsp_moving}, UInt32, Ptr{UInt32}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{hsp_moving_limits}, Ptr{UInt32}), moving, count, ball, xyz, radius, limits, first_bad)
end

function hsp_moving_move_with(moving, count, ball, xyz, radius, request, limits, first_bad)
    ccall((:hsp_moving_move_with, libhardsphere), Int32, (Ptr{hsp_moving}, UInt32, Ptr{UInt32}, Ptr{Cdouble},
          Ptr{Cdouble}, Ptr{hsp_moving_request}, Ptr{hsp_moving_limits}, Ptr{UInt32}), moving, count, ball, xyz,
          radius, request, limits, first_bad)
end

function hsp_moving_undo(moving)
    ccall((:hsp_moving_undo, libhardsphere), Int32, (Ptr{hsp_moving},), moving)
end

function hsp_moving_get_info(moving, info)
    ccall((:hsp_moving_get_info, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_moving_info}), moving, info)
end

function hsp_moving_measure(moving, totals, area, volume_term, capacity, needed)
    ccall((:hsp_moving_measure, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_totals}, Ptr{Cdouble}, Ptr{Cdouble},
          UInt32, Ptr{UInt32}), moving, totals, area, volume_term, capacity, needed)
end

function hsp_moving_gradient(moving, energy, d_centre, d_radius, flags, capacity, needed)
    ccall((:hsp_moving_gradient, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_energy}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), moving, energy, d_centre, d_radius, flags, capacity, needed)
end

function hsp_moving_get_balls(moving, count, ball, out)
    ccall((:hsp_moving_get_balls, libhardsphere), Int32, (Ptr{hsp_moving}, UInt32, Ptr{UInt32}, Ptr{hsp_moving_ball}),
          moving, count, ball, out)
end

function hsp_moving_get_changed(moving, balls, capacity, needed)
    ccall((:hsp_moving_get_changed, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{UInt32}, UInt32, Ptr{UInt32}), moving,
          balls, capacity, needed)
end

function hsp_moving_get_model(moving, model)
    ccall((:hsp_moving_get_model, libhardsphere), Int32, (Ptr{hsp_moving}, Ptr{hsp_model}), moving, model)
end

function hsp_boundary_curvature(boundary, totals, mean, gauss_thirds, capacity, needed)
    ccall((:hsp_boundary_curvature, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_curvatures}, Ptr{Cdouble},
          Ptr{Int32}, UInt32, Ptr{UInt32}), boundary, totals, mean, gauss_thirds, capacity, needed)
end

function hsp_boundary_curvature_with(boundary, request, totals, mean, gauss_thirds, capacity, needed)
    ccall((:hsp_boundary_curvature_with, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_curvature_request},
          Ptr{hsp_curvatures}, Ptr{Cdouble}, Ptr{Int32}, UInt32, Ptr{UInt32}), boundary, request, totals, mean,
          gauss_thirds, capacity, needed)
end

function hsp_boundary_get_morphometry(boundary, request, outputs)
    ccall((:hsp_boundary_get_morphometry, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_morphometry_request},
          Ptr{hsp_morphometry_outputs}), boundary, request, outputs)
end

function hsp_boundary_get_hessian_rows(boundary, request, first, ball, block, flags, capacity, needed)
    ccall((:hsp_boundary_get_hessian_rows, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_gradient_request},
          Ptr{UInt32}, Ptr{UInt32}, Ptr{Cdouble}, Ptr{UInt32}, UInt32, Ptr{UInt32}), boundary, request, first, ball,
          block, flags, capacity, needed)
end

function hsp_boundary_get_hessian_product(boundary, request, direction, product, flags, capacity, needed)
    ccall((:hsp_boundary_get_hessian_product, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_gradient_request},
          Ptr{Cdouble}, Ptr{Cdouble}, Ptr{UInt32}, UInt32, Ptr{UInt32}), boundary, request, direction, product, flags,
          capacity, needed)
end

function hsp_brick_summarise(boundary, request, summary, bytes, first_bad)
    ccall((:hsp_brick_summarise, libhardsphere), Int32, (Ptr{hsp_boundary}, Ptr{hsp_brick_request}, Ptr{Cvoid},
          Ptr{Csize_t}, Ptr{UInt32}), boundary, request, summary, bytes, first_bad)
end

function hsp_brick_merge(a, a_bytes, b, b_bytes, executor, summary, bytes, brick)
    ccall((:hsp_brick_merge, libhardsphere), Int32, (Ptr{UInt8}, Csize_t, Ptr{UInt8}, Csize_t, Ptr{hsp_executor},
          Ptr{Cvoid}, Ptr{Csize_t}, Ptr{UInt32}), a, a_bytes, b, b_bytes, executor, summary, bytes, brick)
end

function hsp_brick_get_totals(summary, bytes, totals, brick)
    ccall((:hsp_brick_get_totals, libhardsphere), Int32, (Ptr{UInt8}, Csize_t, Ptr{hsp_brick_totals}, Ptr{UInt32}),
          summary, bytes, totals, brick)
end

function hsp_brick_get_shells(summary, bytes, out, capacity, needed, brick)
    ccall((:hsp_brick_get_shells, libhardsphere), Int32, (Ptr{UInt8}, Csize_t, Ptr{hsp_brick_shell}, UInt32,
          Ptr{UInt32}, Ptr{UInt32}), summary, bytes, out, capacity, needed, brick)
end

function hsp_contacts_limits_init(limits, struct_size, boundary)
    ccall((:hsp_contacts_limits_init, libhardsphere), Int32, (Ptr{hsp_contacts_limits}, UInt32, Ptr{hsp_boundary}),
          limits, struct_size, boundary)
end

function hsp_contacts_bytes(limits, bytes)
    ccall((:hsp_contacts_bytes, libhardsphere), Int32, (Ptr{hsp_contacts_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_contacts_init(memory, bytes, limits, contacts)
    ccall((:hsp_contacts_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_contacts_limits},
          Ptr{Ptr{hsp_contacts}}), memory, bytes, limits, contacts)
end

function hsp_contacts_compute(contacts, boundary, limits)
    ccall((:hsp_contacts_compute, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{hsp_boundary},
          Ptr{hsp_contacts_limits}), contacts, boundary, limits)
end

function hsp_contacts_compute_with(contacts, boundary, request, limits)
    ccall((:hsp_contacts_compute_with, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{hsp_boundary},
          Ptr{hsp_contacts_request}, Ptr{hsp_contacts_limits}), contacts, boundary, request, limits)
end

function hsp_contacts_get_pairs(contacts, out, capacity, needed)
    ccall((:hsp_contacts_get_pairs, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{hsp_contact}, UInt32, Ptr{UInt32}),
          contacts, out, capacity, needed)
end

function hsp_contacts_get_row(contacts, ball, out, capacity, needed)
    ccall((:hsp_contacts_get_row, libhardsphere), Int32, (Ptr{hsp_contacts}, UInt32, Ptr{hsp_contact}, UInt32,
          Ptr{UInt32}), contacts, ball, out, capacity, needed)
end

function hsp_contacts_measure(contacts, totals, share_volume, contact_area, capacity, needed)
    ccall((:hsp_contacts_measure, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{hsp_totals}, Ptr{Cdouble},
          Ptr{Cdouble}, UInt32, Ptr{UInt32}), contacts, totals, share_volume, contact_area, capacity, needed)
end

function hsp_contacts_group(contacts, group, out, capacity, needed)
    ccall((:hsp_contacts_group, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{UInt32}, Ptr{hsp_group_contact}, UInt32,
          Ptr{UInt32}), contacts, group, out, capacity, needed)
end

function hsp_contacts_get_complex(contacts, counts)
    ccall((:hsp_contacts_get_complex, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{hsp_complex}), contacts, counts)
end

function hsp_contacts_get_simplices(contacts, dimension, out, capacity, needed)
    ccall((:hsp_contacts_get_simplices, libhardsphere), Int32, (Ptr{hsp_contacts}, UInt32, Ptr{hsp_simplex}, UInt32,
          Ptr{UInt32}), contacts, dimension, out, capacity, needed)
end

function hsp_contacts_check(contacts, invariant, id)
    ccall((:hsp_contacts_check, libhardsphere), Int32, (Ptr{hsp_contacts}, Ptr{UInt32}, Ptr{UInt32}), contacts,
          invariant, id)
end

function hsp_periodic_limits_init(limits, struct_size, balls)
    ccall((:hsp_periodic_limits_init, libhardsphere), Int32, (Ptr{hsp_periodic_limits}, UInt32, UInt32), limits,
          struct_size, balls)
end

function hsp_periodic_bytes(limits, bytes)
    ccall((:hsp_periodic_bytes, libhardsphere), Int32, (Ptr{hsp_periodic_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_periodic_init(memory, bytes, limits, periodic)
    ccall((:hsp_periodic_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_periodic_limits},
          Ptr{Ptr{hsp_periodic}}), memory, bytes, limits, periodic)
end

function hsp_periodic_compute(periodic, n, xyz, radius, box, options, limits, first_bad)
    ccall((:hsp_periodic_compute, libhardsphere), Int32, (Ptr{hsp_periodic}, UInt32, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{Cdouble}, Ptr{hsp_model_options}, Ptr{hsp_periodic_limits}, Ptr{UInt32}), periodic, n, xyz, radius, box,
          options, limits, first_bad)
end

function hsp_periodic_compute_with(periodic, n, xyz, radius, box, request, limits, first_bad)
    ccall((:hsp_periodic_compute_with, libhardsphere), Int32, (Ptr{hsp_periodic}, UInt32, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{Cdouble}, Ptr{hsp_periodic_request}, Ptr{hsp_periodic_limits}, Ptr{UInt32}), periodic, n, xyz, radius,
          box, request, limits, first_bad)
end

function hsp_periodic_get_counts(periodic, counts)
    ccall((:hsp_periodic_get_counts, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_counts}), periodic,
          counts)
end

function hsp_periodic_measure(periodic, totals, area, share_volume, capacity, needed)
    ccall((:hsp_periodic_measure, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_totals}, Ptr{Cdouble},
          Ptr{Cdouble}, UInt32, Ptr{UInt32}), periodic, totals, area, share_volume, capacity, needed)
end

function hsp_periodic_curvature(periodic, totals, mean, gauss_thirds, capacity, needed)
    ccall((:hsp_periodic_curvature, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_curvatures}, Ptr{Cdouble},
          Ptr{Int32}, UInt32, Ptr{UInt32}), periodic, totals, mean, gauss_thirds, capacity, needed)
end

function hsp_periodic_get_morphometry(periodic, request, outputs)
    ccall((:hsp_periodic_get_morphometry, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_morphometry_request},
          Ptr{hsp_periodic_morphometry_outputs}), periodic, request, outputs)
end

function hsp_periodic_get_contacts(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_contacts, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_contact}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_group_contacts(periodic, group, out, capacity, needed)
    ccall((:hsp_periodic_group_contacts, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{UInt32},
          Ptr{hsp_group_contact}, UInt32, Ptr{UInt32}), periodic, group, out, capacity, needed)
end

function hsp_periodic_get_windings(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_windings, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_winding}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_components(periodic, component, capacity, needed)
    ccall((:hsp_periodic_get_components, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{UInt32}, UInt32, Ptr{UInt32}),
          periodic, component, capacity, needed)
end

function hsp_periodic_get_gradient(periodic, request, outputs)
    ccall((:hsp_periodic_get_gradient, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_gradient_request},
          Ptr{hsp_periodic_gradient_outputs}), periodic, request, outputs)
end

function hsp_periodic_get_hessian_rows(periodic, request, first, ball, block, flags, capacity, needed)
    ccall((:hsp_periodic_get_hessian_rows, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_gradient_request},
          Ptr{UInt32}, Ptr{UInt32}, Ptr{Cdouble}, Ptr{UInt32}, UInt32, Ptr{UInt32}), periodic, request, first, ball,
          block, flags, capacity, needed)
end

function hsp_periodic_query_point(periodic, xyz, out, capacity, needed)
    ccall((:hsp_periodic_query_point, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{Cdouble}, Ptr{hsp_image}, UInt32,
          Ptr{UInt32}), periodic, xyz, out, capacity, needed)
end

function hsp_periodic_query_ball(periodic, xyz, radius, out, capacity, needed)
    ccall((:hsp_periodic_query_ball, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{Cdouble}, Cdouble, Ptr{hsp_image},
          UInt32, Ptr{UInt32}), periodic, xyz, radius, out, capacity, needed)
end

function hsp_periodic_query_neighbours(periodic, ball, out, capacity, needed)
    ccall((:hsp_periodic_query_neighbours, libhardsphere), Int32, (Ptr{hsp_periodic}, UInt32, Ptr{hsp_image}, UInt32,
          Ptr{UInt32}), periodic, ball, out, capacity, needed)
end

function hsp_periodic_query_pairs(periodic, flags, first, out, capacity, needed)
    ccall((:hsp_periodic_query_pairs, libhardsphere), Int32, (Ptr{hsp_periodic}, UInt32, Ptr{UInt32}, Ptr{hsp_image},
          UInt32, Ptr{UInt32}), periodic, flags, first, out, capacity, needed)
end

function hsp_periodic_check(periodic, invariant, id)
    ccall((:hsp_periodic_check, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{UInt32}, Ptr{UInt32}), periodic,
          invariant, id)
end

function hsp_periodic_get_vertices(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_vertices, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_vertex}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_arcs(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_arcs, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_arc}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_circles(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_circles, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_circle}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_faces(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_faces, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_face}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_loops(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_loops, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_loop}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_loop_arcs(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_loop_arcs, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_periodic_loop_arc}, UInt32,
          Ptr{UInt32}), periodic, out, capacity, needed)
end

function hsp_periodic_get_balls(periodic, out, capacity, needed)
    ccall((:hsp_periodic_get_balls, libhardsphere), Int32, (Ptr{hsp_periodic}, Ptr{hsp_ball}, UInt32, Ptr{UInt32}),
          periodic, out, capacity, needed)
end

function hsp_surface_limits_init(limits, struct_size, boundary)
    ccall((:hsp_surface_limits_init, libhardsphere), Int32, (Ptr{hsp_surface_limits}, UInt32, Ptr{hsp_boundary}),
          limits, struct_size, boundary)
end

function hsp_surface_bytes(limits, bytes)
    ccall((:hsp_surface_bytes, libhardsphere), Int32, (Ptr{hsp_surface_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_surface_init(memory, bytes, limits, surface)
    ccall((:hsp_surface_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_surface_limits},
          Ptr{Ptr{hsp_surface}}), memory, bytes, limits, surface)
end

function hsp_surface_compute(surface, boundary, limits)
    ccall((:hsp_surface_compute, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_boundary}, Ptr{hsp_surface_limits}),
          surface, boundary, limits)
end

function hsp_surface_compute_shells(surface, boundary, shells, count, limits)
    ccall((:hsp_surface_compute_shells, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_boundary}, Ptr{UInt32},
          UInt32, Ptr{hsp_surface_limits}), surface, boundary, shells, count, limits)
end

function hsp_surface_compute_with(surface, boundary, request, limits)
    ccall((:hsp_surface_compute_with, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_boundary},
          Ptr{hsp_surface_request}, Ptr{hsp_surface_limits}), surface, boundary, request, limits)
end

function hsp_surface_get_counts(surface, counts)
    ccall((:hsp_surface_get_counts, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_surface_counts}), surface, counts)
end

function hsp_surface_measure(surface, totals, balls, capacity, needed)
    ccall((:hsp_surface_measure, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_surface_totals},
          Ptr{hsp_surface_totals}, UInt32, Ptr{UInt32}), surface, totals, balls, capacity, needed)
end

function hsp_surface_measure_with(surface, request, totals, balls, capacity, needed)
    ccall((:hsp_surface_measure_with, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_surface_measure_request},
          Ptr{hsp_surface_totals}, Ptr{hsp_surface_totals}, UInt32, Ptr{UInt32}), surface, request, totals, balls,
          capacity, needed)
end

function hsp_surface_get_gradient(surface, request, outputs)
    ccall((:hsp_surface_get_gradient, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_gradient_request},
          Ptr{hsp_gradient_outputs}), surface, request, outputs)
end

function hsp_surface_get_part_counts(surface, counts)
    ccall((:hsp_surface_get_part_counts, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_surface_part_counts}),
          surface, counts)
end

function hsp_surface_next(surface, h)
    ccall((:hsp_surface_next, libhardsphere), UInt32, (Ptr{hsp_surface}, UInt32), surface, h)
end

function hsp_surface_previous(surface, h)
    ccall((:hsp_surface_previous, libhardsphere), UInt32, (Ptr{hsp_surface}, UInt32), surface, h)
end

function hsp_surface_next_loop(surface, h)
    ccall((:hsp_surface_next_loop, libhardsphere), UInt32, (Ptr{hsp_surface}, UInt32), surface, h)
end

function hsp_surface_origin(surface, h)
    ccall((:hsp_surface_origin, libhardsphere), UInt32, (Ptr{hsp_surface}, UInt32), surface, h)
end

function hsp_surface_left(surface, h)
    ccall((:hsp_surface_left, libhardsphere), UInt32, (Ptr{hsp_surface}, UInt32), surface, h)
end

function hsp_surface_get_patches(surface, first, count, out)
    ccall((:hsp_surface_get_patches, libhardsphere), Int32, (Ptr{hsp_surface}, UInt32, UInt32, Ptr{hsp_surface_patch}),
          surface, first, count, out)
end

function hsp_surface_get_edges(surface, first, count, out)
    ccall((:hsp_surface_get_edges, libhardsphere), Int32, (Ptr{hsp_surface}, UInt32, UInt32, Ptr{hsp_surface_edge}),
          surface, first, count, out)
end

function hsp_surface_get_corners(surface, first, count, out)
    ccall((:hsp_surface_get_corners, libhardsphere), Int32, (Ptr{hsp_surface}, UInt32, UInt32,
          Ptr{hsp_surface_corner}), surface, first, count, out)
end

function hsp_surface_get_shells(surface, out, capacity, needed)
    ccall((:hsp_surface_get_shells, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{hsp_surface_shell}, UInt32,
          Ptr{UInt32}), surface, out, capacity, needed)
end

function hsp_surface_check(surface, invariant, id)
    ccall((:hsp_surface_check, libhardsphere), Int32, (Ptr{hsp_surface}, Ptr{UInt32}, Ptr{UInt32}), surface, invariant,
          id)
end

function hsp_mesh_limits_init(limits, struct_size, boundary, edge_length)
    ccall((:hsp_mesh_limits_init, libhardsphere), Int32, (Ptr{hsp_mesh_limits}, UInt32, Ptr{hsp_boundary}, Cdouble),
          limits, struct_size, boundary, edge_length)
end

function hsp_mesh_limits_init_surface(limits, struct_size, surface, edge_length)
    ccall((:hsp_mesh_limits_init_surface, libhardsphere), Int32, (Ptr{hsp_mesh_limits}, UInt32, Ptr{hsp_surface},
          Cdouble), limits, struct_size, surface, edge_length)
end

function hsp_mesh_bytes(limits, bytes)
    ccall((:hsp_mesh_bytes, libhardsphere), Int32, (Ptr{hsp_mesh_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_mesh_init(memory, bytes, limits, mesh)
    ccall((:hsp_mesh_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_mesh_limits}, Ptr{Ptr{hsp_mesh}}),
          memory, bytes, limits, mesh)
end

function hsp_mesh_compute(mesh, boundary, edge_length, limits)
    ccall((:hsp_mesh_compute, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{hsp_boundary}, Cdouble, Ptr{hsp_mesh_limits}),
          mesh, boundary, edge_length, limits)
end

function hsp_mesh_compute_surface(mesh, surface, edge_length, limits)
    ccall((:hsp_mesh_compute_surface, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{hsp_surface}, Cdouble,
          Ptr{hsp_mesh_limits}), mesh, surface, edge_length, limits)
end

function hsp_mesh_compute_with(mesh, boundary, edge_length, request, limits)
    ccall((:hsp_mesh_compute_with, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{hsp_boundary}, Cdouble,
          Ptr{hsp_mesh_request}, Ptr{hsp_mesh_limits}), mesh, boundary, edge_length, request, limits)
end

function hsp_mesh_compute_surface_with(mesh, surface, edge_length, request, limits)
    ccall((:hsp_mesh_compute_surface_with, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{hsp_surface}, Cdouble,
          Ptr{hsp_mesh_request}, Ptr{hsp_mesh_limits}), mesh, surface, edge_length, request, limits)
end

function hsp_mesh_get_counts(mesh, counts)
    ccall((:hsp_mesh_get_counts, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{hsp_mesh_counts}), mesh, counts)
end

function hsp_mesh_get_vertices(mesh, xyz, normals, areas, balls, capacity, needed)
    ccall((:hsp_mesh_get_vertices, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), mesh, xyz, normals, areas, balls, capacity, needed)
end

function hsp_mesh_get_weights(mesh, area, patches, weights, capacity, needed)
    ccall((:hsp_mesh_get_weights, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{Cdouble}, UInt32, Ptr{Cdouble}, UInt32,
          Ptr{UInt32}), mesh, area, patches, weights, capacity, needed)
end

function hsp_mesh_get_triangles(mesh, corners, kinds, patches, balls, capacity, needed)
    ccall((:hsp_mesh_get_triangles, libhardsphere), Int32, (Ptr{hsp_mesh}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), mesh, corners, kinds, patches, balls, capacity, needed)
end

function hsp_mesh_get_patch(mesh, patch, first, count)
    ccall((:hsp_mesh_get_patch, libhardsphere), Int32, (Ptr{hsp_mesh}, UInt32, Ptr{UInt32}, Ptr{UInt32}), mesh, patch,
          first, count)
end

function hsp_topology_limits_init(limits, struct_size, boundary)
    ccall((:hsp_topology_limits_init, libhardsphere), Int32, (Ptr{hsp_topology_limits}, UInt32, Ptr{hsp_boundary}),
          limits, struct_size, boundary)
end

function hsp_topology_bytes(limits, bytes)
    ccall((:hsp_topology_bytes, libhardsphere), Int32, (Ptr{hsp_topology_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_topology_init(memory, bytes, limits, topology)
    ccall((:hsp_topology_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_topology_limits},
          Ptr{Ptr{hsp_topology}}), memory, bytes, limits, topology)
end

function hsp_topology_compute(topology, boundary, limits)
    ccall((:hsp_topology_compute, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_boundary},
          Ptr{hsp_topology_limits}), topology, boundary, limits)
end

function hsp_topology_compute_with(topology, boundary, request, limits)
    ccall((:hsp_topology_compute_with, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_boundary},
          Ptr{hsp_topology_request}, Ptr{hsp_topology_limits}), topology, boundary, request, limits)
end

function hsp_topology_get_counts(topology, counts)
    ccall((:hsp_topology_get_counts, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_topology_counts}), topology,
          counts)
end

function hsp_topology_get_shells(topology, out, capacity, needed)
    ccall((:hsp_topology_get_shells, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_shell}, UInt32, Ptr{UInt32}),
          topology, out, capacity, needed)
end

function hsp_topology_get_components(topology, out, capacity, needed)
    ccall((:hsp_topology_get_components, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_component}, UInt32,
          Ptr{UInt32}), topology, out, capacity, needed)
end

function hsp_topology_get_regions(topology, out, capacity, needed)
    ccall((:hsp_topology_get_regions, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{hsp_region}, UInt32, Ptr{UInt32}),
          topology, out, capacity, needed)
end

function hsp_topology_get_region_shells(topology, region, shells, capacity, needed)
    ccall((:hsp_topology_get_region_shells, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), topology, region, shells, capacity, needed)
end

function hsp_topology_get_region_balls(topology, region, balls, capacity, needed)
    ccall((:hsp_topology_get_region_balls, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), topology, region, balls, capacity, needed)
end

function hsp_topology_locate(topology, xyz, region)
    ccall((:hsp_topology_locate, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{Cdouble}, Ptr{UInt32}), topology, xyz,
          region)
end

function hsp_topology_onext(topology, q)
    ccall((:hsp_topology_onext, libhardsphere), UInt32, (Ptr{hsp_topology}, UInt32), topology, q)
end

function hsp_topology_lnext(topology, q)
    ccall((:hsp_topology_lnext, libhardsphere), UInt32, (Ptr{hsp_topology}, UInt32), topology, q)
end

function hsp_topology_origin(topology, q)
    ccall((:hsp_topology_origin, libhardsphere), UInt32, (Ptr{hsp_topology}, UInt32), topology, q)
end

function hsp_topology_left(topology, q)
    ccall((:hsp_topology_left, libhardsphere), UInt32, (Ptr{hsp_topology}, UInt32), topology, q)
end

function hsp_topology_get_quad_edges(topology, first, count, onext, origin)
    ccall((:hsp_topology_get_quad_edges, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, UInt32, Ptr{UInt32},
          Ptr{UInt32}), topology, first, count, onext, origin)
end

function hsp_topology_get_vertices(topology, first, count, out)
    ccall((:hsp_topology_get_vertices, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, UInt32,
          Ptr{hsp_topology_vertex}), topology, first, count, out)
end

function hsp_topology_get_edges(topology, first, count, out)
    ccall((:hsp_topology_get_edges, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, UInt32, Ptr{hsp_topology_edge}),
          topology, first, count, out)
end

function hsp_topology_get_simple_faces(topology, first, count, out)
    ccall((:hsp_topology_get_simple_faces, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, UInt32,
          Ptr{hsp_simple_face}), topology, first, count, out)
end

function hsp_topology_get_traversal(topology, shell, faces, capacity, needed)
    ccall((:hsp_topology_get_traversal, libhardsphere), Int32, (Ptr{hsp_topology}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), topology, shell, faces, capacity, needed)
end

function hsp_topology_check(topology, invariant, id)
    ccall((:hsp_topology_check, libhardsphere), Int32, (Ptr{hsp_topology}, Ptr{UInt32}, Ptr{UInt32}), topology,
          invariant, id)
end

function hsp_cells_limits_init(limits, struct_size, balls)
    ccall((:hsp_cells_limits_init, libhardsphere), Int32, (Ptr{hsp_cells_limits}, UInt32, UInt32), limits, struct_size,
          balls)
end

function hsp_cells_bytes(limits, bytes)
    ccall((:hsp_cells_bytes, libhardsphere), Int32, (Ptr{hsp_cells_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_cells_init(memory, bytes, limits, cells)
    ccall((:hsp_cells_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_cells_limits}, Ptr{Ptr{hsp_cells}}),
          memory, bytes, limits, cells)
end

function hsp_cells_compute(cells, model, limits)
    ccall((:hsp_cells_compute, libhardsphere), Int32, (Ptr{hsp_cells}, Ptr{hsp_model}, Ptr{hsp_cells_limits}), cells,
          model, limits)
end

function hsp_cells_compute_with(cells, model, request, limits)
    ccall((:hsp_cells_compute_with, libhardsphere), Int32, (Ptr{hsp_cells}, Ptr{hsp_model}, Ptr{hsp_cells_request},
          Ptr{hsp_cells_limits}), cells, model, request, limits)
end

function hsp_cells_get_counts(cells, counts)
    ccall((:hsp_cells_get_counts, libhardsphere), Int32, (Ptr{hsp_cells}, Ptr{hsp_cells_counts}), cells, counts)
end

function hsp_cells_get_cells(cells, first, count, out)
    ccall((:hsp_cells_get_cells, libhardsphere), Int32, (Ptr{hsp_cells}, UInt32, UInt32, Ptr{hsp_free_cell}), cells,
          first, count, out)
end

function hsp_cells_get_neighbours(cells, cell, neighbours, capacity, needed)
    ccall((:hsp_cells_get_neighbours, libhardsphere), Int32, (Ptr{hsp_cells}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), cells, cell, neighbours, capacity, needed)
end

function hsp_cells_get_pairs(cells, first, count, out)
    ccall((:hsp_cells_get_pairs, libhardsphere), Int32, (Ptr{hsp_cells}, UInt32, UInt32, Ptr{hsp_cell_pair}), cells,
          first, count, out)
end

function hsp_cells_locate(cells, xyz, cell)
    ccall((:hsp_cells_locate, libhardsphere), Int32, (Ptr{hsp_cells}, Ptr{Cdouble}, Ptr{UInt32}), cells, xyz, cell)
end

function hsp_cells_check(cells, topology, invariant, id)
    ccall((:hsp_cells_check, libhardsphere), Int32, (Ptr{hsp_cells}, Ptr{hsp_topology}, Ptr{UInt32}, Ptr{UInt32}),
          cells, topology, invariant, id)
end

function hsp_model_arrangement(model, totals, of_ball, scratch, words, words_needed)
    ccall((:hsp_model_arrangement, libhardsphere), Int32, (Ptr{hsp_model}, Ptr{hsp_arrangement}, Ptr{hsp_arrangement},
          Ptr{UInt32}, UInt32, Ptr{UInt32}), model, totals, of_ball, scratch, words, words_needed)
end

function hsp_paths_limits_init(limits, struct_size, balls)
    ccall((:hsp_paths_limits_init, libhardsphere), Int32, (Ptr{hsp_paths_limits}, UInt32, UInt32), limits, struct_size,
          balls)
end

function hsp_paths_bytes(limits, bytes)
    ccall((:hsp_paths_bytes, libhardsphere), Int32, (Ptr{hsp_paths_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_paths_init(memory, bytes, limits, paths)
    ccall((:hsp_paths_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_paths_limits}, Ptr{Ptr{hsp_paths}}),
          memory, bytes, limits, paths)
end

function hsp_paths_compute(paths, model, limits)
    ccall((:hsp_paths_compute, libhardsphere), Int32, (Ptr{hsp_paths}, Ptr{hsp_model}, Ptr{hsp_paths_limits}), paths,
          model, limits)
end

function hsp_paths_compute_with(paths, model, request, limits)
    ccall((:hsp_paths_compute_with, libhardsphere), Int32, (Ptr{hsp_paths}, Ptr{hsp_model}, Ptr{hsp_paths_request},
          Ptr{hsp_paths_limits}), paths, model, request, limits)
end

function hsp_paths_find(paths, from, to, path, limits)
    ccall((:hsp_paths_find, libhardsphere), Int32, (Ptr{hsp_paths}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{hsp_path},
          Ptr{hsp_paths_limits}), paths, from, to, path, limits)
end

function hsp_paths_find_with(paths, from, to, request, path, limits)
    ccall((:hsp_paths_find_with, libhardsphere), Int32, (Ptr{hsp_paths}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{hsp_paths_request}, Ptr{hsp_path}, Ptr{hsp_paths_limits}), paths, from, to, request, path, limits)
end

function hsp_paths_get_points(paths, points, capacity, needed)
    ccall((:hsp_paths_get_points, libhardsphere), Int32, (Ptr{hsp_paths}, Ptr{Cdouble}, UInt32, Ptr{UInt32}), paths,
          points, capacity, needed)
end

function hsp_pores_limits_init(limits, struct_size, balls)
    ccall((:hsp_pores_limits_init, libhardsphere), Int32, (Ptr{hsp_pores_limits}, UInt32, UInt32), limits, struct_size,
          balls)
end

function hsp_pores_bytes(limits, bytes)
    ccall((:hsp_pores_bytes, libhardsphere), Int32, (Ptr{hsp_pores_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_pores_init(memory, bytes, limits, pores)
    ccall((:hsp_pores_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_pores_limits}, Ptr{Ptr{hsp_pores}}),
          memory, bytes, limits, pores)
end

function hsp_pores_options_init(options, struct_size)
    ccall((:hsp_pores_options_init, libhardsphere), Int32, (Ptr{hsp_pores_options}, UInt32), options, struct_size)
end

function hsp_pores_compute(pores, model, options, limits)
    ccall((:hsp_pores_compute, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_model}, Ptr{hsp_pores_options},
          Ptr{hsp_pores_limits}), pores, model, options, limits)
end

function hsp_pores_compute_periodic(pores, periodic, options, limits)
    ccall((:hsp_pores_compute_periodic, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_periodic},
          Ptr{hsp_pores_options}, Ptr{hsp_pores_limits}), pores, periodic, options, limits)
end

function hsp_pores_get_counts(pores, counts)
    ccall((:hsp_pores_get_counts, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_pores_counts}), pores, counts)
end

function hsp_pores_get_maxima(pores, first, count, out)
    ccall((:hsp_pores_get_maxima, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32, Ptr{hsp_pore_maximum}),
          pores, first, count, out)
end

function hsp_pores_get_gates(pores, first, count, out)
    ccall((:hsp_pores_get_gates, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32, Ptr{hsp_pore_gate}), pores,
          first, count, out)
end

function hsp_pores_get_gate_shifts(pores, first, count, out)
    ccall((:hsp_pores_get_gate_shifts, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32,
          Ptr{hsp_pore_gate_shifts}), pores, first, count, out)
end

function hsp_pores_get_maximum_balls(pores, maximum, balls, capacity, needed)
    ccall((:hsp_pores_get_maximum_balls, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), pores, maximum, balls, capacity, needed)
end

function hsp_pores_get_gate_balls(pores, gate, balls, capacity, needed)
    ccall((:hsp_pores_get_gate_balls, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), pores, gate, balls, capacity, needed)
end

function hsp_pores_get_maximum_images(pores, maximum, images, capacity, needed)
    ccall((:hsp_pores_get_maximum_images, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{hsp_image}, UInt32,
          Ptr{UInt32}), pores, maximum, images, capacity, needed)
end

function hsp_pores_get_gate_images(pores, gate, images, capacity, needed)
    ccall((:hsp_pores_get_gate_images, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{hsp_image}, UInt32,
          Ptr{UInt32}), pores, gate, images, capacity, needed)
end

function hsp_pores_get_percolation(pores, percolation)
    ccall((:hsp_pores_get_percolation, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_pore_percolation}), pores,
          percolation)
end

function hsp_pores_get_channels(pores, radius, out, capacity, needed)
    ccall((:hsp_pores_get_channels, libhardsphere), Int32, (Ptr{hsp_pores}, Cdouble, Ptr{hsp_pore_channel}, UInt32,
          Ptr{UInt32}), pores, radius, out, capacity, needed)
end

function hsp_pores_class_at(pores, maximum, radius, member)
    ccall((:hsp_pores_class_at, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Cdouble, Ptr{UInt32}), pores, maximum,
          radius, member)
end

function hsp_pores_gate_between(pores, maximum, other, gate)
    ccall((:hsp_pores_gate_between, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32, Ptr{UInt32}), pores,
          maximum, other, gate)
end

function hsp_pores_locate(pores, xyz, place)
    ccall((:hsp_pores_locate, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{hsp_pore_place}), pores, xyz,
          place)
end

function hsp_pores_locate_with_shifts(pores, xyz, place, shifts)
    ccall((:hsp_pores_locate_with_shifts, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{hsp_pore_place},
          Ptr{hsp_pore_place_shifts}), pores, xyz, place, shifts)
end

function hsp_pores_widest(pores, from, to, passage)
    ccall((:hsp_pores_widest, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{hsp_pore_passage}), pores, from, to, passage)
end

function hsp_pores_find_tunnel(pores, from, to, avoided, count, tunnel, limits)
    ccall((:hsp_pores_find_tunnel, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{UInt32},
          UInt32, Ptr{hsp_tunnel}, Ptr{hsp_pores_limits}), pores, from, to, avoided, count, tunnel, limits)
end

function hsp_pores_find_cheapest_tunnel(pores, from, to, avoided, count, tunnel, limits)
    ccall((:hsp_pores_find_cheapest_tunnel, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{UInt32}, UInt32, Ptr{hsp_tunnel}, Ptr{hsp_pores_limits}), pores, from, to, avoided, count, tunnel, limits)
end

function hsp_pores_find_tunnel_with(pores, from, to, avoided, count, request, tunnel, limits)
    ccall((:hsp_pores_find_tunnel_with, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{Cdouble},
          Ptr{UInt32}, UInt32, Ptr{hsp_tunnel_request}, Ptr{hsp_tunnel}, Ptr{hsp_pores_limits}), pores, from, to,
          avoided, count, request, tunnel, limits)
end

function hsp_pores_get_tunnel_route(pores, route)
    ccall((:hsp_pores_get_tunnel_route, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_tunnel_route}), pores, route)
end

function hsp_pores_get_tunnel_points(pores, points, capacity, needed)
    ccall((:hsp_pores_get_tunnel_points, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_tunnel_point}, UInt32,
          Ptr{UInt32}), pores, points, capacity, needed)
end

function hsp_pores_get_tunnel_point_shifts(pores, points, capacity, needed)
    ccall((:hsp_pores_get_tunnel_point_shifts, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_tunnel_point_shifts},
          UInt32, Ptr{UInt32}), pores, points, capacity, needed)
end

function hsp_pores_find_pockets(pores, narrow, wide, pockets)
    ccall((:hsp_pores_find_pockets, libhardsphere), Int32, (Ptr{hsp_pores}, Cdouble, Cdouble, Ptr{UInt32}), pores,
          narrow, wide, pockets)
end

function hsp_pores_get_pockets(pores, first, count, out)
    ccall((:hsp_pores_get_pockets, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32, Ptr{hsp_pore_pocket}),
          pores, first, count, out)
end

function hsp_pores_get_pocket_maxima(pores, pocket, maxima, capacity, needed)
    ccall((:hsp_pores_get_pocket_maxima, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), pores, pocket, maxima, capacity, needed)
end

function hsp_pores_get_pocket_mouths(pores, pocket, gates, capacity, needed)
    ccall((:hsp_pores_get_pocket_mouths, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), pores, pocket, gates, capacity, needed)
end

function hsp_pores_get_pocket_balls(pores, pocket, balls, capacity, needed)
    ccall((:hsp_pores_get_pocket_balls, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, Ptr{UInt32}, UInt32,
          Ptr{UInt32}), pores, pocket, balls, capacity, needed)
end

function hsp_pores_get_plugged_balls(pores, xyz, radius, capacity, needed)
    ccall((:hsp_pores_get_plugged_balls, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{Cdouble}, Ptr{Cdouble}, UInt32,
          Ptr{UInt32}), pores, xyz, radius, capacity, needed)
end

function hsp_pores_find_regions(pores, boundary, access, regions)
    ccall((:hsp_pores_find_regions, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_boundary}, Ptr{hsp_pore_access},
          Ptr{UInt32}), pores, boundary, access, regions)
end

function hsp_pores_find_regions_with(pores, boundary, request, access, regions)
    ccall((:hsp_pores_find_regions_with, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_boundary},
          Ptr{hsp_pores_request}, Ptr{hsp_pore_access}, Ptr{UInt32}), pores, boundary, request, access, regions)
end

function hsp_pores_get_regions(pores, first, count, out)
    ccall((:hsp_pores_get_regions, libhardsphere), Int32, (Ptr{hsp_pores}, UInt32, UInt32, Ptr{hsp_pore_region}),
          pores, first, count, out)
end

function hsp_pores_measure_pockets(pores, plugged, boundary, out, capacity, needed)
    ccall((:hsp_pores_measure_pockets, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_pores}, Ptr{hsp_boundary},
          Ptr{hsp_pore_pocket_size}, UInt32, Ptr{UInt32}), pores, plugged, boundary, out, capacity, needed)
end

function hsp_pores_measure_pockets_with(pores, plugged, boundary, request, out, capacity, needed)
    ccall((:hsp_pores_measure_pockets_with, libhardsphere), Int32, (Ptr{hsp_pores}, Ptr{hsp_pores}, Ptr{hsp_boundary},
          Ptr{hsp_pores_request}, Ptr{hsp_pore_pocket_size}, UInt32, Ptr{UInt32}), pores, plugged, boundary, request,
          out, capacity, needed)
end

function hsp_view_limits_init(limits, struct_size, balls)
    ccall((:hsp_view_limits_init, libhardsphere), Int32, (Ptr{hsp_view_limits}, UInt32, UInt32), limits, struct_size,
          balls)
end

function hsp_view_bytes(limits, bytes)
    ccall((:hsp_view_bytes, libhardsphere), Int32, (Ptr{hsp_view_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_view_init(memory, bytes, limits, view)
    ccall((:hsp_view_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_view_limits}, Ptr{Ptr{hsp_view}}),
          memory, bytes, limits, view)
end

function hsp_view_options_init(options, struct_size)
    ccall((:hsp_view_options_init, libhardsphere), Int32, (Ptr{hsp_view_options}, UInt32), options, struct_size)
end

function hsp_view_options_turn(options, x, y, z)
    ccall((:hsp_view_options_turn, libhardsphere), Int32, (Ptr{hsp_view_options}, Cdouble, Cdouble, Cdouble), options,
          x, y, z)
end

function hsp_view_compute(view, model, boundary, options, limits)
    ccall((:hsp_view_compute, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{hsp_model}, Ptr{hsp_boundary},
          Ptr{hsp_view_options}, Ptr{hsp_view_limits}), view, model, boundary, options, limits)
end

function hsp_view_get_info(view, info)
    ccall((:hsp_view_get_info, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{hsp_view_info}), view, info)
end

function hsp_view_get_pieces(view, out, capacity, needed)
    ccall((:hsp_view_get_pieces, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{hsp_view_piece}, UInt32, Ptr{UInt32}),
          view, out, capacity, needed)
end

function hsp_view_get_loops(view, out, capacity, needed)
    ccall((:hsp_view_get_loops, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{hsp_view_loop}, UInt32, Ptr{UInt32}), view,
          out, capacity, needed)
end

function hsp_view_get_arcs(view, out, capacity, needed)
    ccall((:hsp_view_get_arcs, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{hsp_view_arc}, UInt32, Ptr{UInt32}), view,
          out, capacity, needed)
end

function hsp_map_limits_init(limits, struct_size, balls)
    ccall((:hsp_map_limits_init, libhardsphere), Int32, (Ptr{hsp_map_limits}, UInt32, UInt32), limits, struct_size,
          balls)
end

function hsp_map_bytes(limits, bytes)
    ccall((:hsp_map_bytes, libhardsphere), Int32, (Ptr{hsp_map_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_map_init(memory, bytes, limits, map)
    ccall((:hsp_map_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_map_limits}, Ptr{Ptr{hsp_map}}), memory,
          bytes, limits, map)
end

function hsp_map_compute(map, model, options, limits)
    ccall((:hsp_map_compute, libhardsphere), Int32, (Ptr{hsp_map}, Ptr{hsp_model}, Ptr{hsp_view_options},
          Ptr{hsp_map_limits}), map, model, options, limits)
end

function hsp_map_get_info(map, info)
    ccall((:hsp_map_get_info, libhardsphere), Int32, (Ptr{hsp_map}, Ptr{hsp_map_info}), map, info)
end

function hsp_map_next(map, h)
    ccall((:hsp_map_next, libhardsphere), UInt32, (Ptr{hsp_map}, UInt32), map, h)
end

function hsp_map_previous(map, h)
    ccall((:hsp_map_previous, libhardsphere), UInt32, (Ptr{hsp_map}, UInt32), map, h)
end

function hsp_map_next_loop(map, h)
    ccall((:hsp_map_next_loop, libhardsphere), UInt32, (Ptr{hsp_map}, UInt32), map, h)
end

function hsp_map_origin(map, h)
    ccall((:hsp_map_origin, libhardsphere), UInt32, (Ptr{hsp_map}, UInt32), map, h)
end

function hsp_map_left(map, h)
    ccall((:hsp_map_left, libhardsphere), UInt32, (Ptr{hsp_map}, UInt32), map, h)
end

function hsp_map_get_vertices(map, first, count, out)
    ccall((:hsp_map_get_vertices, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, UInt32, Ptr{hsp_map_vertex}), map,
          first, count, out)
end

function hsp_map_get_edges(map, first, count, out)
    ccall((:hsp_map_get_edges, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, UInt32, Ptr{hsp_map_edge}), map, first,
          count, out)
end

function hsp_map_get_faces(map, first, count, out)
    ccall((:hsp_map_get_faces, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, UInt32, Ptr{hsp_map_face}), map, first,
          count, out)
end

function hsp_map_get_areas(map, area, capacity, needed)
    ccall((:hsp_map_get_areas, libhardsphere), Int32, (Ptr{hsp_map}, Ptr{Cdouble}, UInt32, Ptr{UInt32}), map, area,
          capacity, needed)
end

function hsp_map_get_outline(map, ball, h, capacity, needed)
    ccall((:hsp_map_get_outline, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, Ptr{UInt32}, UInt32, Ptr{UInt32}), map,
          ball, h, capacity, needed)
end

function hsp_map_pick(map, x, y, sight)
    ccall((:hsp_map_pick, libhardsphere), Int32, (Ptr{hsp_map}, Cdouble, Cdouble, Ptr{hsp_map_sight}), map, x, y, sight)
end

function hsp_map_get_point(map, edge, t, point)
    ccall((:hsp_map_get_point, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, Cdouble, Ptr{hsp_map_point}), map, edge,
          t, point)
end

function hsp_map_get_pole(map, face, pole)
    ccall((:hsp_map_get_pole, libhardsphere), Int32, (Ptr{hsp_map}, UInt32, Ptr{hsp_map_pole}), map, face, pole)
end

function hsp_map_check(map, invariant, id)
    ccall((:hsp_map_check, libhardsphere), Int32, (Ptr{hsp_map}, Ptr{UInt32}, Ptr{UInt32}), map, invariant, id)
end

function hsp_sticks_limits_init(limits, struct_size, balls)
    ccall((:hsp_sticks_limits_init, libhardsphere), Int32, (Ptr{hsp_sticks_limits}, UInt32, UInt32), limits,
          struct_size, balls)
end

function hsp_sticks_bytes(limits, bytes)
    ccall((:hsp_sticks_bytes, libhardsphere), Int32, (Ptr{hsp_sticks_limits}, Ptr{Csize_t}), limits, bytes)
end

function hsp_sticks_init(memory, bytes, limits, sticks)
    ccall((:hsp_sticks_init, libhardsphere), Int32, (Ptr{Cvoid}, Csize_t, Ptr{hsp_sticks_limits},
          Ptr{Ptr{hsp_sticks}}), memory, bytes, limits, sticks)
end

function hsp_sticks_compute(sticks, model, options, stick, count, radius, conflict, limits)
    ccall((:hsp_sticks_compute, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{hsp_model}, Ptr{hsp_view_options},
          Ptr{hsp_stick}, UInt32, Cdouble, Ptr{hsp_sticks_conflict}, Ptr{hsp_sticks_limits}), sticks, model, options,
          stick, count, radius, conflict, limits)
end

function hsp_sticks_compute_map(sticks, model, options, stick, count, radius, conflict, limits)
    ccall((:hsp_sticks_compute_map, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{hsp_model}, Ptr{hsp_view_options},
          Ptr{hsp_stick}, UInt32, Cdouble, Ptr{hsp_sticks_conflict}, Ptr{hsp_sticks_limits}), sticks, model, options,
          stick, count, radius, conflict, limits)
end

function hsp_sticks_get_info(sticks, info)
    ccall((:hsp_sticks_get_info, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{hsp_sticks_info}), sticks, info)
end

function hsp_sticks_get_map_info(sticks, info)
    ccall((:hsp_sticks_get_map_info, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{hsp_map_info}), sticks, info)
end

function hsp_sticks_get_vertices(sticks, first, count, out)
    ccall((:hsp_sticks_get_vertices, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, UInt32, Ptr{hsp_map_vertex}),
          sticks, first, count, out)
end

function hsp_sticks_get_edges(sticks, first, count, out)
    ccall((:hsp_sticks_get_edges, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, UInt32, Ptr{hsp_map_edge}), sticks,
          first, count, out)
end

function hsp_sticks_get_faces(sticks, first, count, out)
    ccall((:hsp_sticks_get_faces, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, UInt32, Ptr{hsp_map_face}), sticks,
          first, count, out)
end

function hsp_sticks_get_areas(sticks, area, capacity, needed)
    ccall((:hsp_sticks_get_areas, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{Cdouble}, UInt32, Ptr{UInt32}), sticks,
          area, capacity, needed)
end

function hsp_sticks_pick(sticks, x, y, sight)
    ccall((:hsp_sticks_pick, libhardsphere), Int32, (Ptr{hsp_sticks}, Cdouble, Cdouble, Ptr{hsp_map_sight}), sticks, x,
          y, sight)
end

function hsp_sticks_get_outline(sticks, ball, h, capacity, needed)
    ccall((:hsp_sticks_get_outline, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, Ptr{UInt32}, UInt32, Ptr{UInt32}),
          sticks, ball, h, capacity, needed)
end

function hsp_sticks_get_point(sticks, edge, t, point)
    ccall((:hsp_sticks_get_point, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, Cdouble, Ptr{hsp_map_point}),
          sticks, edge, t, point)
end

function hsp_sticks_get_pole(sticks, face, pole)
    ccall((:hsp_sticks_get_pole, libhardsphere), Int32, (Ptr{hsp_sticks}, UInt32, Ptr{hsp_map_pole}), sticks, face,
          pole)
end

function hsp_sticks_check(sticks, invariant, id)
    ccall((:hsp_sticks_check, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{UInt32}, Ptr{UInt32}), sticks, invariant, id)
end

function hsp_picture_ink_width(full_width, gap, width)
    ccall((:hsp_picture_ink_width, libhardsphere), Int32, (Cdouble, Cdouble, Ptr{Cdouble}), full_width, gap, width)
end

function hsp_picture_fog_share(nearest, farthest, mean_radius, depth, share)
    ccall((:hsp_picture_fog_share, libhardsphere), Int32, (Cdouble, Cdouble, Cdouble, Cdouble, Ptr{Cdouble}), nearest,
          farthest, mean_radius, depth, share)
end

function hsp_picture_options_init(options, struct_size)
    ccall((:hsp_picture_options_init, libhardsphere), Int32, (Ptr{hsp_picture_options}, UInt32), options, struct_size)
end

function hsp_palette_colour(palette, atomic_number, chain)
    ccall((:hsp_palette_colour, libhardsphere), UInt32, (UInt32, UInt32, UInt32), palette, atomic_number, chain)
end

function hsp_picture_write(view, colour, options, title, description, sink, context, bytes)
    ccall((:hsp_picture_write, libhardsphere), Int32, (Ptr{hsp_view}, Ptr{UInt32}, Ptr{hsp_picture_options},
          Ptr{Cchar}, Ptr{Cchar}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{UInt64}), view, colour, options, title, description,
          sink, context, bytes)
end

function hsp_picture_write_map(map, colour, options, title, description, sink, context, bytes)
    ccall((:hsp_picture_write_map, libhardsphere), Int32, (Ptr{hsp_map}, Ptr{UInt32}, Ptr{hsp_picture_options},
          Ptr{Cchar}, Ptr{Cchar}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{UInt64}), map, colour, options, title, description, sink,
          context, bytes)
end

function hsp_picture_write_sticks(sticks, colour, options, title, description, sink, context, bytes)
    ccall((:hsp_picture_write_sticks, libhardsphere), Int32, (Ptr{hsp_sticks}, Ptr{UInt32}, Ptr{hsp_picture_options},
          Ptr{Cchar}, Ptr{Cchar}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{UInt64}), sticks, colour, options, title, description,
          sink, context, bytes)
end

end
