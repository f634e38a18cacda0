// SPDX-License-Identifier: Apache-2.0
// Element contacts of fast geometries: first touches on the ways of vertices, and universes that are saved on the way.
#include "archive_support.hpp"
#include "element_contacts.hpp"
#include "moving.hpp"

namespace {

using namespace abut_test;

Touches touches_of(const std::vector<abut_stencil>& stencils) {
  Touches out;
  for (const abut_stencil& its : stencils) {
    EXPECT_TRUE(out.insert({its.kind, its.of_a, its.element_a, its.element_b}).second) << "told twice";
    EXPECT_GE(its.toi, 0);
    EXPECT_LE(its.toi, 1);
  }
  return out;
}

TEST(ElementContactsOnWay, AreThoseOfAllPairs) {
  ABUT_NEEDS_MOTION();
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Surface a = folded_surface(8, 0.01, random), b = folded_surface(7, 0.01, random);
    for (std::size_t i = 0; i < b.xyz.size(); i += 3) b.xyz[i] += 0.03;
    Cloths cloths(elements_policy(0));
    cloths.add(a, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
    cloths.add(b);
    cloths.step();
    for (int frame = 0; frame < 3; ++frame) {
      // In the last frame only the one that is not fast moves.
      const std::vector<double> end_a = frame == 2 ? a.xyz : moved(a, 0.05, random), end_b = moved(b, 0.05, random);
      if (frame != 2) cloths.move(0, end_a);
      cloths.move(1, end_b);
      cloths.step();
      const Touches of_one = touches_of(cloths.stencils(0, 0)), of_two = touches_of(cloths.stencils(0, 1));
      EXPECT_EQ(of_one, touches_by_all_pairs(a, end_a, a, end_a, 0));
      EXPECT_EQ(of_two, touches_by_all_pairs(a, end_a, b, end_b, 0));
      EXPECT_EQ(of_one.size() > 5, frame != 2);
      EXPECT_GT(of_two.size(), 5U);
      a.xyz = end_a;
      b.xyz = end_b;
    }
    // Nothing moves: the way has ended. From then on nothing is looked at.
    cloths.step();
    EXPECT_EQ(cloths.universe().stats().examined_pairs, 1U);
    EXPECT_TRUE(cloths.contacts().empty());
    cloths.step();
    EXPECT_EQ(cloths.universe().stats().examined_pairs, 0U);
  }
}

const Surface tip = tip_at(0, 0, 1);

// So far that boxes overlap before and after the step no more than contacts do.
TEST(ElementContactsOnWay, TellWhatPassesWithinAStep) {
  ABUT_NEEDS_MOTION();
  for (const std::size_t fast : {std::size_t{0}, std::size_t{1}}) {
    for (const bool by_pose : {true, false}) {
      SCOPED_TRACE(testing::Message() << fast << by_pose);
      Cloths cloths(elements_policy(0.125));
      cloths.add(ground, fast == 0 ? ABUT_GEOMETRY_FAST : 0);
      cloths.add(tip, fast == 1 ? ABUT_GEOMETRY_FAST : 0);
      cloths.step();
      EXPECT_TRUE(cloths.contacts().empty());
      if (by_pose) cloths.universe().move(cloths.part(1), at(0, 0, -4));
      std::vector<double> below = tip.xyz;
      for (std::size_t i = 2; i < below.size(); i += 3) below[i] -= 4;
      if (!by_pose) cloths.move(1, below);
      cloths.step();
      const auto found = cloths.stencils(0, 1);
      ASSERT_EQ(found.size(), 3U) << "the corners of the tip";
      double first = 1;
      for (const abut_stencil& its : found) {
        EXPECT_EQ(its.kind, abut_stencil_kind{ABUT_STENCIL_VERTEX_FACE});
        EXPECT_EQ(its.of_a, 3U);
        EXPECT_NEAR(its.normal.z, 1, 1e-12);
        first = std::min(first, its.toi);
      }
      EXPECT_NEAR(first, 0.25, 1e-9);
      EXPECT_EQ(letters_of(cloths.universe().events()), "b");
      cloths.step();
      EXPECT_TRUE(cloths.contacts().empty());
      EXPECT_EQ(letters_of(cloths.universe().events()), "e");
    }
  }
}

// With a contact distance they touch as far away, and what is that near at the start touches there.
TEST(ElementContactsOnWay, ComeWithinTheContactDistance) {
  ABUT_NEEDS_MOTION();
  abut_policy policy = elements_policy(0.5);
  policy.contact_distance = 0.25;
  Cloths cloths(policy);
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -0.875));
  cloths.step();
  auto found = cloths.contacts();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].stencil.toi, 0.75 / 0.875, 1e-8);
  EXPECT_NEAR(found[0].gap, 0, 1e-8);
  cloths.step();
  found = cloths.contacts();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].stencil.toi, 0);
  EXPECT_NEAR(found[0].stencil.distance, 0.125, 1e-12);
  // Without time there are no ways: closest features within the tolerance.
  require(abut_universe_detect_changed(cloths.universe()));
  found = cloths.contacts();
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].stencil.distance, 0.125, 1e-12);
  EXPECT_NEAR(found[0].gap, -0.125, 1e-12);
  // A contact distance beyond the tolerance is cut there, as boxes reach no further.
  policy.contact_distance = 2;
  cloths.set_policy(policy);
  cloths.universe().move(cloths.part(1), at(0, 0, 2));
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -0.25));
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
}

// A detection in between ends no way: it leads from the last step with time.
TEST(ElementContactsOnWay, BeginAtTheLastStepWithTime) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -0.5));
  require(abut_universe_detect_all(cloths.universe()));
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.universe().move(cloths.part(1), at(0, 0, -4));
  require(abut_universe_detect_all(cloths.universe()));
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 3U);
}

// What was parked starts where it comes back.
TEST(ElementContactsOnWay, DoNotLeadThroughParking) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.universe().park(cloths.geometry(1), ABUT_PARKING_SHORT_TERM);
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -4));
  cloths.universe().park(cloths.geometry(1), ABUT_PARKING_NONE);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.universe().move(cloths.part(1), at(0, 0, 0));
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 3U);
}

// As those of a search on the same ways, by the kinds and the rest distance of the policy.
TEST(ElementContactsOnWay, AreThoseOfASearch) {
  ABUT_NEEDS_MOTION();
  std::mt19937 random(4);
  const Surface rest = folded_surface(10, 0.01, random);
  const std::vector<double> start = moved(rest, 0.02, random), end = moved({start, rest.triangles}, 0.05, random);
  std::set<std::size_t> counts;
  for (const double rest_distance : {0.0, 0.03}) {
    for (const abut_stencil_kinds kinds : {0U, 1U << ABUT_STENCIL_VERTEX_FACE, 1U << ABUT_STENCIL_EDGE_EDGE}) {
      SCOPED_TRACE(testing::Message() << "kinds " << kinds << ", rest distance " << rest_distance);
      auto options = elements_options(0);
      abut_policy policy = elements_policy(0);
      options.kinds = policy.kinds = kinds;
      options.rest_distance = policy.rest_distance = rest_distance;
      const ElementsOf elements(rest);
      require(abut_elements_set_vertices(elements, start.data(), end.data(), rest.vertex_count()));
      const Touches wanted = touches_of(touches_of(elements, nullptr, options));
      Cloths cloths(policy);
      cloths.add(rest, ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST);
      for (const std::vector<double>& xyz : {rest.xyz, start, end}) {
        cloths.move(0, xyz);
        cloths.step();
      }
      EXPECT_EQ(touches_of(cloths.stencils(0, 0)), wanted);
      EXPECT_FALSE(wanted.empty());
      counts.insert(wanted.size());
    }
  }
  EXPECT_EQ(counts.size(), 6U) << "all of these differ";
}

// Kinds that no first touch has ask for none.
TEST(ElementContactsOnWay, HaveNoOtherKinds) {
  ABUT_NEEDS_MOTION();
  abut_policy policy = elements_policy(0);
  policy.kinds = 1U << ABUT_STENCIL_VERTEX_VERTEX;
  Cloths cloths(policy);
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -4));
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
}

// Both sides may be fast. All pairs are in the order of slots, those on ways and those that are near.
TEST(ElementContactsOnWay, AreToldOnceInOrder) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0.125));
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.add(ground);
  cloths.add(tip_at(0.5, -0.5, 0.0625));
  cloths.add(shifted(ground, 0, 0, -0.5), ABUT_GEOMETRY_FAST);
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 1U);
  cloths.universe().move(cloths.part(0), at(0, 0, -4));
  cloths.step();
  const auto found = cloths.contacts();
  EXPECT_EQ(cloths.stencils(0, 1).size(), 3U);
  EXPECT_EQ(cloths.stencils(0, 3).size(), 3U);
  EXPECT_EQ(cloths.stencils(1, 2).size(), 1U);
  EXPECT_EQ(found.size(), 7U);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const auto& x, const auto& y) {
    return std::pair(x.geometry_a.slot, x.geometry_b.slot) < std::pair(y.geometry_a.slot, y.geometry_b.slot);
  }));
}

// What is no pair passes unseen, however fast it is.
TEST(ElementContactsOnWay, AreOfPairsOnly) {
  ABUT_NEEDS_MOTION();
  enum class Case : std::uint8_t { pair, one_part, no_dynamic, other_policy, rule, exclusion, parked };
  for (const Case its :
       {Case::pair, Case::one_part, Case::no_dynamic, Case::other_policy, Case::rule, Case::exclusion, Case::parked}) {
    SCOPED_TRACE(testing::Message() << "case " << int(its));
    Cloths cloths(elements_policy(0));
    Universe& universe = cloths.universe();
    const abut_motion motion = its == Case::no_dynamic ? ABUT_MOTION_ANIMATED : ABUT_MOTION_DYNAMIC;
    abut_geometry_options options = default_geometry_options();
    options.exclusion = its == Case::exclusion ? 1 : 0;
    const abut_part_id part = universe.add_part(identity, motion);
    cloths.add_on(part, ground, options);
    options.tag = its == Case::other_policy ? 1 : 0;
    options.flags = ABUT_GEOMETRY_FAST;
    cloths.add_on(its == Case::one_part ? part : universe.add_part(identity, motion), tip, options);
    if (its == Case::rule) require(abut_rule_set(universe, &anything, &anything, ABUT_RULE_DISABLE));
    if (its == Case::parked) universe.park(cloths.geometry(0), ABUT_PARKING_SHORT_TERM);
    cloths.step();
    cloths.move(1, shifted(tip, 0, 0, -4).xyz);
    cloths.step();
    EXPECT_EQ(cloths.contacts().size(), its == Case::pair ? 3U : 0U);
    EXPECT_EQ(universe.events().size(), its == Case::pair ? 1U : 0U);
    if (its == Case::other_policy || its == Case::parked) {
      EXPECT_EQ(universe.stats().candidate_pairs, 0U);
    }
  }
}

// What passes beside a border within the contact distance touches; a contact distance beyond the tolerance reaches no
// further than that, also where boxes do.
TEST(ElementContactsOnWay, PassBesideABorder) {
  ABUT_NEEDS_MOTION();
  const double root = std::sqrt(0.5);
  struct Row {
    double x, y, contact_distance;
    bool touches;
  };
  for (const Row& row :
       {Row{-1.1, 0, 0.25, true}, Row{-1.3, 0, 0.25, false}, Row{0.5 + 0.2 * root, 0.5 + 0.2 * root, 9, true},
        Row{0.5 + 0.6 * root, 0.5 + 0.6 * root, 9, false}}) {
    SCOPED_TRACE(testing::Message() << row.x << " " << row.y);
    abut_policy policy = elements_policy(0.5);
    policy.contact_distance = row.contact_distance;
    Cloths cloths(policy);
    cloths.add(ground);
    cloths.add({{row.x, row.y, 4, row.x, row.y, 4.25, row.x, row.y, 4.5}, {0, 1, 2}}, ABUT_GEOMETRY_FAST);
    cloths.step();
    cloths.universe().move(cloths.part(0), at(0, 0, 0.125));  // so that both have ways
    cloths.universe().move(cloths.part(1), at(0, 0, -9));
    cloths.step();
    EXPECT_EQ(cloths.contacts().empty(), !row.touches);
  }
}

// A policy that comes later knows where the vertices were in the step with time before.
TEST(ElementContactsOnWay, BeginWithThePolicy) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(default_policy());
  cloths.add(ground);
  cloths.add(tip, ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.set_policy(elements_policy(0));
  cloths.step();
  cloths.universe().move(cloths.part(1), at(0, 0, -4));
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 3U);
}

// With time what is within the contact distance, without it all within the tolerance; nothing moves in between.
TEST(ElementContactsOnWay, AreOtherOnesWithoutTime) {
  ABUT_NEEDS_MOTION();
  abut_policy policy = elements_policy(0.5);
  policy.contact_distance = 0.25;
  Cloths cloths(policy);
  cloths.add(ground);
  cloths.add({{0, 0, 0.125, 0.5, 0, 0.375, 0, 0.2, 2}, {0, 1, 2}}, ABUT_GEOMETRY_FAST);
  for (int round = 0; round < 2; ++round) {
    for (int again = 0; again < 2; ++again) {
      cloths.step();
      EXPECT_EQ(cloths.contacts().size(), 1U) << round << again;
    }
    for (int again = 0; again < 2; ++again) {
      require(abut_universe_detect_changed(cloths.universe()));
      EXPECT_EQ(cloths.contacts().size(), 2U) << round << again;
    }
  }
}

// A way from beyond 1e50 is none, though it ends on the ground.
TEST(ElementContactsOnWay, FromFarAwayAreNone) {
  ABUT_NEEDS_MOTION();
  Cloths cloths(elements_policy(0));
  cloths.add(ground);
  cloths.add(shifted(tip, 0, 0, 1e60), ABUT_GEOMETRY_FAST);
  cloths.step();
  cloths.move(1, shifted(tip, 0, 0, -1.5).xyz);
  cloths.step();
  EXPECT_TRUE(cloths.contacts().empty());
  cloths.move(1, tip.xyz);
  cloths.step();
  EXPECT_EQ(cloths.contacts().size(), 1U);
}

// The hash tells two touches apart that differ by their time alone.
TEST(ElementContactsOnWay, HaveTheirTimesInTheHash) {
  ABUT_NEEDS_MOTION();
  const auto hash_from = [&](double z) {
    Cloths cloths(elements_policy(0));
    cloths.add(ground);
    cloths.add(shifted(tip, 0, 0, z), ABUT_GEOMETRY_FAST);
    cloths.step();
    cloths.move(1, shifted(tip, 0, 0, -1.5).xyz);
    cloths.step();
    EXPECT_EQ(cloths.contacts().size(), 1U);
    return cloths.universe().hash();
  };
  EXPECT_EQ(hash_from(0.5), hash_from(0.5));
  EXPECT_NE(hash_from(0.5), hash_from(2.5));
}

// What is loaded goes on as what was saved, from each of several moments, and is saved as the same bytes.
TEST(ElementContactsOnWay, AreSavedWithTheirUniverse) {
  for (const abut_geometry_flags fast : {0U, abut_has_feature("motion") != 0 ? ABUT_GEOMETRY_FAST + 0U : 0U}) {
    std::mt19937 random(3);
    Surface a = folded_surface(8, 0.01, random), b = folded_surface(7, 0.01, random);
    abut_policy policy = elements_policy(0.06);
    policy.rest_distance = 0.05;
    Cloths cloths(policy);
    cloths.add(a, ABUT_GEOMETRY_SELF_PAIRS | fast);
    cloths.add(b, ABUT_GEOMETRY_SELF_PAIRS, at(0.03, 0, 0));
    std::vector<Owned> twins;
    const auto expect_equal = [&](const abut_universe* twin) {
      EXPECT_EQ(saved(twin), saved(cloths.universe()));
      std::uint64_t hash = 0;
      require(abut_universe_hash(twin, &hash));
      EXPECT_EQ(hash, cloths.universe().hash());
    };
    for (int frame = 0; frame < 8; ++frame) {
      const std::size_t which = frame < 5 ? 0 : 1;
      const std::vector<double> xyz = moved(which == 0 ? a : b, 0.03, random);
      const auto move = [&](abut_universe* universe) {
        if (frame == 3) return;
        require(abut_geometry_set_vertices(universe, cloths.geometry(which), 0, xyz.data(), xyz.size() / 3));
      };
      const auto step = [&](abut_universe* universe) {
        if (frame == 2) require(abut_universe_detect_changed(universe));
        if (frame != 2) require(abut_universe_step(universe, 0.01));
      };
      move(cloths.universe());
      for (const Owned& twin : twins) move(twin.get());
      twins.push_back(loaded(saved(cloths.universe())));
      expect_equal(twins.back().get());
      step(cloths.universe());
      for (const Owned& twin : twins) step(twin.get());
      twins.push_back(loaded(saved(cloths.universe())));
      EXPECT_FALSE(cloths.contacts().empty());
      for (const Owned& twin : twins) {
        SCOPED_TRACE(testing::Message() << "frame " << frame << ", fast " << fast);
        expect_equal(twin.get());
      }
    }
  }
}

}  // namespace
