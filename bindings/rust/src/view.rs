// SPDX-License-Identifier: Apache-2.0
//! What may be read of a universe at any time, also by several threads at once.

use crate::contact::{Contact, Event};
use crate::error::check;
use crate::meeting::{ApartReasons, Collidable, Rule};
use crate::value::{blank, fill, mirror, raw_mut, raw_slice, raw_slice_mut, GeometryId, Mirror, PartId, Pose};
use crate::{raw, Result, Shape};
use std::ptr::null;

/// A universe, to be read: what the header tags with \[const\]. `Universe` and the argument of a filter are views.
pub struct View {
    universe: *mut raw::abut_universe,
}

/// Counts and times of the last step.
pub type Stats = raw::abut_step_stats;

mirror!(u64, u64);

impl View {
    /// # Safety
    /// The universe must be alive as long as the view.
    pub(crate) unsafe fn new(universe: *mut raw::abut_universe) -> View {
        View { universe }
    }

    /// The pointer of the C interface, for what this crate does not wrap.
    pub fn as_ptr(&self) -> *mut raw::abut_universe {
        self.universe
    }

    /// A slice that the library lends until the next call that changes the universe. Those take `&mut self`, so the
    /// borrow of `self` ends before.
    pub(crate) fn lent<T: Mirror>(
        &self,
        call: impl FnOnce(*mut *const T::Raw, *mut usize) -> raw::abut_status,
    ) -> Result<&[T]> {
        let (mut values, mut count) = (null(), 0);
        check(call(&mut values, &mut count))?;
        if count == 0 {
            return Ok(&[]);
        }
        // SAFETY: the library lends `count` values, which T mirrors.
        Ok(unsafe { std::slice::from_raw_parts(values.cast(), count) })
    }

    /// Contacts of the last step, ordered by the slots of the two geometries, then deepest first.
    ///
    /// They are gone when the universe changes, which the compiler holds you to:
    /// ```compile_fail,E0502
    /// let mut universe = abut::Universe::new(&abut::UniverseOptions::default())?;
    /// let contacts = universe.contacts()?;
    /// universe.step(0.01)?;
    /// println!("{}", contacts.len());
    /// # Ok::<(), abut::Error>(())
    /// ```
    pub fn contacts(&self) -> Result<&[Contact]> {
        // SAFETY: the universe is alive, here and in all methods below; what they hand in lives for the call.
        self.lent(|values, count| unsafe { raw::abut_universe_contacts(self.universe, values, count) })
    }

    /// Events of the last step, in the order of the contacts.
    pub fn events(&self) -> Result<&[Event]> {
        // SAFETY: see contacts.
        self.lent(|values, count| unsafe { raw::abut_universe_events(self.universe, values, count) })
    }

    /// A hash of all contacts and events of the last step: equal runs have equal hashes.
    pub fn hash(&self) -> Result<u64> {
        let mut out = 0;
        // SAFETY: see contacts.
        check(unsafe { raw::abut_universe_hash(self.universe, &mut out) })?;
        Ok(out)
    }

    /// Counts and times of the last step.
    pub fn stats(&self) -> Result<Stats> {
        let mut stats = crate::options::defaults!(abut_step_stats, raw::abut_step_stats_init);
        // SAFETY: see contacts.
        check(unsafe { raw::abut_universe_stats(self.universe, &mut stats) })?;
        Ok(stats)
    }

    /// What the last step did and why, in words.
    pub fn explain(&self) -> Result<String> {
        let mut needed = 0;
        // SAFETY: see contacts; with a capacity of 0 the library asks for no place.
        check(unsafe { raw::abut_universe_explain(self.universe, std::ptr::null_mut(), 0, &mut needed) })?;
        let mut text = vec![0u8; needed];
        // SAFETY: see contacts; the place has `needed` bytes.
        check(unsafe { raw::abut_universe_explain(self.universe, text.as_mut_ptr().cast(), needed, &mut needed) })?;
        text.truncate(text.iter().position(|&byte| byte == 0).unwrap_or(text.len()));
        Ok(String::from_utf8_lossy(&text).into_owned())
    }

    /// What is odd about the scene, in words; nothing when all is well.
    pub fn validate(&self) -> Result<Vec<String>> {
        let mut count = 0;
        // SAFETY: see contacts; with a capacity of 0 the library asks for no place.
        check(unsafe { raw::abut_universe_validate(self.universe, std::ptr::null_mut(), 0, &mut count) })?;
        let mut findings = vec![raw::abut_finding::default(); count];
        // SAFETY: see contacts; nothing has changed since it was counted.
        check(unsafe { raw::abut_universe_validate(self.universe, findings.as_mut_ptr(), count, &mut count) })?;
        // SAFETY: the messages are terminated.
        let words = |finding: &raw::abut_finding| unsafe { std::ffi::CStr::from_ptr(finding.message.as_ptr()) };
        Ok(findings.iter().map(|finding| words(finding).to_string_lossy().into_owned()).collect())
    }

    /// Why two geometries are not examined; nothing where they are, so that the distance of their shapes decides.
    pub fn why_apart(&self, a: GeometryId, b: GeometryId) -> Result<ApartReasons> {
        let mut out = 0;
        // SAFETY: see contacts.
        check(unsafe { raw::abut_universe_why_apart(self.universe, a.raw(), b.raw(), &mut out) })?;
        Ok(ApartReasons::of_bits(out))
    }

    /// The rule that counts for two geometries, and the collidables that it names.
    pub fn rule_between(&self, a: GeometryId, b: GeometryId) -> Result<(Rule, Collidable, Collidable)> {
        let (mut rule, mut of_a, mut of_b) = (0, Collidable::Any.raw(), Collidable::Any.raw());
        // SAFETY: see contacts.
        check(unsafe {
            raw::abut_rule_between(self.universe, a.raw(), b.raw(), &mut rule, &mut of_a, &mut of_b)
        })?;
        let rule = match rule {
            raw::ABUT_RULE_ENABLE => Rule::Enable,
            raw::ABUT_RULE_DISABLE => Rule::Disable,
            _ => Rule::None,
        };
        Ok((rule, Collidable::of_raw(of_a), Collidable::of_raw(of_b)))
    }

    /// All parts, ordered by slot.
    pub fn parts(&self) -> Result<Vec<PartId>> {
        // SAFETY: see contacts; fill hands in a place for `capacity` ids, here and below.
        fill(|place, capacity, count| unsafe { raw::abut_universe_parts(self.universe, place, capacity, count) })
    }

    /// All geometries, ordered by slot.
    pub fn geometries(&self) -> Result<Vec<GeometryId>> {
        // SAFETY: see parts.
        fill(|place, capacity, count| unsafe { raw::abut_universe_geometries(self.universe, place, capacity, count) })
    }

    /// Geometries of a part, in order of creation.
    pub fn geometries_of(&self, part: PartId) -> Result<Vec<GeometryId>> {
        // SAFETY: see parts.
        fill(|place, capacity, count| unsafe {
            raw::abut_part_geometries(self.universe, part.raw(), place, capacity, count)
        })
    }

    /// Where a part is.
    pub fn pose(&self, part: PartId) -> Result<Pose> {
        self.poses(&[part]).map(|poses| poses[0])
    }

    /// Where parts are.
    pub fn poses(&self, parts: &[PartId]) -> Result<Vec<Pose>> {
        let mut out = vec![blank(); parts.len()];
        // SAFETY: see contacts; both slices are equally long.
        check(unsafe { raw::abut_parts_poses(self.universe, raw_slice(parts), parts.len(), raw_slice_mut(&mut out)) })?;
        Ok(out)
    }

    /// Your number on a part.
    pub fn user_data(&self, part: PartId) -> Result<u64> {
        let mut out = 0u64;
        // SAFETY: see contacts.
        check(unsafe { raw::abut_part_user_data(self.universe, part.raw(), raw_mut(&mut out)) })?;
        Ok(out)
    }

    /// The part that a geometry is on.
    pub fn part_of(&self, geometry: GeometryId) -> Result<PartId> {
        let part = self.describe(geometry)?.part;
        Ok(PartId { slot: part.slot, generation: part.generation })
    }

    /// The number that `GeometryOptions` has put on a geometry.
    pub fn geometry_user_data(&self, geometry: GeometryId) -> Result<u64> {
        Ok(self.describe(geometry)?.user_data)
    }

    /// The shape that a geometry has at present. It stays as it is, whatever happens to the geometry.
    pub fn shape_of(&self, geometry: GeometryId) -> Result<Shape> {
        // SAFETY: see contacts; the reference that this adds belongs to the Shape.
        Shape::made(|out| unsafe { raw::abut_geometry_shape(self.universe, geometry.raw(), out) })
    }

    fn describe(&self, geometry: GeometryId) -> Result<raw::abut_geometry_info> {
        let mut info = crate::options::defaults!(abut_geometry_info, raw::abut_geometry_info_init);
        // SAFETY: see contacts.
        check(unsafe { raw::abut_geometry_describe(self.universe, geometry.raw(), &mut info) })?;
        Ok(info)
    }
}
