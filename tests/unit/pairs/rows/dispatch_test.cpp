// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.registry;
import abut.pairs.two_shapes.runs;
import abut.pairs.rows.dispatch;

namespace {

using abut::Box;
using abut::Capsule;
using abut::HeightField;
using abut::Mesh;
using abut::Pose;
using abut::Route;
using abut::Sphere;
using abut::Vec3;

Sphere ball() { return Sphere::make(std::vector{0.5}, {}, {}).value(); }
abut::Plane floor_plane() { return abut::Plane::make(std::vector{0.0, 0.0, 1.0, 0.0}, {}, {}).value(); }
Mesh sheet() {
  const std::vector<double> xyz{-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0};
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
  return Mesh::make(std::vector{0.0}, xyz, indices).value();
}

// Capabilities decide, not names.
TEST(Route, FollowsFromCapabilities) {
  EXPECT_EQ((abut::route<abut::Plane, Mesh>()), Route::half_space_of_parts);
  EXPECT_EQ((abut::route<Mesh, Mesh>()), Route::parts_of_both);
  EXPECT_EQ((abut::route<Mesh, Capsule>()), Route::parts);
  EXPECT_EQ((abut::route<HeightField, Box>()), Route::parts);
  EXPECT_EQ((abut::route<abut::Plane, abut::Triangle>()), Route::half_space);
  EXPECT_EQ((abut::route<abut::Triangle, abut::Triangle>()), Route::convex);
}

TEST(Route, PlanesNeverMeetPlanes) {
  EXPECT_EQ((abut::route<abut::Plane, abut::Plane>()), Route::unsupported);
  EXPECT_EQ((abut::route<abut::Plane, HeightField>()), Route::half_space_of_parts);
  EXPECT_EQ((abut::route<HeightField, HeightField>()), Route::parts_of_both);
}

TEST(Route, IsTheSameInBothOrders) {
  EXPECT_EQ((abut::route<Capsule, Mesh>()), (abut::route<Mesh, Capsule>()));
  EXPECT_EQ((abut::route<Sphere, abut::Plane>()), (abut::route<abut::Plane, Sphere>()));
  EXPECT_TRUE((abut::is_flipped<Capsule, Mesh>()));
  EXPECT_FALSE((abut::is_flipped<Mesh, Capsule>()));
  EXPECT_TRUE((abut::is_flipped<abut::Triangle, abut::Plane>()));
}

TEST(Route, PairsOfTheTableFollowTheOrderOfTheRegistry) {
  for (std::size_t row = 0; row < abut::Shapes::count; ++row) {
    for (std::size_t column = 0; column < abut::Shapes::count; ++column) {
      const auto& kernels = abut::pair_kernels(row, column);
      if (row <= column) {
        EXPECT_NE(kernels.route, Route::none);
        EXPECT_TRUE(kernels.distance != nullptr && kernels.contacts != nullptr && kernels.contacts_in_frame != nullptr);
      } else {
        EXPECT_TRUE(kernels.distance == nullptr && kernels.contacts == nullptr && kernels.contacts_in_frame == nullptr);
      }
    }
  }
}

TEST(DistanceByRoute, IsRefusedBetweenPlanes) {
  abut::Distance out{};
  abut::Manifold manifold;
  EXPECT_EQ(distance_by_route(floor_plane(), floor_plane(), Pose::identity(), {}, out), abut::Outcome::unsupported);
  EXPECT_EQ(contacts_by_route(floor_plane(), floor_plane(), Pose::identity(), {}, manifold),
            abut::Outcome::unsupported);
  EXPECT_TRUE(manifold.empty());
}

// The answer to a flipped pair is in the frame of its own first shape.
TEST(DistanceByRoute, FlippedPairsAnswerInTheFrameOfTheFirst) {
  test::Random random(281);
  for (int i = 0; i < 200; ++i) {
    const abut::Rotation turn = random.rotation();
    const double height = random.uniform(0.1, 3), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    // The sheet and the floor as they stand to a ball above them.
    const Pose above = Pose{turn, {x, y, height}}.inverse();
    const Vec3 down = above.rotation * Vec3{0, 0, -1};
    abut::Distance out{};
    const auto expect_below = [&] {
      EXPECT_NEAR(out.distance, height - 0.5, 1e-12);
      EXPECT_NEAR(norm(out.normal - down), 0, 1e-12);
      EXPECT_NEAR(norm(out.point_a - 0.5 * down), 0, 1e-12);
      EXPECT_NEAR(norm(out.point_b - height * down), 0, 1e-12);
    };
    ASSERT_EQ(distance_by_route(ball(), sheet(), above, {}, out), abut::Outcome::ok);
    expect_below();
    ASSERT_EQ(distance_by_route(ball(), floor_plane(), above, {}, out), abut::Outcome::ok);
    expect_below();
  }
}

TEST(ContactsByRoute, FlippedPairsLeaveEarlierContactsAlone) {
  abut::Manifold manifold(1);
  manifold[0].id = 77;
  manifold[0].point_a = {1, 2, 3};
  const Pose above = Pose{abut::Rotation::identity(), {0, 0, 0.4}}.inverse();
  ASSERT_EQ(contacts_by_route(ball(), floor_plane(), above, {}, manifold), abut::Outcome::ok);
  ASSERT_EQ(manifold.size(), 2u);
  EXPECT_EQ(manifold[0].id, 77u);
  EXPECT_EQ(manifold[0].point_a, (Vec3{1, 2, 3}));
  EXPECT_NEAR(manifold[1].distance, -0.1, 1e-15);
  EXPECT_NEAR(norm(manifold[1].normal - Vec3{0, 0, -1}), 0, 1e-15);
  EXPECT_NEAR(norm(manifold[1].point_a - Vec3{0, 0, -0.5}), 0, 1e-15);
  EXPECT_NEAR(norm(manifold[1].point_b - Vec3{0, 0, -0.4}), 0, 1e-15);
}

// A run answers each of its jobs as if it were asked alone, with the margin of the job.
TEST(ContactsOfRun, AreThoseOfEachJob) {
  test::Random random(282);
  const Box box = Box::make(std::vector{0.5, 0.6, 0.7}, {}, {}).value();
  const std::vector<abut::ShapeHandle> shapes{abut::ShapeHandle(ball()), abut::ShapeHandle(box)};
  std::vector<Pose> poses;
  std::vector<abut::PairJob> jobs;
  std::vector<abut::ShapeHandle> placed;
  for (std::uint32_t i = 0; i < 60; i += 2) {
    placed.push_back(shapes[0]);
    placed.push_back(shapes[1]);
    poses.push_back({random.rotation(), random.point(3)});
    poses.push_back({random.rotation(), poses.back().position + random.point(1)});
    jobs.push_back({i, i + 1, random.uniform(0, 0.3)});
  }
  const abut::RunKinds kinds{shapes[0]->index(), shapes[1]->index()};
  abut::Manifold all;
  abut::PairMemories memories;
  std::vector<abut::PairResult> results(jobs.size());
  abut::contacts_of_run(kinds, placed, poses, jobs, {}, memories, all, results);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    abut::QuerySettings settings;
    settings.margin = jobs[i].margin;
    abut::Manifold alone;
    const abut::Outcome outcome = abut::pair_kernels(kinds.row, kinds.column)
                                      .contacts(*shapes[0], *shapes[1], Pose::identity(),
                                                relative(poses[jobs[i].a], poses[jobs[i].b]), false, settings, alone);
    EXPECT_EQ(results[i].outcome, outcome);
    ASSERT_EQ(results[i].contacts_end - begin, alone.size()) << "job " << i;
    for (std::size_t k = 0; k < alone.size(); ++k) {
      EXPECT_EQ(all[begin + k].id, alone[k].id);
      EXPECT_NEAR(all[begin + k].distance, alone[k].distance, 1e-14);
      EXPECT_LE(alone[k].distance, jobs[i].margin);
    }
    begin = results[i].contacts_end;
  }
  EXPECT_EQ(begin, all.size());
  EXPECT_GT(all.size(), 10u);
}

// What is remembered of pairs changes no contact, lies where the job says, and is left alone where it says none.
TEST(ContactsOfRun, RememberPairsWhereTheJobsSay) {
  const Box box = Box::make(std::vector{0.5, 0.6, 0.7}, {}, {}).value();
  const std::vector<double> corners{-1, -1, -1, 1, -1, -1, 0, 1, -1, 0, 0, 1};
  const abut::Hull hull = abut::Hull::make({}, corners, {}).value();
  const std::vector<abut::ShapeHandle> shapes{abut::ShapeHandle(box), abut::ShapeHandle(hull)};
  const abut::RunKinds kinds{shapes[0]->index(), shapes[1]->index()};
  abut::PairMemories memories, none;
  while (memories.add() < 2) {
  }
  for (int step = 0; step < 3; ++step) {
    const std::vector<Pose> poses{Pose::identity(), {abut::Rotation::identity(), {0.1, 0.2, 1.6 + 0.01 * step}}};
    std::vector<abut::PairJob> jobs{{0, 1, 0, 2}, {0, 1, 0}, {0, 1, 0, 0}};
    abut::Manifold with, without;
    std::vector<abut::PairResult> results(jobs.size()), expected(jobs.size());
    abut::contacts_of_run(kinds, shapes, poses, jobs, {}, memories, with, results);
    for (abut::PairJob& job : jobs) {
      job.memory = abut::no_memory;
    }
    abut::contacts_of_run(kinds, shapes, poses, jobs, {}, none, without, expected);
    ASSERT_EQ(with.size(), without.size());
    ASSERT_GT(with.size(), 2u);
    for (std::size_t i = 0; i < with.size(); ++i) {
      EXPECT_EQ(with[i].id, without[i].id);
      EXPECT_EQ(with[i].distance, without[i].distance);
      EXPECT_EQ(with[i].point_a, without[i].point_a);
    }
    EXPECT_FALSE(memories.knows_nothing(0));
    EXPECT_TRUE(memories.knows_nothing(1));
    EXPECT_FALSE(memories.knows_nothing(2));
  }
}

}  // namespace
