// SPDX-License-Identifier: Apache-2.0
#include "support.hpp"

#include <abut/abut.h>

#include <utility>

namespace abut_test {
namespace {

std::string describe(abut_status status) {
  return std::string(abut_status_name(status)) + " (" + std::to_string(status) + ")";
}

}  // namespace

testing::AssertionResult succeeded(abut_status status) {
  const std::string message = abut_last_error_message();
  if (status != ABUT_OK) return testing::AssertionFailure() << describe(status) << ": " << message;
  return testing::AssertionSuccess();
}

void require(abut_status status) { EXPECT_TRUE(succeeded(status)); }

// Clears the message, so that the next refusal has to write one.
testing::AssertionResult refused(abut_status status, abut_status expected,
                                 std::initializer_list<std::string_view> words) {
  const std::string message = abut_last_error_message();
  require(abut_set_last_error(ABUT_OK, nullptr));
  if (status != expected) {
    return testing::AssertionFailure() << "expected " << describe(expected) << ", got " << describe(status) << ": "
                                       << message;
  }
  if (message.empty()) return testing::AssertionFailure() << describe(status) << " came without a message";
  for (const std::string_view word : words) {
    if (message.find(word) == std::string::npos) {
      return testing::AssertionFailure() << describe(status) << ": the message lacks \"" << word << "\": " << message;
    }
  }
  return testing::AssertionSuccess();
}

Shape make_sphere(double radius) {
  abut_shape* shape = nullptr;
  require(abut_sphere_create(radius, &shape));
  return Shape(shape);
}

Shape make_box(double half_x, double half_y, double half_z) {
  abut_shape* shape = nullptr;
  require(abut_box_create(half_x, half_y, half_z, &shape));
  return Shape(shape);
}

Shape make_capsule(double radius, double half_height) {
  abut_shape* shape = nullptr;
  require(abut_capsule_create(radius, half_height, &shape));
  return Shape(shape);
}

Shape make_plane(abut_vec3 normal, double offset) {
  abut_shape* shape = nullptr;
  require(abut_plane_create(&normal, offset, &shape));
  return Shape(shape);
}

Shape make_octahedron(double radius) {
  const std::array<double, 18> points{radius, 0,       0, -radius, 0, 0,      0, radius, 0,
                                      0,      -radius, 0, 0,       0, radius, 0, 0,      -radius};
  abut_shape* shape = nullptr;
  require(abut_hull_create(points.data(), 6, &shape));
  return Shape(shape);
}

Shape make_square_mesh(double half_side) {
  const double s = half_side;
  const std::array<double, 12> points{-s, -s, 0, s, -s, 0, s, s, 0, -s, s, 0};
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  abut_shape* shape = nullptr;
  require(abut_mesh_create(points.data(), 4, triangles.data(), 2, nullptr, &shape));
  return Shape(shape);
}

Shape make_terrain(std::uint32_t samples, double spacing) {
  std::vector<double> heights(std::size_t{samples} * samples, 0.0);
  heights.at((std::size_t{samples} / 2) * samples + samples / 2) = 0.25 * spacing;
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = samples;
  desc.rows = samples;
  desc.spacing_x = spacing;
  desc.spacing_y = spacing;
  desc.heights = heights.data();
  abut_shape* shape = nullptr;
  require(abut_height_field_create(&desc, &shape));
  return Shape(shape);
}

namespace {

abut_shape_desc describe(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
                         const std::vector<std::uint32_t>& indices) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof(desc));
  desc.kind = abut_shape_kind_by_name(kind);
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = reals.data();
  desc.real_count = reals.size();
  desc.indices = indices.data();
  desc.index_count = indices.size();
  return desc;
}

}  // namespace

Shape make_of_kind(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
                   const std::vector<std::uint32_t>& indices) {
  const abut_shape_desc desc = describe(kind, parameters, reals, indices);
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(abut_shape_create(&desc, &shape)));
  return Shape(shape);
}

void expect_kind_refused(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
                         const std::vector<std::uint32_t>& indices, abut_status status,
                         std::initializer_list<std::string_view> words) {
  const abut_shape_desc desc = describe(kind, parameters, reals, indices);
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), status, words));
  EXPECT_TRUE(out.is_untouched());
}

std::vector<abut_contact> contacts_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b,
                                      const abut_pose& pose_b, double margin) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof(options));
  options.max_contacts = 0;
  options.margin = margin;
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, nullptr, 0, &count)));
  std::vector<abut_contact> found(count);
  EXPECT_TRUE(succeeded(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, found.data(), count, &count)));
  return found;
}

double distance_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b) {
  abut_distance found{};
  EXPECT_TRUE(succeeded(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &found)));
  EXPECT_LE(found.lower, found.distance);
  EXPECT_LE(found.distance, found.upper);
  return found.distance;
}

Shape make_composite(const std::vector<const abut_shape*>& children, const std::vector<abut_pose>& poses) {
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(abut_composite_create(children.data(), poses.data(), children.size(), &shape)));
  return Shape(shape);
}

std::vector<Shape> make_one_of_each_kind() {
  std::vector<Shape> shapes;
  shapes.push_back(make_sphere(1.0));
  shapes.push_back(make_box(1.0, 0.75, 0.5));
  shapes.push_back(make_capsule(0.5, 0.75));
  shapes.push_back(make_plane({0.0, 0.0, 1.0}, 0.0));
  shapes.push_back(make_octahedron(1.0));
  shapes.push_back(make_square_mesh(1.0));
  shapes.push_back(make_terrain(5, 1.0));
  return shapes;
}

}  // namespace abut_test
