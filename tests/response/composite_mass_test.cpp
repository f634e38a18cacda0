// SPDX-License-Identifier: Apache-2.0
// Mass of composites: against formulas, the theorem of parallel axes, a mesh of the same body, and random points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr double pi = std::numbers::pi;
constexpr abut_pose here{{0, 0, 0}, no_turn};

// A shape that copies share.
class SharedShape {
 public:
  SharedShape(Shape shape) : shape_(std::move(shape)) {}
  SharedShape(const SharedShape& other) : shape_(other.get()) { abut_shape_retain(other.get()); }
  SharedShape& operator=(const SharedShape&) = delete;
  [[nodiscard]] abut_shape* get() const { return shape_.get(); }

 private:
  Shape shape_;
};

struct Placed {
  SharedShape shape;
  abut_pose pose = here;
};

Shape composite(const std::vector<Placed>& children) {
  std::vector<const abut_shape*> shapes;
  std::vector<abut_pose> poses;
  for (const Placed& child : children) {
    shapes.push_back(child.shape.get());
    poses.push_back(child.pose);
  }
  return shape_from(
      [&](abut_shape** out) { return abut_composite_create(shapes.data(), poses.data(), shapes.size(), out); });
}

Shape bore(double radius, double half_height, abut_open_ends open) {
  return shape_from([&](abut_shape** out) { return abut_cylinder_hole_create(radius, half_height, open, out); });
}
Shape cavity(double radius) {
  return shape_from([&](abut_shape** out) { return abut_sphere_hole_create(radius, out); });
}
Shape slot(double x, double y, double z, abut_open_faces open) {
  return shape_from([&](abut_shape** out) { return abut_box_hole_create(x, y, z, open, out); });
}
Shape cylinder(double radius, double half_height) {
  return shape_from([&](abut_shape** out) { return abut_cylinder_create(radius, half_height, out); });
}

abut_quat turned(double x, double y, double z, double angle) {
  const double size = std::sqrt(x * x + y * y + z * z), sine = std::sin(angle / 2) / size;
  return {std::cos(angle / 2), sine * x, sine * y, sine * z};
}

abut_mass_properties mass_of(const SharedShape& shape, double density = 1) {
  abut_mass_properties out{};
  require(abut_shape_mass_properties(shape.get(), density, &out));
  return out;
}

void expect_near(const abut_mass_properties& is, const abut_mass_properties& expected, double part) {
  EXPECT_NEAR(is.mass, expected.mass, part * expected.mass);
  EXPECT_NEAR(is.centre.x, expected.centre.x, part);
  EXPECT_NEAR(is.centre.y, expected.centre.y, part);
  EXPECT_NEAR(is.centre.z, expected.centre.z, part);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(is.inertia[i], expected.inertia[i], part * expected.mass) << i;
}

TEST(CompositeMass, OfADumbbellFollowsFromParallelAxes) {
  const double radius = 0.3, away = 2, ball_mass = 4 * pi / 3 * radius * radius * radius;
  const abut_mass_properties is =
      mass_of(composite({{ball(radius), {{away, 0, 0}, no_turn}}, {ball(radius), {{-away, 0, 1}, no_turn}}}), 3);
  EXPECT_NEAR(is.mass, 6 * ball_mass, 1e-13);
  EXPECT_NEAR(is.centre.x, 0, 1e-14);
  EXPECT_NEAR(is.centre.z, 0.5, 1e-14);
  const double own = 0.4 * radius * radius, square = away * away;
  EXPECT_NEAR(is.inertia[0], is.mass * (own + 0.25), 1e-12);
  EXPECT_NEAR(is.inertia[4], is.mass * (own + square + 0.25), 1e-12);
  EXPECT_NEAR(is.inertia[8], is.mass * (own + square), 1e-12);
  EXPECT_NEAR(is.inertia[2], is.mass * away * 0.5, 1e-12);
}

TEST(CompositeMass, OfHollowBodiesHasAFormula) {
  const double outer = 4 * pi / 3, inner = 4 * pi / 3 * 0.343;
  const abut_mass_properties shell = mass_of(composite({{ball(1)}, {cavity(0.7)}}));
  EXPECT_NEAR(shell.mass, outer - inner, 1e-13);
  for (const std::size_t i : {0U, 4U, 8U}) EXPECT_NEAR(shell.inertia[i], 0.4 * (outer - inner * 0.49), 1e-13);
  // A plate with a bore that is open at both ends, one that stands out of it, and a tube.
  for (const auto& [half_height, open] :
       {std::pair(0.01, abut_open_ends{3}), std::pair(0.7, abut_open_ends{0}), std::pair(0.25, abut_open_ends{0})}) {
    const abut_mass_properties plate = mass_of(composite({{block(2, 1, 0.25)}, {bore(0.5, half_height, open)}}));
    const double solid = 4, hole = pi * 0.125;
    EXPECT_NEAR(plate.mass, solid - hole, 1e-13);
    EXPECT_NEAR(plate.inertia[0], solid * (1 + 0.0625) / 3 - hole * (0.0625 + 0.0625 / 3), 1e-13);
    EXPECT_NEAR(plate.inertia[8], solid * 5 / 3 - hole * 0.125, 1e-13);
  }
  const abut_mass_properties tube = mass_of(composite({{cylinder(1, 2)}, {bore(0.8, 2, 3)}}));
  EXPECT_NEAR(tube.mass, 4 * pi * 0.36, 1e-12);
  EXPECT_NEAR(tube.inertia[8], 4 * pi * 0.5 * (1 - 0.4096), 1e-12);
}

// An angle of two blocks, whose corners are those of one mesh; the second one is turned by a quarter.
TEST(CompositeMass, IsThatOfAMeshOfTheSameBody) {
  const std::vector<double> profile{0, 0, 3, 0, 3, 1, 1, 1, 1, 2, 0, 2};
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (const double z : {0.0, 1.5}) {
    for (std::size_t i = 0; i < 6; ++i) xyz.insert(xyz.end(), {profile[2 * i], profile[2 * i + 1], z});
  }
  for (const auto& [a, b, c] : {std::array{0U, 1U, 2U}, {0U, 2U, 3U}, {0U, 3U, 4U}, {0U, 4U, 5U}}) {
    triangles.insert(triangles.end(), {a, c, b, a + 6, b + 6, c + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    triangles.insert(triangles.end(), {i, next, next + 6, i, next + 6, i + 6});
  }
  const SharedShape mesh = shape_from([&](abut_shape** out) {
    return abut_mesh_create(xyz.data(), 12, triangles.data(), triangles.size() / 3, nullptr, out);
  });
  const SharedShape angle = composite({{block(1.5, 0.5, 0.75), {{1.5, 0.5, 0.75}, no_turn}},
                                       {block(0.5, 0.75, 0.5), {{0.5, 1.5, 0.75}, turned(1, 0, 0, pi / 2)}}});
  expect_near(mass_of(angle, 2), mass_of(mesh, 2), 1e-13);
  // The same cavity in both. In the mesh it is found among triangles.
  const abut_pose deep{{0.5, 0.6, 0.7}, no_turn};
  expect_near(mass_of(composite({{block(1.5, 0.5, 0.75), {{1.5, 0.5, 0.75}, no_turn}},
                                 {block(0.5, 0.5, 0.75), {{0.5, 1.5, 0.75}, no_turn}},
                                 {cavity(0.3), deep}})),
              mass_of(composite({{mesh}, {cavity(0.3), deep}})), 1e-13);
}

// Points that are in a solid and in no hole, told by the distance of a point.
TEST(CompositeMass, IsWhatRandomPointsSay) {
  const SharedShape core = composite({{block(1, 0.8, 0.6), {{0.2, 0, 0}, turned(1, 2, 3, 0.7)}},
                                      {bore(0.3, 9, 0), {{0.2, 0, 0}, turned(1, 2, 3, 0.7)}},
                                      {slot(0.2, 0.2, 0.1, 0), {{0.2, 0, 0}, turned(0, 0, 1, 0)}}});
  abut_mass_properties refused{};
  EXPECT_EQ(abut_shape_mass_properties(core.get(), 1, &refused), ABUT_UNSUPPORTED);
  // The bore stands out of the block by 0.1 below, and by far above.
  const abut_quat lean = turned(1, 2, 3, 0.7);
  const abut_vec3 up{2 * (lean.x * lean.z + lean.w * lean.y), 2 * (lean.y * lean.z - lean.w * lean.x),
                     1 - 2 * (lean.x * lean.x + lean.y * lean.y)};
  const std::vector<Placed> children{{block(1, 0.8, 0.6), {{0.2, 0, 0}, lean}},
                                     {ball(0.7), {{-1.6, 0.4, 0.1}, no_turn}},
                                     {cylinder(0.4, 0.8), {{0, 0, -1.7}, turned(0, 1, 1, 0.4)}},
                                     {bore(0.3, 1.9, 0), {{0.2 + 1.2 * up.x, 1.2 * up.y, 1.2 * up.z}, lean}},
                                     {cavity(0.4), {{-1.7, 0.3, 0.2}, no_turn}},
                                     {bore(0.2, 0.3, 0), {{0, 0, -1.7}, turned(0, 1, 1.1, 0.5)}}};
  const abut_mass_properties is = mass_of(composite(children));
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> place(-2.6, 2.6);
  constexpr int count = 200'000;
  const Shape point = shape_from(abut_point_create);
  const double each = 5.2 * 5.2 * 5.2 / count;
  abut_mass_properties sum{};
  // As solids: a hole is what its solid is.
  const std::vector<Placed> plugs{
      {cylinder(0.3, 9), children[3].pose}, {ball(0.4), children[4].pose}, {cylinder(0.2, 0.3), children[5].pose}};
  const auto holds = [&](const Placed& solid, const abut_pose& at) {
    abut_distance found{};
    require(abut_pair_distance(point.get(), &at, solid.shape.get(), &solid.pose, nullptr, &found));
    return found.distance < 0;
  };
  std::array<double, 3> first{}, squares{};
  for (int i = 0; i < count; ++i) {
    const abut_pose at{{place(random), place(random), place(random)}, no_turn};
    bool is_in = false;
    for (std::size_t k = 0; k < 3; ++k) is_in = is_in || (holds(children[k], at) && !holds(plugs[k], at));
    if (!is_in) continue;
    const std::array<double, 3> x{at.position.x, at.position.y, at.position.z};
    sum.mass += each;
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] += each * x[k];
      squares[k] += each * x[k] * x[k];
    }
  }
  EXPECT_NEAR(is.mass, sum.mass, 0.02 * is.mass);
  EXPECT_NEAR(is.centre.x, first[0] / sum.mass, 0.02);
  EXPECT_NEAR(is.centre.y, first[1] / sum.mass, 0.02);
  EXPECT_NEAR(is.centre.z, first[2] / sum.mass, 0.02);
  const double about_x = squares[1] + squares[2] - (first[1] * first[1] + first[2] * first[2]) / sum.mass;
  EXPECT_NEAR(is.inertia[0], about_x, 0.02 * about_x);
}

TEST(CompositeMass, HolesTakeNothingFromSolidsBesideThemOrOfAnotherComposite) {
  const SharedShape pierced = composite({{block(1, 1, 0.2)}, {bore(0.3, 1, 3)}});
  const double plate = 1.6 - pi * 0.09 * 0.4, pin = 0.02 * pi;
  // The pin stands in the bore of another composite, which does not cut it.
  EXPECT_NEAR(mass_of(composite({{pierced}, {cylinder(0.1, 1)}})).mass, plate + pin, 1e-13);
  EXPECT_NEAR(mass_of(composite({{block(1, 1, 0.2)}, {cavity(0.5), {{0, 0, 0.7}, no_turn}}})).mass, 1.6, 1e-13);
  // Two bores side by side, and a slot whose walls lie in the sides of the block.
  EXPECT_NEAR(mass_of(composite({{block(1, 1, 0.2)},
                                 {bore(0.3, 1, 3), {{0.3, 0, 0}, no_turn}},
                                 {bore(0.3, 1, 3), {{-0.3, 0, 0}, no_turn}}}))
                  .mass,
              1.6 - 2 * pi * 0.09 * 0.4, 1e-12);
  EXPECT_NEAR(mass_of(composite({{block(1, 1, 1)}, {slot(1, 0.25, 0.5, 0), {{0, 0, 0.5}, no_turn}}})).mass, 7, 1e-12);
  EXPECT_NEAR(mass_of(composite({{block(1, 1, 1)}, {slot(0.5, 0.25, 9, 16 | 32)}})).mass, 7, 1e-12);
}

TEST(CompositeMass, IsRefusedWhereItIsNotExact) {
  const auto expect_unsupported = [](const SharedShape& shape, const std::string& words) {
    abut_mass_properties out{};
    out.mass = -7;
    EXPECT_EQ(abut_shape_mass_properties(shape.get(), 1, &out), ABUT_UNSUPPORTED) << words;
    EXPECT_NE(std::string(abut_last_error_message()).find(words), std::string::npos) << abut_last_error_message();
    EXPECT_EQ(out.mass, -7);
  };
  const std::string crosses = "hole, child 1, crosses the surface of child 0";
  expect_unsupported(composite({{block(1, 1, 1)}, {cavity(0.5), {{0.8, 0, 0}, no_turn}}}), crosses);
  expect_unsupported(composite({{block(1, 1, 1)}, {bore(0.5, 9, 3), {{0, 0, 0}, turned(1, 0, 0, 0.1)}}}), crosses);
  expect_unsupported(composite({{block(1, 1, 1)}, {bore(0.5, 9, 3), {{0.6, 0, 0}, no_turn}}}), crosses);
  expect_unsupported(composite({{ball(1)}, {bore(0.5, 9, 3)}}), crosses);
  expect_unsupported(composite({{ball(1)}, {bore(0.8, 0.8, 0)}}), crosses);
  expect_unsupported(composite({{block(1, 1, 1)}, {cavity(0.5)}, {cavity(0.5), {{0.2, 0, 0}, no_turn}}}),
                     "hole, child 2, overlaps the hole child 1");
  expect_unsupported(composite({{ball(1)}, {ground()}}), "child 1 of a composite: shape is a plane");
  expect_unsupported(composite({{block(1, 1, 1)}, {slot(1, 1, 9, 16 | 32)}}), "leave nothing");
}

TEST(CompositeMass, MakesABodyByItsDensity) {
  Scene scene;
  const abut_part_id part =
      scene.place(composite({{block(1, 1, 1)}, {cavity(0.5)}}), {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  require(abut_response_add_bodies(scene.response(), &part, 1, nullptr));
  abut_mass_properties out{};
  require(abut_response_body(scene.response(), part, &out));
  EXPECT_NEAR(out.mass, 1000 * (8 - pi / 6), 1e-9);
}

}  // namespace
