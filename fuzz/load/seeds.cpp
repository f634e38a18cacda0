// SPDX-License-Identifier: Apache-2.0
// Universes that have what a saved one may have.
#include <abut/abut.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "load.hpp"

namespace load_fuzzing {
namespace {

struct Release {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};
using Shape = std::unique_ptr<abut_shape, Release>;
using Universe = std::unique_ptr<abut_universe, Release>;

void require(abut_status status) {
  if (status != ABUT_OK) {
    std::abort();
  }
}

template <class Create>
Shape made(Create create) {
  abut_shape* shape = nullptr;
  require(create(&shape));
  return Shape(shape);
}

constexpr abut_pose identity{{0, 0, 0}, {1, 0, 0, 0}};

std::vector<Shape> plain_shapes() {
  std::vector<Shape> shapes;
  const abut_vec3 up{0, 0, 1}, a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  shapes.push_back(made([](abut_shape** out) { return abut_sphere_create(0.5, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_box_create(0.5, 0.4, 0.3, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_capsule_create(0.3, 0.4, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_cylinder_create(0.3, 0.4, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_cone_create(0.3, 0.4, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_ellipsoid_create(0.3, 0.4, 0.5, out); }));
  shapes.push_back(made([&](abut_shape** out) { return abut_plane_create(&up, -0.2, out); }));
  shapes.push_back(made([&](abut_shape** out) { return abut_triangle_create(&a, &b, &c, out); }));
  shapes.push_back(made([](abut_shape** out) { return abut_segment_create(0.4, out); }));
  return shapes;
}

std::vector<Shape> shapes_of_many() {
  std::vector<Shape> shapes;
  constexpr std::array<double, 18> corners{0.5, 0, 0, -0.5, 0, 0, 0, 0.5, 0, 0, -0.5, 0, 0, 0, 0.5, 0, 0, -0.5};
  constexpr std::array<double, 12> xyz{0, 0, 0, 1, 0, 0, 1, 1, 0.2, 0, 1, 0};
  constexpr std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  constexpr std::array<double, 9> heights{0, 0.1, 0, 0.2, 0.3, 0, 0, 0, 0.1};
  constexpr std::array<double, 2> radii{0.2, 0.1};
  shapes.push_back(made([&](abut_shape** out) { return abut_hull_create(corners.data(), 6, out); }));
  shapes.push_back(
      made([&](abut_shape** out) { return abut_mesh_create(xyz.data(), 4, triangles.data(), 2, nullptr, out); }));
  shapes.push_back(made([&](abut_shape** out) {
    abut_height_field_desc desc;
    abut_height_field_desc_init(&desc, sizeof desc);
    desc.columns = desc.rows = 3;
    desc.heights = heights.data();
    return abut_height_field_create(&desc, out);
  }));
  shapes.push_back(
      made([&](abut_shape** out) { return abut_particles_create_with_radii(xyz.data(), radii.data(), 2, out); }));
  const Shape block = made([](abut_shape** out) { return abut_box_create(0.5, 0.5, 0.5, out); });
  const Shape bore = made([](abut_shape** out) { return abut_cylinder_hole_create(0.2, 1, ABUT_OPEN_TOP, out); });
  shapes.push_back(made([&](abut_shape** out) {
    const std::array<const abut_shape*, 2> children{block.get(), bore.get()};
    const std::array<abut_pose, 2> poses{identity, identity};
    return abut_composite_create(children.data(), poses.data(), 2, out);
  }));
  return shapes;
}

std::vector<std::uint8_t> body_of(const abut_universe* universe) {
  std::size_t size = 0;
  require(abut_universe_save(universe, nullptr, 0, &size));
  std::vector<std::uint8_t> bytes(size);
  require(abut_universe_save(universe, bytes.data(), bytes.size(), &size));
  return without_head(bytes);
}

// Everything near everything, with what the caller may say about it.
Seed seed_of(const std::string& name, const std::vector<Shape>& shapes, bool is_full) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.flags = is_full ? ABUT_UNIVERSE_LOCAL_POINTS : 0;
  abut_universe* universe = nullptr;
  require(abut_universe_create(&options, &universe));
  const Universe owner(universe);
  abut_part_id part{};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    abut_part_options place;
    abut_part_options_init(&place, sizeof place);
    place.pose.position.x = 0.3 * static_cast<double>(i);
    place.motion = i % 4 == 3 ? ABUT_MOTION_STATIC : ABUT_MOTION_DYNAMIC;
    require(abut_part_create(universe, &place, &part));
    abut_geometry_options its;
    abut_geometry_options_init(&its, sizeof its);
    its.label = its.tag = static_cast<std::uint32_t>(i % 2);
    its.parking = i % 5 == 4 ? ABUT_PARKING_SHORT_TERM : ABUT_PARKING_NONE;
    abut_geometry_id geometry{};
    require(abut_geometry_create(universe, part, shapes[i].get(), &its, &geometry));
  }
  if (is_full) {
    abut_sleep sleep;
    abut_sleep_init(&sleep, sizeof sleep);
    abut_policy policy;
    abut_policy_init(&policy, sizeof policy);
    policy.period = 2;
    abut_focus focus;
    abut_focus_init(&focus, sizeof focus);
    abut_contact_material material;
    abut_contact_material_init(&material, sizeof material);
    const abut_collidable label{ABUT_COLLIDABLE_LABEL, 1, 0}, any{ABUT_COLLIDABLE_ANY, 0, 0};
    require(abut_part_set_sleep(universe, part, &sleep));
    require(abut_part_measure_velocity(universe, part));
    require(abut_policy_set(universe, 0, 1, &policy));
    require(abut_universe_set_focus(universe, &focus, &identity.position, 1));
    require(abut_material_pair_set(universe, 0, 1, &material));
    require(abut_rule_set(universe, &label, &any, ABUT_RULE_ENABLE));
    require(abut_universe_follow_islands(universe, 1));
  }
  require(abut_universe_step(universe, 0.01));
  require(abut_universe_step(universe, 0.01));
  // A change that no step has seen.
  require(abut_part_set_pose(universe, part, &identity));
  return {name, body_of(universe)};
}

// Two sheets that are near each other and themselves, one of which is fast and has moved since the last step.
Seed seed_of_elements() {
  constexpr std::array<double, 18> xyz{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.2, 0.1, 1.2, 0.2, 0.1, 0.2, 1.2, 0.2};
  constexpr std::array<std::uint32_t, 6> triangles{0, 1, 2, 3, 4, 5};
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
  abut_universe* universe = nullptr;
  require(abut_universe_create(&options, &universe));
  const Universe owner(universe);
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0.3;
  policy.contact_distance = policy.rest_distance = 0.05;
  require(abut_policy_set(universe, 0, 0, &policy));
  abut_geometry_id geometry{};
  for (const abut_geometry_flags fast : {0U, ABUT_GEOMETRY_FAST + 0U}) {
    abut_part_options place;
    abut_part_options_init(&place, sizeof place);
    place.pose.position.z = fast == 0 ? 0 : 0.25;
    abut_part_id part{};
    require(abut_part_create(universe, &place, &part));
    abut_geometry_options its;
    abut_geometry_options_init(&its, sizeof its);
    its.flags = ABUT_GEOMETRY_SELF_PAIRS | fast;
    const Shape sheet =
        made([&](abut_shape** out) { return abut_mesh_create(xyz.data(), 6, triangles.data(), 2, nullptr, out); });
    require(abut_geometry_create(universe, part, sheet.get(), &its, &geometry));
  }
  require(abut_universe_step(universe, 0.01));
  require(abut_geometry_set_vertices(universe, geometry, 3, xyz.data(), 3));
  require(abut_universe_step(universe, 0.01));
  require(abut_geometry_set_vertices(universe, geometry, 0, xyz.data() + 9, 3));
  return {"elements", body_of(universe)};
}

}  // namespace

std::vector<Seed> seeds() {
  const std::vector<Shape> plain = plain_shapes(), many = shapes_of_many();
  return {seed_of("plain", plain, false), seed_of("full", plain, true), seed_of("many", many, true),
          seed_of_elements()};
}

}  // namespace load_fuzzing
