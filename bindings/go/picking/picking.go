// SPDX-License-Identifier: Apache-2.0

// Package picking finds what rays and the mouse meet in a universe, through Embree. It calls the picking library, which
// pkg-config finds as "abut_picking"; include/abut/picking.h is the reference.
//
// Pictures have x to the right and y down, in pixels; (0.5, 0.5) is the centre of the first one.
package picking

// #cgo pkg-config: abut_picking
// #include <abut/picking.h>
import "C"

import (
	"math"
	"runtime"
	"unsafe"

	"abut"
)

// Camera looks along its local -Z with local +Y up. Make it with NewCamera.
type Camera struct {
	fields C.abut_camera
}

// NewCamera is a perspective camera at the origin, with so many pixels.
func NewCamera(width, height uint32) *Camera {
	camera := &Camera{}
	C.abut_camera_init(&camera.fields, C.uint32_t(unsafe.Sizeof(camera.fields)))
	camera.fields.width, camera.fields.height = C.uint32_t(width), C.uint32_t(height)
	return camera
}

// LookAt places the camera at eye, so that target is in the middle of the picture and up is upwards.
func (camera *Camera) LookAt(eye, target, up abut.Vec3) error {
	its, there, upwards := vector(eye), vector(target), vector(up)
	return check(func() C.abut_status { return C.abut_camera_look_at(&camera.fields, &its, &there, &upwards) })
}

// SetVerticalFov sets the angle between the upper and the lower edge, in radians.
func (camera *Camera) SetVerticalFov(radians float64) {
	camera.fields.projection = C.ABUT_PROJECTION_PERSPECTIVE
	camera.fields.vertical_fov = C.double(radians)
}

// SetVerticalExtent makes all rays parallel; extent is the length between the lower and the upper edge.
func (camera *Camera) SetVerticalExtent(extent float64) {
	camera.fields.projection = C.ABUT_PROJECTION_ORTHOGRAPHIC
	camera.fields.vertical_extent = C.double(extent)
}

// Picker casts rays against one universe, which it follows and keeps until both are destroyed. It sees poses as of the last
// step. One goroutine at a time may use it, and nothing may change the universe meanwhile.
type Picker struct {
	pointer *C.abut_picker
}

// New makes a picker of a universe.
func New(universe *abut.Universe) (*Picker, error) {
	defer runtime.KeepAlive(universe)
	picker := &Picker{}
	failure := check(func() C.abut_status {
		return C.abut_picker_create((*C.abut_universe)(universe.Pointer()), &picker.pointer)
	})
	if failure != nil {
		return nil, failure
	}
	runtime.SetFinalizer(picker, (*Picker).Destroy)
	return picker, nil
}

// Destroy frees the picker. Twice is allowed.
func (picker *Picker) Destroy() {
	C.abut_picker_destroy(picker.pointer)
	picker.pointer = nil
}

// SetFlags chooses whether queries meet sensors, and leave out surfaces whose normal points along the ray.
func (picker *Picker) SetFlags(sensors, skipsBackFaces bool) error {
	var flags C.abut_picker_flags
	if sensors {
		flags |= C.ABUT_PICKER_SENSORS
	}
	if skipsBackFaces {
		flags |= C.ABUT_PICKER_SKIP_BACK_FACES
	}
	return picker.call(func() C.abut_status { return C.abut_picker_set_flags(picker.pointer, flags) })
}

// CastRay finds the first thing that a ray meets; nil for none.
func (picker *Picker) CastRay(origin, direction abut.Vec3) (*abut.Hit, error) {
	ray := C.abut_ray{vector(origin), vector(direction), C.double(math.Inf(1))}
	var out C.abut_pick
	failure := picker.call(func() C.abut_status { return C.abut_picker_cast_ray(picker.pointer, &ray, nil, &out) })
	return hit(out), failure
}

// PickPixel finds what lies under the mouse, or within radius pixels of it; nil for nothing.
func (picker *Picker) PickPixel(camera *Camera, x, y, radius float64) (*abut.Hit, error) {
	var out C.abut_pick
	failure := picker.call(func() C.abut_status {
		return C.abut_picker_pick_pixel(
			picker.pointer, &camera.fields, C.double(x), C.double(y), C.double(radius), nil, &out)
	})
	return hit(out), failure
}

// Select lists the geometries of which any point lies in the rectangle with the corners (x0, y0) and (x1, y1); with isInside,
// those of which all points do.
func (picker *Picker) Select(camera *Camera, x0, y0, x1, y1 float64, isInside bool) ([]abut.GeometryID, error) {
	selection := C.abut_selection(C.ABUT_SELECTION_TOUCHING)
	if isInside {
		selection = C.ABUT_SELECTION_INSIDE
	}
	room := make([]C.abut_geometry_id, 64)
	for {
		var count C.size_t
		failure := picker.call(func() C.abut_status {
			return C.abut_picker_select_rectangle(
				picker.pointer, &camera.fields, C.double(x0), C.double(y0), C.double(x1), C.double(y1), selection, nil,
				&room[0], C.size_t(len(room)), &count)
		})
		if failure != nil {
			return nil, failure
		}
		if int(count) <= len(room) {
			found := make([]abut.GeometryID, int(count))
			for i := range found {
				found[i] = geometry(room[i])
			}
			return found, nil
		}
		room = make([]C.abut_geometry_id, int(count))
	}
}

// Render casts one ray through the centre of each pixel, row by row from the top; nil where it meets nothing.
func (picker *Picker) Render(camera *Camera) ([]*abut.Hit, error) {
	out := make([]C.abut_pick, int(camera.fields.width)*int(camera.fields.height)+1)
	failure := picker.call(func() C.abut_status {
		return C.abut_picker_render(picker.pointer, &camera.fields, nil, &out[0], C.size_t(len(out)))
	})
	if failure != nil {
		return nil, failure
	}
	found := make([]*abut.Hit, len(out)-1)
	for i := range found {
		found[i] = hit(out[i])
	}
	return found, nil
}

func (picker *Picker) call(function func() C.abut_status) error {
	defer runtime.KeepAlive(picker)
	return check(function)
}

// check makes a call and asks for its message on the same thread, since messages are kept for each.
func check(call func() C.abut_status) error {
	runtime.LockOSThread()
	defer runtime.UnlockOSThread()
	status := call()
	if status == C.ABUT_OK {
		return nil
	}
	return &abut.Error{Status: abut.Status(status), Message: C.GoString(C.abut_last_error_message())}
}

func vector(its abut.Vec3) C.abut_vec3 {
	return C.abut_vec3{C.double(its[0]), C.double(its[1]), C.double(its[2])}
}

func geometry(id C.abut_geometry_id) abut.GeometryID {
	return abut.GeometryID{Slot: uint32(id.slot), Generation: uint32(id.generation)}
}

func hit(its C.abut_pick) *abut.Hit {
	if its.geometry.slot == 0 {
		return nil
	}
	point, normal := its.point, its.normal
	return &abut.Hit{Geometry: geometry(its.geometry), Distance: float64(its.distance),
		Point:  abut.Vec3{float64(point.x), float64(point.y), float64(point.z)},
		Normal: abut.Vec3{float64(normal.x), float64(normal.y), float64(normal.z)}}
}
