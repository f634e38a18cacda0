// SPDX-License-Identifier: Apache-2.0
// Two shapes that move.
#include "guard.hpp"
#include "pairs/answers.hpp"
#include "pairs/pair_batch.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape.casts.shape_cast;

using namespace abut::capi;

namespace {

abut_status read_cast_options(const abut_query_options* options, PairQuery& query) {
  if (options == nullptr) {
    return ABUT_OK;
  }
  abut_status status = check_query_options(*options);
  status = status != ABUT_OK ? status : to_status(abut::check_not_negative("options.margin", options->margin));
  if (status == ABUT_OK && options->algorithm != ABUT_ALGORITHM_AUTO) {
    return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + std::to_string(options->algorithm) +
                                        "; moving shapes have no other way than ABUT_ALGORITHM_AUTO");
  }
  return status != ABUT_OK ? status : read_options(options, query);
}

// Of two shapes that move at checked poses.
struct Ways {
  abut_vec3 a, b;
};

// `hit` is written where they touch.
abut::Outcome cast(const PlacedPair& pair, const Ways& ways, const abut::QuerySettings& settings, abut_cast_hit& hit,
                   bool& is_met) {
  std::optional<abut::ShapeCastHit> met;
  const abut::Outcome outcome =
      abut::cast_shapes(shape_of(pair.a), to_pose(pair.pose_a), to_vec3(ways.a), shape_of(pair.b), to_pose(pair.pose_b),
                        to_vec3(ways.b), settings, 1, met);
  if (met) {
    hit = from_cast({}, *met);
  }
  is_met = met.has_value();
  return outcome;
}

abut_status cast_one(const PlacedPair& pair, const Ways& ways, const abut_query_options* options, abut_cast_hit& hit,
                     std::uint32_t& found) {
  PairQuery query;
  abut_status status = check_pose({"pose_a"}, pair.pose_a);
  status = status != ABUT_OK ? status : check_position({"displacement_a"}, "", ways.a);
  status = status != ABUT_OK ? status : check_pose({"pose_b"}, pair.pose_b);
  status = status != ABUT_OK ? status : check_position({"displacement_b"}, "", ways.b);
  status = status != ABUT_OK ? status : read_cast_options(options, query);
  if (status != ABUT_OK) {
    return status;
  }
  bool is_met = false;
  const abut::Outcome outcome = cast(pair, ways, query.settings, hit, is_met);
  if (outcome != abut::Outcome::ok) {
    return refuse_outcome(outcome, pair.a, pair.b, query.settings.algorithm);
  }
  found = is_met ? 1 : 0;
  return ABUT_OK;
}

struct [[gsl::Pointer]] WaysOfEach {
  std::span<const abut_vec3> a, b;
};

abut_status read_ways(const abut_vec3* displacements_a, const abut_vec3* displacements_b, std::size_t count,
                      WaysOfEach& ways) {
  abut_status status = read_span("displacements_a", displacements_a, "count", count, ways.a);
  status = status != ABUT_OK ? status : read_span("displacements_b", displacements_b, "count", count, ways.b);
  for (std::size_t i = 0; status == ABUT_OK && i < count; ++i) {
    status = check_position({"displacements_a", i}, "", ways.a[i]);
    status = status != ABUT_OK ? status : check_position({"displacements_b", i}, "", ways.b[i]);
  }
  return status;
}

abut_status cast_each(const PairBatch& pairs, const WaysOfEach& ways, const abut_query_options* options,
                      std::span<abut_cast_hit> out) {
  PairQuery query;
  if (const abut_status status = read_cast_options(options, query); status != ABUT_OK) {
    return status;
  }
  return answer_each(pairs, query.settings.algorithm, query.threads, out, [&](std::size_t i, abut_cast_hit& hit) {
    bool is_met = false;
    const abut::Outcome outcome = cast(pairs.at(i), {ways.a[i], ways.b[i]}, query.settings, hit, is_met);
    if (!is_met) {
      hit.fraction = std::numeric_limits<double>::infinity();
    }
    return outcome;
  });
}

}  // namespace

abut_status abut_pair_cast(const abut_shape* a, const abut_pose* pose_a, const abut_vec3* displacement_a,
                           const abut_shape* b, const abut_pose* pose_b, const abut_vec3* displacement_b,
                           const abut_query_options* options, abut_cast_hit* hit, uint32_t* found) {
  return guard([&] {
    const abut_status status = check_none_null<8>({{{"a", a},
                                                    {"pose_a", pose_a},
                                                    {"displacement_a", displacement_a},
                                                    {"b", b},
                                                    {"pose_b", pose_b},
                                                    {"displacement_b", displacement_b},
                                                    {"hit", hit},
                                                    {"found", found}}});
    return status != ABUT_OK
               ? status
               : cast_one({a, b, *pose_a, *pose_b}, {*displacement_a, *displacement_b}, options, *hit, *found);
  });
}

abut_status abut_pairs_cast(const abut_shape* a, const abut_pose* poses_a, const abut_vec3* displacements_a,
                            const abut_shape* b, const abut_pose* poses_b, const abut_vec3* displacements_b,
                            size_t count, const abut_query_options* options, abut_cast_hit* hits) {
  return guard([&] {
    PairBatch pairs{};
    WaysOfEach ways;
    std::span<abut_cast_hit> out;
    abut_status status = read_span("hits", hits, "count", count, out);
    status = status != ABUT_OK ? status : read_batch(a, poses_a, b, poses_b, "count", count, pairs);
    status = status != ABUT_OK ? status : read_ways(displacements_a, displacements_b, count, ways);
    return status != ABUT_OK ? status : cast_each(pairs, ways, options, out);
  });
}
