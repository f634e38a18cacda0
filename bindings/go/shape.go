// SPDX-License-Identifier: Apache-2.0

package abut

// #include <abut/abut.h>
// #include <stdlib.h>
import "C"

import (
	"runtime"
	"unsafe"
)

// Shape never changes, so goroutines and geometries may share it.
type Shape struct {
	pointer *C.abut_shape
}

func made(create func(out **C.abut_shape) C.abut_status) (*Shape, error) {
	var pointer *C.abut_shape
	if failure := check(func() C.abut_status { return create(&pointer) }); failure != nil {
		return nil, failure
	}
	shape := &Shape{pointer}
	runtime.SetFinalizer(shape, (*Shape).Release)
	return shape, nil
}

// Release gives the shape back; geometries keep theirs. Twice is allowed.
func (shape *Shape) Release() {
	C.abut_shape_release(shape.pointer)
	shape.pointer = nil
}

// Sphere is a solid ball, centred.
func Sphere(radius float64) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status { return C.abut_sphere_create(C.double(radius), out) })
}

// Box is solid and centred; its numbers are half extents.
func Box(x, y, z float64) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_box_create(C.double(x), C.double(y), C.double(z), out)
	})
}

// Capsule holds all points within a radius of a segment along local Z, of which halfHeight is one half.
func Capsule(radius, halfHeight float64) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_capsule_create(C.double(radius), C.double(halfHeight), out)
	})
}

// Cylinder is solid along local Z with flat ends, of which halfHeight is one half.
func Cylinder(radius, halfHeight float64) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_cylinder_create(C.double(radius), C.double(halfHeight), out)
	})
}

// HeightField is terrain: columns * rows heights, X fastest.
func HeightField(columns, rows uint32, spacingX, spacingY float64, heights []float64) (*Shape, error) {
	if uint64(columns)*uint64(rows) != uint64(len(heights)) {
		return nil, differ("columns * rows", int(columns)*int(rows), "heights", len(heights))
	}
	place := copied(heights)
	defer C.free(unsafe.Pointer(place))
	var desc C.abut_height_field_desc
	C.abut_height_field_desc_init(&desc, C.uint32_t(unsafe.Sizeof(desc)))
	desc.columns, desc.rows = C.uint32_t(columns), C.uint32_t(rows)
	desc.spacing_x, desc.spacing_y = C.double(spacingX), C.double(spacingY)
	desc.heights = place
	return made(func(out **C.abut_shape) C.abut_status { return C.abut_height_field_create(&desc, out) })
}

// Particles are small balls of one radius.
func Particles(centres []Vec3, radius float64) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_particles_create(numbers(centres), C.size_t(len(centres)), C.double(radius), out)
	})
}

// Composite is one shape of several, each with a pose in its frame. It keeps its children alive.
func Composite(children []*Shape, at []Pose) (*Shape, error) {
	if len(children) != len(at) {
		return nil, differ("children", len(children), "at", len(at))
	}
	if len(children) == 0 {
		return made(func(out **C.abut_shape) C.abut_status { return C.abut_composite_create(nil, nil, 0, out) })
	}
	pointers := make([]*C.abut_shape, len(children))
	for i, child := range children {
		pointers[i] = child.pointer
	}
	defer runtime.KeepAlive(children)
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_composite_create(&pointers[0], poses(at), C.size_t(len(children)), out)
	})
}

// Plane is the half-space of the points p with dot(normal, p) <= offset.
func Plane(normal Vec3, offset float64) (*Shape, error) {
	its := normal.raw()
	return made(func(out **C.abut_shape) C.abut_status { return C.abut_plane_create(&its, C.double(offset), out) })
}

// Hull is the convex hull of points.
func Hull(points []Vec3) (*Shape, error) {
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_hull_create(numbers(points), C.size_t(len(points)), out)
	})
}

// Mesh is a surface of triangles, each three indices, counter-clockwise seen from the front.
func Mesh(vertices []Vec3, triangles [][3]uint32) (*Shape, error) {
	var indices *C.uint32_t
	if len(triangles) > 0 {
		indices = (*C.uint32_t)(unsafe.Pointer(&triangles[0]))
	}
	return made(func(out **C.abut_shape) C.abut_status {
		return C.abut_mesh_create(
			numbers(vertices), C.size_t(len(vertices)), indices, C.size_t(len(triangles)), nil, out)
	})
}

// OfKind makes a shape of any kind that numbers describe, such as "cone" from radius and half height.
func OfKind(kind string, parameters ...float64) (*Shape, error) {
	name := C.CString(kind)
	defer C.free(unsafe.Pointer(name))
	place := copied(parameters)
	defer C.free(unsafe.Pointer(place))
	var desc C.abut_shape_desc
	C.abut_shape_desc_init(&desc, C.uint32_t(unsafe.Sizeof(desc)))
	desc.kind = C.abut_shape_kind_by_name(name)
	desc.parameters = place
	desc.parameter_count = C.uint64_t(len(parameters))
	return made(func(out **C.abut_shape) C.abut_status { return C.abut_shape_create(&desc, out) })
}

// C may keep no pointer of Go in a struct of Go, so numbers that a struct points to are copied to memory of C.
func copied(values []float64) *C.double {
	size := C.size_t(len(values)) * C.size_t(unsafe.Sizeof(float64(0)))
	place := (*C.double)(C.malloc(size + 1))
	for i, value := range values {
		unsafe.Slice(place, len(values))[i] = C.double(value)
	}
	return place
}

// Kind is the name of its kind, such as "sphere".
func (shape *Shape) Kind() string {
	defer runtime.KeepAlive(shape)
	return C.GoString(C.abut_shape_kind_name(C.abut_shape_kind_of(shape.pointer)))
}

func numbers(points []Vec3) *C.double {
	if len(points) == 0 {
		return nil
	}
	return (*C.double)(unsafe.Pointer(&points[0]))
}

// PairDistance is the signed distance of two shapes.
func PairDistance(a *Shape, poseA Pose, b *Shape, poseB Pose) (Distance, error) {
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	atA, atB := poseA.raw(), poseB.raw()
	var out C.abut_distance
	failure := check(func() C.abut_status {
		return C.abut_pair_distance(a.pointer, &atA, b.pointer, &atB, nil, &out)
	})
	if failure != nil {
		return Distance{}, failure
	}
	return distance(out), nil
}

// PairOverlaps tells whether two shapes are within a margin; of 0, whether they overlap or touch.
func PairOverlaps(a *Shape, poseA Pose, b *Shape, poseB Pose, margin float64) (bool, error) {
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	atA, atB := poseA.raw(), poseB.raw()
	var options C.abut_query_options
	C.abut_query_options_init(&options, C.uint32_t(unsafe.Sizeof(options)))
	options.margin = C.double(margin)
	var out C.uint32_t
	failure := check(func() C.abut_status {
		return C.abut_pair_overlaps(a.pointer, &atA, b.pointer, &atB, &options, &out)
	})
	return out == 1, failure
}

// PairDistances asks about many pairs of poses in one call.
func PairDistances(a *Shape, posesA []Pose, b *Shape, posesB []Pose) ([]Distance, error) {
	if len(posesA) != len(posesB) {
		return nil, differ("posesA", len(posesA), "posesB", len(posesB))
	}
	if len(posesA) == 0 {
		return nil, nil
	}
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	out := make([]C.abut_distance, len(posesA))
	failure := check(func() C.abut_status {
		return C.abut_pairs_distance(a.pointer, poses(posesA), b.pointer, poses(posesB), C.size_t(len(out)), nil, &out[0])
	})
	if failure != nil {
		return nil, failure
	}
	found := make([]Distance, len(out))
	for i := range out {
		found[i] = distance(out[i])
	}
	return found, nil
}

// A Pose is laid out as abut_pose; the test of layouts compares them.
func poses(values []Pose) *C.abut_pose {
	return (*C.abut_pose)(unsafe.Pointer(&values[0]))
}

// PairContacts are the contact points of two shapes, deepest first.
func PairContacts(a *Shape, poseA Pose, b *Shape, poseB Pose) ([]Contact, error) {
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	atA, atB := poseA.raw(), poseB.raw()
	room := make([]C.abut_contact, 8)
	for {
		var count C.size_t
		failure := check(func() C.abut_status {
			return C.abut_pair_contacts(
				a.pointer, &atA, b.pointer, &atB, nil, &room[0], C.size_t(len(room)), &count)
		})
		if failure != nil {
			return nil, failure
		}
		if int(count) <= len(room) {
			return contacts(&room[0], count), nil
		}
		room = make([]C.abut_contact, int(count))
	}
}
