// SPDX-License-Identifier: Apache-2.0
// Particles and composites under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 6> two_places{0, 0, 0, 1, 2, 3};

TEST(ParticlesCreate, RefusesNullPointers) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_particles_create(nullptr, 2, 0.5, out.address()), ABUT_NULL_ARGUMENT, {"xyz", "null"}));
  EXPECT_TRUE(refused(abut_particles_create(two_places.data(), 2, 0.5, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ParticlesCreate, RefusesNonFiniteNumbers) {
  Out<abut_shape*> out;
  expect_non_finite_refused(
      "radius", [&](double bad) { return abut_particles_create(two_places.data(), 2, bad, out.address()); });
  expect_non_finite_refused("xyz[4]", [&](double bad) {
    auto places = two_places;
    places[4] = bad;
    return abut_particles_create(places.data(), 2, 0.5, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

TEST(ParticlesCreate, RefusesRadiiThatAreNotPositive) {
  Out<abut_shape*> out;
  EXPECT_TRUE(
      refused(abut_particles_create(two_places.data(), 2, 0.0, out.address()), ABUT_OUT_OF_RANGE, {"radius", "0"}));
  EXPECT_TRUE(
      refused(abut_particles_create(two_places.data(), 2, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"radius", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ParticlesCreate, RefusesNoneAndCountsThatOverflow) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_particles_create(two_places.data(), 0, 0.5, out.address()), ABUT_EMPTY, {"count", "0"}));
  expect_overflow_refused(3 * sizeof(double), "count", [&](std::size_t count) {
    return abut_particles_create(two_places.data(), count, 0.5, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

// A call that is right until a test spoils something.
struct CompositeCall {
  Shape ball = make_sphere(1);
  Shape block = make_box(1, 1, 1);
  std::array<const abut_shape*, 2> children{ball, block};
  std::array<abut_pose, 2> poses{identity, at(3, 0, 0)};
  std::size_t count = 2;
  abut_status into(abut_shape** out) const { return abut_composite_create(children.data(), poses.data(), count, out); }
};

TEST(CompositeCreate, AcceptsTheCallThatTheOthersSpoil) {
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(CompositeCall{}.into(&shape)));
  abut_shape_release(shape);
}

TEST(CompositeCreate, RefusesNullPointers) {
  Out<abut_shape*> out;
  CompositeCall call;
  EXPECT_TRUE(refused(abut_composite_create(nullptr, call.poses.data(), 2, out.address()), ABUT_NULL_ARGUMENT,
                      {"children", "null"}));
  EXPECT_TRUE(refused(abut_composite_create(call.children.data(), nullptr, 2, out.address()), ABUT_NULL_ARGUMENT,
                      {"poses", "null"}));
  EXPECT_TRUE(refused(call.into(nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  call.children[1] = nullptr;
  EXPECT_TRUE(refused(call.into(out.address()), ABUT_NULL_ARGUMENT, {"children[1]", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreate, RefusesNonFiniteAndOtherBadPoses) {
  Out<abut_shape*> out;
  for (const BadPose& bad : bad_poses()) {
    CompositeCall call;
    call.poses[1] = bad.pose;
    EXPECT_TRUE(refused(call.into(out.address()), bad.status, {"poses[1]", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreate, RefusesNoneAndCountsThatOverflow) {
  Out<abut_shape*> out;
  CompositeCall call;
  call.count = 0;
  EXPECT_TRUE(refused(call.into(out.address()), ABUT_EMPTY, {"count", "0"}));
  for (const std::size_t count : overflowing_counts(sizeof(abut_pose))) {
    call.count = count;
    EXPECT_TRUE(refused(call.into(out.address()), ABUT_SIZE_OVERFLOW, {"count", std::to_string(count)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreateWithMaterials, RefusesNullPointers) {
  Out<abut_shape*> out;
  const CompositeCall call;
  constexpr std::array<std::uint32_t, 2> materials{1, 2};
  const auto create = [&](const abut_shape* const* children, const abut_pose* poses, const std::uint32_t* given,
                          abut_shape** to) {
    return abut_composite_create_with_materials(children, poses, given, 2, to);
  };
  const abut_shape* const* children = call.children.data();
  const abut_pose* poses = call.poses.data();
  EXPECT_TRUE(refused(create(nullptr, poses, materials.data(), out.address()), ABUT_NULL_ARGUMENT, {"children"}));
  EXPECT_TRUE(refused(create(children, nullptr, materials.data(), out.address()), ABUT_NULL_ARGUMENT, {"poses"}));
  EXPECT_TRUE(refused(create(children, poses, nullptr, out.address()), ABUT_NULL_ARGUMENT, {"materials", "null"}));
  EXPECT_TRUE(refused(create(children, poses, materials.data(), nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreateWithMaterials, RefusesNonFiniteAndOtherBadPosesAndCountsThatOverflow) {
  Out<abut_shape*> out;
  CompositeCall call;
  constexpr std::array<std::uint32_t, 2> materials{1, 2};
  for (const std::size_t count : overflowing_counts(sizeof(abut_pose))) {
    EXPECT_TRUE(refused(abut_composite_create_with_materials(call.children.data(), call.poses.data(), materials.data(),
                                                             count, out.address()),
                        ABUT_SIZE_OVERFLOW, {"count", std::to_string(count)}));
  }
  for (const BadPose& bad : bad_poses()) {
    call.poses[1] = bad.pose;
    EXPECT_TRUE(refused(abut_composite_create_with_materials(call.children.data(), call.poses.data(), materials.data(),
                                                             2, out.address()),
                        bad.status, {"poses[1]", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreate, RefusesHolesAlone) {
  Out<abut_shape*> out;
  const double radius = 1;
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof(desc));
  desc.kind = abut_shape_kind_by_name("sphere_hole");
  desc.parameters = &radius;
  desc.parameter_count = 1;
  abut_shape* made = nullptr;
  ASSERT_TRUE(succeeded(abut_shape_create(&desc, &made)));
  const Shape hole(made);
  const std::array<const abut_shape*, 1> children{hole};
  EXPECT_TRUE(refused(abut_composite_create(children.data(), &identity, 1, out.address()), ABUT_EMPTY, {"holes"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CompositeCreate, NestsThirtyTwoDeepAndNoDeeper) {
  Shape inner = make_sphere(1);
  for (int depth = 1; depth <= 32; ++depth) {
    const std::array<const abut_shape*, 1> children{inner};
    abut_shape* made = nullptr;
    ASSERT_TRUE(succeeded(abut_composite_create(children.data(), &identity, 1, &made))) << depth;
    inner = Shape(made);
  }
  Out<abut_shape*> out;
  const std::array<const abut_shape*, 1> children{inner};
  EXPECT_TRUE(refused(abut_composite_create(children.data(), &identity, 1, out.address()), ABUT_OUT_OF_RANGE,
                      {"nesting", "33", "32"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
