// SPDX-License-Identifier: Apache-2.0
// Hulls and meshes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 12> square{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
constexpr std::array<std::uint32_t, 6> two_triangles{0, 1, 2, 0, 2, 3};

TEST(HullCreate, RefusesNoPoints) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_hull_create(square.data(), 0, out.address()), ABUT_EMPTY, {"point_count", "0"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(HullCreate, AcceptsDegeneratePoints) {
  constexpr std::array<double, 12> line{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
  constexpr std::array<double, 12> coincident{5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
  for (const auto& points : {square, line, coincident}) {
    for (std::size_t count = 1; count <= 4; ++count) {
      abut_shape* shape = nullptr;
      EXPECT_TRUE(succeeded(abut_hull_create(points.data(), count, &shape)));
      abut_shape_release(shape);
    }
  }
}

TEST(HullReportInit, IgnoresNull) { abut_hull_report_init(nullptr, 0); }

TEST(HullReportInit, FillsInSizeAndZeroes) {
  Out<abut_hull_report> report;
  abut_hull_report_init(report.address(), sizeof(abut_hull_report));
  EXPECT_EQ(report.value().struct_size, sizeof(abut_hull_report));
  EXPECT_EQ(report.value().dimension, 0U);
  EXPECT_EQ(report.value().point_count, 0U);
  EXPECT_EQ(report.value().error, 0.0);
}

abut_hull_report empty_report() {
  abut_hull_report report;
  abut_hull_report_init(&report, sizeof report);
  return report;
}

TEST(HullDescribe, TellsWhatIsLeft) {
  const Shape hull = make_octahedron(1.0);
  abut_hull_report report = empty_report();
  ASSERT_TRUE(succeeded(abut_hull_describe(hull, &report)));
  EXPECT_EQ(report.struct_size, sizeof report);
  EXPECT_EQ(report.dimension, 3U);
  EXPECT_EQ(report.point_count, 6U);
  EXPECT_EQ(report.vertex_count, 6U);
  EXPECT_EQ(report.edge_count, 12U);
  EXPECT_EQ(report.face_count, 8U);
  EXPECT_EQ(report.error, 0.0);
}

TEST(HullDescribe, AcceptsLaterStructWithZeroTail) {
  const Shape hull = make_octahedron(1.0);
  Grown<abut_hull_report> later{empty_report(), {}};
  later.known.struct_size = sizeof(later);
  EXPECT_TRUE(succeeded(abut_hull_describe(hull, &later.known)));
  EXPECT_EQ(later.known.vertex_count, 6U);
  EXPECT_EQ(later.known.struct_size, sizeof(later));
}

TEST(HullDescribe, RefusesOtherKindsByName) {
  for (const Shape& shape : make_one_of_each_kind()) {
    const std::string kind = abut_shape_kind_name(abut_shape_kind_of(shape));
    if (kind == "hull") continue;
    Out<abut_hull_report> out(empty_report());
    EXPECT_TRUE(refused(abut_hull_describe(shape, out.address()), ABUT_UNSUPPORTED, {kind}));
    EXPECT_TRUE(out.is_untouched());
  }
}

// A mesh of the two triangles, with one argument of the call changed.
struct MeshCall {
  const double* xyz = square.data();
  std::size_t vertex_count = 4;
  const std::uint32_t* triangles = two_triangles.data();
  std::size_t triangle_count = 2;
  const abut_mesh_options* options = nullptr;
  abut_status into(abut_shape** out) const {
    return abut_mesh_create(xyz, vertex_count, triangles, triangle_count, options, out);
  }
};

TEST(MeshCreate, AcceptsTheCallThatTheOthersSpoil) {
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(MeshCall{}.into(&shape)));
  abut_shape_release(shape);
}

TEST(MeshCreate, RefusesNullPointers) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(MeshCall{.xyz = nullptr}.into(out.address()), ABUT_NULL_ARGUMENT, {"xyz", "null"}));
  EXPECT_TRUE(refused(MeshCall{.triangles = nullptr}.into(out.address()), ABUT_NULL_ARGUMENT, {"triangles", "null"}));
  EXPECT_TRUE(refused(MeshCall{}.into(nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesEmptyMeshes) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(MeshCall{.vertex_count = 0}.into(out.address()), ABUT_EMPTY, {"vertex_count", "0"}));
  EXPECT_TRUE(refused(MeshCall{.triangle_count = 0}.into(out.address()), ABUT_EMPTY, {"triangle_count", "0"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesOverflowingCounts) {
  Out<abut_shape*> out;
  expect_overflow_refused(3 * sizeof(double), "vertex_count",
                          [&](std::size_t count) { return MeshCall{.vertex_count = count}.into(out.address()); });
  expect_overflow_refused(3 * sizeof(std::uint32_t), "triangle_count",
                          [&](std::size_t count) { return MeshCall{.triangle_count = count}.into(out.address()); });
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesNonFiniteVertices) {
  Out<abut_shape*> out;
  for (std::size_t place = 0; place < square.size(); ++place) {
    auto points = square;
    expect_non_finite_refused("xyz", [&](double bad) {
      points.at(place) = bad;
      return MeshCall{.xyz = points.data()}.into(out.address());
    });
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesIndicesPastTheVertices) {
  Out<abut_shape*> out;
  for (std::size_t place = 0; place < two_triangles.size(); ++place) {
    for (const std::uint32_t index : {4U, 5U, 0xFFFFFFFFU}) {
      auto triangles = two_triangles;
      triangles.at(place) = index;
      EXPECT_TRUE(refused(MeshCall{.triangles = triangles.data()}.into(out.address()), ABUT_INDEX_OUT_OF_RANGE,
                          {"triangles", std::to_string(index)}));
    }
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesUnknownSides) {
  Out<abut_shape*> out;
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  for (const abut_sides sides : {3U, 77U, 0xFFFFFFFFU}) {
    options.sides = sides;
    EXPECT_TRUE(refused(MeshCall{.options = &options}.into(out.address()), ABUT_UNKNOWN_VALUE,
                        {"sides", std::to_string(sides)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, RefusesWrongStructSize) {
  Out<abut_shape*> out;
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  expect_struct_size_checked(
      options, [&](const abut_mesh_options* wrong) { return MeshCall{.options = wrong}.into(out.address()); });
  EXPECT_TRUE(out.is_untouched());
}

TEST(MeshCreate, AcceptsLaterOptionsWithZeroTail) {
  abut_shape* shape = nullptr;
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  expect_zero_tail_accepted(options,
                            [&](const abut_mesh_options* later) { return MeshCall{.options = later}.into(&shape); });
  abut_shape_release(shape);
}

TEST(MeshCreate, AcceptsTrianglesWithoutArea) {
  constexpr std::array<std::uint32_t, 6> flat{0, 0, 0, 1, 2, 1};
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(MeshCall{.triangles = flat.data()}.into(&shape)));
  abut_shape_release(shape);
}

TEST(MeshOptionsInit, IgnoresNull) { abut_mesh_options_init(nullptr, 0); }

TEST(MeshOptionsInit, FillsInTheDefaults) {
  Out<abut_mesh_options> options;
  abut_mesh_options_init(options.address(), sizeof(abut_mesh_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_mesh_options));
  EXPECT_EQ(options.value().sides, abut_sides{ABUT_SIDES_BOTH});
}

}  // namespace
