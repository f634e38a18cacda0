// SPDX-License-Identifier: Apache-2.0
#include "bad_values.hpp"

namespace abut_test {

std::vector<BadVector> non_finite_vectors() {
  std::vector<BadVector> vectors;
  for (const BadNumber& bad : non_finite_numbers) {
    vectors.push_back({{bad.value, 1.0, 1.0}, bad.word});
    vectors.push_back({{1.0, bad.value, 1.0}, bad.word});
    vectors.push_back({{1.0, 1.0, bad.value}, bad.word});
  }
  return vectors;
}

std::vector<BadPose> bad_poses() {
  std::vector<BadPose> poses;
  for (const BadVector& bad : non_finite_vectors()) {
    poses.push_back({{bad.vector, no_rotation}, ABUT_NOT_FINITE, bad.word});
  }
  const abut_vec3 origin{0.0, 0.0, 0.0};
  for (const BadNumber& bad : non_finite_numbers) {
    poses.push_back({{origin, {bad.value, 0.0, 0.0, 0.0}}, ABUT_NOT_FINITE, bad.word});
    poses.push_back({{origin, {1.0, bad.value, 0.0, 0.0}}, ABUT_NOT_FINITE, bad.word});
    poses.push_back({{origin, {1.0, 0.0, bad.value, 0.0}}, ABUT_NOT_FINITE, bad.word});
    poses.push_back({{origin, {1.0, 0.0, 0.0, bad.value}}, ABUT_NOT_FINITE, bad.word});
  }
  poses.push_back({{origin, {0.0, 0.0, 0.0, 0.0}}, ABUT_ZERO_VECTOR, "orientation"});
  poses.push_back({{origin, {-0.0, 0.0, -0.0, 0.0}}, ABUT_ZERO_VECTOR, "orientation"});
  for (const double length : {2.0, 0.5, 1.0015, 0.9985, 1e-200, 1e200}) {
    poses.push_back({{origin, {length, 0.0, 0.0, 0.0}}, ABUT_NOT_UNIT, "orientation"});
    poses.push_back({{origin, {0.0, 0.6 * length, 0.0, 0.8 * length}}, ABUT_NOT_UNIT, "orientation"});
  }
  return poses;
}

}  // namespace abut_test
