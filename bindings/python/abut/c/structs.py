# SPDX-License-Identifier: Apache-2.0
"""Structs of abut.h and picking.h, field by field."""

from ctypes import POINTER, Structure, c_char, c_char_p, c_double, c_uint32, c_uint64, c_void_p


class Struct(Structure):
    """A struct of C that prints its fields."""

    def __repr__(self):
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name, _ in self._fields_)
        return f"{type(self).__name__}({fields})"


class _Numbers(Struct):
    """A struct of numbers that unpacks: x, y, z = contact.normal."""

    def __iter__(self):
        return (getattr(self, name) for name, _ in self._fields_)


class _Id(Struct):
    """An id is a value: equal ids are equal keys, and a null id is false."""

    def __eq__(self, other):
        if type(other) is not type(self):
            return NotImplemented
        return (self.slot, self.generation) == (other.slot, other.generation)

    def __hash__(self):
        return hash((self.slot, self.generation))

    def __bool__(self):
        return self.slot != 0


class Vec3(_Numbers):
    _fields_ = [
        ("x", c_double), ("y", c_double), ("z", c_double),
    ]


class Quat(_Numbers):
    _fields_ = [
        ("w", c_double), ("x", c_double), ("y", c_double), ("z", c_double),
    ]


class Pose(Struct):
    _fields_ = [
        ("position", Vec3), ("orientation", Quat),
    ]


class Aabb(Struct):
    _fields_ = [
        ("minimum", Vec3), ("maximum", Vec3),
    ]


class PartId(_Id):
    _fields_ = [
        ("slot", c_uint32), ("generation", c_uint32),
    ]


class GeometryId(_Id):
    _fields_ = [
        ("slot", c_uint32), ("generation", c_uint32),
    ]


class Feature(Struct):
    _fields_ = [
        ("kind", c_uint32), ("index", c_uint32),
    ]


class HullReport(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("dimension", c_uint32), ("point_count", c_uint64), ("vertex_count", c_uint64),
        ("edge_count", c_uint64), ("face_count", c_uint64), ("error", c_double),
    ]


class MeshOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("sides", c_uint32),
    ]


class HeightFieldDesc(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("columns", c_uint32), ("rows", c_uint32),
        ("spacing_x", c_double), ("spacing_y", c_double), ("heights", POINTER(c_double)),
    ]


class ShapeDesc(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("kind", c_uint32), ("parameters", POINTER(c_double)),
        ("parameter_count", c_uint64), ("reals", POINTER(c_double)), ("real_count", c_uint64),
        ("indices", POINTER(c_uint32)), ("index_count", c_uint64),
    ]


class Ray(Struct):
    _fields_ = [
        ("origin", Vec3), ("direction", Vec3), ("max_distance", c_double),
    ]


class RayHit(Struct):
    _fields_ = [
        ("distance", c_double), ("point", Vec3), ("normal", Vec3), ("feature", Feature), ("child", c_uint32),
        ("reserved", c_uint32),
    ]


class QueryOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("algorithm", c_uint32), ("error_bound", c_double), ("margin", c_double),
        ("max_contacts", c_uint32), ("max_pair_contacts", c_uint32),
    ]


class Distance(Struct):
    _fields_ = [
        ("distance", c_double), ("lower", c_double), ("upper", c_double), ("point_a", Vec3), ("point_b", Vec3),
        ("normal", Vec3), ("algorithm", c_uint32), ("iterations", c_uint32),
    ]


class Contact(Struct):
    _fields_ = [
        ("geometry_a", GeometryId), ("geometry_b", GeometryId), ("id", c_uint64), ("feature_a", Feature),
        ("feature_b", Feature), ("child_a", c_uint32), ("child_b", c_uint32), ("point_a", Vec3), ("point_b", Vec3),
        ("normal", Vec3), ("distance", c_double), ("toi", c_double), ("flags", c_uint32), ("age", c_uint32),
        ("user_data", c_uint64), ("material_a", c_uint32), ("material_b", c_uint32), ("tangent", Vec3),
        ("reserved", c_uint64),
    ]


class PairMemory(Struct):
    _fields_ = [("opaque", c_uint64 * 8)]


class LocalPoints(Struct):
    _fields_ = [("a", Vec3), ("b", Vec3)]


class UniverseOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("broadphase", c_uint32), ("tolerance_mode", c_uint32),
        ("max_contacts", c_uint32), ("origin", Vec3), ("threads", c_uint32), ("events", c_uint32), ("flags", c_uint32),
        ("max_pair_contacts", c_uint32),
    ]


class PartOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("motion", c_uint32), ("pose", Pose), ("user_data", c_uint64),
    ]


class GeometryOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("flags", c_uint32), ("pose", Pose), ("tolerance", c_double),
        ("user_data", c_uint64), ("layers", c_uint64), ("mask", c_uint64), ("exclusion", c_uint64),
        ("label", c_uint32), ("tag", c_uint32), ("material", c_uint32), ("parking", c_uint32),
    ]


class GeometryInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("kind", c_uint32), ("part", PartId), ("shape", c_void_p), ("pose", Pose),
        ("local", Pose), ("tolerance", c_double), ("user_data", c_uint64), ("layers", c_uint64),
        ("mask", c_uint64), ("exclusion", c_uint64), ("label", c_uint32), ("tag", c_uint32),
        ("material", c_uint32), ("parking", c_uint32), ("flags", c_uint32), ("reserved", c_uint32),
    ]


class Revision(Struct):
    _fields_ = [
        ("geometries", c_uint64), ("poses", c_uint64),
    ]


class Collidable(Struct):
    _fields_ = [
        ("kind", c_uint32), ("slot", c_uint32), ("generation", c_uint32),
    ]


class Policy(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("algorithm", c_uint32), ("detail", c_uint32), ("period", c_uint32),
        ("tolerance", c_double), ("error_bound", c_double),
    ]


class Focus(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("near_tag", c_uint32), ("far_tag", c_uint32), ("reserved", c_uint32),
        ("near_distance", c_double), ("far_distance", c_double),
    ]


class ContactMaterial(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("friction_primary", c_double),
        ("friction_secondary", c_double), ("friction_spin", c_double), ("friction_roll", c_double),
        ("static_scale", c_double), ("slip", c_double), ("compliance", c_double), ("damping", c_double),
        ("restitution", c_double), ("restitution_threshold", c_double), ("adhesive_force", c_double),
    ]


class Finding(Struct):
    _fields_ = [
        ("code", c_uint32), ("reserved", c_uint32), ("geometry", GeometryId), ("other", GeometryId),
        ("message", c_char * 168),
    ]


class Sleep(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("steps", c_uint32), ("linear_speed", c_double), ("linear_acceleration", c_double),
        ("angular_speed", c_double), ("angular_acceleration", c_double),
    ]


class SleepChange(Struct):
    _fields_ = [
        ("part", PartId), ("is_asleep", c_uint32), ("reserved", c_uint32),
    ]


class Island(Struct):
    _fields_ = [
        ("id", c_uint64), ("first_part", c_uint32), ("part_count", c_uint32),
    ]


class Velocity(Struct):
    _fields_ = [
        ("linear", Vec3), ("angular", Vec3),
    ]


class Event(Struct):
    _fields_ = [
        ("kind", c_uint32), ("flags", c_uint32), ("geometry_a", GeometryId), ("geometry_b", GeometryId),
        ("contact_id", c_uint64), ("first_contact", c_uint32), ("contact_count", c_uint32),
    ]


class StepStats(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("reserved", c_uint32), ("parts", c_uint64), ("geometries", c_uint64),
        ("parked", c_uint64), ("moved", c_uint64), ("candidate_pairs", c_uint64), ("filtered_pairs", c_uint64),
        ("examined_pairs", c_uint64), ("kept_pairs", c_uint64), ("touching_pairs", c_uint64),
        ("contacts", c_uint64), ("unsupported_pairs", c_uint64), ("events", c_uint64), ("bytes", c_uint64),
        ("refresh_microseconds", c_double), ("broadphase_microseconds", c_double),
        ("pair_microseconds", c_double), ("narrowphase_microseconds", c_double),
        ("contact_microseconds", c_double), ("asleep", c_uint64),
    ]


class QueryFilter(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("flags", c_uint32), ("layers", c_uint64), ("mask", c_uint64), ("ignore_part", PartId),
        ("ignore_geometry", GeometryId), ("ray_start", c_uint32), ("reserved", c_uint32),
    ]


class QueryHit(Struct):
    _fields_ = [
        ("geometry", GeometryId), ("feature", Feature), ("child", c_uint32), ("reserved", c_uint32),
        ("distance", c_double), ("point", Vec3), ("normal", Vec3),
    ]


class CastHit(Struct):
    _fields_ = [
        ("geometry", GeometryId), ("fraction", c_double), ("contact", Distance), ("feature_a", Feature),
        ("feature_b", Feature), ("child_a", c_uint32), ("child_b", c_uint32),
    ]


class Closest(Struct):
    _fields_ = [
        ("geometry", GeometryId), ("distance", Distance),
    ]


class LayoutEntry(Struct):
    _fields_ = [
        ("type", c_char_p), ("field", c_char_p), ("offset", c_uint64), ("size", c_uint64),
    ]


class Pick(Struct):
    _fields_ = [
        ("geometry", GeometryId), ("feature", Feature), ("child", c_uint32), ("reserved", c_uint32),
        ("distance", c_double), ("point", Vec3), ("normal", Vec3),
    ]


class Camera(Struct):
    _fields_ = [
        ("struct_size", c_uint32), ("width", c_uint32), ("height", c_uint32), ("reserved", c_uint32),
        ("pose", Pose), ("vertical_fov", c_double), ("near_distance", c_double), ("far_distance", c_double),
    ]
