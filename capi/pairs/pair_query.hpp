// SPDX-License-Identifier: Apache-2.0
// What single questions about two shapes and batches of them share. The way to the kernel and back allocates nothing
// and builds no text unless something is wrong.
#ifndef ABUT_CAPI_PAIR_QUERY_HPP
#define ABUT_CAPI_PAIR_QUERY_HPP

#include "convert.hpp"
#include "options.hpp"
#include "shapes/shape_handle.hpp"

import abut.capability;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.composites.seams;
import abut.pairs.two_shapes.measured_routes;
import abut.pairs.two_shapes.remembered;

namespace abut::capi {

inline constexpr abut_query_options default_query_options{
    sizeof(abut_query_options), ABUT_ALGORITHM_AUTO, 0, 0, 4, 0, 0, 0, 0};

struct PairQuery {
  QuerySettings settings;
  std::uint32_t max_contacts = default_query_options.max_contacts;
  std::uint32_t max_pair_contacts = default_query_options.max_pair_contacts;
  std::uint32_t threads = default_query_options.threads;  // of a batch
};

// What questions about two shapes of any sort ask of their options. The margin is theirs.
[[nodiscard]] abut_status check_query_options(const abut_query_options& options);

// Options of distances and contacts, which may be null.
[[nodiscard]] abut_status read_given_options(const abut_query_options& options, PairQuery& query);
[[nodiscard]] inline abut_status read_options(const abut_query_options* options, PairQuery& query) {
  return options == nullptr ? static_cast<abut_status>(ABUT_OK) : read_given_options(*options, query);
}

// The same for questions among whose routes a time budget chooses. Without options nothing is looked at.
[[nodiscard]] abut_status read_given_options(const abut_query_options& options, Question question, const abut_shape* a,
                                             const abut_shape* b, PairQuery& query);
[[nodiscard]] inline abut_status read_options(const abut_query_options* options, Question question, const abut_shape* a,
                                              const abut_shape* b, PairQuery& query) {
  return options == nullptr ? static_cast<abut_status>(ABUT_OK) : read_given_options(*options, question, a, b, query);
}

// Two shapes at checked poses.
struct [[gsl::Pointer]] PlacedPair {
  const abut_shape *a, *b;
  const abut_pose &pose_a, &pose_b;
};

[[nodiscard]] [[gnu::cold]] abut_status refuse_outcome(Outcome outcome, const abut_shape* a, const abut_shape* b,
                                                       Algorithm algorithm);

static_assert(offsetof(Distance, lower) == offsetof(abut_distance, lower));
static_assert(offsetof(Distance, upper) == offsetof(abut_distance, upper));
static_assert(offsetof(Distance, point_a) == offsetof(abut_distance, point_a));
static_assert(offsetof(Distance, point_b) == offsetof(abut_distance, point_b));
static_assert(offsetof(Distance, normal) == offsetof(abut_distance, normal));
static_assert(offsetof(Distance, algorithm) == offsetof(abut_distance, algorithm));
static_assert(offsetof(Distance, iterations) == offsetof(abut_distance, iterations));

static_assert(sizeof(abut_pair_memory) == 64);

// `memory` may be null.
[[nodiscard]] [[gnu::always_inline]] inline Outcome find_distance(const PlacedPair& pair, const PairQuery& query,
                                                                  abut_pair_memory* memory, Distance& found) {
  const AnyShape &a = shape_of(pair.a), &b = shape_of(pair.b);
  const Pose pose_a = to_pose(pair.pose_a), pose_b = to_pose(pair.pose_b);
  return memory == nullptr ? pair_distance(a, b, pose_a, pose_b, query.settings, found)
                           : pair_distance(a, b, pose_a, pose_b, query.settings, written_as<PairHint>(*memory), found);
}

// Room for the contacts of most pairs, made at once: growing would cost more than many a pair takes. Allocators keep
// blocks of up to a kilobyte at hand for each thread; larger ones take as long as a pair of balls.
inline constexpr std::size_t usual_points = 8;
static_assert(usual_points * sizeof(ContactPoint) <= 1024);

// Into a manifold that is empty; those to report come first, `kept` of them. `memory` may be null.
[[nodiscard]] [[gnu::always_inline]] inline Outcome find_contacts(const PlacedPair& pair, const PairQuery& query,
                                                                  abut_pair_memory* memory, Manifold& found,
                                                                  std::size_t& kept) {
  const AnyShape &a = shape_of(pair.a), &b = shape_of(pair.b);
  const Pose pose_a = to_pose(pair.pose_a), pose_b = to_pose(pair.pose_b);
  const Outcome outcome =
      memory == nullptr ? pair_contacts(a, b, pose_a, pose_b, query.settings, found)
                        : pair_contacts(a, b, pose_a, pose_b, query.settings, written_as<PairHint>(*memory), found);
  if (outcome == Outcome::ok) [[likely]] {
    // Most pairs have nothing to choose from.
    const auto surfaces = [&](const ContactPoint& contact) { return surfaces_of(a, b, contact); };
    kept = found.size() < 2 ? found.size() : reduce_children(found, query.max_contacts, surfaces);
    kept = query.max_pair_contacts == 0 ? kept : cap(std::span(found).first(kept), query.max_pair_contacts);
  }
  return outcome;
}

}  // namespace abut::capi

#endif
