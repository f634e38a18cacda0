// SPDX-License-Identifier: Apache-2.0
//! Questions to a universe. They see poses as of the last step or refresh, and change nothing.

use crate::error::{check, expect_as_many};
use crate::meeting::QueryFilter;
use crate::ray::{CastHit, Closest, Hit, Ray};
use crate::value::{blank, fill, raw_mut, raw_of, raw_slice, raw_slice_mut, GeometryId, Pose, Vec3};
use crate::view::View;
use crate::{raw, Result, Shape};

impl View {
    /// The first geometry that a ray meets.
    pub fn cast_ray(&self, ray: &Ray, filter: &QueryFilter) -> Result<Option<Hit>> {
        Ok(self.cast_rays(&[*ray], filter)?[0])
    }

    /// The first geometry that each of many rays meets.
    pub fn cast_rays(&self, rays: &[Ray], filter: &QueryFilter) -> Result<Vec<Option<Hit>>> {
        let mut hits = vec![blank::<Hit>(); rays.len()];
        // SAFETY: the universe is alive, here and below; what is handed in lives for the call. Slices are equally long.
        check(unsafe {
            raw::abut_universe_cast_rays(
                self.as_ptr(),
                raw_slice(rays),
                rays.len(),
                &filter.raw(),
                raw_slice_mut(&mut hits),
            )
        })?;
        Ok(hits.into_iter().map(|hit| (hit.geometry != GeometryId::NULL).then_some(hit)).collect())
    }

    /// All geometries that a ray meets, in the order in which it meets them.
    pub fn cast_ray_all(&self, ray: &Ray, filter: &QueryFilter) -> Result<Vec<Hit>> {
        // SAFETY: see cast_rays; fill hands in a place for `capacity` hits, here and below.
        fill(|place, capacity, count| unsafe {
            raw::abut_universe_cast_ray(
                self.as_ptr(),
                raw_of(ray),
                &filter.raw(),
                raw::ABUT_HIT_ALL,
                place,
                capacity,
                count,
            )
        })
    }

    /// The first geometry that a shape meets while it moves by a displacement without turning.
    pub fn cast_shape(
        &self,
        shape: &Shape,
        pose: &Pose,
        displacement: Vec3,
        filter: &QueryFilter,
    ) -> Result<Option<CastHit>> {
        let hits = fill::<CastHit>(|place, capacity, count| {
            // SAFETY: see cast_ray_all; the shape is alive.
            unsafe {
                raw::abut_universe_cast_shape(
                    self.as_ptr(),
                    shape.as_ptr(),
                    raw_of(pose),
                    raw_of(&displacement),
                    &filter.raw(),
                    raw::ABUT_HIT_NEAREST,
                    place,
                    capacity,
                    count,
                )
            }
        })?;
        Ok(hits.first().copied())
    }

    /// Geometries with which a shape has contacts up to a distance, ordered by slot.
    pub fn overlaps(&self, shape: &Shape, pose: &Pose, margin: f64, filter: &QueryFilter) -> Result<Vec<GeometryId>> {
        // SAFETY: see cast_ray_all; the shape is alive.
        fill(|place, capacity, count| unsafe {
            raw::abut_universe_overlaps(
                self.as_ptr(),
                shape.as_ptr(),
                raw_of(pose),
                &filter.raw(),
                margin,
                place,
                capacity,
                count,
            )
        })
    }

    /// Solids that hold a point, and surfaces that it lies on, ordered by slot.
    pub fn at_point(&self, point: Vec3, filter: &QueryFilter) -> Result<Vec<GeometryId>> {
        // SAFETY: see cast_ray_all.
        fill(|place, capacity, count| unsafe {
            raw::abut_universe_at_point(self.as_ptr(), raw_of(&point), &filter.raw(), place, capacity, count)
        })
    }

    /// The geometry of the least signed distance from a shape, if one is as near as max_distance.
    pub fn closest(
        &self,
        shape: &Shape,
        pose: &Pose,
        max_distance: f64,
        filter: &QueryFilter,
    ) -> Result<Option<Closest>> {
        let (mut out, mut found) = (blank(), 0);
        // SAFETY: see cast_rays; the shape is alive.
        check(unsafe {
            raw::abut_universe_closest(
                self.as_ptr(),
                shape.as_ptr(),
                raw_of(pose),
                max_distance,
                &filter.raw(),
                raw_mut(&mut out),
                &mut found,
            )
        })?;
        Ok((found == 1).then_some(out))
    }

    /// The same for many shapes at once.
    pub fn closest_to_each(
        &self,
        shapes: &[&Shape],
        poses: &[Pose],
        max_distance: f64,
        filter: &QueryFilter,
    ) -> Result<Vec<Option<Closest>>> {
        expect_as_many(("shapes", shapes.len()), ("poses", poses.len()))?;
        let pointers = crate::shape::pointers(shapes);
        let mut out = vec![blank::<Closest>(); poses.len()];
        // SAFETY: see closest; all slices are equally long.
        check(unsafe {
            raw::abut_universe_closest_to_each(
                self.as_ptr(),
                pointers.as_ptr(),
                raw_slice(poses),
                poses.len(),
                max_distance,
                &filter.raw(),
                raw_slice_mut(&mut out),
            )
        })?;
        Ok(out.into_iter().map(|each| (each.geometry != GeometryId::NULL).then_some(each)).collect())
    }
}
