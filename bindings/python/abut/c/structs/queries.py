# SPDX-License-Identifier: Apache-2.0
"""Structs about queries on a universe, and about picking."""

from __future__ import annotations

from .base import Double, Struct, UInt32, UInt64, struct
from .shapes import Distance, Impact
from .values import Feature, GeometryId, PartId, Pose, Vec3


@struct
class QueryFilter(Struct):
    struct_size: UInt32
    flags: UInt32
    layers: UInt64
    mask: UInt64
    ignore_part: PartId
    ignore_geometry: GeometryId
    ray_start: UInt32
    reserved: UInt32


@struct
class QueryHit(Struct):
    geometry: GeometryId
    feature: Feature
    child: UInt32
    reserved: UInt32
    distance: Double
    point: Vec3
    normal: Vec3


@struct
class CastHit(Struct):
    geometry: GeometryId
    fraction: Double
    contact: Distance
    feature_a: Feature
    feature_b: Feature
    child_a: UInt32
    child_b: UInt32


@struct
class ImpactHit(Struct):
    geometry: GeometryId
    impact: Impact


@struct
class Closest(Struct):
    geometry: GeometryId
    distance: Distance


@struct
class Pick(Struct):
    geometry: GeometryId
    feature: Feature
    child: UInt32
    reserved: UInt32
    distance: Double
    point: Vec3
    normal: Vec3


@struct
class Camera(Struct):
    struct_size: UInt32
    width: UInt32
    height: UInt32
    reserved: UInt32
    pose: Pose
    vertical_fov: Double
    near_distance: Double
    far_distance: Double
