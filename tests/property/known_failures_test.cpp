// Inputs on which other libraries failed, judged by the rule of tests/data/README.md.
#include "oracle/known_failures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "record.hpp"
#include "subject.hpp"

namespace {

using oracle::KnownFailure;

property::Subject subject_of(const std::string& name, const oracle::FailureShape& shape) {
  const auto& p = shape.parameters;
  if (shape.type == "sphere") return property::make_sphere(name, p[0]);
  if (shape.type == "box") return property::make_box(name, p[0], p[1], p[2]);
  if (shape.type == "capsule") return property::make_capsule(name, p[0], p[1]);
  return property::make_hull(name, shape.body.core);
}

abut_pose rounded(const oracle::FailurePose& pose) {
  const oracle::Pose exact = oracle::pose_of(pose);
  const auto part = [&exact](std::size_t i) { return static_cast<double>(exact.orientation.at(i)); };
  return {{pose.position[0], pose.position[1], pose.position[2]}, {part(0), part(1), part(2), part(3)}};
}

double along(const abut_distance& d) {
  return (d.point_b.x - d.point_a.x) * d.normal.x + (d.point_b.y - d.point_a.y) * d.normal.y +
         (d.point_b.z - d.point_a.z) * d.normal.z;
}

void judge(const KnownFailure& row, abut_algorithm algorithm) {
  const property::Subject a = subject_of(row.id + " a", row.a);
  const property::Subject b = subject_of(row.id + " b", row.b);
  const abut_pose pose_a = rounded(row.pose_a);
  const abut_pose pose_b = rounded(row.pose_b);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = algorithm;
  abut_distance result{};
  const abut_status status = abut_shapes_distance(a.shape.get(), &pose_a, b.shape.get(), &pose_b, &options, &result);
  if (status == ABUT_UNSUPPORTED && algorithm != ABUT_ALGORITHM_AUTO) return;
  ASSERT_EQ(status, ABUT_OK) << row.id << ": " << abut_last_error_message();

  const double reference = static_cast<double>(row.reference);
  const double error = std::abs(static_cast<double>(oracle::quad(result.distance) - row.reference));
  const double size = std::max(a.size, b.size);
  std::printf("%-40s %24.17g %24.17g %10.2e %4u\n", row.id.c_str(), result.distance, reference, error,
              result.iterations);
  property::record().add("known failures, algorithm " + std::to_string(algorithm), row.id, error / size,
                         (result.upper - result.lower) / size, result.iterations);

  EXPECT_TRUE(std::isfinite(result.distance)) << row.id;
  EXPECT_LE(error, 1e-9 * size + 1e-9 * std::abs(reference)) << row.id;
  if (std::abs(reference) > 1e-9 * size) EXPECT_EQ(result.distance < 0, reference < 0) << row.id;
  EXPECT_NEAR(std::hypot(result.normal.x, result.normal.y, result.normal.z), 1, 1e-14) << row.id;
  const double far = std::hypot(pose_a.position.x, pose_a.position.y, pose_a.position.z);
  EXPECT_NEAR(along(result), result.distance, 1e-13 * (a.size + b.size + far + std::abs(reference))) << row.id;
  EXPECT_LE(result.lower, result.distance) << row.id;
  EXPECT_GE(result.upper, result.distance) << row.id;
}

std::vector<KnownFailure> rows() { return oracle::read_known_failures(ABUT_TEST_DATA "/known_failures.jsonl"); }

TEST(KnownFailures, AreRead) { EXPECT_EQ(rows().size(), 58u); }

TEST(KnownFailures, AreAnsweredRightByDefault) {
  std::printf("%-40s %24s %24s %10s %4s\n", "id", "ours", "reference", "error", "steps");
  for (const KnownFailure& row : rows()) judge(row, ABUT_ALGORITHM_AUTO);
}

TEST(KnownFailures, AreAnsweredRightFromSupportPoints) {
  std::printf("%-40s %24s %24s %10s %4s\n", "id", "ours", "reference", "error", "steps");
  for (const KnownFailure& row : rows()) judge(row, ABUT_ALGORITHM_GJK_EPA);
}

}  // namespace
