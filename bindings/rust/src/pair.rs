// SPDX-License-Identifier: Apache-2.0
//! Two shapes, outside of any universe.

use crate::contact::{Contact, Distance};
use crate::error::{check, expect_as_many};
use crate::options::QueryOptions;
use crate::ray::CastHit;
use crate::shape::Shape;
use crate::value::{blank, fill, fill_room, mirror, raw_mut, raw_of, raw_slice, raw_slice_mut, Pose, Vec3};
use crate::{raw, Result};

/// What queries remember of two shapes that move little from one to the next. It makes them faster and changes no
/// answer beyond its error bound. Keep one for each pair of bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct PairMemory {
    opaque: [u64; 8],
}
mirror!(PairMemory, raw::abut_pair_memory);

/// Two shapes to be asked at any poses.
///
/// ```
/// use abut::{Pair, Pose, Shape};
/// let (ball, cube) = (Shape::sphere(1.0)?, Shape::cuboid([1.0, 1.0, 1.0])?);
/// let found = Pair::new(&ball, &cube).distance(&Pose::IDENTITY, &Pose::at(0.0, 0.0, 3.0))?;
/// assert_eq!((found.distance, found.normal), (1.0, [0.0, 0.0, 1.0]));
/// # Ok::<(), abut::Error>(())
/// ```
///
/// It borrows the shapes:
/// ```compile_fail,E0505
/// # use abut::{Pair, Pose, Shape};
/// let (ball, cube) = (Shape::sphere(1.0)?, Shape::cuboid([1.0, 1.0, 1.0])?);
/// let pair = Pair::new(&ball, &cube);
/// drop(ball);
/// pair.distance(&Pose::IDENTITY, &Pose::IDENTITY)?;
/// # Ok::<(), abut::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pair<'shapes> {
    a: &'shapes Shape,
    b: &'shapes Shape,
    options: QueryOptions,
}

impl<'shapes> Pair<'shapes> {
    /// Two shapes with the default options.
    pub fn new(a: &'shapes Shape, b: &'shapes Shape) -> Pair<'shapes> {
        Pair::with_options(a, b, QueryOptions::default())
    }

    /// Two shapes with a margin, an algorithm or other options of yours.
    pub fn with_options(a: &'shapes Shape, b: &'shapes Shape, options: QueryOptions) -> Pair<'shapes> {
        Pair { a, b, options }
    }

    /// Their signed distance at two poses.
    pub fn distance(&self, pose_a: &Pose, pose_b: &Pose) -> Result<Distance> {
        let mut out = blank();
        // SAFETY: shapes are alive; poses and options are read, and `out` is written, during the call. So below.
        check(unsafe {
            raw::abut_pair_distance(
                self.a.as_ptr(),
                raw_of(pose_a),
                self.b.as_ptr(),
                raw_of(pose_b),
                &self.options.raw(),
                raw_mut(&mut out),
            )
        })?;
        Ok(out)
    }

    /// The same, from where the last query left off.
    pub fn distance_from(&self, memory: &mut PairMemory, pose_a: &Pose, pose_b: &Pose) -> Result<Distance> {
        let mut out = blank();
        // SAFETY: see distance; the memory is written during the call, and nobody else has it.
        check(unsafe {
            raw::abut_pair_distance_with_memory(
                self.a.as_ptr(),
                raw_of(pose_a),
                self.b.as_ptr(),
                raw_of(pose_b),
                &self.options.raw(),
                raw_mut(memory),
                raw_mut(&mut out),
            )
        })?;
        Ok(out)
    }

    /// One distance for each pair of poses, in one call.
    pub fn distances(&self, poses_a: &[Pose], poses_b: &[Pose]) -> Result<Vec<Distance>> {
        expect_as_many(("poses_a", poses_a.len()), ("poses_b", poses_b.len()))?;
        let mut out = vec![blank(); poses_a.len()];
        // SAFETY: see distance; all slices are equally long.
        check(unsafe {
            raw::abut_pairs_distance(
                self.a.as_ptr(),
                raw_slice(poses_a),
                self.b.as_ptr(),
                raw_slice(poses_b),
                poses_a.len(),
                &self.options.raw(),
                raw_slice_mut(&mut out),
            )
        })?;
        Ok(out)
    }

    /// The same with a memory for each pair of poses.
    pub fn distances_from(
        &self,
        memories: &mut [PairMemory],
        poses_a: &[Pose],
        poses_b: &[Pose],
    ) -> Result<Vec<Distance>> {
        expect_as_many(("poses_a", poses_a.len()), ("poses_b", poses_b.len()))?;
        expect_as_many(("poses_a", poses_a.len()), ("memories", memories.len()))?;
        let mut out = vec![blank(); poses_a.len()];
        // SAFETY: see distances; memories are written during the call, and nobody else has them.
        check(unsafe {
            raw::abut_pairs_distance_with_memories(
                self.a.as_ptr(),
                raw_slice(poses_a),
                self.b.as_ptr(),
                raw_slice(poses_b),
                poses_a.len(),
                &self.options.raw(),
                raw_slice_mut(memories),
                raw_slice_mut(&mut out),
            )
        })?;
        Ok(out)
    }

    /// Whether they are within the margin, by default 0. Costs a fraction of a distance or of contacts.
    pub fn overlaps(&self, pose_a: &Pose, pose_b: &Pose) -> Result<bool> {
        let mut out = 0;
        // SAFETY: see distance.
        check(unsafe {
            raw::abut_pair_overlaps(
                self.a.as_ptr(),
                raw_of(pose_a),
                self.b.as_ptr(),
                raw_of(pose_b),
                &self.options.raw(),
                &mut out,
            )
        })?;
        Ok(out == 1)
    }

    /// The same for each pair of poses, in one call.
    pub fn overlaps_of_each(&self, poses_a: &[Pose], poses_b: &[Pose]) -> Result<Vec<bool>> {
        expect_as_many(("poses_a", poses_a.len()), ("poses_b", poses_b.len()))?;
        let shapes_a = vec![self.a.as_ptr() as *const _; poses_a.len()];
        let shapes_b = vec![self.b.as_ptr() as *const _; poses_a.len()];
        let mut out = vec![0; poses_a.len()];
        // SAFETY: see distance; all slices are equally long.
        check(unsafe {
            raw::abut_pairs_overlap(
                shapes_a.as_ptr(),
                raw_slice(poses_a),
                shapes_b.as_ptr(),
                raw_slice(poses_b),
                poses_a.len(),
                &self.options.raw(),
                out.as_mut_ptr(),
            )
        })?;
        Ok(out.into_iter().map(|answer| answer == 1).collect())
    }

    /// Their contact points, deepest first; none when they are further apart than the margin.
    pub fn contacts(&self, pose_a: &Pose, pose_b: &Pose) -> Result<Vec<Contact>> {
        // SAFETY: see distance; fill hands in a place for `capacity` contacts.
        fill(|place, capacity, count| unsafe {
            raw::abut_pair_contacts(
                self.a.as_ptr(),
                raw_of(pose_a),
                self.b.as_ptr(),
                raw_of(pose_b),
                &self.options.raw(),
                place,
                capacity,
                count,
            )
        })
    }

    /// The same, from where the last query left off.
    pub fn contacts_from(&self, memory: &mut PairMemory, pose_a: &Pose, pose_b: &Pose) -> Result<Vec<Contact>> {
        // SAFETY: see contacts; the memory is written during the call, and nobody else has it.
        fill(|place, capacity, count| unsafe {
            raw::abut_pair_contacts_with_memory(
                self.a.as_ptr(),
                raw_of(pose_a),
                self.b.as_ptr(),
                raw_of(pose_b),
                &self.options.raw(),
                raw_mut(memory),
                place,
                capacity,
                count,
            )
        })
    }

    /// Contact points for each pair of poses, in one call.
    pub fn contacts_of_each(&self, poses_a: &[Pose], poses_b: &[Pose]) -> Result<ContactLists> {
        expect_as_many(("poses_a", poses_a.len()), ("poses_b", poses_b.len()))?;
        // SAFETY: see contacts; both slices are equally long, and offsets are one more.
        fill_lists(poses_a.len(), |offsets, place, capacity, count| unsafe {
            raw::abut_pairs_contacts(
                self.a.as_ptr(),
                raw_slice(poses_a),
                self.b.as_ptr(),
                raw_slice(poses_b),
                poses_a.len(),
                &self.options.raw(),
                offsets,
                place,
                capacity,
                count,
            )
        })
    }

    /// The same with a memory for each pair of poses.
    pub fn contacts_of_each_from(
        &self,
        memories: &mut [PairMemory],
        poses_a: &[Pose],
        poses_b: &[Pose],
    ) -> Result<ContactLists> {
        expect_as_many(("poses_a", poses_a.len()), ("poses_b", poses_b.len()))?;
        expect_as_many(("poses_a", poses_a.len()), ("memories", memories.len()))?;
        // SAFETY: see contacts_of_each; memories are written during the call, and nobody else has them.
        fill_lists(poses_a.len(), |offsets, place, capacity, count| unsafe {
            raw::abut_pairs_contacts_with_memories(
                self.a.as_ptr(),
                raw_slice(poses_a),
                self.b.as_ptr(),
                raw_slice(poses_b),
                poses_a.len(),
                &self.options.raw(),
                raw_slice_mut(memories),
                offsets,
                place,
                capacity,
                count,
            )
        })
    }

    /// When they first touch while both move by a displacement without turning; None when they do not.
    pub fn cast(&self, a: (&Pose, Vec3), b: (&Pose, Vec3)) -> Result<Option<CastHit>> {
        let (mut hit, mut found) = (blank(), 0);
        // SAFETY: see distance; displacements are read, and `found` is written, during the call.
        check(unsafe {
            raw::abut_pair_cast(
                self.a.as_ptr(),
                raw_of(a.0),
                raw_of(&a.1),
                self.b.as_ptr(),
                raw_of(b.0),
                raw_of(&b.1),
                &self.options.raw(),
                raw_mut(&mut hit),
                &mut found,
            )
        })?;
        Ok((found == 1).then_some(hit))
    }

    /// The same for each pair of poses and displacements, in one call.
    pub fn casts(&self, a: (&[Pose], &[Vec3]), b: (&[Pose], &[Vec3])) -> Result<Vec<Option<CastHit>>> {
        let count = a.0.len();
        expect_as_many(("poses_a", count), ("displacements_a", a.1.len()))?;
        expect_as_many(("poses_a", count), ("poses_b", b.0.len()))?;
        expect_as_many(("poses_a", count), ("displacements_b", b.1.len()))?;
        let mut hits = vec![blank::<CastHit>(); count];
        // SAFETY: see cast; all slices are equally long.
        check(unsafe {
            raw::abut_pairs_cast(
                self.a.as_ptr(),
                raw_slice(a.0),
                raw_slice(a.1),
                self.b.as_ptr(),
                raw_slice(b.0),
                raw_slice(b.1),
                count,
                &self.options.raw(),
                raw_slice_mut(&mut hits),
            )
        })?;
        Ok(hits.into_iter().map(|hit| hit.fraction.is_finite().then_some(hit)).collect())
    }
}

fn fill_lists(
    pairs: usize,
    mut call: impl FnMut(*mut u64, *mut raw::abut_contact, usize, *mut usize) -> raw::abut_status,
) -> Result<ContactLists> {
    let mut offsets = vec![0; pairs + 1];
    let contacts = fill_room(4 * pairs, |place, capacity, count| call(offsets.as_mut_ptr(), place, capacity, count))?;
    Ok(ContactLists { offsets, contacts })
}

/// Contacts of many pairs, pair after pair.
#[derive(Clone, Debug, Default)]
pub struct ContactLists {
    offsets: Vec<u64>,
    contacts: Vec<Contact>,
}

impl ContactLists {
    /// How many pairs there are.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Contacts of one pair, deepest first. Panics when there is no such pair.
    pub fn of(&self, pair: usize) -> &[Contact] {
        &self.contacts[self.offsets[pair] as usize..self.offsets[pair + 1] as usize]
    }

    /// Contacts of each pair, in their order.
    pub fn iter(&self) -> impl Iterator<Item = &[Contact]> {
        (0..self.len()).map(|pair| self.of(pair))
    }

    /// Contacts of all pairs, one after the other.
    pub fn all(&self) -> &[Contact] {
        &self.contacts
    }
}
