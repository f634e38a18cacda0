// SPDX-License-Identifier: Apache-2.0
// The record of a contact: its friction frame, its room, and its points in the frames of the geometries.
#include <cmath>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double gap_of(const abut_vec3& a, const abut_vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

// By the product of quaternions q * (0, v) * conjugate(q).
abut_vec3 placed(const abut_pose& pose, const abut_vec3& v) {
  const abut_quat& q = pose.orientation;
  const abut_vec3 u{q.x, q.y, q.z};
  const abut_vec3 once = cross(u, v);
  const abut_vec3 twice = cross(u, once);
  return {pose.position.x + v.x + 2 * (q.w * once.x + twice.x), pose.position.y + v.y + 2 * (q.w * once.y + twice.y),
          pose.position.z + v.z + 2 * (q.w * once.z + twice.z)};
}

abut_pose random_pose(std::mt19937_64& random, double spread) {
  std::normal_distribution<double> normal;
  abut_quat q{normal(random), normal(random), normal(random), normal(random)};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  return {{spread * normal(random), spread * normal(random), spread * normal(random)}, q};
}

abut_universe_options with_local_points() {
  abut_universe_options options = default_universe_options();
  options.flags = ABUT_UNIVERSE_LOCAL_POINTS;
  return options;
}

std::vector<abut_local_points> local_points(const abut_universe* universe) {
  return copy_of(abut_universe_local_points, universe);
}

// The one contact of a ball at the origin and another one that lies in a direction.
abut_contact contact_along(const abut_vec3& direction) {
  const Shape ball = make_sphere(1);
  const abut_pose here = at(0, 0, 0), there = at(direction.x, direction.y, direction.z);
  abut_contact contact{};
  std::size_t count = 0;
  require(abut_pair_contacts(ball, &here, ball, &there, nullptr, &contact, 1, &count));
  EXPECT_EQ(count, 1U);
  return contact;
}

std::uint64_t packed_id(const abut_feature& first, const abut_feature& second) {
  return std::uint64_t{1} << 62 | std::uint64_t{first.kind} << 59 | std::uint64_t{first.index} << 31 |
         std::uint64_t{second.kind} << 28 | second.index;
}

TEST(ContactRecord, IdIsPackedFromTheFeatures) {
  std::mt19937_64 random(11);
  std::vector<Shape> shapes;
  shapes.push_back(make_sphere(1));
  shapes.push_back(make_box(1, 0.75, 0.5));
  shapes.push_back(make_octahedron(1));
  shapes.push_back(make_capsule(0.25, 1));
  shapes.push_back(make_plane({0, 0, 1}, 0));
  std::size_t packed = 0, hashed = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shape& a = shapes.at(random() % shapes.size());
    const Shape& b = shapes.at(random() % (shapes.size() - 1));
    for (const abut_contact& contact : contacts_of(a, random_pose(random, 0.75), b, random_pose(random, 0.75))) {
      if ((contact.id & ABUT_CONTACT_ID_HASHED) != 0) {
        ++hashed;
        continue;
      }
      ++packed;
      EXPECT_TRUE(contact.id == packed_id(contact.feature_a, contact.feature_b) ||
                  contact.id == packed_id(contact.feature_b, contact.feature_a));
    }
  }
  // Only features that touch more than once have hashed ids.
  EXPECT_GT(packed, 20 * hashed);
}

TEST(ContactRecord, FrictionFrameIsOrthonormalAndRightHanded) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<abut_vec3> directions{{1, 1, 1}, {-1, -1, -1}, {1, 0, 0},     {0, 1, 0},
                                    {0, 0, 1}, {0, 0, -1},   {1e-9, 0, -1}, {1, 1, -1e-17}};
  for (int i = 0; i < 100; ++i) directions.push_back({normal(random), normal(random), normal(random)});
  for (const abut_vec3& direction : directions) {
    const double length = std::sqrt(dot(direction, direction));
    const abut_contact contact = contact_along({direction.x / length, direction.y / length, direction.z / length});
    EXPECT_NEAR(contact.normal.z, direction.z / length, 1e-12);
    EXPECT_NEAR(dot(contact.tangent, contact.tangent), 1, 1e-12)
        << direction.x << ' ' << direction.y << ' ' << direction.z;
    EXPECT_NEAR(dot(contact.tangent, contact.normal), 0, 1e-12);
    const abut_vec3 second = cross(contact.normal, contact.tangent);
    EXPECT_LT(gap_of(cross(contact.tangent, second), contact.normal), 1e-12);
  }
}

TEST(ContactRecord, IsValidAndItsRoomIsZero) {
  const Shape block = make_box(1, 0.5, 0.8), ball = make_sphere(0.7), can = make_of_kind("cylinder", {0.5, 0.6});
  std::mt19937_64 random(11);
  Universe universe;
  for (int i = 0; i < 60; ++i) universe.add(i % 3 == 0 ? block : i % 3 == 1 ? ball : can, random_pose(random, 1));
  const auto contacts = universe.step();
  ASSERT_GT(contacts.size(), 100U);
  for (const abut_contact& contact : contacts) {
    EXPECT_TRUE(succeeded(abut_contact_validate(&contact)));
    EXPECT_EQ(contact.reserved, 0U);
    EXPECT_EQ(contact.toi, 0.0);
  }
}

// Points near the origin do not tell how large the shapes are that touch there.
TEST(ContactRecord, IsValidNearTheOrigin) {
  const std::vector<Shape> shapes = make_one_of_each_kind();
  const auto seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::size_t count = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      std::uint32_t is_supported = 0;
      require(abut_pair_support(abut_shape_kind_of(a), abut_shape_kind_of(b), ABUT_QUERY_CONTACTS, &is_supported));
      for (int i = 0; is_supported == 1 && i < 20; ++i) {
        abut_pose pose_a = random_pose(random, 0.5), pose_b = random_pose(random, 0.5);
        const std::vector<abut_contact> found = contacts_of(a, pose_a, b, pose_b);
        if (found.empty()) continue;
        // Until they touch, and then both to where they do at the origin.
        const abut_contact deepest = *std::ranges::min_element(found, {}, &abut_contact::distance);
        const auto shift = [](abut_pose& pose, double times, const abut_vec3& by) {
          pose.position.x += times * by.x;
          pose.position.y += times * by.y;
          pose.position.z += times * by.z;
        };
        shift(pose_b, -deepest.distance, deepest.normal);
        shift(pose_a, -1, deepest.point_a);
        shift(pose_b, -1, deepest.point_a);
        for (const abut_contact& contact : contacts_of(a, pose_a, b, pose_b, 1e-9)) {
          EXPECT_TRUE(succeeded(abut_contact_validate(&contact)));
          ++count;
        }
      }
    }
  }
  EXPECT_GT(count, 300U);
}

// Balls that touch at the origin: all of it is rounding.
TEST(ContactRecord, IsValidWhereItsPointsAreRounding) {
  const Shape ball = make_sphere(1), block = make_box(1, 1, 1);
  for (const abut_shape* other : {static_cast<abut_shape*>(ball), static_cast<abut_shape*>(block)}) {
    for (const double x : {-1.0, -0.99999999999999989, -0.9999999999999}) {
      for (const abut_contact& contact : contacts_of(ball, {{x, 1e-17, 0}, {0.8, 0, 0.6, 0}}, other, at(1, 0, 0), 1e-9))
        EXPECT_TRUE(succeeded(abut_contact_validate(&contact))) << x;
    }
  }
}

TEST(ContactRecord, LocalPointsLieAtThePointsWhenPlaced) {
  const Shape block = make_box(1, 0.5, 0.8), ball = make_sphere(0.7);
  std::mt19937_64 random(13);
  const abut_universe_options options = with_local_points();
  Universe universe(&options);
  std::vector<abut_part_id> parts;
  for (int i = 0; i < 40; ++i) {
    parts.push_back(universe.add_part(random_pose(random, 1)));
    abut_geometry_options options_of_it = default_geometry_options();
    options_of_it.pose = random_pose(random, 0.2);
    universe.add_geometry(parts.back(), i % 2 == 0 ? block : ball, options_of_it);
  }
  for (int step = 0; step < 3; ++step) {
    const auto contacts = universe.step();
    const auto points = local_points(universe);
    ASSERT_EQ(points.size(), contacts.size());
    ASSERT_GT(points.size(), 50U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::array<abut_geometry_id, 2> ids{contacts.at(i).geometry_a, contacts.at(i).geometry_b};
      std::array<abut_pose, 2> poses{};
      ASSERT_TRUE(succeeded(abut_geometries_poses(universe, ids.data(), 2, poses.data())));
      EXPECT_LT(gap_of(placed(poses[0], points.at(i).a), contacts.at(i).point_a), 1e-12);
      EXPECT_LT(gap_of(placed(poses[1], points.at(i).b), contacts.at(i).point_b), 1e-12);
    }
    // Most pairs keep what they have in the next step: it moves with them in the list.
    for (const std::size_t moved : {3U, 17U}) {
      universe.move(parts.at(moved), random_pose(random, 1));
    }
  }
}

TEST(ContactRecord, LocalPointsAreOfThePosesOfTheDetection) {
  const Shape ball = make_sphere(1);
  const abut_universe_options options = with_local_points();
  Universe universe(&options);
  universe.add(ball, at(0, 0, 0), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(0, 0, 1.5));
  universe.add_geometry(part, ball);
  ASSERT_EQ(universe.step().size(), 1U);
  universe.move(part, at(5, 0, 1.5));
  ASSERT_TRUE(succeeded(abut_universe_refresh(universe)));
  const auto points = local_points(universe);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT(gap_of(points.at(0).a, {0, 0, 1}), 1e-15);
  EXPECT_LT(gap_of(points.at(0).b, {0, 0, -1}), 1e-15);
}

}  // namespace
