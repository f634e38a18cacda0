// SPDX-License-Identifier: Apache-2.0
// All fifteen axes of two boxes at once, an axis per lane (Gottschalk, Lin, Manocha, "OBBTree", 1996).
module;
export module abut.narrow.fan.box_sat;
import abut.math;
import abut.narrow.fan.sat;

export namespace abut {

// As sat does for any cores with few faces. Stops at the faces when one already separates by more
// than `limit`.
[[nodiscard]] SatResult sat_of_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, Real noise, Real limit);

}  // namespace abut
