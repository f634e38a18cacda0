// SPDX-License-Identifier: Apache-2.0
// What stands between two geometries and a detection: the filters of the universe in its order, in words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rule_book.hpp"
#include "world.hpp"

namespace cli {

struct GateAnswer {
  std::string_view name;  // such as "layers"
  bool is_open;
  std::string says;  // why, for people
};

class Gates {
 public:
  /// The world must live longer.
  explicit Gates(const World& world) : world_(&world), rules_(world) {}

  /// What each gate says about two geometries, by their numbers in the scene.
  [[nodiscard]] std::vector<GateAnswer> answers(std::size_t a, std::size_t b) const;

  /// The names of all gates, in the order in which they are asked.
  [[nodiscard]] static std::vector<std::string_view> names();

  /// The name of the first gate that is closed; none where they meet. Cheap.
  [[nodiscard]] std::optional<std::string_view> closed(std::size_t a, std::size_t b) const;

 private:
  const World* world_;
  RuleBook rules_;
};

}  // namespace cli
