// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.

pub const ABUT_VERSION_MAJOR: u32 = 0;
pub const ABUT_VERSION_MINOR: u32 = 2;
pub const ABUT_VERSION_PATCH: u32 = 0;
pub const ABUT_CONTACT_ID_HASHED: u64 = 9223372036854775808;
pub type abut_status = i32;
pub const ABUT_OK: abut_status = 0;
pub const ABUT_INVALID_ARGUMENT: abut_status = 1;
pub const ABUT_NULL_ARGUMENT: abut_status = 2;
pub const ABUT_NOT_FINITE: abut_status = 3;
pub const ABUT_OUT_OF_RANGE: abut_status = 4;
pub const ABUT_ZERO_VECTOR: abut_status = 5;
pub const ABUT_NOT_UNIT: abut_status = 6;
pub const ABUT_INDEX_OUT_OF_RANGE: abut_status = 7;
pub const ABUT_SIZE_OVERFLOW: abut_status = 8;
pub const ABUT_EMPTY: abut_status = 9;
pub const ABUT_STALE_ID: abut_status = 10;
pub const ABUT_WRONG_STRUCT_SIZE: abut_status = 11;
pub const ABUT_UNKNOWN_VALUE: abut_status = 12;
pub const ABUT_UNSUPPORTED: abut_status = 13;
pub const ABUT_NOT_CONVERGED: abut_status = 14;
pub const ABUT_OUT_OF_MEMORY: abut_status = 15;
pub const ABUT_INTERNAL: abut_status = 16;
pub const ABUT_BUSY: abut_status = 17;
pub type abut_log_level = u32;
pub const ABUT_LOG_NONE: abut_log_level = 0;
pub const ABUT_LOG_ERROR: abut_log_level = 1;
pub const ABUT_LOG_WARNING: abut_log_level = 2;
pub type abut_log = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, level: abut_log_level, message: *const ::std::os::raw::c_char)>;
pub type abut_allocate = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, size: usize, alignment: usize) -> *mut ::std::os::raw::c_void>;
pub type abut_release = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, memory: *mut ::std::os::raw::c_void, size: usize, alignment: usize)>;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_vec3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}
const _: [(); 24] = [(); ::std::mem::size_of::<abut_vec3>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_quat {
    pub w: f64,
    pub x: f64,
    pub y: f64,
    pub z: f64,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_quat>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_pose {
    pub position: abut_vec3,
    pub orientation: abut_quat,
}
const _: [(); 56] = [(); ::std::mem::size_of::<abut_pose>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_aabb {
    pub minimum: abut_vec3,
    pub maximum: abut_vec3,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_aabb>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_part_id {
    pub slot: u32,
    pub generation: u32,
}
const _: [(); 8] = [(); ::std::mem::size_of::<abut_part_id>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_geometry_id {
    pub slot: u32,
    pub generation: u32,
}
const _: [(); 8] = [(); ::std::mem::size_of::<abut_geometry_id>()];
pub type abut_feature_kind = u32;
pub const ABUT_FEATURE_WHOLE: abut_feature_kind = 0;
pub const ABUT_FEATURE_VERTEX: abut_feature_kind = 1;
pub const ABUT_FEATURE_EDGE: abut_feature_kind = 2;
pub const ABUT_FEATURE_FACE: abut_feature_kind = 3;
pub const ABUT_FEATURE_CELL: abut_feature_kind = 4;
pub const ABUT_FEATURE_PARTICLE: abut_feature_kind = 5;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_feature {
    pub kind: abut_feature_kind,
    pub index: u32,
}
const _: [(); 8] = [(); ::std::mem::size_of::<abut_feature>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_shape {
    _unused: [u8; 0],
}
pub type abut_shape_kind = u32;
pub type abut_query = u32;
pub const ABUT_QUERY_DISTANCE: abut_query = 0;
pub const ABUT_QUERY_CONTACTS: abut_query = 1;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_hull_report {
    pub struct_size: u32,
    pub dimension: u32,
    pub point_count: u64,
    pub vertex_count: u64,
    pub edge_count: u64,
    pub face_count: u64,
    pub error: f64,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_hull_report>()];
pub type abut_sides = u32;
pub const ABUT_SIDES_BOTH: abut_sides = 0;
pub const ABUT_SIDES_FRONT: abut_sides = 1;
pub const ABUT_SIDES_SOLID: abut_sides = 2;
pub type abut_mesh_tree = u32;
pub const ABUT_MESH_TREE_AUTO: abut_mesh_tree = 0;
pub const ABUT_MESH_TREE_AABB: abut_mesh_tree = 1;
pub const ABUT_MESH_TREE_OBB: abut_mesh_tree = 2;
pub const ABUT_MESH_TREE_SPHERE: abut_mesh_tree = 3;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_mesh_options {
    pub struct_size: u32,
    pub sides: abut_sides,
    pub corners: u32,
    pub merges_vertices: u32,
    pub merge_distance: f64,
    pub tree: abut_mesh_tree,
    pub reserved: u32,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_mesh_options>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_mesh_report {
    pub struct_size: u32,
    pub reserved: u32,
    pub triangles: u64,
    pub vertices: u64,
    pub merged_vertices: u64,
    pub collapsed_triangles: u64,
    pub duplicate_vertices: u64,
    pub duplicate_triangles: u64,
    pub slivers: u64,
    pub open_edges: u64,
    pub non_manifold_edges: u64,
    pub reversed_triangles: u64,
    pub twisted_patches: u64,
    pub components: u64,
    pub merge_error: f64,
    pub volume: f64,
}
const _: [(); 120] = [(); ::std::mem::size_of::<abut_mesh_report>()];
pub type abut_axis = u32;
pub const ABUT_AXIS_X: abut_axis = 0;
pub const ABUT_AXIS_Y: abut_axis = 1;
pub const ABUT_AXIS_Z: abut_axis = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_uv_grid_options {
    pub struct_size: u32,
    pub sides: abut_sides,
    pub axis_u: abut_axis,
    pub axis_v: abut_axis,
    pub cells_u: u32,
    pub cells_v: u32,
    pub corners: u32,
    pub merges_vertices: u32,
    pub merge_distance: f64,
}
const _: [(); 40] = [(); ::std::mem::size_of::<abut_uv_grid_options>()];
pub type abut_diagonal = u32;
pub const ABUT_DIAGONAL_RISING: abut_diagonal = 0;
pub const ABUT_DIAGONAL_FALLING: abut_diagonal = 1;
pub const ABUT_DIAGONAL_ALTERNATING: abut_diagonal = 2;
pub type abut_below = u32;
pub const ABUT_BELOW_OPEN: abut_below = 0;
pub const ABUT_BELOW_SOLID: abut_below = 1;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_height_field_desc {
    pub struct_size: u32,
    pub diagonal: abut_diagonal,
    pub columns: u32,
    pub rows: u32,
    pub spacing_x: f64,
    pub spacing_y: f64,
    pub heights: *const f64,
    pub below: abut_below,
    pub reserved: u32,
}
impl Default for abut_height_field_desc {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_height_field_desc>()];
pub type abut_interpolation = u32;
pub const ABUT_INTERPOLATION_LINEAR: abut_interpolation = 0;
pub const ABUT_INTERPOLATION_QUADRATIC: abut_interpolation = 1;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_distance_field_desc {
    pub struct_size: u32,
    pub is_inside_out: u32,
    pub columns: u32,
    pub rows: u32,
    pub layers: u32,
    pub interpolation: abut_interpolation,
    pub spacing: abut_vec3,
    pub origin: abut_vec3,
    pub values: *const f64,
}
impl Default for abut_distance_field_desc {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 80] = [(); ::std::mem::size_of::<abut_distance_field_desc>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_distance_field_options {
    pub struct_size: u32,
    pub is_inside_out: u32,
    pub spacing: f64,
    pub band: f64,
    pub interpolation: abut_interpolation,
    pub reserved: u32,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_distance_field_options>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_distance_field_report {
    pub struct_size: u32,
    pub interpolation: abut_interpolation,
    pub block_count: u64,
    pub held_block_count: u64,
    pub error: f64,
    pub far_error: f64,
    pub least_stretch: f64,
    pub most_stretch: f64,
}
const _: [(); 56] = [(); ::std::mem::size_of::<abut_distance_field_report>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_composite_child {
    pub pose: abut_pose,
    pub material: u32,
    pub is_hole: u32,
    pub cut_begin: u32,
    pub cut_end: u32,
}
const _: [(); 72] = [(); ::std::mem::size_of::<abut_composite_child>()];
pub type abut_open_ends = u32;
pub const ABUT_OPEN_TOP: abut_open_ends = 1;
pub const ABUT_OPEN_BOTTOM: abut_open_ends = 2;
pub type abut_open_faces = u32;
pub const ABUT_OPEN_X_HIGH: abut_open_faces = 1;
pub const ABUT_OPEN_X_LOW: abut_open_faces = 2;
pub const ABUT_OPEN_Y_HIGH: abut_open_faces = 4;
pub const ABUT_OPEN_Y_LOW: abut_open_faces = 8;
pub const ABUT_OPEN_Z_HIGH: abut_open_faces = 16;
pub const ABUT_OPEN_Z_LOW: abut_open_faces = 32;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_shape_desc {
    pub struct_size: u32,
    pub kind: abut_shape_kind,
    pub parameters: *const f64,
    pub parameter_count: u64,
    pub reals: *const f64,
    pub real_count: u64,
    pub indices: *const u32,
    pub index_count: u64,
}
impl Default for abut_shape_desc {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 56] = [(); ::std::mem::size_of::<abut_shape_desc>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_ray {
    pub origin: abut_vec3,
    pub direction: abut_vec3,
    pub max_distance: f64,
}
const _: [(); 56] = [(); ::std::mem::size_of::<abut_ray>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_ray_hit {
    pub distance: f64,
    pub point: abut_vec3,
    pub normal: abut_vec3,
    pub feature: abut_feature,
    pub child: u32,
    pub reserved: u32,
}
const _: [(); 72] = [(); ::std::mem::size_of::<abut_ray_hit>()];
pub type abut_algorithm = u32;
pub const ABUT_ALGORITHM_AUTO: abut_algorithm = 0;
pub const ABUT_ALGORITHM_ANALYTIC: abut_algorithm = 1;
pub const ABUT_ALGORITHM_SAT: abut_algorithm = 2;
pub const ABUT_ALGORITHM_GJK_EPA: abut_algorithm = 3;
pub const ABUT_ALGORITHM_LIBCCD_GJK: abut_algorithm = 4;
pub const ABUT_ALGORITHM_LIBCCD_MPR: abut_algorithm = 5;
pub const ABUT_ALGORITHM_FLAT_GROUND: abut_algorithm = 6;
pub const ABUT_ALGORITHM_SEPARATING_TRANSLATION: abut_algorithm = 7;
pub const ABUT_ALGORITHM_SOLID: abut_algorithm = 8;
pub const ABUT_ALGORITHM_FIELD: abut_algorithm = 9;
pub const ABUT_ALGORITHM_HOLE: abut_algorithm = 10;
pub const ABUT_ALGORITHM_RIMS: abut_algorithm = 11;
pub type abut_query_flags = u32;
pub const ABUT_QUERY_WELDS: abut_query_flags = 1;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_query_options {
    pub struct_size: u32,
    pub algorithm: abut_algorithm,
    pub error_bound: f64,
    pub margin: f64,
    pub max_contacts: u32,
    pub max_pair_contacts: u32,
    pub threads: u32,
    pub flags: abut_query_flags,
    pub time_budget: f64,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_query_options>()];
pub type abut_route_flags = u32;
pub const ABUT_ROUTE_CHOSEN: abut_route_flags = 1;
pub const ABUT_ROUTE_IN_TIME: abut_route_flags = 2;
pub const ABUT_ROUTE_IN_BOUND: abut_route_flags = 4;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_route {
    pub algorithm: abut_algorithm,
    pub flags: abut_route_flags,
    pub error_bound: f64,
    pub seconds: f64,
    pub worst_error: f64,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_route>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_distance {
    pub distance: f64,
    pub lower: f64,
    pub upper: f64,
    pub point_a: abut_vec3,
    pub point_b: abut_vec3,
    pub normal: abut_vec3,
    pub algorithm: abut_algorithm,
    pub iterations: u32,
}
const _: [(); 104] = [(); ::std::mem::size_of::<abut_distance>()];
pub type abut_contact_flags = u32;
pub const ABUT_CONTACT_SENSOR: abut_contact_flags = 1;
pub const ABUT_CONTACT_SPECULATIVE: abut_contact_flags = 2;
pub const ABUT_CONTACT_REDUCED_AWAY: abut_contact_flags = 4;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_contact {
    pub geometry_a: abut_geometry_id,
    pub geometry_b: abut_geometry_id,
    pub id: u64,
    pub feature_a: abut_feature,
    pub feature_b: abut_feature,
    pub child_a: u32,
    pub child_b: u32,
    pub point_a: abut_vec3,
    pub point_b: abut_vec3,
    pub normal: abut_vec3,
    pub distance: f64,
    pub toi: f64,
    pub flags: abut_contact_flags,
    pub age: u32,
    pub user_data: u64,
    pub material_a: u32,
    pub material_b: u32,
    pub tangent: abut_vec3,
    pub reserved: u64,
}
const _: [(); 192] = [(); ::std::mem::size_of::<abut_contact>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_pair_memory {
    pub opaque: [u64; 8],
}
const _: [(); 64] = [(); ::std::mem::size_of::<abut_pair_memory>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_first_touch {
    pub touches: u32,
    pub reserved: u32,
    pub lower: f64,
    pub upper: f64,
}
const _: [(); 24] = [(); ::std::mem::size_of::<abut_first_touch>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_elements {
    _unused: [u8; 0],
}
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_element_counts {
    pub vertices: u64,
    pub edges: u64,
    pub triangles: u64,
    pub faces: u64,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_element_counts>()];
pub type abut_closest_method = u32;
pub const ABUT_CLOSEST_FEATURES: abut_closest_method = 0;
pub const ABUT_CLOSEST_OF_FACES: abut_closest_method = 1;
pub const ABUT_CLOSEST_ALL: abut_closest_method = 2;
pub const ABUT_CLOSEST_OF_VERTICES: abut_closest_method = 3;
pub const ABUT_CLOSEST_LOCAL_MINIMA: abut_closest_method = 4;
pub type abut_stencil_kind = u32;
pub const ABUT_STENCIL_VERTEX_FACE: abut_stencil_kind = 0;
pub const ABUT_STENCIL_EDGE_EDGE: abut_stencil_kind = 1;
pub const ABUT_STENCIL_VERTEX_EDGE: abut_stencil_kind = 2;
pub const ABUT_STENCIL_VERTEX_VERTEX: abut_stencil_kind = 3;
pub type abut_stencil_kinds = u32;
pub type abut_elements_flags = u32;
pub const ABUT_ELEMENTS_FRONTS_ONLY: abut_elements_flags = 1;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_elements_options {
    pub struct_size: u32,
    pub method: abut_closest_method,
    pub kinds: abut_stencil_kinds,
    pub flags: abut_elements_flags,
    pub threads: u32,
    pub reserved: u32,
    pub reach: f64,
    pub tolerance: f64,
    pub rest_distance: f64,
    pub cone_angle: f64,
    pub cone_factor: f64,
}
const _: [(); 64] = [(); ::std::mem::size_of::<abut_elements_options>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_stencil {
    pub kind: abut_stencil_kind,
    pub of_a: u32,
    pub element_a: u32,
    pub element_b: u32,
    pub vertices: [u32; 4],
    pub weights: [f64; 4],
    pub normal: abut_vec3,
    pub distance: f64,
    pub toi: f64,
}
const _: [(); 104] = [(); ::std::mem::size_of::<abut_stencil>()];
pub type abut_element_pair_kind = u32;
pub const ABUT_ELEMENT_PAIR_VERTEX_FACE: abut_element_pair_kind = 0;
pub const ABUT_ELEMENT_PAIR_EDGE_EDGE: abut_element_pair_kind = 1;
pub const ABUT_ELEMENT_PAIR_FACE_VERTEX: abut_element_pair_kind = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_element_pair {
    pub kind: abut_element_pair_kind,
    pub a: u32,
    pub b: u32,
}
const _: [(); 12] = [(); ::std::mem::size_of::<abut_element_pair>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_crossing {
    pub edge: u32,
    pub face: u32,
    pub edge_is_of_b: u32,
    pub reserved: u32,
    pub share: f64,
    pub point: abut_vec3,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_crossing>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_movement {
    pub velocity: abut_vec3,
    pub angular_velocity: abut_vec3,
    pub acceleration: abut_vec3,
    pub angular_acceleration: abut_vec3,
    pub centre: abut_vec3,
}
const _: [(); 120] = [(); ::std::mem::size_of::<abut_movement>()];
pub type abut_impact_state = u32;
pub const ABUT_IMPACT_APART: abut_impact_state = 0;
pub const ABUT_IMPACT_TOUCHES: abut_impact_state = 1;
pub const ABUT_IMPACT_STARTS_TOGETHER: abut_impact_state = 2;
pub const ABUT_IMPACT_UNDECIDED: abut_impact_state = 3;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_impact_options {
    pub struct_size: u32,
    pub most_rounds: u32,
    pub tolerance: f64,
    pub margin: f64,
    pub threads: u32,
    pub reserved: u32,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_impact_options>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_impact {
    pub state: abut_impact_state,
    pub rounds: u32,
    pub lower: f64,
    pub upper: f64,
    pub contact: abut_distance,
    pub child_a: u32,
    pub child_b: u32,
}
const _: [(); 136] = [(); ::std::mem::size_of::<abut_impact>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_universe {
    _unused: [u8; 0],
}
pub type abut_broadphase = u32;
pub const ABUT_BROADPHASE_AUTO: abut_broadphase = 0;
pub const ABUT_BROADPHASE_BRUTE: abut_broadphase = 1;
pub const ABUT_BROADPHASE_TREE: abut_broadphase = 2;
pub const ABUT_BROADPHASE_SWEEP_AND_PRUNE: abut_broadphase = 3;
pub const ABUT_BROADPHASE_HASH_GRID: abut_broadphase = 4;
pub type abut_tolerance_mode = u32;
pub const ABUT_TOLERANCE_DEAD_BAND: abut_tolerance_mode = 0;
pub const ABUT_TOLERANCE_MARGIN: abut_tolerance_mode = 1;
pub type abut_event_bits = u32;
pub const ABUT_EVENTS_PAIRS: abut_event_bits = 1;
pub const ABUT_EVENTS_PERSIST: abut_event_bits = 2;
pub const ABUT_EVENTS_CONTACTS: abut_event_bits = 4;
pub const ABUT_EVENTS_ELEMENTS: abut_event_bits = 8;
pub type abut_universe_flags = u32;
pub const ABUT_UNIVERSE_LOCAL_POINTS: abut_universe_flags = 1;
pub const ABUT_UNIVERSE_WELDS: abut_universe_flags = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_universe_options {
    pub struct_size: u32,
    pub broadphase: abut_broadphase,
    pub tolerance_mode: abut_tolerance_mode,
    pub max_contacts: u32,
    pub origin: abut_vec3,
    pub threads: u32,
    pub events: abut_event_bits,
    pub flags: abut_universe_flags,
    pub max_pair_contacts: u32,
}
const _: [(); 56] = [(); ::std::mem::size_of::<abut_universe_options>()];
pub type abut_motion = u32;
pub const ABUT_MOTION_DYNAMIC: abut_motion = 0;
pub const ABUT_MOTION_ANIMATED: abut_motion = 1;
pub const ABUT_MOTION_STATIC: abut_motion = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_part_options {
    pub struct_size: u32,
    pub motion: abut_motion,
    pub pose: abut_pose,
    pub user_data: u64,
}
const _: [(); 72] = [(); ::std::mem::size_of::<abut_part_options>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_sleep {
    pub struct_size: u32,
    pub steps: u32,
    pub linear_speed: f64,
    pub linear_acceleration: f64,
    pub angular_speed: f64,
    pub angular_acceleration: f64,
}
const _: [(); 40] = [(); ::std::mem::size_of::<abut_sleep>()];
pub type abut_parking = u32;
pub const ABUT_PARKING_NONE: abut_parking = 0;
pub const ABUT_PARKING_SHORT_TERM: abut_parking = 1;
pub const ABUT_PARKING_LONG_TERM: abut_parking = 2;
pub type abut_geometry_flags = u32;
pub const ABUT_GEOMETRY_SENSOR: abut_geometry_flags = 1;
pub const ABUT_GEOMETRY_SELF_PAIRS: abut_geometry_flags = 2;
pub const ABUT_GEOMETRY_FAST: abut_geometry_flags = 4;
pub const ABUT_GEOMETRY_SPECULATIVE: abut_geometry_flags = 8;
pub const ABUT_GEOMETRY_KEEPS_SIDE: abut_geometry_flags = 16;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_geometry_options {
    pub struct_size: u32,
    pub flags: abut_geometry_flags,
    pub pose: abut_pose,
    pub tolerance: f64,
    pub user_data: u64,
    pub layers: u64,
    pub mask: u64,
    pub exclusion: u64,
    pub label: u32,
    pub tag: u32,
    pub material: u32,
    pub parking: abut_parking,
}
const _: [(); 120] = [(); ::std::mem::size_of::<abut_geometry_options>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_geometry_info {
    pub struct_size: u32,
    pub kind: abut_shape_kind,
    pub part: abut_part_id,
    pub shape: *mut abut_shape,
    pub pose: abut_pose,
    pub local: abut_pose,
    pub tolerance: f64,
    pub user_data: u64,
    pub layers: u64,
    pub mask: u64,
    pub exclusion: u64,
    pub label: u32,
    pub tag: u32,
    pub material: u32,
    pub parking: abut_parking,
    pub flags: abut_geometry_flags,
    pub reserved: u32,
}
impl Default for abut_geometry_info {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 200] = [(); ::std::mem::size_of::<abut_geometry_info>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_revision {
    pub geometries: u64,
    pub poses: u64,
}
const _: [(); 16] = [(); ::std::mem::size_of::<abut_revision>()];
pub type abut_collidable_kind = u32;
pub const ABUT_COLLIDABLE_GEOMETRY: abut_collidable_kind = 0;
pub const ABUT_COLLIDABLE_PART: abut_collidable_kind = 1;
pub const ABUT_COLLIDABLE_LABEL: abut_collidable_kind = 2;
pub const ABUT_COLLIDABLE_ANY: abut_collidable_kind = 3;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_collidable {
    pub kind: abut_collidable_kind,
    pub slot: u32,
    pub generation: u32,
}
const _: [(); 12] = [(); ::std::mem::size_of::<abut_collidable>()];
pub type abut_rule = u32;
pub const ABUT_RULE_NONE: abut_rule = 0;
pub const ABUT_RULE_ENABLE: abut_rule = 1;
pub const ABUT_RULE_DISABLE: abut_rule = 2;
pub type abut_filter = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, universe: *const abut_universe, geometry_a: abut_geometry_id, geometry_b: abut_geometry_id) -> u32>;
pub type abut_pointer_filter = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, universe: *const abut_universe, geometry_a: *const abut_geometry_id, geometry_b: *const abut_geometry_id) -> u32>;
pub type abut_detail = u32;
pub const ABUT_DETAIL_MANIFOLD: abut_detail = 0;
pub const ABUT_DETAIL_POINT: abut_detail = 1;
pub const ABUT_DETAIL_BOX: abut_detail = 2;
pub const ABUT_DETAIL_TOUCH: abut_detail = 3;
pub const ABUT_DETAIL_ELEMENTS: abut_detail = 4;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_policy {
    pub struct_size: u32,
    pub algorithm: abut_algorithm,
    pub detail: abut_detail,
    pub period: u32,
    pub tolerance: f64,
    pub error_bound: f64,
    pub method: abut_closest_method,
    pub kinds: abut_stencil_kinds,
    pub flags: abut_elements_flags,
    pub reserved: u32,
    pub contact_distance: f64,
    pub rest_distance: f64,
    pub cone_angle: f64,
    pub cone_factor: f64,
    pub time_budget: f64,
}
const _: [(); 88] = [(); ::std::mem::size_of::<abut_policy>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_focus {
    pub struct_size: u32,
    pub near_tag: u32,
    pub far_tag: u32,
    pub reserved: u32,
    pub near_distance: f64,
    pub far_distance: f64,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_focus>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_contact_material {
    pub struct_size: u32,
    pub reserved: u32,
    pub friction_primary: f64,
    pub friction_secondary: f64,
    pub friction_spin: f64,
    pub friction_roll: f64,
    pub static_scale: f64,
    pub slip: f64,
    pub compliance: f64,
    pub damping: f64,
    pub restitution: f64,
    pub restitution_threshold: f64,
    pub adhesive_force: f64,
}
const _: [(); 96] = [(); ::std::mem::size_of::<abut_contact_material>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_backend_pair {
    pub geometry_a: abut_geometry_id,
    pub geometry_b: abut_geometry_id,
    pub shape_a: *const abut_shape,
    pub shape_b: *const abut_shape,
    pub pose_a: abut_pose,
    pub pose_b: abut_pose,
    pub margin: f64,
}
impl Default for abut_backend_pair {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 152] = [(); ::std::mem::size_of::<abut_backend_pair>()];
pub type abut_backend_accepts = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, kind_a: abut_shape_kind, kind_b: abut_shape_kind) -> u32>;
pub type abut_backend_find = ::std::option::Option<unsafe extern "C" fn(context: *mut ::std::os::raw::c_void, universe: *mut abut_universe, pairs: *const abut_backend_pair, count: usize)>;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_backend_contact {
    pub point_a: abut_vec3,
    pub point_b: abut_vec3,
    pub normal: abut_vec3,
    pub feature_a: abut_feature,
    pub feature_b: abut_feature,
    pub child_a: u32,
    pub child_b: u32,
    pub id: u64,
}
const _: [(); 104] = [(); ::std::mem::size_of::<abut_backend_contact>()];
pub type abut_event_kind = u32;
pub const ABUT_EVENT_BEGIN: abut_event_kind = 0;
pub const ABUT_EVENT_PERSIST: abut_event_kind = 1;
pub const ABUT_EVENT_END: abut_event_kind = 2;
pub type abut_event_flags = u32;
pub const ABUT_EVENT_SENSOR: abut_event_flags = 1;
pub const ABUT_EVENT_CONTACT: abut_event_flags = 2;
pub const ABUT_EVENT_ASLEEP: abut_event_flags = 4;
pub const ABUT_EVENT_ELEMENTS: abut_event_flags = 8;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_event {
    pub kind: abut_event_kind,
    pub flags: abut_event_flags,
    pub geometry_a: abut_geometry_id,
    pub geometry_b: abut_geometry_id,
    pub contact_id: u64,
    pub first_contact: u32,
    pub contact_count: u32,
}
const _: [(); 40] = [(); ::std::mem::size_of::<abut_event>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_sleep_change {
    pub part: abut_part_id,
    pub is_asleep: u32,
    pub reserved: u32,
}
const _: [(); 16] = [(); ::std::mem::size_of::<abut_sleep_change>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_local_points {
    pub a: abut_vec3,
    pub b: abut_vec3,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_local_points>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_step_stats {
    pub struct_size: u32,
    pub reserved: u32,
    pub parts: u64,
    pub geometries: u64,
    pub parked: u64,
    pub moved: u64,
    pub candidate_pairs: u64,
    pub filtered_pairs: u64,
    pub examined_pairs: u64,
    pub kept_pairs: u64,
    pub touching_pairs: u64,
    pub contacts: u64,
    pub unsupported_pairs: u64,
    pub events: u64,
    pub bytes: u64,
    pub refresh_microseconds: f64,
    pub broadphase_microseconds: f64,
    pub pair_microseconds: f64,
    pub narrowphase_microseconds: f64,
    pub contact_microseconds: f64,
    pub asleep: u64,
}
const _: [(); 160] = [(); ::std::mem::size_of::<abut_step_stats>()];
pub type abut_apart_reasons = u32;
pub const ABUT_APART_PART: abut_apart_reasons = 1;
pub const ABUT_APART_MOTION: abut_apart_reasons = 2;
pub const ABUT_APART_PARKING: abut_apart_reasons = 4;
pub const ABUT_APART_EXCLUSION: abut_apart_reasons = 8;
pub const ABUT_APART_LAYERS: abut_apart_reasons = 16;
pub const ABUT_APART_RULE: abut_apart_reasons = 32;
pub const ABUT_APART_FILTER: abut_apart_reasons = 64;
pub const ABUT_APART_KINDS: abut_apart_reasons = 128;
pub const ABUT_APART_BOXES: abut_apart_reasons = 256;
pub const ABUT_APART_POLICY: abut_apart_reasons = 512;
pub const ABUT_APART_DETECTION: abut_apart_reasons = 1024;
pub const ABUT_APART_SIDE: abut_apart_reasons = 2048;
pub type abut_finding_code = u32;
pub const ABUT_FINDING_NOTHING_MOVES: abut_finding_code = 0;
pub const ABUT_FINDING_MEETS_NOTHING: abut_finding_code = 1;
pub const ABUT_FINDING_KINDS_UNSUPPORTED: abut_finding_code = 2;
pub const ABUT_FINDING_TOLERANCE_TOO_LARGE: abut_finding_code = 3;
pub const ABUT_FINDING_FAR_FROM_ORIGIN: abut_finding_code = 4;
pub const ABUT_FINDING_EXCLUDED_FROM_ALL: abut_finding_code = 5;
pub const ABUT_FINDING_RULE_DISABLES_ALL: abut_finding_code = 6;
pub const ABUT_FINDING_EXCLUSION_IN_COMMON: abut_finding_code = 7;
pub const ABUT_FINDING_FILTER_KEEPS_NONE: abut_finding_code = 8;
pub const ABUT_FINDING_ALL_PARKED: abut_finding_code = 9;
pub const ABUT_FINDING_ALL_ON_ONE_PART: abut_finding_code = 10;
pub const ABUT_FINDING_INSIDE_OUT: abut_finding_code = 11;
pub const ABUT_FINDING_HOLLOW: abut_finding_code = 12;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_finding {
    pub code: abut_finding_code,
    pub reserved: u32,
    pub geometry: abut_geometry_id,
    pub other: abut_geometry_id,
    pub message: [::std::os::raw::c_char; 168],
}
impl Default for abut_finding {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 192] = [(); ::std::mem::size_of::<abut_finding>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_island {
    pub id: u64,
    pub first_part: u32,
    pub part_count: u32,
}
const _: [(); 16] = [(); ::std::mem::size_of::<abut_island>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_velocity {
    pub linear: abut_vec3,
    pub angular: abut_vec3,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_velocity>()];
pub type abut_velocity_source = u32;
pub const ABUT_VELOCITY_NONE: abut_velocity_source = 0;
pub const ABUT_VELOCITY_GIVEN: abut_velocity_source = 1;
pub const ABUT_VELOCITY_FROM_POSES: abut_velocity_source = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_acceleration {
    pub linear: abut_vec3,
    pub angular: abut_vec3,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_acceleration>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_step_impact {
    pub geometry_a: abut_geometry_id,
    pub geometry_b: abut_geometry_id,
    pub lower: f64,
    pub upper: f64,
    pub first_contact: u32,
    pub contact_count: u32,
    pub is_undecided: u32,
    pub reserved: u32,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_step_impact>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_element_contact {
    pub geometry_a: abut_geometry_id,
    pub geometry_b: abut_geometry_id,
    pub stencil: abut_stencil,
    pub gap: f64,
    pub id: u64,
    pub age: u32,
    pub reserved: u32,
}
const _: [(); 144] = [(); ::std::mem::size_of::<abut_element_contact>()];
pub type abut_query_filter_flags = u32;
pub const ABUT_QUERY_FILTER_SKIP_SENSORS: abut_query_filter_flags = 1;
pub type abut_ray_start = u32;
pub const ABUT_RAY_START_FAR_SIDE: abut_ray_start = 0;
pub const ABUT_RAY_START_SOLID: abut_ray_start = 1;
pub const ABUT_RAY_START_SKIP: abut_ray_start = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_query_filter {
    pub struct_size: u32,
    pub flags: abut_query_filter_flags,
    pub layers: u64,
    pub mask: u64,
    pub ignore_part: abut_part_id,
    pub ignore_geometry: abut_geometry_id,
    pub ray_start: abut_ray_start,
    pub reserved: u32,
}
const _: [(); 48] = [(); ::std::mem::size_of::<abut_query_filter>()];
pub type abut_hit_mode = u32;
pub const ABUT_HIT_NEAREST: abut_hit_mode = 0;
pub const ABUT_HIT_ANY: abut_hit_mode = 1;
pub const ABUT_HIT_ALL: abut_hit_mode = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_query_hit {
    pub geometry: abut_geometry_id,
    pub feature: abut_feature,
    pub child: u32,
    pub reserved: u32,
    pub distance: f64,
    pub point: abut_vec3,
    pub normal: abut_vec3,
}
const _: [(); 80] = [(); ::std::mem::size_of::<abut_query_hit>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_cast_hit {
    pub geometry: abut_geometry_id,
    pub fraction: f64,
    pub contact: abut_distance,
    pub feature_a: abut_feature,
    pub feature_b: abut_feature,
    pub child_a: u32,
    pub child_b: u32,
}
const _: [(); 144] = [(); ::std::mem::size_of::<abut_cast_hit>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_impact_hit {
    pub geometry: abut_geometry_id,
    pub impact: abut_impact,
}
const _: [(); 144] = [(); ::std::mem::size_of::<abut_impact_hit>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_closest {
    pub geometry: abut_geometry_id,
    pub distance: abut_distance,
}
const _: [(); 112] = [(); ::std::mem::size_of::<abut_closest>()];
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_layout_entry {
    pub type_: *const ::std::os::raw::c_char,
    pub field: *const ::std::os::raw::c_char,
    pub offset: u64,
    pub size: u64,
}
impl Default for abut_layout_entry {
    fn default() -> Self {
        unsafe { ::std::mem::zeroed() }
    }
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_layout_entry>()];
extern "C" {
    pub fn abut_set_last_error(status: abut_status, message: *const ::std::os::raw::c_char) -> abut_status;
    pub fn abut_status_name(status: abut_status) -> *const ::std::os::raw::c_char;
    pub fn abut_last_error_message() -> *const ::std::os::raw::c_char;
    pub fn abut_set_log(log: abut_log, context: *mut ::std::os::raw::c_void, most: abut_log_level) -> abut_status;
    pub fn abut_version_string() -> *const ::std::os::raw::c_char;
    pub fn abut_check_version(major: u32, minor: u32) -> abut_status;
    pub fn abut_has_feature(name: *const ::std::os::raw::c_char) -> u32;
    pub fn abut_set_allocator(allocate: abut_allocate, release: abut_release, context: *mut ::std::os::raw::c_void) -> abut_status;
    pub fn abut_memory_in_use(bytes: *mut u64, blocks: *mut u64) -> abut_status;
    pub fn abut_memory_allocate(size: usize, alignment: usize) -> *mut ::std::os::raw::c_void;
    pub fn abut_memory_release(memory: *mut ::std::os::raw::c_void, size: usize, alignment: usize);
    pub fn abut_shape_kind_count() -> usize;
    pub fn abut_shape_kind_at(index: usize) -> abut_shape_kind;
    pub fn abut_shape_kind_by_name(name: *const ::std::os::raw::c_char) -> abut_shape_kind;
    pub fn abut_shape_kind_name(kind: abut_shape_kind) -> *const ::std::os::raw::c_char;
    pub fn abut_shape_kind_parameter_count(kind: abut_shape_kind) -> usize;
    pub fn abut_shape_kind_parameter_name(kind: abut_shape_kind, index: usize) -> *const ::std::os::raw::c_char;
    pub fn abut_pair_support(kind_a: abut_shape_kind, kind_b: abut_shape_kind, query: abut_query, out: *mut u32) -> abut_status;
    pub fn abut_sphere_create(radius: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_box_create(half_x: f64, half_y: f64, half_z: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_capsule_create(radius: f64, half_height: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_cylinder_create(radius: f64, half_height: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_cone_create(radius: f64, half_height: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_ellipsoid_create(radius_x: f64, radius_y: f64, radius_z: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_point_create(out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_segment_create(half_length: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_triangle_create(a: *const abut_vec3, b: *const abut_vec3, c: *const abut_vec3, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_plane_create(normal: *const abut_vec3, offset: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_hull_create(xyz: *const f64, point_count: usize, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_hull_report_init(report: *mut abut_hull_report, struct_size: u32);
    pub fn abut_hull_describe(shape: *const abut_shape, out: *mut abut_hull_report) -> abut_status;
    pub fn abut_mesh_options_init(options: *mut abut_mesh_options, struct_size: u32);
    pub fn abut_mesh_create(xyz: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize, options: *const abut_mesh_options, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_mesh_report_init(report: *mut abut_mesh_report, struct_size: u32);
    pub fn abut_mesh_describe(xyz: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize, options: *const abut_mesh_options, out: *mut abut_mesh_report) -> abut_status;
    pub fn abut_uv_grid_options_init(options: *mut abut_uv_grid_options, struct_size: u32);
    pub fn abut_uv_grid_create(xyz: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize, options: *const abut_uv_grid_options, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_height_field_desc_init(desc: *mut abut_height_field_desc, struct_size: u32);
    pub fn abut_height_field_create(desc: *const abut_height_field_desc, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_distance_field_desc_init(desc: *mut abut_distance_field_desc, struct_size: u32);
    pub fn abut_distance_field_create(desc: *const abut_distance_field_desc, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_distance_field_options_init(options: *mut abut_distance_field_options, struct_size: u32);
    pub fn abut_distance_field_from_mesh(xyz: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize, options: *const abut_distance_field_options, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_distance_field_report_init(report: *mut abut_distance_field_report, struct_size: u32);
    pub fn abut_distance_field_describe(shape: *const abut_shape, out: *mut abut_distance_field_report) -> abut_status;
    pub fn abut_particles_create(xyz: *const f64, count: usize, radius: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_particles_create_with_radii(xyz: *const f64, radii: *const f64, count: usize, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_composite_create(children: *const *const abut_shape, poses: *const abut_pose, count: usize, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_composite_create_with_materials(children: *const *const abut_shape, poses: *const abut_pose, materials: *const u32, count: usize, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_composite_children(shape: *const abut_shape, children: *mut abut_composite_child, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_composite_child_shape(shape: *const abut_shape, child: u32, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_sphere_hole_create(radius: f64, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_cylinder_hole_create(radius: f64, half_height: f64, open_ends: abut_open_ends, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_box_hole_create(half_x: f64, half_y: f64, half_z: f64, open_faces: abut_open_faces, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_shape_desc_init(desc: *mut abut_shape_desc, struct_size: u32);
    pub fn abut_shape_create(desc: *const abut_shape_desc, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_shape_retain(shape: *mut abut_shape);
    pub fn abut_shape_release(shape: *mut abut_shape);
    pub fn abut_shape_kind_of(shape: *const abut_shape) -> abut_shape_kind;
    pub fn abut_shape_parameters(shape: *const abut_shape, parameters: *mut f64, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_shape_aabb(shape: *const abut_shape, pose: *const abut_pose, out: *mut abut_aabb) -> abut_status;
    pub fn abut_shape_triangles(shape: *const abut_shape, xyz: *mut f64, vertex_capacity: usize, vertex_count: *mut usize, triangles: *mut u32, triangle_capacity: usize, triangle_count: *mut usize) -> abut_status;
    pub fn abut_shape_prepare(shape: *const abut_shape, threads: u32) -> abut_status;
    pub fn abut_shape_cast_ray(shape: *const abut_shape, pose: *const abut_pose, ray: *const abut_ray, hit: *mut abut_ray_hit, found: *mut u32) -> abut_status;
    pub fn abut_query_options_init(options: *mut abut_query_options, struct_size: u32);
    pub fn abut_pair_routes(kind_a: abut_shape_kind, kind_b: abut_shape_kind, query: abut_query, options: *const abut_query_options, routes: *mut abut_route, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_routes_load(text: *const ::std::os::raw::c_char) -> abut_status;
    pub fn abut_contact_validate(contact: *const abut_contact) -> abut_status;
    pub fn abut_pair_distance(a: *const abut_shape, pose_a: *const abut_pose, b: *const abut_shape, pose_b: *const abut_pose, options: *const abut_query_options, out: *mut abut_distance) -> abut_status;
    pub fn abut_pairs_distance(a: *const abut_shape, poses_a: *const abut_pose, b: *const abut_shape, poses_b: *const abut_pose, count: usize, options: *const abut_query_options, out: *mut abut_distance) -> abut_status;
    pub fn abut_pair_contacts(a: *const abut_shape, pose_a: *const abut_pose, b: *const abut_shape, pose_b: *const abut_pose, options: *const abut_query_options, contacts: *mut abut_contact, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_pair_distance_with_memory(a: *const abut_shape, pose_a: *const abut_pose, b: *const abut_shape, pose_b: *const abut_pose, options: *const abut_query_options, memory: *mut abut_pair_memory, out: *mut abut_distance) -> abut_status;
    pub fn abut_pairs_distance_with_memories(a: *const abut_shape, poses_a: *const abut_pose, b: *const abut_shape, poses_b: *const abut_pose, count: usize, options: *const abut_query_options, memories: *mut abut_pair_memory, out: *mut abut_distance) -> abut_status;
    pub fn abut_pairs_contacts(a: *const abut_shape, poses_a: *const abut_pose, b: *const abut_shape, poses_b: *const abut_pose, pair_count: usize, options: *const abut_query_options, offsets: *mut u64, contacts: *mut abut_contact, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_pair_contacts_with_memory(a: *const abut_shape, pose_a: *const abut_pose, b: *const abut_shape, pose_b: *const abut_pose, options: *const abut_query_options, memory: *mut abut_pair_memory, contacts: *mut abut_contact, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_pairs_contacts_with_memories(a: *const abut_shape, poses_a: *const abut_pose, b: *const abut_shape, poses_b: *const abut_pose, pair_count: usize, options: *const abut_query_options, memories: *mut abut_pair_memory, offsets: *mut u64, contacts: *mut abut_contact, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_pair_overlaps(a: *const abut_shape, pose_a: *const abut_pose, b: *const abut_shape, pose_b: *const abut_pose, options: *const abut_query_options, out: *mut u32) -> abut_status;
    pub fn abut_pairs_overlap(shapes_a: *const *const abut_shape, poses_a: *const abut_pose, shapes_b: *const *const abut_shape, poses_b: *const abut_pose, count: usize, options: *const abut_query_options, out: *mut u32) -> abut_status;
    pub fn abut_vertices_touch_faces(start: *const f64, end: *const f64, count: usize, separation: f64, tolerance: f64, out: *mut abut_first_touch) -> abut_status;
    pub fn abut_edges_touch_edges(start: *const f64, end: *const f64, count: usize, separation: f64, tolerance: f64, out: *mut abut_first_touch) -> abut_status;
    pub fn abut_elements_create(shape: *const abut_shape, out: *mut *mut abut_elements) -> abut_status;
    pub fn abut_elements_destroy(elements: *mut abut_elements);
    pub fn abut_elements_count(elements: *const abut_elements, out: *mut abut_element_counts) -> abut_status;
    pub fn abut_elements_edges(elements: *const abut_elements, vertices: *mut u32, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_elements_set_vertices(elements: *mut abut_elements, start: *const f64, end: *const f64, vertex_count: usize) -> abut_status;
    pub fn abut_elements_options_init(options: *mut abut_elements_options, struct_size: u32);
    pub fn abut_elements_candidates(a: *mut abut_elements, b: *mut abut_elements, options: *const abut_elements_options, pairs: *mut abut_element_pair, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_elements_closest(a: *mut abut_elements, b: *mut abut_elements, options: *const abut_elements_options, stencils: *mut abut_stencil, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_elements_first_touches(a: *mut abut_elements, b: *mut abut_elements, options: *const abut_elements_options, stencils: *mut abut_stencil, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_elements_crossings(a: *mut abut_elements, b: *mut abut_elements, options: *const abut_elements_options, crossings: *mut abut_crossing, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_movement_between(start: *const abut_pose, end: *const abut_pose, centre: *const abut_vec3, duration: f64, out: *mut abut_movement) -> abut_status;
    pub fn abut_impact_options_init(options: *mut abut_impact_options, struct_size: u32);
    pub fn abut_pair_time_of_impact(a: *const abut_shape, pose_a: *const abut_pose, movement_a: *const abut_movement, b: *const abut_shape, pose_b: *const abut_pose, movement_b: *const abut_movement, duration: f64, options: *const abut_impact_options, out: *mut abut_impact) -> abut_status;
    pub fn abut_pairs_time_of_impact(a: *const abut_shape, poses_a: *const abut_pose, movements_a: *const abut_movement, b: *const abut_shape, poses_b: *const abut_pose, movements_b: *const abut_movement, count: usize, duration: f64, options: *const abut_impact_options, out: *mut abut_impact) -> abut_status;
    pub fn abut_universe_options_init(options: *mut abut_universe_options, struct_size: u32);
    pub fn abut_universe_create(options: *const abut_universe_options, out: *mut *mut abut_universe) -> abut_status;
    pub fn abut_universe_destroy(universe: *mut abut_universe);
    pub fn abut_universe_save(universe: *const abut_universe, bytes: *mut ::std::os::raw::c_void, capacity: usize, size: *mut usize) -> abut_status;
    pub fn abut_universe_load(bytes: *const ::std::os::raw::c_void, size: usize, out: *mut *mut abut_universe) -> abut_status;
    pub fn abut_part_options_init(options: *mut abut_part_options, struct_size: u32);
    pub fn abut_part_create(universe: *mut abut_universe, options: *const abut_part_options, out: *mut abut_part_id) -> abut_status;
    pub fn abut_parts_create(universe: *mut abut_universe, options: *const abut_part_options, count: usize, out: *mut abut_part_id) -> abut_status;
    pub fn abut_part_destroy(universe: *mut abut_universe, part: abut_part_id) -> abut_status;
    pub fn abut_parts_destroy(universe: *mut abut_universe, parts: *const abut_part_id, count: usize) -> abut_status;
    pub fn abut_part_set_pose(universe: *mut abut_universe, part: abut_part_id, pose: *const abut_pose) -> abut_status;
    pub fn abut_parts_set_poses(universe: *mut abut_universe, parts: *const abut_part_id, poses: *const abut_pose, count: usize) -> abut_status;
    pub fn abut_part_pose(universe: *const abut_universe, part: abut_part_id, out: *mut abut_pose) -> abut_status;
    pub fn abut_parts_poses(universe: *const abut_universe, parts: *const abut_part_id, count: usize, out: *mut abut_pose) -> abut_status;
    pub fn abut_part_set_motion(universe: *mut abut_universe, part: abut_part_id, motion: abut_motion) -> abut_status;
    pub fn abut_parts_set_motions(universe: *mut abut_universe, parts: *const abut_part_id, motions: *const abut_motion, count: usize) -> abut_status;
    pub fn abut_part_motion(universe: *const abut_universe, part: abut_part_id, out: *mut abut_motion) -> abut_status;
    pub fn abut_part_user_data(universe: *const abut_universe, part: abut_part_id, out: *mut u64) -> abut_status;
    pub fn abut_part_set_user_data(universe: *mut abut_universe, part: abut_part_id, user_data: u64) -> abut_status;
    pub fn abut_parts_set_user_data(universe: *mut abut_universe, parts: *const abut_part_id, user_data: *const u64, count: usize) -> abut_status;
    pub fn abut_part_geometries(universe: *const abut_universe, part: abut_part_id, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_sleep_init(sleep: *mut abut_sleep, struct_size: u32);
    pub fn abut_part_set_sleep(universe: *mut abut_universe, part: abut_part_id, sleep: *const abut_sleep) -> abut_status;
    pub fn abut_parts_set_sleep(universe: *mut abut_universe, parts: *const abut_part_id, sleeps: *const abut_sleep, count: usize) -> abut_status;
    pub fn abut_part_is_asleep(universe: *const abut_universe, part: abut_part_id, out: *mut u32) -> abut_status;
    pub fn abut_part_wake(universe: *mut abut_universe, part: abut_part_id) -> abut_status;
    pub fn abut_parts_wake(universe: *mut abut_universe, parts: *const abut_part_id, count: usize) -> abut_status;
    pub fn abut_geometry_options_init(options: *mut abut_geometry_options, struct_size: u32);
    pub fn abut_geometry_create(universe: *mut abut_universe, part: abut_part_id, shape: *const abut_shape, options: *const abut_geometry_options, out: *mut abut_geometry_id) -> abut_status;
    pub fn abut_geometries_create(universe: *mut abut_universe, parts: *const abut_part_id, shapes: *const *const abut_shape, options: *const abut_geometry_options, count: usize, out: *mut abut_geometry_id) -> abut_status;
    pub fn abut_geometry_destroy(universe: *mut abut_universe, geometry: abut_geometry_id) -> abut_status;
    pub fn abut_geometries_destroy(universe: *mut abut_universe, geometries: *const abut_geometry_id, count: usize) -> abut_status;
    pub fn abut_geometry_set_options(universe: *mut abut_universe, geometry: abut_geometry_id, options: *const abut_geometry_options) -> abut_status;
    pub fn abut_geometries_set_options(universe: *mut abut_universe, geometries: *const abut_geometry_id, options: *const abut_geometry_options, count: usize) -> abut_status;
    pub fn abut_geometry_set_user_data(universe: *mut abut_universe, geometry: abut_geometry_id, user_data: u64) -> abut_status;
    pub fn abut_geometries_set_user_data(universe: *mut abut_universe, geometries: *const abut_geometry_id, user_data: *const u64, count: usize) -> abut_status;
    pub fn abut_geometry_set_shape(universe: *mut abut_universe, geometry: abut_geometry_id, shape: *const abut_shape) -> abut_status;
    pub fn abut_geometries_set_shapes(universe: *mut abut_universe, geometries: *const abut_geometry_id, shapes: *const *const abut_shape, count: usize) -> abut_status;
    pub fn abut_geometry_set_parameters(universe: *mut abut_universe, geometry: abut_geometry_id, parameters: *const f64, parameter_count: usize) -> abut_status;
    pub fn abut_geometries_set_parameters(universe: *mut abut_universe, geometries: *const abut_geometry_id, parameters: *const f64, parameter_count: usize, count: usize) -> abut_status;
    pub fn abut_geometry_set_heights(universe: *mut abut_universe, geometry: abut_geometry_id, column: u32, row: u32, columns: u32, rows: u32, heights: *const f64) -> abut_status;
    pub fn abut_geometry_set_field_values(universe: *mut abut_universe, geometry: abut_geometry_id, column: u32, row: u32, layer: u32, columns: u32, rows: u32, layers: u32, values: *const f64) -> abut_status;
    pub fn abut_geometry_set_field_lattice(universe: *mut abut_universe, geometry: abut_geometry_id, columns: u32, rows: u32, layers: u32, xyz: *const f64) -> abut_status;
    pub fn abut_geometry_set_particles(universe: *mut abut_universe, geometry: abut_geometry_id, first: usize, xyz: *const f64, radii: *const f64, count: usize) -> abut_status;
    pub fn abut_geometry_set_vertices(universe: *mut abut_universe, geometry: abut_geometry_id, first: usize, xyz: *const f64, count: usize) -> abut_status;
    pub fn abut_geometry_set_vertices_at(universe: *mut abut_universe, geometry: abut_geometry_id, vertices: *const u32, xyz: *const f64, count: usize) -> abut_status;
    pub fn abut_geometry_vertices(universe: *const abut_universe, geometry: abut_geometry_id, xyz: *mut *const f64, count: *mut usize) -> abut_status;
    pub fn abut_geometry_next_vertices(universe: *mut abut_universe, geometry: abut_geometry_id, xyz: *mut *mut f64, count: *mut usize) -> abut_status;
    pub fn abut_geometry_advance(universe: *mut abut_universe, geometry: abut_geometry_id) -> abut_status;
    pub fn abut_geometries_advance(universe: *mut abut_universe, geometries: *const abut_geometry_id, count: usize) -> abut_status;
    pub fn abut_geometry_remove_triangles(universe: *mut abut_universe, geometry: abut_geometry_id, triangles: *const u32, count: usize) -> abut_status;
    pub fn abut_geometry_set_mesh(universe: *mut abut_universe, geometry: abut_geometry_id, xyz: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize) -> abut_status;
    pub fn abut_geometry_shape(universe: *const abut_universe, geometry: abut_geometry_id, out: *mut *mut abut_shape) -> abut_status;
    pub fn abut_geometry_park(universe: *mut abut_universe, geometry: abut_geometry_id, parking: abut_parking) -> abut_status;
    pub fn abut_geometries_park(universe: *mut abut_universe, geometries: *const abut_geometry_id, count: usize, parking: abut_parking) -> abut_status;
    pub fn abut_geometry_info_init(info: *mut abut_geometry_info, struct_size: u32);
    pub fn abut_geometry_describe(universe: *const abut_universe, geometry: abut_geometry_id, out: *mut abut_geometry_info) -> abut_status;
    pub fn abut_geometries_poses(universe: *const abut_universe, geometries: *const abut_geometry_id, count: usize, out: *mut abut_pose) -> abut_status;
    pub fn abut_universe_parts(universe: *const abut_universe, parts: *mut abut_part_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_geometries(universe: *const abut_universe, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_revision(universe: *const abut_universe, out: *mut abut_revision) -> abut_status;
    pub fn abut_universe_counters(universe: *const abut_universe, geometries: *mut *const u64, poses: *mut *const u64) -> abut_status;
    pub fn abut_universe_changes(universe: *const abut_universe, since: *const abut_revision, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize, is_known: *mut u32) -> abut_status;
    pub fn abut_rule_set(universe: *mut abut_universe, a: *const abut_collidable, b: *const abut_collidable, rule: abut_rule) -> abut_status;
    pub fn abut_rules_clear(universe: *mut abut_universe) -> abut_status;
    pub fn abut_rule_between(universe: *const abut_universe, geometry_a: abut_geometry_id, geometry_b: abut_geometry_id, rule: *mut abut_rule, a: *mut abut_collidable, b: *mut abut_collidable) -> abut_status;
    pub fn abut_universe_set_filter(universe: *mut abut_universe, filter: abut_filter, context: *mut ::std::os::raw::c_void) -> abut_status;
    pub fn abut_universe_set_pointer_filter(universe: *mut abut_universe, filter: abut_pointer_filter, context: *mut ::std::os::raw::c_void) -> abut_status;
    pub fn abut_universe_refilter(universe: *mut abut_universe) -> abut_status;
    pub fn abut_policy_init(policy: *mut abut_policy, struct_size: u32);
    pub fn abut_policy_set(universe: *mut abut_universe, tag_a: u32, tag_b: u32, policy: *const abut_policy) -> abut_status;
    pub fn abut_policy_get(universe: *const abut_universe, tag_a: u32, tag_b: u32, out: *mut abut_policy) -> abut_status;
    pub fn abut_focus_init(focus: *mut abut_focus, struct_size: u32);
    pub fn abut_universe_set_focus(universe: *mut abut_universe, focus: *const abut_focus, centres: *const abut_vec3, count: usize) -> abut_status;
    pub fn abut_contact_material_init(material: *mut abut_contact_material, struct_size: u32);
    pub fn abut_material_pair_set(universe: *mut abut_universe, material_a: u32, material_b: u32, row: *const abut_contact_material) -> abut_status;
    pub fn abut_material_pair_get(universe: *const abut_universe, material_a: u32, material_b: u32, out: *mut abut_contact_material) -> abut_status;
    pub fn abut_backend_set(universe: *mut abut_universe, accepts: abut_backend_accepts, find: abut_backend_find, context: *mut ::std::os::raw::c_void) -> abut_status;
    pub fn abut_backend_answer(universe: *mut abut_universe, pair: usize, contacts: *const abut_backend_contact, count: usize) -> abut_status;
    pub fn abut_universe_step(universe: *mut abut_universe, dt: f64) -> abut_status;
    pub fn abut_universe_detect_all(universe: *mut abut_universe) -> abut_status;
    pub fn abut_universe_detect_changed(universe: *mut abut_universe) -> abut_status;
    pub fn abut_universe_detect_pairs(universe: *mut abut_universe, a: *const abut_geometry_id, b: *const abut_geometry_id, count: usize) -> abut_status;
    pub fn abut_universe_detect_region(universe: *mut abut_universe, region: *const abut_aabb) -> abut_status;
    pub fn abut_universe_refresh(universe: *mut abut_universe) -> abut_status;
    pub fn abut_universe_events(universe: *const abut_universe, events: *mut *const abut_event, count: *mut usize) -> abut_status;
    pub fn abut_universe_sleep_changes(universe: *const abut_universe, changes: *mut *const abut_sleep_change, count: *mut usize) -> abut_status;
    pub fn abut_universe_hash(universe: *const abut_universe, out: *mut u64) -> abut_status;
    pub fn abut_universe_contacts(universe: *const abut_universe, contacts: *mut *const abut_contact, count: *mut usize) -> abut_status;
    pub fn abut_universe_local_points(universe: *const abut_universe, points: *mut *const abut_local_points, count: *mut usize) -> abut_status;
    pub fn abut_contacts_set_user_data(universe: *mut abut_universe, user_data: *const u64, count: usize) -> abut_status;
    pub fn abut_step_stats_init(stats: *mut abut_step_stats, struct_size: u32);
    pub fn abut_universe_stats(universe: *const abut_universe, out: *mut abut_step_stats) -> abut_status;
    pub fn abut_universe_explain(universe: *const abut_universe, text: *mut ::std::os::raw::c_char, capacity: usize, needed: *mut usize) -> abut_status;
    pub fn abut_universe_explain_json(universe: *const abut_universe, text: *mut ::std::os::raw::c_char, capacity: usize, needed: *mut usize) -> abut_status;
    pub fn abut_universe_why_apart(universe: *const abut_universe, geometry_a: abut_geometry_id, geometry_b: abut_geometry_id, out: *mut abut_apart_reasons) -> abut_status;
    pub fn abut_universe_validate(universe: *const abut_universe, findings: *mut abut_finding, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_follow_islands(universe: *mut abut_universe, are_followed: u32) -> abut_status;
    pub fn abut_universe_islands(universe: *const abut_universe, islands: *mut *const abut_island, count: *mut usize) -> abut_status;
    pub fn abut_universe_island_parts(universe: *const abut_universe, parts: *mut *const abut_part_id, count: *mut usize) -> abut_status;
    pub fn abut_part_island(universe: *const abut_universe, part: abut_part_id, out: *mut abut_island) -> abut_status;
    pub fn abut_part_set_velocity(universe: *mut abut_universe, part: abut_part_id, velocity: *const abut_velocity) -> abut_status;
    pub fn abut_parts_set_velocities(universe: *mut abut_universe, parts: *const abut_part_id, velocities: *const abut_velocity, count: usize) -> abut_status;
    pub fn abut_part_measure_velocity(universe: *mut abut_universe, part: abut_part_id) -> abut_status;
    pub fn abut_parts_measure_velocities(universe: *mut abut_universe, parts: *const abut_part_id, count: usize) -> abut_status;
    pub fn abut_part_velocity(universe: *const abut_universe, part: abut_part_id, out: *mut abut_velocity, source: *mut abut_velocity_source) -> abut_status;
    pub fn abut_parts_velocities(universe: *const abut_universe, parts: *const abut_part_id, count: usize, out: *mut abut_velocity) -> abut_status;
    pub fn abut_part_set_acceleration(universe: *mut abut_universe, part: abut_part_id, acceleration: *const abut_acceleration) -> abut_status;
    pub fn abut_parts_set_accelerations(universe: *mut abut_universe, parts: *const abut_part_id, accelerations: *const abut_acceleration, count: usize) -> abut_status;
    pub fn abut_parts_accelerations(universe: *const abut_universe, parts: *const abut_part_id, count: usize, out: *mut abut_acceleration) -> abut_status;
    pub fn abut_universe_impacts(universe: *const abut_universe, impacts: *mut *const abut_step_impact, count: *mut usize) -> abut_status;
    pub fn abut_universe_advance_to_first_impact(universe: *mut abut_universe, dt: f64, out: *mut abut_step_impact) -> abut_status;
    pub fn abut_universe_element_contacts(universe: *const abut_universe, contacts: *mut *const abut_element_contact, count: *mut usize) -> abut_status;
    pub fn abut_universe_attach(universe: *const abut_universe, name: *const ::std::os::raw::c_char) -> abut_status;
    pub fn abut_universe_detach(universe: *const abut_universe, name: *const ::std::os::raw::c_char) -> abut_status;
    pub fn abut_query_filter_init(filter: *mut abut_query_filter, struct_size: u32);
    pub fn abut_universe_cast_ray(universe: *const abut_universe, ray: *const abut_ray, filter: *const abut_query_filter, mode: abut_hit_mode, hits: *mut abut_query_hit, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_cast_rays(universe: *const abut_universe, rays: *const abut_ray, count: usize, filter: *const abut_query_filter, hits: *mut abut_query_hit) -> abut_status;
    pub fn abut_universe_cast_shape(universe: *const abut_universe, shape: *const abut_shape, pose: *const abut_pose, displacement: *const abut_vec3, filter: *const abut_query_filter, mode: abut_hit_mode, hits: *mut abut_cast_hit, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_cast_shapes(universe: *const abut_universe, shapes: *const *const abut_shape, poses: *const abut_pose, displacements: *const abut_vec3, count: usize, filter: *const abut_query_filter, hits: *mut abut_cast_hit) -> abut_status;
    pub fn abut_universe_cast_movement(universe: *const abut_universe, shape: *const abut_shape, pose: *const abut_pose, movement: *const abut_movement, duration: f64, options: *const abut_impact_options, filter: *const abut_query_filter, mode: abut_hit_mode, hits: *mut abut_impact_hit, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_cast_movements(universe: *const abut_universe, shapes: *const *const abut_shape, poses: *const abut_pose, movements: *const abut_movement, count: usize, duration: f64, options: *const abut_impact_options, filter: *const abut_query_filter, hits: *mut abut_impact_hit) -> abut_status;
    pub fn abut_universe_overlaps(universe: *const abut_universe, shape: *const abut_shape, pose: *const abut_pose, filter: *const abut_query_filter, margin: f64, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_overlaps_of_each(universe: *const abut_universe, shapes: *const *const abut_shape, poses: *const abut_pose, query_count: usize, filter: *const abut_query_filter, margin: f64, offsets: *mut u64, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_at_point(universe: *const abut_universe, position: *const abut_vec3, filter: *const abut_query_filter, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_at_points(universe: *const abut_universe, positions: *const abut_vec3, query_count: usize, filter: *const abut_query_filter, offsets: *mut u64, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_universe_closest(universe: *const abut_universe, shape: *const abut_shape, pose: *const abut_pose, max_distance: f64, filter: *const abut_query_filter, out: *mut abut_closest, found: *mut u32) -> abut_status;
    pub fn abut_universe_closest_to_each(universe: *const abut_universe, shapes: *const *const abut_shape, poses: *const abut_pose, count: usize, max_distance: f64, filter: *const abut_query_filter, out: *mut abut_closest) -> abut_status;
    pub fn abut_pair_cast(a: *const abut_shape, pose_a: *const abut_pose, displacement_a: *const abut_vec3, b: *const abut_shape, pose_b: *const abut_pose, displacement_b: *const abut_vec3, options: *const abut_query_options, hit: *mut abut_cast_hit, found: *mut u32) -> abut_status;
    pub fn abut_pairs_cast(a: *const abut_shape, poses_a: *const abut_pose, displacements_a: *const abut_vec3, b: *const abut_shape, poses_b: *const abut_pose, displacements_b: *const abut_vec3, count: usize, options: *const abut_query_options, hits: *mut abut_cast_hit) -> abut_status;
    pub fn abut_layout_count() -> usize;
    pub fn abut_layout_at(index: usize, out: *mut abut_layout_entry) -> abut_status;
}
