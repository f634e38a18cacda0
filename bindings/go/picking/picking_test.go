// SPDX-License-Identifier: Apache-2.0

package picking

import (
	"strings"
	"testing"

	"abut"
)

func must[T any](value T, failure error) T {
	if failure != nil {
		panic(failure)
	}
	return value
}

// A row of unit cubes along X, 4 apart, and a camera in front of the one in the middle.
func row() (*abut.Universe, []abut.GeometryID, *Camera) {
	universe, cube := must(abut.NewUniverse(1)), must(abut.Box(1, 1, 1))
	var geometries []abut.GeometryID
	for _, x := range []float64{-4, 0, 4} {
		part := must(universe.AddPart(abut.Dynamic, abut.At(x, 0, 0)))
		geometries = append(geometries, must(universe.AddGeometry(part, cube)))
	}
	camera := NewCamera(200, 100)
	if failure := camera.LookAt(abut.Vec3{0, -10, 0}, abut.Vec3{}, abut.Vec3{0, 0, 1}); failure != nil {
		panic(failure)
	}
	return universe, geometries, camera
}

func TestTheMouse(t *testing.T) {
	universe, geometries, camera := row()
	picker := must(New(universe))
	universe.Destroy() // the picker keeps it
	defer picker.Destroy()
	if hit := must(picker.PickPixel(camera, 100, 50, 0)); hit == nil || hit.Geometry != geometries[1] || hit.Distance != 9 {
		t.Error("the cube in the middle is not under the mouse", hit)
	}
	if hit := must(picker.PickPixel(camera, 100, 2, 0)); hit != nil {
		t.Error("there is something in the sky", hit)
	}
	touching, inside := must(picker.Select(camera, 0, 0, 101, 100, false)), must(picker.Select(camera, 0, 0, 101, 100, true))
	if len(touching) != 2 || len(inside) != 1 || inside[0] != geometries[0] {
		t.Error("the rectangle has others", touching, inside)
	}
	if picture := must(picker.Render(camera)); len(picture) != 20000 || picture[0] != nil || picture[100+200*50] == nil {
		t.Error("the picture is another one")
	}
	if hit := must(picker.CastRay(abut.Vec3{-10, 0, 0}, abut.Vec3{1, 0, 0})); hit == nil || hit.Geometry != geometries[0] {
		t.Error("the ray meets another one", hit)
	}
	camera.SetVerticalExtent(4)
	if hit := must(picker.PickPixel(camera, 100, 24, 0)); hit != nil {
		t.Error("parallel rays pass above the cube", hit)
	}
}

func TestBadInputIsNamed(t *testing.T) {
	universe, _, camera := row()
	picker := must(New(universe))
	_, failure := picker.PickPixel(camera, 0, 0, -1)
	if failure == nil || !strings.HasPrefix(failure.Error(), "radius is -1") {
		t.Error(failure)
	}
	if _, failure = picker.CastRay(abut.Vec3{}, abut.Vec3{}); failure == nil || !strings.Contains(failure.Error(), "direction") {
		t.Error(failure)
	}
	camera.SetVerticalFov(4)
	if _, failure = picker.Render(camera); failure == nil || !strings.Contains(failure.Error(), "vertical_fov") {
		t.Error(failure)
	}
	picker.Destroy()
	picker.Destroy()
	if _, failure = picker.CastRay(abut.Vec3{}, abut.Vec3{1, 0, 0}); failure == nil || !strings.Contains(failure.Error(), "picker") {
		t.Error(failure)
	}
}
