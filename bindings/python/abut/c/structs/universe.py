# SPDX-License-Identifier: Apache-2.0
"""Structs about a universe."""

from __future__ import annotations

from .base import Address, Double, Message, Struct, UInt32, UInt64, struct
from .values import GeometryId, PartId, Pose, Vec3


@struct
class LocalPoints(Struct):
    a: Vec3
    b: Vec3


@struct
class UniverseOptions(Struct):
    struct_size: UInt32
    broadphase: UInt32
    tolerance_mode: UInt32
    max_contacts: UInt32
    origin: Vec3
    threads: UInt32
    events: UInt32
    flags: UInt32
    max_pair_contacts: UInt32


@struct
class PartOptions(Struct):
    struct_size: UInt32
    motion: UInt32
    pose: Pose
    user_data: UInt64


@struct
class GeometryOptions(Struct):
    struct_size: UInt32
    flags: UInt32
    pose: Pose
    tolerance: Double
    user_data: UInt64
    layers: UInt64
    mask: UInt64
    exclusion: UInt64
    label: UInt32
    tag: UInt32
    material: UInt32
    parking: UInt32


@struct
class GeometryInfo(Struct):
    struct_size: UInt32
    kind: UInt32
    part: PartId
    shape: Address
    pose: Pose
    local: Pose
    tolerance: Double
    user_data: UInt64
    layers: UInt64
    mask: UInt64
    exclusion: UInt64
    label: UInt32
    tag: UInt32
    material: UInt32
    parking: UInt32
    flags: UInt32
    reserved: UInt32


@struct
class Revision(Struct):
    geometries: UInt64
    poses: UInt64


@struct
class Collidable(Struct):
    kind: UInt32
    slot: UInt32
    generation: UInt32


@struct
class Policy(Struct):
    struct_size: UInt32
    algorithm: UInt32
    detail: UInt32
    period: UInt32
    tolerance: Double
    error_bound: Double


@struct
class Focus(Struct):
    struct_size: UInt32
    near_tag: UInt32
    far_tag: UInt32
    reserved: UInt32
    near_distance: Double
    far_distance: Double


@struct
class ContactMaterial(Struct):
    struct_size: UInt32
    reserved: UInt32
    friction_primary: Double
    friction_secondary: Double
    friction_spin: Double
    friction_roll: Double
    static_scale: Double
    slip: Double
    compliance: Double
    damping: Double
    restitution: Double
    restitution_threshold: Double
    adhesive_force: Double


@struct
class Finding(Struct):
    code: UInt32
    reserved: UInt32
    geometry: GeometryId
    other: GeometryId
    message: Message


@struct
class Sleep(Struct):
    struct_size: UInt32
    steps: UInt32
    linear_speed: Double
    linear_acceleration: Double
    angular_speed: Double
    angular_acceleration: Double


@struct
class SleepChange(Struct):
    part: PartId
    is_asleep: UInt32
    reserved: UInt32


@struct
class Island(Struct):
    id: UInt64
    first_part: UInt32
    part_count: UInt32


@struct
class Velocity(Struct):
    linear: Vec3
    angular: Vec3


@struct
class Acceleration(Struct):
    linear: Vec3
    angular: Vec3


@struct
class StepImpact(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    lower: Double
    upper: Double
    first_contact: UInt32
    contact_count: UInt32
    is_undecided: UInt32
    reserved: UInt32


@struct
class Event(Struct):
    kind: UInt32
    flags: UInt32
    geometry_a: GeometryId
    geometry_b: GeometryId
    contact_id: UInt64
    first_contact: UInt32
    contact_count: UInt32


@struct
class StepStats(Struct):
    struct_size: UInt32
    reserved: UInt32
    parts: UInt64
    geometries: UInt64
    parked: UInt64
    moved: UInt64
    candidate_pairs: UInt64
    filtered_pairs: UInt64
    examined_pairs: UInt64
    kept_pairs: UInt64
    touching_pairs: UInt64
    contacts: UInt64
    unsupported_pairs: UInt64
    events: UInt64
    bytes: UInt64
    refresh_microseconds: Double
    broadphase_microseconds: Double
    pair_microseconds: Double
    narrowphase_microseconds: Double
    contact_microseconds: Double
    asleep: UInt64
