// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.

use crate::raw::*;

#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct abut_picker {
    _unused: [u8; 0],
}
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_pick {
    pub geometry: abut_geometry_id,
    pub feature: abut_feature,
    pub child: u32,
    pub reserved: u32,
    pub distance: f64,
    pub point: abut_vec3,
    pub normal: abut_vec3,
}
const _: [(); 80] = [(); ::std::mem::size_of::<abut_pick>()];
pub type abut_projection = u32;
pub const ABUT_PROJECTION_PERSPECTIVE: abut_projection = 0;
pub const ABUT_PROJECTION_ORTHOGRAPHIC: abut_projection = 1;
pub type abut_depth_axis = u32;
pub const ABUT_DEPTH_ALONG_RAY: abut_depth_axis = 0;
pub const ABUT_DEPTH_ALONG_AXIS: abut_depth_axis = 1;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_camera {
    pub struct_size: u32,
    pub width: u32,
    pub height: u32,
    pub projection: abut_projection,
    pub pose: abut_pose,
    pub vertical_fov: f64,
    pub near_distance: f64,
    pub far_distance: f64,
    pub vertical_extent: f64,
    pub pixel_aspect: f64,
    pub shift_x: f64,
    pub shift_y: f64,
    pub depth_axis: abut_depth_axis,
    pub reserved: u32,
}
const _: [(); 136] = [(); ::std::mem::size_of::<abut_camera>()];
pub type abut_clip_depth = u32;
pub const ABUT_CLIP_DEPTH_SIGNED: abut_clip_depth = 0;
pub const ABUT_CLIP_DEPTH_UNSIGNED: abut_clip_depth = 1;
pub type abut_picker_flags = u32;
pub const ABUT_PICKER_SENSORS: abut_picker_flags = 1;
pub const ABUT_PICKER_SKIP_BACK_FACES: abut_picker_flags = 2;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_clip_plane {
    pub normal: abut_vec3,
    pub offset: f64,
}
const _: [(); 32] = [(); ::std::mem::size_of::<abut_clip_plane>()];
pub type abut_coherence = u32;
pub const ABUT_COHERENCE_NONE: abut_coherence = 0;
pub const ABUT_COHERENCE_NEIGHBOURS: abut_coherence = 1;
pub type abut_selection = u32;
pub const ABUT_SELECTION_TOUCHING: abut_selection = 0;
pub const ABUT_SELECTION_INSIDE: abut_selection = 1;
pub type abut_snap_kinds = u32;
pub const ABUT_SNAP_VERTEX: abut_snap_kinds = 1;
pub const ABUT_SNAP_MIDPOINT: abut_snap_kinds = 2;
pub const ABUT_SNAP_EDGE: abut_snap_kinds = 4;
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_snap {
    pub geometry: abut_geometry_id,
    pub kind: abut_snap_kinds,
    pub vertices: [u32; 2],
    pub reserved: u32,
    pub parameter: f64,
    pub pixels: f64,
    pub distance: f64,
    pub point: abut_vec3,
}
const _: [(); 72] = [(); ::std::mem::size_of::<abut_snap>()];
#[repr(C)]
#[derive(Debug, Default, Copy, Clone)]
pub struct abut_barycentric {
    pub triangle: u32,
    pub vertices: [u32; 3],
    pub weights: [f64; 3],
}
const _: [(); 40] = [(); ::std::mem::size_of::<abut_barycentric>()];
extern "C" {
    pub fn abut_camera_init(camera: *mut abut_camera, struct_size: u32);
    pub fn abut_camera_look_at(camera: *mut abut_camera, eye: *const abut_vec3, target: *const abut_vec3, up: *const abut_vec3) -> abut_status;
    pub fn abut_camera_set_projection(camera: *mut abut_camera, matrix: *const f64, depth: abut_clip_depth) -> abut_status;
    pub fn abut_camera_ray(camera: *const abut_camera, x: f64, y: f64, out: *mut abut_ray) -> abut_status;
    pub fn abut_picker_create(universe: *mut abut_universe, out: *mut *mut abut_picker) -> abut_status;
    pub fn abut_picker_destroy(picker: *mut abut_picker);
    pub fn abut_picker_update(picker: *mut abut_picker) -> abut_status;
    pub fn abut_picker_set_flags(picker: *mut abut_picker, flags: abut_picker_flags) -> abut_status;
    pub fn abut_picker_set_clip_planes(picker: *mut abut_picker, planes: *const abut_clip_plane, count: usize) -> abut_status;
    pub fn abut_picker_cast_ray(picker: *mut abut_picker, ray: *const abut_ray, filter: *const abut_query_filter, out: *mut abut_pick) -> abut_status;
    pub fn abut_picker_cast_rays(picker: *mut abut_picker, rays: *const abut_ray, count: usize, coherence: abut_coherence, filter: *const abut_query_filter, out: *mut abut_pick) -> abut_status;
    pub fn abut_picker_ray_hits(picker: *mut abut_picker, ray: *const abut_ray, filter: *const abut_query_filter, out: *mut u32) -> abut_status;
    pub fn abut_picker_rays_hit(picker: *mut abut_picker, rays: *const abut_ray, count: usize, coherence: abut_coherence, filter: *const abut_query_filter, out: *mut u32) -> abut_status;
    pub fn abut_picker_cast_ray_all(picker: *mut abut_picker, ray: *const abut_ray, filter: *const abut_query_filter, picks: *mut abut_pick, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_picker_pick_pixel(picker: *mut abut_picker, camera: *const abut_camera, x: f64, y: f64, radius: f64, filter: *const abut_query_filter, out: *mut abut_pick) -> abut_status;
    pub fn abut_picker_render(picker: *mut abut_picker, camera: *const abut_camera, filter: *const abut_query_filter, out: *mut abut_pick, capacity: usize) -> abut_status;
    pub fn abut_picker_select_rectangle(picker: *mut abut_picker, camera: *const abut_camera, x0: f64, y0: f64, x1: f64, y1: f64, selection: abut_selection, filter: *const abut_query_filter, geometries: *mut abut_geometry_id, capacity: usize, count: *mut usize) -> abut_status;
    pub fn abut_picker_snap(picker: *mut abut_picker, camera: *const abut_camera, x: f64, y: f64, radius: f64, kinds: abut_snap_kinds, filter: *const abut_query_filter, out: *mut abut_snap) -> abut_status;
    pub fn abut_picker_barycentric(picker: *mut abut_picker, geometry: abut_geometry_id, face: u32, point: *const abut_vec3, out: *mut abut_barycentric) -> abut_status;
}
