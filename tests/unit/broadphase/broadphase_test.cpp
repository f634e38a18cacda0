// SPDX-License-Identifier: Apache-2.0
// All broad phases find the pairs that a plain double loop finds, whatever happens to the boxes.
#include "box_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

import abut.broadphase;
import abut.core.workers;
import abut.math;

namespace {

using abut::CompactAabb;
using abut::Mobility;
using abut::ProxyPair;
using abut::Workers;
using box_scene::Box;
using box_scene::box_at;
using box_scene::Dice;
using box_scene::Member;
using box_scene::Pairs;
using box_scene::Scene;
using box_scene::unbounded;

CompactAabb compact(const Box& box) { return {box.low, box.high}; }

Pairs numbers(const std::vector<ProxyPair>& pairs) {
  Pairs all;
  for (const ProxyPair& pair : pairs) {
    all.push_back({pair.low, pair.high});
  }
  return all;
}

// A broad phase and the scene that it has been told of.
template <class BroadPhase>
class Told {
 public:
  explicit Told(std::size_t count, std::uint32_t gap = 1) : scene(count), gap_(gap) {}

  void insert(std::uint32_t i, const Member& member) {
    scene[i] = member;
    broad_phase.insert(i * gap_, compact(member.box), member.moves ? Mobility::moving : Mobility::still, member.group);
  }
  void erase(std::uint32_t i) {
    scene[i].reset();
    broad_phase.erase(i * gap_);
  }
  void update(std::uint32_t i, const Box& box) {
    scene[i]->box = box;
    broad_phase.update(i * gap_, compact(box));
  }
  void hide(std::uint32_t i) {
    scene[i]->is_hidden = true;
    broad_phase.hide(i * gap_);
  }
  void show(std::uint32_t i, const Box& box) {
    scene[i]->is_hidden = false;
    scene[i]->box = box;
    broad_phase.show(i * gap_, compact(box));
  }

  void expect_pairs() {
    broad_phase.find_pairs(found_);
    Pairs all = box_scene::pairs_of(scene);
    for (auto& pair : all) {
      pair = {pair[0] * gap_, pair[1] * gap_};
    }
    ASSERT_EQ(numbers(found_), all);
    most = std::max(most, all.size());
  }

  void expect_visits(const Box& box) const {
    std::vector<std::uint32_t> visited;
    broad_phase.visit(compact(box), [&](std::uint32_t proxy) { visited.push_back(proxy / gap_); });
    std::sort(visited.begin(), visited.end());
    ASSERT_EQ(visited, box_scene::members_in(scene, box));
  }

  // All that is met is shown, at the latest when it is met; what is shown besides is met within rounding.
  void expect_sweep(const std::array<double, 3>& centre, const std::array<double, 3>& half,
                    const std::array<double, 3>& displacement, double most_time) const {
    const auto vector = [](const std::array<double, 3>& p) { return abut::Vec3{p[0], p[1], p[2]}; };
    std::vector<std::optional<double>> entries(scene.size());
    broad_phase.sweep(vector(centre), vector(half), vector(displacement), most_time,
                      [&](std::uint32_t proxy, double entry) {
                        EXPECT_FALSE(entries[proxy / gap_]) << "shown twice";
                        EXPECT_TRUE(entry >= 0 && entry <= most_time) << entry;
                        entries[proxy / gap_] = entry;
                        return most_time;
                      });
    std::optional<std::uint32_t> nearest;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      const bool is_there = scene[i] && !scene[i]->is_hidden;
      const auto time =
          is_there ? box_scene::time_of_meeting(scene[i]->box, centre, half, displacement, most_time) : std::nullopt;
      if (time) {
        ASSERT_TRUE(entries[i]) << i << " is missing";
        ASSERT_LE(static_cast<long double>(*entries[i]), *time);
        ASSERT_GE(static_cast<long double>(*entries[i]), *time - 1e-9L * (1 + *time));
      } else if (entries[i]) {
        ASSERT_TRUE(is_there) << i;
        std::array<double, 3> wider = half;
        for (double& side : wider) {
          side += 1e-9;
        }
        ASSERT_TRUE(box_scene::time_of_meeting(scene[i]->box, centre, wider, displacement, most_time * (1 + 1e-9)))
            << i;
      }
      if (entries[i] && (!nearest || *entries[i] < *entries[*nearest])) {
        nearest = i;
      }
    }
    // Who takes the nearest one only has it in the end.
    std::optional<std::uint32_t> last;
    double limit = most_time;
    broad_phase.sweep(vector(centre), vector(half), vector(displacement), most_time,
                      [&](std::uint32_t proxy, double entry) {
                        EXPECT_LE(entry, limit);
                        if (entry < limit || !last) {
                          last = proxy / gap_;
                        }
                        return limit = std::min(limit, entry);
                      });
    ASSERT_EQ(last.has_value(), nearest.has_value());
    if (nearest) {
      ASSERT_EQ(limit, *entries[*nearest]);
    }
  }

  BroadPhase broad_phase;
  Scene scene;
  std::size_t most = 0;

 private:
  std::uint32_t gap_;  // from one number to the next
  std::vector<ProxyPair> found_;
};

template <class BroadPhase>
class BroadPhases : public testing::Test {};
using Implementations = testing::Types<abut::Brute, abut::SweepAndPrune, abut::Tree, abut::Grid>;
TYPED_TEST_SUITE(BroadPhases, Implementations);

TYPED_TEST(BroadPhases, EmptyHasNothing) {
  TypeParam broad_phase;
  std::vector<ProxyPair> pairs{{1, 2}};
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
  EXPECT_EQ(broad_phase.size(), 0u);
  broad_phase.visit(compact(box_at(0, 0, 0, unbounded)), [](std::uint32_t) { ADD_FAILURE(); });
  broad_phase.sweep({0, 0, 0}, {1, 1, 1}, {1, 0, 0}, abut::infinity, [](std::uint32_t, double most) {
    ADD_FAILURE();
    return most;
  });
}

TYPED_TEST(BroadPhases, OneBoxIsAlone) {
  Told<TypeParam> told(1, 4'000'000);
  told.insert(0, {box_at(1, 2, 3, 1), 5, true});
  told.expect_pairs();
  told.expect_visits(box_at(2, 2, 3, 0));
  told.expect_visits(box_at(2.5f, 2, 3, 0));
  told.expect_sweep({-5, 2, 3}, {0, 0, 0}, {1, 0, 0}, abut::infinity);
  told.erase(0);
  told.expect_pairs();
  told.expect_visits(box_at(2, 2, 3, 9));
}

TYPED_TEST(BroadPhases, TouchingBoxesPair) {
  TypeParam broad_phase;
  broad_phase.insert(5, compact(box_at(0, 0, 0, 1)), Mobility::moving, 1);
  broad_phase.insert(2, compact(box_at(2, 0, 0, 1)), Mobility::moving, 2);
  std::vector<ProxyPair> pairs;
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{2, 5}}));
  broad_phase.update(2, {{std::nextafter(1.0f, 2.0f), -1, -1}, {3, 1, 1}});
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
  broad_phase.update(2, {{1, 1, 1}, {3, 3, 3}});
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{2, 5}}));
}

TYPED_TEST(BroadPhases, OneGroupNeverPairs) {
  Told<TypeParam> told(3);
  told.insert(0, {box_at(0, 0, 0, 1), 7, true});
  told.insert(1, {box_at(0, 0, 0, 1), 7, true});
  told.insert(2, {box_at(0, 0, 0, 1), 8, true});
  told.expect_pairs();
  EXPECT_EQ(told.most, 2u);
}

TYPED_TEST(BroadPhases, StillBoxesPairWithMovingOnesOnly) {
  Told<TypeParam> told(4);
  told.insert(0, {box_at(0, 0, 0, 1), 0, false});
  told.insert(1, {box_at(0, 0, 0, 1), 1, false});
  told.insert(2, {box_at(0, 0, 0, 1), 2, true});
  told.insert(3, {{{-unbounded, -unbounded, -unbounded}, {unbounded, unbounded, 0}}, 3, false});
  told.expect_pairs();
  told.update(0, box_at(0.5f, 0, 0, 1));
  told.expect_pairs();
  EXPECT_EQ(told.most, 3u);
}

TYPED_TEST(BroadPhases, HiddenBoxesMeetNothing) {
  Told<TypeParam> told(4);
  for (std::uint32_t i = 0; i < 3; ++i) {
    told.insert(i, {box_at(static_cast<float>(i), 0, 0, 1), i, i != 1});
  }
  told.insert(3, {box_at(0, 0, 0, unbounded), 3, true});
  told.expect_pairs();
  for (const std::uint32_t i : {0u, 3u, 1u}) {
    told.hide(i);
    EXPECT_EQ(told.broad_phase.hidden(), 1u);
    EXPECT_EQ(told.broad_phase.size(), 4u);
    told.expect_visits(box_at(0, 0, 0, 9));
    told.expect_sweep({-9, 0, 0}, {0, 0, 0}, {1, 0, 0}, 50);
    told.expect_pairs();
    told.show(i, told.scene[i]->box);
    told.expect_visits(box_at(0, 0, 0, 9));
    told.expect_pairs();
    EXPECT_EQ(told.broad_phase.hidden(), 0u);
  }
  // Shown elsewhere, and hidden and shown between two searches.
  told.hide(0);
  told.expect_pairs();
  told.show(0, box_at(90, 0, 0, 1));
  told.expect_pairs();
  told.hide(0);
  told.show(0, box_at(1, 0, 0, 1));
  told.expect_pairs();
  told.hide(2);
  told.erase(2);
  EXPECT_EQ(told.broad_phase.hidden(), 0u);
  told.insert(2, {box_at(0, 0, 0, 1), 9, true});
  told.expect_pairs();
}

TYPED_TEST(BroadPhases, NumbersCanBeUsedAgainAtOnce) {
  Told<TypeParam> told(3);
  told.insert(0, {box_at(0, 0, 0, 1), 0, true});
  told.insert(1, {box_at(0, 0, 0, 1), 1, true});
  told.insert(2, {box_at(9, 0, 0, 1), 2, false});
  told.expect_pairs();
  told.erase(1);
  told.insert(1, {box_at(9, 0, 0, 1), 0, true});
  told.expect_pairs();
  told.erase(1);
  told.insert(1, {box_at(0, 0, 0, 1), 1, false});
  told.expect_pairs();
  told.erase(1);
  told.insert(1, {box_at(0, 0, 0, unbounded), 1, true});
  told.expect_pairs();
  EXPECT_EQ(told.most, 2u);
}

struct Course {
  std::uint32_t count;
  float room, size;  // half the side of the room, half the mean side of a box
  std::uint32_t gap;
};

// A box that does not fit what the others are like, now and then.
Box any_box(Dice& dice, const Course& course) {
  const auto place = [&] { return dice.uniform(-course.room, course.room); };
  Box box = box_at(place(), place(), place(), 0);
  const float scale = dice.chance(0.03f) ? 20.0f : dice.chance(0.05f) ? 0.001f : 1.0f;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float half = scale * course.size * dice.uniform(0.5f, 1.5f);
    box.low[axis] -= half;
    box.high[axis] += half;
  }
  if (dice.chance(0.01f)) {
    box.low = {-unbounded, -unbounded, -unbounded};
    box.high = {unbounded, unbounded, place()};
  } else if (dice.chance(0.005f)) {
    box.high[dice.below(3)] = 1e30f;
  }
  return box;
}

template <class BroadPhase>
void change(Told<BroadPhase>& told, Dice& dice, const Course& course) {
  for (std::uint32_t i = 0; i < course.count; ++i) {
    const std::optional<Member>& member = told.scene[i];
    if (!member) {
      if (dice.chance(0.2f)) {
        told.insert(i, {any_box(dice, course), i / 3, dice.chance(0.7f)});
      }
    } else if (dice.chance(0.01f)) {
      told.erase(i);
    } else if (member->is_hidden) {
      if (dice.chance(0.2f)) {
        told.show(i, dice.chance(0.5f) ? member->box : any_box(dice, course));
      }
    } else if (dice.chance(0.02f)) {
      told.hide(i);
    } else if (dice.chance(0.01f)) {
      told.update(i, any_box(dice, course));
    } else if (dice.chance(0.6f) && member->box.high[2] < 1e29f) {
      Box box = member->box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float step = course.size * dice.uniform(-0.1f, 0.1f);
        box.low[axis] += step;
        box.high[axis] += step;
      }
      told.update(i, box);
    }
  }
}

// Boxes come, go, drift, jump, hide, grow and lose their bounds; after every change all agree with the loops.
TYPED_TEST(BroadPhases, AgreeWithPlainLoops) {
  constexpr std::array courses{Course{100, 6, 0.8f, 1}, Course{100, 60, 0.8f, 1000}, Course{60, 1, 0.8f, 1},
                               Course{150, 6000, 500, 7}};
  std::uint32_t seed = 0;
  for (const Course& course : courses) {
    SCOPED_TRACE("course " + std::to_string(seed));
    Dice dice(++seed);
    Told<TypeParam> told(course.count, course.gap);
    for (int frame = 0; frame < 250; ++frame) {
      SCOPED_TRACE("frame " + std::to_string(frame));
      change(told, dice, course);
      const auto place = [&] { return dice.uniform(-course.room, course.room); };
      const auto speed = [&] { return dice.chance(0.3f) ? 0.0 : static_cast<double>(place()); };
      const Box query = box_at(place(), place(), place(), course.size * dice.uniform(0, 3));
      ASSERT_NO_FATAL_FAILURE(told.expect_visits(query));
      const double half = dice.chance(0.5f) ? 0 : static_cast<double>(course.size);
      const std::array centre{static_cast<double>(place()), static_cast<double>(place()), static_cast<double>(place())};
      ASSERT_NO_FATAL_FAILURE(told.expect_sweep(centre, {half, half, 2 * half}, {speed(), speed(), speed()},
                                                dice.chance(0.3f) ? abut::infinity : 1));
      ASSERT_NO_FATAL_FAILURE(told.expect_pairs());
      ASSERT_NO_FATAL_FAILURE(told.expect_visits(query));
    }
    EXPECT_GT(told.most, 20u);  // the scene is crowded enough to mean something
  }
}

// Arrangements that spoil the order, the balance or the cells of one or the other.
TYPED_TEST(BroadPhases, StandsOddArrangements) {
  constexpr std::uint32_t count = 300;
  Dice dice(7);
  const auto line = [](std::uint32_t i) { return box_at(0.9f * static_cast<float>(i), 0, 0, 0.5f); };
  const auto one_place = [](std::uint32_t) { return box_at(1, 1, 1, 0); };
  const auto very_far = [](std::uint32_t i) {
    return box_at(1e30f, i % 2 == 0 ? 1e30f : -1e30f, 1e17f * static_cast<float>(i), 1e17f);
  };
  const auto all_sizes = [](std::uint32_t i) {
    return box_at(static_cast<float>(i % 7), 0, 0, std::ldexp(1.0f, static_cast<int>(i % 80) - 40));
  };
  const auto planes = [](std::uint32_t i) {
    return i % 10 == 0 ? Box{{-unbounded, -unbounded, -unbounded}, {unbounded, static_cast<float>(i), unbounded}}
                       : box_at(0, static_cast<float>(i), 0, 0.4f);
  };
  const std::array<Box (*)(std::uint32_t), 5> arrangements{line, one_place, very_far, all_sizes, planes};
  Told<TypeParam> told(count);
  for (std::size_t before = 0; before < arrangements.size(); ++before) {
    for (std::size_t after = 0; after < arrangements.size(); ++after) {
      SCOPED_TRACE(std::to_string(before) + " to " + std::to_string(after));
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!told.scene[i]) {
          told.insert(i, {arrangements[before](i), i, i % 3 != 0});
        } else {
          told.update(i, arrangements[before](i));
        }
      }
      ASSERT_NO_FATAL_FAILURE(told.expect_pairs());
      // Some teleport, then the rest.
      for (std::uint32_t i = 0; i < count; i += 1 + dice.below(30)) {
        told.update(i, arrangements[after](i));
      }
      ASSERT_NO_FATAL_FAILURE(told.expect_pairs());
      ASSERT_NO_FATAL_FAILURE(told.expect_visits(box_at(1, 1, 1, 2)));
      ASSERT_NO_FATAL_FAILURE(told.expect_sweep({-3, 0.1, 0.1}, {0, 0, 0}, {1, 0, 0}, abut::infinity));
    }
  }
}

// The same bits from any number of threads, in many boxes so that the work is shared.
TYPED_TEST(BroadPhases, ThreadsChangeNothing) {
  constexpr std::uint32_t count = 6000;
  std::vector<std::vector<ProxyPair>> first;
  for (const std::uint32_t threads : {1u, 2u, 5u}) {
    SCOPED_TRACE(threads);
    const Workers workers(threads);
    Dice dice(11);
    TypeParam broad_phase;
    Scene scene(count);
    std::vector<CompactAabb> boxes;
    std::vector<std::uint32_t> moving;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto place = [&] { return dice.uniform(-12, 12); };
      scene[i] = Member{box_at(place(), place(), place(), dice.uniform(0.25f, 0.75f)), i, i % 5 != 0};
      boxes.push_back(compact(scene[i]->box));
      broad_phase.insert(i, boxes[i], scene[i]->moves ? Mobility::moving : Mobility::still, i);
      if (scene[i]->moves) {
        moving.push_back(i);
      }
    }
    std::vector<ProxyPair> pairs;
    for (std::size_t frame = 0; frame < 12; ++frame) {
      for (const std::uint32_t i : moving) {
        const float step = frame == 6 && i % 7 == 0 ? dice.uniform(-9, 9) : dice.uniform(-0.1f, 0.1f);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          boxes[i].low[axis] += step;
          boxes[i].high[axis] += step;
        }
      }
      broad_phase.update_all(workers, moving, boxes);
      broad_phase.find_pairs(workers, pairs);
      if (threads == 1) {
        for (const std::uint32_t i : moving) {
          scene[i]->box = {boxes[i].low, boxes[i].high};
        }
        if (frame % 6 == 0) {
          ASSERT_EQ(numbers(pairs), box_scene::pairs_of(scene));
        }
        first.push_back(pairs);
      } else {
        ASSERT_EQ(pairs, first[frame]) << "frame " << frame;
      }
    }
  }
}

}  // namespace
