// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "query_scene.hpp"

import abut.universe;

namespace {

using namespace test::queries;

bool is_earlier(const RayContact& a, const RayContact& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.geometry.slot < b.geometry.slot;
}

std::vector<RayContact> cast_at_each(const Universe& universe, const Ray& ray, const std::vector<GeometryId>& ids) {
  std::vector<RayContact> hits;
  for_each(universe, ids, [&](GeometryId id, const AnyShape& shape, const Pose& pose) {
    const auto direction = UnitVec3::from_unit_unchecked(pose.rotation.undo(ray.direction));
    if (const auto hit = cast_ray(shape, pose.undo(ray.origin), direction, ray.max_distance)) {
      hits.push_back({id, hit->distance, ray.origin + hit->distance * ray.direction.vec(), pose.rotation * hit->normal,
                      hit->feature, 0});
    }
  });
  std::ranges::sort(hits, is_earlier);
  return hits;
}

void expect_same(const RayContact& found, const RayContact& expected) {
  EXPECT_EQ(found.geometry, expected.geometry);
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_EQ(found.point, expected.point);
  EXPECT_EQ(found.normal, expected.normal);
  EXPECT_EQ(found.feature, expected.feature);
}

Ray random_ray(Random& random, Real size) {
  const Vec3 origin = random.vector(1.5 * size);
  const Vec3 target = random.vector(size);
  return {origin, UnitVec3::make(target - origin).value(), random.in(0, 1) < 0.1 ? infinity : random.in(0.2, 4) * size};
}

class Queries : public testing::TestWithParam<BroadphaseKind> {
 protected:
  Universe universe{{.broadphase = GetParam()}, 7};
};

TEST_P(Queries, RaysMeetWhatTheShapesSay) {
  fill(universe, 150, 5, 1);
  const std::vector<GeometryId> everything = all_of(universe, {});
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 25000; ++i) {
    const Ray ray = random_ray(random, 5);
    const QueryFilter filter = i % 16 == 0 ? random_filter(universe, random) : QueryFilter{};
    const auto expected = cast_at_each(universe, ray, i % 16 == 0 ? all_of(universe, filter) : everything);
    const auto nearest = cast_ray(universe, ray, filter, HitMode::nearest, RayStart::far_side);
    ASSERT_EQ(nearest.size(), std::min<std::size_t>(expected.size(), 1)) << i;
    hits += static_cast<int>(nearest.size());
    if (!nearest.empty()) {
      expect_same(nearest.front(), expected.front());
    }
    if (i % 4 == 0) {
      const auto all = cast_ray(universe, ray, filter, HitMode::all, RayStart::far_side);
      ASSERT_EQ(all.size(), expected.size()) << i;
      for (std::size_t k = 0; k < all.size(); ++k) {
        expect_same(all[k], expected[k]);
      }
      const auto any = cast_ray(universe, ray, filter, HitMode::any, RayStart::far_side);
      ASSERT_EQ(any.size(), nearest.size());
      if (!any.empty()) {
        EXPECT_TRUE(std::ranges::any_of(expected, [&](const RayContact& hit) {
          return hit.geometry == any.front().geometry && hit.distance == any.front().distance;
        }));
      }
    }
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(hits, 5000);
}

TEST_P(Queries, CastsMeetWhatTheShapesSay) {
  fill(universe, 60, 5, 3);
  Random random(4);
  const auto movers = make_all_kinds();
  int hits = 0;
  for (int i = 0; i < 120; ++i) {
    const AnyShape& mover = *movers[static_cast<std::size_t>(i) % movers.size()];
    const Pose pose = random.pose(6);
    const Vec3 way = i % 10 == 0 ? Vec3{0, 0, 0} : random.vector(8);
    const QueryFilter filter = i % 4 == 0 ? random_filter(universe, random) : QueryFilter{};
    std::vector<CastContact> expected;
    for_each(universe, all_of(universe, filter), [&](GeometryId id, const AnyShape& shape, const Pose& placed) {
      std::optional<ShapeCastHit> hit;
      if (cast_shapes(mover, pose, way, shape, placed, {0, 0, 0}, {}, 1, hit) == Outcome::ok && hit) {
        expected.push_back({id, *hit});
      }
    });
    std::ranges::sort(expected, [](const CastContact& one, const CastContact& other) {
      return one.hit.fraction != other.hit.fraction ? one.hit.fraction < other.hit.fraction
                                                    : one.geometry.slot < other.geometry.slot;
    });
    const auto all = cast_shape(universe, mover, pose, way, filter, HitMode::all);
    ASSERT_EQ(all.size(), expected.size()) << i;
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(all[k].geometry, expected[k].geometry) << i;
      EXPECT_EQ(all[k].hit.fraction, expected[k].hit.fraction) << i;
    }
    const auto nearest = cast_shape(universe, mover, pose, way, filter, HitMode::nearest);
    ASSERT_EQ(nearest.size(), std::min<std::size_t>(expected.size(), 1)) << i;
    if (!nearest.empty()) {
      ++hits;
      EXPECT_EQ(nearest.front().geometry, expected.front().geometry) << i;
      EXPECT_NEAR(nearest.front().hit.fraction, expected.front().hit.fraction, 1e-12);
    }
    EXPECT_EQ(cast_shape(universe, mover, pose, way, filter, HitMode::any).size(), nearest.size());
  }
  EXPECT_GT(hits, 30);
}

TEST_P(Queries, OverlapsAreWhatHasContacts) {
  fill(universe, 120, 4, 5);
  Random random(6);
  const auto probes = make_all_kinds();
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const AnyShape& probe = *probes[static_cast<std::size_t>(i) % probes.size()];
    const Pose pose = random.pose(5);
    const Real margin = i % 3 == 0 ? 0.3 : i % 3 == 1 ? 0 : -0.05;
    const QueryFilter filter = i % 4 == 0 ? random_filter(universe, random) : QueryFilter{};
    std::vector<GeometryId> expected;
    for_each(universe, all_of(universe, filter), [&](GeometryId id, const AnyShape& shape, const Pose& placed) {
      Manifold contacts;
      if (pair_contacts(probe, shape, pose, placed, {.margin = margin}, contacts) == Outcome::ok && !contacts.empty()) {
        expected.push_back(id);
      }
    });
    EXPECT_EQ(find_overlaps(universe, probe, pose, margin, filter), expected) << i;
    found += expected.size();
  }
  EXPECT_GT(found, 150U);
}

TEST_P(Queries, TheClosestIsTheLeastDistance) {
  fill(universe, 80, 6, 7);
  Random random(8);
  const auto probes = make_all_kinds();
  int found = 0;
  for (int i = 0; i < 250; ++i) {
    const AnyShape& probe = *probes[static_cast<std::size_t>(i) % probes.size()];
    const Pose pose = random.pose(i % 5 == 0 ? 60 : 7);
    const Real most = i % 3 == 0 ? infinity : random.in(0, 3);
    const QueryFilter filter = i % 4 == 0 ? random_filter(universe, random) : QueryFilter{};
    std::optional<NearGeometry> expected;
    for_each(universe, all_of(universe, filter), [&](GeometryId id, const AnyShape& shape, const Pose& placed) {
      Distance distance{};
      if (pair_distance(probe, shape, pose, placed, {}, distance) == Outcome::ok && distance.distance <= most &&
          (!expected || distance.distance < expected->distance.distance)) {
        expected = NearGeometry{id, distance};
      }
    });
    const auto nearest = find_closest(universe, probe, pose, most, filter);
    ASSERT_EQ(nearest.has_value(), expected.has_value()) << i;
    if (nearest) {
      ++found;
      EXPECT_EQ(nearest->geometry, expected->geometry) << i;
      EXPECT_EQ(nearest->distance.distance, expected->distance.distance) << i;
    }
  }
  EXPECT_GT(found, 100);
}

TEST_P(Queries, WhatIsParkedIsNotThere) {
  const GeometryId ball = add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  const Ray ray{{-5, 0, 0}, UnitVec3::make({1, 0, 0}).value(), 10};
  const ShapeHandle handle = make_handle("sphere", {0.5});
  const AnyShape& probe = *handle;
  const auto is_there = [&] {
    universe.refresh();
    const bool by_ray = !cast_ray(universe, ray, {}, HitMode::nearest, RayStart::far_side).empty();
    EXPECT_EQ(
        !cast_shape(universe, probe, {Rotation::identity(), {-5, 0, 0}}, {10, 0, 0}, {}, HitMode::nearest).empty(),
        by_ray);
    EXPECT_EQ(!find_overlaps(universe, probe, Pose::identity(), 0, {}).empty(), by_ray);
    EXPECT_EQ(!find_at_point(universe, {0.1, 0, 0}, {}).empty(), by_ray);
    EXPECT_EQ(find_closest(universe, probe, Pose::identity(), infinity, {}).has_value(), by_ray);
    return by_ray;
  };
  EXPECT_TRUE(is_there());
  for (const Parking parking : {Parking::short_term, Parking::long_term}) {
    ASSERT_TRUE(universe.park(std::span(&ball, 1), parking));
    EXPECT_FALSE(is_there());
    ASSERT_TRUE(universe.park(std::span(&ball, 1), Parking::none));
    EXPECT_TRUE(is_there());
  }
  ASSERT_TRUE(universe.destroy_geometries(std::span(&ball, 1)));
  EXPECT_FALSE(is_there());
}

INSTANTIATE_TEST_SUITE_P(EveryBroadphase, Queries,
                         testing::Values(BroadphaseKind::brute, BroadphaseKind::tree, BroadphaseKind::sweep_and_prune,
                                         BroadphaseKind::hash_grid),
                         [](const auto& parameter) {
                           std::string name(name_of(parameter.param));
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// What is asked from many threads at once is answered as from one.
TEST(QueriesOfAUniverse, RunAtOnceOnManyThreads) {
  Universe universe({}, 1);
  fill(universe, 200, 5, 11);
  struct Answers {
    std::vector<RayContact> rays;
    std::vector<CastContact> casts;
    std::vector<GeometryId> overlaps;
    std::vector<Real> closest;
  };
  const auto probe = make_handle("capsule", {0.3, 0.4});
  const auto ask = [&] {
    Answers answers;
    Random random(12);
    for (int i = 0; i < 300; ++i) {
      const auto rays = cast_ray(universe, random_ray(random, 5), {}, HitMode::all, RayStart::far_side);
      answers.rays.insert(answers.rays.end(), rays.begin(), rays.end());
      const Pose pose = random.pose(5);
      if (i % 5 == 0) {
        const auto casts = cast_shape(universe, *probe, pose, random.vector(4), {}, HitMode::all);
        answers.casts.insert(answers.casts.end(), casts.begin(), casts.end());
      }
      const auto overlaps = find_overlaps(universe, *probe, pose, 0.1, {});
      answers.overlaps.insert(answers.overlaps.end(), overlaps.begin(), overlaps.end());
      const auto closest = find_closest(universe, *probe, pose, infinity, {});
      answers.closest.push_back(closest ? closest->distance.distance : infinity);
    }
    return answers;
  };
  const Answers expected = ask();
  EXPECT_GT(expected.rays.size(), 100U);
  EXPECT_GT(expected.casts.size(), 20U);
  std::vector<Answers> found(4);
  std::vector<std::thread> threads;
  for (Answers& answers : found) {
    threads.emplace_back([&] { answers = ask(); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const Answers& answers : found) {
    ASSERT_EQ(answers.rays.size(), expected.rays.size());
    for (std::size_t i = 0; i < expected.rays.size(); ++i) {
      expect_same(answers.rays[i], expected.rays[i]);
    }
    ASSERT_EQ(answers.casts.size(), expected.casts.size());
    for (std::size_t i = 0; i < expected.casts.size(); ++i) {
      EXPECT_EQ(answers.casts[i].geometry, expected.casts[i].geometry);
      EXPECT_EQ(answers.casts[i].hit.fraction, expected.casts[i].hit.fraction);
    }
    EXPECT_EQ(answers.overlaps, expected.overlaps);
    EXPECT_EQ(answers.closest, expected.closest);
  }
}

TEST(Queries, FindGeometriesOfAPartWhoseMotionHasChanged) {
  Universe universe({}, 1);
  const GeometryId ball = add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  universe.refresh();
  const PartId part = universe.describe(ball).value().part;
  const MotionKind fixed = MotionKind::fixed;
  ASSERT_TRUE(universe.set_motions(std::span(&part, 1), std::span(&fixed, 1)).has_value());
  EXPECT_EQ(find_at_point(universe, {0, 0, 0}, {}), std::vector{ball});
  universe.refresh();
  EXPECT_EQ(find_at_point(universe, {0, 0, 0}, {}), std::vector{ball});
}

}  // namespace
