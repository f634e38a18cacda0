// picking.h: rays against a universe, compared with rays against each shape in double.
#include <abut/picking.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr abut_quat no_turn{1, 0, 0, 0};

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_picker* picker) const { abut_picker_destroy(picker); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Universe = std::unique_ptr<abut_universe, Delete>;
using PickerHandle = std::unique_ptr<abut_picker, Delete>;
using Shape = std::unique_ptr<abut_shape, Delete>;

abut_vec3 operator+(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
abut_vec3 operator-(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
abut_vec3 operator*(double s, const abut_vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }

template <class Create>
Shape shape_from(const Create& create) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(create(&shape), ABUT_OK) << abut_last_error_message();
  return Shape(shape);
}

Shape sphere(double radius) {
  return shape_from([&](abut_shape** out) { return abut_sphere_create(radius, out); });
}
Shape box(double x, double y, double z) {
  return shape_from([&](abut_shape** out) { return abut_box_create(x, y, z, out); });
}
Shape capsule(double radius, double half_height) {
  return shape_from([&](abut_shape** out) { return abut_capsule_create(radius, half_height, out); });
}
Shape plane(abut_vec3 normal, double offset) {
  return shape_from([&](abut_shape** out) { return abut_plane_create(&normal, offset, out); });
}
Shape mesh(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
  return shape_from([&](abut_shape** out) {
    return abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, out);
  });
}
Shape hull(const std::vector<double>& xyz) {
  return shape_from([&](abut_shape** out) { return abut_hull_create(xyz.data(), xyz.size() / 3, out); });
}

// A ball of triangles: a grid of longitudes and latitudes.
Shape ball_mesh(double radius, std::uint32_t count) {
  std::vector<double> xyz{0, 0, radius, 0, 0, -radius};
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t row = 1; row < count; ++row) {
    const double polar = std::numbers::pi * row / count;
    for (std::uint32_t column = 0; column < 2 * count; ++column) {
      const double azimuth = std::numbers::pi * column / count;
      xyz.insert(xyz.end(), {radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth),
                             radius * std::cos(polar)});
    }
  }
  const auto at = [&](std::uint32_t row, std::uint32_t column) { return 2 + (row - 1) * 2 * count + column % (2 * count); };
  for (std::uint32_t column = 0; column < 2 * count; ++column) {
    triangles.insert(triangles.end(), {0, at(1, column), at(1, column + 1)});
    for (std::uint32_t row = 1; row + 1 < count; ++row) {
      triangles.insert(triangles.end(), {at(row, column), at(row + 1, column), at(row + 1, column + 1)});
      triangles.insert(triangles.end(), {at(row, column), at(row + 1, column + 1), at(row, column + 1)});
    }
    triangles.insert(triangles.end(), {at(count - 1, column), 1, at(count - 1, column + 1)});
  }
  return mesh(xyz, triangles);
}

// Ground of count by count cells over [-half, half], with waves.
Shape ground_mesh(double half, std::uint32_t count, double wave) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j <= count; ++j) {
    for (std::uint32_t i = 0; i <= count; ++i) {
      const double x = half * (2.0 * i / count - 1);
      const double y = half * (2.0 * j / count - 1);
      xyz.insert(xyz.end(), {x, y, wave * std::sin(x) * std::cos(1.3 * y)});
    }
  }
  for (std::uint32_t j = 0; j < count; ++j) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = j * (count + 1) + i;
      triangles.insert(triangles.end(), {a, a + 1, a + count + 2, a, a + count + 2, a + count + 1});
    }
  }
  return mesh(xyz, triangles);
}

struct Placed {
  abut_geometry_id geometry;
  abut_part_id part;
};

class World {
 public:
  World() {
    abut_universe* universe = nullptr;
    EXPECT_EQ(abut_universe_create(nullptr, &universe), ABUT_OK);
    universe_.reset(universe);
    abut_picker* picker = nullptr;
    EXPECT_EQ(abut_picker_create(universe, &picker), ABUT_OK);
    picker_.reset(picker);
  }

  Placed add(const Shape& shape, const abut_vec3& position, const abut_quat& orientation = no_turn) {
    abut_part_options options;
    abut_part_options_init(&options);
    options.pose = {position, orientation};
    Placed placed{};
    EXPECT_EQ(abut_part_create(universe(), &options, &placed.part), ABUT_OK);
    EXPECT_EQ(abut_geometry_create(universe(), placed.part, shape.get(), nullptr, &placed.geometry), ABUT_OK);
    return placed;
  }
  void move(const Placed& placed, const abut_vec3& position, const abut_quat& orientation = no_turn) {
    const abut_pose pose{position, orientation};
    EXPECT_EQ(abut_part_set_pose(universe(), placed.part, &pose), ABUT_OK);
  }
  void remove(const Placed& placed) { EXPECT_EQ(abut_geometry_destroy(universe(), placed.geometry), ABUT_OK); }

  abut_pick pick(const abut_ray& ray) {
    abut_pick pick{};
    EXPECT_EQ(abut_picker_cast_ray(picker(), &ray, &pick), ABUT_OK) << abut_last_error_message();
    return pick;
  }
  std::vector<abut_pick> pick_all(const abut_ray& ray) {
    std::size_t count = 0;
    EXPECT_EQ(abut_picker_cast_ray_all(picker(), &ray, nullptr, 0, &count), ABUT_OK) << abut_last_error_message();
    std::vector<abut_pick> picks(count);
    EXPECT_EQ(abut_picker_cast_ray_all(picker(), &ray, picks.data(), count, &count), ABUT_OK);
    EXPECT_EQ(count, picks.size());
    return picks;
  }

  // First hit over all geometries, each asked in double.
  abut_pick brute(const abut_ray& ray) const {
    std::size_t count = 0;
    EXPECT_EQ(abut_universe_geometries(universe_.get(), nullptr, 0, &count), ABUT_OK);
    std::vector<abut_geometry_id> ids(count);
    EXPECT_EQ(abut_universe_geometries(universe_.get(), ids.data(), count, &count), ABUT_OK);
    abut_pick best{{0, 0}, {0, 0}, infinity, {0, 0, 0}, {0, 0, 0}};
    for (const abut_geometry_id id : ids) {
      abut_geometry_info info;
      abut_geometry_info_init(&info);
      EXPECT_EQ(abut_geometry_describe(universe_.get(), id, &info), ABUT_OK);
      abut_ray_hit hit{};
      std::uint32_t found = 0;
      EXPECT_EQ(abut_shape_cast_ray(info.shape, &info.pose, &ray, &hit, &found), ABUT_OK);
      if (found != 0 && hit.distance < best.distance) best = {id, hit.feature, hit.distance, hit.point, hit.normal};
    }
    return best;
  }

  abut_universe* universe() { return universe_.get(); }
  abut_picker* picker() { return picker_.get(); }

 private:
  Universe universe_;
  PickerHandle picker_;
};

bool same(const abut_geometry_id& a, const abut_geometry_id& b) { return a.slot == b.slot && a.generation == b.generation; }

// Equal up to single precision of `size`, the size of the scene: near ties may go to either.
::testing::AssertionResult agrees(const abut_pick& pick, const abut_pick& expected, double size) {
  const double tolerance = 2e-6 * size;
  if (std::isinf(pick.distance) && std::isinf(expected.distance)) {
    if (pick.geometry.slot == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "a miss that names a geometry";
  }
  if (!(std::fabs(pick.distance - expected.distance) <= tolerance)) {
    return ::testing::AssertionFailure() << "distance " << pick.distance << " of geometry " << pick.geometry.slot
                                         << ", expected " << expected.distance << " of " << expected.geometry.slot;
  }
  if (same(pick.geometry, expected.geometry) && pick.feature.index == expected.feature.index) {
    if (length(pick.normal - expected.normal) > 1e-9) {
      return ::testing::AssertionFailure() << "normal is off by " << length(pick.normal - expected.normal);
    }
    if (std::fabs(pick.distance - expected.distance) > 1e-12 * (size + expected.distance)) {
      return ::testing::AssertionFailure() << "the same feature is hit " << pick.distance - expected.distance << " away";
    }
  }
  if (length(pick.point - expected.point) > tolerance) return ::testing::AssertionFailure() << "the point is off";
  return ::testing::AssertionSuccess();
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  abut_vec3 point(double reach) { return {in(-reach, reach), in(-reach, reach), in(-reach, reach)}; }
  abut_quat turn() {
    for (;;) {
      const abut_quat q{in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)};
      const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
      if (n > 0.1 && n < 1) return {q.w / n, q.x / n, q.y / n, q.z / n};
    }
  }

 private:
  std::mt19937_64 engine_;
};

// Shapes of every kind around `centre`; all but the ground and the plane turned.
std::vector<Placed> fill(World& world, Random& random, int bodies, const abut_vec3& centre, bool with_plane) {
  std::vector<double> corners;
  for (int i = 0; i < 60; ++i) corners.push_back(random.in(-0.8, 0.8));
  const std::array shapes{sphere(0.5),         box(0.4, 0.6, 0.3),  capsule(0.2, 0.7), hull(corners),
                          ball_mesh(0.6, 6), mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0.3}, {0, 1, 2})};
  std::vector<Placed> placed;
  for (int i = 0; i < bodies; ++i) {
    const Shape& shape = shapes[static_cast<std::size_t>(i) % shapes.size()];
    placed.push_back(world.add(shape, centre + random.point(6), random.turn()));
  }
  world.add(ground_mesh(8, 24, 0.4), centre + abut_vec3{0, 0, -3});
  if (with_plane) world.add(plane({0.1, 0.2, 1}, dot({0.1, 0.2, 1}, centre) / std::sqrt(1.05) - 5), {0, 0, 0});
  return placed;
}

// Every way to ask for first hits gives what brute force gives.
void compare(World& world, Random& random, int rays, const abut_vec3& centre, double size) {
  std::vector<abut_ray> asked;
  for (int i = 0; i < rays; ++i) {
    const abut_vec3 from = centre + random.point(i % 3 == 0 ? 30 : 9);
    const abut_vec3 to = centre + random.point(5);
    asked.push_back({from, random.in(0.1, 5) * (to - from), i % 4 == 0 ? random.in(0, 20) : infinity});
  }
  std::vector<abut_pick> unrelated(asked.size());
  std::vector<abut_pick> neighbours(asked.size());
  ASSERT_EQ(abut_picker_cast_rays(world.picker(), asked.data(), asked.size(), ABUT_COHERENCE_NONE, unrelated.data()), ABUT_OK);
  ASSERT_EQ(abut_picker_cast_rays(world.picker(), asked.data(), asked.size(), ABUT_COHERENCE_NEIGHBOURS, neighbours.data()), ABUT_OK);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const abut_pick expected = world.brute(asked[i]);
    EXPECT_TRUE(agrees(world.pick(asked[i]), expected, size)) << "ray " << i;
    EXPECT_TRUE(agrees(unrelated[i], expected, size)) << "ray " << i;
    EXPECT_TRUE(agrees(neighbours[i], expected, size)) << "ray " << i;
  }
}

constexpr abut_ray along_x{{-10, 0, 0}, {1, 0, 0}, infinity};

TEST(Picker, FindsNothingInAnEmptyUniverse) {
  World world;
  const abut_pick pick = world.pick(along_x);
  EXPECT_EQ(pick.geometry.slot, 0U);
  EXPECT_TRUE(std::isinf(pick.distance));
  EXPECT_TRUE(world.pick_all(along_x).empty());
  EXPECT_EQ(abut_picker_update(world.picker()), ABUT_OK);
}

TEST(Picker, MeetsAPlaneThatIsAlone) {
  World world;
  const Placed placed = world.add(plane({-1, 0, 0}, 0), {2, 0, 0});
  const abut_pick pick = world.pick(along_x);
  EXPECT_TRUE(same(pick.geometry, placed.geometry));
  EXPECT_DOUBLE_EQ(pick.distance, 12);
  EXPECT_DOUBLE_EQ(pick.normal.x, -1);
  EXPECT_EQ(world.pick_all(along_x).size(), 1U);
}

TEST(Picker, AgreesWithEachShapeInDouble) {
  for (const std::uint64_t seed : {11U, 12U, 13U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world;
    Random random(seed);
    fill(world, random, 40, {0, 0, 0}, seed != 12);
    compare(world, random, 1500, {0, 0, 0}, 30);
  }
}

TEST(Picker, KeepsItsDigitsFarFromTheOrigin) {
  World world;
  Random random(21);
  const abut_vec3 far{1e6, -1e6, 2e6};
  fill(world, random, 40, far, false);
  compare(world, random, 1000, far, 30);
}

TEST(Picker, KeepsItsDigitsWhenPartsMoveFarAway) {
  World world;
  Random random(22);
  const std::vector<Placed> placed = fill(world, random, 40, {0, 0, 0}, false);
  compare(world, random, 200, {0, 0, 0}, 30);
  const abut_vec3 far{-1e6, 3e5, 1e6};
  for (std::size_t i = 0; i < placed.size(); i += 2) world.move(placed[i], far + random.point(6), random.turn());
  compare(world, random, 500, {0, 0, 0}, 30);
  compare(world, random, 500, far, 30);
}

TEST(Picker, FollowsWhatMovesComesAndGoes) {
  World world;
  Random random(31);
  std::vector<Placed> placed = fill(world, random, 30, {0, 0, 0}, true);
  const Shape lone = ball_mesh(1, 8);
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    for (std::size_t i = static_cast<std::size_t>(step) % 3; i < placed.size(); i += 3) {
      world.move(placed[i], random.point(6), random.turn());
    }
    if (step % 3 == 1) {
      world.remove(placed.back());
      placed.pop_back();
    }
    if (step % 4 == 2) placed.push_back(world.add(lone, random.point(4)));
    compare(world, random, 120, {0, 0, 0}, 30);
  }
}

TEST(Picker, SeesAMeshThatMovesAfterItWasBaked) {
  World world;
  const Placed ball = world.add(ball_mesh(1, 10), {0, 0, 0});
  world.add(ground_mesh(5, 8, 0), {0, 0, -4});
  EXPECT_NEAR(world.pick(along_x).distance, 9, 1e-12);
  world.move(ball, {3, 0, 0});
  EXPECT_NEAR(world.pick(along_x).distance, 12, 1e-12);
  world.remove(ball);
  EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
}

TEST(Picker, DoesNotReportAGeometryThatReplacedAnother) {
  World world;
  const Placed first = world.add(sphere(1), {0, 0, 0});
  EXPECT_TRUE(same(world.pick(along_x).geometry, first.geometry));
  world.remove(first);
  const Placed second = world.add(sphere(2), {0, 0, 0});
  EXPECT_TRUE(same(world.pick(along_x).geometry, second.geometry));
  EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 8);
}

TEST(Picker, LeavesNoCracksBetweenTriangles) {
  World world;
  Random random(41);
  world.add(ground_mesh(100, 64, 2), {0, 0, 0});
  int missed = 0;
  for (int i = 1; i < 64; ++i) {
    for (int j = 1; j < 64; ++j) {
      const double x = 100 * (2.0 * i / 64 - 1);
      const double y = 100 * (2.0 * j / 64 - 1);
      for (const double t : {0.0, 0.3, 0.7}) {
        const double step = 200.0 / 64 * t;
        for (const abut_vec3& target : {abut_vec3{x, y, 0}, {x + step, y, 0}, {x, y + step, 0}, {x + step, y + step, 0}}) {
          // From above: the ground is closed, so every ray inside of its outline must meet it.
          missed += world.pick({target + abut_vec3{0, 0, 500}, {0, 0, -1}, infinity}).geometry.slot == 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(Picker, EndsRaysAtTheirLimit) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  world.add(ball_mesh(1, 10), {0, 5, 0});
  world.add(plane({-1, 0, 0}, 0), {4, 0, 0});
  EXPECT_EQ(world.pick({{-10, 0, 0}, {3, 0, 0}, 8.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 0, 0}, {3, 0, 0}, 9.001}).geometry.slot, 0U);
  EXPECT_EQ(world.pick({{-10, 5, 0}, {3, 0, 0}, 8.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 5, 0}, {3, 0, 0}, 9.001}).geometry.slot, 0U);
  EXPECT_EQ(world.pick({{-10, 9, 0}, {3, 0, 0}, 13.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 9, 0}, {3, 0, 0}, 14.001}).geometry.slot, 0U);
}

TEST(Picker, TakesDirectionsOfAnyLength) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  world.add(ball_mesh(1, 10), {0, 5, 0});
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    EXPECT_NEAR(world.pick({{-10, 0, 0}, {size, 0, 0}, infinity}).distance, 9, 1e-9);
    EXPECT_NEAR(world.pick({{-10, 5, 0}, {size, 0, 0}, infinity}).distance, 9, 1e-9);
  }
}

TEST(Picker, MeetsTheFarSideFromInside) {
  World world;
  world.add(sphere(2), {0, 0, 0});
  world.add(box(1, 1, 1), {20, 0, 0});
  world.add(ball_mesh(1, 10), {40, 0, 0});
  EXPECT_DOUBLE_EQ(world.pick({{0, 0, 0}, {1, 0, 0}, infinity}).distance, 2);
  EXPECT_NEAR(world.pick({{20, 0.2, 0}, {1, 0, 0}, infinity}).distance, 1, 1e-12);
  EXPECT_NEAR(world.pick({{40, 0, 0}, {1, 0, 0}, infinity}).distance, 1, 1e-12);
}

TEST(CastRayAll, ReportsEachCrossingInOrder) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const Placed cube = world.add(box(1, 1, 1), {5, 0.25, 0.125});
  const Placed pill = world.add(capsule(0.5, 1), {10, 0, 0});
  const Placed still = world.add(ball_mesh(1, 10), {15, 0, 0});
  const Placed wall = world.add(plane({-1, 0, 0}, 0), {20, 0, 0});
  const std::vector<abut_pick> picks = world.pick_all(along_x);
  const std::array expected{ball, ball, cube, cube, pill, pill, still, still, wall};
  const std::array distances{9.0, 11.0, 14.0, 16.0, 19.5, 20.5, 24.0, 26.0, 30.0};
  ASSERT_EQ(picks.size(), expected.size());
  for (std::size_t i = 0; i < picks.size(); ++i) {
    EXPECT_TRUE(same(picks[i].geometry, expected[i].geometry)) << i;
    EXPECT_NEAR(picks[i].distance, distances[i], 1e-9) << i;
    EXPECT_EQ(picks[i].normal.x < 0, i % 2 == 0) << i;
  }
}

TEST(CastRayAll, CountsAnEdgeBetweenTrianglesOnce) {
  World world;
  world.add(ground_mesh(4, 8, 0), {0, 0, 0});
  const Placed moving = world.add(ground_mesh(4, 8, 0), {0, 0, 1});
  world.add(box(3, 3, 0.25), {0, 0, -2});
  (void)world.pick(along_x);
  world.move(moving, {0, 0, 2});
  // Through a vertex, an edge, a diagonal of the grounds, and the diagonal of the faces of the box.
  for (const abut_vec3& from : {abut_vec3{1, 1, 9}, {1, 0.4, 9}, {0.5, 0.5, 9}, {-0.5, -0.5, 9}}) {
    EXPECT_EQ(world.pick_all({from, {0, 0, -1}, infinity}).size(), 4U) << from.x << ' ' << from.y;
  }
}

TEST(CastRayAll, BeginsWithTheFirstHit) {
  World world;
  Random random(51);
  fill(world, random, 40, {0, 0, 0}, true);
  for (int i = 0; i < 500; ++i) {
    const abut_vec3 from = random.point(12);
    const abut_ray ray{from, random.point(4) - from, infinity};
    const std::vector<abut_pick> picks = world.pick_all(ray);
    const abut_pick first = world.pick(ray);
    ASSERT_EQ(picks.empty(), first.geometry.slot == 0);
    if (!picks.empty()) EXPECT_NEAR(picks.front().distance, first.distance, 1e-9) << i;
    for (std::size_t k = 1; k < picks.size(); ++k) EXPECT_GE(picks[k].distance, picks[k - 1].distance);
  }
}

TEST(CastRayAll, WritesNoMoreThanTheCapacity) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  std::array<abut_pick, 2> picks{};
  picks[1].distance = -7;
  std::size_t count = 0;
  ASSERT_EQ(abut_picker_cast_ray_all(world.picker(), &along_x, picks.data(), 1, &count), ABUT_OK);
  EXPECT_EQ(count, 2U);
  EXPECT_DOUBLE_EQ(picks[0].distance, 9);
  EXPECT_DOUBLE_EQ(picks[1].distance, -7);
}

abut_camera camera_at(const abut_vec3& eye, const abut_vec3& target) {
  abut_camera camera;
  abut_camera_init(&camera);
  const abut_vec3 up{0, 0, 1};
  EXPECT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
  return camera;
}

TEST(Camera, LooksAlongMinusZByDefault) {
  abut_camera camera;
  abut_camera_init(&camera);
  abut_ray ray;
  ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &ray), ABUT_OK);
  EXPECT_NEAR(ray.direction.z, -1, 1e-15);
  EXPECT_TRUE(std::isinf(ray.max_distance));
  // The upper border of the picture is half of the angle above the middle.
  ASSERT_EQ(abut_camera_ray(&camera, 320, 0, &ray), ABUT_OK);
  EXPECT_NEAR(ray.direction.y, std::sin(0.5), 1e-12);
  ASSERT_EQ(abut_camera_ray(&camera, 400, 240, &ray), ABUT_OK);
  EXPECT_GT(ray.direction.x, 0);
}

TEST(Camera, LooksAtItsTarget) {
  Random random(61);
  for (int i = 0; i < 200; ++i) {
    const abut_vec3 eye = random.point(10);
    const abut_vec3 target = random.point(10);
    const abut_vec3 up = random.point(1);
    abut_camera camera;
    abut_camera_init(&camera);
    ASSERT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
    abut_ray middle;
    ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &middle), ABUT_OK);
    const abut_vec3 sight = (1 / length(target - eye)) * (target - eye);
    EXPECT_NEAR(length(middle.direction - sight), 0, 1e-12);
    abut_ray above;
    ASSERT_EQ(abut_camera_ray(&camera, 320, 200, &above), ABUT_OK);
    EXPECT_GT(dot(above.direction - middle.direction, up), 0);
  }
}

TEST(Camera, StartsAtNearAndEndsAtFar) {
  abut_camera camera;
  abut_camera_init(&camera);
  camera.near_distance = 2;
  camera.far_distance = 5;
  abut_ray ray;
  ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &ray), ABUT_OK);
  EXPECT_NEAR(ray.origin.z, -2, 1e-15);
  EXPECT_DOUBLE_EQ(ray.max_distance, 3);
}

TEST(Render, GivesWhatTheRaysOfThePixelsGive) {
  for (const std::uint32_t width : {1U, 3U, 16U, 61U}) {
    World world;
    Random random(71);
    fill(world, random, 40, {0, 0, 0}, true);
    abut_camera camera = camera_at({9, -8, 5}, {0, 0, -1});
    camera.width = width;
    camera.height = 37;
    std::vector<abut_pick> picture(std::size_t{width} * 37);
    ASSERT_EQ(abut_picker_render(world.picker(), &camera, picture.data(), picture.size()), ABUT_OK);
    for (std::uint32_t y = 0; y < 37; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        abut_ray ray;
        ASSERT_EQ(abut_camera_ray(&camera, x + 0.5, y + 0.5, &ray), ABUT_OK);
        EXPECT_TRUE(agrees(picture[std::size_t{y} * width + x], world.brute(ray), 30)) << x << ' ' << y;
      }
    }
  }
}

TEST(PickPixel, PrefersWhatLiesUnderThePoint) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const abut_camera camera = camera_at({-10, 0, 0}, {0, 0, 0});
  abut_pick pick{};
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 20, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
  EXPECT_NEAR(pick.distance, 9, 1e-12);
}

// Shapes that are thinner than a pixel, 6 pixels to the side of what is asked for.
TEST(PickPixel, FindsThinThings) {
  const abut_camera camera = camera_at({-10, 0, 0}, {0, 0, 0});
  const double pixel = 10 * std::tan(0.5) / 240;  // size of a pixel at the distance of the shapes
  const std::array shapes{box(0.1 * pixel, 0.01 * pixel, 1),
                          capsule(0.01 * pixel, 1),
                          sphere(0.05 * pixel),
                          mesh({0, -0.01 * pixel, -1, 0, 0.01 * pixel, -1, 0, 0, 1}, {0, 1, 2}),
                          hull({0, -0.01 * pixel, -1, 0, 0.01 * pixel, -1, 0, 0, 1, 0.01, 0, 0})};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    World world;
    const Placed thin = world.add(shapes[i], {0, 6.3 * pixel, 0});
    world.add(sphere(0.5), {0, -0.5 - 9 * pixel, 0});
    abut_pick pick{};
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 0, &pick), ABUT_OK);
    EXPECT_EQ(pick.geometry.slot, 0U);
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 5, &pick), ABUT_OK);
    EXPECT_EQ(pick.geometry.slot, 0U);
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 20, &pick), ABUT_OK);
    EXPECT_TRUE(same(pick.geometry, thin.geometry));
    EXPECT_NEAR(pick.distance, 10, 0.1);
  }
}

TEST(PickPixel, FindsTheNearestOfManyAndTheHorizon) {
  World world;
  const abut_camera camera = camera_at({-10, 0, 1}, {0, 0, 1});
  const Placed ground = world.add(plane({0, 0, 1}, 0), {0, 0, 0});
  abut_pick pick{};
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 3, &pick), ABUT_OK);
  EXPECT_EQ(pick.geometry.slot, 0U);
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 8, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ground.geometry));
  const double pixel = 10 * std::tan(0.5) / 240;
  const Placed ball = world.add(sphere(0.1 * pixel), {0, 0, 1 + 7 * pixel});
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 8, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
}

TEST(Picker, AnswersManyThreadsAtOnce) {
  World world;
  Random random(81);
  const std::vector<Placed> placed = fill(world, random, 40, {0, 0, 0}, true);
  for (int round = 0; round < 4; ++round) {
    for (const Placed& body : placed) world.move(body, random.point(6), random.turn());
    std::vector<abut_ray> rays;
    std::vector<abut_pick> expected;
    for (int i = 0; i < 200; ++i) {
      const abut_vec3 from = random.point(9);
      rays.push_back({from, random.point(4) - from, infinity});
      expected.push_back(world.brute(rays.back()));
    }
    // All threads find the picker out of date and race to be the one that brings it up to date.
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = 0; i < rays.size(); ++i) {
          const std::size_t k = (i + static_cast<std::size_t>(t) * 50) % rays.size();
          abut_pick pick{};
          if (abut_picker_cast_ray(world.picker(), &rays[k], &pick) != ABUT_OK || !agrees(pick, expected[k], 30)) ++wrong;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
  }
}

// ---- bad input: a status and a message each, and nothing written ----------------------------------

::testing::AssertionResult refuses(abut_status status, abut_status expected, const std::string& named) {
  const std::string message = abut_last_error_message();
  if (status != expected) {
    return ::testing::AssertionFailure() << abut_status_name(status) << " (" << message << "), expected " << abut_status_name(expected);
  }
  if (message.find(named) == std::string::npos) return ::testing::AssertionFailure() << "no '" << named << "' in: " << message;
  return ::testing::AssertionSuccess();
}

struct BadRay {
  abut_ray ray;
  abut_status status;
  std::string named;
};

std::vector<BadRay> bad_rays() {
  return {{{{not_a_number, 0, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, infinity, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, 0, -infinity}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, 0, 0}, {not_a_number, 0, 0}, 1}, ABUT_NOT_FINITE, "direction"},
          {{{0, 0, 0}, {0, infinity, 0}, 1}, ABUT_NOT_FINITE, "direction"},
          {{{0, 0, 0}, {0, 0, -0.0}, 1}, ABUT_ZERO_VECTOR, "direction"},
          {{{0, 0, 0}, {1, 0, 0}, -1e-300}, ABUT_OUT_OF_RANGE, "max_distance"},
          {{{0, 0, 0}, {1, 0, 0}, -infinity}, ABUT_OUT_OF_RANGE, "max_distance"},
          {{{0, 0, 0}, {1, 0, 0}, not_a_number}, ABUT_NOT_FINITE, "max_distance"}};
}

TEST(BadInput, OfCreateIsRefused) {
  World world;
  abut_picker* picker = nullptr;
  EXPECT_TRUE(refuses(abut_picker_create(nullptr, &picker), ABUT_NULL_ARGUMENT, "universe"));
  EXPECT_TRUE(refuses(abut_picker_create(world.universe(), nullptr), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(abut_picker_update(nullptr), ABUT_NULL_ARGUMENT, "picker"));
  abut_picker_destroy(nullptr);
  abut_camera_init(nullptr);
}

TEST(BadInput, OfCastRayIsRefused) {
  World world;
  abut_pick pick{};
  pick.distance = -7;
  EXPECT_TRUE(refuses(abut_picker_cast_ray(nullptr, &along_x, &pick), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), nullptr, &pick), ABUT_NULL_ARGUMENT, "ray"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), &along_x, nullptr), ABUT_NULL_ARGUMENT, "out"));
  for (const BadRay& bad : bad_rays()) EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), &bad.ray, &pick), bad.status, bad.named));
  EXPECT_DOUBLE_EQ(pick.distance, -7);
}

TEST(BadInput, OfCastRaysIsRefused) {
  World world;
  std::array<abut_ray, 3> rays{along_x, along_x, along_x};
  std::array<abut_pick, 3> picks{};
  picks[0].distance = -7;
  const auto cast = [&](abut_coherence coherence) {
    return abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), coherence, picks.data());
  };
  EXPECT_TRUE(refuses(abut_picker_cast_rays(nullptr, rays.data(), 3, 0, picks.data()), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_cast_rays(world.picker(), nullptr, 3, 0, picks.data()), ABUT_NULL_ARGUMENT, "rays"));
  EXPECT_TRUE(refuses(abut_picker_cast_rays(world.picker(), rays.data(), 3, 0, nullptr), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(cast(2), ABUT_UNKNOWN_VALUE, "coherence"));
  EXPECT_TRUE(refuses(abut_picker_cast_rays(world.picker(), rays.data(), std::numeric_limits<std::size_t>::max() / 8, 0, picks.data()),
                      ABUT_SIZE_OVERFLOW, "count"));
  for (const BadRay& bad : bad_rays()) {
    rays[2] = bad.ray;
    EXPECT_TRUE(refuses(cast(ABUT_COHERENCE_NONE), bad.status, "rays[2]"));
    EXPECT_TRUE(refuses(cast(ABUT_COHERENCE_NEIGHBOURS), bad.status, bad.named));
  }
  EXPECT_DOUBLE_EQ(picks[0].distance, -7);
  EXPECT_EQ(abut_picker_cast_rays(world.picker(), nullptr, 0, 0, nullptr), ABUT_OK);
}

TEST(BadInput, OfCastRayAllIsRefused) {
  World world;
  std::size_t count = 77;
  abut_pick pick{};
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(nullptr, &along_x, &pick, 1, &count), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), nullptr, &pick, 1, &count), ABUT_NULL_ARGUMENT, "ray"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, nullptr, 1, &count), ABUT_NULL_ARGUMENT, "picks"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, &pick, 1, nullptr), ABUT_NULL_ARGUMENT, "count"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, &pick, std::numeric_limits<std::size_t>::max() / 4, &count),
                      ABUT_SIZE_OVERFLOW, "capacity"));
  for (const BadRay& bad : bad_rays()) {
    EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &bad.ray, &pick, 1, &count), bad.status, bad.named));
  }
  EXPECT_EQ(count, 77U);
}

struct BadCamera {
  abut_camera camera;
  abut_status status;
  std::string named;
};

std::vector<BadCamera> bad_cameras() {
  std::vector<BadCamera> cameras;
  const auto add = [&](abut_status status, const char* named, const auto& spoil) {
    BadCamera bad{{}, status, named};
    abut_camera_init(&bad.camera);
    spoil(bad.camera);
    cameras.push_back(bad);
  };
  add(ABUT_WRONG_STRUCT_SIZE, "struct_size", [](abut_camera& c) { c.struct_size = 0; });
  add(ABUT_WRONG_STRUCT_SIZE, "struct_size", [](abut_camera& c) { --c.struct_size; });
  add(ABUT_INVALID_ARGUMENT, "reserved", [](abut_camera& c) { c.reserved = 1; });
  add(ABUT_OUT_OF_RANGE, "width", [](abut_camera& c) { c.width = 0; });
  add(ABUT_OUT_OF_RANGE, "height", [](abut_camera& c) { c.height = 0; });
  add(ABUT_NOT_FINITE, "position", [](abut_camera& c) { c.pose.position.y = infinity; });
  add(ABUT_NOT_FINITE, "orientation", [](abut_camera& c) { c.pose.orientation.z = not_a_number; });
  add(ABUT_ZERO_VECTOR, "orientation", [](abut_camera& c) { c.pose.orientation.w = 0; });
  add(ABUT_NOT_UNIT, "orientation", [](abut_camera& c) { c.pose.orientation.w = 1.01; });
  add(ABUT_OUT_OF_RANGE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = 0; });
  add(ABUT_OUT_OF_RANGE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = std::numbers::pi; });
  add(ABUT_NOT_FINITE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = not_a_number; });
  add(ABUT_OUT_OF_RANGE, "near_distance", [](abut_camera& c) { c.near_distance = -1; });
  add(ABUT_NOT_FINITE, "near_distance", [](abut_camera& c) { c.near_distance = infinity; });
  add(ABUT_NOT_FINITE, "far_distance", [](abut_camera& c) { c.far_distance = not_a_number; });
  add(ABUT_OUT_OF_RANGE, "far_distance", [](abut_camera& c) {
    c.near_distance = 2;
    c.far_distance = 1;
  });
  return cameras;
}

TEST(BadInput, OfCamerasIsRefused) {
  World world;
  abut_ray ray = along_x;
  abut_pick pick{};
  pick.distance = -7;
  std::vector<abut_pick> picture(640 * 480, pick);
  for (const BadCamera& bad : bad_cameras()) {
    EXPECT_TRUE(refuses(abut_camera_ray(&bad.camera, 1, 1, &ray), bad.status, bad.named));
    EXPECT_TRUE(refuses(abut_picker_pick_pixel(world.picker(), &bad.camera, 1, 1, 1, &pick), bad.status, bad.named));
    EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &bad.camera, picture.data(), picture.size()), bad.status, bad.named));
  }
  EXPECT_DOUBLE_EQ(ray.origin.x, -10);
  EXPECT_DOUBLE_EQ(pick.distance, -7);
  EXPECT_DOUBLE_EQ(picture[0].distance, -7);
}

TEST(BadInput, OfCameraRayIsRefused) {
  abut_camera camera;
  abut_camera_init(&camera);
  abut_ray ray;
  EXPECT_TRUE(refuses(abut_camera_ray(nullptr, 1, 1, &ray), ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_camera_ray(&camera, 1, 1, nullptr), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(abut_camera_ray(&camera, not_a_number, 1, &ray), ABUT_NOT_FINITE, "x"));
  EXPECT_TRUE(refuses(abut_camera_ray(&camera, 1, infinity, &ray), ABUT_NOT_FINITE, "y"));
}

TEST(BadInput, OfLookAtIsRefused) {
  abut_camera camera;
  abut_camera_init(&camera);
  const abut_vec3 here{1, 2, 3};
  const abut_vec3 there{4, 5, 6};
  const abut_vec3 bad{0, not_a_number, 0};
  const abut_vec3 up{0, 0, 1};
  const abut_vec3 along{3, 3, 3};
  const abut_vec3 zero{0, 0, 0};
  EXPECT_TRUE(refuses(abut_camera_look_at(nullptr, &here, &there, &up), ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, nullptr, &there, &up), ABUT_NULL_ARGUMENT, "eye"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, nullptr, &up), ABUT_NULL_ARGUMENT, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, nullptr), ABUT_NULL_ARGUMENT, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &bad, &there, &up), ABUT_NOT_FINITE, "eye"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &bad, &up), ABUT_NOT_FINITE, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &bad), ABUT_NOT_FINITE, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &here, &up), ABUT_ZERO_VECTOR, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &along), ABUT_ZERO_VECTOR, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &zero), ABUT_ZERO_VECTOR, "up"));
  EXPECT_DOUBLE_EQ(camera.pose.orientation.w, 1);
  camera.struct_size = 3;
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &up), ABUT_WRONG_STRUCT_SIZE, "struct_size"));
}

TEST(BadInput, OfPickPixelIsRefused) {
  World world;
  abut_camera camera;
  abut_camera_init(&camera);
  abut_pick pick{};
  const auto pick_at = [&](double x, double y, double radius) {
    return abut_picker_pick_pixel(world.picker(), &camera, x, y, radius, &pick);
  };
  EXPECT_TRUE(refuses(abut_picker_pick_pixel(nullptr, &camera, 1, 1, 1, &pick), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_pick_pixel(world.picker(), nullptr, 1, 1, 1, &pick), ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_picker_pick_pixel(world.picker(), &camera, 1, 1, 1, nullptr), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(pick_at(not_a_number, 1, 1), ABUT_NOT_FINITE, "x"));
  EXPECT_TRUE(refuses(pick_at(1, not_a_number, 1), ABUT_NOT_FINITE, "y"));
  EXPECT_TRUE(refuses(pick_at(1, 1, not_a_number), ABUT_NOT_FINITE, "radius"));
  EXPECT_TRUE(refuses(pick_at(1, 1, infinity), ABUT_NOT_FINITE, "radius"));
  EXPECT_TRUE(refuses(pick_at(1, 1, -1), ABUT_OUT_OF_RANGE, "radius"));
}

TEST(BadInput, OfRenderIsRefused) {
  World world;
  abut_camera camera;
  abut_camera_init(&camera);
  std::vector<abut_pick> picture(640 * 480);
  EXPECT_TRUE(refuses(abut_picker_render(nullptr, &camera, picture.data(), picture.size()), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), nullptr, picture.data(), picture.size()), ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, nullptr, picture.size()), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, picture.data(), picture.size() - 1), ABUT_OUT_OF_RANGE, "capacity"));
  camera.width = camera.height = 0xffffffffU;
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, picture.data(), picture.size()), ABUT_SIZE_OVERFLOW, "width"));
}

TEST(BadInput, LeavesNoMessageBehindAfterASuccess) {
  World world;
  abut_pick pick{};
  ASSERT_NE(abut_picker_cast_ray(world.picker(), nullptr, &pick), ABUT_OK);
  ASSERT_NE(abut_last_error_message(), std::string());
  ASSERT_EQ(abut_picker_cast_ray(world.picker(), &along_x, &pick), ABUT_OK);
  EXPECT_EQ(abut_last_error_message(), std::string());
}

}  // namespace
