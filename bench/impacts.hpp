// SPDX-License-Identifier: Apache-2.0
// Convex solids that move from one placement to another and turn on the way: when they first touch.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "scene.hpp"

namespace bench {

struct Flight {
  Placement from_a, to_a, from_b, to_b;
};

// All flights are of the same two solids.
struct Flights {
  Solid a, b;
  std::vector<Flight> all;
};

class [[gnu::visibility("default")]] ImpactFinder {
 public:
  virtual ~ImpactFinder() = default;
  // Answers all; how many touch.
  [[nodiscard]] virtual std::size_t answer() = 0;
};

[[gnu::visibility("default")]] std::unique_ptr<ImpactFinder> make_bullet_impacts(const Flights& flights);

}  // namespace bench
