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

testing::AssertionResult is_null(abut_status status, std::string_view argument) {
  return refused(status, ABUT_NULL_ARGUMENT, {argument, "null"});
}

// Feeds ids of no geometry to `call`, a callable from abut_geometry_id to abut_status.
template <class Call>
void expect_stale_refused(const MeshScene& scene, Call call) {
  for (const abut_geometry_id& stale : scene.stale_geometries)
    EXPECT_TRUE(refused(call(stale), ABUT_STALE_ID, {"geometry", std::to_string(stale.slot)}));
  EXPECT_TRUE(scene.is_as_before());
}

// The same for the id of a box.
template <class Call>
void expect_box_refused(const MeshScene& scene, std::string_view subject, Call call) {
  EXPECT_TRUE(refused(call(scene.second_geometry), ABUT_UNSUPPORTED, {"geometry is a box", subject}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVertices, RefusesNullPointers) {
  const MeshScene scene;
  EXPECT_TRUE(is_null(abut_geometry_set_vertices(nullptr, scene.mesh, 0, scene.zeros.data(), 1), "universe"));
  EXPECT_TRUE(is_null(scene.move(0, nullptr, 1), "xyz"));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVertices, RefusesStaleIds) {
  const MeshScene scene;
  expect_stale_refused(scene, [&](abut_geometry_id stale) {
    return abut_geometry_set_vertices(scene.universe, stale, 0, scene.zeros.data(), 1);
  });
}

TEST(GeometrySetVertices, RefusesNonFiniteNumbers) {
  const MeshScene scene;
  expect_non_finite_refused("xyz[4]", [&](double bad) {
    const std::array xyz{1.0, 2.0, 3.0, 4.0, bad, 5.0};
    return scene.move(0, xyz.data(), 2);
  });
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

TEST(GeometrySetVertices, RefusesOverflowingCounts) {
  const MeshScene scene;
  expect_overflow_refused(3 * sizeof(double), "count",
                          [&](std::size_t count) { return scene.move(0, scene.zeros.data(), count); });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVertices, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices", [&](abut_geometry_id box) {
    return abut_geometry_set_vertices(scene.universe, box, 0, scene.zeros.data(), 1);
  });
}

TEST(GeometrySetVerticesAt, RefusesNullPointers) {
  const MeshScene scene;
  const double* const zeros = scene.zeros.data();
  const std::uint32_t* const none = scene.none.data();
  EXPECT_TRUE(is_null(abut_geometry_set_vertices_at(nullptr, scene.mesh, none, zeros, 1), "universe"));
  EXPECT_TRUE(is_null(scene.move_at(nullptr, zeros, 1), "vertices"));
  EXPECT_TRUE(is_null(scene.move_at(none, nullptr, 1), "xyz"));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVerticesAt, RefusesStaleIds) {
  const MeshScene scene;
  expect_stale_refused(scene, [&](abut_geometry_id stale) {
    return abut_geometry_set_vertices_at(scene.universe, stale, scene.none.data(), scene.zeros.data(), 1);
  });
}

TEST(GeometrySetVerticesAt, RefusesNonFiniteNumbers) {
  const MeshScene scene;
  expect_non_finite_refused("xyz[4]", [&](double bad) {
    const std::array xyz{1.0, 2.0, 3.0, 4.0, bad, 5.0};
    return scene.move_at(halves.data(), xyz.data(), 2);
  });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVerticesAt, RefusesNumbersBeyondTheLast) {
  const MeshScene scene;
  const std::array<std::uint32_t, 2> listed{3, 4};
  EXPECT_TRUE(
      refused(scene.move_at(listed.data(), scene.zeros.data(), 2), ABUT_INDEX_OUT_OF_RANGE, {"vertices[1] is 4", "4"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVerticesAt, RefusesOverflowingCounts) {
  const MeshScene scene;
  for (const std::size_t size : {sizeof(std::uint32_t), 3 * sizeof(double)}) {
    expect_overflow_refused(
        size, "count", [&](std::size_t count) { return scene.move_at(scene.none.data(), scene.zeros.data(), count); });
  }
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetVerticesAt, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices", [&](abut_geometry_id box) {
    return abut_geometry_set_vertices_at(scene.universe, box, scene.none.data(), scene.zeros.data(), 1);
  });
}

TEST(GeometryRemoveTriangles, RefusesNullPointers) {
  const MeshScene scene;
  EXPECT_TRUE(is_null(abut_geometry_remove_triangles(nullptr, scene.mesh, scene.none.data(), 1), "universe"));
  EXPECT_TRUE(is_null(scene.remove(nullptr, 1), "triangles"));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometryRemoveTriangles, RefusesStaleIds) {
  const MeshScene scene;
  expect_stale_refused(scene, [&](abut_geometry_id stale) {
    return abut_geometry_remove_triangles(scene.universe, stale, scene.none.data(), 1);
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

TEST(GeometryRemoveTriangles, RefusesOverflowingCounts) {
  const MeshScene scene;
  expect_overflow_refused(sizeof(std::uint32_t), "count",
                          [&](std::size_t count) { return scene.remove(scene.none.data(), count); });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometryRemoveTriangles, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "triangles", [&](abut_geometry_id box) {
    return abut_geometry_remove_triangles(scene.universe, box, scene.none.data(), 1);
  });
}

TEST(GeometrySetMesh, RefusesNullPointers) {
  const MeshScene scene;
  EXPECT_TRUE(is_null(abut_geometry_set_mesh(nullptr, scene.mesh, corners.data(), 4, halves.data(), 2), "universe"));
  EXPECT_TRUE(is_null(scene.remake(nullptr, 4, halves.data(), 2), "xyz"));
  EXPECT_TRUE(is_null(scene.remake(corners.data(), 4, nullptr, 2), "triangles"));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetMesh, RefusesStaleIds) {
  const MeshScene scene;
  expect_stale_refused(scene, [&](abut_geometry_id stale) {
    return abut_geometry_set_mesh(scene.universe, stale, corners.data(), 4, halves.data(), 2);
  });
}

TEST(GeometrySetMesh, RefusesNonFiniteNumbers) {
  const MeshScene scene;
  expect_non_finite_refused("xyz[8]", [&](double bad) {
    const std::array xyz{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, bad};
    return scene.remake(xyz.data(), 3, halves.data(), 1);
  });
  EXPECT_TRUE(scene.is_as_before());
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

TEST(GeometrySetMesh, RefusesOverflowingCounts) {
  const MeshScene scene;
  expect_overflow_refused(3 * sizeof(double), "vertex_count",
                          [&](std::size_t count) { return scene.remake(corners.data(), count, halves.data(), 2); });
  expect_overflow_refused(3 * sizeof(std::uint32_t), "triangle_count",
                          [&](std::size_t count) { return scene.remake(corners.data(), 4, halves.data(), count); });
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetMesh, RefusesOtherKinds) {
  const MeshScene scene;
  expect_box_refused(scene, "vertices and triangles", [&](abut_geometry_id box) {
    return abut_geometry_set_mesh(scene.universe, box, corners.data(), 4, halves.data(), 2);
  });
}

}  // namespace
