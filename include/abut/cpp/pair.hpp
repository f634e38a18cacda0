// SPDX-License-Identifier: Apache-2.0
// Two shapes alone: distances, contacts and casts. Forms that take a span for their answer make no vector.
#ifndef ABUT_CPP_PAIR_HPP
#define ABUT_CPP_PAIR_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>
#include <abut/cpp/shape.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

[[nodiscard]] inline Answer<Distance> pair_distance(const Shape& a, const Pose& pose_a, const Shape& b,
                                                    const Pose& pose_b, OptionalRef<abut_query_options> options = {}) {
  Distance out;
  return detail::answer(abut_pair_distance(a.get(), &pose_a, b.get(), &pose_b, options.get(), &out), out);
}

// With what the last query of the same two shapes has left, and leaving that of this one.
[[nodiscard]] inline Answer<Distance> pair_distance(const Shape& a, const Pose& pose_a, const Shape& b,
                                                    const Pose& pose_b, PairMemory& memory,
                                                    OptionalRef<abut_query_options> options = {}) {
  Distance out;
  return detail::answer(
      abut_pair_distance_with_memory(a.get(), &pose_a, b.get(), &pose_b, options.get(), &memory, &out), out);
}

// Distances of the same two shapes at many poses; memories are as many as poses, or none.
inline Answer<void> pairs_distance(const Shape& a, Span<const Pose> poses_a, const Shape& b, Span<const Pose> poses_b,
                                   Span<Distance> out, Span<abut_pair_memory> memories = {},
                                   OptionalRef<abut_query_options> options = {}) {
  const std::size_t count = poses_a.size();
  const abut_status sizes = detail::first_failure(
      detail::expect_as_many("poses_b", poses_b.size(), "poses_a", count),
      detail::expect_as_many("out", out.size(), "poses_a", count),
      detail::expect_as_many("memories", memories.empty() ? count : memories.size(), "poses_a", count));
  if (sizes != ABUT_OK) return detail::answer(sizes);
  return detail::answer(
      memories.empty()
          ? abut_pairs_distance(a.get(), poses_a.data(), b.get(), poses_b.data(), count, options.get(), out.data())
          : abut_pairs_distance_with_memories(a.get(), poses_a.data(), b.get(), poses_b.data(), count, options.get(),
                                              memories.data(), out.data()));
}

[[nodiscard]] inline Answer<std::vector<Distance>> pairs_distance(const Shape& a, Span<const Pose> poses_a,
                                                                  const Shape& b, Span<const Pose> poses_b,
                                                                  OptionalRef<abut_query_options> options = {}) {
  std::vector<Distance> out(poses_a.size());
  const abut_status sizes = detail::expect_as_many("poses_b", poses_b.size(), "poses_a", poses_a.size());
  return detail::answer(sizes != ABUT_OK ? sizes
                                         : abut_pairs_distance(a.get(), poses_a.data(), b.get(), poses_b.data(),
                                                               poses_a.size(), options.get(), out.data()),
                        out);
}

// Deepest first; `out` receives as many as fit, and the answer tells how many there are.
[[nodiscard]] inline Answer<std::size_t> pair_contacts(const Shape& a, const Pose& pose_a, const Shape& b,
                                                       const Pose& pose_b, Span<Contact> out,
                                                       OptionalRef<abut_query_options> options = {}) {
  std::size_t count = 0;
  return detail::answer(
      abut_pair_contacts(a.get(), &pose_a, b.get(), &pose_b, options.get(), out.data(), out.size(), &count), count);
}

[[nodiscard]] inline Answer<std::vector<Contact>> pair_contacts(const Shape& a, const Pose& pose_a, const Shape& b,
                                                                const Pose& pose_b,
                                                                OptionalRef<abut_query_options> options = {}) {
  return detail::collect<Contact>([&](Contact* data, std::size_t capacity, std::size_t* count) {
    return abut_pair_contacts(a.get(), &pose_a, b.get(), &pose_b, options.get(), data, capacity, count);
  });
}

[[nodiscard]] inline Answer<std::vector<Contact>> pair_contacts(const Shape& a, const Pose& pose_a, const Shape& b,
                                                                const Pose& pose_b, PairMemory& memory,
                                                                OptionalRef<abut_query_options> options = {}) {
  return detail::collect<Contact>([&](Contact* data, std::size_t capacity, std::size_t* count) {
    return abut_pair_contacts_with_memory(a.get(), &pose_a, b.get(), &pose_b, options.get(), &memory, data, capacity,
                                          count);
  });
}

// When two shapes that move without turning first touch; nothing where they do not.
[[nodiscard]] inline Answer<std::optional<CastHit>> pair_cast(const Shape& a, const Pose& pose_a, Vec3 displacement_a,
                                                              const Shape& b, const Pose& pose_b, Vec3 displacement_b,
                                                              OptionalRef<abut_query_options> options = {}) {
  CastHit hit{};
  std::uint32_t found = 0;
  const abut_status status =
      abut_pair_cast(a.get(), &pose_a, &displacement_a, b.get(), &pose_b, &displacement_b, options.get(), &hit, &found);
  return detail::answer_if_found(status, found, hit);
}

// Checks a contact that went through a file or was made by hand.
inline Answer<void> validate(const Contact& contact) { return detail::answer(abut_contact_validate(&contact)); }

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
