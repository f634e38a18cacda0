// SPDX-License-Identifier: Apache-2.0
// Questions about two shapes.
#include "guard.hpp"
#include "pairs/pair_query.hpp"

import abut.capability;

using namespace abut::capi;

namespace {

[[gnu::always_inline]] inline abut_status check_poses(const abut_pose& pose_a, const abut_pose& pose_b) {
  const abut_status status = check_pose({"pose_a"}, pose_a);
  return status != ABUT_OK ? status : check_pose({"pose_b"}, pose_b);
}

[[gnu::always_inline]] inline abut_status distance(const PlacedPair& pair, const abut_query_options* options,
                                                   abut_pair_memory* memory, abut_distance& out) {
  if (const abut_status status = check_poses(pair.pose_a, pair.pose_b); status != ABUT_OK) {
    return status;
  }
  PairQuery query;
  if (const abut_status status = read_options(options, abut::Question::distance, pair.a, pair.b, query);
      status != ABUT_OK) {
    return status;
  }
  // The kernel writes to the struct of the caller: a copy would wait for what it has written.
  const abut::Outcome outcome = find_distance(pair, query, memory, written_as<abut::Distance>(out));
  return outcome == abut::Outcome::ok ? static_cast<abut_status>(ABUT_OK)
                                      : refuse_outcome(outcome, pair.a, pair.b, query.settings.algorithm);
}

[[gnu::always_inline]] inline abut_status contacts(const PlacedPair& pair, const abut_query_options* options,
                                                   abut_pair_memory* memory, std::span<abut_contact> out,
                                                   std::size_t& count) {
  if (const abut_status status = check_poses(pair.pose_a, pair.pose_b); status != ABUT_OK) {
    return status;
  }
  PairQuery query;
  if (const abut_status status = read_options(options, abut::Question::contacts, pair.a, pair.b, query);
      status != ABUT_OK) {
    return status;
  }
  abut::Manifold found;
  found.reserve(usual_points);
  std::size_t kept = 0;
  const abut::Outcome outcome = find_contacts(pair, query, memory, found, kept);
  if (outcome != abut::Outcome::ok) [[unlikely]] {
    return refuse_outcome(outcome, pair.a, pair.b, query.settings.algorithm);
  }
  fill(std::span<const abut::ContactPoint>(found).first(kept), out,
       [](const abut::ContactPoint& contact) { return from_contact(contact); });
  count = kept;
  return ABUT_OK;
}

}  // namespace

void abut_query_options_init(abut_query_options* options, uint32_t struct_size) {
  fill_defaults(default_query_options, struct_size, options);
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
