// SPDX-License-Identifier: Apache-2.0
// Distances and contacts of two shapes at many pairs of poses.
#include "guard.hpp"
#include "pairs/pair_batch.hpp"

import abut.capability;

namespace abut::capi {

abut_status read_batch(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b, const abut_pose* poses_b,
                       std::string_view count_name, std::size_t count, PairBatch& pairs) {
  pairs.a = a;
  pairs.b = b;
  abut_status status = check_none_null<2>({{{"a", a}, {"b", b}}});
  status = status != ABUT_OK ? status : read_span("poses_a", poses_a, count_name, count, pairs.poses_a);
  status = status != ABUT_OK ? status : read_span("poses_b", poses_b, count_name, count, pairs.poses_b);
  for (std::size_t i = 0; status == ABUT_OK && i < count; ++i) {
    status = check_pose({"poses_a", i}, pairs.poses_a[i]);
    status = status != ABUT_OK ? status : check_pose({"poses_b", i}, pairs.poses_b[i]);
  }
  return status;
}

abut_status refuse_pair(std::size_t number, Outcome outcome, const PairBatch& pairs, Algorithm algorithm) {
  const abut_status status = refuse_outcome(outcome, pairs.a, pairs.b, algorithm);
  set_message("pair " + std::to_string(number) + ": " + abut_last_error_message());
  return status;
}

}  // namespace abut::capi

using namespace abut::capi;

namespace {

// The memory of a pair; null where the batch has none.
abut_pair_memory* memory_of(std::span<abut_pair_memory> memories, std::size_t i) {
  return memories.empty() ? nullptr : &memories[i];
}

// Pairs that have memories never fail after the first one, so that a failure leaves memories as they are.
abut_status distances(const PairBatch& pairs, const abut_query_options* options, std::span<abut_pair_memory> memories,
                      std::span<abut_distance> out) {
  PairQuery query;
  if (const abut_status status = read_options(options, abut::Question::distance, pairs.a, pairs.b, query);
      status != ABUT_OK) {
    return status;
  }
  return answer_each(pairs, query.settings.algorithm, query.threads, out, [&](std::size_t i, abut_distance& found) {
    return find_distance(pairs.at(i), query, memory_of(memories, i), written_as<abut::Distance>(found));
  });
}

// Contacts of the pairs of one task.
struct FoundContacts {
  abut::Manifold points, of_pair;
  std::vector<std::uint64_t> counts;

  // Memory that grows is given back and asked for again in the next batch: that takes longer than the contacts. What is
  // not written costs nothing.
  void reserve(std::size_t pairs) {
    constexpr std::size_t points_of_pair = 4, most_points = 1 << 16;
    points.reserve(std::min(points_of_pair * pairs, most_points));
    of_pair.reserve(usual_points);
    counts.reserve(pairs);
  }
};

abut_status contacts(const PairBatch& pairs, const abut_query_options* options, std::span<abut_pair_memory> memories,
                     std::span<std::uint64_t> offsets, std::span<abut_contact> out, std::size_t& count) {
  PairQuery query;
  if (const abut_status status = read_options(options, abut::Question::contacts, pairs.a, pairs.b, query);
      status != ABUT_OK) {
    return status;
  }
  BatchTasks<FoundContacts> tasks(pairs.size(), query.threads);
  const abut_status status = tasks.run(pairs, query.settings.algorithm, [&](std::size_t i, FoundContacts& found) {
    std::size_t kept = 0;
    found.of_pair.clear();
    const abut::Outcome outcome = find_contacts(pairs.at(i), query, memory_of(memories, i), found.of_pair, kept);
    const auto first = found.of_pair.begin(), last = first + static_cast<std::ptrdiff_t>(kept);
    if (!out.empty()) {
      found.points.insert(found.points.end(), first, last);
    }
    found.counts.push_back(kept);
    return outcome;
  });
  if (status != ABUT_OK) {
    return status;
  }
  offsets[0] = 0;
  tasks.hand_over_in_order([&](std::size_t first, const FoundContacts& found) {
    for (std::size_t i = 0; i < found.counts.size(); ++i) {
      offsets[first + i + 1] = offsets[first + i] + found.counts[i];
    }
  });
  tasks.hand_over([&](std::size_t first, const FoundContacts& found) {
    const std::size_t place = std::min<std::size_t>(offsets[first], out.size());
    fill(std::span<const abut::ContactPoint>(found.points), out.subspan(place),
         [](const abut::ContactPoint& contact) { return from_contact(contact); });
  });
  count = offsets.back();
  return ABUT_OK;
}

abut_status ask_contacts(const PairBatch& pairs, const abut_query_options* options,
                         std::span<abut_pair_memory> memories, std::uint64_t* offsets, abut_contact* contacts_out,
                         std::size_t capacity, std::size_t* count) {
  std::span<std::uint64_t> starts;
  std::span<abut_contact> out;
  abut_status status = check_not_null("count", count);
  status = status != ABUT_OK ? status : read_offsets(offsets, "pair_count", pairs.size(), starts);
  status = status != ABUT_OK ? status : read_span("contacts", contacts_out, "capacity", capacity, out);
  return status != ABUT_OK ? status : contacts(pairs, options, memories, starts, out, *count);
}

}  // namespace

abut_status abut_pairs_distance(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                const abut_pose* poses_b, size_t count, const abut_query_options* options,
                                abut_distance* out) {
  return guard([&] {
    PairBatch pairs{};
    std::span<abut_distance> results;
    abut_status status = read_span("out", out, "count", count, results);
    status = status != ABUT_OK ? status : read_batch(a, poses_a, b, poses_b, "count", count, pairs);
    return status != ABUT_OK ? status : distances(pairs, options, {}, results);
  });
}

abut_status abut_pairs_distance_with_memories(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                              const abut_pose* poses_b, size_t count, const abut_query_options* options,
                                              abut_pair_memory* memories, abut_distance* out) {
  return guard([&] {
    PairBatch pairs{};
    std::span<abut_distance> results;
    std::span<abut_pair_memory> its_memories;
    abut_status status = read_span("out", out, "count", count, results);
    status = status != ABUT_OK ? status : read_span("memories", memories, "count", count, its_memories);
    status = status != ABUT_OK ? status : read_batch(a, poses_a, b, poses_b, "count", count, pairs);
    return status != ABUT_OK ? status : distances(pairs, options, its_memories, results);
  });
}

abut_status abut_pairs_contacts(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                const abut_pose* poses_b, size_t pair_count, const abut_query_options* options,
                                uint64_t* offsets, abut_contact* contacts_out, size_t capacity, size_t* count) {
  return guard([&] {
    PairBatch pairs{};
    const abut_status status = read_batch(a, poses_a, b, poses_b, "pair_count", pair_count, pairs);
    return status != ABUT_OK ? status : ask_contacts(pairs, options, {}, offsets, contacts_out, capacity, count);
  });
}

abut_status abut_pairs_contacts_with_memories(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                              const abut_pose* poses_b, size_t pair_count,
                                              const abut_query_options* options, abut_pair_memory* memories,
                                              uint64_t* offsets, abut_contact* contacts_out, size_t capacity,
                                              size_t* count) {
  return guard([&] {
    PairBatch pairs{};
    std::span<abut_pair_memory> its_memories;
    abut_status status = read_span("memories", memories, "pair_count", pair_count, its_memories);
    status = status != ABUT_OK ? status : read_batch(a, poses_a, b, poses_b, "pair_count", pair_count, pairs);
    return status != ABUT_OK ? status
                             : ask_contacts(pairs, options, its_memories, offsets, contacts_out, capacity, count);
  });
}
