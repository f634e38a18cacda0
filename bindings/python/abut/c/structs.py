# SPDX-License-Identifier: Apache-2.0
# Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.
"""Structs of the headers, field by field."""

from __future__ import annotations

from ctypes import c_char, c_double, c_uint32, c_uint64
from typing import Annotated, Any

from .base import Address, Double, Doubles, Id, Numbers, Struct, Text, UInt32, UInt32s, UInt64, struct

__all__ = ["Vec3", "Quat", "Pose", "Aabb", "PartId", "GeometryId", "Feature", "HullReport", "MeshOptions", "MeshReport",
    "UvGridOptions", "HeightFieldDesc", "DistanceFieldDesc", "DistanceFieldOptions", "DistanceFieldReport",
    "CompositeChild", "ShapeDesc", "Ray", "RayHit", "QueryOptions", "Route", "Distance", "Contact", "PairMemory",
    "FirstTouch", "ElementCounts", "ElementsOptions", "Stencil", "ElementPair", "Crossing", "Movement", "ImpactOptions",
    "Impact", "UniverseOptions", "PartOptions", "Sleep", "GeometryOptions", "GeometryInfo", "Revision", "Collidable",
    "Policy", "Focus", "ContactMaterial", "BackendPair", "BackendContact", "Event", "SleepChange", "LocalPoints",
    "StepStats", "Finding", "Island", "Velocity", "Acceleration", "StepImpact", "ElementContact", "QueryFilter",
    "QueryHit", "CastHit", "ImpactHit", "Closest", "LayoutEntry", "Pick", "Camera", "ClipPlane", "Snap", "Barycentric",
    "ContactProblem", "SolverOptions", "Residuals", "MassProperties", "ResponseOptions", "BodyOptions",
    "ElasticOptions", "ContactLaw", "ResponseSide", "LinkOptions", "ResponseContact", "ResponseObject",
    "ResponseIsland", "Energy", "ResponseFinding"]


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
class CompositeChild(Struct):
    pose: Pose
    material: UInt32
    is_hole: UInt32
    cut_begin: UInt32
    cut_end: UInt32


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
    flags: UInt32
    time_budget: Double


@struct
class Route(Struct):
    algorithm: UInt32
    flags: UInt32
    error_bound: Double
    seconds: Double
    worst_error: Double


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
class PairMemory(Struct):
    opaque: Annotated[Any, c_uint64 * 8]


@struct
class FirstTouch(Struct):
    touches: UInt32
    reserved: UInt32
    lower: Double
    upper: Double


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
    vertices: Annotated[Any, c_uint32 * 4]
    weights: Annotated[Any, c_double * 4]
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
class Sleep(Struct):
    struct_size: UInt32
    steps: UInt32
    linear_speed: Double
    linear_acceleration: Double
    angular_speed: Double
    angular_acceleration: Double


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
    method: UInt32
    kinds: UInt32
    flags: UInt32
    reserved: UInt32
    contact_distance: Double
    rest_distance: Double
    cone_angle: Double
    cone_factor: Double
    time_budget: Double


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
class BackendPair(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    shape_a: Address
    shape_b: Address
    pose_a: Pose
    pose_b: Pose
    margin: Double


@struct
class BackendContact(Struct):
    point_a: Vec3
    point_b: Vec3
    normal: Vec3
    feature_a: Feature
    feature_b: Feature
    child_a: UInt32
    child_b: UInt32
    id: UInt64


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
class SleepChange(Struct):
    part: PartId
    is_asleep: UInt32
    reserved: UInt32


@struct
class LocalPoints(Struct):
    a: Vec3
    b: Vec3


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


@struct
class Finding(Struct):
    code: UInt32
    reserved: UInt32
    geometry: GeometryId
    other: GeometryId
    message: Annotated[bytes, c_char * 168]


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
class ElementContact(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    stencil: Stencil
    gap: Double
    id: UInt64
    age: UInt32
    reserved: UInt32


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
class LayoutEntry(Struct):
    type: Text
    field: Text
    offset: UInt64
    size: UInt64


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
    projection: UInt32
    pose: Pose
    vertical_fov: Double
    near_distance: Double
    far_distance: Double
    vertical_extent: Double
    pixel_aspect: Double
    shift_x: Double
    shift_y: Double
    depth_axis: UInt32
    reserved: UInt32


@struct
class ClipPlane(Struct):
    normal: Vec3
    offset: Double


@struct
class Snap(Struct):
    geometry: GeometryId
    kind: UInt32
    vertices: Annotated[Any, c_uint32 * 2]
    reserved: UInt32
    parameter: Double
    pixels: Double
    distance: Double
    point: Vec3


@struct
class Barycentric(Struct):
    triangle: UInt32
    vertices: Annotated[Any, c_uint32 * 3]
    weights: Annotated[Any, c_double * 3]


@struct
class ContactProblem(Struct):
    struct_size: UInt32
    body_count: UInt32
    contact_count: UInt32
    reserved: UInt32
    masses: Doubles
    inertias: Doubles
    centres: Doubles
    free_velocities: Doubles
    bodies: UInt32s
    points: Doubles
    normals: Doubles
    tangents: Doubles
    frictions: Doubles
    compliances: Doubles
    offsets: Doubles
    surface_velocities: Doubles
    first_velocities: Doubles
    first_impulses: Doubles


@struct
class SolverOptions(Struct):
    struct_size: UInt32
    most_rounds: UInt32
    tolerance: Double
    speed: Double
    solver: UInt32
    reserved: UInt32


@struct
class Residuals(Struct):
    contact: Double
    motion: Double
    dissipation: Double
    speed: Double
    rounds: UInt32
    newton_steps: UInt32
    is_converged: UInt32
    reserved: UInt32


@struct
class MassProperties(Struct):
    mass: Double
    centre: Vec3
    inertia: Annotated[Any, c_double * 9]


@struct
class ResponseOptions(Struct):
    struct_size: UInt32
    most_rounds: UInt32
    gravity: Vec3
    tolerance: Double
    slop: Double
    flags: UInt32
    solver: UInt32
    threads: UInt32
    reserved: UInt32


@struct
class BodyOptions(Struct):
    struct_size: UInt32
    integrator: UInt32
    density: Double
    mass: MassProperties


@struct
class ElasticOptions(Struct):
    struct_size: UInt32
    reserved: UInt32
    young: Double
    poisson: Double
    damping: Double


@struct
class ContactLaw(Struct):
    friction_primary: Double
    friction_secondary: Double
    compliance: Double
    offset: Double
    pull: Double
    surface_velocity: Vec3


@struct
class ResponseSide(Struct):
    kind: UInt32
    slot: UInt32
    generation: UInt32


@struct
class LinkOptions(Struct):
    struct_size: UInt32
    reserved: UInt32
    a: PartId
    b: PartId
    point_a: Vec3
    point_b: Vec3
    stiffness: Double
    damping: Double
    most_force: Double
    break_force: Double


@struct
class ResponseContact(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    id: UInt64
    point: Vec3
    normal: Vec3
    impulse: Vec3
    force: Vec3
    distance: Double
    normal_velocity: Double
    state: UInt32
    island: UInt32
    kind: UInt32
    reserved: UInt32


@struct
class ResponseObject(Struct):
    geometry_a: GeometryId
    geometry_b: GeometryId
    kind: UInt32
    event: UInt32
    contact_count: UInt32
    bond_count: UInt32
    age: UInt32
    reserved: UInt32
    impulse: Vec3
    force: Vec3


@struct
class ResponseIsland(Struct):
    body_count: UInt32
    contact_count: UInt32
    integrator: UInt32
    reserved: UInt32
    residuals: Residuals


@struct
class Energy(Struct):
    kinetic: Double
    potential: Double
    linear_momentum: Vec3
    angular_momentum: Vec3


@struct
class ResponseFinding(Struct):
    code: UInt32
    rule: UInt32
    part: PartId
    geometry: GeometryId
    message: Annotated[bytes, c_char * 168]
