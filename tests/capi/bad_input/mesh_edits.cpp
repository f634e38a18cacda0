// SPDX-License-Identifier: Apache-2.0
// Meshes that change: what is refused, and that nothing changes then.
#include "../bad_values.hpp"
#include "../support.hpp"

namespace {

using namespace abut_test;

const std::vector<double> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::uint32_t> halves{0, 1, 2, 0, 2, 3};

// A universe with a square mesh, and how each function is called on it.
struct MeshScene : Scene {
  MeshScene() {
    mesh = universe.add(make_of_kind("mesh", {0}, corners, halves), at(9, 9, 9));
    before = snapshot(universe);
  }
  // The mesh is asked for its surface, as a snapshot does not hold it.
  bool is_as_before() const {
    std::vector<double> xyz(corners.size() + 3);
    std::vector<std::uint32_t> triangles(halves.size() + 3);
    std::size_t vertex_count = 0, triangle_count = 0;
    require(abut_shape_triangles(universe.describe(mesh).shape, xyz.data(), xyz.size() / 3, &vertex_count,
                                 triangles.data(), triangles.size() / 3, &triangle_count));
    xyz.resize(3 * vertex_count);
    triangles.resize(3 * triangle_count);
    return snapshot(universe) == before && xyz == corners && triangles == halves;
  }
  abut_status move(std::size_t first, const double* xyz, std::size_t count) const {
    return abut_geometry_set_vertices(universe, mesh, first, xyz, count);
  }
  abut_status move_at(const std::uint32_t* vertices, const double* xyz, std::size_t count) const {
    return abut_geometry_set_vertices_at(universe, mesh, vertices, xyz, count);
  }
  abut_status remove(const std::uint32_t* triangles, std::size_t count) const {
    return abut_geometry_remove_triangles(universe, mesh, triangles, count);
  }
  abut_status remake(const double* xyz, std::size_t vertex_count, const std::uint32_t* triangles,
                     std::size_t triangle_count) const {
    return abut_geometry_set_mesh(universe, mesh, xyz, vertex_count, triangles, triangle_count);
  }

  abut_geometry_id mesh{};
  std::vector<unsigned char> before;
  std::array<double, 12> zeros{};
  std::array<std::uint32_t, 6> none{};
};

// Feeds the id of a box to `call`, a callable from abut_geometry_id to abut_status.
template <class Call>
void expect_box_refused(const MeshScene& scene, std::string_view subject, Call call) {
  EXPECT_TRUE(refused(call(scene.second_geometry), ABUT_UNSUPPORTED, {"geometry is a box", subject}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVertices, RefusesNumbersBeyondTheLast) {
  const MeshScene scene;
  const double* const zeros = scene.zeros.data();
  EXPECT_TRUE(refused(scene.move(5, zeros, 0), ABUT_INDEX_OUT_OF_RANGE, {"first is 5", "4"}));
  EXPECT_TRUE(refused(scene.move(3, zeros, 2), ABUT_INDEX_OUT_OF_RANGE, {"count is 2", "1"}));
  EXPECT_TRUE(refused(scene.move(size_max, zeros, 1), ABUT_INDEX_OUT_OF_RANGE, {"first is 18446744073709551615"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVertices, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices", [&](abut_geometry_id box) {
    return abut_geometry_set_vertices(scene.universe, box, 0, scene.zeros.data(), 1);
  });
}

TEST(GeometrySetVerticesAt, RefusesNumbersBeyondTheLast) {
  const MeshScene scene;
  const std::array<std::uint32_t, 2> listed{3, 4};
  EXPECT_TRUE(
      refused(scene.move_at(listed.data(), scene.zeros.data(), 2), ABUT_INDEX_OUT_OF_RANGE, {"vertices[1] is 4", "4"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVerticesAt, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices", [&](abut_geometry_id box) {
    return abut_geometry_set_vertices_at(scene.universe, box, scene.none.data(), scene.zeros.data(), 1);
  });
}

TEST(GeometryRemoveTriangles, RefusesNumbersBeyondTheLast) {
  const MeshScene scene;
  const std::array<std::uint32_t, 2> going{0, 2};
  EXPECT_TRUE(refused(scene.remove(going.data(), 2), ABUT_INDEX_OUT_OF_RANGE, {"triangles[1] is 2", "2"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometryRemoveTriangles, RefusesToLeaveNone) {
  const MeshScene scene;
  const std::array<std::uint32_t, 3> all{1, 0, 1};
  EXPECT_TRUE(refused(scene.remove(all.data(), 3), ABUT_EMPTY, {"count is 3", "no triangle"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometryRemoveTriangles, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "triangles", [&](abut_geometry_id box) {
    return abut_geometry_remove_triangles(scene.universe, box, scene.none.data(), 1);
  });
}

TEST(GeometrySetMesh, RefusesNumbersBeyondTheLast) {
  const MeshScene scene;
  EXPECT_TRUE(
      refused(scene.remake(corners.data(), 3, halves.data(), 2), ABUT_INDEX_OUT_OF_RANGE, {"triangles[5] is 3", "3"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetMesh, RefusesMeshesWithoutTriangles) {
  const MeshScene scene;
  EXPECT_TRUE(refused(scene.remake(corners.data(), 4, nullptr, 0), ABUT_EMPTY, {"triangle_count is 0"}));
  EXPECT_TRUE(refused(scene.remake(nullptr, 0, halves.data(), 2), ABUT_EMPTY, {"vertex_count is 0"}));
  EXPECT_TRUE(refused(scene.remake(corners.data(), 4, scene.none.data(), 2), ABUT_EMPTY, {"one vertex three times"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetMesh, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices and triangles", [&](abut_geometry_id box) {
    return abut_geometry_set_mesh(scene.universe, box, corners.data(), 4, halves.data(), 2);
  });
}

}  // namespace
