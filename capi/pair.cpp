// SPDX-License-Identifier: Apache-2.0
// Questions about two shapes. The way to the kernel and back allocates nothing and builds no text
// unless something is wrong.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shape_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.registry;

using namespace abut::capi;

namespace {

constexpr abut_query_options default_options{sizeof(abut_query_options), ABUT_ALGORITHM_AUTO, 0, 0, 4, 0};

constexpr std::array<std::string_view, 6> algorithm_names{"ABUT_ALGORITHM_AUTO",       "ABUT_ALGORITHM_ANALYTIC",
                                                          "ABUT_ALGORITHM_SAT",        "ABUT_ALGORITHM_GJK_EPA",
                                                          "ABUT_ALGORITHM_LIBCCD_GJK", "ABUT_ALGORITHM_LIBCCD_MPR"};

struct Query {
  abut::QuerySettings settings;
  std::uint32_t max_contacts = default_options.max_contacts;
  std::uint32_t max_pair_contacts = default_options.max_pair_contacts;
};

abut_status read_given_options(const abut_query_options& options, Query& query) {
  if (const abut_status status = check_struct_size({"options"}, options); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_value({"options"}, ".algorithm", options.algorithm, ABUT_ALGORITHM_LIBCCD_MPR);
      status != ABUT_OK) {
    return status;
  }
  if (!(options.error_bound >= 0 && options.error_bound <= abut::largest_coordinate)) {
    return to_status(abut::check_not_negative("options.error_bound", options.error_bound));
  }
  if (!is_coordinate(options.margin)) {
    return to_status(abut::check_finite("options.margin", options.margin));
  }
  query.settings.algorithm = static_cast<abut::Algorithm>(options.algorithm);
  if (options.error_bound > 0) {
    query.settings.error_bound = options.error_bound;
  }
  query.settings.margin = options.margin;
  query.max_contacts = options.max_contacts;
  query.max_pair_contacts = options.max_pair_contacts;
  return ABUT_OK;
}

inline abut_status read_options(const abut_query_options* options, Query& query) {
  return options == nullptr ? static_cast<abut_status>(ABUT_OK) : read_given_options(*options, query);
}

[[gnu::always_inline]] inline abut_status check_poses(const abut_pose& pose_a, const abut_pose& pose_b) {
  const abut_status status = check_pose({"pose_a"}, pose_a);
  return status != ABUT_OK ? status : check_pose({"pose_b"}, pose_b);
}

[[gnu::cold]] abut_status refuse_outcome(abut::Outcome outcome, const abut::AnyShape& a, const abut::AnyShape& b,
                                         abut::Algorithm algorithm) {
  const std::string pair = std::string(abut::kind_name(a.index())) + " and " + std::string(abut::kind_name(b.index()));
  const std::string with(algorithm_names[static_cast<std::size_t>(algorithm)]);
  if (outcome == abut::Outcome::unsupported && algorithm == abut::Algorithm::automatic) {
    return refuse(ABUT_UNSUPPORTED, "there is no algorithm for " + pair);
  }
  switch (outcome) {
    case abut::Outcome::apart:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with +
                                          ", which only tells how deep shapes overlap; this " + pair + " are apart");
    case abut::Outcome::unsupported:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with + "; there is no such way for " + pair);
    case abut::Outcome::not_converged: return refuse(ABUT_NOT_CONVERGED, with + " gave up on " + pair);
    case abut::Outcome::ok: break;
  }
  return ABUT_OK;
}

static_assert(offsetof(abut::Distance, lower) == offsetof(abut_distance, lower));
static_assert(offsetof(abut::Distance, upper) == offsetof(abut_distance, upper));
static_assert(offsetof(abut::Distance, point_a) == offsetof(abut_distance, point_a));
static_assert(offsetof(abut::Distance, point_b) == offsetof(abut_distance, point_b));
static_assert(offsetof(abut::Distance, normal) == offsetof(abut_distance, normal));
static_assert(offsetof(abut::Distance, algorithm) == offsetof(abut_distance, algorithm));
static_assert(offsetof(abut::Distance, iterations) == offsetof(abut_distance, iterations));

static_assert(sizeof(abut_pair_memory) == 64);

struct PlacedPair {
  const abut_shape *a, *b;
  const abut_pose &pose_a, &pose_b;
};

// For poses that were checked. `memory` may be null.
[[gnu::always_inline]] inline abut_status find_distance(const PlacedPair& pair, const abut::QuerySettings& settings,
                                                        abut_pair_memory* memory, abut::Distance& found) {
  const abut::AnyShape &a = shape_of(pair.a), &b = shape_of(pair.b);
  const abut::Pose pose_a = to_pose(pair.pose_a), pose_b = to_pose(pair.pose_b);
  const abut::Outcome outcome = memory == nullptr ? abut::pair_distance(a, b, pose_a, pose_b, settings, found)
                                                  : abut::pair_distance(a, b, pose_a, pose_b, settings,
                                                                        written_as<abut::PairHint>(*memory), found);
  return outcome == abut::Outcome::ok ? static_cast<abut_status>(ABUT_OK)
                                      : refuse_outcome(outcome, a, b, settings.algorithm);
}

[[gnu::always_inline]] inline abut_status distance(const PlacedPair& pair, const abut_query_options* options,
                                                   abut_pair_memory* memory, abut_distance& out) {
  if (const abut_status status = check_poses(pair.pose_a, pair.pose_b); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  // The kernel writes to the struct of the caller: a copy would wait for what it has written.
  return find_distance(pair, query.settings, memory, written_as<abut::Distance>(out));
}

struct PairBatch {
  const abut_shape *a, *b;
  std::span<const abut_pose> poses_a, poses_b;
  std::span<abut_pair_memory> memories;  // none, or one for each pair
};

abut_status check_batch(const PairBatch& pairs) {
  for (std::size_t i = 0; i < pairs.poses_a.size(); ++i) {
    if (const abut_status status = check_pose({"poses_a", i}, pairs.poses_a[i]); status != ABUT_OK) {
      return status;
    }
    if (const abut_status status = check_pose({"poses_b", i}, pairs.poses_b[i]); status != ABUT_OK) {
      return status;
    }
  }
  return ABUT_OK;
}

abut_status read_batch(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b, const abut_pose* poses_b,
                       std::size_t count, PairBatch& pairs) {
  pairs.a = a;
  pairs.b = b;
  abut_status status = check_none_null<2>({{{"a", a}, {"b", b}}});
  status = status != ABUT_OK ? status : read_span("poses_a", poses_a, "count", count, pairs.poses_a);
  return status != ABUT_OK ? status : read_span("poses_b", poses_b, "count", count, pairs.poses_b);
}

abut_status distances(const PairBatch& pairs, const abut_query_options* options, std::span<abut_distance> out) {
  if (const abut_status status = check_batch(pairs); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  // A kernel may fail at the last pair, and then nothing must have been written. Those that have memories never fail
  // after the first pair.
  std::vector<abut_distance> found;
  found.reserve(out.size());
  for (std::size_t i = 0; i < pairs.poses_a.size(); ++i) {
    [[clang::uninitialized]] abut::Distance one;
    abut_pair_memory* memory = pairs.memories.empty() ? nullptr : &pairs.memories[i];
    if (const abut_status status =
            find_distance({pairs.a, pairs.b, pairs.poses_a[i], pairs.poses_b[i]}, query.settings, memory, one);
        status != ABUT_OK) {
      set_message("pair " + std::to_string(i) + ": " + abut_last_error_message());
      return status;
    }
    found.push_back(std::bit_cast<abut_distance>(one));
  }
  std::copy(found.begin(), found.end(), out.begin());
  return ABUT_OK;
}

// Room for the contacts of most pairs, made at once: growing would cost more than many a pair takes. Allocators keep
// blocks of up to a kilobyte at hand for each thread; larger ones take as long as a pair of balls.
constexpr std::size_t usual_points = 8;
static_assert(usual_points * sizeof(abut::ContactPoint) <= 1024);

[[gnu::always_inline]] inline abut_status contacts(const PlacedPair& pair, const abut_query_options* options,
                                                   abut_pair_memory* memory, std::span<abut_contact> out,
                                                   std::size_t& count) {
  if (const abut_status status = check_poses(pair.pose_a, pair.pose_b); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  abut::Manifold found;
  found.reserve(usual_points);
  const abut::AnyShape &a = shape_of(pair.a), &b = shape_of(pair.b);
  const abut::Pose pose_a = to_pose(pair.pose_a), pose_b = to_pose(pair.pose_b);
  const abut::Outcome outcome = memory == nullptr ? abut::pair_contacts(a, b, pose_a, pose_b, query.settings, found)
                                                  : abut::pair_contacts(a, b, pose_a, pose_b, query.settings,
                                                                        written_as<abut::PairHint>(*memory), found);
  if (outcome != abut::Outcome::ok) [[unlikely]] {
    return refuse_outcome(outcome, a, b, query.settings.algorithm);
  }
  // Most pairs have nothing to choose from.
  std::size_t kept = found.size() < 2 ? found.size() : abut::reduce_children(found, query.max_contacts);
  kept = query.max_pair_contacts == 0 ? kept : abut::cap(std::span(found).first(kept), query.max_pair_contacts);
  fill(std::span<const abut::ContactPoint>(found).first(kept), out,
       [](const abut::ContactPoint& contact) { return from_contact(contact); });
  count = kept;
  return ABUT_OK;
}

}  // namespace

void abut_query_options_init(abut_query_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_pair_distance(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                               const abut_pose* pose_b, const abut_query_options* options, abut_distance* out) {
  return guard([&] {
    const abut_status status =
        check_none_null<5>({{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"out", out}}});
    return status != ABUT_OK ? status : distance({a, b, *pose_a, *pose_b}, options, nullptr, *out);
  });
}

abut_status abut_pair_distance_with_memory(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                                           const abut_pose* pose_b, const abut_query_options* options,
                                           abut_pair_memory* memory, abut_distance* out) {
  return guard([&] {
    const abut_status status = check_none_null<6>(
        {{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"memory", memory}, {"out", out}}});
    return status != ABUT_OK ? status : distance({a, b, *pose_a, *pose_b}, options, memory, *out);
  });
}

abut_status abut_pairs_distance(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                const abut_pose* poses_b, size_t count, const abut_query_options* options,
                                abut_distance* out) {
  return guard([&] {
    PairBatch pairs{};
    std::span<abut_distance> results;
    abut_status status = read_batch(a, poses_a, b, poses_b, count, pairs);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, results);
    return status != ABUT_OK ? status : distances(pairs, options, results);
  });
}

abut_status abut_pairs_distance_with_memories(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                              const abut_pose* poses_b, size_t count, const abut_query_options* options,
                                              abut_pair_memory* memories, abut_distance* out) {
  return guard([&] {
    PairBatch pairs{};
    std::span<abut_distance> results;
    abut_status status = read_batch(a, poses_a, b, poses_b, count, pairs);
    status = status != ABUT_OK ? status : read_span("memories", memories, "count", count, pairs.memories);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, results);
    return status != ABUT_OK ? status : distances(pairs, options, results);
  });
}

abut_status abut_pair_contacts(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                               const abut_pose* pose_b, const abut_query_options* options, abut_contact* contacts_out,
                               size_t capacity, size_t* count) {
  return guard([&] {
    std::span<abut_contact> results;
    abut_status status =
        check_none_null<5>({{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("contacts", contacts_out, "capacity", capacity, results);
    return status != ABUT_OK ? status : contacts({a, b, *pose_a, *pose_b}, options, nullptr, results, *count);
  });
}

abut_status abut_pair_contacts_with_memory(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                                           const abut_pose* pose_b, const abut_query_options* options,
                                           abut_pair_memory* memory, abut_contact* contacts_out, size_t capacity,
                                           size_t* count) {
  return guard([&] {
    std::span<abut_contact> results;
    abut_status status = check_none_null<6>(
        {{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"memory", memory}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("contacts", contacts_out, "capacity", capacity, results);
    return status != ABUT_OK ? status : contacts({a, b, *pose_a, *pose_b}, options, memory, results, *count);
  });
}
