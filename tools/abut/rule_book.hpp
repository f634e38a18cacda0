// SPDX-License-Identifier: Apache-2.0
// The places in a scene of the rules that a universe has.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "world.hpp"

namespace cli {

/// The rule that counts for two geometries; ABUT_RULE_NONE where no rule speaks of them.
struct Verdict {
  abut_rule rule;
  std::string path;  // of the rule in the scene
};

class RuleBook {
 public:
  /// The world must live longer.
  explicit RuleBook(const World& world);

  /// By the numbers of the geometries in the scene.
  [[nodiscard]] Verdict verdict(std::size_t a, std::size_t b) const;

 private:
  using Side = std::tuple<abut_collidable_kind, std::uint32_t, std::uint32_t>;
  using Sides = std::pair<Side, Side>;  // the lesser one first
  static Sides sides_of(const abut_collidable& a, const abut_collidable& b);

  const World* world_;
  std::map<Sides, std::string> paths_;  // a later rule about the same two sides replaces an earlier one
};

}  // namespace cli
