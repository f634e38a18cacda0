// SPDX-License-Identifier: Apache-2.0
// Inputs on which other libraries failed, judged by the rule of tests/data/README.md.
#include "oracle/known_failures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "record.hpp"
#include "shortfall.hpp"
#include "solids.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using oracle::FailureShape;
using oracle::KnownFailure;
using oracle::Point;

std::vector<KnownFailure> rows() { return oracle::read_known_failures(ABUT_TEST_DATA "/known_failures.jsonl"); }

std::vector<double> flat(const std::vector<Point>& points) {
  std::vector<double> numbers;
  for (const Point& p : points) numbers.insert(numbers.end(), p.begin(), p.end());
  return numbers;
}

// A disc is a cylinder without height.
property::Subject subject_of(const std::string& name, const FailureShape& shape) {
  if (shape.type == "mesh") return property::make_mesh(name, shape.soup);
  if (shape.type == "disc") return property::make_solid("cylinder", name, {shape.parameters[0], 0}).subject;
  if (shape.type == "convex") return property::make_solid("hull", name, flat(shape.soup.points)).subject;
  if (shape.type == "triangle") return property::make_solid("triangle", name, flat(shape.soup.points)).subject;
  return property::make_solid(shape.type, name, shape.parameters).subject;
}

bool is_curved(const FailureShape& shape) { return shape.type == "cylinder" || shape.type == "ellipsoid"; }

abut_pose rounded(const oracle::FailurePose& pose) {
  const oracle::Pose exact = oracle::pose_of(pose);
  const auto part = [&exact](std::size_t i) { return static_cast<double>(exact.orientation.at(i)); };
  return {{pose.position[0], pose.position[1], pose.position[2]}, {part(0), part(1), part(2), part(3)}};
}

double along(const abut_distance& d) {
  return (d.point_b.x - d.point_a.x) * d.normal.x + (d.point_b.y - d.point_a.y) * d.normal.y +
         (d.point_b.z - d.point_a.z) * d.normal.z;
}

struct Question {
  std::string id;
  const property::Subject& a;
  abut_pose pose_a;
  const property::Subject& b;
  abut_pose pose_b;
  oracle::Quad distance;
  bool is_curved = false;
};

// Part of the size that a value may be off by, and the same part of the value.
constexpr double allowed = 1e-9;
constexpr double allowed_depth_of_curved = 1e-6;

// The answer, unless the pair does not have the algorithm.
std::optional<abut_distance> judge(const Question& q, abut_algorithm algorithm) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = algorithm;
  abut_distance result{};
  const abut_status status =
      abut_pair_distance(q.a.shape.get(), &q.pose_a, q.b.shape.get(), &q.pose_b, &options, &result);
  if (status == ABUT_UNSUPPORTED && algorithm != ABUT_ALGORITHM_AUTO) return std::nullopt;
  EXPECT_EQ(status, ABUT_OK) << q.id << ": " << abut_last_error_message();
  if (status != ABUT_OK) return std::nullopt;

  const double truth = static_cast<double>(q.distance);
  const double error = std::abs(static_cast<double>(oracle::quad(result.distance) - q.distance));
  const double size = std::max(q.a.size, q.b.size);
  property::record().add("known failures, algorithm " + std::to_string(algorithm), q.id, error / size,
                         (result.upper - result.lower) / size, result.iterations);

  const double part = q.is_curved && truth < 0 ? allowed_depth_of_curved : allowed;
  EXPECT_TRUE(std::isfinite(result.distance)) << q.id;
  EXPECT_LE(error, part * size + 1e-9 * std::abs(truth)) << q.id;
  if (std::abs(truth) > 1e-9 * size) EXPECT_EQ(result.distance < 0, truth < 0) << q.id;
  EXPECT_NEAR(std::hypot(result.normal.x, result.normal.y, result.normal.z), 1, 1e-14) << q.id;
  const double far = std::hypot(q.pose_a.position.x, q.pose_a.position.y, q.pose_a.position.z);
  EXPECT_NEAR(along(result), result.distance, 1e-13 * (q.a.size + q.b.size + far + std::abs(truth))) << q.id;
  EXPECT_LE(result.lower, result.distance) << q.id;
  EXPECT_GE(result.upper, result.distance) << q.id;
  return result;
}

void judge_distances(abut_algorithm algorithm) {
  std::printf("%-40s %24s %24s %4s\n", "id", "ours", "reference", "steps");
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.distance) continue;
    ++asked;
    const property::Subject a = subject_of(row.id + " a", *row.a);
    const property::Subject b = subject_of(row.id + " b", *row.b);
    const Question question{
        row.id, a, rounded(row.pose_a), b, rounded(row.pose_b), *row.distance, is_curved(*row.a) || is_curved(*row.b)};
    const auto answer = judge(question, algorithm);
    if (!answer) continue;
    std::printf("%-40s %24.17g %24.17g %4u\n", row.id.c_str(), answer->distance, static_cast<double>(*row.distance),
                answer->iterations);
  }
  EXPECT_EQ(asked, 68u);
}

TEST(KnownFailures, HaveTheirDistanceByDefault) { judge_distances(ABUT_ALGORITHM_AUTO); }

TEST(KnownFailures, HaveTheirDistanceFromSupportPoints) { judge_distances(ABUT_ALGORITHM_GJK_EPA); }

Point sum(const Point& u, const Point& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }

Point between(const Point& start, const Point& end, double time) {
  return {start[0] + time * (end[0] - start[0]), start[1] + time * (end[1] - start[1]),
          start[2] + time * (end[2] - start[2])};
}

// Contacts where the shapes overlap and none where they do not; the deepest is as deep as the shapes overlap.
TEST(KnownFailures, HaveTheirContacts) {
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.asks_contacts) continue;
    ++asked;
    const property::Subject a = subject_of(row.id + " a", *row.a);
    const property::Subject b = subject_of(row.id + " b", *row.b);
    const abut_pose pose_a = rounded(row.pose_a);
    const abut_pose pose_b = rounded(row.pose_b);
    abut_query_options options;
    abut_query_options_init(&options, sizeof options);
    options.max_contacts = 0;
    std::array<abut_contact, 64> contacts{};
    std::size_t count = 0;
    ASSERT_EQ(abut_pair_contacts(a.shape.get(), &pose_a, b.shape.get(), &pose_b, &options, contacts.data(),
                                 contacts.size(), &count),
              ABUT_OK)
        << row.id << ": " << abut_last_error_message();
    const double truth = static_cast<double>(*row.distance);
    EXPECT_EQ(count > 0, truth < 0) << row.id;
    EXPECT_GE(count, row.contacts) << row.id;
    if (count > 0) EXPECT_NEAR(contacts[0].distance, truth, allowed * std::max(a.size, b.size)) << row.id;
  }
  EXPECT_EQ(asked, 25u);
}

// Asks where the first shape, moved along its way, first touches the second.
void judge_cast(const KnownFailure& row) {
  const property::Subject a = subject_of(row.id + " a", *row.a);
  const property::Subject b = subject_of(row.id + " b", *row.b);
  const abut_pose pose_a = rounded(row.pose_a);
  const abut_pose pose_b = rounded(row.pose_b);
  const Point& way = row.cast->displacement;
  const abut_vec3 displacement{way[0], way[1], way[2]};
  const abut_vec3 still{0, 0, 0};
  abut_cast_hit hit{};
  std::uint32_t found = 0;
  ASSERT_EQ(
      abut_pair_cast(a.shape.get(), &pose_a, &displacement, b.shape.get(), &pose_b, &still, nullptr, &hit, &found),
      ABUT_OK)
      << row.id << ": " << abut_last_error_message();
  EXPECT_EQ(found == 1, row.cast->touches) << row.id;
  if (found == 0 || !row.cast->touches) return;
  const double size = std::max(a.size, b.size);
  const double length = std::hypot(way[0], way[1], way[2]);
  std::printf("%-40s %24.17g %24.17g\n", row.id.c_str(), hit.fraction, *row.cast->fraction);
  EXPECT_NEAR(hit.fraction * length, *row.cast->fraction * length, allowed * size) << row.id;
  const double there = *row.cast->fraction > 0 ? 0 : static_cast<double>(*row.distance);
  const double part = is_curved(*row.a) || is_curved(*row.b) ? allowed_depth_of_curved : allowed;
  EXPECT_NEAR(hit.contact.distance, there, part * size) << row.id;
}

TEST(KnownFailures, TouchWhereTheirCastsEnd) {
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.cast) continue;
    ++asked;
    judge_cast(row);
  }
  EXPECT_EQ(asked, 6u);
}

// The two sides of a motion at a time between 0 and 1.
struct Moment {
  property::Subject a;
  property::Subject b;
  oracle::Quad distance;
};

Moment moment_of(const std::string& id, const oracle::FailureMotion& motion, double time) {
  std::array<std::vector<Point>, 2> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_first = motion.is_vertex_face ? i < 1 : i < 2;
    sides.at(is_first ? 0 : 1).push_back(between(motion.start.at(i), motion.end.at(i), time));
  }
  Moment moment{property::make_hull(id + " a", sides[0]), property::make_hull(id + " b", sides[1]), 0};
  moment.distance =
      oracle::signed_distance(moment.a.measured, oracle::Pose{}, moment.b.measured, oracle::Pose{}).distance;
  return moment;
}

// Times that are even, and ever closer to where the two are nearest.
std::vector<double> telling_times(const oracle::FailureMotion& motion) {
  const auto distance = [&motion](double time) { return moment_of("", motion, time).distance; };
  constexpr int even = 64;
  std::vector<double> times;
  for (int i = 0; i <= even; ++i) times.push_back(static_cast<double>(i) / even);
  double best =
      *std::min_element(times.begin(), times.end(), [&](double s, double t) { return distance(s) < distance(t); });
  for (double step = 0.5 / even; step > 1e-16; step /= 2) {
    for (const double time : {best - step, best + step}) {
      if (time < 0 || time > 1) continue;
      times.push_back(time);
      if (distance(time) < distance(best)) best = time;
    }
  }
  return times;
}

// No query follows vertices that each move in their own way. So the five rows of motions are not asked as motions: the
// distances at moments of them are. Whether a motion counts as a collision stays open: the sources say yes to one that
// stays 5e-7 apart and no to one that comes within 4.4e-7.
TEST(KnownFailures, HaveTheirDistanceAtAllTimesOfAMotion) {
  const abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.motion) continue;
    ++asked;
    for (const double time : telling_times(*row.motion)) {
      const Moment moment = moment_of(row.id, *row.motion, time);
      const Question question{row.id, moment.a, here, moment.b, here, moment.distance, false};
      for (const abut_algorithm algorithm : {ABUT_ALGORITHM_AUTO, ABUT_ALGORITHM_GJK_EPA}) judge(question, algorithm);
    }
  }
  EXPECT_EQ(asked, 5u);
}

double distance_to_hit(const property::Subject& shape, const abut_pose& pose, const Point& origin,
                       const Point& direction) {
  const abut_ray ray{{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}, HUGE_VAL};
  abut_ray_hit hit{};
  std::uint32_t found = 0;
  EXPECT_EQ(abut_shape_cast_ray(shape.shape.get(), &pose, &ray, &hit, &found), ABUT_OK);
  return found == 1 ? hit.distance : -HUGE_VAL;
}

// A ray answers with its first crossing; the next ray starts between that one and the next.
TEST(KnownFailures, AreHitByTheirRays) {
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.ray) continue;
    ++asked;
    const property::Subject shape = subject_of(row.id, *row.a);
    double start = 0;
    double last = 0;
    for (const double expected : row.ray->hits) {
      start = last > 0 ? (last + expected) / 2 : 0;
      last = expected;
      const Point origin = between(row.ray->origin, sum(row.ray->origin, row.ray->direction), start);
      EXPECT_NEAR(start + distance_to_hit(shape, rounded(row.pose_a), origin, row.ray->direction), expected, 1e-15)
          << row.id;
    }
  }
  EXPECT_EQ(asked, 2u);
}

struct Triangles {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
};

Triangles triangles_of(const property::Subject& shape) {
  std::size_t points = 0;
  std::size_t triangles = 0;
  EXPECT_EQ(abut_shape_triangles(shape.shape.get(), nullptr, 0, &points, nullptr, 0, &triangles), ABUT_OK);
  Triangles result{std::vector<double>(3 * points), std::vector<std::uint32_t>(3 * triangles)};
  EXPECT_EQ(abut_shape_triangles(shape.shape.get(), result.xyz.data(), points, &points, result.indices.data(),
                                 triangles, &triangles),
            ABUT_OK);
  return result;
}

// A sixth of the sum of the triple products of the triangles' corners.
double volume_of(const Triangles& surface) {
  double sixfold = 0;
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k, std::size_t axis) { return surface.xyz[3 * surface.indices[i + k] + axis]; };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t next = (axis + 1) % 3;
      const std::size_t last = (axis + 2) % 3;
      sixfold += corner(0, axis) * (corner(1, next) * corner(2, last) - corner(1, last) * corner(2, next));
    }
  }
  return sixfold / 6;
}

TEST(KnownFailures, HaveTheirHull) {
  std::size_t asked = 0;
  for (const KnownFailure& row : rows()) {
    if (!row.hull) continue;
    ++asked;
    const property::Subject hull = property::make_solid("hull", row.id, flat(row.hull->points)).subject;
    const Triangles surface = triangles_of(hull);
    const std::set<std::uint32_t> used(surface.indices.begin(), surface.indices.end());
    EXPECT_EQ(used.size(), row.hull->vertices) << row.id;
    EXPECT_GT(volume_of(surface), 0) << row.id;
    if (row.hull->volume) EXPECT_NEAR(volume_of(surface), *row.hull->volume, 1e-14 * *row.hull->volume) << row.id;
  }
  EXPECT_EQ(asked, 2u);
}

// Of 80 rows, two hold nothing to ask: one names a file of points, the other tells of a simulation. Five more are
// motions, of which only moments are asked.
TEST(KnownFailures, AreAllAskedButTwoAndFiveMotions) {
  std::vector<std::string> silent, motions;
  std::size_t count = 0;
  for (const KnownFailure& row : rows()) {
    ++count;
    if (row.motion) {
      motions.push_back(row.id);
    } else if (!row.distance && !row.cast && !row.ray && !row.hull) {
      silent.push_back(row.id);
    }
  }
  EXPECT_EQ(count, 80u);
  EXPECT_EQ(silent, (std::vector<std::string>{"parry-convex-hull-big", "gazebo-2388-sphere-heightmap"}));
  EXPECT_EQ(motions, (std::vector<std::string>{"ipctk-no-zero-toi", "ipctk-bolun-rotating-triangle",
                                               "ipctk-ee-double-root-2", "ipctk-ee-slow-1", "ipctk-ee-slow-2"}));
}

}  // namespace
