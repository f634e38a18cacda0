// SPDX-License-Identifier: Apache-2.0

// Package abut finds where 3D shapes touch: distances, contacts and rays, for two shapes or for a universe of many
// that move. It calls the C interface, which pkg-config finds as "abut"; include/abut/abut.h is the reference.
//
// Everything that is created must be released or destroyed; a finalizer does it for what is forgotten.
package abut

// #cgo pkg-config: abut
// #include <abut/abut.h>
import "C"

import (
	"fmt"
	"runtime"
	"unsafe"
)

// Vec3 is x, y, z.
type Vec3 [3]float64

// Pose maps local points p to Orientation * p + Position.
type Pose struct {
	Position    Vec3
	Orientation [4]float64 // unit quaternion w, x, y, z
}

// At is a pose at a place, not turned.
func At(x, y, z float64) Pose {
	return Pose{Vec3{x, y, z}, [4]float64{1, 0, 0, 0}}
}

// Status is what went wrong, as a number of abut.h.
type Status int32

// Some statuses that programs ask for; abut.h has all of them.
const (
	NotFinite    Status = C.ABUT_NOT_FINITE
	OutOfRange   Status = C.ABUT_OUT_OF_RANGE
	Empty        Status = C.ABUT_EMPTY
	StaleID      Status = C.ABUT_STALE_ID
	UnknownValue Status = C.ABUT_UNKNOWN_VALUE
	Unsupported  Status = C.ABUT_UNSUPPORTED
)

func (status Status) String() string {
	return C.GoString(C.abut_status_name(C.abut_status(status)))
}

// Error is a call that failed, and changed nothing.
type Error struct {
	Status  Status
	Message string // which argument, which value, what was expected
}

func (failure *Error) Error() string {
	return failure.Message
}

// check makes a call and asks for its message on the same thread, since messages are kept for each.
func check(call func() C.abut_status) error {
	runtime.LockOSThread()
	defer runtime.UnlockOSThread()
	status := call()
	if status == C.ABUT_OK {
		return nil
	}
	return &Error{Status(status), C.GoString(C.abut_last_error_message())}
}

func differ(a string, countA int, b string, countB int) error {
	return &Error{C.ABUT_INVALID_ARGUMENT,
		fmt.Sprintf("%s has %d elements and %s has %d; expected as many", a, countA, b, countB)}
}

func (vector Vec3) raw() C.abut_vec3 {
	return C.abut_vec3{C.double(vector[0]), C.double(vector[1]), C.double(vector[2])}
}

func (pose Pose) raw() C.abut_pose {
	turn := pose.Orientation
	return C.abut_pose{pose.Position.raw(),
		C.abut_quat{C.double(turn[0]), C.double(turn[1]), C.double(turn[2]), C.double(turn[3])}}
}

func vec3(vector C.abut_vec3) Vec3 {
	return Vec3{float64(vector.x), float64(vector.y), float64(vector.z)}
}

// Distance of two shapes. It is negative where they overlap; the true one lies in [Lower, Upper].
type Distance struct {
	Distance, Lower, Upper float64
	PointA, PointB         Vec3 // on the surfaces
	Normal                 Vec3 // unit, from a to b
}

func distance(its C.abut_distance) Distance {
	return Distance{float64(its.distance), float64(its.lower), float64(its.upper),
		vec3(its.point_a), vec3(its.point_b), vec3(its.normal)}
}

// Contact is one contact point of two shapes.
type Contact struct {
	GeometryA, GeometryB GeometryID // zero outside of a universe
	ID                   uint64     // the same while the same features touch
	ChildA, ChildB       uint32
	PointA, PointB       Vec3 // on the surfaces
	Normal               Vec3 // unit, from a to b
	Distance             float64
	Age                  uint32 // steps before this one that reported it
}

func contacts(first *C.abut_contact, count C.size_t) []Contact {
	found := make([]Contact, 0, int(count))
	for _, its := range unsafe.Slice(first, int(count)) {
		found = append(found, Contact{
			geometryID(its.geometry_a), geometryID(its.geometry_b), uint64(its.id),
			uint32(its.child_a), uint32(its.child_b), vec3(its.point_a), vec3(its.point_b), vec3(its.normal),
			float64(its.distance), uint32(its.age)})
	}
	return found
}
