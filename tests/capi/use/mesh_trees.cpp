// SPDX-License-Identifier: Apache-2.0
// Meshes that are found by other trees than the default one give the same answers, also after edits.
#include <algorithm>
#include <cmath>
#include <random>

#include "archive_support.hpp"

namespace {

using namespace abut_test;

struct Surface {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
};

// A bent tube whose triangles are long and lie at all angles.
Surface make_tube() {
  constexpr std::uint32_t around = 12, along = 40;
  Surface tube;
  for (std::uint32_t j = 0; j <= along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double a = 6.283185307179586 * i / around, b = 3.0 * j / along, r = 1 + 0.1 * std::sin(5 * b);
      tube.points.insert(tube.points.end(),
                         {(4 + r * std::cos(a)) * std::cos(b), (4 + r * std::cos(a)) * std::sin(b), r * std::sin(a)});
    }
  }
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      tube.triangles.insert(tube.triangles.end(), {a, b, d, a, d, c});
    }
  }
  return tube;
}

abut_status create(const Surface& surface, const abut_mesh_options& options, abut_shape** out) {
  return abut_mesh_create(surface.points.data(), surface.points.size() / 3, surface.triangles.data(),
                          surface.triangles.size() / 3, &options, out);
}

Shape make_mesh(const Surface& surface, abut_mesh_tree tree, abut_sides sides = ABUT_SIDES_BOTH) {
  auto options = filled_by(abut_mesh_options_init);
  options.sides = sides;
  options.tree = tree;
  abut_shape* shape = nullptr;
  require(create(surface, options, &shape));
  return Shape(shape);
}

constexpr std::array<abut_mesh_tree, 3> other_trees{ABUT_MESH_TREE_AABB, ABUT_MESH_TREE_OBB, ABUT_MESH_TREE_SPHERE};

class Poses {
 public:
  explicit Poses(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  abut_pose next() {
    abut_quat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {{uniform(-6, 6), uniform(-1, 6), uniform(-1.5, 1.5)},
            {q.w / length, q.x / length, q.y / length, q.z / length}};
  }

 private:
  std::mt19937 random_;
};

std::vector<double> sorted_distances(std::vector<abut_contact> contacts) {
  std::vector<double> distances;
  for (const abut_contact& contact : contacts) distances.push_back(contact.distance);
  std::ranges::sort(distances);
  return distances;
}

void expect_equal_answers(const abut_shape* mesh, const abut_shape* other, unsigned seed) {
  Poses poses(seed);
  std::vector<Shape> bodies;
  bodies.push_back(make_sphere(0.7));
  bodies.push_back(make_box(0.4, 0.6, 0.3));
  bodies.push_back(make_capsule(0.3, 0.8));
  bodies.push_back(make_plane({0.36, 0.48, 0.8}, 0.2));
  for (const Shape& body : bodies) {
    for (int i = 0; i < 40; ++i) {
      const abut_pose pose = poses.next();
      const auto expected = sorted_distances(contacts_of(mesh, identity, body, pose, 0.1)),
                 found = sorted_distances(contacts_of(other, identity, body, pose, 0.1));
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12);
      EXPECT_NEAR(distance_of(other, identity, body, pose), distance_of(mesh, identity, body, pose), 1e-9);
    }
  }
  for (int i = 0; i < 100; ++i) {
    abut_ray ray{{poses.uniform(-6, 6), poses.uniform(-1, 6), 5}, {poses.uniform(-1, 1), poses.uniform(-1, 1), -1}, 20};
    abut_ray_hit expected{}, found{};
    std::uint32_t is_expected = 0, is_found = 0;
    require(abut_shape_cast_ray(mesh, &identity, &ray, &expected, &is_expected));
    require(abut_shape_cast_ray(other, &identity, &ray, &found, &is_found));
    ASSERT_EQ(is_found, is_expected);
    EXPECT_EQ(found.distance, expected.distance);
  }
}

TEST(MeshTrees, GiveTheSameAnswers) {
  const Surface tube = make_tube();
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const Shape mesh = make_mesh(tube, ABUT_MESH_TREE_AUTO, sides);
    for (const abut_mesh_tree tree : other_trees) {
      SCOPED_TRACE(tree);
      expect_equal_answers(mesh, make_mesh(tube, tree, sides), 3);
    }
  }
}

TEST(MeshTrees, FollowEditsAndAreSaved) {
  constexpr unsigned seed = 8;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Surface tube = make_tube();
  for (const abut_mesh_tree tree : other_trees) {
    SCOPED_TRACE(tree);
    Universe universe;
    std::vector<abut_geometry_id> geometries;
    for (const abut_mesh_tree kind : {static_cast<abut_mesh_tree>(ABUT_MESH_TREE_AUTO), tree}) {
      geometries.push_back(universe.add_geometry(universe.add_part(identity), make_mesh(tube, kind)));
    }
    const auto shape_of = [](const abut_universe* its, abut_geometry_id geometry) {
      abut_shape* shape = nullptr;
      require(abut_geometry_shape(its, geometry, &shape));
      return Shape(shape);
    };
    const auto compare = [&](const abut_universe* its, unsigned number) {
      expect_equal_answers(shape_of(its, geometries[0]), shape_of(its, geometries[1]), number);
    };
    Poses poses(seed);
    compare(universe, 1);
    for (unsigned round = 0; round < 8; ++round) {
      const auto first = static_cast<std::size_t>(poses.uniform(0, 300));
      std::vector<double> moved(tube.points.begin() + static_cast<std::ptrdiff_t>(3 * first),
                                tube.points.begin() + static_cast<std::ptrdiff_t>(3 * (first + 20)));
      for (double& number : moved) number += poses.uniform(-0.3, 0.3);
      std::vector<std::uint32_t> gone;
      for (int i = 0; i < 15; ++i) gone.push_back(static_cast<std::uint32_t>(poses.uniform(0, 959)));
      for (const abut_geometry_id geometry : geometries) {
        require(abut_geometry_set_vertices(universe, geometry, first, moved.data(), 20));
        require(abut_geometry_remove_triangles(universe, geometry, gone.data(), gone.size()));
      }
      compare(universe, round);
    }
    const Owned again = loaded(saved(universe));
    compare(again.get(), 20);
  }
}

TEST(MeshTrees, AreRefusedByNumber) {
  const Surface tube = make_tube();
  auto options = filled_by(abut_mesh_options_init);
  abut_shape* shape = nullptr;
  options.tree = 4;
  EXPECT_EQ(create(tube, options, &shape), ABUT_UNKNOWN_VALUE);
  options.tree = 0;
  options.reserved = 1;
  EXPECT_EQ(create(tube, options, &shape), ABUT_INVALID_ARGUMENT);
  EXPECT_EQ(shape, nullptr);
  expect_kind_refused("mesh", {0, 4}, tube.points, tube.triangles, ABUT_UNKNOWN_VALUE, {"tree", "4"});
  expect_kind_refused("mesh", {0, 1, 2}, tube.points, tube.triangles, ABUT_INVALID_ARGUMENT, {"parameter_count", "3"});
}

}  // namespace
