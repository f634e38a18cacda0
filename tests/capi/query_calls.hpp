// SPDX-License-Identifier: Apache-2.0
// All queries on a universe behind one signature, and what each of them has to refuse.
#pragma once

#include "bad_values.hpp"

namespace abut_test {

// All queries behind one signature, with arguments that are good until a test spoils one.
struct QueryCall {
  Scene scene;
  abut_universe* universe = scene.universe;
  abut_ray ray{{-5, 0, 0}, {1, 0, 0}, 20};
  abut_pose pose = at(0.5, 0, 0);
  abut_vec3 vector{1, 0, 0};  // a displacement, a velocity, or a point
  double number = 0.5;        // a margin, the largest distance, or a duration
  const abut_shape* shape = scene.ball;
  Out<abut_query_hit> hit;
  Out<abut_cast_hit> cast;
  Out<abut_impact_hit> impact;
  Out<abut_closest> near;
  Out<std::size_t> count;
  Out<std::uint32_t> found;
  OutArray<std::uint64_t> offsets{2};
  OutArray<abut_geometry_id> geometries{4};

  bool is_untouched() const {
    return hit.is_untouched() && cast.is_untouched() && impact.is_untouched() && near.is_untouched() &&
           count.is_untouched() && found.is_untouched() && offsets.is_untouched() && geometries.is_untouched() &&
           scene.is_unchanged();
  }

  abut_status cast_ray(const abut_query_filter* filter) {
    return abut_universe_cast_ray(universe, &ray, filter, ABUT_HIT_NEAREST, hit.address(), 1, count.address());
  }
  abut_status cast_rays(const abut_query_filter* filter) {
    return abut_universe_cast_rays(universe, &ray, 1, filter, hit.address());
  }
  abut_status cast_shape(const abut_query_filter* filter) {
    return abut_universe_cast_shape(universe, shape, &pose, &vector, filter, ABUT_HIT_NEAREST, cast.address(), 1,
                                    count.address());
  }
  abut_status cast_shapes(const abut_query_filter* filter) {
    return abut_universe_cast_shapes(universe, &shape, &pose, &vector, 1, filter, cast.address());
  }
  abut_movement movement() const {
    abut_movement its{};
    its.velocity = vector;
    return its;
  }
  abut_status cast_movement(const abut_query_filter* filter) {
    const abut_movement its = movement();
    return abut_universe_cast_movement(universe, shape, &pose, &its, number, nullptr, filter, ABUT_HIT_NEAREST,
                                       impact.address(), 1, count.address());
  }
  abut_status cast_movements(const abut_query_filter* filter) {
    const abut_movement its = movement();
    return abut_universe_cast_movements(universe, &shape, &pose, &its, 1, number, nullptr, filter, impact.address());
  }
  abut_status overlaps(const abut_query_filter* filter) {
    return abut_universe_overlaps(universe, shape, &pose, filter, number, geometries.data(), geometries.size(),
                                  count.address());
  }
  abut_status overlaps_of_each(const abut_query_filter* filter) {
    return abut_universe_overlaps_of_each(universe, &shape, &pose, 1, filter, number, offsets.data(), geometries.data(),
                                          geometries.size(), count.address());
  }
  abut_status at_point(const abut_query_filter* filter) {
    return abut_universe_at_point(universe, &vector, filter, geometries.data(), geometries.size(), count.address());
  }
  abut_status at_points(const abut_query_filter* filter) {
    return abut_universe_at_points(universe, &vector, 1, filter, offsets.data(), geometries.data(), geometries.size(),
                                   count.address());
  }
  abut_status closest(const abut_query_filter* filter) {
    return abut_universe_closest(universe, shape, &pose, number, filter, near.address(), found.address());
  }
  abut_status closest_to_each(const abut_query_filter* filter) {
    return abut_universe_closest_to_each(universe, &shape, &pose, 1, number, filter, near.address());
  }
};

using Ask = abut_status (QueryCall::*)(const abut_query_filter*);

inline void refuse_bad_filters(Ask ask) {
  QueryCall call;
  const auto refuses = [&](abut_query_filter filter, abut_status status,
                           std::initializer_list<std::string_view> words) {
    EXPECT_TRUE(refused((call.*ask)(&filter), status, words));
  };
  abut_query_filter filter = default_filter();
  filter.flags = 2;
  refuses(filter, ABUT_UNKNOWN_VALUE, {"filter.flags", "2"});
  filter = default_filter();
  filter.ray_start = 3;
  refuses(filter, ABUT_UNKNOWN_VALUE, {"filter.ray_start", "3"});
  filter = default_filter();
  filter.reserved = 31;
  refuses(filter, ABUT_INVALID_ARGUMENT, {"filter.reserved", "31"});
  for (const abut_part_id& part : call.scene.stale_parts) {
    if (part.slot == 0 && part.generation == 0) continue;  // no part
    filter = default_filter();
    filter.ignore_part = part;
    refuses(filter, ABUT_STALE_ID, {"filter.ignore_part"});
  }
  for (const abut_geometry_id& geometry : call.scene.stale_geometries) {
    if (geometry.slot == 0 && geometry.generation == 0) continue;  // no geometry
    filter = default_filter();
    filter.ignore_geometry = geometry;
    refuses(filter, ABUT_STALE_ID, {"filter.ignore_geometry"});
  }
  expect_struct_size_checked(default_filter(), [&](const abut_query_filter* wrong) { return (call.*ask)(wrong); });
  EXPECT_TRUE(call.is_untouched());
  expect_zero_tail_accepted(default_filter(), [&](const abut_query_filter* later) { return (call.*ask)(later); });
}

inline void refuse_bad_rays(Ask ask) {
  QueryCall call;
  const abut_ray good = call.ray;
  for (const BadVector& bad : non_finite_vectors()) {
    call.ray = good;
    call.ray.origin = bad.vector;
    EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_NOT_FINITE, {"origin", bad.word}));
    call.ray = good;
    call.ray.direction = bad.vector;
    EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_NOT_FINITE, {"direction", bad.word}));
  }
  call.ray = good;
  call.ray.max_distance = not_a_number;
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_NOT_FINITE, {"max_distance", "nan"}));
  call.ray.max_distance = -2.5;
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_OUT_OF_RANGE, {"max_distance", "-2.5"}));
  call.ray = good;
  call.ray.direction = {0, 0, 0};
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_ZERO_VECTOR, {"direction"}));
  EXPECT_TRUE(call.is_untouched());
}

inline void refuse_bad_poses(Ask ask) {
  QueryCall call;
  expect_pose_field_checked([&](const abut_pose& bad) {
    call.pose = bad;
    return (call.*ask)(nullptr);
  });
  EXPECT_TRUE(call.is_untouched());
}

inline void refuse_bad_durations(Ask ask) {
  QueryCall call;
  for (const BadNumber& bad : non_finite_numbers) {
    call.number = bad.value;
    EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_NOT_FINITE, {"duration", bad.word}));
  }
  call.number = -2.5;
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_OUT_OF_RANGE, {"duration", "-2.5"}));
  EXPECT_TRUE(call.is_untouched());
}

inline void refuse_bad_largest_distances(Ask ask) {
  QueryCall call;
  call.number = not_a_number;
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_NOT_FINITE, {"max_distance", "nan"}));
  call.number = -2.5;
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_OUT_OF_RANGE, {"max_distance", "-2.5"}));
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace abut_test
