// SPDX-License-Identifier: Apache-2.0
//! Cameras and pickers. Pictures have x to the right and y down, in pixels; (0.5, 0.5) is the centre of the first one.

use crate::error::{check, Error};
use crate::meeting::QueryFilter;
use crate::ray::{Hit, Ray};
use crate::value::{blank, fill, mirror, raw_mut, raw_of, raw_slice, raw_slice_mut, GeometryId, Pose, Vec3};
use crate::{raw_picking as raw, Result, Universe};
use std::ptr::null_mut;

/// A camera, which looks along its local -Z with local +Y up. Fields are those of `abut_camera`.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// As C has it: `width`, `height` and the rest may be set, and are checked when the camera is used.
    pub fields: raw::abut_camera,
}

impl Camera {
    /// A perspective camera at the origin, with so many pixels.
    pub fn new(width: u32, height: u32) -> Camera {
        let mut fields = blank_camera();
        // SAFETY: the struct is written during the call.
        unsafe { raw::abut_camera_init(&mut fields, std::mem::size_of::<raw::abut_camera>() as u32) };
        fields.width = width;
        fields.height = height;
        Camera { fields }
    }

    /// Places the camera at `eye`, so that `target` is in the middle of the picture and `up` is upwards.
    pub fn look_at(&mut self, eye: Vec3, target: Vec3, up: Vec3) -> Result<()> {
        // SAFETY: all is read or written during the call.
        check(unsafe { raw::abut_camera_look_at(&mut self.fields, raw_of(&eye), raw_of(&target), raw_of(&up)) })
    }

    /// The ray through a point of the picture.
    pub fn ray(&self, x: f64, y: f64) -> Result<Ray> {
        let mut out = blank();
        // SAFETY: see look_at.
        check(unsafe { raw::abut_camera_ray(&self.fields, x, y, raw_mut(&mut out)) })?;
        Ok(out)
    }

    /// Where it stands and how it is turned.
    pub fn pose(&self) -> Pose {
        let its = &self.fields.pose;
        Pose {
            position: [its.position.x, its.position.y, its.position.z],
            orientation: [its.orientation.w, its.orientation.x, its.orientation.y, its.orientation.z],
        }
    }
}

fn blank_camera() -> raw::abut_camera {
    // SAFETY: numbers alone, for which zeros are values.
    unsafe { std::mem::zeroed() }
}

/// What the queries of a picker meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PickerFlags {
    /// Sensors as well.
    pub sensors: bool,
    /// No surface whose normal points along the ray.
    pub skips_back_faces: bool,
}

/// What counts as selected by a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Selection {
    /// Geometries of which any point lies in the rectangle.
    Touching = raw::ABUT_SELECTION_TOUCHING,
    /// Those of which all points lie in it.
    Inside = raw::ABUT_SELECTION_INSIDE,
}

/// What is kept of a picture: points p with dot(normal, p) at least offset.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipPlane {
    /// Towards what is kept; of any length but zero.
    pub normal: Vec3,
    /// Along the unit normal, in metres.
    pub offset: f64,
}
mirror!(ClipPlane, raw::abut_clip_plane);

/// A vertex, a midpoint or a point of an edge near the mouse.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snap {
    /// Whose it is.
    pub geometry: GeometryId,
    /// `ABUT_SNAP_VERTEX`, `ABUT_SNAP_MIDPOINT` or `ABUT_SNAP_EDGE`.
    pub kind: u32,
    /// The vertex twice, or the ends of the edge, as numbers of the triangles of the shape.
    pub vertices: [u32; 2],
    reserved: u32,
    /// Along the edge, from 0 to 1.
    pub parameter: f64,
    /// From the mouse, in the picture.
    pub pixels: f64,
    /// From the start of the ray.
    pub distance: f64,
    /// In the world.
    pub point: Vec3,
}
mirror!(Snap, raw::abut_snap);

/// Rays against one universe. It sees poses as of the last step. Each query borrows the universe, so that nothing changes it
/// meanwhile.
///
/// ```
/// use abut::{picking::{Camera, Picker}, GeometryOptions, PartOptions, Pose, QueryFilter, Shape, Universe, UniverseOptions};
///
/// let mut universe = Universe::new(&UniverseOptions::default())?;
/// let part = universe.add_part(&PartOptions::at(Pose::at(0.0, 0.0, 0.0)))?;
/// let ball = universe.add_geometry(part, &Shape::sphere(1.0)?, &GeometryOptions::default())?;
/// let mut camera = Camera::new(100, 100);
/// camera.look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0])?;
/// let mut picker = Picker::new(&universe)?;
/// let hit = picker.pick_pixel(&universe, &camera, 50.0, 50.0, 0.0, &QueryFilter::default())?.unwrap();
/// assert_eq!((hit.geometry, hit.distance), (ball, 4.0));
/// # Ok::<(), abut::Error>(())
/// ```
pub struct Picker {
    picker: *mut raw::abut_picker,
    universe: *mut crate::raw::abut_universe,
}

// SAFETY: a picker has no thread of its own; its universe counts it by an atomic number.
unsafe impl Send for Picker {}

// A pick has the fields of a hit, so hits are written in its place.
const _: () = assert!(std::mem::size_of::<raw::abut_pick>() == std::mem::size_of::<crate::raw::abut_query_hit>());

fn met(hit: Hit) -> Option<Hit> {
    (hit.geometry != GeometryId::NULL).then_some(hit)
}

impl Picker {
    /// A picker of a universe. Nothing is built before the first query.
    pub fn new(universe: &Universe) -> Result<Picker> {
        let mut picker = null_mut();
        // SAFETY: the universe is alive, and keeps its memory until the picker is gone.
        check(unsafe { raw::abut_picker_create(universe.as_ptr(), &mut picker) })?;
        Ok(Picker { picker, universe: universe.as_ptr() })
    }

    fn expect(&self, universe: &Universe) -> Result<()> {
        if self.universe == universe.as_ptr() {
            return Ok(());
        }
        Err(Error::invalid("universe is another one than that of the picker".to_owned()))
    }

    /// Chooses what queries of this picker meet.
    pub fn set_flags(&mut self, flags: PickerFlags) -> Result<()> {
        let bits = if flags.sensors { raw::ABUT_PICKER_SENSORS } else { 0 }
            | if flags.skips_back_faces { raw::ABUT_PICKER_SKIP_BACK_FACES } else { 0 };
        // SAFETY: the picker is alive, here and in all methods below; what they hand in lives for the call.
        check(unsafe { raw::abut_picker_set_flags(self.picker, bits) })
    }

    /// Hides what lies behind any of these planes.
    pub fn set_clip_planes(&mut self, planes: &[ClipPlane]) -> Result<()> {
        // SAFETY: see set_flags.
        check(unsafe { raw::abut_picker_set_clip_planes(self.picker, raw_slice(planes), planes.len()) })
    }

    /// The first thing that a ray meets.
    pub fn cast_ray(&mut self, universe: &Universe, ray: &Ray, filter: &QueryFilter) -> Result<Option<Hit>> {
        Ok(self.cast_rays(universe, &[*ray], false, filter)?[0])
    }

    /// The first thing that each of many rays meets. Rays that are near to those before and after them are faster if the call
    /// says that they are `neighbours`.
    pub fn cast_rays(
        &mut self,
        universe: &Universe,
        rays: &[Ray],
        neighbours: bool,
        filter: &QueryFilter,
    ) -> Result<Vec<Option<Hit>>> {
        self.expect(universe)?;
        let coherence = if neighbours { raw::ABUT_COHERENCE_NEIGHBOURS } else { raw::ABUT_COHERENCE_NONE };
        let mut hits = vec![blank::<Hit>(); rays.len()];
        let out = raw_slice_mut(&mut hits).cast();
        // SAFETY: see set_flags; slices are equally long.
        check(unsafe {
            raw::abut_picker_cast_rays(self.picker, raw_slice(rays), rays.len(), coherence, &filter.raw(), out)
        })?;
        Ok(hits.into_iter().map(met).collect())
    }

    /// Every crossing of a surface, nearest first.
    pub fn cast_ray_all(&mut self, universe: &Universe, ray: &Ray, filter: &QueryFilter) -> Result<Vec<Hit>> {
        self.expect(universe)?;
        let filter = filter.raw();
        // SAFETY: see set_flags; fill hands in a place for `capacity` hits.
        fill::<Hit>(|place, capacity, count| unsafe {
            raw::abut_picker_cast_ray_all(self.picker, raw_of(ray), &filter, place.cast(), capacity, count)
        })
    }

    /// Whether a ray meets anything.
    pub fn ray_hits(&mut self, universe: &Universe, ray: &Ray, filter: &QueryFilter) -> Result<bool> {
        self.expect(universe)?;
        let mut out = 0;
        // SAFETY: see set_flags.
        check(unsafe { raw::abut_picker_ray_hits(self.picker, raw_of(ray), &filter.raw(), &mut out) })?;
        Ok(out == 1)
    }

    /// What lies under the mouse, or within `radius` pixels of it.
    pub fn pick_pixel(
        &mut self,
        universe: &Universe,
        camera: &Camera,
        x: f64,
        y: f64,
        radius: f64,
        filter: &QueryFilter,
    ) -> Result<Option<Hit>> {
        self.expect(universe)?;
        let mut hit = blank::<Hit>();
        let out = raw_mut(&mut hit).cast();
        // SAFETY: see set_flags.
        check(unsafe { raw::abut_picker_pick_pixel(self.picker, &camera.fields, x, y, radius, &filter.raw(), out) })?;
        Ok(met(hit))
    }

    /// The geometries in a rectangle with the corners (x0, y0) and (x1, y1).
    pub fn select_rectangle(
        &mut self,
        universe: &Universe,
        camera: &Camera,
        corners: [[f64; 2]; 2],
        selection: Selection,
        filter: &QueryFilter,
    ) -> Result<Vec<GeometryId>> {
        self.expect(universe)?;
        let (filter, [[x0, y0], [x1, y1]]) = (filter.raw(), corners);
        // SAFETY: see cast_ray_all.
        fill(|place, capacity, count| unsafe {
            let (its, chosen) = (&camera.fields, selection as u32);
            raw::abut_picker_select_rectangle(self.picker, its, x0, y0, x1, y1, chosen, &filter, place, capacity, count)
        })
    }

    /// The nearest vertex, midpoint or edge within `radius` pixels; `kinds` are `ABUT_SNAP_VERTEX` and others, joined by `|`.
    #[allow(clippy::too_many_arguments)]
    pub fn snap(
        &mut self,
        universe: &Universe,
        camera: &Camera,
        x: f64,
        y: f64,
        radius: f64,
        kinds: u32,
        filter: &QueryFilter,
    ) -> Result<Option<Snap>> {
        self.expect(universe)?;
        let mut snap = blank::<Snap>();
        let out = raw_mut(&mut snap);
        // SAFETY: see set_flags.
        check(unsafe { raw::abut_picker_snap(self.picker, &camera.fields, x, y, radius, kinds, &filter.raw(), out) })?;
        Ok((snap.geometry != GeometryId::NULL).then_some(snap))
    }

    /// One ray through the centre of each pixel, row by row from the top.
    pub fn render(&mut self, universe: &Universe, camera: &Camera, filter: &QueryFilter) -> Result<Vec<Option<Hit>>> {
        self.expect(universe)?;
        let count = camera.fields.width as usize * camera.fields.height as usize;
        let mut hits = vec![blank::<Hit>(); count];
        let out = raw_slice_mut(&mut hits).cast();
        // SAFETY: see set_flags; there is room for all pixels.
        check(unsafe { raw::abut_picker_render(self.picker, &camera.fields, &filter.raw(), out, count) })?;
        Ok(hits.into_iter().map(met).collect())
    }
}

impl Drop for Picker {
    fn drop(&mut self) {
        // SAFETY: nobody else owns it.
        unsafe { raw::abut_picker_destroy(self.picker) };
    }
}
