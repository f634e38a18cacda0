// SPDX-License-Identifier: Apache-2.0

package abut

// #include <abut/abut.h>
import "C"

import (
	"math"
	"runtime"
	"unsafe"
)

// CastHit tells where two moving shapes first touch.
type CastHit struct {
	Geometry GeometryID // what is met; zero for two shapes outside of a universe
	Fraction float64    // of the displacements
	Contact  Distance   // at that time
}

// PairContactLists asks for the contacts of many pairs of poses in one call: a slice for each pair.
func PairContactLists(a *Shape, posesA []Pose, b *Shape, posesB []Pose) ([][]Contact, error) {
	if len(posesA) != len(posesB) {
		return nil, differ("posesA", len(posesA), "posesB", len(posesB))
	}
	if len(posesA) == 0 {
		return nil, nil
	}
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	offsets := make([]C.uint64_t, len(posesA)+1)
	room := make([]C.abut_contact, 4*len(posesA))
	for {
		var count C.size_t
		failure := check(func() C.abut_status {
			return C.abut_pairs_contacts(a.pointer, poses(posesA), b.pointer, poses(posesB), C.size_t(len(posesA)), nil,
				&offsets[0], &room[0], C.size_t(len(room)), &count)
		})
		if failure != nil {
			return nil, failure
		}
		if int(count) <= len(room) {
			return cut(contacts(&room[0], count), offsets), nil
		}
		room = make([]C.abut_contact, int(count))
	}
}

func cut(all []Contact, offsets []C.uint64_t) [][]Contact {
	lists := make([][]Contact, len(offsets)-1)
	for i := range lists {
		lists[i] = all[offsets[i]:offsets[i+1]:offsets[i+1]]
	}
	return lists
}

// PairCasts tells when two shapes that move by displacements without turning first touch, for many poses and
// displacements in one call; nil where they never do.
func PairCasts(a *Shape, posesA []Pose, displacementsA []Vec3, b *Shape, posesB []Pose, displacementsB []Vec3) ([]*CastHit, error) {
	count := len(posesA)
	if len(displacementsA) != count {
		return nil, differ("posesA", count, "displacementsA", len(displacementsA))
	}
	if len(posesB) != count {
		return nil, differ("posesA", count, "posesB", len(posesB))
	}
	if len(displacementsB) != count {
		return nil, differ("posesA", count, "displacementsB", len(displacementsB))
	}
	if count == 0 {
		return nil, nil
	}
	defer runtime.KeepAlive(a)
	defer runtime.KeepAlive(b)
	out := make([]C.abut_cast_hit, count)
	failure := check(func() C.abut_status {
		return C.abut_pairs_cast(a.pointer, poses(posesA), vectors(displacementsA), b.pointer, poses(posesB),
			vectors(displacementsB), C.size_t(count), nil, &out[0])
	})
	if failure != nil {
		return nil, failure
	}
	hits := make([]*CastHit, count)
	for i, its := range out {
		if !math.IsInf(float64(its.fraction), 1) {
			hits[i] = &CastHit{Fraction: float64(its.fraction), Contact: distance(its.contact)}
		}
	}
	return hits, nil
}

// A Vec3 is laid out as abut_vec3; layout.go compares them.
func vectors(values []Vec3) *C.abut_vec3 {
	return (*C.abut_vec3)(unsafe.Pointer(&values[0]))
}
