// SPDX-License-Identifier: Apache-2.0
// Steps that look ahead: fast geometries on the way to the vertices that they have lent.
#include "element_contacts.hpp"
#include "moving.hpp"

namespace {

using namespace abut_test;

Touches touches_of(const std::vector<abut_stencil>& stencils) {
  Touches out;
  for (const abut_stencil& its : stencils) {
    EXPECT_TRUE(out.insert({its.kind, its.of_a, its.element_a, its.element_b}).second) << "told twice";
  }
  return out;
}

void lend(Cloths& cloths, std::size_t which, const std::vector<double>& xyz) {
  double* next = nullptr;
  std::size_t count = 0;
  require(abut_geometry_next_vertices(cloths.universe(), cloths.geometry(which), &next, &count));
  ASSERT_EQ(3 * count, xyz.size());
  std::copy(xyz.begin(), xyz.end(), next);
}
void advance(Cloths& cloths, std::size_t which) {
  require(abut_geometry_advance(cloths.universe(), cloths.geometry(which)));
}

TEST(ElementContactsAhead, AreThoseOfAllPairs) {
  ABUT_NEEDS_MOTION();
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Surface a = folded_surface(8, 0.01, random), b = folded_surface(7, 0.01, random);
    for (std::size_t i = 0; i < b.xyz.size(); i += 3) b.xyz[i] += 0.03;
    Cloths cloths(elements_policy(0));
    cloths.add(a, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
    cloths.add(b, seed == 1 ? ABUT_GEOMETRY_FAST : 0);
    cloths.step();
    Surface b_before = b;
    for (int frame = 0; frame < 3; ++frame) {
      const std::vector<double> end_a = moved(a, 0.05, random), end_b = moved(b, 0.05, random);
      lend(cloths, 0, end_a);
      lend(cloths, 1, end_b);
      for (int again = 0; again < 2; ++again) {
        cloths.step();
        // What is not fast looks back, to where it was before it advanced.
        const Surface& start_b = seed == 1 || again == 1 ? b : b_before;
        const Touches of_one = touches_of(cloths.stencils(0, 0)), of_two = touches_of(cloths.stencils(0, 1));
        EXPECT_EQ(of_one, touches_by_all_pairs(a, end_a, a, end_a, 0));
        EXPECT_EQ(of_two, touches_by_all_pairs(a, end_a, start_b, seed == 1 ? end_b : b.xyz, 0));
        EXPECT_GT(of_one.size(), 5U);
        EXPECT_GT(of_two.size(), 5U);
      }
      // Without time nothing looks ahead.
      require(abut_universe_detect_changed(cloths.universe()));
      EXPECT_TRUE(cloths.contacts().empty());
      advance(cloths, 0);
      advance(cloths, 1);
      a.xyz = end_a;
      b_before.xyz = std::exchange(b.xyz, end_b);
    }
  }
}

// Bit by bit what a step finds after the vertices were moved there.
TEST(ElementContactsAhead, AreThoseOfAStepThatLooksBack) {
  ABUT_NEEDS_MOTION();
  std::mt19937 random(3);
  Surface mesh = folded_surface(10, 0.01, random);
  const abut_pose pose{{3, 1, -2}, {0.8, 0, 0.6, 0}};
  Cloths ahead(elements_policy(0)), back(elements_policy(0));
  for (Cloths* its : {&ahead, &back}) {
    its->add(mesh, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST, pose);
    its->step();
  }
  for (int frame = 0; frame < 3; ++frame) {
    mesh.xyz = moved(mesh, 0.05, random);
    lend(ahead, 0, mesh.xyz);
    ahead.step();
    advance(ahead, 0);
    back.move(0, mesh.xyz);
    back.step();
    const auto found = ahead.contacts(), wanted = back.contacts();
    EXPECT_GT(wanted.size(), 10U);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].id, wanted[i].id);
      EXPECT_EQ(found[i].stencil.toi, wanted[i].stencil.toi);
      EXPECT_EQ(found[i].stencil.normal.x, wanted[i].stencil.normal.x);
    }
  }
}

const Surface tip = tip_at(0, 0, 1);

// So far that boxes overlap neither at the start nor at the end. The way ends where nothing is lent any more.
TEST(ElementContactsAhead, TellWhatPassesWithinAStep) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0.125));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  lend(cloths, 1, shifted(tip, 0, 0, -4).xyz);
  cloths.step();
  ASSERT_EQ(cloths.stencils(0, 1).size(), 3U) << "the corners of the tip";
  EXPECT_NEAR(cloths.stencils(0, 1)[0].toi, 0.25, 1e-9);
  EXPECT_EQ(letters_of(cloths.universe().events()), "b");
  // A solver changes its mind: it writes again, and looks again.
  lend(cloths, 1, shifted(tip, 0, 0, -0.5).xyz);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  EXPECT_EQ(letters_of(cloths.universe().events()), "e");
  advance(cloths, 1);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.step();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 0U);
}

// Lending alone, without a move, costs and tells nothing.
TEST(ElementContactsAhead, AreNoneWhereNothingIsWritten) {
  ABUT_NEEDS_MOTION();
  std::mt19937 random(4);
  const Surface mesh = folded_surface(8, 0.01, random);
  Cloths cloths(elements_policy(0));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
  cloths.step();
  lend(cloths, 0, mesh.xyz);
  cloths.step();
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 0U);
  EXPECT_TRUE(cloths.contacts().empty());
}

// What is wrong is refused by the step that would look at it, and by no other call.
TEST(ElementContactsAhead, RefuseNumbersThatAreNotFinite) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.add(ground);
  cloths.step();
  const std::uint64_t hash = cloths.universe().hash();
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
    std::vector<double> wrong = which == 0 ? tip.xyz : ground.xyz;
    wrong[7] = std::nan("");
    lend(cloths, which, wrong);
    if (which == 1) {
      cloths.step();
    } else {
      EXPECT_TRUE(refused(abut_universe_step(cloths.universe(), 0.01), ABUT_NOT_FINITE, {"slot 1", "next[7] is nan"}));
      require(abut_universe_detect_changed(cloths.universe()));
      EXPECT_EQ(cloths.universe().hash(), hash);
    }
    EXPECT_TRUE(refused(abut_geometry_advance(cloths.universe(), cloths.geometry(which)), ABUT_NOT_FINITE,
                        {"geometry", "next[7] is nan"}));
    lend(cloths, which, which == 0 ? tip.xyz : ground.xyz);
  }
}

abut_step_impact to_first_impact(abut_universe* universe, double dt = 1) {
  abut_step_impact out{};
  require(abut_universe_advance_to_first_impact(universe, dt, &out));
  return out;
}
std::vector<double> vertices_of(const Cloths& cloths, std::size_t which, const abut_universe* universe) {
  const double* xyz = nullptr;
  std::size_t count = 0;
  require(abut_geometry_vertices(universe, cloths.geometry(which), &xyz, &count));
  return {xyz, xyz + 3 * count};
}

// The first of several touches: all vertices that lead stop there, and the rest of the world.
TEST(ElementContactsAhead, HoldTheWorldUp) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0.125));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.add(tip_at(0.5, -0.5, 2), ABUT_GEOMETRY_FAST);
  cloths.add(tip_at(5, 5, 5));
  const abut_velocity falling{{0, 0, -4}, {0, 0, 0}};
  require(abut_part_set_velocity(cloths.universe(), cloths.part(3), &falling));
  lend(cloths, 1, shifted(tip, 0, 0, -4).xyz);
  lend(cloths, 2, shifted(tip_at(0.5, -0.5, 2), 0, 0, -4).xyz);
  const abut_step_impact first = to_first_impact(cloths.universe());
  EXPECT_TRUE(first.geometry_a == cloths.geometry(0) && first.geometry_b == cloths.geometry(1));
  EXPECT_NEAR(first.lower, 0.25, 1e-9);
  EXPECT_LE(first.lower, 0.25);
  const auto low = [&](std::size_t which) { return vertices_of(cloths, which, cloths.universe())[2]; };
  EXPECT_NEAR(low(1), 0, 1e-8);
  EXPECT_NEAR(low(2), 1, 1e-8);
  abut_pose pose{};
  require(abut_part_pose(cloths.universe(), cloths.part(3), &pose));
  EXPECT_NEAR(pose.position.z, -1, 1e-8);
  for (const std::size_t which : {std::size_t{1}, std::size_t{2}}) {
    EXPECT_TRUE(refused(abut_geometry_advance(cloths.universe(), cloths.geometry(which)), ABUT_INVALID_ARGUMENT,
                        {"lent no vertices"}))
        << "they have advanced";
  }
  // The one that has touched goes back; the other one is next.
  lend(cloths, 1, tip.xyz);
  lend(cloths, 2, shifted(tip_at(0.5, -0.5, 2), 0, 0, -3).xyz);
  const abut_step_impact second = to_first_impact(cloths.universe());
  EXPECT_NEAR(second.lower, 0.5, 1e-6);
}

// The ways of others count: what comes toward a sheet, what the sheet meets of itself, and what nobody looks at.
TEST(ElementContactsAhead, HoldTheWorldUpFromAllSides) {
  ABUT_NEEDS_MOTION();
  enum class Case : std::uint8_t {
    by_velocity,
    by_vertices,
    is_slow,
    is_sensor,
    is_parked,
    is_ruled_out,
    other_policy
  };
  for (const Case its : {Case::by_velocity, Case::by_vertices, Case::is_slow, Case::is_sensor, Case::is_parked,
                         Case::is_ruled_out, Case::other_policy}) {
    SCOPED_TRACE(testing::Message() << "case " << int(its));
    Cloths cloths(elements_policy(0));
    abut_geometry_options options = default_geometry_options();
    options.flags = its == Case::is_sensor ? ABUT_GEOMETRY_SENSOR : 0;
    options.tag = its == Case::other_policy ? 1 : 0;
    if (its == Case::by_vertices) options.flags = ABUT_GEOMETRY_FAST;
    cloths.add_on(cloths.universe().add_part(identity), ground, options);
    cloths.add(tip, its == Case::is_slow ? 0 : ABUT_GEOMETRY_FAST);
    if (its == Case::by_velocity) {
      const abut_velocity rising{{0, 0, 1}, {0, 0, 0}};
      require(abut_part_set_velocity(cloths.universe(), cloths.part(0), &rising));
    }
    if (its == Case::by_vertices) lend(cloths, 0, shifted(ground, 0, 0, 1).xyz);
    if (its == Case::is_parked) cloths.universe().park(cloths.geometry(0), ABUT_PARKING_SHORT_TERM);
    if (its == Case::is_ruled_out) {
      const abut_geometry_id id = cloths.geometry(0);
      const abut_collidable first{ABUT_COLLIDABLE_GEOMETRY, id.slot, id.generation};
      require(abut_rule_set(cloths.universe(), &first, &anything, ABUT_RULE_DISABLE));
    }
    lend(cloths, 1, shifted(tip, 0, 0, -3).xyz);
    const abut_step_impact first = to_first_impact(cloths.universe());
    const bool is_held = its == Case::by_velocity || its == Case::by_vertices;
    EXPECT_NEAR(first.lower, is_held ? 0.25 : 1, 1e-9);
    EXPECT_EQ(first.geometry_a.slot, is_held ? 1U : 0U);
    const double low = vertices_of(cloths, 1, cloths.universe())[2];
    EXPECT_NEAR(low, is_held ? 0.25 : its == Case::is_slow ? 1 : -2, 1e-8);
    if (!is_held && its != Case::is_slow) EXPECT_EQ(low, -2) << "exactly those that were written";
  }
}

// A ball that lands first stops the sheet as well.
TEST(ElementContactsAhead, AreHeldUpByBodiesThatTouchBefore) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  abut_geometry_options fast = default_geometry_options();
  fast.flags = ABUT_GEOMETRY_FAST;
  const abut_geometry_id floor = cloths.universe().add(make_box(1, 1, 1), at(50, 0, 0), ABUT_MOTION_STATIC);
  const abut_part_id body = cloths.universe().add_part(at(50, 0, 1.9));
  cloths.universe().add_geometry(body, make_sphere(0.5), fast);
  const abut_velocity falling{{0, 0, -4}, {0, 0, 0}};
  require(abut_part_set_velocity(cloths.universe(), body, &falling));
  lend(cloths, 1, shifted(tip, 0, 0, -4).xyz);
  const abut_step_impact first = to_first_impact(cloths.universe());
  EXPECT_TRUE(first.geometry_a == floor);
  EXPECT_NEAR(first.lower, 0.1, 1e-6);
  EXPECT_NEAR(vertices_of(cloths, 1, cloths.universe())[2], 0.6, 1e-5);
}

// What has moved since the last step with time still comes from there in the next one.
TEST(ElementContactsAhead, LookingForAnImpactForgetsNoWay) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.add(tip_at(9, 9, 9), ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.move(1, shifted(tip, 0, 0, -4).xyz);
  require(abut_universe_detect_changed(cloths.universe()));
  lend(cloths, 2, tip_at(9, 9, 8).xyz);
  EXPECT_EQ(to_first_impact(cloths.universe()).lower, 1);
  cloths.step();
  EXPECT_EQ(cloths.stencils(0, 1).size(), 3U) << "it passed the ground";
}

TEST(ElementContactsAhead, HoldASheetUpThatMeetsItself) {
  ABUT_NEEDS_MOTION();
  std::mt19937 random(5);
  const Surface mesh = folded_surface(10, 0.01, random);
  const std::vector<double> end = moved(mesh, 0.06, random);
  Cloths cloths(elements_policy(0));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
  lend(cloths, 0, end);
  cloths.step();
  double wanted = 1;
  for (const abut_stencil& its : cloths.stencils(0, 0)) wanted = std::min(wanted, its.toi > 0 ? its.toi : 1);
  ASSERT_LT(wanted, 1);
  const abut_step_impact first = to_first_impact(cloths.universe());
  EXPECT_EQ(first.lower, wanted);
  EXPECT_TRUE(first.geometry_a == cloths.geometry(0) && first.geometry_b == cloths.geometry(0));
  const std::vector<double> now = vertices_of(cloths, 0, cloths.universe());
  for (std::size_t i = 0; i < now.size(); ++i)
    EXPECT_NEAR(now[i], mesh.xyz[i] + wanted * (end[i] - mesh.xyz[i]), 1e-14);
}

}  // namespace
