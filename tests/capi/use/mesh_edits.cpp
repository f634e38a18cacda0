// SPDX-License-Identifier: Apache-2.0
// Meshes and grids of cells that change against such that are made anew, and against all of their triangles one by one.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <tuple>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<double>& settings_of(const std::string& kind) {
  static const std::vector<double> mesh{0}, grid{0, 0, 1, 0, 0};
  return kind == "mesh" ? mesh : grid;
}

// A mesh as the test knows it. A triangle that has gone names one vertex three times.
struct Model {
  std::string kind = "mesh";
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  std::size_t vertex_count() const { return xyz.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
  bool has_gone(std::size_t triangle) const {
    return triangles.at(3 * triangle) == triangles.at(3 * triangle + 1) &&
           triangles.at(3 * triangle) == triangles.at(3 * triangle + 2);
  }
  std::vector<std::uint32_t> present() const {
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < triangle_count(); ++i) {
      if (!has_gone(i)) numbers.push_back(static_cast<std::uint32_t>(i));
    }
    return numbers;
  }
  // Without those that have gone, so that it knows nothing of them.
  Shape made_anew() const {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t number : present()) {
      left.insert(left.end(), triangles.begin() + 3 * number, triangles.begin() + 3 * number + 3);
    }
    return make_of_kind(kind.c_str(), settings_of(kind), xyz, left);
  }
  Shape triangle(std::size_t number) const {
    std::vector<double> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t vertex = 3 * triangles.at(3 * number + i);
      corners.insert(corners.end(), xyz.begin() + std::ptrdiff_t(vertex), xyz.begin() + std::ptrdiff_t(vertex) + 3);
    }
    return make_of_kind("mesh", {0}, corners, {0, 1, 2});
  }
};

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t count) { return random_() % count; }
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  abut_vec3 point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }

 private:
  std::mt19937_64 random_;
};

Model bumpy_sheet(const std::string& kind, std::uint32_t side, Numbers& random) {
  Model model;
  model.kind = kind;
  for (std::uint32_t j = 0; j <= side; ++j) {
    for (std::uint32_t i = 0; i <= side; ++i) {
      model.xyz.insert(model.xyz.end(), {4.0 * i / side - 2, 4.0 * j / side - 2, random.between(-0.3, 0.3)});
      if (i < side && j < side) {
        const std::uint32_t k = j * (side + 1) + i;
        model.triangles.insert(model.triangles.end(), {k, k + 1, k + side + 2, k, k + side + 2, k + side + 1});
      }
    }
  }
  return model;
}

struct Edited {
  Edited(const std::string& kind, std::uint64_t seed, std::uint32_t side = 11)
      : random(seed), model(bumpy_sheet(kind, side, random)) {
    mesh = universe.add(make_of_kind(kind.c_str(), settings_of(kind), model.xyz, model.triangles), identity,
                        ABUT_MOTION_STATIC);
    for (int i = 0; i < 6; ++i) universe.add(make_sphere(0.4), {random.point(1.5), no_rotation});
  }
  const abut_shape* shape() const { return universe.describe(mesh).shape; }

  // A vertex of a grid goes up or down.
  abut_vec3 moved(std::size_t vertex, double reach) {
    abut_vec3 place = random.point(reach);
    if (model.kind == "uv_grid") place.x = place.y = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double by = axis == 0 ? place.x : axis == 1 ? place.y : place.z;
      model.xyz.at(3 * vertex + axis) += by;
    }
    return {model.xyz.at(3 * vertex), model.xyz.at(3 * vertex + 1), model.xyz.at(3 * vertex + 2)};
  }
  void move_range(double reach) {
    const std::size_t first = random.below(model.vertex_count() + 1);
    const std::size_t count = random.below(std::min<std::size_t>(model.vertex_count() - first, 30) + 1);
    for (std::size_t i = first; i < first + count; ++i) moved(i, reach);
    require(abut_geometry_set_vertices(universe, mesh, first, std::span(model.xyz).subspan(3 * first).data(), count));
  }
  void move_list(double reach) {
    std::vector<std::uint32_t> vertices;
    std::vector<abut_vec3> places;
    for (std::size_t i = random.below(9); i > 0; --i) {
      vertices.push_back(static_cast<std::uint32_t>(random.below(model.vertex_count())));
      places.push_back(moved(vertices.back(), reach));
    }
    require(abut_geometry_set_vertices_at(universe, mesh, vertices.data(), places.empty() ? nullptr : &places.front().x,
                                          vertices.size()));
  }
  // All at once, by numbers or by the vertices that the universe lends.
  void move_all(double reach) {
    for (std::size_t i = 0; i < model.vertex_count(); ++i) moved(i, reach);
    require(abut_geometry_set_vertices(universe, mesh, 0, model.xyz.data(), model.vertex_count()));
  }
  void advance(double reach) {
    double* next = nullptr;
    std::size_t count = 0;
    require(abut_geometry_next_vertices(universe, mesh, &next, &count));
    ASSERT_EQ(count, model.vertex_count());
    for (std::size_t i = 0; i < count; ++i) moved(i, reach);
    std::copy(model.xyz.begin(), model.xyz.end(), next);
    require(abut_geometry_advance(universe, mesh));
  }
  void remove() {
    std::vector<std::uint32_t> going;
    for (std::size_t i = random.below(12); i > 0; --i) {
      going.push_back(static_cast<std::uint32_t>(random.below(model.triangle_count())));
    }
    require(abut_geometry_remove_triangles(universe, mesh, going.data(), going.size()));
    for (const std::uint32_t triangle : going) {
      model.triangles.at(3 * triangle + 1) = model.triangles.at(3 * triangle + 2) = model.triangles.at(3 * triangle);
    }
  }
  void make_anew() {
    model = bumpy_sheet(model.kind, static_cast<std::uint32_t>(7 + random.below(6)), random);
    require(abut_geometry_set_mesh(universe, mesh, model.xyz.data(), model.vertex_count(), model.triangles.data(),
                                   model.triangle_count()));
  }
  void change() {
    switch (random.below(14)) {
      case 12: return move_all(random.below(3) == 0 ? 2 : 0.1);
      case 13: return advance(random.below(3) == 0 ? 2 : 0.1);
      case 0: return make_anew();
      case 1: return move_range(2);
      case 2:
      case 3: return remove();
      case 4:
      case 5:
      case 6: return move_range(0.1);
      default: return move_list(0.3);
    }
  }

  Numbers random;
  Model model;
  Universe universe;
  abut_geometry_id mesh{};
};

void expect_same_box(const abut_shape* edited, const abut_shape* anew) {
  abut_aabb one{}, other{};
  require(abut_shape_aabb(edited, &identity, &one));
  require(abut_shape_aabb(anew, &identity, &other));
  EXPECT_EQ(std::memcmp(&one, &other, sizeof one), 0);
}

void expect_same_rays(Edited& scene, const abut_shape* anew, const std::vector<Shape>& parts,
                      const std::vector<std::uint32_t>& numbers) {
  for (int i = 0; i < 8; ++i) {
    const abut_vec3 origin = scene.random.point(3), aim = scene.random.point(1.5);
    const abut_ray ray{origin, {aim.x - origin.x, aim.y - origin.y, aim.z - origin.z}, 9};
    abut_ray_hit one{}, other{}, part{};
    std::uint32_t is_hit = 0, is_hit_anew = 0, is_part_hit = 0;
    require(abut_shape_cast_ray(scene.shape(), &identity, &ray, &one, &is_hit));
    require(abut_shape_cast_ray(anew, &identity, &ray, &other, &is_hit_anew));
    ASSERT_EQ(is_hit, is_hit_anew);
    double nearest = infinity;
    for (const Shape& its : parts) {
      require(abut_shape_cast_ray(its, &identity, &ray, &part, &is_part_hit));
      if (is_part_hit != 0) nearest = std::min(nearest, part.distance);
    }
    ASSERT_EQ(is_hit != 0, nearest < infinity);
    if (is_hit == 0) continue;
    EXPECT_EQ(one.distance, other.distance);
    EXPECT_EQ(one.distance, nearest);
    EXPECT_EQ(one.feature.index, numbers.at(other.feature.index));
  }
}

void expect_same_distances(Edited& scene, const abut_shape* anew, const std::vector<Shape>& parts) {
  const std::array<Shape, 2> probes{make_sphere(0.3), make_box(0.2, 0.3, 0.4)};
  for (int i = 0; i < 6; ++i) {
    const Shape& probe = probes.at(std::size_t(i % 2));
    const abut_pose pose{scene.random.point(2.5), no_rotation};
    const double found = distance_of(scene.shape(), identity, probe, pose);
    EXPECT_NEAR(found, distance_of(anew, identity, probe, pose), 1e-12);
    double nearest = infinity;
    for (const Shape& its : parts) nearest = std::min(nearest, distance_of(its, identity, probe, pose));
    EXPECT_NEAR(std::max(found, 0.0), std::max(nearest, 0.0), 1e-12);
  }
}

// The deepest contact of each ball, by a universe that has seen all edits and by one that sees the last mesh alone.
void expect_same_touches(Edited& scene, const abut_shape* anew) {
  const std::vector<abut_contact> contacts = scene.universe.step();
  for (std::uint32_t slot = 2; slot < 8; ++slot) {
    double deepest = infinity, expected = infinity;
    abut_pose pose = identity;
    for (const abut_contact& contact : contacts) {
      const bool is_of_mesh = contact.geometry_a.slot == 1 || contact.geometry_b.slot == 1;
      if (is_of_mesh && (contact.geometry_a.slot == slot || contact.geometry_b.slot == slot)) {
        deepest = std::min(deepest, contact.distance);
      }
    }
    std::vector<abut_geometry_id> ids(8);
    std::size_t count = 0;
    require(abut_universe_geometries(scene.universe, ids.data(), ids.size(), &count));
    require(abut_geometries_poses(scene.universe, &ids.at(slot - 1), 1, &pose));
    for (const abut_contact& contact : contacts_of(anew, identity, make_sphere(0.4), pose)) {
      expected = std::min(expected, contact.distance);
    }
    if (deepest < infinity || expected < infinity) EXPECT_NEAR(deepest, expected, 1e-12) << "ball " << slot;
  }
}

class MeshEditing : public testing::TestWithParam<std::tuple<std::string, std::uint64_t>> {};

TEST_P(MeshEditing, AnswersAsAMeshMadeAnewAndAsItsTriangles) {
  const auto& [kind, seed] = GetParam();
  Edited scene(kind, seed);
  abut_shape* held = nullptr;
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(kind + ", seed " + std::to_string(seed) + ", round " + std::to_string(round));
    for (std::size_t i = 0; i <= scene.random.below(3); ++i) scene.change();
    const Shape anew = scene.model.made_anew();
    const std::vector<std::uint32_t> numbers = scene.model.present();
    std::vector<Shape> parts;
    for (const std::uint32_t number : numbers) parts.push_back(scene.model.triangle(number));
    expect_same_box(scene.shape(), anew);
    expect_same_rays(scene, anew, parts, numbers);
    expect_same_distances(scene, anew, parts);
    expect_same_touches(scene, anew);
    if (HasFailure()) return;
    // The next change makes a copy.
    if (scene.random.below(5) == 0) require(abut_geometry_shape(scene.universe, scene.mesh, &held));
    abut_shape_release(std::exchange(held, nullptr));
  }
}

INSTANTIATE_TEST_SUITE_P(Random, MeshEditing,
                         testing::Combine(testing::Values("mesh", "uv_grid"),
                                          testing::Range(std::uint64_t{1}, std::uint64_t{7})));

// Places of a large mesh are torn up one after the other, so that parts of its tree wear and are made anew.
TEST(MeshEditing, OfOnePlaceAfterTheOtherAnswersAsAMeshMadeAnew) {
  Edited scene("mesh", 11, 70);
  const std::vector<double> flat = scene.model.xyz;
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const abut_vec3 middle = scene.random.point(2);
    std::vector<std::uint32_t> vertices;
    std::vector<double> places;
    for (std::uint32_t i = 0; i < scene.model.vertex_count(); ++i) {
      if (std::hypot(flat.at(3 * i) - middle.x, flat.at(3 * i + 1) - middle.y) > 0.5) continue;
      const abut_vec3 place = scene.random.point(0.5);
      vertices.push_back(i);
      places.insert(places.end(), {middle.x + place.x, middle.y + place.y, 2 * place.z});
      std::copy(places.end() - 3, places.end(), scene.model.xyz.begin() + 3 * std::ptrdiff_t(i));
    }
    require(abut_geometry_set_vertices_at(scene.universe, scene.mesh, vertices.data(), places.data(), vertices.size()));
    const Shape anew = scene.model.made_anew();
    expect_same_box(scene.shape(), anew);
    expect_same_touches(scene, anew);
    const Shape probe = make_box(0.2, 0.3, 0.4);
    for (int i = 0; i < 50; ++i) {
      const abut_vec3 origin = scene.random.point(3), aim = scene.random.point(1.5);
      const abut_ray ray{origin, {aim.x - origin.x, aim.y - origin.y, aim.z - origin.z}, 9};
      abut_ray_hit one{}, other{};
      std::uint32_t is_hit = 0, is_hit_anew = 0;
      require(abut_shape_cast_ray(scene.shape(), &identity, &ray, &one, &is_hit));
      require(abut_shape_cast_ray(anew, &identity, &ray, &other, &is_hit_anew));
      ASSERT_EQ(is_hit, is_hit_anew);
      EXPECT_EQ(one.distance, other.distance);
      EXPECT_EQ(one.feature.index, other.feature.index);
      const abut_pose pose{scene.random.point(2.5), no_rotation};
      EXPECT_NEAR(distance_of(scene.shape(), identity, probe, pose), distance_of(anew, identity, probe, pose), 1e-12);
    }
    if (HasFailure()) return;
  }
}

// Flat ground of 40 x 40 cells with a ball on each fourth vertex.
struct Ground {
  explicit Ground(const std::string& kind) {
    model.kind = kind;
    for (std::uint32_t j = 0; j <= 40; ++j) {
      for (std::uint32_t i = 0; i <= 40; ++i) {
        model.xyz.insert(model.xyz.end(), {double(i), double(j), i + j == 0 ? -2.0 : i + j == 80 ? 2.0 : 0.0});
        const std::uint32_t k = j * 41 + i;
        if (i < 40 && j < 40) model.triangles.insert(model.triangles.end(), {k, k + 1, k + 42, k, k + 42, k + 41});
      }
    }
    mesh = universe.add(make_of_kind(kind.c_str(), settings_of(kind), model.xyz, model.triangles), identity,
                        ABUT_MOTION_STATIC);
    for (int j = 2; j < 40; j += 4) {
      for (int i = 2; i < 40; i += 4) universe.add(make_sphere(0.5), at(i, j, 0.49));
    }
    universe.step();
  }
  Model model;
  Universe universe;
  abut_geometry_id mesh{};
};

class MeshEdits : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Kind, MeshEdits, testing::Values("mesh", "uv_grid"));

TEST_P(MeshEdits, OnlyPairsNearTheChangeAreExamined) {
  Ground scene(GetParam());
  ASSERT_EQ(scene.universe.stats().touching_pairs, 100U);
  const std::array lower{10.0, 10.0, -1.5};
  ASSERT_TRUE(succeeded(abut_geometry_set_vertices(scene.universe, scene.mesh, 10 * 41 + 10, lower.data(), 1)));
  scene.universe.step();
  EXPECT_EQ(scene.universe.stats().touching_pairs, 99U);
  EXPECT_EQ(scene.universe.stats().examined_pairs, 1U);
  const std::array<std::uint32_t, 1> going{2 * (20 * 40 + 20)};
  ASSERT_TRUE(succeeded(abut_geometry_remove_triangles(scene.universe, scene.mesh, going.data(), 1)));
  scene.universe.step();
  EXPECT_LE(scene.universe.stats().examined_pairs, 1U);
  scene.universe.step();
  EXPECT_EQ(scene.universe.stats().examined_pairs, 0U);
}

TEST_P(MeshEdits, ContactsKeepIdsWhereTrianglesStay) {
  Ground scene(GetParam());
  const auto ids = [&] {
    std::vector<std::uint64_t> all;
    for (const abut_contact& contact : scene.universe.contacts()) all.push_back(contact.id);
    return all;
  };
  const std::vector<std::uint64_t> before = ids();
  ASSERT_TRUE(
      succeeded(abut_geometry_set_mesh(scene.universe, scene.mesh, scene.model.xyz.data(), scene.model.vertex_count(),
                                       scene.model.triangles.data(), scene.model.triangle_count())));
  scene.universe.step();
  EXPECT_EQ(ids(), before);
  for (const abut_contact& contact : scene.universe.contacts()) EXPECT_EQ(contact.age, 1U);
}

TEST_P(MeshEdits, WhatLayOnARemovedTriangleFalls) {
  Universe universe;
  const abut_geometry_id mesh = universe.add(make_of_kind(GetParam().c_str(), settings_of(GetParam()),
                                                          {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}),
                                             identity, ABUT_MOTION_STATIC);
  universe.add(make_sphere(0.1), at(0.7, 0.3, 0.05));
  EXPECT_EQ(universe.step().size(), 1U);
  const std::uint32_t first = 0;
  ASSERT_TRUE(succeeded(abut_geometry_remove_triangles(universe, mesh, &first, 1)));
  EXPECT_TRUE(universe.step().empty());
  std::array<std::uint32_t, 6> triangles{};
  std::array<double, 12> xyz{};
  std::size_t vertices = 0, count = 0;
  require(abut_shape_triangles(universe.describe(mesh).shape, xyz.data(), 4, &vertices, triangles.data(), 2, &count));
  EXPECT_EQ(triangles, (std::array<std::uint32_t, 6>{0, 0, 0, 0, 2, 3}));
}

// Two sheets of small triangles, and two triangles far away that hold the box of the mesh.
TEST(MeshEdits, OnTheWayOutOfADeepBallAreSeen) {
  constexpr std::uint32_t side = 25, sheet = side * side;
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < 2 * sheet; ++i) {
    xyz.insert(xyz.end(), {0.05 * (i % side) - 0.6, 0.05 * (i % sheet / side) - 0.6, i < sheet ? 0 : 0.7});
    if (i % side + 1 < side && i % sheet / side + 1 < side) {
      triangles.insert(triangles.end(), {i, i + 1, i + side + 1, i, i + side + 1, i + side});
    }
  }
  for (const double height : {-2, 2}) {
    const auto first = static_cast<std::uint32_t>(xyz.size() / 3);
    xyz.insert(xyz.end(), {3, 3, height, 3.05, 3, height, 3, 3.05, height});
    triangles.insert(triangles.end(), {first, first + 1, first + 2});
  }
  Universe universe;
  const Shape ball = make_sphere(0.3);
  abut_shape* made = nullptr;
  require(abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &made));
  const abut_geometry_id mesh = universe.add(Shape(made), identity, ABUT_MOTION_STATIC);
  universe.add(ball, at(0, 0, 0.1));
  ASSERT_FALSE(universe.step().empty());
  EXPECT_NEAR(universe.contacts().front().distance, -0.2, 1e-9);
  // The upper sheet comes down to where the ball would have been pushed.
  std::vector<double> lowered(xyz.begin() + 3 * sheet, xyz.begin() + 6 * sheet);
  for (std::size_t i = 2; i < lowered.size(); i += 3) lowered[i] = 0.5;
  require(abut_geometry_set_vertices(universe, mesh, sheet, lowered.data(), sheet));
  ASSERT_FALSE(universe.step().empty());
  EXPECT_NEAR(universe.contacts().front().distance, -0.4, 1e-9);
  EXPECT_NEAR(universe.contacts().front().normal.z, -1, 1e-9);
}

}  // namespace
