# SPDX-License-Identifier: Apache-2.0
"""The C interface of abut as it is, through ctypes: constants, structs, functions.

The names are those of abut.h and picking.h without their prefix for constants and structs. Functions are attributes of
`library` (and of `picking`, which is None where that library is not installed). One that answers a status other than
ABUT_OK raises Error. The module abut wraps all this in objects.

The libraries are found by the loader, or by the environment variables ABUT_LIBRARY and ABUT_PICKING_LIBRARY.
"""

import ctypes
import os
from ctypes import POINTER, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

Status = c_int32
OK = 0
INVALID_ARGUMENT = 1
NULL_ARGUMENT = 2
NOT_FINITE = 3
OUT_OF_RANGE = 4
ZERO_VECTOR = 5
NOT_UNIT = 6
INDEX_OUT_OF_RANGE = 7
SIZE_OVERFLOW = 8
EMPTY = 9
STALE_ID = 10
WRONG_STRUCT_SIZE = 11
UNKNOWN_VALUE = 12
UNSUPPORTED = 13
NOT_CONVERGED = 14
OUT_OF_MEMORY = 15
INTERNAL = 16
BUSY = 17

FEATURE_WHOLE = 0
FEATURE_VERTEX = 1
FEATURE_EDGE = 2
FEATURE_FACE = 3
FEATURE_CELL = 4
FEATURE_PARTICLE = 5

QUERY_DISTANCE, QUERY_CONTACTS = 0, 1
SIDES_BOTH = 0
SIDES_FRONT = 1

ALGORITHM_AUTO = 0
ALGORITHM_ANALYTIC = 1
ALGORITHM_SAT = 2
ALGORITHM_GJK_EPA = 3
ALGORITHM_LIBCCD_GJK = 4
ALGORITHM_LIBCCD_MPR = 5

BROADPHASE_AUTO = 0
BROADPHASE_BRUTE = 1
BROADPHASE_TREE = 2
BROADPHASE_SWEEP_AND_PRUNE = 3
BROADPHASE_HASH_GRID = 4

TOLERANCE_DEAD_BAND = 0
TOLERANCE_MARGIN = 1

EVENTS_PAIRS = 1
EVENTS_PERSIST = 2
EVENTS_CONTACTS = 4

EVENT_BEGIN = 0
EVENT_PERSIST = 1
EVENT_END = 2
EVENT_SENSOR = 1
EVENT_CONTACT = 2
EVENT_ASLEEP = 4

CONTACT_SENSOR = 1
CONTACT_SPECULATIVE = 2
CONTACT_REDUCED_AWAY = 4
UNIVERSE_LOCAL_POINTS = 1
GEOMETRY_SENSOR = 1
GEOMETRY_SELF_PAIRS = 2

MOTION_DYNAMIC = 0
MOTION_ANIMATED = 1
MOTION_STATIC = 2

VELOCITY_NONE = 0
VELOCITY_GIVEN = 1
VELOCITY_FROM_POSES = 2

PARKING_NONE = 0
PARKING_SHORT_TERM = 1
PARKING_LONG_TERM = 2

COLLIDABLE_GEOMETRY = 0
COLLIDABLE_PART = 1
COLLIDABLE_LABEL = 2
COLLIDABLE_ANY = 3

RULE_NONE = 0
RULE_ENABLE = 1
RULE_DISABLE = 2

DETAIL_MANIFOLD = 0
DETAIL_POINT = 1
DETAIL_BOX = 2

FINDING_NOTHING_MOVES = 0
FINDING_MEETS_NOTHING = 1
FINDING_KINDS_UNSUPPORTED = 2
FINDING_TOLERANCE_TOO_LARGE = 3
FINDING_FAR_FROM_ORIGIN = 4
FINDING_EXCLUDED_FROM_ALL = 5

QUERY_FILTER_SKIP_SENSORS = 1
RAY_START_FAR_SIDE = 0
RAY_START_SOLID = 1
RAY_START_SKIP = 2
HIT_NEAREST = 0
HIT_ANY = 1
HIT_ALL = 2

COHERENCE_NONE = 0
COHERENCE_NEIGHBOURS = 1


class _Struct(ctypes.Structure):
    """A struct of C that prints its fields."""

    def __repr__(self):
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name, _ in self._fields_)
        return f"{type(self).__name__}({fields})"


class Vec3(_Struct):
    _fields_ = [
        ("x", c_double), ("y", c_double), ("z", c_double),
    ]


class Quat(_Struct):
    _fields_ = [
        ("w", c_double), ("x", c_double), ("y", c_double), ("z", c_double),
    ]


class Pose(_Struct):
    _fields_ = [
        ("position", Vec3), ("orientation", Quat),
    ]


class Aabb(_Struct):
    _fields_ = [
        ("minimum", Vec3), ("maximum", Vec3),
    ]


class PartId(_Struct):
    _fields_ = [
        ("slot", c_uint32), ("generation", c_uint32),
    ]


class GeometryId(_Struct):
    _fields_ = [
        ("slot", c_uint32), ("generation", c_uint32),
    ]


class Feature(_Struct):
    _fields_ = [
        ("kind", c_uint32), ("index", c_uint32),
    ]


class HullReport(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("dimension", c_uint32), ("point_count", c_uint64), ("vertex_count", c_uint64),
        ("edge_count", c_uint64), ("face_count", c_uint64), ("error", c_double),
    ]


class MeshOptions(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("sides", c_uint32),
    ]


class HeightFieldDesc(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("columns", c_uint32), ("rows", c_uint32),
        ("spacing_x", c_double), ("spacing_y", c_double), ("heights", POINTER(c_double)),
    ]


class ShapeDesc(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("kind", c_uint32), ("parameters", POINTER(c_double)),
        ("parameter_count", c_uint64), ("reals", POINTER(c_double)), ("real_count", c_uint64),
        ("indices", POINTER(c_uint32)), ("index_count", c_uint64),
    ]


class Ray(_Struct):
    _fields_ = [
        ("origin", Vec3), ("direction", Vec3), ("max_distance", c_double),
    ]


class RayHit(_Struct):
    _fields_ = [
        ("distance", c_double), ("point", Vec3), ("normal", Vec3), ("feature", Feature), ("child", c_uint32),
        ("reserved", c_uint32),
    ]


class QueryOptions(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("algorithm", c_uint32), ("error_bound", c_double), ("margin", c_double),
        ("max_contacts", c_uint32), ("max_pair_contacts", c_uint32),
    ]


class Distance(_Struct):
    _fields_ = [
        ("distance", c_double), ("lower", c_double), ("upper", c_double), ("point_a", Vec3), ("point_b", Vec3),
        ("normal", Vec3), ("algorithm", c_uint32), ("iterations", c_uint32),
    ]


class Contact(_Struct):
    _fields_ = [
        ("geometry_a", GeometryId), ("geometry_b", GeometryId), ("id", c_uint64), ("feature_a", Feature),
        ("feature_b", Feature), ("child_a", c_uint32), ("child_b", c_uint32), ("point_a", Vec3), ("point_b", Vec3),
        ("normal", Vec3), ("distance", c_double), ("toi", c_double), ("flags", c_uint32), ("age", c_uint32),
        ("user_data", c_uint64), ("material_a", c_uint32), ("material_b", c_uint32), ("tangent", Vec3),
        ("reserved", c_uint64),
    ]


class PairMemory(_Struct):
    _fields_ = [("opaque", c_uint64 * 8)]


class LocalPoints(_Struct):
    _fields_ = [("a", Vec3), ("b", Vec3)]


class UniverseOptions(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("broadphase", c_uint32), ("tolerance_mode", c_uint32),
        ("max_contacts", c_uint32), ("origin", Vec3), ("threads", c_uint32), ("events", c_uint32), ("flags", c_uint32),
        ("max_pair_contacts", c_uint32),
    ]


class PartOptions(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("motion", c_uint32), ("pose", Pose), ("user_data", c_uint64),
    ]


class GeometryOptions(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("flags", c_uint32), ("pose", Pose), ("tolerance", c_double),
        ("user_data", c_uint64), ("layers", c_uint64), ("mask", c_uint64), ("exclusion", c_uint64),
        ("label", c_uint32), ("tag", c_uint32), ("material", c_uint32), ("parking", c_uint32),
    ]


class GeometryInfo(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("kind", c_uint32), ("part", PartId), ("shape", c_void_p), ("pose", Pose),
        ("local", Pose), ("tolerance", c_double), ("user_data", c_uint64), ("layers", c_uint64),
        ("mask", c_uint64), ("exclusion", c_uint64), ("label", c_uint32), ("tag", c_uint32),
        ("material", c_uint32), ("parking", c_uint32), ("flags", c_uint32), ("reserved", c_uint32),
    ]


class Revision(_Struct):
    _fields_ = [
        ("geometries", c_uint64), ("poses", c_uint64),
    ]


class Collidable(_Struct):
    _fields_ = [
        ("kind", c_uint32), ("slot", c_uint32), ("generation", c_uint32),
    ]


class Policy(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("algorithm", c_uint32), ("detail", c_uint32), ("period", c_uint32),
        ("tolerance", c_double), ("error_bound", c_double),
    ]


class Focus(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("near_tag", c_uint32), ("far_tag", c_uint32), ("reserved", c_uint32),
        ("near_distance", c_double), ("far_distance", c_double),
    ]


class ContactMaterial(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("friction_primary", c_double),
        ("friction_secondary", c_double), ("friction_spin", c_double), ("friction_roll", c_double),
        ("static_scale", c_double), ("slip", c_double), ("compliance", c_double), ("damping", c_double),
        ("restitution", c_double), ("restitution_threshold", c_double), ("adhesive_force", c_double),
    ]


class Finding(_Struct):
    _fields_ = [
        ("code", c_uint32), ("reserved", c_uint32), ("geometry", GeometryId), ("other", GeometryId),
        ("message", c_char * 168),
    ]


class Sleep(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("steps", c_uint32), ("linear_speed", c_double), ("linear_acceleration", c_double),
        ("angular_speed", c_double), ("angular_acceleration", c_double),
    ]


class SleepChange(_Struct):
    _fields_ = [
        ("part", PartId), ("is_asleep", c_uint32), ("reserved", c_uint32),
    ]


class Island(_Struct):
    _fields_ = [
        ("id", c_uint64), ("first_part", c_uint32), ("part_count", c_uint32),
    ]


class Velocity(_Struct):
    _fields_ = [
        ("linear", Vec3), ("angular", Vec3),
    ]


class Event(_Struct):
    _fields_ = [
        ("kind", c_uint32), ("flags", c_uint32), ("geometry_a", GeometryId), ("geometry_b", GeometryId),
        ("contact_id", c_uint64), ("first_contact", c_uint32), ("contact_count", c_uint32),
    ]


class StepStats(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("parts", c_uint64), ("geometries", c_uint64),
        ("parked", c_uint64), ("moved", c_uint64), ("candidate_pairs", c_uint64), ("filtered_pairs", c_uint64),
        ("examined_pairs", c_uint64), ("kept_pairs", c_uint64), ("touching_pairs", c_uint64),
        ("contacts", c_uint64), ("unsupported_pairs", c_uint64), ("events", c_uint64), ("bytes", c_uint64),
        ("refresh_microseconds", c_double), ("broadphase_microseconds", c_double),
        ("pair_microseconds", c_double), ("narrowphase_microseconds", c_double),
        ("contact_microseconds", c_double), ("asleep", c_uint64),
    ]


class QueryFilter(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("flags", c_uint32), ("layers", c_uint64), ("mask", c_uint64), ("ignore_part", PartId),
        ("ignore_geometry", GeometryId), ("ray_start", c_uint32), ("reserved", c_uint32),
    ]


class QueryHit(_Struct):
    _fields_ = [
        ("geometry", GeometryId), ("feature", Feature), ("child", c_uint32), ("reserved", c_uint32),
        ("distance", c_double), ("point", Vec3), ("normal", Vec3),
    ]


class CastHit(_Struct):
    _fields_ = [
        ("geometry", GeometryId), ("fraction", c_double), ("contact", Distance), ("feature_a", Feature),
        ("feature_b", Feature), ("child_a", c_uint32), ("child_b", c_uint32),
    ]


class Closest(_Struct):
    _fields_ = [
        ("geometry", GeometryId), ("distance", Distance),
    ]


class LayoutEntry(_Struct):
    _fields_ = [
        ("type", c_char_p), ("field", c_char_p), ("offset", c_uint64), ("size", c_uint64),
    ]


class Pick(_Struct):
    _fields_ = [
        ("geometry", GeometryId), ("feature", Feature), ("child", c_uint32), ("reserved", c_uint32),
        ("distance", c_double), ("point", Vec3), ("normal", Vec3),
    ]


class Camera(_Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("width", c_uint32), ("height", c_uint32), ("reserved", c_uint32),
        ("pose", Pose), ("vertical_fov", c_double), ("near_distance", c_double), ("far_distance", c_double),
    ]


class Error(Exception):
    """A call that failed: `status` is its number, `name` the name of that, `message` says which argument and why."""

    def __init__(self, status, name, message):
        super().__init__(f"{name}: {message}")
        self.status = status
        self.name = name
        self.message = message


# A filter of pairs: context, universe and two geometries to a number, of which 0 leaves the pair out.
Filter = ctypes.CFUNCTYPE(c_uint32, c_void_p, c_void_p, GeometryId, GeometryId)

FUNCTIONS = {
    "abut_set_last_error": (Status, [Status, c_char_p]),
    "abut_status_name": (c_char_p, [Status]),
    "abut_last_error_message": (c_char_p, []),
    "abut_version_string": (c_char_p, []),
    "abut_check_version": (Status, [c_uint32, c_uint32]),
    "abut_has_feature": (c_uint32, [c_char_p]),
    "abut_shape_kind_count": (c_size_t, []),
    "abut_shape_kind_at": (c_uint32, [c_size_t]),
    "abut_shape_kind_by_name": (c_uint32, [c_char_p]),
    "abut_shape_kind_name": (c_char_p, [c_uint32]),
    "abut_shape_kind_parameter_count": (c_size_t, [c_uint32]),
    "abut_shape_kind_parameter_name": (c_char_p, [c_uint32, c_size_t]),
    "abut_pair_support": (Status, [c_uint32, c_uint32, c_uint32, POINTER(c_uint32)]),
    "abut_sphere_create": (Status, [c_double, POINTER(c_void_p)]),
    "abut_box_create": (Status, [c_double, c_double, c_double, POINTER(c_void_p)]),
    "abut_capsule_create": (Status, [c_double, c_double, POINTER(c_void_p)]),
    "abut_composite_create": (Status, [POINTER(c_void_p), POINTER(Pose), c_size_t, POINTER(c_void_p)]),
    "abut_composite_create_with_materials": (Status, [
        POINTER(c_void_p), POINTER(Pose), POINTER(c_uint32), c_size_t, POINTER(c_void_p)]),
    "abut_cylinder_create": (Status, [c_double, c_double, POINTER(c_void_p)]),
    "abut_plane_create": (Status, [POINTER(Vec3), c_double, POINTER(c_void_p)]),
    "abut_hull_create": (Status, [POINTER(c_double), c_size_t, POINTER(c_void_p)]),
    "abut_hull_report_init": (None, [POINTER(HullReport), c_uint32]),
    "abut_hull_describe": (Status, [c_void_p, POINTER(HullReport)]),
    "abut_mesh_options_init": (None, [POINTER(MeshOptions), c_uint32]),
    "abut_mesh_create": (Status, [
        POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t, POINTER(MeshOptions), POINTER(c_void_p)]),
    "abut_height_field_desc_init": (None, [POINTER(HeightFieldDesc), c_uint32]),
    "abut_height_field_create": (Status, [POINTER(HeightFieldDesc), POINTER(c_void_p)]),
    "abut_particles_create": (Status, [POINTER(c_double), c_size_t, c_double, POINTER(c_void_p)]),
    "abut_shape_desc_init": (None, [POINTER(ShapeDesc), c_uint32]),
    "abut_shape_create": (Status, [POINTER(ShapeDesc), POINTER(c_void_p)]),
    "abut_shape_retain": (None, [c_void_p]),
    "abut_shape_release": (None, [c_void_p]),
    "abut_shape_kind_of": (c_uint32, [c_void_p]),
    "abut_shape_parameters": (Status, [c_void_p, POINTER(c_double), c_size_t, POINTER(c_size_t)]),
    "abut_shape_aabb": (Status, [c_void_p, POINTER(Pose), POINTER(Aabb)]),
    "abut_shape_triangles": (Status, [
        c_void_p, POINTER(c_double), c_size_t, POINTER(c_size_t), POINTER(c_uint32), c_size_t,
        POINTER(c_size_t)]),
    "abut_shape_cast_ray": (Status, [
        c_void_p, POINTER(Pose), POINTER(Ray), POINTER(RayHit), POINTER(c_uint32)]),
    "abut_query_options_init": (None, [POINTER(QueryOptions), c_uint32]),
    "abut_pair_distance": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(Distance)]),
    "abut_pair_distance_with_memory": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Distance)]),
    "abut_pairs_distance_with_memories": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Distance)]),
    "abut_pair_contacts_with_memory": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Contact), c_size_t, POINTER(c_size_t)]),
    "abut_pairs_distance": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions),
        POINTER(Distance)]),
    "abut_pair_contacts": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(Contact),
        c_size_t, POINTER(c_size_t)]),
    "abut_universe_options_init": (None, [POINTER(UniverseOptions), c_uint32]),
    "abut_universe_create": (Status, [POINTER(UniverseOptions), POINTER(c_void_p)]),
    "abut_universe_destroy": (None, [c_void_p]),
    "abut_part_options_init": (None, [POINTER(PartOptions), c_uint32]),
    "abut_part_create": (Status, [c_void_p, POINTER(PartOptions), POINTER(PartId)]),
    "abut_parts_create": (Status, [c_void_p, POINTER(PartOptions), c_size_t, POINTER(PartId)]),
    "abut_part_destroy": (Status, [c_void_p, PartId]),
    "abut_parts_destroy": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_part_set_pose": (Status, [c_void_p, PartId, POINTER(Pose)]),
    "abut_parts_set_poses": (Status, [c_void_p, POINTER(PartId), POINTER(Pose), c_size_t]),
    "abut_part_pose": (Status, [c_void_p, PartId, POINTER(Pose)]),
    "abut_parts_poses": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(Pose)]),
    "abut_part_set_motion": (Status, [c_void_p, PartId, c_uint32]),
    "abut_parts_set_motions": (Status, [c_void_p, POINTER(PartId), POINTER(c_uint32), c_size_t]),
    "abut_part_motion": (Status, [c_void_p, PartId, POINTER(c_uint32)]),
    "abut_part_user_data": (Status, [c_void_p, PartId, POINTER(c_uint64)]),
    "abut_part_geometries": (Status, [c_void_p, PartId, POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_geometry_options_init": (None, [POINTER(GeometryOptions), c_uint32]),
    "abut_geometry_create": (Status, [
        c_void_p, PartId, c_void_p, POINTER(GeometryOptions), POINTER(GeometryId)]),
    "abut_geometries_create": (Status, [
        c_void_p, POINTER(PartId), POINTER(c_void_p), POINTER(GeometryOptions), c_size_t,
        POINTER(GeometryId)]),
    "abut_geometry_destroy": (Status, [c_void_p, GeometryId]),
    "abut_geometries_destroy": (Status, [c_void_p, POINTER(GeometryId), c_size_t]),
    "abut_geometry_set_options": (Status, [c_void_p, GeometryId, POINTER(GeometryOptions)]),
    "abut_geometries_set_options": (Status, [
        c_void_p, POINTER(GeometryId), POINTER(GeometryOptions), c_size_t]),
    "abut_geometry_set_shape": (Status, [c_void_p, GeometryId, c_void_p]),
    "abut_geometries_set_shapes": (Status, [c_void_p, POINTER(GeometryId), POINTER(c_void_p), c_size_t]),
    "abut_geometry_set_parameters": (Status, [c_void_p, GeometryId, POINTER(c_double), c_size_t]),
    "abut_geometries_set_parameters": (Status, [c_void_p, POINTER(GeometryId), POINTER(c_double), c_size_t, c_size_t]),
    "abut_geometry_set_heights": (
        Status, [c_void_p, GeometryId, c_uint32, c_uint32, c_uint32, c_uint32, POINTER(c_double)]),
    "abut_geometry_set_particles": (
        Status, [c_void_p, GeometryId, c_size_t, POINTER(c_double), POINTER(c_double), c_size_t]),
    "abut_geometry_shape": (Status, [c_void_p, GeometryId, POINTER(c_void_p)]),
    "abut_geometry_park": (Status, [c_void_p, GeometryId, c_uint32]),
    "abut_geometries_park": (Status, [c_void_p, POINTER(GeometryId), c_size_t, c_uint32]),
    "abut_geometry_info_init": (None, [POINTER(GeometryInfo), c_uint32]),
    "abut_geometry_describe": (Status, [c_void_p, GeometryId, POINTER(GeometryInfo)]),
    "abut_geometries_poses": (Status, [c_void_p, POINTER(GeometryId), c_size_t, POINTER(Pose)]),
    "abut_universe_parts": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_geometries": (Status, [c_void_p, POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_revision": (Status, [c_void_p, POINTER(Revision)]),
    "abut_universe_counters": (Status, [c_void_p, POINTER(POINTER(c_uint64)), POINTER(POINTER(c_uint64))]),
    "abut_universe_validate": (Status, [c_void_p, POINTER(Finding), c_size_t, POINTER(c_size_t)]),
    "abut_contact_material_init": (None, [POINTER(ContactMaterial), c_uint32]),
    "abut_material_pair_set": (Status, [c_void_p, c_uint32, c_uint32, POINTER(ContactMaterial)]),
    "abut_material_pair_get": (Status, [c_void_p, c_uint32, c_uint32, POINTER(ContactMaterial)]),
    "abut_rule_set": (Status, [c_void_p, POINTER(Collidable), POINTER(Collidable), c_uint32]),
    "abut_rules_clear": (Status, [c_void_p]),
    "abut_universe_set_filter": (Status, [c_void_p, Filter, c_void_p]),
    "abut_universe_refilter": (Status, [c_void_p]),
    "abut_sleep_init": (None, [POINTER(Sleep), c_uint32]),
    "abut_part_set_sleep": (Status, [c_void_p, PartId, POINTER(Sleep)]),
    "abut_parts_set_sleep": (Status, [c_void_p, POINTER(PartId), POINTER(Sleep), c_size_t]),
    "abut_part_is_asleep": (Status, [c_void_p, PartId, POINTER(c_uint32)]),
    "abut_part_wake": (Status, [c_void_p, PartId]),
    "abut_parts_wake": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_universe_sleep_changes": (Status, [c_void_p, POINTER(POINTER(SleepChange)), POINTER(c_size_t)]),
    "abut_universe_follow_islands": (Status, [c_void_p, c_uint32]),
    "abut_universe_islands": (Status, [c_void_p, POINTER(POINTER(Island)), POINTER(c_size_t)]),
    "abut_universe_island_parts": (Status, [c_void_p, POINTER(POINTER(PartId)), POINTER(c_size_t)]),
    "abut_part_island": (Status, [c_void_p, PartId, POINTER(Island)]),
    "abut_part_set_velocity": (Status, [c_void_p, PartId, POINTER(Velocity)]),
    "abut_parts_set_velocities": (Status, [c_void_p, POINTER(PartId), POINTER(Velocity), c_size_t]),
    "abut_part_measure_velocity": (Status, [c_void_p, PartId]),
    "abut_parts_measure_velocities": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_part_velocity": (Status, [c_void_p, PartId, POINTER(Velocity), POINTER(c_uint32)]),
    "abut_parts_velocities": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(Velocity)]),
    "abut_universe_attach": (Status, [c_void_p, c_char_p]),
    "abut_universe_detach": (Status, [c_void_p, c_char_p]),
    "abut_policy_init": (None, [POINTER(Policy), c_uint32]),
    "abut_policy_set": (Status, [c_void_p, c_uint32, c_uint32, POINTER(Policy)]),
    "abut_policy_get": (Status, [c_void_p, c_uint32, c_uint32, POINTER(Policy)]),
    "abut_focus_init": (None, [POINTER(Focus), c_uint32]),
    "abut_universe_set_focus": (Status, [c_void_p, POINTER(Focus), POINTER(Vec3), c_size_t]),
    "abut_universe_step": (Status, [c_void_p, c_double]),
    "abut_universe_detect_all": (Status, [c_void_p]),
    "abut_universe_detect_changed": (Status, [c_void_p]),
    "abut_universe_detect_pairs": (Status, [c_void_p, POINTER(GeometryId), POINTER(GeometryId), c_size_t]),
    "abut_universe_detect_region": (Status, [c_void_p, POINTER(Aabb)]),
    "abut_universe_refresh": (Status, [c_void_p]),
    "abut_universe_events": (Status, [c_void_p, POINTER(POINTER(Event)), POINTER(c_size_t)]),
    "abut_universe_hash": (Status, [c_void_p, POINTER(c_uint64)]),
    "abut_contacts_set_user_data": (Status, [c_void_p, POINTER(c_uint64), c_size_t]),
    "abut_universe_contacts": (Status, [c_void_p, POINTER(POINTER(Contact)), POINTER(c_size_t)]),
    "abut_universe_local_points": (Status, [c_void_p, POINTER(POINTER(LocalPoints)), POINTER(c_size_t)]),
    "abut_contact_validate": (Status, [POINTER(Contact)]),
    "abut_step_stats_init": (None, [POINTER(StepStats), c_uint32]),
    "abut_universe_stats": (Status, [c_void_p, POINTER(StepStats)]),
    "abut_universe_explain": (Status, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)]),
    "abut_universe_explain_json": (Status, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)]),
    "abut_query_filter_init": (None, [POINTER(QueryFilter), c_uint32]),
    "abut_universe_cast_ray": (Status, [
        c_void_p, POINTER(Ray), POINTER(QueryFilter), c_uint32, POINTER(QueryHit), c_size_t, POINTER(c_size_t)]),
    "abut_universe_cast_rays": (Status, [
        c_void_p, POINTER(Ray), c_size_t, POINTER(QueryFilter), POINTER(QueryHit)]),
    "abut_universe_cast_shape": (Status, [
        c_void_p, c_void_p, POINTER(Pose), POINTER(Vec3), POINTER(QueryFilter), c_uint32, POINTER(CastHit), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_cast_shapes": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), POINTER(Vec3), c_size_t, POINTER(QueryFilter), POINTER(CastHit)]),
    "abut_universe_overlaps": (Status, [
        c_void_p, c_void_p, POINTER(Pose), POINTER(QueryFilter), c_double, POINTER(GeometryId), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_overlaps_of_each": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), c_size_t, POINTER(QueryFilter), c_double, POINTER(c_uint64),
        POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_at_point": (Status, [
        c_void_p, POINTER(Vec3), POINTER(QueryFilter), POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_at_points": (Status, [
        c_void_p, POINTER(Vec3), c_size_t, POINTER(QueryFilter), POINTER(c_uint64), POINTER(GeometryId), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_closest": (Status, [
        c_void_p, c_void_p, POINTER(Pose), c_double, POINTER(QueryFilter), POINTER(Closest), POINTER(c_uint32)]),
    "abut_universe_closest_to_each": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), c_size_t, c_double, POINTER(QueryFilter), POINTER(Closest)]),
    "abut_pair_cast": (Status, [
        c_void_p, POINTER(Pose), POINTER(Vec3), c_void_p, POINTER(Pose), POINTER(Vec3), POINTER(QueryOptions),
        POINTER(CastHit), POINTER(c_uint32)]),
    "abut_layout_count": (c_size_t, []),
    "abut_layout_at": (Status, [c_size_t, POINTER(LayoutEntry)]),
}

PICKING_FUNCTIONS = {
    "abut_camera_init": (None, [POINTER(Camera), c_uint32]),
    "abut_camera_look_at": (Status, [POINTER(Camera), POINTER(Vec3), POINTER(Vec3), POINTER(Vec3)]),
    "abut_camera_ray": (Status, [POINTER(Camera), c_double, c_double, POINTER(Ray)]),
    "abut_picker_create": (Status, [c_void_p, POINTER(c_void_p)]),
    "abut_picker_destroy": (None, [c_void_p]),
    "abut_picker_update": (Status, [c_void_p]),
    "abut_picker_cast_ray": (Status, [c_void_p, POINTER(Ray), POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_cast_rays": (Status, [
        c_void_p, POINTER(Ray), c_size_t, c_uint32, POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_cast_ray_all": (Status, [
        c_void_p, POINTER(Ray), POINTER(QueryFilter), POINTER(Pick), c_size_t, POINTER(c_size_t)]),
    "abut_picker_pick_pixel": (Status, [
        c_void_p, POINTER(Camera), c_double, c_double, c_double, POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_render": (Status, [c_void_p, POINTER(Camera), POINTER(QueryFilter), POINTER(Pick), c_size_t]),
}


def _raise_failures(status, _function, _arguments):
    if status != OK:
        message = library.abut_last_error_message().decode("utf-8", "replace")
        raise Error(status, library.abut_status_name(status).decode(), message)


def _declare(loaded, functions):
    for name, (result, arguments) in functions.items():
        function = getattr(loaded, name)
        function.restype = result
        function.argtypes = arguments
        # abut_set_last_error answers the status that it was given.
        if result is Status and name != "abut_set_last_error":
            function.errcheck = _raise_failures
    return loaded


def _load(name, variable):
    abi = f"0.{VERSION_MINOR}" if VERSION_MAJOR == 0 else f"{VERSION_MAJOR}"
    return ctypes.CDLL(os.environ.get(variable) or f"{name}.so.{abi}")


VERSION_MAJOR = 0
VERSION_MINOR = 2

library = _declare(_load("libabut", "ABUT_LIBRARY"), FUNCTIONS)
library.abut_check_version(VERSION_MAJOR, VERSION_MINOR)

try:
    picking = _declare(_load("libabut_picking", "ABUT_PICKING_LIBRARY"), PICKING_FUNCTIONS)
except OSError:
    picking = None
