// SPDX-License-Identifier: Apache-2.0
//! Shapes: immutable, shared and counted.

use crate::error::{check, expect_as_many};
use crate::ray::{Ray, RayHit};
use crate::value::{blank, fill, raw_mut, raw_of, raw_slice, Aabb, Pose, Vec3};
use crate::{raw, Error, Result};
use std::ffi::{CStr, CString};
use std::fmt;
use std::ptr::{null_mut, NonNull};

/// A shape. It never changes, so it may be shared by threads, geometries and universes; a clone is the same shape.
///
/// ```
/// let ball = abut::Shape::sphere(0.5)?;
/// assert_eq!(ball.kind(), "sphere");
/// assert_eq!(ball.parameters()?, [0.5]);
/// # Ok::<(), abut::Error>(())
/// ```
pub struct Shape {
    pointer: NonNull<raw::abut_shape>,
}

// SAFETY: the header tags every function of a shape with [any], and says that a shape does not change while somebody
// holds a reference, which each Shape does. The library counts references atomically.
unsafe impl Send for Shape {}
// SAFETY: as above; no method of Shape writes.
unsafe impl Sync for Shape {}

/// Which side of a mesh stops other shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// A sheet: others are pushed out on the side where they lie.
    Both,
    /// Only the side from which triangles are counter-clockwise.
    Front,
    /// All that the mesh encloses: what is inside is pushed out.
    Solid,
}

impl Shape {
    pub(crate) fn made(create: impl FnOnce(*mut *mut raw::abut_shape) -> raw::abut_status) -> Result<Shape> {
        let mut pointer = null_mut();
        check(create(&mut pointer))?;
        NonNull::new(pointer).map(|pointer| Shape { pointer }).ok_or_else(|| Error::invalid("the shape is null".into()))
    }

    /// A solid ball, centred.
    pub fn sphere(radius: f64) -> Result<Shape> {
        // SAFETY: `out` is a place for one pointer, here and below.
        Shape::made(|out| unsafe { raw::abut_sphere_create(radius, out) })
    }

    /// A solid box, centred, from its half extents; zeros make it flat.
    pub fn cuboid(half_extents: Vec3) -> Result<Shape> {
        let [x, y, z] = half_extents;
        // SAFETY: see sphere.
        Shape::made(|out| unsafe { raw::abut_box_create(x, y, z, out) })
    }

    /// All points within a radius of a segment along local Z, of which half_height is one half.
    pub fn capsule(radius: f64, half_height: f64) -> Result<Shape> {
        // SAFETY: see sphere.
        Shape::made(|out| unsafe { raw::abut_capsule_create(radius, half_height, out) })
    }

    /// A solid cylinder along local Z with flat ends, centred.
    pub fn cylinder(radius: f64, half_height: f64) -> Result<Shape> {
        // SAFETY: see sphere.
        Shape::made(|out| unsafe { raw::abut_cylinder_create(radius, half_height, out) })
    }

    /// The half-space of the points p with dot(normal, p) <= offset; the normal points out of the solid.
    pub fn plane(normal: Vec3, offset: f64) -> Result<Shape> {
        // SAFETY: see sphere; the normal is read during the call.
        Shape::made(|out| unsafe { raw::abut_plane_create(raw_of(&normal), offset, out) })
    }

    /// The convex hull of points.
    pub fn hull(points: &[Vec3]) -> Result<Shape> {
        // SAFETY: see sphere; the points are copied, and three numbers each lie in a row.
        Shape::made(|out| unsafe { raw::abut_hull_create(points.as_ptr().cast(), points.len(), out) })
    }

    /// A surface of triangles, each three indices of vertices, counter-clockwise seen from the front.
    pub fn mesh(vertices: &[Vec3], triangles: &[[u32; 3]], sides: Sides) -> Result<Shape> {
        let mut options = raw::abut_mesh_options::default();
        // SAFETY: see sphere; vertices and triangles are copied, and three numbers each lie in a row.
        Shape::made(|out| unsafe {
            raw::abut_mesh_options_init(&mut options, std::mem::size_of_val(&options) as u32);
            options.sides = match sides {
                Sides::Both => raw::ABUT_SIDES_BOTH,
                Sides::Front => raw::ABUT_SIDES_FRONT,
                Sides::Solid => raw::ABUT_SIDES_SOLID,
            };
            raw::abut_mesh_create(
                vertices.as_ptr().cast(),
                vertices.len(),
                triangles.as_ptr().cast(),
                triangles.len(),
                &options,
                out,
            )
        })
    }

    /// Terrain over a grid: sample (i, j) lies at (i * spacing\[0\], j * spacing\[1\], heights\[j * columns + i\]).
    pub fn height_field(columns: u32, rows: u32, spacing: [f64; 2], heights: &[f64]) -> Result<Shape> {
        let samples = u64::from(columns) * u64::from(rows);
        if heights.len() as u64 != samples {
            let count = heights.len();
            return Err(Error::invalid(format!(
                "heights has {count} numbers; expected columns * rows, which is {samples}"
            )));
        }
        let mut desc = raw::abut_height_field_desc::default();
        // SAFETY: see sphere; heights are copied, and there are as many as the library reads.
        Shape::made(|out| unsafe {
            raw::abut_height_field_desc_init(&mut desc, std::mem::size_of_val(&desc) as u32);
            desc.columns = columns;
            desc.rows = rows;
            desc.spacing_x = spacing[0];
            desc.spacing_y = spacing[1];
            desc.heights = heights.as_ptr();
            raw::abut_height_field_create(&desc, out)
        })
    }

    /// Many small balls of one radius.
    pub fn particles(centres: &[Vec3], radius: f64) -> Result<Shape> {
        // SAFETY: see sphere; the centres are copied, and three numbers each lie in a row.
        Shape::made(|out| unsafe { raw::abut_particles_create(centres.as_ptr().cast(), centres.len(), radius, out) })
    }

    /// Shapes of any kind as one, each at a pose of its own. The composite keeps them alive.
    pub fn composite(children: &[&Shape], poses: &[Pose]) -> Result<Shape> {
        expect_as_many(("children", children.len()), ("poses", poses.len()))?;
        let children = pointers(children);
        // SAFETY: see sphere; there are as many children as poses.
        Shape::made(|out| unsafe {
            raw::abut_composite_create(children.as_ptr(), raw_slice(poses), children.len(), out)
        })
    }

    /// A shape of any kind that numbers describe, such as ("cone", radius, half height). docs/shapes.md lists them.
    pub fn of_kind(kind: &str, parameters: &[f64]) -> Result<Shape> {
        let name = CString::new(kind).map_err(|_| Error::invalid("kind holds a zero byte".into()))?;
        let mut desc = raw::abut_shape_desc::default();
        // SAFETY: see sphere; the name is terminated, and the parameters are read during the call.
        Shape::made(|out| unsafe {
            raw::abut_shape_desc_init(&mut desc, std::mem::size_of_val(&desc) as u32);
            desc.kind = raw::abut_shape_kind_by_name(name.as_ptr());
            desc.parameters = parameters.as_ptr();
            desc.parameter_count = parameters.len() as u64;
            raw::abut_shape_create(&desc, out)
        })
    }

    /// The name of its kind, such as "sphere".
    pub fn kind(&self) -> &'static str {
        // SAFETY: the shape is alive, and names of kinds are static.
        unsafe { CStr::from_ptr(raw::abut_shape_kind_name(raw::abut_shape_kind_of(self.as_ptr()))) }
            .to_str()
            .expect("names of kinds are ASCII")
    }

    /// The numbers that describe it, in the order of docs/shapes.md.
    pub fn parameters(&self) -> Result<Vec<f64>> {
        // SAFETY: the shape is alive, and fill hands in a place for `capacity` numbers.
        fill(|place, capacity, count| unsafe { raw::abut_shape_parameters(self.as_ptr(), place, capacity, count) })
    }

    /// A box around the shape at a pose.
    pub fn aabb(&self, pose: &Pose) -> Result<Aabb> {
        let mut out = blank();
        // SAFETY: the shape is alive; the pose is read and the box written during the call.
        check(unsafe { raw::abut_shape_aabb(self.as_ptr(), raw_of(pose), raw_mut(&mut out)) })?;
        Ok(out)
    }

    /// The surface of a mesh, height field, hull or box as vertices and triangles, in the frame of the shape.
    pub fn triangles(&self) -> Result<(Vec<Vec3>, Vec<[u32; 3]>)> {
        let (mut vertex_count, mut triangle_count) = (0, 0);
        let mut fill = |vertices: &mut [Vec3], triangles: &mut [[u32; 3]]| {
            // SAFETY: the shape is alive; both places are as large as told, and three numbers each lie in a row.
            check(unsafe {
                raw::abut_shape_triangles(
                    self.as_ptr(),
                    vertices.as_mut_ptr().cast(),
                    vertices.len(),
                    &mut vertex_count,
                    triangles.as_mut_ptr().cast(),
                    triangles.len(),
                    &mut triangle_count,
                )
            })?;
            Ok((vertex_count, triangle_count))
        };
        let (vertex_count, triangle_count) = fill(&mut [], &mut [])?;
        let (mut vertices, mut triangles) = (vec![[0.0; 3]; vertex_count], vec![[0; 3]; triangle_count]);
        fill(&mut vertices, &mut triangles)?;
        Ok((vertices, triangles))
    }

    /// Where a ray first crosses the surface of the shape at a pose.
    pub fn cast_ray(&self, pose: &Pose, ray: &Ray) -> Result<Option<RayHit>> {
        let (mut hit, mut found) = (blank(), 0);
        // SAFETY: the shape is alive; pose and ray are read, and hit and found written, during the call.
        check(unsafe {
            raw::abut_shape_cast_ray(self.as_ptr(), raw_of(pose), raw_of(ray), raw_mut(&mut hit), &mut found)
        })?;
        Ok((found == 1).then_some(hit))
    }

    /// The pointer of the C interface, for what this crate does not wrap; it is alive as long as the shape.
    pub fn as_ptr(&self) -> *mut raw::abut_shape {
        self.pointer.as_ptr()
    }
}

pub(crate) fn pointers(shapes: &[&Shape]) -> Vec<*const raw::abut_shape> {
    shapes.iter().map(|shape| shape.as_ptr() as *const _).collect()
}

impl Clone for Shape {
    fn clone(&self) -> Shape {
        // SAFETY: the shape is alive; the clone owns the reference that this adds.
        unsafe { raw::abut_shape_retain(self.as_ptr()) };
        Shape { pointer: self.pointer }
    }
}

impl Drop for Shape {
    fn drop(&mut self) {
        // SAFETY: gives back the one reference that this owns.
        unsafe { raw::abut_shape_release(self.as_ptr()) };
    }
}

impl fmt::Debug for Shape {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_tuple(self.kind()).field(&self.parameters().unwrap_or_default()).finish()
    }
}
