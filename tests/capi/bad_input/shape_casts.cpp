// SPDX-License-Identifier: Apache-2.0
// Two shapes that move, under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Two shapes, each with a pose and a displacement.
struct CastCall {
  Shape a = make_sphere(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  abut_pose pose_a = identity;
  abut_pose pose_b = at(5.0, 0.0, 0.0);
  abut_vec3 displacement_a{1, 0, 0};
  abut_vec3 displacement_b{-9, 0, 0};
  Out<abut_cast_hit> hit;
  Out<std::uint32_t> found;

  abut_status ask(const abut_query_options* options) {
    return abut_pair_cast(a, &pose_a, &displacement_a, b, &pose_b, &displacement_b, options, hit.address(),
                          found.address());
  }
  bool is_untouched() const { return hit.is_untouched() && found.is_untouched(); }
};

TEST(PairCast, RefusesNull) {
  CastCall call;
  const auto refuses = [](abut_status status, std::string_view name) {
    EXPECT_TRUE(refused(status, ABUT_NULL_ARGUMENT, {name, "null"}));
  };
  abut_cast_hit* hit = call.hit.address();
  std::uint32_t* found = call.found.address();
  const abut_pose* pose = &call.pose_a;
  const abut_vec3* way = &call.displacement_a;
  refuses(abut_pair_cast(nullptr, pose, way, call.b, pose, way, nullptr, hit, found), "a");
  refuses(abut_pair_cast(call.a, nullptr, way, call.b, pose, way, nullptr, hit, found), "pose_a");
  refuses(abut_pair_cast(call.a, pose, nullptr, call.b, pose, way, nullptr, hit, found), "displacement_a");
  refuses(abut_pair_cast(call.a, pose, way, nullptr, pose, way, nullptr, hit, found), "b");
  refuses(abut_pair_cast(call.a, pose, way, call.b, nullptr, way, nullptr, hit, found), "pose_b");
  refuses(abut_pair_cast(call.a, pose, way, call.b, pose, nullptr, nullptr, hit, found), "displacement_b");
  refuses(abut_pair_cast(call.a, pose, way, call.b, pose, way, nullptr, nullptr, found), "hit");
  refuses(abut_pair_cast(call.a, pose, way, call.b, pose, way, nullptr, hit, nullptr), "found");
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairCast, RefusesBadPoses) {
  for (const bool is_first : {true, false}) {
    CastCall call;
    expect_pose_field_checked([&](const abut_pose& bad) {
      (is_first ? call.pose_a : call.pose_b) = bad;
      return call.ask(nullptr);
    });
    EXPECT_TRUE(call.is_untouched());
  }
}

TEST(PairCast, RefusesBadOptions) {
  CastCall call;
  abut_query_options good;
  abut_query_options_init(&good, sizeof good);
  abut_query_options options = good;
  options.margin = -0.5;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"margin", "-0.5"}));
  options = good;
  options.error_bound = -2.5;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"error_bound", "-2.5"}));
  options = good;
  options.algorithm = 77;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_UNKNOWN_VALUE, {"algorithm", "77"}));
  options.algorithm = ABUT_ALGORITHM_SAT;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_UNSUPPORTED, {"algorithm"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairCast, RefusesPlanesAgainstPlanes) {
  CastCall call;
  call.a = make_plane({0.0, 0.0, 1.0}, 0.0);
  call.b = make_plane({0.0, 0.0, 1.0}, 0.0);
  EXPECT_TRUE(refused(call.ask(nullptr), ABUT_UNSUPPORTED, {"plane"}));
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace
