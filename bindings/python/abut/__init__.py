# SPDX-License-Identifier: Apache-2.0
"""abut, 3D collision detection, in Python: shapes, distances and contacts of pairs, universes, picking.

    with Shape.sphere(1.0) as ball, Shape.box(1.0, 1.0, 1.0) as box:
        print(pair_distance(ball, pose(), box, pose(3.0, 0.0, 0.0)).distance)

Objects are released by `with`, by close(), or when they are collected. Failures of the library raise Error, which
carries the status and the message. Poses, points and rays are structs, sequences of numbers or NumPy arrays; answers of
many are Records, whose fields are columns. NumPy is needed for arrays only. docs/python.md tells more.
"""

from . import c
from .c import VERSION_MAJOR, VERSION_MINOR, Error, library
from .c.constants import *
from .c.structs import (
    Aabb, Camera, CastHit, Closest, Collidable, Contact, ContactMaterial, Distance, Event, Feature, Finding, Focus,
    GeometryId, GeometryInfo, GeometryOptions, HeightFieldDesc, HullReport, Island, LayoutEntry, LocalPoints, MeshOptions,
    PairMemory, PartId, PartOptions, Pick, Policy, Pose, Quat, QueryFilter, QueryHit, QueryOptions, Ray, RayHit, Revision,
    ShapeDesc, Sleep, SleepChange, StepStats, UniverseOptions, Vec3, Velocity)
from .lending import Borrowed, StaleError
from .pairs import (
    pair_cast, pair_contacts, pair_distance, pair_memories, pairs_cast, pairs_contacts, pairs_distance, points_distance,
    validate_contact)
from .picker import Picker, camera
from .records import Groups, Records
from .shapes import Shape, pair_support, shape_kinds
from .universe import Universe, shape_cast_rays
from .values import pose, poses, ray, rays

__version__ = "0.2.0"


def version() -> str:
    """Version of the library that was loaded."""
    return library.abut_version_string().decode()


def has_feature(name: str) -> bool:
    """Whether the library contains a feature, such as "threads" or "hull"."""
    return library.abut_has_feature(name.encode()) == 1
