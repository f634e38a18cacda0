// SPDX-License-Identifier: Apache-2.0

package abut

import (
	"errors"
	"math"
	"runtime"
	"strings"
	"sync"
	"testing"
)

func must[T any](value T, failure error) T {
	if failure != nil {
		panic(failure)
	}
	return value
}

func ok(failure error) {
	if failure != nil {
		panic(failure)
	}
}

// A universe with a row of balls of radius 1, each 1.5 from the next.
func row(count int) (*Universe, []PartID, []GeometryID) {
	universe, ball := must(NewUniverse(1)), must(Sphere(1))
	defer ball.Release()
	parts, geometries := []PartID{}, []GeometryID{}
	for i := 0; i < count; i++ {
		parts = append(parts, must(universe.AddPart(Dynamic, At(1.5*float64(i), 0, 0))))
		geometries = append(geometries, must(universe.AddGeometry(parts[i], ball)))
	}
	return universe, parts, geometries
}

func contactsOfAStep(universe *Universe) int {
	ok(universe.Step(0.01))
	return len(must(universe.Contacts()))
}

func TestKinds(t *testing.T) {
	square := []Vec3{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}
	for kind, shape := range map[string]*Shape{
		"box": must(Box(1, 2, 3)), "capsule": must(Capsule(0.5, 2)), "plane": must(Plane(Vec3{0, 0, 2}, 0)),
		"hull": must(Hull(square)), "mesh": must(Mesh(square, [][3]uint32{{0, 1, 2}, {0, 2, 3}})),
		"cone": must(OfKind("cone", 1, 2)),
	} {
		if shape.Kind() != kind {
			t.Errorf("%s is a %s", kind, shape.Kind())
		}
		shape.Release()
		shape.Release()
	}
}

func TestBadInputIsNamed(t *testing.T) {
	universe, parts, _ := row(1)
	defer universe.Destroy()
	ok(universe.RemovePart(parts[0]))
	_, negative := Sphere(-1)
	_, nan := Sphere(math.NaN())
	_, empty := Hull(nil)
	_, unknown := OfKind("blob")
	for _, each := range []struct {
		failure error
		status  Status
		words   string
	}{
		{negative, OutOfRange, "radius is -1"}, {nan, NotFinite, "radius"}, {empty, Empty, "point"},
		{unknown, UnknownValue, "kind"}, {universe.SetPose(parts[0], At(0, 0, 0)), StaleID, "part"},
	} {
		var failure *Error
		if !errors.As(each.failure, &failure) || failure.Status != each.status ||
			!strings.Contains(failure.Message, each.words) {
			t.Errorf("%v; expected %v about %s", each.failure, each.status, each.words)
		}
	}
}

func TestTwoShapes(t *testing.T) {
	box, here := must(Box(1, 1, 1)), At(0, 0, 0)
	found := must(PairDistance(box, here, box, At(3.5, 0, 0)))
	if found.Distance != 1.5 || found.Normal != (Vec3{1, 0, 0}) {
		t.Error(found)
	}
	if must(PairOverlaps(box, here, box, At(3.5, 0, 0), 0)) || !must(PairOverlaps(box, here, box, At(3.5, 0, 0), 2)) {
		t.Error("boxes 1.5 apart are within a margin of 2, and do not overlap")
	}
	if many := must(PairDistances(box, []Pose{here, here}, box, []Pose{At(3, 0, 0), At(4, 0, 0)})); many[1].Distance != 2 {
		t.Error(many)
	}
	if _, failure := PairDistances(box, []Pose{here}, box, nil); !strings.Contains(failure.Error(), "posesB has 0") {
		t.Error(failure)
	}
	if points := must(PairContacts(box, here, box, At(0, 0, 1.75))); len(points) != 4 || points[0].Distance != -0.25 {
		t.Error(points)
	}
}

func TestBatchesAreThoseOfEachPair(t *testing.T) {
	box, here := must(Box(1, 1, 1)), At(0, 0, 0)
	from, to := []Pose{here, here, here}, []Pose{At(0, 0, 1.75), At(9, 0, 0), At(1.5, 0, 0)}
	lists := must(PairContactLists(box, from, box, to))
	if len(lists) != 3 || len(lists[0]) != 4 || len(lists[1]) != 0 || len(lists[2]) != 4 {
		t.Fatal(lists)
	}
	for i, contact := range must(PairContacts(box, here, box, to[2])) {
		if lists[2][i] != contact {
			t.Error(lists[2][i], contact)
		}
	}
	still := make([]Vec3, 3)
	hits := must(PairCasts(box, from, []Vec3{{0, 0, 4}, {0, 0, 4}, {4, 0, 0}}, box, []Pose{to[1], to[0], At(4, 0, 0)}, still))
	if hits[0] != nil || hits[1].Fraction != 0 || math.Abs(hits[2].Fraction-0.5) > 1e-9 {
		t.Error(hits)
	}
	if _, failure := PairCasts(box, from, still, box, to, nil); !strings.Contains(failure.Error(), "displacementsB has 0") {
		t.Error(failure)
	}
	ground := must(Plane(Vec3{0, 0, 1}, 0))
	if _, failure := PairContactLists(ground, from, ground, to); !strings.Contains(failure.Error(), "pair 0: there is no algorithm") {
		t.Error(failure)
	}
}

func TestAUniverseTellsWhyTwoAreApart(t *testing.T) {
	universe := must(NewUniverse(1))
	ball := must(Sphere(1))
	geometries := []GeometryID{}
	for i := 0; i < 3; i++ {
		part := must(universe.AddPart(Dynamic, At(1.5*float64(i), 0, 0)))
		geometries = append(geometries, must(universe.AddGeometry(part, ball)))
	}
	if reasons := must(universe.WhyApart(geometries[0], geometries[1])); reasons != ApartByDetection {
		t.Error(reasons)
	}
	if failure := universe.Step(0.01); failure != nil {
		t.Fatal(failure)
	}
	for i, expected := range []ApartReasons{ApartByPart | ApartByKinds, 0, ApartByBoxes} {
		if reasons := must(universe.WhyApart(geometries[0], geometries[i])); reasons != expected {
			t.Error(i, reasons)
		}
	}
	if _, failure := universe.WhyApart(geometries[0], GeometryID{}); !strings.Contains(failure.Error(), "geometry_b is null") {
		t.Error(failure)
	}
	universe.Destroy()
}

func TestMoreContactsThanExpectedAreAllThere(t *testing.T) {
	vertices, triangles := []Vec3{}, [][3]uint32{}
	for i := 0; i < 12; i++ {
		x, first := 3*float64(i), uint32(3*i)
		vertices = append(vertices, Vec3{x, 0, 0}, Vec3{x + 1, 0, 0}, Vec3{x, 1, 0})
		triangles = append(triangles, [3]uint32{first, first + 1, first + 2})
	}
	mesh, ground := must(Mesh(vertices, triangles)), must(Box(50, 50, 1))
	single := must(Mesh(vertices[:3], triangles[:1]))
	one := len(must(PairContacts(single, At(0, 0, 0), ground, At(0, 0, -0.9))))
	if all := len(must(PairContacts(mesh, At(0, 0, 0), ground, At(0, 0, -0.9)))); one == 0 || all < one {
		t.Errorf("%d contacts of one triangle, %d of twelve", one, all)
	}
}

func TestSteps(t *testing.T) {
	universe, parts, geometries := row(2)
	defer universe.Destroy()
	if contactsOfAStep(universe) != 1 {
		t.Fatal("the balls do not touch")
	}
	contact := must(universe.Contacts())[0]
	if contact.Distance != -0.5 || contact.GeometryA != geometries[0] || contact.GeometryB != geometries[1] {
		t.Error(contact)
	}
	hit := must(universe.CastRay(Vec3{-5, 0, 0}, Vec3{2, 0, 0}))
	if hit == nil || hit.Geometry != geometries[0] || hit.Distance != 4 {
		t.Error(hit)
	}
	if hit := must(universe.CastRay(Vec3{-5, 0, 0}, Vec3{-1, 0, 0})); hit != nil {
		t.Error(hit)
	}
	ok(universe.SetPose(parts[1], At(9, 0, 0)))
	if contactsOfAStep(universe) != 0 {
		t.Error("the balls still touch")
	}
}

func TestFilter(t *testing.T) {
	universe, _, geometries := row(3)
	defer universe.Destroy()
	asked := 0
	ok(universe.SetFilter(func(a, b GeometryID) bool {
		asked++
		ok(universe.Park(geometries[0], LongTerm))
		return b != geometries[2]
	}))
	if contactsOfAStep(universe) != 1 || asked != 2 {
		t.Errorf("asked %d times", asked)
	}
	if contactsOfAStep(universe) != 0 {
		t.Error("the geometry is not parked")
	}
	ok(universe.Park(geometries[0], NotParked))
	ok(universe.SetFilter(func(a, b GeometryID) bool { panic("no idea") }))
	func() {
		defer func() {
			if raised := recover(); raised != "no idea" {
				t.Errorf("raised %v", raised)
			}
		}()
		ok(universe.Step(0.01))
	}()
	last := universe.filter
	ok(universe.SetFilter(nil))
	if contactsOfAStep(universe) != 2 {
		t.Error("a pair is left out")
	}
	defer func() {
		if recover() == nil {
			t.Error("the last filter is kept")
		}
	}()
	last.Value()
}

func TestMessagesOfGoroutinesAreTheirOwn(t *testing.T) {
	// More threads than cores, so that goroutines change theirs often.
	defer runtime.GOMAXPROCS(runtime.GOMAXPROCS(16))
	var group sync.WaitGroup
	for i := 0; i < 64; i++ {
		group.Add(1)
		go func(radius float64, word string) {
			defer group.Done()
			for n := 0; n < 2000; n++ {
				if _, failure := Sphere(radius); !strings.Contains(failure.Error(), word) {
					t.Errorf("%v; expected %s", failure, word)
				}
			}
		}([]float64{-1, -2}[i%2], []string{"-1", "-2"}[i%2])
	}
	group.Wait()
}
