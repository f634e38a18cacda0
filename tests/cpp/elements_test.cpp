// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace {

const std::vector<double> square{-1, -1, 0, 2, -1, 0, -1, 2, 0}, tip{0, 0, 1, 0.2, 0, 2, 0, 0.2, 2},
    tip_below{0, 0, -0.5, 0.2, 0, 0.5, 0, 0.2, 0.5};

abut::Elements elements_of(const std::vector<double>& xyz) {
  return abut::Elements::of(abut::Shape::mesh(xyz, {{0, 1, 2}}));
}

TEST(Elements, TellWhatIsNearAndWhatTouches) {
  abut::Elements a = elements_of(tip), b = elements_of(square);
  EXPECT_EQ(a.count().faces, 1U);
  EXPECT_EQ(a.edges().size(), 3U);
  const auto near = abut::ElementsOptions().with_reach(1).with_method(ABUT_CLOSEST_ALL);
  const std::vector<abut::Stencil> closest = a.closest(b, near);
  ASSERT_EQ(closest.size(), 1U);
  EXPECT_EQ(closest[0].distance, 1);
  EXPECT_TRUE(a.closest(near).empty());
  EXPECT_EQ(a.candidates(b, near).size(), 8U);
  EXPECT_TRUE(a.candidates(near).empty());

  a.set_vertices(tip, tip_below);
  const std::vector<abut::Stencil> touches = a.first_touches(b);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_NEAR(touches[0].toi, 2.0 / 3, 1e-9);
  EXPECT_TRUE(a.first_touches().empty());
  EXPECT_TRUE(a.crossings(b).empty());
  a.set_vertices(tip_below);
  EXPECT_EQ(a.crossings(b).size(), 2U);
  EXPECT_TRUE(a.crossings().empty());
}

// More than a list has room for at first.
TEST(Elements, AnswerLongLists) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < 50; ++i) {
    for (std::uint32_t j = 0; j < 50; ++j) {
      xyz.insert(xyz.end(), {double(i), double(j), 0});
      if (i < 49 && j < 49) {
        const std::uint32_t k = 50 * i + j;
        triangles.insert(triangles.end(), {k, k + 50, k + 51, k, k + 51, k + 1});
      }
    }
  }
  abut::Elements folded = abut::Elements::of(abut::Shape::mesh(xyz, triangles));
  EXPECT_EQ(folded.edges().size(), 7301U);
  const auto near = abut::ElementsOptions().with_reach(1.5);
  const std::vector<abut::Stencil> closest = folded.closest(near);
  EXPECT_GT(closest.size(), 1024U);
  EXPECT_EQ(folded.closest(near).size(), closest.size());
}

TEST(Elements, RefuseWhatIsWrong) {
  abut::Elements none, a = elements_of(tip);
  EXPECT_THROW(static_cast<void>(none.count()), abut::Error);
  EXPECT_THROW(static_cast<void>(abut::Elements::of(abut::Shape::sphere(1))), abut::Error);
  EXPECT_THROW(a.set_vertices(std::vector<double>(6)), abut::Error);
  EXPECT_THROW(a.set_vertices(tip, std::vector<double>(6)), abut::Error);
  EXPECT_THROW(static_cast<void>(a.closest(abut::ElementsOptions().with_reach(-1))), abut::Error);
}

TEST(Elements, AreToldByAUniverse) {
  abut::Universe universe = abut::Universe::create(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN));
  universe.set_policy(0, 0,
                      abut::Policy()
                          .with_detail(ABUT_DETAIL_ELEMENTS)
                          .with_tolerance(1.5)
                          .with_contact_distance(0.25)
                          .with_method(ABUT_CLOSEST_OF_VERTICES)
                          .with_kinds(1U << ABUT_STENCIL_VERTEX_FACE)
                          .with_flags(ABUT_ELEMENTS_FRONTS_ONLY)
                          .with_rest_distance(0.5)
                          .with_cone_angle(0.125)
                          .with_cone_factor(1));
  const abut::Policy policy = universe.policy(0, 0);
  EXPECT_EQ(policy.method, abut_closest_method{ABUT_CLOSEST_OF_VERTICES});
  EXPECT_EQ(policy.kinds, 1U);
  EXPECT_EQ(policy.flags, abut_elements_flags{ABUT_ELEMENTS_FRONTS_ONLY});
  EXPECT_EQ(policy.rest_distance, 0.5);
  EXPECT_EQ(policy.cone_angle, 0.125);
  EXPECT_EQ(policy.cone_factor, 1);
  for (const auto* const xyz : {&square, &tip}) {
    universe.create_geometry(universe.create_part(), abut::Shape::mesh(*xyz, {{0, 1, 2}}));
  }
  universe.step(0);
  const abut::Span<const abut::ElementContact> contacts = universe.element_contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].stencil.distance, 1);
  EXPECT_EQ(contacts[0].gap, 0.75);
  EXPECT_TRUE(universe.contacts().empty());
}

TEST(Elements, MoveToVerticesThatAUniverseLends) {
  abut::Universe universe = abut::Universe::create(
      abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN).with_events(ABUT_EVENTS_ELEMENTS));
  universe.set_policy(0, 0, abut::Policy().with_detail(ABUT_DETAIL_ELEMENTS));
  universe.create_geometry(universe.create_part(), abut::Shape::mesh(square, {{0, 1, 2}}));
  const abut::GeometryId moving = universe.create_geometry(universe.create_part(), abut::Shape::mesh(tip, {{0, 1, 2}}),
                                                           abut::GeometryOptions().with_flags(ABUT_GEOMETRY_FAST));
  universe.step(0.01);
  const std::vector<double> before(tip.begin(), tip.end());
  const abut::Span<double> next = universe.next_vertices(moving);
  ASSERT_EQ(next.size(), before.size());
  for (std::size_t i = 2; i < next.size(); i += 3) next[i] -= 1.5;
  universe.step(0.01);
  ASSERT_EQ(universe.element_contacts().size(), 1U);
  EXPECT_EQ(universe.element_contacts()[0].age, 0U);
  ASSERT_EQ(universe.events().size(), 1U);
  EXPECT_EQ(universe.events()[0].flags, abut_event_flags{ABUT_EVENT_ELEMENTS});
  universe.advance(moving);
  const abut::Span<const double> now = universe.vertices(moving);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(now[i], before[i] - (i % 3 == 2 ? 1.5 : 0));
  EXPECT_EQ(universe.next_vertices(moving)[2], before[2]);
  universe.advance(std::vector<abut::GeometryId>{moving});
  EXPECT_EQ(universe.vertices(moving)[2], before[2]);
  EXPECT_THROW(universe.advance(moving), abut::Error);
}

}  // namespace
