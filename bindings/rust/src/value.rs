// SPDX-License-Identifier: Apache-2.0
//! Plain values that look the same on both sides of the C interface.

use crate::raw;

/// x, y, z.
pub type Vec3 = [f64; 3];

/// A type with the size, the alignment and the fields of a struct of the C interface.
///
/// # Safety
/// Each bit pattern that the library writes must be a value of the type.
pub(crate) unsafe trait Mirror: Copy {
    type Raw;
}

macro_rules! mirror {
    ($ours:ty, $raw:ty) => {
        const _: () = assert!(
            std::mem::size_of::<$ours>() == std::mem::size_of::<$raw>()
                && std::mem::align_of::<$ours>() == std::mem::align_of::<$raw>()
        );
        // SAFETY: repr(C) with the fields of the header in its order; tests/layout.rs compares them.
        unsafe impl crate::value::Mirror for $ours {
            type Raw = $raw;
        }
    };
}
pub(crate) use mirror;

mirror!(f64, f64);
mirror!(Vec3, raw::abut_vec3);

pub(crate) fn raw_of<T: Mirror>(value: &T) -> *const T::Raw {
    (value as *const T).cast()
}

pub(crate) fn raw_slice<T: Mirror>(values: &[T]) -> *const T::Raw {
    values.as_ptr().cast()
}

pub(crate) fn raw_slice_mut<T: Mirror>(values: &mut [T]) -> *mut T::Raw {
    values.as_mut_ptr().cast()
}

/// A zeroed value, for the library to write.
pub(crate) fn blank<T: Mirror>() -> T {
    // SAFETY: mirrors hold numbers and arrays of numbers, for which zeros are values.
    unsafe { std::mem::zeroed() }
}

pub(crate) fn raw_mut<T: Mirror>(value: &mut T) -> *mut T::Raw {
    (value as *mut T).cast()
}

/// Where a shape or a part is: it maps local points p to orientation * p + position.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// In metres, or any other unit of yours.
    pub position: Vec3,
    /// Unit quaternion w, x, y, z.
    pub orientation: [f64; 4],
}
mirror!(Pose, raw::abut_pose);

impl Pose {
    /// At the origin and not turned.
    pub const IDENTITY: Pose = Pose { position: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] };

    /// At a place and not turned.
    pub const fn at(x: f64, y: f64, z: f64) -> Pose {
        Pose { position: [x, y, z], orientation: [1.0, 0.0, 0.0, 0.0] }
    }
}

impl Pose {
    pub(crate) fn raw(&self) -> raw::abut_pose {
        let ([x, y, z], [w, i, j, k]) = (self.position, self.orientation);
        raw::abut_pose { position: raw::abut_vec3 { x, y, z }, orientation: raw::abut_quat { w, x: i, y: j, z: k } }
    }
}

impl Default for Pose {
    fn default() -> Pose {
        Pose::IDENTITY
    }
}

/// A box along the axes. Unbounded shapes have infinite sides.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Its least corner.
    pub minimum: Vec3,
    /// Its greatest corner.
    pub maximum: Vec3,
}
mirror!(Aabb, raw::abut_aabb);

/// A part of a universe. It stays harmless when the part is gone: calls answer `Status::StaleId`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartId {
    pub(crate) slot: u32,
    pub(crate) generation: u32,
}
mirror!(PartId, raw::abut_part_id);

/// A geometry of a universe: a shape placed on a part.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GeometryId {
    pub(crate) slot: u32,
    pub(crate) generation: u32,
}
mirror!(GeometryId, raw::abut_geometry_id);

impl PartId {
    /// Names nothing.
    pub const NULL: PartId = PartId { slot: 0, generation: 0 };

    pub(crate) fn raw(self) -> raw::abut_part_id {
        raw::abut_part_id { slot: self.slot, generation: self.generation }
    }
}

impl GeometryId {
    /// Names nothing, as in contacts of two shapes outside of a universe.
    pub const NULL: GeometryId = GeometryId { slot: 0, generation: 0 };

    pub(crate) fn raw(self) -> raw::abut_geometry_id {
        raw::abut_geometry_id { slot: self.slot, generation: self.generation }
    }

    pub(crate) fn from_raw(id: raw::abut_geometry_id) -> GeometryId {
        GeometryId { slot: id.slot, generation: id.generation }
    }
}

/// What of a shape takes part in a contact or is hit by a ray.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Feature {
    kind: u32,
    /// The numbering is the shape's own.
    pub index: u32,
}
mirror!(Feature, raw::abut_feature);

/// The kinds of feature.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FeatureKind {
    /// No corner, edge or face is told apart.
    Whole,
    /// A corner, or the centre of a sphere.
    Vertex,
    /// An edge.
    Edge,
    /// A face; of a mesh or a height field the triangle.
    Face,
    /// One of many particles.
    Particle,
}

impl Feature {
    /// Whether it is a corner, an edge, a face or another kind.
    pub fn kind(&self) -> FeatureKind {
        match self.kind {
            raw::ABUT_FEATURE_VERTEX => FeatureKind::Vertex,
            raw::ABUT_FEATURE_EDGE => FeatureKind::Edge,
            raw::ABUT_FEATURE_FACE => FeatureKind::Face,
            raw::ABUT_FEATURE_PARTICLE => FeatureKind::Particle,
            _ => FeatureKind::Whole,
        }
    }
}

/// Calls a function that fills as much of a slice as there is, and tells how much there would be.
pub(crate) fn fill<T: Mirror>(
    call: impl FnMut(*mut T::Raw, usize, *mut usize) -> raw::abut_status,
) -> crate::Result<Vec<T>> {
    fill_room(8, call)
}

/// The same with room for as many at first: where it does not suffice, the function is called twice.
pub(crate) fn fill_room<T: Mirror>(
    room: usize,
    mut call: impl FnMut(*mut T::Raw, usize, *mut usize) -> raw::abut_status,
) -> crate::Result<Vec<T>> {
    let mut values = vec![blank::<T>(); room];
    loop {
        let mut count = 0;
        crate::error::check(call(raw_slice_mut(&mut values), values.len(), &mut count))?;
        let is_complete = count <= values.len();
        values.resize(count, blank());
        if is_complete {
            return Ok(values);
        }
    }
}
