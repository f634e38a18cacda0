// SPDX-License-Identifier: Apache-2.0
// Why two geometries are not examined: each reason by itself, and in random universes exactly where no detection
// examines the two.
#include <map>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

abut_apart_reasons why_apart(const abut_universe* universe, abut_geometry_id a, abut_geometry_id b) {
  abut_apart_reasons forth = 0, back = 0;
  EXPECT_TRUE(succeeded(abut_universe_why_apart(universe, a, b, &forth)));
  EXPECT_TRUE(succeeded(abut_universe_why_apart(universe, b, a, &back)));
  EXPECT_EQ(forth, back);
  return forth;
}

std::uint64_t examined_pairs(const abut_universe* universe) {
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  EXPECT_TRUE(succeeded(abut_universe_stats(universe, &stats)));
  return stats.examined_pairs;
}

// Two balls that touch, each on a part of its own.
struct TwoBalls {
  TwoBalls() {
    first = universe.add_geometry(first_part, ball);
    second = universe.add_geometry(second_part, ball);
  }
  abut_apart_reasons why() const { return why_apart(universe, first, second); }
  abut_apart_reasons why_after_step() {
    universe.step();
    return why();
  }
  void set_second(const abut_geometry_options& options) {
    EXPECT_TRUE(succeeded(abut_geometry_set_options(universe, second, &options)));
  }
  void detect_far_away() {
    const abut_aabb region{{50, 50, 50}, {60, 60, 60}};
    EXPECT_TRUE(succeeded(abut_universe_detect_region(universe, &region)));
  }

  Universe universe;
  Shape ball = make_sphere(1.0);
  abut_part_id first_part = universe.add_part(identity), second_part = universe.add_part(at(1, 0, 0));
  abut_geometry_id first{}, second{};
};

TEST(WhyApart, IsNothingForAPairThatIsExamined) {
  TwoBalls room;
  EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_DETECTION}) << "no detection has seen them";
  EXPECT_EQ(room.why_after_step(), 0U);
  EXPECT_EQ(room.why_after_step(), 0U) << "what was found is kept";
  room.universe.move(room.second_part, at(1.99, 1.99, 0));
  EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_DETECTION}) << "it has moved since";
  EXPECT_EQ(room.why_after_step(), 0U) << "boxes overlap, and the balls do not";
}

TEST(WhyApart, TellsPartsAndMotions) {
  TwoBalls room;
  const abut_geometry_id third = room.universe.add_geometry(room.first_part, room.ball);
  room.universe.step();
  EXPECT_EQ(why_apart(room.universe, room.first, third), abut_apart_reasons{ABUT_APART_PART});
  EXPECT_EQ(why_apart(room.universe, room.first, room.first), abut_apart_reasons{ABUT_APART_PART | ABUT_APART_KINDS});
  for (const abut_part_id part : {room.first_part, room.second_part})
    EXPECT_TRUE(succeeded(abut_part_set_motion(room.universe, part, ABUT_MOTION_STATIC)));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_MOTION});
  EXPECT_TRUE(succeeded(abut_part_set_motion(room.universe, room.first_part, ABUT_MOTION_DYNAMIC)));
  EXPECT_EQ(room.why_after_step(), 0U);
}

TEST(WhyApart, TellsParking) {
  TwoBalls room;
  room.universe.step();
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    EXPECT_TRUE(succeeded(abut_geometry_park(room.universe, room.second, parking)));
    EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_PARKING});
    EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_PARKING});
    EXPECT_TRUE(succeeded(abut_geometry_park(room.universe, room.second, ABUT_PARKING_NONE)));
    EXPECT_EQ(room.why_after_step(), 0U);
  }
}

TEST(WhyApart, TellsExclusionAndLayers) {
  TwoBalls room;
  abut_geometry_options options = default_geometry_options();
  options.exclusion = 6;
  EXPECT_TRUE(succeeded(abut_geometry_set_options(room.universe, room.first, &options)));
  options.exclusion = 12;
  room.set_second(options);
  EXPECT_EQ(room.why() & ABUT_APART_EXCLUSION, abut_apart_reasons{ABUT_APART_EXCLUSION}) << "at once";
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_EXCLUSION});
  options.exclusion = 8;
  options.layers = 2;
  room.set_second(options);
  EXPECT_EQ(room.why_after_step(), 0U);
  options.mask = 2;
  room.set_second(options);
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_LAYERS});
}

TEST(WhyApart, TellsTheRule) {
  TwoBalls room;
  const abut_collidable second{ABUT_COLLIDABLE_PART, room.second_part.slot, room.second_part.generation};
  EXPECT_TRUE(succeeded(abut_rule_set(room.universe, &second, &anything, ABUT_RULE_DISABLE)));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_RULE});
  abut_rule rule = ABUT_RULE_NONE;
  abut_collidable a{}, b{};
  EXPECT_TRUE(succeeded(abut_rule_between(room.universe, room.first, room.second, &rule, &a, &b)));
  EXPECT_EQ(rule, abut_rule{ABUT_RULE_DISABLE});
  EXPECT_EQ(a.kind, abut_collidable_kind{ABUT_COLLIDABLE_ANY});
  EXPECT_EQ(b.kind, second.kind);
  EXPECT_EQ(b.slot, second.slot);
  EXPECT_EQ(b.generation, second.generation);
  EXPECT_TRUE(succeeded(abut_rules_clear(room.universe)));
  EXPECT_EQ(room.why_after_step(), 0U);
}

TEST(WhyApart, TellsWhatTheFilterSaid) {
  TwoBalls room;
  std::uint32_t answer = 0;
  const auto filter = [](void* context, const abut_universe*, abut_geometry_id, abut_geometry_id) {
    return *static_cast<std::uint32_t*>(context);
  };
  EXPECT_TRUE(succeeded(abut_universe_set_filter(room.universe, filter, &answer)));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_FILTER});
  room.universe.move(room.second_part, at(0.5, 0, 0));
  EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_FILTER | ABUT_APART_DETECTION});
  answer = 1;
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_FILTER}) << "it is not asked again";
  EXPECT_TRUE(succeeded(abut_universe_refilter(room.universe)));
  EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_DETECTION});
  EXPECT_EQ(room.why_after_step(), 0U);
}

TEST(WhyApart, TellsKindsAndBoxes) {
  TwoBalls room;
  const abut_geometry_id floor = room.universe.add(make_plane({0, 0, 1}, 0.0), identity, ABUT_MOTION_DYNAMIC);
  const abut_geometry_id wall = room.universe.add(make_plane({1, 0, 0}, 0.0), identity, ABUT_MOTION_STATIC);
  const abut_geometry_id terrain = room.universe.add(make_terrain(3, 1.0), identity, ABUT_MOTION_STATIC);
  room.universe.move(room.second_part, at(2.5, 0, 0));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_BOXES});
  EXPECT_EQ(why_apart(room.universe, floor, wall), abut_apart_reasons{ABUT_APART_KINDS});
  EXPECT_EQ(why_apart(room.universe, floor, terrain), 0U);
}

TEST(WhyApart, TellsThatAPolicyAsksForBoxes) {
  TwoBalls room;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_BOX;
  EXPECT_TRUE(succeeded(abut_policy_set(room.universe, 0, 0, &policy)));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_POLICY});
}

TEST(WhyApart, TellsWhatADetectionDidNotCover) {
  TwoBalls room;
  room.universe.step();
  room.detect_far_away();
  EXPECT_EQ(room.why(), 0U) << "nothing has changed";
  room.universe.move(room.second_part, at(0.5, 0, 0));
  room.detect_far_away();
  EXPECT_EQ(room.why(), abut_apart_reasons{ABUT_APART_DETECTION});
  abut_policy policy = default_policy();
  policy.period = 1000;
  EXPECT_TRUE(succeeded(abut_policy_set(room.universe, 0, 0, &policy)));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_DETECTION}) << "its step has not come";
}

TEST(WhyApart, TellsAllReasonsThatHold) {
  TwoBalls room;
  abut_geometry_options options = default_geometry_options();
  options.exclusion = 1;
  options.mask = 2;
  EXPECT_TRUE(succeeded(abut_geometry_set_options(room.universe, room.first, &options)));
  room.set_second(options);
  for (const abut_part_id part : {room.first_part, room.second_part})
    EXPECT_TRUE(succeeded(abut_part_set_motion(room.universe, part, ABUT_MOTION_ANIMATED)));
  EXPECT_TRUE(succeeded(abut_rule_set(room.universe, &anything, &anything, ABUT_RULE_DISABLE)));
  room.universe.move(room.second_part, at(9, 0, 0));
  EXPECT_EQ(room.why_after_step(), abut_apart_reasons{ABUT_APART_MOTION | ABUT_APART_EXCLUSION | ABUT_APART_LAYERS |
                                                      ABUT_APART_RULE | ABUT_APART_BOXES});
}

TEST(WhyApart, SpeaksOfAGeometryThatMeetsItself) {
  TwoBalls room;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_SELF_PAIRS;
  options.exclusion = 1;
  const Shape mesh = make_square_mesh(1.0);
  const abut_geometry_id cloth = room.universe.add_geometry(room.first_part, mesh, options);
  room.universe.step();
  EXPECT_EQ(why_apart(room.universe, cloth, cloth), 0U);
  EXPECT_TRUE(succeeded(abut_geometry_set_shape(room.universe, cloth, room.ball)));
  room.universe.step();
  EXPECT_EQ(why_apart(room.universe, cloth, cloth), abut_apart_reasons{ABUT_APART_KINDS});
}

// A crowd of all kinds and motions, with filters of every sort.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : random_(seed), universe_(random_options()) {
    for (int i = 0; i < 9; ++i) parts_.push_back(universe_.add_part(random_pose(), pick(4) < 2 ? 0 : pick(3)));
    const std::vector<Shape> shapes = make_one_of_each_kind();
    for (int i = 0; i < 14; ++i) {
      const std::uint32_t kind = pick(7);
      abut_geometry_options options = default_geometry_options();
      options.flags = kind == 5 && pick(2) == 0 ? ABUT_GEOMETRY_SELF_PAIRS : 0;
      options.layers = 1 + pick(3);
      options.mask = pick(5) == 0 ? 1 + pick(3) : 3;
      options.exclusion = pick(4) == 0 ? 1 + pick(3) : 0;
      options.label = pick(3);
      options.tag = pick(3);
      options.tolerance = 0.25 * pick(3);
      options.parking = pick(8) == 0 ? 1 + pick(2) : 0;
      geometries_.push_back(universe_.add_geometry(parts_.at(pick(9)), shapes.at(kind), options));
    }
    for (int i = 0; i < 4; ++i) add_rule();
    abut_policy policy = default_policy();
    policy.detail = ABUT_DETAIL_BOX;
    EXPECT_TRUE(succeeded(abut_policy_set(universe_, pick(3), pick(3), &policy)));
    EXPECT_TRUE(succeeded(abut_universe_set_filter(universe_, keeps, nullptr)));
  }

  Universe& universe() { return universe_; }
  const std::vector<abut_geometry_id>& geometries() const { return geometries_; }

 private:
  static std::uint32_t keeps(void*, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
    return (7 * a.slot + 3 * b.slot) % 5 != 0 ? 1 : 0;
  }
  std::uint32_t pick(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  double coordinate() { return std::uniform_real_distribution<double>(-2.5, 2.5)(random_); }
  abut_pose random_pose() { return at(coordinate(), coordinate(), coordinate()); }
  const abut_universe_options* random_options() {
    options_ = default_universe_options();
    options_.broadphase = pick(5);
    options_.tolerance_mode = pick(2);
    return &options_;
  }
  abut_collidable random_collidable() {
    const abut_part_id part = parts_.at(pick(9));
    const abut_geometry_id geometry = geometries_.at(pick(14));
    switch (pick(3)) {
      case 0: return {ABUT_COLLIDABLE_GEOMETRY, geometry.slot, geometry.generation};
      case 1: return {ABUT_COLLIDABLE_PART, part.slot, part.generation};
      default: return {ABUT_COLLIDABLE_LABEL, pick(3), 0};
    }
  }
  void add_rule() {
    const abut_collidable a = random_collidable(), b = random_collidable();
    EXPECT_TRUE(succeeded(abut_rule_set(universe_, &a, &b, 1 + pick(2))));
  }

  std::mt19937_64 random_;
  abut_universe_options options_{};
  Universe universe_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
};

// After refilter all pairs are examined again, of which detect_pairs covers one.
bool is_examined(Universe& universe, abut_geometry_id a, abut_geometry_id b) {
  EXPECT_TRUE(succeeded(abut_universe_refilter(universe)));
  EXPECT_TRUE(succeeded(abut_universe_detect_pairs(universe, &a, &b, 1)));
  EXPECT_LE(examined_pairs(universe), 1U);
  return examined_pairs(universe) == 1;
}

TEST(WhyApart, IsNothingExactlyForThePairsThatADetectionExamines) {
  std::map<abut_apart_reasons, std::size_t> seen;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomScene scene(seed);
    Universe& universe = scene.universe();
    ASSERT_TRUE(succeeded(abut_universe_detect_all(universe)));
    const std::uint64_t all_examined = examined_pairs(universe);
    std::uint64_t meeting = 0;
    for (std::size_t i = 0; i < scene.geometries().size(); ++i) {
      for (std::size_t j = i; j < scene.geometries().size(); ++j) {
        const abut_geometry_id a = scene.geometries()[i], b = scene.geometries()[j];
        const bool is_one = is_examined(universe, a, b);
        // A side is a reason of those that are examined.
        const abut_apart_reasons reasons = why_apart(universe, a, b) & ~abut_apart_reasons{ABUT_APART_SIDE};
        EXPECT_EQ(reasons == 0, is_one) << "pair " << i << ", " << j << ": " << reasons;
        meeting += reasons == 0 ? 1 : 0;
        for (abut_apart_reasons bit = 1; bit <= reasons; bit *= 2) seen[bit] += (reasons & bit) != 0 ? 1 : 0;
      }
    }
    EXPECT_EQ(meeting, all_examined);
    seen[0] += meeting;
  }
  for (const abut_apart_reasons reason : {0U, 1U, 2U, 4U, 8U, 16U, 32U, 64U, 128U, 256U, 512U})
    EXPECT_GT(seen[reason], 30U) << "reason " << reason;
}

// A sheet of one side from -1 to 1, with its front up.
Shape one_sided(const char* kind) {
  if (kind == std::string_view("height_field"))
    return make_of_kind(kind, {3, 3, 1, 1, 0, 0}, std::vector<double>(9, 0.0));
  const std::vector<double> parameters =
      kind == std::string_view("mesh") ? std::vector<double>{1} : std::vector<double>{1, 0, 1, 0, 0};
  return make_of_kind(kind, parameters, {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0}, {0, 1, 2, 0, 2, 3});
}

TEST(WhyApart, TellsOfTheBackOfASurfaceOfOneSide) {
  for (const char* kind : {"mesh", "uv_grid", "height_field"}) {
    SCOPED_TRACE(kind);
    Universe universe;
    const Shape sheet = one_sided(kind), ball = make_sphere(0.5);
    const abut_geometry_id ground = universe.add(sheet, identity, ABUT_MOTION_STATIC);
    const abut_part_id part = universe.add_part(at(0.9, 0.8, 0.4));
    const abut_geometry_id its = universe.add_geometry(part, ball);
    EXPECT_EQ(universe.step().size(), 1U) << "in front of it";
    EXPECT_EQ(why_apart(universe, ground, its), 0U);
    universe.move(part, at(0.9, 0.8, -0.4));
    EXPECT_TRUE(universe.step().empty()) << "behind it";
    EXPECT_EQ(why_apart(universe, ground, its), abut_apart_reasons{ABUT_APART_SIDE});
    universe.move(part, at(0.9, 0.8, 0.4));
    universe.step();
    universe.move(part, at(0.9, 0.8, -0.55));
    EXPECT_TRUE(universe.step().empty()) << "and does not reach it";
    EXPECT_EQ(why_apart(universe, ground, its) & ABUT_APART_SIDE, 0U);
  }
}

}  // namespace
