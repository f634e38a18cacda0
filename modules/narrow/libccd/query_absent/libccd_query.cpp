// SPDX-License-Identifier: Apache-2.0
module abut.narrow.libccd;
import abut.capability;
import abut.math;

namespace abut {

Outcome libccd_query(const SupportFunction&, const SupportFunction&, const Vec3&, const Vec3&, Algorithm, Real, Real,
                     Distance&) {
  return Outcome::unsupported;
}

}  // namespace abut
