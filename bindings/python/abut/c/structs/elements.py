# SPDX-License-Identifier: Apache-2.0
"""Structs of meshes that deform."""

from __future__ import annotations

from .base import Double, FourDoubles, FourUInt32s, Struct, UInt32, UInt64, struct
from .values import Vec3


@struct
class ElementCounts(Struct):
    vertices: UInt64
    edges: UInt64
    triangles: UInt64
    faces: UInt64


@struct
class ElementsOptions(Struct):
    struct_size: UInt32
    method: UInt32
    kinds: UInt32
    flags: UInt32
    threads: UInt32
    reserved: UInt32
    reach: Double
    tolerance: Double
    rest_distance: Double
    cone_angle: Double
    cone_factor: Double


@struct
class Stencil(Struct):
    kind: UInt32
    of_a: UInt32
    element_a: UInt32
    element_b: UInt32
    vertices: FourUInt32s
    weights: FourDoubles
    normal: Vec3
    distance: Double
    toi: Double


@struct
class ElementPair(Struct):
    kind: UInt32
    a: UInt32
    b: UInt32


@struct
class Crossing(Struct):
    edge: UInt32
    face: UInt32
    edge_is_of_b: UInt32
    reserved: UInt32
    share: Double
    point: Vec3
