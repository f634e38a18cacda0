// SPDX-License-Identifier: Apache-2.0

package abut

import (
	"math"
	"strings"
	"testing"
)

func TestQueries(t *testing.T) {
	universe, parts, geometries := row(3) // balls of radius 1 at 0, 1.5 and 3
	defer universe.Destroy()
	ok(universe.Refresh())
	ball := must(Sphere(1))
	hits := must(universe.CastRays([]Ray{
		{Origin: Vec3{-9, 0, 0}, Direction: Vec3{1, 0, 0}}, {Origin: Vec3{-9, 0, 0}, Direction: Vec3{1, 0, 0}, MaxDistance: 1},
	}, QueryFilter{}))
	if hits[0] == nil || hits[0].Geometry != geometries[0] || hits[1] != nil {
		t.Error("the rays meet others", hits)
	}
	aside := QueryFilter{IgnorePart: parts[0]}
	if hit := must(universe.CastRays([]Ray{{Origin: Vec3{-9, 0, 0}, Direction: Vec3{1, 0, 0}}}, aside))[0]; hit.Geometry != geometries[1] {
		t.Error("the filter keeps the first one", hit)
	}
	if found := must(universe.Overlaps(ball, At(-1.5, 0, 0), 0, QueryFilter{})); len(found) != 1 || found[0] != geometries[0] {
		t.Error("others overlap", found)
	}
	cast := must(universe.CastShape(ball, At(-6, 0, 0), Vec3{8, 0, 0}, QueryFilter{}))
	if cast == nil || cast.Geometry != geometries[0] || cast.Fraction != 0.5 {
		t.Error("the ball meets another one", cast)
	}
	closest := must(universe.Closest(ball, At(-4, 0, 0), 3, QueryFilter{}))
	if closest == nil || closest.Geometry != geometries[0] || closest.Distance.Distance != 2 {
		t.Error("another one is closest", closest)
	}
	if found := must(universe.Closest(ball, At(-4, 0, 0), 1, QueryFilter{})); found != nil {
		t.Error("something is as near as 1", found)
	}
	if _, failure := universe.Overlaps(ball, At(0, 0, 0), math.NaN(), QueryFilter{}); failure == nil || !strings.HasPrefix(failure.Error(), "margin") {
		t.Error(failure)
	}
	ok(universe.Step(0.1))
	if events := must(universe.Events()); len(events) == 0 || events[0].Kind != Begin || events[0].GeometryA != geometries[0] {
		t.Error("nothing begins", events)
	}
	ok(universe.SetPoses(parts, []Pose{At(0, 0, 0), At(9, 0, 0), At(18, 0, 0)}))
	if at := must(universe.Pose(parts[2])); at != At(18, 0, 0) {
		t.Error("the part is elsewhere", at)
	}
	ok(universe.RemoveGeometry(geometries[0]))
}

func TestOptionsOfGeometries(t *testing.T) {
	universe, parts, _ := row(1)
	defer universe.Destroy()
	options := DefaultGeometry()
	options.Sensor, options.Pose, options.Layers = true, At(0, 5, 0), 2
	sensor := must(universe.AddGeometryWith(parts[0], must(Sphere(1)), options))
	ok(universe.Refresh())
	ray := []Ray{{Origin: Vec3{0, 5, 9}, Direction: Vec3{0, 0, -1}}}
	if hit := must(universe.CastRays(ray, QueryFilter{}))[0]; hit == nil || hit.Geometry != sensor {
		t.Error("the sensor is elsewhere", hit)
	}
	for _, filter := range []QueryFilter{{SkipsSensors: true}, {Mask: 1}, {IgnoreGeometry: sensor}} {
		if hit := must(universe.CastRays(ray, filter))[0]; hit != nil {
			t.Error("the filter keeps the sensor", filter)
		}
	}
	options.Tolerance = -1
	if _, failure := universe.AddGeometryWith(parts[0], must(Sphere(1)), options); failure == nil || !strings.Contains(failure.Error(), "tolerance is -1") {
		t.Error(failure)
	}
}

func TestMoreKinds(t *testing.T) {
	ball := must(Sphere(1))
	for kind, shape := range map[string]*Shape{
		"cylinder": must(Cylinder(1, 2)), "height_field": must(HeightField(2, 2, 1, 1, make([]float64, 4))),
		"particles": must(Particles([]Vec3{{}, {1, 0, 0}}, 0.1)), "composite": must(Composite([]*Shape{ball, ball}, []Pose{At(0, 0, 0), At(3, 0, 0)})),
	} {
		if shape.Kind() != kind {
			t.Error(kind, "is", shape.Kind())
		}
	}
	if _, failure := HeightField(2, 2, 1, 1, nil); failure == nil || !strings.Contains(failure.Error(), "heights has 0") {
		t.Error(failure)
	}
	if _, failure := Composite([]*Shape{ball}, nil); failure == nil || !strings.Contains(failure.Error(), "at has 0") {
		t.Error(failure)
	}
}
