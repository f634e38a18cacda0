// SPDX-License-Identifier: Apache-2.0
// Convex parts that lie side by side have contacts as one shape, where somebody asks for it; real walls stay.
#include <algorithm>
#include <cmath>
#include <vector>

#include "support.hpp"

namespace {

using namespace abut_test;

struct Part {
  const abut_shape* shape;
  abut_pose pose;
};

class Ground {
 public:
  explicit Ground(std::vector<Part> parts) : parts_(std::move(parts)) {}

  // Of one body in a universe, all of them.
  [[nodiscard]] std::vector<abut_contact> in_universe(const abut_shape* body, const abut_pose& pose,
                                                      abut_universe_flags flags,
                                                      abut_motion motion = ABUT_MOTION_STATIC) const {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.max_contacts = 0;
    options.flags = flags;
    Universe universe(&options);
    for (const Part& part : parts_) universe.add(part.shape, part.pose, motion);
    universe.add(body, pose);
    return universe.step();
  }

  // Of a pair with a composite of the parts, all of them.
  [[nodiscard]] std::vector<abut_contact> in_composite(const abut_shape* body, const abut_pose& pose,
                                                       abut_query_flags flags) const {
    const Shape whole = joined();
    const abut_query_options options = with(flags);
    std::vector<abut_contact> contacts(200);
    std::size_t count = 0;
    require(abut_pair_contacts(whole, &identity, body, &pose, &options, contacts.data(), contacts.size(), &count));
    contacts.resize(count);
    return contacts;
  }
  [[nodiscard]] abut_distance distance(const abut_shape* body, const abut_pose& pose, abut_query_flags flags) const {
    const Shape whole = joined();
    const abut_query_options options = with(flags);
    abut_distance found{};
    require(abut_pair_distance(whole, &identity, body, &pose, &options, &found));
    return found;
  }

 private:
  [[nodiscard]] Shape joined() const {
    std::vector<const abut_shape*> children;
    std::vector<abut_pose> poses;
    for (const Part& part : parts_) {
      children.push_back(part.shape);
      poses.push_back(part.pose);
    }
    abut_shape* shape = nullptr;
    require(abut_composite_create(children.data(), poses.data(), children.size(), &shape));
    return Shape(shape);
  }
  [[nodiscard]] static abut_query_options with(abut_query_flags flags) {
    abut_query_options options;
    abut_query_options_init(&options, sizeof options);
    options.max_contacts = 0;
    options.flags = flags;
    return options;
  }

  std::vector<Part> parts_;
};

int count_along(const std::vector<abut_contact>& contacts, const abut_vec3& normal) {
  return static_cast<int>(std::count_if(contacts.begin(), contacts.end(), [&](const abut_contact& c) {
    return std::fabs(c.normal.x - normal.x) + std::fabs(c.normal.y - normal.y) + std::fabs(c.normal.z - normal.z) <
           1e-9;
  }));
}
double deepest(const std::vector<abut_contact>& contacts) {
  double least = 1e300;
  for (const abut_contact& contact : contacts) least = std::min(least, contact.distance);
  return least;
}
// How far contacts reach along X on side b.
double reach_x(const std::vector<abut_contact>& contacts) {
  double most = -1e300;
  for (const abut_contact& contact : contacts) most = std::max(most, contact.point_b.x);
  return most;
}

constexpr abut_vec3 up{0, 0, 1}, left{-1, 0, 0};

void expect_floor(const Ground& ground, const abut_shape* body, const abut_pose& pose, double depth) {
  for (const auto& contacts :
       {ground.in_universe(body, pose, ABUT_UNIVERSE_WELDS), ground.in_composite(body, pose, ABUT_QUERY_WELDS)}) {
    ASSERT_FALSE(contacts.empty());
    EXPECT_EQ(count_along(contacts, up), static_cast<int>(contacts.size()));
    EXPECT_NEAR(deepest(contacts), -depth, 1e-12);
  }
  EXPECT_NEAR(ground.distance(body, pose, ABUT_QUERY_WELDS).distance, -depth, 1e-12);
}

TEST(Welds, OneBoxOverTwoHasContactsUp) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -1)}});
  const abut_pose pose = at(0.505, 0, 0.49);
  expect_floor(ground, body, pose, 0.01);
  EXPECT_NEAR(reach_x(ground.in_universe(body, pose, ABUT_UNIVERSE_WELDS)), 1.005, 1e-12);
  // Without it each box has its wall.
  EXPECT_EQ(count_along(ground.in_universe(body, pose, 0), left), 4);
  EXPECT_EQ(count_along(ground.in_composite(body, pose, 0), left), 4);
  EXPECT_EQ(count_along(ground.in_universe(body, pose, ABUT_UNIVERSE_WELDS, ABUT_MOTION_ANIMATED), left), 0);
  EXPECT_EQ(count_along(ground.in_universe(body, pose, ABUT_UNIVERSE_WELDS, ABUT_MOTION_DYNAMIC), left), 4);
}

TEST(Welds, HeightsThatDifferByACrackAreOneFloorAndASteepStepIsAWall) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  const abut_pose pose = at(0.505, 0, 0.49);
  for (const double rise : {1e-15, 1e-12, 1e-9, 1e-6, 1e-5, -1e-9, -1e-5}) {
    const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -1 + rise)}});
    expect_floor(ground, body, pose, 0.01 + std::max(rise, 0.0));
  }
  for (const double rise : {1e-3, 1e-2, 0.1, 0.5}) {
    const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -1 + rise)}});
    for (const bool is_welded : {false, true}) {
      const auto contacts = ground.in_universe(body, pose, is_welded ? ABUT_UNIVERSE_WELDS : 0);
      EXPECT_EQ(count_along(contacts, up), 4) << rise;
      EXPECT_EQ(count_along(contacts, left), 4) << rise;
      EXPECT_EQ(count_along(ground.in_composite(body, pose, is_welded ? ABUT_QUERY_WELDS : 0), left), 4) << rise;
    }
  }
}

TEST(Welds, GapsUpToACrackAreNone) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  for (const double gap : {1e-12, 1e-9, 1e-6, 1e-5, -1e-6, -0.01, -0.5}) {
    const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2 + gap, 0, -1)}});
    expect_floor(ground, body, at(0.505 + gap, 0, 0.49), 0.01);
  }
  const Ground apart({{tile, at(0, 0, -1)}, {tile, at(2.002, 0, -1)}});
  EXPECT_EQ(count_along(apart.in_universe(body, at(0.507, 0, 0.49), ABUT_UNIVERSE_WELDS), left), 4);
}

TEST(Welds, ThreeAndFourBoxesAtACorner) {
  const Shape tile = make_box(1, 1, 1), ball = make_sphere(0.5), body = make_box(0.5, 0.5, 0.5);
  const std::vector<Part> four{
      {tile, at(-1, -1, -1)}, {tile, at(1, -1, -1)}, {tile, at(-1, 1, -1)}, {tile, at(1, 1, -1)}};
  const std::vector<Part> three(four.begin(), four.end() - 1);
  for (const std::vector<Part>& parts : {three, four}) {
    const Ground ground(parts);
    for (const double x : {-0.495, -0.5, -0.3, -1e-3}) {
      for (const double y : {-0.495, -0.497, -0.2}) {
        expect_floor(ground, body, at(x, y, 0.49), 0.01);
        expect_floor(ground, ball, at(x, y, 0.47), 0.03);
      }
    }
  }
}

TEST(Welds, DeepBallsBetweenBoxesGoUp) {
  const Shape tile = make_box(1, 1, 1), ball = make_sphere(0.5);
  const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -1)}});
  expect_floor(ground, ball, at(0.95, 0, -0.1), 0.6);
  expect_floor(ground, ball, at(1.02, 0, -0.2), 0.7);
}

TEST(Welds, OpenSidesStayWalls) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -1)}});
  // Against both from their common side.
  const auto beside = ground.in_universe(body, at(0.7, 1.49, -1), ABUT_UNIVERSE_WELDS);
  EXPECT_EQ(count_along(beside, {0, 1, 0}), static_cast<int>(beside.size()));
  EXPECT_NEAR(deepest(beside), -0.01, 1e-12);
  // At the outer end of the second one.
  EXPECT_EQ(count_along(ground.in_universe(body, at(3.495, 0, -0.5), ABUT_UNIVERSE_WELDS), {1, 0, 0}), 4);
}

TEST(Welds, ATipInTheCornerOfAStepIsPushedOutOfBoth) {
  // A tetrahedron whose tip is below the floor and in the step.
  const std::vector<double> tip{0, 0, 0, -1, -0.5, 1, -1, 0.5, 1, -0.5, 0, 1.5};
  const Shape body = make_of_kind("hull", {}, tip), tile = make_box(1, 1, 1);
  const Ground ground({{tile, at(0, 0, -1)}, {tile, at(2, 0, -0.9)}});
  const auto contacts = ground.in_universe(body, at(1.005, 0, -0.01), ABUT_UNIVERSE_WELDS),
             plain = ground.in_universe(body, at(1.005, 0, -0.01), 0);
  EXPECT_NEAR(deepest(contacts), deepest(plain), 1e-12);
  EXPECT_EQ(count_along(contacts, left), count_along(plain, left));
}

TEST(Welds, ABoxBesideAMeshHasNoWallUnderIt) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  for (const double sides : {0.0, 1.0}) {
    const Shape sheet = make_of_kind("mesh", {sides}, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3});
    const Ground ground({{sheet, at(0, 0, 0)}, {tile, at(2, 0, -1)}});
    expect_floor(ground, body, at(0.505, 0, 0.49), 0.01);
    const Ground mirrored({{tile, at(0, 0, -1)}, {sheet, at(2, 0, 0)}});
    expect_floor(mirrored, body, at(0.505, 0, 0.49), 0.01);
  }
}

TEST(Welds, ABoxSunkIntoAPlaneHasNoWallUnderIt) {
  abut_shape* shape = nullptr;
  require(abut_plane_create(&up, 0, &shape));
  const Shape plane(shape), tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  const Ground ground({{plane, identity}, {tile, at(2, 0, -1)}});
  const auto contacts = ground.in_universe(body, at(0.505, 0, 0.49), ABUT_UNIVERSE_WELDS);
  EXPECT_EQ(count_along(contacts, up), static_cast<int>(contacts.size()));
  EXPECT_NEAR(deepest(contacts), -0.01, 1e-12);
}

TEST(Welds, MarginsAndDeadBandsHold) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  for (const abut_tolerance_mode mode : {ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN}) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.tolerance_mode = mode;
    options.flags = ABUT_UNIVERSE_WELDS | ABUT_UNIVERSE_LOCAL_POINTS;
    Universe universe(&options);
    for (const double x : {0.0, 2.0}) universe.add(tile, at(x, 0, -1), ABUT_MOTION_STATIC, 0.002);
    universe.add(body, at(0.505, 0, 0.49));
    const auto contacts = universe.step();
    EXPECT_EQ(contacts.size(), 8U);
    EXPECT_EQ(count_along(contacts, up), 8);
    const abut_local_points* points = nullptr;
    std::size_t count = 0;
    require(abut_universe_local_points(universe, &points, &count));
    ASSERT_EQ(count, contacts.size());
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(points[i].b.x, contacts[i].point_b.x - 0.505, 1e-12);
      EXPECT_NEAR(points[i].b.z, contacts[i].point_b.z - 0.49, 1e-12);
    }
  }
}

TEST(Welds, IdsStayWhileABodySlidesOnOneBox) {
  const Shape tile = make_box(1, 1, 1), body = make_box(0.5, 0.5, 0.5);
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.flags = ABUT_UNIVERSE_WELDS;
  Universe universe(&options);
  for (const double x : {0.0, 2.0}) universe.add(tile, at(x, 0, -1), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(0.505, 0, 0.49));
  universe.add_geometry(part, body);
  const auto before = universe.step();
  ASSERT_EQ(before.size(), 8U);
  // Past the depth the wall is no longer the nearest way out of the second box, and its contacts stay the same.
  for (const double x : {0.507, 0.509, 0.511, 0.52, 0.6}) {
    universe.move(part, at(x, 0, 0.49));
    const auto after = universe.step();
    ASSERT_EQ(after.size(), before.size()) << x;
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_EQ(after[i].id, before[i].id) << x;
      EXPECT_GT(after[i].age, 0U) << x;
    }
  }
}

}  // namespace
