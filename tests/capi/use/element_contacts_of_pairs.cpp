// SPDX-License-Identifier: Apache-2.0
// Which pairs have element contacts, by which numbers, and from when on: cases that a wrong filter or a buffer of the
// step before would change.
#include "element_contacts.hpp"

namespace {

using namespace abut_test;

bool has(const std::vector<abut_element_contact>& contacts, abut_stencil_kind kind, std::uint32_t of_a,
         std::uint32_t element_a, std::uint32_t element_b) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const abut_element_contact& its) {
    return its.stencil.kind == kind && its.stencil.of_a == of_a && its.stencil.element_a == element_a &&
           its.stencil.element_b == element_b;
  });
}
void expect_different_ids(const std::vector<abut_element_contact>& contacts) {
  std::set<std::uint64_t> ids;
  for (const abut_element_contact& its : contacts) EXPECT_TRUE(ids.insert(its.id).second) << its.id;
}

// Two triangles point at each other: vertex 0 of each lies at face 0 of the other one.
TEST(ElementContactsOfPairs, IdsTellWhoseTheVertexIs) {
  Cloths cloths(elements_policy(0.125));
  cloths.add({{1, 0, 0, -2, 1, 0, -2, -1, 0}, {0, 1, 2}});
  cloths.add({{-1, 0, 0.1, 2, 1, 0.1, 2, -1, 0.1}, {0, 1, 2}});
  cloths.step();
  const auto found = cloths.contacts();
  EXPECT_TRUE(has(found, ABUT_STENCIL_VERTEX_FACE, 1, 0, 0));
  EXPECT_TRUE(has(found, ABUT_STENCIL_VERTEX_FACE, 3, 0, 0));
  expect_different_ids(found);
}

// A vertex between face 0 above it and edge 0, the upper one of a face that hangs down, below it.
TEST(ElementContactsOfPairs, IdsTellEdgesFromFaces) {
  Cloths cloths(elements_policy(0.125));
  cloths.add({{0, 0, 0, 0.5, 4, 0, -0.5, 4, 0}, {0, 1, 2}});
  cloths.add({{-1, 0, -0.1, 1, 0, -0.1, 0, 0, -2, -1, -1, 0.1, 2, -1, 0.1, -1, 2, 0.1}, {3, 4, 5, 0, 1, 2}});
  cloths.step();
  const auto found = cloths.contacts();
  EXPECT_TRUE(has(found, ABUT_STENCIL_VERTEX_FACE, 1, 0, 0));
  EXPECT_TRUE(has(found, ABUT_STENCIL_VERTEX_EDGE, 1, 0, 0));
  expect_different_ids(found);
}

// Folds, and the same sheet drawn out so that nothing of it is near itself.
struct Folds {
  static constexpr double reach = 0.08;
  Surface folded, wide;
  abut_policy policy = elements_policy(reach);
  Folds() {
    std::mt19937 random(1);
    wide = folded = folded_surface(10, 0.01, random);
    for (std::size_t i = 0; i < wide.xyz.size(); i += 3) wide.xyz[i] *= 40;
    policy.rest_distance = 2 * reach;
  }
};

TEST(ElementContactsOfPairs, AnotherShapeRestsWhereItIs) {
  const Folds folds;
  Cloths cloths(folds.policy);
  cloths.add(folds.wide, ABUT_GEOMETRY_SELF_PAIRS);
  cloths.step();
  cloths.move(0, folds.folded.xyz);
  cloths.step();
  EXPECT_FALSE(cloths.contacts().empty()) << "it has come near itself";
  require(abut_geometry_set_shape(cloths.universe(), cloths.geometry(0), shape_of(folds.folded)));
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty()) << "it rests near itself";
}

TEST(ElementContactsOfPairs, AGeometryInTheSameSlotRestsWhereItIs) {
  const Folds folds;
  Cloths cloths(folds.policy);
  cloths.add(folds.wide, ABUT_GEOMETRY_SELF_PAIRS);
  cloths.step();
  require(abut_geometry_destroy(cloths.universe(), cloths.geometry(0)));
  cloths.add(folds.folded, ABUT_GEOMETRY_SELF_PAIRS);
  EXPECT_EQ(cloths.geometry(0).slot, cloths.geometry(1).slot);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
}

// The rest shape is that of the first detection with the policy, also where nothing is near then.
TEST(ElementContactsOfPairs, RestIsSeenWhenThePolicyComes) {
  const Folds folds;
  abut_policy manifold = default_policy();
  Cloths cloths(manifold);
  cloths.add(folds.wide, ABUT_GEOMETRY_SELF_PAIRS);
  cloths.step();
  cloths.set_policy(folds.policy);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.move(0, folds.folded.xyz);
  cloths.step();
  EXPECT_FALSE(cloths.contacts().empty());
}

// Boxes overlap, and nothing is within reach: no contact, and no event.
TEST(ElementContactsOfPairs, DoNotTouchBeyondTheirReach) {
  Cloths cloths(elements_policy(0.25));
  cloths.add(ground);
  cloths.add(tip_at(1.5, 1.5, 0.125));
  cloths.step();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 1U);
  EXPECT_EQ(cloths.universe().stats().touching_pairs, 0U);
  EXPECT_TRUE(cloths.universe().events().empty());
}

// A pair that ends takes its contacts along, also where a detection elsewhere sees another pair come in its place.
TEST(ElementContactsOfPairs, EndWhereAnotherPairBegins) {
  Cloths cloths(elements_policy(0.25));
  cloths.add(ground);
  cloths.add(tip_at(0, 0, 0.125));
  cloths.add(shifted(ground, 9, 0, 0));
  cloths.step();
  EXPECT_EQ(cloths.stencils(0, 1).size(), 1U);
  cloths.universe().move(cloths.part(1), at(9, 0, 0));
  const abut_aabb elsewhere{{-9, -9, -9}, {-8, -8, -8}};
  require(abut_universe_detect_region(cloths.universe(), &elsewhere));
  EXPECT_TRUE(cloths.stencils(0, 1).empty());
  EXPECT_TRUE(cloths.stencils(1, 2).empty()) << "not examined yet";
  cloths.step();
  EXPECT_TRUE(cloths.stencils(0, 1).empty());
  EXPECT_EQ(cloths.stencils(1, 2).size(), 1U);
}

// Nor does a geometry in the slot of another one take over contacts, before a detection has looked at it.
TEST(ElementContactsOfPairs, EndWithTheirGeometry) {
  Cloths cloths(elements_policy(0.25));
  cloths.add(ground);
  cloths.add(tip_at(0, 0, 0.125));
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 1U);
  require(abut_geometry_destroy(cloths.universe(), cloths.geometry(1)));
  cloths.add(tip_at(0, 0, 0.125));
  EXPECT_EQ(cloths.geometry(1).slot, cloths.geometry(2).slot);
  const abut_aabb elsewhere{{-9, -9, -9}, {-8, -8, -8}};
  require(abut_universe_detect_region(cloths.universe(), &elsewhere));
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.step();
  EXPECT_EQ(cloths.stencils(0, 2).size(), 1U);
}

// Sixth powers of coordinates beyond 1e50 are no numbers.
TEST(ElementContactsOfPairs, FarAwayAreNone) {
  Cloths cloths(elements_policy(0.25));
  for (int i = 0; i < 2; ++i) cloths.add(shifted(ground, 0, 0, 1e60));
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  for (std::size_t which = 0; which < 2; ++which) cloths.move(which, ground.xyz);
  cloths.step();
  EXPECT_FALSE(cloths.contacts().empty());
}

}  // namespace
