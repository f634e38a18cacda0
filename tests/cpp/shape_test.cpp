// SPDX-License-Identifier: Apache-2.0
// Shapes: sharing, every constructor, what they answer, and mistakes.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

// The message of the error that a call throws; empty where it throws none.
template <class Call>
std::string message_of(abut::Status expected, Call&& call) {
  try {
    static_cast<void>(call());
  } catch (const abut::Error& error) {
    EXPECT_EQ(error.status(), expected) << error.what();
    return error.what();
  }
  return {};
}

TEST(Shape, IsSharedByCopies) {
  abut::Shape ball = abut::Shape::sphere(1);
  const abut::Shape copy = ball;
  EXPECT_EQ(ball, copy);
  const abut::Shape moved = std::move(ball);
  EXPECT_FALSE(ball);
  EXPECT_EQ(moved, copy);
  EXPECT_NE(moved, abut::Shape::sphere(1));
  EXPECT_EQ(copy.parameters(), std::vector<double>{1});
}

TEST(Shape, ReplacesWhatItHeld) {
  abut::Shape shape = abut::Shape::sphere(1);
  const abut::Shape ball = shape;
  shape = abut::Shape::box(1, 2, 3);
  EXPECT_EQ(abut::name_of(shape.kind()), "box");
  EXPECT_EQ(abut::name_of(ball.kind()), "sphere");
  const abut::Shape& itself = shape;
  shape = itself;
  EXPECT_EQ(shape.parameters(), (std::vector<double>{1, 2, 3}));
}

TEST(Shape, GivesAndTakesReferences) {
  abut::Shape ball = abut::Shape::sphere(2);
  abut_shape* raw = ball.release();
  EXPECT_FALSE(ball);
  const abut::Shape second = abut::Shape::share(raw);
  {
    const abut::Shape first = abut::Shape::adopt(raw);
  }
  EXPECT_EQ(second.parameters(), std::vector<double>{2});
}

TEST(Shape, ComesInEveryKindWithAName) {
  const std::vector<abut::Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<double> flat{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::array<std::array<double, 3>, 3> triples{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const std::vector<std::uint32_t> indices{0, 1, 2};
  const std::vector<std::pair<std::string, abut::Shape>> shapes{
      {"sphere", abut::Shape::sphere(1)},
      {"box", abut::Shape::box(1, 1, 1)},
      {"capsule", abut::Shape::capsule(1, 1)},
      {"cylinder", abut::Shape::cylinder(1, 1)},
      {"cone", abut::Shape::cone(1, 1)},
      {"ellipsoid", abut::Shape::ellipsoid(1, 2, 3)},
      {"point", abut::Shape::point()},
      {"segment", abut::Shape::segment(1)},
      {"triangle", abut::Shape::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})},
      {"plane", abut::Shape::plane({0, 0, 2}, 0)},
      {"hull", abut::Shape::hull(corners)},
      {"hull", abut::Shape::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
      {"mesh", abut::Shape::mesh(flat, indices)},
      {"mesh", abut::Shape::mesh(triples, {{0, 1, 2}}, abut::MeshOptions().with_sides(ABUT_SIDES_FRONT))},
      {"height_field", abut::Shape::height_field(2, 2, 1, 1, {0, 0, 0, 1})},
      {"particles", abut::Shape::particles(corners, 0.1)},
      {"composite", abut::Shape::composite({abut::Shape::sphere(1)}, {abut::pose({1, 0, 0})}, {7})},
      {"box_hole", abut::Shape::create("box_hole", {1, 1, 1, 0})}};
  for (const auto& [name, shape] : shapes) EXPECT_EQ(abut::name_of(shape.kind()), name);
}

TEST(Shape, TellsTheChildrenOfAComposite) {
  const abut::Shape inner = abut::Shape::composite({abut::Shape::box(1, 1, 1), abut::Shape::sphere_hole(0.5)},
                                                   {abut::pose({0, 0, 2}), abut::pose()});
  const abut::Shape whole =
      abut::Shape::composite({abut::Shape::sphere(1), inner}, {abut::pose({3, 0, 0}), abut::pose()}, {4, 6});
  const std::vector<abut::CompositeChild> children = whole.children();
  ASSERT_EQ(children.size(), 3u);
  EXPECT_EQ(children.at(0).pose.position.x, 3);
  EXPECT_EQ(children.at(1).pose.position.z, 2);
  EXPECT_EQ(children.at(1).material, 6u);
  EXPECT_EQ(children.at(2).is_hole, 1u);
  EXPECT_EQ(children.at(2).cut_begin, 1u);
  const abut::Shape child = whole.child_shape(2);
  EXPECT_EQ(abut::name_of(child.kind()), "sphere_hole");
  EXPECT_EQ(message_of(ABUT_UNSUPPORTED, [] { return abut::Shape(abut::Shape::sphere(1)).children(); }),
            "shape is a sphere; only a composite has children");
}

TEST(Shape, FacesMayHaveFourCornersAndVerticesMayMerge) {
  const std::vector<double> two_squares{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0};
  const std::vector<std::uint32_t> quads{0, 1, 2, 3, 4, 5, 6, 7};
  const auto apart = abut::MeshOptions().with_corners(4);
  const abut::MeshReport report = abut::Shape::describe_mesh(two_squares, quads, apart);
  EXPECT_EQ(report.triangles, 4u);
  EXPECT_EQ(report.open_edges, 8u);
  const abut::MeshReport merged = abut::Shape::describe_mesh(two_squares, quads, apart.with_merging(0));
  EXPECT_EQ(merged.merged_vertices, 2u);
  EXPECT_EQ(merged.open_edges, 6u);
  const abut::Shape mesh = abut::Shape::mesh(two_squares, quads, apart);
  const abut::TriangleMesh halves = mesh.triangles();
  EXPECT_EQ(halves.triangles.size(), 4u);
  const abut::Shape grid =
      abut::Shape::uv_grid(two_squares, quads, abut::UvGridOptions().with_corners(4).with_merging(0));
  const abut::TriangleMesh joined = grid.triangles();
  EXPECT_EQ(joined.triangles.at(2), (std::array<std::uint32_t, 3>{1, 5, 6}));
}

TEST(Shape, ComesWithHolesAndBallsOfVariousRadii) {
  const abut::Shape balls = abut::Shape::particles_with_radii({{0, 0, 0}, {5, 0, 0}}, {0.5, 0.25});
  const abut::Distance gap = abut::pair_distance(balls, abut::pose(), abut::Shape::point(), abut::pose({7, 0, 0}));
  EXPECT_EQ(gap.distance, 1.75);
  EXPECT_EQ(abut::name_of(abut::Shape::sphere_hole(1).kind()), "sphere_hole");
  EXPECT_EQ(abut::name_of(abut::Shape::cylinder_hole(1, 2, ABUT_OPEN_TOP).kind()), "cylinder_hole");
  EXPECT_EQ(abut::name_of(abut::Shape::box_hole(1, 2, 3, ABUT_OPEN_X_HIGH).kind()), "box_hole");
  EXPECT_THROW(static_cast<void>(abut::Shape::particles_with_radii({{0, 0, 0}}, {})), abut::Error);
}

TEST(Shape, AnswersForItself) {
  const abut::Shape box = abut::Shape::box(1, 2, 3);
  EXPECT_EQ(box.aabb(abut::pose({10, 0, 0})).maximum.x, 11);
  const abut::TriangleMesh mesh = box.triangles();
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  const std::optional<abut::RayHit> hit = box.cast_ray(abut::pose(), {{-5, 0, 0}, {1, 0, 0}, INFINITY});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->distance, 4);
  EXPECT_FALSE(box.cast_ray(abut::pose(), {{-5, 9, 0}, {1, 0, 0}, INFINITY}));
  const abut::HullReport report = abut::Shape::hull(mesh.vertices).describe_hull();
  EXPECT_EQ(report.vertex_count, 8U);
}

TEST(Shape, NamesWhatIsWrong) {
  EXPECT_EQ(message_of(ABUT_OUT_OF_RANGE, [] { return abut::Shape::sphere(-2.5); }),
            "radius is -2.5; it must be positive");
  EXPECT_EQ(message_of(ABUT_UNKNOWN_VALUE, [] { return abut::Shape::create("bal", {1}); }),
            "kind is \"bal\"; this build of abut has no shape of that name");
  EXPECT_EQ(message_of(ABUT_INVALID_ARGUMENT, [] { return abut::Shape::hull(std::vector<double>{1, 2}); }),
            "points has 2 numbers; it must be a multiple of 3");
  EXPECT_EQ(message_of(ABUT_INVALID_ARGUMENT, [] { return abut::Shape::height_field(2, 2, 1, 1, {0, 0}); }),
            "heights has 2 numbers; it must have 4, columns * rows");
  EXPECT_EQ(message_of(ABUT_INVALID_ARGUMENT, [] { return abut::Shape::composite({abut::Shape::point()}, {}); }),
            "poses has 0 elements; it must have 1, as many as children");
  EXPECT_NE(message_of(ABUT_NULL_ARGUMENT, [] { return abut::Shape().aabb(abut::pose()); }), "");
}

TEST(Kinds, AreFoundByName) {
  EXPECT_EQ(abut::shape_kind("no such kind"), 0U);
  const abut::ShapeKind box = abut::shape_kind("box"), plane = abut::shape_kind("plane");
  EXPECT_EQ(abut::parameter_names(box), (std::vector<std::string>{"half_x", "half_y", "half_z"}));
  EXPECT_TRUE(abut::pair_support(box, plane, ABUT_QUERY_CONTACTS));
  EXPECT_FALSE(abut::pair_support(plane, plane, ABUT_QUERY_CONTACTS));
  EXPECT_EQ(abut::name_of(0), "");
  EXPECT_GE(abut::shape_kinds().size(), 18U);
}

TEST(Library, TellsWhatWasLoaded) {
  abut::check_version();
  EXPECT_EQ(abut::version().substr(0, 2), std::to_string(ABUT_VERSION_MAJOR) + ".");
  EXPECT_FALSE(abut::has_feature("no such feature"));
  EXPECT_GT(abut::layout().size(), 100U);
}

}  // namespace
