// SPDX-License-Identifier: Apache-2.0

package abut

// #include <abut/abut.h>
// uint32_t abutAskFilter(void *context, abut_universe *universe, abut_geometry_id a, abut_geometry_id b);
// static abut_status set_go_filter(abut_universe *universe, uintptr_t handle) {
//   return abut_universe_set_filter(universe, handle == 0 ? NULL : (abut_filter)abutAskFilter, (void *)handle);
// }
import "C"

import (
	"math"
	"runtime"
	"runtime/cgo"
	"unsafe"
)

// PartID names a part: a body with a pose. When the part is gone, calls answer StaleID.
type PartID struct{ Slot, Generation uint32 }

// GeometryID names a geometry: a shape on a part.
type GeometryID struct{ Slot, Generation uint32 }

func (id PartID) raw() C.abut_part_id {
	return C.abut_part_id{C.uint32_t(id.Slot), C.uint32_t(id.Generation)}
}

func (id GeometryID) raw() C.abut_geometry_id {
	return C.abut_geometry_id{C.uint32_t(id.Slot), C.uint32_t(id.Generation)}
}

func geometryID(id C.abut_geometry_id) GeometryID {
	return GeometryID{uint32(id.slot), uint32(id.generation)}
}

// Motion says how a part moves.
type Motion uint32

// Pairs of parts of which neither is dynamic are never examined.
const (
	Dynamic  Motion = C.ABUT_MOTION_DYNAMIC
	Animated Motion = C.ABUT_MOTION_ANIMATED
	Static   Motion = C.ABUT_MOTION_STATIC
)

// Universe is a space in which parts meet. One goroutine at a time may change it; several may read it meanwhile.
type Universe struct {
	pointer *C.abut_universe
	filter  cgo.Handle
}

type filter struct {
	keeps func(a, b GeometryID) bool
	panic any
}

// NewWeldedUniverse makes a universe in which static geometries that lie side by side have contacts as one shape.
func NewWeldedUniverse(threads uint32) (*Universe, error) {
	return newUniverse(threads, C.ABUT_UNIVERSE_WELDS)
}

// NewUniverse makes an empty universe whose steps use that many threads; 0 is as many as there may be.
func NewUniverse(threads uint32) (*Universe, error) {
	return newUniverse(threads, 0)
}

func newUniverse(threads uint32, flags C.abut_universe_flags) (*Universe, error) {
	var options C.abut_universe_options
	C.abut_universe_options_init(&options, C.uint32_t(unsafe.Sizeof(options)))
	options.threads = C.uint32_t(threads)
	options.flags = flags
	universe := &Universe{}
	failure := check(func() C.abut_status { return C.abut_universe_create(&options, &universe.pointer) })
	if failure != nil {
		return nil, failure
	}
	runtime.SetFinalizer(universe, (*Universe).Destroy)
	return universe, nil
}

// Destroy frees the universe and everything in it. Twice is allowed.
func (universe *Universe) Destroy() {
	C.abut_universe_destroy(universe.pointer)
	universe.pointer = nil
	universe.forget(universe.filter)
	universe.filter = 0
}

// AddPart creates a part, which has no geometry yet.
func (universe *Universe) AddPart(motion Motion, pose Pose) (PartID, error) {
	var options C.abut_part_options
	C.abut_part_options_init(&options, C.uint32_t(unsafe.Sizeof(options)))
	options.motion = C.abut_motion(motion)
	options.pose = pose.raw()
	var out C.abut_part_id
	failure := universe.call(func() C.abut_status { return C.abut_part_create(universe.pointer, &options, &out) })
	return PartID{uint32(out.slot), uint32(out.generation)}, failure
}

// RemovePart destroys a part with its geometries.
func (universe *Universe) RemovePart(part PartID) error {
	return universe.call(func() C.abut_status { return C.abut_part_destroy(universe.pointer, part.raw()) })
}

// AddGeometry puts a shape on a part. The universe keeps the shape alive.
func (universe *Universe) AddGeometry(part PartID, shape *Shape) (GeometryID, error) {
	defer runtime.KeepAlive(shape)
	var out C.abut_geometry_id
	failure := universe.call(func() C.abut_status {
		return C.abut_geometry_create(universe.pointer, part.raw(), shape.pointer, nil, &out)
	})
	return geometryID(out), failure
}

// GeometryOptions are those that AddGeometryWith takes. Begin with DefaultGeometry().
type GeometryOptions struct {
	Sensor    bool
	Pose      Pose    // in the frame of the part
	Tolerance float64 // not negative; the tolerance of a pair is the sum of both
	UserData  uint64
	Layers    uint64 // what it is
	Mask      uint64 // the layers that it meets
	Exclusion uint64 // geometries that have a bit in common never meet
	Label     uint32 // for rules
	Tag       uint32 // for policies, below 64
	Material  uint32
	Parking   Parking
}

// DefaultGeometry is what AddGeometry takes.
func DefaultGeometry() GeometryOptions {
	return GeometryOptions{Pose: At(0, 0, 0), Layers: 1, Mask: math.MaxUint64}
}

// AddGeometryWith puts a shape on a part, with options. The universe keeps the shape alive.
func (universe *Universe) AddGeometryWith(part PartID, shape *Shape, given GeometryOptions) (GeometryID, error) {
	defer runtime.KeepAlive(shape)
	var options C.abut_geometry_options
	C.abut_geometry_options_init(&options, C.uint32_t(unsafe.Sizeof(options)))
	if given.Sensor {
		options.flags = C.ABUT_GEOMETRY_SENSOR
	}
	options.pose = given.Pose.raw()
	options.tolerance = C.double(given.Tolerance)
	options.user_data = C.uint64_t(given.UserData)
	options.layers, options.mask = C.uint64_t(given.Layers), C.uint64_t(given.Mask)
	options.exclusion = C.uint64_t(given.Exclusion)
	options.label, options.tag = C.uint32_t(given.Label), C.uint32_t(given.Tag)
	options.material, options.parking = C.uint32_t(given.Material), C.abut_parking(given.Parking)
	var out C.abut_geometry_id
	failure := universe.call(func() C.abut_status {
		return C.abut_geometry_create(universe.pointer, part.raw(), shape.pointer, &options, &out)
	})
	return geometryID(out), failure
}

// RemoveGeometry destroys a geometry.
func (universe *Universe) RemoveGeometry(geometry GeometryID) error {
	return universe.call(func() C.abut_status { return C.abut_geometry_destroy(universe.pointer, geometry.raw()) })
}

// Pose tells where a part is.
func (universe *Universe) Pose(part PartID) (Pose, error) {
	var out C.abut_pose
	failure := universe.call(func() C.abut_status { return C.abut_part_pose(universe.pointer, part.raw(), &out) })
	turn := out.orientation
	return Pose{vec3(out.position), [4]float64{float64(turn.w), float64(turn.x), float64(turn.y), float64(turn.z)}}, failure
}

// SetPoses places parts, all or none.
func (universe *Universe) SetPoses(parts []PartID, at []Pose) error {
	if len(parts) != len(at) {
		return differ("parts", len(parts), "at", len(at))
	}
	if len(parts) == 0 {
		return nil
	}
	ids := make([]C.abut_part_id, len(parts))
	for i, part := range parts {
		ids[i] = part.raw()
	}
	return universe.call(func() C.abut_status {
		return C.abut_parts_set_poses(universe.pointer, &ids[0], poses(at), C.size_t(len(parts)))
	})
}

// Pointer is that of the C interface, for what this package does not wrap. It is nil when the universe is destroyed.
func (universe *Universe) Pointer() unsafe.Pointer {
	return unsafe.Pointer(universe.pointer)
}

// SetPose places a part; takes effect for contacts at the next step.
func (universe *Universe) SetPose(part PartID, pose Pose) error {
	its := pose.raw()
	return universe.call(func() C.abut_status { return C.abut_part_set_pose(universe.pointer, part.raw(), &its) })
}

// Parking says whether a geometry takes part.
type Parking uint32

// A parked geometry meets nothing. ShortTerm keeps its place in the broad phase.
const (
	NotParked Parking = C.ABUT_PARKING_NONE
	ShortTerm Parking = C.ABUT_PARKING_SHORT_TERM
	LongTerm  Parking = C.ABUT_PARKING_LONG_TERM
)

// ApartReasons say what keeps two geometries from being examined: all that hold.
type ApartReasons uint32

// Why two geometries are apart; abut.h tells more of each.
const (
	ApartByPart      ApartReasons = C.ABUT_APART_PART
	ApartByMotion    ApartReasons = C.ABUT_APART_MOTION
	ApartByParking   ApartReasons = C.ABUT_APART_PARKING
	ApartByExclusion ApartReasons = C.ABUT_APART_EXCLUSION
	ApartByLayers    ApartReasons = C.ABUT_APART_LAYERS
	ApartByRule      ApartReasons = C.ABUT_APART_RULE
	ApartByFilter    ApartReasons = C.ABUT_APART_FILTER
	ApartByKinds     ApartReasons = C.ABUT_APART_KINDS
	ApartByBoxes     ApartReasons = C.ABUT_APART_BOXES
	ApartByPolicy    ApartReasons = C.ABUT_APART_POLICY
	ApartByDetection ApartReasons = C.ABUT_APART_DETECTION
	ApartBySide      ApartReasons = C.ABUT_APART_SIDE
)

// WhyApart tells why two geometries are not examined; 0 where they are, so that the distance of their shapes decides.
func (universe *Universe) WhyApart(a, b GeometryID) (ApartReasons, error) {
	var out C.abut_apart_reasons
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_why_apart(universe.pointer, a.raw(), b.raw(), &out)
	})
	return ApartReasons(out), failure
}

// Park parks a geometry, or brings it back. A filter may do that, too.
func (universe *Universe) Park(geometry GeometryID, parking Parking) error {
	return universe.call(func() C.abut_status {
		return C.abut_geometry_park(universe.pointer, geometry.raw(), C.abut_parking(parking))
	})
}

// Step finds what touches at the present poses; dt is the time since the step before. It moves nothing.
func (universe *Universe) Step(dt float64) error {
	failure := universe.call(func() C.abut_status { return C.abut_universe_step(universe.pointer, C.double(dt)) })
	if universe.filter != 0 {
		asked := universe.filter.Value().(*filter)
		if raised := asked.panic; raised != nil {
			asked.panic = nil
			panic(raised)
		}
	}
	return failure
}

// Contacts of the last step, copied, ordered by the slots of the two geometries, then deepest first.
func (universe *Universe) Contacts() ([]Contact, error) {
	defer runtime.KeepAlive(universe)
	var first *C.abut_contact
	var count C.size_t
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_contacts(universe.pointer, &first, &count)
	})
	if failure != nil {
		return nil, failure
	}
	return contacts(first, count), nil
}

// Hit is where a ray meets a geometry.
type Hit struct {
	Geometry      GeometryID
	Distance      float64 // from the origin, along the unit direction
	Point, Normal Vec3
}

// CastRay finds the first geometry that a ray meets; nil for none. It sees poses as of the last step.
func (universe *Universe) CastRay(origin, direction Vec3) (*Hit, error) {
	ray := C.abut_ray{origin.raw(), direction.raw(), C.double(math.Inf(1))}
	var its C.abut_query_hit
	failure := universe.call(func() C.abut_status {
		return C.abut_universe_cast_rays(universe.pointer, &ray, 1, nil, &its)
	})
	if failure != nil || its.geometry.slot == 0 {
		return nil, failure
	}
	return &Hit{geometryID(its.geometry), float64(its.distance), vec3(its.point), vec3(its.normal)}, nil
}

// SetFilter says which pairs that come near are kept; nil keeps all. It is asked in a step, on the goroutine that
// steps. A panic of it keeps the pair, and goes on when the step is over. One that names its universe keeps it alive:
// destroy the universe then.
func (universe *Universe) SetFilter(keeps func(a, b GeometryID) bool) error {
	var handle cgo.Handle
	if keeps != nil {
		handle = cgo.NewHandle(&filter{keeps: keeps})
	}
	failure := universe.call(func() C.abut_status { return C.set_go_filter(universe.pointer, C.uintptr_t(handle)) })
	if failure != nil {
		universe.forget(handle)
		return failure
	}
	universe.forget(universe.filter)
	universe.filter = handle
	return nil
}

func (universe *Universe) forget(handle cgo.Handle) {
	if handle != 0 {
		handle.Delete()
	}
}

func (universe *Universe) call(function func() C.abut_status) error {
	defer runtime.KeepAlive(universe)
	return check(function)
}

// A panic must not unwind through C: it is kept for the end of the step.
//
//export abutAskFilter
func abutAskFilter(context unsafe.Pointer, _ *C.abut_universe, a, b C.abut_geometry_id) (kept C.uint32_t) {
	asked := cgo.Handle(uintptr(context)).Value().(*filter)
	if asked.panic != nil {
		return 1
	}
	defer func() {
		if raised := recover(); raised != nil {
			asked.panic = raised
			kept = 1
		}
	}()
	if asked.keeps(geometryID(a), geometryID(b)) {
		return 1
	}
	return 0
}
