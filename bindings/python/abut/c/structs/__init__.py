# SPDX-License-Identifier: Apache-2.0
"""Structs of abut.h and picking.h, field by field."""

from .elements import (
    Crossing, ElementCounts, ElementPair, ElementsOptions, Stencil)
from .queries import (
    Camera, CastHit, Closest, ImpactHit, Pick, QueryFilter, QueryHit)
from .shapes import (
    Contact, Distance, DistanceFieldDesc, DistanceFieldOptions, DistanceFieldReport, FirstTouch, HeightFieldDesc, HullReport, Impact,
    ImpactOptions, MeshOptions, MeshReport, Movement, PairMemory, QueryOptions, Ray, RayHit, ShapeDesc, UvGridOptions)
from .universe import (
    Acceleration, Collidable, ContactMaterial, Event, Finding, Focus, GeometryInfo, GeometryOptions, Island, LocalPoints,
    PartOptions, Policy, Revision, Sleep, SleepChange, StepImpact, StepStats, UniverseOptions, Velocity)
from .values import (
    Aabb, Feature, GeometryId, LayoutEntry, PartId, Pose, Quat, Vec3)

__all__ = [
    "Aabb", "Acceleration", "Camera", "CastHit", "Closest", "Collidable", "Contact", "ContactMaterial", "Crossing", "Distance",
    "DistanceFieldDesc", "DistanceFieldOptions", "DistanceFieldReport",
    "ElementCounts", "ElementPair", "ElementsOptions", "Event", "Feature", "Finding", "FirstTouch", "Focus", "GeometryId",
    "GeometryInfo", "GeometryOptions", "HeightFieldDesc", "HullReport", "Impact", "ImpactHit", "ImpactOptions",
    "Island", "LayoutEntry", "LocalPoints", "MeshOptions", "MeshReport", "Movement", "PairMemory", "PartId",
    "PartOptions", "Pick", "Policy", "Pose", "Quat", "QueryFilter", "QueryHit", "QueryOptions", "Ray", "RayHit", "Revision",
    "ShapeDesc", "Sleep", "SleepChange", "Stencil", "StepImpact", "StepStats", "UniverseOptions", "UvGridOptions", "Vec3",
    "Velocity"]
