// SPDX-License-Identifier: Apache-2.0
//! Rays, casts, and what they meet.

use crate::contact::Distance;
use crate::raw;
use crate::value::{mirror, Feature, GeometryId, Vec3};

/// A ray. Its direction has any length but zero; distances are in world units.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes.
    pub direction: Vec3,
    /// How far it goes; may be infinite.
    pub max_distance: f64,
}
mirror!(Ray, raw::abut_ray);

impl Ray {
    /// A ray without end.
    pub const fn new(origin: Vec3, direction: Vec3) -> Ray {
        Ray { origin, direction, max_distance: f64::INFINITY }
    }
}

/// Where a ray meets one shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// From the origin, along the unit direction.
    pub distance: f64,
    /// In the world frame.
    pub point: Vec3,
    /// Unit, out of the solid; of a mesh by winding.
    pub normal: Vec3,
    /// What was hit.
    pub feature: Feature,
    /// Of a composite; 0 for all other shapes.
    pub child: u32,
    reserved: u32,
}
mirror!(RayHit, raw::abut_ray_hit);

/// Where a ray meets a geometry of a universe.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// What is met.
    pub geometry: GeometryId,
    /// What of the shape is met.
    pub feature: Feature,
    /// Of a composite; 0 for all other shapes.
    pub child: u32,
    reserved: u32,
    /// From the origin, along the unit direction.
    pub distance: f64,
    /// In the world frame.
    pub point: Vec3,
    /// Unit, out of the solid; zeros where the ray starts inside it.
    pub normal: Vec3,
}
mirror!(Hit, raw::abut_query_hit);

/// Where a moving shape (a) first touches another (b).
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CastHit {
    /// What is met; null for two shapes outside of a universe.
    pub geometry: GeometryId,
    /// Of the displacement, in \[0, 1\].
    pub fraction: f64,
    /// At that time, in the world.
    pub contact: Distance,
    /// What of the moving shape touches.
    pub feature_a: Feature,
    /// What of the other shape touches.
    pub feature_b: Feature,
    /// Of a composite, or the particle; 0 for all other shapes.
    pub child_a: u32,
    /// The same of the other shape.
    pub child_b: u32,
}
mirror!(CastHit, raw::abut_cast_hit);

/// What is closest to a shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest {
    /// What is closest.
    pub geometry: GeometryId,
    /// From the shape (a) to the geometry (b); negative where they overlap.
    pub distance: Distance,
}
mirror!(Closest, raw::abut_closest);
