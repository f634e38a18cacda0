// SPDX-License-Identifier: Apache-2.0
// Random boxes that come, go, move, jump, hide and grow, and what a plain loop says about them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace box_scene {

constexpr float unbounded = std::numeric_limits<float>::infinity();

struct Box {
  std::array<float, 3> low, high;
};

inline Box box_at(float x, float y, float z, float half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}

// Closed intervals on each axis.
inline bool overlap(const Box& a, const Box& b) {
  bool is_apart = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    is_apart = is_apart || a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis];
  }
  return !is_apart;
}

struct Member {
  Box box;
  std::uint32_t group;
  bool moves;
  bool is_hidden = false;
};
using Scene = std::vector<std::optional<Member>>;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

inline Pairs pairs_of(const Scene& scene) {
  Pairs all;
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    for (std::uint32_t j = i + 1; j < scene.size() && scene[i] && !scene[i]->is_hidden; ++j) {
      if (scene[j] && !scene[j]->is_hidden && scene[i]->group != scene[j]->group &&
          (scene[i]->moves || scene[j]->moves) && overlap(scene[i]->box, scene[j]->box)) {
        all.push_back({i, j});
      }
    }
  }
  return all;
}

inline std::vector<std::uint32_t> members_in(const Scene& scene, const Box& box) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (scene[i] && !scene[i]->is_hidden && overlap(scene[i]->box, box)) {
      all.push_back(i);
    }
  }
  return all;
}

// When a box that is displaced by t times the displacement first meets another, t from 0 to `most`. In long double, by
// clipping the interval of t on each axis.
inline std::optional<long double> time_of_meeting(const Box& box, const std::array<double, 3>& centre,
                                                  const std::array<double, 3>& half,
                                                  const std::array<double, 3>& displacement, double most) {
  long double enter = 0, leave = static_cast<long double>(most);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const long double low = static_cast<long double>(box.low[axis]) - static_cast<long double>(half[axis]);
    const long double high = static_cast<long double>(box.high[axis]) + static_cast<long double>(half[axis]);
    const auto at = static_cast<long double>(centre[axis]), speed = static_cast<long double>(displacement[axis]);
    if (speed == 0) {
      if (at < low || at > high) {
        return std::nullopt;
      }
      continue;
    }
    const auto [first, last] = std::minmax({(low - at) / speed, (high - at) / speed});
    enter = std::max(enter, first);
    leave = std::min(leave, last);
  }
  return enter <= leave ? std::optional(enter) : std::nullopt;
}

// The same numbers on every platform.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  [[nodiscard]] float uniform(float low, float high) {
    return low + (high - low) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
  }
  [[nodiscard]] std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(engine_() % count); }
  [[nodiscard]] bool chance(float share) { return uniform(0, 1) < share; }

 private:
  std::mt19937 engine_;
};

}  // namespace box_scene
