// The C interface of hardsphere, for Rust. Generated from the headers by capi/interface/generate.sh.
// To link it: rustc program.rs -L PREFIX/lib -l static=hardsphere -l m, of an installed archive; C++'s library is not needed.
// All editions: that of 2024 wants `unsafe extern`, which compilers before 1.82 do not know.
#![allow(dead_code, non_camel_case_types)]
use std::os::raw::{c_char, c_void};

pub const HSP_VERSION_MAJOR: u32 = 1;
pub const HSP_VERSION_MINOR: u32 = 1;
pub const HSP_VERSION_PATCH: u32 = 0;
pub const HSP_VERSION_NUMBER: u32 = 10100;
pub const HSP_ABI_NUMBER: u32 = 2;
pub const HSP_PROVISIONAL_NUMBER: u32 = 2;
pub const HSP_NUMERICS_NUMBER: u32 = 3;
pub const HSP_PROVISIONAL_NUMERICS_NUMBER: u32 = 4;
pub const HSP_OK: i32 = 0;
pub const HSP_E_ARGUMENT: i32 = -1;
pub const HSP_E_CAPACITY: i32 = -2;
pub const HSP_E_MEMORY: i32 = -3;
pub const HSP_E_STATE: i32 = -4;
pub const HSP_E_ID: i32 = -5;
pub const HSP_E_CHECK: i32 = -6;
pub const HSP_E_SINK: i32 = -7;
pub const HSP_E_HANDLE: i32 = -8;
pub const HSP_E_VERSION: i32 = -9;
pub const HSP_E_NOT_FINITE: i32 = -10;
pub const HSP_E_NEGATIVE: i32 = -11;
pub const HSP_E_RANGE: i32 = -12;
pub const HSP_E_CONFLICT: i32 = -13;
pub const HSP_E_EXECUTOR: i32 = -15;
pub const HSP_E_DEGENERATE: i32 = -16;
pub const HSP_E_STOPPED: i32 = -17;
pub const HSP_E_DAMAGED: i32 = -18;
pub const HSP_RADII_BONDI: u32 = 0;
pub const HSP_RADII_CHEM3D: u32 = 1;
pub const HSP_RADII_UFF: u32 = 4;
pub const HSP_RADIUS_FALLBACK: u32 = 1;
pub const HSP_RADII_PROTOR: u32 = 2;
pub const HSP_RADII_NACCESS: u32 = 3;
pub const HSP_NONE: u32 = 4294967295;
pub const HSP_MAX_BALLS: u32 = 268435455;
pub const HSP_PACKING_ZERO_RADIUS: u32 = 1;
pub const HSP_PACKING_COINCIDENT: u32 = 2;
pub const HSP_PACKING_NO_PAIR: u32 = 4;
pub const HSP_PAIRS_ONCE: u32 = 1;
pub const HSP_MAX_WORKERS: u32 = 1024;
pub const HSP_VERTEX_TIED: u32 = 1;
pub const HSP_BALL_CONTAINED: u32 = 1;
pub const HSP_TANGENT_OVERLAP: u32 = 0;
pub const HSP_TANGENT_DISJOINT: u32 = 1;
pub const HSP_GRADIENT_ONE_SIDED: u32 = 1;
pub const HSP_CURVATURE_ONE_SIDED: u32 = 1;
pub const HSP_HESSIAN_SINGULAR: u32 = 2;
pub const HSP_BRICK_KEEP_SHELLS: u32 = 1;
pub const HSP_CONTACT_TOUCHING: u32 = 1;
pub const HSP_CONTACT_BURIED: u32 = 2;
pub const HSP_CONTACT_CIRCLE: u32 = 4;
pub const HSP_SIMPLEX_SINGULAR: u32 = 0;
pub const HSP_SIMPLEX_REGULAR: u32 = 1;
pub const HSP_SIMPLEX_INTERIOR: u32 = 2;
pub const HSP_SURFACE_DEGENERATE: u32 = 1;
pub const HSP_PATCH_CONVEX: u32 = 0;
pub const HSP_PATCH_SADDLE: u32 = 1;
pub const HSP_PATCH_CONCAVE: u32 = 2;
pub const HSP_PATCH_CIRCLE_SADDLE: u32 = 3;
pub const HSP_SURFACE_RIM: u32 = 0;
pub const HSP_SURFACE_CIRCLE_RIM: u32 = 1;
pub const HSP_SURFACE_SIDE: u32 = 2;
pub const HSP_SURFACE_CREASE: u32 = 3;
pub const HSP_CORNER_BALL: u32 = 0;
pub const HSP_CORNER_CUSP: u32 = 1;
pub const HSP_CORNER_CREASE: u32 = 2;
pub const HSP_SHELL_OUTER: u32 = 0;
pub const HSP_SHELL_VOID: u32 = 1;
pub const HSP_POINT_VERTEX: u32 = 0;
pub const HSP_POINT_CIRCLE: u32 = 1;
pub const HSP_POINT_POLE: u32 = 2;
pub const HSP_EDGE_ARC: u32 = 0;
pub const HSP_EDGE_CIRCLE: u32 = 1;
pub const HSP_EDGE_CUT: u32 = 2;
pub const HSP_CELL_RUN: u32 = 0;
pub const HSP_CELL_AT_BALL: u32 = 1;
pub const HSP_CELL_APART: u32 = 2;
pub const HSP_PATH_CONNECTED: u32 = 0;
pub const HSP_PATH_APART: u32 = 1;
pub const HSP_PATH_COVERED: u32 = 2;
pub const HSP_PORE_OUTSIDE: u32 = 4294967294;
pub const HSP_PIECES_OUTSIDE_FARTHER: u32 = 0;
pub const HSP_PIECES_OUTSIDE_ALL: u32 = 1;
pub const HSP_VIEW_ALL_BALLS: u32 = 1;
pub const HSP_MAP_PLAIN: u32 = 0;
pub const HSP_MAP_TRIPLE: u32 = 1;
pub const HSP_MAP_T: u32 = 2;
pub const HSP_MAP_TANGENCY: u32 = 3;
pub const HSP_MAP_HALVES: u32 = 4;
pub const HSP_STICK_WHOLE: u32 = 1;
pub const HSP_STICK_DOUBLE: u32 = 2;
pub const HSP_STICK_TRIPLE: u32 = 4;
pub const HSP_STICK_AROMATIC: u32 = 8;
pub const HSP_STICKS_NO_CONFLICT: u32 = 0;
pub const HSP_STICKS_BALLS_MEET: u32 = 1;
pub const HSP_STICKS_NO_BALL: u32 = 2;
pub const HSP_STICKS_SAME_ENDS: u32 = 3;
pub const HSP_STICKS_THIN_BALL: u32 = 4;
pub const HSP_STICKS_SHARP_ANGLE: u32 = 5;
pub const HSP_STICKS_MEET: u32 = 6;
pub const HSP_STICKS_STICK_IN_BALL: u32 = 7;
pub const HSP_STICKS_CYCLE: u32 = 8;
pub const HSP_FORMAT_SVG: u32 = 0;
pub const HSP_FORMAT_EPS: u32 = 1;
pub const HSP_FORMAT_PDF: u32 = 2;
pub const HSP_STYLE_FLAT: u32 = 0;
pub const HSP_STYLE_HEADLIGHT: u32 = 1;
pub const HSP_STYLE_SOFT: u32 = 2;
pub const HSP_UNIT_PX: u32 = 0;
pub const HSP_UNIT_MM: u32 = 1;
pub const HSP_PICTURE_NO_IDS: u32 = 1;
pub const HSP_PICTURE_NO_BACKGROUND: u32 = 2;
pub const HSP_INK_BORDER: u32 = 0;
pub const HSP_INK_GROUP: u32 = 1;
pub const HSP_INK_DEPTH: u32 = 2;
pub const HSP_PICTURE_MEMORY: u32 = 71680;
pub const HSP_PALETTE_SOFT: u32 = 0;
pub const HSP_PALETTE_JMOL: u32 = 1;
pub const HSP_PALETTE_CHAIN: u32 = 2;

#[repr(C)]
pub struct hsp_model {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_body {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_boundary {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_moving {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_contacts {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_periodic {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_surface {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_mesh {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_topology {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_cells {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_paths {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_pores {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_view {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_map {
    _private: [u8; 0],
}

#[repr(C)]
pub struct hsp_sticks {
    _private: [u8; 0],
}

pub type hsp_task = unsafe extern "C" fn(*mut c_void, u32);
pub type hsp_sink = unsafe extern "C" fn(*mut c_void, *const c_char, usize) -> i32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_executor {
    pub struct_size: u32,
    pub workers: u32,
    pub context: *mut c_void,
    pub run: Option<unsafe extern "C" fn(*mut c_void, u32, Option<hsp_task>, *mut c_void) -> i32>,
    pub proceed: Option<unsafe extern "C" fn(*mut c_void) -> i32>,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_residue_atom {
    pub residue: [c_char; 8],
    pub atom: [c_char; 8],
    pub radius: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_model_options {
    pub struct_size: u32,
    pub reserved: u32,
    pub probe: f64,
    pub step: f64,
    pub largest_radius: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_model_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub options: *const hsp_model_options,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_model_info {
    pub balls: u32,
    pub cubes: u32,
    pub table_slots: u32,
    pub longest_probe: u32,
    pub step: f64,
    pub probe: f64,
    pub largest_radius: f64,
    pub largest_rounding: f64,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_packing {
    pub k: f64,
    pub rho: f64,
    pub mean_overlaps: f64,
    pub neighbour_bound: f64,
    pub max_overlaps: u32,
    pub flags: u32,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pairs_request {
    pub struct_size: u32,
    pub flags: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_ray_hit {
    pub xyz: [f64; 3],
    pub distance: f64,
    pub ball: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_body_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pose {
    pub quaternion: [f64; 4],
    pub translation: [f64; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_body_gap {
    pub gap: f64,
    pub fixed: u32,
    pub posed: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_body_overlap {
    pub volume: f64,
    pub pairs: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_rational_pose {
    pub quaternion: [i32; 4],
    pub translation: [f64; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_boundary_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
    pub vertices: u32,
    pub circles: u32,
    pub workers: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_boundary_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
    pub selected: *const u8,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_boundary_counts {
    pub balls: u32,
    pub exposed_balls: u32,
    pub contained_balls: u32,
    pub vertices: u32,
    pub arcs: u32,
    pub circles: u32,
    pub faces: u32,
    pub loops: u32,
    pub shells: u32,
    pub components: u32,
    pub voids: u32,
    pub tied_vertices: u32,
    pub euler: i64,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_vertex {
    pub xyz: [f64; 3],
    pub ball: [u32; 3],
    pub sign: i32,
    pub flags: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_arc {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub angle: f64,
    pub ball: [u32; 2],
    pub vertex: [u32; 2],
    pub face: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_circle {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub ball: [u32; 2],
    pub face: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_face {
    pub ball: u32,
    pub loops: u32,
    pub shell: u32,
    pub first_loop: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_loop {
    pub face: u32,
    pub circle: u32,
    pub side: u32,
    pub first_arc: u32,
    pub arcs: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_loop_arc {
    pub arc: u32,
    pub side: u32,
    pub vertex: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_ball {
    pub faces: u32,
    pub first_face: u32,
    pub component: u32,
    pub flags: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_totals {
    pub area: f64,
    pub volume: f64,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_measure_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub selected: *const u8,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_measure_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub reserved: u32,
    pub totals: *mut hsp_totals,
    pub area: *mut f64,
    pub volume_term: *mut f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_energy {
    pub value: f64,
    pub area: f64,
    pub volume: f64,
    pub d_probe: f64,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_gradient_request {
    pub struct_size: u32,
    pub tangency: u32,
    pub tension: f64,
    pub pressure: f64,
    pub sigma: *const f64,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_gradient_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub first_bad: u32,
    pub energy: *mut hsp_energy,
    pub d_centre: *mut f64,
    pub d_radius: *mut f64,
    pub flags: *mut u32,
    pub area: *mut f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_derivatives_request {
    pub struct_size: u32,
    pub tangency: u32,
    pub sigma: *const f64,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_derivatives_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub first_bad: u32,
    pub area_centre: *mut f64,
    pub area_radius: *mut f64,
    pub volume_centre: *mut f64,
    pub volume_radius: *mut f64,
    pub flags: *mut u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_area_derivative {
    pub centre: [f64; 3],
    pub radius: f64,
    pub angle: f64,
    pub ball: u32,
    pub flags: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_moving_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_moving_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_moving_info {
    pub step: f64,
    pub probe: f64,
    pub largest_radius: f64,
    pub vertices: u64,
    pub arcs: u64,
    pub circles: u64,
    pub faces: u64,
    pub loops: u64,
    pub balls: u32,
    pub exposed_balls: u32,
    pub contained_balls: u32,
    pub components: u32,
    pub changed: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_moving_ball {
    pub centre: [f64; 3],
    pub radius: f64,
    pub area: f64,
    pub volume_term: f64,
    pub d_centre: [f64; 3],
    pub d_radius: f64,
    pub faces: u32,
    pub flags: u32,
    pub gradient_flags: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_curvatures {
    pub mean: f64,
    pub gauss: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_curvature_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_morphometry_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub pressure: f64,
    pub tension: f64,
    pub bending: f64,
    pub gaussian: f64,
    pub sigma: *const f64,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_morphometric_energy {
    pub value: f64,
    pub volume: f64,
    pub area: f64,
    pub mean: f64,
    pub gauss: f64,
    pub d_probe: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_morphometry_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub first_bad: u32,
    pub energy: *mut hsp_morphometric_energy,
    pub d_centre: *mut f64,
    pub d_radius: *mut f64,
    pub flags: *mut u32,
    pub area: *mut f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_brick_request {
    pub struct_size: u32,
    pub brick: u32,
    pub bricks: u32,
    pub flags: u32,
    pub id: *const u64,
    pub owner: *const u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_brick_totals {
    pub balls: u64,
    pub exposed_balls: u64,
    pub contained_balls: u64,
    pub vertices: u64,
    pub arcs: u64,
    pub circles: u64,
    pub faces: u64,
    pub loops: u64,
    pub shells: u64,
    pub components: u64,
    pub voids: u64,
    pub tied_vertices: u64,
    pub euler: i64,
    pub area: f64,
    pub volume: f64,
    pub void_volume: f64,
    pub reserved: [u64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_brick_shell {
    pub component: u64,
    pub faces: u64,
    pub euler: i64,
    pub area: f64,
    pub volume: f64,
    pub kind: u32,
    pub reserved: [u32; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_contacts_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
    pub contacts: u32,
    pub triangles: u32,
    pub tetrahedra: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_contacts_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_contact {
    pub area: f64,
    pub rim: f64,
    pub distance: f64,
    pub ball: [u32; 2],
    pub chords: u32,
    pub flags: u32,
    pub reserved: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_group_contact {
    pub area: f64,
    pub rim: f64,
    pub group: [u32; 2],
    pub contacts: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_complex {
    pub singular: [u32; 4],
    pub regular: [u32; 4],
    pub interior: [u32; 4],
    pub euler: i64,
    pub betti: [u32; 3],
    pub reserved: [u32; 5],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_simplex {
    pub ball: [u32; 4],
    pub kind: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub images: u32,
    pub neighbours: u32,
    pub vertices: u32,
    pub circles: u32,
    pub contacts: u32,
    pub workers: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_request {
    pub struct_size: u32,
    pub areas_alone: u32,
    pub options: *const hsp_model_options,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_counts {
    pub balls: u32,
    pub images: u32,
    pub vertices: u32,
    pub arcs: u32,
    pub circles: u32,
    pub loops: u32,
    pub faces: u32,
    pub shells: u32,
    pub components: u32,
    pub contacts: u32,
    pub euler: i64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_totals {
    pub area: f64,
    pub volume: f64,
    pub box_volume: f64,
    pub free_volume: f64,
    pub contact_area: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_morphometry_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub first_bad: u32,
    pub energy: *mut hsp_morphometric_energy,
    pub d_centre: *mut f64,
    pub d_radius: *mut f64,
    pub flags: *mut u32,
    pub d_strain: *mut f64,
    pub d_box: *mut f64,
    pub area: *mut f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_contact {
    pub area: f64,
    pub rim: f64,
    pub distance: f64,
    pub ball: [u32; 2],
    pub chords: u32,
    pub flags: u32,
    pub shift: [i32; 3],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_winding {
    pub balls: u32,
    pub first: u32,
    pub directions: u32,
    pub copies: u32,
    pub row: [i32; 9],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_gradient_outputs {
    pub struct_size: u32,
    pub capacity: u32,
    pub needed: u32,
    pub first_bad: u32,
    pub energy: *mut hsp_energy,
    pub d_centre: *mut f64,
    pub d_radius: *mut f64,
    pub flags: *mut u32,
    pub d_strain: *mut f64,
    pub d_box: *mut f64,
    pub area: *mut f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_image {
    pub ball: u32,
    pub shift: [i32; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_id {
    pub id: u32,
    pub shift: [i32; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_vertex {
    pub xyz: [f64; 3],
    pub image: [hsp_image; 3],
    pub sign: i32,
    pub flags: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_arc {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub angle: f64,
    pub image: [hsp_image; 2],
    pub vertex: [hsp_periodic_id; 2],
    pub face: [hsp_periodic_id; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_circle {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub image: [hsp_image; 2],
    pub face: [hsp_periodic_id; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_face {
    pub image: hsp_image,
    pub loops: u32,
    pub shell: u32,
    pub first_loop: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_loop {
    pub circle: hsp_periodic_id,
    pub face: u32,
    pub side: u32,
    pub first_arc: u32,
    pub arcs: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_periodic_loop_arc {
    pub arc: hsp_periodic_id,
    pub vertex: hsp_periodic_id,
    pub side: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_limits {
    pub struct_size: u32,
    pub vertices: u32,
    pub faces: u32,
    pub neighbours: u32,
    pub pieces: u32,
    pub arcs: u32,
    pub cusped_circles: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_request {
    pub struct_size: u32,
    pub count: u32,
    pub executor: *const hsp_executor,
    pub shells: *const u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_counts {
    pub convex_patches: u32,
    pub saddle_patches: u32,
    pub concave_patches: u32,
    pub cusped_patches: u32,
    pub cut_patches: u32,
    pub hidden_patches: u32,
    pub rounded_patches: u32,
    pub open_joints: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_totals {
    pub area: f64,
    pub volume: f64,
    pub convex_area: f64,
    pub saddle_area: f64,
    pub concave_area: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_measure_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_part_counts {
    pub patches: u32,
    pub edges: u32,
    pub corners: u32,
    pub shells: u32,
    pub cusps: u32,
    pub junctions: u32,
    pub creases: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_patch {
    pub area: f64,
    pub kind: u32,
    pub source: u32,
    pub part: u32,
    pub shell: u32,
    pub loops: u32,
    pub edges: u32,
    pub h: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_edge {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub angle: f64,
    pub patch: [u32; 2],
    pub corner: [u32; 2],
    pub next: [u32; 2],
    pub previous: [u32; 2],
    pub kind: u32,
    pub source: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_corner {
    pub xyz: [f64; 3],
    pub kind: u32,
    pub ball: [u32; 2],
    pub vertex: [u32; 3],
    pub shell: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_surface_shell {
    pub area: f64,
    pub volume: f64,
    pub euler: i64,
    pub genus: u32,
    pub patches: u32,
    pub chosen: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_mesh_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub curves: u32,
    pub vertices: u32,
    pub triangles: u32,
    pub points: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_mesh_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_mesh_counts {
    pub vertices: u32,
    pub triangles: u32,
    pub curves: u32,
    pub refined: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_topology_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
    pub edges: u32,
    pub cut_arcs: u32,
    pub shells: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_topology_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_topology_counts {
    pub vertices: u32,
    pub edges: u32,
    pub simple_faces: u32,
    pub cut_edges: u32,
    pub shells: u32,
    pub components: u32,
    pub regions: u32,
    pub start_face: u32,
    pub reserved: [u32; 4],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_shell {
    pub area: f64,
    pub volume: f64,
    pub point: [f64; 3],
    pub euler: i64,
    pub genus: u32,
    pub kind: u32,
    pub component: u32,
    pub region: u32,
    pub faces: u32,
    pub simple_faces: u32,
    pub edges: u32,
    pub vertices: u32,
    pub start_face: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_component {
    pub balls: u32,
    pub top_ball: u32,
    pub outer_shell: u32,
    pub shells: u32,
    pub region: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_region {
    pub area: f64,
    pub volume: f64,
    pub enclosing_shell: u32,
    pub components: u32,
    pub shells: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_topology_vertex {
    pub xyz: [f64; 3],
    pub ball: [u32; 3],
    pub kind: u32,
    pub q: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_topology_edge {
    pub centre: [f64; 3],
    pub axis: [f64; 3],
    pub radius: f64,
    pub angle: f64,
    pub vertex: [u32; 2],
    pub face: [u32; 2],
    pub ball: [u32; 2],
    pub kind: u32,
    pub source: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_simple_face {
    pub ball: u32,
    pub face: u32,
    pub edges: u32,
    pub q: u32,
    pub shell: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_cells_limits {
    pub struct_size: u32,
    pub cubes: u32,
    pub entries: u32,
    pub cells: u32,
    pub adjacencies: u32,
    pub landmarks: u32,
    pub facets: u32,
    pub corners: u32,
    pub cube_balls: u32,
    pub cube_corners: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_cells_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_cells_counts {
    pub cubes: u32,
    pub power_cells: u32,
    pub cells: u32,
    pub runs: u32,
    pub adjacencies: u32,
    pub regions: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_free_cell {
    pub low: [f64; 3],
    pub high: [f64; 3],
    pub ball: u32,
    pub cube: u32,
    pub kind: u32,
    pub region: u32,
    pub neighbours: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_cell_pair {
    pub cell: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_arrangement {
    pub vertices: u64,
    pub edges: u64,
    pub faces: u64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_paths_limits {
    pub struct_size: u32,
    pub cubes: u32,
    pub entries: u32,
    pub cells: u32,
    pub adjacencies: u32,
    pub landmarks: u32,
    pub facets: u32,
    pub corners: u32,
    pub cube_balls: u32,
    pub cube_corners: u32,
    pub points: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_paths_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_path {
    pub length: f64,
    pub clearance: f64,
    pub ends: u32,
    pub certified: u32,
    pub points: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pores_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub maxima: u32,
    pub gates: u32,
    pub tied: u32,
    pub candidates: u32,
    pub neighbours: u32,
    pub points: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pores_options {
    pub struct_size: u32,
    pub reserved: u32,
    pub floor: f64,
    pub executor: *const hsp_executor,
    pub before: *const hsp_pores,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pores_counts {
    pub maxima: u32,
    pub gates: u32,
    pub merges: u32,
    pub cavities: u32,
    pub outer_balls: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_maximum {
    pub xyz: [f64; 3],
    pub radius: f64,
    pub death: f64,
    pub ball: [u32; 4],
    pub gate: u32,
    pub parent: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_gate {
    pub xyz: [f64; 3],
    pub radius: f64,
    pub ball: [u32; 3],
    pub end: [u32; 2],
    pub merges: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_gate_shifts {
    pub ball: [i32; 9],
    pub end: [i32; 6],
    pub winds: u32,
    pub directions: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_percolation {
    pub largest: f64,
    pub through: [f64; 3],
    pub included: [f64; 3],
    pub along: [f64; 3],
    pub gate: [u32; 3],
    pub maximum: [u32; 3],
    pub gate_along: [u32; 3],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_channel {
    pub radius: f64,
    pub maximum: u32,
    pub maxima: u32,
    pub directions: u32,
    pub copies: u32,
    pub row: [i32; 9],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_place {
    pub radius: f64,
    pub ball: u32,
    pub maximum: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_place_shifts {
    pub ball: [i32; 3],
    pub maximum: [i32; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_passage {
    pub radius: f64,
    pub passes: u32,
    pub gate: u32,
    pub ball: u32,
    pub at: [u32; 2],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_tunnel {
    pub radius: f64,
    pub length: f64,
    pub there: u32,
    pub gate: u32,
    pub gates: u32,
    pub points: u32,
    pub outside: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_tunnel_request {
    pub struct_size: u32,
    pub cheapest: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_tunnel_route {
    pub cost: f64,
    pub shift: [i32; 3],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_tunnel_point {
    pub xyz: [f64; 3],
    pub radius: f64,
    pub ball: [u32; 4],
    pub gate: u32,
    pub maximum: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_tunnel_point_shifts {
    pub ball: [i32; 12],
    pub at: [i32; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_pocket {
    pub radius: f64,
    pub mouth: f64,
    pub maximum: u32,
    pub gate: u32,
    pub maxima: u32,
    pub mouths: u32,
    pub balls: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_access {
    pub accessible_area: f64,
    pub accessible_volume: f64,
    pub blocked_area: f64,
    pub blocked_volume: f64,
    pub accessible: u32,
    pub blocked: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pores_request {
    pub struct_size: u32,
    pub reserved: u32,
    pub executor: *const hsp_executor,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_region {
    pub radius: f64,
    pub area: f64,
    pub volume: f64,
    pub maximum: u32,
    pub maxima: u32,
    pub shells: u32,
    pub accessible: u32,
    pub directions: u32,
    pub copies: u32,
    pub row: [i32; 9],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_pore_pocket_size {
    pub volume: f64,
    pub area: f64,
    pub plug_area: f64,
    pub regions: u32,
    pub closed: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
    pub arcs: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_options {
    pub struct_size: u32,
    pub pieces: u32,
    pub flags: u32,
    pub reserved: u32,
    pub towards: [f64; 3],
    pub up: [f64; 3],
    pub executor: *const hsp_executor,
    pub unused: *const c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_info {
    pub origin: [f64; 3],
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub towards: [f64; 3],
    pub low: [f64; 2],
    pub high: [f64; 2],
    pub depth_low: f64,
    pub depth_high: f64,
    pub pieces: u32,
    pub loops: u32,
    pub arcs: u32,
    pub kind: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_piece {
    pub centre: [f64; 2],
    pub depth: f64,
    pub radius: f64,
    pub ball: u32,
    pub first_loop: u32,
    pub loops: u32,
    pub first_arc: u32,
    pub arcs: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_loop {
    pub piece: u32,
    pub first_arc: u32,
    pub arcs: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_view_arc {
    pub centre: [f64; 2],
    pub semi_axis: [f64; 2],
    pub rotation: f64,
    pub from: f64,
    pub to: f64,
    pub start: [f64; 2],
    pub end: [f64; 2],
    pub piece: u32,
    pub other_ball: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub neighbours: u32,
    pub edges: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_info {
    pub origin: [f64; 3],
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub towards: [f64; 3],
    pub area: f64,
    pub perturbation: f64,
    pub vertices: u32,
    pub edges: u32,
    pub faces: u32,
    pub components: u32,
    pub balls: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_vertex {
    pub xyz: [f64; 3],
    pub kind: u32,
    pub h: u32,
    pub ball: [u32; 3],
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_edge {
    pub centre: [f64; 2],
    pub first: [f64; 2],
    pub second: [f64; 2],
    pub from: f64,
    pub to: f64,
    pub ball: [u32; 2],
    pub face: [u32; 2],
    pub vertex: [u32; 2],
    pub next: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_face {
    pub area: f64,
    pub ball: u32,
    pub h: u32,
    pub loops: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_sight {
    pub depth: f64,
    pub ball: u32,
    pub face: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_point {
    pub xyz: [f64; 3],
    pub gap: [f64; 2],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_map_pole {
    pub centre: [f64; 2],
    pub radius: f64,
    pub bound: f64,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_sticks_limits {
    pub struct_size: u32,
    pub balls: u32,
    pub sticks: u32,
    pub pairs: u32,
    pub edges: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_stick {
    pub ball: [u32; 2],
    pub flags: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_sticks_conflict {
    pub kind: u32,
    pub first: u32,
    pub second: u32,
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_sticks_info {
    pub origin: [f64; 3],
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub towards: [f64; 3],
    pub low: [f64; 2],
    pub high: [f64; 2],
    pub paths: u32,
    pub balls: u32,
    pub sticks: u32,
    pub arcs: u32,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct hsp_picture_options {
    pub struct_size: u32,
    pub format: u32,
    pub style: u32,
    pub unit: u32,
    pub width: f64,
    pub height: f64,
    pub margin: f64,
    pub outline: f64,
    pub fog: f64,
    pub outline_colour: u32,
    pub background: u32,
    pub flags: u32,
    pub reserved: u32,
    pub scale: f64,
    pub centre: [f64; 3],
    pub memory: *mut c_void,
    pub memory_bytes: usize,
    pub ink: *const hsp_map,
    pub group: *const u32,
    pub ink_width: [f64; 3],
    pub ink_colour: [u32; 3],
    pub reserved_for_ink: u32,
    pub atom_class: *const *const c_char,
    pub atom_title: *const *const c_char,
    pub ink_of_sticks: *const hsp_sticks,
    pub reserved_for_sticks: usize,
}

macro_rules! functions {
    ($of_2024:expr => $($declared:tt)*) => { unsafe extern "C" { $($declared)* } };
    (_ => $($declared:tt)*) => { extern "C" { $($declared)* } };
}

functions! { _ =>
    pub fn hsp_version() -> u32;
    pub fn hsp_abi() -> u32;
    pub fn hsp_provisional() -> u32;
    pub fn hsp_numerics() -> u32;
    pub fn hsp_provisional_numerics() -> u32;
    pub fn hsp_status_text(status: i32) -> *const c_char;
    pub fn hsp_element_radius(set: u32, atomic_number: u32, radius: *mut f64, flags: *mut u32) -> i32;
    pub fn hsp_element_number(symbol: *const c_char, atomic_number: *mut u32) -> i32;
    pub fn hsp_element_symbol(atomic_number: u32) -> *const c_char;
    pub fn hsp_residue_radius(set: u32, residue: *const c_char, atom: *const c_char, radius: *mut f64) -> i32;
    pub fn hsp_residue_get_atoms(set: u32, out: *mut hsp_residue_atom, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_model_max_balls() -> u32;
    pub fn hsp_model_bytes(balls: u32, bytes: *mut usize) -> i32;
    pub fn hsp_model_init(memory: *mut c_void, bytes: usize, balls: u32, model: *mut *mut hsp_model) -> i32;
    pub fn hsp_model_options_init(options: *mut hsp_model_options, struct_size: u32) -> i32;
    pub fn hsp_model_set(
        model: *mut hsp_model,
        n: u32,
        xyz: *const f64,
        radius: *const f64,
        options: *const hsp_model_options,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_model_set_with(
        model: *mut hsp_model,
        n: u32,
        xyz: *const f64,
        radius: *const f64,
        request: *const hsp_model_request,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_model_get_info(model: *const hsp_model, info: *mut hsp_model_info) -> i32;
    pub fn hsp_model_get_balls(
        model: *const hsp_model,
        xyz: *mut f64,
        radius: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_model_get_packing(model: *mut hsp_model, figures: *mut hsp_packing) -> i32;
    pub fn hsp_query_point(
        model: *const hsp_model,
        xyz: *const f64,
        ids: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_query_ball(
        model: *const hsp_model,
        xyz: *const f64,
        radius: f64,
        ids: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_query_meets(model: *const hsp_model, xyz: *const f64, radius: f64, meets: *mut u32) -> i32;
    pub fn hsp_query_neighbours(
        model: *const hsp_model,
        ball: u32,
        ids: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_query_pairs(
        model: *const hsp_model,
        flags: u32,
        first: *mut u32,
        ids: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_query_pairs_with(
        model: *const hsp_model,
        request: *const hsp_pairs_request,
        first: *mut u32,
        ids: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_query_ray(
        model: *const hsp_model,
        origin: *const f64,
        direction: *const f64,
        hit: *mut hsp_ray_hit,
    ) -> i32;
    pub fn hsp_body_bytes(balls: u32, bytes: *mut usize) -> i32;
    pub fn hsp_body_init(memory: *mut c_void, bytes: usize, balls: u32, body: *mut *mut hsp_body) -> i32;
    pub fn hsp_body_set(body: *mut hsp_body, model: *const hsp_model) -> i32;
    pub fn hsp_body_set_with(body: *mut hsp_body, model: *const hsp_model, request: *const hsp_body_request) -> i32;
    pub fn hsp_pose_from_matrix(matrix: *const f64, translation: *const f64, pose: *mut hsp_pose) -> i32;
    pub fn hsp_body_hits(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_pose,
        hit: *mut u32,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_hits_along(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_pose,
        margin: f64,
        hit: *mut u32,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_gaps(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_pose,
        gap: *mut hsp_body_gap,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_overlaps(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_pose,
        overlap: *mut hsp_body_overlap,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_pairs(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        pose: *const hsp_pose,
        pair: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_body_rational_hits(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_rational_pose,
        hit: *mut u32,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_rational_hits_along(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_rational_pose,
        margin: f64,
        hit: *mut u32,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_rational_gaps(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        poses: u32,
        pose: *const hsp_rational_pose,
        gap: *mut hsp_body_gap,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_body_rational_pairs(
        fixed: *const hsp_body,
        posed: *const hsp_body,
        pose: *const hsp_rational_pose,
        pair: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_limits_init(limits: *mut hsp_boundary_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_boundary_bytes(limits: *const hsp_boundary_limits, bytes: *mut usize) -> i32;
    pub fn hsp_boundary_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_boundary_limits,
        boundary: *mut *mut hsp_boundary,
    ) -> i32;
    pub fn hsp_boundary_compute(
        boundary: *mut hsp_boundary,
        model: *const hsp_model,
        limits: *mut hsp_boundary_limits,
    ) -> i32;
    pub fn hsp_boundary_compute_with(
        boundary: *mut hsp_boundary,
        model: *const hsp_model,
        request: *const hsp_boundary_request,
        limits: *mut hsp_boundary_limits,
    ) -> i32;
    pub fn hsp_boundary_get_counts(boundary: *const hsp_boundary, counts: *mut hsp_boundary_counts) -> i32;
    pub fn hsp_boundary_get_vertices(
        boundary: *const hsp_boundary,
        out: *mut hsp_vertex,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_arcs(
        boundary: *const hsp_boundary,
        out: *mut hsp_arc,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_circles(
        boundary: *const hsp_boundary,
        out: *mut hsp_circle,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_faces(
        boundary: *const hsp_boundary,
        out: *mut hsp_face,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_loops(
        boundary: *const hsp_boundary,
        out: *mut hsp_loop,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_loop_arcs(
        boundary: *const hsp_boundary,
        out: *mut hsp_loop_arc,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_balls(
        boundary: *const hsp_boundary,
        out: *mut hsp_ball,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_check(boundary: *mut hsp_boundary, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_areas_bytes(n: u32, bytes: *mut usize) -> i32;
    pub fn hsp_areas(
        n: u32,
        xyz: *const f64,
        radius: *const f64,
        probe: f64,
        memory: *mut c_void,
        bytes: *mut usize,
        totals: *mut hsp_totals,
        area: *mut f64,
    ) -> i32;
    pub fn hsp_boundary_measure(
        boundary: *const hsp_boundary,
        selected: *const u8,
        totals: *mut hsp_totals,
        area: *mut f64,
        volume_term: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_measures(
        boundary: *const hsp_boundary,
        request: *const hsp_measure_request,
        outputs: *mut hsp_measure_outputs,
    ) -> i32;
    pub fn hsp_boundary_measure_faces(
        boundary: *const hsp_boundary,
        area: *mut f64,
        volume_term: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_gradient_request_init(request: *mut hsp_gradient_request, struct_size: u32) -> i32;
    pub fn hsp_boundary_get_gradient(
        boundary: *const hsp_boundary,
        request: *const hsp_gradient_request,
        outputs: *mut hsp_gradient_outputs,
    ) -> i32;
    pub fn hsp_boundary_get_derivatives(
        boundary: *const hsp_boundary,
        request: *const hsp_derivatives_request,
        outputs: *mut hsp_derivatives_outputs,
    ) -> i32;
    pub fn hsp_boundary_get_area_row(
        boundary: *const hsp_boundary,
        ball: u32,
        tangency: u32,
        out: *mut hsp_area_derivative,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_area_rows(
        boundary: *const hsp_boundary,
        request: *const hsp_derivatives_request,
        first: *mut u32,
        ball: *mut u32,
        d_centre: *mut f64,
        d_radius: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_moving_limits_init(limits: *mut hsp_moving_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_moving_bytes(limits: *const hsp_moving_limits, bytes: *mut usize) -> i32;
    pub fn hsp_moving_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_moving_limits,
        moving: *mut *mut hsp_moving,
    ) -> i32;
    pub fn hsp_moving_set(
        moving: *mut hsp_moving,
        model: *const hsp_model,
        sigma: *const f64,
        tension: f64,
        pressure: f64,
        tangency: u32,
        limits: *mut hsp_moving_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_moving_set_with(
        moving: *mut hsp_moving,
        model: *const hsp_model,
        request: *const hsp_gradient_request,
        limits: *mut hsp_moving_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_moving_move(
        moving: *mut hsp_moving,
        count: u32,
        ball: *const u32,
        xyz: *const f64,
        radius: *const f64,
        limits: *mut hsp_moving_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_moving_move_with(
        moving: *mut hsp_moving,
        count: u32,
        ball: *const u32,
        xyz: *const f64,
        radius: *const f64,
        request: *const hsp_moving_request,
        limits: *mut hsp_moving_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_moving_undo(moving: *mut hsp_moving) -> i32;
    pub fn hsp_moving_get_info(moving: *const hsp_moving, info: *mut hsp_moving_info) -> i32;
    pub fn hsp_moving_measure(
        moving: *const hsp_moving,
        totals: *mut hsp_totals,
        area: *mut f64,
        volume_term: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_moving_gradient(
        moving: *const hsp_moving,
        energy: *mut hsp_energy,
        d_centre: *mut f64,
        d_radius: *mut f64,
        flags: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_moving_get_balls(
        moving: *const hsp_moving,
        count: u32,
        ball: *const u32,
        out: *mut hsp_moving_ball,
    ) -> i32;
    pub fn hsp_moving_get_changed(moving: *const hsp_moving, balls: *mut u32, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_moving_get_model(moving: *const hsp_moving, model: *mut hsp_model) -> i32;
    pub fn hsp_boundary_curvature(
        boundary: *const hsp_boundary,
        totals: *mut hsp_curvatures,
        mean: *mut f64,
        gauss_thirds: *mut i32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_curvature_with(
        boundary: *const hsp_boundary,
        request: *const hsp_curvature_request,
        totals: *mut hsp_curvatures,
        mean: *mut f64,
        gauss_thirds: *mut i32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_morphometry(
        boundary: *const hsp_boundary,
        request: *const hsp_morphometry_request,
        outputs: *mut hsp_morphometry_outputs,
    ) -> i32;
    pub fn hsp_boundary_get_hessian_rows(
        boundary: *const hsp_boundary,
        request: *const hsp_gradient_request,
        first: *mut u32,
        ball: *mut u32,
        block: *mut f64,
        flags: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_boundary_get_hessian_product(
        boundary: *const hsp_boundary,
        request: *const hsp_gradient_request,
        direction: *const f64,
        product: *mut f64,
        flags: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_brick_summarise(
        boundary: *const hsp_boundary,
        request: *const hsp_brick_request,
        summary: *mut c_void,
        bytes: *mut usize,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_brick_merge(
        a: *const u8,
        a_bytes: usize,
        b: *const u8,
        b_bytes: usize,
        executor: *const hsp_executor,
        summary: *mut c_void,
        bytes: *mut usize,
        brick: *mut u32,
    ) -> i32;
    pub fn hsp_brick_get_totals(
        summary: *const u8,
        bytes: usize,
        totals: *mut hsp_brick_totals,
        brick: *mut u32,
    ) -> i32;
    pub fn hsp_brick_get_shells(
        summary: *const u8,
        bytes: usize,
        out: *mut hsp_brick_shell,
        capacity: u32,
        needed: *mut u32,
        brick: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_limits_init(
        limits: *mut hsp_contacts_limits,
        struct_size: u32,
        boundary: *const hsp_boundary,
    ) -> i32;
    pub fn hsp_contacts_bytes(limits: *const hsp_contacts_limits, bytes: *mut usize) -> i32;
    pub fn hsp_contacts_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_contacts_limits,
        contacts: *mut *mut hsp_contacts,
    ) -> i32;
    pub fn hsp_contacts_compute(
        contacts: *mut hsp_contacts,
        boundary: *const hsp_boundary,
        limits: *mut hsp_contacts_limits,
    ) -> i32;
    pub fn hsp_contacts_compute_with(
        contacts: *mut hsp_contacts,
        boundary: *const hsp_boundary,
        request: *const hsp_contacts_request,
        limits: *mut hsp_contacts_limits,
    ) -> i32;
    pub fn hsp_contacts_get_pairs(
        contacts: *const hsp_contacts,
        out: *mut hsp_contact,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_get_row(
        contacts: *const hsp_contacts,
        ball: u32,
        out: *mut hsp_contact,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_measure(
        contacts: *const hsp_contacts,
        totals: *mut hsp_totals,
        share_volume: *mut f64,
        contact_area: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_group(
        contacts: *mut hsp_contacts,
        group: *const u32,
        out: *mut hsp_group_contact,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_get_complex(contacts: *const hsp_contacts, counts: *mut hsp_complex) -> i32;
    pub fn hsp_contacts_get_simplices(
        contacts: *const hsp_contacts,
        dimension: u32,
        out: *mut hsp_simplex,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_contacts_check(contacts: *mut hsp_contacts, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_periodic_limits_init(limits: *mut hsp_periodic_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_periodic_bytes(limits: *const hsp_periodic_limits, bytes: *mut usize) -> i32;
    pub fn hsp_periodic_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_periodic_limits,
        periodic: *mut *mut hsp_periodic,
    ) -> i32;
    pub fn hsp_periodic_compute(
        periodic: *mut hsp_periodic,
        n: u32,
        xyz: *const f64,
        radius: *const f64,
        r#box: *const f64,
        options: *const hsp_model_options,
        limits: *mut hsp_periodic_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_compute_with(
        periodic: *mut hsp_periodic,
        n: u32,
        xyz: *const f64,
        radius: *const f64,
        r#box: *const f64,
        request: *const hsp_periodic_request,
        limits: *mut hsp_periodic_limits,
        first_bad: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_counts(periodic: *const hsp_periodic, counts: *mut hsp_periodic_counts) -> i32;
    pub fn hsp_periodic_measure(
        periodic: *const hsp_periodic,
        totals: *mut hsp_periodic_totals,
        area: *mut f64,
        share_volume: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_curvature(
        periodic: *const hsp_periodic,
        totals: *mut hsp_curvatures,
        mean: *mut f64,
        gauss_thirds: *mut i32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_morphometry(
        periodic: *const hsp_periodic,
        request: *const hsp_morphometry_request,
        outputs: *mut hsp_periodic_morphometry_outputs,
    ) -> i32;
    pub fn hsp_periodic_get_contacts(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_contact,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_group_contacts(
        periodic: *mut hsp_periodic,
        group: *const u32,
        out: *mut hsp_group_contact,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_windings(
        periodic: *const hsp_periodic,
        out: *mut hsp_winding,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_components(
        periodic: *const hsp_periodic,
        component: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_gradient(
        periodic: *const hsp_periodic,
        request: *const hsp_gradient_request,
        outputs: *mut hsp_periodic_gradient_outputs,
    ) -> i32;
    pub fn hsp_periodic_get_hessian_rows(
        periodic: *const hsp_periodic,
        request: *const hsp_gradient_request,
        first: *mut u32,
        ball: *mut u32,
        block: *mut f64,
        flags: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_query_point(
        periodic: *const hsp_periodic,
        xyz: *const f64,
        out: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_query_ball(
        periodic: *const hsp_periodic,
        xyz: *const f64,
        radius: f64,
        out: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_query_neighbours(
        periodic: *const hsp_periodic,
        ball: u32,
        out: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_query_pairs(
        periodic: *const hsp_periodic,
        flags: u32,
        first: *mut u32,
        out: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_check(periodic: *mut hsp_periodic, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_periodic_get_vertices(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_vertex,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_arcs(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_arc,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_circles(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_circle,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_faces(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_face,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_loops(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_loop,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_loop_arcs(
        periodic: *const hsp_periodic,
        out: *mut hsp_periodic_loop_arc,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_periodic_get_balls(
        periodic: *const hsp_periodic,
        out: *mut hsp_ball,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_surface_limits_init(
        limits: *mut hsp_surface_limits,
        struct_size: u32,
        boundary: *const hsp_boundary,
    ) -> i32;
    pub fn hsp_surface_bytes(limits: *const hsp_surface_limits, bytes: *mut usize) -> i32;
    pub fn hsp_surface_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_surface_limits,
        surface: *mut *mut hsp_surface,
    ) -> i32;
    pub fn hsp_surface_compute(
        surface: *mut hsp_surface,
        boundary: *const hsp_boundary,
        limits: *mut hsp_surface_limits,
    ) -> i32;
    pub fn hsp_surface_compute_shells(
        surface: *mut hsp_surface,
        boundary: *const hsp_boundary,
        shells: *const u32,
        count: u32,
        limits: *mut hsp_surface_limits,
    ) -> i32;
    pub fn hsp_surface_compute_with(
        surface: *mut hsp_surface,
        boundary: *const hsp_boundary,
        request: *const hsp_surface_request,
        limits: *mut hsp_surface_limits,
    ) -> i32;
    pub fn hsp_surface_get_counts(surface: *const hsp_surface, counts: *mut hsp_surface_counts) -> i32;
    pub fn hsp_surface_measure(
        surface: *const hsp_surface,
        totals: *mut hsp_surface_totals,
        balls: *mut hsp_surface_totals,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_surface_measure_with(
        surface: *const hsp_surface,
        request: *const hsp_surface_measure_request,
        totals: *mut hsp_surface_totals,
        balls: *mut hsp_surface_totals,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_surface_get_gradient(
        surface: *const hsp_surface,
        request: *const hsp_gradient_request,
        outputs: *mut hsp_gradient_outputs,
    ) -> i32;
    pub fn hsp_surface_get_part_counts(surface: *const hsp_surface, counts: *mut hsp_surface_part_counts) -> i32;
    pub fn hsp_surface_next(surface: *const hsp_surface, h: u32) -> u32;
    pub fn hsp_surface_previous(surface: *const hsp_surface, h: u32) -> u32;
    pub fn hsp_surface_next_loop(surface: *const hsp_surface, h: u32) -> u32;
    pub fn hsp_surface_origin(surface: *const hsp_surface, h: u32) -> u32;
    pub fn hsp_surface_left(surface: *const hsp_surface, h: u32) -> u32;
    pub fn hsp_surface_get_patches(
        surface: *const hsp_surface,
        first: u32,
        count: u32,
        out: *mut hsp_surface_patch,
    ) -> i32;
    pub fn hsp_surface_get_edges(
        surface: *const hsp_surface,
        first: u32,
        count: u32,
        out: *mut hsp_surface_edge,
    ) -> i32;
    pub fn hsp_surface_get_corners(
        surface: *const hsp_surface,
        first: u32,
        count: u32,
        out: *mut hsp_surface_corner,
    ) -> i32;
    pub fn hsp_surface_get_shells(
        surface: *const hsp_surface,
        out: *mut hsp_surface_shell,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_surface_check(surface: *mut hsp_surface, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_mesh_limits_init(
        limits: *mut hsp_mesh_limits,
        struct_size: u32,
        boundary: *const hsp_boundary,
        edge_length: f64,
    ) -> i32;
    pub fn hsp_mesh_limits_init_surface(
        limits: *mut hsp_mesh_limits,
        struct_size: u32,
        surface: *const hsp_surface,
        edge_length: f64,
    ) -> i32;
    pub fn hsp_mesh_bytes(limits: *const hsp_mesh_limits, bytes: *mut usize) -> i32;
    pub fn hsp_mesh_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_mesh_limits,
        mesh: *mut *mut hsp_mesh,
    ) -> i32;
    pub fn hsp_mesh_compute(
        mesh: *mut hsp_mesh,
        boundary: *const hsp_boundary,
        edge_length: f64,
        limits: *mut hsp_mesh_limits,
    ) -> i32;
    pub fn hsp_mesh_compute_surface(
        mesh: *mut hsp_mesh,
        surface: *const hsp_surface,
        edge_length: f64,
        limits: *mut hsp_mesh_limits,
    ) -> i32;
    pub fn hsp_mesh_compute_with(
        mesh: *mut hsp_mesh,
        boundary: *const hsp_boundary,
        edge_length: f64,
        request: *const hsp_mesh_request,
        limits: *mut hsp_mesh_limits,
    ) -> i32;
    pub fn hsp_mesh_compute_surface_with(
        mesh: *mut hsp_mesh,
        surface: *const hsp_surface,
        edge_length: f64,
        request: *const hsp_mesh_request,
        limits: *mut hsp_mesh_limits,
    ) -> i32;
    pub fn hsp_mesh_get_counts(mesh: *const hsp_mesh, counts: *mut hsp_mesh_counts) -> i32;
    pub fn hsp_mesh_get_vertices(
        mesh: *const hsp_mesh,
        xyz: *mut f64,
        normals: *mut f64,
        areas: *mut f64,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_mesh_get_weights(
        mesh: *const hsp_mesh,
        area: *const f64,
        patches: u32,
        weights: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_mesh_get_triangles(
        mesh: *const hsp_mesh,
        corners: *mut u32,
        kinds: *mut u32,
        patches: *mut u32,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_mesh_get_patch(mesh: *const hsp_mesh, patch: u32, first: *mut u32, count: *mut u32) -> i32;
    pub fn hsp_topology_limits_init(
        limits: *mut hsp_topology_limits,
        struct_size: u32,
        boundary: *const hsp_boundary,
    ) -> i32;
    pub fn hsp_topology_bytes(limits: *const hsp_topology_limits, bytes: *mut usize) -> i32;
    pub fn hsp_topology_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_topology_limits,
        topology: *mut *mut hsp_topology,
    ) -> i32;
    pub fn hsp_topology_compute(
        topology: *mut hsp_topology,
        boundary: *const hsp_boundary,
        limits: *mut hsp_topology_limits,
    ) -> i32;
    pub fn hsp_topology_compute_with(
        topology: *mut hsp_topology,
        boundary: *const hsp_boundary,
        request: *const hsp_topology_request,
        limits: *mut hsp_topology_limits,
    ) -> i32;
    pub fn hsp_topology_get_counts(topology: *const hsp_topology, counts: *mut hsp_topology_counts) -> i32;
    pub fn hsp_topology_get_shells(
        topology: *const hsp_topology,
        out: *mut hsp_shell,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_get_components(
        topology: *const hsp_topology,
        out: *mut hsp_component,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_get_regions(
        topology: *const hsp_topology,
        out: *mut hsp_region,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_get_region_shells(
        topology: *const hsp_topology,
        region: u32,
        shells: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_get_region_balls(
        topology: *const hsp_topology,
        region: u32,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_locate(topology: *const hsp_topology, xyz: *const f64, region: *mut u32) -> i32;
    pub fn hsp_topology_onext(topology: *const hsp_topology, q: u32) -> u32;
    pub fn hsp_topology_lnext(topology: *const hsp_topology, q: u32) -> u32;
    pub fn hsp_topology_origin(topology: *const hsp_topology, q: u32) -> u32;
    pub fn hsp_topology_left(topology: *const hsp_topology, q: u32) -> u32;
    pub fn hsp_topology_get_quad_edges(
        topology: *const hsp_topology,
        first: u32,
        count: u32,
        onext: *mut u32,
        origin: *mut u32,
    ) -> i32;
    pub fn hsp_topology_get_vertices(
        topology: *const hsp_topology,
        first: u32,
        count: u32,
        out: *mut hsp_topology_vertex,
    ) -> i32;
    pub fn hsp_topology_get_edges(
        topology: *const hsp_topology,
        first: u32,
        count: u32,
        out: *mut hsp_topology_edge,
    ) -> i32;
    pub fn hsp_topology_get_simple_faces(
        topology: *const hsp_topology,
        first: u32,
        count: u32,
        out: *mut hsp_simple_face,
    ) -> i32;
    pub fn hsp_topology_get_traversal(
        topology: *const hsp_topology,
        shell: u32,
        faces: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_topology_check(topology: *mut hsp_topology, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_cells_limits_init(limits: *mut hsp_cells_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_cells_bytes(limits: *const hsp_cells_limits, bytes: *mut usize) -> i32;
    pub fn hsp_cells_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_cells_limits,
        cells: *mut *mut hsp_cells,
    ) -> i32;
    pub fn hsp_cells_compute(cells: *mut hsp_cells, model: *const hsp_model, limits: *mut hsp_cells_limits) -> i32;
    pub fn hsp_cells_compute_with(
        cells: *mut hsp_cells,
        model: *const hsp_model,
        request: *const hsp_cells_request,
        limits: *mut hsp_cells_limits,
    ) -> i32;
    pub fn hsp_cells_get_counts(cells: *const hsp_cells, counts: *mut hsp_cells_counts) -> i32;
    pub fn hsp_cells_get_cells(cells: *const hsp_cells, first: u32, count: u32, out: *mut hsp_free_cell) -> i32;
    pub fn hsp_cells_get_neighbours(
        cells: *const hsp_cells,
        cell: u32,
        neighbours: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_cells_get_pairs(cells: *const hsp_cells, first: u32, count: u32, out: *mut hsp_cell_pair) -> i32;
    pub fn hsp_cells_locate(cells: *const hsp_cells, xyz: *const f64, cell: *mut u32) -> i32;
    pub fn hsp_cells_check(
        cells: *mut hsp_cells,
        topology: *const hsp_topology,
        invariant: *mut u32,
        id: *mut u32,
    ) -> i32;
    pub fn hsp_model_arrangement(
        model: *const hsp_model,
        totals: *mut hsp_arrangement,
        of_ball: *mut hsp_arrangement,
        scratch: *mut u32,
        words: u32,
        words_needed: *mut u32,
    ) -> i32;
    pub fn hsp_paths_limits_init(limits: *mut hsp_paths_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_paths_bytes(limits: *const hsp_paths_limits, bytes: *mut usize) -> i32;
    pub fn hsp_paths_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_paths_limits,
        paths: *mut *mut hsp_paths,
    ) -> i32;
    pub fn hsp_paths_compute(paths: *mut hsp_paths, model: *const hsp_model, limits: *mut hsp_paths_limits) -> i32;
    pub fn hsp_paths_compute_with(
        paths: *mut hsp_paths,
        model: *const hsp_model,
        request: *const hsp_paths_request,
        limits: *mut hsp_paths_limits,
    ) -> i32;
    pub fn hsp_paths_find(
        paths: *mut hsp_paths,
        from: *const f64,
        to: *const f64,
        path: *mut hsp_path,
        limits: *mut hsp_paths_limits,
    ) -> i32;
    pub fn hsp_paths_find_with(
        paths: *mut hsp_paths,
        from: *const f64,
        to: *const f64,
        request: *const hsp_paths_request,
        path: *mut hsp_path,
        limits: *mut hsp_paths_limits,
    ) -> i32;
    pub fn hsp_paths_get_points(paths: *const hsp_paths, points: *mut f64, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_pores_limits_init(limits: *mut hsp_pores_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_pores_bytes(limits: *const hsp_pores_limits, bytes: *mut usize) -> i32;
    pub fn hsp_pores_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_pores_limits,
        pores: *mut *mut hsp_pores,
    ) -> i32;
    pub fn hsp_pores_options_init(options: *mut hsp_pores_options, struct_size: u32) -> i32;
    pub fn hsp_pores_compute(
        pores: *mut hsp_pores,
        model: *const hsp_model,
        options: *const hsp_pores_options,
        limits: *mut hsp_pores_limits,
    ) -> i32;
    pub fn hsp_pores_compute_periodic(
        pores: *mut hsp_pores,
        periodic: *const hsp_periodic,
        options: *const hsp_pores_options,
        limits: *mut hsp_pores_limits,
    ) -> i32;
    pub fn hsp_pores_get_counts(pores: *const hsp_pores, counts: *mut hsp_pores_counts) -> i32;
    pub fn hsp_pores_get_maxima(pores: *const hsp_pores, first: u32, count: u32, out: *mut hsp_pore_maximum) -> i32;
    pub fn hsp_pores_get_gates(pores: *const hsp_pores, first: u32, count: u32, out: *mut hsp_pore_gate) -> i32;
    pub fn hsp_pores_get_gate_shifts(
        pores: *const hsp_pores,
        first: u32,
        count: u32,
        out: *mut hsp_pore_gate_shifts,
    ) -> i32;
    pub fn hsp_pores_get_maximum_balls(
        pores: *const hsp_pores,
        maximum: u32,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_gate_balls(
        pores: *const hsp_pores,
        gate: u32,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_maximum_images(
        pores: *const hsp_pores,
        maximum: u32,
        images: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_gate_images(
        pores: *const hsp_pores,
        gate: u32,
        images: *mut hsp_image,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_percolation(pores: *const hsp_pores, percolation: *mut hsp_pore_percolation) -> i32;
    pub fn hsp_pores_get_channels(
        pores: *mut hsp_pores,
        radius: f64,
        out: *mut hsp_pore_channel,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_class_at(pores: *const hsp_pores, maximum: u32, radius: f64, member: *mut u32) -> i32;
    pub fn hsp_pores_gate_between(pores: *const hsp_pores, maximum: u32, other: u32, gate: *mut u32) -> i32;
    pub fn hsp_pores_locate(pores: *const hsp_pores, xyz: *const f64, place: *mut hsp_pore_place) -> i32;
    pub fn hsp_pores_locate_with_shifts(
        pores: *const hsp_pores,
        xyz: *const f64,
        place: *mut hsp_pore_place,
        shifts: *mut hsp_pore_place_shifts,
    ) -> i32;
    pub fn hsp_pores_widest(
        pores: *const hsp_pores,
        from: *const f64,
        to: *const f64,
        passage: *mut hsp_pore_passage,
    ) -> i32;
    pub fn hsp_pores_find_tunnel(
        pores: *mut hsp_pores,
        from: *const f64,
        to: *const f64,
        avoided: *const u32,
        count: u32,
        tunnel: *mut hsp_tunnel,
        limits: *mut hsp_pores_limits,
    ) -> i32;
    pub fn hsp_pores_find_cheapest_tunnel(
        pores: *mut hsp_pores,
        from: *const f64,
        to: *const f64,
        avoided: *const u32,
        count: u32,
        tunnel: *mut hsp_tunnel,
        limits: *mut hsp_pores_limits,
    ) -> i32;
    pub fn hsp_pores_find_tunnel_with(
        pores: *mut hsp_pores,
        from: *const f64,
        to: *const f64,
        avoided: *const u32,
        count: u32,
        request: *const hsp_tunnel_request,
        tunnel: *mut hsp_tunnel,
        limits: *mut hsp_pores_limits,
    ) -> i32;
    pub fn hsp_pores_get_tunnel_route(pores: *const hsp_pores, route: *mut hsp_tunnel_route) -> i32;
    pub fn hsp_pores_get_tunnel_points(
        pores: *const hsp_pores,
        points: *mut hsp_tunnel_point,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_tunnel_point_shifts(
        pores: *const hsp_pores,
        points: *mut hsp_tunnel_point_shifts,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_find_pockets(pores: *mut hsp_pores, narrow: f64, wide: f64, pockets: *mut u32) -> i32;
    pub fn hsp_pores_get_pockets(pores: *const hsp_pores, first: u32, count: u32, out: *mut hsp_pore_pocket) -> i32;
    pub fn hsp_pores_get_pocket_maxima(
        pores: *const hsp_pores,
        pocket: u32,
        maxima: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_pocket_mouths(
        pores: *const hsp_pores,
        pocket: u32,
        gates: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_pocket_balls(
        pores: *const hsp_pores,
        pocket: u32,
        balls: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_plugged_balls(
        pores: *const hsp_pores,
        xyz: *mut f64,
        radius: *mut f64,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_find_regions(
        pores: *mut hsp_pores,
        boundary: *const hsp_boundary,
        access: *mut hsp_pore_access,
        regions: *mut u32,
    ) -> i32;
    pub fn hsp_pores_find_regions_with(
        pores: *mut hsp_pores,
        boundary: *const hsp_boundary,
        request: *const hsp_pores_request,
        access: *mut hsp_pore_access,
        regions: *mut u32,
    ) -> i32;
    pub fn hsp_pores_get_regions(pores: *const hsp_pores, first: u32, count: u32, out: *mut hsp_pore_region) -> i32;
    pub fn hsp_pores_measure_pockets(
        pores: *mut hsp_pores,
        plugged: *mut hsp_pores,
        boundary: *const hsp_boundary,
        out: *mut hsp_pore_pocket_size,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_pores_measure_pockets_with(
        pores: *mut hsp_pores,
        plugged: *mut hsp_pores,
        boundary: *const hsp_boundary,
        request: *const hsp_pores_request,
        out: *mut hsp_pore_pocket_size,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_view_limits_init(limits: *mut hsp_view_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_view_bytes(limits: *const hsp_view_limits, bytes: *mut usize) -> i32;
    pub fn hsp_view_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_view_limits,
        view: *mut *mut hsp_view,
    ) -> i32;
    pub fn hsp_view_options_init(options: *mut hsp_view_options, struct_size: u32) -> i32;
    pub fn hsp_view_options_turn(options: *mut hsp_view_options, x: f64, y: f64, z: f64) -> i32;
    pub fn hsp_view_compute(
        view: *mut hsp_view,
        model: *const hsp_model,
        boundary: *const hsp_boundary,
        options: *const hsp_view_options,
        limits: *mut hsp_view_limits,
    ) -> i32;
    pub fn hsp_view_get_info(view: *const hsp_view, info: *mut hsp_view_info) -> i32;
    pub fn hsp_view_get_pieces(view: *const hsp_view, out: *mut hsp_view_piece, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_view_get_loops(view: *const hsp_view, out: *mut hsp_view_loop, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_view_get_arcs(view: *const hsp_view, out: *mut hsp_view_arc, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_map_limits_init(limits: *mut hsp_map_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_map_bytes(limits: *const hsp_map_limits, bytes: *mut usize) -> i32;
    pub fn hsp_map_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_map_limits,
        map: *mut *mut hsp_map,
    ) -> i32;
    pub fn hsp_map_compute(
        map: *mut hsp_map,
        model: *const hsp_model,
        options: *const hsp_view_options,
        limits: *mut hsp_map_limits,
    ) -> i32;
    pub fn hsp_map_get_info(map: *const hsp_map, info: *mut hsp_map_info) -> i32;
    pub fn hsp_map_next(map: *const hsp_map, h: u32) -> u32;
    pub fn hsp_map_previous(map: *const hsp_map, h: u32) -> u32;
    pub fn hsp_map_next_loop(map: *const hsp_map, h: u32) -> u32;
    pub fn hsp_map_origin(map: *const hsp_map, h: u32) -> u32;
    pub fn hsp_map_left(map: *const hsp_map, h: u32) -> u32;
    pub fn hsp_map_get_vertices(map: *const hsp_map, first: u32, count: u32, out: *mut hsp_map_vertex) -> i32;
    pub fn hsp_map_get_edges(map: *const hsp_map, first: u32, count: u32, out: *mut hsp_map_edge) -> i32;
    pub fn hsp_map_get_faces(map: *const hsp_map, first: u32, count: u32, out: *mut hsp_map_face) -> i32;
    pub fn hsp_map_get_areas(map: *const hsp_map, area: *mut f64, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_map_get_outline(map: *const hsp_map, ball: u32, h: *mut u32, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_map_pick(map: *const hsp_map, x: f64, y: f64, sight: *mut hsp_map_sight) -> i32;
    pub fn hsp_map_get_point(map: *const hsp_map, edge: u32, t: f64, point: *mut hsp_map_point) -> i32;
    pub fn hsp_map_get_pole(map: *const hsp_map, face: u32, pole: *mut hsp_map_pole) -> i32;
    pub fn hsp_map_check(map: *mut hsp_map, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_sticks_limits_init(limits: *mut hsp_sticks_limits, struct_size: u32, balls: u32) -> i32;
    pub fn hsp_sticks_bytes(limits: *const hsp_sticks_limits, bytes: *mut usize) -> i32;
    pub fn hsp_sticks_init(
        memory: *mut c_void,
        bytes: usize,
        limits: *const hsp_sticks_limits,
        sticks: *mut *mut hsp_sticks,
    ) -> i32;
    pub fn hsp_sticks_compute(
        sticks: *mut hsp_sticks,
        model: *const hsp_model,
        options: *const hsp_view_options,
        stick: *const hsp_stick,
        count: u32,
        radius: f64,
        conflict: *mut hsp_sticks_conflict,
        limits: *mut hsp_sticks_limits,
    ) -> i32;
    pub fn hsp_sticks_compute_map(
        sticks: *mut hsp_sticks,
        model: *const hsp_model,
        options: *const hsp_view_options,
        stick: *const hsp_stick,
        count: u32,
        radius: f64,
        conflict: *mut hsp_sticks_conflict,
        limits: *mut hsp_sticks_limits,
    ) -> i32;
    pub fn hsp_sticks_get_info(sticks: *const hsp_sticks, info: *mut hsp_sticks_info) -> i32;
    pub fn hsp_sticks_get_map_info(sticks: *const hsp_sticks, info: *mut hsp_map_info) -> i32;
    pub fn hsp_sticks_get_vertices(sticks: *const hsp_sticks, first: u32, count: u32, out: *mut hsp_map_vertex) -> i32;
    pub fn hsp_sticks_get_edges(sticks: *const hsp_sticks, first: u32, count: u32, out: *mut hsp_map_edge) -> i32;
    pub fn hsp_sticks_get_faces(sticks: *const hsp_sticks, first: u32, count: u32, out: *mut hsp_map_face) -> i32;
    pub fn hsp_sticks_get_areas(sticks: *const hsp_sticks, area: *mut f64, capacity: u32, needed: *mut u32) -> i32;
    pub fn hsp_sticks_pick(sticks: *const hsp_sticks, x: f64, y: f64, sight: *mut hsp_map_sight) -> i32;
    pub fn hsp_sticks_get_outline(
        sticks: *const hsp_sticks,
        ball: u32,
        h: *mut u32,
        capacity: u32,
        needed: *mut u32,
    ) -> i32;
    pub fn hsp_sticks_get_point(sticks: *const hsp_sticks, edge: u32, t: f64, point: *mut hsp_map_point) -> i32;
    pub fn hsp_sticks_get_pole(sticks: *const hsp_sticks, face: u32, pole: *mut hsp_map_pole) -> i32;
    pub fn hsp_sticks_check(sticks: *mut hsp_sticks, invariant: *mut u32, id: *mut u32) -> i32;
    pub fn hsp_picture_ink_width(full_width: f64, gap: f64, width: *mut f64) -> i32;
    pub fn hsp_picture_fog_share(nearest: f64, farthest: f64, mean_radius: f64, depth: f64, share: *mut f64) -> i32;
    pub fn hsp_picture_options_init(options: *mut hsp_picture_options, struct_size: u32) -> i32;
    pub fn hsp_palette_colour(palette: u32, atomic_number: u32, chain: u32) -> u32;
    pub fn hsp_picture_write(
        view: *mut hsp_view,
        colour: *const u32,
        options: *const hsp_picture_options,
        title: *const c_char,
        description: *const c_char,
        sink: Option<hsp_sink>,
        context: *mut c_void,
        bytes: *mut u64,
    ) -> i32;
    pub fn hsp_picture_write_map(
        map: *mut hsp_map,
        colour: *const u32,
        options: *const hsp_picture_options,
        title: *const c_char,
        description: *const c_char,
        sink: Option<hsp_sink>,
        context: *mut c_void,
        bytes: *mut u64,
    ) -> i32;
    pub fn hsp_picture_write_sticks(
        sticks: *mut hsp_sticks,
        colour: *const u32,
        options: *const hsp_picture_options,
        title: *const c_char,
        description: *const c_char,
        sink: Option<hsp_sink>,
        context: *mut c_void,
        bytes: *mut u64,
    ) -> i32;
}
