#include "support.hpp"

#include <abut/abut.h>

#include <cmath>
#include <iterator>
#include <utility>


namespace abut_test {
namespace {

std::string describe(abut_status status) {
  return std::string(abut_status_name(status)) + " (" + std::to_string(status) + ")";
}

template <class Value>
void append(std::vector<unsigned char>& bytes, const Value& value) {
  const auto image = std::bit_cast<std::array<unsigned char, sizeof(Value)>>(value);
  bytes.insert(bytes.end(), image.begin(), image.end());
}

// A status that the tests of a helper cannot go on without.
void require(abut_status status) { EXPECT_TRUE(succeeded(status)); }

abut_part_id next_generation(abut_part_id id) { return {id.slot, id.generation + 1U}; }
abut_geometry_id next_generation(abut_geometry_id id) { return {id.slot, id.generation + 1U}; }

}  // namespace

testing::AssertionResult succeeded(abut_status status) {
  const std::string message = abut_last_error_message();
  if (status != ABUT_OK) return testing::AssertionFailure() << describe(status) << ": " << message;
  return testing::AssertionSuccess();
}

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
  const std::array<double, 18> points{radius, 0, 0, -radius, 0, 0, 0, radius, 0, 0, -radius, 0, 0, 0, radius, 0, 0, -radius};
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
                         const std::vector<std::uint32_t>& indices, abut_status status, std::initializer_list<std::string_view> words) {
  const abut_shape_desc desc = describe(kind, parameters, reals, indices);
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_shape_create(&desc, out.address()), status, words));
  EXPECT_TRUE(out.is_untouched());
}

std::vector<abut_contact> contacts_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b,
                                      double margin) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof(options));
  options.max_contacts = 0;
  options.margin = margin;
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(abut_shapes_contacts(a, &pose_a, b, &pose_b, &options, nullptr, 0, &count)));
  std::vector<abut_contact> found(count);
  EXPECT_TRUE(succeeded(abut_shapes_contacts(a, &pose_a, b, &pose_b, &options, found.data(), count, &count)));
  return found;
}

double distance_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b) {
  abut_distance found{};
  EXPECT_TRUE(succeeded(abut_shapes_distance(a, &pose_a, b, &pose_b, nullptr, &found)));
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

Universe::Universe(const abut_universe_options* options) { require(abut_universe_create(options, &universe_)); }

abut_part_id Universe::add_part(const abut_pose& pose, abut_motion motion, std::uint64_t user_data) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.pose = pose;
  options.motion = motion;
  options.user_data = user_data;
  abut_part_id part{};
  require(abut_part_create(universe_, &options, &part));
  return part;
}

abut_geometry_id Universe::add_geometry(abut_part_id part, const abut_shape* shape, double tolerance) {
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.tolerance = tolerance;
  abut_geometry_id geometry{};
  require(abut_geometry_create(universe_, part, shape, &options, &geometry));
  return geometry;
}

abut_geometry_id Universe::add(const abut_shape* shape, const abut_pose& pose, abut_motion motion, double tolerance) {
  return add_geometry(add_part(pose, motion), shape, tolerance);
}

std::vector<abut_contact> Universe::contacts() const {
  const abut_contact* first = nullptr;
  std::size_t count = 0;
  require(abut_universe_contacts(universe_, &first, &count));
  std::vector<abut_contact> all;
  std::copy_n(first, count, std::back_inserter(all));
  return all;
}

std::vector<abut_contact> Universe::step() {
  require(abut_universe_step(universe_, 0.0));
  return contacts();
}

std::vector<unsigned char> snapshot(const abut_universe* universe) {
  std::vector<unsigned char> bytes;
  std::size_t count = 0;
  require(abut_universe_parts(universe, nullptr, 0, &count));
  std::vector<abut_part_id> parts(count);
  require(abut_universe_parts(universe, parts.data(), parts.size(), &count));
  for (const abut_part_id part : parts) {
    abut_pose pose{};
    std::uint64_t user_data = 0;
    require(abut_part_pose(universe, part, &pose));
    require(abut_part_user_data(universe, part, &user_data));
    append(bytes, part);
    append(bytes, pose);
    append(bytes, user_data);
  }
  require(abut_universe_geometries(universe, nullptr, 0, &count));
  std::vector<abut_geometry_id> geometries(count);
  require(abut_universe_geometries(universe, geometries.data(), geometries.size(), &count));
  for (const abut_geometry_id geometry : geometries) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    require(abut_geometry_describe(universe, geometry, &info));
    append(bytes, geometry);
    append(bytes, info);
  }
  abut_revision revision{};
  require(abut_universe_revision(universe, &revision));
  append(bytes, revision);
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  require(abut_universe_stats(universe, &stats));
  append(bytes, stats);
  const abut_contact* contacts = nullptr;
  require(abut_universe_contacts(universe, &contacts, &count));
  append(bytes, contacts);
  std::for_each_n(contacts, count, [&](const abut_contact& contact) { append(bytes, contact); });
  return bytes;
}

Scene::Scene() {
  geometry = universe.add(ball, at(0.0, 0.0, 0.0));
  second_geometry = universe.add(block, at(1.5, 0.0, 0.0));
  const abut_part_id doomed = universe.add_part(at(9.0, 0.0, 0.0));
  const abut_geometry_id doomed_geometry = universe.add_geometry(doomed, ball);
  for (int i = 0; i < 4; ++i) other.add(ball, at(5.0 * i, 0.0, 0.0));
  require(abut_part_destroy(universe, doomed));

  std::size_t count = 0;
  std::array<abut_part_id, 2> parts{};
  require(abut_universe_parts(universe, parts.data(), parts.size(), &count));
  part = parts[0];
  second_part = parts[1];
  std::array<abut_part_id, 4> foreign_parts{};
  require(abut_universe_parts(other, foreign_parts.data(), foreign_parts.size(), &count));
  std::array<abut_geometry_id, 4> foreign_geometries{};
  require(abut_universe_geometries(other, foreign_geometries.data(), foreign_geometries.size(), &count));

  constexpr std::uint32_t far = 0xFFFFFFFFU;
  stale_parts = {{0, 0}, doomed, foreign_parts[0], next_generation(part), {0, part.generation}, {1000, part.generation},
                 {far, far}};
  stale_geometries = {{0, 0},
                      doomed_geometry,
                      foreign_geometries[0],
                      next_generation(geometry),
                      {0, geometry.generation},
                      {1000, geometry.generation},
                      {far, far}};
  EXPECT_FALSE(universe.step().empty()) << "the scene must have contacts";
  before_ = snapshot(universe);
}

}  // namespace abut_test
