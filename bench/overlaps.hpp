// SPDX-License-Identifier: Apache-2.0
// Whether solids overlap, and no more: single pairs, and groups of pairs of which the first one that does ends a group.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "scene.hpp"

namespace bench {

struct Overlap {
  std::size_t a, b;  // solids
  Placement pose_a, pose_b;
};

struct Overlaps {
  std::vector<Solid> solids;
  std::vector<Overlap> all;
  std::size_t group = 1;  // so many pairs in a row are one question
};

class [[gnu::visibility("default")]] OverlapFinder {
 public:
  virtual ~OverlapFinder() = default;
  // A byte for each group: 1 where a pair of it overlaps.
  virtual void answer(std::vector<char>& out) = 0;
};

[[gnu::visibility("default")]] std::unique_ptr<OverlapFinder> make_fcl_overlaps(const Overlaps& overlaps);

}  // namespace bench
