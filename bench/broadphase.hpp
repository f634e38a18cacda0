// SPDX-License-Identifier: Apache-2.0
// Many boxes of which some move, and the pairs of them that overlap, asked to one library.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene.hpp"

namespace bench {

struct Box {
  std::array<float, 3> low, high;
};

// The first `moving` boxes move, the others never do.
struct Boxes {
  std::vector<Box> all;
  std::size_t moving = 0;
};

class BoxPairs {
 public:
  BoxPairs() = default;
  BoxPairs(const BoxPairs&) = delete;
  BoxPairs& operator=(const BoxPairs&) = delete;
  virtual ~BoxPairs() = default;

  // What is timed: the boxes that move are given anew and all pairs with one of them are found.
  virtual void step(std::span<const Box> moving) = 0;
  // Pairs of the last step whose boxes, as they were given, overlap.
  [[nodiscard]] virtual std::size_t pairs(std::span<const Box> all) const = 0;
};

[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
  bool is_apart = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    is_apart = is_apart || a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis];
  }
  return !is_apart;
}

enum class BulletBroadphase : std::uint8_t { dbvt, axis_sweep };
[[gnu::visibility("default")]] std::unique_ptr<BoxPairs> make_bullet_broadphase(const Boxes& boxes,
                                                                                BulletBroadphase kind, float extent);
[[gnu::visibility("default")]] std::unique_ptr<BoxPairs> make_fcl_broadphase(const Boxes& boxes);

}  // namespace bench
