// SPDX-License-Identifier: Apache-2.0
//! abut finds where 3D shapes touch: signed distances, contacts and rays, for two shapes ([`Pair`]) or for a
//! [`Universe`] of many that move.
//!
//! Everything is in double precision and right-handed frames, in metres or any other unit of yours. Calls that fail
//! change nothing and answer an [`Error`], which names the argument and the value. [`Shape`] and [`Universe`] may go to
//! other threads. Threads may share both: what changes a universe needs it for itself (`&mut`).
//!
//! The feature `picking` adds `picking`: rays and the mouse through Embree, by a library of its own.
//!
//! What is not wrapped is in [`raw`], all of abut.h.
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]

mod contact;
mod edit;
mod error;
mod meeting;
mod motion;
mod options;
mod pair;
mod policy;
mod query;
mod ray;
mod shape;
mod universe;
mod value;
mod view;

/// Rays and the mouse against a universe, through Embree.
#[cfg(feature = "picking")]
pub mod picking;

/// The C interface; include/abut/abut.h describes each name.
#[allow(missing_docs, non_camel_case_types, non_upper_case_globals)]
pub mod raw;
/// The C interface of the picking library; include/abut/picking.h describes each name.
#[cfg(feature = "picking")]
#[allow(missing_docs, non_camel_case_types, non_upper_case_globals)]
pub mod raw_picking;

pub use contact::{Contact, Distance, Event, EventKind};
pub use error::{Error, Result, Status};
pub use meeting::{ApartReasons, Asking, Collidable, QueryFilter, RayStart, Rule};
pub use motion::{Sleep, SleepChange, Velocity};
pub use options::{
    Algorithm, Broadphase, GeometryOptions, Motion, Parking, PartOptions, QueryOptions, ToleranceMode, UniverseOptions,
};
pub use pair::{ContactLists, Pair, PairMemory};
pub use policy::{ContactMaterial, Detail, Policy};
pub use ray::{CastHit, Closest, Hit, Ray, RayHit};
pub use shape::{Shape, Sides};
pub use universe::Universe;
pub use value::{Aabb, Feature, FeatureKind, GeometryId, PartId, Pose, Vec3};
pub use view::{Stats, View};

/// Version of the library that was loaded, such as "0.2.0".
pub fn version() -> &'static str {
    // SAFETY: the text is static and ASCII.
    unsafe { std::ffi::CStr::from_ptr(raw::abut_version_string()) }.to_str().unwrap_or("")
}
