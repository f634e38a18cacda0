// SPDX-License-Identifier: Apache-2.0
// Flat grounds of every kind, with their tops at height 0 and 4 m to each side.
#pragma once
#include <abut/abut.hpp>

#include <string>
#include <vector>

namespace bench {

struct Ground {
  std::string name;
  std::vector<abut::Shape> shapes;  // each a geometry of one part
  std::vector<abut::Pose> poses;
};

[[nodiscard]] std::vector<Ground> flat_grounds();

}  // namespace bench
