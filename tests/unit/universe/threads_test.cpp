// SPDX-License-Identifier: Apache-2.0
// Every stage of a step on several threads: whatever happens to a scene, it has the same bits as on one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

namespace {

using namespace abut;

ShapeHandle make(std::string_view kind, const std::vector<Real>& parameters) {
  return ShapeHandle(make_shape(find_kind(kind).value(), parameters, {}, {}).value());
}

// What a detection has left behind, as far as it may not depend on the threads.
struct Trace {
  std::uint64_t hash, candidates, filtered, examined, touching, moved, asleep, lost_events;

  friend bool operator==(const Trace&, const Trace&) = default;
};

// Bodies packed so that each has a dozen neighbours: enough for several tasks of every stage.
class Crowd {
 public:
  static constexpr std::size_t side = 15, count = side * side * side;

  explicit Crowd(std::uint32_t threads)
      : universe({.threads = threads, .events = event_pairs | event_persist | event_contacts}, 1),
        shapes{make("sphere", {0.55}), make("box", {0.5, 0.45, 0.5}), make("capsule", {0.4, 0.3}),
               make("cylinder", {0.5, 0.5})} {
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(universe.create_parts(std::array{PartOptions{.placement = place(i, 0)}}).value()[0]);
      geometries.push_back(add(i));
    }
  }

  static Placement place(std::size_t i, std::size_t frame) {
    const Real phase = 0.7 * static_cast<Real>(i) + 0.4 * static_cast<Real>(frame);
    return {{0.9 * static_cast<Real>(i % side) + 0.05 * std::sin(phase), 0.9 * static_cast<Real>(i / side % side),
             0.9 * static_cast<Real>(i / (side * side)) + 0.05 * std::cos(1.3 * phase)},
            {1, 0, 0, 0}};
  }
  GeometryId add(std::size_t i) {
    return universe.create_geometries(std::span(&parts[i], 1), std::span(&shapes[i % shapes.size()], 1), {}).value()[0];
  }
  void move(std::size_t frame, std::size_t stride) {
    for (std::size_t i = frame % stride; i < count; i += stride) {
      const Placement there = place(i, frame);
      ASSERT_TRUE(universe.set_poses(std::span(&parts[i], 1), std::span(&there, 1)).has_value());
    }
  }
  [[nodiscard]] std::span<const GeometryId> some(std::size_t first, std::size_t number) const {
    return std::span(geometries).subspan(first, number);
  }

  // One frame of a scene in which everything changes that a step looks at.
  void play(std::size_t frame) {
    if (frame % 5 != 4) move(frame, 1 + frame % 3);
    if (frame == 2)
      ASSERT_TRUE(universe.set_shapes(some(100, 200), std::vector<ShapeHandle>(200, shapes[0])).has_value());
    if (frame == 3) ASSERT_TRUE(universe.park(some(400, 100), Parking::short_term).has_value());
    if (frame == 3) ASSERT_TRUE(universe.park(some(700, 100), Parking::long_term).has_value());
    if (frame == 5) ASSERT_TRUE(universe.park(some(350, 500), Parking::none).has_value());
    if (frame == 6) {
      ASSERT_TRUE(universe.destroy_geometries(some(900, 50)).has_value());
      for (std::size_t i = 900; i < 950; ++i) geometries[i] = add(1849 - i);
    }
    if (frame == 7) {
      ASSERT_TRUE(
          universe
              .set_rule({.kind = CollidableKind::part, .slot = parts[5].slot, .generation = parts[5].generation}, {},
                        Rule::disable)
              .has_value());
      ASSERT_TRUE(universe.set_policy(0, 0, {.detail = Detail::point, .period = 2}).has_value());
    }
    if (frame == 9)
      ASSERT_TRUE(universe.set_sleep(parts, std::vector<std::optional<Sleep>>(count, Sleep{.steps = 1})).has_value());
    if (frame == 14) ASSERT_TRUE(universe.wake(std::span(parts).first(1)).has_value());
    ASSERT_TRUE(universe.step(0.01).has_value());
  }
  [[nodiscard]] Trace trace() const {
    const StepStats& stats = universe.stats();
    std::uint64_t ends = 0;
    for (const Event& event : universe.events()) ends += event.kind == EventKind::end ? 1 : 0;
    return {universe.hash(),      stats.candidate_pairs, stats.filtered_pairs, stats.examined_pairs,
            stats.touching_pairs, stats.moved,           stats.asleep,         ends};
  }

  Universe universe;
  std::array<ShapeHandle, 4> shapes;
  std::vector<PartId> parts;
  std::vector<GeometryId> geometries;
};

TEST(ThreadsOfAUniverse, LeaveTheSameBehindWhateverHappens) {
  std::vector<Trace> expected;
  for (const std::uint32_t threads : {1U, 2U, 3U, 8U}) {
    Crowd crowd(threads);
    std::vector<Trace> traces;
    std::uint64_t asleep = 0, filtered = 0, ended = 0;
    for (std::size_t frame = 0; frame < 16; ++frame) {
      crowd.play(frame < 10 ? frame : frame == 15 ? 14 : 4);
      traces.push_back(crowd.trace());
      asleep += traces.back().asleep;
      filtered += traces.back().filtered;
      ended += traces.back().lost_events;
    }
    EXPECT_GT(traces.front().candidates, 16384U) << "too few pairs for several tasks of each stage";
    EXPECT_GT(asleep, 0U);
    EXPECT_GT(filtered, 0U);
    EXPECT_GT(ended, 100U);
    expected = expected.empty() ? traces : expected;
    EXPECT_TRUE(traces == expected) << threads << " threads";
  }
}

// Contacts that stay are moved within their list: whatever comes and goes before them, they are those of a detection of
// all.
TEST(ThreadsOfAUniverse, MoveContactsThatStayUpAndDown) {
  for (const std::uint32_t threads : {1U, 4U}) {
    Crowd crowd(threads);
    crowd.play(0);
    std::size_t before = crowd.universe.contacts().size(), grown = 0, shrunk = 0;
    for (std::size_t frame = 0; frame < 8; ++frame) {
      // Every eighth body leaves or comes back, in each half of the slots at another time.
      for (std::size_t i = 0; i < Crowd::count; i += 8) {
        const bool is_away = (frame + (i < Crowd::count / 2 ? 0 : 1)) % 2 == 0;
        const Placement there =
            is_away ? Placement{{100.0 + 3 * static_cast<Real>(i), 0, 0}, {1, 0, 0, 0}} : Crowd::place(i, 0);
        ASSERT_TRUE(crowd.universe.set_poses(std::span(&crowd.parts[i], 1), std::span(&there, 1)).has_value());
      }
      ASSERT_TRUE(crowd.universe.step(0.01).has_value());
      ASSERT_GT(crowd.universe.stats().kept_pairs, 1000U);
      const std::vector<Contact> kept(crowd.universe.contacts().begin(), crowd.universe.contacts().end());
      grown += kept.size() > before ? 1 : 0;
      shrunk += kept.size() < before ? 1 : 0;
      before = kept.size();
      crowd.universe.detect_all();
      const std::span<const Contact> anew = crowd.universe.contacts();
      ASSERT_EQ(kept.size(), anew.size());
      for (std::size_t i = 0; i < kept.size(); ++i) {
        ASSERT_EQ(kept[i].geometry_a, anew[i].geometry_a);
        ASSERT_EQ(kept[i].geometry_b, anew[i].geometry_b);
        ASSERT_EQ(kept[i].point.id, anew[i].point.id);
        ASSERT_EQ(kept[i].point.distance, anew[i].point.distance);
        ASSERT_EQ(kept[i].age + 1, anew[i].age);
      }
    }
    EXPECT_GT(grown + shrunk, 0U);
  }
}

// Once nothing moves, what it took to examine all pairs at once is not held on to.
TEST(ThreadsOfAUniverse, GiveBackWhatADetectionOfAllPairsNeeded) {
  Crowd crowd(1);
  crowd.play(0);
  ASSERT_GT(crowd.universe.stats().examined_pairs, 256U * 64);
  const std::uint64_t bytes = crowd.universe.stats().bytes, pairs = crowd.universe.stats().examined_pairs;
  crowd.play(4);
  crowd.play(4);
  ASSERT_EQ(crowd.universe.stats().examined_pairs, 0U);
  EXPECT_LT(crowd.universe.stats().bytes + 100 * pairs, bytes);
  const std::size_t contacts = crowd.universe.contacts().size();
  crowd.universe.detect_all();
  EXPECT_EQ(crowd.universe.contacts().size(), contacts);
}

// The filter is asked once for each pair, in order, on the thread that steps.
TEST(ThreadsOfAUniverse, AskTheFilterInOrder) {
  Crowd crowd(4);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asked;
  crowd.universe.set_filter([&](GeometryId a, GeometryId b) {
    asked.emplace_back(a.slot, b.slot);
    return (a.slot + b.slot) % 2 == 0;
  });
  crowd.play(0);
  ASSERT_GT(asked.size(), 8U * 1024);
  for (std::size_t i = 1; i < asked.size(); ++i) {
    ASSERT_LT(asked[i - 1], asked[i]);
  }
}

}  // namespace
