// SPDX-License-Identifier: Apache-2.0
// What touches one-sided ground within rounding is stopped where it moves into the ground, and moves off freely: in
// casts, times of impact and steps of fast geometries. Where bodies lie follows from closed forms of their supports.
#include <cmath>
#include <numbers>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  abut_vec3 direction() {
    for (;;) {
      const abut_vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (length(v) > 0.1 && length(v) < 1) return times(1 / length(v), v);
    }
  }
  abut_quat turn() { return turned_by(times(between(0, std::numbers::pi), direction())); }

 private:
  std::mt19937_64 random_;
};

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 turned(const abut_quat& q, const abut_vec3& v) {
  const abut_quat back = product(product(q, {0, v.x, v.y, v.z}), {q.w, -q.x, -q.y, -q.z});
  return {back.x, back.y, back.z};
}

// A shape, and how far it reaches below its origin against a direction in its own frame.
struct Body {
  const char* name;
  Shape shape;
  double (*depth)(const abut_vec3& n);
};

std::vector<Body> make_bodies() {
  std::vector<Body> bodies;
  bodies.push_back({"sphere", make_sphere(0.5), [](const abut_vec3&) { return 0.5; }});
  bodies.push_back({"capsule", make_capsule(0.2, 0.4), [](const abut_vec3& n) { return 0.2 + 0.4 * std::abs(n.z); }});
  bodies.push_back({"box", make_box(0.3, 0.2, 0.4), [](const abut_vec3& n) {
                      return 0.3 * std::abs(n.x) + 0.2 * std::abs(n.y) + 0.4 * std::abs(n.z);
                    }});
  bodies.push_back({"hull", make_octahedron(0.5),
                    [](const abut_vec3& n) { return 0.5 * std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}); }});
  bodies.push_back({"cylinder", make_of_kind("cylinder", {0.3, 0.4}),
                    [](const abut_vec3& n) { return 0.3 * std::hypot(n.x, n.y) + 0.4 * std::abs(n.z); }});
  bodies.push_back({"cone", make_of_kind("cone", {0.3, 0.4}),
                    [](const abut_vec3& n) { return std::max(-0.4 * n.z, 0.4 * n.z + 0.3 * std::hypot(n.x, n.y)); }});
  bodies.push_back({"ellipsoid", make_of_kind("ellipsoid", {0.3, 0.2, 0.4}), [](const abut_vec3& n) {
                      return std::sqrt(0.09 * n.x * n.x + 0.04 * n.y * n.y + 0.16 * n.z * n.z);
                    }});
  bodies.push_back({"segment", make_of_kind("segment", {0.4}), [](const abut_vec3& n) { return 0.4 * std::abs(n.z); }});
  bodies.push_back({"particles", make_of_kind("particles", {0}, {0, 0, 0, 0.1, 0.3, 0, 0, 0.1}),
                    [](const abut_vec3& n) { return 0.1 + std::max(-0.3 * n.x, 0.0); }});
  bodies.push_back({"composite", make_composite({make_box(0.2, 0.2, 0.2), make_sphere(0.2)}, {identity, at(0.3, 0, 0)}),
                    [](const abut_vec3& n) {
                      return std::max(0.2 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)), 0.2 - 0.3 * n.x);
                    }});
  return bodies;
}

struct Ground {
  const char* name;
  Shape shape;  // flat at z = 0 from -3 to 3, front up
};

Ground made_of(const char* name, const char* kind, const std::vector<double>& parameters) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
  constexpr std::uint32_t cells = 4;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) xyz.insert(xyz.end(), {1.5 * i - 3, 1.5 * j - 3, 0});
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t at = j * (cells + 1) + i, above = at + cells + 1;
      indices.insert(indices.end(), {at, at + 1, above + 1, at, above + 1, above});
    }
  }
  return {name, make_of_kind(kind, parameters, xyz, indices)};
}

// Its top is at z = 0.
Shape make_solid_cube() {
  const std::vector<double> cube{-3, -3, -2, 3, -3, -2, -3, 3, -2, 3, 3, -2, -3, -3, 0, 3, -3, 0, -3, 3, 0, 3, 3, 0};
  const std::vector<std::uint32_t> faces{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                         1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};
  return make_of_kind("mesh", {2}, cube, faces);
}

std::vector<Ground> make_grounds() {
  std::vector<Ground> grounds;
  const auto field = [](double below) {
    return make_of_kind("height_field", {5, 5, 1.5, 1.5, 0, below}, std::vector(25, 0.0));
  };
  grounds.push_back({"height field", make_composite({field(0)}, {at(-3, -3, 0)})});
  grounds.push_back({"solid height field", make_composite({field(1)}, {at(-3, -3, 0)})});
  grounds.push_back(made_of("front mesh", "mesh", {1}));
  grounds.push_back(made_of("front grid", "uv_grid", {1, 0, 1, 2, 2}));
  grounds.push_back({"solid mesh", make_solid_cube()});
  grounds.push_back(
      {"mesh and ball", make_composite({made_of("", "mesh", {1}).shape, make_sphere(0.1)}, {identity, at(0, 0, -5)})});
  return grounds;
}

constexpr std::array gaps{-1e-12, -1e-14, -1e-15, -1e-16, 0.0,   1e-17, 1e-16, 5e-16, 1e-15,
                          5e-15,  1e-14,  1e-13,  1e-12,  5e-12, 1e-11, 1e-10, 1e-9};

// A body above or in the ground, and its way.
struct Start {
  const Ground& ground;
  const Body& body;
  abut_pose pose_of_ground, pose;
  abut_vec3 normal;
  double gap;
};

Start random_start(const Ground& ground, const Body& body, Numbers& random) {
  abut_pose frame{times(random.below(2) == 0 ? 0 : 3, random.direction()),
                  random.below(2) == 0 ? no_rotation : random.turn()};
  const abut_vec3 normal = turned(frame.orientation, {0, 0, 1});
  abut_pose pose{{0, 0, 0}, random.below(3) == 0 ? no_rotation : random.turn()};
  const abut_quat& q = pose.orientation;
  const double gap = gaps.at(random.below(gaps.size()));
  const double height = gap + body.depth(turned({q.w, -q.x, -q.y, -q.z}, normal));
  const double x = random.below(4) == 0 ? 0 : random.between(-1.4, 1.4);
  pose.position = sum(frame.position, turned(frame.orientation, {x, random.between(-1.4, 1.4), height}));
  return {ground, body, frame, pose, normal, gap};
}

struct Told {
  const char* by;
  bool is_met;
  double fraction;
};

// What casts, times of impact and a universe say about the same way.
std::vector<Told> ask_all(const Start& start, const abut_vec3& way) {
  const abut_vec3 none{0, 0, 0};
  std::vector<Told> told;
  abut_cast_hit hit{};
  std::uint32_t found = 0;
  require(abut_pair_cast(start.body.shape, &start.pose, &way, start.ground.shape, &start.pose_of_ground, &none, nullptr,
                         &hit, &found));
  told.push_back({"cast", found == 1, hit.fraction});
  if (abut_has_feature("motion") == 0) return told;
  abut_movement movement{}, still{};
  movement.velocity = way;
  abut_impact impact{};
  require(abut_pair_time_of_impact(start.body.shape, &start.pose, &movement, start.ground.shape, &start.pose_of_ground,
                                   &still, 1, nullptr, &impact));
  told.push_back({"time of impact", impact.state != ABUT_IMPACT_APART, impact.lower});
  Universe universe;
  universe.add(start.ground.shape, start.pose_of_ground, ABUT_MOTION_STATIC);
  require(abut_universe_refresh(universe));
  abut_impact_hit touched{};
  const abut_shape* const shape = start.body.shape;
  require(abut_universe_cast_movements(universe, &shape, &start.pose, &movement, 1, 1, nullptr, nullptr, &touched));
  told.push_back({"cast movement", touched.geometry.slot != 0, touched.impact.lower});
  return told;
}

// The toi of the first contact of a fast step.
Told ask_step(const Start& start, const abut_vec3& way) {
  Universe universe;
  universe.add(start.ground.shape, start.pose_of_ground, ABUT_MOTION_STATIC);
  add_moving(universe, start.body.shape, {start.pose, {way, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
  require(abut_universe_step(universe, 1));
  Told told{"step", false, 2};
  for (const abut_contact& contact : universe.contacts()) told = {"step", true, std::min(told.fraction, contact.toi)};
  return told;
}

template <class Visit>
void for_each_start(std::uint64_t seed, int rounds, Visit&& visit) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Numbers random(seed);
  const std::vector<Body> bodies = make_bodies();
  const std::vector<Ground> grounds = make_grounds();
  for (int i = 0; i < rounds; ++i) {
    for (const Ground& ground : grounds) {
      for (const Body& body : bodies) {
        const Start start = random_start(ground, body, random);
        SCOPED_TRACE(testing::Message() << body.name << " on " << ground.name << ", round " << i << ", gap "
                                        << start.gap);
        visit(start, random);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(TouchingGround, StopsWhatMovesIntoIt) {
  for_each_start(31, 40, [](const Start& start, Numbers& random) {
    abut_vec3 way = random.direction();
    way = dot(way, start.normal) > 0 ? times(-1, way) : way;
    const double slope = -dot(way, start.normal);
    if (slope < 0.05) return;
    way = times(random.between(0.05, 1), way);
    const double latest = std::max(start.gap, 0.0) / (slope * length(way)) + 1e-9;
    std::vector<Told> all = ask_all(start, way);
    if (abut_has_feature("motion") != 0) all.push_back(ask_step(start, way));
    // A body without thickness is behind the ground where it is deeper than rounding.
    if (std::string_view(start.body.name) == "segment" && start.gap < -1e-15) return;
    for (const Told& told : all) {
      EXPECT_TRUE(told.is_met && told.fraction <= latest) << told.by << ' ' << told.is_met << ' ' << told.fraction;
    }
  });
}

TEST(TouchingGround, HoldsNothingThatLeavesIt) {
  for_each_start(32, 40, [](const Start& start, Numbers& random) {
    abut_vec3 way = random.direction();
    way = dot(way, start.normal) < 0 ? times(-1, way) : way;
    if (dot(way, start.normal) < 0.05 || start.gap < 0) return;
    for (const Told& told : ask_all(start, way)) EXPECT_FALSE(told.is_met) << told.by << ' ' << told.fraction;
  });
}

// Rounding leaves bodies on either side of the ground after each move.
TEST(TouchingGround, IsCastAgainstAgainAndAgain) {
  for_each_start(33, 6, [](const Start& start, Numbers& random) {
    if (start.gap < 0) return;
    abut_pose pose = start.pose;
    const auto move_by = [&](const abut_vec3& way) {
      const abut_vec3 none{0, 0, 0};
      abut_cast_hit hit{};
      std::uint32_t found = 0;
      require(abut_pair_cast(start.body.shape, &pose, &way, start.ground.shape, &start.pose_of_ground, &none, nullptr,
                             &hit, &found));
      const double fraction = found == 1 ? hit.fraction : 1;
      pose.position = sum(pose.position, times(fraction, way));
      return found == 1;
    };
    const auto height = [&] {
      return dot(sum(pose.position, times(-1, start.pose.position)), start.normal) + start.gap;
    };
    for (int step = 0; step < 12; ++step) {
      // Down and aside, then along the ground, as a character walks.
      abut_vec3 aside = times(0.05, random.direction());
      aside = sum(aside, times(-dot(aside, start.normal), start.normal));
      EXPECT_TRUE(move_by(sum(aside, times(-0.3, start.normal)))) << step;
      static_cast<void>(move_by(aside));
      ASSERT_NEAR(height(), 0, 2e-9) << step;
    }
    EXPECT_FALSE(move_by(times(0.5, start.normal)));
    ASSERT_NEAR(height(), 0.5, 2e-9);
  });
}

TEST(TouchingGround, KeepsTheContactOfAnAdvance) {
  ABUT_NEEDS_MOTION();
  for_each_start(34, 10, [](const Start& start, Numbers& random) {
    abut_vec3 way = random.direction();
    way = dot(way, start.normal) > 0 ? times(-1, way) : way;
    if (dot(way, start.normal) > -0.3) return;
    const Moving falling{{sum(start.pose.position, times(-0.5, way)), start.pose.orientation},
                         {times(random.between(1, 20), way), {0, 0, 0}},
                         {{0, 0, 0}, {0, 0, 0}}};
    Universe universe;
    universe.add(start.ground.shape, start.pose_of_ground, ABUT_MOTION_STATIC);
    add_moving(universe, start.body.shape, falling, ABUT_GEOMETRY_FAST);
    abut_step_impact first{};
    require(abut_universe_advance_to_first_impact(universe, 1, &first));
    ASSERT_LT(first.lower, 1);
    require(abut_universe_step(universe, 1.0 / 60));
    ASSERT_FALSE(universe.contacts().empty());
    EXPECT_LE(universe.contacts()[0].toi, 1e-6);
  });
}

TEST(TouchingGround, StopsABallAtOneRoundingAboveIt) {
  const Shape ball = make_sphere(0.5), field = make_of_kind("height_field", {3, 3, 1, 1}, std::vector(9, 0.0)),
              cube = make_solid_cube();
  const abut_vec3 down{0, 0, -1}, none{0, 0, 0};
  for (const auto& [ground, pose] : {std::pair{static_cast<abut_shape*>(field), at(1, 1, 0.5000000000000001)},
                                     std::pair{static_cast<abut_shape*>(cube), at(0, 0, 0.5000000000000001)}}) {
    abut_cast_hit hit{};
    std::uint32_t found = 0;
    require(abut_pair_cast(ball, &pose, &down, ground, &identity, &none, nullptr, &hit, &found));
    ASSERT_EQ(found, 1U);
    EXPECT_EQ(hit.fraction, 0);
    EXPECT_EQ(hit.contact.normal.z, -1);
  }
  if (abut_has_feature("motion") == 0) return;
  const abut_pose above = at(1, 1, 0.500000000001);
  abut_movement falling{}, still{};
  falling.velocity = down;
  abut_impact impact{};
  require(abut_pair_time_of_impact(ball, &above, &falling, field, &identity, &still, 1, nullptr, &impact));
  EXPECT_TRUE(impact.state == ABUT_IMPACT_STARTS_TOGETHER || impact.state == ABUT_IMPACT_TOUCHES);
  EXPECT_LE(impact.upper, 2e-12);
}

TEST(TouchingGround, HoldsABallThatFellOntoIt) {
  ABUT_NEEDS_MOTION();
  const Shape ball = make_sphere(0.5), field = make_of_kind("height_field", {3, 3, 1, 1}, std::vector(9, 0.0));
  Universe universe;
  universe.add(field, identity, ABUT_MOTION_STATIC);
  add_moving(universe, ball, {at(1, 1, 4), {{0, 0, -10}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
  abut_step_impact first{};
  require(abut_universe_advance_to_first_impact(universe, 1, &first));
  EXPECT_NEAR(first.lower, 0.35, 1e-9);
  require(abut_universe_step(universe, 1.0 / 60));
  ASSERT_EQ(universe.contacts().size(), 1U);
  EXPECT_EQ(universe.contacts()[0].toi, 0);
}

}  // namespace
