// SPDX-License-Identifier: Apache-2.0

package abut

// #include <abut/abut.h>
import "C"

import "unsafe"

// Poses and vectors are handed over as they are, so their sizes must agree: an array of a negative length does not
// compile.
var (
	_ [unsafe.Sizeof(Pose{}) - unsafe.Sizeof(C.abut_pose{})]struct{}
	_ [unsafe.Sizeof(C.abut_pose{}) - unsafe.Sizeof(Pose{})]struct{}
	_ [unsafe.Sizeof(Vec3{}) - unsafe.Sizeof(C.abut_vec3{})]struct{}
	_ [unsafe.Sizeof(C.abut_vec3{}) - unsafe.Sizeof(Vec3{})]struct{}
)
