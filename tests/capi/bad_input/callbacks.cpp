// SPDX-License-Identifier: Apache-2.0
// Calls from a filter, while the universe steps: those that change it are refused, whatever their other arguments are.
#include <functional>
#include <stdexcept>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

struct Callback {
  Scene& scene;
  std::function<abut_status(Scene&)> call;
  int count = 0;
};

std::uint32_t run(void* context, const abut_universe*, abut_geometry_id, abut_geometry_id) {
  auto& callback = *static_cast<Callback*>(context);
  ++callback.count;
  EXPECT_TRUE(refused(callback.call(callback.scene), ABUT_BUSY, {"[exclusive]"}));
  return 1;
}

// Runs a call in a step. The universe goes on as if it had not been made.
void expect_busy(std::function<abut_status(Scene&)> call) {
  Scene scene;
  Callback callback{scene, std::move(call)};
  ASSERT_TRUE(succeeded(abut_universe_set_filter(scene.universe, run, &callback)));
  EXPECT_FALSE(scene.universe.step().empty());
  EXPECT_EQ(callback.count, 1);
  EXPECT_EQ(scene.universe.stats().geometries, 2U);
  EXPECT_EQ(scene.universe.events().size(), 1U);
}

#define ABUT_BUSY_TEST(Suite, ...)                                          \
  TEST(Suite, IsBusyInACallback) {                                          \
    expect_busy([]([[maybe_unused]] Scene& scene) { return __VA_ARGS__; }); \
  }

ABUT_BUSY_TEST(PartCreate, abut_part_create(scene.universe, nullptr, &scene.part))
ABUT_BUSY_TEST(PartsCreate, abut_parts_create(scene.universe, nullptr, 0, nullptr))
ABUT_BUSY_TEST(PartDestroy, abut_part_destroy(scene.universe, scene.part))
ABUT_BUSY_TEST(PartsDestroy, abut_parts_destroy(scene.universe, &scene.part, 1))
ABUT_BUSY_TEST(PartSetPose, abut_part_set_pose(scene.universe, scene.part, nullptr))
ABUT_BUSY_TEST(PartsSetPoses, abut_parts_set_poses(scene.universe, nullptr, nullptr, 1))
ABUT_BUSY_TEST(PartSetMotion, abut_part_set_motion(scene.universe, scene.part, ABUT_MOTION_STATIC))
ABUT_BUSY_TEST(PartsSetMotions, abut_parts_set_motions(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(PartSetSleep, abut_part_set_sleep(scene.universe, scene.part, nullptr))
ABUT_BUSY_TEST(PartsSetSleep, abut_parts_set_sleep(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(PartWake, abut_part_wake(scene.universe, scene.part))
ABUT_BUSY_TEST(PartsWake, abut_parts_wake(scene.universe, nullptr, 0))
ABUT_BUSY_TEST(PartSetVelocity, abut_part_set_velocity(scene.universe, scene.part, nullptr))
ABUT_BUSY_TEST(PartsSetVelocities, abut_parts_set_velocities(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(PartSetAcceleration, abut_part_set_acceleration(scene.universe, scene.part, nullptr))
ABUT_BUSY_TEST(PartsSetAccelerations, abut_parts_set_accelerations(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(UniverseAdvanceToFirstImpact, abut_universe_advance_to_first_impact(scene.universe, 1, nullptr))
ABUT_BUSY_TEST(PartMeasureVelocity, abut_part_measure_velocity(scene.universe, scene.part))
ABUT_BUSY_TEST(PartsMeasureVelocities, abut_parts_measure_velocities(scene.universe, nullptr, 0))
ABUT_BUSY_TEST(UniverseFollowIslands, abut_universe_follow_islands(scene.universe, 1))
ABUT_BUSY_TEST(GeometryCreate, abut_geometry_create(scene.universe, scene.part, scene.ball, nullptr, &scene.geometry))
ABUT_BUSY_TEST(GeometriesCreate, abut_geometries_create(scene.universe, nullptr, nullptr, nullptr, 0, nullptr))
ABUT_BUSY_TEST(GeometryDestroy, abut_geometry_destroy(scene.universe, scene.geometry))
ABUT_BUSY_TEST(GeometriesDestroy, abut_geometries_destroy(scene.universe, &scene.geometry, 1))
ABUT_BUSY_TEST(GeometrySetOptions, abut_geometry_set_options(scene.universe, scene.geometry, nullptr))
ABUT_BUSY_TEST(GeometriesSetOptions, abut_geometries_set_options(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetShape, abut_geometry_set_shape(scene.universe, scene.geometry, scene.block))
ABUT_BUSY_TEST(GeometriesSetShapes, abut_geometries_set_shapes(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetParameters, abut_geometry_set_parameters(scene.universe, scene.geometry, nullptr, 0))
ABUT_BUSY_TEST(GeometriesSetParameters, abut_geometries_set_parameters(scene.universe, nullptr, nullptr, 0, 0))
ABUT_BUSY_TEST(GeometrySetHeights, abut_geometry_set_heights(scene.universe, scene.geometry, 0, 0, 0, 0, nullptr))
ABUT_BUSY_TEST(GeometrySetFieldValues,
               abut_geometry_set_field_values(scene.universe, scene.geometry, 0, 0, 0, 0, 0, 0, nullptr))
ABUT_BUSY_TEST(GeometrySetFieldLattice,
               abut_geometry_set_field_lattice(scene.universe, scene.geometry, 0, 0, 0, nullptr))
ABUT_BUSY_TEST(GeometrySetParticles,
               abut_geometry_set_particles(scene.universe, scene.geometry, 0, nullptr, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetVertices, abut_geometry_set_vertices(scene.universe, scene.geometry, 0, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetVerticesAt,
               abut_geometry_set_vertices_at(scene.universe, scene.geometry, nullptr, nullptr, 0))
ABUT_BUSY_TEST(GeometryRemoveTriangles, abut_geometry_remove_triangles(scene.universe, scene.geometry, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetMesh, abut_geometry_set_mesh(scene.universe, scene.geometry, nullptr, 0, nullptr, 0))
ABUT_BUSY_TEST(RuleSet, abut_rule_set(scene.universe, &anything, &anything, ABUT_RULE_DISABLE))
ABUT_BUSY_TEST(RulesClear, abut_rules_clear(scene.universe))
ABUT_BUSY_TEST(UniverseSetFilter, abut_universe_set_filter(scene.universe, nullptr, nullptr))
ABUT_BUSY_TEST(UniverseSetPointerFilter, abut_universe_set_pointer_filter(scene.universe, nullptr, nullptr))
ABUT_BUSY_TEST(UniverseRefilter, abut_universe_refilter(scene.universe))
ABUT_BUSY_TEST(PolicySet, abut_policy_set(scene.universe, 0, 0, nullptr))
ABUT_BUSY_TEST(UniverseSetFocus, abut_universe_set_focus(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(MaterialPairSet, abut_material_pair_set(scene.universe, 0, 0, nullptr))
ABUT_BUSY_TEST(UniverseStep, abut_universe_step(scene.universe, 0.0))
ABUT_BUSY_TEST(UniverseDetectAll, abut_universe_detect_all(scene.universe))
ABUT_BUSY_TEST(UniverseDetectChanged, abut_universe_detect_changed(scene.universe))
ABUT_BUSY_TEST(UniverseDetectPairs, abut_universe_detect_pairs(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(UniverseDetectRegion, abut_universe_detect_region(scene.universe, nullptr))
ABUT_BUSY_TEST(UniverseRefresh, abut_universe_refresh(scene.universe))
ABUT_BUSY_TEST(PartSetUserData, abut_part_set_user_data(scene.universe, scene.part, 0))
ABUT_BUSY_TEST(PartsSetUserData, abut_parts_set_user_data(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(GeometrySetUserData, abut_geometry_set_user_data(scene.universe, scene.geometry, 0))
ABUT_BUSY_TEST(GeometriesSetUserData, abut_geometries_set_user_data(scene.universe, nullptr, nullptr, 0))
ABUT_BUSY_TEST(ContactsSetUserData, abut_contacts_set_user_data(scene.universe, nullptr, 0))

std::uint32_t destroy(void* context, const abut_universe*, abut_geometry_id, abut_geometry_id) {
  abut_universe_destroy(*static_cast<Universe*>(context));
  return 1;
}

TEST(UniverseDestroy, DoesNothingInACallback) {
  Scene scene;
  ASSERT_TRUE(succeeded(abut_universe_set_filter(scene.universe, destroy, &scene.universe)));
  EXPECT_FALSE(scene.universe.step().empty());
}

// An exception that gets out of a filter is a defect of the caller; the universe can only be destroyed then.
std::uint32_t fail(void*, const abut_universe*, abut_geometry_id, abut_geometry_id) {
  throw std::runtime_error("the filter failed");
}

TEST(UniverseSetFilter, WhatIsThrownOutOfAFilterEndsTheUniverse) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  universe.add(ball, identity);
  universe.add(ball, at(1, 0, 0));
  ASSERT_TRUE(succeeded(abut_universe_set_filter(universe, fail, nullptr)));
  EXPECT_TRUE(refused(abut_universe_step(universe, 0.0), ABUT_INTERNAL, {"the filter failed"}));
  EXPECT_TRUE(refused(abut_universe_step(universe, 0.0), ABUT_INTERNAL, {}));
  std::uint64_t hash = 0;
  EXPECT_TRUE(refused(abut_universe_hash(universe, &hash), ABUT_INTERNAL, {}));
}

// A C interface is made for many languages: [const] calls are open to a filter.
std::uint32_t look(void* context, const abut_universe* universe, abut_geometry_id a, abut_geometry_id b) {
  auto& looked = *static_cast<int*>(context);
  const std::array<abut_geometry_id, 2> both{a, b};
  std::array<abut_pose, 2> poses{};
  EXPECT_TRUE(succeeded(abut_geometries_poses(universe, both.data(), 2, poses.data())));
  EXPECT_EQ(poses[1].position.x, 1.0);
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  EXPECT_TRUE(succeeded(abut_geometry_describe(universe, a, &info)));
  const abut_contact* contacts = nullptr;
  std::size_t count = 9;
  EXPECT_TRUE(succeeded(abut_universe_contacts(universe, &contacts, &count)));
  EXPECT_EQ(count, looked == 0 ? 0U : 1U) << "those of the step before";
  ++looked;
  return 1;
}

TEST(UniverseSetFilter, MayLookAtTheUniverse) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  universe.add(ball, identity);
  universe.add(ball, at(1, 0, 0));
  int looked = 0;
  ASSERT_TRUE(succeeded(abut_universe_set_filter(universe, look, &looked)));
  EXPECT_EQ(universe.step().size(), 1U) << "what was lent to the filter is not lent any more";
  ASSERT_TRUE(succeeded(abut_universe_refilter(universe)));
  EXPECT_EQ(universe.step().size(), 1U);
  EXPECT_EQ(looked, 2);
}

}  // namespace
