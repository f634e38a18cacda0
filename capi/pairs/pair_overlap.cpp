// SPDX-License-Identifier: Apache-2.0
// Whether two shapes overlap.
#include "guard.hpp"
#include "pairs/pair_query.hpp"

import abut.capability;
import abut.core.workers;
import abut.pairs.two_shapes.overlap;

using namespace abut::capi;

namespace {

abut_status read_overlap_options(const abut_query_options* options, PairQuery& query) {
  const abut_status status = read_options(options, query);
  if (status == ABUT_OK && query.settings.algorithm != abut::Algorithm::automatic) {
    return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + std::to_string(options->algorithm) +
                                        "; whether shapes overlap has no other way than ABUT_ALGORITHM_AUTO");
  }
  return status;
}

// `out`: 1 or 0.
[[nodiscard]] abut::Outcome overlaps(const PlacedPair& pair, const PairQuery& query, std::uint32_t& out) {
  const abut::AnyShape &a = shape_of(pair.a), &b = shape_of(pair.b);
  // Most pairs need no more than their positions.
  if (abut::are_far_apart(a, b, to_vec3(pair.pose_a.position), to_vec3(pair.pose_b.position), query.settings.margin)) {
    out = 0;
    return abut::Outcome::ok;
  }
  bool answer = false;
  abut::Manifold scratch;
  const abut::Outcome outcome =
      abut::pair_overlaps(a, b, to_pose(pair.pose_a), to_pose(pair.pose_b), query.settings.margin,
                          abut::OverlapRule::of_distances, scratch, answer);
  out = answer ? 1 : 0;
  return outcome;
}

struct [[gsl::Pointer]] PlacedPairs {
  std::span<const abut_shape* const> shapes_a, shapes_b;
  std::span<const abut_pose> poses_a, poses_b;

  [[nodiscard]] PlacedPair at(std::size_t i) const { return {shapes_a[i], shapes_b[i], poses_a[i], poses_b[i]}; }
};

abut_status check_pairs(const PlacedPairs& pairs) {
  abut_status status = ABUT_OK;
  for (std::size_t i = 0; status == ABUT_OK && i < pairs.poses_a.size(); ++i) {
    if (pairs.shapes_a[i] == nullptr || pairs.shapes_b[i] == nullptr) [[unlikely]] {
      return check_not_null(Where{pairs.shapes_a[i] == nullptr ? "shapes_a" : "shapes_b", i}.with(""), nullptr);
    }
    status = check_pose({"poses_a", i}, pairs.poses_a[i]);
    status = status != ABUT_OK ? status : check_pose({"poses_b", i}, pairs.poses_b[i]);
  }
  return status;
}

// Nothing is written before all have an answer.
abut_status overlaps_of_each(const PlacedPairs& pairs, const abut_query_options* options,
                             std::span<std::uint32_t> out) {
  constexpr std::size_t least_of_task = 64;
  PairQuery query;
  abut_status status = read_overlap_options(options, query);
  status = status != ABUT_OK ? status : check_pairs(pairs);
  if (status != ABUT_OK) {
    return status;
  }
  const abut::Workers workers(out.size() < 2 * least_of_task ? 1 : query.threads);
  const abut::Cuts cuts = workers.cut(out.size(), least_of_task);
  std::vector<std::uint32_t> found(out.size());
  std::vector<abut::Outcome> outcomes(out.size(), abut::Outcome::ok);
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    for (std::size_t i = cuts.begin(task); i < cuts.end(task); ++i) {
      outcomes[i] = overlaps(pairs.at(i), query, found[i]);
    }
  });
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (outcomes[i] != abut::Outcome::ok) [[unlikely]] {
      const PlacedPair pair = pairs.at(i);
      status = refuse_outcome(outcomes[i], pair.a, pair.b, query.settings.algorithm);
      set_message("pair " + std::to_string(i) + ": " + abut_last_error_message());
      return status;
    }
  }
  std::ranges::copy(found, out.begin());
  return ABUT_OK;
}

}  // namespace

abut_status abut_pair_overlaps(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                               const abut_pose* pose_b, const abut_query_options* options, uint32_t* out) {
  return guard([&] {
    abut_status status =
        check_none_null<5>({{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"out", out}}});
    status = status != ABUT_OK ? status : check_pose({"pose_a"}, *pose_a);
    status = status != ABUT_OK ? status : check_pose({"pose_b"}, *pose_b);
    PairQuery query;
    status = status != ABUT_OK ? status : read_overlap_options(options, query);
    if (status != ABUT_OK) {
      return status;
    }
    std::uint32_t answer = 0;
    const abut::Outcome outcome = overlaps({a, b, *pose_a, *pose_b}, query, answer);
    if (outcome != abut::Outcome::ok) [[unlikely]] {
      return refuse_outcome(outcome, a, b, query.settings.algorithm);
    }
    *out = answer;
    return static_cast<abut_status>(ABUT_OK);
  });
}

abut_status abut_pairs_overlap(const abut_shape* const* shapes_a, const abut_pose* poses_a,
                               const abut_shape* const* shapes_b, const abut_pose* poses_b, size_t count,
                               const abut_query_options* options, uint32_t* out) {
  return guard([&] {
    PlacedPairs pairs;
    std::span<std::uint32_t> answers;
    abut_status status = read_span("shapes_a", shapes_a, "count", count, pairs.shapes_a);
    status = status != ABUT_OK ? status : read_span("poses_a", poses_a, "count", count, pairs.poses_a);
    status = status != ABUT_OK ? status : read_span("shapes_b", shapes_b, "count", count, pairs.shapes_b);
    status = status != ABUT_OK ? status : read_span("poses_b", poses_b, "count", count, pairs.poses_b);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, answers);
    return status != ABUT_OK ? status : overlaps_of_each(pairs, options, answers);
  });
}
