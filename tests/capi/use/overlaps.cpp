// SPDX-License-Identifier: Apache-2.0
// Whether shapes overlap: agrees with distances and contacts for all kinds, in batches, in universes and in events.
#include <algorithm>
#include <cmath>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr std::uint64_t seed = 20261128;

// A closed surface around a cube, wound outward. `sides`: as of a mesh.
Shape make_cube_mesh(double half, double sides) {
  std::vector<double> xyz;
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (unsigned axis = 0; axis < 3; ++axis) xyz.push_back((corner >> axis & 1U) != 0 ? half : -half);
  }
  return make_of_kind("mesh", {sides}, xyz, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
}

Shape make_hilly_grid() {
  constexpr std::uint32_t side = 6;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> height(-0.3, 0.3);
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) xyz.insert(xyz.end(), {0.4 * i - 1, 0.4 * j - 1, height(engine)});
  }
  for (std::uint32_t j = 0; j + 1 < side; ++j) {
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      const std::uint32_t a = j * side + i;
      triangles.insert(triangles.end(), {a, a + 1, a + side + 1, a, a + side + 1, a + side});
    }
  }
  return make_of_kind("uv_grid", {0, 0, 1, 0, 0}, xyz, triangles);
}

Shape make_ball_field() {
  constexpr int side = 7;
  constexpr double spacing = 0.4, reach = 1.2;
  std::vector<double> values;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        values.push_back(std::hypot(spacing * i - reach, spacing * j - reach, spacing * k - reach) - 0.8);
      }
    }
  }
  return make_of_kind("distance_field",
                      {side, side, side, spacing, spacing, spacing, -reach, -reach, -reach, 0, 0, 0, 0, 0}, values);
}

std::vector<Shape> all_kinds() {
  std::vector<Shape> shapes = make_one_of_each_kind();
  shapes.push_back(make_of_kind("point", {}));
  shapes.push_back(make_of_kind("segment", {0.75}));
  shapes.push_back(make_of_kind("triangle", {0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  shapes.push_back(make_of_kind("cylinder", {0.5, 0.75}));
  shapes.push_back(make_of_kind("cone", {0.5, 0.75}));
  shapes.push_back(make_of_kind("ellipsoid", {1, 0.75, 0.5}));
  shapes.push_back(make_of_kind("particles", {0.25}, {0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  shapes.push_back(make_of_kind("particles", {0}, {0, 0, 0, 0.5, 1, 0, 0, 0.25, 0, 1, 0.5, 0.1}));
  shapes.push_back(make_cube_mesh(0.6, 1));
  shapes.push_back(make_cube_mesh(0.6, 2));
  shapes.push_back(make_hilly_grid());
  shapes.push_back(make_ball_field());
  shapes.push_back(make_composite({shapes.at(0), shapes.at(1)}, {at(1, 0, 0), at(-1, 0, 0)}));
  return shapes;
}

class Poses {
 public:
  explicit Poses(std::uint64_t number) : engine_(number) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  abut_pose next(double reach) {
    std::normal_distribution<double> normal;
    std::array<double, 4> turn{normal(engine_), normal(engine_), normal(engine_), normal(engine_)};
    const double size = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    return {{uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)},
            {turn[0] / size, turn[1] / size, turn[2] / size, turn[3] / size}};
  }

 private:
  std::mt19937_64 engine_;
};

abut_query_options options_of(double margin, std::uint32_t threads = 1) {
  abut_query_options options = filled_by(abut_query_options_init);
  options.margin = margin;
  options.threads = threads_of_build(threads);
  return options;
}

bool are_supported(const abut_shape* a, const abut_shape* b) {
  std::uint32_t answer = 0;
  EXPECT_TRUE(succeeded(abut_pair_support(abut_shape_kind_of(a), abut_shape_kind_of(b), ABUT_QUERY_CONTACTS, &answer)));
  return answer == 1;
}

// Around the border of such a surface what reaches before it may have no contact.
bool is_one_sided(const abut_shape* shape) {
  std::array<double, 8> parameters{};
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_shape_parameters(shape, parameters.data(), parameters.size(), &count)));
  const std::string_view kind = abut_shape_kind_name(abut_shape_kind_of(shape));
  return kind == "height_field" || (kind == "mesh" && parameters[0] == 1);
}

bool overlap(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b,
             double margin = 0) {
  const abut_query_options options = options_of(margin);
  std::uint32_t there = 2, back = 2;
  EXPECT_TRUE(succeeded(abut_pair_overlaps(a, &pose_a, b, &pose_b, &options, &there)));
  EXPECT_TRUE(succeeded(abut_pair_overlaps(b, &pose_b, a, &pose_a, &options, &back)));
  EXPECT_EQ(there, back) << "whichever comes first";
  return there == 1;
}

TEST(Overlaps, AreWhatTheSignedDistanceSays) {
  constexpr double doubt = 1e-8;
  constexpr int poses = 30;
  const std::vector<Shape> shapes = all_kinds();
  Poses random(seed);
  std::size_t asked = 0, yes = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      if (!are_supported(a, b)) continue;
      for (int i = 0; i < poses; ++i) {
        const abut_pose pose_a = random.next(1), pose_b = random.next(1.2);
        const double margin = i % 3 == 0 ? 0 : random.uniform(i % 3 == 1 ? 0 : -0.3, i % 3 == 1 ? 0.4 : 0);
        abut_distance truth;
        ASSERT_TRUE(succeeded(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &truth)));
        const bool is_near = std::fmax(truth.distance, truth.upper) < margin - doubt;
        if (!is_near && !(truth.lower > margin + doubt)) continue;
        ++asked;
        yes += is_near ? 1 : 0;
        EXPECT_EQ(overlap(a, pose_a, b, pose_b, margin), is_near)
            << abut_shape_kind_name(abut_shape_kind_of(a)) << " and " << abut_shape_kind_name(abut_shape_kind_of(b))
            << ", margin " << margin << ", distance " << truth.distance << ", seed " << seed;
      }
    }
  }
  EXPECT_GT(asked, 9000U);
  EXPECT_GT(yes, asked / 5);
  EXPECT_LT(yes, 4 * (asked / 5));
}

TEST(Overlaps, OfBatchesAreThoseOfEachPair) {
  constexpr std::size_t count = 1000;
  const std::vector<Shape> shapes = all_kinds();
  Poses random(seed + 1);
  std::vector<const abut_shape*> a, b;
  std::vector<abut_pose> poses_a, poses_b;
  std::vector<std::uint32_t> expected;
  while (a.size() < count) {
    const Shape &one = shapes.at(a.size() * 7 % shapes.size()), &other = shapes.at(a.size() * 5 % shapes.size());
    const abut_shape* const second = are_supported(one, other) ? other : shapes.front();
    a.push_back(one);
    b.push_back(second);
    poses_a.push_back(random.next(1));
    poses_b.push_back(random.next(1));
    expected.push_back(overlap(one, poses_a.back(), second, poses_b.back(), 0.05) ? 1 : 0);
  }
  for (const std::uint32_t threads : {1U, 3U, 0U}) {
    const abut_query_options options = options_of(0.05, threads);
    std::vector<std::uint32_t> found(count, 2);
    ASSERT_TRUE(succeeded(
        abut_pairs_overlap(a.data(), poses_a.data(), b.data(), poses_b.data(), count, &options, found.data())));
    EXPECT_EQ(found, expected) << "seed " << seed + 1;
  }
}

TEST(Overlaps, OfSolidsCountAllThatTheyEnclose) {
  const Shape sheet = make_cube_mesh(1, 0), solid = make_cube_mesh(1, 2), small = make_cube_mesh(0.25, 0);
  const Shape ball = make_sphere(0.25), box = make_box(0.2, 0.1, 0.3);
  for (const abut_shape* inside :
       {static_cast<abut_shape*>(ball), static_cast<abut_shape*>(box), static_cast<abut_shape*>(small)}) {
    EXPECT_FALSE(overlap(sheet, identity, inside, at(0.1, 0.2, 0)));
    EXPECT_TRUE(overlap(solid, identity, inside, at(0.1, 0.2, 0)));
    EXPECT_TRUE(overlap(sheet, identity, inside, at(1, 0.2, 0)));
    EXPECT_TRUE(overlap(solid, identity, inside, at(1, 0.2, 0)));
    EXPECT_FALSE(overlap(solid, identity, inside, at(1.5, 0.2, 0)));
    EXPECT_TRUE(overlap(solid, identity, inside, at(1.5, 0.2, 0), 0.5));
  }
}

TEST(Overlaps, OfSolidsWithFlushFacesAreThose) {
  const Shape cube = make_cube_mesh(1, 2);
  EXPECT_TRUE(overlap(cube, identity, cube, at(0.5, 0, 0)));
  EXPECT_TRUE(overlap(cube, identity, cube, identity));
  EXPECT_TRUE(overlap(cube, identity, cube, at(2, 0, 0))) << "touching";
  EXPECT_FALSE(overlap(cube, identity, cube, at(2.0001, 0, 0)));
}

// Nothing of the surface is near: the ground is met at its sides and below.
TEST(Overlaps, OfSolidGroundEndAtItsSidesAndItsFloor) {
  const Shape ground = make_of_kind("height_field", {3, 3, 1, 1, 0, 1}, std::vector<double>(9, 0));
  const Shape sheet = make_of_kind("height_field", {3, 3, 1, 1, 0, 0}, std::vector<double>(9, 0));
  const Shape box = make_box(0.25, 0.25, 0.25), ball = make_sphere(0.25);
  for (const abut_shape* body : {static_cast<abut_shape*>(box), static_cast<abut_shape*>(ball)}) {
    EXPECT_TRUE(overlap(ground, identity, body, at(1, 1, -1)));
    EXPECT_TRUE(overlap(ground, identity, body, at(2.2, 1, -1))) << "its centre is outside";
    EXPECT_FALSE(overlap(ground, identity, body, at(2.3, 1, -1)));
    EXPECT_TRUE(overlap(ground, identity, body, at(1, 1, -2.2)));
    EXPECT_FALSE(overlap(ground, identity, body, at(1, 1, -2.3)));
    EXPECT_FALSE(overlap(ground, identity, body, at(1, 1, 0.3)));
    EXPECT_FALSE(overlap(sheet, identity, body, at(1, 1, -1)));
  }
}

TEST(Overlaps, OfFlatMeshesInOnePlaneAreThoseOfTheirTriangles) {
  const Shape square = make_square_mesh(1);
  EXPECT_TRUE(overlap(square, identity, square, at(1.5, 0.5, 0)));
  EXPECT_FALSE(overlap(square, identity, square, at(2.25, 0.5, 0)));
  EXPECT_TRUE(overlap(square, identity, square, at(2.25, 0.5, 0), 0.26));
}

// The cavity of a block with a hole, and the wall around it.
TEST(Overlaps, OfCompositesHeedTheirHoles) {
  const Shape block = make_box(1, 1, 0.5), hole = make_of_kind("cylinder_hole", {0.5, 1, 0});
  const Shape plate = make_composite({block, hole}, {identity, identity});
  const Shape ball = make_sphere(0.25);
  EXPECT_FALSE(overlap(plate, identity, ball, identity));
  EXPECT_TRUE(overlap(plate, identity, ball, at(0.4, 0, 0)));
  EXPECT_TRUE(overlap(plate, identity, ball, at(0.75, 0.75, 0)));
  EXPECT_FALSE(overlap(plate, identity, ball, at(1.3, 0, 0)));
  EXPECT_TRUE(overlap(plate, identity, ball, identity, 0.3));
}

TEST(Overlaps, AnswerTouchesByTheMargin) {
  const Shape box = make_box(0.5, 0.5, 0.5), ball = make_sphere(0.5);
  for (const abut_shape* body : {static_cast<abut_shape*>(box), static_cast<abut_shape*>(ball)}) {
    EXPECT_TRUE(overlap(box, identity, body, at(0, 0, 1))) << "touching";
    EXPECT_FALSE(overlap(box, identity, body, at(0, 0, 1 + 1e-9)));
    EXPECT_TRUE(overlap(box, identity, body, at(0, 0, 1.25), 0.25));
    EXPECT_TRUE(overlap(box, identity, body, at(0, 0, 0.75), -0.2));
    EXPECT_FALSE(overlap(box, identity, body, at(0, 0, 0.75), -0.3));
  }
}

// What a universe finds is what has contacts. What lies behind a one-sided surface has none.
TEST(Overlaps, OfAUniverseAreWhatHasContacts) {
  constexpr double doubt = 1e-9;
  const std::vector<Shape> shapes = all_kinds();
  Poses random(seed + 2);
  std::size_t found_in_all = 0, around_borders = 0;
  for (int round = 0; round < 12; ++round) {
    Universe universe;
    std::vector<abut_geometry_id> ids;
    std::vector<abut_pose> poses;
    for (const Shape& shape : shapes) {
      poses.push_back(random.next(1.5));
      ids.push_back(universe.add_geometry(universe.add_part(poses.back()), shape));
    }
    require(abut_universe_refresh(universe));
    for (const Shape& body : shapes) {
      const abut_pose pose = random.next(1.5);
      const double margin = round % 2 == 0 ? 0 : 0.1;
      std::vector<abut_geometry_id> found(shapes.size());
      std::size_t count = 0;
      ASSERT_TRUE(succeeded(
          abut_universe_overlaps(universe, body, &pose, nullptr, margin, found.data(), found.size(), &count)));
      found.resize(count);
      found_in_all += count;
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!are_supported(body, shapes[i])) continue;
        const std::size_t more = contacts_of(body, pose, shapes[i], poses[i], margin + doubt).size(),
                          fewer = contacts_of(body, pose, shapes[i], poses[i], margin - doubt).size();
        if ((more == 0) != (fewer == 0)) continue;
        const bool is_found = std::ranges::any_of(found, [&](const abut_geometry_id& id) { return id == ids[i]; });
        if (is_found && more == 0 && (is_one_sided(body) || is_one_sided(shapes[i]))) {
          ++around_borders;
          EXPECT_LT(distance_of(body, pose, shapes[i], poses[i]), margin + doubt) << "seed " << seed + 2;
          continue;
        }
        EXPECT_EQ(is_found, more > 0) << abut_shape_kind_name(abut_shape_kind_of(body)) << " and "
                                      << abut_shape_kind_name(abut_shape_kind_of(shapes[i])) << ", margin " << margin
                                      << ", seed " << seed + 2;
      }
    }
  }
  EXPECT_GT(found_in_all, 500U);
  EXPECT_LT(around_borders, found_in_all / 100);
}

TEST(Overlaps, OfAUniverseAreNotBehindAFront) {
  Universe universe;
  const Shape front = make_of_kind("mesh", {1}, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3});
  universe.add(front, identity);
  require(abut_universe_refresh(universe));
  const Shape ball = make_sphere(0.5), box = make_box(0.5, 0.5, 0.5);
  const auto is_found = [&](const abut_shape* shape, double height, double margin) {
    const abut_pose pose = at(0.1, 0.2, height);
    std::size_t count = 0;
    EXPECT_TRUE(succeeded(abut_universe_overlaps(universe, shape, &pose, nullptr, margin, nullptr, 0, &count)));
    return count == 1;
  };
  EXPECT_TRUE(is_found(ball, 0.4, 0));
  EXPECT_TRUE(is_found(ball, 0.6, 0.2));
  EXPECT_FALSE(is_found(ball, -0.4, 0)) << "its centre is behind";
  EXPECT_TRUE(is_found(box, -0.4, 0)) << "it reaches before the front";
  EXPECT_FALSE(is_found(box, -0.6, 0.2));
  EXPECT_TRUE(overlap(front, identity, ball, at(0.1, 0.2, -0.4))) << "two shapes alone meet from either side";
}

// The events of a policy that wants no contacts are those of one that does.
TEST(Overlaps, OfAPolicyBeginAndEndWithContacts) {
  constexpr int steps = 120;
  std::vector<Shape> shapes = all_kinds();
  std::erase_if(shapes, [](const Shape& shape) { return is_one_sided(shape); });
  for (const double tolerance : {0.0, 0.01}) {
    Poses random(seed + 3);
    std::array<Universe, 2> universes;
    std::array<std::vector<abut_part_id>, 2> parts;
    for (const Shape& shape : shapes) {
      const bool is_ground = abut_shape_kind_of(shape) == abut_shape_kind_by_name("plane");
      const abut_pose pose = random.next(3);
      for (std::size_t i = 0; i < universes.size(); ++i) {
        abut_geometry_options options = default_geometry_options();
        options.tag = 1;
        options.tolerance = tolerance;
        const abut_part_id part = universes.at(i).add_part(is_ground ? at(0, 0, -3) : pose,
                                                           is_ground ? ABUT_MOTION_STATIC : ABUT_MOTION_DYNAMIC);
        universes.at(i).add_geometry(part, shape, options);
        if (!is_ground) parts.at(i).push_back(part);
      }
    }
    abut_policy policy = default_policy();
    policy.detail = ABUT_DETAIL_TOUCH;
    require(abut_policy_set(universes[1], 1, 1, &policy));
    std::size_t events = 0;
    for (int step = 0; step < steps; ++step) {
      for (std::size_t part = 0; part < parts[0].size(); ++part) {
        const abut_pose pose = random.next(2);
        for (std::size_t i = 0; i < universes.size(); ++i) universes.at(i).move(parts.at(i).at(part), pose);
      }
      const std::size_t contacts = universes[0].step().size();
      EXPECT_TRUE(universes[1].step().empty());
      EXPECT_GT(contacts, 0U);
      const std::vector<abut_event> expected = universes[0].events(), found = universes[1].events();
      events += expected.size();
      ASSERT_EQ(letters_of(found), letters_of(expected)) << "tolerance " << tolerance << ", seed " << seed + 3;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(found[i].geometry_a.slot, expected[i].geometry_a.slot) << "seed " << seed + 3;
        EXPECT_EQ(found[i].geometry_b.slot, expected[i].geometry_b.slot) << "seed " << seed + 3;
        EXPECT_EQ(found[i].contact_count, 0U);
      }
      EXPECT_EQ(universes[1].stats().touching_pairs, universes[0].stats().touching_pairs);
    }
    EXPECT_GT(events, 1000U);
  }
}

}  // namespace
