// SPDX-License-Identifier: Apache-2.0
//! A universe: parts that move, geometries on them, and steps that find what touches.

use crate::error::{check, expect_as_many};
use crate::meeting::{ask, Asking, Collidable, Filter, Rule};
use crate::options::{GeometryOptions, Motion, Parking, PartOptions, UniverseOptions};
use crate::shape::pointers;
use crate::value::{blank, raw_mut, raw_of, raw_slice, raw_slice_mut, Aabb, GeometryId, PartId, Pose};
use crate::view::View;
use crate::{raw, Result, Shape};
use std::ops::Deref;
use std::panic::resume_unwind;
use std::ptr::{null, null_mut};

/// A space in which parts meet. Everything that only reads is a method of [`View`].
///
/// ```
/// use abut::{GeometryOptions, PartOptions, Pose, Shape, Universe, UniverseOptions};
/// let ball = Shape::sphere(1.0)?;
/// let mut universe = Universe::new(&UniverseOptions::default())?;
/// for x in [0.0, 1.5] {
///     let part = universe.add_part(&PartOptions::at(Pose::at(x, 0.0, 0.0)))?;
///     universe.add_geometry(part, &ball, &GeometryOptions::default())?;
/// }
/// universe.step(0.01)?;
/// assert_eq!(universe.contacts()?[0].depth(), 0.5);
/// # Ok::<(), abut::Error>(())
/// ```
pub struct Universe {
    view: View,
    // From Box::into_raw, or null: the library keeps this address.
    filter: *mut Filter,
}

// SAFETY: a universe has no thread of its own, and its filter is Send.
unsafe impl Send for Universe {}
// SAFETY: methods of `&self` are those that the header tags with [const], which may run together. The filter is only
// called by methods of `&mut self`.
unsafe impl Sync for Universe {}

impl Deref for Universe {
    type Target = View;

    fn deref(&self) -> &View {
        &self.view
    }
}

impl Universe {
    /// An empty universe.
    pub fn new(options: &UniverseOptions) -> Result<Universe> {
        let mut universe = null_mut();
        // SAFETY: options are read, and the pointer is written, during the call.
        check(unsafe { raw::abut_universe_create(&options.raw(), &mut universe) })?;
        // SAFETY: it is alive until drop.
        Ok(Universe { view: unsafe { View::new(universe) }, filter: null_mut() })
    }

    /// Creates a part, which has no geometry yet.
    pub fn add_part(&mut self, options: &PartOptions) -> Result<PartId> {
        self.add_parts(&[*options]).map(|parts| parts[0])
    }

    /// Creates parts, all or none.
    pub fn add_parts(&mut self, options: &[PartOptions]) -> Result<Vec<PartId>> {
        let raws: Vec<_> = options.iter().map(PartOptions::raw).collect();
        let mut out = vec![blank(); raws.len()];
        // SAFETY: the universe is alive, here and in all methods below; what they hand in lives for the call, and
        // slices are as long as the count.
        check(unsafe { raw::abut_parts_create(self.as_ptr(), raws.as_ptr(), raws.len(), raw_slice_mut(&mut out)) })?;
        Ok(out)
    }

    /// Destroys parts with their geometries, all or none.
    pub fn remove_parts(&mut self, parts: &[PartId]) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_parts_destroy(self.as_ptr(), raw_slice(parts), parts.len()) })
    }

    /// Places a part; takes effect for contacts at the next step.
    pub fn set_pose(&mut self, part: PartId, pose: &Pose) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_part_set_pose(self.as_ptr(), part.raw(), raw_of(pose)) })
    }

    /// Places parts, all or none.
    pub fn set_poses(&mut self, parts: &[PartId], poses: &[Pose]) -> Result<()> {
        expect_as_many(("parts", parts.len()), ("poses", poses.len()))?;
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_parts_set_poses(self.as_ptr(), raw_slice(parts), raw_slice(poses), parts.len()) })
    }

    /// Changes how a part moves.
    pub fn set_motion(&mut self, part: PartId, motion: Motion) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_part_set_motion(self.as_ptr(), part.raw(), motion as u32) })
    }

    /// Puts a shape on a part. The universe keeps the shape alive.
    pub fn add_geometry(&mut self, part: PartId, shape: &Shape, options: &GeometryOptions) -> Result<GeometryId> {
        let mut out = blank();
        // SAFETY: see add_parts.
        check(unsafe {
            raw::abut_geometry_create(self.as_ptr(), part.raw(), shape.as_ptr(), &options.raw(), raw_mut(&mut out))
        })?;
        Ok(out)
    }

    /// Puts a shape on each of many parts, all or none; `options` holds one for each, or none at all.
    pub fn add_geometries(
        &mut self,
        parts: &[PartId],
        shapes: &[&Shape],
        options: &[GeometryOptions],
    ) -> Result<Vec<GeometryId>> {
        expect_as_many(("parts", parts.len()), ("shapes", shapes.len()))?;
        let raws: Vec<_> = options.iter().map(GeometryOptions::raw).collect();
        if !raws.is_empty() {
            expect_as_many(("parts", parts.len()), ("options", raws.len()))?;
        }
        let options = if raws.is_empty() { null() } else { raws.as_ptr() };
        let shapes = pointers(shapes);
        let mut out = vec![blank(); parts.len()];
        // SAFETY: see add_parts.
        check(unsafe {
            raw::abut_geometries_create(
                self.as_ptr(),
                raw_slice(parts),
                shapes.as_ptr(),
                options,
                parts.len(),
                raw_slice_mut(&mut out),
            )
        })?;
        Ok(out)
    }

    /// Takes geometries away, all or none.
    pub fn remove_geometries(&mut self, geometries: &[GeometryId]) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_geometries_destroy(self.as_ptr(), raw_slice(geometries), geometries.len()) })
    }

    /// Replaces the options of a geometry, all of them.
    pub fn set_options(&mut self, geometry: GeometryId, options: &GeometryOptions) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_geometry_set_options(self.as_ptr(), geometry.raw(), &options.raw()) })
    }

    /// Gives a geometry another shape.
    pub fn set_shape(&mut self, geometry: GeometryId, shape: &Shape) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_geometry_set_shape(self.as_ptr(), geometry.raw(), shape.as_ptr()) })
    }

    /// Parks geometries, or brings them back, all or none.
    pub fn park(&mut self, geometries: &[GeometryId], parking: Parking) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe {
            raw::abut_geometries_park(self.as_ptr(), raw_slice(geometries), geometries.len(), parking as u32)
        })
    }

    /// Says whether two collidables meet.
    pub fn set_rule(&mut self, a: Collidable, b: Collidable, rule: Rule) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_rule_set(self.as_ptr(), &a.raw(), &b.raw(), rule as u32) })
    }

    /// Takes all rules away.
    pub fn clear_rules(&mut self) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_rules_clear(self.as_ptr()) })
    }

    /// Sets the filter: false leaves a pair out. It is asked once for each pair that comes near, in a step, by the
    /// thread that steps. A panic of it keeps the pair, and goes on when the step is over.
    ///
    /// A universe may go to another thread, so what the filter holds must be able to:
    /// ```compile_fail,E0277
    /// # let mut universe = abut::Universe::new(&abut::UniverseOptions::default())?;
    /// let count = std::rc::Rc::new(0);
    /// universe.set_filter(move |_, _, _| *count == 0)?;
    /// # Ok::<(), abut::Error>(())
    /// ```
    pub fn set_filter(
        &mut self,
        keeps: impl FnMut(&Asking<'_>, GeometryId, GeometryId) -> bool + Send + 'static,
    ) -> Result<()> {
        let filter = Box::into_raw(Box::new(Filter::new(self.as_ptr(), Box::new(keeps))));
        self.replace_filter(Some(ask), filter)
    }

    /// Takes the filter away.
    pub fn clear_filter(&mut self) -> Result<()> {
        self.replace_filter(None, null_mut())
    }

    fn replace_filter(&mut self, function: raw::abut_filter, filter: *mut Filter) -> Result<()> {
        // SAFETY: see add_parts; the filter lives until it is replaced or the universe is gone.
        let set = check(unsafe { raw::abut_universe_set_filter(self.as_ptr(), function, filter.cast()) });
        let unused = if set.is_ok() { std::mem::replace(&mut self.filter, filter) } else { filter };
        // SAFETY: the library does not know it any more, or never did.
        unsafe { free(unused) };
        set
    }

    /// Asks the filter about all pairs again at the next step.
    pub fn refilter(&mut self) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_universe_refilter(self.as_ptr()) })
    }

    /// Finds what touches at the present poses; dt is the time since the step before. Moves nothing.
    pub fn step(&mut self, dt: f64) -> Result<()> {
        // SAFETY: see add_parts.
        let status = unsafe { raw::abut_universe_step(self.as_ptr(), dt) };
        self.after_detection(status)
    }

    /// A step that finds every pair anew.
    pub fn detect_all(&mut self) -> Result<()> {
        // SAFETY: see add_parts.
        let status = unsafe { raw::abut_universe_detect_all(self.as_ptr()) };
        self.after_detection(status)
    }

    /// A step without time.
    pub fn detect_changed(&mut self) -> Result<()> {
        // SAFETY: see add_parts.
        let status = unsafe { raw::abut_universe_detect_changed(self.as_ptr()) };
        self.after_detection(status)
    }

    /// A step that looks only at pairs whose boxes both meet a region.
    pub fn detect_region(&mut self, region: &Aabb) -> Result<()> {
        // SAFETY: see add_parts.
        let status = unsafe { raw::abut_universe_detect_region(self.as_ptr(), raw_of(region)) };
        self.after_detection(status)
    }

    fn after_detection(&mut self, status: raw::abut_status) -> Result<()> {
        // SAFETY: the filter is alive, and no detection runs that could use it.
        if let Some(panic) = unsafe { self.filter.as_mut() }.and_then(Filter::take_panic) {
            resume_unwind(panic);
        }
        check(status)
    }

    /// Brings what queries see up to date with the poses, without detecting anything.
    pub fn refresh(&mut self) -> Result<()> {
        // SAFETY: see add_parts.
        check(unsafe { raw::abut_universe_refresh(self.as_ptr()) })
    }

    /// Puts a number of yours on each contact of the last step, in their order. Contacts that stay keep it.
    pub fn set_contact_data(&mut self, user_data: &[u64]) -> Result<()> {
        // SAFETY: see add_parts; the library compares the count with that of the contacts.
        check(unsafe { raw::abut_contacts_set_user_data(self.as_ptr(), user_data.as_ptr(), user_data.len()) })
    }
}

/// # Safety
/// The filter comes from Box::into_raw, or is null, and nobody uses it any more.
unsafe fn free(filter: *mut Filter) {
    if !filter.is_null() {
        // SAFETY: as the caller promises.
        drop(unsafe { Box::from_raw(filter) });
    }
}

impl Drop for Universe {
    fn drop(&mut self) {
        // SAFETY: nobody else owns it, and no callback of it runs, since those have no `&mut Universe`.
        unsafe { raw::abut_universe_destroy(self.as_ptr()) };
        // SAFETY: the universe that knew it is gone.
        unsafe { free(self.filter) };
    }
}
