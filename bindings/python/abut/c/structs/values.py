# SPDX-License-Identifier: Apache-2.0
"""Vectors, poses and ids."""

from __future__ import annotations

from .base import Double, Id, Numbers, Struct, Text, UInt32, UInt64, struct


@struct
class Vec3(Numbers):
    x: Double
    y: Double
    z: Double


@struct
class Quat(Numbers):
    w: Double
    x: Double
    y: Double
    z: Double


@struct
class Pose(Struct):
    position: Vec3
    orientation: Quat


@struct
class Aabb(Struct):
    minimum: Vec3
    maximum: Vec3


@struct
class PartId(Id):
    slot: UInt32
    generation: UInt32


@struct
class GeometryId(Id):
    slot: UInt32
    generation: UInt32


@struct
class Feature(Struct):
    kind: UInt32
    index: UInt32


@struct
class LayoutEntry(Struct):
    type: Text
    field: Text
    offset: UInt64
    size: UInt64
