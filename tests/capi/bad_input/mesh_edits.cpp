// SPDX-License-Identifier: Apache-2.0
// Meshes that change: what is refused, and that nothing changes then.
#include "../bad_values.hpp"
#include "../support.hpp"

namespace {

using namespace abut_test;

const std::vector<double> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::uint32_t> halves{0, 1, 2, 0, 2, 3};

struct MeshScene : Scene {
  MeshScene() {
    mesh = universe.add(make_of_kind("mesh", {0}, corners, halves), at(9, 9, 9));
    before = snapshot(universe);
    box = box_of_mesh();
  }
  abut_aabb box_of_mesh() const {
    abut_aabb its{};
    require(abut_shape_aabb(universe.describe(mesh).shape, &identity, &its));
    return its;
  }
  bool is_as_before() const {
    const abut_aabb its = box_of_mesh();
    return snapshot(universe) == before && its.maximum.x == box.maximum.x && its.minimum.z == box.minimum.z;
  }
  abut_geometry_id mesh{};
  std::vector<unsigned char> before;
  abut_aabb box{};
  std::array<double, 12> zeros{};
  std::array<std::uint32_t, 6> none{};
};

TEST(MeshEdits, RefuseNullPointers) {
  const MeshScene scene;
  const double* const zeros = scene.zeros.data();
  const std::uint32_t* const none = scene.none.data();
  EXPECT_TRUE(refused(abut_geometry_set_vertices(nullptr, scene.mesh, 0, zeros, 1), ABUT_NULL_ARGUMENT, {"universe"}));
  EXPECT_TRUE(
      refused(abut_geometry_set_vertices(scene.universe, scene.mesh, 0, nullptr, 1), ABUT_NULL_ARGUMENT, {"xyz"}));
  EXPECT_TRUE(
      refused(abut_geometry_set_vertices_at(nullptr, scene.mesh, none, zeros, 1), ABUT_NULL_ARGUMENT, {"universe"}));
  EXPECT_TRUE(refused(abut_geometry_set_vertices_at(scene.universe, scene.mesh, nullptr, zeros, 1), ABUT_NULL_ARGUMENT,
                      {"vertices"}));
  EXPECT_TRUE(refused(abut_geometry_set_vertices_at(scene.universe, scene.mesh, none, nullptr, 1), ABUT_NULL_ARGUMENT,
                      {"xyz"}));
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(nullptr, scene.mesh, none, 1), ABUT_NULL_ARGUMENT, {"universe"}));
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(scene.universe, scene.mesh, nullptr, 1), ABUT_NULL_ARGUMENT,
                      {"triangles"}));
  EXPECT_TRUE(
      refused(abut_geometry_set_mesh(nullptr, scene.mesh, zeros, 3, none, 1), ABUT_NULL_ARGUMENT, {"universe"}));
  EXPECT_TRUE(
      refused(abut_geometry_set_mesh(scene.universe, scene.mesh, nullptr, 3, none, 1), ABUT_NULL_ARGUMENT, {"xyz"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.mesh, zeros, 3, nullptr, 1), ABUT_NULL_ARGUMENT,
                      {"triangles"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseStaleIds) {
  const MeshScene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    const std::string slot = std::to_string(stale.slot);
    const auto is_stale = [&](abut_status status) { return refused(status, ABUT_STALE_ID, {"geometry", slot}); };
    EXPECT_TRUE(is_stale(abut_geometry_set_vertices(scene.universe, stale, 0, scene.zeros.data(), 1)));
    EXPECT_TRUE(
        is_stale(abut_geometry_set_vertices_at(scene.universe, stale, scene.none.data(), scene.zeros.data(), 1)));
    EXPECT_TRUE(is_stale(abut_geometry_remove_triangles(scene.universe, stale, scene.none.data(), 1)));
    EXPECT_TRUE(is_stale(abut_geometry_set_mesh(scene.universe, stale, corners.data(), 4, halves.data(), 2)));
  }
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseNonFiniteNumbers) {
  const MeshScene scene;
  expect_non_finite_refused("xyz[4]", [&](double bad) {
    const std::array xyz{1.0, 2.0, 3.0, 4.0, bad, 5.0};
    return abut_geometry_set_vertices(scene.universe, scene.mesh, 0, xyz.data(), 2);
  });
  expect_non_finite_refused("xyz[4]", [&](double bad) {
    const std::array xyz{1.0, 2.0, 3.0, 4.0, bad, 5.0};
    return abut_geometry_set_vertices_at(scene.universe, scene.mesh, halves.data(), xyz.data(), 2);
  });
  expect_non_finite_refused("xyz[8]", [&](double bad) {
    const std::array xyz{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, bad};
    return abut_geometry_set_mesh(scene.universe, scene.mesh, xyz.data(), 3, halves.data(), 1);
  });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseNumbersBeyondTheLast) {
  const MeshScene scene;
  const auto move = [&](std::size_t first, std::size_t count) {
    return abut_geometry_set_vertices(scene.universe, scene.mesh, first, scene.zeros.data(), count);
  };
  EXPECT_TRUE(refused(move(5, 0), ABUT_INDEX_OUT_OF_RANGE, {"first is 5", "4"}));
  EXPECT_TRUE(refused(move(3, 2), ABUT_INDEX_OUT_OF_RANGE, {"count is 2", "1"}));
  EXPECT_TRUE(refused(move(size_max, 1), ABUT_INDEX_OUT_OF_RANGE, {"first is 18446744073709551615"}));
  const std::array<std::uint32_t, 2> listed{3, 4};
  EXPECT_TRUE(refused(abut_geometry_set_vertices_at(scene.universe, scene.mesh, listed.data(), scene.zeros.data(), 2),
                      ABUT_INDEX_OUT_OF_RANGE, {"vertices[1] is 4", "4"}));
  const std::array<std::uint32_t, 2> going{0, 2};
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(scene.universe, scene.mesh, going.data(), 2),
                      ABUT_INDEX_OUT_OF_RANGE, {"triangles[1] is 2", "2"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.mesh, corners.data(), 3, halves.data(), 2),
                      ABUT_INDEX_OUT_OF_RANGE, {"triangles[5] is 3", "3"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseToLeaveNoTriangle) {
  const MeshScene scene;
  const std::array<std::uint32_t, 3> all{1, 0, 1};
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(scene.universe, scene.mesh, all.data(), 3), ABUT_EMPTY,
                      {"count is 3", "no triangle"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.mesh, corners.data(), 4, nullptr, 0), ABUT_EMPTY,
                      {"triangle_count is 0"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.mesh, nullptr, 0, halves.data(), 2), ABUT_EMPTY,
                      {"vertex_count is 0"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.mesh, corners.data(), 4, scene.none.data(), 2),
                      ABUT_EMPTY, {"one vertex three times"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseOverflowingCounts) {
  const MeshScene scene;
  expect_overflow_refused(3 * sizeof(double), "count", [&](std::size_t count) {
    return abut_geometry_set_vertices(scene.universe, scene.mesh, 0, scene.zeros.data(), count);
  });
  expect_overflow_refused(3 * sizeof(double), "vertex_count", [&](std::size_t count) {
    return abut_geometry_set_mesh(scene.universe, scene.mesh, scene.zeros.data(), count, scene.none.data(), 1);
  });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(MeshEdits, RefuseOtherKinds) {
  const MeshScene scene;
  const abut_geometry_id box = scene.second_geometry;
  EXPECT_TRUE(refused(abut_geometry_set_vertices(scene.universe, box, 0, scene.zeros.data(), 1), ABUT_UNSUPPORTED,
                      {"geometry", "box", "vertices"}));
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(scene.universe, box, scene.none.data(), 1), ABUT_UNSUPPORTED,
                      {"geometry", "box", "triangles"}));
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, box, corners.data(), 4, halves.data(), 2),
                      ABUT_UNSUPPORTED, {"geometry", "box", "vertices and triangles"}));
  EXPECT_TRUE(scene.is_as_before());
}

}  // namespace
