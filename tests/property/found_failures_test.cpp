// SPDX-License-Identifier: Apache-2.0
// Inputs on which this library itself failed. Each is asked in many common frames and from both sides.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "oracle/known_failures.hpp"
#include "oracle/support.hpp"
#include "shortfall.hpp"
#include "solids.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using oracle::KnownFailure;
using oracle::Quad;
using oracle::Vec;

constexpr double allowed = 1e-9;  // part of the size

std::vector<KnownFailure> rows() { return oracle::read_known_failures(ABUT_TEST_DATA "/found.jsonl"); }

property::SolidSubject solid_of(const std::string& name, const oracle::FailureShape& shape) {
  if (shape.type != "convex") return property::make_solid(shape.type, name, shape.parameters);
  std::vector<double> numbers;
  for (const oracle::Point& p : shape.soup.points) numbers.insert(numbers.end(), p.begin(), p.end());
  return property::make_solid("hull", name, numbers);
}

struct Placed {
  const property::SolidSubject& shape;
  abut_pose pose;

  // How far a point of the world is from the shape.
  [[nodiscard]] Quad distance_to(const abut_vec3& point) const {
    const oracle::Pose exact = property::pose_of(pose);
    return oracle::distance_to_solid(shape.solid, exact.rotate_back(property::vec_of(point) - exact.position));
  }
};

// The pose after a common turn of the world.
abut_pose turned(const oracle::Pose& turn, const oracle::FailurePose& pose) {
  const oracle::Pose own = oracle::pose_of(pose);
  const auto& p = turn.orientation;
  const auto& q = own.orientation;
  const std::array<Quad, 4> wxyz{
      p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
      p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
  const Vec at = turn.rotate(own.position);
  const auto rounded = [](Quad value) { return static_cast<double>(value); };
  return {{rounded(at.x), rounded(at.y), rounded(at.z)},
          {rounded(wxyz[0]), rounded(wxyz[1]), rounded(wxyz[2]), rounded(wxyz[3])}};
}

void judge(const Placed& a, const Placed& b, double truth) {
  abut_distance found{};
  const auto status =
      abut_pair_distance(a.shape.subject.shape.get(), &a.pose, b.shape.subject.shape.get(), &b.pose, nullptr, &found);
  ASSERT_EQ(status, ABUT_OK) << abut_last_error_message();
  const double size = a.shape.subject.size + b.shape.subject.size, rounding = 1e-14 * size;
  EXPECT_NEAR(found.distance, truth, allowed * size);
  EXPECT_LE(found.lower, truth + rounding);
  EXPECT_GE(found.upper, truth - rounding);
  EXPECT_LE(found.upper - found.lower, allowed * size);
  const Quad overlap = oracle::overlap_along(a.shape.solid, property::pose_of(a.pose), b.shape.solid,
                                             property::pose_of(b.pose), property::vec_of(found.normal));
  EXPECT_NEAR(static_cast<double>(overlap), -found.distance, allowed * size) << "along the normal";
  EXPECT_LE(static_cast<double>(a.distance_to(found.point_a)), allowed * size) << "point_a";
  EXPECT_LE(static_cast<double>(b.distance_to(found.point_b)), allowed * size) << "point_b";
}

// The frame as it is, and turns.
std::vector<oracle::Pose> frames() {
  std::vector<oracle::Pose> list{oracle::Pose{}};
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 40; ++i) {
    list.push_back(oracle::Pose::from({0, 0, 0}, {part(random), part(random), part(random), part(random)}));
  }
  return list;
}

TEST(FoundFailures, HaveTheirDepthNormalAndPointsInAllFrames) {
  std::vector<std::string> asked;
  for (const KnownFailure& row : rows()) {
    ASSERT_TRUE(row.a && row.b && row.distance) << row.id;
    asked.push_back(row.id);
    const property::SolidSubject a = solid_of(row.id + " a", *row.a), b = solid_of(row.id + " b", *row.b);
    std::size_t number = 0;
    for (const oracle::Pose& frame : frames()) {
      SCOPED_TRACE(row.id + ", seed 51, frame " + std::to_string(number++));
      const Placed placed_a{a, turned(frame, row.pose_a)}, placed_b{b, turned(frame, row.pose_b)};
      judge(placed_a, placed_b, static_cast<double>(*row.distance));
      judge(placed_b, placed_a, static_cast<double>(*row.distance));
    }
  }
  EXPECT_EQ(asked,
            (std::vector<std::string>{"abut-cone-flat-hull", "abut-cylinder-flat-hull", "abut-cone-box-two-zeros",
                                      "abut-flat-hull-in-box-witness", "abut-flat-ellipsoid-sphere-normal"}));
}

}  // namespace
