// SPDX-License-Identifier: Apache-2.0
// Collision models of SOFA and their data, by the names that docs/sofa.md gives for them.
#include <algorithm>
#include <cmath>
#include <set>

#include "worlds.hpp"

namespace {

using namespace sofa_names;

double distance_of(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b) {
  abut_distance out{};
  require(abut_pair_distance(a.get(), &pose_a, b.get(), &pose_b, nullptr, &out));
  return out.distance;
}
std::size_t contact_count(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b) {
  std::array<abut_contact, 64> contacts{};
  std::size_t count = 0;
  require(abut_pair_contacts(a.get(), &pose_a, b.get(), &pose_b, nullptr, contacts.data(), contacts.size(), &count));
  return count;
}

TEST(CollisionModels, CollisionModel) {
  World world;
  const Shape shape = ball(0.5);
  abut_part_id body{};
  require(abut_part_create(world.get(), nullptr, &body));
  abut_geometry_id geometry{};
  require(abut_geometry_create(world.get(), body, shape.get(), nullptr, &geometry));
  world.add(shape, at(0.75, 0, 0));
  const auto contacts = world.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].geometry_a.slot, geometry.slot);
  EXPECT_NEAR(contacts[0].distance, -0.25, 1e-12);
}

TEST(CollisionModels, Active) {
  World world;
  const abut_geometry_id geometry = world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.5, 0, 0));
  EXPECT_EQ(world.step().size(), 1U);
  require(abut_geometry_park(world.get(), geometry, ABUT_PARKING_LONG_TERM));
  EXPECT_TRUE(world.step().empty());
  require(abut_geometry_park(world.get(), geometry, ABUT_PARKING_NONE));
  EXPECT_EQ(world.step().size(), 1U);
}

TEST(CollisionModels, Moving) {
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.5, 0, 0));
  world.step();
  auto stats = filled_by(abut_step_stats_init);
  require(abut_universe_stats(world.get(), &stats));
  EXPECT_EQ(stats.examined_pairs, 1U);
  EXPECT_EQ(world.step().size(), 1U);
  require(abut_universe_stats(world.get(), &stats));
  EXPECT_EQ(stats.examined_pairs, 0U) << "nothing has moved";
}

TEST(CollisionModels, Simulated) {
  World world;
  const abut_part_id body = world.part(at(0, 0, 0));
  world.put(body, ball(0.5));
  world.add(ball(0.5), at(0.5, 0, 0), 0, ABUT_MOTION_STATIC);
  EXPECT_EQ(world.step().size(), 1U);
  require(abut_part_set_motion(world.get(), body, ABUT_MOTION_STATIC));
  EXPECT_TRUE(world.step().empty());
}

TEST(CollisionModels, SelfCollision) {
  for (const abut_geometry_flags flags : {0U, ABUT_GEOMETRY_SELF_PAIRS + 0U}) {
    World world;
    auto options = filled_by(abut_geometry_options_init);
    options.flags = flags;
    const Shape crossing = mesh_of({-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, -1, 0.3, 0, 1, 0, 0.3, 1}, {0, 1, 2, 3, 4, 5});
    world.put(world.part(at(0, 0, 0)), crossing, options);
    EXPECT_EQ(world.step().empty(), flags == 0);
  }
}

TEST(CollisionModels, Group) {
  auto options = filled_by(abut_geometry_options_init);
  for (const std::uint64_t group : {0U, 1U, 2U}) {
    World world;
    options.exclusion = 1;
    world.put(world.part(at(0, 0, 0)), ball(0.5), options);
    options.exclusion = group;
    world.put(world.part(at(0.5, 0, 0)), ball(0.5), options);
    EXPECT_EQ(world.step().empty(), group == 1) << group;
  }
}

TEST(CollisionModels, ContactDistance) {
  auto options = filled_by(abut_geometry_options_init);
  for (const double x : {1.29, 1.31}) {
    World world;
    options.tolerance = 0.1;
    world.put(world.part(at(0, 0, 0)), ball(0.5), options);
    options.tolerance = 0.2;
    world.put(world.part(at(x, 0, 0)), ball(0.5), options);
    EXPECT_EQ(world.step().size(), x < 1.3 ? 1U : 0U);
  }
}

TEST(CollisionModels, NumberOfContacts) {
  World world;
  world.add(block(0.5), at(0, 0, 0), 0, ABUT_MOTION_STATIC);
  const abut_part_id body = world.part(at(0, 0, 0.9));
  world.put(body, block(0.5));
  const auto contacts = world.step();
  const abut_event* events = nullptr;
  std::size_t count = 0;
  require(abut_universe_events(world.get(), &events, &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(events[0].contact_count, contacts.size());
  EXPECT_EQ(contacts.size(), 4U);
  world.move(body, at(0, 0, 5));
  world.step();
  require(abut_universe_events(world.get(), &events, &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(events[0].kind, abut_event_kind{ABUT_EVENT_END});
  EXPECT_EQ(events[0].contact_count, 0U);
}

TEST(CollisionModels, CollisionElementActiver) {
  World world;
  const abut_geometry_id ground = world.add(square(), at(0, 0, 0), 0, ABUT_MOTION_STATIC);
  world.add(ball(0.25), at(0.5, -0.5, 0.2));
  EXPECT_EQ(world.step().size(), 1U);
  const std::uint32_t below = 0;
  require(abut_geometry_remove_triangles(world.get(), ground, &below, 1));
  EXPECT_TRUE(world.step().empty());
}

TEST(CollisionModels, CollisionElementIterator) {
  const Elements mesh = elements_of(square());
  abut_element_counts counts{};
  require(abut_elements_count(mesh.get(), &counts));
  EXPECT_EQ(counts.vertices, 4U);
  EXPECT_EQ(counts.faces, 2U);
  std::vector<std::uint32_t> ends(2 * counts.edges);
  std::size_t count = 0;
  require(abut_elements_edges(mesh.get(), ends.data(), counts.edges, &count));
  EXPECT_EQ(count, 5U);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t edge = 0; edge < count; ++edge) edges.emplace(ends[2 * edge], ends[2 * edge + 1]);
  EXPECT_EQ(edges, (std::set<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}));
}

TEST(CollisionModels, CubeCollisionModel) {
  auto options = filled_by(abut_mesh_options_init);
  for (const abut_mesh_tree tree : {ABUT_MESH_TREE_AABB, ABUT_MESH_TREE_OBB}) {
    options.tree = tree;
    const Shape mesh = make(abut_mesh_create, square_xyz.data(), std::size_t{4}, square_triangles.data(),
                            std::size_t{2}, static_cast<const abut_mesh_options*>(&options));
    require(abut_shape_prepare(mesh.get(), 1));
    EXPECT_NEAR(distance_of(mesh, at(0, 0, 0), ball(0.25), at(0.5, 0.25, 1)), 0.75, 1e-12);
  }
}

TEST(CollisionModels, SphereCollisionModel) {
  const std::vector<double> centres{0, 0, 0, 2, 0, 0}, radii{0.5, 0.75};
  const Shape spheres = make(abut_particles_create_with_radii, centres.data(), radii.data(), radii.size());
  const Shape rigid = make(abut_sphere_create, 0.25);
  EXPECT_NEAR(distance_of(spheres, at(0, 0, 0), rigid, at(0, 1, 0)), 0.25, 1e-12);
  EXPECT_NEAR(distance_of(spheres, at(0, 0, 0), rigid, at(2, 0.75, 0)), -0.25, 1e-12);
}

TEST(CollisionModels, SphereTreeModel) {
  auto options = filled_by(abut_mesh_options_init);
  options.tree = ABUT_MESH_TREE_SPHERE;
  const Shape mesh = make(abut_mesh_create, square_xyz.data(), std::size_t{4}, square_triangles.data(), std::size_t{2},
                          static_cast<const abut_mesh_options*>(&options));
  EXPECT_NEAR(distance_of(mesh, at(0, 0, 0), ball(0.25), at(0.5, 0.25, 1)), 0.75, 1e-12);
}

TEST(CollisionModels, PointCollisionModel) {
  auto options = within(0.25);
  options.kinds = 1U << ABUT_STENCIL_VERTEX_FACE | 1U << ABUT_STENCIL_VERTEX_EDGE | 1U << ABUT_STENCIL_VERTEX_VERTEX;
  const Elements a = elements_of(square()), b = elements_of(tip(0.5, -0.5, 0.125));
  std::array<abut_stencil, 8> points{};
  std::size_t count = 0;
  require(abut_elements_closest(a.get(), b.get(), &options, points.data(), points.size(), &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(points[0].of_a, 3U);
  EXPECT_EQ(points[0].element_b, 0U);
  EXPECT_EQ(points[0].distance, 0.125);
}

// Two strands that pass each other at right angles.
TEST(CollisionModels, LineCollisionModel) {
  const std::vector<double> along_x{-1, 0, 0, 1, 0, 0}, along_y{0, -1, 0.125, 0, 1, 0.125};
  const std::vector<std::uint32_t> line{0, 1, 1};
  const Shape a = make(abut_mesh_create, along_x.data(), std::size_t{2}, line.data(), std::size_t{1}, nullptr),
              b = make(abut_mesh_create, along_y.data(), std::size_t{2}, line.data(), std::size_t{1}, nullptr);
  const auto stencils = closest(elements_of(a), elements_of(b), within(0.25));
  ASSERT_EQ(stencils.size(), 1U);
  EXPECT_EQ(stencils[0].kind, abut_stencil_kind{ABUT_STENCIL_EDGE_EDGE});
  EXPECT_EQ(stencils[0].distance, 0.125);
}

TEST(CollisionModels, TriangleCollisionModel) {
  const Shape mesh =
      make(abut_mesh_create, square_xyz.data(), std::size_t{4}, square_triangles.data(), std::size_t{2}, nullptr);
  auto report = filled_by(abut_mesh_report_init);
  require(abut_mesh_describe(square_xyz.data(), 4, square_triangles.data(), 2, nullptr, &report));
  EXPECT_EQ(report.triangles, 2U);
  EXPECT_NEAR(distance_of(mesh, at(0, 0, 0), ball(0.25), at(0.5, 0.25, 1)), 0.75, 1e-12);
}

TEST(CollisionModels, BothSide) {
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    auto options = filled_by(abut_mesh_options_init);
    options.sides = sides;
    const Shape mesh = make(abut_mesh_create, square_xyz.data(), std::size_t{4}, square_triangles.data(),
                            std::size_t{2}, static_cast<const abut_mesh_options*>(&options));
    EXPECT_EQ(contact_count(mesh, at(0, 0, 0), ball(0.25), at(0.5, -0.25, 0.2)), 1U);
    EXPECT_EQ(contact_count(mesh, at(0, 0, 0), ball(0.25), at(0.5, -0.25, -0.2)), sides == ABUT_SIDES_BOTH ? 1U : 0U);
  }
}

// The nearest face of a point inside is z = 0.
TEST(CollisionModels, TetrahedronCollisionModel) {
  const Shape tetrahedron = mesh_of(corner_xyz, corner_triangles, ABUT_SIDES_SOLID);
  const Shape point = make(abut_point_create);
  EXPECT_NEAR(distance_of(tetrahedron, at(0, 0, 0), point, at(0.25, 0.25, 0.0625)), -0.0625, 1e-12);
  EXPECT_NEAR(distance_of(tetrahedron, at(0, 0, 0), point, at(0.25, 0.25, -0.5)), 0.5, 1e-12);
}

TEST(CollisionModels, TriangleOctreeModel) {
  const Shape mesh = square();
  const abut_pose pose = at(0, 0, 0);
  const abut_ray ray{{0.5, 0.25, 1}, {0, 0, -1}, 10};
  abut_ray_hit hit{};
  std::uint32_t is_hit = 0;
  require(abut_shape_cast_ray(mesh.get(), &pose, &ray, &hit, &is_hit));
  EXPECT_EQ(is_hit, 1U);
  EXPECT_EQ(hit.distance, 1);
  EXPECT_EQ(hit.feature.index, 0U);
}

TEST(CollisionModels, TriangleModelInRegularGrid) {
  const Shape terrain =
      make(abut_uv_grid_create, square_xyz.data(), std::size_t{4}, square_triangles.data(), std::size_t{2}, nullptr);
  EXPECT_NEAR(distance_of(terrain, at(0, 0, 0), ball(0.25), at(0.5, 0.25, 1)), 0.75, 1e-12);
}

// The axis is Z, and the height is given by its half.
TEST(CollisionModels, CylinderCollisionModel) {
  const Shape cylinder = make(abut_cylinder_create, 0.5, 2.0);
  EXPECT_NEAR(distance_of(cylinder, at(0, 0, 0), ball(0.25), at(0, 0, 3)), 0.75, 1e-9);
  EXPECT_NEAR(distance_of(cylinder, at(0, 0, 0), ball(0.25), at(1, 0, 0)), 0.25, 1e-9);
}

TEST(CollisionModels, OBBCollisionModel) {
  const Shape box = make(abut_box_create, 1.0, 2.0, 3.0);
  const double half = std::sqrt(0.5);
  const abut_pose turned{{0, 0, 0}, {half, 0, 0, half}};  // by a right angle about Z
  EXPECT_NEAR(distance_of(box, turned, ball(0.25), at(3, 0, 0)), 0.75, 1e-12);
  EXPECT_NEAR(distance_of(box, turned, ball(0.25), at(0, 3, 0)), 1.75, 1e-12);
}

TEST(CollisionModels, CapsuleCollisionModel) {
  const Shape capsule = make(abut_capsule_create, 0.5, 1.0);
  EXPECT_NEAR(distance_of(capsule, at(0, 0, 0), ball(0.25), at(0, 0, 3)), 1.25, 1e-12);
}

TEST(CollisionModels, RayCollisionModel) {
  World world;
  world.add(ball(0.5), at(5, 0, 0));
  const abut_geometry_id nearer = world.add(ball(0.5), at(3, 0, 0));
  require(abut_universe_refresh(world.get()));
  const abut_ray ray{{0, 0, 0}, {1, 0, 0}, 10};
  abut_query_hit hit{};
  std::size_t count = 0;
  require(abut_universe_cast_ray(world.get(), &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(hit.geometry.slot, nearer.slot);
  EXPECT_NEAR(hit.distance, 2.5, 1e-12);
}

// The field of a cube of half size 1: values between samples may be off by a part of a cell.
TEST(CollisionModels, RigidDistanceGridCollisionModel) {
  const std::vector<double> xyz{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
  const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                             1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  auto options = filled_by(abut_distance_field_options_init);
  options.spacing = 0.125;
  const Shape field = make(abut_distance_field_from_mesh, xyz.data(), xyz.size() / 3, triangles.data(),
                           triangles.size() / 3, static_cast<const abut_distance_field_options*>(&options));
  EXPECT_NEAR(distance_of(field, at(0, 0, 0), ball(0.25), at(0, 0, 1.2)), -0.05, 0.02);
}

// A lattice that stretches the upper half of space: the top of the cube goes from 1 to -2 + 3 * 4.5 / 4.
TEST(CollisionModels, FFDDistanceGridCollisionModel) {
  constexpr std::uint32_t side = 9;
  std::vector<double> values;
  for (std::uint32_t i = 0; i < side * side * side; ++i) {
    double value = 0;
    for (const std::uint32_t sample : {i % side, i / side % side, i / side / side})
      value = std::max(value, std::abs(0.5 * sample - 2));
    values.push_back(value - 1);
  }
  auto desc = filled_by(abut_distance_field_desc_init);
  desc.columns = desc.rows = desc.layers = side;
  desc.spacing = {0.5, 0.5, 0.5};
  desc.origin = {-2, -2, -2};
  desc.values = values.data();
  World world;
  const abut_geometry_id geometry =
      world.add(make(abut_distance_field_create, static_cast<const abut_distance_field_desc*>(&desc)), at(0, 0, 0));
  world.add(ball(0.25), at(0, 0, 1.6));
  EXPECT_TRUE(world.step().empty());
  std::vector<double> lattice;
  for (const double z : {-2.0, 2.5}) {
    for (const double y : {-2.0, 2.0}) {
      for (const double x : {-2.0, 2.0}) lattice.insert(lattice.end(), {x, y, z});
    }
  }
  require(abut_geometry_set_field_lattice(world.get(), geometry, 2, 2, 2, lattice.data()));
  const auto contacts = world.step();
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].distance, 1.35 - 1.375, 0.01);
}

}  // namespace
