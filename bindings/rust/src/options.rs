// SPDX-License-Identifier: Apache-2.0
//! What calls can be told, each with the defaults of the library.

use crate::raw;
use crate::value::{Pose, Vec3};

macro_rules! defaults {
    ($name:ident, $init:path) => {{
        let mut options = raw::$name::default();
        // SAFETY: the function writes the struct, whose size it is told.
        unsafe { $init(&mut options, std::mem::size_of::<raw::$name>() as u32) };
        options
    }};
}
pub(crate) use defaults;

/// Which search answers two shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Algorithm {
    /// The fastest that keeps the error bound.
    Auto = raw::ABUT_ALGORITHM_AUTO,
    /// Closed forms, where the pair has any.
    Analytic = raw::ABUT_ALGORITHM_ANALYTIC,
    /// Separating axes.
    Sat = raw::ABUT_ALGORITHM_SAT,
    /// Support points, GJK and EPA of abut.
    GjkEpa = raw::ABUT_ALGORITHM_GJK_EPA,
    /// GJK and EPA of libccd.
    LibccdGjk = raw::ABUT_ALGORITHM_LIBCCD_GJK,
    /// Minkowski portal refinement of libccd.
    LibccdMpr = raw::ABUT_ALGORITHM_LIBCCD_MPR,
}

/// How two shapes are asked.
#[derive(Clone, Copy, Debug)]
pub struct QueryOptions {
    /// Which search answers.
    pub algorithm: Algorithm,
    /// The allowed width of the interval of a distance, relative to the size of the shapes; 0 for the default.
    pub error_bound: f64,
    /// Contacts are reported up to this distance; may be negative.
    pub margin: f64,
    /// How many contacts a patch keeps; 0 for all.
    pub max_contacts: u32,
    /// How many all patches of a pair keep together; 0 for all.
    pub max_pair_contacts: u32,
    /// Of a batch; 0 for as many as there may be. Results are the same bits for any number.
    pub threads: u32,
    /// Whether convex children of composites that lie side by side have contacts as one shape.
    pub welds: bool,
}

impl Default for QueryOptions {
    fn default() -> QueryOptions {
        let its = defaults!(abut_query_options, raw::abut_query_options_init);
        QueryOptions {
            algorithm: Algorithm::Auto,
            error_bound: its.error_bound,
            margin: its.margin,
            max_contacts: its.max_contacts,
            max_pair_contacts: its.max_pair_contacts,
            threads: its.threads,
            welds: false,
        }
    }
}

impl QueryOptions {
    pub(crate) fn raw(&self) -> raw::abut_query_options {
        let mut options = defaults!(abut_query_options, raw::abut_query_options_init);
        options.algorithm = self.algorithm as u32;
        options.error_bound = self.error_bound;
        options.margin = self.margin;
        options.max_contacts = self.max_contacts;
        options.max_pair_contacts = self.max_pair_contacts;
        options.threads = self.threads;
        options.flags = if self.welds { raw::ABUT_QUERY_WELDS } else { 0 };
        options
    }
}

/// What the tolerance of a pair means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum ToleranceMode {
    /// An overlap is reported when it exceeds the tolerance.
    DeadBand = raw::ABUT_TOLERANCE_DEAD_BAND,
    /// A separation is reported when it is below the tolerance.
    Margin = raw::ABUT_TOLERANCE_MARGIN,
}

/// How pairs of overlapping boxes are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Broadphase {
    /// The library chooses.
    Auto = raw::ABUT_BROADPHASE_AUTO,
    /// Every pair; for a few dozen geometries.
    Brute = raw::ABUT_BROADPHASE_BRUTE,
    /// Dynamic trees of boxes.
    Tree = raw::ABUT_BROADPHASE_TREE,
    /// Sorted ends on three axes.
    SweepAndPrune = raw::ABUT_BROADPHASE_SWEEP_AND_PRUNE,
    /// Grids of cells, for many boxes of about one size.
    HashGrid = raw::ABUT_BROADPHASE_HASH_GRID,
}

/// What a universe is made with.
#[derive(Clone, Copy, Debug)]
pub struct UniverseOptions {
    /// How pairs of overlapping boxes are found.
    pub broadphase: Broadphase,
    /// What the tolerance of a pair means.
    pub tolerance_mode: ToleranceMode,
    /// How many contacts hold a patch; 0 for all.
    pub max_contacts: u32,
    /// How many all patches of a pair keep together; 0 for all.
    pub max_pair_contacts: u32,
    /// Boxes of the broad phase are stored relative to it.
    pub origin: Vec3,
    /// Of a step; 0 for as many as there may be. Results are the same bits for any number.
    pub threads: u32,
    /// Whether static geometries that lie side by side have contacts as one shape.
    pub welds: bool,
    /// Whether steps also tell about pairs that still touch.
    pub persist_events: bool,
    /// Whether steps tell about each contact, not only about pairs.
    pub contact_events: bool,
}

impl Default for UniverseOptions {
    fn default() -> UniverseOptions {
        let its = defaults!(abut_universe_options, raw::abut_universe_options_init);
        UniverseOptions {
            broadphase: Broadphase::Auto,
            tolerance_mode: ToleranceMode::DeadBand,
            max_contacts: its.max_contacts,
            max_pair_contacts: its.max_pair_contacts,
            origin: [0.0; 3],
            threads: its.threads,
            welds: false,
            persist_events: its.events & raw::ABUT_EVENTS_PERSIST != 0,
            contact_events: its.events & raw::ABUT_EVENTS_CONTACTS != 0,
        }
    }
}

impl UniverseOptions {
    pub(crate) fn raw(&self) -> raw::abut_universe_options {
        let mut options = defaults!(abut_universe_options, raw::abut_universe_options_init);
        let [x, y, z] = self.origin;
        options.broadphase = self.broadphase as u32;
        options.tolerance_mode = self.tolerance_mode as u32;
        options.max_contacts = self.max_contacts;
        options.max_pair_contacts = self.max_pair_contacts;
        options.origin = raw::abut_vec3 { x, y, z };
        options.threads = self.threads;
        options.flags = if self.welds { raw::ABUT_UNIVERSE_WELDS } else { 0 };
        options.events = raw::ABUT_EVENTS_PAIRS
            | if self.persist_events { raw::ABUT_EVENTS_PERSIST } else { 0 }
            | if self.contact_events { raw::ABUT_EVENTS_CONTACTS } else { 0 };
        options
    }
}

/// How a part moves. Pairs of parts of which neither is dynamic are never examined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Motion {
    /// Moved by forces of yours.
    Dynamic = raw::ABUT_MOTION_DYNAMIC,
    /// Moved by a script.
    Animated = raw::ABUT_MOTION_ANIMATED,
    /// Not moved.
    Static = raw::ABUT_MOTION_STATIC,
}

/// What a part is made with.
#[derive(Clone, Copy, Debug)]
pub struct PartOptions {
    /// How it moves.
    pub motion: Motion,
    /// Where it is.
    pub pose: Pose,
    /// A number of yours.
    pub user_data: u64,
}

impl Default for PartOptions {
    fn default() -> PartOptions {
        PartOptions { motion: Motion::Dynamic, pose: Pose::IDENTITY, user_data: 0 }
    }
}

impl PartOptions {
    /// A dynamic part at a pose.
    pub fn at(pose: Pose) -> PartOptions {
        PartOptions { pose, ..PartOptions::default() }
    }

    pub(crate) fn raw(&self) -> raw::abut_part_options {
        let mut options = defaults!(abut_part_options, raw::abut_part_options_init);
        options.motion = self.motion as u32;
        options.pose = self.pose.raw();
        options.user_data = self.user_data;
        options
    }
}

/// Whether a geometry takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Parking {
    /// It does.
    None = raw::ABUT_PARKING_NONE,
    /// It meets nothing and keeps its place in the broad phase.
    ShortTerm = raw::ABUT_PARKING_SHORT_TERM,
    /// It meets nothing and costs nothing in a step.
    LongTerm = raw::ABUT_PARKING_LONG_TERM,
}

/// What a geometry is made with. docs/universe.md says who meets whom.
#[derive(Clone, Copy, Debug)]
pub struct GeometryOptions {
    /// Its contacts say so, and are not to be responded to.
    pub is_sensor: bool,
    /// A mesh or particles that meet themselves.
    pub meets_itself: bool,
    /// In the frame of the part.
    pub pose: Pose,
    /// The tolerance of a pair is the sum of both.
    pub tolerance: f64,
    /// A number of yours.
    pub user_data: u64,
    /// What it is, as bits of your meaning.
    pub layers: u64,
    /// The layers that it meets.
    pub mask: u64,
    /// Geometries that have a bit in common never meet.
    pub exclusion: u64,
    /// For rules.
    pub label: u32,
    /// For policies, below 64.
    pub tag: u32,
    /// Carried to its contacts.
    pub material: u32,
    /// Whether it takes part.
    pub parking: Parking,
}

impl Default for GeometryOptions {
    fn default() -> GeometryOptions {
        let its = defaults!(abut_geometry_options, raw::abut_geometry_options_init);
        GeometryOptions {
            is_sensor: false,
            meets_itself: false,
            pose: Pose::IDENTITY,
            tolerance: its.tolerance,
            user_data: its.user_data,
            layers: its.layers,
            mask: its.mask,
            exclusion: its.exclusion,
            label: its.label,
            tag: its.tag,
            material: its.material,
            parking: Parking::None,
        }
    }
}

impl GeometryOptions {
    pub(crate) fn raw(&self) -> raw::abut_geometry_options {
        let mut options = defaults!(abut_geometry_options, raw::abut_geometry_options_init);
        options.flags = if self.is_sensor { raw::ABUT_GEOMETRY_SENSOR } else { 0 }
            | if self.meets_itself { raw::ABUT_GEOMETRY_SELF_PAIRS } else { 0 };
        options.pose = self.pose.raw();
        options.tolerance = self.tolerance;
        options.user_data = self.user_data;
        options.layers = self.layers;
        options.mask = self.mask;
        options.exclusion = self.exclusion;
        options.label = self.label;
        options.tag = self.tag;
        options.material = self.material;
        options.parking = self.parking as u32;
        options
    }
}
