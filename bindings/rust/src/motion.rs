// SPDX-License-Identifier: Apache-2.0
//! How parts move: velocities, sleep and islands.

use crate::error::{check, expect_as_many};
use crate::options::defaults;
use crate::value::{blank, mirror, raw_slice, raw_slice_mut, PartId, Vec3};
use crate::{raw, Result, Universe, View};
use std::ptr::null;

/// In the world frame. A point p of the part moves by linear + angular x (p - position of the part).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// Of the origin of the part, per second.
    pub linear: Vec3,
    /// Unit axis times radians per second.
    pub angular: Vec3,
}
mirror!(Velocity, raw::abut_velocity);

/// When a part has come to rest: its speeds and accelerations are at most these for some steps in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sleep {
    /// Calm steps in a row, at least 1.
    pub steps: u32,
    /// Of the origin of the part.
    pub linear_speed: f64,
    /// Of the origin of the part.
    pub linear_acceleration: f64,
    /// In radians.
    pub angular_speed: f64,
    /// In radians.
    pub angular_acceleration: f64,
}

impl Default for Sleep {
    fn default() -> Sleep {
        let its = defaults!(abut_sleep, raw::abut_sleep_init);
        Sleep {
            steps: its.steps,
            linear_speed: its.linear_speed,
            linear_acceleration: its.linear_acceleration,
            angular_speed: its.angular_speed,
            angular_acceleration: its.angular_acceleration,
        }
    }
}

impl Sleep {
    fn raw(&self) -> raw::abut_sleep {
        let mut sleep = defaults!(abut_sleep, raw::abut_sleep_init);
        sleep.steps = self.steps;
        sleep.linear_speed = self.linear_speed;
        sleep.linear_acceleration = self.linear_acceleration;
        sleep.angular_speed = self.angular_speed;
        sleep.angular_acceleration = self.angular_acceleration;
        sleep
    }
}

/// A part that fell asleep or woke in the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SleepChange {
    /// May be destroyed since.
    pub part: PartId,
    is_asleep: u32,
    reserved: u32,
}
mirror!(SleepChange, raw::abut_sleep_change);

impl SleepChange {
    /// Whether it fell asleep; else it woke.
    pub fn is_asleep(&self) -> bool {
        self.is_asleep != 0
    }
}

/// Where the parts of an island lie among those of all islands.
#[repr(C)]
#[derive(Clone, Copy)]
struct Island {
    id: u64,
    first_part: u32,
    part_count: u32,
}
mirror!(Island, raw::abut_island);

impl Universe {
    /// Gives parts velocities, which contacts do not depend on; they are stored and handed out.
    pub fn set_velocities(&mut self, parts: &[PartId], velocities: &[Velocity]) -> Result<()> {
        expect_as_many(("parts", parts.len()), ("velocities", velocities.len()))?;
        // SAFETY: the universe is alive, here and below; slices are as long as the count and live for the call.
        check(unsafe {
            raw::abut_parts_set_velocities(self.as_ptr(), raw_slice(parts), raw_slice(velocities), parts.len())
        })
    }

    /// From now on the velocities of parts follow from their poses.
    pub fn measure_velocities(&mut self, parts: &[PartId]) -> Result<()> {
        // SAFETY: see set_velocities.
        check(unsafe { raw::abut_parts_measure_velocities(self.as_ptr(), raw_slice(parts), parts.len()) })
    }

    /// Lets a part fall asleep when it rests; None: it never does.
    pub fn set_sleep(&mut self, part: PartId, sleep: Option<&Sleep>) -> Result<()> {
        let raw = sleep.map(Sleep::raw);
        let pointer = raw.as_ref().map_or(null(), |sleep| sleep as *const _);
        // SAFETY: see set_velocities; the pointer is null or lives for the call.
        check(unsafe { raw::abut_part_set_sleep(self.as_ptr(), part.raw(), pointer) })
    }

    /// Wakes a part at the next step.
    pub fn wake(&mut self, part: PartId) -> Result<()> {
        // SAFETY: see set_velocities.
        check(unsafe { raw::abut_part_wake(self.as_ptr(), part.raw()) })
    }

    /// Says whether steps find islands; at first they do not.
    pub fn follow_islands(&mut self, are_followed: bool) -> Result<()> {
        // SAFETY: see set_velocities.
        check(unsafe { raw::abut_universe_follow_islands(self.as_ptr(), u32::from(are_followed)) })
    }
}

impl View {
    /// Velocities of parts; zeros for one that has none.
    pub fn velocities(&self, parts: &[PartId]) -> Result<Vec<Velocity>> {
        let mut out = vec![blank(); parts.len()];
        // SAFETY: see set_velocities; both slices are equally long.
        check(unsafe {
            raw::abut_parts_velocities(self.as_ptr(), raw_slice(parts), parts.len(), raw_slice_mut(&mut out))
        })?;
        Ok(out)
    }

    /// Whether a part slept at the end of the last step.
    pub fn is_asleep(&self, part: PartId) -> Result<bool> {
        let mut out = 0;
        // SAFETY: see set_velocities.
        check(unsafe { raw::abut_part_is_asleep(self.as_ptr(), part.raw(), &mut out) })?;
        Ok(out == 1)
    }

    /// Parts that fell asleep or woke in the last step, ordered by slot.
    pub fn sleep_changes(&self) -> Result<&[SleepChange]> {
        // SAFETY: see set_velocities.
        self.lent(|values, count| unsafe { raw::abut_universe_sleep_changes(self.as_ptr(), values, count) })
    }

    /// Dynamic parts that touch each other, directly or through others: each island of the last step with its id, which
    /// stays while its parts touch, and its parts. It is
    /// `Status::Unsupported` while islands are not followed.
    pub fn islands(&self) -> Result<impl Iterator<Item = (u64, &[PartId])>> {
        // SAFETY: see set_velocities.
        let islands =
            self.lent::<Island>(|values, count| unsafe { raw::abut_universe_islands(self.as_ptr(), values, count) })?;
        // SAFETY: see set_velocities.
        let parts = self
            .lent::<PartId>(|values, count| unsafe { raw::abut_universe_island_parts(self.as_ptr(), values, count) })?;
        Ok(islands.iter().map(move |island| {
            let first = island.first_part as usize;
            (island.id, &parts[first..first + island.part_count as usize])
        }))
    }
}
