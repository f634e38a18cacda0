// SPDX-License-Identifier: Apache-2.0
// A C++ program that imports the installed modules: the distance of two unit balls 4 apart.
#include <array>
#include <cstdio>
import abut;

int main() {
  const std::array<double, 1> radius{1};
  const auto ball = abut::Sphere::make(radius, {}, {});
  if (!ball.has_value()) {
    std::puts(ball.error().message.c_str());
    return 1;
  }
  const abut::AnyShape shape = ball.value();
  const abut::Pose apart{abut::Rotation::identity(), {4, 0, 0}};
  abut::Distance distance{};
  if (abut::pair_distance(shape, shape, apart, {}, distance) != abut::Outcome::ok) {
    return 1;
  }
  std::printf("distance %g\n", distance.distance);
}
