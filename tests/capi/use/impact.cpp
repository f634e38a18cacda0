// SPDX-License-Identifier: Apache-2.0
// Shapes that move and turn, as a program in C asks for them.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support.hpp"

namespace {

using namespace abut_test;

abut_movement with_velocity(double x, double y, double z) {
  abut_movement movement{};
  movement.velocity = {x, y, z};
  return movement;
}

abut_impact impact_of(const Shape& a, const abut_pose& pose_a, const abut_movement& movement_a, const Shape& b,
                      const abut_pose& pose_b, const abut_movement& movement_b) {
  abut_impact out{};
  require(abut_pair_time_of_impact(a, &pose_a, &movement_a, b, &pose_b, &movement_b, 1, nullptr, &out));
  return out;
}

TEST(ImpactOptionsInit, FillsInTheDefaults) {
  abut_impact_options options;
  abut_impact_options_init(&options, sizeof options);
  EXPECT_EQ(options.struct_size, sizeof options);
  EXPECT_EQ(options.most_rounds, 1024U);
  EXPECT_EQ(options.tolerance, 0);
  EXPECT_EQ(options.margin, 0);
}

TEST(PairTimeOfImpact, TurnsAroundTheCentreThatIsGiven) {
  // A door around a hinge at its left end, and a ball that stands in its way.
  const Shape door = make_box(1, 0.05, 1), ball = make_sphere(0.1);
  abut_movement swing{};
  swing.centre = {-1, 0, 0};
  swing.angular_velocity = {0, 0, 1};
  const abut_impact impact = impact_of(door, at(1, 0, 0), swing, ball, at(0, 1.5, 0), abut_movement{});
  EXPECT_EQ(impact.state, static_cast<abut_impact_state>(ABUT_IMPACT_APART));
  const abut_impact nearer =
      impact_of(door, at(1, 0, 0), swing, ball, at(1.5 * std::cos(0.5), 1.5 * std::sin(0.5), 0), abut_movement{});
  EXPECT_EQ(nearer.state, static_cast<abut_impact_state>(ABUT_IMPACT_TOUCHES));
  EXPECT_NEAR(nearer.upper, 0.5 - std::asin(0.15 / 1.5), 1e-11);
  EXPECT_LE(nearer.lower, nearer.upper);
  EXPECT_LE(nearer.contact.upper, 1e-11);
}

TEST(PairTimeOfImpact, NamesTheChildThatIsMet) {
  const Shape ball = make_sphere(0.5), pair = make_composite({ball, ball}, {at(-2, 0, 0), at(2, 0, 0)});
  const abut_impact impact = impact_of(pair, identity, abut_movement{}, ball, at(9, 0, 0), with_velocity(-8, 0, 0));
  EXPECT_EQ(impact.child_a, 1U);
  EXPECT_NEAR(impact.upper, 0.75, 1e-12);
  const abut_impact turned = impact_of(ball, at(9, 0, 0), with_velocity(-8, 0, 0), pair, identity, abut_movement{});
  EXPECT_EQ(turned.child_b, 1U);
  EXPECT_EQ(turned.upper, impact.upper);
}

TEST(MovementBetween, LeadsFromOnePoseToTheOther) {
  const abut_pose start = at(1, 2, 3);
  const abut_pose end{{4, 2, 3}, {std::cos(0.25), 0, 0, std::sin(0.25)}};
  const abut_vec3 centre{0, 0, 0};
  abut_movement movement;
  require(abut_movement_between(&start, &end, &centre, 0.5, &movement));
  EXPECT_NEAR(movement.velocity.x, 6, 1e-14);
  EXPECT_NEAR(movement.angular_velocity.z, 1, 1e-14);
  EXPECT_EQ(movement.acceleration.z, 0);
}

TEST(PairsTimeOfImpact, AnswerAsSingleOnesOnAnyNumberOfThreads) {
  const Shape rod = make_capsule(0.1, 1), box = make_box(0.5, 0.25, 1);
  constexpr std::size_t count = 300;
  std::vector<abut_pose> poses_a(count, identity), poses_b(count);
  std::vector<abut_movement> movements_a(count), movements_b(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / count;
    poses_b[i] = at(3, share, -share);
    movements_a[i].angular_velocity = {share, 2 - share, 1};
    movements_b[i] = with_velocity(-2 - share, 0, 0);
    movements_b[i].acceleration = {0, 0, share};
  }
  std::vector<abut_impact> out(count);
  for (const std::uint32_t threads : {1U, 2U}) {
    abut_impact_options options;
    abut_impact_options_init(&options, sizeof options);
    options.threads = threads;
    require(abut_pairs_time_of_impact(rod, poses_a.data(), movements_a.data(), box, poses_b.data(), movements_b.data(),
                                      count, 1, &options, out.data()));
    for (std::size_t i = 0; i < count; ++i) {
      const abut_impact one = impact_of(rod, poses_a[i], movements_a[i], box, poses_b[i], movements_b[i]);
      EXPECT_EQ(out[i].state, one.state);
      EXPECT_EQ(out[i].lower, one.lower);
      EXPECT_EQ(out[i].upper, one.upper);
      EXPECT_EQ(out[i].contact.point_a.x, one.contact.point_a.x);
    }
  }
}

// Sixty solids around the origin. What a cast through them finds is what each of them answers alone.
struct Crowd {
  Universe universe;
  Shape box = make_box(0.3, 0.5, 0.4), ball = make_sphere(0.4);
  std::vector<abut_pose> poses;
  std::vector<abut_geometry_id> ids;
  std::mt19937 engine{17};

  Crowd() {
    for (int i = 0; i < 60; ++i) {
      poses.push_back(at(number(3), number(3), number(3)));
      ids.push_back(universe.add(shape(poses.size() - 1), poses.back()));
    }
    require(abut_universe_refresh(universe));
  }
  double number(double most) { return std::uniform_real_distribution<double>(-most, most)(engine); }
  abut_vec3 vector(double most) { return {number(most), number(most), number(most)}; }
  const Shape& shape(std::size_t i) const { return i % 2 == 0 ? box : ball; }

  abut_pose start() { return at(number(3), number(3), number(3)); }
  abut_movement movement() { return {vector(12), vector(3), vector(3), vector(1), vector(1)}; }
};

std::vector<abut_impact_hit> cast_movement(const Crowd& crowd, const Shape& shape, const abut_pose& start,
                                           const abut_movement& movement, abut_hit_mode mode,
                                           const abut_query_filter* filter = nullptr) {
  std::vector<abut_impact_hit> hits(crowd.ids.size());
  std::size_t count = 0;
  require(abut_universe_cast_movement(crowd.universe, shape, &start, &movement, 1, nullptr, filter, mode, hits.data(),
                                      hits.size(), &count));
  hits.resize(count);
  return hits;
}

TEST(UniverseCastMovement, FindsWhatEachGeometryAnswersAlone) {
  Crowd crowd;
  const Shape rod = make_box(1.5, 0.1, 0.1);
  std::size_t found = 0;
  for (int cast = 0; cast < 60; ++cast) {
    const abut_pose start = crowd.start();
    abut_movement movement = crowd.movement();
    if (cast % 3 == 0) {
      movement.angular_velocity = movement.angular_acceleration = {0, 0, 0};
    } else if (cast % 3 == 1) {
      movement.velocity = movement.acceleration = {0, 0, 0};
    }
    const auto all = cast_movement(crowd, rod, start, movement, ABUT_HIT_ALL);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < crowd.ids.size(); ++i) {
      const abut_impact alone = impact_of(rod, start, movement, crowd.shape(i), crowd.poses[i], abut_movement{});
      const auto hit =
          std::ranges::find_if(all, [&](const abut_impact_hit& its) { return its.geometry == crowd.ids[i]; });
      if (alone.state == static_cast<abut_impact_state>(ABUT_IMPACT_APART)) {
        EXPECT_TRUE(hit == all.end()) << cast;
        continue;
      }
      ++expected;
      ASSERT_TRUE(hit != all.end()) << cast;
      EXPECT_EQ(hit->impact.state, alone.state);
      EXPECT_NEAR(hit->impact.upper, alone.upper, 1e-11);
    }
    EXPECT_EQ(all.size(), expected);
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, [](const abut_impact_hit& its) { return its.impact.lower; }));
    found += expected;

    const auto nearest = cast_movement(crowd, rod, start, movement, ABUT_HIT_NEAREST);
    EXPECT_EQ(cast_movement(crowd, rod, start, movement, ABUT_HIT_ANY).size(), all.empty() ? 0U : 1U);
    ASSERT_EQ(nearest.size(), all.empty() ? 0U : 1U);
    if (!all.empty()) {
      EXPECT_TRUE(nearest[0].geometry == all[0].geometry);
      abut_query_filter filter;
      abut_query_filter_init(&filter, sizeof filter);
      filter.ignore_geometry = all[0].geometry;
      EXPECT_EQ(cast_movement(crowd, rod, start, movement, ABUT_HIT_ALL, &filter).size(), all.size() - 1);
    }
  }
  EXPECT_GT(found, 100U);
}

TEST(UniverseCastMovements, AreTheNearestOfEach) {
  Crowd crowd;
  const Shape rod = make_box(1.5, 0.1, 0.1);
  std::vector<const abut_shape*> shapes(20, rod);
  std::vector<abut_pose> starts;
  std::vector<abut_movement> movements;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    starts.push_back(crowd.start());
    movements.push_back(crowd.movement());
  }
  std::vector<abut_impact_hit> hits(shapes.size());
  require(abut_universe_cast_movements(crowd.universe, shapes.data(), starts.data(), movements.data(), shapes.size(), 1,
                                       nullptr, nullptr, hits.data()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto one = cast_movement(crowd, rod, starts[i], movements[i], ABUT_HIT_NEAREST);
    EXPECT_TRUE(hits[i].geometry == (one.empty() ? abut_geometry_id{} : one[0].geometry));
    EXPECT_EQ(hits[i].impact.upper, one.empty() ? 0 : one[0].impact.upper);
  }
}

}  // namespace
