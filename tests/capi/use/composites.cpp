// SPDX-License-Identifier: Apache-2.0
// Composites: several shapes as one.
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "hollow_bodies.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;

abut_pose turned(double x, double y, double z, double angle) {
  return {{x, y, z}, {std::cos(0.5 * angle), 0.6 * std::sin(0.5 * angle), 0, 0.8 * std::sin(0.5 * angle)}};
}

// A row of boxes, each turned a little; more of them than are looked at without a tree.
struct Row {
  explicit Row(int count) {
    for (int i = 0; i < count; ++i) {
      boxes.push_back(make_box(0.4, 0.3 + 0.01 * i, 0.2));
      children.push_back(boxes.back());
      poses.push_back(turned(1.1 * i, 0.1 * (i % 3), 0.05 * i, 0.2 * i));
    }
    whole = make_composite(children, poses);
  }
  std::vector<Shape> boxes;
  std::vector<const abut_shape*> children;
  std::vector<abut_pose> poses;
  Shape whole;
};

TEST(Composite, MeetsAsItsChildrenDo) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  for (const int count : {1, 3, 8, 9, 20}) {
    const Row row(count);
    for (int i = 0; i < 200; ++i) {
      const abut_pose pose =
          turned(0.55 * count * (1 + place(random)), place(random), place(random), 3 * place(random));
      const Shape other = i % 2 == 0 ? make_sphere(0.5) : make_box(0.3, 0.8, 0.2);
      double least = std::numeric_limits<double>::infinity();
      std::size_t contacts = 0;
      for (std::size_t k = 0; k < row.children.size(); ++k) {
        least = std::min(least, distance_of(row.children[k], row.poses[k], other, pose));
        contacts += contacts_of(row.children[k], row.poses[k], other, pose, 0.01).size();
      }
      EXPECT_NEAR(distance_of(row.whole, identity, other, pose), least, 1e-12);
      EXPECT_EQ(contacts_of(row.whole, identity, other, pose, 0.01).size(), contacts);
    }
  }
}

// Walls and floors have numbers behind those of the grid, and so have the triangles of the child that comes next.
TEST(Composite, OfASolidFieldAndASolidMeshIsTheSameInEitherOrder) {
  const Shape field = make_of_kind("height_field", {4, 4, 1, 1, 0, 1}, std::vector<double>(16, 0.0), {});
  const Shape mesh = make_of_kind("mesh", {2}, {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1,  //
                                                -1, -1, 1,  1, -1, 1,  1, 1, 1,  -1, 1, 1},
                                  {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,  //
                                   1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7});
  const abut_pose beside = at(1, -1.5, 0);
  const Shape field_first = make_composite(std::vector<const abut_shape*>{field, mesh}, {identity, beside});
  const Shape mesh_first = make_composite(std::vector<const abut_shape*>{mesh, field}, {beside, identity});
  const Shape ball = make_sphere(0.5);
  EXPECT_NEAR(distance_of(field_first, identity, ball, at(-0.4, 2, -1)), -0.1, 1e-12);   // a wall
  EXPECT_NEAR(distance_of(field_first, identity, ball, at(2.6, 2, -3.3)), -0.2, 1e-12);  // the floor
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> x(-0.5, 3.5), y(-3, 3.5), z(-3.5, 1.5);
  int deep = 0;
  for (int i = 0; i < 200; ++i) {
    const abut_pose pose = at(x(random), y(random), z(random));
    const double distance = distance_of(mesh_first, identity, ball, pose);
    EXPECT_NEAR(distance_of(field_first, identity, ball, pose), distance, 1e-9);
    auto contacts = contacts_of(field_first, identity, ball, pose, 0.01);
    EXPECT_EQ(contacts.size(), contacts_of(mesh_first, identity, ball, pose, 0.01).size());
    for (const abut_contact& contact : contacts) EXPECT_LT(contact.child_a, 2U);
    deep += distance < -0.5 ? 1 : 0;
  }
  EXPECT_GT(deep, 40);
}

TEST(Composite, ReportsTheMaterialsOfItsChildren) {
  const Shape ball = make_sphere(0.5);
  const std::array<const abut_shape*, 3> children{ball, ball, ball};
  const std::array<abut_pose, 3> poses{at(0, 0, 0), at(3, 0, 0), at(6, 0, 0)};
  constexpr std::array<std::uint32_t, 3> materials{7, 0, 9};
  abut_shape* made = nullptr;
  require(abut_composite_create_with_materials(children.data(), poses.data(), materials.data(), 3, &made));
  const Shape row(made);
  // What has a material keeps it within another composite, what has none takes that of the composite.
  const std::array<const abut_shape*, 1> inner{row};
  constexpr std::array<std::uint32_t, 1> outer{5};
  require(abut_composite_create_with_materials(inner.data(), &identity, outer.data(), 1, &made));
  const Shape nested(made);
  for (const auto& [shape, expected] :
       {std::pair<const abut_shape*, std::array<std::uint32_t, 3>>{row, {7, 0, 9}},
        std::pair<const abut_shape*, std::array<std::uint32_t, 3>>{nested, {7, 5, 9}}}) {
    Universe universe;
    (void)universe.add(shape, identity);
    for (const abut_pose& pose : poses) {
      (void)universe.add(ball, at(pose.position.x, 0, 0.9));
    }
    const auto contacts = universe.step();
    ASSERT_EQ(contacts.size(), 3U);
    for (const abut_contact& contact : contacts) {
      EXPECT_EQ(contact.material_a, expected.at(contact.child_a));
      EXPECT_EQ(contact.material_b, 0U);
    }
  }
}

TEST(Composite, NamesTheChildrenThatTouch) {
  const Row row(12);
  const Shape probe = make_sphere(0.3);
  for (std::size_t k = 0; k < row.children.size(); ++k) {
    const auto found = contacts_of(probe, at(row.poses[k].position.x, row.poses[k].position.y, row.poses[k].position.z),
                                   row.whole, identity);
    ASSERT_FALSE(found.empty());
    bool is_named = false;
    for (const abut_contact& contact : found) {
      EXPECT_EQ(contact.child_a, 0U);
      is_named = is_named || contact.child_b == k;
    }
    EXPECT_TRUE(is_named) << k;
  }
}

TEST(Composite, CountsTheChildrenOfChildrenDepthFirst) {
  const Shape ball = make_sphere(0.1);
  const Shape pair = make_composite({ball, ball}, {at(0, 0, 0), at(1, 0, 0)});
  const Shape whole = make_composite({ball, pair, ball}, {at(0, 5, 0), at(10, 0, 0), at(0, 7, 0)});
  const std::vector<abut_pose> places{at(0, 5, 0), at(10, 0, 0), at(11, 0, 0), at(0, 7, 0)};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto found = contacts_of(whole, identity, ball, places[k]);
    ASSERT_EQ(found.size(), 1U) << k;
    EXPECT_EQ(found[0].child_a, k);
  }
}

TEST(Composite, IdsDifferFromChildToChild) {
  const Row row(20);
  const Shape plane = make_plane({0, 0, 1}, 10);
  std::set<std::uint64_t> ids;
  const auto found = contacts_of(row.whole, identity, plane, identity);
  for (const abut_contact& contact : found) ids.insert(contact.id);
  EXPECT_EQ(ids.size(), found.size());
  EXPECT_GE(found.size(), 60U);
}

TEST(Composite, MeetsCompositesAndParticles) {
  const Row row(9);
  const Shape dust = make_of_kind("particles", {0.05}, {0, 0, 0, 1.1, 0.1, 0.05, 50, 0, 0});
  const auto found = contacts_of(row.whole, identity, dust, identity);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].child_b + found[1].child_b, 1U);
  const Row other(3);
  EXPECT_LT(distance_of(row.whole, identity, other.whole, at(0.2, 0, 0)), 0);
  EXPECT_NEAR(distance_of(row.whole, identity, other.whole, at(0, 0, 100)),
              distance_of(other.whole, identity, row.whole, at(0, 0, -100)), 1e-12);
}

TEST(Composite, IsOneEntryOfTheBroadPhase) {
  const Row row(9);
  Universe universe;
  universe.add(row.whole, identity);
  const Shape probe = make_sphere(0.3);
  universe.add(probe, at(0, 0, 0));
  const auto contacts = universe.step();
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof(stats));
  ASSERT_TRUE(succeeded(abut_universe_stats(universe, &stats)));
  EXPECT_EQ(stats.geometries, 2U);
  EXPECT_EQ(stats.candidate_pairs, 1U);
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts[0].child_a, 0U);
}

TEST(Composite, OfTerrainAndSolidsMeetsWhatItCan) {
  const Shape plane = make_plane({0, 0, 1}, 0);
  const Shape ball = make_sphere(1);
  const Shape whole = make_composite({plane, ball}, {identity, at(0, 0, 3)});
  EXPECT_NEAR(distance_of(whole, identity, ball, at(5, 0, 2)), 1, 1e-12);
  EXPECT_NEAR(distance_of(whole, identity, plane, at(0, 0, -5)), 7, 1e-12)
      << "planes do not meet planes, the ball does";
  const Shape planes = make_composite({plane}, {identity});
  abut_distance found{};
  EXPECT_TRUE(refused(abut_pair_distance(planes, &identity, plane, &identity, nullptr, &found), ABUT_UNSUPPORTED,
                      {"composite", "plane"}));
}

TEST(Composite, IsMetByRays) {
  const Row row(20);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-1, 1);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const abut_ray ray{{11 + 11 * place(random), 2 * place(random), 5}, {place(random), 0.3 * place(random), -1}, 20};
    double nearest = std::numeric_limits<double>::infinity();
    abut_ray_hit hit{};
    std::uint32_t found = 0;
    for (std::size_t k = 0; k < row.children.size(); ++k) {
      ASSERT_TRUE(succeeded(abut_shape_cast_ray(row.children[k], &row.poses[k], &ray, &hit, &found)));
      if (found != 0) nearest = std::min(nearest, hit.distance);
    }
    ASSERT_TRUE(succeeded(abut_shape_cast_ray(row.whole, &identity, &ray, &hit, &found)));
    EXPECT_EQ(found != 0, std::isfinite(nearest));
    if (found != 0) {
      EXPECT_NEAR(hit.distance, nearest, 1e-12);
      ++hits;
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(Composite, ComesFromNumbersToo) {
  const std::uint32_t sphere = abut_shape_kind_by_name("sphere"), box = abut_shape_kind_by_name("box");
  const Shape whole = make_of_kind("composite", {}, {0, 0, 0, 1, 0, 0, 0, 0.5, 3, 0, 0, 2, 0, 0, 0, 1, 1, 1},
                                   {sphere, 1, 0, 0, box, 3, 0, 0});
  const Shape probe = make_sphere(0.25);
  EXPECT_NEAR(distance_of(whole, identity, probe, at(-1, 0, 0)), 0.25, 1e-12);
  EXPECT_NEAR(distance_of(whole, identity, probe, at(3, 0, 2)), 0.75, 1e-12);
}

TEST(Composite, NumbersThatDoNotAddUpAreRefusedByName) {
  const std::uint32_t sphere = abut_shape_kind_by_name("sphere");
  const auto refuses = [](const std::vector<double>& reals, const std::vector<std::uint32_t>& indices,
                          abut_status status, std::initializer_list<std::string_view> words) {
    expect_kind_refused("composite", {}, reals, indices, status, words);
  };
  const std::vector<double> ball{0, 0, 0, 1, 0, 0, 0, 0.5};
  refuses({}, {}, ABUT_EMPTY, {"count"});
  refuses(ball, {sphere, 1}, ABUT_INVALID_ARGUMENT, {"child 0", "indices end"});
  refuses(ball, {sphere, 2, 0, 0}, ABUT_INVALID_ARGUMENT, {"child 0", "reals end"});
  refuses(ball, {sphere, 1, 0, 4}, ABUT_INVALID_ARGUMENT, {"child 0", "indices end"});
  refuses({0, 0, 0, 1, 0, 0, 0, 0.5, 7}, {sphere, 1, 0, 0}, ABUT_INVALID_ARGUMENT, {"real_count"});
  refuses({0, 0, 0, 0, 0, 0, 0, 0.5}, {sphere, 1, 0, 0}, ABUT_ZERO_VECTOR, {"child 0", "orientation"});
  refuses({0, 0, 0, 1, 0, 0, 0, -0.5}, {sphere, 1, 0, 0}, ABUT_OUT_OF_RANGE, {"child 0", "radius", "-0.5"});
  refuses(ball, {60001, 1, 0, 0}, ABUT_UNKNOWN_VALUE, {"child 0", "kind", "60001"});
  refuses({std::numeric_limits<double>::quiet_NaN(), 0, 0, 1, 0, 0, 0, 0.5}, {sphere, 1, 0, 0}, ABUT_NOT_FINITE,
          {"child 0", "pose"});
}

TEST(Composite, TellsItsChildren) {
  const Shape ball = make_sphere(0.5), box = make_box(1, 2, 3), bore = cylinder_hole(0.25, 2, 3);
  const abut_pose aside = turned(1, 2, 3, 0.4);
  const std::array<const abut_shape*, 2> inner{box, bore};
  const std::array<abut_pose, 2> inner_poses{aside, identity};
  constexpr std::array<std::uint32_t, 2> inner_materials{7, 0}, outer_materials{3, 5};
  abut_shape* made = nullptr;
  require(abut_composite_create_with_materials(inner.data(), inner_poses.data(), inner_materials.data(), 2, &made));
  const Shape pierced(made);
  const std::array<const abut_shape*, 2> outer{ball, pierced};
  const std::array<abut_pose, 2> outer_poses{at(4, 0, 0), at(0, 1, 0)};
  require(abut_composite_create_with_materials(outer.data(), outer_poses.data(), outer_materials.data(), 2, &made));
  const Shape whole(made);
  std::size_t count = 0;
  require(abut_composite_children(whole, nullptr, 0, &count));
  ASSERT_EQ(count, 3U);
  std::array<abut_composite_child, 3> children{};
  require(abut_composite_children(whole, children.data(), children.size(), &count));
  constexpr std::array<std::uint32_t, 3> materials{3, 7, 5};
  const std::array<const char*, 3> kinds{"sphere", "box", "cylinder_hole"};
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(children.at(i).material, materials.at(i));
    EXPECT_EQ(children.at(i).is_hole, i == 2 ? 1U : 0U);
    require(abut_composite_child_shape(whole, i, &made));
    const Shape child(made);
    EXPECT_STREQ(abut_shape_kind_name(abut_shape_kind_of(child)), kinds.at(i));
  }
  EXPECT_EQ(children[2].cut_begin, 1U);
  EXPECT_EQ(children[2].cut_end, 3U);
  EXPECT_EQ(children[0].pose.position.x, 4);
  EXPECT_EQ(children[1].pose.position.y, 3);
  EXPECT_NEAR(children[1].pose.orientation.w, aside.orientation.w, 1e-15);
  EXPECT_NEAR(children[1].pose.orientation.x, aside.orientation.x, 1e-15);
  EXPECT_NEAR(children[1].pose.orientation.z, aside.orientation.z, 1e-15);
}

TEST(Composite, HasChildrenAloneAndAsManyAsThereAre) {
  const Shape ball = make_sphere(0.5), row = make_composite({ball, ball}, {at(0, 0, 0), at(3, 0, 0)});
  std::size_t count = 9;
  abut_shape* made = nullptr;
  EXPECT_EQ(abut_composite_children(ball, nullptr, 0, &count), ABUT_UNSUPPORTED);
  EXPECT_STREQ(abut_last_error_message(), "shape is a sphere; only a composite has children");
  EXPECT_EQ(abut_composite_child_shape(ball, 0, &made), ABUT_UNSUPPORTED);
  EXPECT_EQ(abut_composite_child_shape(row, 2, &made), ABUT_INDEX_OUT_OF_RANGE);
  EXPECT_STREQ(abut_last_error_message(), "child is 2; it must be below 2, the number of children");
  EXPECT_EQ(count, 9U);
  EXPECT_EQ(made, nullptr);
}

}  // namespace
