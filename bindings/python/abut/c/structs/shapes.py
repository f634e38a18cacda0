# SPDX-License-Identifier: Apache-2.0
"""Structs about shapes and pairs of shapes."""

from __future__ import annotations

from .base import Double, Doubles, EightWords, Struct, UInt32, UInt32s, UInt64, struct
from .values import Feature, GeometryId, Vec3


@struct
class HullReport(Struct):
    struct_size: UInt32
    dimension: UInt32
    point_count: UInt64
    vertex_count: UInt64
    edge_count: UInt64
    face_count: UInt64
    error: Double


@struct
class MeshOptions(Struct):
    struct_size: UInt32
    sides: UInt32
    corners: UInt32
    merges_vertices: UInt32
    merge_distance: Double
    tree: UInt32
    reserved: UInt32


@struct
class MeshReport(Struct):
    struct_size: UInt32
    reserved: UInt32
    triangles: UInt64
    vertices: UInt64
    merged_vertices: UInt64
    collapsed_triangles: UInt64
    duplicate_vertices: UInt64
    duplicate_triangles: UInt64
    slivers: UInt64
    open_edges: UInt64
    non_manifold_edges: UInt64
    reversed_triangles: UInt64
    twisted_patches: UInt64
    components: UInt64
    merge_error: Double
    volume: Double


@struct
class UvGridOptions(Struct):
    struct_size: UInt32
    sides: UInt32
    axis_u: UInt32
    axis_v: UInt32
    cells_u: UInt32
    cells_v: UInt32
    corners: UInt32
    merges_vertices: UInt32
    merge_distance: Double


@struct
class HeightFieldDesc(Struct):
    struct_size: UInt32
    diagonal: UInt32
    columns: UInt32
    rows: UInt32
    spacing_x: Double
    spacing_y: Double
    heights: Doubles
    below: UInt32
    reserved: UInt32


@struct
class DistanceFieldDesc(Struct):
    struct_size: UInt32
    is_inside_out: UInt32
    columns: UInt32
    rows: UInt32
    layers: UInt32
    interpolation: UInt32
    spacing: Vec3
    origin: Vec3
    values: Doubles


@struct
class DistanceFieldOptions(Struct):
    struct_size: UInt32
    is_inside_out: UInt32
    spacing: Double
    band: Double
    interpolation: UInt32
    reserved: UInt32


@struct
class DistanceFieldReport(Struct):
    struct_size: UInt32
    interpolation: UInt32
    block_count: UInt64
    held_block_count: UInt64
    error: Double
    far_error: Double
    least_stretch: Double
    most_stretch: Double


@struct
class ShapeDesc(Struct):
    struct_size: UInt32
    kind: UInt32
    parameters: Doubles
    parameter_count: UInt64
    reals: Doubles
    real_count: UInt64
    indices: UInt32s
    index_count: UInt64


@struct
class Ray(Struct):
    origin: Vec3
    direction: Vec3
    max_distance: Double


@struct
class RayHit(Struct):
    distance: Double
    point: Vec3
    normal: Vec3
    feature: Feature
    child: UInt32
    reserved: UInt32


@struct
class QueryOptions(Struct):
    struct_size: UInt32
    algorithm: UInt32
    error_bound: Double
    margin: Double
    max_contacts: UInt32
    max_pair_contacts: UInt32
    threads: UInt32
    reserved: UInt32


@struct
class Distance(Struct):
    distance: Double
    lower: Double
    upper: Double
    point_a: Vec3
    point_b: Vec3
    normal: Vec3
    algorithm: UInt32
    iterations: UInt32


@struct
class Contact(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    id: UInt64
    feature_a: Feature
    feature_b: Feature
    child_a: UInt32
    child_b: UInt32
    point_a: Vec3
    point_b: Vec3
    normal: Vec3
    distance: Double
    toi: Double
    flags: UInt32
    age: UInt32
    user_data: UInt64
    material_a: UInt32
    material_b: UInt32
    tangent: Vec3
    reserved: UInt64


@struct
class FirstTouch(Struct):
    touches: UInt32
    reserved: UInt32
    lower: Double
    upper: Double


@struct
class Movement(Struct):
    velocity: Vec3
    angular_velocity: Vec3
    acceleration: Vec3
    angular_acceleration: Vec3
    centre: Vec3


@struct
class ImpactOptions(Struct):
    struct_size: UInt32
    most_rounds: UInt32
    tolerance: Double
    margin: Double
    threads: UInt32
    reserved: UInt32


@struct
class Impact(Struct):
    state: UInt32
    rounds: UInt32
    lower: Double
    upper: Double
    contact: Distance
    child_a: UInt32
    child_b: UInt32


@struct
class PairMemory(Struct):
    opaque: EightWords
