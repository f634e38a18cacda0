// SPDX-License-Identifier: Apache-2.0
//! Who meets whom: rules, the filter of a universe, and what queries look at.

use crate::options::{defaults, Parking};
use crate::value::{GeometryId, PartId};
use crate::view::View;
use crate::{error, raw, Result};
use std::any::Any;
use std::ops::Deref;
use std::os::raw::c_void;
use std::panic::{catch_unwind, AssertUnwindSafe};

/// What a rule speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Collidable {
    /// One geometry.
    Geometry(GeometryId),
    /// All geometries of a part.
    Part(PartId),
    /// All geometries with a label.
    Label(u32),
    /// Anything.
    Any,
}

impl Collidable {
    pub(crate) fn raw(self) -> raw::abut_collidable {
        let (kind, slot, generation) = match self {
            Collidable::Geometry(id) => (raw::ABUT_COLLIDABLE_GEOMETRY, id.slot, id.generation),
            Collidable::Part(id) => (raw::ABUT_COLLIDABLE_PART, id.slot, id.generation),
            Collidable::Label(label) => (raw::ABUT_COLLIDABLE_LABEL, label, 0),
            Collidable::Any => (raw::ABUT_COLLIDABLE_ANY, 0, 0),
        };
        raw::abut_collidable { kind, slot, generation }
    }
}

impl Collidable {
    pub(crate) fn of_raw(its: raw::abut_collidable) -> Collidable {
        let raw::abut_collidable { kind, slot, generation } = its;
        match kind {
            raw::ABUT_COLLIDABLE_GEOMETRY => Collidable::Geometry(GeometryId { slot, generation }),
            raw::ABUT_COLLIDABLE_PART => Collidable::Part(PartId { slot, generation }),
            raw::ABUT_COLLIDABLE_LABEL => Collidable::Label(slot),
            _ => Collidable::Any,
        }
    }
}

/// What keeps two geometries from being examined: all reasons that hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ApartReasons {
    /// They are on one part, or are one geometry that does not meet itself.
    pub part: bool,
    /// Neither part is dynamic.
    pub motion: bool,
    /// One of them is parked.
    pub parking: bool,
    /// They have an exclusion bit in common.
    pub exclusion: bool,
    /// The layers of one do not meet the mask of the other.
    pub layers: bool,
    /// The rule that counts disables them.
    pub rule: bool,
    /// The filter said no when it was asked last.
    pub filter: bool,
    /// Their kinds have no algorithm.
    pub kinds: bool,
    /// Their boxes do not overlap.
    pub boxes: bool,
    /// A policy asks about their boxes only.
    pub policy: bool,
    /// The last detection has not looked at them as they are now.
    pub detection: bool,
    /// One is a surface of one side, and the other overlaps it from the back.
    pub side: bool,
}

impl ApartReasons {
    pub(crate) fn of_bits(bits: u32) -> ApartReasons {
        let has = |bit| bits & bit != 0;
        ApartReasons {
            part: has(raw::ABUT_APART_PART),
            motion: has(raw::ABUT_APART_MOTION),
            parking: has(raw::ABUT_APART_PARKING),
            exclusion: has(raw::ABUT_APART_EXCLUSION),
            layers: has(raw::ABUT_APART_LAYERS),
            rule: has(raw::ABUT_APART_RULE),
            filter: has(raw::ABUT_APART_FILTER),
            kinds: has(raw::ABUT_APART_KINDS),
            boxes: has(raw::ABUT_APART_BOXES),
            policy: has(raw::ABUT_APART_POLICY),
            detection: has(raw::ABUT_APART_DETECTION),
            side: has(raw::ABUT_APART_SIDE),
        }
    }
}

/// What a rule says. The most specific one that fits a pair counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Rule {
    /// Takes the rule away; of two geometries: no rule speaks of them.
    None = raw::ABUT_RULE_NONE,
    /// They meet.
    Enable = raw::ABUT_RULE_ENABLE,
    /// They do not.
    Disable = raw::ABUT_RULE_DISABLE,
}

/// What a ray meets that starts inside a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum RayStart {
    /// Its far side.
    FarSide = raw::ABUT_RAY_START_FAR_SIDE,
    /// The solid, at distance 0 and with a normal of zeros.
    Solid = raw::ABUT_RAY_START_SOLID,
    /// Nothing of that geometry.
    Skip = raw::ABUT_RAY_START_SKIP,
}

/// Which geometries a query of a universe looks at; by default all.
#[derive(Clone, Copy, Debug)]
pub struct QueryFilter {
    /// Leaves sensors out.
    pub skips_sensors: bool,
    /// What the query is, for masks of geometries.
    pub layers: u64,
    /// Which layers of geometries it meets.
    pub mask: u64,
    /// A part that is left out with all its geometries.
    pub ignore_part: PartId,
    /// A geometry that is left out.
    pub ignore_geometry: GeometryId,
    /// What a ray meets that starts inside a solid.
    pub ray_start: RayStart,
}

impl Default for QueryFilter {
    fn default() -> QueryFilter {
        QueryFilter {
            skips_sensors: false,
            layers: u64::MAX,
            mask: u64::MAX,
            ignore_part: PartId::NULL,
            ignore_geometry: GeometryId::NULL,
            ray_start: RayStart::FarSide,
        }
    }
}

impl QueryFilter {
    pub(crate) fn raw(&self) -> raw::abut_query_filter {
        let mut filter = defaults!(abut_query_filter, raw::abut_query_filter_init);
        filter.flags = if self.skips_sensors { raw::ABUT_QUERY_FILTER_SKIP_SENSORS } else { 0 };
        filter.layers = self.layers;
        filter.mask = self.mask;
        filter.ignore_part = self.ignore_part.raw();
        filter.ignore_geometry = self.ignore_geometry.raw();
        filter.ray_start = self.ray_start as u32;
        filter
    }
}

/// A universe as its filter sees it in a step: poses are those of the step, contacts and events those before it.
pub struct Asking<'step> {
    view: &'step View,
}

impl Asking<'_> {
    /// Parks a geometry, or brings it back, when the step is over.
    pub fn park(&self, geometry: GeometryId, parking: Parking) -> Result<()> {
        // SAFETY: the universe is alive, and this is the one call that a filter may make of those that change it.
        error::check(unsafe { raw::abut_geometry_park(self.view.as_ptr(), geometry.raw(), parking as u32) })
    }
}

impl Deref for Asking<'_> {
    type Target = View;

    fn deref(&self) -> &View {
        self.view
    }
}

type Keeps = dyn FnMut(&Asking<'_>, GeometryId, GeometryId) -> bool + Send;

/// A filter at a place that stays, since the library keeps its address.
pub(crate) struct Filter {
    keeps: Box<Keeps>,
    universe: *mut raw::abut_universe,
    panic: Option<Box<dyn Any + Send>>,
}

impl Filter {
    pub(crate) fn new(universe: *mut raw::abut_universe, keeps: Box<Keeps>) -> Filter {
        Filter { keeps, universe, panic: None }
    }

    /// What the filter panicked with in the last detection, if it did.
    pub(crate) fn take_panic(&mut self) -> Option<Box<dyn Any + Send>> {
        self.panic.take()
    }
}

/// Asks the filter that `context` points to. A panic must not pass through C: it is kept for the end of the step, and
/// the pair is kept, too.
pub(crate) unsafe extern "C" fn ask(
    context: *mut c_void,
    _universe: *const raw::abut_universe,
    a: raw::abut_geometry_id,
    b: raw::abut_geometry_id,
) -> u32 {
    // SAFETY: the context is the Filter of the universe, which nobody else touches during a step.
    let filter = unsafe { &mut *context.cast::<Filter>() };
    if filter.panic.is_some() {
        return 1;
    }
    // SAFETY: the universe is alive during its step.
    let view = unsafe { View::new(filter.universe) };
    let keeps = &mut filter.keeps;
    let asked = AssertUnwindSafe(|| keeps(&Asking { view: &view }, GeometryId::from_raw(a), GeometryId::from_raw(b)));
    match catch_unwind(asked) {
        Ok(is_kept) => u32::from(is_kept),
        Err(panic) => {
            filter.panic = Some(panic);
            1
        }
    }
}
