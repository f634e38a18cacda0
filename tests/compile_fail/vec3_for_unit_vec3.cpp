// SPDX-License-Identifier: Apache-2.0
// A vector of any length where a direction is asked.
// expect: no known conversion from 'const .*Vec3' to 'const .*UnitVec3'
import abut;

abut::Vec3 along(const abut::UnitVec3& direction);
abut::Vec3 along(const abut::UnitVec3& direction) { return 2.0 * direction.vec(); }

abut::Vec3 unchecked(const abut::Vec3& direction);
abut::Vec3 unchecked(const abut::Vec3& direction) { return along(direction); }
