// SPDX-License-Identifier: Apache-2.0
// Which rule of a scene decides about a pair, in the order that abut_rule_set describes.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "scene.hpp"

namespace cli {

class RuleBook {
 public:
  struct Verdict {
    abut_rule rule;
    std::string path;  // of the rule in the scene
  };

  explicit RuleBook(const Scene& scene);

  /// The rule that counts for two geometries of the scene; none where no rule speaks of them.
  [[nodiscard]] std::optional<Verdict> verdict(const Scene& scene, std::size_t a, std::size_t b) const;

 private:
  using Side = std::pair<abut_collidable_kind, std::size_t>;

  static std::array<Side, 4> sides_of(const Scene& scene, std::size_t geometry);

  // The lesser side first; a later rule about the same two sides replaces an earlier one.
  std::map<std::pair<Side, Side>, Verdict> verdicts_;
};

}  // namespace cli
