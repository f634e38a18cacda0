// SPDX-License-Identifier: Apache-2.0
// Particles and composites under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 6> two_places{0, 0, 0, 1, 2, 3};

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
