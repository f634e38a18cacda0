// SPDX-License-Identifier: Apache-2.0
// Contacts of a universe: their order, their ids, how long they can be read.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Boxes on a floor of boxes, touching several neighbours each.
void add_a_heap(Universe& universe, const Shape& block) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) universe.add(block, at(1.9 * i, 1.9 * j, 0.0));
  }
}

TEST(Contacts, AreOrderedBySlotsThenDeepestFirst) {
  const Shape block = make_box(1, 1, 1);
  Universe universe;
  add_a_heap(universe, block);
  const auto contacts = universe.step();
  ASSERT_GT(contacts.size(), 24U);
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    const abut_contact& a = contacts.at(i - 1);
    const abut_contact& b = contacts.at(i);
    EXPECT_LE(std::tuple(a.geometry_a.slot, a.geometry_b.slot, a.distance),
              std::tuple(b.geometry_a.slot, b.geometry_b.slot, b.distance));
  }
  for (const abut_contact& contact : contacts) EXPECT_LT(contact.geometry_a.slot, contact.geometry_b.slot);
}

TEST(Contacts, KeepTheRecordsPromises) {
  const Shape block = make_box(1, 1, 1);
  Universe universe;
  add_a_heap(universe, block);
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>> ids;
  for (const abut_contact& contact : universe.step()) {
    const abut_vec3& n = contact.normal;
    const double gap = (contact.point_b.x - contact.point_a.x) * n.x + (contact.point_b.y - contact.point_a.y) * n.y +
                       (contact.point_b.z - contact.point_a.z) * n.z;
    EXPECT_NEAR(contact.distance, gap, 1e-12);
    EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0, 1e-12);
    EXPECT_LT(contact.distance, 0.0);
    EXPECT_EQ(contact.toi, 0.0);
    EXPECT_EQ(contact.flags, 0U);
    EXPECT_EQ(contact.age, 0U);
    EXPECT_EQ(contact.user_data, 0U);
    EXPECT_TRUE(ids.insert({contact.geometry_a.slot, contact.geometry_b.slot, contact.id}).second)
        << "ids differ within a pair";
  }
}

// Lines that are parallel but for a thousandth, seen along the normal: points lie aside by no more than that share of
// the stretch. The points of the deepest contact lie opposite each other.
TEST(Contacts, OfLinesThatAreNearlyParallelLieNearlyOpposite) {
  const Shape cylinder = make_of_kind("cylinder", {1, 0.5}), capsule = make_of_kind("capsule", {0.5, 1});
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> one(-1, 1);
  double most_nearly = 0;
  for (const double angle : {3e-4, 0.003, 0.05}) {
    for (int i = 0; i < 100; ++i) {
      const double x = one(random), y = one(random), z = 0.3 * one(random), scale = angle / std::hypot(x, y, z);
      const abut_pose pose{{0.3 + 0.1 * one(random), 0.2, 0.5 + 0.1 * one(random)},
                           {1, 0.5 * scale * x, 0.5 * scale * y, 0.5 * scale * z}};
      const auto contacts = contacts_of(cylinder, pose, capsule, identity, 0);
      ASSERT_FALSE(contacts.empty());
      for (const abut_contact& contact : contacts) {
        const auto aside_along = [&](double abut_vec3::* axis) {
          return contact.point_b.*axis - contact.point_a.*axis - contact.distance * contact.normal.*axis;
        };
        const double aside =
            std::hypot(aside_along(&abut_vec3::x), aside_along(&abut_vec3::y), aside_along(&abut_vec3::z));
        const bool is_deepest = &contact == &contacts[0];
        EXPECT_LE(aside, is_deepest ? 1e-12 : 1e-3) << angle << " " << i;
        most_nearly = std::max(most_nearly, aside);
      }
    }
  }
  EXPECT_GT(most_nearly, 1e-6);
}

TEST(Contacts, OfAPairAreAtMostFourByDefault) {
  const Shape block = make_box(1, 1, 1);
  for (const auto& [maximum, expected] : {std::pair{4U, 4U}, std::pair{2U, 2U}, std::pair{1U, 1U}, std::pair{0U, 8U}}) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.max_contacts = maximum;
    Universe universe(&options);
    universe.add(block, at(0, 0, 0));
    // Turned by an eighth about Z, so that the faces overlap in an octagon.
    universe.add(block, {{0, 0, 1.99}, {0.92387953251128674, 0, 0, 0.38268343236508978}});
    EXPECT_EQ(universe.step().size(), expected) << maximum;
  }
}

TEST(Contacts, KeepTheirIdsUnderSmallMotion) {
  const Shape block = make_box(1, 1, 1);
  const Shape floor = make_box(10, 10, 1);
  Universe universe;
  universe.add(floor, at(0, 0, -1), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(0, 0, 0.999));
  universe.add_geometry(part, block);
  const auto ids_of = [](const std::vector<abut_contact>& contacts) {
    std::set<std::uint64_t> ids;
    for (const abut_contact& contact : contacts) ids.insert(contact.id);
    return ids;
  };
  const auto first = ids_of(universe.step());
  ASSERT_EQ(first.size(), 4U);
  for (int i = 1; i <= 20; ++i) {
    const abut_pose pose = at(0.001 * i, 0.0005 * i, 0.999 - 0.00001 * i);
    ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
    EXPECT_EQ(ids_of(universe.step()), first) << "step " << i;
  }
}

TEST(Contacts, AreEmptyBeforeTheFirstStep) {
  const Shape ball = make_sphere(1);
  Universe universe;
  universe.add(ball, identity);
  universe.add(ball, identity);
  EXPECT_TRUE(universe.contacts().empty());
}

TEST(Contacts, StayThroughConstCalls) {
  const Scene scene;
  const abut_contact* before = nullptr;
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_contacts(scene.universe, &before, &count)));
  const double distance = before->distance;
  abut_pose pose{};
  ASSERT_TRUE(succeeded(abut_part_pose(scene.universe, scene.part, &pose)));
  std::size_t needed = 0;
  ASSERT_TRUE(succeeded(abut_universe_explain(scene.universe, nullptr, 0, &needed)));
  const abut_contact* after = nullptr;
  ASSERT_TRUE(succeeded(abut_universe_contacts(scene.universe, &after, &count)));
  EXPECT_EQ(before, after);
  EXPECT_EQ(before->distance, distance);
}

TEST(Contacts, TakeNewPosesOnlyAtTheNextStep) {
  const Scene scene;
  const auto before = scene.universe.contacts();
  const abut_pose far_away = at(100, 0, 0);
  ASSERT_TRUE(succeeded(abut_part_set_pose(scene.universe, scene.part, &far_away)));
  ASSERT_TRUE(succeeded(abut_universe_step(scene.universe, 0.0)));
  EXPECT_FALSE(before.empty());
  EXPECT_TRUE(scene.universe.contacts().empty());
}

TEST(Contacts, StepMovesNothing) {
  const Scene scene;
  abut_pose before{};
  abut_pose after{};
  ASSERT_TRUE(succeeded(abut_part_pose(scene.universe, scene.part, &before)));
  for (const double dt : {0.0, 1e-300, 0.01, 1e300}) ASSERT_TRUE(succeeded(abut_universe_step(scene.universe, dt)));
  ASSERT_TRUE(succeeded(abut_part_pose(scene.universe, scene.part, &after)));
  EXPECT_EQ(before.position.x, after.position.x);
}

TEST(Contacts, OfAPairSwapWithItsShapes) {
  const auto shapes = make_one_of_each_kind();
  const abut_pose other{{0.3, 0.2, 0.4}, {0.9, 0.3, 0.1, std::sqrt(1 - 0.81 - 0.09 - 0.01)}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      abut_distance ab{};
      abut_distance ba{};
      const abut_status status = abut_pair_distance(shapes.at(i), &identity, shapes.at(j), &other, nullptr, &ab);
      ASSERT_EQ(abut_pair_distance(shapes.at(j), &other, shapes.at(i), &identity, nullptr, &ba), status);
      if (status == ABUT_UNSUPPORTED) continue;
      ASSERT_EQ(status, abut_status{ABUT_OK});
      EXPECT_NEAR(ab.distance, ba.distance, 1e-9) << i << " against " << j;
      std::size_t count_ab = 0;
      std::size_t count_ba = 0;
      ASSERT_EQ(abut_pair_contacts(shapes.at(i), &identity, shapes.at(j), &other, nullptr, nullptr, 0, &count_ab),
                abut_status{ABUT_OK});
      ASSERT_EQ(abut_pair_contacts(shapes.at(j), &other, shapes.at(i), &identity, nullptr, nullptr, 0, &count_ba),
                abut_status{ABUT_OK});
      EXPECT_EQ(count_ab, count_ba) << i << " against " << j;
    }
  }
}

// A sphere of triangles, which faces every way.
Shape make_globe() {
  constexpr std::uint32_t around = 16;
  constexpr std::uint32_t up = 8;
  std::vector<double> reals;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t j = 0; j <= up; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double polar = 3.14159265358979 * j / up;
      const double turn = 2 * 3.14159265358979 * i / around;
      reals.insert(reals.end(), {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
      const std::uint32_t next = (i + 1) % around;
      const std::uint32_t row = j * around;
      if (j < up) indices.insert(indices.end(), {row + i, row + around + i, row + next});
      if (j < up) indices.insert(indices.end(), {row + next, row + around + i, row + around + next});
    }
  }
  return make_of_kind("mesh", {0}, reals, indices);
}

double least_distance(const std::vector<abut_contact>& contacts) {
  double least = HUGE_VAL;
  for (const abut_contact& contact : contacts) least = std::min(least, contact.distance);
  return least;
}

TEST(Contacts, OfOnePairAreCapped) {
  const Shape globe = make_globe();
  const Shape ball = make_sphere(1);
  const std::vector<abut_contact> all = contacts_of(globe, identity, ball, identity);
  ASSERT_GT(all.size(), 50U);

  abut_query_options options = filled_by(abut_query_options_init);
  options.max_pair_contacts = 8;
  std::vector<abut_contact> some(all.size());
  std::size_t count = 0;
  ASSERT_TRUE(
      succeeded(abut_pair_contacts(globe, &identity, ball, &identity, &options, some.data(), some.size(), &count)));
  EXPECT_EQ(count, 8U);
  some.resize(count);
  EXPECT_EQ(least_distance(some), least_distance(all));

  abut_universe_options of_universe = default_universe_options();
  of_universe.max_pair_contacts = 8;
  Universe universe(&of_universe);
  universe.add(globe, identity);
  universe.add(ball, identity);
  const std::vector<abut_contact> stepped = universe.step();
  EXPECT_EQ(stepped.size(), 8U);
  EXPECT_EQ(least_distance(stepped), least_distance(all));
}

}  // namespace
