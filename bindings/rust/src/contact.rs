// SPDX-License-Identifier: Apache-2.0
//! What two shapes have between them: a distance, or contacts.

use crate::raw;
use crate::value::{mirror, Feature, GeometryId, Vec3};

/// The signed distance of two shapes, closest or deepest points and normal.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// Negative: the depth by which they overlap, the least translation that parts them.
    pub distance: f64,
    /// The true distance lies between this and `upper`, up to rounding.
    pub lower: f64,
    /// See `lower`.
    pub upper: f64,
    /// On the surface of a, in the world frame.
    pub point_a: Vec3,
    /// On the surface of b, in the world frame.
    pub point_b: Vec3,
    /// Unit, from a to b.
    pub normal: Vec3,
    algorithm: u32,
    /// Steps that it took.
    pub iterations: u32,
}
mirror!(Distance, raw::abut_distance);

/// One contact point of two shapes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Null outside of a universe.
    pub geometry_a: GeometryId,
    /// Null outside of a universe.
    pub geometry_b: GeometryId,
    /// Unique within the pair, and the same while the same features touch.
    pub id: u64,
    /// What of a touches.
    pub feature_a: Feature,
    /// What of b touches.
    pub feature_b: Feature,
    /// Of a composite, or the particle; 0 for all other shapes.
    pub child_a: u32,
    /// The same of b.
    pub child_b: u32,
    /// On the surface of a, in the world frame.
    pub point_a: Vec3,
    /// On the surface of b, in the world frame.
    pub point_b: Vec3,
    /// Unit, from a to b.
    pub normal: Vec3,
    /// Negative: overlapping.
    pub distance: f64,
    /// The fraction of the step at first touch.
    pub toi: f64,
    flags: u32,
    /// Steps in a row before this one that reported it; 0 outside of a universe.
    pub age: u32,
    /// As `Universe::set_contact_data` left it, while the contact stays.
    pub user_data: u64,
    /// Of the geometries, or of children that have one of their own.
    pub material_a: u32,
    /// The same of b.
    pub material_b: u32,
    /// Unit, at right angles to the normal: the first axis of friction.
    pub tangent: Vec3,
    reserved: u64,
}
mirror!(Contact, raw::abut_contact);

impl Contact {
    /// How far the shapes overlap there; negative when they are apart.
    pub fn depth(&self) -> f64 {
        -self.distance
    }

    /// Whether a geometry of the pair is a sensor: report the contact, do not respond to it.
    pub fn is_sensor(&self) -> bool {
        self.flags & raw::ABUT_CONTACT_SENSOR != 0
    }
}

/// A pair, or one of its contacts, that began to touch, still touches or ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    kind: u32,
    flags: u32,
    /// May be destroyed at an end.
    pub geometry_a: GeometryId,
    /// May be destroyed at an end.
    pub geometry_b: GeometryId,
    /// Of the contact; 0 for a pair.
    pub contact_id: u64,
    /// Index of the first contact of the pair, or of the contact; 0 at an end.
    pub first_contact: u32,
    /// How many contacts it is about; 0 at an end.
    pub contact_count: u32,
}
mirror!(Event, raw::abut_event);

/// What an event tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EventKind {
    /// It touches since this step.
    Begin,
    /// It still touches.
    Persist,
    /// It does not touch any more.
    End,
}

impl Event {
    /// Whether the touch began, goes on or ended.
    pub fn kind(&self) -> EventKind {
        match self.kind {
            raw::ABUT_EVENT_BEGIN => EventKind::Begin,
            raw::ABUT_EVENT_END => EventKind::End,
            _ => EventKind::Persist,
        }
    }

    /// Whether it is about one contact, not about the pair.
    pub fn is_of_contact(&self) -> bool {
        self.flags & raw::ABUT_EVENT_CONTACT != 0
    }

    /// Whether a geometry of the pair is a sensor.
    pub fn is_sensor(&self) -> bool {
        self.flags & raw::ABUT_EVENT_SENSOR != 0
    }
}
