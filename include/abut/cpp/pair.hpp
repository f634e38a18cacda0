// SPDX-License-Identifier: Apache-2.0
// Two shapes alone: overlaps, distances, contacts and casts. Forms that take a span for their answer make no vector.
#ifndef ABUT_CPP_PAIR_HPP
#define ABUT_CPP_PAIR_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>
#include <abut/cpp/shape.hpp>

#include <cstddef>
#include <cstdint>
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

// Whether two shapes are within the margin of the options, by default 0.
[[nodiscard]] inline Answer<bool> pair_overlaps(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                                                OptionalRef<abut_query_options> options = {}) {
  std::uint32_t out = 0;
  const abut_status status = abut_pair_overlaps(a.get(), &pose_a, b.get(), &pose_b, options.get(), &out);
  bool answer = out == 1;
  return detail::answer(status, answer);
}

// The same pair by pair, for as many shapes and poses on either side: 1 or 0 for each.
[[nodiscard]] inline Answer<std::vector<std::uint32_t>> pairs_overlap(Span<const Shape> shapes_a,
                                                                      Span<const Pose> poses_a,
                                                                      Span<const Shape> shapes_b,
                                                                      Span<const Pose> poses_b,
                                                                      OptionalRef<abut_query_options> options = {}) {
  const std::size_t count = poses_a.size();
  const std::vector<const abut_shape*> pointers_a = Shape::pointers_of(shapes_a),
                                       pointers_b = Shape::pointers_of(shapes_b);
  std::vector<std::uint32_t> out(count);
  const abut_status sizes =
      detail::first_failure(detail::expect_as_many("shapes_a", shapes_a.size(), "poses_a", count),
                            detail::expect_as_many("shapes_b", shapes_b.size(), "poses_a", count),
                            detail::expect_as_many("poses_b", poses_b.size(), "poses_a", count));
  return detail::answer(sizes != ABUT_OK
                            ? sizes
                            : abut_pairs_overlap(pointers_a.data(), poses_a.data(), pointers_b.data(), poses_b.data(),
                                                 count, options.get(), out.data()),
                        out);
}

// The measured routes of two kinds; ABUT_ROUTE_CHOSEN marks the one that the time budget of the options takes.
[[nodiscard]] inline Answer<std::vector<Route>> pair_routes(ShapeKind a, ShapeKind b, Query query,
                                                            OptionalRef<abut_query_options> options = {}) {
  return detail::collect<Route>([&](Route* data, std::size_t capacity, std::size_t* count) {
    return abut_pair_routes(a, b, query, options.get(), data, capacity, count);
  });
}

// A table that `abut tune` wrote; null for the one that abut comes with. No other function of abut may run.
inline Answer<void> load_routes(const char* text) { return detail::answer(abut_routes_load(text)); }

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

// Contacts of the same two shapes at many poses: those of pair i are of(i).
[[nodiscard]] inline Answer<ContactLists> pairs_contacts(const Shape& a, Span<const Pose> poses_a, const Shape& b,
                                                         Span<const Pose> poses_b,
                                                         OptionalRef<abut_query_options> options = {}) {
  const abut_status sizes = detail::expect_as_many("poses_b", poses_b.size(), "poses_a", poses_a.size());
  return detail::collect_lists<ContactLists>(poses_a.size(), sizes, [&](ContactLists& lists, std::size_t* count) {
    return abut_pairs_contacts(a.get(), poses_a.data(), b.get(), poses_b.data(), poses_a.size(), options.get(),
                               lists.offsets.data(), lists.all.data(), lists.all.size(), count);
  });
}

// With as many memories as poses.
[[nodiscard]] inline Answer<ContactLists> pairs_contacts(const Shape& a, Span<const Pose> poses_a, const Shape& b,
                                                         Span<const Pose> poses_b, Span<abut_pair_memory> memories,
                                                         OptionalRef<abut_query_options> options = {}) {
  const std::size_t pairs = poses_a.size();
  const abut_status sizes =
      detail::first_failure(detail::expect_as_many("poses_b", poses_b.size(), "poses_a", pairs),
                            detail::expect_as_many("memories", memories.size(), "poses_a", pairs));
  return detail::collect_lists<ContactLists>(pairs, sizes, [&](ContactLists& lists, std::size_t* count) {
    return abut_pairs_contacts_with_memories(a.get(), poses_a.data(), b.get(), poses_b.data(), pairs, options.get(),
                                             memories.data(), lists.offsets.data(), lists.all.data(), lists.all.size(),
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

namespace detail {

inline abut_status pairs_cast(const Shape& a, Span<const Pose> poses_a, Span<const Vec3> displacements_a,
                              const Shape& b, Span<const Pose> poses_b, Span<const Vec3> displacements_b,
                              Span<CastHit> out, OptionalRef<abut_query_options> options) {
  const std::size_t count = poses_a.size();
  const abut_status sizes =
      first_failure(expect_as_many("displacements_a", displacements_a.size(), "poses_a", count),
                    expect_as_many("poses_b", poses_b.size(), "poses_a", count),
                    expect_as_many("displacements_b", displacements_b.size(), "poses_a", count),
                    expect_as_many("out", out.size(), "poses_a", count));
  return sizes != ABUT_OK
             ? sizes
             : abut_pairs_cast(a.get(), poses_a.data(), displacements_a.data(), b.get(), poses_b.data(),
                               displacements_b.data(), count, options.get(), out.data());
}

}  // namespace detail

// The same for many poses and displacements; the fraction of a hit is infinite where the two never touch.
inline Answer<void> pairs_cast(const Shape& a, Span<const Pose> poses_a, Span<const Vec3> displacements_a,
                               const Shape& b, Span<const Pose> poses_b, Span<const Vec3> displacements_b,
                               Span<CastHit> out, OptionalRef<abut_query_options> options = {}) {
  return detail::answer(
      detail::pairs_cast(a, poses_a, displacements_a, b, poses_b, displacements_b, out, options));
}

[[nodiscard]] inline Answer<std::vector<CastHit>> pairs_cast(const Shape& a, Span<const Pose> poses_a,
                                                             Span<const Vec3> displacements_a, const Shape& b,
                                                             Span<const Pose> poses_b,
                                                             Span<const Vec3> displacements_b,
                                                             OptionalRef<abut_query_options> options = {}) {
  std::vector<CastHit> out(poses_a.size());
  const abut_status status =
      detail::pairs_cast(a, poses_a, displacements_a, b, poses_b, displacements_b, out, options);
  return detail::answer(status, out);
}

// Checks a contact that went through a file or was made by hand.
inline Answer<void> validate(const Contact& contact) { return detail::answer(abut_contact_validate(&contact)); }

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
