// SPDX-License-Identifier: Apache-2.0
// Boxes with about four overlaps each that wander through a room.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broadphase.hpp"

namespace bench {

// Sides are 0.5 to 1.5. Each moving box goes by 2 % of its mean side per step. Its direction turns by about seven
// degrees, and turns back at the walls.
class Wandering {
 public:
  Wandering(std::size_t count, double moving_share, std::uint64_t seed) : random_(seed) {
    // Two boxes with mean side 1 overlap when their centres are within 1 of each other along each axis.
    constexpr double overlaps_of_each = 4, volume_of_overlap = 8;
    half_extent_ =
        static_cast<float>(0.5 * std::cbrt(static_cast<double>(count) * volume_of_overlap / overlaps_of_each));
    boxes_.moving = static_cast<std::size_t>(std::lround(moving_share * static_cast<double>(count)));
    for (std::size_t i = 0; i < count; ++i) {
      Box box;
      Way way{random_.direction(), 0};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double side = random_.uniform(0.5, 1.5),
                     centre = static_cast<double>(half_extent_) * random_.uniform(-1, 1);
        way.step += 0.02 * side / 3;
        box.low[axis] = static_cast<float>(centre - side / 2);
        box.high[axis] = static_cast<float>(centre + side / 2);
      }
      boxes_.all.push_back(box);
      if (i < boxes_.moving) {
        ways_.push_back(way);
      }
    }
  }

  void advance() {
    for (std::size_t i = 0; i < boxes_.moving; ++i) {
      Box& box = boxes_.all[i];
      Way& way = ways_[i];
      double length = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        way.direction[axis] += random_.uniform(-0.12, 0.12);
        const float middle = 0.5f * (box.low[axis] + box.high[axis]);
        if (std::abs(middle) > half_extent_) {
          way.direction[axis] = std::copysign(way.direction[axis], static_cast<double>(-middle));
        }
        length += way.direction[axis] * way.direction[axis];
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        way.direction[axis] /= std::sqrt(length);
        const auto shift = static_cast<float>(way.step * way.direction[axis]);
        box.low[axis] += shift;
        box.high[axis] += shift;
      }
    }
  }

  [[nodiscard]] const Boxes& boxes() const { return boxes_; }
  [[nodiscard]] std::span<const Box> moving() const { return std::span(boxes_.all).first(boxes_.moving); }
  [[nodiscard]] float half_extent() const { return half_extent_; }

 private:
  struct Way {
    Point direction;
    double step;
  };
  Random random_;
  float half_extent_ = 0;
  Boxes boxes_;
  std::vector<Way> ways_;
};

}  // namespace bench
