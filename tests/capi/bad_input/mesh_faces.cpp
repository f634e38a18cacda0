// SPDX-License-Identifier: Apache-2.0
// Faces of meshes and reports on them under bad input.
#include <limits>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 12> square{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
constexpr std::array<std::uint32_t, 6> halves{0, 1, 2, 0, 2, 3};

abut_mesh_options usual_options() {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  return options;
}
abut_mesh_report empty_report() {
  abut_mesh_report report;
  abut_mesh_report_init(&report, sizeof report);
  return report;
}

// Each function that reads faces answers the same.
void expect_refused(const std::uint32_t* faces, std::size_t count, const abut_mesh_options& options, abut_status status,
                    std::initializer_list<std::string_view> words) {
  Out<abut_shape*> shape;
  Out<abut_mesh_report> report(empty_report());
  abut_uv_grid_options cells;
  abut_uv_grid_options_init(&cells, sizeof cells);
  cells.corners = options.corners;
  cells.merges_vertices = options.merges_vertices;
  cells.merge_distance = options.merge_distance;
  EXPECT_TRUE(refused(abut_mesh_create(square.data(), 4, faces, count, &options, shape.address()), status, words));
  EXPECT_TRUE(refused(abut_uv_grid_create(square.data(), 4, faces, count, &cells, shape.address()), status, words));
  EXPECT_TRUE(refused(abut_mesh_describe(square.data(), 4, faces, count, &options, report.address()), status, words));
  EXPECT_TRUE(shape.is_untouched());
  EXPECT_TRUE(report.is_untouched());
}

TEST(MeshFaces, HaveThreeOrFourCorners) {
  for (const std::uint32_t corners : {0U, 2U, 5U, 0xFFFFFFFFU}) {
    abut_mesh_options options = usual_options();
    options.corners = corners;
    expect_refused(halves.data(), 2, options, ABUT_UNKNOWN_VALUE,
                   {"options.corners is ", std::to_string(corners), "3 or 4"});
  }
}

TEST(MeshFaces, AreRefusedWithIndicesPastTheVertices) {
  constexpr std::array<std::uint32_t, 8> quads{0, 1, 2, 3, 0, 1, 4, 3};
  abut_mesh_options options = usual_options();
  options.corners = 4;
  expect_refused(quads.data(), 2, options, ABUT_INDEX_OUT_OF_RANGE, {"triangles[6] is 4"});
  constexpr std::array<std::uint32_t, 6> past{0, 1, 2, 0, 2, 4};
  options = usual_options();
  expect_refused(past.data(), 2, options, ABUT_INDEX_OUT_OF_RANGE, {"triangles[5] is 4"});
  options.merges_vertices = 1;
  expect_refused(past.data(), 2, options, ABUT_INDEX_OUT_OF_RANGE, {"triangles[5] is 4"});
}

TEST(MeshFaces, MergeWithinADistanceThatIsOne) {
  abut_mesh_options options = usual_options();
  options.merges_vertices = 2;
  expect_refused(halves.data(), 2, options, ABUT_UNKNOWN_VALUE, {"options.merges_vertices is 2"});
  options.merges_vertices = 1;
  options.merge_distance = -0.5;
  expect_refused(halves.data(), 2, options, ABUT_OUT_OF_RANGE, {"options.merge_distance is -0.5"});
  options.merge_distance = std::numeric_limits<double>::quiet_NaN();
  expect_refused(halves.data(), 2, options, ABUT_NOT_FINITE, {"options.merge_distance is nan"});
  options.merge_distance = 5;
  expect_refused(halves.data(), 2, options, ABUT_EMPTY, {"options.merge_distance is 5", "no triangle"});
}

TEST(MeshDescribe, RefusesWhatIsNoMesh) {
  Out<abut_mesh_report> out(empty_report());
  EXPECT_TRUE(refused(abut_mesh_describe(square.data(), 0, halves.data(), 2, nullptr, out.address()), ABUT_EMPTY,
                      {"vertex_count is 0"}));
  EXPECT_TRUE(refused(abut_mesh_describe(square.data(), 4, halves.data(), 0, nullptr, out.address()), ABUT_EMPTY,
                      {"triangle_count is 0"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshReportInit, IgnoresNull) { abut_mesh_report_init(nullptr, 0); }

TEST(MeshReportInit, FillsInSizeAndZeroes) {
  EXPECT_EQ(empty_report().struct_size, sizeof(abut_mesh_report));
  EXPECT_EQ(empty_report().components, 0U);
}

// A grid of cells that changes: what is refused, and that nothing changes then.
struct GridScene : Scene {
  GridScene() {
    grid = universe.add(
        make_of_kind("uv_grid", {0, 0, 1, 0, 0}, {square.begin(), square.end()}, {halves.begin(), halves.end()}),
        at(9, 9, 9));
    before = snapshot(universe);
  }
  bool is_as_before() const {
    std::array<double, 12> xyz{};
    std::array<std::uint32_t, 6> triangles{};
    std::size_t vertices = 0, count = 0;
    require(abut_shape_triangles(universe.describe(grid).shape, xyz.data(), 4, &vertices, triangles.data(), 2, &count));
    return snapshot(universe) == before && xyz == square && triangles == halves;
  }
  abut_geometry_id grid{};
  std::vector<unsigned char> before;
};

TEST(UvGridEdits, RefuseLateralMoves) {
  const GridScene scene;
  constexpr std::array<double, 6> places{-1, -1, 0.5, 1, -0.75, 0.5};
  EXPECT_TRUE(refused(abut_geometry_set_vertices(scene.universe, scene.grid, 0, places.data(), 2), ABUT_OUT_OF_RANGE,
                      {"xyz[4] is -0.75", "-1, as vertex 1 of a uv_grid moves along Z only"}));
  constexpr std::array<std::uint32_t, 2> listed{0, 1};
  EXPECT_TRUE(refused(abut_geometry_set_vertices_at(scene.universe, scene.grid, listed.data(), places.data(), 2),
                      ABUT_OUT_OF_RANGE, {"xyz[4] is -0.75", "vertex 1"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(UvGridEdits, RefuseWhatAMeshRefuses) {
  const GridScene scene;
  constexpr std::array<double, 3> place{-1, -1, 0.5};
  EXPECT_TRUE(refused(abut_geometry_set_vertices(scene.universe, scene.grid, 4, place.data(), 1),
                      ABUT_INDEX_OUT_OF_RANGE, {"count is 1"}));
  expect_non_finite_refused("xyz[2]", [&](double bad) {
    const std::array<double, 3> wrong{-1, -1, bad};
    return abut_geometry_set_vertices(scene.universe, scene.grid, 0, wrong.data(), 1);
  });
  constexpr std::array<std::uint32_t, 2> all{0, 1};
  EXPECT_TRUE(refused(abut_geometry_remove_triangles(scene.universe, scene.grid, all.data(), 2), ABUT_EMPTY,
                      {"count is 2", "no triangle"}));
  constexpr std::array<std::uint32_t, 3> past{0, 1, 4};
  EXPECT_TRUE(refused(abut_geometry_set_mesh(scene.universe, scene.grid, square.data(), 4, past.data(), 1),
                      ABUT_INDEX_OUT_OF_RANGE, {"triangles[2] is 4"}));
  EXPECT_TRUE(scene.is_as_before());
}

// Other holders of a shape keep it as it was.
TEST(UvGridEdits, LeaveTheShapeOfOthersAsItWas) {
  Universe universe;
  const Shape shared =
      make_of_kind("uv_grid", {0, 0, 1, 0, 0}, {square.begin(), square.end()}, {halves.begin(), halves.end()});
  const abut_geometry_id one = universe.add(shared, identity, ABUT_MOTION_STATIC),
                         other = universe.add(shared, at(10, 0, 0), ABUT_MOTION_STATIC);
  constexpr std::array<double, 3> place{-1, -1, 0.5};
  require(abut_geometry_set_vertices(universe, one, 0, place.data(), 1));
  const auto height = [&](const abut_shape* shape) {
    std::array<double, 12> xyz{};
    std::array<std::uint32_t, 6> triangles{};
    std::size_t vertices = 0, count = 0;
    require(abut_shape_triangles(shape, xyz.data(), 4, &vertices, triangles.data(), 2, &count));
    return xyz[2];
  };
  EXPECT_EQ(height(universe.describe(one).shape), 0.5);
  EXPECT_EQ(height(universe.describe(other).shape), 0);
  EXPECT_EQ(height(shared), 0);
}

}  // namespace
