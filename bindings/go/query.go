// SPDX-License-Identifier: Apache-2.0

package abut

// #include <abut/abut.h>
import "C"

import (
	"math"
	"runtime"
	"unsafe"
)

// QueryFilter says which geometries a query of a universe looks at. The zero value keeps all.
type QueryFilter struct {
	SkipsSensors   bool
	Layers         uint64     // what the query is, for masks of geometries; 0 stands for all layers
	Mask           uint64     // which layers of geometries it meets; 0 stands for all layers
	IgnorePart     PartID     // left out with all its geometries
	IgnoreGeometry GeometryID // left out
}

func (its QueryFilter) raw() C.abut_query_filter {
	var out C.abut_query_filter
	C.abut_query_filter_init(&out, C.uint32_t(unsafe.Sizeof(out)))
	if its.SkipsSensors {
		out.flags = C.ABUT_QUERY_FILTER_SKIP_SENSORS
	}
	if its.Layers != 0 {
		out.layers = C.uint64_t(its.Layers)
	}
	if its.Mask != 0 {
		out.mask = C.uint64_t(its.Mask)
	}
	out.ignore_part = its.IgnorePart.raw()
	out.ignore_geometry = its.IgnoreGeometry.raw()
	return out
}

// Ray starts at Origin and goes along Direction, which has any length but zero. A MaxDistance of 0 stands for no limit.
type Ray struct {
	Origin, Direction Vec3
	MaxDistance       float64
}

func (ray Ray) raw() C.abut_ray {
	most := ray.MaxDistance
	if most == 0 {
		most = math.Inf(1)
	}
	return C.abut_ray{ray.Origin.raw(), ray.Direction.raw(), C.double(most)}
}

// Refresh makes queries see the present poses and geometries, without looking for contacts. A step does that as well.
func (universe *Universe) Refresh() error {
	return universe.call(func() C.abut_status { return C.abut_universe_refresh(universe.pointer) })
}

// CastRays finds the first geometry that each of many rays meets; nil for none.
func (universe *Universe) CastRays(rays []Ray, filter QueryFilter) ([]*Hit, error) {
	if len(rays) == 0 {
		return nil, nil
	}
	given, out := make([]C.abut_ray, len(rays)), make([]C.abut_query_hit, len(rays))
	for i, ray := range rays {
		given[i] = ray.raw()
	}
	its := filter.raw()
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_cast_rays(universe.pointer, &given[0], C.size_t(len(rays)), &its, &out[0])
	})
	if failure != nil {
		return nil, failure
	}
	found := make([]*Hit, len(out))
	for i, hit := range out {
		if hit.geometry.slot != 0 {
			found[i] = &Hit{geometryID(hit.geometry), float64(hit.distance), vec3(hit.point), vec3(hit.normal)}
		}
	}
	return found, nil
}

// CastShape finds the first geometry that a shape meets while it moves by a displacement without turning; nil for none.
func (universe *Universe) CastShape(shape *Shape, pose Pose, displacement Vec3, filter QueryFilter) (*CastHit, error) {
	defer runtime.KeepAlive(shape)
	at, way, its := pose.raw(), displacement.raw(), filter.raw()
	var hit C.abut_cast_hit
	var count C.size_t
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_cast_shape(
			universe.pointer, shape.pointer, &at, &way, &its, C.ABUT_HIT_NEAREST, &hit, 1, &count)
	})
	if failure != nil || count == 0 {
		return nil, failure
	}
	return &CastHit{geometryID(hit.geometry), float64(hit.fraction), distance(hit.contact)}, nil
}

// geometryIDs asks again with room for all, where there is more than expected.
func geometryIDs(fill func(place *C.abut_geometry_id, capacity C.size_t, count *C.size_t) error) ([]GeometryID, error) {
	room := make([]C.abut_geometry_id, 8)
	for {
		var count C.size_t
		if failure := fill(&room[0], C.size_t(len(room)), &count); failure != nil {
			return nil, failure
		}
		if int(count) <= len(room) {
			found := make([]GeometryID, int(count))
			for i := range found {
				found[i] = geometryID(room[i])
			}
			return found, nil
		}
		room = make([]C.abut_geometry_id, int(count))
	}
}

// Overlaps lists the geometries that a shape touches, or has within a margin.
func (universe *Universe) Overlaps(shape *Shape, pose Pose, margin float64, filter QueryFilter) ([]GeometryID, error) {
	defer runtime.KeepAlive(shape)
	at, its := pose.raw(), filter.raw()
	return geometryIDs(func(place *C.abut_geometry_id, capacity C.size_t, count *C.size_t) error {
		return universe.call(func() C.abut_status {
			return C.abut_universe_overlaps(
				universe.pointer, shape.pointer, &at, &its, C.double(margin), place, capacity, count)
		})
	})
}

// Closest is a geometry and the distance of a shape (a) to it (b).
type Closest struct {
	Geometry GeometryID
	Distance Distance
}

// Closest finds the geometry nearest to a shape; nil where none is as near as maxDistance.
func (universe *Universe) Closest(shape *Shape, pose Pose, maxDistance float64, filter QueryFilter) (*Closest, error) {
	defer runtime.KeepAlive(shape)
	at, its := pose.raw(), filter.raw()
	var out C.abut_closest
	var found C.uint32_t
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_closest(
			universe.pointer, shape.pointer, &at, C.double(maxDistance), &its, &out, &found)
	})
	if failure != nil || found == 0 {
		return nil, failure
	}
	return &Closest{geometryID(out.geometry), distance(out.distance)}, nil
}

// EventKind says what happened to a pair, or to a contact of it.
type EventKind uint32

// What an event tells.
const (
	Begin   EventKind = C.ABUT_EVENT_BEGIN
	Persist EventKind = C.ABUT_EVENT_PERSIST
	End     EventKind = C.ABUT_EVENT_END
)

// Event is one change that a step found.
type Event struct {
	Kind                 EventKind
	GeometryA, GeometryB GeometryID
	ContactID            uint64 // 0 where it is about the pair
}

// Events of the last step, copied, in the order of the contacts.
func (universe *Universe) Events() ([]Event, error) {
	defer runtime.KeepAlive(universe)
	var first *C.abut_event
	var count C.size_t
	failure := universe.call(func() C.abut_status { return C.abut_universe_events(universe.pointer, &first, &count) })
	if failure != nil {
		return nil, failure
	}
	found := make([]Event, 0, int(count))
	for _, its := range unsafe.Slice(first, int(count)) {
		found = append(found, Event{
			EventKind(its.kind), geometryID(its.geometry_a), geometryID(its.geometry_b), uint64(its.contact_id)})
	}
	return found, nil
}
